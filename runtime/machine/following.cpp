#include "machine/following.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

namespace kadr::machine {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kTurn = 2 * kPi;

constexpr auto at(std::size_t joint) { return static_cast<Eigen::Index>(joint); }

/// A limit may be missed by the rounding of a solution, rad.
constexpr double kLimitSlack = 1e-9;
/// Between two points that are looked at no joint turns farther, rad: beyond a limit between them
/// it would be by less than the resolution of a rotary axis.
constexpr double kMostTurn = 2 * kPi / 180;
/// A path is looked at in so many steps at least, …
constexpr int kSteps = 64;
/// … and in steps no finer than this part of it: there a pole is passed or an axis swings round.
constexpr double kFinest = 1e-9;
/// How finely the nearest point to a pole is looked for, in parts of the path.
constexpr double kSamePlace = 1e-15;
/// At the pole the solutions of both configurations are half a turn of R1 apart: one that is nearer
/// than this is the nearer one, rad².
constexpr double kSurelyNearest = 1;
/// Leaving a pole, R1 is where it stands so far behind it at least, in parts of the path.
constexpr double kBehindPole = 1e-7;

/// The value that differs by whole turns and is nearest.
double nearest_turn(double angle, double near) {
    return angle + kTurn * std::round((near - angle) / kTurn);
}

Vec3 nearest_turns(const Vec3& rotary, const Vec3& near) {
    Vec3 turned;
    for (Eigen::Index i = 0; i < 3; ++i) turned[i] = nearest_turn(rotary[i], near[i]);
    return turned;
}

/// The angle to the nearer end of the axis R1, rad.
double pole_distance(const Chain& chain, const Vec3& direction) {
    const double tilt = pole_angle_of(chain, direction);
    return std::min(tilt, kPi - tilt);
}

/// The point of the least distance to the pole between two others, by the golden section: the
/// distance is a V where the pole is passed, which keeps all digits.
double nearest_to_pole(const Chain& chain, const DirectionFunction& direction, double from,
                       double to) {
    constexpr double kGolden = 0.61803398874989485;
    const auto distance = [&](double f) { return pole_distance(chain, direction(f)); };
    double left = to - kGolden * (to - from);
    double right = from + kGolden * (to - from);
    double at_left = distance(left);
    double at_right = distance(right);
    while (to - from > kSamePlace) {
        if (at_left < at_right) {
            to = right;
            right = left;
            at_right = at_left;
            left = to - kGolden * (to - from);
            if (left >= right) break;
            at_left = distance(left);
        } else {
            from = left;
            left = right;
            at_left = at_right;
            right = from + kGolden * (to - from);
            if (right <= left) break;
            at_right = distance(right);
        }
    }
    return (from + to) / 2;
}

/// How far behind a pole, or behind the beginning, R1 has a meaning again: part of the path.
double distance_behind(const Chain& chain, const DirectionFunction& direction, double fraction) {
    double behind = kBehindPole;
    while (2 * behind < 1 - fraction && is_at_pole(chain, direction(fraction + behind)))
        behind *= 2;
    return behind;
}

/// A joint at a pole by two points behind it, the farther one twice as far. Where the axes are not
/// square to each other, as those of a nutating head, R1 turns while the tool leaves the pole; what
/// it does up to the nearer point would be seen as a jump.
double led_back(double nearer, double farther) {
    return 2 * nearer - nearest_turn(farther, nearer);
}

struct Refused {
    CandidateFault fault;
    std::size_t joint;
    double value;
};

/// One way of following an orientation path, which is refused or comes to an end.
class FollowingWalk {
  public:
    FollowingWalk(const Chain& chain, const FollowQuery& query,
                  const DirectionFunction& direction_along)
        : chain_(chain), query_(query), direction_(direction_along) {}

    /// From a point of the path with given joints to another one.
    std::optional<Refused> go(double from, double to, Vec3& joints) const {
        double step = (to - from) / kSteps;
        for (double f = from; f < to;) {
            const double next = to - f < step * (1 + kFinest) ? to : f + step;
            const Vec3 direction = direction_(next);
            const Vec3 there = joints_for(chain_, direction, joints);
            const double turn = (there - joints).head<2>().cwiseAbs().maxCoeff();
            if (turn > kMostTurn && next - f > kFinest) {
                step = (next - f) / 2;
                continue;
            }
            if ((tool_vector(chain_, there) - direction).norm() > kPoleWidth)
                return Refused{CandidateFault::NoSolution, kR2, joints[kR2]};
            if (const auto refused = check(there)) return refused;
            joints = there;
            f = next;
            step = std::min(2 * step, (to - from) / kSteps);
        }
        return std::nullopt;
    }

