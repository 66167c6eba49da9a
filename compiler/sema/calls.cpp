// calls.cpp — calls: functions and cycles of the program, functions of the vocabulary, methods of
// arrays, tables.
#include "sema/calls.h"

#include <algorithm>

#include "base/diagnostics/dialect.h"
#include "base/diagnostics/sema.h"
#include "base/text.h"
#include "sema/block_checks.h"
#include "sema/block_fillings.h"
#include "sema/block_words.h"
#include "sema/blocks.h"
#include "sema/builtin_calls.h"
#include "sema/builtins.h"
#include "sema/checking.h"
#include "sema/contours.h"
#include "sema/convert.h"
#include "sema/csv.h"
#include "sema/cycle_blocks.h"
#include "sema/expressions.h"
#include "sema/library_tools.h"
#include "sema/lvalues.h"
#include "sema/optionals.h"
#include "sema/picture.h"
#include "sema/scope.h"
#include "sema/statements.h"
#include "sema/tests.h"
#include "sema/texts.h"
#include "sema/type_declarations.h"
#include "sema/unknown_names.h"
#include "sema/values.h"
#include "sema/with.h"
#include "syntax/habits.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;

namespace {

std::string name_in_library(Check& check, std::string_view name);
std::string parameter_list(const Check& check, const syntax::Expr& expr,
                           std::span<const std::string_view> names, std::uint32_t required);
Value call_function(Check& check, std::uint32_t function, const syntax::Expr& expr);
Value call_method(Check& check, syntax::ExprId id, const syntax::Expr& callee, Reg hint);
Value array_method(Check& check, const Lvalue& array, const syntax::Expr& callee,
                   const syntax::Expr& expr);
Value string_method(Check& check, const Lvalue& string, const syntax::Expr& callee,
                    const syntax::Expr& expr);
void add_default(Check& check, TableColumn& column, const Member& member);
bool is_picture(const Check& check, Type type, PictureSource& source);

}  // namespace

Value call(Check& check, ExprId id, Reg hint) {
    const Expr& expr = check.ast()[id];
    const Expr& callee = check.ast()[expr.child[0]];
    if (callee.kind == ExprKind::Member) return call_method(check, id, callee, hint);
    if (callee.kind != ExprKind::Name) {
        if (callee.kind != ExprKind::Invalid)
            check.report(diag::NotAFunction, callee.range).arg(check.sources.text(callee.range));
        return error_value();
    }
    const std::string_view name = check.text(callee.text);
    if (name.empty()) return error_value();
    const Found found = look_up(check, expr.child[0]);
    if (found.symbol < 0 && found.name != nullptr) check_unambiguous(check, name, callee.range);
    if (found.symbol < 0 && found.name != nullptr && found.name->what == Name::What::Function) {
        return call_function(check, found.name->index, expr);
    }
    if (found.symbol < 0 && found.name != nullptr && found.name->what == Name::What::Curve) {
        check.report(diag::CurveAsValue, callee.range).arg(name);
        return error_value();
    }
    if (const std::optional<Value> value = builtin(check, name, expr, hint)) return *value;
    if (const std::optional<nc::Function> function = nc::find_function(name);
        function && *function != nc::Function::None && *function != nc::Function::Cycle &&
        !nc::is_no_command(*function)) {
        return call_vocabulary(check, nc::info(*function), expr);
    }
    if (found.symbol >= 0 || found.name != nullptr) {
        check.report(diag::NotAFunction, callee.range).arg(name);
        return error_value();
    }
    if (!require_not_lost(check, name)) return error_value();
    // `MSG("…")` and `CYCLE81(…)`, as the control of the input dialect has them.
    const nc::CallMeaning meaning = nc::call_meaning(check.dialect(), name);
    if (meaning.function == nc::Function::Cycle)
        return cycle_call(check, expr, SourceCycle::Kind::Once);
    if (meaning.function != nc::Function::None)
        return call_vocabulary(check, nc::info(meaning.function), expr);
    if (!require_no_foreign_keyword(check, name, callee.range)) return error_value();
    auto builder = check.report(diag::UnknownFunction, callee.range);
    builder.arg(name);
    if (name == "cycle" || name == "program") {
        builder.fix("declare it in the file, `" + std::string(name) +
                    " name(…) { … }`, and call a cycle by its name");
        return error_value();
    }
    if (!take_proposal(check)) return error_value();
    if (const auto module = check.loader.library_module_of(name)) {
        builder.fix("it is in the library: `import " + *module + ";`");
        return error_value();
    }
    if (const std::string other = name_in_library(check, name); !other.empty()) {
        builder.fix(other);
        return error_value();
    }
    if (const std::string cycle = hint_of_cycle(check, name); !cycle.empty()) {
        builder.fix(cycle);
        return error_value();
    }
    if (const syntax::Habit* habit = syntax::habit_of(name)) {
        syntax::advise(builder, *habit, callee.range);
        return error_value();
    }
    if (fix_statement(check, name, callee.range, builder)) return error_value();  // `RETURN (x);`
    const std::vector<std::string_view> names = known_names(check, true);
    if (const auto near = nearest_name(name, names.data(), names.size())) {
        builder.fix(callee.range, std::string(*near), "did you mean " + quoted(*near) + "?");
    }
    return error_value();
}

