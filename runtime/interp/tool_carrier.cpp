#include "interp/tool_carrier.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "base/units.h"
#include "machine/kinematics.h"

namespace kadr::interp {

using path::Mat3;
using path::Vec3;
using std::numbers::pi;

namespace {

using Angles = std::array<double, 2>;

// Numbers of data; S 7.1.
constexpr std::array<std::size_t, 4> kWays = {1, 4, 15, 18};
constexpr std::array<std::size_t, 2> kDirections = {7, 10};
constexpr std::size_t kZeros = 24;
constexpr std::size_t kGridStarts = 26;
constexpr std::size_t kGrids = 28;
constexpr std::size_t kLeast = 30;
constexpr std::size_t kGreatest = 32;

/// Two directions that differ by less are one: components are written with some six digits.
constexpr double kSameAxisDirection = 1e-6;
/// Angles may lie so far outside of their limits, rad: the rounding of what was worked out.
constexpr double kRounding = 1e-9;

void put(CarrierData& data, std::size_t first, const Vec3& vector) {
    for (std::size_t i = 0; i < 3; ++i)
        data.values[first + i] = vector[static_cast<Eigen::Index>(i)] + 0.0;
}

Vec3 vector_at(const CarrierData& data, std::size_t first) {
    return {data.values[first], data.values[first + 1], data.values[first + 2]};
}

/// How an axis of the machine turns what it carries: a table goes against what its axis shows.
Vec3 turning(const machine::RotaryJoint& joint) {
    return joint.sign * (joint.side == machine::ChainSide::Head ? 1 : -1) * joint.direction;
}

/// The machine's chain as a carrier. Of a head or a table alone axis 1 carries axis 2; of both,
/// axis 1 is the head's. The vectors lead back to where they begin, so that with all axes at zero
/// nothing is added.
CarrierData carrier_of(const machine::Chain& chain) {
    using machine::kR1;
    using machine::kR2;
    CarrierData data;
    std::vector<const machine::RotaryJoint*> heads;
    std::vector<const machine::RotaryJoint*> tables;  // the outer one in front
    for (const std::size_t k : {kR1, kR2}) {
        const machine::RotaryJoint& joint = chain.joints[k];
        if (!joint.is_present) continue;
        if (joint.side == machine::ChainSide::Head) heads.push_back(&joint);
        else tables.insert(tables.begin(), &joint);
    }
    data.kind = tables.empty() ? "T" : heads.empty() ? "P" : "M";
    std::size_t axis = 0;
    for (const auto* side : {&heads, &tables}) {
        for (const machine::RotaryJoint* joint : *side) {
            put(data, kDirections[axis], turning(*joint));
            data.axes[axis++] = joint->axis;
        }
    }
    if (!heads.empty() && !tables.empty()) {
        put(data, kWays[0], -heads[0]->point);
        put(data, kWays[1], heads[0]->point);
        put(data, kWays[2], tables[0]->point);
        put(data, kWays[3], -tables[0]->point);
    } else if (!heads.empty()) {
        const Vec3 second = heads.size() > 1 ? heads[1]->point : Vec3::Zero();
        put(data, kWays[0], -heads[0]->point);
        put(data, kWays[1], heads[0]->point - second);
        put(data, kWays[2], second);
    } else {
        const Vec3 second = tables.size() > 1 ? tables[1]->point : Vec3::Zero();
        put(data, kWays[1], tables[0]->point);
        put(data, kWays[2], second - tables[0]->point);
        put(data, kWays[3], -second);
    }
    return data;
}

bool is_axis(const Vec3& direction) { return direction != Vec3::Zero(); }

/// The rotation about a direction that brings one vector to the other; both equally far from it.
double turn_between(const Vec3& direction, const Vec3& from, const Vec3& to) {
    const Vec3 a = from - direction.dot(from) * direction;
    const Vec3 b = to - direction.dot(to) * direction;
    return std::atan2(direction.dot(a.cross(b)), a.dot(b));
}

bool lies_along(const Vec3& direction, const Vec3& vector) {
    return direction.cross(vector).norm() < kSameAxisDirection;
}

/// A rotation of `to` about `outer` and of `from` about `inner`, so that both meet:
/// Rot(outer, first) · Rot(inner, second) · from = to.
struct TwoRotations {
    Vec3 outer;
    Vec3 inner;
    Vec3 from;
    Vec3 to;
    Angles near;  // what is free stays there
};

/// One of them where the other axis does not exist.
void solve_one(const TwoRotations& turns, std::size_t axis, std::vector<Angles>& out) {
    const Vec3& direction = axis == 0 ? turns.outer : turns.inner;
    if (std::abs(direction.dot(turns.from) - direction.dot(turns.to)) > kSameAxisDirection) return;
    Angles angles{};
    angles[axis] = lies_along(direction, turns.from)
                       ? turns.near[axis]
                       : turn_between(direction, turns.from, turns.to);
    out.push_back(angles);
}

/// Both by the vectors in which the cones about the axes meet (Paden–Kahan's second subproblem).
void solve_both(const TwoRotations& turns, std::vector<Angles>& out) {
    const double cosine = turns.outer.dot(turns.inner);
    const Vec3 across = turns.outer.cross(turns.inner);
    const double square = across.squaredNorm();
    if (square < kSameAxisDirection * kSameAxisDirection) {
        TwoRotations one = turns;  // about one line: the second axis stands
        one.from = machine::rotation_about(turns.inner, turns.near[1]) * turns.from;
        const std::size_t before = out.size();
        solve_one(one, 0, out);
        if (out.size() > before) out.back()[1] = turns.near[1];
        return;
    }
    const double along_inner = turns.inner.dot(turns.from);
    const double along_outer = turns.outer.dot(turns.to);
    const double a = (along_outer - cosine * along_inner) / square;
    const double b = (along_inner - cosine * along_outer) / square;
    const double rest = (1 - a * a - b * b - 2 * a * b * cosine) / square;
    if (rest < -kSameAxisDirection) return;
    const double beside = std::sqrt(std::max(0.0, rest));
    for (const double sign : {1.0, -1.0}) {
        if (sign < 0 && beside < kSameAxisDirection) break;
        const Vec3 meet = a * turns.outer + b * turns.inner + sign * beside * across;
        Angles angles;
        angles[1] = lies_along(turns.inner, turns.from)
                        ? turns.near[1]
                        : turn_between(turns.inner, turns.from, meet);
        angles[0] = lies_along(turns.outer, turns.to) ? turns.near[0]
                                                      : turn_between(turns.outer, meet, turns.to);
        out.push_back(angles);
    }
}

std::vector<Angles> solve(const TwoRotations& turns) {
    std::vector<Angles> out;
    const bool has_outer = is_axis(turns.outer);
    const bool has_inner = is_axis(turns.inner);
    if (has_outer && has_inner) {
        solve_both(turns, out);
    } else if (has_outer || has_inner) {
        solve_one(turns, has_outer ? 0 : 1, out);
    } else if ((turns.from - turns.to).norm() < kSameAxisDirection) {
        out.push_back({});
    }
    return out;
}

/// What the axes have to do, in the order of the carrier's axes: rotations, without their zeros.
std::vector<Angles> solve(const Carrier& carrier, const CarrierQuery& query) {
    const auto& [v1, v2] = carrier.directions;
    const Angles near = {query.near[0] - carrier.zeros[0], query.near[1] - carrier.zeros[1]};
    switch (carrier.kind) {
        case Carrier::Kind::Tool: return solve({v1, v2, query.tool, query.frame, near});
        case Carrier::Kind::Part: return solve({v1, v2, query.frame, query.tool, near});
        case Carrier::Kind::Mixed: break;
    }
    // The table goes the other way, about the axis that is the outer one then.
    std::vector<Angles> out = solve({v2, v1, query.tool, query.frame, {-near[1], near[0]}});
    for (Angles& angles : out) angles = {angles[1], -angles[0]};
    return out;
}

/// An angle by whole turns as near to another one as limits let it; nothing: it lies outside.
std::optional<double> within(double angle, double near, double least, double greatest) {
    const double turned = near + std::remainder(angle - near, 2 * pi);
    if (least == 0 && greatest == 0) return turned;
    const double low = std::ceil((least - kRounding - turned) / (2 * pi));
    const double high = std::floor((greatest + kRounding - turned) / (2 * pi));
    if (low > high) return std::nullopt;
    return turned + 2 * pi * std::clamp(0.0, low, high);
}

}  // namespace

ToolCarriers::ToolCarriers(const machine::Machine& machine) {
    if (machine.kinematics && machine.kinematics->chain.is_turning())
        carriers_[1] = carrier_of(machine.kinematics->chain);
}

const CarrierData* ToolCarriers::find(std::int64_t number) const {
    const auto found = carriers_.find(number);
    return found == carriers_.end() ? nullptr : &found->second;
}

Mat3 Carrier::turn(std::size_t axis) const {
    if (!is_axis(directions[axis])) return Mat3::Identity();
    return machine::rotation_about(directions[axis], angles[axis] - zeros[axis]);
}

Mat3 Carrier::head() const {
    switch (kind) {
        case Kind::Tool: return turn(0) * turn(1);
        case Kind::Part: return Mat3::Identity();
        case Kind::Mixed: break;
    }
    return turn(0);
}

Mat3 Carrier::table() const {
    switch (kind) {
        case Kind::Tool: return Mat3::Identity();
        case Kind::Part: return turn(0) * turn(1);
        case Kind::Mixed: break;
    }
    return turn(1);
}

Vec3 Carrier::length(const Vec3& lengths) const {
    switch (kind) {
        case Kind::Tool:
            return offsets[0] + turn(0) * (offsets[1] + turn(1) * (offsets[2] + lengths));
        case Kind::Part: return lengths;
        case Kind::Mixed: break;
    }
    return offsets[0] + turn(0) * (offsets[1] + lengths);
}

Vec3 Carrier::table_shift() const {
    switch (kind) {
        case Kind::Tool: return Vec3::Zero();
        case Kind::Part: {
            const Vec3 inner = offsets[2] + turn(1) * offsets[3];
            return turn(0) * inner - (offsets[2] + offsets[3]);
        }
        case Kind::Mixed: break;
    }
    return turn(1) * offsets[3] - offsets[3];
}

std::optional<Carrier> carrier_of(const CarrierData& data) {
    Carrier carrier;
    if (data.kind == "T" || data.kind == "t") carrier.kind = Carrier::Kind::Tool;
    else if (data.kind == "P" || data.kind == "p") carrier.kind = Carrier::Kind::Part;
    else if (data.kind == "M" || data.kind == "m") carrier.kind = Carrier::Kind::Mixed;
    else return std::nullopt;
    for (std::size_t i = 0; i < 4; ++i) carrier.offsets[i] = vector_at(data, kWays[i]);
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec3 direction = vector_at(data, kDirections[i]);
        if (is_axis(direction)) carrier.directions[i] = direction.normalized();
        else carrier.directions[i] = Vec3::Zero();
        carrier.zeros[i] = rad_from_deg(data.values[kZeros + i]);
    }
    return carrier;
}

