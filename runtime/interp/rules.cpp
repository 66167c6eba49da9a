#include "interp/rules.h"

#include <cmath>

#include "base/numbers.h"

namespace kadr::interp {

namespace {

bool read(std::string_view text, double& value) {
    const Decimal number = parse_decimal(text.data(), text.data() + text.size());
    if (text.empty() || number.end != text.data() + text.size()) return false;
    value = number.value;
    return true;
}

bool read(std::string_view text, int& value) {
    double number = 0;
    if (!read(text, number) || number != std::floor(number) || std::abs(number) > 1e6) return false;
    value = static_cast<int>(number);
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

Rules rules_of(const nc::Dialect& dialect, DiagnosticSink& sink) {
    Rules rules;
    for (const nc::RuleSetting& setting : dialect.rules()) {
        if (set_rule(rules, setting.name, setting.value)) continue;
        sink.report(diag::RuleInvalid, setting.range).arg(setting.name).arg(setting.value);
    }
    return rules;
}

}  // namespace kadr::interp
