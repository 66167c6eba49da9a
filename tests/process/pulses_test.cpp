// Pulses of the laser: windows, durations and the look-ahead against the oracle, and its promises
// on random paths.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "bench/laser_points.h"
#include "process/pulse_ahead.h"
#include "tests/process/support.h"

namespace kadr::process::pulses_test {
namespace {

using namespace test;
using path::Vec3;

/// The clock at a tick of 1 ms.
std::optional<PulseClock> clock_of(double frequency, double tolerance) {
    machine::Laser laser;
    laser.pulse = frequency;
    laser.tolerance = tolerance;
    return machine::pulse_clock(laser, 0.001);
}

PulseClock clock_of(const json& in) {
    EXPECT_EQ(in["tick_s"].get<double>(), 0.001);
    return *clock_of(in["pulse_hz"].get<double>(), in["tolerance"].get<double>());
}

TEST(PulseOracle, ArithmeticOfTheExample) {
    const json entry = oracle("laser_sync.json")["cases"][0];
    const json& in = entry["input"];
    const PulseClock clock = clock_of(in);
    EXPECT_EQ(clock.nominal, in["n_nom"].get<std::int64_t>());
    EXPECT_EQ(clock.least, in["n_min"].get<std::int64_t>());
    EXPECT_EQ(clock.most, in["n_max"].get<std::int64_t>());
    const double a = in["acc_mm_s2"];
    const double feed = in["feed_mm_s"];
    const json& want = entry["expect"];
    EXPECT_NEAR(motion::ramp_length(0, feed, {feed, a, a}), want["acc_distance_to_feed_mm"], 1e-9);
    for (const json& row : want["per_distance"]) {
        const double d = row["d"];
        const auto time = durations({d, feed, a, 0}, 0, 0);
        ASSERT_TRUE(time);
        EXPECT_NEAR(time->least * 1000, row["full_time_ms"].get<double>(), 1e-9 * 50);
        const motion::Profile fastest = profile_lasting({d, feed, a, 0}, 0, 0, time->least);
        EXPECT_NEAR(fastest.peak_speed, row["peak_speed_mm_s"].get<double>(), 1e-6);
        EXPECT_NEAR(fastest.accelerating * 1000, row["half_time_ms"].get<double>(), 1e-5);
        const auto ticks = static_cast<std::int64_t>(std::ceil(time->least / 0.001 - 1e-9));
        EXPECT_EQ(machine::pulse_at_or_after(clock, ticks),
                  row["periods_stop_model"].get<std::int64_t>());
        const auto intervals = static_cast<double>(machine::pulse_at_or_after(clock, ticks));
        EXPECT_NEAR(1000 * (intervals * 0.001 * static_cast<double>(clock.nominal) - time->least),
                    row["idle_wait_ms_to_nominal"].get<double>(), 1e-7);
        EXPECT_NEAR(d / feed * 1000, row["constant_feed_time_ms"].get<double>(), 1e-9);
    }
    // From rest to rest in one window, in two; from rest with a free end.
    const double one = want["largest_distance_one_period_from_rest_to_rest_mm"];
    const double two = want["largest_distance_two_periods_mm"];
    const double reached = want["distance_reached_from_rest_in_one_window_mm"];
    const double longest = 0.001 * static_cast<double>(clock.most);
    EXPECT_NEAR(durations({one, feed, a, 0}, 0, 0)->least, longest, 1e-9);
    EXPECT_NEAR(durations({two, feed, a, 0}, 0, 0)->least,
                0.001 * static_cast<double>(machine::pulse_window(clock, 2).last), 1e-9);
    EXPECT_NEAR(durations({reached, feed, a, 0}, 0, a * longest)->least, longest, 1e-9);
}

TEST(PulseOracle, WindowsOfBlocks) {
    const json entry = oracle("laser_sync.json")["cases"][1];
    const json& in = entry["input"];
    const PulseClock clock = clock_of(in);
    for (const auto& [k, window] : entry["expect"]["windows_ticks"].items()) {
        EXPECT_EQ(machine::pulse_window(clock, std::stoll(k)).first, window[0].get<std::int64_t>());
        EXPECT_EQ(machine::pulse_window(clock, std::stoll(k)).last, window[1].get<std::int64_t>());
    }
    int seen = 0;
    for (const json& block : entry["expect"]["blocks"]) {
        SCOPED_TRACE(block.dump());
        const PulseLeg leg{block["d"], in["feed_mm_s"], in["acc_mm_s2"], 0};
        const double entry_speed = block["v_start"];
        const double exit_speed = block["v_end"];
        const auto time = durations(leg, entry_speed, exit_speed);
        ASSERT_EQ(time.has_value(), block["feasible"].get<bool>());
        ++seen;
        if (!time) continue;
        EXPECT_NEAR(time->least, block["t_min_s"].get<double>(), 1e-9);
        if (block["t_max_s"].is_null()) {
            EXPECT_TRUE(std::isinf(time->most));
        } else {
            EXPECT_NEAR(time->most, block["t_max_s"].get<double>(), 1e-9);
        }
        // The least window with a whole number of ticks that the block can last.
        std::int64_t k = 0;
        std::int64_t ticks = 0;
        while (k < 100) {
            const PulseWindow window = machine::pulse_window(clock, ++k);
            ticks = std::max<std::int64_t>(
                window.first, static_cast<std::int64_t>(std::ceil(time->least / 0.001 - 1e-9)));
            if (ticks <= window.last && static_cast<double>(ticks) * 0.001 <= time->most) break;
        }
        if (block["least_k"].is_null()) {
            EXPECT_EQ(k, 100);
            continue;
        }
        EXPECT_EQ(k, block["least_k"].get<std::int64_t>());
        EXPECT_EQ(ticks, block["least_ticks_in_window"].get<std::int64_t>());
        const double duration = 0.001 * static_cast<double>(ticks);
        const motion::Profile profile = profile_lasting(leg, entry_speed, exit_speed, duration);
        EXPECT_NEAR(profile.duration(), duration, 1e-9);
    }
    EXPECT_GE(seen, 10);
}

/// Points to legs, with the corner rule of the oracle: no axis jumps by more than a·tick.
std::vector<PulseLeg> legs_of(const std::vector<Vec3>& points, double speed, double acceleration,
                              double tick) {
    std::vector<PulseLeg> legs;
    Vec3 before = Vec3::Zero();
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec3 delta = points[i] - points[i - 1];
        const Vec3 direction = delta.normalized();
        const double turn = (direction - before).cwiseAbs().maxCoeff();
        PulseLeg leg{delta.norm(), speed, acceleration, 0};
        if (i > 1) leg.entry_limit = turn > 0 ? acceleration * tick / turn : 1e9;
        legs.push_back(leg);
        before = direction;
    }
    return legs;
}

/// Plans a path and holds every block against what it promises.
std::int64_t intervals_of(const PulseClock& clock, const std::vector<PulseLeg>& legs, double tick,
                          std::size_t depth = 32) {
    PulseAhead ahead(clock, tick, depth);
    std::size_t next = 0;
    std::size_t taken = 0;
    std::int64_t intervals = 0;
    double speed = 0;
    while (taken < legs.size()) {
        while (next < legs.size() && !ahead.is_full()) ahead.append(legs[next++]);
        if (next == legs.size()) ahead.finish();
        const PulseBlock block = ahead.take(0);
        const PulseLeg& leg = legs[taken];
        const motion::Profile& profile = block.profile;
        EXPECT_EQ(profile.entry_speed, speed);
        if (taken > 0) {
            EXPECT_LE(speed, leg.entry_limit * (1 + 1e-9));
        }
        EXPECT_LE(profile.peak_speed, leg.speed * (1 + 1e-9));
        const PulseWindow window = machine::pulse_window(clock, block.intervals);
        EXPECT_GE(block.ticks, window.first);
        EXPECT_LE(block.ticks, window.last);
        EXPECT_NEAR(profile.duration(), static_cast<double>(block.ticks) * tick, 1e-9);
        // The three phases have the length of the leg.
        const double distance =
            (profile.entry_speed + profile.peak_speed) / 2 * profile.accelerating +
            profile.peak_speed * profile.cruising +
            (profile.peak_speed + profile.exit_speed) / 2 * profile.braking;
        EXPECT_NEAR(distance, leg.length, 1e-6 * std::max(1.0, leg.length));
        EXPECT_LE(std::abs(profile.acceleration), leg.acceleration);
        EXPECT_LE(std::abs(profile.deceleration), leg.acceleration);
        speed = profile.exit_speed;
        intervals += block.intervals;
        ++taken;
    }
    EXPECT_EQ(speed, 0);
    return intervals;
}

TEST(PulseOracle, RunsTakeTheFewestIntervals) {
    const json data = oracle("laser_sync.json");
    int seen = 0;
    for (const json& entry : data["cases"]) {
        if (entry["kind"] != "synchronised_run") continue;
        SCOPED_TRACE(entry["id"].get<std::string>());
        const json& in = entry["input"];
        const PulseClock clock = clock_of(in);
        std::vector<Vec3> points;
        for (const json& p : in["points"]) {
            points.emplace_back(p[0].get<double>(), p[1].get<double>(), p[2].get<double>());
        }
        const double tick = in["tick_s"];
        const auto legs = legs_of(points, in["feed_mm_s"], in["acc_mm_s2"], tick);
        const json& limits = entry["expect"]["corner_limits_mm_s"];
        for (std::size_t i = 0; i < limits.size(); ++i) {
            if (limits[i] == 999.0) {
                EXPECT_GT(legs[i + 1].entry_limit, 900);
            } else {
                EXPECT_NEAR(legs[i + 1].entry_limit, limits[i].get<double>(),
                            1e-6 * limits[i].get<double>());
            }
        }
        std::int64_t stopping = 0;
        for (const PulseLeg& leg : legs) {
            const double time = durations(leg, 0, 0)->least;
            stopping += machine::pulse_at_or_after(
                clock, static_cast<std::int64_t>(std::ceil(time / tick - 1e-9)));
        }
        EXPECT_EQ(stopping, entry["expect"]["periods_stop_at_each_point"].get<std::int64_t>());
        const double interval = static_cast<double>(clock.nominal) * tick;
        EXPECT_NEAR(static_cast<double>(stopping) * interval,
                    entry["expect"]["time_stop_s"].get<double>(), 1e-9);
        const auto best = entry["expect"]["periods_best_found"].get<double>();
        const auto got = static_cast<double>(intervals_of(clock, legs, tick));
        RecordProperty("periods_" + entry["id"].get<std::string>(), std::to_string(got));
        EXPECT_NEAR(best * interval, entry["expect"]["time_best_nominal_s"].get<double>(), 1e-9);
        EXPECT_LE(got, 1.03 * best + 1);
        EXPECT_GE(got, 0.97 * best - 1);
        EXPECT_LE(got, static_cast<double>(stopping));
        ++seen;
    }
    EXPECT_EQ(seen, 11);
}

/// The baseline of the oracle's small point sets: so many jumps, everything else 0.125 mm.
TEST(PulseOracle, StopModelOfPointSets) {
    const json cases = oracle("laser_sync.json")["cases"];
    for (const json& entry : cases) {
        if (entry["kind"] != "synthetic_baseline") continue;
        const PulseClock clock = clock_of(entry["input"]);
        const auto intervals = [&](double d) {
            const double time = durations({d, 30, 300, 0}, 0, 0)->least;
            return machine::pulse_at_or_after(
                clock, static_cast<std::int64_t>(motion::ticks_of(time, 0.001)));
        };
        for (const json& file : entry["expect"]["files"]) {
            const auto jumps = file["jumps"].get<std::int64_t>();
            const std::int64_t all =
                (file["points"].get<std::int64_t>() - jumps) * intervals(file["spacing"]) +
                jumps * intervals(file["jump_length"]);
            EXPECT_NEAR(static_cast<double>(all) * 0.025,
                        file["time_stop_at_each_point_s"].get<double>(), 1e-9)
                << file.dump();
            // The same numbers of jumps and of stops, as our sets have them: some of what stopping
            // costs is saved, and no point goes without a pulse of its own.
            const auto points = file["points"].get<int>();
            const auto per = [points](const json& count) { return points / count.get<double>(); };
            const bench::LaserTimes times =
                bench::times_of({1, points, 0, 0, per(file["jumps"]), per(file["stops"])});
            EXPECT_GT(times.synchronised, 0.025 * points);
            EXPECT_LT(times.synchronised, 0.7 * times.stopping);
        }
    }
}

/// The smallest of the 14 files of the paper, made up; `bench_laser` has them all.
TEST(PulseOracle, AFileOfTable2) {
    const bench::LaserFile& file = bench::kTable2[7];
    const bench::LaserTimes times = bench::times_of(file);
    EXPECT_NEAR(times.stopping, file.paper_old, 0.01 * file.paper_old);
    EXPECT_GT(times.synchronised, file.points * 0.025);
    EXPECT_NEAR(times.synchronised, file.paper_new, 0.1 * file.paper_new);
    const double saved = 1 - times.synchronised / times.stopping;
    EXPECT_GT(saved, 0.30);
    EXPECT_LT(saved, 0.50);
    const json cases = oracle("laser_sync.json")["cases"];
    for (const json& entry : cases) {
        if (entry["kind"] != "table2_model") continue;
        const json& rows = entry["expect"]["rows"];
        ASSERT_EQ(rows.size(), bench::kTable2.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const bench::LaserFile& mine = bench::kTable2[i];
            EXPECT_EQ(mine.points, rows[i]["points"].get<int>());
            EXPECT_EQ(mine.paper_old, rows[i]["paper_old_s"].get<double>());
            EXPECT_EQ(mine.paper_new, rows[i]["paper_new_s"].get<double>());
            EXPECT_NEAR(mine.points_per_jump,
                        rows[i]["calibrated_points_per_jump_of_2mm"].get<double>(), 1e-3);
            EXPECT_NEAR(mine.points_per_stop, rows[i]["calibrated_points_per_stop"].get<double>(),
                        1e-3);
        }
    }
}

/// What the oracle works out of the paper's table, from the numbers that the bench has of it: every
/// point costs 2 + e intervals with stops and 1 + e + c without, the same e and c in all files.
TEST(PulseOracle, TwoConstantsForTable2) {
    constexpr double kInterval = 0.025;
    double points = 0, paper_old = 0, paper_new = 0;
    for (const bench::LaserFile& file : bench::kTable2) {
        points += file.points;
        paper_old += file.paper_old;
        paper_new += file.paper_new;
    }
    const double e = paper_old / (points * kInterval) - 2;
    const double c = paper_new / (points * kInterval) - 1 - e;
    const json cases = oracle("laser_sync.json")["cases"];
    for (const json& entry : cases) {
        if (entry["kind"] != "table2_model") continue;
        const json& expected = entry["expect"];
        EXPECT_NEAR(e, expected["e_extra_periods_per_point_jumps"].get<double>(), 1e-9);
        EXPECT_NEAR(c, expected["c_extra_periods_per_point_corners"].get<double>(), 1e-9);
        for (std::size_t i = 0; i < bench::kTable2.size(); ++i) {
            const bench::LaserFile& file = bench::kTable2[i];
            const json& row = expected["rows"][i];
            SCOPED_TRACE(row.dump());
            const auto near = [&row](const char* column, double got) {
                EXPECT_NEAR(got, row[column].get<double>(), 1e-9 * std::abs(got)) << column;
            };
            const double all = file.points * kInterval;  // s, a pulse at every point
            near("bound_old_2_periods_s", 2 * all);
            near("bound_new_1_period_s", all);
            near("periods_per_point_old", file.paper_old / all);
            near("periods_per_point_new", file.paper_new / all);
            near("model_old_s", (2 + e) * all);
            near("model_new_s", (1 + e + c) * all);
            near("ratio_old", (2 + e) * all / file.paper_old);
            near("ratio_new", (1 + e + c) * all / file.paper_new);
            near("saving_paper", 1 - file.paper_new / file.paper_old);
            // The table as printed has minutes and seconds.
            const json& printed = entry["input"]["files"][i];
            const auto seconds = [](const std::string& text) {
                const std::size_t colon = text.find(':');
                return 60 * std::stod(text.substr(0, colon)) + std::stod(text.substr(colon + 1));
            };
            EXPECT_EQ(seconds(printed["old"]), file.paper_old);
            EXPECT_EQ(seconds(printed["new"]), file.paper_new);
        }
    }
}

/// Random paths with long and short legs, sharp and flat corners, at every depth: every block ends
/// on a pulse, within its limits.
TEST(PulseAhead, EveryBlockOfEveryPathEndsOnAPulse) {
    std::mt19937 random(7);
    const auto uniform = [&random](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    for (int path = 0; path < 300; ++path) {
        SCOPED_TRACE("path " + std::to_string(path));
        const double tolerance = path % 3 == 0 ? 0.0 : uniform(0, 0.15);
        const double frequency = path % 2 == 0 ? 40 : 20;
        const PulseClock clock = *clock_of(frequency, tolerance);
        std::vector<PulseLeg> legs;
        const int count = 1 + static_cast<int>(uniform(0, 120));
        const double speed = uniform(5, 60);
        for (int i = 0; i < count; ++i) {
            PulseLeg leg;
            leg.length = uniform(0, 1) < 0.1 ? uniform(0.5, 20) : uniform(0.005, 0.3);
            leg.speed = uniform(0, 1) < 0.1 ? uniform(1, speed) : speed;
            leg.acceleration = uniform(0, 1) < 0.2 ? uniform(100, 600) : 300;
            leg.entry_limit = uniform(0, 1) < 0.3 ? uniform(0, 8) : 1e9;
            if (uniform(0, 1) < 0.05) leg.entry_limit = 0;
            legs.push_back(leg);
        }
        intervals_of(clock, legs, 0.001, path % 5 == 0 ? 1 : 1 + random() % 60);
        if (HasFailure()) return;
    }
}

TEST(PulseAhead, APathThatHasAlreadyWaitedStartsWithTheRestOfItsInterval) {
    const PulseClock clock = *clock_of(40, 0.1);
    PulseAhead ahead(clock, 0.001);
    ahead.append({0.03, 30, 300, 0});  // 20 ms from rest to rest
    ahead.finish();
    EXPECT_EQ(ahead.take(0).ticks, 25);
    // 10 ms have gone since the last pulse: it comes after 13 to 17, too early; then after 38
    // to 42, the sooner the better.
    ahead.append({0.03, 30, 300, 0});
    ahead.finish();
    EXPECT_EQ(ahead.take(10).ticks, 38);
    ahead.append({0.03, 30, 300, 0});
    ahead.finish();
    EXPECT_EQ(ahead.take(3).ticks, 22);
}

TEST(PulseClock, NeedsAWholeNumberOfTicks) {
    EXPECT_FALSE(clock_of(30, 0));  // 33.3 ticks
    ASSERT_TRUE(clock_of(30, 0.1));
    EXPECT_EQ(clock_of(30, 0.1)->least, 30);
    EXPECT_EQ(clock_of(30, 0.1)->most, 36);
    EXPECT_EQ(clock_of(40, 0)->least, 25);
    EXPECT_EQ(clock_of(40, 0)->most, 25);
    EXPECT_FALSE(clock_of(5000, 0.1));
}

}  // namespace
}  // namespace kadr::process::pulses_test
