// frame_blocks.cpp — frames as blocks, and where the tool is in a new one.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/diagnostics/expand.h"
#include "expand/numbers.h"
#include "expand/state.h"
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

}  // namespace

Done Expander::State::check_factor(double factor, std::uint32_t at) {
    const double size = std::fabs(factor);
    const bool is_sized = size >= kLeastFactor && size < kFactorLimit;
    if (is_sized && factor > 0) return kDone;
    auto builder = fault(is_sized || factor == 0 ? diag::FrameScale : diag::FrameScaleRange, at);
    builder.arg(factor);
    if (is_sized)
        builder.fix(
            "use `mirror(…)` to turn a side over, in a FANUC's source `G51.1`, in a "
            "SINUMERIK's `AMIRROR`");
    else if (factor == 0)
        builder.fix(
            "`scale_off()` ends a scale, in a FANUC's source `G50`, in a SINUMERIK's "
            "`SCALE`");
    else builder.fix("is it a percentage? 1 is the size as programmed");
    return kFailed;
}

/// The values of frames that a block has itself: mirrors that all end, factors that are some, and
/// an angle of less than a revolution, which is all that controls take (F 3.7 G68: ±360).
Done Expander::State::settle_frame(Block& block, std::uint32_t at) {
    for (std::size_t i = 0; i < block.function_count; ++i) {
        nc::Invocation& frame = block.functions[i];
        if (frame.function == Function::Rotate && frame.has(kAngle))
            block.set_argument(frame, kAngle, std::fmod(block.argument(frame, kAngle), kTurnDeg));
        if (frame.function == Function::MirrorOff) frame.given = 0;  // none stays
        if (frame.function != Function::Scale) continue;
        for (const std::size_t k : {kOfAll, kOfX, kOfY, kOfZ})
            if (frame.has(k) && !check_factor(block.argument(frame, k), at)) return kFailed;
    }
    return kDone;
}

Done Expander::State::change_frame(const Instruction& instruction, const sema::Slot* registers,
                                   std::uint32_t at) {
    if (!recordings.empty()) return refuse_in_contour("a frame", at);
    if (modal.tilt == ModalState::PlaneTilt::Closed) return refuse_in_tilted_plane("a frame", at);
    if (modal.tcp == ModalState::Tcp::Length) return refuse_under_tcp("a frame", at);
    const sema::Slot* values = registers + instruction.a;
    const SourceId source{static_cast<std::uint32_t>(instruction.immediate.pair.second)};
    const auto change = static_cast<sema::WithFrame>(instruction.b);
    const std::size_t count = change == sema::WithFrame::Rotate  ? 4
                              : change == sema::WithFrame::Scale ? 7
                                                                 : 3;
    if (modal.lost != 0 && !require_frame(change == sema::WithFrame::Rotate, at)) return kFailed;
    std::array<double, 7> numbers{};
    std::array<bool, 7> is_given{};
    for (std::size_t i = 0; i < count; ++i) {
        is_given[i] = values[i].number == values[i].number;
        numbers[i] = is_given[i] ? values[i].number : 0;
        if (!is_sane(numbers[i])) {
            math_fault(sema::MathFault::Overflow, at);
            return kFailed;
        }
    }
    const auto three = [&](std::size_t first) {
        return std::array<double, 3>{numbers[first], numbers[first + 1], numbers[first + 2]};
    };
    constexpr std::size_t kX = parameter_of_all<"x", Function::Shift, Function::Mirror>();
    const std::array<bool, 3> given{is_given[kX], is_given[kX + 1], is_given[kX + 2]};
    control::FrameSteps steps = modal.steps;
    switch (change) {
        case sema::WithFrame::Shift: steps.shift_add(three(kX), given); break;
        case sema::WithFrame::Rotate:
            steps.rotate(numbers[kAngle], modal[Group::Plane], three(kCenter));
            break;
        case sema::WithFrame::Scale: {
            std::array<double, 3> factors{};
            for (std::size_t i = 0; i < 3; ++i) {
                factors[i] = is_given[kOfX + i] ? numbers[kOfX + i]
                             : is_given[kOfAll] ? numbers[kOfAll]
                                                : 1;
                if (!check_factor(factors[i], at)) return kFailed;
            }
            steps.scale(factors, three(kCenter));
            break;
        }
        case sema::WithFrame::Mirror: steps.mirror(given); break;
    }
    const auto [next, why] = steps.frame();
    if (why != control::FrameFormFault::None) return refuse_frame(why, at);
    write_frame(next, source, at, instruction.c);
    modal.steps = steps;
    return Done(!has_failed);
}

