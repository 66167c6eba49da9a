// Mistakes in the shape of a program: wrong programs and what is said about them. One mistake is
// one message, and the rest of the program is still looked at.
#include "parsing.h"

namespace kadr::syntax::mistakes_test {
namespace {

TEST(Mistakes, Semicolons) {
    expect_messages({
        {"cycle a() { G0 Z5 }", "1:18 K1101 `;` is missing behind this block"},
        {R"(cycle a() {
    G0 Z5
    G0 X0;
})",
         "2:10 K1101 `;` is missing behind this block"},
        {R"(cycle a() {
    int a = 5
    int b = 6;
})",
         "2:14 K1101 `;` is missing behind this declaration"},
        {R"(cycle a() {
    x = 5
})",
         "2:10 K1101 `;` is missing behind this statement"},
        {R"(cycle a() {
    drill(to: -5mm)
    drill(to: -6mm);
})",
         "2:20 K1101 `;` is missing behind this statement"},
        {"cycle a() { do { M8; } while (x) }", "1:33 K1101 `;` is missing behind this statement"},
        {"cycle a() { if (n == 5) M8 else M9; }", "1:27 K1101 `;` is missing behind this block"},
        {"cycle a() { return 5 }", "1:21 K1101 `;` is missing behind this statement"},
        {"cycle a() { break }", "1:18 K1101 `;` is missing behind this statement"},
        {R"(import cycles.drilling
cycle a() { })",
         "1:23 K1101 `;` is missing behind this declaration"},
        {R"(cycle a() { G1 X10 Y20 }
cycle b() { G1 X10; })",
         "1:23 K1101 `;` is missing behind this block"},
        {R"(contour c = { G1 X0; }
program p() { })",
         "1:23 K1101 `;` is missing behind this declaration"},
        {R"(cycle a() {
    if (n > 3)
        G1 X10
    else
        G1 X20;
})",
         "3:15 K1101 `;` is missing behind this block"},
        {R"(cycle a() {
    G1 X10 F200
    drill(to: 5);
})",
         "2:16 K1101 `;` is missing behind this block"},
        {R"(cycle a() {
    G1 X10
    int i = 5;
})",
         "2:11 K1101 `;` is missing behind this block"},
    });
}

