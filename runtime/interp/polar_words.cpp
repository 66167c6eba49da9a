// polar_words.cpp — radius and angle become coordinates.
#include <bit>
#include <cmath>

#include "base/diagnostics/iso.h"
#include "base/units.h"
#include "interp/block_words.h"
#include "interp/motion_words.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Slot;
using nc::SlotMask;

namespace {}  // namespace

/// Angle and radius have words of their own.
std::optional<Block> MotionWords::with_polar_slots(const Block& block, Polar& polar) {
    const path::PlaneAxes plane = path::axes_of(view_.plane);
    for (const Axis axis : {plane.first, plane.second}) {
        if (!block.has(nc::slot_of(axis))) continue;
        reporter_.report(diag::PolarMixed, block, nc::slot_of(axis)).arg(kAxisNames[index(axis)]);
        return std::nullopt;
    }
    if (block.has(Slot::PolarRadius)) {
        if (block.at(Slot::PolarRadius) < 0) {
            reporter_.report(diag::PolarRadiusNegative, block, Slot::PolarRadius)
                .arg(block.at(Slot::PolarRadius));
            return std::nullopt;
        }
        polar.radius = block.at(Slot::PolarRadius);
    }
    if (block.has(Slot::PolarAngle)) {
        const double angle_deg = block.at(Slot::PolarAngle);
        if (std::abs(angle_deg) > kFullTurn) {
            reporter_.report(diag::PolarAngleTooLarge, block, Slot::PolarAngle).arg(angle_deg);
            return std::nullopt;
        }
        polar.angle_deg =
            is_distance(block, Slot::PolarAngle) ? polar.angle_deg + angle_deg : angle_deg;
    }
    Block made = at_polar(block, polar);
    const Function motion = block.motion != Function::None ? block.motion : view_.motion;
    if (!is_arc(motion)) return made;
    // The pole is the centre of the arc.
    const SlotMask others = block.given & (nc::kCenterSlots | nc::kThroughSlots |
                                           bit(Slot::Radius) | bit(Slot::Opening));
    if (others != 0) {
        const auto slot = static_cast<Slot>(std::countr_zero(others));
        reporter_.report(diag::ArcWordsMixed, block, slot).arg(slot_word(slot));
        return std::nullopt;
    }
    for (const auto& [axis, value] :
         {std::pair(plane.first, polar.pole.x()), std::pair(plane.second, polar.pole.y())}) {
        const auto center =
            static_cast<Slot>(static_cast<std::size_t>(Slot::CenterX) + index(axis));
        made.set(center, value);
        made.absolute |= bit(center);
        made.incremental &= ~bit(center);
    }
    return made;
}

/// The block with the position that the polar coordinates have come to.
Block MotionWords::at_polar(const Block& block, const Polar& polar) const {
    const path::PlaneAxes plane = path::axes_of(view_.plane);
    const double angle = rad_from_deg(polar.angle_deg);
    const path::Vec2 point =
        polar.pole + polar.radius * path::Vec2(std::cos(angle), std::sin(angle));
    Block made = block;
    made.given &= ~nc::kPolarSlots;
    set_coordinate(made, plane.first, point.x());
    set_coordinate(made, plane.second, point.y());
    return made;
}

/// The axis goes to a coordinate of the programmed system.
void MotionWords::set_coordinate(Block& block, Axis axis, double value) const {
    const Slot slot = nc::slot_of(axis);
    block.set(slot, value / view_.axes.word_scale[index(axis)]);
    block.absolute |= bit(slot);
    block.incremental &= ~bit(slot);
    if (axis == Axis::X) {
        block.x_measure =
            view_.axes.word_scale[0] == 1 ? nc::XMeasure::Radius : nc::XMeasure::Diameter;
    }
}

}  // namespace kadr::interp
