// native_cycles.cpp — cycles of the library that the control has itself.
#include "expand/native_cycles.h"

#include <algorithm>
#include <array>
#include <span>

#include "base/assert.h"
#include "base/diagnostics/expand.h"
#include "expand/blocks.h"
#include "expand/cuts.h"
#include "expand/cycles.h"
#include "expand/faults.h"
#include "expand/input_positions.h"
#include "expand/numbers.h"
#include "expand/plane.h"
#include "expand/running.h"
#include "expand/shape_cycles.h"
#include "expand/unknown.h"
#include "nc/cycle_back.h"
#include "nc/tables.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using nc::Group;

/// Whether the cycle turns the spindle by itself: it taps, and not in a compensating chuck.
static bool turns_spindle(std::span<const sema::ParameterInfo> parameters, std::uint32_t given,
                          std::span<const double> values) {
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (parameters[i].name == "floating") return (given >> i & 1u) == 0 || values[i] == 0;
    }
    return false;
}

/// Whether a cycle has its feed from this parameter: threads are cut with their pitch.
static bool has_feed(const sema::ParameterInfo& parameter) {
    return parameter.name == "pitch" || parameter.name == "lead" || parameter.name == "per_turn";
}

/// `SST` and `SST1` alike: a retraction with the speed of the infeed is none of its own.
static void forget_equal_back(std::span<const sema::ParameterInfo> parameters, std::uint32_t given,
                              std::span<double> values) {
    const auto at = nc::find_parameter(parameters, "at");
    const auto back = nc::find_parameter(parameters, "back");
    if (!at || !back || parameters[*back].kind != sema::ParameterInfo::Kind::Speed) return;
    const bool are_given = (given >> *at & 1u) != 0 && (given >> *back & 1u) != 0;
    if (are_given && values[*at] == values[*back]) values[*back] = 0;
}

/// How a cycle leaves the spindle if the last of its own blocks that is about it makes it stand;
/// None: it turns on, or nothing is known of it.
static Function standing_behind(const sema::Code& code, const sema::FunctionCode& cycle) {
    Function last = Function::None;
    for (std::uint32_t i = cycle.body; i < cycle.end; ++i) {
        const Instruction& instruction = code.instructions[i];
        if (instruction.op != OpCode::Emit) continue;
        const auto plan = static_cast<std::size_t>(instruction.immediate.pair.first);
        for (const nc::Invocation& invocation : code.plans[plan].functions)
            if (nc::info(invocation.function).group == Group::Spindle) last = invocation.function;
    }
    const bool stands = last == Function::SpindleStop || last == Function::SpindleOrient;
    return stands ? last : Function::None;
}

namespace {

/// A cycle whose refusal has been reported.
CycleOutcome failed(Done) { return CycleOutcome::Failed; }

/// Where the cycle leaves the tool.
void go_back(Running& run, std::span<const sema::ParameterInfo> parameters, std::uint32_t given,
             std::span<const double> values) {
    const nc::CycleBack back = nc::cycle_back(parameters, given);
    if (!back.is_elsewhere) return;
    const bool has_plane = run.modal[Group::Plane] != Function::None;
    if (back.moves_in_plane || !has_plane) run.modal.position.lose(kLinearXYZ);
    if (!has_plane) return;
    const std::size_t across = indices_of(plane_of(run.modal[Group::Plane])).across;
    if (back.level) run.modal.position.set(across, values[*back.level]);
    else run.modal.position.lose(static_cast<AxisMask>(1u << across));
}

}  // namespace

/// Whether the call is that of a source whose control spares strokes and shifts from a scaling.
static bool is_spared_by_source(const ActiveCycle& cycle, const sema::Code& code,
                                const CallFrame& call) {
    return cycle.is_running && !cycle.source->rules.cycle_distances_scaled &&
           call.function == &code.functions[cycle.source->function];
}

