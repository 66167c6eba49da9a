// threads.cpp — lines with the spindle geared to them: taps and threads.
#include <cmath>
#include <optional>
#include <string_view>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "interp/block_words.h"
#include "interp/channel.h"
#include "interp/motion_checks.h"
#include "interp/motions.h"
#include "interp/path_smoothing.h"
#include "interp/spindles.h"
#include "interp/stages.h"
#include "interp/tool_in_use.h"
#include "path/linear.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Slot;
using nc::SlotMask;
using path::Command;
using path::FeedMode;
using path::linear;
using path::Op;
using path::SpindleMode;
using path::Vec3;

/// A line with the spindle geared to it, in as out: the spindle turns as the sign of the pitch
/// tells, and stands at the end with the axis.
void Motions::tap(const Block& block, const Target& target) {
    const SlotMask words = block.given & nc::kCenterSlots;
    const double pitch = words == 0 ? 0 : block.at(first_slot(words));
    if (pitch == 0) {
        (words == 0 ? reporter_.report(diag::TapPitchMissing, block)
                    : reporter_.report(diag::TapPitchMissing, block, first_slot(words)));
        return;
    }
    if (spindle_.has_cutting_speed || !(spindle_.speed > 0)) {
        reporter_.report(diag::TapSpeedMissing, block);
        return;
    }
    if (tool_.has_changed) channel_.tool.activate_length(block, target.moved);
    if (!channel_.checks.require_within_limits(block, target.base, target.moved)) return;
    const bool is_cw = (pitch > 0) == (modal_.motion == Function::TapIn);
    channel_.spindles.turn(is_cw ? SpindleMode::Cw : SpindleMode::Ccw);
    channel_.spindles.update_spindle(block);
    path::Motion& motion = channel_.stages.put(Op::Line, block, &target.orientation).motion();
    motion.to = target.base;
    motion.moved = target.moved;
    motion.feed_mode = FeedMode::PerRevolution;
    motion.feed = std::abs(pitch);
    motion.exact_stop = motion.keeps_feed = motion.ignores_hold = true;
    arrive(target);
    channel_.spindles.turn(SpindleMode::Stop);
    channel_.spindles.update_spindle(block);
}

/// A line geared to the spindle as it turns. Its pitch counts along the axis of the longer travel,
/// so a revolution takes the tool so much farther along the line as that is longer.
void Motions::thread(const Block& block, const Target& target, const Actions& actions) {
    const Vec3 delta = linear(target.here) - linear(position_.here());
    const std::optional<double> pitch = thread_pitch(block, delta);
    if (!pitch) return;
    const double along = delta.cwiseAbs().maxCoeff();
    const std::optional<double> change = thread_change(block, *pitch, along);
    if (!change) return;
    if (!require_thread_spindle(block)) return;
    channel_.checks.check_tool(block);
    if (tool_.has_changed) channel_.tool.activate_length(block, target.moved);
    if (!channel_.checks.require_within_limits(block, target.base, target.moved)) return;
    position_.note_motion();
    path::Motion& motion = channel_.stages.put(Op::Thread, block, &target.orientation).motion();
    motion.to = target.base;
    motion.moved = target.moved;
    motion.exact_stop = channel_.smoothing.stops_exactly(actions.exact_stop);
    motion.feed_mode = FeedMode::PerRevolution;
    const double length = (linear(target.base) - linear(position_.base())).norm();
    const double by_distance = along > 0 ? length / along : 1;
    motion.feed = *pitch * by_distance;
    motion.shape = path::ThreadShape{*change * by_distance, actions.thread_start_deg};
    arrive(target);
}

/// The spindle, which the thread is geared to, turns.
Done Motions::require_thread_spindle(const Block& block) {
    if (spindle_.mode != SpindleMode::Cw && spindle_.mode != SpindleMode::Ccw) {
        reporter_.report(diag::RevolutionFeedStands, block);
        return kFailed;
    }
    if (spindle_.has_cutting_speed && reported_.first_time(RunNotice::ThreadSpeed))
        reporter_.report(diag::ThreadUnderCuttingSpeed, block);
    return kDone;
}

/// By how much the pitch changes in a revolution; 0 of an even thread. In a revolution the tool
/// goes by the pitch, so its square changes by twice the change times the distance: it must not
/// come to zero.
std::optional<double> Motions::thread_change(const Block& block, double pitch, double distance) {
    if (!nc::has_fact(modal_.motion, nc::Fact::VaryingThread)) return 0;
    const nc::Invocation* const word = block.find(Function::ThreadChange);
    if (word == nullptr) {
        reporter_.report(diag::ThreadChangeMissing, block);
        return std::nullopt;
    }
    const double programmed =
        block.argument(*word, nc::parameter_of<Function::ThreadChange>("change"));
    const double change = modal_.motion == Function::ThreadDecreasing ? -programmed : programmed;
    if (pitch * pitch + 2 * change * distance > 0) return change;
    reporter_.report(diag::ThreadPitchVanishes, block, Function::ThreadChange)
        .arg(round_to(pitch * pitch / (-2 * change), 4));
    return std::nullopt;
}

/// The pitch that the block or, on some controls, F gives; nothing if it was reported missing.
std::optional<double> Motions::thread_pitch(const Block& block, const Vec3& delta) {
    constexpr double kEqualTravels = 1e-6;  // mm: at 45 degrees either axis will do
    const SlotMask words = block.given & nc::kCenterSlots;
    Eigen::Index longest = 0;
    const double most = delta.cwiseAbs().maxCoeff(&longest);
    const std::string_view name = kAxisNames[static_cast<std::size_t>(longest)];
    // The blocks of a cycle are neutral ones: they have a word for it.
    if (rules_.thread_pitch_is_feed && !block.is_of_cycle()) {
        if (words != 0) warn_arc_word(block, words);
        if (modal_.has_feed && modal_.feed > 0) return modal_.feed;
        reporter_.report(diag::ThreadPitchMissing, block).arg(name);
        return std::nullopt;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto word = static_cast<Slot>(static_cast<std::size_t>(Slot::CenterX) + axis);
        const bool is_long =
            std::abs(delta[static_cast<Eigen::Index>(axis)]) >= most - kEqualTravels;
        if (is_long && block.has(word) && block.at(word) > 0) return block.at(word);
    }
    (words == 0 ? reporter_.report(diag::ThreadPitchMissing, block)
                : reporter_.report(diag::ThreadPitchMissing, block, first_slot(words)))
        .arg(name);
    return std::nullopt;
}

}  // namespace kadr::interp
