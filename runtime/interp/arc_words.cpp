// arc_words.cpp — arcs and involutes as the words of a block give them, in the programmed system.
#include <bit>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "base/units.h"
#include "interp/block_words.h"
#include "interp/motion_words.h"
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
using std::numbers::pi;

namespace {

/// Opening angles below this are none, deg: a thousandth of the finest increment of angles.
constexpr double kLeastOpening = 1e-6;

SlotMask plane_slots(const path::PlaneAxes& plane) {
    return bit(nc::slot_of(plane.first)) | bit(nc::slot_of(plane.second));
}

/// Rotated about an axis through the centre, rad.
Vec3 turned(const Vec3& point, const Vec3& center, const Vec3& axis, double angle) {
    return center + Eigen::AngleAxisd(angle, axis) * (point - center);
}

}  // namespace

/// The programmed radius; half of the chord where the control forgives that it lacks so little.
double MotionWords::radius_of(const Block& block, const path::ArcEnds& ends) const {
    const double radius = block.at(Slot::Radius);
    if (!view_.rules.arc_radius_may_fall_short) return radius;
    const Vec3 delta = ends.end - ends.start;
    const Vec3 normal = path::unit(path::axes_of(view_.plane).normal);
    const double half = (delta - normal * delta.dot(normal)).norm() / 2;
    const double size = std::abs(radius);
    const double slack =
        std::max(view_.rules.arc_tolerance, view_.rules.arc_tolerance_factor * size);
    return size < half && half - size <= slack ? std::copysign(half, radius) : radius;
}

/// The arc in the programmed system; nothing if it was reported, or if there is nothing to move.
std::optional<path::Arc> MotionWords::resolve_arc(const Block& block, const Target& target) {
    const bool has_center = (block.given & nc::kCenterSlots) != 0;
    const std::optional<int> turns = turns_of(block);
    if (!turns) return std::nullopt;
    const path::ArcEnds ends{linear(view_.position.here()), linear(target.here)};
    const path::ArcTurning turning{view_.plane, view_.motion == Function::ArcCw, *turns};
    if (block.has(Slot::Radius)) {
        if (has_center && !view_.rules.arc_radius_wins) {
            reporter_.report(diag::ArcCenterAndRadius, block, Slot::Radius);
            return std::nullopt;
        }
        const Result<path::Arc, path::ArcFault> arc =
            path::arc_of_radius(ends, radius_of(block, ends), turning);
        if (arc) return *arc;
        report_radius_arc(block, arc.error(), ends);
        return std::nullopt;
    }
    const std::optional<Vec3> center = center_of_arc(block, ends.start);
    if (!center) return std::nullopt;
    const path::ArcTolerance tolerance{view_.rules.arc_tolerance, view_.rules.arc_tolerance_factor,
                                       view_.rules.arc_error == nc::ArcError::ShiftCenter
                                           ? path::RadiusError::ShiftCenter
                                           : path::RadiusError::Spread};
    const Result<path::Arc, path::ArcFault> arc =
        path::arc_about_center(ends, *center, turning, tolerance);
    if (arc) return *arc;
    report_center_arc(block, arc.error(), ends, *center);
    return std::nullopt;
}

/// Additional full turns; nothing if they were reported.
std::optional<int> MotionWords::turns_of(const Block& block) {
    const double turns = block.has(Slot::Turns) ? block.at(Slot::Turns) : 0;
    if (turns == std::floor(turns) && turns >= 0 && turns <= path::kMaxTurns)
        return static_cast<int>(turns);
    reporter_.report(diag::ArcTurnsInvalid, block, Slot::Turns).arg(turns);
    return std::nullopt;
}

