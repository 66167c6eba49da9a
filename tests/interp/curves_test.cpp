// Splines through points, polynomials, involutes, threads whose pitch changes: what blocks make of
// them, where they end, and what is wrong with them.
#include <cmath>

#include <Eigen/Geometry>

#include "path/curve.h"
#include "path/curve_of.h"
#include "tests/interp/bench.h"

namespace kadr::interp::curves_test {
namespace {

using path::Op;
using path::Vec3;

Words at(double x, double y) { return Words().x(x).y(y); }
Words through(Function function) { return Words().motion(function); }
Words start_end(Words words, double start, double end) {
    words.fn(Function::SplineStart, {{0, start}});
    return words.fn(Function::SplineEnd, {{0, end}});
}

std::vector<path::Command> of(const Ran& ran, Op op) {
    std::vector<path::Command> found;
    for (const path::Command& command : ran.commands)
        if (command.op() == op) found.push_back(command);
    return found;
}

Vec3 place(const path::Command& command) {
    return {command.motion().to[0], command.motion().to[1], command.motion().to[2]};
}

std::string codes(std::vector<Block> blocks) {
    blocks.insert(blocks.begin(), line().x(0).y(0).z(0).f(500));
    return run(blocks).codes();
}

// ------------------------------------------------------------------------------ through points

TEST(ThroughSplines, HaveASpanForEveryPoint) {
    for (const Function function : {Function::AkimaSpline, Function::CubicSpline}) {
        const Ran ran = run({line().x(0).y(0).f(500), through(function).x(10).y(10),
                             at(20, 0).f(300), at(30, 10), at(40, 0), line().x(50)});
        EXPECT_EQ(ran.codes(), "");
        const auto spans = of(ran, Op::Spline);
        ASSERT_EQ(spans.size(), 4u);
        Vec3 from(0, 0, 0);
        for (std::size_t i = 0; i < spans.size(); ++i) {
            EXPECT_EQ(place(spans[i])[0], 10.0 * static_cast<double>(i + 1));
            EXPECT_EQ(spans[i].line, i + 2);
            EXPECT_EQ(spans[i].motion().feed, i == 0 ? 500 : 300);
            if (i > 0) {
                // One direction from span to span.
                const Vec3 in = from - spans[i - 1].motion().spline().inner[1];
                const Vec3 out = spans[i].motion().spline().inner[0] - from;
                EXPECT_LT((in.normalized() - out.normalized()).norm(), 1e-12);
            }
            from = place(spans[i]);
        }
    }
    // By hand, natural: three points at equal chords, M1 = 6·(d1 − d0)/(4·h).
    const Ran ran = run({line().x(0).y(0).f(500), through(Function::CubicSpline).x(3).y(4),
                         at(6, 0), line().x(50)});
    const auto spans = of(ran, Op::Spline);
    ASSERT_EQ(spans.size(), 2u);
    // d0 = (0.6, 0.8), d1 = (0.6, −0.8): M1 = 6·(0, −1.6)/20 = (0, −0.48). Slope at the start:
    // d0 − h·M1/6 = (0.6, 1.2), so the first pole is (1, 2).
    EXPECT_LT((spans[0].motion().spline().inner[0] - Vec3(1, 2, 0)).norm(), 1e-12);
    EXPECT_LT((spans[0].motion().spline().inner[1] - Vec3(2, 4, 0)).norm(), 1e-12);
}

TEST(ThroughSplines, EndAtAnythingElse) {
    for (const Words& next : {line().x(50), rapid().x(50), fn(Function::CoolantFlood), Words(),
                              at(50, 0).fn(Function::MachineFunction, {{0, 88}})}) {
        const Ran ran = run({line().x(0).y(0).f(500), through(Function::CubicSpline).x(10).y(10),
                             at(20, 0), next, line().x(20).y(0)});
        EXPECT_FALSE(ran.alarmed) << ran.codes();
        EXPECT_EQ(of(ran, Op::Spline).size(),
                  next.operator Block().motion == Function::None && next.operator Block().given != 0
                      ? 3u
                      : 2u);
    }
    // Another kind begins anew; the same word said again goes on.
    const auto mean_y = [](Function second) {
        const Ran ran = run({line().x(0).y(0).f(500), through(Function::CubicSpline).x(10).y(10),
                             at(20, 0), through(second).x(30).y(10), at(40, 0), line().x(50)});
        EXPECT_EQ(of(ran, Op::Spline).size(), 4u);
        const auto spans = of(ran, Op::Spline);
        const Vec3 in = place(spans[1]) - spans[1].motion().spline().inner[1];
        const Vec3 out = spans[2].motion().spline().inner[0] - place(spans[1]);
        return in.normalized().dot(out.normalized());
    };
    EXPECT_NEAR(mean_y(Function::CubicSpline), 1, 1e-12);
    EXPECT_LT(mean_y(Function::AkimaSpline), 0.5);
    // The end of the program, too; a block that the operator leaves out does not end it.
    EXPECT_EQ(
        of(run({line().x(0).y(0).f(500), through(Function::CubicSpline).x(10).y(10)}), Op::Spline)
            .size(),
        1u);
    const Ran skipped = run({line().x(0).y(0).f(500), through(Function::CubicSpline).x(10).y(10),
                             line().x(7).skip(0), at(20, 0), at(30, 5)});
    EXPECT_EQ(skipped.codes().find("K52"), std::string::npos);
}

TEST(ThroughSplines, BeginAndEndInTheDirectionBeside) {
    const Ran ran = run({line().x(-10).y(0).f(500), line().x(0).y(0),
                         start_end(through(Function::CubicSpline).x(10).y(10), 2, 2), at(20, 0),
                         at(30, 10), line().x(30).y(50)});
    EXPECT_EQ(ran.codes(), "");
    const auto spans = of(ran, Op::Spline);
    ASSERT_EQ(spans.size(), 3u);
    EXPECT_LT((spans[0].motion().spline().inner[0].normalized() - Vec3(1, 0, 0)).norm(), 1e-12);
    EXPECT_LT(((place(spans[2]) - spans[2].motion().spline().inner[1]).normalized() - Vec3(0, 1, 0))
                  .norm(),
              1e-12);
    // Arcs, by their centre and by their radius, under a rotated frame: (1, 0) becomes (0, 1).
    const auto end_before = [](const Words& next) {
        const Ran turned =
            run({line().x(0).y(0).f(500), fn(Function::Rotate, {{0, 90}}),
                 start_end(through(Function::AkimaSpline).x(10).y(10), 1, 2), at(20, 0), next});
        EXPECT_EQ(turned.codes(), "");
        const auto found = of(turned, Op::Spline);
        return Vec3((place(found.at(1)) - found.at(1).motion().spline().inner[1]).normalized());
    };
    EXPECT_LT((end_before(ccw().x(30).y(10).i(0).j(10)) - Vec3(0, 1, 0)).norm(), 1e-12);
    EXPECT_LT((end_before(cw().x(40).y(0).i(10).j(0)) - Vec3(-1, 0, 0)).norm(), 1e-12);
    EXPECT_LT((end_before(cw().x(40).y(0).r(10)) - Vec3(-1, 0, 0)).norm(), 1e-9);
    // What follows a spline in its direction knows it.
    const Ran tangent = run({line().x(0).y(0).f(500), through(Function::CubicSpline).x(10).y(10),
                             at(20, 0), through(Function::ArcTangent).x(30).y(0)});
    EXPECT_EQ(tangent.codes(), "");
    const auto arcs = of(tangent, Op::Arc);
    ASSERT_EQ(arcs.size(), 1u);
    const Vec3 in = place(of(tangent, Op::Spline).at(1)) -
                    of(tangent, Op::Spline).at(1).motion().spline().inner[1];
    const Vec3 out =
        arcs[0].motion().arc().normal.cross(Vec3(20, 0, 0) - arcs[0].motion().arc().center);
    EXPECT_LT((in.normalized() - out.normalized()).norm(), 1e-9);
}

TEST(ThroughSplines, AreTheSameInAnyFrame) {
    const auto spans_of = [](std::vector<Block> head, Function function) {
        head.push_back(line().x(0).y(0).f(500));
        head.push_back(start_end(through(function).x(10).y(10), 0, 0));
        for (const Words& words : {at(20, 0), at(30, 10), at(45, 0)}) head.push_back(words);
        return of(run(head), Op::Spline);
    };
    for (const Function function : {Function::AkimaSpline, Function::CubicSpline}) {
        const auto plain = spans_of({}, function);
        const auto moved = spans_of({fn(Function::Shift, {{0, 100}, {1, -7}})}, function);
        ASSERT_EQ(plain.size(), 4u);
        ASSERT_EQ(moved.size(), 4u);
        for (std::size_t i = 0; i < plain.size(); ++i) {
            for (std::size_t k = 0; k < 2; ++k)
                EXPECT_LT((moved[i].motion().spline().inner[k] -
                           plain[i].motion().spline().inner[k] - Vec3(100, -7, 0))
                              .norm(),
                          1e-9);
        }
    }
    const Ran incremental =
        run({line().x(0).y(0).f(500), fn(Function::Incremental),
             through(Function::CubicSpline).x(10).y(10), at(10, -10), at(5, 5)});
    const Ran absolute = run({line().x(0).y(0).f(500), through(Function::CubicSpline).x(10).y(10),
                              at(20, 0), at(25, 5)});
    EXPECT_EQ(incremental.listing(), absolute.listing());
}

/// Every span leads the other axes to what its block says; the curve is that without them.
TEST(ThroughSplines, OtherAxesComeAlongFromPointToPoint) {
    for (const Function function : {Function::AkimaSpline, Function::CubicSpline}) {
        const auto spans_with = [&](double c) {
            const auto turned = [c](Words words, double share) {
                return c == 0 ? words : words.set(Slot::C, c * share);
            };
            const Ran ran = run({line().x(0).y(0).f(500), turned(through(function).x(10).y(10), 1),
                                 at(20, 0), turned(at(30, 10), -2), at(40, 0), line().x(50)});
            EXPECT_EQ(ran.codes(), "");
            return of(ran, Op::Spline);
        };
        const auto plain = spans_with(0);
        const auto led = spans_with(20);
        ASSERT_EQ(led.size(), 4u);
        ASSERT_EQ(plain.size(), 4u);
        const std::array<double, 4> wanted = {20, 20, -40, -40};
        for (std::size_t i = 0; i < led.size(); ++i) {
            EXPECT_EQ(led[i].motion().to[index(Axis::C)], wanted[i]) << i;
            EXPECT_EQ(place(led[i]), place(plain[i])) << i;
            EXPECT_EQ(led[i].motion().spline().inner[0], plain[i].motion().spline().inner[0]) << i;
            EXPECT_EQ(led[i].motion().spline().inner[1], plain[i].motion().spline().inner[1]) << i;
        }
    }
}

TEST(ThroughSplines, WhatIsWrong) {
    const Words first = through(Function::CubicSpline).x(10).y(10);
    EXPECT_EQ(codes({first, at(10, 10), at(20, 0)}), "K5480");
    EXPECT_EQ(codes({start_end(first, 1, 2), at(20, 0)}), "K5481");
    EXPECT_EQ(codes({start_end(first, 1, 2), at(20, 0), fn(Function::CoolantFlood)}), "K5481");
    EXPECT_EQ(run({start_end(first, 2, 1).f(500), at(20, 0)}).codes(), "K5481");
    EXPECT_EQ(codes({Words(first).set(Slot::C, 20), Words().set(Slot::C, 30)}), "K5207");
    EXPECT_EQ(codes({Words(first).set(Slot::B, 20)}), "K5230");
    EXPECT_EQ(codes({Words(first).x(2500)}).substr(0, 2), "K5");
    // A curve leaves the limits where its points do not.
    EXPECT_EQ(
        codes({through(Function::CubicSpline).x(999).y(0), at(999, 100), at(0, 100)}).substr(0, 2),
        "K5");
    EXPECT_EQ(run({through(Function::CubicSpline).x(10)}).codes().substr(0, 2), "K5");  // no feed
    // Under cutter radius compensation a control's spline is not offset here: it is said.
    EXPECT_EQ(
        codes({fn(Function::RadiusOffset, {{0, 1}}), line().x(5).y(0).fn(Function::RadiusCompLeft),
               line().x(8).y(0), first, at(20, 0), line().x(30)}),
        "K5280");
}

// ------------------------------------------------------------------------------ polynomials

Words poly() { return through(Function::Polynomial); }
Words& axis(Words& words, double which, double end, const std::vector<double>& more = {}) {
    std::vector<std::pair<std::size_t, double>> said = {{0, which}, {1, end}};
    for (const double value : more) said.emplace_back(said.size(), value);
    switch (said.size()) {
        case 2: return words.fn(Function::PolynomialAxis, {said[0], said[1]});
        case 3: return words.fn(Function::PolynomialAxis, {said[0], said[1], said[2]});
        case 4: return words.fn(Function::PolynomialAxis, {said[0], said[1], said[2], said[3]});
        case 5:
            return words.fn(Function::PolynomialAxis,
                            {said[0], said[1], said[2], said[3], said[4]});
        default:
            return words.fn(Function::PolynomialAxis,
                            {said[0], said[1], said[2], said[3], said[4], said[5]});
    }
}

TEST(Polynomials, AreEvaluatedAsTheyAreSaid) {
    // x(p) = 1 + a1·p + 2p² − 0.5p³ + 0.1p⁴ + 0.02p⁵, p to 2, x(2) = 10; y even; z stays at 3.
    Words words = poly();
    axis(words, 1, 10, {2, -0.5, 0.1, 0.02});
    words.y(7).fn(Function::PolynomialRange, {{0, 2}});
    const Ran ran = run({line().x(1).y(5).z(3).f(500), words});
    EXPECT_EQ(ran.codes(), "");
    const auto spans = of(ran, Op::Spline);
    ASSERT_EQ(spans.size(), 1u);
    ASSERT_EQ(spans[0].motion().spline().degree, 5);
    const path::QuinticSpan span =
        path::make_quintic(Vec3(1, 5, 3), place(spans[0]), spans[0].motion().spline());
    const double a1 = (10 - 1 - 2 * 4 + 0.5 * 8 - 0.1 * 16 - 0.02 * 32) / 2;
    for (const double p : {0.0, 0.3, 1.0, 1.7, 2.0}) {
        const double x = 1 + a1 * p + 2 * p * p - 0.5 * std::pow(p, 3) + 0.1 * std::pow(p, 4) +
                         0.02 * std::pow(p, 5);
        const Vec3 point = path::point_at(span, p / 2).position;
        EXPECT_LT((point - Vec3(x, 5 + p, 3)).norm(), 1e-12);
    }
}

TEST(Polynomials, DividedTheyAreConics) {
    // The quarter circle of the manual, at a height and in a shifted frame.
    Words words = poly();
    axis(words, 1, 0, {-10});
    axis(words, 2, 10);
    words.fn(Function::PolynomialWeight, {{0, 2}, {1, 1}});
    const Ran ran = run({fn(Function::Shift, {{0, 100}}), line().x(10).y(0).z(4).f(500), words});
    EXPECT_EQ(ran.codes(), "");
    const auto spans = of(ran, Op::Spline);
    ASSERT_EQ(spans.size(), 1u);
    const auto curve =
        path::make_spline(Vec3(110, 0, 4), Vec3(100, 10, 4), spans[0].motion().spline());
    EXPECT_NEAR(curve.length, 5 * std::acos(-1.0), 1e-9);
    for (const double u : {0.1, 0.4, 0.5, 0.9})
        EXPECT_NEAR((path::point_at(curve, u).position - Vec3(100, 0, 4)).norm(), 10, 1e-12);
    // Told where to go, an axis moves evenly with the parameter all the same.
    Words even = poly();
    axis(even, 1, 0, {-10});
    even.y(10).fn(Function::PolynomialWeight, {{0, 2}, {1, 1}});
    const auto beside = of(run({line().x(10).y(0).f(500), even}), Op::Spline);
    ASSERT_EQ(beside.size(), 1u);
    const auto curved =
        path::make_spline(Vec3(10, 0, 0), Vec3(0, 10, 0), beside[0].motion().spline());
    for (const double u : {0.1, 0.5, 0.9})
        EXPECT_NEAR(path::point_at(curved, u).position.y(), 10 * u, 1e-12);
    // A denominator that dips has control points of no weight: the block becomes several spans.
    Words dips = poly();
    axis(dips, 1, 20);
    dips.fn(Function::PolynomialWeight, {{0, 1}, {1, 3.8}});
    const Ran dipped = run({line().x(10).y(0).f(500), dips});
    EXPECT_EQ(dipped.codes(), "");
    EXPECT_GT(of(dipped, Op::Spline).size(), 1u);
    EXPECT_EQ(of(dipped, Op::Spline).back().motion().to[0], 20);
}

TEST(Polynomials, ChainInTheirDirection) {
    Words words = poly();
    axis(words, 1, 10);
    axis(words, 2, 10, {10});
    // y = 10·p², so it ends in the direction (10, 20).
    const Ran ran =
        run({line().x(0).y(0).f(500), words, through(Function::ArcTangent).x(20).y(20)});
    const auto arcs = of(ran, Op::Arc);
    ASSERT_EQ(arcs.size(), 1u);
    const Vec3 out =
        arcs[0].motion().arc().normal.cross(Vec3(10, 10, 0) - arcs[0].motion().arc().center);
    EXPECT_LT((out.normalized() - Vec3(1, 2, 0).normalized()).norm(), 1e-9);
    // Without a polynomial it is a line.
    EXPECT_EQ(of(run({line().x(0).y(0).f(500), poly().x(5).y(5)}), Op::Spline)
                  .at(0)
                  .motion()
                  .spline()
                  .degree,
              1);
}

/// C goes evenly with the parameter, and each command evenly with its way: at every place along
/// every command both are the same but for a thousandth of a degree.
TEST(Polynomials, OtherAxesGoEvenlyWithTheParameter) {
    // x = 10·q, y = 40·q²: the way to q is that of a parabola, far from even.
    Words words = poly().set(Slot::C, 90);
    axis(words, 1, 10);
    axis(words, 2, 40, {40});
    const Ran ran = run({line().x(0).y(0).f(500), words});
    EXPECT_EQ(ran.codes(), "");
    const auto spans = of(ran, Op::Spline);
    ASSERT_GT(spans.size(), 8u);
    EXPECT_LT(spans.size(), 300u);
    Vec3 from(0, 0, 0);
    double turned = 0;
    for (const path::Command& command : spans) {
        const auto curve = path::make_spline(from, place(command), command.motion().spline());
        const double to = command.motion().to[index(Axis::C)];
        for (int i = 0; i <= 16; ++i) {
            const double share = i / 16.0;
            const double q = path::position(curve, share * curve.length)[0] / 10;
            EXPECT_NEAR(turned + share * (to - turned), 90 * q, 1.1e-3);
        }
        from = place(command);
        turned = to;
    }
    EXPECT_EQ(turned, 90);
    EXPECT_EQ(from, Vec3(10, 40, 0));
    // Without a curve there is nothing to be cut.
    EXPECT_EQ(
        of(run({line().x(0).y(0).f(500), poly().x(5).y(5).set(Slot::C, 90)}), Op::Spline).size(),
        1u);
}

/// A block that lasts a time of its own does so in however many commands.
TEST(Polynomials, UnderInverseTimeThePiecesShareTheTime) {
    Words words = poly().set(Slot::C, 90).fn(Function::FeedInverseTime).f(2);
    axis(words, 1, 10);
    axis(words, 2, 40, {40});
    const Ran ran = run({line().x(0).y(0).f(500), words});
    EXPECT_EQ(ran.codes(), "");
    double minutes = 0;
    for (const path::Command& command : of(ran, Op::Spline)) {
        EXPECT_EQ(command.motion().feed_mode, path::FeedMode::InverseTime);
        minutes += 1 / command.motion().feed;
    }
    EXPECT_NEAR(minutes, 0.5, 1e-9);
}

TEST(Polynomials, WhatIsWrong) {
    const auto with = [](const std::function<void(Words&)>& more) {
        Words words = poly();
        axis(words, 1, 10, {2});
        more(words);
        return codes({words});
    };
    EXPECT_EQ(with([](Words&) {}), "");
    EXPECT_EQ(with([](Words& w) { w.fn(Function::PolynomialRange, {{0, 0}}); }), "K5482");
    EXPECT_EQ(
        with([](Words& w) {
            w.y(5).fn(Function::PolynomialWeight, {{0, 2}, {1, .1}, {2, .1}, {3, .1}, {4, .1}});
        }),
        "K5483");
    EXPECT_EQ(with([](Words& w) { w.fn(Function::PolynomialWeight, {{0, -1}}); }), "K5484");
    // 1 − 4q + 4q² touches zero in the middle.
    EXPECT_EQ(with([](Words& w) { w.fn(Function::PolynomialWeight, {{0, 1}, {1, 4}}); }), "K5484");
    EXPECT_EQ(with([](Words& w) { w.set(Slot::C, 20); }), "");
    EXPECT_EQ(with([](Words& w) { w.set(Slot::B, 20); }), "K5230");
    EXPECT_EQ(with([](Words& w) { w.x(20); }), "K5493");
    EXPECT_EQ(with([](Words& w) { axis(w, 2, 2500); }).substr(0, 2), "K5");
}

// ------------------------------------------------------------------------------ involutes

Words involute(Function function) { return Words().motion(function); }

TEST(Involutes, BySaidAngleAndBySaidEnd) {
    const Ran by_angle =
        run({line().x(20).y(0).f(500),
             involute(Function::InvoluteCcw).i(-20).j(0).r(8).set(Slot::Opening, 120)});
    EXPECT_EQ(by_angle.codes(), "");
    const auto found = of(by_angle, Op::Involute);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].motion().involute().base_radius, 8, 1e-12);
    EXPECT_NEAR(std::atan2(found[0].motion().to[1], found[0].motion().to[0]),
                120 * std::acos(-1.0) / 180, 1e-12);
    EXPECT_GT(place(found[0]).norm(), 20);
    // The end rounded to the micrometre: the same curve, met exactly.
    const double x = round_to(found[0].motion().to[0], 3);
    const double y = round_to(found[0].motion().to[1], 3);
    const Ran by_end =
        run({line().x(20).y(0).f(500), involute(Function::InvoluteCcw).x(x).y(y).i(-20).j(0).r(8)});
    EXPECT_EQ(by_end.codes(), "");
    const auto met = of(by_end, Op::Involute);
    ASSERT_EQ(met.size(), 1u);
    EXPECT_NEAR(met[0].motion().involute().base_radius, 8, 0.002);
    EXPECT_NE(met[0].motion().involute().base_radius, 8);
    const path::Involute curve = path::make_involute(
        Vec3(20, 0, 0), place(met[0]), met[0].motion().involute().center,
        met[0].motion().involute().normal, met[0].motion().involute().base_radius);
    EXPECT_LT((path::position(curve, curve.length * (1 - 1e-12)) - Vec3(x, y, 0)).norm(), 1e-8);
    // Below zero it runs towards the circle.
    const Ran inwards =
        run({line().x(20).y(0).f(500),
             involute(Function::InvoluteCw).i(-20).j(0).r(8).set(Slot::Opening, -30)});
    EXPECT_EQ(inwards.codes(), "");
    EXPECT_LT(place(of(inwards, Op::Involute).at(0)).norm(), 20);
    EXPECT_TRUE(of(inwards, Op::Involute).at(0).motion().involute().is_clockwise);
}

