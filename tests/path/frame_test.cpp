// Frames against tests/oracles/frames.json, kind frame_chain.
#include "path/frame.h"

#include <fstream>
#include <numbers>
#include <string>

#include <Eigen/LU>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/units.h"

namespace kadr::path::frame_test {
namespace {

using Json = nlohmann::json;

constexpr double kTolerance = 1e-7;  // mm; what the oracle promises

Vec3 vec3(const Json& json) {
    return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

Vec3 words(const Json& element, double missing) {
    return {element.value("X", missing), element.value("Y", missing), element.value("Z", missing)};
}

Plane plane_of(const std::string& name) {
    return name == "G17" ? Plane::Xy : name == "G18" ? Plane::Zx : Plane::Yz;
}

Frame frame_of(const Json& element) {
    const std::string op = element["op"];
    if (op == "TRANS") return translation(words(element, 0));
    if (op == "SCALE") return scaling(words(element, 1));
    if (op == "ROT_RPL") {
        return rotation_in_plane(plane_of(element["plane"]), rad_from_deg(element["RPL"]));
    }
    if (op == "MIRROR") {
        AxisMask axes = 0;
        for (const char letter : element["axes"].get<std::string>()) {
            axes |= bit(static_cast<Axis>(letter - 'X'));
        }
        return mirroring(axes);
    }
    const Vec3 degrees = words(element, 0);
    const AxisAngles angles{rad_from_deg(degrees.x()), rad_from_deg(degrees.y()),
                            rad_from_deg(degrees.z())};
    EXPECT_TRUE(op == "ROT_RPY" || op == "ROT_EULER") << op;
    return op == "ROT_RPY" ? rotation_rpy(angles) : rotation_euler(angles);
}

TEST(Frame, ChainsOfTheOracle) {
    std::ifstream file(KADR_ROOT "/tests/oracles/frames.json");
    int chains = 0;
    const Json oracle = Json::parse(file);
    for (const Json& test : oracle["cases"]) {
        if (test["kind"] != "frame_chain") continue;
        SCOPED_TRACE(test["id"].get<std::string>());
        ++chains;
        Frame frame;
        for (const Json& element : test["input"]["chain"]) frame = frame * frame_of(element);

        const Json& expected = test["expect"];
        const Result<Frame, FrameFault> back = inverse(frame);
        ASSERT_TRUE(back);
        for (std::size_t i = 0; i < test["input"]["points"].size(); ++i) {
            const Vec3 point = vec3(test["input"]["points"][i]);
            EXPECT_LT((frame(point) - vec3(expected["mapped"][i])).norm(), kTolerance);
            EXPECT_LT(((*back)(frame(point)) - point).norm(), 1e-10);
        }
        EXPECT_LT((frame.shift - vec3(expected["origin"])).norm(), kTolerance);
        for (int column = 0; column < 3; ++column) {
            EXPECT_LT((frame.linear.col(column) - vec3(expected["columns"][column])).norm(), 1e-9);
        }
        EXPECT_NEAR(frame.linear.determinant(), expected["determinant"].get<double>(), 1e-6);
    }
    EXPECT_EQ(chains, 14);
}

TEST(Frame, AdditiveShiftActsInTheTurnedSystem) {
    // ROT Z90, then ATRANS X10: along the old Y.
    const Frame frame =
        rotation_in_plane(Plane::Xy, std::numbers::pi / 2) * translation({10, 0, 0});
    EXPECT_LT((frame(Vec3::Zero()) - Vec3(0, 10, 0)).norm(), 1e-12);
    EXPECT_LT((frame.direction({1, 0, 0}) - Vec3(0, 1, 0)).norm(), 1e-12);
}

TEST(Frame, FlattenedSpaceHasNoWayBack) {
    const Result<Frame, FrameFault> back = inverse(scaling({1, 0, 1}));
    ASSERT_FALSE(back);
    EXPECT_EQ(back.error(), FrameFault::Singular);
}

TEST(Frame, AnglesAreReadBackNormalised) {
    // Read-back of the control: CROT(X,10,Y,90,Z,40) reads as X 0, Y 90, Z 30;
    // CROT(X,190,Y,0,Z,-200) as X −170, Y 0, Z 160.
    struct Row {
        const char* name;
        Vec3 written, read;
    };
    for (const Row& row : {Row{"plain", {10, 20, 30}, {10, 20, 30}},
                           {"y at 90", {10, 90, 40}, {0, 90, 30}},
                           {"y at -90", {10, -90, 40}, {0, -90, 50}},
                           {"beyond the range", {190, 0, -200}, {-170, 0, 160}}}) {
        SCOPED_TRACE(row.name);
        const AxisAngles angles{rad_from_deg(row.written.x()), rad_from_deg(row.written.y()),
                                rad_from_deg(row.written.z())};
        const AxisAngles read = rpy_of(rotation_rpy(angles).linear);
        EXPECT_NEAR(deg_from_rad(read.x), row.read.x(), 1e-6);
        EXPECT_NEAR(deg_from_rad(read.y), row.read.y(), 1e-6);
        EXPECT_NEAR(deg_from_rad(read.z), row.read.z(), 1e-6);
    }
}

}  // namespace
}  // namespace kadr::path::frame_test
