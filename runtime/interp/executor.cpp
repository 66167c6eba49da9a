// executor.cpp — block after block: its functions, its motion, and the commands that come of it.
#include "interp/executor.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "interp/answers.h"
#include "interp/block_functions.h"
#include "interp/channel.h"
#include "interp/contour_tables.h"
#include "interp/cornering.h"
#include "interp/cycle_shapes.h"
#include "interp/cycles.h"
#include "interp/feed_words.h"
#include "interp/motions.h"
#include "interp/programmed_frames.h"
#include "interp/radius_compensation.h"
#include "interp/spindles.h"
#include "interp/splines.h"
#include "interp/stages.h"
#include "interp/tilted_planes.h"
#include "interp/virtual_plane.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Slot;
using path::Command;

// ------------------------------------------------------------------------------ the run

/// All references have to live as long.
Executor::Executor(Channel& channel)
    : channel_(channel),
      options_(channel.state.options),
      reporter_(channel.state.reporter),
      rules_(channel.state.rules),
      output_(channel.state.stage.output),
      clocks_(channel.state.clocks),
      block_count_(channel.state.motion.block_count),
      modal_(channel.state.motion.modal),
      position_(channel.state.motion.position),
      frames_(channel.state.frame.frames),
      spindle_(channel.state.spindle.spindle),
      tool_(channel.state.tool.tool),
      area_(channel.state.stage.area),
      position_words_(channel.state.motion.position_words),
      tilted_plane_(channel.state.tool.tilted_plane),
      virtual_(channel.state.tool.virtual_axes),
      smooth_approach_(channel.state.stage.smooth_approach),
      coolant_(channel.state.spindle.coolant),
      owes_speed_(channel.state.spindle.owes_speed),
      spline_(channel.state.cycle.spline),
      through_(channel.state.cycle.through),
      taps_rigidly_(channel.state.cycle.taps_rigidly),
      unplaced_(channel.state.motion.unplaced),
      reported_(channel.state.reported),
      axes_(channel.state.axes),
      length_shift_(channel.state.motion.length_shift),
      modal_cycles_(channel.state.cycle.modal_cycles),
      cycle_(channel.state.cycle.cycle),
      shape_(channel.state.cycle.shape),
      contour_(channel.state.cycle.contour),
      callers_(channel.state.cycle.callers) {}

void Executor::start() {
    channel_.spindles.set_up_spindles();
    channel_.frames.begin();
    clocks_.run.start(position_.base());
    position_.name();
    channel_.functions.power_on();
}

std::size_t Executor::pull(std::span<Command> out) {
    output_.open(out);
    clocks_.timed = 0;
    look_again();
    channel_.virtual_plane.follow_from_here();
    while (output_.has_room() && !reporter_.has_ended()) execute_next();
    if (virtual_.axes.is_on()) channel_.virtual_plane.follow_rotary();
    channel_.answers.count_time();
    return output_.written();
}

void Executor::execute_next() {
    const Callers::Kind caller = callers_.kind();
    const Block* block = callers_.next();
    if (caller != Callers::Kind::Program) {
        look_again();
        return caller == Callers::Kind::Cycle ? execute_of_cycle(block)
                                              : channel_.cycles.go_to_position(block);
    }
    if (block == nullptr) return end_of_blocks();
    if (reporter_.locations() != nullptr && reporter_.locations()->is_behind_fault(*block)) {
        reporter_.stop();  // the control stops at the line that could not be read
        return;
    }
    if (move_plainly(*block) == Plainly::Executed) return;
    look_again();
    if (virtual_.axes.is_on()) {
        block = channel_.virtual_plane.in_virtual(*block);
        if (block == nullptr) return;
    }
    if (shape_ && !channel_.shapes.require_shape_block(*block)) return;
    if (contour_ && !channel_.contours.require_contour_block(*block)) return;
    execute(rules_.center_stays && acts(*block)
                ? position_words_.with_center(*block, channel_.motions.motion_words())
                : *block);
    // What is no block of the control, or is left out, is none without motion either.
    const bool is_passed = open_line_ || (!reporter_.has_ended() && !acts(*block));
    if (channel_.stages.has_stages() && !is_passed) channel_.stages.settle(*block);
    if (shape_ && !reporter_.has_ended()) channel_.shapes.end_shape_block(*block);
    if (contour_ && !reporter_.has_ended()) channel_.contours.note_contour_block(*block);
    if (virtual_.axes.is_on() && !reporter_.has_ended()) channel_.virtual_plane.follow_rotary();
}

