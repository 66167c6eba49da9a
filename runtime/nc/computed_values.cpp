#include "nc/computed_values.h"

#include <cmath>
#include <vector>

#include "base/powers.h"

namespace kadr::nc {

namespace {

bool has_decimal_codes(const DialectTables& tables, AddressId id) {
    const std::vector<std::uint16_t>& index = tables.code_index[id];
    for (std::size_t i = 0; i < index.size(); ++i) {
        if (index[i] != 0 && i % 10 != 0) return true;
    }
    return false;
}

/// Codes and addresses that take whole numbers get one: `M[3.5]` is M4.
double whole_if_needed(const DialectTables& tables, AddressId id, double value) {
    const Address& address = tables.addresses[id];
    const bool is_whole = address.kind == Address::Kind::Code
                              ? !has_decimal_codes(tables, id)
                              : address.format.point == PointRule::Never;
    return is_whole ? std::round(value) : value;
}

}  // namespace

void set_values(const DialectTables& tables, ControlLine& compiled,
                std::span<const WordValue> values) {
    LexedLine& lexed = compiled.words;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const ComputedValue& computed = compiled.computed[i];
        const WordValue& value = values[i];
        if (value.kind == WordValue::Kind::Text) lexed.text = value.text;
        if (computed.argument >= 0) {
            GivenArgument& argument = lexed.arguments[static_cast<std::size_t>(computed.argument)];
            argument.kind = value.kind == WordValue::Kind::Text     ? GivenArgument::Kind::Text
                            : value.kind == WordValue::Kind::Vacant ? GivenArgument::Kind::Empty
                                                                    : GivenArgument::Kind::Number;
            argument.number = value.number;
            continue;
        }
        GivenWord& word = lexed.words[computed.word];
        word.is_computed = true;
        word.is_left_out = value.kind == WordValue::Kind::Vacant;
        word.is_text = value.kind == WordValue::Kind::Text;
        word.is_known = value.kind == WordValue::Kind::Number;
        word.number = whole_if_needed(tables, word.address, value.number);
        Decimal& decimal = lexed.decimals[computed.word];
        decimal = {};
        decimal.value = word.number;
        decimal.has_point = true;
        lexed.minus[computed.word] = word.number < 0;
    }
}

int value_decimals(const DialectTables& tables, const TextUnits& units, const ControlLine& line,
                   std::size_t computed) {
    const ComputedValue& value = line.computed[computed];
    if (value.argument >= 0) return 0;
    const Address& address = tables.addresses[line.words.words[value.word].address];
    return text_decimals(address.format, address.dimension, units);
}

double rounded_value(const DialectTables& tables, double value, const NumberFormat& format,
                     Dimension dimension, const TextUnits& units) {
    if (!tables.language.rules.rounds_values) return value;
    const double power = power_of_ten(text_decimals(format, dimension, units));
    return std::round(value * power) / power;
}

}  // namespace kadr::nc
