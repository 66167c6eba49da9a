#include "motion/loss_trace.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/axis_shares.h"

namespace kadr::motion {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Two speeds are the same, relative: far below what a person would call slower.
constexpr double kSame = 1e-6;
// A loss below is rounding, s.
constexpr double kNoTime = 1e-9;
// A ramp over more pieces is reported as if it ended at rest: memory stays bounded.
constexpr std::size_t kMostBraking = 1 << 16;

bool reaches(double speed, double limit) { return speed >= limit * (1 - kSame); }

}  // namespace

void LossTrace::add(const Piece& piece, double feed_override) {
    if (!report_) return;
    if (!is_motion(piece.segment.kind) || !(piece.length > 0)) {
        settle(LossReason::Stop);
        up_ = LossReason::Stop;
        last_speed_ = 0;
        return;
    }
    const double wanted = asked(piece, feed_override);
    const Inside inside = limit_inside(piece, wanted);
    pass_junction(piece, inside.speed);
    const Ramps ramps = ramps_of(piece, inside.speed);
    report(piece, inside.reason, piece.length / inside.speed - piece.length / wanted);
    report(piece, LossReason::Jerk, ramps.jerk);
    report(piece, up_, ramps.up);
    if (ramps.down > kNoTime) {
        const Segment& segment = piece.segment;
        braking_.push_back(
            {LossReason::Stop, segment.line, segment.source, ramps.down, segment.start_time});
        if (braking_.size() > kMostBraking) settle(LossReason::Stop);
    }
    last_speed_ = inside.speed;
}

/// The path speed that the program asks for.
double LossTrace::asked(const Piece& piece, double feed_override) const {
    const Segment& segment = piece.segment;
    double feed = segment.feed;
    // What the machine's own greatest feed cut off is a loss, too.
    const bool is_cut = segment.kind == SegmentKind::Feed && machine_.max_feed > 0 &&
                        !segment.is_rotary_only && reaches(feed, machine_.max_feed);
    if (is_cut) feed = std::max(feed, piece.programmed * feed_override);
    return AxisTable::path_speed(segment, feed);
}

LossTrace::Inside LossTrace::limit_inside(const Piece& piece, double asked) const {
    Inside inside{piece.is_cell ? piece.cell.speed : piece.speed, LossReason::AxisVelocity};
    if (piece.is_cell && bend_speed(piece.cell) < inside.speed)
        inside = {bend_speed(piece.cell), LossReason::Curvature};
    if (reaches(inside.speed, asked)) return {asked, inside.reason};
    // Between the ends of a cell the path may be faster than both of them allow.
    inside.speed = std::min(asked, std::max(inside.speed, piece.segment.profile.peak_speed));
    if (!piece.is_cell) inside.reason = reason_of(piece, inside.speed);
    return inside;
}

/// What is nearest to its limit at this speed.
LossReason LossTrace::reason_of(const Piece& piece, double speed) const {
    const double own = AxisTable::path_speed(piece.segment, machine_.max_feed);
    if (machine_.max_feed > 0 && piece.segment.kind == SegmentKind::Feed && reaches(speed, own))
        return LossReason::MachineFeed;
    const bool is_glide = std::holds_alternative<path::Glide>(piece.segment.curve);
    const double steady = is_glide ? kSteadyJerkOfGlide : kSteadyJerk;
    double velocity = 0;
    double bend = 0;
    double jerk = 0;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const AxisTable::Loads& loads = piece.loads;
        velocity = std::max(
            velocity, (loads.turning[i] + loads.rising[i]) * speed / machine_.axes[i].velocity);
        bend =
            std::max(bend, loads.bend[i] * speed * speed / (kNormalShare * axes_.acceleration(i)));
        jerk = std::max(jerk, loads.third[i] * speed * speed * speed / (steady * axes_.jerk(i)));
    }
    if (velocity >= bend && velocity >= jerk) return LossReason::AxisVelocity;
    return bend >= jerk ? LossReason::Curvature : LossReason::CurveJerk;
}

