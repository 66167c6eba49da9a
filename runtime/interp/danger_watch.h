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

    /// The feed of a cut with a running spindle, where it is another one than that of the cut
    /// before.
    void watch_feed(const nc::Block& block);
    /// `C2` beside a line on a lathe may have been meant as a chamfer, where the control wants a
    /// comma.
    void watch_turn_of_part(const nc::Block& block, const Target& target);
    /// A motion to this X, a radius in the programmed system, under constant cutting speed.
    void watch_cutting_speed(const nc::Block& block, double from, double to);
    /// A motion along the axis of the tool's length while another one is to act than before.
    void watch_length(const nc::Block& block, Axis axis);
    /// The first cut of a tool, in a program that has called lengths of others by their numbers:
    /// one that calls none at all has them in its work offsets.
    void watch_missing_length(const nc::Block& block);
    /// X becomes a diameter, as on a lathe.
    void watch_diameter(const nc::Block& block, nc::Function function);
    /// `G04 F2`: where F and S give no time, the code that dwells (ISO 6983-1) is an exact stop,
    /// and the feed is changed.
    void watch_dwell(const nc::Block& block);
    /// Tapping whose pitch is the feed per minute divided by the speed, `G84 … F1.25` under G94.
    ///
    /// function  where it is programmed, if the block has no F
    void watch_tap(const nc::Block& block, nc::Function function);
    /// Another tool is about to come.
    void watch_change(const nc::Block& block);
    /// The spindle is about to stop. Of a lathe its tool stands beside the part; a cycle knows what
    /// it does, and a tool that has gone straight down bores or taps, where the stop belongs to the
    /// work.
    void watch_spindle_stop(const nc::Block& block);
    /// The radius of an offset is about to act beside a contour. Shops number the offsets of radii
    /// as they like, so only that of another tool of the machine is one.
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
    const ProgrammedSpindle& spindle_;
    const Tool& tool_;
    const RadiusCompState& comp_;
    const bool& is_scanning_;
    const ProgrammedUnits& units_;
    ReportedInRun& reported_;
    Dangers& dangers_;
    const std::optional<ContourRun>& contour_;
};

}  // namespace kadr::interp
