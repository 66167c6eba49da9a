// program_state.h — a program while it runs: calls that have not returned, and where each stands.
// Internal to macro.
//
// Told in chapters: program.cpp (the order of lines, statements, jumps, structures),
// program_calls.cpp (calls, modal calls, returns), program_places.cpp (modal calls at the places of
// a pattern), and definitions.cpp (what all programs have).
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/done.h"
#include "base/result.h"
#include "macro/code_list.h"
#include "macro/control_files.h"
#include "macro/control_variables.h"
#include "macro/evaluator.h"
#include "macro/program.h"
#include "macro/program_units.h"
#include "macro/recent_calls.h"
#include "macro/skipped_text.h"
#include "macro/text_macros.h"
#include "nc/kept_lines.h"
#include "nc/line_reader.h"

namespace kadr::macro {

/// A structure that was entered and not left yet.
struct OpenStructure {
    nc::Statement kind = nc::Statement::None;
    int loop = 0;
    Place head;
    Place end;
    std::optional<Place> otherwise;
    double last = 0;                          // For
    std::unique_ptr<nc::ControlLine> counts;  // … its head
};

/// Where the values of a list go.
struct ListPlace {
    nc::Instruction load;     // Element, Global
    std::string name;         // for messages
    std::uint32_t first = 0;  // slot of the first one
    std::uint32_t left = 0;   // so many there are from it on
};

/// A section that is being repeated.
struct OpenRepeat {
    LinePosition begin;
    LinePosition end;     // reached: the section is through
    LinePosition behind;  // where the program goes on in the end
    std::int64_t left = 0;
    bool is_shape = false;  // of a cycle, whose blocks they are
};

/// An argument that was worked out where the call stands.
struct GivenValue {
    bool is_given = false;
    Value value;
    std::string text;                       // of a text
    control::ControlFrame frame;            // of a frame
    ControlVariables::VariablePlace place;  // of a variable alone
    bool is_array = false;
    nc::Span span;
};

/// How a call names its program; the kind is empty where it leaves that open.
struct ProgramName {
    std::string name;
    std::string kind;
};

/// A call with everything that it needs to begin, as often as it is to.
struct PreparedCall {
    ProgramUnit* unit = nullptr;
    const nc::CallForm* form = nullptr;  // null: a statement without a code
    std::int64_t passes = 1;
    std::int64_t start = -1;            // number of the block where it begins
    std::vector<GivenValue> arguments;  // by their places
    std::shared_ptr<Level> level;       // of a macro: arguments are set once
    std::optional<Place> from;          // of a section
    std::optional<LinePosition> to;
    std::shared_ptr<const nc::CallSite> site;
    bool is_modal = false;
    bool is_shape = false;  // its blocks are those of the shape along which a cycle works
    bool is_macro() const { return form != nullptr && form->kind == nc::CallForm::Kind::Macro; }
};

/// A variable of the caller for which a parameter stands.
struct ReturnedVariable {
    ControlVariables::VariablePlace place;
    ControlVariable before;  // the call
};

/// A modal call that is made at the places of a pattern.
struct CallsAtPlaces {
    PreparedCall call;
    std::uint32_t line = 0;    // Block::line of the pattern
    std::uint64_t number = 0;  // … in its text
    nc::ModalFunctions modal_before{};
    bool has_called = false;  // at the place where the tool stands
};

/// A program that runs: the main program, or one that was called.
struct Frame {
    ProgramUnit* unit = nullptr;
    nc::TextState text;
    Level* level = nullptr;
    std::shared_ptr<Level> own_level;   // null: the caller's
    LinePosition here;                  // of the line that is next
    LinePosition goes_on;               // behind the line that is executed
    CompiledLine* next_line = nullptr;  // if the next line is kept
    std::vector<OpenStructure> structures;
    std::vector<OpenRepeat> repeats;
    std::size_t resume = 0;        // statements of the line that are executed already
    bool has_executed = false;     // something besides declarations
    bool has_given_words = false;  // of the line: its call is next
    std::shared_ptr<const nc::CallSite> site;
    SourceId site_number;   // of the site among the recent ones
    PreparedCall call;      // that has begun it
    std::int64_t left = 1;  // passes, this one included
    bool saves = false;
    nc::ModalFunctions modal_before{};
    bool is_definition = false;  // it says what all programs have, and moves nothing
    bool is_called = false;      // the main program has arguments, and returns where it ends
    const ProgramInputs* inputs = nullptr;  // it is what the machine tells before the program
    bool is_in_code_call = false;           // codes that call programs mean what they are here
    bool is_external = false;
    TextMacros macros;
    std::optional<CallsAtPlaces> at_places;     // while the tool goes from place to place
    std::vector<ReturnedVariable> references;   // noted if somebody looks on
    std::size_t modal_limit = ~std::size_t{0};  // modal calls below this one act here
    // How it ends.
    bool is_returning = false;
    bool leaves_all_passes = false;
    int levels = 1;                   // that are left
    std::optional<Place> returns_to;  // in the program that goes on
};

/// Messages go on, or are kept while somebody listens who makes something of them.
class ListeningSink final : public DiagnosticSink {
  public:
    explicit ListeningSink(DiagnosticSink& next) : next_(next) {}
    void take(Diagnostic diagnostic) override {
        (heard_ == nullptr ? next_ : *heard_).take(std::move(diagnostic));
    }
    /// Null: they go on.
    void listen(DiagnosticSink* heard) { heard_ = heard; }
    bool is_listened_to() const { return heard_ != nullptr; }

