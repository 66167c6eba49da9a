#include "machine/kinematics.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "base/assert.h"

namespace kadr::machine {

namespace {

constexpr double kPi = std::numbers::pi;

/// Both configurations meet where the sine of half their distance is below this. The distance grows
/// with the root of an error of the direction, so that a smaller one has no meaning; a direction
/// nearer to the axis R1 than the second number is a matter of the pole.
constexpr double kMeeting = 1e-7;
constexpr double kAwayFromPole = 1e-6;
/// At the pole the angle of R2 keeps its digits, and R2 would jump where it lost them: a smaller
/// one is the rounding of a direction.
constexpr double kNoOpening = 1e-11;

/// Below this the matrix from R1, R2 to the direction of the tool has no inverse.
constexpr double kSingular = 1e-9;

/// Share of a rate that may be left over where only one axis can follow it.
constexpr double kLeftOver = 1e-7;

struct SineCosine {
    double sine = 0;
    double cosine = 1;
};

SineCosine sine_cosine_of(double angle) { return {std::sin(angle), std::cos(angle)}; }

/// Rodrigues' formula for a vector: a third of the work of the matrix.
Vec3 turned(const Vec3& axis, const SineCosine& rotation, const Vec3& vector) {
    return rotation.cosine * vector + rotation.sine * axis.cross(vector) +
           axis * (axis.dot(vector) * (1 - rotation.cosine));
}

Mat3 matrix_of(const Vec3& axis, const SineCosine& rotation) {
    const Vec3 rest = axis * (1 - rotation.cosine);
    const Vec3 s = axis * rotation.sine;
    Mat3 result = rest * axis.transpose();
    result(0, 0) += rotation.cosine;
    result(1, 1) += rotation.cosine;
    result(2, 2) += rotation.cosine;
    result(0, 1) -= s.z();
    result(1, 0) += s.z();
    result(0, 2) += s.y();
    result(2, 0) -= s.y();
    result(1, 2) -= s.x();
    result(2, 1) += s.x();
    return result;
}

/// Into (−π, π].
double wrapped(double angle) {
    if (angle > -kPi && angle <= kPi) return angle;  // nearly always, and the remainder is slow
    const double reduced = std::remainder(angle, 2 * kPi);
    return reduced <= -kPi ? kPi : reduced;
}

bool is_table(const Chain& chain, std::size_t joint) {
    return chain.has(joint) && chain.joints[joint].side == ChainSide::Table;
}
bool is_head(const Chain& chain, std::size_t joint) {
    return chain.has(joint) && chain.joints[joint].side == ChainSide::Head;
}

/// The rotations of all joints, absent ones at rest.
std::array<SineCosine, kJoints> turns_of(const Chain& chain, const Vec3& rotary) {
    std::array<SineCosine, kJoints> turns;
    for (std::size_t k = 0; k < kJoints; ++k) {
        const RotaryJoint& joint = chain.joints[k];
        if (joint.is_present)
            turns[k] = sine_cosine_of(joint.sign * rotary[static_cast<Eigen::Index>(k)]);
    }
    return turns;
}

Vec3 about_joint(const RotaryJoint& joint, const SineCosine& rotation, const Vec3& point) {
    return joint.point + turned(joint.direction, rotation, point - joint.point);
}
Vec3 back_about_joint(const RotaryJoint& joint, const SineCosine& rotation, const Vec3& point) {
    return about_joint(joint, {-rotation.sine, rotation.cosine}, point);
}

/// The tip as the heads carry it, from the end of the zero tool at base.
Vec3 through_heads(const Chain& chain, const std::array<SineCosine, kJoints>& turns,
                   const Vec3& tip) {
    Vec3 point = tip;
    for (const std::size_t k : {kPsi, kR2, kR1}) {
        if (is_head(chain, k)) point = about_joint(chain.joints[k], turns[k], point);
    }
    return point;
}

Vec3 stand_of(const Chain& chain, const ChainPosition& position) {
    return chain.compensates_parallel ? Vec3(position.linear + position.parallel) : position.linear;
}

Mat3 rotation_by(const Chain& chain, const std::array<SineCosine, kJoints>& turns) {
    Mat3 rotation = Mat3::Identity();
    bool is_first = true;
    for (std::size_t k = 0; k < kJoints; ++k) {
        if (!chain.has(k)) continue;
        const Mat3 joint = matrix_of(chain.joints[k].direction, turns[k]);
        rotation = is_first ? joint : Mat3(rotation * joint);
        is_first = false;
    }
    return rotation;
}

/// The axes of the joints as they lie in the workpiece system, and how the linear axes lie in it.
struct AxesInWorkpiece {
    std::array<Vec3, kJoints> direction;  // with the joint's sign
    std::array<Vec3, kJoints> point;
    Mat3 tables;  // from the linear axes into the workpiece system
    Vec3 tip;     // mm
};

AxesInWorkpiece axes_in_workpiece(const Chain& chain, const ChainPosition& position,
                                  const Vec3& tip) {
    const std::array<SineCosine, kJoints> turns = turns_of(chain, position.rotary);
    AxesInWorkpiece axes;
    // The map from behind the joints passed so far into the workpiece system.
    Mat3 linear = Mat3::Identity();
    Vec3 shift = Vec3::Zero();
    bool is_behind_linear_axes = false;
    const auto pass_linear_axes = [&] {
        axes.tables = linear;
        shift += linear * stand_of(chain, position);
        is_behind_linear_axes = true;
    };
    for (std::size_t k = 0; k < kJoints; ++k) {
        axes.direction[k] = axes.point[k] = Vec3::Zero();
        if (!chain.has(k)) continue;
        const RotaryJoint& joint = chain.joints[k];
        if (joint.side == ChainSide::Head && !is_behind_linear_axes) pass_linear_axes();
        axes.direction[k] = joint.sign * (linear * joint.direction);
        axes.point[k] = linear * joint.point + shift;
        const Mat3 inner = linear * matrix_of(joint.direction, turns[k]);
        shift = axes.point[k] - inner * joint.point;
        linear = inner;
    }
    if (!is_behind_linear_axes) pass_linear_axes();
    axes.tip = linear * tip + shift;
    return axes;
}

/// What the rotary axes alone do to the tip.
Vec3 swing(const Chain& chain, const AxesInWorkpiece& axes, const Vec3& rotary) {
    Vec3 velocity = Vec3::Zero();
    for (std::size_t k = 0; k < kJoints; ++k) {
        if (!chain.has(k)) continue;
        velocity += rotary[static_cast<Eigen::Index>(k)] *
                    axes.direction[k].cross(axes.tip - axes.point[k]);
    }
    return velocity;
}

/// Velocities of R1 and R2 that turn the direction `w` of the tool at the rate `w'`; nothing if
/// they cannot.
Result<Vec3, VelocityFault> tilt_velocity(const Chain& chain, const AxesInWorkpiece& axes,
                                          const Vec3& w, const Vec3& rate) {
    const Vec3 by_first = axes.direction[kR1].cross(w);
    const Vec3 by_second = axes.direction[kR2].cross(w);
    Vec3 rotary = Vec3::Zero();
    // w' = R1' n1 × w + R2' n2 × w; the products with n1 and n2 leave one unknown each.
    const double determinant = axes.direction[kR1].dot(by_second);
    if (chain.orients() && std::abs(determinant) > kSingular) {
        rotary[kR2] = axes.direction[kR1].dot(rate) / determinant;
        rotary[kR1] = -axes.direction[kR2].dot(rate) / determinant;
        return rotary;
    }
    // One axis is left: R2 where R1 is at its pole, else the one that the machine has.
    const bool uses_second = chain.has(kR2) && by_second.norm() >= by_first.norm();
    const Vec3& by = uses_second ? by_second : by_first;
    const double squared = by.squaredNorm();
    const double value = squared > 0 ? rate.dot(by) / squared : 0;
    const double left = (rate - value * by).norm();
    if (left > kLeftOver * rate.norm())
        return chain.orients() ? VelocityFault::Singular : VelocityFault::MissingJoint;
    rotary[uses_second ? kR2 : kR1] = value;
    return rotary;
}

/// The angle of the second joint from the middle of both solutions, 0 … π.
struct Opening {
    double angle = 0;
    SineCosine rotation;
};

/// Half angles of the triangle whose sides are known: sin²(γ/2) and cos²(γ/2) are products, which
/// keep their digits at the poles, where cos γ has none.
Opening opening_of(const OrientationTriangle& tilt, double sine, double cosine) {
    // Half of θ, the side from n1 to the direction, from its sine (≥ 0) and cosine.
    double sin_half = 0;
    double cos_half = 1;
    if (cosine >= 0) {
        cos_half = std::sqrt((1 + cosine) / 2);
        sin_half = sine / (2 * cos_half);
    } else {
        sin_half = std::sqrt((1 - cosine) / 2);
        cos_half = sine / (2 * sin_half);
    }
    const auto square = [](double x) { return x * x; };
    const double sin_squared = std::max(0.0, square(sin_half * tilt.cos_half_difference) -
                                                 square(cos_half * tilt.sin_half_difference));
    const double cos_squared =
        std::max(0.0, square(cos_half * tilt.sin_half_sum) - square(sin_half * tilt.cos_half_sum));
    const double sum = sin_squared + cos_squared;
    const double s = std::sqrt(sin_squared);
    const double c = std::sqrt(cos_squared);
    return {2 * std::atan2(s, c), {2 * s * c / sum, (cos_squared - sin_squared) / sum}};
}

struct RotaryCandidate {
    double second = 0;  // angle of the second joint, without its sign
    Vec3 image;         // the tool rotated by it
};

/// The solution of one candidate, checked forwards.
std::optional<Solution> completed(const Chain& chain, const RotaryCandidate& candidate,
                                  const Vec3& direction, bool is_pole) {
    const RotaryJoint& first = chain.joints[kR1];
    const RotaryJoint& second = chain.joints[kR2];
    const Vec3& n1 = first.direction;
    const Vec3 across = n1.cross(candidate.image);
    const double sine = across.dot(direction);  // n1·(v × w), of the parts across n1
    const double cosine = across.dot(n1.cross(direction));
    const double length = std::sqrt(sine * sine + cosine * cosine);
    const SineCosine rotation =
        is_pole || length == 0 ? SineCosine{} : SineCosine{sine / length, cosine / length};
    if ((turned(n1, rotation, candidate.image) - direction).squaredNorm() >
        kPoleAngle * kPoleAngle * 4)
        return std::nullopt;
    Solution solution;
    solution.is_pole = is_pole;
    solution.rotary[kR1] = is_pole ? 0 : wrapped(first.sign * std::atan2(sine, cosine));
    solution.rotary[kR2] = wrapped(second.sign * candidate.second);
    solution.configuration = configuration_of(chain, solution.rotary);
    return solution;
}

RotaryCandidate candidate_at(const Chain& chain, double opening, const SineCosine& rotation) {
    const OrientationTriangle& tilt = chain.tilt;
    const SineCosine second = {
        tilt.sin_nearest * rotation.cosine + tilt.cos_nearest * rotation.sine,
        tilt.cos_nearest * rotation.cosine - tilt.sin_nearest * rotation.sine};
    return {tilt.nearest + opening,
            turned(chain.joints[kR2].direction, second, chain.tool_direction)};
}

Result<Solutions, ReachFault> solve_pair(const Chain& chain, const Vec3& direction) {
    const Vec3& n1 = chain.joints[kR1].direction;
    const double sine = n1.cross(direction).norm();
    Opening opening = opening_of(chain.tilt, sine, n1.dot(direction));
    const bool is_pole = sine < kPoleAngle;
    const bool is_equator = sine > kAwayFromPole && opening.rotation.sine < kMeeting;
    if (is_equator || is_pole) {
        const bool is_far = opening.rotation.cosine < 0;
        if (is_equator || opening.rotation.sine < kNoOpening)
            opening = {is_far ? kPi : 0, {0, is_far ? -1.0 : 1.0}};
    }
    Solutions solutions;
    const auto add = [&](double angle, const SineCosine& rotation) {
        auto solution = completed(chain, candidate_at(chain, angle, rotation), direction, is_pole);
        if (!solution) return;
        solution->is_equator = is_equator;
        solutions.all[solutions.count++] = *solution;
    };
    add(opening.angle, opening.rotation);
    if (opening.rotation.sine > 0)
        add(-opening.angle, {-opening.rotation.sine, opening.rotation.cosine});
    if (solutions.count == 0) return ReachFault::OutsideReach;
    if (solutions.count == 2 && solutions.all[0].configuration > solutions.all[1].configuration)
        std::swap(solutions.all[0], solutions.all[1]);
    return solutions;
}

/// One rotary axis: the direction lies on its cone or it does not.
Result<Solutions, ReachFault> solve_single(const Chain& chain, const Vec3& direction) {
    const std::size_t which = chain.has(kR1) ? kR1 : kR2;
    const RotaryJoint& joint = chain.joints[which];
    const Vec3 across = joint.direction.cross(chain.tool_direction);
    Solution solution;
    solution.is_pole = across.norm() < kPoleAngle;
    const double angle =
        solution.is_pole
            ? 0.0
            : std::atan2(across.dot(direction), across.dot(joint.direction.cross(direction)));
    if ((turned(joint.direction, sine_cosine_of(angle), chain.tool_direction) - direction).norm() >
        2 * kPoleAngle)
        return ReachFault::MissingJoint;
    solution.rotary[static_cast<Eigen::Index>(which)] = wrapped(joint.sign * angle);
    Solutions solutions;
    solutions.all[solutions.count++] = solution;
    return solutions;
}

/// Azimuth of the tool about n1 that R2 alone gives it, from that of n2: within half a turn in each
/// configuration, so that it never jumps.
double azimuth_by_second(const Chain& chain, double second) {
    const Vec3& n1 = chain.joints[kR1].direction;
    const RotaryJoint& joint = chain.joints[kR2];
    const Vec3 image =
        turned(joint.direction, sine_cosine_of(joint.sign * second), chain.tool_direction);
    const Vec3 across = n1.cross(joint.direction);
    return std::atan2(across.dot(image), across.dot(n1.cross(image)));
}

}  // namespace

Mat3 rotation_about(const Vec3& axis, double angle) {
    return matrix_of(axis, sine_cosine_of(angle));
}

Vec3 tip_of_length(const Chain& chain, double length) { return -length * chain.tool_direction; }

Mat3 rotation_of(const Chain& chain, const Vec3& rotary) {
    return rotation_by(chain, turns_of(chain, rotary));
}

Vec3 tool_vector(const Chain& chain, const Vec3& rotary) {
    Vec3 direction = chain.tool_direction;
    for (const std::size_t k : {kR2, kR1}) {
        const RotaryJoint& joint = chain.joints[k];
        if (joint.is_present)
            direction = turned(joint.direction,
                               sine_cosine_of(joint.sign * rotary[static_cast<Eigen::Index>(k)]),
                               direction);
    }
    return direction;
}

Pose forward(const Chain& chain, const ChainPosition& position, const Vec3& tip) {
    const std::array<SineCosine, kJoints> turns = turns_of(chain, position.rotary);
    Vec3 point = stand_of(chain, position) + through_heads(chain, turns, tip);
    for (const std::size_t k : {kR2, kR1}) {
        if (is_table(chain, k)) point = about_joint(chain.joints[k], turns[k], point);
    }
    return {point, rotation_by(chain, turns)};
}

Vec3 inverse_linear(const Chain& chain, const Vec3& target, const ChainPosition& position,
                    const Vec3& tip) {
    const std::array<SineCosine, kJoints> turns = turns_of(chain, position.rotary);
    Vec3 point = target;
    for (const std::size_t k : {kR1, kR2}) {
        if (is_table(chain, k)) point = back_about_joint(chain.joints[k], turns[k], point);
    }
    point -= through_heads(chain, turns, tip);
    if (chain.compensates_parallel) point -= position.parallel;
    return point;
}

Result<Solutions, ReachFault> solve(const Chain& chain, const Vec3& direction) {
    if (chain.orients()) return solve_pair(chain, direction);
    if (chain.is_turning()) return solve_single(chain, direction);
    if ((chain.tool_direction - direction).norm() > 2 * kPoleAngle) return ReachFault::NoRotaryAxis;
    Solutions solutions;
    solutions.count = 1;
    return solutions;
}

Result<Solutions, ReachFault> solve(const Chain& chain, const Mat3& rotation) {
    auto solutions = solve(chain, Vec3(rotation * chain.tool_direction));
    if (!solutions || !chain.has(kPsi)) return solutions;
    Solutions with_spin = *solutions;
    const Vec3& z0 = chain.tool_direction;
    // Any direction across the tool shows how far the tool has rotated about its axis.
    const Vec3 across = z0.unitOrthogonal();
    for (std::size_t i = 0; i < with_spin.count; ++i) {
        Solution& solution = with_spin.all[i];
        const Vec3 image = rotation_of(chain, solution.rotary).transpose() * (rotation * across);
        const double spin = std::atan2(z0.dot(across.cross(image)), across.dot(image));
        solution.rotary[kPsi] = wrapped(chain.joints[kPsi].sign * spin);
    }
    return with_spin;
}

Solution at_pole(const Chain& chain, const Solution& solution, double first) {
    if (!solution.is_pole) return solution;
    Solution moved = solution;
    moved.rotary[kR1] = first;
    if (!chain.has(kPsi)) return moved;
    // At the pole both turn about the same line, in the same sense or in opposite ones.
    const bool is_same_sense =
        chain.joints[kR1].direction.dot(tool_vector(chain, solution.rotary)) > 0;
    const double turn = chain.joints[kR1].sign * (first - solution.rotary[kR1]);
    moved.rotary[kPsi] =
        wrapped(solution.rotary[kPsi] - chain.joints[kPsi].sign * (is_same_sense ? turn : -turn));
    return moved;
}

int configuration_of(const Chain& chain, const Vec3& rotary) {
    // A rounding error at the middle itself must not decide.
    constexpr double kMiddle = 1e-12;
    if (!chain.orients()) return 1;
    const double from_middle = chain.joints[kR2].sign * rotary[kR2] - chain.tilt.nearest;
    return chain.tilt.first_side * std::sin(from_middle) >= -kMiddle ? 1 : 2;
}

PoleAngleReach pole_angle_reach(const Chain& chain) {
    KADR_ASSERT(chain.orients(), "the reach of a chain without two rotary axes");
    const OrientationTriangle& tilt = chain.tilt;
    const double difference = 2 * std::atan2(tilt.sin_half_difference, tilt.cos_half_difference);
    const double sum = 2 * std::atan2(tilt.sin_half_sum, tilt.cos_half_sum);
    return {std::abs(difference), std::min(sum, 2 * kPi - sum)};
}

double pole_angle_of(const Chain& chain, const Vec3& direction) {
    const Vec3& n1 = chain.joints[kR1].direction;
    return std::atan2(n1.cross(direction).norm(), n1.dot(direction));
}

double first_along_great_circle(const Chain& chain, const Vec3& from_rotary,
                                const Vec3& to_rotary) {
    KADR_ASSERT(chain.orients(), "a path of R1 without two rotary axes");
    const Vec3& n1 = chain.joints[kR1].direction;
    const Vec3 from = n1.cross(tool_vector(chain, from_rotary));
    const Vec3 to = n1.cross(tool_vector(chain, to_rotary));
    // The azimuth of a great circle shorter than half of one changes by less than half a turn.
    const double azimuth = std::atan2(n1.dot(from.cross(to)), from.dot(to));
    double by_second =
        azimuth_by_second(chain, to_rotary[kR2]) - azimuth_by_second(chain, from_rotary[kR2]);
    // Where the configurations meet half a turn may have either sign; the other end tells which.
    if (std::abs(by_second) > kPi) by_second -= std::copysign(2 * kPi, by_second);
    return chain.joints[kR1].sign * (azimuth - by_second);
}

Vec3 linear_velocity(const Chain& chain, const ChainPosition& position, const Vec3& tip,
                     const Vec3& tip_velocity, const Vec3& rotary) {
    const AxesInWorkpiece axes = axes_in_workpiece(chain, position, tip);
    return axes.tables.transpose() * (tip_velocity - swing(chain, axes, rotary));
}

Result<ChainVelocity, VelocityFault> axis_velocities(const Chain& chain,
                                                     const ChainPosition& position, const Vec3& tip,
                                                     const ToolVelocity& velocity) {
    const AxesInWorkpiece axes = axes_in_workpiece(chain, position, tip);
    const Vec3 w = tool_vector(chain, position.rotary);
    auto tilt = tilt_velocity(chain, axes, w, velocity.turn.cross(w));
    if (!tilt) return tilt.error();
    ChainVelocity result;
    result.rotary = *tilt;
    if (chain.has(kPsi)) {
        const Vec3 rest = velocity.turn - result.rotary[kR1] * axes.direction[kR1] -
                          result.rotary[kR2] * axes.direction[kR2];
        result.rotary[kPsi] = chain.joints[kPsi].sign * rest.dot(w);
    }
    result.linear = axes.tables.transpose() * (velocity.tip - swing(chain, axes, result.rotary));
    return result;
}

ToolVelocity tool_velocity(const Chain& chain, const ChainPosition& position, const Vec3& tip,
                           const ChainVelocity& velocity) {
    const AxesInWorkpiece axes = axes_in_workpiece(chain, position, tip);
    ToolVelocity result;
    result.tip = axes.tables * velocity.linear + swing(chain, axes, velocity.rotary);
    for (std::size_t k = 0; k < kJoints; ++k)
        result.turn += velocity.rotary[static_cast<Eigen::Index>(k)] * axes.direction[k];
    return result;
}

}  // namespace kadr::machine
