// check.cpp — the road through a program: names of all files, types, signatures, globals, bodies.
#include "sema/check.h"

#include <algorithm>

#include "base/diagnostics/sema.h"
#include "sema/checking.h"
#include "sema/declarations.h"
#include "sema/diameters.h"
#include "sema/functions.h"
#include "sema/globals.h"
#include "sema/naming.h"
#include "sema/type_declarations.h"

namespace kadr::sema {

using syntax::DeclKind;

Check::Check(ModuleLoader& modules, const Sources& all_sources, DiagnosticSink& messages,
             const CheckOptions& chosen)
    : loader(modules),
      sources(all_sources),
      sink(messages),
      options(chosen),
      code(std::make_unique<Code>()),
      emit(*code) {}

void look_at_clock(Check& check) {
    constexpr std::uint32_t kSlice = 256;  // statements
    Clock& clock = check.clock;
    if (clock.is_late || ++clock.looked < kSlice || !check.options.is_over) return;
    clock.looked = 0;
    clock.is_late = check.options.is_over();
    // What is not looked at any more is no mistake.
    check.sink.is_quiet = check.sink.is_quiet || clock.is_late;
}

namespace {

void finish(Check& check) {
    for (std::uint32_t i = 0; i < check.names.function_count(); ++i) {
        const FunctionDecl& function = check.names.function(i);
        FunctionCode& entry = check.code->functions[i + 1];
        entry.name = function.name;
        entry.kind = function.kind == DeclKind::Program    ? FunctionKind::Program
                     : function.kind == DeclKind::Cycle    ? FunctionKind::Cycle
                     : function.kind == DeclKind::Test     ? FunctionKind::Test
                     : function.kind == DeclKind::Property ? FunctionKind::Property
                                                           : FunctionKind::Plain;
        entry.result_slots = check.type_info(function.result).slots;
        entry.units = units_of(check, function);
        if (entry.kind == FunctionKind::Program) {
            entry.motion = check.names.module(function.module).dialect->first_motion();
            entry.work_offset = check.names.module(function.module).dialect->first_work_offset();
        }
        entry.range = function.range;
        entry.is_main_file = function.module == 0;
        for (const ParameterDecl& parameter : function.parameters) {
            entry.parameters.push_back(describe_parameter(check, parameter));
        }
    }
    mark_diameters(check);
    finish_names(check);
    export_enums(check);
}

/// Not done: there was an error, and so there is no code.
Done check_program(Check& check, const syntax::Ast& main, const nc::Dialect& dialect) {
    load_module(check, main, dialect);
    check.code->main_file = main.file;
    const std::uint32_t modules = check.names.module_count();
    for (std::uint32_t i = 0; i < modules; ++i) declare_names(check, i);
    if (check.names.function_count() > kMostFunctions) {
        check.report(diag::TooManyFunctions, check.names.function(kMostFunctions).range)
            .arg(std::size_t{check.names.function_count()})
            .arg(std::size_t{kMostFunctions});
        return kFailed;
    }
    check.code->functions.resize(check.names.function_count() + 1);

    FunctionCode& startup = check.code->functions[0];
    startup.name = "globals";
    startup.kind = FunctionKind::Startup;
    check.here.is_startup = true;
    check.emit.begin_function();
    for (std::uint32_t i = 0; i < modules; ++i) define_types(check, i);
    for (std::uint32_t i = 0; i < check.names.function_count(); ++i) define_signature(check, i);
    check.code->functions[0].entry = check.code->functions[0].body = check.emit.here();
    // Imported files come behind the file that imports them; their variables are needed first.
    for (std::uint32_t i = modules; i-- > 0;) {
        for (std::uint32_t g = 0; g < check.names.global_count(); ++g) {
            if (check.names.global(g).module == i) check_global(check, g, false);
        }
    }
    check.emit.emit(OpCode::Return, 0, 0, 0);
    check.code->functions[0].end = check.emit.here();
    check.code->functions[0].registers = check.emit.registers_used();
    check.here.is_startup = false;

    for (std::uint32_t i = 0; i < check.names.function_count(); ++i) {
        if (check.names.function(i).module != 0) continue;
        check.names.want(i);
    }
    // Calls add to the list: functions of other files are checked as soon as somebody wants them.
    for (std::size_t i = 0; i < check.names.wanted().size(); ++i)
        check_function(check, check.names.wanted()[i]);
    if (check.clock.is_late) return kFailed;
    finish(check);
    if (check.sink.errors > 0) return kFailed;
    for (const Reported::Unused& unused : check.told.unused) {
        check.report(diag::UnusedVariable, unused.range).arg(unused.name);
    }
    return kDone;
}

}  // namespace

CheckResult check(const syntax::Ast& main, const nc::Dialect& dialect, ModuleLoader& modules,
                  const Sources& sources, DiagnosticSink& sink, const CheckOptions& options) {
    Check check(modules, sources, sink, options);
    const Done checked = check_program(check, main, dialect);
    check.checked.plans = check.code->plans;
    if (const auto prelude = check.names.prelude()) check.checked.prelude = *prelude;
    return {checked ? std::move(check.code) : nullptr, std::move(check.checked)};
}

}  // namespace kadr::sema
