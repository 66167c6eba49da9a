// splines.cpp — B-splines: their blocks are collected, their spans executed as soon as they are
// known.
#include "interp/splines.h"

#include <bit>
#include <utility>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "interp/block_functions.h"
#include "interp/block_words.h"
#include "interp/channel.h"
#include "interp/cornering.h"
#include "interp/motion_checks.h"
#include "interp/motions.h"
#include "interp/path_smoothing.h"
#include "interp/radius_compensation.h"
#include "interp/stages.h"
#include "interp/tool_in_use.h"
#include "interp/tool_motion.h"
#include "interp/transformation.h"
#include "path/curve.h"
#include "path/linear.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::parameter_of;
using nc::SlotMask;
using path::Command;
using path::linear;
using path::NurbsFault;
using path::Op;
using path::Vec3;

namespace {

/// The first control point of a spline by knots is where the tool is, as exactly as texts are, mm.
constexpr double kSamePlace = 0.002;

std::string_view words_of(NurbsFault fault) {
    switch (fault) {
        case NurbsFault::Decreasing: return "are decreasing";
        case NurbsFault::Unclamped: return "do not stand degree + 1 times at both ends";
        case NurbsFault::Gap: return "stand more often inside than the degree says";
        case NurbsFault::Counts: return "are not as many as control points and degree + 1";
        case NurbsFault::Degree:
        case NurbsFault::ControlPoints:
        case NurbsFault::Weight: break;
    }
    return "are wrong";
}

constexpr std::size_t kKnot = parameter_of<Function::SplineKnot>("knot");
constexpr std::size_t kInterval = parameter_of<Function::SplineInterval>("interval");
constexpr std::size_t kWeight = parameter_of<Function::SplineWeight>("weight");

/// The argument of a word beside a control point.
std::optional<double> word(const Block& block, Function function, std::size_t parameter) {
    const nc::Invocation* invocation = block.find(function);
    return invocation == nullptr ? std::nullopt
                                 : std::optional(block.argument(*invocation, parameter));
}

}  // namespace

Splines::Splines(Channel& channel)
    : channel_(channel),
      dialect_(channel.state.dialect),
      work_offset_(channel.state.frame.work_offset),
      reporter_(channel.state.reporter),
      rules_(channel.state.rules),
      modal_(channel.state.motion.modal),
      position_(channel.state.motion.position),
      frames_(channel.state.frame.frames),
      tool_(channel.state.tool.tool),
      position_words_(channel.state.motion.position_words),
      orienting_(channel.state.tool.orienting),
      spline_(channel.state.cycle.spline),
      through_(channel.state.cycle.through),
      spline_commands_(channel.state.cycle.spline_commands),
      puts_span_(channel.state.cycle.puts_span),
      dynamics_(channel.state.motion.dynamics) {}

bool Splines::continues_spline(const Block& block) const {
    const bool is_spline = block.motion == Function::None || block.motion == Function::Spline;
    if (!is_spline || (block.motion == Function::Spline && spline_->is_by_knots())) return false;
    bool has_knot = false;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        const Function function = block.functions[i].function;
        if (nc::has_fact(function, nc::Fact::ToolWord)) continue;
        has_knot |= function == Function::SplineKnot;
        if (nc::has_fact(function, nc::Fact::SplineWord) && function != Function::SplineDegree)
            continue;
        if (spline_->is_by_knots() || !leaves_spline_open(block, block.functions[i])) return false;
    }
    return has_knot || (block.given & nc::kTargetSlots) != 0;
}

void Splines::set_spline_degree(const Block& block, const nc::Invocation& invocation) {
    const double degree =
        block.argument(invocation, parameter_of<Function::SplineDegree>("degree"));
    if (degree >= 1 && degree <= 3) {
        spline_degree_ = static_cast<int>(degree);
        return;
    }
    reporter_.report(diag::SplineValue, block, Function::SplineDegree)
        .arg("degree")
        .arg(degree)
        .arg("1, 2 or 3");
}

