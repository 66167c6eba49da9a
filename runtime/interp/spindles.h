// spindles.h — the spindles of the machine: what is programmed of each, and what the motion side
// was told.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// The spindles of the machine: what is programmed of each, and what the motion side was told.
class Spindles {
  public:
    explicit Spindles(Channel& channel);
    Spindles(const Spindles&) = delete;
    Spindles& operator=(const Spindles&) = delete;

    /// The master turns so, or stands; the motion side is told by update_spindle.
    void turn(path::SpindleMode mode) { spindle_.mode = mode; }
    /// rpm; the motion side is told with the next block.
    void set_speed_later(double speed) {
        spindle_.speed = speed;
        owe_speed(true);
    }

    bool has_spindle(std::int64_t number) const;
    void program_speed(const nc::Block& block);
    void leave_cutting_speed();
    void limit_speed(const nc::Block& block, nc::Function function, double limit);
    void bound_speed(const nc::Block& block, nc::Function function, bool is_upper, double bound);
    double highest_speed() const;
    double turning_speed() const;
    void update_spindle(const nc::Block& block);
    void orient_spindle(const nc::Block& block, const nc::Invocation& invocation);
    void set_up_spindles();
    const Spindle* spindle_at(std::int64_t number) const;
    std::uint8_t shown_number() const;
    void select_master(const nc::Block& block, const nc::Invocation& invocation);
    void act_on_spindle(const nc::Block& block, const nc::Invocation& invocation);
    void update_other_spindles(const nc::Block& block);
    void dwell_by_spindle(const nc::Block& block, const nc::Invocation& invocation);

  private:
    void owe_speed(bool is_due) { owes_speed_ = is_due; }
    SpeedLimits speed_limits() const;
    void put_speed_limits(const nc::Block& block, const SpeedLimits& before);
    double bounded_speed(const nc::Block& block);
    void check_edge_turns(const nc::Block& block);
    void stand_spindle(const nc::Block& block, nc::Function function, double angle, bool is_by);
    template <typename Act>
    void with_spindle(const nc::Block& block, const nc::Invocation& invocation, Act act);
    path::Command& put_spindle(const nc::Block& block);

    Channel& channel_;
    const machine::Machine& machine_;
    Reporter& reporter_;
    const Modal& modal_;
    const Position& position_;
    const control::Frames& frames_;
    Spindle& spindle_;
    std::vector<Spindle>& other_spindles_;
    bool& owes_speed_;
    ReportedInRun& told_;
    bool is_master_away_ = false;  // another spindle has its place for a moment
};

}  // namespace kadr::interp
