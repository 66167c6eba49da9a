// cycle_codes.h — codes that are several cycles.
//
// On some controls one code is two cycles, as G84 of a FANUC: with Q it taps in strokes. The stroke
// is modal, so it may be programmed in another block than the code.
#pragma once

#include <optional>

#include "nc/dialect.h"

namespace kadr::nc {

/// The cycle that the same code calls beside a stroke; none: this cycle has strokes itself, or no
/// form of its code takes one.
std::optional<CycleId> cycle_with_strokes(const Dialect& dialect, CycleId cycle);

}  // namespace kadr::nc