TEST(Involutes, FollowFramesThatMirrorAndScale) {
    const auto drawn = [](std::vector<Block> head) {
        head.push_back(line().x(20).y(0).f(500));
        head.push_back(
            involute(Function::InvoluteCcw).i(-20).j(0).r(8).set(Slot::Opening, 120).z(5));
        const Ran ran = run(head);
        EXPECT_EQ(ran.codes(), "");
        return of(ran, Op::Involute).at(0);
    };
    const path::Command plain = drawn({});
    const path::Command mirrored = drawn({fn(Function::Mirror, {{1, 0}})});
    EXPECT_NEAR(mirrored.motion().to[1], -plain.motion().to[1], 1e-9);
    EXPECT_TRUE(mirrored.motion().involute().is_clockwise);
    EXPECT_NEAR(mirrored.motion().involute().base_radius, 8, 1e-12);
    const path::Command scaled = drawn({fn(Function::Scale, {{0, 2}})});
    EXPECT_NEAR(scaled.motion().involute().base_radius, 16, 1e-12);
    EXPECT_NEAR(scaled.motion().to[0], 2 * plain.motion().to[0], 1e-9);
    EXPECT_NEAR(scaled.motion().to[2], 10, 1e-12);
    // Under unequal factors it is none any more.
    EXPECT_EQ(run({fn(Function::Scale, {{4, 2}, {5, 1}, {6, 1}}), line().x(20).y(0).f(500),
                   involute(Function::InvoluteCcw).i(-20).j(0).r(8).set(Slot::Opening, 120)})
                  .codes()
                  .substr(0, 2),
              "K5");
}

