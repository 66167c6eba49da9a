#include "syntax/retype.h"

#include <algorithm>
#include <cctype>
#include <unordered_map>
#include <unordered_set>

#include "base/diagnostics/syntax.h"
#include "base/done.h"
#include "base/unicode.h"
#include "syntax/brackets.h"
#include "syntax/habits.h"
#include "syntax/keyword.h"
#include "syntax/operators.h"
#include "syntax/token_kinds.h"

namespace kadr::syntax {

namespace {

/// What the present statement began with, as far as it matters for what follows.
enum class Head : std::uint8_t {
    Other,
    Words,  // an NC block
    With,
    Contour,  // `contour c = {`: the brace opens statements
    Case,
    Declaration,  // of a variable
    Header,       // a declaration at file level that has parameters
    Struct,
    Enum,
};

/// Whether `//` stands right behind an index, and a value right behind it.
bool is_quotient_comment(std::string_view text, std::size_t index) {
    const std::string_view rest = text.substr(index);
    return rest.size() > 2 && rest.starts_with("//") &&
           (rest[2] == '(' || std::isalnum(static_cast<unsigned char>(rest[2])) != 0);
}

class Retyping {
  public:
    Retyping(const SourceFile& file, std::vector<Lexeme> in, const KeywordTable& keywords)
        : file_(file), in_(std::move(in)), keywords_(keywords), brackets_(file, out_) {}

    std::optional<Prepared> run();

  private:
    void step();
    void begin_statement();
    void end_statement();
    void end_forgotten_statement();
    bool is_lone_type() const;
    const char* head_text() const;
    Done require_no_control_comment();
    std::optional<std::size_t> bracket_comment() const;
    std::optional<std::size_t> line_comment();
    bool is_prose(std::size_t first, std::size_t last) const;
    bool ends_line(std::size_t i) const {
        return at(i + 1).token == Token::EndOfFile ||
               file_.crosses_line(at(i).end, at(i + 1).begin);
    }
    void mend_before();
    void open_paren(Lexeme lexeme);
    void open_brace(Lexeme lexeme);
    void name();
    bool argument_name();
    bool is_keyword_here(const Keyword& keyword) const;
    bool follows(std::string_view followers) const;
    bool opens_contour() const;
    bool is_type_place() const;
    bool is_type_at(std::size_t i) const;
    std::optional<std::size_t> past_brackets(std::size_t i) const;
    void drop_nested_array();
    bool is_generic_call() const;
    const Keyword* foreign_keyword(const Lexeme& lexeme);
    void push(Lexeme lexeme, Token token);

    const Keyword* keyword_of(const Lexeme& lexeme);
    bool declares_operator(std::size_t i, const Keyword& keyword);
    bool is_wrong_name(std::size_t i, const Keyword& keyword) const;
    void report_operator_name(std::size_t i, const Keyword& keyword);
    const Lexeme& at(std::size_t i) const { return in_[i < in_.size() ? i : in_.size() - 1]; }
    Token next() const { return at(i_ + 1).token; }
    Token previous() const { return out_.empty() ? Token::EndOfFile : out_.back().token; }
    bool is_name(std::size_t i) const {
        return at(i).token == Token::Identifier || is_word(at(i).token);
    }

