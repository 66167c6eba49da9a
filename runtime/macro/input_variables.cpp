// input_variables.cpp — variables that are values of the machine: one by its name, or 32 as one
// number.
#include <cmath>
#include <optional>
#include <utility>

#include "base/diagnostics/control.h"
#include "base/numbers.h"
#include "macro/control_variables.h"

namespace kadr::macro {

using nc::VariableRange;

namespace {

constexpr int kBits = 32;

}  // namespace

Variables::Answer ControlVariables::input(std::uint32_t form, std::span<const std::int64_t> indices,
                                          ControlValue& out, std::string& text) {
    machine_values_.read(language_.variables[form].ranges[0], names_.of_machine_value(indices), out,
                         text);
    return Answer::Value;
}

/// 32 variables as one number, the first one its lowest bit; a number with a sign (F 6.5).
Variables::Answer ControlVariables::read_bits(std::uint32_t form, const VariableRange& range,
                                              std::int64_t number, ControlValue& out) {
    const auto first = static_cast<std::int64_t>(range.value) + (number - range.first) * kBits;
    std::uint32_t bits = 0;
    // Of inputs that nobody has given the number is reported that the program reads, and not each.
    bool is_missing = false;
    bool is_given = false;
    const auto report = machine_values_.report_missing_to(
        [&](const std::string&, const std::string&) { is_missing = true; });
    Answer answered = Answer::Value;
    for (int i = 0; i < kBits && answered == Answer::Value; ++i) {
        ControlValue bit;
        answered = family(form, first + i, bit);
        if (bit.number != 0) bits |= std::uint32_t{1} << i;
        is_given |=
            machine_values_.find(names_.in_family(language_.variables[form], first + i)) != nullptr;
    }
    machine_values_.report_missing_to(report);
    if (answered != Answer::Value) return answered;
    if (is_missing && !is_given && report)
        report(names_.in_family(language_.variables[form], number), range.meaning);
    out = ControlValue::of(static_cast<std::int32_t>(bits), range.type);
    return Answer::Value;
}

VariableFault ControlVariables::store_bits(std::uint32_t form, const VariableRange& range,
                                           std::int64_t number, const ControlValue& value) {
    const double whole = std::round(value.number);
    constexpr double kMost = 4294967296.0;
    if (!(whole >= -kMost / 2 && whole < kMost)) {
        std::string shown_value;
        append_shortest(shown_value, value.number);
        return {&diag::ValueForType, {shown_value, "a number of 32 bits"}};
    }
    const auto bits = static_cast<std::uint32_t>(static_cast<std::int64_t>(whole));
    const auto first = static_cast<std::int64_t>(range.value) + (number - range.first) * kBits;
    for (int i = 0; i < kBits; ++i) {
        const VariableFault fault =
            store_family(form, first + i, ControlValue::real(bits >> i & 1u));
        if (fault.row != nullptr) return fault;
    }
    return {};
}

VariableFault ControlVariables::store_input(std::uint32_t form, const VariableRange& range,
                                            const std::string& name, const ControlValue& value,
                                            std::string_view text) {
    if (!range.is_shared && !machine_values_.is_machine_writing())
        return {&diag::VariableReadOnly, {'`' + name + '`'}};
    const bool is_open = language_.variables[form].is_open;
    if (!value.is_number() && !(value.is_text() && is_open))
        return {&diag::TypesDiffer, {'`' + name + '`', std::string(kind_name(value))}};
    ControlValue converted = value;
    if (!is_open) {
        if (VariableFault fault = convert(range.type, converted, text); fault.row != nullptr)
            return fault;
    }
    const MachineValues::Entry* const before = machine_values_.find(name);
    std::optional<ControlVariable> was;
    if (changes_ != nullptr && before != nullptr) was = shown(name, before->value, before->text);
    machine_values_.set(name, {converted, std::string(text), form});
    if (changes_ != nullptr) note_change(std::move(was), shown(name, converted, text));
    return {};
}

}  // namespace kadr::macro
