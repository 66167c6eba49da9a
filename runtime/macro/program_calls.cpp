// Programs that call each other: subprograms and macros, modal calls, returns.
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/diagnostics/control.h"
#include "base/diagnostics/control_memory.h"
#include "base/diagnostics/doubtful.h"
#include "base/diagnostics/iso.h"
#include "macro/declared_size.h"
#include "macro/named_shape.h"
#include "macro/program_state.h"
#include "nc/control_words.h"
#include "nc/number_text.h"

namespace kadr::macro {

using nc::Block;
using nc::CallForm;
using nc::ControlStatement;
using nc::Function;
using nc::Statement;

namespace {

/// Whether an axis moves in the block, as far as words tell.
bool moves(const Block& block) {
    if ((block.given & (nc::kTargetSlots | nc::kPolarSlots)) != 0) return true;
    // A full circle names no end, and an arc may say the angle that it goes.
    const bool is_arc_said = (block.given & (nc::kArcSlots | bit(nc::Slot::Opening))) != 0;
    if (is_arc_said &&
        (block.motion == Function::None || nc::has_fact(block.motion, nc::Fact::Circle)))
        return true;
    return block.find(Function::ReferenceReturn) != nullptr ||
           block.find(Function::ReferencePoint) != nullptr;
}

/// 10 to the power of so many digits.
std::int64_t power_of_ten(int digits) {
    std::int64_t out = 1;
    for (int i = 0; i < digits; ++i) out *= 10;
    return out;
}

nc::Symbol symbol_of(const nc::ProcedureParameter& parameter) {
    nc::Symbol symbol;
    symbol.name = parameter.declaration.name;
    symbol.type = parameter.type;
    symbol.dimensions = parameter.declaration.dimensions;
    symbol.is_reference = parameter.is_reference;
    return symbol;
}

std::string quoted(std::string_view name) { return '`' + std::string(name) + '`'; }

}  // namespace

Program::State::Outcome Program::State::execute_call(CompiledLine& line,
                                                     const ControlStatement& statement,
                                                     Block& out) {
    switch (statement.kind) {
        case Statement::Call:
        case Statement::CallByText: return call(line, statement);
        case Statement::CallModal: return call_modal(line, statement, out);
        case Statement::EndModal: return end_modal(line, statement);
        case Statement::Return: return leave_program(line, statement, out);
        case Statement::Procedure: return declare_procedure(line, statement);
        case Statement::External: return check_external(line, statement);
        default: return Outcome::Nothing;
    }
}

// ------------------------------------------------------------------------------ what is called

Program::State::Outcome Program::State::number_of(CompiledLine& line, const nc::CallValue& value,
                                                  std::optional<double>& out) {
    out.reset();
    if (!value.is_given) return Outcome::Nothing;
    if (value.is_plain) {
        out = value.decimal.value;
        return Outcome::Nothing;
    }
    Value found;
    const Outcome done = evaluate(line, value.value, found);
    if (!goes_on(done)) return done;
    if (found.is_text()) return fail(line, diag::TypesDiffer, value.span, {"a count", "a text"});
    if (!found.is_vacant()) out = std::round(found.number);
    return Outcome::Nothing;
}

/// The name of the program, and the passes that its number may hold: 30012 is 3 times 12.
Program::State::Outcome Program::State::program_name(CompiledLine& line,
                                                     const ControlStatement& statement,
                                                     const CallForm* form, PreparedCall& out,
                                                     ProgramName& found) {
    std::string& name = found.name;
    if (statement.kind == Statement::CallByText) {
        Value text;
        const Outcome done = evaluate(line, statement.second, text);
        if (!goes_on(done)) return done;
        if (!text.is_text())
            return fail(line, diag::TypesDiffer, statement.second.span,
                        {"the name of a program", "a number"});
        const std::string_view path = evaluator.text(text);
        name = nc::program_of_path(language.calls, path, tables.notation.ignores_case);
        found.kind = nc::kind_of_path(language.calls, path, tables.notation.ignores_case);
        if (name.empty()) {
            return fail(line, diag::CallIncomplete, statement.second.span,
                        {std::string(evaluator.text(text))});
        }
        return Outcome::Nothing;
    }
    const nc::Call& words = line.line.calls[statement.call];
    name = form != nullptr && !form->fixed.empty() ? form->fixed : words.name;
    found.kind = words.kind;
    if (!name.empty()) return Outcome::Nothing;
    std::optional<double> number;
    const Outcome done = number_of(line, words.program, number);
    if (!goes_on(done)) return done;
    const auto written = [&](const nc::Span& span) {
        return std::vector{line.text.substr(span.begin, span.end - span.begin)};
    };
    if (!number) {
        // A number that is missing names the program that runs: a part of it is called.
        if (words.start.is_given) {
            name = frame->unit->name;
            out.unit = frame->unit;
            return Outcome::Nothing;
        }
        return fail(line, diag::CallIncomplete, words.span, written(words.span));
    }
    if (*number != std::floor(*number) || !(*number >= 1 && *number < 1e12))
        return fail(line, diag::CallIncomplete, words.program.span, written(words.program.span));
    auto whole = static_cast<std::int64_t>(*number);
    const int digits = form != nullptr ? form->split : 0;
    if (digits > 0 && !words.repeats.is_given && whole >= power_of_ten(digits)) {
        out.passes = whole / power_of_ten(digits);
        whole %= power_of_ten(digits);
    }
    name = std::to_string(whole);
    return Outcome::Nothing;
}

Program::State::Outcome Program::State::find_program(CompiledLine& line,
                                                     const ControlStatement& statement,
                                                     const CallForm* form, PreparedCall& out) {
    ProgramName wanted;
    const Outcome done = program_name(line, statement, form, out, wanted);
    if (!goes_on(done)) return done;
    if (out.unit == nullptr) out.unit = units.find(wanted.name, text(), wanted.kind);
    if (out.unit != nullptr) return Outcome::Nothing;
    return missing_program(line, statement, wanted.name);
}

/// A word that could be a name of a program, and is none, is an unknown word.
Program::State::Outcome Program::State::missing_program(CompiledLine& line,
                                                        const ControlStatement& statement,
                                                        const std::string& name) {
    const bool is_by_text = statement.kind == Statement::CallByText;
    const nc::Call* const words = is_by_text ? nullptr : &line.line.calls[statement.call];
    const nc::Span span = is_by_text                     ? statement.second.span
                          : words->program.span.end != 0 ? words->program.span
                                                         : words->span;
    const bool is_free_name =
        words != nullptr && statement.kind == Statement::Call && words->form >= 0 &&
        language.calls.calls[static_cast<std::size_t>(words->form)].code == "{name}";
    const std::string known = tables.unsupported_words(name);
    if (!known.empty()) return fail(line, diag::IsoNotSupported, span, {known});
    if (is_free_name && !externals.contains(name))
        return fail(line, diag::IsoUnknownWord, span, {name});
    return fail(line, diag::ProgramMissing, span,
                {quoted(nc::shown_program(language.calls, name))});
}

/// Of lines that are only read: whether there is such a program at all.
void Program::State::check_call(CompiledLine& line, const ControlStatement& statement) {
    if (statement.kind != Statement::Call && statement.kind != Statement::CallModal) return;
    const nc::Call& words = line.line.calls[statement.call];
    std::string name = words.name;
    // A number that is computed is not known here.
    if (name.empty() && words.program.is_plain && !lines.failed()) {
        PreparedCall ignored;
        ProgramName wanted;
        const CallForm* const form =
            words.form >= 0 ? &language.calls.calls[static_cast<std::size_t>(words.form)] : nullptr;
        program_name(line, statement, form, ignored, wanted);
        name = wanted.name;
    }
    if (name.empty() || units.find(name, text(), words.kind) != nullptr) return;
    missing_program(line, statement, name);
}

Program::State::Outcome Program::State::prepare_passes(CompiledLine& line,
                                                       const nc::CallValue& passes,
                                                       PreparedCall& out) {
    std::optional<double> count;
    const Outcome done = number_of(line, passes, count);
    if (!goes_on(done) || !count) return done;
    if (!(*count >= 1 && *count <= language.rules.most_passes))
        return fail(line, diag::RepeatCount, passes.span, {evaluator.written(Value::real(*count))});
    out.passes = static_cast<std::int64_t>(*count);
    return Outcome::Nothing;
}

/// Labels between which a program runs.
Program::State::Outcome Program::State::prepare_section(CompiledLine& line,
                                                        const ControlStatement& statement,
                                                        PreparedCall& out) {
    if (statement.from.kind == nc::JumpTarget::Kind::None) return Outcome::Nothing;
    const Place head{out.unit->begin, out.unit->begin};
    Place begin;
    Place end;
    const auto find = [&](const nc::JumpTarget& wanted, const Place& from, Place& found) {
        const auto target = resolve(line, wanted);
        if (!target) return target.error();
        const auto fault = out.unit->map.find(*target, Direction::Forward, from, found);
        return fail(line, fault, diag::JumpTargetMissing, wanted.span, quoted(wanted.label));
    };
    Outcome done = find(statement.from, head, begin);
    if (!goes_on(done)) return done;
    done = find(statement.to, begin, end);
    if (!goes_on(done)) return done;
    out.from = begin;
    out.to = end.next;
    return Outcome::Nothing;
}

/// Everything that a call needs, worked out where it stands.
Program::State::Outcome Program::State::prepare(CompiledLine& line,
                                                const ControlStatement& statement,
                                                PreparedCall& out) {
    const bool is_by_text = statement.kind == Statement::CallByText;
    const nc::Call* const words = is_by_text ? nullptr : &line.line.calls[statement.call];
    if (words != nullptr && words->form >= 0)
        out.form = &language.calls.calls[static_cast<std::size_t>(words->form)];
    Outcome done = find_program(line, statement, out.form, out);
    if (!goes_on(done)) return done;
    const nc::Span span = is_by_text ? statement.second.span : words->span;
    out.site = std::make_shared<nc::CallSite>(
        nc::CallSite{lines.place(line.text, line.place.line.line, span), frame->site});
    if (is_by_text) return prepare_section(line, statement, out);
    nc::CallValue passes = words->repeats;
    if (statement.count.is_given()) {  // `CALL O200 Q2`
        passes.is_given = true;
        passes.value = statement.count;
        passes.span = statement.count.span;
    }
    done = prepare_passes(line, passes, out);
    if (!goes_on(done)) return done;
    std::optional<double> start;
    done = number_of(line, words->start, start);
    if (!goes_on(done)) return done;
    if (start) out.start = static_cast<std::int64_t>(*start);
    if (out.is_macro()) return prepare_letters(line, *words, out);
    done = prepare_list(line, *words, out);
    if (!goes_on(done) || out.form == nullptr || out.form->value.empty()) return done;
    std::optional<double> code;
    done = number_of(line, words->code, code);
    if (!goes_on(done)) return done;
    variables.set_global(out.form->value, code.value_or(out.form->number));
    return done;
}

/// Arguments by letters set variables of the level that the macro gets.
Program::State::Outcome Program::State::prepare_letters(CompiledLine& line, const nc::Call& words,
                                                        PreparedCall& out) {
    out.level = variables.new_level();
    for (const nc::CallArgument& argument : words.arguments) {
        if (argument.is_plain) {
            double number = argument.decimal.value;
            if (argument.like != nc::kNoAddress && !argument.decimal.has_point) {
                const nc::Address& address = tables.addresses[argument.like];
                number = read_meaning(argument.decimal, address.format, address.dimension,
                                      lines.units());
            }
            variables.set_argument(*out.level, argument.slot, Value::real(number));
            continue;
        }
        Value value;
        const Outcome done = evaluate(line, argument.value, value);
        if (!goes_on(done)) return done;
        variables.set_argument(*out.level, argument.slot, value);
    }
    return Outcome::Nothing;
}

Program::State::Outcome Program::State::prepare_list(CompiledLine& line, const nc::Call& words,
                                                     PreparedCall& out) {
    for (const nc::CallArgument& argument : words.arguments) {
        GivenValue& given_value = out.arguments.emplace_back();
        given_value.is_given = argument.is_given;
        given_value.is_array = argument.is_array;
        given_value.span = argument.span;
        if (!argument.is_given) continue;
        if (argument.variable.is_given()) {
            std::array<std::int64_t, 4> indices{};
            if (argument.variable.indices.is_given() && !argument.is_array) {
                const auto outcome = evaluator.indices(line.line, argument.variable, indices);
                if (outcome == Evaluator::Outcome::Later) return Outcome::Wait;
                if (outcome == Evaluator::Outcome::Fault) return fail(line, evaluator.fault());
            }
            given_value.place = variables.place_of(argument.variable.load, indices);
        }
        if (argument.is_array) continue;
        const Outcome done = evaluate(line, argument.value, given_value.value);
        if (!goes_on(done)) return done;
        given_value.text = evaluator.text(given_value.value);
        if (given_value.value.is_frame()) given_value.frame = *evaluator.frame(given_value.value);
    }
    return Outcome::Nothing;
}

// ------------------------------------------------------------------------------ calls

Program::State::Outcome Program::State::call(CompiledLine& line,
                                             const ControlStatement& statement) {
    const bool is_words_of_block = statement.kind == Statement::Call &&
                                   line.line.calls[statement.call].form < 0 &&
                                   line.line.calls[statement.call].name.empty();
    if (is_words_of_block) return call_with_block(line);
    Outcome done = Outcome::Nothing;
    if (statement.kind == Statement::Call) {
        const nc::CallValue& code = line.line.calls[statement.call].code;
        std::optional<double> number;
        done = number_of(line, code, number);
        if (!goes_on(done)) return done;
        // `T#1`: a word without a value is not there.
        if (code.is_given && !number) return Outcome::Nothing;
    }
    PreparedCall prepared;
    done = prepare(line, statement, prepared);
    if (!goes_on(done)) return done;
    return begin(line, prepared);
}

/// A section of this program by its label; with a count it is repeated instead.
Program::State::Outcome Program::State::call_section(CompiledLine& line,
                                                     const ControlStatement& statement) {
    Value count = Value::real(0);
    Outcome done = Outcome::Nothing;
    if (statement.count.is_given()) done = evaluate(line, statement.count, count);
    if (!goes_on(done)) return done;
    if (count.number != 0) return repeat_section(line, statement);
    const auto target = resolve(line, statement.from);
    if (!target) return target.error();
    const Place head{frame->unit->begin, frame->unit->begin};
    PreparedCall prepared;
    prepared.unit = frame->unit;
    const auto fault = map().find(*target, Direction::Forward, head, prepared.from.emplace());
    if (fault != ProgramMap::Fault::None)
        return fail(line, fault, diag::RepeatLabelMissing, statement.from.span,
                    quoted(target->label));
    prepared.site = std::make_shared<nc::CallSite>(
        nc::CallSite{lines.place(line.text, line.place.line.line, statement.span), frame->site});
    return begin(line, prepared);
}

Program::State::Outcome Program::State::check_depth(CompiledLine& line, const PreparedCall& call,
                                                    const nc::Span& span) {
    const nc::LanguageRules& rules = language.rules;
    int macros = 0;
    int subprograms = 0;
    for (const auto& open : frames) {
        if (open->call.unit == nullptr) continue;
        ++(open->call.is_macro() ? macros : subprograms);
    }
    if (call.is_macro() && macros >= rules.most_macros)
        return fail(line, diag::MacrosTooDeep, span, {std::to_string(rules.most_macros)});
    const bool is_full = macros + subprograms >= rules.most_calls;
    if (is_full || (!call.is_macro() && subprograms >= rules.most_subprograms)) {
        const int most = is_full ? rules.most_calls : rules.most_subprograms;
        return fail(line, diag::CallsTooDeep, span, {std::to_string(most)});
    }
    return Outcome::Nothing;
}

/// Sets the call up as the program that runs next; `line` is where it is called.
Program::State::Outcome Program::State::begin(CompiledLine& line, const PreparedCall& call) {
    const nc::Span span = line.line.calls.empty() ? nc::Span{0, 1} : line.line.calls[0].span;
    Outcome done = check_depth(line, call, span);
    if (!goes_on(done)) return done;
    const bool is_external = call.form != nullptr && call.form->is_external;
    if (is_external && frame->is_external) return fail(line, diag::ExternalNested, span);
    const ControlStatement* const head = call.unit->procedure();
    const bool saves = head != nullptr && head->saves && interpreter != nullptr;
    if (saves && given > 0) return Outcome::Wait;
    // Programs that only call each other would take for ever as well.
    if (++turns > options.max_turns)
        return fail(line, diag::EndlessLoop, span, {std::to_string(options.max_turns)});

    auto callee = std::make_unique<Frame>();
    callee->unit = call.unit;
    callee->text.name = call.unit->text->name;
    callee->text.program = call.unit->name;
    callee->call = call;
    callee->left = call.passes;
    callee->site = call.site;
    callee->here = call.unit->begin;
    const bool is_code = call.form != nullptr && !call.form->fixed.empty();
    callee->is_in_code_call = frame->is_in_code_call || is_code;
    callee->is_external = frame->is_external || is_external;
    callee->modal_limit = frame->modal_limit;
    callee->saves = saves;
    callee->macros = shared_macros;
    if (call.is_macro()) {
        callee->own_level = call.level;
    } else if (language.rules.subprograms_have_variables &&
               !(call.is_shape && call.unit == frame->unit)) {
        callee->own_level = variables.new_level();
    }
    callee->level = callee->own_level ? callee->own_level.get() : frame->level;
    references.clear();
    done = bind_parameters(line, call, *callee);
    callee->references = std::move(references);
    if (!goes_on(done)) return done;
    if (call.start >= 0) {
        Place found;
        const auto fault = call.unit->map.find({{}, call.start}, Direction::Forward,
                                               {call.unit->begin, call.unit->begin}, found);
        if (fault != ProgramMap::Fault::None) {
            return fail(line, fault, diag::JumpTargetMissing, span,
                        quoted("N" + std::to_string(call.start)));
        }
        callee->here = found.line;
    }
    if (call.from) callee->here = call.from->line;
    if (saves || call.is_shape) callee->modal_before = lines.modal();
    if (saves) interpreter->keep_frames();
    begins = std::move(callee);
    return Outcome::Nothing;
}

void Program::State::perform_call() {
    frames.push_back(std::move(begins));
    resume_frame(*frames.back());
}

/// What follows is executed in this program, with its variables.
void Program::State::resume_frame(Frame& next) {
    frame = &next;
    variables.enter(*next.level);
    evaluator.enter(*next.level);
    variables.set_program_level(frames.size() - 1);
    lines.enter(next.text);
}

// ------------------------------------------------------------------------------ parameters

Program::State::Outcome Program::State::bind_parameters(CompiledLine& line,
                                                        const PreparedCall& call, Frame& callee) {
    const ControlStatement* const head = call.unit->procedure();
    const std::size_t count = head == nullptr ? 0 : head->parameters.size();
    // The main program of a text without a head has the name of its file.
    const std::string name =
        quoted(call.unit->name.empty() ? call.unit->text->name : call.unit->name);
    if (call.unit->has_wrong_head) return Outcome::Nothing;
    if (call.arguments.size() > count) {
        if (head == nullptr) {
            return fail(line, diag::ProcedureMissing, call.arguments[0].span, {name});
        }
        return fail(line, diag::CallArguments, call.arguments[count].span,
                    {name, std::to_string(count), std::to_string(call.arguments.size())});
    }
    if (count == 0) return Outcome::Nothing;
    variables.enter(*callee.level);
    evaluator.enter(*callee.level);
    Outcome done = Outcome::Nothing;
    for (std::size_t i = 0; i < count; ++i) {
        done = bind_parameter(line, call, i);
        if (!goes_on(done)) break;
    }
    variables.enter(*frame->level);
    evaluator.enter(*frame->level);
    return done;
}

Program::State::Outcome Program::State::bind_parameter(CompiledLine& line, const PreparedCall& call,
                                                       std::size_t index) {
    static const GivenValue kNothing;
    const nc::ControlLine& head = *call.unit->head;
    const nc::ProcedureParameter& parameter = head.statements[0].parameters[index];
    const GivenValue& given_value =
        index < call.arguments.size() ? call.arguments[index] : kNothing;
    variables.level().given[index] = given_value.is_given;
    nc::Symbol symbol = symbol_of(parameter);
    const auto work_out = [&](const nc::Expression& expression, Value& out) {
        return evaluator.run(head, expression, out) == Evaluator::Outcome::Done;
    };
    Value size;
    if (parameter.type_size.is_given() && work_out(parameter.type_size, size)) {
        symbol.text_size = static_cast<std::uint32_t>(
            std::clamp<double>(size.number, 1, language.rules.most_text));
    }
    for (std::size_t i = 0; i < symbol.dimensions; ++i) {
        const nc::Expression& length = parameter.declaration.sizes[i];
        if (length.is_given() && work_out(length, size)) {
            symbol.sizes[i] = static_cast<std::uint32_t>(std::clamp<double>(size.number, 1, 1e6));
        } else if (given_value.place.symbol != nullptr) {
            symbol.sizes[i] = given_value.place.symbol->sizes[i];
        }
    }
    if (parameter.is_reference) return bind_reference(line, parameter, given_value, symbol);
    const std::size_t dimensions =
        given_value.is_array ? given_value.place.symbol->dimensions : std::size_t{0};
    if (given_value.is_given && dimensions != symbol.dimensions) {
        return fail(line, diag::ArgumentDiffers, given_value.span,
                    {quoted(symbol.name), symbol.dimensions > 0 ? "an array" : "one value"});
    }
    if (!has_room_for(variables.level(), symbol)) {
        const std::string name = symbol.name;
        symbol.sizes.fill(1);  // the lines behind speak of it all the same
        variables.declare(std::move(symbol));
        return fail(line, diag::VariablesTooMany,
                    given_value.is_given ? given_value.span : nc::Span{0, 1},
                    {name, std::to_string(kMostElements)});
    }
    const nc::Symbol& added = variables.declare(std::move(symbol));
    const nc::Span span = given_value.is_given ? given_value.span : nc::Span{0, 1};
    const auto set = [&](std::uint32_t place, const Value& value, const Content& content) {
        const auto fault = variables.store_element(added, added.slot + place, value, content);
        if (fault.row == nullptr) return Outcome::Nothing;
        if (given_value.is_given && fault.row == &diag::TypesDiffer) {
            const auto type = std::ranges::find(language.types, added.type, &nc::TypeName::type);
            const std::string wanted =
                type == language.types.end() ? "one of its type" : std::string(type->name);
            return fail(line, diag::ArgumentDiffers, span, {quoted(added.name), wanted});
        }
        return fail(line, *fault.row, span, fault.arguments);
    };
    if (given_value.is_array) {
        const Store& from = *given_value.place.store;
        const std::uint32_t most = std::min(added.count(), given_value.place.symbol->count());
        Outcome done = Outcome::Nothing;
        for (std::uint32_t i = 0; i < most && goes_on(done); ++i) {
            const Value& value = from.values[given_value.place.slot + i];
            if (!value.is_vacant()) done = set(i, value, from.content(value));
        }
        return done;
    }
    if (given_value.is_given) {
        const Content content{given_value.text, &given_value.frame};
        return set(0, evaluator.keep(given_value.value, content), content);
    }
    const std::vector<nc::Expression>& defaults = parameter.declaration.values;
    Outcome done = Outcome::Nothing;
    for (std::size_t i = 0; i < defaults.size() && i < added.count(); ++i) {
        Value value;
        if (!defaults[i].is_given() || !work_out(defaults[i], value)) continue;
        if (!goes_on(set(static_cast<std::uint32_t>(i), value, evaluator.content(value))))
            done = Outcome::Failed;
    }
    return done;
}

/// The parameter is the caller's variable: of the same type, an array of the same dimensions.
Program::State::Outcome Program::State::bind_reference(CompiledLine& line,
                                                       const nc::ProcedureParameter& parameter,
                                                       const GivenValue& given_value,
                                                       nc::Symbol symbol) {
    const ControlVariables::VariablePlace& place = given_value.place;
    const nc::Span span = given_value.is_given      ? given_value.span
                          : line.line.calls.empty() ? nc::Span{0, 1}
                                                    : line.line.calls[0].span;
    if (place.store == nullptr)
        return fail(line, diag::ArgumentNoVariable, span, {quoted(symbol.name)});
    const std::size_t dimensions = given_value.is_array ? place.symbol->dimensions : std::size_t{0};
    if (place.type != parameter.type || dimensions != symbol.dimensions) {
        const auto type = std::ranges::find(language.types, parameter.type, &nc::TypeName::type);
        std::string wanted = symbol.dimensions > 0 ? "an array of " : "a variable of ";
        wanted += type == language.types.end() ? "its type" : type->name;
        return fail(line, diag::ArgumentDiffers, span, {quoted(symbol.name), wanted});
    }
    symbol.slot = place.slot;
    if (place.symbol != nullptr) {
        symbol.text_size = place.symbol->text_size;
        if (given_value.is_array) symbol.sizes = place.symbol->sizes;
    }
    note_reference(symbol, place);
    ControlVariables::bind(variables.level(), std::move(symbol), *place.store);
    return Outcome::Nothing;
}

/// For who looks on: the parameter has the value of the caller's variable, and what the variable
/// was before the call is told when it returns.
void Program::State::note_reference(const nc::Symbol& symbol,
                                    const ControlVariables::VariablePlace& place) {
    if (!variables.notes_changes() || symbol.dimensions > 0) return;
    ControlVariables::VariablePlace named = place;
    if (place.symbol == nullptr && place.store == &frame->level->locals)
        named.symbol = declared_at(*frame->level, place.slot);
    ControlVariable before = variables.shown_at(named);
    ControlVariable parameter = before;
    parameter.name = symbol.name;
    variables.note_change({}, std::move(parameter));
    references.push_back({named, std::move(before)});
}

/// What a program that was left has written into variables of its caller.
void Program::State::note_returned(const Frame& left) {
    for (const ReturnedVariable& reference : left.references) {
        ControlVariable now = variables.shown_at(reference.place);
        const ControlVariable& before = reference.before;
        const bool is_same =
            now.kind == before.kind && now.number == before.number && now.text == before.text;
        if (!is_same) variables.note_change(before, std::move(now));
    }
}

/// The head of a procedure that was not called: the main program, or one that is only read.
Program::State::Outcome Program::State::declare_procedure(CompiledLine& line,
                                                          const ControlStatement& statement) {
    if (frame->has_executed) return fail(line, diag::DeclarationMisplaced, statement.span);
    const bool was_called = (frames.size() > 1 || frame->is_called) && !is_only_checking;
    const bool had_failed = lines.failed();
    Outcome done = Outcome::Nothing;
    for (const nc::ProcedureParameter& parameter : statement.parameters) {
        if (was_called || done == Outcome::Wait || (lines.failed() && !had_failed)) return done;
        std::uint32_t characters = 0;
        done = text_size(line, parameter.type_size, characters);
        if (done != Outcome::Wait)
            done = declare_one(line, parameter.declaration, parameter.type, characters);
    }
    return done;
}

/// A line that says the parameters of another program must say what its head says.
Program::State::Outcome Program::State::check_external(CompiledLine& line,
                                                       const ControlStatement& statement) {
    externals.insert(statement.name);
    const ProgramUnit* const unit = units.find(statement.name, text());
    // Told where it is called.
    if (unit == nullptr || unit->has_wrong_head) return Outcome::Nothing;
    static const std::vector<nc::ProcedureParameter> kNone;
    const auto& wanted = unit->procedure() != nullptr ? unit->procedure()->parameters : kNone;
    const bool is_same =
        std::ranges::equal(wanted, statement.parameters,
                           [](const nc::ProcedureParameter& a, const nc::ProcedureParameter& b) {
                               return a.type == b.type && a.is_reference == b.is_reference &&
                                      a.declaration.dimensions == b.declaration.dimensions;
                           });
    if (is_same) return Outcome::Nothing;
    return fail(line, diag::ExternalDiffers, statement.span, {quoted(statement.name)});
}

// ------------------------------------------------------------------------------ modal calls

Program::State::Outcome Program::State::call_modal(CompiledLine& line,
                                                   const ControlStatement& statement, Block& out) {
    auto prepared = std::make_shared<PreparedCall>();
    const Outcome done = prepare(line, statement, *prepared);
    if (!goes_on(done)) return done;
    prepared->is_modal = true;
    const int most = language.rules.most_modal_calls;
    if (most == 1) modal_calls.clear();
    if (static_cast<int>(modal_calls.size()) >= most)
        return fail(line, diag::ModalCallsTooDeep, statement.span, {std::to_string(most)});
    modal_calls.push_back(std::move(prepared));
    // Where a cycle can be called so as well, this call takes its place.
    if (most != 1 || !out.add(Function::CycleModal)) return Outcome::Nothing;
    keeps_modal_calls = true;
    return Outcome::Block;
}

Program::State::Outcome Program::State::end_modal(CompiledLine& line,
                                                  const ControlStatement& statement) {
    if (modal_calls.empty() && !language.rules.end_modal_alone)
        return fail(line, diag::ModalCallMissing, statement.span);
    if (!modal_calls.empty()) modal_calls.pop_back();
    return Outcome::Nothing;
}

/// The modal call that a block of the program which runs makes; null: none.
const PreparedCall* Program::State::active_modal_call() const {
    const std::size_t count = std::min(frame->modal_limit, modal_calls.size());
    return count == 0 ? nullptr : modal_calls[count - 1].get();
}

/// The code of the modal call that acts; without one that which ends it.
double Program::State::modal_call_code() const {
    const PreparedCall* const active = active_modal_call();
    if (active != nullptr && active->form != nullptr) return active->form->number;
    const auto end =
        std::ranges::find(language.calls.calls, CallForm::Kind::EndModal, &CallForm::kind);
    return end == language.calls.calls.end() ? 0 : end->number;
}

std::optional<std::string> Program::State::name_at(std::int64_t level) const {
    if (level < 0 || level >= static_cast<std::int64_t>(frames.size())) return std::nullopt;
    const Frame& at = *frames[static_cast<std::size_t>(level)];
    if (!at.unit->name.empty()) return at.unit->name;
    const std::string& head = at.text.program;
    return head.empty()
               ? nc::program_of_path(language.calls, at.text.name, tables.notation.ignores_case)
               : head;
}

bool Program::State::find_program(std::string_view name) {
    const std::string wanted =
        nc::program_of_path(language.calls, name, tables.notation.ignores_case);
    if (control_files.knows(file_name(name))) return control_files.has(file_name(name));
    const std::string kind = nc::kind_of_path(language.calls, name, tables.notation.ignores_case);
    return !wanted.empty() && units.find(wanted, text(), kind) != nullptr;
}

bool Program::State::takes_blocks() const {
    const PreparedCall* const active = active_modal_call();
    return active != nullptr && active->form != nullptr &&
           active->form->modal == CallForm::Modal::Block;
}

nc::LineContext Program::State::context() const {
    return {variables.names(),
            frame->is_in_code_call,
            !modal_calls.empty() && takes_blocks(),
            options.skip_levels,
            ear.is_listened_to(),
            options.axis_names.empty() ? nullptr : &options.axis_names};
}

/// Behind a block that moves an axis the modal call is made.
void Program::State::call_behind(const Block& block, std::string_view text_of_line,
                                 std::uint64_t number) {
    const bool is_path = !std::exchange(moves_alone, false);
    if (is_only_checking) return;
    if (block.find(Function::CycleModal) != nullptr) {
        if (!keeps_modal_calls) modal_calls.clear();
        keeps_modal_calls = false;
        return;
    }
    const PreparedCall* const active = active_modal_call();
    if (active == nullptr || is_left_out(block)) return;
    const bool is_pattern = interpreter != nullptr && block.find(Function::Cycle) != nullptr &&
                            goes_to_places(dialect.cycles()[block.cycle]);
    if (is_pattern) return call_at_places(block, *active, text_of_line, number);
    if (!moves(block) || !is_path) return;
    due = *active;
    due->site = std::make_shared<nc::CallSite>(
        nc::CallSite{lines.place(text_of_line, number, {0, 1}), frame->site});
}

/// The modal call that the block before has made.
Program::State::Outcome Program::State::begin_due() {
    CompiledLine here;
    here.text = due->site->place.text;
    const Outcome done = begin(here, *due);
    if (done == Outcome::Wait) return done;
    due.reset();
    if (!begins) return done;
    begins->modal_limit =
        begins->call.is_shape ? 0 : std::min(frame->modal_limit, modal_calls.size()) - 1;
    perform_call();
    return done;
}

/// The words of the block are the arguments of the modal call.
Program::State::Outcome Program::State::call_with_block(CompiledLine& line) {
    const PreparedCall* const active = active_modal_call();
    if (active == nullptr) return Outcome::Nothing;
    PreparedCall call = *active;
    const nc::Call& words = line.line.calls[0];
    Outcome done = prepare_letters(line, words, call);
    if (!goes_on(done)) return done;
    call.site = std::make_shared<nc::CallSite>(
        nc::CallSite{lines.place(line.text, line.place.line.line, words.span), frame->site});
    done = begin(line, call);
    if (begins) begins->modal_limit = std::min(frame->modal_limit, modal_calls.size()) - 1;
    return done;
}

// ------------------------------------------------------------------------------ shapes

/// MCALL in front of such a cycle, or alone, which ends it.
void Program::State::keep_modal_shape(const Block& block, std::string_view text_of_line,
                                      const Place& place) {
    modal_shape.reset();
    const bool has_shape =
        block.find(Function::Cycle) != nullptr && names_shape(dialect.cycles()[block.cycle]);
    if (has_shape) modal_shape.emplace(ModalShape{block, std::string(text_of_line), place});
}

/// The interpreter calls the cycle behind every block that moves an axis.
void Program::State::follow_modal_shape(const Block& block) {
    constexpr nc::SlotMask kPlaces = nc::kTargetSlots | nc::kPolarSlots;
    const bool is_in_shape = std::ranges::any_of(
        frames, [](const std::unique_ptr<Frame>& each) { return each->call.is_shape; });
    if (is_only_checking || has_ended || is_in_shape || due) return;
    const bool is_alone = block.find(Function::RapidOnce) != nullptr;
    if ((block.given & kPlaces) == 0 || is_alone || is_left_out(block)) return;
    const ModalShape shape = *modal_shape;
    follow_named_shape(shape.block, shape.text, shape.place);
}

namespace {

std::vector<std::string> parts_of(std::string_view text) {
    std::vector<std::string> parts;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(':'), text.size());
        if (end > 0) parts.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return parts;
}

}  // namespace

