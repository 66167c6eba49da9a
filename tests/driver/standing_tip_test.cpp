// A tip that the program holds while the tool turns, through the pole of the machine and past it:
// on every stock machine it stands at every tick, and no axis is faster than it may be.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/disk_files.h"
#include "base/units.h"
#include "machine/kinematics.h"
#include "machine/machine.h"
#include "tests/driver/scratch.h"

namespace standing_tip_test {

namespace {

using kadr::Axis;
using kadr::test::Row;
using kadr::test::rows_of;
namespace machine = kadr::machine;

constexpr double kMicrometre = 1e-3;

/// Great circles about a tip that stands: through the pole, and past it at a tenth of a degree and
/// at two; behind the ninth line every block only turns the tool.
const std::string kProgram = R"(N10 G17 G54 G90 G64
N20 T1 D1 M6
N30 S8000 M3
N40 TRAORI
N50 ORIWKS ORIVECT
N60 G0 X60 Y35 Z20 A3=0 B3=0 C3=1
N70 G1 Z8 F2000
N80 A3=0.5 B3=0.2 C3=1 F4000
N90 A3=-0.5 B3=-0.2 C3=1
N100 A3=0.5 B3=0.203 C3=1
N110 A3=-0.5 B3=-0.16 C3=1
N120 A3=0.1 B3=-0.45 C3=1
N130 A3=0 B3=0 C3=1
N140 A3=-0.2 B3=0.4 C3=1
N150 A3=0 B3=0 C3=1
N160 TRAFOOF
N170 M30
)";
constexpr double kFirstTurn = 8;
constexpr double kLastTurn = 15;

class StandingTip : public kadr::test::ScratchFolder {
  protected:
    /// Runs the program on a machine and looks at every tick. Returns how far the axis C turned in
    /// all while the tip stood, deg.
    double expect_standing(const std::string& path) {
        SCOPED_TRACE(path);
        kadr::Sources sources;
        kadr::DiagnosticList messages;
        const auto stock =
            machine::load_machine(path, {KADR_ROOT "/runtime/machines"}, sources, messages);
        EXPECT_TRUE(stock.has_value());
        if (!stock) return 0;
        save("turns.mpf", kProgram);
        const auto result = kadr({"run", file("turns.mpf"), "-d", "sinumerik", "-m", path,
                                  "--setpoints", file("turns.csv")});
        EXPECT_EQ(result.status, 0) << result.err;
        const std::vector<Row> rows = rows_of(kadr::read_file(file("turns.csv")).value_or(""));
        EXPECT_GT(rows.size(), 1000u);
        int standing = 0;
        double lowest = 1e9, highest = -1e9;
        for (const Row& row : rows) {
            if (row.at("iso") < kFirstTurn || row.at("iso") > kLastTurn) continue;
            ++standing;
            const machine::Pose pose = pose_of(*stock, row);
            const double off = std::hypot(pose.tip.x() - 60, pose.tip.y() - 35, pose.tip.z() - 8);
            EXPECT_LT(off, kMicrometre) << row.at("t");
            if (row.contains("C")) {
                lowest = std::min(lowest, row.at("C"));
                highest = std::max(highest, row.at("C"));
            }
            EXPECT_NEAR(row.at("tip_x"), 60, 1e-6);
            EXPECT_NEAR(row.at("tip_y"), 35, 1e-6);
            EXPECT_NEAR(row.at("tip_z"), 8, 1e-6);
        }
        EXPECT_GT(standing, 800);
        if (!rows.empty()) expect_limits(*stock, rows);
        return highest - lowest;
    }

  private:
    /// Tip and tool by the axes alone, with the length of tool 1.
    static machine::Pose pose_of(const machine::Machine& stock, const Row& row) {
        const machine::Chain& chain = stock.kinematics->chain;
        machine::ChainPosition position;
        position.linear = {row.at("X"), row.at("Y"), row.at("Z")};
        for (std::size_t k = 0; k < machine::kJoints; ++k) {
            if (!chain.has(k)) continue;
            const std::string name(kadr::kAxisNames[index(chain.joints[k].axis)]);
            position.rotary[static_cast<Eigen::Index>(k)] = kadr::rad_from_deg(row.at(name));
        }
        const double length = stock.find_tool(1)->length;
        return machine::forward(chain, position, machine::tip_of_length(chain, length));
    }

