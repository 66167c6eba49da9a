// input.cpp — blocks written in the manner of another control: the target shall do what that
// control would have done with them, or the program ends with a message.
#include "expand/input.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/diagnostics/dialect.h"
#include "base/diagnostics/expand.h"
#include "expand/blocks.h"
#include "expand/cycles.h"
#include "expand/faults.h"
#include "expand/frame_blocks.h"
#include "expand/orienting.h"
#include "expand/plane.h"
#include "expand/running.h"
#include "expand/unknown.h"
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

Done emit_rest(Running& run, const sema::Plan& plan, const sema::Instruction& instruction,
               const sema::Slot* registers, std::uint32_t at);
Done require_free_frame(Running& run, nc::Function function, std::uint32_t at);
void adapt_shift(Running& run, nc::Block& block, nc::Invocation& shift);
Done adapt_machine(Running& run, nc::Block& block, const sema::Plan& plan, std::uint32_t at);
Done complete_center(Running& run, nc::Block& block, nc::Invocation& invocation, std::uint32_t at);
void center_unknown(Running& run, nc::Function function, std::size_t axis, std::uint32_t at);
bool is_increment(const Running& run, const nc::Block& block, nc::SlotMask axis);
void become_place(const Running& run, nc::Block& block, std::size_t axis);
Done name_positions(Running& run, nc::Block& block, std::uint32_t at);
Done take_station(Running& run, nc::Block& block, nc::Invocation& select, std::uint32_t at);
Done take_offsets_as_edges(Running& run, nc::Block& block, std::uint32_t at);
Done take_edge_as_length(Running& run, nc::Block& block, nc::Invocation& edge, std::uint32_t at);
Done take_edges_as_offsets(Running& run, nc::Block& block, std::uint32_t at);

constexpr std::size_t kTool = parameter_of_all<"tool", Function::ToolSelect, Function::Tool>();
constexpr std::size_t kEdge = parameter_of<Function::ToolEdge>("edge");
constexpr std::size_t kLengthOffset = parameter_of<Function::LengthCompOn>("offset");
constexpr std::size_t kPoint =
    parameter_of_all<"point", Function::ReferencePoint, Function::ReferenceReturn>();
constexpr std::size_t kPointX = parameter_of<Function::ReferencePoint>("x");

void erase(Block& block, std::size_t at) {
    for (std::size_t i = at + 1; i < block.function_count; ++i)
        block.functions[i - 1] = block.functions[i];
    --block.function_count;
}

/// Makes another function of an invocation that has no arguments of use, with one argument.
void become(Block& block, Invocation& invocation, Function function, std::size_t parameter,
            double argument) {
    invocation.function = function;
    invocation.given = 0;
    invocation.first = block.argument_count;
    block.argument_count = static_cast<std::uint8_t>(block.argument_count + parameter + 1);
    block.set_argument(invocation, parameter, argument);
}

/// Whether the control has words such as `T0102`.
bool says_offset_with_tool(const nc::DialectTables& tables) {
    const auto& forms = tables.forms_of[static_cast<std::size_t>(Function::ToolSelect)];
    return std::ranges::any_of(forms, [&](const nc::FormId id) {
        return std::ranges::any_of(tables.forms[id].words, [](const nc::FormWord& word) {
            return word.tail_parameter >= 0;
        });
    });
}

bool is_cycle_word(Function function) {
    const Group group = nc::info(function).group;
    return group == Group::CycleMode || group == Group::CycleReturn ||
           nc::has_fact(function, nc::Fact::CycleWord);
}

/// Which of its parameters the function gets: from the words of the source, or from registers.
std::uint32_t given_to(const sema::Plan& plan, std::size_t invocation) {
    std::uint32_t given = plan.functions[invocation].given;
    for (const sema::Filling& filling : plan.fillings) {
        if (filling.is_argument && filling.invocation == invocation)
            given |= 1u << filling.parameter;
    }
    return given;
}

/// Takes out of the steps what the function deletes.
void delete_steps(control::FrameSteps& steps, const sema::Plan& plan, std::size_t invocation) {
    const Function function = plan.functions[invocation].function;
    if (function == Function::RotateOff) steps.rotate_off();
    if (function == Function::ScaleOff) steps.scale_off();
    if (function == Function::MirrorOff) steps.mirror_off(given_to(plan, invocation));
}