namespace {

/// `peck_drill`, which the library has with its words in another order; empty: it has none.
std::string name_in_library(Check& check, std::string_view name) {
    constexpr std::size_t kMostWords = 4;
    std::vector<std::string> words(1);
    for (const char c : name) {
        if (c == '_') words.emplace_back();
        else words.back() += c;
    }
    if (words.size() < 2 || words.size() > kMostWords) return "";
    std::sort(words.begin(), words.end());
    do {
        std::string other;
        for (const std::string& word : words) other += (other.empty() ? "" : "_") + word;
        if (const auto module = check.loader.library_module_of(other))
            return "it is in the library as `" + other + "`: `import " + *module + ";`";
    } while (std::next_permutation(words.begin(), words.end()));
    return "";
}

}  // namespace

std::optional<std::vector<ExprId>> bind_arguments(Check& check, const Expr& expr,
                                                  std::string_view name,
                                                  std::span<const std::string_view> names,
                                                  const SourceRange& declared,
                                                  std::uint32_t required) {
    std::vector<ExprId> bound(names.size());
    std::size_t next = 0;
    bool named_before = false;
    bool is_good = true;
    for (const ExprId item : check.ast().exprs(expr.list)) {
        const Expr& argument = check.ast()[item];
        const bool is_named = argument.kind == ExprKind::Argument && !argument.text.is_empty();
        const ExprId value = argument.kind == ExprKind::Argument ? argument.child[0] : item;
        std::size_t at = next;
        if (is_named) {
            named_before = true;
            const auto found = std::find(names.begin(), names.end(), check.text(argument.text));
            if (found == names.end()) {
                auto builder = check.report(diag::UnknownArgument, argument.range);
                builder.arg(name).arg(check.text(argument.text));
                if (declared.file.is_valid()) builder.note(declared, "it is declared here");
                const std::string_view wrong = check.text(argument.text);
                // Of two letters every word of three is near.
                const auto near = wrong.size() > 2 ? nearest_name(wrong, names.data(), names.size())
                                                   : std::nullopt;
                if (near) builder.fix("did you mean " + quoted(*near) + "?");
                else if (!names.empty()) builder.fix(parameter_list(check, expr, names, required));
                is_good = false;
                continue;
            }
            at = static_cast<std::size_t>(found - names.begin());
        } else if (named_before) {
            check.report(diag::PositionalAfterNamed, argument.range).arg(name);
            is_good = false;
            continue;
        } else if (at >= names.size()) {
            auto builder = check.report(diag::TooManyArguments, argument.range);
            builder.arg(name).arg(names.size());
            if (declared.file.is_valid()) builder.note(declared, "it is declared here");
            is_good = false;
            break;
        }
        if (bound[at].is_valid()) {
            check.report(diag::ArgumentTwice, argument.range).arg(name).arg(names[at]);
            is_good = false;
            continue;
        }
        bound[at] = value;
        next = at + 1;
    }
    if (!is_good) {
        return std::nullopt;
    }
    return bound;
}

