// text.cpp — strings with values in them, and the tables of constants.
#include <charconv>

#include "base/diagnostics/sema.h"
#include "sema/checking.h"
#include "sema/expressions.h"
#include "sema/native_cycles.h"
#include "sema/optionals.h"
#include "sema/scope.h"
#include "sema/texts.h"
#include "sema/values.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;

namespace {

void set_factor(const Check& check, Quantity quantity, FormatPiece& piece);

}  // namespace

std::uint32_t text_constant(Check& check, std::string_view text) {
    const auto [found, is_new] = check.pools.texts.try_emplace(
        std::string(text), static_cast<std::uint32_t>(check.code->texts.size()));
    if (is_new) check.code->texts.emplace_back(text);
    return found->second;
}

std::uint32_t layout_constant(Check& check, Type type) {
    const auto known = check.pools.layouts.find(type.index);
    if (known != check.pools.layouts.end()) return known->second;
    ElementLayout layout;
    layout.slots = check.types.layout(type);
    layout.nested.resize(layout.slots.size(), 0);
    const auto fill = [&](auto&& self, Type inner, std::size_t at) -> void {
        const TypeInfo info = check.type_info(inner);
        if (info.kind == TypeKind::Array) {
            // A struct that holds an array of itself has one layout, known by its type.
            layout.nested[at] = layout_constant(check, info.element);
        } else if (info.kind == TypeKind::Struct) {
            for (const Member& member : check.types.struct_of(inner).members) {
                self(self, member.type, at + member.offset);
            }
        }
    };
    const auto index = static_cast<std::uint32_t>(check.code->layouts.size());
    check.pools.layouts[type.index] = index;
    check.code->layouts.emplace_back();
    fill(fill, type, 0);
    check.code->layouts[index] = std::move(layout);
    return index;
}

Done read_format(Check& check, const Value& value, std::string_view format,
                 const SourceRange& range, FormatPiece& piece) {
    const TypeInfo info = check.type_info(check.types.given(value.type));
    using K = FormatPiece::Kind;
    switch (info.kind) {
        case TypeKind::Bool: piece.kind = K::Bool; break;
        case TypeKind::Int: piece.kind = K::Integer; break;
        case TypeKind::Real:
            piece.kind = K::Number;
            set_factor(check, info.quantity, piece);
            break;
        case TypeKind::Feed:
            piece.kind = K::Feed;
            set_factor(check, kFeedPerTime, piece);
            break;
        case TypeKind::Speed:
            piece.kind = K::Speed;
            set_factor(check, kSpindleSpeed, piece);
            break;
        case TypeKind::String: piece.kind = K::Text; break;
        case TypeKind::Enum:
            piece.kind = K::Enum;
            piece.enumeration = info.definition;
            break;
        case TypeKind::Error: return kFailed;
        case TypeKind::Void:
        case TypeKind::Struct:
        case TypeKind::Array:
        case TypeKind::Range:
        case TypeKind::Execution:
            check.report(diag::NotPrintable, range).arg(check.type_name(value.type));
            return kFailed;
    }
    // [+][0][width][.decimals][u]
    const char* at = format.data();
    const char* end = at + format.size();
    bool is_good = true;
    if (at != end && *at == '+') {
        piece.plus = true;
        ++at;
    }
    if (at != end && *at == '0') {
        piece.zeros = true;
        ++at;
    }
    if (at != end && *at >= '0' && *at <= '9') {
        const auto read = std::from_chars(at, end, piece.width);
        is_good = read.ec == std::errc() && piece.width <= 64;
        at = read.ptr;
    }
    if (is_good && at != end && *at == '.') {
        const auto read = std::from_chars(at + 1, end, piece.decimals);
        is_good = read.ec == std::errc() && piece.decimals >= 0 && piece.decimals <= 9 &&
                  read.ptr != at + 1;
        at = read.ptr;
    }
    if (is_good && at != end && *at == 'u') {
        add_unit(check, value.type, " ", piece);
        ++at;
    }
    const bool is_number = piece.kind == K::Integer || piece.kind == K::Number ||
                           piece.kind == K::Feed || piece.kind == K::Speed;
    if (!is_good || at != end ||
        (!is_number && (piece.decimals >= 0 || piece.zeros || piece.plus))) {
        check.report(diag::BadFormat, range).arg(format).arg(check.type_name(value.type));
        return kFailed;
    }
    return kDone;
}

namespace {

/// The library speaks in the units of the program that it serves.
void set_factor(const Check& check, Quantity quantity, FormatPiece& piece) {
    piece.scale.factor = 1.0 / bare_factor(quantity, check.here.units);
    piece.serves_inches = is_library(check, check.here.module);
    if (piece.serves_inches) piece.inch_scale.factor = 1.0 / bare_factor(quantity, Units::Inch);
}

}  // namespace

void add_unit(Check& check, Type type, std::string_view between, FormatPiece& piece) {
    add_unit(check, type, between, check.here.units, piece.scale);
    if (piece.serves_inches) add_unit(check, type, between, Units::Inch, piece.inch_scale);
}

void add_unit(Check& check, Type type, std::string_view between, Units units,
              FormatPiece::Scale& scale) {
    const auto add = [&](Quantity quantity, std::string& unit) {
        unit = unit_text(quantity, units);
        if (!unit.empty()) unit.insert(0, between);
    };
    const TypeInfo info = check.type_info(check.types.given(type));
    if (info.kind == TypeKind::Real) add(info.quantity, scale.unit);
    if (info.kind == TypeKind::Feed) {
        add(kFeedPerTime, scale.unit);
        add(kFeedPerTurn, scale.second_unit);
    }
    if (info.kind == TypeKind::Speed) {
        add(kSpindleSpeed, scale.unit);
        scale.second_unit = std::string(between) + "m/min";
    }
}