namespace {

/// Strokes and shifts are scaled in the language; a control that spares them gets moves, if its own
/// program does not write the cycle.
bool spares_distances(const Running& run, nc::CycleId cycle, std::uint32_t given) {
    if (is_spared_by_source(run.cycle, run.code, run.vm.calls.back())) return false;
    const nc::CycleInfo::Roles& roles = run.target.cycles()[cycle].roles;
    const auto is_given = [&](int role) { return role >= 0 && (given >> role & 1u) != 0; };
    return (is_given(roles.stroke) || is_given(roles.shift)) &&
           !run.target.rules().cycle_distances_scaled;
}

}  // namespace

void compensated_cycle(Running& run, const sema::FunctionCode& cycle) {
    const CallFrame& frame = run.vm.calls.back();
    const bool is_called = run.vm.calls.size() > 1 && frame.return_to > 0;
    const std::uint32_t at = is_called ? frame.return_to - 1 : 0;
    DiagnosticBuilder builder =
        fault_in(run, diag::CycleUnderCompensation, at, run.vm.calls.size() - 1);
    builder.arg(cycle.name);
    note_statement(run, builder, run.modal.by(Group::RadiusComp), "the compensation began here");
    builder.fix("end it before: `G40` with a move");
}

namespace {

/// A control that has cycles of its own, none of which is known to tap as the call wants.
void warn_of_tap(Running& run) {
    const CallFrame& frame = run.vm.calls.back();
    const bool is_called = run.vm.calls.size() > 1 && frame.return_to > 0;
    if (!is_called || !run.target.rules().modal_cycles) return;
    const std::uint32_t at = frame.return_to - 1;
    if (!run.reported_at.first_time(NoticeAt::Tap, at)) return;
    fault_in(run, diag::TapByMoves, at, run.vm.calls.size() - 1).arg(frame.function->name);
}

}  // namespace

