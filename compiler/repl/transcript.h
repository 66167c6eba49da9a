// transcript.h — what was typed at the prompt, as one program.
//
// The prompt keeps no evaluator between two inputs: it keeps the program that they amount to and
// evaluates all of it again. So undoing is dropping the last input, reloading is evaluating once
// more, and what is saved is what was seen.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "driver/session.h"

namespace kadr::repl {

struct Input {
    enum class Kind : std::uint8_t {
        Header,  // language, dialect, units
        Import,
        Declaration,  // what stands beside the program: functions, cycles, structs, constants
        Statement,    // what the program does
        Call,         // of a function: its value is shown, or what it does is kept
        Value,        // an expression to be shown; it is not kept
        Wrong,        // neither; its messages come with the evaluation
    };
    Kind kind = Kind::Wrong;
    std::string text;  // as typed; a forgotten `;` is put behind
};

/// Whether more lines belong to the text: it has a bracket or a comment that is not closed yet, or
/// it ends in a head without its body: `if (…)`, `else`, `do`, `cycle c()`. `headers` are the
/// `language` and `dialect` that hold.
bool is_incomplete(driver::Session& session, std::string_view headers, const std::string& text);

/// What a complete input is, judged by parsing it. `headers` are the `language` and `dialect` that
/// hold.
Input classify(driver::Session& session, std::string_view headers, std::string text);

/// The word for `program` in the keyword language of the headers.
std::string program_word(driver::Session& session, std::string_view headers);

class Transcript {
  public:
    void add(Input input) { inputs_.push_back(std::move(input)); }
    /// Takes the last input back and gives it; there is one.
    Input undo();
    void clear() { inputs_.clear(); }
    const std::vector<Input>& inputs() const { return inputs_; }
    /// Whether the program does anything yet.
    bool has_statements() const;
    /// The headers alone: of each kind the one that was given last.
    std::string headers() const;

    /// The program: headers, imports, declarations, then `program prompt() { … }` with the word for
    /// `program`; one input a paragraph.
    std::string program(std::string_view word) const;
    /// The byte of that program where its last input begins, if that is a statement.
    std::uint32_t last_statement(std::string_view program) const;

  private:
    std::vector<Input> inputs_;
};

}  // namespace kadr::repl
