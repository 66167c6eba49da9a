// definitions.cpp — variables and macros that all programs have. They are declared in programs of
// their own, SINUMERIK's SGUD, MGUD, UGUD and SMAC, MMAC, UMAC, which are read before the main
// program runs.

#include "macro/definitions.h"

#include <algorithm>

#include "base/diagnostics/control.h"
#include "macro/program_run.h"

namespace kadr::macro {

using nc::Block;
using nc::Function;
using nc::Statement;

namespace {

/// What may stand in a program of definitions.
bool defines(const nc::ControlStatement& statement) {
    switch (statement.kind) {
        case Statement::Declare:
        case Statement::DefineMacro:
        case Statement::Procedure:
        case Statement::Return: return true;
        default: return false;
    }
}

}  // namespace

/// They are on top of the main program as if it had called them, the first one last.
void Definitions::begin() {
    const std::vector<std::string>& names = run_.language.calls.definitions;
    // One that is looked at by itself, `kadr check UGUD.DEF`, is the program that runs.
    const std::string own = nc::program_of_path(run_.language.calls, run_.units.main().text->name,
                                                run_.tables.notation.ignores_case);
    const bool is_own = std::ranges::find(names, own) != names.end();
    if (is_own) {
        run_.frames[0]->is_definition = true;
        run_.frames[0]->level = &run_.variables.definitions();
    }
    for (auto name = names.rbegin(); name != names.rend(); ++name) {
        if (is_own && *name == own) continue;
        ProgramUnit* const unit = run_.units.find_definitions(*name);
        if (unit == nullptr) continue;
        auto open = std::make_unique<RunningProgram>();
        open->unit = unit;
        open->text.name = unit->text->name;
        open->text.program = unit->name;
        open->level = &run_.variables.definitions();
        open->here = unit->begin;
        open->is_definition = true;
        run_.add_frame(std::move(open));
    }
    if (run_.frames.size() > 1) run_.resume_frame(*run_.frames.back());
}

/// The next program has its macros, and so have, behind the last one, all.
void Definitions::leave(const RunningProgram& left) {
    run_.frames.back()->macros = left.macros;
    if (run_.frames.back()->is_definition) return;
    run_.frames[0]->macros = common_macros_ = left.macros;
    run_.variables.share_definitions(run_.variables.main_level());
}

/// By its head, else by its file.
std::string Definitions::name() const {
    if (!run_.frame->unit->name.empty()) return run_.frame->unit->name;
    return nc::program_of_path(run_.language.calls, run_.frame->unit->text->name,
                               run_.tables.notation.ignores_case);
}

/// A line that defines something, or the end of the program.
Outcome Definitions::step(Block& out) {
    const LinePosition here = run_.frame->here;
    const Outcome done = run_.step(out);
    if (done != Outcome::Block) return done;
    // Alone it ends as a program does; one that is only read on behind a mistake returns nowhere.
    const bool is_end = out.find(Function::End) != nullptr;
    if (is_end && run_.frames.size() == 1) return done;
    if (is_end || run_.frame->is_returning) return Outcome::Nothing;
    run_.lines.begin(here.line);
    CompiledLine line;
    line.program_line = {here, here};
    run_.end();
    return run_.fail(line, diag::DefinitionsOnly, {}, {name()});
}

Done Definitions::require_definition(CompiledLine& line, const nc::ControlStatement& statement) {
    if (!run_.frame->is_definition || defines(statement)) return kDone;
    run_.fail(line, diag::DefinitionsOnly, statement.span, {name()});
    return kFailed;
}

}  // namespace kadr::macro
