// program.h — a program of a control, its own parametric language included → flat blocks.
//
// Stands between the text and the interpreter: executes assignments, jumps and loops, works out
// computed words, and gives the blocks in the order in which the control executes them. A line that
// is plain words and numbers is handled by the reader and costs nothing more. Statements that ask
// for the state of the interpreter wait until it has executed what was given before.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/stream.h"
#include "macro/control_access.h"
#include "macro/line_watch.h"
#include "macro/printer.h"
#include "macro/program_files.h"
#include "nc/control_line.h"
#include "nc/reader.h"

namespace kadr::macro {

/// What the machine gives a program before it begins: assignments of the control's language, and
/// blocks that write data (`G10 L2`).
struct ProgramInputs {
    std::string name;  // of the file, for messages
    std::string text;  // with the line numbers that messages show
    bool is_given =
        false;  // each line was meant: a name that the control does not have is an error
};

/// An assignment that the machine makes while the program runs, in front of the line that begins
/// next.
struct InputEvent {
    std::string text;  // `$A_IN[3]=1`
    double time = 0;   // s, ≥ 0, from the start of the program, or of the block
    // The block, by one of these; neither: the program.
    std::uint32_t line = 0;    // its line of the text, from 1
    std::int32_t number = -1;  // N
    std::string file;          // where the event stands
    std::uint32_t file_line = 0;
};

struct ProgramOptions {
    std::uint16_t skip_levels = 0;  // bit n: blocks with skip level n are left out
    // How often a main program that begins itself again is executed; nothing: once, and a warning.
    std::optional<std::uint64_t> passes;
    std::uint64_t max_turns = 10'000'000;          // jumps back without a block between them
    std::uint64_t max_repeated = 20'000'000;       // blocks that lines give when they run again
    std::uint64_t max_blocks = 0;                  // statements and blocks; asked at statements
                                                   // alone, 0: no limit
    std::size_t kept_text = std::size_t{4} << 20;  // bytes kept of a text that cannot be read again
    std::size_t kept_lines = 1u << 12;  // before the latest batch, that messages can show
    std::function<bool()>
        is_over;  // asked now and then: whether the program has to end; may be empty
    ProgramFiles* files = nullptr;      // programs that do not stand in the text
    PrintTarget* printer = nullptr;     // null: what the program prints is lost
    std::vector<ProgramInputs> inputs;  // in the order in which they act
    std::vector<InputEvent> events;
    /// The main program is called with these arguments, `A1. B2.` or `(1, 2.5)`, as another program
    /// would.
    std::optional<std::string> call;
    nc::MachineAxisNames axis_names;  // empty: as machines call them (nc::usual_axis_names)
};

/// A variable of the control that the program has set.
struct ControlVariable {
    enum class Kind : std::uint8_t { Real, Int, Bool, Text, Vacant };
    std::string name;  // as the program writes it: `R1`, `#100`, `LIST[0,2]`
    Kind kind = Kind::Real;
    double number = 0;
    std::string text;
};

/// A variable before and behind a line that has set it; Vacant: it had, or has, no value.
struct VariableChange {
    ControlVariable before;
    ControlVariable after;  // of the same name
};

/// A program that has begun and not returned.
struct ProgramLevel {
    std::string program;     // that was called; empty: the main program
    std::string file;        // of its text; empty: the one that was started
    std::uint64_t line = 0;  // that is next; of a program that has called another one, the call
};

/// Whose a variable of the control is.
enum class VariableOwner : std::uint8_t {
    Program,  // of one level of calls: local variables, parameters
    Control,  // of all programs
    Machine,  // inputs and data that the machine gives
};

struct ActiveCode;  // code_list.h

class NcProgram final : public Stream<nc::Block>, public nc::BlockLocations {
  public:
    /// `name` is shown in messages. All references outlive the program.
    NcProgram(const nc::Dialect& dialect, nc::TextSource& text, std::string name,
              const ProgramOptions& options, DiagnosticSink& sink);
    ~NcProgram() override;

    /// From here on lines are only read, for their mistakes: nothing is worked out, no jump goes.
    void check_only();
    /// Behind the end, and behind check_only(): goes to the first part of the main program that a
    /// jump has passed over. False if there is none left.
    bool check_passed_text();
    /// Messages come later than usual: so many lines (ProgramOptions::kept_lines) are kept for
    /// them.
    void keep_lines(std::size_t lines);
    /// Who executes the blocks. Without one, asking for its state is an alarm.
    void follow(ControlAccess& state);
    /// Who gets the lines that the program prints; it outlives the run.
    void print_to(PrintTarget& printer);

    /// Who looks on, and where each variable that is set is noted from now on. Null: nobody.
    void show_to(LineWatch* watch, std::vector<VariableChange>* changes);

    std::size_t pull(std::span<nc::Block> out) override;

    TextLocation location(const nc::Block& block) const override;
    TextLocation location(const nc::Block& block, nc::Slot slot) const override;
    TextLocation location(const nc::Block& block, nc::Function function) const override;
    std::vector<TextLocation> calls(const nc::Block& block) const override;
    /// Where a line of a block (Block::line) stands: its file and its number there.
    TextLocation location(std::uint32_t line) const;
    /// The same with its text and the word that set the slot, else the first one, while the line is
    /// among the latest (ProgramOptions::kept_lines); without them for an older one.
    TextLocation shown_location(std::uint32_t line, std::optional<nc::Slot> slot) const;
    /// The calls that have led to a block with this Block::source, the nearest first. A block of a
    /// program that was called has the number of the call there, any other has none.
    std::vector<TextLocation> calls(SourceId source) const;
    /// Whether such a line is one of the text that was begun with; it then is its number.
    static bool is_in_main_text(std::uint32_t line) { return line < (std::uint32_t{1} << 31); }
    bool failed() const override;
    bool stopped() const override;
    bool calls_at_positions(const nc::Block& block) const override;
    bool is_behind_fault(const nc::Block& block) const override;
    std::uint64_t lines() const override;
    /// Whether a line could not be read, or an alarm came up, even if nobody has come to it yet.
    bool has_fault() const;

    /// In the order of the dialect's tables, then as declared.
    std::vector<ControlVariable> variables() const;
    /// The programs that have begun and not returned, the main program first.
    std::vector<ProgramLevel> levels() const;
    /// The variables of this owner as the program at `level` sees them.
    std::vector<ControlVariable> variables(std::size_t level, VariableOwner owner) const;
    /// An event of the options that has not happened so far.
    struct EventAhead {
        const InputEvent* event = nullptr;
        bool has_begun = false;  // its block has come, or it has none; its time has not
    };
    std::vector<EventAhead> events_ahead() const;
    /// The codes that act behind the lines that were read so far.
    const std::vector<ActiveCode>& codes();
    /// Statements of the control's own language that were executed so far.
    std::uint64_t statements() const;
    /// The line that is next.
    std::uint64_t line() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace kadr::macro
