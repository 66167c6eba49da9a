#include "macro/program_base.h"

#include <array>
#include <utility>

#include "base/diagnostics/control.h"
#include "base/diagnostics/danger.h"
#include "base/numbers.h"

namespace kadr::macro {

using nc::LineFault;
using nc::Span;

ProgramBase::ProgramBase(const nc::Dialect& dialect_, nc::TextSource& main, std::string name,
                         const ProgramOptions& options_, DiagnosticSink& sink_)
    : dialect(dialect_),
      tables(dialect_.tables()),
      language(tables.language),
      options(options_),
      ear(sink_),
      sink(ear),
      lines(dialect_, name, ear),
      kept(lines),
      units(dialect_, main, name, options.kept_text, options.files),
      variables(dialect_, lines),
      evaluator(language.rules, variables.globals(), variables.level(), variables),
      codes(variables.system_variables().codes(), tables, lines.modes()),
      writes(variables, evaluator, language) {
    kept.keep_earlier(options.kept_lines);
    auto first = std::make_unique<RunningProgram>();
    first->unit = &units.main();
    first->text.name = std::move(name);
    first->level = &variables.main_level();
    add_frame(std::move(first));
    resume_frame(*frames[0]);
    variables.machine_values().report_missing_to(
        [this](const std::string& missing, const std::string& meaning) {
            missing_inputs_.push_back({missing, meaning, evaluator.place()});
        });
    lines.faults().add_notes([this](DiagnosticBuilder& message) {
        for (TextLocation& call : nc::locations_of(frame->site.get()))
            message.note(std::move(call), "called here");
    });
}

void ProgramBase::show_way(WayTaken::Kind kind, const LinePosition& line, const ProgramUnit& to,
                           const LinePosition& target) {
    if (watch == nullptr) return;
    const auto file_of = [&](const ProgramText* in) {
        return in == units.main().text ? std::string_view() : std::string_view(in->name);
    };
    watch->takes({kind, line.line, file_of(frame->unit->text), target.line, file_of(to.text)});
}

std::unique_ptr<RunningProgram> ProgramBase::take_frame() {
    std::unique_ptr<RunningProgram> taken = std::move(frames.back());
    frames.pop_back();
    return taken;
}

Outcome ProgramBase::fail(CompiledLine& line, const LineFault& fault) {
    lines.report_event(line.text, fault);
    return Outcome::Failed;
}

bool ProgramBase::end_for_watch() {
    if (watch == nullptr || !watch->has_ended()) return false;
    phase.was_stopped = phase.has_ended = true;
    return true;
}

Outcome ProgramBase::fail(CompiledLine& line, ProgramMap::Fault fault, const DiagnosticRow& missing,
                          const Span& span, const std::string& what) {
    if (fault != ProgramMap::Fault::None && end_for_watch()) return Outcome::Nothing;
    switch (fault) {
        case ProgramMap::Fault::None: return Outcome::Nothing;
        case ProgramMap::Fault::Missing: return fail(line, missing, span, {what});
        case ProgramMap::Fault::LoopNumber: return fail(line, diag::LoopNumber, span, {what});
        case ProgramMap::Fault::TextGone: break;
    }
    return fail(line, diag::TextGone, span, {"this line"});
}

Outcome ProgramBase::evaluate(CompiledLine& line, const nc::Expression& expression,
                              ControlValue& out, int decimals) {
    const Evaluator::Outcome outcome = evaluator.run(line.line, expression, out, decimals);
    if (!missing_inputs_.empty()) report_missing(line);
    switch (outcome) {
        case Evaluator::Outcome::Done:
            if (evaluator.has_radians()) [[unlikely]]
                warn_of_radians(line);
            return Outcome::Nothing;
        case Evaluator::Outcome::Later: return Outcome::Wait;
        case Evaluator::Outcome::Fault: return fail(line, evaluator.fault());
    }
    return Outcome::Nothing;
}

/// Reported once a run: what thinks in radians does so everywhere.
void ProgramBase::warn_of_radians(const CompiledLine& line) {
    const auto found = evaluator.take_radians();
    if (!found || reported_radians_) return;
    reported_radians_ = true;
    sink.report(diag::RadiansInText,
                lines.location(line.text, line.program_line.line.line, found->place))
        .arg(variables.word_of(found->operation))
        .arg(round_to(found->angle, 6));
}

Outcome ProgramBase::truth(CompiledLine& line, const nc::Expression& expression, bool& out) {
    ControlValue value;
    const Outcome done = evaluate(line, expression, value);
    if (!goes_on(done)) return done;
    if (!value.is_number()) {
        return fail(line, diag::TypesDiffer, expression.span,
                    {"a condition", std::string(kind_name(value))});
    }
    out = value.number != 0;
    return Outcome::Nothing;
}

Outcome ProgramBase::store(CompiledLine& line, const nc::Reference& reference,
                           const ControlValue& value) {
    std::array<std::int64_t, 4> indices{};
    if (reference.indices.is_given()) {
        const Evaluator::Outcome outcome = evaluator.indices(line.line, reference, indices);
        if (!missing_inputs_.empty()) report_missing(line);
        switch (outcome) {
            case Evaluator::Outcome::Done: break;
            case Evaluator::Outcome::Later: return Outcome::Wait;
            case Evaluator::Outcome::Fault: return fail(line, evaluator.fault());
        }
    }
    if (variables.must_wait(reference.load, indices)) return Outcome::Wait;
    VariableFault fault = writes.store(line, reference, indices, value);
    if (fault.row == nullptr) return Outcome::Nothing;
    // The control's own state has the name that the program uses.
    const bool is_family = reference.load.kind == nc::ControlInstruction::Kind::Family;
    const bool is_state = is_family || reference.load.kind == nc::ControlInstruction::Kind::System;
    const auto quantity = is_family ? variables.quantity_of(reference.load.index, indices[0])
                                    : static_cast<nc::SystemQuantity>(reference.load.index);
    if (is_state && !fault.arguments.empty() && fault.arguments[0] == info(quantity).name) {
        fault.arguments[0] =
            line.text.substr(reference.span.begin, reference.span.end - reference.span.begin);
    }
    return fail(line, *fault.row, reference.span, fault.arguments);
}

/// Of what the line reads and nobody has given, once.
void ProgramBase::report_missing(const CompiledLine& line) {
    for (const MissingInput& missing : std::exchange(missing_inputs_, {})) {
        const bool is_explained = !missing.meaning.empty();
        const bool has_index = missing.name.find(language.index_open) != std::string::npos;
        sink.report(diag::InputMissing, lines.location(line.text, frame->here.line, missing.span))
            .arg('`' + missing.name + '`' + (is_explained ? " (" + missing.meaning + ')' : ""))
            .fix("give it a value: `--set '" + missing.name +
                 "=1'`, or `<data>` in the machine file" +
                 (has_index ? "; its other elements are not reported" : ""));
    }
}

/// What follows is executed in this program, with its variables.
void ProgramBase::resume_frame(RunningProgram& next) {
    frame = &next;
    variables.enter(*next.level);
    evaluator.enter(*next.level);
    variables.system_variables().set_program_level(frames.size() - 1);
    lines.bounds().enter(next.text);
}

}  // namespace kadr::macro
