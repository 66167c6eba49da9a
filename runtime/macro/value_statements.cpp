// value_statements.cpp — statements that set variables and declare them.
#include "macro/value_statements.h"

#include <array>
#include <cmath>

#include "base/diagnostics/control.h"
#include "base/diagnostics/control_memory.h"
#include "macro/declared_size.h"
#include "macro/program_base.h"

namespace kadr::macro {

using nc::Block;
using nc::ControlStatement;
using nc::Function;
using nc::Span;

Outcome ValueStatements::assign(CompiledLine& line, const ControlStatement& statement, Block& out) {
    if (!statement.list.empty()) return assign_list(line, statement);
    ControlValue value;
    Outcome done = run_.evaluate(line, statement.value, value);
    if (!goes_on(done)) return done;
    // Writing some variables acts: an alarm, a stop.
    const nc::ControlInstruction& load = statement.variable.load;
    nc::SystemQuantity quantity = nc::SystemQuantity::None;
    if (load.kind == nc::ControlInstruction::Kind::System)
        quantity = static_cast<nc::SystemQuantity>(load.index);
    if (load.kind == nc::ControlInstruction::Kind::Family) {
        std::array<std::int64_t, 2> number{};
        if (run_.evaluator.indices(line.line, statement.variable, number) ==
            Evaluator::Outcome::Done)
            quantity = run_.variables.quantity_of(load.index, number[0]);
        // The value of the assignment lives in the texts of the evaluator, not on its stack.
    }
    const std::string comment = utf8_text(line.line.words.comment);
    if (quantity == nc::SystemQuantity::Alarm)
        return raise(line, statement.span, value.number, comment);
    if (quantity == nc::SystemQuantity::MessageStop) return stop_with_message(comment, out);
    done = fit_text(line, statement, value);
    return goes_on(done) ? run_.store(line, statement.variable, value) : done;
}

/// A text that is too long for its variable is cut off. That of a constant is not, which is
/// reported where it is stored, and one that is put together is reported as such. S 8.2.
Outcome ValueStatements::fit_text(CompiledLine& line, const ControlStatement& statement,
                                  ControlValue& value) {
    using Kind = nc::ControlInstruction::Kind;
    if (!value.is_text() || statement.variable.load.kind != Kind::Element) return Outcome::Nothing;
    const nc::ControlSymbol& symbol =
        run_.variables.level().symbols.at(statement.variable.load.index);
    const std::string text(run_.evaluator.text(value));
    const nc::Expression& expression = statement.value;
    const nc::ControlInstruction& last = line.line.code[expression.first + expression.count - 1];
    const std::size_t length = count_code_points(text);
    const bool fits = symbol.type != nc::ValueType::Text || length <= symbol.text_size;
    if (fits || last.kind == Kind::Text) return Outcome::Nothing;
    if (last.kind == Kind::Operate && last.operation == nc::Operation::Concatenate)
        return run_.fail(line, diag::JoinedTooLong, expression.span,
                         {std::to_string(length), std::to_string(symbol.text_size)});
    value = run_.evaluator.keep_text(std::string(code_points(text, 0, symbol.text_size)));
    return Outcome::Nothing;
}

/// `SET(1,,3)`, `REP(0)`, `REP(0,3)`: for elements of an array, or for variables with numbers.
Outcome ValueStatements::assign_list(CompiledLine& line, const ControlStatement& statement) {
    ListTarget target;
    Outcome done = list_target(line, statement.variable, target);
    if (!goes_on(done)) return done;
    std::size_t count = statement.list.size();
    if (statement.fills) {
        done = fill_count(line, statement.list, target.left, count);
        if (!goes_on(done)) return done;
    } else if (count > target.left) {
        return run_.fail(line, diag::TooManyInitialValues, statement.span, {target.name});
    }
    for (std::size_t i = 0; i < count; ++i) {
        const nc::Expression& expression = statement.list[statement.fills ? 0 : i];
        if (!expression.is_given()) continue;
        ControlValue value;
        done = run_.evaluate(line, expression, value);
        if (!goes_on(done)) return done;
        const auto fault = store_at(target, static_cast<std::uint32_t>(i), value);
        if (fault.row != nullptr)
            return run_.fail(line, *fault.row, expression.span, fault.arguments);
    }
    return Outcome::Nothing;
}

/// How many variables get the value of a filling: so many as its second number is, else all.
Outcome ValueStatements::fill_count(CompiledLine& line, std::span<const nc::Expression> expressions,
                                    std::size_t most, std::size_t& out) {
    out = most;
    if (expressions.size() < 2 || !expressions[1].is_given()) return Outcome::Nothing;
    ControlValue number;
    const Outcome done = run_.evaluate(line, expressions[1], number);
    if (!run_.is_sound(done)) return done;
    if (!(number.number >= 1) || number.number > static_cast<double>(most))
        return run_.fail(line, diag::TooManyInitialValues, expressions[1].span, {"this"});
    out = static_cast<std::size_t>(number.number);
    return Outcome::Nothing;
}

/// Where the values of a list go: from this element on, or from the variable of this number on.
Outcome ValueStatements::list_target(CompiledLine& line, const nc::Reference& reference,
                                     ListTarget& out) {
    using Kind = nc::ControlInstruction::Kind;
    out.load = reference.load;
    out.name = line.text.substr(reference.span.begin, reference.span.end - reference.span.begin);
    std::array<std::int64_t, 4> indices{};
    switch (run_.evaluator.indices(line.line, reference, indices)) {
        case Evaluator::Outcome::Done: break;
        case Evaluator::Outcome::Later: return Outcome::Wait;
        case Evaluator::Outcome::Fault: return run_.fail(line, run_.evaluator.fault());
    }
    if (out.load.kind == Kind::Element) {
        const nc::ControlSymbol& symbol = run_.variables.level().symbols.at(out.load.index);
        const auto first = Evaluator::element(symbol, indices);
        if (!first) {
            return run_.fail(line, diag::IndexWrong, reference.span,
                             {Evaluator::wrong_index(symbol, indices)});
        }
        out.first = *first;
        out.left = symbol.slot + symbol.count() - *first;
        out.name = symbol.name;
        return Outcome::Nothing;
    }
    const bool is_family = out.load.kind == Kind::Family;
    if (!is_family && out.load.kind != Kind::Global)
        return run_.fail(line, diag::IndexWrong, reference.span, {"this variable"});
    const nc::VariableRange* range =
        is_family ? find_range(run_.language.variables[out.load.index], indices[0])
                  : range_of_slot(run_.language, out.load.index);
    if (range == nullptr || range->kind != nc::VariableRange::Kind::Global)
        return run_.fail(line, diag::IndexWrong, reference.span, {"this variable"});
    const std::uint32_t behind_first = is_family
                                           ? static_cast<std::uint32_t>(indices[0] - range->first)
                                           : out.load.index - range->slot;
    out.load.kind = Kind::Global;
    out.load.type = range->type;
    out.first = range->slot + behind_first;
    out.left = static_cast<std::uint32_t>(range->last - range->first) + 1 - behind_first;
    return Outcome::Nothing;
}

VariableFault ValueStatements::store_at(const ListTarget& target, std::uint32_t i,
                                        const ControlValue& value) {
    const Content content = run_.evaluator.content(value);
    if (target.load.kind == nc::ControlInstruction::Kind::Element) {
        return run_.variables.store_element(run_.variables.level().symbols.at(target.load.index),
                                            target.first + i, value, content);
    }
    nc::ControlInstruction load = target.load;
    load.index = target.first + i;
    return run_.variables.store(load, {}, value, content);
}

Outcome ValueStatements::declare(CompiledLine& line, const ControlStatement& statement) {
    if (statement.scope.begin != statement.scope.end && !run_.frame->is_definition)
        return run_.fail(line, diag::ScopeMisplaced, statement.scope);
    if (run_.frame->has_executed)
        return run_.fail(line, diag::DeclarationMisplaced, statement.span);
    // Behind a mistake names are declared for the sake of the lines that are only read.
    const bool had_failed = run_.lines.faults().failed();
    std::uint32_t characters = 0;
    Outcome done = text_size(line, statement.type_size, characters);
    if (done != Outcome::Wait && run_.frame->is_definition) done = limit(line, statement);
    for (const nc::Declaration& declaration : statement.declarations) {
        if (done == Outcome::Wait || (run_.lines.faults().failed() && !had_failed)) return done;
        done = declare_one(line, declaration, statement.type, characters);
    }
    return done;
}

/// The least and the greatest value that variables may hold, `LLI 0 ULI 100`.
Outcome ValueStatements::limit(CompiledLine& line, const ControlStatement& statement) {
    ControlVariables::Limits limits;
    ControlValue bound;
    for (const bool is_least : {true, false}) {
        const nc::Expression& expression = is_least ? statement.value : statement.second;
        if (!expression.is_given()) continue;
        const Outcome done = run_.evaluate(line, expression, bound);
        if (!run_.is_sound(done)) return done;
        (is_least ? limits.least : limits.most) = bound.number;
    }
    if (!statement.value.is_given() && !statement.second.is_given()) return Outcome::Nothing;
    for (const nc::Declaration& declaration : statement.declarations)
        run_.variables.limit(declaration.name, limits);
    return Outcome::Nothing;
}

/// Characters of a text variable.
Outcome ValueStatements::text_size(CompiledLine& line, const nc::Expression& expression,
                                   std::uint32_t& out) {
    if (!expression.is_given()) return Outcome::Nothing;
    ControlValue size;
    const Outcome done = run_.evaluate(line, expression, size);
    if (!run_.is_sound(done)) return done;
    if (size.number < 1 || size.number > run_.language.rules.most_text)
        return run_.fail(line, diag::SizeWrong, expression.span, {run_.evaluator.written(size)});
    out = static_cast<std::uint32_t>(size.number);
    return Outcome::Nothing;
}

Outcome ValueStatements::declare_one(CompiledLine& line, const nc::Declaration& declaration,
                                     nc::ValueType type, std::uint32_t characters) {
    nc::ControlSymbol symbol;
    symbol.name = declaration.name;
    symbol.type = type;
    symbol.text_size = characters;
    symbol.dimensions = declaration.dimensions;
    double count = 1;
    const bool had_failed = run_.lines.faults().failed();
    for (std::size_t i = 0; i < declaration.dimensions; ++i) {
        ControlValue length =
            ControlValue::real(1);  // of a parameter whose size the caller's array gives
        Outcome done = Outcome::Nothing;
        if (declaration.sizes[i].is_given())
            done = run_.evaluate(line, declaration.sizes[i], length);
        if (done == Outcome::Wait || (run_.lines.faults().failed() && !had_failed)) return done;
        // Where lines are only read nobody has given the parameters a value.
        if (run_.phase.is_only_checking && !(length.number >= 1)) length = ControlValue::real(1);
        count *= length.number;
        if (!(length.number >= 1) || count > 1e6) {
            return run_.fail(line, diag::SizeWrong, declaration.sizes[i].span,
                             {run_.evaluator.written(length)});
        }
        symbol.sizes[i] = static_cast<std::uint32_t>(length.number);
    }
    if (run_.variables.level().symbols.has_own(symbol.name))
        return run_.fail(line, diag::NameTwice, declaration.span, {symbol.name});
    if (!has_room_for(run_.variables.level(), symbol)) {
        const std::string name = symbol.name;
        symbol.sizes.fill(1);  // the lines behind speak of it all the same
        run_.variables.declare(std::move(symbol));
        return run_.fail(line, diag::VariablesTooMany, declaration.span,
                         {name, std::to_string(kMostElements)});
    }
    const nc::ControlSymbol& added = run_.variables.declare(std::move(symbol));
    std::size_t filled = declaration.values.size();
    if (declaration.fills) {
        const Outcome done = fill_count(line, declaration.values, added.count(), filled);
        if (!run_.is_sound(done)) return done;
    } else if (filled > added.count()) {
        return run_.fail(line, diag::TooManyInitialValues, declaration.span, {added.name});
    }
    for (std::size_t i = 0; i < filled; ++i) {
        const nc::Expression& expression = declaration.values[declaration.fills ? 0 : i];
        if (!expression.is_given()) continue;
        ControlValue value;
        const Outcome done = run_.evaluate(line, expression, value);
        if (!run_.is_sound(done)) return done;
        const auto fault =
            run_.variables.store_element(added, added.slot + static_cast<std::uint32_t>(i), value,
                                         run_.evaluator.content(value));
        if (fault.row == nullptr) continue;
        const bool is_of_type = fault.row == &diag::TypesDiffer;
        return run_.fail(line, is_of_type ? diag::InitialType : *fault.row, expression.span,
                         fault.arguments);
    }
    return Outcome::Nothing;
}

/// The program's own alarm.
Outcome ValueStatements::raise(CompiledLine& line, const Span& span, double number,
                               const std::string& text) {
    const nc::LanguageRules& rules = run_.language.rules;
    const double rounded = std::round(number);
    if (!(rounded >= rules.least_alarm && rounded <= rules.most_alarm))
        return run_.fail(line, diag::AlarmNumber, span,
                         {run_.evaluator.written(ControlValue::real(number))});
    if (run_.counts.given > 0) return Outcome::Wait;
    const std::string shown = std::to_string(std::llround(rounded) + rules.alarm_base);
    const TextLocation location = run_.lines.location(line.text, line.program_line.line.line, span);
    const auto own = run_.dialect.alarm(diag::ProgramAlarm);
    DiagnosticBuilder message = run_.sink.report(diag::ProgramAlarm, location);
    message.arg(shown).alarm((own ? own->number : std::string()) + shown, text);
    run_.lines.faults().write_notes(message);
    run_.lines.faults().note_fault();
    return Outcome::Failed;
}

Outcome ValueStatements::stop_with_message(std::string_view text, Block& out) {
    if (!text.empty()) out.add(Function::Message, 1);
    out.add(Function::Stop);
    out.text = text;
    return Outcome::Block;
}

}  // namespace kadr::macro
