// block_actions.h — what one block asks for, and positions and pitches that are worked out of it.
// Internal to interp.
#pragma once

#include <cstdint>
#include <optional>

#include "base/axes.h"
#include "interp/state.h"
#include "nc/block.h"
#include "path/command.h"
#include "path/curve.h"

namespace kadr::interp {

/// What the functions of one block ask for besides changing the modal state.
struct Actions {
    bool machine_coordinates = false;
    bool taps = false;    // a line of floating tapping
    bool probes = false;  // a line that ends where the probe triggers
    bool exact_stop = false;
    bool at_rapid = false;            // whatever the modal motion
    double tool_offset_increase = 0;  // times the radius offset by which its distances increase
    bool length_changed = false;
    bool suspends_length = false;
    bool tool_change = false;
    bool programs_carrier = false;  // the tool's, or what leads it
    bool flood = false;
    bool mist = false;
    bool coolant_off = false;
    bool stops_behind = false;  // spindle and coolant: where the motion of the block has ended
    double thread_start_deg = 0;
    std::optional<path::SpindleMode> spindle;
    enum class Stop : std::uint8_t { None, Always, Optional };  // of the program
    Stop stop = Stop::None;
    bool ends = false;  // … likewise
    std::optional<CompSide> radius_comp;
    bool comp_changed = false;  // its radius, allowance or rules
    bool keeps_vector = false;  // of the compensation
    ToolWords tool;
    bool switches_length = false;  // the transformation, as a kind of tool length compensation
    const nc::Invocation* comp_corner = nullptr;
    const nc::Invocation* smooth_approach = nullptr;  // SmoothApproach or SmoothRetract
    bool was_rapid = false;                           // the modal motion in the block before
    double feed_before = 0;
    bool had_feed = false;
    const nc::Invocation* corner = nullptr;  // chamfer or rounding at the end of the block
    double corner_feed = 0;                  // 0: not programmed
    std::optional<double> feed_once;         // of this block alone
    const nc::Invocation* angle = nullptr;
    const nc::Invocation* orient = nullptr;
    const nc::Invocation* orient_reset = nullptr;
    const nc::Invocation* align = nullptr;  // the rotary axes stand to the tilted plane
    const nc::Invocation* dwell = nullptr;  // Dwell or SpindleDwell
    const nc::Invocation* message = nullptr;
    const nc::Invocation* limit = nullptr;
    const nc::Invocation* data = nullptr;  // WorkOffsetData or ToolOffsetData
    const nc::Invocation* cycle = nullptr;
    bool cycle_is_cancelled = false;  // … by a motion code behind it
    bool calls_behind_motions = false;
    bool calls_defined = false;  // the cycle that was defined last, behind the motion
    CycleWords cycle_words;
    const nc::Invocation* preset = nullptr;
    const nc::Invocation* measure = nullptr;    // a motion to where the tool is measured
    std::optional<double> tooth_feed;           // mm
    const nc::Invocation* reference = nullptr;  // a motion to the reference point, or from there
    // Before the block.
    path::SpindleMode spindle_before = path::SpindleMode::Stop;
    path::CoolantMode coolant_before = path::CoolantMode::Off;
};

/// End of a motion in the programmed system and in the base system.
struct Target {
    AxisValues here;
    AxisValues base;
    AxisMask moved = 0;
    AxisMask carried = 0;  // of them by the orientation alone: what was programmed for them stays
    OrientPlan orientation{};  // under a transformation
};

/// Where a smooth approach or retraction touches the contour, in the plane of the base system.
struct ApproachPoint {
    path::Vec2 point = path::Vec2::Zero();
    path::Vec2 direction = path::Vec2::Zero();  // of the contour there, unit vector
    path::Vec2 tool = path::Vec2::Zero();       // where the tool comes from or goes to
};

/// Where a probing ended: tool length included, and of the tip, in the programmed system; in
/// machine coordinates.
struct Probed {
    AxisValues head{};
    AxisValues tip{};
    AxisValues machine{};
    bool is_found = true;  // the probe has triggered
};

/// What a probing motion meets on its path.
struct Probing {
    std::optional<Target> touched;  // where the axes are then; nothing: it meets nothing
    bool goes_on = false;           // to the end of its path all the same
    bool ends_move() const { return touched.has_value() && !goes_on; }
};

/// A motion in the coordinates of the words that program it, mm and deg.
struct ProgrammedMove {
    AxisValues from{};
    AxisValues to{};
};

/// The pitch of a thread along an arc, mm a revolution, and the axis along which it is programmed.
struct ThreadPitch {
    double pitch = 0;
    Eigen::Index axis = 0;
};

}  // namespace kadr::interp
