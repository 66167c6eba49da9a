// running_stretch.h — the stretch whose pieces are being delivered, and the profile over it.
//
// Which profile that is, and where the stretch ends, the planner decides; here each piece gets its
// part of it.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>

#include "motion/lookahead.h"
#include "motion/piece.h"
#include "motion/profile.h"
#include "motion/profile_cut.h"
#include "motion/stretch.h"

namespace kadr::motion {

/// Path speeds in the unit of a stretch; at most its own, but for rounding.
JunctionSpeeds own_speeds(const Stretch& stretch, const JunctionSpeeds& speeds);

struct RunningStretch {
    Stretch limits;
    JunctionSpeeds speeds;         // along the path, at its ends
    std::size_t left = 0;          // so many of its pieces are not delivered yet
    ProfileCut cut;                // of its profile, if its jerk is limited
    std::optional<Profile> given;  // its profile, if its jerk is not limited and it is not the
                                   // one that its speeds and limits make
    bool rest_follows = false;     // its own rest is the oldest stretch of the look-ahead

    bool has_limited_jerk() const { return std::isfinite(limits.jerk); }
    /// The profile of its next piece, a motion.
    ///
    /// is_last  of the stretch
    /// tick     of the machine, s
    void plan(Piece& piece, bool is_last, double tick);

  private:
    void plan_varying_feed(Piece& piece, bool is_last);
};

}  // namespace kadr::motion