namespace {

/// The parameters for a person who named another one, and which of them the call still needs.
std::string parameter_list(const Check& check, const Expr& expr,
                           std::span<const std::string_view> names, std::uint32_t required) {
    std::string all;
    std::string missing;
    for (std::size_t i = 0; i < names.size(); ++i) {
        all += (all.empty() ? "" : ", ") + quoted(names[i]);
        const auto items = check.ast().exprs(expr.list);
        const bool is_given =
            std::ranges::any_of(
                items, [&](ExprId id) { return check.text(check.ast()[id].text) == names[i]; }) ||
            (i < items.size() && check.ast()[items[i]].text.is_empty());
        if ((required >> i & 1u) != 0 && !is_given)
            missing += (missing.empty() ? "" : ", ") + quoted(names[i]);
    }
    return "it has " + all + (missing.empty() ? "" : "; it needs " + missing);
}

}  // namespace

void pass_argument(Check& check, const ParameterDecl& parameter, ExprId argument, Reg first) {
    const auto target = static_cast<Reg>(first + parameter.reg);
    if (!parameter.is_reference) {
        expression_in(check, argument, parameter.type, target, parameter.name);
        return;
    }
    const SourceRange range = check.ast()[argument].range;
    const Expr& expr = check.ast()[argument];
    const bool is_path = expr.kind == ExprKind::Name || expr.kind == ExprKind::Index ||
                         expr.kind == ExprKind::Member;
    if (!is_path) {
        check.report(diag::ReferenceArgument, range).arg(parameter.name);
        return;
    }
    const Reg mark = check.emit.mark();
    const std::optional<Lvalue> found = lvalue(check, argument);
    if (!found) return;
    if (found->is_temporary) {
        check.report(diag::ReferenceArgument, range).arg(parameter.name);
    } else if (require_assignable(check, *found, range)) {
        if (found->type != parameter.type) {
            check_places(check, found->type, parameter.type, range, parameter.name);
        } else {
            check.emit.emit(OpCode::Move, target, reference_to(check, *found));
            note_assignment(check, *found);
        }
    }
    check.emit.release_to(mark);
}

/// The parameters that a call names, as uses of them.
void note_arguments(Check& check, const FunctionDecl& function, const Expr& expr) {
    for (const ExprId id : check.ast().exprs(expr.list)) {
        const Expr& argument = check.ast()[id];
        if (argument.kind != ExprKind::Argument || argument.text.is_empty()) continue;
        const auto named =
            std::ranges::find(function.parameters, check.text(argument.text), &ParameterDecl::name);
        if (named != function.parameters.end())
            check.record.note_use(check.here.module, id, named->checked);
    }
}

namespace {

Value call_function(Check& check, std::uint32_t index, const Expr& expr) {
    check.names.want(index);
    const FunctionDecl function = check.names.function(index);
    const bool may_call = check.here.module == 0 && check.here.function != nullptr &&
                          !check.options.calls_programs.empty() &&
                          check.here.function->name == check.options.calls_programs;
    if (function.kind == syntax::DeclKind::Program && !may_call) {
        check.report(diag::ProgramCalled, expr.range).arg(function.name);
        return error_value();
    }
    std::vector<std::string_view> names;
    for (const ParameterDecl& parameter : function.parameters) names.push_back(parameter.name);
    std::uint32_t required = 0;
    for (std::size_t i = 0; i < function.parameters.size(); ++i)
        required |= function.parameters[i].is_required ? 1u << i : 0u;
    const auto bound = bind_arguments(check, expr, function.name, names, function.range, required);
    if (!bound)
        return function.result == types::kVoid ? in_registers(types::kVoid, 0) : error_value();
    note_arguments(check, function, expr);

    const unsigned result_slots = check.type_info(function.result).slots;
    const Reg first =
        check.emit.take(std::max({1u, result_slots, unsigned{function.parameter_slots}}));
    std::uint32_t given = 0;
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const ParameterDecl& parameter = function.parameters[i];
        if ((*bound)[i].is_valid()) {
            pass_argument(check, parameter, (*bound)[i], first);
            given |= 1u << i;
        } else if (parameter.is_required) {
            check.report(diag::ArgumentMissing, expr.range)
                .arg(function.name)
                .arg(parameter.name)
                .note(parameter.range, "it is declared here");
        }
    }
    check.emit.set_location(expr.range);
    check.emit.emit_pair(OpCode::Call, first, index + 1,
                         static_cast<unsigned>(check.here.loop_depth),
                         statement_id(check, expr.range), static_cast<std::int32_t>(given));
    Value value = in_registers(function.result, first);
    value.is_fresh = true;
    return value;
}

}  // namespace

