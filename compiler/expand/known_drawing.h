// known_drawing.h — what blocks have said of poles and roundings for the blocks behind them. For
// the room expand only.
#pragma once

#include "path/contour.h"
#include "path/frame.h"

namespace kadr::expand {

/// In the programmable frame; lengths are those of the part, also where X is a diameter.
struct KnownDrawing {
    path::Vec2 pole = path::Vec2::Zero();
    path::Plane plane = path::Plane::Xy;  // of the pole; in another one it is the zero point
    double radius = 0;                    // polar, programmed last, mm
    double angle_deg = 0;
    double rounding = 0;  // of every corner, mm; 0: none
};

}  // namespace kadr::expand
