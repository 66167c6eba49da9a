// line_texts.cpp — names in a line that stand for text or for numbers of variables.
#include "macro/line_texts.h"

#include <algorithm>

#include "base/diagnostics/control.h"
#include "macro/program_base.h"
#include "nc/control_words.h"

namespace kadr::macro {

using nc::ControlStatement;
using nc::Statement;

Outcome LineTexts::define_macro(CompiledLine& line, const ControlStatement& statement) {
    switch (run_.frame->macros.define(run_.tables, statement.name)) {
        case TextMacros::Fault::None: break;
        case TextMacros::Fault::Form: return run_.fail(line, diag::MacroForm, statement.span);
        case TextMacros::Fault::Known:
            return run_.fail(line, diag::MacroTwice, statement.span,
                             {statement.name.substr(0, statement.name.find(' '))});
        case TextMacros::Fault::Nested:
            return run_.fail(line, diag::MacroNested, statement.span, {statement.name});
    }
    return Outcome::Nothing;
}

/// A line with the words that stand for text put in; one that defines such a word stays as it is.
std::string_view LineTexts::with_macros(std::string_view text) {
    if (!names_.empty()) text = with_names(text);
    if (run_.frame->macros.is_empty()) return text;
    if (nc::front_of(run_.tables, text).statement == Statement::DefineMacro) return text;
    auto expanded = run_.frame->macros.expanded(run_.tables, text);
    if (!expanded) return text;
    expanded_text_ = std::move(*expanded);
    return expanded_text_;
}

/// `500[WIDTH,DEPTH]`: the names stand for #500, #501 … from here on.
/// source: F 6.6
Outcome LineTexts::name_variables(CompiledLine& line, const ControlStatement& statement) {
    constexpr std::size_t kLongest = 8;
    constexpr std::int64_t kFirst = 500;
    constexpr std::int64_t kLast = 549;
    const std::string& text = statement.name;
    const auto wrong = [&](const DiagnosticRow& row, std::string_view what) {
        return run_.fail(line, row, statement.span, {std::string(what)});
    };
    const std::size_t open = text.find(run_.language.index_open);
    const bool is_closed = text.ends_with(run_.language.index_close) && open != std::string::npos;
    std::int64_t number = 0;
    for (std::size_t i = 0; is_closed && i < open; ++i) {
        if (text[i] < '0' || text[i] > '9' || number > kLast) return wrong(diag::NamesForm, text);
        number = number * 10 + (text[i] - '0');
    }
    if (!is_closed || open == 0) return wrong(diag::NamesForm, text);
    std::string_view rest = std::string_view(text).substr(open + 1, text.size() - open - 2);
    for (;; ++number) {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        std::string name(rest.substr(0, comma));
        std::erase(name, ' ');
        const bool is_name =
            !name.empty() && name[0] >= 'A' && name[0] <= 'Z' &&
            std::ranges::all_of(name, [](char c) {
                return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
            });
        if (!is_name) return wrong(diag::NamesSign, name);
        if (name.size() > kLongest) return wrong(diag::NamesLength, name);
        if (number < kFirst || number > kLast)
            return wrong(diag::NamesRange, std::to_string(number));
        names_[name] = number;
        if (comma == rest.size()) return Outcome::Nothing;
        rest.remove_prefix(comma + 1);
    }
}

/// `[#WIDTH]=5`, `X[#WIDTH]`: names of variables become their numbers.
std::string_view LineTexts::with_names(std::string_view text) {
    if (names_.empty() || text.find('#') == std::string_view::npos) return text;
    const nc::ControlWords words(run_.tables, text);
    const auto is_of_name = [](char c) {
        return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    };
    std::string named;
    for (std::size_t at = 0; at < text.size();) {
        if (words.is_comment(at)) {
            named += text.substr(at);
            break;
        }
        std::size_t end = at + 1;
        while (text[at] == '#' && end < text.size() && is_of_name(text[end])) ++end;
        const auto known = text[at] == '#'
                               ? names_.find(std::string(text.substr(at + 1, end - at - 1)))
                               : names_.end();
        if (known == names_.end()) {
            named += text[at++];
            continue;
        }
        // Alone between brackets at the front it is the variable that is set.
        const bool is_front = named.ends_with('[') && end < text.size() && text[end] == ']' &&
                              words.skip_blanks(end + 1) < text.size() &&
                              text[words.skip_blanks(end + 1)] == '=';
        if (is_front) named.pop_back();
        named += '#' + std::to_string(known->second);
        at = end + (is_front ? 1 : 0);
    }
    named_text_ = std::move(named);
    return named_text_;
}

}  // namespace kadr::macro
