#include "nc/block_values.h"

#include <cmath>
#include <optional>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "nc/computed_values.h"

namespace kadr::nc {

Done BlockValues::put(const Claim& claim, const LexedLine& words, std::string_view line,
                      Block& block) {
    const GivenWord& word = words.words[claim.word];
    if (claim.dimension == Dimension::Text) return kDone;
    if (claim.argument >= 0) {
        put_argument(claim, words, block);
        return kDone;
    }
    if (word.is_text && !word.is_known) return kDone;  // a name; it stands in the block's text
    if (word.is_text) block.text.clear();
    if (claim.is_named_only) {
        block.set_argument(block.functions[claim.invocation], claim.parameter, 0);
        return kDone;
    }
    if (claim.has_point_tail) return put_both(claim, words, line, block);
    if (claim.in_increments || claim.tail_digits > 0) return put_whole(claim, words, line, block);
    return put_number(claim, words, line, block);
}

/// An argument of a call: `CYCLE83(…)`.
void BlockValues::put_argument(const Claim& claim, const LexedLine& words, Block& block) const {
    Invocation& invocation = block.functions[claim.invocation];
    const GivenWord& word = words.words[claim.word];
    const double number =
        words.arguments[word.first_argument + static_cast<std::size_t>(claim.argument)].number;
    const double scale = text_scale(claim.dimension, modes_.units(), false);
    const double value = (number / scale - claim.offset) / claim.factor;
    // A clearance is entered without its sign (S 9.1 SDIS).
    const double sum =
        claim.adds ? block.argument(invocation, claim.parameter) + std::fabs(value) : value;
    block.set_argument(invocation, claim.parameter, sum);
}

/// The number of a word, with its decimals.
Done BlockValues::put_number(const Claim& claim, const LexedLine& words, std::string_view line,
                             Block& block) {
    const GivenWord& word = words.words[claim.word];
    const Decimal& decimal = words.decimals[claim.word];
    const TextUnits& units = modes_.units();
    const NumberFormat& own =
        claim.format != nullptr ? *claim.format : tables_.addresses[word.address].format;
    std::optional<NumberFormat> pitch;
    if (claim.is_pitch || (!claim.is_parameter && is_pitch(claim, block)))
        pitch = pitch_format(own);
    const NumberFormat& format = pitch ? *pitch : own;
    // A plain factor below 0: the digits are the number, whatever one without a point means.
    const bool takes_digits = claim.plain_factor < 0;
    const double meaning =
        takes_digits       ? decimal.value
        : word.is_computed ? rounded_value(tables_, decimal.value, format, claim.dimension, units)
                           : read_meaning(decimal, format, claim.dimension, units);
    Decimal written = decimal;
    if (word.is_computed) written.has_point = format.point != PointRule::Never;
    const NumberFault fault =
        check_read(written, words.minus[claim.word], takes_digits ? 0 : meaning, format,
                   claim.dimension, units);
    if (fault != NumberFault::None) {
        const DiagnosticRow& row = fault == NumberFault::Point      ? diag::IsoPointNotAllowed
                                   : fault == NumberFault::Negative ? diag::IsoMinusNotAllowed
                                                                    : diag::IsoTooManyDigits;
        return fail(row, claim, words, line);
    }
    if (!claim.is_parameter) {
        if (points_.is_open() && is_position(static_cast<Slot>(claim.index)))
            points_.watch(claim, words, line);
        set_slot(claim, meaning, block);
        return kDone;
    }
    Invocation& invocation = block.functions[claim.invocation];
    // What a block sets for cycles behind it are strokes and allowances: `G71 U2000 R500`.
    const bool is_preset = invocation.function == Function::CyclePreset;
    if (points_.is_open() && !is_preset && is_position_of_function(claim, words))
        points_.watch(claim, words, line);
    const bool is_plain = claim.plain_factor > 0 && !decimal.has_point;
    const double factor = is_plain ? claim.plain_factor : claim.factor;
    const double scaled = meaning / text_scale(claim.dimension, units, false);
    block.set_argument(invocation, claim.parameter, (scaled - claim.offset) / factor);
    return kDone;
}

/// meaning  of the word, in the text's units
void BlockValues::set_slot(const Claim& claim, double meaning, Block& block) const {
    constexpr double kMinute = 60;  // s; feeds under inverse time are 1/min
    const auto slot = static_cast<Slot>(claim.index);
    const double scale = modes_.slot_scale(claim.dimension);
    const bool is_time = slot == Slot::Feed && modes_.is_feed_time();
    block.set(slot, is_time && meaning != 0 ? kMinute / meaning
                    : scale == 1            ? meaning
                                            : meaning / scale);
}

/// `T4.04`: two whole numbers, of which the second stands behind the point. A number without a
/// point is the first one alone.
Done BlockValues::put_both(const Claim& claim, const LexedLine& words, std::string_view line,
                           Block& block) {
    const GivenWord& word = words.words[claim.word];
    const std::string text = words.text_of(line, claim.word);
    const std::size_t point = word.is_computed ? std::string::npos : text.find('.');
    if (words.minus[claim.word]) return fail(diag::IsoMinusNotAllowed, claim, words, line);
    if (word.is_computed && word.number != std::floor(word.number))
        return fail(diag::IsoPointNotAllowed, claim, words, line);
    Invocation& invocation = block.functions[claim.invocation];
    block.set_argument(invocation, claim.parameter, std::floor(words.decimals[claim.word].value));
    if (point == std::string::npos || point + 1 == text.size()) return kDone;
    const Decimal second = parse_decimal(text.data() + point + 1, text.data() + text.size());
    block.set_argument(invocation, static_cast<std::size_t>(claim.tail_parameter), second.value);
    return kDone;
}

/// Whether the word of a function is a position or a size at the part, as Z and R of a cycle, `,R`,
/// or X of G52. Strokes and allowances have their whole numbers by custom: `Q5000`, `U400`.
bool BlockValues::is_position_of_function(const Claim& claim, const LexedLine& words) const {
    if (claim.dimension != Dimension::Length) return false;
    const std::string& name = tables_.addresses[words.words[claim.word].address].name;
    return name.size() <= 2 && std::string_view("XYZRC").find(name.back()) != std::string::npos;
}

/// Whether the word is F of a thread, where F is the pitch.
bool BlockValues::is_pitch(const Claim& claim, const Block& block) const {
    if (static_cast<Slot>(claim.index) != Slot::Feed || !modes_.is_feed_pitch()) return false;
    const Function motion =
        block.motion != Function::None ? block.motion : modes_.active(Group::Motion);
    return motion == Function::Thread || has_fact(motion, Fact::VaryingThread) ||
           has_fact(motion, Fact::ArcThread);
}

/// A whole number that counts increments, or holds two parameters.
Done BlockValues::put_whole(const Claim& claim, const LexedLine& words, std::string_view line,
                            Block& block) {
    const GivenWord& word = words.words[claim.word];
    const TextUnits& units = modes_.units();
    Decimal decimal = words.decimals[claim.word];
    if (word.is_computed) {
        decimal.value = std::round(decimal.value);
        decimal.has_point = false;
    }
    const int most_digits = tables_.addresses[word.address].format.max_digits;
    const bool is_long = !word.is_computed && most_digits != 0 && decimal.digits > most_digits;
    if (decimal.has_point) return fail(diag::IsoPointNotAllowed, claim, words, line);
    if (words.minus[claim.word]) return fail(diag::IsoMinusNotAllowed, claim, words, line);
    if (is_long) return fail(diag::IsoTooManyDigits, claim, words, line);
    Invocation& invocation = block.functions[claim.invocation];
    if (claim.in_increments) {
        const double size = increment_size(tables_, claim.dimension, units);
        const double value = decimal.value * size / text_scale(claim.dimension, units, false);
        block.set_argument(invocation, claim.parameter, round_to(value, 9));
        return kDone;
    }
    const double front = std::pow(10.0, claim.tail_digits);
    block.set_argument(invocation, claim.parameter, std::floor(decimal.value / front));
    if (claim.tail_parameter >= 0) {
        block.set_argument(invocation, static_cast<std::size_t>(claim.tail_parameter),
                           std::fmod(decimal.value, front));
    }
    return kDone;
}

Done BlockValues::fail(const DiagnosticRow& row, const Claim& claim, const LexedLine& words,
                       std::string_view line) {
    // Words of other controls have nothing to do with how a number is written.
    faults_.report(line,
                   LineFault{&row, words.spans[claim.word], {words.text_of(line, claim.word)}}, {});
    return kFailed;
}

}  // namespace kadr::nc
