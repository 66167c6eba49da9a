// Expressions: literals with units, C's precedence, calls, values in braces.
#include "parsing.h"

namespace kadr::syntax::expressions_test {
namespace {

TEST(Expressions, Numbers) {
    for (const Row& row : {
             Row{"10", "10"},
             {"10.5", "10.5"},
             {".5", "0.5"},
             {"10.", "10.0"},
             {"1e3", "1000.0"},
             {"2.5e-3", "0.0025"},
             {"10mm", "10mm"},
             {"2.5in", "2.5in"},
             {"30deg", "30deg"},
             {"0.5s", "0.5s"},
             {"1500rpm", "1500rpm"},
             {"200mm/min", "200mm/min"},
             {"0.1mm/rev", "0.1mm/rev"},
             {"120m/min", "120m/min"},
             {"5um", "5um"},
             {"5µm", "5um"},
             {"1.5rad", "1.5rad"},
             {"2cm", "2cm"},
             {"1m", "1m"},
             {"3ms", "3ms"},
             {"2min", "2min"},
             {"10in/min", "10in/min"},
             {"0.01in/rev", "0.01in/rev"},
             {"3mm/s", "3mm/s"},
             {"(50%)", "50%"},
             {"10.mm", "10mm"},
             {"1m*2", "(* 1m 2)"},
             {"10mm/a", "(/ 10mm a)"},
             {"10mm / min(a, b)", "(/ 10mm (call min a b))"},
             {"10mm/min(a, b)", "(/ 10mm (call min a b))"},
             {"7 % 3", "(% 7 3)"},
             {"7%n", "(% 7 n)"},
             {"9223372036854775807", "9223372036854775807"},
         }) {
        EXPECT_EQ(expression(row.text), row.expected) << row.text;
    }
}

TEST(Expressions, Precedence) {
    for (const Row& row : {
             Row{"a + b * c", "(+ a (* b c))"},
             {"a * b + c", "(+ (* a b) c)"},
             {"a - b - c", "(- (- a b) c)"},
             {"a / b * c", "(* (/ a b) c)"},
             {"(a + b) * c", "(* (+ a b) c)"},
             {"-a * b", "(* (- a) b)"},
             {"- -a", "(- (- a))"},
             {"!a && b", "(&& (! a) b)"},
             {"a << 1 + b", "(<< a (+ 1 b))"},
             {"a < b == c > d", "(== (< a b) (> c d))"},
             {"a == b & c", "(& (== a b) c)"},
             {"a & b ^ c | d", "(| (^ (& a b) c) d)"},
             {"a | b && c", "(&& (| a b) c)"},
             {"a || b && c || d", "(|| (|| a (&& b c)) d)"},
             {"a ?? b ?? c", "(?? a (?? b c))"},
             {"a ?? b || c", "(?? a (|| b c))"},
             {"a ? b : c ? d : e", "(? a b (? c d e))"},
             {"a ? b ? c : d : e", "(? a (? b c d) e)"},
             {"a ?? b ? c : d", "(? (?? a b) c d)"},
             {"s contains \"G83\" && b", "(&& (contains s \"G83\") b)"},
             {"~a % b", "(% (~ a) b)"},
             {"a >= b != c <= d", "(!= (>= a b) (<= c d))"},
             {"-a.x[1]", "(- (index (. a x) 1))"},
             {"a >> b << c", "(<< (>> a b) c)"},
         }) {
        EXPECT_EQ(expression(row.text), row.expected) << row.text;
    }
}

TEST(Expressions, CallsAndMembers) {
    for (const Row& row : {
             Row{"f()", "(call f)"},
             {"f(a, 2)", "(call f a 2)"},
             {"drill(to: -5mm, retract: 2mm)", "(call drill to: (- 5mm) retract: 2mm)"},
             {"f(a ? b : c)", "(call f (? a b c))"},
             {"f(x, if: 5)", "(call f x if: 5)"},
             {"f(R: 5mm, time: 2s)", "(call f R: 5mm time: 2s)"},
             {"a.b.c(1)[2].d", "(. (index (call (. (. a b) c) 1) 2) d)"},
             {"run.time", "(. run time)"},
             {"p.X10", "(. p X10)"},
             {"p.if", "(. p if)"},
             {"table<hole>(\"f.csv\")", "(call table<hole> \"f.csv\")"},
             {"a < b", "(< a b)"},
             {"a < b > c", "(> (< a b) c)"},
             {"given a ? a : 3", "(? (given a) a 3)"},
             {"given + 1", "(+ given 1)"},
             {"given a[i] && b", "(&& (given (index a i)) b)"},
             {"!given h.depth", "(! (given (. h depth)))"},
             {"2*p + {x: 1mm, y: a ? b : c}", "(+ (* 2 p) (braces x: 1mm y: (? a b c)))"},
             {"{1, 2mm, a + b}", "(braces 1 2mm (+ a b))"},
             {"{}", "(braces)"},
             {"{1, 2,}", "(braces 1 2)"},
             {"{{1, 2}, {3, 4}}", "(braces (braces 1 2) (braces 3 4))"},
             {"f({a, b}, {c, d})", "(call f (braces a b) (braces c d))"},
             {"a ? {1, 2} : {3, 4}", "(? a (braces 1 2) (braces 3 4))"},
             {"b ?? {1, 2}", "(?? b (braces 1 2))"},
             {"true && false", "(&& true false)"},
             {"i++ + ++j", "(+ (post++ i) (pre++ j))"},
             {"int(x)", "(call int x)"},
         }) {
        EXPECT_EQ(expression(row.text), row.expected) << row.text;
    }
}

TEST(Expressions, UnicodeNames) {
    EXPECT_EQ(expression("größe + длина_2 * π"), "(+ größe (* длина_2 π))");
}

}  // namespace
}  // namespace kadr::syntax::expressions_test
