// definitions.cpp — variables and macros that all programs have. They are said in programs of their
// own, SINUMERIK's SGUD, MGUD, UGUD and SMAC, MMAC, UMAC, which are read before the main program
// runs.

#include <algorithm>

#include "base/diagnostics/control.h"
#include "macro/program_state.h"

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
void Program::State::begin_definitions() {
    const std::vector<std::string>& names = language.calls.definitions;
    // One that is looked at by itself, `kadr check UGUD.DEF`, is the program that runs.
    const std::string own =
        nc::program_of_path(language.calls, units.main().text->name, tables.notation.ignores_case);
    const bool is_own = std::ranges::find(names, own) != names.end();
    if (is_own) {
        frames[0]->is_definition = true;
        frames[0]->level = &variables.definitions();
    }
    for (auto name = names.rbegin(); name != names.rend(); ++name) {
        if (is_own && *name == own) continue;
        ProgramUnit* const unit = units.find_definitions(*name);
        if (unit == nullptr) continue;
        auto open = std::make_unique<Frame>();
        open->unit = unit;
        open->text.name = unit->text->name;
        open->text.program = unit->name;
        open->level = &variables.definitions();
        open->here = unit->begin;
        open->is_definition = true;
        frames.push_back(std::move(open));
    }
    if (frames.size() > 1) resume_frame(*frames.back());
}

/// The next program has its macros, and so have, behind the last one, all.
void Program::State::leave_definition(const Frame& left) {
    frames.back()->macros = left.macros;
    if (frames.back()->is_definition) return;
    frames[0]->macros = shared_macros = left.macros;
    variables.share_definitions(variables.main_level());
}

/// By its head, else by its file.
std::string Program::State::name_of_definitions() const {
    if (!frame->unit->name.empty()) return frame->unit->name;
    return nc::program_of_path(language.calls, frame->unit->text->name,
                               tables.notation.ignores_case);
}

/// A line that defines something, or the end of the program.
Program::State::Outcome Program::State::step_in_definition(Block& out) {
    const LinePosition here = frame->here;
    const Outcome done = step(out);
    if (done != Outcome::Block) return done;
    // Alone it ends as a program does; one that is only read on behind a mistake returns nowhere.
    const bool is_end = out.find(Function::End) != nullptr;
    if (is_end && frames.size() == 1) return done;
    if (is_end || frame->is_returning) return Outcome::Nothing;
    lines.begin(here.line);
    CompiledLine line;
    line.place = {here, here};
    has_ended = true;
    return fail(line, diag::DefinitionsOnly, {}, {name_of_definitions()});
}

Done Program::State::require_definition(CompiledLine& line, const nc::ControlStatement& statement) {
    if (!frame->is_definition || defines(statement)) return kDone;
    fail(line, diag::DefinitionsOnly, statement.span, {name_of_definitions()});
    return kFailed;
}

}  // namespace kadr::macro
