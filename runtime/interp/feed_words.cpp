// feed_words.cpp — what a degree counts in F, and a feed that is a polynomial.
// source: SINUMERIK reference 2.3 (FGROUP, FGREF), 3.2 (FPO)
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

/// Whether a motion ends at rest: by what is modal, or by a word of its block alone.
bool Executor::stops_exactly(bool once) const {
    return dynamics_.has_exact_stop() && (modal_.has_exact_stop || once);
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

/// The polynomial of the block's motions; its end is F from here on.
void Executor::take_polynomial(const Block& block, const Invocation& invocation) {
    if (modal_.feed_mode == path::FeedMode::PerRevolution) {
        reporter_.report(diag::FeedPolynomialMode, block, invocation.function);
        return;
    }
    modal_.feed = block.argument(invocation, parameter_of<Function::FeedPolynomial>("end"));
    modal_.has_feed = true;
    tooth_feed_ = 0;
    dynamics_.set_polynomial(
        {path::FeedCharacteristic::Polynomial,
         static_cast<std::uint32_t>(block_count_),
         block.argument(invocation, parameter_of<Function::FeedPolynomial>("square")),
         block.argument(invocation, parameter_of<Function::FeedPolynomial>("cube")),
         {}});
}

/// The course of a motion's feed falls to this, in the unit of F.
void Executor::report_varying_feed(const path::Command& command, double feed) {
    const Block at = block_at(command.source, command.line);
    reporter_.report(diag::FeedCourseNotPositive, at).arg(round_to(feed, 3));
}

}  // namespace kadr::interp
