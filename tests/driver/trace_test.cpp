// A debugger's eyes: the trace, break points, and that looking on changes nothing.
#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "driver/debug/break_points.h"
#include "driver/run.h"
#include "driver/session.h"
#include "tests/common/inputs.h"
#include "tests/common/process.h"

namespace kadr::trace_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kSinumerik =
    "DEF INT COUNT=3\n"
    "N10 G90 G54 G17\n"
    "; nothing is done here\n"
    "R1=5 R2=R1*2\n"
    "N20 G0 X=R1 Y0 Z10 S1000 M3\n"
    "AGAIN:\n"
    "N30 G1 X=IC(2) F200\n"
    "R1=R1+1 R2=R2\n"
    "IF R1<7 GOTOB AGAIN\n"
    "N40 M30\n";
constexpr const char* kFanuc =
    "%\nO0001\nN10 G90 G54 G00 X0. Y0. T1\n#1=[2.+3.]\n#1=#0\nN20 G43 H3 Z5.\n"
    "IF[#1EQ#0]GOTO50\nN40 X99.\nN50 M30\n%\n";
constexpr const char* kKadr =
    "void row(int n, length y) {\n"
    "    for (int i = 0; i < n; i++) {\n"
    "        G1 X=10*i Y=y;\n"
    "    }\n"
    "}\n"
    "program part() {\n"
    "    S1000 M3; F200;\n"
    "    G0 X0 Y0 Z5;\n"
    "    for (int k = 0; k < 2; k++) {\n"
    "        row(3, 5mm*k + 1mm);\n"
    "    }\n"
    "}\n";

class TraceTest : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("kadr-trace-" + std::to_string(::getpid()));
        fs::create_directories(folder_);
        save("a.mpf", kSinumerik);
        save("a.nc", kFanuc);
        save("a.kadr", kKadr);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string file(const std::string& name) const { return (folder_ / name).string(); }
    void save(const std::string& name, const std::string& text) const {
        ASSERT_TRUE(write_file_whole(file(name), text));
    }
    static ProcessResult kadr(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), KADR_BINARY);
        return run_process(arguments, "");
    }
    /// The objects of a trace.
    std::vector<json> traced(std::vector<std::string> arguments, int status = 0) const {
        arguments.insert(arguments.begin(), "run");
        arguments.insert(arguments.end(), {"--trace", file("t.jsonl")});
        const ProcessResult result = kadr(arguments);
        EXPECT_EQ(result.status, status) << result.err;
        std::istringstream in(read_file(file("t.jsonl")).value_or(""));
        std::vector<json> steps;
        for (std::string line; std::getline(in, line);) steps.push_back(json::parse(line));
        return steps;
    }

    fs::path folder_;
};

TEST_F(TraceTest, EveryBlockSaysWhatItChanged) {
    const std::vector<json> steps = traced({file("a.mpf")});
    // Begin, DEF, N10, R1, N20, twice N30 R1 IF, N40; neither the comment nor the label.
    ASSERT_EQ(steps.size(), 12u);
    for (const json& step : steps) {
        for (const char* key : {"block", "file", "line", "text", "variables", "codes", "modal",
                                "position", "machine"})
            EXPECT_TRUE(step.contains(key)) << key << ' ' << step;
    }
    EXPECT_EQ(steps[0]["codes"]["6"], json::parse(R"([null,"G17"])"));
    EXPECT_EQ(steps[1]["variables"], json::parse(R"({"COUNT":[null,3]})"));
    EXPECT_EQ(steps[2]["number"], 10);
    EXPECT_EQ(steps[2]["codes"], json::parse(R"({"8":["G500","G54"]})"));
    EXPECT_EQ(steps[2]["modal"], json::parse(R"({"work_offset":[0,1]})"));
    // An R parameter that was never set is 0; both of a line, in their order.
    EXPECT_EQ(steps[3]["variables"], json::parse(R"({"R1":[0,5],"R2":[0,10]})"));
    EXPECT_EQ(steps[3]["line"], 4);
    EXPECT_FALSE(steps[3].contains("number"));
    EXPECT_EQ(steps[4]["modal"], json::parse(R"({"speed":[0,1000],"spindle":["stop","cw"]})"));
    EXPECT_EQ(steps[4]["position"], json::parse(R"({"X":5,"Y":0,"Z":10})"));
    EXPECT_EQ(steps[5]["codes"], json::parse(R"({"1":["G0","G1"]})"));
    EXPECT_EQ(steps[5]["modal"], json::parse(R"({"feed":[null,200]})"));
    EXPECT_EQ(steps[5]["position"]["X"], 7);
    // What has its value again was not changed.
    EXPECT_EQ(steps[6]["variables"], json::parse(R"({"R1":[5,6]})"));
    EXPECT_EQ(steps[7]["text"], "IF R1<7 GOTOB AGAIN");
    EXPECT_EQ(steps[8]["line"], 7);
    EXPECT_EQ(steps[8]["codes"], json::object());
    EXPECT_EQ(steps[8]["position"]["X"], 9);
    EXPECT_EQ(steps[11]["block"], 11);
}

