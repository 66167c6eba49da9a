// text.cpp — strings with values in them, and the tables of constants.
#include <charconv>

#include "base/diagnostics/sema.h"
#include "sema/checker.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;

std::uint32_t Checker::text_constant(std::string_view text) {
    const auto [found, is_new] =
        text_index_.try_emplace(std::string(text), static_cast<std::uint32_t>(code_->texts.size()));
    if (is_new) code_->texts.emplace_back(text);
    return found->second;
}

std::uint32_t Checker::layout_constant(Type type) {
    const auto known = layout_index_.find(type.index);
    if (known != layout_index_.end()) return known->second;
    ElementLayout layout;
    layout.slots = types_.layout(type);
    layout.nested.resize(layout.slots.size(), 0);
    const auto fill = [&](auto&& self, Type inner, std::size_t at) -> void {
        const TypeInfo info = type_info(inner);
        if (info.kind == TypeKind::Array) {
            // A struct that holds an array of itself has one layout, known by its type.
            layout.nested[at] = layout_constant(info.element);
        } else if (info.kind == TypeKind::Struct) {
            for (const Member& member : types_.struct_of(inner).members) {
                self(self, member.type, at + member.offset);
            }
        }
    };
    const auto index = static_cast<std::uint32_t>(code_->layouts.size());
    layout_index_[type.index] = index;
    code_->layouts.emplace_back();
    fill(fill, type, 0);
    code_->layouts[index] = std::move(layout);
    return index;
}

Done Checker::read_format(const Value& value, std::string_view format, const SourceRange& range,
                          FormatPiece& piece) {
    const TypeInfo info = type_info(types_.given(value.type));
    using K = FormatPiece::Kind;
    switch (info.kind) {
        case TypeKind::Bool: piece.kind = K::Bool; break;
        case TypeKind::Int: piece.kind = K::Integer; break;
        case TypeKind::Real:
            piece.kind = K::Number;
            set_factor(info.quantity, piece);
            break;
        case TypeKind::Feed:
            piece.kind = K::Feed;
            set_factor(kFeedPerTime, piece);
            break;
        case TypeKind::Speed:
            piece.kind = K::Speed;
            set_factor(kSpindleSpeed, piece);
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
            report(diag::NotPrintable, range).arg(type_name(value.type));
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
        add_unit(value.type, " ", piece);
        ++at;
    }
    const bool is_number = piece.kind == K::Integer || piece.kind == K::Number ||
                           piece.kind == K::Feed || piece.kind == K::Speed;
    if (!is_good || at != end ||
        (!is_number && (piece.decimals >= 0 || piece.zeros || piece.plus))) {
        report(diag::BadFormat, range).arg(format).arg(type_name(value.type));
        return kFailed;
    }
    return kDone;
}

/// The library speaks in the units of the program that it serves.
void Checker::set_factor(Quantity quantity, FormatPiece& piece) const {
    piece.scale.factor = 1.0 / bare_factor(quantity, units_);
    piece.serves_inches = is_library(module_);
    if (piece.serves_inches) piece.inch_scale.factor = 1.0 / bare_factor(quantity, Units::Inch);
}

void Checker::add_unit(Type type, std::string_view between, FormatPiece& piece) {
    add_unit(type, between, units_, piece.scale);
    if (piece.serves_inches) add_unit(type, between, Units::Inch, piece.inch_scale);
}

