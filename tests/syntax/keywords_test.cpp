// Files with keywords: the shipped ones are whole, mistakes in others are found with their place.
#include <filesystem>
#include <set>

#include "base/disk_files.h"
#include "base/text.h"
#include "parsing.h"
#include "tests/common/scratch.h"

namespace kadr::syntax::keywords_test {
namespace {

TEST(Keywords, ShippedFilesAreWhole) {
    for (const char* name : {"en", "ru", "uk", "pl"}) {
        const KeywordTable& table = keywords(name);
        EXPECT_EQ(table.name, name);
        std::set<std::string> names;
        for (const auto& [lexeme, keyword] : table.canonical) names.insert(keyword);
        EXPECT_GE(names.size(), 54u) << name;
    }
    EXPECT_EQ(keywords("ru").canonical.at("если"), "if");
    EXPECT_EQ(keywords("en").canonical.at("length"), "length");
}

// The header is read before the table is known, so these two words are listed in header.cpp.
TEST(Keywords, TheHeaderKnowsTheWordsOfAllLanguages) {
    for (const char* name : {"en", "ru", "uk", "pl"}) {
        for (const auto& [lexeme, keyword] : keywords(name).canonical) {
            if (keyword == "language") {
                EXPECT_EQ(scan_header(lexeme + " xx;").language, "xx");
            }
            if (keyword == "dialect") {
                EXPECT_EQ(scan_header(lexeme + " xx;").dialect, "xx");
            }
        }
    }
}

std::string mistakes(const std::string& xml) {
    const std::string path = kadr::testing::scratch("keywords.xml");
    EXPECT_TRUE(write_file_whole(path, xml));
    Sources sources;
    DiagnosticList list;
    const auto table = load_keywords(path, {}, sources, list);
    std::filesystem::remove(path);
    std::string out;
    for (const Diagnostic& diagnostic : list.all()) {
        const LineColumn place = sources.locate(diagnostic.range.file, diagnostic.range.begin);
        out += std::to_string(place.line) + ':' + std::to_string(place.column) + ' ' +
               std::string(diagnostic.row->code) + ' ' + diagnostic.message() + '\n';
    }
    EXPECT_EQ(table.has_value(), list.all().empty());
    return out;
}

TEST(Keywords, Mistakes) {
    const auto inside = [](const std::string& line) {
        return "<language name='xx'>\n  " + line + "\n</language>";
    };
    EXPECT_EQ(mistakes("<language name='xx'>"),
              "1:20 K9101 this is not well-formed XML: start tag and end tag do not match\n");
    EXPECT_EQ(
        mistakes("<words/>"),
        "1:2 K9102 the outermost element is `<words>`, a file with keywords has `<language>`\n");
    EXPECT_EQ(mistakes("<language/>"), "1:2 K9105 `<language>` lacks the attribute `name`\n");
    EXPECT_EQ(mistakes(inside("<word/>")),
              "2:4 K9103 `<word>` has no meaning inside `<language>`\n");
    EXPECT_EQ(mistakes(inside("<keyword name='if'/>")),
              "2:4 K9105 `<keyword>` lacks the attribute `lexeme`\n");
    EXPECT_EQ(mistakes(inside("<keyword name='if' lexeme=''/>")),
              "2:22 K9106 `lexeme` of `<keyword>` is empty\n");
    EXPECT_EQ(mistakes(inside("<keyword name='if' lexeme='ja' word='x'/>")),
              "2:34 K9104 `<keyword>` has no attribute `word`\n");
    EXPECT_EQ(mistakes(inside("<keyword name='iff' lexeme='ja'/>")),
              "2:18 K1306 `iff` is no keyword\n");
    EXPECT_EQ(mistakes(inside("<keyword name='if' lexeme='w razie'/>")),
              "2:30 K1307 `w razie` cannot be a keyword\n");
    EXPECT_EQ(
        mistakes(inside("<keyword name='if' lexeme='ja'/>\n<keyword name='do' lexeme='ja'/>")),
        "3:28 K1308 `ja` is already the lexeme of `if`\n");
    EXPECT_EQ(mistakes(inside("<keyword name='if' lexeme='ja'/>")).substr(0, 54),
              "1:2 K1309 lexemes are missing for `else`, `while`, `do");
}

TEST(Keywords, UnknownLanguage) {
    Sources sources;
    DiagnosticList list;
    EXPECT_FALSE(load_keywords("klingon", kLanguages, sources, list));
    ASSERT_EQ(list.all().size(), 1u);
    EXPECT_EQ(list.all()[0].message(), "there is no keyword language `klingon`");
}

// A language may give words for braces, as the algorithmic languages of schools do.
TEST(Keywords, WordsForBraces) {
    KeywordTable table = keywords("en");
    table.canonical.emplace("begin", "{");
    table.canonical.emplace("end", "}");
    Sources sources;
    DiagnosticList list;
    const FileId file = sources.add("a.kadr", "cycle a() begin if (b) begin M8; end end");
    const Ast ast = parse(sources, file, table, dialect("iso"), list);
    EXPECT_TRUE(list.all().empty());
    EXPECT_EQ(dump(ast), "(cycle a\n  (if b\n    (block\n      (words M8))))");
}

}  // namespace
}  // namespace kadr::syntax::keywords_test
