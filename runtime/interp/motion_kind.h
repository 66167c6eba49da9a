// motion_kind.h — which motion a block is. Internal to interp.
#pragma once

#include <cstdint>

#include "nc/vocabulary.h"

namespace kadr::interp {

/// In the order in which they are asked for: of two that a block could be, it is the first one.
/// What is refused is a kind, too, so that this order is also that of the messages.
enum class MotionKind : std::uint8_t {
    ApproachInSpace,  // refused: a smooth approach beside 3D compensation
    Approach,
    Retract,
    ReferencePoint,
    Measure,
    CompensatedProbe,  // refused
    CallBehindMotions,
    CancelledCycle,
    CycleCall,
    CycleRepeat,
    OrientationReset,
    TurnBesideThread,  // refused: words of the tool beside a motion that takes none
    Spline,
    SplineThrough,
    Polynomial,
    Stays,  // it names no position
    // These have a target.
    MachineCoordinates,
    WithoutLength,
    RapidOnce,
    FloatingTap,
    Probe,
    Thread,
    ArcThread,
    Involute,
    RigidTap,
    Arc,
    ArcThrough,
    ArcTangent,
    Straight,
};

/// What decides it: the words of the block, and what acts.
struct MotionCase {
    nc::Function motion = nc::Function::Rapid;  // that acts
    bool has_target = false;                    // a word of an axis
    bool has_arc_words = false;                 // … of a centre, a radius, a point on the path
    bool turns_tool = false;
    bool has_tool_words = false;
    bool has_knot = false;        // of a spline
    bool has_polynomial = false;  // of an axis
    bool only_turns = false;      // on a spline through points: it programs the orientation there
    enum class Smooth : std::uint8_t { None, Approach, Retract };
    Smooth smooth = Smooth::None;
    bool refers = false;  // a motion to the reference point, or from there
    bool measures = false;
    bool probes = false;
    bool is_in_machine_coordinates = false;
    bool calls_behind_motions = false;
    bool cancels_cycle = false;
    bool calls_cycle = false;
    bool is_of_cycle = false;  // a position, or a level, of the modal cycle
    bool resets_orientation = false;
    bool suspends_length = false;
    bool is_rapid_once = false;
    bool taps = false;  // with a floating chuck
    // What acts:
    bool is_compensated = false;
    bool is_in_space = false;    // … the compensation that acts or that is chosen
    bool repeats_cycle = false;  // a cycle is modal
    bool has_no_frames = false;  // the block has taken them off: it knows its position already
};

/// Total, and without a message.
MotionKind classify(const MotionCase& of);

/// Whether the motion goes to a position that the words of axes name.
constexpr bool has_target(MotionKind kind) { return kind >= MotionKind::MachineCoordinates; }

}  // namespace kadr::interp
