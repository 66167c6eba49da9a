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
#include "interp/discarding_sink.h"
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
      places_(places),
      cycles_(cycles),
      options_(options),
      sink_(&sink),
      rules_(dialect.rules()),
      program_(blocks, options.in_step ? 1 : kProgramBatch),
      clocks_(machine),
      carriers_(machine) {
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
    while (output_.has_room() && !ended_) execute_next();
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
    if (places_ != nullptr && places_->is_behind_fault(*block)) {
        ended_ = alarmed_ = true;  // the control stops at the line that could not be read
        return;
    }
    if (move_plainly(*block) == Plainly::Executed) return;
    if (virtual_.axes.is_on()) {
        block = in_virtual(*block);
        if (block == nullptr) return;
    }
    if (shape_ && !require_shape_block(*block)) return;
    if (contour_ && !require_contour_block(*block)) return;
    execute(rules_.center_stays ? with_center(*block) : *block);
    // What is no block of the control, or is left out, is none without motion either.
    const bool is_passed = open_line_ || (!ended_ && !acts(*block));
    if (has_stages() && !is_passed) settle(*block);
    if (shape_ && !ended_) end_shape_block(*block);
    if (contour_ && !ended_) note_contour_block(*block);
    if (virtual_.axes.is_on() && !ended_) follow_rotary();
}

/// Whether commands pass through something that keeps them back; nearly never.
bool Executor::has_stages() const {
    return corners_.is_active() || is_any_comp_on() || smooth_approach_.is_active();
}

/// The program goes on behind this place, which nobody reads: what waits for its blocks goes as far
/// as it is known, and nothing is missing.
void Executor::end_where_stopped() {
    DiscardingSink nobody;
    DiagnosticSink* const sink = std::exchange(sink_, &nobody);
    finish_open_spline();
    leave_corners(diag::CornerWithoutMotion);
    if (is_any_comp_on()) flush_comp();
    sink_ = sink;
    ended_ = true;
    alarmed_ = false;
}

void Executor::end_of_blocks() {
    if (places_ != nullptr && places_->stopped()) return end_where_stopped();
    finish_open_spline();
    if (ended_) return;
    if (open_line_) report(diag::AngleSecondMissing, *open_line_);
    if (ended_) return;
    leave_corners(diag::CornerWithoutMotion);
    if (ended_) return;
    if (smooth_approach_.is_active()) {
        const Block at =
            block_at(smooth_approach_.move().slow.source, smooth_approach_.move().slow.line);
        report(diag::SoftNoDirection, at);
        return;
    }
    if (is_any_comp_on()) flush_comp();
    if (ended_) return;
    if (contour_ && (places_ == nullptr || !places_->failed())) {
        Block nowhere{};
        nowhere.line = places_ != nullptr ? static_cast<std::uint32_t>(places_->lines()) : 0;
        report(diag::ContourUnfinished, nowhere);
        return;
    }
    ended_ = true;
    // The reader has said already why it stopped.
    if (places_ != nullptr && places_->failed()) {
        alarmed_ = true;
        return;
    }
    const bool is_alarm = rules_.missing_end == nc::MissingEnd::Alarm;
    Block nowhere{};
    nowhere.line = places_ != nullptr ? static_cast<std::uint32_t>(places_->lines()) : 0;
    TextLocation place = places_ != nullptr ? places_->place(nowhere) : TextLocation{};
    report(is_alarm ? diag::EndOfRecord : diag::EndMissing, std::move(place));
}

/// Whether it is a block of the control that the operator lets run.
bool Executor::acts(const Block& block) const {
    if (block.kind != Block::Kind::Nc) return false;
    return block.skip < 0 ||
           ((1u << block.skip | block.further_skip_levels) & options_.skip_levels) == 0;
}