// ---------------------------------------------------------------- vocabulary

/// `mirror(x: true)`: the axis is named, at 0; nothing: it is not named, `false`. A mirror is about
/// the zero point on every control, and takes no other coordinate.
std::optional<Value> named_axis(Check& check, const nc::FunctionInfo& info,
                                const nc::Parameter& parameter, const Value& value,
                                const SourceRange& range) {
    const bool names = parameter.dimension == nc::Dimension::Length &&
                       nc::has_fact(info.function, nc::Fact::NamesAxes);
    if (!names || check.is_error(value)) return value;
    if (value.is_constant() && check.kind(value.type) == TypeKind::Bool) {
        if (value.constant.integer == 0) return std::nullopt;
        return constant_number(0, types::kReal);
    }
    const bool is_zero = value.is_constant() && check.types.is_numeric(value.type) &&
                         (check.kind(value.type) == TypeKind::Int ? value.constant.integer == 0
                                                                  : value.constant.number == 0);
    if (is_zero || !nc::has_fact(info.function, nc::Fact::Mirrors)) return value;
    check.report(diag::MirrorPlace, range)
        .arg(parameter.name)
        .fix(range, "true", "name the axis, and shift the zero point before");
    return error_value();
}

Value call_vocabulary(Check& check, const nc::FunctionInfo& info, const Expr& expr) {
    std::vector<std::string_view> names;
    for (const nc::Parameter& parameter : info.parameters) names.push_back(parameter.name);
    const auto bound = bind_arguments(check, expr, info.name, names, {});
    if (!bound || !require_least(check, info, *bound, expr)) return in_registers(types::kVoid, 0);
    const Reg mark = check.emit.mark();
    Plan plan;
    nc::Invocation invocation;
    invocation.function = info.function;
    invocation.first = 0;
    plan.argument_count = static_cast<std::uint8_t>(names.size());
    const Reg first = check.emit.take(std::max<unsigned>(1, static_cast<unsigned>(names.size())));
    for (std::size_t i = 0; i < names.size(); ++i) {
        const nc::Parameter& parameter = info.parameters[i];
        if (!(*bound)[i].is_valid()) {
            if (!parameter.is_optional)
                check.report(diag::ArgumentMissing, expr.range).arg(info.name).arg(parameter.name);
            continue;
        }
        const SourceRange range = check.ast()[(*bound)[i]].range;
        const auto reg = static_cast<Reg>(first + plan.fillings.size());
        Filling filling;
        if (parameter.dimension == nc::Dimension::Text) {
            expression_in(check, (*bound)[i], types::kString, reg, parameter.name);
            filling.form = Filling::Form::Text;
        } else {
            const Reg inner = check.emit.mark();
            Value value = expression(check, (*bound)[i]);
            if (info.function == nc::Function::Tool && check.kind(value.type) == TypeKind::String)
                value = called_tool(check, value, range);
            const std::optional<Value> named = named_axis(check, info, parameter, value, range);
            if (!named) {
                check.emit.release_to(inner);
                continue;
            }
            value = *named;
            if (parameter.dimension == nc::Dimension::Length &&
                !require_no_diameter(check, value, range, parameter.name))
                value = error_value();
            filling = fill_value(check, value, parameter.dimension, range, parameter.name, reg);
            check.emit.release_to(inner);
        }
        filling.is_argument = true;
        filling.index = static_cast<std::uint8_t>(i);
        filling.invocation = 0;
        filling.parameter = static_cast<std::uint8_t>(i);
        plan.fillings.push_back(filling);
    }
    if (info.group == nc::Group::Motion) plan.motion = info.function;
    else plan.functions.push_back(invocation);
    if (info.function == nc::Function::Inch || info.function == nc::Function::Metric) {
        check_units_function(check, info.function, expr.range);
    }
    check.emit.set_location(expr.range);
    emit_plan(check, std::move(plan), first, 0, expr.range);
    check.emit.release_to(mark);
    return in_registers(types::kVoid, 0);
}

