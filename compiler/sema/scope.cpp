#include "sema/scope.h"

#include <algorithm>

#include "base/diagnostics/sema.h"
#include "sema/builtins.h"
#include "sema/checking.h"
#include "sema/naming.h"

namespace kadr::sema {

namespace {

SymbolId record_local(Check& check, const Symbol& symbol);

}  // namespace

std::string quoted(std::string_view text) {
    std::string all = "`";
    all += text;
    all += '`';
    return all;
}

/// Two imports that declare a name: whichever came first would decide.
void check_unambiguous(Check& check, std::string_view name, const SourceRange& range) {
    if (check.names.module(check.here.module).names.contains(name) || range == check.told.ambiguous)
        return;
    const std::vector<const Name*> all = check.names.imported(check.here.module, name);
    if (all.size() < 2) return;
    check.told.ambiguous = range;
    DiagnosticBuilder builder = check.report(diag::AmbiguousName, range);
    builder.arg(name);
    for (const Name* declared : all) builder.note(declared->range, "it is declared here");
}

Found find(const Check& check, std::string_view name) {
    const std::int32_t local = check.scopes.find(name);
    if (local != Scopes::kNone) return {local, nullptr};
    return {Scopes::kNone, check.names.find(check.here.module, name)};
}

namespace {

void check_new_name(Check& check, std::string_view name, const SourceRange& range) {
    if (name.empty()) return;
    const std::int32_t local = check.scopes.find(name);
    if (local != Scopes::kNone) {
        const bool same_scope = check.scopes.is_of_innermost(local);
        check.report(same_scope ? diag::DuplicateName : diag::ShadowedName, range)
            .arg(name)
            .note(check.scopes[local].range,
                  same_scope ? "it is declared here" : "the outer one is declared here");
        return;
    }
    const auto own = check.names.module(check.here.module).names.find(name);
    if (own != check.names.module(check.here.module).names.end() &&
        own->second.what == Name::What::Variable) {
        check.report(diag::ShadowedName, range)
            .arg(name)
            .note(own->second.range, "the outer one is declared here");
    }
}

}  // namespace

Found look_up(Check& check, syntax::ExprId id) {
    const Found found = find(check, check.text(check.ast()[id].text));
    if (found.symbol >= 0) {
        const Symbol& symbol = check.scopes[found.symbol];
        check.record.note_use(check.here.module, id, symbol.checked);
        check.record.note_givenness(check.here.module, id, symbol.givenness);
    } else if (found.name != nullptr) {
        check.record.note_use(check.here.module, id, found.name->checked);
    }
    return found;
}

void add_symbol(Check& check, Symbol symbol) {
    // `RETURN n;` declares nothing: what its type is, is reported.
    if (check.kind(symbol.type) != TypeKind::Error)
        check_new_name(check, symbol.name, symbol.range);
    symbol.is_optional = check.type_info(symbol.type).is_optional;
    if (!symbol.checked.is_valid() && !symbol.name.empty())
        symbol.checked = record_local(check, symbol);
    note_variable(check, symbol);
    check.scopes.add(symbol, symbol.is_parameter || symbol.may_be_unset || symbol.is_optional);
}

namespace {

SymbolId record_local(Check& check, const Symbol& symbol) {
    DeclaredSymbol declared;
    const bool is_contour =
        symbol.decl.is_valid() && check.ast()[symbol.decl].kind == syntax::DeclKind::Contour;
    declared.kind = is_contour ? DeclaredSymbol::Kind::Contour : DeclaredSymbol::Kind::Variable;
    declared.name = symbol.name;
    declared.file = check.here.module;
    declared.decl = symbol.decl;
    declared.range = symbol.range;
    declared.scope = {symbol.range.file, symbol.range.end, check.scopes.end()};
    declared.type = symbol.type;
    if (check.here.function != nullptr) declared.owner = check.here.function->checked;
    declared.is_const = symbol.is_const;
    return check.record.declare(std::move(declared));
}

}  // namespace

void leave_scope(Check& check, const Scopes::Outer& outer) {
    for (const Symbol& symbol : check.scopes.since(outer)) {
        report_unused(check, symbol);
        end_variable(check, symbol);
    }
    check.scopes.leave(outer);
}

/// A local variable that nothing reads; parameters have their own message. It is reported at the
/// end, if there was no error: what a mistake has cost may have read it.
void report_unused(Check& check, const Symbol& symbol) {
    const bool is_asked = !symbol.is_parameter && !symbol.is_read;
    if (!is_asked || symbol.name.empty() || check.kind(symbol.type) == TypeKind::Error) return;
    if (check.kind(symbol.type) == TypeKind::Execution)
        return;  // executing it may be all that is wanted
    // A library's own matter; and in a broken text, what is missing may have read it.
    if (check.here.module != 0 || check.here.function == nullptr || check.ast().has_errors) return;
    check.told.unused.push_back({symbol.range, symbol.name});
}

std::vector<std::string_view> known_names(const Check& check, bool functions) {
    std::vector<std::string_view> names;
    for (const std::uint32_t module : check.names.visible_modules(check.here.module)) {
        for (const auto& [name, entry] : check.names.module(module).names) {
            if ((entry.what == Name::What::Function) == functions) names.push_back(name);
        }
    }
    if (functions) {
        const auto builtins = builtin_names();
        names.insert(names.end(), builtins.begin(), builtins.end());
        for (const nc::FunctionInfo& info : nc::all_functions()) {
            const bool is_callable = info.function != nc::Function::Cycle &&
                                     !nc::is_no_command(info.function) && !info.name.empty();
            if (is_callable) names.push_back(info.name);
        }
    } else {
        for (const Symbol& symbol : check.scopes.all()) names.push_back(symbol.name);
    }
    // Hash tables have no order of their own; messages must be the same everywhere.
    std::sort(names.begin(), names.end());
    return names;
}

Done require_not_lost(Check& check, std::string_view name) {
    const std::vector<std::string>& lost = check.ast().lost_names;
    if (std::find(lost.begin(), lost.end(), name) == lost.end()) return kDone;
    ++check.sink.errors;  // the parser has reported why
    return kFailed;
}

}  // namespace kadr::sema
