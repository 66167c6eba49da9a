// Words that no program of the corpus uses, one line each: `TEXT => BLOCK`, what the control reads
// and what it means, in the words of the examples of dialect files; `//` stands between the lines
// of a text and between blocks. KADR_UPDATE=1 writes what is read today, to be reviewed as an
// operator would.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "nc/dialect.h"
#include "write/check.h"

namespace kadr::words_test {
namespace {

namespace fs = std::filesystem;

const fs::path kWords = fs::path(KADR_ROOT) / "tests/control/words";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

class Words : public ::testing::TestWithParam<std::string> {};

TEST_P(Words, MeanWhatIsWritten) {
    Sources sources;
    DiagnosticList loading;
    const auto dialect = nc::load_dialect(
        GetParam(), {KADR_ROOT "/dialects", KADR_ROOT "/examples/dialects"}, sources, loading);
    ASSERT_TRUE(dialect.has_value());
    const fs::path file = kWords / (GetParam() + ".txt");
    std::istringstream lines(read_file(file.string()).value_or(""));
    std::string today;
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
        const std::size_t sign = line.find(" => ");
        const std::string text = line.substr(0, sign);
        const std::string block = sign == std::string::npos ? "?" : line.substr(sign + 4);
        nc::Example example;
        example.text = replaced(text, " // ", "\n");
        // An empty block would not be compared.
        example.block = block == "nothing" ? "?" : replaced(block, " // ", "\n");
        DiagnosticList messages;
        write::check_example(*dialect, example, {}, messages);
        std::string means = block;
        if (!messages.all().empty()) {
            const Diagnostic& message = messages.all()[0];
            means = message.arguments.size() == 3 ? message.arguments[1] : message.message();
            means = means.empty() ? "nothing" : replaced(means, " ⏎ ", " // ");
        }
        today += text + " => " + means + '\n';
        EXPECT_EQ(means, block) << text;
    }
    EXPECT_GT(count, 3);
    if (std::getenv("KADR_UPDATE") != nullptr) write_file_whole(file.string(), today);
}

std::vector<std::string> all_words() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(kWords)) names.push_back(entry.path().stem());
    std::sort(names.begin(), names.end());
    return names;
}

INSTANTIATE_TEST_SUITE_P(Dialects, Words, ::testing::ValuesIn(all_words()),
                         [](const auto& test) { return replaced(test.param, "-", "_"); });

}  // namespace
}  // namespace kadr::words_test