// ---------------------------------------------------------------- methods

std::optional<Value> property_value(Check& check, const Lvalue& whole, const Expr& expr) {
    const TypeKind k = check.kind(whole.type);
    const std::string_view name = check.text(expr.text);
    if (k == TypeKind::Execution) return figure(check, whole, expr, nullptr);
    if (k != TypeKind::Array && k != TypeKind::String) return std::nullopt;
    if (check.is_contour(check.types.given(whole.type)) && name != "count") {
        const Value contour =
            require_given(check, load(check, whole, expr.range, true, kNoReg), expr.range, {});
        if (check.is_error(contour)) return contour;
        if (const std::optional<Value> value = contour_property(check, contour, expr))
            return *value;
    }
    if (name != "count" && name != "length") {
        check.report(diag::UnknownMember, expr.range).arg(check.type_name(whole.type)).arg(name);
        return error_value();
    }
    const TypeInfo& info = check.type_info(whole.type);
    if (k == TypeKind::Array && info.count >= 0) return constant_integer(info.count, types::kInt);
    const Value value =
        require_given(check, load(check, whole, expr.range, true, kNoReg), expr.range, {});
    if (check.is_error(value)) return value;
    const Reg reg = check.emit.take(1);
    check.emit.emit(k == TypeKind::Array ? OpCode::CountArray : OpCode::CountText, reg, value.reg);
    return in_registers(types::kInt, reg);
}

