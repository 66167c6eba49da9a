// waiting_pieces.h — prepared pieces that wait until the corners near them are known.
//
// A corner takes of the acceleration and the jerk of both its pieces, and without a limit of the
// jerk of all pieces within a tick of it: only when these are known it is settled what a piece has.
#pragma once

#include <cstddef>

#include "motion/axis_table.h"
#include "motion/piece.h"

namespace kadr::motion {

/// They stand at the end of the ring of pieces: those that wait, and behind them fresh ones, whose
/// corners are not looked at yet.
class WaitingPieces {
  public:
    /// References outlive it.
    ///
    /// tick  of the machine, s
    WaitingPieces(PieceRing& pieces, const AxisTable& axes, double tick)
        : pieces_(pieces), axes_(axes), tick_(tick) {}

    bool is_empty() const { return waiting_ == 0; }
    bool has_fresh() const { return fresh_ > 0; }
    /// So many were appended to the ring.
    void add_fresh(std::size_t count) { fresh_ += count; }
    /// The oldest fresh piece waits now, and the corner before it acts on those that wait. Only if
    /// there is one.
    void take_fresh();
    /// Whether all corners that act on the oldest piece are known.
    bool is_oldest_settled() const { return waiting_ > 1 && is_out_of_reach(); }

    /// Parts of a piece that is settled, one or more, at their positions in the ring.
    struct Settled {
        std::size_t behind = 0;  // so many pieces are behind the last part
        std::size_t parts = 0;
        double exit_limit = 0;  // of the corner behind it
    };
    /// The oldest piece waits no longer; it has what the corners at both its ends leave of its
    /// acceleration and its jerk. The path ends behind a piece that nothing follows.
    Settled settle_oldest();

  private:
    void share_crowd();
    bool is_out_of_reach() const;
    Settled settle(std::size_t behind, const Piece& next);

    PieceRing& pieces_;
    const AxisTable& axes_;
    double tick_;
    std::size_t fresh_ = 0;
    std::size_t waiting_ = 0;
};

}  // namespace kadr::motion
