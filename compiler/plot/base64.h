// base64.h — columns of numbers as text (RFC 4648), little-endian.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <string>

namespace kadr::plot {

inline std::string base64_of(std::span<const std::uint8_t> bytes) {
    constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t left = bytes.size() - i;
        std::uint32_t group = static_cast<std::uint32_t>(bytes[i]) << 16u;
        if (left > 1) group |= static_cast<std::uint32_t>(bytes[i + 1]) << 8u;
        if (left > 2) group |= bytes[i + 2];
        out += kDigits[group >> 18u];
        out += kDigits[group >> 12u & 63u];
        out += left > 1 ? kDigits[group >> 6u & 63u] : '=';
        out += left > 2 ? kDigits[group & 63u] : '=';
    }
    return out;
}

template <typename T>
std::string base64_of(std::span<const T> numbers) {
    static_assert(std::endian::native == std::endian::little);
    return base64_of(std::span<const std::uint8_t>(
        reinterpret_cast<const std::uint8_t*>(numbers.data()), numbers.size_bytes()));
}

}  // namespace kadr::plot
