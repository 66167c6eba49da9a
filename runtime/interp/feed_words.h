// feed_words.h — what F means, and which feed acts.
#pragma once

#include <utility>

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// What F means, and which feed acts.
class FeedWords {
  public:
    explicit FeedWords(Channel& channel);
    FeedWords(const FeedWords&) = delete;
    FeedWords& operator=(const FeedWords&) = delete;

    /// As if F had been programmed: nothing moves with it.
    void assume(double feed) {
        modal_.feed = feed;
        modal_.has_feed = true;
    }
    /// A feed of the block alone.
    void begin_block_feed(double feed) { modal_.begin_block_feed(feed); }
    void end_block_feed() { modal_.end_block_feed(); }

    /// The varying feed of a motion falls to this, in the unit of F.
    void report_varying_feed(const path::Command& command, double feed);
    /// Another meaning of F; some controls forget the old value.
    void select_feed_mode(nc::Function member);
    /// F of the block, unit of the feed mode.
    void set_feed(const nc::Block& block);
    /// The feed of a tooth times the number of teeth is the feed per revolution.
    void set_tooth_feed(const nc::Block& block, double feed);
    /// The tool in the spindle, or its data, may have become others.
    void take_tooth_feed();
    /// The polynomial of the block's motions; its end is F from here on.
    void take_polynomial(const nc::Block& block, const nc::Invocation& invocation);
    /// Whether it may matter how much a degree is in F.
    bool may_count_degrees(const nc::Block& block) const;
    /// A degree is as much in F as a unit of length: an inch where F is in inches. So it is on
    /// every control in a block in which rotary axes move alone, of which none has a radius of its
    /// own (SINUMERIK programming manual, FGREF); with other axes where F is the speed of all of
    /// them.
    void count_degrees(const nc::Block& block, path::Motion& motion) const;

  private:
    Channel& channel_;
    const machine::Machine& machine_;
    const ToolOffsets& tool_offsets_;
    Reporter& reporter_;
    const nc::Rules& rules_;
    const std::uint64_t& block_count_;
    Modal& modal_;
    const Position& position_;
    const Tool& tool_;
    ProgrammedDynamics& dynamics_;
    const AxisData& axes_;
    double tooth_feed_ = 0;  // mm; 0: the feed was programmed by itself
};

}  // namespace kadr::interp