TEST(Mistakes, Brackets) {
    expect_messages({
        {"cycle a() { G1 X=d*cos(a; }", "1:25 K1102 `)` is missing"},
        {R"(cycle a() {
    G1 X=d*cos(a
    G0 Z5;
})",
         "2:17 K1102 `)` is missing"},
        {"cycle a() { x = (a + b)); }", "1:24 K1103 unexpected `)`"},
        {"cycle a() { if n > 3 { M8; } }", "1:15 K1104 `(` is missing behind `if`"},
        {"cycle a() { if (n > 3 { M8; } }", "1:22 K1102 `)` is missing"},
        {"cycle face(length d) G0 Z5;", "1:21 K1105 `{` is missing behind `)`"},
        {R"(program a() {
    if (n) {
        M8;
    M9;
}
cycle b() { M8; })",
         "5:2 K1102 `}` is missing"},
        {R"(program a() {
    if (n) {
        M8;
    M9;
})",
         "5:2 K1102 `}` is missing"},
        {"cycle a() { raw { G65 }", "1:24 K1102 `}` is missing"},
        {"cycle a() { x = a ? b; }", "1:22 K1104 `:` is missing behind `b`"},
        {"cycle a() { for (int i = 0; i < 5) M8; }", "1:34 K1104 `;` is missing behind `5`"},
        {"cycle a() { for (int i = 0, i < 5, i++) M8; }", "1:27 K1104 `;` is missing behind `0`"},
        {"cycle a() { for int i = 0; i < 5; i++ M8; }", "1:16 K1104 `(` is missing behind `for`"},
        {"cycle a() { for (hole h in list) M8; }", "1:24 K1104 `:` is missing behind `h`"},
        {"cycle a() { while x M8; }", "1:18 K1104 `(` is missing behind `while`"},
        {"cycle a() { do M8; }", "1:19 K1104 `while` is missing behind `;`"},
        {"cycle a() { with G91 M8; }", "1:24 K1105 `{` is missing behind `M8`"},
        {"cycle a() { a[5; }", "1:16 K1102 `]` is missing"},
        {"cycle a() { a[5) = 6; }", "1:16 K1102 `]` is missing"},
        {"cycle a() { point p = {1, 2; }", "1:28 K1102 `}` is missing"},
        {R"(}
cycle a() { })",
         "1:1 K1103 unexpected `}`"},
        {"cycle a() { } }", "1:15 K1103 unexpected `}`"},
        {"struct hole { length d, length e; }", "1:23 K1104 `;` is missing behind `d`"},
        {"struct hole { length d }", "1:23 K1104 `;` is missing behind `d`"},
        {"program p { M30; }", "1:10 K1104 `(` is missing behind `p`"},
        {"length f(length a) return a;", "1:19 K1105 `{` is missing behind `)`"},
        {"cycle a() { if (a) { M8; } else { M9; }", "1:40 K1102 `}` is missing"},
        {"cycle a() { G1 X5 Y=(a + b Z3; }", "1:27 K1102 `)` is missing"},
        {R"(length f(length a) {
    return a;
program p() { M30; })",
         "2:14 K1102 `}` is missing"},
        {"cycle a() { x = f(1, 2; y = 3; }", "1:23 K1102 `)` is missing"},
        {"cycle a() { with G91 { X5; }", "1:29 K1102 `}` is missing"},
        {"cycle a() { for (int i = 0; i < 3; i++ { M8; } }", "1:39 K1102 `)` is missing"},
        {"cycle a() { while (a { M8; } M9; }", "1:21 K1102 `)` is missing"},
        {"curve c(length a) angle t = 0 .. 1 { x = 1; }",
         "1:18 K1104 `over` is missing behind `)`"},
        {"void f( { M8; }", "1:8 K1102 `)` is missing"},
        {"cycle a() { x = {1, 2; y = 5; }", "1:22 K1102 `}` is missing"},
        {R"(cycle a() { M8; }}
cycle b() { })",
         "1:18 K1103 unexpected `}`"},
        {"cycle a() { switch (n) { case 1 M8; } }", "1:32 K1104 `:` is missing behind `1`"},
    });
}

TEST(Mistakes, Statements) {
    expect_messages({
        {"cycle a() { if (n > 3) }", "1:23 K1106 a statement is missing behind `)`"},
        {"cycle a() { * 5; }", "1:13 K1107 a block cannot begin with `*`"},
        {R"(G0 Z5;
program a() { M30; })",
         "1:1 K1108 `G0` stands outside of a program, cycle or function"},
        {"program a() { cycle b() { } }",
         "1:15 K1109 `cycle` cannot be declared inside of a program, cycle or function"},
        {"cycle a() { if (a) M8; M3; else M9; }", "1:28 K1110 `else` has no `if`"},
        {"cycle a() { case 1: M8; }", "1:13 K1111 `case` stands outside of a `switch`"},
        {"cycle a() { switch (n) { M8; } }",
         "1:26 K1112 `M8` stands in a `switch` before any `case`"},
        {R"(#include holes.kadr
program a() { M30; })",
         "1:1 K1115 files are brought in with `import`"},
        {R"(include "holes.kadr";
program a() { M30; })",
         "1:1 K1115 files are brought in with `import`"},
        {R"(program a() {
    #include "holes.kadr"
    M30;
})",
         "2:5 K1109 `#include \"holes.kadr\"` cannot be declared inside of a program, cycle or "
         "function"},
        {"units cm;", "1:7 K1116 `cm` is no system of units"},
        {"curve c() over angle t = 0deg { x = t; }",
         "1:26 K1117 the parameter of the curve has no end"},
        {R"(N10 G1 X5
N20 G1 X6)",
         "1:1 K1108 `N10` stands outside of a program, cycle or function"},
        {"O1234\nprogram p() { G0 X5; }",
         "1:1 K1108 `O1234` stands outside of a program, cycle or function"},
        {"(comment) G0 X5",
         "1:1 K1218 `(comment)` is a comment of a control\n"
         "1:11 K1108 `G0` stands outside of a program, cycle or function"},
        {"cycle a() { else M8; M9; }", "1:13 K1110 `else` has no `if`"},
        {"cycle a() { if (a) ; } else { M8; }",
         "1:24 K1108 `else` stands outside of a program, cycle or function"},
        {"f() { M8; }", "1:1 K1108 `f` stands outside of a program, cycle or function"},
        {"cycle a() { %O0001 }", "1:13 K1107 a block cannot begin with `%`"},
    });
}

