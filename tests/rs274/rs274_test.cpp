// Kadr's reader and interpreter against LinuxCNC's: programs/*.ngc are read and interpreted, and
// every command is held against what rs274 made of the same text (expected/*.jsonl). LinuxCNC is
// not needed; record.py has asked it. README.md explains the neutral form.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/disk_files.h"
#include "base/render.h"
#include "base/text.h"
#include "driver/cycles.h"
#include "interp/interpreter.h"
#include "machine/machine.h"
#include "nc/reader.h"
#include "tests/common/inputs.h"

namespace rs274_test {

namespace {

using kadr::path::Command;
using kadr::path::Op;

const std::string kFolder = KADR_ROOT "/tests/rs274/";

// rs274's doubles went through inches once; anything above is a different opinion.
constexpr double kTolerance = 1e-6;

/// One command in the neutral form of both sides. What an op does not have stays empty.
struct Step {
    std::string op{};
    std::uint32_t line = 0;
    std::vector<double> to{};      // X Y Z, A B C if the program has rotary axes
    bool is_machine = false;       // `to` is in machine coordinates
    std::vector<double> values{};  // feed, or what the op is about
    std::vector<double> center{};  // of an arc, the two coordinates in its plane
    std::string words{};           // feed mode, plane, direction … as text
};

std::string shown(const Step& step) {
    std::ostringstream out;
    out << "line " << step.line << ": " << step.op;
    for (double value : step.to) out << ' ' << value;
    if (step.is_machine) out << " machine";
    if (!step.center.empty()) out << " about " << step.center[0] << ' ' << step.center[1];
    for (double value : step.values) out << ' ' << value;
    if (!step.words.empty()) out << ' ' << step.words;
    return out.str();
}

bool is_near(const std::vector<double>& a, const std::vector<double>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double left, double right) {
        return std::abs(left - right) <= kTolerance;
    });
}

/// Spindle and coolant are told with the next command that takes time, so their line is not
/// compared: what matters is the state in which a motion runs.
bool is_same(const Step& a, const Step& b) {
    const bool is_state = a.op == "spindle" || a.op == "coolant";
    return a.op == b.op && (is_state || a.line == b.line) && a.is_machine == b.is_machine &&
           a.words == b.words && is_near(a.to, b.to) && is_near(a.values, b.values) &&
           is_near(a.center, b.center);
}

/// Coordinates of a plane as indices into X Y Z.
std::pair<std::size_t, std::size_t> plane_axes(std::string_view plane) {
    if (plane == "ZX") return {2, 0};
    if (plane == "YZ") return {1, 2};
    return {0, 1};
}

// ---------------------------------------------------------------- what LinuxCNC said

Step recorded_step(const nlohmann::json& json) {
    Step step;
    step.op = json.at("op");
    step.line = json.at("iso");
    if (json.contains("to")) {
        for (const char* axis : {"X", "Y", "Z", "A", "B", "C"}) {
            if (json["to"].contains(axis)) step.to.push_back(json["to"][axis]);
        }
    }
    step.is_machine = json.value("machine_coordinates", false);
    for (const char* name : {"feed", "sweep", "time", "tool", "length", "speed", "cutting_speed"}) {
        if (json.contains(name)) step.values.push_back(json[name]);
    }
    for (const char* name : {"feed_mode", "plane", "dir", "mode"}) {
        if (json.contains(name)) step.words += json[name].get<std::string>() + ' ';
    }
    if (json.contains("center")) {
        const auto [first, second] = plane_axes(json["plane"].get<std::string>());
        step.center = {json["center"][first], json["center"][second]};
    }
    if (json.value("exact_stop", false)) step.words += "exact_stop ";
    if (json.contains("cutting_speed")) step.words += "cutting_speed ";
    return step;
}

std::vector<Step> recorded_steps(const std::string& name) {
    std::vector<Step> steps;
    const auto text = kadr::read_file(kFolder + "expected/" + name + ".jsonl");
    if (!text) return steps;
    std::istringstream lines(*text);
    for (std::string line; std::getline(lines, line);) {
        steps.push_back(recorded_step(nlohmann::json::parse(line)));
    }
    return steps;
}

// ---------------------------------------------------------------- what Kadr says

class WholeText final : public kadr::nc::TextSource {
  public:
    explicit WholeText(std::string_view text) : text_(text) {}
    std::string_view next() override { return std::exchange(text_, {}); }

  private:
    std::string_view text_;
};

const char* feed_mode_name(kadr::path::FeedMode mode) {
    switch (mode) {
        case kadr::path::FeedMode::PerMinute: return "";
        case kadr::path::FeedMode::PerRevolution: return "per_revolution ";
        case kadr::path::FeedMode::InverseTime: return "inverse_time ";
    }
    return "?";
}

