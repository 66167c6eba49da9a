// How the feed comes to F, as commands carry it: by powers of the part of their way.
#include <gtest/gtest.h>

#include "tests/interp/bench.h"

namespace kadr::interp::feed_characteristics_test {
namespace {

using Law = std::array<double, 4>;

Words course(int kind) { return fn(Function::FeedCourse, {{0, kind}}); }

/// The law of a motion; all 0 where F is its feed.
Law law_of(const path::Command& command) {
    return !command.motion().dynamics ? Law{} : command.motion().dynamics->law.feed;
}

void expect_laws(const Ran& ran, const std::vector<Law>& expected) {
    ASSERT_EQ(ran.commands.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        for (std::size_t k = 0; k < 4; ++k)
            EXPECT_NEAR(law_of(ran.commands[i])[k], expected[i][k], 1e-9) << i << " p^" << k;
    }
}

TEST(FeedCharacteristics, LinearBeginsWithTheFeedBefore) {
    const Ran ran = run({
        line().x(10).f(100),
        course(1).x(20).f(300),
        line().x(30),
        line().x(40).f(200),
        rapid().x(50),
        line().x(60).f(250),
        course(0).x(70).f(400),
    });
    expect_laws(ran, {{}, {100, 200, 0, 0}, {}, {300, -100, 0, 0}, {}, {200, 50, 0, 0}, {}});
}

/// A feed that no motion has had is none to begin with; and none of another mode is.
TEST(FeedCharacteristics, WithoutAFeedBeforeFIsConstant) {
    const Ran ran = run({
        course(1).motion(Function::Line).x(10).f(100),
        fn(Function::FeedInverseTime).x(20).f(5),
        line().x(30).f(8),
        fn(Function::FeedPerRevolution).x(40).f(0.1),
        line().x(50).f(0.3),
    });
    expect_laws(ran, {{}, {}, {5, 3, 0, 0}, {}, {}});
}

TEST(FeedCharacteristics, PolynomialsOfOneBlock) {
    const Ran ran = run({
        line().x(10).f(100),
        fn(Function::FeedPolynomial, {{0, 300}, {1, -50}, {2, 20}}).x(20),
        line().x(30),
    });
    // 100 + lin − 50 + 20 = 300
    expect_laws(ran, {{}, {100, 230, -50, 20}, {}});
    EXPECT_EQ(ran.commands[2].motion().feed, 300);
}

/// Through 100 at the start and 200, 100 at the ends of blocks of 10 mm, without curvature at the
/// ends: slopes 15, 0, −15 by the mm of 10 mean ones.
TEST(FeedCharacteristics, ASplineThroughTheFeeds) {
    const Ran ran = run({
        line().x(10).f(100),
        course(2).x(20).f(200),
        line().x(30).f(100),
        course(0).x(40),
    });
    expect_laws(ran, {{}, {100, 150, 0, -50}, {200, 0, -150, 50}, {}});
}

/// What a window holds makes the same spline as the whole: where it is cut feed and slope go on.
TEST(FeedCharacteristics, ALongSplineHasNoSeam) {
    std::vector<Block> program = {line().x(1).f(1000)};
    program.push_back(course(2).x(2).f(1100));
    for (int i = 3; i < 300; ++i) program.push_back(line().x(i).f(1000 + 100 * (i % 3)));
    const Ran ran = run(program);
    ASSERT_EQ(ran.commands.size(), 299u);
    for (std::size_t i = 2; i < ran.commands.size(); ++i) {
        const Law a = law_of(ran.commands[i - 1]);
        const Law b = law_of(ran.commands[i]);
        EXPECT_NEAR(a[0] + a[1] + a[2] + a[3], b[0], 1e-9) << i;
        EXPECT_NEAR(a[1] + 2 * a[2] + 3 * a[3], b[1], 1e-9) << i;
        EXPECT_NEAR(2 * a[2] + 6 * a[3], 2 * b[2], 1e-9) << i;
    }
}

/// The motions of a block share its course by their lengths.
TEST(FeedCharacteristics, AChamferIsAPartOfItsBlock) {
    const Ran ran = run({
        line().x(10).f(100),
        course(1).x(20).f(300).fn(Function::CornerChamfer, {{0, 2}}),
        line().y(10),
        line().y(20).f(400),
    });
    double at = 100;
    for (const path::Command& command : ran.commands) {
        const Law law = law_of(command);
        if (law == Law{}) continue;
        EXPECT_NEAR(law[0], at, 1e-9);
        at = law[0] + law[1];
    }
    EXPECT_NEAR(at, 400, 1e-9);
}

TEST(FeedCharacteristics, AFeedThatFallsTo0IsAnAlarm) {
    const Ran ran = run({
        line().x(10).f(100),
        fn(Function::FeedPolynomial, {{0, 100}, {1, 800}}).x(20),
        line().x(30),
    });
    EXPECT_EQ(ran.codes(), "K5734");
    EXPECT_EQ(ran.commands.size(), 1u);
}

}  // namespace
}  // namespace kadr::interp::feed_characteristics_test
