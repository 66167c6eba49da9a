// The program as its user runs it: exit status, what goes where, and files left as they were.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/common/process.h"

namespace cli_test {

namespace {

namespace fs = std::filesystem;
using kadr::read_file;

constexpr const char* kSquare =
    "program square(length side = 20mm) {\n"
    "    tool(1);\n"
    "    G0 X0 Y0 Z5;\n"
    "    F200 S1000 M3;\n"
    "    G1 Z-1;\n"
    "    X=side; Y=side; X0; Y0;\n"
    "    G0 Z5;\n"
    "    M30;\n"
    "}\n";
constexpr const char* kWrong = "program wrong() {\n    G1 X=nothing;\n}\n";
constexpr const char* kFailing = "program failing() {\n    G0 X1;\n    error(\"too deep\");\n}\n";

class CommandLine : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("kadr-cli-" + std::to_string(::getpid()));
        fs::create_directories(folder_);
        save("square.kadr", kSquare);
        save("wrong.kadr", kWrong);
        save("failing.kadr", kFailing);
        save("flat.nc", "T1 M6\nG0 X0 Y0 Z5 S1000 M3\nG1 Z-1 F200\nG1 X10\nM30\n");
        save("old.txt", "old");
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string file(const std::string& name) const { return (folder_ / name).string(); }
    void save(const std::string& name, const std::string& text) const {
        ASSERT_TRUE(kadr::write_file_whole(file(name), text));
    }
    static ProcessResult kadr(std::vector<std::string> arguments, const std::string& input = "") {
        arguments.insert(arguments.begin(), KADR_BINARY);
        return run_process(arguments, input);
    }
    static std::size_t lines(const std::string& text) {
        return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    }

