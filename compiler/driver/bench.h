// bench.h — the test bench: executes the calls of tests on the whole road, for one control.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/done.h"
#include "driver/cycles.h"
#include "driver/generated_text.h"
#include "driver/program.h"
#include "driver/recording.h"
#include "driver/session.h"
#include "expand/test_bench.h"

namespace kadr::driver {

/// The library's cycles, read once for all tests of a session, by dialect.
using CycleShelf = std::map<std::string, std::unique_ptr<LibraryCycles>>;

class Bench final : public expand::TestBench {
  public:
    /// References outlive the bench. `dialects` are all for which the tests are run.
    Bench(Session& session, const KadrProgram& program, const std::vector<std::string>& dialects,
          CycleShelf& cycles)
        : session_(session), program_(program), dialects_(dialects), cycles_(cycles) {}

    /// A test begins, under this dialect; its messages go to `sink`.
    void begin(const std::string& dialect, DiagnosticSink& sink);
    /// Whether the test has asked for anything that depends on the control.
    bool was_asked() const { return was_asked_; }

    std::optional<std::int64_t> execute(const expand::CallUnderTest& call) override;
    std::optional<std::string> write(const expand::CallUnderTest& call) override;
    Done require_error(const expand::CallUnderTest& call) override;
    expand::FigureAnswer ask(std::int64_t execution, sema::Figure figure,
                             std::span<const sema::Slot> arguments) override;
    std::string dialect() const override;
    std::vector<std::string> dialects() const override;

  private:
    const nc::Dialect* wanted_dialect(const expand::CallUnderTest& call, const std::string& name);
    LibraryCycles& cycles_of(const std::string& name, const nc::Dialect& dialect);
    std::unique_ptr<Recording> perform(const expand::CallUnderTest& call, const std::string& name,
                                       DiagnosticList& messages);
    Entry entry(const expand::CallUnderTest& call) const;
    Done require_no_error(const DiagnosticList& messages);

    Session& session_;
    const KadrProgram& program_;
    const std::vector<std::string>& dialects_;
    CycleShelf& cycles_;
    std::string dialect_;
    DiagnosticSink* sink_ = nullptr;
    mutable bool was_asked_ = false;
    std::vector<std::unique_ptr<Recording>> recordings_;
};

}  // namespace kadr::driver
