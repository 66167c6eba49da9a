// support.h — the oracles of kinematics, and the machines that they are about.
#pragma once

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/units.h"
#include "machine/kinematics.h"
#include "machine/path_choice.h"

namespace kadr::machine::test {

using nlohmann::json;

/// By value: a loop over a part of a temporary would outlive it.
inline json oracle(const std::string& name) {
    std::ifstream file(std::string(KADR_ROOT) + "/tests/oracles/" + name);
    return json::parse(file);
}

inline Vec3 vec(const json& list) {
    return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

inline Vec3 xyz(const json& point) {
    return {point["X"].get<double>(), point["Y"].get<double>(), point["Z"].get<double>()};
}

inline Mat3 matrix(const json& rows) {
    Mat3 result;
    for (int i = 0; i < 3; ++i) result.row(i) = vec(rows[static_cast<std::size_t>(i)]).transpose();
    return result;
}

inline double rad(const json& angle_deg) { return rad_from_deg(angle_deg.get<double>()); }
inline AxisRange limits(const json& pair_deg) { return {rad(pair_deg[0]), rad(pair_deg[1])}; }

/// The way from the end of the zero tool to the tip: tools of the oracles are (dx, dy, length).
inline Vec3 tip_of(const json& tool) {
    const Vec3 t = vec(tool);
    return {t.x(), t.y(), -t.z()};
}

/// A machine of kinematics.json, with or without an axis that turns the tool about itself.
inline Chain chain_of(const std::string& name, bool with_spin = false, bool with_second = true) {
    static const json machines = oracle("kinematics.json")["machines"];
    for (const json& machine : machines) {
        if (machine["name"] != name) continue;
        Chain chain;
        for (const std::size_t k : {kR1, kR2}) {
            const json& given = machine[k == kR1 ? "R1" : "R2"];
            RotaryJoint& joint = chain.joints[k];
            joint.is_present = k == kR1 || with_second;
            joint.axis = k == kR1 ? Axis::C : Axis::B;
            joint.direction = vec(given["axis"]);
            joint.side = given["side"] == "W" ? ChainSide::Table : ChainSide::Head;
            joint.sign = given["dir"].get<double>();
        }
        place_by_vectors(chain, {vec(machine["L1"]), vec(machine["L2"]), Vec3::Zero()});
        if (with_spin) {
            RotaryJoint& joint = chain.joints[kPsi];
            joint.is_present = true;
            joint.side = ChainSide::Head;
            joint.direction = Vec3::UnitZ();
        }
        chain.compensates_parallel = true;
        return prepare(chain).value();
    }
    ADD_FAILURE() << name << " is none of the machines";
    return {};
}

/// Every case of one kind (all cases without kinds: ""), and that there are as many as expected.
template <typename Check>
void for_each_case(const std::string& file, const std::string& kind, int expected, Check check) {
    const json data = oracle(file);
    int seen = 0;
    for (const json& item : data["cases"]) {
        if (!kind.empty() && item["kind"] != kind) continue;
        SCOPED_TRACE(item["id"].get<std::string>());
        ++seen;
        check(item["input"], item["expect"]);
    }
    EXPECT_EQ(seen, expected) << kind;
}

/// How far two angles are from each other, whole turns apart, rad.
inline double apart(double a, double b) {
    return std::abs(std::remainder(a - b, 2 * std::numbers::pi));
}

inline constexpr double kAngleTolerance = rad_from_deg(1e-5);

}  // namespace kadr::machine::test
