// curves.cpp — calls of registered curves: the tool moves along one at the feed, from where it is.
#include <cmath>

#include "base/diagnostics/iso.h"
#include "base/diagnostics/machine.h"
#include "base/units.h"
#include "interp/channel.h"
#include "interp/cornering.h"
#include "interp/motion_checks.h"
#include "interp/motions.h"
#include "interp/path_smoothing.h"
#include "interp/stages.h"
#include "interp/tool_in_use.h"
#include "path/contour.h"
#include "path/curve.h"
#include "path/curve_registry.h"
#include "path/frame.h"
#include "path/linear.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using path::Command;
using path::CurveShape;
using path::linear;
using path::Op;
using path::Vec3;

namespace {

/// As the seam gives them: canonical units.
double canonical(double value, nc::Dimension dimension) {
    switch (dimension) {
        case nc::Dimension::Angle: return rad_from_deg(value);
        case nc::Dimension::Feed: return feed_from_mm_min(value);
        case nc::Dimension::Speed: return speed_from_rpm(value);
        case nc::Dimension::Number:
        case nc::Dimension::Count:
        case nc::Dimension::Length:
        case nc::Dimension::Time:
        case nc::Dimension::Factor:
        case nc::Dimension::Text: break;
    }
    return value;
}

/// Whether a law keeps what its kind promises, as far as samples show.
bool is_sound(const CurveShape& shape) {
    constexpr int kSamples = 64;
    const path::CurveLaw& law = shape.law;
    if (!(law.to > law.from) || !std::isfinite(law.to - law.from)) return false;
    for (int i = 0; i <= kSamples; ++i) {
        const double u = law.from + (law.to - law.from) * i / kSamples;
        const path::SplinePoint point = shape.kind->at(law.numbers, u);
        if (!point.position.allFinite() || !point.first.allFinite() || !point.second.allFinite())
            return false;
    }
    return true;
}

std::string joined(const std::vector<std::string_view>& names) {
    std::string all;
    for (const std::string_view name : names) {
        if (!all.empty()) all += ", ";
        all += name;
    }
    return all.empty() ? "none" : all;
}

}  // namespace

void Motions::move_along_curve(const Block& block, const nc::Invocation& call) {
    const nc::CycleInfo& info = dialect_.cycles()[block.cycle];
    const path::CurveKind* kind = path::find_curve(info.curve);
    if (kind == nullptr) {
        reporter_.report(diag::CurveUnknown, block, Function::Cycle)
            .arg(info.curve)
            .arg(joined(path::curve_names()));
        return;
    }
    const auto refuse = [&](std::string_view words) {
        reporter_.report(diag::CurveRefused, block, Function::Cycle).arg(info.name).arg(words);
    };
    if ((block.given & nc::kTargetSlots) != 0) return refuse("its block moves an axis as well");
    if (shape_ || block.is_of_cycle()) return refuse("it stands in a contour or in a cycle");
    if (modal_cycles_.modal.is_active) return refuse("a cycle is called by every block here");
    if (comp_.is_on())
        return refuse("cutter radius compensation is on, and knows lines and arcs alone");

    std::vector<std::optional<double>> arguments(info.parameters.size());
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if ((call.given >> i & 1u) != 0)
            arguments[i] = canonical(block.argument(call, i), info.parameters[i].dimension);
    }
    Result<path::CurveLaw, std::string> law = kind->make(arguments);
    if (!law) return refuse(law.error());
    CurveShape shape;
    shape.kind = kind;
    shape.law = *law;
    const path::PlaneAxes plane = path::axes_of(modal_.plane);
    path::Mat3 axes;
    axes << path::unit(plane.first), path::unit(plane.second), path::unit(plane.normal);
    shape.linear = frames_.total().linear * axes;
    if (!is_sound(shape)) return refuse("it has no finite shape with these values");

    if (!channel_.checks.require_feed(block, "curve")) return;
    channel_.cornering.leave_corners(diag::CornerNotContour);
    if (reporter_.has_ended()) return;
    if (tool_.has_changed) channel_.tool.activate_length(block, kLinearXYZ);
    const Vec3 start = linear(position_.base());
    const path::Parametric curve = path::make_parametric(start, path::end_of(shape, start), shape);
    if (!(curve.length > path::kSamePoint)) return refuse("it has no length");
    if (!channel_.checks.require_box_within_limits(block, path::bounds(curve))) return;

    Target target{{}, position_.base(), 0};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        target.base[i] = curve.end[k];
        if (path::bounds(curve).lower[k] < path::bounds(curve).upper[k])
            target.moved = static_cast<AxisMask>(target.moved | bit(static_cast<Axis>(i)));
    }
    target.here = frames_.from_base(target.base);
    position_.note_motion();
    path::Motion& motion = channel_.stages.put(Op::Parametric, block).motion();
    motion.to = target.base;
    motion.moved = target.moved;
    motion.exact_stop = channel_.smoothing.stops_exactly();
    motion.feed = modal_.feed;
    motion.curve() = shape;
    arrive(target);
    position_.come_from(curve.end - path::curvature_at(curve, 1).tangent);
}

}  // namespace kadr::interp
