#include "path/transition.h"

#include <algorithm>
#include <cmath>

namespace kadr::path {

namespace {

// Knots 0, 0, 0, 0, 1, 1.5, 2.5, 2.5, 2.5, 2.5: jerk, no jerk for half as long, jerk.
constexpr double kFirstKnot = 1;
constexpr double kSecondKnot = 1.5;
constexpr double kLastKnot = 2.5;

// Of the distance between an end and the corner. A ramp from v to rest in the time T takes the
// distance v·T/2, so dC/du = 2·distance/kLastKnot at the end, three times that to the second
// control point; and without acceleration at the end the third is kLastKnot times as far.
constexpr double kSecondControlPoint = 2.0 / 3.0 / kLastKnot;
constexpr double kThirdPole = kLastKnot * kSecondControlPoint;

/// Samples of a cubic for the deviation, its start not counted.
constexpr int kSamples = 8;
/// Newton's steps to the nearest point of a leg; it is bent by less than a radian.
constexpr int kSteps = 4;

/// Distance of a point from a leg. The search begins at the share `guess` of the leg.
double distance_to(const Leg& leg, const Vec3& point, double guess) {
    double s = leg.from + guess * (leg.to - leg.from);
    double distance = 0;
    for (int step = 0; step <= kSteps; ++step) {
        const CurvePoint at = evaluate(leg.curve, s);
        const Vec3 delta = point - at.position;
        distance = delta.norm();
        // (C − Q)·C' = 0; its derivative by s is 1 − (Q − C)·C''.
        const double slope = std::max(0.1, 1 - delta.dot(at.curvature));
        const double next = std::clamp(s + delta.dot(at.tangent) / slope, leg.from, leg.to);
        if (next == s) break;
        s = next;
    }
    return distance;
}

}  // namespace

Transition transition_between(const CurvePoint& from, const CurvePoint& to, double distance) {
    const double second = distance * kSecondControlPoint;
    const double third = distance * kThirdPole;
    // The first Bézier polygon is q0, q1, q1 + (q2 − q1)·share; its curvature is two thirds of the
    // height of the third point over the tangent, divided by the square of the first leg.
    constexpr double kShare = kFirstKnot / kSecondKnot;
    const double lift = 1.5 / kShare * second * second;
    const Vec3 q0 = from.position;
    const Vec3 q1 = q0 + second * from.tangent;
    const Vec3 q2 = q0 + third * from.tangent + lift * from.curvature;
    const Vec3 q5 = to.position;
    const Vec3 q4 = q5 - second * to.tangent;
    const Vec3 q3 = q5 - third * to.tangent + lift * to.curvature;
    // Boehm's knot insertion: every inner knot three times. The spline is symmetric in its knots.
    const auto between = [](const Vec3& a, const Vec3& b, double share) {
        return Vec3(a + (b - a) * share);
    };
    const Vec3 early = between(q1, q2, kShare);
    const Vec3 inner_early = between(q2, q3, kFirstKnot / kLastKnot);
    const Vec3 inner_late = between(q2, q3, kSecondKnot / kLastKnot);
    const Vec3 late = between(q4, q3, kShare);
    const Vec3 first_joint = between(early, inner_early, kShare);
    const Vec3 second_joint = between(late, inner_late, kShare);
    const auto [left, right] =
        split(Cubic{first_joint, inner_early, inner_late, second_joint}, 0.5);
    constexpr double kOuter = 2 * kFirstKnot / kLastKnot;
    constexpr double kInner = 1 - kOuter;
    return {Glide{{q0, q1, early, first_joint}, kOuter * distance}, Glide{left, kInner * distance},
            Glide{right, kInner * distance},
            Glide{{second_joint, late, q4, q5}, kOuter * distance}};
}

double deviation(const Transition& transition, const Leg& before, const Leg& behind) {
    const Vec3 corner = position(before.curve, before.to);
    double greatest = 0;
    double nearest = (end(transition[1]) - corner).norm();
    for (std::size_t i = 0; i < transition.size(); ++i) {
        for (int k = 1; k <= kSamples; ++k) {
            const double u = static_cast<double>(k) / kSamples;
            const Vec3 point = position(transition[i], u * transition[i].length);
            nearest = std::min(nearest, (point - corner).norm());
            // How far along the curve the point is, from −1 to 1.
            const double along = (static_cast<double>(i) + u) / 2 - 1;
            const double apart = std::min(distance_to(before, point, std::min(1.0, 1 + along)),
                                          distance_to(behind, point, std::max(0.0, along)));
            greatest = std::max(greatest, apart);
        }
    }
    return std::max(greatest, nearest);
}

}  // namespace kadr::path
