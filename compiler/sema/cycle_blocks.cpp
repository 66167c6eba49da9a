// cycle_blocks.cpp — cycles as the control of the input dialect has them, `G83 …` and
// `CYCLE81(…)`: the library's cycle is called, which every target can write.
#include "sema/cycle_blocks.h"

#include <algorithm>

#include "base/diagnostics/dialect.h"
#include "base/diagnostics/sema.h"
#include "nc/cycle_codes.h"
#include "nc/tables.h"
#include "sema/block_checks.h"
#include "sema/block_fillings.h"
#include "sema/block_words.h"
#include "sema/blocks.h"
#include "sema/checking.h"
#include "sema/declarations.h"
#include "sema/expressions.h"
#include "sema/native_cycles.h"
#include "sema/optionals.h"
#include "sema/orienting.h"
#include "sema/statements.h"
#include "sema/values.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Stmt;
using syntax::Word;

/// Files of the library whose cycles are blocks of this one; they are no imports of it.
void load_cycles(Check& check, std::uint32_t module) {
    const syntax::Ast& tree = *check.names.module(module).ast;
    const nc::Dialect& dialect = *check.names.module(module).dialect;
    if (dialect.is_core()) return;
    const auto load = [&](nc::CycleId cycle, const SourceRange& location) {
        if (check.names.cycle_module(cycle) || !nc::can_be_source(dialect, cycle)) return;
        const ModuleLoader::Module found =
            check.loader.load(dialect.cycles()[cycle].module, false, tree.file, location);
        if (found.ast == nullptr) {
            ++check.sink.errors;  // the loader has reported why
            return;
        }
        check.names.set_cycle_module(
            cycle,
            load_module(check, *found.ast, found.dialect != nullptr ? *found.dialect : dialect));
    };
    for (const Word& word : tree.words) {
        if (word.form != Word::Form::Literal) continue;
        const auto cycle = nc::cycle_of(dialect, tree.text(word.address), word.number);
        if (cycle) load(*cycle, word.range);
    }
    for (const Expr& expr : tree.expressions) {
        if (expr.kind != ExprKind::Call || !expr.child[0].is_valid()) continue;
        const Expr& callee = tree[expr.child[0]];
        if (callee.kind != ExprKind::Name) continue;
        // Which of its cycles a call is, its arguments decide: `CYCLE83` has four.
        const nc::AddressId call = dialect.tables().find_address(tree.text(callee.text));
        if (call == nc::kNoAddress) continue;
        const nc::Address& address = dialect.tables().addresses[call];
        if (address.kind != nc::Address::Kind::Call) continue;
        for (const nc::FormId id : address.forms) {
            const nc::Form& form = dialect.tables().forms[id];
            if (form.function == nc::Function::Cycle) load(form.cycle, callee.range);
        }
    }
}

namespace {

/// The library's cycle; null if the file that stands for it has another one of that name.
const Name* cycle_function(const Check& check, nc::CycleId cycle) {
    const std::optional<std::uint32_t> module = check.names.cycle_module(cycle);
    if (!module) return nullptr;
    const std::string_view name = check.names.module(0).dialect->cycles()[cycle].name;
    const auto found = check.names.module(*module).names.find(name);
    if (found == check.names.module(*module).names.end()) return nullptr;
    const bool is_function = found->second.what == Name::What::Function;
    if (!is_function || native_cycle(check, check.names.function(found->second.index)) != cycle)
        return nullptr;
    return &found->second;
}

Done begin_cycle(Check& check, SourceCycle& cycle, nc::CycleId id, const SourceRange& range) {
    const nc::Dialect& dialect = check.dialect();
    const Name* found = cycle_function(check, id);
    if (found == nullptr) {
        check.report(diag::SourceCycle, range).arg(cycle.word);
        return kFailed;
    }
    check.names.want(found->index);
    cycle.function = found->index + 1;
    check.record.note_word(check.here.module, range, found->checked);
    cycle.rules = dialect.rules();
    cycle.has_other_in_strokes = nc::cycle_with_strokes(dialect, id).has_value();
    return kDone;
}

}  // namespace

