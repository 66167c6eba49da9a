// contours.cpp — contours of a running program: blocks that are kept, questions, and the blocks
// that `follow` makes of them.
#include "expand/contours.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/assert.h"
#include "base/diagnostics/expand.h"
#include "base/units.h"
#include "expand/blocks.h"
#include "expand/cuts.h"
#include "expand/cycles.h"
#include "expand/faults.h"
#include "expand/input.h"
#include "expand/orienting.h"
#include "expand/plane.h"
#include "expand/running.h"
#include "expand/text_format.h"
#include "expand/unknown.h"
#include "expand/vm.h"
#include "path/arc.h"
#include "path/contour_lead.h"
#include "path/contour_offset.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using nc::Group;
using path::Contour;
using path::Element;
using path::Vec2;
using path::Vec3;
using sema::ContourFunction;
using sema::ElementSlot;
using sema::FollowSlot;
using sema::Slot;

namespace {

std::int64_t make_contours(Running& run, const std::vector<path::Contour>& contours,
                           const PlaneContour& like, std::uint32_t layout);
void offset_fault(Running& run, path::OffsetFault why, double distance, std::uint32_t at);
Done offset_all(Running& run, const Instruction& instruction, Slot* registers, std::uint32_t at);
Done keep(Running& run, const nc::Block& block, std::uint32_t at);

constexpr std::size_t at(ElementSlot slot) { return static_cast<std::size_t>(slot); }
constexpr std::size_t at(FollowSlot slot) { return static_cast<std::size_t>(slot); }

bool is_given(Slot slot) { return slot.number == slot.number; }

std::string_view describe(path::ArcFault fault) {
    switch (fault) {
        case path::ArcFault::NoRadius: return "its centre is its start";
        case path::ArcFault::RadiusMismatch: return "its end is not on the circle";
        case path::ArcFault::NoChord: return "a radius alone makes no full circle";
        case path::ArcFault::RadiusTooSmall: return "its radius does not reach over the chord";
        default: return "it cannot be calculated";
    }
}

/// How the points of a contour stand in a program: in which plane, and whether X is a diameter.
struct Wording {
    path::Plane plane = path::Plane::Xy;
    bool is_diameter = false;

    PlaneIndices axes() const { return indices_of(plane); }
    /// What a millimetre along the first and the second axis is in a word.
    Vec2 scale() const {
        if (!is_diameter) return {1, 1};
        const PlaneIndices indices = axes();
        return {indices.first == index(Axis::X) ? 2 : 1, indices.second == index(Axis::X) ? 2 : 1};
    }
    Vec2 words(const Vec2& point) const { return point.cwiseProduct(scale()); }
    Vec2 point(const Vec2& words) const { return words.cwiseQuotient(scale()); }
};

template <typename Kept>
Wording wording_of(const Kept& contour) {
    return {contour.plane, contour.is_diameter};
}

/// The point of a plane in the three registers of a point.
void put_point(Slot* slots, const Wording& wording, const Vec2& point) {
    const PlaneIndices axes = wording.axes();
    const Vec2 words = wording.words(point);
    slots[axes.first].number = words.x();
    slots[axes.second].number = words.y();
    slots[axes.across].number = sema::kNotGivenNumber;
}

/// "X and Y", for messages.
std::string axes_text(const Wording& wording) {
    const PlaneIndices axes = wording.axes();
    return std::string(kAxisNames[axes.first]) + " and " + std::string(kAxisNames[axes.second]) +
           (wording.is_diameter ? " (X a diameter)" : "");
}

/// A quarter turn is 90 degrees, not what remains of it after the conversion through radians.
double neat_degrees(double angle_deg) {
    const double rounded = std::nearbyint(angle_deg * 1e9) / 1e9;
    return std::fabs(rounded - angle_deg) < 1e-12 ? rounded : angle_deg;
}

void put_element(Slot* slots, const Wording& wording, const Element& element) {
    put_point(slots + at(ElementSlot::From), wording, element.from);
    put_point(slots + at(ElementSlot::To), wording, element.to);
    const bool is_arc = element.is_arc();
    if (is_arc) {
        put_point(slots + at(ElementSlot::Center), wording, element.center);
    } else {
        for (std::size_t i = 0; i < 3; ++i)
            slots[at(ElementSlot::Center) + i].number = sema::kNotGivenNumber;
    }
    slots[at(ElementSlot::Radius)].number = is_arc ? path::radius(element) : sema::kNotGivenNumber;
    slots[at(ElementSlot::Sweep)].number = neat_degrees(deg_from_rad(element.sweep));
    slots[at(ElementSlot::Length)].number = path::length(element);
    slots[at(ElementSlot::IsArc)].integer = is_arc;
    slots[at(ElementSlot::IsDiameter)].integer = wording.is_diameter;
}

Vec2 point_in(const Slot* slots, const Wording& wording) {
    const PlaneIndices axes = wording.axes();
    return wording.point({slots[axes.first].number, slots[axes.second].number});
}

}  // namespace

