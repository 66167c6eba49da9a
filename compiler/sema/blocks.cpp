// blocks.cpp — NC blocks in the source: words become a plan with values to fill in.
#include "sema/blocks.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/diagnostics/dialect.h"
#include "base/diagnostics/sema.h"
#include "base/numbers.h"
#include "nc/effects.h"
#include "nc/frame_words.h"
#include "nc/lost_words.h"
#include "nc/tables.h"
#include "sema/checking.h"
#include "sema/convert.h"
#include "sema/cycle_blocks.h"
#include "sema/expressions.h"
#include "sema/optionals.h"
#include "sema/orienting.h"
#include "sema/skipped.h"
#include "sema/statements.h"
#include "sema/tests.h"
#include "sema/unknown_names.h"
#include "sema/values.h"
#include "syntax/parse.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Stmt;
using syntax::Word;

namespace {

std::optional<nc::BlockPlan> plan_source(Check& check, const nc::Dialect& dialect,
                                         std::span<const nc::SourceWord> source);
std::string hint_of_command(Check& check, std::string_view word);
std::string hint_of_call(Check& check, std::span<const nc::SourceWord> source);
Filling fill_computed(Check& check, const Value& source, const syntax::Word& word,
                      const nc::Hole& hole, bool has_unit, Reg reg);

}  // namespace

std::string word_text(const Check& check, const Word& word) {
    std::string all(check.ast().text(word.address));
    if (word.form == Word::Form::Literal) append_shortest(all, word.number);
    else if (word.form == Word::Form::Assigned) all += '=';
    else if (word.form == Word::Form::Increment) all += "+=";
    return all;
}

namespace {

/// Whether no word of the file before it is the same: what is lost is reported once, at its first
/// location.
bool is_first(const syntax::Ast& ast, const nc::LostWord& lost) {
    const auto is_same = [&](const Word& a, const Word& b) {
        return ast.text(a.address) == ast.text(b.address) && a.form == b.form &&
               a.number == b.number;
    };
    const std::vector<Word>& words = ast.words;
    const auto at = std::ranges::find(words, lost.range.begin,
                                      [](const Word& word) { return word.range.begin; });
    // `Q1` of `G05.1 Q1` tells it from `G05.1 Q0`.
    const bool is_pair = lost.text.find(' ') != std::string::npos && std::next(at) != words.end();
    for (auto before = words.begin(); before != at; ++before) {
        const bool is_it =
            is_same(*before, *at) && (!is_pair || is_same(*std::next(before), *std::next(at)));
        if (is_it && before->range.begin < lost.range.begin) return false;
    }
    return true;
}

}  // namespace

std::optional<nc::BlockPlan> plan_words(Check& check, std::span<const Word> words) {
    std::vector<nc::SourceWord> source;
    source.reserve(words.size());
    for (const Word& word : words) {
        nc::SourceWord entry;
        entry.address = check.text(word.address);
        entry.value = word.form == Word::Form::Bare      ? nc::SourceWord::Value::None
                      : word.form == Word::Form::Literal ? nc::SourceWord::Value::Literal
                                                         : nc::SourceWord::Value::Computed;
        entry.number = word.number;
        entry.mode = static_cast<nc::SourceWord::Mode>(word.mode);
        if (word.form == Word::Form::Increment) entry.mode = nc::SourceWord::Mode::Incremental;
        entry.range = word.range;
        source.push_back(entry);
    }
    const nc::Dialect& dialect = check.dialect();
    if (dialect.is_core()) return plan_source(check, dialect, source);
    for (const nc::LostWord& lost : nc::lost_words(dialect, source)) {
        if (is_first(check.ast(), lost))
            check.report(diag::SourceWordLost, lost.range).arg(lost.text).arg(lost.why);
    }
    return plan_source(check, dialect, source);
}

