// One program with orientations on machines of every class: the same commands, the same tip and the
// same directions of the tool, by axes that differ.
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/driver/scratch.h"

namespace {

using kadr::read_file;
using kadr::test::Row;
using kadr::test::rows_of;

using FiveAxis = kadr::test::ScratchFolder;

// Lines, an arc, a turn about the tip, along great circles and through the pole.
const std::string kProgram = R"(N10 G17 G54 G90 G64
N20 T1 D1 M6
N30 S8000 M3
N40 TRAORI
N50 ORIWKS ORIVECT
N60 G0 X0 Y0 Z60 C3=1
N70 G1 Z2 F2000
N80 X40 A3=0.5 C3=1
N90 Y30 A3=0.5 B3=0.5 C3=1
N100 A3=-0.5 B3=0.5 C3=1 F3000
N110 G2 X20 Y10 CR=40 B3=-0.3 C3=1 F2000
N120 G1 X30 B3=0.4 C3=1
N130 G0 Z80 C3=1
N140 TRAFOOF
N150 M30
)";

const std::vector<std::string> kMachines = {"trunnion-ac", "trunnion-bc", "head-cb", "head-ab",
                                            "mixed-cb",    "nutating",    "six-axis"};

struct Pose {
    double place[6];
};

/// Where tip and tool are at the end of each line.
std::map<int, Pose> ends_of(const std::vector<Row>& rows) {
    std::map<int, Pose> ends;
    for (const Row& row : rows) {
        ends[static_cast<int>(row.at("iso"))] = {{row.at("tip_x"), row.at("tip_y"), row.at("tip_z"),
                                                  row.at("tool_i"), row.at("tool_j"),
                                                  row.at("tool_k")}};
    }
    return ends;
}

TEST_F(FiveAxis, EveryMachineLeadsTheTipAlongTheSameWay) {
    save("part.mpf", kProgram);
    // Lines end between two ticks: at 2000 mm/min a tick is 0.03 to 0.07 mm of a corner.
    constexpr double kTickWay = 0.08;
    std::map<int, Pose> first;
    for (const std::string& machine : kMachines) {
        SCOPED_TRACE(machine);
        const auto result = kadr({"run", file("part.mpf"), "-d", "sinumerik", "-m", machine,
                                  "--setpoints", file("part.csv")});
        ASSERT_EQ(result.status, 0) << result.err;
        const std::vector<Row> rows = rows_of(read_file(file("part.csv")).value());
        ASSERT_GT(rows.size(), 1000u);
        const Row& last = rows.back();
        EXPECT_NEAR(last.at("tip_x"), 30, 1e-6);
        EXPECT_NEAR(last.at("tip_y"), 10, 1e-6);
        EXPECT_NEAR(last.at("tip_z"), 80, 1e-6);
        EXPECT_NEAR(last.at("tool_k"), 1, 1e-6);
        double turned = 0;
        for (const Row& row : rows) {
            const double length = std::hypot(row.at("tool_i"), row.at("tool_j"), row.at("tool_k"));
            EXPECT_NEAR(length, 1, 3e-9);
            if (row.at("iso") != 10) continue;
            // The tip stands while the tool turns, and the tool stays on its great circle.
            EXPECT_NEAR(row.at("tip_x"), 40, 1e-6);
            EXPECT_NEAR(row.at("tip_y"), 30, 1e-6);
            EXPECT_NEAR(row.at("tip_z"), 2, 1e-6);
            EXPECT_NEAR(row.at("tool_j") - 0.5 * row.at("tool_k"), 0, 1e-6);
            turned += 1;
        }
        EXPECT_GT(turned, 100);
        const auto ends = ends_of(rows);
        if (first.empty()) first = ends;
        ASSERT_EQ(ends.size(), first.size());
        for (const auto& [line, pose] : ends) {
            if (line < 8) continue;  // where the transformation begins, each tip is elsewhere
            for (std::size_t i = 0; i < 6; ++i)
                EXPECT_NEAR(pose.place[i], first.at(line).place[i], kTickWay) << line;
        }
    }
}

TEST_F(FiveAxis, CommandsDifferInRotaryAxesOnly) {
    save("part.mpf", kProgram);
    std::string first;
    for (const std::string& machine : kMachines) {
        const auto result = kadr({"run", file("part.mpf"), "-d", "sinumerik", "-m", machine,
                                  "--commands", file("part.jsonl")});
        ASSERT_EQ(result.status, 0) << result.err;
        std::istringstream lines(read_file(file("part.jsonl")).value());
        std::string text;
        for (std::string line; std::getline(lines, line);) {
            // Machines have tools of their own.
            if (line.find("tool_length") != std::string::npos) continue;
            // {"op":"line","to":{"X":40,"Y":0,"Z":2,"A":26.565,"C":90},"tool":[…
            const std::size_t rotary = line.find_first_of("ABC", line.find("\"Z\":"));
            const std::size_t tool = line.find("},\"tool\":");
            const bool is_motion = tool != std::string::npos && rotary != std::string::npos;
            text += is_motion ? line.substr(0, rotary) + line.substr(tool) : line;
            text += '\n';
        }
        if (first.empty()) first = text;
        EXPECT_EQ(text, first) << machine;
    }
    EXPECT_NE(first.find("\"tool\":[0.447213595,0,0.894427191]"), std::string::npos) << first;
}

}  // namespace
