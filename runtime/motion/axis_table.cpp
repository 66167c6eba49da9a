#include "motion/axis_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "motion/axis_shares.h"
#include "motion/spline_pieces.h"

namespace kadr::motion {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A helix as limits see it: a circle of constant curvature and a steady rise. Spread radii differ
/// by hundredths; of both ends the less favourable one counts.
struct CircleView {
    double curvature;  // 1/mm
    double third;      // |d³C/ds³|, 1/mm²
    double turning;    // share of the tangent in the plane of the circle
    double rising;     // share along the normal, ≥ 0
    double tilt_cos;   // direction of the tangent in the plane: cos·e_φ + sin·e_r
    double tilt_sin;

    explicit CircleView(const path::Helix& helix) {
        const double first = helix.radius;
        const double last = helix.radius + helix.radius_rate * helix.sweep;
        const double spread = helix.radius_rate;
        const double height = helix.height_rate;
        const double small = std::min(first, last);
        const double in_plane = std::hypot(small, spread);
        const double rate = std::hypot(in_plane, height);
        curvature = std::hypot(small, 2 * spread) / (rate * rate);
        // r·ω³ with ω = dφ/ds; and what the spread adds, which is a thousandth of it.
        third = std::hypot(small, 3 * spread) / (rate * rate * rate);
        rising = std::abs(height) / rate;
        const double wide = std::hypot(std::max(first, last), spread);
        turning = wide / std::hypot(wide, height);
        tilt_cos = in_plane > 0 ? small / in_plane : 1;
        tilt_sin = in_plane > 0 ? spread / in_plane : 0;
    }
};

/// How much of the circle the coordinate sees: 1 if the plane contains it, 0 across.
double amplitude(const path::Helix& helix, std::size_t coordinate) {
    const auto i = static_cast<Eigen::Index>(coordinate);
    return std::hypot(helix.e1[i], helix.e2[i]);
}

/// Greatest |dq/ds| of a coordinate on the arc.
double greatest_rate(const path::Helix& helix, const CircleView& circle, std::size_t coordinate) {
    const auto i = static_cast<Eigen::Index>(coordinate);
    const double rise = std::copysign(circle.rising, helix.height_rate) * helix.normal[i];
    const double on_cos = circle.tilt_sin * helix.e1[i] + circle.tilt_cos * helix.e2[i];
    const double on_sin = circle.tilt_sin * helix.e2[i] - circle.tilt_cos * helix.e1[i];
    const path::Extremes wave =
        path::wave_extremes(rise, circle.turning * on_cos, circle.turning * on_sin, helix.sweep);
    return std::max(std::abs(wave.lower), std::abs(wave.upper));
}

/// The greatest acceleration along the path that an axis has left. It sees |q'|·a + |q''|·v²; and
/// as the two are across each other, never more than sqrt(a² + (k·v²)²).
double acceleration_left(const SplineBend& bend, Eigen::Index axis, double speed, double limit) {
    const double across = bend.curvature * speed * speed;
    const double as_sum = bend.rate[axis] > 0
                              ? (limit - bend.bend[axis] * speed * speed) / bend.rate[axis]
                              : kInfinity;
    const double as_vector = across < limit ? std::sqrt(limit * limit - across * across) : 0;
    return std::max(as_sum, as_vector);
}

}  // namespace

AxisTable::AxisTable(const machine::Machine& machine) {
    if (machine.kinematics) chain_ = &machine.kinematics->chain;
    slots_.fill(machine.axes.size());
    const bool has_pulses = machine.laser && machine.laser->pulse > 0;
    for (const machine::MachineAxis& axis : machine.axes) {
        slots_[index(axis.axis)] = axes_.size();
        // A machine that no file describes may leave the jerk open; and the pulses of a laser are
        // timed with trapezoids.
        const bool is_limited = axis.jerk > 0 && !has_pulses;
        const double jerk = is_limited ? axis.jerk : kInfinity;
        axes_.push_back({index(axis.axis), axis.velocity, axis.acceleration, jerk});
        limits_jerk_ = limits_jerk_ || std::isfinite(jerk);
        if (index(axis.axis) >= 3) continue;
        const auto i = static_cast<Eigen::Index>(index(axis.axis));
        linear_.velocity[i] = axis.velocity;
        linear_.acceleration[i] = axis.acceleration;
    }
}

