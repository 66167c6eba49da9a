// text_format.cpp — values into texts: `"{x:.3}"`, `"{i:03}"`.
#include "expand/text_format.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/numbers.h"
#include "base/readable.h"
#include "base/text.h"
#include "expand/running.h"

namespace kadr::expand {

using sema::FormatPiece;
using sema::ShownForm;

namespace {

std::string shown_list(Running& run, const sema::ShownForm& form, Slot list);
std::string shown_contour(Running& run, const sema::ShownForm& form, Slot contour);

constexpr std::int64_t kShownElements = 20;  // of a list; a line or two at a prompt

/// Twelve digits: what was meant, without the noise of the last binary digit.
std::string shown(double value) {
    std::array<char, 40> text{};
    if (value == 0) value = 0;  // no minus before zero
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                   std::chars_format::general, 12);
    return {text.data(), end.ptr};
}

std::string number(double value, const FormatPiece& piece) {
    if (value != value) return "?";
    // With a unit it is for a person.
    if (piece.decimals < 0) return piece.scale.unit.empty() ? shown(value) : readable(value);
    if (!(std::abs(value) < 1e300)) return shown(value);
    std::array<char, kMaxFixedLength> text{};
    return {text.data(), format_fixed(text.data(), value, piece.decimals)};
}

/// The text in its width, its unit behind it.
void pad(std::string text, const FormatPiece& piece, std::string& out, std::string_view unit = {}) {
    if (piece.plus && !text.empty() && text[0] != '-') text.insert(0, 1, '+');
    const auto width = static_cast<std::size_t>(std::max<int>(0, piece.width));
    const std::size_t places = count_code_points(text);
    if (places < width) {
        const std::size_t missing = width - places;
        const bool has_sign = !text.empty() && (text[0] == '-' || text[0] == '+');
        if (piece.zeros) text.insert(has_sign ? 1 : 0, missing, '0');
        else text.insert(0, missing, ' ');
    }
    out += text;
    out += unit;
}

}  // namespace

std::string format(const Running& run, const sema::FormatPattern& pattern, const Slot* values) {
    std::string out;
    const bool is_inch = run.modal[nc::Group::Units] == nc::Function::Inch;
    for (const FormatPiece& piece : pattern) {
        if (out.size() > run.options.limits.array_elements) break;  // who asked for it reports that
        if (piece.kind == FormatPiece::Kind::Literal) {
            out += piece.text;
            continue;
        }
        const Slot value = *values++;
        const FormatPiece::Scale& scale =
            is_inch && piece.serves_inches ? piece.inch_scale : piece.scale;
        switch (piece.kind) {
            case FormatPiece::Kind::Literal: break;
            case FormatPiece::Kind::Integer:
                if (piece.decimals >= 0) {
                    pad(number(static_cast<double>(value.integer), piece), piece, out);
                } else {
                    pad(std::to_string(value.integer), piece, out);
                }
                break;
            case FormatPiece::Kind::Number:
                pad(number(value.number * scale.factor, piece), piece, out, scale.unit);
                break;
            case FormatPiece::Kind::Feed:
            case FormatPiece::Kind::Speed: {
                // Per revolution: mm; cutting speed: m/min.
                const bool second = sema::is_second_form(value.number);
                const bool is_feed = piece.kind == FormatPiece::Kind::Feed;
                double shown_value = value.number * scale.factor;
                if (second) {
                    const double plain = value.number / sema::kSecondForm;
                    shown_value = is_feed ? plain * scale.factor / 60 : plain * 0.06;
                }
                pad(number(shown_value, piece), piece, out,
                    second ? scale.second_unit : scale.unit);
                break;
            }
            case FormatPiece::Kind::Text: pad(run.vm.heap.text(value.integer), piece, out); break;
            case FormatPiece::Kind::Bool:
                pad(value.integer != 0 ? "true" : "false", piece, out);
                break;
            case FormatPiece::Kind::Enum: {
                std::string name = std::to_string(value.integer);
                for (const auto& [member, number_of] : run.code.enums[piece.enumeration].members) {
                    if (number_of == value.integer) name = member;
                }
                pad(std::move(name), piece, out);
                break;
            }
        }
    }
    return out;
}

std::string quantity_text(const Running& run, double value, sema::Quantity quantity) {
    const bool is_inch = run.modal[nc::Group::Units] == nc::Function::Inch;
    const sema::Units units = is_inch ? sema::Units::Inch : sema::Units::Metric;
    const std::string unit = sema::unit_text(quantity, units);
    return readable(value / sema::bare_factor(quantity, units)) + (unit.empty() ? "" : " ") + unit;
}

// ---------------------------------------------------------------- values at the prompt

std::string shown(Running& run, std::uint32_t form, const Slot* value, bool is_part) {
    const ShownForm& shape = run.code.shown_forms[form];
    const bool is_whole = shape.kind != ShownForm::Kind::Members;
    if (is_whole && !sema::is_given(*value, static_cast<unsigned>(shape.slot))) return "not given";
    switch (shape.kind) {
        case ShownForm::Kind::Plain: {
            const std::string text = format(run, {shape.piece}, value);
            const bool is_quoted = is_part && shape.piece.kind == FormatPiece::Kind::Text;
            return is_quoted ? '"' + text + '"' : text;
        }
        case ShownForm::Kind::List: return shown_list(run, shape, *value);
        case ShownForm::Kind::Contour: return shown_contour(run, shape, *value);
        case ShownForm::Kind::Members: break;
    }
    std::string out;
    for (const ShownForm::Part& part : shape.parts) {
        const std::string text = shown(run, part.form, value + part.slot, true);
        if (text == "not given") continue;
        out += (out.empty() ? "{" : ", ") + part.name + ": " + text;
    }
    return out.empty() ? "not given" : out + '}';
}

namespace {

std::string shown_list(Running& run, const ShownForm& form, Slot list) {
    const Heap::ArrayView elements = run.vm.heap.array(list.integer);
    std::string out = "{";
    const std::int64_t most = std::min(elements.count, kShownElements);
    for (std::int64_t i = 0; i < most; ++i) {
        if (i > 0) out += ", ";
        out += shown(run, form.parts[0].form, elements.slots + i * elements.stride, true);
    }
    if (most < elements.count) out += ", … " + std::to_string(elements.count) + " in all";
    return out + '}';
}

/// Its ends and what lies between: all coordinates would hide them.
std::string shown_contour(Running& run, const ShownForm& form, Slot contour) {
    const Heap::ArrayView elements = run.vm.heap.array(contour.integer);
    if (elements.count == 0) return "an empty contour";
    const auto end = [&](const Slot* element, sema::ElementSlot which) {
        return shown(run, form.parts[0].form, element + static_cast<std::size_t>(which), true);
    };
    const Slot* last = elements.slots + (elements.count - 1) * elements.stride;
    return "a contour from " + end(elements.slots, sema::ElementSlot::From) + " to " +
           end(last, sema::ElementSlot::To) + ", " + std::to_string(elements.count) +
           (elements.count == 1 ? " element" : " elements");
}

}  // namespace

}  // namespace kadr::expand
