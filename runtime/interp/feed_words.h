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

    /// F as the program has said it, unit of the feed mode.
    struct Programmed {
        double feed = 0;
        bool is_given = false;
    };
    /// This one acts from here on; returns the one before.
    Programmed exchange(Programmed by) {
        return {std::exchange(modal_.feed, by.feed), std::exchange(modal_.has_feed, by.is_given)};
    }
    /// As if F had been said: nothing moves with it.
    void assume(double feed) { (void)exchange({feed, true}); }

    void report_varying_feed(const path::Command& command, double feed);
    void select_feed_mode(nc::Function member);
    void set_feed(const nc::Block& block);
    void set_tooth_feed(const nc::Block& block, double feed);
    void take_tooth_feed();
    void take_polynomial(const nc::Block& block, const nc::Invocation& invocation);
    bool may_count_degrees(const nc::Block& block) const;
    void count_degrees(const nc::Block& block, path::Command& command) const;

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
    double tooth_feed_ = 0;  // mm; 0: the feed was said by itself
};

}  // namespace kadr::interp
