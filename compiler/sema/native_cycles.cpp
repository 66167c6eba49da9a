#include "sema/native_cycles.h"

#include <algorithm>

#include "nc/parameters.h"

namespace kadr::sema {

using syntax::DeclKind;

bool is_library(const Check& check, std::uint32_t module) {
    return check.sources.name(check.names.module(module).ast->file).find("stdlib") !=
           std::string_view::npos;
}

namespace {

/// What the name of a cycle begins with that asks the control for one along a shape, and has no
/// moves in its place: `native_stock_rough` asks for `stock_rough`.
constexpr std::string_view kAsked = "native_";

/// A contour, then parameters of the control's cycle, then what tells whether the control has it.
bool asks_for(const FunctionDecl& function, const nc::CycleInfo& cycle) {
    const std::vector<ParameterDecl>& own = function.parameters;
    if (!cycle.takes_shape() || own.size() < 2 || own.front().name != "shape") return false;
    return std::all_of(own.begin() + 1, own.end(), [&](const ParameterDecl& parameter) {
        return parameter.is_reference || parameter.name == "is_asked" ||
               nc::find_parameter(cycle.parameters, parameter.name).has_value();
    });
}

/// … of the library's function of that name.
std::optional<nc::CycleId> asked_cycle(const nc::Dialect& dialect, const FunctionDecl& function) {
    const std::string_view name = std::string_view(function.name).substr(kAsked.size());
    const std::optional<nc::CycleId> id = dialect.find_cycle(name);
    return id && asks_for(function, dialect.cycles()[*id]) ? id : std::nullopt;
}

}  // namespace

std::optional<nc::CycleId> native_cycle(const Check& check, const FunctionDecl& function) {
    if (function.kind != DeclKind::Cycle) return std::nullopt;
    // Only the cycles of the standard library are the controls' own: a user's cycle of the same
    // name does what the user wrote.
    if (!is_library(check, function.module)) return std::nullopt;
    const nc::Dialect& dialect = *check.names.module(0).dialect;
    if (std::string_view(function.name).starts_with(kAsked)) return asked_cycle(dialect, function);
    const std::optional<nc::CycleId> id = dialect.find_cycle(function.name);
    if (!id) return std::nullopt;
    const std::vector<nc::Parameter>& parameters = dialect.cycles()[*id].parameters;
    const bool same =
        std::equal(parameters.begin(), parameters.end(), function.parameters.begin(),
                   function.parameters.end(),
                   [](const nc::Parameter& a, const ParameterDecl& b) { return a.name == b.name; });
    return same ? id : std::nullopt;
}

void emit_native_cycle(Check& check) {
    if (!check.body.native_pending) return;
    check.body.native_pending = false;
    check.emit.emit_pair(OpCode::NativeCycle, 0, 0, 0, *check.body.native);
}

namespace {

/// Whether a statement asks something of the parameters, or warns of them, and does nothing else.
bool is_contract(const syntax::Ast& tree, syntax::StmtId id) {
    const syntax::Stmt& stmt = tree[id];
    switch (stmt.kind) {
        case syntax::StmtKind::Require:
        case syntax::StmtKind::Assert:
        case syntax::StmtKind::WarnStmt: return true;
        case syntax::StmtKind::If:
            return !stmt.statement[1].is_valid() && is_contract(tree, stmt.statement[0]);
        case syntax::StmtKind::For: return is_contract(tree, stmt.statement[1]);
        case syntax::StmtKind::Block:
            return std::ranges::all_of(tree.stmts(stmt.statements), [&](syntax::StmtId inner) {
                return tree[inner].kind == syntax::StmtKind::Declaration ||
                       is_contract(tree, inner);
            });
        default: return false;
    }
}

bool only_checks(const Check& check, const FunctionDecl& function) {
    const syntax::Ast& tree = *check.names.module(function.module).ast;
    const syntax::Decl& decl = tree[function.decl];
    if (!decl.body.is_valid()) return false;
    return is_contract(tree, decl.body);
}

/// The function that an expression is a call of; null if it is none of a Kadr file.
const FunctionDecl* called_function(const Check& check, syntax::ExprId id) {
    if (!id.is_valid()) return nullptr;
    const syntax::Expr& expr = check.ast()[id];
    const bool is_call = expr.kind == syntax::ExprKind::Call &&
                         check.ast()[expr.child[0]].kind == syntax::ExprKind::Name;
    if (!is_call) return nullptr;
    const Name* found =
        check.names.find(check.here.module, check.text(check.ast()[expr.child[0]].text));
    if (found == nullptr || found->what != Name::What::Function) return nullptr;
    return &check.names.function(found->index);
}

}  // namespace

/// The contract of a cycle holds for a native one too, so it is checked before; so is what a
/// function works out for the cycle, which may ask as well.
bool is_check(const Check& check, syntax::StmtId id) {
    const syntax::Stmt& stmt = check.ast()[id];
    switch (stmt.kind) {
        case syntax::StmtKind::Empty: return true;
        case syntax::StmtKind::Expression: {
            const FunctionDecl* function = called_function(check, stmt.expression[0]);
            return function != nullptr && only_checks(check, *function);
        }
        case syntax::StmtKind::Declaration: {
            const FunctionDecl* function =
                called_function(check, check.ast()[stmt.declaration].value);
            return function != nullptr && function->kind == DeclKind::Function;
        }
        default: return is_contract(check.ast(), id);
    }
}

}  // namespace kadr::sema
