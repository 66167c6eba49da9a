// target_index.h — where the targets of a text stand, for many questions: what ProgramMap finds by
// looking through the lines once more for each.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "macro/program_map.h"

namespace kadr::macro {

class TargetIndex {
  public:
    /// A line with a target.
    struct Hit {
        LinePosition line;
        std::uint32_t declaration = 0;
    };

    /// A line that begins a program, or ends one. Lines come in the order of the text.
    void note_head(const LinePosition& line) { bounds_.push_back({line, false}); }
    void note_end(const LinePosition& line) { bounds_.push_back({line, true}); }
    /// A target, its label as the language compares names. In the order of the text.
    void add(const LineTarget& target, const Hit& hit) { hits_[target].push_back(hit); }

    /// As ProgramMap::find has it.
    ///
    /// begin  of the program
    const Hit* find(const LineTarget& target, Direction direction, const ProgramLine& from,
                    const LinePosition& begin) const;

  private:
    struct Bound {
        LinePosition line;
        bool is_end = false;
    };
    std::uint64_t end_of_scan(const LinePosition& from, const LinePosition& begin) const;

    std::vector<Bound> bounds_;
    std::map<LineTarget, std::vector<Hit>> hits_;
};

}  // namespace kadr::macro
