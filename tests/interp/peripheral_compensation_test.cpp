// Compensation of the cutter's side in space on FANUC, F 4.4: G41.2 and G42.2 under G43.4 and
// G43.5.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/interp/five_axis_bench.h"

namespace kadr::interp::peripheral_compensation_test {
namespace {

/// With tools of 5 mm radius, and the rotary axes where a test wants them.
machine::Machine with_tool(bool is_mixed = false) {
    machine::Machine machine = trunnion();
    machine::ToolData tool;
    tool.number = 1;
    tool.length = 80;
    tool.radius = 5;
    machine.tools = {tool};
    machine.work_offsets = {};
    if (is_mixed) {
        machine::Chain chain = machine.kinematics->chain;
        chain.joints[machine::kR2].side = machine::ChainSide::Head;
        machine.kinematics->chain = machine::prepare(chain).value();
    }
    return machine;
}

std::vector<path::Command> fanuc(const std::string& text) {
    const Ran ran = read("fanuc", "M06 T01\nS1000 M03\n" + text + "\nM30", with_tool());
    EXPECT_EQ(alarms(ran), "") << text;
    return motions(ran);
}

std::vector<path::Command> sinumerik(const std::string& text) {
    const Ran ran = read("sinumerik", "T1 D1 M6\nS1000 M3\n" + text + "\nM30", with_tool());
    EXPECT_EQ(alarms(ran), "") << text;
    return motions(ran);
}

Vec3 tip(const path::Command& command) {
    return {command.motion().to[0], command.motion().to[1], command.motion().to[2]};
}

/// From the end, because a length has a motion of its own here.
void expect_same(const std::vector<path::Command>& one, const std::vector<path::Command>& other,
                 std::size_t count) {
    ASSERT_GE(one.size(), count);
    ASSERT_GE(other.size(), count);
    for (std::size_t i = 1; i <= count; ++i) {
        const path::Command& a = one[one.size() - i];
        const path::Command& b = other[other.size() - i];
        EXPECT_EQ(a.op(), b.op()) << i;
        EXPECT_LT((tip(a) - tip(b)).norm(), 1e-6) << i;
        EXPECT_LT((a.motion().direction - b.motion().direction).norm(), 1e-9) << i;
        EXPECT_EQ(!a.motion().contact, !b.motion().contact) << i;
        EXPECT_EQ(a.motion().orient_kind, b.motion().orient_kind) << i;
    }
}

/// Words have three decimals here, so that vectors are written a thousand times as long.
TEST(SideCompensation, TheUpperChamferIsThatOfTheOtherControl) {
    const auto wanted = sinumerik(
        "TRAORI\nORIVECT\nG0 X30 Y0 Z30\nZ-3\nCUT3DC ISD=0\n"
        "G0 G42 X20 Y0 A3=-13 B3=-20 C3=23.853721\nG1 X0 Y13 F1000\nA3=13 B3=-20 C3=23.853721\n"
        "X-20 Y0\nA3=13 B3=20 C3=23.853721\nX0 Y-13\nA3=-13 B3=20 C3=23.853721\nX20 Y0\n"
        "G40 X30 Y0 C3=1");
    const auto found = fanuc(
        "G43.5 H01 P1\nG00 X30. Y0. Z30.\nZ-3.\n"
        "G00 G42.2 D01 X20. Y0. I-13000. J-20000. K23853.721\nG01 X0. Y13. F1000.\n"
        "I13000. J-20000. K23853.721\nX-20. Y0.\nI13000. J20000. K23853.721\nX0. Y-13.\n"
        "I-13000. J20000. K23853.721\nX20. Y0.\nG40 X30. Y0. K1.");
    expect_same(found, wanted, 10);
}

TEST(SideCompensation, LeftAndRightWithRotaryAxes) {
    for (const std::string side : {"1", "2"}) {
        SCOPED_TRACE(side);
        const auto wanted = sinumerik("TRAORI\nORIAXES\nG0 X-10 Y-20 Z20\nCUT3DC\nG1 G4" + side +
                                      " X0 Y0 A20 F500\nX40 A30 C10\nG40 X60 Y0 A0 C0");
        for (const std::string type : {".2", ".4", ".5"}) {
            const auto found = fanuc("G43.4 H01\nG00 X-10. Y-20. Z20.\nG01 G4" + side + type +
                                     " D01 X0. Y0. A20. F500.\nX40. A30. C10.\n"
                                     "G40 X60. Y0. A0. C0.\nG49");
            std::vector<path::Command> inside(found.begin(), found.end() - 1);  // G49 moves
            expect_same(inside, wanted, 3);
        }
    }
}

/// Behind it the codes of the plane are of the plane again.
TEST(SideCompensation, EndsWithItsCode) {
    const auto motion = fanuc(
        "G43.4 H01\nG00 X-10. Y-20. Z20.\nG01 G41.2 D01 X0. Y0. F500.\nX40.\nG40 X60.\nG49\n"
        "G41 D01 X0. Y0.\nX40.\nG40 X60.");
    EXPECT_EQ(motion.back().motion().orient_kind, path::OrientKind::None);
    EXPECT_LT((tip(motion.back()) - Vec3(60, 0, 20)).norm(), 1e-9);
}

class SideCompensationRefuses : public ::testing::TestWithParam<Refused> {};

TEST_P(SideCompensationRefuses, WithItsRow) {
    const bool is_mixed = GetParam().code == "K5691";
    expect_refused(read("fanuc", "M06 T01\nS1000 M03\nG00 X0. Y0. Z50.\n" + GetParam().text,
                        with_tool(is_mixed)),
                   GetParam());
}

const std::string kOn = "G43.4 H01\nG01 G41.2 D01 X10. F100.\nX20.\n";

INSTANTIATE_TEST_SUITE_P(, SideCompensationRefuses,
                         ::testing::Values(Refused{"G01 G41.2 D01 X10. F100.", "PS5460", "K5690"},
                                           Refused{kOn + "G49", "PS5460", "K5692"},
                                           Refused{kOn + "G43.5 H01", "PS5460", "K5692"},
                                           Refused{kOn + "G43 H01", "PS5460", "K5692"},
                                           Refused{kOn + "G02 X30. R5.", "PS5461", "K5691"}));

}  // namespace
}  // namespace kadr::interp::peripheral_compensation_test
