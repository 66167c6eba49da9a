// declarations.cpp — files and what they declare: imports, types, functions, global variables.
#include "sema/declarations.h"

#include <algorithm>
#include <array>
#include <unordered_set>

#include "base/assert.h"
#include "base/diagnostics/sema.h"
#include "base/text.h"
#include "sema/checking.h"
#include "sema/composites.h"
#include "sema/contours.h"
#include "sema/convert.h"
#include "sema/curves.h"
#include "sema/cycle_blocks.h"
#include "sema/expressions.h"
#include "sema/native_cycles.h"
#include "sema/preserves.h"
#include "sema/scope.h"
#include "sema/statements.h"
#include "sema/tests.h"
#include "sema/texts.h"
#include "sema/values.h"
#include "sema/with.h"
#include "syntax/habits.h"

namespace kadr::sema {

using syntax::Decl;
using syntax::DeclKind;

namespace {

void import_file(Check& check, std::uint32_t module, const syntax::Decl& decl);
void check_header(Check& check, const syntax::Ast& ast);
void declare_units(Check& check, std::uint32_t module);
void declare_parameter(Check& check, const FunctionDecl& function, ParameterDecl& parameter);
void report_missing_return(Check& check, const FunctionDecl& function, const syntax::Decl& decl,
                           const SourceRange& end);
void report_overflow(Check& check, std::string_view name, const SourceRange& range);
void report_unused_parameters(Check& check);

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

void import_file(Check& check, std::uint32_t module, const Decl& decl) {
    const syntax::Ast& from = *check.names.module(module).ast;
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

namespace {

std::optional<Type> builtin_type(std::string_view name) {
    struct Row {
        std::string_view name;
        Type type;
    };
    static constexpr Row kRows[] = {
        {"void", types::kVoid},         {"bool", types::kBool},
        {"int", types::kInt},           {"real", types::kReal},
        {"length", types::kLengthType}, {"diameter", types::kDiameter},
        {"angle", types::kAngleType},   {"time", types::kTimeType},
        {"feed", types::kFeed},         {"speed", types::kSpeed},
        {"string", types::kString},     {"point", types::kPoint},
        {"vector", types::kVector},     {"execution", types::kExecution},
        {"contour", types::kContour},
    };
    for (const Row& row : kRows) {
        if (row.name == name) return row.type;
    }
    return std::nullopt;
}

void report_unknown_type(Check& check, std::string_view name, const SourceRange& range) {
    auto builder = check.report(diag::UnknownType, range);
    builder.arg(name);
    if (const std::size_t letters = glued_letters(check, name, range)) {
        fix_glued(letters, range, builder);
        return;
    }
    if (const syntax::Habit* habit = syntax::habit_of(name)) {
        syntax::advise(builder, *habit, range);
        return;
    }
    const std::string upper = upper_ascii(name);
    if (upper != name && is_numbered_word(check, upper)) {  // `g1 x=d;`
        builder.fix("words of blocks are written in upper case: `" + upper + " X=…`");
        return;
    }
    std::vector<std::string_view> known = {"bool",   "int",     "real",    "length", "angle",
                                           "time",   "feed",    "speed",   "string", "point",
                                           "vector", "contour", "diameter"};
    for (const auto& [other, entry] : check.names.module(check.here.module).names) {
        if (entry.what == Name::What::Type) known.push_back(other);
    }
    if (const auto near = nearest_name(name, known.data(), known.size())) {
        builder.fix(range, std::string(*near), "did you mean `" + std::string(*near) + "`?");
        return;
    }
    const std::string lower = syntax::lower_ascii(name);
    if (lower != name && syntax::is_keyword(lower))
        builder.fix(range, lower, "keywords are written in lower case");
}

}  // namespace

Type resolve_type(Check& check, syntax::TypeId id) {
    if (!id.is_valid()) return types::kError;
    const syntax::TypeRef ref = check.ast()[id];
    const std::string_view name = check.text(ref.name);
    Type type = types::kError;
    if (const std::optional<Type> builtin = builtin_type(name)) {
        type = *builtin;
    } else if (const Name* found = check.names.find(check.here.module, name);
               found != nullptr && found->what == Name::What::Type) {
        check_unambiguous(check, name, ref.range);
        check.record.note_type_use(check.here.module, id, found->checked);
        type = found->type;
    } else if (name == "element") {
        type = types::kElement;  // not reserved: a program may have its own
    } else if (!name.empty()) {
        if (!require_not_lost(check, name) || !require_no_foreign_keyword(check, name, ref.range))
            return types::kError;
        report_unknown_type(check, name, ref.range);
        return types::kError;
    }
    if (ref.is_optional && ref.array == syntax::TypeRef::Array::None)
        type = check.types.optional(type);
    if (ref.array == syntax::TypeRef::Array::None) return type;
    if (type == types::kVoid) {
        check.report(diag::VoidValue, ref.range);
        return types::kError;
    }
    std::int64_t count = -1;
    if (ref.array == syntax::TypeRef::Array::Fixed) {
        const Value size = expression(check, ref.size, types::kInt);
        if (check.is_error(size)) return types::kError;
        if (!size.is_constant() || check.kind(size.type) != TypeKind::Int ||
            size.constant.integer < 1 || size.constant.integer > 1'000'000) {
            check.report(diag::ArraySize, check.ast()[ref.size].range);
            return types::kError;
        }
        count = size.constant.integer;
    }
    const Type array = check.types.array(type, count);
    return ref.is_optional ? check.types.optional(array) : array;
}

namespace {

void define_struct(Check& check, std::uint32_t module, Type type, const Decl& decl) {
    const syntax::Ast& tree = *check.names.module(module).ast;
    if (check.types.struct_of(type).slots != 0) return;
    std::vector<Member> members;
    std::unordered_set<std::string_view> names;
    for (const syntax::DeclId id : tree.decls(decl.members)) {
        const Decl& field = tree[id];
        const std::string_view name = tree.text(field.name);
        if (!names.insert(name).second) {
            check.report(diag::DuplicateName, field.name_range).arg(name);
            continue;
        }
        // A struct that this one holds must be complete first.
        if (field.type.is_valid() && tree[field.type].array == syntax::TypeRef::Array::None) {
            const Name* found = check.names.find(module, tree.text(tree[field.type].name));
            if (found != nullptr && found->what == Name::What::Type &&
                check.kind(found->type) == TypeKind::Struct &&
                check.types.struct_of(found->type).slots == 0) {
                const bool is_open = std::find(check.open_structs.begin(), check.open_structs.end(),
                                               found->type) != check.open_structs.end();
                if (found->type == type || is_open) {
                    check.report(diag::RecursiveStruct, field.range)
                        .arg(check.types.struct_of(type).name);
                    members.push_back({std::string(name), types::kError, 0, module, {}, false, {}});
                    continue;
                }
                if (check.open_structs.size() >= kMostLevels) {
                    check.report(diag::StructTooDeep, field.range)
                        .arg(check.types.struct_of(type).name)
                        .arg(std::size_t{kMostLevels});
                    members.push_back({std::string(name), types::kError, 0, module, {}, false, {}});
                    continue;
                }
                check.open_structs.push_back(type);
                define_struct(
                    check, found->module, found->type,
                    (*check.names.module(found->module).ast)[syntax::DeclId{found->index}]);
                check.open_structs.pop_back();
                check.here.module = module;
            }
        }
        check.here.module = module;
        Type member_type = resolve_type(check, field.type);
        if (member_type == types::kVoid) {
            check.report(diag::VoidValue, field.range);
            member_type = types::kError;
        }
        if (field.type.is_valid() && tree[field.type].is_reference) {
            check.report(diag::ReferencePlace, field.range);
        }
        const bool is_optional = field.type.is_valid() && tree[field.type].is_optional;
        DeclaredSymbol symbol = described(check, module, id, DeclaredSymbol::Kind::Member);
        symbol.type = member_type;
        symbol.owner = check.types.struct_of(type).symbol;
        members.push_back({std::string(name), member_type, 0, module, field.value, is_optional,
                           check.record.declare(std::move(symbol))});
    }
    if (members.empty()) {
        check.report(diag::EmptyStruct, decl.name_range).arg(check.types.struct_of(type).name);
        members.push_back({"", types::kError, 0, module, {}, false, {}});
    }
    check.here.module = module;
    switch (check.types.complete_struct(type, std::move(members))) {
        case TypeTable::Completed::Good: break;
        case TypeTable::Completed::TooManyRegisters:
            check.report(diag::FunctionTooLarge, decl.name_range)
                .arg(check.types.struct_of(type).name);
            break;
        case TypeTable::Completed::TooManyLevels:
            check.report(diag::StructTooDeep, decl.name_range)
                .arg(check.types.struct_of(type).name)
                .arg(std::size_t{kMostLevels});
            break;
    }
}

void define_enum_values(Check& check, std::uint32_t module, const Decl& decl) {
    const syntax::Ast& tree = *check.names.module(module).ast;
    const Name* entry = check.names.find(module, tree.text(decl.name));
    if (entry == nullptr || entry->what != Name::What::Type) return;
    std::int64_t next = 0;
    std::vector<std::int64_t> values;
    for (const syntax::DeclId id : tree.decls(decl.members)) {
        const Decl& member = tree[id];
        if (member.value.is_valid()) {
            const Value value = expression(check, member.value, types::kInt);
            if (value.is_constant() && check.kind(value.type) == TypeKind::Int) {
                next = value.constant.integer;
            } else if (!check.is_error(value)) {
                check.report(diag::NotConstant, tree[member.value].range)
                    .arg("the value of an enum member");
            }
        }
        values.push_back(next);
        const auto found = check.names.module(module).names.find(tree.text(member.name));
        if (found != check.names.module(module).names.end() &&
            found->second.range == member.name_range) {
            found->second.member = next;
        }
        ++next;
    }
    check.types.set_enum_values(entry->type, values);
}

}  // namespace

void define_types(Check& check, std::uint32_t module) {
    const syntax::Ast& tree = *check.names.module(module).ast;
    check.here.module = module;
    check.here.units = check.names.module(module).units;
    for (const syntax::DeclId id : tree.top) {
        const Decl& decl = tree[id];
        if (decl.kind == DeclKind::Enum) define_enum_values(check, module, decl);
        if (decl.kind != DeclKind::Struct) continue;
        const Name* found = check.names.find(module, tree.text(decl.name));
        if (found != nullptr && found->what == Name::What::Type &&
            found->range == decl.name_range) {
            define_struct(check, module, found->type, decl);
        }
        check.here.module = module;
    }
}

void define_signature(Check& check, std::uint32_t index) {
    check.here.module = check.names.function(index).module;
    check.here.units = units_of(check, check.names.function(index));
    const Decl decl = check.ast()[check.names.function(index).decl];
    FunctionDecl& function = check.names.function(index);
    function.result = decl.kind == DeclKind::Function && decl.type.is_valid()
                          ? resolve_type(check, decl.type)
                          : types::kVoid;
    check.record.set_type(function.checked, function.result);
    if (decl.type.is_valid() && check.ast()[decl.type].is_reference) {
        check.report(diag::ReferencePlace, check.ast()[decl.type].range);
    }
    const bool is_curve = decl.kind == DeclKind::Curve;
    if (is_curve) function.result = function.is_limits ? types::kRange : types::kPoint;
    std::vector<syntax::DeclId> parameters(check.ast().decls(decl.parameters).begin(),
                                           check.ast().decls(decl.parameters).end());
    // The running parameter is one more of the function that gives the points.
    if (is_curve && !function.is_limits) parameters.push_back(check.ast().decls(decl.members)[0]);
    std::uint32_t next = 0;
    for (const syntax::DeclId id : parameters) {
        const Decl& parameter = check.ast()[id];
        ParameterDecl entry;
        entry.name = check.text(parameter.name);
        entry.range = parameter.name_range;
        entry.decl = id;
        entry.type = resolve_type(check, parameter.type);
        if (entry.type == types::kVoid) {
            check.report(diag::VoidValue, parameter.range);
            entry.type = types::kError;
        }
        entry.is_reference = parameter.type.is_valid() && check.ast()[parameter.type].is_reference;
        // `int n in 1..20` of a property: a range is not a default.
        if (decl.kind != DeclKind::Property) entry.initial = parameter.value;
        if (entry.is_reference && parameter.value.is_valid()) {
            check.report(diag::ReferenceDefault, parameter.range).arg(entry.name);
            entry.initial = {};
        }
        if (entry.is_reference && decl.kind == DeclKind::Program) {
            check.report(diag::ProgramParameter, parameter.range).arg(entry.name);
        }
        entry.may_be_unset = parameter.type.is_valid() && check.ast()[parameter.type].is_optional &&
                             check.kind(entry.type) == TypeKind::Struct;
        entry.is_required = !entry.initial.is_valid() && !check.type_info(entry.type).is_optional &&
                            !entry.may_be_unset;
        entry.slots = entry.is_reference ? 1 : check.type_info(entry.type).slots;
        entry.reg = static_cast<Reg>(next);
        next += entry.slots;
        declare_parameter(check, function, entry);
        function.parameters.push_back(entry);
    }
    if (function.parameters.size() > 32) {
        check.report(diag::TooManyParameters, decl.name_range).arg(function.name);
        function.parameters.resize(32);
    }
    // Reported where the body is checked, which finds no room for them.
    function.parameter_slots = static_cast<std::uint16_t>(std::min(next, kMostRegisters + 1));
}

namespace {

/// Both functions of a curve have its parameters.
void declare_parameter(Check& check, const FunctionDecl& function, ParameterDecl& parameter) {
    const SymbolId known =
        check.checked.files[check.here.module].declarations[parameter.decl.index];
    if (known.is_valid()) {
        parameter.checked = known;
        return;
    }
    DeclaredSymbol symbol =
        described(check, check.here.module, parameter.decl, DeclaredSymbol::Kind::Parameter);
    symbol.scope = check.ast()[function.decl].range;
    symbol.type = parameter.type;
    symbol.owner = function.checked;
    parameter.checked = check.record.declare(std::move(symbol));
}

}  // namespace

void check_global(Check& check, std::uint32_t index, bool on_demand) {
    GlobalVariable& global = check.names.global(index);
    if (global.state == GlobalVariable::State::Done) return;
    const syntax::Ast& tree = *check.names.module(global.module).ast;
    const Decl& decl = tree[global.decl];
    if (global.state == GlobalVariable::State::Checking) {
        check.report(diag::CircularConstant, decl.name_range).arg(tree.text(decl.name));
        global.state = GlobalVariable::State::Done;  // reported once
        return;
    }
    global.state = GlobalVariable::State::Checking;
    const Finding finding(check);
    const std::uint32_t module = std::exchange(check.here.module, global.module);
    const Units units = std::exchange(check.here.units, check.names.module(global.module).units);
    const SourceRange location = check.emit.location();
    check.emit.set_location(decl.range);

    Symbol symbol;
    symbol.name = tree.text(decl.name);
    symbol.range = decl.name_range;
    symbol.decl = global.decl;
    symbol.checked = global.symbol.checked;
    symbol.is_const = decl.is_const;
    symbol.type = decl.type.is_valid() ? resolve_type(check, decl.type) : types::kError;
    if (decl.is_const && !decl.value.is_valid())
        check.report(diag::ConstWithoutValue, decl.name_range).arg(symbol.name);
    const Reg mark = check.emit.mark();
    Value value = error_value();
    const bool is_body = decl.kind == DeclKind::Contour;
    if (is_body) {
        symbol.type = types::kContour;
        value = in_registers(types::kContour, check.emit.take(1));
        value.is_fresh = true;
        contour_body(check, decl, value.reg);
    } else if (decl.value.is_valid()) {
        value = expression(check, decl.value, symbol.type);
        if (decl.type.is_valid()) {
            value = convert(check, value, symbol.type, tree[decl.value].range, symbol.name);
        } else {
            symbol.type = value.type;
            if (symbol.type == types::kVoid) {
                check.report(diag::VoidValue, tree[decl.value].range);
                symbol.type = types::kError;
            }
        }
    }
    if (decl.is_const && value.is_constant()) {
        symbol.storage = Symbol::Storage::Constant;
        symbol.constant = value;
    } else {
        if (on_demand && !check.is_error(value)) {
            check.report(diag::UsedBeforeDefinition, decl.name_range).arg(symbol.name);
        }
        symbol.storage = Symbol::Storage::Global;
        symbol.global = check.code->globals;
        const std::uint16_t slots = check.type_info(symbol.type).slots;
        const bool had_room = check.code->globals <= kMostGlobals;
        check.code->globals += slots;
        if (had_room && check.code->globals > kMostGlobals)
            check.report(diag::GlobalsTooLarge, symbol.range).arg(std::size_t{kMostGlobals});
        symbol.may_be_unset = !decl.value.is_valid() && !is_body;
        Reg reg = 0;
        if (decl.value.is_valid() || is_body) {
            reg = in_register(check, value);
            if (value.is_variable && check.types.holds_array(symbol.type)) {
                const Reg copy = check.emit.take(slots);
                copy_value(check, value, copy);
                reg = copy;
            }
        } else {
            reg = check.emit.take(slots);
            if (check.is_optional_type(decl)) emit_unset(check, symbol.type, reg);
            else emit_initial(check, symbol.type, reg);
        }
        if (slots > 0) check.emit.emit_pair(OpCode::StoreGlobal, reg, 0, slots, symbol.global);
    }
    report_overflow(check, symbol.name, symbol.range);
    check.emit.release_to(mark);
    check.emit.set_location(location);
    check.here.module = module;
    check.here.units = units;
    check.record.set_type(symbol.checked, symbol.type);
    check.names.global(index).symbol = symbol;
    check.names.global(index).state = GlobalVariable::State::Done;
}

namespace {

void bind_parameters(Check& check, const FunctionDecl& function) {
    for (const ParameterDecl& parameter : function.parameters) {
        Symbol symbol;
        symbol.name = parameter.name;
        symbol.type = parameter.type;
        symbol.storage =
            parameter.is_reference ? Symbol::Storage::Reference : Symbol::Storage::Local;
        symbol.reg = parameter.reg;
        symbol.range = parameter.range;
        symbol.decl = parameter.decl;
        symbol.checked = parameter.checked;
        symbol.is_parameter = true;
        symbol.may_be_unset = parameter.may_be_unset;
        if (parameter.may_be_unset) symbol.givenness = Givenness::Perhaps;
        if (check.type_info(parameter.type).is_optional) symbol.givenness = Givenness::Perhaps;
        const Found same = find(check, parameter.name);
        if (same.symbol >= 0) check.scopes[same.symbol].is_read = true;  // reported once
        add_symbol(check, symbol);
    }
}

/// The prologue: each default is evaluated if its argument was not given. A default may use the
/// parameters before it.
void check_defaults(Check& check, const FunctionDecl& function) {
    for (std::size_t i = function.parameters.size(); i-- > 0;)
        check.scopes.hide(function.parameters[i].name);
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const ParameterDecl parameter = function.parameters[i];
        const auto symbol = static_cast<std::int32_t>(i);
        const auto show = [&] { check.scopes.show(symbol); };
        if (parameter.is_required) {
            show();
            continue;
        }
        check.body.defaults_from = i;
        Label skip;
        check.emit.set_location(parameter.range);
        check.emit.jump(OpCode::SkipIfGiven, skip, 0, 0, static_cast<unsigned>(i));
        const Reg mark = check.emit.mark();
        if (!parameter.initial.is_valid()) {
            emit_unset(check, parameter.type, parameter.reg);
        } else {
            check.emit.set_location(check.ast()[parameter.initial].range);
            Value value = expression(check, parameter.initial, parameter.type);
            // `length initial = position.z`: a default that is not given itself leaves the
            // parameter not given; reading it is the mistake.
            if (check.type_info(value.type).is_optional &&
                !check.type_info(parameter.type).is_optional &&
                check.type_info(parameter.type).kind == check.type_info(value.type).kind) {
                check.scopes[symbol].may_be_unset = true;
                check.scopes[symbol].givenness = Givenness::Perhaps;
                check.scopes[symbol].unset_name =
                    check.sources.text(check.ast()[parameter.initial].range);
                value.type = check.types.given(value.type);
            }
            value = convert(check, value, parameter.type, check.ast()[parameter.initial].range,
                            parameter.name);
            if (!check.is_error(value)) copy_value(check, value, parameter.reg);
        }
        check.emit.release_to(mark);
        check.emit.bind(skip);
        show();
    }
    check.body.defaults_from = BodyState::kNoDefault;
}

}  // namespace

void check_function(Check& check, std::uint32_t index) {
    const FunctionDecl function = check.names.function(index);
    check.here.module = function.module;
    check.here.units = units_of(check, function);
    const Decl decl = check.ast()[function.decl];
    check.here.function = &function;
    check.emit.begin_function();
    check.scopes.begin_function(decl.range.end);
    check.here.loops.clear();
    check.here.with_depth = 0;
    check.here.loop_depth = 0;
    check.body.native = native_cycle(check, function);

    FunctionCode& entry = check.code->functions[index + 1];
    entry.entry = check.emit.here();
    check.emit.take(
        std::max<unsigned>(function.parameter_slots, check.type_info(function.result).slots));
    check.emit.release_to(function.parameter_slots);
    bind_parameters(check, function);
    if (function.kind == DeclKind::Property) property_ranges(check, index);
    check_defaults(check, function);
    check.code->functions[index + 1].body = check.emit.here();
    check.body.native_pending = check.body.native.has_value();
    if (decl.kind == DeclKind::Curve) {
        curve_body(check, function, decl);
        for (const Symbol& symbol : check.scopes.all()) report_unused(check, symbol);
        FunctionCode& curve = check.code->functions[index + 1];
        curve.end = check.emit.here();
        curve.registers = check.emit.registers_used();
        // The function of the points has all parameters of that of the limits, one more and three
        // coordinates: where these find no room it reports it for both.
        constexpr std::uint32_t kMoreOfPoints = 4;
        if (!function.is_limits || function.parameter_slots + kMoreOfPoints <= kMostRegisters)
            report_overflow(check, function.name, function.range);
        check.here.function = nullptr;
        return;
    }
    check.body.has_preserves = decl.preserves.count > 0;
    if (check.body.has_preserves) {
        check.emit.set_location(decl.range);
        ModalMask mask = words_mask(check, check.ast().word_run(decl.preserves), true);
        check.emit.emit_pair(OpCode::EnterPreserves, 0, 0, 0, mask);
        check.code->functions[index + 1].needs = preserved_members(check, decl);
    }
    Completion completion = Completion::Normal;
    if (decl.body.is_valid()) {
        const syntax::Stmt body = check.ast()[decl.body];
        completion = body.kind == syntax::StmtKind::Block
                         ? block(check, body.statements, body.range)
                         : statement(check, decl.body);
    }
    emit_native_cycle(check);
    const SourceRange end{decl.range.file, decl.range.end > 0 ? decl.range.end - 1 : 0,
                          decl.range.end};
    check.emit.set_location(end);
    if (completion == Completion::Normal) {
        if (function.result != types::kVoid && check.kind(function.result) != TypeKind::Error)
            report_missing_return(check, function, decl, end);
        leave_function(check, end);
        check.emit.emit(OpCode::Return, 0, 0, 0);
    }
    if (check.body.has_preserves) check_preserves(check, function, decl);
    report_unused_parameters(check);

    FunctionCode& done = check.code->functions[index + 1];
    done.end = check.emit.here();
    done.registers = check.emit.registers_used();
    report_overflow(check, function.name, function.range);
    check.here.function = nullptr;
}

namespace {

void report_missing_return(Check& check, const FunctionDecl& function, const Decl& decl,
                           const SourceRange& end) {
    // A statement that could not be read may have been the `return`.
    const bool is_broken =
        std::ranges::any_of(check.ast().statements, [&](const syntax::Stmt& other) {
            return other.kind == syntax::StmtKind::Invalid &&
                   other.range.begin >= decl.range.begin && other.range.end <= decl.range.end;
        });
    if (is_broken) return;
    check.report(diag::MissingReturn, function.range)
        .arg(function.name)
        .arg(check.type_name(function.result))
        .note(end, "the end is reached here without a `return`");
}

/// Reports it if what was emitted needs more registers than there are.
void report_overflow(Check& check, std::string_view name, const SourceRange& range) {
    if (!check.emit.has_overflowed()) return;
    check.emit.forget_overflow();
    check.report(diag::FunctionTooLarge, range).arg(name);
}

void report_unused_parameters(Check& check) {
    if (check.here.function->module != 0) return;  // a library's own matter
    if (check.ast().has_errors) return;            // what is missing may have used them
    for (const Symbol& symbol : check.scopes.all()) {
        if (!symbol.is_parameter || symbol.is_read || symbol.name.empty()) continue;
        check.report(diag::UnusedParameter, symbol.range).arg(symbol.name);
    }
}

}  // namespace

ParameterInfo describe_parameter(Check& check, const ParameterDecl& parameter) {
    ParameterInfo info;
    info.name = parameter.name;
    info.type_name = check.type_name(parameter.type);
    const TypeInfo& type = check.type_info(parameter.type);
    using K = ParameterInfo::Kind;
    switch (type.kind) {
        case TypeKind::Bool: info.kind = K::Bool; break;
        case TypeKind::Int: info.kind = K::Integer; break;
        case TypeKind::Real: info.kind = K::Number; break;
        case TypeKind::Feed: info.kind = K::Feed; break;
        case TypeKind::Speed: info.kind = K::Speed; break;
        case TypeKind::String: info.kind = K::Text; break;
        case TypeKind::Enum: info.kind = K::Enum; break;
        case TypeKind::Struct:
        case TypeKind::Array:
        case TypeKind::Range:
        case TypeKind::Execution:
        case TypeKind::Void:
        case TypeKind::Error: info.kind = K::Other; break;
    }
    if (type.is_contour) info.kind = K::Contour;
    if (parameter.is_reference) info.kind = K::Other;
    if (info.kind == K::Contour) info.layout = layout_constant(check, type.element);
    info.quantity = type.quantity;
    info.is_optional = type.is_optional;
    info.has_default = !parameter.is_required;
    info.slot = parameter.reg;
    info.slots = parameter.slots;
    info.enumeration = type.kind == TypeKind::Enum ? type.definition : 0;
    info.range = parameter.range;
    return info;
}

void export_enums(Check& check) {
    for (std::uint32_t i = 0; i < check.types.enum_count(); ++i) {
        const EnumInfo& info = check.types.enum_at(i);
        check.code->enums.push_back({info.name, info.members});
    }
}

}  // namespace kadr::sema
