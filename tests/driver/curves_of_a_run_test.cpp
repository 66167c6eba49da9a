// Curves over time: of a window of a run.
#include <string>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "tests/driver/scratch.h"

namespace curves_of_a_run_test {

namespace {

using namespace kadr;

class CurvesOfARun : public kadr::test::ScratchFolder {};

TEST_F(CurvesOfARun, AreDrawnForAWindow) {
    save("square.kadr",
         "program p() { tool(1); S1000 M3; F600; G0 X0 Y0 Z5; G1 X10; Y10; X0; Y0; M30; }");
    const auto result = kadr({"run", file("square.kadr"), "--curves", file("c.svg"), "--window",
                              "4.5s..5.5s", "--setpoints", file("c.npy")});
    ASSERT_EQ(result.status, 0) << result.err;
    const std::string svg = read_file(file("c.svg")).value();
    EXPECT_NE(svg.find("square.kadr: the axes over time"), std::string::npos);
    EXPECT_TRUE(read_file(file("c.npy")).value().starts_with("\x93NUMPY"));
    for (const char* wrong : {"3", "5s..4s", "a..b"}) {
        const auto refused =
            kadr({"run", file("square.kadr"), "--curves", file("d.svg"), "--window", wrong});
        EXPECT_EQ(refused.status, 2) << wrong;
        EXPECT_NE(refused.err.find("--window"), std::string::npos) << refused.err;
    }
}

}  // namespace

}  // namespace curves_of_a_run_test
