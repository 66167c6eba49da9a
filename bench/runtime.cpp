// runtime.cpp — what the rooms of the runtime cost, each by itself and inside one process.
//
//   bench_runtime read FILE DIALECT         text → blocks
//   bench_runtime interpret FILE DIALECT    text → blocks → commands
//   bench_runtime plan DEPTH [smooth|circles]
//                                           commands → segments, look-ahead DEPTH; under a limit of
//                                           the jerk; circles at the limits of the axes
//   bench_runtime sample lines|arcs|helices segments → setpoints
//   bench_runtime curves KIND [whole]       segments → setpoints along cspline, bspline, nurbs,
//   poly
//                                           or involute; `whole`: text → setpoints
//   bench_runtime five_axis MACHINE LENGTH  text → setpoints under the transformation of a stock
//                                           machine, lines of LENGTH mm with a vector each
//
// Prints `items seconds`: how many came out, and the CPU time of the process for them.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/disk_files.h"
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
    command.become(kadr::path::Op::Line);
    command.motion().to = {100 * std::cos(angle), 100 * std::sin(angle), 0};
    command.motion().moved = kadr::kLinearXYZ;
    command.motion().feed = 6000;
}

/// Lines of 100 mm back and forth: the sampler has nearly all the work.
void long_line(Command& command, std::uint64_t i) {
    command.become(kadr::path::Op::Line);
    command.motion().to = {i % 2 == 0 ? 100.0 : 0.0, i % 2 == 0 ? 50.0 : 0.0, 0};
    command.motion().moved = kadr::kLinearXYZ;
    command.motion().feed = 6000;
}

