// cycle_blocks.cpp — cycles as the control of the input dialect has them, `G83 …` and
// `CYCLE81(…)`: the library's cycle is called, which every target can write.
#include <algorithm>

#include "base/diagnostics/dialect.h"
#include "base/diagnostics/sema.h"
#include "nc/cycle_codes.h"
#include "nc/tables.h"
#include "sema/checker.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Stmt;
using syntax::Word;

/// Files of the library whose cycles are blocks of this one; they are no imports of it.
void Checker::load_cycles(std::uint32_t module) {
    const syntax::Ast& tree = *modules_[module].ast;
    const nc::Dialect& dialect = *modules_[module].dialect;
    if (dialect.is_core()) return;
    const auto load = [&](nc::CycleId cycle, const SourceRange& location) {
        if (cycle_modules_.contains(cycle) || !nc::can_be_source(dialect, cycle)) return;
        const ModuleLoader::Module found =
            loader_.load(dialect.cycles()[cycle].module, false, tree.file, location);
        if (found.ast == nullptr) {
            ++sink_.errors;  // the loader has reported why
            return;
        }
        cycle_modules_[cycle] =
            load_module(*found.ast, found.dialect != nullptr ? *found.dialect : dialect);
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

/// The library's cycle; null if the file that stands for it has another one of that name.
const Name* Checker::cycle_function(nc::CycleId cycle) const {
    const auto module = cycle_modules_.find(cycle);
    if (module == cycle_modules_.end()) return nullptr;
    const std::string_view name = modules_[0].dialect->cycles()[cycle].name;
    const auto found = modules_[module->second].names.find(name);
    if (found == modules_[module->second].names.end()) return nullptr;
    const bool is_function = found->second.what == Name::What::Function;
    if (!is_function || native_cycle(functions_[found->second.index]) != cycle) return nullptr;
    return &found->second;
}

Done Checker::begin_cycle(SourceCycle& cycle, nc::CycleId id, const SourceRange& range) {
    const nc::Dialect& dialect = *modules_[module_].dialect;
    const Name* found = cycle_function(id);
    if (found == nullptr) {
        report(diag::SourceCycle, range).arg(cycle.word);
        return kFailed;
    }
    FunctionDecl& function = functions_[found->index];
    if (!function.is_wanted) {
        function.is_wanted = true;
        wanted_.push_back(found->index);
    }
    cycle.function = found->index + 1;
    record_.note_word(module_, range, found->checked);
    cycle.rules = dialect.rules();
    cycle.has_other_in_strokes = nc::cycle_with_strokes(dialect, id).has_value();
    return kDone;
}

void Checker::emit_cycle(SourceCycle cycle, Reg first, const SourceRange& range) {
    const auto index = static_cast<std::int64_t>(code_->cycles.size());
    code_->cycles.push_back(std::move(cycle));
    emit_.emit_pair(OpCode::SayCycle, first, 0, static_cast<unsigned>(loop_depth_), index,
                    statement_id(range));
    emit_run_cycle(range);
}

void Checker::emit_run_cycle(const SourceRange& range) {
    const auto depth = static_cast<unsigned>(loop_depth_);
    const Reg mark = emit_.mark();
    const Reg first = emit_.take(1);
    emit_.emit_pair(OpCode::RunCycle, first, 0, depth, statement_id(range));
    emit_.release_to(mark);
    emit_.emit_pair(OpCode::LeaveCycle, 0, 0, depth, 0, statement_id(range));
}

// ---------------------------------------------------------------- words: `G83 X10. Z-20. R2. Q5.`

std::optional<SourceCycle> Checker::take_cycle(Plan& plan, const nc::BlockPlan& planned,
                                               std::span<const Word> words) {
    const auto found =
        std::ranges::find(plan.functions, nc::Function::Cycle, &nc::Invocation::function);
    if (found == plan.functions.end()) return std::nullopt;
    const nc::Dialect& dialect = *modules_[module_].dialect;
    const auto invocation = static_cast<std::size_t>(found - plan.functions.begin());
    const std::span<const nc::Parameter> parameters = dialect.cycles()[plan.cycle].parameters;
    SourceCycle cycle;
    cycle.kind = dialect.rules().modal_cycles ? SourceCycle::Kind::Modal : SourceCycle::Kind::Once;
    SourceRange range = words[0].range;
    for (const Word& word : words) {
        if (word.form != Word::Form::Literal ||
            nc::cycle_of(dialect, text(word.address), word.number) != planned.block.cycle)
            continue;
        cycle.word = word_text(word);
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
        report(diag::BlockWordConflict, range)
            .arg(cycle.word)
            .arg(nc::info(plan.motion).name)
            .fix("the cycle goes to its position at rapid by itself, and a motion code ends it");
        return std::nullopt;
    }
    const nc::CycleId id = std::exchange(plan.cycle, nc::CycleId{0});
    if (!begin_cycle(cycle, id, range)) return std::nullopt;
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
const Word* Checker::repeats_of(std::span<const Word> words) const {
    const nc::Dialect& dialect = *modules_[module_].dialect;
    if (dialect.is_core() || cycle_modules_.empty()) return nullptr;
    const std::string_view address = repeats_address(dialect.tables());
    const Word* times = nullptr;
    bool has_cycle = false;
    bool has_motion = false;
    for (const Word& word : words) {
        if (word.form != Word::Form::Literal) continue;
        if (text(word.address) == address && !has_point(word)) times = &word;
        has_cycle |= nc::cycle_of(dialect, text(word.address), word.number).has_value();
        has_motion |= gives_motion(dialect.tables(), text(word.address), word.number);
    }
    return has_cycle || !has_motion ? times : nullptr;
}

/// The block, then its position in the plane again and again: under G91 one behind the other.
void Checker::repeat_places(const Stmt& stmt, const Word& times) {
    constexpr double kMost = 9999;
    std::vector<Word> words;
    std::vector<Word> place;
    for (const Word& word : ast().word_run(stmt.words)) {
        if (&word == &times) continue;
        words.push_back(word);
        if (text(word.address) == "X" || text(word.address) == "Y") place.push_back(word);
    }
    const char* fault = times.number < 1 || times.number > kMost
                            ? "1 to 9999 times it can be; what 0 keeps for later blocks they say"
                        : place.empty() ? "the block names no position in the plane"
                                        : nullptr;
    if (fault != nullptr) {
        report(diag::SourceRepeats, times.range).arg(word_text(times)).arg(fault);
        return;
    }
    const std::size_t errors = sink_.errors;
    emit_words(words, behind_words(stmt), stmt.range, stmt.skip_level, custom::kRepeats);
    for (int i = 1; i < static_cast<int>(times.number) && errors == sink_.errors; ++i)
        emit_words(place, {}, stmt.range, stmt.skip_level, custom::kRepeats);
}

// ---------------------------------------------------------------- calls: `CYCLE81(50,2,,-10)`

/// What the arguments give as far as the form of the call depends on it; their values beside them.
std::vector<nc::SourceArgument> Checker::source_arguments(std::span<const ExprId> items,
                                                          std::vector<Value>& values) {
    using ArgumentKind = nc::SourceArgument::Kind;
    std::vector<nc::SourceArgument> arguments(items.size());
    values.resize(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Expr& item = ast()[items[i]];
        arguments[i].range = item.range;
        const ExprId id = item.kind == ExprKind::Argument ? item.child[0] : items[i];
        if (!id.is_valid()) continue;
        values[i] = require_given(expression(id), item.range, {});
        const TypeInfo type = type_info(values[i].type);
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
void Checker::fill_cycle(const nc::BlockPlan& plan, std::span<const Value> values,
                         std::span<const ExprId> items, Reg first, SourceCycle& cycle) {
    for (const nc::Hole& hole : plan.holes) {
        const SourceRange range = ast()[items[hole.word]].range;
        const Reg mark = emit_.mark();
        const auto known =
            std::ranges::find(cycle.arguments, hole.parameter, &SourceCycle::Argument::parameter);
        const auto place = static_cast<Reg>(first + (known - cycle.arguments.begin()));
        const bool adds = hole.adds && known != cycle.arguments.end();
        const Reg reg = adds ? emit_.take(1) : place;
        emit_.set_location(range);
        const Filling filling =
            fill_value(values[hole.word], hole.dimension, range, sources_.text(range), reg);
        // A sign of the pattern holds for values with units as well (`{-pitch}`).
        const bool is_count = filling.form == Filling::Form::Count;
        if (hole.factor != 1 && !is_count) emit_.emit_number(OpCode::MulFK, reg, reg, hole.factor);
        if (adds) {
            // A clearance is entered without its sign (S 9.1 SDIS).
            emit_.emit(OpCode::Math1, reg, reg, static_cast<unsigned>(Math::Abs));
            emit_.emit(OpCode::AddF, place, place, reg);
        } else cycle.arguments.push_back({hole.parameter, is_count});
        emit_.release_to(mark);
    }
}

Value Checker::cycle_call(const Expr& expr, SourceCycle::Kind kind) {
    const nc::Dialect& dialect = *modules_[module_].dialect;
    const SourceRange range = ast()[expr.child[0]].range;
    SourceCycle cycle;
    cycle.kind = kind;
    cycle.word = text(ast()[expr.child[0]].text);
    const Reg mark = emit_.mark();
    const Value nothing = in_registers(types::kVoid, 0);
    const std::span<const ExprId> items = ast().exprs(expr.list);
    std::vector<Value> values;
    const std::vector<nc::SourceArgument> arguments = source_arguments(items, values);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (arguments[i].kind != nc::SourceArgument::Kind::Empty && is_error(values[i]))
            return nothing;
    }
    const auto plan = nc::plan_call(dialect, cycle.word, range, arguments, sink_);
    if (!plan || !begin_cycle(cycle, plan->block.cycle, range)) return nothing;
    const nc::Invocation& invocation = plan->block.functions[0];
    for (unsigned i = 0; i < 32; ++i) {
        if ((invocation.given >> i & 1u) != 0) {
            cycle.fixed.emplace_back(static_cast<std::uint8_t>(i),
                                     plan->block.argument(invocation, i));
        }
    }
    const Reg first = emit_.take(std::max<unsigned>(1, static_cast<unsigned>(plan->holes.size())));
    fill_cycle(*plan, values, items, first, cycle);
    emit_.set_location(expr.range);
    emit_cycle(std::move(cycle), first, expr.range);
    emit_.release_to(mark);
    return nothing;
}

bool Checker::is_modal_call(std::span<const Word> words) const {
    const std::string_view name = modules_[module_].dialect->modal_call();
    return !name.empty() && std::ranges::any_of(words, [&](const Word& word) {
        return word.form == Word::Form::Bare && text(word.address) == name;
    });
}

/// `MCALL CYCLE81(…);` and `MCALL;`. What stands behind the word is a point to the parser.
void Checker::modal_call(const Stmt& stmt) {
    const std::span<const Word> words = ast().word_run(stmt.words);
    const std::string_view name = modules_[module_].dialect->modal_call();
    for (const Word& word : words) {
        const bool is_number = word.form == Word::Form::Literal && text(word.address) == "N";
        if (is_number || text(word.address) == name) continue;
        report(diag::BlockWordAlone, word.range).arg(name);
        return;
    }
    if (stmt.skip_level >= 0) {
        report(diag::SkipState, words[0].range).arg(name);
        return;
    }
    const ExprId id = stmt.expression[0];
    if (!id.is_valid()) {
        emit_.set_location(stmt.range);
        emit_.emit(OpCode::EndCycle);
        return;
    }
    const Expr& expr = ast()[id];
    const bool is_call = expr.kind == ExprKind::Call && ast()[expr.child[0]].kind == ExprKind::Name;
    const nc::CallMeaning meaning =
        is_call ? nc::call_meaning(*modules_[module_].dialect, text(ast()[expr.child[0]].text))
                : nc::CallMeaning{};
    if (meaning.function != nc::Function::Cycle) {
        report(diag::SourceModalCall, expr.range).arg(name);
        return;
    }
    cycle_call(expr, SourceCycle::Kind::Called);
}

}  // namespace kadr::sema
