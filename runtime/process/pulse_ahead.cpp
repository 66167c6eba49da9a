#include "process/pulse_ahead.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/assert.h"

namespace kadr::process {

namespace {

// Bands with more intervals than this beyond the fewest are put together: the solution that is
// taken has fewer, but a speed that has been reached must not be without a band.
constexpr std::int64_t kSpare = 3;
// Windows that are tried beyond the first that can be hit.
constexpr std::int64_t kWindows = 2;
constexpr int kHalvings = 36;  // of speeds below 100 mm/s: a millionth of a mm/s
// Legs whose mean speed the end speed goes for.
constexpr std::size_t kMean = 4;

// A time that misses a tick by less is on it.
constexpr double kTickRounding = 1e-7;

struct Ends {
    double low = 0;
    double high = 0;
};

/// End speeds within a band that can be reached from a speed.
Ends reachable(const PulseLeg& leg, double from, const Ends& band) {
    const double change = 2 * leg.acceleration * leg.length;
    const double squared = from * from;
    return {std::max(band.low, std::sqrt(std::max(0.0, squared - change))),
            std::min(band.high, std::sqrt(squared + change))};
}

/// Durations from a speed to any of the end speeds: their ranges run into each other.
Durations durations_to(const PulseLeg& leg, double from, const Ends& ends) {
    const auto fast = durations(leg, from, ends.high);
    const auto slow = durations(leg, from, ends.low);
    if (!fast || !slow) return {std::numeric_limits<double>::infinity(), 0};
    return {fast->least, slow->most};
}

/// The speed between two at which a test changes its answer: it holds at `yes`.
template <typename Test>
double edge(double yes, double no, const Test& holds) {
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = (yes + no) / 2;
        (holds(middle) ? yes : no) = middle;
    }
    return yes;
}

/// A leg, its entry limit and the end speeds that it may have.
struct Task {
    const PulseLeg& leg;
    double limit;
    Ends band;

    Durations time_from(double from) const {
        return durations_to(leg, from, reachable(leg, from, band));
    }
};

/// Times with what rounding may take from them, s.
struct Times {
    double first = 0;
    double last = 0;
};

/// The entry speeds from which a task can take a time between two; false if there are none.
bool find_entries(const Task& task, const Times& times, Ends& found) {
    const double change = 2 * task.leg.acceleration * task.leg.length;
    const double most = std::min(task.limit, std::sqrt(task.band.high * task.band.high + change));
    const double least = std::sqrt(std::max(0.0, task.band.low * task.band.low - change));
    if (least > most) return false;
    // Both ends of the range of times fall while the entry speed grows.
    const auto is_fast = [&](double from) { return task.time_from(from).least <= times.last; };
    const auto is_slow = [&](double from) { return task.time_from(from).most >= times.first; };
    if (!is_fast(most) || !is_slow(least)) return false;
    found.low = is_fast(least) ? least : edge(most, least, is_fast);
    found.high = is_slow(most) ? most : edge(least, most, is_slow);
    return found.low <= found.high;
}

Times times_of(std::int64_t first, std::int64_t last, double tick) {
    return {(static_cast<double>(first) - kTickRounding) * tick,
            (static_cast<double>(last) + kTickRounding) * tick};
}

/// The same for whole ticks of a window. Where there is no choice of times, close to a full brake
/// or a full start, it may lie between two ticks.
void find_entries(const Task& task, const PulseWindow& window, double tick,
                  std::vector<Ends>& found) {
    Ends whole;
    if (!find_entries(task, times_of(window.first, window.last, tick), whole)) return;
    const auto width = [&](double from) {
        const Durations time = task.time_from(from);
        return time.most - time.least;
    };
    if (width(whole.low) >= tick && width(whole.high) >= tick) {
        found.push_back(whole);
        return;
    }
    for (std::int64_t ticks = window.first; ticks <= window.last; ++ticks) {
        Ends one;
        if (find_entries(task, times_of(ticks, ticks, tick), one)) found.push_back(one);
    }
}

}  // namespace

PulseAhead::PulseAhead(const PulseClock& clock, double tick, std::size_t depth)
    : clock_(clock), tick_(tick) {
    depth = std::max<std::size_t>(depth, 1);
    chunk_ = depth / 2 + 1;
    nodes_.resize(depth + chunk_ - 1);
}

void PulseAhead::append(const PulseLeg& leg) {
    KADR_ASSERT(!is_full() && !is_finished_, "there is no room for another leg");
    Node& fresh = node(count_);
    fresh.leg = leg;
    fresh.limit = std::min({leg.entry_limit, last_speed_, leg.speed});  // 0 at the beginning
    last_speed_ = leg.speed;
    ++count_;
}

void PulseAhead::plan_backward() {
    const Bands rest = {{0, 0, 0}};  // the path ends at rest behind what is known
    // The speed before the oldest leg is known.
    for (std::size_t i = count_; i-- > 1;) {
        find_bands(node(i), i + 1 < count_ ? node(i + 1).bands : rest);
    }
}

