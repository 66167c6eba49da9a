// printing.h — what a program prints.
#pragma once

#include "macro/outcome.h"
#include "macro/program_frame.h"

namespace kadr::macro {

class ProgramBase;

class Printing {
  public:
    /// run  outlives it
    explicit Printing(ProgramBase& run) : run_(run) {}

    /// A statement that prints, or opens or closes the printer.
    Outcome execute(CompiledLine& line, const nc::ControlStatement& statement);

  private:
    ProgramBase& run_;
    bool is_open_ = false;
};

}  // namespace kadr::macro
