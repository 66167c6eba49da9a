// format_line.h — one statement without its blocks, as one line or several.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "syntax/pieces.h"

namespace kadr::syntax {

/// Columns of a line.
inline constexpr std::size_t kLineWidth = 100;
/// Columns of one level of indentation.
inline constexpr std::size_t kIndent = 4;

/// The pieces with the blanks that belong between them, indented; in one line if they fit, else
/// broken at the outermost point that makes a line fit. What goes on in brackets is aligned behind
/// the bracket, anything else is indented by `continuation` more. Line comments end their line.
/// They fit if they end in column `width`.
std::vector<std::string> format_line(std::span<const LayoutPiece> pieces, std::size_t indent,
                                     std::size_t continuation, std::size_t width = kLineWidth);

/// Columns that a text in UTF-8 takes.
std::size_t text_width(std::string_view text);

}  // namespace kadr::syntax
