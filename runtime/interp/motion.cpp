// motion.cpp — where a block goes: which motion its words mean, its target, and lines.
#include <bit>
#include <cmath>

#include "base/danger_limits.h"
#include "base/diagnostics/doubtful.h"
#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "interp/block_words.h"
#include "interp/channel.h"
#include "interp/cornering.h"
#include "interp/cycles.h"
#include "interp/danger_watch.h"
#include "interp/feed_words.h"
#include "interp/motion_checks.h"
#include "interp/motions.h"
#include "interp/path_smoothing.h"
#include "interp/programmed_frames.h"
#include "interp/radius_compensation.h"
#include "interp/smooth_approaches.h"
#include "interp/splines.h"
#include "interp/stages.h"
#include "interp/tilted_planes.h"
#include "interp/tool_in_use.h"
#include "interp/tool_motion.h"
#include "interp/transformation.h"
#include "interp/word_hints.h"
#include "path/linear.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Slot;
using nc::SlotMask;
using path::Command;
using path::linear;
using path::Op;
using path::Vec3;

namespace {

constexpr SlotMask kArcSlots = nc::kArcSlots | nc::kThroughSlots | bit(Slot::Opening);

path::Curve straight_path(const Vec3& from, const Vec3& to) {
    constexpr double kStill = 1e-9;  // mm: the rounding of frames
    if ((to - from).norm() <= kStill) return path::Point{from};
    return path::make_line(from, to);
}

}  // namespace

Motions::Motions(Channel& channel)
    : channel_(channel),
      dialect_(channel.state.dialect),
      machine_(channel.state.machine),
      is_lathe_(channel.state.is_lathe),
      tool_offsets_(channel.state.tool.tool_offsets),
      reporter_(channel.state.reporter),
      rules_(channel.state.rules),
      probe_(channel.state.motion.probe),
      modal_(channel.state.motion.modal),
      position_(channel.state.motion.position),
      frames_(channel.state.frame.frames),
      spindle_(channel.state.spindle.spindle),
      tool_(channel.state.tool.tool),
      orienting_(channel.state.tool.orienting),
      tilted_plane_(channel.state.tool.tilted_plane),
      virtual_(channel.state.tool.virtual_axes),
      diameter_is_absolute_(channel.state.motion.diameter_is_absolute),
      corners_(channel.state.stage.corners),
      comp_(channel.state.stage.comp),
      comp_3d_(channel.state.stage.comp_3d),
      units_(channel.state.motion.units),
      dynamics_(channel.state.motion.dynamics),
      unplaced_(channel.state.motion.unplaced),
      reported_(channel.state.reported),
      axes_(channel.state.axes),
      length_shift_(channel.state.motion.length_shift),
      preset_(channel.state.motion.preset),
      modal_cycles_(channel.state.cycle.modal_cycles),
      shape_(channel.state.cycle.shape) {}

/// What decides which motion the block is.
///
/// arc_words  those that belong to an arc, and not to the end of a compensation
MotionCase Motions::case_of(const Block& block, const Actions& actions, SlotMask arc_words) const {
    using Smooth = MotionCase::Smooth;
    constexpr SlotMask kCycleSlots = nc::kTargetSlots | bit(Slot::Radius);
    const SlotMask targets = block.given & nc::kTargetSlots;
    const Function motion = modal_.motion;
    MotionCase of;
    of.motion = motion;
    of.has_target = targets != 0;
    of.has_arc_words = arc_words != 0;
    of.turns_tool = actions.tool.turns();
    of.has_tool_words = actions.tool.is_any();
    of.has_knot = motion == Function::Spline && block.find(Function::SplineKnot) != nullptr;
    of.has_polynomial =
        motion == Function::Polynomial && block.find(Function::PolynomialAxis) != nullptr;
    const bool is_through = motion == Function::AkimaSpline || motion == Function::CubicSpline;
    of.only_turns = is_through && channel_.splines.only_turns(block);
    if (actions.smooth_approach != nullptr)
        of.smooth = actions.smooth_approach->function == Function::SmoothApproach ? Smooth::Approach
                                                                                  : Smooth::Retract;
    of.refers = actions.reference != nullptr;
    of.measures = actions.measure != nullptr;
    of.probes = actions.probes;
    of.is_in_machine_coordinates = actions.machine_coordinates;
    of.calls_behind_motions = actions.calls_behind_motions;
    of.cancels_cycle = actions.cycle_is_cancelled;
    of.calls_cycle = actions.cycle != nullptr;
    of.is_of_cycle = (block.given & kCycleSlots) != 0;
    of.resets_orientation = actions.orient_reset != nullptr;
    of.suspends_length = actions.suspends_length;
    of.is_rapid_once = actions.at_rapid;
    of.taps = actions.taps;
    of.is_compensated = comp_.is_on();
    of.is_in_space = comp_3d_.is_on() || comp_.chosen() != CompKind::InPlane;
    of.repeats_cycle = modal_cycles_.modal.is_active;
    of.has_no_frames = channel_.frames.are_off();
    return of;
}

