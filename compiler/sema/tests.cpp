// tests.cpp — `test` and `property`: calls that are executed, figures, expectations.
//
// The checker knows the words; who executes a call and measures it is the test bench that the
// driver brings (expand/test_bench.h).
#include <algorithm>
#include <array>

#include "base/diagnostics/sema.h"
#include "base/diagnostics/test.h"
#include "base/text.h"
#include "sema/checker.h"

namespace kadr::sema {

using syntax::Decl;
using syntax::DeclKind;
using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Operator;
using syntax::Stmt;

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

void Checker::declare_test(std::uint32_t module, syntax::DeclId id) {
    if (module != 0) return;  // tests are run with their own file
    const Decl& decl = ast()[id];
    FunctionDecl function;
    function.module = module;
    function.decl = id;
    function.name = text(decl.name);
    function.kind = decl.kind;
    function.range = decl.name_range.file.is_valid() ? decl.name_range : decl.range;
    const auto same =
        std::find_if(functions_.begin(), functions_.end(), [&](const FunctionDecl& other) {
            const bool is_test = other.kind == DeclKind::Test || other.kind == DeclKind::Property;
            return is_test && other.module == module && other.name == function.name;
        });
    if (same != functions_.end()) {
        report(diag::DuplicateName, function.range)
            .arg(function.name)
            .note(same->range, "it is declared here");
    }
    function.checked = record_.declare(described(
        module, id,
        decl.kind == DeclKind::Test ? DeclaredSymbol::Kind::Test : DeclaredSymbol::Kind::Property));
    functions_.push_back(std::move(function));
}

bool Checker::is_in_test() const {
    return function_ != nullptr &&
           (function_->kind == DeclKind::Test || function_->kind == DeclKind::Property);
}

void Checker::report_test_block(const SourceRange& range) {
    report(diag::TestBlocks, range)
        .arg(function_->kind == DeclKind::Test ? "test" : "property")
        .fix("put it into a cycle and execute that");
}

Done Checker::read_range_end(ExprId id, const ParameterDecl& parameter, Slot& end) {
    const SourceRange range = ast()[id].range;
    const Value value =
        convert(expression(id, parameter.type), parameter.type, range, parameter.name);
    if (is_error(value)) return kFailed;
    if (!value.is_constant()) {
        report(diag::NotConstant, range).arg("the end of a range");
        return kFailed;
    }
    end = value.constant;
    return kDone;
}

void Checker::property_ranges(std::uint32_t index) {
    const FunctionDecl function = functions_[index];
    const auto ids = ast().decls(ast()[function.decl].parameters);
    std::vector<PropertyRange> ranges(function.parameters.size());
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const ParameterDecl& parameter = function.parameters[i];
        const TypeInfo info = type_info(parameter.type);
        const ExprId given = ast()[ids[i]].value;
        const bool is_plain = !info.is_optional && !parameter.is_reference;
        const bool is_listed = info.kind == TypeKind::Bool || info.kind == TypeKind::Enum;
        const bool is_family = info.kind == TypeKind::Feed || info.kind == TypeKind::Speed;
        const bool is_number =
            info.kind == TypeKind::Int || info.kind == TypeKind::Real || is_family;
        if (info.kind == TypeKind::Error || (is_plain && is_listed && !given.is_valid())) continue;
        const bool has_range = given.is_valid() && ast()[given].kind == ExprKind::Range;
        Quantity quantity = info.kind == TypeKind::Feed    ? kFeedPerTime
                            : info.kind == TypeKind::Speed ? kSpindleSpeed
                                                           : info.quantity;
        if (!is_plain || !is_number || !has_range || !can_be_written(quantity)) {
            report(diag::PropertyValues, parameter.range).arg(parameter.name);
            continue;
        }
        PropertyRange& range = ranges[i];
        const ExprId first = ast()[given].child[0];
        const ExprId last = ast()[given].child[1];
        const Reg mark = emit_.mark();
        const bool is_read = read_range_end(first, parameter, range.from) &&
                             read_range_end(last, parameter, range.to);
        emit_.release_to(mark);
        if (!is_read) continue;
        const bool is_second = is_family && is_second_form(range.from.number);
        if (is_family && is_second != is_second_form(range.to.number)) {
            report(diag::PropertyValues, parameter.range).arg(parameter.name);
            continue;
        }
        const bool is_empty = info.kind == TypeKind::Int ? range.from.integer > range.to.integer
                                                         : range.from.number > range.to.number;
        if (is_empty) {
            report(diag::PropertyRange, ast()[given].range)
                .arg(parameter.name)
                .arg(sources_.text(ast()[first].range))
                .arg(sources_.text(ast()[last].range));
        }
        if (is_second) quantity = info.kind == TypeKind::Feed ? kFeedPerTurn : kFeedPerTime;
        range.unit = unit_text(quantity, units_);
        range.factor = bare_factor(quantity, units_) * (is_second ? kSecondForm : 1.0);
    }
    code_->functions[index + 1].ranges = std::move(ranges);
}

