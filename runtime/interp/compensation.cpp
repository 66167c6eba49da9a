#include "interp/compensation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "base/diagnostics/iso.h"

namespace kadr::interp {

using path::Command;
using path::CompFault;
using path::CompPiece;
using path::Element;
using path::Op;
using path::Vec2;
using std::numbers::pi;

namespace {

Vec2 left_of(const Vec2& direction) { return {-direction.y(), direction.x()}; }

bool is_straight(Op op) { return op == Op::Line || op == Op::Rapid; }

bool is_same(const AxisValues& a, const AxisValues& b) {
    for (std::size_t i = 0; i < kAxes; ++i) {
        if (std::abs(a[i] - b[i]) > path::kSamePoint) return false;
    }
    return true;
}

const DiagnosticRow* row_of(CompFault fault) {
    switch (fault) {
        case CompFault::ArcTooSmall: return &diag::CompArcTooSmall;
        case CompFault::NoIntersection: return &diag::CompNoIntersection;
        case CompFault::Reversed:
        case CompFault::Bottleneck: break;
    }
    return &diag::CompCollision;
}

}  // namespace

// ------------------------------------------------------------------------------ on and off

void Compensation::begin(const CompSettings& settings, path::Plane plane, const CompTool& tool,
                         const AxisValues& here) {
    settings_ = settings;
    plane_ = plane;
    axes_ = path::axes_of(plane);
    if (state_ == State::Off) {
        shown_ = here;
        center_ = Vec2::Zero();
    }
    set_tool(tool);
    here_ = here;
    corners_ = path::RadiusComp(settings.corners);
    has_last_ = approaches_ = false;
    empty_blocks_ = 0;
    state_ = State::Starting;
}

/// The tip stays where it is.
void Compensation::set_tool(const CompTool& tool) {
    distance_ = tool.distance;
    set_in_plane(shown_, in_plane(shown_) + tool.center - center_);
    center_ = tool.center;
}

void Compensation::set_settings(const CompSettings& settings) {
    settings_ = settings;
    corners_.set_rules(settings.corners);
}

void Compensation::leave() { state_ = state_ == State::On ? State::Leaving : State::Off; }

std::optional<CompAlarm> Compensation::flush() {
    const Command nowhere;
    const Fault fault = finish();
    if (fault == nullptr) return std::nullopt;
    return alarm(fault, held_.empty() ? nowhere : held_.back().command);
}

/// The contour ends here, on its normal.
Compensation::Fault Compensation::finish() {
    if (const auto fault = corners_.finish()) return row_of(*fault);
    emit_pieces();
    for (; !held_.empty(); held_.pop_front()) {
        // An approach to no contour at all goes where it is programmed.
        if (held_.front().index != 0) {
            emit_line(held_.front(), center_at(held_.front().command.to), false);
        } else {
            emit_empty();
        }
    }
    corners_ = path::RadiusComp(settings_.corners);
    has_last_ = approaches_ = false;
    return nullptr;
}

// ------------------------------------------------------------------------------ commands in

std::optional<CompAlarm> Compensation::end_block(const AxisValues& here, const nc::Block& block) {
    bool has_moved = false;
    for (Command& command : fresh_) {
        has_moved = has_moved || (path::is_motion(command.op) && moves_in_plane(command));
        const Command place = command;
        if (const Fault fault = take(command, here)) {
            fresh_.clear();
            return alarm(fault, place);
        }
    }
    fresh_.clear();
    here_ = here;
    if (has_moved || !has_last_) {
        empty_blocks_ = 0;
        return std::nullopt;
    }
    if (++empty_blocks_ <= settings_.empty_blocks) return std::nullopt;
    Command place;
    place.source = block.source;
    place.line = block.line;
    if (settings_.more_empty_is_fault)
        return CompAlarm{&diag::CompEmptyBlocks, place.source, place.line};
    if (const Fault fault = finish()) return alarm(fault, place);
    return std::nullopt;
}

/// The block of the element that could not be compensated, else the one that is being taken.
CompAlarm Compensation::alarm(Fault fault, const Command& command) const {
    const auto held = std::ranges::find(held_, corners_.fault_at(), &Held::index);
    const bool is_corner = fault == &diag::CompCollision || fault == &diag::CompNoIntersection ||
                           fault == &diag::CompArcTooSmall;
    if (!is_corner || held == held_.end()) return {fault, command.source, command.line};
    return {fault, held->command.source, held->command.line};
}

Compensation::Fault Compensation::take(Command& command, const AxisValues& behind) {
    if (path::is_motion(command.op) && command.is_unshifted) {
        // For this way the compensation is taken back, and it begins anew behind it.
        if (const Fault fault = finish()) return fault;
        if (state_ == State::On) state_ = State::Starting;
        // Axes that it does not name stay where the cutter is.
        AxisValues tip = shown_;
        set_in_plane(tip, in_plane(shown_) - center_);
        for (const Axis axis : {axes_.first, axes_.second}) {
            if ((command.moved & bit(axis)) == 0) command.to[index(axis)] = tip[index(axis)];
        }
        here_ = shown_ = behind;
        set_in_plane(shown_, center_at(command.to));
        settled_.push_back(std::move(command));
        return nullptr;
    }
    if (path::is_motion(command.op) && moves_in_plane(command)) return take_motion(command);
    if (path::is_motion(command.op) && !is_straight(command.op) && state_ != State::Starting)
        return &diag::CompMotion;
    if (path::is_motion(command.op)) here_ = command.to;
    held_.push_back({std::move(command), 0, 0, false});
    if (!approaches_ && !has_last_) emit_empty(), held_.pop_front();
    return nullptr;
}

Compensation::Fault Compensation::take_motion(Command& command) {
    if (!is_straight(command.op) && command.op != Op::Arc) return &diag::CompMotion;
    const double side = command.normal.dot(path::unit(axes_.normal));
    if (command.op == Op::Arc && std::abs(side) < 1 - 1e-9) return &diag::CompMotion;  // it tilts
    if (command.feed_mode == path::FeedMode::InverseTime && command.op != Op::Rapid)
        return &diag::CompMotion;
    switch (state_) {
        case State::Starting: return approach(command);
        case State::Leaving: return depart(command);
        default: return follow(command);
    }
}

Compensation::Fault Compensation::approach(Command& command) {
    if (!is_straight(command.op)) return &diag::CompStartOnArc;
    here_ = command.to;
    held_.push_back({std::move(command), ++elements_, 0, false});
    approaches_ = true;
    state_ = State::On;
    return nullptr;
}

Compensation::Fault Compensation::follow(Command& command) {
    const Element element = element_of(command);
    if (approaches_) {
        if (const Fault fault = enter(element)) return fault;
    }
    const double radius = element.is_arc() ? path::radius(element) : 0;
    here_ = command.to;
    return push(element, {std::move(command), ++elements_, radius, false});
}

/// The first element says where the approach ends.
Compensation::Fault Compensation::enter(const Element& first) {
    std::optional<Element> way;
    if (const Fault fault = way_in(first, way)) return fault;
    approaches_ = false;
    if (way) {
        if (const auto fault = corners_.push(*way, distance_, held_.front().index))
            return row_of(*fault);
        return nullptr;
    }
    emit_line(held_.front(), path::RadiusComp::start_of(first, distance_), false);
    held_.pop_front();
    return nullptr;
}

Compensation::Fault Compensation::push(const Element& element, Held held) {
    const std::size_t index = held.index;
    held_.push_back(std::move(held));
    last_ = element;
    has_last_ = true;
    empty_blocks_ = 0;
    if (const auto fault = corners_.push(element, distance_, index)) return row_of(*fault);
    emit_pieces();
    return nullptr;
}

Compensation::Fault Compensation::depart(Command& command) {
    if (!is_straight(command.op)) return &diag::CompEndOnArc;
    const Vec2 to = center_at(command.to);
    std::optional<Element> way;
    if (has_last_) {
        if (const Fault fault = way_out(to, way)) return fault;
    }
    here_ = command.to;
    if (way) {
        if (const Fault fault = push(*way, {std::move(command), ++elements_, 0, true}))
            return fault;
        if (const Fault fault = finish()) return fault;
    } else {
        if (const Fault fault = finish()) return fault;
        emit_line({std::move(command), 0, 0, true}, to, false);
    }
    state_ = State::Off;
    return nullptr;
}

// ------------------------------------------------------------------------------ there and back

/// The place on the circle about the corner that a line from `from` touches, so that the corner is
/// at the distance beside it. None within the circle.
std::optional<Vec2> Compensation::touched(const Vec2& corner, const Vec2& from,
                                          double distance) const {
    const Vec2 away = from - corner;
    const double apart = away.norm();
    const double radius = std::abs(distance);
    if (apart <= radius) return std::nullopt;
    const double angle = std::acos(radius / apart);
    const Vec2 direction = away / apart;
    for (const double sign : {1.0, -1.0}) {
        const Vec2 place = corner + Eigen::Rotation2D(sign * angle) * direction * radius;
        if (left_of(place - from).dot(place - corner) * distance > 0) return place;
    }
    return std::nullopt;
}

/// The approach as an element of the contour, if the first corner is to be treated as one; none:
/// straight to the normal.
Compensation::Fault Compensation::way_in(const Element& first, std::optional<Element>& way) const {
    const Vec2 from = in_plane(shown_);
    const Vec2 tangent = path::start_direction(first);
    const Vec2 along = first.from - from;
    if (along.norm() < path::kSamePoint || distance_ == 0) return nullptr;
    if (settings_.start == CompStart::Extended) {
        const double turn = along.x() * tangent.y() - along.y() * tangent.x();
        if (turn * distance_ < 0) way = path::line_element(from, first.from);
    }
    const bool is_behind = left_of(tangent).dot(along) * distance_ > path::kSamePoint;
    if (settings_.start != CompStart::Around || !is_behind) return nullptr;
    const std::optional<Vec2> touch = touched(first.from, from, distance_);
    if (!touch) return &diag::CompStartBlocked;
    way = path::line_element(first.from - (*touch - from), first.from);
    return nullptr;
}

Compensation::Fault Compensation::way_out(const Vec2& to, std::optional<Element>& way) const {
    const Vec2 tangent = path::end_direction(last_);
    const Vec2 along = to - last_.to;
    if (along.norm() < path::kSamePoint || distance_ == 0) return nullptr;
    if (settings_.start == CompStart::Extended) {
        const double turn = tangent.x() * along.y() - tangent.y() * along.x();
        if (turn * distance_ < 0) way = path::line_element(last_.to, to);
    }
    const bool is_behind = left_of(tangent).dot(along) * distance_ < -path::kSamePoint;
    if (settings_.start != CompStart::Around || !is_behind) return nullptr;
    // The way back touches from the other side.
    const std::optional<Vec2> touch = touched(last_.to, to, -distance_);
    if (!touch) return &diag::CompStartBlocked;
    way = path::line_element(last_.to, last_.to + (to - *touch));
    return nullptr;
}

// ------------------------------------------------------------------------------ commands out

void Compensation::emit_pieces() {
    for (const CompPiece& piece : corners_.pieces()) emit(piece);
    corners_.pieces().clear();
}

void Compensation::emit(const CompPiece& piece) {
    // Blocks without motion come before the corner, elements that were left out not at all.
    for (; held_.front().index != piece.index; held_.pop_front()) {
        if (held_.front().index == 0) emit_empty();
    }
    const Held& held = held_.front();
    const Element& way = piece.element;
    if (!way.is_arc()) {
        emit_line(held, held.is_departure ? center_at(held.command.to) : way.to, piece.is_inserted);
    } else {
        const bool is_gap = (in_plane(shown_) - way.from).norm() > path::kSamePoint;
        if (is_gap) emit_line(held, way.from, true);
        if (held.command.op == Op::Rapid) emit_rapid_around(held, way);
        else emit_arc(held, piece);
    }
    if (!piece.is_inserted) held_.pop_front();
}

/// A block without motion in the plane: where the cutter stands now.
void Compensation::emit_empty() {
    Held& held = held_.front();
    if (!path::is_motion(held.command.op)) return settled_.push_back(std::move(held.command));
    set_in_plane(held.command.to, in_plane(shown_));
    put(std::move(held.command));
}

void Compensation::emit_line(const Held& held, const Vec2& to, bool is_inserted) {
    Command command = held.command;
    if (command.op == Op::Arc) command.op = Op::Line;
    if (is_inserted) {
        command.to = shown_;
        command.exact_stop = false;
    }
    set_in_plane(command.to, to);
    // What nothing is left of is no block: an exact stop has its corner.
    if (!is_same(command.to, shown_)) put(std::move(command));
}

void Compensation::emit_arc(const Held& held, const CompPiece& piece) {
    Command command = held.command;
    const Element& arc = piece.element;
    const double radius = path::radius(arc);
    command.op = Op::Arc;
    if (piece.is_inserted) {
        command.to = shown_;
        command.center = {shown_[0], shown_[1], shown_[2]};
        command.exact_stop = false;
        command.turns = 0;
    } else if (settings_.feed == CompFeed::Contour && held.radius > 0) {
        command.feed *= radius / held.radius;
    }
    set_in_plane(command.to, arc.to);
    command.center[static_cast<Eigen::Index>(index(axes_.first))] = arc.center.x();
    command.center[static_cast<Eigen::Index>(index(axes_.second))] = arc.center.y();
    command.normal = path::unit(axes_.normal) * (arc.sweep > 0 ? 1 : -1);
    command.sweep = std::abs(arc.sweep) + 2 * pi * command.turns;
    command.is_clockwise = arc.sweep < 0;
    put(std::move(command));
}

/// At rapid there are no arcs: around a corner by lines that touch the arc.
void Compensation::emit_rapid_around(const Held& held, const Element& arc) {
    const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(arc.sweep) / (pi / 2))));
    const double half = arc.sweep / parts / 2;
    Vec2 arm = arc.from - arc.center;
    for (int i = 0; i < parts; ++i) {
        const Vec2 corner = Eigen::Rotation2D(half) * arm / std::cos(half);
        emit_line(held, arc.center + corner, true);
        arm = Eigen::Rotation2D(2 * half) * arm;
    }
    emit_line(held, arc.to, true);
}

