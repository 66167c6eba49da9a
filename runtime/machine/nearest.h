// nearest.h — rotary positions that go on from where the joints stand.
#pragma once

#include "machine/kinematics.h"

namespace kadr::machine {

/// Nearer to the axis R1 the configuration of a tool says nothing, rad.
inline constexpr double kPoleWidth = 1e-7;
/// Whether the tool stands along the axis R1, at either end of it.
bool is_at_pole(const Chain& chain, const Vec3& direction);

/// The solution for a direction that goes on from where the joints stand: in their configuration
/// and their turn; at the pole R1 stays.
///
/// near     rad; not farther than half a turn from what is looked for
/// returns  `near` itself if there is no solution
Vec3 joints_for(const Chain& chain, const Vec3& direction, const Vec3& near);

}  // namespace kadr::machine
