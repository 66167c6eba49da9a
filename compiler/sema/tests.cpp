// tests.cpp — `test` and `property`: calls that are executed, figures, expectations.
//
// The checker knows the words; who executes a call and measures it is the test bench that the
// driver brings (expand/test_bench.h).
#include "sema/tests.h"

#include <algorithm>
#include <array>

#include "base/diagnostics/sema.h"
#include "base/diagnostics/test.h"
#include "base/text.h"
#include "sema/builtin_calls.h"
#include "sema/calls.h"
#include "sema/checking.h"
#include "sema/conditions.h"
#include "sema/convert.h"
#include "sema/declarations.h"
#include "sema/expressions.h"
#include "sema/lvalues.h"
#include "sema/optionals.h"
#include "sema/scope.h"
#include "sema/statements.h"
#include "sema/texts.h"
#include "sema/values.h"

namespace kadr::sema {

using syntax::Decl;
using syntax::DeclKind;
using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Operator;
using syntax::Stmt;

namespace {

Value test_call(Check& check, TestCall::Purpose purpose, std::string_view name,
                const syntax::Expr& expr);
void expectation(Check& check, syntax::ExprId id);
void expect_comparison(Check& check, const syntax::Expr& expr);
Reg shown(Check& check, const Value& value);

}  // namespace

namespace {

constexpr FigureInfo kFigures[] = {
#define KADR_FIGURE(name, word, result, parameters, meaning) \
    {Figure::name, word, FigureResult::result, parameters, meaning},
#include "sema/figures.def"
#undef KADR_FIGURE
};

/// Whether the language has a unit for such values.
bool can_be_written(Quantity quantity) {
    return quantity.is_number() || find_unit(unit_text(quantity, Units::Metric));
}

/// Code in messages is one line, and not a long one.
std::string one_line(std::string_view code) {
    constexpr std::size_t kMost = 100;
    std::string line;
    for (const char c : code) {
        const bool is_blank = c == ' ' || c == '\n' || c == '\r' || c == '\t';
        if (!is_blank) line += c;
        else if (!line.empty() && line.back() != ' ') line += ' ';
    }
    if (line.size() <= kMost) return line;
    std::size_t cut = kMost;
    while (cut > 0 && (static_cast<unsigned char>(line[cut]) & 0xC0u) == 0x80u) --cut;
    return line.substr(0, cut) + "…";
}

/// What is expected of the left side, in words, the right one standing for `{}`.
std::string_view expected_words(Operator op) {
    switch (op) {
        case Operator::Less: return "less than {}";
        case Operator::LessEqual: return "at most {}";
        case Operator::Greater: return "more than {}";
        case Operator::GreaterEqual: return "at least {}";
        case Operator::NotEqual: return "anything but {}";
        default: return "{}";
    }
}

Operator mirrored(Operator op) {
    switch (op) {
        case Operator::Less: return Operator::Greater;
        case Operator::LessEqual: return Operator::GreaterEqual;
        case Operator::Greater: return Operator::Less;
        case Operator::GreaterEqual: return Operator::LessEqual;
        default: return op;
    }
}

/// One parameter of a figure that is a function.
struct FigureParameter {
    std::string_view name;
    bool is_point = false;
    bool is_count = false;
    bool is_optional = false;
    std::uint16_t slots() const { return is_point ? 3 : 1; }
};

std::vector<FigureParameter> figure_parameters(const FigureInfo& info) {
    std::vector<FigureParameter> parameters;
    std::string_view rest = info.parameters;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        FigureParameter parameter;
        parameter.name = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        parameter.is_optional = parameter.name.starts_with('[');
        parameter.is_point = parameter.name.ends_with('.');
        if (parameter.is_optional)
            parameter.name = parameter.name.substr(1, parameter.name.size() - 2);
        if (parameter.is_point) parameter.name.remove_suffix(1);
        parameter.is_count = parameter.name == "index";
        parameters.push_back(parameter);
    }
    return parameters;
}

bool is_comparison(Operator op) { return op >= Operator::Less && op <= Operator::NotEqual; }

}  // namespace

std::span<const FigureInfo> all_figures() { return kFigures; }

