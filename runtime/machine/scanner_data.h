// scanner_data.h — what a machine file gives for a galvanometer scanner.
//
// Data only: two mirrors that guide the beam over a square field below a lens, beside the axes.
// What a scanner does with it is process/scanner.h's.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace kadr::machine {

/// Corrections at the crossings of a grid, to be interpolated between them. Empty: there is none.
struct FieldGrid {
    std::vector<double> x;   // mm, increasing; two at least
    std::vector<double> y;   // likewise
    std::vector<double> dx;  // mm; that of x[i], y[j] is number j·(size of x) + i
    std::vector<double> dy;

    bool is_empty() const { return x.empty(); }
};

/// The delays that a scanner's controller puts behind its motions, s.
struct ScannerDelays {
    double jump = 0;     // behind a jump: the mirrors settle, the beam is off
    double mark = 0;     // behind the last of a chain of marks
    double polygon = 0;  // between two marks, the beam stays on; at a turning back, if `turning`
    // The polygon delay grows with the angle by which the direction turns, from 0 straight on to
    // all of it at 180 degrees.
    bool polygon_turning = false;
    double laser_on = 0;   // from the start of the first mark until the beam is on; < 0: before it
    double laser_off = 0;  // from the end of the last mark until it is off, >= 0
};

struct Scanner {
    std::int64_t on_function = 0;   // the M function that gives motions to the scanner …
    std::int64_t off_function = 0;  // … and the one that gives them back to the axes
    double half_field = 0;          // mm, > 0; the field is a square of ± this
    double jump_speed = 0;          // mm/s, > 0, in the field
    double mark_speed = std::numeric_limits<double>::infinity();  // mm/s, the highest
    double step = 1e-5;  // s, > 0; motions and delays last a whole number of it
    ScannerDelays delays;
    double pulse = 0;                             // Hz, while the beam is on; 0: continuous
    std::array<double, 4> matrix = {1, 0, 0, 1};  // by rows; position = stage + matrix · field
    FieldGrid correction;                         // what is added to a point of the field
    double chord_tolerance = 0.002;               // mm, > 0; of curves as short vectors
    std::size_t list_size = 4000;                 // commands in one list, at least 1
};

}  // namespace kadr::machine
