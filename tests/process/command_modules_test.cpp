// Who serves a command: nobody, the scanner, a module that is registered.
#include "process/command_modules.h"

#include <cmath>

#include <gtest/gtest.h>

#include "process/planned_motion.h"
#include "tests/motion/support.h"
#include "tests/process/keep.h"

namespace kadr::process::command_modules_test {
namespace {

using motion::Segment;
using motion::SegmentKind;
using motion::test::line_to;
using motion::test::rapid_to;
using motion::test::simple;
using path::Command;
using path::Op;
using path::Vec3;

/// A press that strokes longer each time.
class Press final : public CommandModule {
  public:
    std::vector<Command> serve(const Command& command) override {
        Command stroke = command;
        stroke.become(Op::External);
        stroke.external().time = 0.1 * ++strokes_;
        return {stroke};
    }

  private:
    int strokes_ = 0;
};

const ModuleRegistration kPress("press",
                                [](const machine::Machine&) -> std::unique_ptr<CommandModule> {
                                    return std::make_unique<Press>();
                                });

/// Goes to every place by way of the place above it, in as many steps as the way has millimetres.
class Stairs final : public CommandModule {
  public:
    std::vector<Command> serve(const Command& command) override {
        std::vector<Command> steps;
        const Vec3 to = {command.motion().to[0], command.motion().to[1], command.motion().to[2]};
        const int count = static_cast<int>(std::ceil((to - at_).norm()));
        for (int i = 1; i <= count; ++i) {
            Command& step = steps.emplace_back(command);
            const Vec3 point = at_ + (to - at_) * i / count;
            for (std::size_t k = 0; k < 3; ++k)
                step.motion().to[k] =
                    point[static_cast<Eigen::Index>(k)] + (k == 2 && i < count ? 1 : 0);
        }
        at_ = to;
        return steps;
    }

