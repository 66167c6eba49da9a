// texts.h — texts: their pieces and formats, and the constants of the code that describe values.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

std::uint32_t text_constant(Check& check, std::string_view text);
std::uint32_t layout_constant(Check& check, Type type);
Done read_format(Check& check, const Value& value, std::string_view format,
                 const SourceRange& range, FormatPiece& piece);
void add_unit(Check& check, Type type, std::string_view between, FormatPiece& piece);
void add_unit(Check& check, Type type, std::string_view between, Units units,
              FormatPiece::Scale& scale);
Value string(Check& check, syntax::ExprId id, Reg hint);
Value text_of(Check& check, const Value& value, const SourceRange& range);
/// Makes the value of an expression known at the prompt, given or not.
void show(Check& check, syntax::ExprId id);

}  // namespace kadr::sema
