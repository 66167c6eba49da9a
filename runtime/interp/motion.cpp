// motion.cpp — where a block goes: targets, lines, arcs, tool length and limits.
#include <algorithm>
#include <bit>
#include <cmath>

#include <Eigen/Geometry>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "interp/executor.h"
#include "machine/tilted_plane.h"
#include "path/helix.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Slot;
using nc::SlotMask;
using path::Command;
using path::FeedMode;
using path::Op;
using path::SpindleMode;
using path::Vec3;

namespace {

constexpr SlotMask kArcSlots = nc::kArcSlots | nc::kThroughSlots | bit(Slot::Opening);

bool is_involute(Function motion) {
    return motion == Function::InvoluteCw || motion == Function::InvoluteCcw;
}

/// Motions of which the words of an arc say something.
bool is_circle(Function motion) {
    return is_arc(motion) || is_involute(motion) || motion == Function::ArcThrough ||
           motion == Function::ArcTangent;
}

/// Rounding of the text and of frames: an axis may stand this far behind its limit.
constexpr double kLimitSlack = 1e-6;  // mm, deg

Vec3 linear(const AxisValues& values) { return {values[0], values[1], values[2]}; }

Slot first_slot(SlotMask slots) { return static_cast<Slot>(std::countr_zero(slots)); }

path::Plane plane_with_normal(Axis axis) {
    switch (axis) {
        case Axis::X: return path::Plane::Yz;
        case Axis::Y: return path::Plane::Zx;
        default: return path::Plane::Xy;
    }
}

std::string_view slot_word(Slot slot) {
    switch (slot) {
        case Slot::CenterX: return "I";
        case Slot::CenterY: return "J";
        case Slot::CenterZ: return "K";
        case Slot::Radius: return "radius";
        case Slot::Turns: return "turns";
        default: return nc::slot_name(slot);
    }
}

/// Motions on which the tool may turn as its words say.
bool takes_tool_words(Function motion) {
    return motion == Function::Rapid || motion == Function::Line || is_arc(motion) ||
           motion == Function::ArcThrough || motion == Function::ArcTangent;
}

path::Curve straight_way(const Vec3& from, const Vec3& to) {
    constexpr double kStill = 1e-9;  // mm: the rounding of frames
    if ((to - from).norm() <= kStill) return path::Point{from};
    return path::make_line(from, to);
}

/// How much longer the way of a helix is than the arc that it is over.
double length_by_arc(const path::Arc& arc) {
    const double height = arc.normal.dot(arc.end - arc.start);
    const Vec3 to = arc.end - arc.center - height * arc.normal;
    const double radius = ((arc.start - arc.center).norm() + to.norm()) / 2;
    return std::hypot(radius * arc.sweep, height) / (radius * arc.sweep);
}

}  // namespace

void Executor::move(const Block& block, const Actions& actions) {
    if (block.motion != Function::None) {
        modal_.motion = block.motion;
        taps_rigidly_ &= !modal_cycle_.is_active;
        modal_cycle_.is_active = false;  // a motion code ends a modal cycle
    }
    const SlotMask targets = block.given & nc::kTargetSlots;
    SlotMask arc_words = block.given & kArcSlots;
    // They have told where the compensation ends.
    if (arc_words != 0 && leave_direction(block)) arc_words &= ~nc::kCenterSlots;
    if (actions.soft != nullptr &&
        (space_comp_.is_on() || comp_.chosen() != Function::CompInPlane)) {
        report(diag::CompSpaceStart, block, actions.soft->function);
        return;
    }
    if (actions.soft != nullptr) {
        return actions.soft->function == Function::SoftApproach ? approach_softly(block, actions)
                                                                : retract_softly(block, actions);
    }
    if (actions.reference != nullptr) return refer(block, *actions.reference);
    if (actions.measure != nullptr) return measure_length(block, *actions.measure);
    if (actions.probes && comp_.side != Function::RadiusCompOff) {
        report(diag::ProbeCompensated, block, Function::Probe);
        return;
    }
    const bool is_in_cycle = modal_cycle_.is_active || actions.cycle != nullptr;
    if (is_in_cycle && targets != 0 && (actions.machine_coordinates || actions.probes)) {
        const Function own = actions.probes ? Function::Probe : Function::MachineCoordinates;
        report(diag::MotionInCycle, block, own).arg(nc::info(own).name);
        return;
    }
    if (actions.calls_behind_motions) {
        call_behind_motions_.reset();
        if (actions.cycle != nullptr) call_behind_motions_ = block;
        return;
    }
    if (actions.cycle_is_cancelled) return move_instead_of_cycle(block, actions);
    if (actions.cycle != nullptr) return call_cycle(block, actions);
    constexpr SlotMask kCycleSlots = nc::kTargetSlots | bit(Slot::Radius);
    if (modal_cycle_.is_active && (block.given & kCycleSlots) != 0)
        return repeat_cycle(block, actions);
    if (!check_rigid_tap(block, targets)) return;
    if (actions.orient_reset != nullptr) return reset_orientation(block, *actions.orient_reset);
    if (actions.tool.is_any() && !takes_tool_words(modal_.motion)) {
        report(diag::IsoNotSupported, block).arg("a tool that turns beside a spline or a thread");
        return;
    }
    if (modal_.motion == Function::Spline && !actions.machine_coordinates &&
        (targets != 0 || block.find(Function::SplineKnot) != nullptr))
        return spline(block);
    const bool goes_through =
        modal_.motion == Function::AkimaSpline || modal_.motion == Function::CubicSpline;
    if (goes_through && !actions.machine_coordinates && targets != 0)
        return go_through(block, targets);
    const bool has_polynomial = targets != 0 || block.find(Function::PolynomialAxis) != nullptr;
    if (modal_.motion == Function::Polynomial && !actions.machine_coordinates && has_polynomial)
        return polynomial(block, modal_.has_exact_stop || actions.exact_stop);
    if (targets == 0 && !actions.tool.turns() && (arc_words == 0 || !is_circle(modal_.motion))) {
        if (arc_words != 0) warn_arc_word(block, arc_words);
        if (actions.switches_length) return move_behind_switch(block);
        if (actions.length_changed) move_length_alone(block);
        return;
    }
    if (!check_axes(block, targets) || !check_rotary_ways(block)) return;
    if (actions.at_rapid && refuses_lone_axis(block, targets)) return;
    if ((unplaced_ & targets) != 0) [[unlikely]]
        check_place(block, targets);
    if (actions.machine_coordinates) return move_in_machine_coordinates(block);

    Target target = target_of(block, targets);
    if (orienting_.is_on && !orient(block, actions, target)) return;
    if (comp_.takes_faces() && !lay_face(block, actions.tool)) return;
    if (tilting_.carries || tilting_.on_tables) {
        // In the base system every linear axis may move, whatever the block names.
        target.moved = static_cast<AxisMask>(target.moved | (axes_ & kLinearXYZ));
        check_carried(block);
    }
    if (actions.way_offset != 0 && !offset_ways(block, actions.way_offset, target)) return;
    const bool exact_stop = modal_.has_exact_stop || actions.exact_stop;
    if (actions.at_rapid && comp_.side != Function::RadiusCompOff &&
        (targets & plane_mask()) != 0) {
        report(diag::CompMotion, block);
        return;
    }
    if (actions.suspends_length) return move_without_length(block, target, exact_stop);
    if (actions.at_rapid) return line(block, target, Op::Rapid, true);
    if (actions.taps) return line(block, target, Op::Line, exact_stop);
    if (actions.probes) return line(block, target, Op::Probe, true);
    if (modal_.motion == Function::Thread || is_varying_thread(modal_.motion))
        return thread(block, target, actions);
    if (is_arc_thread(modal_.motion)) return thread_along_arc(block, target, actions);
    if (is_involute(modal_.motion)) return involute(block, target, exact_stop);
    if (is_tapping(modal_.motion)) return tap(block, target);
    if (is_arc(modal_.motion)) return arc(block, target, exact_stop);
    if (modal_.motion == Function::ArcThrough) return arc_over_point(block, target, exact_stop);
    if (modal_.motion == Function::ArcTangent) return arc_along(block, target, exact_stop);
    if (arc_words != 0 && !wish_square_corner(block, target)) warn_arc_word(block, arc_words);
    if (ended_) return;
    line(block, target, modal_.motion == Function::Rapid ? Op::Rapid : Op::Line, exact_stop);
}

