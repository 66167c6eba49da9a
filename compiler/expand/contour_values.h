// contour_values.h — contours between the heap and geometry, and how their points stand in a
// program. For the room expand only.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "expand/plane.h"
#include "expand/running.h"
#include "path/contour.h"
#include "path/contour_offset.h"

namespace kadr::expand {

/// A contour outside of the heap, with the plane in which it lies. Geometry as it is on the part;
/// as words and as points of the program X may be a diameter.
struct PlaneContour {
    path::Contour elements;
    path::Plane plane = path::Plane::Xy;
    bool is_diameter = false;
};

/// How the points of a contour stand in a program: in which plane, and whether X is a diameter.
struct Wording {
    path::Plane plane = path::Plane::Xy;
    bool is_diameter = false;

    PlaneIndices axes() const { return indices_of(plane); }
    /// What a millimetre along the first and the second axis is in a word.
    path::Vec2 scale() const {
        if (!is_diameter) return {1, 1};
        const PlaneIndices indices = axes();
        return {indices.first == index(Axis::X) ? 2 : 1, indices.second == index(Axis::X) ? 2 : 1};
    }
    path::Vec2 words(const path::Vec2& point) const { return point.cwiseProduct(scale()); }
    path::Vec2 point(const path::Vec2& words) const { return words.cwiseQuotient(scale()); }
};

template <typename Kept>
Wording wording_of(const Kept& contour) {
    return {contour.plane, contour.is_diameter};
}

/// Whether a coordinate or another number is given.
inline bool is_given(Slot slot) { return slot.number == slot.number; }
/// The point of a plane in the three registers of a point.
void put_point(Slot* slots, const Wording& wording, const path::Vec2& point);
/// … and the other way round.
path::Vec2 point_in(const Slot* slots, const Wording& wording);
/// "X and Y", for messages.
std::string axes_text(const Wording& wording);

/// The contour that a handle means.
PlaneContour read_contour(Running& run, Slot handle);
/// A contour on the heap, as an array of this layout.
std::int64_t make_contour(Running& run, const PlaneContour& contour, std::uint32_t layout);
/// An array of contours that lie as `like` does.
std::int64_t make_contours(Running& run, const std::vector<path::Contour>& contours,
                           const PlaneContour& like, std::uint32_t layout);
/// Reports an offset that has no result, or that was to end.
void offset_fault(Running& run, path::OffsetFault why, double distance, std::uint32_t at);

}  // namespace kadr::expand
