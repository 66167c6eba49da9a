#include "interp/cutter_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "machine/kinematics.h"
#include "path/linear.h"

namespace kadr::interp {

using path::Command;
using path::CompPiece;
using path::Element;
using path::linear;
using path::Op;
using path::Vec2;
using std::numbers::pi;

namespace {

bool is_same(const AxisValues& a, const AxisValues& b) {
    for (std::size_t i = 0; i < kAxes; ++i) {
        if (std::abs(a[i] - b[i]) > path::kSamePoint) return false;
    }
    return true;
}

}  // namespace

void CutterPath::begin(const CompPlane& plane, const AxisValues& position,
                       const AxisValues& programmed) {
    plane_ = plane;
    stand_at(position, programmed);
}

void CutterPath::stand_at(const AxisValues& position, const AxisValues& programmed) {
    position_ = position;
    programmed_ = programmed;
}

Command CutterPath::as_far_beside(Command command) const {
    if (command.is_motion()) plane_.shift(command.motion(), beside());
    return command;
}

bool CutterPath::take_orientation_fault() { return std::exchange(cannot_orient_, false); }

// ------------------------------------------------------------------------------ of the contour

void CutterPath::put_piece(const CutterMotion& motion, const CompPiece& piece) {
    const Element& element = piece.element;
    if (piece.weight > 0) return insert_conic(motion, piece);
    if (!element.is_arc()) {
        if (piece.is_inserted) insert_line(motion, element.to);
        else
            put_line(motion,
                     motion.is_departure ? plane_.point(motion.command.motion().to) : element.to);
    } else {
        const bool is_gap = (point() - element.from).norm() > path::kSamePoint;
        if (is_gap) insert_line(motion, element.from);
        if (motion.command.op() == Op::Rapid) insert_tangents(motion, element);
        else if (piece.is_inserted) insert_arc(motion, element);
        else put_arc(motion, element);
    }
    if (!piece.is_inserted) programmed_ = motion.command.motion().to;
}

void CutterPath::put_standing(Command command) {
    if (!command.is_motion()) return pass(std::move(command));
    const AxisValues to = command.motion().to;
    plane_.set_point(command.motion().to, point());
    put_beside(std::move(command), to);
    programmed_ = to;
}

void CutterPath::put_line(const CutterMotion& motion, const Vec2& to) {
    Command command = motion.command;
    if (command.op() == Op::Arc) command.become(Op::Line);
    plane_.set_point(command.motion().to, to);
    put_moving(std::move(command), motion.command.motion().to);
}

void CutterPath::put_arc(const CutterMotion& motion, const Element& arc) {
    Command command = motion.command;
    const double radius = path::radius(arc);
    const bool is_slower = motion.feed == nc::CompFeed::Contour ||
                           (motion.feed == nc::CompFeed::Inside && radius < motion.radius);
    if (motion.radius > 0 && is_slower) command.motion().feed *= radius / motion.radius;
    plane_.go_along(arc, command.motion());
    orient_along_arc(motion, arc, command.motion());
    put(std::move(command));
}

/// The other axes come to rest at the contour: on the path to it at its end, on the path from it
/// they begin so.
void CutterPath::put_curve(const CutterMotion& motion, const Vec2& to, const EndCurve& curve) {
    Command command = motion.command;
    plane_.set_point(command.motion().to, to);
    AxisValues inner = curve.leads_in ? command.motion().to : position_;
    command.become(Op::Spline);
    path::SplineShape& spline = command.motion().spline();
    spline.weights = {1, 1, 1, 1};
    spline.degree = curve.degree;
    for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(curve.degree); ++i) {
        plane_.set_point(inner, curve.inner[i]);
        spline.inner[i] = linear(inner);
    }
    put_beside(std::move(command), motion.command.motion().to);
}

// ------------------------------------------------------------------------------ at corners

/// A copy of the motion's command that goes nowhere yet.
Command CutterPath::standing(const CutterMotion& motion) const {
    Command command = motion.command;
    command.motion().to = position_;
    command.motion().exact_stop = false;
    stand_tool(command.motion());
    return command;
}

void CutterPath::insert_line(const CutterMotion& motion, const Vec2& to) {
    Command command = standing(motion);
    if (command.op() == Op::Arc) command.become(Op::Line);
    plane_.set_point(command.motion().to, to);
    put_moving(std::move(command), motion.command.motion().to);
}

