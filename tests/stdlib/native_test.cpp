// A control's own drilling cycle, as a program of a shop has it, moves as the library's cycle does.
#include <filesystem>
#include <initializer_list>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "base/disk_files.h"
#include "base/numbers.h"
#include "base/text.h"
#include "tests/common/process.h"

namespace native_test {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// What moves, turns and waits, without where it stands in the text.
std::vector<json> commands_of(const std::string& suffix, const std::string& text,
                              const std::string& dialect, const std::string& machine = "mill",
                              const std::string& cycles = "moves") {
    const fs::path file =
        fs::temp_directory_path() / ("kadr-native-" + std::to_string(::getpid()) + suffix);
    EXPECT_TRUE(kadr::write_file_whole(file.string(), text));
    const ProcessResult result =
        run_process({KADR_BINARY, "run", file.string(), "-d", dialect, "-m", machine, "--cycles",
                     cycles, "--commands", "-"});
    EXPECT_EQ(result.status, 0) << text << result.err;
    std::error_code ignored;
    fs::remove(file, ignored);
    std::vector<json> commands;
    json last;
    std::istringstream lines(result.out);
    for (std::string line; std::getline(lines, line);) {
        json command = json::parse(line, nullptr, false);
        if (!command.is_object()) continue;
        command.erase("iso");
        command.erase("src");
        const bool moves = command["op"] == "rapid" || command["op"] == "line";
        if (moves && command["to"] == last) continue;  // names the place once more
        if (moves) last = command["to"];
        commands.push_back(std::move(command));
    }
    return commands;
}

struct Row {
    const char* dialect;
    const char* native;  // blocks of the control, behind G0 Z50 over X10 Y5
    const char* call;    // of the library
};

TEST(Native, CyclesOfTheControlsMoveAsTheLibraryDoes) {
    const Row rows[] = {
        {"fanuc", "G98 G81 Z-15. R2.\nG80", "drill(to: -15mm);"},
        {"fanuc", "G98 G82 Z-15. R2. P300\nG80", "drill(to: -15mm, dwell: 0.3s);"},
        {"fanuc", "G98 G73 Z-15. R2. Q4.\nG80", "drill_chip(to: -15mm, peck: 4mm);"},
        {"fanuc", "G98 G83 Z-15. R2. Q4.\nG80", "drill_peck(to: -15mm, peck: 4mm);"},
        {"fanuc", "G98 G85 Z-15. R2.\nG80", "ream(to: -15mm);"},
        {"fanuc", "G98 G86 Z-15. R2.\nG80", "bore_stop(to: -15mm);"},
        {"fanuc", "G98 G89 Z-15. R2. P300\nG80", "bore(to: -15mm, dwell: 0.3s);"},
        {"fanuc", "G98 G76 Z-15. R2. Q0.3\nG80", "bore_oriented(to: -15mm, lift_x: 0.3mm);"},
        {"fanuc", "G98 G76 Z-15. R2. Q0.3 P200\nG80",
         "bore_oriented(to: -15mm, lift_x: 0.3mm, dwell: 0.2s);"},
        {"fanuc", "G98 G87 Z-10. R-15. Q3.\nG80",
         "back_bore(to: -10mm, below: -15mm, shift_x: 3mm, off_face: 0mm);"},
        {"sinumerik", "CYCLE81(50,2,0,-15)", "drill(to: -15mm);"},
        {"sinumerik", "CYCLE81(50,0,2,-15)", "drill(to: -15mm);"},
        {"sinumerik", "CYCLE82(50,2,0,-15,,0.3)", "drill(to: -15mm, dwell: 0.3s);"},
        {"sinumerik", "CYCLE83(50,2,0,-40,,,12,3,0,0,1,1,,,,,1)",
         "drill_deep(to: -40mm, first: 12mm, less: 3mm);"},
        {"sinumerik", "CYCLE83(50,2,0,-40,,,12,3,0,0,1,1,,,,0.3,1)",
         "drill_deep(to: -40mm, first: 12mm, less: 3mm, dwell: 0.3s);"},
        {"sinumerik", "CYCLE86(50,2,0,-15,,0.2,3,-0.3,0,0.1,90)\nM3",
         "bore_oriented(to: -15mm, lift_x: -0.3mm, lift_z: 0.1mm, stop_at: 90deg, dwell: 0.2s);"},
        {"sinumerik", "CYCLE89(50,2,0,-15,,0)", "ream(to: -15mm);"},
        {"sinumerik", "CYCLE85(50,2,0,-15,,0.5,100,300)",
         "ream(to: -15mm, back: 300mm/min, dwell: 0.5s);"},
        {"sinumerik", "CYCLE85(50,2,0,-15,,0,80,60)",
         "ream_at_feeds(to: -15mm, into: 80mm/min, back: 60mm/min);"},
        {"axioma", "CYCLE86(50,2,0,-15,,0,3,0.2,0.2,0,45)\nM3",
         "bore_oriented(to: -15mm, lift_x: 0.2mm, lift_y: 0.2mm, stop_at: 45deg);"},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.native);
        const std::string start = "G0 X10. Y5.\nG0 Z50.\n";
        const std::string flat =
            "G17 G64 G90 G94\nS1200 M3\nF100.\n" + start + row.native + "\nM30\n";
        const std::string program =
            "import cycles.drilling;\nprogram test() {\nS1200 M3;\nF100;\nG0 X10 Y5;\nG0 Z50;\n" +
            std::string(row.call) + "\nM30;\n}\n";
        const bool is_fanuc = std::string(row.dialect) == "fanuc";
        const auto native = commands_of(is_fanuc ? ".nc" : ".mpf",
                                        is_fanuc ? "%\nO0001\n" + flat + "%\n" : flat, row.dialect);
        const auto moves = commands_of(".kadr", program, "iso");
        ASSERT_GT(moves.size(), 5u);
        ASSERT_EQ(native.size(), moves.size());
        for (std::size_t i = 0; i < moves.size(); ++i) EXPECT_EQ(native[i], moves[i]) << i;
    }
}

