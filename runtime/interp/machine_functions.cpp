// M functions that take the machine time, as its file tells: where they are issued, and where the
// program waits for them.
#include <cmath>

#include "base/diagnostics/iso.h"
#include "interp/block_functions.h"
#include "interp/block_words.h"
#include "interp/channel.h"
#include "interp/stages.h"

namespace kadr::interp {

using nc::Block;
using path::Op;

namespace {

using machine::FunctionTime;
using nc::Function;
using nc::parameter_of;
using path::FunctionStep;

constexpr std::int64_t kNoCode = -1;

/// The M function behind a function of a block. Those with a meaning of the control's own have the
/// same number on every control.
std::int64_t code_of(const nc::Block& block, const nc::Invocation& invocation) {
    switch (invocation.function) {
        case Function::MachineFunction:
            return count_of(block, invocation, parameter_of<Function::MachineFunction>("number"));
        case Function::SpindleCw: return 3;
        case Function::SpindleCcw: return 4;
        case Function::SpindleStop: return 5;
        case Function::CoolantMist: return 7;
        case Function::CoolantFlood: return 8;
        case Function::CoolantOff: return 9;
        default: return kNoCode;
    }
}

}  // namespace

/// What is on already need not be switched on.
bool BlockFunctions::has_changed(std::int64_t code, const Actions& actions) const {
    if (code >= 3 && code <= 5) return spindle_.commanded.mode != actions.spindle_before;
    if (code >= 7 && code <= 9) return coolant_ != actions.coolant_before;
    return true;
}

bool BlockFunctions::is_awaited(const nc::Block& block, const nc::Invocation& invocation) const {
    const machine::MachineFunction* known = machine_.find_function(code_of(block, invocation));
    return known != nullptr && known->waits;
}

void BlockFunctions::issue_functions(const nc::Block& block, const Actions& actions,
                                     MotionMoment side) {
    if (machine_.functions.empty()) return;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        const std::int64_t code = code_of(block, block.functions[i]);
        const machine::MachineFunction* known = machine_.find_function(code);
        if (known == nullptr) continue;
        const FunctionTime behind =
            side == MotionMoment::Before ? FunctionTime::BeforeMotion : FunctionTime::AfterMotion;
        FunctionStep step = known->waits ? FunctionStep::Both : FunctionStep::Issue;
        if (known->acts == FunctionTime::WithMotion) {
            if (side == MotionMoment::Behind && !known->waits) continue;
            step = side == MotionMoment::Before ? FunctionStep::Issue : FunctionStep::Await;
        } else if (known->acts != behind) {
            continue;
        }
        if (!has_changed(code, actions)) continue;
        path::MFunction& function = channel_.stages.put(path::Op::Function, block).function();
        function.code = code;
        function.step = step;
    }
}

void BlockFunctions::set_coolant(const Block& block, path::CoolantMode mode) {
    if (mode == coolant_) return;
    coolant_ = mode;
    channel_.stages.put(Op::Coolant, block).coolant().mode = mode;
}

/// What it does the machine file tells; else only its builder knows, and each is reported once.
void BlockFunctions::pass_machine_function(const Block& block, std::int64_t number) {
    if (const auto& scanner = machine_.scanner) {
        if (number == scanner->on_function || number == scanner->off_function) {
            is_scanning_ = number == scanner->on_function;
            channel_.stages.put(is_scanning_ ? Op::ScannerOn : Op::ScannerOff, block);
            return;
        }
    }
    if (machine_.find_function(number) != nullptr) return;  // it takes time, which is known
    if (!reported_.first_time(NoticeEach::MachineFunction, number)) return;
    reporter_.report(diag::MachineFunctionPassed, block, Function::MachineFunction).arg(number);
}

}  // namespace kadr::interp