namespace {

Value call_method(Check& check, ExprId id, const Expr& callee, Reg hint) {
    const Expr& expr = check.ast()[id];
    (void)hint;
    const std::optional<Lvalue> owner = owner_lvalue(check, callee.child[0]);
    if (!owner) return error_value();
    if (check.kind(owner->type) == TypeKind::Array)
        return array_method(check, *owner, callee, expr);
    if (check.kind(owner->type) == TypeKind::Execution) return figure(check, *owner, callee, &expr);
    if (check.kind(owner->type) == TypeKind::String)
        return string_method(check, *owner, callee, expr);
    check.report(diag::UnknownMethod, callee.range)
        .arg(check.type_name(owner->type))
        .arg(check.text(callee.text));
    return error_value();
}

Value array_method(Check& check, const Lvalue& array, const Expr& callee, const Expr& expr) {
    const std::string_view name = check.text(callee.text);
    const TypeInfo info = check.type_info(array.type);
    const Type element = info.element;
    const std::uint16_t slots = check.type_info(element).slots;
    const bool adds = name == "append" || name == "add";
    const bool inserts = name == "insert";
    const bool removes = name == "remove";
    const bool pops = name == "pop";
    const bool clears = name == "clear";
    if (name == "count") {
        if (!require_argument_count(check, expr, name, 0, 0)) return error_value();
        const std::optional<Value> count = property_value(check, array, callee);
        return count ? *count : error_value();
    }
    if (info.is_contour || (!adds && !inserts && !removes && !pops && !clears)) {
        auto builder = check.report(diag::UnknownMethod, callee.range);
        builder.arg(check.type_name(array.type)).arg(name);
        // As lists of other languages call them.
        static constexpr std::pair<std::string_view, std::string_view> kOthers[] = {
            {"push_back", "append"}, {"push", "append"},  {"size", "count"}, {"length", "count"},
            {"pop_back", "pop"},     {"erase", "remove"}, {"len", "count"}};
        const auto* const other =
            std::ranges::find(kOthers, name, &std::pair<std::string_view, std::string_view>::first);
        if (other != std::end(kOthers)) {
            builder.fix("here it is " + quoted(other->second));
        } else if (const auto near =
                       nearest_name(name, array_methods().data(), array_methods().size())) {
            builder.fix("did you mean " + quoted(*near) + "?");
        }
        return error_value();
    }
    if (!require_assignable(check, array, callee.range)) return error_value();
    if (info.count >= 0) {
        check.report(diag::FixedArrayGrows, callee.range)
            .arg(check.type_name(array.type))
            .arg(name);
        return error_value();
    }
    if (!require_argument_count(check, expr, name,
                                inserts           ? 2
                                : adds || removes ? 1
                                                  : 0,
                                inserts           ? 2
                                : adds || removes ? 1
                                                  : 0)) {
        return error_value();
    }
    const auto arguments = check.ast().exprs(expr.list);
    const auto value_of = [&](std::size_t i) {
        const Expr& item = check.ast()[arguments[i]];
        return item.kind == ExprKind::Argument ? item.child[0] : arguments[i];
    };
    const Value handle = load(check, array, callee.range, false, kNoReg);
    if (adds || inserts) {
        Reg at = 0;
        if (inserts) at = expression_in(check, value_of(0), types::kInt, kNoReg, "the index");
        const Reg reg = check.emit.take(slots);
        expression_in(check, value_of(inserts ? 1 : 0), element, reg, "the element");
        check.emit.set_location(expr.range);
        if (inserts) check.emit.emit(OpCode::InsertAt, handle.reg, reg, at);
        else check.emit.emit(OpCode::Append, handle.reg, reg);
        return in_registers(types::kVoid, 0);
    }
    if (clears) {
        check.emit.emit(OpCode::ClearArray, handle.reg);
        return in_registers(types::kVoid, 0);
    }
    Reg at = 0;
    if (removes) {
        at = expression_in(check, value_of(0), types::kInt, kNoReg, "the index");
    } else {
        at = check.emit.take(1);
        check.emit.set_location(expr.range);
        check.emit.emit(OpCode::CountArray, at, handle.reg);
        check.emit.emit(OpCode::CheckFilled, at);
        check.emit.emit_integer(OpCode::AddIK, at, at, -1);
    }
    check.emit.set_location(expr.range);
    const Reg result = check.emit.take(slots);
    if (slots == 1) check.emit.emit(OpCode::LoadElement, result, handle.reg, at);
    else check.emit.emit_pair(OpCode::LoadElementN, result, handle.reg, at, 0, slots);
    check.emit.emit(OpCode::RemoveAt, handle.reg, at);
    Value value = in_registers(element, result);
    value.is_fresh = true;
    return value;
}

Value string_method(Check& check, const Lvalue& string, const Expr& callee, const Expr& expr) {
    const std::string_view name = check.text(callee.text);
    const bool is_part = name == "part";
    if (name == "count") {
        if (!require_argument_count(check, expr, name, 0, 0)) return error_value();
        const std::optional<Value> count = property_value(check, string, callee);
        return count ? *count : error_value();
    }
    if (!is_part && name != "find") {
        auto builder = check.report(diag::UnknownMethod, callee.range);
        builder.arg(check.type_name(string.type)).arg(name);
        if (const auto near = nearest_name(name, text_methods().data(), text_methods().size())) {
            builder.fix("did you mean " + quoted(*near) + "?");
        }
        return error_value();
    }
    static constexpr std::string_view kPart[] = {"from", "count"};
    static constexpr std::string_view kFind[] = {"text"};
    const auto bound = bind_arguments(
        check, expr, name, is_part ? std::span<const std::string_view>(kPart) : kFind, {});
    if (!bound) return error_value();
    if (!(*bound)[0].is_valid()) {
        check.report(diag::ArgumentMissing, expr.range).arg(name).arg(is_part ? "from" : "text");
        return error_value();
    }
    const Value whole =
        require_given(check, load(check, string, callee.range, true, kNoReg), callee.range, {});
    if (check.is_error(whole)) return whole;
    const Reg from = in_register(check, whole);
    const Reg first = check.emit.take(is_part ? 2 : 1);
    expression_in(check, (*bound)[0], is_part ? types::kInt : types::kString, first,
                  is_part ? "from" : "text");
    if (is_part) {
        const auto count = static_cast<Reg>(first + 1);
        if ((*bound)[1].is_valid()) expression_in(check, (*bound)[1], types::kInt, count, "count");
        else emit_unset(check, check.types.optional(types::kInt), count);
    }
    const Reg reg = check.emit.take(1);
    check.emit.set_location(expr.range);
    check.emit.emit(is_part ? OpCode::PartOfText : OpCode::FindText, reg, from, first);
    return in_registers(is_part ? types::kString : types::kInt, reg);
}

}  // namespace

