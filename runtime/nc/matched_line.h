// matched_line.h — what was found of the words of a line when it ran first, for the next time.
#pragma once

#include <vector>

#include "nc/control_line.h"
#include "nc/match.h"

namespace kadr::nc {

/// Holds as long as the modal functions are the same, and if what the block does depends on no
/// computed value.
class MatchedLine {
  public:
    /// Whether the words mean under these functions what they meant then.
    bool holds_under(const ModalFunctions& modal) const { return is_valid_ && before_ == modal; }
    /// Keeps what was found, unless a computed value decides it.
    ///
    /// block  filled but for its values
    void keep(const DialectTables& tables, const ControlLine& compiled, const ModalFunctions& modal,
              const Block& block, const Match& match);
    /// The block as the words were understood before; the values are to be put in.
    void recall(const LexedLine& words, Block& block, Match& match) const;

  private:
    bool is_valid_ = false;
    ModalFunctions before_{};
    std::vector<Claim> claims_;
    std::vector<FormId> forms_;
    Block shape_;  // functions and modes, without values
};

}  // namespace kadr::nc
