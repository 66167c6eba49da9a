// Failure has one form: what may report answers Done, and what answers bool reports nothing.
#include <cstddef>
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"

namespace done_test {

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = KADR_ROOT;

/// A room whose functions keep to it, and what it reports by besides `report…(` and `warn_of…(`.
struct Room {
    std::string folder;
    std::string more;                   // a pattern; empty: nothing
    std::set<std::string> except = {};  // files that do not keep to it yet
};

const std::vector<Room> kRooms = {
    {"runtime/base", ""},
    {"runtime/macro", ""},
    {"runtime/interp", ""},
    {"compiler/sema", R"(\+\+sink_\.errors)"},
    {"compiler/syntax", ""},
    {"runtime/motion", R"(\bfail_\w+\()"},
    {"runtime/path", R"(\bfail\()"},
    {"runtime/machine", ""},
    {"runtime/process", R"(\brefuse\w*\()"},
    {"runtime/control", ""},
    {"runtime/write", ""},
    {"compiler/driver", ""},
    {"compiler/repl", ""},
    {"compiler/cli", ""},
    {"compiler/expand", R"(\bfault(?:_\w+)?\()"},
    {"runtime/nc", R"(\bfail(?:_\w+)?\(|\bset_fault\w*\(|\bbad_value\()"},
};

/// The functions of a text that answer with bool, each from its head to the end of its body.
std::vector<std::string> questions_of(const std::string& text) {
    static const std::regex head(
        R"((^|\n)( *)(?:\[\[nodiscard\]\] |static |constexpr |inline |virtual |friend )*)"
        R"(bool (?:\w+::)*\w+\()");
    std::vector<std::string> questions;
    for (std::sregex_iterator at(text.begin(), text.end(), head), end; at != end; ++at) {
        const auto begin = static_cast<std::size_t>(at->position());
        // Default arguments may have braces: the body begins behind the `)`.
        std::size_t close = begin + at->str().size();
        for (int depth = 1; close < text.size() && depth > 0; ++close) {
            if (text[close] == '(') ++depth;
            if (text[close] == ')') --depth;
        }
        const std::size_t open = text.find_first_of("{;=", close);
        if (open == text.npos || text[open] != '{') continue;
        // A body ends in the column of its head, or in its line.
        const std::size_t line_end = text.find('\n', open);
        const bool is_short = line_end != text.npos && text[line_end - 1] == '}';
        const std::size_t last = is_short ? line_end : text.find('\n' + at->str(2) + '}', open);
        questions.push_back(text.substr(begin, last - begin));
    }
    return questions;
}

std::vector<std::string> reporting_questions(const std::string& text, const Room& room) {
    std::string words =
        R"(\breport(?:_\w+)?\(|\bwarn_of\w*\(|\bcannot_express\(|\bsay_passed\()"
        R"(|\b(?:number|math)_fault\(|\b(?:position|center)_unknown\(|\bnot_given\()";
    if (!room.more.empty()) words += '|' + room.more;
    const std::regex pattern(words);
    std::vector<std::string> found;
    for (const std::string& question : questions_of(text)) {
        if (std::regex_search(question, pattern)) found.push_back(question);
    }
    return found;
}

TEST(House, NoFunctionThatAnswersWithBoolReports) {
    std::size_t questions = 0;
    for (const Room& room : kRooms) {
        for (const fs::directory_entry& entry :
             fs::recursive_directory_iterator(kRoot / room.folder)) {
            const std::string extension = entry.path().extension();
            if (extension != ".h" && extension != ".cpp" && extension != ".inc") continue;
            if (room.except.contains(entry.path().filename().string())) continue;
            const std::string text = kadr::read_file(entry.path()).value_or("");
            questions += questions_of(text).size();
            for (const std::string& found : reporting_questions(text, room))
                ADD_FAILURE() << entry.path() << found;
        }
    }
    EXPECT_GT(questions, 400u);
}

/// That the look above would see one.
TEST(House, AQuestionThatReportsIsFound) {
    const Room room{"", R"(\bfail\()"};
    const std::vector<std::string> wrong = {
        "bool is_known(int n) {\n    if (n > 0) return true;\n    report(diag::A, n);\n}\n",
        "class A {\n    static bool has_b() { return fail(diag::B); }\n};\n",
        "bool A::keeps_limits(const B& b,\n                     C c = {}) {\n    "
        "report_limit(c);\n}\n",
    };
    for (const std::string& text : wrong) EXPECT_EQ(reporting_questions(text, room).size(), 1u);
    const std::vector<std::string> right = {
        "Done require_known(int n) {\n    report(diag::A, n);\n}\n",
        "bool is_known(int n);\nvoid f() {\n    report(diag::A, n);\n}\n",
        "bool is_known() { return true; }\nvoid f() {\n    report(diag::A, n);\n}\n",
    };
    for (const std::string& text : right) EXPECT_TRUE(reporting_questions(text, room).empty());
}

}  // namespace

}  // namespace done_test
