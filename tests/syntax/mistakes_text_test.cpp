// Mistakes in characters, texts and numbers: wrong programs and what is said about them.
#include "parsing.h"

namespace kadr::syntax::mistakes_text_test {
namespace {

TEST(TextMistakes, Texts) {
    expect_messages({
        {R"(cycle a() { note "first side; })", "1:18 K1008 the string is not closed"},
        {R"(cycle a() { note("first side); })", "1:18 K1008 the string is not closed"},
        {"cycle a() { note 'first side'; }", "1:18 K1009 strings stand in straight double quotes"},
        {R"(cycle a() { note "C:\parts"; })", "1:21 K1010 `\\p` means nothing in a string"},
        {R"(cycle a() { note "set {1"; })", "1:23 K1011 `{` stands alone in a string"},
        {R"(cycle a() { note "set 1}"; })", "1:24 K1011 `}` stands alone in a string"},
        {R"x(cycle a() { note "a { b" + "c"; })x", "1:21 K1011 `{` stands alone in a string"},
        {R"x(cycle a() { note "{" + "c"; })x", "1:19 K1011 `{` stands alone in a string"},
        {R"x(cycle a() { note "{f(\"a\")}"; })x",
         "1:22 K1023 a quote inside the braces of a string stands without a backslash"},
        {R"(cycle a() { note "{x:3f}"; })", "1:21 K1012 `3f` is no format of a number"},
        {"cycle a() { /* first side }", "1:13 K1013 the comment is not closed"},
        {R"(test "{n} holes" { })", "1:6 K1015 this string cannot hold values"},
        {"cycle a() { a = “x”; }", "1:17 K1009 strings stand in straight double quotes"},
        {R"(cycle a() { x = "a" + 'b'; })", "1:23 K1009 strings stand in straight double quotes"},
        {"cycle a() { raw { G65", "1:17 K1014 the raw text is not closed"},
        {R"(cycle a() { raw "abc; })", "1:17 K1008 the string is not closed"},
    });
}

TEST(TextMistakes, Numbers) {
    expect_messages({
        {"cycle a() { G1 X1.2.5; }", "1:16 K1016 `X1.2.5` is no number"},
        {"int n = 99999999999999999999;",
         "1:9 K1017 the number `99999999999999999999` is too large"},
        {"length d = 5millimetres;", "1:13 K1018 `millimetres` is no unit"},
        {"cycle a() { x = 1.2.3; y = 5mmm; }",
         "1:17 K1016 `1.2.3` is no number\n"
         "1:29 K1018 `mmm` is no unit"},
        {"cycle a() { int 2a = 5; }", "1:18 K1018 `a` is no unit"},
    });
}

TEST(TextMistakes, Letters) {
    expect_messages({
        {"cycle a() { G1 Х10; }",
         "1:16 K1019 `Х10` is written with Cyrillic letters; the word is `X10`"},
        {"cycle a() { М8; }", "1:13 K1019 `М8` is written with Cyrillic letters; the word is `M8`"},
        {"cycle a() { #100 = 5; }", "1:13 K1007 `#` has no meaning in a Kadr program"},
        {R"(language ru;
цикл a() { if (n > 0) M8; })",
         "2:12 K1020 `if` is `если` in the keyword language `ru`"},
        {"cycle a() { G0 X−5; }", "1:17 K1006 the character `−` has no meaning here"},
        {"cycle a() { x = @; }", "1:17 K1006 the character `@` has no meaning here"},
        {"cycle a() { x = 5 @@ 6; y = $; }",
         "1:19 K1006 the character `@` has no meaning here\n"
         "1:29 K1006 the character `$` has no meaning here"},
    });
}

}  // namespace
}  // namespace kadr::syntax::mistakes_text_test
