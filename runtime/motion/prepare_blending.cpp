// Corner blending: a motion behind which the program lets the control blend the corner waits for
// the next one, and the curve around the corner takes the place of the end of one and of the
// beginning of the other, unless the corner as it is takes less time. Its first half belongs to the
// motion before, with its feed and its line of the text, its second half to the one behind.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "motion/corner_blend.h"
#include "motion/feed.h"
#include "motion/orientation_corner.h"
#include "motion/prepare_state.h"
#include "motion/smooth_profile.h"

namespace kadr::motion {

namespace {

using path::Command;
using path::Op;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Times and speeds that differ by less are the same where the tool alone is led around a corner,
/// which the program asks for by itself: it is done where it costs nothing.
constexpr double kAsQuick = 1.001;

/// Of two motions the longer one is at most so many times as long as the shorter one where halves
/// of the shorter one tell enough of both.
constexpr double kEven = 2;

/// Under a limit of the jerk a curve and what is beside it may become one stretch, which costs up
/// to this part of the ramp to its speed (stretch.h).
constexpr double kGathering = 0.1;

double gathering(double from, double to, const RampLimits& ramp) {
    return std::isfinite(ramp.jerk) ? kGathering * smooth_ramp_time(from, to, ramp) : 0;
}

/// A curve around a corner, and the corner as it is.
struct Alternative {
    double distance = 0;  // mm of the curve on either side
    double on_curve = 0;  // speed there
    CornerPassage corner;
    std::array<double, 2> lengths{};  // of both motions, mm
    std::array<PathLimits, 2> limits;
    /// Where the tip keeps its corner in the middle of the curve, the speed there.
    double in_middle = kInfinity;
    /// Of the tool alone: the program asks for it by itself.
    bool is_asked = false;
    bool is_doubtful = false;  // by kDoubtOfBends, for one of both motions

    /// Whether nothing is lost but on ramps beside a corner that the tip has anyway.
    bool is_as_fast() const {
        return is_asked && on_curve >= std::min(limits[0].speed, limits[1].speed) / kAsQuick;
    }
    /// It has to take less than so many times the time of the corner …
    double allowed() const { return is_as_fast() ? kAsQuick : 1; }
    /// … which takes `time` on so much of the paths on both sides of it.
    double allowed_for(double time, const std::array<double, 2>& distances) const {
        if (!is_doubtful) return allowed() * time;
        const double without_ramps =
            distances[0] / limits[0].speed + distances[1] / limits[1].speed;
        return without_ramps + kDoubtOfBends * (time - without_ramps);
    }
    /// What gathering may cost a ramp from the corner.
    double gathering_from(double corner_speed, double to, const RampLimits& ramp) const {
        const bool ramps_anyway = std::isfinite(in_middle) && is_as_fast();
        return ramps_anyway ? 0 : gathering(std::min(corner_speed, to), to, ramp);
    }
    /// Over one side of the curve, which is left at a speed.
    double time_on_curve(double speed, const RampLimits& ramp) const {
        return in_middle < speed ? time_over(distance, in_middle, speed, ramp) : distance / speed;
    }
};

/// Whether the curve takes less time than a stop where the motions begin and end at rest: there it
/// is worth the least, for the slower a motion is anyway, the more a stop at its end costs.
bool is_quicker_between_rests(const Alternative& curve) {
    double speed = curve.on_curve;
    for (std::size_t i = 0; i < 2; ++i) {
        const PathLimits& limits = curve.limits[i];
        speed = std::min(speed, speed_from_rest(curve.lengths[i] - curve.distance,
                                                {limits.acceleration, limits.jerk}));
    }
    double on_curve = 0;
    double with_stop = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        const PathLimits& limits = curve.limits[i];
        const RampLimits ramp{limits.acceleration, limits.jerk};
        const ProfileLimits most{limits.speed, limits.acceleration, limits.acceleration,
                                 limits.jerk};
        const double length = curve.lengths[i];
        on_curve += curve.time_on_curve(speed, ramp) +
                    time_from_rest(length - curve.distance, speed, most) +
                    curve.gathering_from(0, speed, ramp);
        with_stop += time_from_rest(length, 0, most);
    }
    return on_curve < curve.allowed_for(with_stop, curve.lengths);
}

/// Whether the curve takes less time than the corner, which may be passed or be a stop, whatever
/// becomes of it when its pieces are planned. Ramps end in the middles of both motions; beside a
/// short one that tells little of the long one, so both are looked at from rest to rest as well.
bool saves_time(const Alternative& curve) {
    const double half = std::min(curve.lengths[0], curve.lengths[1]) / 2;
    double on_curve = 0;
    double from_corner = 0;  // what gathering may cost, beside the corner as it is …
    double from_stop = 0;    // … and beside a stop
    double through_corner = 0;
    double with_stop = 0;
    for (const PathLimits& limits : curve.limits) {
        RampLimits ramp{limits.acceleration, limits.jerk};
        on_curve += curve.time_on_curve(curve.on_curve, ramp) +
                    time_over(half - curve.distance, curve.on_curve, limits.speed, ramp);
        from_corner += curve.gathering_from(curve.corner.speed, curve.on_curve, ramp);
        from_stop += curve.gathering_from(0, curve.on_curve, ramp);
        with_stop += time_over(half, 0, limits.speed, ramp);
        ramp.acceleration *= curve.corner.ramp;
        ramp.jerk *= curve.corner.jerk_share;
        through_corner += time_over(half, curve.corner.speed, limits.speed, ramp);
    }
    // Gathering costs less than the pieces take by themselves.
    from_corner = std::min(from_corner, on_curve);
    from_stop = std::min(from_stop, on_curve);
    if (on_curve + from_corner >= curve.allowed_for(through_corner, {half, half}) ||
        on_curve + from_stop >= curve.allowed_for(with_stop, {half, half}))
        return false;
    const bool is_even = std::max(curve.lengths[0], curve.lengths[1]) <= kEven * 2 * half;
    return (is_even && !curve.is_doubtful && on_curve + from_stop < kSurelyQuicker * with_stop) ||
           is_quicker_between_rests(curve);
}

constexpr bool is_blended(Op op) {
    return op == Op::Rapid || op == Op::Line || op == Op::Arc || op == Op::Spline ||
           op == Op::Involute || op == Op::Parametric;
}

}  // namespace

