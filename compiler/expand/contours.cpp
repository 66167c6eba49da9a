#include "expand/contours.h"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/expand.h"
#include "base/units.h"
#include "expand/contour_values.h"
#include "expand/faults.h"
#include "path/contour_lead.h"

namespace kadr::expand {

using path::Contour;
using path::Vec2;
using sema::ContourFunction;

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

}  // namespace kadr::expand
