// header.cpp — what the first lines of a source tell about how to read it.
#include "syntax/parse.h"

namespace kadr::syntax {

namespace {

/// `language` and `dialect` in every keyword language that ships; a test holds them against the
/// files. Other languages write them in English.
constexpr std::string_view kLanguageLexemes[] = {"language", "язык", "мова", "język"};
constexpr std::string_view kDialectLexemes[] = {"dialect", "диалект", "діалект", "dialekt"};

template <std::size_t N>
bool is_one_of(std::string_view word, const std::string_view (&lexemes)[N]) {
    for (const std::string_view lexeme : lexemes) {
        if (lexeme == word) return true;
    }
    return false;
}

/// Takes blanks and comments off the front.
void skip_blanks(std::string_view& text) {
    while (!text.empty()) {
        const std::size_t first = text.find_first_not_of(" \t\r\n\f");
        text.remove_prefix(first == std::string_view::npos ? text.size() : first);
        std::size_t end = 0;
        if (text.starts_with("//")) {
            end = text.find('\n');
        } else if (text.starts_with("/*")) {
            end = text.find("*/", 2);
            if (end != std::string_view::npos) end += 2;
        } else {
            return;
        }
        text.remove_prefix(end == std::string_view::npos ? text.size() : end);
    }
}

/// Takes a word off the front: everything up to a blank or `;`.
std::string_view take_word(std::string_view& text) {
    const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n\f;/{}()=\""));
    text.remove_prefix(word.size());
    return word;
}

/// Takes a text between quotes off the front: the name of a file may hold any character. One that
/// does not end in its line is none.
std::string_view take_text(std::string_view& text) {
    const std::size_t end = text.find_first_of("\"\n", 1);
    if (end == std::string_view::npos || text[end] == '\n') return text.substr(0, 0);
    const std::string_view inside = text.substr(1, end - 1);
    text.remove_prefix(end + 1);
    return inside;
}

}  // namespace

SourceHeader scan_header(std::string_view text) {
    SourceHeader header;
    const char* const begin = text.data();
    // `language`, `dialect` and `units` may stand in any order; the first other word ends the look.
    for (int i = 0; i < 4; ++i) {
        skip_blanks(text);
        const std::string_view keyword = take_word(text);
        if (keyword.empty()) break;
        skip_blanks(text);
        const bool is_quoted = text.starts_with('"');
        const auto at = static_cast<std::uint32_t>(text.data() - begin) + (is_quoted ? 1u : 0u);
        const std::string_view value = is_quoted ? take_text(text) : take_word(text);
        skip_blanks(text);
        if ((value.empty() && !is_quoted) || !text.starts_with(';')) break;
        text.remove_prefix(1);
        if (is_one_of(keyword, kLanguageLexemes)) {
            header.language = value;
            header.language_at = at;
        }
        if (is_one_of(keyword, kDialectLexemes)) {
            header.dialect = value;
            header.dialect_at = at;
        }
    }
    return header;
}

}  // namespace kadr::syntax