AxisTable AxisTable::under(const path::Dynamics& dynamics) const {
    AxisTable table = *this;
    for (Entry& axis : table.axes_) {
        axis.velocity *= dynamics.velocity[axis.coordinate];
        if (!dynamics.is_feed_axis(static_cast<Axis>(axis.coordinate)))
            axis.velocity = std::min(axis.velocity, dynamics.speed[axis.coordinate]);
        axis.acceleration *= dynamics.acceleration[axis.coordinate];
        axis.jerk *= dynamics.jerk[axis.coordinate];
        if (axis.coordinate >= 3) continue;
        const auto i = static_cast<Eigen::Index>(axis.coordinate);
        table.linear_.velocity[i] = axis.velocity;
        table.linear_.acceleration[i] = axis.acceleration;
    }
    return table;
}

PathLimits AxisTable::follower_limits(const Segment& piece, double wanted) const {
    PathLimits limits{wanted, kInfinity, kInfinity, kInfinity};
    for (const Entry& axis : axes_) {
        if (axis.coordinate < 3) continue;
        const double rate = std::abs(piece.follower_rate[axis.coordinate - 3]);
        if (rate * limits.speed > axis.velocity) limits.speed = axis.velocity / rate;
        if (rate * limits.acceleration > axis.acceleration)
            limits.acceleration = axis.acceleration / rate;
        if (rate * limits.jerk > axis.jerk) limits.jerk = axis.jerk / rate;
    }
    return limits;
}

AxisRates AxisTable::rates(const path::Vec3& tangent, const Segment& piece) const {
    AxisRates rates;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const std::size_t c = axes_[i].coordinate;
        rates[i] = c < 3 ? tangent[static_cast<Eigen::Index>(c)] : piece.follower_rate[c - 3];
    }
    return rates;
}

AxisRates AxisTable::start_rates(const Segment& piece) const {
    if (piece.is_transformed()) return rates_on(piece, 0);
    if (const auto* line = std::get_if<path::Line>(&piece.curve)) {
        return rates(line->direction, piece);
    }
    return rates(path::evaluate(piece.curve, 0).tangent, piece);
}

AxisRates AxisTable::end_rates(const Segment& piece) const {
    if (piece.is_transformed()) return rates_on(piece, 1);
    if (const auto* line = std::get_if<path::Line>(&piece.curve)) {
        return rates(line->direction, piece);
    }
    return rates(path::evaluate(piece.curve, path::length(piece.curve)).tangent, piece);
}

AxisRates AxisTable::bends(const Segment& piece, double distance) const {
    AxisRates bends{};
    if (std::holds_alternative<path::Line>(piece.curve)) return bends;
    const path::Vec3 curvature = path::evaluate(piece.curve, distance).curvature;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const std::size_t c = axes_[i].coordinate;
        if (c < 3) bends[i] = curvature[static_cast<Eigen::Index>(c)];
    }
    return bends;
}

AxisRates AxisTable::start_bends(const Segment& piece) const {
    return piece.is_transformed() ? bends_on(piece, 0) : bends(piece, 0);
}

AxisRates AxisTable::end_bends(const Segment& piece) const {
    if (piece.is_transformed()) return bends_on(piece, 1);
    return bends(piece, path::length(piece.curve));
}