/// What a call hands over stands beside the call, and what comes back beside the return.
TEST_F(TraceTest, CallsShowWhatTheyHandOver) {
    save("args.nc", "%\nO0001\n#1=7\nG65P2A1.5X[#1+1]\nM30\nO0002\n#2=#24\nM99\n%\n");
    std::vector<json> steps = traced({file("args.nc"), "-d", "fanuc"});
    ASSERT_EQ(steps.size(), 6u);
    EXPECT_EQ(steps[2]["variables"], json::parse(R"({"#1":[null,1.5],"#24":[null,8]})"));
    EXPECT_EQ(steps[3]["variables"], json::parse(R"({"#2":[null,8]})"));
    EXPECT_EQ(steps[4]["text"], "M99");
    save("var.mpf",
         "DEF REAL SUM=3, KEPT=1\nADD(SUM,KEPT,4)\nM30\n%_N_ADD_SPF\n"
         "PROC ADD(VAR REAL TOTAL, VAR REAL SAME, REAL MORE)\nTOTAL=TOTAL+MORE\nRET\n");
    steps = traced({file("var.mpf")});
    ASSERT_EQ(steps.size(), 7u);
    EXPECT_EQ(steps[2]["variables"],
              json::parse(R"({"TOTAL":[null,3],"SAME":[null,1],"MORE":[null,4]})"));
    EXPECT_EQ(steps[4]["variables"], json::parse(R"({"TOTAL":[3,7]})"));
    EXPECT_EQ(steps[5]["text"], "RET");
    EXPECT_EQ(steps[5]["variables"], json::parse(R"({"SUM":[3,7]})"));
    const ProcessResult table = kadr({"run", file("var.mpf"), "--trace", "-"});
    EXPECT_NE(table.out.find("  in ADD"), std::string::npos) << table.out;
    EXPECT_NE(table.out.find("  back in the main program"), std::string::npos) << table.out;
}

/// Rows of programs that were called say which they are, wherever they stand.
TEST_F(TraceTest, CalledProgramsAreNamed) {
    save("calls.mpf", "R1=1\nINNER\nOUTER\nR1=4\nM30\n%_N_INNER_SPF\nR1=2\nRET\n");
    save("OUTER.SPF", "R1=3\nG0 X1\nINNER\nRET\n");
    const std::vector<json> steps = traced({file("calls.mpf")});
    const auto find = [&](const std::string& name, int line) {
        std::vector<json> found;
        for (const json& step : steps)
            if (step["file"].get<std::string>().ends_with(name) && step["line"] == line)
                found.push_back(step);
        return found;
    };
    const auto main = find("calls.mpf", 1);
    ASSERT_EQ(main.size(), 1u);
    EXPECT_FALSE(main[0].contains("program"));
    EXPECT_FALSE(main[0].contains("level"));
    const auto inner = find("calls.mpf", 7);
    ASSERT_EQ(inner.size(), 2u);
    EXPECT_EQ(inner[0]["program"], "INNER");
    EXPECT_EQ(inner[0]["level"], 1);
    EXPECT_EQ(inner[1]["level"], 2);
    const auto outer = find("OUTER.SPF", 2);
    ASSERT_EQ(outer.size(), 1u);
    EXPECT_EQ(outer[0]["program"], "OUTER");
    EXPECT_EQ(outer[0]["position"]["X"], 1);
    const ProcessResult table = kadr({"run", file("calls.mpf"), "--trace", "-"});
    EXPECT_NE(table.out.find("OUTER.SPF:2"), std::string::npos) << table.out;
    EXPECT_NE(table.out.find("    G0 X1"), std::string::npos) << table.out;
    for (const char* place : {"INNER", "OUTER", "OUTER.SPF:2"}) {
        const ProcessResult stopped = kadr({"run", file("calls.mpf"), "--break", place});
        EXPECT_NE(stopped.err.find("stopped before"), std::string::npos) << place << stopped.err;
    }
}

TEST_F(TraceTest, VacantIsNull) {
    const std::vector<json> steps = traced({file("a.nc"), "-d", "fanuc"});
    std::vector<std::string> numbers;
    std::string lengths;
    json variables = json::array();
    for (const json& step : steps) {
        if (step.contains("number")) numbers.push_back("N" + step["number"].dump());
        if (!step["variables"].empty()) variables.push_back(step["variables"]);
        if (step["modal"].contains("length_offset") && step["block"] != 0)
            lengths += step["modal"]["length_offset"].dump();
    }
    EXPECT_EQ(numbers, (std::vector<std::string>{"N10", "N20", "N50"}));
    EXPECT_EQ(variables, json::parse(R"([{"#1":[null,5]},{"#1":[5,null]}])"));
    EXPECT_EQ(lengths, "[0,3]");
}

TEST_F(TraceTest, PositionsAreThoseOfTheScreen) {
    // The machine's own position counts from its zero: work offset and tool length are in it.
    save("offset.mpf", "$P_UIFR[1,X,TR]=100\nN10 G54 G0 X1 Y2\nN20 M30\n");
    const std::vector<json> steps = traced({file("offset.mpf")});
    EXPECT_EQ(steps[2]["position"]["X"], 1);
    EXPECT_EQ(steps[2]["machine"]["X"], 101);
    // On a lathe X is a diameter where the program's is.
    save("lathe.mpf", "N10 G18 DIAMON G0 X40 Z2\nN20 M30\n");
    const std::vector<json> turned = traced({file("lathe.mpf"), "-m", "lathe"});
    EXPECT_EQ(turned[1]["position"]["X"], 40);
    EXPECT_EQ(turned[1]["machine"]["X"], 20);
}

TEST_F(TraceTest, BlocksOfAKadrProgramNameStatementAndCalls) {
    const std::vector<json> steps = traced({file("a.kadr"), "-d", "sinumerik"});
    std::size_t in_rows = 0;
    for (const json& step : steps) {
        if (!step.contains("calls") || step["calls"].empty()) continue;
        ++in_rows;
        EXPECT_EQ(step["src"], file("a.kadr") + ":3");
        EXPECT_EQ(step["calls"][0]["function"], "row");
        EXPECT_EQ(step["calls"][0]["line"], 10);
        EXPECT_EQ(step["file"], "a.mpf");
    }
    EXPECT_EQ(in_rows, 6u);
    const ProcessResult table = kadr({"run", file("a.kadr"), "-d", "sinumerik", "--trace", "-"});
    EXPECT_NE(table.out.find("a.kadr:3 < row " + file("a.kadr") + ":10"), std::string::npos)
        << table.out;
}

TEST_F(TraceTest, AnAlarmIsTheLastLine) {
    save("alarm.mpf", "N10 G0 X1\nR1=1/0\nN30 M30\n");
    const std::vector<json> steps = traced({file("alarm.mpf")}, 3);
    ASSERT_GE(steps.size(), 3u);
    EXPECT_EQ(steps[1]["number"], 10);
    EXPECT_NE(steps.back()["alarm"].get<std::string>().find("alarm.mpf:2:"), std::string::npos);
    const ProcessResult table = kadr({"run", file("alarm.mpf"), "--trace", "-"});
    EXPECT_NE(table.out.find("\n# not complete, ended by "), std::string::npos) << table.out;
}

TEST_F(TraceTest, AnAlarmOfTheMotionComesBeforeTheNextBlock) {
    // The axis stops at its limit: nothing behind this block was executed for the eye either.
    std::string text = "N10 G0 X1\nN20 G1 X2 F100\nN30 X1000000\n";
    for (int i = 0; i < 50; ++i) text += "N" + std::to_string(100 + i) + " X3\n";
    save("limit.mpf", text + "M30\n");
    const std::vector<json> steps = traced({file("limit.mpf")}, 3);
    EXPECT_TRUE(steps.back().contains("alarm"));
    EXPECT_LE(steps.size(), 5u);
}

TEST_F(TraceTest, TheTableHasAColumnForEverything) {
    const ProcessResult result = kadr({"run", file("a.mpf"), "--trace", "-"});
    EXPECT_EQ(result.status, 0) << result.err;
    std::istringstream in(result.out);
    std::vector<std::string> rows;
    for (std::string row; std::getline(in, row);) rows.push_back(row);
    ASSERT_EQ(rows.size(), 13u);
    const std::size_t text = rows[0].find("text");
    const std::size_t changes = rows[0].find("changes");
    EXPECT_EQ(rows[4].find("R1=5 R2=R1*2"), text);
    EXPECT_EQ(rows[4].find("R1 0 → 5, R2 0 → 10"), changes);
    EXPECT_EQ(rows[6].find("G0 → G1, F - → 200"), changes);
    EXPECT_EQ(rows[6].find("7.000") + 5, rows[0].find('X') + 1);
}

/// Programs with jumps, cycles and compensation give the same commands whether somebody looks on;
/// who looks on sees each call of a cycle by itself.
TEST_F(TraceTest, LookingOnChangesNothing) {
    std::vector<std::vector<std::string>> programs = {{file("a.mpf")},
                                                      {file("a.nc"), "-d", "fanuc"}};
    for (const char* name : {"bracket", "ellipse", "housing", "lid"}) {
        for (const char* dialect : {"sinumerik", "fanuc"})
            programs.push_back(
                {std::string(KADR_ROOT "/examples/") + name + ".kadr", "-d", dialect});
    }
    for (std::vector<std::string> run : programs) {
        SCOPED_TRACE(run[0]);
        run.insert(run.begin(), "run");
        run.insert(run.end(), {"--cycles", "calls"});
        run.insert(run.end(), {"--commands", "-"});
        const ProcessResult alone = kadr(run);
        EXPECT_EQ(alone.status, 0) << alone.err;
        run.insert(run.end(), {"--trace", "/dev/null", "--break", "nowhere"});
        const ProcessResult watched = kadr(run);
        EXPECT_TRUE(alone.out == watched.out);
        EXPECT_NE(watched.err.find("K9017"), std::string::npos) << watched.err;
    }
}

TEST_F(TraceTest, StopsInFrontOfAPlace) {
    struct Row {
        const char* name;
        const char* program;
        const char* place;
        const char* shown;  // of what is said
    };
    for (const Row& row :
         {Row{"block number", "a.mpf", "N30", "   7 | N30 G1 X=IC(2) F200\n     | ^\n"},
          Row{"its digits", "a.mpf", "30", "   7 | N30"},
          Row{"line", "a.mpf", ":8", "a.mpf:8: stopped before `:8`\n"},
          Row{"label", "a.mpf", "again", "   6 | AGAIN:"},
          Row{"line of the text", "a.kadr", "a.mpf:5", "   5 | "},
          Row{"line of the source", "a.kadr", ":8", "G0 X0 Y0 Z5\n"},
          Row{"line of a call", "a.kadr", "a.kadr:10", "in row, called at "},
          Row{"function", "a.kadr", "row", "in row, called at "}}) {
        SCOPED_TRACE(row.name);
        const ProcessResult result =
            kadr({"run", file(row.program), "-d", "sinumerik", "--break", row.place});
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.out, "");
        EXPECT_NE(result.err.find(row.shown), std::string::npos) << result.err;
        EXPECT_NE(result.err.find("position "), std::string::npos) << result.err;
        EXPECT_NE(result.err.find("codes "), std::string::npos) << result.err;
    }
    const ProcessResult shown = kadr({"run", file("a.mpf"), "--break", ":8"});
    EXPECT_NE(shown.err.find("X7.000 Y0.000 Z10.000"), std::string::npos) << shown.err;
    EXPECT_NE(shown.err.find("feed           200\n"), std::string::npos) << shown.err;
    EXPECT_NE(shown.err.find("R2 = 10\n"), std::string::npos) << shown.err;
}

/// A name may mean another variable in each level of calls: shown are those of the one that runs.
TEST_F(TraceTest, VariablesAreThoseOfTheLevel) {
    save("macro.nc",
         "%\nO0001\n#1=3\n#100=7\nG65 P200 A5. B6.\n#3=1\nM30\nO0200\n#4=8\nM98 P5\nM99\n"
         "O0005\nG04 P1\nM99\n%\n");
    save("proc.mpf",
         "DEF REAL SIZE=1\nDEF INT TURNS=2\nRECT(10,TURNS)\nM30\n%_N_RECT_SPF\n"
         "PROC RECT(REAL LL, VAR INT BB)\nDEF STRING[9] TEXT=\"in\"\nBB=4\nG4 F1\nRET\n");
    struct Row {
        const char* program;
        const char* dialect;
        const char* place;
        const char* variables;  // as JSON
    };
    for (const Row& row : {Row{"macro.nc", "fanuc", ":5", R"({"#1":3,"#100":7})"},
                           Row{"macro.nc", "fanuc", ":9", R"({"#1":5,"#2":6,"#100":7})"},
                           // A subprogram has the variables of its caller.
                           Row{"macro.nc", "fanuc", "O5", R"({"#1":5,"#2":6,"#4":8,"#100":7})"},
                           Row{"macro.nc", "fanuc", ":6", R"({"#1":3,"#100":7})"},
                           Row{"macro.nc", "fanuc", ":7", R"({"#1":3,"#3":1,"#100":7})"},
                           Row{"proc.mpf", "sinumerik", ":9", R"({"LL":10,"BB":4,"TEXT":"in"})"},
                           Row{"proc.mpf", "sinumerik", ":4", R"({"SIZE":1,"TURNS":4})"}}) {
        SCOPED_TRACE(std::string(row.program) + ' ' + row.place);
        const json expected = json::parse(row.variables);
        const ProcessResult stop = kadr({"run", file(row.program), "-d", row.dialect, "--break",
                                         row.place, "--diagnostics", "json"});
        const std::size_t begin = stop.err.find("{\"stopped\"");
        ASSERT_NE(begin, std::string::npos) << stop.err;
        EXPECT_EQ(json::parse(stop.err.substr(begin))["variables"], expected);
        const ProcessResult until = kadr({"run", file(row.program), "-d", row.dialect, "--until",
                                          row.place, "--variables", file("level.json")});
        EXPECT_EQ(until.status, 0) << until.err;
        EXPECT_EQ(json::parse(read_file(file("level.json")).value()), expected);
    }
}

/// Variables that were declared have their names when a loop counts them, too.
TEST_F(TraceTest, CountersHaveTheirNames) {
    save("for.mpf", "DEF INT COUNT\nDEF INT LIST[2]\nFOR COUNT=0 TO 1\nG4 F1\nENDFOR\nM30\n");
    std::vector<std::string> changes;
    for (const json& step : traced({file("for.mpf"), "-d", "sinumerik"})) {
        if (step["text"] == "FOR COUNT=0 TO 1" || step["text"] == "ENDFOR")
            changes.push_back(step["variables"].dump());
    }
    ASSERT_EQ(changes.size(), 3u);
    EXPECT_EQ(changes[0], "{}");  // declared with 0
    EXPECT_EQ(changes[1], R"({"COUNT":[0,1]})");
    EXPECT_EQ(changes[2], R"({"COUNT":[1,2]})");
}

/// What a program writes into the control is shown as the program names it.
TEST_F(TraceTest, WrittenStateIsShown) {
    save("state.mpf",
         "DEF INT CNT\nDEF REAL LIST[3]\nR1=2\n$TC_DP6[1,R1]=5\n$P_UIFR[1]=CTRANS(X,10)\n"
         "$P_UIFR[1,X,TR]=20\n$P_PFRAME=CTRANS(Y,3)\nCNT=0\nLIST[1]=2\nM30\n");
    save("state.nc",
         "%\nO0001\n#5221=5.\n#2001=3.\nG10 L2 P1 Y9.\nG10 L10 P1 R4.\nSETVN 510[ABC]\n"
         "#100=0\nWHILE[#100LT2]DO1\n[#ABC]=#100\n#100=#100+1\nEND1\nM30\n%\n");
    struct Row {
        const char* file;
        const char* dialect;
        const char* text;
        const char* variables;
    };
    for (const Row& row :
         {Row{"state.mpf", "sinumerik", "DEF INT CNT", R"json({"CNT":[null,0]})json"},
          Row{"state.mpf", "sinumerik", "DEF REAL LIST[3]", "{}"},
          Row{"state.mpf", "sinumerik", "$TC_DP6[1,R1]=5", R"json({"$TC_DP6[1,2]":[0,5]})json"},
          Row{"state.mpf", "sinumerik", "$P_UIFR[1]=CTRANS(X,10)",
              R"json({"$P_UIFR[1]":["CTRANS()","CTRANS(X,10)"]})json"},
          Row{"state.mpf", "sinumerik", "$P_UIFR[1,X,TR]=20",
              R"json({"$P_UIFR[1,X,TR]":[10,20]})json"},
          Row{"state.mpf", "sinumerik", "$P_PFRAME=CTRANS(Y,3)",
              R"json({"$P_PFRAME":["CTRANS()","CTRANS(Y,3)"]})json"},
          Row{"state.mpf", "sinumerik", "CNT=0", "{}"},
          Row{"state.mpf", "sinumerik", "LIST[1]=2", R"json({"LIST[1]":[0,2]})json"},
          Row{"state.nc", "fanuc", "#5221=5.", R"json({"#5221":[0,5]})json"},
          Row{"state.nc", "fanuc", "#2001=3.", R"json({"#2001":[0,3]})json"},
          Row{"state.nc", "fanuc", "G10 L2 P1 Y9.", R"json({"#2601":[0,9]})json"},
          Row{"state.nc", "fanuc", "G10 L10 P1 R4.", R"json({"#2201":[0,4]})json"},
          Row{"state.nc", "fanuc", "[#ABC]=#100", R"json({"#510":[0,1]})json"}}) {
        SCOPED_TRACE(row.text);
        std::string found = "no such row";
        for (const json& step : traced({file(row.file), "-d", row.dialect})) {
            if (step["text"] == row.text) found = step["variables"].dump();
        }
        EXPECT_EQ(found, row.variables);
    }
}

/// Under compensation the end of a block is known with the next one: the machine stands where the
/// blocks before have sent it. Tool R5, left: (20,0) to (20,30) is (15,0) to (15,30).
TEST_F(TraceTest, MachineStandsBesideTheContour) {
    save("comp.mpf",
         "$TC_DP6[1,1]=5\nT1 M6\nD0\nD1\nG0 X0 Y0 Z0\nS100 M3\nG41 G1 X20 F100\nY30\nY40\n"
         "G40 X0\nM30\n");
    std::vector<std::string> machine;
    std::vector<std::string> edges;
    for (const json& step : traced({file("comp.mpf"), "-d", "sinumerik"})) {
        const json& at = step["machine"];
        machine.push_back(at["X"].dump() + " " + at["Y"].dump());
        if (step["modal"].contains("edge")) edges.push_back(step["modal"]["edge"].dump());
    }
    ASSERT_EQ(machine.size(), 12u);
    EXPECT_EQ(machine[7], "0 0");
    EXPECT_EQ(machine[8], "15 0");
    EXPECT_EQ(machine[9], "15 30");
    EXPECT_EQ(machine[11], "0 40");
    EXPECT_EQ(edges, (std::vector<std::string>{"[null,0]", "[0,1]", "[1,0]", "[0,1]"}));
}

/// A cycle's warnings stand where the program calls it; the library's place is a note.
TEST_F(TraceTest, WarningsOfCyclesNameTheProgram) {
    save(
        "warns.mpf",
        "T1 D1 M6\nS100 M3 F100\nG0 X0 Y0 Z20\nCYCLE81(20,0,2,-5,6)\nHOLES1(0,0,0,10,10,2)\nM30\n");
    const ProcessResult result = kadr({"run", file("warns.mpf"), "-d", "sinumerik"});
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.err.find("warns.mpf:4:1: warning[K3304]"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("warns.mpf:5:1: warning[K3304]"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("note: inside the cycle `hole_drill`"), std::string::npos)
        << result.err;
}

/// Subprograms with numbers, as their head writes them and by the number alone.
TEST_F(TraceTest, SubprogramsAreFoundByTheirNumbers) {
    save("calls.nc",
         "%\nO0001\nN5 G0 X1.\nM98 P9010\nM98 P12\nM30\nO9010\nG0 X2.\nM99\n"
         "O0012\nG0 X3.\nM99\n%\n");
    struct Row {
        const char* place;
        const char* shown;
    };
    for (const Row& row :
         {Row{"O9010", "   7 | O9010"}, Row{"9010", "   7 | O9010"}, Row{"o12", "  10 | O0012"},
          Row{"O0012", "  10 | O0012"}, Row{"N9010", "warning[K9017]"}, Row{"O5", "warning[K9017]"},
          Row{"5", "   3 | N5 G0 X1."}}) {
        SCOPED_TRACE(row.place);
        const ProcessResult result =
            kadr({"run", file("calls.nc"), "-d", "fanuc", "--break", row.place});
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_NE(result.err.find(row.shown), std::string::npos) << result.err;
    }
}

TEST_F(TraceTest, ProgramsSeeTheStopAsAnObject) {
    const ProcessResult result =
        kadr({"run", file("a.mpf"), "--break", "N30", "--diagnostics", "json"});
    const json stop = json::parse(result.err);
    EXPECT_EQ(stop["line"], 7);
    EXPECT_EQ(stop["variables"]["R1"], 5);
    EXPECT_EQ(stop["codes"]["1"], "G0");
    EXPECT_EQ(stop["modal"]["speed"], 1000);
    EXPECT_EQ(stop["modal"]["feed"], nullptr);
    EXPECT_EQ(stop["position"]["X"], 5);
}

TEST_F(TraceTest, UntilEndsTheProgramThere) {
    const ProcessResult result =
        kadr({"run", file("a.mpf"), "--until", "N40", "--until", ":9", "--summary", "json",
              "--variables", file("v.json"), "--commands", file("c.jsonl")});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(result.err.ends_with("warning[K9017]: the run never came to `N40`\n"))
        << result.err;
    EXPECT_EQ(result.err.find("K9017"), result.err.rfind("K9017")) << result.err;
    EXPECT_EQ(json::parse(result.out)["blocks"], 3);
    EXPECT_EQ(json::parse(result.out)["alarms"], 0);
    EXPECT_EQ(json::parse(read_file(file("v.json")).value())["R1"], 6);
    const std::string commands = read_file(file("c.jsonl")).value();
    EXPECT_EQ(commands.find("\"end\""), std::string::npos) << commands;
    // Without another output the summary is for a person.
    const ProcessResult summary = kadr({"run", file("a.mpf"), "--until", "N40"});
    EXPECT_NE(summary.out.find("4 executed"), std::string::npos) << summary.out;
}

TEST_F(TraceTest, WhatWaitsForABlockBehindThePlaceIsNotMissing) {
    const struct {
        const char* waits;
        const char* to;  // where the tool is, as far as the run knows
    } rows[] = {
        {"N20 G1 X10 F100 S100 M3 RND=2", "\"to\":{\"X\":10,\"Y\":0,\"Z\":0}"},
        {"N20 G1 ANG=30 F100 S100 M3", "\"to\":{\"X\":0,\"Y\":0,\"Z\":0}"},
        {"N20 G147 G41 DISR=5 X20 Y20 F100 S100 M3 D1", "\"to\":{\"X\":0,\"Y\":0,\"Z\":0}"},
        {"N20 G41 X10 Y0 D1 F100 S100 M3", "\"to\":{\"X\":10,\"Y\":0,\"Z\":0}"},
    };
    for (const auto& row : rows) {
        SCOPED_TRACE(row.waits);
        write_file_whole(file("wait.mpf"), std::string("T1 D1 M6\nN10 G0 X0 Y0\nG1\n") + row.waits +
                                               "\nN30 Y30\nG40 X0\nN40 M30\n");
        const ProcessResult result = kadr({"run", file("wait.mpf"), "-d", "sinumerik", "--until",
                                           "N30", "--commands", file("c.jsonl")});
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.err.find("alarm"), std::string::npos) << result.err;
        const std::string commands = read_file(file("c.jsonl")).value();
        EXPECT_NE(commands.find(row.to), std::string::npos) << commands;
    }
}

TEST_F(TraceTest, PlacesThatAreNoneAreRefused) {
    for (const char* place : {":0", ":x", "a b", "part.mpf:"}) {
        SCOPED_TRACE(place);
        const ProcessResult result = kadr({"run", file("a.mpf"), "--until", place});
        EXPECT_EQ(result.status, 2);
        EXPECT_NE(result.err.find("K9016"), std::string::npos) << result.err;
    }
    const ProcessResult nowhere = kadr({"run", file("a.mpf"), "--until", ""});
    EXPECT_EQ(nowhere.status, 2);
    EXPECT_NE(nowhere.err.find("--until: the value is empty"), std::string::npos) << nowhere.err;
}

/// What is said when the answers at the stops are these.
std::string conversation(const std::string& program, const std::vector<std::string>& places,
                         std::vector<std::string> answers) {
    std::string words;
    Sources sources = test::inputs().new_sources();
    driver::Messages messages(sources, {}, [&words](std::string_view text) { words += text; });
    driver::Options options;
    options.dialect = "sinumerik";
    driver::Session session(options, test::inputs(), sources, messages);
    driver::RunJob job;
    job.source = program;
    job.breaks = places;
    job.onlooker.say = [&words](std::string_view text) { words += text; };
    std::size_t next = 0;
    job.onlooker.ask = [&]() -> std::optional<std::string> {
        if (next == answers.size()) return std::nullopt;
        words += "> " + answers[next] + '\n';
        return answers[next++];
    };
    EXPECT_EQ(driver::run(session, job), driver::Status::Done);
    return words;
}

TEST_F(TraceTest, AConversationAtABreakPoint) {
    const std::string name = file("a.mpf");
    EXPECT_EQ(conversation(name, {"N30"},
                           {":step", "", ":vars R2", ":break N40", ":b", ":continue", ":c", ":q"}),
              name +
                  ":7: stopped before `N30`\n   7 | N30 G1 X=IC(2) F200\n     | ^\n"
                  "position  X5.000 Y0.000 Z10.000\nmachine   X5.000 Y0.000 Z10.000\n"
                  "> :step\n" +
                  name +
                  ":7:5: warning[K5265]: the first cut comes before any tool is in the spindle\n"
                  "   7 | N30 G1 X=IC(2) F200\n     |     ^~\n" +
                  name +
                  ":8: stopped\n   8 | R1=R1+1 R2=R2\n     | ^\n"
                  "position  X7.000 Y0.000 Z10.000\nmachine   X7.000 Y0.000 Z10.000\n"
                  "> \n" +
                  name +
                  ":9: stopped\n   9 | IF R1<7 GOTOB AGAIN\n     | ^\n"
                  "position  X7.000 Y0.000 Z10.000\nmachine   X7.000 Y0.000 Z10.000\n"
                  "> :vars R2\nR2 = 10\n"
                  "> :break N40\n"
                  "> :b\n"
                  "a location is missing: `:break N120`, `:break :34`, `:break NAME`\n"
                  "> :continue\n" +
                  name +
                  ":7: stopped before `N30`\n   7 | N30 G1 X=IC(2) F200\n     | ^\n"
                  "position  X7.000 Y0.000 Z10.000\nmachine   X7.000 Y0.000 Z10.000\n"
                  "> :c\n" +
                  name +
                  ":10: stopped before `N40`\n  10 | N40 M30\n     | ^\n"
                  "position  X9.000 Y0.000 Z10.000\nmachine   X9.000 Y0.000 Z10.000\n"
                  "> :q\n");
    const std::string state = conversation(name, {"N40"}, {":state", ":calls", ":nonsense"});
    EXPECT_NE(state.find("codes     M3 M9 G1 G17"), std::string::npos) << state;
    EXPECT_NE(state.find(":continue   on to the next break point"), std::string::npos) << state;
}

TEST_F(TraceTest, AFunctionIsEnteredOnceACall) {
    // Twice by the loop; three blocks each.
    const std::string text =
        conversation(file("a.kadr"), {"row"}, {":c", ":calls", ":c", ":c", ":c"});
    std::size_t stops = 0;
    for (std::size_t at = text.find("stopped before"); at != std::string::npos;
         at = text.find("stopped before", at + 1))
        ++stops;
    EXPECT_EQ(stops, 2u) << text;
    EXPECT_NE(text.find("in row, called at " + file("a.kadr") + ":10"), std::string::npos) << text;
}

TEST(BreakPoints, Places) {
    using driver::BreakPoint;
    driver::StopArrival at;
    at.number = 120;
    at.has_number = true;
    at.label = "Again";
    at.program = "L100";
    at.program_head = "L100";
    at.text = {"parts/a.mpf", 12, 12};
    at.statement = {"parts/a.kadr", 30, 34};
    at.started = "parts/a.kadr";
    struct Row {
        const char* text;
        bool is_there;
    };
    for (const Row& row :
         {Row{"N120", true}, Row{"n120", true}, Row{"120", true}, Row{"N12", false},
          Row{"N0120", true}, Row{"again", true}, Row{"L100", true}, Row{"L10", false},
          Row{":30", true}, Row{":34", true}, Row{":35", false}, Row{":12", false},
          Row{"a.mpf:12", true}, Row{"parts/a.mpf:12", true}, Row{".mpf:12", false},
          Row{"b.mpf:12", false}, Row{"a.kadr:31", true}}) {
        SCOPED_TRACE(row.text);
        const auto point = BreakPoint::parse(row.text);
        ASSERT_TRUE(point);
        EXPECT_EQ(point->is_at(at), row.is_there);
    }
}

}  // namespace
}  // namespace kadr::trace_test
