// loop_front.h — statements whose number stands in front of their keyword: `O100 WHILE`.
#pragma once

#include <optional>
#include <string_view>

#include "nc/control_words.h"
#include "nc/language.h"

namespace kadr::nc {

/// Whether the pattern begins with a letter, the number of a loop and a keyword.
bool begins_with_loop(const StatementForm& form);

/// The number that stands in front of the keyword of such a statement at `at`; nothing: the line
/// has another one there.
std::optional<int> loop_in_front(const ControlWords& words, std::string_view line,
                                 const StatementForm& form, std::size_t at);

/// Behind the signs with which the pattern begins, `(` of `(BNC,{target})`; nothing: they do not
/// stand at `at`.
std::optional<std::size_t> behind_front(const ControlWords& words, std::string_view line,
                                        const StatementForm& form, std::size_t at);

}  // namespace kadr::nc
