// A folder includes only folders on lower floors; third-party headers stay behind their doors.
// Link lines alone do not catch a header that leaks, so every #include is read here.
#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"

namespace floors_test {

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = KADR_ROOT;

/// What each room may include besides itself (docs: "The house").
const std::map<std::string, std::set<std::string>> kFloors = {
    {"base", {}},
    {"nc", {"base"}},
    {"path", {"base"}},
    {"machine", {"base", "path"}},
    {"control", {"base", "nc", "path", "machine"}},
    {"macro", {"base", "nc", "path", "machine", "control"}},
    {"write", {"base", "nc"}},
    {"interp", {"base", "nc", "path", "machine", "control", "macro", "write"}},
    {"motion", {"base", "path", "machine"}},
    {"process", {"base", "path", "machine", "motion"}},
    {"syntax", {"base", "nc"}},
    {"sema", {"base", "nc", "machine", "syntax"}},
    {"expand", {"base", "nc", "path", "machine", "control", "syntax", "sema"}},
    {"plot", {"base", "path", "machine", "motion", "process"}},
    {"driver",
     {"base", "nc", "path", "machine", "control", "macro", "write", "interp", "motion", "process",
      "syntax", "sema", "expand", "plot"}},
    {"repl",
     {"base", "nc", "path", "machine", "control", "macro", "write", "interp", "motion", "process",
      "syntax", "sema", "plot", "driver"}},
    {"cli", {"base", "nc", "machine", "driver", "repl"}},
};

/// Libraries that only the named files may see.
const std::map<std::string, std::set<std::string>> kDoors = {
    {"antlr4-runtime", {"syntax"}},
    {"KadrLexer", {"syntax"}},
    {"KadrParser", {"syntax"}},
    {"pugixml", {"base"}},
    {"CLI/", {"cli"}},
    {"histedit", {"repl"}},
    {"utf8proc", {"base"}},
    {"nlohmann", {"driver", "cli"}},
};

struct Include {
    std::string room, file, target;
};

std::vector<Include> includes_of_all_rooms() {
    static const std::regex pattern("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]");
    std::vector<Include> includes;
    for (const char* side : {"runtime", "compiler"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kRoot / side)) {
            const std::string extension = entry.path().extension();
            if (extension != ".h" && extension != ".cpp" && extension != ".def") continue;
            const fs::path relative = fs::relative(entry.path(), kRoot / side);
            std::istringstream text(kadr::read_file(entry.path()).value_or(""));
            for (std::string line; std::getline(text, line);) {
                std::smatch match;
                if (!std::regex_search(line, match, pattern)) continue;
                includes.push_back({relative.begin()->string(), relative.string(), match[1]});
            }
        }
    }
    return includes;
}

TEST(House, RoomsIncludeOnlyLowerFloors) {
    for (const Include& include : includes_of_all_rooms()) {
        const std::string target = include.target.substr(0, include.target.find('/'));
        if (!kFloors.contains(target) || target == include.room) continue;
        ASSERT_TRUE(kFloors.contains(include.room))
            << include.room << " is not on the list of floors";
        EXPECT_TRUE(kFloors.at(include.room).contains(target))
            << include.file << " includes " << include.target;
    }
}

TEST(House, LibrariesStayBehindTheirDoors) {
    for (const Include& include : includes_of_all_rooms()) {
        for (const auto& [library, rooms] : kDoors) {
            if (!include.target.starts_with(library)) continue;
            EXPECT_TRUE(rooms.contains(include.room))
                << include.file << " includes " << include.target;
        }
    }
}

