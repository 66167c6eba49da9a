// cutter_path.h — the cutter's path beside a contour, as commands that are settled.
//
// What runs beside which element is known before: here it becomes commands, with the other axes,
// feed and orientation that they inherit from the programmed motion.
#pragma once

#include <vector>

#include "interp/compensated_orientation.h"
#include "interp/compensation_paths.h"
#include "interp/compensation_plane.h"
#include "nc/rules.h"
#include "path/command.h"
#include "path/radius_comp.h"

namespace kadr::interp {

/// A motion as it is programmed, in the system of the plane.
struct CutterMotion {
    path::Command command;
    double radius = 0;          // of an arc as programmed, mm
    bool is_departure = false;  // ends where it is programmed
    nc::CompFeed feed = nc::CompFeed::Contour;
};

/// Owns where the cutter is. Positions and points are in the system of the plane, mm and deg.
class CutterPath {
  public:
    /// In another plane, or in the same one anew.
    ///
    /// position, programmed  as of `stand_at`
    void begin(const CompPlane& plane, const AxisValues& position, const AxisValues& programmed);
    void set_orientation_limits(const OrientationLimits& limits) { orientation_limits_ = limits; }

    const CompPlane& plane() const { return plane_; }
    /// Where the cutter is: the end of the last command that was settled …
    const AxisValues& position() const { return position_; }
    path::Vec2 point() const { return plane_.point(position_); }
    /// … and how far that is from where the command was programmed to end.
    path::Vec2 beside() const { return point() - plane_.point(programmed_); }
    /// The command, as far beside as the cutter is.
    path::Command as_far_beside(path::Command command) const;

    /// Where the last command was programmed to end.
    void set_programmed(const AxisValues& programmed) { programmed_ = programmed; }
    /// The cutter has come to a position on another path.
    void stand_at(const AxisValues& position, const AxisValues& programmed);

    /// A command that does not concern the cutter's path.
    void pass(path::Command command) { settled_.push_back(std::move(command)); }
    /// A command without motion in the plane: where the cutter stands now.
    void put_standing(path::Command command);
    /// What runs beside an element of the contour, or is inserted in front of it.
    void put_piece(const CutterMotion& motion, const path::CompPiece& piece);
    /// The motion, by a line to a point.
    void put_line(const CutterMotion& motion, const path::Vec2& to);
    /// The motion, on a curve to a point.
    void put_curve(const CutterMotion& motion, const path::Vec2& to, const EndCurve& curve);
    /// The motion as it is, beside what was programmed to end at another position.
    void put_beside(path::Command command, const AxisValues& programmed_to);
    /// With the feed and the text location of the motion; the other axes stand.
    void insert_line(const CutterMotion& motion, const path::Vec2& to);
    void insert_arc(const CutterMotion& motion, const path::Element& arc);

    /// Commands of the base system, in order. The caller clears them.
    std::vector<path::Command>& settled() { return settled_; }
    /// Whether, since it was asked last, a command was left out as the rotary axes cannot orient
    /// the tool on the path beside the contour.
    [[nodiscard]] bool take_orientation_fault();

  private:
    void put(path::Command command);
    void put_moving(path::Command command, const AxisValues& programmed_to);
    void put_arc(const CutterMotion& motion, const path::Element& arc);
    void insert_conic(const CutterMotion& motion, const path::CompPiece& piece);
    void insert_tangents(const CutterMotion& motion, const path::Element& arc);
    path::Command standing(const CutterMotion& motion) const;
    void stand_tool(path::Motion& inserted) const;
    void orient_along_arc(const CutterMotion& motion, const path::Element& arc,
                          path::Motion& beside) const;
    path::Vec3 beside_center(const path::Element& arc, double scale, const AxisValues& at) const;

    CompPlane plane_;
    OrientationLimits orientation_limits_;
    AxisValues position_{};
    AxisValues programmed_{};  // end of the last command that was settled
    bool cannot_orient_ = false;
    std::vector<path::Command> settled_;
};

}  // namespace kadr::interp
