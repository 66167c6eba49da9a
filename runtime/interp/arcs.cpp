// arcs.cpp — arcs as the words of a block give them, and as the frame makes them.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

#include "base/diagnostics/doubtful.h"
#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "interp/block_words.h"
#include "interp/channel.h"
#include "interp/danger_watch.h"
#include "interp/motion_checks.h"
#include "interp/motions.h"
#include "interp/stages.h"
#include "interp/tool_in_use.h"
#include "interp/tool_motion.h"
#include "path/helix.h"
#include "path/linear.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Slot;
using nc::SlotMask;
using path::Command;
using path::FeedMode;
using path::linear;
using path::Op;
using path::Vec3;

namespace {

/// How much longer the path of a helix is than the arc that it is over.
double length_by_arc(const path::Arc& arc) {
    const double height = arc.normal.dot(arc.end - arc.start);
    const Vec3 to = arc.end - arc.center - height * arc.normal;
    const double radius = ((arc.start - arc.center).norm() + to.norm()) / 2;
    return std::hypot(radius * arc.sweep, height) / (radius * arc.sweep);
}

/// The axis of a plane that a machine does not have; nothing: it has both.
std::optional<Axis> missing_axis(AxisMask present, path::Plane plane) {
    const path::PlaneAxes axes = path::axes_of(plane);
    if ((present & bit(axes.first)) == 0) return axes.first;
    if ((present & bit(axes.second)) == 0) return axes.second;
    return std::nullopt;
}

}  // namespace

void Motions::arc(const Block& block, const Target& target, bool exact_stop) {
    if (!channel_.checks.require_feed(block, "arc")) return;
    const auto missing = missing_axis(axes_.present, modal_.plane);
    if (missing && !virtual_.axes.is_on()) {
        DiagnosticBuilder message = reporter_.report(diag::AxisMissing, block, modal_.motion);
        message.arg(kAxisNames[index(*missing)]);
        if (is_lathe_ && modal_.plane != path::Plane::Zx)
            message.fix("the plane of a lathe is that of Z and X, `G18`");
        return;
    }
    if (frames_.is_stretched(modal_.plane)) return stretched_arc(block, target, exact_stop);
    const bool has_opening = block.has(Slot::Opening);
    const bool has_form = (block.given & (nc::kCenterSlots | bit(Slot::Radius))) != 0;
    if (!has_form && !has_opening && rules_.arc_without_center == nc::ArcWithoutCenter::Line) {
        if (target.moved != 0 && reported_.first_time(RunNotice::ArcIsLine))
            reporter_.report(diag::ArcIsLine, block, modal_.motion);
        return line(block, target, Op::Line, exact_stop);
    }
    if (const SlotMask through = block.given & nc::kThroughSlots; through != 0) {
        motion_words().report_arc_words(block, through);
        return;
    }
    Target end = target;
    const std::optional<path::Arc> resolved = has_opening
                                                  ? motion_words().arc_by_opening(block, end)
                                                  : motion_words().resolve_arc(block, target);
    if (resolved) put_arc(block, *resolved, end, exact_stop);
}

/// An arc of the programmed system becomes one of the base system, and a command. A frame that
/// mirrors turns the arc round, which the product of two directions across its axis shows.
void Motions::put_arc(const Block& block, const path::Arc& programmed, const Target& target,
                      bool exact_stop) {
    const path::PlaneAxes plane = path::axes_of(modal_.plane);
    const Vec3 third = path::unit(plane.normal);
    const path::Frame& frame = frames_.total();
    const double side = programmed.normal.dot(third);
    const bool is_plane_tilted = std::abs(side) < 1 - 1e-12;
    const Vec3 first =
        is_plane_tilted ? programmed.normal.unitOrthogonal() : path::unit(plane.first);
    const Vec3 second = is_plane_tilted ? Vec3(programmed.normal.cross(first))
                                        : Vec3(side * path::unit(plane.second));
    const path::Arc arc{linear(position_.base()), linear(target.base), frame(programmed.center),
                        frame.direction(first).cross(frame.direction(second)).normalized(),
                        programmed.sweep};
    put_base_arc(block, arc, target, exact_stop);
}