  private:
    Vec3 at_ = Vec3::Zero();
};

const ModuleRegistration kStairs("stairs",
                                 [](const machine::Machine&) -> std::unique_ptr<CommandModule> {
                                     return std::make_unique<Stairs>();
                                 });

struct Done {
    std::vector<Segment> segments;
    std::vector<motion::Setpoint> setpoints;
    motion::Totals totals;
    std::uint64_t executed = 0;
    DiagnosticList diagnostics;
};

void run(const machine::Machine& machine, std::vector<Command> commands, Done& out) {
    motion::test::CommandList list(std::move(commands));
    PlannedMotion motion(list, machine, {}, out.diagnostics);
    out.setpoints = test::sampled(motion, machine, out.segments);
    out.totals = motion.totals();
    out.executed = motion.executed();
}

Command dwell(double time) {
    Command command = simple(Op::Dwell);
    command.dwell().time = time;
    return command;
}

const std::vector<Command> kProgram = {line_to({10, 0, 0}, 600), dwell(2),
                                       line_to({10, 10, 0}, 600), dwell(3),
                                       line_to({0, 10, 0}, 600)};

TEST(CommandModules, NoneCountsAndLeavesOut) {
    machine::Machine machine = motion::test::machine_of();
    Done plain;
    run(machine, kProgram, plain);
    machine.pipeline.modules = {{Op::Dwell, "none", {}}};
    Done dry;
    run(machine, kProgram, dry);
    EXPECT_NEAR(plain.totals.dwell_time, 5, 1e-12);
    EXPECT_EQ(dry.totals.dwell_time, 0);
    EXPECT_EQ(dry.executed, plain.executed);
    EXPECT_EQ(dry.executed, 5u);
    EXPECT_NEAR(dry.totals.length, 30, 1e-12);
    EXPECT_EQ(dry.setpoints.back().tip, Vec3(0, 10, 0));
}

TEST(CommandModules, ARegisteredOneServesItsCommands) {
    machine::Machine machine = motion::test::machine_of();
    machine.pipeline.modules = {{Op::Dwell, "press", {}}};
    Done done;
    run(machine, kProgram, done);
    EXPECT_EQ(done.totals.dwell_time, 0);
    EXPECT_NEAR(done.totals.external_time, 0.1 + 0.2, 1e-12);  // one press serves both
    EXPECT_EQ(done.setpoints.back().tip, Vec3(0, 10, 0));
}

// 0 to 1000 mm in one answer: more commands than any batch holds, in order, and at the same end.
TEST(CommandModules, AnswerWithSeveralCommands) {
    machine::Machine machine = motion::test::machine_of();
    machine.pipeline.modules = {{Op::Line, "stairs", {}}};
    Done done;
    run(machine,
        {line_to({0, 0, 0}, 600), line_to({3000, 0, 0}, 60000), dwell(1),
         line_to({3000, 2, 0}, 600)},
        done);
    ASSERT_TRUE(done.diagnostics.all().empty());
    EXPECT_EQ(done.executed, 4u);
    // Beside corners there are pieces that end between.
    std::vector<Vec3> ends;
    for (const Segment& segment : done.segments) {
        const Vec3 end = path::end(segment.curve);
        if (segment.kind == SegmentKind::Feed && end == end.array().round().matrix())
            ends.push_back(end);
    }
    ASSERT_EQ(ends.size(), 3000u + 2u);
    EXPECT_EQ(ends[0], Vec3(1, 0, 1));
    EXPECT_EQ(ends[1500], Vec3(1501, 0, 1));
    EXPECT_EQ(ends[2999], Vec3(3000, 0, 0));
    EXPECT_EQ(ends[3001], Vec3(3000, 2, 0));
    EXPECT_NEAR(done.totals.dwell_time, 1, 1e-12);
}

// Y is missing: the third command of the program is refused, whatever the second was made of.
TEST(CommandModules, CountTheCommandsOfTheProgram) {
    for (const bool has_scanner : {false, true}) {
        machine::Machine machine = motion::test::machine_of();
        machine.axes[1].upper = 5;
        if (has_scanner) machine.scanner = machine::Scanner{};
        machine.pipeline.modules = {{Op::Line, "stairs", {}}, {Op::Dwell, "none", {}}};
        Done done;
        run(machine, {line_to({30, 0, 0}, 600), dwell(1), line_to({30, 10, 0}, 600), dwell(1)},
            done);
        EXPECT_EQ(done.diagnostics.all().size(), 1u);
        EXPECT_EQ(done.executed, 2u);
        EXPECT_EQ(done.setpoints.back().tip[1], 5);
    }
}

TEST(CommandModules, TheScannerServesWaysWithoutItsFunctions) {
    machine::Machine machine = motion::test::machine_of();
    machine.scanner = machine::Scanner{};
    machine.scanner->half_field = 50;
    machine.scanner->jump_speed = 8000;
    machine.pipeline.modules = {{Op::Line, "scanner", {}}};
    Done done;
    run(machine,
        {rapid_to({100, 50, 0}), line_to({110, 50, 0}, 60000), line_to({110, 60, 0}, 60000),
         rapid_to({200, 50, 0}), line_to({200, 55, 0}, 60000)},
        done);
    ASSERT_TRUE(done.diagnostics.all().empty());
    std::vector<SegmentKind> kinds;
    double marked = 0;
    Vec3 stage = Vec3::Zero();
    for (const Segment& segment : done.segments) {
        if (kinds.empty() || kinds.back() != segment.kind) kinds.push_back(segment.kind);
        if (segment.kind == SegmentKind::Mark) marked += path::length(segment.curve);
        if (segment.kind == SegmentKind::Rapid) {
            // The axes go on from where they stood, not from where the beam was.
            EXPECT_EQ(path::start(segment.curve), stage);
            stage = path::end(segment.curve);
        }
    }
    EXPECT_NEAR(marked, 25, 1e-9);
    EXPECT_EQ(std::ranges::count(kinds, SegmentKind::Rapid), 2);
    EXPECT_EQ(stage, Vec3(200, 50, 0));
    EXPECT_EQ(done.executed, 5u);
}

TEST(CommandModules, AreKnownByName) {
    EXPECT_EQ(module_names(),
              (std::vector<std::string_view>{"none", "press", "scanner", "stairs"}));
    EXPECT_TRUE(is_module("scanner"));
    EXPECT_FALSE(is_module("Press"));
}

}  // namespace
}  // namespace kadr::process::command_modules_test
