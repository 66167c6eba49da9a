// word_hints.h — words of a program as a message shows them, and what was meant by them. Internal
// to interp.
#pragma once

#include <string>

#include "base/axes.h"
#include "nc/block.h"
#include "nc/reader.h"
#include "nc/tables.h"

namespace kadr::interp {

/// A number as it stands in a word of a control that wants its point: `2.`, `-0.4`.
std::string with_point(double value);

/// "a chamfer is `,C0.4`, with a comma", of a word of an axis whose letter means something else
/// behind a comma; empty: it does not.
std::string hint_at_comma(const nc::DialectTables& tables, Axis axis, double value);

/// What the dialect notes about a code of a cycle that has no word of the cycle beside it: in
/// another system of G codes it may be something else, and was meant so. Empty: nothing.
///
/// caller  the block with the code
std::string hint_at_bare_cycle(const nc::DialectTables& tables, const nc::BlockLocations* locations,
                               const nc::Block& caller);

}  // namespace kadr::interp
