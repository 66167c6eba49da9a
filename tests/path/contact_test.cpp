// Where the tip of a cutter is that touches in space, against tests/oracles/cutter_comp.json.
#include "path/contact.h"

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace kadr::path::contact_test {
namespace {

using Json = nlohmann::json;

Vec3 vec3(const Json& values) {
    return {values[0].get<double>(), values[1].get<double>(), values[2].get<double>()};
}

Json cases() {
    std::ifstream file(KADR_ROOT "/tests/oracles/cutter_comp.json");
    return Json::parse(file)["cases"];
}

Contact side(const Json& input) {
    Contact contact;
    contact.kind = ContactKind::Flank;
    contact.radius = (input["tool_radius"].get<double>() + input["OFFN"].get<double>()) *
                     (input["side"] == "G42" ? 1 : -1);
    contact.depth = input["ISD"].get<double>();
    return contact;
}

TEST(Contact, SidesOfTheOracle) {
    const Json all = cases();
    int count = 0;
    for (const Json& test : all) {
        if (test["kind"] != "CUT3DC_point") continue;
        const Json& input = test["input"];
        const auto aside =
            tip_beside(side(input), vec3(input["tangent"]), vec3(input["orientation"]));
        ASSERT_TRUE(aside);
        EXPECT_LT((vec3(input["point"]) + *aside - vec3(test["expect"]["tip"])).norm(), 1e-6)
            << test["id"];
        ++count;
    }
    EXPECT_EQ(count, 6);
}

TEST(Contact, FacesOfTheOracle) {
    const Json all = cases();
    int count = 0;
    for (const Json& test : all) {
        if (test["kind"] != "CUT3DF_point") continue;
        const Json& input = test["input"];
        Contact contact;
        contact.kind = ContactKind::Face;
        contact.radius = input["tool_radius"].get<double>();
        contact.depth = input["corner_radius"].get<double>();
        const auto aside =
            tip_beside(contact, vec3(input["surface_normal"]), vec3(input["orientation"]));
        ASSERT_TRUE(aside);
        EXPECT_LT((vec3(input["contact"]) + *aside - vec3(test["expect"]["tip"])).norm(), 1e-6)
            << test["id"];
        ++count;
    }
    EXPECT_EQ(count, 9);
}

TEST(Contact, AToolAlongItsPathTouchesNoContour) {
    Contact contact;
    contact.kind = ContactKind::Flank;
    contact.radius = 5;
    EXPECT_FALSE(tip_beside(contact, Vec3::UnitZ(), Vec3::UnitZ()));
    EXPECT_FALSE(beside(Vec3::UnitX(), -Vec3::UnitX()));
}

/// In a corner the axis of the cutter is as far from both lines, whatever its direction.
TEST(Contact, CornersAreTouchedOnBothSides) {
    Contact contact;
    contact.kind = ContactKind::Corner;
    contact.guide = Vec3::UnitX();
    contact.axis = Vec3(0.2, 1, 0).normalized();
    contact.radius = -5;
    contact.depth = 3;
    for (const double tilt : {0.0, 0.3, -0.6}) {
        const Vec3 tool = Eigen::AngleAxisd(tilt, Vec3(0.3, 1, 0).normalized()) * Vec3::UnitZ();
        const auto tip = tip_beside(contact, contact.guide, tool);
        ASSERT_TRUE(tip);
        for (const Vec3& line : {contact.guide, contact.axis}) {
            const Vec3 across = line.cross(tool).normalized();
            EXPECT_NEAR(std::abs(tip->dot(across)), 5, 1e-9);
        }
    }
}

TEST(Contact, TheGuideTurnsEvenly) {
    Contact contact;
    contact.guide = Vec3::UnitX();
    contact.axis = Vec3::UnitZ();
    contact.turn = std::numbers::pi / 2;
    EXPECT_LT((guide_at(contact, 1) - Vec3::UnitY()).norm(), 1e-12);
    EXPECT_LT((guide_at(contact, 0.5) - Vec3(1, 1, 0).normalized()).norm(), 1e-12);
}

Contact face(double radius, double edge) {
    Contact contact;
    contact.kind = ContactKind::Face;
    contact.radius = radius;
    contact.depth = edge;
    return contact;
}

TEST(Contact, AnAllowanceLiftsTheTipAlongTheNormal) {
    const Vec3 normal = Vec3(0.3, -0.2, 1).normalized();
    const Vec3 tool = Vec3(0.1, 0.5, 1).normalized();
    Contact contact = face(5, 2);
    const Vec3 none = *tip_beside(contact, normal, tool);
    contact.allowance = 0.3;
    EXPECT_LT((*tip_beside(contact, normal, tool) - none - 0.3 * normal).norm(), 1e-12);
    EXPECT_LT((tip_square(contact, tool) - 0.3 * tool).norm(), 1e-12);
}

/// A face that lies square to the tool touches with all of it; a ball with its one place.
TEST(Contact, AFaceSquareToTheToolHasNoPlaceThatTouches) {
    EXPECT_FALSE(tip_beside(face(5, 2), Vec3::UnitZ(), Vec3::UnitZ()));
    EXPECT_LT(tip_beside(face(5, 5), Vec3::UnitZ(), Vec3::UnitZ())->norm(), 1e-12);
}

/// … and where it comes to lie so the tip is as it is beside: a nanometre per millimetre of radius.
TEST(Contact, WhereAFaceComesToLieSquareTheTipIsALimit) {
    for (const double turn : {1.0, 0.03, 1e-3, 1e-5}) {
        SCOPED_TRACE(turn);
        Contact contact = face(5, 1);
        contact.guide = Vec3::UnitZ();
        contact.axis = Vec3::UnitY();
        contact.turn = turn;
        const auto aside = [&](double share) {
            return tip_beside(contact, guide_at(contact, share), Vec3::UnitZ());
        };
        const auto limit = tip_or_limit(0, aside);
        ASSERT_TRUE(limit);
        EXPECT_LT((*limit - Vec3(4, 0, 0)).norm(), 5e-6);
        EXPECT_EQ(*tip_or_limit(0.5, aside), *aside(0.5));
    }
    EXPECT_FALSE(tip_or_limit(0, [](double) { return std::optional<Vec3>(); }));
}

/// Around an edge the tip of a ball goes an arc of its radius, that of a flat face half a turn of
/// its own where the edge lies under the tool's middle.
TEST(Contact, TheTipGoesAboutAStandingContact) {
    Contact contact = face(5, 5);
    contact.guide = Vec3(-0.5, 0, 1).normalized();
    contact.axis = Vec3::UnitY();
    contact.turn = 0.8;
    EXPECT_NEAR(tip_travel_about(contact, Vec3::UnitZ()), 5 * 0.8, 2e-3);
    contact.kind = ContactKind::Pivot;
    EXPECT_NEAR(tip_travel_about(contact, Vec3::UnitZ()), 5 * 0.8, 1e-12);
    contact = face(5, 0);
    contact.guide = Vec3(-0.5, 0, 1).normalized();
    contact.axis = Vec3::UnitZ();
    contact.turn = std::numbers::pi;
    EXPECT_NEAR(tip_travel_about(contact, Vec3::UnitZ()), 5 * std::numbers::pi, 0.05);
    contact.turn = 0;
    EXPECT_EQ(tip_travel_about(contact, Vec3::UnitZ()), 0);
}

}  // namespace
}  // namespace kadr::path::contact_test
