// The pages that teach choose which functions they show; what they name is there.
#include <algorithm>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "nc/vocabulary.h"
#include "sema/builtins.h"

namespace named_functions_test {

namespace {

/// The functions and cycles that a module of the library declares, at its left margin.
std::set<std::string> declared_in(const std::string& module) {
    std::string path = module;
    for (char& c : path) c = c == '.' ? '/' : c;
    const std::string text = kadr::read_file(KADR_ROOT "/stdlib/" + path + ".kadr").value_or("");
    static const std::regex head(R"((?:^|\n)[a-z_]+(?:\[\])? ([a-z_0-9]+)\()");
    std::set<std::string> names;
    for (std::sregex_iterator at(text.begin(), text.end(), head), end; at != end; ++at)
        names.insert((*at)[1]);
    return names;
}

/// What stands in backquotes in a cell of a table.
std::vector<std::string> quoted_in(const std::string& cell) {
    static const std::regex quoted("`([^`]+)`");
    std::vector<std::string> texts;
    for (std::sregex_iterator at(cell.begin(), cell.end(), quoted), end; at != end; ++at)
        texts.push_back((*at)[1]);
    return texts;
}

/// The rows of the first table behind a text, as their cells; without its head.
std::vector<std::vector<std::string>> table_behind(const std::string& page,
                                                   const std::string& text) {
    const std::size_t begin = page.find("\n|", page.find(text));
    std::istringstream lines(page.substr(begin + 1));
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(lines, line) && line.starts_with("|");) {
        std::istringstream cells(line.substr(1));
        std::vector<std::string>& row = rows.emplace_back();
        for (std::string cell; std::getline(cells, cell, '|');) row.push_back(cell);
    }
    rows.erase(rows.begin(), rows.begin() + 2);
    return rows;
}

/// A function of the vocabulary, or one that the language has by itself.
bool is_command(const std::string& name) {
    if (std::ranges::count(kadr::sema::builtin_names(), name) > 0) return true;
    for (std::size_t i = 0; i < kadr::nc::kFunctions; ++i)
        if (kadr::nc::info(static_cast<kadr::nc::Function>(i)).name == name) return true;
    return false;
}

/// In front of `;` a module's functions, behind it words about them.
TEST(NamedFunctions, OfTheLibraryAreInTheirModules) {
    const std::string page = kadr::read_file(KADR_ROOT "/docs/stdlib.md").value();
    int functions = 0;
    for (const auto& row : table_behind(page, "| file | what it has |")) {
        std::set<std::string> declared;
        for (const std::string& module : quoted_in(row[0])) declared.merge(declared_in(module));
        static const std::regex name("[a-z_0-9]+");
        for (const std::string& shown : quoted_in(row[1])) {
            if (!std::regex_match(shown, name)) continue;
            ++functions;
            EXPECT_TRUE(declared.contains(shown)) << row[0] << ": " << shown;
        }
    }
    EXPECT_GT(functions, 40);
}

TEST(NamedFunctions, AmongTheCommandsAreCommands) {
    const std::string page = kadr::read_file(KADR_ROOT "/docs/language.md").value();
    const std::set<std::string> prelude = declared_in("prelude");
    static const std::regex call(R"(\b([a-z_]+)\()");
    int commands = 0;
    for (const auto& row : table_behind(page, "## 9. Commands")) {
        for (const std::string& shown : quoted_in(row[0])) {
            for (std::sregex_iterator at(shown.begin(), shown.end(), call), end; at != end; ++at) {
                ++commands;
                const std::string name = (*at)[1];
                EXPECT_TRUE(is_command(name) || prelude.contains(name)) << name;
            }
        }
    }
    EXPECT_GT(commands, 40);
}

}  // namespace

}  // namespace named_functions_test
