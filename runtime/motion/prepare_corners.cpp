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

// How a corner and the ramps beside it share the acceleration of an axis (corner.h): the parts of
// their acceleration that ramps may keep at least, of which the quickest is taken. What is left at
// the speed that comes out is given back to the ramps.
constexpr double kSharedRamp = 0.5;  // half and half
constexpr double kMostRamp = 0.9;    // the jump has up to 42 % then
// … where ramps have so little within a tick of the corner alone.
constexpr double kZoneRamp = 0.02;
// A piece so many times as long as that beside a corner has its acceleration elsewhere.
constexpr double kZones = 4;
// Ramps that lack less are not worth pieces of their own.
constexpr double kWholeRamp = 0.98;
// Corners of equal distance below a tick weigh up to 1.125 times as much as their mean.
constexpr double kCrowding = 1.125;
// Between blocks that are shorter, mm (deg), a corner is never a stop: contours of short blocks
// shall run through, and a rest at every one of them shakes the machine; but where a curve is asked
// for and does not pay, one that is quicker is taken. Under a transformation neither beside one:
// axes need a distance to get up to their speed.
constexpr double kShortBlock = 1;
constexpr double kStraight = 1e-9;  // as in corner.cpp
// Halvings of a speed or a share: to a thousandth.
constexpr int kSpeedSteps = 10;
// A corner that could be passed so many times faster than the pieces beside it is none.
constexpr double kNoCorner = 1e4;

// Jumps of the curvature of equal distance below the width of the bell weigh up to 1.05 times as
// much as their mean.
constexpr double kBellCrowding = 1.05;

}  // namespace

