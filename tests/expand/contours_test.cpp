// Contours of programs: blocks kept as a value, what is asked of them, the blocks they become.
#include <gtest/gtest.h>

#include "tests/sema/running.h"

namespace kadr::testing::contours_test {
namespace {

struct Row {
    const char* source;
    const char* blocks;
};

void expect_rows(std::initializer_list<Row> rows) {
    for (const Row& row : rows) {
        SCOPED_TRACE(row.source);
        const Outcome outcome = run_body(row.source);
        EXPECT_EQ(outcome.all_messages(), "");
        for (const std::string& text : outcome.texts) EXPECT_EQ(text, "");
        EXPECT_EQ(outcome.all_blocks(), row.blocks);
    }
}

TEST(Contours, BlocksAreKept) {
    expect_rows({
        {"contour c = { G1 X0 Y0; X60; G3 X60 Y40 CR=20; G1 X0; close; }; follow(c);",
         "line X0 Y0\nline X60 Y0\narc_ccw X60 Y40 I0 J20\nline X0 Y40\nline X0 Y0"},
        // Values are those of the moment when it is made.
        {"length w = 10mm; contour c = { G1 X0 Y0; X=w; }; w = 20mm; follow(c);",
         "line X0 Y0\nline X10 Y0"},
        // Loops and conditions stand in the braces as everywhere.
        {"contour c = { G1 X0 Y0; for (int i = 1; i < 4; i++) { if (i != 2) X=i*10; } }; "
         "follow(c);",
         "line X0 Y0\nline X10 Y0\nline X30 Y0"},
        {"contour c = { G0 X5 Y5; X10; }; follow(c);", "line X5 Y5\nline X10 Y5"},
        {"contour c = { G90 G1 X0 Y0; with G91 { X10; Y5; } X0; }; follow(c);",
         "line X0 Y0\nline X10 Y0\nline X10 Y5\nline X0 Y5"},
        {"contour c = { G1 X10 Y0; G3 I-10; }; follow(c);", "line X10 Y0\narc_ccw X10 Y0 I-10 J0"},
        {"contour c = { G1 X10 Y0; G2 X0 Y-10 I=AC(0) J=AC(0); }; follow(c);",
         "line X10 Y0\narc_cw X0 Y-10 I-10 J0"},
        {"point p = {3mm, 4mm}; contour c = { G1 X0 Y0; G1 p; X+=2mm; }; follow(c);",
         "line X0 Y0\nline X3 Y4\nline X5 Y4"},
        // A contour in a contour goes on with it.
        {"contour a = { G1 X0 Y0; X10; }; contour b = { follow(a); Y5; close; }; follow(b);",
         "line X0 Y0\nline X10 Y0\nline X10 Y5\nline X0 Y0"},
        // What the blocks inside say does not act outside.
        {"G91; contour c = { G1 X0 Y0; G91 X10; Y5; }; X2; follow(c);",
         "incremental\nX2\nline X=AC(0) Y=AC(0)\nline X=AC(10) Y=AC(0)\nline X=AC(10) Y=AC(5)"},
        // Of the plane Z-X.
        {"G18; contour c = { G1 Z0 X10; Z-20; G2 Z-30 X20 CR=10; }; follow(c);",
         "plane_zx\nline X10 Z0\nline X10 Z-20\narc_cw X20 Z-30 I10 K0"},
    });
}

TEST(Contours, Follow) {
    expect_rows({
        // From where the tool stands: no way to the start if it is there.
        {"contour c = { G1 X0 Y0; X10; }; G0 X0 Y0; follow(c, feed: 300mm/min);",
         "rapid X0 Y0\nline X10 Y0 F300"},
        {"contour c = { G1 X0 Y0; X10; }; G95; follow(c, feed: 0.1mm/rev);",
         "feed_per_revolution\nline X0 Y0 F0.1\nline X10 Y0"},
        {"contour c = { G1 X0 Y0; X10; }; G91; follow(c);",
         "incremental\nline X=AC(0) Y=AC(0)\nline X=AC(10) Y=AC(0)"},
        // 2 mm beside: left of an anticlockwise square is inside.
        {"contour c = { G1 X0 Y0; X10; Y10; X0; close; }; follow(c, left: 2mm);",
         "line X2 Y2\nline X8 Y2\nline X8 Y8\nline X2 Y8\nline X2 Y2"},
        {"contour c = { G1 X0 Y0; X10; Y10; }; follow(c, right: 2mm);",
         "line X0 Y-2\nline X10 Y-2\narc_ccw X12 Y0 I0 J2\nline X12 Y10"},
        // The lead-in joins along the contour: 3 mm straight before, and behind.
        {"contour c = { G1 X0 Y0; X10; }; follow(c, lead_in: 3mm, lead_out: 4mm);",
         "line X-3 Y0\nline X0 Y0\nline X10 Y0\nline X14 Y0"},
        // A quarter circle of 2 mm on the left, before it 3 mm straight down.
        {"contour c = { G1 X0 Y0; X10; }; follow(c, left: 0mm, lead_in: 3mm, arc_in: 2mm, arc_out: "
         "1mm);",
         "line X-2 Y5\nline X-2 Y2\narc_ccw X0 Y0 I2 J0\nline X10 Y0\narc_ccw X11 Y1 I0 J1"},
        {"contour c = { G1 X0 Y0; X10; }; follow(c, right: 1mm, arc_in: 2mm);",
         "line X-2 Y-3\narc_cw X0 Y-1 I2 J0\nline X10 Y-1"},
        {"contour c = { G1 X0 Y0; X10; }; G0 follow_start(c, left: 0mm, arc_in: 2mm);",
         "rapid X-2 Y2"},
    });
}

TEST(Contours, Questions) {
    expect_rows({
        {"contour c = { G1 X0 Y0; X30; Y40; close; }; X=c.length Y=c.count Z=c.area/1mm;",
         "X120 Y3 Z600"},
        {"contour c = { G1 X0 Y0; X30; Y40; close; }; if (c.is_closed && !c.is_clockwise) G0 "
         "c.max;",
         "rapid X30 Y40"},
        {"contour c = { G1 X0 Y0; X30; Y40; close; }; G0 c.min; G0 c.start; G0 reverse(c)[0].to;",
         "rapid X0 Y0\nrapid X0 Y0\nrapid X30 Y40"},
        {"contour c = { G1 X10 Y0; G2 X0 Y-10 CR=10; }; element e = c[0]; X=e.center.x Y=e.radius "
         "Z=-e.sweep/1deg*1mm; if (e.is_arc) X=round(e.length/pi, 0.001mm);",
         "X0 Y10 Z90\nX5"},
        {"contour c = { G1 X0 Y0; X10; Y10; }; for (element e : c) G0 e.to;",
         "rapid X10 Y0\nrapid X10 Y10"},
        {"contour c = { G1 X0 Y0; X10; Y10; close; }; if (inside({8mm, 2mm}, c)) M8; if "
         "(!inside({2mm, "
         "8mm}, c)) M9;",
         "coolant_flood\ncoolant_off"},
        {"contour c = { G1 X0 Y0; X10; }; G0 nearest(c, {4mm, 3mm});", "rapid X4 Y0"},
        {"contour a = { G1 X0 Y0; X10; }; contour b = { G1 X5 Y-5; Y5; }; for (point p : "
         "intersections(a, b)) G0 p;",
         "rapid X5 Y0"},
        {"contour c; X=c.count;", "X0"},
    });
}

// X is a diameter in the words and points; arcs, lengths and distances are those of the part.
TEST(Contours, Diameters) {
    expect_rows({
        {"G18; contour c = { DIAMON; G1 X20 Z0; G3 X24 Z-2 K-2; G1 Z-5; }; follow(c);",
         "plane_zx | diameter_on\nline X20 Z0\narc_ccw X24 Z-2 I0 K-2\nline X24 Z-5"},
        // Outside on a lathe a rounding is G3, a fillet G2; in a bore the other way around.
        {"G18; contour c = { DIAMON; G1 X24 Z-5; G2 X30 Z-8 I3 K0; }; follow(c);",
         "plane_zx | diameter_on\nline X24 Z-5\narc_cw X30 Z-8 I3 K0"},
        {"G18; contour c = { DIAMON; G1 X24 Z-5; G2 X30 Z-8 I=AC(15) K=AC(-5); }; follow(c);",
         "plane_zx | diameter_on\nline X24 Z-5\narc_cw X30 Z-8 I3 K0"},
        {"G18; contour c = { DIAMON; G1 X20 Z0; G91 X4 Z-2; }; follow(c);",
         "plane_zx | diameter_on\nline X20 Z0\nline X24 Z-2"},
        {"G18; contour c = { DIAMON; G1 X20 Z0; G3 X24 Z-2 K-2; }; element e = c[0]; X=e.center.x "
         "Z=e.radius Y=e.sweep/1deg*1mm; if (e.is_diameter && c.is_diameter) X=c.max.x;",
         "plane_zx | diameter_on\nX20 Y90 Z2\nX24"},
        {"G18; contour c = { DIAMON; G1 X6 Z0; X14 Z-3; }; X=c.length;",
         "plane_zx | diameter_on\nX5"},
        // 1 mm beside, on the radius; moved by a diameter.
        {"G18; contour c = { DIAMON; G1 X20 Z0; Z-10; }; follow(c, right: 1mm); follow(shift(c, x: "
         "4mm));",
         "plane_zx | diameter_on\nline X22 Z0\nline X22 Z-10\nline X24 Z0\nline X24 Z-10"},
        {"G18; contour c = { DIAMON; G1 X20 Z0; X40 Z-10; }; for (point p : crossings(c, x: 30mm)) "
         "G0 p;",
         "plane_zx | diameter_on\nrapid X30 Z-5"},
        // As the program has it; a contour in a contour is in the words of the outer one.
        {"G18; DIAMON; contour c = { G1 X20 Z0; X24; }; contour d = { DIAMOF; follow(c); }; "
         "follow(d);",
         "plane_zx\ndiameter_on\nline X20 Z0\nline X24 Z0"},
        {"G18; contour c = { DIAMON; G1 X20 Z0; X24; }; follow(c, feed: 50); contour d = { G1 X1 "
         "Z0; X2; }; follow(d);",
         "plane_zx | diameter_on\nline X20 Z0 F50\nline X24 Z0\nline X1 Z0\nline X2 Z0"},
    });
}

TEST(Contours, Crossings) {
    expect_rows({
        {"contour c = { G1 X0 Y0; X10 Y10; X20 Y0; X30 Y10; }; for (point p : crossings(c, y: "
         "4mm)) G0 p;",
         "rapid X4 Y4\nrapid X16 Y4\nrapid X24 Y4"},
        {"contour c = { G1 X5 Y0; G3 I-5; }; for (point p : crossings(c, x: 3mm)) G0 p;",
         "rapid X3 Y4\nrapid X3 Y-4"},
        {"contour c = { G1 X0 Y0; X10; }; X=crossings(c, y: 1mm).count; contour d; X=crossings(d, "
         "x: 0mm).count;",
         "X0\nX0"},
    });
}

TEST(Contours, MadeAnew) {
    expect_rows({
        {"contour c = { G1 X0 Y0; X10; }; follow(reverse(c));", "line X10 Y0\nline X0 Y0"},
        {"contour c = { G1 X0 Y0; X10; }; follow(shift(c, x: 5mm, y: 1mm));",
         "line X5 Y1\nline X15 Y1"},
        {"contour c = { G1 X0 Y0; X10; }; follow(rotate(c, 90deg, about: {10mm, 0mm}));",
         "line X10 Y-10\nline X10 Y0"},
        {"contour c = { G1 X5 Y0; G2 X0 Y-5 I-5 J0; }; follow(mirror(c, x: true));",
         "line X-5 Y0\narc_ccw X0 Y-5 I5 J0"},
        // The commands of the same names are still there.
        {"shift(x: 5mm); rotate(30deg);", "shift(x=5)\nrotate(angle=30)"},
        {"contour c = { G1 X0 Y0; X20; Y10; X0; close; }; contour[] inner = offset(c, 2mm); "
         "X=inner.count; for (contour i : inner) G0 i.max; X=offset(c, 6mm).count;",
         "X1\nrapid X18 Y8\nX0"},
        // A value: a copy does not change with the original.
        {"contour a = { G1 X0 Y0; X10; }; contour b = a; a = reverse(a); follow(b);",
         "line X0 Y0\nline X10 Y0"},
    });
}

TEST(Contours, AreValuesEverywhere) {
    const Outcome outcome = run(R"(
contour outline = { G1 X0 Y0; X40; Y20; X0; close; };
const length r = 3mm;
struct pocket_data { contour outline; length depth = 5mm; }
contour square(length a) { contour c = { G1 X0 Y0; X=a; Y=a; X0; close; }; return c; }
cycle mill(contour shape, length depth) { G1 Z=-depth; follow(shape, left: r); }
program p() {
    F100;
    mill(outline, depth: 2mm);
    pocket_data data = {square(10mm)};
    contour[] all = {outline, data.outline};
    X=all[1].length Y=all.count;
}
)");
    EXPECT_EQ(outcome.all_messages(), "");
    EXPECT_EQ(outcome.all_blocks(),
              "F100\nline Z-2\nline X3 Y3\nline X37 Y3\nline X37 Y17\nline X3 Y17\nline X3 Y3\n"
              "X40 Y2");
}

TEST(Contours, MistakesHaveTheirPlaces) {
    struct Mistake {
        const char* source;
        const char* message;
    };
    for (const Mistake& row : std::initializer_list<Mistake>{
             {"contour c = { G1 X0 Y0; X10 M8; };", "2:25 K3601"},
             {"contour c = { G1 X0 Y0; Z10; };", "2:25 K3601"},
             {"contour c = { G1 X0 Y0; G0 X10; };", "2:25 K3601"},
             {"contour c = { G1 X0 Y0; note \"a\"; };", "2:25 K3601"},
             {"contour c = { G1 X0 Y0; with shift(x: 1mm) { X10; } };", "2:30 K3601"},
             {"contour c = { G1 Y0; };", "2:15 K3602"},
             {"contour c = { G2 X0 Y0 I5; };", "2:15 K3602"},
             {"contour c = { G1 X0 Y0; G3 X10 I2; };", "2:25 K3603"},
             // At a corner inside, the straight way and the quarter circle come through the wall.
             {"contour c = { G1 X0 Y0; X10; Y10; X0; close; }; follow(c, left: 1mm, lead_in: 2mm);",
              "2:49 K3609"},
             {"contour c = { G1 X0 Y0; X10; Y10; X0; close; }; follow(c, left: 1mm, arc_in: 2mm);",
              "2:49 K3609"},
             {"contour c = { G1 X0 Y0; X10; Y10; X0; close; }; follow(c, left: 0mm, arc_out: 2mm);",
              "2:49 K3609"},
             {"contour c = { G1 X10 Y0; G3 I-10; }; follow(c, left: 2mm, arc_in: 9mm);",
              "2:38 K3609"},
             {"contour c = { G1 X10 Y0; G3 I-10; }; follow(c, left: 2mm, arc_in: -1mm);",
              "2:38 K3610"},
             {"contour c = { G1 X10 Y0; G3 I-10; }; follow(c, left: 12mm);", "2:38 K3608"},
             {"contour c = { close; };", "2:15 K3605"},
             {"contour c = { G1 X0 Y0; X10; }; X=crossings(c, z: 1mm).count;", "2:35 K3616"},
             {"contour c = { G1 X0 Y0; X10; }; X=crossings(c, x: 1mm, y: 1mm).count;",
              "2:35 K3616"},
             {"contour c = { G1 X0 Y0; X10; }; X=crossings(c).count;", "2:35 K3616"},
             {"G18; contour c = { DIAMON; G1 X0 Z0; X10; DIAMOF; X20; };", "2:43 K3601"},
             {"G18; contour c = { DIAMON; G1 X0 Z0; X10; }; contour d = { DIAMOF; G1 X0 Z0; X9; }; "
              "X=intersections(c, d).count;",
              "2:87 K3606"},
             {"while (true) { contour c = { G1 X0 Y0; break; }; }", "2:40 K2217"},
         }) {
        SCOPED_TRACE(row.source);
        Outcome outcome = run_body(row.source);
        // Most of these contours are only made.
        std::erase_if(outcome.messages,
                      [](const std::string& message) { return message.ends_with("K2501"); });
        ASSERT_EQ(outcome.messages.size(), 1u);
        EXPECT_EQ(outcome.messages[0], row.message);
    }
}

}  // namespace
}  // namespace kadr::testing::contours_test
