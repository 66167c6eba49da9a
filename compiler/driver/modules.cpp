#include "driver/modules.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "base/diagnostics/driver.h"
#include "base/text.h"
#include "driver/file_text.h"
#include "nc/command_names.h"

namespace kadr::driver {

namespace {

namespace fs = std::filesystem;

constexpr const char* kDefaultLanguage = "en";
constexpr const char* kDefaultDialect = "iso";
constexpr const char* kPrelude = "prelude";
constexpr const char* kSuffix = ".kadr";
/// What the files of the library share; nothing in it is a cycle for programs.
constexpr const char* kInnerModule = "cycles.levels";

/// `cycles.drilling` → `cycles/drilling.kadr`.
std::string relative_path(std::string_view import, bool is_file) {
    std::string path(import);
    if (is_file) return path;
    std::replace(path.begin(), path.end(), '.', '/');
    return path + kSuffix;
}

std::optional<std::string> find_in(const std::vector<std::string>& folders,
                                   const std::string& relative) {
    std::error_code error;
    for (const std::string& folder : folders) {
        const fs::path candidate = (fs::path(folder) / relative).lexically_normal();
        if (fs::is_regular_file(candidate, error)) return candidate.string();
    }
    return std::nullopt;
}

/// One text for one file, however it is reached.
std::string identity(const std::string& path) {
    std::error_code error;
    const fs::path real = fs::canonical(path, error);
    return error ? path : real.string();
}

/// Names of the modules below these folders, as an import would write them.
std::vector<std::string> module_names(const std::vector<std::string>& folders) {
    std::vector<std::string> names;
    std::error_code error;
    for (const std::string& folder : folders) {
        const fs::path root = folder.empty() ? fs::path(".") : fs::path(folder);
        for (fs::directory_iterator entry(root, error), end; !error && entry != end;
             entry.increment(error)) {
            std::error_code ignored;
            const std::string stem = entry->path().stem().string();
            if (entry->path().extension() == kSuffix) names.push_back(stem);
            if (!entry->is_directory(ignored)) continue;
            for (fs::directory_iterator below(entry->path(), ignored); !ignored && below != end;
                 below.increment(ignored)) {
                if (below->path().extension() != kSuffix) continue;
                names.push_back(stem + '.' + below->path().stem().string());
            }
        }
    }
    return names;
}

}  // namespace

SourceWords words_of(Session& session, FileId file) {
    const syntax::SourceHeader header = syntax::scan_header(session.sources().text(file));
    const auto place = [file](const std::string& name, std::uint32_t at) {
        if (at == 0) return SourceRange{};
        // Of an empty text between quotes, the quotes.
        const auto end = at + static_cast<std::uint32_t>(name.size());
        return name.empty() ? SourceRange{file, at - 1, at + 1} : SourceRange{file, at, end};
    };
    // A file is looked for beside the source, as an imported one is.
    std::string dialect = header.dialect_at == 0 ? kDefaultDialect : header.dialect;
    const bool is_path = dialect.find('/') != std::string::npos || dialect.ends_with(".xml");
    if (is_path && fs::path(dialect).is_relative()) {
        const fs::path folder = fs::path(std::string(session.sources().name(file))).parent_path();
        dialect = (folder / dialect).lexically_normal().string();
        if (dialect.find('/') == std::string::npos) dialect = "./" + dialect;
    }
    return {session.keywords(header.language.empty() ? kDefaultLanguage : header.language,
                             place(header.language, header.language_at)),
            session.dialect(dialect, place(header.dialect, header.dialect_at))};
}

std::vector<std::string> Modules::folders_for(FileId from) const {
    const fs::path importer{std::string(session_.sources().name(from))};
    std::vector<std::string> folders = {importer.parent_path().string()};
    const auto& chosen = session_.options().folders;
    folders.insert(folders.end(), chosen.begin(), chosen.end());
    folders.push_back(session_.share().library);
    return folders;
}

void Modules::report_missing(std::string_view import, const std::string& relative, FileId from,
                             const SourceRange& location) {
    const std::vector<std::string> folders = folders_for(from);
    auto report = std::move(session_.messages().report(diag::ModuleMissing, location).arg(import));
    std::string looked;
    for (const std::string& folder : folders) {
        looked +=
            (looked.empty() ? "`" : ", `") + (folder.empty() ? std::string(".") : folder) + '`';
    }
    report.note("`" + relative + "` was looked for in " + looked);
    const std::vector<std::string> names = module_names(folders);
    const std::vector<std::string_view> views(names.begin(), names.end());
    if (const auto near = nearest_name(import, views.data(), views.size())) {
        const std::string name(*near);
        if (name == import)
            report.fix("a module's name stands without quotes: `import " + name + ";`");
        else report.fix("there is a module `" + name + "`");
    }
}

Modules::Module Modules::load(std::string_view import, bool is_file, FileId from,
                              const SourceRange& location) {
    const std::string relative = relative_path(import, is_file);
    // The prelude is part of the language, whatever lies beside a program.
    const bool is_prelude = import == kPrelude && !is_file;
    const std::vector<std::string> library = {session_.share().library};
    const std::optional<std::string> path =
        find_in(is_prelude ? library : folders_for(from), relative);
    if (!path) {
        report_missing(import, relative, from, location);
        return {};
    }
    const std::string key = identity(*path);
    if (const auto known = by_path_.find(key); known != by_path_.end())
        return known->second.module();
    auto text = session_.files().read_named(*path);
    if (text) return parse_import(session_.sources().add(*path, *std::move(text)), location);
    report_unread(session_.messages(), diag::FileUnreadable, location, *path, text.error(),
                  session_.files());
    by_path_.emplace(key, Parsed{});
    return {};
}

/// A file may be named by mistake, or by somebody who wants to see it in messages: one that does
/// not call itself a Kadr program is shown only if it is one.
Modules::Module Modules::parse_import(FileId file, const SourceRange& location) {
    const std::string name(session_.sources().name(file));
    if (is_kadr_name(name)) return parse(file);
    DiagnosticList messages;
    const Module module = parse(file, messages);
    if (!messages.has_errors()) {
        for (const Diagnostic& diagnostic : messages.all()) session_.messages().take(diagnostic);
        return module;
    }
    session_.messages().report(diag::NoKadrText, location).arg(name);
    by_path_[identity(name)] = {};
    return {};
}

std::optional<std::string> Modules::library_module_of(std::string_view function) {
    const std::string head = ' ' + std::string(function) + '(';
    for (const std::string& name : module_names({session_.share().library})) {
        if (name == kInnerModule) continue;
        const fs::path path = fs::path(session_.share().library) / relative_path(name, false);
        const std::string text = '\n' + read_file(path.string()).value_or("");
        // A declaration stands at the left margin, behind its type or `cycle`.
        for (std::size_t at = text.find(head); at != std::string::npos;
             at = text.find(head, at + 1)) {
            const std::size_t line = text.rfind('\n', at) + 1;
            const std::string_view type = std::string_view(text).substr(line, at - line);
            const bool is_word = !type.empty() && type.find_first_of(" /=(") == std::string::npos;
            if (is_word) return name;
        }
    }
    return std::nullopt;
}

/// The dialects that ship, but for the common core.
std::vector<const nc::Dialect*> Modules::controls() {
    if (!controls_) controls_ = nc::list_dialects(session_.share().dialects);
    std::vector<const nc::Dialect*> all;
    for (const nc::DialectSummary& summary : *controls_) {
        const bool is_sound = nc::can_be_loaded(summary.name, session_.share().dialects);
        const nc::Dialect* dialect = is_sound ? session_.dialect(summary.name) : nullptr;
        if (dialect != nullptr && !dialect->is_core()) all.push_back(dialect);
    }
    return all;
}

std::optional<sema::ModuleLoader::ControlCycle> Modules::cycle_of_control(std::string_view word) {
    for (const nc::Dialect* dialect : controls()) {
        const auto cycle = nc::cycle_of_word(*dialect, word);
        if (!cycle || !nc::can_be_source(*dialect, *cycle)) continue;
        const nc::CycleInfo& info = dialect->cycles()[*cycle];
        return ControlCycle{std::string(info.name), std::string(info.module),
                            std::string(dialect->name())};
    }
    return std::nullopt;
}

std::optional<sema::ModuleLoader::ControlCommand> Modules::command_of_control(
    std::string_view word) {
    for (const nc::Dialect* dialect : controls()) {
        const auto command = nc::command_of_word(*dialect, word);
        if (!command) continue;
        const std::string_view name = command->is_call ? "" : nc::info(command->function).name;
        const bool can_be_given =
            command->is_call || !nc::has_fact(command->function, nc::Fact::ReadOnly);
        if (can_be_given) return ControlCommand{std::string(name), std::string(dialect->name())};
    }
    return std::nullopt;
}

Modules::Module Modules::parse(FileId file) { return parse(file, session_.messages()); }

Modules::Module Modules::parse(FileId file, DiagnosticSink& sink) {
    Parsed& parsed = by_path_[identity(std::string(session_.sources().name(file)))];
    const SourceWords words = words_of(session_, file);
    if (!words) return {};
    parsed.dialect = words.dialect;
    parsed.ast = std::make_unique<syntax::Ast>(
        syntax::parse(session_.sources(), file, *words.keywords, *words.dialect, sink,
                      [this] { return session_.deadline().is_over(); }));
    // Whatever is missing from it now is nobody's mistake.
    if (session_.deadline().is_over()) return {};
    return parsed.module();
}

}  // namespace kadr::driver
