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

#include "base/text.h"
#include "tests/common/process.h"

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
