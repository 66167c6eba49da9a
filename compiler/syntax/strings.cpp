#include "syntax/strings.h"

#include <algorithm>
#include <string>

#include "base/diagnostics/syntax.h"
#include "syntax/quotes.h"

namespace kadr::syntax {

namespace {

/// The index of the `:` that begins a format, or `end`. A `:` in brackets or behind `?` is part of
/// the expression; `??` asks for none.
std::uint32_t format_place(std::string_view text, std::uint32_t begin, std::uint32_t end) {
    int depth = 0;
    int questions = 0;
    for (std::uint32_t i = begin; i < end; ++i) {
        const char c = text[i];
        if (c == '"') {
            i = std::max(i, end_of_text(text, i, end) - 1);
            continue;
        }
        if (c == '(' || c == '[' || c == '{') ++depth;
        if (c == ')' || c == ']' || c == '}') --depth;
        if (depth != 0) continue;
        if (c == '?' && i + 1 < end && text[i + 1] == '?') ++i;
        else if (c == '?') ++questions;
        if (c == ':' && questions-- == 0) return i;
    }
    return end;
}

/// `.3`, `03`, `8.3`, `+.1`, `u`, `.2u`: sign, width, decimals, with the unit.
bool is_format(std::string_view format) {
    std::size_t i = 0;
    const auto skip_digits = [&] {
        const std::size_t first = i;
        while (i < format.size() && format[i] >= '0' && format[i] <= '9') ++i;
        return i - first;
    };
    const bool has_sign = format.starts_with('+');
    if (has_sign) ++i;
    std::size_t digits = skip_digits();
    if (digits > 2) return false;
    if (i < format.size() && format[i] == '.') {
        ++i;
        const std::size_t decimals = skip_digits();
        if (decimals == 0 || decimals > 2) return false;
        digits += decimals;
    }
    const bool has_unit = i < format.size() && format[i] == 'u';
    if (has_unit) ++i;
    return (digits > 0 || has_unit || has_sign) && i == format.size();
}

class Splitter {
  public:
    Splitter(const SourceFile& file, std::vector<Lexeme>& out) : file_(file), out_(out) {}

    void run(std::uint32_t begin, std::uint32_t end, bool is_closed,
             const std::function<void(std::uint32_t, std::uint32_t)>& lex_piece) {
        const std::string_view text = file_.text;
        const std::uint32_t last = is_closed ? end - 1 : end;
        piece_begin_ = begin;
        std::uint32_t i = begin + 1;
        while (i < last) {
            const char c = text[i];
            const bool is_double = i + 1 < last && text[i + 1] == c;
            if (c == '\\') {
                i = escape(i, last);
            } else if ((c == '{' || c == '}') && is_double) {
                content_ += c;
                i += 2;
            } else if (c == '{') {
                i = value(i, last, lex_piece);
            } else {
                if (c == '}') {
                    file_.sink.report(diag::TextBrace, file_.range(i, i + 1))
                        .arg("}")
                        .fix(file_.range(i, i), "}", "write a brace of the text twice");
                }
                content_ += c;
                ++i;
            }
        }
        emit(has_values_ ? Token::TextClose : Token::Text, end);
    }

  private:
    std::uint32_t escape(std::uint32_t at, std::uint32_t last) {
        const char c = at + 1 < last ? file_.text[at + 1] : '\0';
        switch (c) {
            case 'n': content_ += '\n'; break;
            case 't': content_ += '\t'; break;
            case '"':
            case '\\':
            case '{':
            case '}': content_ += c; break;
            default: {
                std::uint32_t next = at + 1;
                do ++next;
                while (next < last && (file_.text[next] & 0xc0) == 0x80);
                file_.sink.report(diag::TextEscape, file_.range(at, std::min(next, last)))
                    .arg(file_.text.substr(at, std::min(next, last) - at))
                    .fix(file_.range(at, at), "\\", "write a backslash of the text twice");
                return next;
            }
        }
        return at + 2;
    }

