#include "syntax/quotes.h"

namespace kadr::syntax {

namespace {

/// Whether a value may begin behind what stands in the braces of a text so far: only there a quote
/// opens a text and does not close the one around.
bool expects_value(std::string_view before) {
    while (!before.empty() && (before.back() == ' ' || before.back() == '\t')) {
        before.remove_suffix(1);
    }
    if (before.empty() || before.ends_with(" contains")) return true;
    return std::string_view("([{,+?:=<>&|!").find(before.back()) != std::string_view::npos;
}

/// Texts in the braces of texts: more levels than this, nobody can read.
constexpr int kMaxNesting = 8;

std::uint32_t end_of_nested(std::string_view text, std::uint32_t begin, std::uint32_t end,
                            int nesting);

std::uint32_t end_of_braces(std::string_view text, std::uint32_t open, std::uint32_t end,
                            int nesting) {
    int depth = 0;
    for (std::uint32_t i = open; i < end; ++i) {
        if (text[i] == '\n') return end;
        if (text[i] == '"') {
            if (!expects_value(text.substr(open + 1, i - open - 1))) return end;
            const std::uint32_t inner = end_of_nested(text, i, end, nesting + 1);
            if (inner == i) return end;
            i = inner - 1;
            continue;
        }
        if (text[i] == '{') ++depth;
        if (text[i] == '}' && --depth == 0) return i;
    }
    return end;
}

std::uint32_t end_of_nested(std::string_view text, std::uint32_t begin, std::uint32_t end,
                            int nesting) {
    if (nesting > kMaxNesting) return begin;
    for (std::uint32_t i = begin + 1; i < end && text[i] != '\n'; ++i) {
        const bool is_double = i + 1 < end && text[i + 1] == text[i];
        if (text[i] == '"') return i + 1;
        if (text[i] == '\\' || (text[i] == '{' && is_double)) {
            ++i;
        } else if (text[i] == '{') {
            i = end_of_braces(text, i, end, nesting);
        }
    }
    return begin;
}

}  // namespace

std::uint32_t closing_brace(std::string_view text, std::uint32_t open, std::uint32_t end) {
    return end_of_braces(text, open, end, 0);
}

std::uint32_t end_of_text(std::string_view text, std::uint32_t begin, std::uint32_t end) {
    return end_of_nested(text, begin, end, 0);
}

}  // namespace kadr::syntax
