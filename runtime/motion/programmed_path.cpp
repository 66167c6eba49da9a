#include "motion/programmed_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "motion/transformed.h"
#include "path/curve.h"

namespace kadr::motion {

namespace {

using machine::Chain;
using path::CurvePoint;
using path::Vec3;

/// Steps to the nearest point; they end where one is shorter than rounding.
constexpr int kSteps = 12;
constexpr double kSameShare = 1e-13;  // of the path
/// Points at which all of a motion is looked at.
constexpr int kLooks = 64;
/// More of them are not looked at at once, beside an arc around the tip.
constexpr std::size_t kMostLooks = 10000;
/// An axis may be beside its path by so much, rad or mm: rounding of degrees and of lengths.
constexpr double kSameFollower = 1e-7;
/// Width of the difference that stands for a derivative, of the path.
constexpr double kStencil = 1e-5;

/// How a point along a motion is given.
enum class MotionParameter : std::uint8_t {
    Circle,  // by the angle
    Span,    // by the parameter, 0 … 1
    Length,  // by the length of the path
    Turn,    // likewise; only the tool, or axes beside X, Y, Z, move
    Touch,   // likewise; the tip is beside the path and goes along it
};

bool follows_axes(const Segment& segment) {
    return !segment.is_transformed() || segment.orientation.kind == path::OrientKind::Axes ||
           segment.virtual_axes.is_on();
}
bool changes_orientation(const Segment& segment) {
    return segment.is_transformed() && !segment.virtual_axes.is_on();
}

bool touches(const ProgrammedMotion& motion) {
    return motion.segment.contact.kind != path::ContactKind::Tip;
}

MotionParameter walk_of(const ProgrammedMotion& motion) {
    const Segment& segment = motion.segment;
    // Where the cutter rolls around a point its tip tells how far; where only the orientation
    // changes, the tip may stand.
    const bool stands = std::holds_alternative<path::Point>(segment.curve);
    if (touches(motion) && (!stands || segment.contact.turn != 0)) return MotionParameter::Touch;
    if (stands) return MotionParameter::Turn;
    if (std::holds_alternative<path::Helix>(segment.curve)) return MotionParameter::Circle;
    const bool is_alone = segment.followers == 0 && !changes_orientation(segment);
    const bool is_span = std::holds_alternative<path::CubicSpan>(segment.curve) ||
                         std::holds_alternative<path::QuinticSpan>(segment.curve);
    return is_alone && is_span ? MotionParameter::Span : MotionParameter::Length;
}

double end_parameter(const ProgrammedMotion& motion, MotionParameter walk) {
    if (walk == MotionParameter::Circle) return std::get<path::Helix>(motion.segment.curve).sweep;
    return walk == MotionParameter::Span ? 1 : motion.length;
}

double length_at(const ProgrammedMotion& motion, MotionParameter walk, double parameter) {
    if (walk != MotionParameter::Circle) return parameter;
    const auto& helix = std::get<path::Helix>(motion.segment.curve);
    return (helix.rate + helix.rate_slope * parameter / 2) * parameter;
}

/// Calls `use` with a curve whose points are given by the parameter.
template <typename Use>
auto with_span(const path::Curve& curve, const Use& use) {
    if (const auto* cubic = std::get_if<path::CubicSpan>(&curve)) return use(*cubic);
    return use(std::get<path::QuinticSpan>(curve));
}

Vec3 tip_of_span(const path::Curve& curve, double u) {
    return with_span(curve, [u](const auto& span) { return path::point_at(span, u).position; });
}

Vec3 tip_on(const Chain& chain, const ProgrammedMotion& motion, MotionParameter walk,
            double parameter) {
    const path::Curve& curve = motion.segment.curve;
    if (touches(motion))
        return pose_at(chain, motion.segment, parameter, path::position(curve, parameter)).tip;
    switch (walk) {
        case MotionParameter::Circle:
            return path::position_at_angle(std::get<path::Helix>(curve), parameter);
        case MotionParameter::Span: return tip_of_span(curve, parameter);
        default: return path::position(curve, parameter);
    }
}

double follower_at(const Segment& segment, std::size_t i, double distance) {
    return segment.follower_start[i] + segment.follower_rate[i] * distance;
}

Vec3 direction_on(const Chain& chain, const Segment& segment, double distance) {
    if (gives_direction(segment.orientation))
        return path::direction_at(segment.orientation, segment.curve, distance);
    std::array<double, kFollowers> followers{};
    for (std::size_t i = 0; i < kFollowers; ++i) followers[i] = follower_at(segment, i, distance);
    return machine::tool_vector(chain, joints_of(chain, followers));
}

// ------------------------------------------------------------------------------ nearest points

/// Where the foot of a perpendicular is looked for, and where it may be at all.
struct Search {
    double guess = 0;
    double lower = 0;
    double upper = 0;
};

double on_line(const path::Line& line, const Vec3& tip, const Search& search) {
    return std::clamp((tip - line.start).dot(line.direction), search.lower, search.upper);
}

/// Where a tip beside a rising or a widening arc has its foot, from the point at its angle on.
double beside_helix(const path::Helix& helix, const Vec3& tip, double angle, const Search& search) {
    if (helix.height_rate == 0 && helix.radius_rate == 0) return angle;
    for (int step = 0; step < kSteps; ++step) {
        const Vec3 out = std::cos(angle) * helix.e1 + std::sin(angle) * helix.e2;
        const Vec3 around = std::cos(angle) * helix.e2 - std::sin(angle) * helix.e1;
        const double radius = helix.radius + helix.radius_rate * angle;
        const Vec3 slope =
            helix.radius_rate * out + radius * around + helix.height_rate * helix.normal;
        const double off = (tip - path::position_at_angle(helix, angle)).dot(slope);
        const double next =
            std::clamp(angle + off / slope.squaredNorm(), search.lower, search.upper);
        if (std::abs(next - angle) <= kSameShare * helix.sweep) return next;
        angle = next;
    }
    return angle;
}

/// The angle of the tip, of all turns the first one that is not much before the guess.
double on_circle(const path::Helix& helix, const Vec3& tip, const Search& search) {
    constexpr double kTurn = 2 * std::numbers::pi;
    // Rounding may put the tip before the point from where it is looked for, by less than a turn.
    constexpr double kBehind = 1e-4;
    const Vec3 out = tip - helix.base;
    const double angle = std::atan2(out.dot(helix.e2), out.dot(helix.e1));
    const double lower = search.lower - kBehind;
    double ahead = std::fmod(angle - lower, kTurn);
    if (ahead < 0) ahead += kTurn;
    const double found = std::max(search.lower, lower + ahead);
    if (found <= search.upper) return beside_helix(helix, tip, found, search);
    // Behind the end, or before the start.
    const bool is_before = found - search.upper > search.lower + kTurn - found;
    return beside_helix(helix, tip, is_before ? search.lower : search.upper, search);
}

double on_span(const path::Curve& curve, const Vec3& tip, const Search& search) {
    return with_span(curve, [&](const auto& span) {
        double u = search.guess;
        for (int step = 0; step < kSteps; ++step) {
            const path::SplinePoint at = path::point_at(span, u);
            const Vec3 delta = tip - at.position;
            const double square = at.first.squaredNorm();
            // (C − Q)·C' = 0; where the curve bends away from the tip the slope is kept from zero.
            const double slope = std::max(square / 8, square - delta.dot(at.second));
            if (!(slope > 0)) break;
            const double next =
                std::clamp(u + delta.dot(at.first) / slope, search.lower, search.upper);
            const bool is_found = std::abs(next - u) <= kSameShare;
            u = next;
            if (is_found) break;
        }
        return u;
    });
}

/// By length; `at` gives point and derivative by it.
template <typename At>
double by_steps(const At& at, const Vec3& wanted, const Search& search) {
    double s = search.guess;
    for (int step = 0; step < kSteps; ++step) {
        const CurvePoint here = at(s);
        const Vec3 delta = wanted - here.position;
        const double square = here.tangent.squaredNorm();
        const double slope = std::max(square / 8, square - delta.dot(here.curvature));
        if (!(slope > 0)) break;
        const double next =
            std::clamp(s + delta.dot(here.tangent) / slope, search.lower, search.upper);
        const bool is_found = std::abs(next - s) <= kSameShare * search.upper;
        s = next;
        if (is_found) break;
    }
    return s;
}

/// A function of the length with its derivative.
template <typename Function>
auto with_slope(const Function& function, double length) {
    return [&function, length](double s) {
        const double step = kStencil * length;
        const double before = std::max(0.0, s - step);
        const double behind = std::min(length, s + step);
        return CurvePoint{function(s),
                          Vec3((function(behind) - function(before)) / (behind - before))};
    };
}

/// Where the axes stand that follow evenly.
double by_followers(const ProgrammedMotion& motion, const StandingTool& tool,
                    const Search& search) {
    double product = 0;
    double square = 0;
    for (std::size_t i = 0; i < kFollowers; ++i) {
        const double rate = motion.segment.follower_rate[i];
        if (rate == 0 || std::isnan(tool.followers[i])) continue;
        product += rate * (tool.followers[i] - motion.segment.follower_start[i]);
        square += rate * rate;
    }
    return square > 0 ? std::clamp(product / square, search.lower, search.upper) : search.upper;
}

double on_turn(const Chain& chain, const ProgrammedMotion& motion, const StandingTool& tool,
               const Search& search) {
    if (follows_axes(motion.segment)) return by_followers(motion, tool, search);
    const auto direction = [&](double s) { return direction_on(chain, motion.segment, s); };
    return by_steps(with_slope(direction, motion.length), tool.tool, search);
}

double parameter_on(const Chain& chain, const ProgrammedMotion& motion, MotionParameter walk,
                    const StandingTool& tool, const Search& search) {
    const path::Curve& curve = motion.segment.curve;
    switch (walk) {
        case MotionParameter::Circle:
            return on_circle(std::get<path::Helix>(curve), tool.tip, search);
        case MotionParameter::Span: return on_span(curve, tool.tip, search);
        case MotionParameter::Turn: return on_turn(chain, motion, tool, search);
        case MotionParameter::Touch: {
            const auto tip = [&](double s) { return tip_on(chain, motion, walk, s); };
            return by_steps(with_slope(tip, motion.length), tool.tip, search);
        }
        case MotionParameter::Length: break;
    }
    if (const auto* line = std::get_if<path::Line>(&curve)) return on_line(*line, tool.tip, search);
    return by_steps([&](double s) { return path::evaluate(curve, s); }, tool.tip, search);
}

// ------------------------------------------------------------------------------ what else is there

void judge_tool(const Chain& chain, const ProgrammedMotion& motion, const StandingTool& tool,
                double distance, Nearness& near) {
    near.direction_tolerance = motion.inclination;
    const Vec3 wanted = direction_on(chain, motion.segment, distance);
    near.inclination = path::angle_between(wanted, tool.tool);
    if (!(near.inclination > motion.inclination)) return;
    // Where axes run evenly past a pole the tool may be on one side of it, its path on the other.
    const Vec3 pole = chain.joints[machine::kR1].direction;
    if (wanted.cross(pole).norm() <= motion.pole) near.direction_tolerance += motion.pole;
    // Where the tip may be beside its path, it may be on as well.
    const double beside = 2 * motion.tolerance;
    const Vec3 before = direction_on(chain, motion.segment, std::max(0.0, distance - beside));
    const Vec3 behind =
        direction_on(chain, motion.segment, std::min(motion.length, distance + beside));
    near.direction_tolerance += path::angle_between(before, behind);
}

void judge_followers(const ProgrammedMotion& motion, const StandingTool& tool, double distance,
                     Nearness& near) {
    const Segment& segment = motion.segment;
    const bool has_led = segment.virtual_axes.turns();
    for (std::size_t i = 0; i < kFollowers; ++i) {
        const double rate = segment.follower_rate[i];
        if (has_led && rate == 0 && i + 3 == index(segment.virtual_axes.rotary)) continue;
        const double off = std::abs(tool.followers[i] - follower_at(segment, i, distance));
        const double allowed = kSameFollower + 2 * std::abs(rate) * motion.tolerance;
        // One that the machine does not have is no number.
        if (!(off - allowed > near.off - near.off_allowed)) continue;
        near.off = off;
        near.off_allowed = allowed;
    }
}

Nearness judged(const Chain& chain, const ProgrammedMotion& motion, MotionParameter walk,
                const StandingTool& tool, double parameter) {
    Nearness near;
    near.parameter = parameter;
    near.distance = (tip_on(chain, motion, walk, parameter) - tool.tip).norm();
    near.off_allowed = kSameFollower;
    if (!(near.distance <= motion.tolerance)) return near;
    const double distance = length_at(motion, walk, parameter);
    if (changes_orientation(motion.segment)) judge_tool(chain, motion, tool, distance, near);
    else judge_followers(motion, tool, distance, near);
    return near;
}

/// Of some points from end to end of the search, the nearest to the tool.
double nearest_look(const Chain& chain, const ProgrammedMotion& motion, MotionParameter walk,
                    const StandingTool& tool, const Search& search) {
    const bool by_tool = walk == MotionParameter::Turn && !follows_axes(motion.segment);
    double nearest = search.guess;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kLooks; ++i) {
        const double parameter = search.lower + (search.upper - search.lower) * i / kLooks;
        const Vec3 off = by_tool ? Vec3(direction_on(chain, motion.segment, parameter) - tool.tool)
                                 : Vec3(tip_on(chain, motion, walk, parameter) - tool.tip);
        const double apart = off.squaredNorm();
        if (apart >= least) continue;
        least = apart;
        nearest = parameter;
    }
    return nearest;
}

/// The first point whose distance from a tip is within the tolerance, or the one of the least
/// distance, to a part of the tolerance. By arc length the distance changes no faster than the
/// point: halves that cannot hold such a point are left out.
double parameter_by_halves(const ProgrammedMotion& motion, const Vec3& tip, const Search& search) {
    struct Look {
        double parameter;
        double distance;
    };
    double width = (search.upper - search.lower) / kLooks;
    std::vector<Look> looks(kLooks);
    for (int i = 0; i < kLooks; ++i)
        looks[static_cast<std::size_t>(i)].parameter = search.lower + (i + 0.5) * width;
    Look best{search.guess, std::numeric_limits<double>::infinity()};
    for (;; width /= 2) {
        for (Look& look : looks)
            look.distance = (path::position(motion.segment.curve, look.parameter) - tip).norm();
        const auto within = std::ranges::find_if(
            looks, [&](const Look& look) { return look.distance <= motion.tolerance; });
        if (within != looks.end()) {
            best = *within;
            looks.erase(within, looks.end());
        } else if (best.distance > motion.tolerance) {
            for (const Look& look : looks)
                if (look.distance < best.distance) best = look;
        }
        if (looks.empty() || width < motion.tolerance / 4 || looks.size() > kMostLooks)
            return best.parameter;
        const double reached = std::max(best.distance, motion.tolerance);
        std::vector<Look> halves;
        for (const Look& look : looks) {
            if (look.distance - width / 2 > reached) continue;
            halves.push_back({look.parameter - width / 4, 0});
            halves.push_back({look.parameter + width / 4, 0});
        }
        looks = std::move(halves);
    }
}

/// The same of a span, whose point is given by the parameter.
double parameter_on_span(const ProgrammedMotion& motion, const Vec3& tip, const Search& search) {
    return with_span(motion.segment.curve, [&](const auto& span) {
        const Search by_length{path::length_to(span, search.guess),
                               path::length_to(span, search.lower),
                               path::length_to(span, search.upper)};
        return path::parameter_at(span, parameter_by_halves(motion, tip, by_length));
    });
}

/// A point may be looked for so far before the one that was found last. Beside a cusp that may have
/// been on the other branch: of a curve as wide as the motion is long, the branches are within the
/// tolerance t of each other over ∛(t²·length).
double lower_bound_of(const ProgrammedMotion& motion, MotionParameter walk, double from) {
    double back = walk == MotionParameter::Turn ? 0 : 2 * motion.tolerance;
    if (walk == MotionParameter::Length &&
        !std::holds_alternative<path::Line>(motion.segment.curve))
        back += 2 * std::cbrt(motion.tolerance * motion.tolerance * motion.length);
    const double share = motion.length > 0 ? back / motion.length : 0;
    return std::max(0.0, from - share * end_parameter(motion, walk));
}

/// The end of a reach; of an arc, and where only the orientation changes, no point ends it.
double parameter_behind(const ProgrammedMotion& motion, MotionParameter walk,
                        const SearchRange& reach) {
    switch (walk) {
        case MotionParameter::Length:
        case MotionParameter::Touch: return reach.from + reach.ahead;
        case MotionParameter::Span:
            return with_span(motion.segment.curve, [&](const auto& span) {
                const double behind = path::length_to(span, reach.from) + reach.ahead;
                return path::parameter_at(span, behind);
            });
        default: return std::numeric_limits<double>::infinity();
    }
}

/// The nearest point between two turns, where a motion does not come back beside itself.
Nearness nearest_on_branch(const Chain& chain, const ProgrammedMotion& motion, MotionParameter walk,
                           const StandingTool& tool, Search branch) {
    const Nearness near =
        judged(chain, motion, walk, tool, parameter_on(chain, motion, walk, tool, branch));
    if (near.distance <= motion.tolerance) return near;
    branch.guess = nearest_look(chain, motion, walk, tool, branch);
    return judged(chain, motion, walk, tool, parameter_on(chain, motion, walk, tool, branch));
}

/// … on the first of the parts between turns on which the tip can be.
Nearness nearest_on_branches(const Chain& chain, const ProgrammedMotion& motion,
                             MotionParameter walk, const StandingTool& tool,
                             const SearchRange& reach) {
    const double upper =
        std::min(end_parameter(motion, walk), parameter_behind(motion, walk, reach));
    double begin = lower_bound_of(motion, walk, reach.from);
    Nearness best;
    best.distance = std::numeric_limits<double>::infinity();
    const auto look_up_to = [&](double end) {
        const Search branch{std::clamp(reach.from, begin, end), begin, end};
        const Nearness near = nearest_on_branch(chain, motion, walk, tool, branch);
        if (near.distance < best.distance) best = near;
        begin = end;
        return best.distance <= motion.tolerance;
    };
    for (const double turn : motion.turns) {
        if (turn <= reach.from) begin = std::max(begin, turn);
        else if (turn < upper && look_up_to(turn)) return best;
    }
    look_up_to(upper);
    return best;
}

}  // namespace

