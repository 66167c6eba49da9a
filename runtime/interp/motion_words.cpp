// motion_words.cpp — where the words of a block lead, in the programmed system and in the base
// system.
#include "interp/motion_words.h"

#include <bit>
#include <cmath>

#include "base/diagnostics/iso.h"
#include "interp/block_words.h"
#include "interp/word_hints.h"
#include "path/linear.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Slot;
using nc::SlotMask;
using path::linear;
using path::Vec3;

void MotionView::take(const Block& block) {
    const Function distance = nc::programmed_in(block, nc::Group::Distance);
    if (distance != Function::None) is_incremental = distance == Function::Incremental;
    if (block.motion != Function::None) motion = block.motion;
}

Target MotionWords::target_of(const Block& block, SlotMask targets) const {
    Target target{view_.position.here(), view_.position.base(), static_cast<AxisMask>(targets)};
    const SlotMask incremental = view_.is_incremental ? ~block.absolute : block.incremental;
    const AxisValues& last = view_.rules.incremental_frame == nc::IncrementalFrame::Traversed
                                 ? view_.position.programmed()
                                 : view_.position.here();
    const AxisValues& shift = view_.frames.shift_values();
    for (SlotMask rest = targets; rest != 0; rest &= rest - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(rest));
        const bool is_distance = (incremental >> i & 1u) != 0;
        double value =
            block.values[i] * (i == 0 ? x_scale(block, is_distance) : view_.axes.word_scale[i]);
        if (is_distance) value += last[i];
        target.here[i] = value;
        target.base[i] = value + shift[i];
    }
    if (block.rotary_approaches != 0) turn_rotary(block, target);
    if (!view_.frames.is_shift()) target.base = view_.frames.to_base(target.here);
    return target;
}

/// What a word for X is multiplied with: half a diameter is a radius.
double MotionWords::x_scale(const Block& block, bool is_distance) const {
    switch (block.x_measure) {
        case nc::XMeasure::Diameter: return 0.5;
        case nc::XMeasure::Radius: return 1;
        case nc::XMeasure::Modal: break;
    }
    return view_.is_diameter_absolute && is_distance ? 1 : view_.axes.word_scale[index(Axis::X)];
}

/// Positions of rotary axes whose direction is programmed lie within one turn.
Done MotionWords::require_rotary_approaches(const Block& block) {
    if (block.rotary_approaches == 0) return kDone;
    for (const Axis axis : {Axis::A, Axis::B, Axis::C}) {
        const nc::RotaryApproach approach = block.rotary_approach(axis);
        const double parameter = block.at(nc::slot_of(axis));
        const bool is_free = approach == nc::RotaryApproach::AsProgrammed;
        if (is_free || (parameter >= 0 && parameter < 360)) continue;
        reporter_.report(diag::RotaryRange, block, nc::slot_of(axis)).arg(parameter);
        return kFailed;
    }
    return kDone;
}

/// Rotary axes go to a position within a revolution by the approach that the word gives.
void MotionWords::turn_rotary(const Block& block, Target& target) const {
    for (const Axis axis : {Axis::A, Axis::B, Axis::C}) {
        const nc::RotaryApproach approach = block.rotary_approach(axis);
        if (approach == nc::RotaryApproach::AsProgrammed || !block.has(nc::slot_of(axis))) continue;
        const std::size_t i = index(axis);
        double turn = std::fmod(block.values[i] - view_.position.here()[i], 360);
        if (approach == nc::RotaryApproach::Shortest) turn = std::remainder(turn, 360);
        if (approach == nc::RotaryApproach::Positive && turn < 0) turn += 360;
        if (approach == nc::RotaryApproach::Negative && turn > 0) turn -= 360;
        target.here[i] = view_.position.here()[i] + turn;
        target.base[i] = target.here[i] + view_.frames.shift_values()[i];
    }
}

Done MotionWords::require_axes(const Block& block, SlotMask targets) {
    SlotMask missing = targets & ~SlotMask{view_.axes.present};
    if (view_.virtual_axes.turns()) {
        missing &= ~bit(nc::slot_of(view_.virtual_axes.virtual_axis()));
        if (const Slot turning = nc::slot_of(view_.virtual_axes.rotary);
            (targets & bit(turning)) != 0) {
            reporter_.report(diag::VirtualRotary, block, turning).arg(nc::slot_name(turning));
            return kFailed;
        }
    }
    if (missing == 0) return kDone;
    const Slot slot = first_slot(missing);
    DiagnosticBuilder message = reporter_.report(diag::AxisMissing, block, slot);
    message.arg(kAxisNames[static_cast<std::size_t>(slot)]);
    const std::string hint = hint_at_comma(view_.tables, static_cast<Axis>(slot), block.at(slot));
    if (!hint.empty() && !block.is_of_cycle()) message.fix(hint);
    return kFailed;
}

/// Whether a word is a distance: by itself, or as the modal state has it.
bool MotionWords::is_distance(const Block& block, Slot slot) const {
    return view_.is_incremental ? (block.absolute & bit(slot)) == 0
                                : (block.incremental & bit(slot)) != 0;
}

/// The point between, in the programmed system.
Vec3 MotionWords::through_point(const Block& block) const {
    Vec3 through = linear(view_.position.here());
    for (std::size_t i = 0; i < 3; ++i) {
        const auto slot = static_cast<Slot>(static_cast<std::size_t>(Slot::ThroughX) + i);
        if (!block.has(slot)) continue;
        double& value = through[static_cast<Eigen::Index>(i)];
        value = is_distance(block, slot) ? value + block.at(slot) : block.at(slot);
    }
    return through;
}

path::Vec2 MotionWords::position_in_plane() const {
    const path::PlaneAxes plane = path::axes_of(view_.plane);
    return {view_.position.here()[index(plane.first)], view_.position.here()[index(plane.second)]};
}

}  // namespace kadr::interp