AxisMask Executor::plane_mask() const {
    const path::PlaneAxes axes = path::axes_of(modal_.plane);
    return static_cast<AxisMask>(1u << index(axes.first) | 1u << index(axes.second));
}

/// The first motion behind the end of a rotation.
void Executor::check_place(const Block& block, SlotMask targets) {
    const SlotMask distances = modal_.is_incremental ? ~block.absolute : block.incremental;
    if ((distances & targets & unplaced_) != 0) report(diag::IncrementBehindRotation, block);
    unplaced_ = 0;
}

Target Executor::target_of(const Block& block, SlotMask targets) const {
    Target target{position_.here, position_.base, static_cast<AxisMask>(targets)};
    const SlotMask incremental = modal_.is_incremental ? ~block.absolute : block.incremental;
    const AxisValues& last = rules_.incremental_frame == IncrementalFrame::Traversed
                                 ? position_.programmed
                                 : position_.here;
    const AxisValues& shift = frames_.shift_values();
    for (SlotMask rest = targets; rest != 0; rest &= rest - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(rest));
        const bool is_distance = (incremental >> i & 1u) != 0;
        double value = block.values[i] * (i == 0 ? x_scale(block, is_distance) : word_scale_[i]);
        if (is_distance) value += last[i];
        target.here[i] = value;
        target.base[i] = value + shift[i];
    }
    if (block.rotary_ways != 0) turn_rotary(block, target);
    if (!frames_.is_shift()) target.base = frames_.to_base(target.here);
    return target;
}

/// What a word for X is multiplied with: half a diameter is a radius.
double Executor::x_scale(const Block& block, bool is_distance) const {
    switch (block.x_measure) {
        case nc::XMeasure::Diameter: return 0.5;
        case nc::XMeasure::Radius: return 1;
        case nc::XMeasure::Modal: break;
    }
    return diameter_is_absolute_ && is_distance ? 1 : word_scale_[index(Axis::X)];
}

/// Places of rotary axes whose direction is said lie within one turn.
bool Executor::check_rotary_ways(const Block& block) {
    if (block.rotary_ways == 0) return true;
    for (const Axis axis : {Axis::A, Axis::B, Axis::C}) {
        const nc::RotaryWay way = block.rotary_way(axis);
        const double place = block.at(nc::slot_of(axis));
        const bool is_free = way == nc::RotaryWay::AsProgrammed || way == nc::RotaryWay::Shortest;
        if (is_free || (place >= 0 && place < 360)) continue;
        report(diag::RotaryRange, block, nc::slot_of(axis)).arg(place);
        return false;
    }
    return true;
}

/// Rotary axes go to a place of their turn on the way that the word says.
void Executor::turn_rotary(const Block& block, Target& target) const {
    for (const Axis axis : {Axis::A, Axis::B, Axis::C}) {
        const nc::RotaryWay way = block.rotary_way(axis);
        if (way == nc::RotaryWay::AsProgrammed || !block.has(nc::slot_of(axis))) continue;
        const std::size_t i = index(axis);
        double turn = std::fmod(block.values[i] - position_.here[i], 360);
        if (way == nc::RotaryWay::Shortest) turn = std::remainder(turn, 360);
        if (way == nc::RotaryWay::Positive && turn < 0) turn += 360;
        if (way == nc::RotaryWay::Negative && turn > 0) turn -= 360;
        target.here[i] = position_.here[i] + turn;
        target.base[i] = target.here[i] + frames_.shift_values()[i];
    }
}

void Executor::arrive(const Target& target) {
    const Vec3 before = linear(position_.base);
    if (before != linear(target.base)) came_from_ = before;
    position_.here = target.here;
    position_.base = target.base;
    for (AxisMask rest = target.moved; rest != 0; rest = static_cast<AxisMask>(rest & (rest - 1))) {
        const auto i = static_cast<std::size_t>(std::countr_zero(rest));
        position_.programmed[i] = target.here[i];
    }
}

// ------------------------------------------------------------------------------ lines

void Executor::line(const Block& block, const Target& programmed, Op op, bool exact_stop) {
    Target target = programmed;
    if (op == Op::Line && !check_feed(block, "line")) return;
    if (op == Op::Probe && !check_probe(block)) return;
    if (op == Op::Rapid) check_rapid(block, target);
    if (tool_.has_changed) activate_length(block, target.moved);
    if (course_ &&
        !lay_course(block, straight_way(linear(position_.base), linear(target.base)), target))
        return;
    if (!check_limits(block, target.base, target.moved)) return;
    has_moved_ = true;
    Command& command = put(op, block);
    command.to = target.base;
    command.moved = target.moved;
    command.exact_stop = exact_stop;
    command.feed = op == Op::Rapid ? 0 : modal_.feed;
    command.keeps_feed = op == Op::Line && block.find(Function::TapFloating) != nullptr;
    arrive(target);
    if (op != Op::Probe) return;
    probed_.emplace();
    probed_->tip = position_.here;
    for (std::size_t i = 0; i < kAxes; ++i) {
        probed_->head[i] = *place_of(nc::Quantity::HeadPosition, static_cast<Axis>(i));
        probed_->machine[i] = *place_of(nc::Quantity::MachinePosition, static_cast<Axis>(i));
    }
}

