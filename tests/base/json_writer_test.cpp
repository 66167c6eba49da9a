#include "base/json_writer.h"

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "base/numbers.h"

namespace json_writer_test {

namespace {

using kadr::JsonStyle;
using kadr::JsonWriter;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string text_of(std::string_view text, JsonStyle style = JsonStyle::Compact) {
    std::string out;
    JsonWriter(out, style).value(text);
    return out;
}

TEST(JsonWriter, CommasComeByThemselves) {
    std::string out = "before ";
    JsonWriter json(out);
    json.object([&] {
        json.key("none").object([&] {});
        json.key("few").array([&] {
            json.value(1).value("two").value(true).null();
            json.array([&] {});
            json.object([&] { json.key_of("a\"b").value(-3); });
        });
        json.key("last").value(false);
    });
    json.end_line();
    json.object([&] {});
    EXPECT_EQ(out, R"(before {"none":{},"few":[1,"two",true,null,[],{"a\"b":-3}],"last":false})"
                   "\n{}");
}

TEST(JsonWriter, MembersOnLinesOfTheirOwn) {
    const auto written = [](int count) {
        std::string out;
        JsonWriter json(out, JsonStyle::Lines);
        json.object([&] {
            for (int i = 0; i < count; ++i) json.key_of("R" + std::to_string(i)).value(i);
        });
        return out;
    };
    EXPECT_EQ(written(0), "{}");
    EXPECT_EQ(written(2), "{\n \"R0\": 0,\n \"R1\": 1\n}");
}

TEST(JsonWriter, TextsAreEscapedWhereTheyMustBe) {
    EXPECT_EQ(text_of("plain кадр"), "\"plain кадр\"");
    EXPECT_EQ(text_of("a\xFF\n\x01"), "\"a\xEF\xBF\xBD\\n\\u0001\"");
    EXPECT_EQ(text_of("\"\\\t\x1f\x7f"), "\"\\\"\\\\\\u0009\\u001f\x7f\"");
    EXPECT_EQ(text_of("\xC3"), "\"\xEF\xBF\xBD\"") << "cut in a character";
    EXPECT_EQ(text_of("\xC0\xAF"), "\"\xEF\xBF\xBD\xEF\xBF\xBD\"") << "overlong";
    EXPECT_EQ(text_of("\xF0\x9F\x94\xA7"), "\"\xF0\x9F\x94\xA7\"");
    EXPECT_EQ(text_of("</script>"), "\"</script>\"");
    EXPECT_EQ(text_of("</script>", JsonStyle::Script), "\"\\u003c/script>\"");
}

TEST(JsonWriter, Numbers) {
    struct Row {
        double value;
        const char* number;
        const char* coordinate;
        const char* general;
    };
    for (const Row& row : {
             Row{0, "0", "0", "0"},
             Row{-0.0, "0", "0", "-0"},
             Row{0.1, "0.1", "0.1", "0.1"},
             Row{-12.5, "-12.5", "-12.5", "-12.5"},
             Row{200000, "200000", "200000", "200000"},
             Row{1e-5, "0.00001", "0.00001", "1e-05"},
             Row{1e-9, "1e-09", "0.000000001", "1e-09"},
             Row{0.30000000000000004, "0.30000000000000004", "0.3", "0.30000000000000004"},
             Row{999999.9999999999, "999999.9999999999", "1000000", "999999.9999999999"},
             Row{1234567.125, "1234567.125", "1234567.125", "1234567.125"},
             Row{1e15, "1e+15", "1e+15", "1000000000000000"},
             Row{1e16, "1e+16", "1e+16", "1e+16"},
             Row{kInfinity, "null", "null", "null"},
             Row{std::nan(""), "null", "null", "null"},
         }) {
        SCOPED_TRACE(row.number);
        std::string out;
        JsonWriter json(out);
        json.array([&] { json.number(row.value).coordinate(row.value).general(row.value); });
        EXPECT_EQ(out,
                  '[' + std::string(row.number) + ',' + row.coordinate + ',' + row.general + ']');
    }
    std::string out;
    JsonWriter json(out);
    json.array([&] {
        json.rounded(2.0 / 3, 3).rounded(-1e-7, 6).rounded(kInfinity, 9);
        json.value(std::numeric_limits<std::uint64_t>::max());
        json.value(std::numeric_limits<std::int64_t>::min());
    });
    EXPECT_EQ(out, "[0.667,0,null,18446744073709551615,-9223372036854775808]");
}

/// The quick way gives what the exact one gives, to the nine decimals that it has.
TEST(JsonWriter, CoordinatesAreRoundedAsEverywhere) {
    std::mt19937_64 random(29);
    std::uniform_real_distribution<double> size(-6, 7);
    for (int i = 0; i < 100'000; ++i) {
        const double value = (i % 2 == 0 ? 1 : -1) * std::pow(10, size(random));
        std::string quick;
        JsonWriter(quick).coordinate(value);
        // Only a tie of the ten-thousandth of a micrometre could differ, and random ones are none.
        EXPECT_NEAR(std::strtod(quick.c_str(), nullptr), kadr::round_to(value, 9), 1.1e-9) << i;
        std::string general;
        JsonWriter(general).general(value);
        EXPECT_EQ(std::strtod(general.c_str(), nullptr), value) << general;
    }
}

}  // namespace

}  // namespace json_writer_test
