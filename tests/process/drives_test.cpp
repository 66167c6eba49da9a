// The model of the drives against the oracle, and a program on it against the same numbers.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "process/drive_run.h"
#include "process/facing_pass.h"
#include "tests/process/support.h"

namespace kadr::process::drives_test {
namespace {

using namespace test;

constexpr double kTurn = 2 * std::numbers::pi;

machine::Drives drives_of(const json& in) {
    machine::Drives drives;
    drives.spindle.inertia = in["J"];
    drives.spindle.torque_constant = in["kT"];
    drives.spindle.time_constant = in["T_sigma"];
    drives.spindle.friction = in["M0"];
    drives.spindle.damping = in["b"];
    drives.feed.gain = in["Kv"];
    drives.feed.feed_forward = in["kff"];
    drives.feed.time_constant = in["T_v"];
    drives.cutting_force = in["Fz"];
    return drives;
}

FacingPass pass_of(const json& in) {
    FacingPass pass;
    pass.radius = in["R0"].get<double>() * 1000;
    pass.spindle.is_turning = pass.spindle.holds_cutting_speed = true;
    pass.spindle.cutting_speed = in["V"].get<double>() * 1000;
    pass.spindle.limit = in["omega_max"].get<double>() / kTurn;
    pass.feed_per_revolution = in["f"].get<double>() * 1000;
    pass.rapid = in["v_rapid"].get<double>() * 1000;
    pass.acceleration = in["a_feed"].get<double>() * 1000;
    pass.ramp_time = in["T_ramp"];
    return pass;
}

/// What the oracle tells of a pass.
struct Told {
    std::vector<FacingSample> samples;
    std::vector<double> crossings;  // s
    double least_radius = 0;        // mm
    double least_before_peak = 0;   // A
    FacingSample peak;
    double half_limit_current = 0;  // A, half way from the radius of the limit to the centre
    double half_limit_radius = 0;   // mm, of the sample there
    double return_time = 0;
};

Told run(const machine::Drives& drives, const FacingPass& pass, const json& times) {
    Told told;
    std::optional<FacingSample> last;
    std::size_t next = 0;
    told.least_before_peak = 1e9;
    double least = 1e9;  // since the near zone began
    const double step = longest_step(drives);
    told.return_time = run_facing_pass(drives, pass, step, [&](const FacingSample& sample) {
        if (next < times.size() && sample.time >= times[next]["t"].get<double>()) {
            told.samples.push_back(sample);
            ++next;
        }
        if (last && (last->radius > 0) != (sample.radius > 0)) {
            const double part = last->radius / (last->radius - sample.radius);
            told.crossings.push_back(last->time + part * (sample.time - last->time));
        }
        told.least_radius = std::min(told.least_radius, sample.radius);
        if (sample.is_cutting && sample.radius < 0.4 * pass.radius) {
            least = std::min(least, sample.current);
            if (sample.current > told.peak.current) {
                told.peak = sample;
                told.least_before_peak = least;
            }
        }
        const double half_limit = pass.spindle.cutting_speed / (kTurn * pass.spindle.limit) / 2;
        if (told.crossings.empty() && last && last->radius > half_limit &&
            sample.radius <= half_limit) {
            told.half_limit_current = sample.current;
            told.half_limit_radius = sample.radius;
        }
        last = sample;
    });
    return told;
}

TEST(DrivesOracle, FacingPass) {
    const json data = oracle("css_drive.json");
    const json& tolerance = data["tolerance"];
    const double part = tolerance["samples_rel"];
    const double time_part = tolerance["times_rel"];
    int cases = 0;
    for (const json& entry : data["cases"]) {
        SCOPED_TRACE(entry["id"].get<std::string>());
        const machine::Drives drives = drives_of(entry["input"]);
        const FacingPass pass = pass_of(entry["input"]);
        const json& want = entry["expect"];
        const Told got = run(drives, pass, want["samples"]);
        const auto near = [](double value, const json& expected, double share) {
            EXPECT_NEAR(value, expected.get<double>(), share * std::abs(expected.get<double>()));
        };
        ASSERT_EQ(got.samples.size(), want["samples"].size());
        for (std::size_t i = 0; i < got.samples.size(); ++i) {
            const json& sample = want["samples"][i];
            SCOPED_TRACE("at " + std::to_string(sample["t"].get<double>()) + " s");
            near(got.samples[i].radius / 1000, sample["R"], part);
            near(got.samples[i].speed, sample["omega"], part);
            near(got.samples[i].current, sample["I"], part);
            near(got.samples[i].feed / 1000, sample["v_feed"], part);
        }
        ASSERT_GE(got.crossings.size(), 2u);
        const double first = want["t_first_crossing"];
        const double second = want["t_second_crossing"];
        near(got.crossings[0], first, time_part);
        near(got.crossings[1], second, time_part);
        near(got.crossings[1] - got.crossings[0], second - first,
             tolerance["second_minus_first_crossing_rel"]);
        near(got.return_time, want["t_return_to_R0"], time_part);
        EXPECT_NEAR(got.least_radius / 1000, want["R_min"].get<double>(),
                    tolerance["R_min_abs"].get<double>());
        near(got.peak.current, want["I_peak_near_centre"], tolerance["I_peak_rel"]);
        near(got.peak.radius / 1000, want["R_at_peak"], tolerance["R_at_peak_rel"]);
        near(got.least_before_peak, want["I_minimum_before_peak"], part);
        near(got.half_limit_current, want["I_at_half_limit_radius"], part);
        // Of the last step in front of it, or the first behind: a step of either is some µm.
        near(got.half_limit_radius / 1000, want["R_half_limit"], 1e-3);
        const double start_load = drives.cutting_force * pass.radius / 1000;
        near(
            settled(drives.spindle, kTurn * pass.spindle.speed_at(pass.radius), start_load).current,
            want["I_start_static"], 1e-6);
        near(settled(drives.spindle, kTurn * pass.spindle.limit, 0).current,
             want["I_idle_at_limit"], 1e-6);
        ++cases;
    }
    EXPECT_EQ(cases, 3);
}

/// A run of commands on a machine with the drives of an oracle's case.
struct ProgramRun {
    std::vector<DriveSample> samples;
    bool has_stalled = false;
};

ProgramRun drive(const machine::Drives& drives, std::vector<path::Command> commands) {
    machine::Machine machine = motion::test::machine_of();
    machine.drives = drives;
    ProgramRun run;
    DriveRun drive(machine, 0.001, [&](const DriveSample& s) { run.samples.push_back(s); });
    for (const motion::Segment& segment :
         motion::test::run(machine, std::move(commands)).segments) {
        drive.add(segment);
    }
    run.has_stalled = drive.has_stalled();
    return run;
}

/// The pass of the paper as a program: the cut goes beyond the centre, and a rapid comes back. The
/// cut itself has the numbers of the oracle at every radius.
TEST(DriveRun, AProgramThatFacesHasTheCurrentsOfTheOracle) {
    const json cases = oracle("css_drive.json")["cases"];
    for (const json& entry : cases) {
        SCOPED_TRACE(entry["id"].get<std::string>());
        const json& in = entry["input"];
        const FacingPass pass = pass_of(in);
        std::vector<path::Command> commands =
            facing(pass.spindle.cutting_speed * 60 / 1000, pass.spindle.limit * 60, pass.radius,
                   -0.2, pass.feed_per_revolution);
        commands.push_back(motion::test::rapid_to({pass.radius, 0, 0}));
        path::Command settling = motion::test::simple(path::Op::Dwell);  // the axis swings in
        settling.dwell().time = 0.5;
        commands.push_back(settling);
        const ProgramRun run = drive(drives_of(in), commands);
        EXPECT_FALSE(run.has_stalled);

        const auto first_below = [&](double radius) {
            bool cuts = false;
            for (const DriveSample& sample : run.samples) {
                cuts = cuts || sample.load > 0;
                if (cuts && sample.tip[0] <= radius) return sample;
            }
            return DriveSample{};
        };
        for (const json& sample : entry["expect"]["samples"]) {
            const double radius = sample["R"].get<double>() * 1000;
            SCOPED_TRACE("radius " + std::to_string(radius));
            const DriveSample got = first_below(radius);
            EXPECT_NEAR(got.speed, sample["omega"].get<double>(),
                        0.01 * sample["omega"].get<double>());
            EXPECT_NEAR(got.current, sample["I"].get<double>(), 0.01 * sample["I"].get<double>());
            EXPECT_NEAR(got.feed / 1000, sample["v_feed"].get<double>(),
                        0.01 * sample["v_feed"].get<double>());
        }
        double peak = 0;
        int crossings = 0;
        for (std::size_t i = 1; i < run.samples.size(); ++i) {
            const DriveSample& sample = run.samples[i];
            if (sample.load > 0 && sample.tip[0] < 0.4 * pass.radius) {
                peak = std::max(peak, sample.current);
            }
            crossings += (run.samples[i - 1].tip[0] > 0) != (sample.tip[0] > 0) ? 1 : 0;
            if (sample.tip[0] < 0) {
                EXPECT_EQ(sample.load, 0) << "behind the centre is nothing to cut";
            }
        }
        const double want = entry["expect"]["I_peak_near_centre"];
        EXPECT_NEAR(peak, want, 0.03 * want);
        // The start is the axis itself: out of it, through the centre, and back.
        EXPECT_EQ(crossings, 3);
        EXPECT_NEAR(run.samples.back().tip[0], pass.radius, 0.01);
    }
}

TEST(DriveRun, AtConstantSpeedTheCurrentFallsInProportionToTheRadius) {
    const json in = oracle("css_drive.json")["cases"][0]["input"];
    const FacingPass pass = pass_of(in);
    const ProgramRun run =
        drive(drives_of(in), facing(200, 3000, pass.radius, 50, pass.feed_per_revolution));
    double n = 0, r = 0, c = 0, rr = 0, cc = 0, rc = 0;
    for (const DriveSample& sample : run.samples) {
        // 1 kN: the load in N·m is the radius. The start of the cut has died away.
        if (sample.load < 0.99 * sample.tip[0] || sample.tip[0] > 99) continue;
        const double radius = sample.tip[0];
        n += 1, r += radius, c += sample.current;
        rr += radius * radius, cc += sample.current * sample.current, rc += radius * sample.current;
    }
    ASSERT_GT(n, 1000);
    EXPECT_GT((n * rc - r * c) / std::sqrt((n * rr - r * r) * (n * cc - c * c)), 0.99);
}

TEST(DriveRun, TheFirstCutWaitsForTheSpindle) {
    machine::Drives drives = drives_of(oracle("css_drive.json")["cases"][0]["input"]);
    drives.spindle.max_current = 90;
    const ProgramRun run = drive(drives, facing(200, 3000, 100, 99, 0.3));
    bool cuts = false;
    for (const DriveSample& sample : run.samples) {
        EXPECT_LE(std::abs(sample.current), 90.001);
        if (sample.load > 0 && !cuts) {
            EXPECT_NEAR(sample.speed, sample.wanted_speed, 0.06 * sample.wanted_speed);
        }
        cuts = cuts || sample.load > 0;
    }
    EXPECT_TRUE(cuts);
    EXPECT_FALSE(run.has_stalled);
}

TEST(DriveRun, ADriveThatIsTooWeakStalls) {
    machine::Drives drives = drives_of(oracle("css_drive.json")["cases"][0]["input"]);
    drives.spindle.max_current = 2;  // 4 N·m: the idle torque alone
    const ProgramRun run = drive(drives, facing(200, 3000, 100, 90, 0.3));
    EXPECT_TRUE(run.has_stalled);
    for (const DriveSample& sample : run.samples) EXPECT_GE(sample.speed, 0);
}

TEST(DriveRun, ALoadLeavesNoErrorOfTheSpeed) {
    const machine::Drives drives = drives_of(oracle("css_drive.json")["cases"][0]["input"]);
    SpindleState state = settled(drives.spindle, 100, 0);
    double least = state.speed;
    for (int i = 0; i < 20000; ++i) {
        state = advanced(drives.spindle, state, 100, 50, 5e-5);
        least = std::min(least, state.speed);
    }
    EXPECT_LT(least, 99);  // the load was felt
    EXPECT_NEAR(state.speed, 100, 1e-6);
    EXPECT_NEAR(state.current, (50 + 4 + 0.01 * 100) / 2, 1e-6);
}

/// The answer to a step of the reference is that of the modulus optimum: 8 % overshoot.
TEST(DriveRun, AStepOvershootsAsTheModulusOptimumDoes) {
    machine::Drives drives = drives_of(oracle("css_drive.json")["cases"][0]["input"]);
    SpindleState state = settled(drives.spindle, 100, 0);
    double most = 0;
    for (int i = 0; i < 20000; ++i) {
        state = advanced(drives.spindle, state, 101, 0, 1e-5);
        most = std::max(most, state.speed);
    }
    EXPECT_NEAR(most, 101.08, 0.005);
}

}  // namespace
}  // namespace kadr::process::drives_test
