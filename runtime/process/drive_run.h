// drive_run.h — a planned motion as the drives run it: the spindle lags, the feed follows it.
//
// Takes the segments of the planner one by one and walks them in time by itself: a feed per
// revolution goes by the real speed of the spindle, ramps and corners are those of the plan, and
// every linear axis has its servo. The first cut waits until the spindle has its speed. Between
// cuts, at rapid, constant cutting speed keeps the speed that it has.
//
// source: the paper on the simulation of constant cutting speed; reference motion §9.2
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "machine/machine.h"
#include "motion/segment.h"
#include "process/drives.h"

namespace kadr::process {

/// The drives at one moment.
struct DriveSample {
    double time = 0;                      // s
    path::Vec3 tip = path::Vec3::Zero();  // mm, where the tool really is; X is the radius
    double wanted_speed = 0;              // rad/s, of the spindle
    double speed = 0;                     // rad/s
    double current = 0;                   // A, of the main drive
    double load = 0;                      // N·m, torque of the cut
    double feed = 0;                      // mm/s, real path speed
    std::uint32_t line = 0;               // of the ISO-7bit text
};

class DriveRun {
  public:
    using Look = std::function<void(const DriveSample&)>;

    /// The machine describes its drives. `period` is the time between the samples that `look` gets,
    /// s; the equations take smaller steps.
    DriveRun(const machine::Machine& machine, double period, Look look);

    /// Runs one more segment. After a stall nothing happens any more.
    void add(const motion::Segment& segment);

    /// The spindle did not get to the speed that was asked for, and the feed stood.
    bool has_stalled() const { return has_stalled_; }
    double wanted_speed() const { return wanted_; }
    double speed() const { return spindle_.speed; }

  private:
    void begin(const motion::Segment& segment);
    void set_spindle(const motion::Segment& segment);
    void stand(double duration);
    void wait_for_speed();
    void walk(const motion::Segment& segment);
    double target_speed(const motion::Segment& segment) const;
    double asked_feed(const motion::Segment& segment) const;
    void step(const motion::Segment* segment, const path::Vec3& point, const path::Vec3& velocity);
    double load(const motion::Segment& segment) const;
    double radius() const { return axes_[0].position; }
    double feed() const;
    void show();

    machine::Drives drives_;
    Look look_;
    double step_ = 0;              // s
    std::int64_t per_sample_ = 1;  // steps
    std::int64_t steps_ = 0;

    motion::CommandedSpindle commanded_;
    SpindleState spindle_;
    double wanted_ = 0;  // rad/s
    bool follows_radius_ = false;
    std::array<AxisState, 3> axes_;
    path::Vec3 point_ = path::Vec3::Zero();  // of the command
    double along_ = 0;                       // mm/s, path speed of the command
    double rest_ = 0;                        // mm, what the last step ran beyond its segment
    double side_ = 1;                        // sign of the radius where the cut began
    double load_ = 0;                        // N·m
    bool has_begun_ = false;
    bool was_cutting_ = false;
    bool has_stalled_ = false;
    std::uint32_t line_ = 0;
};

}  // namespace kadr::process
