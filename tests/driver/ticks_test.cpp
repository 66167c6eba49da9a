// `--tick` says how far apart setpoints are; what is planned depends on the machine alone.
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/disk_files.h"
#include "tests/driver/scratch.h"

namespace ticks_test {

namespace {

using kadr::read_file;
using kadr::test::Row;
using kadr::test::rows_of;

class Ticks : public kadr::test::ScratchFolder {
  protected:
    /// Time of a run, s.
    double time_of(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "run");
        arguments.insert(arguments.end(), {"--summary", "json"});
        const ProcessResult ran = kadr(arguments);
        EXPECT_EQ(ran.status, 0) << ran.err;
        if (ran.status != 0) return 0;
        return nlohmann::json::parse(ran.out)["time_s"].get<double>();
    }
};

/// Corners, arcs, splines, compressed lines, rounded corners, threads, five axes at a pole, feeds
/// that change along the path, the pulses of a laser: 12.15 s instead of 6.25 s it was for blocks
/// of 10 to 200 µm with `--tick 0.25ms`.
TEST_F(Ticks, SetpointsCloserOrFartherAreOfTheSameMotion) {
    std::string shorts =
        "G17 G90 G64\nF1500\nR1=0\nWAY:\nR1=R1+1\nR2=0.105+0.095*SIN(R1*47)\n"
        "R3=40*SIN(R1*7)+8*SIN(R1*101)\nG91 G1 X=R2*COS(R3) Y=R2*SIN(R3)\n"
        "IF R1<800 GOTOB WAY\nM30\n";
    save("short.mpf", shorts);
    save("rest.mpf",
         "G17 G90 G64\nF5000\nG1 X10\nY10\nX20 Y11\nG3 X40 Y11 I10 J0\nG642 G1 X60\nY30\nX30\n"
         "G645 X0 Y0\nX20\nY20\nG64\nCSPLINE X30 Y10\nX40 Y20\nX50 Y5\nG1 X60 FLIN F500\nX80 "
         "F4000\nCOMPCAD X80.1 Y5.1\nX80.2 Y5.25\nX80.3 Y5.45\nX80.4 Y5.6\nCOMPOF G0 X0 "
         "Y0\nX5\nM30\n");
    save("thread.mpf", "G18 G90 G95 S500 M3\nG0 X20 Z5\nG33 Z-20 K1.5\nZ-30 K1.5\nG0 X30\nM30\n");
    const std::string examples = std::string(KADR_ROOT) + "/examples/";
    const std::vector<std::vector<std::string>> runs = {
        {file("short.mpf"), "-d", "sinumerik", "-m", "laser"},
        {file("short.mpf"), "-d", "sinumerik", "-m", "mill"},
        {file("rest.mpf"), "-d", "sinumerik", "-m", "mill"},
        {file("rest.mpf"), "-d", "sinumerik", "-m", "laser"},
        {file("thread.mpf"), "-d", "sinumerik", "-m", "mill"},
        {examples + "dome.mpf", "-d", "sinumerik", "-m", "trunnion-ac"},
        {examples + "cap.mpf", "-d", "sinumerik", "-m", "mixed-cb"},
        {examples + "chamfers.mpf", "-d", "sinumerik", "-m", "head-ab"},
        {examples + "dots.kadr", "-d", "fanuc", "-m", "laser"},
        {examples + "fields.kadr", "-d", "fanuc", "-m", "scanner"},
        {examples + "bracket.kadr", "-d", "fanuc", "-m", "mill"}};
    for (const std::vector<std::string>& run : runs) {
        SCOPED_TRACE(run.front() + " " + run.back());
        const double machine = time_of(run);
        EXPECT_GT(machine, 0);
        for (const char* tick : {"0.25ms", "0.5ms", "1ms", "4ms"}) {
            std::vector<std::string> other = run;
            other.insert(other.end(), {"--tick", tick});
            EXPECT_EQ(time_of(other), machine) << tick;
        }
    }
}

/// … row by row: every fourth setpoint at a quarter of the tick is one at the tick.
TEST_F(Ticks, EveryFourthSetpointAtAQuarterOfTheTickIsOneAtTheTick) {
    save("part.mpf", "G17 G90 G64\nF5000\nG1 X10\nY10\nX20 Y11\nG3 X40 Y11 I10 J0\nM30\n");
    std::vector<std::vector<Row>> rows;
    for (const char* tick : {"1ms", "0.25ms"}) {
        const ProcessResult ran = kadr({"run", file("part.mpf"), "-d", "sinumerik", "--tick", tick,
                                        "--setpoints", file("part.csv")});
        ASSERT_EQ(ran.status, 0) << ran.err;
        rows.push_back(rows_of(read_file(file("part.csv")).value()));
    }
    ASSERT_GT(rows[0].size(), 500u);
    for (std::size_t i = 0; i + 1 < rows[0].size(); ++i) {
        for (const char* axis : {"X", "Y"})
            EXPECT_NEAR(rows[0][i].at(axis), rows[1].at(4 * i).at(axis), 1e-8) << i;
    }
}

}  // namespace

}  // namespace ticks_test
