// cutters.h — the cutter for which a cycle of the program is worked out, and the one that the
// machine has under the number of the tool that is in.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "machine/machine.h"
#include "sema/code.h"

namespace kadr::expand {

/// A size of the tool that a call of the library gives, and another one of the machine's table.
struct CutterMismatch {
    std::string_view parameter;  // `tool_d`, a diameter, or `nose`, a radius
    double said = 0;             // mm
    double own = 0;              // mm, of the machine's tool
};

/// Whether a parameter of the cycle is the size of its tool.
bool has_cutter(const sema::FunctionCode& cycle);

/// The first size that is not the tool's. Nothing where the machine has no radius of the tool: it
/// reports nothing then.
///
/// registers  of the call, with its arguments
std::optional<CutterMismatch> cutter_mismatch(const sema::FunctionCode& cycle,
                                              const sema::Slot* registers,
                                              const machine::Machine& machine, std::int64_t tool);

}  // namespace kadr::expand
