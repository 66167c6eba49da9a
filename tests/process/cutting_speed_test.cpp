// Constant cutting speed: the law against the oracle, and the planner against the law.
#include "process/cutting_speed.h"

#include <gtest/gtest.h>

#include "base/units.h"
#include "tests/process/support.h"

namespace kadr::process::cutting_speed_test {
namespace {

using namespace test;

constexpr double kTurn = 2 * std::numbers::pi;

FacePass pass_of(const json& in) {
    return {in["R_start"], in["R_end"], in["f_mm_rev"],
            rad_from_deg(in["cone_angle_from_face_deg"].get<double>())};
}

TEST(CuttingSpeedOracle, SpeedsAccelerationsAndTimes) {
    const json data = oracle("css.json");
    const double part = data["tolerance"]["rel"];
    const double acceleration_part = data["tolerance"]["accel_rel"];
    int samples = 0;
    for (const json& entry : data["cases"]) {
        SCOPED_TRACE(entry["id"].get<std::string>());
        EXPECT_EQ(entry["kind"], "facing_pass");
        const json& in = entry["input"];
        const json& expected = entry["expect"];
        const motion::CommandedSpindle spindle = spindle_of(in["V_m_min"], in["n_max_rpm"]);
        const FacePass pass = pass_of(in);
        const auto near = [part](double got, double want) {
            EXPECT_NEAR(got, want, part * std::abs(want));
        };
        near(limit_radius(spindle), expected["R_at_speed_limit"]);
        near(pass_time(spindle, pass), expected["time_s"]);
        near(pass_revolutions(pass), expected["revolutions"]);
        for (const json& sample : expected["samples"]) {
            const double radius = sample["R"];
            near(rpm_from_speed(spindle.speed_at(radius)), sample["n_rpm"]);
            near(mm_min_from_feed(feed_speed(spindle, pass, radius)), sample["feed_mm_min"]);
            near(cutting_speed(spindle, radius) * 60 / 1000, sample["cutting_speed_m_min"]);
            ++samples;
            if (sample["spindle_accel_rad_s2"].is_null()) continue;  // at the kink
            const double want = sample["spindle_accel_rad_s2"];
            EXPECT_NEAR(spindle_acceleration(spindle, pass, radius), want,
                        acceleration_part * want);
        }
    }
    EXPECT_GE(samples, 20);
}

TEST(CuttingSpeed, TheLeastSpeedActsOutside) {
    // 200 m/min at 400 rpm: 200000 / (2π·400) = 79.577 mm.
    motion::CommandedSpindle spindle = spindle_of(200, 3000);
    spindle.least = speed_from_rpm(400);
    EXPECT_NEAR(least_speed_radius(spindle), 79.5775, 1e-4);
    EXPECT_NEAR(rpm_from_speed(spindle.speed_at(100)), 400, 1e-9);
    EXPECT_NEAR(rpm_from_speed(spindle.speed_at(50)), 200000 / (std::numbers::pi * 100), 1e-9);
    // 10 mm at 0.3 mm a revolution and 400 revolutions a minute.
    EXPECT_NEAR(pass_time(spindle, {100, 90, 0.3}), 10 / (0.3 * 400) * 60, 1e-9);
    // Outside of the edge steady, inside as without the bound.
    const double edge = least_speed_radius(spindle);
    EXPECT_NEAR(pass_time(spindle, {100, 50, 0.3}),
                (100 - edge) / (0.3 * 400) * 60 + pass_time(spindle_of(200, 3000), {edge, 50, 0.3}),
                1e-9);
    EXPECT_EQ(spindle_acceleration(spindle, {100, 50, 0.3}, 90), 0);
    EXPECT_GT(spindle_acceleration(spindle, {100, 50, 0.3}, 70), 0);
    spindle.limit = speed_from_rpm(300);  // the lower one of both counts
    EXPECT_NEAR(rpm_from_speed(spindle.speed_at(10)), 300, 1e-9);
    EXPECT_NEAR(pass_time(spindle, {100, 90, 0.3}), 10 / (0.3 * 300) * 60, 1e-9);
}

TEST(CuttingSpeed, APassThroughTheCentreIsTwoPasses) {
    const motion::CommandedSpindle spindle = spindle_of(200, 3000);
    const FacePass in{50, 0, 0.3};
    const FacePass out{0, -2, 0.3};
    const FacePass through{50, -2, 0.3};
    EXPECT_DOUBLE_EQ(pass_time(spindle, through), pass_time(spindle, in) + pass_time(spindle, out));
    // 2 mm at 0.3 mm a revolution and 50 revolutions a second.
    EXPECT_NEAR(pass_time(spindle, out), 2 / (0.3 * 50), 1e-12);
    EXPECT_NEAR(cutting_speed(spindle, -50), 200'000.0 / 60, 1e-9);
}

TEST(CuttingSpeed, WithoutALimitTheCutGrowsToTheCentre) {
    const motion::CommandedSpindle spindle = spindle_of(200, 0);
    EXPECT_EQ(limit_radius(spindle), 0);
    EXPECT_NEAR(spindle.speed_at(0.01) * kTurn * 0.01, 200'000.0 / 60, 1e-6);
    EXPECT_GT(spindle_acceleration(spindle, {10, 1, 0.3}, 0.1), 1e6);
}

/// The planner cuts a pass into parts of one feed each; their times add up to the law's.
TEST(CuttingSpeed, ThePlannerTakesTheTimeOfTheLaw) {
    const machine::Machine machine = motion::test::machine_of();
    const json cases = oracle("css.json")["cases"];
    for (const json& entry : cases) {
        SCOPED_TRACE(entry["id"].get<std::string>());
        const json& in = entry["input"];
        if (in["cone_angle_from_face_deg"] != 0) continue;
        const motion::test::Motion run = motion::test::run(
            machine,
            facing(in["V_m_min"], in["n_max_rpm"], in["R_start"], in["R_end"], in["f_mm_rev"]));
        const double want = entry["expect"]["time_s"];
        constexpr double kRamps = 5e-4;  // s, from rest and to it
        EXPECT_NEAR(run.totals.cutting_time, want, 2e-4 * want + kRamps);
    }
}

TEST(CuttingSpeed, ThePlannerKeepsTheLeastSpeed) {
    std::vector<path::Command> commands = facing(200, 3000, 100, 50, 0.3);
    commands[1].speed_limit().least = 400;
    motion::CommandedSpindle spindle = spindle_of(200, 3000);
    spindle.least = speed_from_rpm(400);
    const double want = pass_time(spindle, {100, 50, 0.3});
    const motion::test::Motion run = motion::test::run(motion::test::machine_of(), commands);
    EXPECT_NEAR(run.totals.cutting_time, want, 2e-4 * want + 5e-4);
    EXPECT_LT(want, pass_time(spindle_of(200, 3000), {100, 50, 0.3}) - 0.1);
}

}  // namespace
}  // namespace kadr::process::cutting_speed_test
