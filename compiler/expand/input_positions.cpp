#include "expand/input_positions.h"

#include <string>

#include "base/diagnostics/dialect.h"
#include "expand/blocks.h"
#include "expand/faults.h"
#include "nc/tables.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using nc::Group;
namespace custom = sema::custom;

namespace {

bool is_increment(const Running& run, const Block& block, nc::SlotMask axis) {
    const bool is_modal = run.modal[Group::Distance] == Function::Incremental;
    return (block.incremental & axis) != 0 || (is_modal && (block.absolute & axis) == 0);
}

/// The distance along an axis becomes the coordinate to which it leads.
void become_place(const Running& run, Block& block, std::size_t axis) {
    const nc::SlotMask bit = nc::SlotMask{1} << axis;
    block.values[axis] += run.modal.position[axis];
    block.incremental &= ~bit;
    if (run.modal[Group::Distance] == Function::Incremental) block.absolute |= bit;
}

/// The first motion behind the beginning or the end of a rotation names coordinates of both axes
/// that it turns: what the control takes for an axis that is not named depends on a parameter.
///
/// source       F 3.7 G68, G69; No.11600#5 AX1
Done name_positions(Running& run, Block& block, std::uint32_t at) {
    const bool is_modal = run.modal[Group::Distance] == Function::Incremental;
    for (std::size_t i = 0; i < kAxes; ++i) {
        const nc::SlotMask bit = nc::SlotMask{1} << i;
        if ((run.modal.position.known() & bit) == 0) {
            // The block stands under absolute dimensions then: what stays a distance is marked by
            // itself.
            if (is_modal && (block.given & bit) != 0 && is_increment(run, block, bit))
                block.incremental |= bit;
            if ((run.modal.drifts.unplaced() & ~block.given & bit) == 0) continue;
            const std::string axis(kAxisNames[i]);
            fault(run, diag::PlaceBehindRotation, at)
                .arg(run.target.name())
                .arg(axis)
                .fix("name a coordinate of " + axis + " in this block");
            return kFailed;
        }
        if ((block.given & bit) != 0) {
            if (is_increment(run, block, bit)) become_place(run, block, i);
        } else if ((run.modal.drifts.unplaced() & bit) != 0) {
            block.set(static_cast<nc::Slot>(i), run.modal.position[i]);
            run.modal.drifts.name_by_text(static_cast<AxisMask>(bit));
            if (is_modal) block.absolute |= bit;
        }
    }
    if (!is_modal) return kDone;
    // `G91` of the block itself waits, too.
    bool is_given = false;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        if (block.functions[i].function != Function::Incremental) continue;
        block.functions[i].function = Function::Absolute;
        is_given = true;
    }
    if (!is_given) block.add(Function::Absolute);
    run.modal.owed.owe_incremental();
    return kDone;
}

}  // namespace

Done adapt_increments(Running& run, Block& block, const sema::Plan& plan, std::uint32_t at) {
    const bool source_travels = (plan.customs & custom::kIncrementTravels) != 0;
    const bool target_travels =
        run.target.rules().incremental_frame == nc::IncrementalFrame::Traversed;
    const bool wants_position = (run.modal.drifts.unplaced() & block.given) != 0 &&
                                run.target.rules().place_behind_rotation &&
                                block.find(Function::Cycle) == nullptr;
    if (!source_travels && !target_travels && !wants_position) return kDone;
    if (block.find(nc::Fact::AtMachinePosition) != nullptr) return kDone;
    const Drift none;
    const Drift& of_source = source_travels ? run.modal.drifts.of_program() : none;
    const Drift& of_target = target_travels ? run.modal.drifts.of_text() : none;
    for (std::size_t i = 0; i < kAxes; ++i) {
        const nc::SlotMask bit = nc::SlotMask{1} << i;
        if ((block.given & bit) == 0 || !is_increment(run, block, bit)) continue;
        const bool is_known = (run.modal.position.known() & bit) != 0;
        const bool is_lost = ((of_source.lost | of_target.lost) & bit) != 0;
        const bool needs_place = wants_position && (run.modal.drifts.unplaced() & bit) != 0;
        const bool travels_alike = source_travels && target_travels &&
                                   of_source.by[i] == of_target.by[i] &&
                                   ((of_source.lost ^ of_target.lost) & bit) == 0;
        if (travels_alike && !needs_place) {
            run.modal.position.move(i, -of_source.by[i]);
            if (is_lost) run.modal.position.lose(static_cast<AxisMask>(bit));
            continue;
        }
        if (is_lost || (needs_place && !is_known)) {
            fault(run, diag::IncrementAfterFrame, at)
                .arg(kAxisNames[i])
                .arg(run.target.name())
                .fix("name a coordinate of " + std::string(kAxisNames[i]) + " first");
            return kFailed;
        }
        block.values[i] -= of_source.by[i];
        if ((of_target.has & bit) == 0) continue;
        if (is_known) become_place(run, block, i);
        else block.values[i] += of_target.by[i];
    }
    return !wants_position ? kDone : name_positions(run, block, at);
}

bool is_whole_circle(const Running& run, const sema::Plan& plan) {
    const Function motion = plan.motion != Function::None ? plan.motion : run.modal[Group::Motion];
    nc::SlotMask given = plan.given;
    for (const sema::Filling& filling : plan.fillings) {
        if (!filling.is_argument) given |= nc::SlotMask{1} << filling.index;
    }
    return nc::is_arc(motion) && (given & nc::kCenterSlots) != 0 && (given & nc::kTargetSlots) == 0;
}

Done write_positions(Running& run, SourceId source, std::uint32_t at, unsigned depth) {
    if (!run.target.rules().place_behind_rotation || run.recordings.is_open()) return kDone;
    if (!require_room(run, at)) return kFailed;
    Block& block = next_block(run, source);
    block.motion = Function::Rapid;
    if (!name_positions(run, block, at)) {
        drop_block(run, block);
        return kFailed;
    }
    run.modal.take_words(block);
    run.modal.owed.owe_motion();
    if (run.options.trace) keep_trace(run, at, depth, source);
    return kDone;
}

void return_to_increments(Running& run, Block& block) {
    if ((block.given & (nc::kTargetSlots | nc::kCenterSlots)) == 0) return;
    run.modal.owed.owe_incremental(false);
    if (run.modal[Group::Distance] == Function::Incremental &&
        block.find(Function::Incremental) == nullptr)
        block.add(Function::Incremental);
}

}  // namespace kadr::expand