    std::optional<Refused> check(const Vec3& joints) const {
        for (const std::size_t k : {kR1, kR2}) {
            const AxisRange& limits = query_.limits[k];
            const double value = joints[at(k)];
            const bool is_within =
                value >= limits.lower - kLimitSlack && value <= limits.upper + kLimitSlack;
            if (chain_.has(k) && !is_within) return Refused{CandidateFault::LimitOnPath, k, value};
        }
        return std::nullopt;
    }

    /// R1 where the path leaves a pole, in both configurations, nearest to where it stands.
    std::vector<Vec3> departures(double fraction, const Vec3& joints) const {
        std::vector<Vec3> found;
        const double behind = distance_behind(chain_, direction_, fraction);
        const auto solutions = solve(chain_, direction_(fraction + behind));
        if (!solutions) return found;
        const Vec3 farther = direction_(std::min(fraction + 2 * behind, 1.0));
        const bool is_led_back = fraction + 2 * behind <= 1;
        for (const Solution& solution : *solutions) {
            Vec3 start = joints;
            if (!solution.is_pole) {
                double r1 = solution.rotary[kR1];
                if (is_led_back)
                    r1 = led_back(r1, joints_for(chain_, farther, solution.rotary)[kR1]);
                start[kR1] = nearest_turn(r1, joints[kR1]);
            }
            for (const double turn : {0.0, kTurn, -kTurn}) {
                const Vec3 turned = start + turn * Vec3::UnitX();
                if (check(turned)) continue;
                found.push_back(turned);
                break;
            }
        }
        std::ranges::sort(found, {},
                          [&](const Vec3& start) { return std::abs(start[kR1] - joints[kR1]); });
        return found;
    }

  private:
    const Chain& chain_;
    const FollowQuery& query_;
    const DirectionFunction& direction_;
};

PathRefusal refusal_of(const Chain& chain, const FollowQuery& query, const Refused& refused) {
    PathRefusal refusal;
    if (refused.fault == CandidateFault::NoSolution) {
        refusal.fault = PathChoiceFault::Unreachable;
        return refusal;
    }
    const int configuration = configuration_of(chain, query.start);
    refusal.configurations[static_cast<std::size_t>(configuration - 1)] = {
        refused.fault, refused.joint, refused.value, query.limits[refused.joint]};
    return refusal;
}

}  // namespace

bool is_at_pole(const Chain& chain, const Vec3& direction) {
    // Asked at every tick: so near to the pole the sine is the angle.
    const Vec3 across = chain.joints[kR1].direction.cross(direction);
    return chain.orients() && across.squaredNorm() < kPoleWidth * kPoleWidth;
}

Vec3 joints_for(const Chain& chain, const Vec3& direction, const Vec3& near) {
    const auto solutions = solve(chain, direction);
    if (!solutions) return near;
    const int configuration = configuration_of(chain, near);
    for (const Solution& found : *solutions) {
        if (found.configuration != configuration || found.is_pole) continue;
        Vec3 turned = nearest_turns(found.rotary, near);
        turned[2] = near[2];
        if ((turned - near).squaredNorm() < kSurelyNearest) return turned;
    }
    const bool from_pole = is_at_pole(chain, tool_vector(chain, near));
    Vec3 best = near;
    double least = std::numeric_limits<double>::infinity();
    for (const Solution& found : *solutions) {
        const bool is_other = solutions->count > 1 && found.configuration != configuration;
        if (is_other && !from_pole && !found.is_pole) continue;
        const Vec3 rotary = found.is_pole ? at_pole(chain, found, near[0]).rotary : found.rotary;
        const Vec3 turned = nearest_turns(rotary, near);
        const double distance = (turned - near).head<2>().squaredNorm();
        if (distance >= least) continue;
        least = distance;
        best = turned;
    }
    best[2] = near[2];
    return best;
}

