// executor.cpp — block after block: its functions, its motion, and the commands that come of it.
#include "interp/executor.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "base/text.h"
#include "base/units.h"
#include "nc/tables.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Slot;
using path::Command;
using path::Op;

namespace {

/// Blocks of a batch: enough to hide the cost of a pull, few enough to stay in the nearest cache.
constexpr std::size_t kProgramBatch = 64;

}  // namespace

// ------------------------------------------------------------------------------ the run

Executor::Executor(const nc::Dialect& dialect, const machine::Machine& machine,
                   Stream<Block>& blocks, const nc::BlockLocations* places, CycleExpander* cycles,
                   const InterpreterOptions& options, DiagnosticSink& sink)
    : dialect_(dialect),
      machine_(machine),
      is_lathe_(machine.is_lathe || dialect.is_of_lathe()),
      tool_offsets_(machine, is_lathe_),
      tool_names_(machine),
      cycles_(cycles),
      options_(options),
      reporter_(dialect, places, sink),
      rules_(dialect.rules()),
      program_(blocks, options.in_step ? 1 : kProgramBatch),
      clocks_(machine),
      probe_(options_.probe, options_.touches),
      carriers_(machine),
      dynamics_(machine, axes_, reporter_) {
    axes_.lower.fill(-std::numeric_limits<double>::infinity());
    axes_.upper.fill(std::numeric_limits<double>::infinity());
    axes_.word_scale.fill(1);
    if (is_lathe_) axes_.word_scale[index(Axis::X)] = 0.5;
    for (const machine::MachineAxis& axis : machine.axes) {
        const auto degrees = [&](double value) {
            return axis.is_rotary ? deg_from_rad(value) : value;
        };
        axes_.present |= bit(axis.axis);
        axes_.lower[index(axis.axis)] = degrees(axis.lower);
        axes_.upper[index(axis.axis)] = degrees(axis.upper);
        position_.base[index(axis.axis)] = degrees(axis.home);
        for (std::size_t point = 0; point < machine::kReferencePoints; ++point) {
            const std::optional<double> place =
                point == 0 ? axis.home : axis.further_homes[point - 1];
            if (!place) continue;
            axes_.reference_points[point][index(axis.axis)] = degrees(*place);
            axes_.has_reference_point[point] |= bit(axis.axis);
        }
    }
    set_up_spindles();
    for (const AxisValues& offset : machine.work_offsets)
        work_offsets_.push_back({.shift = offset});
    work_offset_ = rules_.default_work_offset;
    frames_.select_work_offset(work_offset_frame(work_offset_));
    frame_changed();
    clocks_.run.start(position_.base);
    position_.programmed = position_.here;
    for (std::size_t i = 0; i < 3; ++i)
        came_from_[static_cast<Eigen::Index>(i)] = position_.base[i];
    power_on();
}

std::size_t Executor::pull(std::span<Command> out) {
    output_.open(out);
    clocks_.timed = 0;
    follow_from_here();
    while (output_.has_room() && !has_ended()) execute_next();
    if (virtual_.axes.is_on()) follow_rotary();
    count_time();
    return output_.written();
}

void Executor::execute_next() {
    if (cycle_.blocks) {
        const Block* block = cycle_.blocks->next();
        if (block == nullptr) {
            finish_cycle();
            if (has_stages()) settle(cycle_.caller);
        } else {
            const Block& own = in_plane_of_cycle(*block);
            execute(own);
            if (has_stages()) settle(own);
        }
        return;
    }
    if (!patterns_.empty() && !patterns_.back().is_held) return go_to_next_position();
    const Block* block = program_.next();
    if (block == nullptr) return end_of_blocks();
    if (reporter_.locations() != nullptr && reporter_.locations()->is_behind_fault(*block)) {
        reporter_.stop();  // the control stops at the line that could not be read
        return;
    }
    if (move_plainly(*block) == Plainly::Executed) return;
    if (virtual_.axes.is_on()) {
        block = in_virtual(*block);
        if (block == nullptr) return;
    }
    if (shape_ && !require_shape_block(*block)) return;
    if (contour_ && !require_contour_block(*block)) return;
    execute(rules_.center_stays && acts(*block)
                ? position_words_.with_center(*block, motion_words())
                : *block);
    // What is no block of the control, or is left out, is none without motion either.
    const bool is_passed = open_line_ || (!has_ended() && !acts(*block));
    if (has_stages() && !is_passed) settle(*block);
    if (shape_ && !has_ended()) end_shape_block(*block);
    if (contour_ && !has_ended()) note_contour_block(*block);
    if (virtual_.axes.is_on() && !has_ended()) follow_rotary();
}

