// Involutes: what the string draws, walked by its length; ends that miss it; the angle that is
// said.
#include "path/involute.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "path/curve.h"

namespace kadr::path::involute_test {
namespace {

/// By the definition: the point of the circle, and back along the tangent by the string.
Vec3 drawn(double radius, double t) {
    const Vec3 on_circle(std::cos(t), std::sin(t), 0);
    const Vec3 along(-std::sin(t), std::cos(t), 0);
    return radius * on_circle - radius * t * along;
}

TEST(Involute, IsWhatTheStringDraws) {
    // Unwinding from t = 1 to t = 5 about the origin, r = 10: s = r·(25 − 1)/2 = 120.
    const Involute involute =
        make_involute(drawn(10, 1), drawn(10, 5), Vec3::Zero(), Vec3::UnitZ(), 10);
    EXPECT_NEAR(involute.length, 120, 1e-12);
    for (const double t : {1.0, 1.7, 3.0, 4.9, 5.0}) {
        const double s = 10 * (t * t - 1) / 2;
        const CurvePoint point = evaluate(involute, s);
        EXPECT_LT((point.position - drawn(10, t)).norm(), 1e-12);
        EXPECT_LT((point.tangent - Vec3(std::cos(t), std::sin(t), 0)).norm(), 1e-12);
        // The string is the radius of curvature.
        EXPECT_NEAR(point.curvature.norm(), 1 / (10 * t), 1e-12);
        EXPECT_NEAR(point.curvature.dot(point.tangent), 0, 1e-15);
    }
    // Clockwise back to the circle: the same points.
    const Involute back =
        make_involute(drawn(10, 5), drawn(10, 1), Vec3::Zero(), -Vec3::UnitZ(), 10);
    EXPECT_NEAR(back.length, 120, 1e-12);
    EXPECT_LT((position(back, 120 - 35) - position(involute, 35)).norm(), 1e-12);
    EXPECT_LT((evaluate(back, 120 - 35).tangent + evaluate(involute, 35).tangent).norm(), 1e-12);
    EXPECT_LT((evaluate(back, 120 - 35).curvature - evaluate(involute, 35).curvature).norm(),
              1e-12);
}

struct AnyInvolute {
    Vec3 center, normal;
    double radius, first, last, height;
    Involute make() const {
        const Vec3 u = normal.unitOrthogonal();
        const Vec3 v = normal.cross(u);
        const auto point = [&](double t, double hand) {
            const Vec3 d = drawn(radius, t);
            return Vec3(center + d.x() * u + hand * d.y() * v);
        };
        // Away from the circle it unwinds counter-clockwise, towards it the other way.
        const double hand = last > first ? 1 : -1;
        return make_involute(point(first, hand), point(last, hand) + height * normal, center,
                             normal, radius);
    }
};

AnyInvolute any_involute() {
    const auto number = [](int from, int to) { return *rc::gen::inRange(from, to) / 100.0; };
    AnyInvolute any;
    any.center = Vec3(number(-9000, 9000), number(-9000, 9000), number(-900, 900));
    any.normal = Vec3(number(-100, 101), number(-100, 101), number(1, 101)).normalized();
    any.radius = number(50, 5000);
    any.first = number(5, 1500);
    any.last = number(5, 1500);
    if (std::fabs(any.first - any.last) < 0.05) any.last += 0.1;
    any.height = *rc::gen::inRange(0, 2) == 0 ? 0 : number(-5000, 5000);
    return any;
}

RC_GTEST_PROP(Involutes, AreWalkedByTheirLength, ()) {
    const Involute involute = any_involute().make();
    constexpr int kSteps = 400;
    const double size = involute.end.norm() + involute.length;
    const Box box = bounds(involute);
    double sum = 0;
    Vec3 before = involute.start;
    for (int i = 1; i <= kSteps; ++i) {
        const double s = involute.length * i / kSteps;
        const CurvePoint point = evaluate(involute, s);
        const Vec3 chord = point.position - before;
        sum += chord.norm();
        before = point.position;
        RC_ASSERT(std::fabs(point.tangent.norm() - 1) < 1e-12);
        RC_ASSERT(((box.lower - point.position).array() < 1e-9 * (1 + size)).all());
        RC_ASSERT(((point.position - box.upper).array() < 1e-9 * (1 + size)).all());
        // The derivatives, by differences.
        const double step = 1e-4 * involute.length / kSteps;
        if (i == kSteps) continue;
        const Vec3 slope =
            (position(involute, s + step) - position(involute, s - step)) / (2 * step);
        RC_ASSERT((slope - point.tangent).norm() < 1e-5 + 1e-10 * size / step);
    }
    RC_ASSERT(sum <= involute.length * (1 + 1e-12));
    RC_ASSERT((position(involute, involute.length * (1 - 1e-12)) - involute.end).norm() <
              1e-8 * (1 + size));
    const double from = involute.length * *rc::gen::inRange(0, 50) / 100;
    const double to = involute.length * *rc::gen::inRange(51, 101) / 100;
    const Involute piece = part(involute, from, to);
    RC_ASSERT(std::fabs(piece.length - (to - from)) < 1e-12 * size);
    for (const double share : {0.0, 0.3, 0.9, 1.0}) {
        RC_ASSERT((position(piece, share * piece.length) -
                   position(involute, from + share * piece.length))
                      .norm() < 1e-9 * (1 + size));
    }
}

RC_GTEST_PROP(Involutes, MeetAnEndThatMissesALittle, ()) {
    AnyInvolute any = any_involute();
    any.height = 0;
    const Involute exact = any.make();
    const InvoluteWords words{exact.start, any.center, any.normal, any.radius};
    const auto same = base_radius_through(words, exact.end, 1e-6);
    RC_ASSERT(same.has_value());
    RC_ASSERT(std::fabs(*same - any.radius) < 1e-9 * any.radius);
    // Aside by a few micrometres, and by too much.
    const Vec3 aside = any.normal.cross(exact.end - any.center).normalized();
    const Vec3 near = exact.end + 0.004 * aside;
    const auto corrected = base_radius_through(words, near, 0.01);
    if (corrected) {
        const Involute met = make_involute(exact.start, near, any.center, any.normal, *corrected);
        RC_ASSERT((position(met, met.length * (1 - 1e-13)) - near).norm() < 1e-8);
    }
    RC_ASSERT(corrected.has_value() || any.radius * std::min(any.first, any.last) < 1);
}

TEST(Involute, SaysWhatIsWrong) {
    const InvoluteWords words{Vec3(20, 0, 0), Vec3::Zero(), Vec3::UnitZ(), 10};
    const auto fault = [&](const InvoluteWords& said, const Vec3& end) {
        const auto radius = base_radius_through(said, end, 0.01);
        return radius ? std::optional<InvoluteFault>() : radius.error();
    };
    EXPECT_EQ(fault({words.start, words.center, words.normal, 0}, {0, 40, 0}),
              InvoluteFault::Radius);
    EXPECT_EQ(fault({words.start, words.center, words.normal, 20}, {0, 40, 0}),
              InvoluteFault::Inside);
    EXPECT_EQ(fault(words, {0, 9, 0}), InvoluteFault::Inside);
    EXPECT_EQ(fault(words, {0, 20, 0}), InvoluteFault::Even);
    EXPECT_EQ(fault(words, {0, 25, 0}), InvoluteFault::EndOff);
}

RC_GTEST_PROP(Involutes, EndUnderTheAngleThatIsSaid, ()) {
    const auto number = [](int from, int to) { return *rc::gen::inRange(from, to) / 100.0; };
    const double radius = number(100, 3000);
    const InvoluteWords words{Vec3(radius * number(101, 900), 0, 7), Vec3(0, 0, -3),
                              *rc::gen::element(Vec3(Vec3::UnitZ()), Vec3(-Vec3::UnitZ())), radius};
    const double opening = number(-300, 2000);
    RC_PRE(opening != 0);
    const auto end = involute_end(words, opening);
    if (!end) {
        RC_ASSERT(opening < 0);
        RC_ASSERT(end.error() == InvoluteFault::Inside);
        return;
    }
    const double seen = std::atan2(words.normal.z() * end->y(), end->x());
    RC_ASSERT(std::fabs(std::remainder(seen - std::fabs(opening), 2 * std::numbers::pi)) < 1e-9);
    RC_ASSERT((end->norm() > words.start.norm()) == (opening > 0));
    const auto through = base_radius_through(words, *end, 1e-6);
    RC_ASSERT(through.has_value() ||
              std::fabs(Vec3(end->x(), end->y(), 0).norm() - words.start.x()) < 1e-5);
    if (through) RC_ASSERT(std::fabs(*through - radius) < 1e-7 * radius);
}

}  // namespace
}  // namespace kadr::path::involute_test
