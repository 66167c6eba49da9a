#include "syntax/complain.h"

#include <algorithm>

#include "base/assert.h"
#include "base/diagnostics/dialect.h"
#include "base/diagnostics/syntax.h"
#include "base/text.h"
#include "syntax/habits.h"
#include "syntax/keyword.h"
#include "syntax/operators.h"
#include "syntax/parse.h"
#include "syntax/words.h"

namespace kadr::syntax {

namespace {

bool is_word(Token token) {
    return token == Token::LiteralWord || token == Token::BareWord || token == Token::Address;
}

bool opens(Token token) {
    return token == Token::OpenParen || token == Token::OpenBracket || token == Token::OpenBrace ||
           token == Token::OpenValue;
}

bool closes(Token token) {
    return token == Token::CloseParen || token == Token::CloseBracket || token == Token::CloseBrace;
}

/// Words that can only begin a declaration of a file.
bool begins_declaration(Token token) {
    switch (token) {
        case Token::Cycle:
        case Token::Program:
        case Token::Curve:
        case Token::Test:
        case Token::Property:
        case Token::Struct:
        case Token::Enum:
        case Token::Import:
        case Token::Include:
        case Token::Language:
        case Token::Dialect: return true;
        default: return false;
    }
}

/// Words that only begin a statement.
bool begins_statement(Token token) {
    switch (token) {
        case Token::If:
        case Token::While:
        case Token::Do:
        case Token::For:
        case Token::Switch:
        case Token::Break:
        case Token::Continue:
        case Token::Return:
        case Token::With:
        case Token::Const:
        case Token::Auto:
        case Token::TypeName:
        case Token::Note:
        case Token::Raw:
        case Token::Require:
        case Token::Assert:
        case Token::ErrorWord:
        case Token::Warn:
        case Token::Expect:
        case Token::Assume:
        case Token::Close: return true;
        default: return begins_declaration(token);
    }
}

bool is_keyword(Token token) { return token >= Token::If && token <= Token::Contains; }

}  // namespace

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

/// Where the parser stands and what it could go on with.
struct Complaints::Place {
    std::size_t index;
    const Lexeme& offending;
    const Lexeme& previous;
    antlr4::misc::IntervalSet expected;
    std::size_t rule;  // innermost
    Token head;        // first token of the statement or declaration around
    std::size_t head_index;
    bool is_new_line;

