// What a program asks while it runs: positions, offsets, the programmed feed.
#include <algorithm>

#include "interp/executor.h"

namespace kadr::interp {

using nc::Quantity;

/// A count of the machine's axes from 1, or a name: −1 X, −2 Y …
std::optional<Axis> Executor::axis_of(std::int64_t index) const {
    if (index < 0) {
        const auto axis = static_cast<std::size_t>(-index - 1);
        if (axis >= kAxes || (axes_ >> axis & 1u) == 0) return std::nullopt;
        return static_cast<Axis>(axis);
    }
    if (index < 1 || static_cast<std::size_t>(index) > machine_.axes.size()) return std::nullopt;
    return machine_.axes[static_cast<std::size_t>(index - 1)].axis;
}

bool Executor::is_length(std::int64_t index) const {
    const auto axis = axis_of(index);
    return axis && !is_rotary(*axis);
}

double Executor::word_factor(std::int64_t index) const {
    const auto axis = axis_of(index);
    return axis ? 1 / word_scale_[kadr::index(*axis)] : 1;
}

std::optional<double> Executor::place_of(Quantity quantity, Axis axis) const {
    const std::size_t i = index(axis);
    AxisValues head = position_.base;
    for (std::size_t k = 0; k < kAxes; ++k) head[k] += length_shift_[k];
    switch (quantity) {
        case Quantity::EndPosition:
        case Quantity::WorkPosition: return position_.here[i];
        case Quantity::HeadPosition: return frames_.from_base(head)[i];
        case Quantity::MachinePosition: return head[i];
        case Quantity::ToolLength: return length_shift_[i];
        default: return std::nullopt;
    }
}

std::optional<double> Executor::quantity(Quantity quantity, std::int64_t first,
                                         std::int64_t second) {
    if (spline_) finish_spline();  // where the tool is cannot be said inside of one
    const auto number = [](std::int64_t value) { return static_cast<double>(value); };
    switch (quantity) {
        case Quantity::EndPosition:
        case Quantity::WorkPosition:
        case Quantity::HeadPosition:
        case Quantity::MachinePosition:
        case Quantity::ToolLength: {
            const auto axis = axis_of(first);
            return axis ? place_of(quantity, *axis) : std::nullopt;
        }
        case Quantity::WorkOffset: {
            const auto axis = axis_of(second);
            if (!axis || first < 0 || first > rules_.work_offsets) return std::nullopt;
            const auto i = static_cast<std::size_t>(first);
            return i < work_offsets_.size() ? work_offsets_[i][index(*axis)] : 0.0;
        }
        case Quantity::ActiveWorkOffset: return number(work_offset_);
        case Quantity::ActiveAdditionalOffset:
            return number(std::max<std::int64_t>(0, work_offset_ - 6));
        case Quantity::Feed: return modal_.has_feed ? modal_.feed : 0;
        case Quantity::Speed:
            if (first > 1) return std::nullopt;  // of another spindle
            return spindle_.has_cutting_speed ? spindle_.cutting_speed : spindle_.speed;
        case Quantity::SpindleDirection:
            if (first > 1) return std::nullopt;
            switch (spindle_.mode) {
                case path::SpindleMode::Cw: return 3;
                case path::SpindleMode::Ccw: return 4;
                case path::SpindleMode::Stop: return 5;
                case path::SpindleMode::Orient: return 19;
            }
            return std::nullopt;
        case Quantity::Tool: return number(tool_.current);
        case Quantity::SelectedTool: return number(tool_.selected);
        case Quantity::LengthOffset: return number(tool_.offset);
        case Quantity::RadiusOffset: return number(tool_.radius_offset);
        case Quantity::ToolRadius: {
            const auto tool = std::ranges::find_if(
                machine_.tools, [this](const auto& t) { return t.number == tool_.current; });
            return tool == machine_.tools.end() ? 0 : tool->radius;
        }
        case Quantity::None:
        case Quantity::ModalCode:
        case Quantity::ModalNumber:
        case Quantity::BlockNumber:
        case Quantity::Alarm:
        case Quantity::MessageStop: return std::nullopt;
    }
    return std::nullopt;
}

bool Executor::set_work_offset(std::int64_t number, std::int64_t axis_index, double value,
                               bool acts_at_once) {
    const auto axis = axis_of(axis_index);
    if (!axis || number < 0 || number > rules_.work_offsets) return false;
    const auto i = static_cast<std::size_t>(number);
    if (i >= work_offsets_.size()) work_offsets_.resize(i + 1, AxisValues{});
    work_offsets_[i][index(*axis)] = value;
    if (acts_at_once && number == work_offset_) {
        frames_.select_work_offset(work_offsets_[i]);
        frame_changed();
    }
    return true;
}

void Executor::restore_frames(bool is_wanted) {
    if (kept_frames_.empty()) return;
    if (is_wanted) {
        frames_ = kept_frames_.back().frames;
        work_offset_ = kept_frames_.back().work_offset;
        frame_changed();
    }
    kept_frames_.pop_back();
}

}  // namespace kadr::interp
