#include "nc/load.h"

#include <algorithm>
#include <bitset>
#include <charconv>
#include <set>

#include "base/numbers.h"
#include "base/text.h"
#include "nc/form.h"

namespace kadr::nc {

namespace {

using Names = std::vector<std::string_view>;

std::vector<std::string> split(std::string_view text) {
    std::vector<std::string> words;
    std::size_t at = 0;
    while ((at = text.find_first_not_of(" \t\r\n", at)) != std::string_view::npos) {
        const std::size_t end = std::min(text.find_first_of(" \t\r\n", at), text.size());
        words.emplace_back(text.substr(at, end - at));
        at = end;
    }
    return words;
}

constexpr std::array<std::string_view, kSlots> kSlotNames = {
    "X", "Y",        "Z",        "A",        "B",      "C",     "U",    "V",
    "W", "center_x", "center_y", "center_z", "radius", "turns", "feed", "speed"};
constexpr std::array<Dimension, kSlots> kSlotDimensions = {
    Dimension::Length, Dimension::Length, Dimension::Length, Dimension::Angle,
    Dimension::Angle,  Dimension::Angle,  Dimension::Length, Dimension::Length,
    Dimension::Length, Dimension::Length, Dimension::Length, Dimension::Length,
    Dimension::Length, Dimension::Count,  Dimension::Feed,   Dimension::Speed};

/// Applies the elements of one file, one after the other.
class FileLoader {
  public:
    FileLoader(DialectTables& tables, DiagnosticSink& sink) : tables_(tables), sink_(sink) {}

    bool load(const XmlElement& root) {
        if (!check_shape(root, sink_)) return false;
        tables_.examples.clear();  // those of the files it extends are run with them
        // What patterns build upon comes first, wherever it stands in the file.
        for (const XmlElement& e : root.children) {
            if (e.name == "doc") tables_.doc = e.text;
            if (e.name == "remove") load_remove(e);
            if (e.name == "comment") load_comment(e);
            if (e.name == "rules") load_rules(e);
            if (e.name == "address") load_address(e);
            if (e.name == "program") load_program(e);
            if (e.name == "blocks") load_blocks(e);
        }
        for (const XmlElement& e : root.children) {
            if (e.name == "number") load_number(e);
            if (e.name == "group") load_group(e);
            if (e.name == "command") load_command(e);
            if (e.name == "cycle") load_cycle(e);
            if (e.name == "deferred") load_deferred(e);
            if (e.name == "alarm") load_alarm(e);
            if (e.name == "rule") load_rule(e);
            if (e.name == "example") load_example(e);
        }
        return !failed_;
    }

  private:
    // ------------------------------------------------------------ attributes

    std::string_view required(const XmlElement& e, std::string_view name) {
        const XmlAttribute* attribute = e.find(name);
        if (attribute != nullptr) return attribute->value;
        failed_ = true;
        sink_.report(diag::DialectMissingAttribute, e.range).arg(e.name).arg(name);
        return {};
    }

    void bad_value(const XmlAttribute& attribute, std::string_view why) {
        failed_ = true;
        sink_.report(diag::DialectBadValue, attribute.range)
            .arg(attribute.value)
            .arg(attribute.name)
            .arg(why);
    }

    void bad_name(const XmlAttribute& attribute, std::string_view value, const Names& names,
                  std::string_view why) {
        failed_ = true;
        auto report = std::move(sink_.report(diag::DialectBadValue, attribute.range)
                                    .arg(value)
                                    .arg(attribute.name)
                                    .arg(why));
        if (const auto near = nearest_name(value, names.data(), names.size())) {
            report.fix("is `" + std::string(*near) + "` meant?");
        }
    }

    template <typename T>
    void read_number(const XmlElement& e, std::string_view name, T& out) {
        const XmlAttribute* attribute = e.find(name);
        if (attribute == nullptr) return;
        const std::string& text = attribute->value;
        T value{};
        const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
        if (result.ec != std::errc() || result.ptr != text.data() + text.size() || value < T{0}) {
            return bad_value(*attribute, "a number is expected");
        }
        out = value;
    }

