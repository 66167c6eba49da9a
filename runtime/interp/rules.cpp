#include "interp/rules.h"

#include <cmath>
#include <string>
#include <vector>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "base/text.h"

namespace kadr::interp {

namespace {

/// No rule is below zero: tolerances, counts and numbers of offsets.
bool read(std::string_view text, double& value) {
    const Decimal number = parse_decimal(text.data(), text.data() + text.size());
    if (text.empty() || number.end != text.data() + text.size() || number.value < 0) return false;
    value = number.value;
    return true;
}

bool read(std::string_view text, int& value) {
    double number = 0;
    if (!read(text, number) || number != std::floor(number) || std::abs(number) > 1e6) return false;
    value = static_cast<int>(number);
    return true;
}

/// One of three words.
template <typename T>
bool read(std::string_view text, std::string_view first, std::string_view second,
          std::string_view third, T& value) {
    if (text != first && text != second && text != third) return false;
    value = static_cast<T>(text == first ? 0 : text == second ? 1 : 2);
    return true;
}

/// One of two words.
template <typename T>
bool read(std::string_view text, std::string_view first, std::string_view second, T& value) {
    if (text != first && text != second) return false;
    value = static_cast<T>(text == second);
    return true;
}

bool read(std::string_view text, bool& value) { return read(text, "no", "yes", value); }
bool read(std::string_view text, ArcError& value) {
    return read(text, "spread", "shift_center", value);
}
bool read(std::string_view text, ArcWithoutChord& value) {
    return read(text, "alarm", "no_motion", value);
}
bool read(std::string_view text, ArcWithoutCenter& value) {
    return read(text, "alarm", "line", value);
}
bool read(std::string_view text, IncrementalFrame& value) {
    return read(text, "traversed", "distance", value);
}
bool read(std::string_view text, LengthAxis& value) { return read(text, "plane", "z", value); }
bool read(std::string_view text, CompStart& value) {
    return read(text, "normal", "extended", "around", value);
}
bool read(std::string_view text, CompFeed& value) {
    return read(text, "contour", "center", "inside", value);
}
bool read(std::string_view text, ToolSelectChanges& value) {
    return read(text, "no", "yes", "lathe", value);
}
bool read(std::string_view text, path::OutsideCorner& value) {
    return read(text, "arc", "intersection", "square", value);
}
bool read(std::string_view text, PolePassage& value) { return read(text, "alarm", "turn", value); }
bool read(std::string_view text, MissingEnd& value) {
    return read(text, "warning", "alarm", value);
}

constexpr RuleInfo kRules[] = {
#define KADR_RULE(type, field, standard, values, meaning, source) {#field, values, meaning, source},
#include "interp/rules.def"
#undef KADR_RULE
};

}  // namespace

std::span<const RuleInfo> all_rules() { return kRules; }

bool set_rule(Rules& rules, std::string_view name, std::string_view value) {
#define KADR_RULE(type, field, standard, values, meaning, source) \
    if (name == #field) return read(value, rules.field);
#include "interp/rules.def"
#undef KADR_RULE
    return false;
}

namespace {

/// Says why a rule could not be set.
void report(const nc::RuleSetting& setting, DiagnosticSink& sink) {
    std::vector<std::string_view> names;
    for (const RuleInfo& rule : kRules) {
        if (rule.name == setting.name) {
            sink.report(diag::RuleInvalid, setting.value_range)
                .arg(setting.name)
                .arg(setting.value)
                .fix("it takes: " + std::string(rule.values));
            return;
        }
        names.push_back(rule.name);
    }
    auto message = sink.report(diag::RuleUnknown, setting.range);
    message.arg(setting.name);
    if (const auto near = nearest_name(setting.name, names.data(), names.size())) {
        message.fix(setting.range, std::string(*near), "is this meant?");
    }
}

}  // namespace

Rules rules_of(const nc::Dialect& dialect, DiagnosticSink& sink) {
    Rules rules;
    for (const nc::RuleSetting& setting : dialect.rules()) {
        if (!set_rule(rules, setting.name, setting.value)) report(setting, sink);
    }
    return rules;
}

}  // namespace kadr::interp
