// Pages for those who change Kadr: every folder of tests says what it expects, every link of a page
// leads somewhere.
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"

namespace pages_test {

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = KADR_ROOT;

TEST(Pages, EveryFolderOfTestsSaysWhatItExpects) {
    const std::string list = kadr::read_file((kRoot / "tests/README.md").string()).value_or("");
    std::size_t folders = 0;
    for (const auto& entry : fs::directory_iterator(kRoot / "tests")) {
        if (!entry.is_directory()) continue;
        ++folders;
        const std::string name = entry.path().filename();
        EXPECT_TRUE(fs::exists(entry.path() / "README.md")) << "tests/" << name;
        EXPECT_NE(list.find("| [`" + name + "`](" + name + "/README.md) |"), std::string::npos)
            << name << " is not in tests/README.md";
    }
    EXPECT_GT(folders, 20u);
}

/// The pages of the repository: at its root, in docs/, and the README of every folder.
std::vector<fs::path> pages() {
    std::vector<fs::path> found = {kRoot / "web/README.md"};  // beside what npm has put there
    for (const auto& entry : fs::directory_iterator(kRoot))
        if (entry.path().extension() == ".md") found.push_back(entry.path());
    for (const char* part :
         {"bench", "compiler", "dialects", "docs", "examples", "runtime", "stdlib", "tests"}) {
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / part))
            if (entry.path().extension() == ".md") found.push_back(entry.path());
    }
    return found;
}

/// A page without its fences, inside of which brackets are none of a link.
std::string without_fences(const std::string& text) {
    std::istringstream lines(text);
    std::string out;
    bool is_inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```")) is_inside = !is_inside;
        else if (!is_inside) out += line + '\n';
    }
    return out;
}

/// The anchors of a page, as its headings become: small letters and digits, `-` for a blank, the
/// rest left out.
std::set<std::string> anchors_of(const fs::path& page) {
    std::istringstream lines(without_fences(kadr::read_file(page.string()).value_or("")));
    std::set<std::string> anchors;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("#")) continue;
        std::string anchor;
        for (const char c : line.substr(line.find_first_not_of("# "))) {
            const auto byte = static_cast<unsigned char>(c);
            if (c == ' ') anchor += '-';
            else if (std::isalnum(byte) != 0 || c == '_' || c == '-' || byte >= 0x80)
                anchor += static_cast<char>(std::tolower(byte));
        }
        anchors.insert(anchor);
    }
    return anchors;
}

TEST(Pages, EveryLinkLeadsSomewhere) {
    static const std::regex link(R"re(\]\(([^()#\s]*)(?:#([^()\s]+))?\))re");
    int links = 0;
    for (const fs::path& page : pages()) {
        const std::string text = without_fences(kadr::read_file(page.string()).value_or(""));
        for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end; ++at) {
            const std::string file = (*at)[1];
            if (file.find("://") != std::string::npos) continue;
            ++links;
            const fs::path target = file.empty() ? page : page.parent_path() / file;
            EXPECT_TRUE(fs::exists(target)) << page << ": " << (*at)[0];
            if (!(*at)[2].matched || target.extension() != ".md") continue;
            EXPECT_TRUE(anchors_of(target).contains((*at)[2])) << page << ": " << (*at)[0];
        }
    }
    EXPECT_GT(links, 50);
}

/// The paths of what a developer's page may name.
std::vector<std::string> all_files() {
    std::vector<std::string> files;
    for (const char* part : {"bench", "cmake", "compiler", "dialects", "docs", "examples",
                             "grammar", "runtime", "scripts", "stdlib", "tests", "web/src"}) {
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / part))
            files.push_back('/' + entry.path().lexically_relative(kRoot).string());
    }
    return files;
}

/// `runtime/nc/rules.def`, `nc/rules.def`, `rules.def`, `runtime/nc`: files and folders, from the
/// root on or by the end of their path. Names in capitals stand for any.
TEST(Pages, FilesNamedForThoseWhoChangeKadrAreThere) {
    static const std::regex name(
        R"re(`((?:[a-z0-9_.-]+/)*[a-z0-9_-]+\.(?:cpp|h|def|xml|xsd|js|mjs|json|md|txt|g4|inc)|)re"
        R"re((?:compiler|runtime|scripts|tests|web)/[a-z0-9_/-]+)`)re");
    const std::vector<std::string> files = all_files();
    for (const char* page : {"CONTRIBUTING.md", "docs/architecture.md", "docs/adding.md"}) {
        const std::string text = kadr::read_file((kRoot / page).string()).value_or("");
        int names = 0;
        for (std::sregex_iterator at(text.begin(), text.end(), name), end; at != end; ++at) {
            // What a file was called in a commit stands in the last of four columns.
            const auto place = static_cast<std::size_t>(at->position());
            const std::size_t begin = text.rfind('\n', place) + 1;
            const std::string front = text.substr(begin, place - begin);
            if (front.starts_with("|") && std::ranges::count(front, '|') == 4) continue;
            ++names;
            const std::string end_of_path = '/' + (*at)[1].str();
            const bool is_there = std::ranges::any_of(
                files, [&](const std::string& file) { return file.ends_with(end_of_path); });
            EXPECT_TRUE(is_there) << page << ": " << (*at)[1];
        }
        EXPECT_GT(names, 4) << page;
    }
}

/// The standard output of a command; nothing if it fails.
std::string output_of(const std::string& command) {
    std::string out;
    std::FILE* const pipe = popen((command + " 2>/dev/null").c_str(), "r");
    if (pipe == nullptr) return out;
    for (int c = std::getc(pipe); c != EOF; c = std::getc(pipe)) out += static_cast<char>(c);
    return pclose(pipe) == 0 ? out : std::string();
}

/// Each with its subject, or the beginning of it, behind the hash: "`a577853e`, *CYCLE832 acts*".
TEST(Pages, CommitsThatAreCitedAreThere) {
    const std::string git = "git -C '" + kRoot.string() + "' ";
    // An unpacked archive has no log, a shallow clone only its end.
    if (output_of(git + "rev-parse --is-shallow-repository") != "false\n") GTEST_SKIP();
    static const std::regex cited("`([0-9a-f]{8})`(?:, \\*([^*…]+))?");
    const std::string page = kadr::read_file((kRoot / "docs/adding.md").string()).value();
    std::string text = page;
    std::ranges::replace(text, '\n', ' ');
    int commits = 0;
    for (std::sregex_iterator at(text.begin(), text.end(), cited), end; at != end; ++at) {
        ++commits;
        const std::string subject = output_of(git + "log -1 --format=%s " + (*at)[1].str());
        EXPECT_NE(subject, "") << (*at)[1];
        std::string claimed = (*at)[2];
        claimed.erase(claimed.find_last_not_of(' ') + 1);
        EXPECT_TRUE(subject.starts_with(claimed)) << (*at)[1] << ": " << subject;
    }
    EXPECT_GT(commits, 8);
}

}  // namespace

}  // namespace pages_test