    void read_bool(const XmlElement& e, std::string_view name, bool& out) {
        read_choice(e, name, {"no", "yes"}, [&](std::size_t i) { out = i == 1; });
    }

    template <typename Take>
    void read_choice(const XmlElement& e, std::string_view name, const Names& choices, Take take) {
        const XmlAttribute* attribute = e.find(name);
        if (attribute == nullptr) return;
        const auto found = std::find(choices.begin(), choices.end(), attribute->value);
        if (found != choices.end()) return take(static_cast<std::size_t>(found - choices.begin()));
        std::string why = "one of";
        for (const std::string_view choice : choices) why += " `" + std::string(choice) + "`";
        bad_name(*attribute, attribute->value, choices, why + " is expected");
    }

    static void read_text(const XmlElement& e, std::string_view name, std::string& out) {
        if (const XmlAttribute* attribute = e.find(name)) out = attribute->value;
    }

    std::optional<Function> function_named(const XmlAttribute& attribute, std::string_view name) {
        if (name == "none") return Function::None;  // accepted, without effect
        if (const auto function = find_function(name)) return function;
        Names names;
        for (const FunctionInfo& row : all_functions()) names.push_back(row.name);
        failed_ = true;
        auto report =
            std::move(sink_.report(diag::DialectUnknownFunction, attribute.range).arg(name));
        if (const auto near = nearest_name(name, names.data(), names.size())) {
            report.fix("is `" + std::string(*near) + "` meant?");
        }
        return std::nullopt;
    }

    void read_functions(const XmlElement& e, std::string_view name, std::vector<Function>& out) {
        const XmlAttribute* attribute = e.find(name);
        if (attribute == nullptr) return;
        out.clear();
        for (const std::string& word : split(attribute->value)) {
            if (const auto function = function_named(*attribute, word)) out.push_back(*function);
        }
    }

    // ------------------------------------------------------------ frame, comments, rules

    void load_program(const XmlElement& e) {
        ProgramFrame& frame = tables_.program;
        frame.header.clear();
        frame.start.clear();
        frame.finish.clear();
        frame.end.clear();
        frame.skipped.clear();
        read_number(e, "name_length", frame.name_length);
        read_number(e, "least_number", frame.least_number);
        read_number(e, "most_number", frame.most_number);
        read_choice(e, "name_letters", {"any", "two"},
                    [&](std::size_t i) { frame.name_needs_two_letters = i == 1; });
        for (const XmlElement& line : e.children) {
            if (line.name == "header") frame.header.push_back(line.text);
            if (line.name == "start") frame.start.push_back(line.text);
            if (line.name == "finish") frame.finish.push_back(line.text);
            if (line.name == "end") frame.end.push_back(line.text);
            if (line.name == "skipped") frame.skipped.push_back(line.text);
        }
    }

    void load_blocks(const XmlElement& e) {
        read_choice(e, "numbers", {"off", "on"},
                    [&](std::size_t i) { tables_.block_numbers.is_on = i == 1; });
        read_number(e, "start", tables_.block_numbers.start);
        read_number(e, "step", tables_.block_numbers.step);
        read_number(e, "most", tables_.block_numbers.most);
    }

    void load_comment(const XmlElement& e) {
        CommentStyle& style = tables_.comment;
        style.open = required(e, "open");
        style.close.clear();
        read_text(e, "close", style.close);
        style.is_upper = false;
        style.is_ascii = false;
        read_choice(e, "case", {"any", "upper"}, [&](std::size_t i) { style.is_upper = i == 1; });
        read_choice(e, "charset", {"utf8", "ascii"},
                    [&](std::size_t i) { style.is_ascii = i == 1; });
        read_number(e, "max_length", style.max_length);
        style.replacements.clear();
        for (const XmlElement& replace : e.children) {
            const std::string_view character = required(replace, "character");
            if (character.size() == 1) {
                style.replacements.emplace_back(character[0], std::string(required(replace, "by")));
            } else if (const XmlAttribute* attribute = replace.find("character")) {
                bad_value(*attribute, "one ASCII character is expected");
            }
        }
    }

