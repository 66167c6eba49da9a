// Decimal text and back: byte for byte what printf writes, exactly what strtod reads.
#include "base/numbers.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace numbers_test {

namespace {

std::string fixed(double value, int decimals) {
    std::array<char, kadr::kMaxFixedLength> text;
    return {text.data(), kadr::format_fixed(text.data(), value, decimals)};
}

std::string printed(double value, int decimals) {
    std::array<char, 400> text;
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
    std::string result = text.data();
    if (result.find_first_not_of("-0.") == std::string::npos && result[0] == '-')
        result.erase(0, 1);
    return result;
}

TEST(Numbers, FormatFixedTable) {
    struct Row {
        double value;
        int decimals;
        const char* expected;
    };
    for (const Row& row : {Row{0, 3, "0.000"},
                           {-0.0001, 3, "0.000"},
                           {10, 0, "10"},
                           {0.5, 0, "0"},
                           {1.5, 0, "2"},
                           {2.5, 0, "2"},
                           {-2.5, 3, "-2.500"},
                           {0.0005, 3, "0.001"},
                           {1.0005, 3, "1.000"},
                           {999999.9995, 3, "1000000.000"},
                           {1e20, 2, "100000000000000000000.00"},
                           {-1e-9, 9, "-0.000000001"}}) {
        EXPECT_EQ(fixed(row.value, row.decimals), row.expected) << row.value;
    }
}

TEST(Numbers, FormatFixedIsPrintf) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> wide(-1e7, 1e7), narrow(-1, 1);
    std::uniform_int_distribution<int> places(0, 9), half(-200000, 200000);
    for (int i = 0; i < 200000; ++i) {
        const int decimals = places(random);
        for (const double value :
             {wide(random), narrow(random), half(random) / 2.0, half(random) / 2000.0}) {
            ASSERT_EQ(fixed(value, decimals), printed(value, decimals)) << value;
            ASSERT_EQ(kadr::round_to(value, decimals),
                      std::strtod(printed(value, decimals).c_str(), nullptr));
        }
    }
}

TEST(Numbers, ParseDecimalTable) {
    struct Row {
        const char* text;
        double value;
        std::size_t length;
        bool point;
        int decimals;
    };
    for (const Row& row : {Row{"10", 10, 2, false, 0},
                           {"-5.25Y", -5.25, 5, true, 2},
                           {"+.5", 0.5, 3, true, 1},
                           {"10.", 10, 3, true, 0},
                           {".", 0, 0, false, 0},
                           {"-", 0, 0, false, 0},
                           {"X", 0, 0, false, 0},
                           {"", 0, 0, false, 0},
                           {"1E3", 1, 1, false, 0},
                           {"-0", -0.0, 2, false, 0},
                           {"12345678901234567890.5", 12345678901234567890.5, 22, true, 1}}) {
        const std::string text = row.text;
        const kadr::Decimal d = kadr::parse_decimal(text.data(), text.data() + text.size());
        EXPECT_EQ(d.value, row.value) << text;
        EXPECT_EQ(static_cast<std::size_t>(d.end - text.data()), row.length) << text;
        EXPECT_EQ(d.has_point, row.point) << text;
        EXPECT_EQ(d.decimals, row.decimals) << text;
    }
}

TEST(Numbers, ParseDecimalIsStrtod) {
    std::mt19937_64 random(2);
    std::uniform_int_distribution<int> length(1, 18), digit(0, 9);
    for (int i = 0; i < 200000; ++i) {
        std::string text = digit(random) < 3 ? "-" : "";
        for (int k = length(random); k > 0; --k) text += static_cast<char>('0' + digit(random));
        text += '.';
        for (int k = length(random); k > 0; --k) text += static_cast<char>('0' + digit(random));
        ASSERT_EQ(kadr::parse_decimal(text.data(), text.data() + text.size()).value,
                  std::strtod(text.c_str(), nullptr))
            << text;
    }
}

}  // namespace

}  // namespace numbers_test
