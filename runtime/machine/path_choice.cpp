#include "machine/path_choice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "machine/following.h"

namespace kadr::machine {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kPi = std::numbers::pi;

/// A limit may be missed by the rounding of a solution, rad.
constexpr double kLimitSlack = 1e-9;
/// R1 stands if it would turn by less, rad: vectors in programs have six digits and more.
constexpr double kUnchanged = 1e-7;
/// Travels that differ by less are equal, rad and rad².
constexpr double kEqualTravel = 1e-9;
/// Distance of the points at which a great circle is held against the limits, rad. Between them an
/// axis leaves the parabola through three of them by less than the resolution of a rotary axis.
constexpr double kWayStep = 2 * kPi / 180;

constexpr auto at(std::size_t joint) { return static_cast<Eigen::Index>(joint); }

bool is_within(double value, const AxisRange& limits) {
    return value >= limits.lower - kLimitSlack && value <= limits.upper + kLimitSlack;
}

/// A position, whole turns apart: next to a start on either side of it, within limits.
struct Neighbours {
    std::optional<double> below;  // ≤ start
    std::optional<double> above;  // > start
};

/// The least value ≥ bound that is whole turns from `angle`.
double first_from(double angle, double bound) {
    return angle + kTurn * std::ceil((bound - angle) / kTurn - kLimitSlack);
}
double last_up_to(double angle, double bound) {
    return angle + kTurn * std::floor((bound - angle) / kTurn + kLimitSlack);
}

Neighbours neighbours(double angle, double start, const AxisRange& limits) {
    Neighbours found;
    const double below = last_up_to(angle, std::min(start, limits.upper));
    if (is_within(below, limits)) found.below = below;
    double above = first_from(angle, std::max(start, limits.lower));
    if (above <= below + kEqualTravel) above += kTurn;
    if (is_within(above, limits)) found.above = above;
    return found;
}

/// The one next to the start, whatever the limits; half a turn either way: the positive one.
double nearest_turn(double angle, double start) {
    const double travel = std::remainder(angle - start, kTurn);
    return start + (travel <= -kPi + kEqualTravel ? travel + kTurn : travel);
}

/// The nearest admissible one.
std::optional<double> nearest(double angle, double start, const AxisRange& limits) {
    const Neighbours found = neighbours(angle, start, limits);
    if (!found.below) return found.above;
    if (!found.above) return found.below;
    return *found.above - start <= start - *found.below + kEqualTravel ? found.above : found.below;
}

struct Candidate {
    Vec3 rotary;
    int configuration;
    bool is_long;
    bool switches_at_pole;
};

/// At most two travels of R1 in each of both configurations.
struct Candidates {
    std::array<Candidate, 4> all;
    std::size_t count = 0;
    void add(const Candidate& candidate) { all[count++] = candidate; }
};

/// What the five steps need to know of the block.
class PathChooser {
  public:
    PathChooser(const Chain& chain, const PathQuery& query) : chain_(chain), query_(query) {
        end_direction_ = query.rotation * chain.tool_direction;
    }

    Result<PathEnd, PathRefusal> decide() {
        const auto solutions =
            chain_.has(kPsi) ? solve(chain_, query_.rotation) : solve(chain_, end_direction_);
        if (!solutions) return PathRefusal{PathChoiceFault::Unreachable, solutions.error(), {}};
        look_at_path(*solutions);
        PathMode mode = query_.mode;
        collect(*solutions, mode);
        if (found_.count == 0 && mode == PathMode::Vector && query_.rule == PathRule::LongAlways) {
            const PathRefusal in_vector_mode = refusal_;
            mode = PathMode::Axis;
            collect(*solutions, mode);
            if (found_.count == 0) refusal_ = in_vector_mode;
        }
        if (found_.count == 0) return refusal_;
        PathEnd end = best(mode);
        if (can_unwind(mode) && is_wound(end.rotary[kR1])) end = unwound(mode);
        end.passes_pole = mode == PathMode::Vector && passes_pole_;
        return end;
    }

  private:
    /// Where the tool stands at the pole and is to follow a great circle, R1 turns to the direction
    /// of its path at standstill, and any turn will do.
    bool can_unwind(PathMode mode) const {
        return mode == PathMode::Vector && chain_.orients() && starts_at_pole_ && !ends_at_pole_;
    }

