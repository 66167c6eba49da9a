// spline_neighbours.cpp — the direction in which the block behind a spline begins, for its end.
//
// The block is not executed yet: what it programs for its motion is read under the state that it
// will find. What is wrong with its words is reported here already.
//
// No direction has a block that takes its own from the spline before it: a tangent arc, another
// spline through points. Nor one that moves the zero first, or programs no motion of X, Y and Z.
#include <Eigen/Geometry>

#include "interp/block_words.h"
#include "interp/channel.h"
#include "interp/motions.h"
#include "interp/splines.h"
#include "path/curve.h"
#include "path/linear.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Slot;
using nc::SlotMask;
using path::ControlPoint;
using path::linear;
using path::Vec3;

namespace {

/// Where a helix begins: along the circle, and up by what the angle brings.
Vec3 start_of(const path::Arc& arc) {
    const double height = arc.normal.dot(arc.end - arc.start);
    const Vec3 flat = arc.normal.cross(arc.start - arc.center);
    return arc.sweep > 0 ? Vec3(flat + arc.normal * (height / arc.sweep)) : flat;
}

/// Towards the first control point that is not where the curve begins, in space: the derivative of
/// the lowest order that does not vanish.
Vec3 start_of(const std::vector<ControlPoint>& control_points) {
    const Vec3 start = control_points[0].head<3>() / control_points[0][3];
    for (const ControlPoint& control_point : control_points) {
        const Vec3 delta = control_point.head<3>() - control_point[3] * start;
        if (delta.norm() > path::kSameKnot) return delta;
    }
    return Vec3::Zero();
}

std::optional<Vec3> direction_into_arc(MotionWords& words, const Block& block, Target target) {
    if (words.view().frames.is_stretched(words.view().plane)) return std::nullopt;
    const bool has_form = (block.given & (nc::kCenterSlots | bit(Slot::Radius))) != 0;
    if (!has_form && !block.has(Slot::Opening)) return std::nullopt;
    const auto arc = block.has(Slot::Opening) ? words.arc_by_opening(block, target)
                                              : words.resolve_arc(block, target);
    return arc ? std::optional(start_of(*arc)) : std::nullopt;
}

/// In the programmed system, of any length; nothing if the block has none, or it was reported.
std::optional<Vec3> direction_into_next(MotionWords& words, const Block& block) {
    const Function motion = words.view().motion;
    if (motion == Function::Polynomial) {
        const auto polynomials = words.polynomials_of(block);
        return polynomials ? std::optional(start_of(polynomials->control_points)) : std::nullopt;
    }
    const SlotMask targets = block.given & nc::kTargetSlots;
    if (targets == 0 && !is_arc(motion) && !nc::has_fact(motion, nc::Fact::Involute))
        return std::nullopt;
    if (!words.require_axes(block, targets)) return std::nullopt;
    Target target = words.target_of(block, targets);
    const Vec3 start = linear(words.view().position.here());
    const Vec3 delta = linear(target.here) - start;
    if (is_arc(motion)) return direction_into_arc(words, block, target);
    if (nc::has_fact(motion, nc::Fact::Involute)) {
        const auto involute = words.involute_words(block);
        if (!involute) return std::nullopt;
        if (block.has(Slot::Opening) && !words.take_involute_end(block, *involute, target))
            return std::nullopt;
        return path::evaluate(path::make_involute(start, linear(target.here), involute->center,
                                                  involute->normal, involute->base_radius),
                              0)
            .tangent;
    }
    if (motion == Function::ArcThrough) {
        const auto arc =
            path::arc_through({start, linear(target.here)}, words.through_point(block));
        return arc ? std::optional(start_of(*arc)) : std::nullopt;
    }
    // The first control point of a spline is where the tool is: the curve leaves it for the next.
    const bool is_straight = nc::has_fact(motion, nc::Fact::Straight) || motion == Function::Spline;
    return is_straight ? std::optional(delta) : std::nullopt;
}

}  // namespace

/// In the base system, of length 1; nothing if the block has none, or it was reported.
std::optional<Vec3> Splines::direction_into(const Block& next) {
    // Where positions are in another frame is not known before the block is executed.
    if (next.find(nc::Fact::MovesPositions) != nullptr) return std::nullopt;
    MotionView view = channel_.motions.motion_view();
    view.take(next);
    MotionWords words(view, reporter_);
    std::optional<Vec3> delta;
    if ((next.given & nc::kPolarSlots) != 0) {
        Polar polar = position_words_.polar();
        const std::optional<Block> made = words.with_polar_slots(next, polar);
        if (made) delta = direction_into_next(words, *made);
    } else {
        delta = direction_into_next(words, next);
    }
    if (!delta) return std::nullopt;
    const Vec3 direction = frames_.total().direction(*delta);
    const double length = direction.norm();
    return length > path::kSameKnot ? std::optional(Vec3(direction / length)) : std::nullopt;
}

}  // namespace kadr::interp
