#include "syntax/format_line.h"

#include <algorithm>
#include <optional>

#include "syntax/words.h"

namespace kadr::syntax {

namespace {

// What it costs to break a line; a level of brackets costs more than any of them.
constexpr int kNever = -1;
constexpr int kHeader = 0;
constexpr int kComma = 10;
constexpr int kWord = 10;
constexpr int kChoice = 24;
constexpr int kFirstWord = 400;
constexpr int kAssignment = 400;
constexpr int kLevel = 1000;

// Brackets that stand further right than this leave too little room behind them.
constexpr std::size_t kLastAlignment = 60;

bool is_open(Token token) {
    return token == Token::OpenParen || token == Token::OpenBracket || token == Token::OpenValue;
}

bool is_close(Token token) { return token == Token::CloseParen || token == Token::CloseBracket; }

bool is_word_start(Token token) {
    return token == Token::LiteralWord || token == Token::BareWord || token == Token::Address;
}

/// Whether an operator is spelled with letters: `not`, `не`.
bool is_word_operator(const LayoutPiece& piece) {
    const auto first = static_cast<unsigned char>(piece.text.empty() ? '-' : piece.text.front());
    return first >= 0x80 || (first >= 'a' && first <= 'z') || (first >= 'A' && first <= 'Z');
}

/// Whether the token can be an operator between two values, and what it costs to break behind it.
int operator_penalty(Token token) {
    switch (token) {
        case Token::OrOr: return 20;
        case Token::AndAnd: return 22;
        case Token::Coalesce: return 26;
        case Token::Less:
        case Token::LessEqual:
        case Token::Greater:
        case Token::GreaterEqual:
        case Token::Equal:
        case Token::NotEqual:
        case Token::Contains: return 28;
        case Token::Plus:
        case Token::Minus:
        case Token::And:
        case Token::Or:
        case Token::Xor:
        case Token::ShiftLeft:
        case Token::ShiftRight: return 30;
        case Token::Percent: return 32;
        case Token::Star:
        case Token::Slash: return 34;
        default: return kNever;
    }
}

bool is_assignment(Token token) {
    switch (token) {
        case Token::Assign:
        case Token::PlusAssign:
        case Token::MinusAssign:
        case Token::StarAssign:
        case Token::SlashAssign:
        case Token::PercentAssign:
        case Token::ShiftLeftAssign:
        case Token::ShiftRightAssign:
        case Token::AndAssign:
        case Token::XorAssign:
        case Token::OrAssign: return true;
        default: return false;
    }
}

/// Whether a value can end here, so that `-` behind it is an operator between two values.
bool ends_value(Token token) {
    switch (token) {
        case Token::Identifier:
        case Token::Number:
        case Token::Text:
        case Token::TextOpen:  // a whole text with values in it
        case Token::CloseParen:
        case Token::CloseBracket:
        case Token::CloseBrace:
        case Token::True:
        case Token::False:
        case Token::LiteralWord:
        case Token::TypeName: return true;
        default: return false;
    }
}

/// The gap in front of a piece.
struct Gap {
    bool has_blank = false;
    bool is_forced = false;   // a new line must begin here
    int penalty = kNever;     // of beginning one
    std::size_t bracket = 0;  // the innermost open bracket: index of its piece + 1; 0: none
};

/// Decides every gap in one pass from left to right.
class Spacing {
  public:
    explicit Spacing(std::span<const LayoutPiece> pieces) : pieces_(pieces) { find_tables(); }
    std::vector<Gap> run();

  private:
    struct Open {
        std::size_t piece;
        Token token;
        int questions = 0;
        bool is_for = false;
    };

    void find_tables();
    bool has_blank(std::size_t i);
    bool blank_behind_unary(std::size_t i) const;
    bool reads_as_unit(std::size_t slash) const;
    int penalty(std::size_t i) const;
    bool is_forced(std::size_t i) const;
    void enter(std::size_t i);

    Token token(std::size_t i) const { return pieces_[i].token; }
    bool in_for() const { return !open_.empty() && open_.back().is_for; }

