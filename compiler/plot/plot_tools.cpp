#include "plot/plot_tools.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/units.h"
#include "motion/transformed.h"

namespace kadr::plot {

namespace {

// Kept at most: more than a drawing has room for.
constexpr std::size_t kMost = 40'000;
// From one kept tool to the next within a piece, at most; neither is seen to jump then.
constexpr double kTurn = rad_from_deg(3);
constexpr double kWay = 2;      // mm
constexpr double kParts = 100;  // of a piece, at most

/// By how much the orientation changes along a piece, rad; never less than it does.
double orientation_along(const motion::Segment& segment, double length) {
    if (segment.orientation.kind == path::OrientKind::Cone)
        return std::abs(segment.orientation.rate) * length;
    if (motion::gives_direction(segment.orientation))
        return std::numbers::pi;  // on a surface, or to a point
    double rate = 0;
    for (std::size_t i = 0; i < 3; ++i) rate += std::abs(segment.follower_rate[i]);
    return rate * length;
}

}  // namespace

void PlotTools::add(const machine::Chain& chain, const motion::Segment& segment) {
    if (!segment.is_in_workpiece() || segment.kind != motion::SegmentKind::Feed) return;
    const double length = path::length(segment.curve);
    const double travel = segment.is_rotary_only ? 0 : length;
    const double wanted =
        std::max({1.0, orientation_along(segment, length) / kTurn, travel / kWay});
    const auto parts = static_cast<int>(std::ceil(std::min(wanted, kParts)));
    for (int i = 0; i <= parts; ++i) {
        const double distance = length * i / parts;
        const motion::ToolPose placed =
            motion::pose_at(chain, segment, distance, path::position(segment.curve, distance));
        append({placed.tip, placed.tool});
    }
}

void PlotTools::append(const PlotTool& tool) {
    if (passed_++ % every_ != 0) return;
    if (tools_.size() == kMost) {
        for (std::size_t i = 0; 2 * i < tools_.size(); ++i) tools_[i] = tools_[2 * i];
        tools_.resize(tools_.size() / 2);
        every_ *= 2;
    }
    tools_.push_back(tool);
}

}  // namespace kadr::plot
