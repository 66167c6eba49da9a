#include "interp/compensation.h"

#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "base/diagnostics/iso.h"
#include "interp/compensation_paths.h"

namespace kadr::interp {

using path::Command;
using path::CompFault;
using path::Element;
using path::is_straight;
using path::Op;
using path::Vec2;

namespace {

bool is_curve(nc::CompStart start) {
    return start == nc::CompStart::Tangent || start == nc::CompStart::Smooth;
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

const DiagnosticRow* row_of(CompPathFault fault) {
    switch (fault) {
        case CompPathFault::Blocked: break;
    }
    return &diag::CompStartBlocked;
}

}  // namespace

// ------------------------------------------------------------------------------ on and off

void Compensation::begin(const CompSettings& settings, path::Plane plane, double distance,
                         const AxisValues& here) {
    const AxisValues cutter = state_ == State::Off ? here : position();
    const CompPlane in_it(plane, settings.lie);
    settings_ = settings;
    distance_ = distance;
    here_ = in_it.into(here);
    cutter_.begin(in_it, in_it.into(cutter), here_);
    cutter_.set_orientation_limits(settings.orientation_limits);
    contour_.restart(settings.corners);
    approach_.reset();
    keeps_vector_ = is_paused_ = comes_back_ = is_let_go_ = false;
    leave_direction_.reset();
    empty_blocks_ = 0;
    state_ = State::Starting;
}

/// The contour goes on from the same point of the part.
void Compensation::set_aside(const Vec2& aside) {
    if (is_on_contour()) in_plane().set_point(here_, in_plane().point(here_) + aside - aside_);
    aside_ = aside;
}

void Compensation::set_settings(const CompSettings& settings) {
    settings_ = settings;
    cutter_.set_orientation_limits(settings.orientation_limits);
    contour_.set_rules(settings.corners);
}

void Compensation::leave(const std::optional<Vec2>& direction, path::OpenEnd open_end) {
    settings_.corners.open_end = open_end;
    contour_.set_rules(settings_.corners);
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
    // The block of the last element waits for the corner at its end, with what stands behind it.
    if (const Command* const last = contour_.command_of_last()) {
        if (contour_.last()->element.is_arc())
            return CompAlarm{&diag::CompAnewOnArc, last->source, last->line};
        AxisValues programmed = last->motion().to;
        in_plane().shift(programmed, -aside_);
        contour_.end_last_at(programmed);
    }
    return flush();
}

std::optional<CompAlarm> Compensation::begin_again() {
    if (state_ != State::On || !contour_.last()) return std::nullopt;
    is_let_go_ = true;
    return flush();
}

std::optional<CompAlarm> Compensation::stop() {
    std::optional<CompAlarm> alarm = flush();
    state_ = State::Off;
    return alarm;
}

void Compensation::begin_smooth_approach(Command motion) {
    motion = in_plane().into(std::move(motion));
    in_plane().shift(motion.motion(), aside_);
    begin_approach(motion, true);
}

std::optional<CompAlarm> Compensation::round_corner(const Command& motion,
                                                    const std::optional<Vec2>& direction) {
    const CompAlarm missing{&diag::CompNoVector, motion.source, motion.line};
    if (state_ != State::On || !contour_.last()) return missing;
    if (!direction) {
        contour_.round_next_corner();
        return std::nullopt;
    }
    const Element& last = contour_.last()->element;
    const Vec2 tangent = path::end_direction(last);
    const double turn = std::atan2(tangent.x() * direction->y() - tangent.y() * direction->x(),
                                   tangent.dot(*direction));
    const Vec2 corner = last.to;
    if (const Fault fault = finish()) return alarm(fault, motion);
    if (turn * distance_ > 0) return CompAlarm{&diag::CompCollision, motion.source, motion.line};
    if (std::abs(turn * distance_) < path::kSamePoint) return std::nullopt;
    const Vec2 from = cutter_.point();
    const Vec2 to = corner + Eigen::Rotation2D(turn) * (from - corner);
    cutter_.insert_arc({motion}, {from, to, corner, turn});
    return std::nullopt;
}

std::optional<CompAlarm> Compensation::flush() {
    Fault fault = finish();
    if (cutter_.take_orientation_fault()) fault = &diag::CompTurnsInside;
    if (fault == nullptr) return std::nullopt;
    const Command* const newest = contour_.newest();
    return alarm(fault, newest != nullptr ? *newest : Command{});
}

/// The contour ends here, on its normal.
///
/// is_open  its last element may be left out, by the rules of the corners
Compensation::Fault Compensation::finish(const std::optional<Vec2>& direction, bool is_open) {
    if (const auto fault = contour_.finish({direction, is_open, aside_}, cutter_))
        return row_of(*fault);
    contour_.restart(settings_.corners);
    approach_.reset();
    return nullptr;
}

// ------------------------------------------------------------------------------ commands in

std::optional<CompAlarm> Compensation::end_block(const AxisValues& here, const nc::Block& block) {
    bool has_moved = false;
    for (std::size_t i = 0; i < fresh_.size(); ++i) {
        Command& command = fresh_[i];
        if (command.is_motion() && !command.motion().machine_coordinates)
            command = in_plane().into(std::move(command));
        has_moved = has_moved || (command.is_motion() && moves_on(command.motion()));
        // Over a position to a position of the machine: the cutter leaves the contour on its path.
        const bool leaves = state_ == State::On && command.is_motion() && !command.is_unshifted &&
                            i + 1 < fresh_.size() && fresh_[i + 1].is_unshifted;
        if (leaves) state_ = State::Leaving;
        const Command place = command;
        if (const Fault fault = take(command, here)) {
            fresh_.clear();
            return alarm(fault, place);
        }
        if (leaves) state_ = State::On;
    }
    fresh_.clear();
    if (cutter_.take_orientation_fault())
        return CompAlarm{&diag::CompTurnsInside, block.source, block.line};
    here_ = in_plane().into(here);
    if (is_on_contour()) in_plane().shift(here_, aside_);
    keeps_vector_ = false;
    if (has_moved || !contour_.last()) {
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
    const Command* const at_fault = contour_.at_fault();
    const bool is_corner = fault == &diag::CompCollision || fault == &diag::CompNoIntersection ||
                           fault == &diag::CompArcTooSmall;
    if (!is_corner || at_fault == nullptr) return {fault, command.source, command.line};
    return {fault, at_fault->source, at_fault->line};
}

Compensation::Fault Compensation::take(Command& command, const AxisValues& behind) {
    const bool is_motion = command.is_motion();
    if (is_motion && command.motion().machine_coordinates)
        return take_in_machine_coordinates(command, behind);
    if (is_motion) {
        const bool moves = moves_on(command.motion());
        // The path to the contour ends on it; the path from it ends where it is programmed.
        const bool is_led = moves ? state_ != State::Leaving : is_on_contour();
        if (is_led) in_plane().shift(command.motion(), aside_);
        if (moves) return take_motion(command);
    }
    if (is_motion && !is_straight(command.op()) && state_ != State::Starting)
        return &diag::CompMotion;
    if (is_motion) here_ = command.motion().to;
    if (approach_ || contour_.last()) contour_.wait(std::move(command));
    else cutter_.put_standing(std::move(command));
    return nullptr;
}

/// For this motion the compensation is taken back, and it begins anew behind it. Across the plane
/// it is like blocks without motion there: the contour goes on from its normal.
Compensation::Fault Compensation::take_in_machine_coordinates(Command& command,
                                                              const AxisValues& behind) {
    path::Motion& motion = command.motion();
    const bool crosses = (motion.moved & in_plane().mask()) == 0;
    const bool stays = crosses && !in_plane().is_tilted() && !settings_.more_empty_is_fault;
    if (const Fault fault = finish()) return fault;
    if (state_ == State::On && !stays) state_ = State::Starting;
    here_ = in_plane().into(behind);
    AxisValues position = here_;
    if (!in_plane().is_tilted()) {
        // Axes that it does not name stay where the cutter is.
        const path::PlaneAxes& axes = in_plane().axes();
        for (const Axis axis : {axes.first, axes.second}) {
            if ((motion.moved & bit(axis)) == 0)
                motion.to[index(axis)] = cutter_.position()[index(axis)];
        }
        in_plane().set_point(position, in_plane().point(motion.to));
    }
    AxisValues programmed = position;
    if (stays && state_ == State::On)
        in_plane().set_point(programmed, in_plane().point(here_) + aside_);
    cutter_.stand_at(position, programmed);
    cutter_.pass(std::move(command));
    return nullptr;
}

Compensation::Fault Compensation::take_motion(Command& command) {
    if (is_paused_ && state_ == State::On) return follow_paused(command);
    path::Motion& motion = command.motion();
    if (motion.op() == Op::Arc) {
        const double side = motion.arc().normal.dot(path::unit(in_plane().axes().normal));
        if (std::abs(side) < 1 - 1e-9) return &diag::CompMotion;  // it tilts
    } else if (!is_straight(motion.op())) {
        return &diag::CompMotion;
    }
    if (motion.feed_mode == path::FeedMode::InverseTime && motion.op() != Op::Rapid) {
        if (!settings_.takes_inverse_time) return &diag::CompInverseTime;
        feed_along(motion);
    }
    switch (state_) {
        case State::Starting: return approach(command);
        case State::Leaving: return depart(command);
        default: return keeps_vector_ ? follow_kept(command) : follow(command);
    }
}

/// An inverse time as the speed that it is along the programmed path.
void Compensation::feed_along(path::Motion& motion) const {
    const Element element = element_of(motion);
    const double along = element.is_arc() ? path::radius(element) * std::abs(motion.arc().sweep)
                                          : (element.to - element.from).norm();
    const std::size_t normal = index(in_plane().axes().normal);
    const double across = motion.to[normal] - here_[normal];
    motion.feed *= std::hypot(along, across);
    motion.feed_mode = path::FeedMode::PerMinute;
}

/// Beside the block before it ends on the normal, and this one is as far from its contour.
Compensation::Fault Compensation::follow_kept(Command& command) {
    if (!is_straight(command.op())) return &diag::CompMotion;
    if (approach_) return &diag::CompNoVector;
    if (contour_.last()) {
        if (const Fault fault = finish()) return fault;
    }
    const Vec2 vector = cutter_.point() - in_plane().point(here_);
    const Vec2 to = in_plane().point(command.motion().to) + vector;
    here_ = command.motion().to;
    cutter_.put_line({std::move(command)}, to);
    cutter_.set_programmed(here_);
    return nullptr;
}

/// As it is programmed, so far beside as the contour before has ended.
Compensation::Fault Compensation::follow_paused(Command& command) {
    const Vec2 vector = cutter_.point() - in_plane().point(here_);
    here_ = command.motion().to;
    in_plane().shift(command.motion(), vector);
    cutter_.put_beside(std::move(command), here_);
    cutter_.set_programmed(here_);
    return nullptr;
}

/// Behind a pause: from where the tool is to the normal at the start of the contour's element.
void Compensation::come_back(const Command& command, const Element& element) {
    comes_back_ = false;
    cutter_.set_programmed(here_);
    cutter_.insert_line({command}, path::RadiusComp::start_of(element, distance_));
}

// ------------------------------------------------------------------------------ the contour

Compensation::Fault Compensation::approach(Command& command) {
    if (!is_straight(command.op())) return &diag::CompStartOnArc;
    if (keeps_vector_) return &diag::CompNoVector;
    if (is_curve(settings_.start) && command.op() != Op::Line) return &diag::CompMotion;
    begin_approach(command, false);
    return nullptr;
}

void Compensation::begin_approach(Command& command, bool is_straight) {
    here_ = command.motion().to;
    contour_.wait_for_first(std::move(command));
    approach_ = Approach{distance_, is_straight};
    is_let_go_ = false;
    state_ = State::On;
}

Compensation::Fault Compensation::follow(Command& command) {
    const Element element = element_of(command.motion());
    const double before = contour_.last() ? contour_.last()->distance
                          : approach_     ? approach_->distance
                                          : distance_;
    const bool has_changed = std::abs(distance_ - before) > path::kSamePoint;
    if (has_changed && element.is_arc() && settings_.radius_changes_in_lines)
        return &diag::CompRadiusOnArc;
    if (approach_) {
        // The first element tells where the approach ends: so far beside it.
        const double distance = element.is_arc() ? distance_ : before;
        if (const Fault fault = end_approach(element, distance)) return fault;
    }
    if (comes_back_) come_back(command, element);
    // On an arc the cutter cannot come straight to its end.
    if (std::exchange(is_let_go_, false) && element.is_arc()) return &diag::CompAnewOnArc;
    const double radius = element.is_arc() ? path::radius(element) : 0;
    here_ = command.motion().to;
    return push(element, {std::move(command), radius, false, settings_.feed});
}

Compensation::Fault Compensation::end_approach(const Element& first, double distance) {
    const bool is_straight = approach_->is_straight;
    std::optional<Element> element;
    if (!is_straight) {
        // From the other side of the contour the path is straight, whatever the corner.
        const bool is_beside = cutter_.beside().norm() > path::kSamePoint;
        const bool is_direct = is_beside && settings_.start == nc::CompStart::Extended;
        const auto found = approach_element(is_direct ? nc::CompStart::Normal : settings_.start,
                                            first, cutter_.point(), distance);
        if (!found) return row_of(found.error());
        element = *found;
    }
    approach_.reset();
    if (element) {
        const auto fault = contour_.push_approach(*element, distance);
        return fault ? row_of(*fault) : nullptr;
    }
    const bool is_curved = is_curve(settings_.start) && !is_straight;
    if (settings_.corners.open_end != path::OpenEnd::None && !is_curved && !is_straight)
        contour_.open_approach();
    else lead_approach(first, distance, is_curved);
    return nullptr;
}

/// To the normal at the start of the first element.
void Compensation::lead_approach(const Element& first, double distance, bool is_curved) {
    const CutterMotion motion = contour_.take_approach();
    const Vec2 to = path::RadiusComp::start_of(first, distance);
    const auto curve = is_curved ? curve_in(settings_.start, cutter_.point(), first, distance)
                                 : std::optional<EndCurve>{};
    if (curve) cutter_.put_curve(motion, to, *curve);
    else cutter_.put_line(motion, to);
    cutter_.set_programmed(motion.command.motion().to);
}

Compensation::Fault Compensation::push(const Element& element, CutterMotion motion) {
    empty_blocks_ = 0;
    if (const auto fault = contour_.push(element, distance_, std::move(motion)))
        return row_of(*fault);
    contour_.release(cutter_);
    return nullptr;
}

Compensation::Fault Compensation::depart(Command& command) {
    if (!is_straight(command.op())) return &diag::CompEndOnArc;
    std::optional<Element> element;
    // A direction that is programmed takes the place of the corner.
    if (contour_.last() && !leave_direction_) {
        const auto found = retract_element(settings_.start, contour_.last()->element,
                                           in_plane().point(command.motion().to), distance_);
        if (!found) return row_of(found.error());
        element = *found;
    }
    here_ = command.motion().to;
    if (element) {
        if (const Fault fault = push(*element, {std::move(command), 0, true})) return fault;
        if (const Fault fault = finish()) return fault;
    } else if (const Fault fault = depart_from_end(command)) {
        return fault;
    }
    state_ = State::Off;
    return nullptr;
}

/// The contour ends before this motion, which is no element of it.
Compensation::Fault Compensation::depart_from_end(Command& command) {
    const bool is_curved = is_curve(settings_.start);
    const std::optional<CompensatedContour::Last> last = contour_.last();
    if (const Fault fault = finish(leave_direction_, !is_curved)) return fault;
    std::optional<EndCurve> curve;
    const Vec2 to = in_plane().point(command.motion().to);
    if (is_curved && last) {
        if (command.op() != Op::Line) return &diag::CompMotion;
        curve = curve_out(settings_.start, path::line_element(cutter_.point(), to), last->element,
                          distance_);
    }
    const CutterMotion motion{std::move(command), 0, true};
    if (curve) cutter_.put_curve(motion, to, *curve);
    else cutter_.put_line(motion, to);
    return nullptr;
}

/// In the plane, led along the contour as it will be.
bool Compensation::moves_on(const path::Motion& motion) const {
    Vec2 to = in_plane().point(motion.to);
    if (is_on_contour()) to += aside_;
    return motion.op() == Op::Arc || (to - in_plane().point(here_)).norm() > path::kSamePoint;
}

Element Compensation::element_of(const path::Motion& motion) const {
    return in_plane().element_of(motion, in_plane().point(here_));
}

}  // namespace kadr::interp
