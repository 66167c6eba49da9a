#include "driver/command_list.h"

#include "base/json_writer.h"

namespace kadr::driver {

CommandList::CommandList(const Execution& execution, const Session& session, Output& out)
    : execution_(execution), session_(session), out_(out), listing_(execution.machine()) {}

const std::string& CommandList::source_of(const path::Command& command) {
    static const std::string nothing;
    const SourceRange range = execution_.statement(command.source);
    if (!range.file.is_valid()) return nothing;
    // A statement in a loop is named many times and located once.
    if (names_.size() <= command.source.index) names_.resize(command.source.index + 1);
    std::string& name = names_[command.source.index];
    if (name.empty()) name = session_.source_name(range);
    return name;
}

void CommandList::write(const path::Command& command) {
    line_.clear();
    if (macro::NcProgram::is_in_main_text(command.line)) {
        listing_.append(command, source_of(command), line_);
    } else {
        const TextLocation location = execution_.location_of(command.line);
        called_ = command;
        called_.line = location.line;
        listing_.append(called_, location.file + ':' + std::to_string(location.line), line_);
    }
    out_.write(line_);
}

void CommandList::write_alarm(std::string_view text) {
    line_.clear();
    JsonWriter json(line_);
    json.object([&] {
        json.key("op").value("alarm");
        json.key("text").value(text);
    });
    json.end_line();
    out_.write(line_);
}

}  // namespace kadr::driver