/// Full circles of 20 mm radius; helices climb and fall 5 mm a turn.
void circle(Command& command, std::uint64_t i) {
    static_cast<void>(i);
    command.become(kadr::path::Op::Arc);
    command.motion().to = {};
    command.motion().arc().center = {20, 0, 0};
    command.motion().arc().normal = kadr::path::Vec3::UnitZ();
    command.motion().arc().sweep = 2 * std::numbers::pi;
    command.motion().moved = kadr::kLinearXYZ;
    command.motion().feed = 6000;
}
/// At a feed that the axes do not reach on them: planned in cells.
void fast_circle(Command& command, std::uint64_t i) {
    circle(command, i);
    command.motion().feed = 60000;
}
void helix(Command& command, std::uint64_t i) {
    circle(command, i);
    command.motion().to[2] = i % 2 == 0 ? 5.0 : 0.0;
    command.motion().arc().center[2] = i % 2 == 0 ? 0.0 : 5.0;
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

/// Places on a closed wave in space, about `kStep` mm apart.
constexpr double kStep = 5;
kadr::path::Vec3 on_wave(int i) {
    const double around = i * kStep / 90;
    const double radius = 80 + 12 * std::cos(5 * around);
    return {radius * std::cos(around), radius * std::sin(around), 8 * std::sin(3 * around)};
}

/// A program of one kind of curve, 40 m long, in the language that has it.
struct CurveProgram {
    std::string text;
    std::string dialect = "sinumerik";
};

CurveProgram curve_program(const std::string& kind) {
    constexpr int kCount = 8000;
    CurveProgram program;
    program.text = "T1 D1 M6\nS10000 M3\nG64 G0 X92 Y0 Z0\nG1 F6000\n";
    if (kind == "nurbs") {
        program.dialect = "fanuc";
        program.text = "%\nO0001\nG05.1Q1\nG01X92.Y0.Z0.M3S500F6000\n";
    }
    char line[160];
    for (int i = 0; i < kCount; ++i) {
        const kadr::path::Vec3 at = on_wave(i), next = on_wave(i + 1) - at;
        if (kind == "nurbs") {
            // Knots of order 4: four at the beginning, four at the end.
            const int knot = std::max(0, i - 3);
            std::snprintf(line, sizeof line, "%sK%d.X%.4fY%.4fZ%.4fR%.2f\n",
                          i == 0 ? "G06.2P4" : "", knot, at.x(), at.y(), at.z(),
                          i % 2 == 0 ? 1.0 : 1.2);
        } else if (kind == "poly") {
            std::snprintf(line, sizeof line,
                          "POLY PO[X]=(%.4f,%.4f) PO[Y]=(%.4f,%.4f) PO[Z]=(%.4f,0.2,-0.2)\n",
                          at.x() + next.x(), next.y() / 8, at.y() + next.y(), -next.x() / 8,
                          at.z() + next.z());
        } else if (kind == "involute") {
            std::snprintf(
                line, sizeof line, "%s\n",
                i % 2 == 0 ? "INVCCW AR=120 I-20 J0 CR=8" : "INVCW X20 Y0 I=AC(0) J=AC(0) CR=8");
            if (i == 0) program.text += "X20 Y0\n";
        } else {
            std::snprintf(line, sizeof line, "%s X%.4f Y%.4f Z%.4f\n",
                          i > 0               ? ""
                          : kind == "bspline" ? "BSPLINE SD=3"
                                              : "CSPLINE",
                          at.x() + next.x(), at.y() + next.y(), at.z() + next.z());
        }
        program.text += line;
    }
    if (kind == "nurbs") {
        for (int i = 0; i < 4; ++i) program.text += "K" + std::to_string(kCount - 3) + ".\n";
        program.text += "G01X92.\n";
    }
    program.text += "M30\n";
    return program;
}

/// Motion that is planned already.
class PlannedBefore final : public kadr::Stream<kadr::motion::Segment> {
  public:
    explicit PlannedBefore(kadr::Stream<kadr::motion::Segment>& from) {
        std::vector<kadr::motion::Segment> batch(kadr::kBatch);
        while (const std::size_t count = from.pull(batch))
            segments_.insert(segments_.end(), batch.begin(),
                             batch.begin() + static_cast<std::ptrdiff_t>(count));
    }

    std::size_t pull(std::span<kadr::motion::Segment> out) override {
        const std::size_t count = std::min(out.size(), segments_.size() - next_);
        for (std::size_t i = 0; i < count; ++i) out[i] = segments_[next_ + i];
        next_ += count;
        return count;
    }

  private:
    std::vector<kadr::motion::Segment> segments_;
    std::size_t next_ = 0;
};

/// What every room of the bench works with.
struct Bench {
    kadr::Sources sources;
    kadr::DiagnosticList sink;
    std::vector<std::string> arguments;

    std::string argument(std::size_t i) const {
        return i < arguments.size() ? arguments[i] : std::string();
    }
    std::optional<kadr::machine::Machine> machine(const std::string& name) {
        return kadr::machine::load_machine(name, {KADR_ROOT "/runtime/machines"}, sources, sink);
    }
    std::optional<kadr::machine::Machine> own_machine() {
        return machine(KADR_ROOT "/bench/machine.xml");
    }
    auto dialect(const std::string& name) {
        return kadr::nc::load_dialect(name, {KADR_ROOT "/dialects"}, sources, sink);
    }
};

bool read(Bench& bench) {
    const auto machine = bench.own_machine();
    const auto dialect = bench.dialect(bench.argument(2));
    const auto file = kadr::read_file(bench.argument(1));
    if (!machine || !dialect || !file) return false;
    WholeText text(*file);
    kadr::nc::Reader reader(*dialect, text, bench.argument(1), bench.sink);
    if (bench.argument(0) == "read") {
        drain(reader);
        return true;
    }
    kadr::interp::Interpreter interpreter(*dialect, *machine, reader, &reader, nullptr, {},
                                          bench.sink);
    drain(interpreter);
    return true;
}

bool plan(Bench& bench) {
    auto machine = bench.own_machine();
    if (!machine) return false;
    kadr::motion::PlannerOptions options;
    options.lookahead = std::strtoul(bench.argument(1).c_str(), nullptr, 10);
    if (bench.argument(2) == "smooth") {
        for (auto& axis : machine->axes) axis.jerk = 20 * axis.acceleration;
    }
    const bool is_circles = bench.argument(2) == "circles";
    MadeCommands commands(is_circles ? fast_circle : short_line, is_circles ? 10'000 : 1'000'000);
    kadr::motion::Planner planner(commands, *machine, options, bench.sink);
    drain(planner);
    return true;
}

bool sample(Bench& bench) {
    const auto machine = bench.own_machine();
    if (!machine) return false;
    const std::string kind = bench.argument(1);
    MadeCommands commands(kind == "arcs" ? circle : kind == "helices" ? helix : long_line, 3000);
    kadr::motion::Planner planner(commands, *machine, {}, bench.sink);
    kadr::motion::Sampler sampler(planner, *machine, 0);
    drain(sampler);
    return true;
}

/// A program of the control, from its text on, or its motion alone.
bool execute(Bench& bench, const CurveProgram& program, const kadr::machine::Machine& machine,
             bool from_text) {
    const auto dialect = bench.dialect(program.dialect);
    if (!dialect) return false;
    WholeText text(program.text);
    kadr::nc::Reader reader(*dialect, text, "bench", bench.sink);
    kadr::interp::Interpreter interpreter(*dialect, machine, reader, &reader, nullptr, {},
                                          bench.sink);
    kadr::motion::Planner planner(interpreter, machine, {}, bench.sink);
    if (from_text) {
        kadr::motion::Sampler sampler(planner, machine, 0);
        drain(sampler);
        return true;
    }
    PlannedBefore planned(planner);
    kadr::motion::Sampler sampler(planned, machine, 0);
    drain(sampler);
    return true;
}

bool curves(Bench& bench) {
    const auto machine = bench.own_machine();
    return machine &&
           execute(bench, curve_program(bench.argument(1)), *machine, bench.argument(2) == "whole");
}

bool five_axis(Bench& bench) {
    const auto machine = bench.machine(bench.argument(1));
    if (!machine) return false;
    const double length = std::strtod(bench.argument(2).c_str(), nullptr);
    return execute(bench, {.text = bowl_program(length)}, *machine, true);
}

}  // namespace

int main(int argc, char** argv) {
    Bench bench;
    bench.arguments.assign(argv + 1, argv + argc);
    const std::map<std::string, bool (*)(Bench&)> rooms = {
        {"read", read},     {"interpret", read}, {"plan", plan},
        {"sample", sample}, {"curves", curves},  {"five_axis", five_axis}};
    const auto room = rooms.find(bench.argument(0));
    if (room == rooms.end()) {
        std::fputs("usage: bench_runtime read|interpret|plan|sample|curves|five_axis …\n", stderr);
        return 2;
    }
    const bool has_run = room->second(bench);
    for (const kadr::Diagnostic& diagnostic : bench.sink.all())
        std::fputs(kadr::render_text(diagnostic, bench.sources).c_str(), stderr);
    return has_run && !bench.sink.has_errors() ? 0 : 1;
}
