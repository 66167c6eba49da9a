// calls.cpp — calls: functions and cycles of the program, functions of the vocabulary, methods of
// arrays, tables.
#include <algorithm>

#include "base/diagnostics/dialect.h"
#include "base/diagnostics/sema.h"
#include "base/text.h"
#include "sema/builtins.h"
#include "sema/checker.h"
#include "sema/csv.h"
#include "sema/picture.h"
#include "syntax/habits.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;

Value Checker::call(ExprId id, Reg hint) {
    const Expr& expr = ast()[id];
    const Expr& callee = ast()[expr.child[0]];
    if (callee.kind == ExprKind::Member) return call_method(id, callee, hint);
    if (callee.kind != ExprKind::Name) {
        if (callee.kind != ExprKind::Invalid)
            report(diag::NotAFunction, callee.range).arg(sources_.text(callee.range));
        return error_value();
    }
    const std::string_view name = text(callee.text);
    if (name.empty()) return error_value();
    const Found found = look_up(expr.child[0]);
    if (found.symbol < 0 && found.name != nullptr) check_unambiguous(name, callee.range);
    if (found.symbol < 0 && found.name != nullptr && found.name->what == Name::What::Function) {
        return call_function(found.name->index, expr);
    }
    if (found.symbol < 0 && found.name != nullptr && found.name->what == Name::What::Curve) {
        report(diag::CurveAsValue, callee.range).arg(name);
        return error_value();
    }
    if (const std::optional<Value> value = builtin(name, expr, hint)) return *value;
    if (const std::optional<nc::Function> function = nc::find_function(name);
        function && *function != nc::Function::None && *function != nc::Function::Cycle &&
        !nc::has_fact(*function, nc::Fact::ReadOnly)) {
        return call_vocabulary(nc::info(*function), expr);
    }
    if (found.symbol >= 0 || found.name != nullptr) {
        report(diag::NotAFunction, callee.range).arg(name);
        return error_value();
    }
    if (!require_not_lost(name)) return error_value();
    // `MSG("…")` and `CYCLE81(…)`, as the control of the input dialect has them.
    const nc::CallMeaning meaning = nc::call_meaning(*modules_[module_].dialect, name);
    if (meaning.function == nc::Function::Cycle) return cycle_call(expr, SourceCycle::Kind::Once);
    if (meaning.function != nc::Function::None)
        return call_vocabulary(nc::info(meaning.function), expr);
    if (!require_no_foreign_keyword(name, callee.range)) return error_value();
    auto builder = report(diag::UnknownFunction, callee.range);
    builder.arg(name);
    if (name == "cycle" || name == "program") {
        builder.fix("declare it in the file, `" + std::string(name) +
                    " name(…) { … }`, and call a cycle by its name");
        return error_value();
    }
    if (!take_proposal()) return error_value();
    if (const auto module = loader_.library_module_of(name)) {
        builder.fix("it is in the library: `import " + *module + ";`");
        return error_value();
    }
    if (const std::string other = name_in_library(name); !other.empty()) {
        builder.fix(other);
        return error_value();
    }
    if (const std::string cycle = hint_of_cycle(name); !cycle.empty()) {
        builder.fix(cycle);
        return error_value();
    }
    if (const syntax::Habit* habit = syntax::habit_of(name)) {
        syntax::advise(builder, *habit, callee.range);
        return error_value();
    }
    if (fix_statement(name, callee.range, builder)) return error_value();  // `RETURN (x);`
    const std::vector<std::string_view> names = known_names(true);
    if (const auto near = nearest_name(name, names.data(), names.size())) {
        builder.fix(callee.range, std::string(*near), "did you mean " + quoted(*near) + "?");
    }
    return error_value();
}

/// `peck_drill`, which the library has with its words in another order; empty: it has none.
std::string Checker::name_in_library(std::string_view name) {
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
        if (const auto module = loader_.library_module_of(other))
            return "it is in the library as `" + other + "`: `import " + *module + ";`";
    } while (std::next_permutation(words.begin(), words.end()));
    return "";
}

