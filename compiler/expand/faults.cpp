// faults.cpp — errors of a running program: the location, the reason, and who called whom.
#include "expand/faults.h"

#include <algorithm>

#include "base/diagnostics/expand.h"
#include "expand/running.h"
#include "expand/unknown.h"

namespace kadr::expand {

namespace {
// A runaway recursion has a thousand calls; both ends of the list show what happened.
constexpr std::size_t kShownCalls = 8;
}  // namespace

DiagnosticBuilder fault_in(Running& run, const DiagnosticRow& row, std::uint32_t at,
                           std::size_t depth) {
    if (row.severity != Severity::Warning) {
        run.status.fail();
    }
    DiagnosticBuilder builder = run.sink.report(row, run.code.locations[at]);
    std::size_t left_out = 0;
    for (std::size_t i = depth; i-- > 1;) {
        const CallFrame& frame = run.vm.calls[i];
        if (frame.return_to == 0 || frame.function->kind == sema::FunctionKind::Startup) continue;
        const std::size_t from_top = depth - 1 - i;
        if (from_top >= kShownCalls && i > kShownCalls) {
            ++left_out;
            continue;
        }
        if (left_out > 0) {
            builder.note("… " + std::to_string(left_out) + " more calls");
            left_out = 0;
        }
        builder.note(run.code.locations[frame.return_to - 1],
                     "`" + frame.function->name + "` was called here");
    }
    return builder;
}

DiagnosticBuilder fault(Running& run, const DiagnosticRow& row, std::uint32_t at) {
    return fault_in(run, row, at, run.vm.calls.size());
}

void fault_note(Running& run, const DiagnosticRow& row, std::uint32_t at, const std::string& text) {
    fault_in(run, row, at, run.vm.calls.size()).arg(text);
}

void note_statement(const Running& run, DiagnosticBuilder& builder, SourceId statement,
                    std::string text) {
    if (statement.is_valid() && statement.index < run.code.statements.size())
        builder.note(run.code.statements[statement.index], std::move(text));
}

void math_fault(Running& run, sema::MathFault why, std::uint32_t at) {
    fault(run, diag::CalculationFault, at).arg(sema::describe(why));
}

void not_given(Running& run, std::string_view name, std::uint32_t at) {
    if (name.starts_with("position.")) {
        std::string axis(name.substr(9, 1));
        axis[0] = static_cast<char>(axis[0] - 'a' + 'A');
        // A cycle that starts where the tool is: its caller has to know where that is.
        const CallFrame& frame = run.vm.calls.back();
        const bool is_callers = run.vm.calls.size() > 1 && frame.return_to > 0 &&
                                frame.function->kind == sema::FunctionKind::Cycle;
        const std::uint32_t index = is_callers ? frame.return_to - 1 : at;
        DiagnosticBuilder builder =
            fault_in(run, diag::PlaceUnknown, index, run.vm.calls.size() - (is_callers ? 1 : 0));
        builder.arg(axis);
        if (is_callers)
            builder.note(run.code.locations[at], "`" + frame.function->name + "` needs it here");
        const auto* const found = std::ranges::find(kAxisNames, axis);
        if (found != kAxisNames.end())
            report_lost_position(run, builder,
                                 static_cast<std::size_t>(found - kAxisNames.begin()));
        builder.fix("move the axis first, for example `G0 " + axis + "50`");
        return;
    }
    fault(run, diag::ValueNotGiven, at)
        .arg(name.empty() ? std::string_view("the value of this word") : name);
}

void half_given(Running& run, std::int32_t missing, std::int32_t given, std::uint32_t at) {
    fault(run, diag::ValueNotGiven, at)
        .arg(run.code.texts[static_cast<std::size_t>(missing)])
        .note("but `" + run.code.texts[static_cast<std::size_t>(given)] + "` is")
        .fix("give it, with 0 where it changes nothing");
}

void form_fault(Running& run, unsigned needed, std::uint32_t at) {
    static constexpr std::string_view kForms[] = {"per time", "per revolution", "of the spindle",
                                                  "of cutting"};
    fault(run, diag::FormWrong, at).arg(kForms[needed & 3u]).arg(kForms[(needed & 3u) ^ 1u]);
}

void index_fault(Running& run, std::int64_t index, std::int64_t count, std::uint32_t at,
                 std::string_view whole) {
    fault(run, diag::IndexFault, at).arg(index).arg(whole).arg(count);
}

void contract_failed(Running& run, const Instruction& instruction, const Slot* registers,
                     std::uint32_t at) {
    const bool has_text = instruction.b == 0;
    const std::string& condition =
        run.code.texts[static_cast<std::size_t>(instruction.immediate.pair.first)];
    const std::string text = has_text ? run.vm.heap.text(registers[instruction.a].integer)
                                      : "`" + condition + "` does not hold";
    if (instruction.op == OpCode::AssertFailed) {
        fault(run, diag::AssertFailed, at).arg(text);
        return;
    }
    // A contract is broken by the caller: the message stands at the call.
    const CallFrame& frame = run.vm.calls.back();
    const bool is_called = run.vm.calls.size() > 1 && frame.return_to > 0;
    if (!is_called) {
        fault(run, diag::RequireFailed, at).arg(text);
        return;
    }
    const SourceRange contract = run.code.locations[at];
    fault_in(run, diag::RequireFailed, frame.return_to - 1, run.vm.calls.size() - 1)
        .arg(text)
        .note(contract, "`" + frame.function->name + "` requires this");
}

}  // namespace kadr::expand
