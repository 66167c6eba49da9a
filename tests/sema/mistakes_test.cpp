// Mistakes that the checker finds: where it points, and what it proposes. That each row has a
// wrong and a right example that work is examples_test.cpp's matter.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/sema/running.h"

namespace kadr::testing::mistakes_test {
namespace {

struct Row {
    const char* source;
    const char* messages;
};

void expect_rows(std::initializer_list<Row> rows) {
    for (const Row& row : rows) {
        SCOPED_TRACE(row.source);
        EXPECT_EQ(check(row.source).all_messages(), row.messages);
    }
}

TEST(Mistakes, Names) {
    expect_rows({
        {"program p() { X=radios; }", "1:17 K2001 `radios` is not declared"},
        {"int f(int n) { return 2**n; }\nprogram p() { X=f(1); }",
         "1:25 K1205 a value is missing behind `*`"},
        {"program p() { G1 X10 Q5; }", "1:22 K4101 `Q5` is no word of the dialect iso"},
        {"program p() { G1 X=Q5; }", "1:20 K2001 `Q5` is not declared"},
        {"program p() { { int a = 1; X=a; } X=a; }", "1:37 K2001 `a` is not declared"},
        {"program p() { for (int i = 0; i < 2; i++) X=i; X=i; }", "1:50 K2001 `i` is not declared"},
        {"program p() { drll(1mm); }", "1:15 K2002 there is no function, cycle or command `drll`"},
        {"void f() { X1; }\nvoid f() { X2; }\nprogram p() { f(); }",
         "2:6 K2004 `f` is declared twice"},
        {"void f(int a, int a) { X=a; }\nprogram p() { f(1, 2); }",
         "1:19 K2004 `a` is declared twice"},
        {"enum e { a, a }\nprogram p() { }", "1:13 K2004 `a` is declared twice"},
        {"struct s { int a; int a; }\nprogram p() { }", "1:23 K2004 `a` is declared twice"},
        {"int n = 1;\nprogram p() { int n = 2; X=n; }",
         "2:19 K2005 `n` hides a variable of the same name"},
        {"void f(int n) { int n = 2; X=n; }\nprogram p() { f(1); }",
         "1:21 K2005 `n` hides a variable of the same name\n1:12 K2014 the parameter `n` is never "
         "used"},
    });
    const Checked own = check_program("program p() { length k2 = k2; X=k2; }");
    EXPECT_TRUE(own.messages->all().at(0).fixes.empty());
    EXPECT_EQ(own.messages->all().at(0).notes.at(0).text,
              "it is used in its own value, before it has one");
    // The nearest name is proposed.
    const Checked checked = check_program("program p() { length radius = 5mm; X=radios; }");
    EXPECT_EQ(checked.messages->all().at(0).fixes.at(0).replacement, "radius");
}

TEST(Mistakes, HeadsAroundNothing) {
    expect_rows({
        {"program p(bool b = true) { if (b); G0 X1; }",
         "1:34 K2503 this `if` does nothing: its body is the `;`"},
        {"program p(bool b = true) { if (b) X1; else; G0 X1; }",
         "1:43 K2503 this `else` does nothing: its body is the `;`"},
        {"program p(bool b = true) { while (b); G0 X1; }",
         "1:37 K2503 this `while` does nothing: its body is the `;`"},
        {"program p() { for (int i = 0; i < 3; i++); G0 X1; }",
         "1:42 K2503 this `for` does nothing: its body is the `;`"},
        {"program p() { for (int i : 1..3); G0 X1; }",
         "1:33 K2503 this `for` does nothing: its body is the `;`"},
        {"program p() { while (sin(30deg) > 1); G0 X1; }",
         "1:37 K2503 this `while` does nothing: its body is the `;`"},
        {"bool more() { X1; return false; }\nprogram p() { while (more()); if (more()) {} }", ""},
        {"bool more() { X1; return false; }\nprogram p() { for (; more(););  ; }", ""},
    });
}

TEST(Mistakes, NamesThatAreSomethingElse) {
    struct FixRow {
        const char* source;
        const char* messages;
        const char* replacement;
    };
    for (const FixRow& row : {
             FixRow{"program p() { G0 X=5 mm; }",
                    "1:22 K1025 the unit `mm` stands apart from its number", "mm"},
             {"program p() { G0 X10 mm; }", "1:22 K1025 the unit `mm` stands apart from its number",
              "mm"},
             {"program p() { F=100mm / min; }",
              "1:25 K1025 the unit `mm/min` stands apart from its number", "mm/min"},
             {"program p() { F=100 mm/min; }",
              "1:21 K1025 the unit `mm/min` stands apart from its number", "mm/min"},
             {"program p() { G0 x10; }", "1:18 K2001 `x10` is not declared", "X10"},
             {"program p() { plane_zx; }", "1:15 K2001 `plane_zx` is not declared", "plane_zx()"},
             {"program p() { sqrt; }", "1:15 K2001 `sqrt` is not declared", "sqrt()"},
         }) {
        SCOPED_TRACE(row.source);
        EXPECT_EQ(check(row.source).all_messages(), row.messages);
        const Checked checked = check_program(row.source);
        ASSERT_FALSE(checked.messages->all().empty());
        ASSERT_FALSE(checked.messages->all()[0].fixes.empty());
        EXPECT_EQ(checked.messages->all()[0].fixes[0].replacement, row.replacement);
    }
    expect_rows({
        {"program p() { point mm = {1mm}; G0 F=5 mm; }", ""},
        {"program p(length r = 5mm) { G0 Y=r sin(30); }",
         "1:36 K2312 `sin(30)` behind `Y=r` is neither a word nor a point"},
        {"program p(length r = 5mm) { G0 r; }",
         "1:32 K2101 the target must be `point`, not `length`"},
    });
}

TEST(Mistakes, DiametersAndLengths) {
    expect_rows({
        {"program p(diameter d, length r) { G0 X=d + r; }",
         "1:40 K2103 `+` between diameter and length"},
        {"program p(diameter d) { G0 Y=d; }",
         "1:30 K2131 `Y` takes a length, and this is a diameter"},
        {"program p(diameter d) { G2 X=d CR=d; }",
         "1:35 K2131 `CR` takes a length, and this is a diameter"},
        {"program p(diameter d) { shift(x: d); }",
         "1:34 K2131 `x` takes a length, and this is a diameter"},
        {"program p(diameter d) { with shift(z: d) { G0 X1; } }",
         "1:39 K2131 `z` takes a length, and this is a diameter"},
        {"program p(diameter d) { length l = d; G0 X=l; }",
         "1:36 K2132 `l` must be length, and this is a diameter"},
        {"program p(length r) { diameter d = r; G0 X=d; }",
         "1:36 K2132 `d` must be diameter, and this is a length"},
        {"void f(diameter d) { X=d; }\nprogram p(length r) { f(r); f(20mm); f(d: diameter(r)); }",
         "2:25 K2132 `d` must be diameter, and this is a length"},
        {"void f(length? l) { X=l ?? 1mm; }\nprogram p(diameter d) { f(d); f(d/2); f(length(d)); }",
         "2:27 K2132 `l` must be length, and this is a diameter"},
        {"program p(length r, diameter d) { diameter[] a = {r, d}; X=a[0]; }",
         "1:51 K2132 the element must be diameter, and this is a length"},
        {"program p(length r, diameter d) { if (d > r) X1; if (d > 5mm) X2; }",
         "1:39 K2103 `>` between diameter and length"},
        {"program p(length r, diameter d) { X=min(d, r); X=max(d, 5mm); }",
         "1:37 K2103 `min` between diameter and length"},
        {"program p(diameter d) { time t = d; dwell(t); }",
         "1:34 K2102 `t` must be time, not diameter"},
    });
}

TEST(Mistakes, CallsSayWhatTheyNeed) {
    const auto fix_of = [](const char* source) {
        const Checked checked = check_program(source);
        if (checked.messages->all().empty() || checked.messages->all()[0].fixes.empty())
            return std::string();
        return checked.messages->all()[0].fixes[0].text;
    };
    // Of two letters, every word of three is near.
    EXPECT_EQ(fix_of("cycle c(length back, length top = 1, length d) { G0 X=back+top+d; }\n"
                     "program p() { c(to: 5, d: 3); }"),
              "it has `back`, `top`, `d`; it needs `back`");
    EXPECT_EQ(fix_of("cycle c(length peck = 1) { G0 X=peck; }\nprogram p() { c(pecks: 5); }"),
              "did you mean `peck`?");
    EXPECT_EQ(fix_of("program p() { cycle(); }"),
              "declare it in the file, `cycle name(…) { … }`, and call a cycle by its name");
    expect_rows({
        // A mistake in the head of a cycle is one message.
        {"cycle bad() preserves G90, 5 { G0 X1; }\nprogram p() { bad(); }",
         "1:28 K1114 unexpected `5` behind `,`"},
    });
}

/// What programmers of other languages write is answered with Kadr's way.
TEST(Mistakes, HabitsOfOtherLanguages) {
    struct HabitRow {
        const char* statement;
        const char* hint;         // a part of it
        const char* replacement;  // empty: there is none
    };
    for (const HabitRow& row : {
             HabitRow{"double d = 2.5;", "`real`", "real"},
             {"unsigned k = 3;", "`int`", "int"},
             {"unsigned int k = 3;", "`int`", ""},
             {"long long k = 3;", "`int`", ""},
             {"String k = 3;", "`string`", "string"},
             {"boolean b = true;", "`bool`", "bool"},
             {"bool b = TRUE;", "another name", "true"},
             {"var v = 3;", "`auto`", "auto"},
             {"static int k = 3;", "outside", ""},
             {"printf(\"n\");", "`note", ""},
             {"goto 5;", "no jumps", ""},
             {"again: G1 X5;", "no labels", ""},
             {"a = NULL;", "not given", ""},
             {"n = M_PI;", "another name", "pi"},
             {"n = math.sin(30);", "`sin(a)`", ""},
             {"list->append(3mm);", "point", "."},
             {"n = 2**3;", "`pow(a, n)`", ""},
             {"if (n <> 3) X1;", "unequal", "!="},
             {"n := 3;", "assign", "="},
             {"n = (int)2.5;", "`int(x)`", ""},
             {"G1 X=a, Y3;", "commas", ""},
             {"for (int i in list) X1;", "sign", ":"},
             {"for (int i = 0, j = 1; i < 3; i++) X1;", "one variable", ""},
             {"foreach (x in list) X1;", "`for (length x : list)", ""},
             {"int[] k; k.push_back(3);", "`append`", ""},
             {"int k[3];", "behind the type", "[3] k"},
             {"elseif (n > 3) X1;", "`else if", ""},
             {"throw \"x\";", "`error(", ""},
             {"a++;", "by how much: `a += …`", ""},
             {"if (n) X1;", "`n != 0`", ""},
             {"if (1 < n < 3) X1;", "stands by itself", "1 < n && n < 3"},
             {"#define N 3\n", "`const int n = 3;`", ""},
             {"    struct hole h;", "the name alone", ""},
             {"i = 3;", "declare it first", ""},
             {"return 0;", "`return;`", ""},
         }) {
        SCOPED_TRACE(row.statement);
        const Checked checked =
            check_program("program p(int n = 3, length a = 4mm) {\nlength[] list = {1, 2};\n" +
                          std::string(row.statement) + "\nX=a Y=list[0] Z=n;\n}");
        std::string hints;
        bool has_replacement = false;
        for (const Diagnostic& message : checked.messages->all()) {
            for (const Diagnostic::Fix& fix : message.fixes) {
                hints += fix.text + '\n';
                has_replacement |= fix.text.find(row.hint) != std::string::npos &&
                                   fix.replacement == row.replacement;
            }
        }
        EXPECT_TRUE(has_replacement) << hints;
    }
    // Where the name means something, it is a name.
    EXPECT_EQ(check("program p(length end) { real print = 2; X=end*print; }").all_messages(), "");
    EXPECT_EQ(check("program p(int loop) {\n    loop = 3\n    X=loop;\n}").all_messages(),
              "2:13 K1101 `;` is missing behind this statement");
}

TEST(Mistakes, DefaultsUseWhatStandsBeforeThem) {
    expect_rows({
        {"program p(int n = k, int k = 2) { X=n Y=k; }",
         "1:19 K2019 the default of `n` uses `k`, which has no value yet"},
        {"void f(int n = n) { X=n; }\nprogram p() { f(); }",
         "1:16 K2019 the default of `n` uses `n`, which has no value yet"},
        {"void f(int n = m, int k = 1) { X=n Y=k; }\nprogram p() { f(); }",
         "1:16 K2001 `m` is not declared"},
        {"program p(int k = 2, int n = k + 1) { X=n; }", ""},
    });
}

TEST(Mistakes, HeadersStandAtTheTopAndOnce) {
    expect_rows({
        {"units mm; units inch; program p() { X1; }", "1:11 K2310 `units` is given twice"},
        {"dialect iso; dialect iso; program p() { X1; }", "1:14 K2310 `dialect` is given twice"},
        {"program p() { X1; } units inch;", "1:21 K2311 `units` stands behind a declaration"},
        {"program p() { X1; } language en;", "1:21 K2311 `language` stands behind a declaration"},
        {"units inch; program p() { X1; } language en; units mm;",
         "1:33 K2311 `language` stands behind a declaration\n1:46 K2310 `units` is given twice"},
        {"units inch; dialect iso; language en; program p() { X1; }", ""},
    });
}

TEST(Mistakes, NamesOfSeveralImports) {
    RunOptions options;
    options.modules["l"] = "void f() { X1; }\nint n = 1;\nconst int k = 1;\nstruct s { int a; }";
    options.modules["r"] = "void f() { X2; }\nint n = 2;\nconst int k = 2;\nstruct s { int a; }";
    for (const char* use : {"f();", "X=n;", "X=k;", "n = 3;", "s v = {1}; X=v.a;"}) {
        const std::string body = std::string("program p() { ") + use + " }";
        const Outcome outcome = check("import l; import r;\n" + body, options);
        ASSERT_EQ(outcome.messages.size(), 1u) << use << outcome.all_messages();
        EXPECT_EQ(outcome.messages[0], *use == 'X' ? "2:17 K2020" : "2:15 K2020") << use;
        EXPECT_EQ(check("import l;\n" + body, options).all_messages(), "") << use;
    }
    // A name of the file itself goes before both.
    EXPECT_EQ(
        run("import l; import r;\nvoid f() { X3; }\nprogram p() { f(); }", options).all_blocks(),
        "X3");
}

TEST(Mistakes, OneMistakeIsOneMessage) {
    expect_rows({
        {"program p() { int n = wrong + 1; X=n*2; if (n > wrong) X=n; }",
         "1:23 K2001 `wrong` is not declared\n1:49 K2001 `wrong` is not declared"},
        {"program p() { lenght x = 5mm; X=x; Y=x + 1deg; }",
         "1:15 K2003 there is no type `lenght`"},
        {"program p() { auto a = wrong(); X=a; a.append(1); X=a[0]; }",
         "1:24 K2002 there is no function, cycle or command `wrong`"},
        {"program p() { for (point q : wrong) G1 q; }", "1:30 K2001 `wrong` is not declared"},
        {"program p() { switch (wrong) { case 1: X1; } }", "1:23 K2001 `wrong` is not declared"},
    });
}

TEST(Mistakes, Dimensions) {
    expect_rows({
        {"program p() { X=10mm + 5deg; }", "1:17 K2103 `+` between length and angle"},
        {"program p() { if (1s > 1mm) X1; }", "1:19 K2103 `>` between time and length"},
        {"program p() { real r = 2; length d = 1mm; d = d + r; X=d; }",
         "1:47 K2103 `+` between length and number"},
        {"program p() { length a = 2mm*3mm; }", "1:26 K2102 `a` must be length, not area"},
        {"program p() { real a = 2mm; }", "1:24 K2102 `a` must be number, not length"},
        {"program p() { X=5deg; }", "1:15 K2102 `X` must be length, not angle"},
        {"program p() { X5deg; }", "1:15 K2102 `X` must be length, not angle"},
        {"program p() { F=5deg; }", "1:15 K2102 `F` must be feed, not angle"},
        {"program p() { speed n = 1rpm; S=n*1mm*1mm; }",
         "1:31 K2102 `S` must be speed, not speed times area"},
        {"program p() { speed n = 1rpm; feed f = n; F=f; }",
         "1:40 K2102 `f` must be feed, not speed"},
        {"program p() { auto a = cbrt(5mm); X=a; }",
         "1:29 K2110 the cube root of length has no dimension"},
        {"program p() { S=5mm; }", "1:15 K2102 `S` must be speed, not length"},
        {"program p() { dwell(5mm); }", "1:21 K2102 `time` must be time, not length"},
        {"program p() { X=sin(5mm); }", "1:21 K2102 `sin` must be angle, not length"},
        {"program p() { auto a = exp(5mm); }", "1:28 K2102 `exp` must be number, not length"},
        {"program p() { X=atan2(1mm, 1s)/1deg; }", "1:17 K2103 `atan2` between length and time"},
        {"program p() { length[] a = {1, 2deg}; }",
         "1:32 K2102 the element must be length, not angle"},
        {"void f(angle a) { X=sin(a); }\nprogram p() { f(3mm); }",
         "2:17 K2102 `a` must be angle, not length"},
        {"length f() { return 3s; }\nprogram p() { X=f(); }",
         "1:21 K2102 the result must be length, not time"},
        {"program p() { auto a = 1mm; a = 2mm*3mm*4mm; }",
         "1:33 K2102 `a` must be length, not volume"},
        {"program p() { auto a = 1mm/1s/1s/1s; a = 1; length b = a; }",
         "1:56 K2102 `b` must be length, not length/time^3"},
    });
}

TEST(Mistakes, Types) {
    expect_rows({
        {"program p() { int a = 2.5; }", "1:23 K2104 `a` must be a whole number; this one is real"},
        {"program p() { int[] a = {1}; X=a[1.5]; }",
         "1:34 K2104 the index must be a whole number; this one is real"},
        {"program p() { bool a = 1; }", "1:24 K2101 `a` must be `bool`, not `int`"},
        {"program p() { string a = 1; }", "1:26 K2101 `a` must be `string`, not `int`"},
        {"enum e { one }\nenum f { two }\nprogram p() { e a = two; }",
         "3:21 K2101 `a` must be `e`, not `f`"},
        {"enum e { one }\nenum f { two }\nprogram p() { bool a = one == two; }",
         "3:24 K2106 `==` cannot be applied to `e` and `f`"},
        {"program p() { bool b = true; b++; }", "1:30 K2105 `++` cannot be applied to `bool`"},
        {"program p() { X=-true; }", "1:18 K2105 `-` cannot be applied to `bool`"},
        {"program p() { bool b = 1 && 2; }",
         "1:24 K2107 a condition must be `bool`, not `int`\n"
         "1:29 K2107 a condition must be `bool`, not `int`"},
        {"program p() { int[2] a = {1, 2}; int[] b = a; int[3] c = b; }",
         "1:58 K2118 3 elements are needed, not any number of"},
        {"program p() { X=1 ? 2 : 3; }", "1:17 K2107 a condition must be `bool`, not `int`"},
        {"program p() { length a = true ? 5mm : 5deg; }",
         "1:39 K2102 the value must be length, not angle"},
        {"program p(int n = 1) { length a = n > 0 ? 5mm : 5deg; }",
         "1:49 K2102 the value must be length, not angle"},
        {"program p() { int[] a = {1, 2}; int[] b = {1}; if (a == b) X1; }",
         "1:52 K2106 `==` cannot be applied to `int[]` and `int[]`"},
        {"program p() { G1 5; }", "1:18 K1114 unexpected `5` behind `G1`"},
        {"program p() { int n = 1; G1 n; }", "1:29 K2101 the target must be `point`, not `int`"},
    });
}

TEST(Mistakes, ConstantsAreComputedBefore) {
    expect_rows({
        {"program p() { X=1/0; }", "1:17 K2109 division by zero"},
        {"program p() { X=5 % 0; }", "1:17 K2109 division by zero"},
        {"program p() { X=sqrt(1 - 2); }", "1:17 K2109 the square root of a negative number"},
        {"program p() { X=asin(2)/1deg; }",
         "1:17 K2109 the argument of an arc function is outside of -1 to 1"},
        {"program p() { X=tan(90); }", "1:17 K2109 the tangent of a right angle"},
        {"program p() { int n = 9000000000000000000 * 2; }",
         "1:23 K2109 the whole number leaves 64 bits"},
        {"program p() { X=-(~9223372036854775807); }",
         "1:17 K2109 the whole number leaves 64 bits"},
        {"program p() { X=abs(~9223372036854775807); }",
         "1:17 K2109 the whole number leaves 64 bits"},
        {"const real k = 0;\nprogram p() { X=1/k; }", "2:17 K2109 division by zero"},
    });
}

TEST(Mistakes, NotGivenIsNotZero) {
    expect_rows({
        {"program p() { length x; X=x; }", "1:27 K2113 `x` is not given here"},
        {"program p() { length? x; X=x; }", "1:28 K2113 `x` is not given here"},
        {"program p(length? x) { if (!given x) X=x; }", "1:40 K2113 `x` is not given here"},
        {"program p(length? x) { if (given x) X=x; else X=x; }",
         "1:49 K2113 `x` is not given here"},
        // On some way it has a value: that is seen while it runs.
        {"program p(int n = 1) { length x; if (n > 0) x = 1; X=x; }", ""},
        {"program p(int n = 1) { length x; if (n > 0) x = 1; else x = 2; X=x; }", ""},
        {"program p(int n = 1) { length x; while (n > 0) { if (n == 1) X=x; x = 1; n--; } }", ""},
        {"program p(length? x) { require(given x, \"x\"); X=x; }", ""},
    });
}

TEST(Mistakes, CallsAndFlow) {
    expect_rows({
        {"int f(int n) { while (true) { if (n > 0) return 1; n++; } }\nprogram p() { X=f(1); }",
         ""},
        {"int f(int n) { if (n > 0) return 1; else return 2; }\nprogram p() { X=f(1); }", ""},
        {"int f(int n) { switch (n) { case 1: return 1; default: return 2; } }\nprogram p() { "
         "X=f(1); }",
         ""},
        {"int f(int n) { if (n > 0) return 1; error(\"no\"); }\nprogram p() { X=f(1); }", ""},
        {"int f(int n) { while (n > 0) return 1; }\nprogram p() { X=f(1); }",
         "1:5 K2214 `f` must return `int` on every way out"},
        {"void f() { return 1; }\nprogram p() { f(); }", "1:19 K2216 `f` has no result to return"},
        {"program p() { X=sqrt(); }", "1:17 K2212 `sqrt` takes 1 arguments, not 0"},
        {"program p() { X=sqrt(x: 4); }", "1:22 K2208 `sqrt` has no parameter `x`"},
        {"program p() { dwell(tme: 1s); }", "1:21 K2208 `dwell` has no parameter `tme`"},
        {"program p() { tool(); }", "1:15 K2207 `tool` needs `tool`"},
        {"program p() { continue; }", "1:15 K2217 `continue` stands outside of a loop"},
        {"program p() { switch (1) { case 1: continue; } }",
         "1:36 K2217 `continue` stands outside of a loop"},
        {"program p() { while (true) { break; X1; } }", "1:37 K2218 this is never reached"},
        {"struct a { b x; }\nstruct b { a y; }\nprogram p() { }",
         "2:12 K2015 the struct `b` contains itself"},
    });
    // More parameters than a call can count.
    std::string many = "void f(int a0";
    for (int i = 1; i < 33; ++i) many += ", int a" + std::to_string(i);
    many += ") { X=a0; }\nprogram p() { }";
    EXPECT_EQ(check(many).messages.at(0), "1:6 K2213");
    std::string large = "program p() {";
    for (int i = 0; i < 60001; ++i) large += "real v" + std::to_string(i) + "=1;";
    EXPECT_EQ(check(large + "}").messages, std::vector<std::string>{"1:9 K2220"});
}

// The number of registers is told for what holds them, once, whatever it would be in 16 bits.
TEST(Mistakes, ValuesThatAreTooLarge) {
    const auto structs = [](int levels) {
        std::string text = "struct level1 { int a; int b; }\n";
        for (int i = 2; i <= levels; ++i) {
            const std::string inner = "level" + std::to_string(i - 1);
            text += "struct level" + std::to_string(i) + " { " + inner + " a; " + inner + " b; }\n";
        }
        return text;
    };
    const auto has = [](const std::string& program, const std::string& message) {
        const std::vector<std::string> messages = check(program).messages;
        return std::ranges::find(messages, message) != messages.end();
    };
    for (const int levels : {16, 17, 40}) {
        SCOPED_TRACE(levels);
        EXPECT_EQ(
            check(structs(levels) + "program p() { level" + std::to_string(levels) + " x; M30; }")
                .messages,
            std::vector<std::string>{"16:8 K2220"});
    }
    // 32768 registers each: one fits, two do not; outside of functions there is more room.
    const std::string large = structs(15);
    EXPECT_EQ(check(large + "program p() { level15 x; M30; }").messages,
              std::vector<std::string>{"16:23 K2501"});  // it is only never read
    EXPECT_EQ(check(large + "program p() { level15 x; level15 y; M30; }").messages,
              std::vector<std::string>{"16:9 K2220"});
    EXPECT_EQ(check(large + "level15 x;\nlevel15 y;\nprogram p() { M30; }").messages,
              std::vector<std::string>{});
    std::string globals = large;
    for (int i = 0; i < 31; ++i) globals += "level15 x" + std::to_string(i) + ";\n";
    EXPECT_EQ(check(globals + "program p() { M30; }").messages,
              std::vector<std::string>{"46:9 K2622"});
    EXPECT_TRUE(
        has(large + "void f(level15 a, level15 b) { }\nprogram p() { M30; }", "16:6 K2220"));
    EXPECT_EQ(check(large + "curve c(level15 a, level15 b) over real u = 0 .. 1 { x = u*1mm; "
                            "y = 0mm; }\nprogram p() { M30; }")
                  .messages,
              std::vector<std::string>{"16:7 K2220"});
    std::string members = "struct many {";
    for (int i = 0; i < 65540; ++i) members += " int a" + std::to_string(i) + ";";
    EXPECT_EQ(check(members + " }\nprogram p() { many x; M30; }").messages,
              std::vector<std::string>{"1:8 K2220"});
    std::string chain = "struct level1 { int a; }\n";
    for (int i = 2; i <= 150; ++i)
        chain +=
            "struct level" + std::to_string(i) + " { level" + std::to_string(i - 1) + " a; }\n";
    EXPECT_EQ(check(chain + "program p() { level150 x; M30; }").messages,
              std::vector<std::string>{"101:8 K2621"});
}

// An instruction names a function by a number of 16 bits.
TEST(Mistakes, TooManyFunctions) {
    std::string text = "program p() { M30; }\n";
    for (int i = 0; i < 65001; ++i) text += "void f" + std::to_string(i) + "() { }\n";
    EXPECT_EQ(check(text).messages.size(), 1u);
    EXPECT_TRUE(check(text).messages[0].ends_with("K2620"));
}

}  // namespace
}  // namespace kadr::testing::mistakes_test