std::vector<PolePoint> pole_passages(const Chain& chain, const DirectionFunction& direction_along,
                                     double tolerance) {
    std::vector<PolePoint> passages;
    if (!chain.orients()) return passages;
    const Vec3& first = chain.joints[kR1].direction;
    std::array<Vec3, kSteps + 1> directions;
    std::array<double, kSteps + 1> distances{};
    for (std::size_t i = 0; i <= kSteps; ++i) {
        directions[i] = direction_along(static_cast<double>(i) / kSteps);
        distances[i] = pole_distance(chain, directions[i]);
    }
    for (std::size_t i = 1; i < kSteps; ++i) {
        const bool is_least = distances[i] <= distances[i - 1] && distances[i] < distances[i + 1];
        // What comes to the pole between its neighbours is no farther from it than from them.
        const double travel = (directions[i + 1] - directions[i - 1]).norm();
        if (!is_least || distances[i] > travel + tolerance) continue;
        const double fraction =
            nearest_to_pole(chain, direction_along, static_cast<double>(i - 1) / kSteps,
                            static_cast<double>(i + 1) / kSteps);
        const Vec3 direction = direction_along(fraction);
        if (pole_distance(chain, direction) > tolerance) continue;
        if (std::min(fraction, 1 - fraction) < kBehindPole) continue;
        passages.push_back({fraction, direction.dot(first) > 0 ? first : Vec3(-first)});
    }
    return passages;
}

Vec3 joints_before(const Chain& chain, const DirectionFunction& direction, const Vec3& to) {
    Vec3 joints = to;
    for (int i = kSteps - 1; i > 0; --i)
        joints = joints_for(chain, direction(static_cast<double>(i) / kSteps), joints);
    if (!is_at_pole(chain, direction(0))) return joints_for(chain, direction(0), joints);
    // The last step ends beside the pole, where R1 still has its meaning.
    const double behind = distance_behind(chain, direction, 0);
    const Vec3 farther = joints_for(chain, direction(std::min(2 * behind, 1.0)), joints);
    Vec3 nearer = joints_for(chain, direction(behind), farther);
    for (const std::size_t k : {kR1, kR2}) {
        if (2 * behind <= 1) nearer[at(k)] = led_back(nearer[at(k)], farther[at(k)]);
    }
    return nearer;
}

Result<PathEnd, PathRefusal> follow(const Chain& chain, const FollowQuery& query,
                                    const DirectionFunction& direction) {
    const FollowingWalk walk(chain, query, direction);
    const std::vector<PolePoint> passages = pole_passages(chain, direction, kPoleWidth);
    std::vector<Vec3> starts = {query.start};
    const bool starts_at_pole =
        is_at_pole(chain, direction(0)) && !is_at_pole(chain, direction(0.5));
    if (starts_at_pole) starts = walk.departures(0, query.start);
    std::optional<Refused> first_refusal;
    const auto refuse = [&](const Refused& refused) {
        if (!first_refusal) first_refusal = refused;
    };
    if (starts.empty()) refuse({CandidateFault::FirstOutside, kR1, query.start[kR1]});
    for (const Vec3& start : starts) {
        Vec3 joints = start;
        double from = 0;
        std::optional<Refused> refused;
        Vec3 at_last_pole = joints;
        for (const PolePoint& passage : passages) {
            if ((refused = walk.go(from, passage.fraction, joints))) break;
            from = passage.fraction;
            at_last_pole = joints;
        }
        const bool has_passed = !refused && !passages.empty();
        if (!refused) refused = walk.go(from, 1, joints);
        for (const double half : {kPi, -kPi}) {
            if (!refused || !has_passed) break;
            refuse(*refused);
            joints = at_last_pole + half * Vec3::UnitX();
            refused = walk.go(from, 1, joints);
        }
        if (refused) {
            refuse(*refused);
            continue;
        }
        PathEnd end;
        end.rotary = joints;
        end.configuration = configuration_of(chain, joints);
        end.mode = PathMode::Vector;
        end.passes_pole = !passages.empty();
        end.switches_at_pole = end.configuration != configuration_of(chain, query.start);
        end.sum_squares = (joints - query.start).squaredNorm();
        return end;
    }
    return refusal_of(chain, query, *first_refusal);
}

}  // namespace kadr::machine
