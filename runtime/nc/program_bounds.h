// program_bounds.h — where a program begins and ends in a text: heads as `O0001` and
// `%_N_PART_MPF`, end marks, and lines that are neither.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "nc/lexer.h"

namespace kadr::nc {

/// The text that lines stand in, and how far a program in it is read.
struct TextBounds {
    std::string name;          // shown in messages
    std::string program;       // as the head names it
    bool has_content = false;  // blocks or statements were read
    bool has_ended = false;    // the end mark, or the head of another program
};

/// A location in a line of a file.
TextLocation location_in_line(const std::string& file, std::string_view line, std::uint64_t number,
                              const Span& span);

class ProgramBounds {
  public:
    /// What a line is before its words are looked at: a head at a wrong location is misplaced.
    enum class LineKind : std::uint8_t { Nothing, Words, Misplaced, WrongNumber };

    /// tables  outlive it
    /// name    of the text, until another one is entered
    ProgramBounds(const DialectTables& tables, std::string name)
        : tables_(tables), own_text_{std::move(name), {}} {}
    ProgramBounds(const ProgramBounds&) = delete;  // its text may be its own
    ProgramBounds& operator=(const ProgramBounds&) = delete;

    /// The lines that follow stand in this text, which outlives its use.
    void enter(TextBounds& text) { text_ = &text; }
    const TextBounds& text() const { return *text_; }
    /// The end mark of the program was read.
    bool has_ended() const { return text_->has_ended; }
    /// A block was read, or something else was executed; a head of a program behind it begins
    /// another one.
    void note_content() { text_->has_content = true; }

    /// Notes what a head or an end mark holds.
    LineKind kind_of(std::string_view line);
    /// The line with blanks in place of a program's head that words stand behind: `O0001 G20`. Any
    /// other line as it is. The text lives until the next head.
    std::string_view without_head(std::string_view line, std::uint64_t number);
    /// The line as it stands in the text: what without_head gives has blanks for the head.
    std::string_view shown(std::string_view line, std::uint64_t number) const {
        return number == head_number_ && line == head_line_ ? head_text_ : line;
    }
    /// A location in a line of this text.
    TextLocation location(std::string_view line, std::uint64_t number, const Span& span) const {
        return location_in_line(text_->name, shown(line, number), number, span);
    }

  private:
    void note_program(std::string_view line);
    bool has_wrong_number(std::string_view line) const;

    const DialectTables& tables_;
    TextBounds own_text_;
    TextBounds* text_ = &own_text_;
    std::string head_line_;                          // what without_head gives …
    std::string head_text_;                          // … of this line …
    std::uint64_t head_number_ = ~std::uint64_t{0};  // … and its number
};

}  // namespace kadr::nc
