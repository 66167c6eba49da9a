// `kadr compare`: one source for two controls, two programs, and what it says when they differ.
#include <string>
#include <string_view>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/driver/scratch.h"

namespace compare_test {

namespace {

using nlohmann::json;

class Compare : public kadr::test::ScratchFolder {};

const std::string kFlange = std::string(KADR_ROOT) + "/examples/flange.kadr";

TEST_F(Compare, OneSourceMovesAlikeOnTwoControls) {
    const auto result =
        kadr({"compare", kFlange, "-d", "sinumerik", "-d", "fanuc", "--summary", "json"});
    ASSERT_EQ(result.status, 0) << result.out << result.err;
    const json said = json::parse(result.out);
    EXPECT_EQ(said["same"], true);
    EXPECT_GT(said["stretches"], 20);
    EXPECT_LT(said["distance_mm"], 0.003);
    const auto text = kadr({"compare", kFlange, "-d", "sinumerik", "-d", "fanuc"});
    EXPECT_NE(text.out.find("the same motion within 0.003 mm"), std::string::npos) << text.out;
}

/// Corners, angles and polar coordinates: words of the control, or lines, arcs and coordinates.
TEST_F(Compare, CornersAreTheSameMotionOnEveryControl) {
    const std::string folder = std::string(KADR_ROOT) + "/tests/programs/";
    for (const char* name : {"corners", "angles_and_poles", "corners_in_contours",
                             "corners_of_a_source", "corners_diameter_sinumerik"}) {
        for (const char* control : {"sinumerik", "fanuc", "axioma"}) {
            const bool is_lathe = std::string_view(name).find("diameter") != std::string::npos;
            if (is_lathe && std::string_view(control) == "fanuc") continue;  // X is a radius there
            const auto result = kadr({"compare", folder + name + ".kadr", "-d", "iso", "-d",
                                      control, "--summary", "json"});
            ASSERT_EQ(result.status, 0) << name << ' ' << control << result.out << result.err;
            const json said = json::parse(result.out);
            EXPECT_EQ(said["same"], true) << name << ' ' << control;
            EXPECT_LT(said["distance_mm"], 0.003) << name << ' ' << control;
        }
    }
}

/// Behind a transformation the same place has other coordinates, and no axis moves: a millimetre's
/// last digits that one control moves there are no distance.
TEST_F(Compare, OtherCoordinatesAreNoDistance) {
    save("le.kadr",
         "program le() {\n    units mm;\n    tool(1);\n    S8000 M3;\n    G0 X0 Y0 Z60;\n"
         "    tcp(on);\n    G1 X40 Y10 F2000 orient(i: 0.5, j: 0.3, k: 1);\n"
         "    G0 Z80 orient(k: 1);\n    tcp(off);\n    M30;\n}\n");
    const auto result =
        kadr({"compare", file("le.kadr"), "-d", "sinumerik", "-d", "fanuc", "-m", "trunnion-bc"});
    EXPECT_EQ(result.status, 0) << result.err;
    const std::string text = "the same motion within 0.003 mm: 3 stretches, ";
    const std::size_t at = result.out.find(text);
    ASSERT_NE(at, std::string::npos) << result.out;
    EXPECT_LE(std::stod(result.out.substr(at + text.size())), 3) << result.out;
}

/// A retract takes the tool's length off on one control (D0) and not on the other: no axis is
/// somewhere else. A tool that is longer by 0.1 mm moves every axis.
TEST_F(Compare, WhatCountsIsWhereTheAxesAre) {
    const std::string retracts = std::string(KADR_ROOT) + "/tests/golden/lengths/retracts.kadr";
    const auto alike = kadr({"compare", retracts, "-d", "fanuc", "-d", "sinumerik"});
    EXPECT_EQ(alike.status, 0) << alike.out << alike.err;
    const auto other = [&](const std::string& length) {
        save("a.mpf", "$TC_DP3[1,2]=" + length + "\nT1 M6 D2\nS1000 M3 F200\nG0 Z50\nG1 Z1\nM30\n");
        save("b.mpf", "$TC_DP3[1,2]=50\nT1 M6 D2\nS1000 M3 F200\nG0 Z50\nG1 Z1\nM30\n");
        return kadr({"compare", file("a.mpf"), file("b.mpf"), "-d", "sinumerik"});
    };
    EXPECT_EQ(other("50").status, 0) << other("50").out;
    EXPECT_EQ(other("50.1").status, 1) << other("50.1").out;
}

/// What deletes a rotation, a scale or a mirror leaves on every control what the program has said
/// else: shifts inside of it, the origin from before two rotations about points.
TEST_F(Compare, DeletionsLeaveTheSameFrameOnEveryControl) {
    const std::vector<std::string> frames = {
        "rotate(90deg, x: 2mm); rotate(30deg, x: 7mm); rotate_off(); X4 Y1;",
        "rotate(90deg); shift_add(x: 5mm); rotate_off(); X4 Y1;",
        "mirror(x: true); shift_add(x: 5mm); mirror_off(); X3 Y1;",
        "scale(2, x: 3mm); shift_add(x: 5mm); scale_off(); X3 Y2;",
        "rotate(20deg); with mirror(x: true) { X9 Y9; } mirror_off(); X8 Y7; rotate_off(); X1 Y2;",
        "with scale(1.5) { rotate(-45deg, x: 2mm, y: -3mm); X6 Y0; scale_off(); X-7 Y-1; }",
        "with shift(x: 1mm) rotate(30deg, x: 4mm) { X5 Y5; rotate(10deg, y: 3mm); rotate_off(); X7 "
        "Y7; } X3 Y2;"};
    for (const std::string& frame : frames) {
        save("f.kadr", "program f() { tool(1); S1000 M3; G0 X0 Y0 Z5; " + frame + " M30; }");
        for (const std::string control : {"sinumerik", "axioma", "fanuc"}) {
            const auto result = kadr({"compare", file("f.kadr"), "-d", "iso", "-d", control});
            // A FANUC refuses some of them.
            if (control == "fanuc" && result.status == 1 && result.out.empty()) continue;
            EXPECT_EQ(result.status, 0) << control << ": " << frame << '\n'
                                        << result.out << result.err;
        }
    }
}

/// What additive frames round adds up, and a scale makes it larger: 90 steps of 3.333 mm ended
/// 0.03 mm beside 300 mm.
TEST_F(Compare, RoundedFramesDoNotAddUp) {
    save("f.kadr",
         "program f() { tool(1); S1000 M3; F500; G0 X0 Y0 Z10;"
         " for (int i = 0; i < 90; i++) { shift_add(x: 10mm/3); G1 X0 Y0; Y5; }"
         " with scale(2.86) { with rotate(-90deg, x: -15mm, y: -7.1mm) { with scale(3) { X10; } } }"
         " with scale(10) { shift_add(x: 10mm/3); X1 Y0; } M30; }");
    for (const std::string control : {"sinumerik", "axioma"}) {
        const auto result = kadr({"compare", file("f.kadr"), "-d", "iso", "-d", control});
        EXPECT_EQ(result.status, 0) << control << result.out << result.err;
    }
}

TEST_F(Compare, SaysWhereProgramsPart) {
    save("a.mpf", "S1000 M3 F200\nG0 X0 Y0\nG1 X10\nY10\nM30\n");
    save("b.nc", "%\nO1\nS1000M3F200.\nG0X0.Y0.\nG1X10.\nY10.02\nM30\n%\n");
    const auto result = kadr({"compare", file("a.mpf"), file("b.nc"), "-d", "sinumerik", "-d",
                              "fanuc", "-m", "mill", "--summary", "json"});
    ASSERT_EQ(result.status, 1) << result.err;
    const json said = json::parse(result.out);
    EXPECT_EQ(said["parting"], "length");
    EXPECT_EQ(said["parted"][1]["at"], "b.nc:6");
    const auto wide = kadr({"compare", file("a.mpf"), file("b.nc"), "-d", "sinumerik", "-d",
                            "fanuc", "-m", "mill", "--tolerance", "50um"});
    EXPECT_EQ(wide.status, 0) << wide.out;
}

TEST_F(Compare, RefusesWhatItCannotCompare) {
    EXPECT_EQ(kadr({"compare", kFlange}).status, 2);
    EXPECT_EQ(kadr({"compare", kFlange, "-d", "fanuc"}).status, 2);
    EXPECT_EQ(kadr({"compare", kFlange, file("none.nc"), "-d", "fanuc"}).status, 2);
    EXPECT_EQ(kadr({"compare", kFlange, "-d", "fanuc", "-d", "iso", "--tolerance", "3"}).status, 2);
    save("wrong.kadr", "program p() { G1 X=y; }");
    const auto result = kadr({"compare", file("wrong.kadr"), "-d", "fanuc", "-d", "sinumerik"});
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.out, "");
}

/// Where a path is that of the place that a cutter touches, its tip is what counts.
TEST_F(Compare, ACutterOnASurfaceIsComparedByItsTip) {
    const auto milled = [](const std::string& radius) {
        return "$TC_DP1[1,1]=110 $TC_DP6[1,1]=" + radius +
               "\nT1 D1 M6\nS6000 M3 F1500\nTRAORI\nR1=30*SIN(40) R2=30*COS(40)-30\n"
               "G0 X-40 Y0 Z20\nCUT3DF\nG18\nG1 G41 X=-R1 Z=R2\n"
               "G3 X=R1 I=AC(0) K=AC(-30) A4=-SIN(40) C4=COS(40) A5=SIN(40) C5=COS(40)\n"
               "G1 G40 X60 Z30\nM30\n";
    };
    save("five.mpf", milled("5"));
    save("six.mpf", milled("6"));
    save("tip.mpf",
         "$TC_DP6[1,1]=5\nT1 D1 M6\nS6000 M3 F1500\nTRAORI\nR1=35*SIN(40) R2=35*COS(40)-35\n"
         "G0 X-40 Y0 Z20\nG18\nG1 X=-R1 Z=R2\nG3 X=R1 I=AC(0) K=AC(-35)\nG1 X60 Z30\nM30\n");
    const auto compared = [&](const char* other) {
        return kadr({"compare", file("five.mpf"), file(other), "-d", "sinumerik", "-d", "sinumerik",
                     "-m", "trunnion-ac"});
    };
    EXPECT_EQ(compared("five.mpf").status, 0);
    const auto same = compared("tip.mpf");
    EXPECT_EQ(same.status, 0) << same.out << same.err;
    EXPECT_EQ(compared("six.mpf").status, 1);
}

}  // namespace

}  // namespace compare_test
