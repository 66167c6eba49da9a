// What expressions come to. Each row is a body of a program and the blocks that it makes; `note`
// shows values, lengths in mm.
#include <gtest/gtest.h>

#include "base/diagnostics/sema.h"
#include "tests/sema/running.h"

namespace kadr::testing::values_test {
namespace {

struct Row {
    const char* source;
    const char* blocks;
};

void expect_rows(std::initializer_list<Row> rows) {
    for (const Row& row : rows) {
        SCOPED_TRACE(row.source);
        const Outcome outcome = run_body(row.source);
        // What is compared here is exact on purpose.
        for (const std::string& message : outcome.messages) {
            EXPECT_TRUE(message.ends_with(diag::RealEquality.code)) << outcome.all_messages();
        }
        EXPECT_EQ(outcome.all_blocks(), row.blocks);
    }
}

/// Rows `expression` → what `note "{expression}"` shows.
void expect_notes(std::initializer_list<Row> rows) {
    for (const Row& row : rows) {
        SCOPED_TRACE(row.source);
        const Outcome outcome = run_body("note \"{" + std::string(row.source) + "}\";");
        EXPECT_EQ(outcome.all_messages(), "");
        EXPECT_EQ(outcome.all_blocks(), "comment \"" + std::string(row.blocks) + '"');
    }
}

TEST(Values, NumbersTakeTheUnitOfTheirPlace) {
    expect_rows({
        {"G1 X10 Y-5.25 F200;", "line X10 Y-5.25 F200"},
        {"G1 X=10;", "line X10"},
        {"G1 X=1in;", "line X25.4"},
        {"G1 X=5/2;", "line X2.5"},
        {"length d = 5; G1 X=d/2;", "line X2.5"},
        {"int i = 3; G1 X=10*i;", "line X30"},
        {"length d = 10; if (d == 10) M8; if (d > 9.5) M9;", "coolant_flood\ncoolant_off"},
        {"length d = 10mm; d += 5; G1 X=d;", "line X15"},
        {"length[] r = {5, 8, 12}; G1 X=r[2];", "line X12"},
        {"angle a = 30; G1 X=10*sin(a);", "line X5"},
        {"time t = 2; dwell(t);", "dwell(time=2)"},
        {"feed f = 200; F=f;", "F200"},
        {"speed s = 1500; S=s;", "S1500"},
        {"units inch; G1 X1 Y=1 Z=1mm; length d = 2; X=d;", "line X25.4 Y25.4 Z1\nX50.8"},
        {"units inch; F20; feed f = 10; F=f; F=254mm/min;", "F508\nF254\nF254"},
        {"units inch; length d = 25.4mm; note \"{d}\";", "comment \"1\""},
    });
}

TEST(Values, DiametersGoAcross) {
    expect_rows({
        {"diameter d = 40mm; G0 X=d;", "rapid X20"},
        {"diameter d = 40; DIAMON; G0 X=d;", "diameter_on\nrapid X40"},
        {"diameter d = 40; G0 X=d/2 Z=-d/4;", "rapid X20 Z-10"},
        {"diameter d = 40; G0 X=d + 4; X=2mm + d; X=-d;", "rapid X22\nX21\nX-20"},
        {"diameter d = 40; diameter e = 30; G0 X=d - e; if (d > e) X=e;", "rapid X5\nX15"},
        {"length r = 5; diameter d = diameter(2*r); G0 X=d; X+=d; X=IC(d);",
         "rapid X5\nX=IC(5)\nX=IC(5)"},
        {"diameter d = 40; length w = length(d); G0 X=w;", "rapid X40"},
        {"const length w = 40; diameter d = w; length v = 4; G0 X=d; X=length(v);",
         "rapid X20\nX4"},
        {"diameter[] all = {10, 20}; for (diameter d : all) G0 X=d;", "rapid X5\nrapid X10"},
        {"diameter d = 40; note \"{d} {d:u} {pi*d:.1}\";", "comment \"40 40 mm 125.7\""},
        {"units inch; diameter d = 2; G0 X=d;", "rapid X25.4"},
        {"real diameter = 3; G0 X=diameter;", "rapid X3"},
    });
}

TEST(Values, ThePositionIsAPoint) {
    expect_rows({
        {"G0 X1 Y2 Z3; point p = position; G0 p + {1mm, 1mm, 1mm};",
         "rapid X1 Y2 Z3\nrapid X2 Y3 Z4"},
        {"G0 X1; point p = position; note \"{given p.x} {given p.y}\";",
         "rapid X1\ncomment \"true false\""},
    });
}

TEST(Values, QuantitiesAreCoherent) {
    expect_notes({
        {"10mm + 1in", "35.4"},
        {"10mm * 10mm", "100"},
        {"100mm / 10mm", "10"},
        {"120m/min * 0.5s", "1000"},
        {"0.1mm/rev * 1500rpm", "150"},  // mm/min, as F is
        {"1rad", "57.2957795131"},
        {"90deg / 1rad", "1.57079632679"},
        {"1min + 30s", "90"},
        {"500ms", "0.5"},
        {"5um", "0.005"},
        {"28m/min/(pi*14mm)", "636.619772368"},
        {"sqrt(9mm*16mm)", "12"},
        {"hypot(3mm, 4mm)", "5"},
        {"pow(2mm, 3)", "8"},
    });
}

TEST(Values, WholeAndRealNumbers) {
    expect_notes({
        {"7 + 2*3", "13"},
        {"(7 + 2)*3", "27"},
        {"7 - 2 - 1", "4"},
        {"7 / 2", "3.5"},
        {"8 / 2", "4"},
        {"trunc(7/2)", "3"},
        {"trunc(-7/2)", "-3"},
        {"floor(-7/2)", "-4"},
        {"ceil(7/2)", "4"},
        {"round(2.5)", "3"},
        {"round(-2.5)", "-3"},
        {"round(2.345, 0.01)", "2.35"},
        {"round(12.3mm)", "12"},
        {"floor(12.7mm, 0.5mm)", "12.5"},
        {"-7 % 3", "-1"},
        {"7.5 % 2", "1.5"},
        {"mod(7, 3)", "1"},
        {"6 & 3", "2"},
        {"6 | 3", "7"},
        {"6 ^ 10", "12"},
        {"~0", "-1"},
        {"1 << 10", "1024"},
        {"-1024 >> 3", "-128"},
        {"abs(-3)", "3"},
        {"abs(-3.5mm)", "3.5"},
        {"sign(-2mm)", "-1"},
        {"min(3, 1, 2)", "1"},
        {"max(3mm, 1in)", "25.4"},
        {"real(3)/2", "1.5"},
        {"exp(0)", "1"},
        {"ln(1)", "0"},
        {"log10(1000)", "3"},
        {"cbrt(27)", "3"},
        {"1e3", "1000"},
    });
}

TEST(Values, AnglesAreDegreesAndExact) {
    expect_notes({
        {"sin(30)", "0.5"},
        {"sin(180deg)", "0"},
        {"cos(90deg)", "0"},
        {"cos(60deg)", "0.5"},
        {"cos(-240deg)", "-0.5"},
        {"sin(45deg) - cos(45deg)", "0"},
        {"tan(45deg)", "1"},
        {"tan(135deg)", "-1"},
        {"sin(1rad) == sin(1rad)", "true"},
        {"asin(0.5)", "30"},
        {"acos(0)", "90"},
        {"atan(1)", "45"},
        {"atan2(1, -1)", "135"},
        {"atan2(-1mm, 0mm)", "-90"},
        {"sin(36000000030deg)", "0.5"},
    });
}

TEST(Values, FormatsShowTheUnitIfAsked) {
    expect_rows({
        {"length d = 10; note \"{d:u} {d*d:u} {d:8.2u} {d/2mm:u}\";",
         "comment \"10 mm 100 mm^2    10.00 mm 5\""},
        {"units inch; length d = 25.4mm; note \"{d:.1u}\";", "comment \"1.0 in\""},
        {"feed f = 200; note \"{f:u}\"; f = 0.1mm/rev; note \"{f:u}\";",
         "comment \"200 mm/min\"\ncomment \"0.1 mm/rev\""},
        {"units inch; feed f = 0.254mm/rev; note \"{f:u}\";", "comment \"0.01 in/rev\""},
        {"speed s = 1500; note \"{s:u}\"; s = 120m/min; note \"{s:u}\";",
         "comment \"1500 rpm\"\ncomment \"120 m/min\""},
        {"int n = 3; bool b = true; note \"{n:02u} {b:u}\";", "comment \"03 true\""},
    });
}

TEST(Values, VariablesComputeAsConstantsDo) {
    expect_rows({
        {"int a = 7; int b = 2; note \"{a/b} {a%b} {a*b} {a-b} {-a} {a<<b} {a>>b} {a&b} {a|b} "
         "{a^b} {~a}\";",
         "comment \"3.5 1 14 5 -7 28 1 2 7 5 -8\""},
        {"real a = 7.5; real b = 2; note \"{a+b} {a-b} {a*b} {a/b} {a%b} {-a} {10-a} {15/a}\";",
         "comment \"9.5 5.5 15 3.75 1.5 -7.5 2.5 2\""},
        {"angle a = 60deg; note \"{cos(a)} {sin(a/2)} {tan(a*3/4)} {acos(cos(a))}\";",
         "comment \"0.5 0.5 1 60\""},
        {"real a = -2.5; note \"{trunc(a)} {floor(a)} {ceil(a)} {round(a)} {abs(a)} {sign(a)}\";",
         "comment \"-2 -3 -2 -3 2.5 -1\""},
        {"int a = -3; int b = 2; note \"{abs(a)} {min(a, b)} {max(a, b)} {sign(a)}\";",
         "comment \"3 -3 2 -1\""},
        {"real a = 9; real b = 2; note \"{sqrt(a)} {pow(a, b)} {hypot(a, b + 10)} {atan2(b, b)} "
         "{max(a, b)}\";",
         "comment \"3 81 15 45 9\""},
    });
}

TEST(Values, LogicAndComparison) {
    expect_notes({
        {"1 < 2", "true"},
        {"2 <= 1", "false"},
        {"1 == 1.0", "true"},
        {"10mm != 1cm", "false"},
        {"25.4mm == 1in", "true"},
        {"true && false", "false"},
        {"true || false", "true"},
        {"!true", "false"},
        {"1 < 2 ? 3 : 4", "3"},
    });
    expect_rows({
        // The right side runs only when it decides.
        {"int n = 0; bool b = n != 0 && 10/n > 1; note \"{b}\";", "comment \"false\""},
        {"int n = 5; bool b = n > 3 && n < 10 || n == 0; if (b) M8; if (!b) M9;", "coolant_flood"},
        {"int n = 5; if (n < 3 || n > 4) M8; else M9;", "coolant_flood"},
        {"int n = 5; if (!(n < 3 || n > 4)) M8; else M9;", "coolant_off"},
        {"int n = 5; real x = n > 3 ? 1.5 : 2; note \"{x}\";", "comment \"1.5\""},
        {"int n = 2; real x = n > 3 ? 1 : 2.5; note \"{x}\";", "comment \"2.5\""},
        {"int n = 2; note \"{n > 3 ? 1 : 2.5} {n > 1 ? 2.5 : n} {n > 3 ? 4.0 : n}\";",
         "comment \"2.5 2.5 2\""},
        {"length d = 5mm; int n = 2; length x = n > 3 ? 0 : d; note \"{x}\";", "comment \"5\""},
        {"real x = 1.5; bool b = x > 1; bool c = x <= 1; note \"{b} {c} {x == 1.5} {x != 1.5}\";",
         "comment \"true false true false\""},
    });
}

TEST(Values, AssignmentAndSteps) {
    expect_rows({
        {"int i = 1; i += 2; i *= 5; i -= 1; note \"{i}\";", "comment \"14\""},
        {"real x = 1; x /= 4; x *= 2; note \"{x}\";", "comment \"0.5\""},
        {"int i = 7; i %= 4; note \"{i}\";", "comment \"3\""},
        {"int i = 3; i <<= 2; i |= 3; i ^= 1; i &= 14; i >>= 1; note \"{i}\";", "comment \"7\""},
        {"bool b = true; b &= false; b |= true; b ^= true; note \"{b}\";", "comment \"false\""},
        {"int i = 1; int a = i++; int b = ++i; note \"{a} {b} {i}\";", "comment \"1 3 3\""},
        {"int i = 5; int a = i-- - --i; note \"{a} {i}\";", "comment \"2 3\""},
        {"int i = 2; int a = i + i++; note \"{a}\";", "comment \"4\""},
        {"length x = 1; x = x + x*2; note \"{x}\";", "comment \"3\""},
        {"string s = \"a\"; s += \"b\"; s += 3; note s;", "comment \"ab3\""},
        {"point p = {1mm, 2mm}; p = {p.y, p.x}; note \"{p.x} {p.y}\";", "comment \"2 1\""},
    });
}

TEST(Values, Texts) {
    expect_rows({
        {"real x = 3.14159; note \"{x:.3}|{x:8.2}|{x:08.2}\";",
         "comment \"3.142|    3.14|00003.14\""},
        {"int i = 7; note \"{i:03} {-i:03}\";", "comment \"007 -07\""},
        {"length w = 120mm; note \"{w:.0} {w:.1}\";", "comment \"120 120.0\""},
        {"note \"a\" + \"b\" + 1 + 2.5mm;", "comment \"ab12.5\""},
        {"note \"{0.1 + 0.2}\";", "comment \"0.3\""},
        {"string s = \"G83 X1\"; if (s contains \"G83\") M8; if (s contains \"G84\") M9;",
         "coolant_flood"},
        {"string s = \"abc\"; string t = \"abd\"; note \"{s.count} {s < t} {s == t} {s != t}\"; if "
         "(s == \"abc\") M8;",
         "comment \"3 true false true\"\ncoolant_flood"},
        {"note text(5mm) + text(true);", "comment \"5true\""},
        {"feed f = 200mm/min; feed g = 0.2mm/rev; speed s = 1500rpm; note \"{f} {g} {s}\";",
         "comment \"200 0.2 1500\""},
    });
}

TEST(Values, PointsAndVectors) {
    expect_rows({
        {"point p = {10mm, 20mm}; G1 p;", "line X10 Y20"},
        {"point p = {10, 20, 30}; G1 p; G0 Z=p.z;", "line X10 Y20 Z30\nrapid Z30"},
        {"point p; p.x = 5mm; G1 p;", "line X5"},
        {"point a = {1mm, 2mm}; point b = {10mm, 20mm}; G1 a + b; G1 b - a; point c = a*3; G1 c; c "
         "= b/2; G1 c;",
         "line X11 Y22\nline X9 Y18\nline X3 Y6\nline X5 Y10"},
        {"vector v = {0.6, 0.8}; point p = v*10mm; G1 p;", "line X6 Y8"},
        {"G1 {1mm, 2mm};", "line X1 Y2"},
        {"point p = {1mm, 2mm}; note \"{given p.z} {given p.x} {given p} {p.z ?? 7mm}\";",
         "comment \"false true true 7\""},
        {"point a = {0mm, 0mm}; point b = {3mm, 4mm}; note \"{distance(a, b)} {a == b} {a != b}\";",
         "comment \"5 false true\""},
        {"point a = {1mm, 2mm}; point b = {1mm, 2mm}; if (a == b) M8;", "coolant_flood"},
        {"point b = {1mm, 2mm}; point a = -b; G1 a;", "line X-1 Y-2"},
    });
}

TEST(Values, Arrays) {
    expect_rows({
        {"int[] a; a.append(1); a.add(2); a.insert(0, 9); note \"{a.count} {a[0]} {a[2]}\";",
         "comment \"3 9 2\""},
        {"int[] a = {1, 2, 3}; a.remove(0); int b = a.pop(); note \"{a.count} {b} {a[0]}\";",
         "comment \"1 3 2\""},
        {"int[] a = {1, 2, 3}; int[] b = a; b[0] = 9; note \"{a[0]} {b[0]}\";", "comment \"1 9\""},
        {"int[] a = {1}; int[] b = {2}; b = a; b.append(5); note \"{a.count} {b.count}\";",
         "comment \"1 2\""},
        {"int[] a = {1, 2}; a.clear(); note \"{a.count}\";", "comment \"0\""},
        {"real[3] a = {1, 2, 3}; a[1] = 7.5; note \"{a[1]} {a.count}\";", "comment \"7.5 3\""},
        {"int[3] a; a[0] = 1; a[1] = a[0] + 1; note \"{a[1]}\";", "comment \"2\""},
        {"point[] q = {{1mm, 2mm}, {3mm, 4mm}}; point r = {3mm, 4mm}; note \"{q contains r}\"; "
         "r.z = 0; note \"{q contains r}\";",
         "comment \"true\"\ncomment \"false\""},
        {"length a = cbrt(27mm*1mm*1mm); length v = 2; X=a Y=cbrt(v*v*v) Z=cbrt(8);", "X3 Y2 Z2"},
        {"note \"{50%} {-25%}\";", "comment \"0.5 -0.25\""},
        // Without `&` the elements are those that the list had.
        {"int[] a = {1, 2, 3, 4}; for (int v : a) { if (v == 2) a.remove(1); X=v; }",
         "X1\nX2\nX3\nX4"},
        {"int[] a = {1, 2}; for (int v : a) { a.append(v); X=v; } X=a.count;", "X1\nX2\nX4"},
        {"int[] a = {1, 2}; for (int& v : a) { a[1] = 7; X=v; }", "X1\nX7"},
        // Cutting data of variables.
        {"speed vc = 120m/min; length d = 30mm; S=vc/(pi*d)*pi; feed v = 120m/min; S=v/d;",
         "S4000\nS4000"},
        {"feed fz = 0.1mm/rev; speed n = 1000rpm; feed f = fz*n; F=f; f = fz*1000rpm; F=f*2; "
         "speed vc = 100m/min; length d = 100mm; F=2*fz*(vc/d);",
         "F100\nF200\nF200"},
        {"speed n = 1000rpm; length d = 50mm; G96; speed vc = d*n; S=vc;", "cutting_speed_on\nS50"},
        {"speed vc = 100m/min; length d = 100mm; speed n = 900rpm; note \"{vc/d > n} {vc/d < "
         "2000rpm}\"; S=min(vc/d, n);",
         "comment \"true true\"\nS900"},
        {"int[] a = {3, 5}; if (a contains 5) M8; if (a contains 4) M9;", "coolant_flood"},
        {"string[] a = {\"x\", \"y\"}; if (a contains \"y\") M8; note a[0] + a[1];",
         "coolant_flood\ncomment \"xy\""},
        {"point[] a = {{1mm, 2mm}, {3mm, 4mm}}; a[1].x = 9mm; G1 a[1]; G1 X=a[0].y;",
         "line X9 Y4\nline X2"},
        {"int s = 0; for (int i : {1, 2, 3}) s += i; note \"{s}\";", "comment \"6\""},
        {"int[] a = {1, 2, 3}; for (int& i : a) i *= 2; note \"{a[0]} {a[2]}\";",
         "comment \"2 6\""},
        {"int[] a = {1, 2, 3}; a[1] += 10; a[0]++; note \"{a[0]} {a[1]}\";", "comment \"2 12\""},
        {"auto a = {1mm, 2mm}; G1 a;", "line X1 Y2"},
        {"length[] r = {5,8,12}; r.append(3); note \"{r.count}\";", "comment \"4\""},
    });
}

TEST(Values, Optionals) {
    expect_rows({
        {"length? b; note \"{given b}\"; b = 3mm; note \"{given b} {b}\";",
         "comment \"false\"\ncomment \"true 3\""},
        {"length? b; G1 X=b ?? 3mm;", "line X3"},
        {"length? b = 2mm; G1 X=b ?? 3mm;", "line X2"},
        {"int? n; note \"{n ?? 7}\";", "comment \"7\""},
        {"string? s; note s ?? \"none\";", "comment \"none\""},
        {"point? a; point b = a ?? {1mm, 2mm}; G1 b;", "line X1 Y2"},
        {"point a; a.y = 3mm; point b = a ?? {1mm, 2mm}; G1 b;", "line Y3"},
        {"int n = 7; int k = n == 1 ? 1 : n == 2 ? 2 : n == 3 ? 3 : n == 4 ? 4 : n == 5 ? 5 : n == "
         "6 ? 6 : 9; X=k;",
         "X9"},
        {"length d = 3mm; int n = 1; length x = n > 3 ? 0 : abs(d); X=x;", "X3"},
        {"length? a; length? b = 5mm; G1 X=a ?? b ?? 1mm;", "line X5"},
        {"int n = 1; length? b; if (n > 0) b = 5mm; if (given b) G1 X=b;", "line X5"},
    });
}

TEST(Values, MembersBeginWithTheirDefaults) {
    const std::string types =
        "struct drill { length d = 6mm; int n; }\n"
        "struct hole { point at; length d = 6mm; int[] list; drill tool; drill? spare; }\nhole "
        "g;\n";
    const auto body = [&](const std::string& text) {
        return run(types + "program p() { " + text + " }");
    };
    EXPECT_EQ(body("hole h; h.at = {1mm, 2mm}; G0 X=h.d Y=h.tool.d Z=g.d;").all_blocks(),
              "rapid X6 Y6 Z6");
    EXPECT_EQ(
        body("hole[3] hs; hs[1].list.append(4); G0 X=hs[2].d Y=hs[2].list.count;").all_blocks(),
        "rapid X6 Y0");
    EXPECT_EQ(body("hole h; X=h.tool.n;").all_messages(), "4:25 K3104 `h.tool.n` is not given");
    EXPECT_EQ(body("hole h; if (!given h.spare) M8;").all_blocks(), "coolant_flood");
    EXPECT_EQ(body("hole? h; if (!given h) M8;").all_blocks(), "coolant_flood");
}

TEST(Values, StructsAndEnums) {
    const char* declarations =
        "enum side { left, right = 5, top }\n"
        "struct hole { point at; length d = 8mm; int n = 1; }\n"
        "const side start = right;\n"
        "program p() { ";
    const Row rows[] = {
        {"side s = left; if (s == left) M8; note \"{s} {start} {side.top == top}\";",
         "coolant_flood\ncomment \"left right true\""},
        {"hole h = {{1mm, 2mm}}; note \"{h.at.x} {h.d} {h.n}\";", "comment \"1 8 1\""},
        {"hole h = {{1mm, 2mm}, 5mm, 3}; hole g = h; g.d = 6mm; note \"{h.d} {g.d} {g.n}\";",
         "comment \"5 6 3\""},
        {"hole[] all; all.append({{1mm, 2mm}}); all.append({{3mm, 4mm}, 9mm}); for (hole h : all) "
         "G1 h.at;",
         "line X1 Y2\nline X3 Y4"},
        {"hole[] all = {{{1mm, 2mm}}, {{3mm, 4mm}}}; all[1].d = 2mm; hole h = all[1]; note \"{h.d} "
         "{all[0].d}\";",
         "comment \"2 8\""},
        {"hole h; h.d = 3mm; h.n = 2; note \"{h.d} {h.n}\";", "comment \"3 2\""},
        {"switch (start) { case left: M8; break; case right: M9; break; default: M5; }",
         "coolant_off"},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.source);
        const Outcome outcome = run(declarations + std::string(row.source) + " }");
        EXPECT_EQ(outcome.all_messages(), "");
        EXPECT_EQ(outcome.all_blocks(), row.blocks);
    }
}

TEST(Values, FeedsKeepTheirForm) {
    const char* declarations =
        "feed twice(feed f) { return f*2; }\n"
        "feed larger(feed a, feed b) { return a > b ? a : b; }\n"
        "time way_time(length way, feed f) { return way/f; }\n"
        "program p() { ";
    const Row rows[] = {
        {"F=twice(100mm/min);", "F200"},
        {"G95; F=twice(0.1mm/rev);", "feed_per_revolution\nF0.2"},
        {"F=larger(100mm/min, 4mm/s);", "F240"},
        {"dwell(way_time(10mm, 600mm/min));", "dwell(time=1)"},
        {"feed f = 100mm/min; F=f*10mm/20mm;", "F50"},
        {"G95; length pitch = 1.5mm; F=pitch;", "feed_per_revolution\nF1.5"},
        {"G93; time t = 30s; F=1/t;", "feed_inverse_time\nF2"},
        {"G96; S=120m/min; G97; S=1500rpm;", "cutting_speed_on\nS120\ncutting_speed_off\nS1500"},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.source);
        const Outcome outcome = run(declarations + std::string(row.source) + " }");
        EXPECT_EQ(outcome.all_messages(), "");
        EXPECT_EQ(outcome.all_blocks(), row.blocks);
    }
}

}  // namespace
}  // namespace kadr::testing::values_test
