#include "macro/variable_numbers.h"

#include <algorithm>

#include "base/diagnostics/control.h"
#include "nc/control_words.h"

namespace kadr::macro {

namespace {

bool is_of_name(char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; }

}  // namespace

std::optional<nc::LineFault> VariableNumbers::define(const nc::Language& language,
                                                     std::string_view text) {
    constexpr std::size_t kLongest = 8;
    constexpr std::int64_t kFirst = 500;
    constexpr std::int64_t kLast = 549;
    const auto wrong = [](const DiagnosticRow& row, std::string_view what) {
        return nc::LineFault{&row, {}, {std::string(what)}};
    };
    const std::size_t open = text.find(language.index_open);
    const bool is_closed = text.ends_with(language.index_close) && open != std::string_view::npos;
    std::int64_t number = 0;
    for (std::size_t i = 0; is_closed && i < open; ++i) {
        if (text[i] < '0' || text[i] > '9' || number > kLast) return wrong(diag::NamesForm, text);
        number = number * 10 + (text[i] - '0');
    }
    if (!is_closed || open == 0) return wrong(diag::NamesForm, text);
    std::string_view rest = text.substr(open + 1, text.size() - open - 2);
    for (;; ++number) {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        std::string name(rest.substr(0, comma));
        std::erase(name, ' ');
        const bool is_name = !name.empty() && name[0] >= 'A' && name[0] <= 'Z' &&
                             std::ranges::all_of(name, is_of_name);
        if (!is_name) return wrong(diag::NamesSign, name);
        if (name.size() > kLongest) return wrong(diag::NamesLength, name);
        if (number < kFirst || number > kLast)
            return wrong(diag::NamesRange, std::to_string(number));
        names_[name] = number;
        if (comma == rest.size()) return std::nullopt;
        rest.remove_prefix(comma + 1);
    }
}

std::optional<ReplacedText> VariableNumbers::numbered(const nc::DialectTables& tables,
                                                      std::string_view line) const {
    if (names_.empty() || line.find('#') == std::string_view::npos) return std::nullopt;
    const nc::ControlWords words(tables, line);
    ReplacedText out;
    for (std::size_t at = 0; at < line.size();) {
        if (words.is_comment(at)) {
            out.text += line.substr(at);
            break;
        }
        std::size_t end = at + 1;
        while (line[at] == '#' && end < line.size() && is_of_name(line[end])) ++end;
        const auto known =
            line[at] == '#' ? names_.find(line.substr(at + 1, end - at - 1)) : names_.end();
        if (known == names_.end()) {
            out.text += line[at++];
            continue;
        }
        // Alone between brackets at the front it is the variable that is set.
        const bool is_front = out.text.ends_with('[') && end < line.size() && line[end] == ']' &&
                              words.skip_blanks(end + 1) < line.size() &&
                              line[words.skip_blanks(end + 1)] == '=';
        if (is_front) out.text.pop_back();
        const std::size_t bracket = is_front ? 1 : 0;
        out.put('#' + std::to_string(known->second), at - bracket, end + bracket, known->first);
        at = end + bracket;
    }
    return out.words.empty() ? std::nullopt : std::optional(std::move(out));
}

}  // namespace kadr::macro
