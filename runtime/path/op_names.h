// op_names.h — the names of commands, as lists of commands and machine files spell them.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "path/command.h"

namespace kadr::path {

/// "rapid", "speed_limit"
std::string_view op_name(Op op);

/// Nothing: no command has this name.
std::optional<Op> find_op(std::string_view name);

std::vector<std::string_view> op_names();

}  // namespace kadr::path
