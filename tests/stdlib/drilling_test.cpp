// The drilling cycles over many sets of parameters: the bottom is reached exactly, no stroke is
// deeper than it may be, no rapid goes where nothing was drilled, the tool ends where it began.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/common/process.h"
#include "tests/stdlib/commands.h"

namespace drilling_test {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double kStart = 50;    // Z where the tool stands before and after the cycle
constexpr double kExact = 1e-5;  // mm: what the number format rounds

/// What a cycle did to one hole.
struct Hole {
    std::vector<double> strokes;  // each cut below what was drilled before
    double bottom = kStart;
    double end = 0;
    bool rapid_into_material = false;
    int dwells = 0;
};

Hole hole_of(const std::string& call, double retract) {
    const fs::path file =
        fs::temp_directory_path() / ("kadr-drilling-" + std::to_string(::getpid()) + ".kadr");
    EXPECT_TRUE(kadr::write_file_whole(
        file.string(),
        "import cycles.drilling;\nprogram test() {\nS1000 M3;\nF100;\nG0 X10 Y5;\n"
        "G0 Z50;\n" +
            call + ";\nM30;\n}\n"));
    const ProcessResult result = run_process(
        {KADR_BINARY, "run", file.string(), "-d", "iso", "--cycles", "moves", "--commands", "-"});
    EXPECT_EQ(result.status, 0) << call << result.err;
    std::error_code ignored;
    fs::remove(file, ignored);

    Hole hole;
    double drilled = retract;  // nothing is above the retract plane
    bool is_in = false;
    std::istringstream lines(result.out);
    for (std::string line; std::getline(lines, line);) {
        const json command = json::parse(line, nullptr, false);
        if (!command.is_object()) continue;
        if (command["op"] == "dwell") ++hole.dwells;
        if (command["op"] != "rapid" && command["op"] != "line") continue;
        const double z = command["to"]["Z"];
        is_in = is_in || z == kStart;  // before that the tool only comes there
        if (!is_in) continue;
        hole.end = z;
        if (command["op"] == "rapid") {
            hole.rapid_into_material = hole.rapid_into_material || z < drilled - kExact;
        } else if (z < drilled) {
            hole.strokes.push_back(drilled - z);
            drilled = z;
        }
        hole.bottom = std::min(hole.bottom, z);
    }
    return hole;
}

void expect_sound(const Hole& hole, double to) {
    EXPECT_NEAR(hole.bottom, to, kExact);
    EXPECT_EQ(hole.end, kStart);
    EXPECT_FALSE(hole.rapid_into_material);
}

class Dice {
  public:
    explicit Dice(unsigned seed) : engine_(seed) {}
    double length(double low, double high) {
        return std::round(std::uniform_real_distribution<>(low, high)(engine_) * 100) / 100;
    }

