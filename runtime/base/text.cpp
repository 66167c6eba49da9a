#include "base/text.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

#include "base/utf8.h"

namespace kadr {

std::size_t count_code_points(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    }));
}

std::string_view code_points(std::string_view text, std::size_t from, std::size_t count) {
    const auto past = [](std::string_view rest, std::size_t points) {
        std::size_t at = 0;
        for (; points > 0 && at < rest.size(); --points) {
            do ++at;
            while (at < rest.size() && (static_cast<unsigned char>(rest[at]) & 0xC0) == 0x80);
        }
        return at;
    };
    text.remove_prefix(past(text, from));
    return text.substr(0, past(text, count));
}

std::string latin_skeleton(std::string_view name) {
    constexpr std::pair<std::string_view, char> kPairs[] = {
        {"А", 'A'}, {"В", 'B'}, {"Е", 'E'}, {"К", 'K'}, {"М", 'M'}, {"Н", 'H'}, {"О", 'O'},
        {"Р", 'P'}, {"С", 'C'}, {"Т", 'T'}, {"Х", 'X'}, {"У", 'Y'}, {"І", 'I'}, {"Ј", 'J'},
        {"Ѕ", 'S'}, {"а", 'a'}, {"е", 'e'}, {"о", 'o'}, {"р", 'p'}, {"с", 'c'}, {"х", 'x'},
        {"у", 'y'}, {"і", 'i'}, {"ј", 'j'}, {"ѕ", 's'},
    };
    constexpr std::size_t kBytes = 2;  // of each of these letters
    std::string latin;
    for (std::size_t i = 0; i < name.size();) {
        const auto* const pair = std::ranges::find(
            kPairs, name.substr(i, kBytes), [](const auto& letters) { return letters.first; });
        if (pair == std::end(kPairs)) {
            latin += name[i++];
            continue;
        }
        latin += pair->second;
        i += kBytes;
    }
    return latin;
}

namespace {

/// Bytes of the well-formed code point that the text begins with; 0: it begins with none.
std::size_t well_formed_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    const std::size_t length = first < 0x80    ? 1
                               : first < 0xC2  ? 0
                               : first < 0xE0  ? 2
                               : first < 0xF0  ? 3
                               : first <= 0xF4 ? 4
                                               : 0;
    if (length == 0 || length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xC0) != 0x80) return 0;
    const bool is_overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
    const bool is_surrogate = first == 0xED && byte(1) >= 0xA0;
    const bool is_beyond = first == 0xF4 && byte(1) >= 0x90;
    return is_overlong || is_surrogate || is_beyond ? 0 : length;
}

/// Every code point of a text through a function.
template <typename Change>
std::string changed(std::string_view text, Change change) {
    std::string out;
    while (!text.empty()) {
        append_code_point(out, change(first_code_point(text)));
        text.remove_prefix(std::max<std::size_t>(well_formed_length(text), 1));
    }
    return out;
}

/// How far a letter's other case is from it, where whole rows of an alphabet lie apart.
struct LetterRow {
    char32_t first_lower;
    char32_t last_lower;
    char32_t to_upper;
    char32_t left_out;
};
constexpr LetterRow kRows[] = {{U'a', U'z', 0x20, 0},
                               {0xE0, 0xFE, 0x20, 0xF7},  // Latin-1 but for the sign of division
                               {0x430, 0x44F, 0x20, 0},   // Cyrillic
                               {0x450, 0x45F, 0x50, 0}};

}  // namespace

std::size_t find_malformed(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = well_formed_length(text.substr(at));
        if (length == 0) return at;
        at += length;
    }
    return std::string_view::npos;
}

char32_t first_code_point(std::string_view text) {
    const std::size_t length = well_formed_length(text);
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (length < 2) return byte(0);
    char32_t code = byte(0) & (0xFFu >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) code = code << 6 | (byte(i) & 0x3Fu);
    return code;
}

