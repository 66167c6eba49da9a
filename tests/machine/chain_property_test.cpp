// Properties of every stock machine with rotary axes: ways there and back, all solutions,
// velocities.
#include <algorithm>
#include <filesystem>
#include <random>

#include "base/disk_files.h"
#include "machine/machine.h"
#include "tests/machine/support.h"

namespace kadr::machine::chain_property_test {
namespace {

constexpr double kPi = std::numbers::pi;

class Random {
  public:
    double between(double a, double b) {
        return a + (b - a) * static_cast<double>(engine_()) / 4294967296.0;
    }
    Vec3 place(double size) {
        return {between(-size, size), between(-size, size), between(-size, size)};
    }

  private:
    std::mt19937 engine_{20261123};
};

struct Named {
    std::string name;
    Chain chain;
};

/// Stock machines, and chains that no stock machine has: all signs, crooked axes.
std::vector<Named> chains() {
    const std::string folder = std::string(KADR_ROOT) + "/runtime/machines";
    std::vector<Named> found;
    for (const MachineSummary& summary : list({folder}, disk())) {
        Sources sources;
        DiagnosticList diagnostics;
        const auto machine = load_machine(summary.name, {folder}, sources, diagnostics);
        if (machine && machine->kinematics)
            found.push_back({summary.name, machine->kinematics->chain});
    }
    EXPECT_EQ(found.size(), 9u);
    Random random;
    for (const char* name : {"P_AC_globe", "P_BC_globe", "T_CB_head", "T_CA_head", "T_nutating45",
                             "M_C_table_B_head", "M_A_table_B_head"}) {
        for (int variant = 0; variant < 4; ++variant) {
            Chain chain = test::chain_of(name, variant >= 2);
            if (variant % 2 == 1) {
                // As a machine is built: nothing quite at right angles, and the other signs.
                for (RotaryJoint& joint : chain.joints) {
                    joint.sign = -1;
                    joint.direction = (joint.direction + random.place(0.05)).normalized();
                    joint.point += random.place(5);
                }
                chain.tool_direction = (chain.tool_direction + random.place(0.05)).normalized();
                chain.joints[kPsi].direction = chain.tool_direction;
            }
            found.push_back({name + std::to_string(variant), prepare(chain).value()});
        }
    }
    return found;
}

ChainPosition random_position(Random& random, double turn = kPi) {
    ChainPosition position;
    position.linear = random.place(500);
    position.parallel = random.place(50);
    position.rotary = {random.between(-turn, turn), random.between(-turn, turn),
                       random.between(-turn, turn)};
    return position;
}

TEST(ChainProperty, ForwardOfEverySolutionIsThePose) {
    Random random;
    for (const Named& machine : chains()) {
        const Chain& chain = machine.chain;
        SCOPED_TRACE(machine.name);
        for (int i = 0; i < 2000; ++i) {
            ChainPosition position = random_position(random);
            const Vec3 tip = tip_of_length(chain, random.between(0, 200)) + random.place(5);
            const Pose pose = forward(chain, position, tip);
            const auto solutions = solve(chain, pose.rotation);
            ASSERT_TRUE(solutions);
            bool is_found = false;
            for (const Solution& solution : *solutions) {
                ChainPosition again;
                again.rotary = solution.rotary;
                again.parallel = position.parallel;
                again.linear = inverse_linear(chain, pose.tip, again, tip);
                const Pose back = forward(chain, again, tip);
                ASSERT_LT((back.tip - pose.tip).norm(), 1e-9);
                ASSERT_LT(
                    (back.rotation * chain.tool_direction - pose.rotation * chain.tool_direction)
                        .norm(),
                    1e-9);
                if (chain.has(kPsi)) {
                    ASSERT_LT((back.rotation - pose.rotation).norm(), 1e-8);
                }
                double off = 0;
                for (const std::size_t k : {kR1, kR2}) {
                    const auto at = static_cast<Eigen::Index>(k);
                    if (chain.has(k))
                        off = std::max(off, test::apart(solution.rotary[at], position.rotary[at]));
                }
                is_found = is_found || off < 1e-6;
            }
            ASSERT_TRUE(is_found)
                << "the position that the pose came from is none of the solutions";
        }
    }
}

/// The solutions for a direction, found without the solver: every change of sign of the
/// height of the tool above the base of R1, over a whole turn of R2, is one.
int count_by_search(const Chain& chain, const Vec3& direction) {
    const Vec3& n1 = chain.joints[kR1].direction;
    const double wanted = n1.dot(direction);
    const auto height = [&](double second) {
        return n1.dot(tool_vector(chain, {0, second, 0})) - wanted;
    };
    constexpr int kSteps = 720;
    int count = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double a = -kPi + 2 * kPi * i / kSteps;
        const double b = -kPi + 2 * kPi * (i + 1) / kSteps;
        if ((height(a) < 0) != (height(b) < 0)) ++count;
    }
    return count;
}

TEST(ChainProperty, AllSolutionsAreFound) {
    Random random;
    for (const Named& machine : chains()) {
        const Chain& chain = machine.chain;
        if (!chain.orients()) continue;
        SCOPED_TRACE(machine.name);
        const PoleAngleReach reach = pole_angle_reach(chain);
        int reached = 0;
        for (int i = 0; i < 100; ++i) {
            Vec3 direction = random.place(1);
            if (direction.norm() < 0.1) continue;
            direction.normalize();
            const double tilt = pole_angle_of(chain, direction);
            // At the end of the reach the search by steps sees both solutions as none.
            if (std::abs(tilt - reach.lower) < 0.02 || std::abs(tilt - reach.upper) < 0.02)
                continue;
            const auto solutions = solve(chain, direction);
            const int count = count_by_search(chain, direction);
            ASSERT_EQ(solutions ? static_cast<int>(solutions->count) : 0, count);
            ASSERT_EQ(solutions.has_value(), tilt > reach.lower && tilt < reach.upper);
            reached += count;
        }
        EXPECT_GT(reached, 50);
    }
}

// Close to the pole, where an arc cosine would lose half of the digits.
TEST(ChainProperty, DigitsAreKeptAtThePole) {
    Random random;
    for (const char* name : {"P_AC_globe", "T_CB_head", "T_nutating45", "M_A_table_B_head"}) {
        SCOPED_TRACE(name);
        const Chain chain = test::chain_of(name);
        const Vec3& n1 = chain.joints[kR1].direction;
        for (double inclination = 1e-3; inclination > 2e-9; inclination /= 3) {
            const Vec3 direction =
                (n1 + inclination * n1.unitOrthogonal() * random.between(1, 2)).normalized();
            const auto solutions = solve(chain, direction);
            ASSERT_TRUE(solutions);
            ASSERT_EQ(solutions->count, 2u) << inclination;
            for (const Solution& solution : *solutions) {
                EXPECT_FALSE(solution.is_pole);
                EXPECT_LT((tool_vector(chain, solution.rotary) - direction).norm(), 1e-14);
            }
        }
    }
}

TEST(ChainProperty, VelocitiesAreDifferences) {
    Random random;
    constexpr double h = 1e-6;
    for (const Named& machine : chains()) {
        const Chain& chain = machine.chain;
        SCOPED_TRACE(machine.name);
        for (int i = 0; i < 500; ++i) {
            const ChainPosition here = random_position(random);
            const Vec3 tip = tip_of_length(chain, 120) + random.place(5);
            ChainVelocity axes;
            axes.linear = random.place(10);
            for (const std::size_t k : {kR1, kR2, kPsi}) {
                if (chain.has(k)) axes.rotary[static_cast<Eigen::Index>(k)] = random.between(-1, 1);
            }
            const auto moved = [&](double by) {
                ChainPosition position = here;
                position.linear += by * axes.linear;
                position.rotary += by * axes.rotary;
                return forward(chain, position, tip);
            };
            const ToolVelocity tool = tool_velocity(chain, here, tip, axes);
            const Pose before = moved(-h);
            const Pose after = moved(h);
            EXPECT_LT(((after.tip - before.tip) / (2 * h) - tool.tip).norm(), 1e-5);
            const Mat3 rate = (after.rotation - before.rotation) / (2 * h);
            const Mat3 rotation = moved(0).rotation;
            for (int column = 0; column < 3; ++column) {
                const Vec3 turned = tool.turn.cross(Vec3(rotation.col(column)));
                EXPECT_LT((rate.col(column) - turned).norm(), 1e-8);
            }
            // And back: the axes that give this velocity are the ones that made it.
            EXPECT_LT(
                (linear_velocity(chain, here, tip, tool.tip, axes.rotary) - axes.linear).norm(),
                1e-9);
            if (chain.orients() &&
                std::sin(pole_angle_of(chain, tool_vector(chain, here.rotary))) < 0.02)
                continue;
            const auto back = axis_velocities(chain, here, tip, tool);
            ASSERT_TRUE(back);
            ChainVelocity expected = axes;
            // Without Ψ, or with one axis along the tool, that part of the turn belongs to nobody.
            if (!chain.orients()) continue;
            const double determinant = std::abs(chain.joints[kR1].direction.dot(
                rotation_of(chain, {here.rotary[kR1], 0, 0}) *
                chain.joints[kR2].direction.cross(rotation_of(chain, {0, here.rotary[kR2], 0}) *
                                                  chain.tool_direction)));
            if (determinant < 0.02) continue;
            EXPECT_LT((back->rotary - expected.rotary).norm(), 1e-9 / determinant);
            EXPECT_LT((back->linear - expected.linear).norm(), 1e-6 / determinant);
        }
    }
}

TEST(ChainProperty, AtThePoleOnlyTheSecondAxisTurns) {
    const Chain chain = test::chain_of("T_CB_head");
    ChainPosition position;
    position.rotary = {0.4, 0, 0};
    ToolVelocity along;
    // B tilts the tool about the axis that C has turned to: R1 may stand.
    along.turn = Vec3(-std::sin(0.4), std::cos(0.4), 0);
    const auto passing = axis_velocities(chain, position, Vec3(0, 0, -100), along);
    ASSERT_TRUE(passing);
    EXPECT_NEAR(passing->rotary[kR1], 0, 1e-12);
    EXPECT_NEAR(passing->rotary[kR2], 1, 1e-12);
    along.turn = Vec3(std::cos(0.4), std::sin(0.4), 0);
    EXPECT_EQ(axis_velocities(chain, position, Vec3(0, 0, -100), along).error(),
              VelocityFault::Singular);
    // One rotary axis tilts the tool in its own plane only.
    const Chain single = test::chain_of("P_AC_globe", false, false);
    EXPECT_EQ(axis_velocities(single, position, Vec3(0, 0, -100), along).error(),
              VelocityFault::MissingJoint);
}

/// A great circle of pole.json, and the solution on it in the configuration of its start.
struct Circle {
    Chain chain;
    Vec3 start;  // rotary positions
    Vec3 from;
    Vec3 axis;
    double angle;

