// property_bench.h — what the properties of random programs share: running texts and blocks on a
// machine, writing what was run, and showing commands as texts can say them.
#pragma once

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include <rapidcheck.h>

#include "base/numbers.h"
#include "macro/program.h"
#include "tests/interp/bench.h"
#include "tests/nc/nc_testing.h"
#include "write/writer.h"

namespace kadr::control_testing {

using nc::Block;
using nc::Function;
using path::Command;

/// Keeps the blocks that pass.
class Recorder final : public Stream<Block> {
  public:
    Recorder(Stream<Block>& blocks, std::vector<Block>& kept) : blocks_(blocks), kept_(kept) {}
    std::size_t pull(std::span<Block> out) override {
        const std::size_t count = blocks_.pull(out);
        kept_.insert(kept_.end(), out.begin(), out.begin() + static_cast<std::ptrdiff_t>(count));
        return count;
    }

  private:
    Stream<Block>& blocks_;
    std::vector<Block>& kept_;
};

struct Ran {
    std::vector<Command> commands;
    std::vector<Block> blocks;
    std::vector<macro::ControlVariable> variables;
};

/// Wide enough for any program, its zero where the workpiece's is.
inline const machine::Machine& wide_mill() {
    static const machine::Machine kMachine = [] {
        machine::Machine machine = interp::mill();
        for (machine::MachineAxis& axis : machine.axes) {
            axis.lower = -1e6;
            axis.upper = 1e6;
        }
        machine.work_offsets = {{}, {}};
        for (machine::ToolData& tool : machine.tools) tool.length = 0;
        return machine;
    }();
    return kMachine;
}

inline void assert_no_errors(const DiagnosticList& messages) {
    for (const Diagnostic& message : messages.all()) {
        if (message.severity == Severity::Warning) continue;
        RC_FAIL(std::string(message.row->code) + ' ' + message.message() +
                (message.line ? " in line " + std::to_string(message.line->line) : ""));
    }
}

inline std::vector<Command> commands_of(interp::Interpreter& interpreter) {
    std::vector<Command> commands;
    std::vector<Command> batch(16);
    while (const std::size_t count = interpreter.pull(batch)) {
        commands.insert(commands.end(), batch.begin(),
                        batch.begin() + static_cast<std::ptrdiff_t>(count));
    }
    return commands;
}

inline Ran run_text(const nc::Dialect& dialect, const std::string& text) {
    RC_LOG() << "---- " << dialect.name() << '\n' << text;
    DiagnosticList messages;
    nc::testing::OneText source(text);
    macro::NcProgram program(dialect, source, "test", {}, messages);
    Ran ran;
    Recorder blocks(program, ran.blocks);
    interp::Interpreter interpreter(dialect, wide_mill(), blocks, &program, nullptr, {}, messages);
    program.follow(interpreter);
    ran.commands = commands_of(interpreter);
    ran.variables = program.variables();
    assert_no_errors(messages);
    return ran;
}

inline std::vector<Command> run_blocks(const nc::Dialect& dialect,
                                       const std::vector<Block>& blocks) {
    DiagnosticList messages;
    interp::BlockList source(blocks);
    interp::Interpreter interpreter(dialect, wide_mill(), source, nullptr, nullptr, {}, messages);
    std::vector<Command> commands = commands_of(interpreter);
    assert_no_errors(messages);
    return commands;
}

inline double way(const AxisValues& from, const AxisValues& to) {
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i) longest = std::max(longest, std::abs(to[i] - from[i]));
    return longest;
}

/// What the writer makes of blocks that a control executed.
inline std::string written(const nc::Dialect& dialect, const std::vector<Block>& blocks) {
    DiagnosticList messages;
    write::Writer writer(dialect, {.number_blocks = false}, messages);
    std::string text;
    writer.begin({"random", 1, "", false}, text);
    for (const Block& block : blocks) writer.write(block, text);
    writer.end(text);
    assert_no_errors(messages);
    return text;
}

/// The lines that a text begins with: they set the state from which its blocks go on.
inline std::vector<Block> head_of(const nc::Dialect& dialect) {
    DiagnosticList messages;
    write::Writer writer(dialect, {.number_blocks = false}, messages);
    std::string text;
    writer.begin({"random", 1, "", false}, text);
    writer.write({}, text);  // the modal words come with the first block
    return nc::testing::read_blocks(dialect, text).blocks;
}

/// A command as the listing shows it, its numbers within the text's formats.
inline std::string listed(const std::vector<Command>& commands) {
    std::string out;
    interp::Listing listing(wide_mill());
    AxisValues at{};
    for (Command command : commands) {
        const bool is_still = command.is_motion() && command.op() != path::Op::Arc &&
                              way(at, command.motion().to) < 1e-6;
        if (command.is_motion()) at = command.motion().to;
        if (is_still) continue;
        command.line = 0;
        if (command.is_motion())
            for (double& value : command.motion().to) value = round_to(value, 3) + 0.0;
        if (command.op() == path::Op::Arc)
            for (double& value : command.motion().arc().center) value = round_to(value, 3) + 0.0;
        listing.append(command, {}, out);
    }
    return out;
}

/// From the whole range in every case: small programs come by themselves.
inline int whole(int low, int high) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1));
}
inline bool maybe() { return whole(0, 1) == 1; }

/// A function with its first arguments.
inline void add(Block& block, Function function, std::initializer_list<double> arguments = {}) {
    nc::Invocation* invocation = block.add(function, nc::info(function).parameters.size());
    std::size_t i = 0;
    for (const double value : arguments) block.set_argument(*invocation, i++, value);
}

}  // namespace kadr::control_testing
