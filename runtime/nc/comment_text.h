// comment_text.h — texts in the characters that a control can show.
#pragma once

#include <string>
#include <string_view>

#include "nc/tables.h"

namespace kadr::nc {

/// The text as it may stand in a comment of the control: one line; Cyrillic in Latin letters and
/// other characters as `?` if it knows ASCII only; upper case; signs that end a comment replaced.
std::string comment_text(std::string_view text, const CommentStyle& style);

/// `name` as a program name: letters, digits and `_`, upper case, cut to the length the control
/// takes, beginning as it wants.
std::string program_name(std::string_view name, const ProgramTemplates& frame);

}  // namespace kadr::nc
