#include "nc/head_words.h"

#include <algorithm>

#include "nc/letters.h"

namespace kadr::nc {

namespace {

constexpr std::size_t kNone = std::string_view::npos;

bool is_blank_at(std::string_view line, std::size_t at) {
    return at < line.size() && (is_blank(line[at]) || line[at] == '\r');
}

std::size_t behind_blanks(std::string_view line, std::size_t at) {
    while (is_blank_at(line, at)) ++at;
    return at;
}

/// Behind the name of a program by which others call it: `O0001`, `O<NAME>`.
std::size_t behind_program(const DialectTables& tables, std::string_view line) {
    std::string_view behind;
    const ProgramPattern* head =
        header_of(tables.language.calls, line, tables.notation.ignores_case, &behind);
    return head == nullptr ? kNone : line.size() - behind.size();
}

/// Behind `%PART`, of a head that the dialect writes with the units.
std::size_t behind_name(const DialectTables& tables, std::string_view line, std::size_t begin) {
    for (const std::string& header : tables.program.header) {
        const std::size_t front = header.find_first_of("{[");
        if (front == 0 || front == kNone || header.find("{units}") == kNone) continue;
        if (!line.substr(begin).starts_with(std::string_view(header).substr(0, front))) continue;
        std::size_t end = begin + front;
        while (end < line.size() && !is_blank_at(line, end)) ++end;
        return end;
    }
    return kNone;
}

}  // namespace

std::size_t words_behind_head(const DialectTables& tables, std::string_view line) {
    const std::size_t begin = behind_blanks(line, 0);
    std::size_t at = behind_program(tables, line);
    if (at == kNone) at = behind_name(tables, line, begin);
    if (at == kNone) return kNone;
    const CommentStyle& comment = tables.comment;
    for (at = behind_blanks(line, at); at < line.size(); at = behind_blanks(line, at)) {
        if (line[at] == tables.notation.end_sign) {
            ++at;
        } else if (!comment.open.empty() && line.substr(at).starts_with(comment.open)) {
            const std::size_t close = comment.close.empty() ? kNone : line.find(comment.close, at);
            if (close == kNone) return kNone;
            at = close + comment.close.size();
        } else {
            return at;
        }
    }
    return kNone;
}

}  // namespace kadr::nc
