// Tool centre point control as a kind of tool length compensation, F 4.7: G43.4 with rotary axes,
// G43.5 with vectors, what begins and ends it, and what it refuses.
#include <cmath>

#include "tests/interp/five_axis_bench.h"

namespace kadr::interp::tool_centre_test {
namespace {

using path::OrientKind;

constexpr double kLength = 80;  // mm, of tool 1

machine::Machine trunnion_with_tool() {
    machine::Machine machine = trunnion();
    machine::ToolData tool;
    tool.number = 1;
    tool.length = kLength;
    tool.radius = 5;
    machine.tools = {tool};
    machine.work_offsets = {};
    return machine;
}

std::vector<path::Command> fanuc(const std::string& text) {
    const Ran ran = read("fanuc", "M06 T01\nS1000 M03\n" + text + "\nM30", trunnion_with_tool());
    EXPECT_EQ(alarms(ran), "") << text;
    return motions(ran);
}

Vec3 point_of(const path::Command& command) {
    return {command.motion().to[0], command.motion().to[1], command.motion().to[2]};
}

/// Where X, Y and Z of the machine stand at the end of a command.
Vec3 axes_of(const path::Command& command, double length) {
    const machine::Chain chain = trunnion().kinematics->chain;
    const machine::ChainPosition position{Vec3::Zero(),
                                          Vec3::Zero(),
                                          {rad_from_deg(command.motion().to[index(Axis::C)]),
                                           rad_from_deg(command.motion().to[index(Axis::A)]), 0}};
    return machine::inverse_linear(chain, point_of(command), position,
                                   machine::tip_of_length(chain, length));
}

TEST(ToolCentre, SameWaysAsOnTheOtherControl) {
    const Ran other = read("sinumerik",
                           "T1 D1 M6\nS1000 M3\nTRAORI\nORIVECT\nG0 X0 Y0 Z60 C3=1\n"
                           "G1 X40 A3=0.5 C3=1 F2000\nY30 A3=0.5 B3=0.5 C3=1\n"
                           "A3=-0.5 B3=0.5 C3=1\nORIAXES\nX0 A=20 C=30",
                           trunnion_with_tool());
    const auto wanted = motions(other);
    const auto vectors = fanuc(
        "G43.5 H01 P1\nG00 X0. Y0. Z60. K1.\nG01 X40. I0.5 K1. F2000.\n"
        "Y30. I0.5 J0.5 K1.\nI-0.5 J0.5 K1.\nG43.4 H01\nX0. A20. C30.");
    // The first motion of G43.5 is that of the length, which acts at once.
    ASSERT_EQ(vectors.size(), wanted.size() + 1);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const path::Command& one = wanted[i];
        const path::Command& two = vectors[i + 1];
        EXPECT_LT((point_of(one) - point_of(two)).norm(), 1e-9) << i;
        EXPECT_LT((one.motion().direction - two.motion().direction).norm(), 1e-12) << i;
        EXPECT_EQ(one.motion().orient_kind, two.motion().orient_kind) << i;
        EXPECT_LT((one.motion().orientation().axis * one.motion().orientation().angle -
                   two.motion().orientation().axis * two.motion().orientation().angle)
                      .norm(),
                  1e-12);
        EXPECT_NEAR(one.motion().to[index(Axis::A)], two.motion().to[index(Axis::A)], 1e-9) << i;
        EXPECT_NEAR(one.motion().to[index(Axis::C)], two.motion().to[index(Axis::C)], 1e-9) << i;
    }
}

TEST(ToolCentre, TheControlPointGoesAlongTheToolByItsLength) {
    const auto all = fanuc("G00 X30. Y20. Z10. A25. C70.\nG43.4 H01\nG01 X40. F500.\nG49");
    ASSERT_EQ(all.size(), 4u);
    // The head does not tilt: the length lies along Z of the machine.
    EXPECT_LT((axes_of(all[1], kLength) - Vec3(30, 20, 10 + kLength)).norm(), 1e-9);
    // The workpiece lies as the table stands, so that X of the program is that of the machine.
    EXPECT_LT((axes_of(all[2], kLength) - Vec3(40, 20, 10 + kLength)).norm(), 1e-9);
    EXPECT_EQ(all[3].motion().orient_kind, OrientKind::None);
    EXPECT_LT((point_of(all[3]) - Vec3(40, 20, 10)).norm(), 1e-9);
}

TEST(ToolCentre, TheTipStaysWhileTheTableTurns) {
    const auto all = fanuc("G00 X30. Y20. Z10. A25. C70.\nG43.4 H01\nG01 A40. C-10. F500.");
    ASSERT_EQ(all.size(), 3u);
    EXPECT_LT((point_of(all[2]) - point_of(all[1])).norm(), 1e-9);
    EXPECT_EQ(all[2].motion().to[index(Axis::A)], 40);
    EXPECT_EQ(all[2].motion().orient_kind, OrientKind::Axes);
    EXPECT_GT((axes_of(all[2], kLength) - axes_of(all[1], kLength)).norm(), 1);
}

TEST(ToolCentre, RotaryWordsBesideTheCodeSayHowTheWorkpieceLies) {
    const auto turned = fanuc("G43.4 H01 X30. Y20. Z10. A0. C90.\nG01 X40. F500.");
    ASSERT_EQ(turned.size(), 2u);
    EXPECT_LT((axes_of(turned[0], kLength) - Vec3(30, 20, 10 + kLength)).norm(), 1e-9);
    EXPECT_LT((axes_of(turned[1], kLength) - Vec3(40, 20, 10 + kLength)).norm(), 1e-9);
}

TEST(ToolCentre, VectorsTurnWithTheWorkpiece) {
    // With the table turned by 90 degrees, X of the program is another direction of the workpiece.
    const auto all = fanuc("G00 C90.\nG43.5 H01\nG01 X10. I1. K1. F500.");
    ASSERT_EQ(all.size(), 3u);
    const machine::Chain chain = trunnion().kinematics->chain;
    const machine::Mat3 table = machine::rotation_of(chain, {rad_from_deg(90), 0, 0});
    const Vec3 wanted = table * Vec3(1, 0, 1).normalized();
    EXPECT_LT((all[2].motion().direction - wanted).norm(), 1e-12);
    EXPECT_EQ(all[2].motion().orient_kind, OrientKind::Axes)
        << "without tool posture control the axes go evenly";
}

TEST(ToolCentre, LeadLeansTheVectorTowardsTheWay) {
    const auto all = fanuc("G43.5 H01\nG01 X10. K1. Q30. F500.\nY10. K1. Q-10.");
    ASSERT_EQ(all.size(), 3u);
    const double lead = rad_from_deg(30), back = rad_from_deg(-10);
    EXPECT_LT((all[1].motion().direction - Vec3(std::sin(lead), 0, std::cos(lead))).norm(), 1e-12);
    EXPECT_LT((all[2].motion().direction - Vec3(0, std::sin(back), std::cos(back))).norm(), 1e-12);
}

TEST(ToolCentre, PostureControlLeadsRotaryWordsAlongTheGreatCircle) {
    const auto all = fanuc("G43.4 H01 P1\nG01 A20. C40. F500.\nX10. A30. C60.");
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[2].motion().orient_kind, OrientKind::Cone);
    EXPECT_NEAR(all[2].motion().orientation().axis.dot(all[1].motion().direction), 0, 1e-12);
    EXPECT_NEAR(all[2].motion().orientation().axis.dot(all[2].motion().direction), 0, 1e-12);
    EXPECT_EQ(all[2].motion().to[index(Axis::C)], 60);
}

