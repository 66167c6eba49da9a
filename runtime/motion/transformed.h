// transformed.h — pieces on whose path the machine's transformation holds the tip of the tool.
//
// The tip goes along the curve, the orientation changes, and the chain of the machine tells where
// every axis stands for it; exactly, at any distance (motion.md §5). What limits and corners need,
// the derivatives of the axes by the path, comes from a polynomial through five points of a short
// piece.
#pragma once

#include <array>
#include <vector>

#include "machine/following.h"
#include "machine/kinematics.h"
#include "motion/segment.h"

namespace kadr::motion {

/// One value per logical axis; mm and rad.
using LogicalAxes = std::array<double, kAxes>;

using machine::is_at_pole;
using machine::joints_for;

/// Whether the tool's direction is given along the piece, and the rotary axes follow it.
inline bool gives_direction(const path::OrientLaw& orientation) {
    return orientation.kind > path::OrientKind::Axes;
}

/// Where the joints of the chain stand, as followers of a piece have it, and the other way round.
path::Vec3 joints_of(const machine::Chain& chain, const std::array<double, kFollowers>& followers);
void put_joints(const machine::Chain& chain, const path::Vec3& rotary,
                std::array<double, kFollowers>& followers);

/// The piece as it stands at a distance: without path and without orientation.
Segment standing_at(const Segment& piece, double distance);

/// Where all axes stand at a distance along a piece. A piece on which the orientation takes a path
/// of its own must be as short as even_parts() makes it.
LogicalAxes axes_at(const machine::Chain& chain, const Segment& piece, double distance);

/// … and where the tip is: on its path, or beside it where the cutter touches there; and the
/// direction of the tool, from tip to holder. In the workpiece system.
struct ToolPose {
    LogicalAxes axes{};
    path::Vec3 tip = path::Vec3::Zero();
    path::Vec3 tool = path::Vec3::UnitZ();
};
/// The same, gone on to from axes that stand somewhere near on the piece.
LogicalAxes axes_near(const machine::Chain& chain, const Segment& piece, double distance,
                      const LogicalAxes& near);
/// Where the axes stand where the piece begins; the linear ones are 0.
LogicalAxes start_of(const Segment& piece);

/// point  of the curve of the piece at that distance; the piece may also be one from point to point
ToolPose pose_at(const machine::Chain& chain, const Segment& piece, double distance,
                 const path::Vec3& point);

/// The path of the tip from point to point as lines, for those who draw and measure it: one for
/// every few degrees of orientation. What follows the path is shared out evenly.
///
/// piece  goes_straight()
std::vector<Segment> tip_lines(const machine::Chain& chain, const Segment& piece);

/// Where the tip is for these axes; Segment::carrier gives how the tool is carried at base.
path::Vec3 tip_at(const machine::Chain& chain, const LogicalAxes& axes, const path::Vec3& carrier);

/// Positions of the axes over a piece as polynomials of the fourth degree in u = s / length, 0 … 1.
class AxisPolynomials {
  public:
    AxisPolynomials(const machine::Chain& chain, const Segment& piece);

    double length() const { return length_; }
    double position(std::size_t axis, double u) const;
    double rate(std::size_t axis, double u) const;   // dq/ds
    double bend(std::size_t axis, double u) const;   // d²q/ds²
    double third(std::size_t axis, double u) const;  // d³q/ds³

  private:
    static constexpr std::size_t kNodes = 5;
    std::array<std::array<double, kNodes>, kAxes> coefficients_{};
    double length_ = 1;
};

/// Limits of the logical axes, for deciding what is even; infinite where the machine has none.
struct AxisBounds {
    LogicalAxes velocity{};
    LogicalAxes acceleration{};
    LogicalAxes jerk{};
};

struct PartWishes {
    double speed = 0;       // along the path, may be infinite
    double time = 0;        // s; a part that takes less may be uneven
    bool as_cells = false;  // the parts are to be cells (transformed_cells.h)
};

/// A piece as parts, in order, so that one speed suits each of them, or that each is a cell, and
/// its AxisPolynomials is exact to far below a thousandth of a millimetre. `follower_start` of each
/// is where the one before it ends.
std::vector<Segment> even_parts(const machine::Chain& chain, const Segment& whole,
                                const AxisBounds& bounds, const PartWishes& wishes);

}  // namespace kadr::motion
