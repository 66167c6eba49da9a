// listening_sink.h — messages of a program that somebody may listen to before they go on.
#pragma once

#include <utility>

#include "base/diagnostic.h"

namespace kadr::macro {

/// Messages go on, or are kept while somebody listens who makes something of them.
class ListeningSink final : public DiagnosticSink {
  public:
    explicit ListeningSink(DiagnosticSink& next) : next_(next) {}
    void take(Diagnostic diagnostic) override {
        (heard_ == nullptr ? next_ : *heard_).take(std::move(diagnostic));
    }
    /// Null: they go on.
    void listen(DiagnosticSink* heard) { heard_ = heard; }
    bool is_listened_to() const { return heard_ != nullptr; }

  private:
    DiagnosticSink& next_;
    DiagnosticSink* heard_ = nullptr;
};

}  // namespace kadr::macro
