// What other rooms look up in a dialect: the control's alarms, the interpreter's rules, examples.
#include <algorithm>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "base/text.h"
#include "nc/load_parts.h"

namespace kadr::nc {

namespace {

/// A code as its number is: `G5.1` for `G05.1`. Other words as they are.
std::string normal_word(std::string_view word) {
    const char* const begin = word.data() + 1;
    const char* const end = word.data() + word.size();
    if (word.size() < 2) return std::string(word);
    const Decimal number = parse_decimal(begin, end);
    if (number.end != end) return std::string(word);
    std::string normal(word.substr(0, 1));
    append_shortest(normal, number.value);
    return normal;
}

/// A word as a line has it: in capital letters where both cases are one.
std::string as_read(const DialectTables& tables, std::string_view word) {
    return tables.notation.ignores_case ? upper_ascii(word) : std::string(word);
}

}  // namespace

std::string DialectTables::unsupported_words(std::string_view word) const {
    auto found = unsupported.find(normal_word(word));
    // `$MC_*`: every name that begins so.
    for (std::size_t front = word.rfind('_'); found == unsupported.end() && front < word.size();
         front = front == 0 ? word.npos : word.rfind('_', front - 1))
        found = unsupported.find(std::string(word.substr(0, front + 1)) + '*');
    if (found == unsupported.end()) return {};
    return std::string("`").append(word).append("` (").append(found->second).append(")");
}

bool DialectTables::is_passed(std::string_view word) const {
    const auto first = passed.lower_bound(word);
    if (first == passed.end() || !first->first.starts_with(word)) return false;
    const std::string_view rest = std::string_view(first->first).substr(word.size());
    return rest.empty() || rest[0] == '(' || rest[0] == '=';
}

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
    AlarmText alarm;
    Attributes::read_text(element, "number", alarm.number);
    Attributes::read_text(element, "text", alarm.text);
    if (alarm.number.empty() && alarm.text.empty())
        return attributes.bad_value(name, "the control's `number` or its `text` is expected");
    if (const XmlAttribute* about = element.find("about")) {
        tables.alarms_about.push_back({name.value, about->value, std::move(alarm)});
        return;
    }
    tables.alarms.insert_or_assign(name.value, std::move(alarm));
}

/// `<rule name="arc_tolerance" value="0.01"/>`
void load_rule(const XmlElement& element, DialectTables& tables, Attributes& attributes) {
    const XmlAttribute& name = needed(element, "name");
    const XmlAttribute& value = needed(element, "value");
    const std::optional<Rule> rule = rule_named(name.value);
    if (!rule) {
        Names names;
        for (const RuleInfo& each : all_rules()) names.push_back(each.name);
        attributes.fail();
        auto message = attributes.sink().report(diag::RuleUnknown, name.value_range);
        message.arg(name.value);
        if (const auto near = nearest_name(name.value, names.data(), names.size()))
            message.fix(name.value_range, std::string(*near), "is this meant?");
        return;
    }
    tables.named_rules.add(*rule);
    if (set_rule(tables.rules, *rule, value.value)) return;
    attributes.fail();
    attributes.sink()
        .report(diag::RuleInvalid, value.value_range)
        .arg(name.value)
        .arg(value.value)
        .fix("it takes: " + std::string(all_rules()[static_cast<std::size_t>(*rule)].values));
}

void load_unsupported(const XmlElement& element, DialectTables& tables) {
    const std::string& meaning = needed(element, "meaning").value;
    for (const XmlWord& word : words_of(needed(element, "words")))
        tables.unsupported.insert_or_assign(normal_word(as_read(tables, word.text)), meaning);
}

void load_foreign(const XmlElement& element, DialectTables& tables) {
    const std::string& instead = needed(element, "instead").value;
    const XmlAttribute* const during = element.find("during");
    const std::string where = during == nullptr ? "" : '@' + during->value;
    for (const XmlWord& word : words_of(needed(element, "words")))
        tables.foreign.insert_or_assign(as_read(tables, word.text) + where, instead);
}

/// `words` are addresses; `beside` are commands, and addresses with any number. Kept by both names:
/// `P@spindle_cw`.
static void load_passed_beside(const XmlElement& element, const XmlAttribute& beside,
                               const PassedWord& passed, DialectTables& tables,
                               Attributes& attributes) {
    for (const XmlWord& word : words_of(needed(element, "words"))) {
        if (tables.find_address(word.text) == kNoAddress)
            attributes.bad_word(word, "words", "it is not declared as an address");
        for (const XmlWord& other : words_of(beside)) {
            const bool is_address = tables.find_address(other.text) != kNoAddress;
            if (is_address || attributes.function_named(other))
                tables.passed.insert_or_assign(word.text + '@' + other.text, passed);
        }
    }
}

void load_passed(const XmlElement& element, DialectTables& tables, Attributes& attributes) {
    PassedWord passed;
    passed.meaning = needed(element, "meaning").value;
    attributes.read_flag(element, "warns", passed.is_given);
    attributes.read_flag(element, "rest", passed.takes_rest);
    attributes.read_number(element, "read_max", passed.read_max);
    attributes.read_number(element, "least", passed.least);
    attributes.read_number(element, "most", passed.most);
    if (const XmlAttribute* beside = element.find("beside"))
        return load_passed_beside(element, *beside, passed, tables, attributes);
    for (const XmlWord& word : words_of(needed(element, "words"))) {
        const std::string name = as_read(tables, word.text);
        tables.passed.insert_or_assign(name, passed);
        tables.unsupported.erase(name);
    }
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
    Attributes::read_text(element, "gives", example.gives);
    example.text = needed(element, "text").value;
    example.source_range = place("source");
    example.text_range = place("text");
    example.block_range = place("block");
    example.gives_range = place("gives");
    tables.examples.push_back(std::move(example));
}

}  // namespace kadr::nc