// ---------------------------------------------------------------- values

namespace {

PlaneContour read_contour(Running& run, Slot handle) {
    PlaneContour result;
    const Heap::ArrayView elements = run.vm.heap.array(handle.integer);
    for (std::int64_t i = 0; i < elements.count; ++i) {
        const Slot* slots = elements.slots + i * elements.stride;
        if (i == 0) {
            // The coordinate that is not given is the one across the plane.
            if (!is_given(slots[1])) result.plane = path::Plane::Zx;
            else if (!is_given(slots[0])) result.plane = path::Plane::Yz;
            result.is_diameter = slots[at(ElementSlot::IsDiameter)].integer != 0;
        }
        const Wording wording = wording_of(result);
        Element element;
        element.from = point_in(slots + at(ElementSlot::From), wording);
        element.to = point_in(slots + at(ElementSlot::To), wording);
        if (slots[at(ElementSlot::IsArc)].integer != 0) {
            element.center = point_in(slots + at(ElementSlot::Center), wording);
            element.sweep = rad_from_deg(slots[at(ElementSlot::Sweep)].number);
        }
        result.elements.push_back(element);
    }
    return result;
}

}  // namespace

std::int64_t make_contour(Running& run, const PlaneContour& contour, std::uint32_t layout) {
    const std::int64_t array = run.vm.heap.new_array(layout);
    std::array<Slot, sema::kElementSlots> slots{};
    for (const Element& element : contour.elements) {
        put_element(slots.data(), wording_of(contour), element);
        run.vm.heap.append(array, slots.data());
    }
    return array;
}

namespace {

/// Both contours lie in one plane, and X of both is a diameter, or of none.
Done require_same_words(Running& run, const PlaneContour& contour, const PlaneContour& other,
                        std::uint32_t where) {
    if (contour.plane == other.plane && contour.is_diameter == other.is_diameter) return kDone;
    fault(run, diag::ContourPlane, where)
        .arg("a contour")
        .arg(axes_text(wording_of(contour)))
        .arg("another one")
        .arg(axes_text(wording_of(other)));
    return kFailed;
}

/// The contours beside one.
Done offset_one(Running& run, const PlaneContour& contour, const Instruction& instruction,
                Slot* registers, std::uint32_t where) {
    const double distance = registers[instruction.b + 1].number;
    const auto pieces =
        path::offset(contour.elements, distance, [&run] { return run.budget.look_for_end(); });
    if (!pieces) {
        offset_fault(run, pieces.error(), distance, where);
        return kFailed;
    }
    registers[instruction.a].integer = make_contours(
        run, *pieces, contour, static_cast<std::uint32_t>(instruction.immediate.pair.second));
    return kDone;
}

}  // namespace

