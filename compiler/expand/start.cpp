// start.cpp — which program runs, and with which parameters.
#include "expand/start.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/diagnostics/expand.h"
#include "base/numbers.h"
#include "base/text.h"
#include "expand/contour_values.h"
#include "expand/running.h"

namespace kadr::expand {

using sema::FunctionCode;
using sema::FunctionKind;
using sema::ParameterInfo;

namespace {

constexpr std::size_t kFirstStack = 16384;  // registers

std::string_view trim(std::string_view text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

/// A number with or without a unit, as a parameter of this kind takes it.
std::optional<double> read_quantity(const ParameterInfo& parameter, sema::Units units,
                                    std::string_view text) {
    const char* end = text.data() + text.size();
    const Decimal number = sema::parse_number(text.data(), end);
    if (number.end == text.data()) return std::nullopt;
    const std::string_view rest = trim({number.end, static_cast<std::size_t>(end - number.end)});
    const bool is_feed = parameter.kind == ParameterInfo::Kind::Feed;
    const bool is_speed = parameter.kind == ParameterInfo::Kind::Speed;
    const sema::Quantity first = is_feed    ? sema::kFeedPerTime
                                 : is_speed ? sema::kSpindleSpeed
                                            : parameter.quantity;
    if (rest.empty()) return number.value * sema::bare_factor(first, units);
    const std::optional<sema::UnitInfo> unit = sema::find_unit(rest);
    if (!unit) return std::nullopt;
    const double inverse = std::nearbyint(1 / unit->factor);
    const bool divides = unit->factor < 1 && std::fabs(1 / unit->factor - inverse) < 1e-9;
    const double value = divides ? number.value / inverse : number.value * unit->factor;
    if (unit->quantity == first) return value;
    const bool second = (is_feed && unit->quantity == sema::kFeedPerTurn) ||
                        (is_speed && unit->quantity == sema::kFeedPerTime);
    if (second) return value * sema::kSecondForm;
    return std::nullopt;
}

/// A note for what no line of a source has.
std::string from_command_line(std::string_view name, std::string_view value) {
    return "it is set by the option `-D " + std::string(name) + '=' + std::string(value) + '`';
}

const FunctionCode* find_program(Running& run, std::string_view name) {
    std::vector<std::string_view> names;
    const FunctionCode* first = nullptr;
    for (const FunctionCode& function : run.code.functions) {
        if (function.kind != FunctionKind::Program || !function.is_main_file) continue;
        if (!name.empty() && function.name == name) return &function;
        names.push_back(function.name);
        if (names.size() == 1) first = &function;
    }
    if (name.empty() && names.size() == 1) return first;
    if (names.empty()) {
        DiagnosticBuilder builder = run.sink.report(diag::NoProgram, {run.code.main_file, 0, 0});
        const auto callable = std::find_if(
            run.code.functions.begin(), run.code.functions.end(), [](const FunctionCode& function) {
                return function.is_main_file && function.kind == FunctionKind::Cycle;
            });
        if (callable != run.code.functions.end()) {
            builder.fix("call it from one: `program main() { " + callable->name + "(…); }`");
        }
        return nullptr;
    }
    std::string all;
    for (const std::string_view other : names) {
        if (!all.empty()) all += ", ";
        all += other;
    }
    if (name.empty()) {
        run.sink.report(diag::ProgramChoice, {run.code.main_file, 0, 0})
            .arg(all)
            .fix("name one: `--program " + std::string(names[0]) + '`');
        return nullptr;
    }
    DiagnosticBuilder builder = run.sink.report(diag::UnknownProgram);
    builder.arg(name);
    builder.note("it is asked for by the option `--program`");
    builder.note("the file has: " + all);
    return nullptr;
}

}  // namespace

void prepare(Running& run, const FunctionCode& function) {
    run.vm.reserve_stack(std::max(kFirstStack, std::size_t{run.code.globals} + function.registers +
                                                   run.code.functions[0].registers + 16));
    run.modal = ModalState::at_start(function, run.target.power_on(nc::Group::Diameter));
}

Slot& argument_register(Running& run, std::size_t slot) {
    return run.vm.stack[run.code.globals + slot];
}

void enter(Running& run, const FunctionCode& function, std::uint32_t given,
           std::uint32_t return_to) {
    const std::size_t number = static_cast<std::size_t>(&function - run.code.functions.data());
    CallFrame& program = run.vm.calls.push();
    program = {};
    program.function = &function;
    program.base = run.code.globals;
    program.given = given;
    program.return_to = return_to;
    // The globals get their values first; their return goes on at the program's entry.
    const FunctionCode& startup = run.code.functions[0];
    CallFrame& first = run.vm.calls.push();
    first = {};
    first.function = &startup;
    first.base = run.code.globals + function.registers;
    first.return_to = run.vm.beginning_of(function, number, given);
    run.vm.pc = startup.entry;
    run.status.begin();
}

Done set_parameter(Running& run, const FunctionCode& function, const ParameterInfo& parameter,
                   const std::string& text, Slot& slot) {
    const std::string_view value = trim(text);
    const auto wrong = [&](const std::string& wanted) {
        run.sink.report(diag::DefineValue)
            .arg(parameter.name)
            .arg(wanted)
            .arg(value)
            .note(from_command_line(parameter.name, text))
            .note(parameter.range, "it is declared here");
        return kFailed;
    };
    switch (parameter.kind) {
        case ParameterInfo::Kind::Bool:
            if (value == run.code.true_word || value == "true" || value == "yes" || value == "1") {
                slot.integer = 1;
            } else if (value == run.code.false_word || value == "false" || value == "no" ||
                       value == "0") {
                slot.integer = 0;
            } else {
                return wrong(run.code.true_word + " or " + run.code.false_word);
            }
            return kDone;
        case ParameterInfo::Kind::Integer: {
            const auto read =
                std::from_chars(value.data(), value.data() + value.size(), slot.integer);
            if (read.ec != std::errc() || read.ptr != value.data() + value.size())
                return wrong("a whole number");
            return kDone;
        }
        case ParameterInfo::Kind::Number:
        case ParameterInfo::Kind::Feed:
        case ParameterInfo::Kind::Speed: {
            const std::optional<double> number = read_quantity(parameter, function.units, value);
            if (!number) {
                return wrong(parameter.type_name == "real"
                                 ? "a number"
                                 : "a number with a unit of " + parameter.type_name);
            }
            slot.number = *number;
            return kDone;
        }
        case ParameterInfo::Kind::Text: slot.integer = run.vm.heap.new_text(text); return kDone;
        case ParameterInfo::Kind::Enum: {
            std::string all;
            for (const auto& [name, member] : run.code.enums[parameter.enumeration].members) {
                if (name == value) {
                    slot.integer = member;
                    return kDone;
                }
                if (!all.empty()) all += ", ";
                all += name;
            }
            return wrong("one of " + all);
        }
        case ParameterInfo::Kind::Contour:
        case ParameterInfo::Kind::Other: break;
    }
    run.sink.report(diag::DefineType)
        .arg(parameter.name)
        .arg(parameter.type_name)
        .note(from_command_line(parameter.name, text))
        .note(parameter.range, "it is declared here");
    return kFailed;
}

Done start(Running& run, std::string_view name, const std::vector<sema::Define>& defines) {
    run.status.note_failure();
    const FunctionCode* function = find_program(run, name);
    if (function == nullptr) return kFailed;
    prepare(run, *function);
    if (function->work_offset != run.target.first_work_offset())
        run.modal.owed.owe_work_offset(function->work_offset);
    bool is_good = true;
    std::uint32_t given = 0;
    for (const sema::Define& define : defines) {
        const auto found =
            std::find_if(function->parameters.begin(), function->parameters.end(),
                         [&](const ParameterInfo& p) { return p.name == define.name; });
        if (found == function->parameters.end()) {
            DiagnosticBuilder builder = run.sink.report(diag::DefineUnknown);
            builder.arg(function->name).arg(define.name);
            std::vector<std::string_view> names;
            for (const ParameterInfo& parameter : function->parameters)
                names.push_back(parameter.name);
            if (const auto near = nearest_name(define.name, names.data(), names.size())) {
                builder.fix("did you mean `" + std::string(*near) + "`?");
            }
            builder.note(from_command_line(define.name, define.value));
            builder.note(function->range, "the program is declared here");
            is_good = false;
            continue;
        }
        const auto index = static_cast<unsigned>(found - function->parameters.begin());
        if ((given >> index & 1u) != 0) {
            run.sink.report(diag::DefineTwice)
                .arg(define.name)
                .note(from_command_line(define.name, define.value));
            is_good = false;
        }
        given |= 1u << index;
        if (!set_parameter(run, *function, *found, define.value,
                           argument_register(run, found->slot)))
            is_good = false;
    }
    for (std::size_t i = 0; i < function->parameters.size(); ++i) {
        const ParameterInfo& parameter = function->parameters[i];
        if (parameter.has_default || (given >> i & 1u) != 0) continue;
        run.sink.report(diag::DefineMissing, parameter.range)
            .arg(function->name)
            .arg(parameter.name)
            .fix(parameter.kind == ParameterInfo::Kind::Other ||
                         parameter.kind == ParameterInfo::Kind::Contour
                     ? "give it a default value: no option can set `" + parameter.type_name + '`'
                     : "give it on the command line: `-D " + parameter.name + "=…`");
        is_good = false;
    }
    if (!is_good) return kFailed;
    enter(run, *function, given);
    return kDone;
}

bool set_number(const ParameterInfo& parameter, double value, Slot& slot) {
    switch (parameter.kind) {
        case ParameterInfo::Kind::Number: slot.number = value; return true;
        case ParameterInfo::Kind::Feed:
        case ParameterInfo::Kind::Speed: slot.number = value / 60; return true;
        case ParameterInfo::Kind::Bool:
        case ParameterInfo::Kind::Integer:
        case ParameterInfo::Kind::Enum:
            slot.integer = static_cast<std::int64_t>(std::llround(value));
            return true;
        case ParameterInfo::Kind::Text:
        case ParameterInfo::Kind::Contour:
        case ParameterInfo::Kind::Other: break;
    }
    return false;
}

Done start_cycle(Running& run, std::string_view name, std::span<const double> arguments,
                 std::uint32_t given, const Expander::Surroundings& at) {
    run.status.note_failure();
    const auto found = std::find_if(
        run.code.functions.begin(), run.code.functions.end(), [&](const FunctionCode& f) {
            return f.kind == FunctionKind::Cycle && f.name == name && f.end > f.entry;
        });
    if (found == run.code.functions.end()) {
        run.sink.report(diag::UnknownCycle).arg(name);
        return kFailed;
    }
    const FunctionCode& function = *found;
    prepare(run, function);
    run.options.native_cycles = false;  // this is the body of a native one
    // Whether X is a diameter the program has set that calls it; a cycle that needs diameters
    // where it has set radii begins with that.
    const bool turns = run.modal.owed.diameter() != nc::Function::None;
    const bool needs_diameter = turns && !at.x_is_diameter;
    run.modal.take_diameter_of_caller(needs_diameter);
    AxisValues position = at.position;
    if (needs_diameter) position[index(Axis::X)] *= 2;
    run.modal.position.set_all(position);
    run.modal.feed.begin_with(at.feed);
    run.modal.speed.begin_with(at.speed);
    if (at.spindle == path::SpindleMode::Cw) run.modal.set_spindle(3, {});
    if (at.spindle == path::SpindleMode::Ccw) run.modal.set_spindle(4, {});
    const bool takes_shape = std::ranges::any_of(function.parameters, [](const ParameterInfo& p) {
        return p.kind == ParameterInfo::Kind::Contour;
    });
    // A cycle along a shape works in the plane of that, one that turns in the plane that acts.
    if (at.shape != nullptr && (takes_shape || turns)) {
        run.modal.assume(nc::Group::Plane, at.plane == path::Plane::Xy   ? nc::Function::PlaneXy
                                           : at.plane == path::Plane::Zx ? nc::Function::PlaneZx
                                                                         : nc::Function::PlaneYz);
    }
    std::uint32_t set = 0;
    std::size_t next = 0;  // of the arguments
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const ParameterInfo& parameter = function.parameters[i];
        if (parameter.kind == ParameterInfo::Kind::Contour && at.shape != nullptr) {
            argument_register(run, parameter.slot).integer =
                make_contour(run, {*at.shape, at.plane, at.is_diameter}, parameter.layout);
            set |= 1u << i;
            next += arguments.size() + 1 - function.parameters.size();
            continue;
        }
        const std::size_t argument = next++;
        const bool is_given = argument < arguments.size() && (given >> argument & 1u) != 0;
        if (!is_given) {
            if (parameter.has_default) continue;
            run.sink.report(diag::DefineMissing, parameter.range)
                .arg(function.name)
                .arg(parameter.name);
            return kFailed;
        }
        if (!set_number(parameter, arguments[argument], argument_register(run, parameter.slot))) {
            run.sink.report(diag::DefineType).arg(parameter.name).arg(parameter.type_name);
            return kFailed;
        }
        set |= 1u << i;
    }
    enter(run, function, set);
    return kDone;
}

}  // namespace kadr::expand
