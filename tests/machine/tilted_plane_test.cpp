// Tilted planes against the oracles: how they lie, and which rotary axes stand to them.
#include "machine/tilted_plane.h"

#include <array>
#include <set>
#include <vector>

#include "tests/machine/support.h"

namespace kadr::machine::tilted_plane_test {
namespace {

using test::apart;
using test::chain_of;
using test::for_each_case;
using test::json;
using test::kAngleTolerance;
using test::rad;
using test::tip_of;
using test::vec;

constexpr double kDirection = 1e-9;
constexpr double kPlace = 1e-7;   // mm
constexpr double kLinear = 1e-5;  // mm, of axes that an inverse gives

Mat3 columns(const json& list) {
    Mat3 result;
    for (int i = 0; i < 3; ++i) result.col(i) = vec(list[static_cast<std::size_t>(i)]);
    return result;
}

void expect_plane(const Mat3& plane, const json& expect) {
    EXPECT_LT((plane - columns(expect["columns"])).cwiseAbs().maxCoeff(), kDirection);
    EXPECT_NEAR((plane.transpose() * plane - Mat3::Identity()).norm(), 0, 1e-12);
    EXPECT_GT(plane.determinant(), 0);
}

Axis axis_named(char name) { return static_cast<Axis>(name - 'X'); }

/// The rotation of a case of CYCLE800 that says its angles.
Mat3 plane_of(const json& input) {
    const std::string mode = input["mode"];
    if (mode == "axis_by_axis") {
        const std::string order = input["order"];
        std::array<AxisRotation, 3> turns{};
        const std::array<const char*, 3> names = {"_A", "_B", "_C"};
        for (std::size_t i = 0; i < 3; ++i) turns[i] = {axis_named(order[i]), rad(input[names[i]])};
        return turned_in_order(turns);
    }
    if (mode == "solid") {
        const std::array<AxisRotation, 2> turns = {
            {{Axis::Z, rad(input["_A"])}, {Axis::Y, rad(input["_B"])}}};
        return turned_in_order(turns);
    }
    const bool is_xy = input["pair"] == "XY";
    return projected(
               {rad(input[is_xy ? "_A" : "_B"]), rad(input[is_xy ? "_B" : "_A"]), rad(input["_C"])})
        .value();
}

JointLimits limits_of(const std::string& machine) {
    static const json machines = test::oracle("kinematics.json")["machines"];
    JointLimits limits;
    for (const json& item : machines) {
        if (item["name"] != machine) continue;
        limits[kR1] = test::limits(item["R1"]["limits"]);
        limits[kR2] = test::limits(item["R2"]["limits"]);
    }
    return limits;
}

TEST(TiltedPlane, SwivelsOfTheOracleLieAsItSays) {
    int seen = 0;
    for_each_case("swivel_modes.json", "CYCLE800", 17, [&](const json& input, const json& expect) {
        if (input["mode"] == "direct") return;
        ++seen;
        expect_plane(plane_of(input), expect);
        const Chain chain = chain_of(input["machine"]);
        const Vec3 tip = tip_of(input["tool"]);
        for (const json& solution : expect["rotary_solutions"]) {
            // The tool is along Z; tables carry the plane, heads the tip: the linear axes of both
            // agree.
            const Vec3 rotary(rad(solution["R1"]), rad(solution["R2"]), 0);
            const path::Frame tables = table_frame(chain, rotary);
            EXPECT_LT(
                (tool_in_base(chain, rotary) - tables.direction(columns(expect["columns"]).col(2)))
                    .norm(),
                1e-9);
            for (std::size_t i = 0; i < expect["mapped"].size(); ++i) {
                const Vec3 axes =
                    tables(vec(expect["mapped"][i])) - head_offset(chain, rotary, tip);
                EXPECT_LT((axes - vec(solution["XYZ_of_points"][i])).norm(), kLinear);
            }
        }
    });
    EXPECT_EQ(seen, 13);
}

TEST(TiltedPlane, SwivelsTakeTheSolutionOfTheirDirection) {
    for_each_case("swivel_modes.json", "CYCLE800", 17, [&](const json& input, const json& expect) {
        if (input["mode"] == "direct") return;
        const Chain chain = chain_of(input["machine"]);
        SwivelQuery query;
        query.direction = plane_of(input).col(2);
        query.limits = limits_of(input["machine"]);
        query.reference = input["reference_axis"] == "R1" ? kR1 : kR2;
        for (const int sense : {-1, 1}) {
            query.sense = sense;
            const auto end = choose_swivel(chain, query);
            const json& wanted = expect["selected"][std::to_string(sense)];
            ASSERT_EQ(end.has_value(), !wanted.is_null());
            if (!end) continue;
            EXPECT_LT(apart((*end)[0], rad(wanted["R1"])), kAngleTolerance);
            EXPECT_LT(apart((*end)[1], rad(wanted["R2"])), kAngleTolerance);
        }
    });
}

TEST(TiltedPlane, DirectSwivelsLieAsTheirAxesHoldThem) {
    int seen = 0;
    for_each_case("swivel_modes.json", "CYCLE800", 17, [&](const json& input, const json& expect) {
        if (input["mode"] != "direct") return;
        ++seen;
        const Chain chain = chain_of(input["machine"]);
        expect_plane(rotation_of(chain, {rad(input["_A"]), rad(input["_B"]), 0}), expect);
    });
    EXPECT_EQ(seen, 4);
}

TEST(TiltedPlane, FormsOfG682LieAsTheOracleSays) {
    std::set<int> forms;
    for_each_case("swivel_modes.json", "G68.2", 15, [&](const json& input, const json& expect) {
        const int form = input["P"];
        forms.insert(form);
        path::Frame plane;
        if (form == 2) {
            const std::array<Vec3, 3> points = {vec(input["P1"]), vec(input["P2"]),
                                                vec(input["P3"])};
            plane = path::translation(points[0]) *
                    path::Frame{through_points(points).value(), Vec3::Zero()} *
                    path::translation(vec(input["shift_in_feature_system"])) *
                    path::rotation_in_plane(path::Plane::Xy, rad(input["R"]));
        } else if (form == 3) {
            plane = {by_axes(vec(input["x_vector"]), vec(input["z_vector"]), 0.01).value(),
                     vec(input["origin"])};
        } else {
            const Vec3 angles(rad(input["I"]), rad(input["J"]), rad(input["K"]));
            Mat3 rotation = Mat3::Identity();
            if (form == 1) {
                std::array<AxisRotation, 3> turns{};
                int rest = input["Q"];
                for (std::size_t i = 3; i-- > 0; rest /= 10)
                    turns[i] = {static_cast<Axis>(rest % 10 - 1), angles[rest % 10 - 1]};
                rotation = turned_about_fixed(turns);
            } else if (form == 4) {
                rotation = projected({angles[1], angles[0], angles[2]}).value();
            } else {
                const std::array<AxisRotation, 3> turns = {
                    {{Axis::Z, angles[0]}, {Axis::X, angles[1]}, {Axis::Z, angles[2]}}};
                rotation = turned_in_order(turns);
            }
            plane = {rotation, vec(input["origin"])};
        }
        expect_plane(plane.linear, expect);
        EXPECT_LT((plane.shift - vec(expect["origin"])).norm(), kPlace);
        for (std::size_t i = 0; i < input["points"].size(); ++i)
            EXPECT_LT((plane(vec(input["points"][i])) - vec(expect["mapped"][i])).norm(), kPlace);
    });
    EXPECT_EQ(forms, (std::set<int>{0, 1, 2, 3, 4}));
}

TEST(TiltedPlane, EulerPlanesOfTheOracleStandToTheirMachines) {
    for_each_case("frames.json", "G68.2_euler", 7, [&](const json& input, const json& expect) {
        const std::array<AxisRotation, 3> turns = {
            {{Axis::Z, rad(input["I"])}, {Axis::X, rad(input["J"])}, {Axis::Z, rad(input["K"])}}};
        const path::Frame plane{turned_in_order(turns), vec(input["origin"])};
        for (std::size_t i = 0; i < input["points"].size(); ++i)
            EXPECT_LT((plane(vec(input["points"][i])) - vec(expect["mapped"][i])).norm(), kPlace);
        const Chain chain = chain_of(input["machine"]);
        for (const json& solution : expect["rotary_solutions"]) {
            const Vec3 rotary(rad(solution["R1"]), rad(solution["R2"]), 0);
            const Vec3 axes = table_frame(chain, rotary)(plane.shift) -
                              head_offset(chain, rotary, tip_of(input["tool"]));
            EXPECT_LT((axes - vec(solution["XYZ_of_plane_origin"])).norm(), kLinear);
        }
    });
    for_each_case("frames.json", "swivel_axis_by_axis", 6,
                  [&](const json& input, const json& expect) {
                      const std::string order = input["order"];
                      std::array<AxisRotation, 3> turns{};
                      for (std::size_t i = 0; i < 3; ++i)
                          turns[i] = {axis_named(order[i]), rad(input["angles_in_order"][i])};
                      expect_plane(turned_in_order(turns), expect);
                  });
}

TEST(TiltedPlane, PlanesThatAreNoneAreRefused) {
    const std::array<Vec3, 3> line = {Vec3(0, 0, 0), Vec3(1, 2, 3), Vec3(2, 4, 6)};
    EXPECT_EQ(through_points(line).error(), PlaneFault::OneLine);
    const std::array<Vec3, 3> twice = {Vec3(1, 0, 0), Vec3(1, 0, 0), Vec3(2, 4, 6)};
    EXPECT_EQ(through_points(twice).error(), PlaneFault::ZeroVector);
    EXPECT_EQ(by_axes({1, 0, 0}, {0, 0, 0}, 0.1).error(), PlaneFault::ZeroVector);
    EXPECT_EQ(by_axes({1, 0, 0}, {0.2, 0, 1}, 0.1).error(), PlaneFault::NotSquare);
    const Mat3 nearly = by_axes({2, 0, 0}, {0.05, 0, 1}, 0.1).value();
    EXPECT_LT((nearly - Mat3::Identity()).norm(), 1e-12);
    EXPECT_EQ(projected({rad_from_deg(90), rad_from_deg(90), 0}).error(), PlaneFault::OneLine);
}

TEST(TiltedPlane, SquareToTheToolXTurnsNoMoreThanItMust) {
    const Vec3 tool = Vec3(1, -2, 3).normalized();
    const Mat3 near = square_to_tool_near(tool, Mat3::Identity());
    EXPECT_LT((near.col(2) - tool).norm(), 1e-12);
    // Of all directions square to the tool it is the one nearest to X.
    EXPECT_NEAR(near.col(0).dot(Vec3::UnitX().cross(tool)), 0, 1e-12);
    EXPECT_GT(near(0, 0), 0);
    EXPECT_EQ(square_to_tool_near(Vec3::UnitZ(), Mat3::Identity()), Mat3::Identity());
    const Mat3 along = square_to_tool_near(Vec3::UnitX(), Mat3::Identity());
    EXPECT_LT((along.col(1) - Vec3::UnitY()).norm(), 1e-12);
    // G68.3: X is square to the vertical axis.
    const Mat3 plane = square_to_tool(tool);
    EXPECT_NEAR(plane(2, 0), 0, 1e-12);
    EXPECT_LT((plane.col(2) - tool).norm(), 1e-12);
    EXPECT_EQ(square_to_tool(Vec3::UnitZ()), Mat3::Identity());
}

}  // namespace
}  // namespace kadr::machine::tilted_plane_test
