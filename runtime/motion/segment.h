// segment.h — a piece of motion, planned: geometry, what follows it, and its profile in time.
#pragma once

#include <array>
#include <cstdint>

#include "base/axes.h"
#include "base/source.h"
#include "machine/chain.h"
#include "motion/profile.h"
#include "motion/spindle.h"
#include "path/contact.h"
#include "path/curve.h"
#include "path/orient_law.h"
#include "path/virtual_axes.h"

namespace kadr::motion {

enum class SegmentKind : std::uint8_t {
    Rapid,  // positioning
    Feed,   // cutting
    Dwell,  // the rest stand still for `duration`
    ToolChange,
    Orient,  // the spindle goes to an angle
    Hold,    // the operator keeps the axes from going on
    Wait,    // for the machine to acknowledge an M function, or for the spindle's mark
    // Of a module beside the axes, which stand at `stage` meanwhile:
    External,  // nothing moves, or the module is not asked
    Jump,      // a scanner's positioning
    Mark,      // a scanner's path with the beam
};

/// Of the axes.
constexpr bool is_motion(SegmentKind kind) { return kind <= SegmentKind::Feed; }
/// Of a module beside them.
constexpr bool is_external(SegmentKind kind) { return kind >= SegmentKind::External; }

/// Pulses of a beam during a piece, evenly in time.
struct PulseTrain {
    std::uint32_t count = 0;
    double first = 0;   // s from the start of the piece
    double period = 0;  // s
};

/// Of a machine without rotary axes that its file places.
inline const machine::Chain kNoChain{};

/// Axes beside X, Y, Z: A B C (rad) and U V W (mm), in this order.
inline constexpr std::size_t kFollowers = kAxes - 3;

/// One planned piece. A line or an arc draws itself from `curve`; `kind`, `line` and `source` tell
/// how to colour it and whence it came.
struct Segment {
    SegmentKind kind = SegmentKind::Rapid;
    bool ends_command = true;      // no further piece of its command comes
    bool has_pulse = false;        // a pulse of the laser burns the point where it ends
    bool is_rotary_only = false;   // no linear axis moves: lengths are degrees, not mm
    bool is_thread = false;        // the spindle leads: a thread, or a tap
    float thread_start = 0;        // of a thread: revolutions from the spindle's mark to its begin
    AxisMask followers = 0;        // axes beside X, Y, Z that move in this piece
    std::uint32_t line = 0;        // of the ISO-7bit text
    std::uint16_t cycle = 0;       // of the command
    std::int64_t tool_number = 0;  // that was called last; 0: none
    SourceId source;

    path::Curve curve;  // path of the tip, or of the contact; a Point if it stands
    path::Vec3 tool = path::Vec3::UnitZ();    // unit vector from tip to holder
    path::Vec3 carrier = path::Vec3::Zero();  // from the tip to what the linear axes carry, mm
    /// Of a piece on whose path the transformation of the machine holds the tip: `tool` is the tool
    /// at base position, the machine's chain tells where the axes stand (transformed.h), and
    /// follower_start is where the rotary ones begin.
    path::OrientLaw orientation;
    path::Contact contact;  // … and how the cutter touches on the path
    /// If they are on: `curve` is in them, and the tool stays as it is.
    path::VirtualAxes virtual_axes;

    double start_time = 0;  // s, from the start of the program
    double duration = 0;    // s
    double feed =
        0;  // mm/s (deg/s), what was asked for, override included; rapid: what the axes can
    double nominal_feed = 0;         // mm/s (deg/s), as programmed at an override of 100 %
    double feed_per_revolution = 0;  // mm (deg), override included; 0: the feed is no such one
    CommandedSpindle spindle;        // as it is commanded in this piece
    Profile profile;                 // of the path length; empty for a standstill

    path::Vec3 stage = path::Vec3::Zero();  // is_external: where the axes hold the tip
    PulseTrain train;                       // likewise

    std::array<double, kFollowers> follower_start{};  // rad or mm
    std::array<double, kFollowers> follower_rate{};   // per unit of path length

    /// Whether the transformation holds the tip on the path.
    bool is_transformed() const { return orientation.kind > path::OrientKind::Straight; }
    /// … or the axes go straight to where it holds the tip at the end: `curve` is as without a
    /// transformation, and the tip is somewhere else.
    bool goes_straight() const { return orientation.kind == path::OrientKind::Straight; }
    /// Whether tip and tool are those in the workpiece system.
    bool is_in_workpiece() const { return orientation.kind != path::OrientKind::None; }
    double end_time() const { return start_time + duration; }
};

/// The part of a motion between two lengths of its path.
Segment part_of(const Segment& whole, double from, double to);

}  // namespace kadr::motion
