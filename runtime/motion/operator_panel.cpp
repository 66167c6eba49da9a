#include "motion/operator_panel.h"

#include <algorithm>
#include <limits>

namespace kadr::motion {

namespace {

bool is_before(const OperatorEvent& a, const OperatorEvent& b) { return a.time < b.time; }

}  // namespace

OperatorPanel::OperatorPanel(const std::vector<OperatorEvent>& events, const Overrides& at_start)
    : dials_(at_start), highest_(at_start) {
    for (const OperatorEvent& event : events) {
        const bool is_of_program = event.line == 0 && event.number < 0;
        (is_of_program ? events_ : ahead_).push_back(event);
        if (event.act == OperatorAct::FeedOverride)
            highest_.feed = std::max(highest_.feed, event.value);
        if (event.act == OperatorAct::RapidOverride)
            highest_.rapid = std::max(highest_.rapid, event.value);
    }
    std::stable_sort(events_.begin(), events_.end(), is_before);
    const bool may_go = dials_.feed > 0 && dials_.rapid > 0;
    is_used_ = changes_anything() || (!events.empty() && !may_go);
    // Path that is never run has to be prepared for some speed.
    if (!(highest_.feed > 0)) highest_.feed = 1;
    if (!(highest_.rapid > 0)) highest_.rapid = 1;
}

double OperatorPanel::next_time() const {
    return next_ < events_.size() ? events_[next_].time : std::numeric_limits<double>::infinity();
}

/// Whether any event, in whatever order they come, finds something to change: those of blocks have
/// no time yet.
bool OperatorPanel::changes_anything() const {
    const auto changes = [this](const OperatorEvent& event) {
        switch (event.act) {
            case OperatorAct::FeedOverride: return event.value != dials_.feed;
            case OperatorAct::RapidOverride: return event.value != dials_.rapid;
            case OperatorAct::FeedHold: return true;
            case OperatorAct::CycleStart: return false;
        }
        return true;
    };
    return std::ranges::any_of(events_, changes) || std::ranges::any_of(ahead_, changes);
}

bool OperatorPanel::act_until(double time) {
    const Dials before = standing();
    while (next_ < events_.size() && events_[next_].time <= time) act(events_[next_++]);
    return standing() != before;
}

void OperatorPanel::pass_idle_until(double time) {
    while (next_time() <= time) {
        const Dials before = standing();
        const std::size_t first = next_;
        if (!act_until(next_time())) continue;
        dials_ = before.dials;
        is_held_ = before.is_held;
        next_ = first;
        return;
    }
}

void OperatorPanel::act(const OperatorEvent& event) {
    switch (event.act) {
        case OperatorAct::FeedOverride: dials_.feed = event.value; return;
        case OperatorAct::RapidOverride: dials_.rapid = event.value; return;
        case OperatorAct::FeedHold: is_held_ = true; return;
        case OperatorAct::CycleStart: is_held_ = false; return;
    }
}

void OperatorPanel::begin_block(std::uint32_t line, std::int32_t number, double time) {
    const auto is_of_block = [line, number](const OperatorEvent& event) {
        return event.number >= 0 ? event.number == number : event.line == line;
    };
    for (OperatorEvent event : ahead_) {
        if (!is_of_block(event)) continue;
        event.time += time;
        const auto first = events_.begin() + static_cast<std::ptrdiff_t>(next_);
        events_.insert(std::upper_bound(first, events_.end(), event, is_before), event);
    }
    std::erase_if(ahead_, is_of_block);
}

}  // namespace kadr::motion
