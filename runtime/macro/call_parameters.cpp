// call_parameters.cpp — parameters of a program that is called: copies, and variables of the
// caller.
#include "macro/call_parameters.h"

#include <algorithm>
#include <utility>

#include "base/diagnostics/control.h"
#include "base/diagnostics/control_memory.h"
#include "macro/declared_size.h"
#include "macro/program_base.h"
#include "nc/quoted.h"

namespace kadr::macro {

using nc::ControlStatement;
using nc::quoted;

namespace {

nc::ControlSymbol symbol_of(const nc::ProcedureParameter& parameter) {
    nc::ControlSymbol symbol;
    symbol.name = parameter.declaration.name;
    symbol.type = parameter.type;
    symbol.dimensions = parameter.declaration.dimensions;
    symbol.is_reference = parameter.is_reference;
    return symbol;
}

}  // namespace

Outcome CallParameters::bind(CompiledLine& line, const PreparedCall& call, RunningProgram& callee) {
    const ControlStatement* const head = call.unit->procedure();
    const std::size_t count = head == nullptr ? 0 : head->parameters.size();
    // The main program of a text without a head has the name of its file.
    const std::string name =
        quoted(call.unit->name.empty() ? call.unit->text->name : call.unit->name);
    if (call.unit->has_wrong_head) return Outcome::Nothing;
    if (call.arguments.size() > count) {
        if (head == nullptr) {
            return run_.fail(line, diag::ProcedureMissing, call.arguments[0].span, {name});
        }
        return run_.fail(line, diag::CallArguments, call.arguments[count].span,
                         {name, std::to_string(count), std::to_string(call.arguments.size())});
    }
    if (count == 0) return Outcome::Nothing;
    run_.variables.enter(*callee.level);
    run_.evaluator.enter(*callee.level);
    Outcome done = Outcome::Nothing;
    for (std::size_t i = 0; i < count; ++i) {
        done = bind_parameter(line, call, i);
        if (!goes_on(done)) break;
    }
    run_.variables.enter(*run_.frame->level);
    run_.evaluator.enter(*run_.frame->level);
    return done;
}

Outcome CallParameters::bind_noted(CompiledLine& line, const PreparedCall& call,
                                   RunningProgram& callee) {
    references_.clear();
    const Outcome done = bind(line, call, callee);
    callee.references = std::move(references_);
    return done;
}

Outcome CallParameters::bind_parameter(CompiledLine& line, const PreparedCall& call,
                                       std::size_t index) {
    static const GivenValue kNothing;
    const nc::ControlLine& head = *call.unit->head;
    const nc::ProcedureParameter& parameter = head.statements[0].parameters[index];
    const GivenValue& given_value =
        index < call.arguments.size() ? call.arguments[index] : kNothing;
    run_.variables.level().given[index] = given_value.is_given;
    nc::ControlSymbol symbol = symbol_of(parameter);
    const auto work_out = [&](const nc::Expression& expression, ControlValue& out) {
        return run_.evaluator.run(head, expression, out) == Evaluator::Outcome::Done;
    };
    ControlValue size;
    if (parameter.type_size.is_given() && work_out(parameter.type_size, size)) {
        symbol.text_size = static_cast<std::uint32_t>(
            std::clamp<double>(size.number, 1, run_.language.rules.most_text));
    }
    for (std::size_t i = 0; i < symbol.dimensions; ++i) {
        const nc::Expression& length = parameter.declaration.sizes[i];
        if (length.is_given() && work_out(length, size)) {
            symbol.sizes[i] = static_cast<std::uint32_t>(std::clamp<double>(size.number, 1, 1e6));
        } else if (given_value.variable.symbol != nullptr) {
            symbol.sizes[i] = given_value.variable.symbol->sizes[i];
        }
    }
    if (parameter.is_reference) return bind_reference(line, parameter, given_value, symbol);
    const std::size_t dimensions =
        given_value.is_array ? given_value.variable.symbol->dimensions : std::size_t{0};
    if (given_value.is_given && dimensions != symbol.dimensions) {
        return run_.fail(line, diag::ArgumentDiffers, given_value.span,
                         {quoted(symbol.name), symbol.dimensions > 0 ? "an array" : "one value"});
    }
    if (!has_room_for(run_.variables.level(), symbol)) {
        const std::string name = symbol.name;
        symbol.sizes.fill(1);  // the lines behind speak of it all the same
        run_.variables.declare(std::move(symbol));
        return run_.fail(line, diag::VariablesTooMany,
                         given_value.is_given ? given_value.span : nc::Span{0, 1},
                         {name, std::to_string(kMostElements)});
    }
    const nc::ControlSymbol& added = run_.variables.declare(std::move(symbol));
    const nc::Span span = given_value.is_given ? given_value.span : nc::Span{0, 1};
    const auto set = [&](std::uint32_t position, const ControlValue& value,
                         const Content& content) {
        const auto fault =
            run_.variables.store_element(added, added.slot + position, value, content);
        if (fault.row == nullptr) return Outcome::Nothing;
        if (given_value.is_given && fault.row == &diag::TypesDiffer) {
            const auto type =
                std::ranges::find(run_.language.types, added.type, &nc::TypeName::type);
            const std::string wanted =
                type == run_.language.types.end() ? "one of its type" : std::string(type->name);
            return run_.fail(line, diag::ArgumentDiffers, span, {quoted(added.name), wanted});
        }
        return run_.fail(line, *fault.row, span, fault.arguments);
    };
    if (given_value.is_array) {
        const Store& from = *given_value.variable.store;
        const std::uint32_t most = std::min(added.count(), given_value.variable.symbol->count());
        Outcome done = Outcome::Nothing;
        for (std::uint32_t i = 0; i < most && goes_on(done); ++i) {
            const ControlValue& value = from.values[given_value.variable.slot + i];
            if (!value.is_vacant()) done = set(i, value, from.content(value));
        }
        return done;
    }
    if (given_value.is_given) {
        const Content content{given_value.text, &given_value.frame};
        return set(0, run_.evaluator.keep(given_value.value, content), content);
    }
    const std::vector<nc::Expression>& defaults = parameter.declaration.values;
    Outcome done = Outcome::Nothing;
    for (std::size_t i = 0; i < defaults.size() && i < added.count(); ++i) {
        ControlValue value;
        if (!defaults[i].is_given() || !work_out(defaults[i], value)) continue;
        if (!goes_on(set(static_cast<std::uint32_t>(i), value, run_.evaluator.content(value))))
            done = Outcome::Failed;
    }
    return done;
}

/// The parameter is the caller's variable: of the same type, an array of the same dimensions.
Outcome CallParameters::bind_reference(CompiledLine& line, const nc::ProcedureParameter& parameter,
                                       const GivenValue& given_value, nc::ControlSymbol symbol) {
    const ControlVariables::VariableRef& variable = given_value.variable;
    const nc::Span span = given_value.is_given      ? given_value.span
                          : line.line.calls.empty() ? nc::Span{0, 1}
                                                    : line.line.calls[0].span;
    if (variable.store == nullptr)
        return run_.fail(line, diag::ArgumentNoVariable, span, {quoted(symbol.name)});
    const std::size_t dimensions =
        given_value.is_array ? variable.symbol->dimensions : std::size_t{0};
    if (variable.type != parameter.type || dimensions != symbol.dimensions) {
        const auto type =
            std::ranges::find(run_.language.types, parameter.type, &nc::TypeName::type);
        std::string wanted = symbol.dimensions > 0 ? "an array of " : "a variable of ";
        wanted += type == run_.language.types.end() ? "its type" : type->name;
        return run_.fail(line, diag::ArgumentDiffers, span, {quoted(symbol.name), wanted});
    }
    symbol.slot = variable.slot;
    if (variable.symbol != nullptr) {
        symbol.text_size = variable.symbol->text_size;
        if (given_value.is_array) symbol.sizes = variable.symbol->sizes;
    }
    note_reference(symbol, variable);
    ControlVariables::bind(run_.variables.level(), std::move(symbol), *variable.store);
    return Outcome::Nothing;
}

/// For who looks on: the parameter has the value of the caller's variable, and what the variable
/// was before the call is reported when it returns.
void CallParameters::note_reference(const nc::ControlSymbol& symbol,
                                    const ControlVariables::VariableRef& variable) {
    if (!run_.variables.notes_changes() || symbol.dimensions > 0) return;
    ControlVariables::VariableRef named = variable;
    if (variable.symbol == nullptr && variable.store == &run_.frame->level->locals)
        named.symbol = declared_at(*run_.frame->level, variable.slot);
    ControlVariable before = run_.variables.shown_at(named);
    ControlVariable parameter = before;
    parameter.name = symbol.name;
    run_.variables.note_change({}, std::move(parameter));
    references_.push_back({named, std::move(before)});
}

/// What a program that was left has written into variables of its caller.
void CallParameters::note_returned(const RunningProgram& left) {
    for (const ReturnedVariable& reference : left.references) {
        ControlVariable now = run_.variables.shown_at(reference.variable);
        const ControlVariable& before = reference.before;
        const bool is_same =
            now.kind == before.kind && now.number == before.number && now.text == before.text;
        if (!is_same) run_.variables.note_change(before, std::move(now));
    }
}

}  // namespace kadr::macro
