#include "repl/transcript.h"

#include <algorithm>
#include <optional>

#include "driver/modules.h"
#include "syntax/parse.h"
#include "syntax/quotes.h"

namespace kadr::repl {

namespace {

using syntax::Ast;
using syntax::DeclKind;
using syntax::ExprKind;
using syntax::StmtKind;

/// The tree of a text, and what is wrong with its syntax; nothing if its head has no words.
std::optional<Ast> parsed(driver::Session& session, std::string text, DiagnosticList& mistakes) {
    const FileId file = session.sources().add("prompt", std::move(text));
    const driver::SourceWords words = driver::words_of(session, file);
    if (!words) return std::nullopt;
    return syntax::parse(session.sources(), file, *words.keywords, *words.dialect, mistakes);
}

/// The tree of a text without syntax errors; nothing if it has one.
std::optional<Ast> parsed(driver::Session& session, std::string text) {
    DiagnosticList mistakes;
    std::optional<Ast> ast = parsed(session, std::move(text), mistakes);
    if (mistakes.has_errors()) return std::nullopt;
    return ast;
}

/// What the text is beside a program; Wrong if it is nothing of the kind.
Input::Kind kind_at_file_level(const Ast& ast) {
    Input::Kind kind = Input::Kind::Wrong;
    for (const syntax::DeclId id : ast.top) {
        const syntax::Decl& decl = ast[id];
        switch (decl.kind) {
            case DeclKind::Language:
            case DeclKind::Dialect:
            case DeclKind::Units: kind = Input::Kind::Header; break;
            case DeclKind::Import: kind = Input::Kind::Import; break;
            case DeclKind::Variable:
                // A constant serves the cycles that are typed later, a variable the statements.
                if (!decl.is_const) return Input::Kind::Wrong;
                kind = Input::Kind::Declaration;
                break;
            case DeclKind::Contour: return Input::Kind::Wrong;
            default: kind = Input::Kind::Declaration; break;
        }
    }
    return kind;
}

/// What the one statement of a program is: a value, a call, or something else that is done.
Input::Kind kind_of_statement(const Ast& ast) {
    std::optional<syntax::Stmt> only;
    for (const syntax::Stmt& stmt : ast.statements) {
        if (stmt.kind == StmtKind::Block) continue;
        if (only) return Input::Kind::Statement;
        only = stmt;
    }
    if (!only || only->kind != StmtKind::Expression) return Input::Kind::Statement;
    const syntax::Expr& expr = ast.expressions[only->expression[0].index];
    switch (expr.kind) {
        case ExprKind::Assign:
        case ExprKind::Invalid: return Input::Kind::Statement;
        case ExprKind::Call:
            // `a.pop()` has a value and changes `a`.
            return ast[expr.child[0]].kind == ExprKind::Name ? Input::Kind::Call
                                                             : Input::Kind::Statement;
        case ExprKind::Unary: {
            const bool is_step = expr.op == syntax::Operator::PreIncrement ||
                                 expr.op == syntax::Operator::PreDecrement ||
                                 expr.op == syntax::Operator::PostIncrement ||
                                 expr.op == syntax::Operator::PostDecrement;
            return is_step ? Input::Kind::Statement : Input::Kind::Value;
        }
        default: return Input::Kind::Value;
    }
}

std::string as_program(std::string_view word, std::string_view text) {
    return std::string(word) + " prompt() {\n" + std::string(text) + "\n}\n";
}

/// Takes blanks from the end.
std::string trimmed(std::string text) {
    const std::size_t last = text.find_last_not_of(" \t\r\n");
    text.erase(last == std::string::npos ? 0 : last + 1);
    return text;
}

/// Past the comment that begins at `at`, `at` itself if none does; nothing: it is not closed.
std::optional<std::size_t> past_comment(std::string_view text, std::size_t at) {
    if (text.substr(at, 2) == "//") return std::min(text.find('\n', at), text.size());
    if (text.substr(at, 2) != "/*") return at;
    const std::size_t end = text.find("*/", at + 2);
    if (end == std::string_view::npos) return std::nullopt;
    return end + 2;
}

/// Past the string whose quote stands at `at`; one that is not closed ends with its line.
std::size_t past_string(std::string_view text, std::size_t at) {
    const std::uint32_t closed = syntax::end_of_text(text, static_cast<std::uint32_t>(at),
                                                     static_cast<std::uint32_t>(text.size()));
    if (closed > at) return closed;
    for (++at; at < text.size() && text[at] != '"' && text[at] != '\n'; ++at) {
        if (text[at] == '\\') ++at;
    }
    return std::min(at + 1, text.size());
}

/// Behind the last word of a text; comments may follow.
std::size_t end_of_words(const std::string& text) {
    std::size_t end = 0;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t past = past_comment(text, i).value_or(text.size());
        if (past > i) {
            i = past;
            continue;
        }
        const bool is_blank = std::string_view(" \t\r\n").find(text[i]) != std::string_view::npos;
        i = text[i] == '"' ? past_string(text, i) : i + 1;
        if (!is_blank) end = i;
    }
    return end;
}

/// The text with that behind its last word.
std::string with_end(std::string text, std::string_view end) {
    return text.insert(end_of_words(text), end);
}

std::string ended(const std::string& text) { return with_end(text, ";"); }

/// Whether the statement at this index of the file is all that a condition or a loop does.
bool is_lone_body(const Ast& ast, std::size_t index) {
    return std::ranges::any_of(ast.statements, [&](const syntax::Stmt& head) {
        const bool is_head = head.kind == StmtKind::If || head.kind == StmtKind::While ||
                             head.kind == StmtKind::For || head.kind == StmtKind::ForEach;
        return is_head && std::ranges::any_of(head.statement, [&](const syntax::StmtId id) {
                   return id.is_valid() && ast[id].kind == StmtKind::Empty &&
                          ast[id].range.begin == index;
               });
    });
}

std::string first_word(std::string_view text) {
    return std::string(text.substr(0, text.find_first_of(" \t\r\n")));
}

}  // namespace