void Checker::add_unit(Type type, std::string_view between, Units units,
                       FormatPiece::Scale& scale) {
    const auto add = [&](Quantity quantity, std::string& unit) {
        unit = unit_text(quantity, units);
        if (!unit.empty()) unit.insert(0, between);
    };
    const TypeInfo info = type_info(types_.given(type));
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

Value Checker::string(ExprId id, Reg hint) {
    const Expr& expr = ast()[id];
    const auto parts = ast().exprs(expr.list);
    if (parts.empty()) return constant_text(text(expr.text));
    FormatPattern pattern;
    const Reg mark = emit_.mark();
    std::vector<Value> values;
    // The values come to stand one behind the other.
    std::size_t holes = 0;
    for (const ExprId part : parts) {
        if (ast()[part].kind != ExprKind::String || ast()[part].list.count > 0) ++holes;
    }
    if (holes == 0) {
        std::string all;
        for (const ExprId part : parts) all += text(ast()[part].text);
        return constant_text(all);
    }
    const Reg target = emit_.take(1);
    const Reg first = emit_.take(static_cast<unsigned>(holes));
    Reg next = first;
    bool is_good = true;
    for (const ExprId part : parts) {
        const Expr& piece_expr = ast()[part];
        FormatPiece piece;
        if (piece_expr.kind == ExprKind::String && piece_expr.list.count == 0) {
            piece.text = text(piece_expr.text);
            pattern.push_back(std::move(piece));
            continue;
        }
        const bool is_format = piece_expr.kind == ExprKind::Format;
        const ExprId inner = is_format ? piece_expr.child[0] : part;
        const Reg above = emit_.mark();
        Value value = require_given(expression(inner), ast()[inner].range, {});
        const std::string_view format = is_format ? text(piece_expr.text) : std::string_view();
        if (is_error(value) || !read_format(value, format, piece_expr.range, piece)) {
            is_good = false;
        } else {
            copy_value(value, next);
            pattern.push_back(std::move(piece));
        }
        emit_.release_to(above);
        ++next;
    }
    if (!is_good) return error_value();
    emit_.set_location(expr.range);
    emit_.release_to(static_cast<Reg>(target + 1));
    const Reg reg = hint != kNoReg ? hint : target;
    if (hint != kNoReg) emit_.release_to(mark);
    emit_.emit_pair(OpCode::Format, reg, first, 0,
                    static_cast<std::int64_t>(code_->formats.size()));
    code_->formats.push_back(std::move(pattern));
    return in_registers(types::kString, reg);
}

Value Checker::text_of(const Value& value, const SourceRange& range) {
    if (is_error(value) || kind(value.type) == TypeKind::String) return value;
    FormatPiece piece;
    if (!read_format(value, {}, range, piece)) return error_value();
    const Reg from = in_register(value);
    const Reg reg = emit_.take(1);
    emit_.emit_pair(OpCode::Format, reg, from, 0, static_cast<std::int64_t>(code_->formats.size()));
    code_->formats.push_back({std::move(piece)});
    return in_registers(types::kString, reg);
}

// ---------------------------------------------------------------- values at the prompt

std::uint32_t Checker::shown_form(Type type, bool is_part) {
    const std::uint32_t key = type.index * 2u + (is_part ? 1u : 0u);
    const auto known = shown_index_.find(key);
    if (known != shown_index_.end()) return known->second;
    // A struct that holds an array of itself has one form: it is known before its parts are.
    const auto index = static_cast<std::uint32_t>(code_->shown_forms.size());
    shown_index_[key] = index;
    code_->shown_forms.emplace_back();
    ShownForm form;
    form.slot = types_.layout(type)[0];
    const TypeInfo info = type_info(type);
    if (info.kind == TypeKind::Struct) {
        form.kind = ShownForm::Kind::Members;
        for (const Member& member : std::vector<Member>(types_.struct_of(type).members))
            form.parts.push_back({member.name, member.offset, shown_form(member.type, true)});
    } else if (info.is_contour) {
        form.kind = ShownForm::Kind::Contour;
        form.parts.push_back({{}, 0, shown_form(types::kPoint, true)});
    } else if (info.kind == TypeKind::Array) {
        form.kind = ShownForm::Kind::List;
        form.parts.push_back({{}, 0, shown_form(info.element, true)});
    } else if (read_format(in_registers(type, 0), {}, emit_.location(), form.piece)) {
        // Inside of braces as a program has it: `{x: 10mm}`.
        add_unit(type, is_part ? "" : " ", form.piece);
    }
    code_->shown_forms[index] = std::move(form);
    return index;
}

void Checker::show(ExprId id) {
    const Expr& expr = ast()[id];
    const auto is_variable_part = [&] {
        const Expr& owner = ast()[expr.child[0]];
        if (owner.kind == ExprKind::Given) return false;
        const Found found = owner.kind == ExprKind::Name ? find(text(owner.text)) : Found{};
        return found.name == nullptr || found.name->what == Name::What::Variable;  // `kind.blind`
    };
    const bool is_path = expr.kind == ExprKind::Name || expr.kind == ExprKind::Index ||
                         (expr.kind == ExprKind::Member && is_variable_part());
    const Value value = is_path ? unchecked(id) : expression(id);
    if (is_error(value) || kind(value.type) == TypeKind::Void) return;
    emit_.emit_pair(OpCode::Show, in_register(value), 0, 0,
                    static_cast<std::int64_t>(shown_form(value.type, false)));
}

}  // namespace kadr::sema
