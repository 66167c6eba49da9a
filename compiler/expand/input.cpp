#include "expand/input.h"

#include <string>

#include "base/diagnostics/dialect.h"
#include "expand/cycles.h"
#include "expand/faults.h"
#include "expand/frame_blocks.h"
#include "expand/input_frames.h"
#include "expand/input_references.h"
#include "expand/input_tools.h"
#include "expand/input_words.h"
#include "expand/orienting.h"
#include "expand/unknown.h"
#include "nc/tables.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using nc::Group;
using nc::Invocation;
namespace custom = sema::custom;

namespace {

bool is_cycle_word(Function function) {
    const Group group = nc::info(function).group;
    return group == Group::CycleMode || group == Group::CycleReturn ||
           nc::has_fact(function, nc::Fact::CycleWord);
}

}  // namespace

Done adapt(Running& run, Block& block, const sema::Plan& plan, std::uint32_t at) {
    const std::uint32_t customs = plan.customs;
    if ((customs & custom::kFrameDiameter) != 0) scale_frame_x(run, block, 0.5);
    for (std::size_t i = 0; i < block.function_count; ++i) {
        Invocation& invocation = block.functions[i];
        Done adapted = kDone;
        if ((customs & custom::kFrameOrder) != 0)
            adapted = require_free_frame(run, invocation.function, at);
        if ((customs & custom::kCenterAtTool) != 0 && adapted)
            adapted = complete_center(run, block, invocation, at);
        if ((customs & custom::kFeedDeleted) != 0) {
            const Group group = nc::info(invocation.function).group;
            if (group == Group::FeedMode && run.modal[group] != invocation.function)
                run.modal.feed.delete_by_mode();
        }
        switch (invocation.function) {
            case Function::Shift:
                if (adapted && (customs & custom::kShiftKeeps) != 0)
                    adapt_shift(run, block, invocation);
                break;
            case Function::CycleReturnInitial:
            case Function::CycleReturnRetract:
                run.cycle.return_low(invocation.function == Function::CycleReturnRetract);
                break;
            case Function::TapRigid: run.cycle.tap_rigidly(); break;
            case Function::CycleWords:
                if (adapted) adapted = Done(take_cycle_words(run, block, invocation, at));
                break;
            case Function::MachineCoordinates:
                if (adapted) adapted = adapt_machine(run, block, plan, at);
                break;
            case Function::ToolSelect:
                if (adapted) adapted = take_station(run, block, invocation, at);
                break;
            default: break;
        }
        if (!adapted) return kFailed;
    }
    if ((customs & custom::kEdges) != 0) {
        for (std::size_t i = 0; i < block.function_count; ++i) {
            const Invocation& invocation = block.functions[i];
            if (invocation.function == Function::ToolEdge)
                run.modal.length.choose_edge(block.argument(invocation, kEdge) == 0);
        }
    }
    if ((customs & custom::kLengthMoves) != 0 && !run.target.rules().length_moves_alone &&
        !names_axes(plan, run.code.instructions[at])) {
        const Function lost = name_length_axis(run.modal, block);
        if (lost != Function::None) {
            const bool is_off = lost == Function::LengthCompOff;
            fault(run, diag::SourceLengthAlone, at)
                .arg(is_off ? "G49" : "G43")
                .arg(run.target.name())
                .fix(std::string("say it in a block that moves the axis: `G0 Z… ") +
                     (is_off ? "G49`" : "G43 H…`"));
            return kFailed;
        }
    }
    const bool by_tool = (customs & custom::kOffsetsByTool) != 0;
    if ((by_tool || (customs & custom::kEdges) != 0) &&
        by_tool != run.target.counts_offsets_by_tool()) {
        const Done taken =
            by_tool ? take_offsets_as_edges(run, block, at) : take_edges_as_offsets(run, block, at);
        if (!taken) return kFailed;
    }
    if ((customs & custom::kCoreOffsets) != 0 && !take_core_offsets(run, block, at)) return kFailed;
    if ((customs & custom::kDirection) != 0 && !settle_direction(run, block, at)) return kFailed;
    // Cycles of the source are calls of the library's, so these have nothing to do in the target.
    for (std::size_t i = block.function_count; i-- > 0;) {
        const Function function = block.functions[i].function;
        const bool is_spent = (customs & custom::kPlaces) != 0 || !run.target.can_write(function);
        if (is_cycle_word(function) && is_spent) erase(block, i);
    }
    return kDone;
}

namespace {

/// The first one of them, as a program has it.
std::string_view word_of_plane(nc::PlaneMask planes) {
    if ((planes & nc::bit_of_plane(Function::PlaneXy)) != 0) return "G17";
    return (planes & nc::bit_of_plane(Function::PlaneZx)) != 0 ? "G18" : "G19";
}

}  // namespace

Done require_plane_of_source(Running& run, const sema::Plan& plan, std::uint32_t at) {
    if (run.modal.lost.has(Group::Plane))
        return refuse_lost_state(run, "the plane", "say `G17`, `G18` or `G19`", at);
    const Function active = run.modal[Group::Plane];
    if ((plan.planes & nc::bit_of_plane(active)) != 0) return kDone;
    const std::string other(word_of_plane(plan.planes));
    fault(run, diag::SourceOtherPlane, at)
        .arg(other)
        .arg(word_of_plane(nc::bit_of_plane(active)))
        .fix("say `" + other + "` before it, or write words for the plane that is active");
    return kFailed;
}

Done check_move(Running& run, const Block& block, std::uint32_t at) {
    constexpr nc::SlotMask kMoves = nc::kTargetSlots | nc::kCenterSlots;
    if ((block.given & kMoves) == 0 || block.find(Function::MachineCoordinates) != nullptr)
        return kDone;
    // A move without tool length, where the target takes the length with the next move again.
    if (run.modal.length.is_edge_off() && !run.modal.length.has_ended() &&
        run.target.counts_offsets_by_tool()) {
        fault(run, diag::SourceOffset, at)
            .arg(run.target.name())
            .arg("a move with the edge")
            .arg("0")
            .fix("say `D1` before it");
        return kFailed;
    }
    const bool needs_feed = run.modal[Group::Motion] != Function::Rapid &&
                            block.find(Function::ReferenceReturn) == nullptr;
    if (!run.modal.feed.is_deleted() || !needs_feed || block.has(nc::Slot::Feed)) return kDone;
    auto builder = fault(run, diag::SourceFeedDeleted, at);
    note_statement(run, builder, run.modal.by(Group::FeedMode),
                   "the kind of feed was changed here");
    builder.fix("give the block a feed");
    return kFailed;
}

}  // namespace kadr::expand
