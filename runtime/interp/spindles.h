// spindles.h — the spindles of the machine: what is programmed of each, and what is commanded.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// The spindles of the machine: what is programmed of each, and what is commanded.
class Spindles {
  public:
    explicit Spindles(Channel& channel);
    Spindles(const Spindles&) = delete;
    Spindles& operator=(const Spindles&) = delete;

    /// The master turns so, or stands; update_spindle commands it.
    void turn(path::SpindleMode mode) { spindle_.mode = mode; }
    /// rpm; commanded with the next block.
    void set_speed_later(double speed) {
        spindle_.speed = speed;
        owe_speed(true);
        /// number  0 is the master
    }

    bool has_spindle(std::int64_t number) const;
    /// S of the block: rpm, or m/min under constant cutting speed.
    void program_speed(const nc::Block& block);
    /// The spindle keeps the speed that it has at this moment.
    void leave_cutting_speed();
    /// The highest speed under constant cutting speed, rpm.
    void limit_speed(const nc::Block& block, nc::Function function, double limit);
    /// A speed that none programmed passes, rpm; 0 takes the bound away.
    void bound_speed(const nc::Block& block, nc::Function function, bool is_upper, double bound);
    /// The limit that acts under constant cutting speed, rpm; 0: none.
    double highest_speed() const;
    /// Speed under constant cutting speed where the tool is, rpm; infinite in the centre without a
    /// limit.
    double turning_speed() const;
    /// Commands what the spindle does from here on, if that has changed.
    void update_spindle(const nc::Block& block);
    /// SPOS and M19: it stands at an angle, before the motion.
    void orient_spindle(const nc::Block& block, const nc::Invocation& invocation);
    /// The spindles of the machine, all standing, the first one as the master.
    void set_up_spindles();
    /// A spindle by its number, 0 the master; null: the machine has none such.
    const ProgrammedSpindle* spindle_at(std::int64_t number) const;
    /// Where the machine has several spindles, the number of the one whose turn it is; else 0.
    std::uint8_t shown_number() const;
    /// SETMS: whose sense M3, M4, M5 and S are.
    void select_master(const nc::Block& block, const nc::Invocation& invocation);
    /// What a word programs for a spindle by its number.
    void act_on_spindle(const nc::Block& block, const nc::Invocation& invocation);
    /// Commands what the block has changed at the spindles by their numbers: the master is
    /// commanded as ever.
    void update_other_spindles(const nc::Block& block);
    /// The time of so many revolutions of a spindle is known here; the path follows the master
    /// alone.
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
    path::Spindle& put_spindle(const nc::Block& block);

    Channel& channel_;
    const machine::Machine& machine_;
    Reporter& reporter_;
    const Modal& modal_;
    const Position& position_;
    const control::Frames& frames_;
    ProgrammedSpindle& spindle_;
    std::vector<ProgrammedSpindle>& other_spindles_;
    bool& owes_speed_;
    ReportedInRun& reported_;
    bool is_master_away_ = false;  // another spindle has its place for a moment
};

}  // namespace kadr::interp
