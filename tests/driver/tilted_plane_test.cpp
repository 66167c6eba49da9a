// Tilted planes of a source: in the words of a control that has some, and as places of the rotary
// axes and a zero point that has gone with the table on one that has none. The same motion on the
// part.
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/disk_files.h"
#include "tests/driver/scratch.h"

namespace tilted_plane_test {

namespace {

using nlohmann::json;

using Point = std::array<double, 3>;

const std::string kProgram = R"(
program tilted() {
    tool(1); S2000 M3; F500;
    G0 X0 Y0 Z200;
    tilt(x: 10mm, z: -3mm, a: 30deg);
    G0 X0 Y0 Z50;
    G1 Z2;
    G1 X20 Y5;
    G0 Z50;
    tilt(y: 4mm, a: 15deg, b: 20deg, c: 40deg);
    G0 X5 Y0 Z50;
    G1 Z1;
    G3 X15 Y10 CR=10;
    G0 Z50;
    tilt_off();
    G0 A=0 C=0;
    G0 X0 Y0 Z200;
    G1 Z150;
    M30;
}
)";

class Tilt : public kadr::test::ScratchFolder {
  protected:
    void SetUp() override {
        ScratchFolder::SetUp();
        save("part.kadr", kProgram);
        for (const char* name : {"trunnion-ac", "head-cb", "borer"}) save_machine(name);
    }
    /// A stock machine that knows where the part's zero point is.
    void save_machine(const std::string& name) {
        std::string text = kadr::read_file(KADR_ROOT "/runtime/machines/" + name + ".xml").value();
        text.insert(text.rfind("</machine>"),
                    "<offset number=\"1\" x=\"12 mm\" y=\"-7 mm\" z=\"31 mm\"/>");
        save(name + ".xml", text);
    }
    std::string expanded(const std::string& control) {
        const auto result =
            kadr({"expand", file("part.kadr"), "-d", control, "-m", file("trunnion-ac.xml")});
        EXPECT_EQ(result.status, 0) << control << result.err;
        return result.out;
    }
    /// Ends of the motions at feed on the part, by the axes of the trunnion: A about X through Z
    /// -50 carries C about Z, both turn the part against their sign.
    std::vector<Point> cuts(const std::string& control) {
        const auto result = kadr({"run", file("part.kadr"), "-d", control, "-m",
                                  file("trunnion-ac.xml"), "--commands", file("all.jsonl")});
        EXPECT_EQ(result.status, 0) << control << result.err;
        std::vector<Point> found;
        std::istringstream lines(kadr::read_file(file("all.jsonl")).value_or(""));
        for (std::string line; std::getline(lines, line);) {
            const json command = json::parse(line);
            if (command["op"] != "line" && command["op"] != "arc") continue;
            const json& to = command["to"];
            const auto rad = [&](const char* name) {
                return to[name].get<double>() * std::acos(-1) / 180;
            };
            const double y = to["Y"].get<double>();
            const double z = to["Z"].get<double>() + 50;
            const double a = rad("A"), c = rad("C");
            const double y1 = y * std::cos(a) - z * std::sin(a);
            const double z1 = y * std::sin(a) + z * std::cos(a) - 50;
            const double x = to["X"].get<double>();
            found.push_back(
                {x * std::cos(c) - y1 * std::sin(c), x * std::sin(c) + y1 * std::cos(c), z1});
        }
        return found;
    }
};

TEST_F(Tilt, EveryControlHasItsWords) {
    const std::string sinumerik = expanded("sinumerik");
    EXPECT_NE(sinumerik.find("CYCLE800(0,,0,57,10,0,-3,30,0,0,0,0,0,-1)"), std::string::npos)
        << sinumerik;
    EXPECT_NE(sinumerik.find("CYCLE800(0,,0,57,0,4,0,15,20,40,0,0,0,-1)"), std::string::npos);
    EXPECT_NE(sinumerik.find("CYCLE800()"), std::string::npos);
    const std::string fanuc = expanded("fanuc");
    EXPECT_NE(fanuc.find("G68.2 X10. Y0. Z-3. I0. J30. K0.\nG53.1\n"), std::string::npos) << fanuc;
    // One plane ends before the next, and the last one.
    EXPECT_NE(fanuc.find("G69\nG68.2 X0. Y4. Z0. I"), std::string::npos) << fanuc;
    // Not a word of either: places of the axes, and a frame.
    const std::string axioma = expanded("axioma");
    EXPECT_EQ(axioma.find("CYCLE800"), std::string::npos) << axioma;
    EXPECT_NE(axioma.find("A30"), std::string::npos) << axioma;
    EXPECT_NE(axioma.find("TRANS"), std::string::npos) << axioma;
}

TEST_F(Tilt, TheTipGoesTheSameWayOnThePart) {
    // Zero point and origin, then about X by 30 degrees.
    const double s = 0.5, k = std::sqrt(0.75);
    const auto first = [&](double x, double y, double z) {
        return Point{12 + 10 + x, -7 + k * y - s * z, 31 - 3 + s * y + k * z};
    };
    std::vector<Point> reference;
    for (const char* control : {"sinumerik", "fanuc", "axioma"}) {
        SCOPED_TRACE(control);
        const std::vector<Point> all = cuts(control);
        ASSERT_EQ(all.size(), 5u);
        // Angles and places are written in thousandths: 0.0005 degrees are 2 µm at 200 mm.
        constexpr double kWritten = 0.004;
        const std::array<Point, 2> wanted = {first(0, 0, 2), first(20, 5, 2)};
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(all[0][i], wanted[0][i], kWritten);
            EXPECT_NEAR(all[1][i], wanted[1][i], kWritten);
            EXPECT_NEAR(all[4][i], (Point{12, -7, 181})[i], kWritten);
        }
        if (reference.empty()) reference = all;
        for (std::size_t n = 0; n < all.size(); ++n)
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_NEAR(all[n][i], reference[n][i], kWritten) << n;
    }
}

