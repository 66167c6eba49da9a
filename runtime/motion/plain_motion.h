// plain_motion.h — a motion on which nothing but X, Y and Z moves, as programmed, where a
// setpoint is judged in some nanoseconds.
//
// What most of a program is: lines, and spans of splines that go on towards their end. Who asks
// gets a sure answer or none; then programmed_path.h has to look.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <variant>

#include "motion/pipeline.h"
#include "motion/segment.h"
#include "path/curve.h"
#include "path/steady.h"

namespace kadr::motion {

/// Where a setpoint is, as far as a plain motion tells.
struct PlainLook {
    enum class LookResult : std::uint8_t {
        On,       // within the tolerance of it
        Beside,   // not, nor on any point that the tip may have come to from there
        Unknown,  // perhaps
    };
    LookResult side = LookResult::Unknown;
    double parameter = 0;  // On: the foot, in the motion's own parameter
};

struct PlainMotion {
    /// A line, whose points are given in mm; or a steady span (path/steady.h), by its parameter.
    std::variant<path::Line, path::Cubic, path::Quintic> curve;
    double length = 0;                          // mm: of a span, a bound that is never too small
    path::Vec3 carrier = path::Vec3::Zero();    // from the tip to what X, Y and Z carry, mm
    std::array<double, kFollowers> standing{};  // beside X, Y and Z, in the order of the machine
};

/// The motion along a curve, for the caller to complete.
PlainMotion plain_motion_of(const path::Line& line);
PlainMotion plain_motion_of(const path::SteadySpan& steady);

/// Its curve with all that a closer look needs; a span is measured for it.
path::Curve curve_of(const PlainMotion& plain);
const path::Vec3& end_of(const PlainMotion& plain);
inline bool is_line(const PlainMotion& plain) {
    return std::holds_alternative<path::Line>(plain.curve);
}

/// The tip of a setpoint, mm, of a machine with X, Y and Z in front.
inline path::Vec3 tip_of(const PlainMotion& plain, const Setpoint& setpoint) {
    return path::Vec3(setpoint.axis[0], setpoint.axis[1], setpoint.axis[2]) - plain.carrier;
}

/// Whether the axes beside X, Y and Z stand where they should.
///
/// followers  how many the machine has
inline bool stands(const PlainMotion& plain, const Setpoint& setpoint, std::size_t followers) {
    for (std::size_t i = 0; i < followers; ++i)
        if (setpoint.axis[i + 3] != plain.standing[i]) return false;
    return true;
}

PlainLook look_on_span(const PlainMotion& plain, const path::Vec3& tip, double tolerance,
                       double parameter);

inline PlainLook look_on_line(const path::Line& line, const path::Vec3& tip, double tolerance,
                              double parameter) {
    const path::Vec3 out = tip - line.start;
    const double from = std::max(0.0, parameter - 2 * tolerance);
    const double foot =
        std::clamp(out.dot(line.direction), std::min(from, line.length), line.length);
    const bool is_on = (out - line.direction * foot).squaredNorm() <= tolerance * tolerance;
    return {is_on ? PlainLook::LookResult::On : PlainLook::LookResult::Beside, foot};
}

/// Whether a tip is on the motion, not much before a parameter.
///
/// tolerance  mm
/// parameter  in the motion's own parameter, from which on the tip has come
inline PlainLook look_at(const PlainMotion& plain, const path::Vec3& tip, double tolerance,
                         double parameter) {
    const auto* line = std::get_if<path::Line>(&plain.curve);
    return line != nullptr ? look_on_line(*line, tip, tolerance, parameter)
                           : look_on_span(plain, tip, tolerance, parameter);
}

double bound_on_span(const PlainMotion& plain, double parameter);

/// How far along the motion a parameter is, mm: of a span, a bound that is never too small.
inline double travel_bound(const PlainMotion& plain, double parameter) {
    return is_line(plain) ? parameter : bound_on_span(plain, parameter);
}

}  // namespace kadr::motion