TEST(Mistakes, Commas) {
    expect_messages({
        {"cycle a() { drill(to: -5mm retract: 2mm); }",
         "1:27 K1113 `,` is missing between `5mm` and `retract`"},
        {"cycle a() { drill(5 6); }", "1:20 K1113 `,` is missing between `5` and `6`"},
        {"cycle a() { x = 5 6; y = 7; }", "1:19 K1114 unexpected `6` behind `5`"},
        {R"(cycle a() { note "{x y}"; })", "1:22 K1114 unexpected `y` behind `x`"},
        {"cycle a() { with { M8; } }", "1:18 K1114 unexpected `{` behind `with`"},
        {"cycle a() preserves { }", "1:21 K1114 unexpected `{` behind `preserves`"},
        {"cycle a() preserves G90 G17 { }", "1:24 K1113 `,` is missing between `G90` and `G17`"},
        {"enum e { a b }", "1:11 K1113 `,` is missing between `a` and `b`"},
        {"import cycles drilling;", "1:15 K1114 unexpected `drilling` behind `cycles`"},
        {"cycle a() { foo bar baz; }", "1:21 K1114 unexpected `baz` behind `bar`"},
        {"cycle a() { x = a b; }", "1:19 K1114 unexpected `b` behind `a`"},
        {R"(cycle a() { require(a > 0 "text"); })",
         "1:26 K1113 `,` is missing between `0` and `\"text\"`"},
        {"cycle a() { given = 5; x = given 5; }", "1:34 K1114 unexpected `5` behind `given`"},
        {"cycle a() { x := 5; }", "1:15 K1114 unexpected `:` behind `x`"},
        {"cycle a() { if (a) then M8; }", "1:20 K1114 unexpected `then` behind `)`"},
        {"cycle a() { X10 + 5; }", "1:17 K1114 unexpected `+` behind `X10`"},
        {"cycle a() { G1 X10, Y5; }", "1:19 K1114 unexpected `,` behind `X10`"},
        {"cycle a() { point p = (1, 2); }", "1:25 K1114 unexpected `,` behind `1`"},
    });
}