    fs::path folder_;
};

TEST_F(CommandLine, ExitStatusSaysHowItEnded) {
    save("endless.nc", "O1\nN1 #1=#1+1\nGOTO1\nM30\n");
    struct Row {
        const char* name;
        std::vector<std::string> arguments;
        int status;
    };
    for (const Row& row : {
             Row{"expand", {"expand", file("square.kadr")}, 0},
             Row{"help", {"--help"}, 0},
             Row{"help of a command", {"run", "--help"}, 0},
             Row{"version", {"--version"}, 0},
             Row{"check", {"check", file("square.kadr"), file("flat.nc"), "-d", "iso"}, 0},
             Row{"wrong program", {"expand", file("wrong.kadr")}, 1},
             Row{"wrong program, checked", {"check", file("square.kadr"), file("wrong.kadr")}, 1},
             Row{"error while it runs", {"expand", file("failing.kadr")}, 1},
             Row{"no command", {}, 2},
             Row{"unknown command", {"expnad"}, 2},
             Row{"unknown option", {"expand", "--fast", file("square.kadr")}, 2},
             Row{"no source", {"expand"}, 2},
             Row{"missing source", {"expand", file("missing.kadr")}, 2},
             Row{"missing text", {"run", file("missing.nc")}, 2},
             Row{"missing source, checked", {"check", file("missing.kadr")}, 2},
             Row{"folder as source", {"check", folder_.string()}, 2},
             Row{"ISO text to expand", {"expand", file("flat.nc")}, 2},  // K9006
             Row{"unknown control", {"expand", file("square.kadr"), "-d", "nosuch"}, 2},
             Row{"unknown machine", {"run", file("square.kadr"), "-m", "nosuch"}, 2},
             Row{"not a time", {"run", file("square.kadr"), "--tick", "1mm"}, 2},
             Row{"a number without a unit", {"run", file("square.kadr"), "--tick", "5"}, 2},
             Row{"a time with a blank", {"run", file("square.kadr"), "--tick", "4 ms"}, 0},
             Row{"a size with a blank", {"check", file("square.kadr"), "--max-input", "2 GiB"}, 0},
             Row{"a blank for a unit", {"run", file("square.kadr"), "--tick", "5 "}, 2},
             Row{"two units", {"run", file("square.kadr"), "--tick", "4 m s"}, 2},
             Row{"a tick of a minute", {"run", file("square.kadr"), "--tick", "1min"}, 2},
             Row{"no feed at all", {"run", file("square.kadr"), "--feed-override", "0"}, 2},
             Row{"rapid above the axes",
                 {"run", file("square.kadr"), "--rapid-override", "101"},
                 2},
             Row{"not a definition", {"run", file("square.kadr"), "-D", "side"}, 2},
             Row{"later command", {"repl", file("square.kadr")}, 2},
             Row{"map of ISO text", {"run", file("flat.nc"), "--map", file("map")}, 2},  // K9011
             Row{"no time",
                 {"run", file("flat.nc"), "-d", "iso", "--max-time", "1us"},
                 3},  // K5263
             Row{"no time to check",
                 {"check", file("flat.nc"), "-d", "iso", "--max-time", "1us"},
                 1},  // K5263
             Row{"too many blocks to check",
                 {"check", file("flat.nc"), "-d", "iso", "--max-blocks", "2"},
                 1},  // K5262
             Row{"too many lines of the control's language",
                 {"run", file("endless.nc"), "-d", "fanuc", "--max-blocks", "1000"},
                 3},  // K5443
             Row{"too many lines to check",
                 {"check", file("endless.nc"), "-d", "fanuc", "--max-blocks", "1000"},
                 1},                                                   // K5443
             Row{"of several controls", {"run", file("flat.nc")}, 2},  // K9015
             Row{"not a number of blocks", {"run", file("flat.nc"), "--max-blocks", "0"}, 2},
             Row{"not a number of passes", {"run", file("flat.nc"), "--passes", "0"}, 2},
             Row{"two results to standard output",
                 {"run", file("flat.nc"), "--commands", "-", "--summary", "json"},
                 2},
         }) {
        SCOPED_TRACE(row.name);
        const ProcessResult result = kadr(row.arguments);
        EXPECT_EQ(result.status, row.status) << result.err;
        EXPECT_EQ(result.err.empty(), row.status == 0) << result.err;
    }
}

TEST_F(CommandLine, ExpandsToStandardOutputOrFile) {
    const ProcessResult shown = kadr({"expand", file("square.kadr"), "-D", "side=30mm"});
    EXPECT_NE(shown.out.find("X30"), std::string::npos) << shown.out << shown.err;
    const ProcessResult saved =
        kadr({"expand", file("square.kadr"), "-D", "side=30mm", "-o", file("a.nc")});
    EXPECT_EQ(saved.out, "");
    EXPECT_EQ(read_file(file("a.nc")), shown.out);
}

TEST_F(CommandLine, ReadsStandardInput) {
    EXPECT_EQ(kadr({"expand", "-"}, kSquare).out, kadr({"expand", file("square.kadr")}).out);
    const std::string flat = read_file(file("flat.nc")).value();
    const ProcessResult text = kadr({"run", "-", "-d", "iso", "--summary", "json"}, flat);
    EXPECT_EQ(text.status, 0) << text.err;
    EXPECT_EQ(nlohmann::json::parse(text.out)["alarms"], 0);
    EXPECT_EQ(kadr({"run", "-"}, kSquare).status, 0);  // told by its looks
    EXPECT_EQ(kadr({"check", "-"}, kWrong).status, 1);
}

TEST_F(CommandLine, ErrorsLeaveOutputsAsTheyWere) {
    for (const char* source : {"wrong.kadr", "failing.kadr"}) {
        SCOPED_TRACE(source);
        EXPECT_EQ(kadr({"expand", file(source), "-o", file("old.txt")}).status, 1);
        EXPECT_EQ(read_file(file("old.txt")), "old");
        EXPECT_EQ(
            kadr({"run", file(source), "--commands", file("old.txt"), "--plot", file("new.svg")})
                .status,
            1);
        EXPECT_EQ(read_file(file("old.txt")), "old");
        EXPECT_FALSE(fs::exists(file("new.svg")));
        EXPECT_EQ(kadr({"expand", file(source)}).out, "");
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 5);
}

TEST_F(CommandLine, TheFileBehindStandardOutputIsNotReplaced) {
    const std::string run = std::string(KADR_BINARY) + " run " + file("flat.nc") +
                            " -d iso --commands /dev/stdout --summary text; echo after";
    const ProcessResult result =
        run_process({"/bin/sh", "-c", '(' + run + ") > " + file("all.txt")});
    EXPECT_EQ(result.err, "");
    const std::string all = read_file(file("all.txt")).value();
    EXPECT_NE(all.find("{\"op\":\"rapid\""), std::string::npos) << all;
    EXPECT_NE(all.find("flat.nc\n"), std::string::npos) << all;
    EXPECT_TRUE(all.ends_with("after\n")) << all;
}

TEST_F(CommandLine, CutsWithoutFeedOrSpindleAreWarnedOf) {
    struct Row {
        const char* name;
        const char* body;
        const char* message;  // in `expand` and `check`; empty: none
    };
    for (const Row& row :
         {Row{"tool", "S1000 M3; F100; G0 X0; G1 X1; G1 X2;", "warning[K5265]"},
          Row{"down at rapid", "tool(2); G0 X-5 Z-5; Z-6; S1000 M3;", "warning[K5264]"},
          Row{"down from a known height", "tool(2); G0 Z5; Z+=-9; S1000 M3;", "warning[K5264]"},
          Row{"up below the zero", "tool(2); S1000 M3; G0 Z-5; M5; G0 Z-2;", ""},
          Row{"not into the work", "G18; tool(2); G0 Z-5; S1000 M3;", ""},
          Row{"unknown text", "raw \"M77\"; G90 G94 G97 G17; S9 M3; F9; G0 X0; G1 X1;", ""},
          Row{"spindle", "F100; G0 X0; G1 X1; G1 X2;", "warning[K5213]"},
          Row{"speed", "S0 M3; F100; G0 X0; G1 X1;", "warning[K5213]"},
          Row{"tool change", "S500 M3; F100; tool(2); G0 X0; G1 X1;", "warning[K5213]"},
          Row{"turret", "G18; S500 M3; F100; tool(2); G0 X0; G1 X1;", ""},
          Row{"no speed", "tool(2); M3; F100; G0 X0; G1 X1; X2;", "warning[K5217]"},
          Row{"a speed behind the start", "tool(2); M3; S100; F100; G0 X0; G1 X1;", ""},
          Row{"a probe",
              "work_offset(1); tool(2); G0 X0 Y0; G0 Z50; probe_edge(z_minus, at: -3mm, ball_d: "
              "6mm, offset: 1);",
              ""},
          Row{"again", "tool(2); S500 M3; F100; G0 X0; G1 X1;", ""}}) {
        SCOPED_TRACE(row.name);
        save("cut.kadr",
             std::string("import cycles.probing;\nprogram cut() { ") + row.body + " M30; }\n");
        for (const char* command : {"expand", "check"}) {
            const ProcessResult result = kadr({command, file("cut.kadr"), "-d", "sinumerik"});
            EXPECT_EQ(result.status, 0);
            const std::size_t at = result.err.find("warning[");
            EXPECT_EQ(result.err.empty(), *row.message == 0) << result.err;
            if (*row.message == 0) continue;
            EXPECT_NE(result.err.find(row.message), std::string::npos) << result.err;
            // Each is said once.
            EXPECT_EQ(result.err.find("warning[", at + 1), std::string::npos) << result.err;
        }
    }
}

TEST_F(CommandLine, AStandingSpindleIsWarnedOfAnewEachTimeThatItWasStopped) {
    struct Row {
        const char* name;
        const char* body;
        std::vector<int> lines;  // of the warnings
    };
    for (const Row& row :
         {Row{"stopped twice",
              "M3 S100;\nG0 X0 F100;\nM5;\nG1 X1;\nX2;\nM3;\nX3;\nM5;\nX4;\nX5;",
              {5, 10}},
          Row{"allowed",
              "G0 X0 F100 S100;\nM5;\nG1 X1; // kadr: allow K5213\nM3;\nG1 X2;\nM5;\nG1 X3;",
              {8}},
          Row{"allowed at its line alone",
              "G0 X0 F100 S100;\nM5;\nG1 X1; // kadr: allow K5213\nG1 X2;\nG1 X3;",
              {5}},
          Row{"tool change",
              "G0 X0 F100 S100;\nG1 X1; // kadr: allow K5213\ntool(3);\nG1 X2;\nM3;\nG1 X3;",
              {5}},
          Row{"rapid",
              "G0 Z5;\nG0 Z-3; // kadr: allow K5264\nG0 Z5 M3 S100;\nM5;\nG0 Z-4;\nZ-5;",
              {6}}}) {
        SCOPED_TRACE(row.name);
        save("stands.kadr", std::string("program p() { tool(2);\n") + row.body + "\nM30; }\n");
        const ProcessResult result = kadr({"check", file("stands.kadr"), "-d", "sinumerik"});
        std::vector<int> lines;
        const std::string text = file("stands.kadr") + ":";
        for (std::size_t at = result.err.find("warning["); at != std::string::npos;
             at = result.err.find("warning[", at + 1)) {
            const std::size_t begin = result.err.rfind(text, at) + text.size();
            lines.push_back(std::stoi(result.err.substr(begin)));
        }
        EXPECT_EQ(lines, row.lines) << result.err;
    }
}

/// Case 19: behind the end of a program a mistake is one only if something leads there.
TEST_F(CommandLine, WhatStandsBehindTheEndIsWrongOnlyIfItIsReached) {
    struct Row {
        const char* name;
        const char* text;
        const char* dialect;
        int line;
    };
    for (const Row& row :
         {Row{"behind.mpf", "R1=2\nIF R1==1 GOTOF LAB2\nM30\nLAB2: FOOBAR(1)\nG1 X==\nM30\n",
              "sinumerik", 4},
          Row{"behind.nc", "O1\n#1=2\nIF[#1EQ1]GOTO9\nM30\nN9 G01 X\nM30\n", "fanuc", 5},
          Row{"over.mpf", "R1=2\nGOTOF LAB2\nFOOBAR(1)\nLAB2: G0 X1\nM30\n", "sinumerik", 3},
          Row{"branch.mpf", "IF R1==1\nG1 X==\nELSE\nG0 X1\nENDIF\nM30\n", "sinumerik", 2},
          Row{"over.nc", "O1\nG0 X1\nGOTO9\nG01 X\nN9 M30\n%\n", "fanuc", 4},
          Row{"never.nc", "O1\nWHILE[#100GT5]DO1\nG01 X\nEND1\nM30\n", "fanuc", 3},
          Row{"jump.nc", "O1\nGOTO5\nIF[#1EQ1]GOTO88\nN5 M30\n", "fanuc", 3},
          Row{"call.nc", "O1\nGOTO5\nM98 P77\nN5 M30\n", "fanuc", 3},
          Row{"macro.nc", "O1\nGOTO5\nG65 P78\nN5 M30\n", "fanuc", 3},
          Row{"jump.mpf", "IF R1==1\nGOTOF NIX\nENDIF\nM30\n", "sinumerik", 2}}) {
        SCOPED_TRACE(row.name);
        save(row.name, row.text);
        const std::string place = file(row.name) + ':' + std::to_string(row.line) + ':';
        const ProcessResult checked = kadr({"check", file(row.name), "-d", row.dialect});
        EXPECT_EQ(checked.status, 0) << checked.err;
        EXPECT_EQ(checked.err.find("alarm["), std::string::npos) << checked.err;
        EXPECT_NE(checked.err.find(place), std::string::npos) << checked.err;
        EXPECT_NE(checked.err.find("warning[K5921]: if it is reached: "), std::string::npos);
        const ProcessResult run = kadr({"run", file(row.name), "-d", row.dialect});
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_EQ(run.err.find(place), std::string::npos) << run.err;
    }
    // 30012 is three times the program 12.
    save("thrice.nc", "O1\nGOTO5\nM98 P30012\nN5 M30\nO12\nM99\n");
    const ProcessResult thrice = kadr({"check", file("thrice.nc"), "-d", "fanuc"});
    EXPECT_EQ(thrice.err.find("K5921"), std::string::npos) << thrice.err;
    // A subprogram behind knows its parameters, whatever they will be.
    save("behind_sub.mpf",
         "G0 X8\nM30\n%_N_SUB_SPF\nPROC SUB(AXIS AA1, INT BB1)\nDEF REAL CC1[BB1]\n"
         "R1=$P_EP[AA1]+CC1[0]\nRET\n");
    const ProcessResult sub = kadr({"check", file("behind_sub.mpf"), "-d", "sinumerik"});
    EXPECT_EQ(sub.err.find("K5921"), std::string::npos) << sub.err;
    // In front of the end it is a mistake, and so is what stands behind that.
    save("before.mpf", "G1 X==\nFOOBAR(1)\nM30\nFOOBAR(2)\n");
    const ProcessResult checked = kadr({"check", file("before.mpf"), "-d", "sinumerik"});
    EXPECT_EQ(checked.status, 1);
    EXPECT_EQ(checked.err.find("K5921"), std::string::npos) << checked.err;
}

/// Case 6: a program for a lathe that says no plane.
TEST_F(CommandLine, ThePlaneOfALatheActsFromTheStart) {
    save("turn.mpf", "G54 G95 T1 D1\nS500 M4\nG0 X40 Z0\nG3 X50 Z-5 CR=5 F0.2\nM30\n");
    save("mill.mpf", "G17 G95 T1 D1\nS500 M4\nG0 X40 Z0\nG3 X50 Z-5 CR=5 F0.2\nM30\n");
    for (const char* dialect : {"sinumerik", "axioma"}) {
        for (const char* command : {"check", "run"}) {
            SCOPED_TRACE(std::string(command) + ' ' + dialect);
            EXPECT_EQ(kadr({command, file("turn.mpf"), "-d", dialect, "-m", "lathe"}).status, 0);
            const ProcessResult wrong =
                kadr({command, file("mill.mpf"), "-d", dialect, "-m", "lathe"});
            EXPECT_NE(wrong.status, 0);
            EXPECT_NE(wrong.err.find("the machine has no axis Y"), std::string::npos) << wrong.err;
            EXPECT_NE(wrong.err.find("`G18`"), std::string::npos) << wrong.err;
        }
    }
}

TEST_F(CommandLine, CountedNumbersLieAboveThoseOfTheSource) {
    save("own.kadr",
         "dialect sinumerik;\nprogram p() { G0 X1; N10 G0 X2; X3; N25 X4; N7 X5; M30; }\n");
    const ProcessResult result = kadr({"expand", file("own.kadr"), "-d", "sinumerik"});
    EXPECT_EQ(result.err, "");
    EXPECT_NE(result.out.find("N40 G0 X1\nN10 X2\nN50 X3\nN25 X4\nN7 X5\nN60 M30\n"),
              std::string::npos)
        << result.out;
}

TEST_F(CommandLine, AHeaderTellsControlsOfOneSuffixApart) {
    struct Row {
        const char* name;
        const char* text;
        const char* first;  // coordinate that X10 means; null: the text is refused
    };
    for (const Row& row : {Row{"fanuc", "%\nO0001\nG0 X10\nM30\n%\n", "\"X\":0.01"},
                           Row{"without its percent sign", "O0001(A)\nG0 X10\nM30\n", "\"X\":0.01"},
                           Row{"axioma", "%_N_A_MPF\nN10 G0 X10\nN20 M30\n", "\"X\":10"},
                           Row{"nothing", "N10 G0 X10\nN20 M30\n", nullptr}}) {
        SCOPED_TRACE(row.name);
        save("part.nc", row.text);
        const ProcessResult result = kadr({"run", file("part.nc"), "--commands", "-"});
        if (row.first == nullptr) {
            EXPECT_EQ(result.status, 2);
            EXPECT_NE(result.err.find("error[K9015]"), std::string::npos) << result.err;
            EXPECT_NE(result.err.find("`-d axioma` or `-d fanuc`"), std::string::npos)
                << result.err;
        } else {
            EXPECT_NE(result.out.find(row.first), std::string::npos) << result.out << result.err;
        }
    }
}

// `dialect "./shop.xml";` is read beside its source, wherever the command stands, or refused there.
TEST_F(CommandLine, ASourceMayNameADialectFile) {
    save("shop.xml",
         "<dialect name=\"shop\" extends=\"fanuc\" title=\"t\" "
         "suffix=\"nc\"><doc>d</doc></dialect>");
    const std::string source = "program p() { tool(1); G0 X10. Y0. Z5.; M30; }\n";
    save("by_file.kadr", "dialect \"./shop.xml\";\nlanguage en;\n" + source);
    save("no_file.kadr", "dialect \"./none.xml\";\n" + source);
    save("empty.kadr", "dialect \"\";\n" + source);
    const ProcessResult read = kadr({"check", file("by_file.kadr")});
    EXPECT_EQ(read.status, 0) << read.err;
    // A number without a point is a FANUC's matter, which the file extends.
    save("by_file.kadr", "dialect \"shop.xml\";\nprogram p() { tool(1); G0 X10 Y0. Z5.; M30; }\n");
    const ProcessResult point = kadr({"check", file("by_file.kadr")});
    EXPECT_EQ(point.status, 1);
    EXPECT_NE(point.err.find("K4115"), std::string::npos) << point.err;
    for (const char* name : {"no_file.kadr", "empty.kadr"}) {
        const ProcessResult refused = kadr({"check", file(name)});
        EXPECT_EQ(refused.status, 1) << name;
        EXPECT_NE(refused.err.find(std::string(name) + ":1:"), std::string::npos) << refused.err;
        EXPECT_NE(refused.err.find("K4001"), std::string::npos) << refused.err;
    }
}

TEST_F(CommandLine, UnwritableOutputsAreRefused) {
    const ProcessResult result = kadr({"expand", file("square.kadr"), "-o", file("missing/a.nc")});
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("error[K9002]"), std::string::npos) << result.err;
    EXPECT_EQ(kadr({"expand", file("square.kadr"), "-o", file("square.kadr")}).status, 2);  // K9004
    EXPECT_EQ(read_file(file("square.kadr")), kSquare);
}

