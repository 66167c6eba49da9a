#include "nc/language.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"

namespace kadr::nc {

namespace {

constexpr OperationInfo kOperations[] = {
#define KADR_OPERATION(id, name, least, most, meaning) {name, least, most, meaning},
#include "nc/language.def"
#undef KADR_OPERATION
};

constexpr StatementInfo kStatements[] = {
#define KADR_STATEMENT(id, name, meaning) {name, meaning},
#include "nc/language.def"
#undef KADR_STATEMENT
};

constexpr QuantityInfo kQuantities[] = {
#define KADR_QUANTITY(id, name, indices, access, meaning) \
    {name, indices, QuantityInfo::Access::access, meaning},
#include "nc/language.def"
#undef KADR_QUANTITY
};

constexpr FramePartInfo kFrameParts[] = {
#define KADR_FRAME_PART(id, name, meaning) {name, meaning},
#include "nc/language.def"
#undef KADR_FRAME_PART
};

constexpr LanguageRuleInfo kRules[] = {
#define KADR_LANGUAGE_RULE(type, field, standard, values, meaning, source) \
    {#field, values, meaning, source},
#include "nc/language.def"
#undef KADR_LANGUAGE_RULE
};

bool read(std::string_view text, double& value) {
    const Decimal number = parse_decimal(text.data(), text.data() + text.size());
    if (text.empty() || number.end != text.data() + text.size()) return false;
    value = number.value;
    return true;
}

bool read(std::string_view text, int& value) {
    double number = 0;
    if (!read(text, number) || number != std::floor(number) || std::abs(number) > 1e9) return false;
    value = static_cast<int>(number);
    return true;
}

bool read(std::string_view text, bool& value) {
    if (text != "yes" && text != "no") return false;
    value = text == "yes";
    return true;
}

}  // namespace

const OperationInfo& info(Operation operation) {
    return kOperations[static_cast<std::size_t>(operation)];
}
std::span<const OperationInfo> all_operations() { return kOperations; }
const StatementInfo& info(Statement statement) {
    return kStatements[static_cast<std::size_t>(statement)];
}
std::span<const StatementInfo> all_statements() { return kStatements; }
const QuantityInfo& info(SystemQuantity quantity) {
    return kQuantities[static_cast<std::size_t>(quantity)];
}
std::span<const QuantityInfo> all_quantities() { return kQuantities; }
std::span<const FramePartInfo> all_frame_parts() { return kFrameParts; }
std::span<const LanguageRuleInfo> all_language_rules() { return kRules; }

bool set_language_rule(LanguageRules& rules, std::string_view name, std::string_view value) {
#define KADR_LANGUAGE_RULE(type, field, standard, values, meaning, source) \
    if (name == #field) return read(value, rules.field);
#include "nc/language.def"
#undef KADR_LANGUAGE_RULE
    return false;
}

const VariableRange* range_of_slot(const Language& language, std::uint32_t slot) {
    for (const VariableForm& form : language.variables) {
        for (const VariableRange& range : form.ranges) {
            const bool is_store = form.is_family && range.kind == VariableRange::Kind::Global;
            const auto index = static_cast<std::int64_t>(slot) - range.slot;
            if (is_store && index >= 0 && index <= range.last - range.first) return &range;
        }
    }
    return nullptr;
}

const VariableRange* find_range(const VariableForm& family, std::int64_t number) {
    const auto found = std::ranges::find_if(family.ranges, [&](const VariableRange& range) {
        return number >= range.first && number <= range.last;
    });
    if (found == family.ranges.end()) return nullptr;
    // What is declared as nothing at all takes numbers away from a file that is extended.
    const bool is_absent =
        found->kind == VariableRange::Kind::Unsupported && found->meaning.empty();
    return is_absent ? nullptr : &*found;
}

}  // namespace kadr::nc