/// A block of the cycle that runs; null: it has come to its end.
void Executor::execute_of_cycle(const Block* block) {
    if (block == nullptr) {
        channel_.cycles.finish_cycle();
        if (channel_.stages.has_stages()) channel_.stages.settle(cycle_.caller);
        return;
    }
    const Block& own = channel_.cycles.in_plane_of_cycle(*block);
    execute(own);
    if (channel_.stages.has_stages()) channel_.stages.settle(own);
}

/// The program goes on behind this point, which nobody reads: what waits for its blocks goes as far
/// as it is known, and nothing is missing.
void Executor::end_where_stopped() {
    const Reporter::Silence silence(reporter_);
    channel_.splines.finish_open_spline();
    channel_.cornering.leave_corners(diag::CornerWithoutMotion);
    if (channel_.compensation.is_any_comp_on()) channel_.compensation.flush_comp();
    reporter_.go_on();
    reporter_.end();
}

void Executor::end_of_blocks() {
    if (reporter_.locations() != nullptr && reporter_.locations()->stopped())
        return end_where_stopped();
    channel_.splines.finish_open_spline();
    if (reporter_.has_ended()) return;
    if (open_line_) reporter_.report(diag::AngleSecondMissing, *open_line_);
    if (reporter_.has_ended()) return;
    channel_.cornering.leave_corners(diag::CornerWithoutMotion);
    if (reporter_.has_ended()) return;
    if (smooth_approach_.is_active()) {
        const Block at = channel_.stages.block_at(smooth_approach_.move().slow.source,
                                                  smooth_approach_.move().slow.line);
        reporter_.report(diag::SoftNoDirection, at);
        return;
    }
    if (channel_.compensation.is_any_comp_on()) channel_.compensation.flush_comp();
    if (reporter_.has_ended()) return;
    if (contour_ && (reporter_.locations() == nullptr || !reporter_.locations()->failed())) {
        Block nowhere{};
        nowhere.line = reporter_.locations() != nullptr
                           ? static_cast<std::uint32_t>(reporter_.locations()->lines())
                           : 0;
        reporter_.report(diag::ContourUnfinished, nowhere);
        return;
    }
    reporter_.end();
    // The reader has reported already why it stopped.
    if (reporter_.locations() != nullptr && reporter_.locations()->failed()) {
        reporter_.stop();
        return;
    }
    const bool is_alarm = rules_.missing_end == nc::MissingEnd::Alarm;
    Block nowhere{};
    nowhere.line = reporter_.locations() != nullptr
                       ? static_cast<std::uint32_t>(reporter_.locations()->lines())
                       : 0;
    TextLocation location = reporter_.locations() != nullptr
                                ? reporter_.locations()->location(nowhere)
                                : TextLocation{};
    reporter_.report(is_alarm ? diag::EndOfRecord : diag::EndMissing, std::move(location));
}

bool Executor::acts(const Block& block) const {
    if (block.kind != Block::Kind::Nc) return false;
    return block.skip_level < 0 ||
           ((1u << block.skip_level | block.further_skip_levels) & options_.skip_levels) == 0;
}

void Executor::execute(const Block& block) {
    if (!acts(block)) {
        if (block.kind == Block::Kind::Raw) reporter_.report(diag::RawInCycle, block);
        return;
    }
    if (open_line_) return close_line(block);
    if (block.function_count != 0 && opens_line(block)) return;
    run(block);
}

