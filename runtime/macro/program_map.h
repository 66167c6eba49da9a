// program_map.h — positions in a program: where targets stand and where structures end.
//
// Found by looking through the text as the control does, and remembered.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <unordered_map>

#include "nc/control_line.h"
#include "nc/line_source.h"

namespace kadr::macro {

/// The beginning of a line.
struct LinePosition {
    std::uint64_t offset = 0;
    std::uint64_t line = 1;
    friend bool operator==(const LinePosition&, const LinePosition&) = default;
};

/// Where a line is and where the next one begins.
struct ProgramLine {
    LinePosition line;
    LinePosition next;
};

/// The further parts of a loop or a condition, from its head.
struct StructureParts {
    std::optional<ProgramLine> otherwise;  // of a condition
    ProgramLine end;
};

enum class Direction : std::uint8_t { Both, Forward, Backward };

/// What is looked for: a label, or a block number if the label is empty.
struct LineTarget {
    std::string label;
    std::int64_t number = -1;
    // clang-tidy takes the 0 that the compiler compares with for a null pointer of ours.
    friend auto operator<=>(const LineTarget&,
                            const LineTarget&) = default;  // NOLINT(modernize-use-nullptr)
};

class ProgramMap {
  public:
    /// begin  of the program in its text
    ProgramMap(const nc::DialectTables& tables, nc::LineSource& source,
               const LinePosition& begin = {})
        : tables_(tables), source_(source), begin_(begin) {}

    enum class Fault : std::uint8_t { None, Missing, TextGone, LoopNumber };

    /// The nearest line with the target, forward from `from` to the end of the program, then from
    /// its head; backward the nearest one before it.
    Fault find(const LineTarget& target, Direction direction, const ProgramLine& from,
               ProgramLine& out);
    /// The first two lines of the program that this target stands in, if it stands there twice.
    /// Only the first megabyte of the program is looked at, once.
    struct Twice {
        std::uint64_t first = 0;
        std::uint64_t second = 0;
    };
    std::optional<Twice> twice(const LineTarget& target);
    /// The line at which the search for an end could not go on: a head with the number of a loop
    /// that is open, or an end or an ELSE of another structure.
    struct Crossing {
        std::uint64_t line = 0;  // 0: none, the program has ended
        std::string text;
        bool is_second_else = false;
        std::uint64_t inside =
            0;  // head of the structure that is open there; 0: the one looked for
    };
    /// The end of the structure whose head stands at `head`.
    ///
    /// crossing  set where a line of another structure is in the way
    Fault find_end(const ProgramLine& head, const nc::LineFront& front, const StructureParts*& out,
                   Crossing& crossing);
    /// The next mark of this name behind `from`.
    Fault find_label_between(std::string_view label, const LinePosition& from,
                             const LinePosition& to, ProgramLine& out);

    /// Whether nothing but comments and numbers of blocks stands between two positions.
    bool finds_nothing_between(const LinePosition& from, const LinePosition& to);

  private:
    /// Calls `look` with each line from `from` on and its position, until it returns false.
    template <typename Look>
    Fault scan(const LinePosition& from, Look look);
    bool is_target(const nc::LineFront& front, const LineTarget& target) const;

    const nc::DialectTables& tables_;
    nc::LineSource& source_;
    LinePosition begin_;
    std::map<std::tuple<std::uint64_t, Direction, LineTarget>, ProgramLine> targets_;
    std::unordered_map<std::uint64_t, StructureParts> structures_;
    std::optional<std::map<LineTarget, Twice>> twice_;  // nothing: not looked for yet
};

}  // namespace kadr::macro
