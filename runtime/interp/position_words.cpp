// position_words.cpp — poles, polar coordinates, lines at an angle, centres that stay.
#include "interp/position_words.h"

#include <cmath>

#include "base/diagnostics/iso.h"
#include "base/units.h"
#include "interp/block_words.h"
#include "nc/parameters.h"
#include "path/angled_line.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using nc::Slot;
using nc::SlotMask;
using path::cross;
using path::Vec2;

void PositionWords::leave_plane() {
    polar_.pole = Vec2::Zero();
    polar_.angle_deg = 0;
}

const Block* PositionWords::repeated(MotionWords& words) {
    return original_ ? with_polar_axes(Block(*original_), words) : nullptr;
}

/// The pole by its coordinates or its polar coordinates, from where it is counted.
void PositionWords::set_pole(const Block& block, const Invocation& invocation,
                             const MotionWords& words) {
    constexpr double kHere = 0;
    constexpr double kPole = 2;
    constexpr std::size_t kX = parameter_of<Function::Pole>("x");
    constexpr std::size_t kAngle = parameter_of<Function::Pole>("angle");
    constexpr std::size_t kRadius = parameter_of<Function::Pole>("radius");
    const auto has = [&](std::size_t i) { return invocation.has(i); };
    const path::PlaneAxes plane = path::axes_of(words.view().plane);
    const std::size_t across = index(plane.normal);
    if (has(kX + across)) {
        words.reporter()
            .report(diag::PoleOutsidePlane, block, Function::Pole)
            .arg(kAxisNames[across]);
        return;
    }
    const bool is_polar = has(kAngle) || has(kRadius);
    const bool has_axes = has(kX + index(plane.first)) || has(kX + index(plane.second));
    const double angle_deg = block.argument(invocation, kAngle);
    const double radius = block.argument(invocation, kRadius);
    if (is_polar && has_axes) {
        const Axis named = has(kX + index(plane.first)) ? plane.first : plane.second;
        words.reporter()
            .report(diag::PolarMixed, block, Function::Pole)
            .arg(kAxisNames[index(named)]);
        return;
    }
    if (radius < 0) {
        words.reporter().report(diag::PoleRadiusNegative, block, Function::Pole).arg(radius);
        return;
    }
    if (std::abs(angle_deg) > kFullTurn) {
        words.reporter().report(diag::PoleAngleTooLarge, block, Function::Pole).arg(angle_deg);
        return;
    }
    path::Vec2 point{radius * std::cos(rad_from_deg(angle_deg)),
                     radius * std::sin(rad_from_deg(angle_deg))};
    if (!is_polar) {
        const auto word = [&](Axis axis) {
            return block.argument(invocation, kX + index(axis)) *
                   words.view().axes.word_scale[index(axis)];
        };
        point = {word(plane.first), word(plane.second)};
    }
    const double from = block.argument(invocation, parameter_of<Function::Pole>("from"));
    if (from == kHere) point += words.position_in_plane();
    if (from == kPole) point += polar_.pole;
    polar_.pole = point;
    polar_.angle_deg = 0;
    if (!words.view().rules.center_stays) return;
    centers_[index(plane.first)] = point.x();
    centers_[index(plane.second)] = point.y();
}

/// From here on the words of the plane's axes are radius and angle; until they are programmed, they
/// are those of the position where the tool is.
void PositionWords::switch_polar(bool is_on, const MotionWords& words) {
    if (is_on && !polar_.is_on) {
        const path::Vec2 here = words.position_in_plane();
        polar_.pole = path::Vec2::Zero();
        polar_.radius = here.norm();
        polar_.angle_deg = deg_from_rad(std::atan2(here.y(), here.x()));
    }
    polar_.is_on = is_on;
    original_.reset();
}