TEST(Involutes, WhatIsWrong) {
    const auto wrong = [](const Words& words) {
        return run({line().x(20).y(0).f(500), words}).codes();
    };
    const Words ccw_at = involute(Function::InvoluteCcw).i(-20).j(0);
    EXPECT_EQ(wrong(Words(ccw_at).x(0).y(25)), "K5494");
    EXPECT_EQ(wrong(involute(Function::InvoluteCcw).x(0).y(25).r(8)), "K5494");
    EXPECT_EQ(wrong(Words(ccw_at).set(Slot::Opening, 90).r(-8)), "K5495");
    EXPECT_EQ(wrong(Words(ccw_at).set(Slot::Opening, 90).r(20)), "K5489");
    EXPECT_EQ(wrong(Words(ccw_at).set(Slot::Opening, -120).r(8)), "K5489");
    EXPECT_EQ(wrong(Words(ccw_at).x(0).y(25).r(8)), "K5490");
    EXPECT_EQ(wrong(Words(ccw_at).x(0).y(20).r(8)), "K5490");
    EXPECT_EQ(wrong(Words(ccw_at).x(0).y(25).r(8).set(Slot::Opening, 90)).substr(0, 2), "K5");
}

// ------------------------------------------------------------------------------ threads

TEST(VaryingThreads, SayPitchAndChangeAlongTheWay) {
    Words grows = through(Function::ThreadIncreasing).z(-20).k(1.5);
    grows.fn(Function::ThreadChange, {{0, 0.1}});
    Words falls = through(Function::ThreadDecreasing).x(8).z(-26).i(3);
    falls.fn(Function::ThreadChange, {{0, 0.1}});
    const Ran ran = run({line().x(0).y(0).z(0).f(500), grows, falls});
    EXPECT_EQ(ran.codes(), "");
    const auto threads = of(ran, Op::Thread);
    ASSERT_EQ(threads.size(), 2u);
    EXPECT_EQ(threads[0].motion().feed, 1.5);
    EXPECT_EQ(threads[0].motion().thread().pitch_change, 0.1);
    // Along the taper of 8 and 6 a turn is as much longer as the way is; X is the longer one.
    EXPECT_EQ(threads[1].motion().feed, 3.75);
    EXPECT_EQ(threads[1].motion().thread().pitch_change, -0.125);
    EXPECT_EQ(threads[1].motion().feed_mode, path::FeedMode::PerRevolution);
    // An even thread behind it is even.
    const auto even =
        of(run({line().x(0).y(0).z(0).f(500), grows, through(Function::Thread).z(-30).k(2)}),
           Op::Thread);
    ASSERT_EQ(even.size(), 2u);
    EXPECT_EQ(even[1].motion().thread().pitch_change, 0);
}