Done contour_value(Running& run, const Instruction& instruction, Slot* registers,
                   std::uint32_t where) {
    const auto function = static_cast<ContourFunction>(instruction.immediate.pair.first);
    const auto layout = static_cast<std::uint32_t>(instruction.immediate.pair.second);
    Slot& result = registers[instruction.a];
    const Slot* arguments = registers + instruction.b;
    if (function == ContourFunction::OffsetAll)
        return offset_all(run, instruction, registers, where);
    const Slot handle = function == ContourFunction::IsInside ? arguments[3] : arguments[0];
    PlaneContour contour = read_contour(run, handle);
    const Wording wording = wording_of(contour);
    const PlaneIndices axes = wording.axes();
    const auto point_argument = [&](const Slot* slots) -> std::optional<Vec2> {
        for (const std::size_t i : {axes.first, axes.second}) {
            if (is_given(slots[i])) continue;
            not_given(run, "the coordinate " + std::string(kAxisNames[i]) + " of the point", where);
            return std::nullopt;
        }
        return point_in(slots, wording);
    };
    // Of words that may be left out, as distances: what is not given is 0.
    const auto vector_argument = [&](const Slot* slots) {
        Vec2 words = Vec2::Zero();
        if (is_given(slots[axes.first])) words.x() = slots[axes.first].number;
        if (is_given(slots[axes.second])) words.y() = slots[axes.second].number;
        return wording.point(words);
    };
    const auto put_points = [&](const std::vector<Vec2>& points) {
        const std::int64_t list = run.vm.heap.new_array(layout);
        for (const Vec2& point : points) {
            std::array<Slot, 3> slots{};
            put_point(slots.data(), wording, point);
            run.vm.heap.append(list, slots.data());
        }
        result.integer = list;
        return kDone;
    };
    const auto needs_elements = [&] {
        if (!contour.elements.empty()) return kDone;
        fault(run, diag::ContourEmpty, where);
        return kFailed;
    };
    const auto needs_closed = [&](std::string_view what) {
        if (path::is_closed(contour.elements)) return kDone;
        fault(run, diag::ContourOpen, where).arg(what);
        return kFailed;
    };
    const auto put_made = [&](Contour elements) {
        contour.elements = std::move(elements);
        result.integer = make_contour(run, contour, layout);
        return kDone;
    };
    switch (function) {
        case ContourFunction::Length: result.number = path::length(contour.elements); return kDone;
        case ContourFunction::Area:
            if (!needs_closed("the area")) return kFailed;
            result.number = std::fabs(path::signed_area(contour.elements));
            return kDone;
        case ContourFunction::IsClosed:
            result.integer = path::is_closed(contour.elements);
            return kDone;
        case ContourFunction::IsClockwise:
            if (!needs_closed("the sense of rotation")) return kFailed;
            result.integer = path::signed_area(contour.elements) < 0;
            return kDone;
        case ContourFunction::IsDiameter: result.integer = contour.is_diameter; return kDone;
        case ContourFunction::Start:
        case ContourFunction::End: {
            if (!needs_elements()) return kFailed;
            const bool is_start = function == ContourFunction::Start;
            put_point(&result, wording,
                      is_start ? contour.elements.front().from : contour.elements.back().to);
            return kDone;
        }
        case ContourFunction::Min:
        case ContourFunction::Max: {
            if (!needs_elements()) return kFailed;
            const path::Rectangle box = path::bounds(contour.elements);
            put_point(&result, wording, function == ContourFunction::Min ? box.lower : box.upper);
            return kDone;
        }
        case ContourFunction::Reverse: return put_made(path::reversed(contour.elements));
        case ContourFunction::Offset:
            return offset_one(run, contour, instruction, registers, where);
        case ContourFunction::Shift:
            return put_made(path::shifted(contour.elements, vector_argument(arguments + 1)));
        case ContourFunction::Rotate: {
            const Vec2 about = vector_argument(arguments + 2);
            const Contour turned = path::rotated(path::shifted(contour.elements, -about),
                                                 rad_from_deg(arguments[1].number));
            return put_made(path::shifted(turned, about));
        }
        case ContourFunction::Mirror:
            return put_made(path::mirrored(contour.elements, arguments[1 + axes.first].integer != 0,
                                           arguments[1 + axes.second].integer != 0));
        case ContourFunction::IsInside: {
            if (!needs_closed("the inside")) return kFailed;
            const std::optional<Vec2> point = point_argument(arguments);
            if (!point) return kFailed;
            result.integer = path::is_inside(contour.elements, *point);
            return kDone;
        }
        case ContourFunction::Nearest: {
            if (!needs_elements()) return kFailed;
            const std::optional<Vec2> point = point_argument(arguments + 1);
            if (!point) return kFailed;
            put_point(&result, wording, path::nearest(contour.elements, *point).point);
            return kDone;
        }
        case ContourFunction::BegunNear: {
            if (!needs_elements() || !needs_closed("another beginning")) return kFailed;
            const std::optional<Vec2> point = point_argument(arguments + 1);
            if (!point) return kFailed;
            return put_made(path::begun_near(contour.elements, *point));
        }
        case ContourFunction::OffsetAll: return kFailed;  // above
        case ContourFunction::Intersections: {
            const PlaneContour other = read_contour(run, arguments[1]);
            const bool both = !contour.elements.empty() && !other.elements.empty();
            if (both && !require_same_words(run, contour, other, where)) return kFailed;
            return put_points(path::intersections(contour.elements, other.elements));
        }
        case ContourFunction::Crossings: {
            const Slot* words = arguments + 1;
            const bool is_first = is_given(words[axes.first]);
            if (is_first == is_given(words[axes.second]) || is_given(words[axes.across])) {
                fault(run, diag::CrossingLine, where).arg(axes_text(wording));
                return kFailed;
            }
            const Vec2 value = vector_argument(words);
            return put_points(path::crossings(contour.elements, is_first ? 0 : 1,
                                              is_first ? value.x() : value.y()));
        }
    }
    return kDone;
}

