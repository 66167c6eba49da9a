#include "sema/block_checks.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/diagnostics/dialect.h"
#include "base/diagnostics/sema.h"
#include "base/numbers.h"
#include "nc/frame_words.h"
#include "nc/tables.h"
#include "sema/block_words.h"
#include "sema/checking.h"

namespace kadr::sema {

using syntax::Word;

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

}  // namespace

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
        add(nc::has_fact(invocation.function, nc::Fact::Resolved), custom::kDrawn);
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

}  // namespace kadr::sema
