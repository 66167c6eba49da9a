// Words that one control has and another says otherwise: which blocks they are for every target.
#include <gtest/gtest.h>

#include "tests/sema/running.h"

namespace kadr::testing::source_words_test {
namespace {

Outcome run_source(const std::string& dialect, const std::string& statements,
                   const std::string& target) {
    RunOptions options;
    options.source = dialect;
    options.target = target;
    return run("dialect " + dialect + ";\nprogram p() {\nS1000 M3;\nF100;\n" + statements + "\n}",
               options);
}

/// The blocks behind F100.
std::string blocks(const std::string& dialect, const std::string& statements,
                   const std::string& target) {
    const Outcome outcome = run_source(dialect, statements, target);
    EXPECT_EQ(outcome.all_messages(), "") << statements;
    const std::string all = outcome.all_blocks();
    return all.substr(all.find("F100\n") + 5);
}

TEST(SourceWords, AReturnOverAPlaceGoesThereFirst) {
    EXPECT_EQ(blocks("fanuc", "G28 X10. Z20.;", "sinumerik"),
              "work_offset(number=1)\nrapid X10 Z20\nreference_point(point=1, x=0, z=0)");
    EXPECT_EQ(blocks("fanuc", "G30 P3 Y5.;", "axioma"),
              "work_offset(number=1)\nrapid Y5\nreference_point(point=3, y=0)");
    // G28 leaves the motion that the program has said.
    EXPECT_EQ(blocks("fanuc", "G01 X5.; G28 Z20.; X6.;", "sinumerik"),
              "work_offset(number=1)\nline X5\nrapid Z20\nreference_point(point=1, z=0)\nline X6");
    EXPECT_EQ(
        blocks("fanuc", "G00 Z5.; G91 G28 Z20.;", "sinumerik"),
        "work_offset(number=1)\nrapid Z5\nrapid Z20 | incremental\nreference_point(point=1, z=0)");
    // Over the place where it stands it goes straight.
    EXPECT_EQ(blocks("fanuc-lathe", "G28 U0. W0.;", "sinumerik"),
              "work_offset(number=1)\nreference_point(point=1, x=0, z=0)");
    EXPECT_EQ(blocks("fanuc", "G28 X10. Z20.;", "fanuc"), "X10 Z20 | reference_return(point=1)");
}

TEST(SourceWords, AStationIsItsToolWhereTheOffsetIsItsOwn) {
    EXPECT_EQ(blocks("fanuc-lathe", "T0303;", "sinumerik"), "tool(tool=3)");
    EXPECT_EQ(blocks("fanuc-lathe", "T0303;", "fanuc"), "tool(tool=3)");
    EXPECT_EQ(blocks("fanuc-lathe", "T0303; T0300;", "sinumerik"),
              "tool(tool=3)\ntool_edge(edge=0)");
    EXPECT_EQ(blocks("fanuc-lathe", "T0303; T0300;", "fanuc"), "tool(tool=3)\nlength_comp_off");
    EXPECT_EQ(blocks("fanuc-lathe", "T0313;", "fanuc-lathe"), "tool_select(tool=3, offset=13)");
    EXPECT_EQ(run_source("fanuc-lathe", "T0313;", "sinumerik").messages,
              std::vector<std::string>{"5:1 K4118"});
    EXPECT_EQ(run_source("fanuc-lathe", "T0303; T0400;", "sinumerik").messages,
              std::vector<std::string>{"5:8 K4118"});
}

}  // namespace
}  // namespace kadr::testing::source_words_test
