#include "base/allow.h"

#include <string>

#include "base/text.h"

namespace kadr {

namespace {

void skip_separators(std::string_view& text) {
    const std::size_t first = text.find_first_not_of(" \t,");
    text.remove_prefix(first == std::string_view::npos ? text.size() : first);
}

std::string_view take_word(std::string_view& text) {
    const std::string_view word = text.substr(0, text.find_first_of(" \t,\r\n"));
    text.remove_prefix(word.size());
    return word;
}

/// A letter and four digits.
bool is_code(std::string_view word) {
    return word.size() == 5 && word[0] == 'K' &&
           word.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

}  // namespace

Allowance allowed_codes(std::string_view comment) {
    Allowance result;
    skip_separators(comment);
    if (take_word(comment) != "kadr:") return result;
    result.is_one = true;
    skip_separators(comment);
    if (take_word(comment) != "allow") return result;
    while (true) {
        skip_separators(comment);
        std::string_view word = take_word(comment);
        if (word.ends_with(':')) word.remove_suffix(1);
        if (!is_code(word)) break;
        result.codes.push_back(word);
    }
    result.is_well_formed = !result.codes.empty();
    return result;
}

bool iso_line_allows(std::string_view line, std::string_view code) {
    constexpr std::string_view kMark = "KADR:";
    const std::string text = upper_ascii(line);
    const std::size_t mark = text.find(kMark);
    if (mark == std::string::npos) return false;
    std::string_view rest = std::string_view(text).substr(mark + kMark.size());
    rest = rest.substr(0, rest.find(')'));
    skip_separators(rest);
    if (take_word(rest) != "ALLOW") return false;
    for (skip_separators(rest); !rest.empty(); skip_separators(rest)) {
        std::string_view word = take_word(rest);
        if (word.ends_with(':')) word.remove_suffix(1);
        if (!is_code(word)) return false;
        if (word == code) return true;
    }
    return false;
}

}  // namespace kadr
