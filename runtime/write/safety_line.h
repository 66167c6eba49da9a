// safety_line.h — the lines that bring a control to a known state: in front of a program, and
// behind a tool change, where an operator starts again.
//
// They are templates of the dialect. A code in them gives way to the one that the program wants in
// its place: what it programs before it does anything else (`G18 G95`) stands in the line at once.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "write/lines.h"
#include "write/text_state.h"

namespace kadr::write {

class SafetyLine {
  public:
    /// References outlive it.
    SafetyLine(TextState& state, Lines& lines) : state_(state), lines_(lines) {}

    /// The next lines are those of a program.
    void begin() { forget(); }
    /// Whether the block does nothing but choose codes that the line can have; it needs no other
    /// line then.
    bool take(const Block& block);
    /// Whether a block was taken since the last line.
    bool holds_codes() const { return holds_codes_; }
    /// In front of a program.
    void write_start(const std::vector<std::string>& templates, std::string& out);
    /// Behind a tool change: the codes that act, whatever the template has. A shift that acts is
    /// written once more.
    void write_section(const std::vector<std::string>& templates, std::string& out);

  private:
    /// What a line has to say; None: what its template has of the group.
    struct Wanted {
        ModalFunctions functions{};
        NumberInForce offset;
        bool is_without_feed_mode = false;
    };

    void forget() {
        taken_ = {};
        holds_codes_ = false;
    }
    bool needs_no_word(Function function) const;
    bool can_take(const Invocation& invocation) const;
    void write(const std::vector<std::string>& templates, const Wanted& wanted, std::string& out);
    Wanted standing(const std::vector<std::string>& templates) const;
    bool has_group(const std::vector<std::string>& templates, Group group) const;
    bool would_end_cutting_speed() const;
    std::string line_of(std::string_view text, Wanted& wanted) const;
    std::string word_for(std::string_view word, Wanted& wanted) const;
    std::string rest_of(const Wanted& wanted) const;
    const Form* form_of(std::string_view word) const;
    const Form* name_form(std::string_view word) const;
    const Form* offset_form(double number) const;
    void say_words(std::string_view line);

    TextState& state_;
    Lines& lines_;
    Wanted taken_;  // by blocks that have no line of their own
    bool holds_codes_ = false;
};

}  // namespace kadr::write