/// JSON is spelled in one place: no other file has the beginning of an object, or an end of a
/// member's name, in a string.
TEST(House, JsonComesFromItsWriter) {
    constexpr std::array kSpelled = {R"(\":)", R"({\")", R"(,\")", R"(\"])", R"x(R"({)x"};
    std::size_t users = 0;
    for (const char* side : {"runtime", "compiler"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kRoot / side)) {
            const std::string extension = entry.path().extension();
            if (extension != ".h" && extension != ".cpp") continue;
            const std::string text = kadr::read_file(entry.path()).value_or("");
            users += text.find("JsonWriter") != text.npos;
            for (const char* spelled : kSpelled)
                EXPECT_EQ(text.find(spelled), text.npos) << entry.path() << " has " << spelled;
        }
    }
    EXPECT_GT(users, 8u);
}

/// A rule of a control is a typed value of its dialect: only the loader looks one up by its name,
/// so no room has a default of its own.
TEST(House, NoRuleIsAskedByItsName) {
    const std::set<std::string> doors = {"rules.h", "rules.cpp", "load_references.cpp"};
    std::size_t doors_found = 0;
    for (const char* side : {"runtime", "compiler"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kRoot / side)) {
            const std::string text = kadr::read_file(entry.path()).value_or("");
            if (text.find("rule_named(") == text.npos && text.find("set_rule(") == text.npos)
                continue;
            const bool is_language = entry.path().filename().string().starts_with("language");
            const bool is_door = doors.contains(entry.path().filename().string());
            doors_found += is_door;
            EXPECT_TRUE(is_door || is_language) << entry.path();
        }
    }
    EXPECT_EQ(doors_found, doors.size());
}

/// What is so of a function whatever the program says is a column of vocabulary.def: no room keeps
/// a list of functions of its own.
TEST(House, NoPredicateListsFunctions) {
    static const std::regex head(R"(bool \w+\((?:nc::)?Function \w+\)[^;{]*\{)");
    static const std::regex row(R"(\bFunction::\w+)");
    for (const char* side : {"runtime", "compiler"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kRoot / side)) {
            const std::string extension = entry.path().extension();
            if (extension != ".h" && extension != ".cpp") continue;
            const std::string text = kadr::read_file(entry.path()).value_or("");
            for (std::sregex_iterator at(text.begin(), text.end(), head), end; at != end; ++at) {
                const auto begin = static_cast<std::size_t>(at->position());
                const std::string body = text.substr(begin, text.find("\n}", begin) - begin);
                const bool is_const = at->str().find(") const") != std::string::npos;
                EXPECT_TRUE(is_const || !std::regex_search(body, row)) << entry.path() << '\n'
                                                                       << body;
            }
        }
    }
}

/// The text without its comments, as long as before.
std::string without_comments(std::string text) {
    for (std::size_t at = text.find("//"); at != text.npos; at = text.find("//", at)) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        text.replace(at, end - at, end - at, ' ');
        at = end;
    }
    return text;
}

/// The members of the vocabulary that the pattern finds.
std::set<std::string> functions_in(const std::string& statement, const std::regex& pattern) {
    std::set<std::string> found;
    for (std::sregex_iterator at(statement.begin(), statement.end(), pattern), end; at != end; ++at)
        if ((*at)[1] != "None") found.insert((*at)[1]);
    return found;
}

/// … nor does a statement: two functions may be asked for, three are a fact that has no name. The
/// rows of the small enums of modes.cpp are those of whole groups.
TEST(House, NoStatementListsFunctions) {
    static const std::regex asked(
        R"((?:[=!]=\s*|\bfind\(|\bhas\([\w.>-]+,\s*)(?:nc::)?Function::(\w+))");
    static const std::regex listed(R"((?:nc::)?Function::(\w+))");
    static const std::regex list(
        R"(\s*(?:nc::)?Function::\w+(?:,\s*(?:nc::)?Function::\w+)*,?\s*\})");
    static const std::regex range(R"(\s[<>]=?\s+(?:nc::)?Function::\w+)");
    std::size_t statements = 0;
    for (const char* side : {"runtime", "compiler"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kRoot / side)) {
            const std::string extension = entry.path().extension();
            if (extension != ".h" && extension != ".cpp") continue;
            if (entry.path().filename() == "modes.cpp") continue;
            const std::string text = without_comments(kadr::read_file(entry.path()).value_or(""));
            for (std::size_t at = 0, end = 0; at < text.size(); at = end) {
                end = std::min(text.find_first_of(";{}", at), text.size() - 1) + 1;
                const std::string statement = text.substr(at, end - at);
                if (statement.find("Function::") == statement.npos) continue;
                ++statements;
                const bool is_list = std::regex_match(statement, list);
                EXPECT_LT(functions_in(statement, is_list ? listed : asked).size(), 3u)
                    << entry.path() << '\n'
                    << statement;
            }
        }
    }
    EXPECT_GT(statements, 1000u);
}

