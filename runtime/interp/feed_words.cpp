// feed_words.cpp — what a degree counts in F, and a feed that is a polynomial.
// source: SINUMERIK reference 2.3 (FGROUP, FGREF), 3.2 (FPO)
#include "interp/feed_words.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "base/units.h"
#include "interp/block_words.h"
#include "interp/channel.h"
#include "interp/stages.h"
#include "interp/transformation.h"
#include "nc/parameters.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using nc::Slot;
using path::FeedMode;

namespace {

/// $TC_DPNT among the data of a tool on which nothing else depends.
constexpr std::int64_t kTeeth = 100;

}  // namespace

FeedWords::FeedWords(Channel& channel)
    : channel_(channel),
      machine_(channel.state.machine),
      tool_offsets_(channel.state.tool.tool_offsets),
      reporter_(channel.state.reporter),
      rules_(channel.state.rules),
      block_count_(channel.state.motion.block_count),
      modal_(channel.state.motion.modal),
      position_(channel.state.motion.position),
      tool_(channel.state.tool.tool),
      dynamics_(channel.state.motion.dynamics),
      axes_(channel.state.axes) {}

bool FeedWords::may_count_degrees(const Block& block) const {
    constexpr auto kFollowers = static_cast<AxisMask>(~kLinearXYZ);
    const bool has_followers = (block.given & axes_.present & kFollowers) != 0;
    return has_followers && (rules_.feed_of_all_axes || block.has_inch_feed) &&
           !channel_.transformation.is_transformed();
}

void FeedWords::count_degrees(const Block& block, path::Motion& motion) const {
    AxisMask moving = 0;
    for (const machine::MachineAxis& axis : machine_.axes) {
        const std::size_t i = index(axis.axis);
        if (motion.to[i] != position_.base()[i]) moving |= bit(axis.axis);
    }
    const auto turning = static_cast<AxisMask>(moving & kRotaryABC);
    const bool turns_alone = moving == turning;
    const bool counts_all = rules_.feed_of_all_axes && !turns_alone && (moving & ~kLinearXYZ) != 0;
    const bool has_inches = block.has_inch_feed && turning != 0 && (turns_alone || counts_all);
    if (!counts_all && !has_inches) return;
    path::Dynamics& programmed = motion.dynamics.made();
    if (counts_all) programmed.feed_axes = axes_.present;
    constexpr double kSame = 1e-9;  // mm: a program may give the control's radius
    for (double& radius : programmed.feed_radius)
        if (has_inches && std::abs(radius - path::kRadiusOfDegrees) < kSame) radius *= kMmPerInch;
}

void FeedWords::take_polynomial(const Block& block, const Invocation& invocation) {
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

void FeedWords::report_varying_feed(const path::Command& command, double feed) {
    const Block at = channel_.stages.block_at(command.source, command.line);
    reporter_.report(diag::FeedCourseNotPositive, at).arg(round_to(feed, 3));
}

void FeedWords::select_feed_mode(Function member) {
    const FeedMode before = modal_.feed_mode;
    modal_.feed_mode = feed_mode_of(member);
    if (modal_.feed_mode == before || !rules_.feed_deleted_on_mode_change) return;
    modal_.has_feed = false;
    tooth_feed_ = 0;
}

void FeedWords::set_feed(const Block& block) {
    modal_.feed = block.at(Slot::Feed);
    modal_.has_feed = true;
    tooth_feed_ = 0;
}

void FeedWords::set_tooth_feed(const Block& block, double feed) {
    if (modal_.feed_mode != path::FeedMode::PerRevolution) {
        reporter_.report(diag::ToothFeedIdle, block, Function::ToothFeed);
        return;
    }
    if (!(feed > 0)) {
        reporter_.report(diag::FeedNotPositive, block, Function::ToothFeed).arg(feed);
        return;
    }
    tooth_feed_ = feed;
    take_tooth_feed();
    if (!(modal_.feed > 0)) reporter_.report(diag::TeethUnknown, block, Function::ToothFeed);
}

void FeedWords::take_tooth_feed() {
    if (tooth_feed_ == 0) return;
    modal_.feed = tooth_feed_ * tool_offsets_.datum(tool_.edge_number(), kTeeth);
    modal_.has_feed = true;
}

}  // namespace kadr::interp
