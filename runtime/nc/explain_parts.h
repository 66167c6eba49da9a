// explain_parts.h — the parts of explain that have a file of their own.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nc/tables.h"

namespace kadr::nc {

/// Adds a line for each operator, function, statement and variable that the word is or begins.
void explain_language(const Language& language, std::string_view word,
                      std::vector<std::string>& lines);

}  // namespace kadr::nc
