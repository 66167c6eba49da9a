// `kadr run --limits`: the report for a technologist, and its table.
#include <regex>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/driver/scratch.h"

namespace limit_report_test {

namespace {

class LimitReports : public kadr::test::ScratchFolder {
  protected:
    std::string report(const std::string& name, const std::vector<std::string>& more = {}) {
        std::vector<std::string> words = {"run",       file("part.mpf"), "-d",
                                          "sinumerik", "--limits",       file(name)};
        words.insert(words.end(), more.begin(), more.end());
        const ProcessResult result = kadr(words);
        EXPECT_TRUE(result.status == 0 || result.status == 3) << result.err;
        return kadr::read_file(file(name)).value_or("");
    }
};

const char* const kSquare =
    "G17 G90 G71 G64 F3000\nT1 D1\nS5000 M3\nG0 X0 Y0 Z5\nG1 Z0\nX100\nY100\nX0\nY0\nG4 F2\n"
    "G0 Z50\nM30\n";

TEST_F(LimitReports, SaysWhatACornerCosts) {
    save("part.mpf", kSquare);
    const std::string text = report("limits.txt");
    EXPECT_NE(text.find("part.mpf: what keeps the motion below its feed"), std::string::npos);
    EXPECT_TRUE(std::regex_search(text, std::regex("\n  corner +[0-9.]+ s"))) << text;
    EXPECT_TRUE(std::regex_search(text, std::regex("\n  part.mpf:6\n      [0-9.]+ s of [0-9.]+ s: "
                                                   "[^\n]*corner [0-9.]+ s")))
        << text;
}

TEST_F(LimitReports, TheTableAddsUp) {
    save("part.mpf", kSquare);
    std::istringstream rows(report("limits.csv"));
    std::string line;
    std::getline(rows, line);
    EXPECT_EQ(line, "place,reason,lost,time");
    double corners = 0;
    int count = 0;
    while (std::getline(rows, line)) {
        ++count;
        EXPECT_TRUE(line.starts_with("part.mpf:")) << line;
        std::istringstream fields(line);
        std::string text, reason, lost;
        std::getline(fields, text, ',');
        std::getline(fields, reason, ',');
        std::getline(fields, lost, ',');
        if (reason == "corner") corners += std::stod(lost);
    }
    EXPECT_GT(count, 4);
    EXPECT_GT(corners, 0.001);
    EXPECT_LT(corners, 1);
}

TEST_F(LimitReports, TellsToolsApart) {
    save("part.mpf",
         "G17 G90 G71 F3000\nT1 M6\nD1 S5000 M3\nG0 X0 Y0 Z5\nG1 X100\nT2 M6\nD1 S5000 M3\n"
         "G60 G1 X50\nX0\nM30\n");
    const std::string text = report("limits.txt");
    EXPECT_NE(text.find("by tool"), std::string::npos) << text;
    EXPECT_NE(text.find("\n  T1 "), std::string::npos) << text;
    EXPECT_NE(text.find("\n  T2 "), std::string::npos) << text;
}

TEST_F(LimitReports, EndsWithTheAlarm) {
    save("part.mpf", "G17 G90 G71 F3000\nT1 D1\nS5000 M3\nG1 X10\nG1 X999999\nM30\n");
    EXPECT_NE(report("limits.txt").find("# not complete, ended by"), std::string::npos);
}

TEST_F(LimitReports, OfAPulsedLaser) {
    save("part.mpf", "G17 G90 G71 F1800\nT1 D1\nS1000 M3\nG1 X0.12\nX0.24\nX0.36\nX0.48\nM30\n");
    const std::string text = report("limits.txt", {"-m", "laser"});
    EXPECT_NE(text.find("pulse window"), std::string::npos) << text;
}

}  // namespace

}  // namespace limit_report_test
