// circles.cpp — arcs by an opening angle, over a point, along the direction of the motion before.
#include <bit>
#include <cmath>

#include <Eigen/Geometry>

#include "base/diagnostics/iso.h"
#include "base/units.h"
#include "interp/block_words.h"
#include "interp/channel.h"
#include "interp/motion_checks.h"
#include "interp/motions.h"
#include "path/linear.h"

namespace kadr::interp {

using nc::Block;
using nc::Slot;
using nc::SlotMask;
using path::linear;
using path::Op;
using path::Vec3;

/// A circle over a point between, in whatever plane the three points lie.
void Motions::arc_over_point(const Block& block, const Target& target, bool exact_stop) {
    if (!channel_.checks.require_feed(block, "arc")) return;
    if (const SlotMask others = block.given & (nc::kArcSlots | bit(Slot::Opening)); others != 0) {
        motion_words().report_arc_words(block, others);
        return;
    }
    for (const path::Plane plane : {path::Plane::Xy, path::Plane::Zx, path::Plane::Yz}) {
        if (!frames_.is_stretched(plane)) continue;
        reporter_.report(diag::ArcStretched, block, modal_.motion);
        return;
    }
    const path::ArcEnds ends{linear(position_.here()), linear(target.here)};
    const Result<path::Arc, path::ArcFault> arc =
        path::arc_through(ends, motion_words().through_point(block));
    if (!arc) {
        reporter_.report(diag::ArcThroughLine, block);
        return;
    }
    put_arc(block, *arc, target, exact_stop);
}

/// An arc in the plane that begins in the direction in which the tool has come; along the third
/// axis it is a helix. Straight on, it is a line.
void Motions::arc_along(const Block& block, const Target& target, bool exact_stop) {
    if (!channel_.checks.require_feed(block, "arc")) return;
    const SlotMask words = nc::kArcSlots | nc::kThroughSlots | bit(Slot::Opening);
    if (const SlotMask others = block.given & words; others != 0) {
        motion_words().report_arc_words(block, others);
        return;
    }
    if (frames_.is_stretched(modal_.plane)) {
        reporter_.report(diag::ArcStretched, block, modal_.motion);
        return;
    }
    AxisValues behind = position_.base();
    for (std::size_t i = 0; i < 3; ++i)
        behind[i] = position_.came_from()[static_cast<Eigen::Index>(i)];
    const Vec3 third = path::unit(path::axes_of(modal_.plane).normal);
    const Vec3 start = linear(position_.here());
    const Vec3 came = start - linear(frames_.from_base(behind));
    const Vec3 tangent = came - came.dot(third) * third;
    const Vec3 delta = linear(target.here) - start;
    const double height = delta.dot(third);
    if (tangent.norm() < path::kSamePoint) {
        reporter_.report(diag::ArcTangentMissing, block);
        return;
    }
    Result<path::Arc, path::ArcFault> arc =
        path::arc_along_tangent({start, start + delta - height * third}, tangent);
    if (!arc && arc.error() == path::ArcFault::Straight)
        return line(block, target, Op::Line, exact_stop);
    if (!arc) {
        reporter_.report(diag::ArcTangentMissing, block);
        return;
    }
    path::Arc found = *arc;
    found.end = linear(target.here);
    put_arc(block, found, target, exact_stop);
}

}  // namespace kadr::interp
