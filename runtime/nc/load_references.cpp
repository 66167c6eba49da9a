// What other rooms look up in a dialect: the control's alarms, the interpreter's rules, examples.
#include <algorithm>

#include "nc/load_parts.h"

namespace kadr::nc {

void load_alarm(const XmlElement& element, DialectTables& tables, Attributes& attributes) {
    const XmlAttribute& name = needed(element, "for");
    const auto rows = all_diagnostics();
    const bool is_known = std::ranges::any_of(
        rows, [&](const DiagnosticRow* row) { return row->name == name.value; });
    if (!is_known) {
        Names names;
        for (const DiagnosticRow* row : rows) names.push_back(row->name);
        return attributes.bad_name({name.value, name.value_range}, name.name, names,
                                   "there is no such diagnostic");
    }
    AlarmText alarm{needed(element, "number").value, {}};
    Attributes::read_text(element, "text", alarm.text);
    tables.alarms.insert_or_assign(name.value, std::move(alarm));
}

/// Which rules there are is the interpreter's matter; it checks them.
void load_rule(const XmlElement& element, DialectTables& tables) {
    const XmlAttribute& name = needed(element, "name");
    const XmlAttribute& value = needed(element, "value");
    std::erase_if(tables.rule_settings,
                  [&](const RuleSetting& rule) { return rule.name == name.value; });
    tables.rule_settings.push_back({name.value, value.value, name.value_range, value.value_range});
}

void load_example(const XmlElement& element, DialectTables& tables) {
    const auto place = [&](std::string_view name) {
        const XmlAttribute* attribute = element.find(name);
        return attribute == nullptr ? element.range : attribute->value_range;
    };
    Example example;
    Attributes::read_text(element, "source", example.source);
    Attributes::read_text(element, "block", example.block);
    Attributes::read_text(element, "meaning", example.meaning);
    example.text = needed(element, "text").value;
    example.source_range = place("source");
    example.text_range = place("text");
    example.block_range = place("block");
    tables.examples.push_back(std::move(example));
}

}  // namespace kadr::nc
