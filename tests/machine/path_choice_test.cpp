#include "tests/machine/support.h"

namespace kadr::machine::path_choice_test {
namespace {

using test::chain_of;
using test::json;
using test::rad;

PathMode mode_of(const json& word) { return word == "vector" ? PathMode::Vector : PathMode::Axis; }

/// Option 1, 2 or 3 of AxiOMA's parameter.
PathRule rule_of(const json& option) { return static_cast<PathRule>(option.get<int>() - 1); }

void expect_squares(const PathEnd& end, const json& expect) {
    const double squares = expect["sum_squares"].get<double>();
    EXPECT_NEAR(end.sum_squares * std::pow(deg_from_rad(1), 2), squares, 1e-6 * (1 + squares));
}

TEST(PathChoice, Oracle) {
    test::for_each_case("path_choice.json", "", 55, [](const json& input, const json& expect) {
        const Chain chain = test::chain_of(input["machine"]);
        PathQuery query = query_for(chain, test::vec(input["target_vector"]).normalized());
        query.start = {test::rad(input["start"]["R1"]), test::rad(input["start"]["R2"]), 0};
        query.mode = mode_of(input["mode"]);
        query.rule = rule_of(input["option"]);
        query.limits[kR1] = test::limits(input["limits_R1"]);
        query.limits[kR2] = test::limits(input["limits_R2"]);
        const auto end = choose_path(chain, query);
        ASSERT_EQ(end.has_value(), expect["outcome"] == "ok");
        if (!end) {
            EXPECT_EQ(expect["reason"], "no reachable configuration");
            return;
        }
        EXPECT_EQ(end->mode, mode_of(expect["mode_used"]));
        EXPECT_EQ(end->configuration, expect["config"].get<int>());
        EXPECT_NEAR(end->rotary[kR1], test::rad(expect["R1_end"]), test::kAngleTolerance);
        EXPECT_NEAR(end->rotary[kR2], test::rad(expect["R2_end"]), test::kAngleTolerance);
        EXPECT_EQ(end->is_long, expect["R1_path"] == "long");
        EXPECT_EQ(end->switches_at_pole, expect["pole_switch"].get<bool>());
        EXPECT_EQ(end->reason == PathReason::PoleSwitch, expect["pole_switch"].get<bool>());
        expect_squares(*end, expect);
    });
}

TEST(PathChoice, SixAxisOracle) {
    test::for_each_case("six_axis.json", "choice", 14, [](const json& input, const json& expect) {
        const Mat3 rotation =
            Eigen::Matrix3d(rotation_about(Vec3::UnitZ(), test::rad(input["phi"])) *
                            rotation_about(Vec3::UnitY(), test::rad(input["theta"])) *
                            rotation_about(Vec3::UnitZ(), test::rad(input["psi"])));
        PathQuery query;
        query.rotation = rotation;
        query.start = {test::rad(input["start"]["R1"]), test::rad(input["start"]["R2"]),
                       test::rad(input["start"]["Psi"])};
        query.mode = mode_of(input["mode"]);
        query.rule = rule_of(input["option"]);
        query.limits = {test::limits(input["limits_R1"]), test::limits(input["limits_R2"]),
                        test::limits(input["limits_Psi"])};
        const auto end = choose_path(test::chain_of(input["machine"], true), query);
        ASSERT_TRUE(end);
        EXPECT_EQ(end->configuration, expect["config"].get<int>());
        EXPECT_NEAR(end->rotary[kR1], test::rad(expect["R1_end"]), test::kAngleTolerance);
        EXPECT_NEAR(end->rotary[kR2], test::rad(expect["R2_end"]), test::kAngleTolerance);
        EXPECT_NEAR(end->rotary[kPsi], test::rad(expect["Psi_end"]), test::kAngleTolerance);
        expect_squares(*end, expect);
        const auto without = choose_path(test::chain_of(input["machine"]), query);
        ASSERT_TRUE(without);
        EXPECT_EQ(without->configuration, expect["config_when_Psi_is_not_assigned"].get<int>());
    });
}

/// A query in degrees.
PathQuery query_deg(const Chain& chain, double r1, double r2, double to_r1, double to_r2) {
    PathQuery query =
        query_for(chain, tool_vector(chain, {rad_from_deg(to_r1), rad_from_deg(to_r2), 0}));
    query.start = {rad_from_deg(r1), rad_from_deg(r2), 0};
    return query;
}

AxisRange limits_deg(double lower, double upper) {
    return {rad_from_deg(lower), rad_from_deg(upper)};
}

struct Expected {
    double r1;
    double r2;
    PathReason reason;
};

void expect_end(const Chain& chain, const PathQuery& query, const Expected& expected) {
    const auto end = choose_path(chain, query);
    ASSERT_TRUE(end);
    EXPECT_NEAR(deg_from_rad(end->rotary[kR1]), expected.r1, 1e-9);
    EXPECT_NEAR(deg_from_rad(end->rotary[kR2]), expected.r2, 1e-9);
    EXPECT_EQ(end->reason, expected.reason);
}

// From (0, 80) to the direction of (100, 70): configuration 1 needs 100 and 10, configuration 2, at
// (−80, −70), needs 80 and 150. The rules differ just there.
TEST(PathChoice, RulesOfTheControls) {
    const Chain table = test::chain_of("P_BC_globe");
    const Chain head = test::chain_of("T_CB_head");
    const auto with = [](const Chain& chain, PathRule rule) {
        PathQuery query = query_deg(chain, 0, 80, 100, 70);
        query.rule = rule;
        return query;
    };
    const Expected stays = {100, 70, PathReason::LeastSquares};
    for (const PathRule rule : {PathRule::Shortest, PathRule::LongInAxisMode, PathRule::LongAlways,
                                PathRule::LeastSquares})
        expect_end(head, with(head, rule), stays);
    const Expected turns = {-80, -70, PathReason::LeastFirst};
    expect_end(head, with(head, PathRule::LeastTravel), turns);
    expect_end(table, with(table, PathRule::LeastTravel), turns);
    // FANUC's master is the axis nearest to the base: C of the head, B of the two tables; there it
    // is equal which way C goes round, and the second way decides.
    expect_end(head, with(head, PathRule::MasterFirst), turns);
    expect_end(table, with(table, PathRule::MasterFirst), {100, 70, PathReason::LeastSecond});
}

TEST(PathChoice, TheLeastSumCountsWholeTurns) {
    const Chain chain = test::chain_of("T_CB_head");
    PathQuery query = query_deg(chain, 350, 40, 10, 40);
    query.rule = PathRule::LeastSquares;
    query.limits[kR1] = limits_deg(-720, 720);
    expect_end(chain, query, {370, 40, PathReason::LeastSquares});
    // Without the next turn the way back costs 340² against 160² + 80² of the other configuration.
    query.limits[kR1] = limits_deg(0, 360);
    expect_end(chain, query, {190, -40, PathReason::LeastSquares});
}

// Half a turn either way: configuration 1 at R1 ± 180 with the other one out of limits.
TEST(PathChoice, TiesGoThePositiveWay) {
    const Chain chain = test::chain_of("T_CB_head");
    PathQuery query = query_deg(chain, 0, 40, 180, 40);
    query.limits[kR2] = limits_deg(10, 100);
    expect_end(chain, query, {180, 40, PathReason::Tie});
    query.limits[kR1] = limits_deg(-200, 90);
    expect_end(chain, query, {-180, 40, PathReason::OnlyOne});
}

TEST(PathChoice, FanucTiesAreNearestToZero) {
    const Chain chain = test::chain_of("T_CB_head");
    PathQuery query = query_deg(chain, 90, 0, 180, 40);
    query.rule = PathRule::MasterFirst;
    // (180, 40) and (0, −40) are both 90 and 40 away.
    expect_end(chain, query, {0, -40, PathReason::Tie});
}

TEST(PathChoice, RefusalsSayWhatAndWhere) {
    const Chain chain = test::chain_of("T_CB_head");
    PathQuery query = query_deg(chain, 170, 40, -160, 40);
    query.mode = PathMode::Vector;
    query.limits[kR1] = limits_deg(-180, 180);
    query.limits[kR2] = limits_deg(-100, 100);
    const auto refused = choose_path(chain, query);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, PathChoiceFault::NoCandidate);
    const auto& [first, second] = refused.error().configurations;
    EXPECT_EQ(first.fault, CandidateFault::OnlyLongTravel);
    EXPECT_EQ(first.joint, kR1);
    EXPECT_NEAR(deg_from_rad(first.value), 200, 1e-9);
    EXPECT_NEAR(deg_from_rad(first.limits.upper), 180, 1e-9);
    EXPECT_EQ(second.fault, CandidateFault::OtherConfiguration);
    // By axes, with less room for both.
    query.mode = PathMode::Axis;
    query.limits[kR1] = limits_deg(150, 175);
    query.limits[kR2] = limits_deg(0, 100);
    const auto narrow = choose_path(chain, query);
    ASSERT_FALSE(narrow);
    EXPECT_EQ(narrow.error().configurations[0].fault, CandidateFault::FirstOutside);
    EXPECT_EQ(narrow.error().configurations[1].fault, CandidateFault::SecondOutside);
    EXPECT_EQ(narrow.error().configurations[1].joint, kR2);
    EXPECT_NEAR(deg_from_rad(narrow.error().configurations[1].value), -40, 1e-9);
    // No position at all.
    const Chain nutating = test::chain_of("T_nutating45");
    const auto below = choose_path(nutating, query_for(nutating, Vec3(0, 0.6, -0.8)));
    ASSERT_FALSE(below);
    EXPECT_EQ(below.error().fault, PathChoiceFault::Unreachable);
    EXPECT_EQ(below.error().reach, ReachFault::OutsideReach);
}

TEST(PathChoice, LimitsHoldOnTheWay) {
    // From 60 to 60 past the pole at about 7.6 degrees: R2 may not come below 30.
    const Chain chain = test::chain_of("T_CB_head");
    PathQuery query = query_deg(chain, 0, 60, 170, 60);
    query.mode = PathMode::Vector;
    query.limits[kR2] = limits_deg(30, 100);
    const auto refused = choose_path(chain, query);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().configurations[0].fault, CandidateFault::LimitOnPath);
    EXPECT_EQ(refused.error().configurations[0].joint, kR2);
    // By axes R2 does not move at all.
    query.mode = PathMode::Axis;
    expect_end(chain, query, {170, 60, PathReason::LeastSquares});
    // Option 3 takes that way by itself.
    query.mode = PathMode::Vector;
    query.rule = PathRule::LongAlways;
    const auto end = choose_path(chain, query);
    ASSERT_TRUE(end);
    EXPECT_EQ(end->mode, PathMode::Axis);
}

