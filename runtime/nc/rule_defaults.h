// rule_defaults.h — what a rule is where no dialect file sets it.
//
// The defaults of rules.def as the text that a file would have: rooms below the interpreter, which
// has the rules as typed values, ask a dialect by name.
#pragma once

#include <string_view>

namespace kadr::nc {

/// The text of the rule's default: "no", "0.01", "spread". A name that no rule has is our mistake.
std::string_view rule_default(std::string_view name);

}  // namespace kadr::nc
