// motion.cpp — where a block goes: which motion its words mean, its target, and lines.
#include <bit>
#include <cmath>

#include "base/danger_limits.h"
#include "base/diagnostics/doubtful.h"
#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "interp/block_words.h"
#include "interp/executor.h"
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

/// A block that goes to a machine coordinate or probes stands in no cycle. Behind a single cycle to
/// an end in X and Z the way to a machine coordinate is a motion of its own.
Done Executor::require_no_cycle(const Block& block, const Actions& actions) {
    if (!modal_cycles_.modal.is_active && actions.cycle == nullptr) return kDone;
    if (actions.cycle == nullptr && !actions.probes && !is_among_positions()) {
        forget_ends();
        return kDone;
    }
    const Function own = actions.probes ? Function::Probe : Function::MachineCoordinates;
    reporter_.report(diag::MotionInCycle, block, own).arg(reporter_.word_of(block, own));
    return kFailed;
}

void Executor::move(const Block& block, const Actions& actions) {
    if (block.motion != Function::None) modal_.motion = block.motion;
    if (nc::ends_modal_cycle(block)) {
        taps_rigidly_ &= !modal_cycles_.modal.is_active;
        modal_cycles_.modal.is_active = false;
    }
    const SlotMask targets = block.given & nc::kTargetSlots;
    SlotMask arc_words = block.given & kArcSlots;
    const bool has_arc = arc_words != 0 && nc::has_fact(modal_.motion, nc::Fact::Circle);
    const bool may_move = targets != 0 || actions.tool.turns() || has_arc;
    if (may_move && !require_point_to_point_way(block, actions)) return;
    // They have told where the compensation ends.
    if (arc_words != 0 && leave_direction(block)) arc_words &= ~nc::kCenterSlots;
    if (actions.soft != nullptr && (comp_3d_.is_on() || comp_.chosen() != CompKind::InPlane)) {
        reporter_.report(diag::CompSpaceStart, block, actions.soft->function);
        return;
    }
    if (actions.soft != nullptr) {
        return actions.soft->function == Function::SmoothApproach
                   ? approach_smoothly(block, actions)
                   : retract_smoothly(block, actions);
    }
    if (actions.reference != nullptr) return refer(block, *actions.reference);
    if (actions.measure != nullptr) return measure_length(block, *actions.measure);
    if (actions.probes && comp_.is_on()) {
        reporter_.report(diag::ProbeCompensated, block, Function::Probe);
        return;
    }
    if (targets != 0 && (actions.machine_coordinates || actions.probes) &&
        !require_no_cycle(block, actions))
        return;
    if (actions.calls_behind_motions) {
        modal_cycles_.behind_motions.reset();
        if (actions.cycle != nullptr) modal_cycles_.behind_motions = block;
        return;
    }
    if (actions.cycle_is_cancelled) return move_instead_of_cycle(block, actions);
    if (actions.cycle != nullptr) return call_cycle(block, actions);
    constexpr SlotMask kCycleSlots = nc::kTargetSlots | bit(Slot::Radius);
    if (modal_cycles_.modal.is_active && (block.given & kCycleSlots) != 0 &&
        !actions.machine_coordinates)
        return repeat_cycle(block, actions);
    if (!require_no_move_before_tap(block, targets)) return;
    if (actions.orient_reset != nullptr) return reset_orientation(block, *actions.orient_reset);
    const bool is_elsewhere = actions.machine_coordinates && !frames_off_;
    if (actions.tool.is_any() && !nc::has_fact(modal_.motion, nc::Fact::TakesOrientation)) {
        reporter_.report(diag::IsoNotSupported, block).arg("a tool that turns beside a thread");
        return;
    }
    if (modal_.motion == Function::Spline && !is_elsewhere &&
        (targets != 0 || block.find(Function::SplineKnot) != nullptr))
        return spline(block, actions.tool);
    const bool goes_through =
        modal_.motion == Function::AkimaSpline || modal_.motion == Function::CubicSpline;
    if (goes_through && !is_elsewhere && targets != 0 && !only_turns(block))
        return go_through(block, targets, actions.tool);
    const bool has_polynomial = targets != 0 || block.find(Function::PolynomialAxis) != nullptr;
    if (modal_.motion == Function::Polynomial && !is_elsewhere && has_polynomial)
        return polynomial(block, actions.tool, stops_exactly(actions.exact_stop));
    if (targets == 0 && !actions.tool.turns() &&
        (arc_words == 0 || !nc::has_fact(modal_.motion, nc::Fact::Circle))) {
        if (arc_words != 0) warn_arc_word(block, arc_words);
        if (actions.switches_length) return move_behind_switch(block);
        if (actions.length_changed) move_length_alone(block);
        return;
    }
    if (!motion_words().require_axes(block, targets) ||
        !motion_words().require_rotary_approaches(block))
        return;
    if (actions.at_rapid && !require_no_lone_axis(block, targets)) return;
    if ((unplaced_ & targets) != 0) [[unlikely]]
        check_place(block, targets);
    if (is_elsewhere) return move_in_machine_coordinates(block);

    Target target = motion_words().target_of(block, targets);
    if (orienting_.is_on && !orient(block, actions, target)) return;
    if (comp_.takes_surface_normals() && !lay_surface(block, actions.tool)) return;
    if (tilted_plane_.carries || tilted_plane_.on_tables) {
        // In the base system every linear axis may move, whatever the block names.
        target.moved = static_cast<AxisMask>(target.moved | (axes_.present & kLinearXYZ));
        check_carried(block);
    }
    if (is_lathe_ && (targets & bit(Slot::C)) != 0) {
        constexpr auto kC = index(Axis::C);
        const double turn = std::abs(target.here[kC] - position_.here[kC]);
        const bool turns =
            spindle_.mode == path::SpindleMode::Cw || spindle_.mode == path::SpindleMode::Ccw;
        const bool cuts = modal_.motion == Function::Line && (targets & kLinearXYZ) != 0;
        // From zero, as where nobody has used C as an axis: a chamfer without its comma.
        const bool is_tiny =
            position_.here[kC] == 0 && turn > 0 && turn < danger::kLeastSpindleTurn;
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
    const bool goes_to_machine = frames_off_ && modal_.motion == Function::Rapid;
    const bool exact_stop = stops_exactly(actions.exact_stop || goes_to_machine);
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
    if (arc_words != 0 && has_square_corner(block)) wish_square_corner(block, target);
    else if (arc_words != 0) warn_arc_word(block, arc_words);
    if (has_ended()) return;
    line(block, target, modal_.motion == Function::Rapid ? Op::Rapid : Op::Line, exact_stop);
}

AxisMask Executor::plane_mask() const {
    const path::PlaneAxes axes = path::axes_of(modal_.plane);
    return static_cast<AxisMask>(1u << index(axes.first) | 1u << index(axes.second));
}

/// The first motion behind the end of a rotation.
void Executor::check_place(const Block& block, SlotMask targets) {
    const SlotMask distances = modal_.is_incremental ? ~block.absolute : block.incremental;
    if ((distances & targets & unplaced_) != 0)
        reporter_.report(diag::IncrementBehindRotation, block);
    unplaced_ = 0;
}

void Executor::arrive(const Target& target) {
    const Vec3 before = linear(position_.base);
    if (before != linear(target.base)) came_from_ = before;
    position_.here = target.here;
    position_.base = target.base;
    const auto said = static_cast<AxisMask>(target.moved & ~target.carried);
    for (AxisMask rest = said; rest != 0; rest = static_cast<AxisMask>(rest & (rest - 1))) {
        const auto i = static_cast<std::size_t>(std::countr_zero(rest));
        position_.programmed[i] = target.here[i];
    }
}

// ------------------------------------------------------------------------------ lines

void Executor::line(const Block& block, const Target& programmed, Op op, bool exact_stop) {
    Target target = programmed;
    std::optional<Probing> probing;
    if (op == Op::Line && !require_feed(block, "line")) return;
    if (op == Op::Probe && !require_probe_feed(block)) return;
    if (op == Op::Rapid) check_rapid(block, target);
    if (tool_.has_changed) activate_length(block, target.moved);
    if (spindle_.has_cutting_speed && op != Op::Probe) [[unlikely]]
        watch_cutting_speed(block, position_.here[0], target.here[0]);
    if (course_ &&
        !lay_directions(block, straight_path(linear(position_.base), linear(target.base)), target))
        return;
    if (op == Op::Probe || probes_at_rapid(block)) {
        probing = probe_along(block, target, {position_.here, target.here});
        if (probing->ends_move()) target = *probing->touched;
    }
    if (!require_within_limits(block, target.base, target.moved)) return;
    has_moved_ = true;
    Command& command = put(op, block);
    command.to = target.base;
    command.moved = target.moved;
    command.exact_stop = exact_stop;
    command.feed = op == Op::Rapid ? 0 : modal_.feed;
    if (op == Op::Line && block.find(Function::TapFloating) != nullptr) {
        command.keeps_feed = command.ignores_hold = true;
        const bool by_minute = modal_.feed_mode == path::FeedMode::PerMinute && spindle_.speed > 0;
        if (by_minute && !block.is_of_cycle()) watch_tap(block, Function::TapFloating);
    }
    if (dynamics_.has_positioning() && block.find(Function::RapidOnce) != nullptr)
        dynamics_.put_positioning(command);
    if (op != Op::Rapid && may_count_degrees(block)) count_degrees(block, command);
    arrive(target);
    if (probing) note_probed(*probing);
}

}  // namespace kadr::interp
