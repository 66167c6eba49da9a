// The code that comes out: what a loop costs can be read here.
#include <gtest/gtest.h>

#include "tests/sema/running.h"

namespace kadr::testing::code_test {
namespace {

TEST(Code, ALoopTurnsWithOneInstruction) {
    const Outcome outcome =
        check("program p() { real s = 0; for (int i = 1; i <= 1000; i++) s = s + i*0.5; X=s; }");
    EXPECT_EQ(outcome.code,
              "globals: 0 registers\n"
              "  0 Return r0,0\n"
              "p: 5 registers\n"
              "  1 LoadF r0,0\n"
              "  2 LoadI r1,1\n"
              "  3 LoadI r2,1000\n"
              "  4 LoopStart 0\n"
              "  5 JumpGtIK r1,1000,@10\n"
              "  6 IntToReal r3,r1\n"
              "  7 MulFK r3,r3,0.5\n"
              "  8 AddF r0,r0,r3\n"
              "  9 ForLeI r1,r2,1,@6,0\n"
              "  10 Move r1,r0\n"
              "  11 Emit r1,r0,0,0,1\n"
              "  12 Return r0,0\n");
}

TEST(Code, ConstantsLeaveNoTrace) {
    const Outcome outcome = check(
        "const length top = 2*wall + 1mm;\nconst length wall = 4mm;\n"
        "program p() { const int n = 3; X=top/n; if (n > 5) Y1; }");
    EXPECT_EQ(outcome.code,
              "globals: 0 registers\n"
              "  0 Return r0,0\n"
              "p: 1 registers\n"
              "  1 LoadF r0,3\n"
              "  2 Emit r0,r0,0,0,0\n"
              "  3 Jump @6\n"
              "  4 LoadF r0,1\n"
              "  5 Emit r0,r0,0,1,1\n"
              "  6 Return r0,0\n");
}

TEST(Code, ShapesOfBlocksAreShared) {
    const Checked checked = check_program("program p() { G1 X1 Y2; G1 X3 Y4; G1 X5; }");
    ASSERT_TRUE(checked.code != nullptr);
    EXPECT_EQ(checked.code->plans.size(), 2u);
}

}  // namespace
}  // namespace kadr::testing::code_test
