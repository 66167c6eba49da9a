// complain_fixes.cpp — the text that mends a mistake: what a reader may put in the place of what is
// wrong.
#include <algorithm>

#include "base/text.h"
#include "nc/tables.h"
#include "syntax/habits.h"
#include "syntax/keyword.h"
#include "syntax/parse.h"
#include "syntax/parser_position.h"
#include "syntax/token_kinds.h"
#include "syntax/words.h"

namespace kadr::syntax {

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

/// The bracket that closes the one at `open`; the last lexeme if none does.
std::size_t Complaints::matching(std::size_t open) const {
    std::size_t depth = 0;
    for (std::size_t i = open; i < stream_.size(); ++i) {
        if (opens(stream_.lexeme(i).token)) ++depth;
        if (closes(stream_.lexeme(i).token) && --depth == 0) return i;
    }
    return stream_.size() - 1;
}

/// Signs as other languages have them; false: it is none of those.
bool Complaints::fix_sign(const ParserPosition& at, DiagnosticBuilder& report) const {
    const Token before = at.previous.token;
    const Lexeme& offending = at.offending;
    const Lexeme& next = stream_.lexeme(std::min(at.index + 1, stream_.size() - 1));
    const bool is_joined = at.previous.end == offending.begin;
    const SourceRange both = file_.range(at.previous.begin, offending.end);
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
    } else if (offending.token == Token::Colon && at.head_index + 1 == at.index) {
        report.fix("there are no labels and no jumps: `while` and `for` repeat");
    } else if (offending.token == Token::Comma && is_word(at.head)) {
        const bool is_corner = !is_joined && next.begin == offending.end &&  // `G1 X5 ,R2`
                               next.token == Token::LiteralWord && next.end - next.begin > 1 &&
                               (file_.spelling(next)[0] == 'R' || file_.spelling(next)[0] == 'C');
        if (is_corner) {
            report.fix(
                "roundings and chamfers `,R` and `,C` are words of a source with `dialect "
                "fanuc;` at its head");
            return true;
        }
        const bool is_tight = is_joined && next.begin == offending.end;
        report.fix(file_.range(offending), is_tight ? " " : "",
                   "the words of a block have no commas between them");
    } else if (is_cast(at)) {
        report.fix("a value becomes a number of another kind by a call: `int(x)`, `round(x)`");
    } else {
        return false;
    }
    return true;
}

/// `and`, `OR`, `not`: words of other languages.
void Complaints::fix_operator(const ParserPosition& at, DiagnosticBuilder& report) const {
    constexpr std::pair<std::string_view, std::string_view> kWords[] = {
        {"and", "&&"}, {"or", "||"}, {"mod", "%"}, {"eq", "=="}, {"ne", "!="},
        {"lt", "<"},   {"le", "<="}, {"gt", ">"},  {"ge", ">="},
    };
    if (lower_ascii(file_.spelling(at.previous)) == "not") {
        report.fix("the operator is `!`, in front of parentheses: `!(n > 3)`");
        return;
    }
    for (const Lexeme* lexeme : {&at.offending, &at.previous}) {
        const std::string word = lower_ascii(file_.spelling(*lexeme));
        if (word == "div") return void(report.fix("a whole quotient is `trunc(a/b)`"));
        for (const auto& [name, sign] : kWords) {
            if (word != name || lexeme->token != Token::Identifier) continue;
            report.fix(file_.range(*lexeme), std::string(sign), "the operator has a sign");
            return;
        }
    }
}

/// `message "hello";`, `tool 3;`: what is called without its parentheses.
void Complaints::fix_call(const ParserPosition& at, DiagnosticBuilder& report) const {
    const Token token = at.offending.token;
    const bool is_call = at.head == Token::Identifier && at.index == at.head_index + 1 &&
                         (token == Token::Number || token == Token::Text) && !at.is_new_line &&
                         stream_.lexeme(at.index + 1).token == Token::Semicolon;
    if (!is_call) return;
    const std::string small = lower_ascii(file_.spelling(at.previous));
    if (small != file_.spelling(at.previous) && find_keyword(small) != nullptr) {  // `NOTE "a";`
        report.fix(file_.range(at.previous), small, "keywords are written in lower case");
        return;
    }
    report.fix(file_.range(at.previous.end, at.offending.end),
               '(' + std::string(file_.spelling(at.offending)) + ')',
               "the arguments of a call stand in parentheses");
}