/// No frame of the language is what the steps make.
Done Expander::State::refuse_frame(control::FrameFormFault why, std::uint32_t at) {
    fault(why == control::FrameFormFault::Planes ? diag::FramePlanes : diag::FrameStretched, at);
    return kFailed;
}

/// The writer needs to know where the tool is in the new frame: for arcs, for F of helices, and
/// where the control has no words for coordinates and distances beside each other.
void Expander::State::write_position(const sema::Plan& plan, const Instruction& instruction,
                                     std::uint32_t at) {
    const nc::SlotMask known = modal.known & nc::kTargetSlots;
    const bool moves = plan.given != 0 || !plan.fillings.empty();
    if (!moves || !recordings.empty()) return;
    modal.is_position_due = false;
    if (known == 0) return;
    const SourceId source{static_cast<std::uint32_t>(instruction.immediate.pair.second)};
    Block& block = next_block(source);
    block.kind = Block::Kind::Position;
    for (std::size_t i = 0; i < kAxes; ++i) {
        const auto slot = static_cast<nc::Slot>(i);
        if ((known & nc::bit(slot)) != 0) block.set(slot, modal.position[i]);
    }
    if (options.trace) keep_trace(at, instruction.c, source);
}

/// Frames have radii in the language; a control may take them as what X is.
void Expander::State::scale_frame_x(Block& block, double factor) const {
    if (!modal.is_diameter) return;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        nc::Invocation& invocation = block.functions[i];
        const std::optional<std::size_t> x = nc::frame_x(invocation.function);
        if (!x || !invocation.has(*x)) continue;
        block.set_argument(invocation, *x, factor * block.argument(invocation, *x));
    }
}

/// Writes the change from the present frame to another one in functions that every control has: the
/// whole shift, which deletes all else, then mirrors, scale and rotation anew, in the order in
/// which FANUC takes them. An unequal scale stands inside the rotation.
void Expander::State::write_frame(const control::ProgramFrame& next, SourceId source,
                                  std::uint32_t at, unsigned depth) {
    const control::ProgramFrame from = modal.frame;
    // Whatever acts is deleted.
    const bool is_lost =
        (modal.lost & sema::kFrameBit) != 0 || modal.frame_fault != control::FrameFormFault::None;
    if (from == next && !is_lost) return;
    const auto add = [&](Function function, std::span<const double> values,
                         std::span<const bool> given) {
        if (has_failed || !require_room(at)) return;
        Block& block = next_block(source);
        nc::Invocation* invocation = block.add(function, values.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (given[i]) block.set_argument(*invocation, i, values[i]);
        }
        if (target.rules().shift_in_diameter) scale_frame_x(block, 2);
        if (options.trace) keep_trace(at, depth, source);
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
    const Function plane = modal[Group::Plane];
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
    modal.put_frame(next, source);
    modal.lost &= ~sema::kFrameBit;
}

/// The whole frame of the program, where the control may have taken it off: written on top of
/// itself it is the same. S 7.1.
void Expander::State::put_frame_again(SourceId source, std::uint32_t at, unsigned depth) {
    const bool is_known = (modal.lost & sema::kFrameBit) == 0;
    if (!is_known || modal.frame.is_identity()) return;
    modal.lost |= sema::kFrameBit;  // whatever acts is deleted
    const control::FrameSteps steps = modal.steps;
    write_frame(modal.frame, source, at, depth);
    modal.steps = steps;
}

}  // namespace kadr::expand
