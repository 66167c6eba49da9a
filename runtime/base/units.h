// units.h — the only place where units change.
//
// Canonical are mm, s, rad, mm/s, rev/s. Degrees, minutes and inches exist where text is read or
// written, and in Block and Command, whose fields are so named.
#pragma once

#include <numbers>

namespace kadr {

inline constexpr double kMmPerInch = 25.4;  // exact by definition (ISO 31-1)

constexpr double rad_from_deg(double angle_deg) { return angle_deg * (std::numbers::pi / 180.0); }
/// A whole turn, rad.
inline constexpr double kTurnRad = 2 * std::numbers::pi;
constexpr double deg_from_rad(double angle) { return angle * (180.0 / std::numbers::pi); }
constexpr double feed_from_mm_min(double feed_mm_min) { return feed_mm_min / 60.0; }
constexpr double mm_min_from_feed(double feed) { return feed * 60.0; }
constexpr double speed_from_rpm(double speed_rpm) { return speed_rpm / 60.0; }
constexpr double rpm_from_speed(double speed) { return speed * 60.0; }
/// Of rad/s.
constexpr double rpm_from_angular_speed(double speed) { return rpm_from_speed(speed / kTurnRad); }

}  // namespace kadr