TEST(Mistakes, Names) {
    expect_messages({
        {"cycle (length d) { }", "1:6 K1201 a name is missing behind `cycle`"},
        {"cycle a() { length R = 5mm; x = R * 2; }",
         "1:20 K1202 `R` is a word of NC blocks and cannot be a name"},
        {"cycle a(length R1) { x = R1 * 2; }",
         "1:16 K1202 `R1` is a word of NC blocks and cannot be a name"},
        {"cycle a() { int while = 5; }", "1:17 K1203 `while` is a keyword and cannot be a name"},
        {"cycle a() { length radii[8]; }",
         "1:25 K1210 the brackets of an array stand behind its type, not behind `radii`"},
        {"cycle a() { length a = 5, b = 6; }", "1:25 K1211 a declaration has one name"},
        {"cycle a() { for (h : list) M8; }", "1:18 K1212 `h` has no type"},
        {"test six { }", "1:6 K1214 a title in quotes is missing behind `test`"},
        {"cycle a() { X10 = 5; }", "1:13 K1202 `X10` is a word of NC blocks and cannot be a name"},
        {"enum axis { X, Y, Z }", "1:13 K1202 `X` is a word of NC blocks and cannot be a name"},
        {"struct hole { length D; }", "1:22 K1202 `D` is a word of NC blocks and cannot be a name"},
        {"cycle a() { units; }", "1:18 K1201 a name is missing behind `units`"},
        {"property x (length w) { }", "1:10 K1214 a title in quotes is missing behind `property`"},
        {"cycle a(length) { }", "1:9 K1215 a parameter is a type and a name, not `length`"},
        {"cycle a(d) { }", "1:9 K1215 a parameter is a type and a name, not `d`"},
        {"cycle a(length d,) { }", "1:18 K1215 a parameter is a type and a name, not `)`"},
        {"import ;", "1:7 K1201 a name is missing behind `import`"},
        {"struct { length d; }", "1:7 K1201 a name is missing behind `struct`"},
        {"cycle a() { G1 X10 = 5; }",
         "1:16 K1202 `X10` is a word of NC blocks and cannot be a name"},
    });
}

TEST(Mistakes, Values) {
    expect_messages({
        {"cycle a() { G1 X=a*R5; }", "1:20 K1204 `R5` is a word of an NC block, not a value"},
        {"cycle a() { x = a * X10; }", "1:21 K1204 `X10` is a word of an NC block, not a value"},
        {"cycle a() { G1 X=d* Y5; }", "1:20 K1205 a value is missing behind `*`"},
        {"cycle a() { G1 X= ; }", "1:18 K1205 a value is missing behind `=`"},
        {"cycle a() { G1 X; }", "1:16 K1206 the address `X` has no value"},
        {"cycle a() { G1 X Y5; }", "1:16 K1206 the address `X` has no value"},
        {"cycle a() { if (n = 3) M8; }", "1:19 K1207 `=` compares nothing here; did you mean `==`"},
        {"cycle a() { x = (y = 5) + 1; }", "1:20 K1208 `=` cannot stand inside a value"},
        {"cycle a() { G1 Q=10; }", "1:16 K4101 `Q` is no word of the dialect iso"},
        {"cycle a() { G1 X10 Q=5 F100; }", "1:20 K4101 `Q` is no word of the dialect iso"},
        {"cycle a() { G1 X=a Q=5; }", "1:20 K4101 `Q` is no word of the dialect iso"},
        {"cycle a() { G1 X=a*Q=5; }", "1:21 K1208 `=` cannot stand inside a value"},
        {"cycle a() { drill(to = -5mm); }",
         "1:22 K1209 the argument `to` is given with `:`, not with `=`"},
        {R"(cycle a() { note "{}"; })", "1:20 K1205 a value is missing behind `\"{`"},
        {"cycle a() { x = ; }", "1:16 K1205 a value is missing behind `=`"},
        {"cycle a() { x = a + ; }", "1:20 K1205 a value is missing behind `+`"},
        {"cycle a() { f(,5); }", "1:15 K1205 a value is missing behind `(`"},
        {"cycle a() { f(5,); }", "1:17 K1205 a value is missing behind `,`"},
        {"program p(length w = ) { M30; }", "1:21 K1205 a value is missing behind `=`"},
        {"cycle a() { x === 5; }", "1:17 K1205 a value is missing behind `==`"},
        {"cycle a() { x = a <> b; }", "1:20 K1205 a value is missing behind `<`"},
        {"cycle a() { g1 x10; }", "1:13 K1213 words of NC blocks are written in upper case: `G1`"},
        {"cycle a() { G1 X(5); }", "1:16 K1206 the address `X` has no value"},
        {"cycle a() { G1 X=a Y=b C; }", "1:24 K1206 the address `C` has no value"},
        {"cycle a() { g0 z5; g1 x10 y=5 f200; }",
         "1:13 K1213 words of NC blocks are written in upper case: `G0`\n"
         "1:20 K1213 words of NC blocks are written in upper case: `G1`"},
        {"cycle a() { raw G65 P1; }", "1:16 K1205 a value is missing behind `raw`"},
        {"cycle a() { note; }", "1:17 K1205 a value is missing behind `note`"},
        {R"(property "x" (length w in ) { })", "1:26 K1205 a value is missing behind `in`"},
        {"cycle a() { x = a ?? ; }", "1:21 K1205 a value is missing behind `??`"},
        {"cycle a() { a = b = c; }", "1:19 K1208 `=` cannot stand inside a value"},
        {"cycle a() { switch (n) { case: M8; } }", "1:30 K1205 a value is missing behind `case`"},
        {"cycle a() { CYCLE83(1, , 2); }", "1:23 K1205 a value is missing behind `,`"},
    });
}

