// blocks.cpp — blocks: plans filled with values; texts.
#include "expand/blocks.h"

#include <algorithm>
#include <optional>

#include "base/diagnostics/dialect.h"
#include "base/diagnostics/expand.h"
#include "expand/block_values.h"
#include "expand/contour_recording.h"
#include "expand/corners.h"
#include "expand/cuts.h"
#include "expand/cycles.h"
#include "expand/drawn_words.h"
#include "expand/faults.h"
#include "expand/frame_blocks.h"
#include "expand/input.h"
#include "expand/input_frames.h"
#include "expand/input_positions.h"
#include "expand/input_references.h"
#include "expand/numbers.h"
#include "expand/orienting.h"
#include "expand/running.h"
#include "expand/tilted_planes.h"
#include "expand/unknown.h"
#include "nc/frame_words.h"
#include "nc/tables.h"
#include "syntax/ast.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using nc::Group;
using sema::Filling;

namespace {

Done fill_block(Running& run, const sema::Plan& plan, const Instruction& instruction,
                const Slot* registers, std::uint32_t at);

constexpr nc::SlotMask kPointSlots = 7;  // X, Y, Z
constexpr std::uint32_t kOfCycles = sema::custom::kCyclePosition | sema::custom::kPlaces;

}  // namespace

Done require_room(Running& run, std::uint32_t at) {
    if (run.curve.is_in_point) [[unlikely]] {
        fault(run, diag::CurveBlock, at);
        return kFailed;
    }
    if (run.batch.is_holding() && !require_room_to_wait(run)) [[unlikely]]
        return kFailed;
    if (run.budget.take_block()) [[likely]]
        return kDone;
    fault(run, diag::BlockLimit, at)
        .arg(static_cast<std::int64_t>(run.options.limits.blocks))
        .fix("if it is to make more, raise the limit: `--max-blocks " +
             std::to_string(10 * run.options.limits.blocks) + '`');
    return kFailed;
}

Block& next_block(Running& run, SourceId source) {
    Block* block = nullptr;
    if (run.recordings.is_open()) [[unlikely]]
        block = &run.recordings.block();
    else block = &run.batch.add();
    block->reset();
    block->source = source;
    return *block;
}

void drop_block(Running& run, const Block& block) {
    if (!run.recordings.is_kept(block)) run.batch.drop_last();
}

namespace {

/// calls        how many of them lead to the block
void keep_trace_of(Running& run, std::size_t calls, std::uint32_t at, unsigned depth,
                   SourceId source) {
    if (run.recordings.is_open()) return;  // a block of a contour is none of the output
    const CallStack& stack = run.vm.calls;
    BlockOrigin trace;
    trace.statement = source.is_valid() && source.index < run.code.statements.size()
                          ? run.code.statements[source.index]
                          : run.code.locations[at];
    for (std::size_t i = 1; i < calls; ++i) {
        if (stack[i].return_to == 0) continue;
        trace.calls.push_back(
            {run.code.locations[stack[i].return_to - 1], stack[i].function->name, stack[i].loops});
    }
    const std::vector<std::uint64_t>& counts = run.vm.loop_counts;
    const std::size_t loops = std::min<std::size_t>(stack[calls - 1].loops + depth, counts.size());
    trace.loop_counts.assign(counts.begin(), counts.begin() + static_cast<std::ptrdiff_t>(loops));
    run.batch.add_origin(std::move(trace));
}

}  // namespace

void keep_trace(Running& run, std::uint32_t at, unsigned depth, SourceId source) {
    keep_trace_of(run, run.vm.calls.size(), at, depth, source);
}

void keep_trace_of_caller(Running& run, std::uint32_t at, unsigned depth, SourceId source) {
    keep_trace_of(run, run.vm.calls.size() - 1, at, depth, source);
}

Done emit(Running& run, const Instruction& instruction, const sema::Slot* registers,
          std::uint32_t at) {
    const sema::Plan& plan =
        run.code.plans[static_cast<std::size_t>(instruction.immediate.pair.first)];
    if (run.recordings.is_open()) [[unlikely]] {
        if (!require_room(run, at)) return kFailed;
        return keep_plan(run, plan, instruction, registers, at);
    }
    if (plan.planes != nc::kAllPlanes && !require_plane_of_source(run, plan, at)) [[unlikely]]
        return kFailed;
    if (is_between_positions(run) && !require_between_positions(run, plan, instruction, at))
        [[unlikely]]
        return kFailed;
    if (!plan.functions.empty() || run.modal.tcp.acts()) {
        const ToolTaken said = take_tool(run, plan, instruction, at);
        if (said != ToolTaken::Nothing) return Done(said == ToolTaken::Done);
    }
    if (!plan.functions.empty() && is_about_tilted_plane(run, plan)) [[unlikely]]
        return emit_tilted_plane(run, plan, instruction, registers, at);
    if (!plan.functions.empty() && needs_frame(run, plan)) [[unlikely]]
        return emit_frame(run, plan, instruction, registers, at);
    return emit_block(run, plan, instruction, registers, at);
}

