// line_watch.h — who looks on while a program runs: traces and break points.
#pragma once

#include <cstdint>
#include <string_view>

namespace kadr::macro {

/// A line that the control is about to execute.
struct WatchedLine {
    std::string_view text;
    std::uint64_t line = 0;    // of the text, from 1
    std::int64_t number = -1;  // N; -1 none
    std::string_view label;    // as it stands in the line; empty: none
    std::string_view file;     // of the text; empty: of the one that was started
    std::string_view program;  // called subprogram that the line belongs to; empty: none
    std::size_t level = 0;     // how many calls led there
};

/// A way that a line leads which names its target: a jump, a section that is repeated, a call.
struct WayTaken {
    enum class Kind : std::uint8_t { Jump, Repeat, Call };
    Kind kind = Kind::Jump;
    std::uint64_t line = 0;     // that names the target
    std::string_view file;      // … of this text; empty: of the one that was started
    std::uint64_t to_line = 0;  // of the target; of a program its first one
    std::string_view to_file;   // likewise
};

class LineWatch {
  public:
    virtual ~LineWatch() = default;
    /// A line is next. If the interpreter reads block by block (InterpreterOptions::in_step), all
    /// lines before it are executed. False: the program ends in front of it.
    virtual bool comes_to(const WatchedLine& line) = 0;
    /// The line that is executed leads elsewhere; a modal call where it becomes modal.
    virtual void takes(const WayTaken& way) { static_cast<void>(way); }
    /// Asked where the text ends: whether the program has ended in front of more, because the one
    /// who looks on wanted it while that was being made.
    virtual bool has_ended() const { return false; }
};

}  // namespace kadr::macro
