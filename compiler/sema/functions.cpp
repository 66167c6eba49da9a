#include "sema/functions.h"

#include <algorithm>

#include "base/diagnostics/sema.h"
#include "sema/checking.h"
#include "sema/convert.h"
#include "sema/curves.h"
#include "sema/declarations.h"
#include "sema/expressions.h"
#include "sema/naming.h"
#include "sema/native_cycles.h"
#include "sema/preserves.h"
#include "sema/scope.h"
#include "sema/statements.h"
#include "sema/tests.h"
#include "sema/texts.h"
#include "sema/type_declarations.h"
#include "sema/values.h"
#include "sema/with.h"

namespace kadr::sema {

using syntax::Decl;
using syntax::DeclKind;

namespace {

void declare_parameter(Check& check, const FunctionDecl& function, ParameterDecl& parameter);
void report_missing_return(Check& check, const FunctionDecl& function, const syntax::Decl& decl,
                           const SourceRange& end);
void report_unused_parameters(Check& check);

}  // namespace

void define_signature(Check& check, std::uint32_t index) {
    check.here.module = check.names.function(index).module;
    check.here.units = units_of(check, check.names.function(index));
    const Decl decl = check.ast()[check.names.function(index).decl];
    FunctionDecl& function = check.names.function(index);
    function.result = decl.kind == DeclKind::Function && decl.type.is_valid()
                          ? resolve_type(check, decl.type)
                          : types::kVoid;
    check.record.set_type(function.checked, function.result);
    if (decl.type.is_valid() && check.ast()[decl.type].is_reference) {
        check.report(diag::ReferencePlace, check.ast()[decl.type].range);
    }
    const bool is_curve = decl.kind == DeclKind::Curve;
    if (is_curve) function.result = function.is_limits ? types::kRange : types::kPoint;
    std::vector<syntax::DeclId> parameters(check.ast().decls(decl.parameters).begin(),
                                           check.ast().decls(decl.parameters).end());
    // The running parameter is one more of the function that gives the points.
    if (is_curve && !function.is_limits) parameters.push_back(check.ast().decls(decl.members)[0]);
    std::uint32_t next = 0;
    for (const syntax::DeclId id : parameters) {
        const Decl& parameter = check.ast()[id];
        ParameterDecl entry;
        entry.name = check.text(parameter.name);
        entry.range = parameter.name_range;
        entry.decl = id;
        entry.type = resolve_type(check, parameter.type);
        if (entry.type == types::kVoid) {
            check.report(diag::VoidValue, parameter.range);
            entry.type = types::kError;
        }
        entry.is_reference = parameter.type.is_valid() && check.ast()[parameter.type].is_reference;
        // `int n in 1..20` of a property: a range is not a default.
        if (decl.kind != DeclKind::Property) entry.initial = parameter.value;
        if (entry.is_reference && parameter.value.is_valid()) {
            check.report(diag::ReferenceDefault, parameter.range).arg(entry.name);
            entry.initial = {};
        }
        if (entry.is_reference && decl.kind == DeclKind::Program) {
            check.report(diag::ProgramParameter, parameter.range).arg(entry.name);
        }
        entry.may_be_unset = parameter.type.is_valid() && check.ast()[parameter.type].is_optional &&
                             check.kind(entry.type) == TypeKind::Struct;
        entry.is_required = !entry.initial.is_valid() && !check.type_info(entry.type).is_optional &&
                            !entry.may_be_unset;
        entry.slots = entry.is_reference ? 1 : check.type_info(entry.type).slots;
        entry.reg = static_cast<Reg>(next);
        next += entry.slots;
        declare_parameter(check, function, entry);
        function.parameters.push_back(entry);
    }
    if (function.parameters.size() > 32) {
        check.report(diag::TooManyParameters, decl.name_range).arg(function.name);
        function.parameters.resize(32);
    }
    // Reported where the body is checked, which finds no room for them.
    function.parameter_slots = static_cast<std::uint16_t>(std::min(next, kMostRegisters + 1));
}

namespace {

/// Both functions of a curve have its parameters.
void declare_parameter(Check& check, const FunctionDecl& function, ParameterDecl& parameter) {
    const SymbolId known =
        check.checked.files[check.here.module].declarations[parameter.decl.index];
    if (known.is_valid()) {
        parameter.checked = known;
        return;
    }
    DeclaredSymbol symbol =
        described(check, check.here.module, parameter.decl, DeclaredSymbol::Kind::Parameter);
    symbol.scope = check.ast()[function.decl].range;
    symbol.type = parameter.type;
    symbol.owner = function.checked;
    parameter.checked = check.record.declare(std::move(symbol));
}

}  // namespace

namespace {

void bind_parameters(Check& check, const FunctionDecl& function) {
    for (const ParameterDecl& parameter : function.parameters) {
        Symbol symbol;
        symbol.name = parameter.name;
        symbol.type = parameter.type;
        symbol.storage =
            parameter.is_reference ? Symbol::Storage::Reference : Symbol::Storage::Local;
        symbol.reg = parameter.reg;
        symbol.range = parameter.range;
        symbol.decl = parameter.decl;
        symbol.checked = parameter.checked;
        symbol.is_parameter = true;
        symbol.may_be_unset = parameter.may_be_unset;
        if (parameter.may_be_unset) symbol.givenness = Givenness::Perhaps;
        if (check.type_info(parameter.type).is_optional) symbol.givenness = Givenness::Perhaps;
        const Found same = find(check, parameter.name);
        if (same.symbol >= 0) check.scopes[same.symbol].is_read = true;  // reported once
        add_symbol(check, symbol);
    }
}

/// The prologue: each default is evaluated if its argument was not given. A default may use the
/// parameters before it.
void check_defaults(Check& check, const FunctionDecl& function) {
    for (std::size_t i = function.parameters.size(); i-- > 0;)
        check.scopes.hide(function.parameters[i].name);
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const ParameterDecl parameter = function.parameters[i];
        const auto symbol = static_cast<std::int32_t>(i);
        const auto show = [&] { check.scopes.show(symbol); };
        if (parameter.is_required) {
            show();
            continue;
        }
        check.body.defaults_from = i;
        Label skip;
        check.emit.set_location(parameter.range);
        check.emit.jump(OpCode::SkipIfGiven, skip, 0, 0, static_cast<unsigned>(i));
        const Reg mark = check.emit.mark();
        if (!parameter.initial.is_valid()) {
            emit_unset(check, parameter.type, parameter.reg);
        } else {
            check.emit.set_location(check.ast()[parameter.initial].range);
            Value value = expression(check, parameter.initial, parameter.type);
            // `length initial = position.z`: a default that is not given itself leaves the
            // parameter not given; reading it is the mistake.
            if (check.type_info(value.type).is_optional &&
                !check.type_info(parameter.type).is_optional &&
                check.type_info(parameter.type).kind == check.type_info(value.type).kind) {
                check.scopes[symbol].may_be_unset = true;
                check.scopes[symbol].givenness = Givenness::Perhaps;
                check.scopes[symbol].unset_name =
                    check.sources.text(check.ast()[parameter.initial].range);
                value.type = check.types.given(value.type);
            }
            value = convert(check, value, parameter.type, check.ast()[parameter.initial].range,
                            parameter.name);
            if (!check.is_error(value)) copy_value(check, value, parameter.reg);
        }
        check.emit.release_to(mark);
        check.emit.bind(skip);
        show();
    }
    check.body.defaults_from = BodyState::kNoDefault;
}

}  // namespace

