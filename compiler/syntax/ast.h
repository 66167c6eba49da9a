// ast.h — a Kadr program after parsing: flat vectors, typed indices, no ANTLR.
//
// Every node is one plain struct with a kind; what its children mean is noted at the kind. Lists
// of children are runs in `Ast::expression_lists` and so on. Nothing nests deeper than kMaxNesting,
// so that a recursive walk is safe; a walk of chains (see is_chained) must go down their left side
// by a loop. Nothing is resolved here: names are texts, types are as written.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/source.h"

namespace kadr::syntax {

struct ExprId {
    std::uint32_t index = 0xffffffffu;
    bool is_valid() const { return index != 0xffffffffu; }
};
struct StmtId {
    std::uint32_t index = 0xffffffffu;
    bool is_valid() const { return index != 0xffffffffu; }
};
struct DeclId {
    std::uint32_t index = 0xffffffffu;
    bool is_valid() const { return index != 0xffffffffu; }
};
struct TypeId {
    std::uint32_t index = 0xffffffffu;
    bool is_valid() const { return index != 0xffffffffu; }
};
/// An interned text; 0 is the empty text.
struct TextId {
    std::uint32_t index = 0;
    bool is_empty() const { return index == 0; }
    friend bool operator==(TextId, TextId) = default;
};

/// Deepest nesting of expressions and of statements; what is deeper is a diagnostic. In a chain
/// only what stands right of its operators counts.
inline constexpr int kMaxNesting = 500;

/// A run of children in one of the list vectors of Ast.
struct List {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

enum class Unit : std::uint8_t {
    None,
    Mm,
    Cm,
    M,
    Um,
    Inch,
    Deg,
    Rad,
    S,
    Ms,
    Min,
    MmPerMin,
    MPerMin,
    InchPerMin,
    MmPerS,
    MmPerRev,
    InchPerRev,
    Rpm,
    Percent,
};

enum class ExprKind : std::uint8_t {
    Invalid,      // a syntax error stood here
    Bool,         // integer: 0 or 1
    Int,          // integer
    Real,         // number; with `unit` also for whole numbers
    String,       // without braces: text, and an empty list; with: list of pieces, each a String
                  // without list or a Format, no two Strings in a row; escapes are resolved
    Format,       // child 0: expression; text: the format behind ':' (".3", "03"), may be empty
    Name,         // text
    Unary,        // op; child 0
    Binary,       // op; child 0, child 1 (also `??`)
    Conditional,  // child 0 ? child 1 : child 2
    Assign,       // op (Assign or the compound operator); child 0 = target, child 1 = value
    Call,         // child 0 = callee (Name or Member); arguments: list
    Argument,     // text = name, may be empty; child 0 = value
    Index,        // child 0 [ child 1 ]
    Member,       // child 0 . text
    Given,        // `given a`, `given a[i]`, `given h.d`: child 0 = Name, Index or Member
    Braces,       // { … }: list of values, an Argument where a member is named (`{x: 1mm}`); a
                  // point, array or struct by its position
    Range,        // child 0 .. child 1
    TypedCall,    // `table<hole>("f.csv")`: text = callee, type; arguments: list
};

enum class Operator : std::uint8_t {
    None,
    Plus,
    Minus,
    Not,
    BitNot,
    PreIncrement,
    PreDecrement,
    PostIncrement,
    PostDecrement,
    Multiply,
    Divide,
    Modulo,
    Add,
    Subtract,
    ShiftLeft,
    ShiftRight,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    BitAnd,
    BitXor,
    BitOr,
    And,
    Or,
    Coalesce,
    Contains,
    Assign,
    AddAssign,
    SubtractAssign,
    MultiplyAssign,
    DivideAssign,
    ModuloAssign,
    ShiftLeftAssign,
    ShiftRightAssign,
    BitAndAssign,
    BitXorAssign,
    BitOrAssign,
};

/// Whether `a op b op c …` is a chain: a tree that hangs to the left and may be of any length, as
/// generated sums and texts are.
constexpr bool is_chained(Operator op) {
    return (op >= Operator::Multiply && op <= Operator::ShiftRight) ||
           (op >= Operator::BitAnd && op <= Operator::BitOr);
}

struct Expr {
    ExprKind kind = ExprKind::Invalid;
    Operator op = Operator::None;
    Unit unit = Unit::None;
    SourceRange range;
    TextId text;
    TypeId type;
    std::int64_t integer = 0;
    double number = 0;
    std::array<ExprId, 3> child{};
    List list;  // in Ast::expression_lists

