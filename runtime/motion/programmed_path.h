// programmed_path.h — one motion as it is programmed, for those who judge where the tip is.
//
// Geometry of a command: where on its path the tip is nearest, and what tool and axes should be
// there. Which motion a setpoint belongs to is path_check.h's question.
#pragma once

#include <vector>

#include "machine/machine.h"
#include "motion/pipeline.h"
#include "motion/segment.h"

namespace kadr::motion {

/// A motion, whole, and what may be missing of it.
struct ProgrammedMotion {
    Segment segment;            // without times
    double length = 0;          // of its path, mm (deg)
    double tolerance = 0;       // mm, of the tip
    double inclination = 0;     // rad, of the tool
    double pole = 0;            // rad, the path may be led otherwise so near to a pole
    std::vector<double> turns;  // parameters at which it turns back on itself, or nearly, in order
    /// Motions with the same number give the tip in the same coordinates of the same tool.
    std::uint32_t system = 0;
};

/// Where a setpoint is, by its axes.
struct StandingTool {
    path::Vec3 tip = path::Vec3::Zero();
    path::Vec3 tool = path::Vec3::UnitZ();  // under a transformation
    std::array<double, kFollowers> followers{};
};

/// The tip in the coordinates of a motion, by the axes of the machine. An axis that the machine
/// does not have stands where the setpoint has it that its tip is.
StandingTool standing_tool(const machine::Machine& machine, const machine::Chain& chain,
                           const ProgrammedMotion& motion, const Setpoint& setpoint);

/// How far a tool is from a motion.
struct Nearness {
    double parameter = 0;    // along the motion, in its own parameter
    double distance = 0;     // of the tip from the path, mm
    double inclination = 0;  // of the tool from its direction there, rad
    double off = 0;          // of an axis that follows, rad or mm
    /// What the last two may be: where the tip may be beside its path, it also may be behind.
    double direction_tolerance = 0;
    double off_allowed = 0;
};

/// Where a point is looked for: from this one on, along so many mm.
struct SearchRange {
    double from = 0;
    double ahead = 0;
};

/// Beside which point of the motion a tool is, not much before the reach, and how far from it. The
/// point is that nearest to the tip in the neighbourhood of the beginning; where the motion turns
/// back within the reach, the first one on which the tip can be. Of a motion that only changes the
/// orientation it is the one with the nearest direction.
Nearness nearest_on(const machine::Chain& chain, const ProgrammedMotion& motion,
                    const StandingTool& tool, const SearchRange& reach);

/// The same, looked for from the end of the reach back.
Nearness nearest_from_behind(const machine::Chain& chain, const ProgrammedMotion& motion,
                             const StandingTool& tool, const SearchRange& reach);

/// The same, looked for along all of the reach; of arcs along all that is left.
Nearness nearest_on_rest(const machine::Chain& chain, const ProgrammedMotion& motion,
                         const StandingTool& tool, const SearchRange& reach);

/// How far along a motion a parameter is, mm; 0 where its tip does not move.
double distance_to(const ProgrammedMotion& motion, double parameter);

/// Finds where a motion turns back.
void find_turns(ProgrammedMotion& motion);

/// Where the tip is when the motion ends.
path::Vec3 end_of(const machine::Chain& chain, const ProgrammedMotion& motion);

}  // namespace kadr::motion
