// call_preparation.cpp — what a call names and gives: its program, its passes, its
// arguments, worked out where it stands.
#include "macro/call_preparation.h"

#include <algorithm>
#include <cmath>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "macro/fixed_targets.h"
#include "macro/program_run.h"
#include "nc/number_text.h"
#include "nc/quoted.h"

namespace kadr::macro {

using nc::CallForm;
using nc::ControlStatement;
using nc::quoted;
using nc::Statement;

Outcome CallPreparation::number_of(CompiledLine& line, const nc::CallValue& value,
                                   std::optional<double>& out) {
    out.reset();
    if (!value.is_given) return Outcome::Nothing;
    if (value.is_plain) {
        out = value.decimal.value;
        return Outcome::Nothing;
    }
    ControlValue found;
    const Outcome done = run_.evaluate(line, value.value, found);
    if (!goes_on(done)) return done;
    if (found.is_text())
        return run_.fail(line, diag::TypesDiffer, value.span, {"a count", "a text"});
    if (!found.is_vacant()) out = std::round(found.number);
    return Outcome::Nothing;
}

/// The name of the program, and the passes that its number may hold: 30012 is 3 times 12.
Outcome CallPreparation::program_name(CompiledLine& line, const ControlStatement& statement,
                                      const CallForm* form, PreparedCall& out, ProgramName& found) {
    std::string& name = found.name;
    if (statement.kind == Statement::CallByText) {
        ControlValue text;
        const Outcome done = run_.evaluate(line, statement.second, text);
        if (!goes_on(done)) return done;
        if (!text.is_text())
            return run_.fail(line, diag::TypesDiffer, statement.second.span,
                             {"the name of a program", "a number"});
        const std::string_view path = run_.evaluator.text(text);
        name = nc::program_of_path(run_.language.calls, path, run_.tables.notation.ignores_case);
        found.kind = nc::kind_of_path(run_.language.calls, path, run_.tables.notation.ignores_case);
        if (name.empty()) {
            return run_.fail(line, diag::CallIncomplete, statement.second.span,
                             {std::string(run_.evaluator.text(text))});
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
            name = run_.frame->unit->name;
            out.unit = run_.frame->unit;
            return Outcome::Nothing;
        }
        return run_.fail(line, diag::CallIncomplete, words.span, written(words.span));
    }
    const auto program = program_numbered(*number, split_of(form, words));
    if (!program)
        return run_.fail(line, diag::CallIncomplete, words.program.span,
                         written(words.program.span));
    out.passes = program->passes;
    name = program->name;
    return Outcome::Nothing;
}

Outcome CallPreparation::find_program(CompiledLine& line, const ControlStatement& statement,
                                      const CallForm* form, PreparedCall& out) {
    ProgramName wanted;
    const Outcome done = program_name(line, statement, form, out, wanted);
    if (!goes_on(done)) return done;
    if (out.unit == nullptr) out.unit = run_.units.find(wanted.name, run_.text(), wanted.kind);
    if (out.unit != nullptr) return Outcome::Nothing;
    return missing_program(line, statement, wanted.name);
}

/// A word that could be a name of a program, and is none, is an unknown word.
Outcome CallPreparation::missing_program(CompiledLine& line, const ControlStatement& statement,
                                         const std::string& name) {
    const bool is_by_text = statement.kind == Statement::CallByText;
    const nc::Call* const words = is_by_text ? nullptr : &line.line.calls[statement.call];
    const nc::Span span = is_by_text                     ? statement.second.span
                          : words->program.span.end != 0 ? words->program.span
                                                         : words->span;
    const bool is_free_name =
        words != nullptr && statement.kind == Statement::Call && words->form >= 0 &&
        run_.language.calls.calls[static_cast<std::size_t>(words->form)].code == "{name}";
    const std::string known = run_.tables.unsupported_words(name);
    if (!known.empty()) return run_.fail(line, diag::IsoNotSupported, span, {known});
    if (is_free_name && !externals_.contains(name))
        return run_.fail(line, diag::IsoUnknownWord, span, {name});
    return run_.fail(line, diag::ProgramMissing, span,
                     {quoted(nc::shown_program(run_.language.calls, name))});
}

/// Of lines that are only read: whether there is such a program at all.
void CallPreparation::check_call(CompiledLine& line, const ControlStatement& statement) {
    if (statement.kind != Statement::Call && statement.kind != Statement::CallModal) return;
    const nc::Call& words = line.line.calls[statement.call];
    std::string name = words.name;
    // A number that is computed is not known here.
    if (name.empty() && words.program.is_plain && !run_.lines.faults().failed()) {
        PreparedCall ignored;
        ProgramName wanted;
        const CallForm* const form =
            words.form >= 0 ? &run_.language.calls.calls[static_cast<std::size_t>(words.form)]
                            : nullptr;
        program_name(line, statement, form, ignored, wanted);
        name = wanted.name;
    }
    if (name.empty() || run_.units.find(name, run_.text(), words.kind) != nullptr) return;
    missing_program(line, statement, name);
}

Outcome CallPreparation::prepare_passes(CompiledLine& line, const nc::CallValue& passes,
                                        PreparedCall& out) {
    std::optional<double> count;
    const Outcome done = number_of(line, passes, count);
    if (!goes_on(done) || !count) return done;
    if (!(*count >= 1 && *count <= run_.language.rules.most_passes))
        return run_.fail(line, diag::RepeatCount, passes.span,
                         {run_.evaluator.written(ControlValue::real(*count))});
    out.passes = static_cast<std::int64_t>(*count);
    return Outcome::Nothing;
}

/// Labels between which a program runs.
Outcome CallPreparation::prepare_section(CompiledLine& line, const ControlStatement& statement,
                                         PreparedCall& out) {
    if (statement.from.kind == nc::JumpTarget::Kind::None) return Outcome::Nothing;
    const ProgramLine head{out.unit->begin, out.unit->begin};
    ProgramLine begin;
    ProgramLine end;
    const auto find = [&](const nc::JumpTarget& wanted, const ProgramLine& from,
                          ProgramLine& found) {
        const auto target = run_.jumps.resolve(line, wanted);
        if (!target) return target.error();
        const auto fault = out.unit->map.find(*target, Direction::Forward, from, found);
        return run_.fail(line, fault, diag::JumpTargetMissing, wanted.span, quoted(wanted.label));
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
Outcome CallPreparation::prepare(CompiledLine& line, const ControlStatement& statement,
                                 PreparedCall& out) {
    const bool is_by_text = statement.kind == Statement::CallByText;
    const nc::Call* const words = is_by_text ? nullptr : &line.line.calls[statement.call];
    if (words != nullptr && words->form >= 0)
        out.form = &run_.language.calls.calls[static_cast<std::size_t>(words->form)];
    Outcome done = find_program(line, statement, out.form, out);
    if (!goes_on(done)) return done;
    const nc::Span span = is_by_text ? statement.second.span : words->span;
    out.site = std::make_shared<nc::CallSite>(nc::CallSite{
        run_.lines.location(line.text, line.program_line.line.line, span), run_.frame->site});
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
    run_.variables.set_global(out.form->value, code.value_or(out.form->number));
    return done;
}

/// Arguments by letters set variables of the level that the macro gets.
Outcome CallPreparation::prepare_letters(CompiledLine& line, const nc::Call& words,
                                         PreparedCall& out) {
    out.level = run_.variables.new_level();
    for (const nc::CallArgument& argument : words.arguments) {
        if (argument.is_plain) {
            double number = argument.decimal.value;
            if (argument.like != nc::kNoAddress && !argument.decimal.has_point) {
                const nc::Address& address = run_.tables.addresses[argument.like];
                number = read_meaning(argument.decimal, address.format, address.dimension,
                                      run_.lines.modes().units());
            }
            run_.variables.set_argument(*out.level, argument.slot, ControlValue::real(number));
            continue;
        }
        ControlValue value;
        const Outcome done = run_.evaluate(line, argument.value, value);
        if (!goes_on(done)) return done;
        run_.variables.set_argument(*out.level, argument.slot, value);
    }
    return Outcome::Nothing;
}

Outcome CallPreparation::prepare_list(CompiledLine& line, const nc::Call& words,
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
                const auto outcome = run_.evaluator.indices(line.line, argument.variable, indices);
                if (outcome == Evaluator::Outcome::Later) return Outcome::Wait;
                if (outcome == Evaluator::Outcome::Fault)
                    return run_.fail(line, run_.evaluator.fault());
            }
            given_value.variable = run_.variables.variable_of(argument.variable.load, indices);
        }
        if (argument.is_array) continue;
        const Outcome done = run_.evaluate(line, argument.value, given_value.value);
        if (!goes_on(done)) return done;
        given_value.text = run_.evaluator.text(given_value.value);
        if (given_value.value.is_frame())
            given_value.frame = *run_.evaluator.frame(given_value.value);
    }
    return Outcome::Nothing;
}

/// A line that declares the parameters of another program must declare what its head does.
Outcome CallPreparation::check_external(CompiledLine& line, const ControlStatement& statement) {
    externals_.insert(statement.name);
    const ProgramUnit* const unit = run_.units.find(statement.name, run_.text());
    // Reported where it is called.
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
    return run_.fail(line, diag::ExternalDiffers, statement.span, {quoted(statement.name)});
}

}  // namespace kadr::macro
