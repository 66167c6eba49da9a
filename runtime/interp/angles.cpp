// angles.cpp — contours by angles: ends of lines that follow from directions.
#include <optional>

#include "base/diagnostics/iso.h"
#include "base/units.h"
#include "interp/channel.h"
#include "interp/executor.h"
#include "interp/motions.h"
#include "interp/stages.h"
#include "path/angled_line.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Group;
using nc::parameter_of;
using nc::Slot;
using nc::SlotMask;
using path::Vec2;

namespace {

constexpr std::size_t kAngle = parameter_of<Function::ContourAngle>("angle");

}  // namespace

path::Plane Executor::plane_in(const Block& block) const {
    const Function function = nc::programmed_in(block, Group::Plane);
    return function == Function::None ? modal_.plane : plane_of(function);
}

/// Whether the block is a line at an angle whose end only the next one will give; then it waits.
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
    const Vec2 from{position_.here()[index(axes.first)], position_.here()[index(axes.second)]};
    const Vec2 to{block.at(slots[0]) * axes_.word_scale[index(axes.first)],
                  block.at(slots[1]) * axes_.word_scale[index(axes.second)]};
    const Vec2 out = path::unit_at(first.argument(*first.find(Function::ContourAngle), kAngle));
    const Vec2 in = path::unit_at(block.argument(*angle, kAngle));
    const std::optional<Vec2> corner = path::meeting_point(from, out, to, in);
    if (!corner) {
        reporter_.report(diag::AngleWithoutCorner, block, Function::ContourAngle);
        return;
    }
    channel_.motions.motion_words().set_coordinate(first, axes.first, corner->x());
    channel_.motions.motion_words().set_coordinate(first, axes.second, corner->y());
    run(first);
    channel_.stages.settle(first);
    if (!reporter_.has_ended()) run(block);
}

/// Whether a word of the second line is a distance, with what both lines give for dimensions.
bool Executor::is_open_distance(const Block& first, const Block& second, Slot slot) const {
    if (((second.absolute | second.incremental) & bit(slot)) != 0)
        return (second.incremental & bit(slot)) != 0;
    Function function = nc::programmed_in(second, Group::Distance);
    if (function == Function::None) function = nc::programmed_in(first, Group::Distance);
    return function == Function::None ? modal_.is_incremental : function == Function::Incremental;
}

}  // namespace kadr::interp
