// Numbers in messages.
#include "base/readable.h"

#include <gtest/gtest.h>

namespace kadr::readable_test {
namespace {

TEST(Readable, IsWhatWasMeant) {
    struct Row {
        double value;
        const char* text;
    };
    for (const Row& row : {
             Row{10, "10"},
             {10.000000001, "10"},
             {0.1 + 0.2, "0.3"},
             {-0.0, "0"},
             {-2.5, "-2.5"},
             {25.4 / 3, "8.466667"},
             {0.000012, "0.000012"},
             {1.0 / 3e4, "0.0000333333"},
             {999999.9999999, "1000000"},
             {123456789.125, "123456789.125"},
             {1e9 + 1.0 / 3, "1000000000.33"},
             {1e-8, "0.00000001"},
             {1e-12, "1e-12"},
             {1e15, "1e+15"},
         }) {
        EXPECT_EQ(readable(row.value), row.text);
    }
}

}  // namespace
}  // namespace kadr::readable_test
