// orienting.cpp — the machine's transformation: switched on and off, and where the axes stand.
//
// Tool orientation under it is tool_words.cpp's and tool_orientation.cpp's matter; where the axes
// go on the path motion's (motion/transformed.h).
#include <bit>
#include <string>
#include <utility>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "base/units.h"
#include "interp/block_words.h"
#include "interp/channel.h"
#include "interp/compensated_orientation.h"
#include "interp/motions.h"
#include "interp/tilted_planes.h"
#include "interp/tool_in_use.h"
#include "interp/transformation.h"
#include "machine/kinematics.h"
#include "nc/parameters.h"
#include "path/linear.h"
#include "write/spelling.h"

namespace kadr::interp {

using machine::Chain;
using nc::Block;
using nc::Function;
using nc::parameter_of;
using nc::parameter_of_all;
using nc::SlotMask;
using path::linear;
using path::Vec3;

namespace {

/// The joints of one side of the machine; those of the other stand at 0.
Vec3 joints_on(const Chain& chain, machine::ChainSide side, const Vec3& joints) {
    Vec3 found = Vec3::Zero();
    for (std::size_t k = 0; k < machine::kJoints; ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        if (chain.joints[k].side == side) found[i] = joints[i];
    }
    return found;
}

/// From where the table stands into the workpiece.
path::Frame table_frame(const Chain& chain, const Vec3& joints) {
    machine::ChainPosition position;
    position.rotary = joints_on(chain, machine::ChainSide::Table, joints);
    const auto place_of = [&](const Vec3& linear) {
        position.linear = linear;
        return machine::forward(chain, position, Vec3::Zero()).tip;
    };
    path::Frame frame;
    frame.shift = place_of(Vec3::Zero());
    for (Eigen::Index i = 0; i < 3; ++i)
        frame.linear.col(i) = place_of(Vec3::Unit(i)) - frame.shift;
    return frame;
}

/// `0, 0, 1`
std::string written_direction(const Vec3& direction) {
    constexpr int kDecimals = 4;
    std::string out;
    for (const double component : direction) {
        if (!out.empty()) out += ", ";
        append_shortest(out, round_to(component, kDecimals));
    }
    return out;
}

}  // namespace

Transformation::Transformation(Channel& channel)
    : channel_(channel),
      dialect_(channel.state.dialect),
      machine_(channel.state.machine),
      work_offset_(channel.state.frame.work_offset),
      reporter_(channel.state.reporter),
      rules_(channel.state.rules),
      modal_(channel.state.motion.modal),
      position_(channel.state.motion.position),
      frames_(channel.state.frame.frames),
      tool_(channel.state.tool.tool),
      orienting_(channel.state.tool.orienting),
      tilted_plane_(channel.state.tool.tilted_plane),
      virtual_(channel.state.tool.virtual_axes),
      comp_(channel.state.stage.comp),
      reported_(channel.state.reported),
      length_shift_(channel.state.motion.length_shift) {}

Vec3 Transformation::joints_of(const AxisValues& base) const {
    return joints_at(machine_.kinematics->chain, base);
}

std::array<std::size_t, 2> Transformation::joints_in_order() const {
    const Chain& chain = machine_.kinematics->chain;
    const bool both_on_head = chain.joints[machine::kR1].side == machine::ChainSide::Head;
    if (both_on_head || !chain.has(machine::kR2)) return {machine::kR1, machine::kR2};
    return {machine::kR2, machine::kR1};
}

AxisMask Transformation::joint_axes() const {
    AxisMask axes = 0;
    for (const machine::RotaryJoint& joint : machine_.kinematics->chain.joints)
        if (joint.is_present) axes = static_cast<AxisMask>(axes | bit(joint.axis));
    return axes;
}

AxisValues Transformation::machine_axes() const { return machine_axes_at(position_.base()); }

AxisValues Transformation::machine_axes_at(const AxisValues& base) const {
    AxisValues axes = base;
    if (virtual_.axes.is_on()) {
        const Vec3 real = path::real_position(virtual_.axes, linear(axes));
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

Done Transformation::require_transformation(const Block& block, const nc::Invocation& invocation) {
    constexpr double kSameVector = 1e-4;  // rad; components are written with four digits
    constexpr std::size_t kNumber = parameter_of<Function::TcpBased>("number");
    constexpr std::size_t kX = parameter_of<Function::TcpBased>("x");
    constexpr std::size_t kOffsets = parameter_of<Function::TcpBased>("first");
    if (!machine_.kinematics) return kDone;  // which is reported where it is switched on
    const Function function = invocation.function;
    const double number = block.argument(invocation, kNumber, 1);
    if (number != 1) {
        reporter_.report(diag::TransformationNumber, block, function, kNumber)
            .arg(number)
            .arg(machine_.name);
        return kFailed;
    }
    const Vec3 programmed(block.argument(invocation, kX), block.argument(invocation, kX + 1),
                          block.argument(invocation, kX + 2));
    if ((invocation.given >> kX & 7u) != 0) {
        const auto direction = machine::unit_of(programmed);
        const Vec3& own = machine_.kinematics->chain.tool_direction;
        if (!direction) {
            reporter_.report(diag::OrientationZero, block, function, kX);
            return kFailed;
        }
        if ((*direction - own).norm() > kSameVector) {
            reporter_.report(diag::BaseDirection, block, function, kX)
                .arg(written_direction(programmed))
                .arg(written_direction(own));
            return kFailed;
        }
    }
    for (std::size_t i = kOffsets; i < kOffsets + 2; ++i) {
        const double offset = block.argument(invocation, i);
        if (offset == 0) continue;
        reporter_.report(diag::RotaryOffset, block, function, i).arg(offset);
        return kFailed;
    }
    return kDone;
}

void Transformation::switch_transformation(const Block& block, const nc::Invocation& invocation) {
    const bool is_wanted = invocation.function != Function::TcpOff;
    if (is_wanted && !machine_.kinematics) {
        reporter_.report(diag::NoTransformation, block, invocation.function).arg(machine_.name);
        return;
    }
    if (is_wanted == orienting_.is_on || !require_no_spline(block, invocation.function)) return;
    if (comp_.is_on()) {
        reporter_.report(diag::TransformationComp, block, invocation.function)
            .arg(reporter_.word_of(block, invocation.function));
        return;
    }
    if (tool_.has_changed) channel_.tool.activate_length(block, kLinearXYZ);
    channel_.tilted_planes.drop_carry(block);
    const AxisValues axes = machine_axes();
    orienting_.is_on = is_wanted;
    orienting_.configuration = 0;
    const bool has_frame =
        work_offset_ != 0 || !frames_.is_shift() || frames_.shift_values() != AxisValues{};
    orienting_.owes_offset = is_wanted && rules_.transformation_wants_offset && has_frame &&
                             block.find(Function::WorkOffset) == nullptr;
    Vec3 tip = linear(axes) - tool_.lengths;
    if (is_wanted) {
        const machine::ChainPosition position{
            linear(axes), {axes[6], axes[7], axes[8]}, joints_of(axes)};
        tip = machine::forward(machine_.kinematics->chain, position, -tool_.lengths).tip;
    }
    channel_.tool.set_length_shift(is_wanted ? Vec3(Vec3::Zero()) : tool_.lengths);
    take_position(path::with_linear(position_.base(), tip));
    if (!is_wanted && tilted_plane_.is_on)
        channel_.tilted_planes.carry(block, joints_of(position_.base()));
}

Done Transformation::require_no_spline(const Block& block, Function function) {
    if (!nc::has_fact(modal_.motion, nc::Fact::SplineMotion)) return kDone;
    reporter_.report(diag::TransformationSpline, block, function)
        .arg(reporter_.word_of(block, function));
    return kFailed;
}

Done Transformation::require_no_lone_axis(const Block& block, SlotMask targets) {
    const auto moved = static_cast<AxisMask>(targets & kLinearXYZ);
    // Where a transformation is a kind of length compensation a rapid is one like any other.
    if (moved == 0 || !is_transformed() || orienting_.has_length) return kDone;
    const auto first = static_cast<std::size_t>(std::countr_zero(moved));
    reporter_.report(diag::TransformationAxis, block, nc::slot_of(static_cast<Axis>(first)))
        .arg(kAxisNames[first]);
    return kFailed;
}

// ------------------------------------------------------------------------------ with a length

void Transformation::begin_length_transformation(const Block& block,
                                                 const nc::Invocation& invocation,
                                                 Actions& actions) {
    if (!machine_.kinematics) {
        reporter_.report(diag::NoTransformation, block, invocation.function).arg(machine_.name);
        return;
    }
    if (comp_.is_on()) {
        reporter_.report(diag::TransformationComp, block, invocation.function)
            .arg(reporter_.word_of(block, invocation.function));
        return;
    }
    orienting_.takes_vectors = invocation.function == Function::TcpVector;
    constexpr std::size_t kOffset =
        parameter_of_all<"offset", Function::TcpLength, Function::TcpVector>();
    constexpr std::size_t kPlane =
        parameter_of_all<"plane", Function::TcpLength, Function::TcpVector>();
    orienting_.interpolation = block.argument(invocation, kPlane) == 1 ? OrientInterpolation::Plane
                                                                       : OrientInterpolation::Axes;
    orienting_.lead = orienting_.takes_vectors
                          ? block.argument(invocation, parameter_of<Function::TcpVector>("lead"))
                          : 0;
    const bool was_on = orienting_.is_on;
    if (!was_on) {
        orienting_.is_on = orienting_.has_length = true;
        if (rules_.tcp_as_table_stands) {
            // Where the rotary axes go in this block counts as where they stand.
            const auto rotary = static_cast<nc::SlotMask>(block.given & joint_axes());
            const Vec3 joints =
                joints_of(channel_.motions.motion_words().target_of(block, rotary).base);
            frames_.set_table(table_frame(machine_.kinematics->chain, joints));
        }
        position_.keep_coordinates(frames_);
        channel_.tool.set_length_shift(Vec3::Zero());
    }
    channel_.tool.add_length();
    if (invocation.has(kOffset))
        channel_.tool.choose_offset(std::llround(block.argument(invocation, kOffset)));
    channel_.tool.set_length_source(Tool::Source::Offset, actions);
    actions.switches_length = !was_on || channel_.tool.wanted_lengths() != tool_.lengths;
}

void Transformation::choose(Function member) {
    switch (nc::group_of(member)) {
        case nc::Group::OrientInterpolation:
            orienting_.interpolation = orient_interpolation_of(member);
            break;
        case nc::Group::OrientAngles:
            orienting_.angles = tool_angles_of(member);
            if (member == Function::AnglesEuler || member == Function::AnglesZyz)
                orienting_.euler = orienting_.angles;
            break;
        case nc::Group::OrientSystem:
            orienting_.is_in_base = member == Function::OrientInBase;
            break;
        case nc::Group::Spinning: orienting_.spin = spin_from_of(member); break;
        default: break;  // no other is sent here
    }
}

void Transformation::choose_point_to_point(Function function) {
    orienting_.point_to_point = point_to_point_of(function);
}

/// The axes stand; the tip has another position in the base system.
void Transformation::take_position(const AxisValues& base) {
    position_.stand_at(base);
    position_.see_in(frames_);
    position_.name();
    position_.come_from(linear(base));
}

void Transformation::end_length_transformation(Actions& actions) {
    const Chain& chain = machine_.kinematics->chain;
    const AxisValues axes = machine_axes();
    const Vec3 head = joints_on(chain, machine::ChainSide::Head, joints_of(axes));
    const Vec3 length = rules_.length_moves_alone
                            ? Vec3(machine::rotation_of(chain, head) * tool_.lengths)
                            : tool_.lengths;
    orienting_.is_on = orienting_.has_length = orienting_.takes_vectors = false;
    orienting_.lead = 0;
    frames_.release_table();
    channel_.tool.set_length_shift(tool_.lengths);
    take_position(path::with_linear(axes, linear(axes) - length));
    actions.switches_length = true;
}

void Transformation::check_offset_programmed(const Block& block) {
    if (!std::exchange(orienting_.owes_offset, false)) return;
    if (!reported_.first_time(RunNotice::WorkOffset)) return;
    DiagnosticBuilder warning = reporter_.report(diag::TransformationOffset, block);
    const std::string offset = write::spelling_of_offset(dialect_, work_offset_);
    if (!offset.empty()) warning.fix("say it there: `" + offset + "`");
}

Done Transformation::require_allowed_under_tcp(const Block& block, Function function) {
    if (!orienting_.has_length || block.is_of_cycle()) return kDone;
    const bool is_peripheral = comp_.is_on() && comp_.is_peripheral_code;
    if (is_peripheral && nc::info(function).group == nc::Group::LengthComp) {
        reporter_.report(diag::SideCompOrder, block, function)
            .arg(reporter_.word_of(block, function));
        return kFailed;
    }
    if (!nc::has_fact(function, nc::Fact::AlarmUnderTcpLength)) return kDone;
    reporter_.report(diag::TcpForbidden, block, function).arg(reporter_.word_of(block, function));
    return kFailed;
}

}  // namespace kadr::interp
