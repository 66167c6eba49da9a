// control_line.h — one line of a program with the control's own language, compiled.
//
// Expressions are flat postfix code; names have become slots and indices. Nothing here is looked
// up again when the line runs: interp evaluates the code and fills a block, or acts on the
// statements.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "nc/language.h"
#include "nc/lexer.h"

namespace kadr::nc {

/// One step of an expression.
struct ControlInstruction {
    enum class Kind : std::uint8_t {
        Number,   // `number`, of type `type`
        Text,     // ControlLine::texts[index]
        Vacant,   // no value
        Global,   // the variable in slot `index`
        Local,    // the same of the level
        Family,   // the variable of family `index` whose number is on the stack
        System,   // the system variable `index`, its indices on the stack
        Input,    // … of open form `index`: the number of the name and its indices on the stack
        Element,  // the declared variable `index`; `count` indices on the stack
        // Component `part()` of such a frame; the axis is one more on the stack.
        SystemPart,
        ElementPart,
        Operate,  // `operation` on the `count` values on top
    };
    Kind kind = Kind::Number;
    Operation operation = Operation::Add;
    std::uint8_t count = 0;
    ValueType type = ValueType::Real;
    std::uint32_t index = 0;
    double number = 0;

    FramePart part() const { return static_cast<FramePart>(static_cast<int>(number)); }
};

/// A piece of ControlLine::code.
struct Expression {
    std::uint32_t first = 0;
    std::uint32_t count = 0;  // 0: not given
    Span span;
    bool is_logical = false;    // the result of a comparison
    bool keeps_vacant = false;  // a value behind a sign, `X-#1`: the sign of vacant is vacant
    bool is_given() const { return count != 0; }
};

/// A variable that gets a value: its load, and what puts its indices on the stack.
struct Reference {
    ControlInstruction load;
    Expression indices;
    Span span;
    bool is_given() const { return span.end != 0; }
};

struct JumpTarget {
    enum class Kind : std::uint8_t { None, Number, Label, Computed };
    Kind kind = Kind::None;
    std::int64_t number = 0;
    std::string label;
    Expression value;
    Span span;
};

/// `NAME[3,4]=SET(1,2)` in a declaration.
struct Declaration {
    std::string name;
    Span span;
    std::array<Expression, 3> sizes;
    std::uint8_t dimensions = 0;
    std::vector<Expression> values;  // one not given: a gap
    bool fills = false;              // the value goes into all elements
};

/// A parameter of a procedure of the control.
struct ProcedureParameter {
    Declaration declaration;
    ValueType type = ValueType::Real;
    Expression type_size;       // characters of a text
    bool is_reference = false;  // the caller's variable itself
};

/// A value in a call: a number as it stands, or one that is worked out.
struct CallValue {
    bool is_given = false;
    bool is_plain = false;  // `decimal` holds; else `value`
    Decimal decimal;
    Expression value;
    Span span;
};

struct CallArgument : CallValue {
    std::uint32_t slot = 0;       // by letter: the variable that it sets
    AddressId like = kNoAddress;  // by letter: the address whose numbers it has
    Reference variable;           // in a list: if it is nothing but a variable
    bool is_array = false;        // … of which all elements are meant
};

/// A call of a program, or the end of one.
struct Call {
    std::int32_t form = -1;  // index into CallLanguage::calls; -1: a statement without a code
    std::string name;        // if it is written in the line
    std::string kind;        // … and tells of which kind the program is
    Span span;               // of the code or the name
    CallValue program;       // by a number
    CallValue repeats;
    CallValue start;
    CallValue target;
    CallValue code;  // the number behind the letter of the code
    std::vector<CallArgument> arguments;
    bool has_list = false;  // arguments in brackets, by their positions
};

/// A piece of a line that is printed: text, or a value with its digits.
struct PrintPiece {
    std::string text;
    Expression value;  // not given: the text
    int whole = 0;     // digits before the point
    int decimals = 0;
};

struct ControlStatement {
    Statement kind = Statement::None;
    std::uint32_t call = 0;    // of a call: index into ControlLine::calls
    std::uint32_t closes = 0;  // EndLoop: which statements it ends
    Span span;                 // of the keyword
    Reference variable;
    Reference table;    // {table}: a whole array, or a variable; {row}: a row of one
    Expression value;   // {value} {condition} {first} {number}
    Expression second;  // {last} {text}
    Expression count;
    JumpTarget target;
    JumpTarget from;
    JumpTarget to;
    int loop = 0;
    ValueType type = ValueType::Real;
    Expression type_size;  // characters of a text
    Span scope;            // of the word that tells for whom it is declared, if one does
    std::vector<Declaration> declarations;
    std::string name;                            // of a procedure
    std::vector<ProcedureParameter> parameters;  // … and what it takes
    bool saves = false;                          // … and leaves the modal state as it was
    std::vector<Expression> list;                // values for an array from the variable on
    bool fills = false;
    std::vector<PrintPiece> print;
    /// What an IfDo does; of a Case: the jump of each value of `list`, and the default.
    std::vector<ControlStatement> inner;
};

/// A number in a word that is computed, or an argument of a call.
struct ComputedValue {
    std::uint16_t word = 0;
    std::int32_t argument = -1;  // index into LexedLine::arguments; -1: the word itself
    Expression value;
};

/// A word whose axis is worked out: `AX[AXA]=10`.
struct ComputedAxis {
    std::uint16_t word = 0;
    bool is_alone = false;  // the axis moves by itself: `POS[X]=10`
    Expression axis;
};

/// A code by its index in the list of its group: `G[6]=2`.
struct ComputedCode {
    std::uint16_t word = 0;
    Expression group;
    Expression number;
};

struct ControlLine {
    LexedLine words;
    std::vector<ComputedValue> computed;
    std::vector<ComputedAxis> axes;
    std::vector<ComputedCode> codes;
    std::vector<ControlStatement> statements;
    std::vector<Call> calls;
    std::vector<ControlInstruction> code;
    std::vector<Span> spans;  // of the instructions
    std::vector<std::string> texts;

