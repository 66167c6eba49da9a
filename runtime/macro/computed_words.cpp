// computed_words.cpp — words whose value, axis or code the program works out.
#include "macro/computed_words.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "macro/program_run.h"
#include "nc/control_words.h"

namespace kadr::macro {

using nc::Block;
using nc::Function;

namespace {

/// Whether a call of the block has no parameter that names an axis.
bool takes_no_axis(const Block& block) {
    const auto names_axis = [](const nc::Parameter& parameter) {
        return parameter.name.starts_with("axis");
    };
    for (const nc::Invocation& invocation :
         std::span(block.functions).first(block.function_count)) {
        const auto parameters = nc::info(invocation.function).parameters;
        if (invocation.function == Function::Cycle) return true;
        if (!parameters.empty() && std::ranges::none_of(parameters, names_axis)) return true;
    }
    return false;
}

}  // namespace

Outcome ComputedWords::read(CompiledLine& line, Block& out) {
    const nc::ControlLine& code = line.line;
    const bool is_computed = !code.computed.empty() || !code.axes.empty() || !code.codes.empty();
    if (run_.phase.is_only_checking && is_computed) return Outcome::Nothing;
    values_.clear();
    run_.evaluator.forget();
    const nc::ComputedValue* axis_argument = nullptr;
    if (!code.axes.empty()) {
        const Outcome done = set_axes(line);
        if (!goes_on(done)) return done;
    }
    if (!code.codes.empty()) {
        const Outcome done = set_codes(line);
        if (!goes_on(done)) return done;
    }
    for (std::size_t i = 0; i < code.computed.size(); ++i) {
        const bool is_fine_round =
            run_.language.rules.round_in_word && code.computed[i].argument < 0;
        ControlValue value;
        const Outcome done = run_.evaluate(
            line, code.computed[i].value, value,
            is_fine_round ? nc::value_decimals(run_.tables, run_.lines.modes().units(), code, i)
                          : -1);
        if (!goes_on(done)) return done;
        // An axis among the arguments of a call is given by its number, X by -1.
        const bool is_axis_argument = value.axis() && code.computed[i].argument >= 0;
        if (is_axis_argument && axis_argument == nullptr) axis_argument = &code.computed[i];
        if (!value.is_number() && !value.is_text() && !is_axis_argument) {
            return run_.fail(line, diag::TypesDiffer, code.computed[i].value.span,
                             {"a word", std::string(kind_name(value))});
        }
        nc::WordValue& word = values_.emplace_back();
        word.kind = value.is_vacant() ? nc::WordValue::Kind::Vacant
                    : value.is_text() ? nc::WordValue::Kind::Text
                                      : nc::WordValue::Kind::Number;
        word.number = value.number;
        word.text = run_.evaluator.text(value);
    }
    const bool is_kept = &line != &run_.scratch && code.axes.empty() && code.codes.empty();
    nc::MatchedLine* const known = is_kept ? &line.matched : nullptr;
    if (!run_.lines.read_words(line.text, line.line, values_, out, known)) return Outcome::Failed;
    if (axis_argument != nullptr && takes_no_axis(out))
        return run_.fail(line, diag::TypesDiffer, axis_argument->value.span,
                         {"an argument of this call", "an axis"});
    const bool has_lone = std::ranges::any_of(code.axes, &nc::ComputedAxis::is_alone);
    return has_lone ? let_axis_move_alone(line, out) : Outcome::Block;
}

/// An axis that moves by itself goes straight to its position and arrives before the next block. Of
/// several each goes as fast as it can, so they do not stay on a line; where they come to is the
/// same.
Outcome ComputedWords::let_axis_move_alone(CompiledLine& line, Block& out) {
    const nc::SlotMask targets = out.given & nc::kTargetSlots;
    const auto count = static_cast<std::size_t>(std::popcount(targets));
    const auto alone = std::ranges::count_if(line.line.axes, &nc::ComputedAxis::is_alone);
    if (count != static_cast<std::size_t>(alone) || out.motion != Function::None) {
        return run_.fail(line, diag::IsoNotSupported, line.line.axes[0].axis.span,
                         {"an axis that moves by itself beside others"});
    }
    if (count > 1 && !reported_separate_) {
        reported_separate_ = true;
        run_.sink.report(diag::AxesSeparate,
                         run_.lines.location(line.text, line.program_line.line.line,
                                             line.line.axes[0].axis.span));
    }
    if (out.find(Function::RapidOnce) == nullptr) out.add(Function::RapidOnce, 0);
    run_.modal_calls.note_lone_motion();
    return Outcome::Block;
}

/// The axis that a value is, or that it counts where no value is an axis; nothing: there is none.
static std::optional<Axis> axis_of(const ControlVariables& variables, const ControlValue& value) {
    if (value.axis() || !value.is_number()) return value.axis();
    const auto has_number = [&](std::string_view name) {
        const auto axis =
            static_cast<Axis>(std::ranges::find(kAxisNames, name) - kAxisNames.begin());
        const auto number = variables.axis_number(axis);
        return number && static_cast<double>(*number) == value.number;
    };
    const auto found = std::ranges::find_if(kAxisNames, has_number);
    if (found == kAxisNames.end()) return std::nullopt;
    return static_cast<Axis>(found - kAxisNames.begin());
}

/// Words whose axis or spindle is a value get the address of that: `AX[AXA]=10` that of X,
/// `ACC[AXA]=50` that of `ACC[X]`, `S[R1]=500` that of `S2`, or S where it is the first spindle.
Outcome ComputedWords::set_axes(CompiledLine& line) {
    for (const nc::ComputedAxis& computed : line.line.axes) {
        ControlValue value;
        const Outcome done = run_.evaluate(line, computed.axis, value);
        if (!goes_on(done)) return done;
        nc::GivenWord& word = line.line.words.words[computed.word];
        const std::size_t begin = line.line.words.spans[computed.word].begin;
        const nc::ControlWords words(run_.tables, line.text);
        const std::string text = words.normal(words.word_at(begin).text);
        const bool is_axis_word = computed.is_alone || text == run_.language.axis_word;
        word.names_first = false;
        const std::optional<Axis> axis =
            is_axis_word ? axis_of(run_.variables, value) : value.axis();
        if (!axis && is_axis_word)
            return run_.fail(line, diag::AxisNameUnknown, computed.axis.span,
                             {run_.evaluator.written(value)});
        if (!axis) {
            const auto number = value.spindle().value_or(std::llround(value.number));
            word.names_first = number == 1;
            word.address =
                run_.tables.find_address(number == 1 ? text : text + std::to_string(number));
            if (word.address == nc::kNoAddress)
                word.address = run_.tables.find_address(text + '[' + std::to_string(number) + ']');
            if (word.address != nc::kNoAddress) continue;
            return run_.fail(line, diag::SpindleMissing, computed.axis.span,
                             {std::to_string(number)});
        }
        const std::string axis_name(kAxisNames[index(*axis)]);
        const std::string name = is_axis_word ? axis_name : text + '[' + axis_name + ']';
        word.address = run_.tables.find_address(name);
        if (word.address == nc::kNoAddress)
            return run_.fail(line, diag::IsoUnknownWord, computed.axis.span, {name});
    }
    return Outcome::Nothing;
}

/// Words that name a code by its group and its index there become that code.
Outcome ComputedWords::set_codes(CompiledLine& line) {
    for (const nc::ComputedCode& computed : line.line.codes) {
        ControlValue group;
        ControlValue number;
        Outcome done = run_.evaluate(line, computed.group, group);
        if (!goes_on(done)) return done;
        done = run_.evaluate(line, computed.number, number);
        if (!goes_on(done)) return done;
        if (!group.is_number())
            return run_.fail(line, diag::IndexType, computed.group.span,
                             {std::string(kind_name(group))});
        const std::string of = run_.evaluator.written(group);
        const auto list = std::ranges::find_if(run_.language.code_lists,
                                               [&](const auto& l) { return l.group == of; });
        const double place = number.is_number() ? number.number : 0;
        const bool is_there = list != run_.language.code_lists.end() &&
                              place == std::floor(place) && place >= 1 &&
                              place <= static_cast<double>(list->codes.size());
        if (!is_there) {
            return run_.fail(line, diag::GroupNumber, computed.number.span,
                             {of, run_.evaluator.written(number)});
        }
        const std::string& code = list->codes[static_cast<std::size_t>(place) - 1];
        if (!set_code(line.line.words, computed.word, code)) {
            const std::string known = run_.tables.unsupported_words(code);
            return run_.fail(line, known.empty() ? diag::IsoUnknownWord : diag::IsoNotSupported,
                             computed.number.span, {known.empty() ? code : known});
        }
    }
    return Outcome::Nothing;
}

/// `G54` as its letter and number, `BRISK` as a word; false: the dialect has no such code.
bool ComputedWords::set_code(nc::LexedLine& words, std::size_t index,
                             const std::string& code) const {
    nc::GivenWord& word = words.words[index];
    words.decimals[index] = {};
    word.address = run_.tables.find_address(code);
    word.has_value = word.is_known = false;
    if (word.address != nc::kNoAddress) return true;
    const Decimal number = parse_decimal(code.data() + 1, code.data() + code.size());
    word.address = run_.tables.find_address(std::string_view(code).substr(0, 1));
    if (word.address == nc::kNoAddress || number.end != code.data() + code.size()) return false;
    word.has_value = word.is_known = true;
    word.number = number.value;
    words.decimals[index] = number;
    return run_.tables.find_code(word.address, number.value) != nullptr;
}

}  // namespace kadr::macro
