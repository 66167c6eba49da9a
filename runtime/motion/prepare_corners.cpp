// How fast the corner between two pieces of path may be passed.
#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/prepare_state.h"
#include "motion/smooth_profile.h"

namespace kadr::motion {

namespace {

using path::Vec3;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// How a corner and the ramps beside it share the acceleration of an axis (corner.h).
constexpr double kMostRamp = 0.9;    // the jump has up to 42 % then
constexpr double kSharedRamp = 0.5;  // half and half
// Corners of equal distance below a tick weigh up to 1.125 times as much as their mean.
constexpr double kCrowding = 1.125;
// Between blocks that are shorter, mm (deg), a corner is never a stop: contours of short blocks
// shall run through, and a rest at every one of them shakes the machine. Under a transformation
// neither beside one: axes need a way to get up to their speed.
constexpr double kShortBlock = 1;
constexpr double kStraight = 1e-9;  // as in corner.cpp
// A corner that could be passed so many times faster than the pieces beside it is none.
constexpr double kNoCorner = 1e4;

// Jumps of the curvature of equal distance below the width of the bell weigh up to 1.05 times as
// much as their mean.
constexpr double kBellCrowding = 1.05;
constexpr double kMostJump = 0.5;  // part of an axis' jerk that a jump of the curvature may take

}  // namespace

double Preparer::State::corner_speed(const Segment& segment, const AxisRates& in,
                                     double acceleration) const {
    if (last.must_stop) return 0;
    if (segment.turns_only != last.turns_only) return 0;  // mm/s and deg/s do not meet
    const std::size_t n = axes.size();
    if (options.corner_rule == CornerRule::AxisJump || segment.turns_only) {
        return axis_jump_speed({last.rates.data(), n}, {in.data(), n}, {jump.data(), n});
    }
    // The rule knows directions in space; axes beside X Y Z keep to the jump.
    double speed = kInfinity;
    for (std::size_t i = 0; i < n; ++i) {
        if (index(machine.axes[i].axis) < 3) continue;
        speed = std::min(speed, axis_jump_speed({&last.rates[i], 1}, {&in[i], 1}, {&jump[i], 1}));
    }
    const Vec3 direction = path::evaluate(segment.curve, 0).tangent.normalized();
    return std::min(speed,
                    junction_deviation_speed(last.direction, direction, options.junction_deviation,
                                             std::min(acceleration, last.acceleration)));
}

/// The speed at which a corner may be taken, beside the ramps on both sides of it. What is left to
/// the ramps makes the approach faster, what is left to the jump the corner: the quicker of two
/// ways to share is taken.
void Preparer::State::take_corner(Piece& piece) const {
    if (piece.entry_limit > kNoCorner * std::min(last.speed, piece.speed))
        piece.entry_limit = kInfinity;
    const bool is_jump_given =
        std::ranges::any_of(options.velocity_jump, [](double given) { return given > 0; });
    const bool is_free = options.corner_rule != CornerRule::AxisJump || is_jump_given ||
                         piece.entry_limit == 0 || std::isinf(piece.entry_limit);
    if (is_free) return;
    // Whatever the ramp at the end of a thread lacks would be taken from its pitch.
    if (leaves_thread) {
        piece.entry_limit = 0;
        piece.rests_at_corner = true;
        return;
    }
    const bool alone = is_alone(piece);
    double ramp = kSharedRamp;
    double speed = shared_speed(piece, alone, kSharedRamp);
    double time = time_beside(piece, speed, ramp);
    const auto take_if_quicker = [&](double other_speed, double other_ramp) {
        const double other = time_beside(piece, other_speed, other_ramp);
        if (other >= time) return;
        time = other;
        speed = other_speed;
        ramp = other_ramp;
    };
    if (alone) take_if_quicker(shared_speed(piece, alone, kMostRamp), kMostRamp);
    const bool may_rest = piece.segment.is_transformed()
                              ? std::min(last.length, piece.length) >= kShortBlock
                              : std::max(last.length, piece.length) >= kShortBlock;
    if (may_rest) take_if_quicker(0, 1);
    piece.entry_limit = speed;
    piece.rests_at_corner = speed == 0;
    piece.ramp = piece.ramp_before = ramp;
    piece.acceleration *= ramp;
}

/// Time for the halves of both pieces beside a corner that is passed at this speed.
double Preparer::State::time_beside(const Piece& piece, double speed, double ramp) const {
    const double before = time_over(last.length / 2, std::min(speed, last.speed), last.speed,
                                    {ramp * last.acceleration, last.jerk});
    return before + time_over(piece.length / 2, std::min(speed, piece.speed), piece.speed,
                              {ramp * piece.acceleration, piece.jerk});
}

/// Whether no other corner comes within two ticks.
bool Preparer::State::is_alone(const Piece& piece) const {
    const double full = std::min({piece.entry_limit, last.speed, piece.speed});
    const double gain = tick * std::max(last.acceleration, piece.acceleration);
    return std::min(last.length, piece.length) >= 2 * tick * (full + gain);
}

/// … if the pieces on both sides use the part `ramp` of their acceleration.
double Preparer::State::shared_speed(const Piece& piece, bool alone, double ramp) const {
    const double full = std::min({piece.entry_limit, last.speed, piece.speed});
    const double reach = std::min(last.length, piece.length);
    const double gain = tick * std::max(last.acceleration, piece.acceleration);
    double speed = piece.entry_limit;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const double change = std::abs(piece.rates[i] - last.rates[i]);
        if (change < kStraight) continue;
        const double limit = acceleration_at_corner(i);
        const double before = last.loads.at(i, full, ramp * last.acceleration) /
                              (machine_axes.acceleration(i) *
                               last.dynamics.acceleration[index(machine.axes[i].axis)]);
        const double behind =
            piece.loads.at(i, full, ramp * piece.acceleration) / axes.acceleration(i);
        const double share = jump_share(before, behind, alone);
        speed = std::min(speed, share * jump[i] / change);
        if (alone) continue;
        // v·(v + gain) = most: between this corner and the next the speed may still rise.
        const double most = share * limit * reach / (kCrowding * change);
        speed = std::min(speed, std::sqrt(gain * gain / 4 + most) - gain / 2);
    }
    return speed;
}

