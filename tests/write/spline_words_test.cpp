// Splines in the text: control points, knots, intervals and weights of each control, written and
// read, and what their letters mean elsewhere.
#include <gtest/gtest.h>

#include "tests/nc/nc_testing.h"
#include "write/writer.h"

namespace kadr::write::spline_words_test {

using namespace nc;
namespace testing = nc::testing;

namespace {

using testing::read_blocks;
using testing::shipped;

std::string described(std::span<const Block> blocks) {
    std::string all;
    for (const Block& block : blocks) {
        if (!all.empty()) all += '\n';
        all += describe(block);
    }
    return all;
}

Block pole(double x, double y) {
    Block block;
    block.set(Slot::X, x);
    block.set(Slot::Y, y);
    return block;
}

Block with(Block block, Function function, double value) {
    block.set_argument(*block.add(function, 1), 0, value);
    return block;
}

struct Written {
    std::string text;
    std::string codes;
};

Written write(const std::string& dialect, const std::vector<Block>& blocks) {
    DiagnosticList sink;
    Writer writer(shipped(dialect), {.number_blocks = false}, sink);
    Written result;
    writer.begin({}, result.text);
    Block start = pole(0, 0);
    start.motion = Function::Line;
    writer.write(start, result.text);
    result.text.clear();
    for (const Block& block : blocks) writer.write(block, result.text);
    result.codes = testing::codes(sink);
    return result;
}

Block first(Block block) {
    block.motion = Function::Spline;
    return with(block, Function::SplineDegree, 3);
}

TEST(SplineWords, ByIntervals) {
    std::vector<Block> blocks = {
        first(with(pole(10, 10.5), Function::SplineInterval, 0.125)),
        with(with(pole(10, 10.5), Function::SplineWeight, 1.25), Function::SplineInterval, 1),
        with(pole(30, -4), Function::SplineInterval, 0)};
    const Written written = write("sinumerik", blocks);
    EXPECT_EQ(written.codes, "");
    // A control point in the place of the one before is written: it has its own knot.
    EXPECT_EQ(written.text,
              "BSPLINE SD=3 X10 Y10.5 PL=0.125\nX10 Y10.5 PL=1 PW=1.25\nX30 Y-4 PL=0\n");
    const auto back = read_blocks(shipped("sinumerik"), written.text);
    EXPECT_EQ(testing::codes(back.messages), "");
    ASSERT_EQ(back.blocks.size(), 3u);
    EXPECT_EQ(describe(back.blocks[0]),
              "spline X10 Y10.5 | spline_degree(degree=3) | spline_interval(interval=0.125)");
    EXPECT_EQ(describe(back.blocks[1]),
              "X10 Y10.5 | spline_interval(interval=1) | spline_weight(weight=1.25)");
}

TEST(SplineWords, ByKnots) {
    const Written written =
        write("fanuc",
              {first(with(pole(0, 0), Function::SplineKnot, 0)),
               with(with(pole(10, 10.5), Function::SplineWeight, 2), Function::SplineKnot, 0.125),
               with(Block{}, Function::SplineKnot, 12)});
    EXPECT_EQ(written.codes, "");
    EXPECT_EQ(written.text, "G06.2 X0. Y0. K0. P4\nX10. Y10.5 K0.125 R2.\nK12.\n");
    const auto back = read_blocks(shipped("fanuc"), written.text);
    EXPECT_EQ(testing::codes(back.messages), "");
    EXPECT_EQ(described(back.blocks),
              "spline X0 Y0 | spline_knot(knot=0) | spline_degree(degree=3)\n"
              "X10 Y10.5 | spline_knot(knot=0.125) | spline_weight(weight=2)\n"
              "spline_knot(knot=12)");
}

TEST(SplineWords, LettersHaveTheirOldMeaningElsewhere) {
    const auto back = read_blocks(shipped("fanuc"),
                                  "G01 X0. Y0. F100.\nG18 G02 X10. Z0. I5. K0.\nG03 X0. Z0. R5.\n"
                                  "G06.2 P2 K0. X0. Y0.\nK0. X10. Y0.\nK1.\nK1.\nG02 X0. Z0. R5.\n"
                                  "X10. R6.\n");
    EXPECT_EQ(testing::codes(back.messages), "");
    ASSERT_EQ(back.blocks.size(), 9u);
    EXPECT_TRUE(back.blocks[1].has(Slot::CenterZ));
    EXPECT_TRUE(back.blocks[2].has(Slot::Radius));
    for (std::size_t i = 3; i < 7; ++i)
        EXPECT_NE(back.blocks[i].find(Function::SplineKnot), nullptr) << i;
    EXPECT_EQ(back.blocks[7].at(Slot::Radius), 5);
    EXPECT_EQ(back.blocks[8].at(Slot::Radius), 6);
    // Without a spline before it, P is nothing that a line takes.
    EXPECT_NE(testing::codes(read_blocks(shipped("fanuc"), "G01 X5. P4 F100.\n").messages), "");
    EXPECT_NE(testing::codes(read_blocks(shipped("sinumerik"), "G1 X5 PL=2 F100\n").messages), "");
}

TEST(SplineWords, WhereThereIsNoSpelling) {
    EXPECT_EQ(
        write("iso", {first(with(pole(10, 10), Function::SplineInterval, 1))}).codes.substr(0, 5),
        "K4201");
    // Knots where the control counts intervals, and outside of a spline.
    EXPECT_EQ(write("sinumerik", {first(with(pole(0, 0), Function::SplineKnot, 1))}).codes,
              "K4201");
    Block line = with(pole(5, 5), Function::SplineKnot, 1);
    line.motion = Function::Line;
    EXPECT_EQ(write("fanuc", {line}).codes, "K4201");
    EXPECT_EQ(write("fanuc", {first(pole(5, 5))}).codes, "K4201");
}

}  // namespace
}  // namespace kadr::write::spline_words_test