// A FANUC lathe's single cycles are repeated by every block with axis words, until a code of their
// group; each runs as the library's cycle of one cut.
TEST(Native, SingleCyclesOfALatheAreRepeated) {
    const std::string text =
        "%\nO0001\nG97 S500 M03\nG99 F0.2\nG00 X50. Z5.\nG90 X46. Z-20.\nX42.\n"
        "U-10. R-1.\nG94 X20. Z2.\nW-6.\nG92 X38. Z-30. F1.5\nX37.\nG00 X60.\nM30\n%\n";
    const std::string program =
        "import cycles.turning;\nimport cycles.threading;\nprogram test() {\nG97 S500 M3;\nG95 "
        "F0.2;\n"
        "G0 X50 Z5;\nturn_once(x: 46mm, z: -20mm);\nturn_once(x: 42mm, z: -20mm);\n"
        "turn_once(x: 40mm, z: -20mm, taper: -1mm);\nface_once(x: 20mm, z: 2mm);\n"
        "face_once(x: 20mm, z: -1mm);\nthread_once(x: 38mm, z: -30mm, lead: 1.5mm, run_off: 1);\n"
        "thread_once(x: 37mm, z: -30mm, lead: 1.5mm, run_off: 1);\nG0 X60;\nM30;\n}\n";
    const auto native = commands_of(".nc", text, "fanuc-lathe", "lathe");
    const auto moves = commands_of(".kadr", program, "iso", "lathe");
    ASSERT_GT(moves.size(), 25u);
    ASSERT_EQ(native.size(), moves.size());
    for (std::size_t i = 0; i < moves.size(); ++i) EXPECT_EQ(native[i], moves[i]) << i;
    EXPECT_EQ(commands_of(".kadr", program, "fanuc-lathe", "lathe"), moves);
}

