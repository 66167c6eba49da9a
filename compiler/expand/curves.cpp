// curves.cpp — curves of a running program: their points with derivatives, and the blocks that are
// fitted to them.
#include "expand/curves.h"

#include <cmath>

#include "base/diagnostics/expand.h"
#include "base/numbers.h"
#include "expand/blocks.h"
#include "expand/cycles.h"
#include "expand/faults.h"
#include "expand/follow.h"
#include "expand/numbers.h"
#include "expand/plane.h"
#include "expand/running.h"
#include "expand/text_format.h"
#include "expand/vm.h"

namespace kadr::expand {

using nc::Function;
using nc::Group;
using path::Vec2;
using path::Vec3;
using sema::CurveSlot;
using sema::Slot;

namespace {

void keep_back_rounding(Running& run, std::uint32_t at, int coordinates, path::FitOptions& fit);
Done start_fit(Running& run, const Instruction& instruction, std::uint32_t at, bool wants_nurbs,
               const path::FitOptions& fit);
Done fit_spline(Running& run, const Instruction& instruction, std::uint32_t at,
                const path::FitOptions& fit);
void jump_fault(Running& run, const Instruction& instruction, std::uint32_t at, double parameter);
std::size_t block_count(const Running& run, const path::Nurbs& spline);
Done emit_control_point(Running& run, const FollowedBlock& next, std::uint32_t at);
Done emit_line(Running& run, const path::Vec3& to, const FollowedBlock& next, std::uint32_t at);
void set_coordinates(const Running& run, nc::Block& block, const path::Vec3& to);

/// What a millimetre along an axis is in its word.
double word_scale(std::size_t axis, bool is_diameter) {
    return is_diameter && axis == index(Axis::X) ? 2 : 1;
}

/// Finest tolerance of a curve, mm: the increment of the finest controls.
constexpr double kLeastTolerance = 1e-5;

constexpr std::size_t at(CurveSlot slot) { return static_cast<std::size_t>(slot); }

/// First and second axis of the plane, then the one across.
std::array<std::size_t, 3> order_of(path::Plane plane) {
    const PlaneIndices axes = indices_of(plane);
    return {axes.first, axes.second, axes.across};
}

/// Calls the curve's function in the registers behind those of the caller.
std::optional<path::CurveSample> curve_point(Running& run, const Instruction& instruction,
                                             std::uint32_t where, double parameter) {
    const sema::FunctionCode& function =
        run.code.functions[static_cast<std::size_t>(instruction.immediate.pair.first)];
    if (run.vm.calls.size() > run.options.limits.call_depth) {
        fault(run, diag::CallDepthLimit, where)
            .arg(static_cast<std::int64_t>(run.options.limits.call_depth));
        return std::nullopt;
    }
    const CallFrame caller = run.vm.calls.back();
    const std::uint32_t base = caller.base + caller.function->registers;
    run.vm.reserve_stack(std::size_t{base} + function.registers + 8);
    run.vm.slopes.resize(run.vm.stack.size());
    const std::size_t arguments = caller.base + instruction.a + at(CurveSlot::Arguments);
    const std::size_t running = function.parameters.back().slot;
    for (std::size_t i = 0; i < running; ++i) {
        run.vm.stack[base + i] = run.vm.stack[arguments + i];
        run.vm.slopes[base + i] = 0;
    }
    run.vm.stack[base + running].number = parameter;
    run.vm.slopes[base + running] = 1;
    CallFrame& frame = run.vm.calls.push();
    frame = {};
    frame.function = &function;
    frame.return_to = where + 1;  // CurveEnd
    frame.base = base;
    frame.given = static_cast<std::uint32_t>(run.code.instructions[where + 1].immediate.pair.first);
    frame.promises = run.scopes.promises();
    frame.loops = caller.loops;
    const auto number = static_cast<std::size_t>(instruction.immediate.pair.first);
    run.curve.is_in_point = true;
    execute_with_slopes(run, run.vm.beginning_of(function, number, frame.given));
    run.curve.is_in_point = false;
    if (run.status.has_failed()) return std::nullopt;

    Following& curve = *run.curve.following;
    path::CurveSample sample;
    const std::array<std::size_t, 3> axes = order_of(curve.plane);
    for (std::size_t i = 0; i < 3; ++i) {
        const double value = run.vm.stack[base + axes[i]].number;
        const bool is_given = value == value;
        if (!curve.has_coordinates) curve.is_given[i] = is_given;
        if (curve.is_given[i] != is_given) {
            fault(run, diag::CurveCoordinate, where)
                .arg(function.name)
                .arg(std::string(1, "xyz"[axes[i]]))
                .arg(function.parameters.back().name)
                .arg(quantity_text(run, parameter, function.parameters.back().quantity));
            return std::nullopt;
        }
        if (!is_given) continue;
        if (!is_sane(value)) {
            math_fault(run, sema::MathFault::Overflow, where);
            return std::nullopt;
        }
        // The curve gives words; what is fitted is the path of the tool.
        const double scale = word_scale(axes[i], run.modal.is_diameter);
        sample.position[static_cast<Eigen::Index>(i)] = value / scale;
        sample.derivative[static_cast<Eigen::Index>(i)] = run.vm.slopes[base + axes[i]] / scale;
    }
    return sample;
}

Done start_curve(Running& run, const Instruction& instruction, std::uint32_t where) {
    if (is_between_positions(run)) return refuse_beside_cycle(run, "a curve", where);
    const Slot* options_of = run.vm.stack.data() + run.vm.calls.back().base + instruction.a;
    const double tolerance = options_of[at(CurveSlot::Tolerance)].number;
    if (!(tolerance >= kLeastTolerance) || !is_sane(tolerance)) {
        fault(run, diag::CurveTolerance, where).arg(quantity_text(run, tolerance, sema::kLength));
        return kFailed;
    }
    run.curve.following.emplace();
    Following& curve = *run.curve.following;
    curve.plane = plane_of(run.modal[Group::Plane]);
    curve.next.source = statement_of(instruction);
    curve.next.depth = instruction.c;
    curve.next.feed = options_of[at(CurveSlot::Feed)].number;
    curve.next.is_diameter = run.modal.is_diameter;
    path::FitOptions fit;
    fit.tolerance = tolerance;
    fit.from = options_of[at(CurveSlot::From)].number;
    fit.to = options_of[at(CurveSlot::To)].number;
    const bool wants_arcs = options_of[at(CurveSlot::Arcs)].integer != 0;
    // Contours are made of lines and arcs.
    const bool wants_nurbs =
        options_of[at(CurveSlot::Nurbs)].integer != 0 && !run.recordings.is_open();
    // The first point tells which coordinates the curve has.
    const std::optional<path::CurveSample> first = curve_point(run, instruction, where, fit.from);
    if (!first) return kFailed;
    curve.has_coordinates = true;
    if (fit.from == fit.to) {
        const sema::FunctionCode& function =
            run.code.functions[static_cast<std::size_t>(instruction.immediate.pair.first)];
        fault(run, diag::CurveIsPoint, where)
            .arg(function.name)
            .arg(function.parameters.back().name)
            .arg(quantity_text(run, fit.from, function.parameters.back().quantity));
    }
    const bool is_flat = curve.is_given[0] && curve.is_given[1] && !curve.is_given[2];
    const bool has_arcs =
        run.target.can_write(Function::ArcCw) && run.target.can_write(Function::ArcCcw);
    fit.kind = is_flat && has_arcs && wants_arcs ? path::FitKind::Biarcs : path::FitKind::Lines;
    keep_back_rounding(run, where, is_flat ? 2 : 3, fit);
    if (!start_fit(run, instruction, where, wants_nurbs, fit)) return kFailed;
    curve.at = first->position.head<2>();
    // To the start, unless the tool is there.
    const std::array<std::size_t, 3> axes = order_of(curve.plane);
    bool is_there = true;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!curve.is_given[i]) continue;
        const bool is_known = run.modal.position.knows(axes[i]);
        const double distance =
            run.modal.position[axes[i]] / word_scale(axes[i], run.modal.is_diameter) -
            first->position[static_cast<Eigen::Index>(i)];
        is_there = is_there && is_known && std::fabs(distance) <= path::kSamePoint;
    }
    if (is_there) return kDone;
    if (!emit_line(run, first->position, curve.next, where)) return kFailed;
    curve.next.feed = sema::kNotGivenNumber;
    return kDone;
}

