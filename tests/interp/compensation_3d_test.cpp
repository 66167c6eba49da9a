// Compensation by the side of the cutter where the tool turns: S 5.3, motion.md §8.2.
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/interp/five_axis_bench.h"

namespace kadr::interp::compensation_3d_test {
namespace {

using path::Vec3;

std::vector<path::Command> motions(const std::string& text) {
    const Ran ran = read("sinumerik", "G500\nT1 D1 M6\nS1000 M3\n" + text + "\nM30", trunnion());
    EXPECT_EQ(alarms(ran), "") << text;
    std::vector<path::Command> found;
    for (const path::Command& command : ran.commands) {
        if (command.is_motion()) found.push_back(command);
    }
    return found;
}

Vec3 tip(const path::Command& command) {
    return {command.motion().to[0], command.motion().to[1], command.motion().to[2]};
}

TEST(Compensation3d, TheRhombusOfTheOracle) {
    std::ifstream file(KADR_ROOT "/tests/oracles/cutter_comp.json");
    const nlohmann::json all = nlohmann::json::parse(file)["cases"];
    const auto found = std::find_if(all.begin(), all.end(), [](const nlohmann::json& test) {
        return test["id"] == "cut3dc_diamond";
    });
    ASSERT_NE(found, all.end());
    const auto motion = motions(
        "G0 X30 Y0 Z30\nTRAORI\nG0 X30 Y0\nZ-3\nCUT3DC\nISD=1\n"
        "G0 X20 Y0 A3=-13 B3=-20 C3=23.85372088375 G42\n"
        "G1 X0 Y13 F1000\nA3=13 B3=-20 C3=23.85372088375\nX-20 Y0\n"
        "A3=13 B3=20 C3=23.85372088375\nX0 Y-13\nA3=-13 B3=20 C3=23.85372088375\nX20 Y0\n"
        "G40 X30 Y0 C3=1");
    ASSERT_EQ(motion.size(), 12u);
    const auto& blocks = (*found)["expect"]["blocks"];
    for (std::size_t i = 0; i < 4; ++i) {
        const auto place = [&](const char* name) {
            const auto& values = blocks[i][name];
            return Vec3(values[0].get<double>(), values[1].get<double>(), values[2].get<double>());
        };
        EXPECT_LT((tip(motion[3 + 2 * i]) - place("tip_at_start")).norm(), 1e-6) << i;
        EXPECT_LT((tip(motion[4 + 2 * i]) - place("tip_at_end")).norm(), 1e-6) << i;
    }
    EXPECT_LT((tip(motion.back()) - Vec3(30, 0, -3)).norm(), 1e-12);
    // On the arcs about corners the tool turns: they say what is touched.
    ASSERT_TRUE(motion[5].motion().contact);
    EXPECT_EQ(motion[5].motion().contact->contact.kind, path::ContactKind::Pivot);
    EXPECT_LT((motion[5].motion().contact->from - Vec3(0, 13, -3)).norm(), 1e-12);
    EXPECT_FALSE(motion[4].motion().contact);
}

/// With the tool upright it is what the plane has: the same way.
TEST(Compensation3d, AnUprightToolGoesAsInThePlane) {
    const std::string contour =
        "G1 X10 Y0 F500\nX40\nX40 Y20\nG3 X20 Y40 CR=20\nG1 X0\nY0\nG40 Y-20";
    for (const std::string side : {"G41", "G42"}) {
        SCOPED_TRACE(side);
        const auto plane = motions("G0 X-10 Y-10 Z0\nTRAORI\n" + side + " " + contour);
        const auto space = motions("G0 X-10 Y-10 Z0\nTRAORI\nCUT3DC\n" + side + " " + contour);
        ASSERT_EQ(space.size(), plane.size());
        for (std::size_t i = 0; i < plane.size(); ++i) {
            EXPECT_EQ(space[i].op(), plane[i].op()) << i;
            EXPECT_LT((tip(space[i]) - tip(plane[i])).norm(), 1e-8) << i;
        }
    }
}

TEST(Compensation3d, TheDepthMovesTheTipAlongTheTool) {
    const auto motion =
        motions("G0 X-10 Y-10 Z0\nTRAORI\nCUT3DC ISD=2\nG42 G1 X0 Y0 B3=1 C3=1 F500\nX40\nG40 X60");
    const double s = std::sqrt(0.5);
    // Along X and a tool that leans to +Y: aside is −Y and +Z.
    const Vec3 offset = Vec3(0, -5 * s, 5 * s) - 2 * Vec3(0, s, s);
    ASSERT_GE(motion.size(), 3u);
    EXPECT_LT((tip(motion[motion.size() - 2]) - (Vec3(40, 0, 0) + offset)).norm(), 1e-9);
}

TEST(Compensation3d, AnAllowanceAndItsSignCount) {
    const auto motion =
        motions("G0 X-10 Y-10 Z0\nTRAORI\nCUT3DC OFFN=-4\nG42 G1 X0 Y0 F500\nX40\nG40 X60");
    EXPECT_LT((tip(motion[motion.size() - 2]) - Vec3(40, -1, 0)).norm(), 1e-9);
}

/// In a corner that closes the tool touches both lines while it turns between them.
TEST(Compensation3d, InACornerThatClosesBothLinesAreTouched) {
    const auto motion = motions(
        "G0 X-10 Y-10 Z0\nTRAORI\nCUT3DC\nG41 G1 X0 Y0 B3=-0.3 C3=1 F500\nX40\nA3=0.3 C3=1\n"
        "X40 Y40\nG40 Y60 C3=1");
    bool has_corner = false;
    for (const path::Command& command : motion) {
        has_corner =
            has_corner || (command.motion().contact &&
                           command.motion().contact->contact.kind == path::ContactKind::Corner);
    }
    EXPECT_TRUE(has_corner);
    // Before and behind the turn the axis is five millimetres from both walls.
    for (std::size_t i = 0; i + 1 < motion.size(); ++i) {
        if (!motion[i].motion().contact) continue;
        const Vec3 point = tip(motion[i]);
        const Vec3 tool = motion[i].motion().direction;
        for (const Vec3& wall : {Vec3::UnitX().eval(), Vec3::UnitY().eval()}) {
            const Vec3 across = wall.cross(tool).normalized();
            EXPECT_NEAR(std::abs((point - Vec3(40, 0, 0)).dot(across)), 5, 1e-9);
        }
    }
}

TEST(Compensation3d, OutsideLinesMayBeExtended) {
    const auto motion =
        motions("G0 X-10 Y-10 Z0\nTRAORI\nCUT3DC G451\nG42 G1 X0 Y0 F500\nX40\nX40 Y40\nG40 Y60");
    ASSERT_GE(motion.size(), 4u);
    EXPECT_LT((tip(motion[motion.size() - 3]) - Vec3(45, -5, 0)).norm(), 1e-9);
}

/// ORID: first the turn about the corner, then the arc with the tool as it is behind it.
TEST(Compensation3d, TheToolMayTurnBeforeTheArc) {
    const auto motion = motions(
        "G0 X-10 Y-10 Z0\nTRAORI\nCUT3DC ORID\nG42 G1 X0 Y0 F500\nX40\nB3=-0.2 C3=1\nX40 Y40\n"
        "G40 Y60");
    std::size_t turn = 0;
    while (turn < motion.size() && !motion[turn].motion().contact) ++turn;
    ASSERT_LT(turn + 1, motion.size());
    EXPECT_EQ(motion[turn].motion().contact->contact.turn, 0);
    EXPECT_EQ(motion[turn + 1].op(), path::Op::Arc);
    EXPECT_LT((motion[turn + 1].motion().direction - motion[turn].motion().direction).norm(),
              1e-12);
}

struct Refused {
    std::string text;
    std::string code;
    std::string alarm;
};
class SpaceCompensationRefuses : public ::testing::TestWithParam<Refused> {};

TEST_P(SpaceCompensationRefuses, WithItsRow) {
    const Ran ran = read("sinumerik", "T1 D1 M6\nS1000 M3\n" + GetParam().text, trunnion());
    EXPECT_TRUE(ran.alarmed);
    ASSERT_EQ(ran.messages.size(), 1u) << GetParam().text;
    EXPECT_EQ(ran.messages[0].row->code, GetParam().code) << GetParam().text;
    EXPECT_EQ(alarms(ran), GetParam().alarm) << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(
    , SpaceCompensationRefuses,
    ::testing::Values(Refused{"TRAORI\nCUT3DC\nG1 G42 X10 F100\nX20\nZ-10", "K5680", "10759"},
                      Refused{"TRAORI\nCUT3DC\nG1 G41 X10 F100\nX40\nA3=-1 C3=5\nG3 X20 Y20 CR=20",
                              "K5681", "K5681"},
                      Refused{"TRAORI\nCUT3DC KONT\nG1 G42 X10 F100", "K5682", "K5682"},
                      Refused{"TRAORI\nCUT3DC\nG2 G42 X10 CR=8 F100", "K5272", "10753"},
                      Refused{"TRAORI\nCUT3DC\nG1 G41 X10 F100\nX40\nY2\nX0", "K5277", "10751"}));

}  // namespace
}  // namespace kadr::interp::compensation_3d_test
