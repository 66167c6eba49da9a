// Telling a Kadr program from ISO-7bit text, and the map from lines to statements.
#include <memory>

#include <gtest/gtest.h>

#include "driver/cycles.h"
#include "driver/file_text.h"
#include "driver/line_map.h"
#include "tests/common/inputs.h"

namespace text_test {

namespace {

using namespace kadr;
using namespace kadr::driver;

TEST(Source, IsToldByItsLooks) {
    struct Row {
        const char* name;
        const char* text;
        bool is_kadr;
    };
    for (const Row& row : {
             Row{"program", "program p() {\n", true},
             Row{"comment before",
                 "// a (note) with \"quotes\"\n/* more */\nunits mm;\ncycle c(length d) { }", true},
             Row{"other language", "language ru;\nцикл ц() {\n", true},
             Row{"FANUC", "%\nO0001(A {CURLY} NAME)\nG0 X[#1+2]\n%\n", false},
             Row{"SINUMERIK", "; a {comment}\nMSG(\"{text}\")\nN10 X=R1*(2+3)\n", false},
             Row{"empty", "", false},
         }) {
        EXPECT_EQ(looks_like_kadr(row.text), row.is_kadr) << row.name;
    }
}

TEST(Source, IsToldByItsName) {
    EXPECT_TRUE(is_kadr_name("parts/a.kadr"));
    EXPECT_TRUE(is_kadr_name("A.KADR"));
    EXPECT_FALSE(is_kadr_name("kadr"));
    EXPECT_FALSE(is_kadr_name("a.kadr.nc"));
}

TEST(LineMap, FindsTheStatementOfALineInFlight) {
    const auto map = std::make_unique<LineMap>();
    map->add(3, 5, SourceId{7});
    EXPECT_EQ(map->find(4), SourceId{7});
    EXPECT_FALSE(map->find(6).is_valid());
    // A line that is long past is forgotten, never taken for another one.
    map->add(4 + (1u << 14), 4 + (1u << 14), SourceId{9});
    EXPECT_FALSE(map->find(4).is_valid());
    EXPECT_EQ(map->find(5), SourceId{7});
}

TEST(LibraryCycles, UnknownCycleIsReported) {
    Sources sources = test::inputs().new_sources();
    std::string words;
    Messages messages(sources, {}, [&words](std::string_view text) { words += text; });
    Session session({}, test::inputs(), sources, messages);
    const nc::Dialect* dialect = session.dialect("iso", {});
    ASSERT_NE(dialect, nullptr) << words;
    LibraryCycles cycles(session, *dialect);
    interp::CycleCall call;
    call.name = "dril";
    EXPECT_EQ(cycles.expand(call), nullptr);
    EXPECT_NE(words.find("K9009"), std::string::npos) << words;
}

}  // namespace

}  // namespace text_test
