// Which motion a block is: the truth table, row by row as it is asked. A block that could be two of
// them is the one that stands before.
#include "interp/motion_kind.h"

#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace motion_kind_test {

namespace {

using kadr::interp::classify;
using kadr::interp::MotionCase;
using kadr::interp::MotionKind;
using kadr::nc::Function;

struct Row {
    const char* name;
    MotionKind kind;
    void (*say)(MotionCase&);  // what has to be so
};

const std::vector<Row>& table() {
    static const std::vector<Row> rows = {
        {"approach beside 3D compensation", MotionKind::ApproachInSpace,
         [](MotionCase& of) {
             of.smooth = MotionCase::Smooth::Approach;
             of.is_in_space = true;
         }},
        {"approach", MotionKind::Approach,
         [](MotionCase& of) { of.smooth = MotionCase::Smooth::Approach; }},
        {"retract", MotionKind::Retract,
         [](MotionCase& of) { of.smooth = MotionCase::Smooth::Retract; }},
        {"G28", MotionKind::ReferencePoint, [](MotionCase& of) { of.refers = true; }},
        {"G37", MotionKind::Measure, [](MotionCase& of) { of.measures = true; }},
        {"G31 beside G41", MotionKind::CompensatedProbe,
         [](MotionCase& of) { of.probes = of.is_compensated = true; }},
        {"G66", MotionKind::CallBehindMotions,
         [](MotionCase& of) { of.calls_behind_motions = true; }},
        {"G83 G0", MotionKind::CancelledCycle, [](MotionCase& of) { of.cancels_cycle = true; }},
        {"G83", MotionKind::CycleCall, [](MotionCase& of) { of.calls_cycle = true; }},
        {"X under G83", MotionKind::CycleRepeat,
         [](MotionCase& of) { of.repeats_cycle = of.is_of_cycle = true; }},
        {"ORIRESET", MotionKind::OrientationReset,
         [](MotionCase& of) { of.resets_orientation = true; }},
        {"A3 beside G33", MotionKind::TurnBesideThread,
         [](MotionCase& of) {
             of.motion = Function::Thread;
             of.has_tool_words = true;
         }},
        {"BSPLINE X", MotionKind::Spline,
         [](MotionCase& of) {
             of.motion = Function::Spline;
             of.has_target = true;
         }},
        {"knot alone", MotionKind::Spline,
         [](MotionCase& of) {
             of.motion = Function::Spline;
             of.has_knot = true;
         }},
        {"CSPLINE X", MotionKind::SplineThrough,
         [](MotionCase& of) {
             of.motion = Function::CubicSpline;
             of.has_target = true;
         }},
        {"POLY PO[X]", MotionKind::Polynomial,
         [](MotionCase& of) {
             of.motion = Function::Polynomial;
             of.has_polynomial = true;
         }},
        {"F alone", MotionKind::Stays, [](MotionCase&) {}},
        {"I beside G1", MotionKind::Stays,
         [](MotionCase& of) {
             of.motion = Function::Line;
             of.has_arc_words = true;
         }},
        {"G53 X", MotionKind::MachineCoordinates,
         [](MotionCase& of) { of.has_target = of.is_in_machine_coordinates = true; }},
        {"SUPA D0 X", MotionKind::WithoutLength,
         [](MotionCase& of) { of.has_target = of.suspends_length = true; }},
        {"G0 for one block", MotionKind::RapidOnce,
         [](MotionCase& of) { of.has_target = of.is_rapid_once = true; }},
        {"G63 Z", MotionKind::FloatingTap, [](MotionCase& of) { of.has_target = of.taps = true; }},
        {"MEAS=1 X", MotionKind::Probe, [](MotionCase& of) { of.has_target = of.probes = true; }},
        {"G33 Z", MotionKind::Thread,
         [](MotionCase& of) {
             of.motion = Function::Thread;
             of.has_target = true;
         }},
        {"G35 along an arc", MotionKind::ArcThread,
         [](MotionCase& of) {
             of.motion = Function::ThreadArcCw;
             of.has_target = of.has_arc_words = true;
         }},
        {"INVCW", MotionKind::Involute,
         [](MotionCase& of) {
             of.motion = Function::InvoluteCw;
             of.has_target = of.has_arc_words = true;
         }},
        {"G331 Z", MotionKind::RigidTap,
         [](MotionCase& of) {
             of.motion = Function::TapIn;
             of.has_target = true;
         }},
        {"G2 I, a full circle", MotionKind::Arc,
         [](MotionCase& of) {
             of.motion = Function::ArcCw;
             of.has_arc_words = true;
         }},
        {"CIP X I1", MotionKind::ArcThrough,
         [](MotionCase& of) {
             of.motion = Function::ArcThrough;
             of.has_target = of.has_arc_words = true;
         }},
        {"CT X", MotionKind::ArcTangent,
         [](MotionCase& of) {
             of.motion = Function::ArcTangent;
             of.has_target = true;
         }},
        {"G1 X", MotionKind::Straight,
         [](MotionCase& of) {
             of.motion = Function::Line;
             of.has_target = true;
         }},
        {"A3 alone", MotionKind::Straight,
         [](MotionCase& of) { of.turns_tool = of.has_tool_words = true; }}};
    return rows;
}

TEST(MotionKind, EachRowIsItsKind) {
    for (const Row& row : table()) {
        MotionCase of;
        row.say(of);
        EXPECT_EQ(classify(of), row.kind) << row.name;
    }
}

TEST(MotionKind, EveryKindHasARow) {
    constexpr auto kLast = static_cast<std::size_t>(MotionKind::Straight);
    std::array<bool, kLast + 1> seen{};
    for (const Row& row : table()) seen[static_cast<std::size_t>(row.kind)] = true;
    for (std::size_t kind = 0; kind <= kLast; ++kind) EXPECT_TRUE(seen[kind]) << kind;
}

/// What a function asks for goes before what the motion code is: a block that says both is the
/// former, whatever comes first in the text.
TEST(MotionKind, FunctionsGoBeforeTheMotionCode) {
    constexpr auto kFunctions = static_cast<std::size_t>(MotionKind::OrientationReset);
    for (const Row& first : table()) {
        if (static_cast<std::size_t>(first.kind) > kFunctions) continue;
        for (const Row& second : table()) {
            if (second.kind <= first.kind || second.kind == MotionKind::Stays) continue;
            MotionCase of;
            second.say(of);
            const bool is_ready = of.is_in_machine_coordinates || of.probes || of.is_in_space;
            if (is_ready) continue;  // these have rows of their own, below
            first.say(of);
            EXPECT_EQ(classify(of), first.kind) << first.name << " and " << second.name;
        }
    }
}

TEST(MotionKind, APlaceOfTheMachineIsNoPlaceOfACycle) {
    MotionCase of;
    of.repeats_cycle = of.is_of_cycle = of.has_target = of.is_in_machine_coordinates = true;
    EXPECT_EQ(classify(of), MotionKind::MachineCoordinates);
    of.has_no_frames = true;  // its place is known: it moves as it says
    of.repeats_cycle = false;
    EXPECT_EQ(classify(of), MotionKind::Straight);
}

TEST(MotionKind, AMachineCoordinateLeavesASpline) {
    MotionCase of;
    of.motion = Function::Spline;
    of.has_target = of.is_in_machine_coordinates = true;
    EXPECT_EQ(classify(of), MotionKind::MachineCoordinates);
}

TEST(MotionKind, APointThatOnlyTurnsTheToolIsNoPointOfASpline) {
    MotionCase of;
    of.motion = Function::AkimaSpline;
    of.has_target = of.only_turns = of.turns_tool = of.has_tool_words = true;
    EXPECT_EQ(classify(of), MotionKind::Straight);
}

}  // namespace

}  // namespace motion_kind_test
