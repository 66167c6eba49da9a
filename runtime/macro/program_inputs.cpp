// program_inputs.cpp — what the machine tells a program: values before it begins, and at their
// times.
//
// They are said in the control's own words, as assignments and as blocks that write data. A line
// that sets nothing is told with its place; the others act.
#include <algorithm>
#include <utility>

#include "base/diagnostics/control.h"
#include "base/diagnostics/driver.h"
#include "macro/program_state.h"

namespace kadr::macro {

using nc::Block;
using nc::Function;
using nc::Statement;

namespace {

/// A text that is all there, and can be read again.
class HeldText final : public nc::TextSource {
  public:
    explicit HeldText(std::string text) : text_(std::move(text)) {}
    std::string_view next() override {
        const std::size_t from = std::exchange(at_, text_.size());
        return std::string_view(text_).substr(from);
    }
    bool seek(std::uint64_t offset) override {
        at_ = std::min<std::size_t>(offset, text_.size());
        return true;
    }

  private:
    std::string text_;
    std::size_t at_ = 0;
};

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
void Program::State::begin_inputs() {
    if (options.inputs.empty()) return;
    onlooker_changes = variables.note_changes(nullptr);
    for (auto inputs = options.inputs.rbegin(); inputs != options.inputs.rend(); ++inputs) {
        auto open = std::make_unique<Frame>();
        open->unit = &units.add(std::make_unique<HeldText>(inputs->text), inputs->name);
        open->text.name = inputs->name;
        open->level = &variables.main_level();
        open->here = open->unit->begin;
        open->inputs = &*inputs;
        frames.push_back(std::move(open));
    }
    resume_frame(*frames.back());
}

/// Behind the last one the program begins, unless something was wrong.
void Program::State::leave_inputs() {
    variables.note_changes(onlooker_changes);
    if (!has_wrong_inputs) return;
    lines.note_fault();
    has_ended = true;
}

Program::State::Outcome Program::State::step_in_input(Block& out) {
    std::string_view text;
    bool is_too_long = false;
    if (!source().seek(frame->here.offset) || !source().next(text, is_too_long)) {
        frame->is_returning = true;
        return finish_return(out);
    }
    const LinePosition next{source().offset(), frame->here.line + 1};
    scratch.text = text;
    scratch.place = {frame->here, next};
    frame->goes_on = next;
    frame->resume = 0;
    lines.begin(frame->here.line);
    DiagnosticList heard;
    ear.listen(&heard);
    variables.let_machine_write(true);
    Outcome done = run_input(scratch, out);
    variables.let_machine_write(false);
    ear.listen(nullptr);
    if (done == Outcome::Wait) return done;
    if (lines.failed()) {
        tell_wrong_input(scratch.text, heard.all(), frame->inputs->is_said);
        lines.forget_fault();
        out.reset();
        done = Outcome::Nothing;
    }
    frame->here = next;
    if (done == Outcome::Block) deliver(out, scratch.text, next.line - 1, false);
    return done;
}

/// One line: assignments, or a block that writes data.
Program::State::Outcome Program::State::run_input(CompiledLine& line, Block& out) {
    const nc::Span whole{0, static_cast<std::uint32_t>(line.text.size())};
    if (lines.check_kind(line.text) != nc::LineReader::LineKind::Words) return Outcome::Nothing;
    Outcome done = Outcome::Block;
    if (!lines.read_plain(line.text, out)) {
        line.context = context();
        compile_language(line);
        if (lines.failed()) return Outcome::Failed;
        for (const nc::ControlStatement& statement : line.line.statements) {
            const bool is_assignment =
                statement.kind == Statement::Assign || statement.kind == Statement::NameVariables;
            if (!is_assignment) return fail(line, diag::InputNoValue, statement.span);
            const bool is_local = statement.kind == Statement::Assign &&
                                  statement.variable.load.kind == nc::Instruction::Kind::Local;
            const nc::Span& said = statement.variable.span;
            if (is_local) {
                return fail(line, diag::InputOfProgram, said,
                            {line.text.substr(said.begin, said.end - said.begin)});
            }
        }
        if (!line.line.calls.empty()) return fail(line, diag::InputNoValue, whole);
        done = run(line, out);
    }
    if (done != Outcome::Block || lines.failed()) return done;
    return writes_data(out) ? done : fail(line, diag::InputNoValue, whole);
}

void Program::State::tell_wrong_input(const std::string& text, const std::vector<Diagnostic>& heard,
                                      bool is_said) {
    const auto fault = std::ranges::find_if(
        heard, [](const Diagnostic& each) { return each.severity != Severity::Warning; });
    if (fault == heard.end()) return;
    const std::string name(name_in_front(text, language.index_open));
    const LinePlace place = fault->line.value_or(lines.place(text, frame->here.line, {0, 1}));
    const bool is_named = text.find('=') != std::string::npos && !name.empty();
    const bool is_unknown = is_named && !variables.type_of(name);
    if (is_unknown && !is_said) {
        if (passed_inputs.insert(name).second) sink.report(diag::InputPassed, place).arg(name);
        return;
    }
    // What was local in the run that wrote the file is gone.
    if (!is_said && fault->row == &diag::InputOfProgram) return;
    has_wrong_inputs = true;
    const bool is_own = fault->row == &diag::InputNoValue || fault->row == &diag::InputOfProgram;
    if (is_own) {
        DiagnosticBuilder message = sink.report(*fault->row, place);
        for (const std::string& argument : fault->arguments) message.arg(argument);
    } else if (is_unknown) {
        sink.report(diag::InputUnknown, place).arg(name);
    } else {
        sink.report(diag::InputWrong, place).arg(fault->message());
    }
}

/// Of what the line reads and nobody has given, once.
void Program::State::tell_missing(const CompiledLine& line) {
    for (const MissingInput& missing : std::exchange(missing_inputs, {})) {
        const bool is_explained = !missing.meaning.empty();
        const bool has_index = missing.name.find(language.index_open) != std::string::npos;
        sink.report(diag::InputMissing, lines.place(line.text, frame->here.line, missing.span))
            .arg('`' + missing.name + '`' + (is_explained ? " (" + missing.meaning + ')' : ""))
            .fix("give it a value: `--set '" + missing.name +
                 "=1'`, or `<data>` in the machine file" +
                 (has_index ? "; its other elements are not told" : ""));
    }
}

// ------------------------------------------------------------------------------ events

/// Whether the next line is one that an event waits for.
bool Program::State::comes_to_event() {
    event_block = {};
    if (is_only_checking || is_waiting || due || frame->is_returning) return false;
    const std::uint64_t offset = source().offset();
    std::string_view text;
    bool is_too_long = false;
    if (source().seek(frame->here.offset) && source().next(text, is_too_long))
        event_block.number = nc::front_of(tables, text).number;
    source().seek(offset);
    if (frame->unit->text == units.main().text) event_block.line = frame->here.line;
    return std::ranges::any_of(pending_events,
                               [this](const PendingEvent& each) { return is_here(each); });
}

bool Program::State::is_here(const PendingEvent& event) const {
    if (event.begun) return false;
    return event.event->number >= 0 ? event.event->number == event_block.number
                                    : event.event->line == event_block.line;
}

void Program::State::begin_event_block() {
    const double now = interpreter == nullptr ? 0 : interpreter->elapsed();
    for (PendingEvent& each : pending_events)
        if (is_here(each)) each.begun = now;
    waits_for_block = std::ranges::any_of(
        pending_events, [](const PendingEvent& each) { return !each.begun.has_value(); });
}

/// What is due in front of the statement that comes next.
void Program::State::act_events() {
    if (interpreter == nullptr || is_only_checking || is_acting) return;
    const double now = interpreter->elapsed();
    // Those of one time in their order; by the time that is their own, not by that of the line.
    constexpr double kSameTime = 1e-9;
    std::vector<PendingEvent> due_now;
    std::erase_if(pending_events, [&](const PendingEvent& each) {
        const bool is_due = each.begun && *each.begun + each.event->time <= now + kSameTime;
        if (is_due) due_now.push_back(each);
        return is_due;
    });
    std::ranges::stable_sort(
        due_now, {}, [](const PendingEvent& each) { return *each.begun + each.event->time; });
    is_acting = true;
    for (const PendingEvent& each : due_now) act_event(*each.event);
    is_acting = false;
}

/// As a text of its own: what it says is no line of the program.
void Program::State::act_event(const InputEvent& event) {
    CompiledLine line;
    line.text = event.text;
    nc::TextState apart;
    apart.name = event.file;
    const LinePosition goes_on = std::exchange(frame->goes_on, line.place.next);
    const std::size_t resume = std::exchange(frame->resume, 0);
    const bool has_executed = frame->has_executed;
    lines.enter(apart);
    lines.begin(event.file_line);
    DiagnosticList heard;
    ear.listen(&heard);
    variables.let_machine_write(true);
    variables.set_in_step(true);
    Block none;
    none.reset();
    if (run_input(line, none) == Outcome::Block) fail(line, diag::InputNoValue, {0, 1});
    variables.let_machine_write(false);
    ear.listen(nullptr);
    if (lines.failed()) {
        lines.forget_fault();
        tell_wrong_input(event.text, heard.all(), true);
        lines.note_fault();
        has_ended = true;
    }
    lines.enter(frame->text);
    lines.begin(frame->here.line);
    frame->goes_on = goes_on;
    frame->resume = resume;
    frame->has_executed = has_executed;
}

}  // namespace kadr::macro
