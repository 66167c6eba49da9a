// expression_compiler.h — expressions of the control's own language → flat code of a ControlLine.
//
// A cursor in one line, what expressions are made of, and variables as targets of assignments.
// Statements are built upon it in control_parser.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/diagnostics/control.h"
#include "base/done.h"
#include "nc/control_line.h"
#include "nc/control_words.h"

namespace kadr::nc {

/// What became of something that may stand at the cursor, or not.
enum class Try : std::uint8_t {
    Absent,  // something else stands there
    Taken,
    Failed,  // it begins there, and the fault tells what is wrong with it
};

class ExpressionCompiler {
  protected:
    ExpressionCompiler(const DialectTables& tables, const SymbolTable& symbols,
                       std::string_view line, ControlLine& out)
        : tables_(tables),
          language_(tables.language),
          rules_(tables.language.rules),
          symbols_(symbols),
          words_(tables, line),
          line_(line),
          out_(out) {}

    // ------------------------------------------------------------ the cursor

    void begin(std::size_t at);
    std::optional<LineFault> finish(std::size_t& at, bool was_taken);
    char peek() const;
    void skip();
    Span span_from(std::size_t begin) const;
    void set_fault(const DiagnosticRow& row, Span span);
    void set_fault_here(const DiagnosticRow& row);
    Done fail(const DiagnosticRow& row, Span span);
    Done fail_here(const DiagnosticRow& row);
    static Try tried(Done done) { return done ? Try::Taken : Try::Failed; }
    Try not_taken() const { return fault_ ? Try::Failed : Try::Absent; }

    // ------------------------------------------------------------ code

    void emit(const ControlInstruction& instruction, std::size_t begin);
    void emit_number(double number, ValueType type, std::size_t begin);
    void emit_operation(Operation operation, int count, std::size_t begin);
    /// Takes what `parse` takes as an expression of its own.
    template <typename Parse>
    Done take_as_expression(Expression& out, Parse parse) {
        skip();
        const std::size_t begin = at_;
        out.first = static_cast<std::uint32_t>(out_.code.size());
        bool is_logical = false;
        if (!parse(is_logical)) return kFailed;
        out.count = static_cast<std::uint32_t>(out_.code.size()) - out.first;
        out.span = span_from(begin);
        out.is_logical = is_logical;
        return kDone;
    }
    Done take_expression(Expression& out);
    Done take_operand(Expression& out);
    /// A value that is no comparison where the control does not store such.
    Done take_stored(Expression& out);

    // ------------------------------------------------------------ operators
    bool is_block_end(std::size_t at) const { return words_.is_block_end(at); }
    const OperatorForm* find_operator(std::size_t at, bool is_prefix) const;
    /// Operators of this level and those that bind stronger, from left to right.
    Done take_level(int level, bool& is_logical);
    Done take_primary(bool& is_logical);
    Done take_sign(char sign);
    Done take_open(char sign);
    Done take_close(char sign);
    Done take_bracket(bool& is_logical);

    // ------------------------------------------------------------ constants
    Done take_number();
    /// `1.5EX-3`
    Try take_exponent(double& value);
    /// `'HFF'`, `'B1011'`
    Done take_coded_number();
    Done take_text();

    // ------------------------------------------------------------ names
    Done take_name(const LetterRun& word);
    /// The axis that has this name; nothing: none, or values are no axes here.
    std::optional<Axis> axis_named(std::string_view name) const;
    void emit_axis(Axis axis, std::size_t begin);
    Done fail_unknown(const LetterRun& word);
    /// The function whose first form was found; which form it is the arguments decide.
    Done take_function(const LetterRun& word, const FunctionForm& found);
    Done take_variable_itself();
    bool has_divided_form(const FunctionForm& found) const;

    // ------------------------------------------------------------ variables
    Done take_variable();
    /// The code of the indices goes out at once; the load is left to the caller.
    Done take_reference(Reference& out);
    Done require_one_bracket(std::size_t begin);
    /// `#1`, `#[expression]`, `R5`
    Try take_family(const LetterRun& word, Reference& out);
    void add_datum(std::int64_t datum, std::size_t begin, ControlInstruction& load);
    Done take_numbered(const VariableRange& range, int indices, std::size_t begin,
                       ControlInstruction& load);
    Done index_in_family(const VariableForm& form, std::size_t family, std::int64_t number,
                         std::size_t begin, ControlInstruction& load);
    Done fail_unsupported(const VariableRange& range, std::size_t begin);
    /// The word, or all of a name with signs that is declared letter by letter: `#<_feed>` beside
    /// the family `#<_{name}>`.
    LetterRun whole_name(LetterRun word) const;
    /// `$P_EP[X]`, `$PI`, `TRUE`, `#_ABSIO[1]`
    Try take_named(const LetterRun& word, Reference& out);
    Try take_open_name(const LetterRun& word, Reference& out);
    Done take_open_bracket();
    Done take_any_index();
    bool take_machine_axis();
    /// `#<depth>`
    Try take_own_name(Reference& out);
    Done take_indices(const VariableForm& form, ControlInstruction& load);
    Done take_index(const IndexHole& hole);
    Done take_axis_index();
    /// `,X,TR` behind the other indices of a frame, `is_first` without the comma in front: the load
    /// becomes that of the component.
    Done take_frame_part(bool is_first, ControlInstruction& load);
    Try take_symbol(const LetterRun& word, Reference& out);
    bool begins_reference(std::size_t at) const;

    const DialectTables& tables_;
    const Language& language_;
    const LanguageRules& rules_;
    const SymbolTable& symbols_;
    ControlWords words_;
    std::string_view line_;
    ControlLine& out_;
    std::size_t at_ = 0;
    int depth_ = 0;
    NameTable* names_ = nullptr;  // of the program's own variables
    const MachineAxisNames* axis_names_ = nullptr;
    bool is_machine_data_ = false;
    bool takes_whole_arrays_ = false;  // a name of an array without indices is one
    bool takes_rows_ = false;          // … of two indices with the first alone is a row of it
    std::optional<LineFault> fault_;
};

}  // namespace kadr::nc