  private:
    DiagnosticSink& next_;
    DiagnosticSink* heard_ = nullptr;
};

struct Program::State {
    State(const nc::Dialect& dialect_, nc::TextSource& text, std::string name,
          const ProgramOptions& options_, DiagnosticSink& sink_);

    /// What a line has come to.
    enum class Outcome : std::uint8_t {
        Block,    // `out` holds one
        Nothing,  // go on
        Failed,   // and the reason has been told
        Wait,     // the line is run again when the blocks before are executed
    };

    /// Whether the line goes on behind a part of it that has come to this.
    static bool goes_on(Outcome done) { return done == Outcome::Block || done == Outcome::Nothing; }
    /// … of a declaration: behind a mistake in any line names are declared, and their values are
    /// not worked out.
    bool is_sound(Outcome done) const { return goes_on(done) && !lines.failed(); }

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
    /// As they were where the program ended, if programs behind it are read for their mistakes.
    std::optional<std::vector<ControlVariable>> variables_at_end;
    Evaluator evaluator;
    CodeList codes;
    LineWatch* watch = nullptr;
    ControlAccess* interpreter = nullptr;

    std::vector<std::unique_ptr<Frame>> frames;    // the main program first
    Frame* frame = nullptr;                        // that runs
    TextMacros shared_macros;                      // of the definitions
    std::unique_ptr<Frame> begins;                 // called by the line that is executed
    std::optional<PreparedCall> due;               // behind the block that was given last
    std::set<std::string, std::less<>> externals;  // programs that a line has named beforehand
    std::vector<std::shared_ptr<PreparedCall>> modal_calls;
    /// A cycle that is called behind motions and names the program of its shape.
    struct ModalShape {
        nc::Block block;
        std::string text;
        Place place;
    };
    std::optional<ModalShape> modal_shape;
    /// Of the cycles that name none: parts of a text, and which they are.
    struct NamedContour {
        std::vector<std::string> parts;
        std::int64_t kind = 0;
    };
    std::optional<NamedContour> named_contour;
    bool moves_alone = false;                   // an axis of the block, beside the path
    std::vector<ControlVariable> written_data;  // that the last block may write, before it
    struct WrittenOffset {
        bool is_of_tool = false;
        std::int64_t number = 0;
    };
    WrittenOffset data_written;  // … and whose they are
    /// A contour that is being read, and what takes it.
    struct OpenContour {
        ControlVariables::VariablePlace table;
        ControlVariables::VariablePlace undercuts;
        ContourCut cut;
        bool is_coded = false;
        std::size_t depth = 0;  // of the program that has begun it, whose variables they are
    };
    std::optional<OpenContour> open_contour;
    ControlFiles control_files;
    bool keeps_modal_calls = false;  // the block that begins one ends those of cycles
    CompiledLine scratch;
    /// A text that is executed as a block, and how many of its statements are through.
    struct RunningText {
        std::unique_ptr<CompiledLine> line;
        std::size_t resume = 0;
    };
    std::optional<RunningText> running_text;
    std::map<std::string, std::int64_t> variable_names;  // that the program has given
    std::string named_text;     // of the line that is read, with their numbers
    std::string expanded_text;  // of the line that is read, if it has words that stand for text
    std::vector<nc::WordValue> values;
    std::vector<ReturnedVariable> references;  // of the call that is prepared
    std::size_t given = 0;                     // blocks of this batch
    std::uint64_t turns = 0;                   // jumps back since the last block
    std::uint64_t passes_done = 0;             // of the main program
    std::uint64_t repeated = 0;                // blocks of lines that ran again
    std::uint64_t most_line = 0;
    bool is_waiting = false;        // the line in `scratch` is to be run again
    bool is_only_checking = false;  // the program has ended; lines behind are read for mistakes
    /// Values of the machine that nobody has given and that the line reads.
    struct MissingInput {
        std::string name;
        std::string meaning;
        nc::Span span;
    };
    std::vector<MissingInput> missing_inputs;
    /// An event and when its block began, s; nothing: not yet.
    struct PendingEvent {
        const InputEvent* event;
        std::optional<double> begun;
    };
    std::vector<PendingEvent> pending_events;
    bool waits_for_block = false;  // one of them does
    struct EventBlock {
        std::int64_t number = -1;  // N
        std::uint64_t line = 0;    // of the main text; 0: of another one
    };
    EventBlock event_block;                            // that is next
    bool is_acting = false;                            // an event is executed
    std::set<std::string, std::less<>> passed_inputs;  // names that the control does not have
    bool has_wrong_inputs = false;
    std::vector<VariableChange>* onlooker_changes = nullptr;  // what the machine sets is no change
    bool has_begun = false;
    bool has_ended = false;
    bool is_printer_open = false;
    SkippedText skipped;                       // of the main program
    std::optional<std::uint64_t> skipped_end;  // of the part of it that is read for its mistakes
    std::set<std::pair<const ProgramUnit*, std::uint64_t>> said_synchronous;  // unit, place of line
    std::set<std::pair<const ProgramUnit*, std::uint64_t>> said_ends;         // likewise
    std::set<std::pair<const ProgramUnit*, LineTarget>> said_twice;
    std::set<std::string> lost_names;  // of declarations that could not be read
    bool said_separate = false;        // that axes move each by itself
    bool said_radians = false;         // … and that an angle is one in radians
    bool has_visible_fault = false;    // that blocks of this batch stand behind
    bool was_stopped = false;          // by who looks on, or because its time is over
    std::uint32_t steps = 0;
    std::uint64_t executed = 0;  // statements
    std::uint64_t blocks = 0;    // that were given to be executed

