// What the cycles of the library must not be given, and what they say then, word for word: the
// files of refusals/. Every `require` and every `error` of the library has its row.
//
//   [cycles.drilling]           the module; `lathe` behind it: X is a diameter, the plane Z-X
//   drill(to: 5mm)              statements, the last one the call that is refused
//     the bottom at Z 5 mm …    what is said of it
//   bare: bore_helix(…)         no feed is set before
//
// KADR_UPDATE=1 writes the messages: read every line of the difference.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/common/process.h"
#include "tests/common/scratch.h"

namespace refusals_test {

namespace {

namespace fs = std::filesystem;

struct Row {
    std::string call;  // as in the file
    std::string message;
};

struct Section {
    std::string head;  // "cycles.turning] lathe"
    std::vector<Row> rows;

    std::string module() const { return head.substr(0, head.find(']')); }
    bool is_lathe() const { return head.ends_with("lathe"); }
};

std::vector<Section> sections_of(const fs::path& file) {
    std::vector<Section> sections;
    std::istringstream lines(kadr::read_file(file.string()).value_or(""));
    for (std::string line; std::getline(lines, line);) {
        if (line.empty()) continue;
        if (line.starts_with("[")) sections.push_back({line.substr(1), {}});
        else if (line.starts_with("  ")) sections.back().rows.back().message = line.substr(2);
        else sections.back().rows.push_back({line, ""});
    }
    return sections;
}

std::vector<fs::path> files() {
    std::vector<fs::path> all;
    for (const auto& entry : fs::directory_iterator(fs::path(KADR_ROOT) / "tests/stdlib/refusals"))
        all.push_back(entry.path());
    std::ranges::sort(all);
    return all;
}

/// A text between quotation marks, as a program has it.
std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
        if (c == '{' || c == '}') out += c;
    }
    return out + '"';
}

std::string program_of(const Section& section) {
    std::string text = "import " + section.module() + ";\n";
    if (section.module() == "prelude") text.clear();
    for (std::size_t i = 0; i < section.rows.size(); ++i) {
        const std::string& call = section.rows[i].call;
        const bool is_bare = call.starts_with("bare: ");
        const std::string name = "case" + std::to_string(i);
        const std::string body = is_bare ? call.substr(6) : call;
        text += is_bare ? "program " + name + "() { G0 X0 Y0 Z50; " : "void " + name + "() { ";
        if (section.is_lathe() && is_bare) text += "G18; DIAMON; G95; G0 X90 Z60; ";
        else if (section.is_lathe()) text += "G18; DIAMON; G95 F0.2; G0 X90 Z60; ";
        text += body + (body.ends_with('}') ? " }\n" : "; }\n");
        text += "test " + quoted(std::to_string(i)) + " { auto run = attempt(" + name +
                "()); expect(run.message == " + quoted(section.rows[i].message) + "); }\n";
    }
    return text;
}

/// What is found instead of the message of a row, by its number.
std::map<std::size_t, std::string> found_in(const Section& section, const std::string& output) {
    std::map<std::size_t, std::string> found;
    const std::string before = "`run.message` is \"";
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("failed  ")) continue;
        const std::size_t row = std::stoul(line.substr(8));
        const std::size_t at = line.find(before);
        if (at == std::string::npos) {
            found[row] = line;
            continue;
        }
        const std::string behind = "\", expected \"" + section.rows[row].message + '"';
        const std::size_t end = line.rfind(behind);
        const std::size_t from = at + before.size();
        found[row] = line.substr(from, end - from);
    }
    return found;
}

