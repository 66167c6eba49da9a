// programmed_dynamics.cpp — words of how fast motions may be, and what of them a command gets.
// source: SINUMERIK reference 2.3 (FGROUP, FGREF, FL, FA, OVRA), 3.2 (FNORM, FLIN, FCUB, FPO), 3.5;
// FANUC reference 3.2 (G63), 6.5 (#3004)
#include "interp/programmed_dynamics.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/diagnostics/iso.h"
#include "base/units.h"
#include "interp/block_words.h"
#include "nc/parameters.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using nc::parameter_of_all;
using path::Op;
using Write = ControlAccess::Write;

namespace {

// #3004, as a sum.
constexpr int kHold = 1;
constexpr int kOverride = 2;
constexpr int kExactStop = 4;

constexpr double kPercent = 0.01;

std::string_view name_of(Function function) {
    if (function == Function::AxisVelocity) return "velocity";
    return function == Function::AxisJerk ? "jerk" : "acceleration";
}

AxisValues& parts_of_axes(path::Dynamics& dynamics, Function function) {
    if (function == Function::AxisVelocity) return dynamics.velocity;
    return function == Function::AxisJerk ? dynamics.jerk : dynamics.acceleration;
}

}  // namespace

void ProgrammedDynamics::set_axis_limit(const Block& block, const Invocation& invocation) {
    const Function function = invocation.function;
    constexpr double kLeast = 1;
    const double most = function == Function::AxisVelocity ? 100 : 200;
    constexpr std::size_t kAxis =
        parameter_of_all<"axis", Function::AxisVelocity, Function::AxisAcceleration,
                         Function::AxisJerk>();
    constexpr std::size_t kPart =
        parameter_of_all<"percent", Function::AxisVelocity, Function::AxisAcceleration,
                         Function::AxisJerk>();
    const double percent = block.argument(invocation, kPart);
    if (!(percent >= kLeast && percent <= most)) {
        reporter_.report(diag::DynamicsRange, block, function)
            .arg(percent)
            .arg(name_of(function))
            .arg(kLeast)
            .arg(most);
        return;
    }
    const std::int64_t number = std::llround(block.argument(invocation, kAxis));
    const std::size_t axis = number >= 1 ? static_cast<std::size_t>(number) - 1 : kAxes;
    if (axis >= kAxes || (axes_.present >> axis & 1) == 0) {
        reporter_.report(diag::AxisMissing, block, function)
            .arg(axis < kAxes ? kAxisNames[axis] : std::string_view("of this number"));
        return;
    }
    parts_of_axes(programmed_dynamics(), function)[axis] = percent * kPercent;
}

/// So much of F, or of the speed at rapid.
void ProgrammedDynamics::set_override(const Block& block, const Invocation& invocation) {
    path::Dynamics& dynamics = programmed_dynamics();
    const bool is_feed = invocation.function == Function::FeedOverride;
    const double most = is_feed ? 200 : 100;
    constexpr std::size_t kPart =
        parameter_of_all<"percent", Function::FeedOverride, Function::RapidOverride>();
    const double percent = block.argument(invocation, kPart);
    if (!(percent >= 0 && percent <= most)) {
        reporter_.report(diag::OverrideRange, block, invocation.function).arg(percent).arg(most);
        return;
    }
    (is_feed ? dynamics.feed : dynamics.rapid) = percent * kPercent;
}

void ProgrammedDynamics::choose_feed_characteristic(const Block& block,
                                                    const Invocation& invocation) {
    state_.feed_characteristic = static_cast<path::FeedCharacteristic>(std::clamp<std::int64_t>(
        count_of(block, invocation, parameter_of<Function::FeedCourse>("kind")), 0, 2));
    state_.has_feed_characteristic |=
        state_.feed_characteristic != path::FeedCharacteristic::Constant;
}

/// Of the motions from here on.
path::Dynamics& ProgrammedDynamics::programmed_dynamics() { return state_.dynamics.made(); }

/// An axis that the machine has; what it has not is reported.
std::optional<Axis> ProgrammedDynamics::known_axis(const Block& block, const Invocation& invocation,
                                                   std::size_t parameter) {
    const std::int64_t said = std::llround(block.argument(invocation, parameter));
    // A name stands below zero, and so it is for words that name one axis each.
    const std::int64_t named = said > 0 ? -said : said;
    const auto index = static_cast<std::size_t>(-named - 1);
    if (named < 0 && index < kAxes && (axes_.present >> index & 1u) != 0)
        return static_cast<Axis>(index);
    reporter_.report(diag::AxisMissing, block, invocation.function)
        .arg(named < 0 && index < kAxes ? kAxisNames[index] : std::string_view("of this number"));
    return std::nullopt;
}

void ProgrammedDynamics::choose_feed_axes(const Block& block, const Invocation& invocation) {
    constexpr std::size_t kMost = kAxes;
    constexpr std::size_t kFirst = parameter_of<Function::FeedAxes>("axis");
    AxisMask axes = 0;
    for (std::size_t i = 0; i < kMost; ++i) {
        if (!invocation.has(kFirst + i)) continue;
        const std::optional<Axis> axis = known_axis(block, invocation, kFirst + i);
        if (!axis) return;
        axes |= bit(*axis);
    }
    // The geometry axes are what F is about where nothing is programmed.
    const auto geometry = static_cast<AxisMask>(axes_.present & kLinearXYZ);
    programmed_dynamics().feed_axes = axes == geometry ? AxisMask{0} : axes;
}

