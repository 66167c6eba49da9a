// The spellings of functions and cycles: groups of codes, commands, cycles, deferred words.
#include <algorithm>
#include <charconv>
#include <filesystem>

#include "base/diagnostics/dialect.h"
#include "base/numbers.h"
#include "nc/form.h"
#include "nc/load_parts.h"

namespace kadr::nc {

/// They are marked, and dropped all together: each move of the forms behind them would cost as much
/// as reading the file.
void clear_forms(DialectTables& tables, Function function, CycleId cycle) {
    for (Form& form : tables.forms) {
        const bool is_meant = form.function == function;
        if (is_meant && (function != Function::Cycle || form.cycle == cycle))
            form.is_read = form.is_written = false;
    }
}

namespace {

/// Whether the words need an address that was removed: one without a name (`load_remove`).
bool has_removed_address(const DialectTables& tables, const std::vector<FormWord>& words) {
    return std::ranges::any_of(words, [&](const FormWord& word) {
        const bool is_removed =
            word.address != kNoAddress && tables.addresses[word.address].name.empty();
        return is_removed || has_removed_address(tables, word.arguments);
    });
}

bool has_removed_address(const DialectTables& tables, const Form& form) {
    return has_removed_address(tables, form.words) || has_removed_address(tables, form.lead) ||
           std::ranges::any_of(form.extra, [&](const std::vector<FormWord>& line) {
               return has_removed_address(tables, line);
           });
}

}  // namespace

void drop_cleared_forms(DialectTables& tables) {
    std::erase_if(tables.forms, [&](const Form& form) {
        return (!form.is_read && !form.is_written) || has_removed_address(tables, form);
    });
    std::erase_if(tables.deferred, [&](const Deferred& deferred) {
        return has_removed_address(tables, deferred.words);
    });
}

std::optional<CycleId> cycle_named(const DialectTables& tables, std::string_view name) {
    for (std::size_t i = 0; i < tables.cycles.size(); ++i) {
        if (tables.cycles[i].name == name) return static_cast<CycleId>(i);
    }
    return std::nullopt;
}

// ---------------------------------------------------------------- groups and commands

int FormLoader::group_named(std::string_view name) {
    for (std::size_t i = 0; i < tables_.groups.size(); ++i) {
        if (tables_.groups[i].name == name) return static_cast<int>(i);
    }
    tables_.groups.push_back({std::string(name), {}});
    return static_cast<int>(tables_.groups.size() - 1);
}

void FormLoader::begin_function(Function function) {
    const auto index = static_cast<std::size_t>(function);
    if (seen_[index]) return;
    seen_[index] = true;
    clear_forms(tables_, function, 0);
}

void FormLoader::load_group(const XmlElement& element) {
    const int group = group_named(needed(element, "name").value);
    std::vector<Function>& power_on = tables_.groups[static_cast<std::size_t>(group)].power_on;
    attributes_.read_functions(element, "default", power_on);
    check_default(element, "default");
    std::vector<Function> of_lathe;
    attributes_.read_functions(element, "lathe", of_lathe);
    check_default(element, "lathe");
    if (attributes_.kind() == MachineKind::Lathe && !of_lathe.empty())
        power_on = std::move(of_lathe);
    attributes_.read_flag(element, "together",
                          tables_.groups[static_cast<std::size_t>(group)].stands_together);
    for (const XmlElement& code : element.children) load_code(code, group);
}

/// What a group begins with is a name alone: a command that needs a parameter would do nothing.
void FormLoader::check_default(const XmlElement& element, std::string_view name) {
    const XmlAttribute* attribute = element.find(name);
    if (attribute == nullptr) return;
    for (const XmlWord& word : words_of(*attribute)) {
        const std::optional<Function> function = find_function(word.text);
        if (!function) continue;
        const std::span<const Parameter> parameters = info(*function).parameters;
        const auto needed_one = std::ranges::find(parameters, false, &Parameter::is_optional);
        if (needed_one == parameters.end()) continue;
        attributes_.fail();
        attributes_.sink()
            .report(diag::DialectDefaultParameter, word.range)
            .arg(word.text)
            .arg(needed_one->name);
    }
}

void FormLoader::load_code(const XmlElement& element, int group) {
    const XmlAttribute& name = needed(element, "command");
    const XmlAttribute& text = needed(element, "text");
    const auto function = attributes_.function_named({name.value, name.value_range});
    if (!function) return;
    begin_function(*function);
    Form form;
    form.function = *function;
    form.group = group;
    form.range = text.value_range;
    read_form_attributes(element, form);
    Attributes::read_text(element, "doc", form.doc);
    add_forms(form, text.value);
    load_examples(element);
}

void FormLoader::load_command(const XmlElement& element) {
    const XmlAttribute& name = needed(element, "name");
    const auto function = attributes_.function_named({name.value, name.value_range});
    if (!function) return;
    begin_function(*function);
    Form prototype;
    prototype.function = *function;
    if (const XmlAttribute* group = element.find("group")) {
        prototype.group = group_named(group->value);
    }
    Attributes::read_text(element, "doc", prototype.doc);
    load_forms(element, prototype);
}

void FormLoader::load_forms(const XmlElement& element, const Form& prototype) {
    for (const XmlElement& child : element.children) {
        if (child.name != "form") continue;
        Form form = prototype;
        form.range = child.text.empty() ? child.range : child.text_range;
        read_form_attributes(child, form);
        add_forms(form, child.text);
    }
    load_examples(element);
}

void FormLoader::load_examples(const XmlElement& element) {
    for (const XmlElement& child : element.children) {
        if (child.name == "example") load_example(child, tables_);
    }
}

void FormLoader::add_forms(const Form& prototype, std::string_view text) {
    std::vector<Form> forms = parse_form(prototype, text, tables_, attributes_.sink());
    if (forms.empty()) attributes_.fail();
    if (tables_.forms.size() + forms.size() >= kNoForm) {
        attributes_.fail();
        attributes_.sink()
            .report(diag::DialectBadForm, prototype.range)
            .arg(text)
            .arg("there are too many forms");
        return;
    }
    for (Form& form : forms) tables_.forms.push_back(std::move(form));
}

// ---------------------------------------------------------------- attributes of a form

void FormLoader::read_form_attributes(const XmlElement& element, Form& form) {
    attributes_.read_functions(element, "sets", form.sets);
    attributes_.read_functions(element, "needs", form.needs);
    attributes_.read_functions(element, "before", form.before);
    attributes_.read_functions(element, "during", form.during);
    read_cycle_of_words(element, form);
    attributes_.read_functions(element, "outside", form.outside);
    attributes_.read_functions(element, "first", form.first);
    if (const auto use = attributes_.choice(element, "use", {"both", "write", "read"})) {
        form.is_read = *use != 1;
        form.is_written = *use != 2;
    }
    if (const auto feed = attributes_.choice(
            element, "feed",
            {"scaled", "metric", "every_block", "every_block_by_radius", "pitch", "seconds"})) {
        form.feed_stays_metric = *feed == 1;
        form.feed_every_block = *feed == 2 || *feed == 3;
        form.feed_by_radius = *feed == 3;
        form.feed_is_pitch = *feed == 4;
        form.feed_is_time = *feed == 5;
    }
    if (const auto own = attributes_.choice(element, "own_block", {"no", "yes", "axes", "line"})) {
        form.owns_block = *own == 1;
        form.owns_axes = *own == 2;
        form.owns_line = *own == 3;
    }
    attributes_.read_flag(element, "joins", form.joins);
    Attributes::read_text(element, "passed", form.passed);
    Attributes::read_text(element, "lost", form.lost);
    attributes_.read_flag(element, "only", form.owns_address);
    Attributes::read_text(element, "unsupported", form.unsupported);
    form.is_written &= form.unsupported.empty();
    attributes_.read_flag(element, "remembers", form.remembers);
    attributes_.read_flag(element, "preset", form.is_preset);
    attributes_.read_flag(element, "verbatim", form.is_verbatim);
    form.is_written &= !form.is_preset;
    attributes_.read_flag(element, "keeps_length", form.keeps_length);
    Attributes::read_text(element, "note", form.note);
    if (const XmlAttribute* attribute = element.find("names")) {
        for (const XmlWord& word : words_of(*attribute)) form.names.push_back(word.text);
    }
    if (const XmlAttribute* attribute = element.find("lead")) {
        if (!parse_form_line(attribute->value, tables_.parameters(form), tables_,
                             attribute->value_range, form.lead, attributes_.sink())) {
            attributes_.fail();
        }
    }
    if (const XmlAttribute* attribute = element.find("without")) {
        for (const XmlWord& word : words_of(*attribute)) {
            const AddressId id = tables_.find_address(word.text);
            if (id == kNoAddress)
                attributes_.bad_word(word, "without", "it is not declared as an address");
            form.without.push_back(id);
        }
    }
    if (const XmlAttribute* attribute = element.find("implied"))
        read_parameters(*attribute, form, form.implied);
    if (const XmlAttribute* attribute = element.find("drops"))
        read_parameters(*attribute, form, form.drops);
    read_spindle(element, form);
    if (const XmlAttribute* attribute = element.find("when")) read_constraints(*attribute, form);
}

namespace {

/// The index of the parameter with this name; -1 if there is none.
int parameter_named(std::span<const Parameter> parameters, std::string_view name) {
    const auto found = std::ranges::find(parameters, name, &Parameter::name);
    return found == parameters.end() ? -1 : static_cast<int>(found - parameters.begin());
}

Names names_of(std::span<const Parameter> parameters) {
    Names names;
    for (const Parameter& parameter : parameters) names.push_back(parameter.name);
    return names;
}

}  // namespace

/// Names of parameters.
void FormLoader::read_parameters(const XmlAttribute& attribute, const Form& form,
                                 std::vector<int>& out) {
    const std::span<const Parameter> parameters = tables_.parameters(form);
    for (const XmlWord& word : words_of(attribute)) {
        const int parameter = parameter_named(parameters, word.text);
        if (parameter < 0) {
            attributes_.bad_name(word, attribute.name, names_of(parameters),
                                 "there is no such parameter");
        } else {
            out.push_back(parameter);
        }
    }
}

/// How the spindle turns behind a cycle, and the parameter for how it should.
void FormLoader::read_spindle(const XmlElement& element, Form& form) {
    std::vector<Function> left;
    attributes_.read_functions(element, "leaves", left);
    if (!left.empty()) form.leaves = left[0];
    const XmlAttribute* attribute = element.find("spindle");
    if (attribute == nullptr) return;
    const std::span<const Parameter> parameters = tables_.parameters(form);
    form.spindle_parameter = parameter_named(parameters, attribute->value);
    if (form.spindle_parameter >= 0) return;
    attributes_.bad_name({attribute->value, attribute->value_range}, attribute->name,
                         names_of(parameters), "there is no such parameter");
}

/// `number 1..6` or several of them, separated by `;`
void FormLoader::read_constraints(const XmlAttribute& attribute, Form& form) {
    const std::span<const Parameter> parameters = tables_.parameters(form);
    const std::vector<XmlWord> words = words_of(attribute);
    if (words.empty() || words.size() % 2 != 0) {
        return attributes_.bad_value(attribute, "`parameter 1..6` is expected");
    }
    for (std::size_t i = 0; i < words.size(); i += 2) {
        Constraint constraint{parameter_named(parameters, words[i].text), 0, 0};
        if (constraint.parameter < 0) {
            return attributes_.bad_name(words[i], attribute.name, names_of(parameters),
                                        "there is no such parameter");
        }
        std::string_view range = words[i + 1].text;
        if (range.ends_with(';')) range.remove_suffix(1);
        if (!read_range(range, constraint)) {
            return attributes_.bad_word(words[i + 1], attribute.name,
                                        "a range like `1..6`, or one whole number, is expected");
        }
        form.when.push_back(constraint);
    }
}

// ---------------------------------------------------------------- cycles

void FormLoader::load_cycle(const XmlElement& element) {
    const auto id = cycle_of(element);
    if (!id) return;
    Attributes::read_text(element, "meaning", tables_.cycles[*id].meaning);
    Attributes::read_text(element, "module", tables_.cycles[*id].module);
    if (seen_cycles_.insert(*id).second) clear_forms(tables_, Function::Cycle, *id);
    attributes_.read_flag(element, "modal", tables_.cycles[*id].is_modal);
    attributes_.read_flag(element, "taps", tables_.cycles[*id].taps);
    read_roles(element, tables_.cycles[*id]);
    read_settings(element, tables_.cycles[*id]);
    if (const auto otherwise = attributes_.choice(element, "otherwise", {"error", "moves"})) {
        std::erase(tables_.cycles_else_moves, *id);
        if (*otherwise == 1) tables_.cycles_else_moves.push_back(*id);
    }
    Form prototype;
    prototype.function = Function::Cycle;
    prototype.cycle = *id;
    if (const XmlAttribute* group = element.find("group"))
        prototype.group = group_named(group->value);
    Attributes::read_text(element, "doc", prototype.doc);
    load_forms(element, prototype);
}

/// `cycle="thread_once"`: the words are those of this modal cycle and of no other.
void FormLoader::read_cycle_of_words(const XmlElement& element, Form& form) {
    const XmlAttribute* attribute = element.find("cycle");
    if (attribute == nullptr) return;
    form.of_cycle = cycle_named(tables_, attribute->value);
    if (!form.of_cycle) attributes_.bad_value(*attribute, "there is no such cycle");
}

/// Which parameters the words of modal cycles set.
void FormLoader::read_roles(const XmlElement& element, CycleInfo& cycle) {
    const auto read = [&](std::string_view role, std::string_view usual, int& parameter) {
        if (parameter < 0) parameter = parameter_named(cycle.parameters, usual);
        const XmlAttribute* attribute = element.find(role);
        if (attribute == nullptr) return;
        parameter = parameter_named(cycle.parameters, attribute->value);
        if (parameter >= 0) return;
        attributes_.bad_name({attribute->value, attribute->value_range}, attribute->name,
                             names_of(cycle.parameters), "there is no such parameter");
    };
    read("depth", "to", cycle.roles.depth);
    read("retract", "retract", cycle.roles.retract);
    read("stroke", "", cycle.roles.stroke);
    read("shift", "", cycle.roles.shift);
    read("dwell", "dwell", cycle.roles.dwell);
    cycle.roles.start = parameter_named(cycle.parameters, "start_at");
    cycle.roles.first_block = parameter_named(cycle.parameters, "first_block");
    cycle.roles.last_block = parameter_named(cycle.parameters, "last_block");
}

/// `step 2; escape 0.5`
void FormLoader::read_settings(const XmlElement& element, CycleInfo& cycle) {
    const XmlAttribute* attribute = element.find("settings");
    if (attribute == nullptr) return;
    cycle.settings.clear();
    const std::vector<XmlWord> words = words_of(*attribute);
    if (words.empty() || words.size() % 2 != 0) {
        return attributes_.bad_value(*attribute, "`parameter 0.5` is expected");
    }
    for (std::size_t i = 0; i < words.size(); i += 2) {
        const int parameter = parameter_named(cycle.parameters, words[i].text);
        if (parameter < 0) {
            return attributes_.bad_name(words[i], attribute->name, names_of(cycle.parameters),
                                        "there is no such parameter");
        }
        std::string_view number = words[i + 1].text;
        if (number.ends_with(';')) number.remove_suffix(1);
        const char* const end = number.data() + number.size();
        const Decimal value = parse_decimal(number.data(), end);
        if (number.empty() || value.end != end) {
            return attributes_.bad_word(words[i + 1], attribute->name, "a number is expected");
        }
        cycle.settings.push_back({parameter, value.value});
    }
}

/// The cycle that the element names; the common core declares it there.
std::optional<CycleId> FormLoader::cycle_of(const XmlElement& element) {
    const XmlAttribute& name = needed(element, "name");
    const XmlAttribute* parameters = element.find("parameters");
    const XmlAttribute* file = element.find("file");
    const XmlAttribute* curve = element.find("curve");
    const auto known = cycle_named(tables_, name.value);
    const bool is_core = tables_.extends.empty();
    const bool has_body = file != nullptr || curve != nullptr;
    if (parameters != nullptr && !is_core && (known || !has_body)) {
        attributes_.bad_value(*parameters,
                              known ? "this cycle is declared already"
                                    : "a cycle of the control's own needs its Kadr `file`, or the "
                                      "kind of `curve` that it moves along");
        return std::nullopt;
    }
    if (has_body && (known || is_core || parameters == nullptr)) {
        attributes_.bad_value(file != nullptr ? *file : *curve,
                              "only a cycle that is declared here, with `parameters`, has one");
        return std::nullopt;
    }
    if (file != nullptr && curve != nullptr) {
        attributes_.bad_value(*curve, "a cycle that is a curve has no `file`");
        return std::nullopt;
    }
    if (known) return known;
    if (parameters != nullptr) {
        const CycleId id = declare_cycle(name.value, *parameters);
        if (file != nullptr) read_cycle_file(*file, tables_.cycles[id]);
        if (curve != nullptr) {
            tables_.cycles[id].curve = curve->value;
            tables_.cycles[id].file_range = curve->value_range;
            tables_.cycles[id].is_modal = false;
        }
        return id;
    }
    Names names;
    for (const CycleInfo& cycle : tables_.cycles) names.push_back(cycle.name);
    attributes_.bad_name({name.value, name.value_range}, name.name, names,
                         "no cycle of this name is declared");
    return std::nullopt;
}

/// The Kadr file of a cycle lies beside the dialect that declares it.
void FormLoader::read_cycle_file(const XmlAttribute& file, CycleInfo& cycle) {
    const std::filesystem::path folder = std::filesystem::path(tables_.file).parent_path();
    cycle.file = (folder / file.value).string();
    cycle.file_range = file.value_range;
    if (!files_.is_file(cycle.file))
        attributes_.bad_value(file, "there is no such file beside the dialect");
}

/// `to:length retract:length initial?:length`; the names stay in the tables.
CycleId FormLoader::declare_cycle(std::string_view name, const XmlAttribute& parameters) {
    CycleInfo cycle;
    cycle.name = name;
    for (const XmlWord& word : words_of(parameters)) {
        const std::size_t colon = std::min(word.text.find(':'), word.text.size());
        std::string text = word.text.substr(0, colon);
        const auto dimension = find_dimension(
            std::string_view(word.text).substr(std::min(colon + 1, word.text.size())));
        if (!dimension) {
            attributes_.bad_word(word, parameters.name, "`name:dimension` is expected");
            continue;
        }
        const bool is_optional = text.ends_with('?');
        if (is_optional) text.pop_back();
        tables_.texts.push_back(std::move(text));
        cycle.parameters.push_back({tables_.texts.back(), *dimension, is_optional});
    }
    tables_.cycles.push_back(std::move(cycle));
    return static_cast<CycleId>(tables_.cycles.size() - 1);
}

// ---------------------------------------------------------------- deferred words

void FormLoader::load_deferred(const XmlElement& element) {
    if (!seen_deferred_) tables_.deferred.clear();
    seen_deferred_ = true;
    Deferred deferred;
    deferred.pattern = element.text;
    Names axes;
    for (const SlotInfo& slot : slot_infos().first(kAxes)) axes.push_back(slot.name);
    if (const auto axis = attributes_.choice(element, "axis", axes)) {
        deferred.axis = static_cast<int>(*axis);
    }
    attributes_.read_functions(element, "commands", deferred.functions);
    const SourceRange location = element.text.empty() ? element.range : element.text_range;
    if (!parse_form_line(element.text, info(Function::Tool).parameters, tables_, location,
                         deferred.words, attributes_.sink())) {
        attributes_.fail();
    }
    tables_.deferred.push_back(std::move(deferred));
}

}  // namespace kadr::nc
