// Which file of a dialect defines what, and where its `extends` leads.
#include "nc/dialect_chain.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "base/disk_files.h"

namespace kadr::nc::dialect_chain_test {
namespace {

namespace fs = std::filesystem;
using Kind = ChainEntry::Kind;

const SearchPath kFolders = {KADR_ROOT "/tests/control/dialects", KADR_ROOT "/dialects"};

std::string file_name(const DialectChain& chain, std::size_t file) {
    return fs::path(chain.files[file].path).filename().string();
}

/// `fanuc.xml G65, iso.xml G65 hidden`: the entries of a name, with what stands at their ranges.
std::string shown(const DialectChain& chain, const Sources& sources, Kind kind,
                  std::string_view name) {
    std::string all;
    for (const ChainEntry* const entry : entries_of(chain, kind, name)) {
        all += (all.empty() ? "" : ", ") + file_name(chain, entry->file) + ' ';
        all += std::string(sources.text(entry->range)) + (entry->acts ? "" : " hidden");
    }
    return all;
}

TEST(DialectChain, GoesToTheRoot) {
    Sources sources;
    const DialectChain chain = dialect_chain("fanuc-calls", kFolders, sources);
    ASSERT_EQ(chain.files.size(), 3u);
    EXPECT_TRUE(chain.is_whole);
    EXPECT_EQ(file_name(chain, 0), "fanuc-calls.xml");
    EXPECT_EQ(file_name(chain, 1), "fanuc.xml");
    EXPECT_EQ(chain.files[2].name, "iso");
    EXPECT_EQ(sources.text(chain.files[1].extends), "iso");
    EXPECT_FALSE(chain.files[2].extends.file.is_valid());
    const SourceRange& extends = chain.files[0].extends;
    EXPECT_EQ(extended_at(chain, extends.file, extends.begin + 1), &chain.files[1]);
    EXPECT_EQ(extended_at(chain, extends.file, extends.end + 1), nullptr);
}

TEST(DialectChain, KnowsWhoDefinesWhat) {
    Sources sources;
    const DialectChain chain = dialect_chain("fanuc-calls", kFolders, sources);
    const auto entries = [&](Kind kind, std::string_view name) {
        return shown(chain, sources, kind, name);
    };
    EXPECT_EQ(entries(Kind::Call, "M60"), "fanuc-calls.xml M60");
    EXPECT_EQ(entries(Kind::Call, "G65"), "fanuc.xml G65");
    EXPECT_EQ(entries(Kind::Variable, "#{n}"), "fanuc.xml #{n}");
    EXPECT_EQ(entries(Kind::Statement, "GOTO{target}"), "fanuc.xml GOTO{target}");
    EXPECT_EQ(entries(Kind::Function, "SIN[{a}]"), "fanuc.xml SIN[{a}]");
    EXPECT_EQ(entries(Kind::LanguageRule, "loop_numbers"), "fanuc.xml loop_numbers");
    EXPECT_EQ(entries(Kind::Address, "R"), "fanuc.xml R, iso.xml R");
    EXPECT_EQ(entries(Kind::Word, "NOBODY"), "");
    // FANUC spells the line anew, and takes the arc's radius CR away with its address.
    EXPECT_EQ(entries(Kind::Word, "G01"), "fanuc.xml G01");
    EXPECT_EQ(entries(Kind::Address, "CR"), "iso.xml CR hidden");
}

/// Every file that ships, each entry with the text that it names.
TEST(DialectChain, PointsAtNames) {
    for (const char* const name : {"iso", "fanuc", "fanuc-lathe-c", "sinumerik", "axioma"}) {
        Sources sources;
        const DialectChain chain = dialect_chain(name, kFolders, sources);
        EXPECT_TRUE(chain.is_whole) << name;
        EXPECT_GT(chain.entries.size(), 100u) << name;
        for (const ChainEntry& entry : chain.entries) {
            const std::string_view text = sources.text(entry.range);
            const bool has_entities = text.find('&') != std::string_view::npos;
            if (has_entities) continue;
            EXPECT_EQ(text.substr(0, entry.name.size()), entry.name) << name;
        }
    }
}

TEST(DialectChain, TellsOfWhatIsThere) {
    Sources sources;
    EXPECT_TRUE(dialect_chain("no-such-control", kFolders, sources).files.empty());
    const fs::path folder = fs::path(::testing::TempDir()) / "dialect_chain";
    fs::create_directories(folder);
    const auto write = [&](const char* file, const std::string& text) {
        ASSERT_TRUE(write_file_whole((folder / file).string(), text));
    };
    write("round.xml",
          "<dialect name=\"round\" extends=\"./round.xml\" title=\"t\" suffix=\"nc\">"
          "<rule name=\"none_such\" value=\"1\"/></dialect>");
    const DialectChain round = dialect_chain((folder / "round.xml").string(), kFolders, sources);
    ASSERT_EQ(round.files.size(), 1u);
    EXPECT_FALSE(round.is_whole);
    EXPECT_EQ(shown(round, sources, Kind::Rule, "none_such"), "round.xml none_such");
}

}  // namespace
}  // namespace kadr::nc::dialect_chain_test