control::ProgramFrame frame_behind(control::FrameSteps steps, const sema::Plan& plan,
                                   std::size_t invocation) {
    delete_steps(steps, plan, invocation);
    return steps.frame().frame;
}

/// Whether the block has words of axes.
bool names_axes(const sema::Plan& plan, const Instruction& instruction) {
    return (instruction.op == OpCode::Emit && instruction.b != 0) ||
           (plan.given & nc::kTargetSlots) != 0 ||
           std::ranges::any_of(plan.fillings, [](const sema::Filling& filling) {
               return !filling.is_argument && filling.index < kAxes;
           });
}

/// The number of the length that acts behind the block; 0: none. Nothing: nobody knows.
std::optional<double> length_behind(const ModalState& modal, const Block& block) {
    bool is_on = modal[Group::LengthComp] == Function::LengthCompOn;
    std::optional<double> number = modal.length.offset();
    if (modal[Group::LengthComp] == Function::None) number.reset();
    for (std::size_t i = 0; i < block.function_count; ++i) {
        const Invocation& invocation = block.functions[i];
        static_assert(kLengthOffset == parameter_of<Function::LengthOffset>("offset"));
        const bool is_length = invocation.function == Function::LengthCompOn;
        if (is_length) is_on = true;
        if (invocation.function == Function::LengthCompOff) return 0;
        if ((is_length || invocation.function == Function::LengthOffset) &&
            invocation.has(kLengthOffset))
            number = block.argument(invocation, kLengthOffset);
    }
    if (!is_on && modal[Group::LengthComp] != Function::None) return 0;
    return number;
}

/// `G49;` of a control that travels the change of the length at once: the axis goes where its
/// coordinate is the same with the new length.
///
/// returns  the function whose travel nobody knows, because the coordinate is not known; None
Function name_length_axis(ModalState& modal, Block& block) {
    const std::optional<double> before = length_behind(modal, Block{});
    const std::optional<double> behind = length_behind(modal, block);
    if (before && behind && *before == *behind) return Function::None;
    // Where its axis is no length acts, and none is left to be taken off.
    if (modal.length.is_away() && behind == 0) return Function::None;
    const Function motion = block.motion != Function::None ? block.motion : modal[Group::Motion];
    const bool is_straight = motion == Function::Rapid || motion == Function::Line;
    const bool is_changed = block.find(Function::ToolChange) != nullptr;
    if (!is_straight || is_changed || (modal.position.known() & bit(Axis::Z)) == 0)
        return behind == 0 ? Function::LengthCompOff : Function::LengthCompOn;
    block.set(nc::Slot::Z, modal.position[index(Axis::Z)]);
    if (modal[Group::Distance] == Function::Incremental) block.absolute |= bit(nc::Slot::Z);
    return Function::None;
}

}  // namespace

bool needs_frame(const Running& run, const sema::Plan& plan) {
    for (std::size_t i = 0; i < plan.functions.size(); ++i) {
        if (needs_frame(run, plan, i)) return true;
    }
    return false;
}

bool needs_frame(const Running& run, const sema::Plan& plan, std::size_t invocation) {
    const Function function = plan.functions[invocation].function;
    switch (function) {
        case Function::ShiftAdd: return !run.target.can_write(function);
        // Of some axes: the others' mirrors are written anew.
        case Function::MirrorOff:
            if (frame_behind(run.modal.frame.steps(), plan, invocation).has_mirror()) return true;
            [[fallthrough]];
        // What is left of the text's own steps may be another frame.
        case Function::RotateOff:
        case Function::ScaleOff:
            return !run.target.can_write(function) || run.modal.frame.has_fault() ||
                   !control::is_same(
                       frame_behind(run.modal.frame.steps(), plan, invocation),
                       frame_behind(run.modal.frame.written_steps(), plan, invocation));
        case Function::Rotate:
            return (plan.customs & custom::kRotateReplaces) != 0 &&
                   run.modal.frame.now().angle_deg != 0;
        default: return false;
    }
}

