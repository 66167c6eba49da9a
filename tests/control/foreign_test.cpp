// Words of other controls, one line each: `LINE => FIX`, what stands below the message when the
// line cannot be read. Every text that a dialect has for such words stands in its file.
// KADR_UPDATE=1 writes what is said today, to be reviewed.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "macro/program.h"
#include "nc/tables.h"
#include "tests/common/whole_text.h"
#include "tests/interp/bench.h"

namespace kadr::interp::foreign_test {

using macro::NcProgram;
namespace {

namespace fs = std::filesystem;

const fs::path kRows = fs::path(KADR_ROOT) / "tests/control/foreign";

/// The fix of the first alarm, else of the first warning that has one; "none": the alarm has no
/// fix, "no alarm": the line can be read.
std::string fix_of(const nc::Dialect& dialect, const std::string& line) {
    DiagnosticList messages;
    WholeText source("F100\n" + line + "\nM30\n");
    NcProgram program(dialect, source, "test", {}, messages);
    machine::Machine machine = mill();
    machine.tool_change_time = 4;
    Interpreter interpreter(dialect, machine, program, &program, nullptr, {}, messages);
    program.follow(interpreter);
    std::vector<path::Command> batch(8);
    while (interpreter.pull(batch) != 0) {
    }
    std::string advice = "no alarm";
    for (const Diagnostic& message : messages.all()) {
        const bool has_fix = !message.fixes.empty();
        if (message.severity == Severity::Alarm) return has_fix ? message.fixes[0].text : "none";
        if (has_fix && advice == "no alarm") advice = message.fixes[0].text;
    }
    return advice;
}

class ForeignWords : public ::testing::TestWithParam<const char*> {};

TEST_P(ForeignWords, HaveTheirFix) {
    Sources sources;
    DiagnosticList loading;
    const auto dialect = nc::load_dialect(GetParam(), {KADR_ROOT "/dialects"}, sources, loading);
    ASSERT_TRUE(dialect.has_value());
    std::set<std::string> missing;
    for (const auto& [word, text] : dialect->tables().foreign) missing.insert(text);

    const fs::path file = kRows / (std::string(GetParam()) + ".txt");
    std::istringstream lines(read_file(file.string()).value_or(""));
    std::string today;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t sign = std::min(line.find(" => "), line.size());
        const std::string text = line.substr(0, sign);
        const std::string fix = fix_of(*dialect, text);
        today += text + " => " + fix + '\n';
        missing.erase(fix);
        EXPECT_EQ(text + " => " + fix, line);
    }
    for (const std::string& text : missing) ADD_FAILURE() << "no line has the fix: " << text;
    if (std::getenv("KADR_UPDATE") != nullptr) write_file_whole(file.string(), today);
}

INSTANTIATE_TEST_SUITE_P(Dialects, ForeignWords, ::testing::Values("sinumerik", "fanuc"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace kadr::interp::foreign_test
