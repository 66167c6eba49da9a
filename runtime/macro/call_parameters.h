// call_parameters.h — parameters of a program that is called: copies, and variables of the
// caller.
#pragma once

#include "macro/outcome.h"
#include "macro/program_frame.h"

namespace kadr::macro {

class ProgramBase;

class CallParameters {
  public:
    /// run  outlives it
    explicit CallParameters(ProgramBase& run) : run_(run) {}

    /// Gives the parameters of the callee their values.
    Outcome bind(CompiledLine& line, const PreparedCall& call, RunningProgram& callee);
    /// … for the first time; its variables of the caller are noted in it if somebody looks on.
    Outcome bind_noted(CompiledLine& line, const PreparedCall& call, RunningProgram& callee);
    /// What a program that was left has written into variables of its caller.
    void note_returned(const RunningProgram& left);

  private:
    Outcome bind_parameter(CompiledLine& line, const PreparedCall& call, std::size_t index);
    Outcome bind_reference(CompiledLine& line, const nc::ProcedureParameter& parameter,
                           const GivenValue& given, nc::ControlSymbol symbol);
    void note_reference(const nc::ControlSymbol& symbol,
                        const ControlVariables::VariableRef& variable);

    ProgramBase& run_;
    std::vector<ReturnedVariable> references_;  // of the call that is prepared
};

}  // namespace kadr::macro
