// One program with orientations on machines of every class: the same commands, the same tip and the
// same directions of the tool, by axes that differ.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "tests/driver/scratch.h"

namespace five_axis_test {

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

// From point to point the ends are the same on every machine, and so are tip and tool there. The
// plot, the page and the comparison know that the tip is on no line.
TEST_F(FiveAxis, FromPointToPointEveryMachineComesToTheSameEnds) {
    const auto program = [](const std::string& moves) {
        return "G17 G54 G90\nT1 D1 M6\nS8000 M3\nTRAORI\nG54\nORIAXES\nG0 X0 Y0 Z60 C3=1\n" +
               moves +
               "\nG0 X40 Y10 Z30 A3=0.5 C3=1\nG4 F0.1\nG1 X-20 B3=0.4 C3=1 F3000\nG4 F0.1\n"
               "CP G1 X0 F2000\nTRAFOOF\nM30\n";
    };
    save("straight.mpf", program("PTP"));
    save("path.mpf", program("CP"));
    for (const std::string& machine : kMachines) {
        SCOPED_TRACE(machine);
        std::vector<std::map<int, Pose>> ends;
        std::vector<std::map<int, double>> turned;
        for (const char* name : {"straight.mpf", "path.mpf"}) {
            const auto result =
                kadr({"run", file(name), "-d", "sinumerik", "-m", machine, "--setpoints",
                      file("part.csv"), "--plot", file("part.svg"), "--page", file("part.html")});
            ASSERT_EQ(result.status, 0) << result.err;
            ends.push_back(ends_of(rows_of(read_file(file("part.csv")).value())));
        }
        // Behind each of both motions the axes stand.
        for (const int line : {10, 12}) {
            for (std::size_t i = 0; i < 6; ++i)
                EXPECT_NEAR(ends[0].at(line).place[i], ends[1].at(line).place[i], 1e-6) << line;
        }
        const auto same = kadr({"compare", file("straight.mpf"), file("straight.mpf"), "-d",
                                "sinumerik", "-m", machine});
        EXPECT_EQ(same.status, 0) << same.out << same.err;
        const auto other = kadr(
            {"compare", file("straight.mpf"), file("path.mpf"), "-d", "sinumerik", "-m", machine});
        EXPECT_NE(other.status, 0) << other.out;
    }
}

/// A line of 50 mm on which A turns by atan 0.5 beside it, under what `words` say of feeds.
std::string tilting_line(const std::string& words) {
    return "G17 G54 G90\nT1 D1 M6\nS8000 M3\nG0 X0 Y0 Z50 A0 C90\nTRAORI\nG54\nORIWKS ORIVECT\n"
           "G0 X0 Y0 Z0 C3=1\n" +
           words + "\nG1 X50 A3=0.5 C3=1 F1000\nTRAFOOF\nM30\n";
}

// F is the speed of the tip, of tip and rotary axes together where FGROUP names them (SINUMERIK
// reference 3.2 and 8.4), and FL holds back an axis that follows.
TEST_F(FiveAxis, FeedOfTipAndRotaryAxes) {
    constexpr double kFeed = 1000.0 / 60;  // mm/s
    struct Case {
        const char* words;
        double weight;  // mm, of A's way in radians
        double turns;   // deg/s, greatest of A; 0: as the feed has it
    };
    for (const Case& row :
         {Case{"FGROUP(X,Y,Z)", 0, 0}, Case{"FGROUP(X,Y,Z,A,C) FGREF[A]=100", 100, 0},
          Case{"FL[A]=100", 0, 100.0 / 60}}) {
        SCOPED_TRACE(row.words);
        save("part.mpf", tilting_line(row.words));
        const auto result = kadr({"run", file("part.mpf"), "-d", "sinumerik", "-m", "trunnion-ac",
                                  "--setpoints", file("part.csv")});
        ASSERT_EQ(result.status, 0) << result.err;
        const std::vector<Row> rows = rows_of(read_file(file("part.csv")).value());
        double fastest = 0;
        double turning = 0;
        for (std::size_t i = 1; i < rows.size(); ++i) {
            const Row& now = rows[i];
            const Row& before = rows[i - 1];
            if (now.at("iso") != 10 || before.at("iso") != 10) continue;
            const double time = now.at("t") - before.at("t");
            const auto rate = [&](const char* name) {
                return (now.at(name) - before.at(name)) / time;
            };
            const double tip = std::hypot(rate("tip_x"), rate("tip_y"), rate("tip_z"));
            const double turn = rate("A");
            turning = std::max(turning, std::abs(turn));
            fastest =
                std::max(fastest, std::hypot(tip, row.weight * turn * std::numbers::pi / 180));
        }
        // Places are written to a millionth of a millimetre, a tick is a thousandth of a second.
        constexpr double kRounding = 3e-3;
        if (row.turns > 0) EXPECT_NEAR(turning, row.turns, kRounding);
        else EXPECT_NEAR(fastest, kFeed, kRounding);
    }
}

/// How long every line of the text lasts, s, by ticks of a thousandth.
std::map<int, double> times_of_lines(const std::vector<Row>& rows) {
    std::map<int, double> times;
    for (const Row& row : rows) times[static_cast<int>(row.at("iso"))] += 0.001;
    return times;
}

// Under the transformation a block lasts as long as the axes of FGROUP need at F together, and no
// shorter than FL lets an axis come along (SINUMERIK reference 2.3, 8.4). A turns by atan 0.5 on
// 50 mm, and by as much back while the tip stands.
TEST_F(FiveAxis, BlocksLastAsTheFeedAxesSay) {
    const double turn = std::atan(0.5);  // rad
    const double degrees = turn * 180 / std::numbers::pi;
    constexpr double kFeed = 1000.0 / 60;  // mm/s or deg/s
    struct Case {
        const char* words;
        double moved;   // s, tip and tool
        double turned;  // s, the tool alone
    };
    for (const Case& row :
         {Case{"FGROUP()", 50 / kFeed, degrees / kFeed},
          {"FGROUP(X,Y,Z,A) FGREF[A]=200", std::hypot(50, 200 * turn) / kFeed, 200 * turn / kFeed},
          {"FGROUP(A) FGREF[A]=200", 200 * turn / kFeed, 200 * turn / kFeed},
          {"FGROUP(A)", degrees / kFeed, degrees / kFeed},
          {"FGROUP(X) FGREF[A]=200", 50 / kFeed, degrees / kFeed},
          // Slower than F, and faster: which is no limit then.
          {"FL[A]=300", degrees / 5, degrees / 5},
          {"FL[A]=1100", 50 / kFeed, degrees / kFeed},
          // An axis that does not move, and one that makes up F, have nothing to limit.
          {"FL[C]=1 FL[X]=1", 50 / kFeed, degrees / kFeed}}) {
        SCOPED_TRACE(row.words);
        save("part.mpf",
             "G17 G54 G90 G60\nT1 D1 M6\nS8000 M3\nG0 X0 Y0 Z50 A0 C90\nTRAORI\nG54\n"
             "ORIWKS ORIVECT\nG0 X0 Y0 Z0 C3=1\n" +
                 std::string(row.words) + "\nG1 X50 A3=0.5 C3=1 F1000\nA3=0 C3=1\nTRAFOOF\nM30\n");
        const auto result = kadr({"run", file("part.mpf"), "-d", "sinumerik", "-m", "trunnion-ac",
                                  "--setpoints", file("part.csv")});
        ASSERT_EQ(result.status, 0) << result.err;
        const auto times = times_of_lines(rows_of(read_file(file("part.csv")).value()));
        // Ramps from rest and to it are beside the time of F.
        constexpr double kRamps = 0.12;
        EXPECT_GE(times.at(10), row.moved - 0.002);
        EXPECT_LE(times.at(10), row.moved + kRamps);
        EXPECT_GE(times.at(11), row.turned - 0.002);
        EXPECT_LE(times.at(11), row.turned + kRamps);
    }
}

// The example of the manual for FGROUP: the times of its blocks by $AC_TIME, in mm and in inches,
// where a degree is a millimetre, and an inch by FGREF. (SINUMERIK programming manual, path feed.)
TEST_F(FiveAxis, TimesOfTheManualForFeedGroups) {
    save("group.mpf",
         "G17 G60\nT1 D1 M6\nS100 M3\nG0 X-300 A0\nFGROUP(X,A)\nG91 G1 G710 F100\n"
         "X10\nX10 A10\nA10\nX0.001 A10\nG700 F100\nX10\nX10 A10\n"
         "FGREF[A]=360/(2*$PI)\nX0.001 A10\nFGREF[A]=180/$PI/25.4\nA10\nX0.0001 A10\nM30\n");
    const auto result = kadr({"run", file("group.mpf"), "-d", "sinumerik", "-m", "rotary-a",
                              "--setpoints", file("part.csv")});
    ASSERT_EQ(result.status, 0) << result.err;
    const auto times = times_of_lines(rows_of(read_file(file("part.csv")).value()));
    for (const auto& [line, time] : {std::pair(7, 6.0),
                                     {8, 6 * std::sqrt(2)},
                                     {9, 6.0},
                                     {10, 6.0},
                                     {12, 6.0},
                                     {13, 6.0},
                                     {15, 6.0},
                                     {17, 6.0},
                                     {18, 6 / 25.4}})
        EXPECT_NEAR(times.at(line), time, 0.1) << line;
}

/// At the pole R1 turns first, at rapid while the tip stands: the course of the feed is along the
/// path alone. Counted along both it fell below zero, and was halved without an end.
TEST_F(FiveAxis, AFeedThatChangesBeginsAtThePole) {
    for (const std::string& machine : kMachines) {
        for (const std::string feed : {"FLIN\nG1 Y-8\nX20 A3=0.48 B3=0.3 C3=1.09 F500\n",
                                       "FCUB\nG1 Y-8\nX20 A3=0.48 B3=0.3 C3=1.09 F500\n",
                                       "G1 X20 A3=0.48 C3=1.09 F=FPO(500,10,10)\n"}) {
            save("f.mpf", "G17 G90 G54\nT1 D1 M6\nS6000 M3\nTRAORI\nG54\nF4000\nG0 X0 Y0 Z10\n" +
                              feed + "M30\n");
            const auto ran = kadr({"run", file("f.mpf"), "-d", "sinumerik", "-m", machine});
            EXPECT_EQ(ran.status, 0) << machine << '\n' << feed << ran.err;
        }
    }
}

// F is the speed of all axes of a block, of which a degree is a millimetre, or an inch under G20:
// of the tip alone under tool centre point control. Rotary axes alone turn by degrees a minute.
// (FANUC operator's manual, linear interpolation: X20. B40. F300. is 0.14907 min; F reference 3.2.)
TEST_F(FiveAxis, FeedOfAllAxes) {
    save("all.nc",
         "%\nO1\nG17 G21 G94 G61\nT1 M6\nS100 M3\nG90 G0 X-100. Y0. A0.\nG91 G1 X20. A40. F300.\n"
         "X5.\nA30.\nX0. A30.\nG93 X5. A30. F10.\nM30\n%\n");
    save("inch.nc",
         "%\nO1\nG17 G20 G94 G61\nT1 M6\nS100 M3\nG90 G0 X-5. Y0. A0.\nG91 G1 X2. A40. F300.\n"
         "A30.\nX1.\nM30\n%\n");
    const auto times_of = [&](const char* name) {
        const auto result = kadr(
            {"run", file(name), "-d", "fanuc", "-m", "rotary-a", "--setpoints", file("part.csv")});
        EXPECT_EQ(result.status, 0) << result.err;
        return times_of_lines(rows_of(read_file(file("part.csv")).value()));
    };
    const auto metric = times_of("all.nc");
    for (const auto& [line, time] :
         {std::pair(7, std::hypot(20, 40) / 5), {8, 1.0}, {9, 6.0}, {10, 6.0}, {11, 6.0}})
        EXPECT_NEAR(metric.at(line), time, 0.1) << line;
    const auto inches = times_of("inch.nc");
    for (const auto& [line, time] : {std::pair(7, std::hypot(2, 40) / 5), {8, 6.0}, {9, 0.2}})
        EXPECT_NEAR(inches.at(line), time, 0.1) << line;
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

/// What the motions with a tool's direction say, from `"op"` to the direction; without F, which one
/// control says again.
std::vector<std::string> tool_motions(const std::string& commands) {
    std::vector<std::string> found;
    std::istringstream lines(commands);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t tool = line.find("\"tool\":[");
        const std::size_t index = line.find("\"to\":");
        if (tool == std::string::npos || index == std::string::npos) continue;
        found.push_back(line.substr(index, line.find(']', tool) + 1 - index));
    }
    return found;
}

TEST_F(FiveAxis, ThreeLanguagesSayTheSameWays) {
    const std::string start = "N10 G17 G54 G90\nN20 T1 ";
    save("part.mpf", start + R"(D1 M6
S8000 M3
TRAORI
ORIVECT
G0 X0 Y0 Z60 C3=1
G1 Z2 F2000
X40 A3=0.5 C3=1
Y30 A3=0.5 B3=0.5 C3=1
A3=-0.5 B3=0.5 C3=1 F3000
X30 B3=0.4 C3=1
ORIAXES
Y0 A3=0.3 C3=1
G0 Z80 C3=1
TRAFOOF
M30
)");
    save("part.nc", "%\nO0001\n" + start + R"(M06
S8000 M03
G43.5 H01 P1
G00 X0. Y0. Z60. K1.
G01 Z2. F2000.
X40. I0.5 K1.
Y30. I0.5 J0.5 K1.
I-0.5 J0.5 K1. F3000.
X30. J0.4 K1.
G43.5 H01 P0
Y0. I0.3 K1.
G00 Z80. K1.
G49
M30
%
)");
    for (const std::string& machine : kMachines) {
        SCOPED_TRACE(machine);
        std::vector<std::vector<std::string>> ways;
        for (const auto& [text, control] :
             {std::pair("part.mpf", "sinumerik"), std::pair("part.mpf", "axioma"),
              std::pair("part.nc", "fanuc")}) {
            const auto result = kadr({"run", file(text), "-d", control, "-m", machine, "--commands",
                                      file("part.jsonl")});
            ASSERT_EQ(result.status, 0) << result.err;
            ways.push_back(tool_motions(read_file(file("part.jsonl")).value()));
        }
        ASSERT_EQ(ways[0].size(), 8u);
        EXPECT_EQ(ways[1], ways[0]);
        // The length acts in a motion of its own there.
        ASSERT_EQ(ways[2].size(), ways[0].size() + 1);
        ways[2].erase(ways[2].begin());
        EXPECT_EQ(ways[2], ways[0]);
    }
}

/// How the tool stands at the ends of the motions.
std::vector<std::string> tools_in(const std::string& commands) {
    std::vector<std::string> tools;
    for (const std::string& way : tool_motions(commands))
        tools.push_back(way.substr(way.find("\"tool\"")));
    return tools;
}

/// Lines, an arc and a turn about the tip on which the tool goes along cones, leans on a surface
/// and follows a second point.
const std::string kCourses = R"(N10 G17 G54 G90 G64
N20 T1 D1 M6
N30 S8000 M3
N40 TRAORI
N50 G0 X0 Y0 Z2 A3=0.3 C3=1
N60 ORICONCW
N70 G1 X40 A3=-0.3 C3=1 C6=1 F2000
N80 ORICONIO
N90 Y30 A3=0.2 B3=0.5 C3=1 A7=-0.1 B7=0.3 C7=1
N100 ORIPATH LEAD=12 TILT=5
N110 X0
N120 G3 Y10 CR=10 B5=0.2 C5=1
N130 ORICURVE
N140 G1 X30 XH=40 YH=10 ZH=100
N150 ORIAXES
N160 G0 Z80 C3=1
N170 TRAFOOF
N180 M30
)";

