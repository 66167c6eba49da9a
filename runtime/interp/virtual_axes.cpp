// virtual_axes.cpp — programs of polar, cylindrical and inclined-axis coordinates:
// how that begins and ends, what its words mean, and where the rotary axis stands behind a motion.
//
// The commands are in the virtual coordinates (path/virtual_axes.h); the axes on the path are
// motion's.
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "base/units.h"
#include "interp/channel.h"
#include "interp/cornering.h"
#include "interp/executor.h"
#include "interp/radius_compensation.h"
#include "interp/stages.h"
#include "interp/tool_in_use.h"
#include "interp/transformation.h"
#include "interp/virtual_plane.h"
#include "path/curve_of.h"
#include "path/linear.h"
#include "path/polar_passages.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using nc::Slot;
using path::Command;
using path::linear;
using path::Plane;
using path::set_linear;
using path::Vec3;
using path::VirtualAxes;
using path::VirtualKind;

namespace {

/// A real axis may stand so far beside the axis of rotation, mm: half an increment.
constexpr double kBeside = 0.0005;
/// … and the rotary axis so far beside 0, deg.
constexpr double kAtZero = 0.0005;
/// Turning by less at the pole is rounding, rad.
constexpr double kSameTurn = 1e-6;

/// Linear axis along which a rotary one turns.
Axis axis_along(Axis rotary) {
    switch (rotary) {
        case Axis::A: return Axis::X;
        case Axis::B: return Axis::Y;
        default: return Axis::Z;
    }
}

/// The plane of the developed cylinder in the virtual coordinates.
Plane plane_of_cylinder(const VirtualAxes& axes) {
    return axes.rotary == Axis::C ? Plane::Yz : Plane::Xy;
}

/// Where the rotary axis counts as the axis around, the plane is programmed with it as X, Y or Z
/// (No.1022). One of the two ways to program it has both axes in the other order.
bool is_turned_over(const VirtualAxes& axes, Plane programmed) {
    if (axes.kind != VirtualKind::Cylinder) return false;
    return programmed == (axes.rotary == Axis::B ? Plane::Yz : Plane::Zx);
}

Function turned_over(Function function) {
    switch (function) {
        case Function::ArcCw: return Function::ArcCcw;
        case Function::ArcCcw: return Function::ArcCw;
        case Function::RadiusCompLeft: return Function::RadiusCompRight;
        case Function::RadiusCompRight: return Function::RadiusCompLeft;
        default: return function;
    }
}

std::optional<Plane> plane_selected_by(Function function) {
    switch (function) {
        case Function::PlaneXy: return Plane::Xy;
        case Function::PlaneZx: return Plane::Zx;
        case Function::PlaneYz: return Plane::Yz;
        default: return std::nullopt;
    }
}

/// F 3.6: what a control takes that takes little there.
bool stands_there(Function function, VirtualKind kind) {
    if (nc::has_fact(function, nc::Fact::UnderVirtualAxes)) return true;
    switch (function) {
        case Function::TcpOff: return kind == VirtualKind::Polar;
        case Function::CylindricalInterpolationOn: return kind == VirtualKind::Cylinder;
        default: return kind == VirtualKind::Cylinder && plane_selected_by(function).has_value();
    }
}

/// The word that ends it.
Function ending_function(VirtualKind kind) {
    switch (kind) {
        case VirtualKind::Cylinder: return Function::CylindricalInterpolationOn;
        case VirtualKind::Inclined: return Function::InclinedAxisOn;
        case VirtualKind::Polar:
        case VirtualKind::None: break;
    }
    return Function::TcpOff;
}

}  // namespace

// ------------------------------------------------------------------------------ begin and end

VirtualPlane::VirtualPlane(Channel& channel)
    : channel_(channel),
      dialect_(channel.state.dialect),
      machine_(channel.state.machine),
      reporter_(channel.state.reporter),
      rules_(channel.state.rules),
      output_(channel.state.stage.output),
      modal_(channel.state.motion.modal),
      position_(channel.state.motion.position),
      frames_(channel.state.frame.frames),
      tool_(channel.state.tool.tool),
      orienting_(channel.state.tool.orienting),
      virtual_(channel.state.tool.virtual_axes),
      comp_(channel.state.stage.comp),
      compensation_(channel.state.stage.compensation),
      units_(channel.state.motion.units),
      axes_(channel.state.axes) {}

