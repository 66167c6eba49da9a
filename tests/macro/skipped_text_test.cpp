// skipped_text_test.cpp — which parts of a text are left when jumps have passed over it.
#include "macro/skipped_text.h"

#include <string>

#include <gtest/gtest.h>

namespace kadr::macro::skipped_text_test {
namespace {

std::string left_of(PassedText& skipped) {
    std::string text;
    while (const auto part = skipped.take_first()) {
        text += std::to_string(part->begin.offset) + '-' + std::to_string(part->end) + " at " +
                std::to_string(part->begin.line) + "; ";
    }
    return text;
}

LinePosition line(std::uint64_t number) { return {10 * (number - 1), number}; }

TEST(PassedText, IsWhatNoLineOfARunTouches) {
    PassedText skipped;
    skipped.add(line(2), line(7).offset);
    skipped.add(line(9), line(9).offset);  // a jump to the next line
    skipped.add(line(11), line(12).offset);
    skipped.take_out(line(1), line(2));
    skipped.take_out(line(4), line(5));
    skipped.take_out(line(7), line(8));
    EXPECT_EQ(left_of(skipped), "10-30 at 2; 40-60 at 5; 100-110 at 11; ");
}

TEST(PassedText, LosesLinesAtBothItsEnds) {
    PassedText skipped;
    skipped.add(line(2), line(6).offset);
    skipped.take_out(line(2), line(3));
    skipped.take_out(line(5), line(6));
    EXPECT_EQ(left_of(skipped), "20-40 at 3; ");
    skipped.add(line(8), line(9).offset);
    skipped.take_out(line(8), line(9));
    EXPECT_EQ(left_of(skipped), "");
}

}  // namespace
}  // namespace kadr::macro::skipped_text_test
