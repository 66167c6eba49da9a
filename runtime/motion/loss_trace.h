// loss_trace.h — finds for every planned piece why it takes longer than its feed would.
//
// Sees pieces with their profiles in the order of the path. What a limit inside the piece costs is
// reported at once, and so is what it costs to get up to speed again; what braking costs waits for
// the slow point that it is for.
#pragma once

#include <functional>
#include <vector>

#include "machine/machine.h"
#include "motion/piece.h"
#include "motion/speed_loss.h"

namespace kadr::motion {

class LossTrace {
  public:
    using Report = std::function<void(const SpeedLoss&)>;
    /// References outlive the trace. `report` may be empty: then nothing is looked at.
    LossTrace(const machine::Machine& machine, const AxisTable& axes, Report report)
        : machine_(machine), axes_(axes), report_(std::move(report)) {}

    /// The next piece, planned.
    ///
    /// feed_override  that acts in it
    void add(const Piece& piece, double feed_override);
    /// The path has ended.
    void finish() { settle(LossReason::Stop); }

  private:
    /// What both directions of a ramp cost on one piece, s.
    struct Ramps {
        double up = 0;
        double down = 0;
        double jerk = 0;  // of both, what they take longer than without a limit of the jerk
    };
    struct Inside {
        double speed = 0;
        LossReason reason = LossReason::AxisVelocity;
    };

    double asked(const Piece& piece, double feed_override) const;
    Inside limit_inside(const Piece& piece, double asked) const;
    LossReason reason_of(const Piece& piece, double speed) const;
    double bend_speed(const BentCell& cell) const;
    static Ramps ramps_of(const Piece& piece, double speed);
    void pass_junction(const Piece& piece, double speed);
    void settle(LossReason reason);
    void report(const Piece& piece, LossReason reason, double time) const;

    const machine::Machine& machine_;
    const AxisTable& axes_;
    Report report_;
    std::vector<SpeedLoss> braking_;  // for a slow point that has not come yet
    LossReason up_ = LossReason::Stop;
    double last_speed_ = 0;  // limit inside the piece before
};

}  // namespace kadr::motion
