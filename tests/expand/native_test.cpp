// Cycles: the control's own where it has one, else their moves; and their moves for the
// interpreter.
#include <array>

#include <gtest/gtest.h>

#include "tests/sema/running.h"

namespace kadr::testing::native_test {
namespace {

RunOptions target(const std::string& name) {
    RunOptions options;
    options.with_stdlib = true;
    options.target = name;
    return options;
}

const char* const kSource =
    "import cycles.drilling;\n"
    "program p() {\n"
    "    G0 X1 Y2 Z50;\n"
    "    F100;\n"
    "    drill(to: -12mm);\n"
    "    X5;\n"
    "}\n";

TEST(Native, OneBlockWhereTheControlHasTheCycle) {
    const Outcome outcome = run(kSource, target("fanuc"));
    EXPECT_EQ(outcome.all_messages(), "");
    // Defaults are filled in. The cycle leaves rapid behind, so the next block says it again.
    EXPECT_EQ(outcome.all_blocks(),
              "rapid X1 Y2 Z50\nF100\ncycle#0(0=-12, 1=2, 2=50, 3=0)\nrapid X5");
}

TEST(Native, MovesWhereItHasNone) {
    const char* moves = "rapid X1 Y2 Z50\nF100\nrapid Z2\nline Z-12\nrapid Z50\nX5";
    EXPECT_EQ(run(kSource, target("iso")).all_blocks(), moves);
    RunOptions options = target("fanuc");
    options.expand.native_cycles = false;
    EXPECT_EQ(run(kSource, options).all_blocks(), moves);
}

TEST(Native, ContractsHoldForNativeCyclesToo) {
    const Outcome outcome =
        run("import cycles.drilling;\nprogram p() { G0 Z50; drill(to: 12mm); }", target("fanuc"));
    EXPECT_EQ(outcome.messages.size(), 1u);
    EXPECT_EQ(outcome.blocks.size(), 1u);
}

TEST(Native, WithoutAPositionTheCallerIsTold) {
    const Outcome outcome =
        run("import cycles.drilling;\nprogram p() { drill(to: -5mm); }", target("fanuc"));
    EXPECT_EQ(outcome.all_messages(), "2:15 K3105 the position of Z is not known here");
}

TEST(Native, AUsersCycleOfTheSameNameIsTheUsers) {
    const Outcome outcome = run(
        "cycle drill(length to, length retract = 2mm, length initial = 5mm, time dwell = 0s) {\n"
        "    X=to Y=retract Z=initial; dwell(dwell);\n"
        "}\n"
        "program p() { drill(to: -12mm); }\n",
        target("fanuc"));
    EXPECT_EQ(outcome.blocks[0], "X-12 Y2 Z5");
}

TEST(Native, TheInterpreterGetsTheMoves) {
    RunOptions options = target("fanuc");
    const Checked checked = check_program(
        "import cycles.drilling;\nprogram p() { G0 Z1; drill(1mm); drill_peck(to: 1mm, peck: 1mm); "
        "}",
        options);
    ASSERT_TRUE(checked.code != nullptr);
    expand::Expander expander(*checked.code, dialect("fanuc"), {}, *checked.messages);
    const std::array<double, 4> arguments = {-5, 2, 0, 0.5};
    AxisValues position{};
    position[index(Axis::Z)] = 20;
    // `initial` is not given: its default is where the tool is.
    ASSERT_TRUE(
        expander.start_cycle("drill", arguments, 0b1011, {.position = position, .feed = 100}));
    std::array<nc::Block, 16> batch;
    std::string all;
    const std::size_t count = expander.pull(batch);
    for (std::size_t i = 0; i < count; ++i) all += nc::describe(batch[i]) + '\n';
    EXPECT_EQ(all, "rapid Z2\nline Z-5\ndwell(time=0.5)\nrapid Z20\n");
    EXPECT_EQ(expander.pull(batch), 0u);
    EXPECT_FALSE(expander.failed());

    expand::Expander unknown(*checked.code, dialect("fanuc"), {}, *checked.messages);
    EXPECT_FALSE(
        unknown.start_cycle("bore_deep", arguments, 0b1, {.position = position, .feed = 100}));
    EXPECT_EQ(checked.messages->all().back().row->code, "K3008");
}

}  // namespace
}  // namespace kadr::testing::native_test
