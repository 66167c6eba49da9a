// plain_moves.cpp — straight moves of which nothing needs a second look, as nearly every block is
// one.
//
// What motion.cpp does in many steps, each with its question, is here one step behind all the
// questions. Whatever is not plain is left to motion.cpp, as if nobody had looked here.
#include <bit>

#include "interp/channel.h"
#include "interp/cornering.h"
#include "interp/danger_watch.h"
#include "interp/executor.h"
#include "interp/feed_words.h"
#include "interp/motion_checks.h"
#include "interp/path_smoothing.h"
#include "interp/splines.h"
#include "interp/stages.h"
#include "interp/transformation.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::SlotMask;
using path::Command;
using path::Op;

/// Nothing that waits, repeats or turns acts on a move to a position.
bool Executor::is_plain_state() const {
    const bool waits = shape_ || contour_ || open_line_ || channel_.splines.is_in_spline() ||
                       modal_cycles_.behind_motions;
    const bool has_mode = channel_.transformation.is_transformed() ||
                          modal_cycles_.modal.is_active || taps_rigidly_ ||
                          !position_words_.is_plain() || modal_.is_incremental || unplaced_ != 0 ||
                          owes_speed_ || tilted_plane_.carries || tilted_plane_.on_tables ||
                          tilted_plane_.open.has_value();
    return !channel_.stages.has_stages() && !area_.acts() && !channel_.cornering.wishes_corners() &&
           !waits && !has_mode && !tool_.has_changed && frames_.is_shift();
}

/// Words of axes alone, each a position, for a line or a rapid.
bool Executor::is_plain_block(const Block& block) const {
    const SlotMask others = block.given & ~SlotMask{axes_.present};
    const bool is_of_positions =
        block.given != 0 && others == 0 && block.incremental == 0 && block.rotary_approaches == 0;
    return block.kind == Block::Kind::Nc && block.function_count == 0 && block.skip_level < 0 &&
           block.x_measure == nc::XMeasure::Modal && is_of_positions;
}

/// A block that is not a plain one is left alone.
Executor::Plainly Executor::move_plainly(const Block& block) {
    if (!is_plain_block(block)) return Plainly::NotPlain;
    if (!is_plain_) is_plain_ = is_plain_state();  // a plain move does not change it
    if (!*is_plain_) return Plainly::NotPlain;
    const Function motion = block.motion != Function::None ? block.motion : modal_.motion;
    const bool is_rapid = motion == Function::Rapid;
    if (is_rapid
            ? !reported_.has_reported(RunNotice::Rapid) && spindle_.mode == path::SpindleMode::Stop
            : motion != Function::Line)
        return Plainly::NotPlain;
    if (!is_rapid && channel_.feed.may_count_degrees(block)) return Plainly::NotPlain;
    if (options_.max_blocks != 0 && block_count_ >= options_.max_blocks) return Plainly::NotPlain;
    const AxisValues& shift = frames_.shift_values();
    AxisValues to;  // in the base system
    for (SlotMask rest = block.given; rest != 0; rest &= rest - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(rest));
        to[i] = block.values[i] * axes_.word_scale[i] + shift[i];
        const double at = to[i] + length_shift_[i];
        if (!(at >= axes_.lower[i] && at <= axes_.upper[i])) return Plainly::NotPlain;
    }

    ++block_count_;
    modal_.move_by(motion);
    if (!is_rapid && !channel_.checks.require_feed(block, "line")) return Plainly::Executed;
    position_.note_motion();
    path::Motion& line = channel_.stages.put_straight_out(is_rapid ? Op::Rapid : Op::Line, block);
    line.moved = static_cast<AxisMask>(block.given);
    line.exact_stop = channel_.smoothing.stops_exactly();
    line.feed = is_rapid ? 0 : modal_.feed;
    const path::Vec3 before{position_.base()[0], position_.base()[1], position_.base()[2]};
    bool is_elsewhere = false;
    for (SlotMask rest = block.given; rest != 0; rest &= rest - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(rest));
        is_elsewhere |= i < 3 && to[i] != position_.base()[i];
        line.to[i] = to[i];
        position_.arrive_on(i, block.values[i] * axes_.word_scale[i], to[i]);
    }
    if (spindle_.has_cutting_speed && (block.given & bit(nc::Slot::X)) != 0) [[unlikely]]
        channel_.dangers.watch_cutting_speed(block, before[0] - shift[0], position_.here()[0]);
    if (is_elsewhere) position_.come_from(before);
    return Plainly::Executed;
}

}  // namespace kadr::interp