std::optional<std::vector<ExprId>> Checker::bind_arguments(const Expr& expr, std::string_view name,
                                                           std::span<const std::string_view> names,
                                                           const SourceRange& declared,
                                                           std::uint32_t required) {
    std::vector<ExprId> bound(names.size());
    std::size_t next = 0;
    bool named_before = false;
    bool is_good = true;
    for (const ExprId item : ast().exprs(expr.list)) {
        const Expr& argument = ast()[item];
        const bool is_named = argument.kind == ExprKind::Argument && !argument.text.is_empty();
        const ExprId value = argument.kind == ExprKind::Argument ? argument.child[0] : item;
        std::size_t at = next;
        if (is_named) {
            named_before = true;
            const auto found = std::find(names.begin(), names.end(), text(argument.text));
            if (found == names.end()) {
                auto builder = report(diag::UnknownArgument, argument.range);
                builder.arg(name).arg(text(argument.text));
                if (declared.file.is_valid()) builder.note(declared, "it is declared here");
                const std::string_view wrong = text(argument.text);
                // Of two letters every word of three is near.
                const auto near = wrong.size() > 2 ? nearest_name(wrong, names.data(), names.size())
                                                   : std::nullopt;
                if (near) builder.fix("did you mean " + quoted(*near) + "?");
                else if (!names.empty()) builder.fix(parameter_list(expr, names, required));
                is_good = false;
                continue;
            }
            at = static_cast<std::size_t>(found - names.begin());
        } else if (named_before) {
            report(diag::PositionalAfterNamed, argument.range).arg(name);
            is_good = false;
            continue;
        } else if (at >= names.size()) {
            auto builder = report(diag::TooManyArguments, argument.range);
            builder.arg(name).arg(names.size());
            if (declared.file.is_valid()) builder.note(declared, "it is declared here");
            is_good = false;
            break;
        }
        if (bound[at].is_valid()) {
            report(diag::ArgumentTwice, argument.range).arg(name).arg(names[at]);
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

/// The parameters for a person who named another one, and which of them the call still needs.
std::string Checker::parameter_list(const Expr& expr, std::span<const std::string_view> names,
                                    std::uint32_t required) const {
    std::string all;
    std::string missing;
    for (std::size_t i = 0; i < names.size(); ++i) {
        all += (all.empty() ? "" : ", ") + quoted(names[i]);
        const auto items = ast().exprs(expr.list);
        const bool is_given =
            std::ranges::any_of(items,
                                [&](ExprId id) { return text(ast()[id].text) == names[i]; }) ||
            (i < items.size() && ast()[items[i]].text.is_empty());
        if ((required >> i & 1u) != 0 && !is_given)
            missing += (missing.empty() ? "" : ", ") + quoted(names[i]);
    }
    return "it has " + all + (missing.empty() ? "" : "; it needs " + missing);
}

void Checker::pass_argument(const ParameterDecl& parameter, ExprId argument, Reg first) {
    const auto target = static_cast<Reg>(first + parameter.reg);
    if (!parameter.is_reference) {
        expression_in(argument, parameter.type, target, parameter.name);
        return;
    }
    const SourceRange range = ast()[argument].range;
    const Expr& expr = ast()[argument];
    const bool is_path = expr.kind == ExprKind::Name || expr.kind == ExprKind::Index ||
                         expr.kind == ExprKind::Member;
    if (!is_path) {
        report(diag::ReferenceArgument, range).arg(parameter.name);
        return;
    }
    const Reg mark = emit_.mark();
    const std::optional<Lvalue> found = lvalue(argument);
    if (!found) return;
    if (found->is_temporary) {
        report(diag::ReferenceArgument, range).arg(parameter.name);
    } else if (require_assignable(*found, range)) {
        if (found->type != parameter.type) {
            check_places(found->type, parameter.type, range, parameter.name);
        } else {
            emit_.emit(OpCode::Move, target, reference_to(*found));
            note_assignment(*found);
        }
    }
    emit_.release_to(mark);
}

/// The parameters that a call names, as uses of them.
void Checker::note_arguments(const FunctionDecl& function, const Expr& expr) {
    for (const ExprId id : ast().exprs(expr.list)) {
        const Expr& argument = ast()[id];
        if (argument.kind != ExprKind::Argument || argument.text.is_empty()) continue;
        const auto named =
            std::ranges::find(function.parameters, text(argument.text), &ParameterDecl::name);
        if (named != function.parameters.end()) record_.note_use(module_, id, named->checked);
    }
}

Value Checker::call_function(std::uint32_t index, const Expr& expr) {
    FunctionDecl& wanted = functions_[index];
    if (!wanted.is_wanted) {
        wanted.is_wanted = true;
        wanted_.push_back(index);
    }
    const FunctionDecl function = functions_[index];
    const bool may_call = module_ == 0 && function_ != nullptr &&
                          !options_.calls_programs.empty() &&
                          function_->name == options_.calls_programs;
    if (function.kind == syntax::DeclKind::Program && !may_call) {
        report(diag::ProgramCalled, expr.range).arg(function.name);
        return error_value();
    }
    std::vector<std::string_view> names;
    for (const ParameterDecl& parameter : function.parameters) names.push_back(parameter.name);
    std::uint32_t required = 0;
    for (std::size_t i = 0; i < function.parameters.size(); ++i)
        required |= function.parameters[i].is_required ? 1u << i : 0u;
    const auto bound = bind_arguments(expr, function.name, names, function.range, required);
    if (!bound)
        return function.result == types::kVoid ? in_registers(types::kVoid, 0) : error_value();
    note_arguments(function, expr);

    const unsigned result_slots = type_info(function.result).slots;
    const Reg first = emit_.take(std::max({1u, result_slots, unsigned{function.parameter_slots}}));
    std::uint32_t given = 0;
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const ParameterDecl& parameter = function.parameters[i];
        if ((*bound)[i].is_valid()) {
            pass_argument(parameter, (*bound)[i], first);
            given |= 1u << i;
        } else if (parameter.is_required) {
            report(diag::ArgumentMissing, expr.range)
                .arg(function.name)
                .arg(parameter.name)
                .note(parameter.range, "it is declared here");
        }
    }
    emit_.set_location(expr.range);
    emit_.emit_pair(OpCode::Call, first, index + 1, static_cast<unsigned>(loop_depth_),
                    statement_id(expr.range), static_cast<std::int32_t>(given));
    Value value = in_registers(function.result, first);
    value.is_fresh = true;
    return value;
}

// ---------------------------------------------------------------- vocabulary

/// `mirror(x: true)`: the axis is named, at 0; nothing: it is not named, `false`. A mirror is about
/// the zero point on every control, and takes no other coordinate.
std::optional<Value> Checker::named_axis(const nc::FunctionInfo& info,
                                         const nc::Parameter& parameter, const Value& value,
                                         const SourceRange& range) {
    const bool names = parameter.dimension == nc::Dimension::Length &&
                       nc::has_fact(info.function, nc::Fact::NamesAxes);
    if (!names || is_error(value)) return value;
    if (value.is_constant() && kind(value.type) == TypeKind::Bool) {
        if (value.constant.integer == 0) return std::nullopt;
        return constant_number(0, types::kReal);
    }
    const bool is_zero = value.is_constant() && types_.is_numeric(value.type) &&
                         (kind(value.type) == TypeKind::Int ? value.constant.integer == 0
                                                            : value.constant.number == 0);
    if (is_zero || !nc::has_fact(info.function, nc::Fact::Mirrors)) return value;
    report(diag::MirrorPlace, range)
        .arg(parameter.name)
        .fix(range, "true", "name the axis, and shift the zero point before");
    return error_value();
}

Value Checker::call_vocabulary(const nc::FunctionInfo& info, const Expr& expr) {
    std::vector<std::string_view> names;
    for (const nc::Parameter& parameter : info.parameters) names.push_back(parameter.name);
    const auto bound = bind_arguments(expr, info.name, names, {});
    if (!bound || !require_least(info, *bound, expr)) return in_registers(types::kVoid, 0);
    const Reg mark = emit_.mark();
    Plan plan;
    nc::Invocation invocation;
    invocation.function = info.function;
    invocation.first = 0;
    plan.argument_count = static_cast<std::uint8_t>(names.size());
    const Reg first = emit_.take(std::max<unsigned>(1, static_cast<unsigned>(names.size())));
    for (std::size_t i = 0; i < names.size(); ++i) {
        const nc::Parameter& parameter = info.parameters[i];
        if (!(*bound)[i].is_valid()) {
            if (!parameter.is_optional)
                report(diag::ArgumentMissing, expr.range).arg(info.name).arg(parameter.name);
            continue;
        }
        const SourceRange range = ast()[(*bound)[i]].range;
        const auto reg = static_cast<Reg>(first + plan.fillings.size());
        Filling filling;
        if (parameter.dimension == nc::Dimension::Text) {
            expression_in((*bound)[i], types::kString, reg, parameter.name);
            filling.form = Filling::Form::Text;
        } else {
            const Reg inner = emit_.mark();
            Value value = expression((*bound)[i]);
            const std::optional<Value> named = named_axis(info, parameter, value, range);
            if (!named) {
                emit_.release_to(inner);
                continue;
            }
            value = *named;
            if (parameter.dimension == nc::Dimension::Length &&
                !require_no_diameter(value, range, parameter.name))
                value = error_value();
            filling = fill_value(value, parameter.dimension, range, parameter.name, reg);
            emit_.release_to(inner);
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
        check_units_function(info.function, expr.range);
    }
    emit_.set_location(expr.range);
    emit_plan(std::move(plan), first, 0, expr.range);
    emit_.release_to(mark);
    return in_registers(types::kVoid, 0);
}

// ---------------------------------------------------------------- methods

std::optional<Value> Checker::property_value(const Lvalue& whole, const Expr& expr) {
    const TypeKind k = kind(whole.type);
    const std::string_view name = text(expr.text);
    if (k == TypeKind::Execution) return figure(whole, expr, nullptr);
    if (k != TypeKind::Array && k != TypeKind::String) return std::nullopt;
    if (is_contour(types_.given(whole.type)) && name != "count") {
        const Value contour = require_given(load(whole, expr.range, true, kNoReg), expr.range, {});
        if (is_error(contour)) return contour;
        if (const std::optional<Value> value = contour_property(contour, expr)) return *value;
    }
    if (name != "count" && name != "length") {
        report(diag::UnknownMember, expr.range).arg(type_name(whole.type)).arg(name);
        return error_value();
    }
    const TypeInfo& info = type_info(whole.type);
    if (k == TypeKind::Array && info.count >= 0) return constant_integer(info.count, types::kInt);
    const Value value = require_given(load(whole, expr.range, true, kNoReg), expr.range, {});
    if (is_error(value)) return value;
    const Reg reg = emit_.take(1);
    emit_.emit(k == TypeKind::Array ? OpCode::CountArray : OpCode::CountText, reg, value.reg);
    return in_registers(types::kInt, reg);
}

Value Checker::call_method(ExprId id, const Expr& callee, Reg hint) {
    const Expr& expr = ast()[id];
    (void)hint;
    const std::optional<Lvalue> owner = owner_lvalue(callee.child[0]);
    if (!owner) return error_value();
    if (kind(owner->type) == TypeKind::Array) return array_method(*owner, callee, expr);
    if (kind(owner->type) == TypeKind::Execution) return figure(*owner, callee, &expr);
    if (kind(owner->type) == TypeKind::String) return string_method(*owner, callee, expr);
    report(diag::UnknownMethod, callee.range).arg(type_name(owner->type)).arg(text(callee.text));
    return error_value();
}

Value Checker::array_method(const Lvalue& array, const Expr& callee, const Expr& expr) {
    const std::string_view name = text(callee.text);
    const TypeInfo info = type_info(array.type);
    const Type element = info.element;
    const std::uint16_t slots = type_info(element).slots;
    const bool adds = name == "append" || name == "add";
    const bool inserts = name == "insert";
    const bool removes = name == "remove";
    const bool pops = name == "pop";
    const bool clears = name == "clear";
    if (name == "count") {
        if (!require_argument_count(expr, name, 0, 0)) return error_value();
        const std::optional<Value> count = property_value(array, callee);
        return count ? *count : error_value();
    }
    if (info.is_contour || (!adds && !inserts && !removes && !pops && !clears)) {
        auto builder = report(diag::UnknownMethod, callee.range);
        builder.arg(type_name(array.type)).arg(name);
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
    if (!require_assignable(array, callee.range)) return error_value();
    if (info.count >= 0) {
        report(diag::FixedArrayGrows, callee.range).arg(type_name(array.type)).arg(name);
        return error_value();
    }
    if (!require_argument_count(expr, name,
                                inserts           ? 2
                                : adds || removes ? 1
                                                  : 0,
                                inserts           ? 2
                                : adds || removes ? 1
                                                  : 0)) {
        return error_value();
    }
    const auto arguments = ast().exprs(expr.list);
    const auto value_of = [&](std::size_t i) {
        const Expr& item = ast()[arguments[i]];
        return item.kind == ExprKind::Argument ? item.child[0] : arguments[i];
    };
    const Value handle = load(array, callee.range, false, kNoReg);
    if (adds || inserts) {
        Reg at = 0;
        if (inserts) at = expression_in(value_of(0), types::kInt, kNoReg, "the index");
        const Reg reg = emit_.take(slots);
        expression_in(value_of(inserts ? 1 : 0), element, reg, "the element");
        emit_.set_location(expr.range);
        if (inserts) emit_.emit(OpCode::InsertAt, handle.reg, reg, at);
        else emit_.emit(OpCode::Append, handle.reg, reg);
        return in_registers(types::kVoid, 0);
    }
    if (clears) {
        emit_.emit(OpCode::ClearArray, handle.reg);
        return in_registers(types::kVoid, 0);
    }
    Reg at = 0;
    if (removes) {
        at = expression_in(value_of(0), types::kInt, kNoReg, "the index");
    } else {
        at = emit_.take(1);
        emit_.set_location(expr.range);
        emit_.emit(OpCode::CountArray, at, handle.reg);
        emit_.emit(OpCode::CheckFilled, at);
        emit_.emit_integer(OpCode::AddIK, at, at, -1);
    }
    emit_.set_location(expr.range);
    const Reg result = emit_.take(slots);
    if (slots == 1) emit_.emit(OpCode::LoadElement, result, handle.reg, at);
    else emit_.emit_pair(OpCode::LoadElementN, result, handle.reg, at, 0, slots);
    emit_.emit(OpCode::RemoveAt, handle.reg, at);
    Value value = in_registers(element, result);
    value.is_fresh = true;
    return value;
}

Value Checker::string_method(const Lvalue& string, const Expr& callee, const Expr& expr) {
    const std::string_view name = text(callee.text);
    const bool is_part = name == "part";
    if (name == "count") {
        if (!require_argument_count(expr, name, 0, 0)) return error_value();
        const std::optional<Value> count = property_value(string, callee);
        return count ? *count : error_value();
    }
    if (!is_part && name != "find") {
        auto builder = report(diag::UnknownMethod, callee.range);
        builder.arg(type_name(string.type)).arg(name);
        if (const auto near = nearest_name(name, text_methods().data(), text_methods().size())) {
            builder.fix("did you mean " + quoted(*near) + "?");
        }
        return error_value();
    }
    static constexpr std::string_view kPart[] = {"from", "count"};
    static constexpr std::string_view kFind[] = {"text"};
    const auto bound =
        bind_arguments(expr, name, is_part ? std::span<const std::string_view>(kPart) : kFind, {});
    if (!bound) return error_value();
    if (!(*bound)[0].is_valid()) {
        report(diag::ArgumentMissing, expr.range).arg(name).arg(is_part ? "from" : "text");
        return error_value();
    }
    const Value whole = require_given(load(string, callee.range, true, kNoReg), callee.range, {});
    if (is_error(whole)) return whole;
    const Reg from = in_register(whole);
    const Reg first = emit_.take(is_part ? 2 : 1);
    expression_in((*bound)[0], is_part ? types::kInt : types::kString, first,
                  is_part ? "from" : "text");
    if (is_part) {
        const auto count = static_cast<Reg>(first + 1);
        if ((*bound)[1].is_valid()) expression_in((*bound)[1], types::kInt, count, "count");
        else emit_unset(types_.optional(types::kInt), count);
    }
    const Reg reg = emit_.take(1);
    emit_.set_location(expr.range);
    emit_.emit(is_part ? OpCode::PartOfText : OpCode::FindText, reg, from, first);
    return in_registers(is_part ? types::kString : types::kInt, reg);
}

// ---------------------------------------------------------------- tables

void Checker::add_columns(TableSchema& schema, Type type, const std::string& prefix,
                          std::uint16_t slot) {
    const StructInfo& info = types_.struct_of(type);
    for (const Member& member : info.members) {
        const auto at = static_cast<std::uint16_t>(slot + member.offset);
        const TypeInfo& member_type = type_info(member.type);
        if (member_type.kind == TypeKind::Struct) {
            add_columns(schema, member.type, prefix + member.name + '.', at);
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
        if (member.initial.is_valid()) add_default(column, member);
        schema.columns.push_back(std::move(column));
    }
}

/// What a table without the column has in it. A default that must be worked out in the running
/// program is none: the column is missing then.
void Checker::add_default(TableColumn& column, const Member& member) {
    const std::uint32_t here = std::exchange(module_, member.module);
    const Units before = std::exchange(units_, modules_[member.module].units);
    const Reg mark = emit_.mark();
    const Value value = convert(expression(member.initial, member.type), member.type,
                                ast()[member.initial].range, member.name);
    if (value.is_constant()) {
        column.initial.emplace();
        if (column.kind == TableColumn::Kind::Text)
            column.initial_text = code_->texts[static_cast<std::size_t>(value.constant.integer)];
        else if (kind(member.type) == TypeKind::Real || kind(member.type) == TypeKind::Feed ||
                 kind(member.type) == TypeKind::Speed)
            column.initial->number = value.constant.number;
        else column.initial->integer = value.constant.integer;
    }
    emit_.release_to(mark);
    module_ = here;
    units_ = before;
}

/// Where names of files in the present file are relative to; ends in a slash or is empty.
std::string Checker::folder_of_file() const {
    const std::string_view file = sources_.name(ast().file);
    const std::size_t slash = file.find_last_of("/\\");
    return slash == std::string_view::npos ? "" : std::string(file.substr(0, slash + 1));
}

/// `image<picture>("part.pgm")`: a struct of width, height and brightness.
Value Checker::image_call(const Expr& expr) {
    if (!require_argument_count(expr, "image", 1, 1)) return error_value();
    const Type type = resolve_type(expr.type);
    if (kind(type) == TypeKind::Error) return error_value();
    PictureSource source;
    if (!is_picture(type, source)) {
        report(diag::ImageType, expr.range).arg(type_name(type));
        return error_value();
    }
    const ExprId item = ast().exprs(expr.list)[0];
    const ExprId argument = ast()[item].kind == ExprKind::Argument ? ast()[item].child[0] : item;
    source.folder = folder_of_file();
    source.layout = layout_constant(types::kReal);
    const Value path =
        convert(expression(argument, types::kString), types::kString, ast()[argument].range, {});
    if (is_error(path)) return path;
    const Reg reg = emit_.take(type_info(type).slots);
    const auto index = static_cast<std::int64_t>(code_->pictures.size());
    if (path.is_constant()) {
        const std::string name = code_->texts[static_cast<std::size_t>(path.constant.integer)];
        std::optional<Picture> picture =
            read_picture(source.folder, name, ast()[argument].range, options_.files, sink_);
        if (!picture) return error_value();
        source.picture = std::move(*picture);
        emit_.emit_pair(OpCode::LoadImage, reg, 0, 0, index);
    } else {
        const Reg name = in_register(path);
        emit_.emit_pair(OpCode::ReadImage, reg, name, 0, index);
    }
    code_->pictures.push_back(std::move(source));
    Value value = in_registers(type, reg);
    value.is_fresh = true;
    return value;
}

/// Whether a struct has `int width`, `int height`, `real[] dots` and nothing else; notes where.
bool Checker::is_picture(Type type, PictureSource& source) const {
    if (kind(type) != TypeKind::Struct) return false;
    const StructInfo& info = types_.struct_of(type);
    unsigned found = 0;
    for (const Member& member : info.members) {
        const TypeInfo& member_type = type_info(member.type);
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

Value Checker::table(const Expr& expr) {
    if (text(expr.text) == "image") return image_call(expr);
    if (text(expr.text) != "table") {
        report(diag::UnknownFunction, expr.range).arg(text(expr.text)).fix("did you mean `table`?");
        return error_value();
    }
    const Type row = resolve_type(expr.type);
    if (!require_argument_count(expr, "table", 1, 1)) return error_value();
    const ExprId item = ast().exprs(expr.list)[0];
    const ExprId argument = ast()[item].kind == ExprKind::Argument ? ast()[item].child[0] : item;
    if (kind(row) == TypeKind::Error) return error_value();
    if (kind(row) != TypeKind::Struct || types_.holds_array(row)) {
        report(diag::TableType, expr.range).arg(type_name(row));
        return error_value();
    }
    TableSchema schema;
    schema.type_name = type_name(row);
    add_columns(schema, row, "", 0);
    schema.layout = layout_constant(row);
    schema.slots = type_info(row).slots;
    schema.units = units_;
    schema.folder = folder_of_file();
    // Enums must be known where the table is read, which may be before the check is over.
    std::vector<EnumNames> enums;
    for (std::size_t i = 0; i < types_.enum_count(); ++i) {
        enums.push_back({types_.enum_at(i).name, types_.enum_at(i).members});
    }
    const Value path =
        convert(expression(argument, types::kString), types::kString, ast()[argument].range, {});
    if (is_error(path)) return path;
    const auto index = static_cast<std::uint32_t>(code_->schemas.size());
    code_->schemas.push_back(schema);
    const Reg reg = emit_.take(1);
    if (path.is_constant()) {
        const std::string name = code_->texts[static_cast<std::size_t>(path.constant.integer)];
        std::optional<TableRows> rows =
            read_table(schema, enums, name, ast()[argument].range, options_.files, sink_);
        if (!rows) return error_value();
        emit_.emit_pair(OpCode::LoadTable, reg, 0, 0,
                        static_cast<std::int64_t>(code_->tables.size()));
        code_->tables.push_back({index, std::move(*rows)});
    } else {
        const Reg name = in_register(path);
        emit_.emit_pair(OpCode::ReadTable, reg, name, 0, index);
    }
    Value value = in_registers(types_.array(row, -1), reg);
    value.is_fresh = true;
    return value;
}

}  // namespace kadr::sema
