// Motions under the machine's transformation: the tip goes along its path, the orientation changes,
// and the axes are where the chain has them.
//
// A motion is cut into legs at the poles of R1 that the tool passes: there R1 may have to turn
// while everything else stands (motion.md §6.3). Each leg becomes pieces that one speed suits.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "base/assert.h"
#include "base/units.h"
#include "motion/orientation_corner.h"
#include "motion/prepare_state.h"
#include "motion/transformed.h"

namespace kadr::motion {

namespace {

using machine::Chain;
using path::Command;
using path::Op;
using path::OrientKind;
using path::OrientLaw;
using path::Vec3;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// So far the joints may be from where a motion should end, rad: rounding of degrees.
constexpr double kSameJoint = 1e-8;
// … and so far, where they followed a great circle all along, rad: the rest is another turn, or
// another way round the pole.
constexpr double kFollowed = 1e-5;
// So far the tool may be from where a motion should end, rad; beside the pole R1 is known less
// well.
constexpr double kSameDirection = 1e-5;
// A cone as wide as this is a great circle: what its axis is not square to the tool, rad.
constexpr double kSquare = 1e-9;
// At the edge of what the axes cannot reach R1 swings as at a pole. A gap up to so many times the
// tolerance, as axes have that are measured out of square, is passed at so many times its width.
constexpr double kSmallGap = 4;
constexpr double kBesideGap = 1.5;

/// So far along a motion the tool stands at the pole of R1.
struct Passage {
    double distance = 0;
    Vec3 direction = Vec3::Zero();  // of the axis R1, towards the tool
};

/// Where the tool comes nearest to one end of the axis R1, if that is inside the motion and near
/// enough. Turned about `axis` by φ, its component along R1 is c + a·cos φ + b·sin φ.
std::optional<Passage> passage_of(const OrientLaw& orientation, const Vec3& pole,
                                  double tolerance) {
    const double along = orientation.axis.dot(orientation.start) * orientation.axis.dot(pole);
    const double a = orientation.start.dot(pole) - along;
    const double b = orientation.axis.cross(orientation.start).dot(pole);
    if (std::hypot(a, b) == 0) return std::nullopt;
    const double whole = orientation.rate * orientation.length;
    double angle = std::atan2(b, a);
    if (whole < 0 && angle > 0) angle -= 2 * std::numbers::pi;
    if (whole > 0 && angle < 0) angle += 2 * std::numbers::pi;
    const double inside = angle / whole;
    const double margin = machine::kPoleWidth / std::abs(whole);
    if (!(inside > margin && inside < 1 - margin)) return std::nullopt;
    const Vec3 nearest = Eigen::AngleAxisd(angle, orientation.axis) * orientation.start;
    if (nearest.cross(pole).norm() > tolerance || nearest.dot(pole) < 0) return std::nullopt;
    return Passage{inside * orientation.length, pole};
}

/// The turn of a leg between two directions along the shorter great circle.
void lay_great_circle(const Vec3& from, const Vec3& to, OrientLaw& orientation) {
    const Vec3 across = from.cross(to);
    const double sine = across.norm();
    orientation.start = from;
    orientation.rate = sine > 0 ? std::atan2(sine, from.dot(to)) / orientation.length : 0;
    if (sine > 0) orientation.axis = across / sine;
}

Vec3 end_of(const Segment& leg) {
    return path::direction_at(leg.orientation, leg.curve, leg.orientation.length);
}

machine::DirectionFunction direction_along(const Segment& leg) {
    return [&leg](double fraction) {
        return path::direction_at(leg.orientation, leg.curve, fraction * leg.orientation.length);
    };
}

/// Whether the axes come to the end of a great circle by following it all along.
bool is_followed(const Chain& chain, const Segment& whole, const Vec3& to) {
    const Vec3 from = joints_of(chain, whole.follower_start);
    const Vec3 end = end_of(whole);
    if (is_at_pole(chain, whole.orientation.start) || is_at_pole(chain, end)) return true;
    if (machine::crosses_gap(chain, whole.orientation.start, end)) return false;
    const double distance = machine::first_along_great_circle(chain, from, to);
    if (machine::configuration_of(chain, from) == machine::configuration_of(chain, to) &&
        std::abs(from[0] + distance - to[0]) < kFollowed)
        return true;
    // Where the configurations meet, the formula may not tell.
    const LogicalAxes axes = OrientationPath(chain, whole).end();
    std::array<double, kFollowers> followers{};
    std::copy(axes.begin() + 3, axes.end(), followers.begin());
    return (joints_of(chain, followers) - to).head<2>().norm() < kFollowed;
}

/// A great circle that passes near enough to a pole is led through it.
std::vector<Segment> legs_through(const Segment& whole, const std::vector<Passage>& passages) {
    std::vector<Segment> legs;
    double from = 0;
    Vec3 direction = whole.orientation.start;
    for (std::size_t i = 0; i <= passages.size(); ++i) {
        const bool is_last = i == passages.size();
        const double to = is_last ? whole.orientation.length : passages[i].distance;
        const Vec3 towards = is_last ? end_of(whole) : passages[i].direction;
        Segment& leg = legs.emplace_back(part_of(whole, from, to));
        lay_great_circle(direction, towards, leg.orientation);
        from = to;
        direction = towards;
    }
    return legs;
}

/// The part of a great circle that is nearer to a pole than this, rad; nothing if there is none.
std::optional<PathPart> part_beside(const OrientLaw& orientation, const Vec3& pole, double width) {
    const double a = orientation.start.dot(pole);
    const double b = orientation.axis.cross(orientation.start).dot(pole);
    const double ahead = std::hypot(a, b);  // cosine of the least distance on the whole circle
    if (ahead < std::cos(width)) return std::nullopt;
    const double half = std::acos(std::min(1.0, std::cos(width) / ahead));
    const double whole = orientation.rate * orientation.length;
    double middle = std::atan2(b, a);
    middle -= 2 * std::numbers::pi * std::round((middle - whole / 2) / (2 * std::numbers::pi));
    const double from = std::clamp((middle - half) / whole, 0.0, 1.0);
    const double to = std::clamp((middle + half) / whole, 0.0, 1.0);
    if (from == to) return std::nullopt;
    return PathPart{std::min(from, to) * orientation.length,
                    std::max(from, to) * orientation.length};
}

/// Where a great circle begins or ends beside a pole, or where no axes can be at the pole, they run
/// evenly there from one configuration to the other, or R1 round: nowhere farther from the circle
/// than its distance from the pole.
std::vector<Segment> legs_beside(const Chain& chain, const Segment& whole, double width) {
    if (width == 0) return {whole};
    const Vec3 first = chain.joints[machine::kR1].direction;
    std::vector<PathPart> beside;
    for (const Vec3& pole : {first, Vec3(-first)})
        if (const auto part = part_beside(whole.orientation, pole, width)) beside.push_back(*part);
    std::ranges::sort(beside, {}, &PathPart::from);
    std::vector<Segment> legs;
    double from = 0;
    for (PathPart& part : beside) {
        if (part.from - from > kStill) legs.push_back(part_of(whole, from, part.from));
        else part.from = from;
        if (whole.orientation.length - part.to < kStill) part.to = whole.orientation.length;
        legs.push_back(part_of(whole, part.from, part.to));
        legs.back().orientation.kind = OrientKind::Axes;
        from = part.to;
    }
    if (whole.orientation.length - from > kStill)
        legs.push_back(part_of(whole, from, whole.orientation.length));
    return legs;
}

std::vector<Segment> legs_of_circle(const Chain& chain, const Segment& whole, const Vec3& to,
                                    double tolerance) {
    const Vec3 first = chain.joints[machine::kR1].direction;
    const double gap = machine::pole_angle_reach(chain).lower;
    if (gap > machine::kPoleWidth) {
        const bool is_small = gap < kSmallGap * tolerance;
        const double width = is_followed(chain, whole, to) ? 0 : tolerance;
        return legs_beside(chain, whole, is_small ? std::max(width, kBesideGap * gap) : width);
    }
    std::vector<Passage> passages;
    for (const Vec3& pole : {first, Vec3(-first)}) {
        if (const auto found = passage_of(whole.orientation, pole, tolerance))
            passages.push_back(*found);
    }
    std::ranges::sort(passages, {}, &Passage::distance);
    if (!passages.empty()) return legs_through(whole, passages);
    if (is_followed(chain, whole, to)) return {whole};
    return legs_beside(chain, whole, tolerance);
}

/// The motion between poles; one leg if it passes none.
///
/// to  where the joints are to be at its end
std::vector<Segment> legs_of(const Chain& chain, const Segment& whole, const Vec3& to,
                             double tolerance) {
    const OrientLaw& orientation = whole.orientation;
    if (!gives_direction(orientation) || !chain.orients()) return {whole};
    if (orientation.kind == OrientKind::Cone) {
        if (orientation.rate == 0) return {whole};
        if (std::abs(orientation.axis.dot(orientation.start)) < kSquare)
            return legs_of_circle(chain, whole, to, tolerance);
    }
    std::vector<Segment> legs;
    double from = 0;
    for (const auto& passage :
         machine::pole_passages(chain, direction_along(whole), machine::kPoleWidth)) {
        const double parameter = passage.fraction * orientation.length;
        legs.push_back(part_of(whole, from, parameter));
        from = parameter;
    }
    legs.push_back(part_of(whole, from, orientation.length));
    return legs;
}

/// The joints go from here to there in proportion to the path of the leg.
void run_evenly(const Chain& chain, const Vec3& from, const Vec3& to, Segment& leg) {
    std::array<double, kFollowers> rates{};
    put_joints(chain, (to - from) / leg.orientation.length, rates);
    for (std::size_t k = 0; k < machine::kJoints; ++k) {
        if (!chain.has(k)) continue;
        const std::size_t follower = index(chain.joints[k].axis) - 3;
        leg.follower_rate[follower] = rates[follower];
    }
}

/// Whether the tool leaves the pole in this leg.
bool starts_at_pole(const Chain& chain, const Segment& leg) {
    if (!gives_direction(leg.orientation) || !chain.orients()) return false;
    return is_at_pole(chain, path::direction_at(leg.orientation, leg.curve, 0));
}

}  // namespace

/// The legs of a motion, each with the turn of R1 before it that a pole asks for.
void Preparer::State::emit_transformed(const Command& command, const Segment& whole,
                                       AxesPosition::MotionEnd& target) {
    if (whole.virtual_axes.is_on()) return emit_virtual(command, whole, target);
    const Chain& chain = axes.chain();
    const double tolerance = std::max(machine.kinematics->pole_tolerance, machine::kPoleWidth);
    const Vec3 to = joints_of(chain, target.followers);
    Vec3 joints = joints_of(chain, whole.follower_start);
    std::vector<Segment> legs = legs_of(chain, whole, to, tolerance);
    for (std::size_t i = 0; i < legs.size() && !has_ended; ++i) {
        Segment& leg = legs[i];
        put_joints(chain, joints, leg.follower_start);
        const bool is_beside =
            gives_direction(whole.orientation) && !gives_direction(leg.orientation);
        if (is_beside) {
            const bool is_last = i + 1 == legs.size();
            run_evenly(
                chain, joints,
                is_last ? to : machine::joints_before(chain, direction_along(legs[i + 1]), to),
                leg);
        } else if (starts_at_pole(chain, leg)) {
            // Only behind the last pole the end of the motion tells how it is left.
            const Vec3 wanted = i + 1 == legs.size()
                                    ? machine::joints_before(chain, direction_along(leg), to)
                                    : joints;
            turn_at_pole(command, leg, {wanted[0], joints[1], joints[2]});
            joints[0] = wanted[0];
            put_joints(chain, joints, leg.follower_start);
        }
        if (!emit_leg(command, leg, whole.orientation.length, joints)) return;
    }
    if (has_ended) return;
    // An end at the pole leaves R1 free: it goes where the program knows it.
    if (std::abs(joints[0] - to[0]) > kSameJoint && !legs.empty()) {
        const double off =
            std::abs(joints[0] - to[0]) * std::sin(machine::pole_angle_of(chain, end_of(whole)));
        KADR_ASSERT(std::abs(off) < kSameDirection, "the tool stands as the block says");
        Segment end = standing_at(legs.back(), legs.back().orientation.length);
        put_joints(chain, joints, end.follower_start);
        turn_at_pole(command, end, {to[0], joints[1], joints[2]});
        joints[0] = to[0];
    }
    put_joints(chain, joints, target.followers);
    end_command();
}

/// Whether a motion is led from its start to its end without a pole, at which R1 may have to turn,
/// and by no other axes than those that hold the tip.
///
/// to  where the joints are to be at its end
bool Preparer::State::is_one_way(const Segment& whole, const Vec3& to) const {
    if (whole.virtual_axes.is_on() || whole.contact.kind != path::ContactKind::Tip) return false;
    if ((whole.followers & ~kRotaryABC) != 0) return false;
    const Chain& chain = axes.chain();
    if (!gives_direction(whole.orientation)) return true;
    const double tolerance = std::max(machine.kinematics->pole_tolerance, machine::kPoleWidth);
    const std::vector<Segment> legs = legs_of(chain, whole, to, tolerance);
    if (legs.size() != 1 || !gives_direction(legs[0].orientation)) return false;
    return !starts_at_pole(chain, whole) && !is_at_pole(chain, end_of(whole));
}

/// R1 turns to another position as fast as it can while the tip stands.
void Preparer::State::turn_at_pole(const Command& command, const Segment& at, const Vec3& to) {
    const Chain& chain = axes.chain();
    const Vec3 from = joints_of(chain, at.follower_start);
    const double distance = to[0] - from[0];
    if (std::abs(distance) <= kSameJoint) return;
    turn_alone(command, at, chain.joints[machine::kR1].axis, distance);
}

/// A rotary axis turns by so much, rad, as fast as it can while the tip stands.
void Preparer::State::turn_alone(const Command& command, const Segment& at, Axis axis,
                                 double distance) {
    Segment turn = standing_at(at, 0);
    turn.kind = SegmentKind::Rapid;
    turn.is_rotary_only = true;
    turn.orientation.kind = OrientKind::Axes;
    turn.orientation.length = deg_from_rad(std::abs(distance));
    turn.follower_rate[index(axis) - 3] = distance / turn.orientation.length;
    Command rapid = command;
    rapid.become(Op::Rapid);
    // Its feed changes along the path, of which this is none.
    if (has_law(rapid)) rapid.motion().dynamics->law = {};
    last.must_stop = true;
    emit_path(rapid, turn, turn.orientation.length);
    last.must_stop = true;
}

/// Not done if the axes cannot go there.
///
/// length  of the whole motion, by which its time under inverse time feed is shared out
/// joints  where they stand at the end
Done Preparer::State::emit_leg(const Command& command, const Segment& leg, double length,
                               Vec3& joints) {
    const std::optional<LogicalAxes> end = emit_path(command, leg, length);
    if (!end) return kFailed;
    std::array<double, kFollowers> followers{};
    std::copy(end->begin() + 3, end->end(), followers.begin());
    joints = joints_of(axes.chain(), followers);
    return kDone;
}

/// A leg in even parts; where the axes stand at its end, nothing if they cannot go there.
std::optional<LogicalAxes> Preparer::State::emit_path(const Command& command, const Segment& leg,
                                                      double length) {
    const Chain& chain = axes.chain();
    const double wanted = feed_of(command, leg, leg.orientation.length).value_or(kInfinity) *
                          (command.motion().keeps_feed ? 1 : options.feed_override);
    const bool is_rapid = leg.kind == SegmentKind::Rapid;
    const bool as_cells = allows_cells(command) && (!is_rapid || options.rapid_override == 1);
    const std::vector<Segment> parts =
        even_parts(chain, leg, axes.bounds(), {wanted, tick, as_cells});
    for (const Segment& part : parts) {
        if (!check_axes(command, part, part.orientation.length)) return std::nullopt;
        if (!has_ended) check.widen_travel();
    }
    Command share = command;
    const bool starts_at_rest = last.must_stop;
    double from = 0;
    for (const Segment& part : parts) {
        if (has_ended) return std::nullopt;
        if (command.motion().feed_mode == path::FeedMode::InverseTime)
            share.motion().feed = command.motion().feed * length / part.orientation.length;
        // Between two parts the axes go on evenly: the ends of their paths differ by rounding.
        const bool is_inside = as_cells && &part != &parts.front();
        const double to = from + part.orientation.length;
        const double before = starts_at_rest ? kInfinity : from;
        const double behind = command.motion().exact_stop ? kInfinity : leg.orientation.length - to;
        emit(share, part, part.orientation.length,
             {.as_cell = as_cells, .is_inside = is_inside, .margin = std::min(before, behind)});
        from = to;
    }
    return axes_at(chain, parts.back(), parts.back().orientation.length);
}

}  // namespace kadr::motion
