// examples.h — which examples of the table of diagnostics are programs.
#pragma once

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

}  // namespace kadr::testing