StandingTool standing_tool(const machine::Machine& machine, const Chain& chain,
                           const ProgrammedMotion& motion, const Setpoint& setpoint) {
    const Segment& segment = motion.segment;
    LogicalAxes axes;
    axes.fill(std::numeric_limits<double>::quiet_NaN());
    const Vec3 missing =
        (segment.virtual_axes.is_on() ? path::real_position(segment.virtual_axes, setpoint.tip)
                                      : setpoint.tip) +
        segment.carrier;
    for (std::size_t i = 0; i < 3; ++i) axes[i] = missing[static_cast<Eigen::Index>(i)];
    for (std::size_t i = 0; i < machine.axes.size(); ++i)
        axes[index(machine.axes[i].axis)] = setpoint.axis[i];
    StandingTool standing;
    std::copy(axes.begin() + 3, axes.end(), standing.followers.begin());
    const Vec3 carried = Vec3(axes[0], axes[1], axes[2]) - segment.carrier;
    if (segment.virtual_axes.is_on()) {
        const double angle =
            segment.virtual_axes.turns() ? axes[index(segment.virtual_axes.rotary)] : 0;
        standing.tip = path::virtual_position(segment.virtual_axes, carried, angle);
    } else if (segment.is_transformed()) {
        for (double& follower : standing.followers)
            if (std::isnan(follower)) follower = 0;
        machine::ChainPosition position{
            {axes[0], axes[1], axes[2]},
            {standing.followers[3], standing.followers[4], standing.followers[5]},
            joints_of(chain, standing.followers)};
        const machine::Pose pose = machine::forward(chain, position, -segment.carrier);
        standing.tip = pose.tip;
        standing.tool = pose.rotation * chain.tool_direction;
    } else {
        standing.tip = carried;
    }
    return standing;
}