Result<Carrier, CarrierFault> laid_along(Carrier carrier, const CarrierData& data,
                                         const CarrierQuery& query) {
    const std::vector<Angles> found = solve(carrier, query);
    if (found.empty()) return CarrierFault::Unreachable;
    double least = std::numeric_limits<double>::infinity();
    for (const Angles& turns : found) {
        Angles angles{};
        double distance = 0;
        bool fits = true;
        for (std::size_t i = 0; i < 2; ++i) {
            const std::optional<double> angle = within(turns[i] + carrier.zeros[i], query.near[i],
                                                       rad_from_deg(data.values[kLeast + i]),
                                                       rad_from_deg(data.values[kGreatest + i]));
            fits &= angle.has_value();
            if (!fits) break;
            angles[i] = *angle;
            distance += std::abs(angles[i] - query.near[i]);
        }
        if (!fits || distance >= least) continue;
        least = distance;
        carrier.angles = angles;
    }
    if (!std::isfinite(least)) return CarrierFault::Limits;
    carrier.solutions = static_cast<int>(found.size());
    for (std::size_t i = 0; i < 2; ++i) {
        const double step = rad_from_deg(data.values[kGrids + i]);
        if (step == 0) continue;
        const double start = rad_from_deg(data.values[kGridStarts + i]);
        const double exact = carrier.angles[i];
        carrier.angles[i] = start + step * std::round((exact - start) / step);
        carrier.left_over[i] = exact - carrier.angles[i];
    }
    return carrier;
}

}  // namespace kadr::interp
