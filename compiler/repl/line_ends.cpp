#include "repl/line_ends.h"

#include <algorithm>
#include <vector>

#include "repl/transcript.h"

namespace kadr::repl {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";

/// What opens a bracket: statements or members, or values.
enum class Opened : std::uint8_t { Braces, Values };

/// Walks a text and finds where statements end without `;`.
class Walk {
  public:
    Walk(driver::Session& session, std::string_view headers, const std::string& text)
        : session_(session), headers_(headers), text_(text) {}

    std::string ended() {
        for (std::size_t at = 0; at < text_.size();) at = step(at);
        for (auto place = places_.rbegin(); place != places_.rend(); ++place)
            text_.insert(*place, ";");
        return std::move(text_);
    }

  private:
    /// One character, text or comment; gives where the next one is.
    std::size_t step(std::size_t at) {
        const std::size_t past = past_quoted(text_, at);
        if (past > at) {
            if (text_[at] == '"') code_end_ = past;
            return past;
        }
        const char c = text_[at];
        const bool is_of_values = is_in_values();  // a `}` here
        switch (c) {
            case '\n':
                if (is_in_braces() && !goes_on(at)) end_statement();
                return at + 1;
            case '}':
                if (is_in_braces()) end_statement();
                [[fallthrough]];
            case ')':
            case ']':
                if (!open_.empty()) open_.pop_back();
                break;
            case '{': open_.push_back(opens_values() ? Opened::Values : Opened::Braces); break;
            case '(':
            case '[': open_.push_back(Opened::Values); break;
            default: break;
        }
        if (kBlanks.find(c) != std::string_view::npos) return at + 1;
        code_end_ = at + 1;
        const bool ends = (c == ';' && !is_in_values()) || (c == '{' && is_in_braces()) ||
                          (c == '}' && !is_of_values);
        if (ends) begin_ = at + 1;
        return at + 1;
    }

    bool is_in_braces() const { return !open_.empty() && open_.back() == Opened::Braces; }
    bool is_in_values() const { return !open_.empty() && open_.back() == Opened::Values; }

    /// Whether a `{` here begins a list of values: `= {1mm, 2mm}`.
    bool opens_values() const {
        if (is_in_values()) return true;
        const char before = code_end_ == 0 ? ' ' : text_[code_end_ - 1];
        return before == '=';
    }

    /// Whether the next line cannot begin a statement: it goes on with an operator.
    bool goes_on(std::size_t line_end) const {
        const std::size_t next = text_.find_first_not_of(kBlanks, line_end);
        if (next == std::string::npos) return false;
        const std::string_view rest = std::string_view(text_).substr(next);
        const bool is_step = rest.starts_with("++") || rest.starts_with("--");
        return !is_step && std::string_view("+-*%?:.,&|^<>=){[").find(rest[0]) != rest.npos;
    }

    /// Puts a `;` behind what stands since the last end, if that is a whole statement.
    void end_statement() {
        if (code_end_ <= begin_) return;
        std::string piece = text_.substr(begin_, code_end_ - begin_);
        piece.erase(0, std::min(piece.find_first_not_of(kBlanks), piece.size()));
        // The body of `else` is a statement of its own.
        const std::string word = else_word(session_, headers_);
        if (piece.starts_with(word) && piece.size() > word.size() &&
            kBlanks.find(piece[word.size()]) != std::string_view::npos)
            piece.erase(0, word.size());
        if (!is_whole_statement(session_, headers_, piece)) return;
        places_.push_back(code_end_);
        begin_ = code_end_;
    }

    driver::Session& session_;
    std::string_view headers_;
    std::string text_;
    std::vector<Opened> open_;
    std::vector<std::size_t> places_;  // of the `;`
    std::size_t begin_ = 0;            // behind the last statement that has an end
    std::size_t code_end_ = 0;         // behind the last character that is no blank or comment
};

}  // namespace

std::string with_line_ends(driver::Session& session, std::string_view headers,
                           const std::string& text) {
    if (text.find('{') == std::string::npos || can_be_read(session, headers, text)) return text;
    std::string ended = Walk(session, headers, text).ended();
    const bool is_better = can_be_read(session, headers, ended) ||
                           mistakes(session, headers, ended) < mistakes(session, headers, text);
    return is_better ? ended : text;
}

}  // namespace kadr::repl
