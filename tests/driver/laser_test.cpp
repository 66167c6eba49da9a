// `kadr run` on machines with a laser: pulses and power among the setpoints.
#include <algorithm>
#include <map>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/disk_files.h"
#include "base/text.h"
#include "bench/laser_points.h"
#include "tests/driver/scratch.h"

namespace laser_test {

namespace {

using kadr::read_file;
using kadr::test::Row;
using kadr::test::rows_of;

using Laser = kadr::test::ScratchFolder;

const std::string kDots = std::string(KADR_ROOT) + "/examples/dots.kadr";

std::string machine_text() {
    return read_file(std::string(KADR_ROOT) + "/runtime/machines/laser.xml").value();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    EXPECT_NE(text.find(from), std::string::npos) << from;
    return text.replace(text.find(from), from.size(), to);
}

/// The same dots by both ways: as many pulses, and little more than half the time.
TEST_F(Laser, BlocksEndOnPulsesInLittleMoreThanHalfTheTime) {
    save("stop.xml", replaced(machine_text(), "<laser ", "<laser mode=\"stop\" "));
    const ProcessResult with = kadr({"run", kDots, "-d", "sinumerik", "-m", "laser", "--summary",
                                     "json", "--setpoints", file("dots.csv")});
    ASSERT_EQ(with.status, 0) << with.err;
    const ProcessResult stop =
        kadr({"run", kDots, "-d", "sinumerik", "-m", file("stop.xml"), "--summary", "json"});
    ASSERT_EQ(stop.status, 0) << stop.err;
    const nlohmann::json fast = nlohmann::json::parse(with.out);
    const nlohmann::json slow = nlohmann::json::parse(stop.out);
    EXPECT_GT(fast["pulses"], 1000);
    EXPECT_EQ(fast["pulses"], slow["pulses"]);
    const double saved = 1 - fast["time_s"].get<double>() / slow["time_s"].get<double>();
    // A point that is stopped at takes two intervals (0.125 mm from rest to rest: 41 ms), one that
    // is passed takes one.
    EXPECT_GT(saved, 0.4);
    EXPECT_LT(saved, 0.5);

    double pulses = 0;
    double last = 0;
    double gap = 0;
    for (Row& row : rows_of(read_file(file("dots.csv")).value())) {
        if (row["pulse"] == 0) continue;
        EXPECT_EQ(row["pulse"], 1);
        if (pulses > 0) gap = std::max(gap, row["t"] - last);
        EXPECT_GE(row["t"] - last, 0.023 - 1e-9);
        last = row["t"];
        pulses += 1;
    }
    EXPECT_EQ(pulses, fast["pulses"]);
    EXPECT_LT(gap, 2) << "a rapid between two rings";
}

/// A part of a file of the dissertation's Table 2, as the text of a program.
std::string program_of(const kadr::bench::LaserFile& table, int points) {
    kadr::bench::LaserPath path(table, {});
    std::string text = "G71 G90 G64 G17\nG0 X0 Y0\nS100 M3\nG1 F1800\n";
    for (int i = 0; i < points; ++i) {
        path.next();
        text +=
            "X" + std::to_string(path.point()[0]) + " Y" + std::to_string(path.point()[1]) + "\n";
    }
    return text + "M30\n";
}

/// Points that lie a tenth of a micrometre beside a line are burnt as those on it: 0.1 mm from rest
/// to rest take 36.5 ms, and the second pulse may come 48 ms behind the last one. What the corner
/// between them left of the ramps made it 73 ms.
TEST_F(Laser, StopsFromPointToPointWithTheWholeAcceleration) {
    save("stop.xml", replaced(machine_text(), "<laser ", "<laser mode=\"stop\" "));
    for (const char* aside : {"0", "0.0001"}) {
        std::string text = "G71 G90 G64 G17\nG0 X0 Y0\nS100 M3\nG1 F1800\n";
        for (int i = 1; i <= 100; ++i)
            text += "X" + std::to_string(i * 0.1) + " Y" + (i % 2 == 0 ? "0" : aside) + "\n";
        save("points.mpf", text + "M30\n");
        const ProcessResult ran = kadr({"run", file("points.mpf"), "-d", "sinumerik", "-m",
                                        file("stop.xml"), "--setpoints", file("points.csv")});
        ASSERT_EQ(ran.status, 0) << ran.err;
        double last = -1;
        int pulses = 0;
        for (Row& row : rows_of(read_file(file("points.csv")).value())) {
            if (row["pulse"] == 0) continue;
            if (pulses++ > 0) {
                EXPECT_NEAR(row["t"] - last, 0.048, 1e-9) << aside;
            }
            last = row["t"];
        }
        EXPECT_EQ(pulses, 100);
    }
}

/// The 14 files of the dissertation's Table 2, a tenth of each, from the text to the times: every
/// point is a stop of two intervals, which its laser counts in full. All of them: bench/README.md.
TEST_F(Laser, Table2FromTheTextToTheTimes) {
    constexpr int kPart = 10;
    const std::string stop = replaced(machine_text(), "<laser ", "<laser mode=\"stop\" ");
    save("stop.xml", replaced(stop, "tolerance=\"10 %\"", "tolerance=\"0 %\""));
    double all = 0;
    double paper = 0;
    for (const kadr::bench::LaserFile& table : kadr::bench::kTable2) {
        const int points = table.points / kPart;
        save("file.mpf", program_of(table, points));
        const ProcessResult ran = kadr({"run", file("file.mpf"), "-d", "sinumerik", "-m",
                                        file("stop.xml"), "--summary", "json"});
        ASSERT_EQ(ran.status, 0) << ran.err;
        const nlohmann::json summary = nlohmann::json::parse(ran.out);
        EXPECT_EQ(summary["pulses"], points);
        const double time = summary["time_s"].get<double>();
        EXPECT_NEAR(time, table.paper_old / kPart, 0.02 * table.paper_old / kPart) << table.number;
        all += time;
        paper += table.paper_old / kPart;
    }
    EXPECT_NEAR(all, paper, 0.01 * paper);
}

/// … and to the setpoints: the shortest file, whose pulses are two intervals apart, but for its
/// jumps of 2 mm.
TEST_F(Laser, AFileOfTable2FromTheTextToTheSetpoints) {
    constexpr int kPoints = 860;
    save("stop.xml", replaced(machine_text(), "<laser ", "<laser mode=\"stop\" "));
    const kadr::bench::LaserFile& table = kadr::bench::kTable2[7];
    save("file.mpf", program_of(table, kPoints));
    const ProcessResult ran = kadr({"run", file("file.mpf"), "-d", "sinumerik", "-m",
                                    file("stop.xml"), "--setpoints", file("file.csv")});
    ASSERT_EQ(ran.status, 0) << ran.err;
    double last = 0;
    int intervals = 0;
    std::map<int, int> gaps;
    for (Row& row : rows_of(read_file(file("file.csv")).value())) {
        if (row["pulse"] == 0) continue;
        const int gap = static_cast<int>(std::lround((row["t"] - last) / 0.025));
        intervals += gap;
        ++gaps[gap];
        last = row["t"];
    }
    EXPECT_GT(gaps[2], 820);
    const double paper = table.paper_old * kPoints / table.points;
    EXPECT_NEAR(intervals * 0.025, paper, 0.02 * paper);
}

TEST_F(Laser, TheSummaryCountsPulses) {
    const ProcessResult text = kadr({"run", kDots, "-d", "fanuc", "-m", "laser"});
    ASSERT_EQ(text.status, 0) << text.err;
    EXPECT_NE(text.out.find("\n  pulses "), std::string::npos) << text.out;
    const ProcessResult mill =
        kadr({"run", kDots, "-d", "fanuc", "-m", "mill", "--summary", "json"});
    ASSERT_EQ(mill.status, 0) << mill.err;
    EXPECT_FALSE(nlohmann::json::parse(mill.out).contains("pulses"));
}

/// Power follows the path speed: none at rapid, the least at rest, all of it at the feed that the
/// program says, whatever override acts on it.
TEST_F(Laser, PowerFollowsTheSpeed) {
    save("beam.xml", replaced(machine_text(), "<laser pulse=\"40 Hz\" tolerance=\"10 %\"/>",
                              "<laser power=\"500 W\" least_power=\"50 W\"/>"));
    save("cut.mpf", "G71 G90 G0 X10 Y0 S100 M3\nG1 X40 F1200\nOVR=50\nX70\nG0 X0\nM30\n");
    struct Case {
        std::string_view override;
        double most;  // mm/min
        double most_overridden;
    };
    for (const Case& c : {Case{"100", 1200, 600}, Case{"50", 600, 300}, Case{"150", 1800, 900}}) {
        const ProcessResult result =
            kadr({"run", file("cut.mpf"), "-d", "sinumerik", "-m", file("beam.xml"),
                  "--feed-override", std::string(c.override), "--setpoints", file("cut.csv")});
        ASSERT_EQ(result.status, 0) << result.err;
        std::map<int, int> at_feed;
        int part = 0;
        for (Row& row : rows_of(read_file(file("cut.csv")).value())) {
            EXPECT_FALSE(row.contains("pulse"));
            const int line = static_cast<int>(row["iso"]);
            if (line != 2 && line != 4) {
                EXPECT_EQ(row["power"], 0);
                continue;
            }
            EXPECT_NEAR(row["power"], 50 + 450 * std::min(1.0, row["feed"] / 1200), 1e-5);
            const double most = line == 2 ? c.most : c.most_overridden;
            at_feed[line] += row["feed"] > 0.999 * most ? 1 : 0;
            part += row["power"] < 100 ? 1 : 0;
        }
        EXPECT_GT(at_feed[2], 500) << c.override;
        EXPECT_GT(at_feed[4], 500) << c.override;
        EXPECT_GT(part, 20) << c.override;
    }
}

}  // namespace

}  // namespace laser_test
