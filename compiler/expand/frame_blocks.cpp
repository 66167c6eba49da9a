// frame_blocks.cpp — frames as blocks, and where the tool is in a new one.
#include "expand/frame_blocks.h"

#include <array>
#include <cmath>
#include <span>

#include "base/diagnostics/expand.h"
#include "expand/blocks.h"
#include "expand/contour_recording.h"
#include "expand/faults.h"
#include "expand/numbers.h"
#include "expand/orienting.h"
#include "expand/running.h"
#include "expand/tilted_planes.h"
#include "expand/unknown.h"
#include "nc/frame_words.h"
#include "nc/parameters.h"
#include "nc/tables.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using nc::Group;
using nc::parameter_of;
using nc::parameter_of_all;

namespace {

constexpr std::size_t kAngle = parameter_of<Function::Rotate>("angle");
constexpr std::size_t kCenter = parameter_of_all<"x", Function::Rotate, Function::Scale>();
constexpr std::size_t kOfAll = parameter_of<Function::Scale>("factor");
constexpr std::size_t kOfX = parameter_of<Function::Scale>("fx");
constexpr std::size_t kOfY = parameter_of<Function::Scale>("fy");
constexpr std::size_t kOfZ = parameter_of<Function::Scale>("fz");

/// Factors beyond these are a mistake on every control, and their words lose the value.
///
/// source       F PS0142: 0 and from 10000 on
constexpr double kLeastFactor = 1e-5;
constexpr double kFactorLimit = 10000;

constexpr double kTurnDeg = 360;

Done check_factor(Running& run, double factor, std::uint32_t at) {
    const double size = std::fabs(factor);
    const bool is_sized = size >= kLeastFactor && size < kFactorLimit;
    if (is_sized && factor > 0) return kDone;
    auto builder =
        fault(run, is_sized || factor == 0 ? diag::FrameScale : diag::FrameScaleRange, at);
    builder.arg(factor);
    if (is_sized)
        builder.fix(
            "use `mirror(…)` to turn a side over, in a FANUC's source "
            "`G51.1`, in a "
            "SINUMERIK's `AMIRROR`");
    else if (factor == 0)
        builder.fix(
            "`scale_off()` ends a scale, in a FANUC's source `G50`, in a "
            "SINUMERIK's "
            "`SCALE`");
    else builder.fix("is it a percentage? 1 is the size as programmed");
    return kFailed;
}

}  // namespace

Done settle_frame(Running& run, Block& block, std::uint32_t at) {
    for (std::size_t i = 0; i < block.function_count; ++i) {
        nc::Invocation& frame = block.functions[i];
        if (frame.function == Function::Rotate && frame.has(kAngle))
            block.set_argument(frame, kAngle, std::fmod(block.argument(frame, kAngle), kTurnDeg));
        if (frame.function == Function::MirrorOff) frame.given = 0;  // none stays
        if (frame.function != Function::Scale) continue;
        for (const std::size_t k : {kOfAll, kOfX, kOfY, kOfZ})
            if (frame.has(k) && !check_factor(run, block.argument(frame, k), at)) return kFailed;
    }
    return kDone;
}

Done change_frame(Running& run, const Instruction& instruction, const sema::Slot* registers,
                  std::uint32_t at) {
    if (run.recordings.is_open()) return refuse_in_contour(run, "a frame", at);
    if (run.modal.tilt.kind() == PlaneTilt::Closed)
        return refuse_in_tilted_plane(run, "a frame", at);
    if (run.modal.tcp.is_length()) return refuse_under_tcp(run, "a frame", at);
    const sema::Slot* values = registers + instruction.a;
    const SourceId source = statement_of(instruction);
    const auto change = static_cast<sema::WithFrame>(instruction.b);
    const std::size_t count = change == sema::WithFrame::Rotate  ? 4
                              : change == sema::WithFrame::Scale ? 7
                                                                 : 3;
    if (run.modal.lost.what() != 0 && !require_frame(run, change == sema::WithFrame::Rotate, at))
        return kFailed;
    std::array<double, 7> numbers{};
    std::array<bool, 7> is_given{};
    for (std::size_t i = 0; i < count; ++i) {
        is_given[i] = values[i].number == values[i].number;
        numbers[i] = is_given[i] ? values[i].number : 0;
        if (!is_sane(numbers[i])) {
            math_fault(run, sema::MathFault::Overflow, at);
            return kFailed;
        }
    }
    const auto three = [&](std::size_t first) {
        return std::array<double, 3>{numbers[first], numbers[first + 1], numbers[first + 2]};
    };
    constexpr std::size_t kX = parameter_of_all<"x", Function::Shift, Function::Mirror>();
    const std::array<bool, 3> given{is_given[kX], is_given[kX + 1], is_given[kX + 2]};
    control::FrameSteps steps = run.modal.frame.steps();
    switch (change) {
        case sema::WithFrame::Shift: steps.shift_add(three(kX), given); break;
        case sema::WithFrame::Rotate:
            steps.rotate(numbers[kAngle], run.modal[Group::Plane], three(kCenter));
            break;
        case sema::WithFrame::Scale: {
            std::array<double, 3> factors{};
            for (std::size_t i = 0; i < 3; ++i) {
                factors[i] = is_given[kOfX + i] ? numbers[kOfX + i]
                             : is_given[kOfAll] ? numbers[kOfAll]
                                                : 1;
                if (!check_factor(run, factors[i], at)) return kFailed;
            }
            steps.scale(factors, three(kCenter));
            break;
        }
        case sema::WithFrame::Mirror: steps.mirror(given); break;
    }
    const auto [next, why] = steps.frame();
    if (why != control::FrameFormFault::None) return refuse_frame(run, why, at);
    write_frame(run, next, source, at, instruction.c);
    run.modal.frame.name_steps(steps);
    return Done(!run.status.has_failed());
}

