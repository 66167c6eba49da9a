// curves.cpp — curves of a running program: their points with derivatives, and the blocks that are
// fitted to them.
#include <cmath>

#include "base/diagnostics/expand.h"
#include "base/numbers.h"
#include "expand/numbers.h"
#include "expand/plane.h"
#include "expand/state.h"

namespace kadr::expand {

using nc::Function;
using nc::Group;
using path::Vec2;
using path::Vec3;
using sema::CurveSlot;
using sema::Slot;

namespace {

constexpr std::size_t at(CurveSlot slot) { return static_cast<std::size_t>(slot); }

/// First and second axis of the plane, then the one across.
std::array<std::size_t, 3> order_of(path::Plane plane) {
    const PlaneIndices axes = indices_of(plane);
    return {axes.first, axes.second, axes.across};
}

}  // namespace

/// Calls the curve's function in the registers behind those of the caller.
std::optional<path::CurveSample> Expander::State::curve_point(const Instruction& instruction,
                                                              std::uint32_t where,
                                                              double parameter) {
    const sema::FunctionCode& function =
        code.functions[static_cast<std::size_t>(instruction.immediate.pair.first)];
    if (frames.size() > options.limits.call_depth) {
        fault(diag::CallDepthLimit, where)
            .arg(static_cast<std::int64_t>(options.limits.call_depth));
        return std::nullopt;
    }
    const CallFrame caller = frames.back();
    const std::uint32_t base = caller.base + caller.function->registers;
    reserve_stack(std::size_t{base} + function.registers + 8);
    slopes.resize(stack.size());
    const std::size_t arguments = caller.base + instruction.a + at(CurveSlot::Arguments);
    const std::size_t running = function.parameters.back().slot;
    for (std::size_t i = 0; i < running; ++i) {
        stack[base + i] = stack[arguments + i];
        slopes[base + i] = 0;
    }
    stack[base + running].number = parameter;
    slopes[base + running] = 1;
    CallFrame& frame = frames.push();
    frame = {};
    frame.function = &function;
    frame.return_to = where + 1;  // CurveEnd
    frame.base = base;
    frame.given = static_cast<std::uint32_t>(code.instructions[where + 1].immediate.pair.first);
    frame.promises = static_cast<std::uint32_t>(promises.size());
    frame.loops = caller.loops;
    const std::size_t number = static_cast<std::size_t>(instruction.immediate.pair.first);
    pc = frame.given == all_given[number] ? function.body : function.entry;
    is_in_curve = true;
    run<false, true>();
    is_in_curve = false;
    if (has_failed) return std::nullopt;

    Following& curve = *following;
    path::CurveSample sample;
    const std::array<std::size_t, 3> axes = order_of(curve.plane);
    for (std::size_t i = 0; i < 3; ++i) {
        const double value = stack[base + axes[i]].number;
        const bool is_given = value == value;
        if (!curve.has_coordinates) curve.is_given[i] = is_given;
        if (curve.is_given[i] != is_given) {
            fault(diag::CurveCoordinate, where)
                .arg(function.name)
                .arg(std::string(1, "xyz"[axes[i]]))
                .arg(function.parameters.back().name)
                .arg(quantity_text(parameter, function.parameters.back().quantity));
            return std::nullopt;
        }
        if (!is_given) continue;
        if (!is_sane(value)) {
            math_fault(sema::MathFault::Overflow, where);
            return std::nullopt;
        }
        // The curve gives words; what is fitted is the path of the tool.
        const double scale = word_scale(axes[i], modal.is_diameter);
        sample.position[static_cast<Eigen::Index>(i)] = value / scale;
        sample.derivative[static_cast<Eigen::Index>(i)] = slopes[base + axes[i]] / scale;
    }
    return sample;
}

Done Expander::State::start_curve(const Instruction& instruction, std::uint32_t where) {
    if (is_between_positions()) return refuse_beside_cycle("a curve", where);
    const Slot* options_of = stack.data() + frames.back().base + instruction.a;
    const double tolerance = options_of[at(CurveSlot::Tolerance)].number;
    if (!(tolerance >= kLeastTolerance) || !is_sane(tolerance)) {
        fault(diag::CurveTolerance, where).arg(quantity_text(tolerance, sema::kLength));
        return kFailed;
    }
    following.emplace();
    Following& curve = *following;
    curve.plane = plane_of(modal[Group::Plane]);
    curve.next.source = {static_cast<std::uint32_t>(instruction.immediate.pair.second)};
    curve.next.depth = instruction.c;
    curve.next.feed = options_of[at(CurveSlot::Feed)].number;
    curve.next.is_diameter = modal.is_diameter;
    path::FitOptions fit;
    fit.tolerance = tolerance;
    fit.from = options_of[at(CurveSlot::From)].number;
    fit.to = options_of[at(CurveSlot::To)].number;
    const bool wants_arcs = options_of[at(CurveSlot::Arcs)].integer != 0;
    // Contours are made of lines and arcs.
    const bool wants_nurbs = options_of[at(CurveSlot::Nurbs)].integer != 0 && recordings.empty();
    // The first point tells which coordinates the curve has.
    const std::optional<path::CurveSample> first = curve_point(instruction, where, fit.from);
    if (!first) return kFailed;
    curve.has_coordinates = true;
    if (fit.from == fit.to) {
        const sema::FunctionCode& function =
            code.functions[static_cast<std::size_t>(instruction.immediate.pair.first)];
        fault(diag::CurveIsPoint, where)
            .arg(function.name)
            .arg(function.parameters.back().name)
            .arg(quantity_text(fit.from, function.parameters.back().quantity));
    }
    const bool is_flat = curve.is_given[0] && curve.is_given[1] && !curve.is_given[2];
    const bool has_arcs = target.can_write(Function::ArcCw) && target.can_write(Function::ArcCcw);
    fit.kind = is_flat && has_arcs && wants_arcs ? path::FitKind::Biarcs : path::FitKind::Lines;
    keep_back_rounding(where, is_flat ? 2 : 3, fit);
    if (!start_fit(instruction, where, wants_nurbs, fit)) return kFailed;
    curve.at = first->position.head<2>();
    // To the start, unless the tool is there.
    const std::array<std::size_t, 3> axes = order_of(curve.plane);
    bool is_there = true;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!curve.is_given[i]) continue;
        const bool is_known = (modal.known >> axes[i] & 1u) != 0;
        const double distance = modal.position[axes[i]] / word_scale(axes[i], modal.is_diameter) -
                                first->position[static_cast<Eigen::Index>(i)];
        is_there = is_there && is_known && std::fabs(distance) <= path::kSamePoint;
    }
    if (is_there) return kDone;
    if (!emit_line(first->position, curve.next, where)) return kFailed;
    curve.next.feed = sema::kNotGivenNumber;
    return kDone;
}

