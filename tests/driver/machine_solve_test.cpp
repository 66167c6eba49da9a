// `kadr machine solve`, and the stock machines with rotary axes under programs without them.
#include <cmath>

#include <nlohmann/json.hpp>

#include "tests/driver/scratch.h"

namespace machine_solve_test {

namespace {

using nlohmann::json;

class MachineSolve : public kadr::test::ScratchFolder {
  protected:
    static ProcessResult solve(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"machine", "solve"});
        return kadr(arguments);
    }
    static json answer(std::vector<std::string> arguments) {
        arguments.emplace_back("--json");
        const ProcessResult result = solve(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        return json::parse(result.out);
    }
};

// The trunnion's axis lies 50 mm below the face: a spot on the face, turned by A = 30 about it,
// goes by 50 sin 30 = 25 along Y and to 50 cos 30 − 50 = −6.699; the nose stands the tool's 100 mm
// above it.
TEST_F(MachineSolve, WorkedExampleOfTheManual) {
    const std::vector<std::string> words = {
        "trunnion-ac", "--at", "X0,Y0,Z0", "--tool", "0,-0.5,0.866025403784", "--length", "100"};
    const json found = answer(words);
    ASSERT_EQ(found["solutions"].size(), 2u);
    const json& first = found["solutions"][0];
    EXPECT_EQ(first["configuration"], 1);
    EXPECT_NEAR(first["axes"]["X"].get<double>(), 0, 1e-8);
    EXPECT_NEAR(first["axes"]["Y"].get<double>(), 25, 1e-8);
    EXPECT_NEAR(first["axes"]["Z"].get<double>(), 100 + 50 * std::cos(std::acos(-1) / 6) - 50,
                1e-8);
    EXPECT_NEAR(first["axes"]["A"].get<double>(), 30, 1e-8);
    EXPECT_NEAR(first["axes"]["C"].get<double>(), 0, 1e-8);
    EXPECT_TRUE(first["outside"].empty());
    // The other one stands exactly on A's limit.
    EXPECT_NEAR(found["solutions"][1]["axes"]["A"].get<double>(), -30, 1e-8);
    EXPECT_EQ(found["choice"]["configuration"], 1);
    EXPECT_EQ(found["choice"]["axes"], first["axes"]);
    const ProcessResult text = solve(words);
    EXPECT_EQ(text.status, 0);
    EXPECT_NE(text.out.find("from C0 A0, by its axes: configuration 1, to C0 A30: the least sum of "
                            "squares, 900 deg2\n"),
              std::string::npos)
        << text.out;
}

TEST_F(MachineSolve, ThereAndBack) {
    const json forward = answer({"head-cb", "--axes", "X10 Y-20 Z300, C45 B30", "--length", "150"});
    const auto number = [](const json& value) { return value.dump(); };
    const json& tip = forward["tip"];
    const json& tool = forward["tool"];
    // w = (cos C sin B, sin C sin B, cos B)
    EXPECT_NEAR(tool[0].get<double>(), std::sqrt(0.5) * 0.5, 1e-9);
    EXPECT_NEAR(tool[2].get<double>(), std::sqrt(0.75), 1e-9);
    const json back = answer(
        {"head-cb", "--at", "X" + number(tip[0]) + ",Y" + number(tip[1]) + ",Z" + number(tip[2]),
         "--tool", number(tool[0]) + "," + number(tool[1]) + "," + number(tool[2]), "--length",
         "150", "--from", "C40"});
    const json& axes = back["choice"]["axes"];
    for (const auto& [name, value] :
         std::map<std::string, double>{{"X", 10}, {"Y", -20}, {"Z", 300}, {"B", 30}, {"C", 45}})
        EXPECT_NEAR(axes[name].get<double>(), value, 1e-6) << name;
}

TEST_F(MachineSolve, SaysWhatIsOutOfLimitsAndWhy) {
    // Beyond A = 120 both ways: 150 and −150.
    const ProcessResult result =
        solve({"trunnion-ac", "--at", "Z100", "--tool", "0,-0.5,-0.866025"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("out of limits: A149.99"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("no path; configuration 1: A149.99"), std::string::npos)
        << result.out;
    const json found = answer({"trunnion-ac", "--tool", "0,-0.5,-0.866025"});
    EXPECT_EQ(found["choice"]["refused"].size(), 2u);
}

TEST_F(MachineSolve, ThePoleIsFree) {
    const json found = answer({"head-cb", "--at", "Z100", "--tool", "0,0,1", "--from", "C70 B20"});
    ASSERT_EQ(found["solutions"].size(), 1u);
    EXPECT_TRUE(found["solutions"][0]["pole"].get<bool>());
    EXPECT_EQ(found["choice"]["axes"]["C"], 70);
}

TEST_F(MachineSolve, ThroughThePoleOnlyTheSecondAxisTurns) {
    const json found = answer({"head-cb", "--vector", "--tool", "-0.6,0,0.8", "--from", "B30"});
    EXPECT_TRUE(found["choice"]["pole_switch"].get<bool>());
    EXPECT_EQ(found["choice"]["mode"], "vector");
    EXPECT_NEAR(found["choice"]["axes"]["C"].get<double>(), 0, 1e-9);
    EXPECT_NEAR(found["choice"]["axes"]["B"].get<double>(), -36.869897646, 1e-8);
}

// All three angles of the tool: the tip of a tool without lateral offset does not notice the third.
TEST_F(MachineSolve, SixAxes) {
    const json found = answer({"six-axis", "--euler", "30,45,10"});
    const json& axes = found["solutions"][0]["axes"];
    EXPECT_NEAR(axes["C"].get<double>(), 30, 1e-9);
    EXPECT_NEAR(axes["B"].get<double>(), 45, 1e-9);
    EXPECT_NEAR(axes["A"].get<double>(), 10, 1e-9);
    // With a direction alone it stays where it is.
    const json direction = answer({"six-axis", "--tool", "0.6,0,0.8", "--from", "A33"});
    EXPECT_EQ(direction["choice"]["axes"]["A"], 33);
}

TEST_F(MachineSolve, FourAxesAndAParallelOne) {
    // The borer's table turns by −30 for B = 30: the tool comes from X.
    const json found =
        answer({"borer", "--at", "X500,Y300,Z-700", "--tool", "0.5,0,0.866025403784"});
    EXPECT_NEAR(found["choice"]["axes"]["B"].get<double>(), 30, 1e-6);
    // 100 in front of the table's axis, turned back by 30 about Y.
    EXPECT_NEAR(found["choice"]["axes"]["X"].get<double>(), 500 - 50, 1e-6);
    EXPECT_NEAR(found["choice"]["axes"]["Z"].get<double>(), -800 + 86.602540378, 1e-6);
    const ProcessResult leant = solve({"borer", "--tool", "0,0.5,0.866025"});
    EXPECT_EQ(leant.status, 1);
    EXPECT_NE(leant.err.find("K6279"), std::string::npos) << leant.err;
}

TEST_F(MachineSolve, WrongWords) {
    struct Case {
        std::vector<std::string> words;
        const char* said;
        int status;
    };
    for (const Case& item : {
             Case{{"mill", "--at", "X0"}, "K6275", 1},
             {{"trunnion-ac", "--at", "X"}, "K6276", 1},
             {{"trunnion-ac", "--at", "X1e3"}, "K6276", 1},
             {{"trunnion-ac", "--tool", "0,1"}, "K6276", 1},
             {{"trunnion-ac", "--euler", "0;1;2"}, "K6276", 1},
             {{"trunnion-ac", "--from", "B10"}, "K6277", 1},
             {{"trunnion-ac", "--axes", "Q10"}, "K6277", 1},
             {{"trunnion-ac", "--tool", "0,0,0"}, "K6278", 1},
             {{"nutating", "--tool", "0,0.5,-0.8"}, "K6279", 1},
             {{"trunnion-cd"}, "K6001", 2},
             {{"/no/such/machine.xml"}, "K9001", 2},
             {{"trunnion-ac", "--axes", "X1", "--at", "X1"}, "--at", 2},
             {{"trunnion-ac", "--tool", "0,0,1", "--euler", "0,0,0"}, "--euler", 2},
         }) {
        SCOPED_TRACE(item.words.back());
        const ProcessResult result = solve(item.words);
        EXPECT_EQ(result.status, item.status);
        EXPECT_NE(result.err.find(item.said), std::string::npos) << result.err;
        EXPECT_TRUE(result.out.empty()) << result.out;
    }
}

// A program for three axes runs on every machine that has them.
TEST_F(MachineSolve, ProgramsForThreeAxesRunOnEveryStockMachine) {
    save("part.nc",
         "G90 G17\nT1\nS3000 M3\nG0 X10 Y10 Z50\nG1 Z5 F500\nG2 X30 Y10 I10 J0\nG0 Z50\nM30\n");
    for (const char* name : {"trunnion-ac", "trunnion-bc", "head-cb", "head-ab", "mixed-cb",
                             "nutating", "rotary-a", "borer", "six-axis"}) {
        SCOPED_TRACE(name);
        const ProcessResult result =
            kadr({"run", file("part.nc"), "-d", "iso", "-m", name, "--summary", "json"});
        EXPECT_EQ(result.status, 0) << result.err;
        const json summary = json::parse(result.out);
        EXPECT_EQ(summary["alarms"], 0);
        EXPECT_LE(summary["travel"]["X"]["min"].get<double>(), 10);
        EXPECT_GE(summary["travel"]["X"]["max"].get<double>(), 30);
    }
}

}  // namespace

}  // namespace machine_solve_test
