// polar.cpp — polar coordinates: blocks that say angle and radius become blocks that say places.
#include <bit>
#include <cmath>

#include "base/diagnostics/iso.h"
#include "base/units.h"
#include "interp/block_words.h"
#include "interp/executor.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using nc::Slot;
using nc::SlotMask;

namespace {

constexpr double kFullTurn = 360;  // deg

}  // namespace

/// The pole by its coordinates or its polar coordinates, from where it is counted.
void Executor::set_pole(const Block& block, const Invocation& invocation) {
    constexpr double kHere = 0;
    constexpr double kPole = 2;
    constexpr std::size_t kX = parameter_of<Function::Pole>("x");
    constexpr std::size_t kAngle = parameter_of<Function::Pole>("angle");
    constexpr std::size_t kRadius = parameter_of<Function::Pole>("radius");
    const auto has = [&](std::size_t i) { return invocation.has(i); };
    const path::PlaneAxes plane = path::axes_of(modal_.plane);
    const std::size_t across = index(plane.normal);
    if (has(kX + across)) {
        reporter_.report(diag::PoleOutsidePlane, block, Function::Pole).arg(kAxisNames[across]);
        return;
    }
    const bool is_polar = has(kAngle) || has(kRadius);
    const bool has_axes = has(kX + index(plane.first)) || has(kX + index(plane.second));
    const double angle_deg = block.argument(invocation, kAngle);
    const double radius = block.argument(invocation, kRadius);
    if (is_polar && has_axes) {
        const Axis named = has(kX + index(plane.first)) ? plane.first : plane.second;
        reporter_.report(diag::PolarMixed, block, Function::Pole).arg(kAxisNames[index(named)]);
        return;
    }
    if (radius < 0) {
        reporter_.report(diag::PoleRadiusNegative, block, Function::Pole).arg(radius);
        return;
    }
    if (std::abs(angle_deg) > kFullTurn) {
        reporter_.report(diag::PoleAngleTooLarge, block, Function::Pole).arg(angle_deg);
        return;
    }
    path::Vec2 place{radius * std::cos(rad_from_deg(angle_deg)),
                     radius * std::sin(rad_from_deg(angle_deg))};
    if (!is_polar) {
        const auto word = [&](Axis axis) {
            return block.argument(invocation, kX + index(axis)) * axes_.word_scale[index(axis)];
        };
        place = {word(plane.first), word(plane.second)};
    }
    const double from = block.argument(invocation, parameter_of<Function::Pole>("from"));
    if (from == kHere) place += position_in_plane();
    if (from == kPole) place += polar_.pole;
    polar_.pole = place;
    polar_.angle_deg = 0;
    if (!rules_.center_stays) return;
    center_[index(plane.first)] = place.x();
    center_[index(plane.second)] = place.y();
}

path::Vec2 Executor::position_in_plane() const {
    const path::PlaneAxes plane = path::axes_of(modal_.plane);
    return {position_.here[index(plane.first)], position_.here[index(plane.second)]};
}

/// From here on the words of the plane's axes are radius and angle; until they are said, they are
/// those of the place where the tool is.
void Executor::switch_polar(bool is_on) {
    if (is_on && !polar_.is_on) {
        const path::Vec2 here = position_in_plane();
        polar_.pole = path::Vec2::Zero();
        polar_.radius = here.norm();
        polar_.angle_deg = deg_from_rad(std::atan2(here.y(), here.x()));
    }
    polar_.is_on = is_on;
    polar_original_.reset();
}

/// The block with places instead of polar coordinates; the block itself if it has none. Null: it
/// was reported.
const Block* Executor::with_positions(const Block& block) {
    if (polar_original_ && !block.is_of_cycle()) polar_original_.reset();
    if (!block.is_of_cycle()) {
        if (const Invocation* point = block.find(Function::PolarPoint))
            return with_polar_point(block, *point);
        if (block.motion != Function::None) polar_.is_by_points = false;
        const bool goes_on =
            polar_.is_by_points && block.has(Slot::Radius) && (block.given & nc::kTargetSlots) == 0;
        if (goes_on) return with_polar_point(block, {});
    }
    if ((block.given & nc::kPolarSlots) != 0) return with_polar_slots(block);
    if (!polar_.is_on || block.is_of_cycle()) return &block;
    const path::PlaneAxes plane = path::axes_of(modal_.plane);
    const SlotMask words =
        block.given & (bit(nc::slot_of(plane.first)) | bit(nc::slot_of(plane.second)));
    const bool is_place = block.find(nc::Fact::AtMachinePosition) != nullptr;
    if (words == 0 || is_place) return &block;
    polar_original_ = block;
    return with_polar_axes(block);
}