/// Whether commands pass through something that keeps them back; nearly never.
bool Executor::has_stages() const {
    return corners_.is_active() || is_any_comp_on() || smooth_approach_.is_active();
}

/// The program goes on behind this place, which nobody reads: what waits for its blocks goes as far
/// as it is known, and nothing is missing.
void Executor::end_where_stopped() {
    const Reporter::Silence silence(reporter_);
    finish_open_spline();
    leave_corners(diag::CornerWithoutMotion);
    if (is_any_comp_on()) flush_comp();
    reporter_.go_on();
    reporter_.end();
}

void Executor::end_of_blocks() {
    if (reporter_.locations() != nullptr && reporter_.locations()->stopped())
        return end_where_stopped();
    finish_open_spline();
    if (has_ended()) return;
    if (open_line_) reporter_.report(diag::AngleSecondMissing, *open_line_);
    if (has_ended()) return;
    leave_corners(diag::CornerWithoutMotion);
    if (has_ended()) return;
    if (smooth_approach_.is_active()) {
        const Block at =
            block_at(smooth_approach_.move().slow.source, smooth_approach_.move().slow.line);
        reporter_.report(diag::SoftNoDirection, at);
        return;
    }
    if (is_any_comp_on()) flush_comp();
    if (has_ended()) return;
    if (contour_ && (reporter_.locations() == nullptr || !reporter_.locations()->failed())) {
        Block nowhere{};
        nowhere.line = reporter_.locations() != nullptr
                           ? static_cast<std::uint32_t>(reporter_.locations()->lines())
                           : 0;
        reporter_.report(diag::ContourUnfinished, nowhere);
        return;
    }
    reporter_.end();
    // The reader has said already why it stopped.
    if (reporter_.locations() != nullptr && reporter_.locations()->failed()) {
        reporter_.stop();
        return;
    }
    const bool is_alarm = rules_.missing_end == nc::MissingEnd::Alarm;
    Block nowhere{};
    nowhere.line = reporter_.locations() != nullptr
                       ? static_cast<std::uint32_t>(reporter_.locations()->lines())
                       : 0;
    TextLocation place =
        reporter_.locations() != nullptr ? reporter_.locations()->place(nowhere) : TextLocation{};
    reporter_.report(is_alarm ? diag::EndOfRecord : diag::EndMissing, std::move(place));
}

/// Whether it is a block of the control that the operator lets run.
bool Executor::acts(const Block& block) const {
    if (block.kind != Block::Kind::Nc) return false;
    return block.skip < 0 ||
           ((1u << block.skip | block.further_skip_levels) & options_.skip_levels) == 0;
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
    const bool ends_spline =
        (spline_ && !continues_spline(block)) || (through_ && !continues_through(block));
    if (ends_spline) {
        finish_open_spline(&block);
        if (has_ended()) return;
    }
    ++block_count_;
    if (options_.max_blocks != 0 && block_count_ > options_.max_blocks) {
        --block_count_;
        reporter_.report(diag::TooManyBlocks, block)
            .arg(static_cast<std::size_t>(options_.max_blocks));
        return;
    }
    if (tilted_plane_.open && !require_block_of_open_plane(block)) return;
    if (block.function_count != 0) return run_functions(block);
    // Nothing but words: nearly every block.
    static constexpr Actions kNone{};
    if (block.has(Slot::Feed)) set_feed(block);
    if (block.has(Slot::Speed)) program_speed(block);
    if (block.has(Slot::Speed) || owes_speed_) update_spindle(block);
    if (wishes_corners()) wish_corner(block, kNone);
    const bool has_others = !position_words_.is_plain() || (block.given & nc::kPolarSlots) != 0;
    const Block* places = has_others ? with_positions(block) : &block;
    if (places == nullptr) return;
    move(*places, kNone);
    if (modal_cycles_.behind_motions) call_behind_motion(*places);
}

const Block* Executor::with_positions(const Block& block) {
    MotionWords words = motion_words();
    return position_words_.with_positions(block, words);
}

