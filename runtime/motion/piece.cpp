#include "motion/piece.h"

namespace kadr::motion {

Piece part_of(const Piece& whole, double from, double to, const AxisTable& axes) {
    Piece piece = whole;
    piece.segment = part_of(whole.segment, from, to);
    piece.length = to - from;
    if (from > 0) {
        piece.entry_limit = whole.speed;
        piece.entry_acceleration = std::numeric_limits<double>::infinity();
        piece.smooth_corner_jerk = 0;
        piece.rates = axes.start_rates(piece.segment);
    }
    if (to < whole.length) {
        piece.segment.ends_command = false;
        piece.segment.has_pulse = false;
    }
    if (whole.varying_feed.is_on())
        piece.varying_feed =
            varying_feed_of(path::feed_from(whole.varying_feed.feed, from), piece.length);
    return piece;
}

Piece part_between(const Piece& whole, double from, double to, const AxisTable& axes) {
    if (!whole.varying_feed.is_on()) return part_of(whole, from, to, axes);
    return part_of(whole, distance_at(whole.varying_feed, from),
                   distance_at(whole.varying_feed, to), axes);
}

}  // namespace kadr::motion