namespace {

std::int64_t make_contours(Running& run, const std::vector<Contour>& contours,
                           const PlaneContour& like, std::uint32_t layout) {
    const std::int64_t list = run.vm.heap.new_array(layout);
    const std::uint32_t inner = run.code.layouts[layout].nested[0];
    for (const Contour& contour : contours) {
        Slot slot{};
        slot.integer = make_contour(run, {contour, like.plane, like.is_diameter}, inner);
        run.vm.heap.append(list, &slot);
    }
    return list;
}

void offset_fault(Running& run, path::OffsetFault why, double distance, std::uint32_t at) {
    if (why == path::OffsetFault::Stopped) return report_end(run, at);
    fault(run, diag::OffsetUnresolved, at).arg(quantity_text(run, distance, sema::kLength));
}

/// Beside several contours together.
Done offset_all(Running& run, const Instruction& instruction, Slot* registers,
                std::uint32_t where) {
    const Slot* arguments = registers + instruction.b;
    std::vector<Contour> contours;
    PlaneContour like;
    const std::int64_t count = run.vm.heap.array(arguments[0].integer).count;
    for (std::int64_t i = 0; i < count; ++i) {
        PlaneContour one = read_contour(run, run.vm.heap.array(arguments[0].integer).slots[i]);
        if (one.elements.empty()) continue;
        if (!path::is_closed(one.elements)) {
            fault(run, diag::ContourOpen, where).arg("the offset of several contours, one");
            return kFailed;
        }
        if (!contours.empty() && !require_same_words(run, like, one, where)) return kFailed;
        contours.push_back(std::move(one.elements));
        like.plane = one.plane;
        like.is_diameter = one.is_diameter;
    }
    const double distance = arguments[1].number;
    const auto pieces =
        path::offset(contours, distance, [&run] { return run.budget.look_for_end(); });
    if (!pieces) {
        offset_fault(run, pieces.error(), distance, where);
        return kFailed;
    }
    const auto layout = static_cast<std::uint32_t>(instruction.immediate.pair.second);
    registers[instruction.a].integer = make_contours(run, *pieces, like, layout);
    return kDone;
}

}  // namespace

// ---------------------------------------------------------------- blocks that are kept

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

namespace {

/// One block more: its motion becomes an element.
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

}  // namespace

// ---------------------------------------------------------------- follow

