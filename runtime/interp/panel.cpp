// panel.cpp — what the program takes from the operator's panel.
// source: FANUC reference 3.2 (G63), 6.5 (#3004)
#include "interp/executor.h"

namespace kadr::interp {

using path::Op;
using Write = ControlState::Write;

namespace {

// #3004, as a sum.
constexpr int kHold = 1;
constexpr int kOverride = 2;
constexpr int kExactStop = 4;

}  // namespace

Write Executor::suppress_panel(double value) {
    constexpr double kAll = kHold + kOverride + kExactStop;
    if (!(value >= 0 && value <= kAll)) return Write::NoPlace;
    const int bits = static_cast<int>(value);
    panel_.has_hold = (bits & kHold) == 0;
    panel_.has_override = (bits & kOverride) == 0;
    panel_.has_exact_stop = (bits & kExactStop) == 0;
    return Write::Done;
}

double Executor::suppressed_panel() const {
    return (panel_.has_hold ? 0 : kHold) + (panel_.has_override ? 0 : kOverride) +
           (panel_.has_exact_stop ? 0 : kExactStop);
}

/// Whether a motion ends at rest: by what is modal, or by a word of its block alone.
bool Executor::stops_exactly(bool once) const {
    return panel_.has_exact_stop && (modal_.has_exact_stop || once);
}

/// What of the panel acts on a command.
void Executor::put_panel(path::Command& command) const {
    const bool is_motion = path::is_motion(command.op);
    const bool is_feed = is_motion && command.op != Op::Rapid;
    const bool is_tap = is_feed && cycle_blocks_ && cycle_taps_;
    command.keeps_feed = is_tap || (is_feed && (modal_.taps || !panel_.has_override));
    command.ignores_hold = is_tap || (is_motion && (modal_.taps || !panel_.has_hold));
}

}  // namespace kadr::interp
