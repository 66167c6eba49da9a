// amount.h — numbers with units as the command line has them.
#pragma once

#include <optional>
#include <string_view>

namespace kadr::driver {

/// A number and what stands behind it, blanks around it left out: `4 ms`.
struct Amount {
    double value = 0;
    std::string_view unit;  // empty: none
};

/// Nothing: the text does not begin with a number.
std::optional<Amount> amount_of(std::string_view text);

/// Seconds of `1ms`, `0.002s`, `500us`, `2min`. Nothing: it is no time above 0; a bare number could
/// be seconds or milliseconds, and is none either.
std::optional<double> seconds_of(std::string_view text);

}  // namespace kadr::driver
