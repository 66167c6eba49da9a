#include "tests/machine/support.h"

namespace kadr::machine {
namespace {

using test::json;

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
        if (!end) return;
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

}  // namespace
}  // namespace kadr::machine
