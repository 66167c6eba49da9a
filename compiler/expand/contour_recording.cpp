#include "expand/contour_recording.h"

#include <bit>
#include <numbers>
#include <string>

#include "base/diagnostics/expand.h"
#include "expand/blocks.h"
#include "expand/contour_values.h"
#include "expand/corners.h"
#include "expand/drawn_words.h"
#include "expand/faults.h"
#include "expand/text_format.h"
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
    run.modal.drawing = {};
}

Done end_contour(Running& run, std::uint32_t layout, Slot& result) {
    if (!require_no_open_line(run)) return kFailed;
    const ContourRecording recording = run.recordings.end();
    run.modal = recording.before;
    if (recording.corner && !recording.corner->is_modal)
        return refuse_open_corner(run, *recording.corner, "the contour ends");
    result.integer =
        make_contour(run, {recording.elements, recording.plane, recording.is_diameter}, layout);
    return kDone;
}

namespace {

/// What the corner at its end leaves of an element, and the piece behind it; `next` begins there.
Done cut_end(Running& run, path::Contour& elements, const WantedCorner& corner, Element& next) {
    std::optional<path::CornerCut> cut;
    if (!cut_corner(run, corner, elements.back(), next, cut)) return kFailed;
    if (!cut) return kDone;
    elements.back() = path::part(elements.back(), 0, cut->leaves);
    elements.back().to = cut->piece.from;
    if (path::length(elements.back()) <= path::kSamePoint) elements.pop_back();
    elements.push_back(cut->piece);
    next = path::part(next, cut->joins, 1);
    next.from = cut->piece.to;
    return kDone;
}

/// Of a closed contour: the corner where it begins.
Done cut_start(Running& run, ContourRecording& recording) {
    const WantedCorner corner = *std::exchange(recording.corner, std::nullopt);
    if (recording.elements.size() < 2) return refuse_open_corner(run, corner, "the contour ends");
    Element first = recording.elements.front();
    if (!cut_end(run, recording.elements, corner, first)) return kFailed;
    recording.elements.front() = first;
    if (path::length(first) <= path::kSamePoint)
        recording.elements.erase(recording.elements.begin());
    recording.start = recording.at = recording.elements.front().from;
    return kDone;
}

}  // namespace

Done add_element(Running& run, Element element, const std::optional<WantedCorner>& corner) {
    ContourRecording& recording = run.recordings.innermost();
    const Vec2 to = element.to;
    if (const auto before = std::exchange(recording.corner, std::nullopt)) {
        if (!cut_end(run, recording.elements, *before, element)) return kFailed;
    }
    const bool is_left = path::length(element) > path::kSamePoint;
    if (corner && !is_left) {
        fault(run, diag::CornerRoom, corner->at)
            .arg(corner->name())
            .arg(quantity_text(run, corner->shape.size, sema::kLength))
            .arg(": the corner before it takes its whole side");
        return kFailed;
    }
    if (is_left) recording.elements.push_back(element);
    recording.corner = corner;
    recording.at = to;
    return kDone;
}

Done close_contour(Running& run, std::uint32_t where) {
    if (!run.recordings.is_open()) return kDone;  // in a function that is called from elsewhere
    ContourRecording& recording = run.recordings.innermost();
    if (!recording.has_start || recording.is_closed) {
        if (recording.is_closed) fault(run, diag::ContourComplete, where);
        else fault(run, diag::ContourEmpty, where);
        return kFailed;
    }
    if (!require_no_open_line(run)) return kFailed;
    if (recording.at != recording.start) {
        const auto corner = take_wanted(run, where);
        if (!add_element(run, path::line_element(recording.at, recording.start), corner))
            return kFailed;
    }
    if (recording.corner && !cut_start(run, recording)) return kFailed;
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
                if (nc::has_fact(invocation.function, nc::Fact::Resolved)) continue;
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

namespace {

/// Of a block that makes no element.
Done refuse_lost_corner(Running& run, const WantedCorner& corner) {
    fault(run, diag::CornerBeside, corner.at)
        .arg(corner.name())
        .arg("stands in a block that makes no element");
    return kFailed;
}

}  // namespace

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
    if (!run.corners.opens && !require_no_open_line(run)) return kFailed;
    run.corners.opens = false;
    const std::optional<WantedCorner> wanted = std::exchange(run.corners.wanted, std::nullopt);
    if (!moves) return wanted ? refuse_lost_corner(run, *wanted) : kDone;
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
        if (wanted) return refuse_lost_corner(run, *wanted);
        recording.has_start = true;
        recording.start = recording.at = to;
        // `G0 X… Y…` may give where it begins; from here on it is cut.
        if (motion == Function::Rapid) run.modal.assume(Group::Motion, Function::Line);
        return kDone;
    }
    if (motion == Function::Rapid) return refuse_in_contour(run, "a rapid motion", where);
    if (!is_arc && (has_center || has_radius))
        return refuse_in_contour(run, "a centre without G2 or G3", where);
    const std::optional<Element> element = element_of(run, block, recording.at, to, where);
    if (!element) return kFailed;
    if (!is_arc && to == recording.at) {
        if (wanted) return refuse_lost_corner(run, *wanted);
        return kDone;
    }
    return add_element(run, *element, wanted ? wanted : take_wanted(run, where));
}

std::optional<Element> element_of(Running& run, const Block& block, const Vec2& from,
                                  const Vec2& to, std::uint32_t where) {
    const Function motion = run.modal[Group::Motion];
    if (!nc::is_arc(motion)) return path::line_element(from, to);
    const path::Plane plane = plane_of(run.modal[Group::Plane]);
    const PlaneIndices axes = indices_of(plane);
    const bool has_radius = block.has(nc::Slot::Radius);
    // Arcs are made as the interpreter makes them, in space with the plane's axes.
    const auto in_space = [&](const Vec2& v) {
        Vec3 point = Vec3::Zero();
        point[static_cast<Eigen::Index>(axes.first)] = v.x();
        point[static_cast<Eigen::Index>(axes.second)] = v.y();
        return point;
    };
    const bool is_clockwise = motion == Function::ArcCw;
    const path::ArcEnds ends{in_space(from), in_space(to)};
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
            if (i == axes.across) {
                (void)refuse_in_contour(run, "a centre across the plane", where);
                return std::nullopt;
            }
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
        return std::nullopt;
    }
    Element element;
    element.from = from;
    element.to = to;
    element.center = {arc->center[static_cast<Eigen::Index>(axes.first)],
                      arc->center[static_cast<Eigen::Index>(axes.second)]};
    element.sweep = is_clockwise ? -arc->sweep : arc->sweep;
    return element;
}

}  // namespace kadr::expand