// ---------------------------------------------------------------- declarations

void declare_test(Check& check, std::uint32_t module, syntax::DeclId id) {
    if (module != 0) return;  // tests are run with their own file
    const Decl& decl = check.ast()[id];
    FunctionDecl function;
    function.module = module;
    function.decl = id;
    function.name = check.text(decl.name);
    function.kind = decl.kind;
    function.range = decl.name_range.file.is_valid() ? decl.name_range : decl.range;
    const auto same = std::ranges::find_if(check.names.functions(), [&](const FunctionDecl& other) {
        const bool is_test = other.kind == DeclKind::Test || other.kind == DeclKind::Property;
        return is_test && other.module == module && other.name == function.name;
    });
    if (same != check.names.functions().end()) {
        check.report(diag::DuplicateName, function.range)
            .arg(function.name)
            .note(same->range, "it is declared here");
    }
    function.checked = check.record.declare(described(
        check, module, id,
        decl.kind == DeclKind::Test ? DeclaredSymbol::Kind::Test : DeclaredSymbol::Kind::Property));
    check.names.add_function(std::move(function));
}

bool is_in_test(const Check& check) {
    return check.here.function != nullptr && (check.here.function->kind == DeclKind::Test ||
                                              check.here.function->kind == DeclKind::Property);
}

void report_test_block(Check& check, const SourceRange& range) {
    check.report(diag::TestBlocks, range)
        .arg(check.here.function->kind == DeclKind::Test ? "test" : "property")
        .fix("put it into a cycle and execute that");
}

namespace {

Done read_range_end(Check& check, ExprId id, const ParameterDecl& parameter, Slot& end) {
    const SourceRange range = check.ast()[id].range;
    const Value value = convert(check, expression(check, id, parameter.type), parameter.type, range,
                                parameter.name);
    if (check.is_error(value)) return kFailed;
    if (!value.is_constant()) {
        check.report(diag::NotConstant, range).arg("the end of a range");
        return kFailed;
    }
    end = value.constant;
    return kDone;
}

}  // namespace

void property_ranges(Check& check, std::uint32_t index) {
    const FunctionDecl function = check.names.function(index);
    const auto ids = check.ast().decls(check.ast()[function.decl].parameters);
    std::vector<PropertyRange> ranges(function.parameters.size());
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const ParameterDecl& parameter = function.parameters[i];
        const TypeInfo info = check.type_info(parameter.type);
        const ExprId given = check.ast()[ids[i]].value;
        const bool is_plain = !info.is_optional && !parameter.is_reference;
        const bool is_listed = info.kind == TypeKind::Bool || info.kind == TypeKind::Enum;
        const bool is_family = info.kind == TypeKind::Feed || info.kind == TypeKind::Speed;
        const bool is_number =
            info.kind == TypeKind::Int || info.kind == TypeKind::Real || is_family;
        if (info.kind == TypeKind::Error || (is_plain && is_listed && !given.is_valid())) continue;
        const bool has_range = given.is_valid() && check.ast()[given].kind == ExprKind::Range;
        Quantity quantity = info.kind == TypeKind::Feed    ? kFeedPerTime
                            : info.kind == TypeKind::Speed ? kSpindleSpeed
                                                           : info.quantity;
        if (!is_plain || !is_number || !has_range || !can_be_written(quantity)) {
            check.report(diag::PropertyValues, parameter.range).arg(parameter.name);
            continue;
        }
        PropertyRange& range = ranges[i];
        const ExprId first = check.ast()[given].child[0];
        const ExprId last = check.ast()[given].child[1];
        const Reg mark = check.emit.mark();
        const bool is_read = read_range_end(check, first, parameter, range.from) &&
                             read_range_end(check, last, parameter, range.to);
        check.emit.release_to(mark);
        if (!is_read) continue;
        const bool is_second = is_family && is_second_form(range.from.number);
        if (is_family && is_second != is_second_form(range.to.number)) {
            check.report(diag::PropertyValues, parameter.range).arg(parameter.name);
            continue;
        }
        const bool is_empty = info.kind == TypeKind::Int ? range.from.integer > range.to.integer
                                                         : range.from.number > range.to.number;
        if (is_empty) {
            check.report(diag::PropertyRange, check.ast()[given].range)
                .arg(parameter.name)
                .arg(check.sources.text(check.ast()[first].range))
                .arg(check.sources.text(check.ast()[last].range));
        }
        if (is_second) quantity = info.kind == TypeKind::Feed ? kFeedPerTurn : kFeedPerTime;
        range.unit = unit_text(quantity, check.here.units);
        range.factor = bare_factor(quantity, check.here.units) * (is_second ? kSecondForm : 1.0);
    }
    check.code->functions[index + 1].ranges = std::move(ranges);
}