bool has_open_end(std::string_view text) {
    int depth = 0;
    for (std::size_t i = 0; i < text.size();) {
        const std::optional<std::size_t> past = past_comment(text, i);
        if (!past) return true;
        const char c = text[i];
        if (*past > i) {
            i = *past;
            continue;
        }
        if (c == '(' || c == '[' || c == '{') ++depth;
        if (c == ')' || c == ']' || c == '}') --depth;
        i = c == '"' ? past_string(text, i) : i + 1;
    }
    return depth > 0;
}

namespace {

/// The lexeme of a keyword in the keyword language of the headers.
std::string lexeme_of(driver::Session& session, std::string_view headers,
                      const std::string& keyword) {
    const FileId file = session.sources().add("prompt", std::string(headers));
    if (const driver::SourceWords words = driver::words_of(session, file)) {
        for (const auto& [lexeme, name] : words.keywords->canonical) {
            if (name == keyword) return lexeme;
        }
    }
    return keyword;
}

/// Whether a text that is no program becomes one by what can only stand in the next lines.
bool lacks_body(driver::Session& session, const std::string& headers, const std::string& text) {
    const std::string word = program_word(session, headers);
    const std::string until = lexeme_of(session, headers, "while") + " (true);";
    for (const std::string& rest : {std::string(" {}"), " {} " + until, ' ' + until}) {
        const std::string whole = with_end(text, rest);
        if (parsed(session, headers + whole)) return true;
        if (parsed(session, headers + as_program(word, whole))) return true;
    }
    return false;
}

}  // namespace

std::string program_word(driver::Session& session, std::string_view headers) {
    return lexeme_of(session, headers, "program");
}

std::string else_word(driver::Session& session, std::string_view headers) {
    return lexeme_of(session, headers, "else");
}

std::size_t past_quoted(std::string_view text, std::size_t at) {
    const std::size_t past = past_comment(text, at).value_or(text.size());
    return past == at && text[at] == '"' ? past_string(text, at) : past;
}

bool can_be_read(driver::Session& session, std::string_view headers, const std::string& text) {
    if (is_incomplete(session, headers, text)) return true;
    return mistakes(session, headers, text) == 0 || mistakes(session, headers, ended(text)) == 0;
}

std::size_t mistakes(driver::Session& session, std::string_view headers, const std::string& text) {
    const std::string word = program_word(session, headers);
    std::size_t least = static_cast<std::size_t>(-1);
    for (const std::string& whole : {text, as_program(word, text)}) {
        DiagnosticList found;
        (void)parsed(session, std::string(headers) + whole, found);
        least = std::min(least, found.errors());
    }
    return least;
}

bool is_whole_statement(driver::Session& session, std::string_view headers,
                        const std::string& text) {
    if (is_incomplete(session, headers, text)) return false;
    const std::string word = program_word(session, headers);
    return parsed(session, std::string(headers) + as_program(word, ended(text))).has_value();
}

