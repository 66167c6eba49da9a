// axis_shares.h — which parts of what an axis has go into following a bent path.
//
// What turning the path may take is fixed, so that enough is left to reach the speed at all.
#pragma once

namespace kadr::motion {

// sqrt(1 − 1/4): the usual split of LinuxCNC; 87 % of the acceleration turn the path, half of it
// remains along the path.
inline constexpr double kNormalShare = 0.86602540378443865;

// Of an axis' jerk: what turning at constant speed may take, and what speeding up while turning
// may. On an arc the two are across each other, so the path keeps sqrt(1 − 0.6²) − 0.4 = 0.4; on a
// spline they may add up, and it keeps 0.3.
inline constexpr double kSteadyJerk = 0.4;
inline constexpr double kTurningJerk = 0.6;
inline constexpr double kTurningJerkOfSpline = 0.3;
// On the curve around a corner the speed is to stay as it is: the corner is turned with nearly all
// that the axes have, and little is left to speed up meanwhile.
inline constexpr double kSteadyJerkOfGlide = 0.7;
inline constexpr double kTurningJerkOfGlide = 0.1;

}  // namespace kadr::motion
