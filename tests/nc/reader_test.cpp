// Text → blocks, per control: lexical rules, meaning of numbers, groups, and the control's alarms.
#include "nc/reader.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/nc/nc_testing.h"

namespace kadr::nc::reader_test {
namespace {

using testing::read_blocks;
using testing::shipped;

struct Row {
    const char* text;
    const char* blocks;  // described, one a line
};

void expect_blocks(const char* dialect, std::initializer_list<Row> rows) {
    for (const Row& row : rows) {
        const auto result = read_blocks(shipped(dialect), row.text);
        std::string all;
        for (const Block& block : result.blocks) {
            if (!all.empty()) all += '\n';
            all += describe(block);
        }
        EXPECT_EQ(all, row.blocks) << dialect << ": " << row.text;
        EXPECT_EQ(result.messages.errors(), 0u) << dialect << ": " << row.text;
        EXPECT_FALSE(result.failed);
    }
}

TEST(Reader, FanucNumbers) {
    // Reference fanuc.md chapters 1.6 and 12: IS-B, conventional decimal point input.
    expect_blocks(
        "fanuc",
        {
            {"G00X1.23456", "rapid X1.234"},  // cut, not rounded
            {"G00X-1.23456", "rapid X-1.234"},
            {"G00X1000", "rapid X1"},
            {"X1000.", "X1000"},
            {"X+10.Y-.5", "X10 Y-0.5"},
            {"X10", "X0.01"},
            {"G20\nX10000\nX1.", "inch\nX25.4\nX25.4"},
            {"G20 X1. F10.", "X25.4 F254 | inch"},  // the block's own G20 acts in it
            {"A90.\nA90", "A90\nA0.09"},
            {"G94 F200\nF200.", "F200 | feed_per_minute\nF200"},
            {"G95 F20\nF0.2", "F0.2 | feed_per_revolution\nF0.2"},
            {"G04P500\nG04X0.5\nG04X500", "dwell(time=0.5)\ndwell(time=0.5)\ndwell(time=0.5)"},
            {"X123456.789", "X123456.789"},
            {"X-0.", "X0"},
        });
}

TEST(Reader, FanucWords) {
    expect_blocks("fanuc",
                  {
                      {"%\nO0001(TITLE)\nG00 X1.\nM30\n%\nX5.", "rapid X1\nend_rewind"},
                      {"G 0 1 X 1 0 . Y5.", "line X10 Y5"},
                      {"G0X1.G1X2.", "line X2"},  // the last one is valid
                      {"/G00 X1.\n/3 N5 X2.", "/1 rapid X1\n/3 N5 X2"},
                      {"N100 G01 X25.4 Y-10. F300. S1200 M08 (COMMENT)",
                       "N100 line X25.4 Y-10 F300 S1200 | coolant_flood ; COMMENT"},
                      {"(ONLY A COMMENT)", "comment \"ONLY A COMMENT\""},
                      {"(MSG,LOAD)", "message(text=\"LOAD\")"},
                      {"G02 X10. Y0. R5.", "arc_cw X10 Y0 R5"},
                      {"G43 H03 Z50.", "Z50 | length_comp_on(offset=3)"},
                      {"T03 M06", "tool_select(tool=3) | tool_change"},
                      {"G54.1 P2\nG54 P2\nG54.1\nG54",
                       "work_offset(number=8)\nwork_offset(number=8)\nwork_offset(number=7)\nwork_"
                       "offset(number=1)"},
                      {"G04", "exact_stop_once"},
                      {"G52 X60.", "shift(x=60)"},
                      {"G92 S3000", "speed_limit(limit=3000)"},
                      {"G68 X0. Y0. R30.", "rotate(angle=30, x=0, y=0)"},
                      {"G68 R30.", "rotate(angle=30)"},
                      {"G51 X10. Y5. Z0. P1500\nG51 X0 Y0 Z0 I2000 J500 K1000\nG50",
                       "scale(factor=1.5, x=10, y=5, z=0)\n"
                       "scale(x=0, y=0, z=0, fx=2, fy=0.5, fz=1)\nscale_off"},
                      {"G91 G28 Z0.\nG30 P3 X1.\nG30 Y1.",
                       "Z0 | incremental | reference_return(point=1)\n"
                       "X1 | reference_return(point=3)\nY1 | reference_return(point=2)"},
                      {"M29 S800\nG98 G84 Z-10. R2. F800.",
                       "S800 | tap_rigid\n"
                       "F800 | cycle_return_initial | cycle#3(0=-10, 2=2, 5=0, 6=1, 9=3)"},
                      {"G41 D21 X5.", "X5 | radius_comp_left | radius_offset(offset=21)"},
                      {"M88", "machine_function(number=88)"},
                      {"G98 G83 X5. Z-12. R2. Q3. F180.",
                       "X5 F180 | cycle_return_initial | cycle#1(0=-12, 1=3, 2=2, 4=0)"},
                      {"G82 Z-5. R2. P500", "cycle#0(0=-5, 1=2, 3=0.5)"},
                      {"M03 M08", "spindle_cw | coolant_flood"},
                      {"G90 G54 G17 G40 G80",
                       "absolute | work_offset(number=1) | plane_xy | radius_comp_off | cycle_off"},
                      {"X1.\r\nY2.\r\n", "X1\nY2"},
                  });
}

TEST(Reader, SinumerikWords) {
    // Reference sinumerik.md chapters 1.2, 1.3, 15.1 and 15.2.
    expect_blocks(
        "sinumerik",
        {
            {"%_N_PART_MPF\n;$PATH=/_N_WKS_DIR\nN10 G17 G90 G1 X10 Y10 F500     ; (10,10)",
             "comment \"$PATH=/_N_WKS_DIR\"\nN10 line X10 Y10 F500 | plane_xy | absolute ; "
             "(10,10)"},
            {"N20 X=IC(5)", "N20 X=IC(5)"},
            {"N30 G91 X5 Y=AC(0)", "N30 X5 Y=AC(0) | incremental"},
            {"x10 g1 f.5", "line X10 F0.5"},
            {"G1X10Y20F100", "line X10 Y20 F100"},
            {"X=10 Y = -5", "X10 Y-5"},
            {"X1.5EX-3", "X0.0015"},
            {"G3 X0 Y20 CR=20", "arc_ccw X0 Y20 R20"},
            {"G3 X0 Y20 I=AC(0) J=AC( 0 )", "arc_ccw X0 Y20 I=AC(0) J=AC(0)"},
            {"G3 X0 Y20 I-20 J0 Z-9 TURN=2", "arc_ccw X0 Y20 Z-9 I-20 J0 TURN=2"},
            {"/ X1\n/3 N120 G1 G91 X10 M8",
             "/0 X1\n/3 N120 line X10 | incremental | coolant_flood"},
            {"G505\nG500\nG57\nG599",
             "work_offset(number=5)\nwork_offset(number=0)\nwork_offset(number=4)\nwork_offset("
             "number=99)"},
            {"SUPA G0 Z0 D0", "rapid Z0 | machine_coordinates | tool_edge(edge=0)"},
            {"T=\"MILL_10\" D1\nT=\"3\"",
             "tool_select | tool_edge(edge=1) \"MILL_10\"\ntool_select(tool=3)"},
            {"MSG(\"ready; go\")\nMSG()", "message(text=\"ready; go\")\nmessage"},
            {"TRANS X10 Y=5\nTRANS\nAMIRROR X0", "shift(x=10, y=5)\nshift\nmirror(x=0)"},
            {"ROT RPL=30\nROT\nSCALE X2\nMIRROR X0",
             "shift | rotate(angle=30)\nshift\nshift | scale(fx=2)\nshift | mirror(x=0)"},
            {"G75 FP=2 Z1=0\nG74 X1=0 Y1=0",
             "reference_point(point=2, z=0)\nreference_point(x=0, y=0)"},
            {"G331 Z-10 K-1.25 S300\nG63 Z2 F375",
             "tap_in Z-10 K-1.25 S300\nZ2 F375 | tap_floating"},
            {"CYCLE84(50,2,0,-10,,,5,,-1.25,0,600)",
             "cycle#3(0=-10, 1=1.25, 2=2, 3=50, 5=1, 6=0, 7=600, 9=5)"},
            {"M41", "machine_function(number=41)"},
            {"G4 F2.5\nG4 S30", "dwell(time=2.5)\ndwell(revolutions=30)"},
            {"LIMS=3000", "speed_limit(limit=3000)"},
            {"G96 S120\nG97\nG94",
             "S120 | cutting_speed_on | feed_per_revolution\ncutting_speed_off\nfeed_per_minute"},
            {"CYCLE81(10,0,2,-40)", "cycle#0(0=-40, 1=2, 2=10, 3=0)"},
            {"CYCLE83(50,2,0,-12,,,3,-1,0,0,1,1,,,,,1)", "cycle#1(0=-12, 1=3, 2=2, 3=50, 4=0)"},
            {"CYCLE83(50,2,0,-12,,,3,0,0,0,1,1)",
             "cycle#16(0=50, 1=2, 2=0, 3=-12, 6=3, 7=0, 9=0, 10=0, 11=1, 12=1)"},
            {"G700 X1 F10\nG70 X1 F10", "X25.4 F254 | inch\nX25.4 F10 | inch"},
            {"START:\nM17", "label START\nend"},
        });
}

// An equals sign sends no line the long way, and says nothing by itself.
TEST(Reader, ASignBeforeANumberSaysNothing) {
    const struct {
        const char* with;
        const char* without;
    } rows[] = {
        {"G1 X=1.5 Y=-.5 Z=+3 F=100", "G1 X1.5 Y-.5 Z+3 F100"},
        {"N10 G0X=1Y=2", "N10 G0X1Y2"},
        {"g1 x=1 f=5", "G1 X1 F5"},
        {"G17 G2 X=10 Y=0 I=5 J=0 F=100", "G17 G2 X10 Y0 I5 J0 F100"},
        {"G700\nG1 X=1 F=10", "G700\nG1 X1 F10"},
    };
    for (const auto& row : rows) {
        const auto with = read_blocks(shipped("sinumerik"), row.with);
        const auto without = read_blocks(shipped("sinumerik"), row.without);
        ASSERT_EQ(with.blocks.size(), without.blocks.size()) << row.with;
        for (std::size_t i = 0; i < with.blocks.size(); ++i)
            EXPECT_EQ(describe(with.blocks[i]), describe(without.blocks[i])) << row.with;
        EXPECT_EQ(with.messages.errors(), 0u) << row.with;
    }
    expect_blocks("sinumerik", {{"G17 G2 X10 CR=5 F100", "arc_cw X10 R5 F100 | plane_xy"},
                                {"G17 G2 X10 CR=-5", "arc_cw X10 R-5 | plane_xy"}});
    EXPECT_TRUE(read_blocks(shipped("sinumerik"), "G1 N=5").failed);
    EXPECT_TRUE(read_blocks(shipped("fanuc"), "G1 X=5.").failed);
}

TEST(Reader, FanucLatheWords) {
    // Reference fanuc.md chapters 2.3, 2.5, 3.6 and 5.6.
    expect_blocks("fanuc-lathe",
                  {
                      {"G00 X40. W-5.", "rapid X40 Z=IC(-5)"},
                      {"T0101\nT1203\nT0100",
                       "tool_select(tool=1, offset=1)\ntool_select(tool=12, offset=3)\n"
                       "tool_select(tool=1, offset=0)"},
                      {"G50 S2500\nG96 S180 M03",
                       "speed_limit(limit=2500)\nS180 | cutting_speed_on | spindle_cw"},
                      {"G98 G01 Z-5. F200.\nG99 F0.2",
                       "line Z-5 F200 | feed_per_minute\nF0.2 | feed_per_revolution"},
                      {"G28 U0 W0", "X=IC(0) Z=IC(0) | reference_return(point=1)"},
                      {"G32 Z-20. F1.5 Q90000", "thread Z-20 F1.5 | thread_start(angle=90)"},
                      {"G76 P010060 Q100 R0.1\nG76 X18.16 Z-30. P920 Q350 F1.5",
                       "cycle_preset#11(6=30, 7=0.1, 8=1, 9=0.1, 11=0)\n"
                       "F1.5 | cycle#11(0=18.16, 1=-30, 2=0.92, 3=0.35)"},
                  });
}

struct WrongRow {
    const char* text;
    const char* alarm;
    unsigned line, column;
};

void expect_alarms(const char* dialect, std::initializer_list<WrongRow> rows) {
    for (const WrongRow& row : rows) {
        SCOPED_TRACE(std::string(dialect) + ": " + row.text);
        const auto result = read_blocks(shipped(dialect), row.text);
        EXPECT_TRUE(result.failed);
        ASSERT_EQ(result.messages.all().size(), 1u);
        const Diagnostic& message = result.messages.all()[0];
        EXPECT_EQ(message.alarm_number, row.alarm) << message.message();
        ASSERT_TRUE(message.line);
        EXPECT_EQ(message.line->line, row.line);
        EXPECT_EQ(message.line->column, row.column) << message.message();
    }
}

TEST(Reader, BlockNumbersAndHeadersHaveTheirPlace) {
    // Reference sinumerik.md 1.2: N begins a block; fanuc.md 1.3: it may stand behind other words.
    expect_alarms("sinumerik", {
                                   {"G1 X1 N10 F5", "12080", 1, 7},
                                   {"N10 N20 X1", "12080", 1, 5},
                                   {"%_N_A_MPF\nX1\n%B", "12080", 3, 1},
                               });
    // Behind the head of another program nothing belongs to this one.
    expect_blocks("sinumerik", {{"%_N_A_MPF\nX1\n%_N_B_SPF\nX2", "X1"}});
    expect_blocks("sinumerik", {{"; REMARK\n%_N_A_MPF\n\nX1", "comment \"REMARK\"\nX1"}});
    expect_blocks("fanuc", {
                               {"G01 X1. N10 Y2.", "N10 line X1 Y2"},
                               // Another program begins: the text of this one ends.
                               {"%\nO0001\nX1.\nO0002\nX2.", "X1"},
                           });
}

TEST(Reader, FanucAlarms) {
    expect_alarms("fanuc", {
                               {"G54.1 P999", "PS0030", 1, 7},
                               {"G54.1 P0", "PS0030", 1, 7},
                               {"/0 X1.", "", 1, 1},
                               {"G01 X10. E5.", "PS0009", 1, 10},
                               {"G111 X10.", "PS0010", 1, 1},
                               {"G01 X Y5.", "PS0005", 1, 5},
                               {"X.", "PS0005", 1, 1},
                               {"X1234567.", "PS0003", 1, 1},
                               {"X1.234567891", "PS0003", 1, 1},
                               {"G04 P500.", "PS0007", 1, 5},
                               {"S100.5", "PS0007", 1, 1},
                               {"G01 X1. F-5.", "PS0006", 1, 9},
                               {"G01 X1. P5", "PS0009", 1, 9},
                               {"G10 P1 X0.", "PS1144", 1, 1},
                               {"G04 X1. P500", "PS0010", 1, 5},
                               {"X1.\nX1. (ROUGH\nX2.", "PS0004", 2, 5},
                               {"G01 x5.", "PS0004", 1, 5},
                               {"N X5.", "PS0005", 1, 1},
                           });
}

TEST(Reader, SinumerikAlarms) {
    expect_alarms("sinumerik", {
                                   {"G1 X10 Q5", "12550", 1, 8},
                                   {"G81 X10", "12470", 1, 1},
                                   {"GX10", "12550", 1, 1},
                                   {"CR7", "12550", 1, 1},
                                   {"G1 X Y10", "12080", 1, 4},
                                   {"N10 X10 X20", "12010", 1, 9},
                                   {"G0 G1 X10", "12060", 1, 4},
                                   {"G95 G96 S100", "12060", 1, 5},
                                   {"TRANS X10 G1", "12120", 1, 1},
                                   {"F=IC(100)", "12020", 1, 1},
                                   {"G1 X10,5", "12080", 1, 7},
                                   {"(comment)", "12080", 1, 1},
                                   {"/12 X5", "12080", 1, 1},
                                   {"G2 X1 Y1 R10", "12550", 1, 10},
                                   {"MSG(\"open", "12080", 1, 1},
                                   {"Ж X5", "12080", 1, 1},
                               });
}

TEST(Reader, WhatIsNotReadYetSaysSo) {
    for (const char* text : {"R1=5", "X=R1", "X=SIN(30)", "T2=5", "$AA_IM[X]=5", "LOOP1: X5"}) {
        EXPECT_EQ(testing::codes(read_blocks(shipped("sinumerik"), text).messages), "K5018")
            << text;
    }
    for (const char* text : {"#1=5", "G01 X#1", "G01 X[1+2]"}) {
        EXPECT_EQ(testing::codes(read_blocks(shipped("fanuc"), text).messages), "K5018") << text;
    }
}

TEST(Reader, WordsOfTheControlThatKadrLacksAreNotTheProgramsMistake) {
    const auto said = [](const char* dialect, const char* text) {
        const auto read = read_blocks(shipped(dialect), text);
        return testing::rendered(read.messages, {});
    };
    EXPECT_NE(
        said("sinumerik", "G5 X10").find("`G5` (inclined plunging) is not supported by Kadr yet"),
        std::string::npos);
    EXPECT_NE(said("sinumerik", "reposl X10 Y2").find("`REPOSL` (way back"), std::string::npos);
    EXPECT_NE(said("fanuc", "G05.4 Q1").find("`G05.4` (high-speed machining)"), std::string::npos);
    EXPECT_EQ(testing::codes(read_blocks(shipped("sinumerik"), "FOOBAR=2").messages), "K5001");
    EXPECT_EQ(testing::codes(read_blocks(shipped("fanuc"), "G777").messages), "K5002");
}

TEST(Reader, ALeadHasItsOwnDecimals) {
    const auto block = [](const char* text) {
        const auto read = read_blocks(shipped("fanuc"), text);
        return read.blocks.empty() ? std::string() : describe(read.blocks.back());
    };
    EXPECT_EQ(block("G95 G01 Z-5. F1.5875"), "line Z-5 F1.5875 | feed_per_revolution");
    EXPECT_EQ(block("G94 G01 Z-5. F1.5875"), "line Z-5 F1.587 | feed_per_minute");
    EXPECT_EQ(block("G20 G95 G01 F0.059055"), "line F1.499997 | inch | feed_per_revolution");
}

TEST(Reader, WordsWithoutEffectAreAccepted) {
    expect_blocks(
        "fanuc",
        {{"G40G49G80G69G50G15",
          "radius_comp_off | length_comp_off | cycle_off | rotate_off | scale_off | polar_off"},
         {"G08 P1\nG01 X1.", "line X1"}});
    expect_blocks("sinumerik", {{"G1 SOFT G601 X5 CDOF2", "line X5"}, {"STOPRE", ""}});
    // A word of arcs beside a cycle is not passed over.
    EXPECT_EQ(testing::codes(read_blocks(shipped("fanuc"), "G81 X1. Z-5. R2. J3.").messages),
              "K5010");
}

TEST(Reader, WhatPeopleAndEditorsPutAroundBlocks) {
    // A byte order mark, EOB as a PC shows it, several skip levels, blanks behind a sign.
    expect_blocks("fanuc", {{"\xEF\xBB\xBFG01 X1.", "line X1"},
                            {"G01X1.;", "line X1"},
                            {"/2/3 G01 X - 1 . 5", "/2 line X-1.5"},
                            {"G04 P500 F100", "F100 | dwell(time=0.5)"}});
    expect_blocks("sinumerik", {{"\xEF\xBB\xBFG1 X1", "line X1"}});
    const auto skipped = read_blocks(shipped("fanuc"), "/2/3/9 X1.");
    ASSERT_EQ(skipped.blocks.size(), 1u);
    EXPECT_EQ(skipped.blocks[0].further_skip_levels, (1u << 3 | 1u << 9));
    EXPECT_EQ(testing::codes(read_blocks(shipped("sinumerik"), "/2/3 X1").messages), "K5015");
    EXPECT_EQ(testing::codes(read_blocks(shipped("fanuc"), "G04 P500 Y1.").messages), "K5013");
    EXPECT_EQ(testing::codes(read_blocks(shipped("fanuc"), "G01 X - Y1.").messages), "K5015");
}

TEST(Reader, BlocksHaveALimitOfWords) {
    std::string line;
    for (int i = 0; i < 30; ++i) line += "M8 M9 M7 ";
    EXPECT_EQ(testing::codes(read_blocks(shipped("iso"), line).messages), "K5017");
    EXPECT_EQ(testing::codes(read_blocks(shipped("fanuc"), "M3 M8 M88").messages), "");
    EXPECT_EQ(testing::codes(read_blocks(shipped("fanuc"), "M3 M8 M88 M89").messages), "K5007");
}

TEST(Reader, GoesOnBehindAMistake) {
    const auto result = read_blocks(shipped("fanuc"), "X1.\nE5.\nX2.\nG111\n");
    EXPECT_EQ(result.blocks.size(), 2u);
    EXPECT_EQ(result.blocks[1].line, 3u);
    EXPECT_EQ(testing::codes(result.messages), "K5001 K5002");
}

/// Gives a text in pieces of a fixed size.
class Pieces final : public TextSource {
  public:
    Pieces(std::string_view text, std::size_t size) : text_(text), size_(size) {}
    std::string_view next() override {
        const std::string_view piece = text_.substr(0, size_);
        text_.remove_prefix(piece.size());
        return piece;
    }