namespace {

/// The plan of a block; what the cycle of another control is here, is reported beside what is
/// wrong.
std::optional<nc::BlockPlan> plan_source(Check& check, const nc::Dialect& dialect,
                                         std::span<const nc::SourceWord> source) {
    DiagnosticList messages;
    std::optional<nc::BlockPlan> plan = nc::plan_block(dialect, source, messages);
    for (Diagnostic diagnostic : messages.all()) {
        std::string hint;
        if (diagnostic.row == &diag::BlockWordCodeUnknown) {
            hint = hint_of_cycle(check, diagnostic.arguments[0]);
            if (hint.empty()) hint = hint_of_command(check, diagnostic.arguments[0]);
        } else if (diagnostic.row == &diag::BlockWordUnused) {
            hint = hint_of_call(check, source);
        }
        if (!hint.empty()) diagnostic.fixes.push_back({{}, {}, hint});
        check.sink.take(std::move(diagnostic));
    }
    return plan;
}

}  // namespace

/// What to write for the cycle of another control, `G83` or `CYCLE81`; empty: it is none.
std::string hint_of_cycle(Check& check, std::string_view word) {
    if (!take_proposal(check)) return "";
    const auto cycle = check.loader.cycle_of_control(word);
    if (!cycle) return "";
    return "this cycle is `" + cycle->function + "(…)` for every control, `import " +
           cycle->module + ";` brings it in; `dialect " + cycle->dialect +
           ";` at the head of the file takes " + quoted(word);
}

namespace {

/// What to write for a word of another control that begins no cycle, `G68` or `G65`; empty: no
/// control has it.
std::string hint_of_command(Check& check, std::string_view word) {
    if (!take_proposal(check)) return "";
    const auto command = check.loader.command_of_control(word);
    if (!command) return "";
    if (command->function.empty()) return syntax::kCallByName;
    return "this is `" + command->function + "(…)` for every control; `dialect " +
           command->dialect + ";` at the head of the file takes " + quoted(word);
}

/// `M98 P100`: to the common core an M function of the machine's builder, with a word too many.
std::string hint_of_call(Check& check, std::span<const nc::SourceWord> source) {
    for (const nc::SourceWord& word : source) {
        if (word.value != nc::SourceWord::Value::Literal || !take_proposal(check)) continue;
        std::string text(word.address);
        append_shortest(text, word.number);
        const auto command = check.loader.command_of_control(text);
        if (command && command->function.empty()) return syntax::kCallByName;
    }
    return "";
}

/// `M97 P1` in a source of a FANUC: beside a code of another kind P is no word of the modal cycle.
Done check_cycle_words(Check& check, const nc::BlockPlan& plan, std::span<const Word> words) {
    const nc::DialectTables& tables = check.dialect().tables();
    const auto functions = std::span(plan.block.functions).first(plan.block.function_count);
    const bool has_words = std::ranges::find(functions, nc::Function::CycleWords,
                                             &nc::Invocation::function) != functions.end();
    const auto kind_of = [&](const Word& word) {
        const nc::AddressId id = tables.find_address(check.text(word.address));
        return id == nc::kNoAddress ? nc::Address::Kind::Word : tables.addresses[id].kind;
    };
    const bool has_code = std::ranges::any_of(words, [&](const Word& word) {
        return kind_of(word) == nc::Address::Kind::Code && check.text(word.address) != "G";
    });
    const bool moves = (plan.block.given & (nc::kTargetSlots | nc::kArcSlots)) != 0 ||
                       std::ranges::any_of(plan.holes, [](const nc::Hole& hole) {
                           return !hole.is_argument && hole.index < kAxes;
                       });
    if (!has_words || !has_code || moves) return kDone;
    for (const Word& word : words) {
        if (kind_of(word) != nc::Address::Kind::Value) continue;
        check.report(diag::BlockWordUnused, word.range).arg(word_text(check, word));
    }
    return kFailed;
}

}  // namespace

void check_units_function(Check& check, nc::Function function, const SourceRange& range) {
    const bool is_inch = function == nc::Function::Inch;
    if (is_inch == (check.here.units == Units::Inch)) return;
    check.report(diag::UnitsWord, range)
        .arg(is_inch ? "inches" : "millimetres")
        .arg(is_inch ? "mm" : "inch")
        .fix(is_inch
                 ? "the file says its units at its head, `units inch;`, and one value wears its "
                   "own: `1.5in`"
                 : "the file says its units at its head, `units mm;`, and one value wears its "
                   "own: `40mm`");
}

