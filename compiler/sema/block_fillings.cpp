#include "sema/block_fillings.h"

#include <algorithm>
#include <charconv>

#include "base/diagnostics/dialect.h"
#include "base/diagnostics/sema.h"
#include "nc/tables.h"
#include "sema/block_words.h"
#include "sema/checking.h"
#include "sema/convert.h"
#include "sema/expressions.h"
#include "sema/optionals.h"
#include "sema/values.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprKind;
using syntax::Word;

namespace {

Filling fill_computed(Check& check, const Value& source, const syntax::Word& word,
                      const nc::Hole& hole, bool has_unit, Reg reg);

Filling fill_feed(Check& check, const Value& value, const Word& word, Reg reg) {
    Filling filling;
    const TypeInfo info = check.type_info(value.type);
    filling.factor = check.here.units == Units::Inch ? 25.4 : 1.0;
    Value out = value;
    if (info.kind == TypeKind::Int || (info.kind == TypeKind::Real && info.quantity.is_number())) {
        filling.form = Filling::Form::FeedBare;
        out = to_real(check, value);
    } else if (info.kind == TypeKind::Feed && info.quantity.is_number()) {
        filling.form = Filling::Form::Feed;
    } else if (info.kind == TypeKind::Real && info.quantity == kFeedPerTime) {
        filling.form = Filling::Form::FeedPerTime;
    } else if (info.kind == TypeKind::Real &&
               (info.quantity == kFeedPerTurn || info.quantity == kLength)) {
        filling.form = Filling::Form::FeedPerTurn;
    } else if (info.kind == TypeKind::Real && info.quantity == kPerTime) {
        filling.form = Filling::Form::FeedInverse;
    } else {
        out = convert(check, value, types::kFeed, word.range, check.text(word.address));
        filling.form = Filling::Form::Feed;
    }
    if (!check.is_error(out)) copy_value(check, out, reg);
    return filling;
}

Filling fill_speed(Check& check, const Value& value, const Word& word, Reg reg) {
    Filling filling;
    const TypeInfo info = check.type_info(value.type);
    // Cutting speed is m/min, in an inch file ft/min.
    filling.factor = check.here.units == Units::Inch ? 0.3048 : 1.0;
    Value out = value;
    if (info.kind == TypeKind::Int || (info.kind == TypeKind::Real && info.quantity.is_number())) {
        filling.form = Filling::Form::SpeedBare;
        out = to_real(check, value);
    } else if (info.kind == TypeKind::Speed && info.quantity.is_number()) {
        filling.form = Filling::Form::Speed;
    } else if (info.kind == TypeKind::Real &&
               (info.quantity == kSpindleSpeed || info.quantity == kPerTime)) {
        filling.form = Filling::Form::SpeedPerTime;
    } else if (info.kind == TypeKind::Real && info.quantity == kFeedPerTime) {
        filling.form = Filling::Form::SpeedCutting;
    } else if (info.kind == TypeKind::Feed && info.quantity.is_number()) {
        filling.form = Filling::Form::SpeedCutting;
        out = plain_form(check, value, 0);
    } else {
        out = convert(check, value, types::kSpeed, word.range, check.text(word.address));
        filling.form = Filling::Form::Speed;
    }
    if (!check.is_error(out)) copy_value(check, out, reg);
    return filling;
}

}  // namespace

/// A value for a parameter or a slot whose unit in the block is fixed: mm, degrees, s, rpm.
Filling fill_value(Check& check, const Value& value, nc::Dimension dimension,
                   const SourceRange& range, std::string_view what, Reg reg) {
    Filling filling;
    if (check.is_error(value)) return filling;
    if (dimension == nc::Dimension::Count) {
        filling.form = Filling::Form::Count;
        const Value out = convert(check, value, types::kInt, range, what);
        if (!check.is_error(out)) copy_value(check, out, reg);
        return filling;
    }
    Type type = check.types.real(quantity_of(dimension));
    if (dimension == nc::Dimension::Speed) type = types::kSpeed;
    if (dimension == nc::Dimension::Feed) type = types::kFeed;
    Value out = convert(check, value, type, range, what);
    if (check.is_error(out)) return filling;
    if (dimension == nc::Dimension::Speed || dimension == nc::Dimension::Feed) {
        out = convert(check, out, check.types.real(quantity_of(dimension)), range, what);
        const double per_minute = 60;
        if (out.is_constant()) {
            out.constant.number *= per_minute;
        } else if (!check.is_error(out)) {
            const Reg scaled = check.emit.take(1);
            check.emit.emit_number(OpCode::MulFK, scaled, out.reg, per_minute);
            out.reg = scaled;
        }
    }
    if (!check.is_error(out)) copy_value(check, out, reg);
    return filling;
}

namespace {

Filling fill_literal(Check& check, const Word& word, const nc::Hole& hole, Reg reg) {
    Filling filling;
    const UnitInfo unit = unit_info(word.unit);
    const bool has_unit = word.unit != syntax::Unit::None;
    const bool is_slot = !hole.is_argument;
    if (has_unit || (is_slot && (hole.index == static_cast<std::uint8_t>(nc::Slot::Feed) ||
                                 hole.index == static_cast<std::uint8_t>(nc::Slot::Speed)))) {
        const Value value =
            has_unit ? constant_number(word.number * unit.factor, check.types.real(unit.quantity))
                     : constant_number(word.number, types::kReal);
        return fill_computed(check, value, word, hole, has_unit, reg);
    }
    if (hole.dimension == nc::Dimension::Count) {
        if (word.number != std::trunc(word.number))
            check.report(diag::WordNotWhole, word.range).arg(word_text(check, word));
        filling.form = Filling::Form::Count;
        check.emit.emit_integer(OpCode::LoadI, reg, 0,
                                static_cast<std::int64_t>(word.number * hole.factor + hole.offset));
        return filling;
    }
    const double units =
        hole.dimension == nc::Dimension::Length && check.here.units == Units::Inch ? 25.4 : 1.0;
    check.emit.emit_number(OpCode::LoadF, reg, 0,
                           (word.number * hole.factor + hole.offset) * units);
    return filling;
}

}  // namespace

