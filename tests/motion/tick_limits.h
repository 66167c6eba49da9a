// tick_limits.h — what setpoints show of velocity, acceleration and jerk, held against the axes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "motion/axis_table.h"
#include "motion/pipeline.h"

namespace kadr::motion::test {

/// Greatest differences of first, second and third order from tick to tick, in parts of what the
/// axis may do. Where the direction of the path changes at once the velocity jumps, as the rule for
/// corners allows; the jerk is not counted there.
struct TickShares {
    double velocity = 0;
    double acceleration = 0;
    double jerk = 0;
};

/// Times at which the direction of the path changes at once while it moves.
inline std::vector<double> corner_times(const machine::Machine& machine,
                                        const std::vector<Segment>& segments) {
    const AxisTable axes(machine);
    std::vector<double> times;
    for (std::size_t k = 1; k < segments.size(); ++k) {
        const Segment& segment = segments[k];
        if (segment.profile.entry_speed == 0) continue;
        const AxisRates before = axes.end_rates(segments[k - 1]);
        const AxisRates behind = axes.start_rates(segment);
        double change = 0;
        for (std::size_t i = 0; i < axes.size(); ++i) {
            change = std::max(change, std::abs(behind[i] - before[i]));
        }
        if (change > 1e-9) times.push_back(segment.start_time);
    }
    return times;
}

/// Takes setpoints at the tick of the machine, one by one.
class TickWatch {
  public:
    TickWatch(const machine::Machine& machine, const std::vector<Segment>& segments)
        : machine_(machine), corners_(corner_times(machine, segments)) {}

    void add(const Setpoint& setpoint) {
        std::rotate(last_.begin(), last_.begin() + 1, last_.end());
        last_.back() = setpoint;
        if (++count_ < last_.size()) return;
        const double tick = machine_.tick;
        while (corner_ < corners_.size() && corners_[corner_] < last_[0].time - 1e-9 * tick)
            ++corner_;
        const bool is_corner =
            corner_ < corners_.size() && corners_[corner_] <= setpoint.time + 1e-9 * tick;
        for (std::size_t a = 0; a < machine_.axes.size(); ++a) add_axis(a, is_corner);
    }
    const TickShares& shares() const { return shares_; }

  private:
    void add_axis(std::size_t a, bool is_corner) {
        const machine::MachineAxis& axis = machine_.axes[a];
        const double tick = machine_.tick;
        const double step = last_[3].axis[a] - last_[2].axis[a];
        const double before = last_[2].axis[a] - last_[1].axis[a];
        const double first = last_[1].axis[a] - last_[0].axis[a];
        count(shares_.velocity, step, axis.velocity * tick);
        count(shares_.acceleration, step - before, axis.acceleration * tick * tick);
        if (is_corner || std::isinf(axis.jerk)) return;
        count(shares_.jerk, step - 2 * before + first, axis.jerk * tick * tick * tick);
    }
    static void count(double& share, double change, double allowed) {
        // Positions are true to 1e-12 mm; what that makes of a difference is not motion.
        share = std::max(share, std::max(0.0, std::abs(change) - 1e-11) / allowed);
    }

    const machine::Machine& machine_;
    std::vector<double> corners_;
    std::size_t corner_ = 0;
    std::array<Setpoint, 4> last_;
    std::size_t count_ = 0;
    TickShares shares_;
};

}  // namespace kadr::motion::test