namespace {

/// What `follow` travels: beside the contour, leads included. Nothing: reported.
std::optional<PlaneContour> followed(Running& run, const Slot* arguments, std::uint32_t where) {
    PlaneContour contour = read_contour(run, arguments[at(FollowSlot::Contour)]);
    if (contour.elements.empty()) {
        fault(run, diag::ContourEmpty, where);
        return std::nullopt;
    }
    const auto size_of = [&](FollowSlot slot, std::string_view name) -> std::optional<double> {
        const Slot value = arguments[at(slot)];
        if (!is_given(value)) return 0;
        if (value.number >= 0 && value.number < 1e6) return value.number;
        fault(run, diag::LeadSize, where)
            .arg(name)
            .arg(quantity_text(run, value.number, sema::kLength));
        return std::nullopt;
    };
    const auto line_in = size_of(FollowSlot::LeadIn, "lead_in");
    const auto line_out = line_in ? size_of(FollowSlot::LeadOut, "lead_out") : line_in;
    const auto arc_in = line_out ? size_of(FollowSlot::ArcIn, "arc_in") : line_out;
    const auto arc_out = arc_in ? size_of(FollowSlot::ArcOut, "arc_out") : arc_in;
    if (!arc_out) return std::nullopt;
    const Slot left = arguments[at(FollowSlot::Left)];
    const Slot right = arguments[at(FollowSlot::Right)];
    const double distance = is_given(left) ? left.number : is_given(right) ? -right.number : 0;
    const Contour wall = contour.elements;
    if (distance != 0) {
        const auto pieces =
            path::offset(contour.elements, distance, [&run] { return run.budget.look_for_end(); });
        if (!pieces) {
            offset_fault(run, pieces.error(), distance, where);
            return std::nullopt;
        }
        if (pieces->size() != 1) {
            fault(run, diag::ToolDoesNotFit, where)
                .arg(quantity_text(run, std::fabs(distance), sema::kLength))
                .arg(pieces->empty() ? std::string("nothing is left")
                                     : std::to_string(pieces->size()) + " pieces are left");
            return std::nullopt;
        }
        const Element& first = contour.elements.front();
        const Vec2 along = path::start_direction(first);
        const Vec2 beside = first.from + Vec2(-along.y(), along.x()) * distance;
        const bool is_ring = path::is_closed(contour.elements);
        contour.elements = is_ring ? path::begun_near((*pieces)[0], beside) : (*pieces)[0];
    }
    path::LeadInOut leads;
    leads.line_in = *line_in;
    leads.line_out = *line_out;
    leads.arc_in = *arc_in;
    leads.arc_out = *arc_out;
    leads.is_left = is_given(left) ? left.number >= 0 : is_given(right) && right.number < 0;
    const bool has_side = is_given(left) || is_given(right);
    auto whole = path::with_leads(contour.elements, leads, {wall, std::fabs(distance), has_side});
    if (!whole) {
        fault(run, diag::LeadCuts, where)
            .arg(whole.error() == path::LeadFault::InCuts ? "lead-in" : "lead-out");
        return std::nullopt;
    }
    contour.elements = std::move(whole).value();
    return contour;
}

}  // namespace

Done follow_start(Running& run, const Instruction& instruction, Slot* registers,
                  std::uint32_t where) {
    const auto contour = followed(run, registers + instruction.b, where);
    if (!contour) return kFailed;
    put_point(registers + instruction.a, wording_of(*contour), contour->elements.front().from);
    return kDone;
}