/// Machine coordinates are coordinates of the spindle nose: neither frames nor, on most controls,
/// the tool length act.
void Executor::move_in_machine_coordinates(const Block& block) {
    if (is_transformed()) {
        report(diag::TransformationMotion, block, Function::MachineCoordinates)
            .arg("a place in machine coordinates");
        return;
    }
    if (rules_.machine_coordinates_need_absolute && modal_.is_incremental) {
        report(diag::MachineCoordinatesIgnored, block, Function::MachineCoordinates);
        return;
    }
    if (is_arc(modal_.motion) && !rules_.machine_coordinates_rapid) {
        report(diag::ArcInMachineCoordinates, block, Function::MachineCoordinates);
        return;
    }
    if (frames_.has_base()) {
        report(diag::IsoNotSupported, block, Function::MachineCoordinates)
            .arg("machine coordinates while a base frame acts");
        return;
    }
    const bool is_rapid = rules_.machine_coordinates_rapid || modal_.motion == Function::Rapid;
    if (!is_rapid && !check_feed(block, "line")) return;

    const SlotMask targets = block.given & nc::kTargetSlots;
    if (rules_.machine_coordinates_keep_length && tool_.has_changed) {
        activate_length(block, static_cast<AxisMask>(targets));
    }
    const AxisValues length = rules_.machine_coordinates_keep_length ? AxisValues{} : length_shift_;
    AxisValues to = position_.base;
    for (std::size_t i = 0; i < kAxes; ++i) to[i] += length[i];
    const SlotMask incremental = modal_.is_incremental ? ~block.absolute : block.incremental;
    for (SlotMask rest = targets; rest != 0; rest &= rest - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(rest));
        const double value = block.values[i] * word_scale_[i];
        to[i] = (incremental >> i & 1u) != 0 ? to[i] + value : value;
    }
    Target target{{}, to, static_cast<AxisMask>(targets)};
    for (std::size_t i = 0; i < kAxes; ++i) target.base[i] -= length[i];
    target.here = frames_.from_base(target.base);
    if (!check_limits(block, target.base, target.moved)) return;

    Command& command = put(is_rapid ? Op::Rapid : Op::Line, block);
    command.to = to;
    command.moved = target.moved;
    // Without a tool length in force the tip and the machine have the same coordinates.
    command.machine_coordinates =
        !rules_.machine_coordinates_keep_length || length_shift_ == AxisValues{};
    command.is_unshifted = true;
    command.exact_stop = true;
    command.feed = is_rapid ? 0 : modal_.feed;
    arrive(target);
}

/// To a place in machine coordinates, `to` of all axes; `moved` are the ones that it names.
void Executor::rapid_to_machine_position(const Block& block, const AxisValues& to, AxisMask moved) {
    Target target{{}, to, moved};
    for (std::size_t i = 0; i < kAxes; ++i) target.base[i] -= length_shift_[i];
    target.here = frames_.from_base(target.base);
    if (!check_machine_limits(block, target.base, target.moved)) return;
    Command& command = put(Op::Rapid, block);
    command.to = to;
    command.moved = moved;
    command.machine_coordinates = true;
    command.is_unshifted = true;
    command.exact_stop = true;
    command.feed = 0;
    arrive(target);
}

/// A way to a reference point, or from there; none of them stands among the holes of a cycle.
void Executor::refer(const Block& block, const nc::Invocation& invocation) {
    if (is_transformed()) {
        const bool is_fixed =
            invocation.function == Function::ReferencePoint && block.argument(invocation, 0, 1) > 1;
        if (is_fixed) {
            report(diag::TransformationMotion, block, invocation.function).arg("a fixed point");
        } else {
            report(diag::TransformationReference, block, invocation.function);
        }
        return;
    }
    if (modal_cycle_.is_active) {
        report(diag::ReferenceInCycle, block, invocation.function);
        return;
    }
    switch (invocation.function) {
        case Function::ReferenceCheck: return check_reference(block);
        case Function::ReferenceLeave: return leave_reference(block);
        default: return return_to_reference(block, invocation);
    }
}

/// To the programmed place, which must be the reference point of the axes that are named.
void Executor::check_reference(const Block& block) {
    constexpr double kWidth = 0.0005;  // mm, deg: half an increment
    const SlotMask targets = block.given & nc::kTargetSlots;
    if (targets == 0 || !check_axes(block, targets)) return;
    line(block, target_of(block, targets), Op::Rapid, true);
    for (std::size_t i = 0; i < kAxes && !ended_; ++i) {
        if ((targets >> i & 1u) == 0) continue;
        const double at = position_.base[i] + length_shift_[i];
        if (std::abs(at - reference_points_[0][i]) <= kWidth) continue;
        report(diag::ReferenceMissed, block, Function::ReferenceCheck)
            .arg(kAxisNames[i])
            .arg(round_to(at, 4))
            .arg(round_to(reference_points_[0][i], 4));
    }
}

/// Over the place over which the axes went to their reference point, to the programmed one. A
/// distance counts from the place between.
void Executor::leave_reference(const Block& block) {
    const SlotMask targets = block.given & nc::kTargetSlots;
    if (targets == 0 || !check_axes(block, targets)) return;
    Target over{position_.here, {}, static_cast<AxisMask>(targets)};
    for (std::size_t i = 0; i < kAxes; ++i) {
        if ((targets >> i & 1u) == 0) continue;
        if ((has_left_ >> i & 1u) == 0) {
            report(diag::ReferenceNoPlace, block, Function::ReferenceLeave).arg(kAxisNames[i]);
            return;
        }
        over.here[i] = left_over_[i];
    }
    over.base = frames_.to_base(over.here);
    if (over.base != position_.base) line(block, over, Op::Rapid, true);
    if (!ended_) line(block, target_of(block, targets), Op::Rapid, true);
}

/// Makes the ways longer by the radius offset, so many times. False: that is not possible, and it
/// was said.
bool Executor::offset_ways(const Block& block, double times, Target& target) {
    if (comp_.side != Function::RadiusCompOff) {
        report(diag::WayOffsetCompensated, block, Function::WayOffset);
        return false;
    }
    if (is_circle(modal_.motion)) {
        report(diag::IsoNotSupported, block, Function::WayOffset)
            .arg("an arc whose ends are moved by an offset");
        return false;
    }
    const double offset = times * tool_offsets_.radius(tool_.radius_offset);
    for (std::size_t i = 0; i < kAxes; ++i) {
        if ((target.moved >> i & 1u) == 0) continue;
        target.here[i] += target.here[i] < position_.here[i] ? -offset : offset;
    }
    target.base = frames_.to_base(target.here);
    return true;
}

