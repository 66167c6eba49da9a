// runtime.cpp — what the rooms of the runtime cost, each by itself and inside one process.
//
//   bench_runtime read FILE DIALECT         text → blocks
//   bench_runtime interpret FILE DIALECT    text → blocks → commands
//   bench_runtime plan DEPTH [smooth|circles]
//                                           commands → segments, look-ahead DEPTH; under a limit of
//                                           the jerk; circles at the limits of the axes
//   bench_runtime sample lines|arcs|helices segments → setpoints
//   bench_runtime five_axis MACHINE LENGTH  text → setpoints under the transformation of a stock
//                                           machine, lines of LENGTH mm with a vector each
//
// Prints `items seconds`: how many came out, and the CPU time of the process for them.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "base/render.h"
#include "base/text.h"
#include "interp/interpreter.h"
#include "machine/machine.h"
#include "motion/pipeline.h"
#include "nc/reader.h"

namespace {

using kadr::path::Command;

double cpu_time() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// Pulls a stream dry and prints what came out and what it cost.
template <typename T>
void drain(kadr::Stream<T>& stream) {
    std::vector<T> batch(kadr::kBatch);
    std::uint64_t items = 0;
    const double begin = cpu_time();
    while (const std::size_t count = stream.pull(batch)) items += count;
    std::printf("%llu %.6f\n", static_cast<unsigned long long>(items), cpu_time() - begin);
}

class WholeText final : public kadr::nc::TextSource {
  public:
    explicit WholeText(std::string_view text) : text_(text) {}
    std::string_view next() override { return std::exchange(text_, {}); }

  private:
    std::string_view text_;
};

/// Commands made while they are pulled, so that nothing but the motion rooms is measured.
class MadeCommands final : public kadr::Stream<Command> {
  public:
    using Make = void (*)(Command& command, std::uint64_t i);
    MadeCommands(Make make, std::uint64_t count) : make_(make), count_(count) {}

    std::size_t pull(std::span<Command> out) override {
        std::size_t filled = 0;
        for (; filled < out.size() && next_ < count_; ++filled, ++next_) {
            out[filled].line = static_cast<std::uint32_t>(next_ + 1);
            make_(out[filled], next_);
        }
        return filled;
    }

