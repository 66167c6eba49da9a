// break_points.h — `--break` and `--until`: points of a program that a person names.
//
//   N120, 120       a block number
//   :34             a line of the program that was started
//   rows.kadr:34    a line of a file: source, ISO-7bit text or subprogram
//   AGAIN, row      a label, a subprogram, a function of a Kadr program
//   O9010, 9010     a subprogram that has a number
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "expand/expander.h"
#include "macro/line_watch.h"

namespace kadr::driver {

/// A line of a file; empty `file`: there is none.
struct FileLine {
    std::string_view file;
    std::uint64_t first = 0;
    std::uint64_t last = 0;  // of what stands there
};

/// A line that is about to be executed, with what a person may call it.
struct StopArrival {
    std::uint64_t number = 0;  // N; used if has_number
    bool has_number = false;
    std::string_view label;
    std::string_view program;  // that is entered with this line; empty: none
    std::string program_head;  // as its head writes it: `O9010`
    FileLine text;             // of the ISO-7bit text
    FileLine statement;        // of the Kadr program
    std::string_view started;  // the file that was started
    struct Entered {
        std::string_view function;
        FileLine call;
    };
    std::vector<Entered> entered;  // calls of the Kadr program that begin with this line
};

class BreakPoint {
  public:
    /// Nothing: no point can be meant by this.
    static std::optional<BreakPoint> parse(std::string_view text);

    const std::string& text() const { return text_; }
    bool is_at(const StopArrival& arrival) const;

  private:
    enum class Kind : std::uint8_t { Number, Line, Name };
    bool is_line(const FileLine& line, std::string_view started) const;
    bool is_program(const StopArrival& arrival) const;

    std::string text_;  // as it was given
    Kind kind_ = Kind::Name;
    std::uint64_t number_ = 0;  // of the block or the line
    std::string name_;          // of the file or what it is called; in upper case
    bool has_letter_ = false;   // `N120`: a block number and nothing else
};

/// Tells which calls of a Kadr program begin with a block.
class CallWatch {
  public:
    /// How many of the block's calls, from the outermost on, are those of the block before.
    std::size_t known_calls(const expand::BlockOrigin& now);

  private:
    expand::BlockOrigin before_;
};

}  // namespace kadr::driver
