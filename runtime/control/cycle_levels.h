// cycle_levels.h — the levels of a modal cycle, as its words give them from hole to hole.
//
// Source: F 5.1 (R and Z under G91 are distances), 5.4 (R of a lathe's cycles is one always).
#pragma once

#include <optional>

#include "nc/rules.h"

namespace kadr::control {

/// As a word gives it, mm along the tool axis.
struct CycleLevel {
    double value = 0;
    bool is_given = false;
    bool is_distance = false;
};

/// How a word of a level is understood while these dimensions act.
CycleLevel cycle_depth(const nc::Rules& rules, double value, bool is_incremental);
CycleLevel cycle_retract(const nc::Rules& rules, double value, bool is_incremental);

/// What has been programmed; it holds for every further cycle until the mode ends.
struct CycleLevels {
    CycleLevel depth;    // a distance counts from the retract level
    CycleLevel retract;  // a distance counts from the level where the mode began
};

/// The levels of one call, coordinates of the tool axis, mm.
struct CallLevels {
    double depth = 0;
    double retract = 0;
    double back = 0;  // where the tool goes behind it
};

/// is_incremental  the dimensions where the cycle is called: a level that nobody programmed is 0,
///                 or no distance
/// initial         level where the mode began; nothing: not known
/// goes_low        back to the retract level only. One that lies under the bottom, as of boring
///                 from below, is no level to come back to
///
/// Nothing if a level depends on one that is not known.
std::optional<CallLevels> complete_levels(const nc::Rules& rules, CycleLevels programmed,
                                          bool is_incremental, std::optional<double> initial,
                                          bool goes_low);

}  // namespace kadr::control