double Preparer::State::corner_speed(const Segment& segment, const AxisRates& in,
                                     double acceleration) const {
    if (last.must_stop) return 0;
    if (segment.is_rotary_only != last.is_rotary_only) return 0;  // mm/s and deg/s do not meet
    const std::size_t n = axes.size();
    if (options.corner_rule == CornerRule::AxisJump || segment.is_rotary_only) {
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
/// the ramps makes the approach faster, what is left to the jump the corner: the quickest of a few
/// ways to share is taken, and the ramps get all that the jump leaves at its speed.
///
/// The setpoints see the ramps within a tick of the corner alone. Under a limit of the jerk the
/// acceleration vanishes where a stretch ends (stretch.h), so there it is no more than the jerk
/// makes of it in a tick; without one, a piece that is long enough has less on a short distance
/// only.
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
    const CornerShare share = quickest_share(piece);
    piece.entry_limit = share.speed;
    piece.rests_at_corner = share.speed == 0;
    if (piece.rests_at_corner) return;
    const double ramp = ramp_beside(piece, share);
    if (axes.limits_jerk()) {
        piece.entry_acceleration = ramp * std::min(last.acceleration, piece.acceleration);
        if (ends_smoothly(piece)) {
            if (share.is_alone) piece.smooth_corner_jerk = std::min(last.jerk, piece.jerk);
            return;
        }
    }
    piece.ramp = piece.ramp_before = ramp;
    if (!share.is_alone) piece.crowd_ramp = ramp;
    if (ramp >= kWholeRamp || !allows_zones(piece)) return;
    const double zone = corner_zone(piece, share.speed, ramp);
    const auto is_cut = [&](double length, bool can_be_cut) {
        return can_be_cut && length >= kZones * zone;
    };
    if (is_cut(piece.length, can_be_cut(piece.segment))) piece.corner_zone = zone;
    if (is_cut(last.length, last.can_be_cut)) piece.corner_zone_before = zone;
}

/// Of the ways to share, the one that takes the least time.
CornerShare Preparer::State::quickest_share(const Piece& piece) const {
    const double full = std::min(last.speed, piece.speed);
    CornerShare best{0, kSharedRamp, is_alone(piece)};
    const auto with = [&](double ramp, RampEnd end) {
        CornerShare other{0, ramp, best.is_alone, end};
        other.speed = shared_speed(piece, other);
        return other;
    };
    best.speed = shared_speed(piece, best);
    if (best.speed >= full) return best;  // no other one is quicker
    const bool is_smooth = best.is_alone && axes.limits_jerk() && ends_smoothly(piece);
    const CornerShare smooth = is_smooth ? with(0, RampEnd::Smooth) : best;
    const bool may_be_smooth = is_smooth && has_own_ramps(piece, std::min(smooth.speed, full));
    // The ramps have all, and the corner has more than beside any of them.
    if (may_be_smooth) best = smooth;
    double time = time_beside(piece, best);
    const auto take_if_quicker = [&](const CornerShare& other) {
        const double other_time = time_beside(piece, other);
        if (other_time >= time) return;
        time = other_time;
        best = other;
    };
    if (best.is_alone && !may_be_smooth) {
        take_if_quicker(with(kMostRamp, RampEnd::Whole));
        if (allows_zones(piece) && last.can_be_cut && can_be_cut(piece.segment)) {
            const CornerShare zoned = with(kZoneRamp, RampEnd::Zone);
            const double zone = corner_zone(piece, zoned.speed, kZoneRamp);
            if (std::min(last.length, piece.length) >= kZones * zone) take_if_quicker(zoned);
        }
    }
    const bool may_rest = piece.segment.is_transformed()
                              ? std::min(last.length, piece.length) >= kShortBlock
                              : stays_sharp || std::max(last.length, piece.length) >= kShortBlock ||
                                    burns_where_it_turns_back(piece);
    if (!may_rest) return best;
    const CornerShare rest{0, 1, best.is_alone, RampEnd::Whole};
    const double with_rest = time_beside(piece, rest);
    if (is_doubtful(piece)) {
        const double without_ramps = (last.length / last.speed + piece.length / piece.speed) / 2;
        if (time - without_ramps > kDoubtOfBends * (with_rest - without_ramps)) return rest;
    }
    const bool may_be_slower = time > kSurelyQuicker * with_rest;
    if (time > with_rest ||
        (may_be_slower && time_between_rests(piece, best) > time_between_rests(piece, rest)))
        best = rest;
    return best;
}

/// Whether limits that change with the speed are worth a doubt (kDoubtOfBends).
bool Preparer::State::is_doubtful(const Piece& piece) const {
    return axes.limits_jerk() && !piece.segment.is_transformed() &&
           (!last.can_be_cut || !can_be_cut(piece.segment));
}

/// Whether the beam burns a point at a corner that turns back: passing it is hardly faster than a
/// rest, and takes from the ramps of both blocks, which the pulses time whole.
bool Preparer::State::burns_where_it_turns_back(const Piece& piece) const {
    if (!has_pulses() || !burns_point || piece.segment.is_transformed()) return false;
    return last.direction.dot(path::evaluate(piece.segment.curve, 0).tangent) <= 0;
}

/// Whether both pieces are long enough for ramps of their own up to the speed of a corner. Many
/// that are not may lie on one ramp, whose acceleration must not vanish between them.
bool Preparer::State::has_own_ramps(const Piece& piece, double speed) const {
    const double reach = std::min(last.length, piece.length) / 2;
    const RampLimits ramp{std::min(last.acceleration, piece.acceleration),
                          std::min(last.jerk, piece.jerk)};
    return smooth_ramp_length(0, speed, ramp) <= reach;
}

/// Whether pieces may be cut beside a corner, so that they have less acceleration there alone. The
/// pulses of a laser time whole blocks that burn, and a thread has its pitch on all of its path.
bool Preparer::State::allows_zones(const Piece& piece) const {
    const bool is_timed = has_pulses() && burns_point;
    return !axes.limits_jerk() && !is_timed && !piece.segment.is_thread &&
           !piece.varying_feed.is_on() && std::isinf(last.exit_feed);
}

/// The distance beside a corner on which ramps have this part of their acceleration: that of a
/// tick; of two where the jump is less than the ramps, for then setpoints that see half of it see
/// most.
double Preparer::State::corner_zone(const Piece& piece, double speed, double ramp) const {
    const double time = (ramp > kSharedRamp ? 2 : 1) * tick;
    const double acceleration = ramp * std::max(last.acceleration, piece.acceleration);
    return time * (std::min({speed, last.speed, piece.speed}) + acceleration * time / 2);
}

/// Whether a ramp that ends without acceleration has little within a tick of its end.
bool Preparer::State::ends_smoothly(const Piece& piece) const {
    if (piece.varying_feed.is_on() || std::isfinite(last.exit_feed)) return false;
    return last.jerk * tick <= kSharedRamp * last.acceleration &&
           piece.jerk * tick <= kSharedRamp * piece.acceleration;
}

/// Time for the halves of both pieces beside a corner that is passed so.
double Preparer::State::time_beside(const Piece& piece, const CornerShare& share) const {
    const double zone =
        share.end == RampEnd::Zone ? corner_zone(piece, share.speed, share.ramp) : 0;
    const double ramp = share.end == RampEnd::Whole ? share.ramp : 1;
    const auto time_on = [&](double length, double most, const RampLimits& limits) {
        const double speed = std::min(share.speed, most);
        const double beside = zone > 0 ? zone / speed : 0;
        return beside +
               time_over(length / 2 - zone, speed, most, {ramp * limits.acceleration, limits.jerk});
    };
    return time_on(last.length, last.speed, {last.acceleration, last.jerk}) +
           time_on(piece.length, piece.speed, {piece.acceleration, piece.jerk});
}

/// … and for the whole of both if they begin and end at rest, where passing it is worth the least:
/// the slower a motion is anyway, the more a stop at its end costs.
double Preparer::State::time_between_rests(const Piece& piece, const CornerShare& share) const {
    const double zone =
        share.end == RampEnd::Zone ? corner_zone(piece, share.speed, share.ramp) : 0;
    const double near = share.end == RampEnd::Whole ? share.ramp : 1;
    const double far = allows_zones(piece) ? 1 : near;
    const ProfileLimits before{last.speed, far * last.acceleration, near * last.acceleration,
                               last.jerk};
    const ProfileLimits behind{piece.speed, far * piece.acceleration, near * piece.acceleration,
                               piece.jerk};
    const double speed =
        std::min({share.speed, last.speed, piece.speed,
                  speed_from_rest(last.length - zone, {before.acceleration, before.jerk}),
                  speed_from_rest(piece.length - zone, {behind.acceleration, behind.jerk})});
    return (zone > 0 ? 2 * zone / speed : 0) + time_from_rest(last.length - zone, speed, before) +
           time_from_rest(piece.length - zone, speed, behind);
}

/// Whether no other corner comes within two ticks.
bool Preparer::State::is_alone(const Piece& piece) const {
    const double full = std::min({piece.entry_limit, last.speed, piece.speed});
    const double gain = tick * std::max(last.acceleration, piece.acceleration);
    return std::min(last.length, piece.length) >= 2 * tick * (full + gain);
}

/// The accelerations along the path on both sides within a tick of the corner.
SidesOfCorner Preparer::State::sides_of(const Piece& piece, const CornerShare& share) const {
    if (share.end != RampEnd::Smooth)
        return {share.ramp * last.acceleration, share.ramp * piece.acceleration};
    return {std::min(last.acceleration, last.jerk * tick),
            std::min(piece.acceleration, piece.jerk * tick)};
}

/// What an axis has on both sides of the corner at these accelerations, in parts of its limits:
/// within a tick the speed may still rise, and what turning takes with it.
SidesOfCorner Preparer::State::loads_beside(const Piece& piece, std::size_t axis, double speed,
                                            const SidesOfCorner& along) const {
    const double part = last.dynamics.acceleration[index(machine.axes[axis].axis)];
    const double before = std::min(last.speed, speed + tick * along.before);
    const double behind = std::min(piece.speed, speed + tick * along.behind);
    return {last.loads.at(axis, before, along.before) / (machine_axes.acceleration(axis) * part),
            piece.loads.at(axis, behind, along.behind) / axes.acceleration(axis)};
}

/// The speed of the corner if the ramps on both sides have their share.
double Preparer::State::shared_speed(const Piece& piece, const CornerShare& share) const {
    const SidesOfCorner along = sides_of(piece, share);
    const double full = std::min({piece.entry_limit, last.speed, piece.speed});
    double low = shared_speed_at(piece, share, along, full);
    const bool is_bent = last.is_bent || !is_straight(piece.segment);
    if (low >= full || !is_bent || !share.is_alone) return low;
    // Turning takes less of the axes at the speed of the corner than at that of the pieces.
    double high = full;
    for (int i = 0; i < kSpeedSteps; ++i) {
        const double middle = (low + high) / 2;
        (shared_speed_at(piece, share, along, middle) >= middle ? low : high) = middle;
    }
    return low;
}

/// … while turning takes what it does at the speed `at`.
double Preparer::State::shared_speed_at(const Piece& piece, const CornerShare& share,
                                        const SidesOfCorner& along, double at) const {
    const double reach = std::min(last.length, piece.length);
    const double gain = tick * std::max(last.acceleration, piece.acceleration);
    double speed = piece.entry_limit;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const double change = std::abs(piece.rates[i] - last.rates[i]);
        if (change < kStraight) continue;
        const double limit = acceleration_at_corner(i);
        const SidesOfCorner loads = loads_beside(piece, i, at, along);
        const double part =
            jump_share(loads.before, loads.behind, share.is_alone, most_at_corner(i));
        speed = std::min(speed, part * limit * tick / change);
        if (share.is_alone) continue;
        // v·(v + gain) = most: between this corner and the next the speed may still rise.
        const double most = part * limit * reach / (kCrowding * change);
        speed = std::min(speed, std::sqrt(gain * gain / 4 + most) - gain / 2);
    }
    return speed;
}

