#include "driver/check.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "driver/dangers.h"
#include "driver/execution.h"
#include "driver/file_text.h"
#include "driver/generated_text.h"

namespace kadr::driver {

namespace {

constexpr const char* kDefaultTarget = "iso";

/// Interprets ISO-7bit text to its end; what it commands is nobody's concern.
void interpret(Session& session, const std::string& source, std::unique_ptr<FileText> text) {
    const auto execution = Execution::open(session, source, std::move(text));
    if (!execution) return;
    std::vector<path::Command> batch(kBatch);
    while (execution->pull(batch) > 0) {
        session.report({.blocks = execution->blocks(), .setpoints = 0, .time = 0});
    }
    execution->read_rest();
}

/// Makes the text of a program that needs no values from outside, runs it and throws it away: what
/// comes to light only then is a mistake as well.
void try_out(Session& session, const KadrProgram& program) {
    const Options& options = session.options();
    const sema::FunctionCode* chosen = chosen_program(*program.code, options.program);
    if (chosen == nullptr) return;
    const bool is_complete = std::ranges::all_of(
        chosen->parameters, [](const auto& parameter) { return parameter.has_default; });
    if (!is_complete && options.defines.empty()) return;
    const nc::Dialect* target = session.chosen_dialect(kDefaultTarget);
    if (target == nullptr) return;
    auto text =
        std::make_unique<GeneratedText>(session, program, *target, TextAside{.keeps_calls = true});
    text->warn_of_cuts(session.messages());
    if (text->start()) make_with_dangers(session, program, *target, std::move(text));
}

}  // namespace

Status check(Session& session, std::span<const std::string> sources) {
    for (const std::string& source : sources) {
        auto text = open_source(session, source);
        if (!text) continue;
        if (is_kadr_source(source, *text)) {
            const auto program = load_program(session, keep_source(session, source, *text));
            if (program) try_out(session, *program);
        } else {
            interpret(session, source, std::move(text));
        }
    }
    const Status status = session.status();
    return status == Status::Alarm ? Status::Failed : status;
}

}  // namespace kadr::driver
