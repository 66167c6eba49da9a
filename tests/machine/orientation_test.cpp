#include "machine/orientation.h"

#include <random>

#include "tests/machine/support.h"

namespace kadr::machine::orientation_test {
namespace {

using test::json;

constexpr double kVector = 1e-7;  // tolerance of the oracle

Vec3 unit(const json& list) { return test::vec(list).normalized(); }

template <typename Check>
void for_each_case(const char* kind, int expected, Check check) {
    test::for_each_case("orientation.json", kind, expected, check);
}

/// The pairs that name a direction, as a set: each expected one is among those found.
void expect_pairs(const AnglePair& found, const json& expected, Eigen::Index first,
                  Eigen::Index second) {
    ASSERT_GE(expected.size(), 1u);
    for (const json& pair : expected) {
        const bool is_there = std::any_of(found.begin(), found.end(), [&](const Vec3& angles) {
            return test::apart(angles[first], test::rad(pair[0])) < test::kAngleTolerance &&
                   test::apart(angles[second], test::rad(pair[1])) < test::kAngleTolerance;
        });
        EXPECT_TRUE(is_there) << pair;
    }
}

template <typename Matrix, typename Back>
void check_euler(const char* kind, std::array<const char*, 3> names, Matrix make, Back back) {
    for_each_case(kind, 8, [&](const json& in, const json& expect) {
        const Vec3 angles = {test::rad(in[names[0]]), test::rad(in[names[1]]),
                             test::rad(in[names[2]])};
        const Mat3 rotation = make(angles);
        EXPECT_LT((rotation - test::matrix(expect["matrix_rows"])).norm(), kVector);
        EXPECT_LT((rotation.col(2) - test::vec(expect["vector"])).norm(), kVector);
        const AnglePair pair = back(rotation);
        for (const Vec3& again : pair) EXPECT_LT((make(again) - rotation).norm(), 1e-9);
        for (const auto& [key, value] : expect.items()) {
            if (key.starts_with("pairs")) expect_pairs(pair, value, 0, 1);
        }
    });
}

TEST(Orientation, EulerOracle) {
    check_euler("euler_ZY1Z2", {"phi", "theta", "psi"}, euler_zyz, euler_zyz_of);
    check_euler("orieuler_ZX1Z2", {"A2", "B2", "C2"}, euler_zxz, euler_zxz_of);
}

TEST(Orientation, RpyOracle) {
    for_each_case("orirpy_ZY1X2", 8, [](const json& in, const json& expect) {
        const Mat3 rotation =
            rpy_zyx({test::rad(in["A2"]), test::rad(in["B2"]), test::rad(in["C2"])});
        EXPECT_LT((rotation - test::matrix(expect["matrix_rows"])).norm(), kVector);
        EXPECT_LT((rotation.col(2) - test::vec(expect["vector"])).norm(), kVector);
    });
    for_each_case("vector_to_RPY_with_C2_0", 5, [](const json& in, const json& expect) {
        const Vec3 direction = unit(in["vector"]);
        const AnglePair pair = rpy_of_direction(direction);
        expect_pairs(pair, expect["pairs_A2_B2"], 0, 1);
        for (const Vec3& angles : pair)
            EXPECT_LT((rpy_zyx(angles).col(2) - direction).norm(), 1e-12);
    });
}

// w = (sin B, −sin A cos B, cos A cos B), sinumerik.md 7.3.
TEST(Orientation, Rpy2TurnsAboutXFirst) {
    const double a = 0.3;
    const double b = -0.7;
    const Vec3 expected = {std::sin(b), -std::sin(a) * std::cos(b), std::cos(a) * std::cos(b)};
    EXPECT_LT((rpy_xyz({a, b, 1.1}).col(2) - expected).norm(), 1e-15);
}

TEST(Orientation, LeadTiltOracle) {
    for_each_case("LEAD_TILT", 8, [](const json& in, const json& expect) {
        for (const TiltAbout about : {TiltAbout::Normal, TiltAbout::Tangent}) {
            const LeadTilt angles = {test::rad(in["LEAD"]), test::rad(in["TILT"]), about};
            const Varying tangent = {test::vec(in["tangent"]), Vec3::Zero()};
            const Varying normal = {test::vec(in["normal"]), Vec3::Zero()};
            const auto found = by_lead_tilt(tangent, normal, angles);
            ASSERT_TRUE(found);
            const bool is_normal = about == TiltAbout::Normal;
            const Vec3 wanted = test::vec(
                expect[is_normal ? "vector_tilt_about_normal" : "vector_tilt_about_tangent"]);
            EXPECT_LT((found->value - wanted).norm(), kVector);
            // And back, for the same direction by whatever pair of angles.
            const Vec3 n = normal.value.normalized();
            const Vec3 t = (tangent.value - n * n.dot(tangent.value)).normalized();
            const LeadTilt back = lead_tilt_of(found->value, t, n, about);
            const auto again = by_lead_tilt({t, Vec3::Zero()}, normal, back);
            ASSERT_TRUE(again);
            EXPECT_LT((again->value - found->value).norm(), 1e-12);
        }
    });
}

void expect_way(const OrientationArc& arc, const json& fractions, const json& vectors) {
    ASSERT_EQ(fractions.size(), vectors.size());
    for (std::size_t i = 0; i < fractions.size(); ++i) {
        const OrientationPoint point = at(arc, fractions[i].get<double>());
        EXPECT_LT((point.direction - test::vec(vectors[i])).norm(), kVector) << fractions[i];
    }
}

TEST(Orientation, GreatCircleOracle) {
    for_each_case("ORIVECT", 7, [](const json& in, const json& expect) {
        const auto arc = great_circle(unit(in["start"]), unit(in["end"]));
        if (expect.contains("outcome")) {
            EXPECT_EQ(expect["reason"], "plane undefined");
            EXPECT_EQ(arc.error(), OrientationFault::Antiparallel);
            return;
        }
        ASSERT_TRUE(arc);
        EXPECT_NEAR(arc->turn, test::rad(expect["total_angle_deg"]), test::kAngleTolerance);
        EXPECT_NEAR(length_of(*arc), arc->turn, 1e-12);
        expect_way(*arc, in["fractions_of_path_length"], expect["vectors"]);
    });
}

TEST(Orientation, ConeOracle) {
    for_each_case("ORICONCCW_ORICONCW", 5, [](const json& in, const json& expect) {
        for (const ConeSense sense : {ConeSense::Ccw, ConeSense::Cw}) {
            const auto arc = cone_about(unit(in["start"]), unit(in["end"]),
                                        test::vec(in["cone_axis"]), sense, 1e-6);
            ASSERT_TRUE(arc);
            const bool is_ccw = sense == ConeSense::Ccw;
            EXPECT_NEAR(arc->turn, test::rad(expect[is_ccw ? "angle_ccw_deg" : "angle_cw_deg"]),
                        test::kAngleTolerance);
            EXPECT_NEAR(arc->polar, test::rad(expect["opening_half_angle_deg"]),
                        test::kAngleTolerance);
            expect_way(*arc, in["fractions_of_path_length"],
                       expect[is_ccw ? "vectors_ccw" : "vectors_cw"]);
        }
    });
    for_each_case("NUT", 4, [](const json& in, const json& expect) {
        for (const ConeSense sense : {ConeSense::Ccw, ConeSense::Cw}) {
            const auto arc =
                cone_of_opening(unit(in["start"]), unit(in["end"]), test::rad(in["NUT"]), sense);
            ASSERT_TRUE(arc);
            const std::string way = sense == ConeSense::Ccw ? "ccw" : "cw";
            EXPECT_LT((arc->axis - test::vec(expect["cone_axis_" + way])).norm(), kVector);
            EXPECT_NEAR(arc->turn, test::rad(expect["turn_" + way + "_deg"]),
                        test::kAngleTolerance);
            expect_way(*arc, in["fractions_of_path_length"], expect["vectors_" + way]);
        }
    });
}

TEST(Orientation, ConeThroughAndTangentialOracle) {
    for_each_case("ORICONIO", 3, [](const json& in, const json& expect) {
        const auto arc = cone_through(unit(in["start"]), unit(in["intermediate"]), unit(in["end"]));
        ASSERT_TRUE(arc);
        // The axis is reported on the side of the start; the motion needs the one about which it
        // goes counter-clockwise.
        const double side = arc->axis.dot(unit(in["start"])) >= 0 ? 1 : -1;
        EXPECT_LT((side * arc->axis - test::vec(expect["cone_axis"])).norm(), kVector);
        const double half = side > 0 ? arc->polar : std::numbers::pi - arc->polar;
        EXPECT_NEAR(half, test::rad(expect["half_angle_deg"]), test::kAngleTolerance);
    });
    for_each_case("ORICONIO_path", 3, [](const json& in, const json& expect) {
        const auto arc = cone_through(unit(in["start"]), unit(in["intermediate"]), unit(in["end"]));
        ASSERT_TRUE(arc);
        EXPECT_NEAR(arc->turn, test::rad(expect["turn_deg"]), test::kAngleTolerance);
        expect_way(*arc, in["fractions_of_path_length"], expect["vectors"]);
    });
    for_each_case("ORICONTO", 4, [](const json& in, const json& expect) {
        const auto arc =
            cone_tangential(unit(in["start"]), test::vec(in["rate_direction"]), unit(in["end"]));
        ASSERT_TRUE(arc);
        EXPECT_LT((arc->axis - test::vec(expect["cone_axis_ccw"])).norm(), kVector);
        EXPECT_NEAR(arc->turn, test::rad(expect["turn_deg"]), test::kAngleTolerance);
        expect_way(*arc, in["fractions_of_path_length"], expect["vectors"]);
    });
}

// Between axes that run linearly the tool leaves the plane of its ends: the reason for ORIVECT.
TEST(Orientation, AxisLinearOracle) {
    for_each_case("ORIAXES", 4, [](const json& in, const json& expect) {
        const Chain chain = test::chain_of(in["machine"]);
        const auto rotary = [&](double f) {
            const json& a = in["start_R1_R2"];
            const json& b = in["end_R1_R2"];
            return Vec3((1 - f) * test::rad(a[0]) + f * test::rad(b[0]),
                        (1 - f) * test::rad(a[1]) + f * test::rad(b[1]), 0);
        };
        const Vec3 start = tool_vector(chain, rotary(0));
        const Vec3 end = tool_vector(chain, rotary(1));
        EXPECT_LT((start - test::vec(expect["vector_start"])).norm(), kVector);
        EXPECT_LT((end - test::vec(expect["vector_end"])).norm(), kVector);
        EXPECT_LT((tool_vector(chain, rotary(0.5)) - test::vec(expect["vector_mid"])).norm(),
                  kVector);
        const Vec3 normal = start.cross(end).normalized();
        double greatest = 0;
        for (int i = 0; i <= 2000; ++i) {
            const Vec3 w = tool_vector(chain, rotary(i / 2000.0));
            greatest = std::max(greatest, std::asin(std::abs(normal.dot(w))));
        }
        const double wanted = test::rad(expect["max_angle_out_of_great_circle_plane_deg"]);
        EXPECT_NEAR(greatest, wanted, 1e-3 * wanted);
    });
}

TEST(Orientation, LinearisationOracle) {
    for_each_case("linearisation_error", 4, [](const json& in, const json& expect) {
        const Chain chain = test::chain_of(in["machine"]);
        const Vec3 tip = test::tip_of(in["tool"]);
        const Vec3 from = test::vec(in["tip_start"]);
        const Vec3 to = test::vec(in["tip_end"]);
        const auto standing = [&](const json& rotary, const Vec3& target) {
            ChainPosition position;
            position.rotary = {test::rad(rotary[0]), test::rad(rotary[1]), 0};
            position.linear = inverse_linear(chain, target, position, tip);
            return position;
        };
        const ChainPosition a = standing(in["start_R1_R2"], from);
        const ChainPosition b = standing(in["end_R1_R2"], to);
        double error = 0;
        double distance = 0;
        for (int i = 0; i <= 2000; ++i) {
            const double f = i / 2000.0;
            ChainPosition between;
            between.linear = (1 - f) * a.linear + f * b.linear;
            between.rotary = (1 - f) * a.rotary + f * b.rotary;
            const Vec3 off = forward(chain, between, tip).tip - from;
            const Vec3 along = (to - from).normalized();
            error = std::max(error, (off - f * (to - from)).norm());
            distance = std::max(distance, (off - along * along.dot(off)).norm());
        }
        const double wanted = expect["max_tip_error_mm"].get<double>();
        EXPECT_NEAR(error, wanted, 1e-3 * wanted);
        const double wanted_distance = expect["max_distance_from_line_mm"].get<double>();
        EXPECT_NEAR(distance, wanted_distance, 1e-3 * wanted_distance);
    });
}

/// Random numbers that are the same on every machine.
class Random {
  public:
    double between(double a, double b) {
        return a + (b - a) * static_cast<double>(engine_()) / 4294967296.0;
    }
    Vec3 direction() {
        while (true) {
            const Vec3 v = {between(-1, 1), between(-1, 1), between(-1, 1)};
            if (v.norm() > 0.1 && v.norm() < 1) return v.normalized();
        }
    }

