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

/// The words that a source is written in: keywords of its language, words of its input dialect.
/// Null where they cannot be loaded, which is reported.
struct SourceWords {
    const syntax::KeywordTable* keywords = nullptr;
    const nc::Dialect* dialect = nullptr;
    explicit operator bool() const { return keywords != nullptr && dialect != nullptr; }
};
SourceWords words_of(Session& session, FileId file);

/// `cycles.drilling` is looked for as `cycles/drilling.kadr`, a file in quotes as it stands: beside
/// the importing file, in the folders of the options, in the standard library.
class Modules final : public sema::ModuleLoader {
  public:
    explicit Modules(Session& session) : session_(session) {}

    Module load(std::string_view import, bool is_file, FileId from,
                const SourceRange& location) override;

    std::optional<std::string> library_module_of(std::string_view function) override;
    std::optional<ControlCycle> cycle_of_control(std::string_view word) override;
    std::optional<ControlCommand> command_of_control(std::string_view word) override;

    /// Parses a text that is already among the sources, as the main file.
    Module parse(FileId file);

  private:
    struct Parsed {
        std::unique_ptr<syntax::Ast> ast;  // null: could not be read or parsed
        const nc::Dialect* dialect = nullptr;
        Module module() const { return {ast.get(), dialect}; }
    };

    Module parse(FileId file, DiagnosticSink& sink);
    Module parse_import(FileId file, const SourceRange& location);
    std::vector<std::string> folders_for(FileId from) const;
    void report_missing(std::string_view import, const std::string& relative, FileId from,
                        const SourceRange& location);

    std::vector<const nc::Dialect*> controls();

    Session& session_;
    std::map<std::string, Parsed> by_path_;
    std::optional<std::vector<nc::DialectSummary>> controls_;  // looked at for messages alone
};

}  // namespace kadr::driver