// ---------------------------------------------------------------- calls that are executed

std::optional<Value> Checker::test_builtin(std::string_view name, const Expr& expr) {
    using Purpose = TestCall::Purpose;
    const bool is_text = name == "text" && expr.list.count >= 2;
    const bool is_call =
        name == "execute" || name == "attempt" || name == "expect_error" || is_text;
    const bool is_dialect = name == "dialect" || name == "dialects";
    if (!is_call && !is_dialect) return std::nullopt;
    if (!is_in_test()) {
        report(diag::TestOnly, expr.range).arg(name).arg("a `test` or `property`");
        return error_value();
    }
    if (is_call) {
        return test_call(is_text             ? Purpose::Text
                         : name == "execute" ? Purpose::Execute
                         : name == "attempt" ? Purpose::Attempt
                                             : Purpose::ExpectError,
                         name, expr);
    }
    if (!require_argument_count(expr, name, 0, 0)) return error_value();
    const bool is_list = name == "dialects";
    const Type type = is_list ? types_.array(types::kString, -1) : types::kString;
    const Reg reg = emit_.take(1);
    emit_.emit(OpCode::TestDialects, reg, is_list ? layout_constant(types::kString) : 0,
               is_list ? 1 : 0);
    Value value = in_registers(type, reg);
    value.is_fresh = true;
    return value;
}

std::optional<std::uint32_t> Checker::test_subject(std::string_view name, ExprId id) {
    const Expr& call = ast()[id];
    const std::size_t errors = sink_.errors;
    if (call.kind == ExprKind::Call && ast()[call.child[0]].kind == ExprKind::Name) {
        const Found found = look_up(call.child[0]);
        const bool is_known = found.symbol >= 0 || found.name != nullptr;
        if (is_known && found.symbol < 0 && found.name->what == Name::What::Function) {
            const std::uint32_t index = found.name->index;
            FunctionDecl& function = functions_[index];
            const bool refers =
                std::any_of(function.parameters.begin(), function.parameters.end(),
                            [](const ParameterDecl& parameter) { return parameter.is_reference; });
            if (kind(function.result) == TypeKind::Void && !refers) {
                if (!function.is_wanted) wanted_.push_back(index);
                function.is_wanted = true;
                return index;
            }
        } else if (!is_known) {
            expression(id);  // reports that there is no such function
        }
    } else if (call.kind == ExprKind::Invalid) {
        return std::nullopt;
    }
    if (errors == sink_.errors) report(diag::TestSubject, call.range).arg(name);
    return std::nullopt;
}

