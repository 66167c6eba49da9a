// What is not known: behind raw text, behind a block that may be left out, behind the end.
#include <gtest/gtest.h>

#include "tests/sema/running.h"

namespace kadr::testing::unknown_test {
namespace {

struct Row {
    std::string source;
    std::string blocks;
    std::string messages = "";
};

void expect_rows(std::initializer_list<Row> rows) {
    for (const Row& row : rows) {
        SCOPED_TRACE(row.source);
        const Outcome outcome = run(row.source);
        EXPECT_EQ(outcome.all_messages(), row.messages);
        EXPECT_EQ(outcome.all_blocks(), row.blocks);
    }
}

TEST(Unknown, RawTextMakesAllOfTheStateUnknown) {
    expect_rows({
        {"program p() { G0 X1; raw \"G91\"; X5; }", "rapid X1\nraw \"G91\"",
         "1:33 K3212 whether coordinates are absolute is not known here"},
        {"program p() { raw \"A\"; G90; X5; }", "raw \"A\"\nabsolute",
         "1:29 K3212 the motion is not known here"},
        {"program p() { raw \"A\"; G0 X+=5 Y=IC(2) Z=AC(3); }",
         "raw \"A\"\nrapid X=IC(5) Y=IC(2) Z=AC(3)"},
        {"program p() { F100; raw \"G18\"; G90 G2 X5 Y6 CR=10 F100; }", "F100\nraw \"G18\"",
         "1:51 K3212 what F means is not known here"},
        {"program p() { raw \"G18\"; G90 G94 G2 X5 Y6 CR=10 F100; }", "raw \"G18\"",
         "1:26 K3212 the plane is not known here"},
        {"program p() { raw \"A\"; G41; }", "raw \"A\"", "1:24 K3212 the plane is not known here"},
        {"program p() { F100; raw \"G95\"; G90 G1 X5; }", "F100\nraw \"G95\"",
         "1:32 K3212 the feed is not known here"},
        {"program p() { raw \"G95\"; G90 G1 X5 F200; }", "raw \"G95\"",
         "1:36 K3212 what F means is not known here"},
        {"program p() { raw \"G96\"; S1000 M3; }", "raw \"G96\"",
         "1:26 K3212 what S means is not known here"},
        {"program p() { raw \"A\"; with shift(x: 5mm) { G90 G0 X1; } }", "raw \"A\"",
         "1:29 K3212 the frame is not known here"},
        {"program p() { raw \"A\"; mirror(x: true); }", "raw \"A\"",
         "1:24 K3212 the frame is not known here"},
        {"program p() { tool(3); raw \"A\"; note \"{state.tool ?? 7}\"; }",
         "tool(tool=3)\nraw \"A\"\ncomment \"7\""},
        {"program p() { G0; raw \"A\"; contour c = { G1 X0 Y0; X5; }; G90; follow(c, feed: 5mm/s); "
         "}",
         "rapid\nraw \"A\"", "1:42 K3212 the plane is not known here"},
        // All of it said again.
        {"program p() { raw \"A\"; shift(); G17 G90 G94 G97; S500 M3; G0 X1; G1 X2 F100; "
         "with shift(x: 5mm) { X3; } }",
         "raw \"A\"\nshift\nplane_xy | absolute | feed_per_minute | cutting_speed_off\n"
         "S500 | spindle_cw\nrapid X1\nline X2 F100\nshift(x=5)\nX3\nshift"},
    });
    const Outcome outcome = run("program p() { G0 X1;\nraw \"G91\";\nX5; }");
    EXPECT_EQ(outcome.notes, std::vector<std::string>{"2:1 nobody knows what this text changes"});
}

TEST(Unknown, WithSetsBackOnlyWhatWasKnown) {
    expect_rows({
        {"program p() { F100; raw \"A\"; G90 G94; with F50 { G1 X3; } G1 X4; }",
         "F100\nraw \"A\"\nabsolute | feed_per_minute\nF50\nline X3",
         "1:57 K3203 what was active in the group `F` before is not known, so it cannot be set "
         "back"},
        {"program p() { G0 X1; raw \"G91\"; with G91 { X+=3; } }",
         "rapid X1\nraw \"G91\"\nincremental", "1:44 K3212 the motion is not known here"},
        {"program p() { G0 X1; raw \"G91\"; with G91 { G0 X3; } X7; }",
         "rapid X1\nraw \"G91\"\nincremental\nrapid X3",
         "1:51 K3203 what was active in the group `distance` before is not known, so it cannot be "
         "set back"},
        // The offset of the text's head acts where the program has said none.
        {"program p() { G0 X0; with G55 { G0 X1; } G0 X2; }",
         "rapid X0\nwork_offset(number=2)\nrapid X1\nwork_offset(number=1)\nrapid X2"},
        // What the text inside may have changed is set back as well.
        {"program p() { with G91 { raw \"A\"; } G0 X1; }",
         "incremental\nraw \"A\"\nabsolute\nrapid X1"},
        {"program p() { with shift(x: 5mm) { raw \"A\"; } }", "shift(x=5)\nraw \"A\"\nshift"},
        {"program p() { with shift(x: 5mm) { with shift(y: 2mm) { raw \"A\"; } } }",
         "shift(x=5)\nshift(x=5, y=2)\nraw \"A\"\nshift(x=5, y=0, z=0)\nshift"},
        // No F before: none behind it.
        {"program p() { with F50 { G1 X3; } X4; }", "F50\nline X3",
         "1:35 K3212 the feed is not known here"},
        {"program p() { with F50 { G1 X3; } G0 X4; G1 X5 F60; X6; }",
         "F50\nline X3\nrapid X4\nline X5 F60\nX6"},
    });
}

TEST(Unknown, PromisesAreKeptBehindRawText) {
    expect_rows({
        {"cycle c() preserves G90 { raw \"G91\"; }\nprogram p() { G90; c(); G0 X5; }",
         "absolute\nraw \"G91\"\nabsolute\nrapid X5"},
        // In a function that it calls; what was said again in between stays.
        {"void f() { raw \"A\"; G90; }\ncycle c() preserves G90, G17 { f(); }\n"
         "program p() { c(); G0 X5; }",
         "raw \"A\"\nabsolute\nplane_xy\nrapid X5"},
        {"cycle c() preserves F1 { raw \"A\"; }\nprogram p() { F100; c(); }",
         "F100\nraw \"A\"\nF100"},
        {"cycle c() preserves frames { raw \"A\"; }\nprogram p() { with shift(x: 5mm) { c(); } }",
         "shift(x=5)\nraw \"A\"\nshift(x=5, y=0, z=0)\nshift"},
        {"cycle c() preserves G54 { raw \"A\"; }\nprogram p() { c(); }", "raw \"A\"",
         "1:36 K3203 what was active in the group `work_offsets` before is not known, so it cannot "
         "be set back"},
        // What a cycle needs must be known where it is called.
        {"cycle c() preserves G90 { G0 X1; }\nprogram p() { raw \"A\"; c(); }", "raw \"A\"",
         "2:24 K3212 whether `G90` acts, as `c` needs, is not known here"},
    });
}

TEST(Unknown, WhatASkippedBlockSetsIsSaidAgain) {
    expect_rows({
        {"program p() { F100; /F20; G0 X0; G1 X10; X20; }",
         "F100\n/0 F20\nrapid X0\nline X10 F20\nX20"},
        {"program p() { /F20; F30; G1 X10; }", "/0 F20\nF30\nline X10"},
        {"program p() { F100; /G95 F0.1; G1 X20; }",
         "F100\n/0 F0.1 | feed_per_revolution\nline X20 F0.1 | feed_per_revolution"},
        {"program p() { F100; G1 X1; /G95; X20; }", "F100\nline X1\n/0 | feed_per_revolution",
         "1:34 K3212 the feed is not known here"},
        {"program p() { S100 M3; F1; /S500; G1 X1; X2; }",
         "S100 | spindle_cw\nF1\n/0 S500\nline X1 S500\nX2"},
        // In blocks that may be left out as well, until one that may not.
        {"program p() { F100; G1; /F20; /X1; X2; X3; }",
         "F100\nline\n/0 F20\n/0 X1 F20\nX2 F20\nX3"},
        // The coolant is the operator's choice; so is the spindle, but a cut needs it.
        {"program p() { F1; /M8; G1 X1; }", "F1\n/0 | coolant_flood\nline X1"},
        {"program p() { F1; M3; /M5; G0 X0; G1 X1; X2; }",
         "F1\nspindle_cw\n/0 | spindle_stop\nrapid X0\nline X1\nX2",
         "1:35 K3214 whether the spindle turns at this cut is the operator's choice"},
        {"program p() { F1; /M5; M3; G1 X1; }", "F1\n/0 | spindle_stop\nspindle_cw\nline X1"},
    });
}

TEST(Unknown, CompensationIsLeftOutWholeOrNotAtAll) {
    const std::string head = "program p() { F1; tool(1); S1 M3; G0 X0 Y0; G1; ";
    const auto messages = [&](const std::string& blocks) {
        return run(head + blocks + " }").all_messages();
    };
    const std::string doubt =
        " K3250 whether the cutter's radius is compensated here is the "
        "operator's choice";
    EXPECT_EQ(messages("/G41 X1; /X2; /G40 X3; X4;"), "");
    EXPECT_EQ(messages("G41 X1; X2; /G40 X3; /G41 X4; X5; G40 X6;"), "");
    EXPECT_EQ(messages("/G41; G40; X1;"), "");     // said before anything needs it
    EXPECT_EQ(messages("/G41; Z1; G40 X1;"), "");  // nothing goes in the plane
    EXPECT_EQ(messages("/G41; X1;"), "1:55" + doubt);
    EXPECT_EQ(messages("/1 G41 X1; /2 X2; /1 G40 X3;"), "1:60" + doubt);
    EXPECT_EQ(messages("G41 X1; X2; /G42; X3; G40 X4;"), "1:67" + doubt);
    EXPECT_EQ(messages("G18; /G41; Y1; G40 X1;"), "");
    EXPECT_EQ(messages("/G41 X1; G18; G40 X1;"), "1:58" + doubt);
    EXPECT_EQ(messages("G18; /G41; Z1;"), "1:60" + doubt);
}

TEST(Unknown, NothingIsExecutedBehindTheEnd) {
    expect_rows({
        {"program p() { G0 X1; M30; G0 X2; G0 X3; }", "rapid X1\nend_rewind\nrapid X2\nrapid X3",
         "1:27 K3216 a block behind the end of the program"},
        {"void f() { M2; }\nprogram p() { f(); G0 X1; }", "end\nrapid X1",
         "2:20 K3216 a block behind the end of the program"},
        {"program p() { M30; raw \"O2\"; G90 G0 X1; M30; }",
         "end_rewind\nraw \"O2\"\nrapid X1 | absolute\nend_rewind"},
        {"program p() { /M30; G0 X1; M30; }", "/0 | end_rewind\nrapid X1\nend_rewind"},
    });
}

TEST(Unknown, MovesThatNoControlMakes) {
    expect_rows({
        {"program p() { G0 X10 Y0; F100; G2 X10 Y0 I0 J0; }", "rapid X10 Y0\nF100",
         "1:32 K3215 the arc has no radius: its center is its start"},
        {"program p() { G0 X0 Y0; F1; G2 I=AC(0) J=AC(0); }", "rapid X0 Y0\nF1",
         "1:29 K3215 the arc has no radius: its center is its start"},
        {"program p() { F1; G3 X1 CR=0; }", "F1",
         "1:19 K3215 the arc has no radius: its center is its start"},
        {"program p() { G1 X10 F0; }", "", "1:22 K3213 a feed of 0 mm/min"},
        {"program p(real f = -5) { G1 X10 F=f; }", "", "1:33 K3213 a feed of -5 mm/min"},
        {"program p() { point z; G0 z; }", "", "1:24 K3104 `the target` is not given"},
    });
}

TEST(Unknown, CoordinatesOfOnePointOnly) {
    expect_rows({
        {"program p() { point base = {10mm, 20mm}; G0 base + {z: 5mm}; }", "",
         "1:45 K3104 `{z: 5mm}.x` is not given"},
        {"program p() { point q = {1mm, 2mm, 3mm}; G0 q - {1mm, 1mm}; }", "",
         "1:45 K3104 `{1mm, 1mm}.z` is not given"},
        {"program p() { point q = {1mm, 2mm}; q = q + {1mm, 1mm, 1mm}; }", "",
         "1:41 K3104 `q.z` is not given"},
        {"program p() { point q = {1mm, 2mm}; point d = {1mm, 1mm}; q += d; G0 q; }",
         "rapid X2 Y3"},
        {"program p() { G0 X=distance({0mm, 0mm}, {z: 5mm}); }", "",
         "1:20 K3104 `{z: 5mm}.x` is not given"},
        {"program p() { G0 X=distance({1mm, 2mm, 3mm}, {1mm, 2mm}); }", "",
         "1:20 K3104 `{1mm, 2mm}.z` is not given"},
        {"program p() { point a; point b; G0 X=distance(a, b); }", "",
         "1:38 K3104 `a` is not given"},
        {"program p() { G0 X=distance({y: 1mm}, {y: 3mm}); }", "rapid X2"},
    });
}

}  // namespace
}  // namespace kadr::testing::unknown_test
