#include "sema/types.h"

#include <algorithm>
#include <utility>

#include "base/assert.h"

namespace kadr::sema {

TypeTable::TypeTable() {
    const auto add = [&](TypeKind kind, std::uint16_t slots) {
        TypeInfo info;
        info.kind = kind;
        info.slots = slots;
        types_.push_back(info);
    };
    const auto add_real = [&](Quantity quantity, bool is_optional) {
        TypeInfo info;
        info.kind = TypeKind::Real;
        info.quantity = quantity;
        info.is_optional = is_optional;
        types_.push_back(info);
    };
    add(TypeKind::Error, 1);
    add(TypeKind::Void, 0);
    add(TypeKind::Bool, 1);
    add(TypeKind::Int, 1);
    add_real(kNumber, false);
    add_real(kLength, false);
    add_real(kAngle, false);
    add_real(kTime, false);
    add(TypeKind::Feed, 1);
    add(TypeKind::Speed, 1);
    add(TypeKind::String, 1);
    add_real(kLength, true);
    add_real(kNumber, true);
    const auto triple = [](std::string name, Type type) {
        StructInfo info;
        info.name = std::move(name);
        for (std::uint16_t i = 0; i < 3; ++i) {
            info.members.push_back({std::string(1, "xyz"[i]), type, i, 0, {}, false, {}});
        }
        info.slots = 3;
        return info;
    };
    const Type point = add_struct(triple("point", types::kOptionalLength));
    const Type vector = add_struct(triple("vector", types::kOptionalReal));
    KADR_ASSERT(point == types::kPoint && vector == types::kVector, "built-in types moved");
    add(TypeKind::Range, 2);
    add(TypeKind::Execution, 1);
    StructInfo of_contour;
    of_contour.name = "element";
    const Type element = add_struct(std::move(of_contour));
    TypeInfo contour;
    contour.kind = TypeKind::Array;
    contour.element = element;
    contour.is_contour = true;
    types_.push_back(contour);
    complete_struct(element, {{"from", point, 0, 0, {}, false, {}},
                              {"to", point, 0, 0, {}, false, {}},
                              {"center", point, 0, 0, {}, false, {}},
                              {"radius", types::kOptionalLength, 0, 0, {}, false, {}},
                              {"sweep", types::kAngleType, 0, 0, {}, false, {}},
                              {"length", types::kLengthType, 0, 0, {}, false, {}},
                              {"is_arc", types::kBool, 0, 0, {}, false, {}},
                              {"is_diameter", types::kBool, 0, 0, {}, false, {}}});
    add_real(kLength, false);
    types_.back().is_diameter = true;
    KADR_ASSERT(element == types::kElement && types_.size() == types::kDiameter.index + 1u &&
                    (*this)[element].slots == kElementSlots,
                "built-in types moved");
    for (std::uint32_t i = 0; i < types_.size(); ++i) interned_.try_emplace(types_[i], i);
}

std::size_t TypeTable::Hash::operator()(const TypeInfo& info) const {
    // Exponents of a quantity are left out: types that differ in nothing else are few.
    std::size_t hash = static_cast<std::size_t>(info.kind);
    for (const std::uint64_t part :
         {std::uint64_t{info.element.index}, static_cast<std::uint64_t>(info.count),
          std::uint64_t{info.definition}, std::uint64_t{info.is_optional}})
        hash = (hash ^ part) * 0x9e3779b97f4a7c15u;
    return hash;
}

Type TypeTable::intern(const TypeInfo& info) {
    const auto [found, is_new] =
        interned_.try_emplace(info, static_cast<std::uint32_t>(types_.size()));
    if (is_new) types_.push_back(info);
    return {found->second};
}

Type TypeTable::real(Quantity quantity) {
    TypeInfo info;
    info.kind = TypeKind::Real;
    info.quantity = quantity;
    return intern(info);
}

Type TypeTable::family(TypeKind kind, Quantity extra) {
    TypeInfo info;
    info.kind = kind;
    info.quantity = extra;
    return intern(info);
}

void TypeTable::set_enum_values(Type type, const std::vector<std::int64_t>& values) {
    EnumInfo& info = enums_[(*this)[type].definition];
    for (std::size_t i = 0; i < info.members.size() && i < values.size(); ++i) {
        info.members[i].second = values[i];
    }
}

Type TypeTable::optional(Type type) {
    TypeInfo info = (*this)[type];
    // A point is not given when none of its components is.
    if (info.kind == TypeKind::Error || info.kind == TypeKind::Struct) return type;
    info.is_optional = true;
    return intern(info);
}

Type TypeTable::given(Type type) {
    TypeInfo info = (*this)[type];
    if (!info.is_optional) return type;
    info.is_optional = false;
    return intern(info);
}

Type TypeTable::array(Type element, std::int64_t count) {
    TypeInfo info;
    info.kind = TypeKind::Array;
    info.element = element;
    info.count = count;
    return intern(info);
}

Type TypeTable::add_struct(StructInfo info) {
    TypeInfo type;
    type.kind = TypeKind::Struct;
    type.definition = static_cast<std::uint32_t>(structs_.size());
    type.slots = info.slots;
    structs_.push_back(std::move(info));
    types_.push_back(type);
    return {static_cast<std::uint32_t>(types_.size() - 1)};
}

void TypeTable::set_symbol(Type type, SymbolId symbol) {
    const TypeInfo& info = (*this)[type];
    if (info.kind == TypeKind::Struct) structs_[info.definition].symbol = symbol;
    else enums_[info.definition].symbol = symbol;
}

void TypeTable::set_member_symbols(Type enumeration, std::vector<SymbolId> symbols) {
    enums_[(*this)[enumeration].definition].symbols = std::move(symbols);
}

Type TypeTable::add_enum(EnumInfo info) {
    TypeInfo type;
    type.kind = TypeKind::Enum;
    type.definition = static_cast<std::uint32_t>(enums_.size());
    enums_.push_back(std::move(info));
    types_.push_back(type);
    interned_.try_emplace(type, static_cast<std::uint32_t>(types_.size() - 1));
    return {static_cast<std::uint32_t>(types_.size() - 1)};
}

TypeTable::Completed TypeTable::complete_struct(Type type, std::vector<Member> members) {
    StructInfo& info = structs_[types_[type.index].definition];
    std::uint32_t slots = 0;
    std::uint32_t levels = 0;
    bool holds_too_large = false;
    for (Member& member : members) {
        member.offset = static_cast<std::uint16_t>(slots);
        slots += (*this)[member.type].slots;
        if (slots > kMostRegisters) break;
        info.holds_array |= holds_array(member.type);
        if ((*this)[member.type].kind != TypeKind::Struct) continue;
        levels = std::max(levels, struct_of(member.type).levels);
        holds_too_large |= struct_of(member.type).levels > kMostLevels;
    }
    const Completed completed = holds_too_large          ? Completed::Good
                                : slots > kMostRegisters ? Completed::TooManyRegisters
                                : levels >= kMostLevels  ? Completed::TooManyLevels
                                                         : Completed::Good;
    info.levels = levels + 1;
    if (holds_too_large || completed != Completed::Good) {
        // All in one register: nothing runs that comes from here. What holds it is not reported
        // again, which its levels show.
        for (Member& member : members) member.type = types::kError, member.offset = 0;
        slots = 1;
        info.levels = kMostLevels + 1;
        info.holds_array = false;
    }
    types_[type.index].slots = static_cast<std::uint16_t>(slots);
    info.members = std::move(members);
    info.slots = static_cast<std::uint16_t>(slots);
    return completed;
}

std::string TypeTable::name(Type type) const {
    const TypeInfo& info = (*this)[type];
    std::string text;
    switch (info.kind) {
        case TypeKind::Error: text += "?"; break;
        case TypeKind::Void: text += "void"; break;
        case TypeKind::Bool: text += "bool"; break;
        case TypeKind::Int: text += "int"; break;
        case TypeKind::Real:
            text += info.is_diameter            ? "diameter"
                    : info.quantity.is_number() ? "real"
                                                : describe(info.quantity);
            break;
        case TypeKind::Feed:
        case TypeKind::Speed:
            text += info.kind == TypeKind::Feed ? "feed" : "speed";
            if (!info.quantity.is_number()) text += " times " + describe(info.quantity);
            break;
        case TypeKind::String: text += "string"; break;
        case TypeKind::Enum: text += enums_[info.definition].name; break;
        case TypeKind::Struct: text += structs_[info.definition].name; break;
        case TypeKind::Array:
            if (info.is_contour) {
                text += "contour";
                break;
            }
            text += name(info.element);
            text += '[';
            if (info.count >= 0) text += std::to_string(info.count);
            text += ']';
            break;
        case TypeKind::Range: text += "range"; break;
        case TypeKind::Execution: text += "execution"; break;
    }
    if (info.is_optional) text += '?';
    return text;
}

std::vector<SlotKind> TypeTable::layout(Type type) const {
    const TypeInfo& info = (*this)[type];
    switch (info.kind) {
        case TypeKind::Void: return {};
        case TypeKind::Bool:
        case TypeKind::Int:
        case TypeKind::Execution:
        case TypeKind::Enum: return {SlotKind::Integer};
        case TypeKind::Error:
        case TypeKind::Real:
        case TypeKind::Feed:
        case TypeKind::Speed: return {SlotKind::Number};
        case TypeKind::String: return {SlotKind::Text};
        case TypeKind::Array: return {SlotKind::Array};
        case TypeKind::Range: return {SlotKind::Integer, SlotKind::Integer};
        case TypeKind::Struct: break;
    }
    std::vector<SlotKind> slots;
    for (const Member& member : structs_[info.definition].members) {
        const std::vector<SlotKind> inner = layout(member.type);
        slots.insert(slots.end(), inner.begin(), inner.end());
    }
    return slots;
}

bool TypeTable::holds_array(Type type) const {
    const TypeKind kind = (*this)[type].kind;
    return kind == TypeKind::Array || (kind == TypeKind::Struct && struct_of(type).holds_array);
}

bool TypeTable::is_numeric(Type type) const {
    const TypeKind kind = (*this)[type].kind;
    return kind == TypeKind::Int || kind == TypeKind::Real || kind == TypeKind::Feed ||
           kind == TypeKind::Speed;
}

}  // namespace kadr::sema
