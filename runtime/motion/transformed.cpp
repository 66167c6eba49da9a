#include "motion/transformed.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "motion/transformed_cells.h"

namespace kadr::motion {

namespace {

using machine::Chain;
using machine::ChainPosition;
using path::Vec3;

// Beside the pole by so much, rad, and by so much of the piece, R1 has a position that tells where
// it is at the pole.
constexpr double kBesidePole = 1e-6;

// Differences of positions that are rounding, mm and rad.
constexpr double kRounding = 1e-11;

// Of what an axis needs, the most by which the parts of an even piece may differ.
constexpr double kEvenRate = 1.2;
constexpr double kEvenBend = 1.5;
// Below this part of its acceleration the bending of an axis does not matter.
constexpr double kSlightBend = 0.3;
// … and this part more or less of it is no error of a polynomial.
constexpr double kCourseError = 0.01;
constexpr double kCourseErrorOfCell = 5e-4;
// … nor so much of the path that the axis goes: a swing between two nodes would stand out.
constexpr double kCourseShare = 2e-4;
constexpr double kSlightError = 1e-9;  // mm, rad: of which that is not asked
// The error of the rate at the ends of a polynomial, per step, is so often that an eighth of the
// piece inside, and may be this part of a velocity, and this part of an acceleration that the path
// has where it speeds up as much as the axes allow.
constexpr double kEndRate = 7.3;
constexpr double kVelocityError = 5e-4;
constexpr double kAccelerationError = 5e-4;
// More parts a motion has not; the rest is taken as it comes.
constexpr std::size_t kMostParts = 2048;
// Between two nodes of a polynomial no joint turns farther, rad.
constexpr double kNodeTurn = 0.2;
// A swing of R1 near the pole may be cut as finely as this, in parts of the piece.
constexpr double kFinest = 1e-9;

Eigen::Index at(std::size_t i) { return static_cast<Eigen::Index>(i); }

Vec3 parallels_of(const std::array<double, kFollowers>& followers) {
    return {followers[3], followers[4], followers[5]};
}

/// From the end of the zero tool to the tip, at base position.
Vec3 tip_of(const Segment& piece) { return -piece.carrier; }

}  // namespace

Vec3 joints_of(const Chain& chain, const std::array<double, kFollowers>& followers) {
    Vec3 rotary = Vec3::Zero();
    for (std::size_t k = 0; k < machine::kJoints; ++k) {
        if (chain.has(k)) rotary[at(k)] = followers[index(chain.joints[k].axis) - 3];
    }
    return rotary;
}

void put_joints(const Chain& chain, const Vec3& rotary, std::array<double, kFollowers>& followers) {
    for (std::size_t k = 0; k < machine::kJoints; ++k) {
        if (chain.has(k)) followers[index(chain.joints[k].axis) - 3] = rotary[at(k)];
    }
}

namespace {

std::array<double, kFollowers> followers_at(const Segment& piece, double distance) {
    std::array<double, kFollowers> followers{};
    for (std::size_t i = 0; i < kFollowers; ++i)
        followers[i] = piece.follower_start[i] + piece.follower_rate[i] * distance;
    return followers;
}

}  // namespace

Segment standing_at(const Segment& piece, double distance) {
    Segment still = piece;
    const path::CurvePoint at = path::evaluate(piece.curve, distance);
    still.curve = path::Point{at.position};
    still.follower_start = followers_at(piece, distance);
    still.follower_rate = {};
    path::Contact& contact = still.contact;
    if (contact.kind == path::ContactKind::Flank) {
        contact.kind = path::ContactKind::Pivot;
        contact.guide = at.tangent;
    } else if (piece.orientation.length > 0) {
        contact.guide = path::guide_at(contact, distance / piece.orientation.length);
    }
    contact.turn = 0;
    still.orientation = path::OrientLaw{};
    still.orientation.kind = path::OrientKind::Axes;
    return still;
}

namespace {

/// … and the linear axes that belong to them.
LogicalAxes complete(const Chain& chain, const Segment& piece, const Vec3& tip,
                     const std::array<double, kFollowers>& followers) {
    ChainPosition position;
    position.rotary = joints_of(chain, followers);
    position.parallel = parallels_of(followers);
    const Vec3 linear = machine::inverse_linear(chain, tip, position, tip_of(piece));
    LogicalAxes axes{linear[0], linear[1], linear[2]};
    std::ranges::copy(followers, axes.begin() + 3);
    return axes;
}

/// At the pole R1 has the position with which the tool gets there: a nutating head's still moves.
/// From two points beside it, since so near to the pole the rounding of a direction would turn R1.
double first_at_pole(const Chain& chain, const Segment& piece, double distance, const Vec3& near) {
    const path::OrientLaw& orientation = piece.orientation;
    const double inwards = distance > orientation.length / 2 ? -1 : 1;
    const auto beside = [&](double step) {
        return path::direction_at(orientation, piece.curve, distance + inwards * step);
    };
    const Vec3& axis = chain.joints[machine::kR1].direction;
    double step = kBesidePole * orientation.length;
    while (step < orientation.length / 4 && axis.cross(beside(step)).norm() < kBesidePole)
        step *= 2;
    const Vec3 farther = joints_for(chain, beside(2 * step), near);
    const Vec3 nearer = joints_for(chain, beside(step), farther);
    return 2 * nearer[0] - farther[0];
}

Vec3 joints_along(const Chain& chain, const Segment& piece, double distance, const Vec3& direction,
                  Vec3 near) {
    const path::OrientLaw& orientation = piece.orientation;
    const bool stands = orientation.kind == path::OrientKind::Cone && orientation.rate == 0;
    if (stands || !is_at_pole(chain, direction)) return joints_for(chain, direction, near);
    near[0] = first_at_pole(chain, piece, distance, near);
    Vec3 joints = joints_for(chain, direction, near);
    joints[0] = near[0];
    return joints;
}

/// In polar or cylindrical coordinates the tool stands as it does, and a rotary axis follows the
/// path. Where it turns alone, in the centre of polar coordinates, it is a follower like any other.
ToolPose virtual_near(const Segment& piece, double distance, const Vec3& tip,
                      const LogicalAxes& near) {
    ToolPose placed;
    placed.tip = tip;
    placed.tool = piece.tool;
    LogicalAxes& axes = placed.axes;
    std::ranges::copy(followers_at(piece, distance), axes.begin() + 3);
    const Vec3 real = path::real_position(piece.virtual_axes, tip) + piece.carrier;
    for (std::size_t i = 0; i < 3; ++i) axes[i] = real[at(i)];
    const std::size_t rotary = index(piece.virtual_axes.rotary);
    const bool turns_alone = piece.follower_rate[rotary - 3] != 0;
    if (piece.virtual_axes.turns() && !turns_alone)
        axes[rotary] = path::rotary_at(piece.virtual_axes, tip, near[rotary]);
    return placed;
}

Vec3 tool_at(const Chain& chain, const Segment& piece, double distance) {
    if (gives_direction(piece.orientation))
        return path::direction_at(piece.orientation, piece.curve, distance);
    return machine::tool_vector(chain, joints_of(chain, followers_at(piece, distance)));
}

std::optional<Vec3> aside_at(const Segment& piece, double distance, const Vec3& tool) {
    const path::Contact& contact = piece.contact;
    const double share = piece.orientation.length > 0 ? distance / piece.orientation.length : 0;
    const Vec3 guide = contact.kind == path::ContactKind::Flank
                           ? path::evaluate(piece.curve, distance).tangent
                           : path::guide_at(contact, share);
    return path::tip_beside(contact, guide, tool);
}

/// From where the cutter touches to its tip.
Vec3 tip_beside(const Chain& chain, const Segment& piece, double distance, const Vec3& point,
                const Vec3& tool) {
    if (const auto aside = aside_at(piece, distance, tool)) [[likely]]
        return point + *aside;
    const double length = piece.orientation.length;
    if (length == 0) return point + path::tip_square(piece.contact, tool);
    const auto aside = path::tip_or_limit(distance / length, [&](double share) {
        const double at = share * length;
        return aside_at(piece, at, tool_at(chain, piece, at));
    });
    return aside ? Vec3(point + *aside) : point;  // that there is one was checked
}

/// From point to point the axes tell where the tip is.
ToolPose pose_straight(const Chain& chain, const Segment& piece, double distance,
                       const Vec3& point) {
    ToolPose placed;
    const Vec3 linear = point + piece.carrier;
    for (std::size_t i = 0; i < 3; ++i) placed.axes[i] = linear[at(i)];
    const auto followers = followers_at(piece, distance);
    std::ranges::copy(followers, placed.axes.begin() + 3);
    placed.tip = tip_at(chain, placed.axes, piece.carrier);
    placed.tool = machine::tool_vector(chain, joints_of(chain, followers));
    return placed;
}

/// pose_at() with the joints going on from where they stand in `near`.
ToolPose pose_near(const Chain& chain, const Segment& piece, double distance, const Vec3& point,
                   const LogicalAxes& near) {
    if (piece.goes_straight()) return pose_straight(chain, piece, distance, point);
    if (piece.virtual_axes.is_on()) return virtual_near(piece, distance, point, near);
    ToolPose placed;
    auto followers = followers_at(piece, distance);
    if (gives_direction(piece.orientation)) {
        std::array<double, kFollowers> from{};
        std::copy(near.begin() + 3, near.end(), from.begin());
        placed.tool = path::direction_at(piece.orientation, piece.curve, distance);
        Vec3 rotary = joints_along(chain, piece, distance, placed.tool, joints_of(chain, from));
        rotary[2] = joints_of(chain, followers)[2];
        put_joints(chain, rotary, followers);
    } else {
        if (piece.orientation.kind == path::OrientKind::Joints)
            put_joints(chain, path::position(piece.orientation.joints, distance), followers);
        placed.tool = machine::tool_vector(chain, joints_of(chain, followers));
    }
    placed.tip = piece.contact.kind == path::ContactKind::Tip
                     ? point
                     : tip_beside(chain, piece, distance, point, placed.tool);
    placed.axes = complete(chain, piece, placed.tip, followers);
    return placed;
}

}  // namespace

LogicalAxes axes_near(const Chain& chain, const Segment& piece, double distance,
                      const LogicalAxes& near) {
    return pose_near(chain, piece, distance, path::position(piece.curve, distance), near).axes;
}

LogicalAxes start_of(const Segment& piece) {
    LogicalAxes axes{};
    std::ranges::copy(piece.follower_start, axes.begin() + 3);
    return axes;
}

ToolPose pose_at(const Chain& chain, const Segment& piece, double distance, const Vec3& point) {
    return pose_near(chain, piece, distance, point, start_of(piece));
}

LogicalAxes axes_at(const Chain& chain, const Segment& piece, double distance) {
    return axes_near(chain, piece, distance, start_of(piece));
}

std::vector<Segment> tip_lines(const Chain& chain, const Segment& piece) {
    // A circle of half a metre is missed by a fifth of a millimetre.
    constexpr double kTurn = 3 * std::numbers::pi / 180;
    const double length = path::length(piece.curve);
    double turned = 0;
    for (std::size_t i = 0; i < 3; ++i) turned += std::abs(piece.follower_rate[i]) * length;
    const double count = std::clamp(std::ceil(turned / kTurn), 1.0, 1000.0);
    std::vector<Segment> lines;
    const auto tip = [&](double distance) {
        return pose_at(chain, piece, distance, path::position(piece.curve, distance)).tip;
    };
    Vec3 from = tip(0);
    for (double i = 0; i < count; ++i) {
        const Vec3 to = tip(length * (i + 1) / count);
        Segment& line = lines.emplace_back(piece);
        if ((to - from).norm() > 0) line.curve = path::make_line(from, to);
        else line.curve = path::Point{from};
        line.start_time += piece.duration * i / count;
        line.duration /= count;
        from = to;
    }
    return lines;
}

Vec3 tip_at(const Chain& chain, const LogicalAxes& axes, const Vec3& carrier) {
    std::array<double, kFollowers> followers{};
    std::copy(axes.begin() + 3, axes.end(), followers.begin());
    const ChainPosition position{
        {axes[0], axes[1], axes[2]}, parallels_of(followers), joints_of(chain, followers)};
    return machine::forward(chain, position, -carrier).tip;
}

// ------------------------------------------------------------------------------ polynomials

namespace {

constexpr std::size_t kIntervals = 4;

/// Positions at equal distances, each found from the one before it.
std::array<LogicalAxes, kIntervals + 1> nodes_of(const Chain& chain, const Segment& piece) {
    std::array<LogicalAxes, kIntervals + 1> nodes;
    LogicalAxes near = start_of(piece);
    for (std::size_t i = 0; i <= kIntervals; ++i) {
        const double part = static_cast<double>(i) / kIntervals;
        near = nodes[i] = axes_near(chain, piece, part * piece.orientation.length, near);
    }
    return nodes;
}

/// Newton's forward differences of five values as a polynomial of t = 4u.
std::array<double, kIntervals + 1> through(std::array<double, kIntervals + 1> values) {
    for (std::size_t k = 1; k <= kIntervals; ++k) {
        for (std::size_t i = kIntervals; i >= k; --i) values[i] -= values[i - 1];
    }
    for (std::size_t k = 2; k <= kIntervals; ++k) {
        if (std::abs(values[k]) < kRounding) values[k] = 0;
    }
    const auto& d = values;
    return {d[0], d[1] - d[2] / 2 + d[3] / 3 - d[4] / 4, d[2] / 2 - d[3] / 2 + 11 * d[4] / 24,
            d[3] / 6 - d[4] / 4, d[4] / 24};
}

}  // namespace

AxisPolynomials::AxisPolynomials(const Chain& chain, const Segment& piece)
    : length_(piece.orientation.length) {
    const auto nodes = nodes_of(chain, piece);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        std::array<double, kNodes> values{};
        for (std::size_t i = 0; i < kNodes; ++i) values[i] = nodes[i][axis];
        coefficients_[axis] = through(values);
    }
}

