// `kadr run --hold`, `--events` and overrides that are turned: what an operator does meanwhile.
// And M functions for which the machine takes time.
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/disk_files.h"
#include "driver/operator_events.h"
#include "tests/driver/scratch.h"

namespace operator_test {

namespace {

using kadr::driver::block_name;
using kadr::driver::hold_events;
using kadr::driver::operator_event;
using kadr::driver::override_sequence;
using kadr::motion::OperatorAct;
using kadr::motion::OperatorEvent;
using kadr::test::Row;
using kadr::test::rows_of;

std::string shown(const OperatorEvent& event) {
    const bool is_at_block = event.line != 0 || event.number >= 0;
    const char* what = event.act == OperatorAct::FeedOverride    ? "feed"
                       : event.act == OperatorAct::RapidOverride ? "rapid"
                       : event.act == OperatorAct::FeedHold      ? "hold"
                                                                 : "start";
    return (is_at_block ? block_name(event.number, event.line) + '+' : "") +
           std::to_string(event.time).substr(0, 5) + ' ' + what + ' ' +
           std::to_string(event.value).substr(0, 4);
}

TEST(OperatorEvents, LinesOfAFile) {
    struct Line {
        const char* text;
        const char* event;  // empty: none
    };
    for (const Line& row : {
             Line{"5s feed hold", "5.000 hold 1.00"},
             Line{"  500 ms   cycle   start ", "0.500 start 1.00"},
             Line{"1.5min feed override 120 %", "90.00 feed 1.20"},
             Line{"0s rapid override 0%", "0.000 rapid 0.00"},
             Line{"N120 feed override 50", "N120+0.000 feed 0.50"},
             Line{"N120 + 2s feed hold", "N120+2.000 hold 1.00"},
             Line{":34+1s feed hold", ":34+1.000 hold 1.00"},
             Line{"5 feed hold", ""},
             Line{"-5s feed hold", ""},
             Line{"feed hold", ""},
             Line{"5s hold the feed", ""},
             Line{"5s feed hold now", ""},
             Line{"5s feed override", ""},
             Line{"5s feed override 201%", ""},
             Line{"5s rapid override 101%", ""},
             Line{":0 feed hold", ""},
             Line{"N feed hold", ""},
         }) {
        SCOPED_TRACE(row.text);
        const auto event = operator_event(row.text);
        EXPECT_EQ(event ? shown(*event) : "", row.event);
    }
}

std::string shown(const std::vector<OperatorEvent>& events) {
    std::string all;
    for (const OperatorEvent& event : events) all += (all.empty() ? "" : ", ") + shown(event);
    return all;
}

TEST(OperatorEvents, Holds) {
    const auto said = [](const char* text) {
        const auto events = hold_events(text);
        return events ? shown(*events) : "none";
    };
    EXPECT_EQ(said("5s..7s"), "5.000 hold 1.00, 7.000 start 1.00");
    EXPECT_EQ(said("N120..2s"), "N120+0.000 hold 1.00, N120+2.000 start 1.00");
    EXPECT_EQ(said("N120+1s..2s"), "N120+1.000 hold 1.00, N120+3.000 start 1.00");
    EXPECT_EQ(said("5s"), "5.000 hold 1.00");
    EXPECT_EQ(said("5s.."), "5.000 hold 1.00");
    for (const char* wrong : {"", "5", "7s..5s", "..5s", "5s..N120", "5s-7s"})
        EXPECT_EQ(said(wrong), "none") << wrong;
}

TEST(OperatorEvents, CoursesOfASwitch) {
    const auto said = [](const char* text) {
        const auto sequence = override_sequence(text, OperatorAct::FeedOverride, 2);
        if (!sequence) return std::string("none");
        return std::to_string(sequence->at_start).substr(0, 4) + ": " + shown(sequence->events);
    };
    EXPECT_EQ(said("80"), "0.80: ");
    EXPECT_EQ(said("80 %"), "0.80: ");
    EXPECT_EQ(said("100%,5s:50%,9s:120%"), "1.00: 5.000 feed 0.50, 9.000 feed 1.20");
    EXPECT_EQ(said("0%, N120 + 2s : 100%"), "0.00: N120+2.000 feed 1.00");
    for (const char* wrong : {"", "0", "201", "fast", "5s:50%", "100%,50%", "100%,5:50%", "100%,"})
        EXPECT_EQ(said(wrong), "none") << wrong;
}

class Operator : public kadr::test::ScratchFolder {
  protected:
    void SetUp() override {
        ScratchFolder::SetUp();
        // 100 mm at 10 mm/s: 10 s, and ramps of some hundredths.
        save("line.nc", "%\nO1\nN10 G0 X0 Y0 S1000 M3\nN20 G1 X100. F600.\nN30 M30\n%\n");
    }
    nlohmann::json summary(std::vector<std::string> options) {
        std::vector<std::string> arguments = {"run",   file("line.nc"), "-d",
                                              "fanuc", "--summary",     "json"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProcessResult result = kadr(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        said_ = result.err;
        return nlohmann::json::parse(result.out);
    }
    std::string said_;
};

TEST_F(Operator, AHoldTakesItsTime) {
    const double plain = summary({})["time_s"];
    const nlohmann::json held = summary({"--hold", "5s..7s"});
    EXPECT_NEAR(held["time_s"], plain + 2, 1e-6);
    EXPECT_NEAR(held["hold_s"], 2, 0.1);
    EXPECT_NEAR(summary({"--hold", "N20+2s..1s"})["time_s"], plain + 1, 1e-6);
    EXPECT_NEAR(summary({"--hold", ":4..1s"})["time_s"], plain + 1, 0.02);
    // Half of the way at 50 %.
    EXPECT_NEAR(summary({"--feed-override", "100%,5s:50%"})["time_s"], 15, 0.1);
    EXPECT_NEAR(summary({"--rapid-override", "100%,0s:0%,1s:100%"})["time_s"], plain, 1e-6);
}

TEST_F(Operator, SetpointsStandWhileHeld) {
    summary({"--hold", "5s..7s", "--setpoints", file("a.csv")});
    const std::vector<Row> rows = rows_of(kadr::read_file(file("a.csv")).value());
    const double place = Row(rows[5200])["X"];
    EXPECT_NEAR(place, 50, 0.3);
    EXPECT_EQ(Row(rows[6900])["X"], place);
    EXPECT_GT(Row(rows[7200])["X"], place);
}

TEST_F(Operator, EventsThatNeverComeAreTold) {
    const auto said = [&](const std::string& event) {
        save("probe.nc", "%\nO1\nN10 G0 X0.\nN20 G31 X10. F100\nN30 #1=#5061\nN40 M30\n%\n");
        save("events", event + '\n');
        return kadr({"run", file("probe.nc"), "-d", "fanuc", "--events", file("events")}).err;
    };
    EXPECT_EQ(said("N20 touch X5").find("K6215"), std::string::npos);
    EXPECT_EQ(said("N30 set #500=1").find("K6215"), std::string::npos);
    for (const auto& [event, words] :
         {std::pair{"N30 touch X5", "`touch` has not happened: no probing block begins at N30"},
          {":9 touch none", "no probing block begins at :9"},
          {"N99 set #500=1", "`#500=1` has not happened: no block begins at N99"},
          {"900s set #500=1", "`#500=1` has not happened: the run ends before"}})
        EXPECT_NE(said(event).find(words), std::string::npos) << said(event);
}

TEST_F(Operator, EventsFromAFile) {
    save("events", "# tool looked at\nN20 + 1s feed hold\n\nN20 + 3s cycle start  # goes on\n");
    EXPECT_NEAR(summary({"--events", file("events")})["time_s"], double(summary({})["time_s"]) + 2,
                1e-6);
    save("events", "5s feed hold\n7s start\n");
    const ProcessResult wrong =
        kadr({"run", file("line.nc"), "-d", "fanuc", "--events", file("events")});
    EXPECT_EQ(wrong.status, 2);
    EXPECT_NE(wrong.err.find("events:2:1: error[K6211]"), std::string::npos) << wrong.err;
    EXPECT_EQ(kadr({"run", file("line.nc"), "-d", "fanuc", "--events", file("none")}).status, 2);
}

TEST_F(Operator, WhatCannotBe) {
    const ProcessResult forever = kadr({"run", file("line.nc"), "-d", "fanuc", "--hold", "5s"});
    EXPECT_EQ(forever.status, 3);
    EXPECT_NE(forever.err.find("line.nc:4:5: alarm[K6210]"), std::string::npos) << forever.err;
    summary({"--hold", "N99..1s"});
    EXPECT_NE(said_.find("warning[K6213]: no motion begins at N99"), std::string::npos) << said_;
    const ProcessResult pulses =
        kadr({"run", file("line.nc"), "-d", "fanuc", "-m", "laser", "--hold", "1s..2s"});
    EXPECT_EQ(pulses.status, 2);
    EXPECT_NE(pulses.err.find("K6214"), std::string::npos) << pulses.err;
    for (const std::vector<std::string>& options : std::vector<std::vector<std::string>>{
             {"--hold", "soon"}, {"--feed-override", "50%,5s"}, {"--rapid-override", "1s:50%"}}) {
        std::vector<std::string> arguments = {"run", file("line.nc"), "-d", "fanuc"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        EXPECT_EQ(kadr(arguments).status, 2) << options[1];
    }
}

TEST_F(Operator, AFloatingTapHasNoOverride) {
    // 10 mm at 10 mm/s.
    save("tap.mpf", "N10 G0 X0 Z0\nN20 S100 M3\nN30 G63 Z-10 F600\nN40 M30\n");
    const auto time = [&](const std::vector<std::string>& options) {
        std::vector<std::string> arguments = {"run",       file("tap.mpf"), "-d",
                                              "sinumerik", "--summary",     "json"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProcessResult result = kadr(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        return double(nlohmann::json::parse(result.out)["cutting_s"]);
    };
    const double plain = time({});
    EXPECT_NEAR(time({"--feed-override", "50"}), plain, 1e-9);
    EXPECT_NEAR(time({"--feed-override", "100%,0.5s:50%"}), plain, 1e-9);
}

TEST_F(Operator, MFunctionsTakeTheMachineTime) {
    save("clamp.xml", R"(<machine name="clamp" tick="1 ms" tool_change_time="1 s">
  <axis name="X" velocity="30 m/min" acceleration="5 m/s2" jerk="100 m/s3"/>
  <axis name="Y" velocity="30 m/min" acceleration="5 m/s2" jerk="100 m/s3"/>
  <axis name="Z" velocity="30 m/min" acceleration="5 m/s2" jerk="100 m/s3"/>
  <function code="M10" takes="0.4 s"/>
  <function code="M11" takes="0.3 s" acts="after"/>
  <function code="M3" takes="1.5 s"/>
  <function code="M5" takes="2 s"/>
  <function code="M8" takes="0.2 s" waits="no"/>
  <function code="M63" takes="20 s" acts="with"/>
</machine>)");
    const auto waiting = [&](const std::string& blocks) {
        save("line.nc", "%\nO1\nG0 X0 Y0\n" + blocks + "M30\n%\n");
        return double(summary({"-m", file("clamp.xml")})["wait_s"]);
    };
    EXPECT_NEAR(waiting("G1 X10. F600.\nM10\nG1 X20.\n"), 0.4, 1e-9);
    // The machine's file knows it: no word of a function of the builder's.
    EXPECT_EQ(said_.find("K5241"), std::string::npos) << said_;
    EXPECT_NEAR(waiting("M10\nG1 X10. F600. M11\n"), 0.4 + 0.3, 1e-9);
    // The spindle that turns already is not waited for.
    EXPECT_NEAR(waiting("S1000 M3\nG1 X10. F600.\nM3\nG1 X20. M5\n"), 1.5 + 2, 1e-9);
    EXPECT_NEAR(waiting("M8\nG1 X10. F600.\nM9\n"), 0, 1e-9);
    // 100 mm at 10 mm/s while the function takes 20 s.
    EXPECT_NEAR(waiting("G1 X100. F600. M63\nG1 X110.\n"), 10, 0.1);
}

}  // namespace

}  // namespace operator_test
