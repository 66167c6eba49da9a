#include "nc/rules.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/numbers.h"

namespace kadr::nc {

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
bool read(std::string_view text, CompCorner& value) {
    return read(text, "arc", "intersection", "square", value);
}
bool read(std::string_view text, PolePassage& value) { return read(text, "alarm", "turn", value); }
bool read(std::string_view text, MissingEnd& value) {
    return read(text, "warning", "alarm", value);
}

constexpr RuleInfo kRules[] = {
#define KADR_RULE(type, field, standard, values, meaning, source) {#field, values, meaning, source},
#include "nc/rules.def"
#undef KADR_RULE
};

}  // namespace

std::span<const RuleInfo> all_rules() { return kRules; }

std::optional<Rule> rule_named(std::string_view name) {
    const auto* const found = std::ranges::find(kRules, name, &RuleInfo::name);
    if (found == std::end(kRules)) return std::nullopt;
    return static_cast<Rule>(found - std::begin(kRules));
}

bool set_rule(Rules& rules, Rule rule, std::string_view value) {
    switch (rule) {
#define KADR_RULE(type, field, standard, values, meaning, source) \
    case Rule::field:                                             \
        return read(value, rules.field);
#include "nc/rules.def"
#undef KADR_RULE
    }
    return false;
}

}  // namespace kadr::nc
