// program_inputs.h — what the machine gives a program before it begins.
#pragma once

#include <functional>
#include <set>
#include <string>

#include "macro/outcome.h"
#include "macro/program_frame.h"

namespace kadr::macro {

class ProgramRun;

class MachineInputs {
  public:
    /// run  outlives it
    explicit MachineInputs(ProgramRun& run) : run_(run) {}

    /// They come in front of the main program.
    void begin();
    /// The next line of them.
    Outcome step(nc::Block& out);
    /// One line: assignments, or a block that writes data.
    Outcome run(CompiledLine& line, nc::Block& out);
    /// What was heard of a line that is wrong.
    ///
    /// is_given  it was meant: a name that the control does not have is an error
    void report_wrong(const std::string& text, const std::vector<Diagnostic>& heard, bool is_given);
    /// Behind the last one the program begins, unless something was wrong.
    void leave();

  private:
    ProgramRun& run_;
    std::set<std::string, std::less<>> passed_;  // names that the control does not have
    bool has_wrong_ = false;
    std::vector<VariableChange>* onlooker_changes_ = nullptr;  // what the machine sets is no change
};

}  // namespace kadr::macro