/// Over the programmed place, if the block names one and the tool is not there, to the reference
/// point of the axes that are named.
void Executor::return_to_reference(const Block& block, const nc::Invocation& invocation) {
    const SlotMask targets = block.given & nc::kTargetSlots;
    auto moved = static_cast<AxisMask>(targets);
    if (invocation.function == Function::ReferencePoint) {
        moved = static_cast<AxisMask>(invocation.given >> 1 & 0b111u);
    } else if (!check_axes(block, targets)) {
        return;
    }
    const double number = block.argument(invocation, 0, 1);
    const auto point = static_cast<std::size_t>(number - 1);
    if (!(number >= 1) || point >= machine::kReferencePoints ||
        (moved & ~has_reference_point_[point]) != 0) {
        report(diag::ReferenceUnknown, block, invocation.function).arg(number);
        return;
    }
    if (targets != 0) {
        const Target over = target_of(block, targets);
        if (over.base != position_.base) line(block, over, Op::Rapid, true);
        if (ended_) return;
    }
    AxisValues to = position_.base;
    for (std::size_t i = 0; i < kAxes; ++i) {
        to[i] += length_shift_[i];
        if ((moved >> i & 1u) != 0) to[i] = reference_points_[point][i];
    }
    for (std::size_t i = 0; i < kAxes; ++i)
        if ((moved >> i & 1u) != 0) left_over_[i] = position_.here[i];
    has_left_ = static_cast<AxisMask>(has_left_ | moved);
    if (moved != 0) rapid_to_machine_position(block, to, moved);
}

// ------------------------------------------------------------------------------ tapping

/// A line with the spindle geared to it, in as out: the spindle turns as the sign of the pitch
/// says, and stands at the end with the axis.
void Executor::tap(const Block& block, const Target& target) {
    const SlotMask words = block.given & nc::kCenterSlots;
    const double pitch = words == 0 ? 0 : block.at(first_slot(words));
    if (pitch == 0) {
        (words == 0 ? report(diag::TapPitchMissing, block)
                    : report(diag::TapPitchMissing, block, first_slot(words)));
        return;
    }
    if (spindle_.has_cutting_speed || !(spindle_.speed > 0)) {
        report(diag::TapSpeedMissing, block);
        return;
    }
    if (tool_.has_changed) activate_length(block, target.moved);
    if (!check_limits(block, target.base, target.moved)) return;
    const bool is_cw = (pitch > 0) == (modal_.motion == Function::TapIn);
    spindle_.mode = is_cw ? SpindleMode::Cw : SpindleMode::Ccw;
    update_spindle(block);
    Command& command = put(Op::Line, block);
    command.to = target.base;
    command.moved = target.moved;
    command.feed_mode = FeedMode::PerRevolution;
    command.feed = std::abs(pitch);
    command.exact_stop = true;
    arrive(target);
    spindle_.mode = SpindleMode::Stop;
    update_spindle(block);
}

// ------------------------------------------------------------------------------ threads

/// A line geared to the spindle as it turns. Its pitch counts along the axis of the longer way, so
/// a turn takes the tool so much farther along the line as that is longer.
void Executor::thread(const Block& block, const Target& target, const Actions& actions) {
    const Vec3 way = linear(target.here) - linear(position_.here);
    const std::optional<double> pitch = thread_pitch(block, way);
    if (!pitch) return;
    const double along = way.cwiseAbs().maxCoeff();
    const std::optional<double> change = thread_change(block, *pitch, along);
    if (!change) return;
    if (!check_thread_spindle(block)) return;
    check_tool(block);
    if (tool_.has_changed) activate_length(block, target.moved);
    if (!check_limits(block, target.base, target.moved)) return;
    has_moved_ = true;
    Command& command = put(Op::Thread, block);
    command.to = target.base;
    command.moved = target.moved;
    command.exact_stop = modal_.has_exact_stop || actions.exact_stop;
    command.feed_mode = FeedMode::PerRevolution;
    const double length = (linear(target.base) - linear(position_.base)).norm();
    const double by_way = along > 0 ? length / along : 1;
    command.feed = *pitch * by_way;
    command.lead_change = *change * by_way;
    command.angle_deg = actions.thread_start_deg;
    arrive(target);
}

/// False: the spindle, which the thread is geared to, stands, and it was said.
bool Executor::check_thread_spindle(const Block& block) {
    if (spindle_.mode != SpindleMode::Cw && spindle_.mode != SpindleMode::Ccw) {
        report(diag::RevolutionFeedStands, block);
        return false;
    }
    if (spindle_.has_cutting_speed && !warned_thread_speed_) {
        warned_thread_speed_ = true;
        report(diag::ThreadUnderCuttingSpeed, block);
    }
    return true;
}

/// By how much the pitch changes in a turn; 0 of an even thread. In a turn the tool goes by the
/// pitch, so its square changes by twice the change times the way: it must not come to zero.
std::optional<double> Executor::thread_change(const Block& block, double pitch, double way) {
    if (!is_varying_thread(modal_.motion)) return 0;
    const nc::Invocation* const word = block.find(Function::ThreadChange);
    if (word == nullptr) {
        report(diag::ThreadChangeMissing, block);
        return std::nullopt;
    }
    const double said = block.argument(*word, 0);
    const double change = modal_.motion == Function::ThreadDecreasing ? -said : said;
    if (pitch * pitch + 2 * change * way > 0) return change;
    report(diag::ThreadPitchVanishes, block, Function::ThreadChange)
        .arg(round_to(pitch * pitch / (-2 * change), 4));
    return std::nullopt;
}

/// The pitch that the block or, on some controls, F says; nothing if it was reported missing.
std::optional<double> Executor::thread_pitch(const Block& block, const Vec3& way) {
    constexpr double kEqualWays = 1e-6;  // mm: at 45 degrees either axis will do
    const SlotMask words = block.given & nc::kCenterSlots;
    Eigen::Index longest = 0;
    const double most = way.cwiseAbs().maxCoeff(&longest);
    const std::string_view name = kAxisNames[static_cast<std::size_t>(longest)];
    // The blocks of a cycle are neutral ones: they say it in a word.
    if (rules_.thread_pitch_is_feed && !cycle_blocks_) {
        if (words != 0) warn_arc_word(block, words);
        if (modal_.has_feed && modal_.feed > 0) return modal_.feed;
        report(diag::ThreadPitchMissing, block).arg(name);
        return std::nullopt;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto word = static_cast<Slot>(static_cast<std::size_t>(Slot::CenterX) + axis);
        const bool is_long = std::abs(way[static_cast<Eigen::Index>(axis)]) >= most - kEqualWays;
        if (is_long && block.has(word) && block.at(word) > 0) return block.at(word);
    }
    (words == 0 ? report(diag::ThreadPitchMissing, block)
                : report(diag::ThreadPitchMissing, block, first_slot(words)))
        .arg(name);
    return std::nullopt;
}

// ------------------------------------------------------------------------------ tool length

/// The axis along which the chief length of the tool lies.
Axis Executor::wanted_length_axis() const {
    const bool is_turned =
        tool_.source != Tool::Source::None && tool_offsets_.is_turning(tool_.length_number());
    if (is_turned || rules_.length_axis == LengthAxis::Z) return Axis::Z;
    return path::axes_of(modal_.plane).normal;
}

