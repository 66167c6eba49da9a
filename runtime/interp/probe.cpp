// probe.cpp — where the probe triggers: at the surfaces of the machine file, or where an event of
// the run gives it.
#include "interp/probe.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <string>

#include "base/diagnostics/control.h"
#include "base/numbers.h"
#include "base/units.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using path::Vec3;

const ProbeTouch* Probe::take_touch(const Block& block) {
    const ProbeTouch* found = nullptr;
    for (std::size_t i = 0; i < touches_.size(); ++i) {
        const ProbeTouch& touch = touches_[i];
        const bool is_here =
            touch.number >= 0 ? touch.number == block.number : touch.line == block.line;
        if (!is_here) continue;
        found = &touch;
        touches_done_.resize(touches_.size());
        if (touches_done_[i]) continue;
        touches_done_[i] = true;
        break;
    }
    return found;
}

Probe::Event Probe::touch_of_event(const Block& block, const ProgrammedMove& move,
                                   const AxisData& axes, ProgrammedUnits units,
                                   Reporter& reporter) {
    const ProbeTouch* const found = take_touch(block);
    if (found == nullptr) return {};
    for (std::size_t i = 0; i < kAxes; ++i) {
        if ((found->axes >> i & 1u) == 0) continue;
        const bool is_inch = units == ProgrammedUnits::Inch && !is_rotary(static_cast<Axis>(i));
        const double unit = axes.word_scale[i] * (is_inch ? kMmPerInch : 1);
        const double at = found->at[i] * unit;
        const double from = move.from[i];
        const double to = move.to[i];
        const double part = (at - from) / (to - from);
        constexpr double kRounding = 1e-9;
        if (std::isfinite(part) && part >= -kRounding && part <= 1 + kRounding)
            return {true, std::clamp(part, 0.0, 1.0)};
        reporter.report(diag::TouchAside, block, Function::Probe)
            .arg(std::string(kAxisNames[i]) + format_shortest(round_to(found->at[i], 6)))
            .arg(std::string(kAxisNames[i]) + format_shortest(round_to(from / unit, 6)))
            .arg(std::string(kAxisNames[i]) + format_shortest(round_to(to / unit, 6)));
        return {true, {}};
    }
    return {true, {}};
}

/// Several touches of one block are for several runs of it: one of them has come is enough.
std::vector<ProbeTouch> Probe::touches_ahead() const {
    std::vector<ProbeTouch> ahead;
    const auto is_done = [this](const ProbeTouch& touch) {
        for (std::size_t i = 0; i < touches_done_.size(); ++i) {
            const ProbeTouch& other = touches_[i];
            if (touches_done_[i] && other.number == touch.number && other.line == touch.line)
                return true;
        }
        return false;
    };
    std::ranges::copy_if(touches_, std::back_inserter(ahead), std::not_fn(is_done));
    return ahead;
}

std::optional<double> Probe::touch_of_scene(const SceneMove& move) const {
    const double radius = scene_->radius.value_or(move.tool_radius);
    Vec3 to_center = Vec3::Zero();
    if (!scene_->is_center_given)
        to_center[static_cast<Eigen::Index>(index(move.tool_axis))] = radius;
    const control::ControlFrame to_part = inverse(*part_);
    const auto local = [&](const Vec3& tip) -> Vec3 {
        return to_part.whole()(tip + to_center) - scene_->error;
    };
    const Vec3 from = local(move.from);
    const Vec3 to = local(move.to);
    return move.springs_back ? machine::first_release(*scene_, from, to, radius)
                             : machine::first_touch(*scene_, from, to, radius);
}

}  // namespace kadr::interp
