#include "interp/compensation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "base/diagnostics/iso.h"
#include "interp/rotated_command.h"
#include "machine/kinematics.h"

namespace kadr::interp {

using path::Command;
using path::CompFault;
using path::CompPiece;
using path::Element;
using path::linear;
using path::Op;
using path::Vec2;
using std::numbers::pi;

namespace {

bool is_straight(Op op) { return op == Op::Line || op == Op::Rapid; }

bool is_curve(nc::CompStart start) {
    return start == nc::CompStart::Tangent || start == nc::CompStart::Smooth;
}

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

void Compensation::begin(const CompSettings& settings, path::Plane plane, double distance,
                         const AxisValues& here) {
    const AxisValues shown = state_ == State::Off ? here : place();
    settings_ = settings;
    lie_ = settings.lie;
    lies_aside_ = lie_ != path::Mat3::Identity();
    plane_ = plane;
    axes_ = path::axes_of(plane);
    distance_ = distance;
    here_ = meant_ = into_plane(here);
    shown_ = into_plane(shown);
    corners_ = path::RadiusComp(settings.corners);
    has_last_ = approaches_ = keeps_vector_ = is_paused_ = comes_back_ = is_let_go_ = false;
    open_approach_.reset();
    leave_direction_.reset();
    empty_blocks_ = 0;
    state_ = State::Starting;
}

/// The contour goes on from the same place of the part.
void Compensation::set_aside(const Vec2& aside) {
    if (is_on_contour()) set_in_plane(here_, in_plane(here_) + aside - aside_);
    aside_ = aside;
}

void Compensation::set_settings(const CompSettings& settings) {
    settings_ = settings;
    corners_.set_rules(settings.corners);
}

void Compensation::leave(const std::optional<Vec2>& direction, path::OpenEnd open_end) {
    settings_.corners.open_end = open_end;
    corners_.set_rules(settings_.corners);
    leave_direction_ = direction;
    is_paused_ = comes_back_ = false;
    state_ = state_ == State::On ? State::Leaving : State::Off;
}

std::optional<CompAlarm> Compensation::pause() {
    if (state_ != State::On || is_paused_) return std::nullopt;
    std::optional<CompAlarm> alarm = flush();
    is_paused_ = true;
    return alarm;
}

void Compensation::resume() {
    comes_back_ = is_paused_ || comes_back_;
    is_paused_ = false;
}

std::optional<CompAlarm> Compensation::let_go() {
    if (state_ != State::On || is_paused_) return std::nullopt;
    is_let_go_ = true;
    if (!has_last_) return flush();
    // The block of the last element waits for the corner at its end, with what stands behind it.
    const auto last = std::ranges::find(held_, elements_, &Held::index);
    if (last != held_.end()) {
        if (last_.is_arc())
            return CompAlarm{&diag::CompAnewOnArc, last->command.source, last->command.line};
        set_in_plane(last->command.to, in_plane(last->command.to) - aside_);
        last->is_departure = true;
    }
    return flush();
}

std::optional<CompAlarm> Compensation::begin_again() {
    if (state_ != State::On || !has_last_) return std::nullopt;
    is_let_go_ = true;
    return flush();
}

std::optional<CompAlarm> Compensation::stop() {
    std::optional<CompAlarm> alarm = flush();
    state_ = State::Off;
    return alarm;
}

void Compensation::begin_smooth_approach(Command motion) {
    motion = into_plane(std::move(motion));
    lead(motion);
    begin_approach(motion);
    goes_straight_ = true;
}

std::optional<CompAlarm> Compensation::round_corner(const Command& motion,
                                                    const std::optional<Vec2>& direction) {
    const CompAlarm missing{&diag::CompNoVector, motion.source, motion.line};
    if (state_ != State::On || !has_last_) return missing;
    if (!direction) {
        corners_.round_next_corner();
        return std::nullopt;
    }
    const Vec2 tangent = path::end_direction(last_);
    const double turn = std::atan2(tangent.x() * direction->y() - tangent.y() * direction->x(),
                                   tangent.dot(*direction));
    const Vec2 corner = last_.to;
    if (const Fault fault = finish()) return alarm(fault, motion);
    if (turn * distance_ > 0) return CompAlarm{&diag::CompCollision, motion.source, motion.line};
    if (std::abs(turn * distance_) < path::kSamePoint) return std::nullopt;
    const Vec2 from = in_plane(shown_);
    const Vec2 to = corner + Eigen::Rotation2D(turn) * (from - corner);
    emit_arc({motion, 0, 0, false}, {{from, to, corner, turn}, 0, true, 0, Vec2::Zero()});
    return std::nullopt;
}

std::optional<CompAlarm> Compensation::flush() {
    const Command nowhere;
    Fault fault = finish();
    if (std::exchange(cannot_orient_, false)) fault = &diag::CompTurnsInside;
    if (fault == nullptr) return std::nullopt;
    return alarm(fault, held_.empty() ? nowhere : held_.back().command);
}

/// The contour ends here, on its normal.
///
/// is_open  its last element may be left out, by the rules of the corners
Compensation::Fault Compensation::finish(const std::optional<Vec2>& direction, bool is_open) {
    const auto fault = direction ? corners_.finish_towards(*direction)
                       : is_open ? corners_.finish_open()
                                 : corners_.finish();
    if (fault) return row_of(*fault);
    emit_pieces();
    if (open_approach_) emit_approach(in_plane(open_approach_->command.to) - aside_);
    for (; !held_.empty(); held_.pop_front()) {
        // An approach to no contour at all goes where it is programmed; an element that the end
        // has left out goes nowhere.
        if (held_.front().index == 0) {
            emit_empty();
        } else if (!has_last_) {
            emit_line(held_.front(), in_plane(held_.front().command.to) - aside_, false);
        }
    }
    corners_ = path::RadiusComp(settings_.corners);
    has_last_ = approaches_ = false;
    return nullptr;
}

// ------------------------------------------------------------------------------ commands in

std::optional<CompAlarm> Compensation::end_block(const AxisValues& here, const nc::Block& block) {
    bool has_moved = false;
    for (std::size_t i = 0; i < fresh_.size(); ++i) {
        Command& command = fresh_[i];
        if (!command.machine_coordinates) command = into_plane(std::move(command));
        has_moved = has_moved || (path::is_motion(command.op) && moves_on(command));
        // Over a place to a place of the machine: the cutter leaves the contour on the way there.
        const bool leaves = state_ == State::On && path::is_motion(command.op) &&
                            !command.is_unshifted && i + 1 < fresh_.size() &&
                            fresh_[i + 1].is_unshifted;
        if (leaves) state_ = State::Leaving;
        const Command place = command;
        if (const Fault fault = take(command, here)) {
            fresh_.clear();
            return alarm(fault, place);
        }
        if (leaves) state_ = State::On;
    }
    fresh_.clear();
    if (std::exchange(cannot_orient_, false))
        return CompAlarm{&diag::CompTurnsInside, block.source, block.line};
    here_ = into_plane(here);
    if (is_on_contour()) lead(here_);
    keeps_vector_ = false;
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
    if (path::is_motion(command.op) && command.machine_coordinates) {
        // For this way the compensation is taken back, and it begins anew behind it. Across the
        // plane it is like blocks without motion there: the contour goes on from its normal.
        const bool crosses = (command.moved & (bit(axes_.first) | bit(axes_.second))) == 0;
        const bool stays = crosses && !lies_aside_ && !settings_.more_empty_is_fault;
        if (const Fault fault = finish()) return fault;
        if (state_ == State::On && !stays) state_ = State::Starting;
        const AxisValues stood = shown_;
        here_ = shown_ = into_plane(behind);
        if (!lies_aside_) {
            // Axes that it does not name stay where the cutter is.
            for (const Axis axis : {axes_.first, axes_.second}) {
                if ((command.moved & bit(axis)) == 0) command.to[index(axis)] = stood[index(axis)];
            }
            set_in_plane(shown_, in_plane(command.to));
        }
        meant_ = shown_;
        if (stays && state_ == State::On)
            set_in_plane(meant_, in_plane(into_plane(behind)) + aside_);
        settled_.push_back(std::move(command));
        return nullptr;
    }
    if (path::is_motion(command.op)) {
        const bool moves = moves_on(command);
        // The way to the contour ends on it; the way from it ends where it is programmed.
        const bool is_led = moves ? state_ != State::Leaving : is_on_contour();
        if (is_led) lead(command);
        if (moves) return take_motion(command);
    }
    if (path::is_motion(command.op) && !is_straight(command.op) && state_ != State::Starting)
        return &diag::CompMotion;
    if (path::is_motion(command.op)) here_ = command.to;
    held_.push_back({std::move(command), 0, 0, false});
    if (!approaches_ && !has_last_) emit_empty(), held_.pop_front();
    return nullptr;
}

Compensation::Fault Compensation::take_motion(Command& command) {
    if (is_paused_ && state_ == State::On) return follow_paused(command);
    if (!is_straight(command.op) && command.op != Op::Arc) return &diag::CompMotion;
    const double side = command.normal.dot(path::unit(axes_.normal));
    if (command.op == Op::Arc && std::abs(side) < 1 - 1e-9) return &diag::CompMotion;  // it tilts
    if (command.feed_mode == path::FeedMode::InverseTime && command.op != Op::Rapid) {
        if (!settings_.takes_inverse_time) return &diag::CompInverseTime;
        feed_along(command);
    }
    switch (state_) {
        case State::Starting: return approach(command);
        case State::Leaving: return depart(command);
        default: return keeps_vector_ ? follow_kept(command) : follow(command);
    }
}

/// An inverse time as the speed that it is along the programmed way.
void Compensation::feed_along(Command& command) const {
    const Element way = element_of(command);
    const double along =
        way.is_arc() ? path::radius(way) * std::abs(command.sweep) : (way.to - way.from).norm();
    const double across = command.to[index(axes_.normal)] - here_[index(axes_.normal)];
    command.feed *= std::hypot(along, across);
    command.feed_mode = path::FeedMode::PerMinute;
}

/// Beside the block before it ends on the normal, and this one is as far from its contour.
Compensation::Fault Compensation::follow_kept(Command& command) {
    if (!is_straight(command.op)) return &diag::CompMotion;
    if (approaches_) return &diag::CompNoVector;
    if (has_last_) {
        if (const Fault fault = finish()) return fault;
    }
    const Vec2 vector = in_plane(shown_) - in_plane(here_);
    const Vec2 to = in_plane(command.to) + vector;
    const AxisValues programmed = command.to;
    emit_line({std::move(command), 0, 0, false}, to, false);
    here_ = meant_ = programmed;
    return nullptr;
}

/// As it is programmed, so far beside as the contour before has ended.
Compensation::Fault Compensation::follow_paused(Command& command) {
    const Vec2 vector = in_plane(shown_) - in_plane(here_);
    const AxisValues to = command.to;
    set_in_plane(command.to, in_plane(command.to) + vector);
    command.center[static_cast<Eigen::Index>(index(axes_.first))] += vector.x();
    command.center[static_cast<Eigen::Index>(index(axes_.second))] += vector.y();
    put_beside(std::move(command), to);
    here_ = meant_ = to;
    return nullptr;
}

/// Behind a pause: from where the tool is to the normal at the start of the contour's element.
void Compensation::come_back(const Command& command, const Element& element) {
    comes_back_ = false;
    meant_ = here_;
    emit_line({command, 0, 0, false}, path::RadiusComp::start_of(element, distance_), true);
}

Compensation::Fault Compensation::approach(Command& command) {
    if (!is_straight(command.op)) return &diag::CompStartOnArc;
    if (keeps_vector_) return &diag::CompNoVector;
    if (is_curve(settings_.start) && command.op != Op::Line) return &diag::CompMotion;
    begin_approach(command);
    return nullptr;
}

void Compensation::begin_approach(Command& command) {
    here_ = command.to;
    held_.push_back({std::move(command), ++elements_, 0, false});
    approaches_ = true;
    approach_distance_ = distance_;
    goes_straight_ = is_let_go_ = false;
    state_ = State::On;
}

Compensation::Fault Compensation::follow(Command& command) {
    const Element element = element_of(command);
    const double before = has_last_ ? last_distance_ : approaches_ ? approach_distance_ : distance_;
    const bool has_changed = std::abs(distance_ - before) > path::kSamePoint;
    if (has_changed && element.is_arc() && settings_.radius_changes_in_lines)
        return &diag::CompRadiusOnArc;
    if (approaches_) {
        if (const Fault fault = enter(element, element.is_arc() ? distance_ : before)) return fault;
    }
    if (comes_back_) come_back(command, element);
    // On an arc the cutter cannot come straight to its end.
    if (std::exchange(is_let_go_, false) && element.is_arc()) return &diag::CompAnewOnArc;
    const double radius = element.is_arc() ? path::radius(element) : 0;
    last_distance_ = distance_;
    here_ = command.to;
    return push(element, {std::move(command), ++elements_, radius, false, settings_.feed});
}

/// The first element says where the approach ends: so far beside it.
Compensation::Fault Compensation::enter(const Element& first, double distance) {
    const double wanted = std::exchange(distance_, distance);
    const Fault fault = end_approach(first);
    distance_ = wanted;
    return fault;
}

Compensation::Fault Compensation::end_approach(const Element& first) {
    std::optional<Element> way;
    if (!goes_straight_) {
        if (const Fault fault = way_in(first, way)) return fault;
    }
    approaches_ = false;
    if (way) {
        if (const auto fault = corners_.push(*way, distance_, held_.front().index))
            return row_of(*fault);
        return nullptr;
    }
    const bool is_curved = is_curve(settings_.start) && !goes_straight_;
    if (settings_.corners.open_end != path::OpenEnd::None && !is_curved && !goes_straight_) {
        open_approach_ = std::move(held_.front());
        held_.pop_front();
        corners_.begin_open();
        return nullptr;
    }
    if (is_curved) {
        emit_curve_in(first);
    } else {
        emit_line(held_.front(), path::RadiusComp::start_of(first, distance_), false);
    }
    meant_ = held_.front().command.to;
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
    const Vec2 to = in_plane(command.to);
    std::optional<Element> way;
    // A direction that is said takes the place of the corner.
    if (has_last_ && !leave_direction_) {
        if (const Fault fault = retract_path(to, way)) return fault;
    }
    here_ = command.to;
    if (way) {
        if (const Fault fault = push(*way, {std::move(command), ++elements_, 0, true}))
            return fault;
        if (const Fault fault = finish()) return fault;
    } else {
        const bool has_contour = has_last_;
        if (const Fault fault = finish(leave_direction_, !is_curve(settings_.start))) return fault;
        if (!is_curve(settings_.start) || !has_contour) {
            emit_line({std::move(command), 0, 0, true}, to, false);
        } else if (command.op != Op::Line) {
            return &diag::CompMotion;
        } else {
            emit_curve_out(command);
        }
    }
    state_ = State::Off;
    return nullptr;
}

// ------------------------------------------------------------------------------ commands out

void Compensation::emit_pieces() {
    for (const CompPiece& piece : corners_.pieces()) {
        if (open_approach_) emit_approach(piece.element.from);
        emit(piece);
    }
    corners_.pieces().clear();
}

/// The way to the contour, of which is known now where it begins.
void Compensation::emit_approach(const Vec2& to) {
    const Held approach = *std::exchange(open_approach_, std::nullopt);
    emit_line(approach, to, false);
    meant_ = approach.command.to;
}

void Compensation::emit(const CompPiece& piece) {
    // Blocks without motion come before the corner, elements that were left out not at all.
    for (; held_.front().index != piece.index; held_.pop_front()) {
        if (held_.front().index == 0) emit_empty();
    }
    const Held& held = held_.front();
    const Element& way = piece.element;
    if (piece.weight > 0) return emit_conic(held, piece);
    if (!way.is_arc()) {
        const bool ends_there = held.is_departure && !piece.is_inserted;
        emit_line(held, ends_there ? in_plane(held.command.to) : way.to, piece.is_inserted);
    } else {
        const bool is_gap = (in_plane(shown_) - way.from).norm() > path::kSamePoint;
        if (is_gap) emit_line(held, way.from, true);
        if (held.command.op == Op::Rapid) emit_rapid_around(held, way);
        else emit_arc(held, piece);
    }
    if (piece.is_inserted) return;
    meant_ = held.command.to;
    held_.pop_front();
}

/// A block without motion in the plane: where the cutter stands now.
void Compensation::emit_empty() {
    Held& held = held_.front();
    if (!path::is_motion(held.command.op)) return settled_.push_back(std::move(held.command));
    const AxisValues to = held.command.to;
    set_in_plane(held.command.to, in_plane(shown_));
    put_beside(std::move(held.command), to);
    meant_ = to;
}

void Compensation::emit_line(const Held& held, const Vec2& to, bool is_inserted) {
    Command command = held.command;
    if (command.op == Op::Arc) command.op = Op::Line;
    if (is_inserted) {
        command.to = shown_;
        command.exact_stop = false;
        stand_tool(command);
    }
    set_in_plane(command.to, to);
    // What nothing is left of is no block: an exact stop has its corner.
    if (!is_same(command.to, shown_)) put_beside(std::move(command), held.command.to);
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
        stand_tool(command);
    } else if (held.radius > 0 && (held.feed == nc::CompFeed::Contour ||
                                   (held.feed == nc::CompFeed::Inside && radius < held.radius))) {
        command.feed *= radius / held.radius;
    }
    set_in_plane(command.to, arc.to);
    command.center[static_cast<Eigen::Index>(index(axes_.first))] = arc.center.x();
    command.center[static_cast<Eigen::Index>(index(axes_.second))] = arc.center.y();
    command.normal = path::unit(axes_.normal) * (arc.sweep > 0 ? 1 : -1);
    command.sweep = std::abs(arc.sweep) + 2 * pi * command.turns;
    command.is_clockwise = arc.sweep < 0;
    if (!piece.is_inserted) turn_along_arc(held, arc, command);
    put(std::move(command));
}

/// The tool that is led by a second point of its axis keeps its direction on an arc beside the
/// programmed one: about the same centre, of which corners have left a part.
void Compensation::turn_along_arc(const Held& held, const Element& arc, Command& command) const {
    if (command.turning != path::Turning::Point) return;
    const double radius = path::radius(arc);
    const double scale = radius > path::kSamePoint ? held.radius / radius : 0;
    shift_point({linear(meant_), linear(held.command.to), beside_center(arc, scale, shown_),
                 beside_center(arc, scale, command.to)},
                command);
    command.orient_outwards = held.radius - radius;
}

/// A place on the way beside an arc as it lies on the programmed one.
path::Vec3 Compensation::beside_center(const Element& arc, double scale,
                                       const AxisValues& at) const {
    AxisValues place = at;
    set_in_plane(place, arc.center + scale * (in_plane(at) - arc.center));
    return linear(place);
}

/// The arc about a corner that has been made more pointed; at rapid the tangents at its ends and at
/// its middle.
void Compensation::emit_conic(const Held& held, const CompPiece& piece) {
    const Vec2& to = piece.element.to;
    if (held.command.op == Op::Rapid) {
        const double sum = 1 + piece.weight;
        emit_line(held, (piece.element.from + piece.weight * piece.apex) / sum, true);
        emit_line(held, (to + piece.weight * piece.apex) / sum, true);
        return emit_line(held, to, true);
    }
    Command command = held.command;
    command.op = Op::Spline;
    command.to = shown_;
    command.exact_stop = false;
    stand_tool(command);
    AxisValues apex = shown_;
    set_in_plane(apex, piece.apex);
    command.spline.degree = 2;
    command.spline.inner[0] = path::Vec3(apex[0], apex[1], apex[2]);
    command.spline.weights = {1, piece.weight, 1, 1};
    set_in_plane(command.to, to);
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
    const AxisValues from = out_of_plane(std::exchange(shown_, command.to));
    if (!put_oriented(settings_.orientation_limits, from, out_of_plane(std::move(command)),
                      settled_))
        cannot_orient_ = true;
}

/// … that is no arc: from where the last one was programmed to end.
void Compensation::put_beside(Command command, const AxisValues& programmed_to) {
    shift_point({linear(meant_), linear(programmed_to), linear(shown_), linear(command.to)},
                command);
    put(std::move(command));
}

/// What a corner inserts the tool passes as it stands.
void Compensation::stand_tool(Command& command) const {
    if (settings_.orientation_limits.chain == nullptr || command.turning == path::Turning::None)
        return;
    const machine::Chain& chain = *settings_.orientation_limits.chain;
    command.turning = path::Turning::Axes;
    command.direction = lie_.transpose() * machine::tool_vector(chain, joints_at(chain, shown_));
}

Command Compensation::as_far_beside(Command command) const {
    const Vec2 beside = in_plane(shown_) - in_plane(meant_);
    set_in_plane(command.to, in_plane(command.to) + beside);
    command.center[static_cast<Eigen::Index>(index(axes_.first))] += beside.x();
    command.center[static_cast<Eigen::Index>(index(axes_.second))] += beside.y();
    return command;
}

// ------------------------------------------------------------------------------ the plane

bool Compensation::moves_in_plane(const Command& command) const {
    return command.op == Op::Arc ||
           (in_plane(command.to) - in_plane(here_)).norm() > path::kSamePoint;
}

/// The same of a command as it is programmed.
bool Compensation::moves_on(const Command& command) const {
    Command led = command;
    if (is_on_contour()) lead(led);
    return moves_in_plane(led);
}

void Compensation::lead(AxisValues& place) const { set_in_plane(place, in_plane(place) + aside_); }

void Compensation::lead(Command& command) const {
    lead(command.to);
    command.center[static_cast<Eigen::Index>(index(axes_.first))] += aside_.x();
    command.center[static_cast<Eigen::Index>(index(axes_.second))] += aside_.y();
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

AxisValues Compensation::into_plane(const AxisValues& base) const {
    if (!lies_aside_) return base;
    AxisValues values = base;
    turn(lie_.transpose(), values);
    return values;
}

AxisValues Compensation::out_of_plane(const AxisValues& values) const {
    if (!lies_aside_) return values;
    AxisValues base = values;
    turn(lie_, base);
    return base;
}

Command Compensation::into_plane(Command command) const {
    if (lies_aside_ && path::is_motion(command.op)) turn(lie_.transpose(), command);
    return command;
}

Command Compensation::out_of_plane(Command command) const {
    if (!lies_aside_ || !path::is_motion(command.op)) return command;
    turn(lie_, command);
    command.moved |= kLinearXYZ;
    return command;
}

Vec2 Compensation::in_plane(const AxisValues& values) const {
    return {values[index(axes_.first)], values[index(axes_.second)]};
}

void Compensation::set_in_plane(AxisValues& values, const Vec2& at) const {
    values[index(axes_.first)] = at.x();
    values[index(axes_.second)] = at.y();
}

}  // namespace kadr::interp
