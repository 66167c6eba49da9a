#include "interp/compensation_3d.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Dense>

#include "base/diagnostics/iso.h"
#include "base/units.h"
#include "interp/compensation_3d_parts.h"
#include "machine/kinematics.h"
#include "path/curve_of.h"
#include "path/orient_law.h"

namespace kadr::interp {

using path::Command;
using path::Contact;
using path::ContactKind;
using path::is_straight;
using path::linear;
using path::Op;
using path::set_linear;
using path::Vec3;
using std::numbers::pi;

namespace {

// Directions that differ by rounding.
constexpr double kSameToolDirection = 1e-12;

/// By so much a vector turns about an axis to become another, −π … π, both square to it.
double angle_about(const Vec3& axis, const Vec3& from, const Vec3& to) {
    return std::atan2(from.cross(to).dot(axis), from.dot(to));
}

}  // namespace

// ------------------------------------------------------------------------------ on and off

void Compensation3d::begin(const Comp3dSettings& settings, const AxisValues& here) {
    if (state_ == State::Off) shown_ = here;
    settings_ = settings;
    here_ = here;
    tool_ = shown_tool_ = settings.direction;
    approach_.reset();
    last_.reset();
    empty_blocks_ = 0;
    state_ = State::Starting;
}

void Compensation3d::leave() { state_ = state_ == State::On ? State::Leaving : State::Off; }

std::optional<CompAlarm> Compensation3d::flush() {
    const Command place = last_ ? last_->command : Command{};
    const Fault fault = finish();
    if (state_ == State::On) state_ = State::Starting;
    if (fault == nullptr) return std::nullopt;
    return alarm(fault, place);
}

std::optional<CompAlarm> Compensation3d::stop() {
    std::optional<CompAlarm> alarm = flush();
    state_ = State::Off;
    return alarm;
}

// ------------------------------------------------------------------------------ commands in

std::optional<CompAlarm> Compensation3d::end_block(const nc::Block& block) {
    bool has_moved = false;
    for (Command& command : fresh_) {
        const Vec3 before = linear(here_);
        const Command place = command;
        if (const Fault fault = take(command)) {
            fresh_.clear();
            return alarm(fault, place);
        }
        has_moved = has_moved || (linear(here_) - before).norm() > kStill || place.op() == Op::Arc;
    }
    fresh_.clear();
    if (std::exchange(cannot_orient_, false))
        return CompAlarm{&diag::CompTurnsInside, block.source, block.line};
    if (has_moved || (!last_ && !approach_)) {
        empty_blocks_ = 0;
        return std::nullopt;
    }
    if (++empty_blocks_ <= settings_.empty_blocks) return std::nullopt;
    return CompAlarm{&diag::CompEmptyBlocks, block.source, block.line};
}

/// Of the tool where a motion ends.
Vec3 Compensation3d::tool_behind(const path::Motion& motion) const {
    return settings_.orientation_limits.chain == nullptr ? settings_.direction : motion.direction;
}

bool Compensation3d::changes_orientation(const Command& command) const {
    return settings_.orientation_limits.chain != nullptr && command.is_motion();
}

/// What is wrong at a corner is reported of the element before it.
CompAlarm Compensation3d::alarm(Fault fault, const Command& command) const {
    const bool is_corner = fault == &diag::CompCollision || fault == &diag::CompNoIntersection ||
                           fault == &diag::CompFaceCorner;
    const Command& place = is_corner && last_ ? last_->command : command;
    return {fault, place.source, place.line};
}

Compensation3d::Fault Compensation3d::take(Command& command) {
    if (command.is_motion()) {
        path::Motion& motion = command.motion();
        // What is touched is given for a motion beside it, and of none that leads there or stands.
        if (state_ != State::On || motion.machine_coordinates) motion.contact.reset();
        if (!motion.machine_coordinates) return take_motion(command);
        if (const Fault fault = finish()) return fault;
        if (state_ == State::On) state_ = State::Starting;
        here_ = motion.to;
        put(std::move(command));
        return nullptr;
    }
    if (approach_ || last_) {
        waiting_.push_back(std::move(command));
    } else {
        put(std::move(command));
    }
    return nullptr;
}

Compensation3d::Fault Compensation3d::take_motion(Command& command) {
    path::Motion& motion = command.motion();
    if (motion.op() == Op::Thread || motion.op() == Op::Probe) return &diag::CompMotion;
    path::Curve curve = path::curve_of(motion, linear(here_), linear(motion.to));
    if (path::length(curve) <= kStill) {
        // Only the orientation changes, or other axes move.
        here_ = motion.to;
        motion.contact.reset();
        tool_ = tool_behind(motion);
        if (approach_ || last_) {
            waiting_.push_back(std::move(command));
        } else {
            put(std::move(command));
        }
        return nullptr;
    }
    if (state_ == State::On) return follow(command, std::move(curve));
    if (!is_straight(motion.op()))
        return state_ == State::Leaving ? &diag::CompEndOnArc : &diag::CompStartOnArc;
    const Vec3 from = linear(here_);
    here_ = motion.to;
    tool_ = tool_behind(motion);
    if (state_ == State::Leaving) {
        if (const Fault fault = finish()) return fault;
        put_path(std::move(command), from, linear(here_));
        state_ = State::Off;
        return nullptr;
    }
    approach_from_ = from;
    approach_ = std::move(command);
    state_ = State::On;
    return nullptr;
}

Compensation3d::Fault Compensation3d::follow(Command& command, path::Curve curve) {
    path::Motion& motion = command.motion();
    if (motion.feed_mode == path::FeedMode::InverseTime && motion.op() != Op::Rapid) {
        if (!settings_.takes_inverse_time) return &diag::CompInverseTime;
        motion.feed *= path::length(curve);
        motion.feed_mode = path::FeedMode::PerMinute;
    }
    TouchedMotion side;
    side.curve = std::move(curve);
    side.from = here_;
    side.from_tool = tool_;
    side.to_tool = tool_behind(motion);
    side.contact = settings_.cutter.contact;
    here_ = motion.to;
    tool_ = side.to_tool;
    std::optional<Contact> surface;
    if (motion.contact) surface = motion.contact->contact;
    motion.contact.reset();
    side.command = std::move(command);
    if (settings_.cutter.is_face_milling()) {
        if (!surface) return &diag::CompMotion;
        if (const Fault fault = take_surface(*surface, side)) return fault;
    } else if (const Fault fault = check(side)) {
        return fault;
    }
    if (const Fault fault = approach_ ? enter(side) : last_ ? join(side) : nullptr) return fault;
    last_ = std::move(side);
    return nullptr;
}

/// Whether the cutter can go along what is left of an element; when its corners have cut it, the
/// tool stands otherwise along it.
Compensation3d::Fault Compensation3d::check(TouchedMotion& side) const {
    if (side.contact.kind != ContactKind::Face) return check_side(side);
    if (const Fault fault = check_inclinations(side)) return fault;
    return check_bends(side);
}

Compensation3d::Fault Compensation3d::check_side(const TouchedMotion& side) const {
    // Without the machine's transformation nobody holds the tip on another path.
    if (settings_.orientation_limits.chain == nullptr && !keeps_kind(side))
        return &diag::CompMotion;
    for (const double parameter : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const double share = side.share_of_path(parameter);
        const path::CurvePoint at = side.at(share);
        const auto aside = path::beside(at.tangent, tool_on(side, share));
        if (!aside) return &diag::CompAlongTool;
        if (at.curvature.dot(*aside) * side.contact.radius >= 1) return &diag::CompArcTooSmall;
    }
    return nullptr;
}

/// Straight to beside the start of the contour; what orients the tool there comes behind that.
Compensation3d::Fault Compensation3d::enter(const TouchedMotion& first) {
    Command command = std::move(*approach_);
    approach_.reset();
    const Contact contact = standing(guide_on(first, 0));
    const Vec3 tool = tool_behind(command.motion());
    auto aside = path::tip_beside(contact, contact.guide, tool);
    if (!aside && first.contact.kind == ContactKind::Face)
        aside = path::tip_square(first.contact, tool);
    if (!aside) return &diag::CompAlongTool;
    const Vec3 programmed = linear(command.motion().to);
    set_linear(command.motion().to, programmed + *aside);
    put_path(std::move(command), approach_from_, programmed);
    emit_waiting(contact, linear(first.from));
    return nullptr;
}

Compensation3d::Fault Compensation3d::join(TouchedMotion& next) {
    if (next.contact.kind == ContactKind::Face) return join_surfaces(next);
    const path::CurvePoint end = last_->at(1);
    Corner corner{end.position, end.tangent, next.at(0).tangent, last_->to_tool, next.from_tool};
    const auto first = path::beside(corner.first, corner.tool);
    const auto second = path::beside(corner.second, corner.tool);
    if (!first || !second) return &diag::CompAlongTool;
    corner.turn = angle_about(corner.tool, *first, *second);
    if (corner.is_smooth()) {
        emit(*last_);
        emit_waiting(standing(corner.first), corner.point);
        return nullptr;
    }
    if (corner.turn * settings_.cutter.contact.radius < 0 && std::abs(corner.turn) < pi - kSmooth)
        return join_inside(next, corner);
    join_outside(next, corner);
    return nullptr;
}

/// Both elements end where the cutter touches both of them as it stands at the corner. A tool that
/// turns there touches both lines while it does.
Compensation3d::Fault Compensation3d::join_inside(TouchedMotion& next, const Corner& corner) {
    const bool turns = (corner.behind - corner.tool).norm() > kSameToolDirection;
    const bool are_lines = last_->is_line() && next.is_line();
    if (turns && !are_lines) return &diag::CompTurnsInside;
    if (are_lines) {
        const auto shorten = [&](TouchedMotion& side, const Vec3& tool, bool is_first) {
            const Vec3 m1 = *path::beside(corner.first, tool);
            const Vec3 m2 = *path::beside(corner.second, tool);
            const Vec3& along = is_first ? corner.first : corner.second;
            const double across =
                std::abs(side.contact.radius) * (m1 - m2).norm() / (m1 + m2).norm();
            const double share = across / along.cross(tool).norm() / side.length();
            (is_first ? side.end : side.begin) = is_first ? 1 - share : share;
        };
        if (!path::beside(corner.second, corner.behind) ||
            !path::beside(corner.first, corner.behind))
            return &diag::CompAlongTool;
        shorten(*last_, corner.tool, true);
        shorten(next, corner.behind, false);
    } else {
        const Vec3 across = corner.tool.unitOrthogonal();
        if (const Fault fault = meet(*last_, next, {across, corner.tool.cross(across)}))
            return fault;
    }
    if (last_->end <= last_->begin || next.begin >= 1) return &diag::CompCollision;
    if (const Fault fault = check(*last_)) return fault;
    if (const Fault fault = check(next)) return fault;
    emit(*last_);
    Contact contact = standing(corner.first);
    contact.kind = ContactKind::Corner;
    contact.axis = corner.second;
    emit_waiting(contact, corner.point);
    return nullptr;
}

/// Where the tips of both sides meet, seen so. Wherever that is, the first ends and the second
/// begins with the tool of the corner.
Compensation3d::Fault Compensation3d::meet(TouchedMotion& a, TouchedMotion& b,
                                           const View& view) const {
    constexpr int kMostSteps = 40;
    constexpr double kStep = 1e-6;
    const auto apart = [&](double end, double begin) -> std::optional<Eigen::Vector2d> {
        a.end = end;
        b.begin = begin;
        const auto first = tip_on(a, end);
        const auto second = tip_on(b, begin);
        if (!first || !second) return std::nullopt;
        const Vec3 gap = *first - *second;
        return Eigen::Vector2d(gap.dot(view.across), gap.dot(view.along));
    };
    double end = 1;
    double begin = 0;
    for (int i = 0; i < kMostSteps; ++i) {
        const auto gap = apart(end, begin);
        const auto by_end = apart(end - kStep, begin);
        const auto by_begin = apart(end, begin + kStep);
        if (!gap || !by_end || !by_begin) return &diag::CompAlongTool;
        if (gap->norm() < kStill) {
            if (end > 1 + kStep || begin < -kStep) return &diag::CompNoIntersection;
            a.end = std::min(end, 1.0);
            b.begin = std::max(begin, 0.0);
            return nullptr;
        }
        Eigen::Matrix2d slopes;
        slopes.col(0) = (*gap - *by_end) / kStep;
        slopes.col(1) = (*by_begin - *gap) / kStep;
        if (!(std::abs(slopes.determinant()) > 1e-12)) return &diag::CompNoIntersection;
        const Eigen::Vector2d step = slopes.inverse() * *gap;
        // Nothing is left of an element that ends where it begins, and no orientation changes
        // there.
        end = std::min(std::max(end - step[0], a.begin + 2 * kStep), 1.0 + kStep);
        begin = std::clamp(begin - step[1], -kStep, b.end - 2 * kStep);
    }
    return &diag::CompNoIntersection;
}

/// Around the corner on an arc, or to where both lines meet if they are extended.
void Compensation3d::join_outside(TouchedMotion& next, const Corner& corner) {
    const bool turns = std::ranges::any_of(
        waiting_, [&](const Command& command) { return changes_orientation(command); });
    const bool are_even = last_->is_line() && next.is_line() && !last_->turns() && !next.turns();
    if (settings_.extends_lines && are_even && !turns && std::abs(corner.turn) <= settings_.limit) {
        extend(next, corner);
        return;
    }
    emit(*last_);
    Contact contact = standing(corner.first);
    if (turns && settings_.orients_on_arc) {
        contact.axis = corner.axis();
        contact.turn =
            std::atan2(corner.first.cross(corner.second).norm(), corner.first.dot(corner.second));
        return emit_waiting(contact, corner.point);
    }
    emit_waiting(contact, corner.point);
    const auto from = path::beside(corner.first, corner.behind);
    const auto to = path::beside(corner.second, corner.behind);
    if (!from || !to) return;  // the next element reports it
    const double turn = std::abs(angle_about(corner.behind, *from, *to));
    emit_arc(next.command, corner.point, *from, *to,
             settings_.cutter.contact.radius > 0 ? turn : -turn);
}

void Compensation3d::extend(TouchedMotion& next, const Corner& corner) {
    const double across = std::abs(settings_.cutter.contact.radius * std::tan(corner.turn / 2));
    last_->end = 1 + across / corner.first.cross(corner.tool).norm() / last_->length();
    next.begin = -across / corner.second.cross(corner.tool).norm() / next.length();
    emit(*last_);
    emit_waiting(standing(corner.first), corner.point);
}

/// The contour ends here, square to it.
Compensation3d::Fault Compensation3d::finish() {
    if (approach_) {  // of no contour at all
        const Vec3 to = linear(approach_->motion().to);
        put_path(std::move(*approach_), approach_from_, to);
        approach_.reset();
    }
    if (!last_) {
        for (Command& command : waiting_) put(std::move(command));
        waiting_.clear();
        return nullptr;
    }
    const Vec3 guide = guide_on(*last_, 1);
    const Vec3 end = last_->at(1).position;
    emit(*last_);
    emit_waiting(standing(guide), end);
    last_.reset();
    return nullptr;
}

// ------------------------------------------------------------------------------ geometry

path::CurvePoint Compensation3d::TouchedMotion::at(double share) const {
    const double whole = length();
    path::CurvePoint point = path::evaluate(curve, share * whole);
    // A line that is extended.
    if (is_line() && (share < 0 || share > 1))
        point.position = path::start(curve) + share * whole * point.tangent;
    return point;
}

/// Whether the tip's path is of the same kind: of peripheral milling a line, or an arc square to a
/// tool that does not change its direction; on a surface that does not turn either, any.
bool Compensation3d::keeps_kind(const TouchedMotion& side) {
    if (side.turns()) return false;
    if (side.contact.kind == ContactKind::Face) return side.contact.turn == 0;
    const bool is_square_arc =
        side.command.op() == Op::Arc &&
        std::abs(side.command.motion().arc().normal.dot(side.from_tool)) > 1 - 1e-9;
    return side.is_line() || is_square_arc;
}

/// Of the tool at a share of a motion that begins with the axes and the tool so.
Vec3 Compensation3d::tool_along(const path::Motion& motion, const AxisValues& from,
                                const Vec3& from_tool, const path::Curve& curve,
                                double share) const {
    if (settings_.orientation_limits.chain == nullptr) return from_tool;
    const double length = std::holds_alternative<path::Point>(curve) ? 1 : path::length(curve);
    if (motion.orient_kind > path::OrientKind::Axes)
        return path::direction_at(orient_law_of(motion, from_tool, length), curve, share * length);
    AxisValues axes{};
    for (std::size_t i = 3; i < kAxes; ++i) axes[i] = from[i] + share * (motion.to[i] - from[i]);
    return machine::tool_vector(*settings_.orientation_limits.chain,
                                joints_at(*settings_.orientation_limits.chain, axes));
}

/// At a share of the whole path.
Vec3 Compensation3d::tool_on(const TouchedMotion& side, double share) const {
    if (side.command.motion().orient_kind > path::OrientKind::Axes)
        return path::direction_at(orient_law_on(side), side.curve, share * side.length());
    if (!side.turns()) return side.from_tool;
    return tool_along(side.command.motion(), side.from, side.from_tool, side.curve,
                      side.share_of_part(share));
}

/// Of the contour its tangent, of a surface its normal.
Vec3 Compensation3d::guide_on(const TouchedMotion& side, double share) const {
    if (side.contact.kind == ContactKind::Face) return path::guide_at(side.contact, share);
    return side.at(share).tangent;
}

std::optional<Vec3> Compensation3d::aside_on(const TouchedMotion& side, double share) const {
    return path::tip_or_limit(side.share_of_part(share), [&](double parameter) {
        const double at = side.share_of_path(parameter);
        return path::tip_beside(side.contact, guide_on(side, at), tool_on(side, at));
    });
}

std::optional<Vec3> Compensation3d::tip_on(const TouchedMotion& side, double share) const {
    const auto aside = aside_on(side, share);
    if (!aside) return std::nullopt;
    return side.at(share).position + *aside;
}

/// Where the tip and the other axes are at one of the ends of what is left.
AxisValues Compensation3d::axes_on(const TouchedMotion& side, double share) const {
    AxisValues axes = share == side.begin ? side.from : side.command.motion().to;
    set_linear(axes, tip_on(side, share).value_or(side.at(share).position));
    return axes;
}

/// The tool orientation along an element: a block shares its change out over the path that it has
/// in the end (S 7.4: u is the path fraction), so that a corner is passed with the tool that the
/// program gives it. A second point keeps to the ends of the path as it does to those programmed.
path::OrientLaw Compensation3d::orient_law_on(const TouchedMotion& side) {
    const double length = side.length();
    const double part = side.part() * length;
    path::OrientLaw orientation = orient_law_of(side.command.motion(), side.from_tool, part);
    if (orientation.kind == path::OrientKind::Point) {
        const Vec3 before = side.at(side.begin).position - side.at(0).position;
        const Vec3 behind = side.at(side.end).position - side.at(1).position;
        orientation.start += before;
        orientation.axis += (behind - before) / part;
    }
    const double begin = side.begin * length;
    return path::part_of(orientation, -begin, length - begin);
}

/// What a command gives for it for what is left.
void Compensation3d::cut_turn(const TouchedMotion& side, path::Motion& motion) {
    if (!motion.orient_details) return;
    const double length = side.length();
    const path::OrientLaw orientation = orient_law_on(side);
    motion.orient_details->from =
        path::part_of(orientation, side.begin * length, side.end * length).start;
    if (orientation.kind == path::OrientKind::Point)
        motion.orient_details->axis = side.part() * length * orientation.axis;
}

/// The cutter as it stands at a point of the contour or of the surface.
Contact Compensation3d::standing(const Vec3& guide) const {
    Contact contact = settings_.cutter.contact;
    if (contact.kind == ContactKind::Flank) contact.kind = ContactKind::Pivot;
    contact.guide = guide;
    contact.axis = Vec3::UnitZ();
    return contact;
}

// ------------------------------------------------------------------------------ commands out

/// A path that is only shifted, or an arc about the tool, stays what it is.
void Compensation3d::emit(TouchedMotion& side) {
    const AxisValues start = axes_on(side, side.begin);
    if (!is_same_position(start, shown_))
        emit_line_to(side.command, start, tool_on(side, side.begin));
    Command command = side.command;
    path::Motion& motion = command.motion();
    const AxisValues to = axes_on(side, side.end);
    const Vec3 tool = tool_on(side, side.end);
    const double part = side.part();
    if (keeps_kind(side)) {
        const Vec3 aside = side.contact.kind == ContactKind::Face
                               ? aside_on(side, 0).value_or(Vec3::Zero())
                               : Vec3(-side.contact.depth * side.from_tool);
        if (motion.op() == Op::Arc) {
            motion.arc().center += aside;
            motion.arc().sweep *= part;
        } else if (motion.op() == Op::Involute) {
            motion.involute().center += aside;
        }
    } else if (settings_.orientation_limits.chain == nullptr) {
        return emit_splines(side.command, side.from, [&](double share) {
            return tip_on(side, side.share_of_path(share)).value_or(Vec3::Zero());
        });
    } else {
        path::ContactMotion touched;
        touched.contact = side.contact;
        touched.contact.guide = path::guide_at(side.contact, side.begin);
        touched.contact.turn *= part;
        touched.from = linear(side.from);
        touched.to = linear(motion.to);
        touched.begin = side.begin;
        touched.end = side.end;
        motion.contact = touched;
        cut_turn(side, motion);
    }
    motion.to = to;
    motion.direction = tool;
    put(std::move(command));
}

/// What waited at a corner; the guide's rotation is shared out among the changes of orientation.
void Compensation3d::emit_waiting(Contact contact, const Vec3& at) {
    const double whole = contact.turn;
    double angles = 0;
    Vec3 tool = shown_tool_;
    for (const Command& command : waiting_) {
        if (!changes_orientation(command)) continue;
        angles += std::acos(std::clamp(tool.dot(command.motion().direction), -1.0, 1.0));
        tool = command.motion().direction;
    }
    for (Command& command : waiting_) {
        if (!changes_orientation(command)) {
            if (command.is_motion()) set_linear(command.motion().to, linear(shown_));
            put(std::move(command));
            continue;
        }
        const double angle =
            std::acos(std::clamp(shown_tool_.dot(command.motion().direction), -1.0, 1.0));
        contact.turn = angles > 0 ? whole * angle / angles : 0;
        emit_turn(std::move(command), contact, at);
        if (contact.kind != ContactKind::Corner) contact.guide = path::guide_at(contact, 1);
    }
    waiting_.clear();
}

/// The orientation changes about the point that is touched.
void Compensation3d::emit_turn(Command command, Contact contact, const Vec3& at) {
    const AxisValues before = shown_;
    const Vec3 tool = shown_tool_;
    const auto aside = [&](double share) {
        return path::tip_beside(contact, path::guide_at(contact, share),
                                tool_along(command.motion(), before, tool, path::Point{at}, share));
    };
    const bool is_square = contact.kind == ContactKind::Face && !path::tip_or_limit(0.5, aside);
    if (is_square) contact.radius = contact.depth;
    const auto start = path::tip_or_limit(0, aside);
    const auto end = path::tip_or_limit(1, aside);
    if (start) {
        AxisValues from = shown_;
        set_linear(from, at + *start);
        if (!is_same_position(from, shown_)) emit_line_to(command, from, shown_tool_);
    }
    path::ContactMotion motion;
    motion.contact = contact;
    motion.from = motion.to = at;
    command.motion().contact = motion;
    set_linear(command.motion().to, at + end.value_or(Vec3::Zero()));
    put(std::move(command));
}

/// About a corner from square to one side to square to the next; at rapid lines that touch the arc.
void Compensation3d::emit_arc(const Command& model, const Vec3& at, const Vec3& from,
                              const Vec3& to, double turn) {
    const Vec3 tool = shown_tool_;
    const double radius = settings_.cutter.contact.radius;
    const Vec3 center = at - settings_.cutter.contact.depth * tool;
    if (std::abs(turn * radius) < path::kSamePoint) return;
    AxisValues end = shown_;
    if (model.op() == Op::Rapid) {
        const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / (pi / 2))));
        const double half = turn / parts / 2;
        for (int i = 0; i < parts; ++i) {
            const Vec3 arm = Eigen::AngleAxisd((2 * i + 1) * half, tool) * from;
            set_linear(end, center + radius / std::cos(half) * arm);
            emit_line_to(model, end, tool);
        }
        set_linear(end, center + radius * to);
        return emit_line_to(model, end, tool);
    }
    Command command = like(model, Op::Arc);
    path::Motion& motion = command.motion();
    path::ArcShape arc;
    arc.center = center;
    arc.normal = turn > 0 ? tool : Vec3(-tool);
    arc.sweep = std::abs(turn);
    arc.is_clockwise = arc.normal.dot(path::unit(path::axes_of(motion.plane).normal)) < 0;
    motion.shape = arc;
    set_linear(end, center + radius * to);
    motion.to = end;
    motion.direction = tool;
    put(std::move(command));
}

void Compensation3d::emit_line_to(const Command& model, const AxisValues& to, const Vec3& tool) {
    Command command = like(model, model.op() == Op::Rapid ? Op::Rapid : Op::Line);
    command.motion().to = to;
    command.motion().direction = tool;
    put(std::move(command));
}

/// A path to the contour or from it, between two points as it is programmed.
void Compensation3d::put_path(Command command, const Vec3& from, const Vec3& to) {
    shift_point({from, to, linear(shown_), linear(command.motion().to)}, command.motion());
    shown_tool_ = tool_behind(command.motion());
    const AxisValues begin = std::exchange(shown_, command.motion().to);
    if (!put_oriented(settings_.orientation_limits, begin, std::move(command), settled_))
        cannot_orient_ = true;
}

void Compensation3d::put(Command command) {
    if (command.is_motion()) {
        shown_ = command.motion().to;
        shown_tool_ = tool_behind(command.motion());
    }
    settled_.push_back(std::move(command));
}

}  // namespace kadr::interp
