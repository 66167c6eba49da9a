// What `kadr explain` shows as right is right: every example of a row about a source is checked and
// written for the controls that it is meant for, as a user would who types it in.
//
// An example that begins with a declaration is a file. Anything else is a piece of a program, and
// stands here in one with a tool, a spindle, a feed and a place, and with the names of kNames. A
// remark in brackets behind it, `(for a FANUC)`, says which controls are meant; else it is all.
// tests/sema/examples_test.cpp holds the rows K2 and K3 to one message for each mistake.
#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/diagnostic.h"
#include "base/disk_files.h"
#include "base/text.h"
#include "tests/common/examples.h"
#include "tests/common/messages.h"
#include "tests/common/process.h"
#include "tests/common/scratch.h"

namespace row_examples_test {

namespace {

namespace fs = std::filesystem;
using kadr::DiagnosticRow;
using kadr::testing::Message;

const std::vector<std::string> kControls = {"iso", "sinumerik", "fanuc", "axioma"};

/// What a piece of a program may use without declaring it.
constexpr std::string_view kNames =
    "length a = 20mm, length b = 4mm, length x = 5mm, length y = 6mm, int n = 4";

struct Example {
    std::string text;
    std::vector<std::string> controls;
};

/// The controls that the remark behind an example names.
std::vector<std::string> controls_of(std::string_view remark) {
    const auto has = [&](const char* word) { return remark.find(word) != std::string_view::npos; };
    if (has("FANUC lathe")) return {"fanuc-lathe"};
    if (has("FANUC")) return {"fanuc"};
    if (has("SINUMERIK")) return {"sinumerik"};
    return kControls;
}

bool is_file(const std::string& text) {
    static const std::set<std::string> heads = {
        "program", "cycle", "curve",    "contour", "test",  "property", "import",
        "struct",  "enum",  "language", "dialect", "units", "#include"};
    std::istringstream words(text);
    std::string first;
    words >> first;
    const std::string word = first.substr(0, first.find(';'));
    return heads.contains(word) || text.find("program ") != std::string::npos;
}

/// Nothing if the example is a command line, a table, XML, a text of a control or a remark.
std::optional<Example> example_of(std::string_view shown) {
    const bool is_other = shown.starts_with("kadr ") || shown.starts_with("(") ||
                          shown.starts_with("<") || shown.find("<NUL>") != std::string::npos ||
                          shown.find("…") != std::string::npos;
    if (is_other) return std::nullopt;
    Example example{kadr::testing::text_of(shown), controls_of(kadr::testing::remark_of(shown))};
    if (!is_file(example.text)) {
        example.text = "program example(" + std::string(kNames) +
                       ") {\ntool(1); S1000 M3; F100; G0 X0 Y0 Z20;\n" + example.text +
                       "\nM30;\n}\n";
    }
    return example;
}

/// Rows about what stands in a source; those about its tables need the table and not a program.
bool is_about_source(const DiagnosticRow& row) {
    if (row.code.starts_with("K24")) return kadr::testing::is_program(row.right);
    return row.code.starts_with("K1") || row.code.starts_with("K2") || row.code.starts_with("K3") ||
           row.code.starts_with("K41") || row.code.starts_with("K42");
}

class RowExamples : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = kadr::testing::scratch("rows");
        fs::copy(fs::path(KADR_ROOT) / "tests/sema/tables", folder_);
        save("holes.kadr", "cycle row() { G0 X1; }\n");
    }
    void TearDown() override { fs::remove_all(folder_); }

    void save(const char* name, const std::string& text) {
        ASSERT_TRUE(kadr::write_file_whole((folder_ / name).string(), text));
    }

    std::vector<Message> messages(const std::string& source, const std::string& control) {
        save("example.kadr", source);
        const ProcessResult result =
            run_process({KADR_BINARY, "check", (folder_ / "example.kadr").string(), "-d", control,
                         "--diagnostics", "json"});
        return kadr::testing::messages_of(result.err);
    }

    fs::path folder_;
};

TEST_F(RowExamples, RightOnesAreRightForEveryControlThatTheyAreMeantFor) {
    int count = 0;
    for (const DiagnosticRow* row : kadr::all_diagnostics()) {
        const auto right = is_about_source(*row) ? example_of(row->right) : std::nullopt;
        if (!right) continue;
        ++count;
        for (const std::string& control : right->controls) {
            SCOPED_TRACE(std::string(row->code) + " for " + control);
            for (const Message& message : messages(right->text, control)) {
                EXPECT_TRUE(message.is_warning && message.code != row->code)
                    << right->text << "\nsays " << message.code << ": " << message.words;
            }
        }
    }
    EXPECT_GT(count, 250);
}

TEST_F(RowExamples, WrongOnesCauseTheirMessage) {
    int count = 0;
    for (const DiagnosticRow* row : kadr::all_diagnostics()) {
        const bool is_ours = row->code.starts_with("K1") || row->code.starts_with("K4");
        const auto wrong = is_ours && is_about_source(*row) ? example_of(row->wrong) : std::nullopt;
        if (!wrong) continue;
        ++count;
        std::string text;
        const bool is_caused =
            std::any_of(wrong->controls.begin(), wrong->controls.end(), [&](const auto& control) {
                for (const Message& message : messages(wrong->text, control)) {
                    if (message.code == row->code) return true;
                    text += control + ": " + message.code + ' ' + message.words + '\n';
                }
                return false;
            });
        EXPECT_TRUE(is_caused) << row->code << ": " << wrong->text << "\nsays\n" << text;
    }
    EXPECT_GT(count, 80);
}

/// Rows about tests: the wrong example fails with the row's message, the right one holds.
TEST_F(RowExamples, OfTestsFailAndHoldAsTheySay) {
    int count = 0;
    for (const DiagnosticRow* row : kadr::all_diagnostics()) {
        if (!row->code.starts_with("K7") || row->wrong.starts_with("kadr ")) continue;
        ++count;
        const auto said = [&](std::string_view example) {
            save("example.kadr", std::string(example));
            const ProcessResult result =
                run_process({KADR_BINARY, "test", (folder_ / "example.kadr").string(), "-d",
                             "sinumerik", "--diagnostics", "json"});
            return kadr::testing::messages_of(result.err);
        };
        SCOPED_TRACE(row->code);
        const std::vector<Message> wrong = said(row->wrong);
        EXPECT_TRUE(std::ranges::any_of(wrong, [&](const Message& message) {
            return message.code == row->code;
        })) << row->wrong;
        for (const Message& message : said(row->right)) {
            EXPECT_TRUE(message.is_warning)
                << row->right << "\nsays " << message.code << ": " << message.words;
        }
    }
    EXPECT_GE(count, 10);
}

}  // namespace

}  // namespace row_examples_test
