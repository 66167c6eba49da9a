#include "motion/segment.h"

#include <Eigen/Geometry>

namespace kadr::motion {

path::Vec3 direction_at(const Turn& turn, double distance) {
    const double angle = turn.rate * distance;
    if (angle == 0) return turn.direction;
    return Eigen::AngleAxisd(angle, turn.axis) * turn.direction;
}

Segment part_of(const Segment& whole, double from, double to) {
    Segment piece = whole;
    piece.curve = path::part(whole.curve, from, to);
    for (std::size_t k = 0; k < kFollowers; ++k) {
        piece.follower_start[k] += piece.follower_rate[k] * from;
    }
    if (whole.is_transformed()) {
        piece.turn.length = to - from;
        piece.turn.direction = direction_at(whole.turn, from);
        if (whole.turn.length > 0) {
            piece.turn.contact.guide = path::guide_at(whole.turn.contact, from / whole.turn.length);
            piece.turn.contact.turn *= (to - from) / whole.turn.length;
        }
    }
    return piece;
}

}  // namespace kadr::motion