/// What should be added to X, Y, Z; S 5.1.
Vec3 Executor::wanted_lengths() const {
    Vec3 lengths = Vec3::Zero();
    const std::int64_t number = tool_.source == Tool::Source::None ? 0 : tool_.length_number();
    if (number == 0) return lengths;
    const auto put = [&](Axis axis, std::size_t part) {
        const double extra = extra_.lengths[static_cast<Eigen::Index>(part) - 1];
        if ((axes_ & bit(axis)) != 0)
            lengths[static_cast<Eigen::Index>(index(axis))] =
                tool_offsets_.length(part, number) + extra;
    };
    const bool goes_by_plane = rules_.length_axis == LengthAxis::Plane;
    if (tool_offsets_.is_turning(number)) {
        // Lengths of a machine's tool are told by their axes.
        const bool is_typed = tool_offsets_.type(number) != 0;
        const auto axes = path::axes_of(goes_by_plane && is_typed ? modal_.plane : path::Plane::Zx);
        put(axes.second, 1);
        put(axes.first, 2);
        put(axes.normal, 3);
    } else if (goes_by_plane) {
        const auto axes = path::axes_of(modal_.plane);
        put(axes.normal, 1);
        put(axes.second, 2);
        put(axes.first, 3);
    } else {
        put(Axis::Z, 1);
    }
    lengths += extra_.along;
    const bool is_taken_off = tool_.source == Tool::Source::Offset && tool_.is_taken_off;
    return is_taken_off ? Vec3(-lengths) : lengths;
}

/// A machine without a tool table has no lengths; a table with a gap is likely a mistake.
void Executor::check_length_known(const Block& block) {
    const std::int64_t number = tool_.source == Tool::Source::None ? 0 : tool_.length_number();
    if (number == 0 || machine_.tools.empty() || tool_offsets_.is_known(number)) return;
    if (std::find(unknown_tools_.begin(), unknown_tools_.end(), number) != unknown_tools_.end())
        return;
    unknown_tools_.push_back(number);
    report(diag::ToolUnknown, block).arg(number);
}

/// A length that was selected acts along an axis with the first motion of that axis: the motion
/// side is told just before it, and only if the length is another one than before.
void Executor::activate_length(const Block& block, AxisMask moved) {
    const Axis axis = wanted_length_axis();
    if ((moved & bit(axis)) != 0) check_length_known(block);
    const Vec3 wanted = wanted_lengths();
    Vec3 lengths = tool_.lengths;
    AxisMask changed = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        if ((moved >> i & 1u) == 0 || lengths[at] == wanted[at]) continue;
        lengths[at] = wanted[at];
        changed = static_cast<AxisMask>(changed | 1u << i);
    }
    tool_.has_changed = lengths != wanted;
    if (changed == 0) return;
    tool_.lengths = lengths;
    tool_.axis = axis;
    set_length_shift(length_shift_of(lengths));
    put_tool_length(block, axis).moved = changed;
}

/// Tells the motion side what lies between the tip and what the linear axes carry.
Command& Executor::put_tool_length(const Block& block, Axis axis) {
    const Vec3 carried = tilting_.carries ? length_shift_of(tool_.lengths) : tool_.lengths;
    const auto chief = static_cast<Eigen::Index>(index(axis));
    Command& command = put(Op::ToolLength, block);
    command.plane = plane_with_normal(axis);
    command.tool = tool_.source == Tool::Source::None ? 0 : tool_.length_number();
    command.length = carried[chief];
    command.aside = carried;
    command.aside[chief] = 0;
    command.is_swivelled = tilting_.carries;
    if (tilting_.carries)
        command.direction = machine::tool_in_base(machine_.kinematics->chain, tilting_.joints);
    return command;
}

/// `G43 H1` in a block without axis words: the programmed position stays, so the machine axis moves
/// by the change of the length, in the active kind of motion.
void Executor::move_length_alone(const Block& block) {
    if (!rules_.length_moves_alone) return;
    const Vec3 wanted = wanted_lengths();
    AxisMask changed = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        if (wanted[at] != tool_.lengths[at]) changed = static_cast<AxisMask>(changed | 1u << i);
    }
    if (changed == 0) {
        check_length_known(block);
        return;
    }
    line(block, {position_.here, position_.base, changed},
         modal_.motion == Function::Rapid ? Op::Rapid : Op::Line, modal_.has_exact_stop);
}

/// A transformation with a length was switched in a block without axis words: the place in the
/// program stays, and so the axes move.
void Executor::move_behind_switch(const Block& block) {
    if (!rules_.length_moves_alone) return;
    const AxisMask moved =
        orienting_.is_on ? static_cast<AxisMask>(kLinearXYZ | joint_axes()) : kLinearXYZ;
    if (orienting_.is_on) {
        next_turn_ = {};
        settle_turn({position_.here, position_.base, moved});
    }
    line(block, {position_.here, position_.base, moved},
         modal_.motion == Function::Rapid ? Op::Rapid : Op::Line, modal_.has_exact_stop);
}

// ------------------------------------------------------------------------------ arcs

void Executor::arc(const Block& block, const Target& target, bool exact_stop) {
    if (!check_feed(block, "arc")) return;
    if (frames_.is_stretched(modal_.plane)) return stretched_arc(block, target, exact_stop);
    const bool has_opening = block.has(Slot::Opening);
    const bool has_form = (block.given & (nc::kCenterSlots | bit(Slot::Radius))) != 0;
    if (!has_form && !has_opening && rules_.arc_without_center == ArcWithoutCenter::Line) {
        return line(block, target, Op::Line, exact_stop);
    }
    if (tool_.has_changed) activate_length(block, target.moved);
    if (const SlotMask through = block.given & nc::kThroughSlots; through != 0) {
        report_arc_words(block, through);
        return;
    }
    Target end = target;
    const std::optional<path::Arc> resolved =
        has_opening ? arc_by_opening(block, end) : resolve_arc(block, target);
    if (resolved) put_arc(block, *resolved, end, exact_stop);
}

/// An arc of the programmed system becomes one of the base system, and a command. A frame that
/// mirrors turns the arc round, which the product of two directions across its axis shows.
void Executor::put_arc(const Block& block, const path::Arc& programmed, const Target& target,
                       bool exact_stop) {
    const path::PlaneAxes plane = path::axes_of(modal_.plane);
    const Vec3 third = path::unit(plane.normal);
    const path::Frame& frame = frames_.total();
    const double side = programmed.normal.dot(third);
    const bool is_tilted = std::abs(side) < 1 - 1e-12;
    const Vec3 first = is_tilted ? programmed.normal.unitOrthogonal() : path::unit(plane.first);
    const Vec3 second =
        is_tilted ? Vec3(programmed.normal.cross(first)) : Vec3(side * path::unit(plane.second));
    const path::Arc arc{linear(position_.base), linear(target.base), frame(programmed.center),
                        frame.direction(first).cross(frame.direction(second)).normalized(),
                        programmed.sweep};
    put_base_arc(block, arc, target, exact_stop);
}