/// The end by angle and radius from the pole, in one form with its code or beside none. A radius
/// that has slipped to the word of an arc is the polar one: such an arc has no other.
const Block* Executor::with_polar_point(const Block& block, const Invocation& point) {
    constexpr std::size_t kAngle = parameter_of<Function::PolarPoint>("angle");
    constexpr std::size_t kRadius = parameter_of<Function::PolarPoint>("radius");
    const bool has_angle = point.has(kAngle);
    const bool has_own_radius = point.has(kRadius);
    const bool has_radius = has_own_radius || block.has(Slot::Radius);
    if (block.motion != Function::None) polar_.is_by_points = true;
    if (!polar_.is_by_points) {
        reporter_.report(diag::PolarPointAlone, block, Function::PolarPoint);
        return nullptr;
    }
    if (!take_pole(block)) return nullptr;
    if (has_radius && modal_.is_incremental) {
        reporter_.report(diag::IsoNotSupported, block)
            .arg("a polar radius under incremental dimensions");
        return nullptr;
    }
    Block said = block;
    said.given &= ~(nc::kCenterSlots | bit(Slot::Radius));
    if (has_radius)
        said.set(Slot::PolarRadius,
                 has_own_radius ? block.argument(point, kRadius) : block.at(Slot::Radius));
    if (!has_angle) {
        said.set(Slot::PolarAngle, polar_.angle_deg);
        said.absolute |= bit(Slot::PolarAngle);
        return with_polar_slots(said);
    }
    // Full turns beyond the angle of the end, of which a helix has several.
    const double angle_deg = block.argument(point, kAngle);
    const double turns = std::trunc(angle_deg / kFullTurn);
    const double rest = angle_deg - turns * kFullTurn;
    said.set(Slot::PolarAngle, rest);
    const Function motion = block.motion != Function::None ? block.motion : modal_.motion;
    const double more = std::abs(turns) - (rest == 0 ? 1 : 0);
    if (!modal_.is_incremental || !is_arc(motion) || more < 1) return with_polar_slots(said);
    if ((angle_deg < 0) != (motion == Function::ArcCw)) {
        reporter_.report(diag::PolarAngleTooLarge, block, Function::PolarPoint, kAngle)
            .arg(angle_deg);
        return nullptr;
    }
    said.set(Slot::Turns, more);
    return with_polar_slots(said);
}

/// The pole is the centre that stays, and the tool's place is where angles and radii count on from.
Done Executor::take_pole(const Block& block) {
    const path::PlaneAxes plane = path::axes_of(modal_.plane);
    if (rules_.center_stays) {
        const std::optional<double> first = center_[index(plane.first)];
        const std::optional<double> second = center_[index(plane.second)];
        if (!first || !second) {
            reporter_.report(diag::PolarPoleMissing, block);
            return kFailed;
        }
        polar_.pole = {*first, *second};
    }
    const path::Vec2 arm = position_in_plane() - polar_.pole;
    polar_.radius = arm.norm();
    if (arm.norm() > path::kSamePoint)
        polar_.angle_deg = deg_from_rad(std::atan2(arm.y(), arm.x()));
    return kDone;
}

/// Angle and radius have words of their own.
const Block* Executor::with_polar_slots(const Block& block) {
    std::optional<Block> made = motion_words().with_polar_slots(block, polar_);
    if (!made) return nullptr;
    cartesian_ = *made;
    return &cartesian_;
}

/// The words of the plane's first and second axis are radius and angle. A radius that is a distance
/// counts from where the tool is, and there is the pole from then on.
const Block* Executor::with_polar_axes(const Block& block) {
    const path::PlaneAxes plane = path::axes_of(modal_.plane);
    const Slot radius = nc::slot_of(plane.first);
    const Slot angle = nc::slot_of(plane.second);
    if (block.has(radius)) {
        polar_.pole =
            motion_words().is_distance(block, radius) ? position_in_plane() : path::Vec2::Zero();
        polar_.radius = block.at(radius);
    }
    if (block.has(angle)) {
        // The reader took the number for a length.
        const double angle_deg =
            units_ == Units::Inch ? block.at(angle) / kMmPerInch : block.at(angle);
        polar_.angle_deg =
            motion_words().is_distance(block, angle) ? polar_.angle_deg + angle_deg : angle_deg;
    }
    cartesian_ = motion_words().at_polar(block, polar_);
    return &cartesian_;
}

}  // namespace kadr::interp
