// Which entries of the dialect files no text of the tests uses. The list of each dialect is
// tests/control/coverage/NAME.txt, an entry a line with the reason behind `#`; it may only shrink:
// an entry that is not in it must be used, one that is in it must not.
#include "nc/coverage.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "macro/program.h"
#include "tests/common/whole_text.h"
#include "tests/golden/parts.h"
#include "tests/interp/bench.h"

namespace kadr::interp::coverage_test {

using macro::NcProgram;
using macro::ProgramOptions;
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = KADR_ROOT;

std::string content_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The texts of the tests that are written for this control.
std::vector<std::string> texts_for(const nc::Dialect& dialect) {
    const std::string name(dialect.name());
    std::vector<std::string> texts;
    for (const char* folder : {"tests/control", "tests/bad/cases"}) {
        if (!fs::exists(kRoot / folder / name)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder / name)) {
            if (entry.is_regular_file()) texts.push_back(content_of(entry.path()));
        }
    }
    for (const fs::path& file : golden::texts_for(name)) texts.push_back(content_of(file));
    for (const auto& entry : fs::directory_iterator(kRoot / "tests/golden/input")) {
        const std::string file = entry.path().filename();
        if (file.starts_with(name) && file.ends_with(".nc"))
            texts.push_back(content_of(entry.path()));
    }
    for (const auto& entry : fs::directory_iterator(kRoot / "tests/golden/made")) {
        const std::string file = entry.path().filename();
        if (file.ends_with('.' + name + ".txt")) texts.push_back(content_of(entry.path()));
    }
    std::istringstream words(content_of(kRoot / "tests/control/words" / (name + ".txt")));
    for (std::string line; std::getline(words, line);) {
        std::string text = line.substr(0, line.find(" => "));
        for (std::size_t at = 0; (at = text.find(" // ", at)) != std::string::npos;)
            text.replace(at, 4, "\n");
        texts.push_back(text + '\n');
    }
    for (const nc::Example& example : dialect.examples()) texts.push_back(example.text);
    return texts;
}

/// Reads a text to its end, and executes it as far as it goes.
void use(const nc::Dialect& dialect, const std::string& text) {
    for (const bool only_reads : {true, false}) {
        DiagnosticList messages;
        WholeText source(text);
        ProgramOptions options;
        options.max_turns = 1000;
        options.max_repeated = 1000;
        NcProgram program(dialect, source, "text", options, messages);
        const machine::Machine machine = mill();
        Interpreter interpreter(dialect, machine, program, &program, nullptr, {}, messages);
        program.follow(interpreter);
        if (only_reads) {
            program.check_only();
            std::vector<nc::Block> blocks(64);
            while (program.pull(blocks) > 0) continue;
        } else {
            std::vector<path::Command> commands(64);
            while (interpreter.pull(commands) > 0) continue;
        }
    }
}

std::map<std::string, std::string> explained(const std::string& name) {
    std::istringstream lines(content_of(kRoot / "tests/control/coverage" / (name + ".txt")));
    std::map<std::string, std::string> entries;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t sign = line.rfind(" # ");
        if (sign == std::string::npos) continue;
        entries[line.substr(0, sign)] = line.substr(sign + 3);
    }
    return entries;
}

class Coverage : public ::testing::TestWithParam<std::string> {};

TEST_P(Coverage, EveryEntryIsUsedOrExplained) {
    Sources sources;
    DiagnosticList messages;
    auto dialect = nc::load_dialect(
        GetParam(), {KADR_ROOT "/dialects", KADR_ROOT "/examples/dialects"}, sources, messages);
    ASSERT_TRUE(dialect.has_value());
    nc::UsedEntries used;
    dialect->record(&used);
    for (const std::string& text : texts_for(*dialect)) use(*dialect, text);
    dialect->record(nullptr);
    EXPECT_FALSE(used.empty());
    std::map<std::string, std::string> open = explained(GetParam());
    for (const std::string& name : nc::unused_entries(*dialect, used)) {
        EXPECT_EQ(open.erase(name), 1u)
            << name << "\nis used by no text of the tests; write one, or say why in "
            << "tests/control/coverage/" << GetParam() << ".txt";
    }
    for (const auto& [name, reason] : open) {
        ADD_FAILURE() << name << "\nis used; take it out of tests/control/coverage/" << GetParam()
                      << ".txt";
    }
}

std::vector<std::string> all_dialects() {
    std::vector<std::string> names;
    for (const char* folder : {"dialects", "examples/dialects"}) {
        for (const auto& entry : fs::directory_iterator(kRoot / folder)) {
            if (entry.path().extension() == ".xml") names.push_back(entry.path().stem());
        }
    }
    std::ranges::sort(names);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Dialects, Coverage, ::testing::ValuesIn(all_dialects()),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace kadr::interp::coverage_test