void VirtualPlane::begin_virtual(const Block& block, const Invocation& invocation) {
    constexpr std::size_t kRadius = parameter_of<Function::CylindricalInterpolationOn>("radius");
    const bool ends_cylinder = invocation.function == Function::CylindricalInterpolationOn &&
                               invocation.has(kRadius) && block.argument(invocation, kRadius) == 0;
    if (ends_cylinder) {
        if (virtual_.axes.kind == VirtualKind::Cylinder) return end_virtual(block);
        reporter_.report(diag::CylinderWrong, block, invocation.function)
            .arg("radius 0")
            .arg("it ends cylindrical interpolation, and none has begun");
        return;
    }
    if (rules_.virtual_is_narrow && virtual_.axes.is_on())
        return refuse_virtual(block, invocation.function);
    if (comp_.is_on()) {
        reporter_.report(diag::VirtualComp, block, invocation.function);
        return;
    }
    if (!channel_.transformation.require_no_spline(block, invocation.function)) return;
    end_virtual(block);
    channel_.cornering.leave_corners(diag::CornerWithoutMotion);
    if (reporter_.has_ended()) return;
    if (orienting_.is_on) channel_.transformation.switch_transformation(block, {Function::TcpOff});
    if (reporter_.has_ended()) return;
    if (tool_.has_changed) channel_.tool.activate_length(block, kLinearXYZ);
    if (compensation_.is_on()) channel_.compensation.flush_comp();
    const std::optional<VirtualAxes> axes = wanted_virtual(block, invocation);
    if (!axes) return;
    virtual_.axes = *axes;
    virtual_.by_rotary = rules_.virtual_by_rotary && axes->turns();
    virtual_.plane_before = modal_.plane;
    if (virtual_.by_rotary) put_virtual_plane(modal_.plane);
    rotary_.tip = path::virtual_position(*axes, linear(position_.base()), virtual_angle());
    rotary_.at = virtual_angle();
    follow_from_here();
    take_virtual_position(rotary_.tip);
}

void VirtualPlane::end_virtual(const Block& block) {
    if (!virtual_.axes.is_on()) return;
    if (comp_.is_on()) {
        reporter_.report(diag::VirtualComp, block, ending_function(virtual_.axes.kind));
        return;
    }
    channel_.cornering.leave_corners(diag::CornerWithoutMotion);
    if (!reporter_.has_ended() && compensation_.is_on()) channel_.compensation.flush_comp();
    if (!reporter_.has_ended()) follow_rotary();
    if (reporter_.has_ended()) return;
    const Virtual was = std::exchange(virtual_, {});
    if (was.by_rotary) {
        modal_.plane = was.plane_before;
        if (was.is_turned_over) modal_.move_by(turned_over(modal_.motion));
    }
    take_virtual_position(path::real_position(was.axes, linear(position_.base())));
}

/// The axes stand; their positions get other coordinates.
void VirtualPlane::take_virtual_position(const Vec3& point) {
    channel_.transformation.take_position(path::with_linear(position_.base(), point));
}

/// Where the rotary axis stands, rad.
double VirtualPlane::virtual_angle() const {
    return rad_from_deg(position_.base()[index(virtual_.axes.rotary)]);
}

std::optional<VirtualAxes> VirtualPlane::wanted_virtual(const Block& block,
                                                        const Invocation& invocation) {
    switch (invocation.function) {
        case Function::PolarInterpolationOn: return wanted_polar_interpolation(block);
        case Function::CylindricalInterpolationOn: return wanted_cylinder(block, invocation);
        default: return wanted_inclined(block, invocation);
    }
}

