// cycles.h — machining cycles for the interpreter, executed by the standard library's definitions.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "driver/program.h"
#include "driver/session.h"
#include "interp/interpreter.h"

namespace kadr::driver {

/// The files of the library's cycles, in a fixed order.
std::vector<std::string> cycle_files(const std::string& library, const Files& files);

/// Keeps the first mistake that a cycle finds in its parameters: its location is the library's, and
/// who called the cycle knows a better one. Passes on everything else; warnings stand where the
/// cycle is called, and the library's location is noted behind.
class CycleMessages final : public DiagnosticSink {
  public:
    explicit CycleMessages(DiagnosticSink& next) : next_(&next) {}
    void take(Diagnostic diagnostic) override;
    void pass_on_to(DiagnosticSink& next) { next_ = &next; }
    void forget() { refusal_.reset(); }
    /// The cycle that runs from here on.
    struct Caller {
        std::string cycle;
        std::optional<TextLocation> location;
    };
    void follow(const Caller& caller) { caller_ = &caller; }
    void follow_nobody() { caller_ = nullptr; }
    const std::optional<std::string>& refusal() const { return refusal_; }

  private:
    DiagnosticSink* next_;
    const Caller* caller_ = nullptr;
    std::optional<std::string> refusal_;
};

/// Runs `stdlib/cycles`, and the Kadr files of the dialect, for cycle calls that the interpreter
/// meets. A file of the library is checked when a call asks for a cycle that it declares.
class LibraryCycles final : public interp::CycleExpander {
  public:
    /// References outlive the expander.
    LibraryCycles(Session& session, const nc::Dialect& dialect)
        : session_(session),
          dialect_(dialect),
          sink_(&session.messages()),
          messages_(session.messages()) {}

    /// Where the messages of the cycles go from now on; it outlives their blocks.
    void report_to(DiagnosticSink& sink) {
        sink_ = &sink;
        messages_.pass_on_to(sink);
    }

    std::unique_ptr<Stream<nc::Block>> expand(const interp::CycleCall& call) override;
    bool turns(std::string_view cycle) override;
    std::optional<std::string> refusal() const override { return messages_.refusal(); }

  private:
    std::vector<std::string> files_of_control() const;
    std::vector<std::string> files_that_declare(std::string_view cycle) const;
    const KadrProgram* find(std::string_view cycle);
    const KadrProgram* find_in(const std::vector<std::string>& files, std::string_view cycle);

    Session& session_;
    const nc::Dialect& dialect_;
    DiagnosticSink* sink_;
    CycleMessages messages_;
    std::map<std::string, std::optional<KadrProgram>>
        programs_;  // by file; nothing: it has mistakes
    std::map<std::string, const KadrProgram*, std::less<>> found_;  // by cycle; null: there is none
};

}  // namespace kadr::driver
