// blocks.cpp — NC blocks in the source: words become a plan with values to fill in.
#include "sema/blocks.h"

#include <algorithm>

#include "base/diagnostics/sema.h"
#include "base/numbers.h"
#include "nc/effects.h"
#include "sema/block_checks.h"
#include "sema/block_fillings.h"
#include "sema/block_words.h"
#include "sema/checking.h"
#include "sema/convert.h"
#include "sema/cycle_blocks.h"
#include "sema/expressions.h"
#include "sema/orienting.h"
#include "sema/skipped.h"
#include "sema/statements.h"
#include "sema/tests.h"
#include "sema/values.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::Stmt;
using syntax::Word;

namespace {

void append_key(std::string& key, std::int64_t value) {
    key += std::to_string(value);
    key += ',';
}

/// Two plans with the same key are the same plan.
std::string key_of(const Plan& plan) {
    std::string key;
    for (const std::int64_t part :
         {std::int64_t(plan.motion), std::int64_t(plan.given), std::int64_t(plan.incremental),
          std::int64_t(plan.absolute), std::int64_t(plan.argument_count),
          std::int64_t(plan.skip_level), std::int64_t(plan.cycle), std::int64_t(plan.number),
          std::int64_t(plan.customs), std::int64_t(plan.planes)}) {
        append_key(key, part);
    }
    for (const nc::Invocation& invocation : plan.functions) {
        append_key(key, static_cast<std::int64_t>(invocation.function));
        append_key(key, invocation.first);
        append_key(key, invocation.given);
    }
    key += 'a';
    for (const auto& [place, value] : plan.arguments) {
        append_key(key, place);
        append_shortest(key, value);
    }
    key += 'v';
    for (const auto& [place, value] : plan.values) {
        append_key(key, place);
        append_shortest(key, value);
    }
    key += 'f';
    for (const Filling& filling : plan.fillings) {
        append_key(key, static_cast<std::int64_t>(filling.form));
        append_key(key, filling.is_argument);
        append_key(key, filling.index);
        append_key(key, filling.invocation);
        append_key(key, filling.parameter);
        append_shortest(key, filling.factor);
    }
    return key;
}

Plan compact(const nc::BlockPlan& source) {
    const nc::Block& block = source.block;
    Plan plan;
    plan.motion = block.motion;
    plan.given = block.given;
    plan.incremental = block.incremental;
    plan.absolute = block.absolute;
    plan.argument_count = block.argument_count;
    plan.skip_level = block.skip_level;
    plan.cycle = block.cycle;
    plan.number = block.number;
    plan.planes = source.planes;
    plan.functions.assign(block.functions.begin(), block.functions.begin() + block.function_count);
    nc::SlotMask holes = 0;
    for (const nc::Hole& hole : source.holes) {
        if (!hole.is_argument) holes |= nc::SlotMask{1} << hole.index;
    }
    for (const nc::Invocation& invocation : plan.functions) {
        for (unsigned i = 0; i < 32; ++i) {
            if ((invocation.given >> i & 1u) == 0) continue;
            const auto index = static_cast<std::uint8_t>(invocation.first + i);
            plan.arguments.emplace_back(index, block.arguments[index]);
        }
    }
    for (unsigned slot = 0; slot < nc::kSlots; ++slot) {
        const nc::SlotMask mask = nc::SlotMask{1} << slot;
        if ((block.given & mask) != 0 && (holes & mask) == 0) {
            plan.values.emplace_back(static_cast<std::uint8_t>(slot), block.values[slot]);
        }
    }
    return plan;
}

bool is_of_cycle(const nc::Block& block, const nc::Hole& hole) {
    return hole.is_argument && block.functions[hole.invocation].function == nc::Function::Cycle;
}

/// `ROT`, `SCALE` and `MIRROR` of some controls delete the frame before they make their own: that
/// is a block by itself.
bool deletes_frame(const Plan& plan, const nc::Invocation& invocation) {
    return invocation.function == nc::Function::Shift && plan.functions.size() > 1;
}

/// Takes functions without arguments out of a block, into one of their own. M5 and M9: controls
/// differ in whether these act before the motion or after it; in the language they act after it.
template <typename Asked>
Plan take_functions(Plan& plan, Asked is_asked) {
    Plan taken;
    taken.skip_level = plan.skip_level;
    taken.customs = plan.customs;
    for (std::size_t i = 0; i < plan.functions.size();) {
        if (!is_asked(plan.functions[i])) {
            ++i;
            continue;
        }
        taken.functions.push_back(plan.functions[i]);
        plan.functions.erase(plan.functions.begin() + static_cast<std::ptrdiff_t>(i));
        for (Filling& filling : plan.fillings) {
            if (filling.is_argument && filling.invocation > i) --filling.invocation;
        }
    }
    return taken;
}

std::uint32_t plan_constant(Check& check, Plan plan) {
    const auto [found, is_new] = check.pools.plans.try_emplace(
        key_of(plan), static_cast<std::uint32_t>(check.code->plans.size()));
    if (is_new) check.code->plans.push_back(std::move(plan));
    return found->second;
}

}  // namespace

