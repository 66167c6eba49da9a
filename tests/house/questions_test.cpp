// A question changes nothing: what its name asks can be asked twice.
#include <cstddef>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"

namespace questions_test {

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = KADR_ROOT;

struct Questions {
    std::size_t all = 0;
    std::vector<std::string> changing;  // heads of those that may change their object
};

/// The member functions of a header whose names ask for a bool. What stands in the first column is
/// no member.
Questions questions_of(const std::string& text) {
    static const std::regex head(
        R"(\n +((?:\[\[nodiscard\]\] |static |constexpr |inline |virtual |friend )*)bool )"
        R"((?:is|has|may|can|needs|knows)_\w+\()");
    Questions questions;
    for (std::sregex_iterator at(text.begin(), text.end(), head), end; at != end; ++at) {
        ++questions.all;
        const std::string before = at->str(1);
        if (before.find("static ") != before.npos || before.find("friend ") != before.npos)
            continue;
        const auto begin = static_cast<std::size_t>(at->position());
        std::size_t close = begin + at->str().size();
        for (int depth = 1; close < text.size() && depth > 0; ++close) {
            if (text[close] == '(') ++depth;
            if (text[close] == ')') --depth;
        }
        if (text.compare(close, 6, " const") != 0)
            questions.changing.push_back(text.substr(begin, close - begin));
    }
    return questions;
}

TEST(House, AQuestionIsConst) {
    std::size_t questions = 0;
    for (const char* folder : {"runtime", "compiler"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kRoot / folder)) {
            if (entry.path().extension() != ".h") continue;
            const Questions found = questions_of(kadr::read_file(entry.path()).value_or(""));
            questions += found.all;
            for (const std::string& changing : found.changing)
                ADD_FAILURE() << entry.path() << changing;
        }
    }
    EXPECT_GT(questions, 250u);
}

/// That the look above would see one.
TEST(House, AQuestionThatMayChangeItsObjectIsFound) {
    const std::vector<std::string> wrong = {
        "class A {\n    bool is_first() { return !std::exchange(told_, true); }\n};\n",
        "class A {\n    virtual bool has_b(int n = f()) = 0;\n};\n",
        "class A {\n    bool may_go(const B& b,\n                int c);\n};\n",
    };
    for (const std::string& text : wrong) EXPECT_EQ(questions_of(text).changing.size(), 1u);
    const std::vector<std::string> right = {
        "class A {\n    bool is_first() const { return first_; }\n};\n",
        "class A {\n    static bool has_b(int n);\n    bool first_time();\n};\n",
        "class A {\n    bool is_first_ = false;\n};\n",
        "\nbool is_first(int n);\n",
    };
    for (const std::string& text : right) EXPECT_TRUE(questions_of(text).changing.empty());
}

}  // namespace

}  // namespace questions_test
