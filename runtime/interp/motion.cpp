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
      course_(channel.state.tool.course),
      virtual_(channel.state.tool.virtual_axes),
      diameter_is_absolute_(channel.state.motion.diameter_is_absolute),
      corners_(channel.state.stage.corners),
      comp_(channel.state.stage.comp),
      comp_3d_(channel.state.stage.comp_3d),
      units_(channel.state.motion.units),
      dynamics_(channel.state.motion.dynamics),
      unplaced_(channel.state.motion.unplaced),
      told_(channel.state.told),
      axes_(channel.state.axes),
      length_shift_(channel.state.motion.length_shift),
      preset_(channel.state.motion.preset),
      modal_cycles_(channel.state.cycle.modal_cycles),
      shape_(channel.state.cycle.shape) {}

void Motions::move(const Block& block, const Actions& actions) {
    if (block.motion != Function::None) modal_.move_by(block.motion);
    if (nc::ends_modal_cycle(block)) channel_.cycles.end_by_motion_code();
    const SlotMask targets = block.given & nc::kTargetSlots;
    SlotMask arc_words = block.given & kArcSlots;
    const bool has_arc = arc_words != 0 && nc::has_fact(modal_.motion, nc::Fact::Circle);
    const bool may_move = targets != 0 || actions.tool.turns() || has_arc;
    if (may_move && !channel_.tool_motion.require_point_to_point_way(block, actions)) return;
    // They have told where the compensation ends.
    if (arc_words != 0 && channel_.compensation.leave_direction(block))
        arc_words &= ~nc::kCenterSlots;
    if (actions.soft != nullptr && (comp_3d_.is_on() || comp_.chosen() != CompKind::InPlane)) {
        reporter_.report(diag::CompSpaceStart, block, actions.soft->function);
        return;
    }
    if (actions.soft != nullptr) {
        return actions.soft->function == Function::SmoothApproach
                   ? channel_.approaches.approach_smoothly(block, actions)
                   : channel_.approaches.retract_smoothly(block, actions);
    }
    if (actions.reference != nullptr) return refer(block, *actions.reference);
    if (actions.measure != nullptr) return measure_length(block, *actions.measure);
    if (actions.probes && comp_.is_on()) {
        reporter_.report(diag::ProbeCompensated, block, Function::Probe);
        return;
    }
    if (targets != 0 && (actions.machine_coordinates || actions.probes) &&
        !channel_.cycles.require_no_cycle(block, actions))
        return;
    if (actions.calls_behind_motions) {
        return channel_.cycles.call_behind_motions(actions.cycle != nullptr ? &block : nullptr);
    }
    if (actions.cycle_is_cancelled) return channel_.cycles.move_instead_of_cycle(block, actions);
    if (actions.cycle != nullptr) return channel_.cycles.call_cycle(block, actions);
    constexpr SlotMask kCycleSlots = nc::kTargetSlots | bit(Slot::Radius);
    if (modal_cycles_.modal.is_active && (block.given & kCycleSlots) != 0 &&
        !actions.machine_coordinates)
        return channel_.cycles.repeat_cycle(block, actions);
    if (!channel_.checks.require_no_move_before_tap(block, targets)) return;
    if (actions.orient_reset != nullptr)
        return channel_.tool_motion.reset_orientation(block, *actions.orient_reset);
    const bool is_elsewhere = actions.machine_coordinates && !channel_.frames.are_off();
    if (actions.tool.is_any() && !nc::has_fact(modal_.motion, nc::Fact::TakesOrientation)) {
        reporter_.report(diag::IsoNotSupported, block).arg("a tool that turns beside a thread");
        return;
    }
    if (modal_.motion == Function::Spline && !is_elsewhere &&
        (targets != 0 || block.find(Function::SplineKnot) != nullptr))
        return channel_.splines.spline(block, actions.tool);
    const bool goes_through =
        modal_.motion == Function::AkimaSpline || modal_.motion == Function::CubicSpline;
    if (goes_through && !is_elsewhere && targets != 0 && !channel_.splines.only_turns(block))
        return channel_.splines.go_through(block, targets, actions.tool);
    const bool has_polynomial = targets != 0 || block.find(Function::PolynomialAxis) != nullptr;
    if (modal_.motion == Function::Polynomial && !is_elsewhere && has_polynomial)
        return channel_.splines.polynomial(block, actions.tool,
                                           channel_.smoothing.stops_exactly(actions.exact_stop));
    if (targets == 0 && !actions.tool.turns() &&
        (arc_words == 0 || !nc::has_fact(modal_.motion, nc::Fact::Circle))) {
        if (arc_words != 0) warn_arc_word(block, arc_words);
        if (actions.switches_length) return channel_.tool.move_behind_switch(block);
        if (actions.length_changed) channel_.tool.move_length_alone(block);
        return;
    }
    if (!motion_words().require_axes(block, targets) ||
        !motion_words().require_rotary_approaches(block))
        return;
    if (actions.at_rapid && !channel_.transformation.require_no_lone_axis(block, targets)) return;
    if ((unplaced_ & targets) != 0) [[unlikely]]
        check_place(block, targets);
    if (is_elsewhere) return move_in_machine_coordinates(block);

    Target target = motion_words().target_of(block, targets);
    if (orienting_.is_on && !channel_.tool_motion.orient(block, actions, target)) return;
    if (comp_.takes_surface_normals() && !channel_.compensation.lay_surface(block, actions.tool))
        return;
    if (tilted_plane_.carries || tilted_plane_.on_tables) {
        // In the base system every linear axis may move, whatever the block names.
        target.moved = static_cast<AxisMask>(target.moved | (axes_.present & kLinearXYZ));
        channel_.tilted_planes.check_carried(block);
    }
    if (is_lathe_ && (targets & bit(Slot::C)) != 0) {
        constexpr auto kC = index(Axis::C);
        const double turn = std::abs(target.here[kC] - position_.here()[kC]);
        const bool turns =
            spindle_.mode == path::SpindleMode::Cw || spindle_.mode == path::SpindleMode::Ccw;
        const bool cuts = modal_.motion == Function::Line && (targets & kLinearXYZ) != 0;
        // From zero, as where nobody has used C as an axis: a chamfer without its comma.
        const bool is_tiny =
            position_.here()[kC] == 0 && turn > 0 && turn < danger::kLeastSpindleTurn;
        const std::string hint = hint_at_comma(dialect_.tables(), Axis::C, block.at(Slot::C));
        if (turns && cuts && is_tiny && !hint.empty() && !block.is_of_cycle()) {
            reporter_.report(diag::TinyRotation, block, Slot::C)
                .arg("C" + format_shortest(round_to(block.at(Slot::C), 4)))
                .arg(round_to(target.here[kC], 4))
                .fix(hint);
        }
    }
    if (actions.way_offset != 0 && !increase_by_tool_offset(block, actions.way_offset, target))
        return;
    // At rapid a way to a place of the machine ends at rest on every control.
    const bool goes_to_machine = channel_.frames.are_off() && modal_.motion == Function::Rapid;
    const bool exact_stop = channel_.smoothing.stops_exactly(actions.exact_stop || goes_to_machine);
    if (actions.at_rapid && comp_.is_on() && (targets & plane_mask()) != 0) {
        reporter_.report(diag::CompMotion, block);
        return;
    }
    if (actions.suspends_length) return move_without_length(block, target, exact_stop);
    if (actions.at_rapid) return line(block, target, Op::Rapid, true);
    if (actions.taps) return line(block, target, Op::Line, exact_stop);
    if (actions.probes && arc_words != 0) warn_arc_word(block, arc_words);
    if (actions.probes)
        return line(block, target, probes_at_rapid(block) ? Op::Rapid : Op::Probe, true);
    if (modal_.motion == Function::Thread || nc::has_fact(modal_.motion, nc::Fact::VaryingThread))
        return thread(block, target, actions);
    if (nc::has_fact(modal_.motion, nc::Fact::ArcThread))
        return thread_along_arc(block, target, actions);
    if (nc::has_fact(modal_.motion, nc::Fact::Involute)) return involute(block, target, exact_stop);
    if (is_tapping(modal_.motion)) return tap(block, target);
    if (is_arc(modal_.motion)) return arc(block, target, exact_stop);
    if (modal_.motion == Function::ArcThrough) return arc_over_point(block, target, exact_stop);
    if (modal_.motion == Function::ArcTangent) return arc_along(block, target, exact_stop);
    if (arc_words != 0 && channel_.cornering.has_square_corner(block))
        channel_.cornering.wish_square_corner(block, target);
    else if (arc_words != 0) warn_arc_word(block, arc_words);
    if (reporter_.has_ended()) return;
    line(block, target, modal_.motion == Function::Rapid ? Op::Rapid : Op::Line, exact_stop);
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
    if (course_ && !channel_.tool_motion.lay_directions(
                       block, straight_path(linear(position_.base()), linear(target.base)), target))
        return;
    if (op == Op::Probe || probes_at_rapid(block)) {
        probing = probe_along(block, target, {position_.here(), target.here});
        if (probing->ends_move()) target = *probing->touched;
    }
    if (!channel_.checks.require_within_limits(block, target.base, target.moved)) return;
    position_.note_motion();
    Command& command = channel_.stages.put(op, block);
    command.to = target.base;
    command.moved = target.moved;
    command.exact_stop = exact_stop;
    command.feed = op == Op::Rapid ? 0 : modal_.feed;
    if (op == Op::Line && block.find(Function::TapFloating) != nullptr) {
        command.keeps_feed = command.ignores_hold = true;
        const bool by_minute = modal_.feed_mode == path::FeedMode::PerMinute && spindle_.speed > 0;
        if (by_minute && !block.is_of_cycle())
            channel_.dangers.watch_tap(block, Function::TapFloating);
    }
    if (dynamics_.has_positioning() && block.find(Function::RapidOnce) != nullptr)
        dynamics_.put_positioning(command);
    if (op != Op::Rapid && channel_.feed.may_count_degrees(block))
        channel_.feed.count_degrees(block, command);
    arrive(target);
    if (probing) note_probed(*probing);
}

/// What the words of a block mean here.
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
