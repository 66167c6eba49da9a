// standing.h — where the machine stands, and where a command leads from there.
//
// Positions of the tool tip in the base coordinate system; the axes carry it at the tool's length.
// Under a transformation the tip is in the workpiece system, and the chain has the axes' positions;
// or it is in virtual coordinates (path/virtual_axes.h).
// Geometry only: no limits (axis_check.h), no feeds and no corners (prepare.h).
#pragma once

#include <array>

#include "machine/machine.h"
#include "motion/axis_table.h"
#include "motion/segment.h"
#include "path/command.h"

namespace kadr::motion {

/// A billionth of a millimetre or degree is the rounding of frames, not motion.
inline constexpr double kStill = 1e-9;

class AxesPosition {
  public:
    /// At the reference points of the axes, without tool.
    explicit AxesPosition(const machine::Machine& machine);

    struct MotionEnd {
        path::Vec3 tip;
        std::array<double, kFollowers> followers;  // rad or mm
    };
    /// Goes over to the system in which the motion has its target, transformed or not; the axes
    /// stay where they are. True if it is another one.
    bool follow_transformation(const path::Motion& motion);
    MotionEnd target_of(const path::Motion& motion) const;

    /// The path of a Rapid, Line or Arc to its target as geometry. Returns the length of the path
    /// in mm, or in degrees if only rotary axes move (`segment.is_rotary_only`); 0 if nothing
    /// moves.
    double lay_path(const path::Motion& motion, const MotionEnd& target, Segment& segment) const;

    /// A segment in which the machine stands here, for the caller to complete.
    Segment still() const;

    void arrive(const path::Motion& motion, const MotionEnd& target);

    /// Another tool length acts. The axes stay where they are; what changes is the point of the
    /// tool that they carry.
    void set_tool_length(const path::ToolLength& length, const AxisTable& axes);

    const path::Vec3& tip() const { return tip_; }
    const std::array<double, kFollowers>& followers() const { return followers_; }
    /// From the tip to what the linear axes carry, mm; without a transformation.
    const path::Vec3& held() const { return held_; }

  private:
    path::Vec3 carrier() const { return carrier_at({tip_, followers_}); }
    path::Vec3 carrier_at(const MotionEnd& target) const;
    double virtual_angle() const;
    void put_carrier(const path::Vec3& carrier);
    void lay_straight(const MotionEnd& target, Segment& segment) const;
    void lay_orientation(const path::Motion& motion, double& length, Segment& segment) const;
    void lay_followers(const MotionEnd& target, double& length, Segment& segment) const;

    const machine::Chain* chain_ = nullptr;  // null if the machine has no transformation
    bool is_transformed_ = false;
    path::VirtualAxes virtual_;  // in which the tip is given, if they are on
    path::Vec3 tip_ = path::Vec3::Zero();
    std::array<double, kFollowers> followers_{};
    path::Vec3 tool_ = path::Vec3::UnitZ();  // from tip to holder
    path::Vec3 held_ = path::Vec3::Zero();   // from the tip to what the linear axes carry
    AxisValues last_to_{};                   // `to` of the last motion command, as it stood there
};

}  // namespace kadr::motion