void emit_cycle(Check& check, SourceCycle cycle, Reg first, const SourceRange& range) {
    const auto index = static_cast<std::int64_t>(check.code->cycles.size());
    check.code->cycles.push_back(std::move(cycle));
    check.emit.emit_pair(OpCode::SayCycle, first, 0, static_cast<unsigned>(check.here.loop_depth),
                         index, statement_id(check, range));
    emit_run_cycle(check, range);
}

void emit_run_cycle(Check& check, const SourceRange& range) {
    const auto depth = static_cast<unsigned>(check.here.loop_depth);
    const Reg mark = check.emit.mark();
    const Reg first = check.emit.take(1);
    check.emit.emit_pair(OpCode::RunCycle, first, 0, depth, statement_id(check, range));
    check.emit.release_to(mark);
    check.emit.emit_pair(OpCode::LeaveCycle, 0, 0, depth, 0, statement_id(check, range));
}

// ---------------------------------------------------------------- words: `G83 X10. Z-20. R2. Q5.`

std::optional<SourceCycle> take_cycle(Check& check, Plan& plan, const nc::BlockPlan& planned,
                                      std::span<const Word> words) {
    const auto found =
        std::ranges::find(plan.functions, nc::Function::Cycle, &nc::Invocation::function);
    if (found == plan.functions.end()) return std::nullopt;
    const nc::Dialect& dialect = check.dialect();
    const auto invocation = static_cast<std::size_t>(found - plan.functions.begin());
    const std::span<const nc::Parameter> parameters = dialect.cycles()[plan.cycle].parameters;
    SourceCycle cycle;
    cycle.kind = dialect.rules().modal_cycles ? SourceCycle::Kind::Modal : SourceCycle::Kind::Once;
    SourceRange range = words[0].range;
    for (const Word& word : words) {
        if (word.form != Word::Form::Literal ||
            nc::cycle_of(dialect, check.text(word.address), word.number) != planned.block.cycle)
            continue;
        cycle.word = word_text(check, word);
        range = word.range;
    }
    const auto is_other = [&](const Filling& filling) {
        return !filling.is_argument || filling.invocation != invocation;
    };
    const auto own = std::ranges::find_if_not(plan.fillings, is_other);
    for (const Filling& filling : std::span(own, plan.fillings.end()))
        cycle.arguments.push_back({filling.parameter, filling.form == Filling::Form::Count});
    plan.fillings.erase(own, plan.fillings.end());
    for (Filling& filling : plan.fillings) {
        if (filling.is_argument && filling.invocation > invocation) --filling.invocation;
    }
    const std::size_t first = found->first;
    std::erase_if(plan.arguments, [&](const auto& argument) {
        if (argument.first < first || argument.first >= first + parameters.size()) return false;
        cycle.fixed.emplace_back(static_cast<std::uint8_t>(argument.first - first),
                                 argument.second);
        return true;
    });
    plan.functions.erase(found);
    plan.customs |= custom::kCyclePosition;
    if (plan.motion != nc::Function::None) {
        check.report(diag::BlockWordConflict, range)
            .arg(cycle.word)
            .arg(nc::info(plan.motion).name)
            .fix("the cycle goes to its position at rapid by itself, and a motion code ends it");
        return std::nullopt;
    }
    const nc::CycleId id = std::exchange(plan.cycle, nc::CycleId{0});
    if (!begin_cycle(check, cycle, id, range)) return std::nullopt;
    return cycle;
}

namespace {

/// The word that gives how often a block repeats its cycle, `K`; empty: the control has none.
std::string_view repeats_address(const nc::DialectTables& tables) {
    const auto parameters = nc::info(nc::Function::CycleWords).parameters;
    const auto times = std::ranges::find(parameters, "times", &nc::Parameter::name);
    for (const nc::Form& form : tables.forms) {
        if (form.function != nc::Function::CycleWords || form.words.empty()) continue;
        if (form.words[0].parameter == times - parameters.begin())
            return tables.addresses[form.words[0].address].name;
    }
    return {};
}

/// `G2` and its like: what stands beside it are words of a path.
bool gives_motion(const nc::DialectTables& tables, std::string_view address, double number) {
    const nc::AddressId id = tables.find_address(address);
    if (id == nc::kNoAddress || tables.addresses[id].kind != nc::Address::Kind::Code) return false;
    const nc::CodeStart* code = tables.find_code(id, number);
    return code != nullptr && std::ranges::any_of(code->forms, [&](nc::FormId form) {
               return nc::info(tables.forms[form].function).group == nc::Group::Motion;
           });
}

}  // namespace