/// The text rounds every coordinate by up to half of an increment, which is a part of the
/// tolerance.
void keep_back_rounding(Running& run, std::uint32_t where, int coordinates, path::FitOptions& fit) {
    const bool is_inch = run.modal[Group::Units] == Function::Inch;
    const double increment = run.target.written_increment(is_inch);
    const double rounding = std::sqrt(coordinates) * increment / 2;
    const double asked = fit.tolerance;
    fit.tolerance = std::max(asked - rounding, asked / 2);
    if (fit.tolerance + rounding <= asked ||
        !run.reported_at.first_time(NoticeAt::Tolerance, where))
        return;
    fault(run, diag::CurveIncrement, where)
        .arg(quantity_text(run, increment, sema::kLength))
        .arg(quantity_text(run, round_to(fit.tolerance + rounding, 5), sema::kLength))
        .arg(quantity_text(run, asked, sema::kLength));
}

/// As one spline if that is asked for and the control has it; else as lines or arcs, piece by
/// piece.
Done start_fit(Running& run, const Instruction& instruction, std::uint32_t where, bool wants_nurbs,
               const path::FitOptions& fit) {
    const bool has_splines =
        run.target.can_write(Function::Spline) && (run.target.can_write(Function::SplineInterval) ||
                                                   run.target.can_write(Function::SplineKnot));
    if (wants_nurbs && has_splines) return fit_spline(run, instruction, where, fit);
    if (wants_nurbs && run.reported_at.first_time(NoticeAt::Spline, where)) {
        fault(run, diag::SplineFallback, where)
            .arg(run.target.name())
            .arg(fit.kind == path::FitKind::Biarcs ? "arcs" : "lines");
    }
    const Instruction* self = &instruction;
    run.curve.following->fit = std::make_unique<path::CurveFit>(
        [&run, self, where](double parameter) { return curve_point(run, *self, where, parameter); },
        fit);
    return kDone;
}