Done refuse_frame(Running& run, control::FrameFormFault why, std::uint32_t at) {
    fault(run, why == control::FrameFormFault::Planes ? diag::FramePlanes : diag::FrameStretched,
          at);
    return kFailed;
}

void write_position(Running& run, const sema::Plan& plan, const Instruction& instruction,
                    std::uint32_t at) {
    const nc::SlotMask known = run.modal.position.known() & nc::kTargetSlots;
    const bool moves = plan.given != 0 || !plan.fillings.empty();
    if (!moves || run.recordings.is_open()) return;
    run.modal.owed.owe_position(false);
    if (known == 0) return;
    const SourceId source = statement_of(instruction);
    Block& block = next_block(run, source);
    block.kind = Block::Kind::Position;
    for (std::size_t i = 0; i < kAxes; ++i) {
        const auto slot = static_cast<nc::Slot>(i);
        if ((known & nc::bit(slot)) != 0) block.set(slot, run.modal.position[i]);
    }
    if (run.options.trace) keep_trace(run, at, instruction.c, source);
}

void scale_frame_x(const Running& run, Block& block, double factor) {
    if (!run.modal.is_diameter) return;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        nc::Invocation& invocation = block.functions[i];
        const std::optional<std::size_t> x = nc::frame_x(invocation.function);
        if (!x || !invocation.has(*x)) continue;
        block.set_argument(invocation, *x, factor * block.argument(invocation, *x));
    }
}

void write_frame(Running& run, const control::ProgramFrame& next, SourceId source, std::uint32_t at,
                 unsigned depth) {
    const control::ProgramFrame from = run.modal.frame.now();
    // Whatever acts is deleted.
    const bool is_lost = run.modal.lost.has(sema::kFrameBit) || run.modal.frame.has_fault();
    if (from == next && !is_lost) return;
    const auto add = [&](Function function, std::span<const double> values,
                         std::span<const bool> given) {
        if (run.status.has_failed() || !require_room(run, at)) return;
        Block& block = next_block(run, source);
        nc::Invocation* invocation = block.add(function, values.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (given[i]) block.set_argument(*invocation, i, values[i]);
        }
        if (run.target.rules().shift_in_diameter) scale_frame_x(run, block, 2);
        if (run.options.trace) keep_trace(run, at, depth, source);
    };
    const std::array<bool, 3> none{};
    // What is in force already need not be written anew, if nothing behind it has to go.
    const bool keeps_shift = from.shift == next.shift && from.is_shifted == next.is_shifted;
    const bool keeps_mirrors = !from.has_mirror() || from.is_mirrored == next.is_mirrored;
    const bool adds_only =
        keeps_shift && keeps_mirrors && from.angle_deg == 0 && !from.has_scale() && !is_lost;
    if (!adds_only) {
        std::array<bool, 3> given = next.is_shifted;
        const bool is_zero = next.shift == std::array<double, 3>{};
        if (is_zero) {
            given = none;
            // A component that was shifted before must be named to go back.
        } else {
            for (std::size_t i = 0; i < 3; ++i)
                given[i] = given[i] || from.is_shifted[i] || is_lost;
        }
        add(Function::Shift, next.shift, given);
    }
    // A rotation is of the plane that acts where it stands.
    const Function plane = run.modal[Group::Plane];
    const bool is_in_other = plane != Function::None && plane != next.plane;
    const auto add_rotation = [&] {
        if (next.angle_deg == 0) return;
        if (is_in_other) add(next.plane, {}, {});
        const std::array<double, 3> center = next.inner_center();
        const bool has_center = next.has_center();
        const bool is_xy = next.plane == Function::PlaneXy;
        const bool is_zx = next.plane == Function::PlaneZx;
        add(Function::Rotate, std::array{next.inner_angle_deg(), center[0], center[1], center[2]},
            std::array{true, has_center && (is_xy || is_zx), has_center && !is_zx,
                       has_center && !is_xy});
        if (is_in_other) add(plane, {}, {});
    };
    if (next.has_mirror() && !(adds_only && from.has_mirror()))
        add(Function::Mirror, std::array<double, 3>{}, next.is_mirrored);
    if (next.is_stretched(next.plane)) add_rotation();
    if (next.has_scale()) {
        const auto& [fx, fy, fz] = next.scale;
        const bool is_equal = fx == fy && fy == fz;
        add(Function::Scale, std::array<double, 7>{fx, 0, 0, 0, fx, fy, fz},
            std::array{is_equal, false, false, false, !is_equal && fx != 1, !is_equal && fy != 1,
                       !is_equal && fz != 1});
    }
    if (!next.is_stretched(next.plane)) add_rotation();
    run.modal.put_frame(next, source);
    run.modal.lost.regain(sema::kFrameBit);
}

void put_frame_again(Running& run, SourceId source, std::uint32_t at, unsigned depth) {
    const bool is_known = !run.modal.lost.has(sema::kFrameBit);
    if (!is_known || run.modal.frame.now().is_identity()) return;
    run.modal.lost.lose_again(sema::kFrameBit);  // whatever acts is deleted
    const control::FrameSteps steps = run.modal.frame.steps();
    write_frame(run, run.modal.frame.now(), source, at, depth);
    run.modal.frame.name_steps(steps);
}

}  // namespace kadr::expand
