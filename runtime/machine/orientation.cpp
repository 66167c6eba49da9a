#include "machine/orientation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

#include "machine/kinematics.h"
#include "path/frame.h"

namespace kadr::machine {

using path::angle_between;

namespace {

constexpr double kPi = std::numbers::pi;

/// Shorter vectors have no direction: words of programs have six digits and more.
constexpr double kNoLength = 1e-9;

/// Into (−π, π].
double wrapped(double angle) {
    const double reduced = std::remainder(angle, 2 * kPi);
    return reduced <= -kPi ? kPi : reduced;
}

/// Into [0, 2π); a rounding error below zero is none of a whole turn.
double counted_up(double angle) {
    if (std::abs(angle) < kNoLength) return 0;
    return angle < 0 ? angle + 2 * kPi : angle;
}

Vec3 part_across(const Vec3& axis, const Vec3& vector) { return vector - axis * axis.dot(vector); }

/// Right-handed angle about the axis from one vector to the other, (−π, π].
double turn_about(const Vec3& axis, const Vec3& from, const Vec3& to) {
    const Vec3 across = axis.cross(from);
    return std::atan2(across.dot(to), across.dot(axis.cross(to)));
}

/// An arc from a start that is not on the axis.
OrientationArc arc_about(const Vec3& axis, const Vec3& start, double turn) {
    OrientationArc arc;
    arc.axis = axis;
    arc.across = part_across(axis, start).normalized();
    arc.beside = axis.cross(arc.across);
    arc.polar = angle_between(axis, start);
    arc.turn = turn;
    return arc;
}

/// Where the tool is not inclined, first and third turn about the same line: all of it in the
/// third.
Vec3 settled(const Vec3& angles, double sine) {
    if (sine >= kNoLength) return angles;
    const bool is_upright = std::abs(angles[1]) < kPi / 2;
    const double third = is_upright ? angles[2] + angles[0] : angles[2] - angles[0];
    return {0, angles[1], wrapped(third)};
}

/// Angles of Rz·Ry·Rz, and the other names of the same.
AnglePair zyz_pair(const Mat3& r, double shift_first) {
    const double sine = std::hypot(r(0, 2), r(1, 2));
    const double second = std::atan2(sine, r(2, 2));
    // In a matrix without an inclination only its first column shows the rotation.
    const bool is_flat = sine < kNoLength;
    const double first = is_flat ? 0 : std::atan2(r(1, 2), r(0, 2));
    const double third = is_flat ? std::atan2(r(1, 0), r(2, 2) > 0 ? r(0, 0) : -r(0, 0))
                                 : std::atan2(r(2, 1), -r(2, 0));
    // Rx(b) = Rz(−90°) Ry(b) Rz(90°): the angles of Rz·Rx·Rz are those, shifted against each other.
    const Vec3 one = {wrapped(first + shift_first), second, wrapped(third - shift_first)};
    const Vec3 other = {wrapped(one[0] + kPi), -second, wrapped(one[2] + kPi)};
    return {settled(one, sine), settled(other, sine)};
}

}  // namespace

Result<Vec3, OrientationFault> unit_of(const Vec3& vector) {
    const double length = vector.norm();
    if (!(length > kNoLength)) return OrientationFault::ZeroVector;
    return Vec3(vector / length);
}

Mat3 euler_zyz(const Vec3& angles) {
    return rotation_about(Vec3::UnitZ(), angles[0]) * rotation_about(Vec3::UnitY(), angles[1]) *
           rotation_about(Vec3::UnitZ(), angles[2]);
}

Mat3 euler_zxz(const Vec3& angles) {
    return path::rotation_euler({angles[1], angles[2], angles[0]}).linear;
}

Mat3 rpy_zyx(const Vec3& angles) {
    return path::rotation_rpy({angles[0], angles[1], angles[2]}).linear;
}

Mat3 rpy_xyz(const Vec3& angles) {
    return rotation_about(Vec3::UnitX(), angles[0]) * rotation_about(Vec3::UnitY(), angles[1]) *
           rotation_about(Vec3::UnitZ(), angles[2]);
}

AnglePair euler_zyz_of(const Mat3& rotation) { return zyz_pair(rotation, 0); }
AnglePair euler_zxz_of(const Mat3& rotation) { return zyz_pair(rotation, kPi / 2); }

AnglePair rpy_of_direction(const Vec3& direction) {
    // w = (sin B cos A, −sin A, cos B cos A).
    const double flat = std::hypot(direction.x(), direction.z());
    const double a = std::atan2(-direction.y(), flat);
    const double b = flat < kNoLength ? 0 : std::atan2(direction.x(), direction.z());
    return {Vec3(a, b, 0), Vec3(wrapped(kPi - a), wrapped(b + kPi), 0)};
}

Result<Varying, OrientationFault> unit_of(const Varying& vector) {
    const double length = vector.value.norm();
    if (!(length > kNoLength)) return OrientationFault::ZeroVector;
    const Vec3 unit = vector.value / length;
    return Varying{unit, part_across(unit, vector.rate) / length};
}

Result<Varying, OrientationFault> by_lead_tilt(const Varying& tangent, const Varying& normal,
                                               const LeadTilt& angles) {
    const auto n = unit_of(normal);
    const auto t = unit_of(tangent);
    if (!n) return n.error();
    if (!t) return t.error();
    const double inclination = t->value.dot(n->value);
    const double lead_tilt_rate = t->rate.dot(n->value) + t->value.dot(n->rate);
    const auto forward =
        unit_of(Varying{t->value - inclination * n->value,
                        t->rate - lead_tilt_rate * n->value - inclination * n->rate});
    if (!forward) return OrientationFault::NormalAlongTangent;
    const Varying side = {n->value.cross(forward->value),
                          n->rate.cross(forward->value) + n->value.cross(forward->rate)};
    // The direction has constant parts along normal, t' and their product.
    const double sl = std::sin(angles.lead);
    const double cl = std::cos(angles.lead);
    const double st = std::sin(angles.tilt);
    const double ct = std::cos(angles.tilt);
    const Vec3 parts = angles.about == TiltAbout::Normal ? Vec3(cl, sl * ct, sl * st)
                                                         : Vec3(cl * ct, sl, -cl * st);
    const auto composed = [&](Vec3 Varying::*part) -> Vec3 {
        return parts[0] * ((*n).*part) + parts[1] * ((*forward).*part) + parts[2] * (side.*part);
    };
    return Varying{composed(&Varying::value), composed(&Varying::rate)};
}

LeadTilt lead_tilt_of(const Vec3& direction, const Vec3& tangent, const Vec3& normal,
                      TiltAbout about) {
    const double along = direction.dot(tangent);
    const double beside = direction.dot(normal.cross(tangent));
    const double up = direction.dot(normal);
    if (about == TiltAbout::Tangent)
        return {std::atan2(along, std::hypot(beside, up)), std::atan2(-beside, up), about};
    const double inclination = std::hypot(along, beside);
    return {std::atan2(inclination, up), inclination < kNoLength ? 0 : std::atan2(beside, along),
            about};
}

OrientationPoint at(const OrientationArc& arc, double fraction) {
    const double around = fraction * arc.turn;
    const double polar = arc.polar + fraction * arc.polar_change;
    const double sine = std::sin(polar);
    const double cosine = std::cos(polar);
    const double sin_around = std::sin(around);
    const double cos_around = std::cos(around);
    const Vec3 out = cos_around * arc.across + sin_around * arc.beside;
    const Vec3 on = cos_around * arc.beside - sin_around * arc.across;
    const double p = arc.polar_change;
    const double t = arc.turn;
    OrientationPoint point;
    point.direction = cosine * arc.axis + sine * out;
    point.rate = p * (cosine * out - sine * arc.axis) + t * sine * on;
    point.bending = -p * p * point.direction + 2 * p * t * cosine * on - t * t * sine * out;
    point.spin = arc.spin + fraction * arc.spin_change;
    point.spin_rate = arc.spin_change;
    return point;
}

double length_of(const OrientationArc& arc) {
    if (arc.polar_change == 0) return std::abs(arc.turn) * std::sin(arc.polar);
    // Simpson's rule on the rate; openings change by little where they change at all.
    constexpr int kIntervals = 32;
    double sum = 0;
    for (int i = 0; i <= kIntervals; ++i) {
        const double weight = i == 0 || i == kIntervals ? 1 : (i % 2 == 1 ? 4 : 2);
        sum += weight * at(arc, static_cast<double>(i) / kIntervals).rate.norm();
    }
    return sum / (3 * kIntervals);
}

Result<OrientationArc, OrientationFault> great_circle(const Vec3& start, const Vec3& end) {
    const Vec3 across = start.cross(end);
    const double sine = across.norm();
    if (sine < kNoLength && start.dot(end) < 0) return OrientationFault::Antiparallel;
    // Ends that are nearly equal: any axis across them, the direction moves by nothing that counts.
    const Vec3 axis = sine > 0 ? Vec3(across / sine) : start.unitOrthogonal();
    OrientationArc arc = arc_about(axis, start, angle_between(start, end));
    arc.polar = kPi / 2;
    return arc;
}

Result<OrientationArc, OrientationFault> cone_about(const Vec3& start, const Vec3& end,
                                                    const Vec3& axis, ConeSense sense,
                                                    double tolerance) {
    const auto k = unit_of(axis);
    if (!k) return k.error();
    const double polar = angle_between(*k, start);
    const double change = angle_between(*k, end) - polar;
    if (std::abs(change) > tolerance || k->cross(start).norm() < kNoLength ||
        k->cross(end).norm() < kNoLength)
        return OrientationFault::NotOnCone;
    const double up = counted_up(turn_about(*k, start, end));
    const bool is_down = sense == ConeSense::Cw && up > 0;
    OrientationArc arc = arc_about(*k, start, is_down ? up - 2 * kPi : up);
    arc.polar_change = change;
    return arc;
}

Result<OrientationArc, OrientationFault> cone_of_opening(const Vec3& start, const Vec3& end,
                                                         double opening, ConeSense sense) {
    const double angle = angle_between(start, end);
    if (angle < kNoLength) return OrientationFault::EqualVectors;
    if (angle > kPi - kNoLength) return OrientationFault::Antiparallel;
    if (opening < angle - kNoLength) return OrientationFault::OpeningSmall;
    const Vec3 middle = (start + end).normalized();
    const Vec3 across = start.cross(end).normalized();
    const double inclination =
        std::acos(std::clamp(std::cos(opening / 2) / std::cos(angle / 2), 0.0, 1.0));
    const double e = sense == ConeSense::Ccw ? inclination : -inclination;
    const Vec3 axis = middle * std::cos(e) + across * std::sin(e);
    const double turn = std::abs(turn_about(axis, start, end));
    return arc_about(axis, start, sense == ConeSense::Ccw ? turn : -turn);
}

Result<OrientationArc, OrientationFault> cone_through(const Vec3& start, const Vec3& between,
                                                      const Vec3& end) {
    const Vec3 first = between - start;
    const Vec3 second = end - start;
    if (first.norm() < kNoLength || second.norm() < kNoLength || (end - between).norm() < kNoLength)
        return OrientationFault::EqualVectors;
    // Three points of a sphere are never in line, so that the circle has an axis; about it they
    // follow one another counter-clockwise.
    const Vec3 axis = first.cross(second).normalized();
    return arc_about(axis, start, counted_up(turn_about(axis, start, end)));
}

Result<OrientationArc, OrientationFault> cone_tangential(const Vec3& start, const Vec3& rate,
                                                         const Vec3& end) {
    const Vec3 ahead = part_across(start, rate);
    if (ahead.norm() < kNoLength) return great_circle(start, end);
    const Vec3 chord = end - start;
    if (chord.norm() < kNoLength) return OrientationFault::EqualVectors;
    const Vec3 axis = ahead.cross(chord).normalized();
    return arc_about(axis, start, counted_up(turn_about(axis, start, end)));
}

}  // namespace kadr::machine
