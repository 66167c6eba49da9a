// Messages of the motion show what they are about, as those of the interpreter do: the line with a
// caret below the word, the calls that have led to it, however long ago the line was read.
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/driver/scratch.h"

namespace motion_locations_test {

namespace {

class MotionPlaces : public kadr::test::ScratchFolder {
  protected:
    /// What a run says whose motion ends with an alarm.
    std::string programmed_in(const std::string& name, const std::string& text,
                              std::vector<std::string> options) {
        save(name, text);
        options.insert(options.begin(), {"run", file(name)});
        options.insert(options.end(), {"--commands", file("out.jsonl")});
        const ProcessResult result = kadr(options);
        EXPECT_EQ(result.status, 3) << result.err;
        return result.err;
    }
};

void expect_in(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << "not found: " << part << "\nin: " << text;
}

TEST_F(MotionPlaces, AThreadInASubprogramAndTheCallOfSeveralThatWasTooFast) {
    save("CUT.SPF", "PROC CUT(REAL STEP)\nN10 G33 Z=-STEP K=STEP\nRET\n");
    const std::string text = programmed_in("threads.mpf",
                                           "T1 D1 M6\nS12000 M3\nG0 X0 Y0 Z0\nEXTERN CUT(REAL)\n"
                                           "N50 CUT(1)\nN60 CUT(1.5)\nN70 CUT(50)\nM30\n",
                                           {"-d", "sinumerik"});
    expect_in(text, "CUT.SPF:2:5: alarm[22270]: ");
    expect_in(text,
              "\n   2 | N10 G33 Z=-STEP K=STEP\n"
              "     |     ^~~\n");
    expect_in(text, "threads.mpf:7:5: note: called here\n");
    EXPECT_EQ(text.find("threads.mpf:5:"), std::string::npos) << text;
    EXPECT_EQ(text.find("threads.mpf:6:"), std::string::npos) << text;
    expect_in(text, "fix: a slower spindle cuts the same thread\n");
}

TEST_F(MotionPlaces, AProgramOfTheSameTextThatIsCalledAgain) {
    // The first call of 100 mm is through at about 6 s, the second one stands at 15 s: 600 mm/min.
    const std::string text = programmed_in(
        "calls.nc",
        "%\nO1\nT1 M6\nN10 G0 X0 Y0 S1000 M3\nF600.\nN20 M98 P22\nN30 M98 P22\nM30\nO22\n"
        "N40 G91 G1 X100.\nG90\nM99\n%\n",
        {"-d", "fanuc", "--feed-override", "100%,20s:0%"});
    expect_in(text, "calls.nc:10:5: alarm[K6210]: ");
    expect_in(text, "  10 | N40 G91 G1 X100.\n     |     ^~~\n");
    expect_in(text, "calls.nc:7:5: note: called here\n");
    EXPECT_EQ(text.find("calls.nc:6:5: note"), std::string::npos) << text;
    expect_in(text, "fix: let an override above 0 % follow at a later time\n");
}

TEST_F(MotionPlaces, ACycleIsItsCall) {
    const std::string text = programmed_in("holes.mpf",
                                           "N10 T1 D1 M6\nN20 S1000 M3 F100\nN30 G0 X0 Y0 Z10\n"
                                           "N40 CYCLE81(10,0,2,-20)\nN50 M30\n",
                                           {"-d", "sinumerik", "--hold", "N40+5s"});
    expect_in(text, "holes.mpf:4:5: alarm[K6210]: ");
    expect_in(text, "   4 | N40 CYCLE81(10,0,2,-20)\n     |     ^~~~~~~~~~~~~~~~~~~\n");
    expect_in(text, "fix: let cycle start follow at a later time\n");
}

TEST_F(MotionPlaces, ALimitUnderATransformationAtTheWordOfTheAxis) {
    const std::string text = programmed_in(
        "lean.mpf", "T1 D1 M6\nS1000 M3 F1000\nTRAORI\nN40 G1 X0 Y0 Z600 A3=0.1 B3=0 C3=0.9\nM30\n",
        {"-d", "sinumerik", "-m", "trunnion-ac"});
    expect_in(text, "lean.mpf:4:14: alarm[K6101]: axis Z reaches ");
    expect_in(text,
              "   4 | N40 G1 X0 Y0 Z600 A3=0.1 B3=0 C3=0.9\n"
              "     |              ^~~~\n");
}

TEST_F(MotionPlaces, TheScannerIsSwitchedOffElsewhere) {
    const std::string text =
        programmed_in("mark.mpf", "G0 X100 Y50\nM66\nG1 X110 F60000\nN40 M67\nM30\n",
                      {"-d", "sinumerik", "-m", "scanner"});
    expect_in(text, "mark.mpf:4:5: alarm[K6229]: ");
    expect_in(text, "   4 | N40 M67\n     |     ^~~\n");
}

/// Lines that are read in batches long before the motion comes to them, of a text that cannot be
/// read again and is not kept.
TEST_F(MotionPlaces, ALineFarInAStream) {
    constexpr int kLines = 300'000;  // 6 MB
    std::string text = "G0 X0 Y0 Z0\nS1000 M3 F60000\n";
    for (int i = 0; i < kLines; ++i) text += i % 2 == 0 ? "G1 X1.000 Y2.000000\n" : "G1 X0 Y0\n";
    text += "N777 G33 Z-100 K50\n";
    for (int i = 0; i < 3000; ++i) text += "G1 X1\nG1 X0\n";
    text += "M30\n";
    const ProcessResult result =
        run_process({KADR_BINARY, "run", "-", "-d", "sinumerik", "--commands", "/dev/null"}, text);
    EXPECT_EQ(result.status, 3);
    expect_in(result.err, "<stdin>:300003:6: alarm[22270]: ");
    expect_in(result.err, "300003 | N777 G33 Z-100 K50\n       |      ^~~\n");
}

TEST_F(MotionPlaces, ForPrograms) {
    save("line.nc", "%\nO1\nG0 X0 Y0 S1000 M3\nN20 G1 X100. F600.\nM30\n%\n");
    const ProcessResult result = kadr({"run", file("line.nc"), "-d", "fanuc", "--hold", "5s",
                                       "--diagnostics", "json", "--commands", file("out.jsonl")});
    EXPECT_EQ(result.status, 3);
    const std::size_t at = result.err.find("\"K6210\"");
    ASSERT_NE(at, std::string::npos) << result.err;
    const std::size_t begin = result.err.rfind('\n', at) + 1;  // npos + 1 is the first line
    const auto message =
        nlohmann::json::parse(result.err.substr(begin, result.err.find('\n', at) - begin));
    EXPECT_EQ(message["line"], 4);
    EXPECT_EQ(message["column"], 5);
    EXPECT_EQ(message["end_column"], 7);
}

}  // namespace

}  // namespace motion_locations_test