/// `for n = 1 to 5`: the lexeme `to` of the head that begins at `first`; 0: there is none.
std::size_t Complaints::word_to(std::size_t first) const {
    if (stream_.lexeme(first + 1).token != Token::Assign) return 0;
    for (std::size_t i = first + 2; !ends_line(i); ++i) {
        const Lexeme& lexeme = stream_.lexeme(i);
        if (lexeme.token == Token::OpenBrace || lexeme.token == Token::Semicolon) return 0;
        if (lexeme.token == Token::Identifier && lower_ascii(file_.spelling(lexeme)) == "to")
            return i;
    }
    return 0;
}

/// `for (int k = 1 to 5)`: `k : 1..5`.
void Complaints::fix_counting(const ParserPosition& at, DiagnosticBuilder& report) const {
    for (std::size_t i = at.index; i-- > at.head_index;) {
        if (stream_.lexeme(i).token != Token::Assign || word_to(i - 1) != at.index) continue;
        const std::uint32_t begin = stream_.lexeme(i + 1).begin;
        const std::string first(file_.text.substr(begin, at.previous.end - begin));
        const Lexeme& last = stream_.lexeme(at.index + 1);
        return void(report.fix(file_.range(stream_.lexeme(i).begin, last.begin),
                               ": " + first + "..", "a loop over a range counts"));
    }
}

/// `for (int i = 0, i < 5, i++)`, but `for (int i = 0, j = 1; …)`.
void Complaints::fix_comma_of_loop(const ParserPosition& at, DiagnosticBuilder& report) const {
    const std::string_view next = file_.spelling(stream_.lexeme(at.index + 1));
    for (std::size_t i = at.index; i > 0 && stream_.lexeme(i).token != Token::OpenParen; --i) {
        const bool is_asked = stream_.lexeme(i).token == Token::Assign &&
                              file_.spelling(stream_.lexeme(i - 1)) == next;
        if (!is_asked) continue;
        const std::size_t last = last_comma(at.index);
        std::string parts(
            file_.text.substr(at.offending.begin, stream_.lexeme(last).end - at.offending.begin));
        std::ranges::replace(parts, ',', ';');
        return void(report.fix(file_.range(at.offending.begin, stream_.lexeme(last).end), parts,
                               "semicolons stand between the parts of a loop"));
    }
    report.fix("a loop has one variable: declare the others before it");
}

/// `then` behind a condition: another language's.
bool Complaints::is_then(std::size_t index) const {
    const Lexeme& lexeme = stream_.lexeme(index);
    return lexeme.token == Token::Identifier && lower_ascii(file_.spelling(lexeme)) == "then";
}

/// What a keyword is followed by, in parentheses: up to the body or the end of the statement.
void Complaints::fix_parentheses(const ParserPosition& at, DiagnosticBuilder& report) const {
    std::size_t end = at.index;
    for (std::size_t depth = 0; end < stream_.size(); ++end) {
        const Token token = stream_.lexeme(end).token;
        const bool is_end = token == Token::OpenBrace || token == Token::OpenValue ||
                            token == Token::EndOfFile ||
                            (token == Token::Semicolon && at.previous.token != Token::For);
        const bool is_word_of_others =
            token == Token::Identifier && habit_of(file_.spelling(stream_.lexeme(end))) != nullptr;
        const bool is_body = begins_statement(token) || is_word(token) || is_word_of_others;
        if (depth == 0 && (is_end || (end > at.index && is_body))) break;
        if (opens(token)) ++depth;
        if (closes(token) && depth > 0) --depth;
    }
    if (end > at.index && is_closed_behind(end - 1)) {  // `for point p : ps) {`
        const std::uint32_t begin = at.offending.begin;
        report.fix(file_.range(begin, begin), "(", "open it");
        return;
    }
    if (end == at.index) {
        const bool is_empty = at.previous.token == Token::Identifier;  // `program p {`
        const SourceRange gap = file_.range(at.previous.end, at.previous.end);
        if (is_empty) report.fix(gap, "()", "without parameters they are empty");
        else report.fix(file_.range(at.offending.begin, at.offending.begin), "(", "open it");
        return;
    }
    SourceRange range = file_.range(at.offending.begin, stream_.lexeme(end - 1).end);
    // `if n > 2:`
    const bool has_colon = end > at.index + 1 && stream_.lexeme(end - 1).token == Token::Colon;
    const std::uint32_t inner_end = has_colon ? stream_.lexeme(end - 2).end : range.end;
    // `for i in 1..5`
    const bool is_loop = at.previous.token == Token::For && end > at.index + 2 &&
                         at.offending.token == Token::Identifier &&
                         lower_ascii(file_.spelling(stream_.lexeme(at.index + 1))) == "in";
    if (is_loop) {
        const Lexeme& first = stream_.lexeme(at.index + 2);
        const std::string list(file_.text.substr(first.begin, inner_end - first.begin));
        if (list.starts_with("range("))
            return report.fix("a loop counts: `for (int i = 0; i < 5; i++)`"), void();
        const std::string type = list.find("..") != list.npos ? "int " : "auto ";
        report.fix(range,
                   '(' + type + std::string(file_.spelling(at.offending)) + " : " + list + ')',
                   "a loop over a list");
        return;
    }
    if (const std::size_t to = word_to(at.index);
        at.previous.token == Token::For && to > 0 && to + 1 < end) {
        const auto part = [&](std::size_t from, std::size_t last) {
            const std::uint32_t begin = stream_.lexeme(from).begin;
            return std::string(file_.text.substr(begin, stream_.lexeme(last).end - begin));
        };
        report.fix(range,
                   "(int " + part(at.index, at.index) + " : " + part(at.index + 2, to - 1) + ".." +
                       part(to + 1, end - 1) + ')',
                   "a loop over a range counts");
        return;
    }
    const std::string inside(file_.text.substr(range.begin, inner_end - range.begin));
    if (is_then(end)) range.end = stream_.lexeme(end).end;
    report.fix(range, "(" + inside + ")", "put it in parentheses");
}

