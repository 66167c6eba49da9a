// Taps while an operator turns the override and holds the feed: on every control they are run as
// they are programmed, out of the hole again.
// source: SINUMERIK reference 4.6, 10.1; FANUC reference 3.2 (G63), 3.6, 5.1, 5.3
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/driver/scratch.h"

namespace taps_test {

namespace {

using kadr::test::Row;
using kadr::test::rows_of;

struct Tap {
    const char* name;
    const char* dialect;
    const char* machine;
    const char* text;
    double deep;  // in the hole, beyond every approach
    double top;   // where the tap is out of it
    char axis = 'Z';
};

// 0.5 mm a turn, 500 rpm: 250 mm/min; 22 mm in 5.28 s.
const std::vector<Tap> kTaps = {
    {"G331 and G332", "sinumerik", "mill",
     "G17 G90 G94 T1 M6\nG0 Z2\nSPOS=0\nG331 Z-20 K0.5 S500\nG332 Z2 K0.5\nG0 Z20\nM30\n", -3, 2},
    {"with a dwell between", "sinumerik", "mill",
     "G17 G90 T1 M6\nG0 Z2\nG331 Z-20 K0.5 S500\nG4 F1\nG332 Z2 K0.5\nG0 Z20\nM30\n", -3, 2},
    {"G63", "sinumerik", "mill",
     "G17 G90 G94 T1 M6\nG0 Z2\nS500 M3\nG63 Z-20 F250\nG63 Z2 M4\nG0 Z20\nM30\n", -3, 2},
    {"CYCLE84", "sinumerik", "mill",
     "G17 G90 G94 T1 M6\nG0 Z10 F500\nCYCLE84(10,0,2,-20,,0,5,,0.5,0,500,500)\nG0 Z20\nM30\n", -3,
     2},
    {"CYCLE84 faster out", "sinumerik", "mill",
     "G17 G90 G94 T1 M6\nG0 Z10 F500\nCYCLE84(10,0,2,-20,,0,5,,0.5,0,500,1000)\nG0 Z20\nM30\n", -3,
     2},
    {"CYCLE840 with encoder", "sinumerik", "mill",
     "G17 G90 G94 T1 M6\nS500 M3\nG0 Z10 F500\nCYCLE840(10,0,2,-20,,0,4,3,0,,0.5)\nG0 Z20\nM30\n",
     -3, 2},
    {"CYCLE840 by the feed", "sinumerik", "mill",
     "G17 G90 G94 T1 M6\nS500 M3\nG0 Z10 F250\nCYCLE840(10,0,2,-20,,0,4,3,1,,)\nG0 Z20\nM30\n", -3,
     2},
    {"MCALL CYCLE84", "sinumerik", "mill",
     "G17 G90 G94 T1 M6\nG0 Z10 F500\nMCALL CYCLE84(10,0,2,-20,,0,5,,0.5,0,500,500)\nX0 Y0\nMCALL\n"
     "G0 Z20\nM30\n",
     -3, 2},
    {"AxiOMA", "axioma", "mill",
     "G17 G90 G94 T1 M6\nG0 Z2\nG331 Z-20 K0.5 S500\nG332 Z2 K0.5\nG0 Z20\nM30\n", -3, 2},
    {"G84 rigid", "fanuc", "mill",
     "O1\nG21 G17 G90 G94 G80\nT1 M6\nG0 X0 Y0 Z10.\nM29 S500\nG84 Z-20. R2. F250.\nG80\nM30\n", -3,
     2},
    {"G84", "fanuc", "mill",
     "O1\nG21 G17 G90 G95 G80\nT1 M6\nS500 M3\nG0 X0 Y0 Z10.\nG84 Z-20. R2. P500 F0.5\nG80\nM30\n",
     -3, 2},
    {"G74", "fanuc", "mill",
     "O1\nG21 G17 G90 G94 G80\nT1 M6\nS500 M4\nG0 X0 Y0 Z10.\nG74 Z-20. R2. F250.\nG80\nM30\n", -3,
     2},
    {"G84 in strokes", "fanuc", "mill",
     "O1\nG21 G17 G90 G94 G80\nT1 M6\nG0 X0 Y0 Z10.\nM29 S500\nG84 Z-20. R2. Q6. F250.\nG80\nM30\n",
     -3, 2},
    {"G63 of FANUC", "fanuc", "mill",
     "O1\nG21 G17 G90 G94\nT1 M6\nS500 M3\nG0 Z2.\nG63\nG1 Z-20. F250.\nM4\nZ2.\nG64\nG0 "
     "Z20.\nM30\n",
     -3, 2},
    {"G84 of a lathe", "fanuc-lathe", "lathe",
     "O1\nG21 G98 G80\nT0101\nS500 M3\nG0 X0 Z10.\nG84 Z-20. R-8. F250.\nG80\nM30\n", -3, 2},
    {"G88 of a lathe", "fanuc-lathe", "lathe",
     "O1\nG21 G98 G80\nT0101\nS500 M3\nG0 X100. Z10.\nG88 X20. R-5. F250.\nG80\nM30\n", 42, 45,
     'X'},
};

class Taps : public kadr::test::ScratchFolder {
  protected:
    nlohmann::json summary(const Tap& tap, std::vector<std::string> options) {
        save("tap.nc", tap.text);
        std::vector<std::string> arguments = {"run", file("tap.nc"), "-d",        tap.dialect,
                                              "-m",  tap.machine,    "--summary", "json"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProcessResult result = kadr(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        return result.status == 0 ? nlohmann::json::parse(result.out) : nlohmann::json{};
    }
    std::vector<Row> setpoints(const Tap& tap, std::vector<std::string> options) {
        options.insert(options.end(), {"--setpoints", file("tap.csv")});
        summary(tap, options);
        return rows_of(kadr::read_file(file("tap.csv")).value());
    }
};

TEST_F(Taps, HaveNoOverride) {
    for (const Tap& tap : kTaps) {
        SCOPED_TRACE(tap.name);
        const double plain = summary(tap, {})["cutting_s"];
        EXPECT_GT(plain, 5);
        EXPECT_NEAR(summary(tap, {"--feed-override", "50"})["cutting_s"], plain, 1e-6);
        EXPECT_NEAR(summary(tap, {"--feed-override", "150"})["cutting_s"], plain, 1e-6);
        // The approach is at rapid; everything at feed is the tap.
        EXPECT_NEAR(summary(tap, {"--feed-override", "100%,1s:20%,9s:150%"})["cutting_s"], plain,
                    1e-6);
    }
}

TEST_F(Taps, AreHeldOutsideTheHole) {
    for (const Tap& tap : kTaps) {
        SCOPED_TRACE(tap.name);
        const std::string axis = tap.axis == 'X' ? "tip_x" : "tip_z";
        const std::vector<Row> plain = setpoints(tap, {});
        const auto out = std::ranges::find_if(
            plain, [&](const Row& row) { return row.at(axis) >= tap.top - 0.05; });
        const auto in =
            std::find_if(out, plain.end(), [&](const Row& row) { return row.at(axis) < tap.deep; });
        ASSERT_NE(in, plain.end());
        for (const double later : {0.0, 1.5}) {
            const double at = in->at("t") + later;
            const auto held = setpoints(tap, {"--hold", std::to_string(at) + "s..30s"});
            const auto rest =
                std::ranges::find_if(held, [](const Row& row) { return row.at("t") > 29; });
            ASSERT_NE(rest, held.end());
            EXPECT_GE(rest->at(axis), tap.top - 1e-6);
            EXPECT_EQ(rest->at("feed"), 0);
            // In the hole every setpoint is the same.
            for (std::size_t i = 0; i < plain.size() && plain[i].at("t") < at + 3; ++i)
                ASSERT_NEAR(held[i].at(axis), plain[i].at(axis), 1e-6) << plain[i].at("t");
        }
    }
}

/// G63 until G64: overrides and the hold act before and behind it.
TEST_F(Taps, TheModeOfFanucIsModal) {
    const Tap lines{
        "",     "fanuc",
        "mill", "O1\nG21 G17 G90 G94 S500 M3\nG1 X50. F1000.\nG63\nX100.\nG64\nX150.\nM30\n",
        0,      0};
    const double plain = summary(lines, {})["cutting_s"];
    EXPECT_NEAR(summary(lines, {"--feed-override", "50"})["cutting_s"], plain + 6, 0.05);
    const auto held = setpoints(lines, {"--hold", "4s..30s"});
    const auto rest = std::ranges::find_if(held, [](const Row& row) { return row.at("t") > 29; });
    ASSERT_NE(rest, held.end());
    EXPECT_NEAR(rest->at("tip_x"), 100, 0.2);
}

/// #3004 as a sum: 1 no feed hold, 2 no override of the feed, 4 no exact stops.
TEST_F(Taps, AMacroSuppressesThePanel) {
    const auto program = [](int suppressed) {
        return "O1\nG21 G17 G90 G94 G61 S500 M3\n#3004=" + std::to_string(suppressed) +
               "\nG1 X50. F1000.\nX100.\n#3004=0\nX150.\nM30\n";
    };
    const auto tap = [&](const std::string& text) {
        return Tap{"", "fanuc", "mill", text.c_str(), 0, 0};
    };
    const auto rest_of = [&](const std::string& text) {
        const auto held = setpoints(tap(text), {"--hold", "4s..30s"});
        const auto rest =
            std::ranges::find_if(held, [](const Row& row) { return row.at("t") > 29; });
        return rest == held.end() ? -1 : rest->at("tip_x");
    };
    const double plain = summary(tap(program(0)), {})["cutting_s"];
    struct Case {
        int suppressed;
        double slower;  // by 50 %, s
        double rest;    // held at 4 s
    };
    for (const Case& row : {Case{0, 9, 66.7}, Case{1, 9, 100}, Case{2, 3, 66.7}, Case{3, 3, 100}}) {
        SCOPED_TRACE(row.suppressed);
        const std::string text = program(row.suppressed);
        EXPECT_NEAR(summary(tap(text), {"--feed-override", "50"})["cutting_s"], plain + row.slower,
                    0.1);
        EXPECT_NEAR(rest_of(text), row.rest, 0.5);
    }
    // Two stops less: at X50 and X100.
    const double quicker = summary(tap(program(4)), {})["cutting_s"];
    EXPECT_LT(quicker, plain - 1e-3);
}

}  // namespace

}  // namespace taps_test
