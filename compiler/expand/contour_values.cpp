#include "expand/contour_values.h"

#include <array>
#include <cmath>

#include "base/diagnostics/expand.h"
#include "base/units.h"
#include "expand/faults.h"
#include "expand/text_format.h"
#include "expand/vm.h"

namespace kadr::expand {

using path::Contour;
using path::Element;
using path::Vec2;
using sema::ElementSlot;

namespace {

constexpr std::size_t at(ElementSlot slot) { return static_cast<std::size_t>(slot); }

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

}  // namespace

void put_point(Slot* slots, const Wording& wording, const Vec2& point) {
    const PlaneIndices axes = wording.axes();
    const Vec2 words = wording.words(point);
    slots[axes.first].number = words.x();
    slots[axes.second].number = words.y();
    slots[axes.across].number = sema::kNotGivenNumber;
}

Vec2 point_in(const Slot* slots, const Wording& wording) {
    const PlaneIndices axes = wording.axes();
    return wording.point({slots[axes.first].number, slots[axes.second].number});
}

std::string axes_text(const Wording& wording) {
    const PlaneIndices axes = wording.axes();
    return std::string(kAxisNames[axes.first]) + " and " + std::string(kAxisNames[axes.second]) +
           (wording.is_diameter ? " (X a diameter)" : "");
}

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

std::int64_t make_contour(Running& run, const PlaneContour& contour, std::uint32_t layout) {
    const std::int64_t array = run.vm.heap.new_array(layout);
    std::array<Slot, sema::kElementSlots> slots{};
    for (const Element& element : contour.elements) {
        put_element(slots.data(), wording_of(contour), element);
        run.vm.heap.append(array, slots.data());
    }
    return array;
}

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

}  // namespace kadr::expand
