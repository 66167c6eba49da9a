// The table of diagnostics: codes are unique, every row explains itself and is shown by a test.
#include <filesystem>
#include <map>
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "base/diagnostic.h"
#include "base/text.h"

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

/// Everything below tests/ as one text; a row counts as shown if its code or name stands there.
std::string all_tests() {
    std::string all;
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(fs::path(KADR_ROOT) / "tests")) {
        if (!entry.is_regular_file()) continue;
        const std::string extension = entry.path().extension();
        if (extension == ".cpp" || extension == ".kadr" || extension == ".txt" ||
            extension == ".tsv") {
            all += kadr::read_file(entry.path()).value_or("");
        }
    }
    return all;
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

TEST(DiagnosticTable, EveryRowIsShownByATest) {
    const std::string tests = all_tests();
    const auto numbers = alarm_numbers();
    for (const kadr::DiagnosticRow* row : kadr::all_diagnostics()) {
        // tests/sema/examples_test.cpp and, of K7, tests/driver/test_command_test.cpp run the wrong
        // and the right example of each of these.
        if (row->code.starts_with("K2") || row->code.starts_with("K3")) continue;
        if (row->code.starts_with("K7") && !row->wrong.starts_with("kadr ")) continue;
        bool is_shown = tests.find(row->code) != std::string::npos ||
                        tests.find("diag::" + std::string(row->name)) != std::string::npos;
        const auto [first, last] = numbers.equal_range(std::string(row->name));
        for (auto at = first; at != last; ++at)
            is_shown |= tests.find(at->second) != std::string::npos;
        EXPECT_TRUE(is_shown) << row->code << " " << row->name << " is shown by no test";
    }
}

}  // namespace
