// Every example at every tick: no axis is asked for more than it has, with a limit of the jerk and
// without, and the motion ends where the program does.
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "driver/execution.h"
#include "process/scanner.h"
#include "tests/common/inputs.h"
#include "tests/motion/support.h"
#include "tests/motion/tick_limits.h"

namespace limits_test {

namespace {

namespace fs = std::filesystem;
using namespace kadr;

constexpr double kTolerance = 1e-3;

struct Executed {
    std::vector<path::Command> commands;
    machine::Machine machine;
};

Executed execute(const std::string& source, const std::string& machine) {
    Sources sources = test::inputs().new_sources();
    driver::Messages messages(sources, {driver::MessageFormat::Json, false, 20},
                              [](std::string_view line) { ADD_FAILURE() << line; });
    driver::Options options;
    options.dialect = "sinumerik";
    options.machine = machine;
    driver::Session session(options, test::inputs(), sources, messages);
    Executed executed;
    auto text = driver::open_source(session, source);
    auto execution = text ? driver::Execution::open(session, source, std::move(text)) : nullptr;
    if (!execution) {
        ADD_FAILURE() << source;
        return executed;
    }
    executed.machine = execution->machine();
    // What is a scanner's no axis moves for.
    process::ScanLists lists;
    std::optional<process::ScannerCommands> axes;
    const motion::PlannerOptions planning;
    if (executed.machine.scanner)
        axes.emplace(*execution, executed.machine, planning, messages, lists);
    Stream<path::Command>& commands =
        axes ? static_cast<Stream<path::Command>&>(*axes) : *execution;
    std::vector<path::Command> batch(64);
    while (const std::size_t n = commands.pull(batch)) {
        executed.commands.insert(executed.commands.end(), batch.begin(),
                                 batch.begin() + static_cast<std::ptrdiff_t>(n));
    }
    EXPECT_FALSE(execution->alarmed());
    return executed;
}

void expect_limits(const machine::Machine& machine, const std::vector<path::Command>& commands) {
    const motion::test::Motion planned = motion::test::run(machine, commands);
    ASSERT_FALSE(planned.alarmed);
    motion::test::CommandList list(commands);
    DiagnosticList sink;
    motion::Planner planner(list, machine, {}, sink);
    motion::Sampler sampler(planner, machine);
    motion::test::TickWatch watch(machine, planned.segments);
    std::vector<motion::Setpoint> batch(1000);
    motion::Setpoint last;
    while (const std::size_t n = sampler.pull(batch)) {
        for (std::size_t i = 0; i < n; ++i) watch.add(batch[i]);
        last = batch[n - 1];
    }
    EXPECT_LE(watch.shares().velocity, 1 + kTolerance);
    EXPECT_LE(watch.shares().acceleration, 1 + kTolerance);
    EXPECT_LE(watch.shares().jerk, 1 + kTolerance);
    EXPECT_EQ(last.feed, 0);
    // No drift: the last setpoint is the end of the last piece, to the last bit.
    for (std::size_t i = planned.segments.size(); i-- > 0;) {
        if (!motion::is_motion(planned.segments[i].kind)) continue;
        EXPECT_EQ(last.tip, path::end(planned.segments[i].curve));
        break;
    }
}

/// The machine that the text of an example tells to choose; else the mill.
std::string machine_of(const std::string& text) {
    for (const char* name : {"lathe", "laser", "scanner", "trunnion-ac"}) {
        if (text.find(std::string("-m ") + name) != std::string::npos) return name;
    }
    return "mill";
}

TEST(TickLimits, OfEveryExample) {
    std::size_t seen = 0;
    for (const auto& entry : fs::directory_iterator(std::string(KADR_ROOT) + "/examples")) {
        if (entry.path().extension() != ".kadr") continue;
        SCOPED_TRACE(entry.path().filename().string());
        const std::string machine = machine_of(read_file(entry.path().string()).value());
        const Executed executed = execute(entry.path().string(), machine);
        ++seen;
        expect_limits(executed.machine, executed.commands);
        machine::Machine sharp = executed.machine;
        for (auto& axis : sharp.axes) axis.jerk = std::numeric_limits<double>::infinity();
        expect_limits(sharp, executed.commands);
        if (machine != "mill") continue;
        const Executed fast = execute(entry.path().string(), "mill-fast");
        expect_limits(fast.machine, fast.commands);
    }
    EXPECT_GE(seen, 17u);
}

}  // namespace

}  // namespace limits_test
