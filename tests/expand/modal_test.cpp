// Modal state: what `with` sets back, what `preserves` promises, frames, the position.
#include <gtest/gtest.h>

#include "tests/sema/running.h"

namespace kadr::testing::modal_test {
namespace {

struct Row {
    const char* source;
    const char* blocks;
};

void expect_rows(std::initializer_list<Row> rows) {
    for (const Row& row : rows) {
        SCOPED_TRACE(row.source);
        const Outcome outcome = run(row.source);
        EXPECT_EQ(outcome.all_messages(), "");
        EXPECT_EQ(outcome.all_blocks(), row.blocks);
    }
}

/// What a block that may be left out says is in doubt behind it only where it changes something.
TEST(Modal, KnowsWhatHoldsWithAndWithoutABlock) {
    expect_rows({
        {"program p() { G0 X1; / X1; X=position.x + 1mm; }", "rapid X1\n/0 X1\nX2"},
        // Data of a zero point move it along the axes that they name.
        {"program p() { G54; G0 X1 Y2; work_offset_data(number: 1, x: 5mm); Y=position.y + 1mm; }",
         "work_offset(number=1)\nrapid X1 Y2\nwork_offset_data(number=1, x=5)\nY3"},
        {"program p() { G1 X1 F100; / F100; X2; / F200; X3; }",
         "line X1 F100\n/0 F100\nX2\n/0 F200\nX3 F200"},
    });
}

TEST(Modal, WithSetsBackOnEveryWayOut) {
    expect_rows({
        {"program p() { with G91 { X1; } X2; }", "incremental\nX1\nabsolute\nX2"},
        {"program p() { G91; with G91 { X1; } X2; }", "incremental\nincremental\nX1\nX2"},
        {"program p() { with G91 { with G90 { X1; } X2; } }",
         "incremental\nabsolute\nX1\nincremental\nX2\nabsolute"},
        {"program p() { for (int i = 0; i < 3; i++) { with G91 { if (i == 0) continue; if (i == 1) "
         "break; X=i; } } X9; }",
         "incremental\nabsolute\nincremental\nabsolute\nX9"},
        {"cycle c(int n) { with G91 { with G18 { if (n > 0) return; X1; } } }\nprogram p() { c(1); "
         "X2; }",
         "incremental\nplane_zx\nplane_xy\nabsolute\nX2"},
        {"int f() { with G91 { return 3; } }\nprogram p() { X=f(); }", "incremental\nabsolute\nX3"},
        // F goes back with the feed mode, and by itself.
        {"program p() { F180; with G95, F0.1 { G1 X1; } X2; }",
         "F180\nF0.1 | feed_per_revolution\nline X1\nF180 | feed_per_minute\nX2"},
        {"program p() { F180; with F50 { G1 X1; } X2; }", "F180\nF50\nline X1\nF180\nX2"},
        {"program p() { G54; with G55 { X1; } }",
         "work_offset(number=1)\nwork_offset(number=2)\nX1\nwork_offset(number=1)"},
        {"program p() { G54; with work_offset(2) { X1; } }",
         "work_offset(number=1)\nwork_offset(number=2)\nX1\nwork_offset(number=1)"},
        {"program p() { with plane_zx() shift(x: 1) { X1; } }",
         "plane_zx\nshift(x=1)\nX1\nshift\nplane_xy"},
        {"program p() { with G43 H3 { Z1; } }", "length_comp_on(offset=3)\nZ1\nlength_comp_off"},
        {"program p() { G0; with G1 { X1; } X2; }", "rapid\nline\nX1\nrapid\nX2"},
    });
}

TEST(Modal, FramesComposeAndEnd) {
    expect_rows({
        {"program p() { with shift(x: 60mm, y: 40mm) { X1; } X2; }",
         "shift(x=60, y=40)\nX1\nshift\nX2"},
        {"program p() { with shift(x: 10) { with shift(x: 5, y: 1) { X1; } X2; } }",
         "shift(x=10)\nshift(x=15, y=1)\nX1\nshift(x=10, y=0)\nX2\nshift"},
        {"program p() { with shift(x: 10) rotate(90deg) { X1; } }",
         "shift(x=10)\nrotate(angle=90)\nX1\nshift"},
        // A shift inside a rotation moves along the turned axes.
        {"program p() { with rotate(90deg) { with shift(x: 5) { X1; } } }",
         "rotate(angle=90)\nshift(x=0, y=5)\nrotate(angle=90)\nX1\nshift\n"
         "rotate(angle=90)\nshift"},
        {"program p() { with mirror(x: 0) { with shift(x: 5) { X1; } } }",
         "mirror(x=0)\nshift(x=-5)\nmirror(x=0)\nX1\nshift\nmirror(x=0)\nshift"},
        // Mirrors before rotations, as every control takes them; one axis of the plane mirrored
        // turns the sense, two do not.
        {"program p() { with rotate(30deg) mirror(x: 0) { X1; } }",
         "rotate(angle=30)\nshift\nmirror(x=0)\nrotate(angle=-30)\nX1\nshift"},
        {"program p() { with mirror(x: 0) rotate(30deg) { X1; } }",
         "mirror(x=0)\nrotate(angle=30)\nX1\nshift"},
        {"program p() { with rotate(30deg) { with mirror(x: 0, y: 0) { X1; } } }",
         "rotate(angle=30)\nshift\nmirror(x=0, y=0)\nrotate(angle=30)\nX1\nshift\n"
         "rotate(angle=30)\nshift"},
        {"program p() { with shift(x: 1) { with rotate(30deg) { with rotate(15deg) { X1; } } } }",
         "shift(x=1)\nrotate(angle=30)\nshift(x=1)\nrotate(angle=45)\nX1\nshift(x=1)\n"
         "rotate(angle=30)\nshift(x=1)\nshift"},
    });
}

TEST(Modal, PositionIsThatOfTheProgrammedFrame) {
    expect_rows({
        {"program p() { G0 X10 Y20 Z5; note \"{position.x} {position.y} {position.z}\"; }",
         "rapid X10 Y20 Z5\ncomment \"10 20 5\""},
        {"program p() { G0 X10; X+=5; with G91 { X1; } note \"{position.x}\"; }",
         "rapid X10\nX=IC(5)\nincremental\nX1\nabsolute\ncomment \"16\""},
        {"program p() { G0 X10 Y0; with shift(x: 4mm) { note \"{position.x}\"; X1; } note "
         "\"{position.x}\"; }",
         "rapid X10 Y0\nshift(x=4)\ncomment \"6\"\nX1\nshift\ncomment \"5\""},
        {"program p() { G0 X10 Y0; with rotate(90deg) { note \"{position.x:.3} {position.y:.3}\"; "
         "} }",
         "rapid X10 Y0\nrotate(angle=90)\ncomment \"0.000 -10.000\"\nshift"},
        {"program p() { G92 X3; note \"{position.x} {position.y ?? 7mm}\"; }",
         "set_position(x=3)\ncomment \"3 7\""},
        {"program p() { G0 Z5; tool(1); if (!given position.z) note \"lost\"; }",
         "rapid Z5\ntool(tool=1)\ncomment \"lost\""},
        {"program p() { G0 A30; note \"{position.a}\"; }", "rapid A30\ncomment \"30\""},
        {"program p() { F180; S2000; T4; note \"{state.feed} {state.speed} {state.tool}\"; "
         "note \"{120mm/min/state.feed:.3}\"; }",
         "F180\nS2000\ntool_select(tool=4)\ncomment \"180 2000 4\"\ncomment \"0.667\""},
    });
}

TEST(Modal, PreservesIsHeldToItsPromise) {
    struct Wrong {
        const char* source;
        const char* message;
    };
    const Wrong rows[] = {
        {"cycle c() preserves G90 { G91; X5; }\nprogram p() { c(); }", "1:27 K2308"},
        {"cycle c(int n) preserves G90, G17 {\nG91;\nif (n > 0) return;\nG90;\n}\nprogram p() { "
         "c(1); }",
         "2:1 K2308"},
        {"cycle c() preserves G17 { for (int i = 0; i < 3; i++) { G18; } }\nprogram p() { c(); }",
         "1:57 K2308"},
        {"void turn() { G18; }\ncycle c() preserves G17 { turn(); }\nprogram p() { c(); }",
         "2:27 K2308"},
        {"cycle c() preserves frames { shift(x: 5mm); X1; }\nprogram p() { c(); }", "1:30 K2308"},
        // Who called it had another plane: seen only while it runs.
        {"cycle c() preserves G54 { G55; }\nprogram p() { G54; c(); }", "1:32 K3205"},
        {"cycle c() preserves G90, F { F50; G1 X1; }\nprogram p() { F180; c(); }", "1:42 K3205"},
        {"cycle c() preserves S { S50; }\nprogram p() { S180; c(); }", "1:30 K3205"},
        {"cycle c() preserves G17 { G18; G17; }\nprogram p() { G19; c(); }", "2:20 K3206"},
        {"cycle c() preserves G90, G17 { G0 X1; }\nprogram p() { with G91 { c(); } }",
         "2:26 K3206"},
    };
    for (const Wrong& row : rows) {
        SCOPED_TRACE(row.source);
        EXPECT_EQ(run(row.source).messages, std::vector<std::string>{row.message});
    }
    expect_rows({
        {"cycle c() preserves G90 { with G91 { X5; } }\nprogram p() { c(); }",
         "incremental\nX5\nabsolute"},
        {"cycle c() preserves G90 { G91; X5; G90; }\nprogram p() { c(); }",
         "incremental\nX5\nabsolute"},
        {"cycle c(int n) preserves G90 { with G91 { if (n > 0) return; X5; } }\nprogram p() { "
         "c(1); }",
         "incremental\nabsolute"},
        {"cycle c() preserves frames { with shift(x: 5mm) { X1; } }\nprogram p() { c(); }",
         "shift(x=5)\nX1\nshift"},
        {"void turn() { with G18 { X1; } }\ncycle c() preserves G17 { turn(); }\nprogram p() { "
         "c(); }",
         "plane_zx\nX1\nplane_xy"},
    });
}

}  // namespace
}  // namespace kadr::testing::modal_test
