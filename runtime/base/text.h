// text.h — small work on bytes and UTF-8, and files written whole or not at all.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace kadr {

/// Number of code points of a UTF-8 text; every malformed byte counts as one.
std::size_t count_code_points(std::string_view text);

/// `count` code points of a UTF-8 text from the one at `from` on; fewer if it has no more.
std::string_view code_points(std::string_view text, std::size_t from, std::size_t count);

/// The whole file as bytes, or nothing if it cannot be read (missing, a folder, no permission).
std::optional<std::string> read_file(const std::string& path);

/// Writes a file whole or not at all: into a neighbour first, then renamed. False if the folder
/// cannot be written; an existing file is then as it was.
bool write_file_whole(const std::string& path, std::string_view text);

/// The closest of the candidates by edit distance, if it is near enough to be a likely slip.
std::optional<std::string_view> nearest_name(std::string_view wrong,
                                             const std::string_view* candidates, std::size_t count);

/// ASCII upper case; other bytes stay.
std::string upper_ascii(std::string_view text);

}  // namespace kadr
