// Rounded corners: a motion behind which the program lets the control round the corner waits for
// the next one, and the curve around the corner takes the place of the end of one and of the
// beginning of the other, unless the corner as it is takes less time. Its first half belongs to the
// motion before, with its feed and its line of the text, its second half to the one behind.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "motion/corner.h"
#include "motion/feed.h"
#include "motion/prepare_state.h"
#include "motion/rounding.h"
#include "motion/smooth_profile.h"
#include "motion/turned_corner.h"

namespace kadr::motion {

namespace {

using path::Command;
using path::Op;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Of the jump of an axis' velocity that a corner could have, what is left beside ramps, and of the
/// acceleration what is left to them.
constexpr double kJumpBesideRamps = 0.42;
constexpr double kRampBesideJump = 0.9;
/// The same of an axis' jerk, where the curvature jumps.
constexpr double kJerkBesideRamps = 0.5;

/// A curve around a corner, and the corner as it is.
struct Alternative {
    double way = 0;       // mm of the curve on either side
    double on_curve = 0;  // speed there
    double at_corner = 0;
    double half = 0;  // of the shorter one of both motions, mm
};

/// Whether the curve takes less time than the corner, which may be passed or be a stop. Ramps end
/// in the middles of both motions.
bool saves_time(const Alternative& curve, const std::array<PathLimits, 2>& beside) {
    const double most = std::min(beside[0].speed, beside[1].speed);
    double on_curve = 0;
    double through_corner = 0;
    double with_stop = 0;
    for (const PathLimits& limits : beside) {
        RampLimits ramp{limits.acceleration, limits.jerk};
        on_curve += curve.way / curve.on_curve +
                    time_over(curve.half - curve.way, curve.on_curve, limits.speed, ramp);
        with_stop += time_over(curve.half, 0, limits.speed, ramp);
        if (curve.at_corner < most) ramp.acceleration *= kRampBesideJump;
        through_corner += time_over(curve.half, curve.at_corner, limits.speed, ramp);
    }
    return on_curve < std::min(through_corner, with_stop);
}

constexpr bool is_rounded(Op op) {
    return op == Op::Rapid || op == Op::Line || op == Op::Arc || op == Op::Spline ||
           op == Op::Involute || op == Op::Parametric;
}

}  // namespace

/// The path speed that the program asks for; nothing if it cannot be said, which is reported when
/// the motion becomes pieces. Without the operator's override: the way does not depend on it.
std::optional<double> Preparer::State::feed_of(const Command& command, const Segment& segment,
                                               double length) const {
    if (command.op == Op::Rapid) return kInfinity;
    const auto feed = path_feed(command, segment, length, spindle, &axes);
    if (!feed) return std::nullopt;
    return *feed * programmed_override(command);
}

/// Whether there can be a curve before or behind a motion. Axes beside X, Y, Z have no curve but
/// those that turn the tool, and the pulses of a laser burn the programmed points.
bool Preparer::State::can_be_rounded(const Command& command, const Segment& segment,
                                     const Arrival& arrival) const {
    if (!is_rounded(command.op) || has_pulses() || segment.turns_only) return false;
    const bool is_free =
        segment.is_transformed() ? is_one_way(segment, arrival.joints) : segment.followers == 0;
    return is_free && feed_of(command, segment, arrival.length).has_value();
}

/// Keeps a motion until the next one is known; false if nothing is asked for behind it.
bool Preparer::State::hold(const Command& command, const Segment& segment, const Arrival& arrival,
                           double from) {
    const path::Blending& wish = command.blending;
    const bool rounds = wish.kind != path::BlendKind::None && wish.size > 0;
    const bool smooths = wish.smooths_turns && segment.is_transformed();
    if (command.exact_stop || !(rounds || smooths)) return false;
    if (!can_be_rounded(command, segment, arrival)) return false;
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

/// A motion from a place on its way on.
void Preparer::State::emit_rest(const Command& command, const Segment& whole, double length,
                                double from) {
    if (whole.is_transformed()) {
        if (has_law(command)) begin_law(from, length);
        emit_way(command, TurningWay(axes.chain(), whole).part(from, length), length);
    } else {
        emit_part(command, whole, length, {from, length});
    }
    end_command();
}

/// The motion that waits goes on, and the curve around the corner behind it if there is one.
/// Returns how much of the next motion the curve has taken.
double Preparer::State::round_corner(const Command& command, const Segment& segment,
                                     const Arrival& arrival) {
    if (!held.is_held) return 0;
    const double length = arrival.length;
    const bool is_transformed = segment.is_transformed();
    if (!can_be_rounded(command, segment, arrival) ||
        held.segment.is_transformed() != is_transformed ||
        held.segment.goes_straight() != segment.goes_straight())
        return release(), 0;
    if (is_transformed) return round_turned_corner(command, segment, length);
    const auto found =
        rounding({held.segment.curve, held.command.blending}, {segment.curve, command.blending});
    if (!found) return release(), 0;
    const std::array<path::Curve, 2> before{found->curve[0], found->curve[1]};
    const std::array<path::Curve, 2> behind{found->curve[2], found->curve[3]};
    const std::array<PathLimits, 2> beside = {limits_on(held.command, held.segment, held.length),
                                              limits_on(command, segment, length)};
    const double most = std::min(beside[0].speed, beside[1].speed);
    const double on_curve =
        std::min(least_speed(before, held.segment, most), least_speed(behind, segment, most));
    const double at_corner = corner_estimate(held.segment, segment, beside);
    if (!saves_time({found->way, on_curve, at_corner, std::min(held.length, length) / 2}, beside))
        return release(), 0;
    held.is_held = false;
    emit_part(held.command, held.segment, held.length, {held.from, held.length - found->way});
    emit_curves(held.command, held.segment, held.length, before);
    end_command();
    if (has_law(command)) begin_law(0, length);
    emit_curves(command, segment, length, behind);
    return found->way;
}

/// The way of tip and tool around the corner between two motions, if the program asks for one and
/// it takes less time than the corner.
std::optional<TurnedRounding> Preparer::State::rounded_turn(const Command& command,
                                                            const TurningWay& before,
                                                            const TurningWay& behind) const {
    const path::Blending& wish = held.command.blending;
    if (wish.kind == path::BlendKind::None || !(wish.size > 0)) return std::nullopt;
    const auto found = turned_rounding(axes.chain(), before, wish, behind, command.blending);
    if (!found) return std::nullopt;
    const Segment tail = before.part(held.length - found->way, held.length);
    const Segment head = behind.part(0, found->way);
    const std::array<PathLimits, 2> beside = {limits_on(held.command, tail, found->way),
                                              limits_on(command, head, found->way)};
    double on_curve = std::min(beside[0].speed, beside[1].speed);
    for (const Segment& piece : found->pieces)
        on_curve = std::min(on_curve, axes.limits(piece, axes.start_rates(piece), on_curve).speed);
    const double at_corner = corner_estimate(tail, head, beside);
    const double half = std::min(held.length, behind.whole().turn.length) / 2;
    const bool is_quicker = saves_time({found->way, on_curve, at_corner, half}, beside);
    return is_quicker ? found : std::nullopt;
}

/// The same on which the tool turns: its way is rounded, too, or it alone.
double Preparer::State::round_turned_corner(const Command& command, const Segment& segment,
                                            double length) {
    if (held.segment.carrier != segment.carrier) return release(), 0;
    const TurningWay before(axes.chain(), held.segment);
    const TurningWay behind(axes.chain(), segment);
    auto found = rounded_turn(command, before, behind);
    const path::Blending& wish = held.command.blending;
    if (!found && wish.smooths_turns)
        found = smoothed_turn(axes.chain(), before, behind, wish.orientation);
    if (!found) return release(), 0;
    held.is_held = false;
    if (has_law(held.command)) begin_law(held.from, held.length);
    if (const double to = held.length - found->way; to - held.from > kStill)
        emit_way(held.command, before.part(held.from, to), held.length);
    for (std::size_t i = 0; i < found->pieces.size(); ++i) {
        if (i == 2) end_command();
        if (i == 2 && has_law(command)) begin_law(0, length);
        const bool is_before = i < 2;
        if (!has_ended)
            emit_way(is_before ? held.command : command, found->pieces[i],
                     is_before ? held.length : length);
    }
    return found->way;
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

/// About how fast the corner would be passed as it is: the rules of prepare_corners.cpp, of which
/// the shares depend on more than the corner.
double Preparer::State::corner_estimate(const Segment& before, const Segment& behind,
                                        const std::array<PathLimits, 2>& beside) const {
    const std::size_t n = axes.size();
    const AxisRates in = axes.end_rates(before);
    const AxisRates out = axes.start_rates(behind);
    double speed = std::min(beside[0].speed, beside[1].speed);
    if (options.corner_rule == CornerRule::AxisJump) {
        speed = std::min(speed, kJumpBesideRamps * axis_jump_speed({in.data(), n}, {out.data(), n},
                                                                   {jump.data(), n}));
    } else {
        const path::Vec3 from = path::evaluate(before.curve, path::length(before.curve)).tangent;
        const path::Vec3 to = path::evaluate(behind.curve, 0).tangent;
        const double least = std::min(beside[0].acceleration, beside[1].acceleration);
        speed =
            std::min(speed, junction_deviation_speed(from, to, options.junction_deviation, least));
    }
    if (!axes.limits_jerk()) return speed;
    const AxisRates bend_in = axes.end_bends(before);
    const AxisRates bend_out = axes.start_bends(behind);
    for (std::size_t i = 0; i < n; ++i) {
        const double change = std::abs(bend_out[i] - bend_in[i]);
        if (change == 0) continue;
        speed = std::min(speed,
                         std::sqrt(kJerkBesideRamps * axes.jerk(i) * tick / (kJumpBell * change)));
    }
    return speed;
}

}  // namespace kadr::motion
