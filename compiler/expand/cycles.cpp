// cycles.cpp — cycles as the control of the input dialect has them: where each one is due, and the
// call of the library's cycle that it becomes.
//
// A modal cycle belongs to the running program, as on the control: a loop or a function may make
// its positions. What the control does is what interp/cycles.cpp does with its text.
#include "expand/cycles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/diagnostics/dialect.h"
#include "base/diagnostics/expand.h"
#include "expand/blocks.h"
#include "expand/contour_recording.h"
#include "expand/faults.h"
#include "expand/running.h"
#include "expand/start.h"
#include "nc/parameters.h"

namespace kadr::expand {

using nc::Block;
using nc::find_parameter;
using nc::Function;
using nc::Group;
using sema::SourceCycle;
namespace custom = sema::custom;

namespace {

Done require_no_stroke(Running& run, std::uint32_t at);
void take_levels(Running& run, nc::Block& block);
void keep_words(Running& run);
void take_kept_words(Running& run);
Done require_words(Running& run, std::uint32_t at);
void take_given_levels(Running& run, std::uint32_t said);
Done complete_levels(Running& run, const sema::FunctionCode& function, std::uint32_t at);
void say_distance(Running& run, nc::Function function, SourceId source, std::uint32_t at,
                  unsigned depth);

constexpr std::size_t kToolAxis = index(Axis::Z);  // cycles of the library work in X-Y
constexpr double kSpindleStop = 5;                 // as in M5

void set_argument(ActiveCycle& cycle, std::optional<std::size_t> parameter, double value) {
    if (!parameter) return;
    cycle.arguments[*parameter] = value;
    cycle.given |= 1u << *parameter;
}

bool has_argument(const ActiveCycle& cycle, std::optional<std::size_t> parameter) {
    return parameter && (cycle.given >> *parameter & 1u) != 0;
}

/// By what a scaling would change this argument for the library, where all distances of a
/// cycle are scaled, while the control of its source spares it.
///
/// source       F 3.7 G51: Q and d of G83 and G73, the shifts of G76 and G87
double spared_factor(const SourceCycle& source, const control::ProgramFrame& frame,
                     std::string_view parameter) {
    using Spared = std::pair<std::string_view, Axis>;
    constexpr std::array kSpared = {Spared{"peck", Axis::Z},   Spared{"draw", Axis::Z},
                                    Spared{"lift_x", Axis::X}, Spared{"lift_y", Axis::Y},
                                    Spared{"lift_z", Axis::Z}, Spared{"shift_x", Axis::X},
                                    Spared{"shift_y", Axis::Y}};
    if (source.rules.cycle_distances_scaled || !frame.has_scale()) return 1;
    const auto spared = std::ranges::find(kSpared, parameter, &Spared::first);
    return spared == kSpared.end() ? 1 : frame.scale[index(spared->second)];
}

bool has(const sema::Plan& plan, Function function) {
    return std::ranges::find(plan.functions, function, &nc::Invocation::function) !=
           plan.functions.end();
}

}  // namespace

Done refuse_beside_cycle(Running& run, std::string_view what, std::uint32_t at) {
    fault(run, diag::SourceCycleActive, at)
        .arg(run.cycle.source->word)
        .arg(what)
        .fix(run.cycle.source->kind == SourceCycle::Kind::Called ? "end it before: `MCALL;`"
                                                                 : "end it before: `G80;`");
    return kFailed;
}

Done require_between_positions(Running& run, const sema::Plan& plan, const Instruction& instruction,
                               std::uint32_t at) {
    for (const nc::Invocation& invocation : plan.functions) {
        if (nc::has_fact(invocation.function, nc::Fact::CycleApart))
            return refuse_beside_cycle(
                run, '`' + std::string(nc::info(invocation.function).name) + '`', at);
    }
    if ((plan.customs & custom::kPlaces) != 0) return kDone;
    const bool moves = plan.motion != Function::None || instruction.b != 0 ||
                       (plan.given & nc::kTargetSlots) != 0 ||
                       std::ranges::any_of(plan.fillings, [](const sema::Filling& filling) {
                           return !filling.is_argument && filling.index < kAxes;
                       });
    return moves ? refuse_beside_cycle(run, "a move that is no block of its file", at) : kDone;
}

Done take_position(Running& run, Block& block, const sema::Plan& plan, std::uint32_t at) {
    const bool begins = (plan.customs & custom::kCyclePosition) != 0;
    const bool ends = plan.motion != Function::None || has(plan, Function::CycleOff);
    if (ends) run.cycle.taps_rigidly = false;
    const bool is_called =
        run.cycle.is_active && run.cycle.source->kind == SourceCycle::Kind::Called;
    if (begins && is_called) return refuse_beside_cycle(run, "another cycle", at);
    if (!begins && !run.cycle.is_active) {
        if ((plan.customs & custom::kRepeats) == 0) return kDone;
        fault(run, diag::SourceRepeats, at).arg("K").arg("none is active");
        return kFailed;
    }
    if (ends && !is_called) {
        run.cycle.is_active = false;
        return kDone;
    }
    const nc::SlotMask words = block.given & (nc::kTargetSlots | nc::kArcSlots);
    if (words == 0) return kDone;
    if (plan.skip_level >= 0) return refuse_beside_cycle(run, "a block that may be left out", at);
    if (is_called) {
        run.cycle.is_due = (words & nc::kTargetSlots) != 0;
        return kDone;
    }
    if ((words & (nc::kCenterSlots | bit(nc::Slot::Turns))) != 0)
        return refuse_beside_cycle(run, "a word of an arc", at);
    if (!begins) {
        run.cycle.is_due = true;
        take_levels(run, block);
    }
    if ((block.given & nc::kTargetSlots) == 0) return kDone;
    block.motion = Function::Rapid;
    run.modal.assume(Group::Motion, Function::Rapid);
    return kDone;
}

Done take_cycle_words(Running& run, const Block& block, const nc::Invocation& invocation,
                      std::uint32_t at) {
    using GivenAs = std::pair<std::size_t, std::string_view>;
    constexpr std::array kGivenAs = {
        GivenAs{nc::parameter_of<Function::CycleWords>("stroke"), "peck"},
        GivenAs{nc::parameter_of<Function::CycleWords>("dwell"), "dwell"}};
    for (const auto& [given, name] : kGivenAs) {
        if (!invocation.has(given)) continue;
        const auto word = std::ranges::find(kHeldWords, name, &HeldWord::parameter);
        const bool is_place =
            run.cycle.is_active && run.cycle.source->kind == SourceCycle::Kind::Modal;
        if (!is_place) {
            fault(run, diag::SourceCycleWord, at).arg(std::string(1, word->letter));
            return kFailed;
        }
        const double value = block.argument(invocation, given);
        const auto parameter =
            find_parameter(run.code.functions[run.cycle.source->function].parameters, name);
        // A cycle without such a word keeps it for the next one.
        if (parameter && has_argument(run.cycle, parameter))
            set_argument(run.cycle, parameter, value);
        else run.cycle.held[static_cast<std::size_t>(word - kHeldWords.begin())] = value;
    }
    return require_no_stroke(run, at);
}

namespace {

/// `G73 … Q3.`, then `G84`: the stroke is kept, and makes another cycle of the code, which only the
/// block itself can choose.
Done require_no_stroke(Running& run, std::uint32_t at) {
    const auto word = std::ranges::find(kHeldWords, "peck", &HeldWord::parameter);
    const double stroke =
        run.cycle.held[static_cast<std::size_t>(word - kHeldWords.begin())].value_or(0);
    if (!run.cycle.source->has_other_in_strokes || stroke == 0) return kDone;
    fault(run, diag::SourceCycleStroke, at)
        .arg(std::string(1, word->letter))
        .arg(run.cycle.source->word);
    return kFailed;
}

/// `X10. Z-12. R3.` among the positions: from here on the cycle has these levels.
void take_levels(Running& run, Block& block) {
    const nc::Rules& rules = run.cycle.source->rules;
    const bool is_incremental = run.modal[Group::Distance] == Function::Incremental;
    control::CycleLevels& levels = run.cycle.levels;
    if (block.has(nc::Slot::Radius)) {
        levels.retract = control::cycle_retract(rules, block.at(nc::Slot::Radius), is_incremental);
    }
    if (block.has(nc::Slot::Z)) {
        const nc::SlotMask depth = bit(nc::Slot::Z);
        levels.depth = control::cycle_depth(rules, block.at(nc::Slot::Z),
                                            is_incremental && (block.absolute & depth) == 0);
        levels.depth.is_distance |= (block.incremental & depth) != 0;
    }
    const nc::SlotMask words = bit(nc::Slot::Radius) | bit(nc::Slot::Z);
    block.given &= ~words;
    block.incremental &= ~words;
    block.absolute &= ~words;
}

}  // namespace

Done say_cycle(Running& run, const Instruction& instruction, const sema::Slot* registers,
               std::uint32_t at) {
    if (run.recordings.is_open()) return refuse_in_contour(run, "a cycle", at);
    const SourceCycle& source =
        run.code.cycles[static_cast<std::size_t>(instruction.immediate.pair.first)];
    const bool goes_on = run.cycle.is_active &&
                         run.cycle.source->kind == SourceCycle::Kind::Modal &&
                         source.kind == SourceCycle::Kind::Modal;
    if (run.cycle.is_active && !goes_on && source.kind != SourceCycle::Kind::Called)
        return refuse_beside_cycle(run, "another cycle", at);
    if (goes_on) keep_words(run);
    else run.cycle.held = {}, run.cycle.levels = {};
    run.cycle.source = &source;
    run.cycle.given = 0;
    for (const auto& [parameter, value] : source.fixed) set_argument(run.cycle, parameter, value);
    for (std::size_t i = 0; i < source.arguments.size(); ++i) {
        const sema::Slot slot = registers[instruction.a + i];
        const SourceCycle::Argument argument = source.arguments[i];
        const double value = argument.is_count ? static_cast<double>(slot.integer) : slot.number;
        const bool is_missing =
            argument.is_count ? slot.integer == sema::kNotGivenInteger : value != value;
        if (is_missing) {
            not_given(run, run.code.functions[source.function].parameters[argument.parameter].name,
                      at);
            return kFailed;
        }
        if (!(std::fabs(value) < 1e15)) {
            math_fault(run, sema::MathFault::Overflow, at);
            return kFailed;
        }
        set_argument(run.cycle, argument.parameter, value);
    }
    if (!goes_on) {
        run.cycle.initial = run.modal.position[kToolAxis];
        run.cycle.is_initial_known = run.modal.position.knows(kToolAxis);
        run.cycle.frame = run.modal.frame.now();
        run.cycle.work_offset = run.modal.work_offset;
    }
    run.cycle.is_active = source.kind != SourceCycle::Kind::Once;
    run.cycle.is_due = source.kind != SourceCycle::Kind::Called;
    const std::uint32_t own = run.cycle.given;
    if (source.kind == SourceCycle::Kind::Modal) take_given_levels(run, own);
    if (goes_on) take_kept_words(run);
    return require_no_stroke(run, at) ? require_words(run, at) : kFailed;
}

namespace {

/// What the cycle so far had programmed holds for the next one of the mode, too. What its code has
/// by itself is no word: `G81` does not dwell, and a P from before waits for the next `G82`.
void keep_words(Running& run) {
    const sema::FunctionCode& function = run.code.functions[run.cycle.source->function];
    for (std::size_t i = 0; i < kHeldWords.size(); ++i) {
        const auto parameter = find_parameter(function.parameters, kHeldWords[i].parameter);
        const bool is_fixed = std::ranges::any_of(
            run.cycle.source->fixed, [&](const auto& fixed) { return fixed.first == parameter; });
        if (has_argument(run.cycle, parameter) && !is_fixed)
            run.cycle.held[i] = run.cycle.arguments[*parameter];
    }
}

void take_kept_words(Running& run) {
    const sema::FunctionCode& function = run.code.functions[run.cycle.source->function];
    for (std::size_t i = 0; i < kHeldWords.size(); ++i) {
        const auto parameter = find_parameter(function.parameters, kHeldWords[i].parameter);
        if (run.cycle.held[i] && !has_argument(run.cycle, parameter))
            set_argument(run.cycle, parameter, *run.cycle.held[i]);
    }
}

/// Whether a modal cycle has its levels, and what else has no value of its own.
Done require_words(Running& run, std::uint32_t at) {
    if (run.cycle.source->kind != SourceCycle::Kind::Modal) return kDone;
    const sema::FunctionCode& function = run.code.functions[run.cycle.source->function];
    std::string missing;
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const sema::ParameterInfo& parameter = function.parameters[i];
        const auto word = std::ranges::find(kHeldWords, parameter.name, &HeldWord::parameter);
        const bool is_level = parameter.name == "to" || parameter.name == "retract";
        if (has_argument(run.cycle, i) || parameter.name == "pitch") continue;  // F gives the pitch
        if (!is_level && parameter.has_default) continue;
        if (!missing.empty()) missing += ' ';
        if (word != kHeldWords.end()) missing += word->letter;
        else missing += parameter.name;
    }
    if (missing.empty()) return kDone;
    fault(run, diag::BlockWordMissing, at).arg(run.cycle.source->word).arg(missing);
    return kFailed;
}

/// `said`: the arguments that the block itself has.
void take_given_levels(Running& run, std::uint32_t said) {
    const sema::FunctionCode& function = run.code.functions[run.cycle.source->function];
    const nc::Rules& rules = run.cycle.source->rules;
    const bool is_incremental = run.modal[Group::Distance] == Function::Incremental;
    const auto value = [&](std::string_view name) -> std::optional<double> {
        const std::optional<std::size_t> parameter = find_parameter(function.parameters, name);
        if (!parameter || (said >> *parameter & 1u) == 0) return std::nullopt;
        return run.cycle.arguments[*parameter];
    };
    if (const auto retract = value("retract"))
        run.cycle.levels.retract = control::cycle_retract(rules, *retract, is_incremental);
    if (const auto depth = value("to"))
        run.cycle.levels.depth = control::cycle_depth(rules, *depth, is_incremental);
}

/// The level where the mode began, in the present frame.
std::optional<double> initial_level(Running& run, std::uint32_t at) {
    control::KnownPoint begin;
    begin.value[kToolAxis] = run.cycle.initial;
    begin.is_known[kToolAxis] = run.cycle.is_initial_known;
    const control::KnownPoint here =
        control::change_frame(begin, run.cycle.frame, run.modal.frame.now());
    if (here.is_known[kToolAxis] && run.modal.work_offset == run.cycle.work_offset)
        return here.value[kToolAxis];
    fault(run, diag::SourceCycleLevel, at)
        .arg(run.cycle.source->word)
        .fix("move the tool axis before the cycle begins: `G0 Z50.`");
    return std::nullopt;
}

/// A tapping cycle has its pitch from F: F itself where it counts by the revolution, else F
/// divided by the speed.
Done complete_pitch(Running& run, std::size_t pitch, std::uint32_t at) {
    const bool is_pitch = run.modal[Group::FeedMode] == Function::FeedPerRevolution;
    const bool has_speed = run.modal.speed.is_known() && run.modal.speed.value() > 0 &&
                           run.modal[Group::SpeedMode] != Function::CuttingSpeedOn;
    const bool is_known = run.modal.feed.is_known() && (is_pitch || has_speed) &&
                          run.modal[Group::FeedMode] != Function::FeedInverseTime;
    if (!is_known) {
        fault(run, diag::SourceCyclePitch, at)
            .arg(run.cycle.source->word)
            .arg(is_pitch ? "" : " and S");
        return kFailed;
    }
    set_argument(
        run.cycle, pitch,
        is_pitch ? run.modal.feed.value() : run.modal.feed.value() / run.modal.speed.value());
    return kDone;
}

Done complete_cycle(Running& run, const sema::FunctionCode& function, std::uint32_t at) {
    if (run.cycle.taps_rigidly) {
        set_argument(run.cycle, find_parameter(function.parameters, "floating"), 0);
        if (run.cycle.source->rules.rigid_tap_stops_spindle)
            set_argument(run.cycle, find_parameter(function.parameters, "after"), kSpindleStop);
    }
    const std::optional<std::size_t> pitch = find_parameter(function.parameters, "pitch");
    const bool is_given = std::ranges::any_of(
        run.cycle.source->arguments, [&](const SourceCycle::Argument& argument) {
            return argument.parameter == pitch.value_or(nc::kMaxArguments);
        });
    if (pitch && !is_given && !complete_pitch(run, *pitch, at)) return kFailed;
    if (run.cycle.source->kind != SourceCycle::Kind::Modal) return kDone;
    return complete_levels(run, function, at);
}

/// The level where the mode began is asked for only if a level of the call depends on it.
Done complete_levels(Running& run, const sema::FunctionCode& function, std::uint32_t at) {
    const bool is_incremental = run.modal[Group::Distance] == Function::Incremental;
    const auto complete = [&](std::optional<double> initial) {
        return control::complete_levels(run.cycle.source->rules, run.cycle.levels, is_incremental,
                                        initial, run.cycle.returns_low);
    };
    std::optional<control::CallLevels> levels = complete(std::nullopt);
    if (!levels) {
        const std::optional<double> initial = initial_level(run, at);
        if (!initial) return kFailed;
        levels = complete(initial);
    }
    const auto set = [&](std::string_view name, double level) {
        set_argument(run.cycle, find_parameter(function.parameters, name), level);
    };
    set("retract", levels->retract);
    set("to", levels->depth);
    set("initial", levels->back);
    return kDone;
}

}  // namespace

