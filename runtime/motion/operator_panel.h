// operator_panel.h — what the operator does while a program runs: overrides, feed hold, cycle
// start.
//
// Knows when which switch is turned, and nothing of motion; how the path speed follows is
// planner_operated.cpp's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kadr::motion {

/// Parts of what is programmed, ≥ 0; at 0 the motion stands. So does what can be held while the
/// feed is held.
struct Overrides {
    double feed = 1;
    double rapid = 1;
    bool is_held = false;
    bool operator==(const Overrides&) const = default;
};

enum class OperatorAct : std::uint8_t { FeedOverride, RapidOverride, FeedHold, CycleStart };

struct OperatorEvent {
    OperatorAct act = OperatorAct::FeedHold;
    double value = 1;  // of an override, as in Overrides
    double time = 0;   // s, ≥ 0, from the start of the program, or of the block
    // The block, by one of these; neither: the program.
    std::uint32_t line = 0;    // its line of the ISO-7bit text, from 1
    std::int32_t number = -1;  // N
};

/// The panel as it stands, and what will be done with it. Events of one time act in the order in
/// which they were given; one of a block when the block is begun for the first time.
class OperatorPanel {
  public:
    OperatorPanel(const std::vector<OperatorEvent>& events, const Overrides& at_start);

    /// Whether anything that is to be done can change what acts on the motion. If not, the run is
    /// the same as without an operator.
    bool is_used() const { return is_used_; }
    /// When the next event acts, s; infinite if none is known.
    double next_time() const;
    /// Does what is due at a time; false if the panel stands as before.
    bool act_until(double time);
    /// Does what comes until a time, as far as it leaves the panel as it stands: the motion need
    /// not know. What comes at one moment counts together.
    void pass_idle_until(double time);
    /// A block begins; -1: it has no number.
    void begin_block(std::uint32_t line, std::int32_t number, double time);
    /// Whether any event waits for a block.
    bool waits_for_block() const { return !ahead_.empty(); }

    const Overrides& dials() const { return dials_; }
    bool is_held() const { return is_held_; }
    /// What acts on the motion.
    Overrides acting() const { return {dials_.feed, dials_.rapid, is_held_}; }
    /// The highest of all that can come, > 0.
    const Overrides& highest() const { return highest_; }
    /// What is planned for blocks that were not begun yet.
    const std::vector<OperatorEvent>& ahead() const { return ahead_; }

  private:
    /// What a person sees on the panel.
    struct Dials {
        Overrides dials;
        bool is_held = false;
        bool operator==(const Dials&) const = default;
    };
    Dials standing() const { return {dials_, is_held_}; }
    void act(const OperatorEvent& event);
    bool changes_anything() const;

    std::vector<OperatorEvent> events_;  // at times of the program, sorted
    std::size_t next_ = 0;
    std::vector<OperatorEvent> ahead_;  // at blocks that are not begun yet
    Overrides dials_;
    Overrides highest_;
    bool is_held_ = false;
    bool is_used_ = false;
};

}  // namespace kadr::motion
