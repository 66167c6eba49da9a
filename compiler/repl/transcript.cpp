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

/// The tree of a text without syntax errors; nothing if it has one.
std::optional<Ast> parsed(driver::Session& session, std::string text) {
    const FileId file = session.sources().add("prompt", std::move(text));
    const driver::SourceWords words = driver::words_of(session, file);
    if (!words) return std::nullopt;
    DiagnosticList mistakes;
    Ast ast = syntax::parse(session.sources(), file, *words.keywords, *words.dialect, mistakes);
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

/// Whether the one statement of a program computes a value and does nothing with it.
bool is_value(const Ast& ast) {
    std::optional<syntax::Stmt> only;
    for (const syntax::Stmt& stmt : ast.statements) {
        if (stmt.kind == StmtKind::Block) continue;
        if (only) return false;
        only = stmt;
    }
    if (!only || only->kind != StmtKind::Expression) return false;
    const syntax::Expr& expr = ast.expressions[only->expression[0].index];
    switch (expr.kind) {
        case ExprKind::Assign:
        case ExprKind::Call:
        case ExprKind::Invalid: return false;
        case ExprKind::Unary:
            return expr.op != syntax::Operator::PreIncrement &&
                   expr.op != syntax::Operator::PreDecrement &&
                   expr.op != syntax::Operator::PostIncrement &&
                   expr.op != syntax::Operator::PostDecrement;
        default: return true;
    }
}

std::string as_program(std::string_view text) {
    return "program prompt() {\n" + std::string(text) + "\n}\n";
}

/// Takes blanks, and one `;`, from the end.
std::string trimmed(std::string text) {
    const std::size_t last = text.find_last_not_of(" \t\r\n");
    text.erase(last == std::string::npos ? 0 : last + 1);
    return text;
}

}  // namespace

bool is_incomplete(std::string_view text) {
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const auto at = static_cast<std::uint32_t>(i);
        const auto size = static_cast<std::uint32_t>(text.size());
        const std::uint32_t closed = c == '"' ? syntax::end_of_text(text, at, size) : at;
        if (closed > at) {
            i = closed - 1;
        } else if (c == '"') {
            for (++i; i < text.size() && text[i] != '"' && text[i] != '\n'; ++i) {
                if (text[i] == '\\') ++i;
            }
        } else if (text.substr(i, 2) == "//") {
            i = std::min(text.find('\n', i), text.size());
        } else if (text.substr(i, 2) == "/*") {
            i = text.find("*/", i + 2);
            if (i == std::string_view::npos) return true;
            ++i;
        } else if (c == '(' || c == '[' || c == '{') {
            ++depth;
        } else if (c == ')' || c == ']' || c == '}') {
            --depth;
        }
    }
    return depth > 0;
}

Input classify(driver::Session& session, std::string_view headers, std::string text) {
    text = trimmed(std::move(text));
    for (const bool ends_it : {false, true}) {
        const std::string whole = ends_it ? text + ';' : text;
        // A header is judged without those that hold: it replaces one of them.
        for (const std::string& before : {std::string(headers), std::string()}) {
            const auto ast = parsed(session, before + whole);
            const Input::Kind kind = ast ? kind_at_file_level(*ast) : Input::Kind::Wrong;
            if (kind == Input::Kind::Header && !before.empty()) continue;
            if (kind != Input::Kind::Wrong) return {kind, whole};
        }
        if (const auto ast = parsed(session, std::string(headers) + as_program(whole))) {
            if (!is_value(*ast)) return {Input::Kind::Statement, whole};
            if (!ends_it) text.pop_back();
            return {Input::Kind::Value, trimmed(std::move(text))};
        }
    }
    return {Input::Kind::Wrong, std::move(text)};
}

bool Transcript::undo() {
    if (inputs_.empty()) return false;
    inputs_.pop_back();
    return true;
}

std::string Transcript::headers() const {
    std::string out;
    for (const Input& input : inputs_) {
        if (input.kind == Input::Kind::Header) out += input.text + '\n';
    }
    return out;
}

std::string Transcript::program(std::string_view extra, std::string_view name) const {
    std::string out;
    const auto put = [&](Input::Kind kind) {
        for (const Input& input : inputs_) {
            if (input.kind == kind) out += input.text + '\n';
        }
    };
    out += headers();
    put(Input::Kind::Import);
    put(Input::Kind::Declaration);
    out += "program " + std::string(name) + "() {\n";
    put(Input::Kind::Statement);
    if (!extra.empty()) out += std::string(extra) + '\n';
    return out + "}\n";
}

}  // namespace kadr::repl
