// Statements of a control's own language: values, messages, what is said and goes on.
#include <algorithm>
#include <array>
#include <utility>

#include "base/diagnostics/control.h"
#include "base/diagnostics/control_memory.h"
#include "macro/declared_size.h"
#include "macro/program_state.h"
#include "nc/control_words.h"

namespace kadr::macro {

using nc::Block;
using nc::ControlStatement;
using nc::Function;
using nc::Span;
using nc::Statement;

Program::State::Outcome Program::State::execute(CompiledLine& line,
                                                const ControlStatement& statement, Block& out) {
    if (!require_definition(line, statement)) return Outcome::Failed;
    switch (statement.kind) {
        case Statement::None:
        case Statement::JumpToStart:
        case Statement::EndIf:
            if (statement.kind == Statement::EndIf) return leave(line, statement);
            return Outcome::Nothing;
        case Statement::Assign: return assign(line, statement, out);
        case Statement::Jump:
        case Statement::JumpForward:
        case Statement::JumpBackward:
        case Statement::JumpIfThere: return jump(line, statement);
        case Statement::IfDo: return choose(line, statement, out);
        case Statement::Case: return choose_case(line, statement);
        case Statement::If:
        case Statement::While:
        case Statement::Loop:
        case Statement::For:
        case Statement::Repeat: return enter(line, statement);
        case Statement::Else: return otherwise(line, statement);
        case Statement::EndLoop:
        case Statement::Until: return leave(line, statement);
        case Statement::RepeatSection:
        case Statement::RepeatBlock: return repeat_section(line, statement);
        case Statement::Label: return Outcome::Nothing;
        case Statement::CallSection: return call_section(line, statement);
        case Statement::EndSection: {
            if (frames.size() == 1) return Outcome::Nothing;
            ControlStatement end;
            end.kind = Statement::Return;
            end.span = statement.span;
            return execute_call(line, end, out);
        }
        case Statement::Declare: return declare(line, statement);
        case Statement::DefineMacro: return define_macro(line, statement);
        case Statement::Synchronous: return pass_synchronous(line, statement);
        case Statement::RunText: return run_text(line, statement, out);
        case Statement::NameVariables: return name_variables(line, statement);
        case Statement::Print:
        case Statement::PrintBytes:
        case Statement::PrintOpen:
        case Statement::PrintClose: return print(line, statement);
        case Statement::ContourBegin:
        case Statement::ContourCode:
        case Statement::ContourEnd:
        case Statement::ContourRow: return contour(line, statement, out);
        case Statement::WriteFile:
        case Statement::ReadFile:
        case Statement::DeleteFile: return use_file(line, statement);
        case Statement::Call:
        case Statement::CallModal:
        case Statement::CallByText:
        case Statement::EndModal:
        case Statement::Return:
        case Statement::Procedure:
        case Statement::External: return execute_call(line, statement, out);
        case Statement::Alarm: {
            Value number;
            Value text;
            Outcome done = evaluate(line, statement.value, number);
            if (!goes_on(done)) return done;
            if (statement.second.is_given()) done = evaluate(line, statement.second, text);
            if (!goes_on(done)) return done;
            return raise(line, statement.span, number.number, std::string(evaluator.text(text)));
        }
    }
    return Outcome::Nothing;
}

Program::State::Outcome Program::State::assign(CompiledLine& line,
                                               const ControlStatement& statement, Block& out) {
    if (!statement.list.empty()) return assign_list(line, statement);
    Value value;
    Outcome done = evaluate(line, statement.value, value);
    if (!goes_on(done)) return done;
    // Writing some variables acts: an alarm, a stop.
    const nc::Instruction& load = statement.variable.load;
    nc::Quantity quantity = nc::Quantity::None;
    if (load.kind == nc::Instruction::Kind::System)
        quantity = static_cast<nc::Quantity>(load.index);
    if (load.kind == nc::Instruction::Kind::Family) {
        std::array<std::int64_t, 2> number{};
        if (evaluator.indices(line.line, statement.variable, number) == Evaluator::Outcome::Done)
            quantity = variables.quantity_of(load.index, number[0]);
        // The value of the assignment lives in the texts of the evaluator, not on its stack.
    }
    const std::string comment = utf8_text(line.line.words.comment);
    if (quantity == nc::Quantity::Alarm) return raise(line, statement.span, value.number, comment);
    if (quantity == nc::Quantity::MessageStop) return stop_with_message(comment, out);
    done = fit_text(line, statement, value);
    return goes_on(done) ? store(line, statement.variable, value) : done;
}

/// A text that is too long for its variable is cut off. That of a constant is not, which is told
/// where it is stored, and one that is put together is told as such. S 8.2.
Program::State::Outcome Program::State::fit_text(CompiledLine& line,
                                                 const ControlStatement& statement, Value& value) {
    using Kind = nc::Instruction::Kind;
    if (!value.is_text() || statement.variable.load.kind != Kind::Element) return Outcome::Nothing;
    const nc::Symbol& symbol = variables.level().symbols.at(statement.variable.load.index);
    const std::string text(evaluator.text(value));
    const nc::Expression& said = statement.value;
    const nc::Instruction& last = line.line.code[said.first + said.count - 1];
    const std::size_t length = count_code_points(text);
    const bool fits = symbol.type != nc::ValueType::Text || length <= symbol.text_size;
    if (fits || last.kind == Kind::Text) return Outcome::Nothing;
    if (last.kind == Kind::Operate && last.operation == nc::Operation::Concatenate)
        return fail(line, diag::JoinedTooLong, said.span,
                    {std::to_string(length), std::to_string(symbol.text_size)});
    value = evaluator.keep_text(std::string(code_points(text, 0, symbol.text_size)));
    return Outcome::Nothing;
}

Program::State::Outcome Program::State::store(CompiledLine& line, const nc::Reference& reference,
                                              const Value& value) {
    std::array<std::int64_t, 4> indices{};
    if (reference.indices.is_given()) {
        const Evaluator::Outcome outcome = evaluator.indices(line.line, reference, indices);
        if (!missing_inputs.empty()) tell_missing(line);
        switch (outcome) {
            case Evaluator::Outcome::Done: break;
            case Evaluator::Outcome::Later: return Outcome::Wait;
            case Evaluator::Outcome::Fault: return fail(line, evaluator.fault());
        }
    }
    if (variables.must_wait(reference.load, indices)) return Outcome::Wait;
    ControlVariables::Fault fault = store_noted(line, reference, indices, value);
    if (fault.row == nullptr) return Outcome::Nothing;
    // The control's own state has the name that the program says.
    const bool is_family = reference.load.kind == nc::Instruction::Kind::Family;
    const bool is_state = is_family || reference.load.kind == nc::Instruction::Kind::System;
    const auto quantity = is_family ? variables.quantity_of(reference.load.index, indices[0])
                                    : static_cast<nc::Quantity>(reference.load.index);
    if (is_state && !fault.arguments.empty() && fault.arguments[0] == info(quantity).name) {
        fault.arguments[0] =
            line.text.substr(reference.span.begin, reference.span.end - reference.span.begin);
    }
    return fail(line, *fault.row, reference.span, fault.arguments);
}

/// `SET(1,,3)`, `REP(0)`, `REP(0,3)`: for elements of an array, or for variables with numbers.
Program::State::Outcome Program::State::assign_list(CompiledLine& line,
                                                    const ControlStatement& statement) {
    ListPlace place;
    Outcome done = list_place(line, statement.variable, place);
    if (!goes_on(done)) return done;
    std::size_t count = statement.list.size();
    if (statement.fills) {
        done = fill_count(line, statement.list, place.left, count);
        if (!goes_on(done)) return done;
    } else if (count > place.left) {
        return fail(line, diag::TooManyInitialValues, statement.span, {place.name});
    }
    for (std::size_t i = 0; i < count; ++i) {
        const nc::Expression& expression = statement.list[statement.fills ? 0 : i];
        if (!expression.is_given()) continue;
        Value value;
        done = evaluate(line, expression, value);
        if (!goes_on(done)) return done;
        const auto fault = store_at(place, static_cast<std::uint32_t>(i), value);
        if (fault.row != nullptr) return fail(line, *fault.row, expression.span, fault.arguments);
    }
    return Outcome::Nothing;
}

/// How many variables get the value of a filling: so many as its second number says, else all.
Program::State::Outcome Program::State::fill_count(CompiledLine& line,
                                                   std::span<const nc::Expression> said,
                                                   std::size_t most, std::size_t& out) {
    out = most;
    if (said.size() < 2 || !said[1].is_given()) return Outcome::Nothing;
    Value number;
    const Outcome done = evaluate(line, said[1], number);
    if (!is_sound(done)) return done;
    if (!(number.number >= 1) || number.number > static_cast<double>(most))
        return fail(line, diag::TooManyInitialValues, said[1].span, {"this"});
    out = static_cast<std::size_t>(number.number);
    return Outcome::Nothing;
}

/// Where the values of a list go: from this element on, or from the variable of this number on.
Program::State::Outcome Program::State::list_place(CompiledLine& line,
                                                   const nc::Reference& reference, ListPlace& out) {
    using Kind = nc::Instruction::Kind;
    out.load = reference.load;
    out.name = line.text.substr(reference.span.begin, reference.span.end - reference.span.begin);
    std::array<std::int64_t, 4> indices{};
    switch (evaluator.indices(line.line, reference, indices)) {
        case Evaluator::Outcome::Done: break;
        case Evaluator::Outcome::Later: return Outcome::Wait;
        case Evaluator::Outcome::Fault: return fail(line, evaluator.fault());
    }
    if (out.load.kind == Kind::Element) {
        const nc::Symbol& symbol = variables.level().symbols.at(out.load.index);
        const auto first = Evaluator::element(symbol, indices);
        if (!first) {
            return fail(line, diag::IndexWrong, reference.span,
                        {Evaluator::wrong_index(symbol, indices)});
        }
        out.first = *first;
        out.left = symbol.slot + symbol.count() - *first;
        out.name = symbol.name;
        return Outcome::Nothing;
    }
    const bool is_family = out.load.kind == Kind::Family;
    if (!is_family && out.load.kind != Kind::Global)
        return fail(line, diag::IndexWrong, reference.span, {"this variable"});
    const nc::VariableRange* range =
        is_family ? find_range(language.variables[out.load.index], indices[0])
                  : range_of_slot(language, out.load.index);
    if (range == nullptr || range->kind != nc::VariableRange::Kind::Global)
        return fail(line, diag::IndexWrong, reference.span, {"this variable"});
    const std::uint32_t behind_first = is_family
                                           ? static_cast<std::uint32_t>(indices[0] - range->first)
                                           : out.load.index - range->slot;
    out.load.kind = Kind::Global;
    out.load.type = range->type;
    out.first = range->slot + behind_first;
    out.left = static_cast<std::uint32_t>(range->last - range->first) + 1 - behind_first;
    return Outcome::Nothing;
}

ControlVariables::Fault Program::State::store_at(const ListPlace& place, std::uint32_t i,
                                                 const Value& value) {
    const Content content = evaluator.content(value);
    if (place.load.kind == nc::Instruction::Kind::Element) {
        return variables.store_element(variables.level().symbols.at(place.load.index),
                                       place.first + i, value, content);
    }
    nc::Instruction load = place.load;
    load.index = place.first + i;
    return variables.store(load, {}, value, content);
}

Program::State::Outcome Program::State::declare(CompiledLine& line,
                                                const ControlStatement& statement) {
    if (statement.scope.begin != statement.scope.end && !frame->is_definition)
        return fail(line, diag::ScopeMisplaced, statement.scope);
    if (frame->has_executed) return fail(line, diag::DeclarationMisplaced, statement.span);
    // Behind a mistake names are declared for the sake of the lines that are only read.
    const bool had_failed = lines.failed();
    std::uint32_t characters = 0;
    Outcome done = text_size(line, statement.type_size, characters);
    if (done != Outcome::Wait && frame->is_definition) done = limit(line, statement);
    for (const nc::Declaration& declaration : statement.declarations) {
        if (done == Outcome::Wait || (lines.failed() && !had_failed)) return done;
        done = declare_one(line, declaration, statement.type, characters);
    }
    return done;
}

/// The least and the greatest value that variables may hold, `LLI 0 ULI 100`.
Program::State::Outcome Program::State::limit(CompiledLine& line,
                                              const ControlStatement& statement) {
    ControlVariables::Limits limits;
    Value bound;
    for (const bool is_least : {true, false}) {
        const nc::Expression& said = is_least ? statement.value : statement.second;
        if (!said.is_given()) continue;
        const Outcome done = evaluate(line, said, bound);
        if (!is_sound(done)) return done;
        (is_least ? limits.least : limits.most) = bound.number;
    }
    if (!statement.value.is_given() && !statement.second.is_given()) return Outcome::Nothing;
    for (const nc::Declaration& declaration : statement.declarations)
        variables.limit(declaration.name, limits);
    return Outcome::Nothing;
}

/// Characters of a text variable.
Program::State::Outcome Program::State::text_size(CompiledLine& line,
                                                  const nc::Expression& expression,
                                                  std::uint32_t& out) {
    if (!expression.is_given()) return Outcome::Nothing;
    Value size;
    const Outcome done = evaluate(line, expression, size);
    if (!is_sound(done)) return done;
    if (size.number < 1 || size.number > language.rules.most_text)
        return fail(line, diag::SizeWrong, expression.span, {evaluator.written(size)});
    out = static_cast<std::uint32_t>(size.number);
    return Outcome::Nothing;
}

Program::State::Outcome Program::State::declare_one(CompiledLine& line,
                                                    const nc::Declaration& declaration,
                                                    nc::ValueType type, std::uint32_t characters) {
    nc::Symbol symbol;
    symbol.name = declaration.name;
    symbol.type = type;
    symbol.text_size = characters;
    symbol.dimensions = declaration.dimensions;
    double count = 1;
    const bool had_failed = lines.failed();
    for (std::size_t i = 0; i < declaration.dimensions; ++i) {
        Value length = Value::real(1);  // of a parameter whose size the caller's array says
        Outcome done = Outcome::Nothing;
        if (declaration.sizes[i].is_given()) done = evaluate(line, declaration.sizes[i], length);
        if (done == Outcome::Wait || (lines.failed() && !had_failed)) return done;
        // Where lines are only read nobody has given the parameters a value.
        if (is_only_checking && !(length.number >= 1)) length = Value::real(1);
        count *= length.number;
        if (!(length.number >= 1) || count > 1e6) {
            return fail(line, diag::SizeWrong, declaration.sizes[i].span,
                        {evaluator.written(length)});
        }
        symbol.sizes[i] = static_cast<std::uint32_t>(length.number);
    }
    if (variables.level().symbols.has_own(symbol.name))
        return fail(line, diag::NameTwice, declaration.span, {symbol.name});
    if (!has_room_for(variables.level(), symbol)) {
        const std::string name = symbol.name;
        symbol.sizes.fill(1);  // the lines behind speak of it all the same
        variables.declare(std::move(symbol));
        return fail(line, diag::VariablesTooMany, declaration.span,
                    {name, std::to_string(kMostElements)});
    }
    const nc::Symbol& added = variables.declare(std::move(symbol));
    std::size_t filled = declaration.values.size();
    if (declaration.fills) {
        const Outcome done = fill_count(line, declaration.values, added.count(), filled);
        if (!is_sound(done)) return done;
    } else if (filled > added.count()) {
        return fail(line, diag::TooManyInitialValues, declaration.span, {added.name});
    }
    for (std::size_t i = 0; i < filled; ++i) {
        const nc::Expression& expression = declaration.values[declaration.fills ? 0 : i];
        if (!expression.is_given()) continue;
        Value value;
        const Outcome done = evaluate(line, expression, value);
        if (!is_sound(done)) return done;
        const auto fault = variables.store_element(
            added, added.slot + static_cast<std::uint32_t>(i), value, evaluator.content(value));
        if (fault.row == nullptr) continue;
        const bool is_of_type = fault.row == &diag::TypesDiffer;
        return fail(line, is_of_type ? diag::InitialType : *fault.row, expression.span,
                    fault.arguments);
    }
    return Outcome::Nothing;
}

/// The program's own alarm.
Program::State::Outcome Program::State::raise(CompiledLine& line, const Span& span, double number,
                                              const std::string& text) {
    const nc::LanguageRules& rules = language.rules;
    const double rounded = std::round(number);
    if (!(rounded >= rules.least_alarm && rounded <= rules.most_alarm))
        return fail(line, diag::AlarmNumber, span, {evaluator.written(Value::real(number))});
    if (given > 0) return Outcome::Wait;
    const std::string shown = std::to_string(std::llround(rounded) + rules.alarm_base);
    const LinePlace place = lines.place(line.text, line.place.line.line, span);
    const auto own = dialect.alarm(diag::ProgramAlarm);
    DiagnosticBuilder message = sink.report(diag::ProgramAlarm, place);
    message.arg(shown).alarm((own ? own->number : std::string()) + shown, text);
    lines.write_notes(message);
    lines.note_fault();
    return Outcome::Failed;
}

Program::State::Outcome Program::State::define_macro(CompiledLine& line,
                                                     const ControlStatement& statement) {
    switch (frame->macros.define(tables, statement.name)) {
        case TextMacros::Fault::None: break;
        case TextMacros::Fault::Form: return fail(line, diag::MacroForm, statement.span);
        case TextMacros::Fault::Known:
            return fail(line, diag::MacroTwice, statement.span,
                        {statement.name.substr(0, statement.name.find(' '))});
        case TextMacros::Fault::Nested:
            return fail(line, diag::MacroNested, statement.span, {statement.name});
    }
    return Outcome::Nothing;
}

/// A line with the words that stand for text put in; one that defines such a word stays as it is.
std::string_view Program::State::with_macros(std::string_view text) {
    if (!variable_names.empty()) text = with_names(text);
    if (frame->macros.is_empty()) return text;
    if (nc::front_of(tables, text).statement == Statement::DefineMacro) return text;
    auto expanded = frame->macros.expanded(tables, text);
    if (!expanded) return text;
    expanded_text = std::move(*expanded);
    return expanded_text;
}

/// A text as a block of its own. What of it was executed before it had to wait for other blocks is
/// not executed again.
Program::State::Outcome Program::State::run_text(CompiledLine& line,
                                                 const ControlStatement& statement, Block& out) {
    if (!running_text) {
        Value text;
        const Outcome done = evaluate(line, statement.second, text);
        if (!goes_on(done)) return done;
        if (!text.is_text()) {
            return fail(line, diag::TypesDiffer, statement.span,
                        {"a block", std::string(kind_name(text))});
        }
        auto block = std::make_unique<CompiledLine>();
        block->text = evaluator.text(text);
        block->place = line.place;
        const nc::LineFront front = nc::front_of(tables, block->text);
        const bool is_head = front.statement == Statement::Declare ||
                             front.statement == Statement::Procedure ||
                             front.statement == Statement::RunText;
        if (is_head || !front.label.empty())
            return fail(line, diag::TextNoBlock, statement.span, {block->text});
        running_text = RunningText{std::move(block), 0};
    }
    const std::size_t outer = std::exchange(frame->resume, running_text->resume);
    CompiledLine& block = *running_text->line;
    const Outcome done = run(block, out);
    running_text->resume = std::exchange(frame->resume, outer);
    if (done == Outcome::Wait) return done;
    running_text.reset();
    return done;
}

/// `500[WIDTH,DEPTH]`: the names stand for #500, #501 … from here on.
/// source: F 6.6
Program::State::Outcome Program::State::name_variables(CompiledLine& line,
                                                       const ControlStatement& statement) {
    constexpr std::size_t kLongest = 8;
    constexpr std::int64_t kFirst = 500;
    constexpr std::int64_t kLast = 549;
    const std::string& said = statement.name;
    const auto wrong = [&](const DiagnosticRow& row, std::string_view what) {
        return fail(line, row, statement.span, {std::string(what)});
    };
    const std::size_t open = said.find(language.index_open);
    const bool is_closed = said.ends_with(language.index_close) && open != std::string::npos;
    std::int64_t number = 0;
    for (std::size_t i = 0; is_closed && i < open; ++i) {
        if (said[i] < '0' || said[i] > '9' || number > kLast) return wrong(diag::NamesForm, said);
        number = number * 10 + (said[i] - '0');
    }
    if (!is_closed || open == 0) return wrong(diag::NamesForm, said);
    std::string_view rest = std::string_view(said).substr(open + 1, said.size() - open - 2);
    for (;; ++number) {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        std::string name(rest.substr(0, comma));
        std::erase(name, ' ');
        const bool is_name =
            !name.empty() && name[0] >= 'A' && name[0] <= 'Z' &&
            std::ranges::all_of(name, [](char c) {
                return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
            });
        if (!is_name) return wrong(diag::NamesSign, name);
        if (name.size() > kLongest) return wrong(diag::NamesLength, name);
        if (number < kFirst || number > kLast)
            return wrong(diag::NamesRange, std::to_string(number));
        variable_names[name] = number;
        if (comma == rest.size()) return Outcome::Nothing;
        rest.remove_prefix(comma + 1);
    }
}

/// `[#WIDTH]=5`, `X[#WIDTH]`: names of variables become their numbers.
std::string_view Program::State::with_names(std::string_view text) {
    if (variable_names.empty() || text.find('#') == std::string_view::npos) return text;
    const nc::ControlWords words(tables, text);
    const auto is_of_name = [](char c) {
        return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    };
    std::string named;
    for (std::size_t at = 0; at < text.size();) {
        if (words.is_comment(at)) {
            named += text.substr(at);
            break;
        }
        std::size_t end = at + 1;
        while (text[at] == '#' && end < text.size() && is_of_name(text[end])) ++end;
        const auto known = text[at] == '#'
                               ? variable_names.find(std::string(text.substr(at + 1, end - at - 1)))
                               : variable_names.end();
        if (known == variable_names.end()) {
            named += text[at++];
            continue;
        }
        // Alone between brackets at the front it is the variable that is set.
        const bool is_front = named.ends_with('[') && end < text.size() && text[end] == ']' &&
                              words.skip_blanks(end + 1) < text.size() &&
                              text[words.skip_blanks(end + 1)] == '=';
        if (is_front) named.pop_back();
        named += '#' + std::to_string(known->second);
        at = end + (is_front ? 1 : 0);
    }
    named_text = std::move(named);
    return named_text;
}

/// What happens beside the motion is not executed; each such action is said once.
Program::State::Outcome Program::State::pass_synchronous(CompiledLine& line,
                                                         const ControlStatement& statement) {
    if (!said_synchronous.insert({frame->unit, line.place.line.offset}).second)
        return Outcome::Nothing;
    const nc::ControlWords words(tables, line.text);
    std::size_t end = statement.span.begin;
    while (end < line.text.size() && !words.is_comment(end)) ++end;
    const Span whole{statement.span.begin,
                     static_cast<std::uint32_t>(words.trim(statement.span.begin, end))};
    DiagnosticBuilder message =
        sink.report(diag::SynchronousPassed, lines.place(line.text, line.place.line.line, whole));
    message.arg(line.text.substr(whole.begin, whole.end - whole.begin));
    lines.write_notes(message);
    return Outcome::Nothing;
}

Program::State::Outcome Program::State::stop_with_message(std::string_view text, Block& out) {
    if (!text.empty()) out.add(Function::Message, 1);
    out.add(Function::Stop);
    out.text = text;
    return Outcome::Block;
}

}  // namespace kadr::macro
