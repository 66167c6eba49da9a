#include "driver/modules.h"

#include <algorithm>
#include <filesystem>
#include <optional>
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
                                   const std::string& relative, const Files& files) {
    for (const std::string& folder : folders) {
        std::string candidate = (fs::path(folder) / relative).lexically_normal().string();
        if (files.is_file(candidate)) return candidate;
    }
    return std::nullopt;
}

/// Adds the names of the modules in a folder; `before` stands in front of each.
void add_modules(const std::string& folder, const std::string& before, const Files& files,
                 std::vector<std::string>& names) {
    for (const FolderEntry& entry : files.list(folder)) {
        const fs::path name = entry.name;
        if (name.extension() == kSuffix) names.push_back(before + name.stem().string());
    }
}

/// Names of the modules below these folders, as an import would write them.
std::vector<std::string> module_names(const std::vector<std::string>& folders, const Files& files) {
    std::vector<std::string> names;
    for (const std::string& folder : folders) {
        add_modules(folder, "", files, names);
        for (const FolderEntry& entry : files.list(folder)) {
            if (entry.kind != FileKind::Folder) continue;
            const fs::path below = fs::path(folder) / entry.name;
            add_modules(below.string(), below.stem().string() + '.', files, names);
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
    return {session.kept_keywords(header.language.empty() ? kDefaultLanguage : header.language,
                                  place(header.language, header.language_at)),
            session.kept_dialect(dialect, place(header.dialect, header.dialect_at))};
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
    const std::vector<std::string> names = module_names(folders, session_.files());
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
        find_in(is_prelude ? library : folders_for(from), relative, session_.files());
    if (!path) {
        report_missing(import, relative, from, location);
        return {};
    }
    const std::string key = identity(*path);
    if (const auto known = by_path_.find(key); known != by_path_.end())
        return known->second.module();
    auto text = session_.access().read_named(*path);
    if (text) return take_import(*path, *std::move(text), location);
    report_unread(session_.messages(), diag::FileUnreadable, location, *path, text.error(),
                  session_.access());
    by_path_.emplace(key, Parsed{});
    return {};
}

/// Beside the importing file or in the folders of the options, as a module.
Done Modules::load_tools(std::string_view file, FileId from, const SourceRange& location) {
    if (!session_.options().tools.empty()) return Done(session_.tools() != nullptr);
    const std::string relative(file);
    const std::optional<std::string> path = find_in(folders_for(from), relative, session_.files());
    if (!path) {
        report_missing(file, relative, from, location);
        return kFailed;
    }
    return session_.import_tools(*path, location);
}

/// A file may be named by mistake, or by somebody who wants to see it in messages: one that does
/// not call itself a Kadr program is shown only if it is one.
Modules::Module Modules::take_import(const std::string& path, std::string content,
                                     const SourceRange& location) {
    FileId file;
    if (is_kadr_name(path)) return take(path, std::move(content), session_.messages(), file);
    DiagnosticList messages;
    const Module module = take(path, std::move(content), messages, file);
    if (!messages.has_errors()) {
        for (const Diagnostic& diagnostic : messages.all()) session_.messages().take(diagnostic);
        return module;
    }
    session_.messages().report(diag::NoKadrText, location).arg(path);
    by_path_[identity(path)] = {};
    return {};
}

std::optional<std::string> Modules::library_module_of(std::string_view function) {
    const std::string head = ' ' + std::string(function) + '(';
    for (const std::string& name : module_names({session_.share().library}, session_.files())) {
        if (name == kInnerModule) continue;
        const fs::path path = fs::path(session_.share().library) / relative_path(name, false);
        const auto content = session_.files().read(path.string());
        const std::string text = '\n' + (content ? *content : std::string());
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
    if (!controls_) controls_ = nc::list_dialects(session_.share().dialects, session_.files());
    std::vector<const nc::Dialect*> all;
    for (const nc::DialectSummary& summary : *controls_) {
        const bool is_sound =
            nc::can_be_loaded(summary.name, session_.share().dialects, session_.files());
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
        const bool can_be_given = command->is_call || !nc::is_no_command(command->function);
        if (can_be_given) return ControlCommand{std::string(name), std::string(dialect->name())};
    }
    return std::nullopt;
}

/// One text for one file, however it is reached.
std::string Modules::identity(const std::string& path) const {
    std::string real = session_.inputs().files().real_path(path);
    return real.empty() ? path : real;
}

/// Nothing: the time is over, and what is missing from the tree is nobody's mistake.
std::optional<syntax::Ast> Modules::parse(FileId file, const SourceWords& words,
                                          DiagnosticSink& sink) {
    session_.inputs().count_parse();
    syntax::Ast ast = syntax::parse(session_.sources(), file, *words.keywords, *words.dialect, sink,
                                    [this] { return session_.deadline().is_over(); });
    if (session_.deadline().is_over()) return std::nullopt;
    return ast;
}

Modules::Module Modules::parse_main(FileId file) {
    Parsed& parsed = by_path_[identity(std::string(session_.sources().name(file)))];
    const SourceWords words = words_of(session_, file);
    if (!words) return {};
    std::optional<syntax::Ast> ast = parse(file, words, session_.messages());
    if (!ast) return {};
    parsed.own = std::make_unique<syntax::Ast>(*std::move(ast));
    parsed.dialect = words.dialect;
    return parsed.module();
}

std::vector<const syntax::Ast*> Modules::trees() const {
    std::vector<const syntax::Ast*> out;
    for (const auto& [path, parsed] : by_path_) {
        if (const syntax::Ast* ast = parsed.module().ast) out.push_back(ast);
    }
    return out;
}

Modules::Module Modules::take_main(const std::string& path, std::string content, FileId& file) {
    return take(path, std::move(content), session_.messages(), file);
}

/// The tree of a file with this content: one that is there, or a new one. `file` is its text.
Modules::Module Modules::take(const std::string& path, std::string content, DiagnosticSink& sink,
                              FileId& file) {
    Parsed& parsed = by_path_[identity(path)];
    std::shared_ptr<SharedTree> tree = session_.inputs().tree(path, content);
    file = tree->text.file();
    const SourceWords words = words_of(session_, file);
    if (!words) return {};
    if (tree->ast && tree->words != words) {
        tree = session_.inputs().new_tree(path, std::move(content));
        file = tree->text.file();
    }
    if (!tree->ast) {
        DiagnosticList messages;
        tree->ast = parse(file, words, messages);
        tree->words = words;
        tree->messages = messages.all();
    }
    for (const Diagnostic& message : tree->messages) sink.take(message);
    if (!tree->ast) return {};
    parsed.dialect = words.dialect;
    parsed.tree = std::move(tree);
    return parsed.module();
}

}  // namespace kadr::driver
