// execution.h — a source, Kadr program or ISO-7bit text, as a stream of commands.
//
// The middle of the road: read → interpret. A Kadr program is evaluated and written on the way, so
// that what is executed is what would go to the machine.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/done.h"
#include "driver/cycles.h"
#include "driver/deadline.h"
#include "driver/file_text.h"
#include "driver/generated_text.h"
#include "driver/program.h"
#include "driver/program_files.h"
#include "driver/session.h"
#include "interp/interpreter.h"
#include "macro/program.h"

namespace kadr::motion {
struct PlannerOptions;
}

namespace kadr::driver {

/// Opens a source, `-` for standard input. Null: it cannot be read, which is reported as wrong
/// usage.
std::unique_ptr<FileText> open_source(Session& session, const std::string& source);

/// Whether a source is a Kadr program: by its name, standard input by its looks.
bool is_kadr_source(const std::string& source, const FileText& text);

/// Takes a Kadr program among the sources of the session.
FileId keep_source(Session& session, const std::string& source, FileText& text);

/// A call of a checked program that is executed by itself, as a test does.
struct Subject {
    const KadrProgram& program;
    const nc::Dialect& dialect;
    Entry entry;
    LibraryCycles& cycles;  // those of the dialect
    DiagnosticSink& sink;   // for all that is reported on the way
    std::string* text;      // gets the ISO-7bit text
};

/// What goes on beside an execution.
struct Aside {
    Output* map = nullptr;                          // gets the source map of a Kadr program
    std::function<void(std::string_view)> tap;      // gets text that is made, or comes by only once
    bool keeps_calls = false;                       // GeneratedText::calls_behind is asked
    std::function<void(const nc::Block&)> look_at;  // is shown every block that is read
    macro::LineWatch* watch = nullptr;  // is shown every line; then blocks are executed one by one
    /// Is shown every statement of a Kadr program, in step with the blocks.
    expand::StatementWatch* statements = nullptr;
    /// No line of the control's language is executed before the blocks in front of it: what an
    /// alarm leaves in variables and in printed text came before it.
    bool in_step = false;
    std::vector<macro::VariableChange>* changes = nullptr;  // gets the variables that are set
    std::vector<interp::ProbeTouch> touches;                // where the probe triggers
    std::vector<macro::InputEvent> input_events;  // values that the machine gives meanwhile
};

class Execution final : public Stream<path::Command> {
  public:
    /// Loads dialect and machine, checks a Kadr program. Null: reported, the status of the session
    /// tells what it was. What `aside` names outlives the execution.
    static std::unique_ptr<Execution> open(Session& session, const std::string& source,
                                           std::unique_ptr<FileText> text, const Aside& aside = {});
    /// The same for a program among the sources of the session. `tap` sees the text that is
    /// executed.
    static std::unique_ptr<Execution> open(Session& session, FileId program,
                                           GeneratedText::Tap tap);
    /// The same for a part of a program that is checked already; what it refers to outlives the
    /// execution. Null: the sink has got the reason.
    static std::unique_ptr<Execution> open(Session& session, const Subject& subject);
    /// The same for the text of a checked program that somebody else has started; what they refer
    /// to outlives the execution. `sink` gets all that the execution reports. Null: reported.
    static std::unique_ptr<Execution> open(Session& session, const KadrProgram& program,
                                           const nc::Dialect& dialect,
                                           std::unique_ptr<GeneratedText> text,
                                           DiagnosticSink& sink);
    ~Execution() override;

    std::size_t pull(std::span<path::Command> out) override;
    /// Reads the text to its end without executing it, for the sake of its mistakes.
    void read_rest();
    /// Makes the text of a Kadr program to its end, whatever has stopped its execution.
    void make_rest();
    /// Makes so much of it as would have been made if nobody had looked on.
    void finish_text();
    /// Who gets the lines that a program of the control prints.
    void print_to(macro::PrintTarget& printer) { reader_->print_to(printer); }

    bool alarmed() const { return is_late_ || interpreter_->alarmed(); }
    /// Whether the command has computed for longer than it may. Any thread may ask.
    bool is_time_over() const { return deadline_.is_over(); }
    /// Reports it where nobody has: what was left of the motion when the time was over is lost.
    void end_in_time() {
        if (!is_late_) check_time();
    }
    /// Evaluating, writing or reading came to an error.
    bool failed() const;
    std::uint64_t blocks() const { return interpreter_->blocks(); }

    /// The checked program; null for ISO-7bit text.
    const KadrProgram* program() const { return program_; }
    /// The generated text; null for ISO-7bit text.
    const GeneratedText* generated() const { return generated_.get(); }
    /// The modal state and the position behind what was pulled so far.
    const interp::Interpreter& interpreter() const { return *interpreter_; }

    /// The control's program, of which an onlooker asks what acts.
    macro::NcProgram& reader() { return *reader_; }
    const macro::NcProgram& reader() const { return *reader_; }
    /// Variables of the control that the program has set.
    std::vector<macro::ControlVariable> variables() const { return reader_->variables(); }

    const nc::Dialect& dialect() const { return *dialect_; }
    const machine::Machine& machine() const { return *machine_; }
    /// The name of the ISO-7bit text: of the file, or of the one that would be written.
    const std::string& text_name() const { return text_name_; }
    /// The statement behind a command, invalid for ISO-7bit text.
    SourceRange statement(SourceId source) const;
    /// A line (Command::line) as its file and its number there.
    TextLocation location_of(std::uint32_t line) const;
    /// Lets messages of the motion show the lines that they are about and the calls that led to
    /// them. Before the first command is pulled.
    void place_messages(motion::PlannerOptions& options);
    /// Where messages about the text go: it adds the statement of the Kadr program.
    DiagnosticSink& sink();
    /// Lines of the text that a statement of the Kadr program made, so far.
    std::uint64_t statement_lines() const;

  private:
    class HeldMessages;
    class Tagger;
    class StatementNotes;
    explicit Execution(Session& session);

    Done open_inputs();
    Done open_text(const std::string& source, std::unique_ptr<FileText> text);
    Done open_program(FileId file, GeneratedText::Tap tap = {});
    void connect_with_library();
    void connect(DiagnosticSink& sink);
    /// Reports it if the time is over, and is late from then on.
    void check_time();
    void read_on(bool is_reached);
    TextLocation shown_location(std::uint32_t line, std::optional<Axis> axis) const;

    Session& session_;
    Aside aside_;
    std::string text_name_;
    const nc::Dialect* dialect_ = nullptr;
    const machine::Machine* machine_ = nullptr;
    std::optional<KadrProgram> own_program_;
    const KadrProgram* program_ = nullptr;  // null: ISO-7bit text
    std::unique_ptr<GeneratedText> generated_;
    std::unique_ptr<FileText> file_;
    std::unique_ptr<ProgramFolders> called_;  // programs that the text calls
    std::vector<macro::ProgramInputs> inputs_;
    std::unique_ptr<StatementNotes> sink_;
    std::unique_ptr<HeldMessages> held_;
    std::unique_ptr<macro::NcProgram> reader_;
    std::unique_ptr<Stream<nc::Block>> tagged_;
    std::unique_ptr<LibraryCycles> own_cycles_;
    LibraryCycles* cycles_ = nullptr;
    std::unique_ptr<interp::Interpreter> interpreter_;
    bool has_stopped_ = false;  // by an alarm of the interpreter's own
    Deadline deadline_;
    bool is_late_ = false;
    std::uint32_t last_line_ = 0;  // of the text, that was executed
};

}  // namespace kadr::driver
