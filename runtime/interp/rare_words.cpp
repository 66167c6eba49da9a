// rare_words.cpp — rarer words of tools and positions: a block without the tool's length, a feed
// for each tooth, a measured length, positions that are set anew.
// source: SINUMERIK reference 2.1 (group 9), 2.3; FANUC reference 2.2 (G37)
#include <array>
#include <cmath>
#include <utility>

#include "base/diagnostics/iso.h"
#include "base/units.h"
#include "interp/answers.h"
#include "interp/channel.h"
#include "interp/motions.h"
#include "interp/programmed_frames.h"
#include "interp/tool_in_use.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using nc::SlotMask;
using nc::SystemQuantity;
using path::Op;

/// The axes of the block go to its position with their bare spindle; the length acts again with the
/// next motion of each.
void Motions::move_without_length(const Block& block, const Target& target, bool exact_stop) {
    if (orienting_.is_on || comp_.is_on()) {
        reporter_.report(diag::IsoNotSupported, block, Function::LengthSuspend)
            .arg(orienting_.is_on
                     ? "a block without tool offsets under a transformation"
                     : "a block without tool offsets under cutter radius compensation");
        return;
    }
    if (modal_.motion != Function::Rapid && modal_.motion != Function::Line) {
        reporter_.report(diag::IsoNotSupported, block, Function::LengthSuspend)
            .arg("a block without tool offsets that is no line");
        return;
    }
    channel_.tool.without_length([&] {
        line(block, target, modal_.motion == Function::Rapid ? Op::Rapid : Op::Line, exact_stop);
    });
}

void Motions::preset_axes(const Block& block, const Invocation& invocation) {
    if (orienting_.is_on || comp_.is_on() || corners_.is_active()) {
        reporter_.report(diag::PresetMisplaced, block, Function::Preset)
            .arg(orienting_.is_on ? "a transformation" : "cutter radius compensation");
        return;
    }
    constexpr std::size_t kAxis = parameter_of<Function::Preset>("axis");
    constexpr std::size_t kTo = parameter_of<Function::Preset>("to");
    constexpr std::size_t kEach = parameter_of<Function::Preset>("axis2") - kAxis;
    for (std::size_t i = 0; i < 3 * kEach; i += kEach) {
        if (!invocation.has(kAxis + i)) continue;
        const double name = block.argument(invocation, kAxis + i);
        const auto axis = channel_.answers.axis_of(std::llround(name));
        if (!axis || name >= 0) {
            reporter_.report(diag::PresetAxis, block, Function::Preset);
            return;
        }
        if (!invocation.has(kTo + i)) {
            reporter_.report(diag::PresetValue, block, Function::Preset)
                .arg(kAxisNames[index(*axis)]);
            return;
        }
        const double wanted =
            block.argument(invocation, kTo + i) * axes_.word_scale[index(*axis)] *
            (is_rotary(*axis) || units_ != ProgrammedUnits::Inch ? 1 : kMmPerInch);
        const double now = *channel_.answers.position_of(SystemQuantity::MachinePosition, *axis);
        frames_.preset(*axis, now - wanted);
        preset_[index(*axis)] += now - wanted;
    }
    channel_.frames.frame_changed();
    if (reported_.first_time(RunNotice::Preset))
        reporter_.report(diag::PresetLimits, block, Function::Preset);
}

/// Here every tool has the length that its offset gives: the tool comes to where the program
/// expects the sensor, and the offset stays.
void Motions::measure_length(const Block& block, const Invocation& invocation) {
    const SlotMask targets = block.given & nc::kTargetSlots;
    if ((targets & (targets - 1)) != 0 || targets == 0) {
        reporter_.report(diag::MeasureAxes, block, Function::MeasureLength);
        return;
    }
    if (invocation.has(parameter_of<Function::MeasureLength>("offset")) ||
        block.find(Function::LengthOffset) != nullptr) {
        reporter_.report(diag::MeasureOffsetBeside, block, Function::MeasureLength);
        return;
    }
    if (tool_.source != Tool::Source::Offset || tool_.offset == 0) {
        reporter_.report(diag::MeasureOffsetMissing, block, Function::MeasureLength);
        return;
    }
    if (comp_.is_on()) {
        reporter_.report(diag::ProbeCompensated, block, Function::MeasureLength);
        return;
    }
    if (modal_cycles_.modal.is_active) {
        reporter_.report(diag::MotionInCycle, block, Function::MeasureLength).arg("measure_length");
        return;
    }
    if (!motion_words().require_axes(block, targets)) return;
    if (reported_.first_time(RunNotice::Measure)) reporter_.report(diag::MeasureFinds, block);
    line(block, motion_words().target_of(block, targets), Op::Rapid, true);
}

}  // namespace kadr::interp
