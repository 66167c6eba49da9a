// circles.cpp — arcs by an opening angle, over a point, along the direction of the motion before.
#include <bit>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "base/diagnostics/iso.h"
#include "base/units.h"
#include "interp/block_words.h"
#include "interp/executor.h"
#include "path/linear.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Slot;
using nc::SlotMask;
using path::linear;
using path::Op;
using path::Vec3;
using std::numbers::pi;

namespace {

/// Opening angles below this are none, deg: a thousandth of the finest increment of angles.
constexpr double kLeastOpening = 1e-6;

SlotMask plane_slots(const path::PlaneAxes& plane) {
    return bit(nc::slot_of(plane.first)) | bit(nc::slot_of(plane.second));
}

/// Turned about an axis through the centre, rad.
Vec3 turned(const Vec3& point, const Vec3& center, const Vec3& axis, double angle) {
    return center + Eigen::AngleAxisd(angle, axis) * (point - center);
}

}  // namespace

/// The arc that turns by an angle, in the programmed system: to its end, or about its centre, which
/// makes the end. Nothing if it was reported.
std::optional<path::Arc> Executor::arc_by_opening(const Block& block, Target& target) {
    const double opening_deg = block.at(Slot::Opening);
    if (!(opening_deg > kLeastOpening) || !(opening_deg < 360)) {
        report(diag::ArcOpeningInvalid, block, Slot::Opening).arg(opening_deg);
        return std::nullopt;
    }
    const std::optional<int> turns = turns_of(block);
    if (!turns) return std::nullopt;
    const path::PlaneAxes plane = path::axes_of(modal_.plane);
    const bool has_center = (block.given & nc::kCenterSlots) != 0;
    const bool has_end = (block.given & plane_slots(plane)) != 0;
    const SlotMask others = block.given & (bit(Slot::Radius) | nc::kThroughSlots |
                                           (has_end ? nc::kCenterSlots : SlotMask{0}));
    if (others != 0) return report_arc_words(block, others);

    const double sweep = rad_from_deg(opening_deg);
    const bool is_clockwise = modal_.motion == Function::ArcCw;
    const Vec3 third = path::unit(plane.normal);
    const Vec3 normal = is_clockwise ? Vec3(-third) : third;
    const Vec3 start = linear(position_.here);
    path::Arc arc{start, linear(target.here), start, normal, sweep + 2 * pi * *turns};
    if (has_center) {
        const std::optional<Vec3> center = center_of_arc(block, start);
        if (!center) return std::nullopt;
        arc.center = *center + (start - *center).dot(third) * third;
        if ((start - arc.center).norm() < path::kSamePoint) {
            report(diag::ArcCenterMissing, block, Slot::Opening);
            return std::nullopt;
        }
        const Vec3 end = turned(start, arc.center, normal, sweep);
        for (const Axis axis : {plane.first, plane.second}) {
            const auto i = static_cast<Eigen::Index>(index(axis));
            target.here[index(axis)] = arc.end[i] = end[i];
            target.moved = static_cast<AxisMask>(target.moved | bit(axis));
        }
        target.base = frames_.to_base(target.here);
        return arc;
    }
    const Vec3 way = arc.end - start;
    const Vec3 chord = way - way.dot(third) * third;
    if (chord.norm() < path::kSamePoint) {
        report(diag::ArcWithoutChord, block, Slot::Opening);
        return std::nullopt;
    }
    // Half the chord over the tangent of half the angle: from the chord's middle to the centre, on
    // its left for less than half a turn counter-clockwise about the normal.
    arc.center = start + chord / 2 + normal.cross(chord) / (2 * std::tan(sweep / 2));
    return arc;
}

std::nullopt_t Executor::report_arc_words(const Block& block, SlotMask words) {
    const auto slot = static_cast<Slot>(std::countr_zero(words));
    report(diag::ArcWordsMixed, block, slot).arg(slot_word(slot));
    return std::nullopt;
}

/// The point between, in the programmed system.
Vec3 Executor::through_point(const Block& block) const {
    Vec3 through = linear(position_.here);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto slot = static_cast<Slot>(static_cast<std::size_t>(Slot::ThroughX) + i);
        if (!block.has(slot)) continue;
        double& value = through[static_cast<Eigen::Index>(i)];
        value = is_distance(block, slot) ? value + block.at(slot) : block.at(slot);
    }
    return through;
}

/// A circle over a point between, in whatever plane the three points lie.
void Executor::arc_over_point(const Block& block, const Target& target, bool exact_stop) {
    if (!require_feed(block, "arc")) return;
    if (const SlotMask others = block.given & (nc::kArcSlots | bit(Slot::Opening)); others != 0) {
        report_arc_words(block, others);
        return;
    }
    for (const path::Plane plane : {path::Plane::Xy, path::Plane::Zx, path::Plane::Yz}) {
        if (!frames_.is_stretched(plane)) continue;
        report(diag::ArcStretched, block, modal_.motion);
        return;
    }
    const path::ArcEnds ends{linear(position_.here), linear(target.here)};
    const Result<path::Arc, path::ArcFault> arc = path::arc_through(ends, through_point(block));
    if (!arc) {
        report(diag::ArcThroughLine, block);
        return;
    }
    put_arc(block, *arc, target, exact_stop);
}

/// An arc in the plane that begins in the direction in which the tool has come; along the third
/// axis it is a helix. Straight on, it is a line.
void Executor::arc_along(const Block& block, const Target& target, bool exact_stop) {
    if (!require_feed(block, "arc")) return;
    const SlotMask words = nc::kArcSlots | nc::kThroughSlots | bit(Slot::Opening);
    if (const SlotMask others = block.given & words; others != 0) {
        report_arc_words(block, others);
        return;
    }
    if (frames_.is_stretched(modal_.plane)) {
        report(diag::ArcStretched, block, modal_.motion);
        return;
    }
    AxisValues behind = position_.base;
    for (std::size_t i = 0; i < 3; ++i) behind[i] = came_from_[static_cast<Eigen::Index>(i)];
    const Vec3 third = path::unit(path::axes_of(modal_.plane).normal);
    const Vec3 start = linear(position_.here);
    const Vec3 came = start - linear(frames_.from_base(behind));
    const Vec3 tangent = came - came.dot(third) * third;
    const Vec3 way = linear(target.here) - start;
    const double height = way.dot(third);
    if (tangent.norm() < path::kSamePoint) {
        report(diag::ArcTangentMissing, block);
        return;
    }
    Result<path::Arc, path::ArcFault> arc =
        path::arc_along_tangent({start, start + way - height * third}, tangent);
    if (!arc && arc.error() == path::ArcFault::Straight)
        return line(block, target, Op::Line, exact_stop);
    if (!arc) {
        report(diag::ArcTangentMissing, block);
        return;
    }
    path::Arc found = *arc;
    found.end = linear(target.here);
    put_arc(block, found, target, exact_stop);
}

}  // namespace kadr::interp
