#include "driver/check.h"

#include <memory>
#include <utility>
#include <vector>

#include "driver/execution.h"
#include "driver/file_text.h"

namespace kadr::driver {

namespace {

/// Interprets ISO-7bit text to its end; what it commands is nobody's concern.
void interpret(Session& session, const std::string& source, std::unique_ptr<FileText> text) {
    const auto execution = Execution::open(session, source, std::move(text), nullptr);
    if (!execution) return;
    std::vector<path::Command> batch(kBatch);
    while (execution->pull(batch) > 0) {
        session.tell({.blocks = execution->blocks(), .setpoints = 0, .time = 0});
    }
    execution->read_rest();
}

}  // namespace

Status check(Session& session, std::span<const std::string> sources) {
    for (const std::string& source : sources) {
        auto text = open_source(session, source);
        if (!text) continue;
        if (is_kadr_source(source, *text)) {
            load_program(session, keep_source(session, source, *text));
        } else {
            interpret(session, source, std::move(text));
        }
    }
    const Status status = session.status();
    return status == Status::Alarm ? Status::Failed : status;
}

}  // namespace kadr::driver