TEST(Mistakes, NumbersAndUnits) {
    expect_messages({
        {"cycle a() { G1 X10,5 F100; }", "1:16 K1024 `X10,5` has a decimal comma"},
        {"cycle a() { G1 X=10,5; }", "1:18 K1024 `10,5` has a decimal comma"},
        {"cycle a() { length b = 10,5mm; }", "1:24 K1024 `10,5mm` has a decimal comma"},
        {"cycle a() { length b = 5, c = 6; }", "1:25 K1211 a declaration has one name"},
        {"cycle a() { length b = 10 mm; }",
         "1:27 K1025 the unit `mm` stands apart from its number"},
        {"cycle a() { dwell(5 s); }", "1:21 K1025 the unit `s` stands apart from its number"},
        {"cycle a() { feed b = 100 mm/min; }",
         "1:26 K1025 the unit `mm/min` stands apart from its number"},
    });
}

TEST(Mistakes, WordsOfOtherLanguages) {
    expect_messages({
        {"cycle a() { IF (n > 3) M8; }", "1:13 K1217 keywords are written in lower case: `if`"},
        {"cycle a() { While (n > 3) { M8; } }",
         "1:13 K1217 keywords are written in lower case: `while`"},
        {"cycle a() { if (n > 2 and n < 5) M8; }", "1:23 K1114 unexpected `and` behind `2`"},
        {"language ru;\nцикл a() { note \"x\"; M8; }",
         "2:12 K1020 `note` is `заметка` in the keyword language `ru`"},
        {"language ru;\nцикл a() { contour c = { G1 X0; X1; }; }",
         "2:12 K1020 `contour` is `контур` in the keyword language `ru`"},
        {"language ru;\ntest \"x\" { M8; }",
         "2:1 K1020 `test` is `тест` in the keyword language `ru`"},
        // Names of the author's.
        {"language ru;\nструктура contour { целое a; }\nцикл a() { contour c = {1}; note n; }", ""},
    });
}

TEST(Mistakes, StatementsOfControls) {
    expect_messages({
        {"cycle a() { GO X5; NO = 5; x = GO; }",
         "1:13 K1220 `GO` has a letter for a digit; the word is `G0`"},
        {R"(cycle a() {
    IF [n EQ 5] GOTO 10
    ENDWHILE
    G0 Z5
})",
         "2:5 K1217 keywords are written in lower case: `if`\n"
         "3:5 K1219 `ENDWHILE` begins no statement here\n"
         "4:10 K1101 `;` is missing behind this block"},
        {"cycle a() { DO { M8; } WHILE (n < 5); while (n < 5) { } }",
         "1:13 K1217 keywords are written in lower case: `do`\n"
         "1:24 K1217 keywords are written in lower case: `while`"},
        // Names of the program that are words of other languages.
        {R"(enum e {
    end
}
cycle a() {
    real[] list = {
        end
    };
    list = {1, 2,
        loop
    };
    x = c ? 1 :
        proc
    ;
    end
        = 5;
    For(n);
    While(n);
    Do = 5;
    if (n > 3) Return(x);
})",
         ""},
    });
}

