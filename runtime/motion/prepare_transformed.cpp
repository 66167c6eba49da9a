// Motions under the machine's transformation: the tip goes along its path, the tool turns, and the
// axes are where the chain says.
//
// A motion is cut into legs at the poles of R1 that the tool passes: there R1 may have to turn
// while everything else stands (motion.md §6.3). Each leg becomes pieces that one speed suits.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "base/units.h"
#include "motion/prepare_state.h"
#include "motion/transformed.h"

namespace kadr::motion {

namespace {

using machine::Chain;
using path::Command;
using path::Op;
using path::Turn;
using path::Turning;
using path::Vec3;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// So far the joints may be from where a motion should end, rad: rounding of degrees.
constexpr double kSameJoint = 1e-8;
// A cone as wide as this is a great circle: what its axis is not square to the tool, rad.
constexpr double kSquare = 1e-9;

/// So far along a motion the tool stands at the pole of R1.
struct Passage {
    double distance = 0;
    Vec3 direction = Vec3::Zero();  // of the axis R1, towards the tool
};

/// Where the tool comes nearest to one end of the axis R1, if that is inside the motion and near
/// enough. Turned about `axis` by φ, its component along R1 is c + a·cos φ + b·sin φ.
std::optional<Passage> passage_of(const Turn& turn, const Vec3& pole, double tolerance) {
    const double along = turn.axis.dot(turn.start) * turn.axis.dot(pole);
    const double a = turn.start.dot(pole) - along;
    const double b = turn.axis.cross(turn.start).dot(pole);
    if (std::hypot(a, b) == 0) return std::nullopt;
    const double whole = turn.rate * turn.length;
    double angle = std::atan2(b, a);
    if (whole < 0 && angle > 0) angle -= 2 * std::numbers::pi;
    if (whole > 0 && angle < 0) angle += 2 * std::numbers::pi;
    const double inside = angle / whole;
    const double margin = machine::kPoleWidth / std::abs(whole);
    if (!(inside > margin && inside < 1 - margin)) return std::nullopt;
    const Vec3 nearest = Eigen::AngleAxisd(angle, turn.axis) * turn.start;
    if (nearest.cross(pole).norm() > tolerance || nearest.dot(pole) < 0) return std::nullopt;
    return Passage{inside * turn.length, pole};
}

/// The turn of a leg between two directions along the shorter great circle.
void lay_great_circle(const Vec3& from, const Vec3& to, Turn& turn) {
    const Vec3 across = from.cross(to);
    const double sine = across.norm();
    turn.start = from;
    turn.rate = sine > 0 ? std::atan2(sine, from.dot(to)) / turn.length : 0;
    if (sine > 0) turn.axis = across / sine;
}

Vec3 end_of(const Segment& leg) { return path::direction_at(leg.turn, leg.curve, leg.turn.length); }

machine::Course course_of(const Segment& leg) {
    return [&leg](double fraction) {
        return path::direction_at(leg.turn, leg.curve, fraction * leg.turn.length);
    };
}

/// A great circle that comes near enough to a pole is led through it.
std::vector<Segment> legs_of_circle(const Chain& chain, const Segment& whole, double tolerance) {
    const Vec3 first = chain.joints[machine::kR1].direction;
    std::vector<Passage> passages;
    for (const Vec3& pole : {first, Vec3(-first)}) {
        if (const auto found = passage_of(whole.turn, pole, tolerance)) passages.push_back(*found);
    }
    if (passages.empty()) return {whole};
    std::ranges::sort(passages, {}, &Passage::distance);
    std::vector<Segment> legs;
    double from = 0;
    Vec3 direction = whole.turn.start;
    for (std::size_t i = 0; i <= passages.size(); ++i) {
        const bool is_last = i == passages.size();
        const double to = is_last ? whole.turn.length : passages[i].distance;
        const Vec3 towards = is_last ? end_of(whole) : passages[i].direction;
        Segment& leg = legs.emplace_back(part_of(whole, from, to));
        lay_great_circle(direction, towards, leg.turn);
        from = to;
        direction = towards;
    }
    return legs;
}

/// The motion between poles; one leg if it passes none.
std::vector<Segment> legs_of(const Chain& chain, const Segment& whole, double tolerance) {
    const Turn& turn = whole.turn;
    if (!leads_tool(turn) || !chain.orients()) return {whole};
    if (turn.kind == Turning::Cone) {
        if (turn.rate == 0) return {whole};
        if (std::abs(turn.axis.dot(turn.start)) < kSquare)
            return legs_of_circle(chain, whole, tolerance);
    }
    std::vector<Segment> legs;
    double from = 0;
    for (const auto& passage :
         machine::pole_passages(chain, course_of(whole), machine::kPoleWidth)) {
        const double to = passage.fraction * turn.length;
        legs.push_back(part_of(whole, from, to));
        from = to;
    }
    legs.push_back(part_of(whole, from, turn.length));
    return legs;
}

/// Whether the tool leaves the pole in this leg.
bool starts_at_pole(const Chain& chain, const Segment& leg) {
    if (!leads_tool(leg.turn) || !chain.orients()) return false;
    return is_at_pole(chain, path::direction_at(leg.turn, leg.curve, 0));
}

}  // namespace

/// The legs of a motion, each with the turn of R1 before it that a pole asks for.
void Preparer::State::emit_transformed(const Command& command, const Segment& whole,
                                       Standing::Target& target) {
    if (whole.virtual_axes.is_on()) return emit_virtual(command, whole, target);
    const Chain& chain = axes.chain();
    const double tolerance = std::max(machine.kinematics->pole_tolerance, machine::kPoleWidth);
    const Vec3 to = joints_of(chain, target.followers);
    Vec3 joints = joints_of(chain, whole.follower_start);
    std::vector<Segment> legs = legs_of(chain, whole, tolerance);
    for (std::size_t i = 0; i < legs.size() && !has_ended; ++i) {
        Segment& leg = legs[i];
        put_joints(chain, joints, leg.follower_start);
        if (starts_at_pole(chain, leg)) {
            // Only behind the last pole the end of the motion says how it is left.
            const Vec3 wanted =
                i + 1 == legs.size() ? machine::joints_before(chain, course_of(leg), to) : joints;
            turn_at_pole(command, leg, {wanted[0], joints[1], joints[2]});
            joints[0] = wanted[0];
            put_joints(chain, joints, leg.follower_start);
        }
        if (!emit_leg(command, leg, whole.turn.length, joints)) return;
    }
    if (has_ended) return;
    // An end at the pole leaves R1 free: it goes where the program knows it.
    if (std::abs(joints[0] - to[0]) > kSameJoint && !legs.empty()) {
        Segment end = standing_at(legs.back(), legs.back().turn.length);
        put_joints(chain, joints, end.follower_start);
        turn_at_pole(command, end, {to[0], joints[1], joints[2]});
        joints[0] = to[0];
    }
    put_joints(chain, joints, target.followers);
    end_command();
}

/// Whether a motion is led from its start to its end without a pole, at which R1 may have to turn,
/// and by no other axes than those that hold the tip.
bool Preparer::State::is_one_way(const Segment& whole) const {
    if (whole.virtual_axes.is_on() || whole.contact.kind != path::ContactKind::Tip) return false;
    if ((whole.followers & ~kRotaryABC) != 0) return false;
    const Chain& chain = axes.chain();
    if (!leads_tool(whole.turn)) return true;
    const double tolerance = std::max(machine.kinematics->pole_tolerance, machine::kPoleWidth);
    if (legs_of(chain, whole, tolerance).size() != 1) return false;
    return !starts_at_pole(chain, whole) && !is_at_pole(chain, end_of(whole));
}

/// R1 turns to another place as fast as it can while the tip stands.
void Preparer::State::turn_at_pole(const Command& command, const Segment& at, const Vec3& to) {
    const Chain& chain = axes.chain();
    const Vec3 from = joints_of(chain, at.follower_start);
    const double way = to[0] - from[0];
    if (std::abs(way) <= kSameJoint) return;
    turn_alone(command, at, chain.joints[machine::kR1].axis, way);
}

/// A rotary axis turns by so much, rad, as fast as it can while the tip stands.
void Preparer::State::turn_alone(const Command& command, const Segment& at, Axis axis, double way) {
    Segment turn = standing_at(at, 0);
    turn.kind = SegmentKind::Rapid;
    turn.turns_only = true;
    turn.turn.kind = Turning::Axes;
    turn.turn.length = deg_from_rad(std::abs(way));
    turn.follower_rate[index(axis) - 3] = way / turn.turn.length;
    Command rapid = command;
    rapid.op = Op::Rapid;
    last.must_stop = true;
    emit_way(rapid, turn, turn.turn.length);
    last.must_stop = true;
}

/// False if the axes cannot go there, which was reported.
///
/// length  of the whole motion, by which its time under inverse time feed is shared out
/// joints  where they stand at the end
bool Preparer::State::emit_leg(const Command& command, const Segment& leg, double length,
                               Vec3& joints) {
    const std::optional<LogicalAxes> end = emit_way(command, leg, length);
    if (!end) return false;
    std::array<double, kFollowers> followers{};
    std::copy(end->begin() + 3, end->end(), followers.begin());
    joints = joints_of(axes.chain(), followers);
    return true;
}

/// A leg in even parts; where the axes stand at its end, nothing if they cannot go there.
std::optional<LogicalAxes> Preparer::State::emit_way(const Command& command, const Segment& leg,
                                                     double length) {
    const Chain& chain = axes.chain();
    const double wanted = feed_of(command, leg, leg.turn.length).value_or(kInfinity);
    const bool is_rapid = leg.kind == SegmentKind::Rapid;
    const bool as_cells = allows_cells(command) && (!is_rapid || options.rapid_override == 1);
    const std::vector<Segment> parts =
        even_parts(chain, leg, axes.bounds(), {wanted, tick, as_cells});
    for (const Segment& part : parts) {
        if (!is_possible(command, part, part.turn.length)) return std::nullopt;
        if (!has_ended) check.widen_travel();
    }
    Command share = command;
    for (const Segment& part : parts) {
        if (has_ended) return std::nullopt;
        if (command.feed_mode == path::FeedMode::InverseTime)
            share.feed = command.feed * length / part.turn.length;
        // Between two parts the axes go on evenly: the ends of their courses differ by rounding.
        const bool is_inside = as_cells && &part != &parts.front();
        emit(share, part, part.turn.length, {.as_cell = as_cells, .is_inside = is_inside});
    }
    return axes_at(chain, parts.back(), parts.back().turn.length);
}

}  // namespace kadr::motion
