// outputs.h — what a run puts out: the interface of an output, and the table of all of them.
//
// The options of the command line, what RunJob holds, the entries of the manual and the run itself
// come from the table (outputs.def): a new output is a row there and a file in outputs/.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "base/done.h"
#include "driver/execution.h"
#include "driver/options.h"
#include "driver/output.h"
#include "driver/session.h"
#include "driver/summary.h"
#include "driver/trace.h"
#include "motion/pipeline.h"
#include "motion/segment.h"
#include "motion/speed_loss.h"
#include "path/command.h"
#include "process/scanner.h"

namespace kadr::driver {

/// What an output wants of a run; what no output wants is not made.
struct Wants {
    bool commands = false;
    bool segments = false;
    bool setpoints = false;     // of a long wait only a few …
    bool every_tick = false;    // … unless somebody wants them all
    bool speed_losses = false;  // what keeps the motion below its feed
    bool scanner_lists = false;
    bool steps = false;    // what every block changes; blocks are then executed one by one
    bool calls = false;    // GeneratedText::calls_behind
    bool in_step = false;  // an alarm leaves variables and printed text as they were in front of it
};

/// One output of one run. It is shown what it wants, and nothing else.
class RunOutput {
  public:
    virtual ~RunOutput() = default;
    virtual Wants wants() const = 0;

    /// Before the program is opened. Not done: the output cannot be made, which is reported.
    virtual Done look_on(Aside&) { return kDone; }
    /// The program is open, and nothing of it was executed. Not done: its machine has not what the
    /// output shows, which is reported.
    virtual Done follow(Execution&) { return kDone; }

    virtual void see_command(const path::Command&) {}
    /// The line of the segment is that of its block (Execution::location_of).
    virtual void see_segment(const motion::Segment&) {}
    /// May be called by another thread than the rest.
    virtual void see_setpoints(std::span<const motion::Setpoint>) {}
    virtual void see_speed_loss(const motion::SpeedLoss&) {}
    virtual void see_scanner_list(const process::StartedList&) {}
    /// A block and what the state became by it; block 0 is what the program found.
    virtual void see_step(const TraceStep&, const TraceState&) {}

    /// Behind everything: writes what is known only now, and that the output is not complete if an
    /// alarm has ended the run. The figures have no tools, cycles and statements.
    virtual void finish(const RunFigures&) {}
};

/// What an output is made of; all of it outlives the output.
struct OutputParts {
    Session& session;
    const RunJob& job;
    Output& file;
};

/// A row of the table: an output, or a setting of outputs.
struct OutputRow {
    enum class Kind : std::uint8_t {
        File,             // its value is the name of a file, `-` standard output
        FileOfExpansion,  // … which `expand` has as well: only a Kadr program has it
        Word,             // its value says how it is; it goes to standard output
        Setting,          // its value is what an output asks for
    };
    std::string_view flag;   // "--commands"
    std::string_view value;  // as the help shows it: "OUT.jsonl"; words that are admitted: "on|off"
    std::string_view help;   // one line
    std::string_view manual;  // the entry of the manual page, behind its .TP
    Kind kind = Kind::File;
    int turn = 0;  // of its file, when those of a run are put in place; the least comes first
    std::unique_ptr<RunOutput> (*make)(const OutputParts& parts) = nullptr;
    /// What is wrong with the value of a setting; empty: nothing. Null: words are held against
    /// `value`.
    std::string (*fault)(const std::string& text) = nullptr;
};

/// All rows, in the order of the help.
std::span<const OutputRow> output_rows();
/// The row of a flag that there is.
const OutputRow& output_row(std::string_view flag);

/// "trunnion table"; of a machine without a title its name.
std::string machine_title(const machine::Machine& machine);
/// The control, the machine and how long it took: what a drawing has below its title.
std::string subtitle_of(const RunFigures& figures, const machine::Machine& machine);
/// What a drawing or a page says in red; empty: nothing.
std::string warning_of(const RunFigures& figures);

}  // namespace kadr::driver
