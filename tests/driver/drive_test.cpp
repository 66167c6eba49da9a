// `kadr run --drive`: the drives of a turning program, as rows and as a drawing.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/driver/scratch.h"

namespace drive_test {

namespace {

namespace fs = std::filesystem;
using kadr::read_file;
using kadr::test::Row;
using kadr::test::rows_of;

using Drives = kadr::test::ScratchFolder;

const std::string kFace = std::string(KADR_ROOT) + "/examples/face.kadr";

/// The four facts of the paper's figure (reference motion §9.3), on every control.
TEST_F(Drives, TheFacingPassOfThePaper) {
    for (const char* dialect : {"sinumerik", "fanuc-lathe"}) {
        SCOPED_TRACE(dialect);
        const ProcessResult result =
            kadr({"run", kFace, "-d", dialect, "-m", "lathe", "--drive", file("face.csv")});
        ASSERT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.out, "");
        const std::vector<Row> rows = rows_of(read_file(file("face.csv")).value());
        ASSERT_GT(rows.size(), 31000u);
        double start = 0, peak = 0, peak_radius = 0;
        std::vector<double> crossings;
        bool has_cut = false;
        for (std::size_t i = 1; i < rows.size(); ++i) {
            Row row = rows[i];
            const double radius = row["tip_x"];
            has_cut = has_cut || row["load"] > 0;
            if (!has_cut) continue;
            // In proportion: (1 kN · R + 4 N·m + b·ω)/2 N·m/A, as long as the speed hardly changes.
            if (row["load"] > 0 && radius < 99 && radius > 50) {
                EXPECT_NEAR(row["current"], (radius + 4.5) / 2, 0.02 * row["current"]);
                EXPECT_NEAR(row["cutting_speed"], 200, 1);
            }
            if (row["load"] > 0 && std::abs(radius - 98) < 0.01) start = row["current"];
            if (row["load"] > 0 && radius < 40 && row["current"] > peak) {
                peak = row["current"];
                peak_radius = radius;
            }
            if (radius < 9 && radius > 0 && row["load"] > 0) {
                EXPECT_LT(row["current"], 3.57 + 10.61 / 2) << "behind the limit at " << radius;
            }
            if ((rows[i - 1].at("tip_x") > 0) != (radius > 0)) crossings.push_back(row["t"]);
        }
        EXPECT_NEAR(start, 51.2, 0.5);
        EXPECT_NEAR(peak, 39.4, 1.2);
        EXPECT_NEAR(peak_radius, 10.59, 0.11);
        ASSERT_EQ(crossings.size(), 2u);
        EXPECT_GT(crossings[1], crossings[0]);
        EXPECT_LT(crossings[1], crossings[0] + 0.1);
    }
}

TEST_F(Drives, TheDrawingNamesItsAxesAndWhatHappens) {
    const ProcessResult result =
        kadr({"run", kFace, "-d", "sinumerik", "-m", "lathe", "--drive", file("face.svg")});
    ASSERT_EQ(result.status, 0) << result.err;
    const std::string svg = read_file(file("face.svg")).value();
    EXPECT_TRUE(svg.starts_with("<svg ")) << svg.substr(0, 100);
    for (const char* words :
         {"Radius, mm", "Spindle speed, rpm", "Current of the main drive, A", "Path speed, mm/min",
          "Current over radius, A", "time, s", "the dynamic peak, 39.", "the speed limit, 3000 rpm",
          "passes the centre: the load ends", "again on its way back"}) {
        EXPECT_NE(svg.find(words), std::string::npos) << words;
    }
    EXPECT_LT(svg.size(), 500'000u);
}

/// A part that is turned all over: no facing to the centre, nothing to point at.
TEST_F(Drives, AnyTurningProgramCanBeRun) {
    const ProcessResult result =
        kadr({"run", std::string(KADR_ROOT) + "/examples/pin.kadr", "-d", "sinumerik", "-m",
              "lathe", "--drive", file("pin.svg"), "--summary", "text"});
    ASSERT_EQ(result.status, 0) << result.err;
    const std::string svg = read_file(file("pin.svg")).value();
    EXPECT_NE(svg.find("Radius, mm"), std::string::npos);
}

TEST_F(Drives, AMachineWithoutDrivesIsWrongUsage) {
    save("face.mpf", "G18 G95 G0 X20 Z5\nG1 X0 F0.1\nM30\n");
    const ProcessResult result =
        kadr({"run", file("face.mpf"), "-d", "sinumerik", "-m", "mill", "--drive", file("a.svg")});
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("K6021"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("the machine `mill` does not describe its drives"),
              std::string::npos);
    EXPECT_FALSE(fs::exists(file("a.svg")));
}

TEST_F(Drives, ADriveThatIsTooWeakIsSaid) {
    std::string lathe = read_file(std::string(KADR_ROOT) + "/runtime/machines/lathe.xml").value();
    const std::string limit = "max_current=\"100 A\"";
    ASSERT_NE(lathe.find(limit), std::string::npos);
    lathe.replace(lathe.find(limit), limit.size(), "max_current=\"2 A\"");
    save("weak.xml", lathe);
    const ProcessResult result = kadr(
        {"run", kFace, "-d", "sinumerik", "-m", file("weak.xml"), "--drive", file("weak.csv")});
    EXPECT_EQ(result.status, 0) << "a warning: the program itself is right";
    EXPECT_NE(result.err.find("K6108"), std::string::npos) << result.err;
    EXPECT_NE(read_file(file("weak.csv")).value().find("# not complete"), std::string::npos);
}

}  // namespace

}  // namespace drive_test