/// The text rounds every coordinate by up to half of an increment, which is a part of the
/// tolerance.
void Expander::State::keep_back_rounding(std::uint32_t where, int coordinates,
                                         path::FitOptions& fit) {
    const bool is_inch = modal[Group::Units] == Function::Inch;
    const double increment = target.written_increment(is_inch);
    const double rounding = std::sqrt(coordinates) * increment / 2;
    const double asked = fit.tolerance;
    fit.tolerance = std::max(asked - rounding, asked / 2);
    if (fit.tolerance + rounding <= asked || !reported_at.first_time(NoticeAt::Tolerance, where))
        return;
    fault(diag::CurveIncrement, where)
        .arg(quantity_text(increment, sema::kLength))
        .arg(quantity_text(round_to(fit.tolerance + rounding, 5), sema::kLength))
        .arg(quantity_text(asked, sema::kLength));
}

/// As one spline if that is asked for and the control has it; else as lines or arcs, piece by
/// piece.
Done Expander::State::start_fit(const Instruction& instruction, std::uint32_t where,
                                bool wants_nurbs, const path::FitOptions& fit) {
    const bool has_splines =
        target.can_write(Function::Spline) &&
        (target.can_write(Function::SplineInterval) || target.can_write(Function::SplineKnot));
    if (wants_nurbs && has_splines) return fit_spline(instruction, where, fit);
    if (wants_nurbs && reported_at.first_time(NoticeAt::Spline, where)) {
        fault(diag::SplineFallback, where)
            .arg(target.name())
            .arg(fit.kind == path::FitKind::Biarcs ? "arcs" : "lines");
    }
    const Instruction* self = &instruction;
    following->fit = std::make_unique<path::CurveFit>(
        [this, self, where](double parameter) { return curve_point(*self, where, parameter); },
        fit);
    return kDone;
}

