// passed_over.h — words and codes of a text that have no effect here: each is reported once.
#pragma once

#include <set>
#include <string_view>
#include <vector>

#include "nc/lexer.h"
#include "nc/line_faults.h"
#include "nc/match.h"

namespace kadr::nc {

class PassedOver {
  public:
    /// References outlive it. What has no effect is reported by `faults`.
    PassedOver(const DialectTables& tables, LineFaults& faults)
        : tables_(tables), faults_(faults) {}

    /// Words of the line that the lexer has passed over.
    void announce(const LexedLine& words, std::string_view line);
    /// A form that the words have used, if the control does nothing at it.
    void announce(FormId id, const LexedLine& words, std::string_view line);
    /// A word that no form takes, and that means something to another one of the block on which
    /// nothing depends here, is left out of the words: P of `M59 P10`. False: it is no such word.
    bool leave_out(const MatchFault& fault, LexedLine& words, std::string_view line);

  private:
    const PassedWord* beside(const MatchFault& fault, const LexedLine& words) const;

    const DialectTables& tables_;
    LineFaults& faults_;
    std::vector<FormId> reported_forms_;
    std::set<const PassedWord*> reported_words_;
};

}  // namespace kadr::nc
