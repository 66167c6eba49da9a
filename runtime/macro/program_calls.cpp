// program_calls.cpp — programs that call each other: a call begins, and which programs there are.
#include "macro/program_calls.h"

#include <algorithm>
#include <utility>

#include "base/diagnostics/control.h"
#include "macro/program_run.h"
#include "nc/quoted.h"

namespace kadr::macro {

using nc::Block;
using nc::ControlStatement;
using nc::quoted;
using nc::Statement;

Outcome Calls::execute(CompiledLine& line, const ControlStatement& statement, Block& out) {
    switch (statement.kind) {
        case Statement::Call:
        case Statement::CallByText: return call(line, statement);
        case Statement::CallModal: return run_.modal_calls.begin(line, statement, out);
        case Statement::EndModal: return run_.modal_calls.end(line, statement);
        case Statement::Return: return run_.returns.leave(line, statement, out);
        case Statement::Procedure: return declare_procedure(line, statement);
        case Statement::External: return run_.call_preparation.check_external(line, statement);
        default: return Outcome::Nothing;
    }
}

Outcome Calls::call(CompiledLine& line, const ControlStatement& statement) {
    const bool is_words_of_block = statement.kind == Statement::Call &&
                                   line.line.calls[statement.call].form < 0 &&
                                   line.line.calls[statement.call].name.empty();
    if (is_words_of_block) return run_.modal_calls.call_with_block(line);
    Outcome done = Outcome::Nothing;
    if (statement.kind == Statement::Call) {
        const nc::CallValue& code = line.line.calls[statement.call].code;
        std::optional<double> number;
        done = run_.call_preparation.number_of(line, code, number);
        if (!goes_on(done)) return done;
        // `T#1`: a word without a value is not there.
        if (code.is_given && !number) return Outcome::Nothing;
    }
    PreparedCall prepared;
    done = run_.call_preparation.prepare(line, statement, prepared);
    if (!goes_on(done)) return done;
    done = begin(line, prepared);
    if (goes_on(done))
        run_.show_way(WayTaken::Kind::Call, line.program_line.line, *prepared.unit,
                      prepared.unit->begin);
    return done;
}

/// A section of this program by its label; with a count it is repeated instead.
Outcome Calls::call_section(CompiledLine& line, const ControlStatement& statement) {
    ControlValue count = ControlValue::real(0);
    Outcome done = Outcome::Nothing;
    if (statement.count.is_given()) done = run_.evaluate(line, statement.count, count);
    if (!goes_on(done)) return done;
    if (count.number != 0) return run_.jumps.repeat_section(line, statement);
    const auto target = run_.jumps.resolve(line, statement.from);
    if (!target) return target.error();
    const ProgramLine head{run_.frame->unit->begin, run_.frame->unit->begin};
    PreparedCall prepared;
    prepared.unit = run_.frame->unit;
    const auto fault = run_.map().find(*target, Direction::Forward, head, prepared.from.emplace());
    if (fault != ProgramMap::Fault::None)
        return run_.fail(line, fault, diag::RepeatLabelMissing, statement.from.span,
                         quoted(target->label));
    prepared.site = std::make_shared<nc::CallSite>(
        nc::CallSite{run_.lines.location(line.text, line.program_line.line.line, statement.span),
                     run_.frame->site});
    done = begin(line, prepared);
    if (goes_on(done))
        run_.show_way(WayTaken::Kind::Call, line.program_line.line, *prepared.unit,
                      prepared.from->line);
    return done;
}

Outcome Calls::check_depth(CompiledLine& line, const PreparedCall& call, const nc::Span& span) {
    const nc::LanguageRules& rules = run_.language.rules;
    int macros = 0;
    int subprograms = 0;
    for (const auto& open : run_.frames) {
        if (open->call.unit == nullptr) continue;
        ++(open->call.is_macro() ? macros : subprograms);
    }
    if (call.is_macro() && macros >= rules.most_macros)
        return run_.fail(line, diag::MacrosTooDeep, span, {std::to_string(rules.most_macros)});
    const bool is_full = macros + subprograms >= rules.most_calls;
    if (is_full || (!call.is_macro() && subprograms >= rules.most_subprograms)) {
        const int most = is_full ? rules.most_calls : rules.most_subprograms;
        return run_.fail(line, diag::CallsTooDeep, span, {std::to_string(most)});
    }
    return Outcome::Nothing;
}

/// Sets the call up as the program that runs next; `line` is where it is called.
Outcome Calls::begin(CompiledLine& line, const PreparedCall& call) {
    const nc::Span span = line.line.calls.empty() ? nc::Span{0, 1} : line.line.calls[0].span;
    Outcome done = check_depth(line, call, span);
    if (!goes_on(done)) return done;
    const bool is_external = call.form != nullptr && call.form->is_external;
    if (is_external && run_.frame->is_external) return run_.fail(line, diag::ExternalNested, span);
    const ControlStatement* const head = call.unit->procedure();
    const bool saves = head != nullptr && head->saves && run_.interpreter != nullptr;
    if (saves && run_.counts.given > 0) return Outcome::Wait;
    // Programs that only call each other would take for ever as well.
    if (!run_.count_turn())
        return run_.fail(line, diag::EndlessLoop, span, {std::to_string(run_.options.max_turns)});

    auto callee = std::make_unique<RunningProgram>();
    callee->unit = call.unit;
    callee->text.name = call.unit->text->name;
    callee->text.program = call.unit->name;
    callee->call = call;
    callee->left = call.passes;
    callee->site = call.site;
    callee->here = call.unit->begin;
    const bool is_code = call.form != nullptr && !call.form->fixed.empty();
    callee->is_in_code_call = run_.frame->is_in_code_call || is_code;
    callee->is_external = run_.frame->is_external || is_external;
    callee->modal_limit = run_.frame->modal_limit;
    callee->saves = saves;
    callee->macros = run_.definitions.common_macros();
    if (call.is_macro()) {
        callee->own_level = call.level;
    } else if (run_.language.rules.subprograms_have_variables &&
               !(call.is_shape && call.unit == run_.frame->unit)) {
        callee->own_level = run_.variables.new_level();
    }
    callee->level = callee->own_level ? callee->own_level.get() : run_.frame->level;
    done = run_.call_parameters.bind_noted(line, call, *callee);
    if (!goes_on(done)) return done;
    if (call.start >= 0) {
        ProgramLine found;
        const auto fault = call.unit->map.find({{}, call.start}, Direction::Forward,
                                               {call.unit->begin, call.unit->begin}, found);
        if (fault != ProgramMap::Fault::None) {
            return run_.fail(line, fault, diag::JumpTargetMissing, span,
                             quoted("N" + std::to_string(call.start)));
        }
        callee->here = found.line;
        if (!call.is_modal)
            run_.show_way(WayTaken::Kind::Jump, line.program_line.line, *call.unit, found.line);
    }
    if (call.from) callee->here = call.from->line;
    if (saves || call.is_shape) callee->modal_before = run_.lines.modes().modal();
    if (saves) run_.interpreter->keep_frames();
    begins_ = std::move(callee);
    return Outcome::Nothing;
}

void Calls::perform() {
    run_.add_frame(std::move(begins_));
    run_.resume_frame(*run_.frames.back());
}

/// The head of a procedure that was not called: the main program, or one that is only read.
Outcome Calls::declare_procedure(CompiledLine& line, const ControlStatement& statement) {
    if (run_.frame->has_executed)
        return run_.fail(line, diag::DeclarationMisplaced, statement.span);
    const bool was_called =
        (run_.frames.size() > 1 || run_.frame->is_called) && !run_.phase.is_only_checking;
    const bool had_failed = run_.lines.faults().failed();
    Outcome done = Outcome::Nothing;
    for (const nc::ProcedureParameter& parameter : statement.parameters) {
        if (was_called || done == Outcome::Wait || (run_.lines.faults().failed() && !had_failed))
            return done;
        std::uint32_t characters = 0;
        done = run_.value_statements.text_size(line, parameter.type_size, characters);
        if (done != Outcome::Wait)
            done = run_.value_statements.declare_one(line, parameter.declaration, parameter.type,
                                                     characters);
    }
    return done;
}

std::optional<std::string> Calls::name_at(std::int64_t level) const {
    if (level < 0 || level >= static_cast<std::int64_t>(run_.frames.size())) return std::nullopt;
    const RunningProgram& at = *run_.frames[static_cast<std::size_t>(level)];
    if (!at.unit->name.empty()) return at.unit->name;
    const std::string& head = at.text.program;
    return head.empty() ? nc::program_of_path(run_.language.calls, at.text.name,
                                              run_.tables.notation.ignores_case)
                        : head;
}

bool Calls::find_program(std::string_view name) {
    const std::string wanted =
        nc::program_of_path(run_.language.calls, name, run_.tables.notation.ignores_case);
    if (run_.file_statements.knows(name)) return run_.file_statements.has(name);
    const std::string kind =
        nc::kind_of_path(run_.language.calls, name, run_.tables.notation.ignores_case);
    return !wanted.empty() && run_.units.find(wanted, run_.text(), kind) != nullptr;
}

}  // namespace kadr::macro