TEST(ToolCentre, ArcsStandUnderRotaryWords) {
    const auto all = fanuc("G43.4 H01\nG00 X0. Y0. Z0. A20. C0.\nG02 X10. Y0. I5. A30. F500.");
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[2].op(), path::Op::Arc);
    EXPECT_NEAR(all[2].motion().arc().sweep, std::numbers::pi, 1e-9);
}

class ToolCentreRefuses : public ::testing::TestWithParam<Refused> {};

TEST_P(ToolCentreRefuses, WithItsAlarm) {
    const Ran ran =
        read("fanuc", "M06 T01\nS1000 M03\n" + GetParam().text + "\nM30", trunnion_with_tool());
    expect_refused(ran, GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    , ToolCentreRefuses,
    ::testing::Values(Refused{"G43.4 H01\nG41 X10. D01 F100.", "PS5421", "K5611"},
                      Refused{"G43.4 H01\nG55", "PS5421", "K5611"},
                      Refused{"G43.4 H01\nG52 X10.", "PS5421", "K5611"},
                      Refused{"G43.4 H01\nG92 X10.", "PS5421", "K5611"},
                      Refused{"G43.4 H01\nG68 X0. Y0. R30.", "PS5421", "K5611"},
                      Refused{"G43.4 H01\nG81 X10. Z-5. R2. F100.", "PS5421", "K5611"},
                      Refused{"G43.4 H01\nG53 Z0.", "PS5421", "K5609"},
                      Refused{"G43.4 H01\nG28 Z0.", "PS5421", "K5585"},
                      Refused{"G43.5 H01\nG02 X10. Y0. R5. F100.", "PS5421", "K5612"},
                      Refused{"G43.5 H01\nG01 X10. K1. A20. F100.", "PS5421", "K5603"},
                      Refused{"G43.5 H01\nG01 X10. K0. F100.", "PS5421", "K5604"},
                      Refused{"G43.5 H01\nG01 X10. I1. K-1. F100.", "PS5421", "K5607"},
                      Refused{"G43.5 H01\nG01 K1. Q10. F100.", "PS5421", "K5613"},
                      Refused{"G43.5 H01\nG01 Z10. K1. Q10. F100.", "PS5421", "K5614"},
                      Refused{"G43.4 H01 P1\nG01 A20. C0. F100.\nC360.", "PS5421", "K5607"}));

TEST(ToolCentre, MachineWithoutKinematicsRefusesTheCode) {
    const Ran ran = read("fanuc", "G43.4 H01\nM30");
    EXPECT_EQ(alarms(ran), "PS5420");
    EXPECT_EQ(ran.messages.at(0).row->code, "K5600");
}

}  // namespace
}  // namespace kadr::interp::tool_centre_test
