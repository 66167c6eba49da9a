// vm.cpp — the instructions.
//
// Each handler jumps straight to the next one: a table of label addresses, which GCC and Clang know
// and the standard does not, is a quarter faster here than a switch, whose one indirect jump all
// instructions share. Such a jump runs no destructors, so a handler has no variables that need one:
// what does is a function of its own.
//
// One function, because a jump from handler to handler stays inside of one; its chapters are the
// files in vm/.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/assert.h"
#include "base/diagnostics/expand.h"
#include "base/text.h"
#include "expand/state.h"

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

void Expander::State::reserve_stack(std::size_t slots) {
    if (stack.size() < slots) stack.resize(std::max(slots, 2 * stack.size()));
}

/// The pass that used up a slice of them asks for the next one; it belongs to it. False: there is
/// none, or somebody wants the evaluation to end.
bool Expander::State::more_turns(std::uint64_t& turns) {
    constexpr std::uint64_t kSlice = 1u << 16;  // passes between two looks at `stop` and the clock
    if (look_for_end()) return false;
    turns = std::min(turns_reserve, kSlice);
    turns_reserve -= turns;
    return turns > 0;
}

bool Expander::State::look_for_end() {
    was_stopped = options.stop != nullptr && options.stop->load(std::memory_order_relaxed);
    is_late = options.limits.seconds > 0 &&
              std::chrono::duration<double>(Clock::now() - began).count() > options.limits.seconds;
    return was_stopped || is_late;
}

/// Reports why the evaluation ends before the program does.
void Expander::State::report_end(std::uint32_t at) {
    if (was_stopped) {
        fault(diag::EvaluationStopped, at);
        return;
    }
    fault(diag::TimeLimit, at)
        .arg(options.limits.seconds)
        .fix("if it is to work longer, raise the limit: `--max-time`");
}

/// Few passes can make very much: texts and arrays that are copied look at the clock, too.
bool Expander::State::collect_in_time(const Slot* registers) {
    collect_garbage(registers);
    return !look_for_end();
}

std::size_t Expander::State::pull(std::span<nc::Block> out) {
    if (options.trace) {
        traces.erase(traces.begin(), traces.begin() + static_cast<std::ptrdiff_t>(delivered));
        delivered = 0;
    }
    batch = out.data();
    batch_size = out.size();
    batch_count = 0;
    while (batch_count < batch_size && !waiting.empty()) {
        batch[batch_count++] = std::move(waiting.front());
        waiting.pop_front();
    }
    if (is_running && batch_count < batch_size) {
        // A slice of passes can make blocks for seconds: somebody who wants it to end is heard in
        // the next pass.
        if (options.stop != nullptr && options.stop->load(std::memory_order_relaxed))
            turns_reserve += std::exchange(turns_left, 1) - 1;
        if (options.trace) run<true, false>();
        else run<false, false>();
    }
    delivered = batch_count;
    return batch_count;
}

// One line of the dispatch table and one label for each row of opcodes.def.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"

#define KADR_NEXT goto* kLabels[static_cast<unsigned>((++ip)->op)]
#define KADR_GO(target)                               \
    do {                                              \
        ip = program + (target);                      \
        goto* kLabels[static_cast<unsigned>(ip->op)]; \
    } while (false)
#define KADR_JUMP KADR_GO(ip->immediate.pair.first)
#define KADR_TURN                                                               \
    do {                                                                        \
        if (--turns == 0 && !more_turns(turns)) [[unlikely]]                    \
            goto too_many_turns;                                                \
        if constexpr (kTrace)                                                   \
            ++loop_counts[frames.back().loops +                                 \
                          static_cast<std::size_t>(ip->immediate.pair.second)]; \
    } while (false)
#define A r[ip->a]
#define B r[ip->b]
#define C r[ip->c]
#define SHORT_C static_cast<std::int16_t>(ip->c)
#define AT static_cast<std::uint32_t>(ip - program)
// The derivatives beside the registers; without kSlopes nothing of this is there.
#define SLOPE_A slopes[static_cast<std::size_t>(r - stack.data()) + ip->a]
#define SLOPE_B slopes[static_cast<std::size_t>(r - stack.data()) + ip->b]
#define SLOPE_C slopes[static_cast<std::size_t>(r - stack.data()) + ip->c]
#define KADR_SLOPE(formula) \
    if constexpr (kSlopes) SLOPE_A = (formula)
#define KADR_NO_SLOPES(count) \
    if constexpr (kSlopes) std::fill_n(slopes.data() + (r - stack.data()) + ip->a, (count), 0.0)

template <bool kTrace, bool kSlopes>
void Expander::State::run() {
    static const void* const kLabels[] = {
#define KADR_OP(name, operands) &&op_##name,
#include "sema/opcodes.def"
#undef KADR_OP
    };
    const Instruction* const program = code.instructions.data();
    const Instruction* ip = program + pc;
    Slot* r = stack.data() + frames.back().base;
    std::uint64_t turns = turns_left;
    MathFault why = MathFault::Overflow;
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
    if (batch_count == batch_size) {
        pc = AT + 1;
        turns_left = turns;
        return;
    }
    KADR_NEXT;
integer_overflow:
    fault(diag::IntegerOverflow, AT);
    goto stop;
division_by_zero:
    why = MathFault::DivisionByZero;
bad_math:
    math_fault(why, AT);
    goto stop;
bad_shift:
    fault(diag::ShiftFault, AT);
    goto stop;
lost_reference:
    fault(diag::ReferenceLost, AT);
    goto stop;
heap_beyond:
    collect_garbage(r);
    if (!heap.is_beyond()) KADR_NEXT;
    if (!heap.has_too_many_elements()) {
        constexpr std::uint64_t kMebibyte = 1u << 20;
        fault(diag::HeapLimit, AT)
            .arg(static_cast<std::int64_t>(options.limits.heap_bytes / kMebibyte));
        goto stop;
    }
text_too_long:
    fault(diag::ElementLimit, AT).arg(static_cast<std::int64_t>(options.limits.array_elements));
    goto stop;
too_many_turns:
    if (was_stopped || is_late) {
        report_end(AT);
        goto stop;
    }
    fault(diag::LoopLimit, AT).arg(static_cast<std::int64_t>(options.limits.loop_turns));
    goto stop;
stop:
    pc = AT;
    turns_left = turns;
}

#pragma GCC diagnostic pop

template void Expander::State::run<false, true>();  // for curves.cpp

}  // namespace kadr::expand
