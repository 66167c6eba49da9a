// cycle_strokes.h — a modal cycle whose code does something else when a stroke is kept for it.
//
// On some controls one code is two cycles, as G84 of a FANUC: with Q it taps in strokes. The stroke
// is modal, so it may be programmed in a later block than the code.
#pragma once

#include <optional>

#include "interp/state.h"
#include "nc/dialect.h"

namespace kadr::interp {

/// The same call for the cycle that the same code calls beside a stroke; none: this cycle has
/// strokes itself, or no form of its code takes one. Arguments go over by their names.
std::optional<ModalCycle> call_in_strokes(const nc::Dialect& dialect, const ModalCycle& call);

}  // namespace kadr::interp