    std::span<const LayoutPiece> pieces_;
    std::vector<Open> open_;
    std::vector<bool> is_table_ = std::vector<bool>(pieces_.size());  // `{` whose rows stay
    std::vector<bool> is_unary_ = std::vector<bool>(pieces_.size());
    std::vector<bool> is_type_ = std::vector<bool>(pieces_.size());     // part of a type
    std::vector<bool> is_choice_ = std::vector<bool>(pieces_.size());   // `?` or `:` of a choice
    std::vector<bool> is_generic_ = std::vector<bool>(pieces_.size());  // `<` or `>` of `table<t>`
    int questions_ = 0;                                                 // outside of all brackets
};

std::vector<Gap> Spacing::run() {
    std::vector<Gap> gaps(pieces_.size());
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        enter(i);
        Gap& gap = gaps[i];
        const bool closes = !open_.empty() && (is_close(token(i)) || token(i) == Token::CloseBrace);
        gap.bracket = open_.empty() ? 0 : open_.back().piece + 1;
        if (i > 0) {
            gap.has_blank = has_blank(i);
            gap.is_forced = is_forced(i);
            gap.penalty = penalty(i);
            if (gap.penalty != kNever) gap.penalty += kLevel * static_cast<int>(open_.size());
        }
        if (closes) open_.pop_back();
        if (is_open(token(i))) {
            open_.push_back({i, token(i), 0, i > 0 && token(i - 1) == Token::For});
        }
    }
    return gaps;
}

/// The lists whose lines are their author's: those that are assigned, and those whose first row
/// stands below the `{`. Any other list is filled as arguments are: broken inside of a call it
/// would be read as rows the next time, and the call be laid out around them.
void Spacing::find_tables() {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const Token here = token(i);
        if (here == Token::OpenValue) {
            const bool is_assigned = open.empty() && i > 0 && is_assignment(token(i - 1));
            is_table_[i] = is_assigned || pieces_[i + 1].starts_line;
        }
        if (is_open(here)) open.push_back(i);
        if ((is_close(here) || here == Token::CloseBrace) && !open.empty()) open.pop_back();
    }
}

/// What the piece is, as far as its neighbours decide it.
void Spacing::enter(std::size_t i) {
    const Token here = token(i);
    const Token before = i > 0 ? token(i - 1) : Token::EndOfFile;
    const bool behind_type = i > 0 && is_type_[i - 1];
    is_type_[i] = here == Token::TypeName ||
                  (behind_type &&
                   (here == Token::OpenBracket || here == Token::Question || here == Token::And)) ||
                  (here == Token::CloseBracket && !open_.empty() && is_type_[open_.back().piece]);
    int& questions = open_.empty() ? questions_ : open_.back().questions;
    if (here == Token::Question && !is_type_[i]) {
        is_choice_[i] = true;
        ++questions;
    } else if (here == Token::Colon && questions > 0) {
        is_choice_[i] = true;
        --questions;
    }
    is_generic_[i] = (here == Token::Less && before == Token::GenericName) ||
                     (here == Token::Greater && behind_type);
    const bool can_be_sign = here == Token::Plus || here == Token::Minus ||
                             here == Token::PlusPlus || here == Token::MinusMinus ||
                             here == Token::Not || here == Token::Tilde;
    const bool behind_step =
        (before == Token::PlusPlus || before == Token::MinusMinus) && i > 0 && !is_unary_[i - 1];
    const bool skips_block = here == Token::Slash && i == 0;  // `/G1 X5;`
    is_unary_[i] = skips_block || (can_be_sign && !behind_step && (i == 0 || !ends_value(before)));
}

bool Spacing::blank_behind_unary(std::size_t i) const {
    if (is_word_operator(pieces_[i - 1])) return true;
    // `- -a` must not become `--a`.
    const Token here = token(i);
    const Token before = token(i - 1);
    const bool is_minus = before == Token::Minus || before == Token::MinusMinus;
    const bool is_plus = before == Token::Plus || before == Token::PlusPlus;
    return (is_minus && (here == Token::Minus || here == Token::MinusMinus)) ||
           (is_plus && (here == Token::Plus || here == Token::PlusPlus));
}

