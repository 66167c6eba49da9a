// following.h — where the rotary axes go while the tool changes its orientation as given.
//
// An orientation path is a direction of the tool at every point of a path; the axes follow it
// without a jump from where they stand. What it is (a cone, a surface) is path/orient_law.h's
// matter, which of several ends a block takes where only its end is given path_choice.h's.
#pragma once

#include <functional>
#include <vector>

#include "machine/path_choice.h"

namespace kadr::machine {

/// Nearer to the axis R1 the configuration of a tool has no meaning, rad.
inline constexpr double kPoleWidth = 1e-7;
/// Whether the tool stands along the axis R1, at either end of it.
bool is_at_pole(const Chain& chain, const Vec3& direction);

/// The solution for a direction that goes on from where the joints stand: in their configuration
/// and their turn; at the pole R1 stays, and from there either configuration may be gone on with.
///
/// near     rad; not farther than half a turn from what is looked for
/// returns  `near` itself if there is no solution
Vec3 joints_for(const Chain& chain, const Vec3& direction, const Vec3& near);

/// Direction of the tool at a fraction 0 … 1 of a path: unit vector, continuous.
using DirectionFunction = std::function<Vec3(double)>;

/// So far along a path the tool stands at the pole of R1.
struct PolePoint {
    double fraction = 0;
    Vec3 direction = Vec3::Zero();  // of the axis R1, towards the tool
};

/// Where the tool passes the axis R1 between its ends, in order. One that stays there from its
/// beginning on, or up to its end, does not pass.
///
/// tolerance  how far from the axis it may be to count as passing, rad
std::vector<PolePoint> pole_passages(const Chain& chain, const DirectionFunction& direction,
                                     double tolerance);

/// The joints at the end of an orientation path that begins at the pole and is left by the end
/// `to`: where R1 has to stand before.
Vec3 joints_before(const Chain& chain, const DirectionFunction& direction, const Vec3& to);

struct FollowQuery {
    Vec3 start = Vec3::Zero();  // R1, R2, Ψ where the path begins, rad
    JointLimits limits;
};

/// Where rotary axes end that follow an orientation path, and whether limits hold all along. Ψ
/// stays.
///
/// Where the tool begins at the pole, R1 turns there to the nearer one of the two positions from
/// which the path can be followed; where it passes one, R1 stands and the configuration changes,
/// unless limits behind it ask R1 to turn by half a turn there.
///
/// returns  as of choose_path() in vector mode; of an end that only one configuration leads to the
///          refusal stands under the start's
Result<PathEnd, PathRefusal> follow(const Chain& chain, const FollowQuery& query,
                                    const DirectionFunction& direction);

}  // namespace kadr::machine