void Executor::execute(const Block& block) {
    if (!acts(block)) {
        if (block.kind == Block::Kind::Raw) report(diag::RawInCycle, block);
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
        if (ended_) return;
    }
    ++block_count_;
    if (options_.max_blocks != 0 && block_count_ > options_.max_blocks) {
        --block_count_;
        report(diag::TooManyBlocks, block).arg(static_cast<std::size_t>(options_.max_blocks));
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
    const bool has_others =
        polar_.is_on || polar_.is_by_points || (block.given & nc::kPolarSlots) != 0;
    const Block* places = has_others ? with_positions(block) : &block;
    if (places == nullptr) return;
    move(*places, kNone);
    if (modal_cycles_.behind_motions) call_behind_motion(*places);
}

void Executor::run_functions(const Block& said) {
    const Block& block = with_depth_apart(said);
    Actions actions = apply_functions(block);
    if (ended_) return;
    actions.was_rapid = modal_.motion == Function::Rapid;
    actions.feed_before = modal_.feed;
    actions.had_feed = modal_.has_feed;
    actions.spindle_before = spindle_.told.mode;
    actions.coolant_before = coolant_;
    if (block.has(Slot::Feed)) set_feed(block);
    if (actions.tooth_feed) set_tooth_feed(block, *actions.tooth_feed);
    if (actions.preset != nullptr) preset_axes(block, *actions.preset);
    if (actions.corner != nullptr || wishes_corners()) wish_corner(block, actions);
    if (ended_) return;
    act_before_motion(block, actions);
    if (ended_) return;
    const bool was_in_cycle = cycle_.blocks.has_value();
    if (is_without_frames(actions) && !take_frames_off(block)) return;
    const Block* places = with_positions(block);
    if (places != nullptr && actions.angle != nullptr) places = with_angle(*places, *actions.angle);
    if (places == nullptr) return;
    move_with_own_feed(*places, actions);
    if (frames_off_) put_frames_back(block);
    if (modal_cycles_.behind_motions) call_behind_motion(*places);
    if (actions.calls_defined && !ended_ && !shape_) call_defined(block);
    if (ended_) return;
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
    put_panel(command, block);
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
    move_to(at, source, line);
    return at;
}

void Executor::move_to(Block& at, SourceId source, std::uint32_t line) const {
    at.source = source;
    at.line = line;
    const bool is_call = cycle_.blocks && cycle_.caller.line == line;
    at.context = is_call ? &cycle_.context : nullptr;
}

DiagnosticBuilder Executor::report(const DiagnosticRow& row, const Block& block) {
    TextLocation place =
        places_ != nullptr ? places_->place(block) : TextLocation{{}, block.line, 1, 1, {}};
    DiagnosticBuilder builder = report(row, std::move(place));
    if (block.is_of_cycle())
        builder.note("inside the cycle `" + std::string(block.context->cycle) + "`");
    return note_calls(std::move(builder), block);
}

DiagnosticBuilder Executor::report(const DiagnosticRow& row, const Block& block, Slot slot) {
    if (places_ == nullptr || block.is_of_cycle()) return report(row, block);
    return note_calls(report(row, places_->place(block, slot)), block);
}

DiagnosticBuilder Executor::report(const DiagnosticRow& row, const Block& block,
                                   Function function) {
    if (places_ == nullptr || block.is_of_cycle()) return report(row, block);
    return note_calls(report(row, places_->place(block, function)), block);
}

namespace {

/// Characters of a text; columns count them, not bytes.
std::string characters(std::string_view text, std::size_t first, std::size_t count) {
    const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; };
    std::string found;
    std::size_t at = 0;
    for (const char c : text) {
        at += begins(c) ? 1 : 0;
        if (at > first && at <= first + count) found += c;
    }
    return found;
}

/// Where an argument stands in a call, `TRAORI(1,0,0,1)`: bytes. All of the call if it has no such
/// argument.
std::string_view argument_in(std::string_view call, std::size_t argument) {
    std::size_t begin = call.find('(');
    int depth = 0;
    for (std::size_t at = begin; at < call.size(); ++at) {
        if (call[at] == '(') ++depth;
        if (call[at] == ')') --depth;
        const bool ends = (call[at] == ',' && depth == 1) || depth == 0;
        if (!ends) continue;
        if (argument == 0) {
            while (begin + 1 < at && call[begin + 1] == ' ') ++begin;
            while (at > begin + 2 && call[at - 1] == ' ') --at;
            return call.substr(begin + 1, at - begin - 1);
        }
        begin = at;
        --argument;
    }
    return call;
}

}  // namespace

DiagnosticBuilder Executor::report(const DiagnosticRow& row, const Block& block, Function function,
                                   std::size_t argument) {
    if (places_ == nullptr || block.is_of_cycle()) return report(row, block);
    TextLocation place = places_->place(block, function);
    const std::string call = characters(place.text, place.column - 1, place.length);
    const std::string_view said = argument_in(call, argument);
    const auto before = static_cast<std::size_t>(said.data() - call.data());
    place.column +=
        static_cast<std::uint32_t>(count_code_points(std::string_view(call).substr(0, before)));
    place.length = static_cast<std::uint32_t>(std::max<std::size_t>(1, count_code_points(said)));
    return note_calls(report(row, std::move(place)), block);
}

std::string Executor::word_of(const Block& block, Function function) const {
    const std::string name(nc::info(function).name);
    const bool is_said = block.motion == function || block.find(function) != nullptr;
    if (places_ == nullptr || block.is_of_cycle() || !is_said) return name;
    const TextLocation place = places_->place(block, function);
    const std::string word = characters(place.text, place.column - 1, place.length);
    return word.empty() ? name : word;
}

std::string Executor::spelling_of(Function function) const {
    const nc::DialectTables& tables = dialect_.tables();
    for (const nc::FormId id : tables.forms_of[static_cast<std::size_t>(function)]) {
        const nc::Form& form = tables.forms[id];
        if (form.is_read && form.unsupported.empty()) return form.words[0].text;
    }
    return std::string(nc::info(function).name);
}

/// Adds where the program of the block was called.
DiagnosticBuilder Executor::note_calls(DiagnosticBuilder builder, const Block& block) const {
    if (places_ == nullptr) return builder;
    for (TextLocation& place : places_->calls(block)) builder.note(std::move(place), "called here");
    return builder;
}

DiagnosticBuilder Executor::report(const DiagnosticRow& row, TextLocation place) {
    if (row.severity == Severity::Alarm) ended_ = alarmed_ = true;
    DiagnosticBuilder builder = sink_->report(row, std::move(place));
    if (std::optional<nc::AlarmText> alarm = dialect_.alarm(row)) {
        builder.alarm(std::move(alarm->number), std::move(alarm->text));
    }
    return builder;
}

}  // namespace kadr::interp
