#include "driver/examples.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/dialect.h"
#include "driver/cycles.h"
#include "driver/program.h"
#include "driver/program_example.h"
#include "expand/expander.h"
#include "nc/tables.h"
#include "path/curve_registry.h"
#include "write/check.h"

namespace kadr::driver {

namespace {

/// The blocks of an example's source, or what is wrong with it.
struct Trial {
    std::vector<nc::Block> blocks;
    std::vector<nc::Refusal> refusals;  // forms of cycles that do not fit
    std::string fault;
};

/// Whether the source calls a cycle: `G0 Z20; drill(to: -10mm);`
bool calls_cycle(std::string_view source, const nc::Dialect& dialect) {
    return std::ranges::any_of(dialect.cycles(), [&](const nc::CycleInfo& cycle) {
        const std::size_t at = source.find(cycle.name + '(');
        return at != std::string_view::npos &&
               (at == 0 || source[at - 1] == ' ' || source[at - 1] == ';');
    });
}

/// A program of this one statement. A cycle is a function of the library and has to be imported.
std::string program_of(const nc::Example& example, const nc::Dialect& dialect,
                       const std::string& library, const Files& files) {
    std::string text;
    if (calls_cycle(example.source, dialect)) {
        for (const std::string& file : cycle_files(library, files)) {
            text += "import cycles." + std::filesystem::path(file).stem().string() + ";\n";
        }
    }
    return text + "program example() { " + example.source + " }\n";
}

/// A block that sets what X is, and nothing else.
bool says_diameter_alone(const nc::Block& block) {
    return block.kind == nc::Block::Kind::Nc && block.motion == nc::Function::None &&
           block.given == 0 && block.function_count == 1 &&
           nc::info(block.functions[0].function).group == nc::Group::Diameter;
}

Trial run_source(Session& session, const nc::Example& example, const nc::Dialect& dialect) {
    // The messages of the program are about a text that nobody has written: the first one is
    // reported at the example instead.
    Messages messages(session.sources(), {}, [](std::string_view) {});
    Session inner({}, session.inputs(), session.sources(), messages);
    const FileId file = session.sources().add(
        "example", program_of(example, dialect, session.share().library, session.files()));
    const std::optional<KadrProgram> program = load_program(inner, file);
    Trial trial;
    if (program) {
        expand::ExpandOptions options;
        options.refusals = &trial.refusals;
        expand::Expander expander(*program->code, dialect, options, messages);
        std::array<nc::Block, 8> batch;
        auto is_running = static_cast<bool>(expander.start("", {}));
        while (is_running) {
            const std::size_t count = expander.pull(batch);
            trial.blocks.insert(trial.blocks.end(), batch.begin(), batch.begin() + count);
            is_running = count > 0;
        }
    }
    // A turning cycle stands in a program that has set what X is.
    if (calls_cycle(example.source, dialect)) std::erase_if(trial.blocks, says_diameter_alone);
    trial.fault = messages.first_error();
    return trial;
}

/// Why the file does not tell what the control's own cycle does; empty if it does.
std::string fault_of_cycle(const sema::Code& code, const nc::CycleInfo& cycle) {
    const auto function =
        std::ranges::find_if(code.functions, [&](const sema::FunctionCode& candidate) {
            return candidate.kind == sema::FunctionKind::Cycle && candidate.is_main_file &&
                   candidate.name == cycle.name;
        });
    if (function == code.functions.end()) return "it has no cycle `" + cycle.name + '`';
    const bool is_same = std::ranges::equal(
        cycle.parameters, function->parameters,
        [](const nc::Parameter& a, const sema::ParameterInfo& b) { return a.name == b.name; });
    if (!is_same) return "the parameters of its cycle `" + cycle.name + "` are others";
    return "";
}

/// An example of the control's own language is a program, executed to its end.
void check_program(Session& session, const nc::Dialect& dialect, const nc::Example& example) {
    const std::string found = outcome_of(session, dialect, example.text, example.gives);
    if (found == example.gives) return;
    session.messages()
        .report(diag::DialectExampleMeans, example.gives_range)
        .arg(example.text)
        .arg(found)
        .arg(example.gives)
        .note(write::first_difference(found, example.gives));
}

}  // namespace

void check_cycles(Session& session, const nc::Dialect& dialect) {
    for (const nc::CycleInfo& cycle : dialect.cycles()) {
        if (!cycle.curve.empty() && path::find_curve(cycle.curve) == nullptr) {
            session.messages()
                .report(diag::DialectBadValue, cycle.file_range)
                .arg(cycle.curve)
                .arg("curve")
                .arg("no kind of curve of this name is linked into this program");
        }
        if (cycle.file.empty()) continue;
        const std::optional<KadrProgram> program =
            load_program(session, cycle.file, dialect.tables().file, cycle.file_range);
        if (!program) continue;  // its mistakes have been reported
        const std::string fault = fault_of_cycle(*program->code, cycle);
        if (fault.empty()) continue;
        session.messages()
            .report(diag::DialectBadValue, cycle.file_range)
            .arg(std::filesystem::path(cycle.file).filename().string())
            .arg("file")
            .arg(fault);
    }
}

void check_examples(Session& session, const nc::Dialect& dialect) {
    for (const nc::Example& example : dialect.examples()) {
        if (!example.gives.empty()) {
            check_program(session, dialect, example);
            continue;
        }
        Trial trial;
        if (!example.source.empty()) trial = run_source(session, example, dialect);
        if (trial.fault.empty()) {
            write::check_example(dialect, example, trial.blocks, session.messages(),
                                 trial.refusals);
        } else {
            session.messages()
                .report(diag::DialectExampleSource, example.source_range)
                .arg(trial.fault);
        }
    }
}

}  // namespace kadr::driver