// A pass of 0.05° at the pole is led through it, if the tolerance says so.
TEST(PathChoice, NearPolesAreLedThrough) {
    const Chain chain = test::chain_of("T_CB_head");
    PathQuery query = query_deg(chain, 0, 40, 179.9, 40);
    query.mode = PathMode::Vector;
    const auto past = choose_path(chain, query);
    ASSERT_TRUE(past);
    EXPECT_FALSE(past->passes_pole);
    EXPECT_NEAR(deg_from_rad(past->rotary[kR1]), 179.9, 1e-9);
    query.pole_tolerance = rad_from_deg(0.1);
    const auto through = choose_path(chain, query);
    ASSERT_TRUE(through);
    EXPECT_TRUE(through->passes_pole);
    EXPECT_TRUE(through->switches_at_pole);
    EXPECT_NEAR(deg_from_rad(through->rotary[kR1]), -0.1, 1e-9);
    EXPECT_NEAR(deg_from_rad(through->rotary[kR2]), -40, 1e-9);
}

/// A block that begins within the tolerance of the pole, but beside it, follows its great circle
/// unless R1 would swing round by more than a quarter: then the other configuration is nearer.
TEST(PathChoice, BesideThePoleTheNearerConfigurationIsTaken) {
    const Chain chain = chain_of("T_CB_head");
    for (const double aside : {1e-6, 1e-4, 8e-4}) {
        for (const double azimuth : {0.0, 40.0, 170.0, 180.0}) {
            PathQuery query =
                query_for(chain, Vec3(std::sin(0.5) * std::cos(rad(azimuth)),
                                      std::sin(0.5) * std::sin(rad(azimuth)), std::cos(0.5)));
            query.start = Vec3(0, aside, 0);  // C 0: the tool leans to +X
            query.mode = PathMode::Vector;
            query.pole_tolerance = rad(0.05);
            const auto end = choose_path(chain, query);
            ASSERT_TRUE(end.has_value());
            EXPECT_LE(std::abs(end->rotary[kR1]), rad(90) + 1e-9) << aside << ' ' << azimuth;
            EXPECT_EQ(end->configuration == configuration_of(chain, query.start), azimuth < 90);
            EXPECT_LT(
                (tool_vector(chain, end->rotary) - query.rotation * chain.tool_direction).norm(),
                1e-9);
        }
    }
}

