// A control's own drilling cycle, as a program of a shop has it, moves as the library's cycle does.
#include <filesystem>
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

/// What moves, turns and waits, without where it stands in the text.
std::vector<json> commands_of(const std::string& suffix, const std::string& text,
                              const std::string& dialect, const std::string& machine = "mill") {
    const fs::path file =
        fs::temp_directory_path() / ("kadr-native-" + std::to_string(::getpid()) + suffix);
    EXPECT_TRUE(kadr::write_file_whole(file.string(), text));
    const ProcessResult result =
        run_process({KADR_BINARY, "run", file.string(), "-d", dialect, "-m", machine, "--cycles",
                     "moves", "--commands", "-"});
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
         "back_bore(to: -10mm, below: -15mm, shift_x: 3mm);"},
        {"sinumerik", "CYCLE81(50,2,0,-15)", "drill(to: -15mm);"},
        {"sinumerik", "CYCLE81(50,0,2,-15)", "drill(to: -15mm);"},
        {"sinumerik", "CYCLE82(50,2,0,-15,,0.3)", "drill(to: -15mm, dwell: 0.3s);"},
        {"sinumerik", "CYCLE83(50,2,0,-40,,,12,3,0,0,1,1)",
         "drill_deep(to: -40mm, first: 12mm, less: 3mm);"},
        {"sinumerik", "CYCLE83(50,2,0,-40,,,12,3,0,0,1,1,,,,0.3)",
         "drill_deep(to: -40mm, first: 12mm, less: 3mm, dwell: 0.3s);"},
        {"sinumerik", "CYCLE86(50,2,0,-15,,0.2,3,-0.3,0,0.1,90)\nM3",
         "bore_oriented(to: -15mm, lift_x: -0.3mm, lift_z: 0.1mm, stop_at: 90deg, dwell: 0.2s);"},
        {"sinumerik", "CYCLE89(50,2,0,-15,,0)", "ream(to: -15mm);"},
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
        "face_once(x: 20mm, z: -1mm);\nthread_once(x: 38mm, z: -30mm, lead: 1.5mm);\n"
        "thread_once(x: 37mm, z: -30mm, lead: 1.5mm);\nG0 X60;\nM30;\n}\n";
    const auto native = commands_of(".nc", text, "fanuc-lathe", "lathe");
    const auto moves = commands_of(".kadr", program, "iso", "lathe");
    ASSERT_GT(moves.size(), 25u);
    ASSERT_EQ(native.size(), moves.size());
    for (std::size_t i = 0; i < moves.size(); ++i) EXPECT_EQ(native[i], moves[i]) << i;
    EXPECT_EQ(commands_of(".kadr", program, "fanuc-lathe", "lathe"), moves);
}

}  // namespace