    /// From the middle of what R1 may.
    double off_middle(double first) const {
        const AxisRange& limits = query_.limits[kR1];
        return std::abs(first - (limits.lower + limits.upper) / 2);
    }
    /// Whether another turn of R1 is nearer to the middle. Without limits none is.
    bool is_wound(double first) const {
        const AxisRange& limits = query_.limits[kR1];
        if (std::isinf(limits.lower) || std::isinf(limits.upper)) return false;
        return off_middle(first) > kPi + kEqualTravel;
    }

    /// The end from which R1 can go on farthest to either side.
    PathEnd unwound(PathMode mode) const {
        const Candidate* best = &found_.all[0];
        for (std::size_t i = 1; i < found_.count; ++i) {
            const Candidate& other = found_.all[i];
            if (off_middle(other.rotary[kR1]) < off_middle(best->rotary[kR1])) best = &other;
        }
        return end_of(*best, mode, PathReason::OnlyOne);
    }

    bool spins() const { return chain_.has(kPsi) && query_.fixes_spin; }

    /// Whether R1 may turn, or the configuration change, on the great circle.
    void look_at_path(const Solutions& solutions) {
        if (!chain_.orients()) return;
        start_configuration_ = configuration_of(chain_, query_.start);
        const Vec3 from = tool_vector(chain_, query_.start);
        starts_at_pole_ = chain_.joints[kR1].direction.cross(from).norm() < kUnchanged;
        ends_at_pole_ = solutions[0].is_pole;
        if (starts_at_pole_ || ends_at_pole_ || query_.mode == PathMode::Axis) return;
        const PoleApproach approach = pole_approach(chain_, from, end_direction_);
        // Exactly through the pole R1 need not turn there, unless axes out of square leave a gap.
        const bool is_exact =
            approach.distance < kPoleWidth && !crosses_gap(chain_, from, end_direction_);
        const bool is_near = approach.distance < query_.pole_tolerance || is_exact;
        const double angle =
            std::atan2(from.cross(end_direction_).norm(), from.dot(end_direction_));
        const double margin = std::min(approach.fraction, 1 - approach.fraction) * angle;
        begins_or_ends_near_ = is_near && margin < kUnchanged;
        passes_pole_ = is_near && !begins_or_ends_near_;
        crosses_gap_ = crosses_gap(chain_, from, end_direction_);
    }

    void collect(const Solutions& solutions, PathMode mode) {
        passes_pole_ = passes_pole_ && mode == PathMode::Vector;
        gather(solutions, mode);
        if (!begins_or_ends_near_ || mode == PathMode::Axis) return;
        // Beside the pole R1 may have to swing round. Rather it turns there by less than a quarter,
        // into the other configuration if need be.
        const bool swings =
            found_.count == 0 || std::abs(found_.all[0].rotary[kR1] - query_.start[kR1]) > kPi / 2;
        if (!swings) return;
        passes_pole_ = true;
        gather(solutions, mode);
    }

    void gather(const Solutions& solutions, PathMode mode) {
        refusal_ = PathRefusal{};
        found_.count = 0;
        for (const Solution& solution : solutions) {
            // At the pole R1 stays where it is.
            const Solution wanted = at_pole(chain_, solution, query_.start[kR1]);
            const bool is_other =
                query_.configuration != 0 && wanted.configuration != query_.configuration;
            if (is_other && !wanted.is_pole && !wanted.is_equator) {
                refusal_.configurations[static_cast<std::size_t>(wanted.configuration - 1)] =
                    outside(CandidateFault::OtherConfiguration, kR2, wanted.rotary[kR2]);
                continue;
            }
            if (auto refused = consider(wanted, mode))
                refusal_.configurations[static_cast<std::size_t>(wanted.configuration - 1)] =
                    *refused;
        }
    }

    CandidateRefusal outside(CandidateFault fault, std::size_t joint, double angle) const {
        return {fault, joint, nearest_turn(angle, query_.start[at(joint)]), query_.limits[joint]};
    }