/// Axes that are out of square do not reach the directions nearest to R1, however few they are.
TEST(PathChoice, GapsOnTheWayAreRefusedOrPassed) {
    for (const double gap : {1e-5, 1e-3, 0.03}) {
        Chain chain;
        chain.joints[kR1] = {true,         Axis::C, ChainSide::Table, Vec3(gap, 0, 1).normalized(),
                             Vec3::Zero(), 1};
        chain.joints[kR2] = {true, Axis::A, ChainSide::Table, Vec3::UnitX(), Vec3::Zero(), 1};
        chain = prepare(chain).value();
        const Vec3 from = Vec3(gap + 0.3, 0.1, 1).normalized();
        const Vec3 to = Vec3(gap - 0.3, -0.1, 1).normalized();
        EXPECT_TRUE(crosses_gap(chain, from, to));
        EXPECT_FALSE(crosses_gap(chain, from, Vec3(gap + 0.3, -0.1, 1).normalized()));
        PathQuery query = query_for(chain, to);
        query.start = solve(chain, from)->all[0].rotary;
        query.mode = PathMode::Vector;
        query.pole_tolerance = rad(0.05);
        EXPECT_TRUE(choose_path(chain, query).has_value()) << gap;  // it is led past the axis
        query.pole_tolerance = 0;
        const auto refused = choose_path(chain, query);
        ASSERT_FALSE(refused.has_value()) << gap;
        EXPECT_EQ(refused.error().fault, PathChoiceFault::NoCandidate);
    }
}

