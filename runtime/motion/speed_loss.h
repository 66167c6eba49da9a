// speed_loss.h — why a piece of path takes longer than its feed would, and what that costs.
//
// A piece at its programmed feed from end to end costs nothing. What it takes longer has reasons:
// a limit that holds all along the piece, and ramps. A ramp costs time because the path is slow at
// one of its ends, which may lie many blocks away: the reason is what makes it slow there.
#pragma once

#include <cstdint>
#include <string_view>

#include "base/source.h"

namespace kadr::motion {

enum class LossReason : std::uint8_t {
    MachineFeed,   // the machine's greatest feed, along the whole piece
    AxisVelocity,  // the velocity of an axis, likewise
    Curvature,     // the acceleration that an axis needs to follow the bent path
    CurveJerk,     // … and the jerk
    Corner,        // ramps beside a corner
    Stop,          // ramps from and to rest: what the axes accelerate
    SlowerPiece,   // ramps beside a piece that goes slower
    Jerk,          // what a limited jerk adds to ramps
    PulseWindow,   // a piece waits for the pulse of a laser
};
inline constexpr std::size_t kLossReasons = 9;

/// As a technologist reads it: "corner".
std::string_view reason_name(LossReason reason);

/// A part of what a piece takes longer than at its programmed feed. The reason of a ramp down is
/// known when the path is slow again: then the losses before it are reported, in their order.
struct SpeedLoss {
    LossReason reason = LossReason::Stop;
    std::uint32_t line = 0;  // of the ISO-7bit text
    SourceId source;
    double time = 0;  // s, > 0
    double at = 0;    // s, when the piece begins
};

}  // namespace kadr::motion
