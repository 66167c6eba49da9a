#include "expand/input_frames.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "base/diagnostics/dialect.h"
#include "expand/block_values.h"
#include "expand/blocks.h"
#include "expand/faults.h"
#include "expand/frame_blocks.h"
#include "expand/input_words.h"
#include "expand/plane.h"
#include "expand/unknown.h"
#include "nc/parameters.h"
#include "nc/tables.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using nc::Group;
using nc::Invocation;
using nc::parameter_of;
using nc::parameter_of_all;
namespace custom = sema::custom;

namespace {

/// Which of its parameters the function gets: from the words of the source, or from registers.
std::uint32_t given_to(const sema::Plan& plan, std::size_t invocation) {
    std::uint32_t given = plan.functions[invocation].given;
    for (const sema::Filling& filling : plan.fillings) {
        if (filling.is_argument && filling.invocation == invocation)
            given |= 1u << filling.parameter;
    }
    return given;
}

/// Takes out of the steps what the function deletes.
void delete_steps(control::FrameSteps& steps, const sema::Plan& plan, std::size_t invocation) {
    const Function function = plan.functions[invocation].function;
    if (function == Function::RotateOff) steps.rotate_off();
    if (function == Function::ScaleOff) steps.scale_off();
    if (function == Function::MirrorOff) steps.mirror_off(given_to(plan, invocation));
}

control::ProgramFrame frame_behind(control::FrameSteps steps, const sema::Plan& plan,
                                   std::size_t invocation) {
    delete_steps(steps, plan, invocation);
    return steps.frame().frame;
}

}  // namespace

bool needs_frame(const Running& run, const sema::Plan& plan) {
    for (std::size_t i = 0; i < plan.functions.size(); ++i) {
        if (needs_frame(run, plan, i)) return true;
    }
    return false;
}

bool needs_frame(const Running& run, const sema::Plan& plan, std::size_t invocation) {
    const Function function = plan.functions[invocation].function;
    switch (function) {
        case Function::ShiftAdd: return !run.target.can_write(function);
        // Of some axes: the others' mirrors are written anew.
        case Function::MirrorOff:
            if (frame_behind(run.modal.frame.steps(), plan, invocation).has_mirror()) return true;
            [[fallthrough]];
        // What is left of the text's own steps may be another frame.
        case Function::RotateOff:
        case Function::ScaleOff:
            return !run.target.can_write(function) || run.modal.frame.has_fault() ||
                   !control::is_same(
                       frame_behind(run.modal.frame.steps(), plan, invocation),
                       frame_behind(run.modal.frame.written_steps(), plan, invocation));
        case Function::Rotate:
            return (plan.customs & custom::kRotateReplaces) != 0 &&
                   run.modal.frame.now().angle_deg != 0;
        default: return false;
    }
}

namespace {

/// The first four arguments of a function, mm or degrees.
Done read_arguments(Running& run, const sema::Plan& plan, std::size_t invocation,
                    const Instruction& instruction, const sema::Slot* registers, std::uint32_t at,
                    std::array<double, 4>& values, std::array<bool, 4>& given) {
    const std::size_t first = plan.functions[invocation].first;
    for (const auto& [place, value] : plan.arguments) {
        if (place < first || place >= first + 4) continue;
        values[place - first] = value;
        given[place - first] = true;
    }
    const sema::Slot* numbers = registers + instruction.a;
    for (std::size_t f = 0; f < plan.fillings.size(); ++f) {
        const sema::Filling& filling = plan.fillings[f];
        if (!filling.is_argument || filling.invocation != invocation) continue;
        const double number = numbers[f].number;
        if (!(std::fabs(number) < 1e15)) {
            if (number != number) not_given(run, {}, word_of(run, filling, at));
            else math_fault(run, sema::MathFault::Overflow, at);
            return kFailed;
        }
        values[filling.parameter] = number;
        given[filling.parameter] = true;
    }
    return kDone;
}

void center_unknown(Running& run, Function function, std::size_t axis, std::uint32_t at) {
    fault(run, diag::SourceCenter, at)
        .arg(nc::info(function).name)
        .arg(kAxisNames[axis])
        .fix("name the centre: `" + std::string(kAxisNames[axis]) + "0.`");
}

/// What a block programs besides the functions whose frame has been written.
Done emit_rest(Running& run, const sema::Plan& plan, const Instruction& instruction,
               const sema::Slot* registers, std::uint32_t at) {
    sema::Plan rest = plan;
    std::vector<sema::Slot> values(registers + instruction.a,
                                   registers + instruction.a + plan.fillings.size());
    for (std::size_t i = rest.functions.size(); i-- > 0;) {
        const Function function = rest.functions[i].function;
        const bool is_given = nc::has_fact(function, nc::Fact::ChangesFrame) &&
                              !nc::has_fact(function, nc::Fact::SetsFrame);
        if (!is_given) continue;
        rest.functions.erase(rest.functions.begin() + static_cast<std::ptrdiff_t>(i));
        for (std::size_t f = rest.fillings.size(); f-- > 0;) {
            sema::Filling& filling = rest.fillings[f];
            if (!filling.is_argument || filling.invocation < i) continue;
            if (filling.invocation > i) {
                --filling.invocation;
                continue;
            }
            rest.fillings.erase(rest.fillings.begin() + static_cast<std::ptrdiff_t>(f));
            values.erase(values.begin() + static_cast<std::ptrdiff_t>(f));
        }
    }
    const bool is_empty = rest.functions.empty() && rest.fillings.empty() && rest.given == 0 &&
                          rest.motion == Function::None && instruction.b == 0;
    if (is_empty) return kDone;
    Instruction of_rest = instruction;
    of_rest.a = 0;
    if (instruction.b != 0) {  // the target's three numbers
        of_rest.b = static_cast<decltype(of_rest.b)>(values.size() + 1);
        values.insert(values.end(), registers + instruction.b - 1, registers + instruction.b + 2);
    }
    return emit_block(run, rest, of_rest, values.data(), at);
}

}  // namespace

