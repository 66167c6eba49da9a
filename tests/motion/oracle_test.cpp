// Profiles and look-ahead against numbers that were computed by other methods (tests/oracles).
#include <fstream>
#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "motion/axis_table.h"
#include "motion/corner.h"
#include "motion/lookahead.h"
#include "motion/profile.h"
#include "motion/smooth_profile.h"
#include "tests/motion/support.h"
#include "tests/motion/tick_limits.h"

namespace kadr::motion::oracle_test {
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
    if (!fitted) {
        EXPECT_EQ(fitted.error(), ProfileFault::EndTooFast);
        if (expected.contains("note")) {
            EXPECT_EQ(expected["note"], "cannot be slowed by the peak speed alone");
        }
        return;
    }
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

void expect_seven(const json& expected, const Result<Profile, ProfileFault>& got) {
    ASSERT_EQ(got.has_value(), expected["feasible"].get<bool>());
    if (!got) {
        EXPECT_EQ(expected["reason"], "distance too short for the speed change");
        EXPECT_EQ(got.error(), ProfileFault::TooShort);
        return;
    }
    EXPECT_NEAR(got->peak_speed, expected["v_peak"].get<double>(),
                1e-7 * expected["v_peak"].get<double>());
    EXPECT_NEAR(got->duration(), expected["T"].get<double>(), 1e-8);
    for (std::size_t i = 0; i < kPhases; ++i) {
        EXPECT_NEAR(got->phases[i], expected["phases"][i].get<double>(), 1e-7) << i;
    }
}

TEST(ProfileOracle, SevenPhases) {
    int seen = 0;
    for (const json& entry : cases("profiles.json")) {
        if (entry["kind"] != "single") continue;
        SCOPED_TRACE(entry["id"].get<std::string>());
        const json& in = entry["input"];
        EXPECT_EQ(in["a0"], 0.0);  // the profiles begin and end without acceleration
        EXPECT_EQ(in["a1"], 0.0);
        const double a = in["amax"], j = in["jmax"];
        const auto profile = seven_phases(in["S"], in["v0"], in["v1"], {in["vmax"], a, a, j});
        const json& expected = entry["expect"]["jerk7"];
        expect_seven(expected, profile);
        if (!profile) {
            EXPECT_NEAR(smooth_ramp_length(in["v0"], in["v1"], {a, j}),
                        expected["min_distance"].get<double>(), 1e-9);
        } else if (entry["expect"].contains("tick_0.001s") &&
                   !entry["expect"]["tick_0.001s"]["jerk7"].is_null()) {
            expect_ticks(entry["expect"]["tick_0.001s"]["jerk7"], *profile);
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
        auto smooth = machine;
        for (std::size_t i = 0; i < 3; ++i) smooth.axes[i].jerk = in["axis_j"][i];
        const auto gently = run(smooth, {line_to(delta, in["feed"].get<double>() * 60)});
        expect_seven(expected["jerk7"],
                     Result<Profile, ProfileFault>(gently.segments.at(0).profile));
    }
}

TEST(ProfileOracle, FeedWords) {
    for (const json& entry : cases("profiles.json")) {
        if (entry["kind"] != "feed_unit") continue;
        SCOPED_TRACE(entry["id"].get<std::string>());
        const json& in = entry["input"];
        Command move = line_to({in.value("length", 10.0), 0, 0}, in["F"]);
        if (in["mode"] == "G93") move.motion().feed_mode = path::FeedMode::InverseTime;
        if (in["mode"] == "G95") move.motion().feed_mode = path::FeedMode::PerRevolution;
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

TEST(LookAheadOracle, StopsAtEveryPoint) {
    for (const json& entry : cases("lookahead.json")) {
        SCOPED_TRACE(entry["id"].get<std::string>());
        const json& in = entry["input"];
        auto commands = polyline(in);
        for (Command& command : commands) command.motion().exact_stop = true;
        const auto whole = run(machine_at_start(in), commands, corner_options(in));
        EXPECT_NEAR(whole.totals.time,
                    entry["expect"]["time_with_stop_at_every_point"].get<double>(),
                    1e-5 * whole.totals.time);
    }
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

// --- chains under a limit of the jerk -----------------------------------------------------------

TEST(SmoothOracle, ReachAndItsMonotoneBound) {
    for (const json& entry : cases("lookahead_jerk.json")) {
        if (entry["id"] != "reach_values") continue;
        for (const json& row : entry["expect"]["rows"]) {
            const RampLimits limits{row["amax"], row["jmax"]};
            EXPECT_NEAR(smooth_reach(row["v"], row["S"], limits), row["reach"].get<double>(), 1e-9);
            EXPECT_NEAR(steady_reach(row["v"], row["S"], limits), row["envelope"].get<double>(),
                        1e-9);
        }
    }
}

/// A chain of the oracle; its corners become limits of the look-ahead, and no acceleration passes
/// them.
std::vector<Stretch> chain_of(const json& in) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    std::vector<Stretch> chain;
    double corner = 0;
    for (const json& length : in["block_lengths"]) {
        const double passing = std::isinf(corner) ? kInfinity : 0.0;
        chain.push_back({length, in["vmax"], in["amax"], corner, in["jmax"], passing});
        if (chain.size() > in["corner_limits"].size()) break;
        const json& limit = in["corner_limits"][chain.size() - 1];
        corner = limit.is_null() ? kInfinity : limit.get<double>();
    }
    return chain;
}

/// Time of stretches with the speeds that the look-ahead gives them.
double time_of(const std::vector<Stretch>& stretches, std::vector<double>* speeds = nullptr) {
    LookAhead lookahead(10000);
    for (const Stretch& stretch : stretches) lookahead.append(stretch);
    lookahead.finish();
    double time = 0;
    for (const Stretch& s : stretches) {
        const JunctionSpeeds ends = lookahead.take();
        const auto profile = seven_phases(s.length, ends.entry, ends.exit,
                                          {s.speed, s.acceleration, s.acceleration, s.jerk});
        EXPECT_TRUE(profile.has_value());
        if (profile) time += profile->duration();
        if (speeds != nullptr) speeds->push_back(ends.exit);
    }
    return time;
}

TEST(SmoothOracle, EveryBlockByItself) {
    for (const json& entry : cases("lookahead_jerk.json")) {
        if (entry["id"] == "reach_values") continue;
        SCOPED_TRACE(entry["id"].get<std::string>());
        const json& expected = entry["expect"];
        std::vector<double> speeds;
        const double time = time_of(chain_of(entry["input"]), &speeds);
        EXPECT_NEAR(time, expected["T_envelope"].get<double>(), 1e-7 * time);
        // The best there is where no acceleration passes a junction, by search.
        EXPECT_GE(time, expected["T_blockwise_best"].get<double>() * (1 - 1e-3));
        for (std::size_t i = 0; i + 1 < speeds.size(); ++i) {
            EXPECT_NEAR(speeds[i], expected["junction_speeds_envelope"][i].get<double>(), 1e-5);
        }
    }
}

TEST(SmoothOracle, StopsAtEveryJunction) {
    for (const json& entry : cases("lookahead_jerk.json")) {
        if (entry["id"] == "reach_values") continue;
        SCOPED_TRACE(entry["id"].get<std::string>());
        double time = 0;
        for (const Stretch& s : chain_of(entry["input"])) {
            const auto profile =
                seven_phases(s.length, 0, 0, {s.speed, s.acceleration, s.acceleration, s.jerk});
            ASSERT_TRUE(profile.has_value());
            time += profile->duration();
        }
        EXPECT_NEAR(time, entry["expect"]["T_stop_at_every_junction"].get<double>(), 1e-7 * time);
    }
}

TEST(SmoothOracle, GatheredBlocksTakeTheTimeOfTheMergedLine) {
    for (const json& entry : cases("lookahead_jerk.json")) {
        if (entry["id"] == "reach_values") continue;
        SCOPED_TRACE(entry["id"].get<std::string>());
        StretchBuilder builder(1000);
        const auto chain = chain_of(entry["input"]);
        for (std::size_t i = 0; i < chain.size(); ++i) {
            builder.add(chain[i], i + 1 < chain.size() ? chain[i + 1].entry_limit : 0);
        }
        builder.finish();
        const json& expected = entry["expect"];
        const std::vector<Stretch> merged = builder.complete();
        ASSERT_EQ(merged.size(), expected["merged_blocks"].size());
        for (std::size_t i = 0; i < merged.size(); ++i)
            EXPECT_NEAR(merged[i].length, expected["merged_blocks"][i].get<double>(), 1e-9) << i;
        std::vector<double> speeds;
        const double ratio = time_of(merged, &speeds) / expected["T_merged"].get<double>();
        // The monotone reach gives away at most 5.5 % of a speed, and no corner is passed faster
        // than in the least time, where each is passed as fast as its neighbours let it.
        for (std::size_t i = 0; i + 1 < speeds.size(); ++i) {
            const double best = expected["corner_speeds_merged"][i];
            EXPECT_LE(speeds[i], best * (1 + 1e-5)) << i;
            EXPECT_GE(speeds[i], best * (1 - 0.056)) << i;
        }
        RecordProperty(entry["id"].get<std::string>(), std::to_string(ratio));
        EXPECT_GE(ratio, 1 - 1e-5);
        // Where corners are near each other, the monotone reach costs what it may: 1.6 %.
        EXPECT_LE(ratio, 1.016);
    }
}

// --- the least time there is --------------------------------------------------------------------

/// One span of a spline as a command, from Hermite's data over a parameter interval h.
Command span_to(const Vec3& from, const Vec3& to, const Vec3& slope, const Vec3& end_slope,
                double h) {
    return spline_to(to, from + slope * h / 3, to - end_slope * h / 3, kFast);
}

/// Slopes of the natural cubic spline through points at parameters.
std::vector<Vec3> natural_slopes(const std::vector<Vec3>& points, const std::vector<double>& at) {
    const std::size_t n = points.size();
    // Thomas' algorithm: 2·m0 + m1 = 3·d0, …, the same at the end.
    std::vector<double> factor(n);
    std::vector<Vec3> slopes(n);
    const auto h = [&](std::size_t i) { return at[i + 1] - at[i]; };
    const auto d = [&](std::size_t i) { return Vec3((points[i + 1] - points[i]) / h(i)); };
    factor[0] = 0.5;
    slopes[0] = 1.5 * d(0);
    for (std::size_t i = 1; i < n; ++i) {
        const bool is_last = i + 1 == n;
        const double lower = is_last ? 1 : h(i);
        const double upper = is_last ? 0 : h(i - 1);
        const double diagonal = is_last ? 2 : 2 * (h(i - 1) + h(i));
        const Vec3 right =
            is_last ? Vec3(3 * d(i - 1)) : Vec3(3 * (h(i) * d(i - 1) + h(i - 1) * d(i)));
        const double pivot = diagonal - lower * factor[i - 1];
        factor[i] = upper / pivot;
        slopes[i] = (right - lower * slopes[i - 1]) / pivot;
    }
    for (std::size_t i = n - 1; i-- > 0;) slopes[i] -= factor[i] * slopes[i + 1];
    return slopes;
}

/// The commands of a path of the oracle, and where it starts; nothing for the ellipse, which no
/// block of NC text is.
std::vector<Command> optimal_path(const json& in, Vec3& start) {
    std::vector<Command> commands;
    if (in.contains("line_delta")) {
        commands.push_back(line_to(vec3(in["line_delta"]), kFast));
    } else if (in.contains("natural_cubic_points")) {
        std::vector<Vec3> points;
        for (const json& point : in["natural_cubic_points"]) points.push_back(vec3(point));
        const auto at = in["params"].get<std::vector<double>>();
        const auto slopes = natural_slopes(points, at);
        start = points[0];
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            commands.push_back(
                span_to(points[i], points[i + 1], slopes[i], slopes[i + 1], at[i + 1] - at[i]));
        }
    } else if (!in.contains("ellipse_semi_axes")) {
        const double r = in.value("circle_radius", in.value("helix_radius", 0.0));
        const double turns = in.value("turns", 1.0);
        start = {r, 0, 0};
        commands.push_back(arc_to({r, 0, in.value("pitch", 0.0) * turns}, {0, 0, 0},
                                  turns * 2 * std::numbers::pi, kFast));
    }
    return commands;
}

machine::Machine machine_at(const Dynamics& dynamics, const Vec3& start) {
    auto machine = machine_of(dynamics);
    for (int i = 0; i < 3; ++i) machine.axes[static_cast<std::size_t>(i)].home = start[i];
    return machine;
}

TickShares shares_of(const machine::Machine& machine, const Motion& motion,
                     const std::vector<Command>& commands) {
    TickWatch watch(machine, motion.segments);
    for (const Setpoint& setpoint : sample(machine, commands)) watch.add(setpoint);
    return watch.shares();
}

/// The place of a path of the oracle at the middle of its parameter.
Vec3 middle_of(const json& in) {
    if (in.contains("line_delta")) return vec3(in["line_delta"]) / 2;
    if (!in.contains("natural_cubic_points")) {
        const double r = in.value("circle_radius", in.value("helix_radius", 0.0));
        const double turn = in.value("turns", 1.0) * std::numbers::pi;
        return {r * std::cos(turn), r * std::sin(turn),
                in.value("pitch", 0.0) * turn / (2 * std::numbers::pi)};
    }
    std::vector<Vec3> points;
    for (const json& point : in["natural_cubic_points"]) points.push_back(vec3(point));
    const auto at = in["params"].get<std::vector<double>>();
    const auto slopes = natural_slopes(points, at);
    const double u = (at.front() + at.back()) / 2;
    std::size_t i = 0;
    while (at[i + 1] < u) ++i;
    const double h = at[i + 1] - at[i];
    const double t = (u - at[i]) / h;
    const Vec3 rise = points[i + 1] - points[i];
    // Hermite's form with the slopes at both ends.
    return points[i] + t * (h * slopes[i] + t * ((3 * rise - h * (2 * slopes[i] + slopes[i + 1])) +
                                                 t * (h * (slopes[i] + slopes[i + 1]) - 2 * rise)));
}

/// The greatest path speed of a run, and that at the setpoint nearest to a place of the path.
struct SpeedsOfRun {
    double greatest = 0;
    double at_place = 0;
    double apart = 1e9;  // mm, of the setpoint from the place
};
SpeedsOfRun speeds_of(const std::vector<Setpoint>& setpoints, const Vec3& point) {
    SpeedsOfRun speeds;
    for (const Setpoint& setpoint : setpoints) {
        speeds.greatest = std::max(speeds.greatest, setpoint.feed);
        const double apart = (setpoint.tip - point).norm();
        if (apart > speeds.apart) continue;
        speeds.apart = apart;
        speeds.at_place = setpoint.feed;
    }
    return speeds;
}

/// The least time has the greatest speed at every place of the path that any plan can have there.
TEST(TimeOptimalOracle, NoPlanIsFasterAnywhere) {
    for (const json& entry : cases("time_optimal.json")) {
        const json& in = entry["input"];
        SCOPED_TRACE(entry["id"].get<std::string>());
        Vec3 start = Vec3::Zero();
        const auto commands = optimal_path(in, start);
        if (commands.empty()) continue;
        const auto machine = machine_at({vec3(in["axis_v"]), vec3(in["axis_a"])}, start);
        const SpeedsOfRun speeds = speeds_of(sample(machine, commands), middle_of(in));
        const json& expected = entry["expect"];
        const double peak = speeds.greatest / expected["peak_path_speed"].get<double>();
        const double middle = speeds.at_place / expected["speed_at_mid_parameter"].get<double>();
        RecordProperty("peak_" + entry["id"].get<std::string>(), std::to_string(peak));
        RecordProperty("middle_" + entry["id"].get<std::string>(), std::to_string(middle));
        EXPECT_LE(peak, 1.01);
        EXPECT_LE(middle, 1.01);
        EXPECT_GE(peak, 0.9);
        EXPECT_GE(middle, 0.9);
    }
}

TEST(TimeOptimalOracle, PlansTakeTheLeastTimeAndThreePerCent) {
    int seen = 0;
    for (const json& entry : cases("time_optimal.json")) {
        const json& in = entry["input"];
        SCOPED_TRACE(entry["id"].get<std::string>());
        Vec3 start = Vec3::Zero();
        const auto commands = optimal_path(in, start);
        if (commands.empty()) continue;
        const auto machine = machine_at({vec3(in["axis_v"]), vec3(in["axis_a"])}, start);
        const Motion motion = run(machine, commands);
        const json& expected = entry["expect"];
        const double least = expected["T"];
        // Cells that hold the limits at both ends are slower, in the first power of their size.
        const double coarse = expected["T_N"]["1000"];
        const double fine = expected["T_N"]["2000"];
        EXPECT_NEAR(2 * fine - coarse, least, 1e-9);
        EXPECT_GE(motion.totals.time, least - expected["T_uncertainty"].get<double>());
        EXPECT_LE(motion.totals.time, 1.03 * least);
        RecordProperty("ratio_" + entry["id"].get<std::string>(),
                       std::to_string(motion.totals.time / least));
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_LE(motion.totals.max_acceleration[i], in["axis_a"][i].get<double>() * 1.001);
            EXPECT_LE(motion.totals.max_velocity[i], in["axis_v"][i].get<double>() * 1.001);
        }
        // From tick to tick, whatever the plan says of itself.
        const TickShares shares = shares_of(machine, motion, commands);
        EXPECT_LE(shares.velocity, 1.001);
        EXPECT_LE(shares.acceleration, 1.001);
        ++seen;
    }
    EXPECT_EQ(seen, 8);
}

/// The least time knows no jerk; what a limit of twenty times the acceleration a second costs, as
/// the stock mill has it, is reported in bench/README.md.
TEST(TimeOptimalOracle, WithAJerkTheyTakeLonger) {
    for (const json& entry : cases("time_optimal.json")) {
        const json& in = entry["input"];
        SCOPED_TRACE(entry["id"].get<std::string>());
        Vec3 start = Vec3::Zero();
        const auto commands = optimal_path(in, start);
        if (commands.empty()) continue;
        const Vec3 acceleration = vec3(in["axis_a"]);
        const auto machine =
            machine_at({vec3(in["axis_v"]), acceleration, 20 * acceleration}, start);
        const Motion motion = run(machine, commands);
        const double ratio = motion.totals.time / entry["expect"]["T"].get<double>();
        RecordProperty("smooth_" + entry["id"].get<std::string>(), std::to_string(ratio));
        EXPECT_GE(ratio, 1);
        EXPECT_LE(ratio, 2.1);
        const TickShares shares = shares_of(machine, motion, commands);
        EXPECT_LE(shares.velocity, 1.001);
        EXPECT_LE(shares.acceleration, 1.001);
        EXPECT_LE(shares.jerk, 1.001);
    }
}

}  // namespace
}  // namespace kadr::motion::oracle_test
