// statement_holes.h — which holes belong to which statement of a control's language.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "nc/language.h"

namespace kadr::nc {

/// The name of a hole as dialect files write it, without braces.
std::string_view name_of(StatementToken::Hole hole);
/// The hole of this name; nothing: there is none.
std::optional<StatementToken::Hole> hole_named(std::string_view name);

/// The holes of a statement as the manual shows them: "`{condition}` `{jump}` or `{statement}`";
/// those that it may do without with a question mark, "`{loop?}`". Empty: it has none.
std::string shown_holes(Statement statement);

/// What is wrong with the holes of a pattern, as half a sentence; empty: they are those that the
/// statement executes. A hole of another statement would be read and then forgotten.
std::string fault_of_holes(const StatementForm& form);

}  // namespace kadr::nc
