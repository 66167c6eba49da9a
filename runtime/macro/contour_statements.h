// contour_statements.h — statements that read a contour into a table of the program, and
// move along a row of one.
#pragma once

#include "macro/outcome.h"
#include "macro/program_frame.h"

namespace kadr::macro {

class ProgramBase;

class ContourStatements {
  public:
    /// run  outlives it
    explicit ContourStatements(ProgramBase& run) : run_(run) {}

    /// A statement of a contour; `out` is the block of a row.
    Outcome execute(CompiledLine& line, const nc::ControlStatement& statement, nc::Block& out);
    /// Whether a contour is open whose variables belong to a program deeper than this: they are
    /// gone.
    bool is_left_open(std::size_t depth) const { return open_ && depth < open_->depth; }

  private:
    /// A contour that is being read, and what takes it.
    struct OpenContour {
        ControlVariables::VariableRef table;
        ControlVariables::VariableRef undercuts;
        ContourCut cut;
        bool is_coded = false;
        std::size_t depth = 0;  // of the program that has begun it, whose variables they are
    };
    Outcome begin(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome end(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome run_row(CompiledLine& line, const nc::ControlStatement& statement, nc::Block& out);

    ProgramBase& run_;
    std::optional<OpenContour> open_;
};

}  // namespace kadr::macro
