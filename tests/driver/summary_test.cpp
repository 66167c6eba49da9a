// Summaries and setpoint tables: names, units and numbers as the interface promises them.
#include "driver/summary.h"

#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "driver/setpoints.h"

namespace summary_test {

namespace {

using namespace kadr;
using namespace kadr::driver;

machine::Machine two_axes() {
    machine::Machine machine;
    machine.name = "tilter";
    machine.title = "a mill with a tilting table";
    machine.axes.push_back({.name = "X", .axis = Axis::X, .is_rotary = false});
    machine.axes.push_back({.name = "A", .axis = Axis::A, .is_rotary = true});
    return machine;
}

RunFigures figures() {
    RunFigures run;
    run.source = "part.kadr";
    run.dialect = "a control";
    run.blocks = 12;
    run.commands = 9;
    run.totals.time = 75;
    run.totals.cutting_time = 60;
    run.totals.rapid_time = 15;
    run.totals.length = 250.5;
    run.totals.travel_max = {100, std::numbers::pi / 2};
    run.totals.max_velocity = {50, std::numbers::pi};
    run.totals.max_jerk = {std::numeric_limits<double>::infinity(), 0};
    return run;
}

TEST(Summary, JsonHasWhatTheInterfacePromises) {
    const nlohmann::json json = nlohmann::json::parse(summary_json(figures(), two_axes()));
    for (const char* name :
         {"blocks", "commands", "time_s", "cutting_s", "rapid_s", "length_mm", "travel",
          "max_velocity", "max_acceleration", "max_jerk", "alarms", "warnings"}) {
        EXPECT_TRUE(json.contains(name)) << name;
    }
    EXPECT_EQ(json["travel"]["A"]["max"], 90);
    EXPECT_EQ(json["max_velocity"]["A"], 180);
    EXPECT_EQ(json["max_velocity"]["X"], 50);
    EXPECT_TRUE(json["max_jerk"]["X"].is_null());
}

TEST(Summary, TextIsATableForAPerson) {
    const std::string text = summary_text(figures(), two_axes());
    EXPECT_NE(text.find("part.kadr\n"), std::string::npos);
    EXPECT_NE(text.find("1 min 15 s"), std::string::npos);
    EXPECT_NE(text.find("80 %"), std::string::npos);
    EXPECT_NE(text.find("250.5 mm"), std::string::npos);
    EXPECT_NE(text.find("3000.0"), std::string::npos);  // 50 mm/s a minute
}

TEST(Summary, Durations) {
    struct Row {
        double seconds;
        const char* expected;
    };
    for (const Row& row : {Row{0, "0 s"},
                           {3.274, "3.27 s"},
                           {59.4, "59.4 s"},
                           {75, "1 min 15 s"},
                           {3599.6, "1 h 00 min 00 s"},
                           {3723, "1 h 02 min 03 s"}}) {
        EXPECT_EQ(duration_text(row.seconds), row.expected) << row.seconds;
    }
}

TEST(Summary, TellsOfAScanner) {
    RunFigures run = figures();
    run.scan = process::ScanFigures{.lists = 2,
                                    .jumps = 5,
                                    .marks = 4,
                                    .time = 1.5,
                                    .mark_time = 1,
                                    .jump_time = 0.25,
                                    .mark_length = 400,
                                    .jump_length = 90,
                                    .pulses = 20000};
    const std::string text = summary_text(run, two_axes());
    EXPECT_NE(text.find("  marks         4, 400.0 mm in 1 s\n"
                        "  jumps         5, 90.0 mm in 0.25 s\n"
                        "  lists         2, 0.25 s of delays and waiting\n"
                        "  beam pulses   20000\n"),
              std::string::npos)
        << text;
    const nlohmann::json scanner = nlohmann::json::parse(summary_json(run, two_axes()))["scanner"];
    EXPECT_EQ(scanner["mark_s"], 1);
    EXPECT_EQ(scanner["jump_length_mm"], 90);
    EXPECT_EQ(scanner["pulses"], 20000);
}

TEST(Summary, TellsWhereTheTimeGoes) {
    RunFigures run = figures();
    run.tools = {{1, {50, 45, 200}}, {7, {25, 15, 50.5}}};
    run.longest = {{"part.kadr:12", "drill(to: -5mm);", {60, 60, 150}},
                   {"part.kadr:3", "G0 X0;", {15, 0, 100}}};
    const std::string text = summary_text(run, two_axes());
    EXPECT_NE(text.find("  T7            25 s            15 s                  50.5 mm\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("  part.kadr:12        1 min 00 s  80 %  drill(to: -5mm);\n"),
              std::string::npos)
        << text;
    run.cycles = {{"drill_peck", {40, 35, 90}}};
    EXPECT_NE(summary_text(run, two_axes())
                  .find("  cycle         time            cutting               path\n"
                        "  drill_peck    40 s            35 s                  90.0 mm\n"),
              std::string::npos)
        << summary_text(run, two_axes());
    const nlohmann::json json = nlohmann::json::parse(summary_json(run, two_axes()));
    EXPECT_EQ(json["cycles"][0]["cycle"], "drill_peck");
    EXPECT_EQ(json["cycles"][0]["cutting_s"], 35);
    EXPECT_EQ(json["tools"][1]["tool"], 7);
    EXPECT_EQ(json["tools"][1]["cutting_s"], 15);
    EXPECT_EQ(json["longest"][0]["at"], "part.kadr:12");
    EXPECT_EQ(json["longest"][0]["time_s"], 60);
    // One tool and one statement are what the first lines have told already.
    run.tools.pop_back();
    run.longest.pop_back();
    EXPECT_EQ(summary_text(run, two_axes()).find("longest"), std::string::npos);
}

/// What a table has written for these setpoints, in a file of this suffix.
std::string table_of(const std::string& suffix, std::span<const motion::Setpoint> setpoints) {
    const std::string file =
        (std::filesystem::temp_directory_path() / ("kadr-setpoints-" + std::to_string(::getpid())))
            .string() +
        suffix;
    DiagnosticList sink;
    const machine::Machine machine = two_axes();
    const auto output = Output::open(disk(), file, sink);
    if (!output) return {};
    const std::unique_ptr<SetpointTable> table = open_setpoints(machine, *output);
    for (const motion::Setpoint& setpoint : setpoints) table->write(std::span(&setpoint, 1));
    table->finish({});
    if (!output->commit(sink)) return {};
    std::string text = read_file(file).value();
    std::filesystem::remove(file);
    return text;
}

motion::Setpoint some_setpoint() {
    motion::Setpoint setpoint;
    setpoint.time = 0.001;
    setpoint.axis = {-1.25, std::numbers::pi / 4};
    setpoint.tip = {-1.25, 0, 1e-10};
    setpoint.feed = 200.0 / 60;
    setpoint.line = 7;
    return setpoint;
}

TEST(Setpoints, TableHasDegreesAndMillimetresAMinute) {
    const motion::Setpoint setpoint = some_setpoint();
    EXPECT_EQ(table_of(".csv", std::span(&setpoint, 1)),
              "t,X,A,tip_x,tip_y,tip_z,tool_i,tool_j,tool_k,feed,iso\n"
              "0.001,-1.25,45,-1.25,0,0,0,0,1,200,7\n");
}

// The format of NumPy's files: magic, version, length of a dictionary, the records.
TEST(Setpoints, ArrayIsOneOfNumPy) {
    for (const std::size_t rows : {0u, 1u, 1000u}) {
        std::vector<motion::Setpoint> setpoints(rows, some_setpoint());
        const std::string text = table_of(".npy", setpoints);
        ASSERT_GE(text.size(), 10u);
        EXPECT_EQ(text.substr(0, 8), std::string("\x93NUMPY\1\0", 8));
        const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
        const std::size_t begin = 10 + byte(8) + 256u * byte(9);
        ASSERT_LE(begin, text.size());
        EXPECT_EQ(begin % 64, 0u);
        EXPECT_EQ(text[begin - 1], '\n');
        const std::string header = text.substr(10, begin - 10);
        EXPECT_NE(header.find("'shape': (" + std::to_string(rows) + ",)"), std::string::npos);
        EXPECT_NE(header.find("('X', '<f8'), ('A', '<f8'), ('tip_x', '<f8')"), std::string::npos);
        EXPECT_NE(header.find("('feed', '<f8'), ('iso', '<u4')"), std::string::npos);
        constexpr std::size_t kRecord = 10 * 8 + 4;
        ASSERT_EQ(text.size(), begin + rows * kRecord);
        if (rows == 0) continue;
        std::array<double, 10> values{};
        std::memcpy(values.data(), text.data() + text.size() - kRecord, sizeof values);
        EXPECT_EQ(values[0], 0.001);
        EXPECT_EQ(values[1], -1.25);
        EXPECT_NEAR(values[2], 45, 1e-12);
        EXPECT_NEAR(values[9], 200, 1e-12);
        EXPECT_EQ(text[text.size() - 4], 7);
    }
}

}  // namespace

}  // namespace summary_test
