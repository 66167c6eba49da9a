#include "syntax/foreign_statements.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "base/diagnostics/syntax.h"
#include "base/done.h"
#include "syntax/habits.h"
#include "syntax/keyword.h"
#include "syntax/token_kinds.h"

namespace kadr::syntax {

namespace {

/// Lexemes that are looked at for the other bracket of one: more would cost their square where none
/// is closed, and statements of controls are short.
constexpr std::size_t kMostBetween = 10'000;

class Statements {
  public:
    Statements(const SourceFile& file, std::vector<Lexeme> in, const KeywordTable& keywords)
        : file_(file), in_(std::move(in)), keywords_(keywords) {}

    std::vector<Lexeme> run();

  private:
    bool is_start() const;
    bool is_first_of_line() const;
    const Keyword* keyword_in_capitals() const;
    bool is_keyword_here(const Keyword& keyword);
    bool has_body() const;
    bool is_loop_head() const;
    bool ends_do() const;
    bool may_be_element() const;
    Done require_own_statement();
    const Keyword* form_of_control() const;
    bool is_unended() const;
    bool is_other_statement(const Habit& habit) const;

    const Lexeme& at(std::size_t i) const { return in_[i < in_.size() ? i : in_.size() - 1]; }
    bool is_name(std::size_t i) const {
        return at(i).token == Token::Identifier || is_word(at(i).token);
    }
    std::string lower(std::size_t i) const { return lower_ascii(file_.spelling(at(i))); }
    /// Whether nothing stands behind the lexeme in its line.
    bool ends_line(std::size_t i) const {
        return at(i + 1).token == Token::EndOfFile ||
               file_.crosses_line(at(i).end, at(i + 1).begin);
    }
    std::size_t line_end(std::size_t i) const;
    std::size_t mate(std::size_t open) const;

