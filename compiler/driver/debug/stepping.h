// stepping.h — how far a run goes on before it stands again.
#pragma once

#include <cstddef>

#include "driver/debug/stop.h"

namespace kadr::driver {

/// What comes next: a statement of a Kadr program or a line of ISO-7bit text, and how many
/// functions or programs have begun there and not returned.
struct Arrival {
    bool is_statement = false;
    std::size_t depth = 0;
};

struct Advance {
    Resume how = Resume::Continue;
    Arrival from;
    StopReason reason = StopReason::Step;

    /// Whether it stands there, places aside.
    bool ends_at(const Arrival& at) const {
        if (at.is_statement != from.is_statement) return false;
        switch (how) {
            case Resume::Continue: return false;
            case Resume::End:
            case Resume::StepIn: return true;
            case Resume::StepOver: return at.depth <= from.depth;
            case Resume::StepOut: return at.depth < from.depth;
        }
        return false;
    }
};

}  // namespace kadr::driver