TEST_F(FiveAxis, CoursesAreTheSameOnEveryMachine) {
    save("part.mpf", kCourses);
    std::vector<std::string> first;
    for (const std::string& machine : kMachines) {
        SCOPED_TRACE(machine);
        const auto result =
            kadr({"run", file("part.mpf"), "-d", "sinumerik", "-m", machine, "--commands",
                  file("part.jsonl"), "--setpoints", file("part.csv")});
        ASSERT_EQ(result.status, 0) << result.err;
        const auto tools = tools_in(read_file(file("part.jsonl")).value());
        if (first.empty()) first = tools;
        EXPECT_EQ(tools, first);
        for (const Row& row : rows_of(read_file(file("part.csv")).value())) {
            // Line 7: about Z by half a turn, always as far from it.
            if (row.at("iso") != 7) continue;
            EXPECT_NEAR(row.at("tool_k"), 1 / std::hypot(0.3, 1), 1e-6);
            EXPECT_NEAR(row.at("tip_y"), 0, 1e-6);
            const double around = std::numbers::pi * row.at("tip_x") / 40;
            EXPECT_NEAR(row.at("tool_i"), 0.3 / std::hypot(0.3, 1) * std::cos(around), 1e-6);
        }
    }
}

/// The parabola y = x²/40 as a polynomial and as a B-spline of the second degree, on which the tool
/// turns about Y by atan 0.5; behind it two splines through points.
std::string splines(const std::string& parabola) {
    return "G17 G54 G90 G64\nT1 D1 M6\nS8000 M3\nTRAORI\nG54\nORIWKS ORIVECT\nG0 X0 Y0 Z20 C3=1\n" +
           parabola +
           "ASPLINE\nX30 Y15 A3=0.3 C3=1\nX40 Y10 Z25 A3=0.2 B3=0.3 C3=1\nX50 Y15 C3=1\n"
           "CSPLINE\nX60 Y10 A3=-0.2 B3=0.1 C3=1\nX70 Y12 Z20 A3=-0.2 B3=-0.3 C3=1\n"
           "G1 X80\nTRAFOOF\nM30\n";
}

