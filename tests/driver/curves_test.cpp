// A kind of curve of one's own, from the text of a program to setpoints: examples/curves.
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/driver/scratch.h"

namespace curves_test {

namespace {

using kadr::test::Row;

const std::string kFolder = std::string(KADR_ROOT) + "/examples/curves";

class Curves : public kadr::test::ScratchFolder {
  protected:
    static ProcessResult kadr_curves(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), KADR_CURVES_BINARY);
        return run_process(arguments);
    }

    /// The setpoints of a text on the dialect of the example.
    std::vector<Row> setpoints_of(const std::string& text, std::vector<std::string> more = {}) {
        save("part.mpf", text);
        std::vector<std::string> words = {"run",         file("part.mpf"),
                                          "-d",          kFolder + "/clothoid.xml",
                                          "--setpoints", file("out.csv")};
        words.insert(words.end(), more.begin(), more.end());
        const ProcessResult result = kadr_curves(words);
        EXPECT_EQ(result.status, 0) << result.err;
        return kadr::test::rows_of(kadr::read_file(file("out.csv")).value_or(""));
    }
};

/// ∫ (cos, sin)(from·u + (to − from)·u²/2L) du over [0, L] by the midpoint rule, far below 1e-7.
std::pair<double, double> clothoid_end(double from, double to, double length) {
    constexpr int kParts = 200000;
    double x = 0;
    double y = 0;
    for (int i = 0; i < kParts; ++i) {
        const double u = length * (i + 0.5) / kParts;
        const double angle = (from + 0.5 * (to - from) / length * u) * u;
        x += std::cos(angle) * length / kParts;
        y += std::sin(angle) * length / kParts;
    }
    return {x, y};
}

const std::string kHead = "G17 G90 G71 G64 F6000\nT1 D1\nS5000 M3\nG0 X0 Y0 Z5\nG1 Z0\nX30\n";

TEST_F(Curves, TheExampleRuns) {
    const ProcessResult result =
        kadr_curves({"run", kFolder + "/transition.mpf", "-d", kFolder + "/clothoid.xml",
                     "--summary", "json", "--commands", file("commands.jsonl")});
    ASSERT_EQ(result.status, 0) << result.err;
    const auto summary = nlohmann::json::parse(result.out);
    EXPECT_EQ(summary["alarms"], 0);
    const std::string commands = kadr::read_file(file("commands.jsonl")).value_or("");
    EXPECT_NE(commands.find("\"op\":\"curve\""), std::string::npos);
    EXPECT_NE(commands.find("\"kind\":\"clothoid\""), std::string::npos);
}

TEST_F(Curves, TheToolMovesAlongIt) {
    const std::vector<Row> rows = setpoints_of(kHead + "CLOTHOID(0,0,0.05,20)\nM30\n");
    const auto [x, y] = clothoid_end(0, 0.05, 20);
    EXPECT_NEAR(rows.back().at("X"), 30 + x, 1e-6);
    EXPECT_NEAR(rows.back().at("Y"), y, 1e-6);
    // From tick to tick the way is the speed times the tick: 20 mm at 100 mm/s in the end.
    double distance = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        if (rows[i - 1].at("X") < 30) continue;
        distance += std::hypot(rows[i].at("X") - rows[i - 1].at("X"),
                               rows[i].at("Y") - rows[i - 1].at("Y"));
    }
    EXPECT_NEAR(distance, 20, 0.3);  // the tick that crosses the boundary counts for the line
}

TEST_F(Curves, FramesPlanesAndMirrorsAct) {
    const auto [x, y] = clothoid_end(0, 0.05, 20);
    const std::vector<Row> turned =
        setpoints_of(kHead + "ROT RPL=90\nG1 X0 Y-30\nCLOTHOID(0,0,0.05,20)\nM30\n");
    EXPECT_NEAR(turned.back().at("X"), 30 - y, 1e-6);
    EXPECT_NEAR(turned.back().at("Y"), x, 1e-6);
    const std::vector<Row> mirrored =
        setpoints_of(kHead + "MIRROR Y0\nG1 X30 Y0\nCLOTHOID(0,0,0.05,20)\nM30\n");
    EXPECT_NEAR(mirrored.back().at("Y"), -y, 1e-6);
    const std::vector<Row> upright =
        setpoints_of(kHead + "G18\nCLOTHOID(0,0,0.05,20)\nM30\n");  // Z is the first axis there
    EXPECT_NEAR(upright.back().at("Z"), x, 1e-6);
    EXPECT_NEAR(upright.back().at("X"), 30 + y, 1e-6);
}

TEST_F(Curves, SmoothJointsAreNoStops) {
    // In the middle of the example the tool has its feed all the time: 50 mm/s.
    save("part.mpf", kadr::read_file(kFolder + "/transition.mpf").value_or(""));
    const ProcessResult result = kadr_curves(
        {"run", file("part.mpf"), "-d", kFolder + "/clothoid.xml", "--setpoints", file("out.csv")});
    ASSERT_EQ(result.status, 0) << result.err;
    for (const Row& row : kadr::test::rows_of(kadr::read_file(file("out.csv")).value_or(""))) {
        const bool is_on_curves = row.at("X") > 30.5 && row.at("Z") < -0.999 && row.at("Y") < 13;
        if (is_on_curves) {
            EXPECT_GT(row.at("feed"), 2990) << row.at("t");
        }
    }
}

TEST_F(Curves, ThreadsChangeNothing) {
    const std::string text = kHead + "CLOTHOID(0,0,0.05,20)\nCLOTHOID(28.6,0.05,-0.2,30)\nM30\n";
    const std::vector<Row> with = setpoints_of(text, {"--threads", "on"});
    EXPECT_EQ(setpoints_of(text, {"--threads", "off"}), with);
}

TEST_F(Curves, WhatCannotBeIsAnAlarm) {
    const struct {
        const char* text;
        const char* says;
    } kRows[] = {
        {"CLOTHOID(0,0,0.05,-1)", "its length is not above zero"},
        {"CLOTHOID(0,0,5000,10)", "1000 radians"},
        {"$TC_DP6[1,1]=3\nT1 M6\nD1\nG41 X40\nCLOTHOID(0,0,0.05,20)", "compensation"},
    };
    for (const auto& row : kRows) {
        save("part.mpf", kHead + row.text + "\nM30\n");
        const ProcessResult result =
            kadr_curves({"run", file("part.mpf"), "-d", kFolder + "/clothoid.xml"});
        EXPECT_EQ(result.status, 3) << row.text;
        EXPECT_NE(result.err.find("K6241"), std::string::npos) << result.err;
        EXPECT_NE(result.err.find(row.says), std::string::npos) << result.err;
    }
    // The shipped program has no such kind, and says which it has.
    save("part.mpf", kHead + "CLOTHOID(0,0,0.05,20)\nM30\n");
    const ProcessResult plain = kadr({"run", file("part.mpf"), "-d", kFolder + "/clothoid.xml"});
    EXPECT_EQ(plain.status, 3);
    EXPECT_NE(plain.err.find("K6240"), std::string::npos) << plain.err;
    EXPECT_EQ(kadr({"dialect", "check", kFolder + "/clothoid.xml"}).status, 1);
    EXPECT_EQ(kadr_curves({"dialect", "check", kFolder + "/clothoid.xml"}).status, 0);
}

}  // namespace

}  // namespace curves_test