    void load_rules(const XmlElement& e) {
        Rules& rules = tables_.rules;
        const auto repeated = [&](std::string_view name, Repeated& out) {
            read_choice(e, name, {"alarm", "last"}, [&](std::size_t i) {
                out = i == 1 ? Repeated::LastWins : Repeated::Alarm;
            });
        };
        repeated("repeated_address", rules.address);
        repeated("repeated_group", rules.group);
        read_choice(e, "case", {"upper", "any"},
                    [&](std::size_t i) { rules.ignores_case = i == 1; });
        read_bool(e, "assignment", rules.has_assignment);
        read_bool(e, "modes", rules.has_modes);
        read_bool(e, "blanks_inside_words", rules.blanks_inside_words);
        read_number(e, "skip_levels", rules.skip_levels);
        read_number(e, "default_skip", rules.default_skip);
        read_number(e, "read_line", rules.max_line);
        read_number(e, "write_line", rules.write_line);
        read_choice(e, "line_end", {"lf", "crlf"}, [&](std::size_t i) { rules.crlf = i == 1; });
    }

    // ------------------------------------------------------------ addresses and numbers

    Address& address_named(std::string_view name) {
        const AddressId known = tables_.find_address(name);
        if (known != kNoAddress) return tables_.addresses[known];
        const auto id = static_cast<AddressId>(tables_.addresses.size());
        tables_.names.emplace(std::string(name), id);
        if (name.size() == 1) tables_.letters[static_cast<unsigned char>(name[0]) & 127u] = id;
        Address& address = tables_.addresses.emplace_back();
        address.name = name;
        return address;
    }

    void load_address(const XmlElement& e) {
        const std::string_view name = required(e, "name");
        if (name.empty()) return;
        Address& address = address_named(name);
        read_choice(e, "kind", {"value", "code", "block_number"}, [&](std::size_t i) {
            address.kind = i == 1 ? Address::Kind::Code : Address::Kind::Value;
            address.is_block_number = i == 2;
        });
        if (address.kind == Address::Kind::Code && e.find("read_max") == nullptr) {
            address.write_max = address.read_max = 255;
        }
        read_choice(e, "slot", Names(kSlotNames.begin(), kSlotNames.end()), [&](std::size_t i) {
            address.slot = static_cast<int>(i);
            address.dimension = kSlotDimensions[i];
        });
        if (const XmlAttribute* attribute = e.find("dimension")) {
            if (const auto dimension = find_dimension(attribute->value)) {
                address.dimension = *dimension;
            } else {
                bad_value(*attribute, "a dimension of the vocabulary is expected");
            }
        }
        read_number(e, "order", address.order);
        read_number(e, "write_max", address.write_max);
        read_number(e, "read_max", address.read_max);
        read_text(e, "doc", address.doc);
    }

    void load_number(const XmlElement& e) {
        (void)required(e, "addresses");
        const XmlAttribute* attribute = e.find("addresses");
        if (attribute == nullptr) return;
        for (const std::string& name : split(attribute->value)) {
            const AddressId id = name == "()" ? call_address() : tables_.find_address(name);
            if (id == kNoAddress) {
                bad_value(*attribute, "`" + name + "` is not declared as an address");
                continue;
            }
            NumberFormat& format = tables_.addresses[id].format;
            read_number(e, "decimals", format.decimals);
            read_number(e, "inch_decimals", format.inch_decimals);
            read_choice(e, "point", {"needed", "always", "never"},
                        [&](std::size_t i) { format.point = static_cast<PointRule>(i); });
            read_number(e, "digits", format.digits);
            read_number(e, "max_digits", format.max_digits);
            read_number(e, "increment", format.increment);
            read_number(e, "inch_increment", format.inch_increment);
            read_number(e, "revolution_increment", format.revolution_increment);
            read_bool(e, "truncates", format.truncates);
            read_bool(e, "minus", format.allows_minus);
            if (format.decimals > 9 || format.inch_decimals > 9)
                bad_value(*attribute, "at most 9 decimals");
        }
    }

    /// The number format of arguments in parentheses is kept at an address that no text can name.
    AddressId call_address() {
        (void)address_named("()");
        return tables_.find_address("()");
    }