TEST_F(FiveAxis, ToolsTurnInProportionAlongSplinesOnEveryMachine) {
    // The line of the block in which the parabola ends.
    const std::pair<std::string, int> ways[] = {
        {"G1 F1500\nPOLY PO[X]=(20) PO[Y]=(10,10) A3=0.5 C3=1\n", 9},
        {"G1 F1500\nBSPLINE SD=2 X10 A3=-0.3 B3=1 C3=1\nX20 Y10 A3=0.5 C3=1\n", 10}};
    const auto length_to = [](double x) {  // of y = x²/40 from 0
        return 10 * (std::asinh(x / 20) + x / 20 * std::hypot(1, x / 20));
    };
    for (const auto& [parabola, line] : ways) {
        save("part.mpf", splines(parabola));
        std::vector<std::string> first;
        for (const std::string& machine : kMachines) {
            SCOPED_TRACE(machine + parabola);
            const auto result =
                kadr({"run", file("part.mpf"), "-d", "sinumerik", "-m", machine, "--commands",
                      file("part.jsonl"), "--setpoints", file("part.csv")});
            ASSERT_EQ(result.status, 0) << result.err;
            const auto tools = tools_in(read_file(file("part.jsonl")).value());
            if (first.empty()) first = tools;
            EXPECT_EQ(tools, first);
            int count = 0;
            for (const Row& row : rows_of(read_file(file("part.csv")).value())) {
                if (row.at("iso") != line) continue;
                ++count;
                const double x = row.at("tip_x");
                EXPECT_NEAR(row.at("tip_y"), x * x / 40, 1e-6);
                EXPECT_NEAR(row.at("tip_z"), 20, 1e-6);
                const double turn = std::atan(0.5) * length_to(x) / length_to(20);
                EXPECT_NEAR(row.at("tool_i"), std::sin(turn), 1e-6);
                EXPECT_NEAR(row.at("tool_j"), 0, 1e-6);
            }
            EXPECT_GT(count, 400);
        }
    }
}

}  // namespace

}  // namespace five_axis_test
