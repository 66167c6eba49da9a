// kept_state.h — what blocks change besides the geometry that is wanted of them. Internal to
// interp.
#pragma once

#include "base/axes.h"
#include "interp/state.h"
#include "path/command.h"

namespace kadr::interp {

/// As blocks found it whose motions are not executed; it is taken back behind them. Modal codes
/// stay what the blocks of a table have programmed (unsure).
struct KeptState {
    Position position;
    ProgrammedSpindle spindle;
    Tool tool;
    AxisValues length_shift{};
    path::CoolantMode coolant = path::CoolantMode::Off;
};

}  // namespace kadr::interp
