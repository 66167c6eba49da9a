#include "syntax/brackets.h"

#include "base/diagnostics/syntax.h"

namespace kadr::syntax {

namespace {

const char* closing_text(Token open) {
    return open == Token::OpenParen ? ")" : open == Token::OpenBracket ? "]" : "}";
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

bool Brackets::close(const Lexeme& lexeme) {
    std::size_t match = stack_.size();
    while (match > 0 && closing_of(stack_[match - 1].open.token) != lexeme.token) {
        // A `)` or `]` never reaches out of the statement.
        if (lexeme.token != Token::CloseBrace && stack_[match - 1].is_block()) match = 1;
        --match;
    }
    if (match == 0 && lexeme.token != Token::CloseBrace && !is_statement_level()) {
        exchange_top(lexeme);
        return false;
    }
    if (match == 0) {
        if (lexeme.token == Token::CloseBrace) {
            close_values(lexeme);
            has_broken_blocks_ = true;
        }
        file_.sink.report(diag::BracketUnexpected, file_.range(lexeme)).arg(file_.spelling(lexeme));
        return false;
    }
    while (stack_.size() > match) mend_top(lexeme);
    if (lexeme.token == Token::CloseBrace && stack_.back().is_block()) remember_suspect(lexeme);
    pop();
    return true;
}

void Brackets::close_values(const Lexeme& before) {
    while (!is_statement_level()) mend_top(before);
}

void Brackets::close_blocks(const Lexeme& before) {
    close_values(before);
    if (stack_.empty()) return;
    has_broken_blocks_ = true;
    const Lexeme& culprit = has_suspect_ ? suspect_ : stack_.front().open;
    const std::uint32_t place = out_.empty() ? 0 : out_.back().end;
    if (!before.is_repair) {
        file_.sink.report(diag::BracketMissing, file_.range(place, place))
            .arg("}")
            .note(file_.range(culprit), "the brace was opened here");
    }
    while (!stack_.empty()) {
        Lexeme brace;
        brace.token = Token::CloseBrace;
        brace.is_repair = true;
        brace.begin = brace.end = place;
        out_.push_back(brace);
        pop();
    }
}

/// Reports that the innermost bracket is not closed and closes it behind the last token.
void Brackets::mend_top(const Lexeme& before) {
    const Bracket& bracket = stack_.back();
    const char* text = closing_text(bracket.open.token);
    Lexeme lexeme;
    lexeme.token = closing_of(bracket.open.token);
    lexeme.is_repair = true;
    lexeme.begin = lexeme.end = out_.empty() ? before.begin : out_.back().end;
    // Two in a row are one slip: `f(g(x;`.
    const bool is_second = before.is_repair || (!out_.empty() && out_.back().is_repair);
    if (!is_second) {
        file_.sink.report(diag::BracketMissing, file_.range(lexeme))
            .arg(text)
            .note(file_.range(bracket.open), "the bracket was opened here")
            .fix(file_.range(lexeme), text, "close it");
    }
    out_.push_back(lexeme);
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
