// machine_values.cpp — what the machine tells a program: inputs, data of its PLC, machine data.
// Named values, each by the name that a program reads it by.
//
// One that nobody has given is 0, and that is told once.
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/diagnostics/control.h"
#include "base/numbers.h"
#include "macro/control_variables.h"

namespace kadr::macro {

using nc::VariableRange;

namespace {

constexpr int kBits = 32;

/// Of `$MN_USER_DATA_INT[3]` what stands in front of the indices.
std::string_view front_of(std::string_view name, char open) {
    return name.substr(0, std::min(name.find(open), name.size()));
}

}  // namespace

std::string ControlVariables::named(std::uint32_t form, std::int64_t number) const {
    const nc::VariableForm& family = language_.variables[form];
    const std::string name = '`' + name_of(family, number) + '`';
    const VariableRange* range = find_range(family, number);
    const bool is_explained = range != nullptr && !range->meaning.empty();
    return is_explained ? name + " (" + range->meaning + ')' : name;
}

/// The whole name of a value of an open form; an axis by the name of that axis.
std::string ControlVariables::input_name(std::uint32_t form,
                                         std::span<const std::int64_t> indices) const {
    static_cast<void>(form);
    std::string name(names_->name_of(indices[0]));
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

Variables::Answer ControlVariables::input(std::uint32_t form, std::span<const std::int64_t> indices,
                                          Value& out, std::string& text) {
    return read_input(form, language_.variables[form].ranges[0], input_name(form, indices), out,
                      text);
}

Variables::Answer ControlVariables::read_input(std::uint32_t form, const VariableRange& range,
                                               const std::string& name, Value& out,
                                               std::string& text) {
    static_cast<void>(form);
    const auto found = machine_values_.find(name);
    if (found != machine_values_.end()) {
        out = found->second.value;
        text = found->second.text;
        return Answer::Value;
    }
    out = Value::of(0, range.type);
    const bool is_first = told_missing_.emplace(front_of(name, language_.index_open)).second;
    if (is_first && tell_missing_) tell_missing_(name, range.meaning);
    return Answer::Value;
}

/// 32 variables as one number, the first one its lowest bit; a number with a sign (F 6.5).
Variables::Answer ControlVariables::read_bits(std::uint32_t form, const VariableRange& range,
                                              std::int64_t number, Value& out) {
    const auto first = static_cast<std::int64_t>(range.value) + (number - range.first) * kBits;
    std::uint32_t bits = 0;
    // Of inputs that nobody has told the number is told that the program reads, and not each.
    bool is_missing = false;
    bool is_given = false;
    const auto tell = std::exchange(
        tell_missing_, [&](const std::string&, const std::string&) { is_missing = true; });
    Answer answered = Answer::Value;
    for (int i = 0; i < kBits && answered == Answer::Value; ++i) {
        Value bit;
        answered = family(form, first + i, bit);
        if (bit.number != 0) bits |= std::uint32_t{1} << i;
        is_given |= machine_values_.contains(name_of(language_.variables[form], first + i));
    }
    tell_missing_ = tell;
    if (answered != Answer::Value) return answered;
    if (is_missing && !is_given && tell_missing_)
        tell_missing_(name_of(language_.variables[form], number), range.meaning);
    out = Value::of(static_cast<std::int32_t>(bits), range.type);
    return Answer::Value;
}

ControlVariables::Fault ControlVariables::store_bits(std::uint32_t form, const VariableRange& range,
                                                     std::int64_t number, const Value& value) {
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
        const Fault fault = store_family(form, first + i, Value::real(bits >> i & 1u));
        if (fault.row != nullptr) return fault;
    }
    return {};
}

ControlVariables::Fault ControlVariables::store_input(std::uint32_t form,
                                                      const VariableRange& range,
                                                      const std::string& name, const Value& value,
                                                      std::string_view text) {
    if (!range.is_shared && !is_machine_) return {&diag::VariableReadOnly, {'`' + name + '`'}};
    const bool is_open = language_.variables[form].is_open;
    if (!value.is_number() && !(value.is_text() && is_open))
        return {&diag::TypesDiffer, {'`' + name + '`', std::string(kind_name(value))}};
    Value converted = value;
    if (!is_open) {
        if (Fault fault = convert(range.type, converted, text); fault.row != nullptr) return fault;
    }
    const auto before = machine_values_.find(name);
    std::optional<ControlVariable> was;
    if (changes_ != nullptr && before != machine_values_.end())
        was = shown(name, before->second.value, before->second.text);
    machine_values_.insert_or_assign(name, MachineValue{converted, std::string(text), form});
    if (changes_ != nullptr) note_change(std::move(was), shown(name, converted, text));
    return {};
}

/// Those that programs write, too: what only the machine says is known without the program.
void ControlVariables::list_inputs(std::uint32_t form, std::vector<ControlVariable>& out) const {
    for (const auto& [name, value] : machine_values_) {
        const auto& ranges = language_.variables[form].ranges;
        const bool is_shared = std::ranges::any_of(ranges, &VariableRange::is_shared);
        if (value.form == form && is_shared) out.push_back(shown(name, value.value, value.text));
    }
}

}  // namespace kadr::macro
