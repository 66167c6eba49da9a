// danger_watch.h — what no control minds and no spindle stands: warned of once.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// What no control minds and no spindle stands: warned of once.
class DangerWatch {
  public:
    explicit DangerWatch(Channel& channel);
    DangerWatch(const DangerWatch&) = delete;
    DangerWatch& operator=(const DangerWatch&) = delete;

    void watch_feed(const nc::Block& block);
    void watch_turn_of_part(const nc::Block& block, const Target& target);
    void watch_cutting_speed(const nc::Block& block, double from, double to);
    void watch_length(const nc::Block& block, Axis axis);
    void watch_missing_length(const nc::Block& block);
    void watch_diameter(const nc::Block& block, nc::Function function);
    void watch_dwell(const nc::Block& block);
    void watch_tap(const nc::Block& block, nc::Function function);
    void watch_change(const nc::Block& block);
    void watch_spindle_stop(const nc::Block& block);
    void watch_radius(const nc::Block& block, std::int64_t number);
    bool is_new_feed() const {
        return modal_.feed != dangers_.feed || modal_.feed_mode != dangers_.feed_mode;
    }

  private:
    void watch_turret_offset(const nc::Block& block, std::int64_t number);
    bool is_allowed(const DiagnosticRow& row, const nc::Block& block) const;
    bool first_time_of_feed(const DiagnosticRow& row, const nc::Block& block);
    double below_retract() const;

    Channel& channel_;
    const nc::Dialect& dialect_;
    const machine::Machine& machine_;
    const bool is_lathe_;
    const InterpreterOptions& options_;
    Reporter& reporter_;
    const Modal& modal_;
    const Position& position_;
    const Spindle& spindle_;
    const Tool& tool_;
    const RadiusCompState& comp_;
    const bool& is_scanning_;
    const Units& units_;
    ReportedInRun& told_;
    Dangers& dangers_;
    const std::optional<ContourRun>& contour_;
};

}  // namespace kadr::interp
