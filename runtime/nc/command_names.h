// command_names.h — what a control can be told, by the names of the vocabulary.
//
// For the list that a person asks for; explain() says more of one of them.
#pragma once

#include <string>
#include <vector>

#include "nc/dialect.h"

namespace kadr::nc {

/// The functions of the vocabulary and the cycles that the control has a spelling for: name and
/// meaning, one line of text each, functions first.
std::vector<std::string> command_names(const Dialect& dialect);

}  // namespace kadr::nc