/// The centre that the words give, in the programmed system; nothing if it was reported. A distance
/// is a radius, a coordinate is a diameter where X is one: "Channel-specific diameter/radius
/// programming" in SINUMERIK's manual of fundamentals.
std::optional<Vec3> MotionWords::center_of_arc(const Block& block, const Vec3& start) {
    const Slot across = static_cast<Slot>(static_cast<std::size_t>(Slot::CenterX) +
                                          index(path::axes_of(view_.plane).normal));
    if (block.has(across)) {
        reporter_.report(diag::ArcCenterOutsidePlane, block, across).arg(slot_word(across));
        return std::nullopt;
    }
    Vec3 center = start;
    for (std::size_t i = 0; i < 3; ++i) {
        const Slot slot = static_cast<Slot>(static_cast<std::size_t>(Slot::CenterX) + i);
        if (!block.has(slot)) continue;
        double& value = center[static_cast<Eigen::Index>(i)];
        const bool is_place = (block.absolute & bit(slot)) != 0;
        value = is_place ? block.at(slot) * view_.axes.word_scale[i] : value + block.at(slot);
    }
    return center;
}

void MotionWords::report_radius_arc(const Block& block, path::ArcFault fault,
                                    const path::ArcEnds& ends) {
    const Vec3 delta = ends.end - ends.start;
    if (fault == path::ArcFault::RadiusTooSmall) {
        const double height = delta.dot(path::unit(path::axes_of(view_.plane).normal));
        const double chord = std::sqrt(std::max(0.0, delta.squaredNorm() - height * height));
        reporter_.report(diag::ArcRadiusTooSmall, block, Slot::Radius)
            .arg(round_to(block.at(Slot::Radius), 6))
            .arg(round_to(chord, 6));
        return;
    }
    const bool moves = delta.norm() > 0;  // along the axis of a helix
    if (!moves && view_.rules.arc_radius_without_chord == nc::ArcWithoutChord::NoMotion) return;
    reporter_.report(diag::ArcWithoutChord, block, Slot::Radius);
}

void MotionWords::report_center_arc(const Block& block, path::ArcFault fault,
                                    const path::ArcEnds& ends, const Vec3& center) {
    const SlotMask centers = block.given & nc::kCenterSlots;
    const Vec3 normal = path::unit(path::axes_of(view_.plane).normal);
    const auto radius_to = [&](const Vec3& point) {
        const Vec3 arm = point - center;
        return round_to((arm - arm.dot(normal) * normal).norm(), 6);
    };
    // A centre on the start while the end is elsewhere is one, with a radius that does not fit.
    const bool is_nowhere = fault == path::ArcFault::NoRadius &&
                            (centers == 0 || radius_to(ends.start) == radius_to(ends.end));
    if (!is_nowhere) {
        reporter_.report(diag::ArcEndOffCircle, block, first_slot(centers))
            .arg(radius_to(ends.start))
            .arg(radius_to(ends.end));
    } else if (centers == 0) {
        reporter_.report(diag::ArcCenterMissing, block, block.motion);
    } else {
        reporter_.report(diag::ArcCenterMissing, block, first_slot(centers));
    }
}

