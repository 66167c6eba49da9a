// Summaries and setpoint tables: names, units and numbers as the interface promises them.
#include "driver/summary.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "base/text.h"
#include "driver/setpoints.h"

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

TEST(Setpoints, TableHasDegreesAndMillimetresAMinute) {
    const std::string file =
        (std::filesystem::temp_directory_path() / ("kadr-setpoints-" + std::to_string(::getpid())))
            .string();
    DiagnosticList sink;
    const machine::Machine machine = two_axes();
    const auto output = Output::open(file, sink);
    ASSERT_TRUE(output);
    SetpointTable table(machine, *output);
    motion::Setpoint setpoint;
    setpoint.time = 0.001;
    setpoint.axis = {-1.25, std::numbers::pi / 4};
    setpoint.tip = {-1.25, 0, 1e-10};
    setpoint.feed = 200.0 / 60;
    setpoint.line = 7;
    table.write(std::span(&setpoint, 1));
    ASSERT_TRUE(output->commit(sink));
    EXPECT_EQ(read_file(file),
              "t,X,A,tip_x,tip_y,tip_z,tool_i,tool_j,tool_k,feed,iso\n"
              "0.001,-1.25,45,-1.25,0,0,0,0,1,200,7\n");
    std::filesystem::remove(file);
}

}  // namespace
