#include "macro/program.h"

#include "macro/program_run.h"

namespace kadr::macro {

using nc::Block;
using nc::Function;

struct NcProgram::State final : public ProgramRun {
    using ProgramRun::ProgramRun;
};

NcProgram::NcProgram(const nc::Dialect& dialect, nc::TextSource& text, std::string name,
                     const ProgramOptions& options, DiagnosticSink& sink)
    : state_(std::make_unique<State>(dialect, text, std::move(name), options, sink)) {}
NcProgram::~NcProgram() = default;

void NcProgram::check_only() { state_->phase.is_only_checking = true; }
bool NcProgram::check_passed_text() { return state_->check_passed_text(); }
void NcProgram::follow(ControlAccess& state) {
    state_->interpreter = &state;
    state_->variables.system_variables().follow(state);
}
void NcProgram::print_to(PrintTarget& printer) { state_->options.printer = &printer; }
void NcProgram::show_to(LineWatch* watch, std::vector<VariableChange>* changes) {
    state_->watch = watch;
    state_->variables.note_changes(changes);
}
std::size_t NcProgram::pull(std::span<Block> out) { return state_->pull(out); }
TextLocation NcProgram::location(const Block& block) const { return state_->kept.location(block); }
TextLocation NcProgram::location(const Block& block, nc::Slot slot) const {
    return state_->kept.location(block, slot);
}
TextLocation NcProgram::location(const Block& block, Function function) const {
    return state_->kept.location(block, function);
}
std::vector<TextLocation> NcProgram::calls(const Block& block) const {
    return state_->kept.calls(block);
}
TextLocation NcProgram::location(std::uint32_t line) const {
    const ProgramUnits::Line found = state_->units.line_of(line);
    TextLocation location;
    location.file = found.text->name;
    location.line = static_cast<std::uint32_t>(found.number);
    return location;
}
void NcProgram::keep_lines(std::size_t lines) { state_->kept.keep_earlier(lines); }
TextLocation NcProgram::shown_location(std::uint32_t line, std::optional<nc::Slot> slot) const {
    Block block{};
    block.line = line;
    TextLocation found = slot ? state_->kept.location(block, *slot) : state_->kept.location(block);
    return found.text.empty() ? location(line) : found;
}
std::vector<TextLocation> NcProgram::calls(SourceId source) const {
    return nc::locations_of(state_->recent_calls.find(source));
}
bool NcProgram::failed() const { return state_->phase.has_visible_fault; }
bool NcProgram::stopped() const { return state_->phase.was_stopped; }
bool NcProgram::calls_at_positions(const Block& block) const {
    const std::optional<CallsAtPositions>& calls = state_->frame->at_positions;
    return calls && calls->line == block.line;
}
bool NcProgram::is_behind_fault(const Block& block) const {
    static_cast<void>(block);
    return state_->phase.has_visible_fault;
}
std::uint64_t NcProgram::lines() const { return state_->counts.most_line; }
bool NcProgram::has_fault() const { return state_->lines.faults().failed(); }
std::vector<NcProgram::EventAhead> NcProgram::events_ahead() const {
    std::vector<EventAhead> ahead;
    for (const InputEvents::PendingEvent& each : state_->events.pending())
        ahead.push_back({each.event, each.begun.has_value()});
    return ahead;
}

std::vector<ControlVariable> NcProgram::variables() const {
    return state_->variables_at_end ? *state_->variables_at_end : state_->variables.list();
}
std::vector<ProgramLevel> NcProgram::levels() const {
    std::vector<ProgramLevel> levels;
    const auto& frames = state_->frames;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const RunningProgram& running = *frames[i];
        ProgramLevel level;
        if (i > 0) level.program = running.unit->name;
        if (running.unit->text != state_->units.main().text) level.file = running.unit->text->name;
        const nc::CallSite* site = i + 1 < frames.size() ? frames[i + 1]->site.get() : nullptr;
        level.line = site != nullptr ? site->location.line : running.here.line;
        levels.push_back(std::move(level));
    }
    return levels;
}
std::vector<ControlVariable> NcProgram::variables(std::size_t level, VariableOwner owner) const {
    return state_->variables.list(*state_->frames[level]->level, owner);
}
const std::vector<ActiveCode>& NcProgram::codes() { return state_->codes.now(); }
std::uint64_t NcProgram::line() const { return state_->frame->here.line; }
std::uint64_t NcProgram::statements() const { return state_->counts.executed; }

}  // namespace kadr::macro
