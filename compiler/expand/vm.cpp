// vm.cpp — the instructions.
//
// Each handler jumps straight to the next one: a table of label addresses, which GCC and Clang know
// and the standard does not, is a quarter faster here than a switch, whose one indirect jump all
// instructions share. Such a jump runs no destructors, so a handler has no variables that need one:
// what does is a function of its own.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/assert.h"
#include "base/diagnostics/expand.h"
#include "base/text.h"
#include "expand/state.h"
#include "sema/csv.h"
#include "sema/picture.h"

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

void Expander::State::collect_garbage(const Slot* registers) {
    const std::size_t top =
        static_cast<std::size_t>(registers - stack.data()) + frames.back().function->registers;
    heap.collect(std::span<const Slot>(stack.data(), std::min(top, stack.size())));
}

/// The characters of a text as an array.
std::int64_t Expander::State::split_text(std::int64_t text, std::uint32_t layout) {
    const std::int64_t list = heap.new_array(layout);
    const std::string whole = heap.text(text);
    for (std::string_view rest = whole; !rest.empty();) {
        const std::string_view character = code_points(rest, 0, 1);
        Slot slot{};
        slot.integer = heap.new_text(std::string(character));
        heap.append(list, &slot);
        rest.remove_prefix(character.size());
    }
    return list;
}

std::int64_t Expander::State::make_table(const sema::TableSchema& schema,
                                         const sema::TableRows& rows) {
    const std::int64_t table = heap.new_array(schema.layout);
    const std::vector<SlotKind>& kinds = code.layouts[schema.layout].slots;
    std::vector<Slot> row(schema.slots);
    for (std::size_t first = 0; first < rows.slots.size(); first += schema.slots) {
        for (std::size_t i = 0; i < schema.slots; ++i) {
            row[i] = rows.slots[first + i];
            const bool is_text =
                kinds[i] == SlotKind::Text && row[i].integer != sema::kNotGivenInteger;
            if (is_text) {
                row[i].integer =
                    heap.new_text(rows.texts[static_cast<std::size_t>(row[i].integer)]);
            }
        }
        heap.append(table, row.data());
    }
    return table;
}

std::int64_t Expander::State::make_fixed(std::uint32_t layout, std::int64_t count) {
    const std::int64_t array = heap.new_array(layout);
    std::vector<Slot> element;
    for (const SlotKind kind : code.layouts[layout].slots) {
        Slot slot{};
        if (kind == SlotKind::Number) {
            slot.number = sema::kNotGivenNumber;
        } else {
            slot.integer = sema::kNotGivenInteger;
        }
        element.push_back(slot);
    }
    for (std::int64_t i = 0; i < count; ++i) heap.append(array, element.data());
    return array;
}

void Expander::State::make_image(const sema::PictureSource& source, const sema::Picture& picture,
                                 Slot* image) {
    const std::int64_t dots = heap.new_array(source.layout);
    for (const double brightness : picture.brightness) {
        Slot dot{};
        dot.number = brightness;
        heap.append(dots, &dot);
    }
    image[source.width].integer = static_cast<std::int64_t>(picture.width);
    image[source.height].integer = static_cast<std::int64_t>(picture.height);
    image[source.dots].integer = dots;
}

bool Expander::State::read_image(const sema::PictureSource& source, Slot path, std::uint32_t at,
                                 Slot* image) {
    const std::optional<sema::Picture> picture =
        sema::read_picture(source.folder, heap.text(path.integer), code.places[at], sink);
    if (!picture) {
        has_failed = true;
        is_running = false;
        return false;
    }
    make_image(source, *picture, image);
    return true;
}

bool Expander::State::read_table(const sema::TableSchema& schema, Slot path, std::uint32_t at,
                                 Slot& table) {
    const std::optional<sema::TableRows> rows =
        sema::read_table(schema, code.enums, heap.text(path.integer), code.places[at], sink);
    if (!rows) {
        has_failed = true;
        is_running = false;
        return false;
    }
    table.integer = make_table(schema, *rows);
    return true;
}

