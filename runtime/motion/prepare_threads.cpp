// prepare_threads.cpp — threads: they begin at the spindle's mark, and some change their pitch.
//
// The spindle turns at n; from revolution to revolution the pitch p changes by k. So dp/dt = k·n
// and the speed along the path is v = p·n: dv/dt = k·n², a constant acceleration, and p² = p0² +
// 2·k·s. A piece whose acceleration is limited to just that is run with it from end to end, as the
// speeds at its ends leave nothing else. Before it the axis comes up to speed, and behind it it
// stops, as fast as it can: there no thread is true to its pitch, as on a machine.
#include <algorithm>
#include <cmath>

#include "base/diagnostics/machine.h"
#include "base/numbers.h"
#include "motion/feed.h"
#include "motion/prepare_state.h"
#include "motion/report.h"
#include "motion/smooth_profile.h"

namespace kadr::motion {

namespace {

/// Rounding: by so much more than it needs may a geared piece accelerate.
constexpr double kGearSlack = 1e-9;
/// A corner of a chain of threads that takes less of the speed leaves the pitch as it is.
constexpr double kThreadKept = 0.99;
/// What a look-ahead that never takes a speed back leaves of a smooth ramp, and a little more.
constexpr double kRampReserve = 1.1;
/// Ramps end where the speed of the thread meets them; a few steps find it.
constexpr int kRampSteps = 8;

/// The pitch along a thread.
struct VaryingPitch {
    double first = 0;   // mm/rev
    double change = 0;  // mm/rev per revolution

    double at(double s) const { return std::sqrt(std::max(0.0, first * first + 2 * change * s)); }
};

double ramp_to(double speed, const PathLimits& limits) {
    if (std::isinf(limits.jerk)) return speed * speed / (2 * limits.acceleration);
    return kRampReserve * smooth_ramp_length(0, speed, {limits.acceleration, limits.jerk});
}

}  // namespace

/// A thread begins when the spindle is at the angle that is programmed, so that passes run in one
/// groove. One that goes on with another does not wait. S 4.6.
void Preparer::State::meet_spindle(const path::Command& command) {
    const bool is_thread = command.op() == path::Op::Thread;
    thread_goes_on = is_thread && is_threading && !last.must_stop;
    leaves_thread = is_threading && !is_thread;
    is_threading = is_thread;
    if (!is_thread || thread_goes_on || !spindle.is_turning) return;
    release();
    if (has_ended) return;
    last.must_stop = true;
    Piece& stand = emit_stand(command, SegmentKind::Wait);
    stand.awaits_mark = true;
    stand.mark = command.motion().thread().start_deg / 360;
}

/// No axis changes its velocity at once: where a chain of threads turns, the pitch goes down with
/// the speed. Behind the thread of a cycle that is its run-out.
void Preparer::State::check_thread_corner(const path::Command& command, const Piece& piece) {
    const double through = std::min(piece.entry_limit, last.speed);
    const double wanted = std::min(piece.speed, last.speed);
    if (command.cycle != 0 || through >= wanted * kThreadKept) return;
    if (!reported.first_time(PlanNotice::ThreadCorner)) return;
    report(sink, diag::ThreadCorner, command, options.locate_command)
        .arg(round_to(100 * through / wanted, 1))
        .fix("a slower spindle loses less; or let the thread run out before it turns");
}

void Preparer::State::emit_varying_thread(const path::Command& command, const Segment& whole,
                                          double length) {
    const double turns = spindle.speed_at(path::start(whole.curve)[0]);  // 1/s
    const VaryingPitch lead{command.motion().feed, command.motion().thread().pitch_change};
    path::Command share = command;
    const auto part_at = [&](double from, double to, double pitch) {
        share.motion().feed = pitch;
        emit(share, part_of(whole, from, to), to - from);
    };
    // Under a constant cutting speed no acceleration suits the path: many even pieces do.
    const auto parts = feed_bounds(command.motion(), whole, length, spindle);
    if (!parts.empty()) {
        for (std::size_t i = 0; i + 1 < parts.size() && !has_ended; ++i)
            part_at(parts[i], parts[i + 1], (lead.at(parts[i]) + lead.at(parts[i + 1])) / 2);
        return;
    }
    const double most = turns * std::max(lead.at(0), lead.at(length));
    const PathLimits limits = axes.limits(whole, axes.start_rates(whole), most);
    double begin = 0;
    double end = length;
    for (int i = 0; i < kRampSteps && most > 0; ++i) {
        begin = ramp_to(turns * lead.at(begin), limits);
        end = length - ramp_to(turns * lead.at(std::max(end, 0.0)), limits);
    }
    if (!(begin < end)) return emit(command, whole, length);
    part_at(0, begin, lead.at(begin));
    if (has_ended) return;
    part_at(begin, end, std::max(lead.at(begin), lead.at(end)));
    if (has_ended) return;
    Piece& geared = pieces.back(0);
    geared.is_geared = true;
    geared.acceleration =
        std::abs(command.motion().thread().pitch_change) * turns * turns * (1 + kGearSlack);
    geared.jerk = geared.turning_acceleration = std::numeric_limits<double>::infinity();
    part_at(end, length, lead.at(end));
}

}  // namespace kadr::motion
