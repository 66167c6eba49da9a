// contour_run.h — a contour whose blocks are executed without motion, until the program has it as a
// table.
#pragma once

#include <cstdint>
#include <vector>

#include "interp/kept_state.h"
#include "interp/state.h"
#include "macro/contour_table.h"

namespace kadr::interp {

using macro::ContourElement;
using macro::ContourElements;
using macro::ContourModes;

struct ContourRun {
    std::vector<path::Command> commands;  // of the blocks

    /// What acted in a block, in the order in which they came.
    struct BlockModes {
        std::uint32_t line = 0;
        ContourModes modes;
        double feed = 0;
    };
    std::vector<BlockModes> modes;

    KeptState before;
};

}  // namespace kadr::interp
