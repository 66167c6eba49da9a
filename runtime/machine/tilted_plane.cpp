#include "machine/tilted_plane.h"

#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

namespace kadr::machine {

namespace {

/// Sine of the least angle between two directions that span a plane.
constexpr double kOneLine = 1e-9;

/// Rounding of a limit that was given in degrees, rad.
constexpr double kLimitSlack = 1e-9;

/// Two solutions whose reference joints differ by less are as good as each other, rad.
constexpr double kSameValue = 1e-9;

Mat3 columns(const Vec3& x, const Vec3& y, const Vec3& z) {
    Mat3 result;
    result << x, y, z;
    return result;
}

path::Frame back_about(const RotaryJoint& joint, double angle) {
    const Mat3 back = rotation_about(joint.direction, -joint.sign * angle);
    return {back, joint.point - back * joint.point};
}

double wrapped(double angle) {
    const double reduced = std::remainder(angle, 2 * std::numbers::pi);
    return reduced <= -std::numbers::pi ? std::numbers::pi : reduced;
}

/// The turn of an angle that is nearest to the start and within the limits; nothing if none is.
std::optional<double> nearest_turn(double angle, double start, const AxisRange& limits) {
    constexpr double kTurn = 2 * std::numbers::pi;
    const double nearest = start + std::remainder(angle - start, kTurn);
    const double lower = limits.lower - kLimitSlack;
    const double upper = limits.upper + kLimitSlack;
    if (nearest >= lower && nearest <= upper) return nearest;
    const double from = nearest < lower ? nearest + kTurn * std::ceil((lower - nearest) / kTurn)
                                        : nearest - kTurn * std::ceil((nearest - upper) / kTurn);
    if (from >= lower && from <= upper) return from;
    return std::nullopt;
}

/// The solution in the turns next to the start; nothing if limits forbid it.
std::optional<Vec3> within_limits(const Chain& chain, const Solution& solution,
                                  const SwivelQuery& query) {
    const Vec3 wanted = at_pole(chain, solution, query.start[kR1]).rotary;
    Vec3 rotary = query.start;  // Ψ stays
    for (const std::size_t k : {kR1, kR2}) {
        if (!chain.has(k)) continue;
        const auto at = static_cast<Eigen::Index>(k);
        const std::optional<double> turn =
            nearest_turn(wanted[at], query.start[at], query.limits[k]);
        if (!turn) return std::nullopt;
        rotary[at] = *turn;
    }
    return rotary;
}

}  // namespace

Mat3 turned_in_order(std::span<const AxisRotation> turns) {
    Mat3 rotation = Mat3::Identity();
    for (const AxisRotation& turn : turns)
        rotation = rotation * rotation_about(path::unit(turn.axis), turn.angle);
    return rotation;
}

Mat3 turned_about_fixed(std::span<const AxisRotation> turns) {
    Mat3 rotation = Mat3::Identity();
    for (const AxisRotation& turn : turns)
        rotation = rotation_about(path::unit(turn.axis), turn.angle) * rotation;
    return rotation;
}

Result<Mat3, PlaneFault> projected(const ProjectionAngles& angles) {
    const Vec3 x(std::cos(angles.about_y), 0, -std::sin(angles.about_y));
    const Vec3 cut(0, std::cos(angles.about_x), std::sin(angles.about_x));
    const Vec3 normal = x.cross(cut);
    if (normal.norm() < kOneLine) return PlaneFault::OneLine;
    const Vec3 z = normal.normalized();
    return Mat3(columns(x, z.cross(x), z) * rotation_about(Vec3::UnitZ(), angles.about_z));
}

Result<Mat3, PlaneFault> through_points(std::span<const Vec3, 3> points) {
    const Vec3 along = points[1] - points[0];
    const Vec3 aside = points[2] - points[0];
    if (along.norm() == 0 || aside.norm() == 0) return PlaneFault::ZeroVector;
    const Vec3 x = along.normalized();
    const Vec3 normal = x.cross(aside.normalized());
    if (normal.norm() < kOneLine) return PlaneFault::OneLine;
    const Vec3 z = normal.normalized();
    return columns(x, z.cross(x), z);
}

Result<Mat3, PlaneFault> by_axes(const Vec3& x, const Vec3& z, double most_off) {
    if (x.norm() == 0 || z.norm() == 0) return PlaneFault::ZeroVector;
    const Vec3 first = x.normalized();
    const Vec3 last = z.normalized();
    if (std::abs(std::asin(std::clamp(first.dot(last), -1.0, 1.0))) > most_off)
        return PlaneFault::NotSquare;
    const Vec3 normal = (last - first * first.dot(last)).normalized();
    return columns(first, normal.cross(first), normal);
}

Mat3 square_to_tool(const Vec3& tool) {
    const Vec3 across = Vec3::UnitZ().cross(tool);
    if (across.norm() < kOneLine && tool.z() > 0) return Mat3::Identity();
    const Vec3 x = across.norm() < kOneLine ? Vec3(Vec3::UnitX()) : Vec3(across.normalized());
    return columns(x, tool.cross(x), tool);
}

Mat3 square_to_tool_near(const Vec3& tool, const Mat3& old) {
    // Exactly where it stood: no rounding of a frame that need not change.
    if ((old.col(2) - tool).norm() < kOneLine) return old;
    const Vec3 x = old.col(0) - tool * tool.dot(old.col(0));
    if (x.norm() > kOneLine) {
        const Vec3 first = x.normalized();
        return columns(first, tool.cross(first), tool);
    }
    const Vec3 y = (old.col(1) - tool * tool.dot(old.col(1))).normalized();
    return columns(y.cross(tool), y, tool);
}

path::Frame table_frame(const Chain& chain, const Vec3& rotary) {
    path::Frame frame;
    for (std::size_t k = 0; k < kJoints; ++k) {
        const RotaryJoint& joint = chain.joints[k];
        if (!joint.is_present || joint.side != ChainSide::Table) continue;
        frame = back_about(joint, rotary[static_cast<Eigen::Index>(k)]) * frame;
    }
    return frame;
}

Vec3 head_offset(const Chain& chain, const Vec3& rotary, const Vec3& tip) {
    Vec3 point = tip;
    for (const std::size_t k : {kPsi, kR2, kR1}) {
        const RotaryJoint& joint = chain.joints[k];
        if (!joint.is_present || joint.side != ChainSide::Head) continue;
        const double angle = joint.sign * rotary[static_cast<Eigen::Index>(k)];
        point = joint.point + rotation_about(joint.direction, angle) * (point - joint.point);
    }
    return point;
}

Vec3 tool_in_base(const Chain& chain, const Vec3& rotary) {
    return table_frame(chain, rotary).direction(tool_vector(chain, rotary)).normalized();
}

Result<Vec3, PathRefusal> choose_swivel(const Chain& chain, const SwivelQuery& query) {
    const auto solutions = solve(chain, query.direction);
    std::optional<Vec3> chosen;
    const auto reference = static_cast<Eigen::Index>(query.reference);
    if (query.sense != 0 && solutions) {
        for (const Solution& solution : *solutions) {
            const std::optional<Vec3> rotary = within_limits(chain, solution, query);
            if (!rotary) continue;
            const double ahead =
                chosen
                    ? query.sense * (wrapped((*rotary)[reference]) - wrapped((*chosen)[reference]))
                    : 1;
            if (ahead > kSameValue) chosen = rotary;
        }
        if (chosen) return *chosen;
    }
    PathQuery path = query_for(chain, query.direction);
    path.start = query.start;
    path.limits = query.limits;
    path.rule = query.rule;
    const auto end = choose_path(chain, path);
    if (!end) return end.error();
    return end->rotary;
}

}  // namespace kadr::machine