/// Whether a round bracket is closed right behind a lexeme that nothing has opened.
bool Complaints::is_closed_behind(std::size_t last) const {
    std::size_t at = stream_.lexeme(last).end;
    while (at < file_.text.size() && file_.text[at] == ' ') ++at;
    return at < file_.text.size() && file_.text[at] == ')';
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

/// Whether a variable or a parameter of the file is called so, wherever it stands.
bool Complaints::is_declared(std::string_view name) const {
    for (std::size_t i = 1; i < stream_.size(); ++i) {
        if (file_.spelling(stream_.lexeme(i)) != name) continue;
        switch (stream_.lexeme(i - 1).token) {
            case Token::TypeName:
            case Token::Auto:
            case Token::CloseBracket:  // `length[] list`
            case Token::Question:
            case Token::And: return stream_.lexeme(i).token == Token::Identifier;
            default: break;
        }
    }
    return false;
}

/// `R1=5;`: a variable of a control, which exists without being declared.
void Complaints::fix_control_variable(const Lexeme& word, DiagnosticBuilder& report) const {
    report.fix("a variable is declared with its type and a name in small letters, once: `real " +
               lower_ascii(file_.spelling(word)) + " = 0;`, `length depth = 5mm;`");
}

/// `length D;`
void Complaints::fix_name_of_word(const Lexeme& word, DiagnosticBuilder& report) const {
    const std::string name = lower_ascii(file_.spelling(word));
    if (is_declared(name))
        report.fix("choose another name: " + ('`' + name + '`') + " is one already");
    else report.fix(file_.range(word), name, "write it in lower case");
}

/// `X=R1`, `a = X`: a word where a value stands.
void Complaints::fix_value_of_word(const Lexeme& word, DiagnosticBuilder& report) const {
    const std::string name = lower_ascii(file_.spelling(word));
    const std::string letters = name.substr(0, name.find_first_of("+-.0123456789"));
    const SourceRange address =
        file_.range(word.begin, word.begin + static_cast<std::uint32_t>(letters.size()));
    const bool has_sign = name.find_first_of("+-") == letters.size();
    constexpr std::string_view kAxes = "xyzabcuvw";
    if (is_declared(name)) {
        report.fix(file_.range(word), name,
                   "if a variable is meant: names of variables are not addresses");
    } else if (has_sign && is_declared(letters)) {  // `X+5` is one word
        report.fix(address, letters,
                   "if a variable is meant: names of variables are not addresses");
    } else if (letters.size() == 1 && kAxes.find(letters) != std::string_view::npos) {
        report.fix("the position that is programmed is `position." + letters + "`, and `" +
                   upper_ascii(letters) + "+=5mm` goes on from there");
    } else {
        fix_control_variable(word, report);
    }
}

/// A form that begins with the address; null: the control has no such address.
static const nc::Form* form_of_address(const nc::Dialect& dialect, std::string_view name) {
    const nc::AddressId address = dialect.tables().find_address(name);
    if (address == nc::kNoAddress) return nullptr;
    const auto& forms = dialect.tables().forms;
    const auto found = std::ranges::find_if(forms, [&](const nc::Form& form) {
        return !form.words.empty() && form.words[0].address == address;
    });
    return found == forms.end() ? nullptr : &*found;
}

/// `X d`, `X-d`, `X(d)`, `X[d*2]`: the address with its value behind `=`.
void Complaints::fix_word_value(const ParserPosition& at, DiagnosticBuilder& report) const {
    const Token token = at.offending.token;
    const bool is_bracket = token == Token::OpenBracket || token == Token::OpenParen;
    const bool begins_value =
        is_bracket || token == Token::Identifier || token == Token::Minus || token == Token::Plus;
    if (at.is_new_line || !begins_value) return;
    if (!is_bracket) {
        report.fix(file_.range(at.previous.end, at.offending.begin), "=", kValueBehindSign);
        return;
    }
    const std::size_t close = matching(at.index);
    // `R[1]=5`: a variable of a control; `SPOS[1]=90`: a word of it.
    if (stream_.lexeme(close + 1).token == Token::Assign) {
        const std::string_view text =
            file_.text.substr(at.previous.begin, stream_.lexeme(close).end - at.previous.begin);
        const nc::Form* form = form_of_address(dialect_, text);
        const std::string address(file_.spelling(at.previous));
        if (form == nullptr && address.size() > 1 && form_of_address(dialect_, address) != nullptr)
            return static_cast<void>(report.fix(
                "`" + address + "` takes no number in brackets here: `" + address + "=…`"));
        if (form == nullptr) return fix_control_variable(at.previous, report);
        report.fix("a function says it: `" + std::string(nc::info(form->function).name) + "(…)`");
        return;
    }
    const bool is_whole = ends_value(stream_.lexeme(close + 1).token);
    const std::string inside = round_brackets(at.index);
    report.fix(file_.range(at.previous.end, stream_.lexeme(close).end),
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
void Complaints::fix_brackets(const ParserPosition& at, DiagnosticBuilder& report) const {
    const std::size_t close = matching(at.index);
    if (stream_.lexeme(close).token != Token::CloseBracket) return;
    const bool is_whole =
        at.previous.token == Token::Assign && ends_value(stream_.lexeme(close + 1).token);
    const SourceRange range = file_.range(at.offending.begin, stream_.lexeme(close).end);
    const std::string inside = round_brackets(at.index);
    if (is_whole && is_list(at.index, close))
        report.fix(range, '{' + inside + '}', "the values of a list stand in braces");
    else report.fix(range, is_whole ? inside : '(' + inside + ')', "parentheses are round");
}

/// `(int)x`.
bool Complaints::is_cast(const ParserPosition& at) const {
    if (at.previous.token != Token::CloseParen || at.index < 3) return false;
    const std::string_view type = file_.spelling(stream_.lexeme(at.index - 2));
    constexpr std::string_view kTypes[] = {"int", "real", "float", "double", "long", "bool"};
    return stream_.lexeme(at.index - 3).token == Token::OpenParen &&
           std::ranges::find(kTypes, type) != std::end(kTypes);
}

/// How a statement of a control's language is written here, where small letters alone do not make
/// it one: `IF R1<3 GOTO N10;`. Empty: they do.
std::string Complaints::form_of_control(std::string_view keyword, std::size_t head) const {
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
    return is_lowered_only ? "" : form_of_statement(keyword, jumps);
}

/// Whether the lexeme is the last of its line.
bool Complaints::ends_line(std::size_t index) const {
    return index + 1 >= stream_.size() || stream_.lexeme(index + 1).token == Token::EndOfFile ||
           file_.crosses_line(stream_.lexeme(index).end, stream_.lexeme(index + 1).begin);
}

/// `include <holes.kadr>`, `include "holes.kadr"`, `include cycles.drilling`.
void Complaints::fix_include(std::size_t index, DiagnosticBuilder& report) const {
    std::size_t last = index;
    const auto is_end = [&](const Lexeme& lexeme) {
        return lexeme.token == Token::Semicolon && lexeme.end > lexeme.begin;
    };
    while (!ends_line(last) && !is_end(stream_.lexeme(last + 1))) ++last;
    const SourceRange whole = file_.range(stream_.lexeme(index).begin, stream_.lexeme(last).end);
    const std::uint32_t begin = stream_.lexeme(index).end;
    std::string_view name = file_.text.substr(begin, whole.end - begin);
    name.remove_prefix(std::min(name.find_first_not_of(' '), name.size()));
    std::string path(name);
    if (name.size() > 2 && name.front() == '<' && name.back() == '>')
        path = '"' + std::string(name.substr(1, name.size() - 2)) + '"';
    const bool is_ended = is_end(stream_.lexeme(last + 1));
    report.fix(whole, "import " + path + (is_ended ? "" : ";"), "use `import`");
}

}  // namespace kadr::syntax