std::optional<VirtualAxes> VirtualPlane::wanted_polar_interpolation(const Block& block) {
    const auto refuse = [&](std::string_view why) {
        reporter_.report(diag::FaceUnavailable, block, Function::PolarInterpolationOn)
            .arg(machine_.name)
            .arg(why);
        return std::nullopt;
    };
    constexpr AxisMask kNeeded = bit(Axis::X) | bit(Axis::Z) | bit(Axis::C);
    if ((axes_.present & kNeeded) != kNeeded) return refuse("it needs the axes X, Z and C");
    VirtualAxes axes;
    axes.kind = VirtualKind::Polar;
    const double angle = position_.base()[index(Axis::C)];
    if (machine_.kinematics) {
        for (const machine::RotaryJoint& joint : machine_.kinematics->chain.joints) {
            if (!joint.is_present || joint.axis != Axis::C) continue;
            const bool is_along_z = std::abs(joint.direction.z()) > 1 - kSameTurn;
            if (joint.side != machine::ChainSide::Table || !is_along_z)
                return refuse("its C does not turn the part about Z");
            axes.center_x = joint.point.x();
            axes.center_y = joint.point.y();
            axes.sign = joint.sign * joint.direction.z() < 0 ? -1 : 1;
        }
    }
    if (rules_.virtual_from_program) {
        axes.center_x = frames_.shift_values()[0];
        axes.center_y = frames_.shift_values()[1];
        axes.zero = rad_from_deg(angle);
        if (const double programmed = position_.here()[index(Axis::C)];
            std::abs(std::remainder(programmed, 360)) > kAtZero)
            reporter_.report(diag::FaceStart, block, Function::PolarInterpolationOn)
                .arg("C")
                .arg(round_to(programmed, 4));
    }
    if ((axes_.present & bit(Axis::Y)) != 0) {
        const double beside = position_.base()[1] - axes.center_y;
        if (std::abs(beside) > kBeside)
            return refuse("Y stands " + format_shortest(round_to(beside, 4)) +
                          " mm beside the axis of C");
        axes.standing = position_.base()[1];
    }
    axes.side = position_.base()[0] < axes.center_x ? -1 : 1;
    return axes;
}

std::optional<VirtualAxes> VirtualPlane::wanted_cylinder(const Block& block,
                                                         const Invocation& invocation) {
    constexpr std::size_t kRadius = parameter_of<Function::CylindricalInterpolationOn>("radius");
    constexpr std::size_t kDiameter =
        parameter_of<Function::CylindricalInterpolationOn>("diameter");
    const std::int64_t axis = std::llround(
        block.argument(invocation, parameter_of<Function::CylindricalInterpolationOn>("axis")));
    const std::array<Axis, 4> named = {Axis::C, Axis::A, Axis::B, Axis::C};
    VirtualAxes axes;
    axes.kind = VirtualKind::Cylinder;
    axes.rotary = named[static_cast<std::size_t>(std::clamp<std::int64_t>(axis, 0, 3))];
    // Without a word for the axis a machine has one.
    if (axis == 0 && (axes_.present & bit(Axis::C)) == 0)
        axes.rotary = (axes_.present & bit(Axis::A)) != 0 ? Axis::A : Axis::B;
    const AxisMask needed = bit(axes.rotary) | bit(axis_along(axes.rotary));
    if ((axes_.present & needed) != needed) {
        reporter_.report(diag::CylinderUnavailable, block, Function::CylindricalInterpolationOn)
            .arg(machine_.name)
            .arg(axis == 0 ? "it needs a rotary axis, and the linear one along it"
                           : "it needs the axes " + std::string(kAxisNames[index(axes.rotary)]) +
                                 " and " + std::string(kAxisNames[index(axis_along(axes.rotary))]));
        return std::nullopt;
    }
    if (block.argument(invocation, parameter_of<Function::CylindricalInterpolationOn>("walls")) !=
        0) {
        reporter_.report(diag::IsoNotSupported, block, Function::CylindricalInterpolationOn)
            .arg("a cylinder with the width of a groove");
        return std::nullopt;
    }
    axes.size = block.argument(invocation, kRadius, block.argument(invocation, kDiameter) / 2);
    if (!(axes.size > 0)) {
        reporter_.report(diag::CylinderWrong, block, Function::CylindricalInterpolationOn)
            .arg("radius " + format_shortest(round_to(axes.size, 6)))
            .arg("it must be above 0");
        return std::nullopt;
    }
    const std::size_t around = index(axes.virtual_axis());
    axes.standing = position_.base()[around];
    if (rules_.virtual_from_program) {
        axes.zero = rad_from_deg(frames_.shift_values()[index(axes.rotary)]);
        axes.center_y = frames_.shift_values()[around];
    }
    return axes;
}

