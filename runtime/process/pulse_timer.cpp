#include "process/pulse_timer.h"

#include <algorithm>
#include <cmath>

#include "base/assert.h"
#include "motion/lookahead.h"

namespace kadr::process {

namespace {

using motion::Segment;
using motion::SegmentKind;

constexpr std::size_t kSegmentBatch = 32;

// So many pieces that burn nothing are planned together at most.
constexpr std::size_t kMostAlone = 1024;

/// Whether a segment belongs to a block that burns a point at its end.
bool is_burning(const Segment& segment) {
    return segment.kind == SegmentKind::Feed && segment.spindle.is_turning;
}

PulseLeg leg_of(const Segment& segment) {
    const motion::Profile& plan = segment.profile;
    return {plan.length, plan.peak_speed, plan.acceleration, plan.entry_speed};
}

}  // namespace

PulseTimer::PulseTimer(Stream<Segment>& planned, const machine::Machine& machine)
    : planned_(planned),
      axes_(machine),
      laser_(machine.laser.value_or(machine::Laser{})),
      clock_(machine::pulse_clock(laser_, machine.tick).value_or(PulseClock{1, 1, 1})),
      tick_(machine.tick),
      batch_(kSegmentBatch),
      ahead_(clock_, tick_) {}

std::size_t PulseTimer::pull(std::span<Segment> out) {
    std::size_t written = 0;
    while (written < out.size()) {
        if (ready_at_ == ready_.size()) {
            ready_.clear();
            ready_at_ = 0;
            if (!work()) break;
            continue;
        }
        out[written++] = ready_[ready_at_++];
    }
    return written;
}

bool PulseTimer::read(Segment& segment) {
    if (batch_at_ == batch_size_) {
        if (has_ended_) return false;
        batch_at_ = 0;
        batch_size_ = planned_.pull(batch_);
        if (batch_size_ == 0) {
            has_ended_ = true;
            return false;
        }
    }
    segment = batch_[batch_at_++];
    return true;
}

/// One step; false at the end.
bool PulseTimer::work() {
    if (ahead_.is_ready()) {
        deliver_link();
        return true;
    }
    if (next_) {
        const Segment segment = *next_;
        next_.reset();
        do_alone(segment);
        return true;
    }
    Segment segment;
    if (!read(segment)) {
        if (ahead_.is_empty() && alone_.empty()) return false;
        if (!ahead_.is_empty()) ahead_.finish();
        flush_alone();
        return true;
    }
    if (is_link(segment)) {
        flush_alone();
        append_link(segment);
    } else {
        if (!ahead_.is_empty()) ahead_.finish();
        next_ = segment;
    }
    begins_command_ = segment.ends_command;
    return true;
}

/// Whether a segment is a whole block that ends at a point, and can pass it.
bool PulseTimer::is_link(const Segment& segment) const {
    return laser_.mode == machine::PulseMode::Synchronised && is_burning(segment) &&
           begins_command_ && segment.ends_command && segment.profile.length > 0;
}

void PulseTimer::append_link(const Segment& segment) {
    ahead_.append(leg_of(segment));
    links_.push_back(segment);
}

void PulseTimer::deliver_link() {
    // Empty pulses pass while nothing moves; then the last of them counts.
    const std::int64_t since = (ticks_ - last_pulse_) % clock_.nominal;
    const PulseBlock block = ahead_.take(since);
    Segment segment = links_.front();
    links_.pop_front();
    segment.profile = block.profile;
    segment.has_pulse = true;
    const std::int64_t end = ticks_ + block.ticks;
    deliver(segment, static_cast<double>(end) * tick_ - time_);
    advance_to(end);
    last_pulse_ = end;
    ++pulses_;
}

/// What begins and ends at rest: the pieces of a block that burns, or motion between two stops.
void PulseTimer::do_alone(Segment segment) {
    if (!motion::is_motion(segment.kind)) {
        flush_alone();
        const double duration = segment.duration;
        deliver(std::move(segment), duration);
        finish_alone(false);
        return;
    }
    const bool burns = is_burning(segment);
    if (burns != (!alone_.empty() && is_burning(alone_.back()))) flush_alone();
    const bool stops = segment.profile.exit_speed == 0 || alone_.size() + 1 >= kMostAlone;
    const bool is_over = burns ? segment.ends_command : stops;
    alone_.push_back(std::move(segment));
    if (is_over) flush_alone();
}

void PulseTimer::flush_alone() {
    if (alone_.empty()) return;
    const bool is_point = is_burning(alone_.back());
    move_alone();
    finish_alone(is_point);
}

void PulseTimer::move_alone() {
    motion::LookAhead ahead(alone_.size());
    for (const Segment& piece : alone_) {
        const motion::Profile& plan = piece.profile;
        ahead.append({plan.length, plan.peak_speed, plan.acceleration,
                      &piece == &alone_.front() ? 0 : plan.entry_speed});
    }
    ahead.finish();
    for (Segment& piece : alone_) {
        const motion::Profile plan = piece.profile;
        const motion::JunctionSpeeds speeds = ahead.take();
        const auto profile =
            motion::trapezoid(plan.length, speeds.entry, speeds.exit,
                              {plan.peak_speed, plan.acceleration, plan.acceleration});
        KADR_ASSERT(profile.has_value(), "the look-ahead promised a change of speed that fits");
        piece.profile = *profile;
        deliver(piece, profile->duration());
    }
    alone_.clear();
}

/// Waits for the next tick, or at a point for the next pulse.
void PulseTimer::finish_alone(bool is_point) {
    const auto reached = static_cast<std::int64_t>(std::llround(motion::ticks_of(time_, tick_)));
    if (!is_point) {
        wait_until(reached, false);
        return;
    }
    const std::int64_t since = reached - last_pulse_;
    const std::int64_t best = machine::best_tick(clock_, machine::pulse_at_or_after(clock_, since));
    const std::int64_t pulse = last_pulse_ + std::max(since, best);
    wait_until(pulse, true);
    last_pulse_ = pulse;
    ++pulses_;
}

void PulseTimer::wait_until(std::int64_t ticks, bool has_pulse) {
    const double duration = static_cast<double>(ticks) * tick_ - time_;
    // Less than a millionth of a tick is rounding, no wait.
    if (duration > 1e-6 * tick_) {
        Segment wait = last_;
        wait.kind = SegmentKind::Dwell;
        wait.curve = path::Point{path::end(last_.curve)};
        for (std::size_t i = 0; i < motion::kFollowers; ++i) {
            wait.follower_start[i] += wait.follower_rate[i] * last_.profile.length;
            wait.follower_rate[i] = 0;
        }
        wait.followers = 0;
        wait.profile = {};
        wait.has_pulse = has_pulse;
        deliver(wait, duration);
    } else if (!ready_.empty()) {
        ready_.back().has_pulse = has_pulse;
    }
    advance_to(ticks);
}

void PulseTimer::deliver(Segment segment, double duration) {
    segment.start_time = time_;
    segment.duration = duration;
    time_ += duration;
    record(segment);
    last_ = segment;
    ready_.push_back(std::move(segment));
}

/// On a tick the time is exact.
void PulseTimer::advance_to(std::int64_t ticks) {
    ticks_ = ticks;
    time_ = static_cast<double>(ticks) * tick_;
}

void PulseTimer::record(const Segment& segment) {
    switch (segment.kind) {
        case SegmentKind::Rapid: totals_.rapid_time += segment.duration; break;
        case SegmentKind::Feed: totals_.cutting_time += segment.duration; break;
        case SegmentKind::Dwell:
        case SegmentKind::Orient: totals_.dwell_time += segment.duration; break;
        case SegmentKind::ToolChange: totals_.tool_change_time += segment.duration; break;
        case SegmentKind::Hold: totals_.hold_time += segment.duration; break;
        case SegmentKind::Wait: totals_.wait_time += segment.duration; break;
        case SegmentKind::External:
        case SegmentKind::Jump:
        case SegmentKind::Mark: totals_.external_time += segment.duration; break;
    }
    if (!motion::is_motion(segment.kind)) return;
    // In the middle of a dip the speed is least, and its ramps have the other sign.
    Segment upright = segment;
    motion::Profile& profile = upright.profile;
    profile.peak_speed = std::max({profile.entry_speed, profile.peak_speed, profile.exit_speed});
    profile.acceleration = std::abs(profile.acceleration);
    profile.deceleration = std::abs(profile.deceleration);
    const motion::AxisRates in = axes_.start_rates(segment);
    const motion::AxisTable::Peaks peaks = axes_.peaks(upright, axes_.loads(upright, in));
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        totals_.max_velocity[i] = std::max(totals_.max_velocity[i], peaks.velocity[i]);
        const double jump = std::abs(in[i] - last_rates_[i]) * profile.entry_speed / tick_;
        totals_.max_acceleration[i] =
            std::max({totals_.max_acceleration[i], peaks.acceleration[i], jump});
    }
    last_rates_ = axes_.end_rates(segment);
}

motion::Totals PulseTimer::totals(const motion::Totals& planned) const {
    motion::Totals totals = planned;
    totals.time = time_;
    totals.cutting_time = totals_.cutting_time;
    totals.rapid_time = totals_.rapid_time;
    totals.dwell_time = totals_.dwell_time;
    totals.tool_change_time = totals_.tool_change_time;
    totals.external_time = totals_.external_time;
    totals.max_velocity = totals_.max_velocity;
    totals.max_acceleration = totals_.max_acceleration;
    return totals;
}

}  // namespace kadr::process
