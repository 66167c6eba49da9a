#include "macro/control_variables.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "base/units.h"
#include "nc/control_words.h"

namespace kadr::macro {

using nc::Instruction;
using nc::Quantity;
using nc::VariableRange;

namespace {

/// Whether the last index of the quantity is an axis, so that it is a length or an angle.
bool is_of_axis(Quantity quantity) {
    switch (quantity) {
        case Quantity::EndPosition:
        case Quantity::WorkPosition:
        case Quantity::HeadPosition:
        case Quantity::MachinePosition:
        case Quantity::ToolLength:
        case Quantity::BasePosition:
        case Quantity::BaseZeroPosition:
        case Quantity::SettablePosition:
        case Quantity::ProbePosition:
        case Quantity::ProbePlace:
        case Quantity::ProbeMachine:
        case Quantity::ApproachStart:
        case Quantity::ApproachEnd:
        case Quantity::WorkOffset: return true;
        default: return false;
    }
}

/// Whether the quantity is a length of a tool.
bool is_of_tool_data(Quantity quantity) {
    switch (quantity) {
        case Quantity::ToolRadius:
        case Quantity::ToolPart:
        case Quantity::RadiusAllowance:
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
        case Quantity::ExtraLength:
        case Quantity::FirstExtraLength:
        case Quantity::ExtraAlong:
        case Quantity::ExtraRadius:
        case Quantity::ExtraBoth: return true;
        default: return false;
    }
}

std::optional<std::int64_t> number_of(std::string_view text) {
    std::int64_t number = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_whole = result.ec == std::errc() && result.ptr == text.data() + text.size();
    return is_whole ? std::optional(number) : std::nullopt;
}

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

ControlVariables::ControlVariables(const nc::Dialect& dialect, const nc::LineReader& reader)
    : dialect_(dialect), tables_(dialect.tables()), language_(tables_.language), reader_(reader) {
    globals_.grow(language_.global_slots);
    for (const nc::VariableForm& form : language_.variables) {
        for (const VariableRange& range : form.ranges) {
            if (!range.has_initial || range.kind != VariableRange::Kind::Global) continue;
            for (std::int64_t i = 0; i <= range.last - range.first; ++i)
                globals_.values[range.slot + static_cast<std::size_t>(i)] =
                    Value::of(range.value, range.type);
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
    const std::span<const nc::Symbol> all = definitions_.symbols.all();
    for (std::size_t i = 0; i < all.size(); ++i) {
        nc::Symbol symbol = all[i];
        symbol.is_reference = symbol.is_shared = true;
        bind(level, std::move(symbol), *definitions_.stores[i]);
    }
}

const nc::Symbol& ControlVariables::declare(nc::Symbol symbol) {
    Store& store = symbol.is_plain() ? level_->locals : level_->elements;
    symbol.slot = static_cast<std::uint32_t>(store.values.size());
    store.grow(symbol.slot + std::size_t{symbol.count()});
    bind(*level_, std::move(symbol), store);
    const nc::Symbol& added = level_->symbols.all().back();
    if (changes_ != nullptr && added.dimensions == 0)
        note_change({}, shown_in(store, added.slot, &added));
    return added;
}

void ControlVariables::bind(Level& level, nc::Symbol symbol, Store& store) {
    // Code names single values by their slots: each symbol has one, so that they are the same in
    // every call, whatever sizes arrays have.
    if (!symbol.is_plain()) level.locals.grow(level.locals.values.size() + 1);
    level.symbols.add(std::move(symbol));
    level.stores.push_back(&store);
}

ControlVariables::VariablePlace ControlVariables::place_of(const Instruction& load,
                                                           std::span<const std::int64_t> indices) {
    switch (load.kind) {
        case Instruction::Kind::Global: return {&globals_, load.index, load.type, nullptr};
        case Instruction::Kind::Local: return {&level_->locals, load.index, load.type, nullptr};
        case Instruction::Kind::Family: {
            const VariableRange* range = find_range(language_.variables[load.index], indices[0]);
            const bool is_global = range != nullptr && range->kind == VariableRange::Kind::Global;
            if (!is_global && (range == nullptr || range->kind != VariableRange::Kind::Local))
                return {};
            const auto slot = static_cast<std::uint32_t>(range->slot + (indices[0] - range->first));
            return {is_global ? &globals_ : &level_->locals, slot, range->type, nullptr};
        }
        case Instruction::Kind::Element: {
            const nc::Symbol& symbol = level_->symbols.at(load.index);
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
        const auto number = number_of(name.substr(form.name.size()));
        const VariableRange* range = number ? find_range(form, *number) : nullptr;
        if (range == nullptr || range->kind != VariableRange::Kind::Global) continue;
        const auto slot = static_cast<std::size_t>(range->slot + (*number - range->first));
        globals_.values[slot] = Value::of(value, range->type);
        return true;
    }
    return false;
}

// ---------------------------------------------------------------- read

ControlVariables::Indices ControlVariables::indices_of(const VariableRange& range,
                                                       std::int64_t number) {
    const std::int64_t place = number - range.first;
    if (range.stride == 0) return {place + range.start, 0};
    return {place / range.stride + range.start, place % range.stride + range.second};
}

Variables::Answer ControlVariables::family(std::uint32_t form, std::int64_t number, Value& out) {
    const VariableRange* range = find_range(language_.variables[form], number);
    if (range == nullptr) return Answer::Missing;
    const auto slot = static_cast<std::size_t>(range->slot + (number - range->first));
    switch (range->kind) {
        case VariableRange::Kind::Global: out = globals_.values[slot]; break;
        case VariableRange::Kind::Local: out = level_->locals.values[slot]; break;
        case VariableRange::Kind::Constant:
            out = range->is_vacant ? Value{} : Value::of(range->value, range->type);
            return Answer::Value;
        case VariableRange::Kind::Input: {
            std::string text;
            return read_input(form, *range, name_of(language_.variables[form], number), out, text);
        }
        case VariableRange::Kind::Bits: return read_bits(form, *range, number, out);
        case VariableRange::Kind::Same:
        case VariableRange::Kind::Unsupported: return Answer::Unsupported;
        case VariableRange::Kind::System: {
            const Indices indices = indices_of(*range, number);
            double value = 0;
            const Answer answer = system(range->quantity, indices.first, indices.second, value);
            out = Value::of(value, range->type);
            return answer;
        }
    }
    if (out.is_vacant() && !language_.rules.has_vacant) out = Value::of(0, range->type);
    return Answer::Value;
}

Variables::Answer ControlVariables::system(Quantity quantity, std::int64_t first,
                                           std::int64_t second, double& out) {
    if (info(quantity).access == nc::QuantityInfo::Access::Write) return Answer::NotReadable;
    if (quantity == Quantity::ModalCode || quantity == Quantity::ModalNumber) {
        const auto code = modal_code(first, quantity == Quantity::ModalNumber);
        if (!code) return Answer::Missing;
        out = *code;
        return Answer::Value;
    }
    switch (quantity) {
        case Quantity::BlockNumber: out = static_cast<double>(block_number_); return Answer::Value;
        case Quantity::MachineCode: out = reader_.machine_code(); return Answer::Value;
        case Quantity::ModalCall: out = modal_call_ ? modal_call_() : 0; return Answer::Value;
        case Quantity::ProgramNumber:
            out = static_cast<double>(number_of(reader_.text().program).value_or(0));
            return Answer::Value;
        default: break;
    }
    if (quantity == Quantity::ProgramLevel) {
        out = static_cast<double>(program_level_);
        return Answer::Value;
    }
    if (quantity == Quantity::ArgumentGiven) {
        if (first < 1 || first > static_cast<std::int64_t>(level_->given.size()))
            return Answer::Missing;
        out = level_->given[static_cast<std::size_t>(first) - 1] ? 1 : 0;
        return Answer::Value;
    }
    if (state_ == nullptr) return Answer::Unsupported;
    if (!in_step_) return Answer::Later;
    const bool is_of_tool =
        quantity == Quantity::WorkPosition || quantity == Quantity::HeadPosition ||
        quantity == Quantity::MachinePosition || quantity == Quantity::BasePosition ||
        quantity == Quantity::BaseZeroPosition || quantity == Quantity::SettablePosition;
    if (is_of_tool && state_->is_compensated()) return Answer::Compensated;
    const auto value = state_->quantity(quantity, first, second);
    if (!value) return Answer::Missing;
    out = to_text_units(quantity, {first, second}, *value);
    return Answer::Value;
}

bool ControlVariables::set_system(Quantity quantity, std::int64_t first, std::int64_t second,
                                  double value) {
    if (state_ == nullptr) return false;
    return state_->set_quantity(quantity, first, second, value, true) == ControlAccess::Write::Done;
}

Variables::Answer ControlVariables::frame(Quantity quantity, std::int64_t index,
                                          control::ControlFrame& out) {
    if (state_ == nullptr) return Answer::Unsupported;
    if (!in_step_) return Answer::Later;
    const auto frame = state_->frame(quantity, index);
    if (!frame) return Answer::Missing;
    out = *frame;
    return Answer::Value;
}

Variables::Answer ControlVariables::text(Quantity quantity, std::int64_t index, std::string& out) {
    if (quantity == Quantity::ProgramName) {
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

std::optional<std::int64_t> ControlVariables::axis_number(Axis axis) const {
    return state_ == nullptr ? std::nullopt : state_->axis_number(axis);
}

std::optional<nc::ValueType> ControlVariables::type_of(std::string_view name) const {
    const nc::ControlWords words(tables_, name);
    const std::size_t bracket = std::min(name.find(language_.index_open), name.size());
    const std::string_view front = name.substr(0, bracket);
    if (const nc::Symbol* symbol = level_->symbols.find(words.normal(front))) return symbol->type;
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
        const auto number = number_of(front.substr(letters));
        const VariableRange* range = number ? find_range(form, *number) : nullptr;
        if (range != nullptr) return range->type;
    }
    return std::nullopt;
}

std::string ControlVariables::word_of(nc::Operation operation) const {
    const auto form =
        std::ranges::find(language_.functions, operation, &nc::FunctionForm::operation);
    return form == language_.functions.end() ? std::string(info(operation).name) : form->name;
}

bool ControlVariables::find_program(std::string_view name) {
    return is_program_ && is_program_(name);
}

bool ControlVariables::has_spindle(std::int64_t number) const {
    return state_ == nullptr ? number <= 1 : state_->has_spindle(number);
}

bool ControlVariables::set_element(const nc::Symbol& symbol, std::uint32_t element, double value) {
    return store_element(symbol, symbol.slot + element, Value::real(value), {}).row == nullptr;
}

void ControlVariables::set_number(const VariablePlace& place, std::uint32_t element,
                                  double number) {
    const std::uint32_t slot = place.slot + element;
    const bool is_local = place.symbol == nullptr && place.store == &level_->locals;
    const nc::Symbol* symbol = is_local ? declared_at(*level_, slot) : place.symbol;
    change(*place.store, slot, symbol,
           [&] { place.store->values[slot] = Value::of(number, place.type); });
}

void ControlVariables::say_units(ContourSaid& contour) const {
    const double unit = axis_unit(Axis::X);
    const double feed = text_scale(nc::Dimension::Feed, reader_.units(), true);
    const nc::Function function = reader_.units().inch ? nc::Function::Inch : nc::Function::Metric;
    // The code that acts by its place in the list of its group.
    int place = reader_.units().inch ? 0 : 1;
    for (const nc::Form& form : tables_.forms) {
        if (form.function != function || form.group < 0) continue;
        const auto group = static_cast<std::size_t>(form.group);
        const auto list = std::ranges::find(language_.code_lists, tables_.groups[group].name,
                                            &nc::CodeList::group);
        if (list == language_.code_lists.end()) break;
        place = static_cast<int>(code_in_list(*list, group).value_or(place + 1)) - 1;
        break;
    }
    for (ContourElement& element : contour) {
        element.shape.from /= unit;
        element.shape.to /= unit;
        element.shape.center /= unit;
        element.feed *= feed;
        element.modes.is_metric = !reader_.units().inch;
        element.modes.units = place;
    }
}

double ControlVariables::axis_unit(Axis axis) const {
    return reader_.units().inch && !is_rotary(axis) ? kMmPerInch : 1;
}

/// How many units of the text 1 mm, or 1 degree, of the axis is.
double ControlVariables::text_factor(const Indices& indices, std::int64_t axis) const {
    static_cast<void>(indices);
    const bool is_inch = reader_.units().inch && state_->is_length(axis);
    return state_->word_factor(axis) / (is_inch ? kMmPerInch : 1);
}

double ControlVariables::to_text_units(Quantity quantity, const Indices& indices,
                                       double value) const {
    if (is_of_axis(quantity)) {
        const std::int64_t axis = quantity == Quantity::WorkOffset ? indices.second : indices.first;
        return on_increment(value * text_factor(indices, axis), state_->is_length(axis));
    }
    if (quantity == Quantity::Feed)
        return value * text_scale(nc::Dimension::Feed, reader_.units(), true);
    if (is_of_tool_data(quantity))
        return on_increment(value * text_scale(nc::Dimension::Length, reader_.units(), true), true);
    return value;
}

/// Where words are rounded to the increment, the control keeps positions and offsets in increments.
double ControlVariables::on_increment(double value, bool is_length) const {
    if (!language_.rules.rounds_values) return value;
    const nc::Dimension dimension = is_length ? nc::Dimension::Length : nc::Dimension::Angle;
    const double power = std::round(1 / increment_size(tables_, dimension, reader_.units()));
    return std::round(value * power) / power + 0.0;
}

// ---------------------------------------------------------------- active codes

const nc::Form* ControlVariables::active_form(std::size_t group) const {
    const auto acts = [&](const nc::Form& form) {
        const nc::Group of = info(form.function).group;
        if (of == nc::Group::Once || form.function == nc::Function::Cycle) return false;
        nc::Function active = reader_.modal()[static_cast<std::size_t>(of)];
        if (of == nc::Group::Motion && active == nc::Function::None)
            active = dialect_.first_motion();
        return active == form.function;
    };
    const auto& defaults = tables_.groups[group].power_on;
    // A modal cycle is of its own group, or of the one whose default ends cycles.
    const bool is_of_cycles = std::ranges::find(defaults, nc::Function::CycleOff) != defaults.end();
    if (reader_.last_cycle() != nc::kNoForm &&
        reader_.modal()[static_cast<std::size_t>(nc::Group::CycleMode)] == nc::Function::Cycle) {
        const nc::Form& cycle = tables_.forms[reader_.last_cycle()];
        const bool is_here =
            cycle.group >= 0 ? cycle.group == static_cast<int>(group) : is_of_cycles;
        if (is_here) return &cycle;
    }
    const nc::FormId last = reader_.last_form(group);
    if (last != nc::kNoForm) {
        const nc::Form& form = tables_.forms[last];
        // Functions that act once, as frames do, are a group where one of them is the default.
        const bool is_kept = info(form.function).group == nc::Group::Once && !defaults.empty() &&
                             form.function != nc::Function::Cycle;
        if (form.function == nc::Function::None || is_kept || acts(form)) return &form;
    }
    for (const nc::Form& form : tables_.forms) {
        if (form.group != static_cast<int>(group) || !form.is_read || !acts(form)) continue;
        const bool is_first_offset =
            form.function != nc::Function::WorkOffset ||
            (!form.fixed.empty() && form.fixed[0].second == dialect_.first_work_offset());
        if (is_first_offset) return &form;
    }
    // Nothing of the group was said, and nothing acts by itself: what the file calls its default.
    for (const nc::Form& form : tables_.forms) {
        if (form.group != static_cast<int>(group) || !form.is_read) continue;
        const bool is_offset = form.function == nc::Function::WorkOffset && !form.fixed.empty() &&
                               form.fixed[0].second == dialect_.first_work_offset();
        const bool is_default = std::ranges::find(defaults, form.function) != defaults.end();
        if (is_offset || is_default) return &form;
    }
    return nullptr;
}

std::optional<double> ControlVariables::modal_code(std::int64_t number, bool by_place) const {
    const auto place = std::ranges::find_if(
        tables_.groups, [&](const auto& group) { return number_of(group.name) == number; });
    if (by_place) {
        const auto list = std::ranges::find_if(
            language_.code_lists, [&](const auto& of) { return number_of(of.group) == number; });
        if (list == language_.code_lists.end()) return std::nullopt;
        if (list->standard == 0 || place == tables_.groups.end())
            return static_cast<double>(list->standard);
        return code_in_list(*list, static_cast<std::size_t>(place - tables_.groups.begin()));
    }
    if (place == tables_.groups.end()) return std::nullopt;
    const auto group = static_cast<std::size_t>(place - tables_.groups.begin());
    const nc::Form* form = active_form(group);
    if (form == nullptr) {
        // Of codes on which nothing depends the first one acts before any was said.
        const auto first = std::ranges::find_if(tables_.forms, [&](const nc::Form& other) {
            return other.group == static_cast<int>(group) && other.is_read;
        });
        const bool is_passed =
            first != tables_.forms.end() && first->function == nc::Function::None;
        if (is_passed) form = &*first;
    }
    if (form == nullptr) return std::nullopt;
    return form->words[0].number;
}

/// The place of the code that acts; one that is no modal function of the vocabulary acts since it
/// was said.
std::optional<double> ControlVariables::code_in_list(const nc::CodeList& list,
                                                     std::size_t group) const {
    const nc::FormId last = reader_.last_form(group);
    const bool is_said =
        last != nc::kNoForm && info(tables_.forms[last].function).group == nc::Group::Once;
    const nc::Form* form = is_said ? &tables_.forms[last] : active_form(group);
    if (form == nullptr) return static_cast<double>(list.standard);
    const auto found = std::ranges::find(list.codes, form->words[0].text);
    if (found == list.codes.end()) return static_cast<double>(list.standard);
    return static_cast<double>(found - list.codes.begin() + 1);
}

// ---------------------------------------------------------------- names

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

template <typename Set>
void ControlVariables::change(Store& store, std::size_t slot, const nc::Symbol* symbol, Set set) {
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

void ControlVariables::set_argument(Level& level, std::uint32_t slot, const Value& value) {
    change(level.locals, slot, nullptr, [&] { level.locals.values[slot] = value; });
}

void ControlVariables::note_change(std::optional<ControlVariable> before, ControlVariable after) {
    if (changes_ == nullptr) return;
    if (!before) before = shown(after.name, {}, {});
    changes_->push_back({std::move(*before), std::move(after)});
}

// ---------------------------------------------------------------- write

ControlVariables::Fault ControlVariables::convert(nc::ValueType type, Value& value,
                                                  std::string_view text) {
    if (value.is_vacant()) return {};
    const bool is_own_kind = type == nc::ValueType::Axis || type == nc::ValueType::Frame;
    if (is_own_kind || value.kind == Value::Kind::Axis || value.is_frame()) {
        if (value.kind == Value::of(0, type).kind) return {};
        return {&diag::TypesDiffer, {std::string(type_name(type)), std::string(kind_name(value))}};
    }
    if (type == nc::ValueType::Text) {
        if (value.kind == Value::Kind::Real || value.kind == Value::Kind::Int)
            return {&diag::TypesDiffer, {"a text", "a number"}};
        return {};
    }
    if (value.is_text()) {
        if (type == nc::ValueType::Bool) {
            value = Value::of(text.empty() ? 0 : 1, type);
            return {};
        }
        if (type != nc::ValueType::Char || count_code_points(text) != 1)
            return {&diag::TypesDiffer, {std::string(type_name(type)), "a text"}};
        value = Value::of(first_code_point(text), type);
    }
    double number = value.number;
    const auto range_fault = [&] {
        std::string shown;
        append_shortest(shown, value.number);
        return Fault{&diag::ValueForType, {shown, std::string(type_name(type))}};
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
    value = Value::of(number, type);
    return {};
}

Quantity ControlVariables::quantity_of(std::uint32_t form, std::int64_t number) const {
    const VariableRange* range = find_range(language_.variables[form], number);
    const bool is_system = range != nullptr && range->kind == VariableRange::Kind::System;
    return is_system ? range->quantity : Quantity::None;
}

bool ControlVariables::must_wait(const Instruction& target,
                                 std::span<const std::int64_t> indices) const {
    if (in_step_) return false;
    if (target.kind == Instruction::Kind::System || target.kind == Instruction::Kind::SystemPart)
        return true;
    return target.kind == Instruction::Kind::Family &&
           quantity_of(target.index, indices[0]) != Quantity::None;
}

const nc::Symbol* declared_at(const Level& level, std::uint32_t slot) {
    const std::span<const nc::Symbol> all = level.symbols.all();
    const auto found = std::ranges::find_if(
        all, [&](const nc::Symbol& symbol) { return symbol.is_plain() && symbol.slot == slot; });
    return found == all.end() ? nullptr : &*found;
}

ControlVariables::Fault ControlVariables::store(const Instruction& target,
                                                std::span<const std::int64_t> indices,
                                                const Value& value, const Content& content) {
    const std::string_view text = content.text;
    Value converted = value;
    switch (target.kind) {
        case Instruction::Kind::Global:
        case Instruction::Kind::Local: {
            if (Fault fault = convert(target.type, converted, text); fault.row != nullptr)
                return fault;
            Store& store = target.kind == Instruction::Kind::Global ? globals_ : level_->locals;
            const nc::Symbol* symbol = &store == &globals_ || changes_ == nullptr
                                           ? nullptr
                                           : declared_at(*level_, target.index);
            change(store, target.index, symbol, [&] { store.values[target.index] = converted; });
            return {};
        }
        case Instruction::Kind::Family: return store_family(target.index, indices[0], value);
        case Instruction::Kind::Input: {
            const VariableRange& range = language_.variables[target.index].ranges[0];
            return store_input(target.index, range,
                               input_name(target.index, indices.first(target.count)), value, text);
        }
        case Instruction::Kind::System: {
            const auto quantity = static_cast<Quantity>(target.index);
            if (target.type == nc::ValueType::Frame) {
                if (content.frame == nullptr)
                    return {&diag::TypesDiffer, {"a frame", std::string(kind_name(value))}};
                return store_frame(quantity, indices[0], *content.frame);
            }
            if (target.type == nc::ValueType::Text)
                return store_text(quantity, indices[0], value, text);
            return store_system(quantity, {indices[0], indices[1]}, value);
        }
        case Instruction::Kind::SystemPart:
        case Instruction::Kind::ElementPart: return store_part(target, indices, value);
        case Instruction::Kind::Element: {
            const nc::Symbol& symbol = level_->symbols.at(target.index);
            const auto slot = Evaluator::element(symbol, indices);
            if (!slot) return {&diag::IndexWrong, {Evaluator::wrong_index(symbol, indices)}};
            if (target.count == symbol.dimensions)
                return store_element(symbol, *slot, value, content);
            // One character of a text; the code 0 cuts it there.
            const std::int64_t place = indices[symbol.dimensions];
            if (Fault fault = convert(nc::ValueType::Char, converted, text); fault.row != nullptr)
                return fault;
            Store& texts = *level_->stores[target.index];
            const Value& old = texts.values[*slot];
            std::string whole = old.is_text() ? texts.texts[old.text] : std::string();
            if (place < 0 || place >= symbol.text_size)
                return {&diag::IndexWrong, {'`' + symbol.name + '`'}};
            const auto at = static_cast<std::size_t>(place);
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
        case Instruction::Kind::Number:
        case Instruction::Kind::Vacant:
        case Instruction::Kind::Text:
        case Instruction::Kind::Operate: break;
    }
    return {&diag::VariableReadOnly, {"this constant"}};
}

/// Programs keep the limits of what is defined for all of them.
ControlVariables::Fault ControlVariables::check_limits(const nc::Symbol& symbol,
                                                       const Value& value) const {
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

ControlVariables::Fault ControlVariables::store_element(const nc::Symbol& symbol,
                                                        std::uint32_t slot, const Value& value,
                                                        const Content& content) {
    const std::string_view text = content.text;
    Value converted = value;
    if (Fault fault = convert(symbol.type, converted, text); fault.row != nullptr) return fault;
    if (Fault fault = check_limits(symbol, converted); fault.row != nullptr) return fault;
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

ControlVariables::Fault ControlVariables::store_family(std::uint32_t form, std::int64_t number,
                                                       const Value& value) {
    const nc::VariableForm& family = language_.variables[form];
    const VariableRange* range = find_range(family, number);
    const std::string name = name_of(family, number);
    if (range == nullptr) return {&diag::VariableNumber, {name}};
    if (!value.is_number()) return {&diag::TypesDiffer, {name, std::string(kind_name(value))}};
    const auto slot = static_cast<std::size_t>(range->slot + (number - range->first));
    Value converted = value;
    switch (range->kind) {
        case VariableRange::Kind::Global:
        case VariableRange::Kind::Local: {
            if (Fault fault = convert(range->type, converted, {}); fault.row != nullptr)
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
    return store_system(range->quantity, indices_of(*range, number), value);
}

ControlVariables::Fault ControlVariables::store_system(Quantity quantity, const Indices& indices,
                                                       const Value& value) {
    if (info(quantity).access == nc::QuantityInfo::Access::Read)
        return {&diag::VariableReadOnly, {std::string(info(quantity).name)}};
    const std::string name(info(quantity).name);
    if (state_ == nullptr) return {&diag::IsoNotSupported, {name}};
    const bool is_axis = quantity == Quantity::CarrierAxis && value.kind == Value::Kind::Axis;
    if (!value.is_number() && !is_axis)
        return {&diag::TypesDiffer, {name, std::string(kind_name(value))}};
    if (quantity == Quantity::CarrierAxis && !is_axis && value.number != 0)
        return {&diag::TypesDiffer, {name, std::string(kind_name(value))}};
    double number = value.number;
    if (quantity == Quantity::WorkOffset) {
        number = on_increment(number, state_->is_length(indices.second)) /
                 text_factor(indices, indices.second);
    }
    if (is_of_tool_data(quantity)) {
        number =
            on_increment(number, true) / text_scale(nc::Dimension::Length, reader_.units(), true);
    }
    switch (state_->set_quantity(quantity, indices.first, indices.second, number,
                                 language_.rules.offsets_act_at_once)) {
        case ControlAccess::Write::Done: return {};
        case ControlAccess::Write::NoPlace:
            if (quantity == Quantity::EdgeSpeed) return {&diag::ToothFeedNoTool, {}};
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

ControlVariables::Fault ControlVariables::store_frame(Quantity quantity, std::int64_t number,
                                                      const control::ControlFrame& frame) {
    const std::string name(info(quantity).name);
    if (info(quantity).access == nc::QuantityInfo::Access::Read)
        return {&diag::VariableReadOnly, {name}};
    if (state_ == nullptr) return {&diag::IsoNotSupported, {name}};
    switch (state_->set_frame(quantity, number, frame, language_.rules.offsets_act_at_once)) {
        case ControlAccess::Write::Done: return {};
        case ControlAccess::Write::NoPlace: return {&diag::VariableNumber, {"of this offset"}};
        case ControlAccess::Write::TooLarge:
        case ControlAccess::Write::Refused: break;
    }
    return {&diag::IsoNotSupported, {name}};
}

/// A component: the frame is read, changed and written again. The axis is the last index.
ControlVariables::Fault ControlVariables::store_part(const Instruction& target,
                                                     std::span<const std::int64_t> indices,
                                                     const Value& value) {
    if (!value.is_number())
        return {&diag::TypesDiffer, {"a component of a frame", std::string(kind_name(value))}};
    const auto axis = static_cast<Axis>(-indices[target.count - 1u] - 1);
    const nc::FramePart part = target.part();
    const bool is_way = part == nc::FramePart::Shift || part == nc::FramePart::Fine;
    const double wanted = is_way ? value.number * axis_unit(axis) : value.number;
    const auto set = [&](control::ControlFrame& frame) -> Fault {
        if (set_part(frame, part, axis, wanted)) return {};
        if (part == nc::FramePart::Scale && wanted == 0) return {&diag::ScaleInvalid, {"0"}};
        return {&diag::IsoNotSupported, {"such a component of this frame"}};
    };
    if (target.kind == Instruction::Kind::SystemPart) {
        const auto quantity = static_cast<Quantity>(target.index);
        const std::int64_t number = target.count > 1 ? indices[0] : 0;
        control::ControlFrame whole;
        if (frame(quantity, number, whole) != Answer::Value)
            return {&diag::VariableNumber, {"of this offset"}};
        if (Fault fault = set(whole); fault.row != nullptr) return fault;
        return store_frame(quantity, number, whole);
    }
    const nc::Symbol& symbol = level_->symbols.at(target.index);
    const auto slot = Evaluator::element(symbol, indices);
    if (!slot) return {&diag::IndexWrong, {Evaluator::wrong_index(symbol, indices)}};
    Store& store = *level_->stores[target.index];
    const Value& old = store.values[*slot];
    control::ControlFrame whole = old.is_frame() ? store.frames[old.text] : control::ControlFrame();
    if (Fault fault = set(whole); fault.row != nullptr) return fault;
    change(store, *slot, &symbol, [&] { store.set_frame(*slot, whole); });
    return {};
}

bool ControlVariables::load(const Instruction& from, std::span<const std::int64_t> indices,
                            Value& out) {
    switch (from.kind) {
        case Instruction::Kind::Global: out = globals_.values[from.index]; return true;
        case Instruction::Kind::Local: out = level_->locals.values[from.index]; return true;
        case Instruction::Kind::Family: return family(from.index, indices[0], out) == Answer::Value;
        case Instruction::Kind::Element: {
            const auto slot = Evaluator::element(level_->symbols.at(from.index), indices);
            if (slot) out = level_->stores[from.index]->values[*slot];
            return slot.has_value();
        }
        default: return false;
    }
}

// ---------------------------------------------------------------- the list

void ControlVariables::list_family(const nc::VariableForm& form,
                                   std::vector<ControlVariable>& out) const {
    for (const VariableRange& range : form.ranges) {
        const bool is_global = range.kind == VariableRange::Kind::Global;
        if (!is_global && range.kind != VariableRange::Kind::Local) continue;
        const Store& store = is_global ? globals_ : level_->locals;
        for (std::int64_t number = range.first; number <= range.last; ++number) {
            const auto slot = static_cast<std::size_t>(range.slot + (number - range.first));
            const Value& value = store.values[slot];
            const bool is_untouched = range.has_initial && value.number == range.value;
            if (value.is_vacant() || is_untouched) continue;
            out.push_back(shown(name_of(form, number), value, {}));
        }
    }
}

std::vector<ControlVariable> ControlVariables::list() const {
    std::vector<ControlVariable> out;
    for (std::uint32_t i = 0; i < language_.variables.size(); ++i) {
        list_family(language_.variables[i], out);
        list_inputs(i, out);
    }
    for (const nc::Symbol& symbol : level_->symbols.all()) {
        const Store& store = *level_->stores[level_->symbols.index_of(symbol)];
        for (std::uint32_t i = 0; i < symbol.count(); ++i) {
            ControlVariable variable = shown_in(store, symbol.slot + i, &symbol);
            // Of an array those are told that were set.
            const bool is_told = symbol.dimensions == 0
                                     ? variable.kind != ControlVariable::Kind::Vacant
                                     : !store.values[symbol.slot + i].is_vacant();
            if (is_told) out.push_back(std::move(variable));
        }
    }
    return out;
}

}  // namespace kadr::macro