/// `200mm / min` is a quotient, `200mm/min` a feed.
bool Spacing::reads_as_unit(std::size_t slash) const {
    const bool is_between = slash > 0 && slash + 1 < pieces_.size() &&
                            token(slash - 1) == Token::Number &&
                            token(slash + 1) == Token::Identifier;
    if (!is_between) return false;
    const std::string_view number = pieces_[slash - 1].text;
    const std::size_t unit = number.find_last_of("0123456789.") + 1;
    return find_unit(number.substr(unit), pieces_[slash + 1].text) != Unit::None;
}

bool Spacing::has_blank(std::size_t i) {
    const Token before = token(i - 1);
    const Token here = token(i);
    if (pieces_[i].is_comment() || pieces_[i - 1].is_comment()) return true;
    if (is_unary_[i - 1]) return blank_behind_unary(i);
    if (is_open(before) || before == Token::Dot || before == Token::Tilde) return false;
    switch (here) {
        case Token::Semicolon:
        case Token::Comma:
        case Token::Dot:
        case Token::CloseParen:
        case Token::CloseBracket:
        case Token::CloseBrace: return false;
        case Token::PlusPlus:
        case Token::MinusMinus: return is_unary_[i];
        case Token::OpenBracket: return !ends_value(before);
        case Token::OpenParen:
            switch (before) {
                case Token::Identifier:
                case Token::Mode:
                case Token::CloseParen:
                case Token::CloseBracket:
                case Token::Require:
                case Token::Assert:
                case Token::ErrorWord:
                case Token::Warn:
                case Token::Expect:
                case Token::Assume: return false;
                case Token::Greater: return !is_generic_[i - 1];
                case Token::Star:
                case Token::Slash: return false;
                default: break;
            }
            break;
        default: break;
    }
    if (is_generic_[i] || (is_generic_[i - 1] && before == Token::Less)) return false;
    if (is_type_[i] && is_type_[i - 1]) return false;
    if (before == Token::Address && is_assignment(here)) return false;
    if (i > 1 && token(i - 2) == Token::Address && is_assignment(before)) return false;
    if (here == Token::Colon && !is_choice_[i]) return in_for();
    if ((here == Token::Slash && reads_as_unit(i)) ||
        (before == Token::Slash && reads_as_unit(i - 1))) {
        return true;
    }
    if (here == Token::Star || here == Token::Slash || before == Token::Star ||
        before == Token::Slash) {
        return false;
    }
    if (here == Token::DotDot) {
        return before != Token::Number || i + 1 >= pieces_.size() || token(i + 1) != Token::Number;
    }
    if (before == Token::DotDot) {
        return here != Token::Number || i < 2 || token(i - 2) != Token::Number;
    }
    if (before == Token::Minus && i > 1 && is_unary_[i - 1]) return false;
    return true;
}

bool Spacing::is_forced(std::size_t i) const {
    const LayoutPiece& piece = pieces_[i];
    if (pieces_[i - 1].token == Token::LineComment) return true;
    if (piece.is_comment() && piece.starts_line) return true;
    // The rows of a table stay as they are.
    if (open_.empty() || open_.back().token != Token::OpenValue) return false;
    const std::size_t open = open_.back().piece;
    if (!is_table_[open]) return false;
    if (token(i) == Token::CloseBrace) return pieces_[open + 1].starts_line;
    return piece.starts_line && (i == open + 1 || token(i - 1) == Token::Comma);
}

int Spacing::penalty(std::size_t i) const {
    const Token before = token(i - 1);
    const Token here = token(i);
    if (here == Token::OpenBrace || here == Token::Semicolon || here == Token::Comma ||
        is_close(here) || here == Token::CloseBrace) {
        return kNever;
    }
    if (here == Token::Preserves || here == Token::Over) return kHeader;
    if (before == Token::Comma || before == Token::Semicolon) return kComma;
    if (is_generic_[i] || is_generic_[i - 1] || is_type_[i - 1] || is_unary_[i - 1]) return kNever;
    // A word code alone in a line tells nothing: a long value behind it is broken instead.
    if (is_word_start(here) && i > 0 && !is_open(before) && before != Token::Slash)
        return i == 1 ? kFirstWord : kWord;
    if (is_choice_[i]) return kChoice;
    if (is_assignment(before) && here == Token::OpenValue) return kNever;
    if (is_assignment(before) && (i < 2 || token(i - 2) != Token::Address)) return kAssignment;
    return operator_penalty(before);
}

