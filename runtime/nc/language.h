// language.h — the control's own parametric language, as its dialect describes it.
//
// What operators, functions, statements and variables mean is the closed vocabulary of
// language.def; how they are spelled is loaded from <language> into the tables below. The compiler
// of lines (control_parser.h) reads text by them, interp executes.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/source.h"
#include "nc/calls.h"

namespace kadr::nc {

enum class Operation : std::uint8_t {
#define KADR_OPERATION(id, name, least, most, meaning) id,
#include "nc/language.def"
#undef KADR_OPERATION
};

enum class Statement : std::uint8_t {
#define KADR_STATEMENT(id, name, meaning) id,
#include "nc/language.def"
#undef KADR_STATEMENT
};

enum class SystemQuantity : std::uint8_t {
#define KADR_QUANTITY(id, name, indices, access, meaning) id,
#include "nc/language.def"
#undef KADR_QUANTITY
};

/// A component of a frame.
enum class FramePart : std::uint8_t {
#define KADR_FRAME_PART(id, name, meaning) id,
#include "nc/language.def"
#undef KADR_FRAME_PART
};

struct OperationInfo {
    std::string_view name;
    int least_arguments;
    int most_arguments;
    std::string_view meaning;
};
const OperationInfo& info(Operation operation);
std::span<const OperationInfo> all_operations();

struct StatementInfo {
    std::string_view name;
    std::string_view meaning;
};
const StatementInfo& info(Statement statement);
std::span<const StatementInfo> all_statements();

struct QuantityInfo {
    enum class Access : std::uint8_t { Read, Write, Both };
    std::string_view name;
    int indices;
    Access access;
    std::string_view meaning;
};
const QuantityInfo& info(SystemQuantity quantity);
std::span<const QuantityInfo> all_quantities();
/// What ToolDatum multiplies the number of a datum with, to add the number of the edge.
inline constexpr std::int64_t kDatum = 1000;

struct FramePartInfo {
    std::string_view name;
    std::string_view meaning;
};
std::span<const FramePartInfo> all_frame_parts();

struct LanguageRules {
#define KADR_LANGUAGE_RULE(type, field, standard, values, meaning, source) type field = standard;
#include "nc/language.def"
#undef KADR_LANGUAGE_RULE
};

/// A row of the rules, for documentation and for the check of dialect files.
struct LanguageRuleInfo {
    std::string_view name;
    std::string_view values;
    std::string_view meaning;
    std::string_view source;
};
std::span<const LanguageRuleInfo> all_language_rules();
/// Sets one rule from its text. False: there is no such rule, or it cannot have that value.
bool set_language_rule(LanguageRules& rules, std::string_view name, std::string_view value);

/// What a variable holds.
enum class ValueType : std::uint8_t { Real, Int, Bool, Char, Text, Axis, Frame };

struct OperatorForm {
    Operation operation = Operation::Add;
    std::string text;  // `+`, `MOD`
    int level = 0;     // 1 binds strongest
    bool is_prefix = false;
    bool is_word = false;  // letters
};

struct FunctionForm {
    Operation operation = Operation::Sine;
    std::string name;
    int arguments = 1;
    bool is_divided = false;  // `ATAN[{a}]/[{b}]`
    bool takes_any = false;   // `CTRANS({pairs})`, `CMIRROR({axes})`: none, or several
    /// Arguments that are variables of the program, and not their values: `{array}`, `{variable}`;
    /// a bit each.
    std::uint32_t references = 0;
    /// Which of them have an index behind, that counts as the next argument: `{array}[{row}]`.
    std::uint32_t indexed = 0;
    std::string form;
    std::string doc;
};

/// What the numbers `first` to `last` of a family of variables are, or a named variable.
struct VariableRange {
    enum class Kind : std::uint8_t {
        Global,    // a store of the whole run
        Local,     // one of each level of calls
        Constant,  // `value`, read only
        System,    // a system variable of the interpreter
        Same,      // another name of a variable of the family: of number `value`, or that and more
        Input,     // a value of the machine, which programs write as well if `is_shared`
        Bits,      // 32 variables of the family from number `value` on, each a bit
        Unsupported,  // the control has it and Kadr does not
    };
    Kind kind = Kind::Global;
    std::int64_t first = 0;
    std::int64_t last = 0;
    ValueType type = ValueType::Real;
    bool is_vacant = false;  // Constant: the value is "vacant"
    double value = 0;        // Constant; Global: what it holds at the beginning, if has_initial
    bool has_initial = false;
    SystemQuantity quantity = SystemQuantity::None;
    std::int64_t start = 1;   // System: the index that `first` stands for
    std::int64_t stride = 0;  // System with two indices: so many numbers an index
    std::int64_t second = 1;  // … of which the first number stands for this second index
    std::uint32_t slot = 0;   // Global, Local: of `first` in its store
    bool is_shared = false;   // Input: the program writes it, too
    std::string meaning;      // for explanations and messages
};

/// One index of a named variable.
struct IndexHole {
    enum class Kind : std::uint8_t { Number, Axis, Word };
    Kind kind = Kind::Number;
    std::string word;  // Kind::Word: must stand there, `TR`
};

/// `#{n}`, `R{n}`, `$P_EP[{axis}]`, `#_ABSIO[{n}]`, `#<{name}>`, `$MN_{name}`.
struct VariableForm {
    std::string form;
    std::string name;           // the letters before the number or the indices
    std::string closing;        // stands behind a name of the program's own; empty: it has none
    bool is_family = false;     // a number stands behind the name, or an index in brackets
    bool has_signs = false;     // the name is more than a word: `#<_feed>`
    bool is_open = false;       // `$MN_{name}`: further letters, and the indices that stand there
    bool has_namesake = false;  // of two names alike one has indices
    std::vector<IndexHole> indices;
    std::vector<VariableRange> ranges;  // of a family by number; a named variable has one
    SourceRange range;                  // in the file
};

/// One piece of the pattern of a statement.
struct StatementToken {
    enum class Kind : std::uint8_t { Word, Sign, Hole };
    enum class Hole : std::uint8_t {
        Variable,
        Value,
        Condition,
        Target,
        Loop,
        First,
        Last,
        Number,
        Text,
        Count,
        From,
        To,
        Type,
        Declarations,
        Cases,
        Jump,
        Statement,
        Call,
        Procedure,
        Print,
        Rest,
        Table,
        Row,
    };
    Kind kind = Kind::Word;
    Hole hole = Hole::Value;
    bool is_optional = false;  // the rest of the pattern from this piece on may be left out
    std::string text;          // Word, Sign
};

struct StatementForm {
    Statement statement = Statement::None;
    std::string form;
    std::vector<StatementToken> tokens;
    std::string front;                   // signs in front of the first keyword: `(BNC,{target})`
    std::uint32_t closes = 0;            // EndLoop: a bit for each statement that it ends
    bool repeats = false;                // the same may follow in the block (IfDo)
    std::optional<Operation> operation;  // of the values in its holes: the value that counts
    std::string doc;
};

struct TypeName {
    std::string name;
    ValueType type = ValueType::Real;
};

/// A word behind the axis in the brackets of a frame: `[X,TR]`.
struct FramePartName {
    std::string word;
    FramePart part = FramePart::Shift;
};

/// `G1 G2 G3`: the codes of a group in the order of the numbers that a program asks for.
struct GroupCodes {
    std::string group;
    std::vector<std::string> codes;
    std::int64_t standard = 1;  // number of the one that acts where none was given; 0: none does
};

/// The whole language of a control.
struct Language {
    bool is_present = false;
    char open = '(';  // brackets of expressions
    char close = ')';
    char index_open = '[';  // of indices
    char index_close = ']';
    std::string label_sign;   // behind a label, `:`
    std::string label_quote;  // on both sides of a label, `"`; with neither sign block numbers are
                              // the only targets
    int label_length = 32;    // most characters of a label
    bool names_blocks = false;  // a jump says a block by its word, `N20`, where there are no labels
    std::string end_label;      // ends the section of a repeat
    std::string axis_word;      // `AX`: a word whose axis stands between brackets behind it
    std::vector<std::string> lone_axis_words;  // `POS`: … and moves by itself
    LanguageRules rules;
    std::vector<OperatorForm> operators;
    std::vector<FunctionForm> functions;
    std::vector<VariableForm> variables;
    std::vector<StatementForm> statements;
    std::vector<TypeName> types;
    std::vector<FramePartName> frame_parts;
    std::vector<GroupCodes> code_lists;
    CallLanguage calls;
    bool has_labels() const { return !label_sign.empty() || !label_quote.empty(); }
    // Made when it is loaded.
    bool has_axes = false;              // values may be axes
    bool has_names_with_signs = false;  // `#<_feed>`, spelled out
    bool has_label_numbers = false;     // targets are what the statement Label finds
    std::uint32_t global_slots = 0;
    std::uint32_t local_slots = 0;
    int lowest_level = 0;              // of the operators: the number of the weakest
    std::bitset<128> variable_starts;  // first letters of variables
    std::bitset<128> call_starts;      // first letters of codes that call a program
};

/// The range of a family whose variables are in the store of the run, and hold this slot; nullptr
/// if a named variable or a declared one is there.
const VariableRange* range_of_slot(const Language& language, std::uint32_t slot);
/// The range that holds the number; nullptr if the family has no such variable.
const VariableRange* find_range(const VariableForm& family, std::int64_t number);

}  // namespace kadr::nc