void emit_plan(Check& check, Plan plan, Reg first, unsigned point, const SourceRange& range) {
    if (is_in_test(check) && check.here.contour_depth == 0) report_test_block(check, range);
    const std::uint32_t index = plan_constant(check, std::move(plan));
    check.record.note_plan(check.here.module, check.here.block, index);
    check.emit.emit_pair(OpCode::Emit, first, point, static_cast<unsigned>(check.here.loop_depth),
                         index, statement_id(check, range));
}

namespace {

/// The point behind the words. `Y=r sin(30)` has none: an operator was forgotten.
Value target_value(Check& check, ExprId point, std::span<const Word> words) {
    const SourceRange range = check.ast()[point].range;
    check.here.target = range;
    const Value value = expression(check, point, types::kPoint);
    check.here.target = {};
    const bool is_number =
        check.types.is_numeric(value.type) && check.kind(value.type) != TypeKind::Error;
    const bool is_behind_value = !words.empty() && words.back().form != Word::Form::Literal &&
                                 words.back().form != Word::Form::Bare;
    if (is_number && is_behind_value) {
        check.report(diag::OperatorMissing, range)
            .arg(check.sources.text(words.back().range))
            .arg(check.sources.text(range))
            .fix("`*` multiplies; a word of its own begins with its address");
        return error_value();
    }
    return convert(check, value, types::kPoint, range, "the target");
}

}  // namespace

