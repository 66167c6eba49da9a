// check.cpp — the road through a program: names of all files, types, signatures, globals, bodies.
#include "sema/check.h"

#include <algorithm>

#include "base/diagnostics/sema.h"
#include "sema/checker.h"

namespace kadr::sema {

using syntax::DeclKind;

Checker::Checker(ModuleLoader& modules, const Sources& sources, DiagnosticSink& sink,
                 const CheckOptions& options)
    : loader_(modules),
      sources_(sources),
      sink_(sink),
      options_(options),
      code_(std::make_unique<Code>()),
      emit_(*code_) {}

/// `units inch;` as the first statement of a program holds for all of it, its parameters too.
Units Checker::units_of(const FunctionDecl& function) const {
    const syntax::Ast& tree = *modules_[function.module].ast;
    const syntax::Decl& decl = tree[function.decl];
    if (!decl.body.is_valid()) return modules_[function.module].units;
    for (const syntax::StmtId id : tree.stmts(tree[decl.body].statements)) {
        const syntax::Stmt& stmt = tree[id];
        if (stmt.kind == syntax::StmtKind::Empty) continue;
        if (stmt.kind != syntax::StmtKind::Units) break;
        return tree.text(stmt.text) == "mm" ? Units::Metric : Units::Inch;
    }
    return modules_[function.module].units;
}

bool Checker::is_library(std::uint32_t module) const {
    return sources_.name(modules_[module].ast->file).find("stdlib") != std::string_view::npos;
}

std::optional<nc::CycleId> Checker::native_cycle(const FunctionDecl& function) const {
    if (function.kind != DeclKind::Cycle) return std::nullopt;
    // Only the cycles of the standard library are the controls' own: a user's cycle of the same
    // name does what the user wrote.
    if (!is_library(function.module)) return std::nullopt;
    const nc::Dialect& dialect = *modules_[0].dialect;
    const std::optional<nc::CycleId> id = dialect.find_cycle(function.name);
    if (!id) return std::nullopt;
    const std::vector<nc::Parameter>& parameters = dialect.cycles()[*id].parameters;
    const bool same =
        std::equal(parameters.begin(), parameters.end(), function.parameters.begin(),
                   function.parameters.end(),
                   [](const nc::Parameter& a, const ParameterDecl& b) { return a.name == b.name; });
    return same ? id : std::nullopt;
}

void Checker::emit_native_cycle() {
    if (!native_pending_) return;
    native_pending_ = false;
    emit_.emit_pair(OpCode::NativeCycle, 0, 0, 0, *current_native_);
}

namespace {

/// Whether a statement asks something of the parameters, or warns of them, and does nothing else.
bool is_contract(const syntax::Ast& tree, syntax::StmtId id) {
    const syntax::Stmt& stmt = tree[id];
    switch (stmt.kind) {
        case syntax::StmtKind::Require:
        case syntax::StmtKind::Assert:
        case syntax::StmtKind::WarnStmt: return true;
        case syntax::StmtKind::If:
            return !stmt.statement[1].is_valid() && is_contract(tree, stmt.statement[0]);
        case syntax::StmtKind::For: return is_contract(tree, stmt.statement[1]);
        case syntax::StmtKind::Block:
            return std::ranges::all_of(tree.stmts(stmt.statements), [&](syntax::StmtId inner) {
                return tree[inner].kind == syntax::StmtKind::Declaration ||
                       is_contract(tree, inner);
            });
        default: return false;
    }
}

}  // namespace

bool Checker::only_checks(const FunctionDecl& function) const {
    const syntax::Ast& tree = *modules_[function.module].ast;
    const syntax::Decl& decl = tree[function.decl];
    if (!decl.body.is_valid()) return false;
    return is_contract(tree, decl.body);
}

/// The function that an expression is a call of; null if it is none of a Kadr file.
const FunctionDecl* Checker::called_function(syntax::ExprId id) const {
    if (!id.is_valid()) return nullptr;
    const syntax::Expr& expr = ast()[id];
    const bool is_call =
        expr.kind == syntax::ExprKind::Call && ast()[expr.child[0]].kind == syntax::ExprKind::Name;
    if (!is_call) return nullptr;
    const Name* found = find_global(module_, text(ast()[expr.child[0]].text));
    if (found == nullptr || found->what != Name::What::Function) return nullptr;
    return &functions_[found->index];
}

/// The contract of a cycle holds for a native one too, so it is checked before; so is what a
/// function works out for the cycle, which may ask as well.
bool Checker::is_check(syntax::StmtId id) const {
    const syntax::Stmt& stmt = ast()[id];
    switch (stmt.kind) {
        case syntax::StmtKind::Empty: return true;
        case syntax::StmtKind::Expression: {
            const FunctionDecl* function = called_function(stmt.expression[0]);
            return function != nullptr && only_checks(*function);
        }
        case syntax::StmtKind::Declaration: {
            const FunctionDecl* function = called_function(ast()[stmt.declaration].value);
            return function != nullptr && function->kind == DeclKind::Function;
        }
        default: return is_contract(ast(), id);
    }
}

CheckResult Checker::run(const syntax::Ast& main, const nc::Dialect& dialect) {
    const bool is_good = check_program(main, dialect);
    checked_.plans = code_->plans;
    if (prelude_ < modules_.size()) checked_.prelude = prelude_;
    return {is_good ? std::move(code_) : nullptr, std::move(checked_)};
}

bool Checker::check_program(const syntax::Ast& main, const nc::Dialect& dialect) {
    load_module(main, dialect);
    code_->main_file = main.file;
    const auto modules = static_cast<std::uint32_t>(modules_.size());
    for (std::uint32_t i = 0; i < modules; ++i) declare_names(i);
    if (functions_.size() > kMostFunctions) {
        report(diag::TooManyFunctions, functions_[kMostFunctions].range)
            .arg(functions_.size())
            .arg(std::size_t{kMostFunctions});
        return false;
    }
    code_->functions.resize(functions_.size() + 1);

    FunctionCode& startup = code_->functions[0];
    startup.name = "globals";
    startup.kind = FunctionKind::Startup;
    is_startup_ = true;
    emit_.begin_function();
    for (std::uint32_t i = 0; i < modules; ++i) define_types(i);
    for (std::uint32_t i = 0; i < functions_.size(); ++i) define_signature(i);
    code_->functions[0].entry = code_->functions[0].body = emit_.here();
    // Imported files come behind the file that imports them; their variables are needed first.
    for (std::uint32_t i = modules; i-- > 0;) {
        for (std::uint32_t g = 0; g < globals_.size(); ++g) {
            if (globals_[g].module == i) check_global(g, false);
        }
    }
    emit_.emit(OpCode::Return, 0, 0, 0);
    code_->functions[0].end = emit_.here();
    code_->functions[0].registers = emit_.registers_used();
    is_startup_ = false;

    for (std::uint32_t i = 0; i < functions_.size(); ++i) {
        if (functions_[i].module != 0) continue;
        functions_[i].is_wanted = true;
        wanted_.push_back(i);
    }
    // Calls add to the list: functions of other files are checked as soon as somebody wants them.
    for (std::size_t i = 0; i < wanted_.size(); ++i) check_function(wanted_[i]);
    if (is_late_) return false;
    finish();
    if (sink_.errors > 0) return false;
    for (const Unused& unused : unused_) {
        report(diag::UnusedVariable, unused.range).arg(unused.name);
    }
    return true;
}

/// Asked in front of each statement, it finds now and then whether there is time left.
void Checker::look_at_clock() {
    constexpr std::uint32_t kSlice = 256;
    if (is_late_ || ++looked_ < kSlice || !options_.is_over) return;
    looked_ = 0;
    is_late_ = options_.is_over();
    sink_.is_quiet = sink_.is_quiet || is_late_;  // what is not looked at any more is no mistake
}

void Checker::finish() {
    for (std::uint32_t i = 0; i < functions_.size(); ++i) {
        const FunctionDecl& function = functions_[i];
        FunctionCode& entry = code_->functions[i + 1];
        entry.name = function.name;
        entry.kind = function.kind == DeclKind::Program    ? FunctionKind::Program
                     : function.kind == DeclKind::Cycle    ? FunctionKind::Cycle
                     : function.kind == DeclKind::Test     ? FunctionKind::Test
                     : function.kind == DeclKind::Property ? FunctionKind::Property
                                                           : FunctionKind::Plain;
        entry.result_slots = type_info(function.result).slots;
        entry.units = units_of(function);
        if (entry.kind == FunctionKind::Program) {
            entry.motion = modules_[function.module].dialect->first_motion();
            entry.work_offset = modules_[function.module].dialect->first_work_offset();
        }
        entry.range = function.range;
        entry.is_main_file = function.module == 0;
        for (const ParameterDecl& parameter : function.parameters) {
            entry.parameters.push_back(describe_parameter(parameter));
        }
    }
    mark_diameters();
    export_enums();
}

/// What the blocks of a function set for X themselves, and those of its contours.
Checker::DiameterWords Checker::diameter_words(const FunctionCode& function) const {
    DiameterWords words;
    int contours = 0;
    for (std::uint32_t at = function.entry; at < function.end; ++at) {
        const Instruction& instruction = code_->instructions[at];
        contours += static_cast<int>(instruction.op == OpCode::BeginContour) -
                    static_cast<int>(instruction.op == OpCode::EndContour);
        if (instruction.op != OpCode::Emit) continue;
        const Plan& plan = code_->plans[static_cast<std::size_t>(instruction.immediate.pair.first)];
        for (const nc::Invocation& invocation : plan.functions) {
            if (nc::info(invocation.function).group != nc::Group::Diameter) continue;
            if (contours == 0) words.in_program = true;
            else words.in_contour |= invocation.function == nc::Function::DiameterOn;
        }
    }
    return words;
}

/// A function works with diameters, unless it sets what X is, if it makes a contour of diameters,
/// or calls what works with them: a cycle of a lathe is written for DIAMON. So does what is written
/// for a control where X always is one.
void Checker::mark_diameters() {
    std::vector<FunctionCode>& functions = code_->functions;
    std::vector<bool> decides(functions.size());
    for (std::size_t i = 0; i < functions.size(); ++i) {
        const std::vector<nc::Function>& needs = functions[i].needs;
        const DiameterWords words = diameter_words(functions[i]);
        const bool is_of_lathe = i > 0 && modules_[functions_[i - 1].module].dialect->power_on(
                                              nc::Group::Diameter) == nc::Function::DiameterOn;
        decides[i] = words.in_program;
        functions[i].has_diameters =
            is_of_lathe || (words.in_contour && !words.in_program) ||
            std::find(needs.begin(), needs.end(), nc::Function::DiameterOn) != needs.end();
    }
    // From what turns to what calls it, and on to what calls that.
    std::vector<std::vector<std::uint32_t>> callers(functions.size());
    for (std::uint32_t i = 0; i < functions.size(); ++i) {
        for (std::uint32_t at = functions[i].entry; at < functions[i].end; ++at) {
            const Instruction& instruction = code_->instructions[at];
            if (instruction.op == OpCode::Call) callers[instruction.b].push_back(i);
        }
    }
    std::vector<std::uint32_t> pending;
    const auto mark = [&](std::uint32_t i) {
        functions[i].has_diameters = true;
        pending.push_back(i);
    };
    for (std::uint32_t i = 0; i < functions.size(); ++i) {
        if (functions[i].has_diameters) pending.push_back(i);
    }
    while (!pending.empty()) {
        const std::uint32_t turning = pending.back();
        pending.pop_back();
        // A contour of the file is everybody's.
        for (std::uint32_t i = 0; turning == 0 && i < functions.size(); ++i) {
            if (!functions[i].has_diameters && !decides[i]) mark(i);
        }
        for (const std::uint32_t i : callers[turning]) {
            if (!functions[i].has_diameters && !decides[i]) mark(i);
        }
    }
}

CheckResult check(const syntax::Ast& main, const nc::Dialect& dialect, ModuleLoader& modules,
                  const Sources& sources, DiagnosticSink& sink, const CheckOptions& options) {
    return Checker(modules, sources, sink, options).run(main, dialect);
}

}  // namespace kadr::sema
