// How a block came to be: statement, calls, turns of the loops around it.
#include <gtest/gtest.h>

#include "tests/sema/running.h"

namespace kadr::testing::trace_test {
namespace {

TEST(Trace, CallsAndLoops) {
    RunOptions options;
    options.expand.trace = true;
    const Outcome outcome =
        run("cycle c(int n) {\n"
            "    for (int k = 0; k < n; k++) X=k;\n"
            "    Y1;\n"
            "}\n"
            "program p() {\n"
            "    for (int i = 0; i < 2; i++) {\n"
            "        c(2);\n"
            "    }\n"
            "    Z1;\n"
            "}\n",
            options);
    EXPECT_EQ(outcome.all_blocks(), "X0\nX1\nY1\nX0\nX1\nY1\nZ1");
    const std::vector<std::vector<std::uint64_t>> counts = {{1, 1}, {1, 2}, {1}, {2, 1},
                                                            {2, 2}, {2},    {}};
    ASSERT_EQ(outcome.traces.size(), counts.size());
    for (std::size_t i = 0; i < counts.size(); ++i) {
        SCOPED_TRACE(i);
        EXPECT_EQ(outcome.traces[i].loop_counts, counts[i]);
        EXPECT_EQ(outcome.traces[i].calls.size(), i < 6 ? 1u : 0u);
    }
}

}  // namespace
}  // namespace kadr::testing::trace_test
