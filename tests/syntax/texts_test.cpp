// Strings with values in braces, raw text.
#include "parsing.h"

namespace kadr::syntax::texts_test {
namespace {

TEST(Texts, Strings) {
    for (const Row& row : {
             Row{R"("")", R"("")"},
             {R"("abc")", R"("abc")"},
             {R"("a\n\t\"\\\{\}")", "\"a\\n\t\\\"\\\\{}\""},
             {R"("{{x}}")", R"("{x}")"},
             {R"("{x}")", "(text x)"},
             {R"("{x:.3}")", "(text (format x .3))"},
             {R"("a {x} b {y:03} c")", R"((text "a " x " b " (format y 03) " c"))"},
             {R"("{a ? b : c}")", "(text (? a b c))"},
             {R"("{(a ? b : c):.1}")", "(text (format (? a b c) .1))"},
             {R"("{a ?? 2mm:.1u}")", "(text (format (?? a 2mm) .1u))"},
             {R"("{f(k: 2):+.1}")", "(text (format (call f k: 2) +.1))"},
             {R"("{p.x + 2mm:8.2}")", "(text (format (+ (. p x) 2mm) 8.2))"},
             {R"("Ø{d} мм")", R"((text "Ø" d " мм"))"},
             // Texts in the braces of a text.
             {R"x("{f("a")}")x", R"x((text (call f "a")))x"},
             {R"x("{f("a:b"):.1} c")x", R"x((text (format (call f "a:b") .1) " c"))x"},
             {R"x("{a ? "x {b}" : "y"}")x", R"x((text (? a (text "x " b) "y")))x"},
             {R"x("{s contains "{{" + "\""}")x", R"x((text (contains s (+ "{" "\""))))x"},
         }) {
        EXPECT_EQ(expression(row.text), row.expected) << row.text;
    }
}

TEST(Texts, Raw) {
    for (const Row& row : {
             Row{"raw \"G65 P9810 X{x} F300\";", "(raw (text \"G65 P9810 X\" x \" F300\"))"},
             {"raw { G65 P9810 }", "(raw \"G65 P9810\")"},
             {"raw { }", "(raw \"\")"},
             {"raw {\n    G65 P9810\n      (it's \"x\" #1)\n\n    M5\n};",
              "(raw \"G65 P9810\\n  (it's \\\"x\\\" #1)\\n\\nM5\")\n(empty)"},
             {"raw { A{1} }\nM8;", "(raw \"A{1}\")\n(words M8)"},
             {"raw {\n} M8;", "(raw \"\")\n(words M8)"},
         }) {
        EXPECT_EQ(statements(row.text), row.expected) << row.text;
    }
}

}  // namespace
}  // namespace kadr::syntax::texts_test
