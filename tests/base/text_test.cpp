// Characters of UTF-8 texts, and of those that are none.
#include "base/text.h"

#include <gtest/gtest.h>

namespace text_test {

namespace {

using kadr::utf8_text;

TEST(Characters, AreWrittenAndReadBack) {
    for (const char32_t code : {U'a', U'\x7f', U'\x80', U'ö', U'\x7ff', U'\x800', U'€', U'\xffff',
                                U'\x10000', U'\x10ffff'}) {
        std::string text;
        kadr::append_code_point(text, code);
        EXPECT_EQ(kadr::first_code_point(text), code);
        EXPECT_EQ(kadr::count_code_points(text), 1u);
        EXPECT_EQ(utf8_text(text), text);
    }
}

/// Half a character, a tail alone, a longer form of a short one, half of a pair, beyond the last.
TEST(Characters, MalformedBytesAreLatin) {
    EXPECT_EQ(utf8_text("Gr\xf6\xdf"
                        "e"),
              "Größe");
    EXPECT_EQ(utf8_text("a\xc3"), "aÃ");
    EXPECT_EQ(utf8_text("\x80"), "\xc2\x80");
    EXPECT_EQ(utf8_text("\xc0\x80"), "À\xc2\x80");
    EXPECT_EQ(utf8_text("\xe0\x80\x80"), "à\xc2\x80\xc2\x80");
    EXPECT_EQ(utf8_text("\xed\xa0\x80"), "í\xc2\xa0\xc2\x80");
    EXPECT_EQ(utf8_text("\xf4\x90\x80\x80"), "ô\xc2\x90\xc2\x80\xc2\x80");
    EXPECT_EQ(utf8_text("plain"), "plain");
}

TEST(Characters, CaseOfLetters) {
    EXPECT_EQ(kadr::upper_letters("aäÿ÷ß я ѐ 1"), "AÄÿ÷ß Я Ѐ 1");
    EXPECT_EQ(kadr::lower_letters("AÄ×Þ Я Ѐ 1"), "aä×þ я ѐ 1");
}

}  // namespace

}  // namespace text_test