  private:
    std::mt19937 engine_{20240817};
};

// Derivatives against central differences, h = 1e-5: an error of the order h² and rounding / h².
TEST(Orientation, ArcDerivatives) {
    Random random;
    constexpr double h = 1e-5;
    for (int i = 0; i < 300; ++i) {
        SCOPED_TRACE(i);
        const Vec3 a = random.direction();
        const Vec3 b = random.direction();
        const auto arcs = {great_circle(a, b), cone_through(a, random.direction(), b),
                           cone_tangential(a, random.direction(), b),
                           cone_about(a, b, random.direction(), ConeSense::Cw, 4)};
        for (const auto& arc : arcs) {
            ASSERT_TRUE(arc);
            EXPECT_LT((at(*arc, 0).direction - a).norm(), 1e-12);
            EXPECT_LT((at(*arc, 1).direction - b).norm(), 1e-12);
            const double f = random.between(0.1, 0.9);
            const OrientationPoint here = at(*arc, f);
            const Vec3 before = at(*arc, f - h).direction;
            const Vec3 after = at(*arc, f + h).direction;
            EXPECT_NEAR(here.direction.norm(), 1, 1e-12);
            EXPECT_LT(((after - before) / (2 * h) - here.rate).norm(), 1e-7);
            EXPECT_LT(((after - 2 * here.direction + before) / (h * h) - here.bending).norm(),
                      1e-4);
        }
    }
}

TEST(Orientation, LeadTiltRateIsItsDerivative) {
    Random random;
    constexpr double h = 1e-6;
    for (int i = 0; i < 200; ++i) {
        const Varying t = {random.direction(), random.direction()};
        const Varying n = {random.direction(), random.direction()};
        for (const TiltAbout about : {TiltAbout::Normal, TiltAbout::Tangent}) {
            const LeadTilt angles = {random.between(-1, 1), random.between(-1, 1), about};
            if (t.value.cross(n.value).norm() < 0.2) continue;
            const auto near = [&](double by) {
                return by_lead_tilt({t.value + by * t.rate, t.rate},
                                    {n.value + by * n.rate, n.rate}, angles)
                    .value();
            };
            const Vec3 slope = (near(h).value - near(-h).value) / (2 * h);
            EXPECT_LT((slope - near(0).rate).norm(), 1e-6);
        }
    }
}

TEST(Orientation, WhatHasNoAnswer) {
    const Vec3 x = Vec3::UnitX();
    const Vec3 y = Vec3::UnitY();
    const Vec3 z = Vec3::UnitZ();
    EXPECT_EQ(unit_of(Vec3(0, 0, 0)).error(), OrientationFault::ZeroVector);
    EXPECT_EQ(great_circle(z, -z).error(), OrientationFault::Antiparallel);
    EXPECT_EQ(cone_about(x, y, Vec3::Zero(), ConeSense::Ccw, 1).error(),
              OrientationFault::ZeroVector);
    EXPECT_EQ(cone_about(x, z, z, ConeSense::Ccw, 4).error(), OrientationFault::NotOnCone);
    EXPECT_EQ(cone_about(x, Vec3(0, 0.6, 0.8), z, ConeSense::Ccw, 0.01).error(),
              OrientationFault::NotOnCone);
    // The ends are 90° apart: a cone of 80° cannot hold both.
    EXPECT_EQ(cone_of_opening(x, y, rad_from_deg(80), ConeSense::Ccw).error(),
              OrientationFault::OpeningSmall);
    EXPECT_EQ(cone_of_opening(x, x, 1, ConeSense::Ccw).error(), OrientationFault::EqualVectors);
    EXPECT_EQ(cone_of_opening(x, -x, 3.2, ConeSense::Ccw).error(), OrientationFault::Antiparallel);
    EXPECT_EQ(cone_through(x, y, y).error(), OrientationFault::EqualVectors);
    EXPECT_EQ(cone_tangential(x, y, x).error(), OrientationFault::EqualVectors);
    EXPECT_EQ(by_lead_tilt({z, Vec3::Zero()}, {2 * z, Vec3::Zero()}, {}).error(),
              OrientationFault::NormalAlongTangent);
}

TEST(Orientation, EqualEndsStandStill) {
    const Vec3 w = Vec3(0.6, 0, 0.8);
    const auto arc = great_circle(w, w);
    ASSERT_TRUE(arc);
    for (const double f : {0.0, 0.3, 1.0}) EXPECT_LT((at(*arc, f).direction - w).norm(), 1e-15);
    // Neither sense makes a whole turn of it.
    for (const ConeSense sense : {ConeSense::Ccw, ConeSense::Cw})
        EXPECT_EQ(cone_about(w, w, Vec3::UnitZ(), sense, 0.1)->turn, 0);
}

}  // namespace
}  // namespace kadr::machine::orientation_test
