// text.h — small work on bytes and UTF-8, and files written whole or not at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kadr {

/// Number of code points of a UTF-8 text; every malformed byte counts as one.
std::size_t count_code_points(std::string_view text);

/// `count` code points of a UTF-8 text from the one at `from` on; fewer if it has no more.
std::string_view code_points(std::string_view text, std::size_t from, std::size_t count);

/// Its first code point; a malformed byte is the character with that code. The text is not empty.
char32_t first_code_point(std::string_view text);

/// Writes a code point behind a UTF-8 text.
void append_code_point(std::string& text, char32_t code);

/// Bytes of a program as UTF-8: what is malformed was written in Latin-1, a character a byte.
std::string utf8_text(std::string_view bytes);

/// Letters of Latin-1 and of the Cyrillic alphabet in the other case; other characters stay.
std::string upper_letters(std::string_view text);
std::string lower_letters(std::string_view text);

/// How the lines of a text end, as far as it is there.
enum class LineEnds : std::uint8_t {
    Unknown,  // no line has ended yet, or a CR is its last character
    Feeds,    // LF, or CR LF
    Returns,  // CR alone, as old editors and some controls write it
};
LineEnds line_ends(std::string_view text);
/// A text whose lines end with CR alone gets LF for it; every character stays in its place.
void end_lines_with_feeds(std::string& text);

/// A name with the Latin letters that its Cyrillic ones are easily taken for: two names that look
/// alike have the same.
std::string latin_skeleton(std::string_view name);

/// The closest of the candidates by edit distance, if it is near enough to be a likely slip.
std::optional<std::string_view> nearest_name(std::string_view wrong,
                                             const std::string_view* candidates, std::size_t count);

/// ASCII upper case; other bytes stay.
std::string upper_ascii(std::string_view text);

}  // namespace kadr