  private:
    Make make_;
    std::uint64_t count_;
    std::uint64_t next_ = 0;
};

/// Lines of about 0.65 mm along a circle of 100 mm: every corner counts, no line is long enough
/// to reach its feed and brake again.
void short_line(Command& command, std::uint64_t i) {
    const double angle = static_cast<double>(i % 973) * 0.37 * (std::numbers::pi / 180);
    command.op = kadr::path::Op::Line;
    command.to = {100 * std::cos(angle), 100 * std::sin(angle), 0};
    command.moved = kadr::kLinearXYZ;
    command.feed = 6000;
}

/// Lines of 100 mm back and forth: the sampler has nearly all the work.
void long_line(Command& command, std::uint64_t i) {
    command.op = kadr::path::Op::Line;
    command.to = {i % 2 == 0 ? 100.0 : 0.0, i % 2 == 0 ? 50.0 : 0.0, 0};
    command.moved = kadr::kLinearXYZ;
    command.feed = 6000;
}

/// Full circles of 20 mm radius; helices climb and fall 5 mm a turn.
void circle(Command& command, std::uint64_t i) {
    static_cast<void>(i);
    command.op = kadr::path::Op::Arc;
    command.to = {};
    command.center = {20, 0, 0};
    command.normal = kadr::path::Vec3::UnitZ();
    command.sweep = 2 * std::numbers::pi;
    command.moved = kadr::kLinearXYZ;
    command.feed = 6000;
}
/// At a feed that the axes do not reach on them: planned in cells.
void fast_circle(Command& command, std::uint64_t i) {
    circle(command, i);
    command.feed = 60000;
}
void helix(Command& command, std::uint64_t i) {
    circle(command, i);
    command.to[2] = i % 2 == 0 ? 5.0 : 0.0;
    command.center[2] = i % 2 == 0 ? 0.0 : 5.0;
}

/// A SINUMERIK program of lines on a bowl, the tool square to it but for a lean; F makes a line of
/// 1 mm take 20 ticks.
std::string bowl_program(double length) {
    std::string text = "T1 D1 M6\nS10000 M3\nTRAORI\nG54 ORIVECT\nG0 X60 Y0 Z100 A3=-0.4 C3=1\n";
    constexpr double kWay = 40'000;  // mm, in all
    const auto count = static_cast<int>(kWay / length);
    char line[160];
    for (int i = 0; i < count; ++i) {
        // To and fro: axes with limits do not turn without end.
        const double around = 2.8 * std::asin(std::sin(i * length / 170));
        const double radius = 60 + 10 * std::sin(0.13 * around);
        const double x = radius * std::cos(around), y = radius * std::sin(around);
        std::snprintf(line, sizeof line, "N%d G1 X%.4f Y%.4f Z%.4f A3=%.8f B3=%.8f C3=1 F3000\n", i,
                      x, y, 0.004 * radius * radius, -0.4 * std::cos(around),
                      -0.4 * std::sin(around));
        text += line;
    }
    return text + "M30\n";
}

/// What the rooms have to say, at the end.
int verdict(const kadr::DiagnosticList& sink, const kadr::Sources& sources) {
    for (const kadr::Diagnostic& diagnostic : sink.all()) {
        std::fputs(kadr::render_text(diagnostic, sources).c_str(), stderr);
    }
    return sink.has_errors() ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
    const auto argument = [&](int i) { return std::string(i < argc ? argv[i] : ""); };
    kadr::Sources sources;
    kadr::DiagnosticList sink;
    const auto machine =
        kadr::machine::load_machine(KADR_ROOT "/bench/machine.xml", {}, sources, sink);
    if (!machine) return verdict(sink, sources);
    if (argument(1) == "read" || argument(1) == "interpret") {
        const auto dialect =
            kadr::nc::load_dialect(argument(3), {KADR_ROOT "/dialects"}, sources, sink);
        const auto file = kadr::read_file(argument(2));
        if (!dialect || !file) return 1 | verdict(sink, sources);
        WholeText text(*file);
        kadr::nc::Reader reader(*dialect, text, argument(2), sink);
        if (argument(1) == "read") {
            drain(reader);
        } else {
            kadr::interp::Interpreter interpreter(*dialect, *machine, reader, &reader, nullptr, {},
                                                  sink);
            drain(interpreter);
        }
        return verdict(sink, sources);
    }
    kadr::motion::PlannerOptions options;
    if (argument(1) == "plan") {
        options.lookahead = std::strtoul(argument(2).c_str(), nullptr, 10);
        kadr::machine::Machine moved = *machine;
        if (argument(3) == "smooth") {
            for (auto& axis : moved.axes) axis.jerk = 20 * axis.acceleration;
        }
        const bool is_circles = argument(3) == "circles";
        MadeCommands commands(is_circles ? fast_circle : short_line,
                              is_circles ? 10'000 : 1'000'000);
        kadr::motion::Planner planner(commands, moved, options, sink);
        drain(planner);
        return verdict(sink, sources);
    }
    if (argument(1) == "sample") {
        const bool is_arcs = argument(2) == "arcs", is_helices = argument(2) == "helices";
        MadeCommands commands(is_arcs ? circle : is_helices ? helix : long_line, 3000);
        kadr::motion::Planner planner(commands, *machine, options, sink);
        kadr::motion::Sampler sampler(planner, *machine, 0);
        drain(sampler);
        return verdict(sink, sources);
    }
    if (argument(1) == "five_axis") {
        const auto turning = kadr::machine::load_machine(
            argument(2), {KADR_ROOT "/runtime/machines"}, sources, sink);
        const auto dialect =
            kadr::nc::load_dialect("sinumerik", {KADR_ROOT "/dialects"}, sources, sink);
        if (!turning || !dialect) return 1 | verdict(sink, sources);
        const std::string program = bowl_program(std::strtod(argument(3).c_str(), nullptr));
        WholeText text(program);
        kadr::nc::Reader reader(*dialect, text, "bowl.mpf", sink);
        kadr::interp::Interpreter interpreter(*dialect, *turning, reader, &reader, nullptr, {},
                                              sink);
        kadr::motion::Planner planner(interpreter, *turning, options, sink);
        kadr::motion::Sampler sampler(planner, *turning, 0);
        drain(sampler);
        return verdict(sink, sources);
    }
    std::fputs("usage: bench_runtime read|interpret|plan|sample|five_axis …\n", stderr);
    return 2;
}