void PulseAhead::find_bands(Node& at, const Bands& behind) const {
    Bands all;
    std::vector<Ends> found;
    std::int64_t hit = 0;  // the first window that can be hit
    // Rest before the leg is possible always: one can come to a stand anywhere and wait.
    std::int64_t from_rest = 0;
    for (std::int64_t k = 1; from_rest == 0 || k < hit + kWindows; ++k) {
        for (const Band& band : behind) {
            found.clear();
            find_entries({at.leg, at.limit, {band.low, band.high}}, pulse_window(clock_, k), tick_,
                         found);
            for (const Ends& speeds : found) {
                if (hit == 0) hit = k;
                if (speeds.low == 0 && from_rest == 0) from_rest = k;
                all.push_back({k + band.intervals, speeds.low, speeds.high});
            }
        }
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const Band& a, const Band& b) { return a.intervals < b.intervals; });
    at.bands.clear();
    const std::int64_t most = all.front().intervals + kSpare;
    for (Band& band : all) {
        band.intervals = std::min(band.intervals, most);
        const auto same = std::find_if(at.bands.begin(), at.bands.end(), [&band](const Band& b) {
            return b.intervals == band.intervals && b.low <= band.high && band.low <= b.high;
        });
        if (same == at.bands.end()) {
            at.bands.push_back(band);
        } else {
            same->low = std::min(same->low, band.low);
            same->high = std::max(same->high, band.high);
        }
    }
}

/// How the oldest leg can go on from the speed that was reached, the fewest intervals first.
std::vector<PulseAhead::PulseChoice> PulseAhead::choices(const Node& at, const Bands& behind,
                                                         std::int64_t since) const {
    std::vector<PulseChoice> found;
    std::int64_t hit = 0;
    bool can_be_later = true;
    for (std::int64_t k = 1; (hit == 0 && can_be_later) || k < hit + kWindows; ++k) {
        const PulseWindow window = pulse_window(clock_, k);
        can_be_later = false;
        for (const Band& band : behind) {
            const Ends ends = reachable(at.leg, speed_, {band.low, band.high});
            if (ends.low > ends.high) continue;
            const Durations time = durations_to(at.leg, speed_, ends);
            const Times latest = times_of(window.last - since, window.last - since, tick_);
            can_be_later = can_be_later || time.most > latest.last;
            const std::int64_t ticks = ticks_in(window, time, machine::best_tick(clock_, k), since);
            if (ticks == 0) continue;
            if (hit == 0) hit = k;
            found.push_back({k, k + band.intervals, ticks, ends.low, ends.high});
        }
    }
    std::stable_sort(found.begin(), found.end(), [](const PulseChoice& a, const PulseChoice& b) {
        return a.intervals != b.intervals ? a.intervals < b.intervals : a.window < b.window;
    });
    return found;
}

/// The ticks of the window, after those that are gone, that a range of times allows and that come
/// closest to the best one; 0: none.
std::int64_t PulseAhead::ticks_in(const PulseWindow& window, const Durations& time,
                                  std::int64_t wished, std::int64_t since) const {
    std::int64_t best = 0;
    for (std::int64_t ticks = std::max<std::int64_t>(window.first - since, 1);
         ticks <= window.last - since; ++ticks) {
        const Times exact = times_of(ticks, ticks, tick_);
        if (time.least > exact.last || time.most < exact.first) continue;
        if (best == 0 || std::abs(ticks + since - wished) < std::abs(best + since - wished)) {
            best = ticks;
        }
    }
    return best;
}

/// The mean speed of the legs to come at one interval each: with it the windows are hit without
/// ups and downs.
double PulseAhead::wanted_exit(std::size_t legs) {
    const std::size_t last = std::min(1 + kMean, legs);
    if (last <= 1) return 0;
    double distance = 0;
    for (std::size_t i = 1; i < last; ++i) distance += node(i).leg.length;
    return distance / (static_cast<double>(last - 1) * static_cast<double>(clock_.nominal) * tick_);
}

/// The leg on its way: the end speed comes from the wanted one, as far as the time allows.
PulseBlock PulseAhead::block_of(const PulseLeg& leg, const PulseChoice& choice,
                                double wanted) const {
    const Times exact = times_of(choice.ticks, choice.ticks, tick_);
    const auto is_fast = [&](double exit) {
        const auto time = durations(leg, speed_, exit);
        return time && time->least <= exact.last;
    };
    const auto is_slow = [&](double exit) {
        const auto time = durations(leg, speed_, exit);
        return time && time->most >= exact.first;
    };
    double exit = std::clamp(wanted, choice.low, choice.high);
    if (!is_fast(exit)) exit = edge(choice.high, exit, is_fast);
    else if (!is_slow(exit)) exit = edge(choice.low, exit, is_slow);
    return {profile_lasting(leg, speed_, exit, static_cast<double>(choice.ticks) * tick_),
            choice.ticks, choice.window};
}

PulseBlock PulseAhead::take(std::int64_t since) {
    KADR_ASSERT(is_ready(), "not enough of the path is known");
    if (takeable_ == 0) {
        plan_backward();
        takeable_ = is_finished_ ? count_ : std::min(chunk_, count_);
    }
    const Bands rest = {{0, 0, 0}};
    const Node& oldest = node(0);
    const Bands& behind = count_ > 1 ? node(1).bands : rest;
    const std::vector<PulseChoice> all = choices(oldest, behind, since);
    KADR_ASSERT(!all.empty(), "the bands promised that the leg can end on a pulse");
    const PulseBlock block = block_of(oldest.leg, all.front(), wanted_exit(count_));
    speed_ = block.profile.exit_speed;
    first_ = (first_ + 1) % nodes_.size();
    --count_;
    --takeable_;
    if (is_finished_ && count_ == 0) {
        is_finished_ = false;
        takeable_ = 0;
        speed_ = last_speed_ = 0;
    }
    return block;
}

}  // namespace kadr::process