// The three systems of G codes of a lathe say the same with other numbers: what is written for one
// of them is read back to the same commands, with the control's own cycles too.
TEST(Native, LathePartsAreTheSameInEverySystem) {
    for (const char* part :
         {"examples/shaft", "examples/pin", "tests/golden/cycles/lathe_thread"}) {
        const std::string text =
            kadr::read_file(KADR_ROOT "/" + std::string(part) + ".kadr").value_or("");
        for (const char* cycles : {"moves", "native"}) {
            SCOPED_TRACE(std::string(part) + ", " + cycles);
            const auto first = commands_of(".kadr", text, "fanuc-lathe", "lathe", cycles);
            ASSERT_GT(first.size(), 20u);
            EXPECT_EQ(commands_of(".kadr", text, "fanuc-lathe-b", "lathe", cycles), first);
            EXPECT_EQ(commands_of(".kadr", text, "fanuc-lathe-c", "lathe", cycles), first);
        }
    }
}

/// What is executed, short: `Z2 z-8 @0.3 S400 …`; rapid in capitals, feed in small letters, dwells,
/// the spindle.
std::string short_way(const std::vector<json>& commands) {
    std::string out;
    std::map<std::string, double> here;
    const auto add = [&](const std::string& text) { out += (out.empty() ? "" : " ") + text; };
    double feed = 0;
    for (const json& command : commands) {
        const std::string op = command["op"];
        if (op == "rapid" || op == "line") {
            for (const auto& [axis, value] : command["to"].items()) {
                const double to = value;
                if (here.contains(axis) && here[axis] == to) continue;
                here[axis] = to;
                std::string name = axis;
                if (op == "line") name[0] = static_cast<char>(name[0] + 32);
                add(name + kadr::format_shortest(to));
            }
            if (op == "line" && command["feed"] != feed) {
                feed = command["feed"];
                out += "f" + kadr::format_shortest(feed);
            }
        } else if (op == "dwell") {
            add("@" + kadr::format_shortest(kadr::round_to(command["time"], 6)));
        } else if (op == "spindle") {
            const std::string mode = command["mode"];
            if (mode == "stop") add("M5");
            else if (mode == "orient") add("M19");
            else add((mode == "cw" ? "S" : "S-") + kadr::format_shortest(command["speed"]));
        } else if (op == "stop") {
            add("M0");
        }
    }
    return out;
}

struct ShopText {
    const char* text;  // behind `G0 X0 Y0`, `G0 Z50`
    const char* way;
};

void expect_ways(const char* dialect, const char* before, const char* after,
                 std::initializer_list<ShopText> rows) {
    for (const ShopText& row : rows) {
        SCOPED_TRACE(row.text);
        const auto commands = commands_of(std::string(dialect) == "fanuc" ? ".nc" : ".mpf",
                                          std::string(before) + row.text + after, dialect);
        EXPECT_EQ(short_way(commands), "S1000 X0 Y0 Z50" + std::string(row.way));
    }
}

// Rows of fanuc.md 5.1 and 5.2.
TEST(ShopText, FanucCycles) {
    expect_ways(
        "fanuc", "%\nO0001\nG17 G90 G94 T1 M06\nS1000 M3\nG0 X0 Y0 Z50. F100\n", "\nG80\nM30\n%\n",
        {{"G90 G98 G83 X10. Y0 Z-10. R2. Q4.", " X10 Z2 z-2f100 Z2 Z-1 z-6 Z2 Z-5 z-10 Z50"},
         {"G99 G81 X1. Z-1. R2.\nG98 X2.", " X1 Z2 z-1f100 Z2 X2 z-1 Z50"},
         {"G91 G99 G81 X10. R-48. Z-5.\nX10. K2\nX20. K0",
          " X10 Z2 z-3f100 Z2 X20 z-3 Z2 X30 z-3 Z2"},
         {"G81 X1. Z-5. R60.", " X1 Z60 z-5f100 Z60 Z50"},
         {"G85 X1. Z-1. R2.\nG86 X2.", " X1 Z2 z-1f100 z2 Z50 X2 Z2 z-1 M5 Z50 S1000"},
         {"G73 X1. Z-6. R2. Q-4.", " X1 Z2 z-2f100 Z-1.5 z-6 Z50"},
         {"G83 X1. Z-6. R2.", " X1 Z2 z-6f100 Z50"},
         {"G82 X1. Z-1. R2. P500\nX2. P200", " X1 Z2 z-1f100 @0.5 Z50 X2 Z2 z-1 @0.2 Z50"},
         {"G81 X1. Z-1. R2. P500 Q1.5\nG82 X2.\nG83 X3.",
          " X1 Z2 z-1f100 Z50 X2 Z2 z-1 @0.5 Z50 X3 Z2 z0.5 Z2 Z1.5 z-1 Z50"},
         {"G88 X1. Z-1. R2. P500", " X1 Z2 z-1f100 @0.5 M5 M0 Z50 S1000"},
         {"G4 P500 F200;\nG81 X 1 . Z - 1 . R2.;", " @0.5 X1 Z2 z-1f200 Z50"},
         {"/1/3 G81 X1. Z-1. R2.", " X1 Z2 z-1f100 Z50"}});
}

