#include "nc/dialect.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "base/diagnostics/dialect.h"
#include "base/diagnostics/driver.h"
#include "base/done.h"
#include "base/text.h"
#include "base/units.h"
#include "base/xml.h"
#include "nc/dialect_search.h"
#include "nc/inspect.h"
#include "nc/load.h"
#include "nc/refusals.h"

namespace kadr::nc {

Dialect::Dialect(std::unique_ptr<DialectTables> tables) : tables_(std::move(tables)) {}
Dialect::Dialect(Dialect&&) noexcept = default;
Dialect& Dialect::operator=(Dialect&&) noexcept = default;
Dialect::~Dialect() = default;

std::string_view Dialect::name() const { return tables_->name; }
std::string_view Dialect::title() const { return tables_->title; }
std::string_view Dialect::suffix() const { return tables_->suffix; }

std::span<const CycleInfo> Dialect::cycles() const { return tables_->cycles; }

std::optional<CycleId> Dialect::find_cycle(std::string_view name) const {
    for (std::size_t i = 0; i < tables_->cycles.size(); ++i) {
        if (tables_->cycles[i].name == name) return static_cast<CycleId>(i);
    }
    return std::nullopt;
}

const Rules& Dialect::rules() const { return tables_->rules; }

bool Dialect::names_rule(Rule rule) const { return tables_->named_rules.has(rule); }

int Dialect::first_work_offset() const { return rules().default_work_offset; }

Function Dialect::first_motion() const {
    const Function function = tables_->power_on[static_cast<std::size_t>(Group::Motion)];
    return function == Function::None ? Function::Rapid : function;
}

bool Dialect::is_core() const { return tables_->extends.empty(); }

bool Dialect::has_distance_words() const { return tables_->notation.has_modes; }

bool Dialect::counts_offsets_by_tool() const { return !tables_->deferred.empty(); }

std::span<const Example> Dialect::examples() const { return tables_->examples; }

namespace {

/// Whether a line could come from a header's template: `O{number:04}[({name})]`, `%`.
bool is_of_template(std::string_view line, std::string_view header) {
    const std::size_t fixed = header.find_first_of("{[");
    if (fixed == std::string_view::npos) return line == header;
    if (fixed == 0 || header[fixed] == '[' || !line.starts_with(header.substr(0, fixed)))
        return false;
    const char next = fixed < line.size() ? line[fixed] : ' ';
    const bool is_digit = next >= '0' && next <= '9';
    const bool is_letter = (next >= 'A' && next <= 'Z') || (next >= 'a' && next <= 'z');
    return is_digit || (is_letter && !header.substr(fixed).starts_with("{number"));
}

}  // namespace

bool Dialect::has_header(std::string_view text) const {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return false;
    std::string_view line = text.substr(begin, text.find_first_of("\r\n", begin) - begin);
    while (line.ends_with(' ')) line.remove_suffix(1);
    return std::ranges::any_of(tables_->program.header, [&](const std::string& header) {
        return is_of_template(line, header);
    });
}

namespace {
/// What a form does with parameters, a bit each.
struct FormParameters {
    std::uint32_t said = 0;
    std::uint32_t needed = 0;  // the form cannot be written without them
};

void collect_parameters(const std::vector<FormWord>& words, FormParameters& parameters) {
    for (const FormWord& word : words) {
        collect_parameters(word.arguments, parameters);
        if (word.tail_parameter >= 0) parameters.said |= 1u << word.tail_parameter;
        if (word.parameter < 0) continue;
        parameters.said |= 1u << word.parameter;
        if (!word.is_optional && !word.has_default) parameters.needed |= 1u << word.parameter;
    }
}

}  // namespace

bool Dialect::has_native_cycle(CycleId cycle, std::uint32_t given, std::span<const double> values,
                               std::vector<Refusal>* refusals) const {
    if (cycle >= tables_->forms_of_cycle.size()) return false;
    const bool looks_at_values =
        !values.empty() &&
        std::ranges::find(tables_->cycles_else_moves, cycle) != tables_->cycles_else_moves.end();
    return std::ranges::any_of(tables_->forms_of_cycle[cycle], [&](FormId id) {
        const Form& form = tables_->forms[id];
        FormParameters parameters;
        collect_parameters(form.words, parameters);
        for (const std::vector<FormWord>& line : form.extra) collect_parameters(line, parameters);
        collect_parameters(form.lead, parameters);
        for (const int parameter : form.implied) parameters.said |= 1u << parameter;
        for (const auto& [parameter, value] : form.fixed) parameters.said |= 1u << parameter;
        if (form.spindle_parameter >= 0) parameters.said |= 1u << form.spindle_parameter;
        std::uint32_t wrong = (given & ~parameters.said) | (parameters.needed & ~given);
        if (looks_at_values) wrong |= excluded_values(form, given, values);
        if (wrong != 0 && refusals != nullptr)
            refusals->push_back(refusal_of(*tables_, form, wrong, given, values));
        return wrong == 0;
    });
}

bool Dialect::can_write(Function function) const {
    if (function == Function::Cycle) {
        return std::ranges::any_of(tables_->forms_of_cycle,
                                   [](const auto& forms) { return !forms.empty(); });
    }
    if (function == Function::None) return true;
    return !tables_->forms_of[static_cast<std::size_t>(function)].empty();
}

double Dialect::written_increment(bool is_inch) const {
    const AddressId id = tables_->slot_address[static_cast<std::size_t>(Slot::X)];
    if (id == kNoAddress) return 0;
    const NumberFormat& format = tables_->addresses[id].format;
    return is_inch ? kMmPerInch * std::pow(10, -format.inch_decimals)
                   : std::pow(10, -format.decimals);
}

void Dialect::record(UsedEntries* used) { tables_->used = used; }

std::string_view Dialect::modal_call() const { return tables_->notation.modal_call; }

Function Dialect::power_on(Group group) const {
    return tables_->power_on[static_cast<std::size_t>(group)];
}

std::optional<AlarmText> Dialect::alarm(const DiagnosticRow& row, std::string_view detail) const {
    for (const AlarmAbout& about : tables_->alarms_about) {
        const bool fits = about.row == row.name && detail.find(about.words) != detail.npos;
        if (fits && !detail.empty()) return about.alarm;
    }
    const auto found = tables_->alarms.find(row.name);
    if (found == tables_->alarms.end()) return std::nullopt;
    return found->second;
}

// ---------------------------------------------------------------- files

namespace {

namespace fs = std::filesystem;

/// Names of all dialects in the folders, for proposals.
std::vector<std::string> dialect_names(const SearchPath& folders, const Files& files) {
    std::vector<std::string> names;
    for (const std::string& folder : folders) {
        for (const FolderEntry& entry : files.list(folder)) {
            const fs::path path = entry.name;
            if (path.extension() == ".xml") names.push_back(path.stem().string());
        }
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

/// Reports that there is none; the one that may have been meant.
std::optional<std::string> report_missing(const std::string& name, const SourceRange& location,
                                          const SearchPath& folders, const Files& files,
                                          DiagnosticSink& sink) {
    auto report = std::move(sink.report(diag::DialectNotFound, location).arg(name));
    const std::vector<std::string> known = dialect_names(folders, files);
    const std::vector<std::string_view> views(known.begin(), known.end());
    if (const auto near = nearest_name(name, views.data(), views.size())) {
        report.fix("is `" + std::string(*near) + "` meant?");
        return std::string(*near);
    }
    if (!known.empty()) {
        std::string all = "known are";
        for (const std::string& one : known) all += ' ' + one;
        report.note(all);
    }
    return std::nullopt;
}

/// Follows `extends` to the root and applies the files from there on. Goes on behind a mistake, so
/// that one run reports all of them.
class ChainLoader {
  public:
    ChainLoader(MachineKind kind, const SearchPath& folders, Sources& sources, DiagnosticSink& sink)
        : kind_(kind), folders_(folders), sources_(sources), sink_(sink) {}

    Done load(const std::string& name, const SourceRange& location, DialectTables& tables) {
        // Messages name a file as the one that extends it does.
        const bool is_extended = location.file.is_valid();
        const std::string text = is_extended ? std::string(sources_.text(location)) : name;
        auto path = find_dialect_file(name, folders_, sources_.files());
        if (!path) {
            has_mistakes_ = true;
            const auto meant = report_missing(text, location, folders_, sources_.files(), sink_);
            // What stands in the file is judged beside the one that was meant.
            if (is_extended && meant) path = find_dialect_file(*meant, folders_, sources_.files());
            if (!path) return kFailed;
        }
        // However it is spelt: `./a.xml` beside a file that was named `a.xml`.
        const std::string real = sources_.files().real_path(*path);
        const std::string identity = real.empty() ? *path : real;
        if (std::find(chain_.begin(), chain_.end(), identity) != chain_.end()) {
            sink_.report(diag::DialectExtendsItself, location).arg(text);
            return kFailed;
        }
        chain_.push_back(identity);
        const auto file = sources_.read(*path);
        if (!file) {
            sink_.report(diag::FileUnreadable, location).arg(*path);
            return kFailed;
        }
        return load_file(*file, *path, tables);
    }
    bool has_mistakes() const { return has_mistakes_; }
    /// Of the file that was asked for; those that it extends are applied before it.
    XmlElement root() && { return std::move(root_); }

  private:
    Done load_file(FileId file, const std::string& path, DialectTables& tables) {
        auto root = parse_xml(file, sources_, dialect_shape(), sink_);
        if (!root) return kFailed;
        if (!check_xml(*root, dialect_shape(), sink_)) {
            has_mistakes_ = true;
            if (!has_needed_attributes(*root, dialect_shape())) return kFailed;
            root = sound_part(*root, dialect_shape());
        }
        const XmlAttribute* base = root->find("extends");
        if (base != nullptr && !load(extended_name(*base, path), base->value_range, tables)) {
            return kFailed;
        }
        tables.extends = base == nullptr ? "" : base->value;
        tables.file = path;
        tables.name = root->find("name")->value;
        tables.title = root->find("title")->value;
        tables.suffix = root->find("suffix")->value;
        if (!apply_dialect(*root, tables, kind_, sources_.files(), sink_)) has_mistakes_ = true;
        root_ = std::move(*root);
        return kDone;
    }

    const MachineKind kind_;
    const SearchPath& folders_;
    Sources& sources_;
    DiagnosticSink& sink_;
    std::vector<std::string> chain_;
    XmlElement root_;
    bool has_mistakes_ = false;
};

/// kind  of the machines whose defaults act
InspectedDialect inspect(MachineKind kind, const std::string& name_or_file,
                         const SearchPath& folders, Sources& sources, DiagnosticSink& sink) {
    auto tables = std::make_unique<DialectTables>();
    tables->letters.fill(kNoAddress);
    const SearchPath with_own = search_path_of(name_or_file, folders);
    ChainLoader chain(kind, with_own, sources, sink);
    if (!chain.load(name_or_file, {}, *tables)) return {};
    const Done finished = finish_tables(*tables, sink);
    const bool has_mistakes = chain.has_mistakes() || !finished;
    return {Dialect(std::move(tables)), has_mistakes, std::move(chain).root()};
}

}  // namespace

InspectedDialect inspect_dialect(const std::string& name_or_file, const SearchPath& folders,
                                 Sources& sources, DiagnosticSink& sink) {
    return inspect(MachineKind::Mill, name_or_file, folders, sources, sink);
}

std::optional<Dialect> load_dialect(const std::string& name_or_file, const SearchPath& folders,
                                    Sources& sources, DiagnosticSink& sink) {
    return load_dialect_for(MachineKind::Mill, name_or_file, folders, sources, sink);
}

std::optional<Dialect> load_dialect_for(MachineKind kind, const std::string& name_or_file,
                                        const SearchPath& folders, Sources& sources,
                                        DiagnosticSink& sink) {
    InspectedDialect inspected = inspect(kind, name_or_file, folders, sources, sink);
    if (inspected.has_mistakes) return std::nullopt;
    return std::move(inspected.dialect);
}

std::vector<DialectSummary> list_dialects(const SearchPath& folders, const Files& files) {
    std::vector<DialectSummary> all;
    for (const std::string& name : dialect_names(folders, files)) {
        DialectSummary summary{name, {}, {}, {}, {}};
        if (const auto path = find_dialect_file(name, folders, files)) {
            summary.file = *path;
            std::map<std::string, std::string> attributes = first_tag(*path, files);
            summary.title = std::move(attributes["title"]);
            summary.suffix = std::move(attributes["suffix"]);
            summary.extends = std::move(attributes["extends"]);
        }
        all.push_back(std::move(summary));
    }
    return all;
}

bool can_be_loaded(const std::string& name, const SearchPath& folders, const Files& files) {
    Sources sources(files);
    DiagnosticList sink;
    return load_dialect(name, folders, sources, sink).has_value();
}

}  // namespace kadr::nc
