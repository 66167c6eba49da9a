// block_values.h — the numbers of words, put where they belong in a block, as the control takes
// them.
#pragma once

#include <string_view>

#include "base/done.h"
#include "nc/lexer.h"
#include "nc/line_faults.h"
#include "nc/match.h"
#include "nc/point_watch.h"
#include "nc/reading_modes.h"

namespace kadr::nc {

class BlockValues {
  public:
    /// References outlive it.
    ///
    /// points  is given positions
    BlockValues(const DialectTables& tables, const ReadingModes& modes, PointWatch& points,
                LineFaults& faults)
        : tables_(tables), modes_(modes), points_(points), faults_(faults) {}

    /// Puts the value of one word in. Failed: the control does not take a number that is written
    /// so, which was reported.
    ///
    /// words  of `line`
    /// block  with the functions that the words program; its changes of units act in it already
    Done put(const Claim& claim, const LexedLine& words, std::string_view line, Block& block);

  private:
    void put_argument(const Claim& claim, const LexedLine& words, Block& block) const;
    Done put_number(const Claim& claim, const LexedLine& words, std::string_view line,
                    Block& block);
    Done put_whole(const Claim& claim, const LexedLine& words, std::string_view line, Block& block);
    Done put_both(const Claim& claim, const LexedLine& words, std::string_view line, Block& block);
    void set_slot(const Claim& claim, double meaning, Block& block) const;
    bool is_pitch(const Claim& claim, const Block& block) const;
    bool is_position_of_function(const Claim& claim, const LexedLine& words) const;
    Done fail(const DiagnosticRow& row, const Claim& claim, const LexedLine& words,
              std::string_view line);

    const DialectTables& tables_;
    const ReadingModes& modes_;
    PointWatch& points_;
    LineFaults& faults_;
};

}  // namespace kadr::nc
