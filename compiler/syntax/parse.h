// parse.h — Kadr source → Ast. The only door to ANTLR.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "nc/dialect.h"
#include "syntax/ast.h"

namespace kadr::syntax {

/// What to do about a word that the input dialect does not have.
constexpr const char* kForeignWord =
    "the words of blocks are those of the input dialect, which `dialect fanuc;` or `dialect "
    "sinumerik;` at the head of the file chooses; `raw` passes any text";

/// What to do about the call of a subprogram: `M98 P100`, `L100`.
constexpr const char* kCallByName =
    "what is called is a cycle or a function of the file, `cycle name(length d) { … }`, by its "
    "name: `name(5mm);`";

/// What to do about a word whose value is an expression: `G0 Xd;`.
constexpr const char* kValueBehindSign = "a value that is no plain number stands behind `=`";

/// Letters of the address that a name begins with where a word with its value was meant: one of
/// `Xd`, two of `CRr`; 0 if it does not look so.
std::size_t glued_address(const nc::Dialect& dialect, std::string_view name);

/// What a name would be with digits for the letters that look like them, where that is an address
/// with its number: `G0` for `GO`, `X10` for `XlO`. Empty: it is none.
std::string word_with_digits(const nc::Dialect& dialect, std::string_view name);

/// Lexemes of the structural elements in one keyword language: "если" is `if`.
struct KeywordTable {
    std::string name;                                        // "en", "ru"
    std::unordered_map<std::string, std::string> canonical;  // lexeme → English keyword or type
};

/// Loads dialects/languages/NAME.xml. Mistakes are reported; nothing is returned then.
std::optional<KeywordTable> load_keywords(const std::string& name_or_file,
                                          const std::vector<std::string>& folders, Sources& sources,
                                          DiagnosticSink& sink);

/// Name of the keyword language that the source's first declaration asks for (`language ru;`), and
/// of its input dialect (`dialect fanuc;`); empty where it does not name one. A cheap look at the
/// first lines, before the lexeme tables are known.
struct SourceHeader {
    std::string language;
    std::string dialect;
    std::uint32_t language_at = 0;  // byte of the name, where there is one
    std::uint32_t dialect_at = 0;
};
SourceHeader scan_header(std::string_view text);

/// Parses one file. Every syntax error of the file is reported in one run, in a technologist's
/// words; the tree then has Invalid nodes where errors stood. Where `is_over` becomes true the tree
/// is not complete, and whoever asked reports why. `dialect` knows which identifiers are words of
/// NC blocks.
Ast parse(const Sources& sources, FileId file, const KeywordTable& keywords,
          const nc::Dialect& dialect, DiagnosticSink& sink,
          const std::function<bool()>& is_over = {});

}  // namespace kadr::syntax