namespace {

/// The first four arguments of a function, mm or degrees.
Done read_arguments(Running& run, const sema::Plan& plan, std::size_t invocation,
                    const Instruction& instruction, const sema::Slot* registers, std::uint32_t at,
                    std::array<double, 4>& values, std::array<bool, 4>& given) {
    const std::size_t first = plan.functions[invocation].first;
    for (const auto& [place, value] : plan.arguments) {
        if (place < first || place >= first + 4) continue;
        values[place - first] = value;
        given[place - first] = true;
    }
    const sema::Slot* numbers = registers + instruction.a;
    for (std::size_t f = 0; f < plan.fillings.size(); ++f) {
        const sema::Filling& filling = plan.fillings[f];
        if (!filling.is_argument || filling.invocation != invocation) continue;
        const double number = numbers[f].number;
        if (!(std::fabs(number) < 1e15)) {
            if (number != number) not_given(run, {}, word_of(run, filling, at));
            else math_fault(run, sema::MathFault::Overflow, at);
            return kFailed;
        }
        values[filling.parameter] = number;
        given[filling.parameter] = true;
    }
    return kDone;
}

}  // namespace

Done emit_frame(Running& run, const sema::Plan& plan, const Instruction& instruction,
                const sema::Slot* registers, std::uint32_t at) {
    const SourceId source{static_cast<std::uint32_t>(instruction.immediate.pair.second)};
    if (run.modal.lost.what() != 0 && !require_frame(run, false, at)) return kFailed;
    control::FrameSteps steps = run.modal.frame.steps();
    const auto say = [&] {
        const auto [next, why] = steps.frame();
        if (why != control::FrameFormFault::None) return refuse_frame(run, why, at);
        write_frame(run, next, source, at, instruction.c);
        run.modal.frame.name_steps(steps);
        return Done(!run.status.has_failed());
    };
    for (std::size_t i = 0; i < plan.functions.size(); ++i) {
        const Function function = plan.functions[i].function;
        // What else stands in the block meets the frame that these leave (emit_rest).
        const bool is_bound = (plan.customs & custom::kFrameOrder) != 0 &&
                              nc::has_fact(function, nc::Fact::ChangesFrame);
        if (is_bound && !require_free_frame(run, function, at)) return kFailed;
        delete_steps(steps, plan, i);
        if (function != Function::ShiftAdd && function != Function::Rotate) continue;
        // These stand in blocks of their own: nothing is left to write.
        std::array<double, 4> values{};
        std::array<bool, 4> given{};
        if (!read_arguments(run, plan, i, instruction, registers, at, values, given))
            return kFailed;
        if (function == Function::ShiftAdd) {
            constexpr std::size_t kX = parameter_of<Function::ShiftAdd>("x");
            steps.shift_add({values[kX], values[kX + 1], values[kX + 2]},
                            {given[kX], given[kX + 1], given[kX + 2]});
        } else {
            constexpr std::size_t kRotation = parameter_of<Function::Rotate>("angle");
            constexpr std::size_t kX = parameter_of<Function::Rotate>("x");
            const PlaneIndices plane = indices_of(plane_of(run.modal[Group::Plane]));
            for (const std::size_t axis : {plane.first, plane.second}) {
                if (given[kX + axis] || (plan.customs & custom::kCenterAtTool) == 0) continue;
                center_unknown(run, function, axis, at);
                return kFailed;
            }
            steps.rotate_off();
            steps.rotate(values[kRotation], run.modal[Group::Plane],
                         {values[kX], values[kX + 1], values[kX + 2]});
        }
        return say();
    }
    if (!say()) return kFailed;
    return emit_rest(run, plan, instruction, registers, at);
}