Nearness nearest_on(const Chain& chain, const ProgrammedMotion& motion, const StandingTool& tool,
                    const SearchRange& reach) {
    const MotionParameter walk = walk_of(motion);
    if (!motion.turns.empty()) return nearest_on_branches(chain, motion, walk, tool, reach);
    const Search search{reach.from, lower_bound_of(motion, walk, reach.from),
                        end_parameter(motion, walk)};
    return judged(chain, motion, walk, tool, parameter_on(chain, motion, walk, tool, search));
}

Nearness nearest_from_behind(const Chain& chain, const ProgrammedMotion& motion,
                             const StandingTool& tool, const SearchRange& reach) {
    const MotionParameter walk = walk_of(motion);
    const double upper =
        std::min(end_parameter(motion, walk), parameter_behind(motion, walk, reach));
    const Search search{upper, lower_bound_of(motion, walk, reach.from), upper};
    return judged(chain, motion, walk, tool, parameter_on(chain, motion, walk, tool, search));
}

Nearness nearest_on_rest(const Chain& chain, const ProgrammedMotion& motion,
                         const StandingTool& tool, const SearchRange& reach) {
    const MotionParameter walk = walk_of(motion);
    const double lower = lower_bound_of(motion, walk, reach.from);
    const double upper =
        std::min(end_parameter(motion, walk), parameter_behind(motion, walk, reach));
    Search search{reach.from, lower, upper};
    search.guess = nearest_look(chain, motion, walk, tool, search);
    const double parameter = parameter_on(chain, motion, walk, tool, search);
    const Nearness near = judged(chain, motion, walk, tool, parameter);
    if (near.distance <= motion.tolerance) return near;
    if (walk != MotionParameter::Length && walk != MotionParameter::Span) return near;
    // Where the curve bends without limit, beside a cusp, steps by its slope do not arrive.
    const auto by_halves = walk == MotionParameter::Span ? parameter_on_span : parameter_by_halves;
    return judged(chain, motion, walk, tool, by_halves(motion, tool.tip, search));
}