double AxisPolynomials::position(std::size_t axis, double u) const {
    const auto& c = coefficients_[axis];
    const double t = kIntervals * u;
    return c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * c[4])));
}

double AxisPolynomials::rate(std::size_t axis, double u) const {
    const auto& c = coefficients_[axis];
    const double t = kIntervals * u;
    return (c[1] + t * (2 * c[2] + t * (3 * c[3] + t * 4 * c[4]))) * kIntervals / length_;
}

double AxisPolynomials::bend(std::size_t axis, double u) const {
    const auto& c = coefficients_[axis];
    const double t = kIntervals * u;
    const double step = kIntervals / length_;
    return (2 * c[2] + t * (6 * c[3] + t * 12 * c[4])) * step * step;
}

double AxisPolynomials::third(std::size_t axis, double u) const {
    const auto& c = coefficients_[axis];
    const double t = kIntervals * u;
    const double step = kIntervals / length_;
    return (6 * c[3] + t * 24 * c[4]) * step * step * step;
}

// ------------------------------------------------------------------------------ even parts

namespace {

struct ValueRange {
    double least = std::numeric_limits<double>::infinity();
    double most = 0;

    void take(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
};

/// Rotary axes that follow from where the tip and the tool are to be.
AxisMask turning_axes(const Chain& chain, const Segment& piece) {
    if (piece.virtual_axes.is_on())
        return piece.virtual_axes.turns() ? bit(piece.virtual_axes.rotary) : AxisMask{0};
    AxisMask axes = 0;
    for (const machine::RotaryJoint& joint : chain.joints)
        if (joint.is_present) axes = static_cast<AxisMask>(axes | bit(joint.axis));
    return axes;
}

/// Whether no joint turns so far between two nodes that another solution might be meant.
bool is_continuous(const Chain& chain, const Segment& piece) {
    const auto nodes = nodes_of(chain, piece);
    const AxisMask turning = turning_axes(chain, piece);
    for (std::size_t axis = 3; axis < kAxes; ++axis) {
        if ((turning & bit(static_cast<Axis>(axis))) == 0) continue;
        if (std::abs(nodes[0][axis] - piece.follower_start[axis - 3]) > kNodeTurn) return false;
        for (std::size_t i = 1; i < nodes.size(); ++i)
            if (std::abs(nodes[i][axis] - nodes[i - 1][axis]) > kNodeTurn) return false;
    }
    return true;
}

/// The most acceleration along the path that no axis forbids at either end, where the path does not
/// bend it.
double most_along(const AxisPolynomials& polynomials, const AxisBounds& bounds) {
    double along = std::numeric_limits<double>::infinity();
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const double rate =
            std::max(std::abs(polynomials.rate(axis, 0)), std::abs(polynomials.rate(axis, 1)));
        if (rate * along > bounds.acceleration[axis]) along = bounds.acceleration[axis] / rate;
    }
    return along;
}

/// Whether the polynomial is the path of the axes between its nodes too, to a small part of what
/// the limits allow. The error of a polynomial through five points is greatest in its derivatives
/// at the ends: there it is 30 and 64 times what it is an eighth of the piece inside, per step² and
/// step³.
bool is_exact(const Chain& chain, const Segment& piece, const AxisPolynomials& polynomials,
              const AxisBounds& bounds, double speed, const PartWishes& wishes) {
    if (std::isinf(speed)) return true;
    const double slight = wishes.as_cells ? kCourseErrorOfCell : kCourseError;
    const double time = piece.orientation.length / kIntervals / speed;  // of a step
    const bool passes_in_a_tick = piece.orientation.length < wishes.time * speed;
    const double along = most_along(polynomials, bounds) * kIntervals / piece.orientation.length;
    for (const double u : {0.125, 0.875}) {
        const LogicalAxes exact = axes_at(chain, piece, u * piece.orientation.length);
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            const double error = std::abs(exact[axis] - polynomials.position(axis, u));
            if (error < kRounding) continue;
            const double distance =
                std::abs(polynomials.position(axis, 1) - polynomials.position(axis, 0.5)) +
                std::abs(polynomials.position(axis, 0.5) - polynomials.position(axis, 0));
            if (error > std::max(kCourseShare * distance, kSlightError)) return false;
            if (kEndRate * error * along > kAccelerationError * bounds.acceleration[axis])
                return false;
            if (passes_in_a_tick) continue;
            if (kEndRate * error > kVelocityError * bounds.velocity[axis] * time) return false;
            if (30 * error > slight * bounds.acceleration[axis] * time * time) return false;
            if (64 * error > slight * bounds.jerk[axis] * time * time * time) return false;
        }
    }
    return true;
}

