#include "driver/dangers.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "base/diagnostics/danger.h"
#include "driver/execution.h"

namespace kadr::driver {

namespace {

bool is_danger(const DiagnosticRow& row) {
    static constexpr std::array kRows = {
#define KADR_DIAGNOSTIC(name, code, severity, message, explanation, wrong, right) &diag::name,
#include "base/diagnostics/danger.def"
#undef KADR_DIAGNOSTIC
    };
    return std::ranges::find(kRows, &row) != kRows.end();
}

/// Passes on warnings of danger alone, each with its location in the program.
class DangerReport final : public DiagnosticSink {
  public:
    DangerReport(const GeneratedText& text, DiagnosticSink& next) : text_(text), next_(next) {}

    void take(Diagnostic diagnostic) override {
        if (!is_danger(*diagnostic.row)) return;
        text_.move_to_statement(diagnostic);
        next_.take(std::move(diagnostic));
    }

  private:
    const GeneratedText& text_;
    DiagnosticSink& next_;
};

}  // namespace

void make_with_dangers(Session& session, const KadrProgram& program, const nc::Dialect& target,
                       std::unique_ptr<GeneratedText> text) {
    DangerReport dangers(*text, session.messages());
    const auto execution = Execution::open(session, program, target, std::move(text), dangers);
    if (!execution) return;
    std::vector<path::Command> batch(kBatch);
    while (execution->pull(batch) > 0)
        session.report({.blocks = execution->blocks(), .setpoints = 0, .time = 0});
    execution->make_rest();
}

}  // namespace kadr::driver
