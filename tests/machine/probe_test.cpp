// Where the ball of a touch probe first meets the material.
#include "machine/probe.h"

#include <cmath>

#include <gtest/gtest.h>

#include "machine/machine.h"

namespace kadr::machine::probe_test {
namespace {

using path::Vec3;

ProbeSolid block(const Vec3& from, const Vec3& to) {
    ProbeSolid out;
    out.from = from;
    out.to = to;
    return out;
}

ProbeSolid plane(std::size_t axis, double at, bool is_above) {
    ProbeSolid out;
    out.kind = ProbeSolid::Kind::Plane;
    out.axis = axis;
    out.at = at;
    out.is_above = is_above;
    return out;
}

ProbeSolid boss(const Vec3& center, double radius, double height) {
    ProbeSolid out;
    out.kind = ProbeSolid::Kind::Boss;
    out.from = center;
    out.radius = radius;
    out.height = height;
    return out;
}

ProbeScene scene_of(std::vector<ProbeSolid> solids, std::vector<ProbeBore> bores = {}) {
    ProbeScene scene;
    scene.solids = std::move(solids);
    scene.bores = std::move(bores);
    return scene;
}

constexpr double kNever = -1;

TEST(Probe, FirstTouch) {
    const ProbeScene face = scene_of({plane(2, 0, false)});
    const ProbeScene wall = scene_of({plane(0, 30, true)});
    const ProbeScene cuboid = scene_of({block({0, 0, -20}, {50, 40, 0})});
    const ProbeScene stud = scene_of({boss({0, 0, 0}, 10, 15)});
    const ProbeScene hole = scene_of({}, {{{0, 0, 0}, 20, 25}});
    const ProbeScene bored = scene_of({block({-60, -60, -30}, {60, 60, 0})}, {{{0, 0, 0}, 20, 25}});
    const double slope = std::sqrt(2);
    struct Row {
        const char* name;
        const ProbeScene& scene;
        Vec3 from, to;
        double radius;
        double distance;  // mm; kNever: none
    };
    for (const Row& row : {
             Row{"down onto a face", face, {0, 0, 10}, {0, 0, -10}, 3, 7},
             Row{"a point down onto it", face, {0, 0, 10}, {0, 0, -10}, 0, 10},
             // The centre is 3 above the face after 7 down, on a slope of 45 deg 7·√2.
             Row{"aslant onto it", face, {0, 0, 10}, {20, 0, -10}, 3, 7 * slope},
             Row{"not down to it", face, {0, 0, 10}, {0, 0, 3.001}, 3, kNever},
             Row{"just down to it", face, {0, 0, 10}, {0, 0, 3}, 3, 7},
             Row{"along it", face, {0, 0, 4}, {500, 0, 4}, 3, kNever},
             Row{"up from it", face, {0, 0, 3}, {0, 0, 9}, 3, kNever},
             Row{"along it, standing on it", face, {0, 0, 3}, {10, 0, 3}, 3, 0},
             Row{"on into it", face, {0, 0, 3}, {0, 0, 1}, 3, 0},
             Row{"against a wall", wall, {0, 0, 0}, {50, 0, 0}, 2.5, 27.5},
             Row{"away from a wall", wall, {20, 0, 0}, {-50, 0, 0}, 2.5, kNever},
             Row{"a cuboid from its side", cuboid, {-20, 20, -5}, {20, 20, -5}, 3, 17},
             Row{"from above", cuboid, {25, 20, 10}, {25, 20, -10}, 3, 7},
             Row{"beside it", cuboid, {-4, 20, 10}, {-4, 20, -10}, 3, kNever},
             // Beside the edge by 2 the ball of 3 stands √(9 − 4) over it.
             Row{"on its edge", cuboid, {-2, 20, 10}, {-2, 20, -10}, 3, 10 - std::sqrt(5)},
             Row{"a boss from outside", stud, {-30, 0, -5}, {30, 0, -5}, 3, 17},
             Row{"a boss from above", stud, {4, 3, 10}, {4, 3, -10}, 3, 7},
             Row{"below a boss", stud, {-30, 0, -19}, {30, 0, -19}, 3, kNever},
             Row{"a bore from inside", hole, {0, 0, -5}, {30, 0, -5}, 3, 17},
             Row{"a bore off its middle", hole, {5, 0, -5}, {-30, 0, -5}, 3, 22},
             Row{"down into a bore", hole, {0, 0, 10}, {0, 0, -40}, 3, 32},
             Row{"beside a bore", hole, {40, 0, 10}, {40, 0, -10}, 3, 7},
             Row{"a bore in a block", bored, {0, 0, -5}, {0, 30, -5}, 3, 17},
             Row{"over a block", bored, {0, 0, 5}, {100, 0, 5}, 3, kNever},
         }) {
        SCOPED_TRACE(row.name);
        const auto part = first_touch(row.scene, row.from, row.to, row.radius);
        ASSERT_EQ(part.has_value(), row.distance != kNever);
        if (part) {
            EXPECT_NEAR(*part * (row.to - row.from).norm(), row.distance, 1e-8);
        }
    }
}

TEST(Probe, Release) {
    const ProbeScene face = scene_of({plane(2, 0, false)});
    const auto part = first_release(face, {0, 0, 2}, {0, 0, 12}, 3);
    ASSERT_TRUE(part.has_value());
    EXPECT_NEAR(*part, 0.1, 1e-9);
    EXPECT_FALSE(first_release(face, {0, 0, 5}, {0, 0, 12}, 3).has_value()) << "it was free";
    EXPECT_FALSE(first_release(face, {0, 0, 1}, {0, 0, 2}, 3).has_value()) << "it stays";
}

}  // namespace
}  // namespace kadr::machine::probe_test