/// Across a part measures only X: any other word with a diameter means half of it or is a mistake.
Done require_no_diameter(Check& check, const Value& value, const SourceRange& range,
                         std::string_view what) {
    if (!is_diameter(check, value)) return kDone;
    check.report(diag::DiameterPlace, range)
        .arg(what)
        .fix("half of it, the radius, is a length: `…/2`; the measure itself is `length(…)`");
    return kFailed;
}

namespace {

/// A value that the program computes, or one that carries a unit.
Filling fill_computed(Check& check, const Value& source, const Word& word, const nc::Hole& hole,
                      bool has_unit, Reg reg) {
    Filling filling;
    const SourceRange value_range =
        word.value.is_valid() ? check.ast()[word.value].range : word.range;
    const Value value = require_given(check, source, value_range, {});
    if (check.is_error(value)) return filling;
    const std::string_view what = check.text(word.address);
    if (!hole.is_argument && hole.index == static_cast<std::uint8_t>(nc::Slot::Feed)) {
        return fill_feed(check, value, word, reg);
    }
    if (!hole.is_argument && hole.index == static_cast<std::uint8_t>(nc::Slot::Speed)) {
        return fill_speed(check, value, word, reg);
    }
    const bool is_x = !hole.is_argument && hole.index == static_cast<std::uint8_t>(nc::Slot::X);
    if (!is_x && !require_no_diameter(check, value, value_range, what)) return filling;
    const TypeInfo info = check.type_info(value.type);
    if (info.kind == TypeKind::Bool) {
        convert(check, value, check.types.real(quantity_of(hole.dimension)), word.range, what);
        return filling;
    }
    const bool is_bare = !has_unit && (info.kind == TypeKind::Int ||
                                       (info.kind == TypeKind::Real && info.quantity.is_number()));
    // X takes it as it stands: the filling tells that it goes across.
    const Value measure = info.is_diameter ? retyped(value, types::kLengthType) : value;
    filling = fill_value(check, measure, hole.dimension, word.range, what, reg);
    const double factor = is_bare ? hole.factor : 1.0;
    const double units =
        hole.dimension == nc::Dimension::Length && check.here.units == Units::Inch ? 25.4 : 1.0;
    const double offset = hole.offset * (is_bare ? units : 1.0);
    if (filling.form == Filling::Form::Count) {
        if (offset != 0)
            check.emit.emit_integer(OpCode::AddIK, reg, reg, static_cast<std::int64_t>(offset));
        return filling;
    }
    if (factor != 1) check.emit.emit_number(OpCode::MulFK, reg, reg, factor);
    if (offset != 0) check.emit.emit_number(OpCode::AddFK, reg, reg, offset);
    if (is_x && info.is_diameter) filling.form = Filling::Form::Diameter;
    return filling;
}

/// What stands between the quotes of `T="3"`, if the control writes the word so.
std::optional<std::string_view> quoted_of(const syntax::Ast& ast, const Word& word,
                                          const nc::Dialect& dialect) {
    if (!word.value.is_valid()) return std::nullopt;
    const Expr& value = ast[word.value];
    if (value.kind != ExprKind::String || value.list.count != 0) return std::nullopt;
    const nc::DialectTables& tables = dialect.tables();
    const nc::AddressId id = tables.find_address(ast.text(word.address));
    if (id == nc::kNoAddress) return std::nullopt;
    const std::vector<nc::FormId>& forms = tables.addresses[id].forms;
    const bool has_quotes = std::ranges::any_of(forms, [&](const nc::FormId form) {
        return tables.forms[form].words[0].kind == nc::FormWord::Kind::Quoted;
    });
    return has_quotes ? std::optional(ast.text(value.text)) : std::nullopt;
}

/// A whole number of at most eight digits.
std::optional<std::int64_t> tool_number(std::string_view text) {
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_whole = error == std::errc() && end == text.data() + text.size();
    return is_whole && number >= 0 && text.size() <= 8 ? std::optional(number) : std::nullopt;
}

}  // namespace

Filling fill_word(Check& check, const Word& word, const nc::Hole& hole, Reg reg) {
    Filling filling;
    const auto quoted = quoted_of(check.ast(), word, check.dialect());
    if (quoted && hole.dimension == nc::Dimension::Count) {
        filling.form = Filling::Form::Count;
        const auto number = tool_number(*quoted);
        if (!number) {
            check.report(diag::ToolByName, check.ast()[word.value].range)
                .arg(check.text(word.address))
                .arg(*quoted)
                .fix("give the number that the tool has on the machine: `T=3`");
        }
        check.emit.emit_integer(OpCode::LoadI, reg, 0, number.value_or(0));
    } else if (word.form == Word::Form::Literal) {
        filling = fill_literal(check, word, hole, reg);
    } else {
        const Reg mark = check.emit.mark();
        // A number with a dimension of its own can be computed where it belongs.
        const Value value = expression(check, word.value, types::kError, reg);
        filling = fill_computed(check, value, word, hole, false, reg);
        check.emit.release_to(mark);
    }
    filling.is_argument = hole.is_argument;
    filling.index = hole.index;
    filling.invocation = hole.invocation;
    filling.parameter = hole.parameter;
    return filling;
}

}  // namespace kadr::sema
