// contour_lead.h — the paths to a contour and from it: straight, by a quarter circle, or both.
#pragma once

#include "base/result.h"
#include "path/contour.h"

namespace kadr::path {

/// Paths that meet the contour with its own direction. mm; 0: none.
struct LeadInOut {
    double line_in = 0;
    double arc_in = 0;  // radius of a quarter circle between the line and the contour
    double line_out = 0;
    double arc_out = 0;
    bool is_left = true;  // of the quarter circles: the side of the contour on which they lie
};

/// The contour that the part keeps, and how far the tool's centre stays from it.
struct Wall {
    const Contour& contour;
    double distance = 0;    // mm, ≥ 0
    bool has_side = false;  // the leads must stay on the side `LeadInOut::is_left` of it
};

enum class LeadFault : std::uint8_t { InCuts, OutCuts };

/// A path that is not empty, with its leads in front and behind. Refused if a lead meets the path
/// elsewhere than where it joins it, comes nearer to the wall than the tool may, or lies behind it.
Result<Contour, LeadFault> with_leads(const Contour& path, const LeadInOut& leads,
                                      const Wall& wall);

/// A closed contour that begins at its point nearest to `point`.
Contour begun_near(const Contour& contour, const Vec2& point);

}  // namespace kadr::path