    void clear();
};

/// A variable that the program has declared.
struct ControlSymbol {
    std::string name;
    ValueType type = ValueType::Real;
    std::uint32_t slot = 0;  // of its first element in the store of its level
    std::uint8_t dimensions = 0;
    std::array<std::uint32_t, 3> sizes{1, 1, 1};
    std::uint32_t text_size = 0;
    bool is_reference = false;  // stands for a variable of the caller
    bool is_shared = false;     // of the definitions for all programs
    /// Whether it is one value in the store of the level, that code names by its slot.
    bool is_plain() const { return dimensions == 0 && !is_kept_apart() && !is_reference; }
    /// Whether it is kept where values are of any size.
    bool is_kept_apart() const { return type == ValueType::Text || type == ValueType::Frame; }
    std::uint32_t count() const { return sizes[0] * sizes[1] * sizes[2]; }
};

/// The variables declared so far, by name (in upper case where case does not count).
class SymbolTable {
  public:
    const ControlSymbol* find(std::string_view name) const {
        const auto found = by_name_.find(name);
        return found == by_name_.end() ? nullptr : &symbols_[found->second];
    }
    /// Whether the program itself, and nobody for all, has declared the name.
    bool has_own(std::string_view name) const {
        const ControlSymbol* const found = find(name);
        return found != nullptr && !found->is_shared;
    }
    std::uint32_t index_of(const ControlSymbol& symbol) const {
        return static_cast<std::uint32_t>(&symbol - symbols_.data());
    }
    const ControlSymbol& at(std::uint32_t index) const { return symbols_[index]; }
    std::span<const ControlSymbol> all() const { return symbols_; }
    /// Hides one of the same name that all programs have.
    void add(ControlSymbol symbol) {
        by_name_.insert_or_assign(symbol.name, static_cast<std::uint32_t>(symbols_.size()));
        symbols_.push_back(std::move(symbol));
    }

  private:
    std::vector<ControlSymbol> symbols_;
    std::map<std::string, std::uint32_t, std::less<>> by_name_;
};

/// Numbers of the variables that a program names itself, `#<depth>`, in the order in which its
/// lines are first read. They hold for the whole run.
class NameTable {
  public:
    /// From 1 on; `name` as the language compares names.
    std::int64_t number_of(const std::string& name) {
        const auto [entry, is_new] =
            numbers_.emplace(name, static_cast<std::int64_t>(names_.size()) + 1);
        if (is_new) names_.push_back(name);
        return entry->second;
    }
    /// Empty: no name has the number.
    std::string_view name_of(std::int64_t number) const {
        const bool is_there = number >= 1 && static_cast<std::size_t>(number) <= names_.size();
        return is_there ? std::string_view(names_[static_cast<std::size_t>(number) - 1])
                        : std::string_view();
    }

  private:
    std::map<std::string, std::int64_t> numbers_;
    std::vector<std::string> names_;
};

/// What the axes of the machine are called, by the names that stand for them as an index.
using MachineAxisNames = std::map<std::string, Axis, std::less<>>;
/// `AX1` … in the order of these axes, and `X1`, `Y1` …: as machines call them unless set
/// otherwise.
MachineAxisNames usual_axis_names(std::span<const Axis> axes);

/// How a line is understood beyond what stands in it.
struct LineContext {
    NameTable* names = nullptr;     // gets the names of variables; null: the line is only looked at
    bool has_plain_codes = false;   // codes that call a program of their own mean what they are
    bool is_argument = false;       // the words are arguments of a modal call
    std::uint16_t skip_levels = 0;  // bit n: the operator leaves out what has the level n
    bool is_machine_data = false;   // by the machine: numbers may have more digits than a program's
    const MachineAxisNames* axis_names = nullptr;  // null: AX1 is X, AX2 Y … and X1 X, Y1 Y …
    friend bool operator==(const LineContext&, const LineContext&) = default;
};

/// Compiles a line by the language of the dialect. On a fault the line is not to be used.
std::optional<LineFault> compile_line(const DialectTables& tables, const SymbolTable& symbols,
                                      std::string_view line, ControlLine& out,
                                      const LineContext& context = {});

/// What a line is for someone who looks for a location in the program: its targets, and the
/// statement at its front. Quick: nothing is compiled.
struct LineFront {
    std::int64_t number = -1;
    Span number_span;        // with its letter
    std::string_view label;  // as it stands in the line
    Statement statement = Statement::None;
    std::uint32_t closes = 0;
    int loop = 0;           // number of the loop, 0 none
    bool is_empty = false;  // nothing but a number, a label and comments
};
LineFront front_of(const DialectTables& tables, std::string_view line);

/// The number or the quoted text at an index, as the statement Label has it; empty: none is there.
std::string_view label_at(std::string_view line, std::size_t at);

}  // namespace kadr::nc
