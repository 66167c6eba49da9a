// feed_words.cpp — of which axes F is the speed, how fast others may be, how the feed comes to F.
// source: SINUMERIK reference 2.3 (FGROUP, FGREF, FL, FA, OVRA), 3.2 (FNORM, FLIN, FCUB, FPO)
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "base/units.h"
#include "interp/block_words.h"
#include "interp/executor.h"
#include "nc/parameters.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using nc::parameter_of_all;
using path::Op;

void Executor::set_feed_words(const Block& block, const Invocation& invocation) {
    switch (invocation.function) {
        case Function::FeedAxes: return choose_feed_axes(block, invocation);
        case Function::FeedRadius: return set_feed_radius(block, invocation);
        case Function::FeedPolynomial: return take_polynomial(block, invocation);
        case Function::FeedCourse: break;
        default: return set_axis_speed(block, invocation);
    }
    panel_.course = static_cast<path::FeedCharacteristic>(std::clamp<std::int64_t>(
        count_of(block, invocation, parameter_of<Function::FeedCourse>("kind")), 0, 2));
    panel_.has_feed_characteristic |= panel_.course != path::FeedCharacteristic::Constant;
}

/// Of the motions from here on.
path::Dynamics& Executor::programmed_dynamics() {
    if (panel_.dynamics.empty()) panel_.dynamics.emplace_back();
    return panel_.dynamics.front();
}

/// An axis that the machine has; what it has not is reported.
std::optional<Axis> Executor::known_axis(const Block& block, const Invocation& invocation,
                                         std::size_t parameter) {
    const std::int64_t said = std::llround(block.argument(invocation, parameter));
    // A name stands below zero, and so it is for words that name one axis each.
    const std::int64_t named = said > 0 ? -said : said;
    if (const std::optional<Axis> axis = axis_of(named); axis && named < 0) return axis;
    const auto place = static_cast<std::size_t>(-named - 1);
    reporter_.report(diag::AxisMissing, block, invocation.function)
        .arg(named < 0 && place < kAxes ? kAxisNames[place] : std::string_view("of this number"));
    return std::nullopt;
}

void Executor::choose_feed_axes(const Block& block, const Invocation& invocation) {
    constexpr std::size_t kMost = kAxes;
    constexpr std::size_t kFirst = parameter_of<Function::FeedAxes>("axis");
    AxisMask axes = 0;
    for (std::size_t i = 0; i < kMost; ++i) {
        if (!invocation.has(kFirst + i)) continue;
        const std::optional<Axis> axis = known_axis(block, invocation, kFirst + i);
        if (!axis) return;
        axes |= bit(*axis);
    }
    // The geometry axes are what F is about where nothing is said.
    const auto geometry = static_cast<AxisMask>(axes_.present & kLinearXYZ);
    programmed_dynamics().feed_axes = axes == geometry ? AxisMask{0} : axes;
}

