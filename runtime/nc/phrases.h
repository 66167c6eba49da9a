// phrases.h — a text that Kadr writes while it is read: which of its lines write a function of
// Kadr's own in the control's language (forms with `verbatim`).
#pragma once

#include <cstdint>

namespace kadr::nc {

/// Beside TextSource, for who reads what Kadr writes. In every other text a line means what stands
/// in it, and nothing more: `#100=#5061` is an assignment.
class PhraseText {
  public:
    virtual ~PhraseText() = default;
    /// Whether the line (from 1) writes such a function; of lines that were handed out.
    virtual bool is_phrase(std::uint64_t line) const = 0;
};

}  // namespace kadr::nc
