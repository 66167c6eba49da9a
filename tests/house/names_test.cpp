// One type name means one thing: a stranger who has learned a name knows it in every room.
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"

namespace names_test {

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = KADR_ROOT;

/// The types that a text defines outside of other types; those inside say by their owner what they
/// are.
std::vector<std::string> types_in(const std::string& text) {
    static const std::regex kType(
        R"((?:^|\n)(?:template <[^\n]*>\n)?(?:struct|class|enum class|enum) (\w+)(?: final)?(?: : [^;{]*)? \{)");
    std::vector<std::string> names;
    for (std::sregex_iterator match(text.begin(), text.end(), kType), end; match != end; ++match)
        names.push_back((*match)[1]);
    return names;
}

TEST(House, OneTypeNameMeansOneThing) {
    std::map<std::string, std::set<std::string>> files;  // by name
    for (const char* part : {"runtime", "compiler"}) {
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / part)) {
            const std::string extension = entry.path().extension().string();
            if (extension != ".h" && extension != ".cpp") continue;
            const std::string text = kadr::read_file(entry.path().string()).value_or("");
            for (const std::string& name : types_in(text))
                files[name].insert(fs::relative(entry.path(), kRoot).string());
        }
    }
    EXPECT_GT(files.size(), 900u);
    for (const auto& [name, places] : files) {
        if (places.size() == 1) continue;
        std::string list;
        for (const std::string& file : places) list += ' ' + file;
        ADD_FAILURE() << name << " is the name of several types:" << list;
    }
}

TEST(House, ATypeIsFoundByItsDefinition) {
    const std::vector<std::string> expected = {"A", "B", "C", "D"};
    EXPECT_EQ(types_in("struct A {\n    struct Inside {\n};\nclass B final : public A {\n};\n"
                       "struct Later;\nenum class C : std::uint8_t { X };\n"
                       "template <typename T>\nstruct D {\n};\n"),
              expected);
}

}  // namespace

}  // namespace names_test
