// modal_functions.h — which member of each modal group acts: what a line means to its reader, and
// what a text has written to its writer.
#pragma once

#include <array>

#include "nc/block.h"
#include "nc/rules.h"

namespace kadr::nc {

/// Active members of the modal groups as far as they are known; None: not known.
struct ModalFunctions : std::array<Function, kGroups> {
    double work_offset = -1;  // its number; below 0: not known
    CycleId cycle = 0;  // the one that was called last; it is modal if the cycle mode is Cycle

    bool operator==(const ModalFunctions&) const = default;
};

/// What a block leaves of it under the rules of a control.
void follow_modal(const Rules& rules, const Block& block, ModalFunctions& modal);

}  // namespace kadr::nc