Value string(Check& check, ExprId id, Reg hint) {
    const Expr& expr = check.ast()[id];
    const auto parts = check.ast().exprs(expr.list);
    if (parts.empty()) return constant_text(check, check.text(expr.text));
    FormatPattern pattern;
    const Reg mark = check.emit.mark();
    std::vector<Value> values;
    // The values come to stand one behind the other.
    std::size_t holes = 0;
    for (const ExprId part : parts) {
        if (check.ast()[part].kind != ExprKind::String || check.ast()[part].list.count > 0) ++holes;
    }
    if (holes == 0) {
        std::string all;
        for (const ExprId part : parts) all += check.text(check.ast()[part].text);
        return constant_text(check, all);
    }
    const Reg target = check.emit.take(1);
    const Reg first = check.emit.take(static_cast<unsigned>(holes));
    Reg next = first;
    bool is_good = true;
    for (const ExprId part : parts) {
        const Expr& piece_expr = check.ast()[part];
        FormatPiece piece;
        if (piece_expr.kind == ExprKind::String && piece_expr.list.count == 0) {
            piece.text = check.text(piece_expr.text);
            pattern.push_back(std::move(piece));
            continue;
        }
        const bool is_format = piece_expr.kind == ExprKind::Format;
        const ExprId inner = is_format ? piece_expr.child[0] : part;
        const Reg above = check.emit.mark();
        Value value = require_given(check, expression(check, inner), check.ast()[inner].range, {});
        const std::string_view format =
            is_format ? check.text(piece_expr.text) : std::string_view();
        if (check.is_error(value) || !read_format(check, value, format, piece_expr.range, piece)) {
            is_good = false;
        } else {
            copy_value(check, value, next);
            pattern.push_back(std::move(piece));
        }
        check.emit.release_to(above);
        ++next;
    }
    if (!is_good) return error_value();
    check.emit.set_location(expr.range);
    check.emit.release_to(static_cast<Reg>(target + 1));
    const Reg reg = hint != kNoReg ? hint : target;
    if (hint != kNoReg) check.emit.release_to(mark);
    check.emit.emit_pair(OpCode::Format, reg, first, 0,
                         static_cast<std::int64_t>(check.code->formats.size()));
    check.code->formats.push_back(std::move(pattern));
    return in_registers(types::kString, reg);
}

Value text_of(Check& check, const Value& value, const SourceRange& range) {
    if (check.is_error(value) || check.kind(value.type) == TypeKind::String) return value;
    FormatPiece piece;
    if (!read_format(check, value, {}, range, piece)) return error_value();
    const Reg from = in_register(check, value);
    const Reg reg = check.emit.take(1);
    check.emit.emit_pair(OpCode::Format, reg, from, 0,
                         static_cast<std::int64_t>(check.code->formats.size()));
    check.code->formats.push_back({std::move(piece)});
    return in_registers(types::kString, reg);
}

// ---------------------------------------------------------------- values at the prompt

std::uint32_t shown_form(Check& check, Type type, bool is_part) {
    const bool is_inch = check.here.units == Units::Inch;
    const std::uint32_t key = type.index * 4u + (is_part ? 2u : 0u) + (is_inch ? 1u : 0u);
    const auto known = check.pools.showns.find(key);
    if (known != check.pools.showns.end()) return known->second;
    // A struct that holds an array of itself has one form: it is known before its parts are.
    const auto index = static_cast<std::uint32_t>(check.code->shown_forms.size());
    check.pools.showns[key] = index;
    check.code->shown_forms.emplace_back();
    ShownForm form;
    if (const std::vector<SlotKind> slots = check.types.layout(type); !slots.empty())
        form.slot = slots[0];
    form.type = check.type_name(type);
    const TypeInfo info = check.type_info(type);
    if (info.kind == TypeKind::Struct) {
        form.kind = ShownForm::Kind::Members;
        for (const Member& member : std::vector<Member>(check.types.struct_of(type).members))
            form.parts.push_back(
                {member.name, member.offset, shown_form(check, member.type, true)});
    } else if (info.is_contour) {
        form.kind = ShownForm::Kind::Contour;
        form.parts.push_back({{}, 0, shown_form(check, types::kPoint, true)});
    } else if (info.kind == TypeKind::Array) {
        form.kind = ShownForm::Kind::List;
        form.parts.push_back({{}, 0, shown_form(check, info.element, true)});
    } else if (read_format(check, in_registers(type, 0), {}, check.emit.location(), form.piece)) {
        // Inside of braces as a program has it: `{x: 10mm}`.
        add_unit(check, type, is_part ? "" : " ", form.piece);
    }
    check.code->shown_forms[index] = std::move(form);
    return index;
}

void show(Check& check, ExprId id) {
    const Expr& expr = check.ast()[id];
    const auto is_variable_part = [&] {
        const Expr& owner = check.ast()[expr.child[0]];
        if (owner.kind == ExprKind::Given) return false;
        const Found found =
            owner.kind == ExprKind::Name ? find(check, check.text(owner.text)) : Found{};
        return found.name == nullptr || found.name->what == Name::What::Variable;  // `kind.blind`
    };
    const bool is_path = expr.kind == ExprKind::Name || expr.kind == ExprKind::Index ||
                         (expr.kind == ExprKind::Member && is_variable_part());
    const Value value = is_path ? unchecked(check, id) : expression(check, id);
    if (check.is_error(value) || check.kind(value.type) == TypeKind::Void) return;
    check.emit.emit_pair(OpCode::Show, in_register(check, value), 0, 0,
                         static_cast<std::int64_t>(shown_form(check, value.type, false)));
}

}  // namespace kadr::sema
