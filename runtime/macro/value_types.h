// value_types.h — what a variable of each type makes of a value that it is given.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "macro/control_value.h"

namespace kadr::macro {

/// Why a variable did not take a value; `row` is null if it did.
struct VariableFault {
    const DiagnosticRow* row = nullptr;
    std::vector<std::string> arguments;
};

/// Makes the value, which is this text if it is one, what a variable of the type holds: rounded to
/// a whole number, a truth value, a character.
VariableFault convert(nc::ValueType type, ControlValue& value, std::string_view text);

/// What a variable of texts gets: a character or a truth value is written out. S 8.2.
std::string written_text(const ControlValue& value, std::string_view text);

}  // namespace kadr::macro
