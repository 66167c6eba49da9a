// Every way on which a program turns the tool under the transformation, beside every kind of cutter
// compensation (S 5.2, 5.3, 7.4; F 4.4): the tool has the direction that is programmed at the end
// of each block, as without compensation, and gets there without a jump.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "tests/driver/scratch.h"

namespace compensated_orientation_test {

namespace {

using kadr::read_file;
using kadr::test::Row;
using kadr::test::rows_of;
using Vec3 = Eigen::Vector3d;

/// What a block of the contour says of the tool; a number as % stands for the number of the block.
struct Turning {
    const char* words;  // that choose it
    std::vector<std::string> lines;
};

const std::string kVectors[] = {" A3=0.1 C3=1", " A3=0.15 B3=0.1 C3=1", " B3=0.2 C3=1",
                                " A3=-0.1 B3=0.1 C3=1", " B3=0.05 C3=1"};

std::vector<std::string> vectors_with(const std::vector<std::string>& more) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < std::size(kVectors); ++i)
        words.push_back(kVectors[i] + more[i % more.size()]);
    return words;
}

std::map<std::string, Turning> turnings() {
    const std::string lean = " LEAD=5 TILT=3";
    const std::vector<std::string> spin = {" THETA=0", " THETA=10", " THETA=25"};
    return {
        {"great circles", {"ORIVECT", vectors_with({""})}},
        {"axes", {"ORIAXES", vectors_with({""})}},
        {"cones by their opening", {"ORICONCW", vectors_with({" NUT=60"})}},
        {"cones over", {"ORICONIO", vectors_with({" A7=0.05 B7=0.12 C7=1"})}},
        {"cones on", {"ORICONTO", vectors_with({""})}},
        {"a second point",
         {"ORICURVE",
          {" XH=5 YH=0 ZH=100", " XH=50 YH=8 ZH=90", " XH=45 YH=52 ZH=100", " XH=2 YH=44 ZH=95",
           " XH=5 YH=-4 ZH=100"}}},
        {"led", {"ORIPATH", {lean, "", "", "", ""}}},
        {"led with normals",
         {"ORIPATH",
          {lean + " A5=0.05 C5=1", lean + " A4=0.05 C4=1 B5=0.05 C5=1", lean + " B4=0.05 C4=1",
           lean + " A4=0.02 B4=0.05 C4=1 A5=0.03 C5=1", lean + " A4=0.03 C4=1"}}},
        {"about itself", {"ORIVECT ORIROTA", vectors_with(spin)}},
        {"about itself in the plane", {"ORIVECT ORIROTR", vectors_with(spin)}},
        {"about itself as it turns", {"ORIVECT ORIROTT", vectors_with(spin)}},
        {"about itself along the path", {"ORIVECT ORIROTC", vectors_with(spin)}},
        {"rotary axes", {"ORIAXES", {" B=4", " B=8 C=10", " B=2 C=-20", " B=7 C=5", " B=3 C=0"}}},
    };
}

const std::vector<std::string> kOnFaces = {"CUT3DF"};
const std::vector<std::string> kBesideContours = {
    "CUT2D", "CUT2D G451", "CUT2D KONT", "CUT2D KONTT", "CUT3DC ISD=2", "CUT3DC ISD=2 ORID"};

/// A contour to the right of which the material is: two lines, an outside arc, a line.
std::string program(const Turning& turning, const std::string& compensation, bool on_faces) {
    const std::string words(turning.words);
    // Without compensation only a tool that is led by the surface asks how that lies.
    const bool says_face = on_faces && (words == "ORIPATH" || !compensation.empty());
    const bool has_face = turning.lines[1].find("A4=") != std::string::npos;
    const std::string face = says_face && !has_face ? " A4=0.05 B4=0.02 C4=1" : "";
    const std::string side = compensation.empty() ? "" : " G41";
    const char* const places[] = {" X0 Y0 Z0", " X0 Y40", " X40 Y40", " X40 Y0 CR=25", " X10 Y0"};
    const std::string motions[] = {"G1" + side, "G1", "G1", "G2", "G1"};
    std::string text = "$TC_DP1[1,1]=" + std::string(on_faces ? "110" : "120") +
                       "\n$TC_DP3[1,1]=60\n$TC_DP6[1,1]=5\nG17 G40 G90 G94 G54\nT1 D1\nM6\n"
                       "S6000 M3 F3000\nTRAORI\nG54\nG0 X-30 Y-30 Z5 A3=0.05 C3=1\n" +
                       words + "\n" + compensation + "\n";
    for (std::size_t i = 0; i < std::size(places); ++i)
        text += motions[i] + places[i] + turning.lines[i] + face + "\n";
    return text + "G1 G40 X-30 Y-40 Z5\nTRAFOOF\nM30\n";
}

