// Limits: a program that would not end says so.
#include <atomic>
#include <chrono>

#include <gtest/gtest.h>

#include "tests/sema/running.h"

namespace kadr::testing::limits_test {
namespace {

RunOptions with_limits(expand::RunLimits limits) {
    RunOptions options;
    options.expand.limits = limits;
    return options;
}

TEST(Limits, CallDepth) {
    const Outcome outcome = run("void f(int n) { f(n + 1); }\nprogram p() { f(0); }");
    EXPECT_EQ(outcome.all_messages(), "1:17 K3401 calls are nested deeper than 1000");
    // Both ends of the call stack are shown.
    EXPECT_EQ(outcome.notes.size(), 17u);
    EXPECT_EQ(outcome.notes.back(), "2:15 `f` was called here");
    EXPECT_EQ(run("int f(int n) { return n == 0 ? 0 : f(n - 1) + 1; }\nprogram p() { X=f(998); }")
                  .all_blocks(),
              "X998");
}

TEST(Limits, ChainsOfAnyLength) {
    const auto repeated = [](const std::string& text, int times) {
        std::string all;
        for (int i = 0; i < times; ++i) all += text;
        return all;
    };
    const std::string ones = "1" + repeated(" + 1", 49'999);
    EXPECT_EQ(run("program p() { X=" + ones + "; }").all_blocks(), "X50000");
    const std::string names = "a" + repeated(" + a - b", 50'000);
    EXPECT_EQ(run("program p() { int a = 3; int b = 2; X=" + names + "; }").all_blocks(), "X50003");
    // The left operand is read before a later one changes it.
    EXPECT_EQ(run("program p() { int a = 1; X=a + a++ + a + a++ + a; }").all_blocks(), "X9");
    // Literals are joined when it is checked, the rest when it runs.
    const std::string literals = "\"a\"" + repeated(" + \"b\"", 49'999);
    EXPECT_EQ(run("program p() { string s = " + literals + "; X=s.count; }").all_blocks(),
              "X50000");
    const std::string texts = "s" + repeated(" + s", 19'999);
    EXPECT_EQ(run("const string s = \"ab\";\nprogram p() { string t = " + texts + "; X=t.count; }")
                  .all_blocks(),
              "X40000");
}

TEST(Limits, TimeActsInLoopsThatMakeNoBlocks) {
    expand::RunLimits limits;
    limits.seconds = 0.02;
    const Outcome outcome =
        run("program p() { int n = 0; while (true) n = 1 - n; }", with_limits(limits));
    EXPECT_EQ(outcome.messages, std::vector<std::string>{"1:33 K3405"});
}

TEST(Limits, WhoStopsALoopIsHeardInItsNextTurn) {
    const std::atomic<bool> stop = true;
    RunOptions options;
    options.expand.stop = &stop;
    // A slice of turns, after which a loop without blocks looks up, would be 130 000 blocks.
    const Outcome outcome = run("program p() { while (true) { X1; X2; } }", options);
    EXPECT_LE(outcome.blocks.size(), 4u);
    EXPECT_EQ(outcome.messages, std::vector<std::string>{"1:22 K3410"});
}

TEST(Limits, LoopTurns) {
    expand::RunLimits limits;
    limits.loop_turns = 100;
    EXPECT_EQ(run("program p() { int i = 0; while (true) i = 1 - i; }", with_limits(limits))
                  .all_messages(),
              "1:33 K3402 the loops and calls of the program have made 100 passes");
    EXPECT_EQ(run("program p() { int n = 0; for (int i = 0; i < 100; i++) n++; X=n; }",
                  with_limits(limits))
                  .all_blocks(),
              "X100");
    EXPECT_EQ(run("program p() { for (int i = 0; i < 9; i++) for (int k = 0; k < 20; k++) { } }",
                  with_limits(limits))
                  .messages.size(),
              1u);
}

TEST(Limits, Blocks) {
    expand::RunLimits limits;
    limits.blocks = 10;
    const Outcome outcome = run("program p() {\n    while (true) X1;\n}", with_limits(limits));
    EXPECT_EQ(outcome.all_messages(), "2:18 K3403 the program has made 10 blocks");
    EXPECT_EQ(outcome.blocks.size(), 10u);
}

TEST(Limits, Elements) {
    expand::RunLimits limits;
    limits.array_elements = 100;
    EXPECT_EQ(run("program p() { int[] a; while (true) a.append(1); }", with_limits(limits))
                  .all_messages(),
              "1:37 K3404 arrays and texts have grown beyond 100 elements");
    EXPECT_EQ(run("program p() { string s = \"a\"; while (true) s = s + s; }", with_limits(limits))
                  .all_messages(),
              "1:48 K3404 arrays and texts have grown beyond 100 elements");
    // What is no longer used does not count.
    EXPECT_EQ(run("program p() { for (int i = 0; i < 1000; i++) { int[] a = {1, 2, 3}; if (i == "
                  "999) X=a.count; } }",
                  with_limits(limits))
                  .all_blocks(),
              "X3");
}

// Arrays that hold hardly anything, and texts that are put together in braces, take memory as well:
// a copy of itself in itself doubles in each turn.
TEST(Limits, Memory) {
    expand::RunLimits limits;
    limits.heap_bytes = std::uint64_t{1} << 20;
    const char* doubling = "struct s { s[] a; } program p() { s x; while (true) x.a.append(x); }";
    EXPECT_EQ(run(doubling, with_limits(limits)).all_messages(),
              "1:53 K3630 arrays and texts take more than 1 MiB of memory");
    limits.array_elements = 100;
    EXPECT_EQ(
        run("program p() { string t = \"x\"; while (true) t = \"{t}{t}\"; }", with_limits(limits))
            .all_messages(),
        "1:48 K3404 arrays and texts have grown beyond 100 elements");
    // What is no longer used does not count, however much it was.
    limits.array_elements = 10'000'000;
    EXPECT_EQ(run("program p() { string t = \"\"; for (int i = 0; i < 100000; i++) "
                  "t = \"{i}, which is a text of some length\"; X=t.count; }",
                  with_limits(limits))
                  .all_blocks(),
              "X37");
}

// A turn that does much is one turn: the clock is looked at while it works, too.
TEST(Limits, TimeInTurnsThatDoMuch) {
    expand::RunLimits limits;
    limits.seconds = 0.2;
    for (const char* body :
         {"while (true) t = \"{t}\";", "while (true) { int[] b = a; X=b.count; }",
          "while (true) { contour[] c = offset(outline, 1mm); X=c.count; }"}) {
        SCOPED_TRACE(body);
        const std::string program =
            "contour outline = { G1 X0 Y0; for (int i = 1; i < 3000; i++) X=i Y=i % 7; };"
            "program p() { string t = \"x\"; for (int i = 0; i < 20; i++) t = t + t; "
            "int[] a; for (int i = 0; i < 100000; i++) a.append(i); " +
            std::string(body) + " }";
        const auto before = std::chrono::steady_clock::now();
        const Outcome outcome = run(program, with_limits(limits));
        EXPECT_NE(outcome.all_messages().find("K3405"), std::string::npos)
            << outcome.all_messages();
        EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(20));
    }
}

}  // namespace
}  // namespace kadr::testing::limits_test
