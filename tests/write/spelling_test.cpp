// How a control says something: work offsets, what the head of its programs has said, words that
// no text has, and why a form of an example was passed over.
#include "write/spelling.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "nc/lost_words.h"
#include "nc/program_head.h"
#include "tests/nc/nc_testing.h"
#include "write/check.h"

namespace kadr::write::spelling_test {

using namespace nc;
namespace testing = nc::testing;

namespace {

TEST(Spelling, WorkOffsetsAreSaidAsTheControlSaysThem) {
    struct Row {
        const char* dialect;
        int number;
        const char* text;
    };
    for (const Row& row : {Row{"sinumerik", 0, "G500"},
                           {"sinumerik", 1, "G54"},
                           {"sinumerik", 4, "G57"},
                           {"sinumerik", 5, "G505"},
                           {"sinumerik", 99, "G599"},
                           {"axioma", 5, "G505"},
                           {"fanuc", 6, "G59"},
                           {"fanuc", 7, "G54.1 P1"},
                           {"fanuc", 0, ""},
                           {"sinumerik", 100, ""}}) {
        EXPECT_EQ(spelling_of_offset(testing::shipped(row.dialect), row.number), row.text)
            << row.dialect << ' ' << row.number;
    }
}

/// A dialect of its own, written to a file for the time of a test.
std::optional<Dialect> dialect_of(const std::string& body, Sources& sources,
                                  DiagnosticList& messages) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("kadr_spelling_" + std::to_string(::getpid()));
    std::ofstream(file)
        << "<dialect name=\"mine\" extends=\"iso\" title=\"Mine\" suffix=\"nc\">\n" + body +
               "\n</dialect>\n";
    std::optional<Dialect> dialect =
        load_dialect(file.string(), testing::dialect_folders(), sources, messages);
    std::filesystem::remove(file);
    return dialect;
}

TEST(Spelling, TheOffsetOfTheHeadIsReadThere) {
    EXPECT_EQ(offset_of_head(testing::shipped("sinumerik")), 1);
    EXPECT_EQ(offset_of_head(testing::shipped("axioma")), 1);
    EXPECT_EQ(offset_of_head(testing::shipped("fanuc")), 1);
    for (const auto& [start, offset] :
         {std::pair("G17 G90 G500", std::optional(0)), std::pair("G56 G17 G90", std::optional(3)),
          std::pair("G17 G90", std::optional<int>())}) {
        Sources sources;
        DiagnosticList messages;
        const auto dialect = dialect_of(
            "<program><start>" + std::string(start) + "</start><finish>M30</finish></program>",
            sources, messages);
        ASSERT_TRUE(dialect) << testing::rendered(messages, sources);
        EXPECT_EQ(offset_of_head(*dialect), offset) << start;
    }
}

TEST(Spelling, LostWordsAreNamedAsTheControlSpellsThem) {
    struct Row {
        const char* dialect;
        std::vector<const char*> words;
        const char* text;
    };
    for (const Row& row : {Row{"fanuc", {"G5.1", "Q1"}, "G05.1 Q1"},
                           {"fanuc-lathe", {"G5.1", "Q1", "R3"}, "G05.1 Q1 R3"},
                           {"fanuc", {"G22", "X1", "Y1", "Z1", "I0", "J0", "K0"}, "G22"},
                           {"fanuc", {"M96", "P100"}, "M96"},
                           {"fanuc", {"G5", "P10000"}, "G05 P10000"}}) {
        std::vector<SourceWord> words;
        for (const char* word : row.words) words.push_back(testing::source_word(word));
        const std::vector<LostWord> lost = lost_words(testing::shipped(row.dialect), words);
        ASSERT_EQ(lost.size(), 1u) << row.text;
        EXPECT_EQ(lost[0].text, row.text);
    }
}

/// The notes of the one message that an example gets.
std::string notes_of(const Dialect& dialect, const char* source, const char* text) {
    Example example;
    example.source = source;
    example.text = text;
    const std::vector<Block> blocks = {testing::source_block(testing::shipped("iso"), source)};
    DiagnosticList messages;
    check_example(dialect, example, blocks, messages);
    EXPECT_EQ(testing::codes(messages), "K4015") << source;
    std::string notes;
    if (messages.all().empty()) return notes;
    for (const Diagnostic::Note& note : messages.all()[0].notes)
        notes += (notes.empty() ? "" : "\n") + note.text;
    return notes;
}

TEST(Spelling, ExamplesSayWhyAFormWasPassedOver) {
    Sources sources;
    DiagnosticList messages;
    const auto dialect = dialect_of(
        "<command name=\"dwell\">\n<form when=\"time 1..9\">G4 F{time}</form>\n"
        "<form>G4 P{time}</form>\n<form>G4 S{revolutions}</form>\n</command>\n"
        "<command name=\"work_offset\">\n<form when=\"number 1..4\">G{number+53}</form>\n"
        "<form>G500 P{number}</form>\n</command>",
        sources, messages);
    ASSERT_TRUE(dialect) << testing::rendered(messages, sources);
    EXPECT_EQ(notes_of(*dialect, "dwell(time: 0.5s);", "G4 F0.5"),
              "`G4 F{time}` is not taken: `time` is 0.5, not 1 to 9");
    EXPECT_EQ(notes_of(*dialect, "dwell(revolutions: 3);", "G4 P3"),
              "`G4 F{time}` is not taken: `time` is not given, `revolutions` has no place in it\n"
              "`G4 P{time}` is not taken: `time` is not given, `revolutions` has no place in it");
    EXPECT_EQ(notes_of(*dialect, "work_offset(number: 6);", "G59"),
              "`G{number+53}` is not taken: `number` is 6, not 1 to 4");
    // The form that was expected is the one that is written: nothing to say.
    EXPECT_EQ(notes_of(*dialect, "dwell(time: 2s);", "G4 F3"), "");
}

}  // namespace
}  // namespace kadr::write::spelling_test