Done call_cycle(Running& run, const Instruction& instruction, const sema::Slot* registers,
                std::uint32_t at) {
    const sema::FunctionCode& function = run.code.functions[run.cycle.source->function];
    run.cycle.is_due = false;
    run.cycle.is_running = true;
    if (!complete_cycle(run, function, at)) return kFailed;
    if (run.cycle.source->kind != SourceCycle::Kind::Modal)
        run.cycle.motion = run.modal[Group::Motion];
    run.cycle.was_incremental = run.modal[Group::Distance] == Function::Incremental;
    const SourceId source{static_cast<std::uint32_t>(instruction.immediate.pair.first)};
    if (run.cycle.was_incremental) say_distance(run, Function::Absolute, source, at, instruction.c);
    if (run.status.has_failed()) return kFailed;
    if (run.vm.calls.size() > run.options.limits.call_depth) {
        fault(run, diag::CallDepthLimit, at)
            .arg(static_cast<std::int64_t>(run.options.limits.call_depth));
        return kFailed;
    }
    const auto base = static_cast<std::uint32_t>(registers - run.vm.stack.data()) + instruction.a;
    const std::uint32_t outer_loops = run.vm.calls.back().loops;
    CallFrame& frame = run.vm.calls.push();
    frame.function = &function;
    frame.return_to = at + 1;
    frame.base = base;
    frame.given = run.cycle.given;
    frame.promises = run.scopes.promises();
    frame.loops = run.options.trace ? outer_loops + instruction.c : 0;
    run.vm.reserve_stack(std::size_t{base} + function.registers + 8);
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        if ((run.cycle.given >> i & 1u) == 0) continue;
        const sema::ParameterInfo& parameter = function.parameters[i];
        const double factor =
            spared_factor(*run.cycle.source, run.modal.frame.now(), parameter.name);
        set_number(parameter, run.cycle.arguments[i] / factor, run.vm.stack[base + parameter.slot]);
    }
    return kDone;
}

namespace {

void say_distance(Running& run, Function function, SourceId source, std::uint32_t at,
                  unsigned depth) {
    if (!require_room(run, at)) return;
    Block& block = next_block(run, source);
    block.add(function);
    run.modal.take_block(block, run.target.rules());
    if (run.options.trace) keep_trace(run, at, depth, source);
}

}  // namespace

void leave_cycle(Running& run, const Instruction& instruction, std::uint32_t at) {
    const SourceId source = statement_of(instruction);
    run.cycle.is_running = false;
    run.modal.note(Group::Motion, run.cycle.motion, source);
    run.modal.owed.owe_motion();
    if (run.cycle.was_incremental)
        say_distance(run, Function::Incremental, source, at, instruction.c);
}

}  // namespace kadr::expand
