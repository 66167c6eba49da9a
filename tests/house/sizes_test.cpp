// How large a class, a header and a function may become. What is larger is named here with its
// size, which may only fall, and with the reason why it may stay, if there is one.
#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"

namespace sizes_test {

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = KADR_ROOT;

struct Size {
    std::size_t functions = 0;
    std::size_t members = 0;  // that change
};

constexpr std::size_t kMostFunctions = 60;
constexpr std::size_t kMostMembers = 25;
constexpr std::size_t kMostHeaderLines = 300;
constexpr std::size_t kMostDataLines = 500;
constexpr std::size_t kMostFunctionLines = 120;

/// Classes of behaviour that are still to be cut by owners.
const std::map<std::string, Size> kLargeClasses = {
    {"Preparer::State", {96, 32}},
    {"FormWord", {60, 29}},
    {"Lexer", {65, 25}},
};

/// Data that is generated, loaded once, or the words of one block: as many members as it has.
const std::set<std::string> kData = {"DialectTables", "Language", "Form",           "Segment",
                                     "Piece",         "Frame",    "RunningProgram", "Actions"};

const std::map<std::string, std::size_t> kLargeHeaders = {
    {"runtime/motion/prepare_state.h", 341},
};
/// Types without behaviour.
const std::set<std::string> kDataHeaders = {"compiler/sema/code.h", "compiler/syntax/ast.h",
                                            "runtime/nc/tables.h", "runtime/interp/state.h"};

/// Switches over one enum, and orders that are named; the others are still to be cut.
const std::map<std::string, std::size_t> kLongFunctions = {
    {"add_own_effects", 300},            // a switch over all functions
    {"BlockFunctions::apply_own", 407},  // likewise
    {"Answers::quantity", 220},          // a switch over all quantities
    {"contour_value", 136},              // a switch over the questions to a contour
    {"dialect_rules", 157},              // a table
};

std::vector<std::string> lines_of(const fs::path& file) {
    const std::string text = kadr::read_file(file).value_or("");
    std::vector<std::string> lines;
    std::size_t begin = 0;
    while (begin < text.size()) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

std::vector<fs::path> sources(const std::string& extension) {
    std::vector<fs::path> found;
    for (const char* part : {"runtime", "compiler"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kRoot / part))
            if (entry.path().extension() == extension) found.push_back(entry.path());
    }
    return found;
}

/// The members of the classes of a header, as its layout shows them: a declaration begins where the
/// class stands, and four columns further.
std::map<std::string, Size> classes_of(const std::vector<std::string>& lines) {
    static const std::regex head(R"(^( *)(?:class|struct) ([\w:]+)(?: final)?(?: :[^{]*)? ?\{$)");
    static const std::regex no_member(
        R"(^ *(?:using |friend |enum |class |struct |static|const |constexpr |public|private).*)");
    static const std::regex member(
        R"(^ *(?:mutable )?[\w:<>, *]+[ >*]\w+(?:\[\w+\])?(?:\{[^}]*\})?(?: = [^;]*)?;.*)");
    static const std::regex initialised(R"(^ *[\w:<>, *]+ \w+(?:\{| =).*)");
    struct Open {
        std::string name;
        std::size_t column;
        Size size;
    };
    std::vector<Open> open;
    std::map<std::string, Size> found;
    for (const std::string& line : lines) {
        std::smatch match;
        if (std::regex_match(line, match, head)) {
            open.push_back({match[2].str(), static_cast<std::size_t>(match[1].length()), {}});
            continue;
        }
        if (open.empty()) continue;
        const std::size_t column = std::min(line.find_first_not_of(' '), line.size());
        if (column == open.back().column && line.compare(column, 1, "}") == 0) {
            found[open.back().name] = open.back().size;
            open.pop_back();
            continue;
        }
        const bool is_declaration = column == open.back().column + 4 && column < line.size() &&
                                    line[column] != '/' && line[column] != '}';
        if (!is_declaration || line[column] == '#') continue;
        const bool is_static_function =
            line.compare(column, 7, "static ") == 0 && line.find('(') != line.npos;
        if (!is_static_function && std::regex_match(line, no_member)) continue;
        Size& size = open.back().size;
        if (line.find('(') != line.npos && !std::regex_match(line, initialised)) ++size.functions;
        else if (std::regex_match(line, member) && line.find('&') == line.npos) ++size.members;
    }
    return found;
}

TEST(House, ClassesHaveOneOwnersSize) {
    std::set<std::string> seen;
    for (const fs::path& file : sources(".h")) {
        for (const auto& [name, size] : classes_of(lines_of(file))) {
            if (kData.contains(name)) continue;
            const auto large = kLargeClasses.find(name);
            const Size most = large == kLargeClasses.end() ? Size{} : large->second;
            if (large != kLargeClasses.end()) seen.insert(name);
            EXPECT_LE(size.functions, std::max(kMostFunctions, most.functions)) << file << name;
            EXPECT_LE(size.members, std::max(kMostMembers, most.members)) << file << name;
            if (large == kLargeClasses.end()) continue;
            EXPECT_TRUE(size.functions > kMostFunctions || size.members > kMostMembers)
                << name << " is no longer too large: take it out of the list";
        }
    }
    EXPECT_EQ(seen.size(), kLargeClasses.size()) << "a class of the list is gone";
}

/// State that the parts of a channel share (ChannelState), and the files that write it: what has an
/// owner is written by it, and by one neighbour at most.
TEST(House, SharedStateIsWrittenByItsOwner) {
    static const std::regex shared(R"(^    (?:const )?[\w:<>, ]+& (\w+_);)");
    static const std::regex written(
        R"(\b(\w+_)\b((?:\.\w+|\[[^\]]*\]|->\w+)*) *(?:[-+*/|&^]|<<|>>)?=[^=])"
        R"(|exchange\((\w+_)\b((?:\.\w+)*)|(?:\+\+|--)(\w+_)\b)");
    const fs::path room = kRoot / "runtime/interp";
    std::set<std::string> names;
    std::map<std::string, std::string> texts;
    for (const fs::directory_entry& entry : fs::directory_iterator(room)) {
        const std::string text = kadr::read_file(entry.path()).value_or("");
        if (text.find("channel_") == text.npos) continue;  // no part of a channel
        texts[entry.path().filename().string()] = text;
        if (entry.path().extension() != ".h") continue;
        for (const std::string& line : lines_of(entry.path())) {
            std::smatch match;
            if (std::regex_search(line, match, shared)) names.insert(match[1].str());
        }
    }
    EXPECT_GT(names.size(), 40u);
    std::map<std::string, std::set<std::string>> writers;  // of each member
    for (const auto& [file, text] : texts) {
        std::sregex_iterator at(text.begin(), text.end(), written), end;
        for (; at != end; ++at) {
            const std::smatch& match = *at;
            const std::string name = match[1].str() + match[3].str() + match[5].str();
            if (!names.contains(name)) continue;
            std::string member = match[2].str() + match[4].str();
            member = member.substr(0, member.find_first_of(".[-", 1));
            writers[name + member].insert(file);
        }
    }
    EXPECT_GT(writers.size(), 40u);
    for (const auto& [member, files] : writers) {
        std::string list;
        for (const std::string& file : files) list += ' ' + file;
        EXPECT_LE(files.size(), 2u) << member << " is written in" << list;
    }
}

/// The same of a program that runs in the expander: what has verbs is private, and of what stands
/// open in its owners each member is written in two files at most. The chapters of vm.cpp count as
/// one.
TEST(House, StateOfTheExpanderIsWrittenByItsOwner) {
    static const std::regex written(
        R"((?:(?:\+\+|--)run\.((?:\w+\.)*\w+))"
        R"(|\brun\.((?:\w+\.)*\w+)(?:\[[^\]=;]*\])*(?:\.number|\.integer)?)"
        R"( *(?:(?:[-+*/|&^]|<<|>>)?=[^=]|\+\+|--)))");
    std::map<std::string, std::set<std::string>> writers;  // of each member
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(kRoot / "compiler/expand")) {
        const std::string extension = entry.path().extension();
        if (extension != ".cpp" && extension != ".inc") continue;
        const std::string text = kadr::read_file(entry.path()).value_or("");
        std::sregex_iterator at(text.begin(), text.end(), written), end;
        for (; at != end; ++at) {
            const std::string file = extension == ".inc" ? "vm.cpp" : entry.path().filename();
            writers[at->str(1) + at->str(2)].insert(file);
        }
    }
    EXPECT_GT(writers.size(), 20u);
    for (const auto& [member, files] : writers) {
        std::string list;
        for (const std::string& file : files) list += ' ' + file;
        EXPECT_LE(files.size(), 2u) << member << " is written in" << list;
    }
}

