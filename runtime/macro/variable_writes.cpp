// variable_writes.cpp — values that variables take: converted to their type, within their
// limits, and noted if somebody looks on.
#include <cmath>
#include <utility>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "macro/control_variables.h"

namespace kadr::macro {

using nc::ControlInstruction;
using nc::SystemQuantity;
using nc::VariableRange;

template <typename Set>
void ControlVariables::change(Store& store, std::size_t slot, const nc::ControlSymbol* symbol,
                              Set set) {
    if (changes_ == nullptr) return set();
    VariableChange& change = changes_->emplace_back();
    change.before = shown_in(store, slot, symbol);
    set();
    change.after = shown_in(store, slot, symbol);
    // Where nothing is vacant, a variable of the language is 0 until it is set.
    const bool was_zero = symbol == nullptr && !language_.rules.has_vacant &&
                          change.before.kind == ControlVariable::Kind::Vacant;
    if (was_zero) change.before.kind = change.after.kind;
}

void ControlVariables::set_argument(Level& level, std::uint32_t slot, const ControlValue& value) {
    change(level.locals, slot, nullptr, [&] { level.locals.values[slot] = value; });
}

void ControlVariables::note_change(std::optional<ControlVariable> before, ControlVariable after) {
    if (changes_ == nullptr) return;
    if (!before) before = shown(after.name, {}, {});
    changes_->push_back({std::move(*before), std::move(after)});
}

void ControlVariables::set_number(const VariableRef& variable, std::uint32_t element,
                                  double number) {
    const std::uint32_t slot = variable.slot + element;
    const bool is_local = variable.symbol == nullptr && variable.store == &level_->locals;
    const nc::ControlSymbol* symbol = is_local ? declared_at(*level_, slot) : variable.symbol;
    change(*variable.store, slot, symbol,
           [&] { variable.store->values[slot] = ControlValue::of(number, variable.type); });
}

SystemQuantity ControlVariables::quantity_of(std::uint32_t form, std::int64_t number) const {
    const VariableRange* range = find_range(language_.variables[form], number);
    const bool is_system = range != nullptr && range->kind == VariableRange::Kind::System;
    return is_system ? range->quantity : SystemQuantity::None;
}

bool ControlVariables::must_wait(const ControlInstruction& target,
                                 std::span<const std::int64_t> indices) const {
    if (system_variables_.is_in_step()) return false;
    if (target.kind == ControlInstruction::Kind::System ||
        target.kind == ControlInstruction::Kind::SystemPart)
        return true;
    return target.kind == ControlInstruction::Kind::Family &&
           quantity_of(target.index, indices[0]) != SystemQuantity::None;
}

VariableFault ControlVariables::store(const ControlInstruction& target,
                                      std::span<const std::int64_t> indices,
                                      const ControlValue& value, const Content& content) {
    const std::string_view text = content.text;
    ControlValue converted = value;
    switch (target.kind) {
        case ControlInstruction::Kind::Global:
        case ControlInstruction::Kind::Local: {
            if (VariableFault fault = convert(target.type, converted, text); fault.row != nullptr)
                return fault;
            Store& store =
                target.kind == ControlInstruction::Kind::Global ? globals_ : level_->locals;
            const nc::ControlSymbol* symbol = &store == &globals_ || changes_ == nullptr
                                                  ? nullptr
                                                  : declared_at(*level_, target.index);
            change(store, target.index, symbol, [&] { store.values[target.index] = converted; });
            return {};
        }
        case ControlInstruction::Kind::Family: return store_family(target.index, indices[0], value);
        case ControlInstruction::Kind::Input: {
            const VariableRange& range = language_.variables[target.index].ranges[0];
            return store_input(target.index, range,
                               names_.of_machine_value(indices.first(target.count)), value, text);
        }
        case ControlInstruction::Kind::System: {
            const auto quantity = static_cast<SystemQuantity>(target.index);
            if (target.type == nc::ValueType::Frame) {
                if (content.frame == nullptr)
                    return {&diag::TypesDiffer, {"a frame", std::string(kind_name(value))}};
                return system_variables_.set_frame(quantity, indices[0], *content.frame);
            }
            if (target.type == nc::ValueType::Text)
                return system_variables_.set_text(quantity, indices[0], value, text);
            return system_variables_.set_number(quantity, {indices[0], indices[1]}, value);
        }
        case ControlInstruction::Kind::SystemPart:
        case ControlInstruction::Kind::ElementPart: return store_part(target, indices, value);
        case ControlInstruction::Kind::Element: {
            const nc::ControlSymbol& symbol = level_->symbols.at(target.index);
            const auto slot = Evaluator::element(symbol, indices);
            if (!slot) return {&diag::IndexWrong, {Evaluator::wrong_index(symbol, indices)}};
            if (target.count == symbol.dimensions)
                return store_element(symbol, *slot, value, content);
            // One character of a text; the code 0 cuts it there.
            const std::int64_t index = indices[symbol.dimensions];
            if (VariableFault fault = convert(nc::ValueType::Char, converted, text);
                fault.row != nullptr)
                return fault;
            Store& texts = *level_->stores[target.index];
            const ControlValue& old = texts.values[*slot];
            std::string whole = old.is_text() ? texts.texts[old.text] : std::string();
            if (index < 0 || index >= symbol.text_size)
                return {&diag::IndexWrong, {'`' + symbol.name + '`'}};
            const auto at = static_cast<std::size_t>(index);
            const std::size_t length = count_code_points(whole);
            std::string changed(code_points(whole, 0, at));
            if (converted.number != 0) {
                if (at > length) changed.append(at - length, ' ');
                changed += converted.character();
                if (at < length) changed += code_points(whole, at + 1, length);
            }
            whole = std::move(changed);
            change(texts, *slot, &symbol, [&] { texts.set_text(*slot, whole); });
            return {};
        }
        case ControlInstruction::Kind::Number:
        case ControlInstruction::Kind::Vacant:
        case ControlInstruction::Kind::Text:
        case ControlInstruction::Kind::Operate: break;
    }
    return {&diag::VariableReadOnly, {"this constant"}};
}

/// Programs keep the limits of what is defined for all of them.
VariableFault ControlVariables::check_limits(const nc::ControlSymbol& symbol,
                                             const ControlValue& value) const {
    if (!symbol.is_shared || limits_.empty() || !value.is_number()) return {};
    const auto known = limits_.find(symbol.name);
    if (known == limits_.end()) return {};
    const bool is_below = value.number < known->second.least;
    if (!is_below && value.number <= known->second.most) return {};
    std::array<std::string, 2> shown;
    append_shortest(shown[0], value.number);
    append_shortest(shown[1], is_below ? known->second.least : known->second.most);
    return {is_below ? &diag::VariableBelow : &diag::VariableAbove,
            {symbol.name, shown[0], shown[1]}};
}

VariableFault ControlVariables::store_element(const nc::ControlSymbol& symbol, std::uint32_t slot,
                                              const ControlValue& value, const Content& content) {
    const std::string_view text = content.text;
    ControlValue converted = value;
    if (VariableFault fault = convert(symbol.type, converted, text); fault.row != nullptr)
        return fault;
    if (VariableFault fault = check_limits(symbol, converted); fault.row != nullptr) return fault;
    Store& store = *level_->stores[level_->symbols.index_of(symbol)];
    if (symbol.type == nc::ValueType::Frame) {
        change(store, slot, &symbol, [&] { store.set_frame(slot, *content.frame); });
        return {};
    }
    if (symbol.type != nc::ValueType::Text) {
        change(store, slot, &symbol, [&] { store.values[slot] = converted; });
        return {};
    }
    const std::string written = written_text(value, text);
    if (const std::size_t length = count_code_points(written); length > symbol.text_size) {
        return {&diag::TextTooLong, {std::to_string(length), std::to_string(symbol.text_size)}};
    }
    change(store, slot, &symbol, [&] { store.set_text(slot, written); });
    return {};
}

VariableFault ControlVariables::store_family(std::uint32_t form, std::int64_t number,
                                             const ControlValue& value) {
    const nc::VariableForm& family = language_.variables[form];
    const VariableRange* range = find_range(family, number);
    const std::string name = names_.in_family(family, number);
    if (range == nullptr) return {&diag::VariableNumber, {name}};
    if (!value.is_number()) return {&diag::TypesDiffer, {name, std::string(kind_name(value))}};
    const auto slot = static_cast<std::size_t>(range->slot + (number - range->first));
    ControlValue converted = value;
    switch (range->kind) {
        case VariableRange::Kind::Global:
        case VariableRange::Kind::Local: {
            if (VariableFault fault = convert(range->type, converted, {}); fault.row != nullptr)
                return fault;
            const bool is_global = range->kind == VariableRange::Kind::Global;
            Store& store = is_global ? globals_ : level_->locals;
            change(store, slot, nullptr, [&] { store.values[slot] = converted; });
            return {};
        }
        case VariableRange::Kind::Constant: return {&diag::VariableReadOnly, {name}};
        case VariableRange::Kind::Input: return store_input(form, *range, name, value, {});
        case VariableRange::Kind::Bits: return store_bits(form, *range, number, value);
        case VariableRange::Kind::Same:
        case VariableRange::Kind::Unsupported:
            return {&diag::IsoNotSupported, {'`' + name + "` (" + range->meaning + ')'}};
        case VariableRange::Kind::System: break;
    }
    return system_variables_.set_number(range->quantity, indices_of(*range, number), value);
}

/// A component: the frame is read, changed and written again. The axis is the last index.
VariableFault ControlVariables::store_part(const ControlInstruction& target,
                                           std::span<const std::int64_t> indices,
                                           const ControlValue& value) {
    if (!value.is_number())
        return {&diag::TypesDiffer, {"a component of a frame", std::string(kind_name(value))}};
    const auto axis = static_cast<Axis>(-indices[target.count - 1u] - 1);
    const nc::FramePart part = target.part();
    const bool is_distance = part == nc::FramePart::Shift || part == nc::FramePart::Fine;
    const double wanted = is_distance ? value.number * axis_unit(axis) : value.number;
    const auto set = [&](control::ControlFrame& frame) -> VariableFault {
        if (set_part(frame, part, axis, wanted)) return {};
        if (part == nc::FramePart::Scale && wanted == 0) return {&diag::ScaleInvalid, {"0"}};
        return {&diag::IsoNotSupported, {"such a component of this frame"}};
    };
    if (target.kind == ControlInstruction::Kind::SystemPart) {
        const auto quantity = static_cast<SystemQuantity>(target.index);
        const std::int64_t number = target.count > 1 ? indices[0] : 0;
        control::ControlFrame whole;
        if (frame(quantity, number, whole) != Answer::Value)
            return {&diag::VariableNumber, {"of this offset"}};
        if (VariableFault fault = set(whole); fault.row != nullptr) return fault;
        return system_variables_.set_frame(quantity, number, whole);
    }
    const nc::ControlSymbol& symbol = level_->symbols.at(target.index);
    const auto slot = Evaluator::element(symbol, indices);
    if (!slot) return {&diag::IndexWrong, {Evaluator::wrong_index(symbol, indices)}};
    Store& store = *level_->stores[target.index];
    const ControlValue& old = store.values[*slot];
    control::ControlFrame whole = old.is_frame() ? store.frames[old.text] : control::ControlFrame();
    if (VariableFault fault = set(whole); fault.row != nullptr) return fault;
    change(store, *slot, &symbol, [&] { store.set_frame(*slot, whole); });
    return {};
}

}  // namespace kadr::macro
