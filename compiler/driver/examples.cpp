#include "driver/examples.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "base/diagnostics/dialect.h"
#include "driver/cycles.h"
#include "driver/program.h"
#include "expand/expander.h"
#include "nc/check.h"

namespace kadr::driver {

namespace {

/// The blocks of an example's source, or what is wrong with it.
struct Trial {
    std::vector<nc::Block> blocks;
    std::string fault;
};

/// The name in front of the first parenthesis: of a command or a cycle.
std::string_view called(std::string_view source) { return source.substr(0, source.find('(')); }

/// A program of this one statement. A cycle is a function of the library and has to be imported.
std::string program_of(const nc::Example& example, const nc::Dialect& dialect,
                       const std::string& library) {
    std::string text;
    if (dialect.find_cycle(called(example.source))) {
        for (const std::string& file : cycle_files(library)) {
            text += "import cycles." + std::filesystem::path(file).stem().string() + ";\n";
        }
    }
    return text + "program example() { " + example.source + " }\n";
}

Trial run_source(Session& session, const nc::Example& example, const nc::Dialect& dialect) {
    // The messages of the program are about a text that nobody has written: the first one is told
    // at the example instead.
    Messages messages(session.sources(), {}, [](std::string_view) {});
    Session inner({}, session.share(), session.sources(), messages);
    const FileId file =
        session.sources().add("example", program_of(example, dialect, session.share().library));
    const std::optional<Program> program = load_program(inner, file);
    Trial trial;
    if (program) {
        expand::Expander expander(*program->code, dialect, {}, messages);
        std::array<nc::Block, 8> batch;
        bool is_running = expander.start("", {});
        while (is_running) {
            const std::size_t count = expander.pull(batch);
            trial.blocks.insert(trial.blocks.end(), batch.begin(), batch.begin() + count);
            is_running = count > 0;
        }
    }
    trial.fault = messages.first_error();
    return trial;
}

}  // namespace

void check_examples(Session& session, const nc::Dialect& dialect) {
    for (const nc::Example& example : dialect.examples()) {
        Trial trial;
        if (!example.source.empty()) trial = run_source(session, example, dialect);
        if (trial.fault.empty()) {
            nc::check_example(dialect, example, trial.blocks, session.messages());
        } else {
            session.messages()
                .report(diag::DialectExampleSource, example.source_range)
                .arg(trial.fault);
        }
    }
}

}  // namespace kadr::driver
