#include "control/cycle_levels.h"

namespace kadr::control {

CycleLevel cycle_depth(const nc::Rules& rules, double value, bool is_incremental) {
    return {value, true, rules.cycle_levels_incremental && is_incremental};
}

CycleLevel cycle_retract(const nc::Rules& rules, double value, bool is_incremental) {
    CycleLevel level = cycle_depth(rules, value, is_incremental);
    level.is_distance |= rules.cycle_retract_distance;
    return level;
}

std::optional<CallLevels> complete_levels(const nc::Rules& rules, CycleLevels programmed,
                                          bool is_incremental, std::optional<double> initial,
                                          bool goes_low) {
    if (!programmed.retract.is_given) programmed.retract = cycle_retract(rules, 0, is_incremental);
    if (!programmed.depth.is_given) programmed.depth = cycle_depth(rules, 0, is_incremental);
    if (programmed.retract.is_distance && !initial) return std::nullopt;
    const auto level = [](const CycleLevel& of, double from) {
        return of.is_distance ? from + of.value : of.value;
    };
    CallLevels call;
    call.retract = level(programmed.retract, initial.value_or(0));
    call.depth = level(programmed.depth, call.retract);
    const bool stays_low = goes_low && call.retract > call.depth;
    if (!stays_low && !initial) return std::nullopt;
    call.back = stays_low ? call.retract : *initial;
    return call;
}

}  // namespace kadr::control
