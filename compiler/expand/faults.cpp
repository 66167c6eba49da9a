// faults.cpp — errors of a running program: the location, the reason, and who called whom.
#include <algorithm>

#include "base/diagnostics/expand.h"
#include "expand/state.h"

namespace kadr::expand {

namespace {
// A runaway recursion has a thousand calls; both ends of the list show what happened.
constexpr std::size_t kShownCalls = 8;
}  // namespace

DiagnosticBuilder Expander::State::fault_in(const DiagnosticRow& row, std::uint32_t at,
                                            std::size_t depth) {
    if (row.severity != Severity::Warning) {
        has_failed = true;
        is_running = false;
    }
    DiagnosticBuilder builder = sink.report(row, code.locations[at]);
    std::size_t left_out = 0;
    for (std::size_t i = depth; i-- > 1;) {
        const CallFrame& frame = frames[i];
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
        builder.note(code.locations[frame.return_to - 1],
                     "`" + frame.function->name + "` was called here");
    }
    return builder;
}

DiagnosticBuilder Expander::State::fault(const DiagnosticRow& row, std::uint32_t at) {
    return fault_in(row, at, frames.size());
}

void Expander::State::fault_note(const DiagnosticRow& row, std::uint32_t at,
                                 const std::string& text) {
    fault_in(row, at, frames.size()).arg(text);
}

void Expander::State::math_fault(sema::MathFault why, std::uint32_t at) {
    fault(diag::CalculationFault, at).arg(sema::describe(why));
}

void Expander::State::not_given(std::string_view name, std::uint32_t at) {
    if (name.starts_with("position.")) {
        std::string axis(name.substr(9, 1));
        axis[0] = static_cast<char>(axis[0] - 'a' + 'A');
        // A cycle that starts where the tool is: its caller has to know where that is.
        const CallFrame& frame = frames.back();
        const bool is_callers = frames.size() > 1 && frame.return_to > 0 &&
                                frame.function->kind == sema::FunctionKind::Cycle;
        const std::uint32_t index = is_callers ? frame.return_to - 1 : at;
        DiagnosticBuilder builder =
            fault_in(diag::PlaceUnknown, index, frames.size() - (is_callers ? 1 : 0));
        builder.arg(axis);
        if (is_callers)
            builder.note(code.locations[at], "`" + frame.function->name + "` needs it here");
        const auto* const found = std::ranges::find(kAxisNames, axis);
        if (found != kAxisNames.end())
            report_lost_position(builder, static_cast<std::size_t>(found - kAxisNames.begin()));
        builder.fix("move the axis first, for example `G0 " + axis + "50`");
        return;
    }
    fault(diag::ValueNotGiven, at)
        .arg(name.empty() ? std::string_view("the value of this word") : name);
}

void Expander::State::half_given(std::int32_t missing, std::int32_t given, std::uint32_t at) {
    fault(diag::ValueNotGiven, at)
        .arg(code.texts[static_cast<std::size_t>(missing)])
        .note("but `" + code.texts[static_cast<std::size_t>(given)] + "` is")
        .fix("give it, with 0 where it changes nothing");
}

void Expander::State::form_fault(unsigned needed, std::uint32_t at) {
    static constexpr std::string_view kForms[] = {"per time", "per revolution", "of the spindle",
                                                  "of cutting"};
    fault(diag::FormWrong, at).arg(kForms[needed & 3u]).arg(kForms[(needed & 3u) ^ 1u]);
}

void Expander::State::index_fault(std::int64_t index, std::int64_t count, std::uint32_t at,
                                  std::string_view whole) {
    fault(diag::IndexFault, at).arg(index).arg(whole).arg(count);
}

void Expander::State::contract_failed(const Instruction& instruction, const Slot* registers,
                                      std::uint32_t at) {
    const bool has_text = instruction.b == 0;
    const std::string& condition =
        code.texts[static_cast<std::size_t>(instruction.immediate.pair.first)];
    const std::string text = has_text ? heap.text(registers[instruction.a].integer)
                                      : "`" + condition + "` does not hold";
    if (instruction.op == OpCode::AssertFailed) {
        fault(diag::AssertFailed, at).arg(text);
        return;
    }
    // A contract is broken by the caller: the message stands at the call.
    const CallFrame& frame = frames.back();
    const bool is_called = frames.size() > 1 && frame.return_to > 0;
    if (!is_called) {
        fault(diag::RequireFailed, at).arg(text);
        return;
    }
    const SourceRange contract = code.locations[at];
    fault_in(diag::RequireFailed, frame.return_to - 1, frames.size() - 1)
        .arg(text)
        .note(contract, "`" + frame.function->name + "` requires this");
}

void Expander::State::keep_trace(std::uint32_t at, unsigned depth, SourceId source) {
    if (!recordings.empty()) return;  // a block of a contour is none of the output
    BlockOrigin trace;
    trace.statement = source.is_valid() && source.index < code.statements.size()
                          ? code.statements[source.index]
                          : code.locations[at];
    for (std::size_t i = 1; i < frames.size(); ++i) {
        if (frames[i].return_to == 0) continue;
        trace.calls.push_back(
            {code.locations[frames[i].return_to - 1], frames[i].function->name, frames[i].loops});
    }
    const std::size_t loops = frames.back().loops + depth;
    trace.loop_counts.assign(
        loop_counts.begin(),
        loop_counts.begin() + static_cast<std::ptrdiff_t>(std::min(loops, loop_counts.size())));
    traces.push_back(std::move(trace));
}

}  // namespace kadr::expand
