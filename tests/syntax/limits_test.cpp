// Deep nesting, rubbish, large files: a message, in short time, and never a crash.
#include <random>

#include "parsing.h"

namespace kadr::syntax::limits_test {
namespace {

std::string repeated(const std::string& text, int times) {
    std::string out;
    for (int i = 0; i < times; ++i) out += text;
    return out;
}

TEST(Limits, NestingThatIsAllowed) {
    const auto accepts = [](const std::string& text) {
        return Parsed("cycle a() {" + text + "}").messages();
    };
    EXPECT_EQ(accepts("x = " + repeated("(", 400) + "1" + repeated(")", 400) + ";"), "");
    EXPECT_EQ(accepts(repeated("{", 400) + repeated("}", 400)), "");
    // Chains may be of any length: they lean to the left and are walked by loops.
    EXPECT_EQ(accepts("x = 1" + repeated(" + 1", 50'000) + ";"), "");
    EXPECT_EQ(accepts("x = a" + repeated(" * 2 - b % c", 20'000) + ";"), "");
    EXPECT_EQ(accepts("note \"a\"" + repeated(" + \"b\"", 50'000) + ";"), "");
    EXPECT_EQ(accepts(repeated("if (a) M8; else ", 200) + "M9;"), "");
}

TEST(Limits, NestingTooDeep) {
    for (const std::string& text : {
             "x = " + repeated("(", 20000) + "1" + repeated(")", 20000) + ";",
             repeated("{", 20000) + repeated("}", 20000),
             repeated("if (a) ", 20000) + "M8;",
             repeated("if (a) M8; else ", 20000) + "M9;",
             repeated("if (a) { M8; } else ", 20000) + "M9;",
             repeated("while (a) ", 20000) + ";",
             repeated("do ", 20000) + ";",
             "x = " + repeated("a[", 20000) + ";",
             "x = " + repeated("{", 20000) + ";",
             "x = " + repeated("f(", 20000) + ";",
             "x = " + repeated("-", 20000) + "1;",
             "x = " + repeated("!", 20000) + "1;",
             "x = 1" + repeated(" + (1", 20000) + repeated(")", 20000) + ";",
             "x = 1" + repeated(" < 1", 20000) + ";",
             "x = 1" + repeated(" && 1", 20000) + ";",
             "x = a" + repeated(".b", 20000) + ";",
             "x = a" + repeated("(1)", 20000) + ";",
             "x = " + repeated("a ? b : ", 20000) + "c;",
             "x = " + repeated("a ? ", 20000) + "c;",
             "x = a" + repeated(" ?? b", 20000) + ";",
         }) {
        const Parsed result("cycle a() {" + text + "}");
        EXPECT_NE(result.messages().find("K1005 this is nested more than 500 deep"),
                  std::string::npos)
            << text.substr(0, 40) << '\n'
            << result.messages();
    }
}

TEST(Limits, NotText) {
    EXPECT_EQ(Parsed(std::string("int a;\0int b;", 13)).messages(),
              "1:7 K1001 the byte 0x00 is no text");
    EXPECT_EQ(Parsed("int a; // \xC3(").messages(), "1:11 K1001 the byte 0xC3 is no text");
    EXPECT_EQ(Parsed("int a; // \xED\xA0\x80").messages(), "1:11 K1001 the byte 0xED is no text");
    EXPECT_EQ(Parsed("int \x01\x02\x03 a;").messages(), "1:5 K1001 the byte 0x01 is no text");
    // A Cyrillic source in another character set, or no source at all.
    const std::string messages = Parsed(repeated("\xEF \xF0 \xE8 ", 20)).messages();
    EXPECT_NE(messages.find("K1002 the file is not UTF-8 text"), std::string::npos);
}

TEST(Limits, TooLarge) {
    const Parsed result("cycle a() {" + std::string(9u << 20, ' ') + "}");
    EXPECT_EQ(result.messages(), "1:1 K1003 the source is too long");
    const Parsed many("cycle a() {" + std::string(2'000'000, ';') + "}");
    EXPECT_NE(many.messages().find("K1003 the source is too long"), std::string::npos);
}

TEST(Limits, ManyErrorsEnd) {
    const Parsed result("cycle a() {" + repeated("x = * ;\n", 1000) + "}");
    EXPECT_EQ(result.list.all().size(), 51u);
    EXPECT_EQ(result.list.all().back().message(),
              "more than 50 errors; what follows is not looked at");
}

TEST(Limits, RubbishIsSurvived) {
    std::mt19937 random(20240607);
    const std::string_view alphabet = "abXG10 .,;:(){}[]<>=+-*/%!&|?\"'\\#@\n\tifelse";
    for (int round = 0; round < 400; ++round) {
        std::string text = round % 2 == 0 ? "" : "cycle a() {";
        const std::size_t length = random() % 400;
        for (std::size_t i = 0; i < length; ++i) text += alphabet[random() % alphabet.size()];
        (void)Parsed(text).messages();
    }
    // Pieces of programs in any order come further.
    const char* pieces[] = {
        "if",    "(",      ")",     "{",       "}",       "x",     "=",    ";",      "G1",
        "X10",   "X=",     "for",   "int",     "else",    "5",     "\"a{", "}\"",    "\"b\"",
        "case",  "switch", ":",     "?",       ",",       "cycle", "with", "return", "[",
        "]",     ".",      "..",    "test",    "struct",  "enum",  "raw",  "do",     "while",
        "const", "auto",   "-",     "+",       "&",       "<",     ">",    "\n",     "preserves",
        "over",  "in",     "given", "contour", "default", "AC",    "//",   "/*"};
    for (int round = 0; round < 3000; ++round) {
        std::string text = round % 3 == 0 ? "" : "cycle a() { ";
        const std::size_t count = random() % 60;
        for (std::size_t i = 0; i < count; ++i) {
            text += pieces[random() % std::size(pieces)];
            text += ' ';
        }
        const Parsed result(text);
        (void)dump(result.ast);
        EXPECT_LE(result.list.all().size(), 51u);
    }
}

TEST(Limits, ASourceCutAnywhereIsSurvived) {
    const std::string whole =
        "/// Doc\ncycle a(length d, int n = 3) preserves G90 { for (int i = 0; i < n; i++) {"
        " if (i % 2 == 0) G0 X=d*cos(a) Y{1}; else drill(to: -5mm); } note \"a {d:.2} b\";"
        " with shift(x: 1) { X+=5; } raw { M5 } switch (n) { case 1: M8; default: ; } }\n"
        "struct hole { point at; } enum e { a, b } test \"x\" { expect(a contains \"b\"); }";
    for (std::size_t length = 0; length <= whole.size(); ++length) {
        const Parsed result(whole.substr(0, length));
        (void)dump(result.ast);
    }
}

}  // namespace
}  // namespace kadr::syntax::limits_test
