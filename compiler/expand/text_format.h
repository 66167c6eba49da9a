// text_format.h — values into texts. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// A text with its values.
std::string format(const Running& run, const sema::FormatPattern& pattern, const Slot* values);
/// A value for a message, in the units of the program: `2.5 mm`, `0.1 in`.
std::string quantity_text(const Running& run, double value, sema::Quantity quantity);
/// A value as the prompt shows it; `is_part`: inside of another one.
std::string shown(Running& run, std::uint32_t form, const Slot* value, bool is_part = false);

}  // namespace kadr::expand