double distance_to(const ProgrammedMotion& motion, double parameter) {
    const MotionParameter walk = walk_of(motion);
    if (walk == MotionParameter::Turn || walk == MotionParameter::Touch) return 0;
    if (walk != MotionParameter::Span) return length_at(motion, walk, parameter);
    return with_span(motion.segment.curve,
                     [parameter](const auto& span) { return path::length_to(span, parameter); });
}

void find_turns(ProgrammedMotion& motion) {
    const path::Curve& curve = motion.segment.curve;
    const auto of_span = [&](const auto& span) {
        const bool is_by_parameter = walk_of(motion) == MotionParameter::Span;
        for (const double u : span.slow)
            if (u < 1) motion.turns.push_back(is_by_parameter ? u : path::length_to(span, u));
    };
    if (const auto* cubic = std::get_if<path::CubicSpan>(&curve)) of_span(*cubic);
    if (const auto* quintic = std::get_if<path::QuinticSpan>(&curve)) of_span(*quintic);
    if (const auto* parametric = std::get_if<path::Parametric>(&curve)) {
        // What is behind a turn is a curve of its own, which may have others.
        path::Parametric rest = *parametric;
        double begin = 0;
        while (const auto u = path::slow_parameter(rest)) {
            begin += path::length_to(rest, *u);
            motion.turns.push_back(begin);
            rest = path::split(rest, *u).second;
        }
    }
}

Vec3 end_of(const Chain& chain, const ProgrammedMotion& motion) {
    if (!touches(motion)) return path::end(motion.segment.curve);
    return tip_on(chain, motion, walk_of(motion), motion.length);
}

}  // namespace kadr::motion