namespace {

/// What a block programs besides the functions whose frame has been written.
Done emit_rest(Running& run, const sema::Plan& plan, const Instruction& instruction,
               const sema::Slot* registers, std::uint32_t at) {
    sema::Plan rest = plan;
    std::vector<sema::Slot> values(registers + instruction.a,
                                   registers + instruction.a + plan.fillings.size());
    for (std::size_t i = rest.functions.size(); i-- > 0;) {
        const Function function = rest.functions[i].function;
        const bool is_given = nc::has_fact(function, nc::Fact::ChangesFrame) &&
                              !nc::has_fact(function, nc::Fact::SetsFrame);
        if (!is_given) continue;
        rest.functions.erase(rest.functions.begin() + static_cast<std::ptrdiff_t>(i));
        for (std::size_t f = rest.fillings.size(); f-- > 0;) {
            sema::Filling& filling = rest.fillings[f];
            if (!filling.is_argument || filling.invocation < i) continue;
            if (filling.invocation > i) {
                --filling.invocation;
                continue;
            }
            rest.fillings.erase(rest.fillings.begin() + static_cast<std::ptrdiff_t>(f));
            values.erase(values.begin() + static_cast<std::ptrdiff_t>(f));
        }
    }
    const bool is_empty = rest.functions.empty() && rest.fillings.empty() && rest.given == 0 &&
                          rest.motion == Function::None && instruction.b == 0;
    if (is_empty) return kDone;
    Instruction of_rest = instruction;
    of_rest.a = 0;
    if (instruction.b != 0) {  // the target's three numbers
        of_rest.b = static_cast<decltype(of_rest.b)>(values.size() + 1);
        values.insert(values.end(), registers + instruction.b - 1, registers + instruction.b + 2);
    }
    return emit_block(run, rest, of_rest, values.data(), at);
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

/// The first one of them, as a program has it.
static std::string_view word_of_plane(nc::PlaneMask planes) {
    if ((planes & nc::bit_of_plane(Function::PlaneXy)) != 0) return "G17";
    return (planes & nc::bit_of_plane(Function::PlaneZx)) != 0 ? "G18" : "G19";
}

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

namespace {

/// The function may stand where the present frame acts: the control takes mirror, scale
/// and rotation in this order, and inside them nothing before them.
Done require_free_frame(Running& run, Function function, std::uint32_t at) {
    const bool is_other_plane =
        nc::info(function).group == Group::Plane && function != run.modal[Group::Plane];
    const bool of_rotation = nc::has_fact(function, nc::Fact::BeforeRotation) || is_other_plane;
    const bool of_scale = of_rotation && nc::has_fact(function, nc::Fact::ChangesFrame);
    // It replaces the frame of the language, and on the control acts outside of the mirror.
    const bool of_mirror = function == Function::Shift;
    const control::ProgramFrame& frame = run.modal.frame.now();
    const char* inside = of_rotation && frame.angle_deg != 0 ? "rotation"
                         : of_scale && frame.has_scale()     ? "scale"
                         : of_mirror && frame.has_mirror()   ? "mirror"
                                                             : nullptr;
    if (inside == nullptr) return kDone;
    fault(run, diag::SourceFrame, at).arg(nc::info(function).name).arg(inside);
    return kFailed;
}

/// The axes that are not named keep the shift that they have.
void adapt_shift(Running& run, Block& block, Invocation& shift) {
    if (shift.given == 0) return;
    constexpr std::size_t kX = parameter_of<Function::Shift>("x");
    for (std::size_t i = 0; i < 3; ++i) {
        if (!shift.has(kX + i) && run.modal.frame.now().is_shifted[i])
            block.set_argument(shift, kX + i, run.modal.frame.now().shift[i]);
    }
}

/// Machine coordinates as the control reaches them: at rapid whatever acts, or with the tool
/// length, which no other control does.
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

}  // namespace

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
    const SourceId source{static_cast<std::uint32_t>(instruction.immediate.pair.second)};
    Block& block = next_block(run, source);
    block.set_argument(*block.add(Function::WorkOffset, 1),
                       parameter_of<Function::WorkOffset>("number"), run.modal.owed.work_offset());
    run.modal.take_block(block, run.target.rules());
    if (run.options.trace) keep_trace(run, at, instruction.c, source);
}

namespace {

/// A centre that is not named is where the tool stands.
Done complete_center(Running& run, Block& block, Invocation& invocation, std::uint32_t at) {
    const bool is_rotation = invocation.function == Function::Rotate;
    if (!is_rotation && invocation.function != Function::Scale) return kDone;
    constexpr std::size_t kX = parameter_of_all<"x", Function::Rotate, Function::Scale>();
    const PlaneIndices plane = indices_of(plane_of(run.modal[Group::Plane]));
    for (std::size_t i = 0; i < 3; ++i) {
        if (invocation.has(kX + i) || (is_rotation && i == plane.across)) continue;
        // Inside another one the coordinates count otherwise than those of its centre.
        const bool is_known = run.modal.position.knows(i) && run.modal.frame.now().angle_deg == 0 &&
                              !run.modal.frame.now().has_scale();
        if (is_known) {
            block.set_argument(invocation, kX + i, run.modal.position[i]);
            continue;
        }
        center_unknown(run, invocation.function, i, at);
        return kFailed;
    }
    return kDone;
}

void center_unknown(Running& run, Function function, std::size_t axis, std::uint32_t at) {
    fault(run, diag::SourceCenter, at)
        .arg(nc::info(function).name)
        .arg(kAxisNames[axis])
        .fix("name the centre: `" + std::string(kAxisNames[axis]) + "0.`");
}

}  // namespace

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
    const SourceId by = run.modal.by(Group::FeedMode);
    if (by.is_valid() && by.index < run.code.statements.size())
        builder.note(run.code.statements[by.index], "the kind of feed was changed here");
    builder.fix("give the block a feed");
    return kFailed;
}

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

