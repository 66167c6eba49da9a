// Curves of programs: which blocks follow them, their points and derivatives, their mistakes.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/sema/running.h"

namespace kadr::testing::curves_test {
namespace {

const std::string kEllipse =
    "curve ellipse(length a, length b = a/2) over angle t = 0deg .. 360deg { x = a*cos(t); y = "
    "b*sin(t); }\n";

/// Lines and arcs among blocks as `describe` shows them.
struct Count {
    int lines = 0;
    int arcs = 0;
};
Count count(const Outcome& outcome) {
    Count result;
    for (const std::string& block : outcome.blocks) {
        if (block.starts_with("line")) ++result.lines;
        if (block.starts_with("arc")) ++result.arcs;
    }
    return result;
}

RunOptions on(const std::string& control) {
    RunOptions options;
    options.target = control;
    return options;
}

double word(const std::string& block, char address) {
    const std::size_t at = block.find(std::string(" ") + address);
    return at == std::string::npos ? std::nan("") : std::stod(block.substr(at + 2));
}

TEST(Curves, ArcsInThePlane) {
    const Outcome outcome = run(kEllipse +
                                "program p() { G0 follow_start(ellipse(30mm, 20mm)); "
                                "follow(ellipse(30mm, 20mm), tolerance: 5um, feed: 400mm/min); }");
    ASSERT_EQ(outcome.all_messages(), "");
    EXPECT_EQ(outcome.blocks.front(), "rapid X30 Y0");
    EXPECT_NE(outcome.blocks[1].find("F400"), std::string::npos);
    EXPECT_EQ(outcome.all_blocks().find("F400", outcome.all_blocks().find("F400") + 1),
              std::string::npos);
    EXPECT_EQ(count(outcome).lines, 0);
    EXPECT_GE(count(outcome).arcs, 16);
    EXPECT_LE(count(outcome).arcs, 40);
    // Every end of an arc is on the ellipse or, between the arcs of a pair, within 5 µm of it; the
    // tangents at the ends of pairs are the ellipse's own: the centre is on its normal there.
    double x = 30, y = 0;
    for (std::size_t i = 1; i < outcome.blocks.size(); ++i) {
        const std::string& block = outcome.blocks[i];
        const double to_x = word(block, 'X'), to_y = word(block, 'Y');
        // Distance by first order: (x²/a² + y²/b² − 1)/|gradient|.
        const double f = to_x * to_x / 900 + to_y * to_y / 400 - 1;
        EXPECT_LT(std::fabs(f) / std::hypot(to_x / 450, to_y / 200), 0.005);
        if (i % 2 == 1) {
            const double nx = x / 900, ny = y / 400;
            const double cross = nx * word(block, 'J') - ny * word(block, 'I');
            EXPECT_LT(std::fabs(cross) / std::hypot(nx, ny) /
                          std::hypot(word(block, 'I'), word(block, 'J')),
                      1e-9);
        }
        x = to_x;
        y = to_y;
    }
    EXPECT_EQ(x, 30);
    EXPECT_EQ(y, 0);
}

TEST(Curves, LinesInSpaceAndOnWish) {
    const Outcome lines = run(kEllipse + "program p() { follow(ellipse(30mm), arcs: false); }");
    EXPECT_EQ(lines.all_messages(), "");
    EXPECT_EQ(count(lines).arcs, 0);
    EXPECT_GT(count(lines).lines, 100);
    const Outcome space = run(
        "curve rise() over real u = 0 .. 2 { x = 10mm*cos(u*360deg); y = 10mm*sin(u*360deg); z = "
        "-u*5mm; }\nprogram p() { follow(rise(), tolerance: 0.01mm); }");
    EXPECT_EQ(space.all_messages(), "");
    EXPECT_EQ(space.blocks.front(), "line X10 Y0 Z0");
    EXPECT_EQ(count(space).arcs, 0);
    EXPECT_EQ(word(space.blocks.back(), 'Z'), -10);
}

TEST(Curves, SplinesOnWish) {
    const std::string program =
        kEllipse +
        "program p() { G0 X30 Y0; follow(ellipse(30mm, 20mm), feed: 400mm/min, "
        "nurbs: true); X40; }";
    const Outcome intervals = run(program, on("sinumerik"));
    ASSERT_EQ(intervals.all_messages(), "");
    EXPECT_EQ(intervals.blocks[1].substr(0, 11), "spline X30 ");
    EXPECT_NE(intervals.blocks[1].find("F400"), std::string::npos);
    EXPECT_NE(intervals.blocks[1].find("spline_degree(degree=3)"), std::string::npos);
    EXPECT_LT(intervals.blocks.size(), 40u);
    // A position behind the spline is no pole of it.
    EXPECT_EQ(intervals.blocks.back(), "line X40");
    const std::string& last = intervals.blocks[intervals.blocks.size() - 2];
    EXPECT_EQ(last, "X30 Y0 | spline_interval(interval=0)");
    // By knots: the first pole as well, and four knots more behind the last.
    const Outcome knots = run(program, on("fanuc"));
    ASSERT_EQ(knots.all_messages(), "");
    EXPECT_EQ(knots.blocks.size(), intervals.blocks.size() + 5);
    EXPECT_EQ(knots.blocks[1],
              "spline X30 Y0 F400 | spline_degree(degree=3) | spline_knot(knot=0)");
    EXPECT_EQ(knots.blocks[knots.blocks.size() - 2].substr(0, 12), "spline_knot(");
    // Lines and arcs where the control has none, said once; and in a contour.
    const Outcome none = run(kEllipse +
                             "program p() { G0 X30 Y0; for (int i = 0; i < 2; i++) "
                             "follow(ellipse(30mm, 20mm), feed: 400mm/min, nurbs: true); }");
    EXPECT_EQ(none.messages.size(), 1u);
    EXPECT_NE(none.all_messages().find("K3617"), std::string::npos);
    EXPECT_GE(count(none).arcs, 32);
    const Outcome contour =
        run(kEllipse +
                "program p() { contour c = { follow(ellipse(30mm), nurbs: true); close; }; "
                "follow(c); }",
            on("sinumerik"));
    EXPECT_EQ(contour.all_messages(), "");
    EXPECT_EQ(contour.all_blocks().find("spline"), std::string::npos);
}

TEST(Curves, SplinesUnderIncrementalDimensionsAndOfJumps) {
    const Outcome incremental =
        run(kEllipse + "program p() { G0 X30 Y0; G91; follow(ellipse(30mm), nurbs: true); }",
            on("sinumerik"));
    EXPECT_EQ(incremental.all_messages(), "");
    EXPECT_NE(incremental.blocks[3].find("X=AC("), std::string::npos);
    const Outcome jump =
        run("curve c() over real t = 0 .. 10 { x = t*1mm; if (t < 5) y = 0mm; else y = 3mm; }\n"
            "program p() { follow(c(), nurbs: true); }",
            on("sinumerik"));
    EXPECT_NE(jump.all_messages().find("K3615"), std::string::npos);
}

TEST(Curves, BodiesAreProgramsOfTheirOwn) {
    // Functions, conditions, references, constants of the file; the sum of both branches is smooth.
    const Outcome outcome = run(R"(
const length base = 30mm;
real cycloid(real u) { return u - sin(u*360deg)/(2*pi); }
length lift(angle a, length h) {
    if (a < 120deg) return h*cycloid(a/120deg);
    if (a < 180deg) return h;
    return h*(1 - cycloid((a - 180deg)/180deg));
}
void turn(length& u, length& v, angle by) {
    length old = u;
    u = u*cos(by) - v*sin(by);
    v = old*sin(by) + v*cos(by);
}
curve cam(length h) over angle a = 0deg .. 360deg {
    length r = base + lift(a, h);
    x = r; y = 0mm;
    turn(x, y, -a);
}
program p() { follow(cam(10mm), tolerance: 2um); }
)");
    ASSERT_EQ(outcome.all_messages(), "");
    EXPECT_EQ(outcome.blocks.front(), "line X30 Y0");
    EXPECT_EQ(count(outcome).lines, 1);
    EXPECT_LE(count(outcome).arcs, 90);
    for (const std::string& block : outcome.blocks) {
        const double r = std::hypot(word(block, 'X'), word(block, 'Y'));
        EXPECT_GT(r, 30 - 0.002);
        EXPECT_LT(r, 40 + 0.002);
    }
}

TEST(Curves, InOtherPlacesAndWays) {
    // Backwards, in the plane Z-X, incremental around it, in a contour, more blocks than a batch.
    const Outcome backwards = run(
        "curve c() over angle t = 90deg .. 0deg { x = 10mm*cos(t); y = 10mm*sin(t); }\nprogram p() "
        "{ G0 X0 Y10; follow(c()); }");
    EXPECT_EQ(backwards.all_messages(), "");
    EXPECT_EQ(word(backwards.blocks.back(), 'X'), 10);
    EXPECT_TRUE(backwards.blocks.back().starts_with("arc_cw"));
    const Outcome lathe =
        run("curve c() over length s = 0mm .. 20mm { z = -s; x = 10mm + s*s/40mm; }\nprogram p() { "
            "G18; "
            "G0 Z0 X10; follow(c()); }");
    EXPECT_EQ(lathe.all_messages(), "");
    EXPECT_EQ(word(lathe.blocks.back(), 'X'), 20);
    EXPECT_GE(count(lathe).arcs, 2);
    const Outcome kept = run(
        kEllipse +
        "program p() { contour c = { follow(ellipse(30mm)); close; }; X=c.count Y=c.area/1mm; }");
    EXPECT_EQ(kept.all_messages(), "");
    EXPECT_NEAR(word(" " + kept.blocks[0], 'Y'), 3.14159265 * 30 * 15, 0.4);
    const Outcome many = run(kEllipse +
                             "program p() { for (int i = 0; i < 40; i++) { follow(ellipse(30mm), "
                             "tolerance: 1um); G0 Z=i; } }");
    EXPECT_EQ(many.all_messages(), "");
    EXPECT_GT(many.blocks.size(), 2000u);
    EXPECT_EQ(many.blocks.back(), "rapid Z39");
}

/// The derivative of every function that a curve may use, seen through the tangent: a curve with a
/// wrong one would need many more arcs to keep the tolerance. Both sides are smooth and of one
/// size, so the number of arcs tells.
TEST(Curves, DerivativesOfAllFunctions) {
    for (const char* formula : {"10*u",
                                "u*u",
                                "5/(u + 1)",
                                "(u + 3)/(u + 2)",
                                "3 - u",
                                "u/2",
                                "-u",
                                "sqrt(u + 1)",
                                "sin(u*1rad)",
                                "cos(u*1rad)",
                                "tan(u*0.5rad)",
                                "asin(u/3)/1rad",
                                "acos(u/3)/1rad",
                                "atan(u)/1rad",
                                "atan2(u, 2)/1rad",
                                "exp(u)",
                                "ln(u + 1)",
                                "log10(u + 1)",
                                "cbrt(u + 1)",
                                "pow(u + 1, 2.5)",
                                "pow(2, u)",
                                "hypot(u, 2)",
                                "abs(u + 1)",
                                "min(u, 9)",
                                "max(u*u, -1)",
                                "(u + 5) % 100",
                                "mod(u + 5, 100)",
                                "real(3)*u",
                                "u*u*u - 2*u"}) {
        SCOPED_TRACE(formula);
        const Outcome outcome =
            run("curve c() over real u = 0 .. 2 { x = u*10mm; y = (" + std::string(formula) +
                ")*3mm; }\nprogram p() { G0 follow_start(c()); follow(c(), tolerance: 1um); }");
        EXPECT_EQ(outcome.all_messages(), "");
        EXPECT_LE(count(outcome).arcs + count(outcome).lines, 60);
        EXPECT_EQ(word(outcome.blocks.back(), 'X'), 20);
    }
}

TEST(Curves, FaultsInsideShowTheWay) {
    const Outcome outcome =
        run("real f(real u) { return 1/(u - 1); }\n"
            "curve c() over real u = 0 .. 1 { x = u*1mm; y = f(u)*1mm; }\n"
            "program p() {\n  follow(c());\n}");
    ASSERT_EQ(outcome.messages.size(), 1u);
    EXPECT_EQ(outcome.messages[0], "1:25 K3101");
    ASSERT_EQ(outcome.notes.size(), 2u);
    EXPECT_EQ(outcome.notes[0], "2:49 `f` was called here");
    EXPECT_EQ(outcome.notes[1], "4:10 `c` was called here");
}

}  // namespace
}  // namespace kadr::testing::curves_test
