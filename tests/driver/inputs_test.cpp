// What the machine tells a program (docs/inputs.md): `<data>`, `--variables-in`, `--set`,
// `--events`, touches of its probe, and `--call`.
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/disk_files.h"
#include "driver/machine_inputs.h"
#include "driver/operator_events.h"
#include "tests/driver/scratch.h"

namespace inputs_test {

namespace {

using nlohmann::json;

struct Ran {
    ProcessResult result;
    json variables;
};

/// A variable, or −999 if it has no value at the end.
double number(const Ran& ran, const std::string& name) {
    const auto found = ran.variables.find(name);
    if (found == ran.variables.end() || found->is_null()) return -999;
    return found->is_boolean() ? found->get<bool>() : found->get<double>();
}

std::string machine_with(const std::string& elements) {
    return "<machine name=\"m\">"
           "<axis name=\"X\" limits=\"-1000..1000 mm\" velocity=\"30 m/min\" acceleration=\"5 "
           "m/s2\"/>"
           "<axis name=\"Y\" machine_name=\"YM\" limits=\"-900..900 mm\" velocity=\"30 m/min\" "
           "acceleration=\"5 m/s2\"/>"
           "<axis name=\"Z\" limits=\"-800..800 mm\" velocity=\"30 m/min\" acceleration=\"5 "
           "m/s2\"/>\n" +
           elements + "</machine>";
}

class Inputs : public kadr::test::ScratchFolder {
  protected:
    Ran run(const std::string& dialect, const std::string& text,
            const std::vector<std::string>& more = {}) {
        const std::string name =
            dialect == "sinumerik" || dialect == "axioma" ? "part.mpf" : "part.nc";
        save(name, text);
        std::vector<std::string> arguments = {"run",   file(name),    "-d",
                                              dialect, "--variables", file("out.json")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        Ran ran{kadr(arguments), {}};
        ran.variables =
            json::parse(kadr::read_file(file("out.json")).value_or("{}"), nullptr, false);
        return ran;
    }
};

int count(const std::string& text, const std::string& what) {
    int found = 0;
    for (std::size_t at = 0; (at = text.find(what, at)) < text.size(); ++at) ++found;
    return found;
}

// ------------------------------------------------------------------------------ values

/// fanuc.md 14 and 9: an input that nobody has given is 0, told once, by its number; so it is where
/// the number is worked out.
TEST_F(Inputs, OneWithoutAValueIsZeroAndToldOnce) {
    const Ran ran =
        run("fanuc", "%\nO0001\n#5=1000\n#100=#[#5+4]\n#101=#1004\n#102=#1005\nM30\n%\n");
    EXPECT_EQ(ran.result.status, 0) << ran.result.err;
    EXPECT_EQ(number(ran, "#100"), 0);
    EXPECT_EQ(number(ran, "#101"), 0);
    EXPECT_EQ(count(ran.result.err, "warning[K5950]"), 2) << ran.result.err;
    EXPECT_NE(ran.result.err.find("part.nc:4:6: warning[K5950]: no value is given for `#1004` "
                                  "(input of the machine): it is taken for 0"),
              std::string::npos)
        << ran.result.err;
}

TEST_F(Inputs, SetGivesThem) {
    const Ran ran =
        run("fanuc", "%\nO0001\n#100=#1004\n#101=#1032\n#102=#500\n#1105=1\n#103=#1132\nM30\n%\n",
            {"--set", "#1004=1", "--set", "#500=12.5", "--set", "#1032=21"});
    EXPECT_EQ(ran.result.status, 0) << ran.result.err;
    EXPECT_EQ(ran.result.err, "");
    EXPECT_EQ(number(ran, "#100"), 1);  // bit 4 of 21 = 16 + 4 + 1
    EXPECT_EQ(number(ran, "#101"), 21);
    EXPECT_EQ(number(ran, "#102"), 12.5);
    EXPECT_EQ(number(ran, "#103"), 32);  // output 5
    EXPECT_EQ(number(ran, "#1105"), 1);
}

/// Inputs are the machine's: a program does not write them.
TEST_F(Inputs, AProgramCannotWriteAnInput) {
    const Ran ran = run("fanuc", "%\nO0001\n#1004=1\nM30\n%\n");
    EXPECT_EQ(ran.result.status, 3);
    EXPECT_NE(ran.result.err.find("`#1004` cannot be written"), std::string::npos)
        << ran.result.err;
}

/// sinumerik.md 18: machine data from the machine file, data of the PLC as variables.
TEST_F(Inputs, MachineDataOfTheFileAndDataOfThePlc) {
    save("m.xml", machine_with("<data name=\"$MN_USER_DATA_INT[3]\" value=\"7\"/>\n"
                               "<data name=\"$MC_AXCONF_CHANAX_NAME_TAB[0]\" value=\"XC\"/>\n"
                               "<data name=\"$A_IN[3]\" value=\"1\"/>\n"
                               "<data name=\"R10\" value=\"2.5\"/>\n"));
    const Ran ran = run("sinumerik",
                        "DEF STRING[20] NAM\nR1=$MN_USER_DATA_INT[3]\n"
                        "NAM=$MC_AXCONF_CHANAX_NAME_TAB[0]\nR2=$A_IN[3]\nR3=R10\n"
                        "R4=$A_DBR[8]\n$A_DBW[2]=1700\nR5=$A_DBW[2]\nR6=$A_DBR[12]\nM30\n",
                        {"-m", file("m.xml"), "--set", "R10=3"});
    EXPECT_EQ(ran.result.status, 0) << ran.result.err;
    EXPECT_EQ(number(ran, "R1"), 7);
    EXPECT_EQ(ran.variables["NAM"], "XC");
    EXPECT_EQ(number(ran, "R2"), 1);
    EXPECT_EQ(number(ran, "R3"), 3);  // --set comes behind the file
    EXPECT_EQ(number(ran, "R5"), 1700);
    EXPECT_EQ(number(ran, "$A_DBW[2]"), 1700);
    // Of an array once.
    EXPECT_EQ(count(ran.result.err, "K5950"), 1) << ran.result.err;
    EXPECT_NE(ran.result.err.find("`$A_DBR[8]` (real number of the PLC)"), std::string::npos);
}

/// sinumerik.md 7: names of machine axes as an index.
TEST_F(Inputs, NamesOfMachineAxesAreAnIndex) {
    save("m.xml", machine_with("<data name=\"$MA_REF_VELO_POS[YM]\" value=\"600\"/>\n"));
    const Ran ran = run("sinumerik",
                        "G0 X10 Y20 Z30\nR1=$AA_IM[AX2]\nR2=$AA_IM[X1]\nR3=$AA_IM[YM]\n"
                        "R4=$MA_POS_LIMIT_PLUS[AX1]\nR5=$MA_POS_LIMIT_MINUS[Z1]\n"
                        "R6=$MA_REF_VELO_POS[AX2]\nM30\n",
                        {"-m", file("m.xml")});
    EXPECT_EQ(ran.result.status, 0) << ran.result.err;
    EXPECT_EQ(ran.result.err.find("K5950"), std::string::npos) << ran.result.err;
    EXPECT_EQ(number(ran, "R1"), 20);
    EXPECT_EQ(number(ran, "R2"), 10);
    EXPECT_EQ(number(ran, "R3"), 20);
    EXPECT_EQ(number(ran, "R4"), 1000);
    EXPECT_EQ(number(ran, "R5"), -800);
    EXPECT_EQ(number(ran, "R6"), 600);
}

/// A variable that the program has declared with such a name comes first.
TEST_F(Inputs, ADeclaredNameComesBeforeAMachineAxis) {
    save("m.xml", machine_with(""));
    const Ran ran = run("sinumerik",
                        "DEF AXIS YM, AX3\nYM=X AX3=Y\nG0 X10 Y20 Z30\nR1=$AA_IM[YM]\n"
                        "R2=$AA_IM[AX3]\nM30\n",
                        {"-m", file("m.xml")});
    EXPECT_EQ(ran.result.status, 0) << ran.result.err;
    EXPECT_EQ(number(ran, "R1"), 10) << "not Y, as the machine calls it";
    EXPECT_EQ(number(ran, "R2"), 20) << "not the third axis";
}

// ------------------------------------------------------------------------------ files

TEST_F(Inputs, WhatOneRunWritesTheNextOneReads) {
    const Ran first = run("fanuc", "%\nO0001\n#1=3\n#500=1/3\n#501=-1E0\n#100=4\nM30\n%\n");
    ASSERT_EQ(first.result.status, 3) << "no exponents on a FANUC";
    const Ran wrote = run("fanuc", "%\nO0001\n#1=3\n#500=1/3\n#501=0.00000001\n#100=4\nM30\n%\n");
    ASSERT_EQ(wrote.result.status, 0) << wrote.result.err;
    save("kept.json", kadr::read_file(file("out.json")).value_or(""));
    const Ran ran = run("fanuc", "%\nO0001\n#102=#500\n#103=#501\nIF[#1NE#0]THEN #104=1\nM30\n%\n",
                        {"--variables-in", file("kept.json")});
    EXPECT_EQ(ran.result.status, 0) << ran.result.err;
    EXPECT_EQ(number(ran, "#102"), 1.0 / 3);
    EXPECT_EQ(number(ran, "#103"), 1e-8);
    EXPECT_EQ(number(ran, "#104"), -999) << "what was local is gone";
}

TEST_F(Inputs, VariablesThatAProgramHadDeclaredArePassedOver) {
    const Ran wrote = run("sinumerik", "DEF REAL LEN=5\nDEF BOOL FLAG=TRUE\nR5=2.5\nM30\n");
    ASSERT_EQ(wrote.result.status, 0) << wrote.result.err;
    save("kept.json", kadr::read_file(file("out.json")).value_or(""));
    const Ran ran = run("sinumerik", "R1=R5\nM30\n", {"--variables-in", file("kept.json")});
    EXPECT_EQ(ran.result.status, 0) << ran.result.err;
    EXPECT_EQ(number(ran, "R1"), 2.5);
    EXPECT_EQ(count(ran.result.err, "warning[K9052]"), 2) << ran.result.err;
    for (const char* name : {"LEN", "FLAG"}) {
        EXPECT_NE(ran.result.err.find("the variable `" + std::string(name) +
                                      "` is not known, and passed over"),
                  std::string::npos)
            << ran.result.err;
    }
}

/// F 6.5: what the control puts out, variables with and without the sign, offsets as G10.
TEST_F(Inputs, WhatAFanucPutsOut) {
    save("punch.txt",
         "%\nO9999(SAVED)\n#500=12.5\n#501 -3.25 (PROBEX)\n#502=(NOT SET)\n"
         "G10 L2 P1 X10. Y20. Z30.\nG10 L11 P5 R0.2\n%\n");
    const Ran wrong = run("fanuc", "%\nO0001\nM30\n%\n", {"--variables-in", file("punch.txt")});
    EXPECT_EQ(wrong.result.status, 1) << wrong.result.err;
    EXPECT_NE(wrong.result.err.find("punch.txt:5:"), std::string::npos) << wrong.result.err;
    save("punch.txt",
         "%\nO9999(SAVED)\n#500=12.5\n#501 -3.25 (PROBEX)\n"
         "G10 L2 P1 X10. Y20. Z30.\nG10 L11 P5 R0.2\n%\n");
    const Ran ran = run(
        "fanuc",
        "%\nO0001\n#100=#500\n#101=#501\n#102=#5222\n#103=#10005\nG54 G0 X1.\n#104=#5021\nM30\n%\n",
        {"--variables-in", file("punch.txt")});
    EXPECT_EQ(ran.result.status, 0) << ran.result.err;
    EXPECT_EQ(number(ran, "#100"), 12.5);
    EXPECT_EQ(number(ran, "#101"), -3.25);
    EXPECT_EQ(number(ran, "#102"), 20);
    EXPECT_EQ(number(ran, "#103"), 0.2);
    EXPECT_EQ(number(ran, "#104"), 11);
}

TEST_F(Inputs, AnIniFileOfASinumerik) {
    save("all.ini",
         "%_N_INITIAL_INI\n;$PATH=/_N_MPF_DIR\nCHANDATA(1)\nN1 R5=7.5\nN2 $TC_DP1[1,1]=120\n"
         "$TC_DP6[1,1]=5\n$TC_MPP1[1,1]=3\n$TC_MPP1[1,2]=3\n$P_UIFR[1,X,TR]=100\n"
         "$P_UIFR[2]=CTRANS(Y,4)\n$MC_X=3\nM17\n");
    const Ran ran = run("sinumerik",
                        "R1=R5\nR2=$TC_DP6[1,1]\nR3=$P_UIFR[1,X,TR]\nR4=$P_UIFR[2,Y,TR]\nR6=$MC_X\n"
                        "G54 G0 X1\nR7=$AA_IM[X]\nM30\n",
                        {"--variables-in", file("all.ini")});
    EXPECT_EQ(ran.result.status, 0) << ran.result.err;
    EXPECT_EQ(number(ran, "R1"), 7.5);
    EXPECT_EQ(number(ran, "R2"), 5);
    EXPECT_EQ(number(ran, "R3"), 100);
    EXPECT_EQ(number(ran, "R4"), 4);
    EXPECT_EQ(number(ran, "R6"), 3);
    EXPECT_EQ(number(ran, "R7"), 101);
    EXPECT_EQ(count(ran.result.err, "K9052"), 1) << "once by its name\n" << ran.result.err;
    EXPECT_NE(ran.result.err.find("all.ini:7:"), std::string::npos) << ran.result.err;
}

TEST(InputLines, KeepTheirPlaces) {
    std::size_t fault = 0;
    const auto lines = [&](const char* text) {
        return kadr::driver::lines_of_variables(text, fault).value_or("none");
    };
    EXPECT_EQ(lines("{\n \"#500\": 12.5,\n \"#1\": null,\n \"A\": true, \"T\": \"ab\"\n}\n"),
              " \n  #500 = 12.5 \n            \n  A = 1      T = \"ab\"\n \n");
    EXPECT_EQ(lines("%\n#500 1.5 (A)\r\n  #501=2\nO12(X)\nN3 M30\n#5 #6"),
              "\n#500=1.5 (A)\r\n  #501=2\n\n\n#5 #6");
    EXPECT_EQ(lines("{\"#500\": [1, 2]}"), "none");
    EXPECT_EQ(fault, 9u);
    EXPECT_EQ(lines("{\"#500\": 1"), "none");
}

// ------------------------------------------------------------------------------ mistakes

TEST_F(Inputs, WrongOnesAreToldWithTheirPlace) {
    struct Wrong {
        const char* dialect;
        const char* set;
        const char* says;
    };
    for (const Wrong& row : {
             Wrong{"fanuc", "#99999=5",
                   "--set:1:1: error[K9050]: the control has no variable `#99999`"},
             Wrong{"fanuc", "R5=5", "error[K90"},
             Wrong{"fanuc", "#500=1+", "error[K9051]: this sets nothing: "},
             Wrong{"fanuc", "#1=5", "--set:1:1: error[K9054]: `#1` is a variable of the program"},
             Wrong{"fanuc", "#0=5", "error[K9051]: this sets nothing: #0 cannot be written"},
             Wrong{"sinumerik", "#500=1", "error[K90"},
             Wrong{"sinumerik", "G1 X10=5", "error[K90"},
             Wrong{"sinumerik", "NOSUCH=5",
                   "--set:1:1: error[K9050]: the control has no variable `NOSUCH`"},
             Wrong{"sinumerik", "$A_IN[3]=\"A\"", "error[K9051]: this sets nothing: "},
         }) {
        SCOPED_TRACE(row.set);
        const Ran ran = run(row.dialect, "M30\n", {"--set", row.set});
        EXPECT_EQ(ran.result.status, 1) << ran.result.err;
        EXPECT_NE(ran.result.err.find(row.says), std::string::npos) << ran.result.err;
    }
    EXPECT_EQ(run("fanuc", "M30\n", {"--set", "#500"}).result.status, 2);
    EXPECT_EQ(run("fanuc", "M30\n", {"--variables-in", "/no/such/file"}).result.status, 2);
    save("moves.ini", "R5=1\nG1 X10\n");
    const Ran moves = run("sinumerik", "M30\n", {"--variables-in", file("moves.ini")});
    EXPECT_EQ(moves.result.status, 1);
    EXPECT_NE(moves.result.err.find("moves.ini:2:1: error[K9053]: this gives no value"),
              std::string::npos)
        << moves.result.err;
    save("list.json", "{\"#500\": [1]}");
    const Ran list = run("fanuc", "M30\n", {"--variables-in", file("list.json")});
    EXPECT_EQ(list.result.status, 1);
    EXPECT_NE(list.result.err.find("list.json:1:10: error[K9055]"), std::string::npos)
        << list.result.err;
}

/// What is wrong in a machine file is told at its line; other names pass.
TEST_F(Inputs, AMistakeInTheMachineFile) {
    save("m.xml",
         machine_with(
             "<data name=\"#500\" value=\"1\"/>\n<data name=\"$TC_XYZ[1]\" value=\"2\"/>\n"));
    const Ran ran = run("fanuc", "%\nO0001\n#100=#500\nM30\n%\n", {"-m", file("m.xml")});
    EXPECT_EQ(ran.result.status, 0) << ran.result.err;
    EXPECT_EQ(number(ran, "#100"), 1);
    EXPECT_NE(ran.result.err.find("m.xml:3:"), std::string::npos) << ran.result.err;
    EXPECT_NE(ran.result.err.find("K9052"), std::string::npos) << ran.result.err;
}

// ------------------------------------------------------------------------------ events

TEST_F(Inputs, EventsGiveThemAtTheirTime) {
    save("run.txt", "0.5s set #1004=1 # door\nN30 set #1005=1\nN30 + 1s set #1006=1\n");
    const Ran ran =
        run("fanuc",
            "%\nO0001\n#100=#1004\n#101=0\nWHILE[#1004EQ0]DO1\nG4 P100\n#101=#101+1\nEND1\n"
            "#102=#1005\nN30 #103=#1005\n#104=#1006\nG4 P1000\n#105=#1006\nM30\n%\n",
            {"--events", file("run.txt"), "--set", "#1005=0", "--set", "#1006=0"});
    EXPECT_EQ(ran.result.status, 0) << ran.result.err;
    EXPECT_EQ(number(ran, "#100"), 0);
    EXPECT_EQ(number(ran, "#101"), 5) << "dwells of 0.1 s until 0.5 s";
    EXPECT_EQ(number(ran, "#102"), 0);
    EXPECT_EQ(number(ran, "#103"), 1);
    EXPECT_EQ(number(ran, "#104"), 0);
    EXPECT_EQ(number(ran, "#105"), 1);
}

TEST_F(Inputs, EventsOfASinumerik) {
    save("run.txt", "1s set $A_IN[3]=1\n1s set $A_DBR[4]=2.5\n");
    const Ran ran = run("sinumerik", "N10 R1=$A_IN[3]\nG4 F1\nR2=$A_IN[3]\nR3=$A_DBR[4]\nM30\n",
                        {"--events", file("run.txt")});
    EXPECT_EQ(ran.result.status, 0) << ran.result.err;
    EXPECT_EQ(number(ran, "R1"), 0);
    EXPECT_EQ(number(ran, "R2"), 1);
    EXPECT_EQ(number(ran, "R3"), 2.5);
}

TEST_F(Inputs, WrongEventsAreToldWithTheirLine) {
    save("run.txt", "\n0s set #99999=1\n");
    const Ran ran = run("fanuc", "%\nO0001\n#100=1\nM30\n%\n", {"--events", file("run.txt")});
    EXPECT_EQ(ran.result.status, 1) << ran.result.err;
    EXPECT_NE(ran.result.err.find("run.txt:2:"), std::string::npos) << ran.result.err;
    EXPECT_NE(ran.result.err.find("K9050"), std::string::npos) << ran.result.err;
    EXPECT_TRUE(kadr::driver::input_event("5s set #1004=1").has_value());
    EXPECT_TRUE(kadr::driver::input_event("5s set$A_IN[3]=1").has_value());
    for (const char* wrong :
         {"5s set", "5s set #1004", "set #1004=1", "5s sets #1004=1", "5s setR1=1"})
        EXPECT_FALSE(kadr::driver::input_event(wrong).has_value()) << wrong;
    for (const char* wrong :
         {"5s touch X3", "N10 touch", "N10 touch X", "N10 touch 3", "N10+1s touch X3"})
        EXPECT_FALSE(kadr::driver::probe_touch(wrong).has_value()) << wrong;
}

// ------------------------------------------------------------------------------ touches

constexpr const char* kProbeTool = "<tool number=\"9\" length=\"150 mm\" radius=\"3 mm\"/>\n";

TEST_F(Inputs, AProbeStopsAtAPlane) {
    // The lowest point of the ball meets Z 0 of the machine; the path ends there.
    save("m.xml",
         machine_with(std::string(kProbeTool) + "<probe><plane axis=\"Z\" at=\"0 mm\"/></probe>"));
    const Ran ran = run("fanuc",
                        "%\nO0001\nT9 M6\nG0 X0 Y0 Z10.\nG31 Z-10. F100\n#100=#5063\n#101=#5043\n"
                        "G91 G0 Z2.\n#102=#5043\nG90 G31 Z5. F100\n#103=#5063\nM30\n%\n",
                        {"-m", file("m.xml"), "--commands", file("c.jsonl")});
    EXPECT_EQ(ran.result.status, 0) << ran.result.err;
    EXPECT_NEAR(number(ran, "#100"), 0, 1e-6);
    EXPECT_NEAR(number(ran, "#101"), 0, 1e-6);
    EXPECT_NEAR(number(ran, "#102"), 2, 1e-6) << "the way on begins where it stopped";
    EXPECT_NEAR(number(ran, "#103"), 5, 1e-6) << "nothing there: the end of the way";
    const std::string commands = kadr::read_file(file("c.jsonl")).value_or("");
    EXPECT_NE(commands.find("\"op\":\"probe\",\"to\":{\"X\":0,\"Y\":0,\"Z\":0}"), std::string::npos)
        << commands;
}

TEST_F(Inputs, EventsSayWhereAProbeTouches) {
    save("run.txt", "N20 touch X12.5\nN30 touch none\n:7 touch X99\n");
    const Ran ran =
        run("sinumerik",
            "N10 G0 X0 Y0 F100\nN20 G1 X50 MEAS=1 F100\nR1=$AA_MW[X] R2=$AC_MEA[1]\n"
            "N30 G1 X50 MEAS=1\nR3=$AA_MW[X] R4=$AC_MEA[1]\n\nN40 G1 X20 MEAS=1\nR5=$AC_MEA[1]\n"
            "M30\n",
            {"--events", file("run.txt")});
    EXPECT_EQ(ran.result.status, 0) << ran.result.err;
    EXPECT_EQ(number(ran, "R1"), 12.5);
    EXPECT_EQ(number(ran, "R2"), 1);
    EXPECT_EQ(number(ran, "R3"), 50);
    EXPECT_EQ(number(ran, "R4"), 0);
    EXPECT_EQ(number(ran, "R5"), 0);
    EXPECT_NE(
        ran.result.err.find("warning[K5952]: the touch at X99 is not on the path of this block, "
                            "from X50 to X20"),
        std::string::npos)
        << ran.result.err;
}

/// sinumerik.md 17: MEAW measures, and the motion goes on to its end.
TEST_F(Inputs, AMeasuringMotionGoesOn) {
    save("m.xml",
         machine_with(
             std::string(kProbeTool) +
             "<probe radius=\"0 mm\"><plane axis=\"X\" at=\"30 mm\" material=\"above\"/></probe>"));
    save("run.txt", "N20 touch X12.5\n");
    for (const auto& [option, at] :
         {std::pair{std::vector<std::string>{"-m", file("m.xml")}, 30.0},
          std::pair{std::vector<std::string>{"--events", file("run.txt")}, 12.5}}) {
        SCOPED_TRACE(option[0]);
        const Ran ran = run("sinumerik",
                            "N10 T9 D1\nG0 X0 Y0 Z0\nN20 G1 X50 MEAW=1 F100\n"
                            "R1=$AA_MW[X] R2=$AA_IW[X] R3=$AA_MM[X]\nM30\n",
                            option);
        EXPECT_EQ(ran.result.status, 0) << ran.result.err;
        EXPECT_NEAR(number(ran, "R1"), at, 1e-6);
        EXPECT_NEAR(number(ran, "R2"), 50, 1e-6);
        EXPECT_NEAR(number(ran, "R3"), at, 1e-6);
    }
}

/// fanuc.md 10 and 15: a touch is said in the coordinates of the block's words, and those of G53
/// are the machine's, whatever offset and length act.
TEST_F(Inputs, TouchesOfMachineCoordinatesAreSaidInThem) {
    for (const auto& [words, touch, at] :
         {std::tuple{"G90 G53 G31 Z-10. F100", "touch Z-4", -4.0},
          std::tuple{"G91 G53 G31 Z-20. F100", "touch Z-4", -4.0},
          std::tuple{"G90 G31 Z-120. F100", "touch Z-104", -104.0 + 10}}) {
        SCOPED_TRACE(words);
        save("run.txt", std::string("N20 ") + touch + "\n");
        const Ran ran = run("fanuc",
                            std::string("%\nO0001\nG10 L2 P1 X0 Y0 Z10.\nG54\nG53 G0 Z10.\nN20 ") +
                                words + "\n#100=#5023\nM30\n%\n",
                            {"--events", file("run.txt")});
        EXPECT_EQ(ran.result.status, 0) << ran.result.err;
        EXPECT_EQ(ran.result.err.find("K5952"), std::string::npos) << ran.result.err;
        EXPECT_NEAR(number(ran, "#100"), at, 1e-6);
    }
}

TEST_F(Inputs, WithoutASurfaceThatIsToldOnce) {
    const Ran ran =
        run("fanuc", "%\nO0001\nG0 Z10.\nG31 Z-10. F100\nG0 Z10.\nG31 Z-10.\n#100=#5063\nM30\n%\n");
    EXPECT_EQ(ran.result.status, 0) << ran.result.err;
    EXPECT_EQ(number(ran, "#100"), -10);
    EXPECT_EQ(count(ran.result.err, "K5951"), 1) << ran.result.err;
}

// A macro of a shop: the middle and the diameter of a bore by four touches, each fast and slowly
// again, with the ball's radius in #503, results in #500 to #502, and the work offset S corrected.
constexpr const char* kBoreFanuc = R"(%
O9810(BORE CENTRE)
(D DIAMETER, R OVERTRAVEL, S WORK OFFSET 1 TO 6)
IF[#7EQ#0]GOTO91
IF[#18EQ#0]THEN#18=5.
#27=#5041(WHERE IT BEGINS)
#28=#5042
#30=#7/2-#503(WAY OF THE BALL)
#31=1(SIGN)
#32=1(AXIS)
WHILE[#32LE2]DO1
#31=1
WHILE[#31GE-1]DO2
IF[#32EQ2]GOTO10
G90 G31 X[#27+#31*[#30+#18]] F500.
IF[ABS[#5061-[#27+#31*[#30+#18]]]LT0.001]GOTO92
G91 G0 X-[#31*0.5]
G90 G31 X[#27+#31*[#30+#18]] F30.
#33=#5061
G0 X#27
GOTO20
N10 G90 G31 Y[#28+#31*[#30+#18]] F500.
IF[ABS[#5062-[#28+#31*[#30+#18]]]LT0.001]GOTO92
G91 G0 Y-[#31*0.5]
G90 G31 Y[#28+#31*[#30+#18]] F30.
#33=#5062
G0 Y#28
N20 IF[#31LT0]GOTO25
#15=#33
N25 IF[#31GT0]GOTO30
#16=#33
N30 #31=#31-2
END2
IF[#32EQ2]GOTO40
#500=[#15+#16]/2
#27=#500
G0 X#27
GOTO50
N40 #501=[#15+#16]/2
#502=#15-#16+2*#503
G0 Y#501
N50 #32=#32+1
END1
IF[#19EQ#0]GOTO90
#[5201+20*#19]=#[5201+20*#19]+#500
#[5202+20*#19]=#[5202+20*#19]+#501
N90 M99
N91 #3000=91(NO DIAMETER)
N92 #3000=92(NOTHING TOUCHED)
%
)";

std::string bore_machine(const std::string& error) {
    return machine_with(std::string(kProbeTool) +
                        "<offset number=\"1\" x=\"100 mm\" y=\"50 mm\" z=\"-300 mm\"/>\n"
                        "<probe offset=\"1\" error=\"" +
                        error +
                        "\">"
                        "<block from=\"-60 -60 -30 mm\" to=\"60 60 0 mm\"/>"
                        "<bore center=\"0 0 0 mm\" diameter=\"40 mm\"/></probe>");
}

/// fanuc.md 15 and 16: the macro runs to its end with a nominal bore and with one that lies 0.3 mm
/// off, called by a program and by `--call`.
TEST_F(Inputs, AProbingMacroOfAShopFindsABore) {
    const std::string call =
        "%\nO0001\nT9 M6\nG54 G0 X0 Y0\nG31 Z-10. F2000.\n"
        "G65 P9810 D40. S1\nG0 G54 X0 Y0\nM30\n%\n";
    save("O9810.nc", kBoreFanuc);
    for (const double off : {0.0, 0.3}) {
        SCOPED_TRACE(off);
        save("m.xml", bore_machine(std::to_string(off) + ' ' + std::to_string(-off) + " 0 mm"));
        const Ran ran = run("fanuc", call, {"-m", file("m.xml"), "--set", "#503=3"});
        EXPECT_EQ(ran.result.status, 0) << ran.result.err;
        EXPECT_EQ(ran.result.err, "");
        EXPECT_NEAR(number(ran, "#500"), off, 0.0011);
        EXPECT_NEAR(number(ran, "#501"), -off, 0.0011);
        EXPECT_NEAR(number(ran, "#502"), 40, 0.0021);
        const ProcessResult checked =
            kadr({"check", file("part.nc"), "-d", "fanuc", "-m", file("m.xml"), "--set", "#503=3"});
        EXPECT_EQ(checked.status, 0) << checked.err;
    }
    // The work offset holds what was found.
    const Ran corrected = run("fanuc",
                              "%\nO0001\nT9 M6\nG54 G0 X0 Y0\nG31 Z-10. F2000.\nG65 P9810 D40. S1\n"
                              "#100=#5221\n#101=#5222\nM30\n%\n",
                              {"-m", file("m.xml"), "--set", "#503=3"});
    EXPECT_NEAR(number(corrected, "#100"), 100.3, 0.0011);
    EXPECT_NEAR(number(corrected, "#101"), 49.7, 0.0011);
    // Of another size it is 0.6 mm wider; and 12 mm wider is beyond the overtravel.
    save("m.xml", bore_machine("0 0 0 mm"));
    const Ran wide =
        run("fanuc", "%\nO0001\nT9 M6\nG54 G0 X0 Y0\nG31 Z-10. F2000.\nG65 P9810 D39.4\nM30\n%\n",
            {"-m", file("m.xml"), "--set", "#503=3"});
    EXPECT_NEAR(number(wide, "#502"), 40, 0.0021);
    const Ran missed =
        run("fanuc", "%\nO0001\nT9 M6\nG54 G0 X0 Y0\nG31 Z-10. F2000.\nG65 P9810 D28.\nM30\n%\n",
            {"-m", file("m.xml"), "--set", "#503=3"});
    EXPECT_EQ(missed.result.status, 3);
    EXPECT_NE(missed.result.err.find("MC3092"), std::string::npos) << missed.result.err;
}

// The same of another control, with results in its settable frame.
constexpr const char* kBoreSinumerik = R"(PROC BOHRUNG(REAL DIA, INT NUM, REAL UEB) SAVE
DEF REAL MX, MY, WEG, PLUS, MINUS
WEG=DIA/2-$P_TOOLR+UEB
MX=$AA_IW[X]
MY=$AA_IW[Y]
G90 G94
G1 X=MX+WEG F500 MEAS=1
STOPRE
IF $AC_MEA[1]==0 GOTOF FEHLER
PLUS=$AA_MW[X]
G0 X=MX
G1 X=MX-WEG F500 MEAS=1
STOPRE
IF $AC_MEA[1]==0 GOTOF FEHLER
MINUS=$AA_MW[X]
R10=(PLUS+MINUS)/2
G0 X=R10
G1 Y=MY+WEG F500 MEAS=1
STOPRE
IF $AC_MEA[1]==0 GOTOF FEHLER
PLUS=$AA_MW[Y]
G0 Y=MY
G1 Y=MY-WEG F500 MEAS=1
STOPRE
IF $AC_MEA[1]==0 GOTOF FEHLER
MINUS=$AA_MW[Y]
R11=(PLUS+MINUS)/2
R12=PLUS-MINUS+2*$P_TOOLR
G0 Y=R11
$P_UIFR[NUM,X,TR]=$P_UIFR[NUM,X,TR]+R10
$P_UIFR[NUM,Y,TR]=$P_UIFR[NUM,Y,TR]+R11
RET
FEHLER:
SETAL(65042)
RET
)";

TEST_F(Inputs, AProbingProcedureOfAShopFindsABore) {
    save("BOHRUNG.SPF", kBoreSinumerik);
    for (const char* dialect : {"sinumerik", "axioma"}) {
        for (const double off : {0.0, 0.3}) {
            SCOPED_TRACE(dialect + std::to_string(off));
            save("m.xml", bore_machine(std::to_string(off) + ' ' + std::to_string(-off) + " 0 mm"));
            const Ran ran = run(dialect,
                                "T9 D1\nG54 G17 G0 X0 Y0 Z-10\nM5\nBOHRUNG(40,1,5)\n"
                                "R1=$P_UIFR[1,X,TR] R2=$P_UIFR[1,Y,TR]\nM30\n",
                                {"-m", file("m.xml")});
            EXPECT_EQ(ran.result.status, 0) << ran.result.err;
            EXPECT_NEAR(number(ran, "R10"), off, 1e-6);
            EXPECT_NEAR(number(ran, "R11"), -off, 1e-6);
            EXPECT_NEAR(number(ran, "R12"), 40, 1e-6);
            EXPECT_NEAR(number(ran, "R1"), 100 + off, 1e-6);
            EXPECT_NEAR(number(ran, "R2"), 50 - off, 1e-6);
        }
    }
}

/// The library's own cycles stop there, too, on every control that has them.
TEST_F(Inputs, TheLibrarysProbingFindsABore) {
    save("part.kadr",
         "import cycles.probing;\nprogram part() {\n    T9 M6; D1;\n    G54; G0 X0 Y0; G0 Z=-10; "
         "M5; F500;\n"
         "    probe_bore(d: 40mm, ball_d: 6mm, offset: 1);\n}\n");
    save("m.xml", bore_machine("0.3 -0.3 0 mm"));
    for (const char* dialect : {"fanuc", "sinumerik", "axioma"}) {
        SCOPED_TRACE(dialect);
        const ProcessResult ran = kadr({"run", file("part.kadr"), "-d", dialect, "-m",
                                        file("m.xml"), "--commands", file("c.jsonl")});
        EXPECT_EQ(ran.status, 0) << ran.err;
        std::istringstream commands(kadr::read_file(file("c.jsonl")).value_or(""));
        std::string last;
        for (std::string line; std::getline(commands, line);) {
            if (line.find("\"Y\":") < line.size()) last = line;
        }
        const json end = json::parse(last);
        EXPECT_NEAR(end["to"]["X"].get<double>(), 100.3, 0.0011) << last;
        EXPECT_NEAR(end["to"]["Y"].get<double>(), 49.7, 0.0011) << last;
    }
    // A wall in the way to the first point, one beyond its range, no part at all.
    struct Wrong {
        std::string machine;
        const char* code;
        const char* alarm;
    };
    constexpr const char* kMet =
        "alarm[65001]: the probe has triggered on its way: "
        "the probe has triggered where its path should be free";
    constexpr const char* kMissed =
        "alarm[65000]: the probe has not triggered: the probe has not triggered on its path";
    for (const Wrong& row :
         {Wrong{bore_machine("-8 0 0 mm"), "alarm[K5954]", kMet},
          Wrong{bore_machine("8 0 0 mm"), "alarm[K5953]", kMissed},
          Wrong{machine_with(std::string(kProbeTool) +
                             "<probe><plane axis=\"Z\" at=\"-900 mm\"/></probe>"),
                "alarm[K5953]", kMissed}}) {
        SCOPED_TRACE(row.machine);
        save("m.xml", row.machine);
        for (const std::string dialect : {"fanuc", "sinumerik", "axioma"}) {
            const ProcessResult ran =
                kadr({"run", file("part.kadr"), "-d", dialect, "-m", file("m.xml")});
            EXPECT_EQ(ran.status, 3) << ran.err;
            EXPECT_NE(ran.err.find(dialect == "fanuc" ? row.code : row.alarm), std::string::npos)
                << dialect << '\n'
                << ran.err;
        }
    }
}

/// Inputs that are read as one number are missing if none of them was given.
TEST_F(Inputs, AreReadAsOneNumber) {
    const std::string program = "%\nO1\n#100=#1032\nM30\n%\n";
    const Ran given = run("fanuc", program, {"--set", "#1000=1", "--set", "#1003=1"});
    EXPECT_EQ(number(given, "#100"), 9);
    EXPECT_EQ(given.result.err.find("K5950"), std::string::npos) << given.result.err;
    const Ran missing = run("fanuc", program, {});
    EXPECT_EQ(number(missing, "#100"), 0);
    EXPECT_NE(missing.result.err.find("K5950"), std::string::npos) << missing.result.err;
}

// ------------------------------------------------------------------------------ calls

/// fanuc.md 16: as G65 would call it.
TEST_F(Inputs, AMacroIsCalledFromTheCommandLine) {
    const std::string macro =
        "%\nO9010(M)\n#100=#1\n#101=#2\nIF[#3EQ#0]THEN #102=1\n#103=#7\nM99\n%\n";
    const Ran ran = run("fanuc", macro, {"--call", "A1. B#500 D-2.5", "--set", "#500=7"});
    EXPECT_EQ(ran.result.status, 0) << ran.result.err;
    EXPECT_EQ(ran.result.err, "") << "M99 returns";
    EXPECT_EQ(number(ran, "#100"), 1);
    EXPECT_EQ(number(ran, "#101"), 7);
    EXPECT_EQ(number(ran, "#102"), 1);
    EXPECT_EQ(number(ran, "#103"), -2.5);
    const Ran traced = run("fanuc", macro, {"--call", "A1.", "--trace", file("t.jsonl")});
    EXPECT_EQ(traced.result.status, 0) << traced.result.err;
    EXPECT_NE(kadr::read_file(file("t.jsonl")).value_or("").find("#100"), std::string::npos);
    EXPECT_EQ(kadr({"check", file("part.nc"), "-d", "fanuc", "--call", "A1."}).status, 0);
    EXPECT_EQ(run("fanuc-lathe", macro, {"--call", "A1."}).result.status, 0);
}

TEST_F(Inputs, AProcedureIsCalledFromTheCommandLine) {
    const std::string program =
        "PROC FIT(INT NUM, REAL DIA, STRING[20] TXT)\nR1=NUM R2=DIA R3=STRLEN(TXT) "
        "R4=$P_SUBPAR[3]\nRET\n";
    const Ran whole = run("sinumerik", program, {"--call", "(1, 2.5, \"text\")"});
    EXPECT_EQ(whole.result.status, 0) << whole.result.err;
    EXPECT_EQ(number(whole, "R1"), 1);
    EXPECT_EQ(number(whole, "R2"), 2.5);
    EXPECT_EQ(number(whole, "R3"), 4);
    EXPECT_EQ(number(whole, "R4"), 1);
    const Ran named = run("axioma", program, {"--call", "FIT(3, 4)"});
    EXPECT_EQ(named.result.status, 0) << named.result.err;
    EXPECT_EQ(number(named, "R1"), 3);
    EXPECT_EQ(number(named, "R4"), 0);
}

TEST_F(Inputs, WrongCallsAreTold) {
    struct Wrong {
        const char* dialect;
        const char* text;
        const char* call;
    };
    for (const Wrong& row : {
             Wrong{"fanuc", "%\nO1\nM99\n%\n", "A1. A"},
             Wrong{"fanuc", "%\nO1\nM99\n%\n", "G2."},
             Wrong{"sinumerik", "PROC P(INT NUM)\nRET\n", "(1,2)"},
             Wrong{"sinumerik", "PROC P(INT NUM)\nRET\n", "(\"a\")"},
             Wrong{"sinumerik", "G0 X1\nM30\n", "(1)"},
             Wrong{"sinumerik", "PROC P(INT NUM)\nRET\n", "OTHER(1)"},
             Wrong{"fanuc", "%\nO1\nM99\n%\n", "(1,2)"},
         }) {
        SCOPED_TRACE(row.call);
        const Ran ran = run(row.dialect, row.text, {"--call", row.call});
        EXPECT_EQ(ran.result.status, 1) << ran.result.err;
        EXPECT_NE(ran.result.err.find("--call:1:"), std::string::npos) << ran.result.err;
        EXPECT_NE(ran.result.err.find("K9056"), std::string::npos) << ran.result.err;
    }
    save("p.kadr", "program p() { G0 X1; }\n");
    const ProcessResult of_kadr = kadr({"run", file("p.kadr"), "-d", "fanuc", "--call", "A1."});
    EXPECT_EQ(of_kadr.status, 2);
    EXPECT_NE(of_kadr.err.find("K9057"), std::string::npos) << of_kadr.err;
}

}  // namespace

}  // namespace inputs_test
