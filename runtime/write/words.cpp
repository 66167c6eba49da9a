#include "write/words.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/diagnostics/dialect.h"
#include "base/numbers.h"
#include "base/readable.h"
#include "nc/center_words.h"
#include "nc/comment_text.h"
#include "write/lines.h"

namespace kadr::write {

namespace {

/// Decimals of an angle among the arguments of a call: they are real numbers, and an angle of
/// thousandths moves a point that is far from its centre.
constexpr int kArgumentAngleDecimals = 9;

}  // namespace

void Words::append_item(const Block& block, const Item& item, const Targets& targets,
                        std::string& out) {
    if (item.form != kNoForm) {
        const Form& form = tables_.forms[item.form];
        blank(out);
        if (form.is_verbatim) {
            append_verbatim(block, form, *item.invocation, out);
        } else if (form.is_comment) {
            out += tables_.comment.open;
            out += form.words[0].text;
            out += comment_text(block.text, tables_.comment);
            out += tables_.comment.close;
        } else {
            append_words(block, form.words, item.invocation, form.remembers, out);
        }
        return;
    }
    if (item.edge >= 0) return append_edge(block, item.edge, out);
    if (item.words != nullptr) {
        blank(out);
        append_words(block, *item.words, nullptr, false, out);
        return;
    }
    append_slot(block, item.slot, targets, out);
}

/// A line of the control's own language: letters as they are, numbers as in arguments.
void Words::append_verbatim(const Block& block, const Form& form, const Invocation& invocation,
                            std::string& out) {
    const NumberFormat format = argument_format(tables_);
    for (const FormWord& word : form.words) {
        if (word.is_quantity) {
            append_quantity(block, word, format, "()", out);
            continue;
        }
        out += word.text;
        if (word.parameter >= 0) append_parameter(block, word, &invocation, format, "()", out);
    }
}

void Words::append_edge(const Block& block, int edge, std::string& out) {
    const Form& form =
        tables_.forms[tables_.forms_of[static_cast<std::size_t>(Function::ToolEdge)][0]];
    Block words;
    words.source = block.source;
    Invocation* invocation = words.add(Function::ToolEdge, 1);
    words.set_argument(*invocation, parameter_of<Function::ToolEdge>("edge"), edge);
    append_words(words, form.words, invocation, false, out);
}

void Words::append_words(const Block& block, std::span<const FormWord> words,
                         const Invocation* invocation, bool remembers, std::string& out) {
    // Of words that keep their value, only those that change are written; one at least.
    std::uint32_t unchanged = 0;
    std::size_t values = 0;
    for (const FormWord& word : words) {
        if (!remembers || word.parameter < 0 || invocation == nullptr) continue;
        ++values;
        const auto parameter = static_cast<std::size_t>(word.parameter);
        const double value = block.argument(*invocation, parameter, word.fallback);
        const NumberInForce& kept = modal_.frame.shift[parameter % modal_.frame.shift.size()];
        if (kept.is_known && kept.value == value) unchanged |= 1u << word.parameter;
        state_.say_shift(parameter, value);
    }
    const bool writes_all = values == static_cast<std::size_t>(std::popcount(unchanged));
    for (const FormWord& word : words) {
        if (!writes_all && word.parameter >= 0 && (unchanged >> word.parameter & 1u) != 0) continue;
        append_word(block, word, invocation, out);
    }
}

void Words::append_word(const Block& block, const FormWord& word, const Invocation* invocation,
                        std::string& out) {
    switch (word.kind) {
        case FormWord::Kind::Fixed:
            if (word.is_quantity) {
                blank(out);
                append_quantity(block, word, tables_.addresses[word.address].format,
                                tables_.addresses[word.address].name, out);
                break;
            }
            [[fallthrough]];
        case FormWord::Kind::Name:
            blank(out);
            out += word.text;
            break;
        case FormWord::Kind::Call: append_call(block, word, invocation, out); break;
        case FormWord::Kind::Value:
        case FormWord::Kind::Quoted: {
            const auto parameter = static_cast<std::size_t>(word.parameter);
            const bool is_quoted = word.kind == FormWord::Kind::Quoted;
            const bool is_given = invocation == nullptr ||
                                  (invocation->given >> parameter & 1u) != 0 || word.has_default ||
                                  (is_quoted && !block.text.empty());
            if (!is_given) return;
            blank(out);
            out += word.text;
            if (is_quoted) out += '"';
            append_parameter(block, word, invocation,
                             word.format ? *word.format : tables_.addresses[word.address].format,
                             tables_.addresses[word.address].name, out);
            if (is_quoted) out += '"';
            break;
        }
        case FormWord::Kind::Empty:
        case FormWord::Kind::Text:
        case FormWord::Kind::Rest: break;
    }
}

void Words::append_call(const Block& block, const FormWord& word, const Invocation* invocation,
                        std::string& out) {
    blank(out);
    const bool is_in_brackets = word.text.starts_with('(');  // around the name
    out += word.text;
    if (!is_in_brackets) out += '(';
    std::size_t last = is_in_brackets ? out.size() : 0;  // past the last argument that is not empty
    const NumberFormat format = argument_format(tables_);
    NumberFormat angles = format;
    angles.decimals = std::max(format.decimals, kArgumentAngleDecimals);
    for (std::size_t i = 0; i < word.arguments.size(); ++i) {
        const FormWord& argument = word.arguments[i];
        const bool is_given = argument.parameter >= 0 && invocation != nullptr &&
                              (invocation->given >> argument.parameter & 1u) != 0;
        const bool is_lettered = argument.address != kNoAddress;
        if (is_lettered && !is_given && !argument.has_default) continue;
        if (i > 0 || is_in_brackets) out += ',';
        const std::size_t before = out.size();
        if (is_lettered) {
            append_lettered(block, argument, invocation, out);
            last = out.size();
            continue;
        }
        if (argument.is_quantity) {
            append_quantity(block, argument, format, word.text, out);
        } else if (argument.is_work_offset) {
            append_work_offset(block, out);
        } else if (argument.kind == FormWord::Kind::Fixed) {
            out += argument.text;
        } else if (argument.kind == FormWord::Kind::Text) {
            if (!block.text.empty()) {
                out += '"';
                append_text(block, out);
                out += '"';
            }
        } else if (argument.adds) {
            out += '0';
        } else if (argument.kind == FormWord::Kind::Value && (is_given || argument.has_default)) {
            const bool is_angle = argument.dimension == Dimension::Angle;
            append_parameter(block, argument, invocation, is_angle ? angles : format, word.text,
                             out);
        }
        if (out.size() != before) last = out.size();
    }
    // Empty places at the end are left out.
    if (last != 0) out.resize(last);
    while (out.ends_with(',')) out.pop_back();
    out += ')';
}

/// The number of the work offset that acts, which the command names.
void Words::append_work_offset(const Block& block, std::string& out) {
    const double number = modal_.text.work_offset;
    if (number < 0)
        return messages_.cannot_express(block, "a frame where the work offset is not known");
    append_shortest(out, number);
}

/// `X10.`, `X`: an argument with its letter, whose numbers it has.
void Words::append_lettered(const Block& block, const FormWord& word, const Invocation* invocation,
                            std::string& out) {
    out += word.text;
    if (word.is_letter_alone) return;
    append_parameter(block, word, invocation,
                     word.format ? *word.format : tables_.addresses[word.address].format, word.text,
                     out);
}

/// A number of the form itself, in the units of the text.
void Words::append_quantity(const Block& block, const FormWord& word, const NumberFormat& format,
                            std::string_view name, std::string& out) {
    out += word.text;
    const double number = word.number * text_scale(word.dimension, modal_.units, false);
    const NumberFault fault = append_number(out, number, format, word.dimension, modal_.units);
    if (fault != NumberFault::None)
        messages_.number_fault(block, fault, number, word.dimension, name);
}

namespace {

/// A block number is written as it stands behind N, whatever other numbers of the address are.
constexpr NumberFormat kBlockNumber = [] {
    NumberFormat format;
    format.decimals = format.inch_decimals = 0;
    format.point = PointRule::Never;
    format.max_digits = 8;
    format.allows_minus = false;
    return format;
}();

bool is_block_number(const DialectTables& tables, const Block& block, const FormWord& word,
                     const Invocation* invocation) {
    if (invocation == nullptr || invocation->function != Function::Cycle) return false;
    const nc::CycleInfo::Roles& roles = tables.cycles[block.cycle].roles;
    return word.parameter >= 0 &&
           (word.parameter == roles.first_block || word.parameter == roles.last_block);
}

}  // namespace

void Words::append_parameter(const Block& block, const FormWord& word, const Invocation* invocation,
                             const NumberFormat& format, std::string_view name, std::string& out) {
    const auto parameter = static_cast<std::size_t>(word.parameter);
    const bool is_given = invocation != nullptr && (invocation->given >> parameter & 1u) != 0;
    if (word.kind == FormWord::Kind::Quoted && !is_given) {
        append_text(block, out);
        return;
    }
    double value = invocation == nullptr ? held_offset_
                                         : block.argument(*invocation, parameter, word.fallback);
    if (word.is_named_only) value = 0;
    if (word.has_point_tail) return append_both(block, word, value, invocation, name, out);
    if (word.in_increments || word.tail_digits > 0) {
        append_whole(block, word, value, invocation, name, out);
        return;
    }
    const double scale = text_scale(word.dimension, modal_.units, false);
    const double number = (value * word.factor + word.offset) * scale;
    const double programmed = value * scale;  // in the unit that messages name
    if (word.dimension == Dimension::Factor) {
        append_factor(block, number, std::abs(word.factor) == 1000, format, name, out);
        return;
    }
    if (word.plain_factor > 0) {
        NumberFormat pointed = format;  // without its point the number would mean another unit
        pointed.point = PointRule::Always;
        const NumberFault fault = append_number(out, number, pointed, word.dimension, modal_.units);
        if (fault != NumberFault::None)
            messages_.number_fault(block, fault, programmed, word.dimension, name);
        return;
    }
    const bool is_of_frame = invocation != nullptr && word.dimension == Dimension::Length &&
                             has_fact(invocation->function, Fact::SetsFrame);
    const NumberFormat own = is_block_number(tables_, block, word, invocation) ? kBlockNumber
                             : word.is_pitch ? pitch_format(format)
                             : is_of_frame   ? frame_format(format)
                                             : format;
    const NumberFault fault = append_number(out, number, own, word.dimension, modal_.units);
    if (fault != NumberFault::None)
        messages_.number_fault(block, fault, programmed, word.dimension, name);
    const int places = text_decimals(own, word.dimension, modal_.units);
    check_rounding(block, number, places, word.dimension, name);
    if (word.dimension == Dimension::Angle && invocation != nullptr)
        state_.say_turn(block, *invocation, number, places);
}

/// `1.4`: two whole numbers with a point between them.
void Words::append_both(const Block& block, const FormWord& word, double value,
                        const Invocation* invocation, std::string_view name, std::string& out) {
    NumberFormat format;
    format.decimals = format.inch_decimals = 0;
    format.point = PointRule::Never;
    format.max_digits = 8;
    format.allows_minus = false;
    const auto append = [&](double number) {
        const NumberFault fault =
            append_number(out, number, format, Dimension::Count, modal_.units);
        if (fault != NumberFault::None)
            messages_.number_fault(block, fault, number, Dimension::Count, name);
    };
    append(value);
    const auto tail = static_cast<std::size_t>(word.tail_parameter);
    if (invocation != nullptr && (invocation->given >> tail & 1u) == 0) return;
    out += '.';
    append(invocation == nullptr ? value : block.argument(*invocation, tail));
}

/// A whole number without a point: so many increments, or a number in two parts, the first of two
/// digits at least.
void Words::append_whole(const Block& block, const FormWord& word, double value,
                         const Invocation* invocation, std::string_view name, std::string& out) {
    NumberFormat format;
    format.decimals = format.inch_decimals = 0;
    format.point = PointRule::Never;
    format.max_digits = 8;
    format.allows_minus = false;
    double number = value;
    if (word.in_increments) {
        number *= text_scale(word.dimension, modal_.units, false) /
                  increment_size(tables_, word.dimension, modal_.units);
    } else {
        const double front = std::pow(10.0, word.tail_digits);
        const auto tail_at = static_cast<std::size_t>(std::max(word.tail_parameter, 0));
        const double tail = word.tail_parameter < 0 ? word.tail_value
                            : invocation == nullptr ? value
                                                    : block.argument(*invocation, tail_at);
        if (!(tail >= 0 && tail < front))
            return messages_.number_fault(block, NumberFault::TooLarge, tail, Dimension::Count,
                                          name);
        number = value * front + tail;
        format.digits = word.tail_digits + 2;
    }
    const Dimension dimension = word.in_increments ? Dimension::Number : Dimension::Count;
    const NumberFault fault = append_number(out, number, format, dimension, modal_.units);
    const double programmed =
        word.in_increments ? value * text_scale(word.dimension, modal_.units, false) : value;
    if (fault != NumberFault::None)
        messages_.number_fault(block, fault, programmed, word.dimension, name);
}

/// A ratio is as exact as it is meant, whatever the decimals of its letter; in thousandths it is a
/// whole number, and what is finer cannot be written.
void Words::append_factor(const Block& block, double number, bool in_thousandths,
                          const NumberFormat& address, std::string_view name, std::string& out) {
    constexpr int kDecimals = 9;     // a factor is a real number on the controls that take one
    constexpr double kNoise = 1e-6;  // of a product with 1000
    NumberFormat format;
    format.allows_minus = address.allows_minus;
    format.decimals = in_thousandths ? 0 : kDecimals;
    if (in_thousandths) format.point = PointRule::Never;
    const NumberFault fault = append_number(out, number, format, Dimension::Factor, modal_.units);
    if (in_thousandths && std::fabs(number - std::nearbyint(number)) > kNoise) {
        if (!messages_.fails_first_time(block, name)) return;
        messages_.report(diag::FactorTooFine, block).arg(number / 1000).arg(name);
        return;
    }
    const double programmed = in_thousandths ? number / 1000 : number;
    if (fault != NumberFault::None)
        messages_.number_fault(block, fault, programmed, Dimension::Factor, name);
}

/// The slot whose letter is written for a slot: that of a centre's word may be told by the plane.
std::size_t Words::word_slot(const Block& block, Slot slot) const {
    const bool is_turned = tables_.rules.center_by_plane && is_arc(text_.effective_motion(block));
    if (!is_turned) return static_cast<std::size_t>(slot);
    const Function plane = modal_.meant_of(Group::Plane);
    return static_cast<std::size_t>(nc::center_word_of_slot(slot, plane));
}

void Words::append_slot(const Block& block, Slot slot, const Targets& targets, std::string& out) {
    const bool by_letter = (targets.by_letter & bit(slot)) != 0;
    const auto at = static_cast<std::size_t>(slot);
    const AddressId id =
        by_letter ? tables_.incremental_address[at] : tables_.slot_address[word_slot(block, slot)];
    if (id == kNoAddress)
        return messages_.cannot_express(block, '`' + std::string(slot_name(slot)) + '`');
    const Address& address = tables_.addresses[id];
    double number = 0;
    if ((targets.written & bit(slot)) != 0) {
        number = targets.number[static_cast<std::size_t>(slot)];
    } else {
        const double value =
            slot == Slot::Feed && !block.has(slot) ? modal_.meant_feed : block.at(slot);
        number = text_.to_text(slot, value) * (slot == Slot::Feed ? targets.feed_factor : 1);
    }
    blank(out);
    out += address.name;
    const bool is_absolute = (targets.wrapped_absolute & bit(slot)) != 0;
    const bool is_incremental = (targets.wrapped_incremental & bit(slot)) != 0;
    if (is_absolute || is_incremental) {
        out += is_absolute ? "=AC(" : "=IC(";
    } else if (address.name.size() > 1) {
        out += '=';
    }
    const bool is_pitch = slot == Slot::Feed && text_.feed_word.is_pitch;
    const NumberFault fault =
        is_pitch ? append_number(out, number, pitch_format(address.format), address.dimension,
                                 modal_.units)
                 : append_number(out, number, address.format, address.dimension, modal_.units);
    if (is_absolute || is_incremental) out += ')';
    if (fault != NumberFault::None)
        messages_.number_fault(block, fault, number, address.dimension, address.name);
    check_rounding(block, number,
                   text_decimals(is_pitch ? pitch_format(address.format) : address.format,
                                 address.dimension, modal_.units),
                   address.dimension, address.name);
    if (slot == Slot::Feed)
        state_.say_feed(round_to(number, text_.decimals(slot)), targets.feed_factor != 1);
    if (slot == Slot::Speed) state_.say_speed(round_to(number, text_.decimals(slot)));
}

/// A text between quotes; one that would end early is an error, what is only shown has apostrophes.
void Words::append_text(const Block& block, std::string& out) {
    std::string text = block.text;
    if (block.find(Function::Message) != nullptr) std::ranges::replace(text, '"', '\'');
    if (text.find_first_of("\"\n\r") != std::string::npos) {
        messages_.fail();
        messages_.report(diag::RawTextBroken, block).arg("text");
        return;
    }
    out += text;
}

/// A feed or a speed that the decimals of its word make another one.
void Words::check_rounding(const Block& block, double number, int places, Dimension dimension,
                           std::string_view name) {
    if (dimension != Dimension::Feed && dimension != Dimension::Speed) return;
    const double written = round_to(number, places);
    if (written == number || written == 0 || !std::isfinite(number)) return;  // 0 has its message
    constexpr double kWarning = 0.01;
    constexpr double kError = 0.1;
    const double share = std::fabs(written / number - 1);
    if (share <= kWarning) return;
    const bool is_error = share > kError;
    const std::string key = std::string(name) + " rounded";
    if (is_error ? !messages_.fails_first_time(block, key) : !messages_.first_time(block, key))
        return;
    messages_.report_word(is_error ? diag::RoundedFar : diag::RoundedAside, block, name)
        .arg(name)
        .arg(quantity_words(written, dimension, modal_.units))
        .arg(quantity_words(number, dimension, modal_.units))
        .arg(readable(round_to(100 * share, 1)));
}

}  // namespace kadr::write
