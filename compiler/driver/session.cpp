#include "driver/session.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/assert.h"
#include "base/diagnostics/driver.h"
#include "base/diagnostics/tools.h"
#include "base/text.h"
#include "driver/pipeline_stages.h"

namespace kadr::driver {

namespace {

constexpr const char* kStockMachine = "mill";
constexpr const char* kStockLathe = "lathe";

/// A loader knows only that a file could not be read; this tells why.
class ReasonSink final : public DiagnosticSink {
  public:
    ReasonSink(const Files& files, DiagnosticSink& next) : files_(files), next_(next) {}

    void take(Diagnostic diagnostic) override {
        if (diagnostic.row == &diag::FileUnreadable && !diagnostic.arguments.empty()) {
            std::string why = files_.why_unreadable(diagnostic.arguments[0]);
            if (why.empty()) why = "it holds more than " + bytes_text(Files::kMostBytes);
            diagnostic.notes.insert(diagnostic.notes.begin(), {{}, std::nullopt, std::move(why)});
        }
        next_.take(std::move(diagnostic));
    }

  private:
    const Files& files_;
    DiagnosticSink& next_;
};

/// Notes where something was asked for that is not there: a location in a source, or an option.
class OriginSink final : public DiagnosticSink {
  public:
    OriginSink(DiagnosticSink& next, const SourceRange& location, std::string_view option)
        : next_(next), location_(location), option_(option) {}

    void take(Diagnostic diagnostic) override {
        const bool has_place = diagnostic.range.file.is_valid() || diagnostic.line;
        if (!has_place && location_.file.is_valid()) {
            diagnostic.range = location_;
        } else if (!has_place && !option_.empty()) {
            diagnostic.notes.push_back(
                {{}, std::nullopt, "it is asked for by the option `" + std::string(option_) + "`"});
        }
        next_.take(std::move(diagnostic));
    }

