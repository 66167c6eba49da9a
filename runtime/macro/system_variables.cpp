#include "macro/system_variables.h"

#include <algorithm>
#include <cmath>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "base/units.h"
#include "macro/whole_number.h"

namespace kadr::macro {

using nc::SystemQuantity;

namespace {

/// Whether the last index of the system variable is an axis, so that it is a length or an angle.
bool is_of_axis(SystemQuantity quantity) {
    switch (quantity) {
        case SystemQuantity::EndPosition:
        case SystemQuantity::WorkPosition:
        case SystemQuantity::HeadPosition:
        case SystemQuantity::MachinePosition:
        case SystemQuantity::ToolLength:
        case SystemQuantity::BasePosition:
        case SystemQuantity::BaseZeroPosition:
        case SystemQuantity::SettablePosition:
        case SystemQuantity::ProbePosition:
        case SystemQuantity::ProbePlace:
        case SystemQuantity::ProbeMachine:
        case SystemQuantity::ApproachStart:
        case SystemQuantity::ApproachEnd:
        case SystemQuantity::WorkOffset: return true;
        default: return false;
    }
}

/// Whether the system variable is a length of a tool.
bool is_of_tool_data(SystemQuantity quantity) {
    switch (quantity) {
        case SystemQuantity::ToolRadius:
        case SystemQuantity::ToolPart:
        case SystemQuantity::RadiusAllowance:
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
        case SystemQuantity::ExtraLength:
        case SystemQuantity::FirstExtraLength:
        case SystemQuantity::ExtraAlong:
        case SystemQuantity::ExtraRadius:
        case SystemQuantity::ExtraBoth: return true;
        default: return false;
    }
}

}  // namespace

QuantityIndices indices_of(const nc::VariableRange& range, std::int64_t number) {
    const std::int64_t index = number - range.first;
    if (range.stride == 0) return {index + range.start, 0};
    return {index / range.stride + range.start, index % range.stride + range.second};
}

Variables::Answer SystemVariables::number(SystemQuantity quantity, std::int64_t first,
                                          std::int64_t second, double& out) {
    if (info(quantity).access == nc::QuantityInfo::Access::Write) return Answer::NotReadable;
    if (quantity == SystemQuantity::ModalCode) {
        const auto code = codes_.number(first);
        if (!code) return Answer::Missing;
        out = *code;
        return Answer::Value;
    }
    if (quantity == SystemQuantity::ModalNumber) {
        const auto place = codes_.place(first);
        if (!place) return Answer::Missing;
        out = static_cast<double>(*place);
        return Answer::Value;
    }
    switch (quantity) {
        case SystemQuantity::BlockNumber:
            out = static_cast<double>(block_number_);
            return Answer::Value;
        case SystemQuantity::MachineCode:
            out = reader_.modes().machine_code();
            return Answer::Value;
        case SystemQuantity::ModalCall: out = modal_call_ ? modal_call_() : 0; return Answer::Value;
        case SystemQuantity::ProgramLevel:
            out = static_cast<double>(program_level_);
            return Answer::Value;
        case SystemQuantity::ProgramNumber:
            out = static_cast<double>(whole_number(reader_.bounds().text().program).value_or(0));
            return Answer::Value;
        default: break;
    }
    if (state_ == nullptr) return Answer::Unsupported;
    if (!in_step_) return Answer::Later;
    const bool is_of_tool =
        quantity == SystemQuantity::WorkPosition || quantity == SystemQuantity::HeadPosition ||
        quantity == SystemQuantity::MachinePosition || quantity == SystemQuantity::BasePosition ||
        quantity == SystemQuantity::BaseZeroPosition ||
        quantity == SystemQuantity::SettablePosition;
    if (is_of_tool && state_->is_compensated()) return Answer::Compensated;
    const auto value = state_->quantity(quantity, first, second);
    if (!value) return Answer::Missing;
    out = to_text_units(quantity, {first, second}, *value);
    return Answer::Value;
}

bool SystemVariables::set_whole_number(SystemQuantity quantity, std::int64_t first,
                                       std::int64_t second, double value) {
    if (state_ == nullptr) return false;
    return state_->set_quantity(quantity, first, second, value, true) == ControlAccess::Write::Done;
}

Variables::Answer SystemVariables::frame(SystemQuantity quantity, std::int64_t index,
                                         control::ControlFrame& out) {
    if (state_ == nullptr) return Answer::Unsupported;
    if (!in_step_) return Answer::Later;
    const auto frame = state_->frame(quantity, index);
    if (!frame) return Answer::Missing;
    out = *frame;
    return Answer::Value;
}

Variables::Answer SystemVariables::text(SystemQuantity quantity, std::int64_t index,
                                        std::string& out) {
    if (quantity == SystemQuantity::ProgramName) {
        const auto name = name_at_ ? name_at_(index) : std::nullopt;
        if (!name) return Answer::Missing;
        out = *name;
        return Answer::Value;
    }
    if (state_ == nullptr) return Answer::Unsupported;
    if (!in_step_) return Answer::Later;
    const auto text = state_->text(quantity, index);
    if (!text) return Answer::Missing;
    out = *text;
    return Answer::Value;
}

std::optional<std::int64_t> SystemVariables::axis_number(Axis axis) const {
    return state_ == nullptr ? std::nullopt : state_->axis_number(axis);
}

bool SystemVariables::has_spindle(std::int64_t number) const {
    return state_ == nullptr ? number <= 1 : state_->has_spindle(number);
}

void SystemVariables::put_units(ContourElements& contour) const {
    const double unit = axis_unit(Axis::X);
    const double feed = text_scale(nc::Dimension::Feed, reader_.modes().units(), true);
    const nc::Function function =
        reader_.modes().units().inch ? nc::Function::Inch : nc::Function::Metric;
    // The code that acts by its index in the list of its group.
    int index = reader_.modes().units().inch ? 0 : 1;
    for (const nc::Form& form : tables_.forms) {
        if (form.function != function || form.group < 0) continue;
        const auto group = static_cast<std::size_t>(form.group);
        const auto list = std::ranges::find(language_.code_lists, tables_.groups[group].name,
                                            &nc::GroupCodes::group);
        if (list == language_.code_lists.end()) break;
        index = static_cast<int>(codes_.place_in(*list, group)) - 1;
        break;
    }
    for (ContourElement& element : contour) {
        element.shape.from /= unit;
        element.shape.to /= unit;
        element.shape.center /= unit;
        element.feed *= feed;
        element.modes.is_metric = !reader_.modes().units().inch;
        element.modes.units = index;
    }
}

double SystemVariables::axis_unit(Axis axis) const {
    return reader_.modes().units().inch && !is_rotary(axis) ? kMmPerInch : 1;
}

/// How many units of the text 1 mm, or 1 degree, of the axis is.
double SystemVariables::text_factor(std::int64_t axis) const {
    const bool is_inch = reader_.modes().units().inch && state_->is_length(axis);
    return state_->word_factor(axis) / (is_inch ? kMmPerInch : 1);
}

double SystemVariables::to_text_units(SystemQuantity quantity, const QuantityIndices& indices,
                                      double value) const {
    if (is_of_axis(quantity)) {
        const std::int64_t axis =
            quantity == SystemQuantity::WorkOffset ? indices.second : indices.first;
        return on_increment(value * text_factor(axis), state_->is_length(axis));
    }
    if (quantity == SystemQuantity::Feed)
        return value * text_scale(nc::Dimension::Feed, reader_.modes().units(), true);
    if (is_of_tool_data(quantity))
        return on_increment(
            value * text_scale(nc::Dimension::Length, reader_.modes().units(), true), true);
    return value;
}

/// Where words are rounded to the increment, the control keeps positions and offsets in increments.
double SystemVariables::on_increment(double value, bool is_length) const {
    if (!language_.rules.rounds_values) return value;
    const nc::Dimension dimension = is_length ? nc::Dimension::Length : nc::Dimension::Angle;
    const double power =
        std::round(1 / increment_size(tables_, dimension, reader_.modes().units()));
    return std::round(value * power) / power + 0.0;
}

VariableFault SystemVariables::set_number(SystemQuantity quantity, const QuantityIndices& indices,
                                          const ControlValue& value) {
    if (info(quantity).access == nc::QuantityInfo::Access::Read)
        return {&diag::VariableReadOnly, {std::string(info(quantity).name)}};
    const std::string name(info(quantity).name);
    if (state_ == nullptr) return {&diag::IsoNotSupported, {name}};
    const bool is_axis =
        quantity == SystemQuantity::CarrierAxis && value.kind == ControlValue::Kind::Axis;
    if (!value.is_number() && !is_axis)
        return {&diag::TypesDiffer, {name, std::string(kind_name(value))}};
    if (quantity == SystemQuantity::CarrierAxis && !is_axis && value.number != 0)
        return {&diag::TypesDiffer, {name, std::string(kind_name(value))}};
    double number = value.number;
    if (quantity == SystemQuantity::WorkOffset) {
        number =
            on_increment(number, state_->is_length(indices.second)) / text_factor(indices.second);
    }
    if (is_of_tool_data(quantity)) {
        number = on_increment(number, true) /
                 text_scale(nc::Dimension::Length, reader_.modes().units(), true);
    }
    switch (state_->set_quantity(quantity, indices.first, indices.second, number,
                                 language_.rules.offsets_act_at_once)) {
        case ControlAccess::Write::Done: return {};
        case ControlAccess::Write::NoSuchEntry:
            if (quantity == SystemQuantity::EdgeSpeed) return {&diag::ToothFeedNoTool, {}};
            return {&diag::VariableNumber, {"of this offset"}};
        case ControlAccess::Write::TooLarge: {
            std::string shown;
            append_shortest(shown, value.number);
            return {&diag::OffsetDataValue, {shown}};
        }
        case ControlAccess::Write::Refused: break;
    }
    return {&diag::IsoNotSupported, {name}};
}

VariableFault SystemVariables::set_frame(SystemQuantity quantity, std::int64_t number,
                                         const control::ControlFrame& frame) {
    const std::string name(info(quantity).name);
    if (info(quantity).access == nc::QuantityInfo::Access::Read)
        return {&diag::VariableReadOnly, {name}};
    if (state_ == nullptr) return {&diag::IsoNotSupported, {name}};
    switch (state_->set_frame(quantity, number, frame, language_.rules.offsets_act_at_once)) {
        case ControlAccess::Write::Done: return {};
        case ControlAccess::Write::NoSuchEntry: return {&diag::VariableNumber, {"of this offset"}};
        case ControlAccess::Write::TooLarge:
        case ControlAccess::Write::Refused: break;
    }
    return {&diag::IsoNotSupported, {name}};
}

VariableFault SystemVariables::set_text(SystemQuantity quantity, std::int64_t index,
                                        const ControlValue& value, std::string_view text) {
    const std::string name(info(quantity).name);
    if (info(quantity).access == nc::QuantityInfo::Access::Read)
        return {&diag::VariableReadOnly, {name}};
    if (state_ == nullptr) return {&diag::IsoNotSupported, {name}};
    ControlValue converted = value;
    if (VariableFault fault = convert(nc::ValueType::Text, converted, text); fault.row != nullptr)
        return fault;
    const std::string written = written_text(value, text);
    const auto most = static_cast<std::size_t>(language_.rules.most_tool_name);
    if (const std::size_t length = count_code_points(written); length > most)
        return {&diag::TextTooLong, {std::to_string(length), std::to_string(most)}};
    if (written.empty() && quantity == SystemQuantity::ToolNameOf)
        return {&diag::ToolNameEmpty, {}};
    switch (state_->set_text(quantity, index, written)) {
        case ControlAccess::Write::Done: return {};
        case ControlAccess::Write::NoSuchEntry: return {&diag::VariableNumber, {"of this tool"}};
        case ControlAccess::Write::TooLarge:
        case ControlAccess::Write::Refused: break;
    }
    return {&diag::IsoNotSupported, {name}};
}

}  // namespace kadr::macro