void check_function(Check& check, std::uint32_t index) {
    const FunctionDecl function = check.names.function(index);
    check.here.module = function.module;
    check.here.units = units_of(check, function);
    const Decl decl = check.ast()[function.decl];
    check.here.function = &function;
    check.emit.begin_function();
    check.scopes.begin_function(decl.range.end);
    check.here.loops.clear();
    check.here.with_depth = 0;
    check.here.loop_depth = 0;
    check.body.native = native_cycle(check, function);

    FunctionCode& entry = check.code->functions[index + 1];
    entry.entry = check.emit.here();
    check.emit.take(
        std::max<unsigned>(function.parameter_slots, check.type_info(function.result).slots));
    check.emit.release_to(function.parameter_slots);
    bind_parameters(check, function);
    if (function.kind == DeclKind::Property) property_ranges(check, index);
    check_defaults(check, function);
    check.code->functions[index + 1].body = check.emit.here();
    check.body.native_pending = check.body.native.has_value();
    if (decl.kind == DeclKind::Curve) {
        curve_body(check, function, decl);
        for (const Symbol& symbol : check.scopes.all()) report_unused(check, symbol);
        end_variables(check);
        FunctionCode& curve = check.code->functions[index + 1];
        curve.end = check.emit.here();
        curve.registers = check.emit.registers_used();
        // The function of the points has all parameters of that of the limits, one more and three
        // coordinates: where these find no room it reports it for both.
        constexpr std::uint32_t kMoreOfPoints = 4;
        if (!function.is_limits || function.parameter_slots + kMoreOfPoints <= kMostRegisters)
            report_overflow(check, function.name, function.range);
        check.here.function = nullptr;
        return;
    }
    check.body.has_preserves = decl.preserves.count > 0;
    if (check.body.has_preserves) {
        check.emit.set_location(decl.range);
        ModalMask mask = words_mask(check, check.ast().word_run(decl.preserves), true);
        check.emit.emit_pair(OpCode::EnterPreserves, 0, 0, 0, mask);
        check.code->functions[index + 1].needs = preserved_members(check, decl);
    }
    Completion completion = Completion::Normal;
    if (decl.body.is_valid()) {
        const syntax::Stmt body = check.ast()[decl.body];
        completion = body.kind == syntax::StmtKind::Block
                         ? block(check, body.statements, body.range)
                         : statement(check, decl.body);
    }
    emit_native_cycle(check);
    const SourceRange end{decl.range.file, decl.range.end > 0 ? decl.range.end - 1 : 0,
                          decl.range.end};
    check.emit.set_location(end);
    if (completion == Completion::Normal) {
        if (function.result != types::kVoid && check.kind(function.result) != TypeKind::Error)
            report_missing_return(check, function, decl, end);
        leave_function(check, end);
        check.emit.emit(OpCode::Return, 0, 0, 0);
    }
    if (check.body.has_preserves) check_preserves(check, function, decl);
    report_unused_parameters(check);
    end_variables(check);

    FunctionCode& done = check.code->functions[index + 1];
    done.end = check.emit.here();
    done.registers = check.emit.registers_used();
    report_overflow(check, function.name, function.range);
    check.here.function = nullptr;
}

