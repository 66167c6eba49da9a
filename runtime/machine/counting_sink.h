// counting_sink.h — whether a file has mistakes, told by its messages on their way.
#pragma once

#include <cstddef>
#include <utility>

#include "base/diagnostic.h"

namespace kadr::machine {

/// Counts the errors that pass on their way to the real sink.
class CountingSink final : public DiagnosticSink {
  public:
    explicit CountingSink(DiagnosticSink& sink) : sink_(sink) {}
    void take(Diagnostic diagnostic) override {
        if (diagnostic.severity != Severity::Warning) ++errors_;
        sink_.take(std::move(diagnostic));
    }
    bool has_errors() const { return errors_ > 0; }

  private:
    DiagnosticSink& sink_;
    std::size_t errors_ = 0;
};

}  // namespace kadr::machine
