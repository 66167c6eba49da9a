// smooth_approaches.h — smooth approach and retraction.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// Smooth approach and retraction.
class SmoothApproaches {
  public:
    explicit SmoothApproaches(Channel& channel);
    SmoothApproaches(const SmoothApproaches&) = delete;
    SmoothApproaches& operator=(const SmoothApproaches&) = delete;

    /// G147, G247, G347.
    void approach_smoothly(const nc::Block& block, const Actions& actions);
    /// G148, G248, G348.
    void retract_smoothly(const nc::Block& block, const Actions& actions);
    /// What a block has put while an approach waits; when its contour has begun, all goes on.
    void settle_approach(const nc::Block& block);

  private:
    std::optional<ApproachMove> approach_move_of(const nc::Block& block, const Actions& actions);
    double base_level(double programmed) const;
    std::optional<path::ApproachPath> approach_path(const nc::Block& block,
                                                    const ApproachMove& move,
                                                    const ApproachPoint& at);
    std::optional<double> approach_level(const nc::Block& block, const ApproachMove& move,
                                         double contour, double tool);
    void put_smooth_approach();
    void put_infeed(path::Command command, AxisValues& here, double level);
    void put_approach_path(path::Command command, const path::Element& element);
    path::Vec2 in_plane(const AxisValues& values) const;
    void set_in_plane(AxisValues& values, const path::Vec2& point) const;

    Channel& channel_;
    Reporter& reporter_;
    const nc::Rules& rules_;
    CommandOutput& output_;
    const Modal& modal_;
    Position& position_;
    const control::Frames& frames_;
    const Tool& tool_;
    const RadiusCompState& comp_;
    const Orienting& orienting_;
    const ApproachChoice& approach_choice_;
    SmoothApproach& smooth_approach_;
    std::optional<Approached>& approached_;
    Compensation& compensation_;
};

}  // namespace kadr::interp
