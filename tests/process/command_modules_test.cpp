// Who serves a command: nobody, the scanner, a module that is registered.
#include "process/command_modules.h"

#include <gtest/gtest.h>

#include "process/planned_motion.h"
#include "tests/motion/support.h"
#include "tests/process/keep.h"

namespace kadr::process {
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
    Command serve(const Command& command) override {
        Command stroke = command;
        stroke.op = Op::External;
        stroke.time = 0.1 * ++strokes_;
        return stroke;
    }

  private:
    int strokes_ = 0;
};

const ModuleRegistration kPress("press",
                                [](const machine::Machine&) -> std::unique_ptr<CommandModule> {
                                    return std::make_unique<Press>();
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
    command.time = time;
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
    EXPECT_EQ(dry.totals.commands, 5u);
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
    EXPECT_EQ(module_names(), (std::vector<std::string_view>{"none", "press", "scanner"}));
    EXPECT_TRUE(is_module("scanner"));
    EXPECT_FALSE(is_module("Press"));
}

}  // namespace
}  // namespace kadr::process
