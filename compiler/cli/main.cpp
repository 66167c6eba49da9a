// main.cpp — the program `kadr`: arguments in, exit status out. Everything between is the driver's.
#include <cstdio>
#include <cstdlib>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include <unistd.h>

#include "base/diagnostics/driver.h"
#include "base/disk_files.h"
#include "cli/options.h"
#include "cli/out_of_memory.h"
#include "cli/progress.h"
#include "driver/check.h"
#include "driver/compare.h"
#include "driver/expand.h"
#include "driver/format.h"
#include "driver/machine_solve.h"
#include "driver/parameters.h"
#include "driver/run.h"
#include "driver/session.h"
#include "driver/tables.h"
#include "driver/test.h"
#include "repl/terminal.h"

namespace {

using namespace kadr;
using driver::Status;

void print(std::FILE* out, std::string_view text) { std::fwrite(text.data(), 1, text.size(), out); }

/// Whether all that was written to standard output has come there. Asked behind the last of it.
bool is_output_whole() {
    const bool is_flushed = std::fflush(stdout) == 0;
    return is_flushed && std::ferror(stdout) == 0;
}

/// For what does not go through an output of the driver.
Status reported(driver::Session& session, Status status) {
    if (is_output_whole()) return status;
    session.messages().report(diag::FileUnwritable).arg("standard output");
    return Status::Usage;
}

Status show(driver::Session& session, const driver::Reply& reply) {
    print(stdout, reply.text);
    return reported(session, reply.status);
}

/// A command at a break point; nothing at the end of the input.
std::optional<std::string> ask() {
    print(stderr, "kadr: ");
    std::string line;
    for (int c = std::getchar(); c != '\n'; c = std::getchar()) {
        if (c == EOF) return std::nullopt;
        line += static_cast<char>(c);
    }
    return line;
}

/// With somebody who looks on if the program does not come from where he types.
Status run(driver::Session& session, const cli::CommandLine& line, cli::ProgressLine& progress) {
    driver::RunJob job = line.run;
    job.onlooker.say = [&progress](std::string_view text) {
        progress.clear();
        print(stderr, text);
    };
    job.onlooker.reads_json = line.messages == driver::MessageFormat::Json;
    const bool is_terminal = ::isatty(STDIN_FILENO) != 0 && ::isatty(STDERR_FILENO) != 0;
    if (is_terminal && job.source != "-" && !job.onlooker.reads_json) job.onlooker.ask = ask;
    return driver::run(session, job);
}

Status perform(driver::Session& session, const cli::CommandLine& line,
               cli::ProgressLine& progress) {
    switch (line.verb) {
        case cli::Verb::Expand: return driver::expand(session, line.expand);
        case cli::Verb::Parameters: return driver::list_parameters(session, line.parameters);
        case cli::Verb::Run: return run(session, line, progress);
        case cli::Verb::Compare: return driver::compare(session, line.compare);
        case cli::Verb::Check: return driver::check(session, line.sources);
        case cli::Verb::Test: return driver::test(session, line.test);
        case cli::Verb::Format: return driver::format(session, line.sources, line.format);
        case cli::Verb::Repl:
            return reported(session, repl::converse(line.options, session.inputs()));
        case cli::Verb::Explain: return show(session, driver::explain_message(session, line.word));
        case cli::Verb::DialectList: return show(session, driver::list_dialects(session));
        case cli::Verb::DialectCheck:
            return show(session, driver::check_dialect(session, line.file));
        case cli::Verb::DialectExplain:
            return show(session, driver::explain_word(session, line.file, line.word));
        case cli::Verb::MachineList: return show(session, driver::list_machines(session));
        case cli::Verb::MachineCheck:
            return show(session, driver::check_machine(session, line.file));
        case cli::Verb::MachineSolve:
            return show(session, driver::solve_machine(session, line.solve));
    }
    return Status::Usage;
}

Status perform(const cli::CommandLine& line) {
    const bool is_terminal = ::isatty(STDERR_FILENO) != 0;
    cli::ProgressLine progress(is_terminal);
    driver::SharedInputs inputs(disk(), driver::find_share(disk()));
    Sources sources = inputs.new_sources();
    driver::MessageOptions options;
    options.format = line.messages;
    if (line.verb == cli::Verb::Test) options.repeats = 10000;  // each stands for another test
    options.color = is_terminal && std::getenv("NO_COLOR") == nullptr;
    driver::Messages messages(sources, options, [&](std::string_view text) {
        progress.clear();
        print(stderr, text);
    });
    driver::Session session(line.options, inputs, sources, messages);
    if (is_terminal) session.set_progress([&](const driver::Progress& at) { progress.show(at); });
    const Status status = perform(session, line, progress);
    progress.clear();
    messages.finish();
    return status;
}

}  // namespace

int main(int count, char** arguments) try {
    cli::end_without_memory();
    const auto parsed = cli::parse_command_line(count, arguments);
    if (const auto* answer = std::get_if<cli::Answer>(&parsed)) {
        const bool is_done = answer->status == Status::Done;
        print(is_done ? stdout : stderr, answer->text);
        const bool is_written = !is_done || is_output_whole();
        return static_cast<int>(is_written ? answer->status : Status::Usage);
    }
    const auto& line = std::get<cli::CommandLine>(parsed);
    cli::say_out_of_memory_as(line.messages);
    return static_cast<int>(perform(line));
} catch (const std::bad_alloc&) {
    // Outputs that were begun are gone by now: what holds them has gone out of scope.
    return cli::report_out_of_memory();
} catch (const std::length_error&) {  // more elements than any memory has
    return cli::report_out_of_memory();
}
