// run_clock.h — how long commands take, for a program that asks for the time.
//
// At the programmed speeds: axes gain and lose speed at once, and rapids go as fast as the slowest
// axis allows. What the machine really needs is the matter of motion/, which knows nothing of a
// program that waits for an answer.
#pragma once

#include "base/axes.h"
#include "machine/machine.h"
#include "path/command.h"

namespace kadr::interp {

class RunClock {
  public:
    explicit RunClock(const machine::Machine& machine)
        : machine_(machine), most_speed_(machine.max_speed) {}

    /// Where the axes stand; mm, deg.
    void start(const AxisValues& at) { at_ = at; }
    void add(const path::Command& command);
    /// Since the start, s.
    double seconds() const { return seconds_; }
    /// … of them in motions at feed, s.
    double cutting_seconds() const { return cutting_seconds_; }

  private:
    void follow_virtual(const path::VirtualAxes& axes);
    void move(const path::Motion& motion, const AxisValues& to);
    double time_of(const path::Motion& motion, const AxisValues& to) const;
    double rapid(const AxisValues& from, const AxisValues& to) const;
    double distance_of(const path::Motion& motion, const AxisValues& to) const;
    AxisValues machine_position(const AxisValues& at) const;
    double speed_at(double x) const;

    const machine::Machine& machine_;
    AxisValues at_{};         // of the tip, in the base system
    path::VirtualAxes axes_;  // in which at_ is given
    AxisValues length_{};     // of the tool
    double seconds_ = 0;
    double cutting_seconds_ = 0;
    double spindle_ = 0;  // rpm, or m/min
    bool has_cutting_speed_ = false;
    double limit_ = 0;   // of the program under constant cutting speed, rpm; 0: none
    double least_ = 0;   // … below which the spindle does not turn then
    double most_speed_;  // of the master spindle, rev/s; 0: no limit
};

}  // namespace kadr::interp
