// What the milling cycles of SINUMERIK leave behind, over many sets of parameters: nothing outside
// the shape is touched, everything inside is at its depth, no rapid goes into material, no cut is
// deeper than its step.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/common/process.h"
#include "tests/stdlib/cycle_run.h"
#include "tests/stdlib/stock.h"

namespace control_cycles_test {

namespace {

using namespace stdlib_test;
using nlohmann::json;
namespace fs = std::filesystem;

constexpr double kCell = 0.25;    // mm
constexpr double kMargin = 0.03;  // inside: scallops of the simulation, cells near the border
constexpr double kEdge = 0.004;   // outside: what rounding of the text may do
constexpr int kSets = 6;          // parameter sets a cycle

std::string number(double value) { return json(std::round(value * 1000) / 1000).dump(); }

/// The arguments of a call, `_` for one that is left out.
std::string call(const std::string& name, const std::vector<double>& arguments) {
    std::string text = name + '(';
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (i > 0) text += ',';
        if (!std::isnan(arguments[i])) text += number(arguments[i]);
    }
    return text + ')';
}
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The machine that has a cutter of this diameter as its tool 1.
std::string machine_text(double tool_d) {
    std::ifstream file(KADR_ROOT "/runtime/machines/mill.xml");
    std::string text{std::istreambuf_iterator<char>(file), {}};
    const std::size_t end = text.rfind("</machine>");
    EXPECT_NE(end, std::string::npos);
    text.insert(end, "<tool number=\"1\" name=\"cutter\" length=\"0 mm\" radius=\"" +
                         number(tool_d / 2) + " mm\"/>\n");
    return text;
}

/// The commands of these calls, from (0, 0, 40) on.
std::vector<json> commands_of_calls(const std::string& calls, double tool_d) {
    const fs::path folder =
        fs::temp_directory_path() / ("kadr-control-cycles-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    const std::string program = (folder / "part.mpf").string();
    const std::string machine = (folder / "mill.xml").string();
    EXPECT_TRUE(
        kadr::write_file_whole(program, "T1 D1 M6\nS3000 M3\nG0 X0 Y0 Z40\n" + calls + "\nM30\n"));
    EXPECT_TRUE(kadr::write_file_whole(machine, machine_text(tool_d)));
    const ProcessResult result = run_process(
        {KADR_BINARY, "run", program, "-d", "sinumerik", "-m", machine, "--commands", "-"});
    EXPECT_EQ(result.status, 0) << calls << '\n' << result.err;
    std::vector<json> commands;
    std::istringstream lines(result.out);
    for (std::string line; std::getline(lines, line);) {
        json command = json::parse(line, nullptr, false);
        if (command.is_object()) commands.push_back(std::move(command));
    }
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    return commands;
}

Stock plate() {
    return Stock(40, kCell, 0, [](double, double) { return -1.0; });
}

/// Straight down into material goes what the call says so of; at rapid nothing does.
void expect_no_rapid_cut(const Stock& stock) {
    for (const Fault& fault : stock.faults()) {
        if (fault.what == "rapid into material") ADD_FAILURE() << fault.command;
    }
    EXPECT_NEAR(stock.position().z, 40, 1e-9) << "the cycle ends at RTP";
}

TEST(ControlCycles, RectangularPocket) {
    Dice dice(11);
    for (int i = 0; i < kSets; ++i) {
        const double tool_d = dice.length(4, 12);
        const double l = dice.length(1.5 * tool_d, 60), w = dice.length(1.5 * tool_d, 60);
        const double corner = dice.length(tool_d / 2 + 0.1, std::min(l, w) / 2);
        const double floor = -dice.length(1, 9), step = dice.length(0.8, 4);
        const double allowance = dice.coin() ? 0 : 0.3, on_floor = dice.coin() ? 0 : 0.2;
        const double distance = dice.number(0, 3), angle = 4, r = 0.2 * tool_d;
        const auto pocket = [&](double kind, double entry, double pitch) {
            return call("POCKET3",
                        {40,   0,     1,     floor,     l,        w,     corner, 0,
                         0,    0,     step,  allowance, on_floor, 500,   100,    distance,
                         kind, kNone, kNone, kNone,     kNone,    entry, pitch});
        };
        const bool on_helix = dice.coin();
        const std::string rough = on_helix ? pocket(21, r, 0.5) : pocket(31, angle, kNone);
        SCOPED_TRACE(rough);
        Stock stock = plate();
        stock.cut(commands_of_calls(rough, tool_d), tool_d);
        expect_no_rapid_cut(stock);
        EXPECT_TRUE(stock.faults().empty()) << "straight down into material";
        EXPECT_LE(stock.deepest_cut(), step + 1e-3);
        EXPECT_NEAR(stock.lowest(), floor + on_floor, 1e-6);
        const Shape inset = rectangle(l - 2 * allowance, w - 2 * allowance,
                                      std::max(corner - allowance, tool_d / 2));
        EXPECT_EQ(stock.difference(inset, floor + on_floor, kMargin, kEdge), "");
        if (allowance > 0 || on_floor > 0) {
            stock.cut(commands_of_calls(pocket(12, kNone, kNone), tool_d), tool_d);
            expect_no_rapid_cut(stock);
        }
        EXPECT_EQ(stock.difference(rectangle(l, w, corner), floor, kMargin, kEdge), "");
        EXPECT_NEAR(stock.lowest(), floor, 1e-6);
    }
}

TEST(ControlCycles, RoundPocket) {
    Dice dice(12);
    for (int i = 0; i < kSets; ++i) {
        const double tool_d = dice.length(4, 12), r = dice.length(0.8 * tool_d, 30);
        const double floor = -dice.length(1, 9), step = dice.length(0.8, 4);
        const std::string whole =
            call("POCKET4", {40, 0, 1, floor, r, 0, 0, step, 0.2, 0.1, 500, 100,
                             static_cast<double>(dice.number(0, 3)), 21, kNone, kNone, kNone,
                             0.2 * tool_d, 0.4}) +
            '\n' +
            call("POCKET2", {40, 0, 1, floor, kNone, r, 0, 0, 100, 500, step, 3, 0.2, 2, 0, 0, 0}) +
            '\n' + call("POCKET4", {40, 0, 1, floor, r, 0, 0, step, 0.2, 0.1, 500, 100, 0, 12});
        SCOPED_TRACE(whole);
        Stock stock = plate();
        stock.cut(commands_of_calls(whole, tool_d), tool_d);
        expect_no_rapid_cut(stock);
        EXPECT_EQ(stock.difference(disc(2 * r), floor, kMargin, kEdge), "");
        EXPECT_NEAR(stock.lowest(), floor, 1e-6);
    }
}

TEST(ControlCycles, Slots) {
    Dice dice(13);
    for (int i = 0; i < kSets; ++i) {
        const double tool_d = dice.length(4, 12), w = dice.length(1.1 * tool_d, 1.9 * tool_d);
        const double l = dice.length(w + 2, 60), r = dice.length(5, 30);
        const double floor = -dice.length(1, 9), step = dice.length(0.8, 4);
        const double distance = dice.number(2, 3), allowance = dice.coin() ? 0 : 0.1;
        const std::string slot =
            call("SLOT1", {40,           0,         1,  floor, kNone, 1,   l,   w,
                           -(r + l / 2), 0,         r,  0,     0,     100, 500, step,
                           distance,     allowance, 30, 0,     0,     0,   0,   6});
        SCOPED_TRACE(slot);
        Stock stock = plate();
        stock.cut(commands_of_calls(slot, tool_d), tool_d);
        expect_no_rapid_cut(stock);
        EXPECT_EQ(stock.difference(stadium(l, w), floor, kMargin, kEdge), "");

        const double radius = dice.length(w, 28), start = dice.number(0, 350),
                     arc = dice.number(30, 200);
        const std::string bent =
            call("SLOT2", {40,    0, 1,   floor, kNone, 1,        arc,       w, 0, 0, radius,
                           start, 0, 100, 500,   step,  distance, allowance, 0, 0, 0, 0});
        SCOPED_TRACE(bent);
        Stock other = plate();
        other.cut(commands_of_calls(bent, tool_d), tool_d);
        expect_no_rapid_cut(other);
        EXPECT_EQ(other.difference(bent_stadium(2 * radius, start, arc, w), floor, kMargin, kEdge),
                  "");

        const std::string hole = call(
            "LONGHOLE", {40, 0, 1, floor, kNone, 1, l, -(r + l / 2), 0, r, 0, 0, 100, 500, step});
        SCOPED_TRACE(hole);
        Stock narrow = plate();
        narrow.cut(commands_of_calls(hole, tool_d), tool_d);
        expect_no_rapid_cut(narrow);
        EXPECT_EQ(narrow.difference(stadium(l, tool_d), floor, kMargin, kEdge), "");
    }
}

TEST(ControlCycles, FaceAndSpigot) {
    Dice dice(14);
    for (int i = 0; i < kSets; ++i) {
        const double tool_d = dice.length(6, 16), l = dice.length(20, 60), w = dice.length(20, 60);
        const double depth = dice.length(0.5, 3), kind = 10 * dice.number(1, 4) + 1;
        const std::string face =
            call("CYCLE71", {40, 0, 2, -depth, -l / 2, -w / 2, l, w, 0, 1, 0, 3, 0, 500, kind});
        SCOPED_TRACE(face);
        Stock blank(40, kCell, 0, rectangle(l, w, 0));
        blank.cut(commands_of_calls(face, tool_d), tool_d);
        expect_no_rapid_cut(blank);
        EXPECT_EQ(blank.difference(rectangle(l, w, 0), -depth, kMargin, kEdge), "");

        const double r = dice.length(5, 15), blank_d = 2 * r + 1.5 * tool_d;
        const std::string spigot =
            call("CYCLE77", {40, 0, 2, -depth, kNone, 2 * r, 0, 0, 1, 0.2, 0, 500, 100,
                             static_cast<double>(dice.number(0, 3)), 1, blank_d}) +
            '\n' +
            call("CYCLE77",
                 {40, 0, 2, -depth, kNone, 2 * r, 0, 0, 1, 0.2, 0, 500, 100, 0, 2, blank_d});
        SCOPED_TRACE(spigot);
        Stock bar(40, kCell, 0, disc(blank_d));
        bar.cut(commands_of_calls(spigot, tool_d), tool_d);
        expect_no_rapid_cut(bar);
        EXPECT_EQ(bar.spigot_difference(disc(2 * r), -depth, kMargin, kEdge), "");
    }
}

TEST(ControlCycles, RectangularSpigot) {
    Dice dice(16);
    for (int i = 0; i < kSets; ++i) {
        const double tool_d = dice.length(6, 16), l = dice.length(10, 35), w = dice.length(10, 35);
        const double corner = dice.coin() ? 0 : dice.length(0.5, std::min(l, w) / 2);
        const double depth = dice.length(0.5, 8), step = dice.length(0.5, 4);
        const double allowance = dice.coin() ? 0 : 0.3, on_floor = dice.coin() ? 0 : 0.2;
        const double turned = dice.number(0, 1) * 90;
        const auto around = [&](double kind, double distance) {
            return call("CYCLE76", {40,     0,   2,        -depth, kNone,      l,         w,
                                    corner, 0,   0,        turned, step,       allowance, on_floor,
                                    500,    100, distance, kind,   l + tool_d, w + tool_d});
        };
        const std::string rough = around(1, dice.number(0, 3));
        SCOPED_TRACE(rough);
        const bool is_across = turned > 0;
        const auto seen = [&](double more) {
            return is_across ? rectangle(w + 2 * more, l + 2 * more, corner + more)
                             : rectangle(l + 2 * more, w + 2 * more, corner + more);
        };
        Stock bar(40, kCell, 0, seen(tool_d / 2));
        bar.cut(commands_of_calls(rough, tool_d), tool_d);
        EXPECT_LE(bar.deepest_cut(), step + 1e-3);
        EXPECT_EQ(bar.spigot_difference(seen(allowance), -depth + on_floor, kMargin, kEdge), "");
        bar.cut(commands_of_calls(around(2, 0), tool_d), tool_d);
        expect_no_rapid_cut(bar);
        EXPECT_EQ(bar.spigot_difference(seen(0), -depth, kMargin, kEdge), "");
        EXPECT_NEAR(bar.lowest(), -depth, 1e-6);
    }
}

TEST(ControlCycles, MilledThread) {
    Dice dice(17);
    for (int i = 0; i < kSets; ++i) {
        const double d = dice.length(10, 40), pitch = dice.length(0.5, 3);
        const double core = d - 1.2 * pitch, depth = dice.length(3, 15);
        const bool is_outside = dice.coin();
        const double tool_d = is_outside ? dice.length(4, 16) : dice.length(0.4 * core, 0.8 * core);
        const std::string thread =
            call("CYCLE90", {40, 0, 2, -depth, kNone, d, core, pitch, 500,
                             static_cast<double>(dice.number(2, 3)), is_outside ? 1.0 : 0.0, 0, 0});
        SCOPED_TRACE(thread);
        // A spigot, or a plate with the hole of the core.
        const Shape before = disc(is_outside ? d : core);
        Stock stock(40, kCell, 0,
                    [&](double x, double y) { return is_outside ? before(x, y) : -before(x, y); });
        const std::vector<json> commands = commands_of_calls(thread, tool_d);
        stock.cut(commands, tool_d);
        expect_no_rapid_cut(stock);
        EXPECT_NEAR(stock.lowest(), -depth, 1e-6);
        // The core stays, or what lies outside the thread; the flank is cut to there.
        const double edge = (is_outside ? core : d) / 2, side = is_outside ? 1 : -1;
        for (double distance = kCell; distance < 2; distance += kCell) {
            EXPECT_EQ(stock.height_at(edge - side * (distance + 0.2), 0.1), 0) << distance;
        }
        EXPECT_LT(stock.height_at(edge + side * 0.3, 0.1), 0);
        // Whole turns with the pitch, between the way on and the way off.
        int turns = 0;
        double z = 0;
        for (const json& command : commands) {
            if (!command.contains("to")) continue;
            const double to = command["to"]["Z"];
            if (command["op"] == "arc" && to != z) {
                EXPECT_NEAR(z - to, pitch, 2e-6);
                ++turns;
            }
            z = to;
        }
        EXPECT_EQ(turns, static_cast<int>(std::ceil(depth / pitch - 0.001)));
    }
}

// Around a rectangle whose contour stands in a program of its own, from the middle of its right
// side.
TEST(ControlCycles, AlongAContour) {
    Dice dice(15);
    for (int i = 0; i < kSets; ++i) {
        const double tool_d = dice.length(6, 14), l = dice.length(15, 40), w = dice.length(15, 40);
        const double r = dice.length(0.5, std::min(l, w) / 2 - 1), depth = dice.length(1, 6);
        const double step = dice.length(0.8, 4), allowance = dice.coin() ? 0 : 0.3;
        const double on_floor = dice.coin() ? 0 : 0.2;
        const double onto = dice.number(1, 3), off = dice.number(1, 3);
        const bool is_steep = dice.coin();
        const double behind = 100 * dice.number(0, 2), size = 1.5 * tool_d;
        const auto along = [&](double kind) {
            std::string text = call(
                "CYCLE72", {kNone, 40, 0, 1, -depth, step, allowance, on_floor, 500, 100,
                            behind + kind, 42, onto + (is_steep ? 10 : 0), size, 800, off, size});
            return text.insert(text.find('(') + 1, "\"KONT\"");
        };
        const std::string x = number(l / 2), y = number(w / 2), a = number(l / 2 - r),
                          b = number(w / 2 - r), cr = " CR=" + number(r) + "\n";
        const std::string contour = "\nM30\n%_N_KONT_SPF\nG1 X" + x + " Y0\nY" + b + "\nG3 X" + a +
                                    " Y" + y + cr + "G1 X-" + a + "\nG3 X-" + x + " Y" + b + cr +
                                    "G1 Y-" + b + "\nG3 X-" + a + " Y-" + y + cr + "G1 X" + a +
                                    "\nG3 X" + x + " Y-" + b + cr + "G1 Y0\nM17";
        SCOPED_TRACE(along(1) + contour);
        const Shape blank = rectangle(l + tool_d, w + tool_d, 0);
        Stock bar(40, kCell, 0, blank);
        bar.cut(commands_of_calls(along(1) + contour, tool_d), tool_d);
        EXPECT_LE(bar.deepest_cut(), step + 1e-3);
        EXPECT_NEAR(bar.lowest(), -depth + on_floor, 1e-6);
        const Shape left = rectangle(l + 2 * allowance, w + 2 * allowance, r + allowance);
        EXPECT_EQ(bar.spigot_difference(left, -depth + on_floor, kMargin, kEdge), "");
        bar.cut(commands_of_calls(along(2) + contour, tool_d), tool_d);
        expect_no_rapid_cut(bar);
        EXPECT_EQ(bar.spigot_difference(rectangle(l, w, r), -depth, kMargin, kEdge), "");
        EXPECT_NEAR(bar.lowest(), -depth, 1e-6);
    }
}

}  // namespace

}  // namespace control_cycles_test