class ATurningTool : public kadr::test::ScratchFolder {
  protected:
    struct Turned {
        std::map<int, Vec3> ends;  // by line of the text
        double jump = 0;           // greatest change of the direction between two setpoints
    };
    Turned run(const std::string& text, const std::string& control, const char* machine) const {
        Turned turned;
        save("part.mpf", text);
        const auto result = kadr({"run", file("part.mpf"), "-d", control, "-m", machine,
                                  "--setpoints", file("part.csv")});
        EXPECT_EQ(result.status, 0) << result.err << text;
        if (result.status != 0) return turned;
        // Behind the contour the transformation ends, and what the tool is told in.
        const auto contour = static_cast<std::ptrdiff_t>(text.rfind("G40 X"));
        const auto last = std::count(text.begin(), text.begin() + contour, '\n') + 1;
        Vec3 before = Vec3::Zero();
        for (const Row& row : rows_of(read_file(file("part.csv")).value_or("t\n"))) {
            const int line = static_cast<int>(row.at("iso"));
            if (line > last) break;
            const Vec3 tool(row.at("tool_i"), row.at("tool_j"), row.at("tool_k"));
            if (!before.isZero()) turned.jump = std::max(turned.jump, (tool - before).norm());
            turned.ends[line] = before = tool;
        }
        EXPECT_GE(turned.ends.size(), 6u) << text;
        return turned;
    }
    /// One setpoint before the end of a block the tool may be a step away from it.
    static void expect_same_ends(const Turned& found, const Turned& wanted) {
        constexpr double kStep = 2e-3;
        EXPECT_LT(found.jump, 0.012);  // 20 rpm are 0.0042 in a tick of 2 ms
        for (const auto& [line, tool] : wanted.ends) {
            const auto end = found.ends.find(line);
            if (end == found.ends.end()) continue;
            EXPECT_LT((end->second - tool).norm(), kStep) << "line " << line;
        }
    }
};

TEST_F(ATurningTool, StandsAtTheEndsOfBlocksAsProgrammedBesideAContour) {
    for (const auto& [name, turning] : turnings()) {
        const bool spins = std::string(turning.words).find("ORIROT") != std::string::npos;
        const char* const machine = spins ? "six-axis" : "head-cb";
        for (const bool on_faces : {false, true}) {
            // On a surface whose normal leads the tool it has an edge at each of these corners.
            if (on_faces && name == "led with normals") continue;
            const Turned wanted = run(program(turning, "", on_faces), "sinumerik", machine);
            for (const std::string& compensation : on_faces ? kOnFaces : kBesideContours) {
                SCOPED_TRACE(name + " " + compensation);
                const std::string text = program(turning, compensation, on_faces);
                expect_same_ends(run(text, "sinumerik", machine), wanted);
            }
        }
    }
}

/// FANUC's compensation of the cutter's side, with rotary axes and with vectors that are said.
TEST_F(ATurningTool, StandsAsProgrammedBesideFanucsSide) {
    const auto part = [](const char* code, const char* begin,
                         const std::vector<std::string>& words) {
        return std::string("%\nO0001\nG10 L12 P1 R5.\nG17 G40 G90 G94 G54\nT1 M6\nS6000 M3\n") +
               begin + "\nG01 " + code + " X0. Y0. Z0. F3000." + words[0] + "\nY40." + words[1] +
               "\nX40." + words[2] + "\nY0." + words[3] + "\nG40 X60. Y-30." + words[4] +
               "\nG49\nM30\n%\n";
    };
    const std::vector<std::string> axes = {" B4. C10.", " B8. C15.", " B2. C-20.", " B7.", " B0."};
    const std::vector<std::string> vectors = {" I0.1 K1.", " I0.15 J0.1 K1.", " J0.2 K1.",
                                              " I-0.1 J0.1 K1.", " J0.05 K1."};
    const char* const by_axes = "G43.4 H1\nG00 X-30. Y-30. Z5. B3. C5.";
    const char* const by_vectors = "G43.5 H1 P1\nG00 X-30. Y-30. Z5. I0.05 K1.";
    for (const bool says_vectors : {false, true}) {
        SCOPED_TRACE(says_vectors);
        const char* const begin = says_vectors ? by_vectors : by_axes;
        const auto& text = says_vectors ? vectors : axes;
        const Turned wanted = run(part("", begin, text), "fanuc", "head-cb");
        expect_same_ends(run(part("G41.2 D1", begin, text), "fanuc", "head-cb"), wanted);
    }
}

}  // namespace

}  // namespace compensated_orientation_test
