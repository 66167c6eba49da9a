// Profiles and look-ahead against numbers that were computed by other methods (tests/oracles).
#include <fstream>
#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "motion/axis_table.h"
#include "motion/corner.h"
#include "motion/profile.h"
#include "tests/motion/support.h"

namespace kadr::motion {
namespace {

using nlohmann::json;
using namespace test;

/// By value: a loop over a part of a temporary would outlive it.
json cases(const std::string& name) {
    std::ifstream file(std::string(KADR_ROOT) + "/tests/oracles/" + name);
    return json::parse(file)["cases"];
}

Vec3 vec3(const json& list) {
    return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

/// A line as a segment, for questions to the axis table.
Segment straight(const Vec3& delta) {
    Segment segment;
    segment.curve = path::make_line(Vec3::Zero(), delta);
    return segment;
}

void expect_trapezoid(const json& expected, const Result<Profile, ProfileFault>& got) {
    ASSERT_EQ(got.has_value(), expected["feasible"].get<bool>());
    if (!got) return;
    EXPECT_NEAR(got->peak_speed, expected["v_peak"].get<double>(),
                1e-7 * expected["v_peak"].get<double>());
    EXPECT_NEAR(got->accelerating, expected["phases"][0].get<double>(), 1e-8);
    EXPECT_NEAR(got->cruising, expected["phases"][1].get<double>(), 1e-8);
    EXPECT_NEAR(got->braking, expected["phases"][2].get<double>(), 1e-8);
    EXPECT_NEAR(got->duration(), expected["T"].get<double>(), 1e-8);
}

void expect_ticks(const json& expected, const Profile& profile) {
    EXPECT_EQ(ticks_of(profile.duration(), 0.001), expected["N"].get<double>());
    const auto fitted = fitted_to_ticks(profile, 0.001);
    ASSERT_EQ(fitted.has_value(), !expected["T"].is_null());
    if (!fitted) return;
    EXPECT_NEAR(fitted->duration(), expected["T"].get<double>(), 1e-8);
    EXPECT_NEAR(fitted->peak_speed, expected["v_peak"].get<double>(),
                1e-7 * expected["v_peak"].get<double>());
}

TEST(ProfileOracle, Trapezoids) {
    int seen = 0;
    for (const json& entry : cases("profiles.json")) {
        if (entry["kind"] != "single") continue;
        SCOPED_TRACE(entry["id"].get<std::string>());
        const json& in = entry["input"];
        const ProfileLimits limits{in["vmax"], in["amax"], in["amax"]};
        const auto profile = trapezoid(in["S"], in["v0"], in["v1"], limits);
        const json& expected = entry["expect"]["trapezoid"];
        expect_trapezoid(expected, profile);
        if (!profile) {
            EXPECT_NEAR(ramp_length(in["v0"], in["v1"], limits),
                        expected["min_distance"].get<double>(), 1e-9);
        } else if (entry["expect"].contains("tick_0.001s")) {
            expect_ticks(entry["expect"]["tick_0.001s"]["trapezoid"], *profile);
        }
        ++seen;
    }
    EXPECT_EQ(seen, 26);
}

TEST(ProfileOracle, LimitsOfALineFromTheAxes) {
    for (const json& entry : cases("profiles.json")) {
        if (entry["kind"] != "axis_line") continue;
        SCOPED_TRACE(entry["id"].get<std::string>());
        const json& in = entry["input"];
        const auto machine = machine_of({vec3(in["axis_v"]), vec3(in["axis_a"])});
        const Vec3 delta = vec3(in["delta"]);
        const AxisTable axes(machine);
        const Segment piece = straight(delta);
        const PathLimits limits = axes.limits(piece, axes.start_rates(piece), in["feed"]);
        const json& expected = entry["expect"];
        EXPECT_NEAR(limits.speed, expected["vmax"].get<double>(), 1e-7);
        EXPECT_NEAR(limits.acceleration, expected["amax"].get<double>(), 1e-7);
        const auto whole = run(machine, {line_to(delta, in["feed"].get<double>() * 60)});
        ASSERT_EQ(whole.segments.size(), 1u);
        EXPECT_NEAR(whole.segments[0].profile.length, expected["S"].get<double>(), 1e-9);
        expect_trapezoid(expected["trapezoid"],
                         Result<Profile, ProfileFault>(whole.segments[0].profile));
    }
}

TEST(ProfileOracle, FeedWords) {
    for (const json& entry : cases("profiles.json")) {
        if (entry["kind"] != "feed_unit") continue;
        SCOPED_TRACE(entry["id"].get<std::string>());
        const json& in = entry["input"];
        Command move = line_to({in.value("length", 10.0), 0, 0}, in["F"]);
        if (in["mode"] == "G93") move.feed_mode = path::FeedMode::InverseTime;
        if (in["mode"] == "G95") move.feed_mode = path::FeedMode::PerRevolution;
        const auto whole = run(machine_of(), {spindle_on(in.value("spindle_rpm", 1000.0)), move});
        ASSERT_EQ(whole.segments.size(), 1u);
        EXPECT_NEAR(whole.segments[0].feed, entry["expect"]["path_speed_mm_s"].get<double>(),
                    1e-12);
    }
}

std::vector<Command> polyline(const json& in) {
    std::vector<Command> commands;
    for (const json& point : in["points"]) {
        commands.push_back(line_to(vec3(point), in["feed"].get<double>() * 60));
    }
    return commands;
}

PlannerOptions corner_options(const json& in) {
    PlannerOptions options;
    if (in["rule"] == "axis_jump") {
        for (std::size_t i = 0; i < 3; ++i) options.velocity_jump[i] = in["axis_velocity_jump"][i];
    } else {
        options.corner_rule = CornerRule::JunctionDeviation;
        options.junction_deviation = in["junction_deviation"];
    }
    return options;
}

/// The machine of a case, standing at the first point of its polyline.
machine::Machine machine_at_start(const json& in) {
    auto machine = machine_of({Vec3::Constant(1e6), vec3(in["axis_a"])});
    const Vec3 start = vec3(in["points"][0]);
    for (int i = 0; i < 3; ++i) machine.axes[static_cast<std::size_t>(i)].home = start[i];
    return machine;
}

TEST(LookAheadOracle, JunctionSpeedsAtEveryDepth) {
    int seen = 0;
    for (const json& entry : cases("lookahead.json")) {
        for (const auto& [depth, expected] : entry["expect"]["by_depth"].items()) {
            SCOPED_TRACE(entry["id"].get<std::string>() + ", depth " + depth);
            PlannerOptions options = corner_options(entry["input"]);
            options.lookahead = depth == "all" ? 100000 : std::stoul(depth);
            const auto whole =
                run(machine_at_start(entry["input"]), polyline(entry["input"]), options);
            const json& speeds = expected["junction_speeds"];
            ASSERT_EQ(whole.segments.size() + 1, speeds.size());
            for (std::size_t i = 0; i < whole.segments.size(); ++i) {
                EXPECT_NEAR(whole.segments[i].profile.entry_speed, speeds[i].get<double>(), 1e-4)
                    << i;
                EXPECT_NEAR(whole.segments[i].profile.exit_speed, speeds[i + 1].get<double>(), 1e-4)
                    << i;
            }
            EXPECT_NEAR(whole.totals.time, expected["total_time"].get<double>(),
                        1e-5 * whole.totals.time);
            ++seen;
        }
    }
    EXPECT_EQ(seen, 40);
}

TEST(LookAheadOracle, CornerLimits) {
    for (const json& entry : cases("lookahead.json")) {
        SCOPED_TRACE(entry["id"].get<std::string>());
        const json& in = entry["input"];
        const auto machine = machine_at_start(in);
        const PlannerOptions options = corner_options(in);
        const AxisTable axes(machine);
        for (std::size_t i = 0; i + 2 < in["points"].size(); ++i) {
            const Segment before = straight(vec3(in["points"][i + 1]) - vec3(in["points"][i]));
            const Segment after = straight(vec3(in["points"][i + 2]) - vec3(in["points"][i + 1]));
            const AxisRates d1 = axes.start_rates(before);
            const AxisRates d2 = axes.start_rates(after);
            const double corner =
                options.corner_rule == CornerRule::AxisJump
                    ? axis_jump_speed({d1.data(), 3}, {d2.data(), 3},
                                      {options.velocity_jump.data(), 3})
                    : junction_deviation_speed(Vec3(d1[0], d1[1], d1[2]), Vec3(d2[0], d2[1], d2[2]),
                                               options.junction_deviation,
                                               std::min(axes.limits(before, d1, 1).acceleration,
                                                        axes.limits(after, d2, 1).acceleration));
            EXPECT_NEAR(std::min(corner, in["feed"].get<double>()),
                        entry["expect"]["corner_limits"][i].get<double>(), 1e-4)
                << i;
        }
    }
}

TEST(TimeOptimalOracle, NoProfileIsFasterThanTheAxesAllow) {
    // A trapezoid with a fixed share for the centripetal acceleration pays for its simplicity: up
    // to a quarter on a circle from rest to rest, less the longer the path.
    struct Row {
        const char* id;
        double worst_ratio;
    };
    for (const Row& row : {Row{"line", 1.0001}, Row{"circle", 1.26}, Row{"helix", 1.23}}) {
        SCOPED_TRACE(row.id);
        for (const json& entry : cases("time_optimal.json")) {
            if (entry["id"] != row.id) continue;
            const json& in = entry["input"];
            auto machine = machine_of({vec3(in["axis_v"]), vec3(in["axis_a"])});
            std::vector<Command> commands;
            if (in.contains("line_delta")) {
                commands.push_back(line_to(vec3(in["line_delta"]), kFast));
            } else {
                const double r = in.value("circle_radius", in.value("helix_radius", 0.0));
                const double turns = in.value("turns", 1.0);
                machine.axes[0].home = r;
                commands.push_back(arc_to({r, 0, in.value("pitch", 0.0) * turns}, {0, 0, 0},
                                          turns * 2 * std::numbers::pi, kFast));
            }
            const double time = run(machine, commands).totals.time;
            const json& expected = entry["expect"];
            EXPECT_GE(time, expected["T"].get<double>() - expected["T_uncertainty"].get<double>());
            EXPECT_LE(time, row.worst_ratio * expected["T"].get<double>());
        }
    }
}

}  // namespace
}  // namespace kadr::motion
