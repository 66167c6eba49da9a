// command_names.h — what can be programmed on a control, by the names of the vocabulary.
//
// For the list that a person asks for; explain() tells more of one of them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nc/dialect.h"

namespace kadr::nc {

/// The functions of the vocabulary and the cycles that the control has a spelling for: name and
/// meaning, one line of text each, functions first.
std::vector<std::string> command_names(const Dialect& dialect);

/// What a word with a number (`G68`, `M98`) means on a control.
struct CommandMeaning {
    bool is_call = false;  // of a subprogram or a macro, or its end
    Function function = Function::None;
};

/// Nothing: the control has no such word, or it is that of a cycle.
std::optional<CommandMeaning> command_of_word(const Dialect& dialect, std::string_view word);

}  // namespace kadr::nc
