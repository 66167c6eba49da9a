#include "nc/control_words.h"

#include <algorithm>

#include "base/text.h"
#include "nc/letters.h"

namespace kadr::nc {

ControlWords::ControlWords(const DialectTables& tables, std::string_view line)
    : tables_(tables), line_(line), comment_(tables.comment.open) {
    while (comment_.ends_with(' ')) comment_.remove_suffix(1);
}

std::size_t ControlWords::skip_blanks(std::size_t at) const {
    while (at < line_.size() && is_blank(line_[at])) ++at;
    return at;
}

std::size_t ControlWords::skip_comments(std::size_t at) const {
    const std::string& close = tables_.comment.close;
    at = skip_blanks(at);
    if (!tables_.comment.also_read.empty()) return skip_all_comments(at);
    while (!close.empty() && is_comment(at)) {
        const std::size_t end = line_.find(close, at + comment_.size());
        if (end == std::string_view::npos) break;
        at = skip_blanks(end + close.size());
    }
    return at;
}

std::size_t ControlWords::skip_all_comments(std::size_t at) const {
    while (at < line_.size()) {
        std::string_view open;
        std::string_view close;
        if (line_.substr(at).starts_with(comment_)) {
            open = comment_;
            close = tables_.comment.close;
        }
        for (const CommentMarks& marks : tables_.comment.also_read) {
            if (!open.empty() || !line_.substr(at).starts_with(marks.open)) continue;
            open = marks.open;
            close = marks.close;
        }
        const std::size_t end = close.empty() ? line_.size() : line_.find(close, at + open.size());
        if (open.empty() || close.empty() || end == std::string_view::npos) break;
        at = skip_blanks(end + close.size());
    }
    return at;
}

std::size_t ControlWords::trim(std::size_t begin, std::size_t end) const {
    end = std::min(end, line_.size());
    while (end > begin && is_blank(line_[end - 1])) --end;
    return end;
}

char ControlWords::upper(char c) const {
    const bool is_small = c >= 'a' && c <= 'z';
    return is_small && tables_.notation.ignores_case ? static_cast<char>(c - 'a' + 'A') : c;
}

std::string ControlWords::normal(std::string_view text) const {
    return tables_.notation.ignores_case ? upper_ascii(text) : std::string(text);
}

bool ControlWords::is_comment(std::size_t at) const {
    if (at >= line_.size()) return false;
    if (line_.substr(at).starts_with(comment_)) return true;
    const auto& others = tables_.comment.also_read;
    return !others.empty() && std::ranges::any_of(others, [&](const CommentMarks& marks) {
        return line_.substr(at).starts_with(marks.open);
    });
}

bool ControlWords::is_block_end(std::size_t at) const {
    const char sign = tables_.notation.end_sign;
    if (sign == '\0' || at >= line_.size() || line_[at] != sign) return false;
    const std::size_t next = skip_blanks(at + 1);
    return next >= line_.size() || is_comment(next);
}

LetterRun ControlWords::word_at(std::size_t at) const {
    LetterRun word{at, {}};
    if (at >= line_.size()) return word;
    std::size_t end = at;
    const bool is_sign = line_[at] == '#' || line_[at] == '$';
    if (is_sign) ++end;
    const bool has_name = end < line_.size() && is_letter(line_[end]);
    // Behind a sign a name keeps its digits everywhere: `#_WZG54`.
    const bool has_digits = has_name && (is_sign || !is_blank_insensitive());
    while (has_name && end < line_.size() &&
           (is_letter(line_[end]) || (has_digits && is_digit(line_[end]))))
        ++end;
    word.text = line_.substr(at, end - at);
    return word;
}

bool ControlWords::is_same(std::string_view a, std::string_view b) const {
    return std::ranges::equal(a, b, [this](char x, char y) { return upper(x) == upper(y); });
}

bool ControlWords::starts_with(std::size_t at, std::string_view text) const {
    return at <= line_.size() && is_same(line_.substr(at, text.size()), text);
}

bool ControlWords::matches_operator(const LetterRun& word, std::string_view text) const {
    if (!is_blank_insensitive()) return is_same(word.text, text);
    return is_same(word.text.substr(0, text.size()), text);
}

bool ControlWords::matches(const LetterRun& word, std::string_view keyword) const {
    if (word.text.empty()) return false;
    if (matches_operator(word, keyword)) return true;
    const auto shortest = static_cast<std::size_t>(tables_.language.rules.short_words);
    return shortest != 0 && word.text.size() >= shortest && word.text.size() < keyword.size() &&
           is_same(keyword.substr(0, word.text.size()), word.text);
}

bool ControlWords::matches_with_digits(const LetterRun& word, std::string_view keyword) const {
    if (keyword.size() != 1) return matches(word, keyword);
    const std::string_view behind = word.text.substr(std::min<std::size_t>(1, word.text.size()));
    return is_same(word.text.substr(0, 1), keyword) && std::ranges::all_of(behind, is_digit);
}

std::size_t ControlWords::length_of(const LetterRun& word, std::string_view keyword) const {
    return std::min(word.text.size(), keyword.size());
}

bool ControlWords::begins_variable(std::size_t at) const {
    if (at >= line_.size()) return false;
    const Language& language = tables_.language;
    const LetterRun word = word_at(at);
    for (const VariableForm& form : language.variables) {
        const char first = form.name[0];
        if (!starts_with(at, form.name.substr(0, 1))) continue;
        if (first == '#' || first == '$') return true;
        if (!form.is_family || !starts_with(at, form.name)) continue;
        const std::string_view digits =
            word.text.substr(std::min(form.name.size(), word.text.size()));
        const std::size_t next = skip_blanks(at + word.text.size());
        const bool has_index = next < line_.size() && line_[next] == language.index_open;
        if (digits.empty() ? has_index : std::ranges::all_of(digits, is_digit)) return true;
    }
    return false;
}

std::int64_t ControlWords::block_number(std::string_view name) const {
    if (name.size() < 2 || !std::ranges::all_of(name.substr(1), is_digit)) return -1;
    const AddressId address = tables_.find_address(name.substr(0, 1));
    if (address == kNoAddress || !tables_.addresses[address].is_block_number) return -1;
    std::int64_t number = 0;
    for (const char c : name.substr(1))
        number = std::min<std::int64_t>(number * 10 + (c - '0'), 1'000'000'000);
    return number;
}

}  // namespace kadr::nc
