// What Kadr proposes for mistakes out of habit (fixes.txt): the words that a reader sees, and that
// a fix which replaces text mends the program.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/common/process.h"
#include "tests/common/scratch.h"

namespace fixes_test {

namespace {

namespace fs = std::filesystem;

struct FixCase {
    std::string name;
    std::string written;                // the line of the program
    std::vector<std::string> expected;  // codes and fixes
};

std::vector<FixCase> all_fixes() {
    std::ifstream in(std::string(KADR_ROOT) + "/tests/bad/fixes.txt");
    std::vector<FixCase> cases;
    bool is_open = false;
    for (std::string line; std::getline(in, line);) {
        const bool is_comment = line.starts_with("# ") || line == "#";
        if (line.empty()) is_open = false;
        if (line.empty() || (is_comment && !is_open)) continue;
        if (is_open) {
            cases.back().expected.push_back(line);
            continue;
        }
        std::string name = std::to_string(cases.size() + 1) + '_';
        for (const char c : line) {
            if (std::isalnum(static_cast<unsigned char>(c)) != 0) name += c;
        }
        cases.push_back({name, line, {}});
        is_open = true;
    }
    return cases;
}

std::string program_with(const std::string& line) {
    const bool is_outside = line.starts_with("^ ");
    return (is_outside ? line.substr(2) + "\n" : std::string()) +
           "program p() {\n"
           "    length d = 10mm; real a = 1; int n = 3; length[] list = {1mm};\n"
           "    length с = 5mm; length плунжер = 6mm;\n"
           "    F100;\n"
           "    " +
           (is_outside ? "" : line) +
           "\n"
           "    G1 X=d*a Y=n Z=list[0]+с+плунжер;\n"
           "}\n";
}

class Fixes : public ::testing::TestWithParam<FixCase> {
  protected:
    ProcessResult check(const std::string& program, bool is_json) const {
        const fs::path file = kadr::testing::scratch("fix" + GetParam().name + ".kadr");
        std::ofstream(file, std::ios::binary) << program;
        std::vector<std::string> words = {KADR_BINARY, "check", file.string()};
        if (is_json) words.insert(words.end(), {"--diagnostics", "json"});
        ProcessResult result = run_process(words);
        fs::remove(file);
        return result;
    }
};

/// Codes of errors and lines of fixes, as they stand in the output.
std::vector<std::string> said_in(const std::string& output) {
    std::vector<std::string> shown;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
        const std::string mark = ": error[";
        const std::size_t at = line.find(mark);
        if (at != std::string::npos) shown.push_back(line.substr(at + mark.size(), 5));
        if (line.starts_with("  fix: ")) shown.push_back(line.substr(2));
    }
    return shown;
}

TEST_P(Fixes, SayWhatToWrite) {
    const ProcessResult result = check(program_with(GetParam().written), false);
    EXPECT_EQ(said_in(result.err), GetParam().expected) << result.err;
    EXPECT_EQ(result.status, GetParam().expected.empty() ? 0 : 1) << result.err;
}

/// Bytes before the character `column` (from 1) of the line `line` (from 1).
std::size_t byte_of(const std::string& text, std::size_t line, std::size_t column) {
    std::size_t at = 0;
    for (; line > 1; --line) at = text.find('\n', at) + 1;
    for (; column > 1; --column) {
        do ++at;
        while ((text[at] & 0xc0) == 0x80);
    }
    return at;
}

struct Edit {
    std::size_t begin, end;
    std::string replacement;
};

/// What the fixes of all messages replace, the last place first.
std::vector<Edit> edits_of(const std::string& messages, const std::string& program) {
    std::vector<Edit> edits;
    std::istringstream lines(messages);
    for (std::string line; std::getline(lines, line);) {
        const nlohmann::json message = nlohmann::json::parse(line);
        for (const nlohmann::json& fix : message.at("fixes")) {
            if (!fix.contains("replacement")) continue;
            edits.push_back({byte_of(program, fix.at("line"), fix.at("column")),
                             byte_of(program, fix.at("end_line"), fix.at("end_column")),
                             fix.at("replacement")});
        }
    }
    std::sort(edits.begin(), edits.end(),
              [](const Edit& a, const Edit& b) { return a.begin > b.begin; });
    return edits;
}

TEST_P(Fixes, MendTheProgram) {
    std::string program = program_with(GetParam().written);
    // One mistake may hide the next one of its kind.
    constexpr int kMostRounds = 3;
    bool is_mended = false;
    for (int round = 0; round < kMostRounds; ++round) {
        const std::vector<Edit> edits = edits_of(check(program, true).err, program);
        if (edits.empty()) break;
        for (const Edit& edit : edits)
            program.replace(edit.begin, edit.end - edit.begin, edit.replacement);
        is_mended = true;
    }
    if (!is_mended) return;  // the fix is in words
    const ProcessResult result = check(program, false);
    EXPECT_EQ(result.status, 0) << program << result.err;
}

INSTANTIATE_TEST_SUITE_P(Habits, Fixes, ::testing::ValuesIn(all_fixes()),
                         [](const auto& fix) { return fix.param.name; });

}  // namespace

}  // namespace fixes_test
