// probing.cpp — where a probing motion ends: at the surfaces of the machine file, or where an event
// of the run says.
//
// Without either the probe goes to the end of its way and counts as triggered there.
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "interp/block_words.h"
#include "interp/executor.h"
#include "nc/parameters.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using nc::parameter_of_all;
using path::Vec3;

bool Executor::knows_touches() const {
    return options_.probe != nullptr || !options_.touches.empty();
}

/// The way up to a part of it.
Target Executor::part_of_move(const Target& target, double part) const {
    Target out = target;
    for (std::size_t i = 0; i < kAxes; ++i)
        out.base[i] = position_.base[i] + part * (target.base[i] - position_.base[i]);
    out.here = frames_.from_base(out.base);
    return out;
}

/// What the probe meets on its way.
///
/// way  in the coordinates of the block's words, which are the machine's under G53
Probing Executor::probe_along(const Block& block, const Target& target, const ProgrammedMove& way) {
    Probing probing;
    const Invocation& call = *block.find(Function::Probe);
    probing.goes_on = block.argument(call, parameter_of<Function::Probe>("through")) != 0;
    if (!knows_touches()) {
        if (told_.first_time(Once::Touch))
            reporter_.report(diag::TouchMissing, block, Function::Probe);
        probing.touched = target;
        return probing;
    }
    const bool springs_back = block.argument(call, parameter_of<Function::Probe>("input")) < 0;
    bool is_said = false;
    std::optional<double> part = touch_of_event(block, way, is_said);
    if (!is_said && options_.probe != nullptr) part = touch_of_scene(target, springs_back);
    if (part) probing.touched = part_of_move(target, *part);
    return probing;
}

/// The part of the way that an event says. Of several for one block each is for one run of it, the
/// last one for all behind.
std::optional<double> Executor::touch_of_event(const Block& block, const ProgrammedMove& way,
                                               bool& is_said) {
    const ProbeTouch* found = nullptr;
    for (std::size_t i = 0; i < options_.touches.size(); ++i) {
        const ProbeTouch& touch = options_.touches[i];
        const bool is_here =
            touch.number >= 0 ? touch.number == block.number : touch.line == block.line;
        if (!is_here) continue;
        found = &touch;
        touches_done_.resize(options_.touches.size());
        if (touches_done_[i]) continue;
        touches_done_[i] = true;
        break;
    }
    is_said = found != nullptr;
    if (!is_said || found->axes == 0) return std::nullopt;
    for (std::size_t i = 0; i < kAxes; ++i) {
        if ((found->axes >> i & 1u) == 0) continue;
        const bool is_inch = units_ == Units::Inch && !is_rotary(static_cast<Axis>(i));
        const double unit = axes_.word_scale[i] * (is_inch ? kMmPerInch : 1);
        const double at = found->at[i] * unit;
        const double from = way.from[i];
        const double to = way.to[i];
        const double part = (at - from) / (to - from);
        constexpr double kRounding = 1e-9;
        if (std::isfinite(part) && part >= -kRounding && part <= 1 + kRounding)
            return std::clamp(part, 0.0, 1.0);
        reporter_.report(diag::TouchAside, block, Function::Probe)
            .arg(std::string(kAxisNames[i]) + format_shortest(round_to(found->at[i], 6)))
            .arg(std::string(kAxisNames[i]) + format_shortest(round_to(from / unit, 6)))
            .arg(std::string(kAxisNames[i]) + format_shortest(round_to(to / unit, 6)));
        return std::nullopt;
    }
    return std::nullopt;
}

/// Several touches of one block are for several runs of it: one of them has come is enough.
std::vector<ProbeTouch> Executor::touches_ahead() const {
    std::vector<ProbeTouch> ahead;
    const auto is_done = [this](const ProbeTouch& touch) {
        for (std::size_t i = 0; i < touches_done_.size(); ++i) {
            const ProbeTouch& other = options_.touches[i];
            if (touches_done_[i] && other.number == touch.number && other.line == touch.line)
                return true;
        }
        return false;
    };
    std::ranges::copy_if(options_.touches, std::back_inserter(ahead), std::not_fn(is_done));
    return ahead;
}

std::optional<double> Executor::touch_of_scene(const Target& target, bool springs_back) {
    const machine::ProbeScene& scene = *options_.probe;
    // A part stays where it is, whatever becomes of the offset that tells its nominal place.
    if (!probe_frame_) {
        probe_frame_ = control::ControlFrame();
        if (scene.offset > 0) probe_frame_ = chain(frames_.base(), work_offset_at(scene.offset));
    }
    const bool has_edge = tool_.source == Tool::Source::Edge;
    const machine::ToolData* const tool = machine_.find_tool(tool_.current);
    const double of_tool = has_edge          ? tool_offsets_.radius(tool_.edge_number())
                           : tool != nullptr ? tool->radius
                                             : 0;
    const double radius = scene.radius.value_or(of_tool);
    Vec3 to_center = Vec3::Zero();
    if (!scene.is_center_told) to_center[static_cast<Eigen::Index>(index(tool_.axis))] = radius;
    const auto local = [&](const AxisValues& base) -> Vec3 {
        const Vec3 center = Vec3(base[0], base[1], base[2]) + to_center;
        return inverse(*probe_frame_).whole()(center) - scene.error;
    };
    const Vec3 from = local(position_.base);
    const Vec3 to = local(target.base);
    return springs_back ? machine::first_release(scene, from, to, radius)
                        : machine::first_touch(scene, from, to, radius);
}

/// Behind the motion: what the probe has found.
void Executor::note_probed(const Probing& probing) {
    const Position end = position_;
    // Where the probe goes on, the axes stood elsewhere as it triggered.
    if (probing.touched && probing.goes_on) {
        position_.here = probing.touched->here;
        position_.base = probing.touched->base;
    }
    probed_.emplace();
    probed_->is_found = probing.touched.has_value();
    probed_->tip = position_.here;
    for (std::size_t i = 0; i < kAxes; ++i) {
        probed_->head[i] = *place_of(nc::Quantity::HeadPosition, static_cast<Axis>(i));
        probed_->machine[i] = *place_of(nc::Quantity::MachinePosition, static_cast<Axis>(i));
    }
    position_ = end;
}

/// The library's words about what was probed last. Where nobody has said where the part lies, it
/// lies where the program expects it.
void Executor::use_probed(const Block& block, const Invocation& invocation) {
    if (!knows_touches() || !probed_) return;
    const auto axis_at = [&](std::size_t parameter) {
        return axis_of(count_of(block, invocation, parameter));
    };
    switch (invocation.function) {
        case Function::ProbeCheck:
            if (!probed_->is_found) reporter_.report(diag::ProbeMissed, block, invocation.function);
            return;
        case Function::ProbeClear:
            if (probed_->is_found) reporter_.report(diag::ProbeMet, block, invocation.function);
            return;
        case Function::ProbeKeep:
            if (const auto axis = axis_at(parameter_of<Function::ProbeKeep>("axis")))
                probe_kept_ = probed_->tip[index(*axis)];
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
            const double found = probed_->tip[index(*axis)];
            const bool is_middle = invocation.function == Function::OffsetToMiddle;
            const double place = is_middle ? (probe_kept_ + found) / 2 : found;
            const double before = work_offset_at(number).shift[index(*axis)];
            set_work_offset(number, *axis, before + place - block.argument(invocation, kAt), false);
            return;
        }
        default: return;
    }
}

}  // namespace kadr::interp
