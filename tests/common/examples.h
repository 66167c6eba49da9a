// examples.h — which examples of the table of diagnostics are programs.
#pragma once

#include <string>
#include <string_view>

namespace kadr::testing {

/// Whether an example is a program that can be run. Command lines, pieces of tables and examples
/// shortened with an ellipsis are not; their rows need tests of their own.
inline bool is_program(std::string_view example) {
    const bool is_table = example.find("program") == std::string_view::npos &&
                          example.find('{') == std::string_view::npos;
    return !is_table && !example.starts_with("kadr ") && !example.starts_with("(") &&
           example.find("…") == std::string_view::npos;
}

/// The remark in brackets behind a program, ` (for a FANUC)`; empty: there is none.
inline std::string_view remark_of(std::string_view example) {
    const std::size_t open = example.rfind(" (");
    const bool is_behind = open != std::string_view::npos && open > 0 && example.ends_with(')') &&
                           (example[open - 1] == ';' || example[open - 1] == '}');
    return is_behind ? example.substr(open) : std::string_view();
}

/// The example without the remark.
inline std::string text_of(std::string_view example) {
    return std::string(example.substr(0, example.size() - remark_of(example).size()));
}

}  // namespace kadr::testing