void Splines::spline(const Block& block, const ToolWords& tool) {
    const SlotMask targets = block.given & nc::kTargetSlots;
    const std::optional<double> knot = word(block, Function::SplineKnot, kKnot);
    const SlotMask others = targets & ~SlotMask{kLinearXYZ};
    const bool leads_others =
        !channel_.transformation.is_transformed() && !knot && !(spline_ && spline_->is_by_knots());
    if (others != 0 && !leads_others) {
        const auto other = static_cast<nc::Slot>(std::countr_zero(others));
        reporter_.report(diag::SplineAxis, block, other).arg(nc::slot_name(other));
        return;
    }
    if (!channel_.motions.motion_words().require_axes(block, targets) ||
        !channel_.motions.motion_words().require_rotary_approaches(block))
        return;
    if (const auto interval = word(block, Function::SplineInterval, kInterval);
        interval && *interval < 0) {
        reporter_.report(diag::IsoMinusNotAllowed, block, Function::SplineInterval)
            .arg(reporter_.word_of(block, Function::SplineInterval));
        return;
    }
    if (!channel_.tool_motion.require_orientation_along(block, tool)) return;
    if (!spline_ && !start_spline(block, knot.has_value())) return;
    spline_end_.line = block.line;
    spline_end_.source = block.source;
    std::optional<NurbsFault> fault;
    if (targets != 0) {
        if (!add_control_point(block, targets, tool)) return;
        if (!spline_->is_by_knots()) {
            const auto interval = word(block, Function::SplineInterval, kInterval);
            fault = spline_->add_interval(interval.value_or(1));
        }
    }
    if (knot && spline_->is_by_knots()) fault = spline_->add_knot(*knot);
    if (fault) return report_spline(block, *fault);
    move_along_spline();
}

Done Splines::start_spline(const Block& block, bool by_knots) {
    const bool counts_knots =
        dialect_.can_write(Function::SplineKnot) && !dialect_.can_write(Function::SplineInterval);
    channel_.cornering.leave_corners(diag::CornerNotContour);
    if (reporter_.has_ended()) return kFailed;
    if (!by_knots && counts_knots) {
        reporter_.report(diag::SplineKnots, block).arg("are missing");
        return kFailed;
    }
    if (!channel_.checks.require_feed(block, "spline")) return kFailed;
    if (tool_.has_changed) channel_.tool.activate_length(block, kLinearXYZ);
    spline_commands_.begin(span_as_programmed(block));
    spline_.emplace(spline_degree_, by_knots);
    if (by_knots) return kDone;
    ControlPointBlock start{block.line, block.source, 0, position_.base(), {}, {}};
    start.modes = orienting_;
    if (!channel_.tool_motion.orient_control_point(block, {}, start)) return kFailed;
    spline_->add_control_point(linear(position_.base()), 1, start);
    return kDone;
}

Done Splines::add_control_point(const Block& block, SlotMask targets, const ToolWords& tool) {
    const double weight = word(block, Function::SplineWeight, kWeight).value_or(1);
    if (!(weight > 0)) {
        reporter_.report(diag::SplineValue, block, Function::SplineWeight)
            .arg("weight")
            .arg(weight)
            .arg("above 0");
        return kFailed;
    }
    const Target target = channel_.motions.motion_words().target_of(block, targets);
    const Vec3 pole = linear(target.base);
    // Control points of X, Y and Z may lie where the axes never go; others keep to the limits.
    if (!channel_.checks.require_within_limits(block, target.base,
                                               static_cast<AxisMask>(target.moved & ~kLinearXYZ)))
        return kFailed;
    const bool is_start = spline_->control_points() == 0;
    if (is_start && (pole - linear(position_.base())).norm() > kSamePlace) {
        reporter_.report(diag::SplineStart, block)
            .arg(round_to((pole - linear(position_.base())).norm(), 4));
        return kFailed;
    }
    ControlPointBlock control_point = control_point_block(block, target.base);
    if (!channel_.tool_motion.orient_control_point(block, tool, control_point)) return kFailed;
    spline_->moved = static_cast<AxisMask>(spline_->moved | target.moved);
    spline_->add_control_point(pole, weight, control_point);
    channel_.motions.arrive(target);
    return kDone;
}

/// Whether a spline goes on in a block with a position beside which this stands. Another motion
/// ends it, and what makes the path stop; what moves the zero or the tool ends it as well.
/// source: SINUMERIK reference 4.4
bool Splines::leaves_spline_open(const Block& block, const nc::Invocation& invocation) const {
    if (nc::has_fact(invocation.function, nc::Fact::InSpline)) return true;
    if (nc::has_fact(invocation.function, nc::Fact::InSplineWithoutComp))
        return !channel_.compensation.is_any_comp_on();
    switch (invocation.function) {
        case Function::WorkOffset:
            return count_of(block, invocation, parameter_of<Function::WorkOffset>("number")) ==
                   work_offset_;
        case Function::ToolSelect:
            return !nc::selects_at_once(rules_, channel_.functions.changer()) &&
                   !invocation.has(parameter_of<Function::ToolSelect>("offset"));
        case Function::SpindleOrient: return false;
        case Function::MachineFunction: return !channel_.functions.is_awaited(block, invocation);
        default: break;
    }
    switch (nc::info(invocation.function).group) {
        case nc::Group::Plane: return !channel_.functions.is_other_plane(invocation.function);
        case nc::Group::Spindle:
        case nc::Group::Coolant: return !channel_.functions.is_awaited(block, invocation);
        default: return false;
    }
}

