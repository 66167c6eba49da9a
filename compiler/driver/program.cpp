#include "driver/program.h"

#include <functional>
#include <utility>

#include "base/diagnostics/driver.h"
#include "base/diagnostics/expand.h"
#include "base/done.h"
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

/// The time may be over before the program was checked, or somebody may not want it any more.
Done require_time(Session& session, FileId file) {
    if (!session.deadline().is_over()) return kDone;
    if (session.deadline().is_cancelled()) {
        session.messages().report(diag::EvaluationStopped, SourceRange{file, 0, 0});
        return kFailed;
    }
    session.messages()
        .report(diag::TimeLimit, SourceRange{file, 0, 0})
        .arg(session.deadline().seconds())
        .note("it was being read and checked")
        .fix("if it is to work longer, raise the limit: `--max-time`");
    return kFailed;
}

/// Where the tree of the main file comes from. `file` is its text.
using TakeMain = std::function<Modules::Module(Modules& modules, FileId& file)>;

std::optional<KadrProgram> checked(Session& session, const TakeMain& take_main, bool keeps_names) {
    const std::size_t errors_before = session.messages().errors();
    KadrProgram program;
    program.modules = std::make_unique<Modules>(session);
    FileId& file = program.file;
    // A library with mistakes is reported as such, not as tools that it has not.
    if (!session.options().tools.empty() && session.tools() == nullptr) return std::nullopt;
    const auto [ast, dialect] = take_main(*program.modules, file);
    if (ast == nullptr) {
        (void)require_time(session, file);  // beside what the parser has reported
        return std::nullopt;
    }
    sema::CheckOptions options = session.options().check;
    options.access = &session.access();
    options.keeps_names = keeps_names;
    options.tools = [&session] { return session.tools(); };
    options.is_over = [&session] { return session.deadline().is_over(); };
    sema::CheckResult result = sema::check(*ast, *dialect, *program.modules, session.sources(),
                                           session.messages(), options);
    program.code = std::move(result.code);
    if (program.code == nullptr && !require_time(session, file)) return std::nullopt;
    if (program.code != nullptr) name_truth(session, *program.code);
    if (program.code == nullptr || session.messages().errors() > errors_before) return std::nullopt;
    return program;
}

}  // namespace

std::optional<KadrProgram> load_program(Session& session, const std::string& path,
                                        const std::string& beside, const SourceRange& location) {
    auto text = session.access().read_named(path, beside);
    if (!text) {
        report_unread(session.messages(), diag::FileUnreadable, location, path, text.error(),
                      session.access());
        return std::nullopt;
    }
    return checked(
        session,
        [&](Modules& modules, FileId& file) {
            return modules.take_main(path, *std::move(text), file);
        },
        false);
}

std::optional<KadrProgram> load_program(Session& session, FileId main, bool keeps_names) {
    session.access().allow_home_of(std::string(session.sources().name(main)));
    return checked(
        session,
        [main](Modules& modules, FileId& file) {
            file = main;
            return modules.parse_main(main);
        },
        keeps_names);
}

}  // namespace kadr::driver