Done fit_spline(Running& run, const Instruction& instruction, std::uint32_t where,
                const path::FitOptions& fit) {
    path::SplineFitResult fitted = path::fit_spline(
        [&](double parameter) { return curve_point(run, instruction, where, parameter); }, fit);
    if (run.status.has_failed()) return kFailed;
    if (fitted.fault) {
        jump_fault(run, instruction, where, fitted.parameter);
        return kFailed;
    }
    run.curve.following->spline = std::move(fitted.spline);
    // By intervals the first control point is where the tool is anyway.
    run.curve.following->next_knot = run.target.can_write(Function::SplineInterval) ? 1 : 0;
    return kDone;
}

void jump_fault(Running& run, const Instruction& instruction, std::uint32_t where,
                double parameter) {
    const sema::FunctionCode& function =
        run.code.functions[static_cast<std::size_t>(instruction.immediate.pair.first)];
    fault(run, diag::CurveJump, where)
        .arg(function.name)
        .arg(function.parameters.back().name)
        .arg(quantity_text(run, parameter, function.parameters.back().quantity));
}

}  // namespace

CurveProgress follow_curve(Running& run, const Instruction& instruction, std::uint32_t where) {
    if (run.curve.is_in_point) {
        fault(run, diag::CurveBlock, where);
        return CurveProgress::Failed;
    }
    if (!run.curve.following && !start_curve(run, instruction, where)) return CurveProgress::Failed;
    for (;;) {
        const bool has_room = run.recordings.is_open() || !run.batch.is_full();
        if (!has_room) return CurveProgress::BatchFull;
        Following& curve = *run.curve.following;
        if (curve.fit == nullptr) {
            if (curve.next_knot >= block_count(run, curve.spline)) break;
            if (!emit_control_point(run, curve.next, where)) return CurveProgress::Failed;
            ++curve.next_knot;
            curve.next.feed = sema::kNotGivenNumber;
            continue;
        }
        const std::optional<path::FitPiece> piece = curve.fit->next();
        if (!piece) break;
        const Vec2 to = piece->to.head<2>();
        if (piece->sweep == 0) {
            if (!emit_line(run, piece->to, curve.next, where)) return CurveProgress::Failed;
        } else {
            const path::Element arc{curve.at, to, piece->center, piece->sweep};
            if (!emit_element(run, arc, curve.next, where)) return CurveProgress::Failed;
        }
        curve.at = to;
        curve.next.feed = sema::kNotGivenNumber;
    }
    if (run.status.has_failed()) return CurveProgress::Failed;
    if (run.curve.following->fit == nullptr) {
        // A position by itself behind the spline is no further control point of it.
        run.modal.assume(Group::Motion, Function::Line);
        run.modal.owed.owe_motion();
    } else if (run.curve.following->fit->fault() == path::FitFault::Jump) {
        jump_fault(run, instruction, where, run.curve.following->fit->parameter());
        return CurveProgress::Failed;
    }
    run.curve.following.reset();
    return CurveProgress::Done;
}

