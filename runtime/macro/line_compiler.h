// line_compiler.h — lines of the control's own language, compiled once.
#pragma once

#include <set>
#include <string>

#include "macro/program_frame.h"

namespace kadr::macro {

class ProgramRun;

class LineCompiler {
  public:
    /// run  outlives it
    explicit LineCompiler(ProgramRun& run) : run_(run) {}

    /// What kind of line it is; one that cannot be read stays New.
    void compile(CompiledLine& line, nc::Block& out);
    /// … of the control's own language.
    void compile_language(CompiledLine& line);

  private:
    void note_lost_names(const CompiledLine& line);
    bool is_lost(const CompiledLine& line, const nc::LineFault& fault) const;

    ProgramRun& run_;
    std::set<std::string> lost_names_;  // of declarations that could not be read
};

}  // namespace kadr::macro
