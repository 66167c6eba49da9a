// Cycles written the way of a control: which blocks they are for every target.
#include <gtest/gtest.h>

#include "tests/sema/running.h"

namespace kadr::testing::source_cycles_test {
namespace {

/// A source says its dialect in its first line.
RunOptions options_of(const std::string& source, const std::string& target) {
    RunOptions options;
    options.with_stdlib = true;
    const std::size_t begin = source.find(' ') + 1;
    options.source = source.substr(begin, source.find(';') - begin);
    options.target = target;
    return options;
}

std::string fanuc(const std::string& statements) {
    return "dialect fanuc;\nprogram p() {\nS1000 M3;\nG0 X0. Y0. Z50.;\nF100;\n" + statements +
           "\n}";
}

std::string sinumerik(const std::string& statements) {
    return "dialect sinumerik;\nprogram p() {\nS1000 M3;\nG0 X0 Y0 Z50;\nF100;\n" + statements +
           "\n}";
}

/// The blocks behind F100.
std::string blocks(const std::string& source, const std::string& dialect) {
    const Outcome outcome = run(source, options_of(source, dialect));
    EXPECT_EQ(outcome.all_messages(), "") << source;
    const std::string all = outcome.all_blocks();
    const std::size_t begin = all.find("F100\n");
    return begin == std::string::npos ? all : all.substr(begin + 5);
}

TEST(SourceCycles, AtEveryPlaceUntilTheModeEnds) {
    const std::string source = fanuc("G81 X10. Z-5. R2.; Y5.; M8; X20.; G80; X30.;");
    EXPECT_EQ(blocks(source, "fanuc"),
              "rapid X10\ncycle#0(0=-5, 1=2, 2=50, 3=0)\nrapid Y5\n"
              "cycle#0(0=-5, 1=2, 2=50, 3=0)\ncoolant_flood\nrapid X20\n"
              "cycle#0(0=-5, 1=2, 2=50, 3=0)\nrapid X30");
    EXPECT_EQ(blocks(fanuc("G81 X10. Z-5. R2.; G01 Y5.; X20.;"), "fanuc"),
              "rapid X10\ncycle#0(0=-5, 1=2, 2=50, 3=0)\nline Y5\nX20");
    EXPECT_EQ(blocks(fanuc("G81 Z-5. R2.;"), "iso"), "rapid Z2\nline Z-5\nrapid Z50");
}

TEST(SourceCycles, LevelsThatAPlaceChangesStay) {
    EXPECT_EQ(blocks(fanuc("G81 X10. Z-5. R2.; X20. Z-6.; X30. R3.; X40.;"), "fanuc"),
              "rapid X10\ncycle#0(0=-5, 1=2, 2=50, 3=0)\nrapid X20\n"
              "cycle#0(0=-6, 1=2, 2=50, 3=0)\nrapid X30\ncycle#0(0=-6, 1=3, 2=50, 3=0)\n"
              "rapid X40\ncycle#0(0=-6, 1=3, 2=50, 3=0)");
    // Only a level: once more at the same place.
    EXPECT_EQ(blocks(fanuc("G81 X10. Z-5. R2.; Z-6.;"), "fanuc"),
              "rapid X10\ncycle#0(0=-5, 1=2, 2=50, 3=0)\ncycle#0(0=-6, 1=2, 2=50, 3=0)");
}

/// As the control does: R counts from where the mode began, Z from R, whichever was said last.
TEST(SourceCycles, LevelsThatAreDistancesStaySo) {
    EXPECT_EQ(blocks(fanuc("G91 G81 X10. Z-15. R-40.; G82 X10. R-38. P500; G80;"), "fanuc"),
              "rapid X10 | incremental\nabsolute\ncycle#0(0=-5, 1=10, 2=50, 3=0)\nincremental\n"
              "rapid X10\nabsolute\ncycle#0(0=-3, 1=12, 2=50, 3=0.5)\nincremental");
}

TEST(SourceCycles, StrokeAndDwellThatAPlaceChangesStay) {
    EXPECT_EQ(blocks(fanuc("G83 X10. Z-12. R2. Q4.; X20. Q2.; X30.; G80;"), "fanuc"),
              "rapid X10\ncycle#1(0=-12, 1=4, 2=2, 3=50, 4=0)\nrapid X20\n"
              "cycle#1(0=-12, 1=2, 2=2, 3=50, 4=0)\nrapid X30\n"
              "cycle#1(0=-12, 1=2, 2=2, 3=50, 4=0)");
    EXPECT_EQ(blocks(fanuc("G82 X10. Z-5. R2. P500; X20. P100; G80;"), "fanuc"),
              "rapid X10\ncycle#0(0=-5, 1=2, 2=50, 3=0.5)\nrapid X20\n"
              "cycle#0(0=-5, 1=2, 2=50, 3=0.1)");
    // Q waits for a cycle that has one.
    EXPECT_EQ(blocks(fanuc("G81 X10. Z-5. R2.; X20. Q2.; G83 X30.; G80;"), "fanuc"),
              "rapid X10\ncycle#0(0=-5, 1=2, 2=50, 3=0)\nrapid X20\n"
              "cycle#0(0=-5, 1=2, 2=50, 3=0)\nrapid X30\n"
              "cycle#1(0=-5, 1=2, 2=2, 3=50, 4=0)");
    const std::string source = fanuc("X10. Q2.;");
    EXPECT_EQ(run(source, options_of(source, "fanuc")).all_messages(),
              "6:1 K4131 `Q` beside a position changes the modal cycle, and none is active");
}

TEST(SourceCycles, TapsWithAllThatTheControlSays) {
    const std::string angle = sinumerik("CYCLE84(50, 0, 2, -15,,, 3,, 1.5, 90, 300,);");
    EXPECT_EQ(run(angle, options_of(angle, "fanuc")).all_messages().substr(0, 22),
              "6:1 K3301 POSS 90 deg:");
    EXPECT_EQ(blocks(sinumerik("CYCLE84(50, 0, 2, -15,,, 3, 10,,, 300,);"), "fanuc"),
              "cycle#3(0=-15, 1=1.5, 2=2, 3=50, 4=0, 5=0, 6=0, 7=300, 8=0, 9=3)");
    // Without an encoder the feed makes the thread: 100 mm/min at 1000 rpm.
    const std::string fed =
        blocks(sinumerik("CYCLE840(50, 0, 2, -15,, 0, 4, 3, 1,, 1.5);"), "fanuc");
    EXPECT_EQ(fed.substr(0, 19), "cycle#3(0=-15, 1=0.");
    EXPECT_NE(fed.find("6=1, 7=1000"), std::string::npos) << fed;
}

TEST(SourceCycles, LevelsHoldFromCycleToCycle) {
    EXPECT_EQ(blocks(fanuc("G85 X10. Z-5. R2.; G86 X20.; G89 X30. P500; G81 X40. Z-6.;"), "fanuc"),
              "rapid X10\ncycle#5(0=-5, 1=2, 2=50, 3=0)\nrapid X20\ncycle#6(0=-5, 1=2, 2=50)\n"
              "rapid X30\ncycle#5(0=-5, 1=2, 2=50, 3=0.5)\nrapid X40\n"
              "cycle#0(0=-6, 1=2, 2=50, 3=0)");
    // P waits for the next cycle that dwells; under G91 a level from before stays where it is.
    EXPECT_EQ(blocks(fanuc("G82 X10. Z-5. R2. P500; G81 X20.; G82 X30.;"), "fanuc"),
              "rapid X10\ncycle#0(0=-5, 1=2, 2=50, 3=0.5)\nrapid X20\n"
              "cycle#0(0=-5, 1=2, 2=50, 3=0)\nrapid X30\ncycle#0(0=-5, 1=2, 2=50, 3=0.5)");
    EXPECT_EQ(blocks(fanuc("G81 X10. Z-5. R2.; G91 G85 X10. Z-9.;"), "fanuc"),
              "rapid X10\ncycle#0(0=-5, 1=2, 2=50, 3=0)\nrapid X10 | incremental\nabsolute\n"
              "cycle#5(0=-7, 1=2, 2=50, 3=0)\nincremental");
    // The end of the mode ends them.
    for (const char* ended : {"G85 X3. Y3. R1. Z-4.; G80; G86 X4.;", "G86 X4.;"}) {
        const Outcome outcome = run(fanuc(ended), options_of(fanuc(ended), "fanuc"));
        ASSERT_EQ(outcome.messages.size(), 1u) << ended;
        EXPECT_TRUE(outcome.messages[0].ends_with("K4107")) << outcome.messages[0];
        EXPECT_EQ(outcome.texts[0], "`G86` lacks words: `Z R`");
    }
}

TEST(SourceCycles, TheReturnLevel) {
    EXPECT_EQ(blocks(fanuc("G99 G81 X10. Z-5. R2.; G98 X20.;"), "fanuc"),
              "rapid X10\ncycle#0(0=-5, 1=2, 2=2, 3=0)\nrapid X20\ncycle#0(0=-5, 1=2, 2=50, 3=0)");
}

TEST(SourceCycles, DistancesOfIncrementalDimensions) {
    // R from the level where the mode began, Z from R; a level said once stays where it is.
    EXPECT_EQ(blocks(fanuc("G91 G81 X10. Z-8. R-45.; X10.; G90 X0.;"), "fanuc"),
              "rapid X10 | incremental\nabsolute\ncycle#0(0=-3, 1=5, 2=50, 3=0)\nincremental\n"
              "rapid X10\nabsolute\ncycle#0(0=-3, 1=5, 2=50, 3=0)\nincremental\n"
              "rapid X0 | absolute\ncycle#0(0=-3, 1=5, 2=50, 3=0)");
    EXPECT_EQ(blocks(fanuc("G81 X10. Z-5. R2.; G91 X10.; Z-9.;"), "fanuc"),
              "rapid X10\ncycle#0(0=-5, 1=2, 2=50, 3=0)\nrapid X10 | incremental\nabsolute\n"
              "cycle#0(0=-5, 1=2, 2=50, 3=0)\nincremental\nabsolute\n"
              "cycle#0(0=-7, 1=2, 2=50, 3=0)\nincremental");
}

TEST(SourceCycles, TheInitialLevelMovesWithAShift) {
    EXPECT_EQ(blocks(fanuc("G81 X10. Z-5. R2.; G52 Z10.; X20.; G52 Z0.;"), "fanuc"),
              "rapid X10\ncycle#0(0=-5, 1=2, 2=50, 3=0)\nshift(z=10)\nrapid X20\n"
              "cycle#0(0=-5, 1=2, 2=40, 3=0)\nshift(z=0)");
}

TEST(SourceCycles, PlacesInLoopsAndFunctions) {
    EXPECT_EQ(blocks("dialect fanuc;\nvoid places() { for (int i : 1..2) X=i*10; }\n"
                     "program p() {\nS1000 M3;\nG0 X0. Y0. Z50.;\nF100;\n"
                     "G81 Z-5. R2.; places(); G80; places();\n}",
                     "fanuc"),
              "cycle#0(0=-5, 1=2, 2=50, 3=0)\nrapid X10\ncycle#0(0=-5, 1=2, 2=50, 3=0)\n"
              "rapid X20\ncycle#0(0=-5, 1=2, 2=50, 3=0)\nrapid X10\nX20");
}

TEST(SourceCycles, TapsHaveTheirPitchFromF) {
    // In a chuck the spindle turns on, rigid it stands behind; 1 mm a turn.
    EXPECT_EQ(blocks(fanuc("G84 X10. Z-5. R5. F1000;"), "sinumerik"),
              "rapid X10 F1000\n"
              "cycle#3(0=-5, 1=1, 2=5, 3=50, 4=0, 5=0, 6=1, 7=1000, 8=0, 9=3)");
    EXPECT_EQ(blocks(fanuc("M29 S500; G95 G74 X10. Z-5. R5. P200 F1.5;"), "sinumerik"),
              "S500\nrapid X10 F1.5 | feed_per_revolution\n"
              "cycle#3(0=-5, 1=1.5, 2=5, 3=50, 4=0.2, 5=1, 6=0, 7=500, 8=0, 9=5)");
}

TEST(SourceCycles, RepeatsUnderDistances) {
    const std::string three =
        "rapid X+10 | incremental\nabsolute\ncycle#0(0=-5, 1=2, 2=50, 3=0)\nincremental\n";
    EXPECT_EQ(blocks(fanuc("G91 G81 X10. Z-7. R-48. K3; G80; G90;"), "fanuc"),
              blocks(fanuc("G91 G81 X10. Z-7. R-48.; X10.; X10.; G80; G90;"), "fanuc"));
    EXPECT_EQ(blocks(fanuc("G81 Z-5. R2.; G91 X10. K2; G80; G90;"), "sinumerik"),
              blocks(fanuc("G81 Z-5. R2.; G91 X10.; X10.; G80; G90;"), "sinumerik"));
    // With a point it is the centre of an arc.
    const std::string arc = fanuc("G81 Z-5. R2.; G80; G18 G02 X10. Z50. I5. K0.;");
    EXPECT_EQ(run(arc, options_of(arc, "fanuc")).all_messages(), "");
    struct Row {
        const char* statements;
        const char* message;
    };
    for (const Row& row :
         {Row{"G81 X10. Z-5. R2. K0;", "6:19 K4128"}, Row{"G81 Z-5. R2. K3;", "6:14 K4128"},
          Row{"G81 Z-5. R2.; G80; G01; G91 X10. F100; Y5. K3;", "6:40 K4128"}}) {
        SCOPED_TRACE(row.statements);
        const std::string source = fanuc(row.statements);
        const std::string messages = run(source, options_of(source, "fanuc")).all_messages();
        EXPECT_EQ(messages.substr(0, messages.find(' ', 6)), row.message) << messages;
    }
}

TEST(SourceCycles, ThreadsOfTheControl) {
    const std::string source =
        "dialect sinumerik;\nprogram p() {\nG18; DIAMON; S500 M3;\nG0 X50 Z5;\nF100;\n"
        "CYCLE97(1.5,,0,-30,40,40,3,2,0.92,0.05,29,0,5,2,1,1);\n}";
    const Outcome outcome = run(source, options_of(source, "sinumerik"));
    EXPECT_EQ(outcome.all_messages(), "");
    EXPECT_NE(outcome.all_blocks().find("cycle#"), std::string::npos) << outcome.all_blocks();
    const Outcome moves = run(source, options_of(source, "iso"));
    EXPECT_NE(moves.all_blocks().find("thread Z-32"), std::string::npos) << moves.all_blocks();
}

TEST(SourceCycles, CallsOfTheControl) {
    const std::string once = sinumerik("length d = 5; CYCLE81(50,1,1.5,-d); X10;");
    EXPECT_EQ(blocks(once, "fanuc"), "cycle#0(0=-5, 1=2.5, 2=50, 3=0)\nrapid X10");
    EXPECT_EQ(blocks(sinumerik("CYCLE84(50,2,,-5,,0.1,5,,-0.05in,0,500,0);"), "fanuc"),
              "cycle#3(0=-5, 1=1.27, 2=2, 3=50, 4=0.1, 5=1, 6=0, 7=500, 8=0, 9=5)");
}

TEST(SourceCycles, CallsThatOnlyTheirControlKnows) {
    // Clearance, first depth, kind of machining: what drill_peck cannot say is made of moves.
    // Strokes of 5, 3 and 2 mm; when less than two of 2 are left, two share the rest.
    EXPECT_EQ(blocks(sinumerik("CYCLE83(50,0,2,-15,,-5,,2,0,0,1,1);"), "fanuc"),
              "rapid Z2\nline Z-5\nrapid Z2\nrapid Z-4.4\nline Z-8\nrapid Z2\nrapid Z-7.4\n"
              "line Z-10\nrapid Z2\nrapid Z-9.4\nline Z-12\nrapid Z2\nrapid Z-11.4\n"
              "line Z-13.5\nrapid Z2\nrapid Z-12.9\nline Z-15\nrapid Z50");
    // The tool comes out of a reamed hole to its own retract level at feed.
    EXPECT_EQ(blocks(sinumerik("CYCLE85(20,0,2,-10,,0.5,100,300);"), "iso"),
              "rapid Z2\nline Z-10 F100\ndwell(time=0.5)\nline Z2 F300\nF100\nrapid Z20");
    EXPECT_EQ(blocks(sinumerik("CYCLE87(50,0,2,-10,,3);"), "iso"),
              "rapid Z2\nspindle_cw\nline Z-10\nspindle_stop\nstop\nrapid Z50");
}

TEST(SourceCycles, ModalCallsBehindEveryMotion) {
    const std::string source =
        sinumerik("MCALL CYCLE81(50,2,,-5); G1 X10; M8; G91 Y5; G90; MCALL; X20;");
    EXPECT_EQ(blocks(source, "fanuc"),
              "line X10\ncycle#0(0=-5, 1=2, 2=50, 3=0)\ncoolant_flood\nline Y5 | incremental\n"
              "absolute\ncycle#0(0=-5, 1=2, 2=50, 3=0)\nincremental\nabsolute\nline X20");
    // A new call takes the place of the one before.
    EXPECT_EQ(blocks(sinumerik("MCALL CYCLE81(50,2,,-5); MCALL CYCLE81(50,2,,-6); X10;"), "fanuc"),
              "X10\ncycle#0(0=-6, 1=2, 2=50, 3=0)");
}

TEST(SourceCycles, TheLibraryHasNoNamesInTheProgram) {
    const std::string source = fanuc("G81 Z-5. R2.; G80; drill(to: -5mm);");
    const Outcome outcome = run(source, options_of(source, "fanuc"));
    EXPECT_EQ(outcome.all_messages(), "6:20 K2002 there is no function, cycle or command `drill`");
}

// Where it was called is said behind the expander, of the library's calls among themselves as well.
TEST(SourceCycles, ContractsAreTheLibrarys) {
    const std::string source = fanuc("G81 X5. Z10. R2.;");
    const Outcome outcome = run(source, options_of(source, "fanuc"));
    ASSERT_EQ(outcome.messages.size(), 1u);
    EXPECT_TRUE(outcome.messages[0].ends_with("K3301"));
}

}  // namespace
}  // namespace kadr::testing::source_cycles_test
