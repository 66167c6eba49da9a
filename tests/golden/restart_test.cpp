// The operator's restart: each section of a part, started alone after a reset, moves as it does in
// the whole.
#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/disk_files.h"
#include "tests/common/process.h"
#include "tests/common/scratch.h"
#include "tests/golden/parts.h"

namespace golden::restart_test {

namespace {

using nlohmann::json;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

/// A motion with how the spindle turns and whether coolant flows in it.
struct Move {
    std::size_t line = 0;  // of the text, from 1
    json command;
};

/// What moves in a text, and the lines in which tools are changed.
struct Moves {
    std::vector<Move> all;
    std::vector<std::size_t> tools;
    std::string errors;
};

Moves run_of(const std::string& text, const std::string& dialect, const std::string& machine) {
    const std::string file =
        kadr::testing::scratch(dialect == "sinumerik" ? "section.mpf" : "section.nc");
    EXPECT_TRUE(kadr::write_file_whole(file, text));
    const ProcessResult result =
        run_process({KADR_BINARY, "run", file, "-d", dialect, "-m", machine, "--commands", "-"});
    Moves run;
    if (result.status != 0) run.errors = result.err;
    json spindle;
    json coolant = {{"op", "coolant"}, {"mode", "off"}};
    std::istringstream in(result.out);
    for (std::string line; std::getline(in, line);) {
        json command = json::parse(line, nullptr, false);
        if (!command.is_object()) continue;
        const std::size_t at = command.value("iso", std::size_t{0});
        for (const char* key : {"iso", "src"}) command.erase(key);
        if (command["op"] == "tool") run.tools.push_back(at);
        if (command["op"] == "spindle") spindle = command;
        if (command["op"] == "coolant") coolant = command;
        if (!command.contains("to")) continue;
        command["spindle"] = spindle;
        command["coolant"] = coolant;
        run.all.push_back({at, std::move(command)});
    }
    return run;
}

bool is_cut(const json& command) { return command["op"] != "rapid"; }

/// Up to the first cut the tool comes from wherever it stands: it comes down above the same
/// position, and the last way ends where the cut begins.
void expect_same(const std::vector<json>& whole, const std::vector<json>& alone) {
    ASSERT_EQ(whole.size(), alone.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
        for (const char* axis : {"X", "Y"})
            ASSERT_EQ(whole[i]["to"][axis], alone[i]["to"][axis]) << "move " << i;
    }
    const auto first = std::ranges::find_if(whole, is_cut);
    const auto begin = static_cast<std::size_t>(first - whole.begin());
    for (std::size_t i = begin > 0 ? begin - 1 : 0; i < whole.size(); ++i)
        ASSERT_EQ(whole[i], alone[i]) << "move " << i << " of the section";
}

/// The text that an operator starts in this line: what stands in front of the first block, and the
/// rest from the line on.
std::string from_line(const std::vector<std::string>& lines, std::size_t line) {
    std::string text;
    for (const std::string& head : lines) {
        const bool is_head = head.starts_with('%') || head.starts_with('O');
        if (!is_head) break;
        text += head + '\n';
    }
    for (std::size_t i = line - 1; i < lines.size(); ++i) text += lines[i] + '\n';
    return text;
}

}  // namespace

class Restart : public ::testing::TestWithParam<Part> {};

TEST_P(Restart, EachSectionStandsAlone) {
    const Part& part = GetParam();
    for (const std::string& dialect : part.dialects()) {
        const ProcessResult made =
            run_process({KADR_BINARY, "expand", part.source.string(), "-d", dialect});
        ASSERT_EQ(made.status, 0) << made.err;
        const std::vector<std::string> lines = lines_of(made.out);
        const Moves whole = run_of(made.out, dialect, part.machine);
        ASSERT_EQ(whole.errors, "");
        for (std::size_t i = 1; i < whole.tools.size(); ++i) {
            // The tool is called in the line of M6, or in the one before.
            std::size_t line = whole.tools[i];
            if (lines[line - 1].find('T') == std::string::npos) --line;
            SCOPED_TRACE(dialect + ", from " + lines[line - 1]);
            EXPECT_TRUE(lines[line - 1].starts_with('N'));
            const Moves alone = run_of(from_line(lines, line), dialect, part.machine);
            ASSERT_EQ(alone.errors, "");
            std::vector<json> of_whole, of_alone;
            for (const Move& move : whole.all)
                if (move.line >= line) of_whole.push_back(move.command);
            for (const Move& move : alone.all) of_alone.push_back(move.command);
            expect_same(of_whole, of_alone);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Parts, Restart,
                         ::testing::ValuesIn(parts_of(fs::path(KADR_ROOT) / "examples")),
                         [](const auto& part) { return part.param.name(); });

}  // namespace golden::restart_test