/// With how much acceleration along the path the corner may be passed.
double Preparer::State::corner_acceleration_limit(const AxisRates& in) const {
    double most = kInfinity;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const double change = std::abs(in[i] - last.rates[i]);
        if (change > kStraight) most = std::min(most, jerk_at_corner(i) * tick / change);
    }
    return most;
}

/// Where the curvature jumps, as between a line and an arc, the acceleration of the axes does at
/// any speed: from tick to tick that is a jerk. The jump gets a share of what the axes have, as
/// little as its speed needs and half at most; the pieces beside it keep the rest.
void Preparer::State::take_bend(Piece& piece) const {
    if (piece.entry_limit == 0) return;
    const bool is_bent = !is_straight(piece.segment);
    if (!is_bent && !last.is_bent) return;
    const AxisRates bends = is_bent ? axes.start_bends(piece.segment) : AxisRates{};
    double change = 0;  // of d²q/ds², in parts of the axis' jerk
    for (std::size_t i = 0; i < axes.size(); ++i) {
        change = std::max(change, std::abs(bends[i] - last.bends[i]) / jerk_at_corner(i));
    }
    const double speed = std::min({piece.entry_limit, last.speed, piece.speed});
    const double reach = std::min(last.length, piece.length);
    const bool is_alone = reach >= kJumpBellTicks * tick * speed;
    const double weight = (is_alone ? 1 : kBellCrowding) * change;
    const double bell = kJumpBell / tick;
    const double full = weight * speed * speed * (is_alone ? bell : std::max(bell, speed / reach));
    if (full < kStraight) return;
    if (full > kMostJump) {
        const double most = kMostJump / weight;
        const double alone = std::sqrt(most / bell);
        piece.entry_limit = is_alone ? alone : std::min(alone, std::cbrt(most * reach));
    }
    piece.jerk_share = piece.jerk_before = 1 - std::min(full, kMostJump);
    piece.jerk *= piece.jerk_share;
    piece.acceleration =
        std::min(piece.acceleration, piece.turning_acceleration * piece.jerk_share);
}

void Preparer::State::remember(const Piece& piece) {
    const Segment& segment = piece.segment;
    last.is_bent = !is_straight(segment);
    last.rates = last.is_bent ? axes.end_rates(segment) : piece.rates;
    if (axes.limits_jerk()) last.bends = last.is_bent ? axes.end_bends(segment) : AxisRates{};
    if (options.corner_rule == CornerRule::JunctionDeviation) {
        last.direction =
            path::evaluate(segment.curve, path::length(segment.curve)).tangent.normalized();
    }
    last.loads = piece.loads;
    if (!(is_plain && last.is_plain) && last.dynamics != dynamics) {
        last.dynamics = dynamics;
        last.is_plain = is_plain;
        set_jumps();
    }
    last.length = piece.length;
    last.speed = piece.speed;
    last.acceleration = piece.acceleration / piece.ramp;
    last.jerk = piece.jerk;
    last.turns_only = segment.turns_only;
    last.must_stop = false;
    last.exit_feed = std::numeric_limits<double>::infinity();
    last.feed_slope = 0;
    if (piece.course.is_on()) {
        last.exit_feed = piece.course.exit();
        last.feed_slope = piece.course.slope(piece.length) / last.exit_feed;
    }
}

}  // namespace kadr::motion
