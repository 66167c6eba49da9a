// queries.h — questions to a checked program, as an editor asks them: what stands here, where is it
// declared, where is it used, what could stand here.
//
// Positions are bytes of a file. The answers are there for a program with mistakes as well, as far
// as the check came.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/source.h"
#include "sema/checked.h"
#include "syntax/parse.h"

namespace kadr::sema {

/// A place where a name stands, declared or used.
struct Occurrence {
    SourceRange range;  // of the name alone
    SymbolId symbol;
    bool is_declaration = false;
    friend bool operator==(const Occurrence&, const Occurrence&) = default;
};

/// The name that covers this byte, or ends there; nothing: none does, or nobody declared it (a
/// function of the language, a name with a mistake).
std::optional<Occurrence> symbol_at(const Checked& checked, const Sources& sources, FileId file,
                                    std::uint32_t byte);

/// All places of a name, its declaration among them, by file and position. In files that were
/// imported those are found that the check has come to.
std::vector<Occurrence> occurrences_of(const Checked& checked, const Sources& sources,
                                       SymbolId symbol);

/// The smallest expression that covers this byte, or ends there; not valid: there is none.
syntax::ExprId expression_at(const syntax::Ast& ast, std::uint32_t byte);

/// The type of the smallest expression at this byte, as a person writes it (`length`, `hole[]`);
/// of a declared name its type. Empty: nothing is known there.
std::string type_at(const Checked& checked, const Sources& sources, FileId file,
                    std::uint32_t byte);

/// A declaration on one line, as it would be written: `const length depth`, `cycle bore(length d)`.
std::string describe(const Checked& checked, SymbolId symbol);

/// A word that could stand at a position.
struct Proposal {
    enum class Kind : std::uint8_t {
        Symbol,    // `symbol`
        Member,    // of a value, behind its point; of a struct with `symbol`
        Builtin,   // a function of the language
        Command,   // a function of the vocabulary
        Keyword,   // in the keyword language of the file
        Address,   // a word of an NC block
        Argument,  // the name of a parameter of the call around
    };
    Kind kind = Kind::Symbol;
    std::string text;
    SymbolId symbol;
};

/// What could stand at this byte, in place of the word that ends there; sorted by text, each once.
/// BehindWords a point the members of what stands before it; in a call the names of its parameters,
/// too. `keywords` of the file's keyword language; null: none are proposed.
std::vector<Proposal> proposals_at(const Checked& checked, const Sources& sources,
                                   const syntax::KeywordTable* keywords, FileId file,
                                   std::uint32_t byte);

}  // namespace kadr::sema
