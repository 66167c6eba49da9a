// program_run.h — a program while it runs: the order of its lines, and who executes which
// statement. Internal to macro.
//
// What all statements stand on is ProgramBase; each kind of them has an owner of its own, which
// asks the others through their public functions.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "macro/call_parameters.h"
#include "macro/call_preparation.h"
#include "macro/computed_words.h"
#include "macro/contour_statements.h"
#include "macro/definitions.h"
#include "macro/file_statements.h"
#include "macro/input_events.h"
#include "macro/line_compiler.h"
#include "macro/line_texts.h"
#include "macro/modal_calls.h"
#include "macro/printing.h"
#include "macro/program_base.h"
#include "macro/program_calls.h"
#include "macro/program_inputs.h"
#include "macro/program_jumps.h"
#include "macro/program_returns.h"
#include "macro/shape_calls.h"
#include "macro/skipped_text.h"
#include "macro/value_statements.h"

namespace kadr::macro {

class ProgramRun : public ProgramBase {
  public:
    ProgramRun(const nc::Dialect& dialect_, nc::TextSource& main, std::string name,
               const ProgramOptions& options_, DiagnosticSink& sink_);

    ContourStatements contours{*this};
    FileStatements file_statements{*this};
    Printing printing{*this};
    LineTexts line_texts{*this};
    ValueStatements value_statements{*this};
    Jumps jumps{*this};
    CallPreparation call_preparation{*this};
    CallParameters call_parameters{*this};
    ModalCalls modal_calls{*this};
    ShapeCalls shape_calls{*this};
    Calls calls{*this};
    Returns returns{*this};
    MachineInputs machine_inputs{*this};
    InputEvents events{*this};
    Definitions definitions{*this};
    ComputedWords computed_words{*this};
    LineCompiler line_compiler{*this};
    CompiledLine scratch;
    /// As they were where the program ended, if programs behind it are read for their mistakes.
    std::optional<std::vector<ControlVariable>> variables_at_end;

    /// The next blocks; none: the program is at its end.
    std::size_t pull(std::span<nc::Block> out);
    /// Goes to the first part of the main program that a jump has passed over; false: there is
    /// none.
    bool check_passed_text();
    /// The next line, or what comes in its place.
    Outcome step(nc::Block& out);
    /// A line, from the statement on that is next.
    Outcome run(CompiledLine& line, nc::Block& out);
    /// A statement of it.
    Outcome execute(CompiledLine& line, const nc::ControlStatement& statement, nc::Block& out);
    /// Gives the block its location, and does what follows from it.
    void deliver(nc::Block& block, std::string_view text, std::uint64_t number, bool again);
    void name_call(nc::Block& block);
    /// Whether the block is not executed for its skip level.
    bool is_left_out(const nc::Block& block) const;
    /// Under which lines are compiled.
    nc::LineContext context() const;

  private:
    bool runs_flat();
    void take_flat(std::span<nc::Block> out);
    void begin_main();
    bool take_step();
    bool is_in_cycle_mode() const {
        return lines.modes().active(nc::Group::CycleMode) == nc::Function::Cycle;
    }
    bool is_at_limit() const {
        return options.max_blocks != 0 && counts.executed + counts.blocks >= options.max_blocks;
    }
    bool show(std::string_view text);
    Outcome first_time(nc::Block& out);
    Outcome finish_first(Outcome done, std::string_view text, LinePosition next, nc::Block& out);
    CompiledLine* line_at(const LinePosition& position);
    void end_after(nc::Block& block);
    Outcome end_of_text();
    void note_passed_text();
    void advance();
    Outcome choose(CompiledLine& line, const nc::ControlStatement& statement, nc::Block& out);
    Outcome run_text(CompiledLine& line, const nc::ControlStatement& statement, nc::Block& out);
    Outcome pass_synchronous(CompiledLine& line, const nc::ControlStatement& statement);

    /// A text that is executed as a block, and how many of its statements are through.
    struct RunningText {
        std::unique_ptr<CompiledLine> line;
        std::size_t resume = 0;
    };
    std::optional<RunningText> running_text_;
    PassedText skipped_;                        // of the main program
    std::optional<std::uint64_t> skipped_end_;  // of the part of it that is read for its mistakes
    std::set<std::pair<const ProgramUnit*, std::uint64_t>>
        reported_synchronous_;  // unit, position of line
};

/// The main program is called with the arguments of the options.
Outcome begin_with_arguments(ProgramRun& run);

}  // namespace kadr::macro