TEST(Refusals, SayWhatIsWrong) {
    const fs::path folder = kadr::testing::scratch("refusals");
    fs::create_directories(folder);
    const std::string source = (folder / "refusals.kadr").string();
    const bool is_update = std::getenv("KADR_UPDATE") != nullptr;
    for (const fs::path& file : files()) {
        std::string updated;
        for (const Section& section : sections_of(file)) {
            SCOPED_TRACE(file.filename().string() + " [" + section.head);
            ASSERT_TRUE(kadr::write_file_whole(source, program_of(section)));
            std::vector<std::string> words = {KADR_BINARY, "test", source, "-d", "iso"};
            if (section.is_lathe()) words.insert(words.end(), {"-m", "lathe"});
            const ProcessResult result = run_process(words);
            const auto found = found_in(section, result.out);
            EXPECT_TRUE(result.out.find(" tests, ") != std::string::npos ||
                        result.out.find(" test, ") != std::string::npos)
                << result.err;
            updated += (updated.empty() ? "[" : "\n[") + section.head + '\n';
            for (std::size_t i = 0; i < section.rows.size(); ++i) {
                const Row& row = section.rows[i];
                EXPECT_FALSE(row.message.empty() && !is_update) << row.call;
                const bool is_other = found.contains(i);
                EXPECT_FALSE(is_other && !is_update)
                    << row.call << "\n  says " << (is_other ? found.at(i) : "");
                updated += row.call + "\n  " + (is_other ? found.at(i) : row.message) + '\n';
            }
        }
        if (is_update) {
            ASSERT_TRUE(kadr::write_file_whole(file.string(), updated));
        }
    }
    fs::remove_all(folder);
}

// ---------------------------------------------------------------- every require has its row

/// The pieces of a text between what is formatted into it.
std::vector<std::string> pieces_of(const std::string& text) {
    std::vector<std::string> pieces(1);
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '{' && depth++ == 0) pieces.emplace_back();
        if (depth == 0) pieces.back() += text[i];
        if (text[i] == '}') --depth;
    }
    return pieces;
}

/// Whether a message is one of these pieces in their order.
bool fits(const std::string& message, const std::vector<std::string>& pieces) {
    if (!message.starts_with(pieces.front()) || !message.ends_with(pieces.back())) return false;
    std::size_t at = 0;
    for (const std::string& piece : pieces) {
        at = message.find(piece, at);
        if (at == std::string::npos) return false;
        at += piece.size();
    }
    return true;
}

/// The last text of a call that begins at `at`, behind its parenthesis; empty: it has none.
std::string last_text(const std::string& source, std::size_t at) {
    std::string text;
    int depth = 1;
    for (std::size_t i = at; i < source.size() && depth > 0; ++i) {
        if (source[i] == '(') ++depth;
        if (source[i] == ')') --depth;
        if (source[i] != '"') continue;
        text.clear();
        // A text may stand inside of another one, in braces.
        int braces = 0;
        for (++i; i < source.size() && (source[i] != '"' || braces > 0); ++i) {
            if (source[i] == '{') ++braces;
            if (source[i] == '}') --braces;
            text += source[i];
        }
    }
    return text;
}

/// Sources of the library without comments.
std::string without_comments(const std::string& source) {
    std::string out;
    std::istringstream lines(source);
    for (std::string line; std::getline(lines, line);) {
        const bool is_comment = line.substr(0, line.find_first_not_of(' ')).size() < line.size() &&
                                line.substr(line.find_first_not_of(' ')).starts_with("//");
        if (!is_comment) out += line + '\n';
    }
    return out;
}

/// What no parameter is known to come to: a guard against contours that the library makes itself.
const std::set<std::string> kGuards = {
    "a tool of this size cannot follow the contour in one piece"};

TEST(Refusals, EveryRequirementOfTheLibraryHasOne) {
    std::vector<std::string> messages;
    for (const fs::path& file : files()) {
        for (const Section& section : sections_of(file)) {
            for (const Row& row : section.rows) messages.push_back(row.message);
        }
    }
    int requirements = 0;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(KADR_ROOT) / "stdlib")) {
        if (entry.path().extension() != ".kadr") continue;
        const std::string source =
            without_comments(kadr::read_file(entry.path().string()).value_or(""));
        for (const std::string word : {" require(", " error("}) {
            for (std::size_t at = source.find(word); at != std::string::npos;
                 at = source.find(word, at + 1)) {
                const std::string text = last_text(source, at + word.size());
                const std::vector<std::string> pieces = pieces_of(text);
                ++requirements;
                if (kGuards.contains(text)) continue;
                EXPECT_TRUE(std::ranges::any_of(
                    messages, [&](const std::string& message) { return fits(message, pieces); }))
                    << entry.path().filename().string() << ": " << text;
            }
        }
    }
    EXPECT_GT(requirements, 400);
}

}  // namespace

}  // namespace refusals_test
