// Tool centre point control: how the tool stands as a program says it, the rotary axes that follow
// from it, and what is refused. S 7.1 to 7.4.
#include <cmath>
#include <numbers>

#include "tests/interp/five_axis_bench.h"

namespace kadr::interp::orienting_test {
namespace {

using path::OrientKind;
using path::Vec3;

/// Motions of a text without messages.
std::vector<path::Command> motions(const std::string& text) {
    const Ran ran = read("sinumerik", "S1000 M3\nTRAORI\n" + text + "\nM30", trunnion());
    EXPECT_EQ(alarms(ran), "") << text;
    return motions(ran);
}

TEST(Orienting, VectorBecomesRotaryPositionsOnTheGreatCircle) {
    const auto all = motions("G1 X10 Y5 Z0 A3=1 B3=-2 C3=4 F100\nX20\nX30 A3=1 B3=-2 C3=4");
    ASSERT_EQ(all.size(), 3u);
    const Vec3 wanted = Vec3(1, -2, 4).normalized();
    for (const path::Command& command : all) {
        EXPECT_LT((tool_of(command) - wanted).norm(), 1e-12);
        EXPECT_LT((command.motion().direction - wanted).norm(), 1e-12);
    }
    EXPECT_EQ(all[0].motion().orient_kind, OrientKind::Cone);
    EXPECT_LT((all[0].motion().orientation().axis - Vec3(2, 1, 0).normalized()).norm(), 1e-12);
    EXPECT_NEAR(all[0].motion().orientation().angle, std::acos(4 / std::sqrt(21.0)), 1e-12);
    // Words of one block; and a vector that says nothing new turns nothing.
    EXPECT_EQ(all[1].motion().orient_kind, OrientKind::Axes);
    EXPECT_EQ(all[1].motion().to[index(Axis::A)], all[0].motion().to[index(Axis::A)]);
    EXPECT_EQ(all[2].motion().orient_kind, OrientKind::Axes);
}

TEST(Orienting, AxesGoInProportionUnderOriaxes) {
    const auto all = motions("ORIAXES\nG1 X10 A3=1 B3=-2 C3=4 F100\nX20 A=30 C=45");
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].motion().orient_kind, OrientKind::Axes);
    EXPECT_LT((tool_of(all[0]) - Vec3(1, -2, 4).normalized()).norm(), 1e-12);
    EXPECT_EQ(all[1].motion().to[index(Axis::A)], 30);
    EXPECT_EQ(all[1].motion().to[index(Axis::C)], 45);
}

TEST(Orienting, TurnsAreSmoothedWithinTheToleranceOfTheTool) {
    const auto all = motions(
        "ORISON OTOL=2\nG1 X10 A3=1 C3=1 F100\nG642 X20\nORISOF X30\nG64 X40\nORISON OTOL=-1 X50");
    ASSERT_EQ(all.size(), 5u);
    const bool smooths[] = {true, true, false, false, true};
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_EQ(all[i].motion().blending.smooths_orientation, smooths[i]) << i;
    EXPECT_NEAR(all[0].motion().blending.orientation, rad_from_deg(2), 1e-15);
    EXPECT_EQ(all[0].motion().blending.kind, path::BlendKind::None);
    EXPECT_EQ(all[1].motion().blending.kind, path::BlendKind::Tolerance);
    EXPECT_EQ(all[4].motion().blending.orientation, trunnion().orientation_tolerance);
    const Ran plain = read("sinumerik", "S1000 M3\nORISON\nG1 X10 F100\nM30", trunnion());
    EXPECT_FALSE(motions(plain)[0].motion().blending.smooths_orientation)
        << "without a transformation";
}

TEST(Orienting, AnglesAreWhatTheirModeSays) {
    const double a = rad_from_deg(20), b = rad_from_deg(35), c = rad_from_deg(-50);
    const auto sin = [](double x) { return std::sin(x); };
    const auto cos = [](double x) { return std::cos(x); };
    const struct {
        std::string mode;
        Vec3 tool;
    } cases[] = {
        {"ORIEULER", {sin(a) * sin(b), -cos(a) * sin(b), cos(b)}},
        {"ORIRPY",
         {cos(c) * sin(b) * cos(a) + sin(c) * sin(a), sin(c) * sin(b) * cos(a) - cos(c) * sin(a),
          cos(b) * cos(a)}},
        {"ORIRPY2", {sin(b), -sin(a) * cos(b), cos(a) * cos(b)}},
    };
    for (const auto& angles : cases) {
        const auto all = motions(angles.mode + "\nG1 X10 A2=20 B2=35 C2=-50 F100");
        ASSERT_EQ(all.size(), 1u);
        EXPECT_LT((tool_of(all[0]) - angles.tool).norm(), 1e-12) << angles.mode;
    }
}