// ---------------------------------------------------------------- calls that are executed

std::optional<Value> test_builtin(Check& check, std::string_view name, const Expr& expr) {
    using Purpose = TestCall::Purpose;
    const bool is_text = name == "text" && expr.list.count >= 2;
    const bool is_call =
        name == "execute" || name == "attempt" || name == "expect_error" || is_text;
    const bool is_dialect = name == "dialect" || name == "dialects";
    if (!is_call && !is_dialect) return std::nullopt;
    if (!is_in_test(check)) {
        check.report(diag::TestOnly, expr.range).arg(name).arg("a `test` or `property`");
        return error_value();
    }
    if (is_call) {
        return test_call(check,
                         is_text             ? Purpose::Text
                         : name == "execute" ? Purpose::Execute
                         : name == "attempt" ? Purpose::Attempt
                                             : Purpose::ExpectError,
                         name, expr);
    }
    if (!require_argument_count(check, expr, name, 0, 0)) return error_value();
    const bool is_list = name == "dialects";
    const Type type = is_list ? check.types.array(types::kString, -1) : types::kString;
    const Reg reg = check.emit.take(1);
    check.emit.emit(OpCode::TestDialects, reg, is_list ? layout_constant(check, types::kString) : 0,
                    is_list ? 1 : 0);
    Value value = in_registers(type, reg);
    value.is_fresh = true;
    return value;
}

