#include "syntax/brackets.h"

#include "base/diagnostics/syntax.h"
#include "syntax/token_kinds.h"

namespace kadr::syntax {

namespace {

const char* closing_text(Token open) {
    return open == Token::OpenParen ? ")" : open == Token::OpenBracket ? "]" : "}";
}

/// Whether what begins so goes on with no value in front of it.
bool begins_block(Token token) {
    return token == Token::Identifier || is_word(token) || begins_statement(token);
}

}  // namespace

Token closing_of(Token open) {
    return open == Token::OpenParen     ? Token::CloseParen
           : open == Token::OpenBracket ? Token::CloseBracket
                                        : Token::CloseBrace;
}

void Brackets::open(const Lexeme& lexeme, Bracket::Role role) {
    Bracket bracket;
    bracket.open = lexeme;
    bracket.role = role;
    bracket.indent = file_.lines.line_indent(lexeme.begin);
    // What is nested without braces around this block stays around it until it is closed.
    bracket.heads = static_cast<int>(heads_);
    stack_.push_back(bracket);
}

void Brackets::pop() {
    heads_ = static_cast<std::size_t>(stack_.back().heads);
    stack_.pop_back();
}

void Brackets::reset_heads() {
    heads_ = stack_.empty() ? 0 : static_cast<std::size_t>(stack_.back().heads);
}

Done Brackets::close(const Lexeme& lexeme) {
    std::size_t match = stack_.size();
    while (match > 0 && closing_of(stack_[match - 1].open.token) != lexeme.token) {
        // A `)` or `]` never reaches out of the statement.
        if (lexeme.token != Token::CloseBrace && stack_[match - 1].is_block()) match = 1;
        --match;
    }
    if (match == 0 && lexeme.token != Token::CloseBrace && !is_statement_level()) {
        exchange_top(lexeme);
        return kFailed;
    }
    if (match == 0) {
        if (lexeme.token == Token::CloseBrace) {
            close_values(lexeme);
            has_broken_blocks_ = true;
        }
        file_.sink.report(diag::BracketUnexpected, file_.range(lexeme)).arg(file_.spelling(lexeme));
        return kFailed;
    }
    while (stack_.size() > match) mend_top(lexeme);
    if (lexeme.token == Token::CloseBrace && stack_.back().is_block()) remember_suspect(lexeme);
    pop();
    return kDone;
}

void Brackets::close_values(const Lexeme& before) {
    while (!is_statement_level()) mend_top(before);
}

void Brackets::close_blocks(const Lexeme& before) {
    close_values(before);
    if (stack_.empty()) return;
    has_broken_blocks_ = true;
    const Lexeme& culprit = has_suspect_ ? suspect_ : stack_.front().open;
    const std::uint32_t index = out_.empty() ? 0 : out_.back().end;
    if (!before.is_repair) {
        file_.sink.report(diag::BracketMissing, file_.range(index, index))
            .arg("}")
            .note(file_.range(culprit), "the brace was opened here");
    }
    while (!stack_.empty()) {
        Lexeme brace;
        brace.token = Token::CloseBrace;
        brace.is_repair = true;
        brace.begin = brace.end = index;
        out_.push_back(brace);
        pop();
    }
}

/// In the tokens so far, where the innermost bracket should have been closed: the condition of a
/// statement ends where its block of words begins, `if ((a > 1) && (b > 1) G1 X1;`, all others
/// behind the last token.
std::size_t Brackets::end_of_top() const {
    const Bracket& top = stack_.back();
    if (top.role != Bracket::Role::Control && top.role != Bracket::Role::For) return out_.size();
    std::size_t first = out_.size();
    while (first > 0 && out_[first - 1].begin > top.open.begin) --first;
    std::size_t depth = 0;
    for (std::size_t i = first; i < out_.size(); ++i) {
        const Token token = out_[i].token;
        if (opens(token)) ++depth;
        else if (closes(token) && depth > 0) --depth;
        else if (depth == 0 && i > first && begins_block(token) && may_end_value(out_[i - 1].token))
            return i;
    }
    return out_.size();
}

/// Reports that the innermost bracket is not closed and closes it where it should have been.
void Brackets::mend_top(const Lexeme& before) {
    const Bracket& bracket = stack_.back();
    const char* text = closing_text(bracket.open.token);
    Lexeme lexeme;
    lexeme.token = closing_of(bracket.open.token);
    lexeme.is_repair = true;
    const std::size_t at = end_of_top();
    lexeme.begin = lexeme.end = at == 0 ? before.begin : out_[at - 1].end;
    // Two in a row are one slip: `f(g(x;`.
    const bool is_second = before.is_repair || (!out_.empty() && out_.back().is_repair);
    if (!is_second) {
        file_.sink.report(diag::BracketMissing, file_.range(lexeme))
            .arg(text)
            .note(file_.range(bracket.open), "the bracket was opened here")
            .fix(file_.range(lexeme), text, "close it");
    }
    out_.insert(out_.begin() + static_cast<std::ptrdiff_t>(at), lexeme);
    pop();
}

/// `a[5)`: one bracket of the wrong kind is one mistake.
void Brackets::exchange_top(const Lexeme& wrong) {
    const Lexeme& open = stack_.back().open;
    file_.sink.report(diag::BracketMissing, file_.range(wrong))
        .arg(closing_text(open.token))
        .note(file_.range(open), "the bracket was opened here")
        .fix(file_.range(wrong), closing_text(open.token), "close it with its own kind");
    Lexeme right = wrong;
    right.token = closing_of(open.token);
    out_.push_back(right);
    pop();
}

/// A `}` that stands first in its line, further left than the line of its `{`, closes a brace
/// further out; the `{` that it seems to close has none of its own.
void Brackets::remember_suspect(const Lexeme& brace) {
    if (has_suspect_) return;
    const std::uint32_t indent = file_.lines.indent(brace.begin);
    const std::string_view before = file_.text.substr(brace.begin - indent, indent);
    if (before.find_first_not_of(" \t") != std::string_view::npos) return;
    if (indent < stack_.back().indent) {
        suspect_ = stack_.back().open;
        has_suspect_ = true;
    }
}

}  // namespace kadr::syntax