/// The turn that used up a slice of them asks for the next one; it belongs to it. False: there is
/// none, or somebody wants the evaluation to end.
bool Expander::State::more_turns(std::uint64_t& turns) {
    constexpr std::uint64_t kSlice = 1u << 16;  // turns between two looks at `stop` and the clock
    was_stopped = options.stop != nullptr && options.stop->load(std::memory_order_relaxed);
    is_late = options.limits.seconds > 0 &&
              std::chrono::duration<double>(Clock::now() - began).count() > options.limits.seconds;
    if (was_stopped || is_late) return false;
    turns = std::min(turns_reserve, kSlice);
    turns_reserve -= turns;
    return turns > 0;
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

    // ---------------------------------------------------------------- copying
op_Move:
    KADR_SLOPE(SLOPE_B);
    A = B;
    KADR_NEXT;
op_MoveN:
    if constexpr (kSlopes) std::memmove(&SLOPE_A, &SLOPE_B, ip->c * sizeof(double));
    std::memmove(&A, &B, ip->c * sizeof(Slot));
    KADR_NEXT;
op_LoadI:
    A.integer = ip->immediate.integer;
    KADR_NEXT;
op_LoadF:
    KADR_SLOPE(0);
    A.number = ip->immediate.number;
    KADR_NEXT;
op_LoadText:
    A.integer = Heap::constant_text(static_cast<std::uint32_t>(ip->immediate.pair.first));
    KADR_NEXT;
op_LoadGlobal:
    if constexpr (kSlopes)
        std::memcpy(&SLOPE_A, slopes.data() + ip->immediate.pair.first, ip->c * sizeof(double));
    std::memcpy(&A, stack.data() + ip->immediate.pair.first, ip->c * sizeof(Slot));
    KADR_NEXT;
op_StoreGlobal:
    if constexpr (kSlopes)
        std::memcpy(slopes.data() + ip->immediate.pair.first, &SLOPE_A, ip->c * sizeof(double));
    std::memcpy(stack.data() + ip->immediate.pair.first, &A, ip->c * sizeof(Slot));
    KADR_NEXT;
op_LoadRef : {
    const std::int64_t reference = B.integer;
    const auto offset = ip->immediate.pair.first;
    const Slot* from = reference >= 0 ? stack.data() + reference + offset
                                      : heap.referred(reference + offset, ip->c);
    if (from == nullptr) [[unlikely]]
        goto lost_reference;
    KADR_NO_SLOPES(ip->c);
    if constexpr (kSlopes) {
        if (reference >= 0)
            std::memmove(&SLOPE_A, slopes.data() + reference + offset, ip->c * sizeof(double));
    }
    std::memmove(&A, from, ip->c * sizeof(Slot));
    KADR_NEXT;
}
op_StoreRef : {
    const std::int64_t reference = B.integer;
    const auto offset = ip->immediate.pair.first;
    Slot* to = reference >= 0 ? stack.data() + reference + offset
                              : heap.referred(reference + offset, ip->c);
    if (to == nullptr) [[unlikely]]
        goto lost_reference;
    if constexpr (kSlopes) {
        if (reference >= 0)
            std::memmove(slopes.data() + reference + offset, &SLOPE_A, ip->c * sizeof(double));
    }
    std::memmove(to, &A, ip->c * sizeof(Slot));
    KADR_NEXT;
}
op_RefLocal:
    A.integer = (r - stack.data()) + ip->b;
    KADR_NEXT;
op_RefGlobal:
    A.integer = ip->immediate.pair.first;
    KADR_NEXT;
op_RefElement : {
    const Heap::ArrayView array = heap.array(B.integer);
    const std::int64_t index = C.integer;
    if (index < 0 || index >= array.count) [[unlikely]] {
        index_fault(index, array.count, AT);
        goto stop;
    }
    A.integer = Heap::element_reference(
        B.integer, static_cast<std::uint32_t>(index * array.stride + ip->immediate.pair.first));
    KADR_NEXT;
}
op_RefOffset:
    A.integer = B.integer + ip->immediate.pair.first;
    KADR_NEXT;

    // ---------------------------------------------------------------- whole numbers
op_AddI:
    if (__builtin_add_overflow(B.integer, C.integer, &A.integer)) [[unlikely]]
        goto integer_overflow;
    KADR_NEXT;
op_SubI:
    if (__builtin_sub_overflow(B.integer, C.integer, &A.integer)) [[unlikely]]
        goto integer_overflow;
    KADR_NEXT;
op_MulI:
    if (__builtin_mul_overflow(B.integer, C.integer, &A.integer)) [[unlikely]]
        goto integer_overflow;
    KADR_NEXT;
op_ModI:
    if (C.integer == 0) [[unlikely]] {
        why = MathFault::DivisionByZero;
        goto bad_math;
    }
    A.integer = sema::remainder(B.integer, C.integer);
    KADR_NEXT;
op_AddIK:
    if (__builtin_add_overflow(B.integer, ip->immediate.integer, &A.integer)) [[unlikely]]
        goto integer_overflow;
    KADR_NEXT;
op_MulIK:
    if (__builtin_mul_overflow(B.integer, ip->immediate.integer, &A.integer)) [[unlikely]]
        goto integer_overflow;
    KADR_NEXT;
op_NegI:
    if (__builtin_sub_overflow(std::int64_t{0}, B.integer, &A.integer)) [[unlikely]]
        goto integer_overflow;
    KADR_NEXT;
op_AndI:
    A.integer = B.integer & C.integer;
    KADR_NEXT;
op_OrI:
    A.integer = B.integer | C.integer;
    KADR_NEXT;
op_XorI:
    A.integer = B.integer ^ C.integer;
    KADR_NEXT;
op_NotI:
    A.integer = ~B.integer;
    KADR_NEXT;
op_ShlI : {
    const std::int64_t value = B.integer;
    const std::int64_t by = C.integer;
    if (by < 0 || by > 62) [[unlikely]]
        goto bad_shift;
    const auto shifted = static_cast<std::int64_t>(static_cast<std::uint64_t>(value) << by);
    if (shifted >> by != value) [[unlikely]]
        goto integer_overflow;
    A.integer = shifted;
    KADR_NEXT;
}
op_ShrI : {
    const std::int64_t by = C.integer;
    if (by < 0 || by > 62) [[unlikely]]
        goto bad_shift;
    A.integer = B.integer >> by;
    KADR_NEXT;
}

    // ---------------------------------------------------------------- real numbers
op_AddF:
    KADR_SLOPE(SLOPE_B + SLOPE_C);
    A.number = B.number + C.number;
    KADR_NEXT;
op_SubF:
    KADR_SLOPE(SLOPE_B - SLOPE_C);
    A.number = B.number - C.number;
    KADR_NEXT;
op_MulF:
    KADR_SLOPE(SLOPE_B * C.number + B.number * SLOPE_C);
    A.number = B.number * C.number;
    KADR_NEXT;
op_DivF:
    if (C.number == 0) [[unlikely]]
        goto division_by_zero;
    KADR_SLOPE((SLOPE_B - B.number / C.number * SLOPE_C) / C.number);
    A.number = B.number / C.number;
    KADR_NEXT;
op_ModF:
    if (C.number == 0) [[unlikely]]
        goto division_by_zero;
    KADR_SLOPE(SLOPE_B - std::trunc(B.number / C.number) * SLOPE_C);
    A.number = std::fmod(B.number, C.number);
    KADR_NEXT;
op_AddFK:
    KADR_SLOPE(SLOPE_B);
    A.number = B.number + ip->immediate.number;
    KADR_NEXT;
op_MulFK:
    KADR_SLOPE(SLOPE_B * ip->immediate.number);
    A.number = B.number * ip->immediate.number;
    KADR_NEXT;
op_DivFK:
    KADR_SLOPE(SLOPE_B / ip->immediate.number);
    A.number = B.number / ip->immediate.number;
    KADR_NEXT;
op_SubKF:
    KADR_SLOPE(-SLOPE_B);
    A.number = ip->immediate.number - B.number;
    KADR_NEXT;
op_DivKF:
    if (B.number == 0) [[unlikely]]
        goto division_by_zero;
    KADR_SLOPE(-ip->immediate.number / B.number / B.number * SLOPE_B);
    A.number = ip->immediate.number / B.number;
    KADR_NEXT;
op_NegF:
    KADR_SLOPE(-SLOPE_B);
    A.number = -B.number;
    KADR_NEXT;
op_IntToReal:
    KADR_SLOPE(0);
    A.number = static_cast<double>(B.integer);
    KADR_NEXT;
op_ToInt : {
    const std::optional<std::int64_t> whole =
        sema::to_integer(B.number, static_cast<Rounding>(ip->c));
    if (!whole) [[unlikely]]
        goto integer_overflow;
    A.integer = *whole;
    KADR_NEXT;
}
op_RoundF:
    KADR_SLOPE(0);
    A.number = sema::round_to_unit(B.number, static_cast<Rounding>(ip->c), ip->immediate.number);
    KADR_NEXT;
op_Sqrt:
    if (B.number < 0) [[unlikely]] {
        why = MathFault::NegativeRoot;
        goto bad_math;
    }
    KADR_SLOPE(SLOPE_B == 0 ? 0 : SLOPE_B / (2 * std::sqrt(B.number)));
    A.number = std::sqrt(B.number);
    KADR_NEXT;
op_SinDeg:
    KADR_SLOPE(SLOPE_B * sema::kRadPerDeg * sema::cos_deg(B.number));
    A.number = sema::sin_deg(B.number);
    KADR_NEXT;
op_CosDeg:
    KADR_SLOPE(-SLOPE_B * sema::kRadPerDeg * sema::sin_deg(B.number));
    A.number = sema::cos_deg(B.number);
    KADR_NEXT;
op_Math1 : {
    const sema::MathResult result = sema::evaluate(static_cast<Math>(ip->c), B.number);
    KADR_SLOPE(sema::slope(static_cast<Math>(ip->c), B.number, SLOPE_B));
    if (!result) [[unlikely]] {
        why = result.error();
        goto bad_math;
    }
    A.number = *result;
    KADR_NEXT;
}
op_Math2 : {
    const sema::MathResult result =
        sema::evaluate(static_cast<Math>(ip->immediate.pair.first), B.number, C.number);
    KADR_SLOPE(sema::slope(static_cast<Math>(ip->immediate.pair.first), B.number, C.number, SLOPE_B,
                           SLOPE_C));
    if (!result) [[unlikely]] {
        why = result.error();
        goto bad_math;
    }
    A.number = *result;
    KADR_NEXT;
}
op_MathI:
    if (static_cast<Math>(ip->immediate.pair.first) == Math::Abs) {
        const std::optional<std::int64_t> amount = sema::magnitude(B.integer);
        if (!amount) [[unlikely]]
            goto integer_overflow;
        A.integer = *amount;
        KADR_NEXT;
    }
    A.integer = integer_math(static_cast<Math>(ip->immediate.pair.first), B.integer, C.integer);
    KADR_NEXT;

    // ---------------------------------------------------------------- yes or no
op_LtI:
    A.integer = B.integer < C.integer;
    KADR_NEXT;
op_LeI:
    A.integer = B.integer <= C.integer;
    KADR_NEXT;
op_EqI:
    A.integer = B.integer == C.integer;
    KADR_NEXT;
op_NeI:
    A.integer = B.integer != C.integer;
    KADR_NEXT;
op_LtF:
    A.integer = B.number < C.number;
    KADR_NEXT;
op_LeF:
    A.integer = B.number <= C.number;
    KADR_NEXT;
op_EqF:
    A.integer = B.number == C.number;
    KADR_NEXT;
op_NeF:
    A.integer = B.number != C.number;
    KADR_NEXT;
op_Not:
    A.integer = B.integer == 0;
    KADR_NEXT;
op_CompareText : {
    const int order = heap.text(B.integer).compare(heap.text(C.integer));
    A.integer = (order > 0) - (order < 0);
    KADR_NEXT;
}
op_EqualPart : {
    const auto kind = static_cast<unsigned>(ip->immediate.pair.first);
    const bool both = is_given(B, kind) && is_given(C, kind);
    if (!both) A.integer = is_given(B, kind) == is_given(C, kind);
    else if (kind == static_cast<unsigned>(SlotKind::Number)) A.integer = B.number == C.number;
    else if (kind == static_cast<unsigned>(SlotKind::Text)) {
        A.integer = heap.text(B.integer) == heap.text(C.integer);
    } else {
        A.integer = B.integer == C.integer;
    }
    KADR_NEXT;
}
op_IsGiven:
    A.integer = is_given(B, ip->c);
    KADR_NEXT;
op_CheckGiven:
    if (!is_given(A, ip->c)) [[unlikely]] {
        not_given(code.texts[static_cast<std::size_t>(ip->immediate.pair.first)], AT);
        goto stop;
    }
    KADR_NEXT;
op_SameGiven:
    if (is_given(A, kNumberSlot) != is_given(B, kNumberSlot)) [[unlikely]] {
        const auto [left, right] = ip->immediate.pair;
        half_given(is_given(A, kNumberSlot) ? right : left, is_given(A, kNumberSlot) ? left : right,
                   AT);
        goto stop;
    }
    KADR_NEXT;
op_SameForm:
    if (sema::is_second_form(A.number) != sema::is_second_form(B.number) && A.number != 0 &&
        B.number != 0) [[unlikely]] {
        fault(diag::FormsMixed, AT);
        goto stop;
    }
    KADR_NEXT;
op_FeedForm:
    if (B.number != 0 && sema::is_second_form(B.number) != ((ip->c & 1u) == 1)) [[unlikely]] {
        form_fault(ip->c, AT);
        goto stop;
    }
    KADR_SLOPE((ip->c & 1u) == 1 ? SLOPE_B / sema::kSecondForm : SLOPE_B);
    A.number = (ip->c & 1u) == 1 ? B.number / sema::kSecondForm : B.number;
    KADR_NEXT;

    // ---------------------------------------------------------------- jumps
op_Jump:
    KADR_JUMP;
#define KADR_JUMP_IF(condition) \
    if (condition) KADR_JUMP;   \
    KADR_NEXT
#define KADR_LOOP_IF(condition) \
    if (condition) {            \
        KADR_TURN;              \
        KADR_JUMP;              \
    }                           \
    KADR_NEXT
op_JumpIf:
    KADR_JUMP_IF(A.integer != 0);
op_JumpIfNot:
    KADR_JUMP_IF(A.integer == 0);
op_JumpLtI:
    KADR_JUMP_IF(A.integer < B.integer);
op_JumpLeI:
    KADR_JUMP_IF(A.integer <= B.integer);
op_JumpEqI:
    KADR_JUMP_IF(A.integer == B.integer);
op_JumpNeI:
    KADR_JUMP_IF(A.integer != B.integer);
op_JumpLtIK:
    KADR_JUMP_IF(A.integer < SHORT_C);
op_JumpLeIK:
    KADR_JUMP_IF(A.integer <= SHORT_C);
op_JumpGtIK:
    KADR_JUMP_IF(A.integer > SHORT_C);
op_JumpGeIK:
    KADR_JUMP_IF(A.integer >= SHORT_C);
op_JumpEqIK:
    KADR_JUMP_IF(A.integer == SHORT_C);
op_JumpNeIK:
    KADR_JUMP_IF(A.integer != SHORT_C);
op_JumpLtF:
    KADR_JUMP_IF(A.number < B.number);
op_JumpLeF:
    KADR_JUMP_IF(A.number <= B.number);
op_JumpEqF:
    KADR_JUMP_IF(A.number == B.number);
op_JumpNeF:
    KADR_JUMP_IF(A.number != B.number);
op_JumpGiven:
    KADR_JUMP_IF(is_given(A, ip->c));
op_JumpNotGiven:
    KADR_JUMP_IF(!is_given(A, ip->c));
op_LoopStart:
    if constexpr (kTrace) {
        const std::size_t at =
            frames.back().loops + static_cast<std::size_t>(ip->immediate.pair.second);
        if (loop_counts.size() <= at) loop_counts.resize(at + 16);
        loop_counts[at] = 1;
    }
    KADR_NEXT;
op_Loop:
    KADR_TURN;
    KADR_JUMP;
op_LoopIf:
    KADR_LOOP_IF(A.integer != 0);
op_LoopIfNot:
    KADR_LOOP_IF(A.integer == 0);
op_LoopLtI:
    KADR_LOOP_IF(A.integer < B.integer);
op_LoopLeI:
    KADR_LOOP_IF(A.integer <= B.integer);
op_LoopNeI:
    KADR_LOOP_IF(A.integer != B.integer);
op_LoopLtIK:
    KADR_LOOP_IF(A.integer < SHORT_C);
op_LoopLeIK:
    KADR_LOOP_IF(A.integer <= SHORT_C);
op_LoopGtIK:
    KADR_LOOP_IF(A.integer > SHORT_C);
op_LoopGeIK:
    KADR_LOOP_IF(A.integer >= SHORT_C);
op_LoopNeIK:
    KADR_LOOP_IF(A.integer != SHORT_C);
op_LoopLtF:
    KADR_LOOP_IF(A.number < B.number);
op_LoopLeF:
    KADR_LOOP_IF(A.number <= B.number);
op_ForLtI:
    if (__builtin_add_overflow(A.integer, SHORT_C, &A.integer)) [[unlikely]]
        goto integer_overflow;
    KADR_LOOP_IF(A.integer < B.integer);
op_ForLeI:
    if (__builtin_add_overflow(A.integer, SHORT_C, &A.integer)) [[unlikely]]
        goto integer_overflow;
    KADR_LOOP_IF(A.integer <= B.integer);
op_ForGtI:
    if (__builtin_add_overflow(A.integer, SHORT_C, &A.integer)) [[unlikely]]
        goto integer_overflow;
    KADR_LOOP_IF(A.integer > B.integer);
op_ForGeI:
    if (__builtin_add_overflow(A.integer, SHORT_C, &A.integer)) [[unlikely]]
        goto integer_overflow;
    KADR_LOOP_IF(A.integer >= B.integer);

    // ---------------------------------------------------------------- functions
op_Call : {
    // Calls that call twice make no loop and never end all the same.
    if (--turns == 0 && !more_turns(turns)) [[unlikely]]
        goto too_many_turns;
    if (frames.size() > options.limits.call_depth) [[unlikely]] {
        fault(diag::CallDepthLimit, AT).arg(static_cast<std::int64_t>(options.limits.call_depth));
        goto stop;
    }
    const sema::FunctionCode& function = code.functions[ip->b];
    const auto base = static_cast<std::uint32_t>(r - stack.data()) + ip->a;
    [[maybe_unused]] const std::uint32_t outer_loops = frames.back().loops;
    CallFrame& frame = frames.push();
    frame.function = &function;
    frame.return_to = AT + 1;
    frame.base = base;
    frame.given = static_cast<std::uint32_t>(ip->immediate.pair.second);
    frame.promises = static_cast<std::uint32_t>(promises.size());
    if constexpr (kTrace) frame.loops = outer_loops + ip->c;
    if (stack.size() < std::size_t{base} + function.registers + 8) [[unlikely]] {
        reserve_stack(std::size_t{base} + function.registers + 8);
        if constexpr (kSlopes) slopes.resize(stack.size());
    }
    r = stack.data() + base;
    KADR_GO(frame.given == all_given[ip->b] ? function.body : function.entry);
}
op_SkipIfGiven:
    if ((frames.back().given >> ip->c & 1u) != 0) KADR_JUMP;
    KADR_NEXT;
op_Return:
    if constexpr (kSlopes)
        std::memmove(slopes.data() + (r - stack.data()), &SLOPE_A, ip->c * sizeof(double));
    if (ip->c == 1) r[0] = A;
    else if (ip->c > 1) std::memmove(r, &A, ip->c * sizeof(Slot));
leave_function : {
    const CallFrame& frame = frames.back();
    if (promises.size() != frame.promises) [[unlikely]]
        promises.resize(frame.promises);
    if (frames.size() == 1) [[unlikely]] {
        is_running = false;
        goto stop;
    }
    const std::uint32_t to = frame.return_to;
    frames.pop();
    r = stack.data() + frames.back().base;
    KADR_GO(to);
}
op_Finish:
    is_running = false;
    goto stop;

    // ---------------------------------------------------------------- texts
op_Format : {
    if (heap.is_full()) [[unlikely]]
        collect_garbage(r);
    A.integer =
        heap.new_text(format(code.formats[static_cast<std::size_t>(ip->immediate.pair.first)], &B));
    KADR_NEXT;
}
op_Concat : {
    if (heap.is_full()) [[unlikely]]
        collect_garbage(r);
    const std::string& left = heap.text(B.integer);
    const std::string& right = heap.text(C.integer);
    if (left.size() + right.size() > options.limits.array_elements) [[unlikely]]
        goto too_many_elements;
    A.integer = heap.new_text(left + right);
    KADR_NEXT;
}
op_ContainsText:
    A.integer = heap.text(B.integer).find(heap.text(C.integer)) != std::string::npos;
    KADR_NEXT;
op_CountText:
    A.integer = static_cast<std::int64_t>(count_code_points(heap.text(B.integer)));
    KADR_NEXT;
op_CharacterOf : {
    if (heap.is_full()) [[unlikely]]
        collect_garbage(r);
    const std::string& text = heap.text(B.integer);
    const auto index = static_cast<std::size_t>(C.integer);
    const std::string_view character =
        C.integer >= 0 ? code_points(text, index, 1) : std::string_view();
    if (character.empty()) [[unlikely]] {
        index_fault(C.integer, static_cast<std::int64_t>(count_code_points(text)), AT,
                    "the string");
        goto stop;
    }
    A.integer = heap.new_text(std::string(character));
    KADR_NEXT;
}
op_PartOfText : {
    if (heap.is_full()) [[unlikely]]
        collect_garbage(r);
    const std::string& text = heap.text(B.integer);
    const auto total = static_cast<std::int64_t>(count_code_points(text));
    const std::int64_t from = C.integer;
    const bool is_open = (&C)[1].integer == sema::kNotGivenInteger;
    const std::int64_t count = is_open ? total - from : (&C)[1].integer;
    if (from < 0 || from > total || count < 0 || count > total - from) [[unlikely]] {
        fault(diag::TextPart, AT).arg(count).arg(from).arg(total);
        goto stop;
    }
    A.integer = heap.new_text(std::string(
        code_points(text, static_cast<std::size_t>(from), static_cast<std::size_t>(count))));
    KADR_NEXT;
}
op_FindText : {
    const std::string_view text = heap.text(B.integer);
    const std::size_t at = text.find(heap.text(C.integer));
    A.integer = at == std::string_view::npos
                    ? -1
                    : static_cast<std::int64_t>(count_code_points(text.substr(0, at)));
    KADR_NEXT;
}
op_SplitText : {
    if (heap.is_full()) [[unlikely]]
        collect_garbage(r);
    const std::int64_t source = B.integer;
    A.integer = split_text(source, static_cast<std::uint32_t>(ip->immediate.pair.first));
    if (heap.elements() > options.limits.array_elements) [[unlikely]]
        goto too_many_elements;
    KADR_NEXT;
}

    // ---------------------------------------------------------------- arrays
op_NewArray:
    if (heap.is_full()) [[unlikely]]
        collect_garbage(r);
    A.integer = heap.new_array(static_cast<std::uint32_t>(ip->immediate.pair.first));
    KADR_NEXT;
op_NewFixed:
    if (heap.is_full()) [[unlikely]]
        collect_garbage(r);
    A.integer =
        make_fixed(static_cast<std::uint32_t>(ip->immediate.pair.first), ip->immediate.pair.second);
    if (heap.elements() > options.limits.array_elements) [[unlikely]]
        goto too_many_elements;
    KADR_NEXT;
op_Append:
    heap.append(A.integer, &B);
    if (heap.elements() > options.limits.array_elements) [[unlikely]] {
        collect_garbage(r);
        if (heap.elements() > options.limits.array_elements) goto too_many_elements;
    }
    KADR_NEXT;
op_InsertAt : {
    const std::int64_t count = heap.array(A.integer).count;
    if (C.integer < 0 || C.integer > count) [[unlikely]] {
        index_fault(C.integer, count + 1, AT);
        goto stop;
    }
    heap.insert(A.integer, C.integer, &B);
    if (heap.elements() > options.limits.array_elements) [[unlikely]]
        goto too_many_elements;
    KADR_NEXT;
}
op_RemoveAt : {
    const std::int64_t count = heap.array(A.integer).count;
    if (B.integer < 0 || B.integer >= count) [[unlikely]] {
        index_fault(B.integer, count, AT);
        goto stop;
    }
    heap.remove(A.integer, B.integer);
    KADR_NEXT;
}
op_CheckFilled:
    if (A.integer == 0) [[unlikely]] {
        fault(diag::EmptyArray, AT);
        goto stop;
    }
    KADR_NEXT;
op_ClearArray:
    heap.clear(A.integer);
    KADR_NEXT;
op_CountArray:
    A.integer = heap.array(B.integer).count;
    KADR_NEXT;
op_LoadElement : {
    const Heap::ArrayView array = heap.array(B.integer);
    const std::int64_t index = C.integer;
    if (static_cast<std::uint64_t>(index) >= static_cast<std::uint64_t>(array.count)) [[unlikely]] {
        index_fault(index, array.count, AT);
        goto stop;
    }
    KADR_NO_SLOPES(1);
    A = array.slots[index];
    KADR_NEXT;
}
op_StoreElement : {
    const Heap::ArrayView array = heap.array(B.integer);
    const std::int64_t index = C.integer;
    if (static_cast<std::uint64_t>(index) >= static_cast<std::uint64_t>(array.count)) [[unlikely]] {
        index_fault(index, array.count, AT);
        goto stop;
    }
    array.slots[index] = A;
    KADR_NEXT;
}
op_LoadElementN : {
    const Heap::ArrayView array = heap.array(B.integer);
    const std::int64_t index = C.integer;
    if (static_cast<std::uint64_t>(index) >= static_cast<std::uint64_t>(array.count)) [[unlikely]] {
        index_fault(index, array.count, AT);
        goto stop;
    }
    KADR_NO_SLOPES(ip->immediate.pair.second);
    const Slot* from = array.slots + index * array.stride + ip->immediate.pair.first;
    std::memmove(&A, from, static_cast<std::size_t>(ip->immediate.pair.second) * sizeof(Slot));
    KADR_NEXT;
}
op_StoreElementN : {
    const Heap::ArrayView array = heap.array(B.integer);
    const std::int64_t index = C.integer;
    if (static_cast<std::uint64_t>(index) >= static_cast<std::uint64_t>(array.count)) [[unlikely]] {
        index_fault(index, array.count, AT);
        goto stop;
    }
    Slot* to = array.slots + index * array.stride + ip->immediate.pair.first;
    std::memmove(to, &A, static_cast<std::size_t>(ip->immediate.pair.second) * sizeof(Slot));
    KADR_NEXT;
}
op_CopyArray:
    if (heap.is_full()) [[unlikely]]
        collect_garbage(r);
    A.integer = heap.copy(B.integer);
    if (heap.elements() > options.limits.array_elements) [[unlikely]]
        goto too_many_elements;
    KADR_NEXT;
op_CopyParts:
    if (heap.is_full()) [[unlikely]]
        collect_garbage(r);
    heap.copy_parts(&A, static_cast<std::uint32_t>(ip->immediate.pair.first));
    if (heap.elements() > options.limits.array_elements) [[unlikely]]
        goto too_many_elements;
    KADR_NEXT;
op_ContainsElement : {
    const Heap::ArrayView array = heap.array(B.integer);
    const SlotKind kind = heap.layout(B.integer).slots[0];
    const Slot wanted = C;
    std::int64_t found = 0;
    for (std::int64_t i = 0; i < array.count && found == 0; ++i) {
        if (kind == SlotKind::Number) found = array.slots[i].number == wanted.number;
        else if (kind == SlotKind::Text) {
            found = heap.text(array.slots[i].integer) == heap.text(wanted.integer);
        } else {
            found = array.slots[i].integer == wanted.integer;
        }
    }
    A.integer = found;
    KADR_NEXT;
}
op_LoadTable : {
    if (heap.is_full()) [[unlikely]]
        collect_garbage(r);
    const sema::LoadedTable& table =
        code.tables[static_cast<std::size_t>(ip->immediate.pair.first)];
    A.integer = make_table(code.schemas[table.schema], table.rows);
    if (heap.elements() > options.limits.array_elements) [[unlikely]]
        goto too_many_elements;
    KADR_NEXT;
}
op_LoadImage : {
    if (heap.is_full()) [[unlikely]]
        collect_garbage(r);
    const sema::PictureSource& source =
        code.pictures[static_cast<std::size_t>(ip->immediate.pair.first)];
    make_image(source, source.picture, &A);
    if (heap.elements() > options.limits.array_elements) [[unlikely]]
        goto too_many_elements;
    KADR_NEXT;
}
op_ReadImage:
    if (heap.is_full()) [[unlikely]]
        collect_garbage(r);
    if (!read_image(code.pictures[static_cast<std::size_t>(ip->immediate.pair.first)], B, AT, &A))
        goto stop;
    if (heap.elements() > options.limits.array_elements) [[unlikely]]
        goto too_many_elements;
    KADR_NEXT;
op_ReadTable:
    if (heap.is_full()) [[unlikely]]
        collect_garbage(r);
    if (!read_table(code.schemas[static_cast<std::size_t>(ip->immediate.pair.first)], B, AT, A))
        goto stop;
    if (heap.elements() > options.limits.array_elements) [[unlikely]]
        goto too_many_elements;
    KADR_NEXT;

    // ---------------------------------------------------------------- blocks
op_Emit:
    if (!emit(*ip, r, AT)) [[unlikely]]
        goto stop;
    goto batch_or_next;
op_EmitText:
    if (!emit_text(*ip, r, AT)) [[unlikely]]
        goto stop;
    goto batch_or_next;
op_NativeCycle:
    if (!emit_cycle(static_cast<nc::CycleId>(ip->immediate.pair.first), r)) KADR_NEXT;
    if (has_failed) goto stop;
    // The block stands for the body. The return comes first: the next batch begins behind the call.
    if (batch_count < batch_size) goto leave_function;
    {
        const CallFrame frame = frames.back();
        promises.resize(frame.promises);
        if (frames.size() == 1) {
            is_running = false;
            goto stop;
        }
        frames.pop();
        pc = frame.return_to;
        turns_left = turns;
        return;
    }
op_SayCycle:
    if (!say_cycle(*ip, r, AT)) [[unlikely]]
        goto stop;
    KADR_NEXT;
op_RunCycle:
    if (!said_cycle.is_due) [[likely]] {
        ++ip;  // nothing is to be left
        KADR_NEXT;
    }
    if (!call_cycle(*ip, r, AT)) goto stop;
    r = stack.data() + frames.back().base;
    KADR_GO(frames.back().function->entry);
op_LeaveCycle:
    leave_cycle(*ip, AT);
    if (has_failed) goto stop;
    goto batch_or_next;
op_EndCycle:
    said_cycle.is_active = false;
    KADR_NEXT;
op_EnterWith:
    withs.push_back({static_cast<sema::ModalMask>(ip->immediate.pair.first), modal});
    KADR_NEXT;
op_ChangeFrame:
    if (!change_frame(*ip, r, AT)) [[unlikely]]
        goto stop;
    goto batch_or_next;
op_LeaveWith:
    for (unsigned i = 0; i < ip->c; ++i) {
        if (!leave_with({static_cast<std::uint32_t>(ip->immediate.pair.second)}, AT, 0)) goto stop;
    }
    goto batch_or_next;
op_EnterPreserves:
    if (!check_needs(AT)) [[unlikely]]
        goto stop;
    promises.push_back({static_cast<sema::ModalMask>(ip->immediate.pair.first), modal});
    KADR_NEXT;
op_CheckPreserves:
    if (!check_preserves(AT)) [[unlikely]]
        goto stop;
    goto batch_or_next;
op_Position:
    KADR_SLOPE(0);
    A.number = (modal.known >> ip->c & 1u) != 0 ? modal.position[ip->c] : sema::kNotGivenNumber;
    KADR_NEXT;
op_State:
    KADR_SLOPE(0);
    if (static_cast<sema::StateValue>(ip->c) == sema::StateValue::Tool) {
        A.integer = modal.has_tool ? static_cast<std::int64_t>(modal.tool) : sema::kNotGivenInteger;
    } else if (static_cast<sema::StateValue>(ip->c) == sema::StateValue::Spindle) {
        A.integer = spindle_code();
    } else if (static_cast<sema::StateValue>(ip->c) == sema::StateValue::Mirrored) {
        A.integer = modal.frame.is_left_handed() ? 1 : 0;
    } else if (static_cast<sema::StateValue>(ip->c) == sema::StateValue::Turned) {
        A.integer = modal.frame.is_shift() ? 0 : 1;
    } else {
        A.number = state_value(static_cast<sema::StateValue>(ip->c));
    }
    KADR_NEXT;

    // ---------------------------------------------------------------- contours and curves
op_BeginContour:
    begin_contour();
    KADR_NEXT;
op_CloseContour:
    if (!close_contour(AT)) [[unlikely]]
        goto stop;
    KADR_NEXT;
op_EndContour:
    if (heap.is_full()) [[unlikely]]
        collect_garbage(r);
    A.integer = end_contour(static_cast<std::uint32_t>(ip->immediate.pair.first));
    if (heap.elements() > options.limits.array_elements) [[unlikely]]
        goto too_many_elements;
    KADR_NEXT;
op_ContourValue:
    KADR_NO_SLOPES(3);  // of the largest result, a point
    if (heap.is_full()) [[unlikely]]
        collect_garbage(r);
    if (!contour_value(*ip, r, AT)) [[unlikely]]
        goto stop;
    if (heap.elements() > options.limits.array_elements) [[unlikely]]
        goto too_many_elements;
    KADR_NEXT;
op_FollowContour:
    if (!follow_contour(*ip, r, AT)) [[unlikely]]
        goto stop;
    goto batch_or_next;
op_FollowCurve:
    turns_left = turns;
    {
        const Progress progress = follow_curve(*ip, AT);
        // Points of the curve have been calculated meanwhile: the registers may have moved.
        r = stack.data() + frames.back().base;
        turns = turns_left;
        if (progress == Progress::Failed) goto stop;
        pc = progress == Progress::Done ? AT + 2 : AT;
        if (progress == Progress::BatchFull || batch_count == batch_size) {
            if (recordings.empty()) return;
        }
        KADR_GO(pc);
    }
op_CurveEnd:
    pc = AT;
    turns_left = turns;
    return;
op_FollowStart:
    KADR_NO_SLOPES(3);
    if (!follow_start(*ip, r, AT)) [[unlikely]]
        goto stop;
    KADR_NEXT;

    // ---------------------------------------------------------------- messages of the author
op_RequireFailed:
op_AssertFailed:
    contract_failed(*ip, r, AT);
    goto stop;
op_UserError:
    fault(diag::ProgramError, AT).arg(heap.text(A.integer));
    goto stop;
op_UserWarning:
    fault_note(diag::ProgramWarning, AT, heap.text(A.integer));
    KADR_NEXT;
op_Show:
    if (options.shown != nullptr) {
        const auto form = static_cast<std::uint32_t>(ip->immediate.pair.first);
        options.shown->push_back(shown(form, &A));
    }
    KADR_NEXT;

    // ---------------------------------------------------------------- tests
op_TestCall:
    if (!test_call(*ip, r, AT)) [[unlikely]]
        goto stop;
    ++ip;  // the Finish is for the call
    KADR_NEXT;
op_Figure:
    ask_figure(*ip, r);
    KADR_NEXT;
op_TestDialects:
    list_dialects(*ip, r);
    KADR_NEXT;
op_ExpectFailed:
    if (!expectation_failed(*ip, r, AT)) goto stop;
    KADR_NEXT;
op_AssumeFailed:
    is_rejected = true;
    is_running = false;
    goto stop;

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
too_many_elements:
    fault(diag::ElementLimit, AT).arg(static_cast<std::int64_t>(options.limits.array_elements));
    goto stop;
too_many_turns:
    if (was_stopped) {
        fault(diag::EvaluationStopped, AT);
        goto stop;
    }
    if (is_late) {
        fault(diag::TimeLimit, AT)
            .arg(options.limits.seconds)
            .fix("if it is to work longer, raise the limit: `--max-time`");
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
