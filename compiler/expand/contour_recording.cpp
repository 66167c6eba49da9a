#include "expand/contour_recording.h"

#include <bit>
#include <numbers>
#include <string>

#include "base/diagnostics/expand.h"
#include "expand/blocks.h"
#include "expand/contour_values.h"
#include "expand/faults.h"
#include "path/arc.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using nc::Group;
using path::Element;
using path::Vec2;
using path::Vec3;

namespace {

std::string_view describe(path::ArcFault fault) {
    switch (fault) {
        case path::ArcFault::NoRadius: return "its centre is its start";
        case path::ArcFault::RadiusMismatch: return "its end is not on the circle";
        case path::ArcFault::NoChord: return "a radius alone makes no full circle";
        case path::ArcFault::RadiusTooSmall: return "its radius does not reach over the chord";
        default: return "it cannot be calculated";
    }
}

}  // namespace

void begin_contour(Running& run) {
    run.recordings.begin(run.modal);
    // A contour is the same wherever it is made: in coordinates, cut, from a point of its own.
    run.modal.position.lose_all();
    run.modal.owed.owe_motion(false);
    run.modal.assume(Group::Motion, Function::Line);
    run.modal.assume(Group::Distance, Function::Absolute);
    run.modal.lost.regain((sema::group_bit(Group::Motion) | sema::group_bit(Group::Distance)));
}

std::int64_t end_contour(Running& run, std::uint32_t layout) {
    const ContourRecording recording = run.recordings.end();
    run.modal = recording.before;
    return make_contour(run, {recording.elements, recording.plane, recording.is_diameter}, layout);
}

Done close_contour(Running& run, std::uint32_t where) {
    if (!run.recordings.is_open()) return kDone;  // in a function that is called from elsewhere
    ContourRecording& recording = run.recordings.innermost();
    if (!recording.has_start || recording.is_closed) {
        if (recording.is_closed) fault(run, diag::ContourComplete, where);
        else fault(run, diag::ContourEmpty, where);
        return kFailed;
    }
    if (recording.at != recording.start)
        recording.elements.push_back(path::line_element(recording.at, recording.start));
    recording.at = recording.start;
    recording.is_closed = true;
    return kDone;
}

Done keep_plan(Running& run, const sema::Plan& plan, const Instruction& instruction,
               const Slot* registers, std::uint32_t where) {
    for (const nc::Invocation& invocation : plan.functions) {
        switch (nc::info(invocation.function).group) {
            case Group::Plane:
            case Group::Distance:
            case Group::Diameter: continue;
            default:
                return refuse_in_contour(
                    run, "`" + std::string(nc::info(invocation.function).name) + "`", where);
        }
    }
    if (!fill_plan(run, plan, instruction, registers, where)) return kFailed;
    return keep(run, run.recordings.block(), where);
}

Done refuse_in_contour(Running& run, std::string_view what, std::uint32_t where) {
    fault(run, diag::ContourBlock, where).arg(what);
    return kFailed;
}

