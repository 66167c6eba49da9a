// rule_defaults.h — what a rule is where no dialect file sets it.
//
// The interpreter has all rules as typed values (interp/rules.def). The checker, the expander and
// the writer ask a dialect for some of them by name; here are the defaults of those, as the text
// that a file would have. A test holds them against the table, and an assertion finds a name that
// is missing: what one room takes for granted, no other does without.
#pragma once

#include <span>
#include <string_view>

#include "nc/dialect.h"

namespace kadr::nc {

struct RuleDefault {
    std::string_view name;
    std::string_view text;  // "no", "0.01", "spread"
};

/// The rules that rooms other than the interpreter ask for.
std::span<const RuleDefault> rule_defaults();

/// The value of a rule, by the files or by default. A name without a row here is our mistake.
std::string_view rule_text(std::span<const RuleSetting> settings, std::string_view name);

/// The value of a rule that is a number.
double rule_value(const Dialect& dialect, std::string_view name);

}  // namespace kadr::nc
