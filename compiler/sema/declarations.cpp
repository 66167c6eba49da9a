// declarations.cpp — files and what they declare: imports, types, functions, global variables.
#include <algorithm>
#include <array>
#include <unordered_set>

#include "base/assert.h"
#include "base/diagnostics/sema.h"
#include "base/text.h"
#include "sema/checker.h"
#include "syntax/habits.h"

namespace kadr::sema {

using syntax::Decl;
using syntax::DeclKind;

std::uint32_t Checker::load_module(const syntax::Ast& ast, const nc::Dialect& dialect) {
    for (std::uint32_t i = 0; i < modules_.size(); ++i) {
        if (modules_[i].ast == &ast) return i;
    }
    const auto module = static_cast<std::uint32_t>(modules_.size());
    ModuleScope scope;
    scope.ast = &ast;
    scope.dialect = &dialect;
    modules_.push_back(std::move(scope));
    record_.add_file(ast, dialect);
    check_header(ast);
    declare_units(module);
    for (const syntax::DeclId id : ast.top) {
        if (ast[id].kind == DeclKind::Import) import(module, ast[id]);
    }
    load_cycles(module);
    if (prelude_ == 0xffffffffu) {
        // The first file asks for the prelude before anything else needs it; the prelude itself
        // finds the mark below and does not import itself.
        prelude_ = 0xfffffffeu;
        const ModuleLoader::Module prelude =
            loader_.load("prelude", false, ast.file, {ast.file, 0, 0});
        if (prelude.ast != nullptr) {
            prelude_ =
                load_module(*prelude.ast, prelude.dialect != nullptr ? *prelude.dialect : dialect);
        }
    }
    return module;
}

void Checker::import(std::uint32_t module, const Decl& decl) {
    const syntax::Ast& from = *modules_[module].ast;
    const nc::Dialect& dialect = *modules_[module].dialect;
    const ModuleLoader::Module found =
        loader_.load(from.text(decl.name), decl.is_file, from.file, decl.range);
    if (found.ast == nullptr) {
        ++sink_.errors;  // the loader has reported why
        return;
    }
    const std::uint32_t imported =
        load_module(*found.ast, found.dialect != nullptr ? *found.dialect : dialect);
    record_.import(module, decl.range, imported);
    std::vector<std::uint32_t>& imports = modules_[module].imports;
    if (std::find(imports.begin(), imports.end(), imported) == imports.end()) {
        imports.push_back(imported);
    }
}

/// What tells how a file is to be read stands in front of everything that is read so, and once.
void Checker::check_header(const syntax::Ast& ast) {
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
            report(diag::HeaderTwice, decl.range)
                .arg(header->second)
                .note(before->range, "it stands here");
        } else if (first != nullptr) {
            report(diag::HeaderLate, decl.range)
                .arg(header->second)
                .note(first->range, "the first declaration stands here");
        }
        before = &decl;
    }
}

void Checker::declare_units(std::uint32_t module) {
    const syntax::Ast& ast = *modules_[module].ast;
    for (const syntax::DeclId id : ast.top) {
        const Decl& decl = ast[id];
        if (decl.kind != DeclKind::Units) continue;
        modules_[module].units = ast.text(decl.name) == "mm" ? Units::Metric : Units::Inch;
    }
    record_.set_units(module, modules_[module].units);
}