/// The part of their acceleration that the ramps beside a corner keep, which is passed at this
/// speed at most.
double Preparer::State::ramp_beside(const Piece& piece, const CornerShare& share) const {
    const double speed = std::min({share.speed, last.speed, piece.speed});
    const double least = share.end == RampEnd::Smooth ? 0 : share.ramp;
    const bool is_bent = last.is_bent || !is_straight(piece.segment);
    double ramp = 1;
    for (std::size_t i = 0; i < axes.size() && ramp > least; ++i) {
        const double change = std::abs(piece.rates[i] - last.rates[i]);
        if (change < kStraight) continue;
        const double most = most_at_corner(i);
        const double jumped = share.is_alone ? change * speed / (acceleration_at_corner(i) * tick)
                                             : crowded_jump(piece, i, speed);
        const auto loads_at = [&](double part) {
            return loads_beside(piece, i, speed,
                                {part * last.acceleration, part * piece.acceleration});
        };
        if (!is_bent && share.is_alone) {
            const SidesOfCorner loads = loads_at(1);
            ramp = std::min(ramp, ramp_share(loads.before, loads.behind, jumped, most));
            continue;
        }
        // Between corners that are so near the ramps have it on other axes as well.
        if (!share.is_alone) ramp = std::min(ramp, most - jumped);
        const auto leaves_enough = [&](double part) {
            const SidesOfCorner loads = loads_at(part);
            if (share.is_alone)
                return corner_acceleration(loads.before, loads.behind, jumped) <= most;
            return std::max(loads.before, loads.behind) + jumped <= most;
        };
        if (!is_bent || leaves_enough(ramp)) continue;
        double low = least;
        for (int k = 0; k < kSpeedSteps && low < ramp; ++k) {
            const double middle = (low + ramp) / 2;
            (leaves_enough(middle) ? low : ramp) = middle;
        }
        ramp = low;
    }
    return std::max(ramp, least);
}