bool is_even(const Chain& chain, const Segment& piece, const AxisBounds& bounds,
             const PartWishes& wishes) {
    if (!is_continuous(chain, piece)) return false;
    const AxisPolynomials polynomials(chain, piece);
    ValueRange slowness;
    ValueRange stiffness;
    for (std::size_t i = 0; i <= kIntervals; ++i) {
        const double u = static_cast<double>(i) / kIntervals;
        double slow = 0;
        double stiff = 0;
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            slow = std::max(slow, std::abs(polynomials.rate(axis, u)) / bounds.velocity[axis]);
            stiff =
                std::max(stiff, std::abs(polynomials.bend(axis, u)) / bounds.acceleration[axis]);
        }
        slowness.take(slow);
        stiffness.take(stiff);
    }
    const bool is_slow = slowness.most * wishes.speed > 1;  // the velocity of an axis limits it
    const double speed = is_slow ? 1 / slowness.most : wishes.speed;
    if (!is_exact(chain, piece, polynomials, bounds, speed, wishes)) return false;
    if (piece.orientation.length < wishes.time * speed) return true;
    if (wishes.as_cells)
        return is_nearly_straight(polynomials, bounds, wishes.speed) ||
               cell_on(polynomials, bounds, wishes.speed).has_value();
    if (is_slow && slowness.most > kEvenRate * slowness.least) return false;
    const bool is_slight = std::isinf(speed) || stiffness.most * speed * speed < kSlightBend;
    return is_slight || stiffness.most <= kEvenBend * stiffness.least;
}

}  // namespace

std::vector<Segment> even_parts(const Chain& chain, const Segment& whole, const AxisBounds& bounds,
                                const PartWishes& wishes) {
    const double length = whole.orientation.length;
    const double finest = kFinest * length;
    std::vector<Segment> parts;
    Segment rest = whole;
    double from = 0;
    double step = length;
    while (from < length) {
        double to = length - from < step * (1 + kFinest) ? length : from + step;
        Segment part = part_of(rest, 0, to - from);
        if (to - from > finest && parts.size() < kMostParts &&
            !is_even(chain, part, bounds, wishes)) {
            step = (to - from) / 2;
            continue;
        }
        const LogicalAxes end = nodes_of(chain, part).back();
        rest = part_of(rest, to - from, length - from);
        std::copy(end.begin() + 3, end.end(), rest.follower_start.begin());
        parts.push_back(part);
        step = 2 * (to - from);
        from = to;
    }
    return parts;
}

}  // namespace kadr::motion