/// Under unequal factors: an arc by its radius between the scaled ends, where the control makes
/// one.
void Executor::stretched_arc(const Block& block, const Target& target, bool exact_stop) {
    const SlotMask thirds = bit(nc::slot_of(path::axes_of(modal_.plane).normal));
    const bool is_helix = !block.has(Slot::Radius) && (block.given & thirds) != 0;
    if (!rules_.arc_radius_scaled_by_larger || frames_.is_tilted(modal_.plane) || is_helix) {
        report(diag::ArcStretched, block, modal_.motion);
        return;
    }
    if (!block.has(Slot::Radius)) return stretched_arc_about_center(block, target, exact_stop);
    const std::optional<int> turns = turns_of(block);
    if (!turns) return;
    if (tool_.has_changed) activate_length(block, target.moved);
    const path::ArcEnds ends{linear(position_.base), linear(target.base)};
    const bool is_cw = (modal_.motion == Function::ArcCw) != frames_.is_mirrored(modal_.plane);
    const Result<path::Arc, path::ArcFault> arc =
        path::arc_of_radius(ends, block.at(Slot::Radius) * frames_.larger_factor(modal_.plane),
                            {modal_.plane, is_cw, *turns});
    if (!arc) return report_radius_arc(block, arc.error(), ends);
    put_base_arc(block, *arc, target, exact_stop);
}

/// Centre and end are scaled each by its axis; the arc goes about the centre to the direction of
/// the end, and a line to the end itself.
void Executor::stretched_arc_about_center(const Block& block, const Target& target,
                                          bool exact_stop) {
    const std::optional<Vec3> programmed = center_of_arc(block, linear(position_.here));
    if (!programmed) return;
    const Vec3 third = path::unit(path::axes_of(modal_.plane).normal);
    const Vec3 start = linear(position_.base);
    Vec3 center = frames_.total()(*programmed);
    center += (start - center).dot(third) * third;
    const Vec3 out = start - center;
    const Vec3 to_end = linear(target.base) - center;
    const bool has_radius = out.norm() > path::kSamePoint && to_end.norm() > path::kSamePoint;
    if (!has_radius) {
        report(diag::ArcCenterMissing, block, modal_.motion);
        return;
    }
    if (tool_.has_changed) activate_length(block, target.moved);
    const bool is_cw = (modal_.motion == Function::ArcCw) != frames_.is_mirrored(modal_.plane);
    const Vec3 normal = is_cw ? Vec3(-third) : third;
    double sweep = std::atan2(normal.dot(out.cross(to_end)), out.dot(to_end));
    if (sweep <= 0) sweep += 2 * std::numbers::pi;
    const path::Arc arc{start, center + to_end.normalized() * out.norm(), center, normal, sweep};
    Target turned = target;
    for (std::size_t i = 0; i < 3; ++i) turned.base[i] = arc.end[static_cast<Eigen::Index>(i)];
    turned.here = frames_.from_base(turned.base);
    const bool is_on_arc = (arc.end - linear(target.base)).norm() < path::kSamePoint;
    put_base_arc(block, arc, turned, exact_stop && is_on_arc);
    if (!is_on_arc && !ended_) line(block, target, Op::Line, exact_stop);
}

/// An arc of the base system as a command.
void Executor::put_base_arc(const Block& block, const path::Arc& arc, const Target& programmed,
                            bool exact_stop) {
    const Vec3 third = path::unit(path::axes_of(modal_.plane).normal);
    Target target = programmed;
    if (course_) {
        const path::Curve way =
            path::make_helix(arc.start, arc.end, arc.center, arc.normal, arc.sweep);
        if (!lay_course(block, way, target)) return;
    }
    if (!check_arc_limits(block, arc, target)) return;

    Command& command = put(Op::Arc, block);
    command.to = target.base;
    command.moved = target.moved;
    command.exact_stop = exact_stop;
    command.center = arc.center;
    command.normal = arc.normal;
    command.sweep = arc.sweep;
    command.is_clockwise = arc.normal.dot(third) < 0;
    command.turns = block.has(Slot::Turns) ? block.at(Slot::Turns) : 0;
    command.feed = modal_.feed;
    // F = feed/radius, and the length is radius · sweep: the time is sweep/F.
    if (modal_.feed_mode == FeedMode::InverseTime && rules_.inverse_time_arc_by_radius) {
        command.feed = modal_.feed / arc.sweep;
    }
    if (modal_.feed_mode != FeedMode::InverseTime && rules_.helix_feed_along_arc) {
        command.feed *= length_by_arc(arc);
    }
    arrive(target);
    came_from_ = arc.end - arc.normal.cross(arc.end - arc.center);
}

/// Where a centre stays, the block as if it had said it: an arc has the one that was said last, if
/// it says no radius; words that stand beside no arc have done all that they do.
const Block& Executor::with_center(const Block& block) {
    if (!acts(block)) return block;
    const SlotMask said = block.given & nc::kCenterSlots;
    for (std::size_t i = 0; i < center_.size(); ++i) {
        const Slot slot = static_cast<Slot>(static_cast<std::size_t>(Slot::CenterX) + i);
        if ((said & bit(slot)) == 0) continue;
        const double from = (block.absolute & bit(slot)) != 0 ? 0 : position_.here[i];
        center_[i] = from + block.at(slot);
    }
    const Function motion = block.motion != Function::None ? block.motion : modal_.motion;
    const bool is_moved = (block.given & nc::kTargetSlots) != 0 || block.motion != Function::None;
    const bool turns = is_arc(motion) && is_moved;
    if (turns && block.has(Slot::Radius)) return block;
    if (!turns && said == 0) return block;
    centered_ = block;
    centered_.given &= ~nc::kCenterSlots;
    if (!turns) return centered_;
    const path::PlaneAxes plane = path::axes_of(modal_.plane);
    for (const Axis axis : {plane.first, plane.second}) {
        const Slot slot = static_cast<Slot>(static_cast<std::size_t>(Slot::CenterX) + index(axis));
        if (!center_[index(axis)]) continue;
        centered_.set(slot, *center_[index(axis)]);
        centered_.absolute |= bit(slot);
    }
    return centered_;
}

/// The programmed radius; half of the chord where the control forgives that it lacks so little.
double Executor::radius_of(const Block& block, const path::ArcEnds& ends) const {
    const double radius = block.at(Slot::Radius);
    if (!rules_.arc_radius_may_fall_short) return radius;
    const Vec3 way = ends.end - ends.start;
    const Vec3 normal = path::unit(path::axes_of(modal_.plane).normal);
    const double half = (way - normal * way.dot(normal)).norm() / 2;
    const double size = std::abs(radius);
    const double slack = std::max(rules_.arc_tolerance, rules_.arc_tolerance_factor * size);
    return size < half && half - size <= slack ? std::copysign(half, radius) : radius;
}