namespace {

/// `T0101`, for a target that selects tools without their offsets: the tool with its own ones.
Done take_station(Running& run, Block& block, Invocation& select, std::uint32_t at) {
    constexpr std::size_t kOffset = parameter_of<Function::ToolSelect>("offset");
    if (!select.has(kOffset) || says_offset_with_tool(run.target.tables())) return kDone;
    const double tool = block.argument(select, kTool);
    const double offset = block.argument(select, kOffset);
    if (offset == tool) {
        become(block, select, Function::Tool, kTool, tool);
        return kDone;
    }
    const bool is_off = offset == 0 && run.modal.tool.in() == tool;
    if (is_off && run.target.can_write(Function::ToolEdge)) {
        become(block, select, Function::ToolEdge, kEdge, 0);
        return kDone;
    }
    if (is_off && run.target.can_write(Function::LengthCompOff)) {
        select.function = Function::LengthCompOff;
        select.given = 0;
        return kDone;
    }
    fault(run, diag::SourceOffset, at)
        .arg(run.target.name())
        .arg("tool " + std::to_string(std::llround(tool)) + " with the offset")
        .arg(std::to_string(std::llround(offset)))
        .fix("give the offset the number of its tool, or say `tool(n)`");
    return kFailed;
}

/// `H3` and `D3` of tool 3 are its first edge.
Done take_offsets_as_edges(Running& run, Block& block, std::uint32_t at) {
    // The tool that is in, not one that waits for its change; before the first change the one that
    // was called.
    const Invocation* select = block.find(Function::ToolSelect);
    const bool changes = block.find(Function::ToolChange) != nullptr;
    const bool is_called = select != nullptr && (changes || !run.modal.tool.in());
    const bool is_in = !is_called && !changes && run.modal.tool.in();
    const bool has_tool = is_called || is_in || run.modal.tool.called();
    const double tool = is_called ? block.argument(*select, kTool)
                        : is_in   ? run.modal.tool.in().value_or(0)
                                  : run.modal.tool.called().value_or(0);
    bool is_given = false;
    for (std::size_t i = 0; i < block.function_count;) {
        Invocation& invocation = block.functions[i];
        // `H2` alone is another offset of a length that acts already.
        const bool is_other_length = invocation.function == Function::LengthOffset;
        const bool is_length = invocation.function == Function::LengthCompOn || is_other_length;
        const bool is_off = invocation.function == Function::LengthCompOff;
        const bool is_radius = invocation.function == Function::RadiusOffset;
        if (!is_length && !is_off && !is_radius) {
            ++i;
            continue;
        }
        const bool acts =
            !is_other_length || (run.modal[Group::LengthComp] == Function::LengthCompOn &&
                                 block.find(nc::Fact::CallsEdge) == nullptr);
        // An edge that is switched off takes its radius along.
        const bool is_plain = run.modal[Group::RadiusComp] == Function::RadiusCompOff ||
                              block.find(Function::RadiusCompOff) != nullptr;
        static_assert(kLengthOffset == parameter_of<Function::RadiusOffset>("offset"));
        const double number = is_off ? 0 : block.argument(invocation, kLengthOffset, -1);
        static_assert(kLengthOffset == parameter_of<Function::LengthOffset>("offset"));
        const bool fits = acts && (number == 0 ? is_plain : has_tool && number == tool);
        if (!fits) {
            std::string shown = number < 0 ? "without H" : std::to_string(std::llround(number));
            if (is_off) shown.clear();
            auto builder = fault(run, diag::SourceOffset, at);
            builder.arg(run.target.name())
                .arg(is_length ? "the length offset"
                     : is_off  ? "the end of the length offset"
                               : "the radius offset")
                .arg(shown);
            builder.fix(is_off ? "switch the radius compensation off before it"
                               : "give the offset the number of its tool, or say `tool(n)`");
            return kFailed;
        }
        if (is_given) {
            erase(block, i);
            continue;
        }
        is_given = true;
        if (!is_radius) {  // what a `with` around it sets back
            run.modal.assume(Group::LengthComp,
                             number == 0 ? Function::LengthCompOff : Function::LengthCompOn);
            run.modal.length.take_offset(number != 0 ? std::optional(number) : std::nullopt);
        }
        become(block, invocation, Function::ToolEdge, kEdge, number == 0 ? 0 : 1);
        ++i;
    }
    return kDone;
}

}  // namespace

