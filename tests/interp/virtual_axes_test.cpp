// Faces, cylinders and inclined slides as programs say them: what a machine cannot do is refused,
// and listings say in which coordinates a place is. What the controls' words do is shown by the
// programs of tests/control.
#include <cmath>
#include <numbers>
#include <sstream>

#include "tests/interp/text_bench.h"

namespace kadr::interp::virtual_axes_test {
namespace {

/// A mill of these axes.
machine::Machine with_axes(std::string_view names) {
    machine::Machine machine = mill();
    std::erase_if(machine.axes, [&](const auto& axis) {
        return names.find(axis.name) == std::string_view::npos;
    });
    return machine;
}

struct Refused {
    std::string_view dialect;
    std::string text;
    std::string_view axes;
    std::string_view alarm;
    std::string_view code;
};
class VirtualRefuses : public ::testing::TestWithParam<Refused> {};

TEST_P(VirtualRefuses, WithItsAlarm) {
    const auto& [dialect, text, axes, alarm, code] = GetParam();
    const Ran ran = read(dialect, text, with_axes(axes));
    EXPECT_TRUE(ran.alarmed);
    ASSERT_EQ(ran.messages.size(), 1u) << text;
    EXPECT_EQ(ran.messages[0].alarm_number, alarm) << text;
    EXPECT_EQ(ran.messages[0].row->code, code) << text;
}

INSTANTIATE_TEST_SUITE_P(
    , VirtualRefuses,
    ::testing::Values(Refused{"sinumerik", "TRANSMIT\nM30", "XYZ", "14100", "K5540"},
                      Refused{"sinumerik", "TRACYL(40)\nM30", "XYZ", "14100", "K5541"},
                      Refused{"sinumerik", "TRAANG(30)\nM30", "XY", "14100", "K5549"},
                      Refused{"sinumerik", "TRAANG()\nM30", "XZ", "14404", "K5548"},
                      Refused{"sinumerik", "TRANSMIT\nG74 X1=0\nM30", "XZC", "17630", "K5585"},
                      Refused{"sinumerik", "TRANSMIT\nSUPA G0 X0\nM30", "XZC", "17620", "K5609"},
                      Refused{"fanuc", "G12.1\nM30", "XYZ", "PS0145", "K5540"},
                      Refused{"fanuc", "G07.1 C20.\nM30", "XYZ", "PS0175", "K5541"},
                      Refused{"fanuc", "G12.1\nG28 X0\nM30", "XZC", "PS0146", "K5542"},
                      Refused{"fanuc", "G12.1\nG81 X5. Z-5. R2. F100\nM30", "XZC", "PS0146",
                              "K5542"},
                      Refused{"fanuc", "G12.1\nG12.1\nM30", "XZC", "PS0146", "K5542"},
                      Refused{"fanuc", "G07.1 C20.\nG07.1 C30.\nM30", "XZC", "PS0176", "K5543"},
                      Refused{"fanuc", "G07.1 C-20.\nM30", "XZC", "PS0175", "K5544"}));

/// Lines of the listing that tell of motions.
std::string motions_of(const Ran& ran) {
    std::string out;
    std::istringstream lines(ran.listing());
    for (std::string line; std::getline(lines, line);)
        if (line.find("\"to\"") != std::string::npos) out += line + '\n';
    return out;
}

TEST(Virtual, ListingSaysOnWhatAPlaceLies) {
    const Ran face = read("sinumerik", "S1000 M3\nG0 X20\nTRANSMIT\nG1 X10 Y10 F100\nTRAFOOF\nM30",
                          with_axes("XZC"));
    EXPECT_FALSE(face.alarmed);
    EXPECT_NE(motions_of(face).find(R"("to":{"X":10,"Y":10,"Z":0,"C":45},"on":"face")"),
              std::string::npos)
        << motions_of(face);
    const Ran cylinder = read(
        "sinumerik", "S1000 M3\nG0 X20\nTRACYL(40)\nG1 Y10 F100\nTRAFOOF\nM30", with_axes("XZC"));
    EXPECT_NE(motions_of(cylinder).find(R"("on":"cylinder","radius":20)"), std::string::npos)
        << motions_of(cylinder);
}

/// The tool stands behind the centre of the face: C stays where it is, and X goes on below 0.
TEST(Virtual, FaceFromTheOtherSide) {
    const Ran ran = read("sinumerik", "S1000 M3\nG0 X-20\nTRANSMIT\nG1 X0 Y-20 F100\nTRAFOOF\nM30",
                         with_axes("XZC"));
    EXPECT_FALSE(ran.alarmed);
    const path::Command& line = ran.commands.at(ran.commands.size() - 2);
    EXPECT_EQ(line.motion().virtual_axes().side, -1);
    EXPECT_NEAR(line.motion().to[index(Axis::C)], 90, 1e-9);
}

/// A program that goes through the centre many times in one batch and in many.
TEST(Virtual, RotaryAxisDoesNotDependOnBatches) {
    std::string text = "S1000 M3\nG0 X20\nTRANSMIT\n";
    for (int i = 0; i < 20; ++i) text += "G1 X-10 Y" + std::to_string(i) + " F100\nX10 Y-3\n";
    const Ran ran = read("sinumerik", text + "TRAFOOF\nM30", with_axes("XZC"));
    EXPECT_FALSE(ran.alarmed);
    for (const path::Command& command : ran.commands) {
        if (!command.is_motion() || !command.motion().virtual_axes().is_on()) continue;
        const double angle =
            std::atan2(command.motion().to[1], command.motion().to[0]) * 180 / std::numbers::pi;
        const double turned = command.motion().to[index(Axis::C)] - angle;
        EXPECT_NEAR(std::remainder(turned, 360), 0, 1e-9);
    }
}

}  // namespace
}  // namespace kadr::interp::virtual_axes_test