    void load_remove(const XmlElement& e) {
        if (const XmlAttribute* attribute = e.find("commands")) {
            for (const std::string& word : split(attribute->value)) {
                if (const auto function = function_named(*attribute, word))
                    clear_forms(*function, 0);
            }
        }
        if (const XmlAttribute* attribute = e.find("cycles")) {
            for (const std::string& word : split(attribute->value)) {
                if (const auto id = cycle_named(word)) clear_forms(Function::Cycle, *id);
            }
        }
        if (const XmlAttribute* attribute = e.find("addresses")) {
            for (const std::string& word : split(attribute->value))
                remove_address(*attribute, word);
        }
    }

    void remove_address(const XmlAttribute& attribute, const std::string& name) {
        const AddressId id = tables_.find_address(name);
        if (id == kNoAddress)
            return bad_value(attribute, "`" + name + "` is not declared as an address");
        tables_.names.erase(name);
        if (name.size() == 1) tables_.letters[static_cast<unsigned char>(name[0])] = kNoAddress;
        tables_.addresses[id].slot = -1;
        tables_.addresses[id].name.clear();
    }

    // ------------------------------------------------------------ functions

    int group_named(std::string_view name) {
        for (std::size_t i = 0; i < tables_.groups.size(); ++i) {
            if (tables_.groups[i].name == name) return static_cast<int>(i);
        }
        tables_.groups.push_back({std::string(name), {}});
        return static_cast<int>(tables_.groups.size() - 1);
    }

    void clear_forms(Function function, CycleId cycle) {
        std::erase_if(tables_.forms, [&](const Form& form) {
            return form.function == function &&
                   (function != Function::Cycle || form.cycle == cycle);
        });
    }

    /// What a file says about a function replaces what the files it extends said.
    void begin_function(Function function) {
        const auto index = static_cast<std::size_t>(function);
        if (seen_[index]) return;
        seen_[index] = true;
        clear_forms(function, 0);
    }

    void add_forms(const Form& prototype, std::string_view text) {
        std::vector<Form> forms = parse_form(prototype, text, tables_, sink_);
        if (forms.empty()) failed_ = true;
        if (tables_.forms.size() + forms.size() >= kNoForm) {
            failed_ = true;
            sink_.report(diag::DialectBadForm, prototype.range)
                .arg(text)
                .arg("there are too many forms");
            return;
        }
        for (Form& form : forms) tables_.forms.push_back(std::move(form));
    }

    void read_form_attributes(const XmlElement& e, Form& form) {
        form.range = e.range;
        read_functions(e, "sets", form.sets);
        read_functions(e, "needs", form.needs);
        read_functions(e, "before", form.before);
        read_functions(e, "during", form.during);
        read_functions(e, "outside", form.outside);
        read_functions(e, "first", form.first);
        read_choice(e, "use", {"both", "write", "read"}, [&](std::size_t i) {
            form.is_read = i != 1;
            form.is_written = i != 2;
        });
        read_choice(e, "feed", {"scaled", "metric", "every_block", "every_block_by_radius"},
                    [&](std::size_t i) {
                        form.feed_stays_metric = i == 1;
                        form.feed_every_block = i >= 2;
                        form.feed_by_radius = i == 3;
                    });
        read_bool(e, "own_block", form.owns_block);
        read_bool(e, "remembers", form.remembers);
        read_bool(e, "keeps_length", form.keeps_length);
        read_text(e, "note", form.note);
        if (const XmlAttribute* attribute = e.find("lead")) {
            if (!parse_form_line(attribute->value, tables_.parameters(form), tables_,
                                 attribute->range, form.lead, sink_))
                failed_ = true;
        }
        if (const XmlAttribute* attribute = e.find("implied")) read_implied(*attribute, form);
        if (const XmlAttribute* attribute = e.find("when")) read_constraints(*attribute, form);
    }

    /// Parameters that the control takes from the position at which it starts.
    void read_implied(const XmlAttribute& attribute, Form& form) {
        const std::span<const Parameter> parameters = tables_.parameters(form);
        for (const std::string& word : split(attribute.value)) {
            const auto found = std::find_if(parameters.begin(), parameters.end(),
                                            [&](const Parameter& p) { return p.name == word; });
            if (found == parameters.end())
                return bad_value(attribute, "there is no such parameter");
            form.implied.push_back(static_cast<int>(found - parameters.begin()));
        }
    }

