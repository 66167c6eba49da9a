// program_inputs.cpp — what the machine gives a program: values before it begins, and at their
// times.
//
// They are written in the control's own words, as assignments and as blocks that write data. A line
// that sets nothing is reported with its location; the others act.
#include "macro/program_inputs.h"

#include <algorithm>
#include <utility>

#include "base/diagnostics/driver.h"
#include "macro/program_run.h"
#include "nc/held_text.h"

namespace kadr::macro {

using nc::Block;
using nc::Function;
using nc::HeldText;
using nc::Statement;

namespace {

/// A block that writes data and moves nothing.
bool writes_data(const Block& block) {
    return block.motion == Function::None && block.find(nc::Fact::WritesData) != nullptr;
}

/// The name that a line sets: `$TC_DP6` of `N1 $TC_DP6[1,1]=5`.
std::string_view name_in_front(std::string_view text, char open) {
    const auto skip_blanks = [&] {
        text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    };
    skip_blanks();
    const std::size_t digits = std::min(text.find_first_not_of("0123456789", 1), text.size());
    const bool is_numbered = !text.empty() && (text[0] == 'N' || text[0] == 'n') && digits > 1;
    if (is_numbered && digits < text.size() && (text[digits] == ' ' || text[digits] == '\t')) {
        text.remove_prefix(digits);
        skip_blanks();
    }
    const char ends[] = {open, '=', ' ', '\t', '\0'};
    return text.substr(0, std::min(text.find_first_of(ends), text.size()));
}

}  // namespace

/// They are on top of the main program as if it had called them, the first one last.
void MachineInputs::begin() {
    if (run_.options.inputs.empty()) return;
    onlooker_changes_ = run_.variables.note_changes(nullptr);
    for (auto inputs = run_.options.inputs.rbegin(); inputs != run_.options.inputs.rend();
         ++inputs) {
        auto open = std::make_unique<RunningProgram>();
        open->unit = &run_.units.add(std::make_unique<HeldText>(inputs->text), inputs->name);
        open->text.name = inputs->name;
        open->level = &run_.variables.main_level();
        open->here = open->unit->begin;
        open->inputs = &*inputs;
        run_.add_frame(std::move(open));
    }
    run_.resume_frame(*run_.frames.back());
}

/// Behind the last one the program begins, unless something was wrong.
void MachineInputs::leave() {
    run_.variables.note_changes(onlooker_changes_);
    if (!has_wrong_) return;
    run_.lines.faults().note_fault();
    run_.end();
}

Outcome MachineInputs::step(Block& out) {
    std::string_view text;
    bool is_too_long = false;
    if (!run_.source().seek(run_.frame->here.offset) || !run_.source().next(text, is_too_long)) {
        run_.frame->is_returning = true;
        return run_.returns.finish(out);
    }
    const LinePosition next{run_.source().offset(), run_.frame->here.line + 1};
    run_.scratch.text = text;
    run_.scratch.program_line = {run_.frame->here, next};
    run_.frame->goes_on = next;
    run_.frame->resume = 0;
    run_.lines.begin(run_.frame->here.line);
    DiagnosticList heard;
    run_.ear.listen(&heard);
    run_.variables.machine_values().let_machine_write(true);
    Outcome done = run(run_.scratch, out);
    run_.variables.machine_values().let_machine_write(false);
    run_.ear.listen(nullptr);
    if (done == Outcome::Wait) return done;
    if (run_.lines.faults().failed()) {
        report_wrong(run_.scratch.text, heard.all(), run_.frame->inputs->is_given);
        run_.lines.faults().forget_fault();
        out.reset();
        done = Outcome::Nothing;
    }
    run_.frame->here = next;
    if (done == Outcome::Block) run_.deliver(out, run_.scratch.text, next.line - 1, false);
    return done;
}

/// One line: assignments, or a block that writes data.
Outcome MachineInputs::run(CompiledLine& line, Block& out) {
    const nc::Span whole{0, static_cast<std::uint32_t>(line.text.size())};
    if (run_.lines.check_kind(line.text) != nc::LineReader::LineKind::Words)
        return Outcome::Nothing;
    Outcome done = Outcome::Block;
    if (!run_.lines.read_plain(line.text, out)) {
        line.context = run_.context();
        run_.line_compiler.compile_language(line);
        if (run_.lines.faults().failed()) return Outcome::Failed;
        for (const nc::ControlStatement& statement : line.line.statements) {
            const bool is_assignment =
                statement.kind == Statement::Assign || statement.kind == Statement::NameVariables;
            if (!is_assignment) return run_.fail(line, diag::InputNoValue, statement.span);
            const bool is_local =
                statement.kind == Statement::Assign &&
                statement.variable.load.kind == nc::ControlInstruction::Kind::Local;
            const nc::Span& said = statement.variable.span;
            if (is_local) {
                return run_.fail(line, diag::InputOfProgram, said,
                                 {line.text.substr(said.begin, said.end - said.begin)});
            }
        }
        if (!line.line.calls.empty()) return run_.fail(line, diag::InputNoValue, whole);
        done = run_.run(line, out);
    }
    if (done != Outcome::Block || run_.lines.faults().failed()) return done;
    return writes_data(out) ? done : run_.fail(line, diag::InputNoValue, whole);
}

void MachineInputs::report_wrong(const std::string& text, const std::vector<Diagnostic>& heard,
                                 bool is_given) {
    const auto fault = std::ranges::find_if(
        heard, [](const Diagnostic& each) { return each.severity != Severity::Warning; });
    if (fault == heard.end()) return;
    const std::string name(name_in_front(text, run_.language.index_open));
    const TextLocation location =
        fault->line.value_or(run_.lines.location(text, run_.frame->here.line, {0, 1}));
    const bool is_named = text.find('=') != std::string::npos && !name.empty();
    const bool is_unknown = is_named && !run_.variables.type_of(name);
    if (is_unknown && !is_given) {
        if (passed_.insert(name).second) run_.sink.report(diag::InputPassed, location).arg(name);
        return;
    }
    // What was local in the run that wrote the file is gone.
    if (!is_given && fault->row == &diag::InputOfProgram) return;
    has_wrong_ = true;
    const bool is_own = fault->row == &diag::InputNoValue || fault->row == &diag::InputOfProgram;
    if (is_own) {
        DiagnosticBuilder message = run_.sink.report(*fault->row, location);
        for (const std::string& argument : fault->arguments) message.arg(argument);
    } else if (is_unknown) {
        run_.sink.report(diag::InputUnknown, location).arg(name);
    } else {
        run_.sink.report(diag::InputWrong, location).arg(fault->message());
    }
}

}  // namespace kadr::macro
