#include "macro/control_variables.h"

#include <algorithm>
#include <utility>

#include "macro/whole_number.h"
#include "nc/control_words.h"

namespace kadr::macro {

using nc::ControlInstruction;
using nc::VariableRange;

ControlVariables::ControlVariables(const nc::Dialect& dialect, const nc::LineReader& reader)
    : tables_(dialect.tables()),
      language_(tables_.language),
      names_(language_),
      system_variables_(dialect, reader),
      machine_values_(language_) {
    globals_.grow(language_.global_slots);
    for (const nc::VariableForm& form : language_.variables) {
        for (const VariableRange& range : form.ranges) {
            if (!range.has_initial || range.kind != VariableRange::Kind::Global) continue;
            for (std::int64_t i = 0; i <= range.last - range.first; ++i)
                globals_.values[range.slot + static_cast<std::size_t>(i)] =
                    ControlValue::of(range.value, range.type);
        }
    }
    main_.locals.grow(language_.local_slots);
}

std::unique_ptr<Level> ControlVariables::new_level() {
    auto level = std::make_unique<Level>();
    level->locals.grow(language_.local_slots);
    share_definitions(*level);
    return level;
}

void ControlVariables::share_definitions(Level& level) {
    const std::span<const nc::ControlSymbol> all = definitions_.symbols.all();
    for (std::size_t i = 0; i < all.size(); ++i) {
        nc::ControlSymbol symbol = all[i];
        symbol.is_reference = symbol.is_shared = true;
        bind(level, std::move(symbol), *definitions_.stores[i]);
    }
}

const nc::ControlSymbol& ControlVariables::declare(nc::ControlSymbol symbol) {
    Store& store = symbol.is_plain() ? level_->locals : level_->elements;
    symbol.slot = static_cast<std::uint32_t>(store.values.size());
    store.grow(symbol.slot + std::size_t{symbol.count()});
    bind(*level_, std::move(symbol), store);
    const nc::ControlSymbol& added = level_->symbols.all().back();
    if (changes_ != nullptr && added.dimensions == 0)
        note_change({}, shown_in(store, added.slot, &added));
    return added;
}

void ControlVariables::bind(Level& level, nc::ControlSymbol symbol, Store& store) {
    // Code names single values by their slots: each symbol has one, so that they are the same in
    // every call, whatever sizes arrays have.
    if (!symbol.is_plain()) level.locals.grow(level.locals.values.size() + 1);
    level.symbols.add(std::move(symbol));
    level.stores.push_back(&store);
}

ControlVariables::VariableRef ControlVariables::variable_of(const ControlInstruction& load,
                                                            std::span<const std::int64_t> indices) {
    switch (load.kind) {
        case ControlInstruction::Kind::Global: return {&globals_, load.index, load.type, nullptr};
        case ControlInstruction::Kind::Local:
            return {&level_->locals, load.index, load.type, nullptr};
        case ControlInstruction::Kind::Family: {
            const VariableRange* range = find_range(language_.variables[load.index], indices[0]);
            const bool is_global = range != nullptr && range->kind == VariableRange::Kind::Global;
            if (!is_global && (range == nullptr || range->kind != VariableRange::Kind::Local))
                return {};
            const auto slot = static_cast<std::uint32_t>(range->slot + (indices[0] - range->first));
            return {is_global ? &globals_ : &level_->locals, slot, range->type, nullptr};
        }
        case ControlInstruction::Kind::Element: {
            const nc::ControlSymbol& symbol = level_->symbols.at(load.index);
            const bool is_whole = load.count == 0;
            const auto slot =
                is_whole ? std::optional(symbol.slot) : Evaluator::element(symbol, indices);
            if (!slot || load.count > symbol.dimensions) return {};
            return {level_->stores[load.index], *slot, symbol.type, &symbol};
        }
        default: return {};
    }
}

bool ControlVariables::set_global(std::string_view name, double value) {
    for (const nc::VariableForm& form : language_.variables) {
        if (!form.is_family || !name.starts_with(form.name)) continue;
        const auto number = whole_number(name.substr(form.name.size()));
        const VariableRange* range = number ? find_range(form, *number) : nullptr;
        if (range == nullptr || range->kind != VariableRange::Kind::Global) continue;
        const auto slot = static_cast<std::size_t>(range->slot + (*number - range->first));
        globals_.values[slot] = ControlValue::of(value, range->type);
        return true;
    }
    return false;
}

Variables::Answer ControlVariables::system(nc::SystemQuantity quantity, std::int64_t first,
                                           std::int64_t second, double& out) {
    if (quantity != nc::SystemQuantity::ArgumentGiven)
        return system_variables_.number(quantity, first, second, out);
    if (first < 1 || first > static_cast<std::int64_t>(level_->given.size()))
        return Answer::Missing;
    out = level_->given[static_cast<std::size_t>(first) - 1] ? 1 : 0;
    return Answer::Value;
}

Variables::Answer ControlVariables::family(std::uint32_t form, std::int64_t number,
                                           ControlValue& out) {
    const VariableRange* range = find_range(language_.variables[form], number);
    if (range == nullptr) return Answer::Missing;
    const auto slot = static_cast<std::size_t>(range->slot + (number - range->first));
    switch (range->kind) {
        case VariableRange::Kind::Global: out = globals_.values[slot]; break;
        case VariableRange::Kind::Local: out = level_->locals.values[slot]; break;
        case VariableRange::Kind::Constant:
            out = range->is_vacant ? ControlValue{} : ControlValue::of(range->value, range->type);
            return Answer::Value;
        case VariableRange::Kind::Input: {
            std::string text;
            machine_values_.read(*range, names_.in_family(language_.variables[form], number), out,
                                 text);
            return Answer::Value;
        }
        case VariableRange::Kind::Bits: return read_bits(form, *range, number, out);
        case VariableRange::Kind::Same:
        case VariableRange::Kind::Unsupported: return Answer::Unsupported;
        case VariableRange::Kind::System: {
            const QuantityIndices indices = indices_of(*range, number);
            double value = 0;
            const Answer answer = system(range->quantity, indices.first, indices.second, value);
            out = ControlValue::of(value, range->type);
            return answer;
        }
    }
    if (out.is_vacant() && !language_.rules.has_vacant) out = ControlValue::of(0, range->type);
    return Answer::Value;
}

bool ControlVariables::load(const ControlInstruction& from, std::span<const std::int64_t> indices,
                            ControlValue& out) {
    switch (from.kind) {
        case ControlInstruction::Kind::Global: out = globals_.values[from.index]; return true;
        case ControlInstruction::Kind::Local: out = level_->locals.values[from.index]; return true;
        case ControlInstruction::Kind::Family:
            return family(from.index, indices[0], out) == Answer::Value;
        case ControlInstruction::Kind::Element: {
            const auto slot = Evaluator::element(level_->symbols.at(from.index), indices);
            if (slot) out = level_->stores[from.index]->values[*slot];
            return slot.has_value();
        }
        default: return false;
    }
}

std::optional<nc::ValueType> ControlVariables::type_of(std::string_view name) const {
    const nc::ControlWords words(tables_, name);
    const std::size_t bracket = std::min(name.find(language_.index_open), name.size());
    const std::string_view front = name.substr(0, bracket);
    if (const nc::ControlSymbol* symbol = level_->symbols.find(words.normal(front)))
        return symbol->type;
    for (const nc::VariableForm& form : language_.variables) {
        if (words.is_same(front, form.name)) {
            const bool is_whole = form.is_family || !form.indices.empty() || bracket == name.size();
            if (is_whole && !form.ranges.empty()) return form.ranges[0].type;
            continue;
        }
        const std::size_t letters = form.name.size();
        if (form.is_open && words.starts_with(0, form.name)) return form.ranges[0].type;
        if (!form.is_family || front.size() <= letters ||
            !words.is_same(front.substr(0, letters), form.name))
            continue;
        const auto number = whole_number(front.substr(letters));
        const VariableRange* range = number ? find_range(form, *number) : nullptr;
        if (range != nullptr) return range->type;
    }
    return std::nullopt;
}

std::string ControlVariables::named(std::uint32_t form, std::int64_t number) const {
    return names_.with_meaning(language_.variables[form], number);
}

std::string ControlVariables::word_of(nc::Operation operation) const {
    return names_.of_operation(operation);
}

bool ControlVariables::set_element(const nc::ControlSymbol& symbol, std::uint32_t element,
                                   double value) {
    return store_element(symbol, symbol.slot + element, ControlValue::real(value), {}).row ==
           nullptr;
}

const nc::ControlSymbol* declared_at(const Level& level, std::uint32_t slot) {
    const std::span<const nc::ControlSymbol> all = level.symbols.all();
    const auto found = std::ranges::find_if(all, [&](const nc::ControlSymbol& symbol) {
        return symbol.is_plain() && symbol.slot == slot;
    });
    return found == all.end() ? nullptr : &*found;
}

ControlVariable ControlVariables::shown_in(const Store& store, std::size_t slot,
                                           const nc::ControlSymbol* symbol) const {
    const ControlValue& value = store.values[slot];
    const auto kind =
        &store == &globals_ ? VariableRange::Kind::Global : VariableRange::Kind::Local;
    std::string name =
        symbol == nullptr
            ? names_.at_slot(kind, slot)
            : names_.of_element(*symbol, static_cast<std::uint32_t>(slot) - symbol->slot);
    // Where nothing is vacant, what was declared begins with the zero of its type.
    const bool begins_with_zero =
        symbol != nullptr && value.is_vacant() && !language_.rules.has_vacant &&
        symbol->type != nc::ValueType::Frame && symbol->type != nc::ValueType::Axis;
    if (begins_with_zero) return shown(std::move(name), ControlValue::of(0, symbol->type), {});
    if (value.is_frame())
        return shown(std::move(name), value, names_.written(store.frames[value.text]));
    if (const auto axis = value.axis())
        return shown(std::move(name), value, kAxisNames[index(*axis)]);
    if (const auto spindle = value.spindle())
        return shown(std::move(name), value, "S" + std::to_string(*spindle));
    return shown(std::move(name), value, store.content(value).text);
}

const Store* ControlVariables::store_of(const VariableRange& range, const Level& level) const {
    if (range.kind == VariableRange::Kind::Global) return &globals_;
    return range.kind == VariableRange::Kind::Local ? &level.locals : nullptr;
}

void ControlVariables::list_range(const nc::VariableForm& form, const VariableRange& range,
                                  const Store& store, std::vector<ControlVariable>& out) const {
    for (std::int64_t number = range.first; number <= range.last; ++number) {
        const auto slot = static_cast<std::size_t>(range.slot + (number - range.first));
        const ControlValue& value = store.values[slot];
        const bool is_untouched = range.has_initial && value.number == range.value;
        if (value.is_vacant() || is_untouched) continue;
        out.push_back(shown(names_.in_family(form, number), value, {}));
    }
}

void ControlVariables::list_declared(const Level& level, const nc::ControlSymbol& symbol,
                                     std::vector<ControlVariable>& out) const {
    const Store& store = *level.stores[level.symbols.index_of(symbol)];
    for (std::uint32_t i = 0; i < symbol.count(); ++i) {
        ControlVariable variable = shown_in(store, symbol.slot + i, &symbol);
        // Of an array those are reported that were set.
        const bool is_reported = symbol.dimensions == 0
                                     ? variable.kind != ControlVariable::Kind::Vacant
                                     : !store.values[symbol.slot + i].is_vacant();
        if (is_reported) out.push_back(std::move(variable));
    }
}

std::vector<ControlVariable> ControlVariables::list() const {
    std::vector<ControlVariable> out;
    for (std::uint32_t i = 0; i < language_.variables.size(); ++i) {
        for (const VariableRange& range : language_.variables[i].ranges) {
            if (const Store* store = store_of(range, *level_))
                list_range(language_.variables[i], range, *store, out);
        }
        machine_values_.list(i, out);
    }
    for (const nc::ControlSymbol& symbol : level_->symbols.all())
        list_declared(*level_, symbol, out);
    return out;
}

std::vector<ControlVariable> ControlVariables::list(const Level& level, VariableOwner owner) const {
    std::vector<ControlVariable> out;
    for (std::uint32_t i = 0; i < language_.variables.size(); ++i) {
        if (owner == VariableOwner::Machine) machine_values_.list(i, out);
        for (const VariableRange& range : language_.variables[i].ranges) {
            const Store* store = store_of(range, level);
            const VariableOwner owned =
                store == &globals_ ? VariableOwner::Control : VariableOwner::Program;
            if (store != nullptr && owned == owner)
                list_range(language_.variables[i], range, *store, out);
        }
    }
    for (const nc::ControlSymbol& symbol : level.symbols.all()) {
        const Store* store = level.stores[level.symbols.index_of(symbol)];
        const bool is_everybodys = store == &definitions_.locals || store == &definitions_.elements;
        const VariableOwner owned = is_everybodys ? VariableOwner::Control : VariableOwner::Program;
        if (owned == owner) list_declared(level, symbol, out);
    }
    return out;
}

}  // namespace kadr::macro
