// Every statement of the language, and how statements nest.
#include "parsing.h"

namespace kadr::syntax::statements_test {
namespace {

TEST(Statements, Simple) {
    for (const Row& row : {
             Row{";", "(empty)"},
             {"break;", "(break)"},
             {"continue;", "(continue)"},
             {"return;", "(return)"},
             {"return a + 1;", "(return (+ a 1))"},
             {"close;", "(close)"},
             {"f(5);", "(do (call f 5))"},
             {"/G1 X5;", "(words skip G1 X5)"},
             {"/2 X5;", "(words skip2 X5)"},
             {"/2G1 X5;", "(words skip2 G1 X5)"},
             {"if (a) /X=b/2;", "(if a\n  (words skip (X= (/ b 2))))"},
             {"G1 p*2 - q;", "(words G1 (- (* p 2) q))"},
             {"i++;", "(do (post++ i))"},
             {"a[i].x = 5;", "(do (= (. (index a i) x) 5))"},
             {"x += 1;", "(do (+= x 1))"},
             {"x -= 1;", "(do (-= x 1))"},
             {"x *= 2;", "(do (*= x 2))"},
             {"x /= 2;", "(do (/= x 2))"},
             {"x %= 2;", "(do (%= x 2))"},
             {"x <<= 2;", "(do (<<= x 2))"},
             {"x >>= 2;", "(do (>>= x 2))"},
             {"x &= y | 1;", "(do (&= x (| y 1)))"},
             {"x ^= y;", "(do (^= x y))"},
             {"x |= y;", "(do (|= x y))"},
             {"note \"a\";", "(note \"a\")"},
             {"note(\"a\");", "(note \"a\")"},
             {"comment(\"a\");", "(note \"a\")"},
             {"comment = 5;", "(do (= comment 5))"},
             {"note title;", "(note title)"},
             {"units inch;", "(units inch)"},
             {"units in;", "(units inch)"},
             {"require(a > 0);", "(require (> a 0))"},
             {"require(a > 0, \"no\");", "(require (> a 0) \"no\")"},
             {"assert(a == b, \"no\");", "(assert (== a b) \"no\")"},
             {"error(\"no\");", "(error \"no\")"},
             {"warn(\"hm\");", "(warn \"hm\")"},
             {"expect(a < b);", "(expect (< a b))"},
             {"assume(a != b);", "(assume (!= a b))"},
             {"{ M8; { M9; } }", "(block\n  (words M8)\n  (block\n    (words M9)))"},
         }) {
        EXPECT_EQ(statements(row.text), row.expected) << row.text;
    }
}

TEST(Statements, Variables) {
    for (const Row& row : {
             Row{"length r = 5;", "(var length r 5)"},
             {"int i;", "(var int i)"},
             {"const real k = 1.5;", "(var const real k 1.5)"},
             {"auto v = f(1);", "(var auto v (call f 1))"},
             {"const auto v = 1;", "(var const auto v 1)"},
             {"length[] radii = {5, 8, 12};", "(var length[] radii (braces 5 8 12))"},
             {"real[8] r;", "(var real[8] r)"},
             {"hole[n + 1] h;", "(var hole[(+ n 1)] h)"},
             {"length? b;", "(var length? b)"},
             {"length? b = 5;", "(var length? b 5)"},
             {"point& p = list[3];", "(var point& p (index list 3))"},
             {"point p = {10mm, 20mm};", "(var point p (braces 10mm 20mm))"},
             {"contour c = { G1 X0; close; };", "(contour c\n  (words G1 X0)\n  (close))"},
             {"a ? b : c;", "(do (? a b c))"},
             {"time = 5;", "(do (= time 5))"},
             {"real error = 0;", "(var real error 0)"},
             {"error = 5;", "(do (= error 5))"},
             {"int test = note + raw;", "(var int test (+ note raw))"},
         }) {
        EXPECT_EQ(statements(row.text), row.expected) << row.text;
    }
}

TEST(Statements, Branches) {
    EXPECT_EQ(statements("if (a) M8;"), "(if a\n  (words M8))");
    EXPECT_EQ(statements("if (a) { M8; } else { M9; }"),
              "(if a\n  (block\n    (words M8))\n  (block\n    (words M9)))");
    // An `else` belongs to the nearest `if`.
    EXPECT_EQ(statements("if (a) if (b) M8; else M9;"),
              "(if a\n  (if b\n    (words M8)\n    (words M9)))");
    EXPECT_EQ(statements("if (a) M8; else if (b) M9; else M3;"),
              "(if a\n  (words M8)\n  (if b\n    (words M9)\n    (words M3)))");
    EXPECT_EQ(statements("switch (n) { case 1: M8; break; case 2, 4 .. 6: { M9; } default: M3; }"),
              "(switch n\n"
              "  (case 1\n    (words M8)\n    (break))\n"
              "  (case 2 (.. 4 6)\n    (block\n      (words M9)))\n"
              "  (case default\n    (words M3)))");
}

TEST(Statements, Loops) {
    EXPECT_EQ(statements("while (i < 3) i++;"), "(while (< i 3)\n  (do (post++ i)))");
    EXPECT_EQ(statements("do { i++; } while (i < 3);"),
              "(do-while (< i 3)\n  (block\n    (do (post++ i))))");
    EXPECT_EQ(statements("for (int i = 0; i < n; ++i) X=i;"),
              "(for\n  (var int i 0) (< i n) (pre++ i)\n  (words (X= i)))");
    EXPECT_EQ(statements("for (i = 0; ; i += 2) ;"), "(for\n  (do (= i 0)) _ (+= i 2)\n  (empty))");
    EXPECT_EQ(statements("for (;;) break;"), "(for _ _\n  (break))");
    EXPECT_EQ(statements("for (auto i = 0; i < 3; i++) ;"),
              "(for\n  (var auto i 0) (< i 3) (post++ i)\n  (empty))");
    EXPECT_EQ(statements("for (hole h : table<hole>(\"f.csv\")) drill(h.d);"),
              "(for-each hole h (call table<hole> \"f.csv\")\n  (do (call drill (. h d))))");
    EXPECT_EQ(statements("for (auto r : {1, 2}) X=r;"),
              "(for-each auto r (braces 1 2)\n  (words (X= r)))");
    EXPECT_EQ(statements("for (hole& h : holes) h.d = 1;"),
              "(for-each hole& h holes\n  (do (= (. h d) 1)))");
    EXPECT_EQ(statements("for (int i : 1 .. 5) X=i;"),
              "(for-each int i (.. 1 5)\n  (words (X= i)))");
}

TEST(Statements, With) {
    EXPECT_EQ(statements("with G91 { X5; }"), "(with G91\n  (block\n    (words X5)))");
    EXPECT_EQ(statements("with G95, F0.1 { X5; }"), "(with G95 F0.1\n  (block\n    (words X5)))");
    EXPECT_EQ(statements("with F=f { X5; }"), "(with (F= f)\n  (block\n    (words X5)))");
    EXPECT_EQ(statements("with shift(x: 10mm) rotate(30deg) { X5; }"),
              "(with (call shift x: 10mm) (call rotate 30deg)\n  (block\n    (words X5)))");
    EXPECT_EQ(statements("with G91, shift(x: 1) { }"), "(with G91 (call shift x: 1)\n  (block))");
}

TEST(Statements, LinesOfOneBlock) {
    // A deeper line goes on with the block; `{`, `else` and operators may stand anywhere.
    EXPECT_EQ(statements("    G1 X10\n      Y20;"), "(words G1 X10 Y20)");
    EXPECT_EQ(statements("if (a)\n{\nM8;\n}\nelse\nM9;"),
              "(if a\n  (block\n    (words M8))\n  (words M9))");
    EXPECT_EQ(statements("x = a\n+ b;"), "(do (= x (+ a b)))");
    EXPECT_EQ(statements("if (a) G1 X10;\nG0 Z5;"), "(if a\n  (words G1 X10))\n(words G0 Z5)");
}

}  // namespace
}  // namespace kadr::syntax::statements_test