/// Of the cycles behind that name no contour themselves; it stays until another is named.
void Program::State::keep_contour(const Block& block, std::int64_t kind) {
    named_contour = NamedContour{parts_of(block.text), std::max<std::int64_t>(kind, 0)};
}

/// The contour along which a cycle works: the one that it names, or the one that was named before.
Program::State::NamedContour Program::State::contour_of(const Block& block) const {
    NamedContour contour;
    if (block.text.empty() && named_contour) {
        contour = *named_contour;
    } else {
        contour.parts = parts_of(block.text);
        contour.kind = static_cast<std::int64_t>(contour.parts.size() == 2 ? ContourPlace::Labels
                                                                           : ContourPlace::Program);
    }
    if (contour.kind == static_cast<std::int64_t>(ContourPlace::Named) && !contour.parts.empty()) {
        const std::string name = contour.parts[0];
        contour.parts = {std::string(kContourBegin) + name, std::string(kContourEnd) + name};
    }
    return contour;
}

/// The blocks of a shape that a cycle names: those of a program, or those between two labels of the
/// program that runs (`"BEGIN:END"`) or of another. They come next; behind them the cycle is
/// called.
void Program::State::follow_named_shape(const Block& block, std::string_view text_of_line,
                                        const Place& place) {
    const nc::Span whole{0, static_cast<std::uint32_t>(text_of_line.size())};
    const auto missing = [&](const DiagnosticRow& row, std::string what) {
        lines.report_fault(text_of_line, nc::LineFault{&row, whole, {std::move(what)}});
        has_ended = true;
    };
    NamedContour contour = contour_of(block);
    const auto kind = static_cast<ContourPlace>(contour.kind);
    PreparedCall call;
    call.is_shape = true;
    call.site = std::make_shared<nc::CallSite>(
        nc::CallSite{lines.place(text_of_line, place.line.line, whole), frame->site});
    call.unit = frame->unit;
    if (kind == ContourPlace::Program || kind == ContourPlace::ProgramLabels) {
        const std::string said = contour.parts.empty() ? std::string() : contour.parts[0];
        const std::string name =
            nc::program_of_path(language.calls, said, tables.notation.ignores_case);
        const std::string its_kind =
            nc::kind_of_path(language.calls, said, tables.notation.ignores_case);
        call.unit = name.empty() ? nullptr : units.find(name, text(), its_kind);
        if (call.unit == nullptr)
            return missing(diag::ProgramMissing,
                           quoted(name.empty() ? said : nc::shown_program(language.calls, name)));
        if (!contour.parts.empty()) contour.parts.erase(contour.parts.begin());
    }
    if (kind == ContourPlace::Program) {
        due = std::move(call);
        return;
    }
    contour.parts.resize(2);  // a label that nobody said is missing
    Place begin{call.unit->begin, call.unit->begin};
    Place end;
    for (const std::string& label : contour.parts) {
        const Place from = begin;
        Place& found = &label == &contour.parts[0] ? begin : end;
        if (call.unit->map.find({label, -1}, Direction::Forward, from, found) !=
            ProgramMap::Fault::None)
            return missing(diag::JumpTargetMissing, quoted(label));
    }
    call.from = begin;
    call.to = end.next;
    due = std::move(call);
}

