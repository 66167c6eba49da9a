// computed_values.h — values that were worked out for words of a line, as numbers of these words.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "nc/control_line.h"
#include "nc/number_text.h"

namespace kadr::nc {

/// What a computed value of a line has come to; in the order of ControlLine::computed.
struct WordValue {
    enum class Kind : std::uint8_t { Number, Text, Vacant };
    Kind kind = Kind::Number;
    double number = 0;
    std::string_view text;
};

/// Puts computed values into the words of their line; a word that is vacant is none.
void set_values(const DialectTables& tables, ControlLine& compiled,
                std::span<const WordValue> values);

/// The decimals to which the control rounds a computed value of the line.
///
/// computed  index into ControlLine::computed
int value_decimals(const DialectTables& tables, const TextUnits& units, const ControlLine& line,
                   std::size_t computed);

/// A computed value as the control takes it, in the text's units: rounded to the increment of its
/// address, halves away from zero.
double rounded_value(const DialectTables& tables, double value, const NumberFormat& format,
                     Dimension dimension, const TextUnits& units);

}  // namespace kadr::nc
