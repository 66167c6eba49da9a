// line_ends.h — inside of braces a line end ends a statement, as it does outside of them.
//
// A file needs its `;`. At the prompt the end of a line, or a `}`, stands for one that was
// forgotten, wherever the statement is whole there.
#pragma once

#include <string>
#include <string_view>

#include "driver/session.h"

namespace kadr::repl {

/// The text of an input whose brackets are closed, with `;` put behind whole statements that stand
/// in braces without one; the text as it is if it can be read like that, or has no fewer mistakes
/// with them. `headers` are the `language` and `dialect` that hold.
std::string with_line_ends(driver::Session& session, std::string_view headers,
                           const std::string& text);

}  // namespace kadr::repl
