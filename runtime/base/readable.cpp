#include "base/readable.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/numbers.h"

namespace kadr {

std::string readable(double value) {
    constexpr int kDecimals = 6;
    constexpr int kMostDigits = 12;
    constexpr double kLeast = 1e-9;
    constexpr double kGreatest = 1e12;
    const double size = std::fabs(value);
    std::array<char, 40> text{};
    char* const begin = text.data();
    if (value == 0) return "0";  // no minus before it
    if (!(size >= kLeast && size < kGreatest)) {
        const auto end =
            std::to_chars(begin, begin + text.size(), value, std::chars_format::general,
                          size < kLeast ? kDecimals : kMostDigits);
        return {begin, end.ptr};
    }
    const int before_point = static_cast<int>(std::floor(std::log10(size))) + 1;
    const int decimals =
        std::clamp(kDecimals, kDecimals - before_point, kMostDigits - before_point);
    const auto end =
        std::to_chars(begin, begin + text.size(), value, std::chars_format::fixed, decimals);
    std::string out(begin, end.ptr);
    if (out.find('.') != std::string::npos) {
        out.erase(out.find_last_not_of('0') + 1);
        if (out.ends_with('.')) out.pop_back();
    }
    return out;
}

}  // namespace kadr
