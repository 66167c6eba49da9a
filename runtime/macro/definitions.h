// definitions.h — variables and macros that all programs have.
#pragma once

#include "base/done.h"
#include "macro/outcome.h"
#include "macro/program_frame.h"

namespace kadr::macro {

class ProgramRun;

class Definitions {
  public:
    /// run  outlives it
    explicit Definitions(ProgramRun& run) : run_(run) {}

    /// Their programs come in front of the main program.
    void begin();
    /// A line that defines something, or the end of the program.
    Outcome step(nc::Block& out);
    /// The next program has its macros, and so have, behind the last one, all.
    void leave(const RunningProgram& left);
    /// Nothing else stands in such a program.
    Done require_definition(CompiledLine& line, const nc::ControlStatement& statement);
    /// Of all programs.
    const TextMacros& common_macros() const { return common_macros_; }

  private:
    std::string name() const;

    ProgramRun& run_;
    TextMacros common_macros_;
};

}  // namespace kadr::macro