  private:
    std::string_view text_;
    std::size_t size_;
};

TEST(Reader, PiecesMayEndAnywhere) {
    const std::string feeds = "N10 G1 X1.5 F200\r\nN20 X2 ; two\n\nN30 G4 F1.5\nN40 X3";
    const std::string returns = "N10 G1 X1.5 F200\rN20 X2 ; two\r\rN30 G4 F1.5\rN40 X3";
    const std::string empty_first = "N10 G1 X1.5 F200\r\rN20 X2 ; two\rN30 G4 F1.5\rN40 X3";
    for (const std::string& text : {feeds, returns, empty_first})
        for (std::size_t size = 1; size < text.size() + 1; ++size) {
            SCOPED_TRACE(text);
            Pieces pieces(text, size);
            DiagnosticList sink;
            Reader reader(shipped("sinumerik"), pieces, "part.mpf", sink);
            std::vector<Block> blocks(10);
            ASSERT_EQ(reader.pull(blocks), 4u) << size;
            EXPECT_EQ(describe(blocks[0]), "N10 line X1.5 F200");
            EXPECT_EQ(describe(blocks[1]), "N20 X2 ; two");
            EXPECT_EQ(describe(blocks[3]), "N40 X3");
            EXPECT_EQ(blocks[3].line, 5u);
            EXPECT_EQ(reader.pull(blocks), 0u);
            EXPECT_EQ(reader.lines(), 5u);
        }
}

TEST(Reader, LongLinesAreAnAlarmAndNotMemory) {
    /// A line of 200 MB in pieces of 64 KiB.
    class Endless final : public TextSource {
      public:
        std::string_view next() override {
            if (count_++ > 3200)
                return count_ == 3202 ? std::string_view("\nX5\n") : std::string_view();
            return piece_;
        }

      private:
        std::string piece_ = std::string(65536, 'X');
        int count_ = 0;
    };
    Endless source;
    DiagnosticList sink;
    Reader reader(shipped("sinumerik"), source, "part.mpf", sink);
    std::vector<Block> blocks(2);
    EXPECT_EQ(reader.pull(blocks), 1u);
    EXPECT_EQ(describe(blocks[0]), "X5");
    EXPECT_EQ(blocks[0].line, 2u);
    ASSERT_EQ(testing::codes(sink), "K5016");
    EXPECT_EQ(sink.all()[0].alarm_number, "12540");
}

TEST(Reader, ALineWithoutAnEndEndsTheText) {
    class Zeros final : public TextSource {
      public:
        std::string_view next() override { return piece_; }

      private:
        std::string piece_ = std::string(1 << 20, '\0');
    };
    Zeros source;
    DiagnosticList sink;
    Reader reader(shipped("fanuc"), source, "part.nc", sink);
    std::vector<Block> blocks(2);
    EXPECT_EQ(reader.pull(blocks), 0u);
    EXPECT_EQ(testing::codes(sink), "K5016");
}

TEST(Reader, Places) {
    const std::string text = "N10 G1 X1 F200\nN20 G2 X5 Y5 CR=3 M8\n";
    Pieces pieces(text, text.size());
    DiagnosticList sink;
    Reader reader(shipped("sinumerik"), pieces, "part.mpf", sink);
    std::vector<Block> blocks(2);
    ASSERT_EQ(reader.pull(blocks), 2u);
    EXPECT_EQ(reader.location(blocks[1]).line, 2u);
    EXPECT_EQ(reader.location(blocks[1]).column, 5u);
    EXPECT_EQ(reader.location(blocks[1], Slot::Radius).column, 14u);
    EXPECT_EQ(reader.location(blocks[1], Slot::Radius).length, 4u);
    EXPECT_EQ(reader.location(blocks[1], Function::CoolantFlood).column, 19u);
    EXPECT_EQ(reader.location(blocks[1], Function::ArcCw).text, "N20 G2 X5 Y5 CR=3 M8");
    EXPECT_EQ(reader.location(blocks[0], Slot::Feed).column, 11u);
}

}  // namespace
}  // namespace kadr::nc::reader_test