void Compensation::put(Command command) {
    command.moved = static_cast<AxisMask>(command.moved | bit(axes_.first) | bit(axes_.second));
    shown_ = command.to;
    set_in_plane(command.to, in_plane(command.to) - center_);
    command.center[static_cast<Eigen::Index>(index(axes_.first))] -= center_.x();
    command.center[static_cast<Eigen::Index>(index(axes_.second))] -= center_.y();
    settled_.push_back(std::move(command));
}

// ------------------------------------------------------------------------------ the plane

bool Compensation::moves_in_plane(const Command& command) const {
    return command.op == Op::Arc ||
           (in_plane(command.to) - in_plane(here_)).norm() > path::kSamePoint;
}

Element Compensation::element_of(const Command& command) const {
    const Vec2 from = in_plane(here_);
    const Vec2 to = in_plane(command.to);
    if (command.op != Op::Arc) return path::line_element(from, to);
    Element arc{from, to, {}, 0};
    arc.center = {command.center[static_cast<Eigen::Index>(index(axes_.first))],
                  command.center[static_cast<Eigen::Index>(index(axes_.second))]};
    const bool is_left = command.normal.dot(path::unit(axes_.normal)) > 0;
    arc.sweep = (command.sweep - 2 * pi * command.turns) * (is_left ? 1 : -1);
    return arc;
}

Vec2 Compensation::in_plane(const AxisValues& values) const {
    return {values[index(axes_.first)], values[index(axes_.second)]};
}

void Compensation::set_in_plane(AxisValues& values, const Vec2& at) const {
    values[index(axes_.first)] = at.x();
    values[index(axes_.second)] = at.y();
}

}  // namespace kadr::interp
