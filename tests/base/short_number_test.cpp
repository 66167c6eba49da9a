// The short way of reading numbers gives what the long one gives, or leaves it to that.
#include "base/short_number.h"

#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "base/numbers.h"

namespace short_number_test {

namespace {

using kadr::Decimal;
using kadr::parse_decimal;
using kadr::read_short_number;
using kadr::read_short_whole;
using kadr::ShortNumber;
using kadr::ShortWhole;

TEST(ShortNumber, Reads) {
    struct Row {
        const char* text;
        double value;
        std::size_t length;  // 0: left to the long way
    };
    for (const Row& row : {Row{"12.345 Y2", 12.345, 6},
                           {"-12.345Y2", -12.345, 7},
                           {"1234567 ", 1234567, 7},
                           {"12345678 ", 0, 0},
                           {"123.4567 ", 0, 0},
                           {"-123.456", -123.456, 8},
                           {".5 Y12345", 0.5, 2},
                           {"10. Y12345", 10, 3},
                           {"10..5 Y123", 10, 3},
                           {"7", 7, 1},
                           {"-7.5", -7.5, 4},
                           {"-0.000", -0.0, 6},
                           {". Y1234567", 0, 0},
                           {"- Y1234567", 0, 0},
                           {"-", 0, 0},
                           {"", 0, 0},
                           {"+5 Y123456", 0, 0},
                           {"#1 Y123456", 0, 0}}) {
        SCOPED_TRACE(row.text);
        const std::string line = row.text;
        const ShortNumber number = read_short_number(line.data(), line);
        if (row.length == 0) {
            EXPECT_EQ(number.end, nullptr);
            continue;
        }
        ASSERT_EQ(number.end, line.data() + row.length);
        EXPECT_EQ(number.value, row.value);
        EXPECT_EQ(std::signbit(number.value), std::signbit(row.value));
    }
}

TEST(ShortNumber, ReadsDigitsAlone) {
    for (const std::string line : {"G90.5 X1", "G90", "G90X12345"}) {
        SCOPED_TRACE(line);
        const ShortWhole whole = read_short_whole(line.data() + 1, line);
        EXPECT_EQ(whole.value, 90u);
        EXPECT_EQ(whole.end, line.data() + 3);
    }
    for (const std::string line : {"N", "N12345678", "N-1 X12345"})
        EXPECT_EQ(read_short_whole(line.data() + 1, line).end, nullptr) << line;
}

TEST(ShortNumber, AgreesWithTheLongWay) {
    std::mt19937 random(7);
    constexpr std::string_view kBytes = "0123456789012345678901234567890..-+ XE=";
    for (int i = 0; i < 200'000; ++i) {
        std::string line(1 + random() % 20, ' ');
        for (char& c : line) c = kBytes[random() % kBytes.size()];
        const char* const at = line.data() + random() % line.size();
        const Decimal expected = parse_decimal(at, line.data() + line.size());
        const ShortNumber number = read_short_number(at, line);
        if (number.end == nullptr) {
            const bool is_short = expected.end != at && *at != '+' && expected.end - at < 8;
            EXPECT_FALSE(is_short) << line;
            continue;
        }
        ASSERT_EQ(number.end, expected.end) << line;
        ASSERT_EQ(number.value, expected.value) << line;
    }
}

}  // namespace

}  // namespace short_number_test
