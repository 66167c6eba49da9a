// frame_words.cpp — words of frames: work offsets, shifts, rotations, scales.
#include <algorithm>
#include <bit>

#include "base/assert.h"
#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "base/units.h"
#include "interp/block_words.h"
#include "interp/executor.h"
#include "nc/parameters.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using nc::parameter_of_all;
using path::Op;

void Executor::select_work_offset(const Block& block, std::int64_t number) {
    if (number < 0 || number > rules_.work_offsets) {
        report(diag::WorkOffsetUnknown, block, Function::WorkOffset).arg(number);
        return;
    }
    frames_.select_work_offset(work_offset_frame(number));
    select_stored_bases();
    work_offset_ = number;
    frame_changed();
}

void Executor::apply_frame(const Block& block, const Invocation& invocation) {
    const bool is_set = invocation.function == Function::SetPosition ||
                        invocation.function == Function::SetPositionAxes ||
                        invocation.function == Function::PositionReset;
    if (is_set && cycles_said_.modal.is_active) {
        report(diag::SetPositionInCycle, block, invocation.function);
        return;
    }
    const bool is_compensated = comp_.is_on() && rules_.comp_is_innermost;
    if (is_compensated && nc::has_fact(invocation.function, nc::Fact::LetsCompGo) &&
        !cycle_.blocks) {
        send_comp({CompChange::Kind::LetGo, {}, modal_.plane, 0, position_.base, {}, {}});
        if (ended_) return;
    }
    const double x_scale = rules_.shift_in_diameter ? axes_.word_scale[index(Axis::X)] : 1;
    const bool is_of_axes = invocation.function == Function::ShiftAxes ||
                            invocation.function == Function::ShiftAxesAdd ||
                            invocation.function == Function::SetPositionAxes;
    constexpr std::size_t kX =
        parameter_of_all<"x", Function::Shift, Function::ShiftAdd, Function::ShiftAxes,
                         Function::ShiftAxesAdd, Function::ShiftCoarse, Function::ShiftFine,
                         Function::Mirror, Function::MirrorOff, Function::SetPosition,
                         Function::SetPositionAxes, Function::PositionReset>();
    const control::FrameWords words =
        frame_words(block, invocation, kX, x_scale, is_of_axes ? std::size_t{6} : std::size_t{3});
    if (is_of_axes && !require_named_axes(block, invocation, static_cast<AxisMask>(words.given)))
        return;
    switch (invocation.function) {
        case Function::Shift:
        case Function::ShiftAxes: frames_.shift(words); break;
        case Function::ShiftAdd:
        case Function::ShiftAxesAdd: frames_.shift_add(words); break;
        case Function::ShiftCoarse: frames_.set_coarse(words); break;
        case Function::ShiftFine: frames_.set_fine(words); break;
        case Function::RotateSpace:
        case Function::RotateSolid: rotate_in_space(block, invocation); break;
        case Function::Rotate:
            frames_.rotate(
                plane_in(block),
                rad_from_deg(block.argument(invocation, parameter_of<Function::Rotate>("angle"),
                                            rules_.rotation_angle)),
                center_of(block, invocation));
            break;
        case Function::Scale: scale(block, invocation); break;
        case Function::ScaleOff: frames_.scale_off(); break;
        case Function::RotateOff:
            if (rules_.place_behind_rotation && frames_.is_rotated()) unplaced_ = plane_mask();
            frames_.rotate_off();
            break;
        case Function::Mirror: frames_.mirror(words); break;
        case Function::MirrorOff: frames_.mirror_off(static_cast<AxisMask>(words.given)); break;
        case Function::SetPosition:
        case Function::SetPositionAxes:
            frames_.set_position(words, position_.here, position_.base);
            break;
        case Function::PositionReset:
            frames_.reset_position(static_cast<AxisMask>(words.given));
            break;
        default: KADR_ASSERT(false, "not a function of frames");
    }
    frame_changed();
    for (std::size_t i = 0; is_set && i < kAxes; ++i) {
        if (words.has(i)) position_.programmed[i] = position_.here[i];
    }
}

Done Executor::require_named_axes(const Block& block, const Invocation& invocation,
                                  AxisMask named) {
    const auto missing = static_cast<AxisMask>(named & ~(axes_.present | kLinearXYZ));
    if (missing == 0) return kDone;
    report(diag::AxisMissing, block, invocation.function)
        .arg(kAxisNames[static_cast<std::size_t>(std::countr_zero(missing))]);
    return kFailed;
}

/// Center of a rotation or a scaling.
control::FrameWords Executor::center_of(const Block& block, const Invocation& invocation) const {
    constexpr std::size_t kX = parameter_of_all<"x", Function::Rotate, Function::Scale>();
    const double x_scale = rules_.shift_in_diameter ? axes_.word_scale[index(Axis::X)] : 1;
    control::FrameWords center = frame_words(block, invocation, kX, x_scale);
    for (std::size_t i = 0; rules_.frame_center_at_tool && i < 3; ++i) {
        if (!center.has(i)) center.values[i] = position_.here[i];
    }
    return center;
}

/// About X, Y and Z, as far as they are named.
void Executor::rotate_in_space(const Block& block, const Invocation& invocation) {
    constexpr std::size_t kX =
        parameter_of_all<"x", Function::RotateSpace, Function::RotateSolid>();
    std::vector<control::AxisAndValue> angles;
    for (std::size_t i = 0; i < 3; ++i) {
        if (invocation.has(kX + i))
            angles.push_back({static_cast<Axis>(i), block.argument(invocation, kX + i)});
    }
    if (invocation.function == Function::RotateSpace) {
        frames_.turn(rotation_frame(angles).linear);
    } else if (angles.size() <= 2) {
        frames_.turn(solid_frame(angles).linear);
    } else {
        report(diag::SolidAngles, block, invocation.function).arg(angles.size());
    }
}

/// One factor, or one for each axis; the axes that nothing is said of keep their size.
void Executor::scale(const Block& block, const Invocation& invocation) {
    constexpr std::size_t kFactors = parameter_of<Function::Scale>("fx");
    const double all = block.argument(invocation, parameter_of<Function::Scale>("factor"), 1);
    path::Vec3 factors;
    for (std::size_t i = 0; i < 3; ++i) {
        const double factor = block.argument(invocation, kFactors + i, all);
        if (factor == 0) {
            report(diag::ScaleInvalid, block, Function::Scale).arg(factor);
            return;
        }
        factors[static_cast<Eigen::Index>(i)] = factor;
    }
    frames_.scale(factors, center_of(block, invocation));
}

/// What it does the machine file says, or the machine builder alone knows; then each is said once.
void Executor::pass_machine_function(const Block& block, std::int64_t number) {
    if (const auto& scanner = machine_.scanner) {
        if (number == scanner->on_function || number == scanner->off_function) {
            is_scanning_ = number == scanner->on_function;
            put(is_scanning_ ? Op::ScannerOn : Op::ScannerOff, block);
            return;
        }
    }
    if (machine_.find_function(number) != nullptr) return;  // it takes time, which is known
    if (!told_.first_time(OnceEach::MachineFunction, number)) return;
    report(diag::MachineFunctionPassed, block, Function::MachineFunction).arg(number);
}

/// No axis moves when a frame changes, but the tool has other coordinates now.
void Executor::frame_changed() { position_.here = frames_.from_base(position_.base); }

}  // namespace kadr::interp