namespace {

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

DeclaredSymbol Checker::described(std::uint32_t module, syntax::DeclId id,
                                  DeclaredSymbol::Kind kind) const {
    const syntax::Ast& tree = *modules_[module].ast;
    DeclaredSymbol symbol;
    symbol.kind = kind;
    symbol.name = tree.text(tree[id].name);
    symbol.file = module;
    symbol.decl = id;
    symbol.range = tree[id].name_range.file.is_valid() ? tree[id].name_range : tree[id].range;
    symbol.is_const = tree[id].is_const;
    return symbol;
}

/// Declares a name of a file; what it is called and where stands in its declaration.
SymbolId Checker::declare(std::uint32_t module, syntax::DeclId id, Name entry, SymbolId owner) {
    const Decl& decl = (*modules_[module].ast)[id];
    const std::string_view name = modules_[module].ast->text(decl.name);
    if (name.empty()) return {};
    entry.module = module;
    entry.range = decl.name_range;
    const bool is_member = entry.what == Name::What::EnumMember;
    DeclaredSymbol symbol =
        described(module, id, is_member ? DeclaredSymbol::Kind::EnumMember : kind_of(decl.kind));
    symbol.type = entry.type;
    symbol.owner = owner;
    entry.checked = record_.declare(std::move(symbol));
    const auto [found, is_new] = modules_[module].names.try_emplace(name, entry);
    if (!is_new) {
        report(diag::DuplicateName, entry.range)
            .arg(name)
            .note(found->second.range, "it is declared here");
    }
    return entry.checked;
}

void Checker::declare_enum(std::uint32_t module, syntax::DeclId id) {
    const syntax::Ast& ast = *modules_[module].ast;
    const Decl& decl = ast[id];
    EnumInfo info;
    info.name = ast.text(decl.name);
    info.range = decl.name_range;
    std::int64_t next = 0;
    for (const syntax::DeclId member : ast.decls(decl.members)) {
        info.members.emplace_back(ast.text(ast[member].name), next++);
    }
    const Type type = types_.add_enum(info);
    const SymbolId symbol = declare(module, id, entry_of(Name::What::Type, 0, type));
    types_.set_symbol(type, symbol);
    next = 0;
    std::vector<SymbolId> members;
    for (const syntax::DeclId member : ast.decls(decl.members)) {
        const Name entry = entry_of(Name::What::EnumMember, 0, type, next++);
        members.push_back(declare(module, member, entry, symbol));
    }
    types_.set_member_symbols(type, std::move(members));
}

void Checker::declare_names(std::uint32_t module) {
    const syntax::Ast& ast = *modules_[module].ast;
    module_ = module;
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
                const auto index = static_cast<std::uint32_t>(functions_.size());
                function.checked = declare(module, id, entry_of(Name::What::Function, index));
                functions_.push_back(std::move(function));
                break;
            }
            case DeclKind::Contour:
            case DeclKind::Variable: {
                const auto index = static_cast<std::uint32_t>(globals_.size());
                globals_.push_back({GlobalVariable::State::Unchecked, module, id, {}});
                const SymbolId symbol = declare(module, id, entry_of(Name::What::Variable, index));
                globals_.back().symbol.checked = symbol;
                break;
            }
            case DeclKind::Struct: {
                StructInfo info;
                info.name = name;
                info.range = decl.name_range;
                const Type type = types_.add_struct(std::move(info));
                const SymbolId symbol =
                    declare(module, id, entry_of(Name::What::Type, id.index, type));
                types_.set_symbol(type, symbol);
                break;
            }
            case DeclKind::Enum: declare_enum(module, id); break;
            case DeclKind::Curve: {
                FunctionDecl points;
                points.module = module;
                points.decl = id;
                points.name = name;
                points.kind = decl.kind;
                points.range = decl.name_range;
                const auto index = static_cast<std::uint32_t>(functions_.size());
                points.checked = declare(module, id, entry_of(Name::What::Curve, index));
                FunctionDecl limits = points;
                limits.is_limits = true;
                functions_.push_back(std::move(points));
                functions_.push_back(std::move(limits));
                break;
            }
            case DeclKind::Test:
            case DeclKind::Property: declare_test(module, id); break;
            case DeclKind::Parameter:
            case DeclKind::Import:
            case DeclKind::Units:
            case DeclKind::Dialect:
            case DeclKind::Language:
            case DeclKind::Invalid: break;
        }
    }
}

