// rotation_3d.cpp — a rotation in space about an axis through a point: FANUC's coordinate
// conversion in three dimensions, G68 with I, J and K.
//
// The program goes on in a system whose origin is that point, turned about the axis; a second
// rotation is programmed in the system of the first. Heads that are set by hand, or turned by the
// program before, hold the tool along its Z, and so the tool's length lies there. No axis moves.
// F 3.7.
#include <Eigen/Geometry>

#include "base/diagnostics/iso.h"
#include "base/units.h"
#include "interp/channel.h"
#include "interp/tilted_planes.h"
#include "interp/tool_in_use.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using path::Frame;
using path::Vec3;

namespace {

constexpr int kMostTurns = 2;  // PS5043

}  // namespace

/// The rotations and the length of the tool are nested. The length
/// is switched on inside of them and off again: else it would lie askew to its own compensation.
Done TiltedPlanes::require_nested_length(const Block& block, Function function) {
    const bool has_length = tool_.source != Tool::Source::None && tool_.length_number() != 0;
    if (!has_length) return kDone;
    reporter_.report(diag::SpaceTurnLength, block, function)
        .arg(reporter_.word_of(block, function));
    return kFailed;
}

void TiltedPlanes::rotate_about_axis(const Block& block, const Invocation& invocation) {
    constexpr std::size_t kCenter = parameter_of<Function::Rotation3d>("x");
    constexpr std::size_t kAxis = parameter_of<Function::Rotation3d>("i");
    constexpr std::size_t kAngle = parameter_of<Function::Rotation3d>("angle");
    if (tilted_plane_.turns >= kMostTurns) {
        reporter_.report(diag::SpaceTurnNested, block, invocation.function);
        return;
    }
    if (!require_place_for_plane(block, invocation, tilted_plane_.turns > 0)) return;
    if (!require_nested_length(block, invocation.function)) return;
    const Vec3 axis{block.argument(invocation, kAxis), block.argument(invocation, kAxis + 1),
                    block.argument(invocation, kAxis + 2)};
    if (axis.norm() == 0) {
        reporter_.report(diag::SpaceTurnAxis, block, invocation.function);
        return;
    }
    Vec3 center;
    for (std::size_t i = 0; i < 3; ++i) {
        center[static_cast<Eigen::Index>(i)] =
            block.argument(invocation, kCenter + i, position_.here()[i]);
    }
    const double angle = rad_from_deg(block.argument(invocation, kAngle));
    const Frame turned{Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix(),
                       Vec3::Zero()};
    set_plane(path::translation(center) * turned, tilted_plane_.turns > 0);
    ++tilted_plane_.turns;
    position_.name();
}

/// All rotations end at once.
Done TiltedPlanes::end_rotations_3d(const Block& block) {
    if (tilted_plane_.turns == 0) return kDone;
    if (!require_nested_length(block, Function::RotateOff)) return kFailed;
    tilted_plane_.turns = 0;
    channel_.tool.set_length_shift(channel_.tool.length_shift_of(tool_.lengths));
    return kDone;
}

}  // namespace kadr::interp
