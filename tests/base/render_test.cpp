// How a diagnostic looks to a person and to a program.
#include "base/render.h"

#include <gtest/gtest.h>

#include "base/diagnostics/driver.h"

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
    f.list.report(kadr::diag::FileUnreadable, kadr::LinePlace{"O1.nc", 7, 3, 2, "N1 G2"})
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
                  kadr::LinePlace{"a.nc", 1, 100001, 1,
                                  std::string(100000, 'X') + "?" + std::string(5000, 'Y')});
    EXPECT_LT(kadr::render_text(f.list.all()[0], f.sources).size(), 500u);
    EXPECT_NE(kadr::render_text(f.list.all()[0], f.sources).find("XXX?YYY"), std::string::npos);
}

TEST(Render, JsonIsOneObjectALine) {
    Fixture f;
    f.list.report(kadr::diag::FileUnreadable, f.word()).arg("a\"b");
    EXPECT_EQ(
        kadr::render_json(f.list.all()[0], f.sources),
        "{\"file\":\"part.kadr\",\"line\":2,\"column\":6,\"end_column\":12,\"severity\":\"error\","
        "\"code\":\"K9001\",\"message\":\"cannot read `a\\\"b`\",\"notes\":[],\"fixes\":[]}");
    EXPECT_EQ(kadr::json_string("a\xFF\n\x01"), "\"a\xEF\xBF\xBD\\n\\u0001\"");
}

}  // namespace
