// Whether X is a diameter: who says it, when the text says it again, what it does to X itself.
#include <gtest/gtest.h>

#include "tests/sema/running.h"

namespace kadr::testing::diameter_test {
namespace {

struct Row {
    const char* source;
    const char* blocks;
    const char* message = "";
};

void expect_rows(std::initializer_list<Row> rows, const RunOptions& options = {}) {
    for (const Row& row : rows) {
        SCOPED_TRACE(row.source);
        const Outcome outcome = run(row.source, options);
        EXPECT_EQ(outcome.all_messages(), row.message);
        EXPECT_EQ(outcome.all_blocks(), row.blocks);
    }
}

TEST(Diameter, ACycleWrittenForItMakesTheProgramOne) {
    expect_rows({
        {"cycle c() preserves DIAMON { G1 X10; }\nprogram p() { F100; G0 X50; c(); }",
         "F100\nrapid X50 | diameter_on\nline X10"},
        // With the first state that is set, however deep the cycle is called.
        {"cycle c() preserves DIAMON { G1 X10; }\nvoid f() { c(); }\n"
         "program p() { F100; G18; G0 X50; f(); }",
         "F100\nplane_zx | diameter_on\nrapid X50\nline X10"},
        // In a block that may be left out it would be the operator's choice.
        {"cycle c() preserves DIAMON { G1 X10; }\nprogram p() { F100; /G0 X50; c(); }",
         "F100\ndiameter_on\n/0 rapid X50\nline X10"},
        // The program's own word counts, where it stands.
        {"cycle c() preserves DIAMON { G1 X10; }\nprogram p() { F100; DIAMON; G0 X50; c(); }",
         "F100\ndiameter_on\nrapid X50\nline X10"},
        {"cycle c() preserves DIAMON { G1 X10; }\n"
         "program p() { F100; DIAMOF; G0 X25; with DIAMON { c(); } X5; }",
         "F100\ndiameter_off\nrapid X25\ndiameter_on\nline X10\ndiameter_off\nX5"},
        // A contour of diameters, too; what is followed is in the words of the program.
        {"program p() { F100; G18; contour c = { DIAMON; G1 X20 Z0; Z-5; }; G0 X20 Z0; follow(c); "
         "}",
         "F100\nplane_zx | diameter_on\nrapid X20 Z0\nline X20 Z-5"},
        {"program p() { F100; G18 DIAMOF; contour c = { DIAMON; G1 X20 Z0; Z-5; }; G0 X10 Z0; "
         "follow(c); }",
         "F100\nplane_zx | diameter_off\nrapid X10 Z0\nline X10 Z-5"},
        {"program p() { F100; G18 DIAMON; contour c = { DIAMOF; G1 X20 Z0; Z-5; }; G0 X40 Z0; "
         "follow(c); }",
         "F100\nplane_zx | diameter_on\nrapid X40 Z0\nline X40 Z-5"},
        // Where nothing turns, nothing is said.
        {"program p() { G0 X1; }", "rapid X1"},
    });
}

TEST(Diameter, OfAControlWhereXAlwaysIsOne) {
    RunOptions options;
    options.source = "fanuc-lathe";
    expect_rows(
        {{"program p() { G0 X50. Z2.; }", "work_offset(number=1)\nrapid X50 Z2 | diameter_on"}},
        options);
}

TEST(Diameter, IsSaidAgainWhereItMayBeLost) {
    expect_rows({
        {"program p() { DIAMON; raw \"M55\"; G90 G0 X10; }",
         "diameter_on\nraw \"M55\"\nrapid X10 | absolute | diameter_on"},
        {"program p() { /DIAMON; G0 X10; }", "/0 | diameter_on\nrapid X10 | diameter_on"},
        {"program p() { raw \"M55\"; G90 G0 X10; }", "raw \"M55\"\nrapid X10 | absolute"},
    });
}

TEST(Diameter, TheToolStaysWhereItIs) {
    expect_rows({
        {"program p() { DIAMOF; G0 X10; DIAMON; note \"{position.x}\"; }",
         "diameter_off\nrapid X10\ndiameter_on\ncomment \"20\""},
        {"program p() { DIAMON; G0 X10; DIAMOF; note \"{position.x}\"; DIAMOF; X+=1; }",
         "diameter_on\nrapid X10\ndiameter_off\ncomment \"5\"\ndiameter_off\nX=IC(1)"},
    });
}

// Frames have radii in the language; a FANUC takes them as what X is.
TEST(Diameter, FramesHaveRadii) {
    const char* const source =
        "program p() { DIAMON; G0 X50; with shift(x: 3mm) { note \"{position.x}\"; X40; } }";
    expect_rows({{source, "diameter_on\nrapid X50\nshift(x=3)\ncomment \"44\"\nX40\nshift"}});
    RunOptions options;
    options.target = "fanuc-lathe";
    expect_rows(
        {{source, "diameter_on\nrapid X50\nshift(x=6)\ncomment \"44\"\nX40\nshift"},
         {"program p() { DIAMON; TRANS X3; ATRANS X1; G0 X40; }",
          "diameter_on\nshift(x=6)\nshift(x=8)\nrapid X40"},
         {"program p() { TRANS X3; G0 X40; }", "shift(x=6)\nrapid X40"},
         {"program p() { DIAMOF; TRANS X3; G0 X40; }", "diameter_off\nshift(x=3)\nrapid X40"}},
        options);
    options.source = "fanuc-lathe";
    options.target = "iso";
    expect_rows({{"program p() { G0 X50. Z2.; G52 X6. Z-1.; X40.; G52 X0. Z0.; }",
                  "work_offset(number=1)\nrapid X50 Z2 | diameter_on\nshift(x=3, z=-1)\nX40\n"
                  "shift(x=0, z=0)"}},
                options);
}

TEST(Diameter, ACycleIsNotCalledInRadii) {
    expect_rows({{"cycle c() preserves DIAMON { G1 X10; }\nprogram p() { F100; DIAMOF; c(); }",
                  "F100\ndiameter_off", "2:29 K3206 `c` needs DIAMON, but DIAMOF is active"}});
}

TEST(Diameter, TurningWithoutAWordOfItIsWarnedOf) {
    RunOptions options;
    options.expand.warns_of_cuts = true;
    expect_rows(
        {
            {"program p() { G95 F0.2; G96 S180 M3; G0 X40; G96 S200; }",
             "F0.2 | feed_per_revolution\nS180 | cutting_speed_on | spindle_cw\nrapid X40\n"
             "S200 | cutting_speed_on",
             "1:25 K3218 a part is turned, and nothing says whether X is a diameter"},
            {"program p() { S500 M3; G0 X40 Z2; G33 Z-20 K1.5; }",
             "S500 | spindle_cw\nrapid X40 Z2\nthread Z-20 K1.5",
             "1:35 K3218 a part is turned, and nothing says whether X is a diameter"},
            {"program p() { DIAMOF; G95 F0.2; G96 S180 M3; G0 X40; }",
             "diameter_off\nF0.2 | feed_per_revolution\nS180 | cutting_speed_on | spindle_cw\n"
             "rapid X40"},
        },
        options);
    // A control without a word for it is not helped by the warning.
    options.target = "fanuc-lathe";
    expect_rows({{"program p() { G95 F0.2; G96 S180 M3; G0 X40; }",
                  "F0.2 | feed_per_revolution\nS180 | cutting_speed_on | spindle_cw\nrapid X40"}},
                options);
}

}  // namespace
}  // namespace kadr::testing::diameter_test