/// The block with positions instead of polar coordinates; the block itself if it has none. Null:
/// it was reported.
const Block* PositionWords::with_positions(const Block& block, MotionWords& words) {
    if (original_ && !block.is_of_cycle()) original_.reset();
    if (!block.is_of_cycle()) {
        if (const Invocation* point = block.find(Function::PolarPoint))
            return with_polar_point(block, *point, words);
        if (block.motion != Function::None) polar_.is_by_points = false;
        const bool goes_on =
            polar_.is_by_points && block.has(Slot::Radius) && (block.given & nc::kTargetSlots) == 0;
        if (goes_on) return with_polar_point(block, {}, words);
    }
    if ((block.given & nc::kPolarSlots) != 0) return with_polar_slots(block, words);
    if (!polar_.is_on || block.is_of_cycle()) return &block;
    const path::PlaneAxes plane = path::axes_of(words.view().plane);
    const SlotMask in_plane =
        block.given & (bit(nc::slot_of(plane.first)) | bit(nc::slot_of(plane.second)));
    const bool is_place = block.find(nc::Fact::AtMachinePosition) != nullptr;
    if (in_plane == 0 || is_place) return &block;
    original_ = block;
    return with_polar_axes(block, words);
}

/// The end by angle and radius from the pole, in one form with its code or beside none. A radius
/// that has slipped to the word of an arc is the polar one: such an arc has no other.
const Block* PositionWords::with_polar_point(const Block& block, const Invocation& point,
                                             MotionWords& words) {
    constexpr std::size_t kAngle = parameter_of<Function::PolarPoint>("angle");
    constexpr std::size_t kRadius = parameter_of<Function::PolarPoint>("radius");
    const bool has_angle = point.has(kAngle);
    const bool has_own_radius = point.has(kRadius);
    const bool has_radius = has_own_radius || block.has(Slot::Radius);
    if (block.motion != Function::None) polar_.is_by_points = true;
    if (!polar_.is_by_points) {
        words.reporter().report(diag::PolarPointAlone, block, Function::PolarPoint);
        return nullptr;
    }
    if (!take_pole(block, words)) return nullptr;
    if (has_radius && words.view().is_incremental) {
        words.reporter()
            .report(diag::IsoNotSupported, block)
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
        return with_polar_slots(said, words);
    }
    // Full turns beyond the angle of the end, of which a helix has several.
    const double angle_deg = block.argument(point, kAngle);
    const double turns = std::trunc(angle_deg / kFullTurn);
    const double rest = angle_deg - turns * kFullTurn;
    said.set(Slot::PolarAngle, rest);
    const Function motion = block.motion != Function::None ? block.motion : words.view().motion;
    const double more = std::abs(turns) - (rest == 0 ? 1 : 0);
    if (!words.view().is_incremental || !is_arc(motion) || more < 1)
        return with_polar_slots(said, words);
    if ((angle_deg < 0) != (motion == Function::ArcCw)) {
        words.reporter()
            .report(diag::PolarAngleTooLarge, block, Function::PolarPoint, kAngle)
            .arg(angle_deg);
        return nullptr;
    }
    said.set(Slot::Turns, more);
    return with_polar_slots(said, words);
}

/// The pole is the centre that stays, and angles and radii count on from the tool's position.
Done PositionWords::take_pole(const Block& block, const MotionWords& words) {
    const path::PlaneAxes plane = path::axes_of(words.view().plane);
    if (words.view().rules.center_stays) {
        const std::optional<double> first = centers_[index(plane.first)];
        const std::optional<double> second = centers_[index(plane.second)];
        if (!first || !second) {
            words.reporter().report(diag::PolarPoleMissing, block);
            return kFailed;
        }
        polar_.pole = {*first, *second};
    }
    const path::Vec2 arm = words.position_in_plane() - polar_.pole;
    polar_.radius = arm.norm();
    if (arm.norm() > path::kSamePoint)
        polar_.angle_deg = deg_from_rad(std::atan2(arm.y(), arm.x()));
    return kDone;
}

/// Angle and radius have words of their own.
const Block* PositionWords::with_polar_slots(const Block& block, MotionWords& words) {
    std::optional<Block> made = words.with_polar_slots(block, polar_);
    if (!made) return nullptr;
    cartesian_ = *made;
    return &cartesian_;
}

/// The words of the plane's first and second axis are radius and angle. A radius that is a distance
/// counts from where the tool is, and there is the pole from then on.
const Block* PositionWords::with_polar_axes(const Block& block, MotionWords& words) {
    const path::PlaneAxes plane = path::axes_of(words.view().plane);
    const Slot radius = nc::slot_of(plane.first);
    const Slot angle = nc::slot_of(plane.second);
    if (block.has(radius)) {
        polar_.pole =
            words.is_distance(block, radius) ? words.position_in_plane() : path::Vec2::Zero();
        polar_.radius = block.at(radius);
    }
    if (block.has(angle)) {
        // The reader took the number for a length.
        const double angle_deg = words.view().units == ProgrammedUnits::Inch
                                     ? block.at(angle) / kMmPerInch
                                     : block.at(angle);
        polar_.angle_deg =
            words.is_distance(block, angle) ? polar_.angle_deg + angle_deg : angle_deg;
    }
    cartesian_ = words.at_polar(block, polar_);
    return &cartesian_;
}

