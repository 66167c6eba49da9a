#include "nc/calls.h"

#include <algorithm>
#include <iterator>

#include "base/text.h"
#include "nc/letters.h"

namespace kadr::nc {

namespace {

bool is_name_char(char c) {
    return is_digit(c) || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' ||
           c == '-' || c == '+' || c == '.';
}

/// Without regard to case.
bool starts_with(std::string_view text, std::string_view front) {
    const auto upper = [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; };
    return text.size() >= front.size() &&
           std::equal(front.begin(), front.end(), text.begin(),
                      [&](char a, char b) { return upper(a) == upper(b); });
}

/// 12 for `0012`.
std::string without_zeros(std::string_view digits) {
    while (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
    return std::string(digits);
}

}  // namespace

bool read_program_pattern(std::string_view form, ProgramPattern& out) {
    const std::size_t open = form.find('{');
    const std::size_t close = form.find('}');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open)
        return false;
    const std::string_view hole = form.substr(open + 1, close - open - 1);
    if (hole != "n" && hole != "name") return false;
    out.form = form;
    out.before = form.substr(0, open);
    out.behind = form.substr(close + 1);
    out.is_number = hole == "n";
    return true;
}

namespace {

/// Whether what stands behind a program's name belongs to it still. Behind a number another word of
/// the block may begin at once, `O0001G20`.
bool goes_on(const ProgramPattern& pattern, std::string_view rest) {
    if (rest.empty() || !is_name_char(rest.front())) return false;
    const bool begins_word = pattern.is_number && pattern.behind.empty() && is_letter(rest.front());
    return !begins_word;
}

}  // namespace

std::optional<std::string> match_program(const ProgramPattern& pattern, std::string_view text,
                                         bool ignores_case, bool is_whole,
                                         std::string_view* behind) {
    if (!starts_with(text, pattern.before)) return std::nullopt;
    text.remove_prefix(pattern.before.size());
    if (pattern.is_number && !is_whole) {
        while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    }
    const auto is_sign = pattern.is_number ? is_digit : is_name_char;
    auto length = static_cast<std::size_t>(std::ranges::find_if_not(text, is_sign) - text.begin());
    // What stands behind the name may be made of letters as well: `POCK_SPF`.
    while (length > 0 && !starts_with(text.substr(length), pattern.behind)) --length;
    if (length == 0) return std::nullopt;
    const std::string_view rest = text.substr(length + pattern.behind.size());
    if (is_whole ? !rest.empty() : goes_on(pattern, rest)) return std::nullopt;
    if (behind != nullptr) *behind = rest;
    const std::string_view name = text.substr(0, length);
    if (pattern.is_number) return without_zeros(name);
    return ignores_case ? upper_ascii(name) : std::string(name);
}

const ProgramPattern* header_of(const CallLanguage& calls, std::string_view line, bool ignores_case,
                                std::string_view* behind) {
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    const auto found = std::ranges::find_if(calls.headers, [&](const ProgramPattern& pattern) {
        return match_program(pattern, line, ignores_case, false, behind).has_value();
    });
    return found == calls.headers.end() ? nullptr : &*found;
}

std::optional<std::string_view> name_in_header(const CallLanguage& calls, std::string_view line,
                                               bool ignores_case) {
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    std::string_view behind;
    const ProgramPattern* const head = header_of(calls, line, ignores_case, &behind);
    if (head == nullptr) return std::nullopt;
    std::string_view name = line.substr(head->before.size());
    name.remove_suffix(behind.size() + head->behind.size());
    while (!name.empty() && is_blank(name.front())) name.remove_prefix(1);
    return name;
}

std::optional<std::string> program_of_header(const CallLanguage& calls, std::string_view line,
                                             bool ignores_case) {
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    for (const ProgramPattern& pattern : calls.headers) {
        auto name = match_program(pattern, line, ignores_case, false);
        // A name that is a number in other words: `<O123>` is O123.
        if (name && !pattern.is_number) return program_of_path(calls, *name, ignores_case);
        if (name) return name;
    }
    return std::nullopt;
}

namespace {

std::string_view file_of(std::string_view path) {
    const std::size_t slash = path.find_last_of('/');
    return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

/// The form of files with marks of their own that the name of a file has; nullptr: none.
const ProgramPattern* form_of_file(const CallLanguage& calls, std::string_view file,
                                   bool ignores_case) {
    const auto found = std::ranges::find_if(calls.files, [&](const ProgramPattern& pattern) {
        const bool is_bare = pattern.before.empty() && pattern.behind.empty();
        return !is_bare && match_program(pattern, file, ignores_case, true).has_value();
    });
    return found == calls.files.end() ? nullptr : &*found;
}

}  // namespace

std::string program_of_path(const CallLanguage& calls, std::string_view path, bool ignores_case) {
    const std::string_view file = file_of(path);
    if (const ProgramPattern* form = form_of_file(calls, file, ignores_case))
        return *match_program(*form, file, ignores_case, true);
    return ignores_case ? upper_ascii(file) : std::string(file);
}

std::string kind_of(const ProgramPattern& pattern) {
    std::string letters;
    std::ranges::copy_if(pattern.behind, std::back_inserter(letters),
                         [](char c) { return is_letter(c) && c != '_'; });
    return upper_ascii(letters);
}

std::string kind_of_path(const CallLanguage& calls, std::string_view path, bool ignores_case) {
    const ProgramPattern* const form = form_of_file(calls, file_of(path), ignores_case);
    return form != nullptr ? kind_of(*form) : std::string();
}

std::string shown_program(const CallLanguage& calls, std::string_view name) {
    const bool is_number = std::ranges::all_of(name, is_digit);
    for (const ProgramPattern& pattern : calls.headers) {
        if (pattern.is_number && is_number) return pattern.before + std::string(name);
    }
    return std::string(name);
}

}  // namespace kadr::nc
