#include "interp/interpreter.h"

#include "interp/executor.h"

namespace kadr::interp {

struct Interpreter::State {
    Executor executor;
};

Interpreter::Interpreter(const nc::Dialect& dialect, const machine::Machine& machine,
                         Stream<nc::Block>& blocks, const nc::Reader* places, CycleExpander* cycles,
                         const InterpreterOptions& options, DiagnosticSink& sink)
    : state_(new State{Executor(dialect, machine, blocks, places, cycles, options, sink)}) {}

Interpreter::~Interpreter() = default;

std::size_t Interpreter::pull(std::span<path::Command> out) { return state_->executor.pull(out); }
bool Interpreter::alarmed() const { return state_->executor.alarmed(); }
std::vector<StateItem> Interpreter::state() const { return state_->executor.state(); }
const AxisValues& Interpreter::position() const { return state_->executor.position(); }
std::uint64_t Interpreter::blocks() const { return state_->executor.blocks(); }

}  // namespace kadr::interp
