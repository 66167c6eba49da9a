// What a program says of how fast its motions may be: parts of the machine's limits, and of F.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/motion/support.h"

namespace kadr::motion::dynamics_test {
namespace {

using namespace test;

/// A program's dynamics with one thing said.
template <class Say>
Command under(Command command, Say say) {
    path::Dynamics dynamics;
    say(dynamics);
    command.motion().dynamics = {dynamics};
    return command;
}

TEST(Dynamics, TimesOfALine) {
    // 1000 mm at 100 mm/s, 5000 mm/s²; X has 500 mm/s. Ramps up and down cost v/a.
    struct Row {
        const char* name;
        Command command;
        double time;
    };
    const Command line = line_to({1000, 0, 0}, 6000);
    const Command rapid = rapid_to({1000, 0, 0});
    for (const Row& row : {
             Row{"half the feed", under(line, [](auto& d) { d.feed = 0.5; }), 20 + 50.0 / 5000},
             {"twice the feed", under(line, [](auto& d) { d.feed = 2; }), 5 + 200.0 / 5000},
             {"a fifth of the acceleration", under(line, [](auto& d) { d.acceleration[0] = 0.2; }),
              10 + 100.0 / 1000},
             {"twice the acceleration", under(line, [](auto& d) { d.acceleration[0] = 2; }),
              10 + 100.0 / 10000},
             {"of another axis", under(line, [](auto& d) { d.acceleration[1] = 0.2; }),
              10 + 100.0 / 5000},
             {"a tenth of the velocity", under(line, [](auto& d) { d.velocity[0] = 0.1; }),
              20 + 50.0 / 5000},
             {"rapid has its own", under(rapid, [](auto& d) { d.feed = 0.5; }), 2 + 500.0 / 5000},
             {"half of rapid", under(rapid, [](auto& d) { d.rapid = 0.5; }), 4 + 250.0 / 5000},
         }) {
        SCOPED_TRACE(row.name);
        EXPECT_NEAR(run(machine_of(), {row.command}).totals.time, row.time, 1e-9);
    }
}

TEST(Dynamics, TheOperatorsOverrideComesOnTop) {
    const Command line = under(line_to({1000, 0, 0}, 6000), [](auto& d) { d.feed = 0.5; });
    PlannerOptions options;
    options.feed_override = 0.4;
    EXPECT_NEAR(run(machine_of(), {line}, options).totals.time, 50 + 20.0 / 5000, 1e-9);
    PlannerOptions turned;
    turned.events = {{OperatorAct::FeedOverride, 0.4, 0, 0, -1}};
    EXPECT_NEAR(run(machine_of(), {line}, turned).totals.time, 50 + 20.0 / 5000, 1e-9);
}

TEST(Dynamics, TheJerkHasItsPart) {
    // v/J < a²/J²: up in 2·sqrt(v/J).
    const auto machine = machine_of({.jerk = Vec3(50000, 50000, 40000)});
    const Command line = under(line_to({1000, 0, 0}, 6000), [](auto& d) { d.jerk[0] = 0.25; });
    EXPECT_NEAR(run(machine, {line}).totals.time, 10 + 2 * std::sqrt(100 / 12500.0), 1e-9);
}

/// From tick to tick no axis leaves what the program leaves it; at the corner between two motions
/// it keeps what both leave.
TEST(Dynamics, SetpointsKeepTheLimits) {
    for (const double jerk : {kUnlimited, 50000.0}) {
        SCOPED_TRACE(jerk);
        const auto machine = machine_of({.jerk = Vec3::Constant(jerk)});
        const auto slow = [](auto& d) { d.acceleration[0] = d.acceleration[1] = 0.3; };
        const std::vector<Command> program = {
            line_to({50, 0, 0}, 12000),
            under(line_to({100, 5, 0}, 12000), slow),
            under(arc_to({100, 65, 0}, {100, 35, 0}, std::numbers::pi, 12000), slow),
            line_to({50, 60, 0}, 12000),
            under(line_to({0, 65, 0}, 12000), [](auto& d) { d.velocity[0] = 0.2; }),
            line_to({-50, 60, 0}, 12000),
        };
        const auto is_in_slow = [](const Setpoint& at) {
            return at.axis[0] > 100 || (at.axis[0] > 50 && at.axis[1] < 20);
        };
        const Motion motion = run(machine, program);
        const auto points = sample(machine, program);
        std::array<double, 2> most{};  // of the slow part, and elsewhere
        double fastest = 0;
        for (std::size_t i = 2; i < points.size(); ++i) {
            const double tick = machine.tick;
            const bool is_slow = is_in_slow(points[i - 2]) && is_in_slow(points[i]);
            for (std::size_t a = 0; a < 2; ++a) {
                const double v = (points[i].axis[a] - points[i - 1].axis[a]) / tick;
                const double before = (points[i - 1].axis[a] - points[i - 2].axis[a]) / tick;
                most[is_slow] = std::max(most[is_slow], std::abs(v - before) / tick);
                const bool is_limited =
                    points[i].axis[0] < 49.9 && points[i].axis[0] > 0.1 && points[i].axis[1] > 55;
                if (is_limited && a == 0) fastest = std::max(fastest, std::abs(v));
            }
        }
        EXPECT_LE(most[1], 1500 * (1 + 1e-6));
        EXPECT_GT(most[1], 1000);
        EXPECT_LE(most[0], 5000 * (1 + 1e-6));
        EXPECT_LE(fastest, 100 * (1 + 1e-6));
        EXPECT_GT(fastest, 99);
        EXPECT_TRUE(motion.diagnostics.all().empty());
    }
}

TEST(Dynamics, AProgramThatTakesAllSpeedIsAnAlarm) {
    const Motion result =
        run(machine_of(), {under(line_to({1000, 0, 0}, 6000), [](auto& d) { d.feed = 0; })});
    ASSERT_EQ(result.diagnostics.all().size(), 1u);
    EXPECT_EQ(result.diagnostics.all()[0].row->code, "K6210");
}

}  // namespace
}  // namespace kadr::motion::dynamics_test