namespace {

void check_units_words(Check& check, const nc::BlockPlan& plan, std::span<const Word> words) {
    for (std::size_t i = 0; i < plan.block.function_count; ++i) {
        const nc::Function function = plan.block.functions[i].function;
        if (function != nc::Function::Inch && function != nc::Function::Metric) continue;
        SourceRange range = words[0].range;
        for (const Word& word : words) {
            const bool is_units = check.text(word.address) == "G" &&
                                  (word.number == 20 || word.number == 21 || word.number == 70 ||
                                   word.number == 71 || word.number == 700 || word.number == 710);
            if (is_units) range = word.range;
        }
        check_units_function(check, function, range);
        if (function == nc::Function::Inch && check.here.units == Units::Inch &&
            plan.feed_stays_metric) {
            check.report(diag::SourceFeedMetric, range)
                .arg(check.sources.text(range))
                .fix("say the function that holds for feeds as well, `G700`");
        }
    }
}

}  // namespace

bool has_point(const Check& check, const Word& word) {
    const std::string_view written = check.sources.text(word.range);
    return written.find_first_of(".eE", check.text(word.address).size()) != std::string_view::npos;
}

namespace {

/// What a control reads, with its unit and without the noise of the factor: `0.0003 inch`.
std::string read_as(double number, const nc::Hole& hole, bool is_inch) {
    constexpr int kDigits = 12;  // a control has nine, and the factors are powers of ten
    std::array<char, 40> text{};
    // As 12345.678: a small number with an exponent would be no number of a control.
    const int decimals = kDigits - 1 - static_cast<int>(std::floor(std::log10(std::abs(number))));
    const auto written = std::to_chars(text.data(), text.data() + text.size(), number,
                                       std::chars_format::fixed, std::clamp(decimals, 0, kDigits));
    std::string out(text.data(), written.ptr);
    if (out.find('.') != std::string::npos) {
        out.erase(out.find_last_not_of('0') + 1);
        if (out.ends_with('.')) out.pop_back();
    }
    switch (hole.dimension) {
        case nc::Dimension::Length: return out + (is_inch ? " inch" : " mm");
        case nc::Dimension::Angle: return out + " deg";
        case nc::Dimension::Time: return out + " s";
        default: return out;
    }
}

Done check_points(Check& check, const nc::BlockPlan& plan, std::span<const Word> words) {
    const nc::Dialect& dialect = check.dialect();
    Done checked = kDone;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const Word& word = words[i];
        const bool is_plain = word.form == Word::Form::Literal && word.unit == syntax::Unit::None;
        if (!is_plain || word.number == 0 || has_point(check, word)) continue;
        const bool is_factor = std::ranges::any_of(plan.holes, [i](const nc::Hole& hole) {
            return hole.word == i && hole.dimension == nc::Dimension::Factor;
        });
        if (is_factor) continue;  // in thousandths, without a point
        const std::string_view address = check.text(word.address);
        const double one = nc::plain_number(dialect, address, check.here.units == Units::Inch).time;
        if (one == 1) continue;
        const auto hole = std::ranges::find(plan.holes, i, &nc::Hole::word);
        if (hole == plan.holes.end()) continue;  // `Q1` of `G05.1 Q1`: part of the code
        DiagnosticBuilder message = check.report(diag::SourceNoPoint, word.range);
        const std::string as_read =
            read_as(word.number * one, *hole, check.here.units == Units::Inch);
        message.arg(word_text(check, word)).arg(dialect.name()).arg(as_read);
        // Nobody means a hundredth by a whole number; `Q1000` may be both.
        constexpr double kLeastMeant = 0.1;
        std::string number(address);
        append_shortest(number, word.number * one);
        if (number.find('.') == std::string::npos) number += '.';
        if (word.number * one < kLeastMeant)
            message.fix(word.range, word_text(check, word) + '.', "write the point");
        else
            message.fix("write the point: `" + number + "` if " + as_read + " is meant, `" +
                        word_text(check, word) + ".` if not");
        checked = kFailed;
    }
    return checked;
}