TEST(VaryingThreads, WhatIsWrong) {
    const auto wrong = [](Function function, double pitch, std::optional<double> change) {
        Words words = through(function).z(-20).k(pitch);
        if (change) words.fn(Function::ThreadChange, {{0, *change}});
        return codes({words});
    };
    EXPECT_EQ(wrong(Function::ThreadIncreasing, 1.5, {}), "K5491");
    // 2² − 2·0.1·20 = 0: nothing is left at the end; a little less change leaves something.
    EXPECT_EQ(wrong(Function::ThreadDecreasing, 2, 0.1), "K5492");
    EXPECT_EQ(wrong(Function::ThreadIncreasing, 2, -0.1), "K5492");
    EXPECT_EQ(wrong(Function::ThreadDecreasing, 2, 0.099), "");
}

// ------------------------------------------------------------------------------ neighbours

struct Neighbour {
    const char* name;
    Words words;
    double tolerance = 1e-6;  // of the tangents
};

Words polynomials(std::initializer_list<double> x, std::initializer_list<double> y) {
    Words words = poly();
    axis(words, 1, *x.begin(), {x.begin() + 1, x.end()});
    axis(words, 2, *y.begin(), {y.begin() + 1, y.end()});
    return words;
}

/// Every motion that has a direction of its own, from (20, 0).
std::vector<Neighbour> neighbours() {
    Words conic = polynomials({30, 3}, {5, -2, 4});
    conic.fn(Function::PolynomialWeight, {{0, 2}, {1, 0.5}});
    return {{"line", line().x(30).y(7)},
            {"line upwards", line().x(30).y(7).z(4)},
            {"line by distances", line().x(9).y(-4).fn(Function::Incremental)},
            {"polar line", line().set(Slot::PolarAngle, 30).set(Slot::PolarRadius, 50)},
            {"polar arc", ccw().set(Slot::PolarAngle, 70).set(Slot::PolarRadius, 20)},
            {"arc about a centre", cw().x(40).y(0).i(10).j(0)},
            {"whole circle", ccw().i(10).j(5)},
            {"arc of a radius", ccw().x(33).y(9).r(40)},
            {"arc of an opening", ccw().x(33).y(9).set(Slot::Opening, 70)},
            {"arc of an opening about a centre", cw().i(3).j(8).set(Slot::Opening, 70)},
            {"helix", ccw().x(40).y(0).z(12).i(10).j(0)},
            {"helix of turns", cw().x(40).y(0).z(-30).i(10).j(0).set(Slot::Turns, 3)},
            {"arc over a point", through(Function::ArcThrough)
                                     .x(40)
                                     .y(3)
                                     .z(2)
                                     .set(Slot::ThroughX, 28)
                                     .set(Slot::ThroughY, 9)
                                     .set(Slot::ThroughZ, 5)},
            {"polynomials", polynomials({30, 3, -1}, {5, 20, -7, 2})},
            // Where a curve's slope vanishes its tangent is that of a place beside.
            {"polynomials that begin at rest", polynomials({40, 20}, {6, 2, 4}), 1e-3},
            {"polynomials by a divisor", conic},
            {"control points",
             through(Function::Spline).x(30).y(9).fn(Function::SplineDegree, {{0, 1}})},
            {"involute", involute(Function::InvoluteCcw).i(-20).j(0).r(8).set(Slot::Opening, 120)},
            {"involute inwards",
             involute(Function::InvoluteCw).i(-20).j(0).r(8).set(Slot::Opening, -30)}};
}