/// At which the bend alone takes all that an axis has at an end of a cell.
double LossTrace::bend_speed(const BentCell& cell) const {
    const double across = std::ranges::max(greatest_load(cell, 0, 1));
    return across > 0 ? 1 / std::sqrt(across) : kInfinity;
}

/// What the ramps of a piece take longer than its own speed.
LossTrace::Ramps LossTrace::ramps_of(const Piece& piece, double speed) {
    const Profile& profile = piece.segment.profile;
    Ramps ramps;
    if (profile.has_varying_feed()) {
        const double loss = profile.duration() - profile.rate->varying_feed.time;
        (profile.rate->exit > profile.rate->entry ? ramps.up : ramps.down) = loss;
        return ramps;
    }
    // A part of the path on which the speed goes from one value to another.
    const auto change = [&](double from, double to, double time, double distance) {
        double loss = time - distance / speed;
        if (profile.is_smooth) {
            // At constant acceleration this change takes less time, and leaves distance for the
            // speed.
            const double least = std::abs(to - from) / piece.acceleration;
            const double left = distance - 0.5 * (from + to) * least;
            const double more = time - least - std::max(0.0, left) / speed;
            ramps.jerk += std::clamp(more, 0.0, std::max(0.0, loss));
            loss -= std::clamp(more, 0.0, std::max(0.0, loss));
        }
        (to > from ? ramps.up : ramps.down) += loss;
    };
    if (!profile.is_smooth) {
        const double top = profile.peak_speed;
        const auto ramp_distance = [](double from, double to, double time) {
            return 0.5 * (from + to) * time;
        };
        change(profile.entry_speed, top, profile.accelerating,
               ramp_distance(profile.entry_speed, top, profile.accelerating));
        change(top, top, profile.cruising, top * profile.cruising);
        change(top, profile.exit_speed, profile.braking,
               ramp_distance(top, profile.exit_speed, profile.braking));
        return ramps;
    }
    // Phases of one direction go together: only from end to end of a ramp is the jerk reported.
    ProfileState at{0, profile.entry_speed, 0};
    ProfileState begin = at;
    double time = 0;
    int direction = 0;
    const auto close = [&] {
        if (time > 0) change(begin.speed, at.speed, time, at.distance - begin.distance);
        begin = at;
        time = 0;
    };
    for_each_phase(profile, [&](const Phase& phase) {
        const double middle = phase.acceleration + 0.5 * phase.jerk * phase.duration;
        const int now = middle > 0 ? 1 : middle < 0 ? -1 : 0;
        if (now != direction) close();
        direction = now;
        at = advanced(at, phase, phase.duration);
        time += phase.duration;
        return true;
    });
    close();
    return ramps;
}

/// What the point between the piece before and this one means for the ramps beside it.
void LossTrace::pass_junction(const Piece& piece, double speed) {
    const double entry = piece.segment.profile.entry_speed;
    if (entry == 0) {
        up_ = piece.rests_at_corner ? LossReason::Corner : LossReason::Stop;
        settle(up_);
        return;
    }
    const double beside = std::min(last_speed_, speed);
    if (piece.entry_limit < beside * (1 - kSame) && reaches(entry, piece.entry_limit)) {
        settle(LossReason::Corner);
        up_ = LossReason::Corner;
        return;
    }
    if (reaches(entry, beside)) {
        settle(LossReason::SlowerPiece);
        up_ = LossReason::SlowerPiece;
    }
}

/// The slow point that the path was braked for.
void LossTrace::settle(LossReason reason) {
    for (SpeedLoss& loss : braking_) {
        loss.reason = reason;
        report_(loss);
    }
    braking_.clear();
}

void LossTrace::report(const Piece& piece, LossReason reason, double time) const {
    if (!(time > kNoTime)) return;
    report_({reason, piece.segment.line, piece.segment.source, time, piece.segment.start_time});
}

}  // namespace kadr::motion