Done emit_frame(Running& run, const sema::Plan& plan, const Instruction& instruction,
                const sema::Slot* registers, std::uint32_t at) {
    const SourceId source = statement_of(instruction);
    if (run.modal.lost.what() != 0 && !require_frame(run, false, at)) return kFailed;
    control::FrameSteps steps = run.modal.frame.steps();
    const auto say = [&] {
        const auto [next, why] = steps.frame();
        if (why != control::FrameFormFault::None) return refuse_frame(run, why, at);
        write_frame(run, next, source, at, instruction.c);
        run.modal.frame.name_steps(steps);
        return Done(!run.status.has_failed());
    };
    for (std::size_t i = 0; i < plan.functions.size(); ++i) {
        const Function function = plan.functions[i].function;
        // What else stands in the block meets the frame that these leave (emit_rest).
        const bool is_bound = (plan.customs & custom::kFrameOrder) != 0 &&
                              nc::has_fact(function, nc::Fact::ChangesFrame);
        if (is_bound && !require_free_frame(run, function, at)) return kFailed;
        delete_steps(steps, plan, i);
        if (function != Function::ShiftAdd && function != Function::Rotate) continue;
        // These stand in blocks of their own: nothing is left to write.
        std::array<double, 4> values{};
        std::array<bool, 4> given{};
        if (!read_arguments(run, plan, i, instruction, registers, at, values, given))
            return kFailed;
        if (function == Function::ShiftAdd) {
            constexpr std::size_t kX = parameter_of<Function::ShiftAdd>("x");
            steps.shift_add({values[kX], values[kX + 1], values[kX + 2]},
                            {given[kX], given[kX + 1], given[kX + 2]});
        } else {
            constexpr std::size_t kRotation = parameter_of<Function::Rotate>("angle");
            constexpr std::size_t kX = parameter_of<Function::Rotate>("x");
            const PlaneIndices plane = indices_of(plane_of(run.modal[Group::Plane]));
            for (const std::size_t axis : {plane.first, plane.second}) {
                if (given[kX + axis] || (plan.customs & custom::kCenterAtTool) == 0) continue;
                center_unknown(run, function, axis, at);
                return kFailed;
            }
            steps.rotate_off();
            steps.rotate(values[kRotation], run.modal[Group::Plane],
                         {values[kX], values[kX + 1], values[kX + 2]});
        }
        return say();
    }
    if (!say()) return kFailed;
    return emit_rest(run, plan, instruction, registers, at);
}

Done require_free_frame(Running& run, Function function, std::uint32_t at) {
    const bool is_other_plane =
        nc::info(function).group == Group::Plane && function != run.modal[Group::Plane];
    const bool of_rotation = nc::has_fact(function, nc::Fact::BeforeRotation) || is_other_plane;
    const bool of_scale = of_rotation && nc::has_fact(function, nc::Fact::ChangesFrame);
    // It replaces the frame of the language, and on the control acts outside of the mirror.
    const bool of_mirror = function == Function::Shift;
    const control::ProgramFrame& frame = run.modal.frame.now();
    const char* inside = of_rotation && frame.angle_deg != 0 ? "rotation"
                         : of_scale && frame.has_scale()     ? "scale"
                         : of_mirror && frame.has_mirror()   ? "mirror"
                                                             : nullptr;
    if (inside == nullptr) return kDone;
    fault(run, diag::SourceFrame, at).arg(nc::info(function).name).arg(inside);
    return kFailed;
}

void adapt_shift(Running& run, Block& block, Invocation& shift) {
    if (shift.given == 0) return;
    constexpr std::size_t kX = parameter_of<Function::Shift>("x");
    for (std::size_t i = 0; i < 3; ++i) {
        if (!shift.has(kX + i) && run.modal.frame.now().is_shifted[i])
            block.set_argument(shift, kX + i, run.modal.frame.now().shift[i]);
    }
}

Done complete_center(Running& run, Block& block, Invocation& invocation, std::uint32_t at) {
    const bool is_rotation = invocation.function == Function::Rotate;
    if (!is_rotation && invocation.function != Function::Scale) return kDone;
    constexpr std::size_t kX = parameter_of_all<"x", Function::Rotate, Function::Scale>();
    const PlaneIndices plane = indices_of(plane_of(run.modal[Group::Plane]));
    for (std::size_t i = 0; i < 3; ++i) {
        if (invocation.has(kX + i) || (is_rotation && i == plane.across)) continue;
        // Inside another one the coordinates count otherwise than those of its centre.
        const bool is_known = run.modal.position.knows(i) && run.modal.frame.now().angle_deg == 0 &&
                              !run.modal.frame.now().has_scale();
        if (is_known) {
            block.set_argument(invocation, kX + i, run.modal.position[i]);
            continue;
        }
        center_unknown(run, invocation.function, i, at);
        return kFailed;
    }
    return kDone;
}

}  // namespace kadr::expand
