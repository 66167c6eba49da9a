// compensation_3d_faces.cpp — the end of a cutter on a surface (S 5.3 CUT3DF, motion.md §8.3).
//
// The commands bring along how the surface lies: its normal where they begin and how that turns.
// Where the normal jumps from one command to the next, the surface has an edge: around one that
// stands out the cutter rolls, in a hollow one both paths end where the tips meet.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "base/diagnostics/iso.h"
#include "interp/compensation_3d_parts.h"
#include "path/orient_law.h"

namespace kadr::interp {

using path::Command;
using path::Contact;
using path::ContactKind;
using path::Op;
using path::set_linear;
using path::Vec3;
using std::numbers::pi;

namespace {

// Angle between a tool and a normal below which the surface lies square to the tool, rad.
constexpr double kSquare = 1e-6;
// Rounding of normals where a cutter's flank begins, rad.
constexpr double kInclinationRounding = 1e-6;
// What a cutter may take off beyond a hollow edge before that is one, and by how much tips may miss
// each other in it, mm.
constexpr double kGouge = 1e-4;
constexpr double kMiss = 1e-3;
// Of a path as splines, mm.
constexpr double kWayTolerance = 1e-6;
constexpr int kInclinations = 32;  // points of a path at which the tool is looked at
constexpr int kBends = 16;         // … and the surface

Contact part_of(const Contact& contact, double from, double to) {
    Contact part = contact;
    part.guide = path::guide_at(contact, from);
    part.turn *= to - from;
    return part;
}

}  // namespace

// ------------------------------------------------------------------------------ along a surface

Compensation3d::Fault Compensation3d::take_surface(const Contact& surface,
                                                   TouchedMotion& side) const {
    side.contact.guide = surface.guide;
    side.contact.axis = surface.axis;
    side.contact.turn = surface.turn;
    if (settings_.orientation_limits.chain == nullptr && side.turns()) return &diag::CompMotion;
    // At rapid only lines lead anywhere, and between their ends nobody holds the tip.
    if (settings_.orientation_limits.chain == nullptr && side.command.op() == Op::Rapid &&
        !keeps_kind(side))
        return &diag::CompMotion;
    return check(side);
}

/// Of the tool from the normal, rad.
double Compensation3d::inclination_on(const TouchedMotion& side, double share) const {
    return path::angle_between(guide_on(side, share), tool_on(side, share));
}

/// The share of what is left between two at which the tool is nearest to the normal, if there is
/// one such point.
double Compensation3d::least_inclination(const TouchedMotion& side, double from, double to) const {
    constexpr double kNarrow = 1e-10;
    const auto tilt = [&](double share) { return inclination_on(side, side.share_of_path(share)); };
    while (to - from > kNarrow) {
        const double third = (to - from) / 3;
        if (tilt(from + third) < tilt(to - third)) {
            to -= third;
        } else {
            from += third;
        }
    }
    return (from + to) / 2;
}

/// The edge reaches from the end face to where the flank begins. A surface that lies square to the
/// tool all along touches with its middle; one that comes to lie so on the path would have to
/// touch with its other side from there on.
Compensation3d::Fault Compensation3d::check_inclinations(TouchedMotion& side) const {
    std::array<double, kInclinations + 1> tilts;
    for (int i = 0; i <= kInclinations; ++i)
        tilts[static_cast<std::size_t>(i)] =
            inclination_on(side, side.share_of_path(static_cast<double>(i) / kInclinations));
    const auto [least, most] = std::ranges::minmax(tilts);
    if (most > pi / 2 - settings_.cutter.flank + kInclinationRounding) return &diag::CompFaceTilt;
    if (side.contact.radius == side.contact.depth) return nullptr;
    if (most < kSquare) {
        side.contact.radius = side.contact.depth;
        return nullptr;
    }
    if (most - least < kInclinationRounding) return nullptr;
    for (std::size_t i = 0; i <= kInclinations; ++i) {
        const bool is_lowest = (i == 0 || tilts[i] <= tilts[i - 1]) &&
                               (i == kInclinations || tilts[i] <= tilts[i + 1]);
        if (!is_lowest) continue;
        const double from = i == 0 ? 0 : static_cast<double>(i - 1) / kInclinations;
        const double to = i == kInclinations ? 1 : static_cast<double>(i + 1) / kInclinations;
        const double share = least_inclination(side, from, to);
        const bool is_inside = share > kSquare && share < 1 - kSquare;
        if (is_inside && inclination_on(side, side.share_of_path(share)) < kSquare)
            return &diag::CompFaceSquare;
    }
    return nullptr;
}

/// In a hollow that bends more than the cutter does its tip would go back: as the tool stands, the
/// tip's path has the direction of the path everywhere.
Compensation3d::Fault Compensation3d::check_bends(const TouchedMotion& side) const {
    if (side.contact.turn == 0) return nullptr;
    constexpr double kStep = 1e-5;
    for (int i = 0; i <= kBends; ++i) {
        const double parameter = std::clamp(static_cast<double>(i) / kBends, kStep, 1 - kStep);
        const double share = side.share_of_path(parameter);
        const Vec3 tangent = side.at(share).tangent;
        const Vec3 tool = tool_on(side, share);
        const auto before =
            path::tip_beside(side.contact, path::guide_at(side.contact, share - kStep), tool);
        const auto behind =
            path::tip_beside(side.contact, path::guide_at(side.contact, share + kStep), tool);
        if (!before || !behind) continue;
        const double distance = 2 * kStep * side.length();
        if (distance + (*behind - *before).dot(tangent) <= 0) return &diag::CompArcTooSmall;
    }
    return nullptr;
}

// ------------------------------------------------------------------------------ at edges

Compensation3d::Fault Compensation3d::join_surfaces(TouchedMotion& next) {
    const Corner corner{last_->at(1).position, last_->at(1).tangent, next.at(0).tangent,
                        last_->to_tool, next.from_tool};
    const Vec3 from = guide_on(*last_, 1);
    const Vec3 to = guide_on(next, 0);
    const double angle = path::angle_between(from, to);
    // A path that rises out of the surface before or behind it lies in a hollow.
    const double rise = std::max(corner.second.dot(from), -corner.first.dot(to));
    const Contact& cutter = settings_.cutter.contact;
    const bool is_hollow = rise > kSmooth && cutter.radius * (1 - std::cos(angle)) > kGouge;
    if (is_hollow) return join_hollow(next, corner);
    emit(*last_);
    Contact contact = standing(from);
    const bool turns = std::ranges::any_of(
        waiting_, [&](const Command& command) { return changes_orientation(command); });
    if (angle > kSmooth && turns && settings_.orients_on_arc) {
        const Vec3 across = from.cross(to);
        contact.axis = across.norm() > kSmooth ? Vec3(across.normalized()) : from.unitOrthogonal();
        contact.turn = angle;
        emit_waiting(contact, corner.point);
        return nullptr;
    }
    emit_waiting(contact, corner.point);
    if (angle > kSmooth) roll(next, from, corner.point);
    return nullptr;
}

/// Both paths end where the tips meet as the tool stands at the edge. In space they need not: then
/// no point of the cutter touches both surfaces on the path.
Compensation3d::Fault Compensation3d::join_hollow(TouchedMotion& next, const Corner& corner) {
    if (std::ranges::any_of(waiting_,
                            [&](const Command& command) { return changes_orientation(command); }))
        return &diag::CompTurnsInside;
    const Vec3 along = corner.second - corner.second.dot(corner.first) * corner.first;
    if (along.norm() < kSmooth) return &diag::CompFaceCorner;
    if (meet(*last_, next, {corner.first, along.normalized()}) != nullptr)
        return &diag::CompFaceCorner;
    const auto end = tip_on(*last_, last_->end);
    const auto begin = tip_on(next, next.begin);
    if (!end || !begin || (*end - *begin).norm() > kMiss) return &diag::CompFaceCorner;
    if (last_->end <= last_->begin || next.begin >= 1) return &diag::CompCollision;
    if (const Fault fault = check(*last_)) return fault;
    if (const Fault fault = check(next)) return fault;
    const Contact contact = standing(guide_on(*last_, last_->end));
    emit(*last_);
    emit_waiting(contact, corner.point);
    return nullptr;
}

/// The cutter rolls around an edge from one normal to that of the next surface. Where its end
/// comes to lie square to the tool on the path it slides over the edge.
void Compensation3d::roll(const TouchedMotion& next, const Vec3& from, const Vec3& at) {
    const Vec3 to = guide_on(next, 0);
    const Vec3 across = from.cross(to);
    Contact contact = standing(from);
    contact.axis = across.norm() > kSmooth ? Vec3(across.normalized()) : from.unitOrthogonal();
    contact.turn = path::angle_between(from, to);
    const double before = path::angle_between(from, shown_tool_);
    const double behind = path::angle_between(shown_tool_, to);
    const bool is_square_between = contact.radius != contact.depth && before > kSquare &&
                                   behind > kSquare &&
                                   before + behind - contact.turn < kSquare * kSquare;
    if (!is_square_between) return roll_part(contact, next, at);
    const double share = before / contact.turn;
    roll_part(part_of(contact, 0, share), next, at);
    roll_part(part_of(contact, share, 1), next, at);
}

void Compensation3d::roll_part(const Contact& contact, const TouchedMotion& next, const Vec3& at) {
    const Vec3 tool = shown_tool_;
    const TipPath tip = [&](double parameter) -> Vec3 {
        const auto aside = path::tip_or_limit(parameter, [&](double share) {
            return path::tip_beside(contact, path::guide_at(contact, share), tool);
        });
        return at + aside.value_or(path::tip_square(contact, tool));
    };
    AxisValues begin = shown_;
    set_linear(begin, tip(0));
    if (!is_same_position(begin, shown_)) emit_line_to(next.command, begin, tool);
    AxisValues end = shown_;
    set_linear(end, tip(1));
    if (path::tip_travel_about(contact, tool) < path::kSamePoint) return;
    if (next.command.op() == Op::Rapid) return emit_line_to(next.command, end, tool);
    Command command = like(next.command, Op::Line);
    command.motion().to = end;
    command.motion().direction = tool;
    if (settings_.orientation_limits.chain == nullptr) return emit_splines(command, shown_, tip);
    path::ContactMotion motion;
    motion.contact = contact;
    motion.from = motion.to = at;
    command.motion().contact = motion;
    put(std::move(command));
}

// ------------------------------------------------------------------------------ as splines

namespace {

/// The cubic over a part of a path that begins and ends as the path does.
path::SplineShape cubic_over(const std::function<Vec3(double)>& tip, double from, double to) {
    // Slopes from inside: at its ends a path may be a limit (path::tip_or_limit).
    const double step = (to - from) * 1e-3;
    const auto slope = [&](double at, double h) {
        return Vec3((-5 * tip(at + h) + 8 * tip(at + 2 * h) - 3 * tip(at + 3 * h)) / (2 * h));
    };
    path::SplineShape shape;
    shape.inner[0] = tip(from) + (to - from) / 3 * slope(from, step);
    shape.inner[1] = tip(to) - (to - from) / 3 * slope(to, -step);
    return shape;
}

bool is_near(const std::function<Vec3(double)>& tip, double from, double to,
             const path::SplineShape& shape) {
    const Vec3 first = tip(from);
    const Vec3 last = tip(to);
    for (const double t : {0.2, 0.5, 0.8}) {
        const double u = 1 - t;
        const Vec3 at = u * u * u * first + 3 * u * u * t * shape.inner[0] +
                        3 * u * t * t * shape.inner[1] + t * t * t * last;
        if ((at - tip(from + t * (to - from))).norm() > kWayTolerance) return false;
    }
    return true;
}

}  // namespace

/// A path that is no line and no arc, where no transformation of the machine holds the tip on it.
void Compensation3d::emit_splines(const Command& model, const AxisValues& from,
                                  const TipPath& tip) {
    constexpr double kShortest = 1e-4;
    double begin = 0;
    double step = 1;
    while (begin < 1) {
        const double end = begin + step > 1 - kShortest / 2 ? 1 : begin + step;
        const path::SplineShape shape = cubic_over(tip, begin, end);
        if (step > kShortest && !is_near(tip, begin, end, shape)) {
            step /= 2;
            continue;
        }
        Command command = like(model, Op::Spline);
        command.motion().spline() = shape;
        command.motion().to = model.motion().to;
        for (std::size_t i = 3; i < kAxes; ++i)
            command.motion().to[i] = from[i] + end * (model.motion().to[i] - from[i]);
        set_linear(command.motion().to, tip(end));
        command.motion().direction = shown_tool_;
        if (end == 1) command.motion().exact_stop = model.motion().exact_stop;
        put(std::move(command));
        begin = end;
        step = std::min(2 * step, 1 - begin);
    }
}

}  // namespace kadr::interp