    /// Child 0 may be a link as well, and so on.
    bool is_chain_link() const { return kind == ExprKind::Binary && is_chained(op); }
};

/// A word of a block: `X10`, `X=r+1`, `X+=5mm`, `I=AC(5)`, `G1`, `TRANS`.
struct Word {
    enum class Form : std::uint8_t { Bare, Literal, Assigned, Increment };
    enum class Mode : std::uint8_t { Modal, Absolute, Incremental };  // plain; AC(…); IC(…) or +=
    Form form = Form::Bare;
    Mode mode = Mode::Modal;
    TextId address;          // "X", "G", "CR", "TRANS"
    double number = 0;       // of a Literal, sign included
    Unit unit = Unit::None;  // of a Literal: `X10mm`
    ExprId value;            // of Assigned and Increment
    SourceRange range;
};

enum class StmtKind : std::uint8_t {
    Invalid,
    Empty,
    Block,        // { … }: statements: list
    Expression,   // expression[0]
    Declaration,  // declaration (a Variable or a Contour)
    If,           // expression[0]; statement[0] then; statement[1] else, may be invalid
    While,        // expression[0]; statement[0]
    DoWhile,      // statement[0]; expression[0]
    For,  // statement[0] init, expression[0] condition, expression[1] step: each may be invalid;
          // statement[1] body
    ForEach,  // declaration (a Variable without value), expression[0] sequence; statement[0] body
    Switch,   // expression[0]; statements: list of Case
    Case,     // expressions: list of values (empty: default); statements: list
    Break,
    Continue,
    Return,  // expression[0], may be invalid
    Words,   // an NC block: words; expression: a point given behind the words (`G1 p;`) and how the
             // tool stands (`orient(…)`), in whatever order; both may be invalid
    With,    // words: list of modal words; expressions: list of frame calls; statement[0] body
    Note,    // expression[0]: text of a comment in the output
    Raw,     // expression[0]: text that goes through, may hold several lines
    Units,   // text: "mm" or "inch"
    Require,    // expression[0] condition; expression[1] text, may be invalid
    Assert,     // as Require
    ErrorStmt,  // expression[0] text
    WarnStmt,   // expression[0] text
    Close,      // `close;` in a contour
    Assume,     // expression[0], in a property
    Expect,     // expression[0], in a test
};

/// `/` without a level: the control's own default.
inline constexpr std::int8_t kDefaultSkipLevel = 10;

struct Stmt {
    StmtKind kind = StmtKind::Invalid;
    SourceRange range;
    TextId text;
    DeclId declaration;
    std::array<ExprId, 2> expression{};
    std::array<StmtId, 2> statement{};
    List statements;   // in Ast::statement_lists
    List expressions;  // in Ast::expression_lists
    List words;        // in Ast::words
    std::int8_t skip_level =
        -1;  // Words: level of `/G1 X5;`, 0…9; kDefaultSkipLevel: `/` alone; -1: none
};

/// A type as written: `length`, `hole[]`, `real[8]`, `length?`, `point&`.
struct TypeRef {
    enum class Array : std::uint8_t { None, Growing, Fixed };
    TextId name;  // canonical English name of a built-in type, or the user's
    Array array = Array::None;
    ExprId size;  // of a Fixed array
    bool is_optional = false;
    bool is_reference = false;
    SourceRange range;
};

enum class DeclKind : std::uint8_t {
    Invalid,
    Variable,   // type, name, value (may be invalid), is_const; `auto`: type invalid
    Parameter,  // type, name, value = default, may be invalid
    Function,   // type = result, name, parameters, body
    Cycle,      // name, parameters, preserves, body
    Program,    // name, parameters, preserves, body
    Struct,     // name; members: list of Variable
    Enum,       // name; members: list of Variable (value may be invalid)
    Import,    // name: dotted path `cycles.drilling`, or a file in quotes (is_file); `#include` too
    Contour,   // name, body
    Curve,     // name, parameters; members[0]: the running parameter (Variable); values: from, to;
               // body
    Test,      // name: its title; body
    Property,  // name; parameters with ranges in `value`; body
    Units,     // name: "mm" or "inch", for the whole file
    Dialect,   // name: input dialect of the file
    Language,  // name: keyword language of the file
};

struct Decl {
    DeclKind kind = DeclKind::Invalid;
    bool is_const = false;
    bool is_file = false;
    TextId name;
    TextId documentation;  // of `///` lines before it
    TypeId type;
    ExprId value;
    ExprId value_to;  // Curve: end of the range
    StmtId body;
    List parameters;  // in Ast::declaration_lists
    List members;     // in Ast::declaration_lists
    List preserves;   // in Ast::words: `G90`, `G17`, and the word FRAMES for `frames`
    SourceRange range;
    SourceRange name_range;
};

/// A comment of the source, for the formatter and for documentation.
struct Comment {
    SourceRange range;
    bool is_documentation = false;
};

/// One parsed file. Built by `parse`; plain data, copied and compared trivially.
struct Ast {
    FileId file;
    std::vector<Expr> expressions;
    std::vector<Stmt> statements;
    std::vector<Decl> declarations;
    std::vector<TypeRef> types;
    std::vector<Word> words;
    std::vector<ExprId> expression_lists;
    std::vector<StmtId> statement_lists;
    std::vector<DeclId> declaration_lists;
    std::vector<std::string> texts = {""};
    std::vector<DeclId> top;  // in source order
    std::vector<Comment> comments;
    /// Names of what stood where it cannot be declared; whoever uses them makes no second mistake.
    std::vector<std::string> lost_names;
    std::string language;  // of the keywords
    /// English keywords for which this language has another word, with that word.
    std::map<std::string, std::string, std::less<>> keyword_words;
    bool has_errors = false;  // of the syntax; the tree has holes

    const Expr& operator[](ExprId id) const { return expressions[id.index]; }
    const Stmt& operator[](StmtId id) const { return statements[id.index]; }
    const Decl& operator[](DeclId id) const { return declarations[id.index]; }
    const TypeRef& operator[](TypeId id) const { return types[id.index]; }
    std::string_view text(TextId id) const { return texts[id.index]; }
    std::span<const ExprId> exprs(List list) const {
        return {expression_lists.data() + list.first, list.count};
    }
    std::span<const StmtId> stmts(List list) const {
        return {statement_lists.data() + list.first, list.count};
    }
    std::span<const DeclId> decls(List list) const {
        return {declaration_lists.data() + list.first, list.count};
    }
    std::span<const Word> word_run(List list) const {
        return {words.data() + list.first, list.count};
    }
};

}  // namespace kadr::syntax
