// Where the tip of a cutter is that touches in space, against tests/oracles/cutter_comp.json.
#include "path/contact.h"

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace kadr::path {
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
    contact.kind = ContactKind::Side;
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
    contact.kind = ContactKind::Side;
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

}  // namespace
}  // namespace kadr::path
