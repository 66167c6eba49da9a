#include "motion/waiting_pieces.h"

#include <algorithm>
#include <array>

namespace kadr::motion {

void WaitingPieces::take_fresh() {
    --fresh_;
    if (waiting_ > 0 && !axes_.limits_jerk()) share_crowd();
    ++waiting_;
}

/// Without a limit of the jerk the setpoints of a tick may see several corners with the ramps of
/// all pieces between them: within a tick of a crowded one the ramps have what it leaves.
void WaitingPieces::share_crowd() {
    Piece& newest = pieces_.back(fresh_);
    double time = 0;  // at least, from the newest corner back
    for (std::size_t k = 1; k <= waiting_ && time < tick_; ++k) {
        Piece& behind = pieces_.back(fresh_ + k - 1);
        behind.ramp_before = std::min(behind.ramp_before, newest.crowd_ramp);
        Piece& before = pieces_.back(fresh_ + k);
        time += before.length / before.speed;
        if (time < tick_) newest.ramp = std::min(newest.ramp, before.crowd_ramp);
    }
}

/// Whether no corner that is still to come lies within a tick of the oldest piece.
bool WaitingPieces::is_out_of_reach() const {
    if (axes_.limits_jerk()) return true;
    double time = 0;
    for (std::size_t k = 0; k + 1 < waiting_ && time < tick_; ++k) {
        const Piece& piece = pieces_.back(fresh_ + k);
        if (piece.entry_limit == 0) return true;  // it rests there
        time += piece.length / piece.speed;
    }
    return time >= tick_;
}

WaitingPieces::Settled WaitingPieces::settle_oldest() {
    --waiting_;
    const std::size_t behind = fresh_ + waiting_;
    return behind > 0 ? settle(behind, pieces_.back(behind - 1)) : settle(0, Piece{});
}

/// The piece that waited for `next`; so many pieces are `behind` it.
WaitingPieces::Settled WaitingPieces::settle(std::size_t behind, const Piece& next) {
    const double exit_limit = next.entry_limit;
    Piece& piece = pieces_.back(behind);
    piece.jerk *= std::min(1.0, next.jerk_before / piece.jerk_share);
    piece.acceleration =
        std::min(piece.acceleration, piece.turning_acceleration * next.jerk_before);
    piece.is_cell = piece.is_cell && piece.ramp == 1 && next.ramp_before == 1;
    const double head = piece.corner_zone;
    const double tail = next.corner_zone_before;
    const double all = piece.acceleration;
    if (head == 0) piece.acceleration = std::min(piece.acceleration, piece.ramp * all);
    if (tail == 0) piece.acceleration = std::min(piece.acceleration, next.ramp_before * all);
    if (head == 0 && tail == 0) return {behind, 1, exit_limit};

    // Beside a corner it has less on a short distance alone: that is a piece of its own.
    const Piece whole = piece;
    const std::array<double, 4> bounds{0, head, whole.length - tail, whole.length};
    const std::array<double, 3> most{piece.ramp * all, all, next.ramp_before * all};
    std::size_t parts = 0;
    for (std::size_t i = 0; i < most.size(); ++i) {
        if (bounds[i] == bounds[i + 1]) continue;
        Piece& part = parts == 0 ? pieces_.back(behind) : pieces_.insert_behind(behind);
        part = part_of(whole, bounds[i], bounds[i + 1], axes_);
        part.acceleration = std::min(whole.acceleration, most[i]);
        if (parts > 0) part.issues = 0;
        ++parts;
    }
    return {behind, parts, whole.speed};
}

}  // namespace kadr::motion
