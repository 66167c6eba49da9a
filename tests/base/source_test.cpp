// Places in texts, files written whole, names that were meant.
#include "base/source.h"

#include <array>
#include <filesystem>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/common/scratch.h"

namespace source_test {

namespace {

TEST(Sources, LocatesInCharactersNotBytes) {
    kadr::Sources sources;
    const kadr::FileId file = sources.add("a",
                                          "\xEF\xBB\xBF"
                                          "ab\r\nЖx\n");
    struct Row {
        std::uint32_t byte, line, column;
    };
    for (const Row& row : {Row{0, 1, 1}, {2, 1, 3}, {4, 2, 1}, {6, 2, 2}, {8, 3, 1}, {99, 3, 1}}) {
        const kadr::LineColumn at = sources.locate(file, row.byte);
        EXPECT_EQ(at.line, row.line) << row.byte;
        EXPECT_EQ(at.column, row.column) << row.byte;
    }
    EXPECT_EQ(sources.line_at(file, 1), "ab");
    EXPECT_EQ(sources.text(kadr::SourceRange{file, 4, 6}), "Ж");
}

TEST(Sources, UnreadableIsNothing) {
    kadr::Sources sources;
    EXPECT_FALSE(sources.read("/no/such/file"));
    EXPECT_FALSE(sources.read("/"));
}

TEST(Text, WritesWholeOrNotAtAll) {
    const std::string path = kadr::testing::scratch("whole.txt");
    ASSERT_TRUE(kadr::write_file_whole(path, "first"));
    ASSERT_TRUE(kadr::write_file_whole(path, "second"));
    EXPECT_EQ(kadr::read_file(path), "second");
    EXPECT_FALSE(kadr::write_file_whole("/no/such/folder/file", "x"));
    std::filesystem::remove(path);
}

TEST(Text, NearestName) {
    const std::array<std::string_view, 3> names = {"radius", "depth", "width"};
    EXPECT_EQ(kadr::nearest_name("raduis", names.data(), names.size()), "radius");
    EXPECT_EQ(kadr::nearest_name("widht", names.data(), names.size()), "width");
    EXPECT_FALSE(kadr::nearest_name("temperature", names.data(), names.size()));
    constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};
    EXPECT_EQ(kadr::nearest_name("Z", kAxes.data(), kAxes.size()), "z");
}

}  // namespace

}  // namespace source_test