    const SourceFile& file_;
    std::vector<Lexeme> in_;
    const KeywordTable& keywords_;
    std::vector<Lexeme> out_;
    Brackets brackets_;
    std::size_t i_ = 0;
    Head head_ = Head::Other;
    bool at_start_ = true;               // of a statement or declaration
    std::uint32_t statement_begin_ = 0;  // byte
    std::size_t statement_first_ = 0;    // index in out_
    bool has_assignment_ = false;        // the present statement has its `=` behind it
    std::unordered_map<std::uint32_t, const Keyword*> known_;  // by TextId
    std::unordered_set<std::uint32_t> wrong_names_;            // operators that were declared
};

std::optional<Prepared> Retyping::run() {
    out_.reserve(in_.size() + 8);
    for (std::size_t i = 0; i < in_.size(); ++i) {  // words for brackets and operators
        const Keyword* keyword = keyword_of(in_[i]);
        if (keyword == nullptr || keyword->context != Keyword::Context::Operator) continue;
        if (declares_operator(i, *keyword)) {
            report_operator_name(i, *keyword);
            continue;
        }
        if (is_wrong_name(i, *keyword)) continue;
        in_[i].token = keyword->token;
    }
    for (i_ = 0; in_[i_].token != Token::EndOfFile; ++i_) {
        step();
        if (brackets_.depth() > kMaxNesting) {
            file_.sink.report(diag::NestingTooDeep, file_.range(in_[i_])).arg(kMaxNesting);
            return std::nullopt;
        }
    }
    brackets_.close_blocks(in_[i_]);
    out_.push_back(in_[i_]);
    return Prepared{std::move(out_), brackets_.has_broken_blocks()};
}

void Retyping::step() {
    const Lexeme& lexeme = in_[i_];
    mend_before();
    end_forgotten_statement();
    if (!require_no_control_comment()) return;
    if (at_start_) begin_statement();
    switch (lexeme.token) {
        case Token::Identifier: return name();
        case Token::LiteralWord:
        case Token::BareWord:
        case Token::Address:
            if (argument_name()) return;
            return push(lexeme, lexeme.token);
        case Token::OpenParen: return open_paren(lexeme);
        case Token::OpenBracket:
            brackets_.open(lexeme, Bracket::Role::Plain);
            return push(lexeme, lexeme.token);
        case Token::OpenBrace: return open_brace(lexeme);
        case Token::CloseParen:
        case Token::CloseBracket: {
            const Bracket* top = brackets_.top();
            const bool is_control = top != nullptr && (top->role == Bracket::Role::Control ||
                                                       top->role == Bracket::Role::For);
            if (!brackets_.close(lexeme)) return;
            push(lexeme, lexeme.token);
            at_start_ = is_control && lexeme.token == Token::CloseParen;
            return;
        }
        case Token::CloseBrace: {
            const Bracket* top = brackets_.top();
            const bool is_value = top != nullptr && top->open.token == Token::OpenValue;
            if (!brackets_.close(lexeme)) return;
            push(lexeme, lexeme.token);
            if (!is_value) end_statement();
            return;
        }
        case Token::Semicolon: {
            Bracket* top = brackets_.top();
            const bool is_for =
                top != nullptr && top->role == Bracket::Role::For && top->semicolons++ < 2;
            push(lexeme, lexeme.token);
            if (is_for) return;
            end_statement();
            return;
        }
        case Token::Include:
            push(lexeme, lexeme.token);
            end_statement();
            return;
        case Token::RawText:
            // `raw { … }` ends with its brace, as a block does.
            push(lexeme, lexeme.token);
            if (next() != Token::Semicolon) end_statement();
            return;
        case Token::Question:
            if (Bracket* top = brackets_.top()) ++top->questions;
            brackets_.add_head();  // what follows is nested in the choice
            return push(lexeme, lexeme.token);
        case Token::Comma:
            if (!brackets_.is_statement_level()) brackets_.reset_heads();
            return push(lexeme, lexeme.token);
        case Token::Colon: {
            Bracket* top = brackets_.top();
            const bool is_choice = top != nullptr && top->questions > 0;
            if (is_choice) --top->questions;
            push(lexeme, lexeme.token);
            at_start_ = !is_choice && head_ == Head::Case && brackets_.is_statement_level();
            return;
        }
        case Token::Assign:
            if (brackets_.is_statement_level()) has_assignment_ = true;
            return push(lexeme, lexeme.token);
        default: return push(lexeme, lexeme.token);
    }
}

void Retyping::push(Lexeme lexeme, Token token) {
    lexeme.token = token;
    out_.push_back(lexeme);
    at_start_ = false;
}

/// Behind `;` or `}`: unless an `else` goes on with it, the statements around are over as well.
void Retyping::end_statement() {
    at_start_ = true;
    const Keyword* keyword = keyword_of(at(i_ + 1));
    if (keyword == nullptr || keyword->token != Token::Else) brackets_.reset_heads();
}

void Retyping::begin_statement() {
    statement_begin_ = in_[i_].begin;
    statement_first_ = out_.size();
    const bool is_skip = in_[i_].token == Token::Slash;  // `/G1 X5;`
    head_ = is_word(in_[i_].token) || is_skip ? Head::Words : Head::Other;
    has_assignment_ = false;
    if (Bracket* top = brackets_.top()) top->questions = 0;
}

/// Closes brackets that cannot reach over the next token.
void Retyping::mend_before() {
    const Lexeme& lexeme = in_[i_];
    if (brackets_.is_statement_level()) {
        // What only a file can hold, at the left margin of the block around: its `}` is missing.
        if (brackets_.is_file_level() || !at_start_ || lexeme.token != Token::Identifier) return;
        const Keyword* keyword = keyword_of(lexeme);
        if (keyword == nullptr || !is_keyword_here(*keyword)) return;
        const Token token = keyword->token;
        const bool is_outer = token == Token::Cycle || token == Token::Program ||
                              token == Token::Test || token == Token::Property ||
                              token == Token::Curve || token == Token::Struct ||
                              token == Token::Enum || token == Token::Import;
        if (is_outer && file_.lines.indent(lexeme.begin) <= brackets_.outermost().indent) {
            brackets_.close_blocks(lexeme);
            at_start_ = true;
        }
        return;
    }
    const Bracket& top = *brackets_.top();
    const bool is_new_line = file_.crosses_line(out_.back().end, lexeme.begin);
    bool is_over = false;
    if (lexeme.token == Token::Semicolon) {
        is_over = top.role != Bracket::Role::For || top.semicolons >= 2;
    } else if (lexeme.token == Token::OpenBrace) {
        const bool is_default = previous() == Token::Assign || previous() == Token::In;
        is_over = (may_end_value(previous()) && top.open.token != Token::OpenValue) ||
                  (top.role == Bracket::Role::Parameters && !is_default);
    } else if (is_word(lexeme.token) && next() != Token::Colon) {
        is_over = may_end_value(previous()) && (is_new_line || head_ == Head::Words);
    } else if (lexeme.token == Token::Identifier && is_new_line) {
        const Keyword* keyword = keyword_of(lexeme);
        is_over = keyword != nullptr && keyword->context == Keyword::Context::Anywhere &&
                  keyword->token != Token::True && keyword->token != Token::False;
    }
    if (is_over) brackets_.close_values(lexeme);
}

const char* Retyping::head_text() const {
    return head_ == Head::Words                                      ? "this block"
           : brackets_.is_file_level() || head_ == Head::Declaration ? "this declaration"
                                                                     : "this statement";
}

/// Whether nothing but `point[]` stands there yet: its name may follow in the next line, as behind
/// `void`.
bool Retyping::is_lone_type() const {
    if (out_[statement_first_].token != Token::TypeName) return false;
    return std::all_of(out_.begin() + static_cast<std::ptrdiff_t>(statement_first_) + 1, out_.end(),
                       [](const Lexeme& lexeme) {
                           return lexeme.token == Token::OpenBracket ||
                                  lexeme.token == Token::CloseBracket ||
                                  lexeme.token == Token::Number;
                       });
}

/// A statement goes on with a name in the next line only if that line is indented deeper. Otherwise
/// its `;` was forgotten, and two NC blocks would silently become one.
void Retyping::end_forgotten_statement() {
    const Lexeme& lexeme = in_[i_];
    if (at_start_ || !brackets_.is_statement_level()) return;
    if (!is_name(i_) || !file_.crosses_line(out_.back().end, lexeme.begin)) return;
    if (file_.lines.indent(lexeme.begin) > file_.lines.line_indent(statement_begin_)) return;
    const bool ends_word = may_end_value(previous()) || previous() == Token::BareWord;
    const bool is_header = head_ == Head::Header && previous() == Token::CloseParen;
    const Bracket* top = brackets_.top();
    const bool is_enum = top != nullptr && top->role == Bracket::Role::Enumerators;
    const Keyword* keyword = keyword_of(lexeme);
    const bool goes_on = keyword != nullptr && is_keyword_here(*keyword) &&
                         keyword->context == Keyword::Context::Infix;
    if (!ends_word || is_header || is_enum || goes_on || is_lone_type()) return;
    Lexeme semicolon;
    semicolon.token = Token::Semicolon;
    semicolon.is_repair = true;
    semicolon.begin = semicolon.end = out_.back().end;
    // A statement at file level is a mistake as a whole, and behind a mended bracket one is
    // reported.
    const Token first = out_[statement_first_].token;
    const bool is_stray =
        brackets_.is_file_level() && (first == Token::Identifier || is_word(first) ||
                                      first == Token::Percent || first == Token::Colon);
    const bool is_reported = is_stray || out_.back().is_repair;
    if (!is_reported) {
        auto message = file_.sink.report(diag::SemicolonMissing, file_.range(semicolon));
        message.arg(head_text());
        // `n//2`: with a semicolon in front the rest of the line would be lost.
        if (is_quotient_comment(file_.text, semicolon.begin))
            message.fix("`//` begins a comment; a whole quotient is `trunc(a/b)`");
        else message.fix(file_.range(semicolon), ";", "end it");
    }
    out_.push_back(semicolon);
    at_start_ = true;
    brackets_.reset_heads();
}

// ---------------------------------------------------------------- comments of a control

/// Two names, words or numbers in a row, as in a sentence: `FACE MILL`.
bool Retyping::is_prose(std::size_t first, std::size_t last) const {
    const auto is_given = [&](std::size_t i) { return is_name(i) || at(i).token == Token::Number; };
    for (std::size_t i = first; i < last; ++i) {
        if (is_given(i) && is_given(i + 1)) return true;
    }
    return false;
}

/// `(FACE MILL)` where no statement begins so, and behind the words of a block: its last lexeme.
std::optional<std::size_t> Retyping::bracket_comment() const {
    std::size_t close = i_;
    for (int depth = 0; !ends_line(close); ++close) {
        if (at(close).token == Token::OpenParen) ++depth;
        if (at(close).token == Token::CloseParen && --depth == 0) break;
    }
    if (at(close).token != Token::CloseParen) return std::nullopt;
    if (is_prose(i_ + 1, close - 1)) return close;
    const bool is_alone = ends_line(close) || is_name(close + 1);
    const bool is_comment = at_start_ ? is_alone : previous() == Token::LiteralWord;
    return is_comment ? std::optional(close) : std::nullopt;
}

/// `; face mill`, and the same behind a block: its last lexeme.
std::optional<std::size_t> Retyping::line_comment() {
    const Lexeme& semicolon = at(i_ - 1);
    if (semicolon.token != Token::Semicolon || ends_line(i_ - 1)) return std::nullopt;
    const Keyword* keyword = keyword_of(at(i_));
    const bool is_code_word =
        keyword != nullptr && (keyword->context == Keyword::Context::Anywhere ||
                               keyword->context == Keyword::Context::Type);
    bool is_of_names = at(i_).token == Token::Identifier && !is_code_word;
    std::size_t last = i_;
    for (; !ends_line(last); ++last) {
        is_of_names = is_of_names && (is_name(last + 1) || at(last + 1).token == Token::Number);
        const Token token = at(last + 1).token;
        const bool is_code =
            token == Token::Semicolon || token == Token::OpenBrace || token == Token::CloseBrace;
        if (is_code) return std::nullopt;
    }
    if (at(i_).token == Token::CloseBrace) return std::nullopt;
    const Habit* habit = habit_of(file_.spelling(at(i_)));
    if (last == i_ && habit != nullptr && habit->is_statement) return std::nullopt;  // `; ENDLOOP`
    const bool is_first = i_ < 2 || ends_line(i_ - 2);
    return is_first || is_of_names ? std::optional(last) : std::nullopt;
}

/// A comment as controls write it: it is reported, and left out.
Done Retyping::require_no_control_comment() {
    const bool is_bracket = at(i_).token == Token::OpenParen;
    if (!brackets_.is_statement_level() || (out_.empty() && !is_bracket)) return kDone;
    const bool is_behind_words =
        !at_start_ && head_ == Head::Words && may_end_value(previous()) && !ends_line(i_ - 1);
    std::optional<std::size_t> last;
    if (is_bracket && (at_start_ || is_behind_words)) last = bracket_comment();
    else if (!is_bracket && at_start_) last = line_comment();
    if (!last) return kDone;
    const std::uint32_t begin = is_bracket ? at(i_).begin : at(i_ - 1).begin;
    const bool is_own_sign = !is_bracket && i_ >= 2 && !ends_line(i_ - 2);  // it ends the block
    const std::string_view comment = file_.text.substr(begin, at(*last).end - begin);
    std::string_view words = comment.substr(1, comment.size() - (is_bracket ? 2 : 1));
    words.remove_prefix(std::min(words.find_first_not_of(' '), words.size()));
    const bool ends_block = is_behind_words && ends_line(*last);
    std::string mended = is_own_sign || ends_block ? "; " : "";
    mended += ends_line(*last) ? "// " + std::string(words) : "/* " + std::string(words) + " */";
    const std::uint32_t from = ends_block ? out_.back().end : begin;
    file_.sink.report(diag::ControlComment, file_.range(begin, at(*last).end))
        .arg(comment)
        .fix(file_.range(from, at(*last).end), mended, "a comment begins with `//`");
    i_ = *last;
    if (!ends_block) return kFailed;
    Lexeme semicolon;
    semicolon.token = Token::Semicolon;
    semicolon.is_repair = true;
    semicolon.begin = semicolon.end = from;
    out_.push_back(semicolon);
    end_statement();
    return kFailed;
}

void Retyping::open_paren(Lexeme lexeme) {
    Bracket::Role role = Bracket::Role::Plain;
    switch (previous()) {
        case Token::If:
        case Token::While:
        case Token::Switch: role = Bracket::Role::Control; break;
        case Token::For: role = Bracket::Role::For; break;
        default:
            if (brackets_.is_file_level() && head_ == Head::Header && !has_assignment_) {
                role = Bracket::Role::Parameters;
            }
    }
    brackets_.open(lexeme, role);
    push(lexeme, lexeme.token);
}

/// `{` opens statements, members, or a value.
void Retyping::open_brace(Lexeme lexeme) {
    const Bracket* top = brackets_.top();
    bool is_value = false;
    if (top != nullptr && !top->is_block()) {
        is_value = true;
    } else if (!at_start_) {
        const Token before = previous();
        const bool is_choice = before == Token::Colon && head_ != Head::Case;
        is_value = head_ == Head::Words || before == Token::Return || before == Token::Question ||
                   find_binary_operator(before) != nullptr || is_choice ||
                   (before == Token::Assign && head_ != Head::Contour);
    }
    if (is_value) {
        lexeme.token = Token::OpenValue;
        brackets_.open(lexeme, Bracket::Role::Plain);
        return push(lexeme, Token::OpenValue);
    }
    brackets_.open(lexeme, head_ == Head::Struct ? Bracket::Role::Members
                           : head_ == Head::Enum ? Bracket::Role::Enumerators
                                                 : Bracket::Role::Block);
    push(lexeme, Token::OpenBrace);
    at_start_ = true;
}

/// `całkowita i = 0`, where `i` is the word for `&&`.
bool Retyping::declares_operator(std::size_t i, const Keyword& keyword) {
    if (keyword.token == Token::Not) return false;
    const Keyword* before = i > 0 ? keyword_of(in_[i - 1]) : nullptr;
    const bool is_behind_type = before != nullptr && (before->context == Keyword::Context::Type ||
                                                      before->token == Token::Auto);
    const Token after = at(i + 1).token;
    const bool ends_name = after == Token::Assign || after == Token::Semicolon ||
                           after == Token::Comma || after == Token::CloseParen ||
                           after == Token::Colon;
    return (is_behind_type && ends_name) || after == Token::Assign;
}

/// Whether the word was declared before and stands where no operator can: it is a name there, so
/// that the mistake is one message.
bool Retyping::is_wrong_name(std::size_t i, const Keyword& keyword) const {
    return keyword.token != Token::Not && wrong_names_.contains(in_[i].text.index) &&
           (i == 0 || !may_end_value(in_[i - 1].token));
}

void Retyping::report_operator_name(std::size_t i, const Keyword& keyword) {
    if (!wrong_names_.insert(in_[i].text.index).second) return;
    file_.sink.report(diag::KeywordAsName, file_.range(in_[i]))
        .arg("`" + std::string(file_.texts.text(in_[i].text)) + "`")
        .note("in this keyword language it means `" + std::string(keyword.name) + '`');
}

const Keyword* Retyping::keyword_of(const Lexeme& lexeme) {
    if (lexeme.token != Token::Identifier) return nullptr;
    const auto known = known_.find(lexeme.text.index);
    if (known != known_.end()) return known->second;
    const std::string spelled(file_.texts.text(lexeme.text));
    const Keyword* keyword = nullptr;
    const auto found = keywords_.canonical.find(spelled);
    if (found != keywords_.canonical.end()) {
        keyword = find_keyword(found->second);
    } else if (spelled == "language" || spelled == "dialect") {
        // They must be readable before the keyword language is known.
        keyword = find_keyword(spelled);
    }
    known_.emplace(lexeme.text.index, keyword);
    return keyword;
}

void Retyping::name() {
    const Lexeme& lexeme = in_[i_];
    if (previous() == Token::Dot) return push(lexeme, Token::Identifier);
    if (argument_name()) return;
    if (previous() == Token::Assign && out_.size() > 1 &&
        out_[out_.size() - 2].token == Token::Address && next() == Token::OpenParen &&
        (file_.spelling(lexeme) == "AC" || file_.spelling(lexeme) == "IC")) {
        return push(lexeme, Token::Mode);
    }
    const Keyword* keyword = keyword_of(lexeme);
    if (keyword == nullptr && at_start_) keyword = foreign_keyword(lexeme);
    if (keyword != nullptr && is_keyword_here(*keyword)) {
        push(lexeme, keyword->token);
        switch (keyword->token) {
            case Token::If:
            case Token::While:
            case Token::For:
            case Token::Switch: brackets_.add_head(); return;
            case Token::Do:
            case Token::Else:
                brackets_.add_head();
                at_start_ = true;
                return;
            case Token::With: head_ = Head::With; return;
            case Token::Contour: head_ = Head::Contour; return;
            case Token::Case:
            case Token::Default: head_ = Head::Case; return;
            case Token::Struct: head_ = Head::Struct; return;
            case Token::Enum: head_ = Head::Enum; return;
            case Token::Cycle:
            case Token::Program:
            case Token::Curve:
            case Token::Property: head_ = Head::Header; return;
            default: return;
        }
    }
    if (is_generic_call()) return push(lexeme, Token::GenericName);
    if (is_type_place() && is_type_at(i_)) {
        Lexeme type = lexeme;
        if (keyword != nullptr &&
            (keyword->context == Keyword::Context::Type || keyword->token == Token::Contour)) {
            type.text = file_.texts.intern(keyword->name);
        }
        if (at_start_) head_ = brackets_.is_file_level() ? Head::Header : Head::Declaration;
        drop_nested_array();
        return push(type, Token::TypeName);
    }
    // `целое(x)` calls the function of that name.
    Lexeme plain = lexeme;
    if (keyword != nullptr && keyword->context == Keyword::Context::Type &&
        next() == Token::OpenParen) {
        plain.text = file_.texts.intern(keyword->name);
    }
    push(plain, Token::Identifier);
}

/// `to` in `drill(to: 5mm)`, `x` in `{x: 5mm}`. Any word can be one.
bool Retyping::argument_name() {
    const Bracket* top = brackets_.top();
    const bool is_place =
        top != nullptr && top->role == Bracket::Role::Plain &&
        (top->open.token == Token::OpenParen || top->open.token == Token::OpenValue) &&
        top->questions == 0 &&
        (previous() == Token::OpenParen || previous() == Token::OpenValue ||
         previous() == Token::Comma);
    if (!is_place || next() != Token::Colon) return false;
    Lexeme lexeme = in_[i_];
    lexeme.text = file_.texts.intern(composed(file_.spelling(lexeme)));
    push(lexeme, Token::ArgumentName);
    return true;
}

bool Retyping::is_keyword_here(const Keyword& keyword) const {
    const Bracket* top = brackets_.top();
    switch (keyword.context) {
        case Keyword::Context::Anywhere: return true;
        case Keyword::Context::Type:
        case Keyword::Context::Operator: return false;
        case Keyword::Context::Statement:
            if (keyword.token == Token::Contour && !opens_contour()) return false;
            // At file level there are no expressions that could begin with a name.
            return at_start_ && (brackets_.is_file_level() || follows(keyword.followers));
        case Keyword::Context::Header:
            return brackets_.is_file_level() && previous() == Token::CloseParen;
        case Keyword::Context::Parameter:
            return previous() == Token::Identifier && top != nullptr &&
                   top->role == Bracket::Role::Parameters;
        case Keyword::Context::Infix:
            return may_end_value(previous()) && !at_start_ && head_ != Head::Words;
        case Keyword::Context::Prefix: return next() == Token::Identifier;
        case Keyword::Context::Preserved:
            return previous() == Token::Preserves || previous() == Token::Comma;
    }
    return false;
}

bool Retyping::follows(std::string_view followers) const {
    for (const char follower : followers) {
        switch (follower) {
            case 'n':
                if (is_name(i_ + 1)) return true;
                break;
            case 't':
                if (next() == Token::Text || next() == Token::TextOpen) return true;
                break;
            case '(':
                if (next() == Token::OpenParen) return true;
                break;
            case '{':
                if (next() == Token::RawText) return true;
                break;
            case ';':
                if (next() == Token::Semicolon) return true;
                break;
            default: break;
        }
    }
    return false;
}

/// `contour c = { G1 X0 Y0; … };`, not a variable or a function of that type: `contour c;`,
/// `contour c = reverse(d);`, `contour make() { … }`.
bool Retyping::opens_contour() const {
    if (!is_name(i_ + 1)) return false;
    const Token after = at(i_ + 2).token;
    if (after == Token::Assign) return at(i_ + 3).token == Token::OpenBrace;
    return after != Token::Semicolon && after != Token::OpenParen;
}

/// Whether a declaration can begin here.
bool Retyping::is_type_place() const {
    const Bracket* top = brackets_.top();
    if (top != nullptr && top->role == Bracket::Role::Enumerators) return false;
    if (at_start_ || previous() == Token::Const || previous() == Token::Over) return true;
    if (previous() == Token::Less && out_.size() > 1 &&
        out_[out_.size() - 2].token == Token::GenericName) {
        return true;
    }
    if (brackets_.is_statement_level()) return false;
    if (top->role == Bracket::Role::For) return previous() == Token::OpenParen;
    return top->role == Bracket::Role::Parameters &&
           (previous() == Token::OpenParen || previous() == Token::Comma);
}

/// Past the `]` that closes the `[` at `i`; nothing if the statement ends before.
std::optional<std::size_t> Retyping::past_brackets(std::size_t i) const {
    int depth = 0;
    do {
        if (at(i).token == Token::OpenBracket) ++depth;
        if (at(i).token == Token::CloseBracket) --depth;
        if (at(i).token == Token::Semicolon || at(i).token == Token::EndOfFile) return std::nullopt;
        ++i;
    } while (depth > 0);
    return i;
}

/// `int[][] m`: reported here, and read as `int[] m`, so that it is one message.
void Retyping::drop_nested_array() {
    if (next() != Token::OpenBracket) return;
    const std::size_t first = *past_brackets(i_ + 1);
    std::size_t end = first;
    while (at(end).token == Token::OpenBracket) end = *past_brackets(end);
    if (end == first) return;
    file_.sink.report(diag::ArrayOfArrays, file_.range(in_[i_].begin, in_[end - 1].end))
        .fix("let a struct hold the inner array");
    in_.erase(in_.begin() + static_cast<std::ptrdiff_t>(first),
              in_.begin() + static_cast<std::ptrdiff_t>(end));
}

/// A type in front of a name: `length r`, `length[] r`, `hole[8] h`, `length? r`, `point& p`.
bool Retyping::is_type_at(std::size_t i) const {
    if (previous() == Token::Less) return true;  // `table<hole>`
    ++i;
    while (at(i).token == Token::OpenBracket) {
        const std::optional<std::size_t> end = past_brackets(i);
        if (!end) return false;
        i = *end;
    }
    const bool is_optional = at(i).token == Token::Question;
    if (is_optional) ++i;
    if (at(i).token == Token::And) ++i;
    if (!is_name(i)) return false;
    // `then M8;` declares nothing, `length D;` means to.
    if (is_word(at(i).token) && at(i + 1).token != Token::Assign) {
        const auto known = keywords_.canonical.find(std::string(file_.texts.text(in_[i_].text)));
        const Keyword* keyword =
            known == keywords_.canonical.end() ? nullptr : find_keyword(known->second);
        if (keyword == nullptr || keyword->context != Keyword::Context::Type) return false;
    }
    if (!is_optional) return true;
    const Token after = at(i + 1).token;
    // At file level there are no expressions: a function that may give no value.
    const bool is_function = after == Token::OpenParen && at_start_ && brackets_.is_file_level();
    return after == Token::Comma || after == Token::CloseParen || after == Token::Semicolon ||
           after == Token::Assign || is_function;
}

/// `table<hole>(`: never a comparison, a truth value is not compared with a number.
bool Retyping::is_generic_call() const {
    return next() == Token::Less && at(i_ + 2).token == Token::Identifier &&
           at(i_ + 3).token == Token::Greater && at(i_ + 4).token == Token::OpenParen;
}

/// `for` or `note "…"` in a file whose keyword language has `для` and `заметка`.
const Keyword* Retyping::foreign_keyword(const Lexeme& lexeme) {
    const Keyword* english = find_keyword(file_.texts.text(lexeme.text));
    if (english == nullptr) return nullptr;
    // `note` in front of a text and a contour of blocks can mean nothing else; what may be a type
    // or a function of the author's is the checker's matter.
    const bool is_text = next() == Token::Text || next() == Token::TextOpen;
    const bool is_reported =
        english->context == Keyword::Context::Anywhere ||
        (english->context == Keyword::Context::Statement && is_text) ||
        (english->token == Token::Contour && opens_contour() && is_word(at(i_ + 4).token));
    if (!is_reported) return nullptr;
    for (const auto& [lexeme_here, name] : keywords_.canonical) {
        if (name != english->name) continue;
        file_.sink.report(diag::ForeignKeyword, file_.range(lexeme))
            .arg(english->name)
            .arg(lexeme_here)
            .arg(keywords_.name)
            .fix(file_.range(lexeme), lexeme_here, "use the word of the keyword language");
        return english;
    }
    return nullptr;
}

}  // namespace

std::optional<Prepared> retype(const SourceFile& file, std::vector<Lexeme> lexemes,
                               const KeywordTable& keywords) {
    return Retyping(file, std::move(lexemes), keywords).run();
}

}  // namespace kadr::syntax
