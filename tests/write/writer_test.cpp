// Block → text, per control: words in their order, modal state, numbers, arcs, frames, tools.
#include "write/writer.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "tests/common/scratch.h"
#include "tests/nc/nc_testing.h"

namespace kadr::write::writer_test {

using namespace nc;
namespace testing = nc::testing;

namespace {

using testing::shipped;

struct Program {
    const char* source;  // statements, one a line
    const char* text;    // what comes behind the safety line
};

Block statement_block(std::string_view statement) {
    Block block;
    if (statement.starts_with("// ")) {
        block.kind = Block::Kind::Comment;
        block.comment = statement.substr(3);
        return block;
    }
    if (statement.starts_with("raw ")) {
        block.kind = Block::Kind::Raw;
        block.text = statement.substr(4);
        return block;
    }
    return testing::source_block(shipped("iso"), statement);
}

struct Written {
    std::string text;   // behind the safety line
    std::string codes;  // of messages
};

Written write_blocks(const std::string& dialect, std::span<const Block> blocks,
                     WriteOptions options = {}, bool is_inch = false) {
    DiagnosticList sink;
    options.number_blocks = false;
    Writer writer(shipped(dialect), options, sink);
    std::string text;
    writer.begin({"test", 1, "", is_inch}, text);
    Block nothing;  // brings the safety line
    writer.write(nothing, text);
    const std::size_t start = text.size();
    for (const Block& block : blocks) writer.write(block, text);
    EXPECT_EQ(writer.lines(),
              static_cast<std::uint32_t>(std::count(text.begin(), text.end(), '\n')));
    return {text.substr(start), testing::codes(sink)};
}

Written write_block(const std::string& dialect, const Block& block) {
    return write_blocks(dialect, {&block, 1});
}

Written write(const std::string& dialect, std::string_view source, WriteOptions options = {},
              bool is_inch = false) {
    std::vector<Block> blocks;
    while (!source.empty()) {
        const std::size_t end = std::min(source.find('\n'), source.size());
        blocks.push_back(statement_block(source.substr(0, end)));
        source.remove_prefix(std::min(end + 1, source.size()));
    }
    return write_blocks(dialect, blocks, options, is_inch);
}

void expect_text(const std::string& dialect, std::initializer_list<Program> programs) {
    for (const Program& program : programs) {
        const Written written = write(dialect, program.source);
        EXPECT_EQ(written.text, program.text) << dialect << ":\n" << program.source;
        EXPECT_EQ(written.codes, "") << dialect << ":\n" << program.source;
    }
}

TEST(Writer, ModalWordsAreWrittenOnce) {
    expect_text("fanuc", {
                             {"G1 X0 F200\nG1 X10 F200\nG1 X20 F300\nG0 X0",
                              "G01 X0. F200.\nX10.\nX20. F300.\nG00 X0.\n"},
                             {"G0 X1 Y2 Z3\nX1 Y5 Z3\nX1 Y5 Z3", "X1. Y2. Z3.\nY5.\nX1. Y5. Z3.\n"},
                             {"G17 G90\nG0 X1", "X1.\n"},
                             {"S2400 M3\nS2400\nS2500", "S2400 M03\nS2500\n"},
                         });
    expect_text("sinumerik",
                {
                    {"G1 X0 F200\nG1 X10.5 F200\nG0 X-0.25", "G1 X0 F200\nX10.5\nG0 X-0.25\n"},
                    {"G91\nX5\nX5\nG90\nX0", "G91\nG0 X5\nX5\nG90\nX0\n"},
                });
    const Written verbose = write("fanuc", "G1 X0 F200\nG1 X10 F200", {.verbose_modal = true});
    EXPECT_EQ(verbose.text, "G01 X0. F200.\nG01 X10. F200.\n");
}

TEST(Writer, ThreadsHaveTheirPitchWhereTheControlTakesIt) {
    expect_text("sinumerik", {{"G0 X20 Z5\nG33 Z-20 K1.5\nZ-30 K1.5 SF=90\nG0 X30",
                               "G0 X20 Z5\nG33 Z-20 K1.5\nZ-30 K1.5 SF=90\nG0 X30\n"}});
    // F is the pitch, and the feed of the program comes back with the next cut, also where nothing
    // but its number would be written.
    expect_text("fanuc", {
                             {"G1 X25 Z5 F200\nG33 Z-20 K1.5\nG0 X30\nG1 Z-30\nX25",
                              "G01 X25. Z5. F200.\nG33 Z-20. F1.5\nG00 X30.\nG01 Z-30. F200.\n"
                              "X25.\n"},
                             {"F200\nG0 X20 Z5\nG33 Z-20 K3 SF=120.5\nG33 X25 Z-40 K3 SF=0",
                              "F200.\nX20. Z5.\nG33 Z-20. Q120500 F3.\nX25. Z-40. Q0\n"},
                         });
    expect_text("fanuc-lathe", {{"G0 X20 Z5\nG33 Z-20 K1.0583", "X20. Z5.\nG32 Z-20. F1.0583\n"}});
    EXPECT_EQ(write("fanuc", "G0 X20 Z5\nG33 Z-20").codes, "K4214");
    EXPECT_EQ(write("sinumerik", "G0 X20 Z5\nG33 Z-20").codes, "K4214");
}

TEST(Writer, APitchThatWasSaidAsFGoesAlongTheLongerWay) {
    // As the source `dialect fanuc;` has it.
    DiagnosticList sink;
    Writer writer(shipped("sinumerik"), {.number_blocks = false}, sink);
    std::string text;
    writer.begin({"test", 1, "", false}, text);
    for (const char* source : {"G0 X0 Z0", "G33 X30 Z-20 F2", "G33 X35 Z-60 F2", "G33 Z-70 F2"}) {
        writer.write(testing::source_block(shipped("fanuc"), source), text);
    }
    EXPECT_EQ(testing::codes(sink), "");
    EXPECT_NE(text.find("G33 X30 Z-20 I2\nX35 Z-60 K2\nZ-70 K2\n"), std::string::npos) << text;
}

TEST(Writer, ProbesMoveAtFeedAndLoseThePosition) {
    expect_text("sinumerik",
                {{"G0 X0\nG31 X10 F100\nX10\nX0", "G0 X0\nG1 X10 MEAS=1 F100\nG0 X10\nX0\n"}});
    expect_text("fanuc", {{"G0 X0\nG31 X10 F100\nX10\nX0", "X0.\nG31 X10. F100.\nG00 X10.\nX0.\n"},
                          {"G31 P2 X10 F100", "G31 P2 X10. F100.\n"}});
    // A probing move is a line at feed: another motion beside it says two things at once.
    EXPECT_EQ(write("sinumerik", "G0 G31 X10 F100").codes, "K4201");
}

TEST(Writer, DistancesHaveTheirLettersOnALathe) {
    expect_text("fanuc-lathe", {
                                   {"G0 X20 Z5\nX=IC(4) Z-10\nG91\nX2 Z-1\nG90\nX0",
                                    "X20. Z5.\nU4. Z-10.\nU2. W-1.\nX0.\n"},
                                   {"G28 X=IC(0) Z=IC(0)", "G28 U0. W0.\n"},
                                   {"G95\nG1 Z-5 F0.1234", "G99\nG01 Z-5. F0.1234\n"},
                                   {"tool(3)\nG0 Z5", "T0303\nG00 Z5.\n"},
                               });
    EXPECT_EQ(write("fanuc-lathe", "G43 H3").codes, "K4201");
}

TEST(Writer, AfterRawTextNothingIsKnown) {
    expect_text("fanuc", {{"G1 X10 F200\nraw G65 P9810\nG1 X10 F200",
                           "G01 X10. F200.\nG65 P9810\nG01 X10. F200.\n"}});
}

TEST(Writer, NumbersFollowTheControl) {
    expect_text("fanuc", {
                             {"G0 X10 Y-0.5 Z0.0004", "X10. Y-0.5 Z0.\n"},
                             {"G1 X1.2346 F200.5", "G01 X1.235 F200.5\n"},
                             {"S2400.4 M3\nT3 M6\nDR=1",
                              "S2400 M03\nT03 M06\nG00 G17 G21 G40 G54 G80 G90 G94\nD01\n"},
                             {"G4 P0.25", "G04 P250\n"},
                         });
    expect_text("sinumerik", {
                                 {"G0 X10 Y-0.5 Z0.0004", "G0 X10 Y-0.5 Z0\n"},
                                 {"G4 P0.25", "G4 F0.25\n"},
                                 {"G1 X1 F0.1234", "G1 X1 F0.1234\n"},
                             });
}

// A feed or a speed that rounding makes another one: a warning above a hundredth, an error above a
// tenth.
TEST(Writer, RoundingThatIsAnotherNumber) {
    EXPECT_EQ(write("fanuc", "S1.5 M3").codes, "K4240");
    EXPECT_EQ(write("fanuc", "S30.4 M3").codes, "K4241");
    EXPECT_EQ(write("fanuc", "S239.5 M3").codes, "");
    EXPECT_EQ(write("fanuc", "G1 X1 F0.0016").codes, "K4240");
    EXPECT_EQ(write("fanuc", "G1 X1 F0.0306").codes, "K4241");
    EXPECT_EQ(write("fanuc", "G1 X1 F0.0996").codes, "");
    EXPECT_EQ(write("sinumerik", "S1.5 M3\nG1 X1 F0.0016").codes, "");
}

// An angle that the control cannot say so finely is an error where it takes the tool more than half
// an increment beside its place, as far as that is from the centre of the rotation.
TEST(Writer, AnglesThatAreTooFine) {
    const std::string rotated = "G0 X0 Y0\nrotate(12.3456789)\n";
    EXPECT_EQ(write("fanuc", rotated + "X900 Y0\nX900 Y900").codes, "K4242");
    EXPECT_EQ(write("fanuc", rotated + "X50 Y0").codes, "");
    EXPECT_EQ(write("fanuc", "rotate(angle: 12.3456789, x: 900, y: 900)\nX950 Y900").codes, "");
    EXPECT_EQ(write("fanuc", "rotate(12.346)\nX900 Y900").codes, "");
    EXPECT_EQ(write("fanuc", "rotate(0.0004)\nX900 Y900").codes, "K4242");
    EXPECT_EQ(write("fanuc", rotated + "rotate_off()\nX900 Y900").codes, "");
    EXPECT_EQ(write("fanuc", "tilt_euler(a: 0, b: 12.3456789, c: 0)\nX900 Y900 Z0").codes, "K4243");
    EXPECT_EQ(write("sinumerik", rotated + "X900 Y900").text,
              "G0 X0 Y0\nAROT RPL=12.3456789\nX900 Y900\n");
}

TEST(Writer, Inches) {
    EXPECT_EQ(write("fanuc", "G1 X25.4 F254", {}, true).text, "G01 X1. F10.\n");
    EXPECT_EQ(write("sinumerik", "G1 X25.4 F254", {}, true).text, "G1 X1 F10\n");
}

TEST(Writer, IncrementalWordsDoNotDrift) {
    // 1/3 three times is 1: the roundings of the steps must not add up.
    expect_text("fanuc", {{"G91\nX0.33333333333\nX0.33333333333\nX0.33333333334",
                           "G91\nX0.333\nX0.334\nX0.333\n"}});
}

TEST(Writer, WordsByThemselves) {
    expect_text("sinumerik", {{"G0 X10\nX=IC(5) Y=AC(3)", "G0 X10\nX=IC(5) Y=AC(3)\n"}});
    expect_text("fanuc",
                {
                    {"G0 X10\nX=IC(5)", "X10.\nX15.\n"},
                    // The position is not known: a block of distances under G91, then back.
                    {"G0 X=IC(5)\nX20", "G91 X5.\nG90 X20.\n"},
                    // Several stay under G91, a G90 between them holds for what comes then.
                    {"G0 X=IC(5)\nX=IC(1)\nY=IC(2)\nX20", "G91 X5.\nX1.\nY2.\nG90 X20.\n"},
                    {"G0 X=IC(5)\nG90 X=IC(1)\nX20", "G91 X5.\nX1.\nG90 X20.\n"},
                    // The author's own text stands under the dimensions that he has said.
                    {"G0 X=IC(5)\nraw X3", "G91 X5.\nG90\nX3\n"},
                    {"G0 X10 Y0\nG91\nX=AC(3)", "X10. Y0.\nG91\nX-7.\n"},
                });
    EXPECT_EQ(write("fanuc", "G0 X=IC(5) Y=AC(2)").codes, "K4204");
}

TEST(Writer, ArcsFitTheRoundedPoints) {
    expect_text(
        "fanuc",
        {
            {"G0 X20 Y0\nG3 X0 Y20 I-20 J0 F100", "X20. Y0.\nG03 X0. Y20. I-20. J0. F100.\n"},
            {"G0 X20 Y0\nG3 X0 Y20 CR=20", "X20. Y0.\nG03 X0. Y20. R20.\n"},
            {"G0 X20 Y0\nG3 X0 Y20 I=AC(0) J=AC(0)", "X20. Y0.\nG03 X0. Y20. I-20. J0.\n"},
            {"G0 X20 Y0\nG3 I-20", "X20. Y0.\nG03 I-20.\n"},
        });
    expect_text("sinumerik", {
                                 {"G0 X20 Y0\nG3 X0 Y20 I=AC(0) J=AC(0)",
                                  "G0 X20 Y0\nG3 X0 Y20 I=AC(0) J=AC(0)\n"},
                                 {"G0 X20 Y0\nG3 X0 Y20 CR=-20", "G0 X20 Y0\nG3 X0 Y20 CR=-20\n"},
                             });
}

// Where X always is a diameter nothing is written; where the machine decides that is a warning.
TEST(Writer, WhetherXIsADiameter) {
    expect_text("sinumerik", {{"DIAMON\nG0 X10\nDIAMON\nDIAMOF", "DIAMON\nG0 X10\nDIAMOF\n"}});
    expect_text("fanuc-lathe", {{"G18 DIAMON\nG0 X10", "X10.\n"}, {"G0 X10\nDIAMON", "X10.\n"}});
    EXPECT_EQ(write("fanuc-lathe", "DIAMOF").codes, "K4201");
    EXPECT_EQ(write("fanuc-lathe-b", "DIAMOF").codes, "K4201");
    EXPECT_EQ(write("fanuc", "DIAMON\nG0 X10").codes, "K4217");
    EXPECT_EQ(write("fanuc", "DIAMON\nG0 X10\nDIAMON").codes, "K4217");
    EXPECT_EQ(write("fanuc", "DIAMON\nG0 X10").text, "X10.\n");
    EXPECT_EQ(write("fanuc", "DIAMOF\nG0 X10").codes, "K4217");
}

// On a lathe X is a diameter, I and R are not, and no word need say so.
TEST(Writer, ArcsOfLathes) {
    for (const char* name : {"sinumerik", "iso"}) {
        expect_text(
            name, {
                      // From the radius 10 to 12, on whose circle the end lies.
                      {"G18\nG0 X20 Z0\nG3 X24 Z-2 I0 K-2", "G18\nG0 X20 Z0\nG3 X24 Z-2 I0 K-2\n"},
                      // A radius on a mill.
                      {"G18\nG0 X10 Z0\nG3 X12 Z-2 CR=2", "G18\nG0 X10 Z0\nG3 X12 Z-2 CR=2\n"},
                  });
    }
    // The end is rounded, and the centre moves along, as on a mill.
    expect_text("fanuc", {{"G18\nG0 X20 Z0\nG3 X24.0005 Z-2.00025 I0 K-2.00025",
                           "G18\nX20. Z0.\nG03 X24. Z-2. I0. K-2.\n"}});
    EXPECT_EQ(write("fanuc", "G18\nG0 X20 Z0\nG3 X40 Z-2 CR=2").codes, "K4208");
    // As a diameter the chord is 2.83, but no number shows that X is one, and as a radius it
    // is 4.47.
    for (const char* name : {"sinumerik", "iso", "fanuc"})
        EXPECT_EQ(write(name, "G18\nG0 X20 Z0\nG3 X24 Z-2 CR=2").codes, "K4208") << name;
    // Where it is known what X is, nothing is guessed.
    expect_text("sinumerik", {{"G18 DIAMON\nG0 X20 Z0\nG3 X24 Z-2 CR=2",
                               "G18 DIAMON\nG0 X20 Z0\nG3 X24 Z-2 CR=2\n"}});
    EXPECT_EQ(write("sinumerik", "G18 DIAMOF\nG0 X20 Z0\nG3 X24 Z-2 CR=2").codes, "K4208");
    EXPECT_EQ(write("sinumerik", "G18 DIAMON\nG0 X20 Z0\nG3 X22 Z-2 I0 K-2").codes, "K4215");
    EXPECT_EQ(write("fanuc-lathe", "G18\nG0 X20 Z0\nG3 X22 Z-2 I0 K-2").codes, "K4215");
}

// A quarter circle in 1/600 min: F of an arc is its angle over that time on a FANUC, X or not.
TEST(Writer, InverseTimeOfArcsOnALathe) {
    expect_text("fanuc-lathe",
                {{"G18\nG0 X20 Z0\nG93\nG3 X24 Z-2 CR=2 F600\nG3 X20 Z-4 I-2 K0 F600",
                  "X20. Z0.\nG93\nG03 X24. Z-2. R2. F942.4778\nX20. Z-4. I-2. K0. F942.4778\n"}});
}

TEST(Writer, ArcsFromUnknownPositionsKeepTheirWords) {
    expect_text("sinumerik",
                {
                    {"G2 X=IC(5) Y0 I=AC(3) J0", "G2 X=IC(5) Y0 I=AC(3) J0\n"},
                    {"tool(3)\nG3 X5 Y1.5 I=AC(1.23456) J2",
                     "T=\"3\" D1\nM6\nG3 X5 Y1.5 I=AC(1.23456) J2\n"},
                    // An axis without a word does not move: the chord is known.
                    {"G3 X=IC(10) CR=5", "G3 X=IC(10) CR=5\n"},
                    {"raw G02\nX5 Y1 I5 J0\nX9 Y1 CR=7", "G02\nX5 Y1 I5 J0\nX9 Y1 CR=7\n"},
                });
    expect_text("fanuc", {{"G2 X5 Y0 I1 J0", "G02 X5. Y0. I1. J0.\n"}});
    EXPECT_EQ(write("fanuc", "G2 X5 Y0 I=AC(1) J0").codes, "K4204");
    EXPECT_EQ(write("fanuc", "G3 X0 Y20 I-20 J0 Z-9 TURN=2").codes, "K4204");
}

TEST(Writer, ArcWordsWithoutAnArcAreAnError) {
    for (const char* name : {"iso", "sinumerik", "fanuc"}) {
        EXPECT_EQ(write(name, "G1 X1\nX3 I4").codes, "K4209") << name;
        EXPECT_EQ(write(name, "X3 CR=4").codes, "K4209") << name;
        EXPECT_EQ(write(name, "G1 X1\nX3 TURN=1").codes, "K4209") << name;
        EXPECT_EQ(write(name, "G2 X3 I4\nX5").codes, "K4211") << name;
        // Such a block comes from another control's text; the planner refuses it in a source.
        Block block = testing::source_block(shipped("iso"), "G2 X3 CR=4");
        block.set(Slot::CenterX, 1);
        DiagnosticList sink;
        Writer writer(shipped(name), {}, sink);
        std::string text;
        writer.write(block, text);
        EXPECT_EQ(testing::codes(sink), "K4210") << name;
    }
}

TEST(Writer, NumbersOfTheProgramStayWithTheirBlocks) {
    expect_text("fanuc", {{"N100 G0 X1\nN110 G90\nX2\nN120 S100 M3 M8",
                           "N100 X1.\nN110\nX2.\nN120 S100 M03\nM08\n"}});
    DiagnosticList sink;
    Writer writer(shipped("sinumerik"), {}, sink);
    std::string text;
    writer.begin({"part", 1, "", false}, text);
    for (const char* statement : {"G0 X1", "N100 X2", "X3", "N105 shift", "X4"}) {
        if (std::string_view(statement) == "N105 shift") {
            Block block = testing::source_block(shipped("iso"), "TRANS X1");
            block.number = 105;
            writer.write(block, text);
        } else {
            writer.write(testing::source_block(shipped("iso"), statement), text);
        }
    }
    EXPECT_EQ(text,
              "%_N_PART_MPF\nN10 G54 G17 G71 G40 G64 G90 G94\nN20 G0 X1\nN100 X2\nN110 X3\n"
              "N105 TRANS X1\nN120 X4\n");
}

TEST(Writer, WhatAnOperatorMaySkipIsNotKnown) {
    DiagnosticList sink;
    Writer writer(shipped("fanuc"), {}, sink);
    std::string text;
    writer.begin({}, text);
    text.clear();
    for (const char* statement : {"G0 X1 Z5", "G1 X2 F100", "X3 Z5 F100"}) {
        Block block = testing::source_block(shipped("iso"), statement);
        if (block.motion == Function::Line) block.skip_level = 2;
        writer.write(block, text);
    }
    EXPECT_EQ(text,
              "G69\nG50\nG00 G17 G21 G40 G49 G54 G80 G90 G94 G97\nG50.1 X0. Y0. Z0.\nG52 X0. Y0. "
              "Z0.\nX1. Z5.\n/2 G01 X2. F100.\nG01 X3. F100.\n");
    Block block = testing::source_block(shipped("iso"), "G0 X1");
    block.skip_level = 0;  // `/` is level 1 here, and there is none below
    writer.write(block, text);
    EXPECT_EQ(testing::codes(sink), "K4201");
}

/// In another plane the length acts along another axis, and both have to go.
TEST(Writer, AxesOfTheLengthAreSaidAgainInAnotherPlane) {
    expect_text("sinumerik",
                {{"G17\nG0 X0 Y0 Z50\nG18\nG0 X5 Y0 Z50", "G0 X0 Y0 Z50\nG18\nX5 Y0 Z50\n"}});
    expect_text("fanuc", {{"G17\nG0 X0 Y0 Z50\nG18\nG0 X5 Y0 Z50",
                           "X0. Y0. Z50.\nG18\nX5.\n"}});  // its length lies along Z
}

/// Behind a tool change X is named by a word that acts, not by one that may be left out.
TEST(Writer, AWordThatMayBeLeftOutNamesNoAxis) {
    std::vector<Block> blocks;
    for (const char* statement : {"G0 X10 Y2", "tool(2)", "G0 X10", "G0 X10 Y10"})
        blocks.push_back(testing::source_block(shipped("iso"), statement));
    blocks[2].skip_level = 1;
    const Written written = write_blocks("fanuc", blocks);
    EXPECT_EQ(written.text.substr(written.text.find("M06")),
              "M06\nG00 G17 G21 G40 G54 G80 G90 G94\n/ X10.\nX10. Y10.\n");
}

TEST(Writer, RadiusThatNoLongerFitsBecomesACentre) {
    // Half a turn whose chord the rounding makes longer than twice the rounded radius.
    const Written written = write("fanuc", "G0 X0 Y0\nG2 X9.2007 Y0 CR=4.60035");
    EXPECT_EQ(written.text, "X0. Y0.\nG02 X9.201 Y0. I4.6 J0.\n");
}

TEST(Writer, FeedOfAHelixByItsArc) {
    // A circle of 5 mm and 20 mm down: the way is sqrt((10 pi)^2 + 20^2) = 37.2419, the
    // arc 31.4159.
    expect_text("fanuc", {{"F100\nG0 X0 Y0 Z0\nG1 X1\nX0\nG3 X0 Y0 I5 J0 Z-20\nG1 Z0",
                           "F100.\nX0. Y0. Z0.\nG01 X1.\nX0.\nG03 X0. Y0. Z-20. I5. J0. F84.356\n"
                           "G01 Z0. F100.\n"},
                          // F once for all turns, and again for what follows them.
                          {"F100\nG0 X0 Y0 Z0\nG3 X0 Y0 I5 J0 Z-60 TURN=2\nG3 X0 Y0 I5 J0",
                           "F100.\nX0. Y0. Z0.\nG03 Z-20. I5. J0. F84.356\nZ-40. I5. J0.\n"
                           "X0. Y0. Z-60. I5. J0.\nX0. Y0. I5. J0. F100.\n"}});
    // Where the way does not differ from the arc by an increment of F, nothing is said.
    expect_text("fanuc", {{"F100\nG0 X0 Y0 Z0\nG3 X0 Y0 I5 J0 Z-0.01\nG1 Z0",
                           "F100.\nX0. Y0. Z0.\nG03 X0. Y0. Z-0.01 I5. J0.\nG01 Z0.\n"}});
    // The mode said again, unequal factors, text of the author's own behind it.
    expect_text("fanuc", {{"F100\nG0 X0 Y0 Z0\nG94\nG3 X0 Y0 I5 J0 Z-20\nraw G01 X5.",
                           "F100.\nX0. Y0. Z0.\nG03 X0. Y0. Z-20. I5. J0. F84.356\nF100.\n"
                           "G01 X5.\n"},
                          {"F100\nscale(fx: 2, fy: 2, fz: 0.5)\nG0 X0 Y0 Z0\nG3 X0 Y0 I5 J0 Z-20",
                           "F100.\nG51 X0. Y0. Z0. I2000 J2000 K500\nX0. Y0. Z0.\n"
                           "G03 X0. Y0. Z-20. I5. J0. F98.757\n"}});
    expect_text("sinumerik", {{"F100\nG0 X0 Y0 Z0\nG3 X0 Y0 I5 J0 Z-20\nG1 Z0",
                               "F100\nG0 X0 Y0 Z0\nG3 X0 Y0 Z-20 I5 J0\nG1 Z0\n"}});
}

TEST(Writer, HelixTurnsBecomeBlocksWhereThereIsNoWord) {
    // 2 full turns and a quarter: 8/9 of the depth in the turns.
    expect_text("fanuc",
                {{"G0 X20 Y0 Z0\nG3 X0 Y20 I-20 J0 Z-9 TURN=2",
                  "X20. Y0. Z0.\nG03 Z-4. I-20. J0.\nZ-8. I-20. J0.\nX0. Y20. Z-9. I-20. J0.\n"}});
    // Of a distance every circle goes its share, and the last one no more than that.
    expect_text("fanuc",
                {{"G0 X0 Y0 Z0\nG91 G3 X0 Y0 I3 J0 Z-3 TURN=2",
                  "X0. Y0. Z0.\nG03 G91 Z-1. I3. J0.\nZ-1. I3. J0.\nX0. Y0. Z-1. I3. J0.\n"},
                 {"G0 X0 Y0 Z0\nG3 X0 Y0 I3 J0 Z=IC(-3) TURN=2",
                  "X0. Y0. Z0.\nG03 Z-1. I3. J0.\nZ-2. I3. J0.\nX0. Y0. Z-3. I3. J0.\n"}});
    // The plane may be said beside them.
    expect_text("fanuc",
                {{"G18\nG0 X20 Y0 Z0\nG17 G3 X0 Y20 I-20 J0 Z-9 TURN=1",
                  "G18\nX20. Y0. Z0.\nG03 G17 Z-7.2 I-20. J0.\nX0. Y20. Z-9. I-20. J0.\n"}});
    expect_text("sinumerik", {{"G0 X20 Y0 Z0\nG3 X0 Y20 I-20 J0 Z-9 TURN=2",
                               "G0 X20 Y0 Z0\nG3 X0 Y20 Z-9 I-20 J0 TURN=2\n"}});
}

TEST(Writer, ToolsAndHeldBackWords) {
    expect_text("fanuc", {
                             {"tool(3)\nS2400 M3\nG0 X0 Y0\nG0 Z50\nG0 Z2",
                              "T03 M06\nS2400 M03\nG00 X0. Y0.\nG43 H03 Z50.\nZ2.\n"},
                             // An offset of the program's own stands for the tool's.
                             {"tool(3)\nG43 H5 Z50", "T03 M06\nG00 G43 H05 Z50.\n"},
                             {"tool(3)\nH5\nZ50", "T03 M06\nH05\nG00 G43 H05 Z50.\n"},
                             {"tool(3)\nG41 DR=8\nG1 X5 F100", "T03 M06\nG41 D08\nG01 X5. F100.\n"},
                             {"tool(3)\nG41\nG1 X5 F100\nG40\nG42",
                              "T03 M06\nG41 D03\nG01 X5. F100.\nG40\nG42 D03\n"},
                         });
    expect_text("sinumerik", {{"tool(3)\nG0 Z50", "T=\"3\" D1\nM6\nG0 Z50\n"}});
}

TEST(Writer, OneMCodeABlock) {
    expect_text("fanuc", {{"S100 M3 M8 M0", "S100 M03\nM08\nM00\n"}});
    expect_text("sinumerik", {{"S100 M3 M8 M0", "S100 M3 M8 M0\n"}});
}

TEST(Writer, ACodeThatStandsAloneAmongItsAddress) {
    expect_text(KADR_ROOT "/examples/dialects/haas.xml", {{"S100 M3 M8", "S100 M03 M08\n"},
                                                          {"M5 M9 M0", "M05 M09\nM00\n"},
                                                          {"M8 M1", "M08\nM01\n"}});
}

TEST(Writer, Frames) {
    expect_text("fanuc",
                {
                    // A shift of an earlier program may act: the first one names every axis.
                    {"shift(x: 60, y: 40)\nshift()", "G52 X60. Y40.\nG52 X0. Y0.\n"},
                    {"shift(x: 60)\nrotate(30)\nshift(x: 10)",
                     "G52 X60.\nG68 X0. Y0. R30.\nG69\nG52 X10.\n"},
                    {"mirror(x: 0)\nrotate(30)\nshift()",
                     "G51.1 X0.\nG68 X0. Y0. R30.\nG69\nG50.1 X0. Y0. Z0.\n"},
                    {"G18\nrotate(30)", "G18\nG68 Z0. X0. R30.\n"},
                    {"mirror(x: 0)\nshift()", "G51.1 X0.\nG50.1 X0. Y0. Z0.\n"},
                });
    expect_text("sinumerik",
                {{"shift(x: 60)\nrotate(30)\nshift()", "TRANS X60\nAROT RPL=30\nTRANS\n"}});
    EXPECT_EQ(write("fanuc", "rotate(30)\nrotate(10)").codes, "K4212");
    for (const char* inside : {"mirror(x: 0)", "mirror_off()", "work_offset(2)", "G18"}) {
        EXPECT_EQ(write("fanuc", std::string("rotate(30)\n") + inside).codes, "K4212") << inside;
        EXPECT_EQ(write("fanuc", std::string("rotate(30)\nrotate_off()\n") + inside).codes, "");
    }
    EXPECT_EQ(write("fanuc", "raw G65 P1\nmirror(x: 0)").codes, "K4212");
    // The control itself knows whether a rotation acts behind raw text.
    EXPECT_EQ(write("fanuc", "raw G65 P1\nG54").codes, "");
    EXPECT_EQ(write("fanuc", "raw G65 P1\nG18").codes, "");
}

TEST(Writer, AxesThatTheControlTurnsAreSaidAgain) {
    expect_text("sinumerik",
                {{"G0 X1 A10\norient_reset()\nX2 A10", "G0 X1 A10\nORIRESET()\nX2 A10\n"}});
}

TEST(Writer, FramesLeaveTheOtherAxesWhereTheyAre) {
    expect_text("fanuc",
                {
                    // From the start lines the shift is known to be 0.
                    {"shift(x: 60)\nG0 X1 Z50\nrotate(30)\nX2 Z50\nshift(x: 60)\nX3 Z50",
                     "G52 X60.\nX1. Z50.\nG68 X0. Y0. R30.\nX2.\nG69\nX3.\n"},
                    {"shift()\nG0 X1 Z50\nshift(z: 5)\nX2 Z50", "X1. Z50.\nG52 Z5.\nX2. Z50.\n"},
                    {"G0 X1 Z50\nmirror(z: 0)\nX1 Z50", "X1. Z50.\nG51.1 Z0.\nZ50.\n"},
                });
    expect_text("sinumerik", {
                                 {"G0 X1 Z50\nshift(x: 60)\nX2 Z50", "G0 X1 Z50\nTRANS X60\nX2\n"},
                                 {"G0 X1 Z50\nATRANS X5\nX2 Z50\nTRANS\nX2 Z50",
                                  "G0 X1 Z50\nATRANS X5\nX2\nTRANS\nX2\n"},
                                 {"raw TRANS Z5\nG0 X1 Z50\nTRANS X5\nX2 Z50",
                                  "TRANS Z5\nG0 X1 Z50\nTRANS X5\nX2 Z50\n"},
                             });
}

TEST(Writer, FeedAndSpeedModes) {
    expect_text("sinumerik", {
                                 {"G95\nG96 S120 M3\nG1 X0 F0.2", "G95\nG96 S120 M3\nG1 X0 F0.2\n"},
                                 {"G96 S120", "G961 S120\n"},
                                 {"G95\nG96\nG97 S500", "G95\nG96\nG97 S500\n"},
                                 {"G95 G96 S100", "G96 S100\n"},
                                 {"G96 S100\nG94", "G961 S100\n"},
                                 // A change of the feed mode deletes F.
                                 {"G1 X0 F100\nG95 F100\nX1", "G1 X0 F100\nG95 F100\nX1\n"},
                             });
    expect_text("fanuc", {
                             {"G96 S120 M3", "G96 S120 M03\n"},
                             {"G93\nG1 X1 F2\nX2\nX3 F2", "G93\nG01 X1. F2.\nX2. F2.\nX3. F2.\n"},
                         });
}

TEST(Writer, InverseTimeOfArcsByRadius) {
    // F 2 is half a minute; a quarter turn in half a minute is pi/2 · 2 = pi per minute.
    expect_text("fanuc",
                {
                    {"G0 X20 Y0\nG93\nG3 X0 Y20 I-20 J0 F2\nG3 X-20 Y0 CR=20 F2",
                     "X20. Y0.\nG93\nG03 X0. Y20. I-20. J0. F3.142\nX-20. Y0. R20. F3.142\n"},
                    // 2 turns and a quarter in half a minute: 9/8 of the feed for each turn, 9
                    // times for the rest.
                    {"G0 X20 Y0 Z0\nG93\nG3 X0 Y20 I-20 J0 Z-9 TURN=2 F2",
                     "X20. Y0. Z0.\nG93\nG03 Z-4. I-20. J0. F28.274\nZ-8. I-20. J0. F28.274\n"
                     "X0. Y20. Z-9. I-20. J0. F28.274\n"},
                });
    expect_text("sinumerik", {{"G0 X20 Y0\nG93\nG3 X0 Y20 I-20 J0 F2",
                               "G0 X20 Y0\nG93\nG3 X0 Y20 I-20 J0 F2\n"}});
}

TEST(Writer, Cycles) {
    expect_text(
        "fanuc",
        {
            {"G0 Z50\ndrill_peck(to: -12, peck: 3, retract: 2, initial: 50, dwell: 0)\nG0 X5\n"
             "drill(to: -5, retract: 2, initial: 50, dwell: 0.5)",
             "Z50.\nG98 G83 Z-12. R2. Q3.\nG80\nG00 X5.\nG82 Z-5. R2. P500\nG80\n"},
            // The tool axis is somewhere else: it goes to the level first.
            {"G0 Z60\nG1 X5 F100\ndrill(to: -5, retract: 2, initial: 50, dwell: 0)\nX9",
             "Z60.\nG01 X5. F100.\nG00 Z50.\nG98 G81 Z-5. R2.\nG80\nG01 X9.\n"},
            {"G0 Z50\nG91\ndrill(to: -5, retract: 2, initial: 50, dwell: 0)\nX9",
             "Z50.\nG91\nG90 G98 G81 Z-5. R2.\nG80\nG91 G00 X9.\n"},
            {"tool(3)\ndrill(to: -5, retract: 2, initial: 50, dwell: 0)",
             "T03 M06\nG00 G43 H03 Z50.\nG98 G81 Z-5. R2.\nG80\n"},
        });
}

TEST(Writer, ABlockOfFramesAloneIsFollowed) {
    DiagnosticList sink;
    Writer writer(shipped("sinumerik"), {.number_blocks = false}, sink);
    std::string text;
    writer.begin({"part", 1, "", false}, text);
    Block frames;
    frames.add(Function::Shift);
    frames.set_argument(*frames.add(Function::Mirror, 3), 0, 0);
    for (const Block& block : {statement_block("G0 X10 Y0"), frames, statement_block("X10 Y5")}) {
        writer.write(block, text);
    }
    EXPECT_EQ(text,
              "%_N_PART_MPF\nG54 G17 G71 G40 G64 G90 G94\nG0 X10 Y0\nTRANS\nAMIRROR X0\nX10 Y5\n");
}

TEST(Writer, Comments) {
    expect_text("fanuc", {
                             {"// bracket 120 x 80 (rough)", "(BRACKET 120 X 80 [ROUGH])\n"},
                             {"// фланец Ø80, чистовая", "(FLANETS O80, CHISTOVAIA)\n"},
                             {"// część ±0.1, Zażółć gęślą jaźń, Çà ñ Œ Ω",
                              "(CZESC +-0.1, ZAZOLC GESLA JAZN, CA N OE OHM)\n"},
                         });
    expect_text("sinumerik", {{"// фланец (чистовая)", "; фланец (чистовая)\n"}});
    Block block = testing::source_block(shipped("iso"), "G0 X1");
    block.comment = "go";
    DiagnosticList sink;
    Writer writer(shipped("sinumerik"), {}, sink);
    std::string text;
    writer.begin({"part", 1, "", false}, text);
    EXPECT_EQ(writer.write(block, text), 3u);
    EXPECT_EQ(text, "%_N_PART_MPF\nN10 G54 G17 G71 G40 G64 G90 G94\nN20 G0 X1 ; go\n");
}

TEST(Writer, ProgramFrame) {
    struct Row {
        const char* dialect;
        ProgramInfo program;
        const char* text;
    };
    for (const Row& row : {
             Row{"fanuc",
                 {"bracket", 12, "Flange (A)", false},
                 "%\nO0012(BRACKET)\n(FLANGE [A])\nG69\nG50\nG00 G17 G21 G40 G49 G54 G80 G90 G94 "
                 "G97\nG50.1 X0. Y0. Z0.\nG52 X0. Y0. Z0.\nX1.\nM30\n%\n"},
             {"fanuc",
              {"bracket", 12, "", true},
              "%\nO0012(BRACKET)\nG69\nG50\nG00 G17 G20 G40 G49 G54 G80 G90 G94 G97\nG50.1 X0. Y0. "
              "Z0.\nG52 X0. Y0. Z0.\nX0.0394\nM30\n%\n"},
             {"sinumerik",
              {"3 holes", 1, "", false},
              "%_N_NC_3_HOLES_MPF\nN10 G54 G17 G71 G40 G64 G90 G94\nN20 G0 X1\nN30 M30\n"},
         }) {
        DiagnosticList sink;
        Writer writer(shipped(row.dialect), {}, sink);
        std::string text;
        writer.begin(row.program, text);
        writer.write(testing::source_block(shipped("iso"), "G0 X1"), text);
        writer.end(text);
        EXPECT_EQ(text, row.text);
        EXPECT_FALSE(writer.failed());
    }
}

TEST(Writer, WhatCannotBeSaidIsAnError) {
    struct Row {
        const char* dialect;
        const char* source;
        const char* codes;
    };
    for (const Row& row : {
             Row{"sinumerik", "G92 X0", "K4201"},
             {"fanuc", "G0 X1234567", "K4202"},
             {"fanuc", "work_offset(0)", "K4201"},
             {"sinumerik", "mirror(x: 5)", "K4201"},  // AMIRROR takes the axis, not the place
             {"fanuc", "mirror(x: 5)", ""},
             {"fanuc", "G54.1 P100", "K4201"},
             {"fanuc", "ATRANS X5", "K4201"},
             {"fanuc", "SPOS=90", "K4201"},
             {"fanuc", "G91\nG53 Z0", "K4201"},
             {"fanuc", "G90\nG91 G53 Z0", "K4201"},
             {"fanuc", "G0 X0\nG53 X=IC(5)", "K4201"},
             {"fanuc", "G0 X1\nG54 G30 P3 X0", "K4201"},  // G54 P3 is another offset
             {"iso", "G0 X1\nG54 G30 P3 X0", ""},
             {"fanuc-lathe", "G91\nG53 X5", "K4201"},
             {"fanuc", "mirror()", "K4201"},  // no axis
             {"sinumerik", "reference_point()", "K4201"},
             {"fanuc", "scale(factor: -2)", "K4218"},  // P takes no sign
             {"sinumerik", "scale(factor: -2)", ""},
             {"sinumerik", "G43 H3", "K4201"},
             {"sinumerik", "message(\"say \"hi\"\")", ""},  // with apostrophes
             {"sinumerik", "G91\nG53 Z0", "K4201"},
             {"sinumerik", "G0 X0\nG53 X=IC(5)", "K4201"},
         }) {
        EXPECT_EQ(write(row.dialect, row.source).codes, row.codes)
            << row.dialect << ": " << row.source;
    }
    DiagnosticList sink;
    Writer writer(shipped("fanuc"), {}, sink);
    std::string text;
    Block block;
    block.set(Slot::X, std::numeric_limits<double>::infinity());
    writer.write(block, text);
    block.set(Slot::X, 1);
    writer.write(block, text);
    EXPECT_EQ(testing::codes(sink), "K4203");
    EXPECT_TRUE(writer.failed());
}

TEST(Writer, ADistanceIsNoMachineCoordinate) {
    for (const char* dialect : {"iso", "sinumerik", "fanuc", "axioma"}) {
        SCOPED_TRACE(dialect);
        EXPECT_EQ(write(dialect, "G0 X10\nG53 X=IC(5)").codes, "K4201");
        EXPECT_EQ(write(dialect, "G91 G0 X10\nG53 X5").codes, "K4201");
    }
    expect_text("iso", {{"G0 X10\nG91\nG53 X=AC(5)", "G0 X10\nG91\nG53 X=AC(5)\n"}});
}

TEST(Writer, DimensionsThatALineBeforeChangedAreSaidAgain) {
    Block block;
    Invocation* point = block.add(Function::ReferencePoint, 4);
    block.set_argument(*point, 3, 0);
    block.add(Function::Absolute);
    block.motion = Function::Rapid;
    block.set(Slot::X, 5);
    EXPECT_EQ(write_block("fanuc", block).text, "G91 G28 Z0.\nG90 X5.\n");
    expect_text("fanuc", {{"G91\nG90 G53 Z5", "G91\nG90 G53 Z5.\n"}});
}

TEST(Writer, WhatDoesNotGoTogetherIsAnError) {
    // The edge of the tool and, for the machine coordinates, edge 0.
    Block edge;
    edge.set_argument(*edge.add(Function::Tool, 1), 0, 3);
    edge.add(Function::MachineCoordinates);
    edge.set(Slot::Z, 0);
    EXPECT_EQ(write_block("sinumerik", edge).codes, "K4201");
    // The second reference point would be the second probe.
    Block probe;
    probe.add(Function::Probe, 1);
    probe.set_argument(*probe.add(Function::ReferenceReturn, 1), 0, 2);
    probe.set(Slot::Z, 0);
    EXPECT_EQ(write_block("iso", probe).codes, "K4201");
}

TEST(Writer, ALineOfTheControlsLanguageTakesNoComment) {
    Block block;
    block.set_argument(*block.add(Function::ProbeKeep, 1), 0, 2);
    block.comment = "the far side";
    EXPECT_EQ(write_block("sinumerik", block).text, "; the far side\nR100=$AA_MW[Y]\n");
}

TEST(Writer, LongLinesAreAnError) {
    const std::string line(600, 'X');
    EXPECT_EQ(write("sinumerik", "raw " + line).codes, "K4205");
    EXPECT_EQ(write("sinumerik", "raw " + line.substr(0, 511)).codes, "");
}

TEST(Writer, LongCommentsGoOn) {
    const std::string words =
        "one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen";
    EXPECT_EQ(write("fanuc", "// " + words).text,
              "(ONE TWO THREE FOUR FIVE SIX SEVEN EIGHT NINE TEN ELEVEN TWELVE THIRTEEN "
              "FOURTEEN)\n(FIFTEEN)\n");
}

TEST(Writer, ANumberThatWouldReadOtherwiseIsNeverWritten) {
    // A point that is left out where the control then counts increments.
    // In a folder of its own: a dialect beside the file would be the one that it extends.
    const std::string folder = kadr::testing::scratch("broken_point");
    std::filesystem::create_directories(folder);
    const std::string file = folder + "/broken.xml";
    std::ofstream(file) << "<dialect name=\"broken\" extends=\"fanuc\" title=\"t\" suffix=\"nc\">"
                           "<number addresses=\"X\" point=\"needed\"/></dialect>";
    Sources sources;
    DiagnosticList sink;
    const auto dialect = load_dialect(file, testing::dialect_folders(), sources, sink);
    std::filesystem::remove_all(folder);
    ASSERT_TRUE(dialect);
    Writer writer(*dialect, {}, sink);
    std::string text;
    Block block;
    block.motion = Function::Line;
    block.set(Slot::X, 10);
    writer.write(block, text);
    EXPECT_EQ(testing::codes(sink), "K4206");
}

TEST(Writer, ALeadKeepsItsDecimals) {
    const char* tap =
        "tap(to: -10, pitch: 1.58754, retract: 2, initial: 50, dwell: 0, left: 0, floating: 0, at: "
        "600, back: 0, after: 3)";
    const std::string program = std::string("G0 Z50\n") + tap;
    EXPECT_NE(write("fanuc", program).text.find("G84 Z-10. R2. F1.5875\n"), std::string::npos)
        << write("fanuc", program).text;
    EXPECT_NE(write("sinumerik", program).text.find("3,,1.58754,0,600,0)"), std::string::npos)
        << write("sinumerik", program).text;
    EXPECT_NE(write("fanuc", program, {}, true).text.find("F0.062502\n"), std::string::npos)
        << write("fanuc", program, {}, true).text;
}

TEST(Writer, WhatACycleCannotSayIsNamed) {
    DiagnosticList sink;
    Writer writer(shipped("fanuc"), {}, sink);
    std::string text;
    writer.begin({"test", 1, "", false}, text);
    writer.write(testing::source_block(
                     shipped("iso"),
                     "tap(to: -10, pitch: 1.5, retract: 2, initial: 50, dwell: 0, left: 0, "
                     "floating: 0, at: 600, back: 800, after: 3)"),
                 text);
    ASSERT_EQ(sink.all().size(), 1u);
    EXPECT_NE(testing::rendered(sink, {}).find("the cycle `tap` with this `back`"),
              std::string::npos)
        << testing::rendered(sink, {});
}

TEST(Writer, MessagesNameTheWord) {
    Sources sources;
    const std::string_view program = "G0 X=Z0*2 Y=(Z+1) Z+=10;";
    const FileId file = sources.add("part.kadr", std::string(program));
    const std::vector<SourceRange> statements = {
        {file, 0, static_cast<std::uint32_t>(program.size())}};
    DiagnosticList sink;
    Writer writer(shipped("fanuc"), {}, sink);
    writer.set_statements(statements, &sources);
    Block block = testing::source_block(shipped("iso"), "G0 X2 Y1 Z=IC(10)");
    block.source = SourceId{0};
    std::string text;
    writer.begin({"test", 1, "", false}, text);
    writer.write(block, text);
    ASSERT_EQ(sink.all().size(), 1u);
    EXPECT_EQ(sources.text(sink.all()[0].range), "Z+=10");
}

TEST(Writer, MessagesNameTheStatement) {
    DiagnosticList sink;
    Writer writer(shipped("sinumerik"), {}, sink);
    const std::vector<SourceRange> statements = {{FileId{0}, 3, 9}};
    writer.set_statements(statements);
    Block block = testing::source_block(shipped("iso"), "G92 X0");
    block.source = SourceId{0};
    std::string text;
    writer.write(block, text);
    writer.write(block, text);  // in a loop: said once
    ASSERT_EQ(sink.all().size(), 1u);
    EXPECT_EQ(sink.all()[0].range, statements[0]);
}

}  // namespace
}  // namespace kadr::write::writer_test