    ProgramText& text() { return *frame->unit->text; }
    nc::LineSource& source() { return frame->unit->text->source; }
    ProgramMap& map() { return frame->unit->map; }
    LinePosition& frontier() { return frame->unit->frontier; }

    // lines
    std::size_t pull(std::span<nc::Block> out);
    Outcome step(nc::Block& out);
    bool runs_flat();
    void take_flat(std::span<nc::Block> out);
    void begin_main();
    void begin_definitions();
    void leave_definition(const Frame& left);
    std::string name_of_definitions() const;
    Outcome step_in_definition(nc::Block& out);
    // program_inputs.cpp
    void begin_inputs();
    Outcome step_in_input(nc::Block& out);
    Outcome run_input(CompiledLine& line, nc::Block& out);
    void tell_wrong_input(const std::string& text, const std::vector<Diagnostic>& heard,
                          bool is_said);
    void leave_inputs();
    void tell_missing(const CompiledLine& line);
    bool comes_to_event();
    bool is_here(const PendingEvent& event) const;
    void begin_event_block();
    void act_events();
    void act_event(const InputEvent& event);
    Outcome begin_with_arguments();
    Outcome prepare_arguments(CompiledLine& line);
    Done require_definition(CompiledLine& line, const nc::ControlStatement& statement);
    bool take_step();
    bool is_in_cycle_mode() const {
        return lines.modal()[static_cast<std::size_t>(nc::Group::CycleMode)] == nc::Function::Cycle;
    }
    bool is_at_limit() const {
        return options.max_blocks != 0 && executed + blocks >= options.max_blocks;
    }
    bool show(std::string_view text);
    Outcome first_time(nc::Block& out);
    Outcome finish_first(Outcome done, std::string_view text, LinePosition next, nc::Block& out);
    Outcome run(CompiledLine& line, nc::Block& out);
    CompiledLine* line_at(const LinePosition& position);
    void compile(CompiledLine& line, nc::Block& out);
    void compile_language(CompiledLine& line);
    void note_lost_names(const CompiledLine& line);
    bool is_lost(const CompiledLine& line, const nc::LineFault& fault) const;
    void name_call(nc::Block& block);
    void deliver(nc::Block& block, std::string_view text, std::uint64_t number, bool again);
    void end_after(nc::Block& block);
    bool is_left_out(const nc::Block& block) const;
    void follow_shape(const nc::Block& block, std::string_view text, const Place& place);
    void keep_modal_shape(const nc::Block& block, std::string_view text, const Place& place);
    void follow_modal_shape(const nc::Block& block);
    void keep_contour(const nc::Block& block, std::int64_t kind);
    NamedContour contour_of(const nc::Block& block) const;
    void follow_named_shape(const nc::Block& block, std::string_view text, const Place& place);
    Outcome end_of_text();
    void note_skipped();
    bool check_skipped();
    void advance();
    Outcome read_words(CompiledLine& line, nc::Block& out);
    Outcome set_axes(CompiledLine& line);
    Outcome set_codes(CompiledLine& line);
    bool set_code(nc::LexedLine& words, std::size_t place, const std::string& code) const;
    Outcome let_axis_move_alone(CompiledLine& line, nc::Block& out);

