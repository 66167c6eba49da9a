// checked.h — what the checker has found out: types, declarations, uses, constants, plans of
// blocks.
//
// Plain vectors over the ids of each tree, recorded in the pass that checks. They exist after
// errors as well, as far as it came; of a file that was imported they tell of what somebody uses.
// `queries.h` answers questions from them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/source.h"
#include "nc/dialect.h"
#include "sema/code.h"
#include "sema/types.h"
#include "syntax/ast.h"

namespace kadr::sema {

/// What is known about a variable at one point of the program.
enum class Givenness : std::uint8_t { Given, Perhaps, NotGiven };

/// A name of a file, of a function or of a type; it outlives its scope.
struct DeclaredSymbol {
    enum class Kind : std::uint8_t {
        Variable,
        Parameter,
        Contour,
        Function,
        Cycle,
        Program,
        Curve,
        Test,
        Property,
        Struct,
        Member,
        Enum,
        EnumMember,
    };
    Kind kind = Kind::Variable;
    std::string name;
    std::uint32_t file = 0;  // index into Checked::files
    syntax::DeclId decl;     // not valid: a coordinate of a curve, which nobody writes down
    SourceRange range;       // of the name where it is declared
    SourceRange scope;       // of a local name: where it can be used; not valid: in all of its file
    Type type;               // of a Function its result
    SymbolId owner;  // of a Parameter or local name its function, of a Member its struct …
    bool is_const = false;
};

/// What an expression came to.
struct ExpressionFacts {
    static constexpr std::uint32_t kNoConstant = 0xffffffffu;

    Type type;                             // kError: it was not checked, or has a mistake
    SymbolId symbol;                       // of a Name, a Member or a named Argument: what it means
    std::uint32_t constant = kNoConstant;  // index into Checked::constants; not of literals
    Givenness givenness = Givenness::Given;  // of a Name: what is known where it stands
};

/// What an NC block came to.
struct StatementFacts {
    static constexpr std::uint32_t kNoPlan = 0xffffffffu;

    std::uint32_t plan = kNoPlan;  // index into Checked::plans; of several blocks the first
};

/// A value that is known before the program runs.
struct ConstantValue {
    Type type;
    Slot slot{};       // of a String nothing
    std::string text;  // of a String
};

/// A use that is no name of the tree: the word of a control that calls a cycle of the library.
struct WordUse {
    SourceRange range;
    SymbolId symbol;
};

struct ImportedFile {
    SourceRange range;       // of the declaration
    std::uint32_t file = 0;  // index into Checked::files
};

/// One tree and what was found out about it. The vectors have the length of those of the tree.
struct CheckedFile {
    const syntax::Ast* ast = nullptr;  // lives as long as the loader of the check
    const nc::Dialect* dialect = nullptr;
    Units units = Units::Metric;
    std::vector<ExpressionFacts> expressions;  // by ExprId
    std::vector<StatementFacts> statements;    // by StmtId
    std::vector<SymbolId> declarations;        // by DeclId: what it declares
    std::vector<SymbolId> types;               // by TypeId: the struct or enum that is named
    std::vector<WordUse> words;                // in the order of the check
    std::vector<ImportedFile> imports;         // in the order of the file; the prelude is not named
};

struct Checked {
    TypeTable types;
    std::vector<DeclaredSymbol> symbols;  // by SymbolId
    std::vector<ConstantValue> constants;
    std::vector<Plan> plans;
    std::vector<CheckedFile> files;   // 0: the one that was asked for
    std::uint32_t prelude = kNoFile;  // index of the file whose names are everybody's

    static constexpr std::uint32_t kNoFile = 0xffffffffu;

    const DeclaredSymbol& operator[](SymbolId id) const { return symbols[id.index]; }
};

}  // namespace kadr::sema