/// `K5` in a block that calls a cycle or can be a position of one; in another it is a centre.
const Word* repeats_of(const Check& check, std::span<const Word> words) {
    const nc::Dialect& dialect = check.dialect();
    if (dialect.is_core() || !check.names.has_cycle_blocks()) return nullptr;
    const std::string_view address = repeats_address(dialect.tables());
    const Word* times = nullptr;
    bool has_cycle = false;
    bool has_motion = false;
    for (const Word& word : words) {
        if (word.form != Word::Form::Literal) continue;
        if (check.text(word.address) == address && !has_point(check, word)) times = &word;
        has_cycle |= nc::cycle_of(dialect, check.text(word.address), word.number).has_value();
        has_motion |= gives_motion(dialect.tables(), check.text(word.address), word.number);
    }
    return has_cycle || !has_motion ? times : nullptr;
}

/// The block, then its position in the plane again and again: under G91 one behind the other.
void repeat_places(Check& check, const Stmt& stmt, const Word& times) {
    constexpr double kMost = 9999;
    std::vector<Word> words;
    std::vector<Word> place;
    for (const Word& word : check.ast().word_run(stmt.words)) {
        if (&word == &times) continue;
        words.push_back(word);
        if (check.text(word.address) == "X" || check.text(word.address) == "Y")
            place.push_back(word);
    }
    const char* fault = times.number < 1 || times.number > kMost
                            ? "1 to 9999 times it can be; what 0 keeps for later blocks they say"
                        : place.empty() ? "the block names no position in the plane"
                                        : nullptr;
    if (fault != nullptr) {
        check.report(diag::SourceRepeats, times.range).arg(word_text(check, times)).arg(fault);
        return;
    }
    const std::size_t errors = check.sink.errors;
    emit_words(check, words, behind_words(check, stmt), stmt.range, stmt.skip_level,
               custom::kRepeats);
    for (int i = 1; i < static_cast<int>(times.number) && errors == check.sink.errors; ++i)
        emit_words(check, place, {}, stmt.range, stmt.skip_level, custom::kRepeats);
}

// ---------------------------------------------------------------- calls: `CYCLE81(50,2,,-10)`

namespace {

/// What the arguments give as far as the form of the call depends on it; their values beside them.
std::vector<nc::SourceArgument> source_arguments(Check& check, std::span<const ExprId> items,
                                                 std::vector<Value>& values) {
    using ArgumentKind = nc::SourceArgument::Kind;
    std::vector<nc::SourceArgument> arguments(items.size());
    values.resize(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Expr& item = check.ast()[items[i]];
        arguments[i].range = item.range;
        const ExprId id = item.kind == ExprKind::Argument ? item.child[0] : items[i];
        if (!id.is_valid()) continue;
        values[i] = require_given(check, expression(check, id), item.range, {});
        const TypeInfo type = check.type_info(values[i].type);
        const bool is_number = type.kind == TypeKind::Int || type.kind == TypeKind::Real;
        if (type.kind == TypeKind::String) {
            arguments[i].kind = ArgumentKind::Text;
        } else if (is_number && values[i].is_constant()) {
            arguments[i].kind = ArgumentKind::Number;
            arguments[i].number = type.kind == TypeKind::Int
                                      ? static_cast<double>(values[i].constant.integer)
                                      : values[i].constant.number;
        } else {
            arguments[i].kind = ArgumentKind::Computed;
        }
    }
    return arguments;
}

/// Puts the values into the registers from `first`; what is added to another one goes there.
void fill_cycle(Check& check, const nc::BlockPlan& plan, std::span<const Value> values,
                std::span<const ExprId> items, Reg first, SourceCycle& cycle) {
    for (const nc::Hole& hole : plan.holes) {
        const SourceRange range = check.ast()[items[hole.word]].range;
        const Reg mark = check.emit.mark();
        const auto known =
            std::ranges::find(cycle.arguments, hole.parameter, &SourceCycle::Argument::parameter);
        const auto place = static_cast<Reg>(first + (known - cycle.arguments.begin()));
        const bool adds = hole.adds && known != cycle.arguments.end();
        const Reg reg = adds ? check.emit.take(1) : place;
        check.emit.set_location(range);
        const Filling filling = fill_value(check, values[hole.word], hole.dimension, range,
                                           check.sources.text(range), reg);
        // A sign of the pattern holds for values with units as well (`{-pitch}`).
        const bool is_count = filling.form == Filling::Form::Count;
        if (hole.factor != 1 && !is_count)
            check.emit.emit_number(OpCode::MulFK, reg, reg, hole.factor);
        if (adds) {
            // A clearance is entered without its sign (S 9.1 SDIS).
            check.emit.emit(OpCode::Math1, reg, reg, static_cast<unsigned>(Math::Abs));
            check.emit.emit(OpCode::AddF, place, place, reg);
        } else cycle.arguments.push_back({hole.parameter, is_count});
        check.emit.release_to(mark);
    }
}

}  // namespace

