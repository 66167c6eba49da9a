// Motion from point to point against the third-order profile of least time, in closed form.
//
// The time of a rapid from rest to rest is the least there is on its line; of one that is cut into
// pieces as well. What the line itself costs against axes that go each by itself is told in
// bench/README.md.
#include "bench/point_to_point.h"

#include <gtest/gtest.h>

#include "tests/motion/support.h"
#include "tests/motion/tick_limits.h"

namespace kadr::motion::point_to_point_test {
namespace {

using namespace test;
using bench::least_time;
using bench::Transfer;

Vec3 end_of(const Transfer& transfer) {
    return {transfer.delta[0], transfer.delta[1], transfer.delta[2]};
}

TEST(PointToPoint, TheFourCasesOfTheClosedForm) {
    // v = 100 mm/s, a = 1000 mm/s², j = 50,000 mm/s³: ramps of 0.1 + 0.02 s, 6 mm each.
    EXPECT_NEAR(least_time(50, {100, 1000, 50'000}), 0.12 + 38.0 / 100 + 0.12, 1e-12);
    EXPECT_NEAR(least_time(12, {100, 1000, 50'000}), 0.24, 1e-12);
    // Up to (√(20² + 4·1000·6) − 20)/2 = 68.1025 mm/s, without a cruise.
    EXPECT_NEAR(least_time(6, {100, 1000, 50'000}), 2 * (0.068102496759067 + 0.02), 1e-12);
    // Below 2a³/j² the acceleration is not reached; S = 2·j·Tj³.
    EXPECT_NEAR(least_time(2, {1000, 1000, 10'000}), 4 * std::cbrt(1e-4), 1e-12);
    // The speed is reached before the acceleration is: Tj = √(v/j) = 0.05 s, 4·Tj and the cruise.
    EXPECT_NEAR(least_time(10, {25, 1000, 10'000}), 10.0 / 25 + 0.1, 1e-12);
    // All cases meet where they change.
    for (const double v : {10.0, 90.0, 100.0, 110.0, 1000.0}) {
        const bench::ThirdOrder limits{v, 1000, 10'000};
        for (const double s : {2 * v * std::sqrt(v / 1e4), v * (v / 1000 + 0.1), 20.0})
            EXPECT_NEAR(least_time(s * (1 - 1e-9), limits), least_time(s * (1 + 1e-9), limits),
                        1e-7);
    }
}

TEST(PointToPoint, OneAxisTakesTheLeastTime) {
    bench::Transfers transfers(1);
    for (int i = 0; i < 2000; ++i) {
        const Transfer transfer = transfers.next(1);
        const Motion motion = run(bench::machine_for(transfer), {rapid_to(end_of(transfer))});
        const double least = bench::least_time_straight(transfer);
        ASSERT_NEAR(motion.totals.time, least, 1e-8 * least) << i;
    }
}

TEST(PointToPoint, ThreeAxesTogetherTakeTheLeastTimeOfTheirLine) {
    bench::Transfers transfers(2);
    double worst = 1;
    double sum = 0;
    constexpr int kCount = 2000;
    for (int i = 0; i < kCount; ++i) {
        const Transfer transfer = transfers.next(3);
        const Motion motion = run(bench::machine_for(transfer), {rapid_to(end_of(transfer))});
        const double least = bench::least_time_straight(transfer);
        ASSERT_NEAR(motion.totals.time, least, 1e-8 * least) << i;
        // Axes that go each by itself are never slower, and the line seldom costs much.
        const double ratio = motion.totals.time / bench::least_time_free(transfer);
        ASSERT_GE(ratio, 1 - 1e-9);
        worst = std::max(worst, ratio);
        sum += ratio;
    }
    RecordProperty("line_against_free_axes_mean", std::to_string(sum / kCount));
    RecordProperty("line_against_free_axes_worst", std::to_string(worst));
    EXPECT_LT(sum / kCount, 1.1);
}

TEST(PointToPoint, ALineInPiecesTakesTheTimeOfTheWholeLine) {
    bench::Transfers transfers(3);
    for (int i = 0; i < 200; ++i) {
        const Transfer transfer = transfers.next(3);
        std::vector<Command> commands;
        for (int piece = 1; piece <= 50; ++piece)
            commands.push_back(rapid_to(end_of(transfer) * piece / 50));
        const Motion motion = run(bench::machine_for(transfer), commands);
        const double least = bench::least_time_straight(transfer);
        ASSERT_GE(motion.totals.time, least * (1 - 1e-8)) << i;
        ASSERT_LE(motion.totals.time, least * (1 + 1e-6)) << i;
    }
}

TEST(PointToPoint, ThereAndBackWithStopsIsTheSum) {
    bench::Transfers transfers(4);
    for (int i = 0; i < 200; ++i) {
        const Transfer transfer = transfers.next(3);
        std::vector<Command> commands = {rapid_to(end_of(transfer)), rapid_to(Vec3::Zero()),
                                         rapid_to(end_of(transfer) / 7)};
        for (Command& command : commands) command.motion().exact_stop = true;
        Transfer seventh = transfer;
        for (double& distance : seventh.delta) distance /= 7;
        const double least =
            2 * bench::least_time_straight(transfer) + bench::least_time_straight(seventh);
        const Motion motion = run(bench::machine_for(transfer), commands);
        ASSERT_NEAR(motion.totals.time, least, 1e-8 * least) << i;
    }
}

/// What is sampled keeps every limit from tick to tick and arrives at the first tick behind the
/// least time.
TEST(PointToPoint, SetpointsKeepTheLimitsAndArriveInTime) {
    bench::Transfers transfers(5);
    for (int i = 0; i < 100; ++i) {
        const Transfer transfer = transfers.next(3);
        const machine::Machine machine = bench::machine_for(transfer);
        const std::vector<Command> commands = {rapid_to(end_of(transfer))};
        const std::vector<Setpoint> setpoints = sample(machine, commands);
        const Motion motion = run(machine, commands);
        TickWatch watch(machine, motion.segments);
        for (const Setpoint& setpoint : setpoints) watch.add(setpoint);
        EXPECT_LE(watch.shares().velocity, 1.001) << i;
        EXPECT_LE(watch.shares().acceleration, 1.001) << i;
        EXPECT_LE(watch.shares().jerk, 1.001) << i;
        const double least = bench::least_time_straight(transfer);
        ASSERT_EQ(setpoints.back().time, machine.tick * ticks_of(least, machine.tick)) << i;
        ASSERT_LT((setpoints.back().tip - end_of(transfer)).norm(), 1e-12) << i;
    }
}

}  // namespace
}  // namespace kadr::motion::point_to_point_test
