#include "driver/execution.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <utility>
#include <vector>

#include "base/diagnostics/control.h"
#include "base/diagnostics/driver.h"
#include "base/diagnostics/expand.h"
#include "base/diagnostics/iso.h"
#include "base/text.h"
#include "driver/machine_inputs.h"
#include "motion/pipeline.h"
#include "syntax/limits.h"

namespace kadr::driver {

namespace {

constexpr const char* kDefaultDialect = "iso";

/// Lines that a message of the motion can show: what the compensation and the look-ahead hold back,
/// with the lines between that move nothing. As many as LineMap knows.
constexpr std::size_t kShownLines = std::size_t{1} << 14;

/// Whether a dialect's list of suffixes, "mpf spf", has this one; case does not count.
bool has_suffix(std::string_view list, std::string_view suffix) {
    const std::string all = ' ' + upper_ascii(list) + ' ';
    return all.find(' ' + upper_ascii(suffix) + ' ') != std::string::npos;
}

/// Dialects whose files have this suffix, without those that only vary another one of them.
std::vector<nc::DialectSummary> dialects_of_suffix(const Session& session,
                                                   std::string_view suffix) {
    std::vector<nc::DialectSummary> found;
    for (const nc::DialectSummary& summary :
         nc::list_dialects(session.share().dialects, session.files())) {
        if (has_suffix(summary.suffix, suffix)) found.push_back(summary);
    }
    std::vector<nc::DialectSummary> own;
    for (const nc::DialectSummary& summary : found) {
        const bool is_variant = std::ranges::any_of(
            found, [&](const nc::DialectSummary& other) { return other.name == summary.extends; });
        if (!is_variant) own.push_back(summary);
    }
    return own;
}

/// The dialect whose files end as this one does, else the common core. Of several the one whose
/// header the text has. Empty: reported.
std::string dialect_of_text(Session& session, const std::string& source, std::string_view text) {
    std::string suffix = std::filesystem::path(source).extension().string();
    if (suffix.size() < 2) return kDefaultDialect;
    suffix.erase(0, 1);
    std::vector<nc::DialectSummary> found = dialects_of_suffix(session, suffix);
    if (found.empty()) return kDefaultDialect;
    if (found.size() == 1) return found[0].name;
    // Another control's file with mistakes tells nothing about this text.
    std::erase_if(found, [&](const nc::DialectSummary& summary) {
        return !nc::can_be_loaded(summary.name, session.share().dialects, session.files());
    });
    if (found.empty()) return kDefaultDialect;
    if (found.size() == 1) return found[0].name;
    std::vector<std::string> with_header;
    std::string names;
    std::string choices;
    for (const nc::DialectSummary& summary : found) {
        const nc::Dialect* dialect = session.dialect(summary.name, {});
        if (dialect != nullptr && dialect->has_header(text)) with_header.push_back(summary.name);
        if (!names.empty()) names += " or ", choices += " or ";
        names += summary.name;
        choices += "`-d " + summary.name + '`';
    }
    if (with_header.size() == 1) return with_header[0];
    session.messages().report(diag::DialectAmbiguous).arg(source).arg(names).fix("say " + choices);
    session.mark_usage();
    return {};
}

/// The name of the text that a program would be written to: "part.mpf".
std::string generated_name(std::string_view source, const nc::Dialect& dialect) {
    const std::string stem = std::filesystem::path(source).stem().string();
    const std::string_view suffixes = dialect.suffix();
    const std::string suffix(suffixes.substr(0, suffixes.find(' ')));
    return (stem.starts_with('<') ? "program" : stem) + '.' + (suffix.empty() ? "iso" : suffix);
}

std::string shown_name(const std::string& source) { return source == "-" ? "<stdin>" : source; }

}  // namespace

/// Keeps what the reader reports until the blocks before are executed: it reads ahead, and a
/// control that stops, or comes to its end, does not complain of what stands behind.
class Execution::HeldMessages final : public DiagnosticSink {
  public:
    explicit HeldMessages(DiagnosticSink& next) : next_(next) {}