    /// `number 1..6` or several of them, separated by `;`
    void read_constraints(const XmlAttribute& attribute, Form& form) {
        const std::span<const Parameter> parameters = tables_.parameters(form);
        const std::vector<std::string> words = split(attribute.value);
        for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
            Constraint constraint{-1, 0, 0};
            for (std::size_t p = 0; p < parameters.size(); ++p) {
                if (parameters[p].name == words[i]) constraint.parameter = static_cast<int>(p);
            }
            std::string_view range = words[i + 1];
            if (range.ends_with(';')) range.remove_suffix(1);
            if (!read_range(range, constraint)) constraint.parameter = -1;
            if (constraint.parameter < 0)
                return bad_value(attribute, "`parameter 1..6` is expected");
            form.when.push_back(constraint);
        }
        if (words.empty() || words.size() % 2 != 0)
            bad_value(attribute, "`parameter 1..6` is expected");
    }

    /// `1..6` or `0`, whole numbers.
    static bool read_range(std::string_view text, Constraint& out) {
        const char* const end = text.data() + text.size();
        int least = 0;
        const auto first = std::from_chars(text.data(), end, least);
        out.least = out.most = least;
        if (first.ec != std::errc() || first.ptr == end) return first.ec == std::errc();
        if (end - first.ptr < 3 || first.ptr[0] != '.' || first.ptr[1] != '.') return false;
        int most = 0;
        const auto second = std::from_chars(first.ptr + 2, end, most);
        out.most = most;
        return second.ec == std::errc() && second.ptr == end && least <= most;
    }

    void load_group(const XmlElement& e) {
        const int group = group_named(required(e, "name"));
        if (e.find("default") != nullptr) {
            read_functions(e, "default", tables_.groups[static_cast<std::size_t>(group)].power_on);
        }
        for (const XmlElement& code : e.children) {
            const XmlAttribute* attribute = code.find("function");
            const std::string_view name = required(code, "function");
            const std::string_view text = required(code, "text");
            if (attribute == nullptr || text.empty()) continue;
            const auto function = function_named(*attribute, name);
            if (!function) continue;
            begin_function(*function);
            Form form;
            form.function = *function;
            form.group = group;
            read_form_attributes(code, form);
            read_text(code, "doc", form.doc);
            add_forms(form, text);
            load_examples(code);
        }
    }

    void load_command(const XmlElement& e) {
        const std::string_view name = required(e, "name");
        const XmlAttribute* attribute = e.find("name");
        if (attribute == nullptr) return;
        const auto function = function_named(*attribute, name);
        if (!function) return;
        begin_function(*function);
        Form prototype;
        prototype.function = *function;
        if (const XmlAttribute* group = e.find("group"))
            prototype.group = group_named(group->value);
        read_text(e, "doc", prototype.doc);
        load_forms(e, prototype);
    }

    void load_forms(const XmlElement& e, const Form& prototype) {
        for (const XmlElement& child : e.children) {
            if (child.name != "form") continue;
            Form form = prototype;
            read_form_attributes(child, form);
            add_forms(form, child.text);
        }
        load_examples(e);
    }

    std::optional<CycleId> cycle_named(std::string_view name) const {
        for (std::size_t i = 0; i < tables_.cycles.size(); ++i) {
            if (tables_.cycles[i].name == name) return static_cast<CycleId>(i);
        }
        return std::nullopt;
    }

    void load_cycle(const XmlElement& e) {
        const std::string_view name = required(e, "name");
        if (name.empty()) return;
        auto id = cycle_named(name);
        const XmlAttribute* parameters = e.find("parameters");
        if (parameters != nullptr && !tables_.extends.empty()) {
            return bad_value(*parameters, "cycles are declared in the common core only");
        }
        if (!id && parameters == nullptr) {
            Names names;
            for (const CycleInfo& cycle : tables_.cycles) names.push_back(cycle.name);
            return bad_name(*e.find("name"), name, names, "the common core declares no such cycle");
        }
        if (!id) id = declare_cycle(name, *parameters);
        read_text(e, "meaning", tables_.cycles[*id].meaning);
        if (!seen_cycles_.contains(*id)) clear_forms(Function::Cycle, *id);
        seen_cycles_.insert(*id);
        Form prototype;
        prototype.function = Function::Cycle;
        prototype.cycle = *id;
        read_text(e, "doc", prototype.doc);
        load_forms(e, prototype);
    }

