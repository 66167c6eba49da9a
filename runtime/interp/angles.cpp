// angles.cpp — contours by angles: ends of lines that follow from directions.
#include <cmath>

#include "base/diagnostics/iso.h"
#include "base/units.h"
#include "interp/executor.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Group;
using nc::parameter_of;
using nc::Slot;
using nc::SlotMask;
using path::Vec2;

namespace {

/// Sine of the angle below which two directions are one.
constexpr double kParallel = 1e-9;

constexpr std::size_t kAngle = parameter_of<Function::ContourAngle>("angle");

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

Vec2 direction_of(double angle_deg) {
    const double angle = rad_from_deg(angle_deg);
    return {std::cos(angle), std::sin(angle)};
}

}  // namespace

path::Plane Executor::plane_in(const Block& block) const {
    const Function said = nc::programmed_in(block, Group::Plane);
    return said == Function::None ? modal_.plane : plane_of(said);
}

/// Whether the block is a line at an angle whose end only the next one will tell; then it waits.
bool Executor::opens_line(const Block& block) {
    if (block.is_of_cycle()) return false;
    const nc::Invocation* angle = block.find(Function::ContourAngle);
    if (angle == nullptr) return false;
    const path::PlaneAxes plane = path::axes_of(plane_in(block));
    const SlotMask ends = bit(nc::slot_of(plane.first)) | bit(nc::slot_of(plane.second));
    if ((block.given & (ends | nc::kPolarSlots)) != 0) return false;
    open_line_ = block;
    return true;
}

/// The second line of two: where they meet is the end of the first.
void Executor::close_line(const Block& block) {
    Block first = *open_line_;
    open_line_.reset();
    const nc::Invocation* angle = block.find(Function::ContourAngle);
    const Function first_motion = first.motion != Function::None ? first.motion : modal_.motion;
    const Function motion = block.motion != Function::None ? block.motion : first_motion;
    if (!nc::has_fact(first_motion, nc::Fact::Straight) ||
        !nc::has_fact(motion, nc::Fact::Straight)) {
        reporter_.report(diag::AngleMotion, block);
        return;
    }
    const path::Plane plane = plane_in(first);
    if (nc::programmed_in(block, Group::Plane) != Function::None && plane_in(block) != plane) {
        reporter_.report(diag::AnglePlane, block);
        return;
    }
    const path::PlaneAxes axes = path::axes_of(plane);
    const Slot slots[] = {nc::slot_of(axes.first), nc::slot_of(axes.second)};
    const bool has_end = block.has(slots[0]) && block.has(slots[1]);
    if ((block.given & nc::kTargetSlots) == 0 && angle == nullptr) {
        reporter_.report(diag::AngleSecondMissing, first);
        return;
    }
    if (angle == nullptr || !has_end || is_open_distance(first, block, slots[0]) ||
        is_open_distance(first, block, slots[1])) {
        reporter_.report(diag::AngleMissing, block);
        return;
    }
    const Vec2 from{position_.here[index(axes.first)], position_.here[index(axes.second)]};
    const Vec2 to{block.at(slots[0]) * axes_.word_scale[index(axes.first)],
                  block.at(slots[1]) * axes_.word_scale[index(axes.second)]};
    const Vec2 out = direction_of(first.argument(*first.find(Function::ContourAngle), kAngle));
    const Vec2 in = direction_of(block.argument(*angle, kAngle));
    const double w = cross(out, in);
    // Both ways go forward.
    const double along = std::abs(w) < kParallel ? -1 : cross(to - from, in) / w;
    const double beyond = std::abs(w) < kParallel ? -1 : cross(out, to - from) / w;
    if (!(along > 0) || !(beyond > 0)) {
        reporter_.report(diag::AngleWithoutCorner, block, Function::ContourAngle);
        return;
    }
    const Vec2 corner = from + along * out;
    motion_words().set_coordinate(first, axes.first, corner.x());
    motion_words().set_coordinate(first, axes.second, corner.y());
    run(first);
    settle(first);
    if (!has_ended()) run(block);
}

/// Whether a word of the second line is a distance, with what both lines say of dimensions.
bool Executor::is_open_distance(const Block& first, const Block& second, Slot slot) const {
    if (((second.absolute | second.incremental) & bit(slot)) != 0)
        return (second.incremental & bit(slot)) != 0;
    Function said = nc::programmed_in(second, Group::Distance);
    if (said == Function::None) said = nc::programmed_in(first, Group::Distance);
    return said == Function::None ? modal_.is_incremental : said == Function::Incremental;
}

/// A line at an angle with one coordinate of its end, or with both, which have to agree. Null: it
/// was reported.
const Block* Executor::with_angle(const Block& block, const nc::Invocation& angle) {
    const Function motion = block.motion != Function::None ? block.motion : modal_.motion;
    const bool is_polar = (block.given & nc::kPolarSlots) != 0;
    if (!nc::has_fact(motion, nc::Fact::Straight) || is_polar) {
        reporter_.report(diag::AngleMotion, block, Function::ContourAngle);
        return nullptr;
    }
    if (rules_.angles_in_zx && modal_.plane != path::Plane::Zx) {
        reporter_.report(diag::AnglePlane, block, Function::ContourAngle);
        return nullptr;
    }
    const path::PlaneAxes plane = path::axes_of(modal_.plane);
    const SlotMask words =
        block.given & (bit(nc::slot_of(plane.first)) | bit(nc::slot_of(plane.second)));
    const Target said = motion_words().target_of(block, words);
    const Vec2 from = position_in_plane();
    const Vec2 to{said.here[index(plane.first)], said.here[index(plane.second)]};
    const Vec2 along = direction_of(block.argument(angle, kAngle));
    const bool has_first = block.has(nc::slot_of(plane.first));
    const bool has_second = block.has(nc::slot_of(plane.second));
    if (has_first && has_second) {
        if (std::abs(cross(along, to - from)) <= rules_.arc_tolerance && along.dot(to - from) >= 0)
            return &block;
        reporter_.report(diag::AngleAndEnd, block, Function::ContourAngle);
        return nullptr;
    }
    const Vec2 way = to - from;
    const double part = has_first ? along.x() : along.y();
    const double length = std::abs(part) < kParallel ? -1 : (has_first ? way.x() : way.y()) / part;
    if (!(length >= 0)) {
        reporter_.report(diag::AngleWithoutCorner, block, Function::ContourAngle);
        return nullptr;
    }
    cartesian_ = block;
    const Axis open = has_first ? plane.second : plane.first;
    const Vec2 end = from + length * along;
    motion_words().set_coordinate(cartesian_, open, has_first ? end.y() : end.x());
    return &cartesian_;
}

}  // namespace kadr::interp
