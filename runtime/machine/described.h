// described.h — what a machine file has described already, and where.
#pragma once

#include <map>
#include <string>

#include "base/diagnostic.h"
#include "base/diagnostics/machine.h"
#include "base/done.h"

namespace kadr::machine {

class Described {
  public:
    explicit Described(DiagnosticSink& sink) : sink_(sink) {}

    /// What is described twice is reported with the location of the first description.
    Done require_first(const std::string& what, const SourceRange& location) {
        const auto [first, is_new] = seen_.emplace(what, location);
        if (!is_new) {
            sink_.report(diag::MachineTwice, location)
                .arg(what)
                .note(first->second, "the first description");
        }
        return Done(is_new);
    }

  private:
    DiagnosticSink& sink_;
    std::map<std::string, SourceRange> seen_;
};

}  // namespace kadr::machine
