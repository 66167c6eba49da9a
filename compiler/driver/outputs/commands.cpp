// commands.cpp — `--commands`: what was executed, as JSON Lines.
#include <vector>

#include "base/json_writer.h"
#include "driver/outputs.h"
#include "interp/listing.h"

namespace kadr::driver {

namespace {

class CommandsOutput final : public RunOutput {
  public:
    explicit CommandsOutput(const OutputParts& parts)
        : session_(parts.session), file_(parts.file) {}
    Wants wants() const override { return {.commands = true}; }

    Done follow(Execution& execution) override {
        execution_ = &execution;
        listing_.emplace(execution.machine());
        return kDone;
    }
    void see_command(const path::Command& command) override;
    /// The last line of a list that is not complete: `{"op":"alarm","text":…}`.
    void finish(const RunFigures& figures) override;

  private:
    const std::string& source_of(const path::Command& command);

    const Session& session_;
    Output& file_;
    const Execution* execution_ = nullptr;
    std::optional<interp::Listing> listing_;
    std::vector<std::string> names_;  // of statements, by SourceId; empty: not asked for yet
    std::string line_;
    path::Command called_;  // with the number of its line in its own file
};

const std::string& CommandsOutput::source_of(const path::Command& command) {
    static const std::string nothing;
    const SourceRange range = execution_->statement(command.source);
    if (!range.file.is_valid()) return nothing;
    // A statement in a loop is named many times and located once.
    if (names_.size() <= command.source.index) names_.resize(command.source.index + 1);
    std::string& name = names_[command.source.index];
    if (name.empty()) name = session_.source_name(range);
    return name;
}

void CommandsOutput::see_command(const path::Command& command) {
    line_.clear();
    if (macro::NcProgram::is_in_main_text(command.line)) {
        listing_->append(command, source_of(command), line_);
    } else {
        const TextLocation location = execution_->location_of(command.line);
        called_ = command;
        called_.line = location.line;
        listing_->append(called_, location.file + ':' + std::to_string(location.line), line_);
    }
    file_.write(line_);
}

void CommandsOutput::finish(const RunFigures& figures) {
    if (figures.alarm.empty()) return;
    line_.clear();
    JsonWriter json(line_);
    json.object([&] {
        json.key("op").value("alarm");
        json.key("text").value(figures.alarm);
    });
    json.end_line();
    file_.write(line_);
}

}  // namespace

std::unique_ptr<RunOutput> make_commands(const OutputParts& parts) {
    return std::make_unique<CommandsOutput>(parts);
}

}  // namespace kadr::driver