// ------------------------------------------------------------------------------ returns

Program::State::Outcome Program::State::leave_program(CompiledLine& line,
                                                      const ControlStatement& statement,
                                                      Block& out) {
    const nc::Call* const words =
        line.line.calls.empty() ? nullptr : &line.line.calls[statement.call];
    std::optional<LineTarget> target;
    if (statement.target.kind != nc::JumpTarget::Kind::None) {
        const auto wanted = resolve(line, statement.target);
        if (!wanted) return wanted.error();
        if (!wanted->label.empty() || wanted->number >= 0) target = *wanted;
    }
    std::optional<double> number;
    Outcome done = Outcome::Nothing;
    if (words != nullptr) done = number_of(line, words->target, number);
    if (!goes_on(done)) return done;
    if (number) target = LineTarget{{}, static_cast<std::int64_t>(*number)};
    if (!target && cancel_repeat()) return Outcome::Nothing;
    if (frames.size() == 1) return return_in_main(line, statement, target, out);
    if (frame->call.is_modal && !line.line.words.words.empty()) {
        return fail(
            line, diag::ReturnWithWords, statement.span,
            {line.text.substr(statement.span.begin, statement.span.end - statement.span.begin)});
    }
    // How many levels, and which block of the program that goes on.
    Value behind;
    Value levels = Value::real(1);
    if (statement.value.is_given()) done = evaluate(line, statement.value, behind);
    if (!goes_on(done)) return done;
    if (statement.count.is_given()) done = evaluate(line, statement.count, levels);
    if (!goes_on(done)) return done;
    const auto most = static_cast<double>(frames.size() - 1);
    frame->levels = static_cast<int>(std::clamp(std::round(levels.number), 1.0, most));
    if (target) {
        Frame& next = *frames[frames.size() - 1 - static_cast<std::size_t>(frame->levels)];
        Place found;
        const auto fault = next.unit->map.find(*target, Direction::Forward,
                                               {next.unit->begin, next.unit->begin}, found);
        const std::string what =
            target->label.empty() ? "N" + std::to_string(target->number) : target->label;
        if (fault != ProgramMap::Fault::None)
            return fail(line, fault, diag::JumpTargetMissing, statement.span, quoted(what));
        if (behind.number > 0) found.line = found.next;
        frame->returns_to = found;
    }
    std::optional<double> left;
    if (words != nullptr) done = number_of(line, words->repeats, left);
    if (!goes_on(done)) return done;
    // The pass that ends is counted off.
    if (left) frame->left = static_cast<std::int64_t>(std::clamp(*left, 0.0, 1e9)) + 1;
    frame->is_returning = true;
    return Outcome::Nothing;
}

