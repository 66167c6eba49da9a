#include <array>
#include <cmath>
#include <numbers>

#include "base/diagnostics/iso.h"
#include "interp/channel.h"
#include "interp/programmed_frames.h"
#include "interp/splines.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using Write = ControlAccess::Write;

/// Offsets that the machine file does not name are zero, as in a new control.
control::ControlFrame ProgrammedFrames::work_offset_frame(std::int64_t number) const {
    const auto of = [this](std::size_t i) {
        return i < work_offsets_.size() ? work_offsets_[i] : control::ControlFrame();
    };
    const control::ControlFrame own = of(static_cast<std::size_t>(number));
    return rules_.external_work_offset && number != 0 ? chain(of(0), own) : own;
}

control::ControlFrame& ProgrammedFrames::work_offset_at(std::int64_t number) {
    const auto i = static_cast<std::size_t>(number);
    if (i >= work_offsets_.size()) work_offsets_.resize(i + 1);
    return work_offsets_[i];
}

void ProgrammedFrames::work_offset_changed(std::int64_t number, bool acts_at_once) {
    const bool acts = number == work_offset_ || (rules_.external_work_offset && number == 0);
    if (!acts_at_once || !acts) return;
    frames_.select_work_offset(work_offset_frame(work_offset_));
    frame_changed();
}

Write ProgrammedFrames::set_work_offset(std::int64_t number, Axis axis, double value,
                                        bool acts_at_once) {
    if (number < 0 || number > rules_.work_offsets) return Write::NoSuchEntry;
    channel_.splines.finish_open_spline();
    work_offset_at(number).shift[index(axis)] = value;
    work_offset_changed(number, acts_at_once);
    return Write::Done;
}

void ProgrammedFrames::write_work_offset(const Block& block, const Invocation& invocation) {
    constexpr std::size_t kNumber = parameter_of<Function::WorkOffsetData>("number");
    constexpr std::size_t kX = parameter_of<Function::WorkOffsetData>("x");
    const std::int64_t number = std::llround(block.argument(invocation, kNumber));
    if (number < 0 || number > rules_.work_offsets) {
        reporter_.report(diag::OffsetDataNumber, block, invocation.function).arg(number);
        return;
    }
    for (std::size_t i = 0; i < kAxes; ++i) {
        if (!invocation.has(kX + i)) continue;
        const auto axis = static_cast<Axis>(i);
        if ((axes_.present & bit(axis)) == 0) {
            reporter_.report(diag::AxisMissing, block, invocation.function).arg(kAxisNames[i]);
            return;
        }
        double value = block.argument(invocation, kX + i) * axes_.word_scale[i];
        const auto n = static_cast<std::size_t>(number);
        if (modal_.is_incremental && n < work_offsets_.size()) value += work_offsets_[n].shift[i];
        set_work_offset(number, axis, value, true);
    }
}

void ProgrammedFrames::begin() {
    frames_.select_work_offset(work_offset_frame(work_offset_));
    frame_changed();
}

}  // namespace kadr::interp
