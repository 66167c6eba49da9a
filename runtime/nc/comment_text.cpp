#include "nc/comment_text.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/text.h"

namespace kadr::nc {

namespace {

/// Cyrillic letters from U+0410 (А) to U+044F (я), after ICAO 9303, the spelling in passports.
constexpr std::array<std::string_view, 64> kCyrillic = {
    "A", "B", "V", "G", "D", "E",  "ZH", "Z",  "I",  "I",    "K",  "L", "M", "N", "O",  "P",
    "R", "S", "T", "U", "F", "KH", "TS", "CH", "SH", "SHCH", "IE", "Y", "",  "E", "IU", "IA",
    "a", "b", "v", "g", "d", "e",  "zh", "z",  "i",  "i",    "k",  "l", "m", "n", "o",  "p",
    "r", "s", "t", "u", "f", "kh", "ts", "ch", "sh", "shch", "ie", "y", "",  "e", "iu", "ia"};

struct Letter {
    char32_t code;
    std::string_view text;
};
constexpr std::array<Letter, 39> kLetters = {
    {{U'Ё', "E"},   {U'ё', "e"},   {U'Є', "IE"},  {U'є', "ie"}, {U'І', "I"},  {U'і', "i"},
     {U'Ї', "I"},   {U'ї', "i"},   {U'Ґ', "G"},   {U'ґ', "g"},  {U'Ä', "AE"}, {U'ä', "ae"},
     {U'Ö', "OE"},  {U'ö', "oe"},  {U'Ü', "UE"},  {U'ü', "ue"}, {U'ß', "ss"}, {U'ø', "o"},
     {U'Ø', "O"},   {U'°', "DEG"}, {U'×', "X"},   {U'µ', "u"},  {U'–', "-"},  {U'—', "-"},
     {U'“', "'"},   {U'”', "'"},   {U'…', "..."}, {U'№', "NO"}, {U'±', "+-"}, {U'Æ', "AE"},
     {U'æ', "ae"},  {U'Œ', "OE"},  {U'œ', "oe"},  {U'Þ', "TH"}, {U'þ', "th"}, {U'−', "-"},
     {U'Ω', "OHM"}, {U'€', "EUR"}, {U'²', "2"}}};

/// Latin letters from U+00C0 (À) to U+017F (ſ) without their marks.
constexpr std::string_view kLatin =
    "AAAAAAACEEEEIIIIDNOOOOOxOUUUUYTsaaaaaaaceeeeiiiidnooooo/ouuuuyty"
    "AaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIiIiJjKkkLlLlLlL"
    "lLlNnNnNnnNnOoOoOoOoRrRrRrSsSsSsSsTtTtTtUuUuUuUuUuUuWwYyYZzZzZzs";

/// The code point at the front, its bytes removed; malformed bytes come one by one as U+FFFD.
char32_t take_code_point(std::string_view& text) {
    const auto first = static_cast<unsigned char>(text[0]);
    const std::size_t length = first < 0x80    ? 1
                               : first >= 0xf0 ? 4
                               : first >= 0xe0 ? 3
                               : first >= 0xc0 ? 2
                                               : 1;
    if (first < 0x80) {
        text.remove_prefix(1);
        return first;
    }
    if (length == 1 || text.size() < length) {
        text.remove_prefix(1);
        return 0xfffd;
    }
    char32_t code = first & (0xffu >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        code = (code << 6) | (static_cast<unsigned char>(text[i]) & 0x3fu);
    }
    text.remove_prefix(length);
    return code;
}

void append_ascii(std::string& out, char32_t code) {
    if (code >= 0x410 && code <= 0x44f) {
        out += kCyrillic[code - 0x410];
        return;
    }
    const auto found = std::find_if(kLetters.begin(), kLetters.end(),
                                    [&](const Letter& letter) { return letter.code == code; });
    if (found != kLetters.end()) {
        out += found->text;
    } else if (code >= 0xc0 && code < 0xc0 + kLatin.size()) {
        out += kLatin[code - 0xc0];
    } else {
        out += '?';
    }
}

bool is_name_letter(char c) { return (c >= 'A' && c <= 'Z') || c == '_'; }

}  // namespace

std::string comment_text(std::string_view text, const CommentStyle& style) {
    std::string ascii;
    std::string_view rest = text;
    while (!rest.empty()) {
        const std::string_view before = rest;
        const char32_t code = take_code_point(rest);
        if (code < 0x20 || code == 0x7f) {
            ascii += ' ';
        } else if (code < 0x80) {
            ascii += static_cast<char>(code);
        } else if (style.is_ascii) {
            append_ascii(ascii, code);
        } else {
            ascii += before.substr(0, before.size() - rest.size());
        }
    }
    std::string out;
    for (const char c : ascii) {
        const auto replaced = std::find_if(style.replacements.begin(), style.replacements.end(),
                                           [&](const auto& pair) { return pair.first == c; });
        if (replaced != style.replacements.end()) {
            out += replaced->second;
        } else {
            out += c;
        }
    }
    while (out.ends_with(' ')) out.pop_back();
    return style.is_upper ? upper_ascii(out) : out;
}

std::string program_name(std::string_view name, const ProgramTemplates& frame) {
    CommentStyle ascii;
    ascii.is_ascii = true;
    ascii.is_upper = true;
    std::string out = comment_text(name, ascii);
    for (char& c : out) {
        if (!is_name_letter(c) && !(c >= '0' && c <= '9')) c = '_';
    }
    const bool begins_well =
        out.size() >= 2 && is_name_letter(out[0]) && is_name_letter(out[1]) && out[1] != '_';
    if (frame.name_needs_two_letters && !begins_well) out.insert(0, "NC_");
    if (frame.name_length > 0 && out.size() > frame.name_length) out.resize(frame.name_length);
    return out;
}

}  // namespace kadr::nc