/// The path speed that the program asks for; nothing if it cannot be known, which is reported when
/// the motion becomes pieces. Without the operator's override: the path does not depend on it.
std::optional<double> Preparer::State::feed_of(const Command& command, const Segment& segment,
                                               double length) const {
    if (command.op() == Op::Rapid) return kInfinity;
    const auto feed = path_feed(command.motion(), segment, length, spindle, &axes);
    if (!feed) return std::nullopt;
    return *feed * programmed_override(command);
}

/// Whether there can be a curve before or behind a motion. Axes beside X, Y, Z have no curve but
/// those that orient the tool, and the pulses of a laser burn the programmed points.
bool Preparer::State::can_be_blended(const Command& command, const Segment& segment,
                                     const EndState& arrival) const {
    if (!is_blended(command.op()) || has_pulses() || segment.is_rotary_only) return false;
    const bool is_free =
        segment.is_transformed() ? is_one_way(segment, arrival.joints) : segment.followers == 0;
    return is_free && feed_of(command, segment, arrival.length).has_value();
}

/// Keeps a motion until the next one is known; false if nothing is asked for behind it.
bool Preparer::State::hold(const Command& command, const Segment& segment, const EndState& arrival,
                           double from) {
    const path::Blending& wish = command.motion().blending;
    const bool rounds = wish.kind != path::BlendKind::None && wish.size > 0;
    const bool smooths = wish.smooths_orientation && segment.is_transformed();
    if (command.motion().exact_stop || !(rounds || smooths)) return false;
    if (!can_be_blended(command, segment, arrival)) return false;
    held.is_held = true;
    held.command = command;
    held.segment = segment;
    held.length = arrival.length;
    held.from = from;
    return true;
}

/// The motion that waits goes on as it is.
void Preparer::State::release() {
    if (!held.is_held) return;
    held.is_held = false;
    emit_rest(held.command, held.segment, held.length, held.from);
}

/// The same; the corner behind it was to be blended, and no curve pays.
void Preparer::State::keep_sharp() {
    release();
    stays_sharp = true;
}

/// A motion from a point on its path on.
void Preparer::State::emit_rest(const Command& command, const Segment& whole, double length,
                                double from) {
    if (whole.is_transformed()) {
        if (has_law(command)) begin_law(from, length);
        emit_path(command, OrientationPath(axes.chain(), whole).part(from, length), length);
    } else {
        emit_part(command, whole, length, {from, length});
    }
    end_command();
}