/// Whatever motion acts: `G53.1` of a FANUC turns the axes by the modal one.
TEST_F(Tilt, TheRotaryAxesGoAtRapid) {
    save("part.kadr", R"(
program tilted() {
    tool(1); S2000 M3; F500;
    tilt(b: 10deg);
    G0 X0 Y0 Z200;
    G1 Z180;
    tilt(a: 30deg);
    Z170;
    tilt(a: 20deg);
    tilt_off();
    X0 Y0 Z160;
    G2 X10 Y0 CR=5;
    tilt(a: 10deg);
    G1 X0 Y0;
    M30;
}
)");
    EXPECT_NE(expanded("fanuc").find("T01 M06\n"
                                     "S2000 M03\n"
                                     "F500.\n"
                                     "G00\n"
                                     "G68.2 X0. Y0. Z0. I90. J10. K-90.\n"
                                     "G53.1\n"
                                     "G43 H01 X0. Y0. Z200.\n"
                                     "G01 Z180.\n"
                                     "G00\n"
                                     "G69\n"
                                     "G68.2 X0. Y0. Z0. I0. J30. K0.\n"
                                     "G53.1\n"
                                     "G01 Z170.\n"
                                     "G00\n"
                                     "G69\n"
                                     "G68.2 X0. Y0. Z0. I0. J20. K0.\n"
                                     "G53.1\n"
                                     "G69\n"
                                     "G01 X0. Y0. Z160.\n"
                                     "G02 X10. Y0. R5.\n"
                                     "G00\n"
                                     "G68.2 X0. Y0. Z0. I0. J10. K0.\n"
                                     "G53.1\n"
                                     "G01 X0. Y0.\n"),
              std::string::npos)
        << expanded("fanuc");
    for (const char* control : {"sinumerik", "fanuc", "axioma"}) {
        SCOPED_TRACE(control);
        cuts(control);
        std::istringstream lines(kadr::read_file(file("all.jsonl")).value_or(""));
        json before = {{"A", 0}, {"C", 0}};
        for (std::string line; std::getline(lines, line);) {
            const json command = json::parse(line);
            if (!command.contains("to") || !command["to"].contains("A")) continue;
            const json& to = command["to"];
            const bool turns = to["A"] != before["A"] || to["C"] != before["C"];
            if (turns) {
                EXPECT_EQ(command["op"], "rapid") << line;
            }
            before = {{"A", to["A"]}, {"C", to["C"]}};
        }
    }
}

/// Behind raw text nobody knows the motion, and the rapid of the plane is none that was said.
TEST_F(Tilt, TheMotionOfRawTextStaysUnknown) {
    save("part.kadr", R"(
program tilted() {
    tool(1); S2000 M3; F500;
    G0 X0 Y0 Z200;
    raw "M88";
    shift(); G90 G17 G40 G94 G97 G54; F500; S2000 M3;
    tilt(a: 10deg);
    X0 Y0 Z150;
    M30;
}
)");
    for (const char* control : {"fanuc", "axioma"}) {
        const auto result =
            kadr({"expand", file("part.kadr"), "-d", control, "-m", file("trunnion-ac.xml")});
        EXPECT_NE(result.status, 0) << control << result.out;
        EXPECT_NE(result.err.find("8:5: error[K3212]"), std::string::npos) << result.err;
    }
}

