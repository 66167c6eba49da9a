#include "driver/expand.h"

#include <array>
#include <memory>
#include <utility>

#include "base/diagnostics/driver.h"
#include "driver/dangers.h"
#include "driver/execution.h"
#include "driver/file_text.h"
#include "driver/generated_text.h"
#include "driver/output.h"
#include "driver/output_names.h"

namespace kadr::driver {

namespace {

constexpr const char* kDefaultTarget = "iso";

Status refused(Session& session) {
    session.mark_usage();
    return session.status();
}

}  // namespace

Status expand(Session& session, const ExpandJob& job) {
    Messages& messages = session.messages();
    const auto source = open_source(session, job.source);
    if (!source) return session.status();
    if (job.source != "-" && !is_kadr_name(job.source)) {
        messages.report(diag::NotAKadrProgram).arg(job.source);
        return refused(session);
    }
    const std::array<std::string, 2> outputs = {job.output, job.map};
    if (!require_outputs_apart(session.files(), job.source, outputs, messages))
        return refused(session);
    const nc::Dialect* target = session.chosen_dialect(kDefaultTarget);
    if (target == nullptr) return session.status();
    const std::optional<KadrProgram> program =
        load_program(session, keep_source(session, job.source, *source));
    if (!program) return session.status();

    const OutputRules rules = session.output_rules();
    const auto text_output = Output::open(session.files(), job.output, messages, rules);
    const auto map_output =
        job.map.empty() ? nullptr : Output::open(session.files(), job.map, messages, rules);
    if (!text_output || (!map_output && !job.map.empty())) return refused(session);

    // For a machine the text is run as well, for the dangers that are in it.
    const bool has_machine = !session.options().machine.empty();
    auto text = std::make_unique<GeneratedText>(
        session, *program, *target, TextAside{.map = map_output.get(), .keeps_calls = has_machine});
    text->warn_of_cuts(messages);
    text->set_tap([&](std::string_view piece) { text_output->write(piece); });
    if (!text->start()) return session.status();
    if (has_machine) {
        make_with_dangers(session, *program, *target, std::move(text));
    } else {
        while (!text->next().empty()) {
            if (!session.require_output_room()) return session.status();
            session.report({.blocks = text->blocks(), .setpoints = 0, .time = 0});
        }
        if (text->failed()) return session.status();
    }
    if (session.status() != Status::Done) return session.status();
    const bool is_written =
        text_output->commit(messages) && (!map_output || map_output->commit(messages));
    return is_written ? session.status() : refused(session);
}

}  // namespace kadr::driver