Done follow_contour(Running& run, const Instruction& instruction, const Slot* registers,
                    std::uint32_t where) {
    if (is_between_positions(run)) return refuse_beside_cycle(run, "a contour", where);
    const Slot* arguments = registers + instruction.a;
    const auto contour = followed(run, arguments, where);
    if (!contour) return kFailed;
    const path::Plane plane = plane_of(run.modal[Group::Plane]);
    if (contour->plane != plane) {
        fault(run, diag::ContourPlane, where)
            .arg("a contour")
            .arg(axes_text({contour->plane}))
            .arg("the program")
            .arg(axes_text({plane}));
        return kFailed;
    }
    FollowedBlock next;
    next.source = {static_cast<std::uint32_t>(instruction.immediate.pair.second)};
    next.depth = instruction.c;
    next.feed = arguments[at(FollowSlot::Feed)].number;
    // X is what the program, or a contour that is being made, has it; else what the contour's words
    // were.
    const bool is_given = run.recordings.is_open() || run.modal[Group::Diameter] != Function::None;
    const Wording wording{plane, is_given ? run.modal.is_diameter : contour->is_diameter};
    next.is_diameter = wording.is_diameter;
    const PlaneIndices axes = wording.axes();
    const Vec2 begin = contour->elements.front().from;
    const bool is_known =
        run.modal.position.knows(axes.first) && run.modal.position.knows(axes.second);
    const Vec2 here =
        wording.point({run.modal.position[axes.first], run.modal.position[axes.second]});
    const bool is_there = is_known && (here - begin).norm() <= path::kSamePoint;
    if (!is_there) {
        if (!emit_element(run, path::line_element(here, begin), next, where)) return kFailed;
        next.feed = sema::kNotGivenNumber;
    }
    for (const Element& element : contour->elements) {
        if (!emit_element(run, element, next, where)) return kFailed;
        next.feed = sema::kNotGivenNumber;
    }
    return kDone;
}

Done emit_element(Running& run, const Element& element, const FollowedBlock& next,
                  std::uint32_t where) {
    if (!require_room(run, where)) return kFailed;
    const Wording wording{plane_of(run.modal[Group::Plane]), next.is_diameter};
    const PlaneIndices axes = wording.axes();
    const Vec2 words = wording.words(element.to);
    Block& block = next_block(run, next.source);
    block.motion = !element.is_arc()   ? Function::Line
                   : element.sweep > 0 ? Function::ArcCcw
                                       : Function::ArcCw;
    const std::size_t plane_axes[2] = {axes.first, axes.second};
    for (std::size_t i = 0; i < 2; ++i) {
        const auto component = static_cast<Eigen::Index>(i);
        const auto word = static_cast<nc::Slot>(plane_axes[i]);
        block.set(word, words[component]);
        if (run.modal[Group::Distance] == Function::Incremental) block.absolute |= nc::bit(word);
        if (!element.is_arc()) continue;
        const auto center =
            static_cast<nc::Slot>(static_cast<std::size_t>(nc::Slot::CenterX) + plane_axes[i]);
        block.set(center, element.center[component] - element.from[component]);
    }
    return finish_followed(run, block, next, where);
}

Done finish_followed(Running& run, Block& block, const FollowedBlock& next, std::uint32_t where) {
    const bool owes_behind = run.modal.take_functions(block, run.target.rules());
    if (next.feed == next.feed) {
        sema::Filling filling;
        filling.form = sema::Filling::Form::Feed;
        if (!fill_feed(run, block, filling, next.feed, where)) {
            drop_block(run, block);
            return kFailed;
        }
    }
    const bool leads = run.modal.tcp.acts() && !run.recordings.is_open();
    if ((!run.recordings.is_open() && !check_move(run, block, where)) ||
        (leads && !check_leading(run, block, where))) {
        drop_block(run, block);
        return kFailed;
    }
    if (run.modal.lost.needs_care() && !settle_unknown(run, block, where)) {
        drop_block(run, block);
        return kFailed;
    }
    if (run.modal.is_compensation_due() && !check_pitch(run, block, where)) {
        drop_block(run, block);
        return kFailed;
    }
    if (run.modal.has_ended && !run.recordings.is_open()) warn_after_end(run, where);
    if (run.modal.owed.diameter() != Function::None && !run.recordings.is_open())
        say_diameter(run, block);
    run.modal.take_words(block);
    if (owes_behind) run.modal.take_behind(block, run.target.rules());
    if (run.recordings.is_open()) return keep(run, block, where);
    if (is_cut_doubtful(run) && !check_cut(run, block, where)) {
        drop_block(run, block);
        return kFailed;
    }
    if (run.options.trace) keep_trace(run, where, next.depth, next.source);
    return kDone;
}

}  // namespace kadr::expand