bool is_incomplete(driver::Session& session, std::string_view headers, const std::string& text) {
    if (has_open_end(text)) return true;
    const std::string before(headers);
    const std::string head = as_program(program_word(session, headers), "");
    const std::size_t body = before.size() + head.find('\n') + 1;
    for (const bool ends_it : {false, true}) {
        const std::string whole = ends_it ? ended(text) : text;
        if (parsed(session, before + whole) || parsed(session, whole)) return false;
        const auto ast =
            parsed(session, before + as_program(program_word(session, headers), whole));
        if (ast) return ends_it && is_lone_body(*ast, body + end_of_words(text));
    }
    return lacks_body(session, before, text);
}

namespace {

/// Whether a text with mistakes is meant to stand beside the program: it declares a cycle, a
/// function, a struct. What is wrong in it is then reported as it is there.
bool declares(driver::Session& session, const std::string& headers, std::string_view text) {
    const FileId file = session.sources().add("prompt", headers + std::string(text));
    const driver::SourceWords words = driver::words_of(session, file);
    if (!words) return false;
    const std::string word(text.substr(0, text.find_first_of(" \t\r\n({")));
    const auto meaning = words.keywords->canonical.find(word);
    const std::string_view name =
        meaning == words.keywords->canonical.end() ? std::string_view() : meaning->second;
    constexpr std::string_view kDeclarations[] = {"cycle",    "program", "curve", "test",
                                                  "property", "struct",  "enum"};
    const std::size_t after = text.find_first_not_of(" \t\r\n", word.size());
    const bool is_named = after != std::string_view::npos && after > word.size();
    if (is_named && std::ranges::find(kDeclarations, name) != std::end(kDeclarations)) return true;
    DiagnosticList mistakes;
    const Ast ast =
        syntax::parse(session.sources(), file, *words.keywords, *words.dialect, mistakes);
    return std::ranges::any_of(
        ast.top, [&](const syntax::DeclId id) { return ast[id].kind == DeclKind::Function; });
}

}  // namespace

Input classify(driver::Session& session, std::string_view headers, std::string text) {
    text = trimmed(std::move(text));
    const std::string word = program_word(session, headers);
    for (const bool ends_it : {false, true}) {
        const std::string whole = ends_it ? ended(text) : text;
        // A header is judged without those that hold: it replaces one of them.
        for (const std::string& before : {std::string(headers), std::string()}) {
            const auto ast = parsed(session, before + whole);
            const Input::Kind kind = ast ? kind_at_file_level(*ast) : Input::Kind::Wrong;
            if (kind == Input::Kind::Header && !before.empty()) continue;
            if (kind != Input::Kind::Wrong) return {kind, whole};
        }
        if (const auto ast = parsed(session, std::string(headers) + as_program(word, whole)))
            return {kind_of_statement(*ast), whole};
    }
    // A keyword language that cannot be loaded: nothing can be read in it.
    if (first_word(text) == "language") return {Input::Kind::Header, ended(text)};
    const bool is_declaration = declares(session, std::string(headers), text);
    return {is_declaration ? Input::Kind::Declaration : Input::Kind::Wrong, std::move(text)};
}

Input Transcript::undo() {
    Input last = std::move(inputs_.back());
    inputs_.pop_back();
    return last;
}

bool Transcript::has_statements() const {
    return std::ranges::any_of(inputs_, [](const Input& input) {
        return input.kind == Input::Kind::Statement || input.kind == Input::Kind::Call ||
               input.kind == Input::Kind::Value;
    });
}

std::string Transcript::headers() const {
    std::string out;
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
        if (inputs_[i].kind != Input::Kind::Header) continue;
        const bool is_replaced =
            std::any_of(inputs_.begin() + static_cast<std::ptrdiff_t>(i) + 1, inputs_.end(),
                        [&](const Input& later) {
                            return later.kind == Input::Kind::Header &&
                                   first_word(later.text) == first_word(inputs_[i].text);
                        });
        if (!is_replaced) out += inputs_[i].text + '\n';
    }
    return out;
}

std::string Transcript::program(std::string_view word) const {
    std::string out;
    const auto put = [&](auto... kinds) {
        for (const Input& input : inputs_) {
            if (((input.kind == kinds) || ...)) out += input.text + '\n';
        }
    };
    out += headers();
    put(Input::Kind::Import);
    put(Input::Kind::Declaration);
    out += std::string(word) + " prompt() {\n";
    put(Input::Kind::Statement, Input::Kind::Call, Input::Kind::Value);
    return out + "}\n";
}

std::uint32_t Transcript::last_statement(std::string_view program) const {
    constexpr std::size_t kBehind = 3;  // "\n}\n"
    return static_cast<std::uint32_t>(program.size() - kBehind - inputs_.back().text.size());
}

}  // namespace kadr::repl