/// Under unequal factors: an arc by its radius between the scaled ends, where the control makes
/// one.
void Motions::stretched_arc(const Block& block, const Target& target, bool exact_stop) {
    const SlotMask thirds = bit(nc::slot_of(path::axes_of(modal_.plane).normal));
    const bool is_helix = !block.has(Slot::Radius) && (block.given & thirds) != 0;
    if (!rules_.arc_radius_scaled_by_larger || frames_.is_plane_tilted(modal_.plane) || is_helix) {
        reporter_.report(diag::ArcStretched, block, modal_.motion);
        return;
    }
    if (!block.has(Slot::Radius)) return stretched_arc_about_center(block, target, exact_stop);
    const std::optional<int> turns = motion_words().turns_of(block);
    if (!turns) return;
    const path::ArcEnds ends{linear(position_.base()), linear(target.base)};
    const bool is_cw = (modal_.motion == Function::ArcCw) != frames_.is_mirrored(modal_.plane);
    const Result<path::Arc, path::ArcFault> arc =
        path::arc_of_radius(ends, block.at(Slot::Radius) * frames_.larger_factor(modal_.plane),
                            {modal_.plane, is_cw, *turns});
    if (!arc) return motion_words().report_radius_arc(block, arc.error(), ends);
    put_base_arc(block, *arc, target, exact_stop);
}

/// Centre and end are scaled each by its axis; the arc goes about the centre to the direction of
/// the end, and a line to the end itself.
void Motions::stretched_arc_about_center(const Block& block, const Target& target,
                                         bool exact_stop) {
    const std::optional<Vec3> programmed =
        motion_words().center_of_arc(block, linear(position_.here()));
    if (!programmed) return;
    const Vec3 third = path::unit(path::axes_of(modal_.plane).normal);
    const Vec3 start = linear(position_.base());
    Vec3 center = frames_.total()(*programmed);
    center += (start - center).dot(third) * third;
    const Vec3 out = start - center;
    const Vec3 to_end = linear(target.base) - center;
    const bool has_radius = out.norm() > path::kSamePoint && to_end.norm() > path::kSamePoint;
    if (!has_radius) {
        reporter_.report(diag::ArcCenterMissing, block, modal_.motion);
        return;
    }
    const bool is_cw = (modal_.motion == Function::ArcCw) != frames_.is_mirrored(modal_.plane);
    const Vec3 normal = is_cw ? Vec3(-third) : third;
    double sweep = std::atan2(normal.dot(out.cross(to_end)), out.dot(to_end));
    if (sweep <= 0) sweep += 2 * std::numbers::pi;
    const path::Arc arc{start, center + to_end.normalized() * out.norm(), center, normal, sweep};
    Target turned = target;
    for (std::size_t i = 0; i < 3; ++i) turned.base[i] = arc.end[static_cast<Eigen::Index>(i)];
    turned.here = frames_.from_base(turned.base);
    const bool is_on_arc = (arc.end - linear(target.base)).norm() < path::kSamePoint;
    put_base_arc(block, arc, turned, exact_stop && is_on_arc);
    if (!is_on_arc && !reporter_.has_ended()) line(block, target, Op::Line, exact_stop);
}

/// An arc of the base system as a command.
void Motions::put_base_arc(const Block& block, const path::Arc& arc, const Target& programmed,
                           bool exact_stop) {
    const Vec3 third = path::unit(path::axes_of(modal_.plane).normal);
    Target target = programmed;
    if (tool_.has_changed && !channel_.tool.activate_length_on_arc(block, arc.normal, target.moved))
        return;
    if (target.orientation.waiting != nullptr) {
        const path::Curve curve =
            path::make_helix(arc.start, arc.end, arc.center, arc.normal, arc.sweep);
        if (!channel_.tool_motion.lay_directions(block, curve, target)) return;
    }
    if (!channel_.checks.require_arc_within_limits(block, arc, target)) return;
    if (spindle_.has_cutting_speed) [[unlikely]]
        channel_.dangers.watch_cutting_speed(block, position_.here()[0], target.here[0]);

    path::Motion& motion = channel_.stages.put(Op::Arc, block, &target.orientation).motion();
    motion.to = target.base;
    motion.moved = target.moved;
    motion.exact_stop = exact_stop;
    const double turns = block.has(Slot::Turns) ? block.at(Slot::Turns) : 0;
    motion.shape =
        path::ArcShape{arc.center, arc.normal, arc.sweep, turns, arc.normal.dot(third) < 0};
    motion.feed = modal_.feed;
    // F = feed/radius, and the length is radius · sweep: the time is sweep/F.
    if (modal_.feed_mode == FeedMode::InverseTime && rules_.inverse_time_arc_by_radius) {
        motion.feed = modal_.feed / arc.sweep;
    }
    if (modal_.feed_mode != FeedMode::InverseTime && rules_.helix_feed_along_arc) {
        motion.feed *= length_by_arc(arc);
    }
    arrive(target);
    const double climb = arc.normal.dot(arc.end - arc.start) / arc.sweep;
    position_.come_from(arc.end - arc.normal.cross(arc.end - arc.center) - arc.normal * climb);
}

void Motions::warn_arc_word(const Block& block, SlotMask words) {
    const Slot slot = first_slot(words);
    reporter_.report(diag::ArcWordUnused, block, slot)
        .arg(slot_word(slot))
        .arg(modal_.motion == Function::Rapid ? "rapid" : "line");
}

}  // namespace kadr::interp
