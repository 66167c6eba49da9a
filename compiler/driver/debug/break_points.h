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

namespace kadr::driver {

/// A line of a file; empty `file`: there is none.
struct FileLine {
    std::string_view file;
    std::uint64_t first = 0;
    std::uint64_t last = 0;  // of what stands there
};

/// A line of ISO-7bit text or a statement that is about to be executed, with what a person may
/// call it.
struct StopArrival {
    std::uint64_t number = 0;  // N; used if has_number
    bool has_number = false;
    std::string_view label;
    std::string_view program;  // that is entered with this line; empty: none
    std::string program_head;  // as its head writes it: `O9010`
    FileLine text;             // of the ISO-7bit text
    FileLine statement;        // of the Kadr program
    std::string_view started;  // the file that was started
    std::string_view entered;  // function of the Kadr program that begins with it; empty: none
};

class BreakPoint {
  public:
    /// Nothing: no point can be meant by this.
    static std::optional<BreakPoint> parse(std::string_view text);

    /// A line of a file; empty `file`: of the one that was started.
    static BreakPoint at_line(std::string_view file, std::uint64_t line);

    enum class Kind : std::uint8_t { Number, Line, Name };

    const std::string& text() const { return text_; }
    Kind kind() const { return kind_; }
    bool is_at(const StopArrival& arrival) const;
    /// Of a Kind::Line: whether it stands in this file at all.
    bool is_in(std::string_view file, std::string_view started) const;

  private:
    bool is_line(const FileLine& line, std::string_view started) const;
    bool is_program(const StopArrival& arrival) const;

    std::string text_;  // as it was given
    Kind kind_ = Kind::Name;
    std::uint64_t number_ = 0;  // of the block or the line
    std::string name_;          // of the file or what it is called; in upper case
    bool has_letter_ = false;   // `N120`: a block number and nothing else
};

}  // namespace kadr::driver
