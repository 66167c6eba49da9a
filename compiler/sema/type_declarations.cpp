#include "sema/type_declarations.h"

#include <algorithm>
#include <unordered_set>

#include "base/diagnostics/sema.h"
#include "base/text.h"
#include "sema/checking.h"
#include "sema/declarations.h"
#include "sema/expressions.h"
#include "sema/scope.h"
#include "sema/unknown_names.h"
#include "syntax/habits.h"
#include "syntax/parse.h"

namespace kadr::sema {

using syntax::Decl;
using syntax::DeclKind;

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

void export_enums(Check& check) {
    for (std::uint32_t i = 0; i < check.types.enum_count(); ++i) {
        const EnumInfo& info = check.types.enum_at(i);
        check.code->enums.push_back({info.name, info.members});
    }
}

}  // namespace kadr::sema
