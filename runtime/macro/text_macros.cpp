#include "macro/text_macros.h"

#include <algorithm>

#include "nc/control_words.h"
#include "nc/letters.h"

namespace kadr::macro {

using nc::is_letter;

namespace {

/// Between the word and its text.
constexpr std::string_view kAs = "AS";

bool is_in_name(char c) { return is_letter(c) || (c >= '0' && c <= '9'); }

std::size_t end_of_name(std::string_view line, std::size_t begin) {
    std::size_t end = begin;
    while (end < line.size() && is_in_name(line[end])) ++end;
    return end;
}

}  // namespace

TextMacros::Fault TextMacros::define(const nc::DialectTables& tables, std::string_view definition) {
    const nc::ControlWords words(tables, definition);
    const std::size_t name_end = end_of_name(definition, 0);
    if (name_end < 2 || !is_letter(definition[0])) return Fault::Form;
    const std::size_t as = words.skip_blanks(name_end);
    const std::size_t as_end = end_of_name(definition, as);
    if (!words.is_same(definition.substr(as, as_end - as), kAs)) return Fault::Form;
    const std::size_t text = words.skip_blanks(as_end);
    if (text >= definition.size()) return Fault::Form;
    Macro macro{words.normal(definition.substr(0, name_end)), std::string(definition.substr(text))};
    const auto known = std::ranges::find(macros_, macro.name, &Macro::name);
    if (known != macros_.end()) return known->text == macro.text ? Fault::None : Fault::Known;
    if (expanded(tables, macro.text)) return Fault::Nested;
    macros_.push_back(std::move(macro));
    return Fault::None;
}

std::optional<ReplacedText> TextMacros::expanded(const nc::DialectTables& tables,
                                                 std::string_view line) const {
    const nc::ControlWords words(tables, line);
    std::optional<ReplacedText> out;
    std::size_t copied = 0;
    for (std::size_t at = 0; at < line.size() && !words.is_comment(at);) {
        if (line[at] == '"') {
            at = std::min(line.find('"', at + 1), line.size() - 1) + 1;
            continue;
        }
        if (!is_in_name(line[at])) {
            ++at;
            continue;
        }
        const std::size_t end = end_of_name(line, at);
        std::string name = words.normal(line.substr(at, end - at));
        const auto macro = std::ranges::find(macros_, name, &Macro::name);
        if (macro != macros_.end()) {
            if (!out) out.emplace();
            out->text.append(line.substr(copied, at - copied));
            out->put(macro->text, at, end, std::move(name));
            copied = end;
        }
        at = end;
    }
    if (out) out->text.append(line.substr(copied));
    return out;
}

}  // namespace kadr::macro