namespace {

/// Blocks of a spline: by knots one for each of them; by intervals one for each control point but
/// the first.
std::size_t block_count(const Running& run, const path::Nurbs& spline) {
    return run.target.can_write(Function::SplineInterval) ? spline.control_points.size()
                                                          : spline.knots.size();
}

/// One block of the spline: a control point with its knot or its interval, or a knot alone.
Done emit_control_point(Running& run, const FollowedBlock& next, std::uint32_t where) {
    if (!require_room(run, where)) return kFailed;
    const path::Nurbs& spline = run.curve.following->spline;
    const std::size_t i = run.curve.following->next_knot;
    const bool by_intervals = run.target.can_write(Function::SplineInterval);
    nc::Block& block = next_block(run, next.source);
    if (i == (by_intervals ? 1 : 0)) {
        block.motion = Function::Spline;
        block.set_argument(*block.add(Function::SplineDegree, 1),
                           nc::parameter_of<Function::SplineDegree>("degree"), spline.degree);
    }
    const auto degree = static_cast<std::size_t>(spline.degree);
    if (by_intervals) {
        const double interval = spline.knots[degree + i] - spline.knots[degree + i - 1];
        block.set_argument(*block.add(Function::SplineInterval, 1),
                           nc::parameter_of<Function::SplineInterval>("interval"), interval);
    } else {
        block.set_argument(*block.add(Function::SplineKnot, 1),
                           nc::parameter_of<Function::SplineKnot>("knot"), spline.knots[i]);
    }
    if (i < spline.control_points.size()) set_coordinates(run, block, spline.control_points[i]);
    return finish_followed(run, block, next, where);
}

/// A line in all coordinates that the curve has.
Done emit_line(Running& run, const Vec3& to, const FollowedBlock& next, std::uint32_t where) {
    if (!require_room(run, where)) return kFailed;
    nc::Block& block = next_block(run, next.source);
    block.motion = Function::Line;
    set_coordinates(run, block, to);
    return finish_followed(run, block, next, where);
}

void set_coordinates(const Running& run, nc::Block& block, const Vec3& to) {
    const std::array<std::size_t, 3> axes = order_of(run.curve.following->plane);
    for (std::size_t i = 0; i < 3; ++i) {
        if (!run.curve.following->is_given[i]) continue;
        const auto word = static_cast<nc::Slot>(axes[i]);
        block.set(word, to[static_cast<Eigen::Index>(i)] *
                            word_scale(axes[i], run.curve.following->next.is_diameter));
        if (run.modal[Group::Distance] == Function::Incremental) block.absolute |= nc::bit(word);
    }
}

}  // namespace

}  // namespace kadr::expand
