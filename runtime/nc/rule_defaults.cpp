#include "nc/rule_defaults.h"

#include <string>
#include <unordered_map>

#include "base/assert.h"

namespace kadr::nc {

namespace {

/// The word of a dialect file for a value in C++: `true` is yes, `ArcError::ShiftCenter` is
/// shift_center, a number is itself.
std::string file_word(std::string_view code) {
    if (code == "true") return "yes";
    if (code == "false") return "no";
    const std::size_t scope = code.rfind("::");
    if (scope == std::string_view::npos) return std::string(code);
    std::string word;
    for (const char c : code.substr(scope + 2)) {
        const bool is_capital = c >= 'A' && c <= 'Z';
        if (is_capital && !word.empty()) word += '_';
        word += is_capital ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return word;
}

using Defaults = std::unordered_map<std::string_view, std::string>;

const Defaults& defaults() {
    static const Defaults table = {
#define KADR_RULE(type, field, standard, values, meaning, source) {#field, file_word(#standard)},
#include "nc/rules.def"
#undef KADR_RULE
    };
    return table;
}

}  // namespace

std::string_view rule_default(std::string_view name) {
    const auto found = defaults().find(name);
    KADR_ASSERT(found != defaults().end(), "no rule has this name");
    return found->second;
}

}  // namespace kadr::nc