    std::uint32_t value(std::uint32_t open, std::uint32_t last,
                        const std::function<void(std::uint32_t, std::uint32_t)>& lex_piece) {
        const std::uint32_t close = closing_brace(file_.text, open, last);
        if (close == last) {
            const std::size_t quote = file_.text.substr(0, last).find("\\\"", open);
            const std::size_t end = file_.text.substr(0, last).find('}', open);
            if (quote < end && end < last) {
                const auto at = static_cast<std::uint32_t>(quote);
                file_.sink.report(diag::TextInnerQuote, file_.range(at, at + 2))
                    .fix(file_.range(at, at + 1), "", "leave out the backslashes");
                return static_cast<std::uint32_t>(end) + 1;
            }
            file_.sink.report(diag::TextBrace, file_.range(open, open + 1))
                .arg("{")
                .fix(file_.range(open, open), "{", "write a brace of the text twice");
            content_ += '{';
            return open + 1;
        }
        emit(has_values_ ? Token::TextMiddle : Token::TextOpen, open + 1);
        has_values_ = true;
        const std::uint32_t colon = format_place(file_.text, open + 1, close);
        lex_piece(open + 1, colon);
        if (colon < close) format(colon, close);
        piece_begin_ = close;
        return close + 1;
    }

    void format(std::uint32_t colon, std::uint32_t close) {
        const std::string_view spelled = file_.text.substr(colon + 1, close - colon - 1);
        if (!is_format(spelled)) {
            file_.sink.report(diag::TextFormat, file_.range(colon, close)).arg(spelled);
            return;
        }
        Lexeme lexeme;
        lexeme.token = Token::Format;
        lexeme.begin = colon;
        lexeme.end = close;
        lexeme.text = file_.texts.intern(spelled);
        out_.push_back(lexeme);
    }

    void emit(Token token, std::uint32_t end) {
        Lexeme lexeme;
        lexeme.token = token;
        lexeme.begin = piece_begin_;
        lexeme.end = end;
        lexeme.text = file_.texts.intern(content_);
        out_.push_back(lexeme);
        content_.clear();
    }

    const SourceFile& file_;
    std::vector<Lexeme>& out_;
    std::string content_;
    std::uint32_t piece_begin_ = 0;
    bool has_values_ = false;
};

}  // namespace

void split_text(const SourceFile& file, std::uint32_t begin, std::uint32_t end, bool is_closed,
                const std::function<void(std::uint32_t, std::uint32_t)>& lex_piece,
                std::vector<Lexeme>& out) {
    Splitter(file, out).run(begin, end, is_closed, lex_piece);
}

std::string raw_lines(std::string_view between) {
    std::vector<std::string_view> lines;
    while (true) {
        const std::size_t end = between.find('\n');
        std::string_view line = between.substr(0, end);
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        lines.push_back(line);
        if (end == std::string_view::npos) break;
        between.remove_prefix(end + 1);
    }
    const auto is_blank = [](std::string_view line) {
        return line.find_first_not_of(" \t") == std::string_view::npos;
    };
    // `raw { G4 }` in one line is that text without its blanks.
    if (lines.size() == 1) {
        const std::size_t first = lines[0].find_first_not_of(" \t");
        if (first == std::string_view::npos) return "";
        return std::string(lines[0].substr(first, lines[0].find_last_not_of(" \t") + 1 - first));
    }
    if (is_blank(lines.front())) lines.erase(lines.begin());
    if (!lines.empty() && is_blank(lines.back())) lines.pop_back();
    std::size_t indent = std::string_view::npos;
    for (std::string_view line : lines) {
        if (!is_blank(line)) indent = std::min(indent, line.find_first_not_of(" \t"));
    }
    std::string joined;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (i > 0) joined += '\n';
        if (!is_blank(lines[i])) joined += lines[i].substr(indent);
    }
    return joined;
}

}  // namespace kadr::syntax
