// What the sources of the interpreter and of the controls' languages keep to, beyond what the
// compiler sees.
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"

namespace interp_test {

namespace {

namespace fs = std::filesystem;

const std::vector<fs::path> kRooms = {fs::path(KADR_ROOT) / "runtime/interp",
                                      fs::path(KADR_ROOT) / "runtime/macro"};

/// The headers of these rooms, or the sources as well.
std::vector<fs::path> files_of_rooms(bool with_sources) {
    std::vector<fs::path> files;
    for (const fs::path& room : kRooms) {
        for (const fs::directory_entry& entry : fs::directory_iterator(room)) {
            const std::string extension = entry.path().extension();
            if (extension == ".h" || (with_sources && extension == ".cpp"))
                files.push_back(entry.path());
        }
    }
    return files;
}

/// What has a few meanings is an enum (modes.h), not one function of the whole vocabulary. What
/// stays is the modal motion: blocks are read, compared and written with it.
TEST(Interp, NoStateIsAnyFunction) {
    const std::set<std::string> motions = {"motion_kind.h: motion", "motion_words.h: motion",
                                           "state.h: motion", "through_run.h: function"};
    static const std::regex member(R"(\n +(?:nc::)?Function (\w+)(?:\s*=\s*[^;]+|\{[^;]*\})?;)");
    std::set<std::string> found;
    for (const fs::path& file : files_of_rooms(false)) {
        const std::string text = kadr::read_file(file).value_or("");
        for (std::sregex_iterator at(text.begin(), text.end(), member), end; at != end; ++at)
            found.insert(file.filename().string() + ": " + (*at)[1].str());
    }
    EXPECT_EQ(found, motions);
}

/// A function of the sources, as far as its head and its end can be told by the layout.
struct Definition {
    std::string file;
    std::string name;
    std::string body;
};

/// All functions that return the type, in the sources and in classes of the headers.
std::vector<Definition> definitions_of(const std::string& type) {
    const std::regex head(R"(\n( *)(?:static |inline |constexpr )*)" + type +
                          R"( ((?:\w+::)*\w+)\([^;{}]*\)[^;{}]*\{)");
    std::vector<Definition> found;
    for (const fs::path& file : files_of_rooms(true)) {
        const std::string text = kadr::read_file(file).value_or("");
        for (std::sregex_iterator at(text.begin(), text.end(), head), end; at != end; ++at) {
            const auto begin = static_cast<std::size_t>(at->position() + at->length());
            const std::size_t line = text.find('\n', begin);
            const bool is_one_line = text[line - 1] == '}';
            const std::size_t last =
                is_one_line ? line : text.find('\n' + (*at)[1].str() + '}', begin);
            found.push_back({file.filename(), (*at)[2], text.substr(begin, last - begin)});
        }
    }
    return found;
}

/// What may refuse says Done: a bool would leave open which of its values is which.
TEST(Interp, NoBoolTellsOfAMistake) {
    static const std::regex tells(R"(\b(?:report|fail|require_\w+|refuse_\w+)\()");
    const std::vector<Definition> questions = definitions_of("bool");
    EXPECT_GT(questions.size(), 100u);
    for (const Definition& question : questions)
        EXPECT_FALSE(std::regex_search(question.body, tells))
            << question.file << ": " << question.name;
}

/// … and is named by what it does, not as a question.
TEST(Interp, NoQuestionIsDone) {
    static const std::regex question(R"((?:.*::)?(?:is|has|needs|can|may|refuses)_\w+)");
    const std::vector<Definition> verbs = definitions_of("Done");
    EXPECT_GT(verbs.size(), 50u);
    for (const Definition& verb : verbs)
        EXPECT_FALSE(std::regex_match(verb.name, question)) << verb.file << ": " << verb.name;
}

}  // namespace

}  // namespace interp_test
