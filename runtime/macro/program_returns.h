// program_returns.h — returns: to the caller, to the next pass, to the head of the main program.
#pragma once

#include "macro/outcome.h"
#include "macro/program_frame.h"

namespace kadr::macro {

class ProgramRun;

class Returns {
  public:
    /// run  outlives it
    explicit Returns(ProgramRun& run) : run_(run) {}

    /// A return.
    Outcome leave(CompiledLine& line, const nc::ControlStatement& statement, nc::Block& out);
    /// A return inside of a section that is repeated ends only that. False: there is none.
    bool cancel_repeat();
    /// The program that runs is through: once more, or back to where it was called.
    Outcome finish(nc::Block& out);

  private:
    Outcome return_in_main(CompiledLine& line, const nc::ControlStatement& statement,
                           const std::optional<LineTarget>& target, nc::Block& out);
    void restart(RunningProgram& again);

    ProgramRun& run_;
    std::uint64_t passes_done_ = 0;  // of the main program
};

}  // namespace kadr::macro
