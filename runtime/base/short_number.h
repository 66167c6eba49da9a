// short_number.h — the numbers that nearly all words carry, read in one step: `-12.345`.
//
// Digit after digit costs a branch for each, and a mispredicted one wherever a number is longer or
// shorter than the last. Here eight bytes are looked at together.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace kadr {

/// Eight bytes of a line from an index on, the first one lowest; behind its end stand zeros.
class ByteWindow {
  public:
    static constexpr std::size_t kSize = 8;

    /// at  an index in the line, before its end
    ByteWindow(const char* at, std::string_view line) {
        const char* const end = line.data() + line.size();
        if (line.size() >= kSize) {
            const char* const from = std::min(at, end - kSize);
            std::memcpy(&bytes_, from, kSize);
            if constexpr (std::endian::native == std::endian::big)
                bytes_ = __builtin_bswap64(bytes_);
            bytes_ >>= 8 * (at - from);
            return;
        }
        for (const char* p = end; p != at; --p)
            bytes_ = bytes_ << 8 | static_cast<unsigned char>(p[-1]);
    }

    /// The highest bit of each byte that is no digit; behind the first of them only that of the
    /// next one is certain, and only if the first is a point. 0: there are eight digits.
    std::uint64_t ends_of_digits() const {
        const std::uint64_t values = bytes_ ^ kOnes * '0';  // of digits: 0 to 9
        return ((values + kOnes * (0x80 - 10)) | values) & kHighest;
    }
    /// The highest bit of each byte that is a point; above the lowest of them none is certain.
    std::uint64_t points() const {
        const std::uint64_t others = bytes_ ^ kOnes * '.';
        return (others - kOnes) & ~others & kHighest;
    }
    /// The bytes without the one that `mark` is the highest bit of: those before it move onto it,
    /// and 0 stands first.
    std::uint64_t without(std::uint64_t mark) const {
        const std::uint64_t before = (mark >> 7) - 1;
        return (bytes_ & before) << 8 | (bytes_ & ~(before << 8 | 0xff));
    }
    std::uint64_t bytes() const { return bytes_; }

  private:
    static constexpr std::uint64_t kOnes = 0x0101010101010101;
    static constexpr std::uint64_t kHighest = kOnes * 0x80;

    std::uint64_t bytes_ = 0;
};

/// The whole number that the first `count` of eight bytes are, 1 to 8; 0 is a digit as '0' is.
constexpr std::uint64_t number_of_digits(std::uint64_t bytes, unsigned count) {
    // The last digit becomes the highest byte, with zeros before the first. Then each step joins
    // neighbours: numbers of two digits, of four, of eight. 2561 is 10·2⁸ + 1, the others are
    // alike.
    bytes = bytes << (64 - 8 * count) & 0x0f0f0f0f0f0f0f0f;
    bytes = (bytes * 2561 >> 8) & 0x00ff00ff00ff00ff;
    bytes = (bytes * 6553601 >> 16) & 0x0000ffff0000ffff;
    return bytes * 42949672960001 >> 32;
}

/// How many bytes stand before the one that `mark` is the highest bit of.
constexpr unsigned bytes_before(std::uint64_t mark) {
    return static_cast<unsigned>(std::countr_zero(mark)) / 8;
}

/// A number of a line and where it ends.
struct ShortNumber {
    double value = 0;           // the nearest double
    const char* end = nullptr;  // nullptr: there is none, or it needs a closer look
};

struct ShortWhole {
    std::uint64_t value = 0;
    const char* end = nullptr;
};

/// The number at `at`, an index in the line: `-12.345`, with no more than seven bytes behind its
/// sign. In a function of its own: it needs most registers.
ShortNumber read_short_number(const char* at, std::string_view line);
/// Digits alone, no more than seven; what stands behind them is not looked at.
ShortWhole read_short_whole(const char* at, std::string_view line);

}  // namespace kadr
