// same_paths.h — where tip and tool are at the ticks of a run, and whether two runs go the same
// ways.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "tests/driver/scratch.h"

namespace kadr::test {

struct Way {
    Eigen::Vector3d tip;   // mm, in the workpiece
    Eigen::Vector3d tool;  // unit vector from the tip to the holder
    int line = 0;          // of the ISO-7bit text
};

/// Of the setpoints in a CSV.
inline std::vector<Way> sample_distances_of(const std::string& csv) {
    std::vector<Way> found;
    for (const Row& row : rows_of(csv))
        found.push_back({{row.at("tip_x"), row.at("tip_y"), row.at("tip_z")},
                         {row.at("tool_i"), row.at("tool_j"), row.at("tool_k")},
                         static_cast<int>(row.at("iso"))});
    return found;
}

/// How far a pose is from the way between two ticks: mm, and as a difference of unit vectors.
inline std::array<double, 2> beside(const Way& pose, const Way& from, const Way& to) {
    constexpr double kTurnWeight = 1e4;  // mm²: a turn counts as much as a way of 100 mm
    const Eigen::Vector3d way = to.tip - from.tip;
    const Eigen::Vector3d turn = to.tool - from.tool;
    const double size = way.squaredNorm() + kTurnWeight * turn.squaredNorm();
    const double dot =
        (pose.tip - from.tip).dot(way) + kTurnWeight * (pose.tool - from.tool).dot(turn);
    const double share = size == 0 ? 0 : std::clamp(dot / size, 0.0, 1.0);
    return {(from.tip + share * way - pose.tip).norm(),
            ((from.tool + share * turn).normalized() - pose.tool).norm()};
}

/// Every tick of one run lies on the way of the other, to a micrometre and a millionth; where the
/// text of the other begins with motions of its own, from a tick on.
inline void expect_same_paths(const std::vector<Way>& ticks, const std::vector<Way>& reference) {
    std::size_t at = 0;
    for (const Way& pose : ticks) {
        bool is_on = false;
        for (std::size_t i = at; i + 1 < reference.size() && !is_on; ++i) {
            const auto [tip, tool] = beside(pose, reference[i], reference[i + 1]);
            is_on = tip < 1e-3 && tool < 1e-6;
            if (is_on) at = i;
        }
        ASSERT_TRUE(is_on) << "line " << pose.line << ": " << pose.tip.transpose() << " | "
                           << pose.tool.transpose();
    }
}

}  // namespace kadr::test