Done emit_block(Running& run, const sema::Plan& plan, const Instruction& instruction,
                const sema::Slot* registers, std::uint32_t at) {
    if (!require_room(run, at)) return kFailed;
    if (run.modal.owed.work_offset() != 0) [[unlikely]]
        say_offset(run, plan, instruction, at);
    if (run.modal.owed.diameter() != Function::None && plan.skip_level >= 0) [[unlikely]] {
        const SourceId source = statement_of(instruction);
        say_diameter_alone(run, source, at, instruction.c);
    }
    if (run.modal.owed.position()) [[unlikely]]
        write_position(run, plan, instruction, at);
    if (run.modal.drifts.unplaced() != 0 && instruction.b == 0 && is_whole_circle(run, plan))
        [[unlikely]] {
        const SourceId source = statement_of(instruction);
        if (!write_positions(run, source, at, instruction.c)) return kFailed;
    }
    if (!fill_plan(run, plan, instruction, registers, at)) {
        run.batch.drop_last();  // a block that could not be finished is not delivered
        return kFailed;
    }
    if (plan.customs == 0) [[likely]]
        return kDone;
    if ((plan.customs & sema::custom::kReference) != 0)
        go_over_position(run, statement_of(instruction));
    const Block& block = run.batch.last();
    const bool is_empty =
        block.function_count == 0 && block.given == 0 && block.motion == Function::None;
    if (!is_empty) return kDone;
    // All that it programmed the target does by itself.
    run.batch.drop_last();
    if (run.options.trace) run.batch.drop_origin();
    return kDone;
}

Done fill_plan(Running& run, const sema::Plan& plan, const Instruction& instruction,
               const sema::Slot* registers, std::uint32_t at) {
    if (plan.skip_level < 0) [[likely]]
        return fill_block(run, plan, instruction, registers, at);
    // Nobody knows here whether the operator lets the block run.
    const ModalState without = run.modal;
    if (!fill_block(run, plan, instruction, registers, at)) return kFailed;
    run.modal.join(without, statement_of(instruction));
    return kDone;
}

/// A control may have a frame that the language has not: its own words are its own matter.
static bool is_frame_of_language(const sema::Plan& plan) {
    return (plan.customs & sema::custom::kFrameOfSource) == 0 &&
           std::ranges::any_of(plan.functions, [](const nc::Invocation& invocation) {
               return nc::has_fact(invocation.function, nc::Fact::AddsToFrame);
           });
}

/// What does not depend on values that are calculated.
static inline void copy_constants(const sema::Plan& plan, int default_skip, Block& block) {
    block.motion = plan.motion;
    block.given = plan.given;
    block.incremental = plan.incremental;
    block.absolute = plan.absolute;
    block.argument_count = plan.argument_count;
    block.skip_level = plan.skip_level == syntax::kDefaultSkipLevel
                           ? static_cast<std::int8_t>(default_skip)
                           : plan.skip_level;
    block.cycle = plan.cycle;
    block.number = plan.number;
    block.feed_along_arc = (plan.customs & sema::custom::kFeedOfArc) != 0;
    block.feed_of_all_axes = (plan.customs & sema::custom::kFeedOfAxes) != 0;
    block.length_waits = (plan.customs & sema::custom::kLengthMoves) == 0;
    block.function_count = static_cast<std::uint8_t>(plan.functions.size());
    for (std::size_t i = 0; i < plan.functions.size(); ++i) block.functions[i] = plan.functions[i];
    for (const auto& [place, value] : plan.arguments) block.arguments[place] = value;
    for (const auto& [place, value] : plan.values) block.values[place] = value;
}

