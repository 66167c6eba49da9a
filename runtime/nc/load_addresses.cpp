// The heads of words: which letters and names there are, and how their numbers look.
#include <array>

#include "base/diagnostics/dialect.h"
#include "base/done.h"
#include "nc/load_parts.h"

namespace kadr::nc {

std::span<const SlotInfo> slot_infos() {
    static constexpr std::array<SlotInfo, kSlots> kInfos = {{
        {"X", Dimension::Length},          {"Y", Dimension::Length},
        {"Z", Dimension::Length},          {"A", Dimension::Angle},
        {"B", Dimension::Angle},           {"C", Dimension::Angle},
        {"U", Dimension::Length},          {"V", Dimension::Length},
        {"W", Dimension::Length},          {"center_x", Dimension::Length},
        {"center_y", Dimension::Length},   {"center_z", Dimension::Length},
        {"radius", Dimension::Length},     {"turns", Dimension::Count},
        {"feed", Dimension::Feed},         {"speed", Dimension::Speed},
        {"polar_angle", Dimension::Angle}, {"polar_radius", Dimension::Length},
        {"opening", Dimension::Angle},     {"through_x", Dimension::Length},
        {"through_y", Dimension::Length},  {"through_z", Dimension::Length},
    }};
    return kInfos;
}

namespace {

/// The number format of arguments in parentheses is kept at an address that no text can name.
constexpr std::string_view kCallAddress = "()";

Address& address_named(DialectTables& tables, std::string_view name) {
    const AddressId known = tables.find_address(name);
    if (known != kNoAddress) return tables.addresses[known];
    const auto id = static_cast<AddressId>(tables.addresses.size());
    tables.names.emplace(std::string(name), id);
    if (name.size() == 1) tables.letters[static_cast<unsigned char>(name[0]) & 127u] = id;
    Address& address = tables.addresses.emplace_back();
    address.name = name;
    return address;
}

void read_format(const XmlElement& element, NumberFormat& format, Attributes& attributes) {
    attributes.read_number(element, "decimals", format.decimals);
    attributes.read_number(element, "inch_decimals", format.inch_decimals);
    attributes.read_number(element, "lead_decimals", format.lead_decimals);
    attributes.read_number(element, "inch_lead_decimals", format.inch_lead_decimals);
    attributes.read_number(element, "frame_decimals", format.frame_decimals);
    if (const auto point = attributes.choice(element, "point", {"needed", "always", "never"})) {
        format.point = static_cast<PointRule>(*point);
    }
    attributes.read_number(element, "digits", format.digits);
    attributes.read_number(element, "max_digits", format.max_digits);
    attributes.read_number(element, "increment", format.increment);
    attributes.read_number(element, "inch_increment", format.inch_increment);
    attributes.read_number(element, "revolution_increment", format.revolution_increment);
    attributes.read_flag(element, "truncates", format.truncates);
    attributes.read_flag(element, "minus", format.allows_minus);
    attributes.read_flag(element, "plus", format.writes_plus);
}

/// No more decimals than the writer's scaled integers hold.
Done check_decimals(const XmlElement& element, const NumberFormat& format, Attributes& attributes) {
    constexpr int kMost = 9;
    const std::pair<const char*, int> all[] = {
        {"decimals", format.decimals},
        {"inch_decimals", format.inch_decimals},
        {"lead_decimals", format.lead_decimals},
        {"inch_lead_decimals", format.inch_lead_decimals},
        {"frame_decimals", format.frame_decimals},
    };
    for (const auto& [name, decimals] : all) {
        if (decimals <= kMost) continue;
        attributes.bad_value(needed(element, name), "at most 9 decimals");
        return kFailed;
    }
    return kDone;
}

void remove_address(const XmlWord& word, DialectTables& tables, Attributes& attributes) {
    const AddressId id = tables.find_address(word.text);
    if (id == kNoAddress) {
        return attributes.bad_word(word, "addresses", "it is not declared as an address");
    }
    tables.names.erase(word.text);
    if (word.text.size() == 1) {
        tables.letters[static_cast<unsigned char>(word.text[0])] = kNoAddress;
    }
    tables.addresses[id].slot = -1;
    tables.addresses[id].name.clear();
}

}  // namespace

void load_address(const XmlElement& element, DialectTables& tables, Attributes& attributes) {
    Address& address = address_named(tables, needed(element, "name").value);
    if (const auto kind = attributes.choice(element, "kind", {"value", "code", "block_number"})) {
        address.kind = *kind == 1 ? Address::Kind::Code : Address::Kind::Value;
        address.is_block_number = *kind == 2;
    }
    if (address.kind == Address::Kind::Code && element.find("read_max") == nullptr) {
        address.write_max = address.read_max = 255;
    }
    Names slots;
    for (const SlotInfo& slot : slot_infos()) slots.push_back(slot.name);
    slots.push_back("none");
    if (const auto slot = attributes.choice(element, "slot", slots)) {
        const bool is_none = *slot == slot_infos().size();
        address.slot = is_none ? -1 : static_cast<int>(*slot);
        if (!is_none) address.dimension = slot_infos()[*slot].dimension;
    }
    if (const XmlAttribute* attribute = element.find("dimension")) {
        if (const auto dimension = find_dimension(attribute->value)) {
            address.dimension = *dimension;
        } else {
            attributes.bad_value(*attribute, "a dimension of the vocabulary is expected");
        }
    }
    attributes.read_flag(element, "incremental", address.is_incremental);
    attributes.read_flag(element, "coordinate", address.is_coordinate);
    attributes.read_number(element, "order", address.order);
    attributes.read_number(element, "write_max", address.write_max);
    attributes.read_number(element, "read_max", address.read_max);
    Attributes::read_text(element, "doc", address.doc);
}

/// `<number commands="dwell" decimals="2"/>`: of the words in the forms that stand above it.
static void load_number_of_commands(const XmlElement& element, const XmlAttribute& commands,
                                    DialectTables& tables, Attributes& attributes) {
    DiagnosticList unheard;
    Attributes silent(unheard);
    for (const XmlWord& word : words_of(commands)) {
        const auto function = attributes.function_named(word);
        if (!function) continue;
        bool has_word = false;
        const auto set = [&](FormWord& each) {
            if (each.kind != FormWord::Kind::Value || each.address == kNoAddress) return;
            if (!each.format) each.format = tables.addresses[each.address].format;
            read_format(element, *each.format, silent);
            has_word = true;
        };
        for (Form& form : tables.forms) {
            if (form.function != *function) continue;
            for (FormWord& each : form.words) {
                set(each);
                for (FormWord& argument : each.arguments) set(argument);
            }
            for (std::vector<FormWord>& line : form.extra)
                for (FormWord& each : line) set(each);
        }
        if (!has_word)
            attributes.bad_word(word, "commands", "no form above this line has a number of it");
    }
}

void load_number(const XmlElement& element, DialectTables& tables, Attributes& attributes) {
    // A wrong value is reported once, not for every address.
    NumberFormat checked;
    read_format(element, checked, attributes);
    if (!check_decimals(element, checked, attributes)) return;
    DiagnosticList unheard;
    Attributes silent(unheard);
    const XmlAttribute* const addresses = element.find("addresses");
    const XmlAttribute* const commands = element.find("commands");
    if ((addresses == nullptr) == (commands == nullptr)) {
        attributes.fail();
        attributes.sink()
            .report(diag::DialectBadForm, element.range)
            .arg("number")
            .arg("it is said of `addresses` or of `commands`");
        return;
    }
    if (commands != nullptr) return load_number_of_commands(element, *commands, tables, attributes);
    for (const XmlWord& word : words_of(*addresses)) {
        if (word.text == kCallAddress) (void)address_named(tables, kCallAddress);  // adds it
        const AddressId id = tables.find_address(word.text);
        if (id == kNoAddress) {
            attributes.bad_word(word, "addresses", "it is not declared as an address");
        } else {
            read_format(element, tables.addresses[id].format, silent);
        }
    }
}

void load_remove(const XmlElement& element, DialectTables& tables, Attributes& attributes) {
    if (const XmlAttribute* commands = element.find("commands")) {
        for (const XmlWord& word : words_of(*commands)) {
            if (const auto function = attributes.function_named(word)) {
                clear_forms(tables, *function, 0);
            }
        }
    }
    bool clears_deferred = false;
    attributes.read_flag(element, "deferred", clears_deferred);
    if (clears_deferred) tables.deferred.clear();
    if (const XmlAttribute* cycles = element.find("cycles")) {
        for (const XmlWord& word : words_of(*cycles)) {
            if (const auto id = cycle_named(tables, word.text)) {
                clear_forms(tables, Function::Cycle, *id);
            } else {
                Names names;
                for (const CycleInfo& cycle : tables.cycles) names.push_back(cycle.name);
                attributes.bad_name(word, "cycles", names, "there is no such cycle");
            }
        }
    }
    if (const XmlAttribute* addresses = element.find("addresses")) {
        for (const XmlWord& word : words_of(*addresses)) {
            remove_address(word, tables, attributes);
        }
    }
}

}  // namespace kadr::nc