/// The bend takes its share of the acceleration first, as on an arc.
PathLimits AxisTable::spline_limits(const SplineBend& bend, double wanted) const {
    PathLimits limits{wanted, kInfinity, kInfinity, kInfinity};
    for (const Entry& axis : axes_) {
        if (axis.coordinate >= 3) continue;
        const auto i = static_cast<Eigen::Index>(axis.coordinate);
        const double steady = kSteadyJerk * axis.jerk;
        if (bend.third[i] * limits.speed * limits.speed * limits.speed > steady)
            limits.speed = std::cbrt(steady / bend.third[i]);
        if (bend.rate[i] * limits.speed > axis.velocity)
            limits.speed = axis.velocity / bend.rate[i];
        const double most = kNormalShare * axis.acceleration;
        if (bend.bend[i] * limits.speed * limits.speed > most)
            limits.speed = std::sqrt(most / bend.bend[i]);
    }
    for (const Entry& axis : axes_) {
        if (axis.coordinate >= 3) continue;
        const auto i = static_cast<Eigen::Index>(axis.coordinate);
        limits.acceleration = std::min(limits.acceleration,
                                       acceleration_left(bend, i, limits.speed, axis.acceleration));
        const double turning = 3 * bend.bend[i] * limits.speed;
        const double share = kTurningJerkOfSpline * axis.jerk;
        if (turning * limits.turning_acceleration > share)
            limits.turning_acceleration = share / turning;
    }
    limits.acceleration = std::min(limits.acceleration, limits.turning_acceleration);
    const double cube = limits.speed * limits.speed * limits.speed;
    for (const Entry& axis : axes_) {
        if (axis.coordinate >= 3 || std::isinf(axis.jerk)) continue;
        const auto i = static_cast<Eigen::Index>(axis.coordinate);
        const double left = axis.jerk - bend.third[i] * cube -
                            3 * bend.bend[i] * limits.speed * limits.acceleration;
        if (bend.rate[i] * limits.jerk > left) limits.jerk = left / bend.rate[i];
    }
    return limits;
}

namespace {

struct GlideBend : SplineBend {
    double tool = 0;  // greatest |dC/ds|
};

/// By the control points of the derivatives, of which the second are the ends of the line that it
/// is.
GlideBend bend_of(const path::Glide& glide) {
    GlideBend bend;
    for (std::size_t i = 0; i < 3; ++i) {
        const path::Vec3 rate = 3 * (glide.cubic[i + 1] - glide.cubic[i]) / glide.length;
        bend.rate = bend.rate.cwiseMax(rate.cwiseAbs());
        bend.tool = std::max(bend.tool, rate.norm());
    }
    bend.bend = path::evaluate(glide, 0).curvature.cwiseAbs().cwiseMax(
        path::evaluate(glide, glide.length).curvature.cwiseAbs());
    bend.third = path::third_derivative(glide).cwiseAbs();
    // Along and across are not told apart: the derivatives add up.
    bend.curvature = kInfinity;
    return bend;
}

/// Of a curve without closed forms for its limits; nothing of the others.
std::optional<SplineBend> sampled_bend(const path::Curve& curve) {
    if (const auto* glide = std::get_if<path::Glide>(&curve)) return bend_of(*glide);
    if (path::bends_freely(curve)) return motion::bend_of(curve);
    return std::nullopt;
}

double speed_on(const GlideBend& bend, double wanted) { return wanted / std::max(1.0, bend.tool); }

}  // namespace

double AxisTable::path_speed(const Segment& piece, double wanted) {
    const auto* glide = std::get_if<path::Glide>(&piece.curve);
    return glide != nullptr ? speed_on(bend_of(*glide), wanted) : wanted;
}

