// Inside corners of the side of a cutter that turns along one of both blocks, or along both (S 5.3
// CUT3DC, motion.md §8.2): at every setpoint the cutter, as a cylinder, keeps out of the contour
// and of the walls that are flat, and at the corner it touches both sides at once.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "tests/driver/scratch.h"

namespace inside_corners_test {

namespace {

using kadr::read_file;
using kadr::test::Row;
using kadr::test::rows_of;
using Vec3 = Eigen::Vector3d;

using InsideCorners = kadr::test::ScratchFolder;

constexpr double kDeepest = 0.002;  // mm
constexpr double kAbove = 12;       // of the contour the cutter still has a side, mm

/// A line of the contour with the tool at its ends.
struct Wall {
    Vec3 from;
    Vec3 to;
    Vec3 first;  // tool, unit vectors
    Vec3 last;
    bool is_flat;  // the tool stays in one plane with the line

    Vec3 along() const { return (to - from).normalized(); }
};

struct Contour {
    bool is_left = true;
    double radius = 0;
    double depth = 0;
    Wall walls[2];

    /// Square to a flat wall, to the side where the cutter is.
    Vec3 normal(const Wall& wall) const {
        const Vec3 right = wall.along().cross(wall.first).normalized();
        return is_left ? Vec3(-right) : right;
    }
};

struct Cutter {
    Vec3 tip;
    Vec3 tool;

    explicit Cutter(const Row& row)
        : tip(row.at("tip_x"), row.at("tip_y"), row.at("tip_z")),
          tool(row.at("tool_i"), row.at("tool_j"), row.at("tool_k")) {}

    /// From its axis, mm.
    double distance(const Vec3& point) const { return (point - tip).cross(tool).norm(); }
    /// Of its side over a flat wall, mm; below it negative.
    double above(const Contour& contour, const Wall& wall) const {
        const Vec3 normal = contour.normal(wall);
        const double inclination = normal.dot(tool);
        const double lowest = std::min(0.0, (contour.depth + kAbove) * inclination);
        return (tip - wall.from).dot(normal) + lowest -
               contour.radius * std::sqrt(std::max(0.0, 1 - inclination * inclination));
    }
    /// Of its side from the nearest point of a line, mm.
    double beside(const Contour& contour, const Wall& wall) const {
        constexpr int kPoints = 400;
        double least = 1e9;
        for (int i = 0; i <= kPoints; ++i)
            least =
                std::min(least, distance(wall.from + i * (wall.to - wall.from) / double{kPoints}));
        return least - contour.radius;
    }
};

std::string words(const char* names, const char* suffix, const Vec3& values) {
    std::ostringstream text;
    text.precision(12);
    for (int i = 0; i < 3; ++i) text << ' ' << names[i] << suffix << values[i];
    return text.str();
}

std::string place(const Vec3& at) { return words("XYZ", "=", at); }
std::string tool(const Vec3& direction) { return words("ABC", "3=", direction); }

std::string program(const Contour& contour) {
    const Wall& a = contour.walls[0];
    const Wall& b = contour.walls[1];
    const Vec3 before = a.from + 20 * contour.normal({a.from, a.to, a.first, a.first, true});
    std::ostringstream text;
    text.precision(12);
    text << "$TC_DP1[1,1]=120\n$TC_DP3[1,1]=60\n$TC_DP6[1,1]=" << contour.radius
         << "\nG17 G40 G90 G94 G54\nT1 D1\nM6\nS6000 M3 F6000\nTRAORI\nORIVECT\nG0" << place(before)
         << tool(a.first) << "\nCUT3DC ISD=" << contour.depth << "\nG1 G4"
         << (contour.is_left ? '1' : '2') << place(a.from) << "\nG1" << place(a.to) << tool(a.last)
         << "\nG1" << place(b.to) << tool(b.last) << "\nG1 G40"
         << place(b.to + 20 * contour.normal({b.from, b.to, b.last, b.last, true}))
         << "\nTRAFOOF\nM30\n";
    return text.str();
}

constexpr double kFirstLine = 13;  // of the contour in the program

/// What turns: the second block, the first, or both in the planes of their walls.
enum class Turns { Second, First, Both };

Contour random_contour(unsigned seed, Turns turns) {
    std::mt19937 random(seed);
    const auto between = [&](double least, double most) {
        return least + (most - least) * (static_cast<std::uint32_t>(random()) / 4294967295.0);
    };
    Contour contour;
    contour.is_left = random() % 2 == 0;
    contour.radius = between(3, 10);
    contour.depth = between(0, 8);
    const double heading = between(-3, 3);
    const double turn = between(0.7, 2.2) * (contour.is_left ? 1 : -1);
    const auto line = [&](double angle) {
        return Vec3(std::cos(angle), std::sin(angle), between(-0.1, 0.1)).normalized();
    };
    const Vec3 in = line(heading);
    const Vec3 out = line(heading + turn);
    const auto leant = [&](double most) {
        return Vec3(between(-most, most), between(-most, most), 1).normalized();
    };
    const Vec3 corner = leant(0.15);
    const auto along = [&](const Vec3& delta) {
        return Vec3(corner + between(-0.3, 0.3) * delta).normalized();
    };
    Vec3 first = corner;
    Vec3 last = corner;
    if (turns == Turns::First) first = leant(0.3);
    if (turns == Turns::Second) last = leant(0.3);
    if (turns == Turns::Both) {
        first = along(in);
        last = along(out);
    }
    const Vec3 from = -between(55, 70) * in;
    const Vec3 to = between(55, 70) * out;
    contour.walls[0] = {from, Vec3::Zero(), first, corner, turns != Turns::First};
    contour.walls[1] = {Vec3::Zero(), to, corner, last, turns != Turns::Second};
    return contour;
}

struct Found {
    int setpoints = 0;
    double deepest = 1e9;    // mm; in the contour or a flat wall where negative
    double corner = 1e9;     // from the farther of both lines where that is nearest
    double standing = 0;     // what is left of the line that is being milled
    double last_tool = 1e9;  // from the tool that is programmed at the end
};

class ATurningCutter : public InsideCorners {
  protected:
    Found mill(const Contour& contour, const char* machine) const {
        Found found;
        save("part.mpf", program(contour));
        const auto result = kadr({"run", file("part.mpf"), "-d", "sinumerik", "-m", machine,
                                  "--setpoints", file("part.csv")});
        EXPECT_EQ(result.status, 0) << result.err << program(contour);
        for (const Row& row : rows_of(read_file(file("part.csv")).value_or("t\n"))) {
            const double line = row.at("iso");
            if (line != kFirstLine && line != kFirstLine + 1) continue;
            look(contour, contour.walls[line == kFirstLine ? 0 : 1], Cutter(row), found);
        }
        return found;
    }

