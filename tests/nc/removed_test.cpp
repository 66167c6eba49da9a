// A dialect that extends a shipped one and removes an address or a command: what the control lacks
// is a message, wherever a program wants it. The blocks are those of whole parts, read from their
// texts; each removal writes and reads a part of them, and arcs of every kind.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "nc/tables.h"
#include "tests/common/scratch.h"
#include "tests/golden/parts.h"
#include "tests/nc/nc_testing.h"
#include "write/writer.h"

namespace kadr::nc::removed_test {
namespace {

namespace fs = std::filesystem;
using testing::shipped;

struct Part {
    std::string text;
    std::vector<Block> blocks;
};

/// The parts of the golden texts for a dialect, and what they have not.
std::vector<Part> parts_for(const std::string& dialect) {
    constexpr std::size_t kMostBytes = 6000;  // of a part: the rest is more of the same
    std::vector<Part> parts;
    for (const fs::path& file : golden::texts_for(dialect)) {
        std::string text = read_file(file.string()).value_or("");
        if (text.size() > kMostBytes) text.resize(text.rfind('\n', kMostBytes) + 1);
        parts.push_back({text, testing::read_blocks(shipped(dialect), text).blocks});
    }
    Part arcs;
    for (const char* statement : {"G0 X0 Y0 Z0",
                                  "G2 X5 Y5 I5 J0 F100",
                                  "G3 X9 Y2 CR=20",
                                  "G3 X9 Y2 Z-4 I-3 J1 TURN=2",
                                  "G18",
                                  "G2 X4 Z-2 I2 K3",
                                  "G3 X4 Z4 CR=-9",
                                  "G19",
                                  "G2 Y4 Z2 J2 K3",
                                  "G3 Y4 Z9 CR=9",
                                  "G17",
                                  "G91",
                                  "G2 X1 Y1 I1 J0",
                                  "G90",
                                  "G2 X=AC(5) Y=AC(5) I=AC(1) J=AC(1)",
                                  "G33 Z-20 K2",
                                  "G41",
                                  "G42",
                                  "G40",
                                  "S100 M3",
                                  "G4 P1",
                                  "M30"}) {
        arcs.blocks.push_back(testing::source_block(shipped("iso"), statement));
    }
    parts.push_back(std::move(arcs));
    return parts;
}

/// Writes and reads the parts with the dialect. What cannot be written is told, and what is written
/// is read again.
void try_parts(const Dialect& dialect, std::span<const Part> parts) {
    static std::size_t turn = 0;  // which part comes next
    constexpr std::size_t kAtOnce = 4;
    for (std::size_t i = 0; i < std::min(kAtOnce, parts.size()); ++i) {
        const Part& part = i == 0 ? parts.back() : parts[turn++ % parts.size()];
        testing::read_blocks(dialect, part.text);
        DiagnosticList sink;
        write::Writer writer(dialect, {}, sink);
        std::string text;
        writer.begin({"part", 1, "", false}, text);
        for (const Block& block : part.blocks) writer.write(block, text);
        writer.end(text);
        const bool has_error =
            std::any_of(sink.all().begin(), sink.all().end(),
                        [](const Diagnostic& one) { return one.row->severity == Severity::Error; });
        EXPECT_EQ(writer.failed(), has_error) << testing::codes(sink);
    }
}

void try_without(const std::string& base, const char* kind, const std::string& name,
                 std::span<const Part> parts) {
    SCOPED_TRACE(base + " without " + name);
    const std::string path = kadr::testing::scratch("reduced.xml");
    std::ofstream(path) << "<dialect name=\"reduced\" extends=\"" << base
                        << "\" title=\"t\" suffix=\"t\"><doc>d</doc><remove " << kind << "=\""
                        << name << "\"/></dialect>";
    Sources sources;
    DiagnosticList sink;
    const auto dialect = load_dialect(path, testing::dialect_folders(), sources, sink);
    if (dialect) try_parts(*dialect, parts);
    else EXPECT_FALSE(sink.all().empty());
}

class Removed : public ::testing::TestWithParam<const char*> {};

TEST_P(Removed, EachAddress) {
    const std::vector<Part> parts = parts_for(GetParam());
    for (const Address& address : shipped(GetParam()).tables().addresses) {
        if (!address.name.empty() && address.name.find_first_of("()<>&\" ") == std::string::npos)
            try_without(GetParam(), "addresses", address.name, parts);
    }
}

TEST_P(Removed, EachCommand) {
    const std::vector<Part> parts = parts_for(GetParam());
    const auto& tables = shipped(GetParam()).tables();
    for (std::size_t i = 1; i < tables.forms_of.size(); ++i) {
        const auto function = static_cast<Function>(i);
        if (!tables.forms_of[i].empty())
            try_without(GetParam(), "commands", std::string(info(function).name), parts);
    }
}

INSTANTIATE_TEST_SUITE_P(Dialects, Removed,
                         ::testing::Values("iso", "sinumerik", "fanuc", "fanuc-lathe", "axioma"),
                         [](const auto& dialect) {
                             std::string name = dialect.param;
                             std::erase(name, '-');
                             return name;
                         });

/// What the writer says of the statements, with a dialect that lacks these words or commands.
std::string said_without(const std::string& base, const std::string& removed,
                         std::initializer_list<const char*> statements) {
    const std::string path = kadr::testing::scratch("lacking.xml");
    std::ofstream(path) << "<dialect name=\"lacking\" extends=\"" << base
                        << "\" title=\"t\" suffix=\"t\"><doc>d</doc><remove " << removed
                        << "/></dialect>";
    Sources sources;
    DiagnosticList sink;
    const auto dialect = load_dialect(path, testing::dialect_folders(), sources, sink);
    EXPECT_TRUE(dialect) << testing::rendered(sink, sources);
    if (!dialect) return {};
    write::Writer writer(*dialect, {}, sink);
    std::string text;
    writer.begin({"part", 1, "", false}, text);
    for (const char* statement : statements)
        writer.write(testing::source_block(shipped("iso"), statement), text);
    return sink.all().empty() ? "" : sink.all()[0].message();
}

// A message names what the control lacks.
TEST(RemovedWords, AreNamed) {
    struct Row {
        const char* base;
        const char* removed;
        std::initializer_list<const char*> statements;
        const char* said;
    };
    for (const Row& row : {
             Row{"iso",
                 "addresses=\"I J K\"",
                 {"G0 X0 Y0 Z0", "G2 X5 Y5 I5 J0 F100"},
                 "an arc centre"},
             {"fanuc", "addresses=\"I\"", {"G0 X0 Y0 Z0", "G2 X5 Y5 I5 J0 F100"}, "an arc centre"},
             {"sinumerik",
              "addresses=\"K\"",
              {"G0 X0 Y0 Z0", "G18", "G2 X4 Z-2 I2 K3 F100"},
              "an arc centre"},
             {"fanuc", "addresses=\"F\"", {"G0 X0 Y0 Z0", "G1 X5 F100"}, "`F`"},
             {"fanuc", "addresses=\"Z\"", {"G0 X0 Y0 Z0"}, "Z"},
             {"iso", "addresses=\"S\"", {"S100 M3"}, "`S`"},
             {"sinumerik", "addresses=\"LIMS\"", {"LIMS=500"}, "`speed_limit`"},
             {"fanuc", "addresses=\"P\"", {"G4 P1"}, "`dwell`"},
             {"fanuc", "commands=\"dwell\"", {"G4 P1"}, "`dwell`"},
             {"iso", "commands=\"arc_cw\"", {"G0 X0 Y0 Z0", "G2 X5 Y5 I5 J0 F100"}, "`arc_cw`"},
             {"sinumerik", "commands=\"radius_comp_left\"", {"G41"}, "`radius_comp_left`"},
             {"fanuc", "commands=\"coolant_flood\"", {"M8"}, "`coolant_flood`"},
         }) {
        SCOPED_TRACE(std::string(row.base) + " without " + row.removed);
        const std::string text = said_without(row.base, row.removed, row.statements);
        EXPECT_NE(text.find(row.said), std::string::npos) << text;
        EXPECT_NE(text.find("lacking"), std::string::npos) << text;
    }
}

}  // namespace
}  // namespace kadr::nc::removed_test
