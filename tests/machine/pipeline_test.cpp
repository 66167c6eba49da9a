// The element <pipeline> of a machine file: what it says, and what is said about its mistakes.
#include <cstdio>
#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "machine/machine.h"
#include "machine/setpoint_columns.h"

namespace kadr::machine::pipeline_test {
namespace {

struct Loaded {
    std::optional<Machine> machine;
    std::vector<std::string> lines;  // "K6242 dwel"
};

/// A machine with an axis and this pipeline.
Loaded load(const std::string& pipeline, const std::string& beside = "") {
    const std::string path = (std::filesystem::temp_directory_path() /
                              ("kadr-pipeline-" + std::to_string(::getpid()) + ".xml"))
                                 .string();
    EXPECT_TRUE(
        write_file_whole(path,
                         "<machine name=\"m\" tick=\"2 ms\"><axis name=\"X\" velocity=\"1 m/s\" "
                         "acceleration=\"1 m/s2\" limits=\"-1..1 m\"/>" +
                             pipeline + beside + "</machine>"));
    Loaded loaded;
    Sources sources;
    DiagnosticList diagnostics;
    loaded.machine = load_machine(path, {}, sources, diagnostics);
    std::remove(path.c_str());
    for (const Diagnostic& diagnostic : diagnostics.all())
        loaded.lines.push_back(std::string(diagnostic.row->code) + ' ' + diagnostic.message());
    return loaded;
}

TEST(Pipeline, IsWhatTheProgramHasWithoutOne) {
    const Loaded plain = load("");
    ASSERT_TRUE(plain.machine);
    const Pipeline& pipeline = plain.machine->pipeline;
    EXPECT_EQ(pipeline.ahead, 1024u);
    EXPECT_TRUE(pipeline.modules.empty());
    EXPECT_EQ(pipeline.translate.batch, 64u);
    EXPECT_EQ(pipeline.interpolate.batch, 1024u);
    EXPECT_TRUE(pipeline.setpoints.file.empty());
    EXPECT_EQ(chosen_columns(*plain.machine).size(), 10u);  // t X tip tool feed iso
}

TEST(Pipeline, SaysWhoServesWhatAndInWhichStages) {
    const Loaded loaded = load(
        "<pipeline ahead=\"300\"><serve command=\"dwell\" by=\"none\"/>"
        "<serve command=\"function\" by=\"press\"/>"
        "<translate period=\"0.5 s\" batch=\"7\" queue=\"2\"/><interpolate period=\"10 ms\" "
        "queue=\"9\"/><output period=\"0.1 s\" file=\"{program}.npy\" columns=\"t axes iso\"/>"
        "</pipeline>");
    ASSERT_TRUE(loaded.machine) << loaded.lines.front();
    const Pipeline& pipeline = loaded.machine->pipeline;
    EXPECT_EQ(pipeline.ahead, 300u);
    ASSERT_EQ(pipeline.modules.size(), 2u);
    EXPECT_EQ(pipeline.modules[0].command, path::Op::Dwell);
    EXPECT_EQ(pipeline.modules[0].module, "none");
    EXPECT_EQ(pipeline.modules[1].module, "press");
    EXPECT_DOUBLE_EQ(pipeline.translate.period, 0.5);
    EXPECT_EQ(pipeline.translate.batch, 7u);
    EXPECT_EQ(pipeline.translate.queue, 2u);
    EXPECT_EQ(pipeline.interpolate.batch, 5u);  // ticks of 2 ms
    EXPECT_EQ(pipeline.interpolate.queue, 9u);
    EXPECT_EQ(pipeline.output.batch, 50u);
    EXPECT_EQ(pipeline.setpoints.file, "{program}.npy");
    EXPECT_EQ(chosen_columns(*loaded.machine), (std::vector<std::size_t>{0, 1, 9}));
}

TEST(Pipeline, MistakesAreSaid) {
    const struct {
        const char* text;
        const char* says;
    } kRows[] = {
        {"<serve command=\"dwel\" by=\"none\"/>", "K6242 `dwel` is no command"},
        {"<serve command=\"spindle\" by=\"none\"/>", "K6242 `spindle` is no command"},
        {"<serve command=\"dwell\" by=\"none\"/><serve command=\"dwell\" by=\"none\"/>", "K6014"},
        {"<serve command=\"arc\" by=\"none\"/>", "K6244 `arc` moves the tool"},
        {"<serve command=\"line\" by=\"scanner\"/>",
         "K6245 `line` cannot be served by a scanner: the machine file describes none"},
        {"<serve command=\"dwell\" by=\"scanner\"/>", "K6245 `dwell` cannot"},
        {"<output period=\"3 ms\"/>", "K6246 the period 3 ms is not a whole number of ticks of 2"},
        {"<interpolate period=\"1 ms\"/>", "K6246"},
        {"<translate period=\"0 ms\"/>", "K6011"},
        {"<translate batch=\"0\"/>", "K6018"},
        {"<output columns=\"t Y\"/>", "K6247 `Y` is not a column"},
        {"<output columns=\"t t\"/>", "K6014"},
        {"<output file=\"out.txt\"/>", "K6248 setpoints cannot be put into `out.txt`: it ends"},
        {"<output file=\"{part}.csv\"/>", "K6248"},
        {"<output/><output/>", "K6014"},
    };
    for (const auto& row : kRows) {
        SCOPED_TRACE(row.text);
        const Loaded loaded = load("<pipeline>" + std::string(row.text) + "</pipeline>");
        EXPECT_FALSE(loaded.machine);
        ASSERT_EQ(loaded.lines.size(), 1u);
        EXPECT_TRUE(loaded.lines.front().starts_with(row.says)) << loaded.lines.front();
    }
    EXPECT_FALSE(load("<pipeline ahead=\"0\"/>").machine);
    EXPECT_FALSE(load("<pipeline/><pipeline/>").machine);
}

TEST(Pipeline, AScannerMayServeWays) {
    const Loaded loaded =
        load("<pipeline><serve command=\"line\" by=\"scanner\"/></pipeline>",
             "<scanner on=\"66\" off=\"67\" field=\"100 mm\" jump_speed=\"8 m/s\"/>");
    EXPECT_TRUE(loaded.machine) << loaded.lines.front();
}

}  // namespace
}  // namespace kadr::machine::pipeline_test
