// through_splines.cpp — splines through points: their blocks are collected, their spans executed as
// soon as they are known.
//
// X, Y and Z make the spline, which is what SPLINEPATH is if nobody programs it; from point to
// point every other axis goes in proportion to the path (SPATH; SINUMERIK reference 4.4).
#include <bit>

#include "base/diagnostics/iso.h"
#include "interp/channel.h"
#include "interp/cornering.h"
#include "interp/motion_checks.h"
#include "interp/motions.h"
#include "interp/splines.h"
#include "interp/tool_in_use.h"
#include "interp/tool_motion.h"
#include "interp/transformation.h"
#include "nc/parameters.h"
#include "path/curve.h"
#include "path/linear.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Slot;
using nc::SlotMask;
using path::linear;
using path::SplineEnd;
using path::Vec3;

namespace {

/// Direction of a distance, if it is one.
std::optional<Vec3> direction_of(const Vec3& delta) {
    const double length = delta.norm();
    if (!(length > path::kSameKnot)) return std::nullopt;
    return Vec3(delta / length);
}

}  // namespace

void Splines::choose_spline_end(const Block& block, const nc::Invocation& invocation) {
    constexpr std::size_t kKind =
        nc::parameter_of_all<"kind", Function::SplineStart, Function::SplineEnd>();
    const double programmed = block.argument(invocation, kKind);
    const auto kind = programmed == 0   ? SplineEnd::Kind::Auto
                      : programmed == 1 ? SplineEnd::Kind::Natural
                                        : SplineEnd::Kind::Tangent;
    (invocation.function == Function::SplineStart ? spline_ends_.start : spline_ends_.end) = kind;
}

bool Splines::continues_through(const Block& block) {
    if (block.motion != Function::None && block.motion != through_->function) return false;
    if (only_turns(block)) return false;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        const Function function = block.functions[i].function;
        if (nc::has_fact(function, nc::Fact::ToolWord)) continue;
        if (function == Function::SplineStart || function == Function::SplineEnd) continue;
        if (!leaves_spline_open(block, block.functions[i])) return false;
    }
    return (block.given & (nc::kTargetSlots | nc::kPolarSlots)) != 0;
}

bool Splines::only_turns(const Block& block) {
    const bool is_turned = block.find(nc::Fact::ToolWord) != nullptr;
    const SlotMask targets = block.given & nc::kTargetSlots;
    if (!is_turned || targets == 0 || (block.given & nc::kPolarSlots) != 0) return false;
    MotionView view = channel_.motions.motion_view();
    view.take(block);
    const Target target = MotionWords(view, reporter_).target_of(block, targets);
    return !((linear(target.base) - linear(position_.base())).norm() > path::kSameKnot);
}

void Splines::go_through(const Block& block, SlotMask targets, const ToolWords& tool) {
    const SlotMask others = targets & ~SlotMask{kLinearXYZ};
    const auto refuse_others = [&] {
        const auto other = static_cast<Slot>(std::countr_zero(others));
        reporter_.report(diag::SplineAxis, block, other).arg(nc::slot_name(other));
    };
    if (others != 0 && channel_.transformation.is_transformed()) return refuse_others();
    if (!channel_.motions.motion_words().require_axes(block, targets) ||
        !channel_.motions.motion_words().require_rotary_approaches(block))
        return;
    if (!channel_.checks.require_feed(block, "spline")) return;
    if (!channel_.tool_motion.require_orientation_along(block, tool)) return;
    if (!through_ && !start_through(block)) return;
    spline_end_.line = block.line;
    spline_end_.source = block.source;
    const Target target = channel_.motions.motion_words().target_of(block, targets);
    if (!channel_.checks.require_within_limits(block, target.base, target.moved)) return;
    if (!through_->spline.add_point(linear(target.base))) {
        // An axis has no path of the spline to follow.
        const bool is_followed = others != 0 && target.base != position_.base();
        if (is_followed) refuse_others();
        else reporter_.report(diag::SplinePointRepeated, block);
        return;
    }
    through_->moved = static_cast<AxisMask>(through_->moved | target.moved);
    through_->blocks.push_back(control_point_block(block, target.base));
    if (tool.is_any()) through_->blocks.back().tool = tool;
    channel_.motions.arrive(target);
    move_through();
}

Done Splines::start_through(const Block& block) {
    channel_.cornering.leave_corners(diag::CornerNotContour);
    if (reporter_.has_ended()) return kFailed;
    SplineEnd start{spline_ends_.start, Vec3::Zero()};
    if (start.kind == SplineEnd::Kind::Tangent) {
        const auto direction = direction_of(linear(position_.base()) - position_.came_from());
        if (!direction) {
            reporter_.report(diag::SplineNoDirection, block).arg("before");
            return kFailed;
        }
        start.tangent = *direction;
    }
    if (tool_.has_changed) channel_.tool.activate_length(block, kLinearXYZ);
    spline_commands_.begin(span_as_programmed(block));
    const bool is_akima = modal_.motion == Function::AkimaSpline;
    const auto kind = is_akima ? path::ThroughKind::Akima : path::ThroughKind::CubicSpline;
    // The contour keeps its shape when a frame rotates it.
    const path::Mat3 axes = path::unit_axes(frames_.total());
    through_.emplace(
        ThroughRun{modal_.motion, {kind, start, linear(position_.base()), axes}, {}, AxisMask{0}});
    return kDone;
}

/// Puts out the spans that are known by now. One that is known while points may still come is not
/// the last.
void Splines::move_through() {
    while (!reporter_.has_ended()) {
        const std::optional<path::ThroughSpan> span = through_->spline.next();
        if (!span) return;
        const ControlPointBlock block = through_->blocks.front();
        through_->blocks.pop_front();
        const bool is_last = through_->blocks.empty();
        put_commands_before(block.number);
        put_span({span->start, span->end, span->shape}, block, through_->moved, block.stops);
        if (is_last) position_.come_from(span->shape.inner[1]);
    }
}

/// Another block follows, or none: the spline ends at its last point.
void Splines::finish_through(const Block* next) {
    SplineEnd end{spline_ends_.end, Vec3::Zero()};
    if (end.kind == SplineEnd::Kind::Tangent) {
        const auto direction = next != nullptr ? direction_into(*next) : std::nullopt;
        if (!direction) {
            // What is wrong with the block itself was reported.
            if (!reporter_.has_ended())
                reporter_.report(diag::SplineNoDirection, spline_end_).arg("behind");
            through_.reset();
            return;
        }
        end.tangent = *direction;
    }
    through_->spline.finish(end);
    move_through();
    put_commands_before(SplineCommands::kBehindAll);
    through_.reset();
}

// ------------------------------------------------------------------------------ any spline

void Splines::finish_open_spline(const Block* next) {
    if (spline_) finish_spline();
    if (through_) finish_through(next);
}

}  // namespace kadr::interp