namespace {

/// Whether a line, read by itself, ends the program.
bool ends_program(const nc::Dialect& dialect, std::string_view line) {
    struct OneLine final : nc::TextSource {
        explicit OneLine(std::string_view all) : rest(all) {}
        std::string_view next() override { return std::exchange(rest, {}); }
        std::string_view rest;
    } text(line);
    DiagnosticList ignored;
    nc::Reader reader(dialect, text, "", ignored);
    std::array<Block, 1> block;
    return reader.pull(block) > 0 && (block[0].find(Function::End) != nullptr ||
                                      block[0].find(Function::EndRewind) != nullptr);
}

/// Whether a jump may end the program in front of the place: a block with a number stands in the
/// program from there on, and the program's end behind it. Exits to an alarm alone are none.
bool has_exit_behind(const nc::Dialect& dialect, nc::LineSource& source, const LinePosition& from) {
    const nc::DialectTables& tables = dialect.tables();
    if (!source.seek(from.offset)) return false;
    std::string_view line;
    bool is_too_long = false;
    bool has_number = false;
    while (source.next(line, is_too_long)) {
        if (std::ranges::find(tables.program.end, line) != tables.program.end.end()) return false;
        if (nc::program_of_header(tables.language.calls, line, tables.notation.ignores_case))
            return false;
        has_number = has_number || nc::front_of(tables, line).number >= 0;
        if (has_number && ends_program(dialect, line)) return true;
    }
    return false;
}

}  // namespace