PathLimits AxisTable::glide_limits(const path::Glide& glide, double wanted) const {
    const GlideBend bend = bend_of(glide);
    PathLimits limits{speed_on(bend, wanted), kInfinity, kInfinity, kInfinity};
    for (const Entry& axis : axes_) {
        if (axis.coordinate >= 3) continue;
        const auto i = static_cast<Eigen::Index>(axis.coordinate);
        double& speed = limits.speed;
        if (bend.rate[i] * speed > axis.velocity) speed = axis.velocity / bend.rate[i];
        if (bend.bend[i] * speed * speed > kNormalShare * axis.acceleration)
            speed = std::sqrt(kNormalShare * axis.acceleration / bend.bend[i]);
        if (bend.third[i] * speed * speed * speed > kSteadyJerkOfGlide * axis.jerk)
            speed = std::cbrt(kSteadyJerkOfGlide * axis.jerk / bend.third[i]);
    }
    const double v = limits.speed;
    for (const Entry& axis : axes_) {
        if (axis.coordinate >= 3) continue;
        const auto i = static_cast<Eigen::Index>(axis.coordinate);
        const double left = axis.acceleration - bend.bend[i] * v * v;
        if (bend.rate[i] * limits.acceleration > left) limits.acceleration = left / bend.rate[i];
        const double turning = 3 * bend.bend[i] * v;
        if (turning * limits.turning_acceleration > kTurningJerkOfGlide * axis.jerk)
            limits.turning_acceleration = kTurningJerkOfGlide * axis.jerk / turning;
    }
    limits.acceleration = std::min(limits.acceleration, limits.turning_acceleration);
    for (const Entry& axis : axes_) {
        if (axis.coordinate >= 3 || std::isinf(axis.jerk)) continue;
        const auto i = static_cast<Eigen::Index>(axis.coordinate);
        const double left =
            axis.jerk - bend.third[i] * v * v * v - 3 * bend.bend[i] * v * limits.acceleration;
        if (bend.rate[i] * limits.jerk > left) limits.jerk = left / bend.rate[i];
    }
    return limits;
}

PathLimits AxisTable::limits(const Segment& piece, const AxisRates& start, double wanted) const {
    if (piece.is_transformed()) return transformed_limits(piece, wanted);
    if (const auto* helix = std::get_if<path::Helix>(&piece.curve))
        return helix_limits(*helix, piece, wanted);
    if (const auto* glide = std::get_if<path::Glide>(&piece.curve))
        return glide_limits(*glide, wanted);
    if (path::bends_freely(piece.curve)) {
        const PathLimits beside = follower_limits(piece, wanted);
        PathLimits limits = spline_limits(motion::bend_of(piece.curve), beside.speed);
        limits.acceleration = std::min(limits.acceleration, beside.acceleration);
        limits.jerk = std::min(limits.jerk, beside.jerk);
        return limits;
    }
    return line_limits(start, wanted);
}

PathLimits AxisTable::line_limits(const AxisRates& along, double wanted) const {
    double slowness = 0;   // 1/speed
    double weight = 0;     // 1/acceleration
    double stiffness = 0;  // 1/jerk
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const double rate = std::abs(along[i]);
        slowness = std::max(slowness, rate / axes_[i].velocity);
        weight = std::max(weight, rate / axes_[i].acceleration);
        if (limits_jerk_) stiffness = std::max(stiffness, rate / axes_[i].jerk);
    }
    return {slowness * wanted > 1 ? 1 / slowness : wanted, weight > 0 ? 1 / weight : kInfinity,
            stiffness > 0 ? 1 / stiffness : kInfinity, kInfinity};
}

/// The jerk along the path that an axis has left on an arc at these limits.
double AxisTable::jerk_left(const path::Helix& helix, const Segment& piece, const Entry& axis,
                            const PathLimits& limits) {
    if (axis.coordinate >= 3) {
        const double rate = std::abs(piece.follower_rate[axis.coordinate - 3]);
        return rate > 0 ? axis.jerk / rate : kInfinity;
    }
    if (std::isinf(axis.jerk)) return kInfinity;
    // hypot(c·j + K, Y) + h·j ≤ J, solved for j: K what turning at the speed takes, Y what speeding
    // up while turning takes, c and h the shares of the tangent in and across the plane.
    const CircleView circle(helix);
    const double m = amplitude(helix, axis.coordinate);
    const double v = limits.speed;
    const double steady = m * circle.third * v * v * v;
    const double speeding = 3 * m * circle.curvature * v * limits.acceleration;
    const double c = m * circle.turning;
    const double h =
        circle.rising * std::abs(helix.normal[static_cast<Eigen::Index>(axis.coordinate)]);
    const double left = axis.jerk * axis.jerk - steady * steady - speeding * speeding;
    const double linear = c * steady + h * axis.jerk;
    const double root = std::sqrt(std::max(0.0, linear * linear + (c * c - h * h) * left));
    return linear + root > 0 ? left / (linear + root) : kInfinity;
}

