#include "sema/declarations.h"

#include <algorithm>
#include <array>

#include "base/diagnostics/sema.h"
#include "base/text.h"
#include "sema/checking.h"
#include "sema/cycle_blocks.h"
#include "sema/tests.h"

namespace kadr::sema {

using syntax::Decl;
using syntax::DeclKind;

namespace {

void import_file(Check& check, std::uint32_t module, const syntax::Decl& decl);
void check_header(Check& check, const syntax::Ast& ast);
void declare_units(Check& check, std::uint32_t module);

}  // namespace

/// `units inch;` as the first statement of a program holds for all of it, its parameters too.
Units units_of(const Check& check, const FunctionDecl& function) {
    const syntax::Ast& tree = *check.names.module(function.module).ast;
    const syntax::Decl& decl = tree[function.decl];
    if (!decl.body.is_valid()) return check.names.module(function.module).units;
    for (const syntax::StmtId id : tree.stmts(tree[decl.body].statements)) {
        const syntax::Stmt& stmt = tree[id];
        if (stmt.kind == syntax::StmtKind::Empty) continue;
        if (stmt.kind != syntax::StmtKind::Units) break;
        return tree.text(stmt.text) == "mm" ? Units::Metric : Units::Inch;
    }
    return check.names.module(function.module).units;
}

std::uint32_t load_module(Check& check, const syntax::Ast& ast, const nc::Dialect& dialect) {
    if (const auto known = check.names.module_of(ast)) return *known;
    const std::uint32_t module = check.names.add_module(ast, dialect);
    check.record.add_file(ast, dialect);
    check_header(check, ast);
    declare_units(check, module);
    for (const syntax::DeclId id : ast.top) {
        if (ast[id].kind == DeclKind::Import) import_file(check, module, ast[id]);
    }
    load_cycles(check, module);
    // The first file asks for the prelude before anything else needs it; the prelude itself does
    // not import itself.
    if (!check.names.ask_for_prelude()) return module;
    const ModuleLoader::Module prelude =
        check.loader.load("prelude", false, ast.file, {ast.file, 0, 0});
    if (prelude.ast != nullptr) {
        check.names.set_prelude(load_module(
            check, *prelude.ast, prelude.dialect != nullptr ? *prelude.dialect : dialect));
    }
    return module;
}

namespace {

/// `import "tools.csv";` names the tool library.
bool is_tool_library(const Decl& decl, std::string_view file) {
    const std::string name = upper_ascii(file);
    return decl.is_file && (name.ends_with(".CSV") || name.ends_with(".XML"));
}

void import_file(Check& check, std::uint32_t module, const Decl& decl) {
    const syntax::Ast& from = *check.names.module(module).ast;
    if (is_tool_library(decl, from.text(decl.name))) {
        if (!check.loader.load_tools(from.text(decl.name), from.file, decl.range))
            ++check.sink.errors;  // the loader has reported why
        return;
    }
    const nc::Dialect& dialect = *check.names.module(module).dialect;
    const ModuleLoader::Module found =
        check.loader.load(from.text(decl.name), decl.is_file, from.file, decl.range);
    if (found.ast == nullptr) {
        ++check.sink.errors;  // the loader has reported why
        return;
    }
    const std::uint32_t imported =
        load_module(check, *found.ast, found.dialect != nullptr ? *found.dialect : dialect);
    check.record.import(module, decl.range, imported);
    check.names.import(module, imported);
}

/// What tells how a file is to be read stands in front of everything that is read so, and once.
void check_header(Check& check, const syntax::Ast& ast) {
    static constexpr std::pair<DeclKind, std::string_view> kHeaders[] = {
        {DeclKind::Units, "units"},
        {DeclKind::Dialect, "dialect"},
        {DeclKind::Language, "language"},
    };
    std::array<const Decl*, std::size(kHeaders)> said{};
    const Decl* first = nullptr;
    for (const syntax::DeclId id : ast.top) {
        const Decl& decl = ast[id];
        const auto* const header =
            std::ranges::find(kHeaders, decl.kind, [](const auto& row) { return row.first; });
        if (header == std::end(kHeaders)) {
            if (first == nullptr && decl.kind != DeclKind::Invalid) first = &decl;
            continue;
        }
        const Decl*& before = said[static_cast<std::size_t>(header - kHeaders)];
        if (before != nullptr) {
            check.report(diag::HeaderTwice, decl.range)
                .arg(header->second)
                .note(before->range, "it stands here");
        } else if (first != nullptr) {
            check.report(diag::HeaderLate, decl.range)
                .arg(header->second)
                .note(first->range, "the first declaration stands here");
        }
        before = &decl;
    }
}

void declare_units(Check& check, std::uint32_t module) {
    const syntax::Ast& ast = *check.names.module(module).ast;
    for (const syntax::DeclId id : ast.top) {
        const Decl& decl = ast[id];
        if (decl.kind != DeclKind::Units) continue;
        check.names.module(module).units =
            ast.text(decl.name) == "mm" ? Units::Metric : Units::Inch;
    }
    check.record.set_units(module, check.names.module(module).units);
}

DeclaredSymbol::Kind kind_of(DeclKind kind) {
    using Kind = DeclaredSymbol::Kind;
    switch (kind) {
        case DeclKind::Parameter: return Kind::Parameter;
        case DeclKind::Function: return Kind::Function;
        case DeclKind::Cycle: return Kind::Cycle;
        case DeclKind::Program: return Kind::Program;
        case DeclKind::Struct: return Kind::Struct;
        case DeclKind::Enum: return Kind::Enum;
        case DeclKind::Contour: return Kind::Contour;
        case DeclKind::Curve: return Kind::Curve;
        case DeclKind::Test: return Kind::Test;
        case DeclKind::Property: return Kind::Property;
        case DeclKind::Variable:
        case DeclKind::Import:
        case DeclKind::Units:
        case DeclKind::Dialect:
        case DeclKind::Language:
        case DeclKind::Invalid: break;
    }
    return Kind::Variable;
}

Name entry_of(Name::What what, std::uint32_t index, Type type = {}, std::int64_t member = 0) {
    Name entry;
    entry.what = what;
    entry.index = index;
    entry.type = type;
    entry.member = member;
    return entry;
}

}  // namespace

DeclaredSymbol described(const Check& check, std::uint32_t module, syntax::DeclId id,
                         DeclaredSymbol::Kind kind) {
    const syntax::Ast& tree = *check.names.module(module).ast;
    DeclaredSymbol symbol;
    symbol.kind = kind;
    symbol.name = tree.text(tree[id].name);
    symbol.file = module;
    symbol.decl = id;
    symbol.range = tree[id].name_range.file.is_valid() ? tree[id].name_range : tree[id].range;
    symbol.is_const = tree[id].is_const;
    return symbol;
}

namespace {

/// Declares a name of a file; what it is called and where stands in its declaration.
SymbolId declare(Check& check, std::uint32_t module, syntax::DeclId id, Name entry,
                 SymbolId owner = {}) {
    const Decl& decl = (*check.names.module(module).ast)[id];
    const std::string_view name = check.names.module(module).ast->text(decl.name);
    if (name.empty()) return {};
    entry.module = module;
    entry.range = decl.name_range;
    const bool is_member = entry.what == Name::What::EnumMember;
    DeclaredSymbol symbol = described(
        check, module, id, is_member ? DeclaredSymbol::Kind::EnumMember : kind_of(decl.kind));
    symbol.type = entry.type;
    symbol.owner = owner;
    entry.checked = check.record.declare(std::move(symbol));
    const auto [found, is_new] = check.names.module(module).names.try_emplace(name, entry);
    if (!is_new) {
        check.report(diag::DuplicateName, entry.range)
            .arg(name)
            .note(found->second.range, "it is declared here");
    }
    return entry.checked;
}

void declare_enum(Check& check, std::uint32_t module, syntax::DeclId id) {
    const syntax::Ast& ast = *check.names.module(module).ast;
    const Decl& decl = ast[id];
    EnumInfo info;
    info.name = ast.text(decl.name);
    info.range = decl.name_range;
    std::int64_t next = 0;
    for (const syntax::DeclId member : ast.decls(decl.members)) {
        info.members.emplace_back(ast.text(ast[member].name), next++);
    }
    const Type type = check.types.add_enum(info);
    const SymbolId symbol = declare(check, module, id, entry_of(Name::What::Type, 0, type));
    check.types.set_symbol(type, symbol);
    next = 0;
    std::vector<SymbolId> members;
    for (const syntax::DeclId member : ast.decls(decl.members)) {
        const Name entry = entry_of(Name::What::EnumMember, 0, type, next++);
        members.push_back(declare(check, module, member, entry, symbol));
    }
    check.types.set_member_symbols(type, std::move(members));
}

}  // namespace

void declare_names(Check& check, std::uint32_t module) {
    const syntax::Ast& ast = *check.names.module(module).ast;
    check.here.module = module;
    for (const syntax::DeclId id : ast.top) {
        const Decl& decl = ast[id];
        const std::string_view name = ast.text(decl.name);
        switch (decl.kind) {
            case DeclKind::Function:
            case DeclKind::Cycle:
            case DeclKind::Program: {
                FunctionDecl function;
                function.module = module;
                function.decl = id;
                function.name = name;
                function.kind = decl.kind;
                function.range = decl.name_range;
                const std::uint32_t index = check.names.function_count();
                function.checked =
                    declare(check, module, id, entry_of(Name::What::Function, index));
                check.names.add_function(std::move(function));
                break;
            }
            case DeclKind::Contour:
            case DeclKind::Variable: {
                const std::uint32_t index = check.names.add_global(module, id);
                check.names.global(index).symbol.checked =
                    declare(check, module, id, entry_of(Name::What::Variable, index));
                break;
            }
            case DeclKind::Struct: {
                StructInfo info;
                info.name = name;
                info.range = decl.name_range;
                const Type type = check.types.add_struct(std::move(info));
                const SymbolId symbol =
                    declare(check, module, id, entry_of(Name::What::Type, id.index, type));
                check.types.set_symbol(type, symbol);
                break;
            }
            case DeclKind::Enum: declare_enum(check, module, id); break;
            case DeclKind::Curve: {
                FunctionDecl points;
                points.module = module;
                points.decl = id;
                points.name = name;
                points.kind = decl.kind;
                points.range = decl.name_range;
                const std::uint32_t index = check.names.function_count();
                points.checked = declare(check, module, id, entry_of(Name::What::Curve, index));
                FunctionDecl limits = points;
                limits.is_limits = true;
                check.names.add_function(std::move(points));
                check.names.add_function(std::move(limits));
                break;
            }
            case DeclKind::Test:
            case DeclKind::Property: declare_test(check, module, id); break;
            case DeclKind::Parameter:
            case DeclKind::Import:
            case DeclKind::Units:
            case DeclKind::Dialect:
            case DeclKind::Language:
            case DeclKind::Invalid: break;
        }
    }
}

}  // namespace kadr::sema
