// Statements and the blocks that they make.
#include <gtest/gtest.h>

#include "tests/sema/running.h"

namespace kadr::testing::blocks_test {
namespace {

struct Row {
    const char* source;
    const char* blocks;
};

void expect_rows(std::initializer_list<Row> rows) {
    for (const Row& row : rows) {
        SCOPED_TRACE(row.source);
        const Outcome outcome = run_body(row.source);
        EXPECT_EQ(outcome.all_messages(), "");
        EXPECT_EQ(outcome.all_blocks(), row.blocks);
    }
}

TEST(Blocks, Loops) {
    expect_rows({
        {"for (int i = 0; i < 3; i++) G1 X=10*cos(i*90deg) Y=10mm*sin(i*90deg);",
         "line X10 Y0\nline X0 Y10\nline X-10 Y0"},
        {"for (int i = 3; i > 0; i--) X=i;", "X3\nX2\nX1"},
        {"for (int i = 0; i <= 6; i += 3) X=i;", "X0\nX3\nX6"},
        {"const int n = 2; for (int i = 0; i < n; i++) X=i;", "X0\nX1"},
        {"int n = 2; for (int i = 0; i < n; i++) { X=i; if (i == 0) n = 3; }", "X0\nX1\nX2"},
        {"for (length x = 0mm; x < 5mm; x += 2mm) X=x;", "X0\nX2\nX4"},
        {"for (int i : 1..3) X=i;", "X1\nX2\nX3"},
        {"int n = 3; for (int i : n..1) X=i;", ""},
        {"int i = 0; while (i < 2) { X=i; i++; }", "X0\nX1"},
        {"int i = 5; do { X=i; i++; } while (i < 2);", "X5"},
        {"int i = 0; while (true) { i++; if (i == 2) continue; if (i > 3) break; X=i; }", "X1\nX3"},
        {"for (int i = 0; i < 3; i++) { for (int k = 0; k < 3; k++) { if (k == 1) break; X=i Y=k; "
         "} }",
         "X0 Y0\nX1 Y0\nX2 Y0"},
        {"for (;;) { M8; break; }", "coolant_flood"},
        {"for (point p : {{1mm, 2mm}, {3mm, 4mm}}) G0 p;", "rapid X1 Y2\nrapid X3 Y4"},
    });
}

TEST(Blocks, Switches) {
    expect_rows({
        {"switch (2) { case 1: M7; case 2: M8; case 3: M9; }", "coolant_flood\ncoolant_off"},
        {"switch (9) { case 1: M7; break; default: M8; break; case 3: M9; }", "coolant_flood"},
        {"int n = 4; switch (n) { case 1, 2: M7; break; case 3..5: M8; break; }", "coolant_flood"},
        {"string s = \"b\"; switch (s) { case \"a\": M7; break; case \"b\": M8; }",
         "coolant_flood"},
        {"int n = 100000; switch (n) { case 100000: M8; }", "coolant_flood"},
    });
}

TEST(Blocks, Words) {
    expect_rows({
        {"G2 X10 Y10 I5 J0 F200;", "arc_cw X10 Y10 I5 J0 F200"},
        {"G3 X=10 Y10 CR=20;", "arc_ccw X10 Y10 R20"},
        {"X+=10mm Y-=5mm;", "X=IC(10) Y=IC(-5)"},
        {"G4 P0.5;", "dwell(time=0.5)"},
        {"time t = 500ms; G4 P=t;", "dwell(time=0.5)"},
        {"T3 M6;", "tool_select(tool=3) | tool_change"},
        {"int n = 3; T=n;", "tool_select(tool=3)"},
        {"int n = 2; G54.1 P=n;", "work_offset(number=8)"},
        {"G55;", "work_offset(number=2)"},
        {"N10 G1 X1;", "N10 line X1"},
        {"G1 X10mm Y1in;", "line X10 Y25.4"},
        {"F200mm/min;", "F200"},
    });
}

TEST(Blocks, Commands) {
    expect_rows({
        {"tool(3);", "tool(tool=3)"},
        {"dwell(time: 0.5s); dwell(0.5s); dwell(0.5);",
         "dwell(time=0.5)\ndwell(time=0.5)\ndwell(time=0.5)"},
        {"shift(x: 10mm); shift();", "shift(x=10)\nshift"},
        {"rotate(30deg);", "rotate(angle=30)"},
        {"mirror(x: 0);", "mirror(x=0)"},
        {"message(\"part {1+1}\");", "message(text=\"part 2\")"},
        {"speed_limit(3000rpm); speed_limit(2500);",
         "speed_limit(limit=3000)\nspeed_limit(limit=2500)"},
        {"stop(); optional_stop();", "stop\noptional_stop"},
        {"work_offset(2);", "work_offset(number=2)"},
    });
}

TEST(Blocks, TextsGoThrough) {
    expect_rows({
        {"note \"a {1 + 1}\";", "comment \"a 2\""},
        // No `;` behind the brace, whatever comes next.
        {"raw { A } length w = 3; raw { B } note \"{w}\"; raw { C } raw \"D\";",
         "raw \"A\"\nraw \"B\"\ncomment \"3\"\nraw \"C\"\nraw \"D\""},
        {"raw \"G65 P9810 X{2.5mm}\";", "raw \"G65 P9810 X2.5\""},
        {"raw \"A\\nB\\nC\\nD\\nE\";", "raw \"A\"\nraw \"B\"\nraw \"C\"\nraw \"D\"\nraw \"E\""},
    });
}

TEST(Blocks, Units) {
    const Outcome inch = run("units inch;\nprogram p(length x = 2) { G20; G1 X=x Y=1mm F10; }");
    EXPECT_EQ(inch.all_messages(), "");
    EXPECT_EQ(inch.all_blocks(), "inch\nline X50.8 Y1 F254");
    // A library in mm stays in mm when an inch program uses it.
    RunOptions options;
    options.modules["lib"] = "length ten() { return 10; }";
    const Outcome mixed = run("import lib;\nprogram p() { units inch; G1 X=ten() Y=1; }", options);
    EXPECT_EQ(mixed.all_messages(), "");
    EXPECT_EQ(mixed.all_blocks(), "line X10 Y25.4");
}

}  // namespace
}  // namespace kadr::testing::blocks_test
