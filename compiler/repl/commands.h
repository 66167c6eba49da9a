// commands.h — the table of the prompt's commands.
#pragma once

#include <string_view>
#include <vector>

namespace kadr::repl {

struct CommandRow {
    std::string_view name;  // without the `:`
    std::string_view argument;
    std::string_view meaning;
};

std::vector<CommandRow> command_table();

}  // namespace kadr::repl
