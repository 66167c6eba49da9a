// support.h — machines and command lists for the motion tests.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "motion/path_check.h"
#include "motion/pipeline.h"

namespace kadr::motion::test {

using path::Command;
using path::Op;
using path::Vec3;

inline constexpr double kUnlimited = std::numeric_limits<double>::infinity();

/// Velocity, acceleration and jerk of X, Y and Z.
struct Dynamics {
    Vec3 velocity = {500, 500, 400};
    Vec3 acceleration = {5000, 5000, 4000};
    Vec3 jerk = Vec3::Constant(kUnlimited);
};

inline machine::Machine machine_of(const Dynamics& dynamics = {}) {
    machine::Machine machine;
    machine.name = "test";
    for (int i = 0; i < 3; ++i) {
        machine::MachineAxis axis;
        axis.name = std::string(1, "XYZ"[i]);
        axis.axis = static_cast<Axis>(i);
        axis.lower = -kUnlimited;
        axis.upper = kUnlimited;
        axis.velocity = dynamics.velocity[i];
        axis.acceleration = dynamics.acceleration[i];
        axis.jerk = dynamics.jerk[i];
        machine.axes.push_back(axis);
    }
    return machine;
}

/// Feed without limit by the axes or the program.
inline constexpr double kFast = 1e9;

inline Command line_to(const Vec3& to, double feed_mm_min) {
    Command command(Op::Line);
    command.motion().moved = kLinearXYZ;
    command.motion().feed = feed_mm_min;
    for (int i = 0; i < 3; ++i) command.motion().to[static_cast<std::size_t>(i)] = to[i];
    return command;
}

inline Command rapid_to(const Vec3& to) {
    Command command = line_to(to, 0);
    command.become(Op::Rapid);
    return command;
}

/// Counter-clockwise about +Z, or clockwise for a negative sweep.
inline Command arc_to(const Vec3& to, const Vec3& center, double sweep, double feed_mm_min) {
    Command command = line_to(to, feed_mm_min);
    command.become(Op::Arc);
    command.motion().arc().center = center;
    command.motion().arc().normal = sweep < 0 ? Vec3(0, 0, -1) : Vec3(0, 0, 1);
    command.motion().arc().sweep = std::abs(sweep);
    return command;
}

/// A span of a spline over two control points, with weights of all four.
inline Command spline_to(const Vec3& to, const Vec3& first, const Vec3& second, double feed_mm_min,
                         const std::array<double, 6>& weights = {1, 1, 1, 1, 1, 1}) {
    Command command = line_to(to, feed_mm_min);
    command.become(Op::Spline);
    command.motion().spline().inner[0] = first;
    command.motion().spline().inner[1] = second;
    command.motion().spline().weights = weights;
    return command;
}

inline Command spindle_on(double speed_rpm) {
    Command command(Op::Spindle);
    command.spindle().mode = path::SpindleMode::Cw;
    command.spindle().speed = speed_rpm;
    return command;
}

inline Command simple(Op op) { return Command(op); }

/// Corners behind these motions may be rounded: from a distance before them, or within a tolerance.
inline std::vector<Command> rounded(std::vector<Command> commands, const path::Blending& wish) {
    for (Command& command : commands)
        if (command.is_motion()) command.motion().blending = wish;
    return commands;
}
inline path::Blending by_distance(double size) { return {path::BlendKind::Distance, false, size}; }
inline path::Blending within(double size, bool with_tangents = false) {
    return {path::BlendKind::Tolerance, with_tangents, size};
}

/// A list of commands as a stream.
class CommandList final : public Stream<Command> {
  public:
    explicit CommandList(std::vector<Command> commands) : commands_(std::move(commands)) {
        std::uint32_t line = 0;
        for (Command& command : commands_) {
            ++line;
            if (command.line == 0) command.line = line;
        }
    }
    std::size_t pull(std::span<Command> out) override {
        std::size_t n = 0;
        while (n < out.size() && at_ < commands_.size()) out[n++] = commands_[at_++];
        return n;
    }

  private:
    std::vector<Command> commands_;
    std::size_t at_ = 0;
};

/// A whole run: the segments, what they amount to and what was reported.
struct Motion {
    std::vector<Segment> segments;
    Totals totals;
    DiagnosticList diagnostics;
    bool alarmed = false;
};

inline Motion run(const machine::Machine& machine, std::vector<Command> commands,
                  const PlannerOptions& options = {}) {
    Motion result;
    CommandList list(std::move(commands));
    Planner planner(list, machine, options, result.diagnostics);
    std::vector<Segment> batch(7);  // not a divisor of anything
    while (const std::size_t n = planner.pull(batch)) {
        result.segments.insert(result.segments.end(), batch.begin(),
                               batch.begin() + static_cast<long>(n));
    }
    result.totals = planner.totals();
    result.alarmed = planner.alarmed();
    return result;
}

/// The setpoints, all of them held against the path of the commands.
inline std::vector<Setpoint> sample(const machine::Machine& machine, std::vector<Command> commands,
                                    const PlannerOptions& options = {}) {
    DiagnosticList diagnostics;
    PathCheck check(machine);
    for (const Command& command : commands) check.read(command);
    CommandList list(std::move(commands));
    Planner planner(list, machine, options, diagnostics);
    Sampler sampler(planner, machine);
    std::vector<Setpoint> all;
    std::vector<Setpoint> batch(13);
    while (const std::size_t n = sampler.pull(batch)) {
        (void)check.follow(std::span(batch).first(n));  // asked for at the end
        all.insert(all.end(), batch.begin(), batch.begin() + static_cast<long>(n));
    }
    if (!planner.alarmed()) check.finish();
    if (const auto& off = check.deviation())
        ADD_FAILURE() << "command " << off->motion.line << ", " << off->time << " s: fault "
                      << static_cast<int>(off->fault) << " by " << off->distance << " where "
                      << off->allowed << " is allowed";
    return all;
}

}  // namespace kadr::motion::test
