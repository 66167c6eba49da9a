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

    /// A chamfer, a rounding, or their feed, at the end of the block's motion.
    void choose_corner(const nc::Block& block, const nc::Invocation& invocation, Actions& actions);
    /// Tells the corners what this block asks for, before it puts its motion.
    void wish_corner(const nc::Block& block, const Actions& actions);
    /// Whether the words of arcs beside a line program a corner.
    bool has_square_corner(const nc::Block& block) const;
    /// A chamfer or a rounding at a square corner, programmed by the words of arcs beside a line:
    /// the centre word of the other axis, or a radius, whose sign is the direction onwards.
    void wish_square_corner(const nc::Block& block, const Target& target);
    /// A cycle, or the end of the text, has no corner with the motion before it.
    void leave_corners(const DiagnosticRow& why);
    /// What is settled goes on to the next stage.
    void pass_corners();
    /// At the block that asked for the corner.
    void report_corner(const CornerMessage& message);
    /// Whether a corner at the end of a motion may still be wished for, by a block behind it.
    bool wishes_corners() const { return modal_rounding_ > 0 || rules_.corner_in_own_block; }

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
    double modal_rounding_ = 0;  // of every corner, mm; 0: none
    double corner_feed_ = 0;     // of every corner; 0: that of a neighbour
};

}  // namespace kadr::interp
