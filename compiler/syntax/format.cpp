#include "syntax/format.h"

#include <algorithm>

#include "base/assert.h"
#include "base/text.h"
#include "syntax/format_line.h"
#include "syntax/lex.h"
#include "syntax/prepare.h"
#include "syntax/print.h"

namespace kadr::syntax {

namespace {

/// Between the longest line of a run and the comments behind it.
constexpr std::size_t kCommentGap = 4;
/// Of a line that must not be broken.
constexpr std::size_t kNoLimit = SIZE_MAX;

struct OutLine {
    std::string code;
    std::string comment;  // behind the code
};

/// A recursive walk over statements; it trusts that the file was parsed without a mistake.
class Formatting {
  public:
    explicit Formatting(std::vector<LayoutPiece> pieces) : pieces_(std::move(pieces)) {}

    std::string run();

  private:
    using Pieces = std::vector<LayoutPiece>;

    void declarations();
    void statements(std::size_t level);
    void statement(std::size_t level);
    void controlled(Pieces head, std::size_t level);
    void block(Pieces head, std::size_t level);
    bool one_line_block(Pieces& head, std::size_t level);
    void values_block(Pieces head, std::size_t level);
    void switch_cases(std::size_t level);
    void do_statement(std::size_t level);
    bool join_while(std::size_t level);
    void simple(Pieces head, std::size_t level);

    Pieces take_head();
    Pieces take_simple();
    void take_parentheses(Pieces& head);
    std::optional<std::size_t> simple_end(std::size_t at) const;
    std::size_t block_end(std::size_t open) const;
    bool is_block_of_words(std::size_t at) const;
    bool is_allowed_line() const;
    bool whole_line(std::size_t level);

    std::vector<std::string> in_lines(const Pieces& pieces, std::size_t level,
                                      std::size_t continuation = kIndent) const {
        return format_line(pieces, level * kIndent, continuation, width_);
    }
    /// All of it, however long that becomes.
    static std::string in_one_line(const Pieces& pieces) {
        return format_line(pieces, 0, kIndent, kNoLimit).front();
    }
    void comments(std::size_t level);
    void trailing_comment();
    void emit(const Pieces& pieces, std::size_t level, std::size_t continuation = kIndent);
    void blank_line();
    std::string joined() const;

    const LayoutPiece& here() const { return pieces_[at_]; }
    bool is(Token token) const { return here().token == token; }
    LayoutPiece take() { return pieces_[at_++]; }
    bool is_end() const { return is(Token::EndOfFile) || is(Token::CloseBrace); }

