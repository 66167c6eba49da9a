// program_base.h — what every statement of a program stands on: the control's tables, the reader of
// lines, the variables, the programs that have not returned, and reports of faults. Internal to
// macro.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/done.h"
#include "macro/code_list.h"
#include "macro/control_variables.h"
#include "macro/evaluator.h"
#include "macro/listening_sink.h"
#include "macro/noted_writes.h"
#include "macro/outcome.h"
#include "macro/program.h"
#include "macro/program_frame.h"
#include "macro/program_units.h"
#include "macro/recent_calls.h"
#include "nc/kept_lines.h"
#include "nc/line_reader.h"

namespace kadr::macro {

/// How much was done, for limits and for who asks.
struct RunCounts {
    std::size_t given = 0;       // blocks of this batch
    std::uint64_t turns = 0;     // jumps back since the last block
    std::uint64_t repeated = 0;  // blocks of lines that ran again
    std::uint64_t most_line = 0;
    std::uint32_t steps = 0;
    std::uint64_t executed = 0;  // statements
    std::uint64_t blocks = 0;    // that were given to be executed
};

/// How far the run is.
struct RunPhase {
    bool has_begun = false;
    bool is_waiting = false;        // a line is to be run again
    bool is_only_checking = false;  // the program has ended; lines behind are read for mistakes
    bool has_ended = false;
    bool has_visible_fault = false;  // that blocks of this batch stand behind
    bool was_stopped = false;        // by who looks on, or because its time is over
};

class ProgramBase {
  public:
    ProgramBase(const nc::Dialect& dialect_, nc::TextSource& main, std::string name,
                const ProgramOptions& options_, DiagnosticSink& sink_);
    ProgramBase(const ProgramBase&) = delete;
    ProgramBase& operator=(const ProgramBase&) = delete;

    const nc::Dialect& dialect;
    const nc::DialectTables& tables;
    const nc::Language& language;
    ProgramOptions options;
    ListeningSink ear;
    DiagnosticSink& sink;
    nc::LineReader lines;
    nc::KeptLines kept;
    RecentCalls recent_calls;
    ProgramUnits units;
    ControlVariables variables;
    Evaluator evaluator;
    CodeList codes;
    NotedWrites writes;
    LineWatch* watch = nullptr;
    ControlAccess* interpreter = nullptr;
    std::vector<std::unique_ptr<RunningProgram>> frames;  // the main program first
    RunningProgram* frame = nullptr;                      // that runs
    RunCounts counts;
    RunPhase phase;

    // Where the program stands that runs.
    ProgramText& text() { return *frame->unit->text; }
    nc::LineSource& source() { return frame->unit->text->source; }
    ProgramMap& map() { return frame->unit->map; }
    LinePosition& frontier() { return frame->unit->frontier; }

    /// What follows is executed in this program, with its variables.
    void resume_frame(RunningProgram& next);
    /// A program that was called, or comes in front of those there are.
    void add_frame(std::unique_ptr<RunningProgram> added) { frames.push_back(std::move(added)); }
    /// The one that was called last.
    std::unique_ptr<RunningProgram> take_frame();
    /// All but the main program are left.
    void keep_main_frame() { frames.resize(1); }
    /// Behind text that there is not: the program ends here if the one who looks on wanted it to
    /// while more was being made. False: nobody did.
    bool end_for_watch();
    /// The program ends here.
    void end() { phase.has_ended = true; }
    /// A jump back, or a call.
    void note_turn() { ++counts.turns; }
    /// … and whether there may be so many without a block between them.
    Done count_turn() {
        note_turn();
        return Done(counts.turns <= options.max_turns);
    }

    /// Of a declaration: behind a mistake in any line names are declared, and their values are not
    /// worked out.
    bool is_sound(Outcome done) const { return goes_on(done) && !lines.faults().failed(); }
    /// decimals  as Evaluator::run has them
    Outcome evaluate(CompiledLine& line, const nc::Expression& expression, ControlValue& out,
                     int decimals = -1);
    /// The value of a condition.
    Outcome truth(CompiledLine& line, const nc::Expression& expression, bool& out);
    /// Sets a variable.
    Outcome store(CompiledLine& line, const nc::Reference& reference, const ControlValue& value);
    /// Reports what is wrong with the line; always Failed.
    Outcome fail(CompiledLine& line, const nc::LineFault& fault);
    Outcome fail(CompiledLine& line, const DiagnosticRow& row, const nc::Span& span,
                 std::vector<std::string> arguments = {}) {
        return fail(line, nc::LineFault{&row, span, std::move(arguments)});
    }
    Outcome fail(CompiledLine& line, ProgramMap::Fault fault, const DiagnosticRow& missing,
                 const nc::Span& span, const std::string& what);

    /// Tells who looks on that the line, of the program that runs, leads to one of the program
    /// `to`.
    void show_way(WayTaken::Kind kind, const LinePosition& line, const ProgramUnit& to,
                  const LinePosition& target);

  private:
    void warn_of_radians(const CompiledLine& line);
    void report_missing(const CompiledLine& line);

    /// Values of the machine that nobody has given and that the line reads.
    struct MissingInput {
        std::string name;
        std::string meaning;
        nc::Span span;
    };
    std::vector<MissingInput> missing_inputs_;
    bool reported_radians_ = false;  // that an angle is one in radians
};

}  // namespace kadr::macro
