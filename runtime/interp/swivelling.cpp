// swivelling.cpp — SINUMERIK's swivelling cycle CYCLE800, and frames along the tool and on the
// tables: TOFRAME, TOROT, PAROT. S 6.4, 6.5.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "base/units.h"
#include "interp/carriers.h"
#include "interp/channel.h"
#include "interp/motions.h"
#include "interp/programmed_frames.h"
#include "interp/tilted_planes.h"
#include "interp/transformation.h"
#include "machine/tilted_plane.h"
#include "path/linear.h"

namespace kadr::interp {

using machine::Mat3;
using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using path::Frame;
using path::linear;
using path::Op;
using path::Vec3;

namespace {

constexpr std::size_t kMode = parameter_of<Function::Swivel>("mode");
constexpr std::size_t kOrigin = parameter_of<Function::Swivel>("x");
constexpr std::size_t kAngles = parameter_of<Function::Swivel>("a");
constexpr std::size_t kShift = parameter_of<Function::Swivel>("x1");

// Kinds of angles: bits 6 and 7 of the mode.
constexpr unsigned kByAxes = 0;
constexpr unsigned kSolid = 1;
constexpr unsigned kProjected = 2;
constexpr unsigned kDirect = 3;

Vec3 three(const Block& block, const Invocation& invocation, std::size_t first) {
    return {block.argument(invocation, first), block.argument(invocation, first + 1),
            block.argument(invocation, first + 2)};
}

/// A digit of a decimal number, the units being the first.
int digit(double number, int index) {
    return static_cast<int>(std::fmod(std::floor(std::abs(number) / std::pow(10, index)), 10));
}

/// X, Y and Z as a frame has rotated them, without its scale and its mirrors.
Mat3 directions(const Mat3& linear) {
    Mat3 result = linear;
    result.colwise().normalize();
    if (result.determinant() < 0) result.col(0) = -result.col(0);
    return result;
}

/// The inverse of a frame that is known to have one.
Frame back_of(const Frame& frame) { return path::inverse(frame).value(); }

}  // namespace

void TiltedPlanes::swivel(const Block& block, const Invocation& invocation) {
    const bool says_none = invocation.given == 0 && block.text.empty();
    if (says_none || block.text == "0") return end_swivel(block);
    const auto refuse = [&](std::string_view what) {
        reporter_.report(diag::SwivelValue, block, Function::Swivel).arg(what);
    };
    if (comp_.is_on()) {
        reporter_.report(diag::TiltCompensated, block, Function::Swivel).arg("CYCLE800");
        return;
    }
    if (!require_rotary_axes(block, Function::Swivel)) return;
    if (modal_.plane != path::Plane::Xy) return refuse("the working plane is not G17");
    const double direction =
        block.argument(invocation, parameter_of<Function::Swivel>("direction"));
    if (direction != -1 && direction != 0 && direction != 1)
        return refuse("_DIR is not -1, 0 or 1");
    const double options = block.argument(invocation, parameter_of<Function::Swivel>("options"));
    if (digit(options, 2) != 0) {
        reporter_.report(diag::IsoNotSupported, block, Function::Swivel)
            .arg("swivelling the tool alone");
        return;
    }
    if (digit(options, 0) > 1 || digit(options, 1) > 1) return refuse("_ST has a digit above 1");
    // The cycle sees to it that no transformation acts: the axes stay, as at TRAFOOF. S 6.5.
    if (orienting_.is_on) channel_.transformation.switch_transformation(block, {Function::TcpOff});
    if (reporter_.has_ended() || !retract_before_swivel(block, invocation)) return;

    // A new plane is programmed in the system of the work offset; one that is added, in the plane
    // so far with all that the program has done in it.
    const Frame outer = digit(options, 0) == 1 ? frames_.inside_tool_frame() : Frame{};
    frames_.set_tool_frame(std::nullopt);
    frames_.set_programmable({});
    frames_.set_tilted_plane(outer);
    const std::optional<Mat3> rotation = swivel_rotation(block, invocation);
    if (!rotation) return;
    frames_.set_tilted_plane(outer * path::translation(three(block, invocation, kOrigin)) *
                             Frame{*rotation, Vec3::Zero()} *
                             path::translation(three(block, invocation, kShift)));
    tilted_plane_.is_on = true;
    reported_.renew(RunNotice::TiltTurned);
    channel_.frames.frame_changed();

    constexpr double kMostModes = 1e6;
    const auto mode =
        static_cast<unsigned>(std::clamp(block.argument(invocation, kMode), 0.0, kMostModes));
    std::optional<Vec3> joints = direct_joints(block, invocation);
    if (mode >> 6 != kDirect)
        joints = joints_for_plane(block, Function::Swivel, static_cast<int>(direction));
    if (!joints) return;
    const bool holds_tip = digit(options, 1) == 1;
    if (direction != 0)
        holds_tip ? turn_about_tip(block, *joints, Op::Rapid, 0)
                  : turn_joints(block, *joints, Op::Rapid);
    if (!reporter_.has_ended()) carry(block, *joints);
}

/// Where the rotary axes 1 and 2 of the swivel data are to stand, rad. S 6.5.
Vec3 TiltedPlanes::direct_joints(const Block& block, const Invocation& invocation) const {
    const machine::Chain& chain = machine_.kinematics->chain;
    Vec3 joints = channel_.transformation.joints_of(position_.base());
    const std::array<std::size_t, 2> order = channel_.transformation.joints_in_order();
    for (std::size_t i = 0; i < 2; ++i) {
        if (chain.has(order[i]))
            joints[static_cast<Eigen::Index>(order[i])] =
                rad_from_deg(block.argument(invocation, kAngles + i));
    }
    return joints;
}

/// The rotation that the mode and the angles give; nothing if it was reported.
std::optional<Mat3> TiltedPlanes::swivel_rotation(const Block& block,
                                                  const Invocation& invocation) {
    const double mode = block.argument(invocation, kMode);
    const auto refuse = [&](std::string_view what) -> std::optional<Mat3> {
        reporter_.report(diag::SwivelValue, block, Function::Swivel).arg(what);
        return std::nullopt;
    };
    if (mode < 0 || mode > 255) return refuse("_MODE is not between 0 and 255");
    const auto bits = static_cast<unsigned>(mode);
    const Vec3 angles = three(block, invocation, kAngles) * rad_from_deg(1);
    const std::array<unsigned, 3> codes = {bits & 3u, bits >> 2 & 3u, bits >> 4 & 3u};
    const auto axis = [&](std::size_t i) { return static_cast<Axis>(codes[i] - 1); };
    switch (bits >> 6) {
        case kDirect: {
            // The plane lies as the rotary axes hold it, whatever the work offset is rotated by.
            const Mat3 outer = directions((frames_.outside_tool_frame() * frames_.tilt()).linear);
            return Mat3(outer.transpose() * machine::rotation_of(machine_.kinematics->chain,
                                                                 direct_joints(block, invocation)));
        }
        case kSolid: {
            const std::array<machine::AxisRotation, 2> turns = {
                {{Axis::Z, angles[0]}, {Axis::Y, angles[1]}}};
            return machine::turned_in_order(turns);
        }
        case kProjected: {
            const bool is_yx = codes[0] == 2 && codes[1] == 1;
            if (!is_yx && !(codes[0] == 1 && codes[1] == 2))
                return refuse("its projection angles are not about X and Y");
            const auto plane =
                machine::projected({angles[is_yx ? 1 : 0], angles[is_yx ? 0 : 1], angles[2]});
            if (plane) return *plane;
            return refuse("its projection angles do not span a plane");
        }
        default: break;
    }
    const unsigned seen = 1u << codes[0] | 1u << codes[1] | 1u << codes[2];
    if (bits >> 6 != kByAxes || seen != 0b1110u) return refuse("_MODE names no order of X, Y, Z");
    const std::array<machine::AxisRotation, 3> turns = {
        {{axis(0), angles[0]}, {axis(1), angles[1]}, {axis(2), angles[2]}}};
    return machine::turned_in_order(turns);
}

Done TiltedPlanes::retract_before_swivel(const Block& block, const Invocation& invocation) {
    const double kind = block.argument(invocation, parameter_of<Function::Swivel>("retract"));
    const auto to_reference = [&](AxisMask axes) {
        AxisValues to = channel_.transformation.machine_axes();
        for (std::size_t i = 0; i < 3; ++i)
            if ((axes >> i & 1u) != 0) to[i] = axes_.reference_points[0][i];
        channel_.motions.rapid_to_machine_position(block, to, axes);
        return Done(!reporter_.has_ended());
    };
    const auto across = static_cast<AxisMask>((bit(Axis::X) | bit(Axis::Y)) & axes_.present);
    if (kind == 0) return kDone;
    if (kind == 1) return to_reference(bit(Axis::Z));
    if (kind == 2) return to_reference(bit(Axis::Z)) ? to_reference(across) : kFailed;
    if (kind == 4) return retract_along_tool(block, std::nullopt);
    if (kind == 5) {
        const double by = block.argument(invocation, parameter_of<Function::Swivel>("by"));
        return retract_along_tool(block, by);
    }
    reporter_.report(diag::SwivelValue, block, Function::Swivel).arg("_FR is not 0, 1, 2, 4 or 5");
    return kFailed;
}

/// Away from the workpiece along the tool: by a distance, or as far as the axes go.
Done TiltedPlanes::retract_along_tool(const Block& block, std::optional<double> by) {
    const AxisValues axes = channel_.transformation.machine_axes();
    const Vec3 tool = machine::tool_in_base(machine_.kinematics->chain,
                                            channel_.transformation.joints_of(position_.base()));
    double most = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const double along = tool[static_cast<Eigen::Index>(i)];
        if (std::abs(along) < 1e-12) continue;
        most = std::min(most, ((along > 0 ? axes_.upper[i] : axes_.lower[i]) - axes[i]) / along);
    }
    const double distance = by.value_or(most);
    if (!std::isfinite(distance) || distance < 0 || distance > most + 1e-6) {
        reporter_.report(diag::SwivelRetract, block, Function::Swivel);
        return kFailed;
    }
    if (distance == 0) return kDone;
    Target target{position_.here(), position_.base(),
                  static_cast<AxisMask>(axes_.present & kLinearXYZ)};
    for (std::size_t i = 0; i < 3; ++i)
        target.base[i] += distance * tool[static_cast<Eigen::Index>(i)];
    target.here = frames_.from_base(target.base);
    channel_.motions.line(block, target, Op::Rapid, true);
    return Done(!reporter_.has_ended());
}

