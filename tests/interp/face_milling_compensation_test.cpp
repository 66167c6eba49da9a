// Compensation by the end of the cutter on a surface: S 5.3 CUT3DF, motion.md §8.3.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "interp/mill_shape.h"
#include "tests/interp/five_axis_bench.h"
#include "tests/interp/program_bench.h"

namespace kadr::interp::face_milling_compensation_test {
namespace {

/// A tool by its data; radius 5, a rounding of 2, a side that leans by 10 degrees.
std::string tool_of(int type) {
    return "$TC_DP1[1,1]=" + std::to_string(type) +
           "\n$TC_DP3[1,1]=50\n$TC_DP6[1,1]=5\n$TC_DP7[1,1]=2\n$TC_DP11[1,1]=10\n"
           "G500\nT1 D1 M6\nS1000 M3\n";
}

std::vector<path::Command> milled(int type, const std::string& text) {
    const Ran ran = run_program("sinumerik", tool_of(type) + text + "\nM30", trunnion());
    EXPECT_EQ(alarms(ran), "") << text;
    return motions(ran);
}

Vec3 tip(const path::Command& command) {
    return {command.motion().to[0], command.motion().to[1], command.motion().to[2]};
}

/// Of the tip from the contact, by motion.md §8.3.
Vec3 aside(double radius, double edge, const Vec3& normal, const Vec3& tool) {
    const Vec3 across = normal - normal.dot(tool) * tool;
    return edge * normal + (radius - edge) * across.normalized() - edge * tool;
}

/// Rounding of each type of tool: a ball, one that is said, none.
TEST(SurfaceCompensation, EachShapeTouchesWithItsEdge) {
    struct Row {
        int type;
        double edge;
    };
    const Vec3 normal = Vec3(-0.2, 0.1, 1).normalized();
    const Vec3 tool = Vec3(0.3, 0.4, 1).normalized();
    for (const Row row : {Row{110, 5}, Row{111, 5}, Row{120, 0}, Row{121, 2}, Row{130, 0},
                          Row{131, 2}, Row{140, 0}, Row{155, 0}, Row{156, 2}, Row{157, 5}}) {
        SCOPED_TRACE(row.type);
        const auto motion = milled(row.type,
                                   "G0 X-10 Y-10 Z20\nTRAORI\nCUT3DF\n"
                                   "G41 G1 X0 Y0 Z0 A3=0.3 B3=0.4 C3=1 F500\n"
                                   "X40 Z8 A4=-0.2 B4=0.1 C4=1\nG40 X60 Z30");
        ASSERT_EQ(motion.size(), 4u);
        const Vec3 off = aside(5, row.edge, normal, tool);
        EXPECT_LT((tip(motion[1]) - off).norm(), 1e-9);
        EXPECT_LT((tip(motion[2]) - Vec3(40, 0, 8) - off).norm(), 1e-9);
        EXPECT_LT((tip(motion[3]) - Vec3(60, 0, 30)).norm(), 1e-12);
        EXPECT_FALSE(motion[2].motion().contact) << "a shifted line is a line";
    }
}

TEST(SurfaceCompensation, BothSideWordsAreTheSame) {
    const std::string text = "X40 Z8 A4=-0.2 C4=1 A5=0.1 C5=1\nG40 X60 Z30";
    const std::string head = "G0 X-10 Y-10 Z20\nTRAORI\nCUT3DF\n";
    const auto left = milled(110, head + "G41 G1 X0 Y0 Z0 F500\n" + text);
    const auto right = milled(110, head + "G42 G1 X0 Y0 Z0 F500\n" + text);
    const auto changed = milled(110, head + "G41 G1 X0 Y0 Z0 F500\nG42 " + text);
    ASSERT_EQ(left.size(), right.size());
    ASSERT_EQ(left.size(), changed.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
        EXPECT_LT((tip(left[i]) - tip(right[i])).norm(), 1e-12);
        EXPECT_LT((tip(left[i]) - tip(changed[i])).norm(), 1e-12);
    }
}

/// A normal that turns along the block: the motion says what is touched and how it turns.
TEST(SurfaceCompensation, ANormalMayTurnAlongTheBlock) {
    const auto motion = milled(121,
                               "G0 X-10 Y-10 Z20\nTRAORI\nCUT3DF\n"
                               "G41 G1 X0 Y0 Z0 B3=0.5 C3=1 F500\n"
                               "X40 A4=-0.2 C4=1 A5=0.2 C5=1\nX60 A5=0.4 C5=1\nG40 X80 Z30");
    ASSERT_EQ(motion.size(), 5u);
    const Vec3 tool = Vec3(0, 0.5, 1).normalized();
    const Vec3 normals[] = {Vec3(-0.2, 0, 1).normalized(), Vec3(0.2, 0, 1).normalized(),
                            Vec3(0.4, 0, 1).normalized()};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 point(i == 0 ? 0 : i == 1 ? 40 : 60, 0, 0);
        EXPECT_LT((tip(motion[1 + i]) - point - aside(5, 2, normals[i], tool)).norm(), 1e-9) << i;
    }
    for (const std::size_t i : {2u, 3u}) {
        ASSERT_TRUE(motion[i].motion().contact);
        const path::Contact& contact = motion[i].motion().contact->contact;
        EXPECT_EQ(contact.kind, path::ContactKind::Face);
        EXPECT_LT((contact.guide - normals[i - 2]).norm(), 1e-12);
        EXPECT_LT((path::guide_at(contact, 1) - normals[i - 1]).norm(), 1e-12);
    }
}

TEST(SurfaceCompensation, NothingSaidIsUpwardsAndFramesTurnIt) {
    const auto up = milled(110,
                           "G0 X-10 Y-10 Z20\nTRAORI\nCUT3DF\nG41 G1 X0 Y0 Z0 A3=1 C3=1 F500\n"
                           "X40\nG40 X60 Z30");
    const double s = std::sqrt(0.5);
    EXPECT_LT((tip(up[2]) - Vec3(40 - 5 * s, 0, 5 - 5 * s)).norm(), 1e-9);
    const auto turned = milled(110,
                               "G0 X-10 Y-10 Z20\nTRAORI\nROT Y45\nCUT3DF\n"
                               "G41 G1 X0 Y0 Z0 C3=1 F500\nX40\nG40 X60 Z30");
    // Tool and normal are Z of the frame: the tip is where the ball touches.
    EXPECT_LT((tip(turned[2]) - 40 * Vec3(s, 0, -s)).norm(), 1e-9);
}

TEST(SurfaceCompensation, TheAllowanceLiesAlongTheNormal) {
    const std::string text =
        "G0 X-10 Y0 Z5\nTRAORI\nCUT3DF\nG41 G1 X0 Y0 Z0 B3=0.5 C3=1 F500\n"
        "X40 A4=-0.2 C4=1\nG40 X60 Z30";
    const auto none = milled(121, text);
    const auto some = milled(121, "OFFN=0.3\n" + text);
    EXPECT_LT((tip(some[1]) - tip(none[1]) - 0.3 * Vec3(-0.2, 0, 1).normalized()).norm(), 1e-9);
}

/// A face that lies square on the surface touches with its middle.
TEST(SurfaceCompensation, AFaceThatLiesSquareTouchesWithItsMiddle) {
    const auto motion = milled(120,
                               "G0 X-10 Y-10 Z20\nTRAORI\nCUT3DF\nG41 G1 X0 Y0 Z0 F500\nX40\n"
                               "A3=0.5 C3=1\nX60\nG40 X80 Z30");
    ASSERT_GT(motion.size(), 5u);
    EXPECT_LT((tip(motion[2]) - Vec3(40, 0, 0)).norm(), 1e-12);
    // It leans towards +X: its front edge touches, and the tip is behind it. Before it turns it
    // slides to where that edge is at the contact.
    EXPECT_LT((tip(motion[3]) - Vec3(35, 0, 0)).norm(), 1e-5);
    const Vec3 off = aside(5, 0, Vec3::UnitZ(), Vec3(0.5, 0, 1).normalized());
    EXPECT_LT((tip(motion[4]) - Vec3(40, 0, 0) - off).norm(), 1e-9);
}

/// CUT3DFS: square to the plane of the machine. CUT3DFF: along Z of the frame.
TEST(SurfaceCompensation, AToolThatStandsIsToldByPlaneOrFrame) {
    const auto milled_so = [](const std::string& system) {
        const Ran ran = run_program("sinumerik",
                                    tool_of(110) + "ROT Y30\nG0 X-10 Y0 Z5\n" + system +
                                        "\nG41 G1 X0 Z0 F500\nX40\nG40 X60\nM30",
                                    mill());
        EXPECT_EQ(alarms(ran), "");
        return tip(motions(ran).at(2));
    };
    const double s = std::sqrt(0.75);
    const Vec3 point = 40 * Vec3(s, 0, -0.5);
    EXPECT_LT((milled_so("CUT3DFS") - point - 5 * Vec3(0.5, 0, s) + 5 * Vec3::UnitZ()).norm(),
              1e-9);
    EXPECT_LT((milled_so("CUT3DFF") - point).norm(), 1e-9);
}

/// Without a transformation a way that is no line is splines.
TEST(SurfaceCompensation, ThreeAxesGetSplines) {
    const Ran ran = run_program("sinumerik",
                                tool_of(110) +
                                    "G0 X-10 Y0 Z5\nCUT3DFF\nG41 G1 X0 Z0 F500\n"
                                    "X40 A4=-0.5 C4=1 A5=0.5 C5=1\nG40 X60 Z30\nM30",
                                mill());
    EXPECT_EQ(alarms(ran), "");
    const auto motion = motions(ran);
    ASSERT_GT(motion.size(), 3u);
    EXPECT_EQ(motion[2].op(), path::Op::Spline);
    const Vec3 off = 5 * Vec3(0.5, 0, 1).normalized() - 5 * Vec3::UnitZ();
    EXPECT_LT((tip(motion[motion.size() - 2]) - Vec3(40, 0, 0) - off).norm(), 1e-9);
}

TEST(SurfaceCompensation, AxiomaHasTheWordsToo) {
    const Ran ran = run_program("axioma",
                                tool_of(110) +
                                    "G0 X-10 Y0 Z5\nTRAORI\nCUT3DF\n"
                                    "G41 G1 X0 Y0 Z0 A3=1 C3=1 F500\n"
                                    "X40 A4=-0.2 C4=1\nG40 X60 Z30\nM30",
                                trunnion());
    EXPECT_EQ(alarms(ran), "");
    const auto motion = motions(ran);
    const Vec3 off = aside(5, 5, Vec3(-0.2, 0, 1).normalized(), Vec3(1, 0, 1).normalized());
    EXPECT_LT((tip(motion.at(2)) - Vec3(40, 0, 0) - off).norm(), 1e-9);
}

TEST(SurfaceCompensation, AToolOfNoShapeIsSaid) {
    const Ran ran = run_program(
        "sinumerik", tool_of(150) + "CUT3DFF\nG41 G1 X0 Y0 Z0 F500\nX40\nG40 X60\nM30", mill());
    EXPECT_EQ(alarms(ran), "K5688");
    ASSERT_EQ(ran.messages.size(), 1u);
    EXPECT_EQ(ran.messages[0].row->code, "K5688");
}

class SurfaceCompensationRefuses : public ::testing::TestWithParam<Refused> {};

TEST_P(SurfaceCompensationRefuses, WithItsRow) {
    const std::string head =
        "$TC_DP1[1,1]=156\n$TC_DP6[1,1]=5\n$TC_DP7[1,1]=1\n$TC_DP11[1,1]=10\n"
        "T1 D1 M6\nS1000 M3\nG0 X0 Y0 Z10\n";
    expect_refused(run_program("sinumerik", head + GetParam().text, trunnion()), GetParam());
}

const std::string kOn = "TRAORI\nCUT3DF\nG1 G41 X10 Z0 F100\n";

INSTANTIATE_TEST_SUITE_P(
    , SurfaceCompensationRefuses,
    ::testing::Values(Refused{kOn + "X20 A4=-1 C4=0.1", "10767", "K5683"},
                      Refused{kOn + "X20 A4=-0.1 C4=1 A5=0.1 C5=1", "10768", "K5684"},
                      Refused{kOn + "X20 A4=0", "10769", "K5685"},
                      Refused{kOn + "X20 A4=-1 C4=1 A5=1 C5=-1", "10769", "K5685"},
                      Refused{"$TC_DP7[1,1]=6\nT1 D1\n" + kOn, "10774", "K5686"},
                      Refused{"$TC_DP7[1,1]=-1\nT1 D1\n" + kOn, "10774", "K5686"},
                      Refused{"$TC_DP11[1,1]=90\nT1 D1\n" + kOn, "10774", "K5686"},
                      Refused{kOn + "A3=0.2 B3=0.4 C3=1\nX20\nX40 Z10 A4=-0.5 B4=0.8 C4=1\nX50",
                              "10773", "K5687"},
                      Refused{"TRAORI\nCUT3DFF\nG1 G41 X10 Z0 F100\n", "10772", "K5689"},
                      Refused{"TRAORI\nCUT3DF KONT\nG1 G41 X10 Z0 F100\n", "K5682", "K5682"},
                      Refused{kOn + "X20 RND=2\nY20", "K5018", "K5018"},
                      // A hollow of 2 mm radius: the ball of 5 mm does not fit.
                      Refused{"$TC_DP1[1,1]=110\nT1 D1\n" + kOn + "X11 A4=0.5 C4=1 A5=-0.5 C5=1",
                              "10751", "K5275"}));

}  // namespace
}  // namespace kadr::interp::face_milling_compensation_test
