// The disk has one door: who works for a user is handed his files (base/files.h).
#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/disk_files.h"

namespace doors_test {

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = KADR_ROOT;

/// Places below `runtime` and `compiler` that match, as "file: place".
///
/// words  one of which is in every match; a file without them is not searched
std::vector<std::string> places_with(const std::regex& pattern,
                                     const std::vector<std::string>& words,
                                     const std::set<std::string>& except) {
    std::vector<std::string> places;
    for (const char* half : {"runtime", "compiler"}) {
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / half)) {
            const std::string extension = entry.path().extension().string();
            const std::string name = fs::relative(entry.path(), kRoot).generic_string();
            if ((extension != ".cpp" && extension != ".h") || except.contains(name)) continue;
            const std::string text = kadr::read_file(entry.path().string()).value();
            const bool has_word = std::ranges::any_of(words, [&](const std::string& word) {
                return text.find(word) != std::string::npos;
            });
            if (!has_word) continue;
            for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at)
                places.push_back(name + ": " + at->str());
        }
    }
    return places;
}

}  // namespace

TEST(House, TheDiskHasOneDoor) {
    // The history of the prompt belongs to the terminal's library, which opens it itself.
    const std::set<std::string> doors = {"runtime/base/disk_files.cpp",
                                         "runtime/base/disk_writing.cpp",
                                         "compiler/repl/terminal.cpp"};
    const std::vector<std::string> words = {
        "fstream", "fopen", "tmpfile", "directory_iterator", "fs::", "is_reg", "filesystem::"};
    const std::regex asks(
        R"(fstream|\bfopen\(|\btmpfile\(|directory_iterator|is_regular_file|)"
        R"((fs|filesystem)::(is_\w+|exists|status|canonical|weakly_canonical|absolute|relative|)"
        R"(equivalent|read_symlink|remove|rename|create_\w+|file_size|current_path)\b)");
    EXPECT_EQ(places_with(asks, words, doors), std::vector<std::string>{});
}

TEST(House, WhoWorksIsHandedHisFiles) {
    // The command line chooses the disk; texts that nobody gave files have those of the disk.
    const std::set<std::string> choosers = {
        "runtime/base/disk_files.cpp", "runtime/base/disk_files.h", "runtime/base/disk_writing.cpp",
        "runtime/base/source.cpp",     "compiler/cli/main.cpp",     "compiler/cli/options.cpp"};
    const std::regex chooses(R"(\bdisk\(\)|#include "base/disk_files\.h")");
    EXPECT_EQ(places_with(chooses, {"disk"}, choosers), std::vector<std::string>{});
}

}  // namespace doors_test
