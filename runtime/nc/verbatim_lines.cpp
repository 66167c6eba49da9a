#include "nc/verbatim_lines.h"

#include <array>

#include "base/numbers.h"
#include "nc/letters.h"

namespace kadr::nc {

namespace {

/// Fills the block if the text has the letters of the form and numbers between them; blanks do not
/// count.
bool matches(const DialectTables& tables, const TextUnits& units, const Form& form,
             std::string_view text, Block& block) {
    const char* at = text.data();
    const char* const end = at + text.size();
    const auto skip = [](const char*& p, const char* last) {
        while (p != last && is_blank(*p)) ++p;
    };
    std::array<double, 32> values{};
    std::uint32_t given = 0;
    for (const FormWord& word : form.words) {
        const char* letter = word.text.data();
        const char* const last = letter + word.text.size();
        for (skip(letter, last); letter != last; skip(letter, last)) {
            skip(at, end);
            if (at == end || *at != *letter) return false;
            ++at;
            ++letter;
        }
        if (word.parameter < 0 && !word.is_quantity) continue;
        skip(at, end);
        const Decimal decimal = parse_decimal(at, end);
        if (decimal.end == at) return false;
        at = decimal.end;
        if (word.is_quantity) {
            if (!is_quantity(word, decimal.value, argument_format(tables), units)) return false;
            continue;
        }
        const auto parameter = static_cast<std::size_t>(word.parameter);
        const double scale = text_scale(word.dimension, units, false);
        const double value = (decimal.value / scale - word.offset) / word.factor;
        const bool is_given = (given >> parameter & 1u) != 0;
        if (is_given && value != values[parameter]) return false;
        values[parameter] = value;
        given |= 1u << parameter;
    }
    skip(at, end);
    if (at != end) return false;
    for (const Constraint& c : form.when) {
        const double value = values[static_cast<std::size_t>(c.parameter)];
        if (value < c.least || value > c.most) return false;
    }
    const std::size_t count = tables.parameters(form).size();
    Invocation* invocation = block.add(form.function, count);
    if (invocation == nullptr) return false;
    for (std::size_t i = 0; i < count; ++i) {
        if ((given >> i & 1u) != 0) block.set_argument(*invocation, i, values[i]);
    }
    for (const auto& [parameter, value] : form.fixed) {
        block.set_argument(*invocation, static_cast<std::size_t>(parameter), value);
    }
    return true;
}

}  // namespace

bool read_verbatim(const DialectTables& tables, const TextUnits& units, std::string_view line,
                   Block& block) {
    if (tables.verbatim_forms.empty()) return false;
    const char* begin = line.data();
    const char* const end = begin + line.size();
    const auto skip_blanks = [&] {
        while (begin != end && is_blank(*begin)) ++begin;
    };
    skip_blanks();
    std::int8_t skip_level = -1;
    if (begin != end && *begin == '/') {
        ++begin;
        skip_level = static_cast<std::int8_t>(tables.notation.default_skip);
        if (begin != end && is_digit(*begin)) skip_level = static_cast<std::int8_t>(*begin++ - '0');
        skip_blanks();
    }
    std::int32_t number = -1;
    if (begin != end && *begin == 'N') {
        const Decimal decimal = parse_decimal(begin + 1, end);
        if (decimal.end == begin + 1 || decimal.has_point || decimal.value > 99999999) return false;
        number = static_cast<std::int32_t>(decimal.value);
        begin = decimal.end;
    }
    for (const FormId id : tables.verbatim_forms) {
        const Form& form = tables.forms[id];
        if (!matches(tables, units, form, {begin, end}, block)) continue;
        tables.note(&form);
        block.number = number;
        block.skip_level = skip_level;
        return true;
    }
    return false;
}

}  // namespace kadr::nc
