// command.h — what the interpreter tells the motion side.
//
// Resolved: frames, units, plane, modal state and offsets are worked in; nobody behind this point
// knows a G-code. Positions are of the tool tip in the base coordinate system, mm and degrees; X of
// a lathe is a radius.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "base/axes.h"
#include "base/source.h"
#include "path/contact.h"
#include "path/dynamics.h"
#include "path/orient_kind.h"
#include "path/parametric.h"
#include "path/spline.h"
#include "path/virtual_axes.h"

namespace kadr::path {

enum class Op : std::uint8_t {
    Rapid,
    Line,
    Arc,
    Spline,
    Involute,
    Parametric,  // a curve of a registered kind
    Thread,      // a line geared to the spindle
    Probe,       // a line that ends where the probe triggers
    Dwell,
    Spindle,       // the master spindle, which paths follow
    OtherSpindle,  // one that they do not
    SpeedLimit,
    Tool,
    ToolLength,
    Coolant,
    Function,  // an M function that takes the machine time
    Stop,
    OptionalStop,
    Message,
    End,
    ScannerOn,   // motions from here on are the scanner's; the axes stand
    ScannerOff,  // … and the axes' again
    External,    // the axes stand while a module beside them works for `time`
};

/// Whether the tool moves along a path.
constexpr bool is_motion(Op op) { return op <= Op::Probe; }
constexpr bool is_straight(Op op) { return op == Op::Line || op == Op::Rapid; }

enum class FeedMode : std::uint8_t { PerMinute, PerRevolution, InverseTime };
enum class Plane : std::uint8_t { Xy, Zx, Yz };
enum class SpindleMode : std::uint8_t { Stop, Cw, Ccw, Orient };
enum class CoolantMode : std::uint8_t { Off, Flood, Mist };
/// What becomes of an M function where its command stands.
enum class FunctionStep : std::uint8_t {
    Issue,  // the motion goes on
    Await,  // of what was issued before: the motion waits for the acknowledgement
    Both,
};

/// How the corner behind a motion is rounded, if the next motion lets it.
enum class BlendKind : std::uint8_t {
    None,
    Distance,   // from `size` before the corner to as far behind it, at most
    Tolerance,  // leaving the programmed path by `size` at most
};
struct Blending {
    BlendKind kind = BlendKind::None;
    bool with_tangents = false;  // also where only the curvature jumps
    double size = 0;             // mm
    /// So far the tool's direction may leave the programmed one meanwhile, rad.
    double orientation = std::numeric_limits<double>::infinity();
    /// Where the tip is not led around the corner, the tool is: the tip stays on its path.
    bool smooths_orientation = false;

    friend bool operator==(const Blending&, const Blending&) = default;
};

struct Command {
    Op op = Op::Rapid;
    FeedMode feed_mode = FeedMode::PerMinute;
    Plane plane = Plane::Xy;
    SpindleMode spindle = SpindleMode::Stop;
    CoolantMode coolant = CoolantMode::Off;
    FunctionStep step = FunctionStep::Both;  // of a Function
    bool exact_stop = false;                 // the motion ends at rest
    bool machine_coordinates = false;  // `to` is in machine coordinates, tool length not counted
    bool is_unshifted = false;         // programmed in machine coordinates, whatever `to` is in
    bool keeps_feed = false;           // no override of the feed acts, as when tapping
    bool ignores_hold = false;         // a hold waits until the motions with this are through
    bool cutting_speed = false;        // spindles: `speed` is m/min (constant cutting speed)
    bool is_swivelled = false;         // ToolLength: `direction` is the tool's, which a head turns
    std::uint8_t spindle_number = 0;   // of a spindle where the machine has several; else 0
    AxisMask moved = 0;                // axes that the block programmed
    SourceId source;
    std::uint32_t line = 0;   // of the ISO-7bit text
    std::uint16_t cycle = 0;  // a part of one: its place in the dialect's list, from 1; 0: of none

    AxisValues to{};  // end position of every axis, mm and deg
    // Arc: runs counter-clockwise about `normal` by `sweep` while the height along it grows evenly.
    // The radius goes linearly from the start's to the end's (within the control's tolerance).
    Vec3 center = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ();
    double sweep = 0;           // rad, > 0, additional turns included
    bool is_clockwise = false;  // in `plane` of the base system, mirrors worked in; for listings
    double turns = 0;           // additional full turns, as programmed
    SplineShape spline;         // Spline: one span, from where the tool is to `to`
    // Involute: of a circle about `center`, counter-clockwise about `normal` from where the tool is
    // to `to`; the height along the normal grows evenly with the way.
    double base_radius = 0;         // of the circle, mm
    std::vector<CurveShape> curve;  // Parametric: its one shape; others have none and stay small
    Blending blending;              // of the corner behind a motion; none where it ends at rest
    double compress = 0;  // Line: it may become a part of a curve within this tolerance, mm;
                          // 0: it stays what it is

    // Of a motion: one where the program says something of it; else none.
    std::vector<Dynamics> dynamics;

    // Of a motion under a transformation: `to` is the tip in the workpiece system or in virtual
    // coordinates, and where the rotary axes stand there.
    Turning turning = Turning::None;
    Vec3 direction = Vec3::UnitZ();  // of the tool at the end, unit vector from tip to holder;
                                     // in the base system where no transformation acts
    /// … and how it turns: fields as of a Turn, but over the whole motion: `rate` is rad and
    /// `axis` of a Point mm from its start to the end, leans go from the first to the second.
    Vec3 turn_from = Vec3::UnitZ();  // Surface, Point
    Vec3 turn_axis = Vec3::Zero();   // Cone, Surface, Point
    double turn_angle = 0;           // Cone, Surface; by the right-hand rule
    double orient_outwards = 0;      // Point
    Lean lean;                       // Surface
    // … whose path is that of the place where the cutter touches: one; else none.
    std::vector<ContactMotion> contact;
    VirtualAxes virtual_axes;  // in which the motion is told; the tool does not turn then

    double feed = 0;            // mm/min, mm/rev or 1/min, as feed_mode says; of a thread mm/rev
    double lead_change = 0;     // Thread: by how much `feed` changes in a turn, mm/rev
    double speed = 0;           // spindles: rpm or m/min; SpeedLimit: rpm
    double least_speed = 0;     // SpeedLimit: rpm, under constant cutting speed; 0: none
    double angle_deg = 0;       // spindles: orient; Thread: angle of the spindle at its start
    double time = 0;            // Dwell, s; 0 if revolutions; External, s
    double revolutions = 0;     // Dwell
    std::int64_t tool = 0;      // Tool, ToolLength: the tool or offset number
    std::int64_t code = 0;      // Function: M10 is 10
    double length = 0;          // ToolLength: what is added along the normal of `plane`, mm
    Vec3 aside = Vec3::Zero();  // ToolLength: … and along the other axes, mm
    std::string text;           // Message
};

}  // namespace kadr::path
