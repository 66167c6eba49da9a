#include "driver/session.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "base/diagnostics/driver.h"
#include "base/text.h"
#include "driver/pipeline_stages.h"
#include "nc/dialect_on_machine.h"

namespace kadr::driver {

namespace {

constexpr const char* kStockMachine = "mill";
constexpr const char* kStockLathe = "lathe";

/// Loads on first use; a failure is remembered too, so that it is reported once.
template <typename T, typename Load>
const T* load_once(std::map<std::string, std::unique_ptr<T>>& loaded, const std::string& name,
                   const Load& load) {
    const auto known = loaded.find(name);
    if (known != loaded.end()) return known->second.get();
    std::optional<T> fresh = load();
    auto owned = fresh ? std::make_unique<T>(std::move(*fresh)) : nullptr;
    return loaded.emplace(name, std::move(owned)).first->second.get();
}

/// Keeps what a loader reports until it is known whether it read only what may be read.
class HeldSink final : public DiagnosticSink {
  public:
    void take(Diagnostic diagnostic) override { held_.push_back(std::move(diagnostic)); }
    void release_to(DiagnosticSink& next) {
        for (Diagnostic& diagnostic : held_) {
            report_why(diagnostic);
            next.take(std::move(diagnostic));
        }
    }

  private:
    /// The loader knows only that a file could not be read.
    static void report_why(Diagnostic& diagnostic) {
        if (diagnostic.row != &diag::FileUnreadable || diagnostic.arguments.empty()) return;
        std::string why = why_unreadable(diagnostic.arguments[0]);
        if (why.empty()) why = "it holds more than " + bytes_text(Files::kMostBytes);
        diagnostic.notes.insert(diagnostic.notes.begin(), {{}, std::nullopt, std::move(why)});
    }

    std::vector<Diagnostic> held_;
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

Session::Session(Options options, Share share, Sources& sources, Messages& messages)
    : options_(std::move(options)),
      share_(std::move(share)),
      sources_(sources),
      messages_(messages),
      files_(options_.max_input),
      deadline_(options_.max_time),
      output_limit_(options_.max_output) {
    for (const std::string& folder : options_.allow_read) files_.allow(folder);
    for (const std::string& folder : options_.folders) files_.allow(folder);
    for (const std::string& folder : options_.search) files_.allow(folder);
    files_.allow(share_.library);
    for (const auto* folders : {&share_.dialects, &share_.languages, &share_.machines})
        for (const std::string& folder : *folders) files_.allow(folder);
}

/// All texts from this one on, which a loader has read, are ones that it may read; they are noted.
/// `beside`: the file that the user named; empty: a source named it, at `location`.
Done Session::admit(std::size_t first, const std::string& beside, const SourceRange& location) {
    for (std::size_t i = first; i < sources_.size(); ++i) {
        const std::string name(sources_.name(FileId{static_cast<std::uint32_t>(i)}));
        files_.note(name);
        if (name == beside || is_of_share(name) || files_.may_be_read(name, beside)) continue;
        report_unread(messages_, diag::FileUnreadable, location, name, files_.fault_elsewhere(name),
                      files_);
        return kFailed;
    }
    return kDone;
}

/// Whether a file stands in a folder of Kadr's own, where a link is as good as the file.
bool Session::is_of_share(const std::string& name) const {
    if (name.find("..") != std::string::npos) return false;
    const auto holds = [&](const std::string& folder) { return name.starts_with(folder + '/'); };
    return holds(share_.library) || std::ranges::any_of(share_.dialects, holds) ||
           std::ranges::any_of(share_.languages, holds) ||
           std::ranges::any_of(share_.machines, holds);
}

const nc::Dialect* Session::dialect(const std::string& name_or_file, const SourceRange& location) {
    const bool is_option = name_or_file == options_.dialect;
    // Without an option the machine is a lathe where the control is one by itself.
    const bool is_lathe = !options_.machine.empty() && machine() != nullptr && machine()->is_lathe;
    const auto kind = is_lathe ? nc::MachineKind::Lathe : nc::MachineKind::Mill;
    return load_once(dialects_, name_or_file, [&]() -> std::optional<nc::Dialect> {
        const std::size_t first = sources_.size();
        HeldSink held;
        OriginSink sink(held, location, is_option ? "-d" : "");
        auto fresh = nc::load_dialect_for(kind, name_or_file, share_.dialects, sources_, sink);
        const bool is_named = is_option || !location.file.is_valid();
        if (!admit(first, is_named ? name_or_file : std::string(), location)) return std::nullopt;
        held.release_to(messages_);
        // The files of its cycles belong to it, whether this run calls one or not.
        if (fresh) {
            for (const nc::CycleInfo& cycle : fresh->cycles())
                if (!cycle.file.empty()) files_.note(cycle.file);
        }
        return fresh;
    });
}

const nc::Dialect* Session::chosen_dialect(const std::string& otherwise) {
    const nc::Dialect* chosen =
        dialect(options_.dialect.empty() ? otherwise : options_.dialect, {});
    if (chosen == nullptr) mark_usage();
    return chosen;
}

const syntax::KeywordTable* Session::keywords(const std::string& name_or_file,
                                              const SourceRange& location) {
    return load_once(keywords_, name_or_file, [&]() -> std::optional<syntax::KeywordTable> {
        const std::size_t first = sources_.size();
        HeldSink held;
        OriginSink sink(held, location, "");
        auto fresh = syntax::load_keywords(name_or_file, share_.languages, sources_, sink);
        if (!admit(first, "", location)) return std::nullopt;
        held.release_to(messages_);
        return fresh;
    });
}

std::string Session::stock_machine() {
    if (options_.dialect.empty()) return kStockMachine;
    const nc::Dialect* control = dialect(options_.dialect);
    return control != nullptr && control->is_of_lathe() ? kStockLathe : kStockMachine;
}

nc::InspectedDialect Session::inspect_dialect(const std::string& name_or_file,
                                              DiagnosticSink& found) {
    const std::size_t first = sources_.size();
    HeldSink held;
    nc::InspectedDialect inspected =
        nc::inspect_dialect(name_or_file, share_.dialects, sources_, held);
    if (!admit(first, name_or_file, {})) return {};
    held.release_to(found);
    return inspected;
}

std::optional<machine::DescribedMachine> Session::load_machine(const std::string& name_or_file,
                                                               std::string_view option) {
    const std::size_t first = sources_.size();
    HeldSink held;
    OriginSink sink(held, {}, option);
    auto fresh = machine::load_described_machine(name_or_file, share_.machines, sources_, sink);
    if (!admit(first, name_or_file, {})) return std::nullopt;
    held.release_to(messages_);
    return fresh;
}

const machine::Machine* Session::machine() {
    if (!machine_was_loaded_) {
        machine_was_loaded_ = true;
        const bool is_option = !options_.machine.empty();
        const std::string_view option = is_option ? "-m" : "";
        auto fresh = load_machine(is_option ? options_.machine : stock_machine(), option);
        OriginSink sink(messages_, {}, option);
        if (fresh && !require_modules(fresh->machine, sink)) fresh.reset();
        if (!fresh) mark_usage();
        if (fresh) {
            machine_ = std::make_unique<machine::Machine>(std::move(fresh->machine));
            machine_data_ = std::move(fresh->data);
        }
    }
    return machine_.get();
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
    const std::string library = share_.library + '/';
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
