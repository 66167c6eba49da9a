#include "base/numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <system_error>

#include "base/assert.h"
#include "base/powers.h"

namespace kadr {

namespace {

constexpr double kExactInteger = 9007199254740992.0;  // 2^53
constexpr int kMaxDecimals = 9;

constexpr std::array<char, 200> digit_pairs() {
    std::array<char, 200> pairs{};
    for (std::size_t i = 0; i < 100; ++i) {
        pairs[2 * i] = static_cast<char>('0' + i / 10);
        pairs[2 * i + 1] = static_cast<char>('0' + i % 10);
    }
    return pairs;
}
constexpr std::array<char, 200> kDigitPairs = digit_pairs();

char* format_fixed_exactly(char* out, double value, int decimals) {
    const auto end =
        std::to_chars(out, out + kMaxFixedLength, value, std::chars_format::fixed, decimals);
    KADR_ASSERT(end.ec == std::errc(), "a finite number fits into kMaxFixedLength");
    if (*out != '-') return end.ptr;
    for (const char* c = out + 1; c != end.ptr; ++c) {
        if (*c != '0' && *c != '.') return end.ptr;
    }
    std::memmove(out, out + 1, static_cast<std::size_t>(end.ptr - out - 1));
    return end.ptr - 1;
}

}  // namespace

char* write_digits_backwards(char* end, std::uint64_t n) {
    while (n >= 100) {
        const std::size_t pair = n % 100;
        n /= 100;
        end -= 2;
        std::memcpy(end, kDigitPairs.data() + 2 * pair, 2);
    }
    if (n >= 10) {
        end -= 2;
        std::memcpy(end, kDigitPairs.data() + 2 * n, 2);
    } else {
        *--end = static_cast<char>('0' + n);
    }
    return end;
}

bool scaled_magnitude(double value, int decimals, std::uint64_t& scaled) {
    const double product = std::fabs(value) * kPowersOfTen[static_cast<std::size_t>(decimals)];
    // The product carries a rounding error of half a unit in its last place. Where its fraction is
    // farther from one half than that, the exact product rounds the same way; nearer than that the
    // exact decimal expansion has to decide, and the caller asks std::to_chars.
    if (!(product < kExactInteger / 8)) return false;
    const auto whole = static_cast<std::uint64_t>(product);
    const double fraction = product - static_cast<double>(whole);  // exact below 2^53
    constexpr double kEpsilon = 2.3e-16;                           // > 2^-52
    if (std::fabs(fraction - 0.5) <= (product + 1.0) * kEpsilon) return false;
    scaled = whole + (fraction > 0.5 ? 1 : 0);
    return true;
}

char* format_fixed(char* out, double value, int decimals) {
    KADR_ASSERT(decimals >= 0 && decimals <= kMaxDecimals, "0 to 9 decimals");
    std::uint64_t scaled = 0;
    if (!scaled_magnitude(value, decimals, scaled))
        return format_fixed_exactly(out, value, decimals);
    if (value < 0 && scaled != 0) *out++ = '-';

    std::array<char, 24> buffer;
    char* const end = buffer.data() + buffer.size();
    char* begin = write_digits_backwards(end, scaled);
    while (end - begin <= decimals) *--begin = '0';
    const std::ptrdiff_t whole = end - begin - decimals;
    std::memcpy(out, begin, static_cast<std::size_t>(whole));
    out += whole;
    if (decimals > 0) {
        *out++ = '.';
        std::memcpy(out, begin + whole, static_cast<std::size_t>(decimals));
        out += decimals;
    }
    return out;
}

double round_to(double value, int decimals) {
    std::uint64_t scaled = 0;
    if (scaled_magnitude(value, decimals, scaled)) {
        const double rounded =
            static_cast<double>(scaled) / kPowersOfTen[static_cast<std::size_t>(decimals)];
        return value < 0 && scaled != 0 ? -rounded : rounded;
    }
    std::array<char, kMaxFixedLength> text;
    char* const end = format_fixed_exactly(text.data(), value, decimals);
    double rounded = 0;
    std::from_chars(text.data(), end, rounded);
    return rounded;
}

Decimal parse_decimal(const char* begin, const char* end) {
    const char* p = begin;
    const bool has_sign = p != end && (*p == '-' || *p == '+');
    const bool is_negative = has_sign && *p == '-';
    if (has_sign) ++p;

    std::uint64_t mantissa = 0;
    const auto take_digits = [&] {
        // Beyond 19 digits the integer wraps; their number tells, and from_chars takes over.
        for (; p != end && static_cast<unsigned char>(*p - '0') <= 9; ++p)
            mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p - '0');
    };
    const char* const first_digit = p;
    take_digits();
    const char* const point = p;
    const bool has_point = p != end && *p == '.';
    if (has_point) {
        ++p;
        take_digits();
    }
    const std::ptrdiff_t decimals = has_point ? p - point - 1 : 0;
    std::ptrdiff_t digits = (point - first_digit) + decimals;
    if (digits == 0) return Decimal{.end = begin};
    for (const char* zero = first_digit; zero != p && (*zero == '0' || *zero == '.'); ++zero)
        digits -= *zero == '0' ? 1 : 0;

    // A mantissa below 2^53 and a power of ten up to 10^22 are exact; so is their quotient,
    // correctly rounded (Clinger 1990).
    double value = 0;
    if (digits <= 15 && decimals <= 22) {
        value = static_cast<double>(mantissa) / kPowersOfTen[static_cast<std::size_t>(decimals)];
    } else {
        const auto read = std::from_chars(first_digit, p, value, std::chars_format::fixed);
        // Correctly rounded, what is beyond all numbers is infinite; what is too small stays 0.
        const bool is_large = digits > decimals;
        if (read.ec == std::errc::result_out_of_range && is_large)
            value = std::numeric_limits<double>::infinity();
    }
    const auto count = [](std::ptrdiff_t n) {
        return static_cast<std::uint16_t>(std::min<std::ptrdiff_t>(n, 0xffff));
    };
    // Made in one piece: written field by field and then copied, it would wait for itself.
    return {is_negative ? -value : value, p, has_point, count(digits), count(decimals)};
}

void append_shortest(std::string& out, double value) {
    std::array<char, 32> text;
    if (value == 0) value = 0;  // no sign on zero
    // Where a person reads it, an exponent is for what is very large or very small.
    const double size = std::fabs(value);
    const bool is_ordinary = size >= 1e-5 && size < 1e15;
    const auto end = is_ordinary ? std::to_chars(text.data(), text.data() + text.size(), value,
                                                 std::chars_format::fixed)
                                 : std::to_chars(text.data(), text.data() + text.size(), value);
    out.append(text.data(), end.ptr);
}

std::string format_shortest(double value) {
    std::string text;
    append_shortest(text, value);
    return text;
}

}  // namespace kadr
