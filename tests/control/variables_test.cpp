// System variables of the controls' references, one a line, and what becomes of them in a program:
// `NAME | READS | WRITES => OUTCOME`. READS is a text that reads it, WRITES one that writes it;
// `//` stands between lines. The outcome is `read`, `written`, `read and written`, or the code of
// the alarm with which reading ends; K5018 is what the control has and Kadr does not. A row holds
// for the controls that extend this one, too, unless they have another for the name. KADR_UPDATE=1
// writes what is so today.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostics/control.h"
#include "base/disk_files.h"
#include "base/text.h"
#include "macro/program.h"
#include "tests/common/held_texts.h"
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

/// `NAME | READS | WRITES`, and what becomes of it.
struct Row {
    std::string front;
    std::string outcome;
    bool is_own = false;  // of the control's list, else of the one that it extends
    std::string name() const { return front.substr(0, front.find(" | ")); }
    std::string line() const { return front + " => " + outcome; }
};

fs::path list_of(const std::string& control) { return kVariables / (control + ".txt"); }

std::vector<Row> own_rows(const std::string& control) {
    std::vector<Row> rows;
    std::istringstream lines(read_file(list_of(control).string()).value_or(""));
    for (std::string line; std::getline(lines, line);) {
        const std::size_t sign = line.find(" => ");
        if (sign == std::string::npos) ADD_FAILURE() << line;
        else rows.push_back({line.substr(0, sign), line.substr(sign + 4), true});
    }
    return rows;
}

/// The rows of a control: its own, and those of the control that it extends for all other names.
std::vector<Row> rows_of(const std::string& control) {
    std::vector<Row> rows = own_rows(control);
    const std::string base = golden::base_of(control);
    if (base.empty()) return rows;
    const std::size_t own = rows.size();
    for (Row row : rows_of(base)) {
        const auto is_same = [&](const Row& other) { return other.name() == row.name(); };
        if (std::any_of(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(own), is_same))
            continue;
        row.is_own = false;
        rows.push_back(std::move(row));
    }
    return rows;
}

/// Whether the control that this one extends has the same row.
bool stands_twice(const std::string& control, const Row& row) {
    const std::string base = golden::base_of(control);
    if (base.empty()) return false;
    return std::ranges::any_of(rows_of(base),
                               [&](const Row& other) { return other.line() == row.line(); });
}

/// What becomes of a row today.
std::string outcome_of(const nc::Dialect& dialect, const std::string& front) {
    const std::size_t reads = front.find(" | ");
    const std::size_t writes = front.find(" | ", reads + 3);
    if (writes == std::string::npos) return "no row";
    const std::string end = "\nM30\n";
    const std::string reading =
        alarm_of(dialect, with_lines(front.substr(reads + 3, writes - reads - 3)) + end);
    const std::string writing = alarm_of(dialect, with_lines(front.substr(writes + 3)) + end);
    if (!reading.empty()) return writing.empty() ? "written" : reading;
    return writing.empty() ? "read and written" : "read";
}

class Variables : public testing::TestWithParam<std::string> {};

TEST_P(Variables, AreReadOrWrittenAsWritten) {
    Sources sources;
    DiagnosticList loading;
    const auto dialect = nc::load_dialect(
        GetParam(), {KADR_ROOT "/dialects", KADR_ROOT "/examples/dialects"}, sources, loading);
    ASSERT_TRUE(dialect.has_value());
    const std::vector<Row> rows = rows_of(GetParam());
    EXPECT_GT(rows.size(), 50u);
    std::string today;
    for (const Row& row : rows) {
        Row now = row;
        now.outcome = outcome_of(*dialect, row.front);
        EXPECT_EQ(now.outcome, row.outcome) << row.front;
        EXPECT_FALSE(row.is_own && stands_twice(GetParam(), row))
            << row.line() << "\nis the row of the control that " << GetParam() << " extends";
        const bool differs = now.outcome != row.outcome;
        if (row.is_own ? !stands_twice(GetParam(), now) : differs) today += now.line() + '\n';
    }
    if (std::getenv("KADR_UPDATE") != nullptr && !today.empty()) {
        EXPECT_TRUE(write_file_whole(list_of(GetParam()).string(), today));
    }
}

std::string test_name(std::string name) {
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Dialects, Variables,
                         testing::Values("sinumerik", "axioma", "fanuc", "fanuc-lathe"),
                         [](const auto& test) { return test_name(test.param); });

}  // namespace
}  // namespace kadr::interp::variables_test