CycleOutcome emit_cycle(Running& run, nc::CycleId cycle, const sema::Slot* registers) {
    if (run.recordings.is_open()) return CycleOutcome::Moves;
    if (run.target.cycles()[cycle].takes_shape()) return emit_shape_cycle(run, cycle, registers);
    const CallFrame& frame = run.vm.calls.back();
    if (run.modal.compensation.is_choice() && frame.return_to > 0) {
        compensation_chosen(run, fault_in(run, diag::CompensationInDoubt, frame.return_to - 1,
                                          run.vm.calls.size() - 1));
        return CycleOutcome::Failed;
    }
    const Function compensation = run.modal[Group::RadiusComp];
    if (nc::has_fact(compensation, nc::Fact::CompSide)) {
        compensated_cycle(run, *frame.function);
        return CycleOutcome::Failed;
    }
    if (!run.options.native_cycles || run.modal.tcp.is_length()) return CycleOutcome::Moves;
    if (is_between_positions(run) && frame.return_to > 0)
        return failed(refuse_beside_cycle(run, "another cycle", frame.return_to - 1));
    const std::vector<sema::ParameterInfo>& parameters = frame.function->parameters;
    using Kind = sema::ParameterInfo::Kind;
    const bool is_as_given = !run.target.rules().cycle_distances_scaled &&
                             is_spared_by_source(run.cycle, run.code, frame);
    std::uint32_t given = 0;
    std::array<double, nc::kMaxArguments> values{};
    KADR_ASSERT(parameters.size() <= values.size(), "a cycle has more parameters than a block");
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const sema::Slot slot = registers[parameters[i].slot];
        const Kind kind = parameters[i].kind;
        const bool is_number = kind == Kind::Number || kind == Kind::Feed || kind == Kind::Speed;
        const bool is_given =
            is_number ? slot.number == slot.number : slot.integer != sema::kNotGivenInteger;
        if (!is_given) continue;
        given |= 1u << i;
        values[i] = is_number ? slot.number : static_cast<double>(slot.integer);
        if (kind == Kind::Number && is_as_given && (run.cycle.given >> i & 1u) != 0)
            values[i] = run.cycle.arguments[i];
        if (kind != Kind::Feed && kind != Kind::Speed) continue;
        // Cycles of controls know feeds per minute and speeds in revolutions only.
        if (sema::is_second_form(values[i])) return CycleOutcome::Moves;
        values[i] = neat(values[i] * kMinute);
    }
    const std::span<const double> arguments(values.data(), parameters.size());
    forget_equal_back(parameters, given, values);
    if (!run.target.has_native_cycle(cycle, given, arguments, run.options.refusals)) {
        // A call in the control's own words: what it does not give, the control has by itself.
        given &= frame.given;
        const bool is_programmed = run.cycle.is_running;
        if (!is_programmed ||
            !run.target.has_native_cycle(cycle, given, arguments, run.options.refusals)) {
            if (turns_spindle(parameters, given, values)) warn_of_tap(run);
            return CycleOutcome::Moves;
        }
    }
    // Under inverse time F belongs to a block, and a cycle is many.
    if (run.modal[Group::FeedMode] == Function::FeedInverseTime) return CycleOutcome::Moves;
    if (run.modal.frame.now().has_scale() && spares_distances(run, cycle, given))
        return CycleOutcome::Moves;
    const std::uint32_t at = frame.return_to > 0 ? frame.return_to - 1 : 0;
    if (run.modal.lost.what() != 0 && !require_state_for_cycle(run, *frame.function, given, at))
        return CycleOutcome::Failed;
    const bool needs_feed = std::ranges::none_of(parameters, has_feed);
    if (needs_feed && run.modal.feed.is_lost())
        return failed(refuse_lost_feed(run, at, run.vm.calls.size() - 1));
    if (run.options.warns_of_cuts && is_cut_doubtful(run) &&
        !turns_spindle(parameters, given, values))
        warn_of_cut(run, at, needs_feed);
    if (run.status.has_failed()) return CycleOutcome::Failed;
    if (!require_room(run, at)) return CycleOutcome::Failed;
    if (run.modal.has_ended) warn_after_end(run, at);
    const Instruction& call = run.code.instructions[at];
    const SourceId source{static_cast<std::uint32_t>(call.immediate.pair.first)};
    if (run.modal.owed.diameter() != Function::None)
        say_diameter_alone(run, source, at, run.vm.calls.size() - 1);
    if (run.modal.drifts.unplaced() != 0 &&
        !write_positions(run, source, at, static_cast<unsigned>(run.vm.calls.size() - 1)))
        return CycleOutcome::Failed;
    if (run.modal.lost.restate() != 0) say_again_alone(run, source, at, run.vm.calls.size() - 1);
    if (run.modal.speed.is_turning_in_doubt() && !turns_spindle(parameters, given, values) &&
        run.modal.reported.first_time(ProgramNotice::SpindleInDoubt))
        warn_of_choice(run, fault_in(run, diag::SpindleInDoubt, at, run.vm.calls.size() - 1));
    Block& block = next_block(run, source);
    nc::Invocation* invocation = block.add(Function::Cycle, parameters.size());
    KADR_ASSERT(invocation != nullptr, "a cycle has more parameters than a block holds");
    block.cycle = cycle;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if ((given >> i & 1u) != 0) block.set_argument(*invocation, i, values[i]);
    }
    // The contract of a cycle: it ends where it began, after a move at rapid.
    run.modal.note(Group::Motion, Function::Rapid, source);
    run.modal.owed.owe_motion();
    if (const Function left = standing_behind(run.code, *frame.function); left != Function::None)
        run.modal.switch_spindle(left, source);
    // The cycle names coordinates of its own; which ones only one that drills in Z shows.
    const bool drills_in_z = std::ranges::any_of(parameters, [&](const sema::ParameterInfo& p) {
        return p.name == "initial" && (given >> (&p - parameters.data()) & 1u) != 0;
    });
    if (drills_in_z) run.modal.drifts.forget(bit(Axis::Z));
    else run.modal.drifts.lose_all();
    const AxisMask before = run.modal.position.known();
    go_back(run, parameters, given, values);
    run.modal.position.note_loss(before, source, Loss::Control);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if ((given >> i & 1u) == 0) continue;
        if (parameters[i].name == "initial") {
            run.modal.position.set(index(Axis::Z), values[i]);
        } else if (parameters[i].name == "after") {
            run.modal.set_spindle(values[i], source);
        }
    }
    if (run.options.trace) keep_trace_of_caller(run, at, call.c, source);
    return CycleOutcome::Block;
}

}  // namespace kadr::expand
