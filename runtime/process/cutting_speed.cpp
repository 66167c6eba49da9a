#include "process/cutting_speed.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace kadr::process {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// The speed that nothing lets the spindle exceed, rev/s; 0: none.
double top_speed(const motion::CommandedSpindle& spindle) {
    if (spindle.limit > 0 && spindle.machine_limit > 0) {
        return std::min(spindle.limit, spindle.machine_limit);
    }
    return std::max(spindle.limit, spindle.machine_limit);
}

/// The speed below which the spindle does not turn, rev/s; 0: none.
double least_speed(const motion::CommandedSpindle& spindle) {
    const double top = top_speed(spindle);
    return top > 0 ? std::min(spindle.least, top) : spindle.least;
}

/// By how much the radius changes in a revolution, mm.
double radial_feed(const FacePass& pass) { return pass.feed_per_revolution * std::cos(pass.cone); }

}  // namespace

double limit_radius(const motion::CommandedSpindle& spindle) {
    const double top = top_speed(spindle);
    return top > 0 ? spindle.cutting_speed / (kTurn * top) : 0;
}

double least_speed_radius(const motion::CommandedSpindle& spindle) {
    const double least = least_speed(spindle);
    return least > 0 ? spindle.cutting_speed / (kTurn * least)
                     : std::numeric_limits<double>::infinity();
}

double cutting_speed(const motion::CommandedSpindle& spindle, double radius) {
    return kTurn * std::abs(radius) * spindle.speed_at(radius);
}

double feed_speed(const motion::CommandedSpindle& spindle, const FacePass& pass, double radius) {
    return pass.feed_per_revolution * spindle.speed_at(radius);
}

double spindle_acceleration(const motion::CommandedSpindle& spindle, const FacePass& pass,
                            double radius) {
    const double distance = std::abs(radius);
    if (distance <= limit_radius(spindle) || distance >= least_speed_radius(spindle)) return 0;
    // ω = V/R and dR/dt = −f·ω/2π.
    const double speed = spindle.cutting_speed / distance;
    return speed / distance * radial_feed(pass) * speed / kTurn;
}

double pass_time(const motion::CommandedSpindle& spindle, const FacePass& pass) {
    if (pass.from * pass.to < 0) {
        FacePass in = pass;
        FacePass out = pass;
        in.to = out.from = 0;
        return pass_time(spindle, in) + pass_time(spindle, out);
    }
    const double near = std::min(std::abs(pass.from), std::abs(pass.to));
    const double far = std::max(std::abs(pass.from), std::abs(pass.to));
    const double edge = std::clamp(limit_radius(spindle), near, far);
    const double outer = std::clamp(least_speed_radius(spindle), edge, far);
    const double feed = radial_feed(pass);
    double time =
        std::numbers::pi * (outer - edge) * (outer + edge) / (feed * spindle.cutting_speed);
    if (edge > near) time += (edge - near) / (feed * top_speed(spindle));
    if (far > outer) time += (far - outer) / (feed * least_speed(spindle));
    return time;
}

double pass_revolutions(const FacePass& pass) {
    return std::abs(pass.from - pass.to) / radial_feed(pass);
}

}  // namespace kadr::process