    explicit Circle(const test::json& in)
        : chain(test::chain_of(in["machine"])),
          start(test::rad(in["start_R1_R2"][0]), test::rad(in["start_R1_R2"][1]), 0),
          from(tool_vector(chain, start)) {
        const Vec3 to = test::vec(in["target_vector"]).normalized();
        axis = from.cross(to).normalized();
        angle = std::atan2(from.cross(to).norm(), from.dot(to));
    }

    Vec3 rotary_at(double fraction) const {
        const auto solutions = solve(chain, Vec3(rotation_about(axis, fraction * angle) * from));
        const int kept = configuration_of(chain, start);
        if (solutions) {
            for (const Solution& solution : *solutions) {
                if (solution.configuration == kept) return solution.rotary;
            }
        }
        ADD_FAILURE() << "no solution at " << fraction;
        return start;
    }
};

TEST(ChainProperty, FirstAxisFollowsTheGreatCircle) {
    test::for_each_case(
        "pole.json", "vector_path", 12, [](const test::json& in, const test::json& expect) {
            const Circle circle(in);
            EXPECT_NEAR(circle.angle, test::rad(expect["angle_deg"]), test::kAngleTolerance);
            const test::json& fractions = in["fractions_of_path_length"];
            for (std::size_t i = 0; i < fractions.size(); ++i) {
                const Vec3 rotary = circle.rotary_at(fractions[i].get<double>());
                const double first = circle.start[kR1] +
                                     first_along_great_circle(circle.chain, circle.start, rotary);
                const test::json& wanted = expect["R1_R2"][i];
                EXPECT_NEAR(first, test::rad(wanted[0]), test::kAngleTolerance);
                EXPECT_NEAR(rotary[kR2], test::rad(wanted[1]), test::kAngleTolerance);
            }
        });
}

// The greatest rate of R1 along the circle, as the velocities of the axes have it.
TEST(ChainProperty, GreatestRateOfTheFirstAxis) {
    test::for_each_case(
        "pole.json", "vector_path", 12, [](const test::json& in, const test::json& expect) {
            const Circle circle(in);
            double greatest = 0;
            for (int i = 0; i <= 20000; ++i) {
                ChainPosition position;
                position.rotary = circle.rotary_at(i / 20000.0);
                const auto velocity = axis_velocities(circle.chain, position, Vec3::Zero(),
                                                      {Vec3::Zero(), circle.axis});
                ASSERT_TRUE(velocity);
                greatest = std::max(greatest, std::abs(velocity->rotary[kR1]));
            }
            const double wanted = expect["largest_dR1_per_degree_of_vector"].get<double>();
            EXPECT_NEAR(greatest, wanted, 1e-3 * wanted);
        });
}

// pole.json, through_pole: the ends of both ways through the pole (their times are the planner's).
TEST(ChainProperty, BothWaysThroughThePole) {
    test::for_each_case(
        "pole.json", "through_pole", 3, [](const test::json& in, const test::json& expect) {
            const Chain chain = test::chain_of(in["machine"]);
            PathQuery query = query_for(chain, test::vec(in["target_vector"]).normalized());
            query.start = {test::rad(in["start_R1_R2"][0]), test::rad(in["start_R1_R2"][1]), 0};
            query.mode = PathMode::Vector;
            const double to_deg = std::pow(deg_from_rad(1), 2);
            const auto switched = choose_path(chain, query);
            ASSERT_TRUE(switched);
            EXPECT_TRUE(switched->switches_at_pole);
            EXPECT_TRUE(switched->passes_pole);
            const test::json& by_switch = expect["switch"];
            EXPECT_NEAR(switched->rotary[kR1], test::rad(by_switch["R1_end"]),
                        test::kAngleTolerance);
            EXPECT_NEAR(switched->rotary[kR2], test::rad(by_switch["R2_end"]),
                        test::kAngleTolerance);
            EXPECT_NEAR(switched->sum_squares * to_deg, by_switch["sum_squares"].get<double>(),
                        1e-3);
            // With R2 kept on its side the other way is left.
            const double pole = chain.tilt.nearest;
            const bool is_above = query.start[kR2] > pole;
            const auto keep_off = [&](double by) {
                return is_above ? AxisRange{pole + by, pole + kPi}
                                : AxisRange{pole - kPi, pole - by};
            };
            query.limits[kR2] = keep_off(0);
            const auto turned = choose_path(chain, query);
            ASSERT_TRUE(turned);
            EXPECT_FALSE(turned->switches_at_pole);
            EXPECT_TRUE(turned->passes_pole);
            const test::json& by_turn = expect["stop_and_turn"];
            EXPECT_NEAR(std::abs(turned->rotary[kR1] - query.start[kR1]),
                        test::rad(by_turn["R1_change_abs"]), test::kAngleTolerance);
            EXPECT_NEAR(turned->rotary[kR2], test::rad(by_turn["R2_end"]), test::kAngleTolerance);
            // And with R2 kept off the pole itself there is none.
            query.limits[kR2] = keep_off(0.02);
            const auto refused = choose_path(chain, query);
            ASSERT_FALSE(refused);
            const int kept = configuration_of(chain, query.start);
            const auto& why = refused.error().configurations;
            EXPECT_EQ(why[static_cast<std::size_t>(kept - 1)].fault, CandidateFault::LimitOnPath);
            EXPECT_EQ(why[static_cast<std::size_t>(2 - kept)].fault, CandidateFault::SecondOutside);
        });
}

}  // namespace
}  // namespace kadr::machine::chain_property_test