void append_code_point(std::string& text, char32_t code) {
    if (code < 0x80) {
        text += static_cast<char>(code);
        return;
    }
    const int tails = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    const unsigned mark = tails == 1 ? 0xC0 : tails == 2 ? 0xE0 : 0xF0;
    text += static_cast<char>(static_cast<unsigned char>(mark | code >> (6 * tails)));
    for (int i = tails - 1; i >= 0; --i)
        text += static_cast<char>(static_cast<unsigned char>(0x80 | (code >> (6 * i) & 0x3F)));
}

std::string utf8_text(std::string_view bytes) {
    const bool is_plain = std::all_of(bytes.begin(), bytes.end(),
                                      [](char c) { return static_cast<unsigned char>(c) < 0x80; });
    if (is_plain) return std::string(bytes);
    return changed(bytes, [](char32_t code) { return code; });
}

std::string upper_letters(std::string_view text) {
    return changed(text, [](char32_t code) -> char32_t {
        for (const LetterRow& row : kRows)
            if (code >= row.first_lower && code <= row.last_lower && code != row.left_out)
                return code - row.to_upper;
        return code;
    });
}

std::string lower_letters(std::string_view text) {
    return changed(text, [](char32_t code) -> char32_t {
        for (const LetterRow& row : kRows) {
            const char32_t lower = code + row.to_upper;
            if (lower >= row.first_lower && lower <= row.last_lower && lower != row.left_out)
                return lower;
        }
        return code;
    });
}

LineEnds line_ends(std::string_view text) {
    const std::size_t end = text.find_first_of("\r\n");
    if (end == std::string_view::npos) return LineEnds::Unknown;
    // Several CR in front of an LF are what is left of a text that went through many hands.
    const std::size_t behind = text.find_first_not_of('\r', end);
    if (behind == std::string_view::npos) return LineEnds::Unknown;
    return text[behind] == '\n' ? LineEnds::Feeds : LineEnds::Returns;
}

void end_lines_with_feeds(std::string& text) {
    const LineEnds ends = line_ends(text);
    const bool is_one_line = ends == LineEnds::Unknown && text.ends_with('\r');
    if (ends != LineEnds::Returns && !is_one_line) return;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_pair = i + 1 < text.size() && text[i + 1] == '\n';
        if (text[i] == '\r' && !is_pair) text[i] = '\n';
    }
}

namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
        }
    }
    return row.back();
}

/// The words of a name in the order of the alphabet: `drill` and `peck` of `peck_drill`.
std::vector<std::string> words_of(std::string_view name) {
    std::vector<std::string> words(1);
    for (const char c : name) {
        if (c == '_') words.emplace_back();
        else words.back() += c;
    }
    std::sort(words.begin(), words.end());
    return words;
}

}  // namespace

std::optional<std::string_view> nearest_name(std::string_view wrong,
                                             const std::string_view* candidates,
                                             std::size_t count) {
    // A third of the letters may differ; beyond that a proposal misleads more than it helps.
    std::size_t best = std::max<std::size_t>(1, (wrong.size() + 1) / 3) + 1;
    std::optional<std::string_view> nearest;
    const std::vector<std::string> words = words_of(wrong);
    for (std::size_t i = 0; i < count; ++i) {
        if (upper_ascii(candidates[i]) == upper_ascii(wrong)) return candidates[i];
        // `peck_drill`: the words of a name in another order.
        if (words.size() > 1 && candidates[i].size() == wrong.size() &&
            words_of(candidates[i]) == words)
            return candidates[i];
        // Of two letters every word of three is near, and every letter to every other; `dd` is a
        // slip for `d`, `Xd` is none.
        const std::string_view longer =
            std::max(candidates[i], wrong, [](auto a, auto b) { return a.size() < b.size(); });
        const bool is_doubled = longer.size() == 2 && longer[0] == longer[1];
        const bool is_letter = std::min(candidates[i].size(), wrong.size()) < 2;
        if ((is_letter && !is_doubled) || (candidates[i].size() == 2 && wrong.size() > 2)) continue;
        const std::size_t distance = edit_distance(wrong, candidates[i]);
        if (distance < best) {
            best = distance;
            nearest = candidates[i];
        }
    }
    return nearest;
}

std::string upper_ascii(std::string_view text) {
    std::string upper(text);
    for (char& c : upper) {
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    }
    return upper;
}

}  // namespace kadr