    const SourceFile& file_;
    std::vector<Lexeme> in_;
    const KeywordTable& keywords_;
    std::vector<Lexeme> out_;
    std::size_t i_ = 0;
};

std::vector<Lexeme> Statements::run() {
    out_.reserve(in_.size());
    for (; i_ < in_.size(); ++i_) {
        if (in_[i_].token != Token::Identifier || !is_start()) {
            out_.push_back(in_[i_]);
            continue;
        }
        if (!require_own_statement()) continue;
        const Keyword* keyword = keyword_in_capitals();
        Lexeme lexeme = in_[i_];
        if (keyword != nullptr && is_keyword_here(*keyword)) {
            const std::string small(keyword->name);
            file_.sink.report(diag::KeywordCase, file_.range(lexeme))
                .arg(small)
                .fix(file_.range(lexeme), small, "write it in lower case");
            lexeme.text = file_.texts.intern(small);
        }
        out_.push_back(lexeme);
    }
    return std::move(out_);
}

/// Whether a statement can begin here, behind the number of a block as well.
bool Statements::is_start() const {
    if (out_.empty()) return true;
    const Lexeme& before = out_.back();
    switch (before.token) {
        case Token::Semicolon:
        case Token::OpenBrace:
        case Token::CloseBrace:
        case Token::CloseParen:
        case Token::Colon: return true;
        case Token::Identifier: return lower_ascii(file_.texts.text(before.text)) == "else";
        case Token::LiteralWord: return file_.texts.text(before.text) == "N" && is_first_of_line();
        default: return false;
    }
}

/// Whether the present lexeme is the first of its line, the number of a block not counted.
bool Statements::is_first_of_line() const {
    std::size_t first = i_;
    const bool has_number = first > 0 && at(first - 1).token == Token::LiteralWord &&
                            file_.texts.text(at(first - 1).text) == "N" && !ends_line(first - 1);
    if (has_number) --first;
    return first == 0 || ends_line(first - 1);
}

/// The last lexeme of the line that is no `;` at its end.
std::size_t Statements::line_end(std::size_t i) const {
    while (!ends_line(i) && at(i + 1).token != Token::Semicolon) ++i;
    return i;
}

/// The bracket that closes the one at `open`; the end of the file if none near does.
std::size_t Statements::mate(std::size_t open) const {
    std::size_t depth = 0;
    for (std::size_t i = open; i < std::min(in_.size(), open + kMostBetween); ++i) {
        if (opens(at(i).token)) ++depth;
        if (closes(at(i).token) && --depth == 0) return i;
    }
    return in_.size() - 1;
}

// ---------------------------------------------------------------- keywords in capitals

/// `for` of `FOR` and `For`; null if there is no such keyword in the file's language.
const Keyword* Statements::keyword_in_capitals() const {
    const std::string_view spelled = file_.spelling(in_[i_]);
    const std::string small = lower_ascii(spelled);
    if (small == spelled || keywords_.canonical.contains(std::string(spelled))) return nullptr;
    const auto found = keywords_.canonical.find(small);
    const Keyword* keyword = found == keywords_.canonical.end() ? nullptr : find_keyword(small);
    return keyword != nullptr && keyword->context == Keyword::Context::Anywhere ? keyword : nullptr;
}

/// Whether what follows can follow the keyword and no name: of a function, a variable or a type.
bool Statements::is_keyword_here(const Keyword& keyword) {
    const Lexeme& next = at(i_ + 1);
    switch (keyword.token) {
        case Token::For: return is_loop_head();
        case Token::Do: return next.token == Token::OpenBrace;
        case Token::Else: return next.token == Token::OpenBrace || lower(i_ + 1) == "if";
        case Token::While: return ends_do() || has_body();
        case Token::If:
        case Token::Switch: return has_body();
        case Token::Case: return next.token == Token::Number || next.token == Token::Text;
        case Token::Default: return next.token == Token::Colon;
        case Token::Return: return next.token == Token::Number || next.token == Token::Text;
        default: return false;
    }
}

/// `IF (n > 3) M8;`: behind a call stands no block and no name. Not `IF (n > 3) GOTO 10;`.
bool Statements::has_body() const {
    if (at(i_ + 1).token != Token::OpenParen) return false;
    const std::size_t body = mate(i_ + 1) + 1;
    if (at(body).token == Token::OpenBrace || is_word(at(body).token)) return true;
    const Habit* habit = habit_of(file_.spelling(at(body)));
    return at(body).token == Token::Identifier && (habit == nullptr || !habit->is_statement);
}

/// `FOR (int i = 0; i < 5; i++)`, `FOR (length x : list)`: no call has such arguments.
bool Statements::is_loop_head() const {
    if (at(i_ + 1).token != Token::OpenParen) return false;
    std::size_t depth = 0;
    const std::size_t end = std::min(in_.size(), i_ + kMostBetween);
    for (std::size_t i = i_ + 1; i < end && at(i).token != Token::OpenBrace; ++i) {
        if (opens(at(i).token)) ++depth;
        if (closes(at(i).token) && --depth == 0) return false;
        const bool is_list =
            at(i).token == Token::Colon && i == i_ + 4 && at(i_ + 2).token == Token::Identifier;
        if (depth == 1 && (at(i).token == Token::Semicolon || is_list)) return is_name(i_ + 2);
    }
    return false;
}

/// `} WHILE (…);` behind a `do {`.
bool Statements::ends_do() const {
    const bool follows_brace = !out_.empty() && out_.back().token == Token::CloseBrace;
    if (at(i_ + 1).token != Token::OpenParen || !follows_brace) return false;
    std::size_t depth = 0;
    const std::size_t first = out_.size() - std::min(out_.size(), kMostBetween);
    for (std::size_t i = out_.size(); i-- > first;) {
        if (closes(out_[i].token)) ++depth;
        if (!opens(out_[i].token) || --depth > 0) continue;
        if (i == 0 || out_[i - 1].token != Token::Identifier) return false;
        const auto word = keywords_.canonical.find(std::string(file_.texts.text(out_[i - 1].text)));
        return word != keywords_.canonical.end() && word->second == "do";
    }
    return false;
}

// ---------------------------------------------------------------- statements that are left out

/// Whether the value of a list may stand here: `{` or `:` in front of it need not be of statements.
bool Statements::may_be_element() const {
    if (out_.empty()) return false;
    const Token before = out_.back().token;
    const bool opens_body = before == Token::OpenBrace && out_.size() > 1 &&
                            out_[out_.size() - 2].token == Token::CloseParen;
    return before == Token::Colon || (before == Token::OpenBrace && !opens_body);
}

/// The statement of a control that begins here: it is reported, and left out to the end of its
/// line.
Done Statements::require_own_statement() {
    // `n = 2; ENDIF`: a word alone behind another statement as well.
    if ((!is_first_of_line() && !ends_line(i_)) || may_be_element()) return kDone;
    const Lexeme& first = in_[i_];
    const std::size_t last = line_end(i_);
    if (const Keyword* keyword = form_of_control()) {
        bool jumps = false;
        for (std::size_t i = i_; i <= last; ++i) jumps |= lower(i).starts_with("goto");
        file_.sink.report(diag::KeywordCase, file_.range(first))
            .arg(keyword->name)
            .fix(form_of_statement(keyword->name, jumps));
    } else {
        const Habit* habit = habit_of(file_.spelling(first));
        if (habit == nullptr || !is_other_statement(*habit)) return kDone;
        file_.sink.report(diag::ForeignStatement, file_.range(first))
            .arg(file_.spelling(first))
            .fix(std::string(habit->hint));
    }
    Lexeme end = at(last + 1);
    if (end.token != Token::Semicolon || ends_line(last)) {
        end = {};
        end.token = Token::Semicolon;
        end.begin = end.end = at(last).end;
        i_ = last;
    } else {
        i_ = last + 1;
    }
    end.is_repair = true;
    out_.push_back(end);
    return kFailed;
}

/// `IF [#1 EQ 5] GOTO 10`, `WHILE [n LT 7] DO1;`, and a line without `;` and body, `FOR n=1 TO 5`
/// or `IF (n > 3) THEN`: the keyword. Null: it may be something else.
const Keyword* Statements::form_of_control() const {
    const Keyword* keyword = keyword_in_capitals();
    if (keyword == nullptr) return nullptr;
    if (keyword->token == Token::Else && ends_line(i_) && is_unended()) return find_keyword("if");
    if (form_of_statement(keyword->name, false).empty()) return nullptr;
    if (!opens(at(i_ + 1).token)) return is_unended() ? keyword : nullptr;
    const std::size_t close = mate(i_ + 1);
    const std::string behind = lower(close + 1);
    const bool is_bracket = at(i_ + 1).token == Token::OpenBracket;
    if (behind.starts_with("goto")) return keyword;
    if (is_bracket && (behind.starts_with("then") || behind.starts_with("do"))) return keyword;
    const bool is_head = ends_line(close) || (behind == "then" && ends_line(close + 1));
    return is_head && is_unended() ? keyword : nullptr;
}

/// Whether the statement has no `;` and cannot go on in the next line.
bool Statements::is_unended() const {
    const std::size_t last = line_end(i_);
    if (!ends_line(last)) return false;
    for (std::size_t i = i_; i <= last; ++i) {
        if (at(i).token == Token::OpenBrace || at(i).token == Token::CloseBrace) return false;
    }
    const Lexeme& next = at(last + 1);
    const bool begins = is_name(last + 1) || next.token == Token::CloseBrace ||
                        next.token == Token::EndOfFile || next.token == Token::OpenParen;
    return begins && file_.lines.indent(next.begin) <= file_.lines.line_indent(in_[i_].begin);
}

/// A jump or a word of another language where no name of the program can stand.
bool Statements::is_other_statement(const Habit& habit) const {
    // `include` has a message of its own.
    if (!habit.is_statement || habit.word == "include") return false;
    const Token next = at(i_ + 1).token;
    const bool is_jump = lower(i_).starts_with("goto") && !ends_line(i_) &&
                         (next == Token::Number || next == Token::LiteralWord);
    if (is_jump) return true;
    // A name of the program may be spelled so: `end = 3`, `loop.count`.
    const bool may_be_name = next == Token::Assign || next == Token::Dot ||
                             next == Token::OpenBracket || next == Token::OpenParen;
    return (ends_line(i_) || !may_be_name) && is_unended();
}

}  // namespace

std::vector<Lexeme> mend_statements(const SourceFile& file, std::vector<Lexeme> lexemes,
                                    const KeywordTable& keywords) {
    return Statements(file, std::move(lexemes), keywords).run();
}

}  // namespace kadr::syntax