    // statements
    Outcome execute(CompiledLine& line, const nc::ControlStatement& statement, nc::Block& out);
    Outcome execute_call(CompiledLine& line, const nc::ControlStatement& statement, nc::Block& out);
    Outcome assign(CompiledLine& line, const nc::ControlStatement& statement, nc::Block& out);
    Outcome fit_text(CompiledLine& line, const nc::ControlStatement& statement, Value& value);
    Outcome assign_list(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome fill_count(CompiledLine& line, std::span<const nc::Expression> said, std::size_t most,
                       std::size_t& out);
    Outcome list_place(CompiledLine& line, const nc::Reference& reference, ListPlace& out);
    ControlVariables::Fault store_at(const ListPlace& place, std::uint32_t i, const Value& value);
    Outcome declare(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome declare_one(CompiledLine& line, const nc::Declaration& declaration, nc::ValueType type,
                        std::uint32_t text_size);
    Outcome text_size(CompiledLine& line, const nc::Expression& expression, std::uint32_t& out);
    Outcome limit(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome jump(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome choose(CompiledLine& line, const nc::ControlStatement& statement, nc::Block& out);
    Outcome choose_case(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome enter(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome pass_end(const CompiledLine& line, const nc::ControlStatement& statement);
    Outcome leave(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome otherwise(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome repeat_section(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome call_section(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome raise(CompiledLine& line, const nc::Span& span, double number, const std::string& text);
    Outcome print(CompiledLine& line, const nc::ControlStatement& statement);  // printing.cpp
    // contour_statements.cpp
    Outcome contour(CompiledLine& line, const nc::ControlStatement& statement, nc::Block& out);
    Outcome begin_contour(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome end_contour(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome run_contour_row(CompiledLine& line, const nc::ControlStatement& statement,
                            nc::Block& out);
    // file_statements.cpp
    Outcome use_file(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome read_file(CompiledLine& line, const nc::ControlStatement& statement,
                      const std::string& name, ControlFiles::Error& error);
    std::string file_name(std::string_view path) const;
    Outcome run_text(CompiledLine& line, const nc::ControlStatement& statement, nc::Block& out);
    Outcome name_variables(CompiledLine& line, const nc::ControlStatement& statement);
    std::string_view with_names(std::string_view text);
    Outcome define_macro(CompiledLine& line, const nc::ControlStatement& statement);
    std::string_view with_macros(std::string_view text);
    Outcome pass_synchronous(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome stop_with_message(std::string_view text, nc::Block& out);

    // parts
    Outcome evaluate(CompiledLine& line, const nc::Expression& expression, Value& out,
                     int decimals = -1);
    Outcome truth(CompiledLine& line, const nc::Expression& expression, bool& out);
    Outcome store(CompiledLine& line, const nc::Reference& reference, const Value& value);
    void note_data(const nc::Block& block);
    void tell_data();
    ControlVariables::Fault store_noted(const CompiledLine& line, const nc::Reference& reference,
                                        std::span<const std::int64_t> indices, const Value& value);
    Outcome count_on(CompiledLine& line, OpenStructure& loop, bool& goes_on_looping);
    Result<LineTarget, Outcome> resolve(CompiledLine& line, const nc::JumpTarget& target);
    void warn_of_radians(const CompiledLine& line);
    void warn_of_twin(const CompiledLine& line, const nc::Span& span, const LineTarget& target,
                      const Place& found);
    Outcome go(CompiledLine& line, const Place& target, const nc::Span& span);
    void leave_open(const LinePosition& target);
    Outcome fail(CompiledLine& line, const nc::LineFault& fault);
    Outcome fail(CompiledLine& line, const DiagnosticRow& row, const nc::Span& span,
                 std::vector<std::string> arguments = {}) {
        return fail(line, nc::LineFault{&row, span, std::move(arguments)});
    }
    Outcome fail(CompiledLine& line, const nc::ControlStatement& statement, ProgramMap::Fault fault,
                 const ProgramMap::Crossing& crossing);
    Outcome fail(CompiledLine& line, ProgramMap::Fault fault, const DiagnosticRow& missing,
                 const nc::Span& span, const std::string& what);

    // program_calls.cpp: calls
    Outcome call(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome call_modal(CompiledLine& line, const nc::ControlStatement& statement, nc::Block& out);
    Outcome end_modal(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome prepare(CompiledLine& line, const nc::ControlStatement& statement, PreparedCall& out);
    Outcome prepare_passes(CompiledLine& line, const nc::CallValue& passes, PreparedCall& out);
    Outcome prepare_section(CompiledLine& line, const nc::ControlStatement& statement,
                            PreparedCall& out);
    Outcome prepare_letters(CompiledLine& line, const nc::Call& call, PreparedCall& out);
    Outcome prepare_list(CompiledLine& line, const nc::Call& call, PreparedCall& out);
    Outcome find_program(CompiledLine& line, const nc::ControlStatement& statement,
                         const nc::CallForm* form, PreparedCall& out);
    Outcome program_name(CompiledLine& line, const nc::ControlStatement& statement,
                         const nc::CallForm* form, PreparedCall& out, ProgramName& name);
    Outcome missing_program(CompiledLine& line, const nc::ControlStatement& statement,
                            const std::string& name);
    Outcome number_of(CompiledLine& line, const nc::CallValue& value, std::optional<double>& out);
    Outcome check_depth(CompiledLine& line, const PreparedCall& call, const nc::Span& span);
    Outcome bind_parameters(CompiledLine& line, const PreparedCall& call, Frame& callee);
    Outcome bind_parameter(CompiledLine& line, const PreparedCall& call, std::size_t index);
    void note_reference(const nc::Symbol& symbol, const ControlVariables::VariablePlace& place);
    void note_returned(const Frame& left);
    Outcome bind_reference(CompiledLine& line, const nc::ProcedureParameter& parameter,
                           const GivenValue& given, nc::Symbol symbol);
    Outcome begin(CompiledLine& line, const PreparedCall& call);
    void perform_call();
    const PreparedCall* active_modal_call() const;
    bool takes_blocks() const;
    double modal_call_code() const;
    /// The program that so many calls have led to; nothing: there are not as many.
    std::optional<std::string> name_at(std::int64_t level) const;
    bool find_program(std::string_view name);
    nc::LineContext context() const;
    void call_behind(const nc::Block& block, std::string_view text, std::uint64_t number);
    Outcome begin_due();
    void call_at_places(const nc::Block& block, const PreparedCall& active, std::string_view text,
                        std::uint64_t number);
    Outcome go_on_at_places(nc::Block& out);
    void leave_places(Frame& of);
    Outcome call_with_block(CompiledLine& line);
    void check_call(CompiledLine& line, const nc::ControlStatement& statement);
    void check_jumps(CompiledLine& line, const std::vector<nc::ControlStatement>& statements);
    Outcome find_target(CompiledLine& line, const nc::ControlStatement& statement,
                        LineTarget& target, std::optional<Place>& found);
    Outcome check_external(CompiledLine& line, const nc::ControlStatement& statement);

    // … returns
    Outcome declare_procedure(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome leave_program(CompiledLine& line, const nc::ControlStatement& statement,
                          nc::Block& out);
    Outcome return_in_main(CompiledLine& line, const nc::ControlStatement& statement,
                           const std::optional<LineTarget>& target, nc::Block& out);
    bool cancel_repeat();
    Outcome finish_return(nc::Block& out);
    void restart(Frame& again);
    void resume_frame(Frame& next);
};

}  // namespace kadr::macro