TEST_F(CommandLine, AlarmsEndWithThreeAndKeepWhatCameBefore) {
    save("alarm.nc", "G0 X0 Y0 Z5\nG0 X10\nG1 X20\nG0 X30\nM30\n");  // no feed: the third block
    const ProcessResult result =
        kadr({"run", file("alarm.nc"), "-d", "iso", "--commands", file("old.txt"), "--setpoints",
              file("a.csv"), "--plot", file("a.svg")});
    EXPECT_EQ(result.status, 3) << result.err;
    EXPECT_NE(result.err.find("alarm.nc:3:"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("K9007"), std::string::npos) << result.err;
    const std::string commands = read_file(file("old.txt")).value();
    EXPECT_EQ(lines(commands), 3u) << commands;
    EXPECT_NE(commands.find("\"op\":\"alarm\""), std::string::npos);
    EXPECT_NE(read_file(file("a.csv")).value().find("# not complete"), std::string::npos);
    EXPECT_NE(read_file(file("a.svg")).value().find("not complete"), std::string::npos);
    EXPECT_EQ(kadr({"check", file("alarm.nc"), "-d", "iso"}).status, 1);
}

TEST_F(CommandLine, OnlyWhatIsReachedIsComplainedOf) {
    // The reader is ahead of the execution: it must not speak first, nor of what stands behind the
    // end.
    save("early.nc", "G0 X0 Y0 Z5\nG1 X20\n?!\nM30\n");
    const ProcessResult early =
        kadr({"run", file("early.nc"), "-d", "iso", "--commands", file("a.jsonl")});
    EXPECT_EQ(early.status, 3);
    EXPECT_NE(early.err.find("early.nc:2:"), std::string::npos) << early.err;
    EXPECT_EQ(early.err.find("early.nc:3:"), std::string::npos) << early.err;
    save("behind.nc", "G0 X0 Y0 Z5\nM30\n?!\n");
    EXPECT_EQ(kadr({"run", file("behind.nc"), "-d", "iso"}).status, 0);
    // A check wants to know everything.
    const ProcessResult checked = kadr({"check", file("early.nc"), "-d", "iso"});
    EXPECT_NE(checked.err.find("early.nc:2:"), std::string::npos) << checked.err;
    EXPECT_NE(checked.err.find("early.nc:3:"), std::string::npos) << checked.err;
}

TEST_F(CommandLine, WhatIsPassedOverIsSaidThoughTheProgramEnds) {
    save("beside.mpf",
         "G0 X10\nID=1 WHEN $AA_IM[X]>10 DO M8\nATOL[X]=50\nX20\nM30\nID=2 EVERY $A_IN[1] DO M9\n");
    const ProcessResult result = kadr({"run", file("beside.mpf"), "-d", "sinumerik"});
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.err.find("beside.mpf:2:1: warning[K5488]"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("beside.mpf:3:1: warning[K5247]"), std::string::npos) << result.err;
    EXPECT_EQ(result.err.find("ID=2"), std::string::npos) << result.err;
}

TEST_F(CommandLine, ArcsInSpaceHaveTheirNormal) {
    save("space.mpf",
         "T1 D1 M6\nS500 M3 F100\nG0 X0 Y0 Z0\nCIP X20 Y0 Z0 I1=10 J1=0 K1=10\n"
         "G2 X30 Y0 CR=5\nMSG(\"\xC4rger\")\nM30\n");
    const ProcessResult result =
        kadr({"run", file("space.mpf"), "-d", "sinumerik", "--commands", "-"});
    std::istringstream lines(result.out);
    int arcs = 0;
    for (std::string line; std::getline(lines, line);) {
        const auto command = nlohmann::json::parse(line);  // throws where it is not UTF-8
        if (command["op"] == "message") {
            EXPECT_NE(command["text"], "");
        }
        if (command["op"] != "arc") continue;
        EXPECT_EQ(command.contains("normal"), arcs == 0) << line;
        if (arcs++ == 0) {
            EXPECT_NEAR(std::abs(command["normal"][1].get<double>()), 1, 1e-9);
        }
    }
    EXPECT_EQ(arcs, 2);
}

TEST_F(CommandLine, VariablesAreAnObject) {
    EXPECT_EQ(kadr({"run", file("flat.nc"), "-d", "iso", "--variables", "-"}).out, "{}\n");
}

TEST_F(CommandLine, WhatAProgramPrintsGoesToAFile) {
    save("print.nc", "%\nO0001\n#1=12.5\nPOPEN\nDPRNT[X#1[43]]\nDPRNT[END]\nPCLOS\nM30\n%\n");
    const ProcessResult printed = kadr({"run", file("print.nc"), "-d", "fanuc", "--print", "-"});
    EXPECT_EQ(printed.status, 0) << printed.err;
    EXPECT_EQ(printed.out, "X   12.500\nEND\n");
    // What came before an alarm is kept.
    save("alarm.nc", "%\nO0001\nPOPEN\nDPRNT[A]\n#3000=1(STOP)\nDPRNT[B]\nM30\n%\n");
    EXPECT_EQ(kadr({"run", file("alarm.nc"), "-d", "fanuc", "--print", file("out.txt")}).status, 3);
    EXPECT_EQ(read_file(file("out.txt")), "A\n");
}

/// Lines behind an alarm are not executed, though blocks are read ahead as a rule.
TEST_F(CommandLine, AnAlarmLeavesTheVariablesThatCameBeforeIt) {
    save("early.mpf", "R1=1\nG1 X5\nR4=4\nM30\n");
    const ProcessResult early =
        kadr({"run", file("early.mpf"), "-d", "sinumerik", "--variables", "-"});
    EXPECT_EQ(early.status, 3);
    EXPECT_NE(early.out.find("\"R1\""), std::string::npos) << early.out;
    EXPECT_EQ(early.out.find("\"R4\""), std::string::npos) << early.out;
    save("early.nc", "%\nO0001\nPOPEN\nDPRNT[A]\nG1 X5.\nDPRNT[B]\nPCLOS\nM30\n%\n");
    EXPECT_EQ(kadr({"run", file("early.nc"), "-d", "fanuc", "--print", file("out.txt")}).status, 3);
    EXPECT_EQ(read_file(file("out.txt")), "A\n");
}

TEST_F(CommandLine, AlarmInGeneratedTextNamesTheStatement) {
    save("nofeed.kadr",
         "program nofeed() {\n    G0 X0;\n    raw \"G1 X20\";\n    G90 G0 X30;\n}\n");
    const ProcessResult result =
        kadr({"run", file("nofeed.kadr"), "-d", "iso", "--commands", file("old.txt")});
    EXPECT_EQ(result.status, 3) << result.err;
    EXPECT_NE(result.err.find("nofeed.kadr:3:5: alarm["), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("nofeed.iso:4:1: note: it writes this line"), std::string::npos)
        << result.err;
}

TEST_F(CommandLine, JsonDiagnosticsAreOneObjectALine) {
    const ProcessResult result = kadr({"check", file("wrong.kadr"), "--diagnostics", "json"});
    EXPECT_EQ(result.status, 1);
    ASSERT_GE(lines(result.err), 1u);
    const nlohmann::json message =
        nlohmann::json::parse(result.err.substr(0, result.err.find('\n')));
    EXPECT_EQ(message["severity"], "error");
    EXPECT_EQ(message["line"], 2);
    EXPECT_EQ(message["column"], 10);
}

TEST_F(CommandLine, RunWritesEveryOutput) {
    const ProcessResult result = kadr(
        {"run", file("square.kadr"), "--commands", file("a.jsonl"), "--setpoints", file("a.csv"),
         "--plot", file("a.svg"), "--map", file("a.map"), "--summary", "json", "--tick", "10ms"});
    ASSERT_EQ(result.status, 0) << result.err;
    const nlohmann::json summary = nlohmann::json::parse(result.out);
    EXPECT_GT(summary["time_s"], 20.0);  // 4 · 20 mm at 200 mm/min are 24 s
    EXPECT_EQ(summary["travel"]["X"]["max"], 20);

    const std::string commands = read_file(file("a.jsonl")).value();
    EXPECT_EQ(lines(commands), summary["commands"]);
    EXPECT_NE(commands.find("square.kadr:5\""), std::string::npos) << commands;

    const std::string setpoints = read_file(file("a.csv")).value();
    EXPECT_TRUE(setpoints.starts_with("t,X,Y,Z")) << setpoints.substr(0, 80);
    EXPECT_NE(setpoints.find("\n0.01,"), std::string::npos);
    EXPECT_EQ(setpoints.find("\n0.001,"), std::string::npos);

    const std::string map = read_file(file("a.map")).value();
    const nlohmann::json entry = nlohmann::json::parse(map.substr(0, map.find('\n')));
    EXPECT_EQ(entry["line"], 2);
    EXPECT_EQ(entry["file"], file("square.kadr"));
}

TEST_F(CommandLine, OverridesActOnWhatTheyAreFor) {
    const auto times = [this](const std::vector<std::string>& switches) {
        std::vector<std::string> arguments = {"run", file("square.kadr"), "--summary", "json"};
        arguments.insert(arguments.end(), switches.begin(), switches.end());
        const ProcessResult result = kadr(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        const nlohmann::json summary = nlohmann::json::parse(result.out);
        return std::pair<double, double>(summary["cutting_s"], summary["rapid_s"]);
    };
    const auto [cutting, rapid] = times({});
    const auto [half_cutting, same_rapid] = times({"--feed-override", "50"});
    // Twice the time, but for ramps of some milliseconds.
    EXPECT_NEAR(half_cutting, 2 * cutting, 0.1);
    EXPECT_NEAR(same_rapid, rapid, 0.01);
    const auto [same_cutting, slow_rapid] = times({"--rapid-override", "5"});
    EXPECT_NEAR(same_cutting, cutting, 0.01);
    EXPECT_GT(slow_rapid, 1.5 * rapid);
}

TEST_F(CommandLine, RunWithoutOutputsTellsAPerson) {
    const ProcessResult result = kadr({"run", file("square.kadr")});
    EXPECT_TRUE(result.out.starts_with("square.kadr\n")) << result.out << result.err;
    EXPECT_EQ(kadr({"run", file("square.kadr"), "--plot", file("a.svg")}).out, "");
}

TEST_F(CommandLine, TruthIsSaidInTheWordsOfTheProgram) {
    save("truth.kadr", "language ru;\nпрограмма p(логический ф) { если (ф) M8; иначе M9; M30; }\n");
    const auto expand = [&](const char* value) {
        return kadr({"expand", file("truth.kadr"), "-D", std::string("ф=") + value});
    };
    EXPECT_NE(expand("истина").out.find("M8"), std::string::npos);
    EXPECT_NE(expand("ложь").out.find("M9"), std::string::npos);
    EXPECT_NE(expand("false").out.find("M9"), std::string::npos);
    EXPECT_NE(expand("нет").err.find("истина"), std::string::npos);
}

TEST_F(CommandLine, MissingModuleProposesOne) {
    save("import.kadr", "import cycles.driling;\nprogram p() { G0 X1; }\n");
    const ProcessResult result = kadr({"check", file("import.kadr")});
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.err.find("import.kadr:1:"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("K9003"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("`cycles.drilling`"), std::string::npos) << result.err;
}

TEST_F(CommandLine, ProposesWhatMends) {
    save("library.kadr", "program p() {\n    drill_peck(to: -3mm, peck: 1mm);\n}\n");
    EXPECT_NE(kadr({"check", file("library.kadr")}).err.find("`import cycles.drilling;`"),
              std::string::npos);
    save("struct.kadr",
         "struct hole { length d; }\nprogram p(hole h) {\n    G0 X=h.d;\n    M30;\n}\n");
    const ProcessResult missing = kadr({"expand", file("struct.kadr")});
    EXPECT_EQ(missing.status, 1);
    EXPECT_NE(missing.err.find("no option can set `hole`"), std::string::npos) << missing.err;
    save("length.kadr", "program p(length d) {\n    G0 X=d;\n    M30;\n}\n");
    EXPECT_NE(kadr({"expand", file("length.kadr")}).err.find("`-D d=…`"), std::string::npos);
}

TEST_F(CommandLine, ExplainsItsMessages) {
    const ProcessResult one = kadr({"explain", "K9001"});
    EXPECT_TRUE(one.out.starts_with("error[K9001]: cannot read")) << one.out;
    EXPECT_NE(one.out.find("wrong:"), std::string::npos);
    const ProcessResult all = kadr({"explain"});
    EXPECT_NE(all.out.find("\nK9001"), std::string::npos);
    EXPECT_EQ(kadr({"explain", "K0000"}).status, 2);  // K9010
    // By the number that the control shows: all that raises it, and on which control.
    for (const char* number : {"PS0011", "ps11"}) {
        const ProcessResult alarm = kadr({"explain", number});
        EXPECT_EQ(alarm.status, 0) << alarm.err;
        EXPECT_NE(alarm.out.find("alarm PS0011 of FANUC"), std::string::npos) << alarm.out;
        EXPECT_NE(alarm.out.find("F200"), std::string::npos) << alarm.out;
    }
    const ProcessResult siemens = kadr({"explain", "14040"});
    EXPECT_NE(siemens.out.find("alarm 14040 of SINUMERIK"), std::string::npos) << siemens.out;
    EXPECT_EQ(kadr({"explain", "PS99999"}).status, 2);  // K9010
}

TEST_F(CommandLine, WhatTheControlWouldAlarmOnIsNotWritten) {
    save("feed.kadr", "program p() { tool(2); S1000 M3; G0 X0; G1 X1; G1 X2; M30; }\n");
    for (const char* command : {"expand", "check"}) {
        const ProcessResult core = kadr({command, file("feed.kadr"), "-d", "iso"});
        EXPECT_EQ(core.status, 0);
        EXPECT_NE(core.err.find("warning[K3222]"), std::string::npos) << core.err;
        const ProcessResult real = kadr({command, file("feed.kadr"), "-d", "fanuc"});
        EXPECT_EQ(real.status, 1);
        EXPECT_EQ(real.out, "");
        EXPECT_NE(real.err.find("error[K3223]: no feed is set for this cut: fanuc stops with alarm "
                                "PS0011"),
                  std::string::npos)
            << real.err;
    }
    EXPECT_EQ(kadr({"run", file("feed.kadr"), "-d", "fanuc"}).status, 3);
    save("times.kadr", "program p() { dwell(0.4ms); S0.2 M3; M30; }\n");
    const ProcessResult times = kadr({"expand", file("times.kadr"), "-d", "fanuc"});
    EXPECT_EQ(times.status, 1);
    EXPECT_NE(times.err.find("0.0004 s does not survive"), std::string::npos) << times.err;
    EXPECT_NE(times.err.find("0.2 rpm does not survive"), std::string::npos) << times.err;
    save("plane.kadr",
         "program p() { tool(1); S1000 M3 F100; G0 X0 Y0 Z5; G18; G2 X10 Z5 I5 K0; M30; }\n");
    EXPECT_NE(kadr({"expand", file("plane.kadr"), "-d", "sinumerik"}).err.find("warning[K4134]"),
              std::string::npos);
    EXPECT_EQ(kadr({"expand", file("plane.kadr"), "-d", "fanuc"}).err.find("K4134"),
              std::string::npos);
    save("letters.kadr", "program p() { for (int i : 1..2) raw \"(деталь)\"; M30; }\n");
    const ProcessResult letters = kadr({"expand", file("letters.kadr"), "-d", "fanuc"});
    EXPECT_EQ(letters.status, 0);
    EXPECT_NE(letters.err.find("warning[K4216]: `д` is no character of fanuc"), std::string::npos);
    EXPECT_EQ(letters.err.find("K4216"), letters.err.rfind("K4216"));
    EXPECT_EQ(kadr({"expand", file("letters.kadr"), "-d", "sinumerik"}).err, "");
}

TEST_F(CommandLine, OffsetsOfTheCoreAreThoseOfTheTarget) {
    save("core.kadr",
         "program p() { T3 M6; G43 H3; S1 M3; G0 X0 Z5; G49; G0 Z9; T4 M6; D1; Z8; D0; M30; }\n");
    const std::string edges = kadr({"expand", file("core.kadr"), "-d", "sinumerik"}).out;
    EXPECT_NE(edges.find("M6\nN30 D1\n"), std::string::npos) << edges;
    EXPECT_NE(edges.find("N60 D0\n"), std::string::npos) << edges;
    const std::string offsets = kadr({"expand", file("core.kadr"), "-d", "fanuc"}).out;
    // A length waits for the move of its axis; the last one has none.
    EXPECT_NE(
        offsets.find("G49 Z9.\nN2 T04 M06\nG00 G17 G21 G40 G54 G80 G90 G94\nG43 H04 Z8.\nM30\n"),
        std::string::npos)
        << offsets;
    save("with.kadr", "program p() { T3 M6; with G43 H3 { G0 Z5; } Z9; M30; }\n");
    const std::string inside = kadr({"expand", file("with.kadr"), "-d", "sinumerik"}).out;
    EXPECT_NE(inside.find("N30 D1\nN40 G0 Z5\nN50 D0\nN60 Z9\n"), std::string::npos) << inside;
    save("other.kadr", "program p() { T3 M6; G43 H5; M30; }\n");
    EXPECT_NE(kadr({"expand", file("other.kadr"), "-d", "sinumerik"}).err.find("say `tool(n)`"),
              std::string::npos);
    save("edge.kadr", "program p() { T3 M6; D2; M30; }\n");
    EXPECT_NE(kadr({"expand", file("edge.kadr"), "-d", "fanuc"}).err.find("say `tool(n)`"),
              std::string::npos);
}

TEST_F(CommandLine, ADialectFileTellsAllItsMistakesAtOnce) {
    save("my.xml",
         "<dialect name=\"my\" extends=\"fanuk\" title=\"My\" suffix=\"nc\">\n"
         "<foo/>\n"
         "<number addresses=\"X\" decimals=\"three\"/>\n"
         "<group name=\"01\"><code text=\"G0\" command=\"rapit\"/></group>\n"
         "<cycle name=\"drill_peck\"><form>G83 Z{to}</form></cycle>\n"
         "<rule name=\"arc_tol\" value=\"1\"/>\n"
         "<rule/>\n"
         "</dialect>\n");
    const ProcessResult result = kadr({"dialect", "check", file("my.xml")});
    EXPECT_EQ(result.status, 1);
    for (const char* message :
         {"my.xml:1:29: error[K4001]", "my.xml:2:2: error[K9103]", "my.xml:3:33: error[K4006]",
          "my.xml:4:43: error[K4008]", "my.xml:5:32: error[K4011]", "my.xml:6:13: error[K5202]",
          "my.xml:7:2: error[K9105]"})
        EXPECT_NE(result.err.find(message), std::string::npos) << message << '\n' << result.err;
    EXPECT_EQ(result.out, "my: the examples are tried when these are mended\n");
}

TEST_F(CommandLine, TheDirectionOfTheLanguageIsHeld) {
    const std::string folder = KADR_ROOT "/tests/programs/";
    const ProcessResult tests = kadr({"test", folder + "language_bracket.kadr", "--runs", "5"});
    EXPECT_EQ(tests.status, 0) << tests.err;
    for (const char* dialect : {"sinumerik", "fanuc", "axioma"}) {
        for (const char* name : {"language_bracket", "language_pieces", "language_russian"}) {
            const ProcessResult result = kadr({"expand", folder + name + ".kadr", "-d", dialect});
            EXPECT_EQ(result.status, 0) << name << dialect << result.err;
        }
    }
}

TEST_F(CommandLine, TablesOfControlsAndMachines) {
    EXPECT_NE(kadr({"dialect", "list"}).out.find("iso"), std::string::npos);
    const std::string commands = kadr({"dialect", "explain", "iso"}).out;
    for (const char* row : {"\nspindle_cw  ", "\ndwell  ", "\nplane_xy  "})
        EXPECT_NE(commands.find(row), std::string::npos) << row << commands;
    EXPECT_EQ(kadr({"dialect", "check", "iso"}).status, 0);
    EXPECT_EQ(kadr({"dialect", "check", file("missing.xml")}).status, 2);
    EXPECT_NE(kadr({"dialect", "explain", "iso", "G1"}).out.find("line"), std::string::npos);
    EXPECT_EQ(kadr({"dialect", "explain", "iso", "G777"}).status, 1);  // K9012
    EXPECT_NE(kadr({"machine", "list"}).out.find("mill"), std::string::npos);
    EXPECT_EQ(kadr({"machine", "check", "mill"}).status, 0);
}

TEST_F(CommandLine, MessagesGoToStandardErrorOnly) {
    const ProcessResult result = kadr({"expand", file("wrong.kadr")});
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err.find('\033'), std::string::npos);  // no colour beside a terminal
}

TEST_F(CommandLine, TheHouseKeepsItsOwnLayout) {
    std::vector<std::string> arguments = {"fmt", "--check"};
    for (const char* folder : {"stdlib", "stdlib/cycles", "examples", "examples/languages"}) {
        for (const auto& entry : fs::directory_iterator(fs::path(KADR_ROOT) / folder)) {
            if (entry.path().extension() == ".kadr") arguments.push_back(entry.path().string());
        }
    }
    ASSERT_GT(arguments.size(), 25u);
    const auto checked = kadr(arguments);
    EXPECT_EQ(checked.status, 0) << checked.err;
}

TEST_F(CommandLine, FormatRewritesAFileOrOnlyLooks) {
    constexpr const char* kUgly = "program p(){G0 X1;\n  M30 ;}\n";
    constexpr const char* kLaidOut = "program p() {\n    G0 X1;\n    M30;\n}\n";
    save("ugly.kadr", kUgly);
    const auto checked = kadr({"fmt", "--check", file("ugly.kadr")});
    EXPECT_EQ(checked.status, 1);
    EXPECT_NE(checked.err.find("ugly.kadr:1:1: error[K9013]"), std::string::npos) << checked.err;
    EXPECT_EQ(read_file(file("ugly.kadr")), kUgly);

    const auto written = kadr({"fmt", file("ugly.kadr")});
    EXPECT_EQ(written.status, 0) << written.err;
    EXPECT_EQ(read_file(file("ugly.kadr")), kLaidOut);
    EXPECT_EQ(kadr({"fmt", "--check", file("ugly.kadr")}).status, 0);

    EXPECT_EQ(kadr({"fmt", "-"}, kUgly).out, kLaidOut);

    save("broken.kadr", "program p( { }\n");
    EXPECT_EQ(kadr({"fmt", file("broken.kadr")}).status, 1);
    EXPECT_EQ(read_file(file("broken.kadr")), "program p( { }\n");

    const auto iso = kadr({"fmt", file("flat.nc")});
    EXPECT_EQ(iso.status, 2);
    EXPECT_NE(iso.err.find("K9014"), std::string::npos) << iso.err;
}

}  // namespace

}  // namespace cli_test