namespace {

std::optional<std::uint32_t> test_subject(Check& check, std::string_view name, ExprId id) {
    const Expr& call = check.ast()[id];
    const std::size_t errors = check.sink.errors;
    if (call.kind == ExprKind::Call && check.ast()[call.child[0]].kind == ExprKind::Name) {
        const Found found = look_up(check, call.child[0]);
        const bool is_known = found.symbol >= 0 || found.name != nullptr;
        if (is_known && found.symbol < 0 && found.name->what == Name::What::Function) {
            const std::uint32_t index = found.name->index;
            FunctionDecl& function = check.names.function(index);
            const bool refers =
                std::any_of(function.parameters.begin(), function.parameters.end(),
                            [](const ParameterDecl& parameter) { return parameter.is_reference; });
            if (check.kind(function.result) == TypeKind::Void && !refers) {
                check.names.want(index);
                return index;
            }
        } else if (!is_known) {
            expression(check, id);  // reports that there is no such function
        }
    } else if (call.kind == ExprKind::Invalid) {
        return std::nullopt;
    }
    if (errors == check.sink.errors) check.report(diag::TestSubject, call.range).arg(name);
    return std::nullopt;
}

Value test_call(Check& check, TestCall::Purpose purpose, std::string_view name, const Expr& expr) {
    using Purpose = TestCall::Purpose;
    const bool has_text = purpose == Purpose::Text || purpose == Purpose::ExpectError;
    std::vector<std::string_view> names = {"call", "at", "feed", "speed"};
    const std::string_view text_name = purpose == Purpose::ExpectError ? "code" : "dialect";
    if (has_text) names.insert(names.begin(), text_name);
    else names.push_back(text_name);
    const auto bound = bind_arguments(check, expr, name, names, {});
    if (!bound) return error_value();
    const auto argument = [&](std::string_view wanted) {
        const auto found = std::find(names.begin(), names.end(), wanted);
        return (*bound)[static_cast<std::size_t>(found - names.begin())];
    };
    for (const std::string_view needed : {std::string_view("call"), text_name}) {
        if (argument(needed).is_valid() || (needed != "call" && !has_text)) continue;
        check.report(diag::ArgumentMissing, expr.range).arg(name).arg(needed);
        return error_value();
    }
    const std::optional<std::uint32_t> index = test_subject(check, name, argument("call"));
    if (!index) return error_value();
    const FunctionDecl function = check.names.function(*index);
    const Expr& call = check.ast()[argument("call")];
    std::vector<std::string_view> parameter_names;
    for (const ParameterDecl& parameter : function.parameters)
        parameter_names.push_back(parameter.name);
    const auto arguments =
        bind_arguments(check, call, function.name, parameter_names, function.range);
    if (!arguments) return error_value();

    const Reg base =
        check.emit.take(kTestOptions + std::max<unsigned>(1, function.parameter_slots));
    const auto option = [&](std::string_view wanted, Type type, unsigned position) {
        const auto reg = static_cast<Reg>(base + position);
        if (argument(wanted).is_valid()) expression_in(check, argument(wanted), type, reg, wanted);
        else if (type == types::kString)
            check.emit.emit_integer(OpCode::LoadI, reg, 0, kNotGivenInteger);
        else {
            for (unsigned i = 0; i < check.type_info(type).slots; ++i)
                check.emit.emit_number(OpCode::LoadF, reg + i, 0, kNotGivenNumber);
        }
    };
    option("at", types::kPoint, 0);
    option("feed", types::kFeed, 3);
    option("speed", types::kSpeed, 4);
    option(text_name, types::kString, 5);

    TestCall entry;
    entry.purpose = purpose;
    entry.function = *index + 1;
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const ParameterDecl& parameter = function.parameters[i];
        entry.layouts.push_back(layout_constant(check, parameter.type));
        if ((*arguments)[i].is_valid()) {
            pass_argument(check, parameter, (*arguments)[i], static_cast<Reg>(base + kTestOptions));
            entry.given |= 1u << i;
        } else if (parameter.is_required) {
            check.report(diag::ArgumentMissing, call.range)
                .arg(function.name)
                .arg(parameter.name)
                .note(parameter.range, "it is declared here");
        }
    }
    check.emit.set_location(call.range);
    check.emit.emit_pair(OpCode::TestCall, base, 0, 0, statement_id(check, call.range),
                         static_cast<std::int64_t>(check.code->test_calls.size()));
    check.emit.emit(OpCode::Finish);
    check.code->test_calls.push_back(std::move(entry));
    const Type result = purpose == Purpose::Text          ? types::kString
                        : purpose == Purpose::ExpectError ? types::kVoid
                                                          : types::kExecution;
    return in_registers(result, base);
}

}  // namespace

// ---------------------------------------------------------------- figures

namespace {

Done take_figure_arguments(Check& check, const FigureInfo& info, const Expr& call, Reg first) {
    const std::vector<FigureParameter> parameters = figure_parameters(info);
    std::vector<std::string_view> names;
    names.reserve(parameters.size());
    for (const FigureParameter& parameter : parameters) names.push_back(parameter.name);
    const auto bound = bind_arguments(check, call, info.name, names, {});
    if (!bound) return kFailed;
    Reg reg = first;
    Done taken = kDone;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const FigureParameter& parameter = parameters[i];
        const Type type = parameter.is_point   ? types::kPoint
                          : parameter.is_count ? types::kInt
                                               : types::kLengthType;
        if ((*bound)[i].is_valid()) {
            expression_in(check, (*bound)[i], type, reg, parameter.name);
        } else if (parameter.is_optional) {
            check.emit.emit_number(OpCode::LoadF, reg, 0, kNotGivenNumber);
        } else {
            check.report(diag::ArgumentMissing, call.range).arg(info.name).arg(parameter.name);
            taken = kFailed;
        }
        reg = static_cast<Reg>(reg + parameter.slots());
    }
    return taken;
}

}  // namespace