/// The arc in the programmed system; nothing if it was reported, or if there is nothing to move.
std::optional<path::Arc> Executor::resolve_arc(const Block& block, const Target& target) {
    const bool has_center = (block.given & nc::kCenterSlots) != 0;
    const std::optional<int> turns = turns_of(block);
    if (!turns) return std::nullopt;
    const path::ArcEnds ends{linear(position_.here), linear(target.here)};
    const path::ArcTurning turning{modal_.plane, modal_.motion == Function::ArcCw, *turns};
    if (block.has(Slot::Radius)) {
        if (has_center && !rules_.arc_radius_wins) {
            report(diag::ArcCenterAndRadius, block, Slot::Radius);
            return std::nullopt;
        }
        const Result<path::Arc, path::ArcFault> arc =
            path::arc_of_radius(ends, radius_of(block, ends), turning);
        if (arc) return *arc;
        report_radius_arc(block, arc.error(), ends);
        return std::nullopt;
    }
    const std::optional<Vec3> center = center_of_arc(block, ends.start);
    if (!center) return std::nullopt;
    const path::ArcTolerance tolerance{rules_.arc_tolerance, rules_.arc_tolerance_factor,
                                       rules_.arc_error == ArcError::ShiftCenter
                                           ? path::RadiusError::ShiftCenter
                                           : path::RadiusError::Spread};
    const Result<path::Arc, path::ArcFault> arc =
        path::arc_about_center(ends, *center, turning, tolerance);
    if (arc) return *arc;
    report_center_arc(block, arc.error(), ends, *center);
    return std::nullopt;
}

/// Additional full turns; nothing if they were reported.
std::optional<int> Executor::turns_of(const Block& block) {
    const double turns = block.has(Slot::Turns) ? block.at(Slot::Turns) : 0;
    if (turns == std::floor(turns) && turns >= 0 && turns <= path::kMaxTurns)
        return static_cast<int>(turns);
    report(diag::ArcTurnsInvalid, block, Slot::Turns).arg(turns);
    return std::nullopt;
}

/// The centre that the words say, in the programmed system; nothing if it was reported.
std::optional<Vec3> Executor::center_of_arc(const Block& block, const Vec3& start) {
    const Slot across = static_cast<Slot>(static_cast<std::size_t>(Slot::CenterX) +
                                          index(path::axes_of(modal_.plane).normal));
    if (block.has(across)) {
        report(diag::ArcCenterOutsidePlane, block, across).arg(slot_word(across));
        return std::nullopt;
    }
    Vec3 center = start;
    for (std::size_t i = 0; i < 3; ++i) {
        const Slot slot = static_cast<Slot>(static_cast<std::size_t>(Slot::CenterX) + i);
        if (!block.has(slot)) continue;
        double& value = center[static_cast<Eigen::Index>(i)];
        value = (block.absolute & bit(slot)) != 0 ? block.at(slot) : value + block.at(slot);
    }
    return center;
}

void Executor::report_radius_arc(const Block& block, path::ArcFault fault,
                                 const path::ArcEnds& ends) {
    const Vec3 way = ends.end - ends.start;
    if (fault == path::ArcFault::RadiusTooSmall) {
        const double height = way.dot(path::unit(path::axes_of(modal_.plane).normal));
        const double chord = std::sqrt(std::max(0.0, way.squaredNorm() - height * height));
        report(diag::ArcRadiusTooSmall, block, Slot::Radius)
            .arg(round_to(block.at(Slot::Radius), 6))
            .arg(round_to(chord, 6));
        return;
    }
    const bool moves = way.norm() > 0;  // along the axis of a helix
    if (!moves && rules_.arc_radius_without_chord == ArcWithoutChord::NoMotion) return;
    report(diag::ArcWithoutChord, block, Slot::Radius);
}

void Executor::report_center_arc(const Block& block, path::ArcFault fault,
                                 const path::ArcEnds& ends, const Vec3& center) {
    const SlotMask centers = block.given & nc::kCenterSlots;
    if (fault == path::ArcFault::NoRadius) {
        if (centers == 0) {
            report(diag::ArcCenterMissing, block, block.motion);
        } else {
            report(diag::ArcCenterMissing, block, first_slot(centers));
        }
        return;
    }
    const Vec3 normal = path::unit(path::axes_of(modal_.plane).normal);
    const Vec3 from = ends.start - center;
    const Vec3 to = ends.end - center;
    report(diag::ArcEndOffCircle, block, first_slot(centers))
        .arg(round_to((from - from.dot(normal) * normal).norm(), 6))
        .arg(round_to((to - to.dot(normal) * normal).norm(), 6));
}

void Executor::warn_arc_word(const Block& block, SlotMask words) {
    const Slot slot = first_slot(words);
    report(diag::ArcWordUnused, block, slot)
        .arg(slot_word(slot))
        .arg(modal_.motion == Function::Rapid ? "rapid" : "line");
}

// ------------------------------------------------------------------------------ checks

bool Executor::check_axes(const Block& block, SlotMask targets) {
    SlotMask missing = targets & ~SlotMask{axes_};
    if (virtual_.axes.turns()) {
        missing &= ~bit(nc::slot_of(virtual_.axes.virtual_axis()));
        if (const Slot turning = nc::slot_of(virtual_.axes.rotary); (targets & bit(turning)) != 0) {
            report(diag::VirtualRotary, block, turning).arg(nc::slot_name(turning));
            return false;
        }
    }
    if (missing == 0) return true;
    const Slot slot = first_slot(missing);
    report(diag::AxisMissing, block, slot).arg(kAxisNames[static_cast<std::size_t>(slot)]);
    return false;
}

/// Between the code that gears the spindle and the tapping cycle no axis moves.
bool Executor::check_rigid_tap(const Block& block, SlotMask targets) {
    if (!taps_rigidly_ || targets == 0 || cycle_blocks_) return true;
    if (block.find(Function::TapRigid) != nullptr) return true;
    report(diag::TapMoveBefore, block, first_slot(targets));
    return false;
}

bool Executor::check_feed(const Block& block, std::string_view what) {
    if (!modal_.has_feed) {
        report(diag::FeedMissing, block).arg(what);
        return false;
    }
    if (!(modal_.feed > 0)) {
        const double feed = modal_.feed;
        (block.has(Slot::Feed) ? report(diag::FeedNotPositive, block, Slot::Feed)
                               : report(diag::FeedNotPositive, block))
            .arg(feed);
        return false;
    }
    if (modal_.feed_mode == FeedMode::InverseTime && rules_.inverse_time_feed_in_every_block &&
        !block.has(Slot::Feed)) {
        report(diag::InverseTimeFeedMissing, block);
        return false;
    }
    if (spindle_.mode == SpindleMode::Cw || spindle_.mode == SpindleMode::Ccw) {
        check_tool(block);
        return true;
    }
    if (modal_.feed_mode == FeedMode::PerRevolution) {
        report(diag::RevolutionFeedStands, block);
        return false;
    }
    // The beam of a scanner comes with its marks.
    if (!warned_spindle_stopped_ && !is_scanning_) {
        warned_spindle_stopped_ = true;
        report(diag::FeedWithSpindleStopped, block);
    }
    return true;
}