TEST_F(Tilt, WhatCannotBeWorkedOutIsRefused) {
    const struct {
        std::string body, control, machine, code;
    } cases[] = {
        {"tilt(a: 30deg);", "axioma", "mill", "K3262"},
        {"tilt(a: 30deg);", "axioma", "trunnion-ac", "K3263"},
        {"tilt(a: 30deg);", "axioma", file("borer.xml"), "K3264"},
        {"tilt(a: 30deg);", "axioma", file("head-cb.xml"), "K3265"},
        {"shift(x: 10mm); tilt(a: 30deg);", "sinumerik", "mill", "K3260"},
        {"shift(x: 10mm); tilt(a: 30deg);", "fanuc", "mill", "K3260"},
        {"tilt(a: 30deg); shift(x: 10mm);", "fanuc", "mill", "K3261"},
        {"tilt(a: 30deg); with rotate(10deg) { G0 X5; }", "fanuc", "mill", "K3261"},
        {"tilt(a: 30deg); work_offset(2);", "sinumerik", "mill", "K3261"},
    };
    for (const auto& wrong : cases) {
        SCOPED_TRACE(wrong.body + " for " + wrong.control);
        save("wrong.kadr",
             "program p() { tool(1); S1000 M3; G0 X0 Y0 Z50; " + wrong.body + " M30; }\n");
        const auto result =
            kadr({"expand", file("wrong.kadr"), "-d", wrong.control, "-m", wrong.machine});
        EXPECT_EQ(result.status, 1);
        EXPECT_NE(result.err.find("error[" + wrong.code + "]"), std::string::npos) << result.err;
    }
}

TEST_F(Tilt, ATableAboutOneAxisShiftsTheZeroPoint) {
    save("side.kadr",
         "program p() { tool(1); S1000 M3; F200; G0 Z300; tilt(b: 90deg); G0 X10 Y5 Z50; G1 Z-4; "
         "tilt_off(); M30; }\n");
    const auto result =
        kadr({"expand", file("side.kadr"), "-d", "axioma", "-m", file("borer.xml")});
    ASSERT_EQ(result.status, 0) << result.err;
    // Axis at X 500, Z -800: dX = 12 - 500, dZ = 31 + 800; the table goes the other way round, so
    // the zero point comes to 500 - dZ, -800 + dX.
    EXPECT_NE(result.out.find("B90"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("X-343"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("Z-1319"), std::string::npos) << result.out;
}

/// The axes at the end of a program, as setpoints have them, put the tip where the plane says.
TEST_F(Tilt, TheAxesOfEveryMachineBringTheTipToThePlane) {
    save("part.nc",
         "%\nO0001\nT1 M06\nS1000 M03\nG54\nG68.2 X10. Y0 Z-3. I90. J20. K-90.\n"
         "G53.1\nG43 H1 X0 Y0 Z80.\nG01 Z2. F800.\nX12. Y-5.\nM30\n%\n");
    // About Y by 20 degrees: X is (cos, 0, -sin), Z (sin, 0, cos).
    const double c = std::cos(std::acos(-1) / 9), s = std::sin(std::acos(-1) / 9);
    const std::array<double, 6> wanted = {10 + 12 * c + 2 * s, -5, -3 - 12 * s + 2 * c, s, 0, c};
    for (const std::string name :
         {"trunnion-ac", "trunnion-bc", "head-cb", "head-ab", "mixed-cb", "nutating", "six-axis"}) {
        SCOPED_TRACE(name);
        const std::string length = name == "six-axis" ? "150" : "120";  // of tool 1
        const auto run = kadr(
            {"run", file("part.nc"), "-d", "fanuc", "-m", name, "--setpoints", file("all.csv")});
        ASSERT_EQ(run.status, 0) << run.err;
        const kadr::test::Row last =
            kadr::test::rows_of(kadr::read_file(file("all.csv")).value()).back();
        std::string axes;
        for (const char* axis : {"X", "Y", "Z", "A", "B", "C"})
            if (last.contains(axis)) axes += axis + std::to_string(last.at(axis)) + " ";
        const auto solved =
            kadr({"machine", "solve", name, "--axes", axes, "--length", length, "--json"});
        ASSERT_EQ(solved.status, 0) << solved.err;
        const json found = json::parse(solved.out);
        const json& at = found;
        // The axes are printed with six digits: at the end of a head that is a thousandth.
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(at["tip"][i].get<double>(), wanted[i], 2e-4);
            EXPECT_NEAR(at["tool"][i].get<double>(), wanted[3 + i], 1e-6);
        }
        // Of a head the setpoints show how it holds the tool; a table leaves it along Z.
        const bool is_head = name.starts_with("head") || name == "nutating";
        if (is_head) {
            EXPECT_NEAR(last.at("tool_i"), wanted[3], 1e-6);
        }
    }
}

}  // namespace

}  // namespace tilted_plane_test
