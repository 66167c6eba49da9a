// table_pages.h — the tables of the program as pages show them: rules, the language of controls,
// commands, cycles, figures of tests,
// thresholds, diagnostics.
#pragma once

#include <string>
#include <string_view>

namespace docs {

std::string rules_table();
std::string language_rules_table();
std::string operations_table();
std::string frame_parts_table();
std::string statements_table();
std::string quantities_table();
/// With the first words by which SINUMERIK and FANUC say each.
std::string commands_table();
std::string cycles_table();

/// What a test can ask about an execution.
std::string figures_table();
/// Beyond which a legal word is warned of.
std::string danger_limits_table();

/// Code, name, message and explanation of the rows whose code begins so.
std::string diagnostics_table(std::string_view code);

}  // namespace docs
