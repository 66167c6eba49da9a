// What a program asks while it runs: positions, offsets, the programmed feed.
#include "interp/answers.h"

#include <algorithm>
#include <cmath>

#include "interp/carriers.h"
#include "interp/channel.h"
#include "interp/radius_compensation.h"
#include "interp/spindles.h"
#include "interp/splines.h"
#include "interp/stages.h"
#include "interp/tool_in_use.h"
#include "interp/transformation.h"

namespace kadr::interp {

using nc::SystemQuantity;

Answers::Answers(Channel& channel)
    : channel_(channel),
      dialect_(channel.state.dialect),
      machine_(channel.state.machine),
      work_offsets_(channel.state.frame.work_offsets),
      work_offset_(channel.state.frame.work_offset),
      tool_offsets_(channel.state.tool.tool_offsets),
      tool_names_(channel.state.tool.tool_names),
      options_(channel.state.options),
      rules_(channel.state.rules),
      output_(channel.state.stage.output),
      clocks_(channel.state.clocks),
      probe_(channel.state.motion.probe),
      modal_(channel.state.motion.modal),
      position_(channel.state.motion.position),
      frames_(channel.state.frame.frames),
      spindle_(channel.state.spindle.spindle),
      other_spindles_(channel.state.spindle.other_spindles),
      tool_(channel.state.tool.tool),
      extra_(channel.state.tool.extra),
      comp_(channel.state.stage.comp),
      smooth_approach_(channel.state.stage.smooth_approach),
      approached_(channel.state.stage.approached),
      coolant_(channel.state.spindle.coolant),
      dynamics_(channel.state.motion.dynamics),
      axes_(channel.state.axes),
      length_shift_(channel.state.motion.length_shift),
      preset_(channel.state.motion.preset),
      modal_cycles_(channel.state.cycle.modal_cycles) {}

std::optional<Axis> Answers::axis_of(std::int64_t index) const {
    if (index < 0) {
        const auto axis = static_cast<std::size_t>(-index - 1);
        if (axis >= kAxes || (axes_.present >> axis & 1u) == 0) return std::nullopt;
        return static_cast<Axis>(axis);
    }
    if (index < 1 || static_cast<std::size_t>(index) > machine_.axes.size()) return std::nullopt;
    return machine_.axes[static_cast<std::size_t>(index - 1)].axis;
}

namespace {

/// As values of the language name an axis.
double name_of_axis(Axis axis) { return -1.0 - static_cast<double>(index(axis)); }

/// Texts of tool carriers.
bool is_of_carrier(SystemQuantity quantity) {
    return quantity == SystemQuantity::CarrierKind || quantity == SystemQuantity::CarrierName ||
           quantity == SystemQuantity::CarrierFirstName ||
           quantity == SystemQuantity::CarrierSecondName;
}

}  // namespace

bool Answers::is_length(std::int64_t index) const {
    const auto axis = axis_of(index);
    return axis && !is_rotary(*axis);
}

double Answers::word_factor(std::int64_t index) const {
    const auto axis = axis_of(index);
    return axis ? 1 / axes_.word_scale[kadr::index(*axis)] : 1;
}

std::optional<double> Answers::position_of(SystemQuantity quantity, Axis axis) const {
    const std::size_t i = index(axis);
    const AxisValues head = channel_.transformation.machine_axes();
    switch (quantity) {
        case SystemQuantity::EndPosition:
        case SystemQuantity::WorkPosition: return position_.here()[i];
        case SystemQuantity::HeadPosition: return frames_.from_base(head)[i];
        case SystemQuantity::MachinePosition: return head[i] - preset_[i];
        case SystemQuantity::BasePosition: return position_.base()[i];
        case SystemQuantity::BaseZeroPosition: return position_within(frames_.base(), axis);
        case SystemQuantity::SettablePosition:
            return position_within(chain(frames_.base(), frames_.work_offset()), axis);
        case SystemQuantity::ToolLength: return length_shift_[i];
        default: return std::nullopt;
    }
}

/// Where the tip is, seen from a frame.
double Answers::position_within(const control::ControlFrame& frame, Axis axis) const {
    const std::size_t i = index(axis);
    if (i > 2) return position_.base()[i] - frame.shift[i] - frame.fine[i];
    const path::Vec3 at{position_.base()[0], position_.base()[1], position_.base()[2]};
    return inverse(frame).whole()(at)[static_cast<Eigen::Index>(i)];
}

/// A bit for each axis, in the order in which the machine has them.
double Answers::mirrored_axes() const {
    const AxisMask mirrored = frames_.mirrored();
    double bits = 0;
    for (std::size_t i = 0; i < machine_.axes.size(); ++i)
        if ((mirrored & bit(machine_.axes[i].axis)) != 0)
            bits += std::ldexp(1.0, static_cast<int>(i));
    return bits;
}

void Answers::count_time() {
    for (; clocks_.timed < output_.written(); ++clocks_.timed)
        clocks_.run.add(output_.at(clocks_.timed));
}

double Answers::run_time() {
    count_time();
    RunClock clock = clocks_.run;
    const auto add = [&](const path::Command& command) { clock.add(command); };
    channel_.stages.visit_waiting(add);
    clocks_.latest = std::max(clocks_.latest, clock.seconds());
    clocks_.cutting = std::max(clocks_.cutting, clock.cutting_seconds());
    return clocks_.latest;
}

std::optional<double> Answers::clock(SystemQuantity quantity) {
    constexpr double kDay = 86400;
    constexpr double kHour = 3600;
    constexpr double kMilliseconds = 2147483648;  // then the counter begins again; F 6.5
    const double now = run_time();
    switch (quantity) {
        case SystemQuantity::Milliseconds:
            return std::fmod(std::floor(clocks_.milliseconds_from + now * 1000), kMilliseconds);
        case SystemQuantity::Hours: return clocks_.hours_from + now / kHour;
        case SystemQuantity::Date: return static_cast<double>(options_.date);
        case SystemQuantity::TimeOfDay: {
            const double of_day = std::fmod(std::floor(options_.time_of_day + now), kDay);
            const double hours = std::floor(of_day / kHour);
            const double minutes = std::floor((of_day - hours * kHour) / 60);
            return hours * 10000 + minutes * 100 + (of_day - hours * kHour - minutes * 60);
        }
        default: return std::nullopt;
    }
}

/// The day of the run, and the time of the day, running time included.
std::optional<double> Answers::calendar(SystemQuantity quantity) {
    constexpr double kDay = 86400;
    const double of_day = std::fmod(std::floor(options_.time_of_day + run_time()), kDay);
    const auto date = static_cast<double>(options_.date);  // YYYYMMDD
    switch (quantity) {
        case SystemQuantity::Year: return std::floor(date / 10000);
        case SystemQuantity::Month: return std::fmod(std::floor(date / 100), 100);
        case SystemQuantity::Day: return std::fmod(date, 100);
        case SystemQuantity::Hour: return std::floor(of_day / 3600);
        case SystemQuantity::Minute: return std::fmod(std::floor(of_day / 60), 60);
        case SystemQuantity::Second: return std::fmod(of_day, 60);
        case SystemQuantity::Millisecond:
            return std::fmod(std::floor((options_.time_of_day + run_time()) * 1000), 1000);
        default: return std::nullopt;
    }
}

/// As SINUMERIK counts the data of a tool; S 5.1.
std::optional<double> Answers::tool_datum(std::int64_t number) const {
    if (const auto column = ToolOffsets::column_of_datum(number))
        return tool_offsets_.value(*column, tool_.edge_number());
    if (number < 1 || number > ToolOffsets::kMostNumberedDatum) return std::nullopt;
    return tool_offsets_.datum(tool_.edge_number(), number);
}

double Answers::timer(std::int64_t number) {
    const auto found = clocks_.timers.find(number);
    if (found == clocks_.timers.end()) return 0;
    return found->second.runs ? run_time() + found->second.value : found->second.value;
}

void Answers::set_timer(std::int64_t number, double value) {
    if (value < 0) {
        clocks_.timers[number] = {timer(number), false};
    } else {
        clocks_.timers[number] = {value - run_time(), true};
    }
}

std::optional<double> Answers::quantity(SystemQuantity quantity, std::int64_t first,
                                        std::int64_t second) {
    channel_.splines.finish_open_spline();  // where the tool is cannot be known inside of one
    const auto number = [](std::int64_t value) { return static_cast<double>(value); };
    switch (quantity) {
        case SystemQuantity::EndPosition:
        case SystemQuantity::WorkPosition:
        case SystemQuantity::HeadPosition:
        case SystemQuantity::MachinePosition:
        case SystemQuantity::BasePosition:
        case SystemQuantity::BaseZeroPosition:
        case SystemQuantity::SettablePosition:
        case SystemQuantity::ToolLength: {
            const auto axis = axis_of(first);
            return axis ? position_of(quantity, *axis) : std::nullopt;
        }
        case SystemQuantity::LowerLimit:
        case SystemQuantity::UpperLimit: {
            const auto axis = axis_of(first);
            if (!axis) return std::nullopt;
            return (quantity == SystemQuantity::LowerLimit ? axes_.lower
                                                           : axes_.upper)[index(*axis)];
        }
        case SystemQuantity::WorkOffset: {
            const auto axis = axis_of(second);
            if (!axis || first < 0 || first > rules_.work_offsets) return std::nullopt;
            const auto i = static_cast<std::size_t>(first);
            return i < work_offsets_.size() ? work_offsets_[i].shift[index(*axis)] : 0.0;
        }
        case SystemQuantity::Transformation:
            return channel_.transformation.is_transformed() ? 1 : 0;
        case SystemQuantity::ActiveWorkOffset: return number(work_offset_);
        case SystemQuantity::ActiveAdditionalOffset:
            return number(std::max<std::int64_t>(0, work_offset_ - 6));
        case SystemQuantity::Feed: return modal_.has_feed ? modal_.feed : 0;
        case SystemQuantity::MasterSpindle: return number(spindle_.number);
        case SystemQuantity::SpindleCount:
            return number(static_cast<std::int64_t>(other_spindles_.size()) + 1);
        case SystemQuantity::Speed: {
            const ProgrammedSpindle* const spindle = channel_.spindles.spindle_at(first);
            if (spindle == nullptr) return std::nullopt;
            return spindle->has_cutting_speed ? spindle->cutting_speed : spindle->speed;
        }
        case SystemQuantity::SpindleDirection: {
            const ProgrammedSpindle* const spindle = channel_.spindles.spindle_at(first);
            if (spindle == nullptr) return std::nullopt;
            switch (spindle->mode) {
                case path::SpindleMode::Cw: return 3;
                case path::SpindleMode::Ccw: return 4;
                case path::SpindleMode::Stop: return 5;
                case path::SpindleMode::Orient: return 19;
            }
            return std::nullopt;
        }
        case SystemQuantity::Tool: return number(tool_.current);
        case SystemQuantity::SelectedTool: return number(tool_.selected);
        case SystemQuantity::LengthOffset: return number(tool_.offset);
        case SystemQuantity::RadiusOffset: return number(tool_.radius_offset);
        case SystemQuantity::ToolEdge:
            return number(tool_.source == Tool::Source::Edge ? tool_.edge : 0);
        case SystemQuantity::ToolPart:
            if (first < 1 || first > 3) return std::nullopt;
            return tool_.source == Tool::Source::None
                       ? 0
                       : tool_offsets_.length(static_cast<std::size_t>(first),
                                              tool_.length_number()) +
                             extra_.lengths[static_cast<Eigen::Index>(first) - 1] +
                             channel_.tool.sum_offset(static_cast<std::size_t>(first));
        case SystemQuantity::Timer: return timer(first);
        case SystemQuantity::CuttingTime: run_time(); return clocks_.cutting;
        case SystemQuantity::ToolRadius:
            if (tool_.source == Tool::Source::None) return 0;
            return tool_offsets_.radius(tool_.edge_number()) + extra_.radius +
                   channel_.tool.sum_offset(4);
        case SystemQuantity::ActiveToolDatum: return tool_datum(first);
        case SystemQuantity::ToolDatum:
            if (!channel_.tool.has_edge(first, second % nc::kDatum)) return std::nullopt;
            return tool_offsets_.datum(ToolOffsets::of_edge(first, second % nc::kDatum),
                                       second / nc::kDatum);
        case SystemQuantity::CarrierDatum:
        case SystemQuantity::CarrierAxis:
        case SystemQuantity::ActiveCarrier:
        case SystemQuantity::CarrierAngle:
        case SystemQuantity::CarrierLeftOver:
        case SystemQuantity::CarrierSolutions:
            return channel_.carriers.carrier_quantity(quantity, first, second);
        case SystemQuantity::FirstExtraLength: return extra_.lengths[0];
        case SystemQuantity::ExtraLength:
            if (first < 1 || first > 3) return std::nullopt;
            return extra_.lengths[static_cast<Eigen::Index>(first) - 1];
        case SystemQuantity::ExtraAlong: {
            const auto axis = axis_of(first);
            if (!axis || index(*axis) > 2) return std::nullopt;
            return extra_.along[static_cast<Eigen::Index>(index(*axis))];
        }
        case SystemQuantity::ExtraRadius: return extra_.radius;
        case SystemQuantity::ActualSpeed: {
            const ProgrammedSpindle* const spindle = channel_.spindles.spindle_at(first);
            if (spindle == nullptr) return std::nullopt;
            const bool is_ccw = spindle->mode == path::SpindleMode::Ccw;
            if (!is_ccw && spindle->mode != path::SpindleMode::Cw) return 0;
            // Only the master has a constant cutting speed.
            const double speed = spindle->has_cutting_speed ? channel_.spindles.turning_speed()
                                                            : spindle->commanded.speed;
            return is_ccw ? -speed : speed;
        }
        case SystemQuantity::LengthGeometry:
        case SystemQuantity::LengthWear:
        case SystemQuantity::RadiusGeometry:
        case SystemQuantity::RadiusWear:
        case SystemQuantity::CrossGeometry:
        case SystemQuantity::CrossWear:
        case SystemQuantity::FirstLength:
        case SystemQuantity::FirstWear:
        case SystemQuantity::SecondLength:
        case SystemQuantity::SecondWear:
        case SystemQuantity::ThirdLength:
        case SystemQuantity::ThirdWear:
        case SystemQuantity::FirstBase:
        case SystemQuantity::SecondBase:
        case SystemQuantity::ThirdBase:
        case SystemQuantity::ToolTip:
        case SystemQuantity::ToolType: {
            if (!channel_.tool.has_edge(first, second)) return std::nullopt;
            const bool is_cross =
                quantity == SystemQuantity::CrossGeometry || quantity == SystemQuantity::CrossWear;
            const std::int64_t at = ToolOffsets::of_edge(first, second);
            return tool_offsets_.value(*tool_offsets_.column_of(quantity, at), at) /
                   (is_cross ? axes_.word_scale[index(Axis::X)] : 1);
        }
        case SystemQuantity::EdgeCount: return number(tool_offsets_.edges(first));
        case SystemQuantity::EdgeNumberOf: return number(tool_offsets_.number_of(first, second));
        case SystemQuantity::ToolWithEdge: return number(tool_offsets_.tool_with(first, second));
        case SystemQuantity::CuttingEdge:
            if (!channel_.tool.has_edge(first, second)) return std::nullopt;
            return number(tool_offsets_.cutting_edge(first, second));
        case SystemQuantity::ApproachStart:
        case SystemQuantity::ApproachEnd: {
            const auto axis = axis_of(first);
            if (!axis) return std::nullopt;
            if (!approached_) return 0;
            const AxisValues& base =
                quantity == SystemQuantity::ApproachStart ? approached_->start : approached_->end;
            return frames_.from_base(base)[index(*axis)];
        }
        case SystemQuantity::ApproachKnown: return approached_ ? 1 : 0;
        case SystemQuantity::RadiusAllowance: return comp_.allowance;
        case SystemQuantity::ProbePosition: {
            const auto axis = axis_of(first);
            if (!axis) return std::nullopt;
            return probe_.found() ? probe_.found()->head[index(*axis)] : 0.0;
        }
        case SystemQuantity::ProbePlace:
        case SystemQuantity::ProbeMachine: {
            const auto axis = axis_of(first);
            if (!axis) return std::nullopt;
            if (!probe_.found()) return 0;
            return (quantity == SystemQuantity::ProbePlace ? probe_.found()->tip
                                                           : probe_.found()->machine)[index(*axis)];
        }
        case SystemQuantity::ProbeFound: return probe_.found() && probe_.found()->is_found ? 1 : 0;
        case SystemQuantity::MirroredAxes: return mirrored_axes();
        case SystemQuantity::FirstPlaneAxis: return name_of_axis(path::axes_of(modal_.plane).first);
        case SystemQuantity::SecondPlaneAxis:
            return name_of_axis(path::axes_of(modal_.plane).second);
        case SystemQuantity::NormalAxis: return name_of_axis(path::axes_of(modal_.plane).normal);
        case SystemQuantity::SuppressedPanel: return dynamics_.suppressed_panel();
        case SystemQuantity::Milliseconds:
        case SystemQuantity::Hours:
        case SystemQuantity::Date:
        case SystemQuantity::TimeOfDay: return clock(quantity);
        case SystemQuantity::RunTime: return run_time();
        case SystemQuantity::Year:
        case SystemQuantity::Month:
        case SystemQuantity::Day:
        case SystemQuantity::Hour:
        case SystemQuantity::Minute:
        case SystemQuantity::Second:
        case SystemQuantity::Millisecond: return calendar(quantity);
        case SystemQuantity::ChannelBaseMask: return frames_.bases().channel_mask;
        case SystemQuantity::GlobalBaseMask: return frames_.bases().global_mask;
        case SystemQuantity::SettableFrame:
        case SystemQuantity::ActiveFrame:
        case SystemQuantity::BaseFrame:
        case SystemQuantity::ChannelBaseFrame:
        case SystemQuantity::ChannelBaseNow:
        case SystemQuantity::GlobalBaseFrame:
        case SystemQuantity::GlobalBaseNow:
        case SystemQuantity::AllBaseFrames:
        case SystemQuantity::ExternalFrame:
        case SystemQuantity::SetFrame:
        case SystemQuantity::TableFrame:
        case SystemQuantity::ToolFrame:
        case SystemQuantity::PlaneFrame:
        case SystemQuantity::InnerFrame:
        case SystemQuantity::ProgrammableFrame:
        case SystemQuantity::TotalFrame:
        case SystemQuantity::ProgramLevel:
        case SystemQuantity::ArgumentGiven:
        case SystemQuantity::ExtraBoth:
        case SystemQuantity::ToolName:
        case SystemQuantity::ToolNameOf:
        case SystemQuantity::CarrierKind:
        case SystemQuantity::CarrierName:
        case SystemQuantity::CarrierFirstName:
        case SystemQuantity::CarrierSecondName:
        case SystemQuantity::ProgramName:
        case SystemQuantity::EdgeSpeed:
        case SystemQuantity::None:
        case SystemQuantity::ModalCode:
        case SystemQuantity::ModalNumber:
        case SystemQuantity::BlockNumber:
        case SystemQuantity::ModalCall:
        case SystemQuantity::MachineCode:
        case SystemQuantity::ProgramNumber:
        case SystemQuantity::Alarm:
        case SystemQuantity::MessageStop: return std::nullopt;
    }
    return std::nullopt;
}

std::optional<std::string> Answers::text(SystemQuantity quantity, std::int64_t index) {
    if (is_of_carrier(quantity)) return channel_.carriers.carrier_text(quantity, index);
    const bool is_active = quantity == SystemQuantity::ToolName;
    if (!is_active && quantity != SystemQuantity::ToolNameOf) return std::nullopt;
    const std::int64_t number = is_active ? tool_.current : index;
    if (number == 0) return is_active ? std::optional<std::string>("") : std::nullopt;
    return tool_names_.of(number);
}

ControlAccess::Write Answers::set_text(SystemQuantity quantity, std::int64_t index,
                                       std::string_view text) {
    if (is_of_carrier(quantity)) return channel_.carriers.set_carrier_text(quantity, index, text);
    if (quantity != SystemQuantity::ToolNameOf) return ControlAccess::Write::Refused;
    if (index < 1 || index > rules_.tool_offsets) return ControlAccess::Write::NoSuchEntry;
    tool_names_.set(index, text);
    return ControlAccess::Write::Done;
}

std::optional<std::int64_t> Answers::axis_number(Axis axis) const {
    const auto found = std::ranges::find(machine_.axes, axis, &machine::MachineAxis::axis);
    if (found == machine_.axes.end()) return std::nullopt;
    return found - machine_.axes.begin() + 1;
}

bool Answers::is_compensated() const {
    return channel_.compensation.is_any_comp_on() || smooth_approach_.is_active();
}

}  // namespace kadr::interp