/// The jumps of an axis that come together at corners that lie within two ticks of each other, in
/// parts of what it may change its velocity by in a tick.
double Preparer::State::crowded_jump(const Piece& piece, std::size_t axis, double speed) const {
    const double change = std::abs(piece.rates[axis] - last.rates[axis]);
    const double reach = std::min(last.length, piece.length);
    const double gain = tick * std::max(last.acceleration, piece.acceleration);
    const double near = std::max(1 / tick, kCrowding * (speed + gain) / reach);
    return change * speed * near / acceleration_at_corner(axis);
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
    double change = 0;  // of d²q/ds², in parts of the axis' jerk …
    double braked = 0;  // … and of the jerk that its jump of the acceleration stands for
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const double bent = std::abs(bends[i] - last.bends[i]);
        change = std::max(change, bent / jerk_at_corner(i));
        braked = std::max(braked, bent / jerk_of_bend(i));
    }
    const double speed = std::min({piece.entry_limit, last.speed, piece.speed});
    const double reach = std::min(last.length, piece.length);
    const bool is_alone = reach >= kJumpBellTicks * tick * speed;
    const double weight = is_alone ? 1 : kBellCrowding;
    const double bell = kJumpBell / tick;
    const auto taken = [&](double part, double v) {
        return weight * part * v * v * (is_alone ? bell : std::max(bell, v / reach));
    };
    if (taken(change, speed) < kStraight && taken(braked, speed) <= kMostJump) return;
    double passed = speed;
    if (taken(braked, speed) > kMostJump) {
        const double most = kMostJump / (weight * braked);
        const double alone = std::sqrt(most / bell);
        passed = is_alone ? alone : std::min(alone, std::cbrt(most * reach));
        piece.entry_limit = passed;
    }
    const double share = 1 - std::min(taken(change, passed), kMostJump);
    if (rests_at_bend(piece, passed, share)) {
        piece.entry_limit = 0;
        piece.rests_at_corner = true;
        return;
    }
    piece.jerk_share = piece.jerk_before = share;
    piece.jerk *= piece.jerk_share;
    piece.acceleration =
        std::min(piece.acceleration, piece.turning_acceleration * piece.jerk_share);
}

