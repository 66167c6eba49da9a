// laser_points.h — point sets for a pulsed laser as the 14 files of the paper's Table 2 may have
// been, and what both ways of burning them take.
//
// The files themselves are not published. A set has the number of points of its file, smooth
// strokes with points 0.10 to 0.15 mm apart, a sharp corner behind so many points and a jump of
// 2 mm behind so many others; these two numbers are those with which a simple model gives both
// times of the paper (reference motion §3.5).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "motion/corner.h"
#include "process/pulse_ahead.h"

namespace kadr::bench {

struct LaserFile {
    int number;
    int points;
    double paper_old;        // s, stop at each point
    double paper_new;        // s, synchronised
    double points_per_jump;  // of 2 mm
    double points_per_stop;  // sharp corners
};

inline constexpr std::array<LaserFile, 14> kTable2 = {{
    {1, 34800, 1811, 1095, 61.2676, 11.2987},
    {2, 12100, 629, 421, 63.0208, 6.4021},
    {3, 23200, 1219, 848, 49.1525, 5.5502},
    {4, 108400, 5528, 2896, 125.4630, 69.4872},
    {5, 65200, 3336, 1874, 107.2368, 19.4048},
    {6, 30900, 1572, 961, 143.0556, 9.5666},
    {7, 38600, 1999, 1442, 69.9275, 4.7304},
    {8, 8600, 472, 298, 25.5952, 10.4878},
    {9, 26700, 1408, 816, 45.7192, 17.6821},
    {10, 52000, 2666, 1693, 98.4848, 7.9511},
    {11, 31200, 1611, 1074, 76.4706, 6.4198},
    {12, 28000, 1429, 868, 120.6897, 10.0719},
    {13, 35200, 1843, 1185, 53.0120, 7.9279},
    {14, 21100, 1097, 611, 62.7976, 25.4217},
}};

/// The laser of the paper: 40 Hz, 1 ms, 300 mm/s², 30 mm/s, 10 %.
struct LaserSetup {
    machine::PulseClock clock = {25, 23, 27};
    double tick = 0.001;
    double acceleration = 300;
    double feed = 30;
};

/// A generator that is the same everywhere: the lowest quality suffices (Numerical Recipes).
class Chance {
  public:
    explicit Chance(std::uint64_t seed) : state_(seed) {}
    double between(double low, double high) {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return low + (high - low) * static_cast<double>(state_ >> 11) * 0x1p-53;
    }

  private:
    std::uint64_t state_;
};

/// The legs from point to point of a set. Corners have the limit of the axis jump, a·tick.
class LaserPath {
  public:
    LaserPath(const LaserFile& file, const LaserSetup& setup)
        : file_(file), setup_(setup), chance_(static_cast<std::uint64_t>(file.number)) {}

    process::PulseLeg next() {
        double turn = bend_ * last_;  // of a smooth stroke, radius 2 mm and more
        if (since_stop_ >= file_.points_per_stop) {
            since_stop_ -= file_.points_per_stop;
            turn = chance_.between(std::numbers::pi / 3, std::numbers::pi);
            bend_ = chance_.between(-0.5, 0.5);
        }
        double length = chance_.between(0.10, 0.15);
        if (since_jump_ >= file_.points_per_jump) {
            since_jump_ -= file_.points_per_jump;
            length = 2;
        }
        ++since_stop_;
        ++since_jump_;
        const path::Vec3 before(std::cos(angle_), std::sin(angle_), 0);
        angle_ += turn;
        const path::Vec3 behind(std::cos(angle_), std::sin(angle_), 0);
        point_ += length * behind;
        process::PulseLeg leg{length, setup_.feed, setup_.acceleration, 0};
        const double jump = setup_.acceleration * setup_.tick;
        const std::array<double, 2> in{before[0], before[1]};
        const std::array<double, 2> out{behind[0], behind[1]};
        const std::array<double, 2> jumps{jump, jump};
        leg.entry_limit = motion::axis_jump_speed(in, out, jumps);
        last_ = length < 1 ? length : 0.125;
        return leg;
    }

    /// Where the leg that was asked for last ends, mm.
    const path::Vec3& point() const { return point_; }

  private:
    const LaserFile& file_;
    LaserSetup setup_;
    Chance chance_;
    path::Vec3 point_ = path::Vec3::Zero();
    double angle_ = 0;
    double bend_ = 0.3;  // 1/mm
    double last_ = 0.125;
    double since_stop_ = 0;
    double since_jump_ = 0;
};

struct LaserTimes {
    double stopping = 0;      // s, rest at every point
    double synchronised = 0;  // s
};

/// Both ways over a whole set; intervals count with their nominal length.
inline LaserTimes times_of(const LaserFile& file, const LaserSetup& setup = {}) {
    LaserPath path(file, setup);
    process::PulseAhead ahead(setup.clock, setup.tick);
    std::int64_t stopping = 0;
    std::int64_t synchronised = 0;
    int appended = 0;
    for (int taken = 0; taken < file.points; ++taken) {
        while (appended < file.points && !ahead.is_full()) {
            const process::PulseLeg leg = path.next();
            const double ticks = motion::ticks_of(process::durations(leg, 0, 0)->least, setup.tick);
            stopping += machine::pulse_at_or_after(setup.clock, static_cast<std::int64_t>(ticks));
            ahead.append(leg);
            if (++appended == file.points) ahead.finish();
        }
        synchronised += ahead.take(0).intervals;
    }
    const double interval = static_cast<double>(setup.clock.nominal) * setup.tick;
    return {static_cast<double>(stopping) * interval, static_cast<double>(synchronised) * interval};
}

}  // namespace kadr::bench
