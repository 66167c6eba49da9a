// process_data.h — what a machine file gives for the process: drives, cutting load, laser.
//
// Data only. The models that use them are process/'s; here stands what each number means and its
// unit. Electrical and mechanical quantities of drives are in SI units.
#pragma once

#include <cstdint>
#include <limits>

namespace kadr::machine {

/// The main drive: motor, current loop and speed loop, all seen at the spindle.
struct SpindleDrive {
    double inertia = 0;          // kg·m², > 0, spindle, chuck and part
    double torque_constant = 0;  // N·m/A, > 0
    double time_constant = 0;    // s, > 0; of the closed current loop, filters included
    double friction = 0;         // N·m, idle torque at any speed
    double damping = 0;          // N·m·s, idle torque per rad/s
    double max_current = std::numeric_limits<double>::infinity();  // A, > 0
};

/// A servo of the feed axes: position loop, feed-forward, closed speed loop.
struct FeedDrive {
    double gain = 0;           // 1/s, > 0, of the position loop
    double time_constant = 0;  // s, > 0; of the closed speed loop
    double feed_forward = 1;   // share of the commanded velocity, 0 … 1
};

/// Both drives and the load that a cut puts on them.
struct Drives {
    SpindleDrive spindle;
    FeedDrive feed;
    double cutting_force = 0;  // N, tangential, at the programmed feed
};

/// How a pulsed laser is brought to its points.
enum class PulseMode : std::uint8_t {
    Synchronised,  // blocks end on the pulses, without a stop
    Stop,          // rest at every point until the next pulse
};

/// A laser beside the axes.
struct Laser {
    double pulse = 0;      // Hz, of the pump; 0: the beam is continuous
    double tolerance = 0;  // share by which one interval between pulses may differ
    PulseMode mode = PulseMode::Synchronised;
    double power = 0;        // W, at the programmed feed; 0: not controlled
    double least_power = 0;  // W, at rest
};

}  // namespace kadr::machine