PathLimits AxisTable::helix_limits(const path::Helix& helix, const Segment& piece,
                                   double wanted) const {
    const CircleView circle(helix);
    double speed = wanted;
    for (const Entry& axis : axes_) {
        if (axis.coordinate >= 3) {
            const double rate = std::abs(piece.follower_rate[axis.coordinate - 3]);
            if (rate * speed > axis.velocity) speed = axis.velocity / rate;
            continue;
        }
        const double rate = greatest_rate(helix, circle, axis.coordinate);
        if (rate * speed > axis.velocity) speed = axis.velocity / rate;
        const double bend = circle.curvature * amplitude(helix, axis.coordinate);
        if (bend * speed * speed > kNormalShare * axis.acceleration) {
            speed = std::sqrt(kNormalShare * axis.acceleration / bend);
        }
        const double third = circle.third * amplitude(helix, axis.coordinate);
        if (third * speed * speed * speed > kSteadyJerk * axis.jerk) {
            speed = std::cbrt(kSteadyJerk * axis.jerk / third);
        }
    }

    double acceleration = kInfinity;
    double turning_acceleration = kInfinity;
    for (const Entry& axis : axes_) {
        if (axis.coordinate >= 3) {
            const double rate = std::abs(piece.follower_rate[axis.coordinate - 3]);
            if (rate * acceleration > axis.acceleration) acceleration = axis.acceleration / rate;
            continue;
        }
        // m·sqrt((c·a)² + N²) + h·a ≤ A, solved for a: m share of the circle in this coordinate, N
        // the centripetal acceleration, c and h the shares of the tangent in and across the plane.
        const double m = amplitude(helix, axis.coordinate);
        const double n = circle.curvature * speed * speed;
        const double c = circle.turning;
        const double h =
            circle.rising * std::abs(helix.normal[static_cast<Eigen::Index>(axis.coordinate)]);
        const double a = axis.acceleration;
        const double left = a * a - m * m * n * n;
        const double root =
            std::sqrt(std::max(0.0, a * a * h * h + (m * m * c * c - h * h) * left));
        const double denominator = a * h + root;
        if (denominator > 0) acceleration = std::min(acceleration, left / denominator);
        const double turning = 3 * m * circle.curvature * speed;
        if (turning * turning_acceleration > kTurningJerk * axis.jerk)
            turning_acceleration = kTurningJerk * axis.jerk / turning;
    }
    PathLimits limits{speed, std::min(acceleration, turning_acceleration), kInfinity,
                      turning_acceleration};
    for (const Entry& axis : axes_)
        limits.jerk = std::min(limits.jerk, jerk_left(helix, piece, axis, limits));
    return limits;
}

AxisTable::Loads AxisTable::loads(const Segment& piece, const AxisRates& start) const {
    if (piece.is_transformed()) return transformed_loads(piece);
    Loads loads;
    if (const std::optional<SplineBend> found = sampled_bend(piece.curve)) {
        const SplineBend& bend = *found;
        for (std::size_t i = 0; i < axes_.size(); ++i) {
            if (axes_[i].coordinate >= 3) {
                loads.turning[i] = std::abs(start[i]);
                continue;
            }
            const auto c = static_cast<Eigen::Index>(axes_[i].coordinate);
            loads.rising[i] = bend.rate[c];
            loads.bend[i] = bend.bend[c];
            loads.third[i] = bend.third[c];
        }
        loads.curvature = bend.curvature;
        return loads;
    }
    const auto* helix = std::get_if<path::Helix>(&piece.curve);
    if (helix == nullptr) {
        for (std::size_t i = 0; i < axes_.size(); ++i) loads.turning[i] = std::abs(start[i]);
        return loads;
    }
    const CircleView circle(*helix);
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const std::size_t c = axes_[i].coordinate;
        if (c >= 3) {
            loads.turning[i] = std::abs(piece.follower_rate[c - 3]);
            continue;
        }
        const double seen = amplitude(*helix, c);
        loads.turning[i] = seen * circle.turning;
        loads.bend[i] = seen * circle.curvature;
        loads.third[i] = seen * circle.third;
        loads.rising[i] = circle.rising * std::abs(helix->normal[static_cast<Eigen::Index>(c)]);
    }
    return loads;
}

