// CSV tables: mistakes are named with file, row and column.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/disk_files.h"
#include "sema/csv.h"
#include "tests/sema/running.h"

namespace kadr::testing::tables_test {
namespace {

class Tables : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ =
            std::filesystem::temp_directory_path() / ("kadr_tables_" + std::to_string(::getpid()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    Outcome read(const std::string& csv, const std::string& file = "t.csv") {
        std::ofstream(folder_ / "t.csv", std::ios::binary) << csv;
        RunOptions options;
        options.file = (folder_ / "test.kadr").string();
        return run(
            "struct row { length d; angle? a; int n = 1; string s; }\n"
            "program p() { for (row r : table<row>(\"" +
                file + "\")) note \"{r.d} {r.n} {r.s} {r.a ?? 0deg}\"; }",
            options);
    }

    std::filesystem::path folder_;
};

TEST_F(Tables, AreReadWithUnitsAndQuotes) {
    const Outcome plain = read(
        "\xEF\xBB\xBF"
        "d [in], a, n, s\r\n1,30,2,\"a \"\"b\"\", c\"\r\n\r\n# comment\n2mm,,3,x\n");
    EXPECT_EQ(plain.all_messages(), "");
    EXPECT_EQ(plain.all_blocks(), "comment \"25.4 2 a \"b\", c 30\"\ncomment \"2 3 x 0\"");
    // As spreadsheets write it where the comma is the decimal sign; an optional column may be
    // missing.
    const Outcome semicolons = read("s;d;n\nx;1,5;2\n");
    EXPECT_EQ(semicolons.all_messages(), "");
    EXPECT_EQ(semicolons.all_blocks(), "comment \"1.5 2 x 0\"");
    // A column that is missing is the default of its member; an empty cell is none.
    const Outcome without = read("s,d\nx,2\ny,3\n");
    EXPECT_EQ(without.all_messages(), "");
    EXPECT_EQ(without.all_blocks(), "comment \"2 1 x 0\"\ncomment \"3 1 y 0\"");
}

TEST_F(Tables, MissingColumnsAreTheDefaultsOfTheirMembers) {
    std::ofstream(folder_ / "t.csv", std::ios::binary) << "at.x,d [mm]\n1,5\n";
    RunOptions options;
    options.file = (folder_ / "test.kadr").string();
    const Outcome outcome = run(
        "units inch;\n"
        "enum kind { blind, through }\n"
        "struct place { length x; length y = 2; }\n"
        "struct row { place at; length d; length? c = 1mm; kind k = through; bool deep = true;\n"
        "    string s = \"drill\"; real f = 0.5; feed v = 100mm/min; angle a = 45; }\n"
        "program p() {\n"
        "    for (row r : table<row>(\"t.csv\"))\n"
        "        note \"{r.at.x} {r.at.y} {r.d:.4} {r.c ?? 9:.4} {r.k} {r.deep} {r.s} {r.f} "
        "{r.v:.3} "
        "{r.a}\"; }",
        options);
    EXPECT_EQ(outcome.all_messages(), "");
    EXPECT_EQ(outcome.all_blocks(),
              "comment \"1 2 0.1969 0.0394 through true drill 0.5 3.937 45\"");
}

TEST_F(Tables, MistakesHaveRowAndColumn) {
    struct Row {
        const char* csv;
        const char* messages;
    };
    const Row rows[] = {
        {"", "1:1 K2403"},
        {"d,n,s,x\n1,1,a,2\n", "1:7 K2404"},
        {"d,n,s,d\n1,1,a,2\n", "1:7 K2405"},
        {"n,s\n1,a\n", "1:1 K2406"},
        {"dd,n,s\n1,1,a\n", "1:1 K2406"},
        {"d [deg],n,s\n1,1,a\n", "1:1 K2407"},
        {"d [foo],n,s\n1,1,a\n", "1:1 K2407"},
        {"d,n,s\n1,1\n", "2:1 K2408"},
        {"d,n,s\n1,1,a\nbig,1,a\n", "3:1 K2409"},
        {"d,n,s\n1,1.5,a\n", "2:3 K2409"},
        {"d,n,s\n5deg,1,a\n", "2:1 K2409"},
        {"d,n,s\n1,,a\n", "2:3 K2410"},
        {"d,n,s\n1,1,\"a\n", "2:1 K2411"},
        {"d,n,s\n\"1,1,a\n", "2:1 K2411"},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.csv);
        const Outcome outcome = read(row.csv);
        ASSERT_EQ(outcome.messages, std::vector<std::string>{row.messages});
        EXPECT_EQ(outcome.notes, std::vector<std::string>{"2:39 the table is read here"});
    }
    EXPECT_EQ(read("d,n,s\n", "none.csv").messages, std::vector<std::string>{"2:39 K2402"});
    EXPECT_EQ(read("d,n,s\nx,y,a\n").messages,
              (std::vector<std::string>{"2:1 K2409", "2:3 K2409"}));
}

/// A picture file read by name, by a constant one and by one that only the program knows.
class Pictures : public Tables {
  protected:
    Outcome read_picture(const std::string& bytes) {
        std::ofstream(folder_ / "p.pgm", std::ios::binary) << bytes;
        RunOptions options;
        options.file = (folder_ / "test.kadr").string();
        return run(
            "struct picture { int width; real[] dots; int height; }\n"
            "program p() { string name = \"p\"; picture a = image<picture>(\"p.pgm\");\n"
            "picture b = image<picture>(name + \".pgm\");\n"
            "assert(a.dots.count == b.dots.count && a.width == b.width, \"the same\");\n"
            "note \"{a.width} x {a.height}\"; for (real v : b.dots) note \"{v:.4}\"; }",
            options);
    }
};

TEST_F(Pictures, AreBrightnessFromTheTopDown) {
    // 64/128 = 0.5; bytes of two: 0x0100 = 256 of 1024 = 0.25.
    const Outcome text = read_picture("P2 # grey\n3 # wide\n1\n128 0 64\n128");
    EXPECT_EQ(text.all_messages(), "");
    EXPECT_EQ(text.all_blocks(),
              "comment \"3 x 1\"\ncomment \"0.0000\"\ncomment \"0.5000\"\ncomment \"1.0000\"");
    const Outcome bytes = read_picture(std::string("P5 1 2 200\n") + '\xc8' + '\x0a');
    EXPECT_EQ(bytes.all_messages(), "");
    EXPECT_EQ(bytes.all_blocks(), "comment \"1 x 2\"\ncomment \"1.0000\"\ncomment \"0.0500\"");
    const Outcome wide = read_picture(std::string("P5\n#c\n2 1 1024\n") + '\x01' +
                                      std::string(1, '\0') + "\x04" + std::string(1, '\0') + "\n");
    EXPECT_EQ(wide.all_messages(), "");
    EXPECT_EQ(wide.all_blocks(), "comment \"2 x 1\"\ncomment \"0.2500\"\ncomment \"1.0000\"");
}

/// Each row takes a register for every member of the struct, in the file or not.
TEST_F(Tables, HaveALimit) {
    std::string csv = "d\n";
    for (int i = 0; i < 800; ++i) csv += "1\n";
    std::ofstream(folder_ / "t.csv", std::ios::binary) << csv;
    sema::TableSchema schema;
    schema.type_name = "row";
    schema.slots = 65535;
    schema.columns.emplace_back().name = "d";
    DiagnosticList messages;
    FileAccess access(disk());
    access.allow(folder_.string());
    const auto rows =
        sema::read_table(schema, {}, (folder_ / "t.csv").string(), {}, &access, messages);
    EXPECT_FALSE(rows);
    ASSERT_EQ(messages.all().size(), 1u);
    EXPECT_EQ(messages.all()[0].row->code, "K2624");
}

bool is_only(const Outcome& outcome, const std::string& code) {
    return outcome.messages.size() == 1 && outcome.messages[0].ends_with(code);
}

TEST_F(Pictures, AreNamedWithTheirMistakes) {
    EXPECT_TRUE(is_only(read_picture(""), "K2413"));
    EXPECT_TRUE(is_only(read_picture("P2"), "K2414"));
    EXPECT_TRUE(is_only(read_picture("P2 2 2 -1"), "K2414"));
    EXPECT_TRUE(is_only(read_picture("P2 2 2 65536 1 1 1 1"), "K2414"));
    EXPECT_TRUE(is_only(read_picture("P2 99999999999999999999 2 1"), "K2414"));
    EXPECT_TRUE(is_only(read_picture("P2 1 1 9 1.5"), "K2416"));
    EXPECT_TRUE(is_only(read_picture("P5 2 2 255"), "K2417"));
    EXPECT_TRUE(is_only(read_picture("P5 2 1 1024\n\x01\x01\x01"), "K2417"));
    EXPECT_TRUE(is_only(read_picture("P2 50000000 1 9"), "K2417"));
}

}  // namespace
}  // namespace kadr::testing::tables_test
