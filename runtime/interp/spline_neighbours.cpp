// spline_neighbours.cpp — the direction in which the block behind a spline begins, for its end.
//
// The block is not executed yet: what it says of its motion is understood under the modal state
// that it makes, and that is put back. What is wrong with its words is said here already.
//
// No direction has a block that takes its own from the spline before it: a tangent arc, another
// spline through points. Nor one that moves places first, or says no motion of X, Y and Z.
#include <Eigen/Geometry>

#include "interp/block_words.h"
#include "interp/executor.h"
#include "path/curve.h"
#include "path/linear.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Slot;
using nc::SlotMask;
using path::linear;
using path::Pole;
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
Vec3 start_of(const std::vector<Pole>& poles) {
    const Vec3 start = poles[0].head<3>() / poles[0][3];
    for (const Pole& pole : poles) {
        const Vec3 way = pole.head<3>() - pole[3] * start;
        if (way.norm() > path::kSameKnot) return way;
    }
    return Vec3::Zero();
}

}  // namespace

/// In the base system, of length 1; nothing if the block has none, or it was reported.
std::optional<Vec3> Executor::direction_into(const Block& next) {
    if (frames_change_in(next)) return std::nullopt;
    const Modal modal_before = modal_;
    const Polar polar_before = polar_;
    if (next.find(Function::Incremental) != nullptr) modal_.is_incremental = true;
    if (next.find(Function::Absolute) != nullptr) modal_.is_incremental = false;
    if (next.motion != Function::None) modal_.motion = next.motion;
    const bool is_polar = (next.given & nc::kPolarSlots) != 0;
    const Block* const places = is_polar ? with_polar_slots(next) : &next;
    const std::optional<Vec3> way = places != nullptr ? direction_into_next(*places) : std::nullopt;
    modal_ = modal_before;
    polar_ = polar_before;
    if (!way) return std::nullopt;
    const Vec3 direction = frames_.total().direction(*way);
    const double length = direction.norm();
    return length > path::kSameKnot ? std::optional(Vec3(direction / length)) : std::nullopt;
}

/// The same in the programmed system, of any length; polar coordinates have become places, and the
/// motion is modal.
std::optional<Vec3> Executor::direction_into_next(const Block& block) {
    const Function motion = modal_.motion;
    if (motion == Function::Polynomial) {
        const auto course = polynomials_of(block);
        return course ? std::optional(start_of(course->poles)) : std::nullopt;
    }
    const SlotMask targets = block.given & nc::kTargetSlots;
    if (targets == 0 && !is_arc(motion) && !nc::has_fact(motion, nc::Fact::Involute))
        return std::nullopt;
    if (!require_axes(block, targets)) return std::nullopt;
    Target target = target_of(block, targets);
    const Vec3 start = linear(position_.here);
    const Vec3 way = linear(target.here) - start;
    if (is_arc(motion)) return way_into_arc(block, target);
    if (nc::has_fact(motion, nc::Fact::Involute)) {
        const auto words = involute_words(block);
        if (!words) return std::nullopt;
        if (block.has(Slot::Opening) && !take_involute_end(block, *words, target))
            return std::nullopt;
        const path::Involute involute = path::make_involute(
            start, linear(target.here), words->center, words->normal, words->base_radius);
        return path::evaluate(involute, 0).tangent;
    }
    switch (motion) {
        case Function::ArcThrough: {
            const auto arc = path::arc_through({start, linear(target.here)}, through_point(block));
            return arc ? std::optional(start_of(*arc)) : std::nullopt;
        }
        case Function::Line:
        case Function::Rapid:
        // Its first control point is where the tool is, and the curve leaves it for the next one.
        case Function::Spline: return way;
        default: return std::nullopt;
    }
}

std::optional<Vec3> Executor::way_into_arc(const Block& block, Target target) {
    if (frames_.is_stretched(modal_.plane)) return std::nullopt;
    const bool has_form = (block.given & (nc::kCenterSlots | bit(Slot::Radius))) != 0;
    if (!has_form && !block.has(Slot::Opening)) return std::nullopt;
    const auto arc =
        block.has(Slot::Opening) ? arc_by_opening(block, target) : resolve_arc(block, target);
    return arc ? std::optional(start_of(*arc)) : std::nullopt;
}

/// Whether the block changes where places are: its direction is not known before it is executed.
bool Executor::frames_change_in(const Block& block) const {
    return block.find(nc::Fact::MovesPositions) != nullptr;
}

}  // namespace kadr::interp