    /// `to:length retract:length initial?:length`; the names stay in the tables.
    CycleId declare_cycle(std::string_view name, const XmlAttribute& attribute) {
        CycleInfo cycle;
        cycle.name = name;
        for (const std::string& word : split(attribute.value)) {
            const std::size_t colon = word.find(':');
            const auto dimension = find_dimension(colon == std::string::npos
                                                      ? std::string_view()
                                                      : std::string_view(word).substr(colon + 1));
            if (!dimension) {
                bad_value(attribute, "`name:dimension` is expected");
                continue;
            }
            std::string text = word.substr(0, colon);
            const bool is_optional = text.ends_with('?');
            if (is_optional) text.pop_back();
            tables_.texts.push_back(std::move(text));
            cycle.parameters.push_back({tables_.texts.back(), *dimension, is_optional});
        }
        tables_.cycles.push_back(std::move(cycle));
        return static_cast<CycleId>(tables_.cycles.size() - 1);
    }

    void load_deferred(const XmlElement& e) {
        if (!seen_deferred_) tables_.deferred.clear();
        seen_deferred_ = true;
        Deferred deferred;
        deferred.pattern = e.text;
        read_choice(e, "axis", Names(kSlotNames.begin(), kSlotNames.begin() + kAxes),
                    [&](std::size_t i) { deferred.axis = static_cast<int>(i); });
        read_functions(e, "functions", deferred.functions);
        const auto parameters = info(Function::Tool).parameters;
        if (!parse_form_line(e.text, parameters, tables_, e.range, deferred.words, sink_))
            failed_ = true;
        tables_.deferred.push_back(std::move(deferred));
    }

    void load_alarm(const XmlElement& e) {
        const std::string_view name = required(e, "for");
        const XmlAttribute* attribute = e.find("for");
        const std::string_view number = required(e, "number");
        if (attribute == nullptr) return;
        const auto rows = all_diagnostics();
        const auto found = std::find_if(
            rows.begin(), rows.end(), [&](const DiagnosticRow* row) { return row->name == name; });
        if (found == rows.end()) {
            Names names;
            for (const DiagnosticRow* row : rows) names.push_back(row->name);
            return bad_name(*attribute, name, names, "there is no such diagnostic");
        }
        AlarmText alarm{std::string(number), {}};
        read_text(e, "text", alarm.text);
        tables_.alarms.insert_or_assign(std::string(name), std::move(alarm));
    }

    /// Which rules there are is the interpreter's matter; it checks them.
    void load_rule(const XmlElement& e) {
        RuleSetting setting{std::string(required(e, "name")), std::string(required(e, "value")),
                            e.range};
        std::erase_if(tables_.rule_settings,
                      [&](const RuleSetting& r) { return r.name == setting.name; });
        tables_.rule_settings.push_back(std::move(setting));
    }

    void load_examples(const XmlElement& e) {
        for (const XmlElement& child : e.children) {
            if (child.name == "example") load_example(child);
        }
    }

    void load_example(const XmlElement& e) {
        Example example;
        example.range = e.range;
        read_text(e, "source", example.source);
        read_text(e, "block", example.block);
        read_text(e, "meaning", example.meaning);
        example.text = required(e, "text");
        tables_.examples.push_back(std::move(example));
    }

    DialectTables& tables_;
    DiagnosticSink& sink_;
    bool failed_ = false;
    std::bitset<kFunctions> seen_;
    std::set<CycleId> seen_cycles_;
    bool seen_deferred_ = false;
};

}  // namespace

bool apply_dialect(const XmlElement& root, DialectTables& tables, DiagnosticSink& sink) {
    return FileLoader(tables, sink).load(root);
}

}  // namespace kadr::nc