double AxisTable::Loads::jerk_at(std::size_t i, const PathState& state) const {
    const double rate = turning[i] + rising[i];
    if (std::isinf(state.jerk)) return rate > 0 ? state.jerk : 0;
    if (bend[i] == 0) return rate * state.jerk;
    const double v = state.speed;
    const double steady = third[i] * v * v * v;
    const double speeding = 3 * bend[i] * v * state.acceleration;
    if (curvature > 0) return rate * state.jerk + steady + speeding;
    return std::hypot(turning[i] * state.jerk + steady, speeding) + rising[i] * state.jerk;
}

AxisTable::Peaks AxisTable::peaks(const Segment& piece, const Loads& loads) const {
    Peaks peaks;
    const double speed = piece.profile.peak_speed;
    const double along = path_acceleration(piece.profile);
    const double jerk = limits_jerk_ ? path_jerk(piece.profile) : 0;
    const auto* helix = piece.is_transformed() ? nullptr : std::get_if<path::Helix>(&piece.curve);
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const std::size_t c = axes_[i].coordinate;
        const double rate = helix == nullptr || c >= 3
                                ? loads.turning[i] + loads.rising[i]
                                : greatest_rate(*helix, CircleView(*helix), c);
        peaks.velocity[i] = rate * speed;
        peaks.acceleration[i] = loads.at(i, speed, along);
        // The acceleration of a trapezoid begins and ends at once.
        if (limits_jerk_) {
            peaks.jerk[i] = loads.jerk_at(i, {speed, along, jerk});
        } else if (peaks.acceleration[i] > 0) {
            peaks.jerk[i] = kInfinity;
        }
    }
    return peaks;
}

void AxisTable::measure_cell(const Segment& piece, const BentCell& cell, Peaks& peaks) const {
    const Profile& profile = piece.profile;
    const bool rests = profile.entry_speed == 0 && profile.exit_speed == 0;
    const AxisValues loads =
        rests ? greatest_load(cell, profile.acceleration, profile.peak_speed * profile.peak_speed)
              : load_between(cell, profile.entry_speed, profile.exit_speed);
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const std::size_t c = axes_[i].coordinate;
        if (c >= 3 && !piece.is_transformed()) continue;
        const double rate = std::max(std::abs(cell.entry.along[c]), std::abs(cell.exit.along[c])) *
                            axes_[i].acceleration;
        const double most = piece.is_transformed() ? rate : std::min(1.0, rate);
        peaks.velocity[i] = std::min(peaks.velocity[i], most * profile.peak_speed);
        peaks.acceleration[i] = std::min(peaks.acceleration[i], loads[c] * axes_[i].acceleration);
    }
}

AxisRates AxisTable::positions(const Segment& piece, double distance) const {
    if (piece.is_transformed()) return transformed_positions(piece, distance);
    const path::Vec3 point = path::position(piece.curve, distance) + piece.carrier;
    AxisRates positions{};
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const std::size_t c = axes_[i].coordinate;
        positions[i] = c < 3 ? point[static_cast<Eigen::Index>(c)]
                             : piece.follower_start[c - 3] + piece.follower_rate[c - 3] * distance;
    }
    return positions;
}

AxisTable::Travel AxisTable::travel(const Segment& piece, double length) const {
    if (piece.is_transformed()) return transformed_travel(piece);
    const path::Vec3 offset = piece.carrier;
    const path::Box box = path::bounds(piece.curve);
    Travel travel;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const std::size_t c = axes_[i].coordinate;
        if (c < 3) {
            const auto k = static_cast<Eigen::Index>(c);
            travel.lower[i] = box.lower[k] + offset[k];
            travel.upper[i] = box.upper[k] + offset[k];
        } else {
            const double from = piece.follower_start[c - 3];
            const double to = from + piece.follower_rate[c - 3] * length;
            travel.lower[i] = std::min(from, to);
            travel.upper[i] = std::max(from, to);
        }
    }
    return travel;
}

}  // namespace kadr::motion