Value cycle_call(Check& check, const Expr& expr, SourceCycle::Kind kind) {
    const nc::Dialect& dialect = check.dialect();
    const SourceRange range = check.ast()[expr.child[0]].range;
    SourceCycle cycle;
    cycle.kind = kind;
    cycle.word = check.text(check.ast()[expr.child[0]].text);
    const Reg mark = check.emit.mark();
    const Value nothing = in_registers(types::kVoid, 0);
    const std::span<const ExprId> items = check.ast().exprs(expr.list);
    std::vector<Value> values;
    const std::vector<nc::SourceArgument> arguments = source_arguments(check, items, values);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (arguments[i].kind != nc::SourceArgument::Kind::Empty && check.is_error(values[i]))
            return nothing;
    }
    const auto plan = nc::plan_call(dialect, cycle.word, range, arguments, check.sink);
    if (!plan || !begin_cycle(check, cycle, plan->block.cycle, range)) return nothing;
    const nc::Invocation& invocation = plan->block.functions[0];
    for (unsigned i = 0; i < 32; ++i) {
        if ((invocation.given >> i & 1u) != 0) {
            cycle.fixed.emplace_back(static_cast<std::uint8_t>(i),
                                     plan->block.argument(invocation, i));
        }
    }
    const Reg first =
        check.emit.take(std::max<unsigned>(1, static_cast<unsigned>(plan->holes.size())));
    fill_cycle(check, *plan, values, items, first, cycle);
    check.emit.set_location(expr.range);
    emit_cycle(check, std::move(cycle), first, expr.range);
    check.emit.release_to(mark);
    return nothing;
}

bool is_modal_call(const Check& check, std::span<const Word> words) {
    const std::string_view name = check.dialect().modal_call();
    return !name.empty() && std::ranges::any_of(words, [&](const Word& word) {
        return word.form == Word::Form::Bare && check.text(word.address) == name;
    });
}

/// `MCALL CYCLE81(…);` and `MCALL;`. What stands behind the word is a point to the parser.
void modal_call(Check& check, const Stmt& stmt) {
    const std::span<const Word> words = check.ast().word_run(stmt.words);
    const std::string_view name = check.dialect().modal_call();
    for (const Word& word : words) {
        const bool is_number = word.form == Word::Form::Literal && check.text(word.address) == "N";
        if (is_number || check.text(word.address) == name) continue;
        check.report(diag::BlockWordAlone, word.range).arg(name);
        return;
    }
    if (stmt.skip_level >= 0) {
        check.report(diag::SkipState, words[0].range).arg(name);
        return;
    }
    const ExprId id = stmt.expression[0];
    if (!id.is_valid()) {
        check.emit.set_location(stmt.range);
        check.emit.emit(OpCode::EndCycle);
        return;
    }
    const Expr& expr = check.ast()[id];
    const bool is_call =
        expr.kind == ExprKind::Call && check.ast()[expr.child[0]].kind == ExprKind::Name;
    const nc::CallMeaning meaning =
        is_call ? nc::call_meaning(check.dialect(), check.text(check.ast()[expr.child[0]].text))
                : nc::CallMeaning{};
    if (meaning.function != nc::Function::Cycle) {
        check.report(diag::SourceModalCall, expr.range).arg(name);
        return;
    }
    cycle_call(check, expr, SourceCycle::Kind::Called);
}

}  // namespace kadr::sema
