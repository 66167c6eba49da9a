// smoothing.cpp — what is programmed of blended corners and compressed lines.
//
// The commands carry it; where a curve fits, and which one, is the motion side's matter.
#include <algorithm>
#include <cmath>

#include "base/diagnostics/iso.h"
#include "base/units.h"
#include "interp/channel.h"
#include "interp/path_smoothing.h"
#include "interp/transformation.h"
#include "nc/parameters.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::parameter_of;
using nc::parameter_of_all;
using path::BlendKind;
using path::Op;

PathSmoothing::PathSmoothing(Channel& channel)
    : channel_(channel),
      machine_(channel.state.machine),
      reporter_(channel.state.reporter),
      modal_(channel.state.motion.modal),
      orienting_(channel.state.tool.orienting),
      virtual_(channel.state.tool.virtual_axes),
      dynamics_(channel.state.motion.dynamics) {}

void PathSmoothing::choose_smoothing(const Block& block, const nc::Invocation& invocation) {
    switch (invocation.function) {
        case Function::CompressOn: smoothing_.compresses = true; return;
        case Function::CompressOff: smoothing_.compresses = false; return;
        case Function::OrientSmooth: smoothing_.smooths_orientation = true; return;
        case Function::OrientSmoothOff: smoothing_.smooths_orientation = false; return;
        case Function::HighSpeed: choose_high_speed(block, invocation); return;
        default: break;
    }
    constexpr std::size_t kSize =
        parameter_of_all<"tolerance", Function::PathTolerance, Function::OrientTolerance>();
    static_assert(
        kSize ==
        parameter_of_all<"distance", Function::BlendFeedDistance, Function::BlendRapidDistance>());
    const double size = block.argument(invocation, kSize);
    if (invocation.function == Function::PathTolerance) {
        smoothing_.tolerance = size < 0 ? std::nullopt : std::optional(size);
        return;
    }
    if (invocation.function == Function::OrientTolerance) {
        smoothing_.orientation = size < 0 ? std::nullopt : std::optional(rad_from_deg(size));
        return;
    }
    if (size < 0)
        reporter_.report(diag::BlendDistanceNegative, block, invocation.function).arg(size);
    const bool is_rapid = invocation.function == Function::BlendRapidDistance;
    (is_rapid ? smoothing_.rapid_distance : smoothing_.feed_distance) = std::max(size, 0.0);
}

/// S 10.4 CYCLE832. Which of G642, G643 and G645 the cycle uses, and which compressor, is a matter
/// of its set-up (unsure): here they are those that give the smoothest path within the tolerance,
/// whatever the kind of machining. The kinds differ in their dynamics, of which a machine file has
/// one set.
void PathSmoothing::choose_high_speed(const Block& block, const nc::Invocation& invocation) {
    constexpr Function kCorners = Function::BlendSmooth;
    constexpr bool kCompresses = true;
    const double tolerance =
        block.argument(invocation, parameter_of<Function::HighSpeed>("tolerance"));
    const std::int64_t kind =
        std::llround(block.argument(invocation, parameter_of<Function::HighSpeed>("kind")));
    const bool is_on = kind % 10 != 0 && tolerance > 0;
    const bool has_orientation = is_on && kind / 10 % 10 == 1;
    smoothing_.tolerance = is_on ? std::optional(tolerance) : std::nullopt;
    const double orientation =
        block.argument(invocation, parameter_of<Function::HighSpeed>("orientation"));
    smoothing_.orientation =
        has_orientation ? std::optional(rad_from_deg(orientation)) : std::nullopt;
    smoothing_.compresses = is_on && kCompresses;
    modal_.set_path_mode(is_on ? kCorners : Function::ContinuousPath);
}

path::Blending PathSmoothing::blending(Op op) const {
    path::Blending blending;
    if (virtual_.axes.is_on() || !path::is_motion(op)) return blending;
    const double orientation = smoothing_.orientation.value_or(machine_.orientation_tolerance);
    if (modal_.blend == Blend::Distance) {
        blending.kind = BlendKind::Distance;
        blending.size = op == Op::Rapid ? smoothing_.rapid_distance : smoothing_.feed_distance;
    } else if (modal_.blend != Blend::None) {
        blending.kind = BlendKind::Tolerance;
        blending.with_tangents = modal_.blend == Blend::Smooth;
        blending.size = smoothing_.tolerance.value_or(machine_.corner_tolerance);
        blending.orientation = orientation;
    }
    if (orienting_.is_on && smoothing_.smooths_orientation && orientation > 0) {
        blending.smooths_orientation = true;
        blending.orientation = orientation;
    }
    return blending;
}

double PathSmoothing::compressing(Op op) const {
    if (channel_.transformation.is_transformed() || !smoothing_.compresses || op != Op::Line)
        return 0;
    return smoothing_.tolerance.value_or(machine_.compressor_tolerance);
}

bool PathSmoothing::stops_exactly(bool once) const {
    return dynamics_.has_exact_stop() && (modal_.has_exact_stop || once);
}

}  // namespace kadr::interp