    /// Adds the admissible travels into a configuration (steps 1 and 2), or tells why none is.
    std::optional<CandidateRefusal> consider(const Solution& wanted, PathMode mode) {
        Vec3 end = wanted.rotary;
        if (const auto refused = place(end, kR2, CandidateFault::SecondOutside)) return refused;
        if (const auto refused = place(end, kPsi, CandidateFault::SpinOutside)) return refused;
        if (!chain_.has(kR1)) {
            end[kR1] = query_.start[kR1];
            found_.add({end, wanted.configuration, false, false});
            return std::nullopt;
        }
        const bool follows = mode == PathMode::Vector && chain_.orients();
        if (follows && !starts_at_pole_ && !ends_at_pole_ && !passes_pole_)
            return follow(end, wanted);
        if (follows && passes_pole_) {
            if (const auto refused = check_pole(wanted.configuration)) return refused;
        }
        return travels_of_first(end, wanted.configuration, follows);
    }

    /// R2 and Ψ go to the admissible turn next to their start.
    std::optional<CandidateRefusal> place(Vec3& end, std::size_t joint,
                                          CandidateFault fault) const {
        double& value = end[at(joint)];
        const double start = query_.start[at(joint)];
        if (!chain_.has(joint) || (joint == kPsi && !query_.fixes_spin)) {
            value = start;
            return std::nullopt;
        }
        const auto turn = nearest(value, start, query_.limits[joint]);
        if (!turn) return outside(fault, joint, value);
        value = *turn;
        return std::nullopt;
    }

    /// The great circle leads to one end only: the one reached without a jump.
    std::optional<CandidateRefusal> follow(Vec3 end, const Solution& wanted) {
        const int configuration = wanted.configuration;
        // Where the configurations meet, both lead to it.
        if (configuration != start_configuration_ && !wanted.is_equator)
            return outside(CandidateFault::OtherConfiguration, kR2, end[kR2]);
        if (crosses_gap_) return outside(CandidateFault::NoSolution, kR2, end[kR2]);
        const double second = nearest_turn(end[kR2], query_.start[kR2]);
        if (std::abs(second - end[kR2]) > kEqualTravel)
            return outside(CandidateFault::SecondOutside, kR2, second);
        end[kR1] = query_.start[kR1] + first_along_great_circle(chain_, query_.start, end);
        if (!is_within(end[kR1], query_.limits[kR1])) {
            const auto other = nearest(end[kR1], query_.start[kR1], query_.limits[kR1]);
            return CandidateRefusal{
                other ? CandidateFault::OnlyLongTravel : CandidateFault::FirstOutside, kR1,
                end[kR1], query_.limits[kR1]};
        }
        if (const auto refused = check_travel(end)) return refused;
        found_.add({end, configuration, false, false});
        return std::nullopt;
    }

    /// R2 comes to the middle between both configurations where the path passes the pole.
    std::optional<CandidateRefusal> check_pole(int configuration) const {
        if (configuration != start_configuration_) return std::nullopt;  // it only passes
        const double middle = chain_.joints[kR2].sign * chain_.tilt.nearest;
        // Both poles of R1 are half a turn of R2 apart; the path passes the nearer one.
        const double half = nearest_turn(middle, query_.start[kR2]);
        const double other = nearest_turn(middle + kPi, query_.start[kR2]);
        const double value =
            std::abs(half - query_.start[kR2]) <= std::abs(other - query_.start[kR2]) ? half
                                                                                      : other;
        if (is_within(value, query_.limits[kR2])) return std::nullopt;
        return CandidateRefusal{CandidateFault::LimitOnPath, kR2, value, query_.limits[kR2]};
    }

    /// Both ends may be within the limits and the travel between them not.
    std::optional<CandidateRefusal> check_travel(const Vec3& end) const {
        const Vec3 from = tool_vector(chain_, query_.start);
        const double angle =
            std::atan2(from.cross(end_direction_).norm(), from.dot(end_direction_));
        const int steps = static_cast<int>(std::ceil(angle / kWayStep));
        for (int i = 1; i < steps; ++i) {
            const double f = static_cast<double>(i) / steps;
            const Vec3 direction =
                (std::sin((1 - f) * angle) * from + std::sin(f * angle) * end_direction_) /
                std::sin(angle);
            const auto solutions = solve(chain_, direction);
            if (!solutions)
                return CandidateRefusal{CandidateFault::LimitOnPath, kR2, end[kR2],
                                        query_.limits[kR2]};
            for (const Solution& solution : *solutions) {
                if (solution.configuration != start_configuration_ || solution.is_pole) continue;
                Vec3 rotary = solution.rotary;
                rotary[kR2] = nearest_turn(rotary[kR2], query_.start[kR2]);
                rotary[kR1] =
                    query_.start[kR1] + first_along_great_circle(chain_, query_.start, rotary);
                for (const std::size_t k : {kR1, kR2}) {
                    if (!is_within(rotary[at(k)], query_.limits[k]))
                        return CandidateRefusal{CandidateFault::LimitOnPath, k, rotary[at(k)],
                                                query_.limits[k]};
                }
            }
        }
        return std::nullopt;
    }

