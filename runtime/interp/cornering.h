// cornering.h — chamfers and roundings: what blocks ask for, given to the stage that makes them.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// Chamfers and roundings: what blocks ask for, given to the stage that makes them.
class Cornering {
  public:
    explicit Cornering(Channel& channel);
    Cornering(const Cornering&) = delete;
    Cornering& operator=(const Cornering&) = delete;

    void choose_corner(const nc::Block& block, const nc::Invocation& invocation, Actions& actions);
    void wish_corner(const nc::Block& block, const Actions& actions);
    bool has_square_corner(const nc::Block& block) const;
    void wish_square_corner(const nc::Block& block, const Target& target);
    void leave_corners(const DiagnosticRow& why);
    void pass_corners();
    void report_corner(const CornerMessage& message);
    /// Whether a corner at the end of a motion may still be wished for, by a block behind it.
    bool wishes_corners() const { return rounding_ > 0 || rules_.corner_in_own_block; }

  private:
    void take_corner_feed(const nc::Block& block, const nc::Invocation& invocation,
                          Actions& actions);
    void put_wish(const nc::Block& block, CornerWish wish);

    Channel& channel_;
    Reporter& reporter_;
    const nc::Rules& rules_;
    const Modal& modal_;
    const Position& position_;
    const control::Frames& frames_;
    Corners& corners_;
    const RadiusCompState& comp_;
    const SmoothApproach& smooth_approach_;
    double rounding_ = 0;     // of every corner, mm; 0: none
    double corner_feed_ = 0;  // of every corner; 0: that of a neighbour
};

}  // namespace kadr::interp
