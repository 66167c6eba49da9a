#include "motion/run_record.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "motion/corner.h"
#include "motion/profile.h"

namespace kadr::motion {

namespace {

constexpr double kStraight = 1e-9;  // as in corner.cpp

/// The greatest acceleration along the path within a tick of an end of a profile, where it is this.
double acceleration_near(const Profile& profile, double at_end, double tick) {
    const double most = path_acceleration(profile);
    if (!profile.is_smooth || profile.has_varying_feed()) return most;
    return std::min(most, std::abs(at_end) + path_jerk(profile) * tick);
}

}  // namespace

void RunRecord::add(const Piece& piece) {
    const Segment& segment = piece.segment;
    add_time(segment);
    if (!is_motion(segment.kind)) return;
    ++totals_.segments;
    const double length = path::arc_length(segment.curve);
    totals_.length += length;
    if (segment.kind == SegmentKind::Feed) totals_.cutting_length += length;
    AxisTable::Peaks peaks = axes_.peaks(segment, piece.loads);
    if (piece.is_cell) axes_.measure_cell(segment, piece.cell, peaks);
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        totals_.max_velocity[i] = std::max(totals_.max_velocity[i], peaks.velocity[i]);
        totals_.max_acceleration[i] = std::max(totals_.max_acceleration[i], peaks.acceleration[i]);
        totals_.max_jerk[i] = std::max(totals_.max_jerk[i], peaks.jerk[i]);
    }
    add_corner(piece);
}

void RunRecord::add_time(const Segment& segment) {
    totals_.time += segment.duration;
    switch (segment.kind) {
        case SegmentKind::Rapid: totals_.rapid_time += segment.duration; break;
        case SegmentKind::Feed: totals_.cutting_time += segment.duration; break;
        case SegmentKind::Dwell:
        case SegmentKind::Orient: totals_.dwell_time += segment.duration; break;
        case SegmentKind::ToolChange: totals_.tool_change_time += segment.duration; break;
        case SegmentKind::Hold: totals_.hold_time += segment.duration; break;
        case SegmentKind::Wait: totals_.wait_time += segment.duration; break;
        case SegmentKind::External:
        case SegmentKind::Jump:
        case SegmentKind::Mark: totals_.external_time += segment.duration; break;
    }
}

void RunRecord::add_hold(double duration) {
    totals_.time += duration;
    totals_.hold_time += duration;
}

/// What setpoints show at a corner: the jump of the velocity and the ramps beside it.
void RunRecord::add_corner(const Piece& piece) {
    const Segment& segment = piece.segment;
    const double speed = segment.profile.entry_speed;
    const double along = path_acceleration(segment.profile);
    const bool is_straight =
        std::holds_alternative<path::Line>(segment.curve) && !segment.is_transformed();
    const double near =
        acceleration_near(segment.profile, segment.profile.entry_acceleration, tick_);
    if (axes_.limits_jerk()) add_jerk(piece, along);
    if (speed > 0) {
        for (std::size_t i = 0; i < axes_.size(); ++i) {
            const double change = std::abs(piece.rates[i] - last_.rates[i]);
            if (change < kStraight) continue;
            const double jump = change * speed / tick_;
            const double reached = corner_acceleration(last_.loads.at(i, speed, last_.near),
                                                       piece.loads.at(i, speed, near), jump);
            totals_.max_acceleration[i] = std::max(totals_.max_acceleration[i], reached);
        }
    }
    last_.rates = is_straight ? piece.rates : axes_.end_rates(segment);
    last_.loads = piece.loads;
    last_.along = along;
    const double end = state_at(segment.profile, segment.profile.duration()).acceleration;
    last_.near = acceleration_near(segment.profile, end, tick_);
}

/// The same of the jerk.
void RunRecord::add_jerk(const Piece& piece, double along) {
    const Segment& segment = piece.segment;
    const double speed = segment.profile.entry_speed;
    const double jerk = path_jerk(segment.profile);
    const bool is_straight =
        std::holds_alternative<path::Line>(segment.curve) && !segment.is_transformed();
    const AxisRates bends = is_straight ? AxisRates{} : axes_.start_bends(segment);
    for (std::size_t i = 0; speed > 0 && i < axes_.size(); ++i) {
        const double jump = std::abs(piece.rates[i] - last_.rates[i]) * speed / tick_;
        const double bend = std::abs(bends[i] - last_.bends[i]) * speed * speed;
        if (jump == 0 && bend == 0) continue;
        const double beside = std::max(last_.loads.jerk_at(i, {speed, last_.along, last_.jerk}),
                                       piece.loads.jerk_at(i, {speed, along, jerk}));
        totals_.max_jerk[i] =
            std::max(totals_.max_jerk[i], (jump + kJumpBell * bend) / tick_ + beside);
    }
    last_.bends = is_straight ? AxisRates{} : axes_.end_bends(segment);
    last_.jerk = jerk;
}

void RunRecord::set_travel(const AxisTable::Travel& travel) {
    totals_.travel_min = travel.lower;
    totals_.travel_max = travel.upper;
}

}  // namespace kadr::motion
