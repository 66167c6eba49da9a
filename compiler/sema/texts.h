// texts.h — texts: their pieces and formats, and the constants of the code that describe values.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// The index of a text in the code; each text stands there once.
std::uint32_t text_constant(Check& check, std::string_view text);
/// The index of the layout of an array's elements of this type.
std::uint32_t layout_constant(Check& check, Type type);
/// Reads the format behind `:` in a text (".3", "03", "u") for a value; a wrong one is reported.
Done read_format(Check& check, const Value& value, std::string_view format,
                 const SourceRange& range, FormatPiece& piece);
/// Lets the piece show the unit of its values behind them, with `between` before it.
void add_unit(Check& check, Type type, std::string_view between, FormatPiece& piece);
void add_unit(Check& check, Type type, std::string_view between, Units units,
              FormatPiece::Scale& scale);
/// A text, with its pieces.
Value string(Check& check, syntax::ExprId id, Reg hint);
/// A value as a text.
Value text_of(Check& check, const Value& value, const SourceRange& range);
/// The index of the form in which a value of the type is shown; `is_part`: inside of another one.
std::uint32_t shown_form(Check& check, Type type, bool is_part);
/// Makes the value of an expression known at the prompt, given or not.
void show(Check& check, syntax::ExprId id);

}  // namespace kadr::sema