/// Where a centre stays, the block as if it had programmed it: an arc has the one that was
/// programmed last, if it has no radius; words that stand beside no arc have done all that they do.
const Block& PositionWords::with_center(const Block& block, const MotionWords& words) {
    const SlotMask programmed = block.given & nc::kCenterSlots;
    for (std::size_t i = 0; i < centers_.size(); ++i) {
        const Slot slot = static_cast<Slot>(static_cast<std::size_t>(Slot::CenterX) + i);
        if ((programmed & bit(slot)) == 0) continue;
        const double from = (block.absolute & bit(slot)) != 0 ? 0 : words.view().position.here()[i];
        centers_[i] = from + block.at(slot);
    }
    const Function motion = block.motion != Function::None ? block.motion : words.view().motion;
    const bool is_moved = (block.given & nc::kTargetSlots) != 0 || block.motion != Function::None;
    const bool turns = is_arc(motion) && is_moved;
    if (turns && block.has(Slot::Radius)) return block;
    if (!turns && programmed == 0) return block;
    centered_ = block;
    centered_.given &= ~nc::kCenterSlots;
    if (!turns) return centered_;
    const path::PlaneAxes plane = path::axes_of(words.view().plane);
    for (const Axis axis : {plane.first, plane.second}) {
        const Slot slot = static_cast<Slot>(static_cast<std::size_t>(Slot::CenterX) + index(axis));
        if (!centers_[index(axis)]) continue;
        centered_.set(slot, *centers_[index(axis)]);
        centered_.absolute |= bit(slot);
    }
    return centered_;
}

/// A line at an angle with one coordinate of its end, or with both, which have to agree. Null: it
/// was reported.
const Block* PositionWords::with_angle(const Block& block, const nc::Invocation& angle,
                                       MotionWords& words) {
    const Function motion = block.motion != Function::None ? block.motion : words.view().motion;
    const bool is_polar = (block.given & nc::kPolarSlots) != 0;
    if (!nc::has_fact(motion, nc::Fact::Straight) || is_polar) {
        words.reporter().report(diag::AngleMotion, block, Function::ContourAngle);
        return nullptr;
    }
    if (words.view().rules.angles_in_zx && words.view().plane != path::Plane::Zx) {
        words.reporter().report(diag::AnglePlane, block, Function::ContourAngle);
        return nullptr;
    }
    const path::PlaneAxes plane = path::axes_of(words.view().plane);
    const SlotMask in_plane =
        block.given & (bit(nc::slot_of(plane.first)) | bit(nc::slot_of(plane.second)));
    const Target said = words.target_of(block, in_plane);
    const Vec2 from = words.position_in_plane();
    const Vec2 to{said.here[index(plane.first)], said.here[index(plane.second)]};
    const Vec2 along =
        path::unit_at(block.argument(angle, parameter_of<Function::ContourAngle>("angle")));
    const bool has_first = block.has(nc::slot_of(plane.first));
    const bool has_second = block.has(nc::slot_of(plane.second));
    if (has_first && has_second) {
        if (std::abs(cross(along, to - from)) <= words.view().rules.arc_tolerance &&
            along.dot(to - from) >= 0)
            return &block;
        words.reporter().report(diag::AngleAndEnd, block, Function::ContourAngle);
        return nullptr;
    }
    const Eigen::Index given = has_first ? 0 : 1;
    const std::optional<Vec2> end = path::end_at(from, along, given, to[given]);
    if (!end) {
        words.reporter().report(diag::AngleWithoutCorner, block, Function::ContourAngle);
        return nullptr;
    }
    cartesian_ = block;
    const Axis open = has_first ? plane.second : plane.first;
    words.set_coordinate(cartesian_, open, (*end)[1 - given]);
    return &cartesian_;
}

}  // namespace kadr::interp