  private:
    DiagnosticSink& next_;
    SourceRange location_;
    std::string_view option_;
};

}  // namespace

Session::Session(Options options, SharedInputs& inputs, Sources& sources, Messages& messages)
    : options_(std::move(options)),
      inputs_(inputs),
      sources_(sources),
      messages_(messages),
      access_(inputs.files(), options_.max_input),
      deadline_(options_.max_time, options_.stop),
      output_limit_(options_.max_output) {
    KADR_ASSERT(sources.shared() == &inputs.sources(), "a session whose texts are not shared");
    for (const std::string& folder : options_.allow_read) access_.allow(folder);
    for (const std::string& folder : options_.folders) access_.allow(folder);
    for (const std::string& folder : options_.search) access_.allow(folder);
    access_.allow(share().library);
    for (const auto* folders : {&share().dialects, &share().languages, &share().machines})
        for (const std::string& folder : *folders) access_.allow(folder);
}

/// A loader has read this file, and may; it is noted. `beside`: the file that the user named;
/// empty: a source named it, at `location`.
Done Session::admit(const std::string& file, const std::string& beside,
                    const SourceRange& location) {
    access_.note(file);
    if (file == beside || is_of_share(file) || access_.may_be_read(file, beside)) return kDone;
    report_unread(messages_, diag::FileUnreadable, location, file, access_.fault_elsewhere(file),
                  access_);
    return kFailed;
}

/// … all texts from this one on, which the user named.
Done Session::admit_since(std::size_t first, const std::string& beside) {
    for (std::size_t i = first; i < sources_.size(); ++i) {
        if (!admit(std::string(sources_.name(sources_.nth(i))), beside, {})) return kFailed;
    }
    return kDone;
}

/// What was loaded, if this session may read all that it was made from; its messages are reported.
template <typename T>
std::shared_ptr<const T> Session::admit_load(const SharedLoad<T>& load, const std::string& beside,
                                             const SourceRange& location, std::string_view option) {
    for (const SharedText& text : load->texts) {
        if (!admit(std::string(sources_.name(text.file())), beside, location)) return nullptr;
    }
    ReasonSink reasons(files(), messages_);
    OriginSink sink(reasons, location, option);
    for (const Diagnostic& message : load->messages) sink.take(message);
    if (!load->value) return nullptr;
    return std::shared_ptr<const T>(load, &*load->value);
}

/// Whether a file stands in a folder of Kadr's own, where a link is as good as the file.
bool Session::is_of_share(const std::string& name) const {
    if (name.find("..") != std::string::npos) return false;
    const auto holds = [&](const std::string& folder) { return name.starts_with(folder + '/'); };
    return holds(share().library) || std::ranges::any_of(share().dialects, holds) ||
           std::ranges::any_of(share().languages, holds) ||
           std::ranges::any_of(share().machines, holds);
}

std::shared_ptr<const nc::Dialect> Session::kept_dialect(const std::string& name_or_file,
                                                         const SourceRange& location) {
    const bool is_option = name_or_file == options_.dialect;
    // Without an option the machine is a lathe where the control is one by itself.
    const bool is_lathe = !options_.machine.empty() && machine() != nullptr && machine()->is_lathe;
    const auto kind = is_lathe ? nc::MachineKind::Lathe : nc::MachineKind::Mill;
    const auto known = dialects_.find(name_or_file);
    if (known != dialects_.end()) return known->second;
    const bool is_named = is_option || !location.file.is_valid();
    const std::string beside = is_named ? name_or_file : std::string();
    auto dialect =
        admit_load(inputs_.dialect(kind, name_or_file), beside, location, is_option ? "-d" : "");
    // The files of its cycles belong to it, whether this run calls one or not.
    if (dialect != nullptr) {
        for (const nc::CycleInfo& cycle : dialect->cycles())
            if (!cycle.file.empty()) access_.note(cycle.file);
    }
    return dialects_[name_or_file] = std::move(dialect);
}

const nc::Dialect* Session::chosen_dialect(const std::string& otherwise) {
    const nc::Dialect* chosen =
        dialect(options_.dialect.empty() ? otherwise : options_.dialect, {});
    if (chosen == nullptr) mark_usage();
    return chosen;
}

std::shared_ptr<const syntax::KeywordTable> Session::kept_keywords(const std::string& name_or_file,
                                                                   const SourceRange& location) {
    const auto known = keywords_.find(name_or_file);
    if (known != keywords_.end()) return known->second;
    return keywords_[name_or_file] = admit_load(inputs_.keywords(name_or_file), "", location, "");
}

std::string Session::stock_machine() {
    if (options_.dialect.empty()) return kStockMachine;
    const nc::Dialect* control = dialect(options_.dialect);
    return control != nullptr && control->is_of_lathe() ? kStockLathe : kStockMachine;
}

nc::InspectedDialect Session::inspect_dialect(const std::string& name_or_file,
                                              DiagnosticSink& found) {
    const std::size_t first = sources_.size();
    DiagnosticList held;  // until it is known whether only files were read that may be
    nc::InspectedDialect inspected =
        nc::inspect_dialect(name_or_file, share().dialects, sources_, held);
    if (!admit_since(first, name_or_file)) return {};
    ReasonSink reasons(files(), found);
    for (const Diagnostic& message : held.all()) reasons.take(message);
    return inspected;
}

std::optional<machine::DescribedMachine> Session::load_machine(const std::string& name_or_file,
                                                               std::string_view option) {
    const std::size_t first = sources_.size();
    DiagnosticList held;
    auto fresh = machine::load_described_machine(name_or_file, share().machines, sources_, held);
    if (!admit_since(first, name_or_file)) return std::nullopt;
    ReasonSink reasons(files(), messages_);
    OriginSink sink(reasons, {}, option);
    for (const Diagnostic& message : held.all()) sink.take(message);
    return fresh;
}

const machine::Machine* Session::machine() {
    if (!machine_was_loaded_) {
        machine_was_loaded_ = true;
        const bool is_option = !options_.machine.empty();
        const std::string_view option = is_option ? "-m" : "";
        const std::string name = is_option ? options_.machine : stock_machine();
        auto loaded = admit_load(inputs_.machine(name), name, {}, option);
        OriginSink sink(messages_, {}, option);
        if (loaded != nullptr && !require_modules(loaded->machine, sink)) loaded.reset();
        if (loaded == nullptr) mark_usage();
        bare_machine_ = machine_ = std::move(loaded);
        if (machine_ != nullptr && tools() != nullptr) equip_machine();
    }
    return machine_ == nullptr ? nullptr : &machine_->machine;
}

void Session::equip_machine() {
    auto equipped = std::make_shared<machine::DescribedMachine>(*bare_machine_);
    machine::add_tools(equipped->machine, *tools_, messages_);
    machine_ = std::move(equipped);
}

const machine::ToolLibrary* Session::tools() {
    const bool is_option = !options_.tools.empty();
    // A machine that is being loaded asks for the library when its file is read.
    if (!is_option && !options_.machine.empty()) (void)machine();
    if (tools_were_loaded_) return tools_.get();
    tools_were_loaded_ = true;
    const std::string file = is_option ? options_.tools : machine_data().tools;
    if (file.empty()) return nullptr;
    tools_ = admit_load(inputs_.tools(file), is_option ? file : options_.machine, {},
                        is_option ? "--tools" : "");
    if (tools_ == nullptr) mark_usage();
    return tools_.get();
}

Done Session::import_tools(const std::string& file, const SourceRange& location) {
    if (!imported_tools_.empty() && imported_tools_ != file) {
        messages_.report(diag::ToolsTwice, location).arg(file).arg(imported_tools_);
        return kFailed;
    }
    if (imported_tools_ == file) return Done(tools_ != nullptr);
    imported_tools_ = file;
    tools_were_loaded_ = true;
    tools_ = admit_load(inputs_.tools(file), "", location, "");
    if (tools_ == nullptr) return kFailed;
    if (bare_machine_ != nullptr) equip_machine();
    return kDone;
}

Done Session::require_output_room() {
    if (!output_limit_.is_over()) return kDone;
    if (output_limit_.first_time_over()) {
        messages_.report(diag::OutputLimit)
            .arg(bytes_text(output_limit_.most()))
            .fix("if so much is meant, raise the limit: `--max-output`");
    }
    return kFailed;
}

std::string Session::output_name(FileId file) const {
    const std::string_view name = sources_.name(file);
    const std::string library = share().library + '/';
    if (!name.starts_with(library)) return std::string(name);
    return "stdlib/" + std::string(name.substr(library.size()));
}

std::string Session::source_name(const SourceRange& range) const {
    if (!range.file.is_valid()) return {};
    return output_name(range.file) + ':' +
           std::to_string(sources_.locate(range.file, range.begin).line);
}

Status Session::status() const {
    if (is_usage_) return Status::Usage;
    if (messages_.errors() > 0) return Status::Failed;
    if (messages_.alarms() > 0) return Status::Alarm;
    return Status::Done;
}

}  // namespace kadr::driver
