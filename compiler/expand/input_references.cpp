#include "expand/input_references.h"

#include <algorithm>

#include "base/diagnostics/dialect.h"
#include "base/diagnostics/expand.h"
#include "expand/blocks.h"
#include "expand/faults.h"
#include "expand/input_words.h"
#include "nc/parameters.h"
#include "nc/tables.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using nc::Group;
using nc::Invocation;
using nc::parameter_of;
using nc::parameter_of_all;
namespace custom = sema::custom;

namespace {

constexpr std::size_t kPoint =
    parameter_of_all<"point", Function::ReferencePoint, Function::ReferenceReturn>();
constexpr std::size_t kPointX = parameter_of<Function::ReferencePoint>("x");

}  // namespace

Done adapt_machine(Running& run, Block& block, const sema::Plan& plan, std::uint32_t at) {
    if ((plan.customs & custom::kMachineLength) != 0 && run.modal.tool.called() &&
        !run.modal.length.is_edge_off()) {
        const Invocation* edge = block.find(Function::ToolEdge);
        if (edge == nullptr || block.argument(*edge, kEdge) != 0) {
            fault(run, diag::SourceMachine, at)
                .fix("switch the tool length off in this block: `D0`");
            return kFailed;
        }
    }
    if ((plan.customs & custom::kMachineRapid) == 0) return kDone;
    if (run.modal[Group::Distance] == Function::Incremental &&
        block.find(Function::Absolute) == nullptr) {
        fault(run, diag::StateNeeded, at)
            .arg("G53")
            .arg(nc::info(Function::Absolute).name)
            .arg(nc::info(Function::Incremental).name);
        return kFailed;
    }
    if (run.modal[Group::Motion] != Function::Rapid || plan.motion != Function::None)
        block.motion = Function::Rapid;
    return kDone;
}

void say_offset(Running& run, const sema::Plan& plan, const Instruction& instruction,
                std::uint32_t at) {
    const bool moves = names_axes(plan, instruction);
    // A return that the target does not have goes over its intermediate point with a block of its
    // own.
    const bool has_return = run.target.can_write(Function::ReferenceReturn);
    const bool is_elsewhere =
        std::ranges::any_of(plan.functions, [&](const Invocation& invocation) {
            if (invocation.function == Function::ReferenceReturn && !has_return) return false;
            return invocation.function == Function::WorkOffset ||
                   nc::has_fact(invocation.function, nc::Fact::AtMachinePosition);
        });
    if (!moves || is_elsewhere) return;
    const SourceId source = statement_of(instruction);
    Block& block = next_block(run, source);
    block.set_argument(*block.add(Function::WorkOffset, 1),
                       parameter_of<Function::WorkOffset>("number"), run.modal.owed.work_offset());
    run.modal.take_block(block, run.target.rules());
    if (run.options.trace) keep_trace(run, at, instruction.c, source);
}

void say_reference(Running& run, Block& block) {
    if (run.target.can_write(Function::ReferenceReturn) ||
        !run.target.can_write(Function::ReferencePoint))
        return;
    const nc::SlotMask named = block.given & nc::kTargetSlots;
    const bool is_modal = run.modal[Group::Distance] == Function::Incremental;
    for (std::size_t i = 0; i < nc::kSlots; ++i) {
        const nc::SlotMask bit = nc::SlotMask{1} << i;
        if ((named & bit) == 0) continue;
        const bool is_distance =
            (block.incremental & bit) != 0 || (is_modal && (block.absolute & bit) == 0);
        // What goes over a point the writer refuses.
        if (i >= 3 || !is_distance || block.values[i] != 0) return;
    }
    if (named == 0) return;
    for (std::size_t f = 0; f < block.function_count; ++f) {
        Invocation& invocation = block.functions[f];
        if (invocation.function != Function::ReferenceReturn) continue;
        const double point = block.argument(invocation, kPoint, 1);
        become(block, invocation, Function::ReferencePoint, kPoint, point);
        block.argument_count = static_cast<std::uint8_t>(block.argument_count + 3);
        for (std::size_t i = 0; i < 3; ++i) {
            if ((named >> i & 1u) != 0) block.set_argument(invocation, kPointX + i, 0);
        }
    }
    block.given &= ~named;
    block.incremental &= ~named;
    block.absolute &= ~named;
}

void go_over_position(Running& run, SourceId source) {
    if (run.target.can_write(Function::ReferenceReturn) ||
        !run.target.can_write(Function::ReferencePoint))
        return;
    Block& way = run.batch.last();
    const Invocation* found = way.find(Function::ReferenceReturn);
    const nc::SlotMask named = way.given & nc::kTargetSlots;
    if (found == nullptr || named == 0 || named >> 3 != 0) return;
    const double point = way.argument(*found, kPoint, 1);
    erase(way, static_cast<std::size_t>(found - way.functions.data()));
    way.motion = Function::Rapid;
    // The programmed motion is not changed by the return.
    if (run.modal[Group::Motion] != Function::Rapid) run.modal.owed.owe_motion();
    const std::int8_t skip_level = way.skip_level;
    const std::uint16_t further_skip_levels = way.further_skip_levels;
    Block& back = next_block(run, source);
    back.skip_level = skip_level;
    back.further_skip_levels = further_skip_levels;
    Invocation* reference = back.add(Function::ReferencePoint, 4);
    back.set_argument(*reference, kPoint, point);
    for (std::size_t i = 0; i < 3; ++i) {
        if ((named >> i & 1u) != 0) back.set_argument(*reference, kPointX + i, 0);
    }
    if (run.options.trace) run.batch.repeat_origin();
}

}  // namespace kadr::expand
