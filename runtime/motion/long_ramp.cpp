#include "motion/long_ramp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "motion/profile_cut.h"
#include "motion/smooth_profile.h"

namespace kadr::motion {

namespace {

// What is tried: how far, and with which parts between the least and the greatest limits of the
// stretches. A search for the best would cost far more than it saves.
constexpr std::array<std::size_t, 10> kReach = {1, 2, 3, 4, 6, 8, 11, 15, 19, kMostJoined};
constexpr std::array kSpeeds = {1.0, 0.7, 0.45, 0.28, 0.16, 0.08};
constexpr std::array kAccelerations = {0.0, 0.3, 0.6, 0.9};
constexpr std::array kJerks = {0.0, 0.4, 0.8};
// Below the greatest speed of a bent piece an axis has more left than there.
constexpr double kMore = 2;

// Longer ranges are held against their pieces too often.
constexpr std::size_t kMostPieces = 512;

// Less is not worth another profile, s.
constexpr double kLeastGain = 1e-6;
// Of a limit: rounding.
constexpr double kSlack = 1e-9;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double between(double least, double greatest, double part) {
    return least * std::pow(greatest / least, part);
}

/// Stretches that may go together, and what their limits range over.
struct StretchRange {
    std::size_t stretches = 0;
    std::size_t pieces = 0;
    double length = 0;
    double time = 0;  // by themselves
    double speed = 0;
    double least_acceleration = 0;
    double acceleration = 0;
    double least_jerk = 0;
    double jerk = 0;
    double exit = 0;

    void add(const PlannedStretch& next) {
        const Stretch& limits = next.limits;
        least_acceleration = stretches == 0 ? limits.acceleration
                                            : std::min(least_acceleration, limits.acceleration);
        least_jerk = stretches == 0 ? limits.jerk : std::min(least_jerk, limits.jerk);
        acceleration = std::max(acceleration, limits.acceleration);
        jerk = std::max(jerk, limits.jerk);
        speed = std::max(speed, limits.speed);
        length += limits.length;
        time += next.profile.duration();
        pieces += limits.pieces;
        exit = next.speeds.exit;
        ++stretches;
    }
};

/// Whether the path goes on in its direction where a piece begins.
bool goes_on(const Piece& piece) {
    return is_motion(piece.segment.kind) && !piece.is_cell && piece.ramp == 1 &&
           piece.ramp_before == 1 && std::isinf(piece.entry_acceleration);
}

/// Whether nothing of what a piece may do is kept for the corner before it.
bool is_free(const Piece& piece) { return piece.entry_limit == 0 || goes_on(piece); }

/// Whether its bend changes along it. Arcs and the curves around corners have closed forms, and
/// every limit already.
bool is_bent(const Piece& piece) {
    return path::bends_freely(piece.segment.curve) &&
           !std::holds_alternative<path::Glide>(piece.segment.curve);
}

/// Whether every axis keeps its limits on an inner piece.
///
/// share  of the jerk, that the changes of the bend at its ends leave
bool suits_axes(const Piece& piece, const Profile& part, double share, const AxisTable& axes) {
    const AxisTable::PathState state{part.peak_speed, path_acceleration(part), path_jerk(part)};
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const double most = axes.acceleration(i) * (1 + kSlack);
        if (piece.loads.at(i, state.speed, state.acceleration) > most) return false;
        if (piece.loads.jerk_at(i, state) > share * axes.jerk(i) * (1 + kSlack)) return false;
    }
    return true;
}

/// Whether a profile over the first pieces keeps all limits.
bool suits(const Profile& whole, const StretchRange& range, PieceRing& pieces,
           const AxisTable& axes) {
    ProfileCut cut(whole);
    for (std::size_t i = 0; i < range.pieces; ++i) {
        const Piece& piece = pieces.at(i);
        const bool is_last = i + 1 == range.pieces;
        const Profile part = cut.next(piece.length, is_last);
        if (part.peak_speed > piece.speed * (1 + kSlack)) return false;
        if (i > 0 && part.entry_speed > piece.entry_limit * (1 + kSlack)) return false;
        const Piece* behind_it = is_last && i + 1 < pieces.size() ? &pieces.at(i + 1) : nullptr;
        const bool is_behind_corner = i == 0 && !is_free(piece);
        const bool is_before_corner = behind_it && !is_free(*behind_it);
        if (is_behind_corner || is_before_corner) {
            double most = kInfinity;
            if (is_behind_corner) most = piece.smooth_corner_jerk;
            if (is_before_corner) most = std::min(most, behind_it->smooth_corner_jerk);
            if (path_jerk(part) > std::max(piece.jerk, most) * (1 + kSlack)) return false;
            // A corner that is not smooth was reckoned with all that its pieces have.
            if (most == 0) {
                if (path_acceleration(part) > piece.acceleration * (1 + kSlack)) return false;
                continue;
            }
        }
        const double behind = i + 1 < pieces.size() ? pieces.at(i + 1).jerk_before : 1;
        const double share = std::min(piece.jerk_share, behind);
        if (!suits_axes(piece, part, share, axes)) return false;
    }
    return true;
}

/// The range of the first stretches, as many as go on from one to the next.
std::vector<StretchRange> ranges_of(const std::deque<PlannedStretch>& planned, PieceRing& pieces) {
    std::vector<StretchRange> ranges;
    StretchRange range;
    bool bends = false;
    for (const PlannedStretch& next : planned) {
        if (std::isinf(next.limits.jerk)) return ranges;
        const std::size_t first = range.pieces;
        if (first + next.limits.pieces > kMostPieces) return ranges;
        for (std::size_t i = first; i < first + next.limits.pieces; ++i) {
            if (i > 0 && !goes_on(pieces.at(i))) return ranges;
            // Its axes have other limits than the machine's.
            if (pieces.at(i).has_dynamics) return ranges;
            bends = bends || is_bent(pieces.at(i));
        }
        range.add(next);
        const bool is_tried = std::ranges::find(kReach, range.stretches) != kReach.end();
        if (bends && is_tried) ranges.push_back(range);
    }
    return ranges;
}

}  // namespace

std::optional<LongRamp> long_ramp(const std::deque<PlannedStretch>& planned, PieceRing& pieces,
                                  const AxisTable& axes) {
    std::optional<LongRamp> best;
    double most = kLeastGain;
    const double entry = planned.front().speeds.entry;
    for (const StretchRange& range : ranges_of(planned, pieces)) {
        const double base = std::max(entry, range.exit);
        for (const double speed_part : kSpeeds) {
            const double speed = base + speed_part * (range.speed - base);
            // Even at this speed from end to end it would not save more.
            if (range.time - range.length / speed <= most) continue;
            for (const double part : kAccelerations) {
                const double a =
                    between(range.least_acceleration, kMore * range.acceleration, part);
                for (const double jerk_part : kJerks) {
                    const double j = between(range.least_jerk, kMore * range.jerk, jerk_part);
                    const auto profile =
                        seven_phases(range.length, entry, range.exit, {speed, a, a, j});
                    if (!profile) continue;
                    const double gain = range.time - profile->duration();
                    if (gain <= most || !suits(*profile, range, pieces, axes)) continue;
                    most = gain;
                    best = LongRamp{range.stretches, *profile};
                }
            }
        }
    }
    return best;
}

}  // namespace kadr::motion
