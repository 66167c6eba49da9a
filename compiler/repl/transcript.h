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

/// Whether the text has a bracket or a comment that is not closed yet.
bool has_open_end(std::string_view text);

/// Whether more lines belong to the text: it has a bracket or a comment that is not closed yet, or
/// it ends in a head without its body: `if (…)`, `else`, `do`, `cycle c()`. `headers` are the
/// `language` and `dialect` that hold.
bool is_incomplete(driver::Session& session, std::string_view headers, const std::string& text);

/// What a complete input is, judged by parsing it. `headers` are the `language` and `dialect` that
/// hold.
Input classify(driver::Session& session, std::string_view headers, std::string text);

/// The word for `program` in the keyword language of the headers.
std::string program_word(driver::Session& session, std::string_view headers);

/// Whether a text has no mistake of syntax, `;` put behind it or not, or waits only for the body of
/// its last head.
bool can_be_read(driver::Session& session, std::string_view headers, const std::string& text);

/// How many mistakes of syntax a text has, beside a program or in one, where it has fewer.
std::size_t mistakes(driver::Session& session, std::string_view headers, const std::string& text);

/// Whether a text of a program needs nothing but `;` behind it to be a statement.
bool is_whole_statement(driver::Session& session, std::string_view headers,
                        const std::string& text);

/// The word for `else` in the keyword language of the headers.
std::string else_word(driver::Session& session, std::string_view headers);

/// Past the text or comment that begins at `at`, which may not be closed; `at` itself if none does.
std::size_t past_quoted(std::string_view text, std::size_t at);

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
