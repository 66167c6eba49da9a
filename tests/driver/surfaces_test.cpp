// Surfaces milled with the end of a cutter (S 5.3 CUT3DF): at every setpoint the cutter, as a body,
// is as far from the surface as the program says.
//
// The body is the core of the mill, a cylinder from its rounding up, thickened by the radius of the
// rounding. How far a sphere, a plane or a point is from it has nothing to do with how the
// compensation finds the tip.
#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "tests/driver/scratch.h"

namespace surfaces_test {

namespace {

using kadr::read_file;
using kadr::test::Row;
using kadr::test::rows_of;
using Vec3 = Eigen::Vector3d;

using Surfaces = kadr::test::ScratchFolder;

struct Mill {
    const char* name;
    int type;
    double radius;
    double edge;  // radius of its rounding
};

const Mill kMills[] = {
    {"ball nose", 110, 5, 5}, {"bull nose", 121, 5, 1.5}, {"end mill", 120, 5, 0}};

/// Where a mill is at a setpoint.
struct Body {
    Mill mill;
    Vec3 tip;
    Vec3 tool;

    Body(const Mill& of, const Row& row)
        : mill(of),
          tip(row.at("tip_x"), row.at("tip_y"), row.at("tip_z")),
          tool(row.at("tool_i"), row.at("tool_j"), row.at("tool_k")) {}

    /// Of a point outside of the mill, mm.
    double distance(const Vec3& point) const {
        const double height = (point - tip).dot(tool);
        const double away = (point - tip - height * tool).norm();
        const double below = std::max(0.0, mill.edge - height);
        const double beside = std::max(0.0, away - (mill.radius - mill.edge));
        return std::hypot(below, beside) - mill.edge;
    }
    /// Of the mill's lowest place above a plane, mm; below it negative.
    double above(const Vec3& place, const Vec3& normal) const {
        const double along = normal.dot(tool);
        return (tip - place).dot(normal) + mill.edge * (along - 1) -
               (mill.radius - mill.edge) * std::sqrt(std::max(0.0, 1 - along * along));
    }
};

/// Lines of a text that are marked, from 1.
std::set<int> marked(const std::string& text, const std::string& by) {
    std::set<int> found;
    std::istringstream lines(text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (line.find(by) != std::string::npos) found.insert(number);
    }
    return found;
}

std::string with_tool(const Mill& mill, const std::string& text) {
    std::ostringstream whole;
    whole << "$TC_DP1[1,1]=" << mill.type << "\n$TC_DP3[1,1]=60\n$TC_DP6[1,1]=" << mill.radius
          << "\n$TC_DP7[1,1]=" << mill.edge << "\nG17 G40 G90 G94 G54\nT1 D1\nM6\nS6000 M3 F1500\n"
          << text << "\nM30\n";
    return whole.str();
}

struct Seen {
    int setpoints = 0;
    double least = 1e9;
    double most = -1e9;
};

const std::string kSphere =
    "TRAORI\nORIVECT\nR1=30*SIN(60) R2=30*COS(60)-30\n"
    "G0 X45 Y0 Z20 A3=0.6 B3=0.5 C3=0.8\nCUT3DF\nG18\n"
    "G1 G41 X=R1 Y0 Z=R2\n"
    "G2 X0 Z0 I=AC(0) K=AC(-30) A4=SIN(60) C4=COS(60) C5=1 A3=0.2 B3=0.6 C3=1 ; on it\n"
    "G2 X=-R1 Z=R2 I=AC(0) K=AC(-30) A5=-SIN(60) C5=COS(60) A3=-0.5 B3=0.4 C3=0.7 ; on it\n"
    "G1 G40 X-60 Z30\nG0 Z60\nG0 X0 Y-45 A3=0.3 B3=-0.4 C3=1\nG19\n"
    "G1 G42 X0 Y=-R1 Z=R2\n"
    "G2 Y0 Z0 J=AC(0) K=AC(-30) B4=-SIN(60) C4=COS(60) C5=1 A3=0.3 B3=0.1 C3=1 ; on it\n"
    "G1 G40 Z40\nTRAFOOF";

class OnEveryMill : public Surfaces {
  protected:
    using Clearance = std::function<double(const Body&)>;