    Pieces pieces_;
    std::size_t at_ = 0;
    std::size_t width_ = kLineWidth;
    std::vector<OutLine> lines_;
};

std::string Formatting::run() {
    declarations();
    return joined();
}

// ---------------------------------------------------------------- file level

void Formatting::declarations() {
    bool last_is_long = false;  // the declaration before has a body in lines of its own
    bool has_comments = false;  // the present one has lines of comment in front of it
    std::size_t begin = 0;      // the first line of the present one, with its comments
    while (!is(Token::EndOfFile)) {
        if (!has_comments) begin = lines_.size();
        if (here().is_comment()) {
            if (here().follows_blank && !lines_.empty()) {
                blank_line();
                if (!has_comments) begin = lines_.size();
            }
            has_comments = true;
            emit({take()}, 0);
            continue;
        }
        if (here().follows_blank) blank_line();
        if (!has_comments) begin = lines_.size();
        const std::size_t first = lines_.size();
        const bool is_repeat = is(Token::Semicolon);
        statement(0);
        if (is_repeat) continue;
        const bool is_long = lines_.size() > first + 1 && lines_.back().code == "}";
        const bool needs_blank =
            (is_long || last_is_long) && begin > 0 && !lines_[begin - 1].code.empty();
        // A comment that stands close to its declaration stays there.
        if (needs_blank) lines_.insert(lines_.begin() + static_cast<long>(begin), OutLine{});
        last_is_long = is_long;
        has_comments = false;
    }
}

// ---------------------------------------------------------------- statements

void Formatting::statements(std::size_t level) {
    bool is_first = true;
    while (!is_end()) {
        if (here().follows_blank && !is_first) blank_line();
        is_first = false;
        if (here().is_comment()) {
            emit({take()}, level);
        } else {
            statement(level);
        }
    }
}

void Formatting::statement(std::size_t level) {
    // What a comment silences is a line: its statements stay together, however long it is.
    width_ = is_allowed_line() ? kNoLimit : kLineWidth;
    if (width_ == kNoLimit && whole_line(level)) return;
    switch (here().token) {
        case Token::OpenBrace: return block({}, level);
        case Token::If:
        case Token::While:
        case Token::For: return controlled({}, level);
        case Token::Do: return do_statement(level);
        default: return simple({}, level);
    }
}

/// A statement with its words, up to `;` or with a block behind.
void Formatting::simple(Pieces head, std::size_t level) {
    const bool had_head = !head.empty();
    const bool is_enum = is(Token::Enum);
    const bool is_switch = is(Token::Switch);
    const bool is_words = is_block_of_words(at_);
    const Pieces own = take_head();
    head.insert(head.end(), own.begin(), own.end());
    // Behind a `;` stands a block of its own.
    const Token last = head.back().token;
    const bool is_over =
        last == Token::Semicolon || last == Token::RawText || last == Token::Include;
    if (is(Token::OpenBrace) && !is_over) {
        if (is_enum) return values_block(std::move(head), level);
        if (is_switch) {
            head.push_back(take());
            emit(head, level, 2 * kIndent);
            trailing_comment();
            switch_cases(level + 1);
            emit({take()}, level);
            return trailing_comment();
        }
        return block(std::move(head), level);
    }
    // NC blocks that share a line in the source go on doing so.
    while (is_words && !had_head && !here().starts_line && is_block_of_words(at_)) {
        const auto end = simple_end(at_);
        if (!end) break;
        Pieces longer = head;
        for (std::size_t i = at_; i < *end; ++i) longer.push_back(pieces_[i]);
        if (in_lines(longer, level).size() > 1) break;
        head = std::move(longer);
        at_ = *end;
    }
    emit(head, level);
    trailing_comment();
}

/// `if (…)`, `while (…)`, `for (…)` and `else` with what they control.
void Formatting::controlled(Pieces head, std::size_t level) {
    while (true) {
        const bool is_if = is(Token::If);
        head.push_back(take());
        take_parentheses(head);
        const bool is_commented = here().is_comment();
        if (is(Token::OpenBrace)) {
            block(std::move(head), level);
        } else if (const auto end = is_commented ? std::nullopt : simple_end(at_)) {
            Pieces whole = head;
            for (std::size_t i = at_; i < *end; ++i) whole.push_back(pieces_[i]);
            if (in_lines(whole, level).size() == 1) {
                at_ = *end;
                emit(whole, level);
                trailing_comment();
            } else {
                emit(head, level, 2 * kIndent);
                simple({}, level + 1);
            }
        } else {
            emit(head, level, 2 * kIndent);
            trailing_comment();
            while (here().is_comment()) emit({take()}, level + 1);
            statement(level + 1);
        }
        if (!is_if) return;
        std::size_t next = at_;
        while (pieces_[next].is_comment()) ++next;
        if (pieces_[next].token != Token::Else) return;
        while (here().is_comment()) emit({take()}, level);
        head = {take()};
        // `} else {` is one line.
        if (!lines_.empty() && lines_.back().code == std::string(level * kIndent, ' ') + "}" &&
            lines_.back().comment.empty()) {
            lines_.pop_back();
            LayoutPiece brace;
            brace.token = Token::CloseBrace;
            brace.text = "}";
            head.insert(head.begin(), brace);
        }
        if (is(Token::If)) continue;
        break;
    }
    if (is(Token::OpenBrace)) return block(std::move(head), level);
    if (const auto end = here().is_comment() ? std::nullopt : simple_end(at_)) {
        return simple(std::move(head), level);
    }
    if (here().is_comment() || is(Token::Do)) {
        emit(head, level);
        trailing_comment();
        while (here().is_comment()) emit({take()}, level + 1);
        return statement(level + 1);
    }
    controlled(std::move(head), level);
}

void Formatting::do_statement(std::size_t level) {
    Pieces head = {take()};
    const std::size_t before = lines_.size();
    const bool is_block = is(Token::OpenBrace);
    if (is_block) {
        block(std::move(head), level);
    } else {
        emit(head, level);
        trailing_comment();
        while (here().is_comment()) emit({take()}, level + 1);
        statement(level + 1);
    }
    if (is_block && lines_.size() == before + 1 && join_while(level)) return;
    while (here().is_comment()) emit({take()}, level);
    Pieces tail;
    if (lines_.back().code == std::string(level * kIndent, ' ') + "}" &&
        lines_.back().comment.empty()) {
        lines_.pop_back();
        LayoutPiece brace;
        brace.token = Token::CloseBrace;
        brace.text = "}";
        tail.push_back(brace);
    }
    const Pieces own = take_head();
    tail.insert(tail.end(), own.begin(), own.end());
    emit(tail, level);
    trailing_comment();
}

/// `do { … } while (…);` is one line where its block is and the whole fits.
bool Formatting::join_while(std::size_t level) {
    if (here().is_comment() || !lines_.back().comment.empty()) return false;
    const std::size_t mark = at_;
    const Pieces own = take_head();
    const std::vector<std::string> tail = in_lines(own, level);
    const std::string& line = lines_.back().code;
    const bool fits =
        tail.size() == 1 &&
        count_code_points(line) + count_code_points(tail[0]) - level * kIndent < width_;
    if (!fits || std::ranges::any_of(own, &LayoutPiece::is_comment)) {
        at_ = mark;
        return false;
    }
    lines_.back().code += ' ' + tail[0].substr(level * kIndent);
    trailing_comment();
    return true;
}

/// `{ … }` behind a head; a `;` behind it belongs to it.
void Formatting::block(Pieces head, std::size_t level) {
    if (one_line_block(head, level)) return;
    head.push_back(take());
    if (is(Token::CloseBrace)) {
        head.push_back(take());
        if (is(Token::Semicolon)) head.push_back(take());
        emit(head, level, 2 * kIndent);
        return trailing_comment();
    }
    emit(head, level, 2 * kIndent);
    trailing_comment();
    statements(level + 1);
    Pieces tail = {take()};
    if (is(Token::Semicolon)) tail.push_back(take());
    emit(tail, level);
    trailing_comment();
}

/// A block that its author wrote in one line stays there if it fits and holds simple statements.
bool Formatting::one_line_block(Pieces& head, std::size_t level) {
    const std::size_t end = block_end(at_);
    if (end == at_ + 2) return false;
    for (std::size_t i = at_ + 1; i < end; ++i) {
        if (pieces_[i].starts_line || pieces_[i].is_comment()) return false;
    }
    for (std::size_t i = at_ + 1; i + 1 < end;) {
        const auto next = simple_end(i);
        if (!next) return false;
        i = *next;
    }
    // The braces of statements in one line have blanks inside: they are joined by hand.
    Pieces open = head;
    open.push_back(pieces_[at_]);
    const std::vector<std::string> front = in_lines(open, level, 2 * kIndent);
    if (front.size() > 1) return false;
    std::string line = front.front();
    for (std::size_t i = at_ + 1; i + 1 < end;) {
        const auto next = simple_end(i);
        const Pieces part(pieces_.begin() + static_cast<long>(i),
                          pieces_.begin() + static_cast<long>(*next));
        line += ' ' + in_one_line(part);
        i = *next;
    }
    line += " }";
    std::size_t behind = end;
    if (pieces_[behind].token == Token::Semicolon) {
        line += ';';
        ++behind;
    }
    if (text_width(line) > width_) return false;
    at_ = behind;
    lines_.push_back({std::move(line), {}});
    trailing_comment();
    return true;
}

/// The names of an enum: in one line as their author wrote them, or one a line.
void Formatting::values_block(Pieces head, std::size_t level) {
    const std::size_t end = block_end(at_);
    bool is_short = true;
    for (std::size_t i = at_ + 1; i < end; ++i) {
        is_short &= !pieces_[i].starts_line && !pieces_[i].is_comment();
    }
    Pieces whole = head;
    for (std::size_t i = at_; i < end; ++i) whole.push_back(pieces_[i]);
    head.push_back(take());
    if (is_short && end > at_ + 1) {
        const Pieces names(pieces_.begin() + static_cast<long>(at_),
                           pieces_.begin() + static_cast<long>(end - 1));
        const std::string line =
            std::string(level * kIndent, ' ') + in_one_line(head) + ' ' + in_one_line(names) + " }";
        if (text_width(line) <= width_) {
            at_ = end;
            lines_.push_back({line, {}});
            return trailing_comment();
        }
    }
    emit(head, level);
    trailing_comment();
    while (!is_end()) {
        if (here().is_comment()) {
            emit({take()}, level + 1);
            continue;
        }
        Pieces name;
        while (!is_end() && !here().is_comment()) {
            name.push_back(take());
            if (name.back().token == Token::Comma) break;
        }
        emit(name, level + 1);
        trailing_comment();
    }
    emit({take()}, level);
    trailing_comment();
}

void Formatting::switch_cases(std::size_t level) {
    bool is_first = true;
    while (!is_end()) {
        if (here().follows_blank && !is_first) blank_line();
        is_first = false;
        if (here().is_comment()) {
            // In front of a label it belongs to the label, else to the statements above.
            std::size_t next = at_;
            while (pieces_[next].is_comment()) ++next;
            const Token behind = pieces_[next].token;
            const bool is_label = behind == Token::Case || behind == Token::Default;
            emit({take()}, is_label ? level : level + 1);
            continue;
        }
        if (!is(Token::Case) && !is(Token::Default)) {
            statement(level + 1);
            continue;
        }
        Pieces label;
        int questions = 0;
        for (int depth = 0;;) {
            const Token token = here().token;
            if (token == Token::OpenParen || token == Token::OpenBracket) ++depth;
            if (token == Token::CloseParen || token == Token::CloseBracket) --depth;
            if (token == Token::Question) ++questions;
            label.push_back(take());
            if (token != Token::Colon || depth > 0) continue;
            if (questions == 0) break;
            --questions;
        }
        if (is(Token::OpenBrace) && !here().starts_line) {
            block(std::move(label), level);
            continue;
        }
        // `case 1: X5; break;` stays in one line if its author wrote it so.
        const std::size_t behind_label = at_;
        const std::size_t label_size = label.size();
        while (!here().starts_line && !is_end() && !here().is_comment()) {
            const auto end = simple_end(at_);
            if (!end) break;
            Pieces longer = label;
            for (std::size_t i = at_; i < *end; ++i) longer.push_back(pieces_[i]);
            if (in_lines(longer, level).size() > 1) break;
            label = std::move(longer);
            at_ = *end;
        }
        // All of them or none: the rest of a line would stand below what it follows.
        const bool is_whole = here().starts_line || here().is_comment() || is_end() ||
                              is(Token::Case) || is(Token::Default);
        if (!is_whole) {
            at_ = behind_label;
            label.resize(label_size);
        }
        emit(label, level);
        trailing_comment();
    }
}

// ---------------------------------------------------------------- reading pieces

/// Up to the `;` that ends it, or to the `{` of its block.
Formatting::Pieces Formatting::take_head() {
    Pieces out;
    int depth = 0;
    while (!is(Token::EndOfFile)) {
        const Token token = here().token;
        if (depth == 0 && token == Token::OpenBrace) return out;
        if (token == Token::OpenParen || token == Token::OpenBracket || token == Token::OpenValue) {
            ++depth;
        }
        if (token == Token::CloseParen || token == Token::CloseBracket ||
            token == Token::CloseBrace) {
            --depth;
        }
        out.push_back(take());
        const bool is_end =
            token == Token::Semicolon || token == Token::RawText || token == Token::Include;
        if (depth == 0 && is_end) return out;
    }
    return out;
}

void Formatting::take_parentheses(Pieces& head) {
    int depth = 0;
    do {
        const Token token = here().token;
        if (token == Token::OpenParen || token == Token::OpenBracket || token == Token::OpenValue) {
            ++depth;
        }
        if (token == Token::CloseParen || token == Token::CloseBracket ||
            token == Token::CloseBrace) {
            --depth;
        }
        head.push_back(take());
    } while (depth > 0 || head.back().is_comment());
}

/// The piece behind a statement that has no block and no comment inside: it can share a line. An
/// `if` with an `else` cannot.
std::optional<std::size_t> Formatting::simple_end(std::size_t at) const {
    switch (pieces_[at].token) {
        case Token::OpenBrace:
        case Token::CloseBrace:
        case Token::EndOfFile:
        case Token::Do:
        case Token::Case:
        case Token::Default: return std::nullopt;
        default: break;
    }
    bool is_if = false;
    while (pieces_[at].token == Token::If || pieces_[at].token == Token::While ||
           pieces_[at].token == Token::For) {
        is_if |= pieces_[at].token == Token::If;
        int depth = 0;
        do {
            ++at;
            if (pieces_[at].is_comment()) return std::nullopt;
            if (pieces_[at].token == Token::OpenParen) ++depth;
            if (pieces_[at].token == Token::CloseParen) --depth;
        } while (depth > 0);
        ++at;
        if (pieces_[at].token == Token::OpenBrace || pieces_[at].token == Token::Do) {
            return std::nullopt;
        }
    }
    int depth = 0;
    for (;; ++at) {
        const Token token = pieces_[at].token;
        if (pieces_[at].is_comment() || token == Token::OpenBrace || token == Token::RawText ||
            token == Token::EndOfFile) {
            return std::nullopt;
        }
        if (token == Token::OpenParen || token == Token::OpenBracket || token == Token::OpenValue) {
            ++depth;
        }
        if (token == Token::CloseParen || token == Token::CloseBracket ||
            token == Token::CloseBrace) {
            --depth;
        }
        if (depth == 0 && token == Token::Semicolon) break;
    }
    ++at;
    std::size_t next = at;
    while (pieces_[next].is_comment()) ++next;
    if (is_if && pieces_[next].token == Token::Else) return std::nullopt;
    return at;
}

/// The piece behind the `}` of a block.
std::size_t Formatting::block_end(std::size_t open) const {
    int depth = 0;
    std::size_t i = open;
    do {
        const Token token = pieces_[i].token;
        if (token == Token::OpenBrace || token == Token::OpenValue) ++depth;
        if (token == Token::CloseBrace) --depth;
        ++i;
    } while (depth > 0);
    return i;
}

bool Formatting::is_block_of_words(std::size_t at) const {
    const Token token = pieces_[at].token;
    return token == Token::LiteralWord || token == Token::BareWord || token == Token::Address;
}

/// Whether a comment silences warnings of the line in the source where the next piece stands.
bool Formatting::is_allowed_line() const {
    const bool is_below = at_ > 0 && here().starts_line && !here().follows_blank &&
                          pieces_[at_ - 1].starts_line && pieces_[at_ - 1].is_allowance();
    if (is_below) return true;
    std::size_t end = at_;
    while (pieces_[end].token != Token::EndOfFile && (end == at_ || !pieces_[end].starts_line))
        ++end;
    return pieces_[end - 1].is_allowance();
}

/// The simple statements up to the end of the line, in one line.
bool Formatting::whole_line(std::size_t level) {
    std::size_t end = at_;
    do {
        const auto next = simple_end(end);
        if (!next) return false;
        end = *next;
    } while (!pieces_[end].starts_line && !pieces_[end].is_comment() &&
             pieces_[end].token != Token::CloseBrace && pieces_[end].token != Token::EndOfFile);
    const Pieces line(pieces_.begin() + static_cast<long>(at_),
                      pieces_.begin() + static_cast<long>(end));
    at_ = end;
    emit(line, level);
    trailing_comment();
    return true;
}

// ---------------------------------------------------------------- writing lines

/// A comment in the line of what was just written goes behind it.
void Formatting::trailing_comment() {
    if (!here().is_comment() || here().starts_line || lines_.empty()) return;
    // Another statement behind it in the same line would be cut off by a line comment only.
    if (here().token == Token::BlockComment && !pieces_[at_ + 1].starts_line &&
        pieces_[at_ + 1].token != Token::EndOfFile) {
        return;
    }
    lines_.back().comment = take().text;
}

void Formatting::emit(const Pieces& pieces, std::size_t level, std::size_t continuation) {
    for (std::string& line : in_lines(pieces, level, continuation)) {
        lines_.push_back({std::move(line), {}});
    }
}

void Formatting::blank_line() {
    if (!lines_.empty() && !(lines_.back().code.empty() && lines_.back().comment.empty())) {
        lines_.push_back({});
    }
}

/// The lines with the comments behind them, aligned in runs of neighbours.
std::string Formatting::joined() const {
    std::string out;
    for (std::size_t i = 0; i < lines_.size();) {
        std::size_t end = i;
        std::size_t column = 0;
        while (end < lines_.size() && !lines_[end].comment.empty()) {
            column = std::max(column, text_width(lines_[end].code));
            ++end;
        }
        for (; i < end; ++i) {
            const std::size_t width = text_width(lines_[i].code);
            out += lines_[i].code + std::string(column - width + kCommentGap, ' ') +
                   lines_[i].comment + '\n';
        }
        if (i < lines_.size()) out += lines_[i++].code + '\n';
    }
    return out;
}

/// The pieces of a text that was parsed without a mistake.
std::vector<LayoutPiece> pieces_of(const Sources& sources, FileId id, const KeywordTable& keywords,
                                   const nc::Dialect& dialect) {
    LimitedSink limit;
    const std::optional<std::string> clean = clean_text(id, sources.text(id), limit);
    std::vector<std::string> texts(1);
    Interner interner(texts);
    const LineStarts lines(*clean);
    const SourceFile file{id, *clean, limit, interner, lines};
    std::vector<Comment> comments;
    auto prepared = prepare(file, keywords, dialect, limit, comments);
    std::erase_if(prepared->lexemes,
                  [](const Lexeme& lexeme) { return lexeme.token == Token::NoArgument; });
    return pieces_of(file, prepared->lexemes, comments);
}

}  // namespace

std::optional<std::string> format(const Sources& sources, FileId file, const KeywordTable& keywords,
                                  const nc::Dialect& dialect, DiagnosticSink& sink) {
    DiagnosticList mistakes;
    const Ast ast = parse(sources, file, keywords, dialect, mistakes);
    for (const Diagnostic& mistake : mistakes.all()) sink.take(mistake);
    if (mistakes.has_errors()) return std::nullopt;
    std::string text = Formatting(pieces_of(sources, file, keywords, dialect)).run();

    Sources check;
    const FileId again = check.add(std::string(sources.name(file)), text);
    DiagnosticList none;
    const Ast same = parse(check, again, keywords, dialect, none);
    KADR_ASSERT(!none.has_errors() && dump(same) == dump(ast), "the layout changed the meaning");
    return text;
}

}  // namespace kadr::syntax
