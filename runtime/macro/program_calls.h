// program_calls.h — programs that call each other: a call begins, and which programs there are.
#pragma once

#include "macro/outcome.h"
#include "macro/program_frame.h"

namespace kadr::macro {

class ProgramRun;

class Calls {
  public:
    /// run  outlives it
    explicit Calls(ProgramRun& run) : run_(run) {}

    /// A statement of calls.
    Outcome execute(CompiledLine& line, const nc::ControlStatement& statement, nc::Block& out);
    /// A section of this program by its label; with a count it is repeated instead.
    Outcome call_section(CompiledLine& line, const nc::ControlStatement& statement);
    /// Sets the call up as the program that runs next; `line` is where it is called.
    Outcome begin(CompiledLine& line, const PreparedCall& call);
    /// The program that was set up; null: none.
    RunningProgram* begun() const { return begins_.get(); }
    /// It is the program that runs.
    void perform();
    /// … if one was set up.
    void perform_begun() {
        if (begins_) perform();
    }
    /// The program that so many calls have led to; nothing: there are not as many.
    std::optional<std::string> name_at(std::int64_t level) const;
    /// Whether there is a program, or a file, with this name.
    bool find_program(std::string_view name);

  private:
    Outcome call(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome check_depth(CompiledLine& line, const PreparedCall& call, const nc::Span& span);
    Outcome declare_procedure(CompiledLine& line, const nc::ControlStatement& statement);

    ProgramRun& run_;
    std::unique_ptr<RunningProgram> begins_;  // called by the line that is executed
};

}  // namespace kadr::macro
