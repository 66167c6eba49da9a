// convert.cpp — a value where it is used: bare numbers take the unit, quantities must fit.
#include "sema/convert.h"

#include <cmath>

#include "base/diagnostics/sema.h"
#include "sema/checking.h"
#include "sema/optionals.h"
#include "sema/origins.h"
#include "sema/values.h"

namespace kadr::sema {

namespace {

Done require_same_measure(Check& check, const Value& value, Type target, const SourceRange& range,
                          std::string_view what);
Value whole_number(Check& check, const Value& value, Type target, const SourceRange& range,
                   std::string_view what);
std::optional<Value> same_quantity(Check& check, const Value& value, Type target);
Value family_value(Check& check, const Value& value, Type target, bool second);

}  // namespace

namespace {

/// A subject in a message: "the value" as it is, what is code in backticks.
std::string subject(std::string_view what) {
    if (what.empty()) return "the value";
    return what.starts_with("the ") ? std::string(what) : quoted(what);
}

}  // namespace

void check_places(Check& check, Type from, Type to, const SourceRange& range,
                  std::string_view what) {
    check.report(diag::TypeMismatch, range)
        .arg(subject(what))
        .arg(check.type_name(to))
        .arg(check.type_name(from));
}

Value adapt_number(Check& check, const Value& value, Type target) {
    const TypeInfo& info = check.type_info(target);
    const Quantity quantity = info.kind == TypeKind::Feed    ? kFeedPerTime
                              : info.kind == TypeKind::Speed ? kSpindleSpeed
                                                             : info.quantity;
    const double factor = bare_factor(quantity, check.here.units);
    if (const std::optional<double> number = number_of(check, value)) {
        return constant_number(*number * factor, target);
    }
    const Value real = to_real(check, value);
    if (factor == 1.0) {
        Value same = real;
        same.type = target;
        return same;
    }
    const Reg reg = check.emit.take(1);
    check.emit.emit_number(OpCode::MulFK, reg, real.reg, factor);
    return in_registers(target, reg);
}

Value convert(Check& check, const Value& source, Type target, const SourceRange& range,
              std::string_view what) {
    if (check.is_error(source) || check.kind(target) == TypeKind::Error) return error_value();
    if (source.type == target) return source;
    if (check.kind(source.type) == TypeKind::Void) {
        check.report(diag::VoidValue, range);
        return error_value();
    }
    if (check.type_info(target).is_optional) {
        // Not given stays not given; a value is converted.
        Value plain = source;
        plain.type = check.types.given(source.type);
        Value converted = convert(check, plain, check.types.given(target), range, what);
        if (!check.is_error(converted)) converted.type = target;
        return converted;
    }
    const Value value = require_given(check, source, range, {});
    if (check.is_error(value) || value.type == target) return value;
    if (is_plain_number(check, value)) {
        if (check.kind(target) == TypeKind::Real && check.type_info(target).quantity.is_number())
            return to_real(check, value);
        if (check.kind(target) == TypeKind::Int)
            return whole_number(check, value, target, range, what);
        if (check.types.is_numeric(target)) {
            if (value.origin != Origin::Any) warn_of_origin(check, value, target, range);
            return adapt_number(check, value, target);
        }
    } else if (check.types.is_numeric(value.type) && check.types.is_numeric(target)) {
        if (!require_same_measure(check, value, target, range, what)) return error_value();
        if (const std::optional<Value> same = same_quantity(check, value, target)) return *same;
        check.report(diag::DimensionMismatch, range)
            .arg(subject(what))
            .arg(quantity_name(check, target))
            .arg(quantity_name(check, value.type));
        return error_value();
    }
    const TypeInfo from = check.type_info(value.type);
    const TypeInfo to = check.type_info(target);
    const bool is_array = from.kind == TypeKind::Array && to.kind == TypeKind::Array;
    if (is_array && from.element == to.element && from.is_contour == to.is_contour) {
        if (to.count < 0) return retyped(value, target);
        check.report(diag::ElementCount, range)
            .arg(to.count)
            .arg(from.count < 0 ? std::string("any number of") : std::to_string(from.count));
        return error_value();
    }
    check_places(check, value.type, target, range, what);
    return error_value();
}

namespace {

Done require_same_measure(Check& check, const Value& value, Type target, const SourceRange& range,
                          std::string_view what) {
    const TypeInfo& from = check.type_info(value.type);
    const TypeInfo& to = check.type_info(target);
    const bool are_lengths = from.kind == TypeKind::Real && to.kind == TypeKind::Real &&
                             from.quantity == kLength && to.quantity == kLength;
    if (!are_lengths || from.is_diameter == to.is_diameter || value.is_constant()) return kDone;
    const std::string text(check.sources.text(range));
    DiagnosticBuilder builder = check.report(diag::DiameterOrLength, range);
    builder.arg(subject(what)).arg(check.type_name(target)).arg(check.type_name(value.type));
    if (to.is_diameter) {
        builder.fix("if it is a diameter, say so: `diameter(" + text + ")`")
            .fix("if it is a radius: `diameter(2*" + text + ")`");
    } else {
        builder.fix("the radius is `" + text + "/2`")
            .fix("where the measure across is meant: `length(" + text + ")`");
    }
    return kFailed;
}

}  // namespace

bool is_plain_number(const Check& check, const Value& value) {
    return check.kind(value.type) == TypeKind::Int ||
           (check.kind(value.type) == TypeKind::Real &&
            check.type_info(value.type).quantity.is_number());
}

bool is_diameter(const Check& check, const Value& value) {
    return check.type_info(value.type).is_diameter;
}

std::string quantity_name(const Check& check, Type type) {
    switch (check.kind(type)) {
        case TypeKind::Int: return "number";
        case TypeKind::Real:
            if (!check.type_info(type).is_diameter) return describe(check.type_info(type).quantity);
            return check.type_name(type);
        default: return check.type_name(type);
    }
}

/// The same bits under another type.
Value retyped(Value value, Type type) {
    value.type = type;
    return value;
}

namespace {

Value whole_number(Check& check, const Value& value, Type target, const SourceRange& range,
                   std::string_view what) {
    if (check.kind(value.type) == TypeKind::Int) return retyped(value, target);
    const bool is_whole = value.is_constant() &&
                          value.constant.number == std::trunc(value.constant.number) &&
                          std::fabs(value.constant.number) < 9e18;
    if (is_whole) return constant_integer(static_cast<std::int64_t>(value.constant.number), target);
    check.report(diag::RealToInt, range)
        .arg(subject(what))
        .fix("say how to round: `trunc(…)`, `round(…)`, `floor(…)` or `ceil(…)`");
    return error_value();
}

bool is_family(TypeKind kind) { return kind == TypeKind::Feed || kind == TypeKind::Speed; }

/// What a feed or speed measures in its first or second form.
Quantity form_quantity(TypeKind family, int form) {
    if (family == TypeKind::Feed) return form == 0 ? kFeedPerTime : kFeedPerTurn;
    return form == 0 ? kSpindleSpeed : kFeedPerTime;
}

}  // namespace

std::optional<int> form_of(Quantity quantity, TypeKind family) {
    for (const int form : {0, 1}) {
        if (quantity == form_quantity(family, form)) return form;
    }
    // Revolutions are a number: 28m/min/(pi*d) turns a spindle, pi*d*3000rpm cuts.
    if (family == TypeKind::Speed && quantity == kPerTime) return 0;
    if (family == TypeKind::Speed && quantity == kSpindleSpeed * kLength) return 1;
    return std::nullopt;
}

namespace {

/// Between quantities: the same one, or a feed or speed in one of its two forms; a length is a feed
/// per revolution, as the pitch of a thread.
std::optional<Value> same_quantity(Check& check, const Value& value, Type target) {
    const TypeInfo from = check.type_info(value.type);
    const TypeInfo to = check.type_info(target);
    if (from.kind == TypeKind::Real && to.kind == TypeKind::Real) {
        const bool same = from.quantity == to.quantity ||
                          (to.quantity == kSpindleSpeed && from.quantity == kPerTime);
        return same ? std::optional(retyped(value, target)) : std::nullopt;
    }
    if (is_family(from.kind) && to.kind == TypeKind::Real) {
        for (const int form : {0, 1}) {
            if (form_quantity(from.kind, form) * from.quantity == to.quantity)
                return retyped(plain_form(check, value, form), target);
        }
        return std::nullopt;
    }
    if (!is_family(to.kind) || !to.quantity.is_number()) return std::nullopt;
    if (from.kind == TypeKind::Real) {
        if (const std::optional<int> form = form_of(from.quantity, to.kind))
            return family_value(check, value, target, *form == 1);
        if (to.kind == TypeKind::Feed && from.quantity == kLength)
            return family_value(check, value, target, true);
        return std::nullopt;
    }
    // A calculation with a variable: at most one of its forms makes the target. A speed by itself
    // is no feed, even if both are m/min.
    if (!is_family(from.kind) || (to.kind == TypeKind::Feed && from.quantity.is_number()))
        return std::nullopt;
    for (const int form : {0, 1}) {
        if (form_of(form_quantity(from.kind, form) * from.quantity, to.kind))
            return same_quantity(check, plain_form(check, value, form), target);
    }
    return std::nullopt;
}

}  // namespace

/// `vc/(pi*d)` of a `speed vc` as a speed of its own, for what is compared with or added to one.
bool settle(Check& check, Value& value) {
    const TypeInfo& info = check.type_info(value.type);
    if (!is_family(info.kind) || info.quantity.is_number()) return false;
    for (const Type target : {types::kSpeed, types::kFeed}) {
        if (std::optional<Value> settled = same_quantity(check, value, target)) {
            value = *settled;
            return true;
        }
    }
    return false;
}

namespace {

Value family_value(Check& check, const Value& value, Type target, bool second) {
    // The second form is told from the first by its size; see kSecondForm.
    const double factor = second ? kSecondForm : 1.0;
    if (value.is_constant()) return constant_number(value.constant.number * factor, target);
    Value result = value;
    result.type = target;
    if (!second) return result;
    const Reg reg = check.emit.take(1);
    check.emit.emit_number(OpCode::MulFK, reg, value.reg, factor);
    return in_registers(target, reg);
}

}  // namespace

Value plain_form(Check& check, const Value& value, int form) {
    const TypeKind family = check.kind(value.type);
    const Type type =
        check.types.real(form_quantity(family, form) * check.type_info(value.type).quantity);
    const Reg from = in_register(check, value);
    const Reg reg = check.emit.take(1);
    const unsigned flags = family == TypeKind::Speed ? kSpeedForm : 0;
    check.emit.emit(OpCode::FeedForm, reg, from, static_cast<unsigned>(form) | flags);
    return in_registers(type, reg);
}

Value to_real(Check& check, const Value& value) {
    if (check.kind(value.type) != TypeKind::Int) {
        if (value.is_constant()) return value;
        return value;
    }
    if (value.is_constant()) {
        return constant_number(static_cast<double>(value.constant.integer), types::kReal);
    }
    const Reg reg = check.emit.take(1);
    check.emit.emit(OpCode::IntToReal, reg, value.reg);
    return in_registers(types::kReal, reg);
}

}  // namespace kadr::sema
