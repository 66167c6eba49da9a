// The comment that silences a warning.
#include "base/allow.h"

#include <string>

#include <gtest/gtest.h>

namespace kadr::allow_test {
namespace {

std::string codes(std::string_view comment) {
    const Allowance allowance = allowed_codes(comment);
    if (!allowance.is_one) return "no comment for kadr";
    if (!allowance.is_well_formed) return "malformed";
    std::string all;
    for (const std::string_view code : allowance.codes) {
        all += (all.empty() ? "" : " ") + std::string(code);
    }
    return all;
}

TEST(Allow, CodesAndReason) {
    EXPECT_EQ(codes(" kadr: allow K2501 the setter reads it"), "K2501");
    EXPECT_EQ(codes("kadr: allow K2501, K2502: both are meant"), "K2501 K2502");
    EXPECT_EQ(codes(" kadr: allow K2501\r"), "K2501");
    EXPECT_EQ(codes(" what kadr: allow K2501 means"), "no comment for kadr");
    EXPECT_EQ(codes(" kadr: allow"), "malformed");
    EXPECT_EQ(codes(" kadr: allow all"), "malformed");
    EXPECT_EQ(codes(" kadr: silence K2501"), "malformed");
}

}  // namespace
}  // namespace kadr::allow_test