    bool expects(Token token) const {
        return expected.contains(token == Token::EndOfFile ? antlr4::Token::EOF
                                                           : static_cast<std::size_t>(token));
    }
    /// Whether nothing but this token can go on.
    bool expects_only(Token token) const { return expects(token) && expected.size() == 1; }
};

Complaints::Place Complaints::place_of(antlr4::Parser& parser, std::size_t index) {
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
    const Place place = place_of(parser, index);
    // What was put in or left out around here is told already.
    if (place.previous.is_repair || place.offending.is_repair) return;
    explain(place);
    lose_variable(place);
    if (limit_.is_full()) throw antlr4::ParseCancellationException();
}

bool Complaints::is_semicolon_forgotten(const Place& place) const {
    if (!place.expects(Token::Semicolon)) return false;
    const Token token = place.offending.token;
    // `return if;`: hardly two statements in one line.
    if (place.previous.token == Token::Return && !place.is_new_line && begins_statement(token))
        return false;
    return place.is_new_line || token == Token::CloseBrace || token == Token::EndOfFile ||
           begins_statement(token);
}

void Complaints::explain(const Place& place) {
    if (explain_glued_words(place) || explain_number(place) || explain_capitals(place) ||
        explain_program_number(place) || explain_habit(place) || explain_for(place) ||
        explain_declaration(place) || explain_name(place) || explain_value(place) ||
        explain_sign(place) || explain_closing(place)) {
        return;
    }
    const SourceRange range = file_.range(place.offending);
    if (place.offending.token == Token::Else && place.expects(Token::Semicolon)) {
        const SourceRange gap = file_.range(place.previous.end, place.previous.end);
        file_.sink.report(diag::SemicolonMissing, gap).arg("this block").fix(gap, ";", "end it");
    } else if (place.expects(Token::OpenBrace) && place.rule == KadrParser::RuleBlock) {
        const SourceRange gap = file_.range(place.previous.end, place.previous.end);
        file_.sink.report(diag::BodyMissing, gap).arg(quoted(place.previous));
    } else if (place.head == Token::Switch && place.expects_only(Token::CloseBrace)) {
        file_.sink.report(diag::CaseMissing, range).arg(quoted(place.offending));
    } else {
        auto report = file_.sink.report(diag::Unexpected, range);
        report.arg(quoted(place.offending)).arg(quoted(place.previous));
        if (!fix_sign(place, report)) fix_operator(place, report);
    }
}

/// Whether the lexeme is the last of its line.
bool Complaints::ends_line(std::size_t index) const {
    return index + 1 >= stream_.size() || stream_.lexeme(index + 1).token == Token::EndOfFile ||
           file_.crosses_line(stream_.lexeme(index).end, stream_.lexeme(index + 1).begin);
}

/// The bracket that closes the one at `open`; the last lexeme if none does.
std::size_t Complaints::matching(std::size_t open) const {
    std::size_t depth = 0;
    for (std::size_t i = open; i < stream_.size(); ++i) {
        if (opens(stream_.lexeme(i).token)) ++depth;
        if (closes(stream_.lexeme(i).token) && --depth == 0) return i;
    }
    return stream_.size() - 1;
}

/// `(int)x`.
bool Complaints::is_cast(const Place& place) const {
    if (place.previous.token != Token::CloseParen || place.index < 3) return false;
    const std::string_view type = file_.spelling(stream_.lexeme(place.index - 2));
    constexpr std::string_view kTypes[] = {"int", "real", "float", "double", "long", "bool"};
    return stream_.lexeme(place.index - 3).token == Token::OpenParen &&
           std::ranges::find(kTypes, type) != std::end(kTypes);
}

/// Signs as other languages have them; false: it is none of those.
bool Complaints::fix_sign(const Place& place, DiagnosticBuilder& report) const {
    const Token before = place.previous.token;
    const Lexeme& offending = place.offending;
    const Lexeme& next = stream_.lexeme(std::min(place.index + 1, stream_.size() - 1));
    const bool is_joined = place.previous.end == offending.begin;
    const SourceRange both = file_.range(place.previous.begin, offending.end);
    const auto is = [&](Token first, Token second) {
        return is_joined && before == first && offending.token == second;
    };
    if (is(Token::Minus, Token::Greater)) {
        report.fix(both, ".", "a member stands behind a point");
    } else if (is(Token::Less, Token::Greater)) {
        report.fix(both, "!=", "unequal");
    } else if (is(Token::Star, Token::Star)) {
        report.fix("a power is `pow(a, n)`");
    } else if (offending.token == Token::And && before == Token::Assign) {
        report.fix("there are no pointers: a parameter `int& n` is the caller's own variable");
    } else if (offending.token == Token::Colon && next.token == Token::Assign) {
        report.fix(file_.range(offending.begin, next.end), "=", "assign");
    } else if (offending.token == Token::Colon && place.head_index + 1 == place.index) {
        report.fix("there are no labels and no jumps: `while` and `for` repeat");
    } else if (offending.token == Token::Comma && is_word(place.head)) {
        report.fix(file_.range(offending), "", "the words of a block have no commas between them");
    } else if (is_cast(place)) {
        report.fix("a value becomes a number of another kind by a call: `int(x)`, `round(x)`");
    } else {
        return false;
    }
    return true;
}

/// `and`, `OR`, `not`: words of other languages.
void Complaints::fix_operator(const Place& place, DiagnosticBuilder& report) const {
    constexpr std::pair<std::string_view, std::string_view> kWords[] = {
        {"and", "&&"},
        {"or", "||"},
        {"mod", "%"},
        {"div", "/"},
    };
    if (lower_ascii(file_.spelling(place.previous)) == "not") {
        report.fix("the operator is `!`, in front of parentheses: `!(n > 3)`");
        return;
    }
    for (const Lexeme* lexeme : {&place.offending, &place.previous}) {
        const std::string word = lower_ascii(file_.spelling(*lexeme));
        for (const auto& [name, sign] : kWords) {
            if (word != name || lexeme->token != Token::Identifier) continue;
            report.fix(file_.range(*lexeme), std::string(sign), "the operator has a sign");
            return;
        }
    }
}

/// `10,5` and `10 mm`.
bool Complaints::explain_number(const Place& place) {
    const Lexeme& previous = place.previous;
    const Lexeme& offending = place.offending;
    const bool is_number = previous.token == Token::Number || previous.token == Token::LiteralWord;
    if (!is_number || place.is_new_line) return false;
    const std::string spelled(file_.spelling(previous));
    const auto& next = stream_.lexeme(std::min(place.index + 1, stream_.size() - 1));
    const bool is_whole = spelled.find('.') == std::string::npos;
    if (offending.token == Token::Comma && next.token == Token::Number && is_whole &&
        previous.end == offending.begin && next.begin == offending.end) {
        const SourceRange whole = file_.range(previous.begin, next.end);
        file_.sink.report(diag::DecimalComma, whole)
            .arg(file_.text.substr(previous.begin, next.end - previous.begin))
            .fix(file_.range(offending), ".", "write a point");
        return true;
    }
    if (offending.token != Token::Identifier || previous.unit != Unit::None) return false;
    const std::string_view name = file_.spelling(offending);
    const auto& per = stream_.lexeme(std::min(place.index + 2, stream_.size() - 1));
    const bool is_quotient = next.token == Token::Slash && per.token == Token::Identifier &&
                             find_unit(name, file_.spelling(per)) != Unit::None;
    if (!is_quotient && find_unit(name, "") == Unit::None) return false;
    std::string unit(name);
    if (is_quotient) unit += '/' + std::string(file_.spelling(per));
    const std::uint32_t end = is_quotient ? per.end : offending.end;
    file_.sink.report(diag::UnitApart, file_.range(offending.begin, end))
        .arg(unit)
        .fix(file_.range(previous.begin, end), spelled + unit, "write it right behind the number");
    return true;
}

/// `IF (n > 3) M8;`: a call of `IF` to the parser.
bool Complaints::explain_capitals(const Place& place) {
    // `WHILE n<3 DO1;` begins like a declaration of `n`.
    const bool is_name = place.head == Token::Identifier || place.head == Token::TypeName;
    if (!is_name || place.head_index == place.index) return false;
    const Lexeme& head = stream_.lexeme(place.head_index);
    const std::string_view spelled = file_.spelling(head);
    const std::string lower = lower_ascii(spelled);
    const Keyword* keyword = find_keyword(lower);
    if (lower == spelled || keyword == nullptr || keyword->place != Keyword::Place::Anywhere)
        return false;
    auto report = file_.sink.report(diag::KeywordCase, file_.range(head));
    report.arg(lower);
    if (const std::string form = form_of_statement(lower, place.head_index); !form.empty())
        report.fix(form);
    else report.fix(file_.range(head), lower, "write it in lower case");
    return true;
}

/// How a statement of a control's language is written here, where small letters alone do not make
/// it one: `IF R1<3 GOTO N10;`. Empty: they do.
std::string Complaints::form_of_statement(std::string_view keyword, std::size_t head) const {
    constexpr std::pair<std::string_view, std::string_view> kForms[] = {
        {"if", "`if (a < 3) { … } else { … }`"},
        {"while", "`while (a < 3) { … }`"},
        {"for", "`for (int i = 0; i < n; i++) { … }`"},
    };
    const auto* const form =
        std::ranges::find(kForms, keyword, [](const auto& f) { return f.first; });
    if (form == std::end(kForms)) return "";
    bool jumps = false;
    bool has_brace = false;
    std::size_t end = head + 1;
    for (; !ends_line(end - 1) && stream_.lexeme(end).token != Token::Semicolon; ++end) {
        const std::string word = lower_ascii(file_.spelling(stream_.lexeme(end)));
        jumps |= word.starts_with("goto");
        has_brace |= stream_.lexeme(end).token == Token::OpenBrace;
    }
    const bool is_lowered_only = stream_.lexeme(head + 1).token == Token::OpenParen && !jumps &&
                                 (has_brace || matching(head + 1) + 1 < end);
    if (is_lowered_only) return "";
    return "it is written " + std::string(form->second) +
           (jumps ? "; there are no jumps, what is left out or repeated stands in its braces" : "");
}

/// A statement that begins with a word of another language: `foreach (x in list)`, `goto 5`.
bool Complaints::explain_habit(const Place& place) {
    const Lexeme& head = stream_.lexeme(place.head_index);
    // `static int k = 3;`: a type to the parser, and `int` the name.
    const bool is_type = head.token == Token::TypeName && place.index <= place.head_index + 2;
    if (head.token != Token::Identifier && !is_type) return false;
    if (place.head_index >= place.index) return false;
    const Habit* habit = habit_of(file_.spelling(head));
    if (habit == nullptr || !habit->is_statement) return false;
    // A name of the program may be spelled so: `end = 3`, `loop.count`.
    switch (stream_.lexeme(place.head_index + 1).token) {
        case Token::Assign:
        case Token::Dot:
        case Token::OpenBracket:
        case Token::Semicolon: return false;
        default: break;
    }
    file_.sink.report(diag::Unexpected, file_.range(place.offending))
        .arg(quoted(place.offending))
        .arg(quoted(place.previous))
        .fix(std::string(habit->hint));
    return true;
}

/// A line `O1234` of a control's text above the program: a type to the parser, and `program` a
/// name.
bool Complaints::explain_program_number(const Place& place) {
    if (place.head_index + 2 != place.index) return false;
    const Lexeme& head = stream_.lexeme(place.head_index);
    const std::string_view spelled = file_.spelling(head);
    const bool is_number = spelled.size() > 1 && spelled[0] == 'O' &&
                           spelled.find_first_not_of("0123456789", 1) == std::string_view::npos;
    if (!is_number) return false;
    file_.sink.report(diag::StatementOutside, file_.range(head))
        .arg(quoted(head))
        .fix("a program that is called so has this number: `program " + std::string(spelled) +
             "() { … }`");
    return true;
}

/// The head of a `for`: which of its two kinds it is shows only at its third token.
bool Complaints::explain_for(const Place& place) {
    if (place.rule != KadrParser::RuleForHead) return false;
    const SourceRange gap = file_.range(place.previous.end, place.previous.end);
    const bool is_declared =
        place.previous.token == Token::TypeName || place.previous.token == Token::Auto;
    if (is_declared && is_word(place.offending.token)) {
        explain_address_name(place.offending);
        return true;
    }
    if (place.offending.token == Token::Colon) {
        file_.sink.report(diag::ForTypeMissing, file_.range(place.previous))
            .arg(quoted(place.previous));
        return true;
    }
    if (place.previous.token != Token::Identifier || !place.expects(Token::Number)) return false;
    const bool is_list =
        place.offending.token == Token::Identifier || place.offending.token == Token::In;
    auto message = file_.sink.report(diag::SignMissing, gap);
    message.arg(is_list ? ":" : "=").arg(quoted(place.previous));
    if (lower_ascii(file_.spelling(place.offending)) == "in")
        message.fix(file_.range(place.offending), ":", "a loop over a list has a sign");
    return true;
}

/// Where nothing but one sign can stand.
bool Complaints::explain_sign(const Place& place) {
    if (place.expects(Token::Text) && place.rule == KadrParser::RuleText) {
        file_.sink.report(diag::TitleMissing, file_.range(place.offending))
            .arg(quoted(place.previous));
        return true;
    }
    constexpr std::pair<Token, const char*> kSigns[] = {
        {Token::OpenParen, "("}, {Token::Colon, ":"}, {Token::While, "while"},
        {Token::Over, "over"},   {Token::In, "in"},
    };
    const SourceRange gap = file_.range(place.previous.end, place.previous.end);
    for (const auto& [token, sign] : kSigns) {
        if (!place.expects_only(token)) continue;
        auto message = file_.sink.report(diag::SignMissing, gap);
        message.arg(sign).arg(quoted(place.previous));
        if (token == Token::OpenParen) fix_parentheses(place, message);
        return true;
    }
    const bool is_for = place.rule == KadrParser::RuleForHead;
    const bool is_field = place.rule == KadrParser::RuleField;
    if (place.expects_only(Token::Semicolon) && (is_for || is_field) && !place.is_new_line) {
        auto message = file_.sink.report(diag::SignMissing, gap);
        message.arg(";").arg(quoted(place.previous));
        if (is_for && place.offending.token == Token::Comma) fix_comma_of_loop(place, message);
        return true;
    }
    const bool is_name_first = place.previous.token == Token::Identifier;
    if (place.expects_only(Token::Assign) && is_name_first) {
        file_.sink.report(diag::SignMissing, gap).arg("=").arg(quoted(place.previous));
        return true;
    }
    return false;
}

/// The last comma in front of the bracket that closes the list in which one stands, without
/// brackets between them.
std::size_t Complaints::last_comma(std::size_t index) const {
    std::size_t last = index;
    for (; !opens(stream_.lexeme(index).token) && !closes(stream_.lexeme(index).token); ++index) {
        if (index + 1 >= stream_.size()) break;
        if (stream_.lexeme(index).token == Token::Comma) last = index;
    }
    return last;
}

/// `for (int i = 0, i < 5, i++)`, but `for (int i = 0, j = 1; …)`.
void Complaints::fix_comma_of_loop(const Place& place, DiagnosticBuilder& report) const {
    const std::string_view next = file_.spelling(stream_.lexeme(place.index + 1));
    for (std::size_t i = place.index; i > 0 && stream_.lexeme(i).token != Token::OpenParen; --i) {
        const bool is_asked = stream_.lexeme(i).token == Token::Assign &&
                              file_.spelling(stream_.lexeme(i - 1)) == next;
        if (!is_asked) continue;
        const std::size_t last = last_comma(place.index);
        std::string parts(file_.text.substr(place.offending.begin,
                                            stream_.lexeme(last).end - place.offending.begin));
        std::ranges::replace(parts, ',', ';');
        return void(report.fix(file_.range(place.offending.begin, stream_.lexeme(last).end), parts,
                               "semicolons stand between the parts of a loop"));
    }
    report.fix("a loop has one variable: declare the others before it");
}

/// What a keyword is followed by, in parentheses: up to the body or the end of the statement.
void Complaints::fix_parentheses(const Place& place, DiagnosticBuilder& report) const {
    std::size_t end = place.index;
    for (std::size_t depth = 0; end < stream_.size(); ++end) {
        const Token token = stream_.lexeme(end).token;
        const bool is_end = token == Token::OpenBrace || token == Token::OpenValue ||
                            token == Token::EndOfFile ||
                            (token == Token::Semicolon && place.previous.token != Token::For);
        const bool is_word_of_others =
            token == Token::Identifier && habit_of(file_.spelling(stream_.lexeme(end))) != nullptr;
        const bool is_body = begins_statement(token) || is_word(token) || is_word_of_others;
        if (depth == 0 && (is_end || (end > place.index && is_body))) break;
        if (opens(token)) ++depth;
        if (closes(token) && depth > 0) --depth;
    }
    if (end == place.index) {
        const bool is_empty = place.previous.token == Token::Identifier;  // `program p {`
        const SourceRange gap = file_.range(place.previous.end, place.previous.end);
        if (is_empty) report.fix(gap, "()", "without parameters they are empty");
        else report.fix(file_.range(place.offending.begin, place.offending.begin), "(", "open it");
        return;
    }
    const SourceRange range = file_.range(place.offending.begin, stream_.lexeme(end - 1).end);
    // `for i in 1..5`
    const bool is_loop = place.previous.token == Token::For && end > place.index + 2 &&
                         place.offending.token == Token::Identifier &&
                         lower_ascii(file_.spelling(stream_.lexeme(place.index + 1))) == "in";
    if (is_loop) {
        const Lexeme& first = stream_.lexeme(place.index + 2);
        const std::string list(file_.text.substr(first.begin, range.end - first.begin));
        const std::string type = list.find("..") != list.npos ? "int " : "auto ";
        report.fix(range,
                   '(' + type + std::string(file_.spelling(place.offending)) + " : " + list + ')',
                   "a loop over a list");
        return;
    }
    report.fix(range,
               "(" + std::string(file_.text.substr(range.begin, range.end - range.begin)) + ")",
               "put it in parentheses");
}

/// A function inside of a function: `length f(length x) {`.
bool Complaints::explain_declaration(const Place& place) {
    const bool is_variable = place.head == Token::TypeName && place.rule != KadrParser::RuleFile;
    if (!is_variable || place.offending.token != Token::OpenParen ||
        place.previous.token != Token::Identifier || !place.expects(Token::Semicolon)) {
        return false;
    }
    lost_names_.emplace_back(file_.spelling(place.previous));
    file_.sink.report(diag::DeclarationInside, file_.range(place.previous))
        .arg("the function " + quoted(place.previous));
    return true;
}

/// The variable or cycle whose declaration has this mistake: its name is no second one.
void Complaints::lose_variable(const Place& place) {
    if (place.head == Token::Cycle || place.head == Token::Curve)
        return lose_names(place.head_index);
    const bool is_variable =
        place.head == Token::TypeName || place.head == Token::Const || place.head == Token::Auto;
    if (!is_variable) return;
    for (std::size_t i = place.head_index; i < place.index; ++i) {
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

/// An address in the place of a name.
void Complaints::explain_address_name(const Lexeme& lexeme) {
    const std::string_view spelled = file_.spelling(lexeme);
    bad_names_.insert(std::string(spelled));
    const SourceRange range = file_.range(lexeme);
    file_.sink.report(diag::AddressAsName, range)
        .arg(quoted(lexeme))
        .fix(range, lower_ascii(spelled), "write it in lower case");
}

/// Where a name must stand.
bool Complaints::explain_name(const Place& place) {
    if (!place.expects(Token::Identifier) || place.expected.size() > 3) return false;
    const Lexeme& offending = place.offending;
    const SourceRange range = file_.range(offending);
    if (is_word(offending.token)) {
        explain_address_name(offending);
    } else if (is_keyword(offending.token)) {
        file_.sink.report(diag::KeywordAsName, range).arg(quoted(offending));
    } else {
        file_.sink.report(diag::NameMissing, file_.range(place.previous.end, place.previous.end))
            .arg(quoted(place.previous))
            .arg(quoted(offending));
    }
    return true;
}

/// Where a value must stand.
bool Complaints::explain_value(const Place& place) {
    if (!place.expects(Token::Number) || place.expects(Token::If)) return false;
    if (place.expects(Token::Semicolon) && place.offending.token != Token::Semicolon) {
        return false;  // the value is not needed
    }
    const Lexeme& offending = place.offending;
    const SourceRange gap = file_.range(place.previous.end, place.previous.end);
    const bool is_text_meant = place.head == Token::Raw || place.head == Token::Note;
    // In `X=a* Y5` a value was forgotten, in `X=a*R5` the word was meant as one.
    const bool is_next_word = is_word(place.head) && place.previous.end != offending.begin;
    if (is_word(offending.token) && !is_text_meant && !is_next_word) {
        const std::string_view spelled = file_.spelling(offending);
        if (bad_names_.count(std::string(spelled)) > 0) return true;
        file_.sink.report(diag::WordAsValue, file_.range(offending))
            .arg(quoted(offending))
            .fix(file_.range(offending), lower_ascii(spelled),
                 "if a variable is meant: names of variables are not addresses");
        return true;
    }
    auto message = file_.sink.report(diag::ValueMissing, gap);
    message.arg(quoted(place.previous));
    if (offending.token == Token::OpenBracket) fix_brackets(place, message);
    else fix_sign(place, message);
    return true;
}

/// The text between a bracket and the one that closes it, with round brackets for the square ones
/// that group as controls have them: `[d + 1]`, but `list[0]`.
std::string Complaints::round_brackets(std::size_t open) const {
    const std::size_t close = matching(open);
    std::vector<bool> is_group;
    std::string text;
    std::uint32_t copied = stream_.lexeme(open).end;
    const auto exchange = [&](const Lexeme& bracket, char round) {
        text += file_.text.substr(copied, bracket.begin - copied);
        text += round;
        copied = bracket.end;
    };
    for (std::size_t i = open + 1; i < close; ++i) {
        const Lexeme& lexeme = stream_.lexeme(i);
        if (opens(lexeme.token)) {
            const Token before = stream_.lexeme(i - 1).token;
            is_group.push_back(lexeme.token == Token::OpenBracket && before != Token::Identifier &&
                               !closes(before));
            if (is_group.back()) exchange(lexeme, '(');
        } else if (closes(lexeme.token) && !is_group.empty()) {
            if (is_group.back()) exchange(lexeme, ')');
            is_group.pop_back();
        }
    }
    return text + std::string(file_.text.substr(copied, stream_.lexeme(close).begin - copied));
}

/// Whether the value of a word ends in front of this token.
bool ends_value(Token token) {
    return token == Token::Semicolon || token == Token::EndOfFile || is_word(token) ||
           token == Token::CloseBrace;
}

/// `X d`, `X-d`, `X(d)`, `X[d*2]`: the address with its value behind `=`.
void Complaints::fix_word_value(const Place& place, DiagnosticBuilder& report) const {
    const Token token = place.offending.token;
    const bool is_bracket = token == Token::OpenBracket || token == Token::OpenParen;
    const bool begins_value =
        is_bracket || token == Token::Identifier || token == Token::Minus || token == Token::Plus;
    if (place.is_new_line || !begins_value) return;
    if (!is_bracket) {
        report.fix(file_.range(place.previous.end, place.offending.begin), "=", kValueBehindSign);
        return;
    }
    const std::size_t close = matching(place.index);
    const bool is_whole = ends_value(stream_.lexeme(close + 1).token);
    const std::string inside = round_brackets(place.index);
    report.fix(file_.range(place.previous.end, stream_.lexeme(close).end),
               is_whole ? '=' + inside : "=(" + inside + ')', kValueBehindSign);
}

/// Whether a comma stands between two brackets, outside of those inside.
bool Complaints::is_list(std::size_t open, std::size_t close) const {
    std::size_t depth = 0;
    for (std::size_t i = open + 1; i < close; ++i) {
        const Token token = stream_.lexeme(i).token;
        if (opens(token)) ++depth;
        else if (closes(token) && depth > 0) --depth;
        else if (token == Token::Comma && depth == 0) return true;
    }
    return false;
}

/// `X=[d*2]`, `a*[b+c]`: square brackets that group; `[1mm, 2mm]`: those of a list.
void Complaints::fix_brackets(const Place& place, DiagnosticBuilder& report) const {
    const std::size_t close = matching(place.index);
    if (stream_.lexeme(close).token != Token::CloseBracket) return;
    const bool is_whole =
        place.previous.token == Token::Assign && ends_value(stream_.lexeme(close + 1).token);
    const SourceRange range = file_.range(place.offending.begin, stream_.lexeme(close).end);
    const std::string inside = round_brackets(place.index);
    if (is_whole && is_list(place.index, close))
        report.fix(range, '{' + inside + '}', "the values of a list stand in braces");
    else report.fix(range, is_whole ? inside : '(' + inside + ')', "parentheses are round");
}

/// `G1 Xd Yd Zd;`: words whose values are names without `=`. One or two of them are a point and
/// another one to the grammar; of more the parser stops at the last.
bool Complaints::explain_glued_words(const Place& place) {
    const auto is_glued = [&](std::size_t i) {
        const Lexeme& lexeme = stream_.lexeme(i);
        return lexeme.token == Token::Identifier &&
               glued_address(dialect_, file_.spelling(lexeme)) > 0;
    };
    if (!is_word(place.head) || !is_glued(place.index)) return false;
    for (std::size_t i = place.head_index; i <= place.index; ++i) {
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
    return true;
}

/// Where something must end: a statement, brackets, a list.
bool Complaints::explain_closing(const Place& place) {
    const Lexeme& offending = place.offending;
    const SourceRange range = file_.range(offending);
    const SourceRange gap = file_.range(place.previous.end, place.previous.end);
    if (place.expects(Token::If)) {
        file_.sink.report(diag::StatementMissing, gap).arg(quoted(place.previous));
        return true;
    }
    if (place.previous.token == Token::Address && place.expects(Token::Assign)) {
        auto report = file_.sink.report(diag::WordWithoutValue, file_.range(place.previous));
        report.arg(quoted(place.previous));
        fix_word_value(place, report);
        return true;
    }
    const bool is_variable =
        place.head == Token::TypeName || place.head == Token::Const || place.head == Token::Auto;
    if (is_semicolon_forgotten(place)) {
        const char* what =
            is_word(place.head) ? "this block"
            : is_variable || begins_declaration(place.head) || place.head == Token::Contour
                ? "this declaration"
                : "this statement";
        file_.sink.report(diag::SemicolonMissing, gap).arg(what).fix(gap, ";", "end it");
        return true;
    }
    if (is_variable && place.expects(Token::Semicolon) && offending.token == Token::OpenBracket) {
        auto message = file_.sink.report(diag::ArrayBrackets, range);
        message.arg(file_.spelling(place.previous));
        std::size_t close = place.index;
        while (close + 1 < stream_.size() && stream_.lexeme(close).token != Token::CloseBracket &&
               stream_.lexeme(close).token != Token::Semicolon)
            ++close;
        if (place.index >= 2 && stream_.lexeme(close).token == Token::CloseBracket) {
            const std::uint32_t type_end = stream_.lexeme(place.index - 2).end;
            const std::uint32_t end = stream_.lexeme(close).end;
            message.fix(file_.range(type_end, end),
                        std::string(file_.text.substr(offending.begin, end - offending.begin)) +
                            ' ' + std::string(file_.spelling(place.previous)),
                        "put them behind the type");
        }
        return true;
    }
    if (is_variable && place.expects(Token::Semicolon) && offending.token == Token::Comma) {
        const std::uint32_t begin = stream_.lexeme(place.head_index).begin;
        std::uint32_t end = begin;  // of the type
        for (std::size_t i = place.head_index; stream_.lexeme(i).token != Token::Identifier; ++i)
            end = stream_.lexeme(i).end;
        file_.sink.report(diag::SeveralNames, range)
            .fix(range, "; " + std::string(file_.text.substr(begin, end - begin)),
                 "end the declaration and begin another one");
        return true;
    }
    return explain_assignment(place) || explain_comma(place);
}

/// `G1 X10 Q=5;`, `Q` being no address of the dialect.
bool Complaints::is_foreign_word(const Place& place) const {
    if (!is_word(place.head) || place.previous.token != Token::Identifier || place.index < 2)
        return false;
    const Token before = stream_.lexeme(place.index - 2).token;
    const bool is_behind_value =
        is_word(before) || before == Token::Number || before == Token::Identifier || closes(before);
    const std::string_view name = file_.spelling(place.previous);
    return is_behind_value && upper_ascii(name) == name;
}

/// `=` where a value is over.
bool Complaints::explain_assignment(const Place& place) {
    if (place.offending.token != Token::Assign) return false;
    const SourceRange range = file_.range(place.offending);
    if (is_word(place.previous.token)) {
        file_.sink.report(diag::AddressAsName, file_.range(place.previous))
            .arg(quoted(place.previous))
            .fix(file_.range(place.previous), lower_ascii(file_.spelling(place.previous)),
                 "write it in lower case");
        return true;
    }
    if (is_foreign_word(place)) {
        file_.sink.report(diag::BlockWordUnknown, file_.range(place.previous))
            .arg(file_.spelling(place.previous))
            .arg(dialect_.name())
            .fix(kForeignWord);
        return true;
    }
    const auto token_before = [&](std::size_t distance) {
        return place.index < distance ? Token::EndOfFile
                                      : stream_.lexeme(place.index - distance).token;
    };
    const bool is_first =
        token_before(2) == Token::OpenParen && token_before(3) == Token::Identifier;
    if (place.previous.token == Token::Identifier && place.rule == KadrParser::RuleSuffix &&
        (is_first || token_before(2) == Token::Comma)) {
        file_.sink.report(diag::ArgumentAssigned, range)
            .arg(quoted(place.previous))
            .fix(range, ":", "give the argument with `:`");
    } else {
        file_.sink.report(diag::AssignmentInValue, range).fix(range, "==", "to compare");
    }
    return true;
}

/// Two values, parameters or words in a row.
bool Complaints::explain_comma(const Place& place) {
    const Token token = place.offending.token;
    const SourceRange gap = file_.range(place.previous.end, place.previous.end);
    const bool closes_list =
        (place.expects_only(Token::CloseParen) &&
         (place.rule == KadrParser::RuleSuffix || place.rule == KadrParser::RuleParameters ||
          place.rule == KadrParser::RuleModal)) ||
        (place.expects_only(Token::CloseParen) &&
         (place.head == Token::Require || place.head == Token::Assert)) ||
        place.expects_only(Token::CloseBrace) || place.expects(Token::Comma);
    if (closes_list && token == Token::Comma) {
        file_.sink.report(diag::ValueMissing, gap).arg(quoted(place.previous));
        return true;
    }
    if (place.head == Token::Enum && is_word(token)) {
        file_.sink.report(diag::AddressAsName, file_.range(place.offending))
            .arg(quoted(place.offending))
            .fix(file_.range(place.offending), lower_ascii(file_.spelling(place.offending)),
                 "write it in lower case");
        return true;
    }
    if (place.rule == KadrParser::RuleParameters || place.rule == KadrParser::RuleType) {
        const bool is_first =
            place.previous.token == Token::OpenParen || place.previous.token == Token::Comma;
        if (is_first) {
            file_.sink.report(diag::ParameterShape, file_.range(place.offending))
                .arg(quoted(place.offending));
            return true;
        }
    }
    const bool begins_item = token == Token::Identifier || token == Token::Number ||
                             token == Token::Text || token == Token::TextOpen ||
                             token == Token::TypeName || token == Token::ArgumentName ||
                             token == Token::OpenValue;
    const bool is_preserved = place.expects(Token::OpenBrace) && is_word(token) &&
                              is_word(place.previous.token) && begins_declaration(place.head);
    if (!(closes_list && begins_item && place.head != Token::Switch) && !is_preserved) return false;
    file_.sink.report(diag::CommaMissing, gap)
        .arg(quoted(place.previous))
        .arg(quoted(place.offending))
        .fix(gap, ",", "separate them");
    return true;
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
        file_.sink.report(diag::IncludeWord, range).fix(range, "import", "use `import`");
    } else if (is_file) {
        file_.sink.report(diag::StatementOutside, range).arg(quoted(lexeme));
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

// ---------------------------------------------------------------- where it goes on

void Complaints::reportError(antlr4::Parser* parser, const antlr4::RecognitionException& e) {
    std::size_t index = stream_.index();
    if (e.getOffendingToken() != nullptr) {
        index = std::max(index, e.getOffendingToken()->getTokenIndex());
    }
    complain(*parser, index);
}

/// A single token is missing. `;` is put in, an address in the place of a name is taken for it;
/// everything else ends the statement.
antlr4::Token* Complaints::recoverInline(antlr4::Parser* parser) {
    const std::size_t index = stream_.index();
    const Place place = place_of(*parser, index);
    const bool is_name = place.expects_only(Token::Identifier) && is_word(place.offending.token);
    const bool is_semicolon = place.expects_only(Token::Semicolon) && is_semicolon_forgotten(place);
    if (!is_name && !is_semicolon) throw antlr4::InputMismatchException(parser);
    complain(*parser, index);
    Lexeme lexeme = place.offending;
    if (is_name) {
        lexeme.token = Token::Identifier;
        lexeme.text = file_.texts.intern(file_.spelling(lexeme));
        stream_.consume();
    } else {
        lexeme.token = Token::Semicolon;
        lexeme.begin = lexeme.end = place.previous.end;
    }
    // The parser hangs tokens without an index into the tree itself.
    conjured_.emplace_back(lexeme, INVALID_INDEX);
    return &conjured_.back();
}

void Complaints::recover(antlr4::Parser* parser, std::exception_ptr e) {
    antlr4::ParserRuleContext& context = *parser->getContext();
    switch (context.getRuleIndex()) {
        case KadrParser::RuleParameters: return skip_parameters(context);
        case KadrParser::RuleStatement:
        case KadrParser::RuleDeclaration: return skip_statement(*parser, context);
        case KadrParser::RuleSwitchCase: return skip_statement(*parser, context);
        case KadrParser::RuleFile: return;
        default: std::rethrow_exception(e);
    }
}

/// The brackets that are open between the start of a rule and the place of the parser.
std::vector<Token> Complaints::open_brackets(const antlr4::ParserRuleContext& context) const {
    std::vector<Token> open;
    for (std::size_t i = context.start->getTokenIndex(); i < stream_.place(); ++i) {
        const Token token = stream_.lexeme(i).token;
        if (opens(token)) open.push_back(token);
        if (closes(token) && !open.empty()) open.pop_back();
    }
    return open;
}

/// Goes on behind the `)` of the parameters, so that the body is read.
void Complaints::skip_parameters(const antlr4::ParserRuleContext& context) {
    std::size_t depth = open_brackets(context).size();
    while (depth > 0 && stream_.LA(1) != antlr4::Token::EOF) {
        const Token token = token_of(stream_.LA(1));
        if (opens(token)) ++depth;
        if (closes(token)) --depth;
        stream_.consume();
    }
}

/// A state of the parser from which its rules call `block`. Full-context prediction follows the
/// chain of calling states; a block that recovery reads must seem to be called from such a one.
static std::size_t state_that_calls_block(const antlr4::Parser& parser) {
    for (const antlr4::atn::ATNState* state : parser.getATN().states) {
        if (state == nullptr || state->transitions.empty()) continue;
        const antlr4::atn::Transition* transition = state->transitions[0];
        if (transition->getSerializationType() == antlr4::atn::Transition::RULE &&
            transition->target->ruleIndex == KadrParser::RuleBlock) {
            return state->stateNumber;
        }
    }
    KADR_ASSERT(false, "the grammar has no rule that calls block");
}

/// Reads the block that comes next, whose mistakes are told, wherever the parser stands.
static void read_block(antlr4::Parser& parser) {
    const std::size_t state = parser.getState();
    parser.setState(state_that_calls_block(parser));
    static_cast<KadrParser&>(parser).block();
    parser.setState(state);
}

/// Goes on behind the `;` of the statement, or behind its body, which is read on the way. Stops
/// before a `}` of the block around and before a line that is not indented deeper.
void Complaints::skip_statement(antlr4::Parser& parser, const antlr4::ParserRuleContext& context) {
    const Lexeme& start = static_cast<LexemeToken*>(context.start)->lexeme();
    const std::uint32_t indent = file_.lines.line_indent(start.begin);
    const std::size_t begin = context.start->getTokenIndex();
    std::vector<Token> open = open_brackets(context);
    // `for i = 0; i < 5; i++` without parentheses: its `;` end nothing.
    int separators =
        start.token == Token::For && stream_.lexeme(begin + 1).token != Token::OpenParen ? 2 : 0;
    while (stream_.LA(1) != antlr4::Token::EOF) {
        const Lexeme& lexeme = stream_.lexeme(stream_.index());
        const Token token = lexeme.token;
        if (open.empty()) {
            if (token == Token::OpenBrace) {
                read_block(parser);
                if (start.token != Token::If || token_of(stream_.LA(1)) != Token::Else) return;
                continue;
            }
            if (token == Token::Else && start.token == Token::If) {
                stream_.consume();
                if (token_of(stream_.LA(1)) == Token::If) stream_.consume();
                continue;
            }
            if (token == Token::CloseBrace) break;
            const bool has_moved = stream_.index() > begin;
            const Lexeme& previous = stream_.lexeme(stream_.index() - (has_moved ? 1 : 0));
            if (has_moved && token != Token::Semicolon &&
                file_.crosses_line(previous.end, lexeme.begin) &&
                file_.lines.indent(lexeme.begin) <= indent) {
                return;
            }
        }
        if (opens(token)) open.push_back(token);
        if (closes(token) && !open.empty()) open.pop_back();
        stream_.consume();
        if (token == Token::Semicolon && open.empty() && separators-- == 0) return;
    }
    // A statement that is nothing but a mistake must not be tried again.
    if (stream_.index() == begin && token_of(stream_.LA(1)) != Token::CloseBrace) stream_.consume();
}

/// Before each statement of a block and each declaration of a file: steps over what cannot begin
/// one.
void Complaints::sync(antlr4::Parser* parser) {
    antlr4::ParserRuleContext& context = *parser->getContext();
    const std::size_t rule = context.getRuleIndex();
    if (rule != KadrParser::RuleBlock && rule != KadrParser::RuleFile &&
        rule != KadrParser::RuleSwitchCase) {
        return;
    }
    const bool is_file = rule == KadrParser::RuleFile;
    const auto& atn = parser->getATN();
    const antlr4::misc::IntervalSet& starts = atn.nextTokens(atn.states[parser->getState()]);
    if (!starts.contains(static_cast<std::size_t>(is_file ? Token::Cycle : Token::If))) return;
    const auto fits = [&] {
        const Token token = token_of(stream_.LA(1));
        return starts.contains(stream_.LA(1)) || token == Token::EndOfFile ||
               (rule == KadrParser::RuleSwitchCase &&
                (token == Token::Case || token == Token::Default || token == Token::CloseBrace));
    };
    while (!fits()) {
        explain_start(*parser);
        skip_start(*parser, is_file);
    }
}

void Complaints::skip_start(antlr4::Parser& parser, bool is_file) {
    const Token first = token_of(stream_.LA(1));
    stream_.consume();
    if ((first == Token::Else || first == Token::Include) && !is_file) return;
    int depth = opens(first) ? 1 : 0;
    Token last = first;
    while (stream_.LA(1) != antlr4::Token::EOF) {
        const std::size_t index = stream_.index();
        const Token token = token_of(stream_.LA(1));
        const bool has_members = first == Token::Struct || first == Token::Enum;
        if (depth == 0 && token == Token::OpenBrace && !has_members) {
            read_block(parser);
            last = Token::CloseBrace;
            if (!is_file) return;
            continue;
        }
        if (depth == 0 && token == Token::CloseBrace && !is_file) return;
        if (depth == 0 && is_file) {
            const bool is_fresh =
                last == Token::Semicolon || last == Token::CloseBrace ||
                file_.crosses_line(stream_.lexeme(index - 1).end, stream_.lexeme(index).begin);
            const bool is_declaration = begins_declaration(token) || token == Token::TypeName ||
                                        token == Token::Const || token == Token::Contour;
            if (is_fresh && is_declaration) return;
        }
        if (opens(token)) ++depth;
        if (closes(token)) --depth;
        stream_.consume();
        last = token;
        if (has_members && depth == 0 && token == Token::CloseBrace && !is_file) return;
        const bool is_end =
            token == Token::Semicolon ||
            (token == Token::Colon && (first == Token::Case || first == Token::Default));
        if (depth == 0 && is_end && !is_file) return;
    }
}

}  // namespace kadr::syntax
