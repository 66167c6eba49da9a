// reference_queries.h — questions to what a text declares and uses, as an editor asks them: what
// stands here, where is it declared, where is it used, what could stand here.
//
// Positions are bytes of a text. The answers are there for a text with mistakes as well.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "macro/references.h"

namespace kadr::macro {

/// The use whose name covers this byte, or ends there; null: there is none.
const TextUse* use_at(const References& references, std::uint64_t byte);

/// What the name at this byte means, declared or used there; nothing: no name stands there, or
/// nobody has declared it.
std::optional<NamedPlace> declaration_at(const References& references, std::uint64_t byte);

/// Where the use leads, in whatever text; nothing: that is not known.
std::optional<NamedPlace> target_of(const References& references, const TextUse& use);

/// The program in which this byte stands: its index among the declarations.
std::uint32_t program_at(const References& references, std::uint64_t byte);

/// A place where a name stands.
struct NameOccurrence {
    std::size_t text = 0;  // index of its text in the list
    TextRange range;
    bool is_declaration = false;
    TextUse::Kind kind = TextUse::Kind::Read;  // of a use
    friend bool operator==(const NameOccurrence&, const NameOccurrence&) = default;
};

/// All places of a name in these texts, by text and position.
std::vector<NameOccurrence> occurrences_of(std::span<const References> texts,
                                           const NamedPlace& name);

/// A row of the outline of a text.
struct OutlineRow {
    enum class Kind : std::uint8_t { Program, Label, Call };
    Kind kind = Kind::Program;
    std::string name;  // of a Call what it calls; empty: it is computed
    TextRange range;
    std::uint32_t program = 0;  // index of the declaration in which it stands
};
/// Programs, labels and calls in the order of the text.
std::vector<OutlineRow> outline_of(const References& references);

/// Blocks with numbers of a program, in the order of the text: those at which nobody aims, too.
///
/// program  index of its declaration
/// most     so many are looked for
std::vector<TextDeclaration> blocks_of(const nc::Dialect& dialect, nc::TextSource& text,
                                       const References& references, std::uint32_t program,
                                       std::size_t most);

/// A line of a text that somebody writes, and where.
struct LineCursor {
    std::string_view line;
    std::uint32_t column = 0;  // bytes in front of the cursor
    std::uint64_t begin = 0;   // of the line in its text
};
/// Names that could stand at the cursor, in place of the word that ends there; sorted, each once:
/// labels and blocks that a jump would find there, programs behind a call, variables in a value.
std::vector<std::string> names_at(const nc::Dialect& dialect, nc::TextSource& text,
                                  const References& references, const LineCursor& cursor,
                                  ProgramFiles* files);

}  // namespace kadr::macro