TEST(Orienting, FramesTurnVectorsUnlessTheyAreOfTheBase) {
    const auto turned = motions("ROT Z90\nG1 X10 A3=1 C3=1 F100");
    ASSERT_EQ(turned.size(), 1u);
    EXPECT_LT((tool_of(turned[0]) - Vec3(0, 1, 1).normalized()).norm(), 1e-12);
    const auto of_base = motions("ORIMKS\nROT Z90\nG1 X10 A3=1 C3=1 F100");
    EXPECT_LT((tool_of(of_base[0]) - Vec3(1, 0, 1).normalized()).norm(), 1e-12);
    const auto shifted = motions("TRANS X5\nG1 X10 A3=1 C3=1 F100");
    EXPECT_LT((tool_of(shifted[0]) - Vec3(1, 0, 1).normalized()).norm(), 1e-12);
    EXPECT_EQ(shifted[0].motion().to[0], 15);
}

TEST(Orienting, AxesStandWhereTheTransformationIsSwitched) {
    const machine::Machine machine = trunnion();
    const Ran ran = read("sinumerik",
                         "G0 X30 Y20 Z10 A=25 C=70\nTRAORI\nG91 G0 X=0\nG90 G0 Z=IC(10)\n"
                         "TRAFOOF\nG91 G0 X=0",
                         machine);
    const auto all = motions(ran);
    ASSERT_EQ(all.size(), 4u);
    const machine::Chain& chain = machine.kinematics->chain;
    const machine::ChainPosition position{
        {30, 20, 10}, Vec3::Zero(), {rad_from_deg(70), rad_from_deg(25), 0}};
    const Vec3 tip = machine::forward(chain, position, Vec3::Zero()).tip;
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(all[1].motion().to[i], tip[static_cast<Eigen::Index>(i)], 1e-12);
    // Ten millimetres along Z of the workpiece are a way of all axes of the machine.
    const Vec3 above = tip + Vec3(0, 0, 10);
    const Vec3 axes = machine::inverse_linear(chain, above, position, Vec3::Zero());
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(all[3].motion().to[i], axes[static_cast<Eigen::Index>(i)], 1e-12);
    // The table is tilted about X: that is a way of Y and Z.
    EXPECT_GT((axes - Vec3(30, 20, 10)).tail<2>().cwiseAbs().minCoeff(), 0.1);
}

class OrientingRefuses : public ::testing::TestWithParam<Refused> {};

TEST_P(OrientingRefuses, WithItsAlarm) {
    const Ran ran = read("sinumerik", "S1000 M3\n" + GetParam().text, trunnion());
    expect_refused(ran, GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    , OrientingRefuses,
    ::testing::Values(Refused{"G1 X10 C3=1 F100", "14101", "K5602"},
                      Refused{"TRAORI\nTRAFOOF\nG1 X10 A2=10 F100", "14101", "K5602"},
                      Refused{"TRAORI\nG1 X10 C3=1 A2=10 F100", "14110", "K5601"},
                      Refused{"TRAORI\nG1 X10 A2=10 A=5 F100", "14111", "K5610"},
                      Refused{"TRAORI\nG1 X10 A3=1 C3=1 C=5 F100", "14129", "K5603"},
                      Refused{"TRAORI\nG1 X10 A3=0 F100", "14121", "K5604"},
                      Refused{"TRAORI\nG1 X10 C3=-1 F100", "14120", "K5605"},
                      Refused{"TRAORI\nG1 X10 A3=1 C3=-1 F100", "14112", "K5607"},
                      Refused{"TRAORI\nSUPA G0 Z0", "17620", "K5609"},
                      Refused{"TRAORI\nG74 Z1=0", "17630", "K5585"},
                      Refused{"T1 D1 M6\nS1000 M3\nG1 G41 X10 F100\nX20\nTRAORI", "14400",
                              "K5608"}));

TEST(Orienting, MachineWithoutKinematicsHasNoTransformation) {
    const Ran ran = read("sinumerik", "TRAORI");
    EXPECT_EQ(alarms(ran), "14100");
    EXPECT_EQ(ran.messages.at(0).row->code, "K5600");
}

TEST(Orienting, NutatingHeadDoesNotReachBelowTheHorizontal) {
    machine::Machine machine = trunnion();
    machine::Chain chain;
    const double s = std::sqrt(0.5);
    chain.joints[machine::kR1] = {true,          Axis::C,     machine::ChainSide::Head,
                                  Vec3::UnitZ(), {0, 0, 250}, 1};
    chain.joints[machine::kR2] = {true,      Axis::A,     machine::ChainSide::Head,
                                  {0, s, s}, {0, 0, 120}, 1};
    machine.kinematics->chain = machine::prepare(chain).value();
    const Ran ran = read("sinumerik", "S1000 M3\nTRAORI\nG1 X10 A3=1 C3=-1 F100", machine);
    EXPECT_EQ(alarms(ran), "14112");
    EXPECT_EQ(ran.messages.at(0).row->code, "K5606");
}

}  // namespace
}  // namespace kadr::interp::orienting_test