// ---------------------------------------------------------------- tables

namespace {

void add_columns(Check& check, TableSchema& schema, Type type, const std::string& prefix,
                 std::uint16_t slot) {
    const StructInfo& info = check.types.struct_of(type);
    for (const Member& member : info.members) {
        const auto at = static_cast<std::uint16_t>(slot + member.offset);
        const TypeInfo& member_type = check.type_info(member.type);
        if (member_type.kind == TypeKind::Struct) {
            add_columns(check, schema, member.type, prefix + member.name + '.', at);
            continue;
        }
        TableColumn column;
        column.name = prefix + member.name;
        column.slot = at;
        column.quantity = member_type.quantity;
        column.is_optional = member_type.is_optional;
        using K = TableColumn::Kind;
        switch (member_type.kind) {
            case TypeKind::Bool: column.kind = K::Bool; break;
            case TypeKind::Int: column.kind = K::Integer; break;
            case TypeKind::Real: column.kind = K::Number; break;
            case TypeKind::Feed: column.kind = K::Feed; break;
            case TypeKind::Speed: column.kind = K::Speed; break;
            case TypeKind::String: column.kind = K::Text; break;
            case TypeKind::Enum:
                column.kind = K::Enum;
                column.enumeration = member_type.definition;
                break;
            default: continue;
        }
        if (member.initial.is_valid()) add_default(check, column, member);
        schema.columns.push_back(std::move(column));
    }
}

/// What a table without the column has in it. A default that must be worked out in the running
/// program is none: the column is missing then.
void add_default(Check& check, TableColumn& column, const Member& member) {
    const std::uint32_t here = std::exchange(check.here.module, member.module);
    const Units before = std::exchange(check.here.units, check.names.module(member.module).units);
    const Reg mark = check.emit.mark();
    const Value value = convert(check, expression(check, member.initial, member.type), member.type,
                                check.ast()[member.initial].range, member.name);
    if (value.is_constant()) {
        column.initial.emplace();
        if (column.kind == TableColumn::Kind::Text)
            column.initial_text =
                check.code->texts[static_cast<std::size_t>(value.constant.integer)];
        else if (check.kind(member.type) == TypeKind::Real ||
                 check.kind(member.type) == TypeKind::Feed ||
                 check.kind(member.type) == TypeKind::Speed)
            column.initial->number = value.constant.number;
        else column.initial->integer = value.constant.integer;
    }
    check.emit.release_to(mark);
    check.here.module = here;
    check.here.units = before;
}

/// Where names of files in the present file are relative to; ends in a slash or is empty.
std::string folder_of_file(const Check& check) {
    const std::string_view file = check.sources.name(check.ast().file);
    const std::size_t slash = file.find_last_of("/\\");
    return slash == std::string_view::npos ? "" : std::string(file.substr(0, slash + 1));
}

/// `image<picture>("part.pgm")`: a struct of width, height and brightness.
Value image_call(Check& check, const Expr& expr) {
    if (!require_argument_count(check, expr, "image", 1, 1)) return error_value();
    const Type type = resolve_type(check, expr.type);
    if (check.kind(type) == TypeKind::Error) return error_value();
    PictureSource source;
    if (!is_picture(check, type, source)) {
        check.report(diag::ImageType, expr.range).arg(check.type_name(type));
        return error_value();
    }
    const ExprId item = check.ast().exprs(expr.list)[0];
    const ExprId argument =
        check.ast()[item].kind == ExprKind::Argument ? check.ast()[item].child[0] : item;
    source.folder = folder_of_file(check);
    source.layout = layout_constant(check, types::kReal);
    const Value path = convert(check, expression(check, argument, types::kString), types::kString,
                               check.ast()[argument].range, {});
    if (check.is_error(path)) return path;
    const Reg reg = check.emit.take(check.type_info(type).slots);
    const auto index = static_cast<std::int64_t>(check.code->pictures.size());
    if (path.is_constant()) {
        const std::string name = check.code->texts[static_cast<std::size_t>(path.constant.integer)];
        std::optional<Picture> picture = read_picture(
            source.folder, name, check.ast()[argument].range, check.options.access, check.sink);
        if (!picture) return error_value();
        source.picture = std::move(*picture);
        check.emit.emit_pair(OpCode::LoadImage, reg, 0, 0, index);
    } else {
        const Reg name = in_register(check, path);
        check.emit.emit_pair(OpCode::ReadImage, reg, name, 0, index);
    }
    check.code->pictures.push_back(std::move(source));
    Value value = in_registers(type, reg);
    value.is_fresh = true;
    return value;
}

/// Whether a struct has `int width`, `int height`, `real[] dots` and nothing else; notes where.
bool is_picture(const Check& check, Type type, PictureSource& source) {
    if (check.kind(type) != TypeKind::Struct) return false;
    const StructInfo& info = check.types.struct_of(type);
    unsigned found = 0;
    for (const Member& member : info.members) {
        const TypeInfo& member_type = check.type_info(member.type);
        const bool is_count = member_type.kind == TypeKind::Int && !member_type.is_optional;
        const bool is_dots = member_type.kind == TypeKind::Array && member_type.count < 0 &&
                             member_type.element == types::kReal;
        const auto at = static_cast<std::uint16_t>(member.offset);
        if (member.name == "width" && is_count) source.width = at, found |= 1u;
        if (member.name == "height" && is_count) source.height = at, found |= 2u;
        if (member.name == "dots" && is_dots) source.dots = at, found |= 4u;
    }
    return found == 7u && info.members.size() == 3;
}

}  // namespace