std::optional<VirtualAxes> VirtualPlane::wanted_inclined(const Block& block,
                                                         const Invocation& invocation) {
    constexpr AxisMask kNeeded = bit(Axis::X) | bit(Axis::Z);
    if ((axes_.present & kNeeded) != kNeeded) {
        reporter_.report(diag::InclinedUnavailable, block, Function::InclinedAxisOn)
            .arg(machine_.name)
            .arg("it needs the axes X and Z");
        return std::nullopt;
    }
    constexpr std::size_t kAngle = parameter_of<Function::InclinedAxisOn>("angle");
    const double angle = block.argument(invocation, kAngle, 90);
    if (!(std::abs(angle) < 90)) {
        reporter_.report(diag::InclinedAngle, block, Function::InclinedAxisOn)
            .arg(invocation.has(kAngle) ? format_shortest(angle) + "°" : "not given");
        return std::nullopt;
    }
    VirtualAxes axes;
    axes.kind = VirtualKind::Inclined;
    axes.size = rad_from_deg(angle);
    return axes;
}

// ------------------------------------------------------------------------------ words

void VirtualPlane::refuse_virtual(const Block& block, Function function) {
    const bool is_face = virtual_.axes.kind == VirtualKind::Polar;
    reporter_.report(is_face ? diag::FaceWord : diag::CylinderWord, block, function)
        .arg('`' + reporter_.word_of(block, function) + '`');
}

void VirtualPlane::refuse_virtual(const Block& block, Slot slot) {
    const bool is_face = virtual_.axes.kind == VirtualKind::Polar;
    reporter_.report(is_face ? diag::FaceWord : diag::CylinderWord, block, slot)
        .arg("the word " + std::string(nc::slot_name(slot)));
}

/// The control takes the block there.
Done VirtualPlane::require_virtual_words(const Block& block) {
    if (!rules_.virtual_is_narrow) return kDone;
    const VirtualKind kind = virtual_.axes.kind;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        if (stands_there(block.functions[i].function, kind)) continue;
        refuse_virtual(block, block.functions[i].function);
        return kFailed;
    }
    const bool moves = (block.given & nc::kTargetSlots) != 0;
    const Function motion = block.motion != Function::None ? block.motion
                            : moves                        ? modal_.motion
                                                           : Function::Line;
    if (!stands_there(motion, kind)) {
        if (block.motion != Function::None) {
            refuse_virtual(block, motion);
        } else {
            reporter_
                .report(kind == VirtualKind::Polar ? diag::FaceWord : diag::CylinderWord, block)
                .arg('`' + reporter_.word_of(block, motion) + '`');
        }
        return kFailed;
    }
    const nc::SlotMask centers = block.given & nc::kCenterSlots;
    if (kind == VirtualKind::Cylinder && centers != 0) {
        refuse_virtual(block, static_cast<Slot>(std::countr_zero(centers)));
        return kFailed;
    }
    return kDone;
}

/// The word of the rotary axis as the one of the coordinate around.
Done VirtualPlane::take_rotary_word(const Block& block) {
    const Slot word = nc::slot_of(virtual_.axes.rotary);
    const Slot around = nc::slot_of(virtual_.axes.virtual_axis());
    if (block.has(around)) {
        refuse_virtual(block, around);
        return kFailed;
    }
    if (!block.has(word)) return kDone;
    const bool is_face = virtual_.axes.kind == VirtualKind::Polar;
    const ProgrammedUnits power_on = units_of(dialect_.power_on(nc::Group::Units));
    const bool is_inch =
        (units_ != ProgrammedUnits::Unsaid ? units_ : power_on) == ProgrammedUnits::Inch;
    const double factor =
        is_face ? (is_inch ? kMmPerInch : 1) : virtual_.axes.size * std::numbers::pi / 180;
    const bool is_distance = (block.incremental & bit(word)) != 0;
    const bool is_place = (block.absolute & bit(word)) != 0;
    for (nc::SlotMask* mask : {&around_.given, &around_.incremental, &around_.absolute})
        *mask &= ~bit(word);
    around_.set(around, block.at(word) * factor);
    if (is_distance) around_.incremental |= bit(around);
    if (is_place) around_.absolute |= bit(around);
    around_.rotary_approaches = 0;
    return kDone;
}