Value Checker::test_call(TestCall::Purpose purpose, std::string_view name, const Expr& expr) {
    using Purpose = TestCall::Purpose;
    const bool has_text = purpose == Purpose::Text || purpose == Purpose::ExpectError;
    std::vector<std::string_view> names = {"call", "at", "feed", "speed"};
    const std::string_view text_name = purpose == Purpose::ExpectError ? "code" : "dialect";
    if (has_text) names.insert(names.begin(), text_name);
    else names.push_back(text_name);
    const auto bound = bind_arguments(expr, name, names, {});
    if (!bound) return error_value();
    const auto argument = [&](std::string_view wanted) {
        const auto found = std::find(names.begin(), names.end(), wanted);
        return (*bound)[static_cast<std::size_t>(found - names.begin())];
    };
    for (const std::string_view needed : {std::string_view("call"), text_name}) {
        if (argument(needed).is_valid() || (needed != "call" && !has_text)) continue;
        report(diag::ArgumentMissing, expr.range).arg(name).arg(needed);
        return error_value();
    }
    const std::optional<std::uint32_t> index = test_subject(name, argument("call"));
    if (!index) return error_value();
    const FunctionDecl function = functions_[*index];
    const Expr& call = ast()[argument("call")];
    std::vector<std::string_view> parameter_names;
    for (const ParameterDecl& parameter : function.parameters)
        parameter_names.push_back(parameter.name);
    const auto arguments = bind_arguments(call, function.name, parameter_names, function.range);
    if (!arguments) return error_value();

    const Reg base = emit_.take(kTestOptions + std::max<unsigned>(1, function.parameter_slots));
    const auto option = [&](std::string_view wanted, Type type, unsigned position) {
        const auto reg = static_cast<Reg>(base + position);
        if (argument(wanted).is_valid()) expression_in(argument(wanted), type, reg, wanted);
        else if (type == types::kString)
            emit_.emit_integer(OpCode::LoadI, reg, 0, kNotGivenInteger);
        else {
            for (unsigned i = 0; i < type_info(type).slots; ++i)
                emit_.emit_number(OpCode::LoadF, reg + i, 0, kNotGivenNumber);
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
        entry.layouts.push_back(layout_constant(parameter.type));
        if ((*arguments)[i].is_valid()) {
            pass_argument(parameter, (*arguments)[i], static_cast<Reg>(base + kTestOptions));
            entry.given |= 1u << i;
        } else if (parameter.is_required) {
            report(diag::ArgumentMissing, call.range)
                .arg(function.name)
                .arg(parameter.name)
                .note(parameter.range, "it is declared here");
        }
    }
    emit_.set_location(call.range);
    emit_.emit_pair(OpCode::TestCall, base, 0, 0, statement_id(call.range),
                    static_cast<std::int64_t>(code_->test_calls.size()));
    emit_.emit(OpCode::Finish);
    code_->test_calls.push_back(std::move(entry));
    const Type result = purpose == Purpose::Text          ? types::kString
                        : purpose == Purpose::ExpectError ? types::kVoid
                                                          : types::kExecution;
    return in_registers(result, base);
}

// ---------------------------------------------------------------- figures

Done Checker::take_figure_arguments(const FigureInfo& info, const Expr& call, Reg first) {
    const std::vector<FigureParameter> parameters = figure_parameters(info);
    std::vector<std::string_view> names;
    names.reserve(parameters.size());
    for (const FigureParameter& parameter : parameters) names.push_back(parameter.name);
    const auto bound = bind_arguments(call, info.name, names, {});
    if (!bound) return kFailed;
    Reg reg = first;
    Done taken = kDone;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const FigureParameter& parameter = parameters[i];
        const Type type = parameter.is_point   ? types::kPoint
                          : parameter.is_count ? types::kInt
                                               : types::kLengthType;
        if ((*bound)[i].is_valid()) {
            expression_in((*bound)[i], type, reg, parameter.name);
        } else if (parameter.is_optional) {
            emit_.emit_number(OpCode::LoadF, reg, 0, kNotGivenNumber);
        } else {
            report(diag::ArgumentMissing, call.range).arg(info.name).arg(parameter.name);
            taken = kFailed;
        }
        reg = static_cast<Reg>(reg + parameter.slots());
    }
    return taken;
}

