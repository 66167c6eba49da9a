// B-splines: poles by intervals and by knots become the same spans; where they end, and what is
// wrong with them.
#include "tests/interp/text_bench.h"

namespace kadr::interp::spline_test {
namespace {

Words pole(double x, double y) { return Words().x(x).y(y); }
Words begin(int degree) {
    return fn(Function::SplineDegree, {{0, degree}}).motion(Function::Spline);
}
Words& interval(Words& words, double width) {
    return words.fn(Function::SplineInterval, {{0, width}});
}
Words by_interval(double x, double y, double width) {
    Words words = pole(x, y);
    return interval(words, width);
}
Words by_knot(double x, double y, double knot) {
    return pole(x, y).fn(Function::SplineKnot, {{0, knot}});
}
Words knot(double value) { return fn(Function::SplineKnot, {{0, value}}); }

std::vector<path::Command> splines(const Ran& ran) {
    std::vector<path::Command> found;
    for (const path::Command& command : ran.commands) {
        if (command.op() == path::Op::Spline) found.push_back(command);
    }
    return found;
}

TEST(Splines, IntervalsAndKnotsAreTheSame) {
    // Degree 3, knots 0 0 0 0 1 3 3 3 3: two spans.
    const Ran intervals =
        run({line().x(0).y(0).f(500), begin(3), by_interval(10, 10, 1), by_interval(20, 0, 2),
             by_interval(30, 10, 0), by_interval(40, 0, 0)});
    const Ran knots =
        run({line().x(0).y(0).f(500), begin(3).x(0).y(0).fn(Function::SplineKnot, {{0, 0}}),
             by_knot(10, 10, 0), by_knot(20, 0, 0), by_knot(30, 10, 0), by_knot(40, 0, 1), knot(3),
             knot(3), knot(3), knot(3)});
    EXPECT_EQ(intervals.codes(), "");
    EXPECT_EQ(knots.codes(), "");
    EXPECT_EQ(intervals.listing(), knots.listing());
    const auto spans = splines(intervals);
    ASSERT_EQ(spans.size(), 2u);
    // By hand: the pole 20|0 is worth (0, 1, 3); between the poles of (0, 0, 1) and (0, 1, 3) the
    // point of (0, 1, 1) divides 1 : 2, and so on.
    EXPECT_NEAR(spans[0].motion().spline().inner[0].x(), 10, 1e-12);
    EXPECT_NEAR(spans[0].motion().spline().inner[1].x(), 10 + 10.0 / 3, 1e-12);
    EXPECT_NEAR(spans[0].motion().spline().inner[1].y(), 10 - 10.0 / 3, 1e-12);
    EXPECT_EQ(spans[1].motion().to[0], 40);
    EXPECT_EQ(spans[1].motion().to[1], 0);
    EXPECT_EQ(spans[0].line, 5u);  // of the last pole on which it depends
    EXPECT_EQ(spans[1].line, 6u);
}

/// An axis that has poles as X has them is, at the end of every span, where X is.
TEST(Splines, OtherAxesHaveThePolesOfTheirBlocks) {
    const std::vector<double> x = {10, 15, 40, 30, 70, 75};
    const std::vector<double> widths = {1, 2, 0.5, 3, 1, 1};
    std::vector<Block> plain = {line().x(0).y(0).f(500), begin(3)};
    std::vector<Block> led = plain;
    for (std::size_t i = 0; i < x.size(); ++i) {
        Words words = by_interval(x[i], i % 2 == 0 ? 10.0 : 0.0, widths[i]);
        words.fn(Function::SplineWeight, {{0, 1 + 0.2 * static_cast<double>(i)}});
        plain.push_back(words);
        led.push_back(words.set(Slot::C, 2 * x[i]));
    }
    const Ran with = run(led);
    EXPECT_EQ(with.codes(), "");
    const auto spans = splines(with);
    const auto without = splines(run(plain));
    ASSERT_EQ(spans.size(), 4u);
    ASSERT_EQ(without.size(), 4u);
    for (std::size_t i = 0; i < spans.size(); ++i) {
        EXPECT_EQ(spans[i].motion().to[0], without[i].motion().to[0]);
        EXPECT_NEAR(spans[i].motion().to[index(Axis::C)], 2 * spans[i].motion().to[0], 1e-9) << i;
        EXPECT_EQ(without[i].motion().to[index(Axis::C)], 0) << i;
    }
    EXPECT_EQ(spans.back().motion().to[index(Axis::C)], 150);
}

TEST(Splines, ClampedWhateverTheLastIntervalsSay) {
    const auto listing = [](double second_last, double last) {
        return run({line().x(0).y(0).f(500), begin(3), by_interval(10, 10, 1),
                    by_interval(20, 0, 2), by_interval(30, 10, second_last),
                    by_interval(40, 0, last)})
            .listing();
    };
    EXPECT_EQ(listing(0, 0), listing(1, 7));
    // Nothing said: widths of one.
    EXPECT_EQ(
        run({line().x(0).y(0).f(500), begin(2), pole(10, 10), pole(20, 0), pole(30, 5)}).listing(),
        run({line().x(0).y(0).f(500), begin(2), by_interval(10, 10, 1), by_interval(20, 0, 1),
             by_interval(30, 5, 1)})
            .listing());
}

TEST(Splines, EndAtAnotherMotionOrFunction) {
    for (const Words& next : {line().x(50), rapid().x(50), fn(Function::CoolantFlood),
                              fn(Function::MachineFunction, {{0, 88}}), Words()}) {
        const Ran ran = run({line().x(0).y(0).f(500), begin(2), pole(10, 10), pole(20, 0), next,
                             line().x(20).y(0)});
        EXPECT_FALSE(ran.alarmed) << ran.codes();
        EXPECT_EQ(splines(ran).size(), 1u);
    }
    const Ran twice = run({line().x(0).y(0).f(500), begin(2), pole(10, 10), pole(20, 0),
                           fn(Function::CoolantFlood), pole(30, 10), pole(40, 0)});
    ASSERT_EQ(splines(twice).size(), 2u);
    EXPECT_EQ(splines(twice)[1].motion().spline().degree, 2);
    EXPECT_EQ(splines(twice)[1].motion().to[0], 40);
    // At the end of the program, too.
    EXPECT_EQ(splines(run({line().x(0).y(0).f(500), begin(2), pole(10, 10), pole(20, 0)})).size(),
              1u);
}

/// Through four points, with words beside the third one.
std::string four_points(const std::string& kind, const std::string& beside_third) {
    return "G64 F500 G1 X0 Y0\n" + kind + " X20 Y10\nX40 Y0\nX60 Y10 " + beside_third +
           "\nX80 Y0\nG1 X90\nM30\n";
}

bool has_same_shape(const path::Command& a, const path::Command& b) {
    if (a.motion().spline().degree != b.motion().spline().degree) return false;
    const auto inside = static_cast<std::size_t>(a.motion().spline().degree) - 1;
    return std::equal(a.motion().spline().inner.begin(), a.motion().spline().inner.begin() + inside,
                      b.motion().spline().inner.begin());
}

/// SINUMERIK reference 4.4: another motion, a stop or a block without a position ends a spline.
TEST(Splines, GoOnBesideWordsThatEndNone) {
    for (const std::string kind : {"ASPLINE", "CSPLINE", "BSPLINE"}) {
        const auto plain = splines(read("sinumerik", four_points(kind, "")));
        ASSERT_FALSE(plain.empty());
        for (const std::string word :
             {"MSG(\"A\")", "G64",           "G60",     "G9",        "G641 ADIS=1", "OVR=50",
              "ACC[X]=50",  "VELOLIM[Y]=50", "S2000",   "F300",      "T2",          "M8",
              "M3 S100",    "G90",           "G17",     "LIMS=2000", "COMPON",      "FNORM",
              "FLIN",       "CFC",           "CFTCP",   "ISD=0",     "ORIC",        "G451",
              "KONT",       "ORIVECT",       "ORIAXES", "ORIRPY",    "ORIMKS",      "ORIROTT",
              "ORISON",     "ORISOF",        "CP",      "PTPG0"}) {
            SCOPED_TRACE(kind + " " + word);
            const Ran ran = read("sinumerik", four_points(kind, word));
            EXPECT_FALSE(ran.alarmed) << ran.codes();
            const auto found = splines(ran);
            ASSERT_EQ(found.size(), plain.size());
            for (std::size_t i = 0; i < found.size(); ++i) {
                EXPECT_TRUE(has_same_shape(found[i], plain[i])) << i;
                EXPECT_EQ(found[i].motion().to, plain[i].motion().to) << i;
            }
        }
        // A stop ends it.
        const Ran stopped = read("sinumerik", four_points(kind, "M0"));
        const bool is_same = splines(stopped).size() == plain.size() &&
                             has_same_shape(splines(stopped)[1], plain[1]);
        EXPECT_FALSE(is_same) << kind;
    }
}

/// What stands beside a point acts from its span on, and not on those that waited for the point.
TEST(Splines, WordsBesideAPointActFromItsSpanOn) {
    for (const std::string kind : {"ASPLINE", "CSPLINE"}) {
        SCOPED_TRACE(kind);
        const Ran ran = read("sinumerik", four_points(kind, "MSG(\"A\") OVR=50 G94 F300 G9"));
        EXPECT_FALSE(ran.alarmed) << ran.codes();
        const auto spans = splines(ran);
        ASSERT_EQ(spans.size(), 4u);
        for (std::size_t i = 0; i < 4; ++i) {
            const auto& dynamics = spans[i].motion().dynamics;
            EXPECT_EQ(dynamics ? dynamics->feed : 1, i < 2 ? 1 : 0.5) << i;
            EXPECT_EQ(spans[i].motion().feed, i < 2 ? 500 : 300) << i;
            EXPECT_EQ(spans[i].motion().exact_stop, i == 2) << i;
            EXPECT_EQ(spans[i].line, i + 2) << i;
        }
        std::string order;
        for (const path::Command& command : ran.commands) {
            if (command.op() == path::Op::Message) order += 'm';
            if (command.op() == path::Op::Spline) order += 's';
        }
        EXPECT_EQ(order, "ssmss");
    }
    // Under G60 every block ends at rest.
    const auto stopping = splines(read("sinumerik", "F500 G1 X0 Y0 G60\nCSPLINE X1 Y1\nX2\nM30\n"));
    ASSERT_EQ(stopping.size(), 2u);
    EXPECT_TRUE(stopping[0].motion().exact_stop && stopping[1].motion().exact_stop);
}

TEST(Splines, FeedWeightsAndExactStop) {
    Words heavy = pole(10, 10);
    heavy.fn(Function::SplineWeight, {{0, 2}});
    const Ran ran = run({fn(Function::ExactStop), line().x(0).y(0).f(500), begin(2), heavy,
                         pole(20, 0), pole(30, 10).f(300), pole(40, 0)});
    EXPECT_EQ(ran.codes(), "");
    const auto spans = splines(ran);
    ASSERT_EQ(spans.size(), 3u);
    EXPECT_EQ(spans[0].motion().feed, 500);
    EXPECT_EQ(spans[1].motion().feed, 300);
    EXPECT_FALSE(spans[0].motion().exact_stop);
    EXPECT_FALSE(spans[1].motion().exact_stop);
    EXPECT_TRUE(spans[2].motion().exact_stop);
    EXPECT_EQ(spans[0].motion().spline().weights[1], 2);
    EXPECT_EQ(spans[2].motion().spline().weights[2], 1);
}

TEST(Splines, IncrementalAndShifted) {
    const Ran absolute = run({line().x(0).y(0).f(500), begin(2), pole(10, 10), pole(20, 0)});
    const Ran incremental = run({line().x(0).y(0).f(500), fn(Function::Incremental), begin(2),
                                 pole(10, 10), pole(10, -10)});
    EXPECT_EQ(absolute.listing(), incremental.listing());
    const Ran shifted = run({fn(Function::Shift, {{0, 100}}), line().x(0).y(0).f(500), begin(2),
                             pole(10, 10), pole(20, 0)});
    EXPECT_EQ(splines(shifted).at(0).motion().to[0], 120);
    EXPECT_EQ(splines(shifted).at(0).motion().spline().inner[0].x(), 110);
}

/// SINUMERIK reference 4.4, 4.5: PL is the range of polynomials, which is above zero, and of a
/// B-spline a distance of knots.
TEST(Splines, IntervalsBelowZeroHaveTheirAlarms) {
    const std::string start = "M3 S100 F500 G1 X0 Y0\n";
    for (const std::string range : {"PL=0", "PL=-1"})
        EXPECT_EQ(alarms(read("sinumerik", start + "POLY PO[X]=(10,2) " + range + "\nM30\n")),
                  "14093");
    EXPECT_EQ(alarms(read("sinumerik", start + "BSPLINE X10 Y5 PL=-1\nX20\nX30\nM30\n")), "12560");
}

TEST(Splines, WhatIsWrong) {
    const auto codes = [](std::vector<Block> blocks) {
        blocks.insert(blocks.begin(), line().x(0).y(0).f(500));
        return run(blocks).codes();
    };
    EXPECT_EQ(codes({begin(3), pole(10, 10), pole(20, 0)}), "K5203");
    EXPECT_EQ(codes({begin(2), by_interval(10, 10, -1), pole(20, 0)}), "K5006");
    EXPECT_EQ(
        codes({begin(1).x(0).y(0).fn(Function::SplineKnot, {{0, 0}}), by_knot(10, 0, 0), knot(1)}),
        "K5204");
    EXPECT_EQ(codes({begin(1).x(0).y(0).fn(Function::SplineKnot, {{0, 0}}), by_knot(10, 0, 1),
                     knot(2), knot(2)}),
              "K5204");
    EXPECT_EQ(codes({begin(1).x(5).y(0).fn(Function::SplineKnot, {{0, 0}})}), "K5205");
    EXPECT_EQ(codes({begin(4), pole(10, 10)}), "K5206");
    Words weightless = pole(10, 10);
    weightless.fn(Function::SplineWeight, {{0, 0}});
    EXPECT_EQ(codes({begin(2), weightless, pole(20, 0)}), "K5206");
    EXPECT_EQ(codes({begin(2), pole(10, 10).set(Slot::B, 20), pole(20, 0)}), "K5230");
    EXPECT_EQ(codes({begin(1).x(0).y(0).fn(Function::SplineKnot, {{0, 0}}),
                     by_knot(10, 0, 0).set(Slot::C, 20)}),
              "K5207");
    // Beyond the limit of X between the poles; the poles themselves may be beyond it.
    EXPECT_EQ(codes({begin(2), pole(1500, 0), pole(0, 100)}), "");
    EXPECT_EQ(codes({begin(2), pole(2500, 0), pole(0, 100)}).substr(0, 2), "K5");
}

}  // namespace
}  // namespace kadr::interp::spline_test