void Motions::move(const Block& block, const Actions& actions) {
    if (block.motion != Function::None) modal_.move_by(block.motion);
    if (nc::ends_modal_cycle(block)) channel_.cycles.end_by_motion_code();
    const SlotMask targets = block.given & nc::kTargetSlots;
    SlotMask arc_words = block.given & kArcSlots;
    const bool has_arc = arc_words != 0 && nc::has_fact(modal_.motion, nc::Fact::Circle);
    const bool may_move = targets != 0 || actions.tool.turns() || has_arc;
    if (may_move && !channel_.tool_motion.require_point_to_point_motion(block, actions)) return;
    // They have given how the compensation ends.
    if (arc_words != 0 && channel_.compensation.leave_direction(block))
        arc_words &= ~nc::kCenterSlots;
    const MotionKind kind = classify(case_of(block, actions, arc_words));
    const bool stands_alone = targets != 0 && (actions.machine_coordinates || actions.probes);
    if (kind > MotionKind::CompensatedProbe && stands_alone &&
        !channel_.cycles.require_no_cycle(block, actions))
        return;
    if (kind > MotionKind::CycleRepeat &&
        !channel_.checks.require_no_move_before_tap(block, targets))
        return;
    if (has_target(kind)) return move_to_target(block, actions, kind, arc_words);
    move_otherwise(block, actions, kind, arc_words);
}

/// A block without a position of its own, or whose path others know.
void Motions::move_otherwise(const Block& block, const Actions& actions, MotionKind kind,
                             SlotMask arc_words) {
    const SlotMask targets = block.given & nc::kTargetSlots;
    switch (kind) {
        case MotionKind::ApproachInSpace:
            reporter_.report(diag::CompSpaceStart, block, actions.smooth_approach->function);
            return;
        case MotionKind::Approach: return channel_.approaches.approach_smoothly(block, actions);
        case MotionKind::Retract: return channel_.approaches.retract_smoothly(block, actions);
        case MotionKind::ReferencePoint: return refer(block, *actions.reference);
        case MotionKind::Measure: return measure_length(block, *actions.measure);
        case MotionKind::CompensatedProbe:
            reporter_.report(diag::ProbeCompensated, block, Function::Probe);
            return;
        case MotionKind::CallBehindMotions:
            return channel_.cycles.call_behind_motions(actions.cycle != nullptr ? &block : nullptr);
        case MotionKind::CancelledCycle:
            return channel_.cycles.move_instead_of_cycle(block, actions);
        case MotionKind::CycleCall: return channel_.cycles.call_cycle(block, actions);
        case MotionKind::CycleRepeat: return channel_.cycles.repeat_cycle(block, actions);
        case MotionKind::OrientationReset:
            return channel_.tool_motion.reset_orientation(block, *actions.orient_reset);
        case MotionKind::TurnBesideThread:
            reporter_.report(diag::IsoNotSupported, block)
                .arg("a change of the orientation beside a thread");
            return;
        case MotionKind::Spline: return channel_.splines.spline(block, actions.tool);
        case MotionKind::SplineThrough:
            return channel_.splines.go_through(block, targets, actions.tool);
        case MotionKind::Polynomial:
            return channel_.splines.polynomial(
                block, actions.tool, channel_.smoothing.stops_exactly(actions.exact_stop));
        case MotionKind::Stays:
            if (arc_words != 0) warn_arc_word(block, arc_words);
            if (actions.switches_length) return channel_.tool.move_behind_switch(block);
            if (actions.length_changed) channel_.tool.move_length_alone(block);
            return;
        case MotionKind::MachineCoordinates:
        case MotionKind::WithoutLength:
        case MotionKind::RapidOnce:
        case MotionKind::FloatingTap:
        case MotionKind::Probe:
        case MotionKind::Thread:
        case MotionKind::ArcThread:
        case MotionKind::Involute:
        case MotionKind::RigidTap:
        case MotionKind::Arc:
        case MotionKind::ArcThrough:
        case MotionKind::ArcTangent:
        case MotionKind::Straight: return;  // they have a target
    }
}