void Executor::set_feed_radius(const Block& block, const Invocation& invocation) {
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

/// Whether it may matter how much a degree is in F.
bool Executor::may_count_degrees(const Block& block) const {
    constexpr auto kFollowers = static_cast<AxisMask>(~kLinearXYZ);
    const bool has_followers = (block.given & axes_.present & kFollowers) != 0;
    return has_followers && (rules_.feed_of_all_axes || block.has_inch_feed) && !is_transformed();
}

/// A degree is as much in F as a unit of length: an inch where F is in inches. So it is on every
/// control in a block in which rotary axes move alone, of which none has a radius of its own
/// (SINUMERIK programming manual, FGREF); with other axes where F is the speed of all of them.
void Executor::count_degrees(const Block& block, path::Command& command) const {
    AxisMask moving = 0;
    for (const machine::MachineAxis& axis : machine_.axes) {
        const std::size_t i = index(axis.axis);
        if (command.to[i] != position_.base[i]) moving |= bit(axis.axis);
    }
    const auto turning = static_cast<AxisMask>(moving & kRotaryABC);
    const bool turns_alone = moving == turning;
    const bool counts_all = rules_.feed_of_all_axes && !turns_alone && (moving & ~kLinearXYZ) != 0;
    const bool has_inches = block.has_inch_feed && turning != 0 && (turns_alone || counts_all);
    if (!counts_all && !has_inches) return;
    if (command.dynamics.empty()) command.dynamics.emplace_back();
    path::Dynamics& said = command.dynamics.front();
    if (counts_all) said.feed_axes = axes_.present;
    constexpr double kSame = 1e-9;  // mm: a program may say the control's radius
    for (double& radius : said.feed_radius)
        if (has_inches && std::abs(radius - path::kRadiusOfDegrees) < kSame) radius *= kMmPerInch;
}

/// What a word says of the speed of one axis: of one that is not among the feed axes (motion/ asks
/// whether it is), or of one that positions by itself.
void Executor::set_axis_speed(const Block& block, const Invocation& invocation) {
    constexpr std::size_t kAxis =
        parameter_of_all<"axis", Function::AxisSpeed, Function::AxisFeed, Function::AxisOverride>();
    constexpr std::size_t kSpeed =
        parameter_of_all<"speed", Function::AxisSpeed, Function::AxisFeed>();
    constexpr std::size_t kTurning =
        parameter_of_all<"turning", Function::AxisSpeed, Function::AxisFeed>();
    const std::optional<Axis> axis = known_axis(block, invocation, kAxis);
    if (!axis) return;
    const std::size_t i = index(*axis);
    PanelState::Positioning& positioning = panel_.positioning;
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
        positioning.is_said = true;
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
    positioning.is_said |= is_positioning;
}

/// What axes that position by themselves have of their speed: of their own feed the override, up to
/// what the program leaves them of the machine's.
void Executor::put_positioning(path::Command& command) const {
    const PanelState::Positioning& positioning = panel_.positioning;
    if (!positioning.is_said) return;
    if (command.dynamics.empty()) command.dynamics.emplace_back();
    AxisValues& parts = command.dynamics.front().velocity;
    for (const machine::MachineAxis& axis : machine_.axes) {
        const std::size_t i = index(axis.axis);
        const double own =
            std::isfinite(positioning.speed[i]) ? positioning.speed[i] / axis.velocity : parts[i];
        const double part = own * positioning.part[i];
        if (part > 0) {
            parts[i] = std::min(parts[i], part);
        } else if ((command.moved & bit(axis.axis)) != 0) {
            command.dynamics.front().rapid = 0;  // it stands
        }
    }
}

/// The polynomial of the block's motions; its end is F from here on.
void Executor::take_polynomial(const Block& block, const Invocation& invocation) {
    if (modal_.feed_mode == path::FeedMode::PerRevolution) {
        reporter_.report(diag::FeedPolynomialMode, block, invocation.function);
        return;
    }
    modal_.feed = block.argument(invocation, parameter_of<Function::FeedPolynomial>("end"));
    modal_.has_feed = true;
    tooth_feed_ = 0;
    panel_.has_feed_characteristic = true;
    panel_.polynomial = {
        path::FeedCharacteristic::Polynomial,
        static_cast<std::uint32_t>(block_count_),
        block.argument(invocation, parameter_of<Function::FeedPolynomial>("square")),
        block.argument(invocation, parameter_of<Function::FeedPolynomial>("cube")),
        {}};
}

/// How the feed of a motion comes to F; feed_characteristics.h works it out when the motions of its
/// block are known. Under a feed per revolution F holds from the start (SINUMERIK reference 3.2).
/// Cycles, whose feeds are their own, have none.
void Executor::put_feed_law(path::Command& command) const {
    const auto block = static_cast<std::uint32_t>(block_count_);
    const bool is_polynomial = panel_.polynomial.kind != path::FeedCharacteristic::Constant &&
                               panel_.polynomial.block == block;
    if (panel_.course == path::FeedCharacteristic::Constant && !is_polynomial) return;
    const bool can_have_one = command.op >= Op::Line && command.op <= Op::Parametric;
    if (!can_have_one || modal_.feed_mode == path::FeedMode::PerRevolution) return;
    if (command.dynamics.empty()) command.dynamics.emplace_back();
    path::FeedLaw& law = command.dynamics.front().law;
    law = is_polynomial ? panel_.polynomial : path::FeedLaw{panel_.course, block};
}

/// The course of a motion's feed falls to this, in the unit of F.
void Executor::report_varying_feed(const path::Command& command, double feed) {
    const Block at = block_at(command.source, command.line);
    reporter_.report(diag::FeedCourseNotPositive, at).arg(round_to(feed, 3));
}

}  // namespace kadr::interp
