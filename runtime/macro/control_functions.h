// control_functions.h — functions of a control's language that need more than arithmetic: values
// put into a text, a circle through points, a frame from points that were measured.
//
// Plain values in, plain values out; what a program's variables are is the evaluator's matter.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "control/control_frame.h"

namespace kadr::macro {

/// A value that is put into a text.
struct FormatValue {
    double number = 0;
    bool is_text = false;
    bool is_char = false;
    std::string_view text;
};

/// A format with its values put in; else what of the format is wrong.
struct Formatted {
    std::string text;
    std::string wrong;  // `%D`; empty: nothing
};

/// Puts values where a format has %D (whole number), %F and %E (number), %S (text), %C
/// (character), %B (TRUE or FALSE), %X (hexadecimal digits); %5D and %8.3F give width and decimals,
/// %% the sign.
///
/// source  S 8.4 SPRINT; that %E is written as 1.234500E+03 is not given there (unsure)
Formatted format_text(std::string_view format, std::span<const FormatValue> values);

struct PlaneCircle {
    double x = 0;  // mm, as the points
    double y = 0;
    double radius = 0;
};

/// The circle through 3 points in a plane, or 4. Of 4 points that are on no common circle the mean
/// of the circles through 3 of them each (unsure).
///
/// points  x, y in turn, shape (3, 2) or (4, 2)
/// returns nothing if three of them are on a line or two are the same
/// source  S 8.4 CALCDAT
std::optional<PlaneCircle> circle_through(std::span<const double> points);

struct MeasuredFrame {
    control::ControlFrame frame;
    /// Mean distance of the points from where the frame carries them, mm; -1: the ideal points are
    /// on a line, -2: the measured ones (unsure), and the frame does nothing.
    double error = 0;
};

/// The rotation and shift that carry three points best to where they were measured: least squares.
///
/// ideal, real  x, y, z of three points in turn, mm, shape (3, 3)
/// source       S 6.4 MEAFRAME; the fit is Umeyama's without a scale
MeasuredFrame measured_frame(std::span<const double, 9> ideal, std::span<const double, 9> real);

}  // namespace kadr::macro
