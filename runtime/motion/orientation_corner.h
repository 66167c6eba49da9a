// orientation_corner.h — the curve around a corner of motions that change the orientation.
//
// Under the transformation of the machine a corner is a corner of the tip, of the orientation of
// the tool, or of both: where a great circle goes over into another one the tip may go straight
// on, and yet the rotary axes have another speed at once. Tip and rotary axes are led around it on
// one and the same part of the path (path/transition.h).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "motion/corner_blend.h"
#include "motion/transformed.h"

namespace kadr::motion {

/// The path of the axes on a motion of any length, found once from its start.
class OrientationPath {
  public:
    /// chain, whole  have to live as long
    OrientationPath(const machine::Chain& chain, const Segment& whole);

    /// Where the rotary axes are, rad, and how they go on, per mm and per mm² of the path.
    path::CurvePoint joints(double distance) const;
    /// Direction of the tool there, from tip to holder.
    path::Vec3 tool(double distance) const;
    /// A part of the motion, which begins where the axes are then.
    Segment part(double from, double to) const;
    LogicalAxes end() const { return nodes_.back().axes; }
    const Segment& whole() const { return *whole_; }

  private:
    struct Node {
        double distance = 0;
        LogicalAxes axes{};
    };
    LogicalAxes axes(double distance) const;
    path::Vec3 joints_at(double distance) const;

    const machine::Chain* chain_;
    const Segment* whole_;
    std::vector<Node> nodes_;
};

struct OrientationBlend {
    double distance = 0;            // mm of the path on either side of the corner
    std::array<Segment, 4> pieces;  // two before the middle, two behind it
};

/// As rounding(), and with a tool whose direction is not farther from the programmed one than
/// `orientation` of the blending before the corner.
///
/// returns   nothing if neither tip nor rotary axes have a corner, if the tip turns back, or if
///           no distance is left
std::optional<OrientationBlend> orientation_blend(const machine::Chain& chain,
                                                  const OrientationPath& before,
                                                  const path::Blending& wish,
                                                  const OrientationPath& behind,
                                                  const path::Blending& wish_behind);

/// The tip stays on its path, corner or not, and the rotary axes alone are led around theirs: their
/// speed and how it changes go on along the path, on a distance as long as the tolerance allows.
///
/// tolerance  how far the tool may be from its programmed direction, rad
/// returns    nothing if the rotary axes have no corner, or if no distance is left
std::optional<OrientationBlend> smoothed_orientation(const machine::Chain& chain,
                                                     const OrientationPath& before,
                                                     const OrientationPath& behind,
                                                     double tolerance);

}  // namespace kadr::motion