  private:
    static void look(const Contour& contour, const Wall& milled, const Cutter& cutter,
                     Found& found) {
        ++found.setpoints;
        double farther = 0;
        for (const Wall& wall : contour.walls) {
            const double beside = cutter.beside(contour, wall);
            found.deepest = std::min(found.deepest, beside);
            farther = std::max(farther, beside);
            if (wall.is_flat) found.deepest = std::min(found.deepest, cutter.above(contour, wall));
            // Between two points of the line the axis is a little farther away.
            if (&wall == &milled) found.standing = std::max(found.standing, beside);
        }
        found.corner = std::min(found.corner, farther);
        found.last_tool = (cutter.tool - contour.walls[1].last).norm();
    }
};

void expect_clean(const Found& found) {
    EXPECT_GT(found.setpoints, 200);
    EXPECT_GT(found.deepest, -kDeepest);
    EXPECT_LT(found.standing, 0.01);
    EXPECT_LT(found.corner, 0.05);
    EXPECT_LT(found.last_tool, 1e-3);
}

TEST_F(ATurningCutter, KeepsOutOfBothWallsOfRandomCorners) {
    const char* const machines[] = {"trunnion-ac", "head-cb", "trunnion-bc"};
    for (unsigned seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE(seed);
        const Turns turns = static_cast<Turns>(seed % 3);
        expect_clean(mill(random_contour(seed, turns), machines[seed / 3 % 3]));
    }
}

/// An upright cutter that begins to lean behind the corner: there it stands upright, as far from
/// both lines as it is thick.
TEST_F(ATurningCutter, StandsAtTheCornerAsThatIsProgrammed) {
    const struct {
        double radius, depth;
        Vec3 last;
    } cases[] = {{10, 6, {-0.8, 0.2, 1}},
                 {8, 20, {-0.36, 0, 1}},
                 {10, 0, {-0.8, 0.2, 1}},
                 {10, 6, {0.5, 0.5, 1}}};
    for (const auto& at : cases) {
        SCOPED_TRACE(::testing::Message() << at.radius << ' ' << at.depth);
        Contour contour{true, at.radius, at.depth, {}};
        const Vec3 up = Vec3::UnitZ();
        contour.walls[0] = {{0, 0, 0}, {40, 0, 0}, up, up, true};
        contour.walls[1] = {{40, 0, 0}, {40, 40, 0}, up, at.last.normalized(), false};
        expect_clean(mill(contour, "trunnion-bc"));
        double farthest = 0;
        for (const Row& row : rows_of(read_file(file("part.csv")).value_or("t\n"))) {
            if (row.at("iso") == kFirstLine) farthest = std::max(farthest, row.at("tip_x"));
        }
        EXPECT_NEAR(farthest, 40 - at.radius, 1e-3);
    }
}

}  // namespace

}  // namespace inside_corners_test