/// The tangents of two commands where they meet.
struct Meeting {
    Vec3 in = Vec3::Zero();
    Vec3 out = Vec3::Zero();
};

/// Between command `i` and the one behind it, from where `start` is.
Meeting meeting_behind(const Ran& ran, std::size_t i, Vec3 start) {
    std::vector<path::Curve> ways;
    for (const path::Command& command : ran.commands) {
        if (!command.is_motion()) continue;
        ways.push_back(path::curve_of(command.motion(), start, place(command)));
        start = place(command);
    }
    if (i + 1 >= ways.size()) return {};
    return {path::evaluate(ways[i], path::arc_length(ways[i])).tangent,
            path::evaluate(ways[i + 1], 0).tangent};
}

/// Under frames of every kind the spline ends as the block behind it begins, and begins as the one
/// before it ends: as these are executed, not as their words say.
TEST(SplineNeighbours, TakeTheirDirections) {
    const std::vector<std::vector<Block>> heads = {
        {},
        {fn(Function::Shift, {{0, 3}, {1, -7}}), fn(Function::Rotate, {{0, 40}})},
        {fn(Function::Mirror, {{0, 0}})}};
    for (const auto& head : heads) {
        for (const Function kind : {Function::AkimaSpline, Function::CubicSpline}) {
            for (const Neighbour& next : neighbours()) {
                SCOPED_TRACE(next.name);
                std::vector<Block> blocks = head;
                for (const Words& words :
                     {line().x(0).y(0).z(0).f(500), start_end(through(kind).x(10).y(10), 0, 2),
                      at(20, 0), next.words, line().x(60).y(60).z(0)})
                    blocks.push_back(words);
                const Ran ending = run(blocks);
                EXPECT_EQ(ending.codes(), "");
                const Meeting end = meeting_behind(ending, 2, Vec3(0, 0, 0));
                EXPECT_GT(end.in.norm(), 0.9);
                EXPECT_LT((end.in - end.out).norm(), next.tolerance);

                blocks = head;
                for (const Words& words : {line().x(20).y(0).z(0).f(500), next.words,
                                           start_end(through(kind).x(60).y(50).z(0), 2, 0),
                                           at(70, 80), line().x(90).y(90)})
                    blocks.push_back(words);
                const Ran beginning = run(blocks);
                if (next.words.operator Block().motion == Function::Spline) continue;
                EXPECT_EQ(beginning.codes(), "");
                const Meeting begin = meeting_behind(beginning, 1, Vec3(0, 0, 0));
                EXPECT_LT((begin.in - begin.out).norm(), 1e-6);
            }
        }
    }
}