Done Expander::State::fit_spline(const Instruction& instruction, std::uint32_t where,
                                 const path::FitOptions& fit) {
    path::SplineFitResult fitted = path::fit_spline(
        [&](double parameter) { return curve_point(instruction, where, parameter); }, fit);
    if (has_failed) return kFailed;
    if (fitted.fault) {
        jump_fault(instruction, where, fitted.parameter);
        return kFailed;
    }
    following->spline = std::move(fitted.spline);
    // By intervals the first control point is where the tool is anyway.
    following->next_knot = target.can_write(Function::SplineInterval) ? 1 : 0;
    return kDone;
}

void Expander::State::jump_fault(const Instruction& instruction, std::uint32_t where,
                                 double parameter) {
    const sema::FunctionCode& function =
        code.functions[static_cast<std::size_t>(instruction.immediate.pair.first)];
    fault(diag::CurveJump, where)
        .arg(function.name)
        .arg(function.parameters.back().name)
        .arg(quantity_text(parameter, function.parameters.back().quantity));
}

Expander::State::Progress Expander::State::follow_curve(const Instruction& instruction,
                                                        std::uint32_t where) {
    if (is_in_curve) {
        fault(diag::CurveBlock, where);
        return Progress::Failed;
    }
    if (!following && !start_curve(instruction, where)) return Progress::Failed;
    for (;;) {
        const bool has_room = !recordings.empty() || batch_count < batch_size;
        if (!has_room) return Progress::BatchFull;
        Following& curve = *following;
        if (curve.fit == nullptr) {
            if (curve.next_knot >= block_count(curve.spline)) break;
            if (!emit_control_point(curve.next, where)) return Progress::Failed;
            ++curve.next_knot;
            curve.next.feed = sema::kNotGivenNumber;
            continue;
        }
        const std::optional<path::FitPiece> piece = curve.fit->next();
        if (!piece) break;
        const Vec2 to = piece->to.head<2>();
        if (piece->sweep == 0) {
            if (!emit_line(piece->to, curve.next, where)) return Progress::Failed;
        } else {
            const path::Element arc{curve.at, to, piece->center, piece->sweep};
            if (!emit_element(arc, curve.next, where)) return Progress::Failed;
        }
        curve.at = to;
        curve.next.feed = sema::kNotGivenNumber;
    }
    if (has_failed) return Progress::Failed;
    if (following->fit == nullptr) {
        // A position by itself behind the spline is no further control point of it.
        modal.assume(Group::Motion, Function::Line);
        modal.restate_motion = true;
    } else if (following->fit->fault() == path::FitFault::Jump) {
        jump_fault(instruction, where, following->fit->parameter());
        return Progress::Failed;
    }
    following.reset();
    return Progress::Done;
}

/// Blocks of a spline: by knots one for each of them; by intervals one for each control point but
/// the first.
std::size_t Expander::State::block_count(const path::Nurbs& spline) const {
    return target.can_write(Function::SplineInterval) ? spline.control_points.size()
                                                      : spline.knots.size();
}

/// One block of the spline: a control point with its knot or its interval, or a knot alone.
Done Expander::State::emit_control_point(const FollowedBlock& next, std::uint32_t where) {
    if (!require_room(where)) return kFailed;
    const path::Nurbs& spline = following->spline;
    const std::size_t i = following->next_knot;
    const bool by_intervals = target.can_write(Function::SplineInterval);
    nc::Block& block = next_block(next.source);
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
    if (i < spline.control_points.size()) set_coordinates(block, spline.control_points[i]);
    return finish_followed(block, next, where);
}

/// A line in all coordinates that the curve has.
Done Expander::State::emit_line(const Vec3& to, const FollowedBlock& next, std::uint32_t where) {
    if (!require_room(where)) return kFailed;
    nc::Block& block = next_block(next.source);
    block.motion = Function::Line;
    set_coordinates(block, to);
    return finish_followed(block, next, where);
}

void Expander::State::set_coordinates(nc::Block& block, const Vec3& to) const {
    const std::array<std::size_t, 3> axes = order_of(following->plane);
    for (std::size_t i = 0; i < 3; ++i) {
        if (!following->is_given[i]) continue;
        const auto word = static_cast<nc::Slot>(axes[i]);
        block.set(word, to[static_cast<Eigen::Index>(i)] *
                            word_scale(axes[i], following->next.is_diameter));
        if (modal[Group::Distance] == Function::Incremental) block.absolute |= nc::bit(word);
    }
}

}  // namespace kadr::expand