    void take(Diagnostic diagnostic) override { held_.push_back(std::move(diagnostic)); }
    void release() {
        for (Diagnostic& diagnostic : held_) next_.take(std::move(diagnostic));
        held_.clear();
    }
    /// What stands behind the end of the program is wrong only if something leads there.
    void soften() {
        for (Diagnostic& diagnostic : held_) {
            if (diagnostic.severity != Severity::Alarm) continue;
            std::string text = diagnostic.message();
            if (!diagnostic.alarm_number.empty())
                text = "alarm " + diagnostic.alarm_number + ", " + text;
            diagnostic.row = &diag::IfReached;
            diagnostic.severity = Severity::Warning;
            diagnostic.arguments = {std::move(text)};
            diagnostic.alarm_number.clear();
            diagnostic.alarm_text.clear();
        }
    }
    /// Behind the last block: the warnings of the lines up to it. What stands behind it waits for a
    /// check that reads on.
    void release_up_to(const std::string& file, std::uint32_t line) {
        std::vector<Diagnostic> behind;
        for (Diagnostic& diagnostic : held_) {
            const bool is_behind = diagnostic.severity != Severity::Warning || !diagnostic.line ||
                                   (diagnostic.line->file == file && diagnostic.line->line > line);
            if (is_behind) behind.push_back(std::move(diagnostic));
            else next_.take(std::move(diagnostic));
        }
        held_ = std::move(behind);
    }

  private:
    DiagnosticSink& next_;
    std::vector<Diagnostic> held_;
};

/// Gives the blocks that were read the statements that had written them.
class Execution::Tagger final : public Stream<nc::Block> {
  public:
    using Look = std::function<void(const nc::Block&)>;
    Tagger(Stream<nc::Block>& blocks, HeldMessages& held, const LineMap* lines, Look look)
        : blocks_(blocks), held_(held), lines_(lines), look_(std::move(look)) {}

    std::size_t pull(std::span<nc::Block> out) override {
        held_.release();
        const std::size_t count = blocks_.pull(out);
        if (lines_ != nullptr) {
            for (nc::Block& block : out.first(count)) block.source = lines_->find(block.line);
        }
        if (look_) {
            for (const nc::Block& block : out.first(count)) look_(block);
        }
        return count;
    }

  private:
    Stream<nc::Block>& blocks_;
    HeldMessages& held_;
    const LineMap* lines_;
    Look look_;  // may be empty
};

/// Places a message about generated text, which is nowhere on the disk, at the statement that wrote
/// the line.
class Execution::StatementNotes final : public DiagnosticSink {
  public:
    StatementNotes(const Execution& execution, DiagnosticSink& next)
        : execution_(execution), next_(next) {}

    std::size_t alarms() const { return alarms_; }

    void take(Diagnostic diagnostic) override {
        if (diagnostic.severity == Severity::Alarm) {
            ++alarms_;
            name_alarm(diagnostic);
        }
        // Run from its source a program meets a part that lies right (docs/stdlib.md).
        if (place_at_statement(diagnostic) && diagnostic.row == &diag::TouchMissing) return;
        next_.take(std::move(diagnostic));
    }

    /// Whether the line of the message is generated; its location is that of the statement then.
    bool place_at_statement(Diagnostic& diagnostic) const {
        const bool is_generated = execution_.generated_ && diagnostic.line &&
                                  diagnostic.line->file == execution_.text_name_;
        if (!is_generated) return false;
        execution_.generated_->move_to_statement(diagnostic);
        return !diagnostic.line;
    }

  private:
    /// The motion knows no control: its alarms get their numbers here.
    void name_alarm(Diagnostic& diagnostic) const {
        if (!diagnostic.alarm_number.empty()) return;
        const auto own = execution_.dialect().alarm(*diagnostic.row);
        if (!own) return;
        diagnostic.alarm_number = own->number;
        diagnostic.alarm_text = own->text;
    }