/// The block behind is executed as if nobody had looked at it before.
TEST(SplineNeighbours, AreNotChangedByBeingLookedAt) {
    for (const Neighbour& next : neighbours()) {
        SCOPED_TRACE(next.name);
        const auto behind = [&](double end) {
            const Ran ran = run({line().x(0).y(0).z(0).f(500),
                                 start_end(through(Function::CubicSpline).x(10).y(10), 0, end),
                                 at(20, 0), next.words, line().x(60).y(60).z(0)});
            const std::string all = ran.listing();
            std::size_t from = 0;
            for (int lines = 0; lines < 3; ++lines) from = all.find('\n', from) + 1;
            return all.substr(from);
        };
        EXPECT_EQ(behind(2), behind(1));
    }
}

TEST(SplineNeighbours, WithoutADirectionOfTheirOwn) {
    const Words first = start_end(through(Function::CubicSpline).x(10).y(10), 1, 2);
    const auto behind = [&](const Words& next) { return codes({first, at(20, 0), next}); };
    EXPECT_EQ(behind(through(Function::ArcTangent).x(30).y(5)), "K5481");
    EXPECT_EQ(behind(through(Function::AkimaSpline).x(30).y(5)), "K5481");
    EXPECT_EQ(behind(line().x(20).y(0)), "K5481");
    EXPECT_EQ(behind(through(Function::Spline).x(20).y(0)), "K5481");
    EXPECT_EQ(behind(line().x(30).fn(Function::PlaneZx)), "K5481");
    // What is wrong with the block itself is said instead.
    EXPECT_EQ(behind(ccw().x(200).y(0).r(3)).find("K5481"), std::string::npos);
    EXPECT_EQ(behind(poly().x(30).fn(Function::PolynomialRange, {{0, 0}})), "K5482");
    EXPECT_EQ(behind(line().set(Slot::PolarAngle, 30).set(Slot::PolarRadius, -5)).find("K5481"),
              std::string::npos);
}

}  // namespace
}  // namespace kadr::interp::curves_test