std::uint32_t customs_of(const Check& check, const Plan& plan, std::span<const Word> words) {
    const nc::Dialect& dialect = check.dialect();
    std::uint32_t customs = 0;
    const auto add = [&](bool is_so, std::uint32_t bit) {
        if (is_so) customs |= bit;
    };
    bool changes_tool = false;
    for (const nc::Invocation& invocation : plan.functions) {
        const nc::Group group = nc::info(invocation.function).group;
        changes_tool |= invocation.function == nc::Function::ToolChange;
        add(group == nc::Group::CycleMode || group == nc::Group::CycleReturn, custom::kCycleWords);
        add(invocation.function == nc::Function::TapRigid, custom::kCycleWords);
        add(invocation.function == nc::Function::ToolVector, custom::kDirection);
        const bool is_offset = nc::has_fact(invocation.function, nc::Fact::CallsEdge);
        add(is_offset && dialect.is_core(), custom::kCoreOffsets);
    }
    // Its length acts with the change, if the block does not name another one.
    add(changes_tool && dialect.is_core() && (customs & custom::kCoreOffsets) == 0, custom::kEdges);
    if (dialect.is_core()) return customs;
    add(check.names.has_cycle_blocks(), custom::kPlaces);
    const auto differs = [&](auto nc::Rules::*rule) {
        constexpr nc::Rules kLanguage = nc::Rules::of_language();
        return dialect.rules().*rule != kLanguage.*rule;
    };
    using nc::Rules;
    add(differs(&Rules::incremental_frame), custom::kIncrementTravels);
    add(differs(&Rules::helix_feed_along_arc), custom::kFeedOfArc);
    add(differs(&Rules::feed_of_all_axes), custom::kFeedOfAxes);
    for (const nc::Invocation& invocation : plan.functions) {
        using nc::Function;
        add(differs(&Rules::rotation_is_innermost), custom::kFrameOrder);
        add(nc::has_fact(invocation.function, nc::Fact::AddsToFrame), custom::kFrameOfSource);
        add(differs(&Rules::shift_in_diameter) && nc::frame_x(invocation.function).has_value(),
            custom::kFrameDiameter);
        add(nc::info(invocation.function).group == nc::Group::FeedMode &&
                differs(&Rules::feed_deleted_on_mode_change),
            custom::kFeedDeleted);
        add(differs(&Rules::length_moves_alone) &&
                (nc::info(invocation.function).group == nc::Group::LengthComp ||
                 invocation.function == Function::LengthOffset),
            custom::kLengthMoves);
        const bool is_of_tool = invocation.function == Function::ToolChange ||
                                nc::has_fact(invocation.function, nc::Fact::CallsOffset) ||
                                nc::has_fact(invocation.function, nc::Fact::CallsEdge);
        add(is_of_tool, dialect.counts_offsets_by_tool() ? custom::kOffsetsByTool : custom::kEdges);
        switch (invocation.function) {
            case Function::Shift:
                add(differs(&Rules::shift_keeps_unnamed), custom::kShiftKeeps);
                break;
            case Function::Rotate:
                add(differs(&Rules::rotate_replaces), custom::kRotateReplaces);
                add(differs(&Rules::frame_center_at_tool), custom::kCenterAtTool);
                break;
            case Function::Mirror:
                add(differs(&Rules::mirror_replaces), custom::kMirrorReplaces);
                break;
            case Function::Scale:
                add(differs(&Rules::frame_center_at_tool), custom::kCenterAtTool);
                break;
            case Function::MachineCoordinates:
                add(differs(&Rules::machine_coordinates_rapid), custom::kMachineRapid);
                add(differs(&Rules::machine_coordinates_keep_length), custom::kMachineLength);
                break;
            case Function::ReferenceReturn: add(true, custom::kReference); break;
            case Function::ToolSelect:
                add(invocation.has(nc::parameter_of<Function::ToolSelect>("offset")),
                    custom::kStation);
                break;
            default: break;
        }
    }
    for (const Word& word : words) {
        const bool is_plain = word.form == Word::Form::Literal && word.unit == syntax::Unit::None;
        if (!is_plain || check.text(word.address) != "F" || has_point(check, word)) continue;
        add(nc::plain_number(dialect, "F", check.here.units == Units::Inch).revolution != 1,
            custom::kFeedCounts);
    }
    return customs;
}

