// tilted_planes.cpp — tilted working planes: how a block programs one, and how frames and tool
// follow the rotary axes that stand to it.
//
// The base system is that of the linear axes. While a plane acts, the frames lie on the workpiece
// as the tables have turned it, and between the tip and what the linear axes carry lies the tool as
// the heads have turned it: every line is one of the linear axes, and limits are theirs. Workpiece
// and offsets are given for rotary axes at zero. F 4.8, S 6.5, motion.md 7.2.
#include "interp/tilted_planes.h"

#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "base/units.h"
#include "interp/carriers.h"
#include "interp/channel.h"
#include "interp/motion_checks.h"
#include "interp/motions.h"
#include "interp/programmed_frames.h"
#include "interp/stages.h"
#include "interp/tool_in_use.h"
#include "interp/transformation.h"
#include "machine/orientation.h"
#include "machine/tilted_plane.h"
#include "nc/parameters.h"
#include "path/linear.h"

namespace kadr::interp {

using machine::Mat3;
using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using nc::parameter_of_all;
using path::Frame;
using path::linear;
using path::Op;
using path::Vec3;

namespace {

/// Rotary axes that differ by less stand where they are to be, rad.
constexpr double kSameAngle = 1e-11;

/// Lengths that the turning of a head has left as they were, mm.
constexpr double kSameLength = 1e-9;

/// How far the two vectors of a plane may be from a right angle; F No.11220 (unsure).
constexpr double kSquareTolerance = rad_from_deg(5);

/// Three parameters that stand beside each other; what is not given is 0.
Vec3 three(const Block& block, const Invocation& invocation, std::size_t first) {
    return {block.argument(invocation, first), block.argument(invocation, first + 1),
            block.argument(invocation, first + 2)};
}

Vec3 three_angles(const Block& block, const Invocation& invocation, std::size_t first) {
    return three(block, invocation, first) * rad_from_deg(1);
}

Frame turned(const Mat3& rotation) { return {rotation, Vec3::Zero()}; }

std::string_view words_of(machine::PlaneFault fault) {
    switch (fault) {
        case machine::PlaneFault::OneLine: return "its points, vectors or angles are of one line";
        case machine::PlaneFault::NotSquare: return "its vectors are not at right angles";
        case machine::PlaneFault::ZeroVector: return "two of its points are one, or a vector is 0";
    }
    return "it is none";
}

/// The axes by the digits of a number, the first one in front; nothing if it is none of their
/// orders.
std::optional<std::array<Axis, 3>> axes_in_order(double digits) {
    std::array<Axis, 3> order{};
    unsigned seen = 0;
    if (!(digits >= 123 && digits <= 321)) return std::nullopt;
    auto rest = static_cast<std::int64_t>(digits);
    for (std::size_t i = 3; i-- > 0; rest /= 10) {
        const auto digit = static_cast<std::size_t>(rest % 10);
        if (digit < 1 || digit > 3) return std::nullopt;
        order[i] = static_cast<Axis>(digit - 1);
        seen |= 1u << digit;
    }
    if (seen != 0b1110u) return std::nullopt;
    return order;
}

/// The word of the blocks that program it.
Function function_of(const OpenPlane& programmed) {
    return programmed.is_by_points ? Function::TiltedPlaneByPoints : Function::TiltedPlaneByVectors;
}

}  // namespace

// ------------------------------------------------------------------------------ planes

TiltedPlanes::TiltedPlanes(Channel& channel)
    : channel_(channel),
      machine_(channel.state.machine),
      reporter_(channel.state.reporter),
      modal_(channel.state.motion.modal),
      position_(channel.state.motion.position),
      frames_(channel.state.frame.frames),
      tool_(channel.state.tool.tool),
      carrier_(channel.state.tool.carrier),
      orienting_(channel.state.tool.orienting),
      tilted_plane_(channel.state.tool.tilted_plane),
      comp_(channel.state.stage.comp),
      reported_(channel.state.reported),
      axes_(channel.state.axes),
      length_shift_(channel.state.motion.length_shift) {}

/// The origin that a block names: all of its coordinates or none. Nothing: it was reported.
std::optional<Vec3> TiltedPlanes::origin_of_plane(const Block& block, const Invocation& invocation,
                                                  std::size_t first) {
    const unsigned given = invocation.given >> first & 0b111u;
    if (given == 0 || given == 0b111u) return three(block, invocation, first);
    reporter_.report(diag::TiltFormat, block, invocation.function)
        .arg("one of the coordinates of its origin is missing");
    return std::nullopt;
}

/// A plane may be programmed here.
Done TiltedPlanes::require_place_for_plane(const Block& block, const Invocation& invocation,
                                           bool is_added) {
    if (comp_.is_on()) {
        reporter_.report(diag::TiltCompensated, block, invocation.function)
            .arg(reporter_.word_of(block, invocation.function));
        return kFailed;
    }
    if (tilted_plane_.is_on && !is_added && invocation.function != Function::Tilt) {
        reporter_.report(diag::TiltNested, block, invocation.function);
        return kFailed;
    }
    return kDone;
}

/// The plane lies in the system reached so far, a local shift included.
void TiltedPlanes::set_plane(const Frame& plane, bool is_added) {
    const Frame own = path::translation(frames_.own_shift());
    const Frame back = path::translation(-frames_.own_shift());
    const Frame outer = is_added ? frames_.tilt() : Frame{};
    frames_.set_tilted_plane(outer * own * plane * back);
    tilted_plane_.is_on = true;
    channel_.frames.frame_changed();
}

std::optional<Frame> TiltedPlanes::plane_by_angles(const Block& block,
                                                   const Invocation& invocation) {
    const bool is_plane = invocation.function == Function::TiltedPlaneByAngles;
    constexpr std::size_t kOrigin =
        parameter_of_all<"x", Function::Tilt, Function::TiltedPlaneEuler>();
    constexpr std::size_t kAngles =
        parameter_of_all<"a", Function::Tilt, Function::TiltedPlaneEuler>();
    const std::size_t at = is_plane ? parameter_of<Function::TiltedPlaneByAngles>("x") : kOrigin;
    std::optional<Vec3> origin = three(block, invocation, at);
    if (invocation.function != Function::Tilt) origin = origin_of_plane(block, invocation, at);
    if (!origin) return std::nullopt;
    const Frame shift = path::translation(*origin);
    const Vec3 angles = three_angles(
        block, invocation, is_plane ? parameter_of<Function::TiltedPlaneByAngles>("a") : kAngles);
    if (invocation.function == Function::Tilt) return shift * turned(machine::rpy_xyz(angles));
    const double kind =
        is_plane ? block.argument(invocation, parameter_of<Function::TiltedPlaneByAngles>("kind"))
                 : 0;
    if (kind == 0) return shift * turned(machine::euler_zxz(angles));
    if (kind == 4) {
        const auto plane = machine::projected({angles[1], angles[0], angles[2]});
        if (plane) return shift * turned(*plane);
        reporter_.report(diag::TiltFormat, block, invocation.function).arg(words_of(plane.error()));
        return std::nullopt;
    }
    const auto order = axes_in_order(
        block.argument(invocation, parameter_of<Function::TiltedPlaneByAngles>("order"), 123));
    if (!order) {
        reporter_.report(diag::TiltFormat, block, invocation.function)
            .arg("its order of the axes is none of 123, 132, 213, 231, 312, 321");
        return std::nullopt;
    }
    std::array<machine::AxisRotation, 3> turns{};
    for (std::size_t i = 0; i < 3; ++i)
        turns[i] = {(*order)[i], angles[static_cast<Eigen::Index>(index((*order)[i]))]};
    return shift * turned(machine::turned_about_fixed(turns));
}

void TiltedPlanes::tilt(const Block& block, const Invocation& invocation) {
    const bool is_added =
        invocation.function == Function::TiltedPlaneByAngles &&
        block.argument(invocation, parameter_of<Function::TiltedPlaneByAngles>("added")) != 0;
    if (!require_place_for_plane(block, invocation, is_added)) return;
    if (invocation.function == Function::Tilt && !require_rotary_axes(block, Function::Tilt))
        return;
    const std::optional<Frame> plane = plane_by_angles(block, invocation);
    if (!plane) return;
    set_plane(*plane, is_added);
    if (machine_.kinematics) carry(block, channel_.transformation.joints_of(position_.base()));
}

void TiltedPlanes::set_plane_by_blocks(const Block& block, const Invocation& invocation) {
    constexpr std::size_t kNumber =
        parameter_of_all<"number", Function::TiltedPlaneByPoints, Function::TiltedPlaneByVectors>();
    constexpr std::size_t kAdded =
        parameter_of_all<"added", Function::TiltedPlaneByPoints, Function::TiltedPlaneByVectors>();
    constexpr std::size_t kOrigin =
        parameter_of_all<"x", Function::TiltedPlaneByPoints, Function::TiltedPlaneByVectors>();
    constexpr std::size_t kTurn = parameter_of<Function::TiltedPlaneByPoints>("turn");
    constexpr std::size_t kVector = parameter_of<Function::TiltedPlaneByVectors>("i");
    const bool is_by_points = invocation.function == Function::TiltedPlaneByPoints;
    const double number = block.argument(invocation, kNumber);
    const bool is_added = block.argument(invocation, kAdded) != 0;
    if (!tilted_plane_.open) {
        if (!require_place_for_plane(block, invocation, is_added)) return;
        tilted_plane_.open.emplace();
        tilted_plane_.open->is_by_points = is_by_points;
        tilted_plane_.open->is_added = is_added;
        tilted_plane_.open->next = is_by_points && number == 0 ? 0 : 1;
    }
    OpenPlane& programmed = *tilted_plane_.open;
    if (programmed.is_by_points != is_by_points || programmed.is_added != is_added ||
        number != programmed.next) {
        reporter_.report(diag::TiltFormat, block, invocation.function)
            .arg("its blocks do not stand in their order");
        return;
    }
    const std::optional<Vec3> point = origin_of_plane(block, invocation, kOrigin);
    if (!point) return;
    if (is_by_points) {
        programmed.values[programmed.next] = *point;
        if (programmed.next == 0) programmed.turn = rad_from_deg(block.argument(invocation, kTurn));
    } else {
        if (programmed.next == 1) programmed.origin = *point;
        programmed.values[programmed.next] = three(block, invocation, kVector);
    }
    const unsigned last = is_by_points ? 3 : 2;
    if (programmed.next++ < last) return;
    const std::optional<Frame> plane = plane_by_blocks(block, programmed);
    tilted_plane_.open.reset();
    if (!plane) return;
    set_plane(*plane, is_added);
    if (machine_.kinematics) carry(block, channel_.transformation.joints_of(position_.base()));
}

std::optional<Frame> TiltedPlanes::plane_by_blocks(const Block& block,
                                                   const OpenPlane& programmed) {
    const std::array<Vec3, 3> points = {programmed.values[1], programmed.values[2],
                                        programmed.values[3]};
    const auto plane =
        programmed.is_by_points
            ? machine::through_points(points)
            : machine::by_axes(programmed.values[1], programmed.values[2], kSquareTolerance);
    if (!plane) {
        reporter_.report(diag::TiltFormat, block, function_of(programmed))
            .arg(words_of(plane.error()));
        return std::nullopt;
    }
    if (!programmed.is_by_points) return path::translation(programmed.origin) * turned(*plane);
    return path::translation(points[0]) * turned(*plane) * path::translation(programmed.values[0]) *
           path::rotation_in_plane(path::Plane::Xy, programmed.turn);
}

Done TiltedPlanes::require_block_of_open_plane(const Block& block) {
    if (block.find(function_of(*tilted_plane_.open)) != nullptr) return kDone;
    reporter_.report(diag::TiltFormat, block)
        .arg("its blocks are not complete: number " + std::to_string(tilted_plane_.open->next) +
             " is missing");
    return kFailed;
}

void TiltedPlanes::tilt_along_tool(const Block& block, const Invocation& invocation) {
    if (!require_place_for_plane(block, invocation, false)) return;
    if (!require_rotary_axes(block, invocation.function)) return;
    constexpr std::size_t kOrigin = parameter_of<Function::TiltedPlaneAlongTool>("x");
    const std::optional<Vec3> programmed = origin_of_plane(block, invocation, kOrigin);
    if (!programmed) return;
    carry(block, channel_.transformation.joints_of(position_.base()));
    const Vec3 origin =
        (invocation.given >> kOrigin & 0b111u) != 0 ? *programmed : linear(position_.here());
    const Vec3 tool = machine::tool_in_base(machine_.kinematics->chain, tilted_plane_.joints);
    const Mat3 plane =
        machine::square_to_tool((frames_.total().linear.transpose() * tool).normalized());
    const double turn = rad_from_deg(
        block.argument(invocation, parameter_of<Function::TiltedPlaneAlongTool>("turn")));
    set_plane(
        path::translation(origin) * turned(plane) * path::rotation_in_plane(path::Plane::Xy, turn),
        false);
    position_.name();
}

void TiltedPlanes::end_tilted_plane(const Block& block) {
    if (!tilted_plane_.is_on || !end_rotations_3d(block)) return;
    tilted_plane_.is_on = false;
    reported_.renew(RunNotice::TiltTurned);
    frames_.set_tilted_plane({});
    drop_carry(block);
    channel_.frames.frame_changed();
    position_.name();
}

// ------------------------------------------------------------------------------ rotary axes

Done TiltedPlanes::require_rotary_axes(const Block& block, Function function) {
    if (machine_.kinematics && machine_.kinematics->chain.is_turning()) return kDone;
    reporter_.report(diag::TiltNoKinematics, block, function).arg(machine_.name);
    return kFailed;
}

void TiltedPlanes::align(const Block& block, const Invocation& invocation) {
    const Function function = invocation.function;
    const bool is_about_tip = function == Function::AlignToolAtTip;
    if (!tilted_plane_.is_on) {
        reporter_.report(diag::TiltAlignAlone, block, function);
        return;
    }
    if (!require_rotary_axes(block, function)) return;
    const double distance =
        function == Function::AlignTool
            ? block.argument(invocation, parameter_of<Function::AlignTool>("way"))
            : 0;
    const int sense = distance == 1 ? 1 : distance == 2 ? -1 : 0;
    constexpr std::size_t kOffset = parameter_of<Function::AlignToolAtTip>("offset");
    if (is_about_tip && invocation.has(kOffset)) {
        channel_.tool.choose_offset(std::llround(block.argument(invocation, kOffset)));
        channel_.tool.measure_from(Tool::Source::Offset);
    }
    const std::optional<Vec3> joints = joints_for_plane(block, function, sense);
    if (!joints) return;
    // At rapid with the plane itself, else as the modal motion has it.
    const bool is_line = modal_.motion == Function::Line && function != Function::Tilt;
    const Op op = is_line ? Op::Line : Op::Rapid;
    const double above =
        is_about_tip ? block.argument(invocation, parameter_of<Function::AlignToolAtTip>("above"))
                     : 0;
    is_about_tip ? turn_about_tip(block, *joints, op, above) : turn_joints(block, *joints, op);
    if (!reporter_.has_ended()) carry(block, *joints);
}

/// Positions of the rotary axes with the tool along Z of the programmed system; nothing if it was
/// reported.
std::optional<Vec3> TiltedPlanes::joints_for_plane(const Block& block, Function function,
                                                   int sense) {
    const machine::Kinematics& kinematics = *machine_.kinematics;
    const machine::Chain& chain = kinematics.chain;
    const Vec3 normal = frames_.total().direction(Vec3::UnitZ());
    machine::SwivelQuery query;
    query.direction = (frames_.tables().linear.transpose() * normal).normalized();
    query.start = channel_.transformation.joints_of(position_.base());
    query.rule = kinematics.rule;
    query.sense = sense;
    const std::size_t last = chain.has(machine::kR2) ? machine::kR2 : machine::kR1;
    query.reference =
        function == Function::Swivel ? kinematics.swivel_reference.value_or(last) : last;
    for (std::size_t k = 0; k < machine::kJoints; ++k) {
        if (!chain.has(k)) continue;
        const std::size_t i = index(chain.joints[k].axis);
        query.limits[k] = {rad_from_deg(axes_.lower[i]), rad_from_deg(axes_.upper[i])};
    }
    const auto joints = machine::choose_swivel(chain, query);
    if (joints) return *joints;
    const machine::PathRefusal& refusal = joints.error();
    if (refusal.fault == machine::PathChoiceFault::Unreachable) {
        reporter_.report(diag::TiltUnreachable, block, function)
            .arg(chain.orients() ? "its rotary axes do not reach so far"
                                 : "it has one rotary axis, which does not lead there");
        return std::nullopt;
    }
    std::string words;
    for (const machine::CandidateRefusal& refused : refusal.configurations) {
        if (refused.fault == machine::CandidateFault::NoSolution) continue;
        if (!words.empty()) words += ", ";
        words += kAxisNames[index(chain.joints[refused.joint].axis)];
        words += format_shortest(round_to(deg_from_rad(refused.value), 4));
    }
    reporter_.report(diag::TiltLimits, block, function).arg(words);
    return std::nullopt;
}

/// The rotary axes go there, and the linear axes stand.
void TiltedPlanes::turn_joints(const Block& block, const Vec3& joints, Op op) {
    const machine::Chain& chain = machine_.kinematics->chain;
    if ((joints - channel_.transformation.joints_of(position_.base())).cwiseAbs().maxCoeff() <
        kSameAngle)
        return;
    Target target{position_.here(), position_.base(), channel_.transformation.joint_axes()};
    for (std::size_t k = 0; k < machine::kJoints; ++k) {
        if (!chain.has(k)) continue;
        const std::size_t i = index(chain.joints[k].axis);
        target.base[i] = deg_from_rad(joints[static_cast<Eigen::Index>(k)]);
        target.here[i] = target.base[i] - frames_.shift_values()[i];
    }
    channel_.motions.line(block, target, op, true);
}

/// The rotary axes go there, and the linear axes hold the tip on the workpiece, or a point of the
/// tool's axis above it: that is the tip of a shorter tool. F 4.8.
void TiltedPlanes::turn_about_tip(const Block& block, const Vec3& joints, Op op, double above) {
    if (op == Op::Line && !channel_.checks.require_feed(block, "line")) return;
    drop_carry(block);
    if (tool_.has_changed) channel_.tool.activate_length(block, kLinearXYZ);
    if (above == 0) return hold_tip(block, joints, op);
    const Vec3 lengths = tool_.lengths;
    channel_.tool.set_lengths(lengths - above * machine_.kinematics->chain.tool_direction);
    stand_at(block, channel_.transformation.machine_axes(), true);
    hold_tip(block, joints, op);
    if (reporter_.has_ended()) return;
    const AxisValues axes = channel_.transformation.machine_axes();
    channel_.tool.set_lengths(lengths);
    stand_at(block, axes, true);
}

void TiltedPlanes::hold_tip(const Block& block, const Vec3& joints, Op op) {
    const machine::Chain& chain = machine_.kinematics->chain;
    const AxisValues axes = channel_.transformation.machine_axes();
    const Vec3 tool = -tool_.lengths;
    machine::ChainPosition position{linear(axes),
                                    {axes[6], axes[7], axes[8]},
                                    channel_.transformation.joints_of(position_.base())};
    const Vec3 tip = machine::forward(chain, position, tool).tip;
    position.rotary = joints;
    const Vec3 stand = machine::inverse_linear(chain, tip, position, tool);
    AxisValues end = position_.base();
    for (std::size_t k = 0; k < machine::kJoints; ++k) {
        if (chain.has(k))
            end[index(chain.joints[k].axis)] = deg_from_rad(joints[static_cast<Eigen::Index>(k)]);
    }
    for (std::size_t i = 0; i < 3; ++i)
        end[i] = stand[static_cast<Eigen::Index>(i)] - length_shift_[i];
    const auto moved = static_cast<AxisMask>(kLinearXYZ | channel_.transformation.joint_axes());
    if (!channel_.checks.require_within_machine(block, end, moved)) return;
    path::Motion& motion = channel_.stages.put(op, block).motion();
    motion.to = end;
    for (std::size_t i = 0; i < 3; ++i) motion.to[i] = tip[static_cast<Eigen::Index>(i)];
    motion.moved = moved;
    motion.exact_stop = true;
    motion.feed = op == Op::Rapid ? 0 : modal_.feed;
    motion.orient_plainly(path::OrientKind::Axes);
    motion.direction = machine::tool_vector(chain, joints);
    position_.stand_at(end);
    channel_.frames.frame_changed();
    position_.name();
}

// ------------------------------------------------------------------------------ what they carry

void TiltedPlanes::carry(const Block& block, const Vec3& joints) {
    if (!machine_.kinematics || orienting_.is_on) return;
    const AxisValues axes = channel_.transformation.machine_axes();
    const bool had_carrier = channel_.carriers.leave_carrier();
    const Vec3 before = tilted_plane_.carries ? tilted_plane_.joints : Vec3(Vec3::Zero());
    const machine::Chain& chain = machine_.kinematics->chain;
    const bool tool_turns = !machine::tool_in_base(chain, before)
                                 .isApprox(machine::tool_in_base(chain, joints), kSameLength);
    tilted_plane_.carries = true;
    tilted_plane_.joints = joints;
    frames_.set_tables(machine::table_frame(chain, joints));
    stand_at(block, axes, tool_turns || had_carrier);
}

void TiltedPlanes::drop_carry(const Block& block) {
    if (!tilted_plane_.carries) return;
    const AxisValues axes = channel_.transformation.machine_axes();
    const machine::Chain& chain = machine_.kinematics->chain;
    const bool tool_turned = !machine::tool_in_base(chain, tilted_plane_.joints)
                                  .isApprox(chain.tool_direction, kSameLength);
    tilted_plane_.carries = false;
    frames_.set_tables(
        tilted_plane_.on_tables
            ? machine::table_frame(chain, channel_.transformation.joints_of(position_.base()))
            : Frame{});
    stand_at(block, axes, tool_turned);
}

/// The axes stand where they are; tip and tool have another position in the base system.
void TiltedPlanes::stand_at(const Block& block, const AxisValues& axes, bool tool_turns) {
    const Vec3 shift = channel_.tool.length_shift_of(tool_.lengths);
    if (tool_turns || (shift - linear(length_shift_)).norm() > kSameLength) {
        channel_.tool.set_length_shift(shift);
        channel_.tool.put_tool_length(block, tool_.axis).changed = kLinearXYZ;
    }
    channel_.transformation.take_position(
        path::with_linear(position_.base(), linear(axes) - linear(length_shift_)));
}

void TiltedPlanes::check_carried(const Block& block) {
    if (reported_.has_reported(RunNotice::TiltTurned) || !machine_.kinematics) return;
    const nc::SlotMask turned = block.given & channel_.transformation.joint_axes();
    if (turned == 0) return;
    const Vec3 now = tilted_plane_.joints;
    const machine::Chain& chain = machine_.kinematics->chain;
    for (std::size_t k = 0; k < machine::kJoints; ++k) {
        if (!chain.has(k)) continue;
        const nc::Slot slot = nc::slot_of(chain.joints[k].axis);
        if ((turned & bit(slot)) == 0) continue;
        const double parameter = deg_from_rad(now[static_cast<Eigen::Index>(k)]);
        constexpr double kWidth = 0.0005;  // deg: half an increment
        if (std::abs(std::remainder(block.at(slot) - parameter, 360)) < kWidth) continue;
        reported_.count_as_reported(RunNotice::TiltTurned);
        reporter_.report(diag::TiltTurned, block, slot)
            .arg(kAxisNames[index(chain.joints[k].axis)])
            .arg(round_to(parameter, 4));
        return;
    }
}

}  // namespace kadr::interp
