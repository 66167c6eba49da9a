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

using nc::Quantity;

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
bool is_of_carrier(Quantity quantity) {
    return quantity == Quantity::CarrierKind || quantity == Quantity::CarrierName ||
           quantity == Quantity::CarrierFirstName || quantity == Quantity::CarrierSecondName;
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

std::optional<double> Answers::place_of(Quantity quantity, Axis axis) const {
    const std::size_t i = index(axis);
    const AxisValues head = channel_.transformation.machine_axes();
    switch (quantity) {
        case Quantity::EndPosition:
        case Quantity::WorkPosition: return position_.here()[i];
        case Quantity::HeadPosition: return frames_.from_base(head)[i];
        case Quantity::MachinePosition: return head[i] - preset_[i];
        case Quantity::BasePosition: return position_.base()[i];
        case Quantity::BaseZeroPosition: return place_within(frames_.base(), axis);
        case Quantity::SettablePosition:
            return place_within(chain(frames_.base(), frames_.work_offset()), axis);
        case Quantity::ToolLength: return length_shift_[i];
        default: return std::nullopt;
    }
}

/// Where the tip is, seen from a frame.
double Answers::place_within(const control::ControlFrame& frame, Axis axis) const {
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

std::optional<double> Answers::clock(Quantity quantity) {
    constexpr double kDay = 86400;
    constexpr double kHour = 3600;
    constexpr double kMilliseconds = 2147483648;  // then the counter begins again; F 6.5
    const double now = run_time();
    switch (quantity) {
        case Quantity::Milliseconds:
            return std::fmod(std::floor(clocks_.milliseconds_from + now * 1000), kMilliseconds);
        case Quantity::Hours: return clocks_.hours_from + now / kHour;
        case Quantity::Date: return static_cast<double>(options_.date);
        case Quantity::TimeOfDay: {
            const double of_day = std::fmod(std::floor(options_.time_of_day + now), kDay);
            const double hours = std::floor(of_day / kHour);
            const double minutes = std::floor((of_day - hours * kHour) / 60);
            return hours * 10000 + minutes * 100 + (of_day - hours * kHour - minutes * 60);
        }
        default: return std::nullopt;
    }
}

/// The day of the run, and the time of the day, running time included.
std::optional<double> Answers::calendar(Quantity quantity) {
    constexpr double kDay = 86400;
    const double of_day = std::fmod(std::floor(options_.time_of_day + run_time()), kDay);
    const auto date = static_cast<double>(options_.date);  // YYYYMMDD
    switch (quantity) {
        case Quantity::Year: return std::floor(date / 10000);
        case Quantity::Month: return std::fmod(std::floor(date / 100), 100);
        case Quantity::Day: return std::fmod(date, 100);
        case Quantity::Hour: return std::floor(of_day / 3600);
        case Quantity::Minute: return std::fmod(std::floor(of_day / 60), 60);
        case Quantity::Second: return std::fmod(of_day, 60);
        case Quantity::Millisecond:
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

std::optional<double> Answers::quantity(Quantity quantity, std::int64_t first,
                                        std::int64_t second) {
    channel_.splines.finish_open_spline();  // where the tool is cannot be said inside of one
    const auto number = [](std::int64_t value) { return static_cast<double>(value); };
    switch (quantity) {
        case Quantity::EndPosition:
        case Quantity::WorkPosition:
        case Quantity::HeadPosition:
        case Quantity::MachinePosition:
        case Quantity::BasePosition:
        case Quantity::BaseZeroPosition:
        case Quantity::SettablePosition:
        case Quantity::ToolLength: {
            const auto axis = axis_of(first);
            return axis ? place_of(quantity, *axis) : std::nullopt;
        }
        case Quantity::LowerLimit:
        case Quantity::UpperLimit: {
            const auto axis = axis_of(first);
            if (!axis) return std::nullopt;
            return (quantity == Quantity::LowerLimit ? axes_.lower : axes_.upper)[index(*axis)];
        }
        case Quantity::WorkOffset: {
            const auto axis = axis_of(second);
            if (!axis || first < 0 || first > rules_.work_offsets) return std::nullopt;
            const auto i = static_cast<std::size_t>(first);
            return i < work_offsets_.size() ? work_offsets_[i].shift[index(*axis)] : 0.0;
        }
        case Quantity::Transformation: return channel_.transformation.is_transformed() ? 1 : 0;
        case Quantity::ActiveWorkOffset: return number(work_offset_);
        case Quantity::ActiveAdditionalOffset:
            return number(std::max<std::int64_t>(0, work_offset_ - 6));
        case Quantity::Feed: return modal_.has_feed ? modal_.feed : 0;
        case Quantity::MasterSpindle: return number(spindle_.number);
        case Quantity::SpindleCount:
            return number(static_cast<std::int64_t>(other_spindles_.size()) + 1);
        case Quantity::Speed: {
            const Spindle* const spindle = channel_.spindles.spindle_at(first);
            if (spindle == nullptr) return std::nullopt;
            return spindle->has_cutting_speed ? spindle->cutting_speed : spindle->speed;
        }
        case Quantity::SpindleDirection: {
            const Spindle* const spindle = channel_.spindles.spindle_at(first);
            if (spindle == nullptr) return std::nullopt;
            switch (spindle->mode) {
                case path::SpindleMode::Cw: return 3;
                case path::SpindleMode::Ccw: return 4;
                case path::SpindleMode::Stop: return 5;
                case path::SpindleMode::Orient: return 19;
            }
            return std::nullopt;
        }
        case Quantity::Tool: return number(tool_.current);
        case Quantity::SelectedTool: return number(tool_.selected);
        case Quantity::LengthOffset: return number(tool_.offset);
        case Quantity::RadiusOffset: return number(tool_.radius_offset);
        case Quantity::ToolEdge: return number(tool_.source == Tool::Source::Edge ? tool_.edge : 0);
        case Quantity::ToolPart:
            if (first < 1 || first > 3) return std::nullopt;
            return tool_.source == Tool::Source::None
                       ? 0
                       : tool_offsets_.length(static_cast<std::size_t>(first),
                                              tool_.length_number()) +
                             extra_.lengths[static_cast<Eigen::Index>(first) - 1] +
                             channel_.tool.sum_offset(static_cast<std::size_t>(first));
        case Quantity::Timer: return timer(first);
        case Quantity::CuttingTime: run_time(); return clocks_.cutting;
        case Quantity::ToolRadius:
            if (tool_.source == Tool::Source::None) return 0;
            return tool_offsets_.radius(tool_.edge_number()) + extra_.radius +
                   channel_.tool.sum_offset(4);
        case Quantity::ActiveToolDatum: return tool_datum(first);
        case Quantity::ToolDatum:
            if (!channel_.tool.has_edge(first, second % nc::kDatum)) return std::nullopt;
            return tool_offsets_.datum(ToolOffsets::of_edge(first, second % nc::kDatum),
                                       second / nc::kDatum);
        case Quantity::CarrierDatum:
        case Quantity::CarrierAxis:
        case Quantity::ActiveCarrier:
        case Quantity::CarrierAngle:
        case Quantity::CarrierLeftOver:
        case Quantity::CarrierSolutions:
            return channel_.carriers.carrier_quantity(quantity, first, second);
        case Quantity::FirstExtraLength: return extra_.lengths[0];
        case Quantity::ExtraLength:
            if (first < 1 || first > 3) return std::nullopt;
            return extra_.lengths[static_cast<Eigen::Index>(first) - 1];
        case Quantity::ExtraAlong: {
            const auto axis = axis_of(first);
            if (!axis || index(*axis) > 2) return std::nullopt;
            return extra_.along[static_cast<Eigen::Index>(index(*axis))];
        }
        case Quantity::ExtraRadius: return extra_.radius;
        case Quantity::ActualSpeed: {
            const Spindle* const spindle = channel_.spindles.spindle_at(first);
            if (spindle == nullptr) return std::nullopt;
            const bool is_ccw = spindle->mode == path::SpindleMode::Ccw;
            if (!is_ccw && spindle->mode != path::SpindleMode::Cw) return 0;
            // Only the master has a constant cutting speed.
            const double speed = spindle->has_cutting_speed ? channel_.spindles.turning_speed()
                                                            : spindle->told.speed;
            return is_ccw ? -speed : speed;
        }
        case Quantity::LengthGeometry:
        case Quantity::LengthWear:
        case Quantity::RadiusGeometry:
        case Quantity::RadiusWear:
        case Quantity::CrossGeometry:
        case Quantity::CrossWear:
        case Quantity::FirstLength:
        case Quantity::FirstWear:
        case Quantity::SecondLength:
        case Quantity::SecondWear:
        case Quantity::ThirdLength:
        case Quantity::ThirdWear:
        case Quantity::FirstBase:
        case Quantity::SecondBase:
        case Quantity::ThirdBase:
        case Quantity::ToolTip:
        case Quantity::ToolType: {
            if (!channel_.tool.has_edge(first, second)) return std::nullopt;
            const bool is_cross =
                quantity == Quantity::CrossGeometry || quantity == Quantity::CrossWear;
            const std::int64_t at = ToolOffsets::of_edge(first, second);
            return tool_offsets_.value(*tool_offsets_.column_of(quantity, at), at) /
                   (is_cross ? axes_.word_scale[index(Axis::X)] : 1);
        }
        case Quantity::EdgeCount: return number(tool_offsets_.edges(first));
        case Quantity::EdgeNumberOf: return number(tool_offsets_.number_of(first, second));
        case Quantity::ToolWithEdge: return number(tool_offsets_.tool_with(first, second));
        case Quantity::CuttingEdge:
            if (!channel_.tool.has_edge(first, second)) return std::nullopt;
            return number(tool_offsets_.cutting_edge(first, second));
        case Quantity::ApproachStart:
        case Quantity::ApproachEnd: {
            const auto axis = axis_of(first);
            if (!axis) return std::nullopt;
            if (!approached_) return 0;
            const AxisValues& base =
                quantity == Quantity::ApproachStart ? approached_->start : approached_->end;
            return frames_.from_base(base)[index(*axis)];
        }
        case Quantity::ApproachKnown: return approached_ ? 1 : 0;
        case Quantity::RadiusAllowance: return comp_.allowance;
        case Quantity::ProbePosition: {
            const auto axis = axis_of(first);
            if (!axis) return std::nullopt;
            return probe_.found() ? probe_.found()->head[index(*axis)] : 0.0;
        }
        case Quantity::ProbePlace:
        case Quantity::ProbeMachine: {
            const auto axis = axis_of(first);
            if (!axis) return std::nullopt;
            if (!probe_.found()) return 0;
            return (quantity == Quantity::ProbePlace ? probe_.found()->tip
                                                     : probe_.found()->machine)[index(*axis)];
        }
        case Quantity::ProbeFound: return probe_.found() && probe_.found()->is_found ? 1 : 0;
        case Quantity::MirroredAxes: return mirrored_axes();
        case Quantity::FirstPlaneAxis: return name_of_axis(path::axes_of(modal_.plane).first);
        case Quantity::SecondPlaneAxis: return name_of_axis(path::axes_of(modal_.plane).second);
        case Quantity::NormalAxis: return name_of_axis(path::axes_of(modal_.plane).normal);
        case Quantity::SuppressedPanel: return dynamics_.suppressed_panel();
        case Quantity::Milliseconds:
        case Quantity::Hours:
        case Quantity::Date:
        case Quantity::TimeOfDay: return clock(quantity);
        case Quantity::RunTime: return run_time();
        case Quantity::Year:
        case Quantity::Month:
        case Quantity::Day:
        case Quantity::Hour:
        case Quantity::Minute:
        case Quantity::Second:
        case Quantity::Millisecond: return calendar(quantity);
        case Quantity::ChannelBaseMask: return frames_.bases().channel_mask;
        case Quantity::GlobalBaseMask: return frames_.bases().global_mask;
        case Quantity::SettableFrame:
        case Quantity::ActiveFrame:
        case Quantity::BaseFrame:
        case Quantity::ChannelBaseFrame:
        case Quantity::ChannelBaseNow:
        case Quantity::GlobalBaseFrame:
        case Quantity::GlobalBaseNow:
        case Quantity::AllBaseFrames:
        case Quantity::ExternalFrame:
        case Quantity::SetFrame:
        case Quantity::TableFrame:
        case Quantity::ToolFrame:
        case Quantity::PlaneFrame:
        case Quantity::InnerFrame:
        case Quantity::ProgrammableFrame:
        case Quantity::TotalFrame:
        case Quantity::ProgramLevel:
        case Quantity::ArgumentGiven:
        case Quantity::ExtraBoth:
        case Quantity::ToolName:
        case Quantity::ToolNameOf:
        case Quantity::CarrierKind:
        case Quantity::CarrierName:
        case Quantity::CarrierFirstName:
        case Quantity::CarrierSecondName:
        case Quantity::ProgramName:
        case Quantity::EdgeSpeed:
        case Quantity::None:
        case Quantity::ModalCode:
        case Quantity::ModalNumber:
        case Quantity::BlockNumber:
        case Quantity::ModalCall:
        case Quantity::MachineCode:
        case Quantity::ProgramNumber:
        case Quantity::Alarm:
        case Quantity::MessageStop: return std::nullopt;
    }
    return std::nullopt;
}

std::optional<std::string> Answers::text(Quantity quantity, std::int64_t index) {
    if (is_of_carrier(quantity)) return channel_.carriers.carrier_text(quantity, index);
    const bool is_active = quantity == Quantity::ToolName;
    if (!is_active && quantity != Quantity::ToolNameOf) return std::nullopt;
    const std::int64_t number = is_active ? tool_.current : index;
    if (number == 0) return is_active ? std::optional<std::string>("") : std::nullopt;
    return tool_names_.of(number);
}

ControlAccess::Write Answers::set_text(Quantity quantity, std::int64_t index,
                                       std::string_view text) {
    if (is_of_carrier(quantity)) return channel_.carriers.set_carrier_text(quantity, index, text);
    if (quantity != Quantity::ToolNameOf) return ControlAccess::Write::Refused;
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