Value figure(Check& check, const Lvalue& execution, const Expr& member, const Expr* call) {
    const std::string_view name = check.text(member.text);
    if (name.empty()) return error_value();
    const auto* info = std::find_if(std::begin(kFigures), std::end(kFigures),
                                    [&](const FigureInfo& row) { return row.name == name; });
    const bool is_function = info != std::end(kFigures) && !info->parameters.empty();
    if (info == std::end(kFigures) || is_function != (call != nullptr)) {
        auto builder =
            check.report(is_function || call == nullptr ? diag::UnknownMember : diag::UnknownMethod,
                         member.range);
        builder.arg("execution").arg(name);
        if (info != std::end(kFigures)) {
            builder.fix(is_function ? "it is a function: " + quoted(std::string(name) + "(…)")
                                    : "it is not a function: " + quoted(name));
            return error_value();
        }
        std::vector<std::string_view> names;
        for (const FigureInfo& row : kFigures) names.push_back(row.name);
        if (const auto near = nearest_name(name, names.data(), names.size())) {
            builder.fix("did you mean " + quoted(*near) + "?");
        }
        return error_value();
    }
    const Value handle = load(check, execution, member.range, true, kNoReg);
    if (check.is_error(handle)) return handle;
    unsigned slots = info->result == FigureResult::Point ? 3 : 1;
    unsigned argument_slots = 0;
    for (const FigureParameter& parameter : figure_parameters(*info))
        argument_slots += parameter.slots();
    const Reg first = check.emit.take(std::max(slots, argument_slots));
    if (call != nullptr) {
        ++check.asked_figures;
        if (!take_figure_arguments(check, *info, *call, first)) return error_value();
    }
    check.emit.set_location(call != nullptr ? call->range : member.range);
    Type type = types::kInt;
    std::int64_t layout = 0;
    switch (info->result) {
        case FigureResult::Count: break;
        case FigureResult::Length: type = check.types.optional(types::kLengthType); break;
        case FigureResult::Time: type = types::kTimeType; break;
        case FigureResult::Truth: type = types::kBool; break;
        case FigureResult::Text: type = types::kString; break;
        case FigureResult::Point: type = types::kPoint; break;
        case FigureResult::Counts:
            type = check.types.array(types::kInt, -1);
            layout = layout_constant(check, types::kInt);
            break;
        case FigureResult::Lengths:
            type = check.types.array(types::kLengthType, -1);
            layout = layout_constant(check, types::kLengthType);
            break;
    }
    check.emit.emit_pair(OpCode::Figure, first, handle.reg, static_cast<unsigned>(info->figure),
                         layout);
    check.emit.release_to(static_cast<Reg>(first + slots));
    Value value = in_registers(type, first);
    value.is_fresh = true;
    return value;
}

// ---------------------------------------------------------------- expectations

void assume_statement(Check& check, const Stmt& stmt) {
    if (check.here.function == nullptr || check.here.function->kind != DeclKind::Property) {
        check.report(diag::TestOnly, stmt.range).arg("assume").arg("a `property`");
        return;
    }
    Label good;
    jump_if(check, stmt.expression[0], true, good);
    check.emit.emit(OpCode::AssumeFailed);
    check.emit.bind(good);
    assume_given(check, stmt.expression[0], true);
}

void expect_statement(Check& check, const Stmt& stmt) {
    if (!is_in_test(check)) {
        check.report(diag::TestOnly, stmt.range).arg("expect").arg("a `test` or `property`");
        return;
    }
    expectation(check, stmt.expression[0]);
}

