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
    if (whole.course.is_on())
        piece.course = course_of(path::feed_from(whole.course.feed, from), piece.length);
    return piece;
}

Piece part_between(const Piece& whole, double from, double to, const AxisTable& axes) {
    if (!whole.course.is_on()) return part_of(whole, from, to, axes);
    return part_of(whole, place_at(whole.course, from), place_at(whole.course, to), axes);
}

}  // namespace kadr::motion