std::optional<Type> Checker::builtin_type(std::string_view name) const {
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

void Checker::report_unknown_type(std::string_view name, const SourceRange& range) {
    auto builder = report(diag::UnknownType, range);
    builder.arg(name);
    if (const std::size_t letters = glued_letters(name, range)) {
        fix_glued(letters, range, builder);
        return;
    }
    if (const syntax::Habit* habit = syntax::habit_of(name)) {
        syntax::advise(builder, *habit, range);
        return;
    }
    const std::string upper = upper_ascii(name);
    if (upper != name && is_numbered_word(upper)) {  // `g1 x=d;`
        builder.fix("words of blocks are written in upper case: `" + upper + " X=…`");
        return;
    }
    std::vector<std::string_view> known = {"bool",   "int",     "real",    "length", "angle",
                                           "time",   "feed",    "speed",   "string", "point",
                                           "vector", "contour", "diameter"};
    for (const auto& [other, entry] : modules_[module_].names) {
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

Type Checker::resolve_type(syntax::TypeId id) {
    if (!id.is_valid()) return types::kError;
    const syntax::TypeRef ref = ast()[id];
    const std::string_view name = text(ref.name);
    Type type = types::kError;
    if (const std::optional<Type> builtin = builtin_type(name)) {
        type = *builtin;
    } else if (const Name* found = find_global(module_, name);
               found != nullptr && found->what == Name::What::Type) {
        check_unambiguous(name, ref.range);
        record_.note_type_use(module_, id, found->checked);
        type = found->type;
    } else if (name == "element") {
        type = types::kElement;  // not reserved: a program may have its own
    } else if (!name.empty()) {
        if (!require_not_lost(name) || !require_no_foreign_keyword(name, ref.range))
            return types::kError;
        report_unknown_type(name, ref.range);
        return types::kError;
    }
    if (ref.is_optional && ref.array == syntax::TypeRef::Array::None) type = types_.optional(type);
    if (ref.array == syntax::TypeRef::Array::None) return type;
    if (type == types::kVoid) {
        report(diag::VoidValue, ref.range);
        return types::kError;
    }
    std::int64_t count = -1;
    if (ref.array == syntax::TypeRef::Array::Fixed) {
        const Value size = expression(ref.size, types::kInt);
        if (is_error(size)) return types::kError;
        if (!size.is_constant() || kind(size.type) != TypeKind::Int || size.constant.integer < 1 ||
            size.constant.integer > 1'000'000) {
            report(diag::ArraySize, ast()[ref.size].range);
            return types::kError;
        }
        count = size.constant.integer;
    }
    const Type array = types_.array(type, count);
    return ref.is_optional ? types_.optional(array) : array;
}

void Checker::define_struct(std::uint32_t module, Type type, const Decl& decl) {
    const syntax::Ast& tree = *modules_[module].ast;
    if (types_.struct_of(type).slots != 0) return;
    std::vector<Member> members;
    std::unordered_set<std::string_view> names;
    for (const syntax::DeclId id : tree.decls(decl.members)) {
        const Decl& field = tree[id];
        const std::string_view name = tree.text(field.name);
        if (!names.insert(name).second) {
            report(diag::DuplicateName, field.name_range).arg(name);
            continue;
        }
        // A struct that this one holds must be complete first.
        if (field.type.is_valid() && tree[field.type].array == syntax::TypeRef::Array::None) {
            const Name* found = find_global(module, tree.text(tree[field.type].name));
            if (found != nullptr && found->what == Name::What::Type &&
                kind(found->type) == TypeKind::Struct && types_.struct_of(found->type).slots == 0) {
                const bool is_open = std::find(open_structs_.begin(), open_structs_.end(),
                                               found->type) != open_structs_.end();
                if (found->type == type || is_open) {
                    report(diag::RecursiveStruct, field.range).arg(types_.struct_of(type).name);
                    members.push_back({std::string(name), types::kError, 0, module, {}, false, {}});
                    continue;
                }
                if (open_structs_.size() >= kMostLevels) {
                    report(diag::StructTooDeep, field.range)
                        .arg(types_.struct_of(type).name)
                        .arg(std::size_t{kMostLevels});
                    members.push_back({std::string(name), types::kError, 0, module, {}, false, {}});
                    continue;
                }
                open_structs_.push_back(type);
                define_struct(found->module, found->type,
                              (*modules_[found->module].ast)[syntax::DeclId{found->index}]);
                open_structs_.pop_back();
                module_ = module;
            }
        }
        module_ = module;
        Type member_type = resolve_type(field.type);
        if (member_type == types::kVoid) {
            report(diag::VoidValue, field.range);
            member_type = types::kError;
        }
        if (field.type.is_valid() && tree[field.type].is_reference) {
            report(diag::ReferencePlace, field.range);
        }
        const bool is_optional = field.type.is_valid() && tree[field.type].is_optional;
        DeclaredSymbol symbol = described(module, id, DeclaredSymbol::Kind::Member);
        symbol.type = member_type;
        symbol.owner = types_.struct_of(type).symbol;
        members.push_back({std::string(name), member_type, 0, module, field.value, is_optional,
                           record_.declare(std::move(symbol))});
    }
    if (members.empty()) {
        report(diag::EmptyStruct, decl.name_range).arg(types_.struct_of(type).name);
        members.push_back({"", types::kError, 0, module, {}, false, {}});
    }
    module_ = module;
    switch (types_.complete_struct(type, std::move(members))) {
        case TypeTable::Completed::Good: break;
        case TypeTable::Completed::TooManyRegisters:
            report(diag::FunctionTooLarge, decl.name_range).arg(types_.struct_of(type).name);
            break;
        case TypeTable::Completed::TooManyLevels:
            report(diag::StructTooDeep, decl.name_range)
                .arg(types_.struct_of(type).name)
                .arg(std::size_t{kMostLevels});
            break;
    }
}

void Checker::define_enum_values(std::uint32_t module, const Decl& decl) {
    const syntax::Ast& tree = *modules_[module].ast;
    const Name* entry = find_global(module, tree.text(decl.name));
    if (entry == nullptr || entry->what != Name::What::Type) return;
    std::int64_t next = 0;
    std::vector<std::int64_t> values;
    for (const syntax::DeclId id : tree.decls(decl.members)) {
        const Decl& member = tree[id];
        if (member.value.is_valid()) {
            const Value value = expression(member.value, types::kInt);
            if (value.is_constant() && kind(value.type) == TypeKind::Int) {
                next = value.constant.integer;
            } else if (!is_error(value)) {
                report(diag::NotConstant, tree[member.value].range)
                    .arg("the value of an enum member");
            }
        }
        values.push_back(next);
        const auto found = modules_[module].names.find(tree.text(member.name));
        if (found != modules_[module].names.end() && found->second.range == member.name_range) {
            found->second.member = next;
        }
        ++next;
    }
    types_.set_enum_values(entry->type, values);
}

void Checker::define_types(std::uint32_t module) {
    const syntax::Ast& tree = *modules_[module].ast;
    module_ = module;
    units_ = modules_[module].units;
    for (const syntax::DeclId id : tree.top) {
        const Decl& decl = tree[id];
        if (decl.kind == DeclKind::Enum) define_enum_values(module, decl);
        if (decl.kind != DeclKind::Struct) continue;
        const Name* found = find_global(module, tree.text(decl.name));
        if (found != nullptr && found->what == Name::What::Type &&
            found->range == decl.name_range) {
            define_struct(module, found->type, decl);
        }
        module_ = module;
    }
}

void Checker::define_signature(std::uint32_t index) {
    module_ = functions_[index].module;
    units_ = units_of(functions_[index]);
    const Decl decl = ast()[functions_[index].decl];
    FunctionDecl& function = functions_[index];
    function.result = decl.kind == DeclKind::Function && decl.type.is_valid()
                          ? resolve_type(decl.type)
                          : types::kVoid;
    record_.set_type(function.checked, function.result);
    if (decl.type.is_valid() && ast()[decl.type].is_reference) {
        report(diag::ReferencePlace, ast()[decl.type].range);
    }
    const bool is_curve = decl.kind == DeclKind::Curve;
    if (is_curve) function.result = function.is_limits ? types::kRange : types::kPoint;
    std::vector<syntax::DeclId> parameters(ast().decls(decl.parameters).begin(),
                                           ast().decls(decl.parameters).end());
    // The running parameter is one more of the function that gives the points.
    if (is_curve && !function.is_limits) parameters.push_back(ast().decls(decl.members)[0]);
    std::uint32_t next = 0;
    for (const syntax::DeclId id : parameters) {
        const Decl& parameter = ast()[id];
        ParameterDecl entry;
        entry.name = text(parameter.name);
        entry.range = parameter.name_range;
        entry.decl = id;
        entry.type = resolve_type(parameter.type);
        if (entry.type == types::kVoid) {
            report(diag::VoidValue, parameter.range);
            entry.type = types::kError;
        }
        entry.is_reference = parameter.type.is_valid() && ast()[parameter.type].is_reference;
        // `int n in 1..20` of a property: a range is not a default.
        if (decl.kind != DeclKind::Property) entry.initial = parameter.value;
        if (entry.is_reference && parameter.value.is_valid()) {
            report(diag::ReferenceDefault, parameter.range).arg(entry.name);
            entry.initial = {};
        }
        if (entry.is_reference && decl.kind == DeclKind::Program) {
            report(diag::ProgramParameter, parameter.range).arg(entry.name);
        }
        entry.may_be_unset = parameter.type.is_valid() && ast()[parameter.type].is_optional &&
                             kind(entry.type) == TypeKind::Struct;
        entry.is_required =
            !entry.initial.is_valid() && !type_info(entry.type).is_optional && !entry.may_be_unset;
        entry.slots = entry.is_reference ? 1 : type_info(entry.type).slots;
        entry.reg = static_cast<Reg>(next);
        next += entry.slots;
        declare_parameter(function, entry);
        function.parameters.push_back(entry);
    }
    if (function.parameters.size() > 32) {
        report(diag::TooManyParameters, decl.name_range).arg(function.name);
        function.parameters.resize(32);
    }
    // Reported where the body is checked, which finds no room for them.
    function.parameter_slots = static_cast<std::uint16_t>(std::min(next, kMostRegisters + 1));
}

/// Both functions of a curve have its parameters.
void Checker::declare_parameter(const FunctionDecl& function, ParameterDecl& parameter) {
    const SymbolId known = checked_.files[module_].declarations[parameter.decl.index];
    if (known.is_valid()) {
        parameter.checked = known;
        return;
    }
    DeclaredSymbol symbol = described(module_, parameter.decl, DeclaredSymbol::Kind::Parameter);
    symbol.scope = ast()[function.decl].range;
    symbol.type = parameter.type;
    symbol.owner = function.checked;
    parameter.checked = record_.declare(std::move(symbol));
}

void Checker::check_global(std::uint32_t index, bool on_demand) {
    GlobalVariable& global = globals_[index];
    if (global.state == GlobalVariable::State::Done) return;
    const syntax::Ast& tree = *modules_[global.module].ast;
    const Decl& decl = tree[global.decl];
    if (global.state == GlobalVariable::State::Checking) {
        report(diag::CircularConstant, decl.name_range).arg(tree.text(decl.name));
        global.state = GlobalVariable::State::Done;  // reported once
        return;
    }
    global.state = GlobalVariable::State::Checking;
    const Finding finding(*this);
    const std::uint32_t module = std::exchange(module_, global.module);
    const Units units = std::exchange(units_, modules_[global.module].units);
    const SourceRange location = emit_.location();
    emit_.set_location(decl.range);

    Symbol symbol;
    symbol.name = tree.text(decl.name);
    symbol.range = decl.name_range;
    symbol.decl = global.decl;
    symbol.checked = global.symbol.checked;
    symbol.is_const = decl.is_const;
    symbol.type = decl.type.is_valid() ? resolve_type(decl.type) : types::kError;
    if (decl.is_const && !decl.value.is_valid())
        report(diag::ConstWithoutValue, decl.name_range).arg(symbol.name);
    const Reg mark = emit_.mark();
    Value value = error_value();
    const bool is_body = decl.kind == DeclKind::Contour;
    if (is_body) {
        symbol.type = types::kContour;
        value = in_registers(types::kContour, emit_.take(1));
        value.is_fresh = true;
        contour_body(decl, value.reg);
    } else if (decl.value.is_valid()) {
        value = expression(decl.value, symbol.type);
        if (decl.type.is_valid()) {
            value = convert(value, symbol.type, tree[decl.value].range, symbol.name);
        } else {
            symbol.type = value.type;
            if (symbol.type == types::kVoid) {
                report(diag::VoidValue, tree[decl.value].range);
                symbol.type = types::kError;
            }
        }
    }
    if (decl.is_const && value.is_constant()) {
        symbol.storage = Symbol::Storage::Constant;
        symbol.constant = value;
    } else {
        if (on_demand && !is_error(value)) {
            report(diag::UsedBeforeDefinition, decl.name_range).arg(symbol.name);
        }
        symbol.storage = Symbol::Storage::Global;
        symbol.global = code_->globals;
        const std::uint16_t slots = type_info(symbol.type).slots;
        const bool had_room = code_->globals <= kMostGlobals;
        code_->globals += slots;
        if (had_room && code_->globals > kMostGlobals)
            report(diag::GlobalsTooLarge, symbol.range).arg(std::size_t{kMostGlobals});
        symbol.may_be_unset = !decl.value.is_valid() && !is_body;
        Reg reg = 0;
        if (decl.value.is_valid() || is_body) {
            reg = in_register(value);
            if (value.is_variable && types_.holds_array(symbol.type)) {
                const Reg copy = emit_.take(slots);
                copy_value(value, copy);
                reg = copy;
            }
        } else {
            reg = emit_.take(slots);
            if (is_optional_type(decl)) emit_unset(symbol.type, reg);
            else emit_initial(symbol.type, reg);
        }
        if (slots > 0) emit_.emit_pair(OpCode::StoreGlobal, reg, 0, slots, symbol.global);
    }
    report_overflow(symbol.name, symbol.range);
    emit_.release_to(mark);
    emit_.set_location(location);
    module_ = module;
    units_ = units;
    record_.set_type(symbol.checked, symbol.type);
    globals_[index].symbol = symbol;
    globals_[index].state = GlobalVariable::State::Done;
}

void Checker::bind_parameters(const FunctionDecl& function) {
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
        if (type_info(parameter.type).is_optional) symbol.givenness = Givenness::Perhaps;
        const Found same = find(parameter.name);
        if (same.symbol >= 0)
            symbols_[static_cast<std::size_t>(same.symbol)].is_read = true;  // reported once
        add_symbol(symbol);
    }
}

/// The prologue: each default is evaluated if its argument was not given. A default may use the
/// parameters before it.
void Checker::check_defaults(const FunctionDecl& function) {
    for (std::size_t i = function.parameters.size(); i-- > 0;)
        visible_[function.parameters[i].name].pop_back();
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const ParameterDecl parameter = function.parameters[i];
        const auto show = [&] { visible_[parameter.name].push_back(static_cast<std::int32_t>(i)); };
        if (parameter.is_required) {
            show();
            continue;
        }
        defaults_from_ = i;
        Label skip;
        emit_.set_location(parameter.range);
        emit_.jump(OpCode::SkipIfGiven, skip, 0, 0, static_cast<unsigned>(i));
        const Reg mark = emit_.mark();
        if (!parameter.initial.is_valid()) {
            emit_unset(parameter.type, parameter.reg);
        } else {
            emit_.set_location(ast()[parameter.initial].range);
            Value value = expression(parameter.initial, parameter.type);
            // `length initial = position.z`: a default that is not given itself leaves the
            // parameter not given; reading it is the mistake.
            if (type_info(value.type).is_optional && !type_info(parameter.type).is_optional &&
                type_info(parameter.type).kind == type_info(value.type).kind) {
                symbols_[i].may_be_unset = true;
                symbols_[i].givenness = Givenness::Perhaps;
                symbols_[i].unset_name = sources_.text(ast()[parameter.initial].range);
                value.type = types_.given(value.type);
            }
            value = convert(value, parameter.type, ast()[parameter.initial].range, parameter.name);
            if (!is_error(value)) copy_value(value, parameter.reg);
        }
        emit_.release_to(mark);
        emit_.bind(skip);
        show();
    }
    defaults_from_ = kNoDefault;
}

void Checker::check_function(std::uint32_t index) {
    const FunctionDecl function = functions_[index];
    module_ = function.module;
    units_ = units_of(function);
    const Decl decl = ast()[function.decl];
    function_ = &function;
    emit_.begin_function();
    forget_symbols(0);
    loops_.clear();
    scope_begin_ = 0;
    scope_end_ = decl.range.end;
    with_depth_ = 0;
    loop_depth_ = 0;
    current_native_ = native_cycle(function);

    FunctionCode& entry = code_->functions[index + 1];
    entry.entry = emit_.here();
    emit_.take(std::max<unsigned>(function.parameter_slots, type_info(function.result).slots));
    emit_.release_to(function.parameter_slots);
    bind_parameters(function);
    if (function.kind == DeclKind::Property) property_ranges(index);
    check_defaults(function);
    code_->functions[index + 1].body = emit_.here();
    native_pending_ = current_native_.has_value();
    if (decl.kind == DeclKind::Curve) {
        curve_body(function, decl);
        FunctionCode& curve = code_->functions[index + 1];
        curve.end = emit_.here();
        curve.registers = emit_.registers_used();
        // The function of the points has all parameters of that of the limits, one more and three
        // coordinates: where these find no room it reports it for both.
        constexpr std::uint32_t kMoreOfPoints = 4;
        if (!function.is_limits || function.parameter_slots + kMoreOfPoints <= kMostRegisters)
            report_overflow(function.name, function.range);
        function_ = nullptr;
        return;
    }
    has_preserves_ = decl.preserves.count > 0;
    if (has_preserves_) {
        emit_.set_location(decl.range);
        ModalMask mask = words_mask(ast().word_run(decl.preserves), true);
        emit_.emit_pair(OpCode::EnterPreserves, 0, 0, 0, mask);
        code_->functions[index + 1].needs = preserved_members(decl);
    }
    Completion completion = Completion::Normal;
    if (decl.body.is_valid()) {
        const syntax::Stmt body = ast()[decl.body];
        completion = body.kind == syntax::StmtKind::Block ? block(body.statements, body.range)
                                                          : statement(decl.body);
    }
    emit_native_cycle();
    const SourceRange end{decl.range.file, decl.range.end > 0 ? decl.range.end - 1 : 0,
                          decl.range.end};
    emit_.set_location(end);
    if (completion == Completion::Normal) {
        if (function.result != types::kVoid && kind(function.result) != TypeKind::Error)
            report_missing_return(function, decl, end);
        leave_function(end);
        emit_.emit(OpCode::Return, 0, 0, 0);
    }
    if (has_preserves_) check_preserves(function, decl);
    report_unused_parameters();

    FunctionCode& done = code_->functions[index + 1];
    done.end = emit_.here();
    done.registers = emit_.registers_used();
    report_overflow(function.name, function.range);
    function_ = nullptr;
}

void Checker::report_missing_return(const FunctionDecl& function, const Decl& decl,
                                    const SourceRange& end) {
    // A statement that could not be read may have been the `return`.
    const bool is_broken = std::ranges::any_of(ast().statements, [&](const syntax::Stmt& other) {
        return other.kind == syntax::StmtKind::Invalid && other.range.begin >= decl.range.begin &&
               other.range.end <= decl.range.end;
    });
    if (is_broken) return;
    report(diag::MissingReturn, function.range)
        .arg(function.name)
        .arg(type_name(function.result))
        .note(end, "the end is reached here without a `return`");
}

/// Reports it if what was emitted needs more registers than there are.
void Checker::report_overflow(std::string_view name, const SourceRange& range) {
    if (!emit_.has_overflowed()) return;
    emit_.forget_overflow();
    report(diag::FunctionTooLarge, range).arg(name);
}

void Checker::report_unused_parameters() {
    if (function_->module != 0) return;  // a library's own matter
    if (ast().has_errors) return;        // what is missing may have used them
    for (const Symbol& symbol : symbols_) {
        if (!symbol.is_parameter || symbol.is_read || symbol.name.empty()) continue;
        report(diag::UnusedParameter, symbol.range).arg(symbol.name);
    }
}

ParameterInfo Checker::describe_parameter(const ParameterDecl& parameter) {
    ParameterInfo info;
    info.name = parameter.name;
    info.type_name = type_name(parameter.type);
    const TypeInfo& type = type_info(parameter.type);
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
    if (info.kind == K::Contour) info.layout = layout_constant(type.element);
    info.quantity = type.quantity;
    info.is_optional = type.is_optional;
    info.has_default = !parameter.is_required;
    info.slot = parameter.reg;
    info.slots = parameter.slots;
    info.enumeration = type.kind == TypeKind::Enum ? type.definition : 0;
    info.range = parameter.range;
    return info;
}

void Checker::export_enums() {
    for (std::uint32_t i = 0; i < types_.enum_count(); ++i) {
        const EnumInfo& info = types_.enum_at(i);
        code_->enums.push_back({info.name, info.members});
    }
}

}  // namespace kadr::sema