/// A block with a point, as its span is executed.
ControlPointBlock Splines::control_point_block(const Block& block, const AxisValues& to) {
    // A varying feed counts blocks.
    if (block.function_count != 0 || dynamics_.has_feed_characteristic())
        spline_commands_.change(span_as_programmed(block));
    return {block.line,
            block.source,
            modal_.feed,
            to,
            spline_commands_.count(),
            channel_.smoothing.stops_exactly(block.find(Function::ExactStopOnce) != nullptr),
            std::nullopt,
            std::nullopt,
            orienting_};
}

Command Splines::span_as_programmed(const Block& block) {
    Command span(Op::Spline);
    channel_.stages.fill_in(span, block);
    return span;
}

/// Puts out what stands in front of the span of a block of the open spline.
void Splines::put_commands_before(std::uint32_t number) {
    while (auto said = spline_commands_.take_before(number))
        channel_.stages.behind_corners() = std::move(*said);
}

/// Puts out the spans that are known by now.
void Splines::move_along_spline() {
    while (!reporter_.has_ended()) {
        const std::optional<SplineStep> step = spline_->next();
        if (!step) return;
        put_commands_before(step->block.number);
        // Between the ends no block ends at a position of its own.
        put_span(step->span, step->block, spline_->moved, step->is_last && step->block.stops);
    }
}

/// A span of an open spline is as its own block has programmed, and its orientation is as it was
/// laid just now.
void Splines::as_programmed(Command& command) const {
    const Command laid = std::exchange(command, spline_commands_.span());
    command.source = laid.source;
    command.line = laid.line;
    command.motion().orient_kind = laid.motion().orient_kind;
    command.motion().direction = laid.motion().direction;
    command.motion().orient_details = laid.motion().orient_details;
}

/// A span as a command, programmed by a block.
void Splines::put_span(const path::SplineSpan& span, const ControlPointBlock& control_point,
                       AxisMask moved, bool exact_stop) {
    Block at;  // whose location messages show
    at.line = control_point.line;
    at.source = control_point.source;
    const auto& [start, end, shape, last] = span;
    path::Curve curve = path::Point{start};
    if (shape.degree > 3) curve = path::make_quintic(start, end, shape);
    else curve = path::make_spline(start, end, shape);
    const path::Box box = path::bounds(curve);
    if (!channel_.checks.require_box_within_limits(at, box)) return;
    // The tip stands, the tool or other axes turn: no curve has a direction of travel there.
    const bool stands = box.lower == box.upper && !is_in_spline();
    AxisValues to = control_point.to;
    for (std::size_t i = 0; i < 3; ++i) to[i] = end[static_cast<Eigen::Index>(i)];
    OrientPlan orientation;
    puts_span_ = true;
    const bool is_laid = !orienting_.is_on || channel_.tool_motion.orient_along(
                                                  at, control_point, curve, to, orientation);
    puts_span_ = false;
    if (!is_laid) return;
    position_.note_motion();
    const bool turns = orientation.orient_kind != path::OrientKind::Axes;
    Command& command = channel_.stages.put(stands ? Op::Line : Op::Spline, at, &orientation);
    if (is_in_spline()) as_programmed(command);
    path::Motion& motion = command.motion();
    motion.to = to;
    motion.moved =
        turns ? static_cast<AxisMask>(moved | kLinearXYZ | channel_.transformation.joint_axes())
              : moved;
    if (!stands) motion.spline() = shape;
    motion.feed = control_point.feed;
    motion.exact_stop = exact_stop;
}

/// Another block follows, or none: the spline ends where its last control point is.
void Splines::finish_spline() {
    if (const auto fault = spline_->finish()) {
        report_spline(spline_end_, *fault);
    } else {
        move_along_spline();
    }
    put_commands_before(SplineCommands::kBehindAll);
    spline_.reset();
}

void Splines::report_spline(const Block& block, NurbsFault fault) {
    if (fault == NurbsFault::ControlPoints) {
        reporter_.report(diag::SplinePoles, block)
            .arg(spline_->degree())
            .arg(spline_->degree() + 1)
            .arg(static_cast<int>(spline_->control_points()));
    } else {
        reporter_.report(diag::SplineKnots, block).arg(words_of(fault));
    }
}

}  // namespace kadr::interp
