// pipeline.h — Command → Setpoint, and what a run amounts to.
//
// plan: commands become segments, the look-ahead gives every junction its speed; sample: each
// segment is walked along its profile at the machine's tick.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/stream.h"
#include "machine/machine.h"
#include "path/command.h"

namespace kadr::motion {

/// One sample of the motion. Canonical units: s, mm, rad, mm/s.
struct Setpoint {
    double time = 0;
    std::array<double, kAxes> axis{};   // in the order of Machine::axes
    path::Vec3 tip = path::Vec3::Zero();
    path::Vec3 tool = path::Vec3::UnitZ();  // unit vector from tip to holder
    double feed = 0;                    // path speed at this instant
    std::uint32_t line = 0;             // of the ISO-7bit text
    SourceId source;
};

/// What a run amounts to; filled while the motion is planned, complete at the end of the stream.
struct Totals {
    std::uint64_t commands = 0;
    double time = 0;                    // s, everything
    double cutting_time = 0;            // s at feed
    double rapid_time = 0;              // s
    double dwell_time = 0;              // s
    double tool_change_time = 0;        // s
    double length = 0;                  // mm, of the tip, all motion
    double cutting_length = 0;          // mm
    std::array<double, kAxes> travel_min{};  // per machine axis, mm or rad
    std::array<double, kAxes> travel_max{};
    std::array<double, kAxes> max_velocity{};
    std::array<double, kAxes> max_acceleration{};
    std::array<double, kAxes> max_jerk{};    // infinite under trapezoidal profiles
};

}  // namespace kadr::motion