const char* plane_name(kadr::path::Plane plane) {
    switch (plane) {
        case kadr::path::Plane::Xy: return "XY";
        case kadr::path::Plane::Zx: return "ZX";
        case kadr::path::Plane::Yz: return "YZ";
    }
    return "?";
}

const char* spindle_name(kadr::path::SpindleMode mode) {
    switch (mode) {
        case kadr::path::SpindleMode::Stop: return "stop";
        case kadr::path::SpindleMode::Cw: return "cw";
        case kadr::path::SpindleMode::Ccw: return "ccw";
        case kadr::path::SpindleMode::Orient: return "orient";
    }
    return "?";
}

const char* coolant_name(kadr::path::CoolantMode mode) {
    switch (mode) {
        case kadr::path::CoolantMode::Off: return "off";
        case kadr::path::CoolantMode::Flood: return "flood";
        case kadr::path::CoolantMode::Mist: return "mist";
    }
    return "?";
}

/// Brings Kadr's commands into the neutral form: spindle and coolant when something happens under
/// a new state, motions of no length left out, everything behind the end forgotten.
class Reduction {
  public:
    Reduction(bool has_rotary, bool shows_exact_stop)
        : axes_(has_rotary ? 6 : 3), shows_exact_stop_(shows_exact_stop) {}

    void take(const Command& command) {
        switch (command.op()) {
            case Op::Rapid: motion(command, "rapid"); break;
            case Op::Line: motion(command, "line"); break;
            case Op::Arc: motion(command, "arc"); break;
            case Op::Dwell: report(command, "dwell", {command.dwell().time}); break;
            case Op::Tool:
                report(command, "tool", {static_cast<double>(command.tool().number)});
                break;
            case Op::ToolLength:
                length_ = command.tool_length().length;
                report(command, "tool_length", {command.tool_length().length});
                break;
            case Op::Stop: report(command, "stop", {}); break;
            case Op::OptionalStop: report(command, "optional_stop", {}); break;
            case Op::End: report(command, "end", {}); break;
            case Op::ScannerOn:
            case Op::ScannerOff:
            case Op::External: ADD_FAILURE() << "no machine here has a scanner"; break;
            case Op::Function:
                ADD_FAILURE() << "no machine here has functions that take time";
                break;
            case Op::OtherSpindle: ADD_FAILURE() << "no machine here has two spindles"; break;
            case Op::Spindle:
                spindle_ = {.op = "spindle", .words = spindle_name(command.spindle().mode)};
                spindle_.words += ' ';
                if (command.spindle().mode == kadr::path::SpindleMode::Stop) break;
                spindle_.values = {command.spindle().speed};
                if (command.spindle().has_cutting_speed) spindle_.words += "cutting_speed ";
                break;
            case Op::Coolant:
                coolant_ = {.op = "coolant", .words = coolant_name(command.coolant().mode)};
                coolant_.words += ' ';
                break;
            case Op::SpeedLimit:
            case Op::Message:
            case Op::Spline:
            case Op::Involute:
            case Op::Parametric:
            case Op::Thread:
            case Op::Probe: break;  // rs274 says nothing about them
        }
    }

    std::vector<Step> steps;

  private:
    void report(const Command& command, const char* op, std::vector<double> values) {
        Step step{.op = op, .line = command.line, .values = std::move(values)};
        add(std::move(step));
    }

    void motion(const Command& command, const char* op) {
        Step step{.op = op, .line = command.line};
        step.to.assign(command.motion().to.begin(), command.motion().to.begin() + axes_);
        step.is_machine = command.motion().machine_coordinates;
        std::vector<double> slides = step.to;
        if (!step.is_machine) slides[2] += length_;
        const bool is_empty =
            command.op() != Op::Arc && !slides_.empty() && is_near(slides, slides_);
        slides_ = std::move(slides);
        if (is_empty) return;
        if (command.op() != Op::Rapid) {
            step.values.push_back(command.motion().feed);
            step.words += feed_mode_name(command.motion().feed_mode);
        }
        if (command.op() == Op::Arc) {
            const auto [first, second] = plane_axes(plane_name(command.motion().plane));
            step.center = {command.motion().arc().center[static_cast<Eigen::Index>(first)],
                           command.motion().arc().center[static_cast<Eigen::Index>(second)]};
            step.values.push_back(command.motion().arc().sweep);
            step.words += plane_name(command.motion().plane);
            step.words += command.motion().arc().is_clockwise ? " cw " : " ccw ";
        }
        if (shows_exact_stop_ && command.motion().exact_stop && command.op() != Op::Rapid) {
            step.words += "exact_stop ";
        }
        add(std::move(step));
    }