/// Where the words of the block lead; nothing: it was reported.
std::optional<Target> Motions::target_of(const Block& block, const Actions& actions) {
    Target target = motion_words().target_of(block, block.given & nc::kTargetSlots);
    if (orienting_.is_on && !channel_.tool_motion.orient(block, actions, target))
        return std::nullopt;
    if (comp_.takes_surface_normals() && !channel_.compensation.lay_surface(block, actions.tool))
        return std::nullopt;
    if (tilted_plane_.carries || tilted_plane_.on_tables) {
        // In the base system every linear axis may move, whatever the block names.
        target.moved = static_cast<AxisMask>(target.moved | (axes_.present & kLinearXYZ));
        channel_.tilted_planes.check_carried(block);
    }
    channel_.dangers.watch_turn_of_part(block, target);
    if (actions.tool_offset_increase != 0 &&
        !increase_by_tool_offset(block, actions.tool_offset_increase, target))
        return std::nullopt;
    return target;
}

void Motions::move_to_target(const Block& block, const Actions& actions, MotionKind kind,
                             SlotMask arc_words) {
    const SlotMask targets = block.given & nc::kTargetSlots;
    if (!motion_words().require_axes(block, targets) ||
        !motion_words().require_rotary_approaches(block))
        return;
    if (actions.at_rapid && !channel_.transformation.require_no_lone_axis(block, targets)) return;
    if ((unplaced_ & targets) != 0) [[unlikely]]
        check_place(block, targets);
    if (kind == MotionKind::MachineCoordinates) return move_in_machine_coordinates(block);
    const std::optional<Target> target = target_of(block, actions);
    if (!target) return;
    // At rapid a motion to a position of the machine ends at rest on every control.
    const bool goes_to_machine = channel_.frames.are_off() && modal_.motion == Function::Rapid;
    const bool exact_stop = channel_.smoothing.stops_exactly(actions.exact_stop || goes_to_machine);
    if (actions.at_rapid && comp_.is_on() && (targets & plane_mask()) != 0) {
        reporter_.report(diag::CompMotion, block);
        return;
    }
    switch (kind) {
        case MotionKind::WithoutLength: return move_without_length(block, *target, exact_stop);
        case MotionKind::RapidOnce: return line(block, *target, Op::Rapid, true);
        case MotionKind::FloatingTap: return line(block, *target, Op::Line, exact_stop);
        case MotionKind::Probe:
            if (arc_words != 0) warn_arc_word(block, arc_words);
            return line(block, *target, probes_at_rapid(block) ? Op::Rapid : Op::Probe, true);
        case MotionKind::Thread: return thread(block, *target, actions);
        case MotionKind::ArcThread: return thread_along_arc(block, *target, actions);
        case MotionKind::Involute: return involute(block, *target, exact_stop);
        case MotionKind::RigidTap: return tap(block, *target);
        case MotionKind::Arc: return arc(block, *target, exact_stop);
        case MotionKind::ArcThrough: return arc_over_point(block, *target, exact_stop);
        case MotionKind::ArcTangent: return arc_along(block, *target, exact_stop);
        default: break;  // a straight motion
    }
    if (arc_words != 0 && channel_.cornering.has_square_corner(block))
        channel_.cornering.wish_square_corner(block, *target);
    else if (arc_words != 0) warn_arc_word(block, arc_words);
    if (reporter_.has_ended()) return;
    line(block, *target, modal_.motion == Function::Rapid ? Op::Rapid : Op::Line, exact_stop);
}

