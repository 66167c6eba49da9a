#include "macro/value_types.h"

#include <cmath>

#include "base/diagnostics/control.h"
#include "base/numbers.h"

namespace kadr::macro {

namespace {

std::string_view type_name(nc::ValueType type) {
    switch (type) {
        case nc::ValueType::Real: return "a real";
        case nc::ValueType::Int: return "a whole number";
        case nc::ValueType::Bool: return "a truth value";
        case nc::ValueType::Char: return "a character";
        case nc::ValueType::Text: return "a text";
        case nc::ValueType::Axis: return "an axis";
        case nc::ValueType::Frame: return "a frame";
    }
    return "";
}

}  // namespace

VariableFault convert(nc::ValueType type, ControlValue& value, std::string_view text) {
    if (value.is_vacant()) return {};
    const bool is_own_kind = type == nc::ValueType::Axis || type == nc::ValueType::Frame;
    if (is_own_kind || value.kind == ControlValue::Kind::Axis || value.is_frame()) {
        if (value.kind == ControlValue::of(0, type).kind) return {};
        return {&diag::TypesDiffer, {std::string(type_name(type)), std::string(kind_name(value))}};
    }
    if (type == nc::ValueType::Text) {
        if (value.kind == ControlValue::Kind::Real || value.kind == ControlValue::Kind::Int)
            return {&diag::TypesDiffer, {"a text", "a number"}};
        return {};
    }
    if (value.is_text()) {
        if (type == nc::ValueType::Bool) {
            value = ControlValue::of(text.empty() ? 0 : 1, type);
            return {};
        }
        if (type != nc::ValueType::Char || count_code_points(text) != 1)
            return {&diag::TypesDiffer, {std::string(type_name(type)), "a text"}};
        value = ControlValue::of(first_code_point(text), type);
    }
    double number = value.number;
    const auto range_fault = [&] {
        std::string shown;
        append_shortest(shown, value.number);
        return VariableFault{&diag::ValueForType, {shown, std::string(type_name(type))}};
    };
    switch (type) {
        case nc::ValueType::Int:
            number = std::floor(number + 0.5);
            if (!(number >= -2147483648.0 && number <= 2147483647.0)) return range_fault();
            break;
        case nc::ValueType::Char:
            number = std::floor(number + 0.5);
            if (!(number >= 0 && number <= 255)) return range_fault();
            break;
        case nc::ValueType::Bool: number = number != 0 ? 1 : 0; break;
        default: break;
    }
    value = ControlValue::of(number, type);
    return {};
}

std::string written_text(const ControlValue& value, std::string_view text) {
    if (value.kind == ControlValue::Kind::Char) return value.character();
    if (value.kind == ControlValue::Kind::Bool) return value.number != 0 ? "1" : "0";
    return std::string(text);
}

}  // namespace kadr::macro