namespace {

void expectation(Check& check, ExprId id) {
    const Expr& expr = check.ast()[id];
    const bool is_binary = expr.kind == ExprKind::Binary;
    if (is_binary && expr.op == Operator::And) {
        // Each part reports for itself what is wrong.
        expectation(check, expr.child[0]);
        expectation(check, expr.child[1]);
        return;
    }
    const Reg mark = check.emit.mark();
    check.emit.set_location(expr.range);
    const std::uint32_t asked = check.asked_figures;
    const auto reason = [&] { return check.asked_figures > asked ? kHasReason : std::uint16_t{0}; };
    const auto untrue = [&](Expectation why, Reg value) {
        check.emit.set_location(expr.range);
        check.emit.emit_pair(
            OpCode::ExpectFailed, value, 0, static_cast<unsigned>(why) | reason(),
            text_constant(check, quoted(one_line(check.sources.text(expr.range)))));
    };
    if (is_binary && is_comparison(expr.op)) {
        expect_comparison(check, expr);
    } else if (is_binary && expr.op == Operator::Contains &&
               check.kind(type_of(check, expr.child[0])) == TypeKind::String) {
        const SourceRange range = check.ast()[expr.child[1]].range;
        const Value whole = require_given(check, expression(check, expr.child[0]),
                                          check.ast()[expr.child[0]].range, {});
        const Value part = convert(check, expression(check, expr.child[1], types::kString),
                                   types::kString, range, {});
        if (!check.is_error(whole) && !check.is_error(part)) {
            Label good;
            const Reg text = in_register(check, whole);
            const Reg wanted = in_register(check, part);
            const Reg answer = check.emit.take(1);
            check.emit.emit(OpCode::ContainsText, answer, text, wanted);
            check.emit.jump(OpCode::JumpIf, good, answer);
            untrue(Expectation::UntrueOfText, text);
            check.emit.bind(good);
        }
    } else {
        Label good;
        jump_if(check, id, true, good);
        untrue(Expectation::Untrue, 0);
        check.emit.bind(good);
    }
    check.emit.release_to(mark);
}

bool is_measured(const Check& check, Type type) {
    const TypeInfo& info = check.type_info(type);
    return info.kind == TypeKind::Real &&
           (info.quantity == kLength || info.quantity == kAngle || info.quantity == kTime);
}

void jump_if_near(Check& check, Reg a, Reg b, Label& near) {
    const Reg way = check.emit.take(1);
    const Reg most = check.emit.take(1);
    check.emit.emit(OpCode::SubF, way, a, b);
    check.emit.emit(OpCode::Math1, way, way, static_cast<unsigned>(Math::Abs));
    check.emit.emit_number(OpCode::LoadF, most, 0, kExpectTolerance);
    check.emit.jump(OpCode::JumpLeF, near, way, most);
}

/// Jumps to `good` if both sides are as the operator wants, within the tolerance of tests.
Done emit_agreement(Check& check, const Expr& expr, const Value& left, const Value& right,
                    Label& good) {
    const Operator op = expr.op;
    const bool is_equality = op == Operator::Equal || op == Operator::NotEqual;
    if (is_equality && left.type == types::kPoint && right.type == types::kPoint) {
        Label differs;
        for (unsigned i = 0; i < 3; ++i) {
            Label next;
            const auto a = static_cast<Reg>(left.reg + i);
            const auto b = static_cast<Reg>(right.reg + i);
            const Reg same = check.emit.take(1);
            check.emit.emit(OpCode::EqualPart, same, a, b).immediate.pair = {
                static_cast<std::int32_t>(SlotKind::Number), 0};
            check.emit.jump(OpCode::JumpIf, next, same);
            // A part that only one of them has never agrees.
            Label apart;
            for (const Reg part : {a, b}) {
                check.emit.jump(OpCode::JumpNotGiven, apart, part, 0,
                                static_cast<unsigned>(SlotKind::Number));
            }
            jump_if_near(check, a, b, next);
            check.emit.bind(apart);
            check.emit.jump(OpCode::Jump, op == Operator::Equal ? differs : good);
            check.emit.bind(next);
        }
        if (op == Operator::Equal) check.emit.jump(OpCode::Jump, good);
        check.emit.bind(differs);
        return kDone;
    }
    const std::optional<ComparedSides> found = compare(check, expr, left, right);
    if (!found) return kFailed;
    const bool is_exact = op == Operator::Less || op == Operator::Greater;
    if (!found->is_real || !is_measured(check, found->left.type) || is_exact) {
        jump_compare(check, *found, true, good, -1);
        return kDone;
    }
    const Reg a = in_register(check, found->left);
    const Reg b = in_register(check, found->right);
    if (op == Operator::Equal) {
        jump_if_near(check, a, b, good);
    } else if (op == Operator::NotEqual) {
        Label near;
        jump_if_near(check, a, b, near);
        check.emit.jump(OpCode::Jump, good);
        check.emit.bind(near);
    } else {
        const Reg beyond = check.emit.take(1);
        const Reg most = check.emit.take(1);
        const bool is_upper = op == Operator::LessEqual;
        check.emit.emit(OpCode::SubF, beyond, is_upper ? a : b, is_upper ? b : a);
        check.emit.emit_number(OpCode::LoadF, most, 0, kExpectTolerance);
        check.emit.jump(OpCode::JumpLeF, good, beyond, most);
    }
    return kDone;
}

void expect_comparison(Check& check, const Expr& expr) {
    const std::uint32_t asked = check.asked_figures;
    std::optional<Sides> sides = compared_sides(check, expr);
    if (!sides) return;
    if (check.types.is_numeric(sides->left.type) && check.types.is_numeric(sides->right.type) &&
        check.kind(sides->left.type) != TypeKind::Int) {
        // A bare number shows the unit that it gets.
        if (is_plain_number(check, sides->right) && sides->right.is_constant())
            sides->right = adapt_number(check, sides->right, sides->left.type);
    }
    sides->left = in_registers(sides->left.type, in_register(check, sides->left));
    const bool is_literal = sides->right.is_constant();
    sides->right = in_registers(sides->right.type, in_register(check, sides->right));
    Label good;
    if (!emit_agreement(check, expr, sides->left, sides->right, good)) return;
    // `12mm == run.x`: what is looked at is what is not written down.
    const auto is_number = [&](ExprId id) {
        return check.ast()[id].kind == ExprKind::Int || check.ast()[id].kind == ExprKind::Real;
    };
    const bool is_swapped = is_number(expr.child[0]) && !is_number(expr.child[1]);
    if (is_swapped) std::swap(sides->left, sides->right);
    const ExprId seen = expr.child[is_swapped ? 1 : 0];
    const ExprId wanted = expr.child[is_swapped ? 0 : 1];
    const Reg is = shown(check, sides->left);
    const Reg should = shown(check, sides->right);
    std::string words(expected_words(is_swapped ? mirrored(expr.op) : expr.op));
    const bool is_written_out = is_literal || check.ast()[wanted].kind == ExprKind::Braces;
    if (!is_written_out && !is_swapped)
        words += " (" + quoted(one_line(check.sources.text(check.ast()[wanted].range))) + ")";
    check.emit.set_location(expr.range);
    const std::uint16_t reason = check.asked_figures > asked ? kHasReason : 0;
    check.emit.emit_pair(
        OpCode::ExpectFailed, is, should, static_cast<unsigned>(Expectation::Compared) | reason,
        text_constant(check, quoted(one_line(check.sources.text(check.ast()[seen].range)))),
        text_constant(check, words));
    check.emit.bind(good);
}

/// A value as it would be written in the program, with its unit.
void append_shown(Check& check, const Value& value, FormatPattern& pattern) {
    const auto literal = [&](std::string_view words) {
        FormatPiece piece;
        piece.text = words;
        pattern.push_back(std::move(piece));
    };
    const TypeInfo info = check.type_info(check.types.given(value.type));
    if (info.kind == TypeKind::Struct) {
        literal("{");
        bool is_first = true;
        for (const Member& member :
             std::vector<Member>(check.types.struct_of(value.type).members)) {
            if (!is_first) literal(", ");
            is_first = false;
            append_shown(check, in_registers(member.type, 0), pattern);
        }
        literal("}");
        return;
    }
    FormatPiece piece;
    if (info.kind == TypeKind::String) literal("\"");
    if (!read_format(check, value, {}, check.emit.location(), piece)) return;
    add_unit(check, value.type, "", piece);
    pattern.push_back(std::move(piece));
    if (info.kind == TypeKind::String) literal("\"");
}

Reg shown(Check& check, const Value& value) {
    FormatPattern pattern;
    append_shown(check, value, pattern);
    const Reg reg = check.emit.take(1);
    check.emit.emit_pair(OpCode::Format, reg, in_register(check, value), 0,
                         static_cast<std::int64_t>(check.code->formats.size()));
    check.code->formats.push_back(std::move(pattern));
    return reg;
}

}  // namespace

}  // namespace kadr::sema
