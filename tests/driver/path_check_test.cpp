// A run whose planned motion is made wrong: it says so, as an error of Kadr, and leaves no file.
#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/text.h"
#include "driver/run.h"
#include "tests/common/inputs.h"
#include "tests/driver/scratch.h"

namespace kadr::path_check_test {
namespace {

const std::string kText =
    "G17 G90 G642 CTOL=0.05\nS6000 M3\nF2000\nG1 X10\nX10 Y10\nG3 X0 Y20 CR=10\nG1 X-20\nM30\n";
/// Of a machine that turns table and tool: the tip is at X0, the tool leans.
const std::string kTurned =
    "G17 G90\nS6000 M3\nTRAORI\nORIWKS\nORIVECT\nF2000\nG0 X0 Y0 Z0 A3=0 B3=0.2 C3=1\n"
    "G1 X10 A3=0.2 B3=0.2 C3=1\nX20 A3=0.4 B3=0 C3=1\nTRAFOOF\nM30\n";
/// The second block turns the tool alone, in the plane of the contour: its tip stands.
const std::string kTurnedBesideAContour =
    "$TC_DP1[1,1]=120\n$TC_DP3[1,1]=60\n$TC_DP6[1,1]=5\nG17 G90 G94 G54\nT1 D1\nM6\n"
    "S6000 M3 F3000\nTRAORI\nG54\nORIWKS\nORIVECT\nG0 X-30 Y-30 Z5 A3=0.05 C3=1\nCUT3DC\n"
    "G1 G41 X0 Y0 Z0\nX33\nA3=1 C3=1\nX90\nG40 Y-20\nTRAFOOF\nM30\n";

struct Ran {
    driver::Status status = driver::Status::Done;
    std::string messages;
};

class PathCheckTest : public test::ScratchFolder {
  protected:
    Ran run(const std::string& text, const std::string& machine,
            const std::function<void(motion::Segment&)>& spoil) const {
        save("part.mpf", text);
        Ran ran;
        for (const bool has_threads : {false, true}) {
            std::filesystem::remove(file("out.csv"));
            ran.messages.clear();
            Sources sources = test::inputs().new_sources();
            driver::Messages messages(sources, {driver::MessageFormat::Text, false, 20},
                                      [&](std::string_view line) { ran.messages += line; });
            driver::Options options;
            options.dialect = "sinumerik";
            options.machine = machine;
            driver::Session session(options, test::inputs(), sources, messages);
            driver::RunJob job;
            job.source = file("part.mpf");
            job.outputs["--setpoints"] = file("out.csv");
            job.threads = has_threads;
            ran.status = driver::run(session, job, spoil);
        }
        return ran;
    }
    bool has_file() const { return std::filesystem::exists(file("out.csv")); }
};

TEST_F(PathCheckTest, RightMotionIsWritten) {
    const Ran ran = run(kText, "mill", {});
    EXPECT_EQ(ran.status, driver::Status::Done) << ran.messages;
    EXPECT_EQ(ran.messages.find("error"), std::string::npos) << ran.messages;
    EXPECT_TRUE(has_file());
    EXPECT_EQ(run(kTurned, "trunnion-ac", {}).status, driver::Status::Done);
    EXPECT_EQ(run(kTurnedBesideAContour, "trunnion-ac", {}).status, driver::Status::Done);
}

TEST_F(PathCheckTest, WrongMotionIsAnErrorAndLeavesNoFile) {
    // The planner takes a line to another height, 0.01 mm beyond the tolerance.
    const Ran ran = run(kText, "mill", [](motion::Segment& segment) {
        if (segment.line != 7) return;
        if (auto* line = std::get_if<path::Line>(&segment.curve)) {
            line->start.z() += 0.06;
            line->end.z() += 0.06;
        }
    });
    EXPECT_EQ(ran.status, driver::Status::Failed);
    EXPECT_FALSE(has_file());
    EXPECT_NE(ran.messages.find("part.mpf:7"), std::string::npos) << ran.messages;
    EXPECT_NE(ran.messages.find("error[K6320]: an error of Kadr: the tip is off by 0.06 mm"),
              std::string::npos)
        << ran.messages;
    EXPECT_NE(ran.messages.find("where 0.050001 mm is allowed"), std::string::npos) << ran.messages;
}

TEST_F(PathCheckTest, AToolThatLeansAnotherWayIsOne) {
    const Ran ran = run(kTurned, "trunnion-ac", [](motion::Segment& segment) {
        if (segment.line == 8) segment.orientation.rate *= 1.01;
    });
    EXPECT_EQ(ran.status, driver::Status::Failed);
    EXPECT_FALSE(has_file());
    EXPECT_NE(ran.messages.find("the direction of the tool is off by"), std::string::npos)
        << ran.messages;
}

TEST_F(PathCheckTest, AMotionThatIsLeftOutIsOne) {
    // Everything behind the arc stays where the arc ends.
    const Ran ran = run(kText, "mill", [](motion::Segment& segment) {
        if (segment.line == 7) segment.curve = path::Point{{0, 20, 0}};
    });
    EXPECT_EQ(ran.status, driver::Status::Failed);
    EXPECT_FALSE(has_file());
    EXPECT_NE(ran.messages.find("the end of the path is off by 20 mm"), std::string::npos)
        << ran.messages;
}

}  // namespace
}  // namespace kadr::path_check_test
