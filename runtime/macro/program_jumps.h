// program_jumps.h — where a program goes on: jumps, structures, sections that are repeated.
#pragma once

#include <set>
#include <utility>

#include "base/result.h"
#include "macro/outcome.h"
#include "macro/program_frame.h"

namespace kadr::macro {

class ProgramBase;

class Jumps {
  public:
    /// run  outlives it
    explicit Jumps(ProgramBase& run) : run_(run) {}

    /// Which line a target means, or what this line comes to where that is not known.
    Result<std::int64_t, Outcome> count_of(CompiledLine& line,
                                           const nc::ControlStatement& statement);
    Result<LineTarget, Outcome> resolve(CompiledLine& line, const nc::JumpTarget& target);
    /// A jump.
    Outcome jump(CompiledLine& line, const nc::ControlStatement& statement);
    /// The jump of the first case whose value it is.
    Outcome choose_case(CompiledLine& line, const nc::ControlStatement& statement);
    /// Goes on at this line.
    Outcome go(CompiledLine& line, const ProgramLine& target, const nc::Span& span);
    /// A jump leaves structures and sections that the target does not stand in.
    void leave_open(const LinePosition& target);
    /// The head of a structure.
    Outcome enter(CompiledLine& line, const nc::ControlStatement& statement);
    /// The end of a structure, or of one pass.
    Outcome leave(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome end_pass(CompiledLine& line, const nc::ControlStatement& statement);
    /// The other part of a condition begins: the one before is through.
    Outcome otherwise(CompiledLine& line, const nc::ControlStatement& statement);
    /// A section of the program comes once more, or so often.
    Outcome repeat_section(CompiledLine& line, const nc::ControlStatement& statement);
    /// Of lines that are only read: whether the targets stand in the program.
    void check(CompiledLine& line, const std::vector<nc::ControlStatement>& statements);

  private:
    Outcome find_target(CompiledLine& line, const nc::ControlStatement& statement,
                        LineTarget& target, std::optional<ProgramLine>& found);
    void warn_of_twin(const CompiledLine& line, const nc::Span& span, const LineTarget& target,
                      const ProgramLine& found);
    Outcome fail_at_end(CompiledLine& line, const nc::ControlStatement& statement,
                        ProgramMap::Fault fault, const ProgramMap::Crossing& crossing);
    Outcome pass_end(const CompiledLine& line, const nc::ControlStatement& statement);
    Outcome count_on(CompiledLine& line, OpenStructure& loop, bool& goes_on_looping);

    ProgramBase& run_;
    std::set<std::pair<const ProgramUnit*, std::uint64_t>> reported_ends_;  // unit, line's position
    std::set<std::pair<const ProgramUnit*, LineTarget>> reported_twins_;
};

}  // namespace kadr::macro
