// program_calls.cpp — programs that call each other: a call begins, and which programs there are.
#include <algorithm>
#include <utility>

#include "base/diagnostics/control.h"
#include "macro/program_state.h"
#include "nc/quoted.h"

namespace kadr::macro {

using nc::Block;
using nc::ControlStatement;
using nc::quoted;
using nc::Statement;

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

nc::LineContext Program::State::context() const {
    return {variables.names(),
            frame->is_in_code_call,
            !modal_calls.empty() && takes_blocks(),
            options.skip_levels,
            ear.is_listened_to(),
            options.axis_names.empty() ? nullptr : &options.axis_names};
}

}  // namespace kadr::macro