AxisMask Motions::plane_mask() const {
    const path::PlaneAxes axes = path::axes_of(modal_.plane);
    return static_cast<AxisMask>(1u << index(axes.first) | 1u << index(axes.second));
}

/// The first motion behind the end of a rotation.
void Motions::check_place(const Block& block, SlotMask targets) {
    const SlotMask distances = modal_.is_incremental ? ~block.absolute : block.incremental;
    if ((distances & targets & unplaced_) != 0)
        reporter_.report(diag::IncrementBehindRotation, block);
    unplaced_ = 0;
}

void Motions::arrive(const Target& target) {
    position_.arrive(target.here, target.base,
                     static_cast<AxisMask>(target.moved & ~target.carried));
}

// ------------------------------------------------------------------------------ lines

void Motions::line(const Block& block, const Target& programmed, Op op, bool exact_stop) {
    Target target = programmed;
    std::optional<Probing> probing;
    if (op == Op::Line && !channel_.checks.require_feed(block, "line")) return;
    if (op == Op::Probe && !channel_.checks.require_probe_feed(block)) return;
    if (op == Op::Rapid) channel_.checks.check_rapid(block, target);
    if (tool_.has_changed) channel_.tool.activate_length(block, target.moved);
    if (spindle_.has_cutting_speed && op != Op::Probe) [[unlikely]]
        channel_.dangers.watch_cutting_speed(block, position_.here()[0], target.here[0]);
    if (target.orientation.waiting != nullptr &&
        !channel_.tool_motion.lay_directions(
            block, straight_path(linear(position_.base()), linear(target.base)), target))
        return;
    if (op == Op::Probe || probes_at_rapid(block)) {
        probing = probe_along(block, target, {position_.here(), target.here});
        if (probing->ends_move()) target = *probing->touched;
    }
    if (!channel_.checks.require_within_limits(block, target.base, target.moved)) return;
    position_.note_motion();
    path::Motion& motion = channel_.stages.put(op, block, &target.orientation).motion();
    motion.to = target.base;
    motion.moved = target.moved;
    motion.exact_stop = exact_stop;
    motion.feed = op == Op::Rapid ? 0 : modal_.feed;
    if (op == Op::Line && block.find(Function::TapFloating) != nullptr) {
        motion.keeps_feed = motion.ignores_hold = true;
        const bool by_minute = modal_.feed_mode == path::FeedMode::PerMinute && spindle_.speed > 0;
        if (by_minute && !block.is_of_cycle())
            channel_.dangers.watch_tap(block, Function::TapFloating);
    }
    if (dynamics_.has_positioning() && block.find(Function::RapidOnce) != nullptr)
        dynamics_.put_positioning(motion);
    if (op != Op::Rapid && channel_.feed.may_count_degrees(block))
        channel_.feed.count_degrees(block, motion);
    arrive(target);
    if (probing) note_probed(*probing);
}

MotionView Motions::motion_view() const {
    return {modal_.motion,
            modal_.plane,
            modal_.is_incremental,
            diameter_is_absolute_,
            channel_.transformation.is_transformed(),
            position_,
            frames_,
            axes_,
            virtual_.axes,
            rules_,
            dialect_.tables(),
            units_};
}

MotionWords Motions::motion_words() { return {motion_view(), reporter_}; }

}  // namespace kadr::interp
