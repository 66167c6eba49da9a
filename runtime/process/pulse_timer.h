// pulse_timer.h — the motion module of a pulsed laser: planned motion in the times of its pulses.
//
// Stands behind the planner and in front of the sampler. While the beam is on, which is switched as
// a spindle is, every block at feed ends at a point that one pulse burns. Single lines that follow
// each other are timed together so that they pass their points without a stop (pulse_ahead.h); the
// planner's speeds are the most that corners and ramps allow, and stay the limits. Everything else
// begins and ends at rest: motion that burns nothing, blocks of several pieces, dwells. A point
// behind such a block waits for the next pulse, as all points do in the mode `stop`.
//
// Time counts in ticks of the machine, whatever the tick of the setpoints is.
//
// source: the laser dissertation; reference motion §3
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "base/stream.h"
#include "machine/machine.h"
#include "motion/axis_table.h"
#include "motion/pipeline.h"
#include "process/pulse_ahead.h"

namespace kadr::process {

class PulseTimer final : public Stream<motion::Segment> {
  public:
    /// The machine has a pulsed laser. References outlive the timer.
    PulseTimer(Stream<motion::Segment>& planned, const machine::Machine& machine);

    std::size_t pull(std::span<motion::Segment> out) override;

    /// What the run amounts to, from what it would have without the laser.
    motion::Totals totals(const motion::Totals& planned) const;
    /// Points that were burnt.
    std::uint64_t pulses() const { return pulses_; }

  private:
    bool read(motion::Segment& segment);
    bool work();
    bool is_link(const motion::Segment& segment) const;
    void flush_alone();
    void append_link(const motion::Segment& segment);
    void deliver_link();
    void do_alone(motion::Segment segment);
    void move_alone();
    void finish_alone(bool is_point);
    void wait_until(std::int64_t ticks, bool has_pulse);
    void deliver(motion::Segment segment, double duration);
    void advance_to(std::int64_t ticks);
    void record(const motion::Segment& segment);

    Stream<motion::Segment>& planned_;
    motion::AxisTable axes_;
    machine::Laser laser_;
    PulseClock clock_;
    double tick_;

    std::vector<motion::Segment> batch_;
    std::size_t batch_size_ = 0;
    std::size_t batch_at_ = 0;
    bool has_ended_ = false;

    PulseAhead ahead_;
    std::deque<motion::Segment> links_;    // what ahead_ knows
    std::optional<motion::Segment> next_;  // read, and to be done when the links are through
    std::vector<motion::Segment> alone_;   // pieces of one command, from rest to rest
    bool begins_command_ = true;           // the next segment is the first of its command

    std::vector<motion::Segment> ready_;
    std::size_t ready_at_ = 0;
    motion::Segment last_;         // delivered last
    std::int64_t ticks_ = 0;       // time, where everything is on a tick
    double time_ = 0;              // s, of the end of what was delivered
    std::int64_t last_pulse_ = 0;  // ticks
    std::uint64_t pulses_ = 0;
    motion::Totals totals_;  // times, velocities and accelerations only
    motion::AxisRates last_rates_{};
};

}  // namespace kadr::process
