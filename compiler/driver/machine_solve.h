// machine_solve.h — `kadr machine solve`: where the tool of a machine stands, and which axes put it
// there.
#pragma once

#include <string>

#include "driver/session.h"
#include "driver/tables.h"

namespace kadr::driver {

/// What was asked, as it stands on the command line; empty: not given.
struct SolveJob {
    std::string machine;  // a name or a file
    std::string axes;     // "X1 Y2 Z3 A30 C45": where they stand; forward kinematics
    std::string at;       // "X0,Y0,Z100": the tip; inverse kinematics
    std::string tool;     // "0,0.5,0.866": direction from tip to holder
    std::string euler;  // "30,45,0": rotations about Z, Y', Z'', degrees; instead of the direction
    std::string from;   // "A0,C0": where the rotary axes come from
    double length = 0;  // mm, of the tool
    bool follows_vector = false;  // the block is one with a great circle
    bool as_json = false;
};

/// Tip and direction for positions of the axes, or every configuration of the axes for tip and
/// direction, those out of limits named, with the one that the machine's path choice would take.
Reply solve_machine(Session& session, const SolveJob& job);

}  // namespace kadr::driver
