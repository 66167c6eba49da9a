// What a run puts out is a table (driver/outputs.def): every row is an option and does what it
// says.
#include "driver/outputs.h"

#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "tests/driver/scratch.h"

namespace outputs_test {

namespace {

using namespace kadr;
using driver::output_rows;
using driver::OutputRow;
using Kind = driver::OutputRow::Kind;

class OutputTable : public kadr::test::ScratchFolder {};

TEST_F(OutputTable, RowsAreApart) {
    std::set<std::string_view> flags;
    std::set<int> turns;
    for (const OutputRow& row : output_rows()) {
        EXPECT_TRUE(flags.insert(row.flag).second) << row.flag;
        EXPECT_EQ(&driver::output_row(row.flag), &row);
        if (row.kind == Kind::Setting) continue;
        EXPECT_TRUE(turns.insert(row.turn).second) << row.flag << " has the turn of another one";
        EXPECT_NE(row.make, nullptr) << row.flag;
    }
}

TEST_F(OutputTable, EveryRowIsAnOptionWithItsHelp) {
    const std::string help = kadr({"run", "--help"}).out;
    const std::string expand = kadr({"expand", "--help"}).out;
    for (const OutputRow& row : output_rows()) {
        const std::string option = "  " + std::string(row.flag) + ' ' + std::string(row.value);
        EXPECT_NE(help.find(option), help.npos) << option;
        EXPECT_EQ(expand.find(option) != expand.npos, row.kind == Kind::FileOfExpansion) << option;
    }
}

/// Every output by itself: a file that is not empty, or standard output, and nothing else.
TEST_F(OutputTable, EveryOutputIsWritten) {
    // Those that only some machines have.
    const std::map<std::string_view, std::string> machines = {{"--drive", "lathe"},
                                                              {"--scanner", "scanner"}};
    save("part.kadr", "program p() { tool(1); S1000 M3; F600; G0 X10 Z5; G1 X20; G1 Z-1; M30; }\n");
    save("part.nc", "O1\nPOPEN\nDPRNT[X#1[53]]\nPCLOS\n#500=1\nM30\n%\n");
    std::size_t outputs = 0;
    for (const OutputRow& row : output_rows()) {
        if (row.kind == Kind::Setting) continue;
        SCOPED_TRACE(row.flag);
        ++outputs;
        const bool is_word = row.kind == Kind::Word;
        const bool is_of_control = row.flag == "--print" || row.flag == "--variables";
        const auto machine = machines.find(row.flag);
        const std::string value =
            is_word ? std::string(row.value.substr(0, row.value.find('|'))) : file("out");
        const auto result = kadr(
            {"run", file(is_of_control ? "part.nc" : "part.kadr"), "-d", "fanuc", "-m",
             machine == machines.end() ? "mill" : machine->second, std::string(row.flag), value});
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.out.empty(), !is_word) << result.out;
        EXPECT_EQ(read_file(file("out")).value_or("").empty(), is_word);
        std::filesystem::remove(file("out"));
    }
    EXPECT_GT(outputs, 10u);
}

/// Nothing is asked for: the summary is written for a person. A setting asks for no output.
TEST_F(OutputTable, WithoutOutputsThereIsASummary) {
    save("part.mpf", "T1 D1\nS500 M3\nG1 X10 F500\nM30\n");
    const auto plain = kadr({"run", file("part.mpf"), "-d", "sinumerik"});
    const auto text = kadr({"run", file("part.mpf"), "-d", "sinumerik", "--summary", "text"});
    const auto set = kadr({"run", file("part.mpf"), "-d", "sinumerik", "--plot-color", "line"});
    EXPECT_NE(plain.out, "");
    EXPECT_EQ(plain.out, text.out);
    EXPECT_EQ(plain.out, set.out);
    EXPECT_EQ(kadr({"run", file("part.mpf"), "-d", "sinumerik", "--trace", file("t")}).out, "");
}

}  // namespace

}  // namespace outputs_test