namespace {

/// Fills in the values of a block's functions, and lets the modal state follow them.
///
/// returns      whether something of them comes true behind the motion only; nothing: reported
std::optional<bool> take_functions(Running& run, Block& block, const sema::Plan& plan,
                                   const sema::Slot* values, std::uint32_t at) {
    for (std::size_t i = 0; i < plan.fillings.size(); ++i) {
        if (plan.fillings[i].is_argument && !fill(run, block, plan.fillings[i], values[i], at))
            return std::nullopt;
    }
    if (plan.customs != 0 && !adapt(run, block, plan, at)) [[unlikely]]
        return std::nullopt;
    if (!check_mirror(run, block, plan, at) || !settle_frame(run, block, at)) return std::nullopt;
    if (run.options.warns_of_cuts) warn_of_plane(run, block, at);
    const Function motion = plan.motion != Function::None ? plan.motion : run.modal[Group::Motion];
    const bool owes_behind = run.modal.take_functions(block, run.target.rules());
    const bool has_no_frame = run.modal.frame.has_fault() && is_frame_of_language(plan);
    if (has_no_frame && !refuse_frame(run, run.modal.frame.fault(), at)) return std::nullopt;
    const bool has_rapid = (plan.customs & sema::custom::kMachineRapid) != 0;
    if (run.target.rules().machine_coordinates_rapid && !has_rapid && motion != Function::Rapid &&
        block.find(Function::MachineCoordinates) != nullptr) [[unlikely]] {
        fault(run, diag::MachineAtFeed, at)
            .arg(run.target.name())
            .arg(nc::info(motion).name)
            .fix("write `G0` in the block");
        return std::nullopt;
    }
    if (run.target.rules().shift_in_diameter) scale_frame_x(run, block, 2);
    if (run.modal[Group::Diameter] == Function::None && run.options.warns_of_cuts)
        warn_of_radius(run, block, at);
    if (has_rapid && motion != Function::Rapid) {
        run.modal.assume(Group::Motion, motion);
        run.modal.owed.owe_motion();
    }
    return owes_behind;
}

Done fill_block(Running& run, const sema::Plan& plan, const Instruction& instruction,
                const sema::Slot* registers, std::uint32_t at) {
    const SourceId source = statement_of(instruction);
    Block& block = next_block(run, source);
    if ((plan.customs & kOfCycles) != 0) [[unlikely]]
        run.cycle.begin_block(run.modal[Group::Motion]);
    copy_constants(plan, run.target.tables().notation.default_skip, block);
    // Values of functions before those of F and S: the feed mode decides what F means.
    const sema::Slot* values = registers + instruction.a;
    if (run.modal.has_ended && !run.recordings.is_open()) [[unlikely]]
        warn_after_end(run, at);
    bool owes_behind = false;
    if (block.function_count == 0 && block.motion != Function::None) {  // nearly all of them
        if (plan.customs != 0 && !adapt(run, block, plan, at)) [[unlikely]]
            return kFailed;
        owes_behind = run.modal.take_functions(block, run.target.rules());
        const bool is_thread = block.motion == Function::Thread;
        if (is_thread && run.modal[Group::Diameter] == Function::None && run.options.warns_of_cuts)
            warn_of_radius(run, block, at);
    } else if (block.function_count != 0) {
        const std::optional<bool> taken = take_functions(run, block, plan, values, at);
        if (!taken) return kFailed;
        owes_behind = *taken;
    }
    if ((plan.customs & sema::custom::kFeedCounts) != 0 &&
        run.modal[Group::FeedMode] == Function::FeedPerRevolution) [[unlikely]] {
        const auto feed = std::ranges::find(plan.fillings, Filling::Form::FeedBare, &Filling::form);
        fault(run, diag::SourceNoPoint, feed == plan.fillings.end() ? at : word_of(run, *feed, at))
            .arg("F")
            .arg("the control of this source")
            .arg("in hundredths of mm/rev")
            .fix("write the point");
        return kFailed;
    }
    for (std::size_t i = 0; i < plan.fillings.size(); ++i) {
        if (!plan.fillings[i].is_argument && !fill(run, block, plan.fillings[i], values[i], at))
            return kFailed;
    }
    if (instruction.b != 0) {
        const sema::Slot* point = registers + (instruction.b - 1);
        for (unsigned i = 0; i < 3; ++i) {
            if (point[i].number != point[i].number) continue;
            if (!is_sane(point[i].number)) {
                math_fault(run, sema::MathFault::Overflow, at);
                return kFailed;
            }
            block.set(static_cast<nc::Slot>(i), point[i].number);
        }
        if ((block.given & kPointSlots) == 0) {
            not_given(run, "the target", at);
            return kFailed;
        }
    }
    if ((plan.customs & sema::custom::kDrawn) != 0 && !take_drawn_words(run, block, plan, at))
        [[unlikely]]
        return kFailed;
    if ((plan.customs & kOfCycles) != 0 && !run.recordings.is_open() &&
        !take_position(run, block, plan, at)) [[unlikely]] {
        return kFailed;
    }
    if ((block.given & (nc::kTargetSlots | nc::kCenterSlots)) != 0) run.modal.put_motion(block);
    if (!run.recordings.is_open()) {
        if ((run.modal.length.is_edge_off() || run.modal.feed.is_deleted()) &&
            !check_move(run, block, at)) [[unlikely]]
            return kFailed;
        const bool owes_incremental = run.modal.owed.incremental();
        if ((run.modal.drifts.adapts() & block.given) != 0 &&
            !adapt_increments(run, block, plan, at)) [[unlikely]]
            return kFailed;
        if (owes_incremental && block.find(Function::Absolute) == nullptr) [[unlikely]]
            return_to_increments(run, block);
    }
    if (block.function_count != 0 &&
        !(check_cutting_speed(run, block, at) && check_tool_change(run, block, at)))
        return kFailed;
    if (run.modal.compensation.is_choice() && !run.recordings.is_open() &&
        !require_sure_compensation(run, block, at)) [[unlikely]]
        return kFailed;
    if (run.modal.is_compensation_due() && !check_pitch(run, block, at)) [[unlikely]]
        return kFailed;
    if ((plan.customs & sema::custom::kReference) != 0) say_reference(run, block);
    if (run.modal.frame.is_stretched() && nc::is_arc(run.modal[Group::Motion]) &&
        (block.given & (nc::kTargetSlots | nc::kCenterSlots)) != 0 &&
        run.modal.frame.now().is_stretched(run.modal[Group::Plane])) {
        fault(run, diag::ArcUnderScale, at);
        return kFailed;
    }
    if (run.modal.lost.needs_care() && !settle_unknown(run, block, at)) [[unlikely]]
        return kFailed;
    if (nc::is_arc(run.modal[Group::Motion]) && !run.recordings.is_open() &&
        !require_radius(run, block, at))
        return kFailed;
    if (run.modal.tcp.acts() && !check_leading(run, block, at)) return kFailed;
    if (run.modal.owed.diameter() != Function::None && !run.recordings.is_open()) [[unlikely]]
        say_diameter(run, block);
    if (run.options.warns_of_cuts && !run.modal.reported.has_reported(ProgramNotice::Rapid) &&
        !run.recordings.is_open())
        check_rapid(run, block, at);
    const bool has_corner = is_about_corner(run);
    const KnownPosition before = has_corner ? run.modal.position : KnownPosition();
    run.modal.take_words(block);
    if (owes_behind) [[unlikely]]
        run.modal.take_behind(block, run.target.rules());
    if (!run.recordings.is_open() && is_cut_doubtful(run) && !check_cut(run, block, at))
        [[unlikely]]
        return kFailed;
    if (run.options.trace) keep_trace(run, at, instruction.c, source);
    if (has_corner) [[unlikely]]
        return finish_side(run, before, at);
    return kDone;
}

}  // namespace

