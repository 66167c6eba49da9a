// contour.h — chains of lines and arcs in a plane: measures, questions, transformations.
//
// Coordinates are those of the working plane, first and second axis; which plane that is, is the
// caller's matter. Exact geometry: arcs stay arcs. Offsets are contour_offset.h.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace kadr::path {

using Vec2 = Eigen::Vector2d;  // mm, or a unit vector

/// Of two vectors, mm²: above zero if the second one lies to the left of the first.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Lengths below this are none: a tenth of the finest increment that a control takes.
inline constexpr double kSamePoint = 1e-5;  // mm

/// A straight line or an arc of a circle.
struct Element {
    Vec2 from = Vec2::Zero();
    Vec2 to = Vec2::Zero();
    Vec2 center = Vec2::Zero();  // of an arc
    double sweep = 0;            // rad, counter-clockwise positive, to ±2π; 0: a line

    bool is_arc() const { return sweep != 0; }
};

/// Elements in the order in which they are travelled; each begins where the one before ends.
using Contour = std::vector<Element>;

struct Rectangle {
    Vec2 lower = Vec2::Zero();
    Vec2 upper = Vec2::Zero();
};

Element line_element(const Vec2& from, const Vec2& to);
/// The arc about a centre at equal distance from both points. Equal points make a full circle.
Element arc_element(const Vec2& from, const Vec2& to, const Vec2& center, bool is_clockwise);

// ---- of one element
double radius(const Element& element);  // of an arc, mm
double length(const Element& element);
/// Unit vectors of travel at both ends.
Vec2 start_direction(const Element& element);
Vec2 end_direction(const Element& element);
/// The point at a share 0 … 1 of the length.
Vec2 point_at(const Element& element, double share);
/// The piece between two shares, 0 ≤ from < to ≤ 1.
Element part(const Element& element, double from, double to);
Element reversed(const Element& element);
Rectangle bounds(const Element& element);

struct Nearest {
    Vec2 point = Vec2::Zero();
    double distance = 0;  // mm
    std::size_t element = 0;
    double share = 0;  // of the element's length, 0 … 1
};
/// The point of an element that is nearest to a point.
Nearest nearest(const Element& element, const Vec2& point);

/// A common point of two elements and where it is on each, as shares of the length.
struct Crossing {
    Vec2 point = Vec2::Zero();
    double share_a = 0;
    double share_b = 0;
};
/// Common points; where two elements run over each other, the ends of the common piece.
/// At most four.
std::vector<Crossing> crossings(const Element& a, const Element& b);

// ---- of a contour
double length(const Contour& contour);
/// Whether it ends where it begins, within kSamePoint. An empty contour is not closed.
bool is_closed(const Contour& contour);
/// Enclosed by a closed contour, mm²: positive if it runs counter-clockwise.
double signed_area(const Contour& contour);
Rectangle bounds(const Contour& contour);
/// How often a closed contour runs around a point, counter-clockwise positive.
int turns_around(const Contour& contour, const Vec2& point);
/// Whether a point is inside a closed contour; on it counts as inside.
bool is_inside(const Contour& contour, const Vec2& point);
/// The nearest point of a contour that is not empty.
Nearest nearest(const Contour& contour, const Vec2& point);
/// Common points of two contours, in the order of the first one; each once.
std::vector<Vec2> intersections(const Contour& a, const Contour& b);
/// Where a contour meets the line on which one coordinate (0 the first, 1 the second) has a value:
/// in the order of travel, each point once; of a piece that runs along the line, its ends.
std::vector<Vec2> crossings(const Contour& contour, Eigen::Index coordinate, double value);

Contour reversed(const Contour& contour);
Contour shifted(const Contour& contour, const Vec2& by);
/// Turned about the zero point, rad, counter-clockwise.
Contour rotated(const Contour& contour, double angle);
/// With the sign of the first, the second coordinate changed.
Contour mirrored(const Contour& contour, bool first, bool second);

}  // namespace kadr::path