/// Whole numbers that the planner has put into the block itself: `T1.5` is no tool.
void check_counts(Check& check, const nc::BlockPlan& plan, std::span<const Word> words) {
    for (std::size_t f = 0; f < plan.block.function_count; ++f) {
        const nc::Invocation& invocation = plan.block.functions[f];
        const auto parameters = nc::info(invocation.function).parameters;
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            if ((invocation.given >> i & 1u) == 0 ||
                parameters[i].dimension != nc::Dimension::Count)
                continue;
            const double value = plan.block.argument(invocation, i);
            if (value == std::trunc(value)) continue;
            for (const Word& word : words) {
                if (word.form != Word::Form::Literal || word.number == std::trunc(word.number))
                    continue;
                check.report(diag::WordNotWhole, word.range).arg(word_text(check, word));
                break;
            }
        }
    }
}

}  // namespace

// ---------------------------------------------------------------- values

namespace {

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

}  // namespace

// ---------------------------------------------------------------- plans

namespace {

void append_key(std::string& key, std::int64_t value) {
    key += std::to_string(value);
    key += ',';
}

/// Two plans with the same key are the same plan.
std::string key_of(const Plan& plan) {
    std::string key;
    for (const std::int64_t part :
         {std::int64_t(plan.motion), std::int64_t(plan.given), std::int64_t(plan.incremental),
          std::int64_t(plan.absolute), std::int64_t(plan.argument_count),
          std::int64_t(plan.skip_level), std::int64_t(plan.cycle), std::int64_t(plan.number),
          std::int64_t(plan.customs), std::int64_t(plan.planes)}) {
        append_key(key, part);
    }
    for (const nc::Invocation& invocation : plan.functions) {
        append_key(key, static_cast<std::int64_t>(invocation.function));
        append_key(key, invocation.first);
        append_key(key, invocation.given);
    }
    key += 'a';
    for (const auto& [place, value] : plan.arguments) {
        append_key(key, place);
        append_shortest(key, value);
    }
    key += 'v';
    for (const auto& [place, value] : plan.values) {
        append_key(key, place);
        append_shortest(key, value);
    }
    key += 'f';
    for (const Filling& filling : plan.fillings) {
        append_key(key, static_cast<std::int64_t>(filling.form));
        append_key(key, filling.is_argument);
        append_key(key, filling.index);
        append_key(key, filling.invocation);
        append_key(key, filling.parameter);
        append_shortest(key, filling.factor);
    }
    return key;
}

Plan compact(const nc::BlockPlan& source) {
    const nc::Block& block = source.block;
    Plan plan;
    plan.motion = block.motion;
    plan.given = block.given;
    plan.incremental = block.incremental;
    plan.absolute = block.absolute;
    plan.argument_count = block.argument_count;
    plan.skip_level = block.skip_level;
    plan.cycle = block.cycle;
    plan.number = block.number;
    plan.planes = source.planes;
    plan.functions.assign(block.functions.begin(), block.functions.begin() + block.function_count);
    nc::SlotMask holes = 0;
    for (const nc::Hole& hole : source.holes) {
        if (!hole.is_argument) holes |= nc::SlotMask{1} << hole.index;
    }
    for (const nc::Invocation& invocation : plan.functions) {
        for (unsigned i = 0; i < 32; ++i) {
            if ((invocation.given >> i & 1u) == 0) continue;
            const auto index = static_cast<std::uint8_t>(invocation.first + i);
            plan.arguments.emplace_back(index, block.arguments[index]);
        }
    }
    for (unsigned slot = 0; slot < nc::kSlots; ++slot) {
        const nc::SlotMask mask = nc::SlotMask{1} << slot;
        if ((block.given & mask) != 0 && (holes & mask) == 0) {
            plan.values.emplace_back(static_cast<std::uint8_t>(slot), block.values[slot]);
        }
    }
    return plan;
}

bool is_of_cycle(const nc::Block& block, const nc::Hole& hole) {
    return hole.is_argument && block.functions[hole.invocation].function == nc::Function::Cycle;
}

/// `ROT`, `SCALE` and `MIRROR` of some controls delete the frame before they make their own: that
/// is a block by itself.
bool deletes_frame(const Plan& plan, const nc::Invocation& invocation) {
    return invocation.function == nc::Function::Shift && plan.functions.size() > 1;
}

/// Takes functions without arguments out of a block, into one of their own. M5 and M9: controls
/// differ in whether these act before the motion or after it; in the language they act after it.
template <typename Asked>
Plan take_functions(Plan& plan, Asked is_asked) {
    Plan taken;
    taken.skip_level = plan.skip_level;
    taken.customs = plan.customs;
    for (std::size_t i = 0; i < plan.functions.size();) {
        if (!is_asked(plan.functions[i])) {
            ++i;
            continue;
        }
        taken.functions.push_back(plan.functions[i]);
        plan.functions.erase(plan.functions.begin() + static_cast<std::ptrdiff_t>(i));
        for (Filling& filling : plan.fillings) {
            if (filling.is_argument && filling.invocation > i) --filling.invocation;
        }
    }
    return taken;
}

std::uint32_t plan_constant(Check& check, Plan plan) {
    const auto [found, is_new] = check.pools.plans.try_emplace(
        key_of(plan), static_cast<std::uint32_t>(check.code->plans.size()));
    if (is_new) check.code->plans.push_back(std::move(plan));
    return found->second;
}

}  // namespace