/// … nor does a switch put several of them in one row, but for the two over all functions, which
/// answer each by name.
TEST(House, NoSwitchListsFunctions) {
    static const std::regex row(R"((?:case (?:nc::)?Function::\w+:\s*){3,})");
    const std::set<fs::path> total = {kRoot / "runtime/interp/functions.cpp",
                                      kRoot / "runtime/nc/effects.cpp"};
    for (const char* side : {"runtime", "compiler"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kRoot / side)) {
            const std::string extension = entry.path().extension();
            if (extension != ".h" && extension != ".cpp") continue;
            if (total.contains(entry.path())) continue;
            const std::string text = without_comments(kadr::read_file(entry.path()).value_or(""));
            std::sregex_iterator at(text.begin(), text.end(), row), end;
            for (; at != end; ++at) ADD_FAILURE() << entry.path() << '\n' << at->str();
        }
    }
}

/// Which argument of a function is meant is said by its name, parameter_of<…>("to"): its number is
/// the table's alone.
TEST(House, NoArgumentIsAskedByItsPlace) {
    // The first argument of a call may be a call itself.
    static const std::regex asked(R"((?:\.|->)argument\((?:[^(),;]|\([^()]*\))*,\s*\d)"
                                  R"(|\bset_argument\((?:[^(),;]|\([^()]*\))*,\s*\d)"
                                  R"(|\binvocation,\s*\d)"
                                  R"(|(?:\.|->)given\s*&\s*\d)"
                                  R"(|\bgiven\s*>>\s*\(?\d)");
    for (const char* side : {"runtime", "compiler"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kRoot / side)) {
            const std::string extension = entry.path().extension();
            if (extension != ".h" && extension != ".cpp") continue;
            const std::string text = kadr::read_file(entry.path()).value_or("");
            for (std::sregex_iterator at(text.begin(), text.end(), asked), end; at != end; ++at)
                ADD_FAILURE() << entry.path() << '\n' << at->str();
        }
    }
}

/// The text from an opening brace behind `from` to the one that closes it.
std::string braced(const std::string& text, std::size_t from) {
    const std::size_t begin = text.find('{', from);
    std::size_t at = begin;
    for (int depth = 0; at < text.size(); ++at) {
        if (text[at] == '{') ++depth;
        if (text[at] == '}' && --depth == 0) break;
    }
    return text.substr(begin, at - begin);
}

/// Whoever follows the effects of functions answers each kind of them: no fold has a `default`, and
/// neither have the two switches over all functions.
TEST(House, FoldsAnswerEveryEffect) {
    struct Switch {
        const char* file;
        const char* head;
    };
    constexpr std::array kSwitches = {
        Switch{"runtime/interp/functions.cpp", "switch (effect.kind)"},
        Switch{"compiler/expand/modal.cpp", "switch (effect.kind)"},
        Switch{"compiler/expand/modal.cpp", "switch (group)"},
        Switch{"runtime/write/following.cpp", "switch (effect.kind)"},
        Switch{"runtime/nc/modal_functions.cpp", "switch (effect.kind)"},
        Switch{"runtime/interp/functions.cpp", "switch (invocation.function)"},
        Switch{"runtime/interp/functions.cpp", "switch (effect.group())"},
        Switch{"runtime/nc/effects.cpp", "switch (function)"},
    };
    for (const auto& [file, head] : kSwitches) {
        const std::string text = kadr::read_file(kRoot / file).value_or("");
        const std::size_t at = text.find(head);
        ASSERT_NE(at, std::string::npos) << file << " has no " << head;
        EXPECT_EQ(braced(text, at).find("default:"), std::string::npos) << file << ": " << head;
    }
}

}  // namespace

}  // namespace floors_test
