// input_events.h — assignments that the machine makes while the program runs, at their times.
#pragma once

#include <span>

#include "macro/outcome.h"
#include "macro/program_frame.h"

namespace kadr::macro {

class ProgramRun;

class InputEvents {
  public:
    /// run  outlives it
    explicit InputEvents(ProgramRun& run) : run_(run) {}

    /// An event and when its block began, s; nothing: not yet.
    struct PendingEvent {
        const InputEvent* event;
        std::optional<double> begun;
    };

    /// Those of the options.
    void begin(std::span<const InputEvent> events);
    bool is_pending() const { return !pending_.empty(); }
    std::span<const PendingEvent> pending() const { return pending_; }
    /// Whether one of them waits for its block.
    bool waits_for_block() const { return waits_for_block_; }
    /// Whether the next line is one that an event waits for.
    bool comes_next();
    /// That line begins: times count from here.
    void begin_block();
    /// What is due in front of the statement that comes next.
    void act();

  private:
    struct EventBlock {
        std::int64_t number = -1;  // N
        std::uint64_t line = 0;    // of the main text; 0: of another one
    };
    bool is_here(const PendingEvent& event) const;
    void act_event(const InputEvent& event);

    ProgramRun& run_;
    std::vector<PendingEvent> pending_;
    bool waits_for_block_ = false;
    EventBlock next_;
    bool is_acting_ = false;
};

}  // namespace kadr::macro
