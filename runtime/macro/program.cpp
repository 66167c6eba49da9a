#include "macro/program.h"

#include "macro/program_run.h"

namespace kadr::macro {

using nc::Block;
using nc::Function;

struct Program::State final : public ProgramRun {
    using ProgramRun::ProgramRun;
};

Program::Program(const nc::Dialect& dialect, nc::TextSource& text, std::string name,
                 const ProgramOptions& options, DiagnosticSink& sink)
    : state_(std::make_unique<State>(dialect, text, std::move(name), options, sink)) {}
Program::~Program() = default;

void Program::check_only() { state_->phase.is_only_checking = true; }
bool Program::check_passed_text() { return state_->check_passed_text(); }
void Program::follow(ControlAccess& state) {
    state_->interpreter = &state;
    state_->variables.system_variables().follow(state);
}
void Program::print_to(Printer& printer) { state_->options.printer = &printer; }
void Program::show_to(LineWatch* watch, std::vector<VariableChange>* changes) {
    state_->watch = watch;
    state_->variables.note_changes(changes);
}
std::size_t Program::pull(std::span<Block> out) { return state_->pull(out); }
TextLocation Program::place(const Block& block) const { return state_->kept.place(block); }
TextLocation Program::place(const Block& block, nc::Slot slot) const {
    return state_->kept.place(block, slot);
}
TextLocation Program::place(const Block& block, Function function) const {
    return state_->kept.place(block, function);
}
std::vector<TextLocation> Program::calls(const Block& block) const {
    return state_->kept.calls(block);
}
TextLocation Program::place(std::uint32_t line) const {
    const ProgramUnits::Line found = state_->units.line_of(line);
    TextLocation place;
    place.file = found.text->name;
    place.line = static_cast<std::uint32_t>(found.number);
    return place;
}
void Program::keep_lines(std::size_t lines) { state_->kept.keep_earlier(lines); }
TextLocation Program::shown_place(std::uint32_t line, std::optional<nc::Slot> slot) const {
    Block block{};
    block.line = line;
    TextLocation found = slot ? state_->kept.place(block, *slot) : state_->kept.place(block);
    return found.text.empty() ? place(line) : found;
}
std::vector<TextLocation> Program::calls(SourceId source) const {
    return nc::places_of(state_->recent_calls.find(source));
}
bool Program::failed() const { return state_->phase.has_visible_fault; }
bool Program::stopped() const { return state_->phase.was_stopped; }
bool Program::calls_at_positions(const Block& block) const {
    const std::optional<CallsAtPositions>& calls = state_->frame->at_positions;
    return calls && calls->line == block.line;
}
bool Program::is_behind_fault(const Block& block) const {
    static_cast<void>(block);
    return state_->phase.has_visible_fault;
}
std::uint64_t Program::lines() const { return state_->counts.most_line; }
bool Program::has_fault() const { return state_->lines.faults().failed(); }
std::vector<Program::EventAhead> Program::events_ahead() const {
    std::vector<EventAhead> ahead;
    for (const InputEvents::PendingEvent& each : state_->events.pending())
        ahead.push_back({each.event, each.begun.has_value()});
    return ahead;
}

std::vector<ControlVariable> Program::variables() const {
    return state_->variables_at_end ? *state_->variables_at_end : state_->variables.list();
}
const std::vector<ActiveCode>& Program::codes() { return state_->codes.now(); }
std::uint64_t Program::line() const { return state_->frame->here.line; }
std::uint64_t Program::statements() const { return state_->counts.executed; }

}  // namespace kadr::macro