TEST(Mistakes, ArraysOfArrays) {
    expect_messages({
        {"cycle a() { int[][] m; }", "1:13 K1216 there are no arrays of arrays"},
        {"cycle a() { hole[2][3] rows; }", "1:13 K1216 there are no arrays of arrays"},
        {"void f(int[][] m) { M8; }", "1:8 K1216 there are no arrays of arrays"},
        {"struct s { int[][] m; }", "1:12 K1216 there are no arrays of arrays"},
        {"int[][] m;", "1:1 K1216 there are no arrays of arrays"},
        {"cycle a() { m[1][2] = 3; x = m[1][2]; }", ""},
        {"length? f(bool b) { return 1; }", ""},
    });
}

/// What is proposed mends the mistake it is proposed for.
TEST(Mistakes, FixesMend) {
    for (const std::string& text : std::vector<std::string>{
             "cycle a() { G1 X10,5 F100; }",
             "cycle a() { length b = 10,5mm; }",
             "cycle a() { length b = 10 mm; }",
             "cycle a() { feed b = 100 mm/min; }",
             "cycle a() { IF (n > 3) M8; }",
             "cycle a() { if (n > 2 AND n < 5) M8; }",
             "cycle a() { if n > 3 { M8; } }",
             "cycle a() { if n > 3 M8; }",
             "cycle a() { while n + (2) > 3 { M8; } }",
             "cycle a() { for int i = 0; i < 3; i++ { M8; } }",
             "language ru;\nцикл a() { note \"x\"; }",
         }) {
        SCOPED_TRACE(text);
        const Parsed wrong(text);
        ASSERT_EQ(wrong.list.all().size(), 1u);
        ASSERT_FALSE(wrong.list.all()[0].fixes.empty());
        const Diagnostic::Fix& fix = wrong.list.all()[0].fixes[0];
        std::string mended = text;
        mended.replace(fix.range.begin, fix.range.end - fix.range.begin, fix.replacement);
        EXPECT_EQ(Parsed(mended).messages(), "") << mended;
    }
}

TEST(Mistakes, Several) {
    expect_messages({
        // A body outside of everything, with a mistake behind which the parser looks far ahead.
        {"++{if(p;else",
         "1:8 K1102 `)` is missing\n"
         "1:13 K1102 `}` is missing"},
        {"program p(length w length h) { G0 Z5 }",
         "1:19 K1113 `,` is missing between `w` and `length`\n"
         "1:37 K1101 `;` is missing behind this block"},
        {R"(cycle a() {
    // a first mistake does not hide the others
    x = (1 + ;
    G1 X=;
    if (n = 3) { G0 Z5 }
    for (int i = 0; i < 3; i++) { drill(to = 5); }
}
cycle b() { G1 Х5; })",
         "3:13 K1102 `)` is missing\n"
         "4:10 K1205 a value is missing behind `=`\n"
         "5:11 K1207 `=` compares nothing here; did you mean `==`\n"
         "5:23 K1101 `;` is missing behind this block\n"
         "6:44 K1209 the argument `to` is given with `:`, not with `=`\n"
         "8:16 K1019 `Х5` is written with Cyrillic letters; the word is `X5`"},
        {R"(program p() {
    G0 Z5;
    cycle b() { M8; }
    x = ;
})",
         "3:5 K1109 `cycle` cannot be declared inside of a program, cycle or function\n"
         "4:8 K1205 a value is missing behind `=`"},
        {"cycle a() { return if; }", "1:20 K1114 unexpected `if` behind `return`"},
    });
}

}  // namespace
}  // namespace kadr::syntax::mistakes_test
