#include "nc/load_attributes.h"

#include <algorithm>

#include "base/assert.h"
#include "base/diagnostics/dialect.h"
#include "base/text.h"

namespace kadr::nc {

const XmlAttribute& needed(const XmlElement& element, std::string_view name) {
    const XmlAttribute* attribute = element.find(name);
    KADR_ASSERT(attribute != nullptr, "the shape of the file was checked");
    return *attribute;
}

void Attributes::bad_word(const XmlWord& word, std::string_view attribute, std::string_view why) {
    failed_ = true;
    sink_.report(diag::DialectBadValue, word.range)
        .arg(shown_value(word.text))
        .arg(attribute)
        .arg(why);
}

void Attributes::bad_value(const XmlAttribute& attribute, std::string_view why) {
    bad_word({attribute.value, attribute.value_range}, attribute.name, why);
}

void Attributes::bad_name(const XmlWord& word, std::string_view attribute, const Names& names,
                          std::string_view why) {
    failed_ = true;
    auto message = sink_.report(diag::DialectBadValue, word.range);
    message.arg(shown_value(word.text)).arg(attribute).arg(why);
    if (const auto near = nearest_name(word.text, names.data(), names.size())) {
        message.fix(word.range, std::string(*near), "is this meant?");
    }
}

void Attributes::read_flag(const XmlElement& element, std::string_view name, bool& out) {
    if (const auto found = choice(element, name, {"no", "yes"})) out = *found == 1;
}

std::optional<std::size_t> Attributes::choice(const XmlElement& element, std::string_view name,
                                              const Names& choices) {
    const XmlAttribute* attribute = element.find(name);
    if (attribute == nullptr) return std::nullopt;
    const auto found = std::ranges::find(choices, attribute->value);
    if (found != choices.end()) return static_cast<std::size_t>(found - choices.begin());
    std::string why = "one of";
    for (const std::string_view one : choices) why += " `" + std::string(one) + "`";
    bad_name({attribute->value, attribute->value_range}, name, choices, why + " is expected");
    return std::nullopt;
}

bool read_range(std::string_view text, Constraint& out) {
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

void Attributes::read_text(const XmlElement& element, std::string_view name, std::string& out) {
    if (const XmlAttribute* attribute = element.find(name)) out = attribute->value;
}

std::optional<Function> Attributes::function_named(const XmlWord& word) {
    if (word.text == "none") return Function::None;
    if (const auto function = find_function(word.text)) return function;
    failed_ = true;
    Names names;
    for (const FunctionInfo& row : all_functions()) names.push_back(row.name);
    auto message = sink_.report(diag::DialectUnknownFunction, word.range);
    message.arg(shown_value(word.text));
    if (const auto near = nearest_name(word.text, names.data(), names.size())) {
        message.fix(word.range, std::string(*near), "is this meant?");
    }
    return std::nullopt;
}

void Attributes::read_functions(const XmlElement& element, std::string_view name,
                                std::vector<Function>& out) {
    const XmlAttribute* attribute = element.find(name);
    if (attribute == nullptr) return;
    out.clear();
    for (const XmlWord& word : words_of(*attribute)) {
        if (const auto function = function_named(word)) out.push_back(*function);
    }
}

}  // namespace kadr::nc