void Executor::run(const Block& block) {
    const bool ends_spline = (spline_ && !channel_.splines.continues_spline(block)) ||
                             (through_ && !channel_.splines.continues_through(block));
    if (ends_spline) {
        channel_.splines.finish_open_spline(&block);
        if (reporter_.has_ended()) return;
    }
    ++block_count_;
    if (options_.max_blocks != 0 && block_count_ > options_.max_blocks) {
        --block_count_;
        reporter_.report(diag::TooManyBlocks, block)
            .arg(static_cast<std::size_t>(options_.max_blocks));
        return;
    }
    if (tilted_plane_.open && !channel_.tilted_planes.require_block_of_open_plane(block)) return;
    if (block.function_count != 0) return run_functions(block);
    // Nothing but words: nearly every block.
    static constexpr Actions kNone{};
    if (block.has(Slot::Feed)) channel_.feed.set_feed(block);
    if (block.has(Slot::Speed)) channel_.spindles.program_speed(block);
    if (block.has(Slot::Speed) || owes_speed_) channel_.spindles.update_spindle(block);
    if (channel_.cornering.wishes_corners()) channel_.cornering.wish_corner(block, kNone);
    const bool has_others = !position_words_.is_plain() || (block.given & nc::kPolarSlots) != 0;
    const Block* places = has_others ? with_positions(block) : &block;
    if (places == nullptr) return;
    channel_.motions.move(*places, kNone);
    if (modal_cycles_.behind_motions) channel_.cycles.call_behind_motion(*places);
}

const Block* Executor::with_positions(const Block& block) {
    MotionWords words = channel_.motions.motion_words();
    return position_words_.with_positions(block, words);
}

void Executor::run_functions(const Block& said) {
    const Block& block = channel_.cycles.with_depth_apart(said);
    Actions actions = channel_.functions.apply_functions(block);
    if (reporter_.has_ended()) return;
    actions.was_rapid = modal_.motion == Function::Rapid;
    actions.feed_before = modal_.feed;
    actions.had_feed = modal_.has_feed;
    actions.spindle_before = spindle_.commanded.mode;
    actions.coolant_before = coolant_;
    if (block.has(Slot::Feed)) channel_.feed.set_feed(block);
    if (actions.tooth_feed) channel_.feed.set_tooth_feed(block, *actions.tooth_feed);
    if (actions.preset != nullptr) channel_.motions.preset_axes(block, *actions.preset);
    if (actions.corner != nullptr || channel_.cornering.wishes_corners())
        channel_.cornering.wish_corner(block, actions);
    if (reporter_.has_ended()) return;
    channel_.functions.act_before_motion(block, actions);
    if (reporter_.has_ended()) return;
    const bool was_in_cycle = callers_.runs(Callers::Kind::Cycle);
    if (channel_.frames.is_without_frames(actions) && !channel_.frames.take_frames_off(block))
        return;
    const Block* places = with_positions(block);
    if (places != nullptr && actions.angle != nullptr) {
        MotionWords words = channel_.motions.motion_words();
        places = position_words_.with_angle(*places, *actions.angle, words);
    }
    if (places == nullptr) return;
    move_with_own_feed(*places, actions);
    if (channel_.frames.are_off()) channel_.frames.put_frames_back(block);
    if (modal_cycles_.behind_motions) channel_.cycles.call_behind_motion(*places);
    if (actions.calls_defined && !reporter_.has_ended() && !shape_)
        channel_.cycles.call_defined(block);
    if (reporter_.has_ended()) return;
    if (callers_.runs(Callers::Kind::Cycle) && !was_in_cycle) {
        cycle_.after = actions;  // what the calling block does after its motion waits for the cycle
    } else {
        channel_.functions.act_after_motion(block, actions);
    }
}

/// A feed that the block alone has acts in its motion, or in those of its cycle; behind it the
/// modal one does again.
void Executor::move_with_own_feed(const Block& places, const Actions& actions) {
    if (!actions.feed_once) return channel_.motions.move(places, actions);
    const bool was_in_cycle = callers_.runs(Callers::Kind::Cycle);
    const bool was_in_pattern = callers_.runs(Callers::Kind::Pattern);
    const bool was_in_shape = shape_.has_value();
    channel_.feed.begin_block_feed(*actions.feed_once);
    channel_.motions.move(places, actions);
    // The strokes of a cycle go by it, and what comes behind the cycle does not.
    if (callers_.runs(Callers::Kind::Cycle) && !was_in_cycle)
        return cycle_.modal_before.end_block_feed();
    if (callers_.runs(Callers::Kind::Pattern) && !was_in_pattern) return;  // it ends with that
    if (shape_ && !was_in_shape) shape_->modal.end_block_feed();
    channel_.feed.end_block_feed();
}

// ------------------------------------------------------------------------------ out

}  // namespace kadr::interp
