// involutes.cpp — involutes of circles in the working plane.
#include <cmath>

#include <Eigen/Geometry>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "base/units.h"
#include "interp/channel.h"
#include "interp/cornering.h"
#include "interp/motion_checks.h"
#include "interp/motions.h"
#include "interp/stages.h"
#include "interp/tool_in_use.h"
#include "path/curve.h"
#include "path/linear.h"

namespace kadr::interp {

using nc::Block;
using nc::Slot;
using path::linear;
using path::Vec3;

void Motions::involute(const Block& block, const Target& programmed, bool exact_stop) {
    if (!channel_.checks.require_feed(block, "involute")) return;
    channel_.cornering.leave_corners(diag::CornerNotContour);
    if (reporter_.has_ended()) return;
    if (frames_.is_stretched(modal_.plane)) {
        reporter_.report(diag::ArcStretched, block, modal_.motion);
        return;
    }
    const std::optional<path::InvoluteWords> words = motion_words().involute_words(block);
    if (!words) return;
    Target target = programmed;
    if (block.has(Slot::Opening) && !motion_words().take_involute_end(block, *words, target))
        return;
    const auto radius =
        path::base_radius_through(*words, linear(target.here), rules_.involute_tolerance);
    if (!radius) return motion_words().report_involute(block, radius.error());
    put_involute(block, *words, *radius, target, exact_stop);
}

void Motions::put_involute(const Block& block, const path::InvoluteWords& words, double radius,
                           const Target& target, bool exact_stop) {
    const path::Frame& frame = frames_.total();
    const Vec3 out = words.start - words.center;
    const Vec3 flat = out - out.dot(words.normal) * words.normal;
    const Vec3 first = frame.direction(flat);
    const Vec3 normal = first.cross(frame.direction(words.normal.cross(flat))).normalized();
    // Equal factors along the axes of the plane make a larger circle.
    const double base_radius = radius * first.norm() / flat.norm();
    const Vec3 center = frame(words.center);
    const path::Involute involute = path::make_involute(
        linear(position_.base()), linear(target.base), center, normal, base_radius);
    if (tool_.has_changed && !channel_.tool.activate_length_on_arc(block, normal, target.moved))
        return;
    if (!channel_.checks.require_within_limits(block, target.base, target.moved)) return;
    if (!channel_.checks.require_box_within_limits(block, path::bounds(involute))) return;
    position_.note_motion();
    path::Motion& motion =
        channel_.stages.put(path::Op::Involute, block, &target.orientation).motion();
    motion.to = target.base;
    motion.moved = target.moved;
    motion.exact_stop = exact_stop;
    const bool is_clockwise = normal.dot(path::unit(path::axes_of(modal_.plane).normal)) < 0;
    motion.shape = path::InvoluteShape{center, normal, base_radius, is_clockwise};
    motion.feed = modal_.feed;
    arrive(target);
    position_.come_from(involute.end - path::evaluate(involute, involute.length).tangent);
}

}  // namespace kadr::interp