Value Checker::figure(const Lvalue& execution, const Expr& member, const Expr* call) {
    const std::string_view name = text(member.text);
    if (name.empty()) return error_value();
    const auto* info = std::find_if(std::begin(kFigures), std::end(kFigures),
                                    [&](const FigureInfo& row) { return row.name == name; });
    const bool is_function = info != std::end(kFigures) && !info->parameters.empty();
    if (info == std::end(kFigures) || is_function != (call != nullptr)) {
        auto builder =
            report(is_function || call == nullptr ? diag::UnknownMember : diag::UnknownMethod,
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
    const Value handle = load(execution, member.range, true, kNoReg);
    if (is_error(handle)) return handle;
    unsigned slots = info->result == FigureResult::Point ? 3 : 1;
    unsigned argument_slots = 0;
    for (const FigureParameter& parameter : figure_parameters(*info))
        argument_slots += parameter.slots();
    const Reg first = emit_.take(std::max(slots, argument_slots));
    if (call != nullptr) {
        ++asked_figures_;
        if (!take_figure_arguments(*info, *call, first)) return error_value();
    }
    emit_.set_location(call != nullptr ? call->range : member.range);
    Type type = types::kInt;
    std::int64_t layout = 0;
    switch (info->result) {
        case FigureResult::Count: break;
        case FigureResult::Length: type = types_.optional(types::kLengthType); break;
        case FigureResult::Time: type = types::kTimeType; break;
        case FigureResult::Truth: type = types::kBool; break;
        case FigureResult::Text: type = types::kString; break;
        case FigureResult::Point: type = types::kPoint; break;
        case FigureResult::Counts:
            type = types_.array(types::kInt, -1);
            layout = layout_constant(types::kInt);
            break;
        case FigureResult::Lengths:
            type = types_.array(types::kLengthType, -1);
            layout = layout_constant(types::kLengthType);
            break;
    }
    emit_.emit_pair(OpCode::Figure, first, handle.reg, static_cast<unsigned>(info->figure), layout);
    emit_.release_to(static_cast<Reg>(first + slots));
    Value value = in_registers(type, first);
    value.is_fresh = true;
    return value;
}

// ---------------------------------------------------------------- expectations

void Checker::assume_statement(const Stmt& stmt) {
    if (function_ == nullptr || function_->kind != DeclKind::Property) {
        report(diag::TestOnly, stmt.range).arg("assume").arg("a `property`");
        return;
    }
    Label good;
    jump_if(stmt.expression[0], true, good);
    emit_.emit(OpCode::AssumeFailed);
    emit_.bind(good);
    assume_given(stmt.expression[0], true);
}

void Checker::expect_statement(const Stmt& stmt) {
    if (!is_in_test()) {
        report(diag::TestOnly, stmt.range).arg("expect").arg("a `test` or `property`");
        return;
    }
    expectation(stmt.expression[0]);
}

void Checker::expectation(ExprId id) {
    const Expr& expr = ast()[id];
    const bool is_binary = expr.kind == ExprKind::Binary;
    if (is_binary && expr.op == Operator::And) {
        // Each part reports for itself what is wrong.
        expectation(expr.child[0]);
        expectation(expr.child[1]);
        return;
    }
    const Reg mark = emit_.mark();
    emit_.set_location(expr.range);
    const std::uint32_t asked = asked_figures_;
    const auto reason = [&] { return asked_figures_ > asked ? kHasReason : std::uint16_t{0}; };
    const auto untrue = [&](Expectation why, Reg value) {
        emit_.set_location(expr.range);
        emit_.emit_pair(OpCode::ExpectFailed, value, 0, static_cast<unsigned>(why) | reason(),
                        text_constant(quoted(one_line(sources_.text(expr.range)))));
    };
    if (is_binary && is_comparison(expr.op)) {
        expect_comparison(expr);
    } else if (is_binary && expr.op == Operator::Contains &&
               kind(type_of(expr.child[0])) == TypeKind::String) {
        const SourceRange range = ast()[expr.child[1]].range;
        const Value whole =
            require_given(expression(expr.child[0]), ast()[expr.child[0]].range, {});
        const Value part =
            convert(expression(expr.child[1], types::kString), types::kString, range, {});
        if (!is_error(whole) && !is_error(part)) {
            Label good;
            const Reg text = in_register(whole);
            const Reg wanted = in_register(part);
            const Reg answer = emit_.take(1);
            emit_.emit(OpCode::ContainsText, answer, text, wanted);
            emit_.jump(OpCode::JumpIf, good, answer);
            untrue(Expectation::UntrueOfText, text);
            emit_.bind(good);
        }
    } else {
        Label good;
        jump_if(id, true, good);
        untrue(Expectation::Untrue, 0);
        emit_.bind(good);
    }
    emit_.release_to(mark);
}

bool Checker::is_measured(Type type) const {
    const TypeInfo& info = type_info(type);
    return info.kind == TypeKind::Real &&
           (info.quantity == kLength || info.quantity == kAngle || info.quantity == kTime);
}

void Checker::jump_if_near(Reg a, Reg b, Label& near) {
    const Reg way = emit_.take(1);
    const Reg most = emit_.take(1);
    emit_.emit(OpCode::SubF, way, a, b);
    emit_.emit(OpCode::Math1, way, way, static_cast<unsigned>(Math::Abs));
    emit_.emit_number(OpCode::LoadF, most, 0, kExpectTolerance);
    emit_.jump(OpCode::JumpLeF, near, way, most);
}

/// Jumps to `good` if both sides are as the operator wants, within the tolerance of tests.
Done Checker::emit_agreement(const Expr& expr, const Value& left, const Value& right, Label& good) {
    const Operator op = expr.op;
    const bool is_equality = op == Operator::Equal || op == Operator::NotEqual;
    if (is_equality && left.type == types::kPoint && right.type == types::kPoint) {
        Label differs;
        for (unsigned i = 0; i < 3; ++i) {
            Label next;
            const auto a = static_cast<Reg>(left.reg + i);
            const auto b = static_cast<Reg>(right.reg + i);
            const Reg same = emit_.take(1);
            emit_.emit(OpCode::EqualPart, same, a, b).immediate.pair = {
                static_cast<std::int32_t>(SlotKind::Number), 0};
            emit_.jump(OpCode::JumpIf, next, same);
            // A part that only one of them has never agrees.
            Label apart;
            for (const Reg part : {a, b}) {
                emit_.jump(OpCode::JumpNotGiven, apart, part, 0,
                           static_cast<unsigned>(SlotKind::Number));
            }
            jump_if_near(a, b, next);
            emit_.bind(apart);
            emit_.jump(OpCode::Jump, op == Operator::Equal ? differs : good);
            emit_.bind(next);
        }
        if (op == Operator::Equal) emit_.jump(OpCode::Jump, good);
        emit_.bind(differs);
        return kDone;
    }
    const std::optional<ComparedSides> found = compare(expr, left, right);
    if (!found) return kFailed;
    const bool is_exact = op == Operator::Less || op == Operator::Greater;
    if (!found->is_real || !is_measured(found->left.type) || is_exact) {
        jump_compare(*found, true, good, -1);
        return kDone;
    }
    const Reg a = in_register(found->left);
    const Reg b = in_register(found->right);
    if (op == Operator::Equal) {
        jump_if_near(a, b, good);
    } else if (op == Operator::NotEqual) {
        Label near;
        jump_if_near(a, b, near);
        emit_.jump(OpCode::Jump, good);
        emit_.bind(near);
    } else {
        const Reg beyond = emit_.take(1);
        const Reg most = emit_.take(1);
        const bool is_upper = op == Operator::LessEqual;
        emit_.emit(OpCode::SubF, beyond, is_upper ? a : b, is_upper ? b : a);
        emit_.emit_number(OpCode::LoadF, most, 0, kExpectTolerance);
        emit_.jump(OpCode::JumpLeF, good, beyond, most);
    }
    return kDone;
}

void Checker::expect_comparison(const Expr& expr) {
    const std::uint32_t asked = asked_figures_;
    std::optional<Sides> sides = compared_sides(expr);
    if (!sides) return;
    if (types_.is_numeric(sides->left.type) && types_.is_numeric(sides->right.type) &&
        kind(sides->left.type) != TypeKind::Int) {
        // A bare number shows the unit that it gets.
        if (is_plain_number(sides->right) && sides->right.is_constant())
            sides->right = adapt_number(sides->right, sides->left.type);
    }
    sides->left = in_registers(sides->left.type, in_register(sides->left));
    const bool is_literal = sides->right.is_constant();
    sides->right = in_registers(sides->right.type, in_register(sides->right));
    Label good;
    if (!emit_agreement(expr, sides->left, sides->right, good)) return;
    // `12mm == run.x`: what is looked at is what is not written down.
    const auto is_number = [&](ExprId id) {
        return ast()[id].kind == ExprKind::Int || ast()[id].kind == ExprKind::Real;
    };
    const bool is_swapped = is_number(expr.child[0]) && !is_number(expr.child[1]);
    if (is_swapped) std::swap(sides->left, sides->right);
    const ExprId seen = expr.child[is_swapped ? 1 : 0];
    const ExprId wanted = expr.child[is_swapped ? 0 : 1];
    const Reg is = shown(sides->left);
    const Reg should = shown(sides->right);
    std::string words(expected_words(is_swapped ? mirrored(expr.op) : expr.op));
    const bool is_written_out = is_literal || ast()[wanted].kind == ExprKind::Braces;
    if (!is_written_out && !is_swapped)
        words += " (" + quoted(one_line(sources_.text(ast()[wanted].range))) + ")";
    emit_.set_location(expr.range);
    const std::uint16_t reason = asked_figures_ > asked ? kHasReason : 0;
    emit_.emit_pair(
        OpCode::ExpectFailed, is, should, static_cast<unsigned>(Expectation::Compared) | reason,
        text_constant(quoted(one_line(sources_.text(ast()[seen].range)))), text_constant(words));
    emit_.bind(good);
}

/// A value as it would be written in the program, with its unit.
void Checker::append_shown(const Value& value, FormatPattern& pattern) {
    const auto literal = [&](std::string_view words) {
        FormatPiece piece;
        piece.text = words;
        pattern.push_back(std::move(piece));
    };
    const TypeInfo info = type_info(types_.given(value.type));
    if (info.kind == TypeKind::Struct) {
        literal("{");
        bool is_first = true;
        for (const Member& member : std::vector<Member>(types_.struct_of(value.type).members)) {
            if (!is_first) literal(", ");
            is_first = false;
            append_shown(in_registers(member.type, 0), pattern);
        }
        literal("}");
        return;
    }
    FormatPiece piece;
    if (info.kind == TypeKind::String) literal("\"");
    if (!read_format(value, {}, emit_.location(), piece)) return;
    add_unit(value.type, "", piece);
    pattern.push_back(std::move(piece));
    if (info.kind == TypeKind::String) literal("\"");
}

Reg Checker::shown(const Value& value) {
    FormatPattern pattern;
    append_shown(value, pattern);
    const Reg reg = emit_.take(1);
    emit_.emit_pair(OpCode::Format, reg, in_register(value), 0,
                    static_cast<std::int64_t>(code_->formats.size()));
    code_->formats.push_back(std::move(pattern));
    return reg;
}

}  // namespace kadr::sema
