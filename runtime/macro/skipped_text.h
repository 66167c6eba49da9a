// skipped_text.h — parts of a text that a run has jumped over and not come back to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "macro/program_map.h"

namespace kadr::macro {

class PassedText {
  public:
    struct Part {
        LinePosition begin;     // of its first line
        std::uint64_t end = 0;  // offset behind its last one
    };

    /// A jump ahead has passed over this. Parts come in the order of the text.
    void add(const LinePosition& begin, std::uint64_t end);
    /// A line that lies behind such a jump is executed after all.
    void take_out(const LinePosition& begin, const LinePosition& next);
    /// The first part that is left, which then is left no more.
    std::optional<Part> take_first();

  private:
    std::vector<Part> parts_;  // in order, apart from each other
    std::size_t first_ = 0;    // that was not taken
};

}  // namespace kadr::macro