namespace {

void report_missing_return(Check& check, const FunctionDecl& function, const Decl& decl,
                           const SourceRange& end) {
    // A statement that could not be read may have been the `return`.
    const bool is_broken =
        std::ranges::any_of(check.ast().statements, [&](const syntax::Stmt& other) {
            return other.kind == syntax::StmtKind::Invalid &&
                   other.range.begin >= decl.range.begin && other.range.end <= decl.range.end;
        });
    if (is_broken) return;
    check.report(diag::MissingReturn, function.range)
        .arg(function.name)
        .arg(check.type_name(function.result))
        .note(end, "the end is reached here without a `return`");
}

void report_unused_parameters(Check& check) {
    if (check.here.function->module != 0) return;  // a library's own matter
    if (check.ast().has_errors) return;            // what is missing may have used them
    for (const Symbol& symbol : check.scopes.all()) {
        if (!symbol.is_parameter || symbol.is_read || symbol.name.empty()) continue;
        check.report(diag::UnusedParameter, symbol.range).arg(symbol.name);
    }
}

}  // namespace

ParameterInfo describe_parameter(Check& check, const ParameterDecl& parameter) {
    ParameterInfo info;
    info.name = parameter.name;
    info.type_name = check.type_name(parameter.type);
    const TypeInfo& type = check.type_info(parameter.type);
    using K = ParameterInfo::Kind;
    switch (type.kind) {
        case TypeKind::Bool: info.kind = K::Bool; break;
        case TypeKind::Int: info.kind = K::Integer; break;
        case TypeKind::Real: info.kind = K::Number; break;
        case TypeKind::Feed: info.kind = K::Feed; break;
        case TypeKind::Speed: info.kind = K::Speed; break;
        case TypeKind::String: info.kind = K::Text; break;
        case TypeKind::Enum: info.kind = K::Enum; break;
        case TypeKind::Struct:
        case TypeKind::Array:
        case TypeKind::Range:
        case TypeKind::Execution:
        case TypeKind::Void:
        case TypeKind::Error: info.kind = K::Other; break;
    }
    if (type.is_contour) info.kind = K::Contour;
    if (parameter.is_reference) info.kind = K::Other;
    if (info.kind == K::Contour) info.layout = layout_constant(check, type.element);
    info.quantity = type.quantity;
    info.is_optional = type.is_optional;
    info.has_default = !parameter.is_required;
    info.slot = parameter.reg;
    info.slots = parameter.slots;
    info.enumeration = type.kind == TypeKind::Enum ? type.definition : 0;
    info.range = parameter.range;
    return info;
}

void report_overflow(Check& check, std::string_view name, const SourceRange& range) {
    if (!check.emit.has_overflowed()) return;
    check.emit.forget_overflow();
    check.report(diag::FunctionTooLarge, range).arg(name);
}

}  // namespace kadr::sema
