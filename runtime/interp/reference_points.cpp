// reference_points.cpp — motions in machine coordinates and to reference points.
#include <bit>
#include <cmath>
#include <utility>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "interp/block_words.h"
#include "interp/channel.h"
#include "interp/cycles.h"
#include "interp/motion_checks.h"
#include "interp/motions.h"
#include "interp/stages.h"
#include "interp/tool_in_use.h"
#include "interp/transformation.h"
#include "nc/parameters.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::parameter_of;
using nc::parameter_of_all;
using nc::SlotMask;
using path::Command;
using path::Op;

// ------------------------------------------------------------------------------ without frames

// --------------------------------------------------------------------------- positions

/// Machine coordinates are coordinates of the spindle nose: neither frames nor, on most controls,
/// the tool length act. The motion is none of the contour.
void Motions::move_in_machine_coordinates(const Block& block) {
    if (channel_.transformation.is_transformed()) {
        reporter_.report(diag::TransformationMotion, block, Function::MachineCoordinates)
            .arg("a position in machine coordinates");
        return;
    }
    // The skip function goes by distances as well, `G91 G53 G31 Z-5.`, and at its feed.
    const bool probes = block.find(Function::Probe) != nullptr;
    if (rules_.machine_coordinates_need_absolute && modal_.is_incremental && !probes) {
        reporter_.report(diag::MachineCoordinatesIgnored, block, Function::MachineCoordinates);
        return;
    }
    if (is_arc(modal_.motion) && !rules_.machine_coordinates_rapid) {
        reporter_.report(diag::ArcInMachineCoordinates, block, Function::MachineCoordinates);
        return;
    }
    const bool is_rapid =
        probes_at_rapid(block) ||
        (!probes && (rules_.machine_coordinates_rapid || modal_.motion == Function::Rapid));
    if (!is_rapid && !(probes ? channel_.checks.require_probe_feed(block)
                              : channel_.checks.require_feed(block, "line")))
        return;

    const SlotMask targets = block.given & nc::kTargetSlots;
    const bool has_length = rules_.machine_coordinates_keep_length;
    if (has_length && tool_.has_changed)
        channel_.tool.activate_length(block, static_cast<AxisMask>(targets));
    AxisValues to = position_.base();
    for (std::size_t i = 0; i < kAxes; ++i) to[i] += length_shift_[i];
    const SlotMask incremental = modal_.is_incremental ? ~block.absolute : block.incremental;
    for (SlotMask rest = targets; rest != 0; rest &= rest - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(rest));
        const double value = block.values[i] * axes_.word_scale[i];
        const bool is_distance = (incremental >> i & 1u) != 0;
        to[i] = is_distance ? to[i] + value : value + (has_length ? length_shift_[i] : 0);
    }
    Target target{{}, to, static_cast<AxisMask>(targets)};
    for (std::size_t i = 0; i < kAxes; ++i) target.base[i] -= length_shift_[i];
    target.here = frames_.from_base(target.base);
    Probing probing;
    if (probes) {
        ProgrammedMove move{position_.base(), target.base};
        for (std::size_t i = 0; i < kAxes && !has_length; ++i) {
            move.from[i] += length_shift_[i];
            move.to[i] += length_shift_[i];
        }
        probing = probe_along(block, target, move);
    }
    if (probing.ends_move()) {
        target = *probing.touched;
        for (std::size_t i = 0; i < kAxes; ++i) to[i] = target.base[i] + length_shift_[i];
    }
    if (!channel_.checks.require_within_limits(block, target.base, target.moved)) return;

    Command& command = channel_.stages.put(is_rapid ? Op::Rapid
                                           : probes ? Op::Probe
                                                    : Op::Line,
                                           block);
    command.is_unshifted = true;
    path::Motion& motion = command.motion();
    motion.to = to;
    motion.moved = target.moved;
    motion.machine_coordinates = true;
    motion.exact_stop = true;
    motion.feed = is_rapid ? 0 : modal_.feed;
    arrive(target);
    if (probes) note_probed(probing);
}

void Motions::rapid_to_machine_position(const Block& block, const AxisValues& to, AxisMask moved) {
    Target target{{}, to, moved};
    for (std::size_t i = 0; i < kAxes; ++i) target.base[i] -= length_shift_[i];
    target.here = frames_.from_base(target.base);
    if (!channel_.checks.require_within_machine(block, target.base, target.moved)) return;
    Command& command = channel_.stages.put(Op::Rapid, block);
    command.is_unshifted = true;
    path::Motion& motion = command.motion();
    motion.to = to;
    motion.moved = moved;
    motion.machine_coordinates = true;
    motion.exact_stop = true;
    motion.feed = 0;
    arrive(target);
}

/// A motion to a reference point, or from there; none of them stands among the holes of a cycle.
void Motions::refer(const Block& block, const nc::Invocation& invocation) {
    if (channel_.transformation.is_transformed()) {
        // The search for the reference point has no number; a fixed point may have the first.
        const bool is_fixed = invocation.function == Function::ReferencePoint &&
                              invocation.has(parameter_of<Function::ReferencePoint>("point"));
        if (is_fixed) {
            reporter_.report(diag::TransformationMotion, block, invocation.function)
                .arg("a fixed point");
        } else {
            reporter_.report(diag::TransformationReference, block, invocation.function);
        }
        return;
    }
    if (channel_.cycles.is_among_positions()) {
        reporter_.report(diag::ReferenceInCycle, block, invocation.function);
        return;
    }
    if (modal_cycles_.modal.is_active) channel_.cycles.forget_ends();
    switch (invocation.function) {
        case Function::ReferenceCheck: return check_reference(block);
        case Function::ReferenceLeave: return leave_reference(block);
        case Function::ReferencePoint:
        case Function::ReferenceReturn: return return_to_reference(block, invocation);
        default: break;  // no other is sent here
    }
}