/// Fills lines from left to right.
class Breaking {
  public:
    Breaking(std::span<const LayoutPiece> pieces, std::size_t indent, std::size_t continuation,
             std::size_t width)
        : pieces_(pieces),
          gaps_(Spacing(pieces).run()),
          indent_(indent),
          continuation_(continuation),
          width_(width),
          behind_(pieces.size()),
          line_indent_(pieces.size()),
          hangs_(pieces.size()) {}

    std::vector<std::string> run();

  private:
    bool fits() const;
    std::size_t column_of(std::size_t first) const;
    std::size_t line_end(std::size_t first, std::size_t column) const;
    void emit(std::size_t first, std::size_t end, std::size_t column);

    std::span<const LayoutPiece> pieces_;
    std::vector<Gap> gaps_;
    std::size_t indent_;
    std::size_t continuation_;
    std::size_t width_;
    std::vector<std::size_t> behind_;       // the column behind a piece
    std::vector<std::size_t> line_indent_;  // of the line that a piece went into
    std::vector<bool> hangs_;               // a bracket with nothing behind it in its line
    std::vector<std::string> lines_;
};

bool Breaking::fits() const {
    std::size_t width = indent_;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        if (gaps_[i].is_forced) return false;
        width += text_width(pieces_[i].text) + (i > 0 && gaps_[i].has_blank ? 1 : 0);
    }
    return width <= width_;
}

std::vector<std::string> Breaking::run() {
    if (!fits()) {
        // A header that does not fit gets its promises in lines of their own.
        for (std::size_t i = 1; i < pieces_.size(); ++i) {
            const Token token = pieces_[i].token;
            if (token == Token::Preserves && gaps_[i].bracket == 0) gaps_[i].is_forced = true;
        }
    }
    for (std::size_t first = 0; first < pieces_.size();) {
        const std::size_t column = column_of(first);
        const std::size_t end = line_end(first, column);
        emit(first, end, column);
        first = end;
    }
    return std::move(lines_);
}

/// Where the line that begins with this piece begins.
std::size_t Breaking::column_of(std::size_t first) const {
    if (first == 0) return indent_;
    const std::size_t bracket = gaps_[first].bracket;
    if (bracket == 0) return indent_ + continuation_;
    const std::size_t open = bracket - 1;
    if (hangs_[open]) {
        const bool closes = pieces_[first].token == Token::CloseBrace;
        return line_indent_[open] + (closes ? 0 : kIndent);
    }
    return behind_[open] <= kLastAlignment ? behind_[open] : indent_ + 2 * kIndent;
}

/// The piece behind the line that begins with `first`.
std::size_t Breaking::line_end(std::size_t first, std::size_t column) const {
    std::size_t width = column;
    std::optional<std::size_t> best;
    for (std::size_t i = first; i < pieces_.size(); ++i) {
        if (i > first) {
            if (gaps_[i].is_forced) return i;
            const int penalty = gaps_[i].penalty;
            if (penalty != kNever && (!best || penalty <= gaps_[*best].penalty)) best = i;
            width += gaps_[i].has_blank ? 1 : 0;
        }
        width += text_width(pieces_[i].text);
        // Where nothing could be broken yet, the first chance behind is taken.
        if (width > width_ && best) return *best;
    }
    return pieces_.size();
}

void Breaking::emit(std::size_t first, std::size_t end, std::size_t column) {
    std::string line(column, ' ');
    for (std::size_t i = first; i < end; ++i) {
        if (i > first && gaps_[i].has_blank) line += ' ';
        line += pieces_[i].text;
        behind_[i] = text_width(line);
        line_indent_[i] = column;
        hangs_[i] = i + 1 == end && is_open(pieces_[i].token);
    }
    lines_.push_back(std::move(line));
}

}  // namespace

std::size_t text_width(std::string_view text) {
    const std::size_t line = text.rfind('\n');
    if (line != std::string_view::npos) text.remove_prefix(line + 1);
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::vector<std::string> format_line(std::span<const LayoutPiece> pieces, std::size_t indent,
                                     std::size_t continuation, std::size_t width) {
    return Breaking(pieces, indent, continuation, width).run();
}

}  // namespace kadr::syntax