/// The motion that waits goes on, and the curve around the corner behind it if there is one.
/// Returns how much of the next motion the curve has taken.
double Preparer::State::round_corner(const Command& command, const Segment& segment,
                                     const EndState& arrival) {
    if (!held.is_held) return 0;
    const double length = arrival.length;
    const bool is_transformed = segment.is_transformed();
    if (!can_be_blended(command, segment, arrival) ||
        held.segment.is_transformed() != is_transformed ||
        held.segment.goes_straight() != segment.goes_straight())
        return release(), 0;
    if (is_transformed) return blend_orientation_corner(command, segment, length);
    const auto found = corner_blend({held.segment.curve, held.command.motion().blending},
                                    {segment.curve, command.motion().blending});
    if (!found) return keep_sharp(), 0;
    const std::array<path::Curve, 2> before{found->curve[0], found->curve[1]};
    const std::array<path::Curve, 2> behind{found->curve[2], found->curve[3]};
    const std::array<PathLimits, 2> beside = {limits_on(held.command, held.segment, held.length),
                                              limits_on(command, segment, length)};
    const double most = std::min(beside[0].speed, beside[1].speed);
    const double on_curve =
        std::min(least_speed(before, held.segment, most), least_speed(behind, segment, most));
    const CornerPassage corner =
        corner_between({held.segment, held.length, beside[0]}, {segment, length, beside[1]});
    Alternative around{found->distance, on_curve, corner, {held.length, length}, beside};
    around.is_doubtful = axes.limits_jerk() && (path::bends_freely(held.segment.curve) ||
                                                path::bends_freely(segment.curve));
    if (!saves_time(around)) return keep_sharp(), 0;
    held.is_held = false;
    emit_part(held.command, held.segment, held.length, {held.from, held.length - found->distance});
    emit_curves(held.command, held.segment, held.length, before);
    end_command();
    if (has_law(command)) begin_law(0, length);
    emit_curves(command, segment, length, behind);
    return found->distance;
}

/// Time along paths under the transformation: where the axes keep one below its feed, by the parts
/// that one speed suits.
double Preparer::State::time_along(std::span<const Segment> ways, const Command& command) const {
    double time = 0;
    for (const Segment& segment : ways) {
        const double length = segment.orientation.length;
        const double wanted = feed_of(command, segment, length).value_or(kInfinity);
        const auto speed_on = [&](const Segment& part) {
            return axes.limits(part, axes.start_rates(part), wanted).speed;
        };
        if (const double speed = speed_on(segment); speed >= wanted) {
            time += length / speed;
            continue;
        }
        for (const Segment& part :
             even_parts(axes.chain(), segment, axes.bounds(), {wanted, tick, false})) {
            time += part.orientation.length / speed_on(part);
        }
    }
    return time;
}

/// Whether the path around a corner takes less time than the corner as it is, or than a stop there.
bool Preparer::State::gains_time(const OrientationBlend& around, const Command& command,
                                 const OrientationPath& before, const OrientationPath& behind,
                                 CornerAsItIs as_it_is) {
    const double distance = around.distance;
    const Segment tail = before.part(held.length - distance, held.length);
    const Segment head = behind.part(0, distance);
    Alternative curve;
    curve.distance = distance;
    curve.lengths = {held.length, behind.whole().orientation.length};
    curve.limits = {limits_on(held.command, tail, distance), limits_on(command, head, distance)};
    curve.on_curve = std::min(curve.limits[0].speed, curve.limits[1].speed);
    const std::span<const Segment> four(around.pieces);
    for (const Segment& piece : four) {
        curve.on_curve = std::min(
            curve.on_curve, axes.limits(piece, axes.start_rates(piece), curve.on_curve).speed);
    }
    if (as_it_is != CornerAsItIs::Stop) {
        curve.corner = corner_between({tail, curve.lengths[0], curve.limits[0]},
                                      {head, curve.lengths[1], curve.limits[1]});
    }
    if (as_it_is != CornerAsItIs::OfTheTip) return saves_time(curve);
    curve.is_asked = true;
    if (BlendedCorner(four[1].curve, four[2].curve).is_corner(false)) {
        curve.in_middle = corner_between({four[1], four[1].orientation.length, curve.limits[0]},
                                         {four[2], four[2].orientation.length, curve.limits[1]})
                              .speed;
    }
    // The least speed may be that of a short part.
    curve.limits[0].speed = distance / time_along({&tail, 1}, held.command);
    curve.limits[1].speed = distance / time_along({&head, 1}, command);
    if (saves_time(curve)) return true;
    // Between its parts the ramps lie between that and the mean: half way, in time.
    const double at_mean =
        time_along(four.first(2), held.command) + time_along(four.last(2), command);
    curve.on_curve = 2 * distance / ((at_mean + 2 * distance / curve.on_curve) / 2);
    return saves_time(curve);
}

/// The path of tip and tool around the corner between two motions, if the program asks for one and
/// it takes less time than the corner. Under a limit of the jerk the corner is a stop then: small
/// changes of orientation at a corner of the tip would let the rotary axes jump, which costs no
/// time.
OrientationAtCorner Preparer::State::blended_orientation(const Command& command,
                                                         const OrientationPath& before,
                                                         const OrientationPath& behind) {
    const path::Blending& wish = held.command.motion().blending;
    if (wish.kind == path::BlendKind::None || !(wish.size > 0)) return {};
    auto found = orientation_blend(axes.chain(), before, wish, behind, command.motion().blending);
    if (!found) return {};
    const bool rests = axes.limits_jerk();
    if (gains_time(*found, command, before, behind,
                   rests ? CornerAsItIs::Stop : CornerAsItIs::Passed))
        return {std::move(found), false};
    return {std::nullopt, rests};
}