/// The main program is begun again, or ends: one whose last block begins it again never ends by
/// itself, so it is executed as often as was asked for, which is once.
///
/// source  F 6.8
Program::State::Outcome Program::State::return_in_main(CompiledLine& line,
                                                       const ControlStatement& statement,
                                                       const std::optional<LineTarget>& target,
                                                       Block& out) {
    if (!language.rules.return_restarts_main || frame->is_called) {
        out.add(Function::End);
        return Outcome::Block;
    }
    Place found{frame->unit->begin, frame->unit->begin};
    if (target) {
        const auto fault = map().find(*target, Direction::Forward, found, found);
        if (fault != ProgramMap::Fault::None) {
            return fail(line, fault, diag::JumpTargetMissing, statement.span,
                        quoted("N" + std::to_string(target->number)));
        }
    }
    // A return to a block in front begins it again, too; one to a block behind is a jump. Where
    // a block with a number and the end stand behind, a jump may lead there and end the loop: it is
    // one of the program's.
    const bool is_jump = target && found.line.offset > frame->here.offset;
    const bool is_skipped_at_will = line.line.words.skip >= 0;
    const auto is_own_loop = [&] {
        return !options.passes && !is_skipped_at_will &&
               has_exit_behind(dialect, source(), line.place.next);
    };
    const std::uint64_t passes = options.passes.value_or(1);
    if (is_jump || is_own_loop() || ++passes_done < passes) {
        if (!target) frame->text.has_content = false;
        return go(line, found, statement.span);
    }
    if (!options.passes) {
        const nc::Span& span = statement.span;
        sink.report(diag::MainBeginsAgain, lines.place(line.text, frame->here.line, span))
            .arg(line.text.substr(span.begin, span.end - span.begin));
    }
    out.add(Function::End);
    return Outcome::Block;
}