Done keep(Running& run, const Block& block, std::uint32_t where) {
    ContourRecording& recording = run.recordings.innermost();
    const path::Plane plane = plane_of(run.modal[Group::Plane]);
    const PlaneIndices axes = indices_of(plane);
    if (!recording.has_start) {
        recording.plane = plane;
        recording.is_diameter = run.modal.is_diameter;
    } else if (recording.plane != plane) {
        return refuse_in_contour(run, "another plane", where);
    } else if (recording.is_diameter != run.modal.is_diameter) {
        return refuse_in_contour(run, "a change between diameter and radius", where);
    }
    if (block.has(nc::Slot::Feed)) return refuse_in_contour(run, "a feed", where);
    if (block.has(nc::Slot::Speed)) return refuse_in_contour(run, "a speed", where);
    if (block.has(nc::Slot::Turns)) return refuse_in_contour(run, "a helix", where);
    const nc::SlotMask in_plane = nc::SlotMask{1} << axes.first | nc::SlotMask{1} << axes.second;
    const nc::SlotMask others = block.given & nc::kTargetSlots & ~in_plane;
    if (others != 0) {
        const auto axis = static_cast<std::size_t>(std::countr_zero(others));
        return refuse_in_contour(run, "a motion of " + std::string(kAxisNames[axis]), where);
    }
    const Function motion = run.modal[Group::Motion];
    const bool is_arc = nc::is_arc(motion);
    const bool has_center = (block.given & nc::kCenterSlots) != 0;
    const bool has_radius = block.has(nc::Slot::Radius);
    const bool moves = (block.given & in_plane) != 0 || (is_arc && has_center);
    if (!moves) return kDone;
    if (recording.is_closed) {
        fault(run, diag::ContourComplete, where);
        return kFailed;
    }
    const Wording wording = wording_of(recording);
    const Vec2 to =
        wording.point({run.modal.position[axes.first], run.modal.position[axes.second]});
    if (!recording.has_start) {
        const bool both =
            run.modal.position.knows(axes.first) && run.modal.position.knows(axes.second);
        if (!both || is_arc) {
            fault(run, diag::ContourStart, where)
                .arg(kAxisNames[axes.first])
                .arg(kAxisNames[axes.second]);
            return kFailed;
        }
        recording.has_start = true;
        recording.start = recording.at = to;
        // `G0 X… Y…` may give where it begins; from here on it is cut.
        if (motion == Function::Rapid) run.modal.assume(Group::Motion, Function::Line);
        return kDone;
    }
    if (motion == Function::Rapid) return refuse_in_contour(run, "a rapid motion", where);
    if (!is_arc) {
        if (has_center || has_radius)
            return refuse_in_contour(run, "a centre without G2 or G3", where);
        if (to != recording.at) recording.elements.push_back(path::line_element(recording.at, to));
        recording.at = to;
        return kDone;
    }
    // Arcs are made as the interpreter makes them, in space with the plane's axes.
    const auto in_space = [&](const Vec2& v) {
        Vec3 point = Vec3::Zero();
        point[static_cast<Eigen::Index>(axes.first)] = v.x();
        point[static_cast<Eigen::Index>(axes.second)] = v.y();
        return point;
    };
    const bool is_clockwise = motion == Function::ArcCw;
    const path::ArcEnds ends{in_space(recording.at), in_space(to)};
    path::ArcTurning turning;
    turning.plane = plane;
    turning.is_clockwise = is_clockwise;
    Result<path::Arc, path::ArcFault> arc = path::ArcFault::NoRadius;
    if (has_radius) {
        arc = path::arc_of_radius(ends, block.at(nc::Slot::Radius), turning);
    } else {
        Vec3 center = ends.start;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto slot =
                static_cast<nc::Slot>(static_cast<std::size_t>(nc::Slot::CenterX) + i);
            if (!block.has(slot)) continue;
            if (i == axes.across) return refuse_in_contour(run, "a centre across the plane", where);
            // Of the part as it is: I is no diameter.
            double& value = center[static_cast<Eigen::Index>(i)];
            if ((block.absolute & nc::bit(slot)) != 0) value = block.at(slot);
            else value += block.at(slot);
        }
        path::ArcTolerance tolerance;
        tolerance.mode = path::RadiusError::ShiftCenter;
        // The last decimal of a short arc turns its centre far and moves the path by that decimal.
        tolerance.shift_angle = std::numbers::pi / 4;
        arc = path::arc_about_center(ends, center, turning, tolerance);
    }
    if (!arc) {
        fault(run, diag::ContourArc, where).arg(describe(arc.error()));
        return kFailed;
    }
    Element element;
    element.from = recording.at;
    element.to = to;
    element.center = {arc->center[static_cast<Eigen::Index>(axes.first)],
                      arc->center[static_cast<Eigen::Index>(axes.second)]};
    element.sweep = is_clockwise ? -arc->sweep : arc->sweep;
    recording.elements.push_back(element);
    recording.at = to;
    return kDone;
}

}  // namespace kadr::expand