    /// R1 on either side of its start; the long travel only where the rule admits it.
    std::optional<CandidateRefusal> travels_of_first(Vec3 end, int configuration, bool follows) {
        const double start = query_.start[kR1];
        const double target = end[kR1];
        const Neighbours travels = neighbours(target, start, query_.limits[kR1]);
        if (!travels.below && !travels.above)
            return outside(CandidateFault::FirstOutside, kR1, target);
        const double shortest = std::abs(std::remainder(target - start, kTurn));
        const bool unwinds = follows && starts_at_pole_ && !ends_at_pole_;
        const bool admits_long = unwinds || (query_.rule != PathRule::Shortest && !follows);
        bool was_added = false;
        for (const auto& travel : {travels.above, travels.below}) {
            if (!travel) continue;
            const double change = std::abs(*travel - start);
            const bool is_long = change > shortest + kEqualTravel;
            if (is_long && !admits_long) continue;
            end[kR1] = *travel;
            const bool stands = change < kUnchanged || (passes_pole_ && follows && !is_long);
            found_.add({end, configuration, is_long,
                        chain_.orients() && configuration != start_configuration_ && stands});
            was_added = true;
        }
        if (was_added) return std::nullopt;
        return outside(CandidateFault::OnlyLongTravel, kR1, target);
    }

    /// Steps 4 and 5, or the rule of another control.
    PathEnd best(PathMode mode) const {
        const bool has_steps = query_.rule == PathRule::Shortest ||
                               query_.rule == PathRule::LongInAxisMode ||
                               query_.rule == PathRule::LongAlways;
        if (has_steps) {
            for (std::size_t i = 0; i < found_.count; ++i) {
                if (found_.all[i].switches_at_pole)
                    return end_of(found_.all[i], mode, PathReason::PoleSwitch);
            }
        }
        const Candidate* best = &found_.all[0];
        PathReason reason = PathReason::OnlyOne;
        for (std::size_t i = 1; i < found_.count; ++i) {
            const Candidate* other = &found_.all[i];
            const auto [is_better, why] = compared(*other, *best);
            if (is_better) best = other;
            // The last criterion that was needed tells most.
            reason = std::max(reason, why);
        }
        return end_of(*best, mode, reason);
    }

    struct Verdict {
        bool is_better;
        PathReason why;
    };

    Vec3 travels_of(const Candidate& candidate) const {
        Vec3 travels = Vec3::Zero();
        for (std::size_t k = 0; k < kJoints; ++k) {
            if (chain_.has(k))
                travels[at(k)] = std::abs(candidate.rotary[at(k)] - query_.start[at(k)]);
        }
        return travels;
    }

    /// Whether `a` goes before `b`.
    Verdict compared(const Candidate& a, const Candidate& b) const {
        const Vec3 travels_a = travels_of(a);
        const Vec3 travels_b = travels_of(b);
        const auto less = [](double x, double y) { return x < y - kEqualTravel; };
        const auto differ = [](double x, double y) { return std::abs(x - y) > kEqualTravel; };
        if (query_.rule == PathRule::LeastTravel || query_.rule == PathRule::MasterFirst) {
            const auto first = at(leading_joint());
            const auto second = first == at(kR1) ? at(kR2) : at(kR1);
            if (differ(travels_a[first], travels_b[first]))
                return {less(travels_a[first], travels_b[first]), PathReason::LeastFirst};
            if (differ(travels_a[second], travels_b[second]))
                return {less(travels_a[second], travels_b[second]), PathReason::LeastSecond};
        } else if (differ(travels_a.squaredNorm(), travels_b.squaredNorm())) {
            return {less(travels_a.squaredNorm(), travels_b.squaredNorm()),
                    PathReason::LeastSquares};
        }
        return {wins_tie(a, b), PathReason::Tie};
    }