void emit_words(Check& check, std::span<const Word> words, const BehindWords& behind,
                const SourceRange& range, std::int8_t skip_level, std::uint32_t customs) {
    const ExprId point = behind.point;
    const Reg mark = check.emit.mark();
    std::optional<nc::BlockPlan> planned;
    Plan plan;
    if (!words.empty()) {
        planned = plan_words(check, words);
        if (planned && !check_points(check, *planned, words)) planned.reset();
        if (!planned) {
            for (const Word& word : words) {
                if (word.value.is_valid()) expression(check, word.value);
            }
            check.emit.release_to(mark);
            return;
        }
        if (!check_cycle_words(check, *planned, words)) return;
        check_units_words(check, *planned, words);
        check_counts(check, *planned, words);
        // The arguments of a cycle stand behind the values of the block itself.
        std::stable_partition(
            planned->holes.begin(), planned->holes.end(),
            [&](const nc::Hole& hole) { return !is_of_cycle(planned->block, hole); });
        plan = compact(*planned);
        plan.customs = customs_of(check, plan, words) | customs;
        const auto is_polar = [](const nc::Hole& hole) {
            return !hole.is_argument && (nc::kPolarSlots >> hole.index & 1u) != 0;
        };
        if (std::ranges::any_of(planned->holes, is_polar)) plan.customs |= custom::kDrawn;
        plan.skip_level = skip_level;
        if (skip_level >= 0) check_passed_text(check, plan, words);
    }
    const std::size_t holes = planned ? planned->holes.size() : 0;
    constexpr std::size_t kDirection = 3;
    const std::size_t values = holes + (behind.orient.is_valid() ? kDirection : 0);
    const Reg first = check.emit.take(std::max<unsigned>(1, static_cast<unsigned>(values)));
    for (std::size_t i = 0; i < holes; ++i) {
        const nc::Hole& hole = planned->holes[i];
        const Word& word = words[hole.word];
        check.emit.set_location(word.range);
        plan.fillings.push_back(fill_word(check, word, hole, static_cast<Reg>(first + i)));
    }
    unsigned point_register = 0;
    if (point.is_valid()) {
        const SourceRange point_range = check.ast()[point].range;
        const Value value = target_value(check, point, words);
        if (!check.is_error(value)) {
            point_register = in_register(check, value) + 1u;
            const auto is_linear = [](const Filling& f) { return !f.is_argument && f.index <= 2; };
            if (std::any_of(plan.fillings.begin(), plan.fillings.end(), is_linear)) {
                check.report(diag::TargetTwice, point_range);
            }
        }
    }
    if (behind.orient.is_valid()) {
        const Expr& orient = check.ast()[behind.orient];
        check.emit.set_location(orient.range);
        // A block without its direction is written as well: it deserves its own messages.
        const auto reg = static_cast<Reg>(first + holes);
        if (take_direction(check, orient, reg)) (void)add_direction(check, plan, orient.range);
    }
    check.emit.set_location(range);
    const std::optional<SourceCycle> cycle =
        planned ? take_cycle(check, plan, *planned, words) : std::nullopt;
    const auto is_target = [](const Filling& f) { return !f.is_argument && f.index < kAxes; };
    const bool moves = point_register != 0 || (plan.given & nc::kTargetSlots) != 0 ||
                       (plan.customs & custom::kDrawn) != 0 ||
                       std::any_of(plan.fillings.begin(), plan.fillings.end(), is_target);
    const Plan deletion = take_functions(
        plan, [&](const nc::Invocation& invocation) { return deletes_frame(plan, invocation); });
    if (!deletion.functions.empty()) emit_plan(check, deletion, first, 0, range);
    Plan stops;
    if (moves) {
        stops = take_functions(plan, [](const nc::Invocation& invocation) {
            return nc::has_fact(invocation.function, nc::Fact::StopsMachine);
        });
    }
    // … unless the source is written for a control on which they act before.
    const nc::Dialect& dialect = check.dialect();
    const bool is_before =
        !dialect.is_core() && nc::time_of_stop(dialect.rules()) == nc::When::BeforeMotion;
    const bool has_stops = !stops.functions.empty();
    if (has_stops && !is_before) {
        // BehindWords what the program stops or ends with nothing acts: it comes last.
        const Plan ends = take_functions(plan, [](const nc::Invocation& invocation) {
            return nc::has_fact(invocation.function, nc::Fact::StopsProgram);
        });
        stops.functions.insert(stops.functions.end(), ends.functions.begin(), ends.functions.end());
    }
    if (has_stops && is_before) emit_plan(check, stops, first, 0, range);
    const std::size_t own_values = plan.fillings.size();
    emit_plan(check, std::move(plan), first, point_register, range);
    if (cycle) emit_cycle(check, *cycle, static_cast<Reg>(first + own_values), range);
    else if (check.names.has_cycle_blocks() && !dialect.is_core()) emit_run_cycle(check, range);
    if (has_stops && !is_before) emit_plan(check, std::move(stops), first, 0, range);
    check.emit.release_to(mark);
}

void words_statement(Check& check, const Stmt& stmt) {
    if (is_modal_call(check, check.ast().word_run(stmt.words))) return modal_call(check, stmt);
    if (const Word* times = repeats_of(check, check.ast().word_run(stmt.words)))
        return repeat_places(check, stmt, *times);
    emit_words(check, check.ast().word_run(stmt.words), behind_words(check, stmt), stmt.range,
               stmt.skip_level);
}

}  // namespace kadr::sema