    /// From tick to tick no axis goes farther than at its velocity, and the way changes by no more
    /// than at its acceleration.
    static void expect_limits(const machine::Machine& stock, const std::vector<Row>& rows) {
        // Setpoints have six digits: over a tick of a millisecond and twice that is 1e-6/1e-6.
        constexpr double kDigits = 2e-6;
        for (const machine::MachineAxis& axis : stock.axes) {
            const double unit = axis.is_rotary ? kadr::deg_from_rad(1) : 1;
            double fastest = 0;
            double hardest = 0;
            for (std::size_t i = 2; i < rows.size(); ++i) {
                const double tick = rows[i].at("t") - rows[i - 1].at("t");
                if (std::abs(tick - stock.tick) > 1e-9) continue;
                const double now = rows[i].at(axis.name), before = rows[i - 1].at(axis.name),
                             first = rows[i - 2].at(axis.name);
                fastest = std::max(fastest, (std::abs(now - before) - kDigits) / tick);
                hardest = std::max(
                    hardest, (std::abs(now - 2 * before + first) - 2 * kDigits) / tick / tick);
            }
            EXPECT_LT(fastest, 1.001 * axis.velocity * unit) << axis.name;
            EXPECT_LT(hardest, 1.001 * axis.acceleration * unit) << axis.name;
        }
    }
};

TEST_F(StandingTip, StandsAtEveryTickOnEveryStockMachine) {
    for (const char* name :
         {"trunnion-ac", "trunnion-bc", "head-cb", "head-ab", "mixed-cb", "nutating", "six-axis"})
        expect_standing(name);
}

// With R2 kept on one side the first axis turns half a turn at the pole, where R2 stands.
TEST_F(StandingTip, StandsWhereTheFirstAxisTurnsAtThePole) {
    for (const std::string name : {"trunnion-bc", "head-cb", "six-axis"}) {
        std::string text = kadr::read_file(KADR_ROOT "/runtime/machines/" + name + ".xml").value();
        const std::string both = "<axis name=\"B\" limits=\"-110..110 deg\"";
        ASSERT_NE(text.find(both), std::string::npos);
        text.replace(text.find(both), both.size(), "<axis name=\"B\" limits=\"-1..110 deg\"");
        save(name + "-one-side.xml", text);
        EXPECT_GT(expect_standing(file(name + "-one-side.xml")), 170);
    }
}

/// An axis that turns back inside a block goes as far as its setpoints: the travel, and so the look
/// at the limits, found its last places only as well as sixteen samples did (0.04 mm).
TEST_F(StandingTip, TheTravelEndsWhereAnAxisTurnsBack) {
    save("swing.mpf",
         "G17 G90\nT1 D1 M6\nS1000 M3\nTRAORI\nG54\nORIAXES\nF3000\n"
         "G1 X0 Y0 Z100 A3=0.2 B3=-0.2 C3=1\n"
         "G1 X2.1127 Y-0.1474 A3=0.21342 B3=-0.77101 C3=1\n"
         "G1 X2.1853 Y-0.1156 A3=-0.41966 B3=-0.27181 C3=1\nTRAFOOF\nM30\n");
    const auto ran = kadr({"run", file("swing.mpf"), "-d", "sinumerik", "-m", "head-cb", "--tick",
                           "0.2ms", "--setpoints", file("swing.csv"), "--summary", "json"});
    ASSERT_EQ(ran.status, 0) << ran.err;
    const auto travel = nlohmann::json::parse(ran.out)["travel"];
    const auto rows = rows_of(kadr::read_file(file("swing.csv")).value());
    for (const char* axis : {"X", "Y", "Z"}) {
        const auto by = [&](const Row& a, const Row& b) { return a.at(axis) < b.at(axis); };
        const auto [least, most] = std::ranges::minmax_element(rows, by);
        EXPECT_NEAR(travel[axis]["min"].get<double>(), least->at(axis), kMicrometre) << axis;
        EXPECT_NEAR(travel[axis]["max"].get<double>(), most->at(axis), kMicrometre) << axis;
        EXPECT_LE(travel[axis]["min"].get<double>(), least->at(axis) + 1e-8) << axis;
        EXPECT_GE(travel[axis]["max"].get<double>(), most->at(axis) - 1e-8) << axis;
    }
}

}  // namespace

}  // namespace standing_tip_test