// Rows of sinumerik.md 10.1.
TEST(ShopText, SinumerikCycles) {
    expect_ways(
        "sinumerik", "G17 G90 G94 G71\nT1 D1 M6\nS1000 M3\nG0 X0 Y0 Z50 F100\n", "\nM30\n",
        {{"CYCLE81(60,0,2,-8)", " Z2 z-8f100 Z60"},
         {"CYCLE81(20,0,2,,10)", " Z2 z-10f100 Z20"},
         {"CYCLE82(20,0,2,-8,9,-5,0,0,0)", " Z2 z-9f100 @0.3 Z20"},
         {"CYCLE83(10,0,2,-40,,-12,,3,0.5,1,0.8,1)",
          " Z2 z-12f80 @0.5 Z2 @1 Z-11.2 z-21f100 @0.5 Z2 @1 Z-20.2 z-27 @0.5 Z2 @1 Z-26.2 z-30 "
          "@0.5 Z2 @1 Z-29.2 z-33 @0.5 Z2 @1 Z-32.2 z-36 @0.5 Z2 @1 Z-35.2 z-38 @0.5 Z2 @1 Z-37.2 "
          "z-40 @0.5 Z10"},
         {"CYCLE83(10,0,2,-15,,,8,-0.5,,,,0,3,2,0.3,1)",
          " Z2 z-8f100 z-7.7 z-12 z-11.7 z-13.5 z-13.2 z-15 @1 Z10"},
         {"CYCLE84(20,0,2,-10,,0.5,5,8,,90,400,600)",
          " Z2 M19 S400 z-10f1.25 @0.5 S-600 z2 M5 Z20"},
         {"CYCLE84(20,0,2,-8,,,3,,-1.25,0,400,,,1,,1,6,0.5)",
          " Z2 M19 S-400 z-4f1.25 S400 z-3.5 S-400 z-8 S400 z2 Z20 S1000"},
         {"CYCLE840(20,0,2,-10,,1,0,3,0,8)", " Z2 z-10f1.25 S-1000 z2 S1000 Z20"},
         {"CYCLE840(20,0,2,-10,,1,4,3,1)", " Z2 z-10f100 @1 S-1000 z2 S1000 Z20"},
         {"CYCLE85(20,0,2,-10,,0.5,80,300)", " Z2 z-10f80 @0.5 z2f300 Z20"},
         {"M5\nCYCLE86(20,0,2,-10,,0.5,3,-1,0.2,1,45)",
          " M5 Z2 S1000 z-10f100 @0.5 M19 X-1 Y0.2 Z-9 Z2 Z20 X0 Y0"},
         {"CYCLE86(20,0,2,-10,,,4,0,0,0,45)", " Z2 S-1000 z-10f100 M19 Z2 Z20"},
         {"CYCLE87(20,0,2,-10,,3)", " Z2 z-10f100 M5 M0 Z20"},
         {"CYCLE88(20,0,2,-10,,0.5,4)", " Z2 S-1000 z-10f100 @0.5 M5 M0 Z20"},
         {"CYCLE89(20,0,2,-10,,0.5)", " Z2 z-10f100 @0.5 z2 Z20"},
         {"MCALL CYCLE81(20,0,2,-8)\nX10\nM8\nX20\nMCALL\nX30",
          " X10 Z2 z-8f100 Z20 X20 Z2 z-8 Z20 X30"}});
}

}  // namespace

}  // namespace native_test
