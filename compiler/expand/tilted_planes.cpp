// tilted_planes.cpp — tilted planes: in the words of the target, or as positions of the rotary axes
// and a zero point that has gone with the table.
//
// A control without such words moves its linear axes and nothing else. On a machine whose tables
// alone turn, a plane to which the tool stands is then a shift and a rotation about Z; a head would
// incline the tool's length away from Z, which takes a control that knows of it. Motion.md 7.2
// and 7.3.
#include "expand/tilted_planes.h"

#include <array>
#include <cmath>

#include "base/diagnostics/expand.h"
#include "base/units.h"
#include "expand/block_values.h"
#include "expand/blocks.h"
#include "expand/contour_recording.h"
#include "expand/faults.h"
#include "expand/frame_blocks.h"
#include "expand/input_frames.h"
#include "expand/numbers.h"
#include "expand/orienting.h"
#include "expand/running.h"
#include "machine/machine.h"
#include "machine/orientation.h"
#include "machine/tilted_plane.h"
#include "nc/parameters.h"

namespace kadr::expand {

using machine::Mat3;
using nc::Block;
using nc::Function;
using nc::Group;
using path::Frame;
using path::Vec3;

namespace {

Done emit_plan_of_frame(Running& run, const sema::Plan& plan, const Instruction& instruction,
                        const Slot* registers, std::uint32_t at);
Done read_plane(Running& run, const sema::Plan& plan, const Instruction& instruction,
                const Slot* registers, std::uint32_t at, std::array<double, 6>& values);
Done say_euler(Running& run, const std::array<double, 6>& values, SourceId source, std::uint32_t at,
               unsigned depth);
Done resolve_tilted_plane(Running& run, const std::array<double, 6>& values, SourceId source,
                          std::uint32_t at, unsigned depth);
Done say_joints(Running& run, const machine::Chain& chain, const path::Vec3& joints,
                SourceId source, std::uint32_t at, unsigned depth);

constexpr std::size_t kOrigin =
    nc::parameter_of_all<"x", Function::Tilt, Function::TiltedPlaneEuler>();
constexpr std::size_t kAngles =
    nc::parameter_of_all<"a", Function::Tilt, Function::TiltedPlaneEuler>();

Vec3 three(const std::array<double, 6>& values, std::size_t first) {
    return {values[first], values[first + 1], values[first + 2]};
}

/// What is left beside a rotation about Z is rounding.
constexpr double kNoTilt = 1e-9;

/// Angles of a resolved plane that differ from 0 by less are 0, deg.
constexpr double kNoAngle = 1e-9;

double neat_angle(double angle_deg) { return std::fabs(angle_deg) < kNoAngle ? 0 : angle_deg; }

/// The programmed motion. Rotary axes go to a plane at rapid, whatever it is.
struct ModalMotion {
    Function member;
    SourceId by;
    bool is_lost;
};

ModalMotion modal_motion(const ModalState& modal) {
    return {modal[Group::Motion], modal.by(Group::Motion), modal.lost.has(Group::Motion)};
}

/// Behind a block at rapid: the next move writes what is programmed, or must write it itself.
void keep_motion(ModalState& modal, const ModalMotion& motion) {
    modal.assume(Group::Motion, motion.member, motion.by);
    if (motion.is_lost) modal.lost.lose_again(sema::group_bit(Group::Motion));
    else if (motion.member != Function::Rapid) modal.owed.owe_motion();
}

}  // namespace

bool is_about_tilted_plane(const Running& run, const sema::Plan& plan) {
    for (const nc::Invocation& invocation : plan.functions) {
        if (nc::has_fact(invocation.function, nc::Fact::BeginsOrEndsTiltedPlane)) return true;
        if (run.modal.tilt.acts() && nc::has_fact(invocation.function, nc::Fact::MovesSystem))
            return true;
    }
    return false;
}

Done emit_tilted_plane(Running& run, const sema::Plan& plan, const Instruction& instruction,
                       const Slot* registers, std::uint32_t at) {
    const Function function = plan.functions.front().function;
    if (!nc::has_fact(function, nc::Fact::BeginsOrEndsTiltedPlane)) {
        const bool may_change = run.modal.tilt.kind() == PlaneTilt::Own;
        if (may_change && function != Function::WorkOffset && function != Function::SetPosition)
            return emit_plan_of_frame(run, plan, instruction, registers, at);
        return refuse_in_tilted_plane(run, nc::info(function).name, at);
    }
    if (run.recordings.is_open()) return refuse_in_contour(run, "a tilted plane", at);
    const bool is_outermost = run.modal.tilt.kind() == PlaneTilt::Resolved
                                  ? run.modal.frame.now() == run.modal.tilt.frame()
                                  : run.modal.frame.now().is_identity();
    if (!is_outermost) {
        fault(run, diag::TiltInFrame, at).arg(nc::info(function).name);
        return kFailed;
    }
    const SourceId source = statement_of(instruction);
    if (function == Function::TiltedPlaneOff) {
        if (run.modal.tilt.kind() == PlaneTilt::None) return kDone;
        if (run.modal.tilt.kind() != PlaneTilt::Resolved)
            return emit_block(run, plan, instruction, registers, at);
        write_frame(run, {}, source, at, instruction.c);
        run.modal.tilt.choose(PlaneTilt::None);
        return Done(!run.status.has_failed());
    }
    if (run.target.can_write(Function::Tilt))
        return emit_block(run, plan, instruction, registers, at);
    std::array<double, 6> values{};
    if (!read_plane(run, plan, instruction, registers, at, values)) return kFailed;
    if (run.target.can_write(Function::TiltedPlaneEuler) &&
        run.target.can_write(Function::AlignTool))
        return say_euler(run, values, source, at, instruction.c);
    return resolve_tilted_plane(run, values, source, at, instruction.c);
}

namespace {

/// A frame inside of a plane, on a control that has frames in planes.
Done emit_plan_of_frame(Running& run, const sema::Plan& plan, const Instruction& instruction,
                        const Slot* registers, std::uint32_t at) {
    if (needs_frame(run, plan)) return emit_frame(run, plan, instruction, registers, at);
    return emit_block(run, plan, instruction, registers, at);
}

}  // namespace

Done refuse_in_tilted_plane(Running& run, std::string_view what, std::uint32_t at) {
    fault(run, diag::FrameInTilt, at).arg(what).arg(run.target.name());
    return kFailed;
}

namespace {

/// Origin, mm, and the angles about X, the new Y, the new Z, deg.
Done read_plane(Running& run, const sema::Plan& plan, const Instruction& instruction,
                const Slot* registers, std::uint32_t at, std::array<double, 6>& values) {
    const std::size_t first = plan.functions.front().first;
    for (const auto& [place, value] : plan.arguments)
        if (place >= first && place < first + values.size()) values[place - first] = value;
    const Slot* numbers = registers + instruction.a;
    for (std::size_t f = 0; f < plan.fillings.size(); ++f) {
        const sema::Filling& filling = plan.fillings[f];
        if (!filling.is_argument || filling.parameter >= values.size()) continue;
        const double number = numbers[f].number;
        if (!is_sane(number)) {
            if (number != number) not_given(run, {}, word_of(run, filling, at));
            else math_fault(run, sema::MathFault::Overflow, at);
            return kFailed;
        }
        values[filling.parameter] = number;
    }
    return kDone;
}

/// By Euler angles, and the rotary axes in a block of its own.
Done say_euler(Running& run, const std::array<double, 6>& values, SourceId source, std::uint32_t at,
               unsigned depth) {
    const auto add = [&](Function function, std::span<const ArgumentValue> arguments) {
        put_function(run, function, arguments, source, at, depth);
    };
    const Vec3 turns = three(values, kAngles) * rad_from_deg(1);
    const Vec3 euler = machine::euler_zxz_of(machine::rpy_xyz(turns))[0];
    std::array<ArgumentValue, 6> said{};
    for (std::size_t i = 0; i < said.size(); ++i) said[i] = {i, values[i]};
    for (std::size_t i = 0; i < 3; ++i)
        said[kAngles + i].value = neat_angle(deg_from_rad(euler[static_cast<Eigen::Index>(i)]));
    // `G53.1` turns them as the modal motion is, and stands next to the plane. F 4.8 G53.1.
    const ModalMotion motion = modal_motion(run.modal);
    if (!require_room(run, at)) return kFailed;
    Block& block = next_block(run, source);
    block.motion = Function::Rapid;
    run.modal.take_block(block, run.target.rules());
    if (run.options.trace) keep_trace(run, at, depth, source);
    if (run.modal.tilt.acts()) add(Function::TiltedPlaneOff, {});
    add(Function::TiltedPlaneEuler, said);
    add(Function::AlignTool,
        std::array{ArgumentValue{nc::parameter_of<Function::AlignTool>("way"), 0}});
    keep_motion(run.modal, motion);
    return Done(!run.status.has_failed());
}

/// The rotary axes go to their positions, and the frame is that of the part on the turned tables.
Done resolve_tilted_plane(Running& run, const std::array<double, 6>& values, SourceId source,
                          std::uint32_t at, unsigned depth) {
    const machine::Machine* machine = run.options.machine ? run.options.machine() : nullptr;
    if (machine == nullptr || !machine->kinematics) {
        fault(run, diag::TiltNoMachine, at)
            .arg(run.target.name())
            .arg(machine == nullptr ? "" : machine->name)
            .fix("name the machine: `-m MACHINE`");
        return kFailed;
    }
    const machine::Chain& chain = machine->kinematics->chain;
    const std::size_t number = run.modal[Group::WorkOffsets] == Function::WorkOffset
                                   ? static_cast<std::size_t>(run.modal.work_offset)
                                   : 1;
    if (number >= machine->work_offsets.size()) {
        fault(run, diag::TiltNoZero, at).arg(machine->name).arg(number);
        return kFailed;
    }
    const AxisValues& offset = machine->work_offsets[number];
    const Vec3 zero(offset[0], offset[1], offset[2]);
    const Vec3 turns = three(values, kAngles) * rad_from_deg(1);
    const Mat3 plane = machine::rpy_xyz(turns);

    machine::SwivelQuery query;
    query.direction = plane.col(2);
    query.rule = machine->kinematics->rule;
    for (std::size_t k = 0; k < machine::kJoints; ++k) {
        if (!chain.has(k)) continue;
        const Axis axis = chain.joints[k].axis;
        const auto slot = static_cast<Eigen::Index>(k);
        if ((run.modal.position.known() & bit(axis)) != 0)
            query.start[slot] = rad_from_deg(run.modal.position[index(axis)]);
        if (const machine::MachineAxis* limits = machine->find(axis))
            query.limits[k] = {limits->lower, limits->upper};
    }
    const auto joints = machine::choose_swivel(chain, query);
    if (!joints) {
        fault(run, diag::TiltBeyond, at).arg(machine->name);
        return kFailed;
    }
    const bool head_turns =
        (machine::tool_in_base(chain, *joints) - chain.tool_direction).norm() > kNoTilt;
    if (head_turns) {
        fault(run, diag::TiltOfHead, at).arg(run.target.name()).arg(machine->name);
        return kFailed;
    }
    const Vec3 origin = three(values, kOrigin);
    const Frame whole = machine::table_frame(chain, *joints) * path::translation(zero + origin) *
                        Frame{plane, Vec3::Zero()};

    control::ProgramFrame next;
    for (std::size_t i = 0; i < 3; ++i) {
        next.shift[i] = neat(whole.shift[static_cast<Eigen::Index>(i)] - offset[i]);
        next.is_shifted[i] = next.shift[i] != 0;
    }
    next.plane = Function::PlaneXy;
    next.angle_deg = neat_angle(deg_from_rad(std::atan2(whole.linear(1, 0), whole.linear(0, 0))));
    if (!say_joints(run, chain, *joints, source, at, depth)) return kFailed;
    write_frame(run, next, source, at, depth);
    run.modal.tilt.resolve(run.modal.frame.now());
    return Done(!run.status.has_failed());
}

/// A block at rapid that brings the rotary axes to their positions; the modal motion stays.
Done say_joints(Running& run, const machine::Chain& chain, const Vec3& joints, SourceId source,
                std::uint32_t at, unsigned depth) {
    if (!require_room(run, at)) return kFailed;
    Block& block = next_block(run, source);
    block.motion = Function::Rapid;
    for (std::size_t k = 0; k < machine::kJoints; ++k) {
        if (!chain.has(k)) continue;
        const nc::Slot slot = nc::slot_of(chain.joints[k].axis);
        block.set(slot, neat(neat_angle(deg_from_rad(joints[static_cast<Eigen::Index>(k)]))));
        if (run.modal[Group::Distance] == Function::Incremental) block.absolute |= nc::bit(slot);
    }
    const ModalMotion motion = modal_motion(run.modal);
    run.modal.take_block(block, run.target.rules());
    keep_motion(run.modal, motion);
    if (run.options.trace) keep_trace(run, at, depth, source);
    return kDone;
}

}  // namespace

}  // namespace kadr::expand
