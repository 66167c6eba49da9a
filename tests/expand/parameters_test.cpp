// Programs and their parameters from the command line.
#include <gtest/gtest.h>

#include "tests/sema/running.h"

namespace kadr::testing::parameters_test {
namespace {

RunOptions with(std::vector<sema::Define> defines, std::string program = "") {
    RunOptions options;
    options.defines = std::move(defines);
    options.program = std::move(program);
    return options;
}

const char* const kSource =
    "enum side { left, right }\n"
    "program p(length x = 1mm, int n = 2, real r = 0.5, bool b = false, angle a = 30, string s = "
    "\"none\",\n"
    "          feed f = 100, speed v = 1000, side d = left, length y = 2*x, length? z) {\n"
    "    note \"{x} {n} {r} {b} {a} {s} {f} {v} {d} {y} {z ?? 0mm}\";\n"
    "}\n";

TEST(Parameters, AreReadWithUnits) {
    struct Row {
        std::vector<sema::Define> defines;
        const char* shown;
    };
    const Row rows[] = {
        {{}, "1 2 0.5 false 30 none 100 1000 left 2 0"},
        {{{"x", "100mm"}}, "100 2 0.5 false 30 none 100 1000 left 200 0"},
        {{{"x", "2.5in"}, {"y", "7"}}, "63.5 2 0.5 false 30 none 100 1000 left 7 0"},
        {{{"x", "-3"}, {"n", "-4"}}, "-3 -4 0.5 false 30 none 100 1000 left -6 0"},
        {{{"r", "2"}, {"b", "true"}, {"a", "45deg"}}, "1 2 2 true 45 none 100 1000 left 2 0"},
        {{{"s", "M8 bolt"}, {"d", "right"}}, "1 2 0.5 false 30 M8 bolt 100 1000 right 2 0"},
        {{{"f", "250mm/min"}, {"v", "1500rpm"}}, "1 2 0.5 false 30 none 250 1500 left 2 0"},
        {{{"f", "0.1mm/rev"}, {"v", "120m/min"}}, "1 2 0.5 false 30 none 0.1 120 left 2 0"},
        {{{"z", "9mm"}}, "1 2 0.5 false 30 none 100 1000 left 2 9"},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.shown);
        const Outcome outcome = run(kSource, with(row.defines));
        EXPECT_EQ(outcome.all_messages(), "");
        EXPECT_EQ(outcome.all_blocks(), "comment \"" + std::string(row.shown) + '"');
    }
}

TEST(Parameters, MistakesAreNamed) {
    struct Row {
        std::vector<sema::Define> defines;
        const char* message;
    };
    const Row rows[] = {
        {{{"xx", "1"}}, "- K3003 `p` has no parameter `xx`"},
        {{{"x", "3deg"}}, "- K3004 `x` must be a number with a unit of length, not `3deg`"},
        {{{"x", "wide"}}, "- K3004 `x` must be a number with a unit of length, not `wide`"},
        {{{"n", "2.5"}}, "- K3004 `n` must be a whole number, not `2.5`"},
        {{{"r", "2mm"}}, "- K3004 `r` must be a number, not `2mm`"},
        {{{"b", "maybe"}}, "- K3004 `b` must be true or false, not `maybe`"},
        {{{"d", "up"}}, "- K3004 `d` must be one of left, right, not `up`"},
        {{{"n", "1"}, {"n", "2"}}, "- K3005 `n` is set twice"},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.message);
        const Outcome outcome = run(kSource, with(row.defines));
        EXPECT_EQ(outcome.all_messages(), row.message);
        EXPECT_EQ(outcome.all_blocks(), "");
    }
    EXPECT_EQ(run("program p(length x) { X=x; }").all_messages(),
              "1:18 K3006 `p` needs a value for `x`");
    EXPECT_EQ(run("program p(point x = {1mm, 2mm}) { G0 x; }", with({{"x", "1"}})).all_messages(),
              "- K3007 `x` is `point` and cannot be set from outside");
}

TEST(Parameters, TheOnlyProgramOrTheNamedOne) {
    const char* source = "program a() { X1; }\nprogram b() { X2; }";
    EXPECT_EQ(run("program a() { X1; }").all_blocks(), "X1");
    EXPECT_EQ(run(source).all_messages(), "1:1 K3009 the file has several programs: a, b");
    EXPECT_EQ(run(source, with({}, "a")).all_blocks(), "X1");
    EXPECT_EQ(run(source, with({}, "b")).all_blocks(), "X2");
    EXPECT_EQ(run(source, with({}, "c")).all_messages(), "- K3002 there is no program `c`");
    EXPECT_EQ(run("cycle a() { X1; }").all_messages(), "1:1 K3001 the file has no program");
}

}  // namespace
}  // namespace kadr::testing::parameters_test
