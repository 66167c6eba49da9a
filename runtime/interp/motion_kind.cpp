#include "interp/motion_kind.h"

#include <optional>

namespace kadr::interp {

using nc::Fact;
using nc::Function;

namespace {

/// Motions that other functions program than the motion code.
std::optional<MotionKind> kind_by_functions(const MotionCase& of) {
    using Smooth = MotionCase::Smooth;
    if (of.smooth != Smooth::None && of.is_in_space) return MotionKind::ApproachInSpace;
    if (of.smooth == Smooth::Approach) return MotionKind::Approach;
    if (of.smooth == Smooth::Retract) return MotionKind::Retract;
    if (of.refers) return MotionKind::ReferencePoint;
    if (of.measures) return MotionKind::Measure;
    if (of.probes && of.is_compensated) return MotionKind::CompensatedProbe;
    return std::nullopt;
}

std::optional<MotionKind> kind_by_cycle(const MotionCase& of) {
    if (of.calls_behind_motions) return MotionKind::CallBehindMotions;
    if (of.cancels_cycle) return MotionKind::CancelledCycle;
    if (of.calls_cycle) return MotionKind::CycleCall;
    if (of.repeats_cycle && of.is_of_cycle && !of.is_in_machine_coordinates)
        return MotionKind::CycleRepeat;
    return std::nullopt;
}

/// Blocks that are collected, or become curves of their own.
std::optional<MotionKind> kind_by_spline(const MotionCase& of) {
    if (of.is_in_machine_coordinates && !of.has_no_frames) return std::nullopt;
    if (of.motion == Function::Spline && (of.has_target || of.has_knot)) return MotionKind::Spline;
    const bool goes_through =
        of.motion == Function::AkimaSpline || of.motion == Function::CubicSpline;
    if (goes_through && of.has_target && !of.only_turns) return MotionKind::SplineThrough;
    if (of.motion == Function::Polynomial && (of.has_target || of.has_polynomial))
        return MotionKind::Polynomial;
    return std::nullopt;
}

bool stays(const MotionCase& of) {
    const bool has_arc = of.has_arc_words && nc::has_fact(of.motion, Fact::Circle);
    return !of.has_target && !of.turns_tool && !has_arc;
}

MotionKind kind_by_target(const MotionCase& of) {
    if (of.is_in_machine_coordinates && !of.has_no_frames) return MotionKind::MachineCoordinates;
    if (of.suspends_length) return MotionKind::WithoutLength;
    if (of.is_rapid_once) return MotionKind::RapidOnce;
    if (of.taps) return MotionKind::FloatingTap;
    if (of.probes) return MotionKind::Probe;
    if (of.motion == Function::Thread || nc::has_fact(of.motion, Fact::VaryingThread))
        return MotionKind::Thread;
    if (nc::has_fact(of.motion, Fact::ArcThread)) return MotionKind::ArcThread;
    if (nc::has_fact(of.motion, Fact::Involute)) return MotionKind::Involute;
    if (nc::has_fact(of.motion, Fact::Tapping)) return MotionKind::RigidTap;
    if (nc::has_fact(of.motion, Fact::Arc)) return MotionKind::Arc;
    if (of.motion == Function::ArcThrough) return MotionKind::ArcThrough;
    if (of.motion == Function::ArcTangent) return MotionKind::ArcTangent;
    return MotionKind::Straight;
}

}  // namespace

MotionKind classify(const MotionCase& of) {
    if (const auto kind = kind_by_functions(of)) return *kind;
    if (const auto kind = kind_by_cycle(of)) return *kind;
    if (of.resets_orientation) return MotionKind::OrientationReset;
    if (of.has_tool_words && !nc::has_fact(of.motion, Fact::TakesOrientation))
        return MotionKind::TurnBesideThread;
    if (const auto kind = kind_by_spline(of)) return *kind;
    return stays(of) ? MotionKind::Stays : kind_by_target(of);
}

}  // namespace kadr::interp