void ProgrammedDynamics::set_feed_radius(const Block& block, const Invocation& invocation) {
    const double radius = block.argument(invocation, parameter_of<Function::FeedRadius>("radius"));
    if (!(radius > 0)) {
        reporter_.report(diag::FeedRadiusRange, block, invocation.function).arg(radius);
        return;
    }
    const std::optional<Axis> axis =
        known_axis(block, invocation, parameter_of<Function::FeedRadius>("axis"));
    if (!axis) return;
    programmed_dynamics().feed_radius[index(*axis)] = radius;
}

/// What a word programs for the speed of one axis: of one that is not among the feed axes (motion/
/// asks whether it is), or of one that positions by itself.
void ProgrammedDynamics::set_axis_speed(const Block& block, const Invocation& invocation) {
    constexpr std::size_t kAxis =
        parameter_of_all<"axis", Function::AxisSpeed, Function::AxisFeed, Function::AxisOverride>();
    constexpr std::size_t kSpeed =
        parameter_of_all<"speed", Function::AxisSpeed, Function::AxisFeed>();
    constexpr std::size_t kTurning =
        parameter_of_all<"turning", Function::AxisSpeed, Function::AxisFeed>();
    const std::optional<Axis> axis = known_axis(block, invocation, kAxis);
    if (!axis) return;
    const std::size_t i = index(*axis);
    PanelState::Positioning& positioning = state_.positioning;
    if (invocation.function == Function::AxisOverride) {
        const double percent =
            block.argument(invocation, parameter_of<Function::AxisOverride>("percent"));
        constexpr double kMost = 200;
        if (!(percent >= 0 && percent <= kMost)) {
            reporter_.report(diag::OverrideRange, block, invocation.function)
                .arg(percent)
                .arg(kMost);
            return;
        }
        positioning.is_given = true;
        positioning.part[i] = percent / 100;
        return;
    }
    const bool turns = is_rotary(*axis);
    const bool is_positioning = invocation.function == Function::AxisFeed;
    const double speed = block.argument(invocation, turns ? kTurning : kSpeed);
    if (!(speed > 0)) {
        reporter_
            .report(is_positioning ? diag::AxisFeedRange : diag::AxisSpeedRange, block,
                    invocation.function)
            .arg(speed)
            .arg(kAxisNames[i]);
        return;
    }
    AxisValues& speeds = is_positioning ? positioning.speed : programmed_dynamics().speed;
    speeds[i] = turns ? rad_from_deg(speed) / 60 : feed_from_mm_min(speed);
    positioning.is_given |= is_positioning;
}

Write ProgrammedDynamics::suppress_panel(double value) {
    constexpr double kAll = kHold + kOverride + kExactStop;
    if (!(value >= 0 && value <= kAll)) return Write::NoSuchEntry;
    const int bits = static_cast<int>(value);
    state_.has_hold = (bits & kHold) == 0;
    state_.has_override = (bits & kOverride) == 0;
    state_.has_exact_stop = (bits & kExactStop) == 0;
    return Write::Done;
}

double ProgrammedDynamics::suppressed_panel() const {
    return (state_.has_hold ? 0 : kHold) + (state_.has_override ? 0 : kOverride) +
           (state_.has_exact_stop ? 0 : kExactStop);
}

/// What of the panel and of the machine's limits acts on a motion.
void ProgrammedDynamics::put_panel(path::Motion& motion, const Block& block,
                                   const Acting& acting) const {
    const bool is_feed = motion.op() != Op::Rapid;
    const bool is_tap = is_feed && block.is_of_cycle() && block.context->taps;
    motion.keeps_feed = is_tap || (is_feed && (acting.taps || !state_.has_override));
    motion.ignores_hold = is_tap || acting.taps || !state_.has_hold;
    motion.dynamics = state_.dynamics;
    // At rapid an axis has all its speed, whatever it has beside F.
    if (motion.dynamics && !is_feed) motion.dynamics->speed = path::Dynamics().speed;
    if (state_.has_feed_characteristic && !block.is_of_cycle()) put_feed_law(motion, acting);
}

/// What axes that position by themselves have of their speed: of their own feed the override, up to
/// what the program leaves them of the machine's.
void ProgrammedDynamics::put_positioning(path::Motion& motion) const {
    const PanelState::Positioning& positioning = state_.positioning;
    if (!positioning.is_given) return;
    AxisValues& parts = motion.dynamics.made().velocity;
    for (const machine::MachineAxis& axis : machine_.axes) {
        const std::size_t i = index(axis.axis);
        const double own =
            std::isfinite(positioning.speed[i]) ? positioning.speed[i] / axis.velocity : parts[i];
        const double part = own * positioning.part[i];
        if (part > 0) {
            parts[i] = std::min(parts[i], part);
        } else if ((motion.moved & bit(axis.axis)) != 0) {
            motion.dynamics->rapid = 0;  // it stands
        }
    }
}

/// How the feed of a motion comes to F; feed_characteristics.h works it out when the motions of its
/// block are known. Under a feed per revolution F holds from the start (SINUMERIK reference 3.2).
/// Cycles, whose feeds are their own, have none.
void ProgrammedDynamics::put_feed_law(path::Motion& motion, const Acting& acting) const {
    const std::uint32_t block = acting.block;
    const bool is_polynomial = state_.polynomial.kind != path::FeedCharacteristic::Constant &&
                               state_.polynomial.block == block;
    if (state_.feed_characteristic == path::FeedCharacteristic::Constant && !is_polynomial) return;
    const bool can_have_one = motion.op() >= Op::Line && motion.op() <= Op::Parametric;
    if (!can_have_one || acting.feed_mode == path::FeedMode::PerRevolution) return;
    path::FeedLaw& law = motion.dynamics.made().law;
    law = is_polynomial ? state_.polynomial : path::FeedLaw{state_.feed_characteristic, block};
}

}  // namespace kadr::interp
