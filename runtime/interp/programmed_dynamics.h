// programmed_dynamics.h — how fast motions may be as programmed, and what the program takes from
// the operator's panel. Internal to interp.
#pragma once

#include <cstdint>
#include <optional>

#include "interp/axis_data.h"
#include "interp/interpreter.h"
#include "interp/reporter.h"
#include "interp/state.h"
#include "machine/machine.h"
#include "nc/block.h"
#include "path/command.h"

namespace kadr::interp {

class ProgrammedDynamics {
  public:
    /// All have to live as long.
    ProgrammedDynamics(const machine::Machine& machine, const AxisData& axes, Reporter& reporter)
        : machine_(machine), axes_(axes), reporter_(reporter) {}

    /// FeedOverride, RapidOverride.
    void set_override(const nc::Block& block, const nc::Invocation& invocation);
    /// AxisVelocity, AxisAcceleration, AxisJerk.
    void set_axis_limit(const nc::Block& block, const nc::Invocation& invocation);
    void choose_feed_axes(const nc::Block& block, const nc::Invocation& invocation);
    void set_feed_radius(const nc::Block& block, const nc::Invocation& invocation);
    void choose_feed_characteristic(const nc::Block& block, const nc::Invocation& invocation);
    /// AxisSpeed, AxisFeed, AxisOverride.
    void set_axis_speed(const nc::Block& block, const nc::Invocation& invocation);
    /// The feed of one block, which the law names, as a polynomial.
    void set_polynomial(const path::FeedLaw& law) {
        state_.has_feed_characteristic = true;
        state_.polynomial = law;
    }

    /// #3004 of a FANUC, as a sum: what does not act.
    ControlAccess::Write suppress_panel(double value);
    double suppressed_panel() const;
    bool has_exact_stop() const { return state_.has_exact_stop; }
    bool has_feed_characteristic() const { return state_.has_feed_characteristic; }
    /// Whether an axis positions at a speed of its own.
    bool has_positioning() const { return state_.positioning.is_given; }

    /// What acts beside it.
    struct Acting {
        bool taps;  // neither an override of the feed nor a hold acts
        path::FeedMode feed_mode;
        std::uint32_t block;  // of the run, by its count
    };
    /// Fills in what of the panel and of the programmed limits acts on a motion.
    void put_panel(path::Motion& motion, const nc::Block& block, const Acting& acting) const;
    /// … and the speeds of axes that position by themselves.
    void put_positioning(path::Motion& motion) const;

  private:
    path::Dynamics& programmed_dynamics();
    std::optional<Axis> known_axis(const nc::Block& block, const nc::Invocation& invocation,
                                   std::size_t parameter);
    void put_feed_law(path::Motion& motion, const Acting& acting) const;

    const machine::Machine& machine_;
    const AxisData& axes_;
    Reporter& reporter_;
    PanelState state_;
};

}  // namespace kadr::interp
