// The same orientation program by hand in the languages of three controls, each in its own way of
// saying it: by angles, by vectors and by I, J, K. Tip and tool go the same ways on a table and
// under a head. Blocks end at rest, so that no tick cuts a corner.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "tests/driver/same_paths.h"

namespace same_orientation_test {

namespace {

using kadr::test::Way;

using SameOrientation = kadr::test::ScratchFolder;

// Directions by azimuth and tilt: 30° 20°, 150° 25°, 200° 10°, and through the pole to 20° 10°.
// AxiOMA: ORIEULER turns about Z, Y', Z'', so that the angles are azimuth and tilt.
const std::string kAxioma = R"(G17 G54 G90 G60
T1 D1 M6
S8000 M3
TRAORI
ORIWKS ORIEULER ORIVECT
G0 X0 Y0 Z60 A2=0 B2=0
G1 Z2 F2000
X40 A2=30 B2=20
G3 X60 Y20 CR=20
G1 A2=150 B2=25 F3000
X20 Y40 Z8 A2=200 B2=10 F2000
G2 X0 Y20 CR=20
G1 X0 Y0 A2=20 B2=10
ORIAXES
X10 A2=0 B2=0
G0 Z80
TRAFOOF
M30
)";

// SINUMERIK: by vectors, and by its ORIEULER about Z, X', Z'', whose first angle is greater by 90°.
const std::string kSinumerik = R"(N10 G17 G54 G90 G60
N20 T1 D1 M6
N30 S8000 M3
N40 TRAORI
N50 ORIWKS ORIVECT
N60 G0 X0 Y0 Z60 C3=1
N70 G1 Z2 F2000
N80 X40 A3=0.296198133 B3=0.171010072 C3=0.939692621
N90 G3 X60 Y20 I=AC(40) J=AC(20)
N100 ORIEULER
N110 G1 A2=240 B2=25 F3000
N120 X20 Y40 Z8 A2=290 B2=10 F2000
N130 G2 X0 Y20 I=AC(0) J=AC(40) B3=-0.059391175 A3=-0.163175911 C3=0.984807753
N140 G1 X0 Y0 A3=0.163175911 B3=0.059391175 C3=0.984807753
N150 ORIAXES
N160 X10 C3=1
N170 G0 Z80
N180 TRAFOOF
N190 M30
)";

// FANUC: vectors of any length under G43.5; arcs under G43.4, where I, J and K are no vector.
const std::string kFanuc = R"(%
O0001
G17 G54 G90 G61
T1 M06
S8000 M03
G43.5 H01 P1
G00 X0. Y0. Z60. K1.
G01 Z2. F2000.
X40. I2961.981 J1710.101 K9396.926
G43.4 H01
G03 X60. Y20. R20.
G43.5 H01 P1
G01 I-3659.982 J2113.091 K9063.078 F3000.
X20. Y40. Z8. I-1631.759 J-593.912 K9848.078 F2000.
G43.4 H01
G02 X0. Y20. R20.
G43.5 H01 P1
G01 X0. Y0. I1631.759 J593.912 K9848.078
G43.5 H01 P0
X10. K1.
G00 Z80.
G49
M30
%
)";

/// The ticks below a height: what a control does before the way down and behind the way up is its
/// own.
std::vector<Way> below(double height, const std::vector<Way>& all) {
    std::vector<Way> found;
    std::copy_if(all.begin(), all.end(), std::back_inserter(found),
                 [=](const Way& way) { return way.tip.z() < height; });
    return found;
}

TEST_F(SameOrientation, ThreeLanguagesLeadTipAndToolAlike) {
    save("part.nc", kAxioma);
    save("part.mpf", kSinumerik);
    save("part.fanuc", kFanuc);
    for (const std::string machine : {"trunnion-ac", "head-cb"}) {
        std::vector<Way> first;
        for (const auto& [text, control] :
             {std::pair("part.mpf", "sinumerik"), std::pair("part.nc", "axioma"),
              std::pair("part.fanuc", "fanuc")}) {
            SCOPED_TRACE(std::string(control) + " on " + machine);
            const auto result = kadr(
                {"run", file(text), "-d", control, "-m", machine, "--setpoints", file("all.csv")});
            ASSERT_EQ(result.status, 0) << result.err;
            const auto all =
                kadr::test::sample_distances_of(kadr::read_file(file("all.csv")).value_or(""));
            const auto now = below(50, all);
            ASSERT_GT(now.size(), 1000u);
            if (first.empty()) first = now;
            expect_same_paths(below(45, now), first);
            expect_same_paths(below(45, first), now);
        }
        // What the text says, by hand: quarters of circles with the tool standing at its azimuth
        // and tilt, a turn about a point in the plane of both directions.
        const double deg = std::acos(-1) / 180;
        const auto direction = [&](double azimuth, double tilt) {
            return Eigen::Vector3d(std::cos(azimuth * deg) * std::sin(tilt * deg),
                                   std::sin(azimuth * deg) * std::sin(tilt * deg),
                                   std::cos(tilt * deg));
        };
        const Eigen::Vector3d normal = direction(30, 20).cross(direction(150, 25)).normalized();
        int on_arcs = 0, turning = 0;
        for (const Way& way : first) {
            if (way.line == 9 || way.line == 13) {
                ++on_arcs;
                const Eigen::Vector3d center =
                    way.line == 9 ? Eigen::Vector3d(40, 20, 2) : Eigen::Vector3d(0, 40, 8);
                EXPECT_NEAR((way.tip - center).norm(), 20, 1e-3);
                const Eigen::Vector3d stands =
                    way.line == 9 ? direction(30, 20) : direction(200, 10);
                EXPECT_LT((way.tool - stands).norm(), 1e-6);
            } else if (way.line == 11) {
                ++turning;
                EXPECT_LT((way.tip - Eigen::Vector3d(60, 20, 2)).norm(), 1e-3);
                EXPECT_LT(std::abs(way.tool.dot(normal)), 1e-6);
            }
        }
        EXPECT_GT(on_arcs, 500);
        EXPECT_GT(turning, 100);
    }
}

}  // namespace

}  // namespace same_orientation_test