  private:
    std::mt19937 engine_;
};

std::string mm(double value) { return json(value).dump() + "mm"; }

TEST(Drilling, Pecks) {
    Dice dice(11);
    for (int i = 0; i < 20; ++i) {
        const double to = -dice.length(0.5, 60), retract = dice.length(0.1, 5);
        const double peck = dice.length(0.5, 15);
        for (const char* cycle : {"drill_peck", "drill_chip"}) {
            const std::string call = std::string(cycle) + "(to: " + mm(to) + ", peck: " + mm(peck) +
                                     ", retract: " + mm(retract) + ", dwell: 0.1s)";
            SCOPED_TRACE(call);
            const Hole hole = hole_of(call, retract);
            expect_sound(hole, to);
            EXPECT_EQ(hole.dwells, 1);
            const double count = std::ceil((retract - to) / peck - 1e-6);
            EXPECT_EQ(static_cast<double>(hole.strokes.size()), count);
            for (double stroke : hole.strokes) EXPECT_LE(stroke, peck + 0.001 + kExact);
        }
    }
}

TEST(Drilling, StrokesThatBecomeShorter) {
    Dice dice(12);
    for (int i = 0; i < 40; ++i) {
        const double retract = dice.length(0.1, 5), first = dice.length(1, 20);
        const double less = dice.length(0.3, first), to = retract - dice.length(first, 90);
        const std::string call = "drill_deep(to: " + mm(to) + ", first: " + mm(first) +
                                 ", less: " + mm(less) + ", retract: " + mm(retract) + ")";
        SCOPED_TRACE(call);
        const Hole hole = hole_of(call, retract);
        expect_sound(hole, to);
        ASSERT_FALSE(hole.strokes.empty());
        EXPECT_NEAR(hole.strokes[0], first, kExact);
        for (std::size_t k = 1; k < hole.strokes.size(); ++k) {
            const double longest = std::max(hole.strokes[k - 1] - less, less);
            const bool is_last = k + 1 == hole.strokes.size();
            // The last two share what is left.
            EXPECT_LE(hole.strokes[k],
                      (is_last ? std::max(longest, hole.strokes[k - 1]) : longest) + 0.001 + kExact)
                << k;
            // What the first stroke leaves may be thin; nothing else is.
            if (hole.strokes.size() > 2) {
                EXPECT_GE(hole.strokes[k], less / 2 - 0.001 - kExact) << k;
            }
        }
    }
}

/// What a call says that must be refused, or warned of.
std::string messages_of(const std::string& before, const std::string& call,
                        const std::string& dialect) {
    return stdlib_test::outcome_of(
               "import cycles.drilling;\nimport threads;\nprogram test() {\n"
               "tool(1);\nS1000 M3;\nF100;\nG0 X10 Y5;\nG0 Z50;\n" +
                   before + " {\n" + call + ";\n}\nM30;\n}\n",
               dialect, "mill", "native")
        .messages;
}

TEST(Drilling, ADwellIsNotNegative) {
    for (const char* call :
         {"center(d: 5mm, dwell: -1s)", "drill(to: -3mm, dwell: -1s)",
          "drill_peck(to: -3mm, peck: 1mm, dwell: -1s)",
          "drill_chip(to: -3mm, peck: 1mm, dwell: -1s)",
          "drill_deep(to: -9mm, first: 4mm, less: 1mm, dwell: -1s)",
          "tap(to: -3mm, pitch: 1mm, dwell: -1s)", "bore(to: -3mm, dwell: -1s)",
          "ream(to: -3mm, dwell: -1s)", "ream(to: -3mm, back: 300mm/min, dwell: -1s)",
          "bore_oriented(to: -3mm, lift_x: 0.2mm, dwell: -1s)",
          "bore_oriented(to: -3mm, lift_x: 0.2mm, stop_at: 0deg, dwell: -1s)",
          "back_bore(to: -3mm, below: -9mm, shift_x: 1mm, dwell: -1s)"}) {
        for (const char* dialect : {"iso", "sinumerik", "fanuc"}) {
            SCOPED_TRACE(std::string(call) + dialect);
            const std::string messages = messages_of("", call, dialect);
            EXPECT_NE(messages.find(":10:1: error[K3301]: `dwell`: a rest of -1 s cannot be"),
                      std::string::npos)
                << messages;
        }
    }
}

TEST(Drilling, WhatTheMachineTurnsIsNotMirrored) {
    struct Row {
        const char* before;
        const char* call;
        const char* message;  // none: it is right
    };
    const char* thread = "thread_mill(d: 20mm, pitch: 2mm, to: -4mm, tool_d: 12mm, cut: 300mm/min)";
    const char* outside =
        "thread_mill_outside(d: 20mm, pitch: 2mm, to: -4mm, tool_d: 12mm, cut: 300mm/min)";
    const char* oriented = "bore_oriented(to: -20mm, lift_x: 0.5mm)";
    const char* stopped =
        "bore_to_stop(to: -20mm, lift_x: 0.5mm, lift_y: 0mm, lift_z: 0mm, "
        "stop_at: 0deg)";
    const char* back = "back_bore(to: -5mm, below: -20mm, shift_x: 1mm)";
    for (const Row& row :
         {Row{"with mirror(x: true)", thread, "a mirror turns the hand"},
          {"with mirror(y: true)", outside, "a mirror turns the hand"},
          {"with mirror(x: true) mirror(y: true)", thread, ""},
          {"with rotate(30deg)", thread, ""},
          {"with mirror(x: true)", oriented, "lifted another way"},
          {"with rotate(30deg)", oriented, "lifted another way"},
          {"with scale(2)", oriented, "lifted another way"},
          {"with shift(x: 10mm)", oriented, ""},
          {"with mirror(x: true)", stopped, "lifted another way"},
          {"with mirror(x: true)", back, "lifted another way"},
          {"spindle(500rpm, ccw);", oriented, "starts it again with M3"},
          {"spindle(500rpm, ccw);", "bore_stop(to: -5mm)", "starts it again with M3"},
          {"spindle(500rpm, ccw);", back, "starts it again with M3"},
          {"spindle(500rpm, ccw);", "drill(to: -5mm)", "only a left-hand tool cuts that way"},
          {"spindle(500rpm, ccw);", "tap(to: -5mm, pitch: 1mm)", ""}}) {
        SCOPED_TRACE(std::string(row.before) + row.call);
        const std::string messages = messages_of(row.before, row.call, "sinumerik");
        if (std::string(row.message).empty()) {
            EXPECT_EQ(messages, "");
        }
        EXPECT_NE(messages.find(row.message), std::string::npos) << messages;
    }
}

TEST(Drilling, WaysOut) {
    Dice dice(13);
    for (int i = 0; i < 10; ++i) {
        const double to = -dice.length(1, 40), retract = dice.length(0.1, 5);
        const std::string heights = "(to: " + mm(to) + ", retract: " + mm(retract);
        for (const std::string& call :
             {"drill" + heights + ")", "bore" + heights + ")", "ream" + heights + ")",
              "ream" + heights + ", back: 300mm/min)", "bore_stop" + heights + ")",
              "bore_oriented" + heights + ", lift_x: 0.1mm, lift_y: -0.1mm)"}) {
            SCOPED_TRACE(call);
            const Hole hole = hole_of(call, retract);
            expect_sound(hole, to);
            EXPECT_EQ(hole.strokes.size(), 1u);
        }
        const double d = dice.length(1, 20);
        SCOPED_TRACE("center " + mm(d));
        const Hole hole = hole_of("center(d: " + mm(d) + ", tip: 90deg)", 2);
        expect_sound(hole, -d / 2);
    }
}

}  // namespace

}  // namespace drilling_test