/// To the programmed position, which must be the reference point of the axes that are named.
void Motions::check_reference(const Block& block) {
    constexpr double kWidth = 0.0005;  // mm, deg: half an increment
    const SlotMask targets = block.given & nc::kTargetSlots;
    if (targets == 0 || !motion_words().require_axes(block, targets)) return;
    line(block, motion_words().target_of(block, targets), Op::Rapid, true);
    for (std::size_t i = 0; i < kAxes && !reporter_.has_ended(); ++i) {
        if ((targets >> i & 1u) == 0) continue;
        const double at = position_.base()[i] + length_shift_[i];
        if (std::abs(at - axes_.reference_points[0][i]) <= kWidth) continue;
        reporter_.report(diag::ReferenceMissed, block, Function::ReferenceCheck)
            .arg(kAxisNames[i])
            .arg(round_to(at, 4))
            .arg(round_to(axes_.reference_points[0][i], 4));
    }
}

/// Over the position over which the axes went to their reference point, to the programmed one. A
/// distance counts from the intermediate point.
void Motions::leave_reference(const Block& block) {
    const SlotMask targets = block.given & nc::kTargetSlots;
    if (targets == 0 || !motion_words().require_axes(block, targets)) return;
    Target over{position_.here(), {}, static_cast<AxisMask>(targets)};
    for (std::size_t i = 0; i < kAxes; ++i) {
        if ((targets >> i & 1u) == 0) continue;
        if ((axes_.has_left >> i & 1u) == 0) {
            reporter_.report(diag::ReferenceNoPlace, block, Function::ReferenceLeave)
                .arg(kAxisNames[i]);
            return;
        }
        over.here[i] = axes_.left_over[i];
    }
    over.base = frames_.to_base(over.here);
    if (over.base != position_.base()) line(block, over, Op::Rapid, true);
    if (!reporter_.has_ended())
        line(block, motion_words().target_of(block, targets), Op::Rapid, true);
}

/// Makes the distances longer by the radius offset, so many times.
Done Motions::increase_by_tool_offset(const Block& block, double times, Target& target) {
    if (comp_.is_on()) {
        reporter_.report(diag::WayOffsetCompensated, block, Function::ToolOffsetIncrease);
        return kFailed;
    }
    if (nc::has_fact(modal_.motion, nc::Fact::Circle)) {
        reporter_.report(diag::IsoNotSupported, block, Function::ToolOffsetIncrease)
            .arg("an arc whose ends are moved by an offset");
        return kFailed;
    }
    const double offset = times * tool_offsets_.radius(tool_.radius_offset);
    for (std::size_t i = 0; i < kAxes; ++i) {
        if ((target.moved >> i & 1u) == 0) continue;
        target.here[i] += target.here[i] < position_.here()[i] ? -offset : offset;
    }
    target.base = frames_.to_base(target.here);
    return kDone;
}

/// Over the programmed position, if the block names one and the tool is not there, to the reference
/// point of the axes that are named.
void Motions::return_to_reference(const Block& block, const nc::Invocation& invocation) {
    const SlotMask targets = block.given & nc::kTargetSlots;
    auto moved = static_cast<AxisMask>(targets);
    if (invocation.function == Function::ReferencePoint) {
        constexpr std::size_t kX = parameter_of<Function::ReferencePoint>("x");
        moved = static_cast<AxisMask>(invocation.given >> kX & 0b111u);
    } else if (!motion_words().require_axes(block, targets)) {
        return;
    }
    constexpr std::size_t kPoint =
        parameter_of_all<"point", Function::ReferencePoint, Function::ReferenceReturn>();
    const double number = block.argument(invocation, kPoint, 1);
    const bool is_one = number >= 1 && number < machine::kReferencePoints + 1;
    const std::size_t point = is_one ? static_cast<std::size_t>(number) - 1 : 0;
    if (!is_one || (moved & ~axes_.has_reference_point[point]) != 0) {
        DiagnosticBuilder message =
            reporter_.report(diag::ReferenceUnknown, block, invocation.function);
        message.arg(number);
        if (is_one && point > 0)
            message.fix("the machine's file says where it is: `home" + std::to_string(point + 1) +
                        "` of the axis");
        return;
    }
    if (targets != 0) {
        const Target over = motion_words().target_of(block, targets);
        if (over.base != position_.base()) line(block, over, Op::Rapid, true);
        if (reporter_.has_ended()) return;
    }
    AxisValues to = position_.base();
    for (std::size_t i = 0; i < kAxes; ++i) {
        to[i] += length_shift_[i];
        if ((moved >> i & 1u) != 0) to[i] = axes_.reference_points[point][i];
    }
    for (std::size_t i = 0; i < kAxes; ++i)
        if ((moved >> i & 1u) != 0) axes_.left_over[i] = position_.here()[i];
    axes_.has_left = static_cast<AxisMask>(axes_.has_left | moved);
    if (moved != 0) rapid_to_machine_position(block, to, moved);
}

}  // namespace kadr::interp
