#include "motion/segment.h"

namespace kadr::motion {

Segment part_of(const Segment& whole, double from, double to) {
    Segment piece = whole;
    piece.curve = path::part(whole.curve, from, to);
    for (std::size_t k = 0; k < kFollowers; ++k) {
        piece.follower_start[k] += piece.follower_rate[k] * from;
    }
    if (whole.is_transformed()) piece.orientation = path::part_of(whole.orientation, from, to);
    if (whole.orientation.length > 0) {
        piece.contact.guide = path::guide_at(whole.contact, from / whole.orientation.length);
        piece.contact.turn *= (to - from) / whole.orientation.length;
    }
    return piece;
}

}  // namespace kadr::motion
