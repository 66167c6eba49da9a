// System variables of the controls' references, one a line, and what becomes of them in a program:
// `NAME | READS | WRITES => OUTCOME`. READS is a text that reads it, WRITES one that writes it;
// `//` stands between lines. The outcome is `read`, `written`, `read and written`, or the code of
// the alarm with which reading ends; K5018 is what the control has and Kadr does not. KADR_UPDATE=1
// writes what is so today.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostics/control.h"
#include "base/text.h"
#include "macro/program.h"
#include "tests/common/whole_text.h"
#include "tests/interp/bench.h"

namespace kadr::interp::variables_test {

using macro::NcProgram;
using macro::ProgramOptions;
namespace {

namespace fs = std::filesystem;

const fs::path kVariables = fs::path(KADR_ROOT) / "tests/control/variables";

/// The code of the alarm with which a program ends; empty: without one. An alarm that is what
/// writing does counts as none.
std::string alarm_of(const nc::Dialect& dialect, const std::string& text) {
    machine::Machine machine = mill();
    machine.is_lathe = dialect.name().find("lathe") != std::string_view::npos;
    DiagnosticList messages;
    WholeText source(text);
    ProgramOptions options;
    options.max_turns = 100;
    NcProgram program(dialect, source, "test", options, messages);
    Interpreter interpreter(dialect, machine, program, &program, nullptr, {}, messages);
    program.follow(interpreter);
    std::vector<path::Command> batch(8);
    while (interpreter.pull(batch) != 0) {
    }
    for (const Diagnostic& message : messages.all()) {
        const bool is_given = message.row == &diag::ProgramAlarm;
        if (message.severity == Severity::Alarm && !is_given) return std::string(message.row->code);
    }
    return "";
}

std::string with_lines(std::string text) {
    for (std::size_t at = 0; (at = text.find("//", at)) != std::string::npos; ++at)
        text.replace(at, 2, "\n");
    return text;
}

class Variables : public ::testing::TestWithParam<std::string> {};

TEST_P(Variables, AreReadOrWrittenAsWritten) {
    Sources sources;
    DiagnosticList loading;
    const auto dialect = nc::load_dialect(
        GetParam(), {KADR_ROOT "/dialects", KADR_ROOT "/examples/dialects"}, sources, loading);
    ASSERT_TRUE(dialect.has_value());
    const fs::path file = kVariables / (GetParam() + ".txt");
    std::istringstream lines(read_file(file.string()).value_or(""));
    std::string today;
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
        const std::size_t reads = line.find(" | ");
        const std::size_t writes = line.find(" | ", reads + 3);
        const std::size_t sign = line.find(" => ");
        ASSERT_TRUE(writes != std::string::npos && sign != std::string::npos) << line;
        const std::string end = "\nM30\n";
        const std::string reading =
            alarm_of(*dialect, with_lines(line.substr(reads + 3, writes - reads - 3)) + end);
        const std::string writing =
            alarm_of(*dialect, with_lines(line.substr(writes + 3, sign - writes - 3)) + end);
        const std::string outcome = reading.empty() ? writing.empty() ? "read and written" : "read"
                                    : writing.empty() ? "written"
                                                      : reading;
        EXPECT_EQ(outcome, line.substr(sign + 4)) << line;
        today += line.substr(0, sign + 4) + outcome + '\n';
    }
    EXPECT_GT(count, 50);
    if (std::getenv("KADR_UPDATE") != nullptr) write_file_whole(file.string(), today);
}

std::string test_name(std::string name) {
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Dialects, Variables,
                         ::testing::Values("sinumerik", "axioma", "fanuc", "fanuc-lathe"),
                         [](const auto& test) { return test_name(test.param); });

}  // namespace
}  // namespace kadr::interp::variables_test