void emit_plan(Check& check, Plan plan, Reg first, unsigned point, const SourceRange& range) {
    if (is_in_test(check) && check.here.contour_depth == 0) report_test_block(check, range);
    const std::uint32_t index = plan_constant(check, std::move(plan));
    check.record.note_plan(check.here.module, check.here.block, index);
    check.emit.emit_pair(OpCode::Emit, first, point, static_cast<unsigned>(check.here.loop_depth),
                         index, statement_id(check, range));
}

namespace {

/// The point behind the words. `Y=r sin(30)` has none: an operator was forgotten.
Value target_value(Check& check, ExprId point, std::span<const Word> words) {
    const SourceRange range = check.ast()[point].range;
    check.here.target = range;
    const Value value = expression(check, point, types::kPoint);
    check.here.target = {};
    const bool is_number =
        check.types.is_numeric(value.type) && check.kind(value.type) != TypeKind::Error;
    const bool is_behind_value = !words.empty() && words.back().form != Word::Form::Literal &&
                                 words.back().form != Word::Form::Bare;
    if (is_number && is_behind_value) {
        check.report(diag::OperatorMissing, range)
            .arg(check.sources.text(words.back().range))
            .arg(check.sources.text(range))
            .fix("`*` multiplies; a word of its own begins with its address");
        return error_value();
    }
    return convert(check, value, types::kPoint, range, "the target");
}

}  // namespace

