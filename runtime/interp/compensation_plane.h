// compensation_plane.h — the plane in which a contour is compensated: what commands give in it, and
// how it lies in the base system.
//
// Geometry alone: nothing here knows of cutters and corners.
#pragma once

#include "base/axes.h"
#include "path/command.h"
#include "path/contour.h"
#include "path/frame.h"

namespace kadr::interp {

/// A working plane that may be tilted against the base system. Positions in its own system have the
/// plane's two axes and the axis square to them under the names of the base system.
class CompPlane {
  public:
    CompPlane() = default;
    /// lie  turns the plane, where it is one of two axes, to where it lies in the base system
    CompPlane(path::Plane plane, const path::Mat3& lie);

    path::Plane plane() const { return plane_; }
    const path::Mat3& lie() const { return lie_; }
    const path::PlaneAxes& axes() const { return axes_; }
    /// Whether its own system is another one than the base system.
    bool is_tilted() const { return is_tilted_; }
    /// Its two axes.
    AxisMask mask() const { return static_cast<AxisMask>(bit(axes_.first) | bit(axes_.second)); }

    /// From the base system into that of the plane, and back. Of commands those that are no motion
    /// stay as they are.
    AxisValues into(const AxisValues& base) const;
    AxisValues out_of(const AxisValues& values) const;
    path::Command into(path::Command command) const;
    path::Command out_of(path::Command command) const;

    // What follows is in the system of the plane, mm.
    path::Vec2 point(const AxisValues& values) const;
    void set_point(AxisValues& values, const path::Vec2& at) const;
    void shift(AxisValues& values, const path::Vec2& by) const;
    /// The end of a motion, and the centre that it may have.
    void shift(path::Motion& motion, const path::Vec2& by) const;
    /// The path of a line or an arc that begins at a point.
    path::Element element_of(const path::Motion& motion, const path::Vec2& from) const;
    /// The motion goes along an arc, with the full turns that it has beside it.
    void go_along(const path::Element& arc, path::Motion& motion) const;

  private:
    void shift(path::Vec3& center, const path::Vec2& by) const;
    void set_center(path::Vec3& center, const path::Vec2& at) const;
    path::Vec2 in_plane(const path::Vec3& center) const;

    path::Plane plane_ = path::Plane::Xy;
    path::PlaneAxes axes_;
    path::Mat3 lie_ = path::Mat3::Identity();
    bool is_tilted_ = false;
};

}  // namespace kadr::interp
