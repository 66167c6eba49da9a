#include "machine/chain.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "base/assert.h"
#include "path/orient_law.h"

namespace kadr::machine {

using path::angle_between;

namespace {

/// Directions that differ by less are the same one, rad: no drawing is that exact, and the solver
/// divides by the sine.
constexpr double kSameDirection = 1e-6;

bool are_parallel(const Vec3& a, const Vec3& b) { return a.cross(b).norm() < kSameDirection; }

OrientationTriangle tilt_triangle(const Chain& chain) {
    const Vec3& n1 = chain.joints[kR1].direction;
    const Vec3& n2 = chain.joints[kR2].direction;
    const Vec3& z0 = chain.tool_direction;
    const double alpha = angle_between(n1, n2);
    const double beta = angle_between(n2, z0);
    OrientationTriangle tilt;
    tilt.sin_half_difference = std::sin((alpha - beta) / 2);
    tilt.cos_half_difference = std::cos((alpha - beta) / 2);
    tilt.sin_half_sum = std::sin((alpha + beta) / 2);
    tilt.cos_half_sum = std::cos((alpha + beta) / 2);
    tilt.sin_product = std::sin(alpha) * std::sin(beta);
    // Of both n1 and z0 only the part across n2 takes part in the turning about n2.
    const Vec3 from = z0 - n2 * n2.dot(z0);
    const Vec3 to = n1 - n2 * n2.dot(n1);
    tilt.nearest = std::atan2(n2.dot(from.cross(to)), from.dot(to));
    tilt.sin_nearest = std::sin(tilt.nearest);
    tilt.cos_nearest = std::cos(tilt.nearest);
    // sin(b − nearest) at a small positive R2 where R2 = 0 is in the middle, at R2 = 0 elsewhere.
    const bool zero_is_middle = std::abs(tilt.sin_nearest) < kSameDirection;
    const double side =
        zero_is_middle ? chain.joints[kR2].sign * tilt.cos_nearest : -tilt.sin_nearest;
    tilt.first_side = side < 0 ? -1 : 1;
    return tilt;
}

}  // namespace

Result<Chain, ChainFault> prepare(Chain chain) {
    KADR_ASSERT(chain.tool_direction.norm() > 0, "a chain without a direction of the tool");
    chain.tool_direction.normalize();
    for (RotaryJoint& joint : chain.joints) {
        KADR_ASSERT(joint.direction.norm() > 0, "a rotary axis without a direction");
        joint.direction.normalize();
    }
    const RotaryJoint& first = chain.joints[kR1];
    const RotaryJoint& second = chain.joints[kR2];
    const RotaryJoint& spin = chain.joints[kPsi];
    if (!chain.is_turning()) return ChainFault::NoJoint;
    if (spin.is_present) {
        if (!chain.orients()) return ChainFault::SpinWithoutPair;
        const double off = spin.direction.dot(chain.tool_direction);
        if (spin.side != ChainSide::Head || off < 0 ||
            !are_parallel(spin.direction, chain.tool_direction))
            return ChainFault::SpinNotAlongTool;
        chain.joints[kPsi].direction = chain.tool_direction;
    }
    if (!chain.orients()) return chain;
    if (first.side == ChainSide::Head && second.side == ChainSide::Table)
        return ChainFault::TableBehindHead;
    if (are_parallel(first.direction, second.direction)) return ChainFault::ParallelJoints;
    if (are_parallel(second.direction, chain.tool_direction)) return ChainFault::SecondAlongTool;
    chain.tilt = tilt_triangle(chain);
    return chain;
}

void place_by_vectors(Chain& chain, const AxisVectors& vectors) {
    // With the end of the zero tool at the start point, the axes lie back along the vectors.
    const Vec3 second = -vectors.second_to_tool;
    const Vec3 first = second - vectors.first_to_second;
    const auto place = [&](RotaryJoint& joint, const Vec3& from_tool) {
        joint.point = joint.side == ChainSide::Table ? Vec3(vectors.start + from_tool) : from_tool;
    };
    place(chain.joints[kR1], first);
    place(chain.joints[kR2], second);
}

}  // namespace kadr::machine
