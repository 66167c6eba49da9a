// call_compiler.h — calls of programs in a line of the control's own language: codes with the words
// that belong to them, names with arguments in brackets, heads of procedures.
#pragma once

#include <string>

#include "nc/expression_compiler.h"

namespace kadr::nc {

class CallCompiler : protected ExpressionCompiler {
  protected:
    using ExpressionCompiler::ExpressionCompiler;

    /// A code that calls, or a word that belongs to the one before.
    Try take_code_call(const LineContext& context);
    Try take_word_of_call();
    /// Whether a call is open that takes what follows in its block as arguments.
    bool is_in_macro_call() const;
    /// Arguments and words of that call up to a comment or the end of the block; comments stand
    /// between words, so there may be more behind one.
    Try take_words_of_macro();
    /// The whole line as the arguments of a modal call, up to a comment.
    Try take_line_as_arguments();
    /// `POCK(10,20)`, `POCK P3`, `P=3 POCK`, `L123`; only where it is all of its block.
    Try take_named_call();
    /// A program and its arguments behind a keyword.
    Done take_call_hole(ControlStatement& out);
    /// Whether a program that the dialect does not know as a word of its own is named there.
    bool begins_call(std::size_t at) const;

    /// One type of a list of parameters; defined by who reads declarations.
    virtual Done take_parameter(ProcedureParameter& out, bool is_named) = 0;
    Done take_procedure(ControlStatement& out);
    ~CallCompiler() = default;

  private:
    const CallForm* find_code(std::size_t& at, const LineContext& context) const;
    ControlStatement& add_call(const CallForm& form, Statement kind, std::size_t begin);
    Done take_program_in_brackets(Call& call);
    Done take_letter_argument(Call& call, bool is_block);
    Done take_value_of_word(CallValue& out);
    Try take_repeats(const CallForm& form, CallValue& out);
    Done take_call_list(Call& call);
    Done take_listed(CallArgument& out);
    std::string program_name(std::size_t& at) const;
    const CallForm* form_of_name(std::string_view name) const;
    bool is_known_name(std::string_view name) const;
    bool comes_to_end();

    std::int32_t open_call_ = -1;  // whose words may follow
    std::vector<char> series_;     // letters of the series that were given in this round
    int rounds_ = 0;               // of the series
};

}  // namespace kadr::nc