void Executor::run_functions(const Block& said) {
    const Block& block = with_depth_apart(said);
    Actions actions = apply_functions(block);
    if (has_ended()) return;
    actions.was_rapid = modal_.motion == Function::Rapid;
    actions.feed_before = modal_.feed;
    actions.had_feed = modal_.has_feed;
    actions.spindle_before = spindle_.told.mode;
    actions.coolant_before = coolant_;
    if (block.has(Slot::Feed)) set_feed(block);
    if (actions.tooth_feed) set_tooth_feed(block, *actions.tooth_feed);
    if (actions.preset != nullptr) preset_axes(block, *actions.preset);
    if (actions.corner != nullptr || wishes_corners()) wish_corner(block, actions);
    if (has_ended()) return;
    act_before_motion(block, actions);
    if (has_ended()) return;
    const bool was_in_cycle = cycle_.blocks.has_value();
    if (is_without_frames(actions) && !take_frames_off(block)) return;
    const Block* places = with_positions(block);
    if (places != nullptr && actions.angle != nullptr) {
        MotionWords words = motion_words();
        places = position_words_.with_angle(*places, *actions.angle, words);
    }
    if (places == nullptr) return;
    move_with_own_feed(*places, actions);
    if (frames_off_) put_frames_back(block);
    if (modal_cycles_.behind_motions) call_behind_motion(*places);
    if (actions.calls_defined && !has_ended() && !shape_) call_defined(block);
    if (has_ended()) return;
    if (cycle_.blocks && !was_in_cycle) {
        cycle_.after = actions;  // what the calling block does after its motion waits for the cycle
    } else {
        act_after_motion(block, actions);
    }
}

/// A feed that the block alone has acts in its motion, or in those of its cycle; behind it the
/// modal one does again.
void Executor::move_with_own_feed(const Block& places, const Actions& actions) {
    if (!actions.feed_once) return move(places, actions);
    const bool was_in_cycle = cycle_.blocks.has_value();
    const bool was_in_shape = shape_.has_value();
    const double feed = std::exchange(modal_.feed, *actions.feed_once);
    const bool has_feed = std::exchange(modal_.has_feed, true);
    move(places, actions);
    const auto take_back = [&](Modal& modal) {
        modal.feed = feed;
        modal.has_feed = has_feed;
    };
    if (cycle_.blocks && !was_in_cycle) return take_back(cycle_.modal_before);
    if (shape_ && !was_in_shape) take_back(shape_->modal);
    take_back(modal_);
}

// ------------------------------------------------------------------------------ out

/// Where a command goes that no corner waits for.
Command& Executor::behind_corners() {
    if (keeps_shape()) return shape_->commands.emplace_back();
    if (contour_) return contour_->commands.emplace_back();
    if (smooth_approach_.is_active()) return smooth_approach_.next();
    if (comp_3d_.is_on()) return comp_3d_.next();
    return compensation_.is_on() ? compensation_.next() : output_.next();
}

Command& Executor::put(Op op, const Block& block) {
    if (path::is_motion(op)) dangers_.begin_motion(op, position_.base);
    const bool waits = is_in_spline() && op != Op::Spline && !puts_span_;
    Command& command = waits                  ? spline_commands_.next()
                       : corners_.is_active() ? corners_.next()
                                              : behind_corners();
    command.op = op;
    fill_in(command, block);
    return command;
}

/// What the modal state says of a command.
void Executor::fill_in(Command& command, const Block& block) {
    const Op op = command.op;
    command.feed_mode = modal_.feed_mode;
    command.plane = modal_.plane;
    command.exact_stop = false;
    command.blending = blending(op);
    command.compress = block.is_of_cycle() ? 0 : compressing(op);
    command.machine_coordinates = false;
    command.is_unshifted = frames_off_.has_value();
    dynamics_.put_panel(command, block,
                        {modal_.taps, modal_.feed_mode, static_cast<std::uint32_t>(block_count_)});
    command.is_swivelled = false;
    command.moved = 0;
    command.source = block.source;
    command.line = block.line;
    command.cycle = block.is_of_cycle() ? block.context->number : 0;
    command.to = position_.base;
    command.turning = path::Turning::None;
    command.contact.clear();
    const bool reaches_comp = comp_3d_.is_on() || corners_.is_active();
    if (comp_.is_face_milling_acting() && reaches_comp && path::is_motion(op))
        command.contact.push_back({face_, path::Vec3::Zero(), path::Vec3::Zero()});
    command.virtual_axes = {};
    if (is_transformed()) put_orientation(command);
    command.text.clear();
}

Block Executor::block_at(SourceId source, std::uint32_t line) const {
    Block at{};
    locate(at, source, line);
    return at;
}

void Executor::locate(Block& at, SourceId source, std::uint32_t line) const {
    at.source = source;
    at.line = line;
    const bool is_call = cycle_.blocks && cycle_.caller.line == line;
    at.context = is_call ? &cycle_.context : nullptr;
}

}  // namespace kadr::interp
