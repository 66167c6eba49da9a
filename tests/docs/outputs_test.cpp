// What a run puts out is a table (driver/outputs.def): the manual has its entries, and the page on
// motion names its rows.
#include "driver/outputs.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"

namespace outputs_test {

namespace {

using kadr::driver::output_rows;
using kadr::driver::OutputRow;

/// As the manual spells a flag: its hyphens are no dashes.
std::string in_roff(std::string_view flag) {
    std::string out;
    for (const char c : flag) out += c == '-' ? std::string("\\-") : std::string(1, c);
    return out;
}

/// An entry of the manual: from behind its `.TP` to the next one.
struct Entry {
    std::size_t begin = 0;
    std::size_t end = 0;  // equal: there is none
};

Entry entry_of(const std::string& page, std::string_view flag) {
    constexpr std::string_view kHead = "\n.TP\n";
    const std::string name = ' ' + in_roff(flag);
    for (std::size_t at = page.find(kHead); at != page.npos; at = page.find(kHead, at + 1)) {
        const std::size_t begin = at + kHead.size();
        const std::string line = page.substr(begin, page.find('\n', begin) - begin);
        const std::size_t found = line.find(name);
        const bool is_whole = found != line.npos && (found + name.size() == line.size() ||
                                                     line[found + name.size()] == ' ');
        if (!is_whole || !line.starts_with(".B")) continue;
        const std::size_t end = std::min(page.find(kHead, begin - 1), page.find("\n.SH ", begin));
        return {begin, end + 1};
    }
    return {};
}

/// Puts the entry of a row in its place; a new one stands behind that of the row before.
void put_entry(std::string& page, const OutputRow& row, std::string_view flag_before) {
    const std::string text(row.manual.substr(1));  // without the line end that opens it
    const Entry old = entry_of(page, row.flag);
    if (old.end > old.begin) {
        page.replace(old.begin, old.end - old.begin, text);
        return;
    }
    const Entry before = entry_of(page, flag_before);
    ASSERT_GT(before.end, before.begin) << flag_before;
    page.insert(before.end, ".TP\n" + text);
}

/// KADR_UPDATE=1 puts the entries of the table into the manual.
TEST(Outputs, TheManualHasTheEntriesOfTheTable) {
    const std::string file = KADR_ROOT "/docs/kadr.1";
    const std::string page = kadr::read_file(file).value_or("");
    std::string now = page;
    std::string_view before;
    for (const OutputRow& row : output_rows()) {
        put_entry(now, row, before);
        before = row.flag;
    }
    if (std::getenv("KADR_UPDATE") != nullptr) {
        ASSERT_TRUE(kadr::write_file_whole(file, now));
    } else {
        EXPECT_EQ(page, now) << "run with KADR_UPDATE=1 and look at it";
    }
    for (const OutputRow& row : output_rows())
        EXPECT_EQ(entry_of(now, row.flag).begin, now.find(row.manual.substr(1))) << row.flag;
}

/// Outputs have a row in the table of the page on motion; settings are named beside theirs.
TEST(Outputs, ThePageOnMotionHasThem) {
    const std::string page = kadr::read_file(KADR_ROOT "/docs/motion.md").value_or("");
    const std::size_t begin = page.find("## What a run puts out");
    ASSERT_NE(begin, page.npos);
    const std::string chapter = page.substr(begin, page.find("\n## ", begin) - begin);
    for (const OutputRow& row : output_rows()) {
        const std::string flag(row.flag);
        const bool is_setting = row.kind == OutputRow::Kind::Setting;
        EXPECT_NE(chapter.find((is_setting ? "`" : "\n| `") + flag + ' '), page.npos) << flag;
    }
}

}  // namespace

}  // namespace outputs_test