/// The frames of the cycle go; no axis moves.
void TiltedPlanes::end_swivel(const Block& block) {
    if (carrier_.stand) channel_.carriers.end_carrier();
    frames_.set_tool_frame(std::nullopt);
    end_tilted_plane(block);
    channel_.frames.frame_changed();
}

void TiltedPlanes::frame_along_tool(const Block& block, const Invocation& invocation) {
    const double programmed = block.argument(invocation, parameter_of<Function::ToolFrame>("axis"));
    const auto axis = static_cast<Eigen::Index>(programmed) - 1;
    if (axis < 0 || axis > 2) return;  // no form has it
    Vec3 tool = Vec3::UnitZ();
    if (carrier_.stand) {
        tool = carrier_.stand->head() * tool;
    } else if (machine_.kinematics) {
        const machine::Chain& chain = machine_.kinematics->chain;
        const Vec3 joints = channel_.transformation.joints_of(position_.base());
        tool = orienting_.is_on ? machine::tool_vector(chain, joints)
                                : machine::tool_in_base(chain, joints);
    }
    frames_.set_tool_frame(std::nullopt);
    const Frame old = frames_.total();
    const Mat3 before = directions(old.linear);
    Mat3 order = Mat3::Zero();  // brings the axis to where Z was
    for (Eigen::Index i = 0; i < 3; ++i) order((i + axis + 1) % 3, i) = 1;
    const Mat3 after = machine::square_to_tool_near(tool, before * order) * order.transpose();
    const bool moves = block.argument(invocation, parameter_of<Function::ToolFrame>("moves")) != 0;
    const Frame wanted{after * before.transpose() * old.linear,
                       moves ? linear(position_.base()) : old.shift};
    const Frame outside = frames_.tables() * frames_.outside_tool_frame();
    frames_.set_tool_frame(back_of(outside) * wanted * back_of(frames_.inside_tool_frame()));
    channel_.frames.frame_changed();
    position_.name();  // `Z=IC(100)` behind it is a distance along the tool alone
}

void TiltedPlanes::follow_tables(const Block& block, bool is_wanted) {
    if (is_wanted && !carrier_.stand && !require_rotary_axes(block, Function::TableFrame)) return;
    tilted_plane_.on_tables = is_wanted;
    if (carrier_.stand) {
        channel_.carriers.lay_on_carrier();
        position_.name();
        return;
    }
    if (tilted_plane_.carries || orienting_.is_on) return;
    frames_.set_tables(
        is_wanted ? machine::table_frame(machine_.kinematics->chain,
                                         channel_.transformation.joints_of(position_.base()))
                  : Frame{});
    channel_.frames.frame_changed();
    position_.name();
}

}  // namespace kadr::interp