void emit_words(Check& check, std::span<const Word> words, const BehindWords& behind,
                const SourceRange& range, std::int8_t skip_level, std::uint32_t customs) {
    const ExprId point = behind.point;
    const Reg mark = check.emit.mark();
    std::optional<nc::BlockPlan> planned;
    Plan plan;
    if (!words.empty()) {
        planned = plan_words(check, words);
        if (planned && !check_points(check, *planned, words)) planned.reset();
        if (!planned) {
            for (const Word& word : words) {
                if (word.value.is_valid()) expression(check, word.value);
            }
            check.emit.release_to(mark);
            return;
        }
        if (!check_cycle_words(check, *planned, words)) return;
        check_units_words(check, *planned, words);
        check_counts(check, *planned, words);
        // The arguments of a cycle stand behind the values of the block itself.
        std::stable_partition(
            planned->holes.begin(), planned->holes.end(),
            [&](const nc::Hole& hole) { return !is_of_cycle(planned->block, hole); });
        plan = compact(*planned);
        plan.customs = customs_of(check, plan, words) | customs;
        plan.skip_level = skip_level;
        if (skip_level >= 0) check_passed_text(check, plan, words);
    }
    const std::size_t holes = planned ? planned->holes.size() : 0;
    constexpr std::size_t kDirection = 3;
    const std::size_t values = holes + (behind.orient.is_valid() ? kDirection : 0);
    const Reg first = check.emit.take(std::max<unsigned>(1, static_cast<unsigned>(values)));
    for (std::size_t i = 0; i < holes; ++i) {
        const nc::Hole& hole = planned->holes[i];
        const Word& word = words[hole.word];
        check.emit.set_location(word.range);
        plan.fillings.push_back(fill_word(check, word, hole, static_cast<Reg>(first + i)));
    }
    unsigned point_register = 0;
    if (point.is_valid()) {
        const SourceRange point_range = check.ast()[point].range;
        const Value value = target_value(check, point, words);
        if (!check.is_error(value)) {
            point_register = in_register(check, value) + 1u;
            const auto is_linear = [](const Filling& f) { return !f.is_argument && f.index <= 2; };
            if (std::any_of(plan.fillings.begin(), plan.fillings.end(), is_linear)) {
                check.report(diag::TargetTwice, point_range);
            }
        }
    }
    if (behind.orient.is_valid()) {
        const Expr& orient = check.ast()[behind.orient];
        check.emit.set_location(orient.range);
        // A block without its direction is written as well: it deserves its own messages.
        const auto reg = static_cast<Reg>(first + holes);
        if (take_direction(check, orient, reg)) (void)add_direction(check, plan, orient.range);
    }
    check.emit.set_location(range);
    const std::optional<SourceCycle> cycle =
        planned ? take_cycle(check, plan, *planned, words) : std::nullopt;
    const auto is_target = [](const Filling& f) { return !f.is_argument && f.index < kAxes; };
    const bool moves = point_register != 0 || (plan.given & nc::kTargetSlots) != 0 ||
                       std::any_of(plan.fillings.begin(), plan.fillings.end(), is_target);
    const Plan deletion = take_functions(
        plan, [&](const nc::Invocation& invocation) { return deletes_frame(plan, invocation); });
    if (!deletion.functions.empty()) emit_plan(check, deletion, first, 0, range);
    Plan stops;
    if (moves) {
        stops = take_functions(plan, [](const nc::Invocation& invocation) {
            return nc::has_fact(invocation.function, nc::Fact::StopsMachine);
        });
    }
    // … unless the source is written for a control on which they act before.
    const nc::Dialect& dialect = check.dialect();
    const bool is_before =
        !dialect.is_core() && nc::time_of_stop(dialect.rules()) == nc::When::BeforeMotion;
    const bool has_stops = !stops.functions.empty();
    if (has_stops && !is_before) {
        // BehindWords what the program stops or ends with nothing acts: it comes last.
        const Plan ends = take_functions(plan, [](const nc::Invocation& invocation) {
            return nc::has_fact(invocation.function, nc::Fact::StopsProgram);
        });
        stops.functions.insert(stops.functions.end(), ends.functions.begin(), ends.functions.end());
    }
    if (has_stops && is_before) emit_plan(check, stops, first, 0, range);
    const std::size_t own_values = plan.fillings.size();
    emit_plan(check, std::move(plan), first, point_register, range);
    if (cycle) emit_cycle(check, *cycle, static_cast<Reg>(first + own_values), range);
    else if (check.names.has_cycle_blocks() && !dialect.is_core()) emit_run_cycle(check, range);
    if (has_stops && !is_before) emit_plan(check, std::move(stops), first, 0, range);
    check.emit.release_to(mark);
}

void words_statement(Check& check, const Stmt& stmt) {
    if (is_modal_call(check, check.ast().word_run(stmt.words))) return modal_call(check, stmt);
    if (const Word* times = repeats_of(check, check.ast().word_run(stmt.words)))
        return repeat_places(check, stmt, *times);
    emit_words(check, check.ast().word_run(stmt.words), behind_words(check, stmt), stmt.range,
               stmt.skip_level);
}

}  // namespace kadr::sema
