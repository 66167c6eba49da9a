// Words of NC blocks: literals, computed values, modes, points.
#include "parsing.h"

namespace kadr::syntax::words_test {
namespace {

TEST(Words, Literals) {
    for (const Row& row : {
             Row{"X10;", "(words X10)"},
             {"X10.5;", "(words X10.5)"},
             {"X-5.25;", "(words X-5.25)"},
             {"X+30;", "(words X30)"},
             {"X.5;", "(words X0.5)"},
             {"X-.5;", "(words X-0.5)"},
             {"X10.;", "(words X10)"},
             {"X10. Y5.;", "(words X10 Y5)"},
             {"G54.1 P3;", "(words G54.1 P3)"},
             {"X10mm;", "(words X10mm)"},
             {"X2.5in Y-1in;", "(words X2.5in Y-1in)"},
             {"F200mm/min;", "(words F200mm/min)"},
             {"S1500rpm M3;", "(words S1500rpm M3)"},
             {"F0.1mm/rev;", "(words F0.1mm/rev)"},
             {"X -5;", "(words X-5)"},
             {"X 10;", "(words X10)"},
             {"G01 X010;", "(words G1 X10)"},
             {"CR25 X1;", "(words CR25 X1)"},
             {"G0X10Y20;", "(words G0 X10 Y20)"},
             {"G1X10.5Y-20.F200;", "(words G1 X10.5 Y-20 F200)"},
             {"G1X-5Y=a;", "(words G1 X-5 (Y= a))"},
             {"M30;", "(words M30)"},
             {"T3 M6;", "(words T3 M6)"},
             {"TRANS X5 Y5;", "(words TRANS X5 Y5)"},
         }) {
        EXPECT_EQ(statements(row.text), row.expected) << row.text;
    }
}

TEST(Words, Values) {
    for (const Row& row : {
             Row{"G1 X=r*cos(a) Y=r*sin(a) F200;",
                 "(words G1 (X= (* r (call cos a))) (Y= (* r (call sin a))) F200)"},
             {"X=a Y-5;", "(words (X= a) Y-5)"},
             {"X=a -5 Y5;", "(words (X= (- a 5)) Y5)"},
             {"X=5Y10;", "(words (X= 5) Y10)"},
             {"G2 X10 CR=r+1;", "(words G2 X10 (CR= (+ r 1)))"},
             {"X+=10mm;", "(words (X+= 10mm))"},
             {"X-=10mm;", "(words (X+= (- 10mm)))"},
             {"G2 X5 I=AC(5) J=IC(3);", "(words G2 X5 (I=AC 5) (J=IC 3))"},
             {"X=ac(5);", "(words (X= (call ac 5)))"},
             {"X = a;", "(words (X= a))"},
             {"G1 X=a\n    Y=b\n    F200;", "(words G1 (X= a) (Y= b) F200)"},
         }) {
        EXPECT_EQ(statements(row.text), row.expected) << row.text;
    }
}

TEST(Words, Points) {
    for (const Row& row : {
             Row{"G1 p;", "(words G1 p)"},
             {"G1 holes[i].at F200;", "(words G1 F200 (. (index holes i) at))"},
             {"G1 polar(r, a);", "(words G1 (call polar r a))"},
             {"G1 {10mm, 20mm};", "(words G1 (braces 10mm 20mm))"},
             {"G1 p + q - {1, 2} F5;", "(words G1 F5 (- (+ p q) (braces 1 2)))"},
         }) {
        EXPECT_EQ(statements(row.text), row.expected) << row.text;
    }
}

TEST(Words, OnlyUpperCaseAddressesAreWords) {
    EXPECT_EQ(statements("x = width + Xmax + MAX_2;"), "(do (= x (+ (+ width Xmax) MAX_2)))");
    EXPECT_EQ(statements("x1 = 5;"), "(do (= x1 5))");
}

TEST(Words, TheInputDialectDecides) {
    const std::string program = "cycle a() { SUPA; }";
    EXPECT_EQ(parsed("dialect sinumerik;\n" + program),
              "(dialect sinumerik)\n(cycle a\n  (words SUPA))");
    // `X1` is an address there, but only before `=`.
    EXPECT_EQ(parsed("dialect sinumerik;\ncycle a() { G1 X1 Y1.5; }"),
              parsed("dialect sinumerik;\ncycle a() { G1 X 1 Y 1.5; }"));
}

// Calls of the control may leave arguments out; the language's own may not.
TEST(Words, ArgumentsLeftOut) {
    const std::string head = "dialect sinumerik;\ncycle a() { ";
    EXPECT_NE(parsed(head + "CYCLE81(50,2,,-10); }").find("(call CYCLE81 50 2  (- 10))"),
              std::string::npos);
    EXPECT_NE(
        parsed(head + "MCALL CYCLE82(, f(1, 2), {1, 2}, ,); }").find("(call CYCLE82  (call f"),
        std::string::npos);
    for (const char* wrong : {"f(1,,2);", "CYCLE81(f(1,,2));", "CYCLE81({1,,2});", "f(,);"})
        EXPECT_NE(Parsed(head + wrong + " }").messages(), "") << wrong;
}

}  // namespace
}  // namespace kadr::syntax::words_test