    void add(Step step) {
        for (auto [now, told] :
             {std::pair{&spindle_, &told_spindle_}, std::pair{&coolant_, &told_coolant_}}) {
            if (is_same(*now, *told)) continue;
            *told = *now;
            steps.push_back(*now);
            steps.back().line = step.line;
        }
        steps.push_back(std::move(step));
    }

    std::ptrdiff_t axes_;
    bool shows_exact_stop_;
    double length_ = 0;
    std::vector<double> slides_;
    Step spindle_{.op = "spindle", .words = "stop "};
    Step coolant_{.op = "coolant", .words = "off "};
    Step told_spindle_ = spindle_;
    Step told_coolant_ = coolant_;
};

// ---------------------------------------------------------------- the comparison

struct Program {
    std::string name;
    std::string text;
    std::string rule;  // the first line: what the program guards

    bool says(std::string_view words) const { return rule.find(words) != std::string::npos; }
    std::string line(std::uint32_t number) const {
        std::istringstream lines(text);
        std::string result;
        for (std::uint32_t i = 0; i < number; ++i) std::getline(lines, result);
        return result;
    }
};

Program read_program(const std::string& name) {
    Program program;
    program.name = name;
    program.text = kadr::read_file(kFolder + "programs/" + name + ".ngc").value_or("");
    program.rule = program.text.substr(0, program.text.find('\n'));
    return program;
}

std::vector<std::string> program_names() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(kFolder + "programs")) {
        if (entry.path().extension() == ".ngc") names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

/// What Kadr makes of the program. Its machining cycles are those of the standard library.
std::vector<Step> interpreted_steps(const Program& program) {
    kadr::Sources sources = kadr::test::inputs().new_sources();
    kadr::DiagnosticList sink;
    std::string cycle_messages;
    kadr::driver::Messages messages(sources, {},
                                    [&](std::string_view text) { cycle_messages += text; });
    kadr::driver::Session session({}, kadr::test::inputs(), sources, messages);
    const std::string dialect_name =
        program.says("dialect fanuc") ? "fanuc" : kFolder + "linuxcnc.xml";
    const auto dialect =
        kadr::nc::load_dialect(dialect_name, {KADR_ROOT "/dialects"}, sources, sink);
    const auto machine = kadr::machine::load_machine(kFolder + "machine.xml", {}, sources, sink);
    Reduction reduction(program.text.find(" A") != std::string::npos,
                        program.text.find("G61") != std::string::npos);
    if (dialect && machine) {
        WholeText text(program.text);
        kadr::nc::Reader reader(*dialect, text, program.name + ".ngc", sink);
        kadr::interp::InterpreterOptions options;
        options.optional_stop = true;
        if (program.says("block delete on")) options.skip_levels = 0xffff;
        kadr::driver::LibraryCycles cycles(session, *dialect);
        kadr::interp::Interpreter interpreter(*dialect, *machine, reader, &reader, &cycles, options,
                                              sink);
        std::vector<Command> batch(kadr::kBatch);
        while (const std::size_t count = interpreter.pull(batch)) {
            for (std::size_t i = 0; i < count; ++i) reduction.take(batch[i]);
        }
    }
    for (const kadr::Diagnostic& diagnostic : sink.all()) {
        // The programs cut air with a standing spindle; warnings are right and of no interest.
        if (diagnostic.severity == kadr::Severity::Warning) continue;
        ADD_FAILURE() << kadr::render_text(diagnostic, sources);
    }
    EXPECT_EQ(cycle_messages, "");
    return std::move(reduction.steps);
}

class Rs274 : public ::testing::TestWithParam<std::string> {};

TEST_P(Rs274, SaysTheSame) {
    const Program program = read_program(GetParam());
    SCOPED_TRACE(program.rule);
    const std::vector<Step> expected = recorded_steps(program.name);
    ASSERT_FALSE(expected.empty()) << "not recorded yet: run tests/rs274/record.py";
    const std::vector<Step> actual = interpreted_steps(program);
    const Step nothing{.op = "nothing"};
    for (std::size_t i = 0; i < std::max(expected.size(), actual.size()); ++i) {
        const Step& left = i < expected.size() ? expected[i] : nothing;
        const Step& right = i < actual.size() ? actual[i] : nothing;
        if (is_same(left, right)) continue;
        ADD_FAILURE() << program.line(left.line ? left.line : right.line) << "\n  rs274 "
                      << shown(left) << "\n  Kadr  " << shown(right);
        break;  // what follows is out of step
    }
}

INSTANTIATE_TEST_SUITE_P(Programs, Rs274, ::testing::ValuesIn(program_names()),
                         [](const auto& program) { return program.param; });

}  // namespace

}  // namespace rs274_test