const Block* VirtualPlane::in_virtual(const Block& block) {
    if (!channel_.executor.acts(block)) return &block;
    if (!require_virtual_words(block)) return nullptr;
    if (!virtual_.by_rotary) return &block;
    around_ = block;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        if (const auto plane = plane_selected_by(block.functions[i].function)) {
            virtual_.plane_before = *plane;
            put_virtual_plane(*plane);
            around_.functions[i].function =
                modal_.plane == Plane::Yz ? Function::PlaneYz : Function::PlaneXy;
        }
    }
    if (!take_rotary_word(block)) return nullptr;
    if (!virtual_.is_turned_over) return &around_;
    around_.motion = turned_over(around_.motion);
    for (std::size_t i = 0; i < around_.function_count; ++i)
        around_.functions[i].function = turned_over(around_.functions[i].function);
    return &around_;
}

/// The plane is that of the end face or of the developed cylinder, however it is programmed.
void VirtualPlane::put_virtual_plane(Plane programmed) {
    const bool is_over = is_turned_over(virtual_.axes, programmed);
    if (is_over != virtual_.is_turned_over) modal_.move_by(turned_over(modal_.motion));
    virtual_.is_turned_over = is_over;
    modal_.plane =
        virtual_.axes.kind == VirtualKind::Polar ? Plane::Xy : plane_of_cylinder(virtual_.axes);
}

// ------------------------------------------------------------------------------ the rotary axis

void VirtualPlane::follow_from_here() {
    rotary_.followed = output_.written() + output_.waiting().size();
}

void VirtualPlane::follow_rotary() {
    if (!virtual_.axes.turns()) return;
    const std::size_t count = output_.written() + output_.waiting().size();
    const std::size_t axis = index(virtual_.axes.rotary);
    for (; rotary_.followed < count; ++rotary_.followed) {
        Command& command = output_.any(rotary_.followed);
        if (!command.is_motion()) continue;
        path::Motion& motion = command.motion();
        if (motion.virtual_axes().is_on()) {
            const Vec3 to = linear(motion.to);
            if (!follow_leg_by_leg(command, path::curve_of(motion, rotary_.tip, to))) return;
            rotary_.tip = to;
        }
        motion.to[axis] = deg_from_rad(rotary_.at);
    }
    const double at = deg_from_rad(rotary_.at);
    position_.arrive_on(axis, at - frames_.shift_values()[axis], at);
}

/// Where the control does not go through the pole the command is taken back.
Done VirtualPlane::follow_leg_by_leg(const Command& command, const path::Curve& curve) {
    if (std::holds_alternative<path::Point>(curve)) return kDone;
    for (const path::Curve& leg : path::legs_between_poles(virtual_.axes, curve)) {
        const double leaves_at = path::rotary_to_leave(virtual_.axes, leg, rotary_.at);
        const double by = leaves_at - rotary_.at;
        if (rules_.pole_passage == nc::PolePassage::Alarm && std::abs(by) > kSameTurn) {
            const Block at = channel_.stages.block_at(command.source, command.line);
            output_.drop_from(rotary_.followed);
            reporter_.report(diag::PoleOnPath, at)
                .arg(kAxisNames[index(virtual_.axes.rotary)])
                .arg(round_to(deg_from_rad(by), 3));
            return kFailed;
        }
        rotary_.at = path::rotary_behind(virtual_.axes, leg, leaves_at);
    }
    return kDone;
}

}  // namespace kadr::interp