TEST(PathChoice, PoleApproachIsTheNearestPoint) {
    const Chain chain = test::chain_of("T_CB_head");
    const Vec3 from = tool_vector(chain, {0, rad_from_deg(40), 0});
    const Vec3 to = tool_vector(chain, {rad_from_deg(170), rad_from_deg(40), 0});
    const PoleApproach approach = pole_approach(chain, from, to);
    // Symmetric ends: the middle, at the height of the chord. tan d = tan 40 · cos 85.
    EXPECT_NEAR(approach.fraction, 0.5, 1e-12);
    EXPECT_NEAR(std::tan(approach.distance),
                std::tan(rad_from_deg(40)) * std::cos(rad_from_deg(85)), 1e-12);
    // Away from the pole the nearer end is the nearest point.
    const Vec3 lower = tool_vector(chain, {0, rad_from_deg(70), 0});
    EXPECT_NEAR(pole_approach(chain, from, lower).distance, rad_from_deg(40), 1e-12);
    EXPECT_EQ(pole_approach(chain, lower, from).fraction, 1);
}

TEST(PathChoice, OneRotaryAxis) {
    Chain chain;
    chain.joints[kR1] = {true, Axis::A, ChainSide::Table, Vec3::UnitX(), Vec3::Zero(), 1};
    chain = prepare(chain).value();
    PathQuery query = query_deg(chain, 350, 0, 20, 0);
    query.limits[kR1] = limits_deg(-360, 720);
    const auto end = choose_path(chain, query);
    ASSERT_TRUE(end);
    EXPECT_NEAR(deg_from_rad(end->rotary[kR1]), 380, 1e-9);
    query.limits[kR1] = limits_deg(300, 360);
    const auto refused = choose_path(chain, query);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().configurations[0].fault, CandidateFault::FirstOutside);
}

}  // namespace
}  // namespace kadr::machine::path_choice_test
