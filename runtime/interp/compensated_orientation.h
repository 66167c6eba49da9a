// compensated_orientation.h — tool orientation on a path that a cutter compensation has laid
// beside the one that is programmed, under the machine's transformation.
//
// The control shares the change of orientation in a block out over its path (S 7.4: u is the path
// fraction), so that beside the contour, too, a block begins and ends with the tool that the
// program gives it. Where the path gives the orientation, it does so on the path that is left.
#pragma once

#include <vector>

#include "machine/chain.h"
#include "machine/path_choice.h"
#include "path/command.h"
#include "path/orient_law.h"

namespace kadr::interp {

/// What orients the tool; without a chain nothing does.
struct OrientationLimits {
    const machine::Chain* chain = nullptr;
    machine::JointLimits limits;
};

/// R1, R2 and Ψ of the chain as the axes have them, rad.
path::Vec3 joints_at(const machine::Chain& chain, const AxisValues& axes);

/// The orientation along a path of this length, mm, that begins with the tool so.
path::OrientLaw orient_law_of(const path::Motion& motion, const path::Vec3& from_tool,
                              double length);

/// The ends of a path: as it is programmed, and beside that; mm.
struct CompensatedEnds {
    path::Vec3 from = path::Vec3::Zero();
    path::Vec3 to = path::Vec3::Zero();
    path::Vec3 from_beside = path::Vec3::Zero();
    path::Vec3 to_beside = path::Vec3::Zero();
};

/// The second point of the tool's axis goes aside with the tip, so that the tool keeps its
/// direction at both ends. Other orientations stay what they are.
void shift_point(const CompensatedEnds& ends, path::Motion& motion);

/// A command beside the contour, behind `settled`; before it and behind it changes of orientation
/// while the tip stands, if its path would need other orientations at its ends than are programmed.
///
/// from     where the axes are
/// returns  false if the rotary axes cannot follow; then nothing is put out
bool put_oriented(const OrientationLimits& orientation_limits, const AxisValues& from,
                  path::Command command, std::vector<path::Command>& settled);

}  // namespace kadr::interp
