// The table of diagnostics: codes are unique, every row explains itself and is shown by a test.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "base/diagnostic.h"
#include "base/disk_files.h"
#include "base/text.h"
#include "tests/common/examples.h"

namespace table_test {

namespace {

namespace fs = std::filesystem;

TEST(DiagnosticTable, CodesAndNamesAreUnique) {
    std::map<std::string_view, std::string_view> codes;
    for (const kadr::DiagnosticRow* row : kadr::all_diagnostics()) {
        const auto [other, is_new] = codes.emplace(row->code, row->name);
        EXPECT_TRUE(is_new) << row->code << ": " << row->name << " and " << other->second;
        EXPECT_TRUE(std::regex_match(std::string(row->code), std::regex("K[1-9][0-9]{3}")))
            << row->code;
    }
}

TEST(DiagnosticTable, EveryRowExplainsItself) {
    for (const kadr::DiagnosticRow* row : kadr::all_diagnostics()) {
        EXPECT_GE(row->explanation.size(), 40u) << row->code << " has no explanation";
        EXPECT_FALSE(row->wrong.empty()) << row->code << " has no wrong example";
        EXPECT_FALSE(row->right.empty()) << row->code << " has no right example";
        const std::string message(row->message);
        EXPECT_FALSE(message.ends_with('.')) << row->code << " ends with a full stop";
        EXPECT_FALSE(message.size() > 1 && std::isupper(static_cast<unsigned char>(message[0])) &&
                     std::islower(static_cast<unsigned char>(message[1])))
            << row->code << " begins in upper case";
    }
}

/// Takes the comments out of a C++ text: a code in a comment shows nothing.
std::string without_comments(const std::string& text) {
    std::string out;
    char quote = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (quote == 0 && text.compare(i, 2, "//") == 0) {
            i = std::min(text.find('\n', i), text.size() - 1);
        } else if (quote != 0 && text[i] == '\\') {
            out += text[i++];
        } else if (quote == 0 && (text[i] == '"' || text[i] == '\'')) {
            // In a number such as 1'000 it is no quotation mark.
            const bool is_separator =
                text[i] == '\'' && i > 0 && std::isalnum(static_cast<unsigned char>(text[i - 1]));
            if (!is_separator) quote = text[i];
        } else if (text[i] == quote) {
            quote = 0;
        }
        if (i < text.size()) out += text[i];
    }
    return out;
}

/// The lines of a text in which `mark` stands, from there on.
std::string lines_with(const std::string& text, const std::string& mark) {
    std::string out;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t at = line.find(mark);
        if (at != std::string::npos) out += line.substr(at) + '\n';
    }
    return out;
}

/// What the tests expect. Not what stands in comments, in recordings and in the texts of whole
/// parts.
struct Expectations {
    std::string code;   // of the test programs
    std::string lines;  // beside the lines of programs, and in wrong files
};

Expectations all_expectations() {
    const fs::path tests = fs::path(KADR_ROOT) / "tests";
    Expectations all;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(tests)) {
        if (!entry.is_regular_file()) continue;
        const std::string room = *fs::relative(entry.path(), tests).begin();
        if (room == "house" || room == "fuzz") continue;
        const std::string text = kadr::read_file(entry.path()).value_or("");
        if (entry.path().extension() == ".cpp") {
            all.code += without_comments(text);
        } else if (room == "bad" || room == "control") {
            all.lines += lines_with(text, "expect: ");
        } else if (room == "programs") {
            all.lines += lines_with(text, "//!");
        }
    }
    return all;
}

/// The words of a text: letters and digits without a gap, and their names in C++.
std::set<std::string> words_of(const std::string& text) {
    std::set<std::string> words;
    std::string word;
    for (const char c : text + ' ') {
        if (std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == ':') {
            word += c;
            continue;
        }
        while (word.ends_with(':')) word.pop_back();
        words.insert(std::exchange(word, {}));
    }
    return words;
}

/// Numbers of the controls' own alarms, by the row that they stand for.
std::multimap<std::string, std::string> alarm_numbers() {
    static const std::regex pattern("<alarm for=\"(\\w+)\" number=\"(\\w+)\"");
    std::multimap<std::string, std::string> numbers;
    for (const fs::directory_entry& entry :
         fs::directory_iterator(fs::path(KADR_ROOT) / "dialects")) {
        if (entry.path().extension() != ".xml") continue;
        const std::string text = kadr::read_file(entry.path()).value_or("");
        for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at) {
            numbers.emplace((*at)[1], (*at)[2]);
        }
    }
    return numbers;
}

/// Whether a test runs the row's wrong example and expects the row: tests/sema/examples_test.cpp,
/// for K7 tests/driver/test_command_test.cpp.
bool is_run_as_example(const kadr::DiagnosticRow& row) {
    if (row.code.starts_with("K7")) return !row.wrong.starts_with("kadr ");
    const bool is_language = row.code.starts_with("K2") || row.code.starts_with("K3");
    return is_language && kadr::testing::is_program(row.wrong);
}

/// The longest piece of a row's message between its arguments: what a line that expects it says.
std::string fixed_words(const kadr::DiagnosticRow& row) {
    static const std::regex argument("\\{[0-9]\\}");
    const std::string message(row.message);
    std::string longest;
    for (std::sregex_token_iterator at(message.begin(), message.end(), argument, -1), end;
         at != end; ++at) {
        if (at->length() > static_cast<std::ptrdiff_t>(longest.size())) longest = *at;
    }
    while (longest.ends_with(' ')) longest.pop_back();
    return longest;
}

/// Whether a line expects an alarm with this number in the row's words. The number alone says
/// little: a control has one for many mistakes.
bool has_alarm_line(const std::string& lines, const std::string& number,
                    const kadr::DiagnosticRow& row) {
    std::istringstream text(lines);
    for (std::string line; std::getline(text, line);) {
        if (line.find(fixed_words(row)) != std::string::npos && words_of(line).contains(number)) {
            return true;
        }
    }
    return false;
}

TEST(DiagnosticTable, EveryRowIsShownByATest) {
    const Expectations expected = all_expectations();
    const std::set<std::string> words = words_of(expected.code + ' ' + expected.lines);
    const auto numbers = alarm_numbers();
    for (const kadr::DiagnosticRow* row : kadr::all_diagnostics()) {
        const std::string name(row->name);
        bool is_shown = is_run_as_example(*row) || words.contains(std::string(row->code)) ||
                        words.contains("diag::" + name);
        const auto [first, last] = numbers.equal_range(name);
        for (auto at = first; at != last && !is_shown; ++at) {
            is_shown = has_alarm_line(expected.lines, at->second, *row);
        }
        EXPECT_TRUE(is_shown) << row->code << ' ' << name << " is shown by no test";
    }
}

}  // namespace

}  // namespace table_test
