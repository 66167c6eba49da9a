// Errors while a program runs: the place, and who called whom.
#include <gtest/gtest.h>

#include "tests/sema/running.h"

namespace kadr::testing::faults_test {
namespace {

TEST(Faults, StandWhereTheyHappen) {
    struct Row {
        const char* source;
        const char* message;
    };
    const Row rows[] = {
        {"program p(int n = 0) { X1; X=1/n; }", "1:30 K3101 division by zero"},
        {"program p(int n = 0) { X=5 % n; }", "1:26 K3101 division by zero"},
        {"program p(real n = 2) { X=asin(n)/1deg; }",
         "1:27 K3101 the argument of an arc function is outside of -1 to 1"},
        {"program p(real n = 0) { X=ln(n); }",
         "1:27 K3101 the logarithm of a number that is not positive"},
        {"program p(angle a = 90) { X=tan(a); }", "1:29 K3101 the tangent of a right angle"},
        {"program p(real n = -8) { X=pow(n, 0.5); }",
         "1:28 K3101 a fractional power of a negative number"},
        {"program p(real n = 1000) { X=exp(n); }",
         "1:30 K3101 the result is too large for a number"},
        // The least whole number: its amount, and what is left of it, would be one too many.
        {"program p(int n = -9223372036854775807) { n -= 1; X=abs(n); }",
         "1:53 K3102 the whole number leaves 64 bits"},
        {"program p(int n = -9223372036854775807) { n -= 1; X=-n; }",
         "1:53 K3102 the whole number leaves 64 bits"},
        {"program p(int n = -1) { int[] a = {1}; X=a[n]; }",
         "1:42 K3106 there is no element -1; the array has 1"},
        {"program p(int n = 5) { int[] a = {1}; a[n] = 2; }",
         "1:39 K3106 there is no element 5; the array has 1"},
        {"program p() { int[] a; a.pop(); }", "1:24 K3111 the array is empty"},
        {"program p(int n = 9) { int[] a; a.insert(n, 1); }",
         "1:33 K3106 there is no element 9; the array has 1"},
        {"program p(int n = 1) { int[3] a; X=a[n]; }", "1:36 K3104 `a[n]` is not given"},
        {"program p(int n = 1) { length x; if (n > 5) x = 1; X=x; }",
         "1:54 K3104 `x` is not given"},
        {"program p() { G0 Z5; raw \"X\"; Z=position.z; }",
         "1:33 K3105 the position of Z is not known here"},
        // Another zero point, which one knows the control; data of one that does not act are none.
        {"program p() { G54; G0 X5; work_offset_data(number: 2, x: 1mm); X=position.x; "
         "work_offset_data(number: 1, x: 1mm); X=position.x; }",
         "1:117 K3105 the position of X is not known here"},
        // One axis moves in machine coordinates: two of a rotated plane.
        {"program p() { G0 X0 Y0; rotate(30deg); G53 G0 X5; Y=position.y; }",
         "1:53 K3105 the position of Y is not known here"},
        {"program p(length? b) { X=b; }", "1:26 K3104 `b` is not given"},
        {"program p() { point q = {1mm}; X=q.y; }", "1:34 K3104 `q.y` is not given"},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.source);
        const Outcome outcome = run(row.source);
        EXPECT_EQ(outcome.all_messages(), row.message);
    }
}

/// Why a position is not known, and by which statement.
TEST(Faults, NameWhatHasLostAPosition) {
    struct Row {
        const char* source;
        const char* note;
    };
    for (const auto& [source, note] : {Row{"program p() { G0 X1; T1 M6; X=position.x; }",
                                           "1:22 behind this block the control alone knows it"},
                                       Row{"program p() { G0 X1; / X2; X=position.x; }",
                                           "1:22 nobody knows whether this block is executed"},
                                       Row{"program p() { G0 X1; raw \"G4\"; X=position.x; }",
                                           "1:22 nobody knows what this text changes"}}) {
        const Outcome outcome = run(source);
        EXPECT_EQ(outcome.notes, std::vector<std::string>{note}) << source;
    }
}

TEST(Faults, AnUnfinishedBlockIsNotDelivered) {
    const Outcome outcome =
        run("program p(length d = 1mm) { X1; for (int i = 0; i < 60; i++) d *= 2; X5 Y=d; }");
    EXPECT_EQ(outcome.all_messages(), "1:70 K3101 the result is too large for a number");
    EXPECT_EQ(outcome.all_blocks(), "X1");
}

TEST(Faults, NameTheCallers) {
    const Outcome outcome =
        run("length inner(real x) { return 1mm/x; }\n"
            "length outer(real x) { return inner(x); }\n"
            "program p() {\n"
            "    X1;\n"
            "    X=outer(0);\n"
            "    X2;\n"
            "}\n");
    EXPECT_EQ(outcome.messages, std::vector<std::string>{"1:31 K3101"});
    EXPECT_EQ(outcome.notes, (std::vector<std::string>{"2:31 `inner` was called here",
                                                       "5:7 `outer` was called here"}));
    EXPECT_EQ(outcome.blocks, std::vector<std::string>{"X1"});
}

TEST(Faults, RequireStandsAtTheCaller) {
    const Outcome outcome =
        run("cycle c(int n) {\n"
            "    require(n > 0, \"n must be positive, not {n}\");\n"
            "    X=n;\n"
            "}\n"
            "program p() {\n"
            "    c(-5);\n"
            "}\n");
    EXPECT_EQ(outcome.all_messages(), "6:5 K3301 n must be positive, not -5");
    EXPECT_EQ(outcome.notes, std::vector<std::string>{"2:5 `c` requires this"});
    // Without a text, the condition says it; in a program the require itself is the place.
    EXPECT_EQ(run("program p(int n = 0) { require(n > 0); }").all_messages(),
              "1:24 K3301 `n > 0` does not hold");
}

TEST(Faults, MessagesOfTheAuthor) {
    const Outcome outcome =
        run("program p(int n = 3) { warn(\"n is {n}\"); X1; assert(n == 3); error(\"end\"); X2; }");
    EXPECT_EQ(outcome.all_messages(), "1:24 K3304 n is 3\n1:62 K3303 end");
    EXPECT_EQ(outcome.all_blocks(), "X1");
}

}  // namespace
}  // namespace kadr::testing::faults_test
