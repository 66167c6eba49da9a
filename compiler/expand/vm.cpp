// vm.cpp — the instructions.
//
// Each handler jumps straight to the next one: a table of label addresses, which GCC and Clang know
// and the standard does not, is a quarter faster here than a switch, whose one indirect jump all
// instructions share. Such a jump runs no destructors, so a handler has no variables that need one:
// what does is a function of its own.
//
// One function, because a jump from handler to handler stays inside of one; its chapters are the
// files in vm/.
#include "expand/vm.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/diagnostics/expand.h"
#include "base/text.h"
#include "expand/block_values.h"
#include "expand/blocks.h"
#include "expand/contour_recording.h"
#include "expand/contours.h"
#include "expand/corners.h"
#include "expand/curves.h"
#include "expand/cycles.h"
#include "expand/faults.h"
#include "expand/follow.h"
#include "expand/frame_blocks.h"
#include "expand/native_cycles.h"
#include "expand/running.h"
#include "expand/scopes.h"
#include "expand/tests.h"
#include "expand/text_format.h"
#include "expand/values.h"
#include "sema/arithmetic.h"

namespace kadr::expand {

using sema::is_given;
using sema::Math;
using sema::MathFault;
using sema::Rounding;
using sema::SlotKind;

namespace {

constexpr auto kNumberSlot = static_cast<unsigned>(SlotKind::Number);

/// `sign`, `min`, `max`; `abs` may overflow and stands at its instruction.
std::int64_t integer_math(Math function, std::int64_t a, std::int64_t b) {
    switch (function) {
        case Math::Sign: return (a > 0) - (a < 0);
        case Math::Min: return std::min(a, b);
        default: return std::max(a, b);
    }
}

}  // namespace

void report_end(Running& run, std::uint32_t at) {
    if (run.budget.was_stopped()) {
        fault(run, diag::EvaluationStopped, at);
        return;
    }
    fault(run, diag::TimeLimit, at)
        .arg(run.options.limits.seconds)
        .fix("if it is to work longer, raise the limit: `--max-time`");
}

namespace {

/// Few passes can make very much: texts and arrays that are copied look at the clock, too.
bool collect_in_time(Running& run, const Slot* registers) {
    collect_garbage(run, registers);
    return !run.budget.look_for_end();
}

}  // namespace

// One line of the dispatch table and one label for each row of opcodes.def.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"

// Without kWatch nothing of this is there.
#define KADR_LOOK                                                            \
    if constexpr (kWatch) {                                                  \
        if (starts[AT] != 0) {                                               \
            run.vm.pc = AT;                                                  \
            const auto answer = run.options.watch->comes_to(starts[AT] - 1); \
            if (answer == StatementWatch::Answer::End) run.status.finish();  \
            if (answer != StatementWatch::Answer::GoOn) goto stop;           \
        }                                                                    \
    }
#define KADR_NEXT                                     \
    do {                                              \
        ++ip;                                         \
        KADR_LOOK                                     \
        goto* kLabels[static_cast<unsigned>(ip->op)]; \
    } while (false)
#define KADR_GO(target)                               \
    do {                                              \
        ip = program + (target);                      \
        KADR_LOOK                                     \
        goto* kLabels[static_cast<unsigned>(ip->op)]; \
    } while (false)
#define KADR_JUMP KADR_GO(ip->immediate.pair.first)
#define KADR_TURN                                                                      \
    do {                                                                               \
        if (--turns == 0 && (turns = run.budget.take_slice()) == 0) [[unlikely]]       \
            goto too_many_turns;                                                       \
        if constexpr (kTrace)                                                          \
            ++run.vm.loop_counts[run.vm.calls.back().loops +                           \
                                 static_cast<std::size_t>(ip->immediate.pair.second)]; \
    } while (false)
#define A r[ip->a]
#define B r[ip->b]
#define C r[ip->c]
#define SHORT_C static_cast<std::int16_t>(ip->c)
#define AT static_cast<std::uint32_t>(ip - program)
// The derivatives beside the registers; without kSlopes nothing of this is there.
#define SLOPE_A run.vm.slopes[static_cast<std::size_t>(r - run.vm.stack.data()) + ip->a]
#define SLOPE_B run.vm.slopes[static_cast<std::size_t>(r - run.vm.stack.data()) + ip->b]
#define SLOPE_C run.vm.slopes[static_cast<std::size_t>(r - run.vm.stack.data()) + ip->c]
#define KADR_SLOPE(formula) \
    if constexpr (kSlopes) SLOPE_A = (formula)
#define KADR_NO_SLOPES(count) \
    if constexpr (kSlopes)    \
    std::fill_n(run.vm.slopes.data() + (r - run.vm.stack.data()) + ip->a, (count), 0.0)

namespace {

/// Runs instructions until the batch is full, the program ends, or the point of a curve is there.
template <bool kTrace, bool kSlopes, bool kWatch>
void execute(Running& run) {
    static const void* const kLabels[] = {
#define KADR_OP(name, operands) &&op_##name,
#include "sema/opcodes.def"
#undef KADR_OP
    };
    const Instruction* const program = run.code.instructions.data();
    const Instruction* ip = program + run.vm.pc;
    Slot* r = run.vm.stack.data() + run.vm.calls.back().base;
    std::uint64_t turns = run.budget.turns();
    MathFault why = MathFault::Overflow;
    [[maybe_unused]] const std::uint32_t* const starts = run.code.names.starts.data();
    KADR_LOOK
    goto* kLabels[static_cast<unsigned>(ip->op)];

    // The chapters.
#include "expand/vm/arrays.inc"
#include "expand/vm/blocks.inc"
#include "expand/vm/calls.inc"
#include "expand/vm/conditions.inc"
#include "expand/vm/copying.inc"
#include "expand/vm/messages.inc"
#include "expand/vm/numbers.inc"
#include "expand/vm/texts.inc"

    // ---------------------------------------------------------------- ways out
batch_or_next:
    if (run.batch.is_full()) {
        run.vm.pc = AT + 1;
        run.budget.keep_turns(turns);
        return;
    }
    KADR_NEXT;
integer_overflow:
    fault(run, diag::IntegerOverflow, AT);
    goto stop;
division_by_zero:
    why = MathFault::DivisionByZero;
bad_math:
    math_fault(run, why, AT);
    goto stop;
bad_shift:
    fault(run, diag::ShiftFault, AT);
    goto stop;
lost_reference:
    fault(run, diag::ReferenceLost, AT);
    goto stop;
heap_beyond:
    collect_garbage(run, r);
    if (!run.vm.heap.is_beyond()) KADR_NEXT;
    if (!run.vm.heap.has_too_many_elements()) {
        constexpr std::uint64_t kMebibyte = 1u << 20;
        fault(run, diag::HeapLimit, AT)
            .arg(static_cast<std::int64_t>(run.options.limits.heap_bytes / kMebibyte));
        goto stop;
    }
text_too_long:
    fault(run, diag::ElementLimit, AT)
        .arg(static_cast<std::int64_t>(run.options.limits.array_elements));
    goto stop;
too_many_turns:
    if (run.budget.was_stopped() || run.budget.is_late()) {
        report_end(run, AT);
        goto stop;
    }
    fault(run, diag::LoopLimit, AT).arg(static_cast<std::int64_t>(run.options.limits.loop_turns));
    goto stop;
stop:
    run.vm.pc = AT;
    run.budget.keep_turns(turns);
}

#pragma GCC diagnostic pop

}  // namespace

void execute_with_slopes(Running& run, std::uint32_t from) {
    run.vm.pc = from;
    execute<false, true, false>(run);
}

std::size_t pull(Running& run, std::span<nc::Block> out) {
    run.batch.begin(out);
    if (!run.status.is_running() || run.batch.is_full()) return run.batch.count();
    run.budget.look_early();
    if (run.options.watch != nullptr && !run.code.names.starts.empty())
        execute<true, false, true>(run);
    else if (run.options.trace) execute<true, false, false>(run);
    else execute<false, false, false>(run);
    if (!run.status.is_running() && run.batch.is_holding() && !run.status.has_failed())
        finish_corners(run);
    return run.batch.count();
}

}  // namespace kadr::expand
