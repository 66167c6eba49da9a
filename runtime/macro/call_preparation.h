// call_preparation.h — what a call names and gives: its program, its passes, its
// arguments, worked out where it stands.
#pragma once

#include <functional>
#include <set>
#include <string>

#include "macro/outcome.h"
#include "macro/program_frame.h"

namespace kadr::macro {

class ProgramRun;

/// How a call names its program; the kind is empty where it leaves that open.
struct ProgramName {
    std::string name;
    std::string kind;
};

class CallPreparation {
  public:
    /// run  outlives it
    explicit CallPreparation(ProgramRun& run) : run_(run) {}

    /// Everything that a call needs.
    Outcome prepare(CompiledLine& line, const nc::ControlStatement& statement, PreparedCall& out);
    /// Arguments by letters set variables of the level that the macro gets.
    Outcome prepare_letters(CompiledLine& line, const nc::Call& call, PreparedCall& out);
    /// Arguments of a list, by their positions.
    Outcome prepare_list(CompiledLine& line, const nc::Call& call, PreparedCall& out);
    /// A number of a call; nothing: it is not given.
    Outcome number_of(CompiledLine& line, const nc::CallValue& value, std::optional<double>& out);
    /// Of lines that are only read: whether there is such a program at all.
    void check_call(CompiledLine& line, const nc::ControlStatement& statement);
    /// A line that declares the parameters of another program must declare what its head does.
    Outcome check_external(CompiledLine& line, const nc::ControlStatement& statement);

  private:
    Outcome prepare_passes(CompiledLine& line, const nc::CallValue& passes, PreparedCall& out);
    Outcome prepare_section(CompiledLine& line, const nc::ControlStatement& statement,
                            PreparedCall& out);
    Outcome find_program(CompiledLine& line, const nc::ControlStatement& statement,
                         const nc::CallForm* form, PreparedCall& out);
    Outcome program_name(CompiledLine& line, const nc::ControlStatement& statement,
                         const nc::CallForm* form, PreparedCall& out, ProgramName& name);
    Outcome missing_program(CompiledLine& line, const nc::ControlStatement& statement,
                            const std::string& name);

    ProgramRun& run_;
    std::set<std::string, std::less<>> externals_;  // programs that a line has named beforehand
};

}  // namespace kadr::macro
