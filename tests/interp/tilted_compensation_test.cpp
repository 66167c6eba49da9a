// Cutter radius compensation in a plane that frames have tilted (S 5.2 CUT2DF, F 4.8): the ways are
// those of the plane as it lies without the frame, tilted with it.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "path/frame.h"
#include "path/linear.h"
#include "tests/interp/five_axis_bench.h"

namespace kadr::interp::tilted_compensation_test {
namespace {

using path::linear;
using path::Mat3;
using path::Vec3;

struct Ways {
    std::vector<path::Command> commands;
    std::string alarms;
};

Ways sample_distances_of(const std::string& control, const std::string& begin,
                         const std::string& contour) {
    const Ran ran = read(control, begin + "\n" + contour, trunnion());
    return {motions(ran), alarms(ran)};
}

/// How a frame lies: of places one along each axis.
Mat3 lie_of(const std::string& control, const std::string& begin, const char* end) {
    const Ways distances = sample_distances_of(
        control, begin, std::string("G0 X0 Y0 Z0\nX1.\nX0 Y1.\nY0 Z1.\n") + end);
    EXPECT_EQ(distances.commands.size(), 4u) << distances.alarms;
    Mat3 lie = Mat3::Identity();
    if (distances.commands.size() != 4) return lie;
    for (std::size_t i = 1; i < 4; ++i)
        lie.col(static_cast<Eigen::Index>(i - 1)) =
            linear(distances.commands[i].motion().to) - linear(distances.commands[0].motion().to);
    return lie;
}

void expect_tilted(const Ways& flat, const Ways& tilted, const Mat3& lie) {
    constexpr double kRounding = 1e-9;
    EXPECT_EQ(tilted.alarms, flat.alarms);
    ASSERT_EQ(tilted.commands.size(), flat.commands.size());
    ASSERT_FALSE(flat.commands.empty());
    // Of the first place the zero points are no matter.
    const Vec3 flat_origin = linear(flat.commands.front().motion().to);
    const Vec3 origin = linear(tilted.commands.front().motion().to);
    const auto off = [&](const Vec3& found, const Vec3& wanted) {
        return (found - origin - lie * (wanted - flat_origin)).norm();
    };
    for (std::size_t i = 0; i < flat.commands.size(); ++i) {
        const path::Command& at = flat.commands[i];
        const path::Command& found = tilted.commands[i];
        EXPECT_EQ(found.op(), at.op()) << i;
        EXPECT_NEAR(found.motion().feed, at.motion().feed, kRounding) << i;
        EXPECT_LT(off(linear(found.motion().to), linear(at.motion().to)), kRounding) << i;
        if (at.op() != path::Op::Arc) continue;
        EXPECT_LT(off(found.motion().arc().center, at.motion().arc().center), kRounding) << i;
        EXPECT_LT((found.motion().arc().normal - lie * at.motion().arc().normal).norm(), kRounding)
            << i;
        EXPECT_NEAR(found.motion().arc().sweep, at.motion().arc().sweep, kRounding) << i;
    }
}

const char* const kContours[] = {
    "G1 X0 Y0 F500\nX40 RND=5\nY40 CHR=3\nG2 X60 Y60 CR=30 RND=2\nG1 X90 Z-4 CHF=2\nX70 Y70\nX60",
    "G41 G1 X0 Y0 F500 RNDM=4\nX40\nY40\nM8\nX80 Y60\nY90\nRNDM=0\nG40 X100 Y100",
    "G41 G1 X0 Y0 F500\nX40\nY40\nX80 Y60\nG40 X100 Y100",
    "G42 G1 X0 Y0 F500\nX40\nY40\nX80 Y60\nG40 X100 Y100",
    "G41 G1 X0 Y0 F500\nX40\nG3 X60 Y20 CR=20\nG2 X80 Y40 CR=20\nY60\nG40 X100 Y100",
    "G42 G451 G1 X0 Y0 F500\nX40 Z-3\nG3 X60 Y20 Z2 CR=20\nG1 Y60\nX20\nG40 X0 Y100 Z10",
    "KONT G42 G1 X0 Y0 F500\nX40\nX20 Y40\nX0 Y0\nG40 X-20 Y30",
    "KONTT G41 G1 X0 Y0 F500\nX40\nY40\nG40 X100 Y100",
    "CDON G41 G1 X0 Y0 F500\nX40\nY4\nX44\nY40\nG40 X100 Y100",
    "G41 G1 X0 Y0 F500\nX40\nCUTCONON\nX60 Y10\nCUTCONOF\nY40\nG40 X100 Y100",
    "G41 G1 X0 Y0 F500\nX40\nZ-5\nM8\nY40\nOFFN=2\nX80\nG40 X100 Y100",
    "G41 G1 X0 Y0 F500\nG3 X6 Y0 CR=3\nG40 X100 Y100",  // too small: an alarm in both
};

TEST(TiltedCompensation, LiesAsTheFrameDoes) {
    const std::string before = "S1000 M3 T1 D1 M6\nCUT2DF";
    for (const char* frame :
         {"ROT X20", "ROT X25 Y-40 Z70", "ROT Y100", "ROT X20\nATRANS X5 Y7 Z9"}) {
        for (const char* plane : {"G17", "G18", "G19"}) {
            const std::string begin = before + "\n" + plane;
            const std::string tilted = begin + "\n" + frame;
            const Mat3 lie = lie_of("sinumerik", tilted, "M30");
            for (const char* contour : kContours) {
                SCOPED_TRACE(std::string(frame) + " " + plane + "\n" + contour);
                if (std::string(plane) != "G17" && std::string(contour).find('G') != 0) continue;
                const std::string text = std::string("G0 X-30 Y-30 Z5\n") + contour + "\nM30";
                const Ways flat = sample_distances_of("sinumerik", begin, text);
                const Ways turned = sample_distances_of("sinumerik", tilted, text);
                if (std::string(frame).find("ATRANS") == std::string::npos)
                    expect_tilted(flat, turned, lie);
                else EXPECT_EQ(turned.alarms, flat.alarms);
            }
        }
    }
}

TEST(TiltedCompensation, LiesInTheTiltedPlaneOfFanuc) {
    const std::string begin = "%\nO0001\nG10 L12 P1 R5.\nT1 M6 S500 M3";
    const std::string tilted = begin + "\nG68.2 X0 Y0 Z0 I20. J30. K-15.";
    const Mat3 lie = lie_of("fanuc", tilted, "M30\n%");
    for (const char* contour :
         {"G41 D1 G01 X0 Y0 F500.\nX40.\nY40.\nX80. Y60.\nG40 X100. Y100.",
          "G42 D1 G01 X0 Y0 F500.\nX40.\nG03 X60. Y20. R20.\nG01 Y60.\nG39\nX20.\nG40 X0 Y90. I-1. "
          "J0.",
          "G41 D1 G01 X0 Y0 F500.\nX40.\nG38 X50. Y10.\nY40.\nG40 X100. Y100."}) {
        SCOPED_TRACE(contour);
        const std::string text = std::string("G00 X-30. Y-30. Z5.\n") + contour + "\nM30\n%";
        expect_tilted(sample_distances_of("fanuc", begin, text),
                      sample_distances_of("fanuc", tilted, text), lie);
    }
}

/// S 5.2 CUT2D: in the plane of the basic system, whatever frames do; there the arc of a tilted
/// plane is none.
TEST(TiltedCompensation, StaysInTheBasicPlane) {
    const std::string begin = "S1000 M3 T1 D1 M6\nROT X60\nG0 X-20 Y-20 Z0";
    const Ways distances =
        sample_distances_of("sinumerik", begin, "G41 G1 X0 Y0 F500\nX40\nY40\nG40 X80 Y80\nM30");
    EXPECT_EQ(distances.alarms, "");
    ASSERT_EQ(distances.commands.size(), 5u);
    const double rise = std::sin(rad_from_deg(60));
    EXPECT_LT((linear(distances.commands[1].motion().to) - Vec3(0, 5, 0)).norm(), 1e-9);
    EXPECT_LT((linear(distances.commands[2].motion().to) - Vec3(35, 5, 0)).norm(), 1e-9);
    EXPECT_LT((linear(distances.commands[3].motion().to) - Vec3(35, 20, 40 * rise)).norm(), 1e-9);
    const Ways arc = sample_distances_of("sinumerik", begin,
                                         "G41 G1 X0 Y0 F500\nX40\nG3 X60 Y20 CR=20\nG40 X90\nM30");
    EXPECT_NE(arc.alarms, "");
}

/// The plane may not begin to lie otherwise while the cutter is beside a contour (10757).
TEST(TiltedCompensation, EndsBeforeThePlaneTurns) {
    const Ways distances =
        sample_distances_of("sinumerik", "S1000 M3 T1 D1 M6\nCUT2DF\nROT X20",
                            "G41 G1 X0 Y0 F500\nX40\nAROT Y5\nY40\nX60\nG40 X90\nM30");
    EXPECT_NE(distances.alarms.find("10757"), std::string::npos) << distances.alarms;
}

}  // namespace
}  // namespace kadr::interp::tilted_compensation_test
