#include "syntax/limits.h"

#include <algorithm>
#include <utility>

#include "base/diagnostics/syntax.h"

namespace kadr::syntax {

void LimitedSink::take(Diagnostic diagnostic) {
    has_errors_ = has_errors_ || diagnostic.severity != Severity::Warning;
    if (!is_full()) kept_.push_back(std::move(diagnostic));
}

void LimitedSink::deliver(DiagnosticSink& sink) {
    std::stable_sort(kept_.begin(), kept_.end(), [](const Diagnostic& a, const Diagnostic& b) {
        return a.range.begin < b.range.begin;
    });
    const bool was_full = is_full();
    const SourceRange last = kept_.empty() ? SourceRange{} : kept_.back().range;
    for (Diagnostic& diagnostic : kept_) sink.take(std::move(diagnostic));
    kept_.clear();
    if (was_full) sink.report(diag::TooManyErrors, last).arg(kMaxErrors);
}

}  // namespace kadr::syntax
