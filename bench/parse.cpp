// parse.cpp — what the first two rooms of the compiler cost, inside one process.
//
//   bench_parse FILE    prints `parse_s check_s`: CPU time of parsing the file and of checking it
//
// Each is the least of several rounds. The first round is left out: ANTLR learns its decisions in
// it, as it does once in a command; `kadr check` in run.py has that share.
#include "syntax/parse.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "base/render.h"
#include "sema/check.h"

namespace {

using namespace kadr;

constexpr int kRounds = 5;

double cpu_time() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// The file stands for itself: nothing is imported, the prelude is left out.
class NoModules final : public sema::ModuleLoader {
  public:
    Module load(std::string_view, bool, FileId, const SourceRange&) override { return {}; }
};

[[noreturn]] void fail(const DiagnosticList& messages, const Sources& sources) {
    for (const Diagnostic& message : messages.all()) {
        std::fputs(render_text(message, sources).c_str(), stderr);
    }
    std::exit(1);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const std::string root = KADR_ROOT;
    Sources sources;
    DiagnosticList messages;
    const auto dialect = nc::load_dialect("iso", {root + "/dialects"}, sources, messages);
    const auto keywords =
        syntax::load_keywords("en", {root + "/dialects/languages"}, sources, messages);
    const auto file = sources.read(argv[1]);
    if (!dialect || !keywords || !file) fail(messages, sources);
    double parsing = 1e9;
    double checking = 1e9;
    for (int round = 0; round <= kRounds; ++round) {
        const double start = cpu_time();
        const syntax::Ast ast = syntax::parse(sources, *file, *keywords, *dialect, messages);
        const double parsed = cpu_time();
        NoModules modules;
        const auto result = sema::check(ast, *dialect, modules, sources, messages);
        const double checked = cpu_time();
        if (messages.has_errors() || !result.code) fail(messages, sources);
        if (round == 0) continue;
        parsing = std::min(parsing, parsed - start);
        checking = std::min(checking, checked - parsed);
    }
    std::printf("%.6f %.6f\n", parsing, checking);
    return 0;
}