TEST(House, HeadersAreShort) {
    for (const fs::path& file : sources(".h")) {
        const std::string name = fs::relative(file, kRoot).string();
        const std::size_t lines = lines_of(file).size();
        const auto large = kLargeHeaders.find(name);
        const std::size_t most = large != kLargeHeaders.end()  ? large->second
                                 : kDataHeaders.contains(name) ? kMostDataLines
                                                               : kMostHeaderLines;
        EXPECT_LE(lines, most) << name;
    }
}

TEST(House, FunctionsAreShort) {
    static const std::regex head(R"(^[A-Za-z][^;=]*?((?:\w+::)*~?\w+)\(.*[^;}]$)");
    static const std::regex no_function(R"(^(?:namespace|class|struct|enum|using|TEST)\b.*)");
    std::size_t functions = 0;
    for (const fs::path& file : sources(".cpp")) {
        std::string name;
        std::size_t begin = 0;
        const std::vector<std::string> lines = lines_of(file);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            std::smatch match;
            if (name.empty() && !std::regex_match(lines[i], no_function) &&
                std::regex_match(lines[i], match, head)) {
                name = match[1].str();
                begin = i;
            }
            // A constructor may end in the line of its last member.
            const bool ends = lines[i].starts_with('}') || lines[i].ends_with(" {}");
            if (name.empty() || !ends) continue;
            const auto large = kLongFunctions.find(name);
            const std::size_t most =
                large == kLongFunctions.end() ? kMostFunctionLines : large->second;
            EXPECT_LE(i - begin + 1, most) << file << ": " << name;
            ++functions;
            name.clear();
        }
    }
    EXPECT_GT(functions, 3000u);
}

/// That the look above counts what is there.
TEST(House, ACountOfMembersSeesThem) {
    const auto found = classes_of({
        "class A {",
        "  public:",
        "    void f(int n);",
        "    int g() const { return n_; }",
        "",
        "  private:",
        "    struct B {",
        "        int x = 0;",
        "        std::vector<int> y;",
        "    };",
        "    const int& c_;",
        "    int n_ = 0;  // of them",
        "    std::optional<B> b_;",
        "    static int h(int n);",
        "};",
    });
    EXPECT_EQ(found.at("A").functions, 3u);
    EXPECT_EQ(found.at("A").members, 2u);
    EXPECT_EQ(found.at("B").members, 2u);
}

}  // namespace

}  // namespace sizes_test
