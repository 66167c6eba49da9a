// limits.h — how much of a source Kadr reads before it reports that something else must be wrong.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "base/diagnostic.h"

namespace kadr::syntax {

inline constexpr std::size_t kMaxBytes = std::size_t{8} << 20;  // a parse costs about 1 µs a byte
inline constexpr std::size_t kMaxLexemes = 1'000'000;           // … and some 200 bytes a token
inline constexpr std::size_t kSlice = std::size_t{1} << 14;     // tokens between looks at the clock
inline constexpr std::size_t kMaxErrors = 50;
inline constexpr std::size_t kMaxBadBytes = 8;  // then the file is no text

/// Keeps diagnostics until there are too many of them; what comes then is dropped. The steps of
/// parsing find mistakes in their own order, a reader wants them in the order of the source.
class LimitedSink final : public DiagnosticSink {
  public:
    /// `is_over` tells that the command has no time left; empty: it has.
    explicit LimitedSink(std::function<bool()> is_over = {}) : is_over_(std::move(is_over)) {}

    /// Whether the work is to end because there is no time left. A look at the clock.
    bool is_late() const { return is_over_ && is_over_(); }
    void take(Diagnostic diagnostic) override;
    bool has_errors() const { return has_errors_; }
    bool is_full() const { return kept_.size() >= kMaxErrors; }
    /// Hands everything on, sorted by location, and reports if it was too much.
    void deliver(DiagnosticSink& sink);

  private:
    std::function<bool()> is_over_;
    std::vector<Diagnostic> kept_;
    bool has_errors_ = false;
};

}  // namespace kadr::syntax
