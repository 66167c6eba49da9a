// Arcs against tests/oracles/curves.json, type arc, and the faults that have no oracle.
#include "path/arc.h"

#include <fstream>
#include <map>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "tests/path/oracle_arcs.h"

namespace kadr::path::arc_test {
namespace {

using test::arc_of;
using test::Json;
using test::vec3;

/// The oracle's words for a fault.
const std::map<std::string, ArcFault> kFaults = {
    {"end point not on the circle", ArcFault::RadiusMismatch},
    {"no centre", ArcFault::RadiusTooSmall},
    {"centre undefined", ArcFault::NoChord},
    {"collinear", ArcFault::Collinear},
    {"end point straight behind", ArcFault::Backwards},
};

TEST(Arc, CasesOfTheOracle) {
    std::ifstream file(KADR_ROOT "/tests/oracles/curves.json");
    int arcs = 0;
    const Json oracle = Json::parse(file);
    for (const Json& test : oracle["cases"]) {
        if (test["type"] != "arc") continue;
        SCOPED_TRACE(test["id"].get<std::string>());
        ++arcs;
        const Result<Arc, ArcFault> arc = arc_of(test["input"]);
        const Json& expected = test["expect"];
        if (expected.contains("alarm")) {
            ASSERT_FALSE(arc);
            EXPECT_EQ(arc.error(), kFaults.at(expected["alarm"]));
            continue;
        }
        ASSERT_TRUE(arc);
        EXPECT_NEAR(arc->sweep, test["u_range"][1].get<double>(), 1e-9);
        EXPECT_NEAR(arc->sweep, expected["sweep_rad"].get<double>(), 1e-9);
        EXPECT_LT((arc->center - vec3(expected["center"])).norm(), 1e-9);
        EXPECT_NEAR(measures_of(*arc).start_radius, expected["radius_start"].get<double>(), 1e-9);
        EXPECT_NEAR(measures_of(*arc).end_radius, expected["radius_end"].get<double>(), 1e-9);
        if (expected.contains("axis")) {
            EXPECT_LT((arc->normal - vec3(expected["axis"])).norm(), 1e-9);
        }
        for (const Json& sample : expected["samples"]) {
            const ArcPoint point = point_at(*arc, sample["u"]);
            EXPECT_LT((point.position - vec3(sample["C"])).norm(), 1e-9);
            EXPECT_LT((point.first - vec3(sample["C1"])).norm(), 1e-9 * point.first.norm());
            EXPECT_LT((point.second - vec3(sample["C2"])).norm(), 1e-8 * point.second.norm());
        }
        EXPECT_NEAR(length_of(*arc), expected["length"].get<double>(), 1e-7);
    }
    EXPECT_EQ(arcs, 24);
}

TEST(Arc, ShiftedCenterKeepsTheStartRadius) {
    // SINUMERIK, start 20,0: `G3 X0 Y20.01 I-20 J0` moves the centre to about 0,0.01.
    const ArcTolerance tolerance{0.01, 1e-3, RadiusError::ShiftCenter};
    const Result<Arc, ArcFault> arc =
        arc_about_center({{20, 0, 0}, {0, 20.01, 0}}, {0, 0, 0}, {}, tolerance);
    ASSERT_TRUE(arc);
    EXPECT_LT((arc->center - Vec3(0, 0.01, 0)).norm(), 1e-4);
    EXPECT_NEAR(measures_of(*arc).start_radius, 20, 1e-12);
    EXPECT_NEAR(measures_of(*arc).end_radius, 20, 1e-12);
}

TEST(Arc, Faults) {
    const ArcTolerance shift{0.01, 1e-3, RadiusError::ShiftCenter};
    const ArcTurning many{Plane::Xy, false, kMaxTurns + 1};
    struct Row {
        const char* name;
        Result<Arc, ArcFault> arc;
        ArcFault expected;
    };
    for (const Row& row :
         {Row{"centre at the start", arc_about_center({{1, 2, 0}, {3, 4, 0}}, {1, 2, 5}, {}, {}),
              ArcFault::NoRadius},
          // radii 20 and 20.05, limit max(0.01, 0.02)
          {"14040", arc_about_center({{20, 0, 0}, {0, 20.05, 0}}, {0, 0, 0}, {}, shift),
           ArcFault::RadiusMismatch},
          // almost a full turn, end 0.005 too far out: the centre would have to turn by 90 degrees
          {"shift too large", arc_about_center({{20, 0, 0}, {20.005, 0, 0}}, {0, 0, 0}, {}, shift),
           ArcFault::RadiusMismatch},
          {"turns", arc_about_center({{20, 0, 0}, {0, 20, 0}}, {0, 0, 0}, many, {}),
           ArcFault::BadTurns},
          {"turns by radius", arc_of_radius({{20, 0, 0}, {0, 20, 0}}, 20, many),
           ArcFault::BadTurns},
          {"through a point between", arc_through({{0, 0, 0}, {4, 4, 4}}, {1, 1, 1}),
           ArcFault::Straight},
          {"over a point beyond all numbers", arc_through({{-20, 0, 0}, {20, 0, 0}}, {0, -1e90, 0}),
           ArcFault::Collinear},
          {"through the start", arc_through({{0, 0, 0}, {0, 0, 0}}, {0, 0, 0}),
           ArcFault::Collinear},
          {"straight on", arc_along_tangent({{0, 0, 0}, {5, 0, 0}}, {2, 0, 0}), ArcFault::Straight},
          {"tangent, no way", arc_along_tangent({{1, 0, 0}, {1, 0, 0}}, {2, 0, 0}),
           ArcFault::NoChord}}) {
        SCOPED_TRACE(row.name);
        ASSERT_FALSE(row.arc);
        EXPECT_EQ(row.arc.error(), row.expected);
    }
}

TEST(Arc, HelixOfTwoTurnsAndAQuarter) {
    // Start 20,0,0: `G3 X0 Y20 I-20 J0 Z-9 TURN=2`; length sqrt((20·4.5π)² + 9²) = 282.887
    const Result<Arc, ArcFault> arc =
        arc_about_center({{20, 0, 0}, {0, 20, -9}}, {0, 0, 0}, {Plane::Xy, false, 2}, {});
    ASSERT_TRUE(arc);
    EXPECT_NEAR(arc->sweep, 4.5 * std::numbers::pi, 1e-12);
    EXPECT_NEAR(length_of(*arc), 282.887, 5e-4);
}

TEST(Arc, LengthOfASpiral) {
    // r from 0 excluded: 1 to 3 in one turn; |C'| = sqrt(r² + g²), g = 2/2π, summed finely.
    Arc arc;
    arc.start = {1, 0, 0};
    arc.end = {3, 0, 0};
    arc.sweep = 2 * std::numbers::pi;
    double sum = 0;
    const int steps = 20000;
    for (int i = 0; i < steps; ++i) {
        sum += point_at(arc, (i + 0.5) / steps * arc.sweep).first.norm() * arc.sweep / steps;
    }
    EXPECT_NEAR(length_of(arc), sum, 1e-7);
}

}  // namespace
}  // namespace kadr::path::arc_test
