// empty_body.cpp — `if (…);`: a head whose body is the empty statement, C's classic.
#include "sema/empty_body.h"

#include <algorithm>

#include "base/diagnostics/sema.h"
#include "sema/builtins.h"
#include "sema/checking.h"

namespace kadr::sema {

namespace {

using syntax::Ast;
using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Operator;
using syntax::Stmt;
using syntax::StmtId;
using syntax::StmtKind;

/// Whether evaluating does something: `i++`, or a call of what the language does not have itself.
bool acts(const Ast& ast, ExprId id) {
    if (!id.is_valid()) return false;
    const Expr& expr = ast[id];
    if (expr.kind == ExprKind::Unary && expr.op >= Operator::PreIncrement &&
        expr.op <= Operator::PostDecrement)
        return true;
    if (expr.kind == ExprKind::Call) {
        const Expr& callee = ast[expr.child[0]];
        const auto builtins = builtin_names();
        if (callee.kind != ExprKind::Name ||
            std::find(builtins.begin(), builtins.end(), ast.text(callee.text)) == builtins.end())
            return true;
    }
    const auto is_acting = [&](const ExprId inner) { return acts(ast, inner); };
    if (std::any_of(expr.child.begin(), expr.child.end(), is_acting)) return true;
    const auto list = ast.exprs(expr.list);
    return std::any_of(list.begin(), list.end(), is_acting);
}

/// The word before a `;` that is all that the statement does; empty: it has a body, or the loop
/// works in its condition.
std::string_view head_of_nothing(const Ast& ast, const Stmt& stmt) {
    const auto is_empty = [&](const StmtId id) {
        return id.is_valid() && ast[id].kind == StmtKind::Empty;
    };
    switch (stmt.kind) {
        case StmtKind::If:
            if (is_empty(stmt.statement[0])) return "if";
            return is_empty(stmt.statement[1]) ? "else" : "";
        case StmtKind::While:
            return is_empty(stmt.statement[0]) && !acts(ast, stmt.expression[0]) ? "while" : "";
        case StmtKind::For: {
            // Its step has an effect always: `i++`. What counts is a call.
            const ExprId step = stmt.expression[1];
            const bool calls =
                step.is_valid() && ast[step].kind != ExprKind::Unary && acts(ast, step);
            return is_empty(stmt.statement[1]) && !calls && !acts(ast, stmt.expression[0]) ? "for"
                                                                                           : "";
        }
        case StmtKind::ForEach: return is_empty(stmt.statement[0]) ? "for" : "";
        default: return "";
    }
}

}  // namespace

void warn_of_empty_body(Check& check, const Stmt& stmt) {
    const std::string_view head = head_of_nothing(check.ast(), stmt);
    if (head.empty()) return;
    const bool is_else = head == "else" || stmt.kind == StmtKind::For;
    const SourceRange body = check.ast()[stmt.statement[is_else ? 1 : 0]].range;
    check.report(diag::EmptyBody, body)
        .arg(head)
        .fix(body, "", "take the `;` away, if the next statement is meant")
        .fix(body, " { }", "write braces, if nothing is meant");
}

}  // namespace kadr::sema
