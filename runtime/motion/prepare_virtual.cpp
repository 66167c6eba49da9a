// Motions in polar, cylindrical and inclined-axis coordinates: the tip goes along
// its path there, and the real axes are where path/virtual_axes.h has them.
//
// Near the centre of polar coordinates the rotary axis turns fast: pieces become as short as one
// speed suits them. In the centre itself the tool stands while the axis turns to where the path
// leads away.
#include <algorithm>
#include <cmath>

#include "motion/prepare_state.h"
#include "motion/transformed.h"
#include "path/polar_passages.h"

namespace kadr::motion {

namespace {

// By less the rotary axis need not turn in the centre, rad: rounding of directions.
constexpr double kSameAngle = 1e-8;

}  // namespace

void Preparer::State::emit_virtual(const path::Command& command, const Segment& whole,
                                   AxesPosition::MotionEnd& target) {
    const path::VirtualAxes& virtual_axes = whole.virtual_axes;
    const std::size_t rotary = index(virtual_axes.rotary) - 3;
    std::array<double, kFollowers> followers = whole.follower_start;
    for (const path::Curve& curve : path::legs_between_poles(virtual_axes, whole.curve)) {
        if (has_ended) return;
        Segment leg = whole;
        leg.curve = curve;
        leg.orientation.length = std::holds_alternative<path::Point>(curve)
                                     ? whole.orientation.length
                                     : path::length(curve);
        leg.follower_start = followers;
        if (virtual_axes.turns()) {
            const double away =
                path::rotary_to_leave(virtual_axes, curve, followers[rotary]) - followers[rotary];
            if (std::abs(away) > kSameAngle) {
                turn_alone(command, leg, virtual_axes.rotary, away);
                leg.follower_start[rotary] += away;
            }
        }
        if (has_ended) return;
        const std::optional<LogicalAxes> end = emit_path(command, leg, whole.orientation.length);
        if (!end) return;
        std::copy(end->begin() + 3, end->end(), followers.begin());
    }
    if (has_ended) return;
    target.followers = followers;
    end_command();
}

}  // namespace kadr::motion
