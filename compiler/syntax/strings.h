// strings.h — what stands between two quotes.
#pragma once

#include <functional>
#include <vector>

#include "syntax/lexeme.h"

namespace kadr::syntax {

/// Appends the tokens of the text literal at [begin, end), quotes included: one Text, or TextOpen,
/// the tokens of an expression, maybe Format, … TextClose. `lex_piece` appends the tokens of a
/// piece of the source.
void split_text(const SourceFile& file, std::uint32_t begin, std::uint32_t end, bool is_closed,
                const std::function<void(std::uint32_t, std::uint32_t)>& lex_piece,
                std::vector<Lexeme>& out);

/// The lines between the braces of `raw { … }`, without the first and the last line end and without
/// the indentation that all of them share.
std::string raw_lines(std::string_view between);

}  // namespace kadr::syntax