Value table(Check& check, const Expr& expr) {
    if (check.text(expr.text) == "image") return image_call(check, expr);
    if (check.text(expr.text) != "table") {
        check.report(diag::UnknownFunction, expr.range)
            .arg(check.text(expr.text))
            .fix("did you mean `table`?");
        return error_value();
    }
    const Type row = resolve_type(check, expr.type);
    if (!require_argument_count(check, expr, "table", 1, 1)) return error_value();
    const ExprId item = check.ast().exprs(expr.list)[0];
    const ExprId argument =
        check.ast()[item].kind == ExprKind::Argument ? check.ast()[item].child[0] : item;
    if (check.kind(row) == TypeKind::Error) return error_value();
    if (check.kind(row) != TypeKind::Struct || check.types.holds_array(row)) {
        check.report(diag::TableType, expr.range).arg(check.type_name(row));
        return error_value();
    }
    TableSchema schema;
    schema.type_name = check.type_name(row);
    add_columns(check, schema, row, "", 0);
    schema.layout = layout_constant(check, row);
    schema.slots = check.type_info(row).slots;
    schema.units = check.here.units;
    schema.folder = folder_of_file(check);
    // Enums must be known where the table is read, which may be before the check is over.
    std::vector<EnumNames> enums;
    for (std::size_t i = 0; i < check.types.enum_count(); ++i) {
        enums.push_back({check.types.enum_at(i).name, check.types.enum_at(i).members});
    }
    const Value path = convert(check, expression(check, argument, types::kString), types::kString,
                               check.ast()[argument].range, {});
    if (check.is_error(path)) return path;
    const auto index = static_cast<std::uint32_t>(check.code->schemas.size());
    check.code->schemas.push_back(schema);
    const Reg reg = check.emit.take(1);
    if (path.is_constant()) {
        const std::string name = check.code->texts[static_cast<std::size_t>(path.constant.integer)];
        std::optional<TableRows> rows = read_table(schema, enums, name, check.ast()[argument].range,
                                                   check.options.access, check.sink);
        if (!rows) return error_value();
        check.emit.emit_pair(OpCode::LoadTable, reg, 0, 0,
                             static_cast<std::int64_t>(check.code->tables.size()));
        check.code->tables.push_back({index, std::move(*rows)});
    } else {
        const Reg name = in_register(check, path);
        check.emit.emit_pair(OpCode::ReadTable, reg, name, 0, index);
    }
    Value value = in_registers(check.types.array(row, -1), reg);
    value.is_fresh = true;
    return value;
}

}  // namespace kadr::sema
