#include <random>

#include <Eigen/Geometry>

#include "tests/machine/support.h"

namespace kadr::machine::kinematics_test {
namespace {

using test::json;

double number(const json& value) { return value.get<double>(); }

ChainPosition position_of(const json& input) {
    ChainPosition position;
    position.linear = test::xyz(input);
    position.rotary = {test::rad(input["R1"]), test::rad(input["R2"]), test::rad(input["psi"])};
    return position;
}

void check_forward(const json& input, const json& expect, bool has_second) {
    ChainPosition position = position_of(input);
    // Where the joint is missing, what stands there has no influence.
    if (!has_second) position.rotary[kR2] = 0.7;
    const Chain chain = test::chain_of(input["machine"], has_second, has_second);
    const Vec3 tip = test::tip_of(input["tool"]);
    const Pose pose = forward(chain, position, tip);
    EXPECT_LT((pose.tip - test::vec(expect["tip"])).norm(), 1e-6);
    EXPECT_LT((tool_vector(chain, position.rotary) - test::vec(expect["vector"])).norm(), 1e-8);
    EXPECT_LT((pose.rotation * chain.tool_direction - test::vec(expect["vector"])).norm(), 1e-8);
    if (expect.contains("matrix_rows")) {
        EXPECT_LT((pose.rotation - test::matrix(expect["matrix_rows"])).norm(), 1e-8);
    }
    EXPECT_LT((inverse_linear(chain, pose.tip, position, tip) - position.linear).norm(), 1e-9);
}

TEST(Kinematics, ForwardOracle) {
    const auto five = [](const json& in, const json& expect) { check_forward(in, expect, true); };
    const auto four = [](const json& in, const json& expect) { check_forward(in, expect, false); };
    test::for_each_case("kinematics.json", "forward", 28, five);
    test::for_each_case("kinematics.json", "forward_4axis_R2_absent", 7, four);
}

/// R1, R2 and the linear axes that bring the tip to its place.
void expect_solution(const Chain& chain, const Solution& solution, const json& expected,
                     const json& input) {
    EXPECT_EQ(solution.configuration, expected["config"].get<int>());
    EXPECT_LT(test::apart(solution.rotary[kR1], test::rad(expected["R1"])), test::kAngleTolerance);
    EXPECT_LT(test::apart(solution.rotary[kR2], test::rad(expected["R2"])), test::kAngleTolerance);
    ChainPosition position;
    position.rotary = solution.rotary;
    const Vec3 linear =
        inverse_linear(chain, test::vec(input["tip"]), position, test::tip_of(input["tool"]));
    EXPECT_LT((linear - test::xyz(expected)).norm(), 1e-5);
}

/// Of R2 of a machine of the oracles.
AxisRange second_limits(const json& name) {
    const json machines = test::oracle("kinematics.json")["machines"];
    for (const json& machine : machines)
        if (machine["name"] == name) return test::limits(machine["R2"]["limits"]);
    ADD_FAILURE() << name;
    return {};
}

TEST(Kinematics, InverseOracle) {
    test::for_each_case(
        "kinematics.json", "inverse", 63, [](const json& input, const json& expect) {
            const Chain chain = test::chain_of(input["machine"]);
            const auto solutions = solve(chain, Vec3(test::vec(input["vector"]).normalized()));
            ASSERT_EQ(solutions.has_value(), expect["reachable"].get<bool>());
            if (!solutions) {
                EXPECT_EQ(solutions.error(), ReachFault::OutsideReach);
                return;
            }
            const json& expected = expect["solutions_in_(-180,180]"];
            ASSERT_EQ(solutions->count, expected.size());
            const AxisRange second = second_limits(input["machine"]);
            for (std::size_t i = 0; i < expected.size(); ++i) {
                expect_solution(chain, (*solutions)[i], expected[i], input);
                const double tilt = (*solutions)[i].rotary[kR2];
                constexpr double kOnLimit = 1e-9;  // rad: some stand on it
                EXPECT_EQ(second.lower - kOnLimit <= tilt && tilt <= second.upper + kOnLimit,
                          expected[i]["R2_within_limits"].get<bool>());
                EXPECT_EQ((*solutions)[i].is_pole, expected[i]["R1_free"].get<bool>());
                EXPECT_EQ((*solutions)[i].is_pole, expect["singular"].get<bool>());
            }
        });
}

TEST(Kinematics, ParallelAxesOracle) {
    test::for_each_case(
        "kinematics.json", "uvw_compensation", 7, [](const json& input, const json& expect) {
            const json& start = input["start"];
            const Vec3 tip = test::tip_of(input["tool"]);
            ChainPosition position;
            position.linear = test::vec(start);
            position.rotary = {test::rad(start[3]), test::rad(start[4]), 0};
            Chain chain = test::chain_of(input["machine"]);
            const Vec3 target = forward(chain, position, tip).tip;
            EXPECT_LT((target - test::vec(expect["tip"])).norm(), 1e-6);
            position.parallel = test::vec(input["uvw"]);
            const Vec3 moved = inverse_linear(chain, target, position, tip);
            const Vec3 wanted = test::xyz(expect);
            EXPECT_LT((moved - wanted).norm(), 1e-6);
            // Without compensation U, V, W are none of the chain's business.
            chain.compensates_parallel = false;
            EXPECT_LT((inverse_linear(chain, target, position, tip) - position.linear).norm(),
                      1e-9);
        });
}

TEST(Kinematics, SixAxisOracle) {
    test::for_each_case("six_axis.json", "inverse", 21, [](const json& input, const json& expect) {
        const Chain chain = test::chain_of(input["machine"], true);
        const Mat3 rotation = test::matrix(expect["matrix_rows"]);
        const auto solutions = solve(chain, rotation);
        ASSERT_TRUE(solutions);
        const json& expected = expect["solutions_in_(-180,180]"];
        ASSERT_EQ(solutions->count, expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            expect_solution(chain, (*solutions)[i], expected[i], input);
            const Vec3& rotary = (*solutions)[i].rotary;
            EXPECT_LT(test::apart(rotary[kPsi], test::rad(expected[i]["Psi"])),
                      test::kAngleTolerance);
            EXPECT_LT((rotation_of(chain, rotary) - rotation).norm(), 1e-8);
        }
    });
    test::for_each_case("six_axis.json", "pole", 8, [](const json& input, const json& expect) {
        const Chain chain = test::chain_of(input["machine"], true);
        const auto solutions = solve(chain, test::matrix(input["matrix_rows"]));
        ASSERT_TRUE(solutions);
        ASSERT_EQ(solutions->count, 1u);
        ASSERT_TRUE((*solutions)[0].is_pole);
        const Vec3 rotary = at_pole(chain, (*solutions)[0], test::rad(input["start_R1"])).rotary;
        EXPECT_LT(test::apart(rotary[kR1], test::rad(expect["R1"])), 1e-12);
        EXPECT_LT(test::apart(rotary[kR2], test::rad(expect["R2"])), test::kAngleTolerance);
        EXPECT_LT(test::apart(rotary[kPsi], test::rad(expect["Psi"])), test::kAngleTolerance);
    });
}

// The borer's recalculation is the inverse of a chain with one table axis B: the place where the
// machine must stand for a point that has been turned with the table.
TEST(Kinematics, ZeroPointOracle) {
    test::for_each_case("zero_point.json", "", 22, [](const json& input, const json& expect) {
        Chain chain;
        RotaryJoint& table = chain.joints[kR1];
        table.is_present = true;
        table.axis = Axis::B;
        table.direction = Vec3::UnitY();
        table.point = {number(input["table_centre_X"]), 0, number(input["table_centre_Z"])};
        // `dir` tells how the table turns with the part; a positive tool motion is the other way.
        table.sign = -input["dir"].get<double>();
        chain = prepare(chain).value();
        ChainPosition position;
        position.rotary[kR1] = test::rad(input["B"]);
        const Vec3 zero = {number(input["part_zero_X"]), 12.5, number(input["part_zero_Z"])};
        const Vec3 turned = inverse_linear(chain, zero, position, Vec3::Zero());
        // By hand: from the axis of the table, as a radius and its angle from Z towards X.
        const Vec3 before = zero - table.point;
        const Vec3 behind = turned - table.point;
        EXPECT_NEAR(before.x(), expect["dX"].get<double>(), 1e-9);
        EXPECT_NEAR(before.z(), expect["dZ"].get<double>(), 1e-9);
        EXPECT_NEAR(std::hypot(behind.x(), behind.z()), expect["R"].get<double>(), 1e-9);
        const auto expect_angle = [](const Vec3& radius, const json& angle_deg) {
            if (std::hypot(radius.x(), radius.z()) < 1e-9) return;  // on the axis there is none
            EXPECT_LT(test::apart(std::atan2(radius.x(), radius.z()), test::rad(angle_deg)),
                      rad_from_deg(1e-9));
        };
        expect_angle(before, expect["alpha_deg"]);
        expect_angle(behind, expect["gamma_deg"]);
        EXPECT_NEAR(turned.x(), expect["new_X"].get<double>(), 1e-9);
        EXPECT_NEAR(turned.y(), 12.5, 1e-12);
        EXPECT_NEAR(turned.z(), expect["new_Z"].get<double>(), 1e-9);
    });
}

TEST(Kinematics, ChainsThatAreNone) {
    const auto chain_with = [](ChainSide first, const Vec3& n1, ChainSide second, const Vec3& n2) {
        Chain chain;
        chain.joints[kR1] = {true, Axis::C, first, n1, Vec3::Zero(), 1};
        chain.joints[kR2] = {true, Axis::B, second, n2, Vec3::Zero(), 1};
        return chain;
    };
    const Vec3 x = Vec3::UnitX();
    const Vec3 z = Vec3::UnitZ();
    EXPECT_EQ(prepare(Chain{}).error(), ChainFault::NoJoint);
    EXPECT_EQ(prepare(chain_with(ChainSide::Head, z, ChainSide::Table, x)).error(),
              ChainFault::TableBehindHead);
    EXPECT_EQ(prepare(chain_with(ChainSide::Head, x, ChainSide::Head, -x)).error(),
              ChainFault::ParallelJoints);
    EXPECT_EQ(prepare(chain_with(ChainSide::Head, x, ChainSide::Head, z)).error(),
              ChainFault::SecondAlongTool);
    Chain spun = chain_with(ChainSide::Head, z, ChainSide::Head, x);
    spun.joints[kPsi] = {true, Axis::A, ChainSide::Head, x, Vec3::Zero(), 1};
    EXPECT_EQ(prepare(spun).error(), ChainFault::SpinNotAlongTool);
    spun.joints[kPsi].direction = z;
    EXPECT_TRUE(prepare(spun));
    spun.joints[kR2].is_present = false;
    EXPECT_EQ(prepare(spun).error(), ChainFault::SpinWithoutPair);
}

TEST(Kinematics, OneRotaryAxisReachesItsConeOnly) {
    Chain chain;
    chain.joints[kR1] = {true, Axis::A, ChainSide::Table, Vec3::UnitX(), Vec3::Zero(), 1};
    chain = prepare(chain).value();
    // w = Rot(x, 30°) z = (0, −sin 30°, cos 30°)
    const auto found = solve(chain, Vec3(0, -0.5, std::sqrt(0.75)));
    ASSERT_TRUE(found);
    ASSERT_EQ(found->count, 1u);
    EXPECT_NEAR((*found)[0].rotary[kR1], rad_from_deg(30), 1e-12);
    EXPECT_EQ(solve(chain, Vec3(0.6, 0, 0.8)).error(), ReachFault::MissingJoint);
}

}  // namespace
}  // namespace kadr::machine::kinematics_test
