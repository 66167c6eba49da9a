// numbers.h — decimal text to number and back: exact, without locale, without heap.
//
// These two functions are the largest cost of expansion and of interpretation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace kadr {

/// The longest text that `format_fixed` writes.
inline constexpr std::size_t kMaxFixedLength = 340;

/// Writes `value` with exactly `decimals` (0 to 9) places, byte for byte as printf("%.*f") does in
/// the "C" locale, except that a result of zero has no sign. Returns past the last byte written.
/// `out` needs kMaxFixedLength bytes. `value` is finite.
char* format_fixed(char* out, double value, int decimals);

/// The value that `format_fixed` writes, as a number: `value` rounded to `decimals` places.
double round_to(double value, int decimals);

/// |value|·10^decimals rounded to a whole number, if that rounding is certain; false where only
/// the exact decimal expansion can decide (at ties, and beyond 10^15).
bool scaled_magnitude(double value, int decimals, std::uint64_t& scaled);

/// Writes the digits of `n` so that they end at `end`; returns where they begin.
char* write_digits_backwards(char* end, std::uint64_t n);

/// A decimal number as it stands in NC text: sign, digits, point, digits; no exponent.
struct Decimal {
    double value = 0;           // correctly rounded
    const char* end = nullptr;  // past the number; equal to the start if there is none
    bool has_point = false;
    std::uint16_t digits = 0;    // digits written, leading zeros not counted
    std::uint16_t decimals = 0;  // digits after the point
};

/// Reads the longest decimal number at `begin`: `10`, `-5.25`, `+.5`, `10.`.
Decimal parse_decimal(const char* begin, const char* end);

/// Shortest text that reads back as the same number: `0.1`, `1e+30`, `-3`.
std::string format_shortest(double value);
void append_shortest(std::string& out, double value);

}  // namespace kadr