/// The path of the tool alone, while the tip stays on its path: likewise. Else the corner stays as
/// it would be without.
std::optional<OrientationBlend> Preparer::State::smoothed_path(const Command& command,
                                                               const OrientationPath& before,
                                                               const OrientationPath& behind) {
    const path::Blending& wish = held.command.motion().blending;
    if (!wish.smooths_orientation) return std::nullopt;
    auto found = smoothed_orientation(axes.chain(), before, behind, wish.orientation);
    if (found && !gains_time(*found, command, before, behind, CornerAsItIs::OfTheTip))
        found.reset();
    return found;
}

/// The same where the orientation changes: its path is blended, too, or it alone.
double Preparer::State::blend_orientation_corner(const Command& command, const Segment& segment,
                                                 double length) {
    if (held.segment.carrier != segment.carrier) return release(), 0;
    const OrientationPath before(axes.chain(), held.segment);
    const OrientationPath behind(axes.chain(), segment);
    auto [found, rests] = blended_orientation(command, before, behind);
    if (!found) found = smoothed_path(command, before, behind);
    if (!found) {
        release();
        if (rests) last.must_stop = true;
        return 0;
    }
    held.is_held = false;
    if (has_law(held.command)) begin_law(held.from, held.length);
    if (const double to = held.length - found->distance; to - held.from > kStill)
        emit_path(held.command, before.part(held.from, to), held.length);
    for (std::size_t i = 0; i < found->pieces.size(); ++i) {
        if (i == 2) end_command();
        if (i == 2 && has_law(command)) begin_law(0, length);
        const bool is_before = i < 2;
        if (!has_ended)
            emit_path(is_before ? held.command : command, found->pieces[i],
                      is_before ? held.length : length);
    }
    return found->distance;
}

/// What the axes allow on a motion, at a speed up to what it asks for.
PathLimits Preparer::State::limits_on(const Command& command, const Segment& segment,
                                      double length) const {
    const double wanted = feed_of(command, segment, length).value_or(kInfinity);
    return axes.limits(segment, axes.start_rates(segment), wanted);
}

double Preparer::State::least_speed(std::span<const path::Curve> curves, const Segment& whole,
                                    double most) const {
    Segment piece = whole;
    for (const path::Curve& curve : curves) {
        piece.curve = curve;
        most = std::min(most, axes.limits(piece, axes.start_rates(piece), most).speed);
    }
    return most;
}

/// How the corner between the motion that waits and the next one would be passed as it is, by the
/// rules of prepare_corners.cpp.
CornerPassage Preparer::State::corner_between(const CornerNeighbour& before,
                                              const CornerNeighbour& behind) {
    Piece piece;
    piece.segment = behind.segment;
    piece.length = behind.length;
    piece.speed = behind.limits.speed;
    piece.acceleration = behind.limits.acceleration;
    piece.jerk = behind.limits.jerk;
    piece.turning_acceleration = behind.limits.turning_acceleration;
    piece.rates = axes.start_rates(behind.segment);
    piece.loads = axes.loads(behind.segment, piece.rates);

    CornerMemory memory;
    memory.rates = axes.end_rates(before.segment);
    memory.loads = axes.loads(before.segment, axes.start_rates(before.segment));
    memory.is_bent = !is_straight(before.segment);
    memory.can_be_cut = can_be_cut(before.segment);
    if (axes.limits_jerk() && memory.is_bent) memory.bends = axes.end_bends(before.segment);
    memory.dynamics = dynamics;
    memory.is_plain = is_plain;
    memory.length = before.length;
    memory.speed = before.limits.speed;
    memory.acceleration = before.limits.acceleration;
    memory.jerk = before.limits.jerk;
    memory.turning_acceleration = before.limits.turning_acceleration;
    memory.must_stop = false;
    if (options.corner_rule == CornerRule::JunctionDeviation)
        memory.direction =
            path::evaluate(before.segment.curve, path::length(before.segment.curve)).tangent;

    std::swap(last, memory);
    piece.entry_limit = corner_speed(behind.segment, piece.rates, piece.acceleration);
    take_corner(piece);
    if (axes.limits_jerk()) take_bend(piece);
    std::swap(last, memory);
    return {std::min({piece.entry_limit, piece.speed, before.limits.speed}), piece.ramp,
            piece.jerk_share};
}

}  // namespace kadr::motion
