#include "motion/running_stretch.h"

#include <algorithm>

#include "base/assert.h"
#include "motion/varying_feed.h"

namespace kadr::motion {

JunctionSpeeds own_speeds(const Stretch& stretch, const JunctionSpeeds& speeds) {
    if (!stretch.has_varying_feed()) return speeds;
    return {std::min(stretch.speed, speeds.entry / stretch.entry_feed),
            std::min(stretch.speed, speeds.exit / stretch.exit_feed)};
}

void RunningStretch::plan(Piece& piece, bool is_last, double tick) {
    Segment& segment = piece.segment;
    if (piece.is_cell) {
        segment.profile = profile_over(piece.cell, speeds.entry, speeds.exit);
    } else if (given) {
        segment.profile =
            piece.varying_feed.is_on() ? over_varying_feed(*given, piece.varying_feed) : *given;
    } else if (piece.varying_feed.is_on()) {
        plan_varying_feed(piece, is_last);
    } else if (std::isinf(limits.jerk)) {
        auto profile = trapezoid(piece.length, speeds.entry, speeds.exit,
                                 {piece.speed, piece.acceleration, piece.acceleration});
        KADR_ASSERT(profile.has_value(),
                    "the look-ahead promised a change of speed that does not fit");
        segment.profile = *profile;
        // What setpoints show of an acceleration that begins at once.
        if (piece.is_geared) segment.profile.jerk = piece.acceleration / tick;
    } else {
        segment.profile = cut.next(piece.length, is_last);
    }
}

/// Over the time of its feed, as others over their length.
void RunningStretch::plan_varying_feed(Piece& piece, bool is_last) {
    const VaryingFeed& varying_feed = piece.varying_feed;
    if (has_limited_jerk()) {
        piece.segment.profile =
            over_varying_feed(cut.next(varying_feed.time, is_last), varying_feed);
        return;
    }
    const double most = rate_limits(varying_feed, piece.acceleration, piece.jerk).acceleration;
    const auto rate =
        trapezoid(varying_feed.time, std::min(1.0, speeds.entry / varying_feed.entry()),
                  std::min(1.0, speeds.exit / varying_feed.exit()), {1, most, most});
    KADR_ASSERT(rate.has_value(), "the look-ahead promised a change of speed that does not fit");
    piece.segment.profile = over_varying_feed(*rate, varying_feed);
}

}  // namespace kadr::motion
