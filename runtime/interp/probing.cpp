// probing.cpp — motions that probe, and what becomes of what they find.
//
// Without either the probe goes to the end of its path and counts as triggered there.
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "interp/answers.h"
#include "interp/block_words.h"
#include "interp/channel.h"
#include "interp/motions.h"
#include "interp/programmed_frames.h"
#include "nc/parameters.h"
#include "path/linear.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using nc::parameter_of_all;
using path::linear;

/// The motion up to a part of it.
Target Motions::part_of_move(const Target& target, double part) const {
    Target out = target;
    for (std::size_t i = 0; i < kAxes; ++i)
        out.base[i] = position_.base()[i] + part * (target.base[i] - position_.base()[i]);
    out.here = frames_.from_base(out.base);
    return out;
}

/// What the probe meets on its path.
///
/// move  in the coordinates of the block's words, which are the machine's under G53
Probing Motions::probe_along(const Block& block, const Target& target, const ProgrammedMove& move) {
    Probing probing;
    const Invocation& call = *block.find(Function::Probe);
    probing.goes_on = block.argument(call, parameter_of<Function::Probe>("through")) != 0;
    if (!probe_.knows_touches()) {
        if (reported_.first_time(RunNotice::Touch))
            reporter_.report(diag::TouchMissing, block, Function::Probe);
        probing.touched = target;
        return probing;
    }
    const bool springs_back = block.argument(call, parameter_of<Function::Probe>("input")) < 0;
    auto [is_given, part] = probe_.touch_of_event(block, move, axes_, units_, reporter_);
    if (!is_given && probe_.scene() != nullptr) part = touch_of_scene(target, springs_back);
    if (part) probing.touched = part_of_move(target, *part);
    return probing;
}

std::optional<double> Motions::touch_of_scene(const Target& target, bool springs_back) {
    if (!probe_.has_part()) {
        const std::int64_t offset = probe_.scene()->offset;
        probe_.place_part(offset > 0 ? chain(frames_.base(), channel_.frames.work_offset_at(offset))
                                     : control::ControlFrame());
    }
    const bool has_edge = tool_.source == Tool::Source::Edge;
    const machine::ToolData* const tool = machine_.find_tool(tool_.current);
    const double radius = has_edge          ? tool_offsets_.radius(tool_.edge_number())
                          : tool != nullptr ? tool->radius
                                            : 0;
    return probe_.touch_of_scene(
        {linear(position_.base()), linear(target.base), radius, tool_.axis, springs_back});
}

/// Behind the motion: what the probe has found.
void Motions::note_probed(const Probing& probing) {
    const Position end = position_;
    // Where the probe goes on, the axes stood elsewhere as it triggered.
    if (probing.touched && probing.goes_on) {
        position_.arrive(probing.touched->here, probing.touched->base, 0);
    }
    Probed probed;
    probed.is_found = probing.touched.has_value();
    probed.tip = position_.here();
    for (std::size_t i = 0; i < kAxes; ++i) {
        probed.head[i] =
            *channel_.answers.position_of(nc::SystemQuantity::HeadPosition, static_cast<Axis>(i));
        probed.machine[i] = *channel_.answers.position_of(nc::SystemQuantity::MachinePosition,
                                                          static_cast<Axis>(i));
    }
    probe_.find(probed);
    position_ = end;
}

void Motions::use_probed(const Block& block, const Invocation& invocation) {
    if (!probe_.knows_touches() || !probe_.found()) return;
    const auto axis_at = [&](std::size_t parameter) {
        return channel_.answers.axis_of(count_of(block, invocation, parameter));
    };
    switch (invocation.function) {
        case Function::ProbeCheck:
            if (!probe_.found()->is_found)
                reporter_.report(diag::ProbeMissed, block, invocation.function);
            return;
        case Function::ProbeClear:
            if (probe_.found()->is_found)
                reporter_.report(diag::ProbeMet, block, invocation.function);
            return;
        case Function::ProbeKeep:
            if (const auto axis = axis_at(parameter_of<Function::ProbeKeep>("axis")))
                probe_.keep(probe_.found()->tip[index(*axis)]);
            return;
        case Function::OffsetToEdge:
        case Function::OffsetToMiddle: {
            constexpr std::size_t kOffset =
                parameter_of_all<"offset", Function::OffsetToEdge, Function::OffsetToMiddle>();
            constexpr std::size_t kAxis =
                parameter_of_all<"axis", Function::OffsetToEdge, Function::OffsetToMiddle>();
            constexpr std::size_t kAt =
                parameter_of_all<"at", Function::OffsetToEdge, Function::OffsetToMiddle>();
            const std::int64_t number = count_of(block, invocation, kOffset);
            const auto axis = axis_at(kAxis);
            if (!axis || number < 0 || number > rules_.work_offsets) return;
            const double found = probe_.found()->tip[index(*axis)];
            const bool is_middle = invocation.function == Function::OffsetToMiddle;
            const double along = is_middle ? (probe_.kept() + found) / 2 : found;
            const double before = channel_.frames.work_offset_at(number).shift[index(*axis)];
            channel_.frames.set_work_offset(
                number, *axis, before + along - block.argument(invocation, kAt), false);
            return;
        }
        default: return;
    }
}

}  // namespace kadr::interp