    bool wins_tie(const Candidate& a, const Candidate& b) const {
        if (query_.rule == PathRule::MasterFirst) {
            const double off_a = a.rotary.head<2>().squaredNorm();
            const double off_b = b.rotary.head<2>().squaredNorm();
            if (std::abs(off_a - off_b) > kEqualTravel) return off_a < off_b;
        }
        if (a.configuration != b.configuration) return a.configuration == start_configuration_;
        return a.rotary[kR1] > b.rotary[kR1];
    }

    /// FANUC's master is nearest to the machine's base: R2 of two tables, else R1 (motion.md 7.2;
    /// of a table and a head the table). SINUMERIK looks at R1.
    std::size_t leading_joint() const {
        const bool two_tables = chain_.has(kR2) && chain_.joints[kR2].side == ChainSide::Table;
        return query_.rule == PathRule::MasterFirst && two_tables ? kR2 : kR1;
    }

    PathEnd end_of(const Candidate& candidate, PathMode mode, PathReason reason) const {
        PathEnd end;
        end.rotary = candidate.rotary;
        end.configuration = candidate.configuration;
        end.mode = mode;
        end.is_long = candidate.is_long;
        end.switches_at_pole = candidate.switches_at_pole;
        end.sum_squares = travels_of(candidate).squaredNorm();
        end.reason = reason;
        return end;
    }

    const Chain& chain_;
    const PathQuery& query_;
    Vec3 end_direction_;
    int start_configuration_ = 1;
    bool starts_at_pole_ = false;
    bool ends_at_pole_ = false;
    bool passes_pole_ = false;
    bool begins_or_ends_near_ = false;  // to the pole, and does not pass it in between
    bool crosses_gap_ = false;          // the great circle, what the axes cannot reach
    Candidates found_;
    PathRefusal refusal_;
};

}  // namespace

PathQuery query_for(const Chain& chain, const Vec3& direction) {
    PathQuery query;
    query.rotation =
        Eigen::Quaterniond::FromTwoVectors(chain.tool_direction, direction).toRotationMatrix();
    query.fixes_spin = false;
    return query;
}

Result<PathEnd, PathRefusal> choose_path(const Chain& chain, const PathQuery& query) {
    return PathChooser(chain, query).decide();
}

bool crosses_gap(const Chain& chain, const Vec3& from, const Vec3& to) {
    if (!chain.orients()) return false;
    const PoleAngleReach reach = pole_angle_reach(chain);
    const Vec3& n1 = chain.joints[kR1].direction;
    auto [least, most] = std::minmax({pole_angle_of(chain, from), pole_angle_of(chain, to)});
    const Vec3 across = from.cross(to);
    const double sine = across.norm();
    if (sine > kPoleAngle) {
        const double angle = std::atan2(sine, from.dot(to));
        const Vec3 ahead = (across / sine).cross(from);
        const double nearest = std::atan2(n1.dot(ahead), n1.dot(from));
        for (const double t : {nearest, nearest + kPi, nearest - kPi}) {
            if (t <= 0 || t >= angle) continue;
            const double tilt = pole_angle_of(chain, std::cos(t) * from + std::sin(t) * ahead);
            least = std::min(least, tilt);
            most = std::max(most, tilt);
        }
    }
    return least < reach.lower - kUnchanged || most > reach.upper + kUnchanged;
}

PoleApproach pole_approach(const Chain& chain, const Vec3& from, const Vec3& to) {
    const Vec3& n1 = chain.joints[kR1].direction;
    const Vec3 across = from.cross(to);
    const double sine = across.norm();
    const double angle = std::atan2(sine, from.dot(to));
    const auto distance_of = [&](const Vec3& w) {
        return std::atan2(n1.cross(w).norm(), std::abs(n1.dot(w)));
    };
    PoleApproach nearest = {distance_of(from), 0};
    if (const double end = distance_of(to); end < nearest.distance) nearest = {end, 1};
    if (sine < kPoleAngle) return nearest;
    // On the circle from·cos t + ahead·sin t the product with n1 is greatest at this t, and least
    // half a turn from it.
    const Vec3 ahead = (across / sine).cross(from);
    const double greatest = std::atan2(n1.dot(ahead), n1.dot(from));
    for (const double t : {greatest, greatest + kPi, greatest - kPi}) {
        if (t <= 0 || t >= angle) continue;
        const double distance = distance_of(std::cos(t) * from + std::sin(t) * ahead);
        if (distance < nearest.distance) nearest = {distance, t / angle};
    }
    return nearest;
}

}  // namespace kadr::machine
