// The borer's method: where the zero point of a part goes when the table turns, in the library and
// as a macro of a control that does not follow its table; both against the oracle, in all four
// quadrants.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/disk_files.h"
#include "tests/driver/scratch.h"

namespace borer_test {

namespace {

using nlohmann::json;

using Borer = kadr::test::ScratchFolder;

json oracle() {
    std::ifstream file(KADR_ROOT "/tests/oracles/zero_point.json");
    return json::parse(file)["cases"];
}

std::string text(double value, int decimals = 12) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
    return buffer;
}

TEST_F(Borer, TheLibraryTurnsTheZeroPointAsTheOracle) {
    std::string program = "import borer;\n";
    int cases = 0;
    for (const json& item : oracle()) {
        const json& in = item["input"];
        const json& out = item["expect"];
        const auto mm = [](const json& value) { return text(value.get<double>()) + "mm"; };
        program += "test \"" + item["id"].get<std::string>() +
                   "\" {\n    turntable table = {x: " + mm(in["table_centre_X"]) +
                   ", z: " + mm(in["table_centre_Z"]) +
                   ", is_reversed: " + (in["dir"].get<int>() < 0 ? "true" : "false") +
                   "};\n    point zero = {" + mm(in["part_zero_X"]) + ", 7mm, " +
                   mm(in["part_zero_Z"]) + "};\n    point now = turned_zero(zero, table, " +
                   text(in["B"].get<double>()) + "deg);\n    expect(abs(now.x - " +
                   mm(out["new_X"]) + ") < 1e-9mm && abs(now.z - " + mm(out["new_Z"]) +
                   ") < 1e-9mm && now.y == 7mm);\n    expect(abs(zero_radius(zero, table) - " +
                   mm(out["R"]) + ") < 1e-9mm);\n}\n";
        ++cases;
    }
    save("zero.kadr", program);
    const auto result = kadr({"test", file("zero.kadr")});
    EXPECT_EQ(result.status, 0) << result.out << result.err;
    EXPECT_EQ(cases, 22);
    EXPECT_NE(result.out.find("22 tests, 0 failed"), std::string::npos) << result.out;
}

TEST_F(Borer, TheMacroTurnsTheZeroPointAsTheOracle) {
    save("O9010.nc", kadr::read_file(KADR_ROOT "/examples/borer/O9010.nc").value());
    for (const json& item : oracle()) {
        SCOPED_TRACE(item["id"].get<std::string>());
        const json& in = item["input"];
        const json& out = item["expect"];
        const auto said = [&](const char* name) { return text(in[name].get<double>(), 4); };
        save("main.nc",
             "%\nO0001\n#500=" + said("table_centre_X") + "\n#501=" + said("table_centre_Z") +
                 "\n#502=" + std::to_string(in["dir"].get<int>()) + "\nG90 G10 L2 P1 X" +
                 said("part_zero_X") + " Y7.5 Z" + said("part_zero_Z") + "\nG65 P9010 A54. B" +
                 said("B") + " C55.\n#101=#5241\n#102=#5242\n#103=#5243\n#104=#4014\nM30\n%\n");
        const auto result = kadr({"run", file("main.nc"), "-d", "fanuc", "-m", "borer",
                                  "--variables", file("all.json")});
        ASSERT_EQ(result.status, 0) << result.err;
        const json all = json::parse(kadr::read_file(file("all.json")).value());
        // The control keeps offsets in increments of 0.001 mm.
        EXPECT_NEAR(all["#101"].get<double>(), out["new_X"].get<double>(), 0.0005 + 1e-9);
        EXPECT_NEAR(all["#102"].get<double>(), 7.5, 1e-9);
        EXPECT_NEAR(all["#103"].get<double>(), out["new_Z"].get<double>(), 0.0005 + 1e-9);
        EXPECT_EQ(all["#104"].get<double>(), 55);
    }
}

/// The oracle's zero points as the sum of an external offset and G54: the control adds it to G55
/// too.
TEST_F(Borer, TheMacroCountsTheExternalOffsetIn) {
    save("O9010.nc", kadr::read_file(KADR_ROOT "/examples/borer/O9010.nc").value());
    const double outer[] = {100, 12.5, -50.25};
    int quadrants = 0;
    for (const json& item : oracle()) {
        SCOPED_TRACE(item["id"].get<std::string>());
        const json& in = item["input"];
        const json& out = item["expect"];
        const auto value = [&](const char* name) { return in[name].get<double>(); };
        const bool is_right = value("part_zero_X") > value("table_centre_X");
        const bool is_front = value("part_zero_Z") > value("table_centre_Z");
        quadrants |= 1 << (2 * is_right + is_front);
        const auto said = [&](const char* name) { return text(value(name), 4); };
        const auto inner = [&](const char* name, int axis) {
            return text(value(name) - outer[axis], 4);
        };
        save("main.nc", "%\nO0001\n#500=" + said("table_centre_X") +
                            "\n#501=" + said("table_centre_Z") +
                            "\n#502=" + std::to_string(in["dir"].get<int>()) + "\nG90 G10 L2 P0 X" +
                            text(outer[0], 4) + " Y" + text(outer[1], 4) + " Z" +
                            text(outer[2], 4) + "\nG10 L2 P1 X" + inner("part_zero_X", 0) +
                            " Y7.5 Z" + inner("part_zero_Z", 2) + "\nG65 P9010 A54. B" + said("B") +
                            " C55.\n#101=#5241+#5201\n#102=#5242\n#103=#5243+#5203\n" + "M30\n%\n");
        const auto result = kadr({"run", file("main.nc"), "-d", "fanuc", "-m", "borer",
                                  "--variables", file("all.json")});
        ASSERT_EQ(result.status, 0) << result.err;
        const json all = json::parse(kadr::read_file(file("all.json")).value());
        EXPECT_NEAR(all["#101"].get<double>(), out["new_X"].get<double>(), 0.0005 + 1e-9);
        EXPECT_NEAR(all["#102"].get<double>(), 7.5, 1e-9);
        EXPECT_NEAR(all["#103"].get<double>(), out["new_Z"].get<double>(), 0.0005 + 1e-9);
    }
    EXPECT_EQ(quadrants, 0b1111);
}

TEST_F(Borer, TheMacroRefusesWhatItCannotWorkOut) {
    save("O9010.nc", kadr::read_file(KADR_ROOT "/examples/borer/O9010.nc").value());
    const std::string axis = "#500=1.\n#501=2.\n#502=1\n";
    const struct {
        std::string lines, alarm;
    } cases[] = {{axis + "G65 P9010 A54. C55.", "MC3091"},
                 {"G65 P9010 A54. B90. C55.", "MC3092"},
                 {"#500=1.\n#501=2.\n#502=2\nG65 P9010 A54. B90. C55.", "MC3092"},
                 {axis + "G65 P9010 A54. B90. C54.", "MC3093"},
                 {axis + "G65 P9010 A53. B90. C54.", "MC3093"}};
    for (const auto& wrong : cases) {
        save("main.nc", "%\nO0001\n" + wrong.lines + "\nM30\n%\n");
        const auto result = kadr({"run", file("main.nc"), "-d", "fanuc", "-m", "borer"});
        EXPECT_EQ(result.status, 3) << wrong.lines;
        EXPECT_NE(result.err.find(wrong.alarm), std::string::npos) << wrong.lines << result.err;
    }
}

TEST_F(Borer, TheCubeIsDrilledInItsFourSides) {
    const std::string folder = KADR_ROOT "/examples/borer/";
    const auto result = kadr({"run", folder + "cube.nc", "-d", "fanuc", "-m", "borer", "--commands",
                              file("cube.jsonl")});
    ASSERT_EQ(result.status, 0) << result.err;
    // The bottom of each hole, turned back with the table, is 20 mm deep in the corner's system.
    std::istringstream lines(kadr::read_file(file("cube.jsonl")).value());
    int holes = 0;
    for (std::string line; std::getline(lines, line);) {
        const json command = json::parse(line);
        if (command["op"] != "line") continue;
        const json& to = command["to"];
        const double turn = command["to"]["B"].get<double>() * std::acos(-1) / 180;
        // Table -1: the part goes left-handed about Y, here X 500, Z -800.
        const double dx = 120 * std::cos(turn) - 150 * std::sin(turn);
        const double dz = 120 * std::sin(turn) + 150 * std::cos(turn);
        if (to["Z"].get<double>() - (-800 + dz) > -19.9995) continue;
        ++holes;
        EXPECT_NEAR(to["X"].get<double>(), 500 + dx + 10, 0.001);
        EXPECT_NEAR(to["Y"].get<double>(), 160, 0.001);
        EXPECT_NEAR(to["Z"].get<double>(), -800 + dz - 20, 0.001);
    }
    EXPECT_EQ(holes, 4);
}

}  // namespace

}  // namespace borer_test