/// A return inside of a section that is repeated ends only that: on behind the repetition.
bool Program::State::cancel_repeat() {
    if (frame->repeats.empty()) return false;
    frame->here = frame->goes_on = frame->repeats.back().behind;
    frame->next_line = nullptr;
    frame->repeats.pop_back();
    leave_open(frame->here);
    return true;
}

/// The program that runs is through: once more, or back to where it was called.
Program::State::Outcome Program::State::finish_return(Block& out) {
    if (frame->saves && given > 0) return Outcome::Wait;
    const bool is_jump = frame->returns_to.has_value() || frame->levels > 1;
    if (!is_jump && --frame->left > 0) {
        if (++turns > options.max_turns) {
            has_ended = true;
            CompiledLine nowhere;
            return fail(nowhere, diag::EndlessLoop, {}, {std::to_string(options.max_turns)});
        }
        restart(*frame);
        return Outcome::Nothing;
    }
    const std::optional<Place> target = frame->returns_to;
    const LinePosition from = frame->here;
    ProgramText& left_text = text();
    Outcome done = Outcome::Nothing;
    for (int levels = frame->levels; levels > 0 && frames.size() > 1; --levels) {
        const std::unique_ptr<Frame> left = std::move(frames.back());
        frames.pop_back();
        resume_frame(*frames.back());
        // The variables that take the contour are gone.
        if (open_contour && frames.size() < open_contour->depth) {
            CompiledLine nowhere;
            has_ended = true;
            return fail(nowhere, diag::ContourUnfinished, {});
        }
        leave_places(*left);
        note_returned(*left);
        if (left->is_definition) leave_definition(*left);
        if (left->inputs != nullptr && frames.back()->inputs == nullptr) leave_inputs();
        if (left->saves) interpreter->restore_frames(true);
        if (left->call.is_shape) out.add(Function::CycleCall);
        if (left->saves || left->call.is_shape) lines.restore(left->modal_before, out);
    }
    if (out.function_count > 0 || out.motion != Function::None) {
        out.line = units.line_id(left_text, std::max<std::uint64_t>(from.line, 2) - 1);
        kept.add(out.line, std::max<std::uint64_t>(from.line, 2) - 1, "", &left_text.name, nullptr);
        done = Outcome::Block;
    }
    if (target) {
        ++turns;
        leave_places(*frame);
        leave_open(target->line);
        frame->here = target->line;
        frame->next_line = nullptr;
    }
    return done;
}

/// One more pass of the program that runs.
void Program::State::restart(Frame& again) {
    again.is_returning = false;
    again.text.has_content = again.text.has_ended = false;
    again.structures.clear();
    again.repeats.clear();
    again.resume = 0;
    again.has_executed = again.has_given_words = false;
    again.next_line = nullptr;
    again.here = again.unit->begin;
    if (again.call.start >= 0) {
        Place found;
        const auto fault = again.unit->map.find({{}, again.call.start}, Direction::Forward,
                                                {again.unit->begin, again.unit->begin}, found);
        if (fault == ProgramMap::Fault::None) again.here = found.line;
    }
    if (!again.own_level || again.call.is_macro()) return;
    again.own_level = variables.new_level();
    again.level = again.own_level.get();
    resume_frame(again);
    CompiledLine nowhere;
    bind_parameters(nowhere, again.call, again);
}

}  // namespace kadr::macro