Done emit_text(Running& run, const Instruction& instruction, const sema::Slot* registers,
               std::uint32_t at) {
    if (run.recordings.is_open()) return refuse_in_contour(run, "a text", at);
    if (is_between_positions(run) && instruction.b == 1)
        return refuse_beside_cycle(run, "raw text", at);
    const SourceId source = statement_of(instruction);
    // A copy: making blocks does not move texts, but nothing should depend on that.
    const std::string text = run.vm.heap.text(registers[instruction.a].integer);
    const bool is_raw = instruction.b == 1;
    if (is_raw && run.modal.owed.diameter() != Function::None)
        say_diameter_alone(run, source, at, instruction.c);
    std::string_view rest = text;
    do {
        if (!require_room(run, at)) return kFailed;
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        std::string_view line = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        Block& block = next_block(run, source);
        block.kind = is_raw ? Block::Kind::Raw : Block::Kind::Comment;
        if (is_raw) block.text = line;
        else block.comment = line;
        if (run.options.trace) keep_trace(run, at, instruction.c, source);
    } while (!rest.empty());
    if (!is_raw) return kDone;
    run.modal.forget(source);
    // No word of this control tells what X is, so no text changes it.
    if (run.target.tables().forms_of[static_cast<std::size_t>(Function::DiameterOff)].empty())
        run.modal.lost.regain(sema::group_bit(Group::Diameter));
    return kDone;
}

}  // namespace kadr::expand
