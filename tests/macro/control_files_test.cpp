// Files that a program writes: how much there may be of them. What programs see of them is held by
// programs of tests/control.
#include "macro/control_files.h"

#include <gtest/gtest.h>

namespace kadr::macro::control_files_test {
namespace {

TEST(ControlFiles, AreFullAtSomeTimeAndHaveRoomAgainBehindADeletedOne) {
    ControlFiles files;
    const std::string line(1000, 'x');
    std::size_t lines = 0;
    while (files.write("ONE", line) == ControlFiles::Error::None) ++lines;
    EXPECT_EQ(files.write("TWO", line), ControlFiles::Error::FileFull);
    EXPECT_FALSE(files.has("TWO"));
    // What is taken for a line besides its text is less than a tenth of this one.
    EXPECT_GT(lines, ControlFiles::kMostBytes / 1100);
    ControlFiles::Lines last;
    EXPECT_EQ(files.read("ONE", static_cast<double>(lines), 1, last), ControlFiles::Error::None);
    EXPECT_EQ(last, ControlFiles::Lines{line});
    EXPECT_EQ(files.remove("ONE"), ControlFiles::Error::None);
    EXPECT_EQ(files.write("TWO", line), ControlFiles::Error::None);
}

}  // namespace
}  // namespace kadr::macro::control_files_test
