#include "base/short_number.h"

#include "base/powers.h"

namespace kadr {

namespace {

/// Of a number below 2⁶³, for which the processor has an instruction.
double to_double(std::uint64_t value) {
    return static_cast<double>(static_cast<std::int64_t>(value));
}

/// The digits of the window, which is at `at`; `ends` are its ends of digits.
inline ShortWhole whole_of(const ByteWindow& window, std::uint64_t ends, const char* at) {
    const unsigned length = bytes_before(ends);
    if (ends == 0 || length == 0) return {};
    return {number_of_digits(window.bytes(), length), at + length};
}

}  // namespace

ShortWhole read_short_whole(const char* at, std::string_view line) {
    if (at == line.data() + line.size()) return {};
    const ByteWindow window(at, line);
    return whole_of(window, window.ends_of_digits(), at);
}

ShortNumber read_short_number(const char* at, std::string_view line) {
    const char* const end = line.data() + line.size();
    const bool is_negative = at != end && *at == '-';
    if (is_negative) ++at;
    if (at == end) return {};
    const ByteWindow window(at, line);
    const std::uint64_t ends = window.ends_of_digits();
    const std::uint64_t point = ends & -ends;
    if ((window.points() & point) == 0) {
        const ShortWhole whole = whole_of(window, ends, at);
        const double value = to_double(whole.value);
        return {is_negative ? -value : value, whole.end};
    }
    const std::uint64_t rest = ends ^ point;
    const unsigned length = bytes_before(rest);
    if (rest == 0 || length == 1) return {};  // it goes on, or is a point alone
    const unsigned decimals = length - bytes_before(point) - 1;
    // The quotient of two exact numbers is the nearest double.
    const double value =
        to_double(number_of_digits(window.without(point), length)) / kPowersOfTen[decimals];
    return {is_negative ? -value : value, at + length};
}

}  // namespace kadr
