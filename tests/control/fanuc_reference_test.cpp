// The rows of the reference of FANUC's manuals, and the programs that show them:
// coverage/reference-fanuc.txt.
//   # 3.5 Planes and circular interpolation      a chapter
//   Radius error | fanuc/arc_off_circle.nc …     a row, and files below tests/control
//   Spiral | - an option of the control          … or why there is none
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace kadr::fanuc_reference_test {
namespace {

namespace fs = std::filesystem;

const fs::path kPrograms = fs::path(KADR_ROOT) / "tests/control";

class FanucReference : public ::testing::TestWithParam<fs::path> {};

TEST_P(FanucReference, EveryRowHasAProgramOrAReason) {
    std::ifstream lines(GetParam());
    std::string chapter;
    std::set<std::string> chapters, rows;
    int rows_of_chapter = 1;
    for (std::string line; std::getline(lines, line);) {
        SCOPED_TRACE(line);
        if (line.starts_with("# ")) {
            EXPECT_GT(rows_of_chapter, 0) << chapter << " has no row";
            EXPECT_TRUE(chapters.insert(line).second) << "the chapter stands twice";
            chapter = line;
            rows_of_chapter = 0;
            continue;
        }
        EXPECT_FALSE(chapter.empty()) << "a row before the first chapter";
        ++rows_of_chapter;
        const std::size_t sign = line.find(" | ");
        ASSERT_NE(sign, std::string::npos) << "a row is NAME | FILE… or NAME | - REASON";
        EXPECT_TRUE(rows.insert(chapter + line.substr(0, sign)).second) << "the row stands twice";
        const std::string behind = line.substr(sign + 3);
        if (behind.starts_with("- ")) {
            EXPECT_GT(behind.size(), 2u) << "a row without a program wants a reason";
            continue;
        }
        std::istringstream files(behind);
        int count = 0;
        for (std::string file; files >> file; ++count)
            EXPECT_TRUE(fs::is_regular_file(kPrograms / file)) << file;
        EXPECT_GT(count, 0);
    }
    EXPECT_GT(rows.size(), 50u);
    EXPECT_GT(rows_of_chapter, 0) << chapter << " has no row";
}

std::vector<fs::path> lists() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(kPrograms / "coverage")) {
        if (entry.path().filename().string().starts_with("reference-fanuc"))
            files.push_back(entry.path());
    }
    std::ranges::sort(files);
    return files;
}

INSTANTIATE_TEST_SUITE_P(Controls, FanucReference, ::testing::ValuesIn(lists()),
                         [](const auto& test) {
                             std::string name = test.param.stem();
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace kadr::fanuc_reference_test
