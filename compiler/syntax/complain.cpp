// complain.cpp — what a mistake is in a technologist's words.
#include <algorithm>

#include "base/diagnostics/dialect.h"
#include "base/diagnostics/syntax.h"
#include "base/text.h"
#include "syntax/habits.h"
#include "syntax/keyword.h"
#include "syntax/operators.h"
#include "syntax/parse.h"
#include "syntax/parser_position.h"
#include "syntax/token_kinds.h"
#include "syntax/words.h"

namespace kadr::syntax {

// ---------------------------------------------------------------- the tokens

LexemeStream::LexemeStream(const std::vector<Lexeme>& lexemes, const LimitedSink* limit)
    : limit_(limit) {
    tokens_.reserve(lexemes.size());
    for (std::size_t i = 0; i < lexemes.size(); ++i) tokens_.emplace_back(lexemes[i], i);
}

antlr4::Token* LexemeStream::LT(ssize_t offset) {
    if (offset < 0 && at_ < static_cast<std::size_t>(-offset)) return &tokens_.front();
    const std::size_t index = offset < 0 ? at_ - static_cast<std::size_t>(-offset)
                                         : at_ + static_cast<std::size_t>(offset) - 1;
    return &tokens_[std::min(index, tokens_.size() - 1)];
}

antlr4::Token* LexemeStream::get(std::size_t index) const { return &tokens_[index]; }

// ---------------------------------------------------------------- what is wrong

Complaints::ParserPosition Complaints::location_of(antlr4::Parser& parser, std::size_t index) {
    const Lexeme& offending = stream_.lexeme(index);
    const Lexeme& previous = stream_.lexeme(index > 0 ? index - 1 : 0);
    Token head = Token::EndOfFile;
    std::size_t head_index = index;
    for (antlr4::RuleContext* context = parser.getContext(); context != nullptr;
         context = static_cast<antlr4::RuleContext*>(context->parent)) {
        const std::size_t rule = context->getRuleIndex();
        if (rule == KadrParser::RuleStatement || rule == KadrParser::RuleDeclaration) {
            auto* start = static_cast<antlr4::ParserRuleContext*>(context)->start;
            head = static_cast<LexemeToken*>(start)->lexeme().token;
            head_index = start->getTokenIndex();
            break;
        }
    }
    return {index,
            offending,
            previous,
            parser.getExpectedTokens(),
            parser.getContext()->getRuleIndex(),
            head,
            head_index,
            file_.crosses_line(previous.end, offending.begin)};
}

std::string Complaints::quoted(const Lexeme& lexeme) const {
    if (lexeme.token == Token::EndOfFile) return "the end of the file";
    std::string_view spelled = file_.spelling(lexeme);
    constexpr std::size_t kLongest = 40;
    if (spelled.size() <= kLongest) return "`" + std::string(spelled) + "`";
    std::size_t length = kLongest;
    while ((spelled[length] & 0xc0) == 0x80) --length;
    return "`" + std::string(spelled.substr(0, length)) + "…`";
}

void Complaints::complain(antlr4::Parser& parser, std::size_t index) {
    if (index == last_place_) return;
    last_place_ = index;
    const ParserPosition at = location_of(parser, index);
    // What was put in or left out around here is reported already.
    if (at.previous.is_repair || at.offending.is_repair) return;
    explain(at);
    lose_variable(at);
    if (limit_.is_full()) throw antlr4::ParseCancellationException();
}

bool Complaints::is_semicolon_forgotten(const ParserPosition& at) const {
    if (!at.expects(Token::Semicolon)) return false;
    const Token token = at.offending.token;
    // `return if;`: hardly two statements in one line.
    if (at.previous.token == Token::Return && !at.is_new_line && begins_statement(token))
        return false;
    return at.is_new_line || token == Token::CloseBrace || token == Token::EndOfFile ||
           begins_statement(token);
}

void Complaints::explain(const ParserPosition& at) {
    if (!check_glued_words(at) || !check_number(at) || !check_capitals(at) ||
        !check_program_number(at) || !check_habit(at) || !check_for(at) || !check_declaration(at) ||
        !check_name(at) || !check_value(at) || !check_sign(at) || !check_closing(at)) {
        return;
    }
    const SourceRange range = file_.range(at.offending);
    if (at.offending.token == Token::Else && at.expects(Token::Semicolon)) {
        const SourceRange gap = file_.range(at.previous.end, at.previous.end);
        file_.sink.report(diag::SemicolonMissing, gap).arg("this block").fix(gap, ";", "end it");
    } else if (at.expects(Token::OpenBrace) && at.rule == KadrParser::RuleBlock) {
        const SourceRange gap = file_.range(at.previous.end, at.previous.end);
        file_.sink.report(diag::BodyMissing, gap).arg(quoted(at.previous));
    } else if (at.offending.token == Token::OpenBrace && at.expects(Token::OpenParen) &&
               at.previous.token == Token::Identifier && at.head_index + 2 == at.index &&
               at.head == Token::TypeName) {
        const SourceRange gap = file_.range(at.previous.end, at.previous.end);
        auto message = file_.sink.report(diag::SignMissing, gap);
        message.arg("(").arg(quoted(at.previous));
        fix_parentheses(at, message);
    } else if (at.head == Token::Switch && at.expects_only(Token::CloseBrace)) {
        file_.sink.report(diag::CaseMissing, range).arg(quoted(at.offending));
    } else {
        auto report = file_.sink.report(diag::Unexpected, range);
        report.arg(quoted(at.offending)).arg(quoted(at.previous));
        if (!fix_sign(at, report)) {
            fix_operator(at, report);
            fix_call(at, report);
        }
    }
}

// Each of these knows a kind of mistake: if it is that one, it is reported, and no other looks.

/// `10,5` and `10 mm`.
Done Complaints::check_number(const ParserPosition& at) {
    const Lexeme& previous = at.previous;
    const Lexeme& offending = at.offending;
    const bool is_number = previous.token == Token::Number || previous.token == Token::LiteralWord;
    if (!is_number || at.is_new_line) return kDone;
    if (previous.unit != Unit::None && offending.token == Token::Comma) return kDone;
    const std::string spelled(file_.spelling(previous));
    const auto& next = stream_.lexeme(std::min(at.index + 1, stream_.size() - 1));
    const bool is_whole = spelled.find('.') == std::string::npos;
    if (offending.token == Token::Comma && next.token == Token::Number && is_whole &&
        previous.end == offending.begin && next.begin == offending.end) {
        const SourceRange whole = file_.range(previous.begin, next.end);
        auto message = file_.sink.report(diag::DecimalComma, whole);
        message.arg(file_.text.substr(previous.begin, next.end - previous.begin));
        // `1,234.5`, `1,2,3`: what is meant, only the author knows.
        const bool is_list = next.end < file_.text.size() && file_.text[next.end] == ',';
        const bool has_point = file_.spelling(next).find('.') != std::string_view::npos;
        if (has_point) message.fix("thousands are not set apart: `1234.5`");
        else if (is_list) message.fix("a list stands in braces: `{1, 2, 3}`");
        else message.fix(file_.range(offending), ".", "write a point");
        return kFailed;
    }
    if (offending.token != Token::Identifier || previous.unit != Unit::None) return kDone;
    const std::string_view name = file_.spelling(offending);
    if (const std::string_view meant = unit_meant(name); !meant.empty()) {  // `5 MM`
        file_.sink.report(diag::UnitApart, file_.range(offending))
            .arg(meant)
            .fix(file_.range(previous.begin, offending.end), spelled + std::string(meant),
                 "write it right behind the number");
        return kFailed;
    }
    const auto& per = stream_.lexeme(std::min(at.index + 2, stream_.size() - 1));
    const bool is_quotient = next.token == Token::Slash && per.token == Token::Identifier &&
                             find_unit(name, file_.spelling(per)) != Unit::None;
    if (!is_quotient && find_unit(name, "") == Unit::None) return kDone;
    std::string unit(name);
    if (is_quotient) unit += '/' + std::string(file_.spelling(per));
    const std::uint32_t end = is_quotient ? per.end : offending.end;
    file_.sink.report(diag::UnitApart, file_.range(offending.begin, end))
        .arg(unit)
        .fix(file_.range(previous.begin, end), spelled + unit, "write it right behind the number");
    return kFailed;
}

/// `IF (n > 3) M8;`: a call of `IF` to the parser.
Done Complaints::check_capitals(const ParserPosition& at) {
    // `WHILE n<3 DO1;` begins like a declaration of `n`.
    const bool is_name = at.head == Token::Identifier || at.head == Token::TypeName;
    if (!is_name || at.head_index == at.index) return kDone;
    const Lexeme& head = stream_.lexeme(at.head_index);
    const std::string_view spelled = file_.spelling(head);
    const std::string lower = lower_ascii(spelled);
    const Keyword* keyword = find_keyword(lower);
    if (lower == spelled || keyword == nullptr || keyword->context != Keyword::Context::Anywhere)
        return kDone;
    auto report = file_.sink.report(diag::KeywordCase, file_.range(head));
    report.arg(lower);
    if (const std::string form = form_of_control(lower, at.head_index); !form.empty())
        report.fix(form);
    else report.fix(file_.range(head), lower, "write it in lower case");
    return kFailed;
}

/// A statement that begins with a word of another language: `foreach (x in list)`, `goto 5`.
Done Complaints::check_habit(const ParserPosition& at) {
    const Lexeme& head = stream_.lexeme(at.head_index);
    // `static int k = 3;`: a type to the parser, and `int` the name.
    const bool is_type = head.token == Token::TypeName && at.index <= at.head_index + 2;
    if (head.token != Token::Identifier && !is_type) return kDone;
    if (at.head_index >= at.index) return kDone;
    const Habit* habit = habit_of(file_.spelling(head));
    if (habit == nullptr || !habit->is_statement) return kDone;
    // A name of the program may be spelled so: `end = 3`, `loop.count`.
    switch (stream_.lexeme(at.head_index + 1).token) {
        case Token::Assign:
        case Token::Dot:
        case Token::OpenBracket:
        case Token::Semicolon: return kDone;
        default: break;
    }
    if (is_then(at.head_index)) {
        file_.sink.report(diag::Unexpected, file_.range(head))
            .arg(quoted(head))
            .arg(quoted(stream_.lexeme(at.head_index - 1)))
            .fix(file_.range(head.begin, at.offending.begin), "", "there is no `then`");
        return kFailed;
    }
    file_.sink.report(diag::Unexpected, file_.range(at.offending))
        .arg(quoted(at.offending))
        .arg(quoted(at.previous))
        .fix(std::string(habit->hint));
    return kFailed;
}

/// A line `O1234` of a control's text above the program: a type to the parser, and `program` a
/// name.
Done Complaints::check_program_number(const ParserPosition& at) {
    if (at.head_index + 2 != at.index) return kDone;
    const Lexeme& head = stream_.lexeme(at.head_index);
    if (!is_program_number(head)) return kDone;
    auto message = file_.sink.report(diag::StatementOutside, file_.range(head));
    message.arg(quoted(head));
    fix_program_number(head, message);
    return kFailed;
}

bool Complaints::is_program_number(const Lexeme& lexeme) const {
    const std::string_view spelled = file_.spelling(lexeme);
    return spelled.size() > 1 && spelled[0] == 'O' &&
           spelled.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

void Complaints::fix_program_number(const Lexeme& lexeme, DiagnosticBuilder& report) const {
    report.fix("a program that is called so has this number: `program " +
               std::string(file_.spelling(lexeme)) + "() { … }`");
}

/// The head of a `for`: which of its two kinds it is shows only at its third token.
Done Complaints::check_for(const ParserPosition& at) {
    if (at.rule != KadrParser::RuleForHead) return kDone;
    const SourceRange gap = file_.range(at.previous.end, at.previous.end);
    const bool is_declared =
        at.previous.token == Token::TypeName || at.previous.token == Token::Auto;
    if (is_declared && is_word(at.offending.token)) {
        explain_address_name(at.offending);
        return kFailed;
    }
    if (at.offending.token == Token::Colon) {
        file_.sink.report(diag::ForTypeMissing, file_.range(at.previous)).arg(quoted(at.previous));
        return kFailed;
    }
    if (at.previous.token != Token::Identifier || !at.expects(Token::Number)) return kDone;
    const bool is_list = at.offending.token == Token::Identifier || at.offending.token == Token::In;
    auto message = file_.sink.report(diag::SignMissing, gap);
    message.arg(is_list ? ":" : "=").arg(quoted(at.previous));
    if (lower_ascii(file_.spelling(at.offending)) == "in")
        message.fix(file_.range(at.offending), ":", "a loop over a list has a sign");
    return kFailed;
}

/// `while (n < 3) do { … }`: a loop of other languages, and to the parser one with its condition at
/// the end.
Done Complaints::check_do(std::size_t index) {
    if (index == 0 || stream_.lexeme(index).token != Token::Do) return kDone;
    const Lexeme& before = stream_.lexeme(index - 1);
    const Lexeme& word = stream_.lexeme(index);
    if (before.token != Token::CloseParen || file_.crosses_line(before.end, word.begin))
        return kDone;
    file_.sink.report(diag::Unexpected, file_.range(word))
        .arg(quoted(word))
        .arg(quoted(before))
        .fix(file_.range(word.begin, stream_.lexeme(index + 1).begin), "", "there is no `do` here");
    return kFailed;
}

/// Where nothing but one sign can stand.
Done Complaints::check_sign(const ParserPosition& at) {
    if (at.expects(Token::Text) && at.rule == KadrParser::RuleText) {
        file_.sink.report(diag::TitleMissing, file_.range(at.offending)).arg(quoted(at.previous));
        return kFailed;
    }
    constexpr std::pair<Token, const char*> kSigns[] = {
        {Token::OpenParen, "("}, {Token::Colon, ":"}, {Token::While, "while"},
        {Token::Over, "over"},   {Token::In, "in"},
    };
    const SourceRange gap = file_.range(at.previous.end, at.previous.end);
    for (const auto& [token, sign] : kSigns) {
        if (!at.expects_only(token)) continue;
        if (token == Token::While && !check_do(at.head_index)) return kFailed;
        auto message = file_.sink.report(diag::SignMissing, gap);
        message.arg(sign).arg(quoted(at.previous));
        if (token == Token::OpenParen) fix_parentheses(at, message);
        return kFailed;
    }
    const bool is_for = at.rule == KadrParser::RuleForHead;
    const bool is_field = at.rule == KadrParser::RuleField;
    if (at.expects_only(Token::Semicolon) && (is_for || is_field) && !at.is_new_line) {
        auto message = file_.sink.report(diag::SignMissing, gap);
        message.arg(";").arg(quoted(at.previous));
        if (is_for && at.offending.token == Token::Comma) fix_comma_of_loop(at, message);
        else if (is_for) fix_counting(at, message);
        return kFailed;
    }
    const bool is_name_first = at.previous.token == Token::Identifier;
    if (at.expects_only(Token::Assign) && is_name_first) {
        file_.sink.report(diag::SignMissing, gap).arg("=").arg(quoted(at.previous));
        return kFailed;
    }
    return kDone;
}

/// A function inside of a function: `length f(length x) {`.
Done Complaints::check_declaration(const ParserPosition& at) {
    const bool is_variable = at.head == Token::TypeName && at.rule != KadrParser::RuleFile;
    if (!is_variable || at.offending.token != Token::OpenParen ||
        at.previous.token != Token::Identifier || !at.expects(Token::Semicolon)) {
        return kDone;
    }
    lost_names_.emplace_back(file_.spelling(at.previous));
    file_.sink.report(diag::DeclarationInside, file_.range(at.previous))
        .arg("the function " + quoted(at.previous));
    return kFailed;
}

/// The variable or cycle whose declaration has this mistake: its name is no second one.
void Complaints::lose_variable(const ParserPosition& at) {
    if (at.head == Token::Cycle || at.head == Token::Curve) return lose_names(at.head_index);
    const bool is_variable =
        at.head == Token::TypeName || at.head == Token::Const || at.head == Token::Auto;
    if (!is_variable) return;
    for (std::size_t i = at.head_index; i < at.index; ++i) {
        const Lexeme& lexeme = stream_.lexeme(i);
        if (lexeme.token == Token::Assign) return;
        if (lexeme.token == Token::Identifier) lost_names_.emplace_back(file_.spelling(lexeme));
    }
}

/// Remembers what the declaration that begins here would have declared.
void Complaints::lose_names(std::size_t index) {
    const bool is_enum = stream_.lexeme(index).token == Token::Enum;
    for (++index; index < stream_.size(); ++index) {
        const Lexeme& lexeme = stream_.lexeme(index);
        if (lexeme.token == Token::Identifier) lost_names_.emplace_back(file_.spelling(lexeme));
        const bool is_list = lexeme.token == Token::OpenBrace || lexeme.token == Token::Comma;
        const bool goes_on = lexeme.token == Token::Identifier || (is_enum && is_list);
        if (!goes_on) return;
    }
}

/// An address in place of a name.
void Complaints::explain_address_name(const Lexeme& lexeme) {
    const std::string_view spelled = file_.spelling(lexeme);
    bad_names_.insert(std::string(spelled));
    auto message = file_.sink.report(diag::AddressAsName, file_.range(lexeme));
    message.arg(quoted(lexeme));
    fix_name_of_word(lexeme, message);
}

/// Where a name must stand.
Done Complaints::check_name(const ParserPosition& at) {
    if (!at.expects(Token::Identifier) || at.expected.size() > 3) return kDone;
    const Lexeme& offending = at.offending;
    const SourceRange range = file_.range(offending);
    if (is_word(offending.token)) {
        explain_address_name(offending);
    } else if (is_keyword(offending.token)) {
        file_.sink.report(diag::KeywordAsName, range).arg(quoted(offending));
    } else {
        file_.sink.report(diag::NameMissing, file_.range(at.previous.end, at.previous.end))
            .arg(quoted(at.previous))
            .arg(quoted(offending));
    }
    return kFailed;
}

/// Where a value must stand.
Done Complaints::check_value(const ParserPosition& at) {
    if (!at.expects(Token::Number) || at.expects(Token::If)) return kDone;
    if (at.expects(Token::Semicolon) && at.offending.token != Token::Semicolon) {
        return kDone;  // the value is not needed
    }
    const Lexeme& offending = at.offending;
    const SourceRange gap = file_.range(at.previous.end, at.previous.end);
    const bool is_text_meant = at.head == Token::Raw || at.head == Token::Note;
    // In `X=a* Y5` a value was forgotten, in `X=a*R5` the word was meant as one.
    const bool is_next_word = is_word(at.head) && at.previous.end != offending.begin;
    if (is_word(offending.token) && !is_text_meant && !is_next_word) {
        const std::string_view spelled = file_.spelling(offending);
        if (bad_names_.count(std::string(spelled)) > 0) return kFailed;
        auto message = file_.sink.report(diag::WordAsValue, file_.range(offending));
        message.arg(quoted(offending));
        fix_value_of_word(offending, message);
        return kFailed;
    }
    auto message = file_.sink.report(diag::ValueMissing, gap);
    message.arg(quoted(at.previous));
    if (offending.token == Token::OpenBracket) fix_brackets(at, message);
    else fix_sign(at, message);
    return kFailed;
}

/// `G1 Xd Yd Zd;`: words whose values are names without `=`. One or two of them are a point and
/// another one to the grammar; of more the parser stops at the last.
Done Complaints::check_glued_words(const ParserPosition& at) {
    const auto is_glued = [&](std::size_t i) {
        const Lexeme& lexeme = stream_.lexeme(i);
        return lexeme.token == Token::Identifier &&
               glued_address(dialect_, file_.spelling(lexeme)) > 0;
    };
    if (!is_word(at.head) || !is_glued(at.index)) return kDone;
    for (std::size_t i = at.head_index; i <= at.index; ++i) {
        const Token before = stream_.lexeme(i > 0 ? i - 1 : 0).token;
        const bool is_behind_value = is_word(before) || before == Token::Identifier ||
                                     before == Token::Number || closes(before);
        if (!is_glued(i) || !is_behind_value) continue;
        const std::string_view name = file_.spelling(stream_.lexeme(i));
        const std::size_t letters = glued_address(dialect_, name);
        const auto value = stream_.lexeme(i).begin + static_cast<std::uint32_t>(letters);
        file_.sink.report(diag::WordWithoutValue, file_.range(stream_.lexeme(i).begin, value))
            .arg('`' + std::string(name.substr(0, letters)) + '`')
            .fix(file_.range(value, value), "=", kValueBehindSign);
    }
    return kFailed;
}

/// Where something must end: a statement, brackets, a list.
Done Complaints::check_closing(const ParserPosition& at) {
    const Lexeme& offending = at.offending;
    const SourceRange range = file_.range(offending);
    const SourceRange gap = file_.range(at.previous.end, at.previous.end);
    if (at.expects(Token::If)) {
        file_.sink.report(diag::StatementMissing, gap).arg(quoted(at.previous));
        return kFailed;
    }
    if (at.previous.token == Token::Address && at.expects(Token::Assign)) {
        auto report = file_.sink.report(diag::WordWithoutValue, file_.range(at.previous));
        report.arg(quoted(at.previous));
        fix_word_value(at, report);
        return kFailed;
    }
    const bool is_variable =
        at.head == Token::TypeName || at.head == Token::Const || at.head == Token::Auto;
    if (is_semicolon_forgotten(at)) {
        const char* what = is_word(at.head) ? "this block"
                           : is_variable || begins_declaration(at.head) || at.head == Token::Contour
                               ? "this declaration"
                               : "this statement";
        file_.sink.report(diag::SemicolonMissing, gap).arg(what).fix(gap, ";", "end it");
        return kFailed;
    }
    if (is_variable && at.expects(Token::Semicolon) && offending.token == Token::OpenBracket) {
        auto message = file_.sink.report(diag::ArrayBrackets, range);
        message.arg(file_.spelling(at.previous));
        std::size_t close = at.index;
        while (close + 1 < stream_.size() && stream_.lexeme(close).token != Token::CloseBracket &&
               stream_.lexeme(close).token != Token::Semicolon)
            ++close;
        if (at.index >= 2 && stream_.lexeme(close).token == Token::CloseBracket) {
            const std::uint32_t type_end = stream_.lexeme(at.index - 2).end;
            const std::uint32_t end = stream_.lexeme(close).end;
            message.fix(file_.range(type_end, end),
                        std::string(file_.text.substr(offending.begin, end - offending.begin)) +
                            ' ' + std::string(file_.spelling(at.previous)),
                        "put them behind the type");
        }
        return kFailed;
    }
    if (is_variable && at.expects(Token::Semicolon) && offending.token == Token::Comma) {
        const std::uint32_t begin = stream_.lexeme(at.head_index).begin;
        std::uint32_t end = begin;  // of the type
        std::size_t name = at.head_index;
        for (; name < at.index && stream_.lexeme(name).token != Token::Identifier; ++name)
            end = stream_.lexeme(name).end;
        auto message = file_.sink.report(diag::SeveralNames, range);
        if (name < at.index) {
            message.fix(range, "; " + std::string(file_.text.substr(begin, end - begin)),
                        "end the declaration and begin another one");
        }
        return kFailed;
    }
    if (!check_assignment(at)) return kFailed;
    return check_comma(at);
}

/// `G1 X10 Q=5;`, `Q` being no address of the dialect.
bool Complaints::is_foreign_word(const ParserPosition& at) const {
    if (!is_word(at.head) || at.previous.token != Token::Identifier || at.index < 2) return false;
    const Token before = stream_.lexeme(at.index - 2).token;
    const bool is_behind_value =
        is_word(before) || before == Token::Number || before == Token::Identifier || closes(before);
    const std::string_view name = file_.spelling(at.previous);
    return is_behind_value && upper_ascii(name) == name;
}

/// `=` where a value is over.
Done Complaints::check_assignment(const ParserPosition& position) {
    if (position.offending.token != Token::Assign) return kDone;
    const SourceRange range = file_.range(position.offending);
    if (is_word(position.previous.token)) {
        auto message = file_.sink.report(diag::AddressAsName, file_.range(position.previous));
        message.arg(quoted(position.previous));
        const std::string name = lower_ascii(file_.spelling(position.previous));
        if (is_declared(name))
            message.fix(file_.range(position.previous), name, "write it in lower case");
        else fix_control_variable(position.previous, message);
        return kFailed;
    }
    if (is_foreign_word(position)) {
        file_.sink.report(diag::BlockWordUnknown, file_.range(position.previous))
            .arg(file_.spelling(position.previous))
            .arg(dialect_.name())
            .fix(kForeignWord);
        return kFailed;
    }
    if (position.previous.token == Token::Identifier && is_word(position.head)) {
        // `Y=dZ=5`: the next word right behind a name.
        const std::string_view name = file_.spelling(position.previous);
        const std::size_t end = name.find_last_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ") + 1;
        const bool is_address = nc::word_kind(dialect_, name.substr(end)) == nc::WordKind::Address;
        if (end > 0 && end < name.size() && is_address && is_declared(name.substr(0, end))) {
            const std::uint32_t at = position.previous.begin + static_cast<std::uint32_t>(end);
            file_.sink.report(diag::AssignmentInValue, range)
                .fix(file_.range(at, at), " ", "a blank ends the name in front of the next word");
            return kFailed;
        }
    }
    if (!check_small_address(position)) return kFailed;
    const auto token_before = [&](std::size_t distance) {
        return position.index < distance ? Token::EndOfFile
                                         : stream_.lexeme(position.index - distance).token;
    };
    const bool is_first =
        token_before(2) == Token::OpenParen && token_before(3) == Token::Identifier;
    if (position.previous.token == Token::Identifier && position.rule == KadrParser::RuleSuffix &&
        (is_first || token_before(2) == Token::Comma)) {
        file_.sink.report(diag::ArgumentAssigned, range)
            .arg(quoted(position.previous))
            .fix(range, ":", "give the argument with `:`");
    } else {
        file_.sink.report(diag::AssignmentInValue, range).fix(range, "==", "to compare");
    }
    return kFailed;
}

/// `G1 x=10`: an address in small letters is a name, and no word.
Done Complaints::check_small_address(const ParserPosition& at) {
    if (at.previous.token != Token::Identifier || !is_word(at.head)) return kDone;
    const std::string_view name = file_.spelling(at.previous);
    const std::string address = upper_ascii(name);
    if (address == name || is_declared(name) ||
        nc::word_kind(dialect_, address) != nc::WordKind::Address)
        return kDone;
    const SourceRange word = file_.range(at.previous.begin, at.offending.end);
    file_.sink.report(diag::AssignmentInValue, word)
        .fix(word, address + "=", "words of blocks are written in upper case");
    return kFailed;
}

/// Two values, parameters or words in a row.
Done Complaints::check_comma(const ParserPosition& at) {
    const Token token = at.offending.token;
    const SourceRange gap = file_.range(at.previous.end, at.previous.end);
    const bool closes_list =
        (at.expects_only(Token::CloseParen) &&
         (at.rule == KadrParser::RuleSuffix || at.rule == KadrParser::RuleParameters ||
          at.rule == KadrParser::RuleModal)) ||
        (at.expects_only(Token::CloseParen) &&
         (at.head == Token::Require || at.head == Token::Assert)) ||
        at.expects_only(Token::CloseBrace) || at.expects(Token::Comma);
    if (closes_list && token == Token::Comma) {
        file_.sink.report(diag::ValueMissing, gap).arg(quoted(at.previous));
        return kFailed;
    }
    if (at.head == Token::Enum && is_word(token)) {
        file_.sink.report(diag::AddressAsName, file_.range(at.offending))
            .arg(quoted(at.offending))
            .fix(file_.range(at.offending), lower_ascii(file_.spelling(at.offending)),
                 "write it in lower case");
        return kFailed;
    }
    if (at.rule == KadrParser::RuleParameters || at.rule == KadrParser::RuleType) {
        const bool is_first =
            at.previous.token == Token::OpenParen || at.previous.token == Token::Comma;
        if (is_first) {
            file_.sink.report(diag::ParameterShape, file_.range(at.offending))
                .arg(quoted(at.offending));
            return kFailed;
        }
    }
    const bool begins_item = token == Token::Identifier || token == Token::Number ||
                             token == Token::Text || token == Token::TextOpen ||
                             token == Token::TypeName || token == Token::ArgumentName ||
                             token == Token::OpenValue;
    const bool is_preserved = at.expects(Token::OpenBrace) && is_word(token) &&
                              is_word(at.previous.token) && begins_declaration(at.head);
    if (!(closes_list && begins_item && at.head != Token::Switch) && !is_preserved) return kDone;
    if (!check_name_in_list(at)) return kFailed;
    file_.sink.report(diag::CommaMissing, gap)
        .arg(quoted(at.previous))
        .arg(quoted(at.offending))
        .fix(gap, ",", "separate them");
    return kFailed;
}

/// `drill(to: -5mm, dwell 0.2s)`, `int n 3` among parameters: a name and its value.
Done Complaints::check_name_in_list(const ParserPosition& at) {
    const Token token = at.offending.token;
    const bool is_value = token == Token::Number || token == Token::Text || token == Token::True ||
                          token == Token::False;
    if (at.previous.token != Token::Identifier || !is_value || at.index < 2) return kDone;
    const Token before = stream_.lexeme(at.index - 2).token;
    const bool is_argument = at.rule == KadrParser::RuleSuffix &&
                             (before == Token::Comma || before == Token::OpenParen) &&
                             !is_declared(file_.spelling(at.previous));
    const bool is_default = at.rule == KadrParser::RuleParameters;
    if (!is_argument && !is_default) return kDone;
    const SourceRange gap = file_.range(at.previous.end, at.previous.end);
    file_.sink.report(diag::SignMissing, gap)
        .arg(is_argument ? ":" : "=")
        .arg(quoted(at.previous))
        .fix(gap, is_argument ? ":" : " =",
             is_argument ? "between an argument's name and its value"
                         : "in front of the value of a parameter that is left out");
    return kFailed;
}

/// Something stands where a statement or a declaration should begin.
void Complaints::explain_start(antlr4::Parser& parser) {
    const std::size_t index = stream_.index();
    if (index == last_place_) return;
    last_place_ = index;
    const Lexeme& lexeme = stream_.lexeme(index);
    const SourceRange range = file_.range(lexeme);
    const bool is_file = parser.getContext()->getRuleIndex() == KadrParser::RuleFile;
    if (is_file && has_broken_blocks_) return;
    const bool follows_repair =
        lexeme.is_repair || (index > 0 && stream_.lexeme(index - 1).is_repair);
    if (follows_repair) return;
    if (is_file && file_.spelling(lexeme) == "include") {
        auto message = file_.sink.report(diag::IncludeWord, range);
        fix_include(index, message);
    } else if (is_file) {
        auto message = file_.sink.report(diag::StatementOutside, range);
        message.arg(quoted(lexeme));
        // A control's text begins with a word of it.
        const bool begins_text =
            is_word(lexeme.token) || lexeme.token == Token::Percent || lexeme.token == Token::Colon;
        if (index == 0 && begins_text)
            message.fix("the text of a control has another ending: `part.nc` is read with `-d`");
        else if (is_program_number(lexeme)) fix_program_number(lexeme, message);
    } else if (lexeme.token == Token::Else) {
        file_.sink.report(diag::ElseWithoutIf, range);
    } else if (lexeme.token == Token::Case || lexeme.token == Token::Default) {
        file_.sink.report(diag::CaseOutside, range).arg(quoted(lexeme));
    } else if (begins_declaration(lexeme.token)) {
        auto message = file_.sink.report(diag::DeclarationInside, range);
        message.arg(quoted(lexeme));
        // `struct hole h;` as in C.
        const bool is_type = lexeme.token == Token::Struct || lexeme.token == Token::Enum;
        if (is_type && index + 2 < stream_.size() &&
            stream_.lexeme(index + 1).token == Token::Identifier &&
            stream_.lexeme(index + 2).token == Token::Identifier) {
            message.fix(file_.range(lexeme.begin, stream_.lexeme(index + 1).begin), "",
                        "if a variable is meant: the name alone is the type");
        }
        lose_names(index);
    } else {
        file_.sink.report(diag::StatementStart, range).arg(quoted(lexeme));
    }
    if (limit_.is_full()) throw antlr4::ParseCancellationException();
}

}  // namespace kadr::syntax