void CutterPath::insert_arc(const CutterMotion& motion, const Element& arc) {
    Command command = standing(motion);
    path::ArcShape about;
    about.center = linear(position_);
    command.motion().shape = about;
    plane_.go_along(arc, command.motion());
    put(std::move(command));
}

/// The arc about a corner that has been made more pointed; at rapid the tangents at its ends and at
/// its middle.
void CutterPath::insert_conic(const CutterMotion& motion, const CompPiece& piece) {
    const Vec2& to = piece.element.to;
    if (motion.command.op() == Op::Rapid) {
        const double sum = 1 + piece.weight;
        insert_line(motion, (piece.element.from + piece.weight * piece.apex) / sum);
        insert_line(motion, (to + piece.weight * piece.apex) / sum);
        return insert_line(motion, to);
    }
    Command command = standing(motion);
    command.become(Op::Spline);
    AxisValues apex = position_;
    plane_.set_point(apex, piece.apex);
    path::SplineShape& spline = command.motion().spline();
    spline.degree = 2;
    spline.inner[0] = linear(apex);
    spline.weights = {1, piece.weight, 1, 1};
    plane_.set_point(command.motion().to, to);
    put(std::move(command));
}

/// At rapid there are no arcs: around a corner by lines that touch the arc.
void CutterPath::insert_tangents(const CutterMotion& motion, const Element& arc) {
    const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(arc.sweep) / (pi / 2))));
    const double half = arc.sweep / parts / 2;
    Vec2 arm = arc.from - arc.center;
    for (int i = 0; i < parts; ++i) {
        const Vec2 corner = Eigen::Rotation2D(half) * arm / std::cos(half);
        insert_line(motion, arc.center + corner);
        arm = Eigen::Rotation2D(2 * half) * arm;
    }
    insert_line(motion, arc.to);
}

// ------------------------------------------------------------------------------ the tool

/// The tool that is led by a second point of its axis keeps its direction on an arc beside the
/// programmed one: about the same centre, of which corners have left a part.
void CutterPath::orient_along_arc(const CutterMotion& motion, const Element& arc,
                                  path::Motion& beside) const {
    if (beside.orient_kind != path::OrientKind::Point) return;
    const double radius = path::radius(arc);
    const double scale = radius > path::kSamePoint ? motion.radius / radius : 0;
    shift_point({linear(programmed_), linear(motion.command.motion().to),
                 beside_center(arc, scale, position_), beside_center(arc, scale, beside.to)},
                beside);
    beside.orient_details->outwards = motion.radius - radius;
}

/// A position on the path beside an arc as it lies on the programmed one.
path::Vec3 CutterPath::beside_center(const Element& arc, double scale, const AxisValues& at) const {
    AxisValues position = at;
    plane_.set_point(position, arc.center + scale * (plane_.point(at) - arc.center));
    return linear(position);
}

/// What a corner inserts the tool passes as it stands.
void CutterPath::stand_tool(path::Motion& inserted) const {
    if (orientation_limits_.chain == nullptr || inserted.orient_kind == path::OrientKind::None)
        return;
    const machine::Chain& chain = *orientation_limits_.chain;
    inserted.orient_plainly(path::OrientKind::Axes);
    inserted.direction =
        plane_.lie().transpose() * machine::tool_vector(chain, joints_at(chain, position_));
}

// ------------------------------------------------------------------------------ out

/// What nothing is left of is no block: an exact stop has its corner.
void CutterPath::put_moving(Command command, const AxisValues& programmed_to) {
    if (!is_same(command.motion().to, position_)) put_beside(std::move(command), programmed_to);
}

/// … that is no arc: from where the last one was programmed to end.
void CutterPath::put_beside(Command command, const AxisValues& programmed_to) {
    shift_point({linear(programmed_), linear(programmed_to), linear(position_),
                 linear(command.motion().to)},
                command.motion());
    put(std::move(command));
}

void CutterPath::put(Command command) {
    path::Motion& motion = command.motion();
    motion.moved = static_cast<AxisMask>(motion.moved | plane_.mask());
    const AxisValues from = plane_.out_of(std::exchange(position_, motion.to));
    if (!put_oriented(orientation_limits_, from, plane_.out_of(std::move(command)), settled_))
        cannot_orient_ = true;
}

}  // namespace kadr::interp