/// Whether a rest where the curvature jumps is quicker than to pass it at this speed: what turns
/// with the jump takes from the jerk, and so from the ramps of both pieces.
bool Preparer::State::rests_at_bend(const Piece& piece, double passed, double share) const {
    if (piece.varying_feed.is_on() || std::isfinite(last.exit_feed) || piece.segment.is_thread)
        return false;
    if (std::max(last.length, piece.length) < kShortBlock) return false;
    const auto ramp_of = [](const auto& beside, double part) {
        return RampLimits{std::min(beside.acceleration, part * beside.turning_acceleration),
                          part * beside.jerk};
    };
    const auto half = [&](const auto& beside, double speed, double part) {
        return time_over(beside.length / 2, std::min(speed, beside.speed), beside.speed,
                         ramp_of(beside, part));
    };
    const double stopped = half(last, 0, 1) + half(piece, 0, 1);
    const double through = half(last, passed, share) + half(piece, passed, share);
    if (through > stopped) return true;
    // Where the path behind ends at rest, what the ramps lack counts the most. Both meet at one
    // speed, and a stop has to be reached from that at the other end.
    const auto time_on = [&](const auto& beside, const SidesOfCorner& speeds, double part) {
        const RampLimits ramp = ramp_of(beside, part);
        const double from = std::min(
            {speeds.before, beside.speed, smooth_reach(speeds.behind, beside.length, ramp)});
        const auto profile =
            seven_phases(beside.length, from, speeds.behind,
                         {beside.speed, ramp.acceleration, ramp.acceleration, ramp.jerk});
        return profile ? profile->duration() : kInfinity;
    };
    const double reached =
        std::min({passed, smooth_reach(last.entry_speed, last.length, ramp_of(last, share)),
                  smooth_reach(0, piece.length, ramp_of(piece, share))});
    return time_on(last, {last.entry_speed, reached}, share) + time_on(piece, {0, reached}, share) >
           time_on(last, {last.entry_speed, 0}, 1) + time_on(piece, {0, 0}, 1);
}

/// At most so fast the corner before a piece can be reached: from the last rest on, by what is
/// behind. Jerk counts beside what is bent, where somebody asks (rests_at_bend).
double Preparer::State::reached_before(const Piece& piece) const {
    if (!axes.limits_jerk()) return 0;
    const double most = std::min({piece.entry_limit, last.speed, piece.speed});
    const double square = last.entry_speed * last.entry_speed + 2 * last.acceleration * last.length;
    const bool is_bent = last.is_bent || !is_straight(piece.segment);
    if (!is_bent || most == 0) return std::min(most, std::sqrt(square));
    const double jerk = last.jerk * piece.jerk_before;
    return std::min(most, smooth_reach(last.entry_speed, last.length, {last.acceleration, jerk}));
}

void Preparer::State::remember(const Piece& piece) {
    const Segment& segment = piece.segment;
    last.entry_speed = reached_before(piece);
    last.is_bent = !is_straight(segment);
    last.can_be_cut = can_be_cut(segment);
    stays_sharp = false;
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
    last.acceleration = piece.acceleration;
    last.jerk = piece.jerk;
    last.turning_acceleration = piece.turning_acceleration;
    last.is_rotary_only = segment.is_rotary_only;
    last.must_stop = false;
    last.exit_feed = std::numeric_limits<double>::infinity();
    last.feed_slope = 0;
    if (piece.varying_feed.is_on()) {
        last.exit_feed = piece.varying_feed.exit();
        last.feed_slope = piece.varying_feed.slope(piece.length) / last.exit_feed;
    }
}

}  // namespace kadr::motion