/// A probe must not turn, so the spindle may stand; a feed per revolution would wait for ever then.
bool Executor::check_probe(const Block& block) {
    const bool turns = spindle_.mode == SpindleMode::Cw || spindle_.mode == SpindleMode::Ccw;
    const bool has_feed = modal_.has_feed && modal_.feed > 0;
    if (!turns && has_feed && modal_.feed_mode == FeedMode::PerMinute) return true;
    return check_feed(block, "probing move");
}

/// A rapid that dives below the workpiece zero of a mill while the spindle stands. On a lathe, and
/// in another plane, Z is not the way into the workpiece.
void Executor::check_rapid(const Block& block, const Target& target) {
    constexpr auto kZ = static_cast<std::size_t>(Axis::Z);
    const bool stands = spindle_.mode == SpindleMode::Stop;
    const bool dives = (target.moved >> kZ & 1u) != 0 && target.here[kZ] < 0 &&
                       target.here[kZ] < position_.here[kZ];
    const bool is_mill = word_scale_[0] == 1 && modal_.plane == path::Plane::Xy;
    if (warned_rapid_ || !stands || !dives || !is_mill) return;
    warned_rapid_ = true;
    report(diag::RapidBelowPlane, block, Slot::Z).arg(round_to(target.here[kZ], 4));
}

/// A cut on a machine that changes tools, with whatever turns in the spindle.
void Executor::check_tool(const Block& block) {
    if (has_called_tool_ || !options_.asks_for_tool || machine_.tool_change_time == 0 ||
        tool_.current != 0)
        return;
    has_called_tool_ = true;  // said once
    report(diag::ToolNeverCalled, block);
}

void Executor::check_units(const Block& block, nc::Function units) {
    const bool changes = units_ != nc::Function::None && units_ != units;
    const std::string_view acts = comp_.side != nc::Function::RadiusCompOff
                                      ? "cutter radius compensation"
                                  : frames_.is_rotated() ? "a rotation"
                                  : frames_.is_scaled()  ? "a scaling"
                                                         : "";
    if (changes && rules_.comp_is_innermost && !acts.empty()) {
        report(diag::UnitsInside, block, units)
            .arg(units == nc::Function::Inch ? "inches" : "millimetres")
            .arg(acts);
        return;
    }
    if (changes && has_moved_ && !warned_units_) {
        warned_units_ = true;
        const bool to_inch = units == nc::Function::Inch;
        report(diag::UnitsMixed, block, units)
            .arg(to_inch ? "millimetres" : "inches")
            .arg(to_inch ? "inches" : "millimetres");
    }
    units_ = units;
}

bool Executor::check_limits(const Block& block, const AxisValues& base, AxisMask moved) {
    // Where the axes go under a transformation is worked out along the way (motion/axis_check.h).
    if (is_transformed()) return !area_.acts() || check_area(block, base, moved);
    return check_machine_limits(block, base, moved) &&
           (!area_.acts() || check_area(block, base, moved));
}

/// Whether the tip is inside of the working area that the program has set.
bool Executor::check_area(const Block& block, const AxisValues& base, AxisMask moved) {
    const AxisMask axes =
        frames_.is_shift() ? moved : static_cast<AxisMask>(moved | (axes_ & kLinearXYZ));
    const std::optional<WorkArea::Excess> excess = area_.excess(base, axes);
    if (!excess) return true;
    const Slot word = nc::slot_of(excess->axis);
    (block.has(word) ? report(diag::AreaLeft, block, word) : report(diag::AreaLeft, block))
        .arg(kAxisNames[index(excess->axis)])
        .arg(round_to(excess->at, 6))
        .arg(round_to(excess->limit, 6));
    return false;
}

bool Executor::check_machine_limits(const Block& block, const AxisValues& base, AxisMask moved) {
    const AxisMask axes =
        frames_.is_shift() ? moved : static_cast<AxisMask>(moved | (axes_ & kLinearXYZ));
    for (AxisMask rest = axes; rest != 0; rest = static_cast<AxisMask>(rest & (rest - 1))) {
        const auto i = static_cast<std::size_t>(std::countr_zero(rest));
        const double at = base[i] + length_shift_[i];
        if (at < lower_[i] - kLimitSlack || at > upper_[i] + kLimitSlack) {
            report_limit(block, static_cast<Axis>(i), at);
            return false;
        }
    }
    return true;
}

bool Executor::check_arc_limits(const Block& block, const path::Arc& arc, const Target& target) {
    if (!check_limits(block, target.base, target.moved)) return false;
    // Far from every limit, which is nearly always, the whole circle is the quick answer.
    const path::ArcShape shape = path::shape_of(arc);
    if (is_transformed()) return true;
    const double reach = std::max(shape.start_radius, shape.end_radius) + std::abs(shape.height);
    bool is_far = !area_.acts();
    for (std::size_t i = 0; i < 3; ++i) {
        const double center = arc.center[static_cast<Eigen::Index>(i)] + length_shift_[i];
        is_far &= center - reach >= lower_[i] && center + reach <= upper_[i];
    }
    if (is_far) return true;
    return check_box(block, path::bounds(path::make_helix(arc.start, arc.end, arc.center,
                                                          arc.normal, arc.sweep)));
}

bool Executor::check_box(const Block& block, const path::Box& box) {
    for (std::size_t i = 0; i < 3; ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        for (const double edge : {box.lower[k], box.upper[k]}) {
            const double at = edge + length_shift_[i];
            if (at >= lower_[i] - kLimitSlack && at <= upper_[i] + kLimitSlack) continue;
            report_limit(block, static_cast<Axis>(i), at);
            return false;
        }
    }
    if (!area_.acts()) return true;
    const auto corner = [](const Vec3& at) {
        AxisValues values{};
        for (std::size_t i = 0; i < 3; ++i) values[i] = at[static_cast<Eigen::Index>(i)];
        return values;
    };
    return check_area(block, corner(box.lower), kLinearXYZ) &&
           check_area(block, corner(box.upper), kLinearXYZ);
}

void Executor::report_limit(const Block& block, Axis axis, double at) {
    const std::size_t i = index(axis);
    const double limit = at < lower_[i] ? lower_[i] : upper_[i];
    DiagnosticBuilder builder = block.has(nc::slot_of(axis))
                                    ? report(diag::AxisLimit, block, nc::slot_of(axis))
                                    : report(diag::AxisLimit, block);
    builder.arg(kAxisNames[i]).arg(round_to(at, 6)).arg(round_to(limit, 6));
}

}  // namespace kadr::interp
