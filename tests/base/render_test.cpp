// How a diagnostic looks to a person and to a program.
#include "base/render.h"

#include <gtest/gtest.h>

#include "base/diagnostics/driver.h"

namespace render_test {

namespace {

struct Fixture {
    kadr::Sources sources;
    kadr::DiagnosticList list;
    kadr::FileId file = sources.add("part.kadr", "units mm;\n  G1 Ж=10*i;\n");
    kadr::SourceRange word() const { return {file, 15, 22}; }
};

TEST(Render, TextWithCaretNoteAndFix) {
    Fixture f;
    f.list.report(kadr::diag::FileUnreadable, f.word())
        .arg("a.kadr")
        .note({f.file, 0, 5}, "units are set here")
        .fix({f.file, 22, 22}, " F200", "give the block a feed");
    EXPECT_EQ(kadr::render_text(f.list.all()[0], f.sources),
              "part.kadr:2:6: error[K9001]: cannot read `a.kadr`\n"
              "   2 |   G1 Ж=10*i;\n"
              "     |      ^~~~~~\n"
              "part.kadr:1:1: note: units are set here\n"
              "  fix: give the block a feed: `G1 Ж=10*i F200;`\n");
}

TEST(Render, AlarmShowsTheControlsOwnNumber) {
    Fixture f;
    f.list.report(kadr::diag::FileUnreadable, kadr::TextLocation{"O1.nc", 7, 3, 2, "N1 G2"})
        .arg("x")
        .alarm("PS0020", "OVER TOLERANCE OF RADIUS");
    EXPECT_EQ(kadr::render_text(f.list.all()[0], f.sources),
              "O1.nc:7:3: alarm[PS0020]: OVER TOLERANCE OF RADIUS: cannot read `x`\n"
              "   7 | N1 G2\n"
              "     |   ^~\n");
    EXPECT_TRUE(f.list.has_errors());
}

TEST(Render, LongLinesAreShownAroundTheCaret) {
    Fixture f;
    f.list.report(kadr::diag::FileUnreadable,
                  kadr::TextLocation{"a.nc", 1, 100001, 1,
                                     std::string(100000, 'X') + "?" + std::string(5000, 'Y')});
    EXPECT_LT(kadr::render_text(f.list.all()[0], f.sources).size(), 500u);
    EXPECT_NE(kadr::render_text(f.list.all()[0], f.sources).find("XXX?YYY"), std::string::npos);
}

/// The column of the caret under the letter `x` of a line.
std::size_t caret_under_x(const std::string& line) {
    Fixture f;
    const kadr::FileId file = f.sources.add("wide.kadr", line);
    const auto at = static_cast<std::uint32_t>(line.find('x'));
    f.list.report(kadr::diag::FileUnreadable, kadr::SourceRange{file, at, at + 1});
    const std::string text = kadr::render_text(f.list.all()[0], f.sources);
    const std::size_t mark = text.rfind('\n', text.find('^'));
    return text.find('^') - mark - std::string_view("\n     | ").size();
}

// A mark on a letter takes no column, a letter of East Asia two, a tab is shown as one blank.
TEST(Render, CaretStandsBehindWideLetters) {
    EXPECT_EQ(caret_under_x("abx"), 2u);
    EXPECT_EQ(caret_under_x("\tx"), 1u);
    EXPECT_EQ(caret_under_x("\xE6\x97\xA5\xE6\x9C\xACx"), 4u);
    EXPECT_EQ(caret_under_x("e\xCC\x81x"), 1u);
    EXPECT_EQ(caret_under_x("\xC3\xA9x"), 1u);
}

// A fix that inserts replaces nothing; one in words has no place.
TEST(Render, JsonTellsEditsFromWords) {
    Fixture f;
    const kadr::SourceRange word = f.word();
    f.list.report(kadr::diag::FileUnreadable, word)
        .fix({word.file, word.begin, word.begin}, "=", "insert")
        .fix("think");
    const std::string json = kadr::render_json(f.list.all()[0], f.sources);
    EXPECT_NE(json.find("\"fixes\":[{\"file\":\"part.kadr\",\"line\":2,\"column\":6,\"end_line\":2,"
                        "\"end_column\":6,\"replacement\":\"=\",\"text\":\"insert\"},"
                        "{\"text\":\"think\"}]"),
              std::string::npos)
        << json;
}

TEST(Render, JsonIsOneObjectALine) {
    Fixture f;
    f.list.report(kadr::diag::FileUnreadable, f.word()).arg("a\"b");
    EXPECT_EQ(kadr::render_json(f.list.all()[0], f.sources),
              "{\"file\":\"part.kadr\",\"line\":2,\"column\":6,\"end_line\":2,\"end_column\":12,"
              "\"severity\":\"error\","
              "\"code\":\"K9001\",\"message\":\"cannot read `a\\\"b`\",\"notes\":[],\"fixes\":[]}");
}

}  // namespace

}  // namespace render_test
