// modules.h — finds, reads and parses the files of a program, each once.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "driver/session.h"
#include "sema/check.h"

namespace kadr::driver {

/// The words of a source, as its head names them.
SourceWords words_of(Session& session, FileId file);

/// `cycles.drilling` is looked for as `cycles/drilling.kadr`, a file in quotes as it stands: beside
/// the importing file, in the folders of the options, in the standard library.
class Modules final : public sema::ModuleLoader {
  public:
    explicit Modules(Session& session) : session_(session) {}

    Module load(std::string_view import, bool is_file, FileId from,
                const SourceRange& location) override;

    Done load_tools(std::string_view file, FileId from, const SourceRange& location) override;

    std::optional<std::string> library_module_of(std::string_view function) override;
    std::optional<ControlCycle> cycle_of_control(std::string_view word) override;
    std::optional<ControlCommand> command_of_control(std::string_view word) override;

    /// The main file: a text that is among the sources of the session.
    Module parse_main(FileId file);
    /// … or one of the library, whose tree others may have parsed. Nothing of a main file is kept
    /// for others.
    Module take_main(const std::string& path, std::string content, FileId& file);

    /// The trees of all files that were parsed, in no order; they live as long as this.
    std::vector<const syntax::Ast*> trees() const;

  private:
    /// A file that was looked at. No tree: it could not be read or parsed.
    struct Parsed {
        std::shared_ptr<const SharedTree> tree;  // of several sessions
        std::unique_ptr<syntax::Ast> own;        // … or of this one
        std::shared_ptr<const nc::Dialect> dialect;
        Module module() const {
            if (own != nullptr) return {own.get(), dialect.get()};
            return tree == nullptr ? Module{} : Module{&*tree->ast, dialect.get()};
        }
    };

    Module take(const std::string& path, std::string content, DiagnosticSink& sink, FileId& file);
    Module take_import(const std::string& path, std::string content, const SourceRange& location);
    std::optional<syntax::Ast> parse(FileId file, const SourceWords& words, DiagnosticSink& sink);
    std::string identity(const std::string& path) const;
    std::vector<std::string> folders_for(FileId from) const;
    void report_missing(std::string_view import, const std::string& relative, FileId from,
                        const SourceRange& location);

    std::vector<const nc::Dialect*> controls();

    Session& session_;
    std::map<std::string, Parsed> by_path_;
    std::optional<std::vector<nc::DialectSummary>> controls_;  // looked at for messages alone
};

}  // namespace kadr::driver