    const Execution& execution_;
    DiagnosticSink& next_;
    std::size_t alarms_ = 0;
};

Execution::Execution(Session& session)
    : session_(session), deadline_(session.options().max_time, session.options().stop) {}
Execution::~Execution() = default;

std::unique_ptr<FileText> open_source(Session& session, const std::string& source) {
    auto text = FileText::open(session.files(), source);
    if (!text) {
        report_unread(session.messages(), diag::FileUnreadable, {}, source,
                      {ReadFault::Kind::Unreadable, session.files().why_unreadable(source)},
                      session.access());
        session.mark_usage();
        return nullptr;
    }
    session.access().allow_home_of(source);
    session.access().note(source);
    return text;
}

bool is_kadr_source(const std::string& source, const FileText& text) {
    return is_kadr_name(source) || (source == "-" && looks_like_kadr(text.peek()));
}

FileId keep_source(Session& session, const std::string& source, FileText& text) {
    return session.sources().add(shown_name(source), text.read_all(syntax::kMaxBytes));
}

std::unique_ptr<Execution> Execution::open(Session& session, const std::string& source,
                                           std::unique_ptr<FileText> text, const Aside& aside) {
    std::unique_ptr<Execution> execution(new Execution(session));
    execution->aside_ = aside;
    execution->machine_ = session.machine();
    if (execution->machine_ == nullptr) return nullptr;
    const Done opened =
        is_kadr_source(source, *text)
            ? execution->open_program(keep_source(session, source, *text), aside.tap)
            : execution->open_text(source, std::move(text));
    if (!opened || !execution->open_inputs()) return nullptr;
    execution->machine_ = session.machine();  // with the tools that the program imports
    execution->connect_with_library();
    return execution;
}

std::unique_ptr<Execution> Execution::open(Session& session, const Subject& subject) {
    std::unique_ptr<Execution> execution(new Execution(session));
    execution->machine_ = session.machine();
    if (execution->machine_ == nullptr) return nullptr;
    execution->dialect_ = &subject.dialect;
    execution->program_ = &subject.program;
    execution->text_name_ = generated_name(subject.entry.name, subject.dialect);
    execution->generated_ = std::make_unique<GeneratedText>(
        session, subject.program, subject.dialect, TextAside{}, subject.sink);
    if (subject.text != nullptr) {
        execution->generated_->set_tap(
            [text = subject.text](std::string_view piece) { *text += piece; });
    }
    if (!execution->generated_->start(subject.entry)) return nullptr;
    execution->cycles_ = &subject.cycles;
    subject.cycles.report_to(subject.sink);
    execution->connect(subject.sink);
    return execution;
}

std::unique_ptr<Execution> Execution::open(Session& session, const KadrProgram& program,
                                           const nc::Dialect& dialect,
                                           std::unique_ptr<GeneratedText> text,
                                           DiagnosticSink& sink) {
    std::unique_ptr<Execution> execution(new Execution(session));
    execution->machine_ = session.machine();
    if (execution->machine_ == nullptr) return nullptr;
    execution->dialect_ = &dialect;
    execution->program_ = &program;
    execution->text_name_ = generated_name(session.sources().name(program.file), dialect);
    execution->generated_ = std::move(text);
    execution->own_cycles_ = std::make_unique<LibraryCycles>(session, dialect);
    execution->cycles_ = execution->own_cycles_.get();
    execution->cycles_->report_to(sink);
    execution->connect(sink);
    return execution;
}

/// What the machine gives the program before it begins.
Done Execution::open_inputs() {
    if (session_.options().call && program_ != nullptr) {
        session_.messages().report(diag::CallOfKadr);
        session_.mark_usage();
        return kFailed;
    }
    auto inputs = machine_inputs(session_);
    if (!inputs) return kFailed;
    inputs_ = std::move(*inputs);
    return kDone;
}

Done Execution::open_text(const std::string& source, std::unique_ptr<FileText> text) {
    const bool is_named = !session_.options().dialect.empty();
    const std::string guess = is_named ? "" : dialect_of_text(session_, source, text->peek());
    if (!is_named && guess.empty()) return kFailed;
    dialect_ = session_.chosen_dialect(guess);
    text_name_ = shown_name(source);
    file_ = std::move(text);
    if (source == "-") file_->set_tap(aside_.tap);
    std::vector<std::string> folders;
    if (source != "-") {
        const std::filesystem::path folder = std::filesystem::path(source).parent_path();
        folders.push_back(folder.empty() ? "." : folder.string());
    }
    const std::vector<std::string>& search = session_.options().search;
    for (const std::string& folder : search) {
        if (session_.files().is_folder(folder)) continue;
        session_.messages()
            .report(diag::FileUnreadable)
            .arg(folder)
            .note("it is no folder, or there is none");
        session_.mark_usage();
        return kFailed;
    }
    folders.insert(folders.end(), search.begin(), search.end());
    called_ = std::make_unique<ProgramFolders>(std::move(folders), session_);
    return Done(dialect_ != nullptr);
}

std::unique_ptr<Execution> Execution::open(Session& session, FileId program,
                                           GeneratedText::Tap tap) {
    std::unique_ptr<Execution> execution(new Execution(session));
    execution->machine_ = session.machine();
    if (execution->machine_ == nullptr) return nullptr;
    if (!execution->open_program(program, std::move(tap)) || !execution->open_inputs())
        return nullptr;
    execution->machine_ = session.machine();  // with the tools that the program imports
    execution->connect_with_library();
    return execution;
}

Done Execution::open_program(FileId file, GeneratedText::Tap tap) {
    dialect_ = session_.chosen_dialect(kDefaultDialect);
    if (dialect_ == nullptr) return kFailed;
    own_program_ = load_program(session_, file, aside_.statements != nullptr);
    if (!own_program_) return kFailed;
    program_ = &*own_program_;
    text_name_ = generated_name(session_.sources().name(file), *dialect_);
    const TextAside beside{.map = aside_.map,
                           .keeps_calls = aside_.keeps_calls || aside_.watch != nullptr,
                           .watch = aside_.statements};
    generated_ = std::make_unique<GeneratedText>(session_, *program_, *dialect_, beside);
    generated_->set_tap(std::move(tap));
    return generated_->start();
}

/// With the library's cycles for this execution alone.
void Execution::connect_with_library() {
    own_cycles_ = std::make_unique<LibraryCycles>(session_, *dialect_);
    cycles_ = own_cycles_.get();
    connect(session_.messages());
}

void Execution::connect(DiagnosticSink& sink) {
    const Options& options = session_.options();
    sink_ = std::make_unique<StatementNotes>(*this, sink);
    nc::TextSource& text = generated_ ? static_cast<nc::TextSource&>(*generated_) : *file_;
    held_ = std::make_unique<HeldMessages>(*sink_);
    macro::ProgramOptions program_options;
    program_options.skip_levels = options.skip_levels;
    program_options.passes = options.passes;
    program_options.files = called_.get();
    program_options.inputs = inputs_;
    program_options.call = options.call;
    program_options.events = aside_.input_events;
    program_options.axis_names = axis_names(*machine_, session_.machine_data());
    if (options.max_time > 0 || options.stop != nullptr)
        program_options.is_over = [this] { return deadline_.is_over(); };
    if (options.max_blocks != 0) {  // it counts what the other limits count
        constexpr auto kNone = std::numeric_limits<std::uint64_t>::max();
        program_options.max_blocks = options.max_blocks;
        program_options.max_repeated = program_options.max_turns = kNone;
    }
    reader_ =
        std::make_unique<macro::NcProgram>(*dialect_, text, text_name_, program_options, *held_);
    tagged_ = std::make_unique<Tagger>(*reader_, *held_,
                                       generated_ ? &generated_->lines() : nullptr, aside_.look_at);
    // A cycle that a test executes by itself runs with the tool of its caller.
    const bool is_subject = generated_ && !own_program_;
    const std::optional<machine::ProbeScene>& probe = session_.machine_data().probe;
    const interp::InterpreterOptions interpreter_options{
        .max_blocks = options.max_blocks,
        .skip_levels = options.skip_levels,
        .optional_stop = options.optional_stop,
        .asks_for_tool = !is_subject,
        .has_named_machine = is_subject || !options.machine.empty(),
        .probe = probe ? &*probe : nullptr,
        .touches = aside_.touches,
        .in_step = aside_.watch != nullptr || aside_.in_step,
        .is_allowed = [this](const DiagnosticRow& row, const TextLocation& location) {
            Diagnostic warning;
            warning.row = &row;
            warning.severity = Severity::Warning;
            warning.line = location;
            sink_->place_at_statement(warning);
            return session_.messages().is_silenced(warning);
        }};
    interpreter_ = std::make_unique<interp::Interpreter>(
        *dialect_, *machine_, *tagged_, reader_.get(), cycles_, interpreter_options, *sink_);
    reader_->follow(*interpreter_);
    reader_->show_to(aside_.watch, aside_.changes);
}

void Execution::check_time() {
    if (!deadline_.is_over()) return;
    is_late_ = true;
    // A loop without blocks was cut in the middle.
    const std::uint64_t line = reader_->stopped() ? reader_->line() : last_line_;
    const auto location = shown_location(static_cast<std::uint32_t>(line), {});
    if (deadline_.is_cancelled()) {
        // The evaluator of a Kadr program was asked as well, and may have answered before.
        if (session_.messages().errors() == 0) sink_->report(diag::EvaluationStopped, location);
        return;
    }
    sink_->report(diag::TimeIsUp, location)
        .arg(deadline_.seconds())
        .arg(static_cast<std::size_t>(blocks()));
}

std::size_t Execution::pull(std::span<path::Command> out) {
    if (is_late_ || session_.output_limit().is_over()) return 0;
    check_time();
    if (is_late_) return 0;
    const std::size_t alarms = sink_->alarms();
    const std::size_t count = interpreter_->pull(out);
    if (count > 0) last_line_ = out[count - 1].line;
    if (count == 0 && reader_->stopped()) check_time();
    has_stopped_ = has_stopped_ || sink_->alarms() > alarms;
    // Stopped without a word of its own: the reader knows why.
    if (count == 0 && interpreter_->alarmed() && !has_stopped_) held_->release();
    if (count == 0) held_->release_up_to(text_name_, last_line_);
    return count;
}

void Execution::read_rest() {
    reader_->check_only();
    read_on(has_stopped_ || interpreter_->alarmed());
    // To what was jumped over nothing has led, whatever has stopped the run.
    while (reader_->check_passed_text()) read_on(false);
}

/// Reads what is left for its mistakes.
void Execution::read_on(bool is_reached) {
    std::vector<nc::Block> batch(kBatch);
    const auto soften = [&] {
        if (!is_reached) held_->soften();
    };
    do {
        soften();
    } while (tagged_->pull(batch) > 0);
    soften();
    held_->release();
}

void Execution::finish_text() {
    if (generated_) generated_->finish_piece();
}

void Execution::make_rest() {
    while (!generated_->next().empty())
        session_.report({.blocks = generated_->blocks(), .setpoints = 0, .time = 0});
}

bool Execution::failed() const {
    return reader_->has_fault() || (generated_ && generated_->failed());
}

SourceRange Execution::statement(SourceId source) const {
    if (program_ == nullptr || !source.is_valid() ||
        source.index >= program_->code->statements.size())
        return {};
    return program_->code->statements[source.index];
}

DiagnosticSink& Execution::sink() { return *sink_; }

std::uint64_t Execution::statement_lines() const {
    return generated_ ? generated_->statement_lines() : 0;
}

TextLocation Execution::location_of(std::uint32_t line) const { return reader_->location(line); }

/// A line with its text, at the word of the axis if it has one.
TextLocation Execution::shown_location(std::uint32_t line, std::optional<Axis> axis) const {
    std::optional<nc::Slot> slot;
    if (axis) slot = static_cast<nc::Slot>(index(*axis));
    return reader_->shown_location(line, slot);
}

void Execution::place_messages(motion::PlannerOptions& options) {
    reader_->keep_lines(std::max(kShownLines, 2 * options.lookahead));
    options.locate_command = [this](const motion::CommandLocation& asked) {
        motion::ShownLocation shown{shown_location(asked.line, asked.axis), {}};
        // The source of generated text is a statement, which StatementNotes shows.
        if (!generated_) shown.calls = reader_->calls(asked.source);
        return shown;
    };
}

}  // namespace kadr::driver
