// What registers and instructions are called: variables with the instructions in which they live,
// and where statements begin.
#include <gtest/gtest.h>

#include "tests/sema/running.h"

namespace kadr::testing::names_test {
namespace {

std::string names_of(const std::string& source) {
    RunOptions options;
    options.keeps_names = true;
    const Checked checked = check_program(source, options);
    return checked.code == nullptr ? "it has errors" : print_names(*checked.code, *checked.sources);
}

TEST(Names, OnlyOnWish) {
    const Checked checked = check_program("program p() { int n = 1; n++; X=n; }");
    ASSERT_TRUE(checked.code != nullptr);
    EXPECT_TRUE(checked.code->names.variables.empty());
    EXPECT_TRUE(checked.code->names.statements.empty());
    EXPECT_TRUE(checked.code->names.starts.empty());
}

/// The code is that of a check without names.
TEST(Names, CostNoInstruction) {
    const std::string source =
        "real s;\nvoid f(real& a) { while (a < 9) a += 1; }\n"
        "program p() { f(s); for (int i : 1..3) { if (i > 2) break; else X=i; } }";
    RunOptions options;
    options.keeps_names = true;
    const Checked with = check_program(source, options);
    const Checked without = check_program(source);
    ASSERT_TRUE(with.code != nullptr && without.code != nullptr);
    EXPECT_EQ(print(*with.code), print(*without.code));
}

TEST(Names, ALoop) {
    // Behind the pass the counter is still there: its condition looks at it.
    EXPECT_EQ(names_of("program p(length a, int n = 3) {\n    real s = 0;\n"
                       "    for (int i = 1; i <= n; i++) {\n        s = s + i*0.5;\n    }\n"
                       "    X=s Y=a;\n}\n"),
              "globals:\n"
              "p:\n"
              "  1 to 15: length a in r0\n"
              "  1 to 15: int n in r1\n"
              "  4 to 14: real s in r2\n"
              "  5 to 11: int i in r3\n"
              "  3 | real s = 0;\n"
              "  4 | int i = 1\n"
              "  7 | s = s + i*0.5;\n"
              "  10 | i++\n"
              "  11 | X=s Y=a;\n");
}

/// Of a statement with a body the head; a `while` begins where it looks whether to go on.
TEST(Names, HeadsOfBodies) {
    EXPECT_EQ(names_of("program p() {\n    int n = 0;\n    const int most = 3;\n"
                       "    while (n < most)\n    {\n        n++;\n    }\n"
                       "    do { n--; } while (n > 0);\n    if (n == 0) { n = 5; } else X1;\n"
                       "    switch (n) { case 5: Y1; }\n    with G91 { Z1; }\n}\n"),
              "globals:\n"
              "p:\n"
              "  2 to 24: int n in r0\n"
              "  2 to 24: int most constant\n"
              "  1 | int n = 0;\n"
              "  4 | n++;\n"
              "  5 | while (n < most)\n"
              "  7 | n--;\n"
              "  8 | n > 0\n"
              "  9 | if (n == 0)\n"
              "  10 | n = 5;\n"
              "  12 | X1;\n"
              "  14 | switch (n)\n"
              "  17 | Y1;\n"
              "  19 | with G91\n"
              "  21 | Z1;\n"
              "  23 | }\n");
}

TEST(Names, AllKindsOfVariables) {
    EXPECT_EQ(names_of(R"(const length wall = 4mm;
length depth = wall*2;
enum side { left, right }
struct hole { point at; length d; }
void grow(hole[]& holes, length? by) {
    for (hole& h : holes) { if (given by) h.d += by; }
    for (int i : 1..2) holes.append({{x: 1mm, y: 2mm}, 3mm});
}
program p(string text = "a", side s = right) {
    hole[] all;
    grow(all, depth);
    contour c = { G0 X0 Y0; G1 X10; Y10; };
    note "{text} {s} {c.length}";
}
)"),
              R"(length wall constant
length depth in global 0
globals:
  0 | length depth = wall*2;
grow:
  3 to 35: hole[]& holes by r0
  3 to 35: length? by in r1
  7 to 20: hole& h by r6
  22 to 34: int i in r4
  5 | for (hole& h : holes)
  13 | if (given by)
  15 | h.d += by;
  18 | hole& h : holes
  20 | for (int i : 1..2)
  25 | holes.append({{x: 1mm, y: 2mm}, 3mm});
  33 | int i : 1..2
p:
  35 to 61: string text in r0
  35 to 61: side s in r1
  40 to 60: hole[] all in r2
  54 to 60: contour c in r3
  39 | hole[] all;
  40 | grow(all, depth);
  45 | contour c =
  46 | G0 X0 Y0;
  49 | G1 X10;
  51 | Y10;
  54 | note "{text} {s} {c.length}";
)");
}

}  // namespace
}  // namespace kadr::testing::names_test
