// variable_names.cpp — how programs write their variables, for lists and for who looks on.
#include <utility>

#include "base/numbers.h"
#include "macro/control_variables.h"

namespace kadr::macro {

using nc::VariableRange;

ControlVariable shown(std::string name, const Value& value, std::string_view text) {
    ControlVariable variable;
    variable.name = std::move(name);
    variable.number = value.number;
    variable.text = text;
    switch (value.kind) {
        case Value::Kind::Bool: variable.kind = ControlVariable::Kind::Bool; break;
        case Value::Kind::Int:
        case Value::Kind::Char: variable.kind = ControlVariable::Kind::Int; break;
        case Value::Kind::Text:
        case Value::Kind::Axis:
        case Value::Kind::Frame: variable.kind = ControlVariable::Kind::Text; break;
        case Value::Kind::Vacant: variable.kind = ControlVariable::Kind::Vacant; break;
        default: variable.kind = ControlVariable::Kind::Real;
    }
    return variable;
}

namespace {

std::string element_name(const nc::Symbol& symbol, std::uint32_t place, char open, char close) {
    if (symbol.dimensions == 0) return symbol.name;
    std::array<std::uint32_t, 3> indices{};
    for (std::size_t i = symbol.dimensions; i-- > 0;) {
        indices[i] = place % symbol.sizes[i];
        place /= symbol.sizes[i];
    }
    std::string name = symbol.name + open;
    for (std::size_t i = 0; i < symbol.dimensions; ++i) {
        if (i > 0) name += ',';
        name += std::to_string(indices[i]);
    }
    return name + close;
}

}  // namespace

/// As the program writes it: `R1`, `#100`.
std::string ControlVariables::name_of(const nc::VariableForm& form, std::int64_t number) const {
    if (!form.closing.empty()) return std::string(names_->name_of(number)) + form.closing;
    std::string name = form.name;
    const std::string digits = std::to_string(number);
    if (form.is_family) name += digits;
    if (!form.indices.empty()) name += language_.index_open + digits + language_.index_close;
    return name;
}

std::string ControlVariables::name_in(const Store& store, std::size_t slot) const {
    const auto wanted =
        &store == &globals_ ? VariableRange::Kind::Global : VariableRange::Kind::Local;
    for (const nc::VariableForm& form : language_.variables) {
        for (const VariableRange& range : form.ranges) {
            const std::int64_t number = range.first + static_cast<std::int64_t>(slot) - range.slot;
            if (range.kind == wanted && number >= range.first && number <= range.last)
                return name_of(form, number);
        }
    }
    return {};
}

ControlVariable ControlVariables::shown_in(const Store& store, std::size_t slot,
                                           const nc::Symbol* symbol) const {
    const Value& value = store.values[slot];
    std::string name = symbol == nullptr
                           ? name_in(store, slot)
                           : element_name(*symbol, static_cast<std::uint32_t>(slot) - symbol->slot,
                                          language_.index_open, language_.index_close);
    // Where nothing is vacant, what was declared begins with the zero of its type.
    const bool begins_with_zero =
        symbol != nullptr && value.is_vacant() && !language_.rules.has_vacant &&
        symbol->type != nc::ValueType::Frame && symbol->type != nc::ValueType::Axis;
    if (begins_with_zero) return shown(std::move(name), Value::of(0, symbol->type), {});
    if (value.is_frame()) return shown(std::move(name), value, written(store.frames[value.text]));
    if (const auto axis = value.axis())
        return shown(std::move(name), value, kAxisNames[index(*axis)]);
    if (const auto spindle = value.spindle())
        return shown(std::move(name), value, "S" + std::to_string(*spindle));
    return shown(std::move(name), value, store.content(value).text);
}

/// A frame by its constants, as a program would write it: `CTRANS(X,10):CROT(Z,30)`.
std::string ControlVariables::written(const control::ControlFrame& frame) const {
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
        out += (out.empty() ? "" : ":") + word_of(operation) + language_.open + pairs +
               language_.close;
    };
    add(nc::Operation::FrameShift, nc::FramePart::Shift, 0);
    add(nc::Operation::FrameFine, nc::FramePart::Fine, 0);
    add(nc::Operation::FrameRotation, nc::FramePart::Rotation, 0);
    add(nc::Operation::FrameScale, nc::FramePart::Scale, 1);
    add(nc::Operation::FrameMirror, nc::FramePart::Mirror, 0);
    if (out.empty()) out = word_of(nc::Operation::FrameShift) + language_.open + language_.close;
    return out;
}

}  // namespace kadr::macro