    Seen walk(const Mill& mill, const std::string& text, const char* machine,
              const Clearance& clearance) const {
        return walk_whole(mill, with_tool(mill, text), machine, "; on it", clearance);
    }
    Seen walk_whole(const Mill& mill, const std::string& text, const char* machine,
                    const std::string& by, const Clearance& clearance) const {
        save("part.mpf", text);
        const auto result = kadr({"run", file("part.mpf"), "-d", "sinumerik", "-m", machine,
                                  "--setpoints", file("part.csv")});
        EXPECT_EQ(result.status, 0) << result.err;
        const std::set<int> lines = marked(text, by);
        Seen seen;
        for (const Row& row : rows_of(read_file(file("part.csv")).value_or("t\n"))) {
            if (!lines.contains(static_cast<int>(row.at("iso")))) continue;
            ++seen.setpoints;
            const double clear = clearance(Body(mill, row));
            seen.least = std::min(seen.least, clear);
            seen.most = std::max(seen.most, clear);
        }
        return seen;
    }
    /// All along, with every mill on each of the machines, as much is clear as is wanted, mm.
    void expect_clear(const std::string& text, std::initializer_list<const char*> machines,
                      double wanted, double tolerance, const Clearance& clearance) const {
        for (const Mill& mill : kMills) {
            for (const char* machine : machines) {
                SCOPED_TRACE(std::string(mill.name) + " on " + machine);
                const Seen seen = walk(mill, text, machine, clearance);
                EXPECT_GT(seen.setpoints, 500);
                EXPECT_GT(seen.least, wanted - tolerance);
                EXPECT_LT(seen.most, wanted + tolerance);
            }
        }
    }
};

double above_sphere(const Body& body) { return body.distance({0, 0, -30}) - 30; }

TEST_F(OnEveryMill, ASphereIsTouchedAllAlong) {
    expect_clear(kSphere, {"trunnion-ac", "head-ab", "mixed-cb"}, 0, 1e-6, above_sphere);
}

TEST_F(OnEveryMill, AnAllowanceIsLeftOnTheSphere) {
    expect_clear("OFFN=0.4\n" + kSphere, {"trunnion-bc"}, 0.4, 1e-6, above_sphere);
}

TEST_F(OnEveryMill, TheCapOfTheExamplesIsTouchedOnEveryMeridian) {
    const std::string text = read_file(KADR_ROOT "/examples/cap.mpf").value();
    for (const char* machine : {"trunnion-ac", "head-cb"}) {
        SCOPED_TRACE(machine);
        const Seen seen =
            walk_whole({"bull nose", 121, 6, 3}, text, machine, "I=AC(0)", [](const Body& body) {
                return body.distance({0, 0, -60}) - 60;
            });
        EXPECT_GT(seen.setpoints, 12000);
        EXPECT_GT(seen.least, -1e-6);
        EXPECT_LT(seen.most, 1e-6);
    }
}

/// The plane 0.3 X + 0.2 Y + Z = 0, with a tool that turns along lines and at a corner.
TEST_F(OnEveryMill, ATiltedPlaneIsTouchedAllAlong) {
    const std::string normal = " A4=0.3 B4=0.2 C4=1";
    const std::string text = "TRAORI\nG0 X-30 Y-10 Z40 A3=0.5 C3=1\nCUT3DF\nG1 G41 X-20 Y0 Z6" +
                             normal + "\nX20 Y0 Z-6 A3=0.2 B3=0.6 C3=1" + normal +
                             " ; on it\nA3=-0.2 B3=0.6 C3=1" + normal + " ; on it\nX20 Y20 Z-10" +
                             normal + " ; on it\nX-20 Y10 Z4 A3=0.5 B3=0.5 C3=1" + normal +
                             " ; on it\nG40 Z60\nTRAFOOF";
    const Vec3 up = Vec3(0.3, 0.2, 1).normalized();
    expect_clear(text, {"trunnion-ac", "head-cb"}, 0, 1e-6,
                 [&](const Body& body) { return body.above(Vec3::Zero(), up); });
}

/// Up one side of a roof and down the other: at the ridge the mill touches the ridge.
TEST_F(OnEveryMill, ARidgeIsRolledAround) {
    const std::string text =
        "TRAORI\nG0 X-30 Y0 Z20 A3=0.1 B3=0.3 C3=1\nCUT3DF\nG1 G41 X-20 Y0 Z-10\n"
        "X0 Z0 A4=-0.5 C4=1 ; on it\nX20 Z-10 A4=0.5 C4=1 ; on it\nG40 Z40\nTRAFOOF";
    const Vec3 first = Vec3(-0.5, 0, 1).normalized();
    const Vec3 second = Vec3(0.5, 0, 1).normalized();
    for (const Mill& mill : kMills) {
        SCOPED_TRACE(mill.name);
        int rolled = 0;
        const Seen seen = walk(mill, text, "trunnion-ac", [&](const Body& body) {
            const double away[] = {std::abs(body.above(Vec3::Zero(), first)),
                                   std::abs(body.above(Vec3::Zero(), second))};
            const double flat = std::min(away[0], away[1]);
            if (flat < 1e-6) return flat;
            ++rolled;
            return std::abs(body.distance(Vec3::Zero()));
        });
        EXPECT_GT(seen.setpoints, 500);
        EXPECT_LT(seen.most, 1e-6);
        EXPECT_GT(rolled, 10);
    }
}

/// Down into a groove and up again: neither side is cut into.
TEST_F(OnEveryMill, InAGrooveBothSidesAreKeptTo) {
    const std::string text =
        "TRAORI\nG0 X-30 Y0 Z30 C3=1\nCUT3DF\nG1 G41 X-20 Y0 Z10\n"
        "X0 Z0 A4=0.5 C4=1 ; on it\nX20 Z10 A4=-0.5 C4=1 ; on it\nG40 Z40\nTRAFOOF";
    const Vec3 first = Vec3(0.5, 0, 1).normalized();
    const Vec3 second = Vec3(-0.5, 0, 1).normalized();
    for (const Mill& mill : kMills) {
        SCOPED_TRACE(mill.name);
        const Seen seen = walk(mill, text, "trunnion-ac", [&](const Body& body) {
            return std::min(body.above(Vec3::Zero(), first), body.above(Vec3::Zero(), second));
        });
        EXPECT_GT(seen.setpoints, 300);
        EXPECT_GT(seen.least, -1e-6);
        EXPECT_LT(seen.most, 1e-6);
    }
}

/// On a floor and up a slope, with a tool that turns on both: where it stands in the edge between
/// them it touches both, and it turns on from there.
TEST_F(OnEveryMill, InAHollowEdgeATurningMillKeepsToBothSides) {
    // The tool stands upright, at the pole of the machine, where it is led a little beside its way.
    constexpr double kBesidePole = 2e-4;
    const struct {
        const char* floor;
        const char* slope;
        Vec3 first, second;
    } cases[] = {
        {"X0 Z0 A4=0 C4=1", "X20 Z20 A4=-1 C4=1 A3=-0.7 C3=1", {0, 0, 1}, {-1, 0, 1}},
        {"X0 Z0 A4=0 C4=1 A3=-0.1 C3=1", "X20 Z20 A4=-1 C4=1 A3=-0.6 C3=1", {0, 0, 1}, {-1, 0, 1}},
        {"X0 Z0 A4=0 C4=1 A3=0.7 C3=1", "X20 Z20 A4=-1 C4=1 A3=-0.3 C3=1", {0, 0, 1}, {-1, 0, 1}}};
    for (const auto& at : cases) {
        for (const Mill& mill : kMills) {
            SCOPED_TRACE(std::string(mill.name) + ", " + at.floor);
            const std::string text =
                "TRAORI\nORIVECT\nG0 X-50 Y0 Z30 C3=1\nCUT3DF\nG1 G41 X-40 Y0 Z0 C5=1\n" +
                std::string(at.floor) + " ; on it\n" + at.slope + " ; on it\nG40 Z60\nTRAFOOF";
            const Seen seen = walk(mill, text, "trunnion-bc", [&](const Body& body) {
                return std::min(body.above(Vec3::Zero(), at.first.normalized()),
                                body.above(Vec3::Zero(), at.second.normalized()));
            });
            EXPECT_GT(seen.setpoints, 300);
            EXPECT_GT(seen.least, -kBesidePole);
            EXPECT_LT(seen.most, kBesidePole);
        }
    }
}

/// Three axes: the tool stands, the sphere turns under it. Over the pole a face slides. The plane
/// stays, for the length of the tool lies across it.
TEST_F(OnEveryMill, ThreeAxesKeepToTheSphereToo) {
    const std::string text =
        "R1=30*SIN(50) R2=30*COS(50)-30 R3=30*SIN(25) R4=30*COS(25)-30\nG0 X40 Y0 Z20\nCUT3DFF\nG1 "
        "G41 X=R1 Y0 Z=R2\n"
        "CIP X0 Z0 I1=R3 K1=R4 A4=SIN(50) C4=COS(50) C5=1 ; on it\n"
        "CIP X=-R1 Z=R2 I1=-R3 K1=R4 A5=-SIN(50) C5=COS(50) ; on it\nG1 G40 X-60 Z30";
    // The splines keep to a nanometre.
    expect_clear(text, {"mill", "trunnion-ac"}, 0, 2e-6, above_sphere);
}

}  // namespace

}  // namespace surfaces_test
