// cells.h — texts of tables and schemas as a page shows them.
#pragma once

#include <string>
#include <string_view>

namespace docs {

/// Outside of code `<` would begin a tag of HTML.
inline std::string plain(std::string_view text) {
    std::string out;
    bool is_code = false;
    for (const char c : text) {
        if (c == '`') is_code = !is_code;
        if (c == '<' && !is_code) out += "&lt;";
        else out += c;
    }
    return out;
}

/// As a cell of a table, in one line.
inline std::string cell(std::string_view text) {
    std::string out;
    for (const char c : plain(text)) {
        if (c == '|') out += "\\|";
        else out += c == '\n' ? ' ' : c;
    }
    return out.empty() ? "—" : out;
}

}  // namespace docs
