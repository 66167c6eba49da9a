#include "driver/program.h"

#include <utility>

#include "base/diagnostics/driver.h"
#include "sema/check.h"

namespace kadr::driver {

namespace {

/// The command line is written in the words of the program: `-D mirrored=ложь`.
void name_truth(Session& session, sema::Code& code) {
    const SourceWords words = words_of(session, code.main_file);
    if (!words) return;
    for (const auto& [lexeme, name] : words.keywords->canonical) {
        if (name == "true") code.true_word = lexeme;
        if (name == "false") code.false_word = lexeme;
    }
}

}  // namespace

std::optional<Program> load_program(Session& session, const std::string& path) {
    const std::optional<FileId> file = session.sources().read(path);
    if (!file) {
        session.messages().report(diag::FileUnreadable).arg(path);
        return std::nullopt;
    }
    return load_program(session, *file);
}

std::optional<Program> load_program(Session& session, FileId file) {
    const std::size_t errors_before = session.messages().errors();
    Program program;
    program.file = file;
    program.modules = std::make_unique<Modules>(session);
    const auto [ast, dialect] = program.modules->parse(file);
    if (ast == nullptr) return std::nullopt;
    program.code = sema::check(*ast, *dialect, *program.modules, session.sources(),
                               session.messages(), session.options().check);
    if (program.code != nullptr) name_truth(session, *program.code);
    if (program.code == nullptr || session.messages().errors() > errors_before) return std::nullopt;
    return program;
}

}  // namespace kadr::driver
