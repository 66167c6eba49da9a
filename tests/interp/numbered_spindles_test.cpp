// Machines with several spindles: what the motion side is told of each. S 2.3, 3.2.
#include "interp/run_clock.h"
#include "tests/interp/text_bench.h"

namespace kadr::interp::numbered_spindles_test {
namespace {

using path::Command;
using path::Op;

machine::Machine twin() {
    machine::Machine machine = mill();
    machine.spindles = {{.number = 2, .max_speed = 100, .orient_time = 0.5}};
    return machine;
}

/// What is told of spindles: `1 cw 800`, `(2) ccw 500` of one that is not the master.
std::string spindles(const std::string& text, const machine::Machine& machine = twin()) {
    const Ran ran = read("sinumerik", text + "\nM30", machine);
    std::string out = alarms(ran);
    for (const Command& command : ran.commands) {
        if (command.op() != Op::Spindle && command.op() != Op::OtherSpindle) continue;
        if (!out.empty()) out += ", ";
        std::string number = std::to_string(command.spindle().number);
        if (command.op() == Op::OtherSpindle) number = '(' + number + ')';
        static constexpr std::array kModes = {"stop", "cw", "ccw", "orient"};
        out += number + ' ' + kModes.at(static_cast<std::size_t>(command.spindle().mode));
        const bool stands = command.spindle().mode == path::SpindleMode::Orient;
        append_shortest(out += ' ', stands ? command.spindle().angle_deg : command.spindle().speed);
    }
    return out;
}

TEST(NumberedSpindles, OneSpindleHasNoNumber) {
    EXPECT_EQ(spindles("S800 M3\nS1=900\nM1=5\nSPOS[1]=90", mill()),
              "0 cw 800, 0 cw 900, 0 stop 0, 0 orient 90");
}

TEST(NumberedSpindles, AreToldBesideTheMaster) {
    EXPECT_EQ(spindles("S800 M3 S2=500 M2=4\nS2=600\nM2=5 M5\nSPOS[2]=30\nSPOS[2]=IC(-45)"),
              "1 cw 800, (2) ccw 500, (2) ccw 600, 1 stop 0, (2) stop 0, (2) orient 30, "
              "(2) orient 345");
}

TEST(NumberedSpindles, TheMasterIsToldWhenAnotherOneBecomesIt) {
    // A spindle that stands at an angle stays there.
    EXPECT_EQ(spindles("S800 M3\nSPOS[2]=30\nSETMS(2)\nM4 S200\nS1=700\nSETMS\nM2=5"),
              "1 cw 800, (2) orient 30, 2 stop 0, 2 ccw 200, (1) cw 700, 1 cw 700, (2) stop 0");
    EXPECT_EQ(spindles("S2=500 M2=3\nSETMS(2)\nSETMS(2)\nM2=4"), "(2) cw 500, 2 cw 500, 2 ccw 500");
}

TEST(NumberedSpindles, ConstantCuttingSpeedIsTheMastersWithItsLimits) {
    const Ran ran =
        read("sinumerik", "LIMS[2]=1500\nLIMS=3000\nSETMS(2)\nG96 S100 M3\nM30", twin());
    EXPECT_EQ(alarms(ran), "");
    std::vector<double> limits;
    for (const Command& command : ran.commands)
        if (command.op() == Op::SpeedLimit) limits.push_back(command.speed_limit().most);
    EXPECT_EQ(limits, (std::vector<double>{3000, 1500}));
    const auto last = std::find_if(ran.commands.rbegin(), ran.commands.rend(),
                                   [](const Command& c) { return c.op() == Op::Spindle; });
    ASSERT_NE(last, ran.commands.rend());
    EXPECT_EQ(last->spindle().number, 2);
    EXPECT_TRUE(last->spindle().has_cutting_speed);
}

TEST(NumberedSpindles, TapsAndThreadsTurnTheMaster) {
    EXPECT_EQ(spindles("SETMS(2)\nS300\nG331 Z-10 K1\nG332 Z5 K1"),
              "2 stop 0, 2 cw 300, 2 stop 0, 2 ccw 300, 2 stop 0");
    EXPECT_EQ(spindles("S2=300 M2=3\nG33 Z-10 K1"), "K5214, (2) cw 300") << "the master stands";
}

TEST(NumberedSpindles, ListingSaysTheNumber) {
    const Ran ran = read("sinumerik", "S800 M3 S2=500 M2=4\nM30", twin());
    ASSERT_GE(ran.commands.size(), 2u);
    std::string text;
    for (std::size_t i = 0; i < 2; ++i) {
        Command command = ran.commands[i];
        command.line = 0;
        Listing(twin()).append(command, {}, text);
    }
    EXPECT_EQ(text,
              "{\"op\":\"spindle\",\"spindle\":1,\"mode\":\"cw\",\"speed\":800}\n"
              "{\"op\":\"other_spindle\",\"spindle\":2,\"mode\":\"ccw\",\"speed\":500}\n");
}

/// G25 S and LIMS hold under constant cutting speed, the lower one of both first.
/// source: SINUMERIK reference 3.2, motion reference 9.1
TEST(SpeedLimits, ReachTheMotion) {
    const Ran ran = read("sinumerik", "G25 S400\nG96 S200 M3\nLIMS=3000\nG26 S2000\nM30\n");
    EXPECT_FALSE(ran.alarmed) << ran.codes();
    std::vector<std::pair<double, double>> limits;  // least, most
    for (const path::Command& command : ran.commands)
        if (command.op() == path::Op::SpeedLimit)
            limits.emplace_back(command.speed_limit().least, command.speed_limit().most);
    const std::vector<std::pair<double, double>> expected = {{400, 0}, {400, 3000}, {400, 2000}};
    EXPECT_EQ(limits, expected);
}

TEST(SpeedLimits, HoldForTheClockOfTheProgram) {
    struct Row {
        double least;
        double most;
        double speed;  // rpm with 200 m/min at a radius of 90 mm
    };
    // Without limits 200000 / (2π·90) rpm.
    for (const Row& row : {Row{0, 0, 353.6776513}, {400, 0, 400}, {0, 300, 300}, {400, 300, 300}}) {
        SCOPED_TRACE(row.speed);
        const machine::Machine machine = mill();
        RunClock clock(machine);
        AxisValues at{};
        at[0] = 100;
        clock.start(at);
        path::Command limit(path::Op::SpeedLimit);
        limit.speed_limit().least = row.least;
        limit.speed_limit().most = row.most;
        clock.add(limit);
        path::Command spindle(path::Op::Spindle);
        spindle.spindle().mode = path::SpindleMode::Cw;
        spindle.spindle().speed = 200;
        spindle.spindle().has_cutting_speed = true;
        clock.add(spindle);
        path::Command cut(path::Op::Line);
        cut.motion().feed_mode = path::FeedMode::PerRevolution;
        cut.motion().feed = 0.3;
        cut.motion().to[0] = 90;
        clock.add(cut);
        EXPECT_NEAR(clock.seconds(), 10 / (0.3 * row.speed) * 60, 1e-6);
    }
}

}  // namespace
}  // namespace kadr::interp::numbered_spindles_test