Done take_core_offsets(Running& run, Block& block, std::uint32_t at) {
    const bool by_tool = run.target.counts_offsets_by_tool();
    for (std::size_t i = 0; i < block.function_count; ++i) {
        Invocation& invocation = block.functions[i];
        if (run.target.can_write(invocation.function)) continue;
        switch (invocation.function) {
            case Function::LengthCompOn:
            case Function::LengthCompOff:
                if (!by_tool) return take_offsets_as_edges(run, block, at);
                break;
            case Function::ToolEdge:
                if (by_tool && !take_edge_as_length(run, block, invocation, at)) return kFailed;
                break;
            default: break;
        }
    }
    return kDone;
}

namespace {

/// `D1` is the length of the tool that is in, `D0` none.
Done take_edge_as_length(Running& run, Block& block, Invocation& edge, std::uint32_t at) {
    const double number = block.argument(edge, kEdge);
    const Invocation* select = block.find(Function::ToolSelect);
    const bool changes = block.find(Function::ToolChange) != nullptr;
    // Of a tool that waits for its change the length must not act yet.
    const bool has_tool = changes ? select != nullptr || run.modal.tool.called()
                                  : select == nullptr && run.modal.tool.in();
    const double tool = !changes            ? run.modal.tool.in().value_or(0)
                        : select != nullptr ? block.argument(*select, kTool)
                                            : run.modal.tool.called().value_or(0);
    if (number == 0) {
        edge.function = Function::LengthCompOff;
        edge.given = 0;
        return kDone;
    }
    if (number != 1 || !has_tool) {
        fault(run, diag::SourceOffset, at)
            .arg(run.target.name())
            .arg("the edge")
            .arg(std::to_string(std::llround(number)))
            .fix("say `tool(n)`, which makes the length act on every control");
        return kFailed;
    }
    become(block, edge, Function::LengthCompOn, kLengthOffset, tool);
    return kDone;
}

/// The first edge acts with the change of its tool; it has the offsets with the tool's number.
/// `D0` ends its length, and `D1` behind that brings it again; both wait for the next move.
Done take_edges_as_offsets(Running& run, Block& block, std::uint32_t at) {
    for (std::size_t i = block.function_count; i-- > 0;) {
        if (block.functions[i].function != Function::ToolEdge) continue;
        const double edge = block.argument(block.functions[i], kEdge);
        const bool is_off = edge == 0 && block.find(Function::MachineCoordinates) != nullptr;
        // An edge that is switched off takes its radius along.
        const bool is_plain = run.modal[Group::RadiusComp] == Function::RadiusCompOff ||
                              block.find(Function::RadiusCompOff) != nullptr;
        if (edge == 0 && !is_off && is_plain && run.target.can_write(Function::LengthCompOff)) {
            block.functions[i].function = Function::LengthCompOff;
            block.functions[i].given = 0;
            run.modal.length.end();
            continue;
        }
        if (edge == 1 && run.modal.length.has_ended() && run.modal.tool.in() &&
            block.find(Function::ToolChange) == nullptr) {
            become(block, block.functions[i], Function::LengthCompOn, kLengthOffset,
                   run.modal.tool.in().value_or(0));
            run.modal.length.begin_again();
            continue;
        }
        if (edge != 1 && !is_off) {
            fault(run, diag::SourceOffset, at)
                .arg(run.target.name())
                .arg("the edge")
                .arg(std::to_string(std::llround(edge)))
                .fix(
                    "say what the target is to do where it is the target: `G49`, "
                    "`G43 H…`");
            return kFailed;
        }
        erase(block, i);
    }
    if (run.target.rules().tool_change_activates_length) return kDone;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        if (block.functions[i].function != Function::ToolChange) continue;
        const Invocation* select = block.find(Function::ToolSelect);
        if (select == nullptr && !run.modal.tool.called()) return kDone;
        const double tool = select != nullptr ? block.argument(*select, kTool)
                                              : run.modal.tool.called().value_or(0);
        become(block, block.functions[i], Function::Tool, kTool, tool);
        if (select != nullptr)
            erase(block, static_cast<std::size_t>(select - block.functions.data()));
        return kDone;
    }
    return kDone;
}

}  // namespace

}  // namespace kadr::expand