/// The arc that turns by an angle, in the programmed system: to its end, or about its centre, which
/// makes the end. Nothing if it was reported.
std::optional<path::Arc> MotionWords::arc_by_opening(const Block& block, Target& target) {
    const double opening_deg = block.at(Slot::Opening);
    if (!(opening_deg > kLeastOpening) || !(opening_deg < 360)) {
        reporter_.report(diag::ArcOpeningInvalid, block, Slot::Opening).arg(opening_deg);
        return std::nullopt;
    }
    const std::optional<int> turns = turns_of(block);
    if (!turns) return std::nullopt;
    const path::PlaneAxes plane = path::axes_of(view_.plane);
    const bool has_center = (block.given & nc::kCenterSlots) != 0;
    const bool has_end = (block.given & plane_slots(plane)) != 0;
    const SlotMask others = block.given & (bit(Slot::Radius) | nc::kThroughSlots |
                                           (has_end ? nc::kCenterSlots : SlotMask{0}));
    if (others != 0) return report_arc_words(block, others);

    const double sweep = rad_from_deg(opening_deg);
    const bool is_clockwise = view_.motion == Function::ArcCw;
    const Vec3 third = path::unit(plane.normal);
    const Vec3 normal = is_clockwise ? Vec3(-third) : third;
    const Vec3 start = linear(view_.position.here());
    path::Arc arc{start, linear(target.here), start, normal, sweep + 2 * pi * *turns};
    if (has_center) {
        const std::optional<Vec3> center = center_of_arc(block, start);
        if (!center) return std::nullopt;
        arc.center = *center + (start - *center).dot(third) * third;
        if ((start - arc.center).norm() < path::kSamePoint) {
            reporter_.report(diag::ArcCenterMissing, block, Slot::Opening);
            return std::nullopt;
        }
        const Vec3 end = turned(start, arc.center, normal, sweep);
        for (const Axis axis : {plane.first, plane.second}) {
            const auto i = static_cast<Eigen::Index>(index(axis));
            target.here[index(axis)] = arc.end[i] = end[i];
            target.moved = static_cast<AxisMask>(target.moved | bit(axis));
        }
        target.base = view_.frames.to_base(target.here);
        return arc;
    }
    const Vec3 delta = arc.end - start;
    const Vec3 chord = delta - delta.dot(third) * third;
    if (chord.norm() < path::kSamePoint) {
        reporter_.report(diag::ArcWithoutChord, block, Slot::Opening);
        return std::nullopt;
    }
    // Half the chord over the tangent of half the angle: from the chord's middle to the centre, on
    // its left for less than half a turn counter-clockwise about the normal.
    arc.center = start + chord / 2 + normal.cross(chord) / (2 * std::tan(sweep / 2));
    return arc;
}

std::nullopt_t MotionWords::report_arc_words(const Block& block, SlotMask words) {
    const auto slot = static_cast<Slot>(std::countr_zero(words));
    reporter_.report(diag::ArcWordsMixed, block, slot).arg(slot_word(slot));
    return std::nullopt;
}

// ------------------------------------------------------------------------------ involutes

/// What the block gives for its involute but the end; nothing if it was reported.
std::optional<path::InvoluteWords> MotionWords::involute_words(const Block& block) {
    const SlotMask others = block.given & (nc::kThroughSlots | bit(Slot::Turns));
    if (others != 0) {
        report_arc_words(block, others);
        return std::nullopt;
    }
    if (!block.has(Slot::Radius) || (block.given & nc::kCenterSlots) == 0) {
        reporter_.report(diag::InvoluteWordsMissing, block)
            .arg(block.has(Slot::Radius) ? "centre" : "radius of its base circle");
        return std::nullopt;
    }
    const Vec3 start = linear(view_.position.here());
    const std::optional<Vec3> center = center_of_arc(block, start);
    if (!center) return std::nullopt;
    const Vec3 third = path::unit(path::axes_of(view_.plane).normal);
    const bool is_cw = view_.motion == Function::InvoluteCw;
    return path::InvoluteWords{start, *center, is_cw ? Vec3(-third) : third,
                               block.at(Slot::Radius)};
}

/// The end of an involute that gives the angle under which it is seen from the centre.
Done MotionWords::take_involute_end(const Block& block, const path::InvoluteWords& words,
                                    Target& target) {
    const path::PlaneAxes plane = path::axes_of(view_.plane);
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
    target.base = view_.frames.to_base(target.here);
    target.moved = static_cast<AxisMask>(target.moved | bit(plane.first) | bit(plane.second));
    return kDone;
}

void MotionWords::report_involute(const Block& block, InvoluteFault fault) {
    switch (fault) {
        case InvoluteFault::Radius:
            reporter_.report(diag::InvoluteRadius, block, Slot::Radius).arg(block.at(Slot::Radius));
            return;
        case InvoluteFault::Inside: reporter_.report(diag::InvoluteInside, block); return;
        case InvoluteFault::Even:
        case InvoluteFault::EndOff: reporter_.report(diag::InvoluteEndOff, block); return;
    }
}

}  // namespace kadr::interp
