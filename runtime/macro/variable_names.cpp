#include "macro/variable_names.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/numbers.h"

namespace kadr::macro {

using nc::VariableRange;

ControlVariable shown(std::string name, const ControlValue& value, std::string_view text) {
    ControlVariable variable;
    variable.name = std::move(name);
    variable.number = value.number;
    variable.text = text;
    switch (value.kind) {
        case ControlValue::Kind::Bool: variable.kind = ControlVariable::Kind::Bool; break;
        case ControlValue::Kind::Int:
        case ControlValue::Kind::Char: variable.kind = ControlVariable::Kind::Int; break;
        case ControlValue::Kind::Text:
        case ControlValue::Kind::Axis:
        case ControlValue::Kind::Frame: variable.kind = ControlVariable::Kind::Text; break;
        case ControlValue::Kind::Vacant: variable.kind = ControlVariable::Kind::Vacant; break;
        default: variable.kind = ControlVariable::Kind::Real;
    }
    return variable;
}

std::string VariableNames::in_family(const nc::VariableForm& form, std::int64_t number) const {
    if (!form.closing.empty()) return std::string(numbers_->name_of(number)) + form.closing;
    std::string name = form.name;
    const std::string digits = std::to_string(number);
    if (form.is_family) name += digits;
    if (!form.indices.empty()) name += language_.index_open + digits + language_.index_close;
    return name;
}

std::string VariableNames::with_meaning(const nc::VariableForm& form, std::int64_t number) const {
    const std::string name = '`' + in_family(form, number) + '`';
    const VariableRange* range = find_range(form, number);
    const bool is_explained = range != nullptr && !range->meaning.empty();
    return is_explained ? name + " (" + range->meaning + ')' : name;
}

std::string VariableNames::of_machine_value(std::span<const std::int64_t> indices) const {
    std::string name(numbers_->name_of(indices[0]));
    for (std::size_t i = 1; i < indices.size(); ++i) {
        name += i == 1 ? language_.index_open : ',';
        const std::int64_t index = indices[i];
        const bool is_axis = index < 0 && index >= -static_cast<std::int64_t>(kAxes);
        name += is_axis ? std::string(kAxisNames[static_cast<std::size_t>(-index - 1)])
                        : std::to_string(index);
    }
    if (indices.size() > 1) name += language_.index_close;
    return name;
}

std::string VariableNames::at_slot(VariableRange::Kind kind, std::size_t slot) const {
    for (const nc::VariableForm& form : language_.variables) {
        for (const VariableRange& range : form.ranges) {
            const std::int64_t number = range.first + static_cast<std::int64_t>(slot) - range.slot;
            if (range.kind == kind && number >= range.first && number <= range.last)
                return in_family(form, number);
        }
    }
    return {};
}

std::string VariableNames::of_element(const nc::ControlSymbol& symbol,
                                      std::uint32_t element) const {
    if (symbol.dimensions == 0) return symbol.name;
    std::array<std::uint32_t, 3> indices{};
    for (std::size_t i = symbol.dimensions; i-- > 0;) {
        indices[i] = element % symbol.sizes[i];
        element /= symbol.sizes[i];
    }
    std::string name = symbol.name + language_.index_open;
    for (std::size_t i = 0; i < symbol.dimensions; ++i) {
        if (i > 0) name += ',';
        name += std::to_string(indices[i]);
    }
    return name + language_.index_close;
}

std::string VariableNames::of_operation(nc::Operation operation) const {
    const auto form =
        std::ranges::find(language_.functions, operation, &nc::FunctionForm::operation);
    return form == language_.functions.end() ? std::string(info(operation).name) : form->name;
}

std::string VariableNames::written(const control::ControlFrame& frame) const {
    std::string out;
    const auto add = [&](nc::Operation operation, nc::FramePart part, double neutral) {
        std::string pairs;
        for (std::size_t i = 0; i < kAxes; ++i) {
            const double value = part_of(frame, part, static_cast<Axis>(i)).value_or(neutral);
            if (round_to(value, 9) == neutral) continue;
            pairs += (pairs.empty() ? "" : ",") + std::string(kAxisNames[i]);
            if (part == nc::FramePart::Mirror) continue;
            pairs += ',';
            append_shortest(pairs, round_to(value, 9));
        }
        if (pairs.empty()) return;
        out += (out.empty() ? "" : ":") + of_operation(operation) + language_.open + pairs +
               language_.close;
    };
    add(nc::Operation::FrameShift, nc::FramePart::Shift, 0);
    add(nc::Operation::FrameFine, nc::FramePart::Fine, 0);
    add(nc::Operation::FrameRotation, nc::FramePart::Rotation, 0);
    add(nc::Operation::FrameScale, nc::FramePart::Scale, 1);
    add(nc::Operation::FrameMirror, nc::FramePart::Mirror, 0);
    if (out.empty())
        out = of_operation(nc::Operation::FrameShift) + language_.open + language_.close;
    return out;
}

}  // namespace kadr::macro
