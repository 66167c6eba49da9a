// involutes.cpp — involutes of circles in the working plane.
#include <cmath>

#include <Eigen/Geometry>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "base/units.h"
#include "interp/executor.h"
#include "path/curve.h"
#include "path/linear.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Slot;
using nc::SlotMask;
using path::InvoluteFault;
using path::linear;
using path::Vec3;

void Executor::involute(const Block& block, const Target& programmed, bool exact_stop) {
    if (!require_feed(block, "involute")) return;
    leave_corners(diag::CornerNotContour);
    if (ended_) return;
    if (frames_.is_stretched(modal_.plane)) {
        report(diag::ArcStretched, block, modal_.motion);
        return;
    }
    const std::optional<path::InvoluteWords> words = involute_words(block);
    if (!words) return;
    Target target = programmed;
    if (block.has(Slot::Opening) && !take_involute_end(block, *words, target)) return;
    const auto radius =
        path::base_radius_through(*words, linear(target.here), rules_.involute_tolerance);
    if (!radius) return report_involute(block, radius.error());
    put_involute(block, *words, *radius, target, exact_stop);
}

/// What the block says of its involute but the end; nothing if it was reported.
std::optional<path::InvoluteWords> Executor::involute_words(const Block& block) {
    const SlotMask others = block.given & (nc::kThroughSlots | bit(Slot::Turns));
    if (others != 0) {
        report_arc_words(block, others);
        return std::nullopt;
    }
    if (!block.has(Slot::Radius) || (block.given & nc::kCenterSlots) == 0) {
        report(diag::InvoluteWordsMissing, block)
            .arg(block.has(Slot::Radius) ? "centre" : "radius of its base circle");
        return std::nullopt;
    }
    const Vec3 start = linear(position_.here);
    const std::optional<Vec3> center = center_of_arc(block, start);
    if (!center) return std::nullopt;
    const Vec3 third = path::unit(path::axes_of(modal_.plane).normal);
    const bool is_cw = modal_.motion == Function::InvoluteCw;
    return path::InvoluteWords{start, *center, is_cw ? Vec3(-third) : third,
                               block.at(Slot::Radius)};
}

/// The end of an involute that says the angle under which it is seen from the centre.
Done Executor::take_involute_end(const Block& block, const path::InvoluteWords& words,
                                 Target& target) {
    const path::PlaneAxes plane = path::axes_of(modal_.plane);
    const SlotMask in_plane = bit(nc::slot_of(plane.first)) | bit(nc::slot_of(plane.second));
    if (const SlotMask ends = block.given & in_plane; ends != 0) {
        report_arc_words(block, ends);
        return kFailed;
    }
    const auto end = path::involute_end(words, rad_from_deg(block.at(Slot::Opening)));
    if (!end) {
        report_involute(block, end.error());
        return kFailed;
    }
    for (const Axis axis : {plane.first, plane.second})
        target.here[index(axis)] = (*end)[static_cast<Eigen::Index>(index(axis))];
    target.base = frames_.to_base(target.here);
    target.moved = static_cast<AxisMask>(target.moved | bit(plane.first) | bit(plane.second));
    return kDone;
}

void Executor::put_involute(const Block& block, const path::InvoluteWords& words, double radius,
                            const Target& target, bool exact_stop) {
    const path::Frame& frame = frames_.total();
    const Vec3 out = words.start - words.center;
    const Vec3 flat = out - out.dot(words.normal) * words.normal;
    const Vec3 first = frame.direction(flat);
    const Vec3 normal = first.cross(frame.direction(words.normal.cross(flat))).normalized();
    // Equal factors along the axes of the plane make a larger circle.
    const double base_radius = radius * first.norm() / flat.norm();
    const Vec3 center = frame(words.center);
    const path::Involute involute = path::make_involute(linear(position_.base), linear(target.base),
                                                        center, normal, base_radius);
    if (tool_.has_changed && !activate_length_on_arc(block, normal, target.moved)) return;
    if (!require_within_limits(block, target.base, target.moved)) return;
    if (!require_box_within_limits(block, path::bounds(involute))) return;
    has_moved_ = true;
    path::Command& command = put(path::Op::Involute, block);
    command.to = target.base;
    command.moved = target.moved;
    command.exact_stop = exact_stop;
    command.center = center;
    command.normal = normal;
    command.base_radius = base_radius;
    command.is_clockwise = normal.dot(path::unit(path::axes_of(modal_.plane).normal)) < 0;
    command.turns = 0;
    command.feed = modal_.feed;
    arrive(target);
    came_from_ = involute.end - path::evaluate(involute, involute.length).tangent;
}

void Executor::report_involute(const Block& block, InvoluteFault fault) {
    switch (fault) {
        case InvoluteFault::Radius:
            report(diag::InvoluteRadius, block, Slot::Radius).arg(block.at(Slot::Radius));
            return;
        case InvoluteFault::Inside: report(diag::InvoluteInside, block); return;
        case InvoluteFault::Even:
        case InvoluteFault::EndOff: report(diag::InvoluteEndOff, block); return;
    }
}

}  // namespace kadr::interp
