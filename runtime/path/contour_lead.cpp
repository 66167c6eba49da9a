#include "path/contour_lead.h"

#include <algorithm>
#include <cmath>

#include "path/contour_offset.h"

namespace kadr::path {

namespace {

Vec2 left_of(const Vec2& v) { return {-v.y(), v.x()}; }

/// The path that arrives at `point` along `direction`, its last element first.
Contour lead_in(const Vec2& point, const Vec2& direction, double line, double arc, bool is_left) {
    Contour contour;
    Vec2 at = point;
    Vec2 along = direction;
    if (arc > 0) {
        // A quarter circle about the point beside: it begins one radius back and one to the side.
        const Vec2 side = is_left ? left_of(direction) : Vec2(-left_of(direction));
        const Vec2 center = point + side * arc;
        const Vec2 begin = center - direction * arc;
        contour.push_back(arc_element(begin, point, center, !is_left));
        at = begin;
        along = -side;
    }
    if (line > 0) contour.push_back(line_element(at - along * line, at));
    return contour;
}

/// Points of a lead that are looked at: every fifth of a degree of a quarter circle and the bends
/// of the wall beside it cannot hide more than the tolerance between them.
constexpr int kLooks = 500;

/// How far a straight line lies on the path itself, mm from `joint`: a closed contour that is begun
/// on a side comes back along it. What the tool does there it does once more at the end.
double shared_length(const Contour& contour, const Element& neighbour, const Vec2& joint) {
    if (contour.empty() || contour.front().is_arc() || neighbour.is_arc()) return 0;
    const bool is_end = (neighbour.to - joint).norm() <= kSamePoint;
    if (!is_end && (neighbour.from - joint).norm() > kSamePoint) return 0;
    const Vec2 back = is_end ? neighbour.from : neighbour.to;
    const Vec2 along = -start_direction(contour.front());  // away from the joint
    const Vec2 there = back - joint;
    const double across = std::fabs(along.x() * there.y() - along.y() * there.x());
    return across <= kSamePoint && along.dot(there) > 0 ? there.norm() : 0;
}

/// Whether the point is on the wrong side of a closed wall; on the wall itself it is not.
bool is_behind(const Wall& wall, const Vec2& point, bool is_left) {
    if (nearest(wall.contour, point).distance <= kSamePoint) return false;
    const bool is_free_inside = (signed_area(wall.contour) > 0) == is_left;
    return (turns_around(wall.contour, point) != 0) != is_free_inside;
}

/// Whether a lead meets the path elsewhere than at `joint`, or the wall. `neighbour` is the element
/// of the path that it may lie on.
bool cuts(const Contour& contour, const Contour& path, const Element& neighbour, const Vec2& joint,
          bool is_left, const Wall& wall) {
    const std::vector<Vec2> points = intersections(contour, path);
    const double shared = shared_length(contour, neighbour, joint) + kSamePoint;
    const bool meets = std::any_of(points.begin(), points.end(),
                                   [&](const Vec2& p) { return (p - joint).norm() > shared; });
    if (meets || !wall.has_side) return meets;
    for (const Element& element : contour) {
        for (int i = 0; i <= kLooks && wall.distance > 0; ++i) {
            const Vec2 point = point_at(element, static_cast<double>(i) / kLooks);
            if (nearest(wall.contour, point).distance < wall.distance - 2 * kOffsetTolerance)
                return true;
        }
    }
    // Along the wall itself a lead that does not cross it may still lie on the wrong side.
    if (wall.distance > 0 || contour.empty() || !is_closed(wall.contour)) return false;
    return is_behind(wall, point_at(contour.back(), 0.5), is_left) ||
           is_behind(wall, contour.back().from, is_left);
}

}  // namespace

Result<Contour, LeadFault> with_leads(const Contour& path, const LeadInOut& leads,
                                      const Wall& wall) {
    const Element& first = path.front();
    const Element& last = path.back();
    Contour in =
        lead_in(first.from, start_direction(first), leads.line_in, leads.arc_in, leads.is_left);
    // Backwards, the lead-out is a lead-in, and left is right.
    const Contour out =
        lead_in(last.to, -end_direction(last), leads.line_out, leads.arc_out, !leads.is_left);
    if (cuts(in, path, last, first.from, leads.is_left, wall)) return LeadFault::InCuts;
    if (cuts(out, path, first, last.to, leads.is_left, wall)) return LeadFault::OutCuts;
    std::reverse(in.begin(), in.end());
    in.insert(in.end(), path.begin(), path.end());
    for (const Element& element : out) in.push_back(reversed(element));
    return in;
}

Contour begun_near(const Contour& contour, const Vec2& point) {
    const Nearest at = nearest(contour, point);
    const Element& element = contour[at.element];
    const double size = length(element);
    Contour result;
    const auto next = static_cast<std::ptrdiff_t>(at.element) + 1;
    const bool at_start = at.share * size <= kSamePoint;
    const bool at_end = (1 - at.share) * size <= kSamePoint;
    if (!at_end) result.push_back(at_start ? element : part(element, at.share, 1));
    result.insert(result.end(), contour.begin() + next, contour.end());
    result.insert(result.end(), contour.begin(), contour.begin() + next - 1);
    if (!at_start) result.push_back(at_end ? element : part(element, 0, at.share));
    return result;
}

}  // namespace kadr::path
