// M functions that take the machine time: where the axes stand for them, and for how long.
#include <vector>

#include <gtest/gtest.h>

#include "tests/motion/support.h"

namespace kadr::motion::function_test {
namespace {

using namespace test;

/// M10 takes 0.4 s and M11 3 s.
machine::Machine clamped_machine() {
    machine::Machine machine = machine_of();
    machine.functions = {{10, 0.4}, {11, 3}};
    return machine;
}

Command function(std::int64_t code, path::FunctionStep step) {
    Command command = simple(Op::Function);
    command.function().code = code;
    command.function().step = step;
    return command;
}

/// 100 mm at 100 mm/s and 5000 mm/s²: 1.02 s from rest to rest.
constexpr double kLine = 1.02;
std::vector<Command> between_lines(const std::vector<Command>& before,
                                   const std::vector<Command>& behind = {}) {
    std::vector<Command> program = {line_to({100, 0, 0}, 6000)};
    program.insert(program.end(), before.begin(), before.end());
    program.push_back(line_to({200, 0, 0}, 6000));
    program.insert(program.end(), behind.begin(), behind.end());
    program.push_back(line_to({300, 0, 0}, 6000));
    return program;
}

TEST(MachineFunction, TheAxesWaitWhereTheProgramDoes) {
    struct Row {
        const char* name;
        std::vector<Command> program;
        double waiting;
        double time;
    };
    using enum path::FunctionStep;
    const std::vector<Row> rows = {
        // 300 mm without a stop: 3 s and two halves of 0.02 s
        {"none", between_lines({}), 0, 3.02},
        {"awaited at once", between_lines({function(10, Both)}), 0.4, 3.02 + 0.02 + 0.4},
        {"not awaited", between_lines({function(11, Issue)}), 0, 3.02},
        // The line takes 1.01 s up to its stop: it was entered at full speed.
        {"with the line, which is longer",
         between_lines({function(10, Issue)}, {function(10, Await)}), 0, 3.02 + 0.02},
        {"with the line, which is shorter",
         between_lines({function(11, Issue)}, {function(11, Await)}), 3 - 1.01,
         3.02 + 0.02 + 3 - 1.01},
        {"two at once", between_lines({function(10, Issue), function(11, Both)}), 3,
         3.02 + 0.02 + 3},
        {"of no time", between_lines({function(12, Both)}), 0, 3.02 + 0.02},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.name);
        const Motion result = run(clamped_machine(), row.program);
        EXPECT_NEAR(result.totals.wait_time, row.waiting, 1e-9);
        EXPECT_NEAR(result.totals.time, row.time, 1e-9);
        for (const Segment& segment : result.segments) EXPECT_GT(segment.duration, 0);
    }
}

TEST(MachineFunction, SetpointsStandMeanwhile) {
    // At 100 mm after 1.02 s, for 0.4 s.
    const auto setpoints =
        sample(clamped_machine(), between_lines({function(10, path::FunctionStep::Both)}));
    for (std::size_t i = 1020; i <= 1420; ++i) {
        ASSERT_NEAR(setpoints[i].axis[0], 100, 1e-9);
        ASSERT_EQ(setpoints[i].feed, 0);
    }
    EXPECT_GT(setpoints[1422].axis[0], 100);
}

/// Answers a second after the function was issued, and remembers what it was asked.
class SlowPlc final : public Plc {
  public:
    double acknowledged(const IssuedFunction& function) override {
        asked.push_back(function);
        return function.time + 1;
    }
    std::vector<IssuedFunction> asked;
};

TEST(MachineFunction, AnotherPlcMayAnswer) {
    SlowPlc plc;
    PlannerOptions options;
    options.plc = &plc;
    const Motion result =
        run(clamped_machine(), between_lines({function(10, path::FunctionStep::Both)}), options);
    EXPECT_NEAR(result.totals.wait_time, 1, 1e-9);
    ASSERT_EQ(plc.asked.size(), 1u);
    EXPECT_EQ(plc.asked[0].code, 10);
    EXPECT_EQ(plc.asked[0].line, 2u);
    EXPECT_NEAR(plc.asked[0].time, kLine, 1e-9);
}

TEST(MachineFunction, AHoldDoesNotInterruptIt) {
    PlannerOptions options;
    options.events = {{OperatorAct::FeedHold, 1, 1.1, 0, -1},
                      {OperatorAct::CycleStart, 1, 5, 0, -1}};
    const Motion result =
        run(clamped_machine(), between_lines({function(10, path::FunctionStep::Both)}), options);
    EXPECT_NEAR(result.totals.wait_time, 0.4, 1e-9);
    EXPECT_NEAR(result.totals.hold_time, 5 - kLine - 0.4, 1e-9);
    EXPECT_NEAR(result.totals.time, 5 + 2.02, 1e-9);
}

}  // namespace
}  // namespace kadr::motion::function_test
