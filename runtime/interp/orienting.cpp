// orienting.cpp — the machine's transformation: where tip and tool are to be, and which rotary
// positions that takes. Where the axes go in between is motion's (motion/transformed.h).
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "base/units.h"
#include "interp/executor.h"
#include "machine/orientation.h"
#include "machine/path_choice.h"

namespace kadr::interp {

using machine::Chain;
using nc::Block;
using nc::Function;
using path::Command;
using path::Turning;
using path::Vec3;

namespace {

/// Rounding of words and frames, as a tool's direction shows it, rad: it does not turn the tool.
constexpr double kSameDirection = 1e-12;

std::string degrees(double angle) { return format_shortest(round_to(deg_from_rad(angle), 4)); }

Vec3 linear(const AxisValues& values) { return {values[0], values[1], values[2]}; }

std::string_view words_of(machine::CandidateFault fault) {
    using machine::CandidateFault;
    switch (fault) {
        case CandidateFault::NoSolution: return "does not exist";
        case CandidateFault::FirstOutside:
        case CandidateFault::SecondOutside:
        case CandidateFault::SpinOutside: return "is beyond a limit";
        case CandidateFault::OnlyLongWay: return "is there by the longer way only";
        case CandidateFault::OtherConfiguration: return "is not on the great circle";
        case CandidateFault::LimitOnTheWay: return "is behind a limit on the way";
    }
    return "is not possible";
}

std::string words_of(const Chain& chain, const machine::PathRefusal& refusal) {
    std::string words;
    for (const machine::CandidateRefusal& refused : refusal.configurations) {
        if (refused.fault == machine::CandidateFault::NoSolution) continue;
        if (!words.empty()) words += "; ";
        words += kAxisNames[index(chain.joints[refused.joint].axis)];
        words += " at " + degrees(refused.value) + "° ";
        words += words_of(refused.fault);
    }
    return words;
}

}  // namespace

Vec3 Executor::joints_of(const AxisValues& base) const {
    Vec3 joints = Vec3::Zero();
    const Chain& chain = machine_.kinematics->chain;
    for (std::size_t k = 0; k < machine::kJoints; ++k) {
        if (chain.has(k))
            joints[static_cast<Eigen::Index>(k)] = rad_from_deg(base[index(chain.joints[k].axis)]);
    }
    return joints;
}

AxisMask Executor::joint_axes() const {
    AxisMask axes = 0;
    for (const machine::RotaryJoint& joint : machine_.kinematics->chain.joints)
        if (joint.is_present) axes = static_cast<AxisMask>(axes | bit(joint.axis));
    return axes;
}

/// Where the axes of the machine stand.
AxisValues Executor::machine_axes() const {
    AxisValues axes = position_.base;
    if (virtual_.axes.is_on()) {
        const Vec3 real = path::real_place(virtual_.axes, linear(axes));
        for (std::size_t k = 0; k < 3; ++k) axes[k] = real[static_cast<Eigen::Index>(k)];
    }
    for (std::size_t k = 0; k < kAxes; ++k) axes[k] += length_shift_[k];
    if (!orienting_.is_on) return axes;
    const machine::ChainPosition position{
        Vec3::Zero(), {axes[6], axes[7], axes[8]}, joints_of(axes)};
    const Vec3 xyz =
        machine::inverse_linear(machine_.kinematics->chain, linear(axes), position, -tool_.lengths);
    for (std::size_t k = 0; k < 3; ++k) axes[k] = xyz[static_cast<Eigen::Index>(k)];
    return axes;
}

/// The axes stay where they are; what changes is the system in which the tip is said. S 7.1.
void Executor::switch_transformation(const Block& block, const nc::Invocation& invocation) {
    const bool is_wanted = invocation.function == Function::TcpOn;
    if (is_wanted && !machine_.kinematics) {
        report(diag::NoTransformation, block, invocation.function).arg(machine_.name);
        return;
    }
    if (is_wanted == orienting_.is_on) return;
    if (comp_.side != Function::RadiusCompOff) {
        report(diag::TransformationComp, block, invocation.function)
            .arg(nc::info(invocation.function).name);
        return;
    }
    if (tool_.has_changed) activate_length(block, kLinearXYZ);
    const AxisValues axes = machine_axes();
    orienting_.is_on = is_wanted;
    Vec3 tip = linear(axes) - tool_.lengths;
    if (is_wanted) {
        const machine::ChainPosition position{
            linear(axes), {axes[6], axes[7], axes[8]}, joints_of(axes)};
        tip = machine::forward(machine_.kinematics->chain, position, -tool_.lengths).tip;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        length_shift_[i] = is_wanted ? 0 : tool_.lengths[at];
        position_.base[i] = tip[at];
    }
    position_.here = position_.programmed = frames_.from_base(position_.base);
    came_from_ = tip;
}

void Executor::take_orientation(const Block& block, const nc::Invocation& invocation,
                                Actions& actions) {
    if (!orienting_.is_on) {
        report(diag::OrientationAlone, block, invocation.function)
            .arg(nc::info(invocation.function).name);
        return;
    }
    const auto part = static_cast<std::size_t>(block.argument(invocation, 0));
    if (part > 2) return;  // no form says it
    const double value = block.argument(invocation, 1);
    const bool is_vector = invocation.function == Function::ToolVector;
    (is_vector ? actions.tool_vector : actions.tool_angles)[part] = value;
    std::uint8_t& said = is_vector ? actions.vector_parts : actions.angle_parts;
    said = static_cast<std::uint8_t>(said | 1u << part);
}

bool Executor::turns_in_two_ways(const Block& block, const Actions& actions) {
    const bool has_axes = (block.given & joint_axes()) != 0;
    const bool has_vector = actions.vector_parts != 0;
    const bool has_angles = actions.angle_parts != 0;
    const DiagnosticRow* row = has_vector && has_angles ? &diag::OrientVectorAngles
                               : has_vector && has_axes ? &diag::OrientVectorAxes
                               : has_angles && has_axes ? &diag::OrientAnglesAxes
                                                        : nullptr;
    if (row == nullptr) return false;
    report(*row, block, has_vector ? Function::ToolVector : Function::ToolAngle);
    return true;
}

/// The direction that the block's words say, in the base system; nothing if it was reported.
std::optional<Vec3> Executor::wanted_direction(const Block& block, const Actions& actions) {
    Vec3 said(actions.tool_vector.data());
    if (actions.angle_parts != 0) {
        const Vec3 angles = Vec3(actions.tool_angles.data()) * (std::numbers::pi / 180);
        machine::Mat3 rotation;
        switch (orienting_.angles) {
            case Function::AnglesRpy: rotation = machine::rpy_zyx(angles); break;
            case Function::AnglesXyz: rotation = machine::rpy_xyz(angles); break;
            default: rotation = machine::euler_zxz(angles); break;
        }
        said = rotation * Vec3::UnitZ();
    }
    if (!orienting_.is_in_base && !frames_.is_shift()) {
        const Vec3 origin = linear(frames_.to_base({}));
        // Scales stretch places, not directions.
        Vec3 turned = Vec3::Zero();
        for (std::size_t i = 0; i < 3; ++i) {
            AxisValues unit{};
            unit[i] = 1;
            turned += said[static_cast<Eigen::Index>(i)] *
                      (linear(frames_.to_base(unit)) - origin).normalized();
        }
        said = turned;
    }
    const auto direction = machine::unit_of(said);
    if (direction) return *direction;
    report(diag::OrientationZero, block, Function::ToolVector);
    return std::nullopt;
}

/// What the block says of the tool, as rotary positions at its end and a way there. False: it was
/// reported.
bool Executor::orient(const Block& block, const Actions& actions, Target& target) {
    // Every axis may move, whatever the block names.
    target.moved = static_cast<AxisMask>(target.moved | kLinearXYZ | joint_axes());
    next_turn_ = {};
    if (actions.orients()) {
        if (turns_in_two_ways(block, actions)) return false;
        const std::optional<Vec3> to = wanted_direction(block, actions);
        if (!to || !lay_turn(block, *to, target)) return false;
    }
    next_turn_.direction = machine::tool_vector(machine_.kinematics->chain, joints_of(target.base));
    return true;
}

bool Executor::lay_turn(const Block& block, const Vec3& to, Target& target) {
    const Chain& chain = machine_.kinematics->chain;
    const Vec3 joints = joints_of(position_.base);
    const Vec3 from = machine::tool_vector(chain, joints);
    if ((to - from).norm() < kSameDirection) return true;
    machine::PathQuery query = machine::query_for(chain, to);
    query.start = joints;
    query.rule = machine_.kinematics->rule;
    query.pole_tolerance = machine_.kinematics->pole_tolerance;
    const bool is_plane = orienting_.turning == Function::TurnPlane;
    query.mode = is_plane ? machine::PathMode::Vector : machine::PathMode::Axis;
    for (std::size_t k = 0; k < machine::kJoints; ++k) {
        if (!chain.has(k)) continue;
        const std::size_t i = index(chain.joints[k].axis);
        query.limits[k] = {rad_from_deg(lower_[i]), rad_from_deg(upper_[i])};
    }
    const auto arc = machine::great_circle(from, to);
    if (is_plane && !arc) {
        report(diag::OrientationOpposite, block);
        return false;
    }
    const auto end = machine::choose_path(chain, query);
    if (!end) {
        const machine::PathRefusal& refusal = end.error();
        if (refusal.fault == machine::PathFault::Unreachable) {
            report(diag::OrientationBeyond, block)
                .arg(chain.orients() ? "the direction is outside of the reach of its rotary axes"
                                     : "it has one rotary axis, which does not lead there");
        } else {
            report(diag::OrientationNoWay, block).arg(words_of(chain, refusal));
        }
        return false;
    }
    for (std::size_t k = 0; k < machine::kJoints; ++k) {
        if (!chain.has(k)) continue;
        const std::size_t i = index(chain.joints[k].axis);
        const double shift = frames_.shift_values()[i];
        target.base[i] = deg_from_rad(end->rotary[static_cast<Eigen::Index>(k)]);
        target.here[i] = target.base[i] - shift;
    }
    if (end->mode == machine::PathMode::Vector) {
        next_turn_.turning = Turning::Cone;
        next_turn_.axis = arc->axis;
        next_turn_.angle = arc->turn;
    }
    return true;
}

/// A motion under the transformation: the turn that waits, or the axes as they are programmed.
void Executor::put_turn(Command& command) {
    if (!path::is_motion(command.op)) return;
    if (virtual_.axes.is_on()) {
        command.turning = Turning::Axes;
        command.virtual_axes = virtual_.axes;
        return;
    }
    command.turning = std::exchange(next_turn_.turning, Turning::Axes);
    command.direction = next_turn_.direction;
    command.turn_axis = next_turn_.axis;
    command.turn_angle = next_turn_.angle;
}

}  // namespace kadr::interp
