// shape_run.h — a cycle along a shape whose blocks are still coming.
//
// The blocks follow the call in the stream: from one block number to another, or those of a program
// that the call names. For most cycles they are not executed but kept, as geometry, and what they
// change besides the geometry is forgotten; one cycle executes them.
#pragma once

#include <cstdint>
#include <vector>

#include "interp/kept_state.h"
#include "interp/state.h"

namespace kadr::interp {

struct ShapeRun {
    nc::Block block;  // that called the cycle
    ModalCycle call;
    std::int64_t last = 0;     // number of the shape's last block
    bool is_named = false;     // it stands in a program; a block that calls the cycle is behind it
    bool is_followed = false;  // the blocks are executed; then the tool goes back to its start
    bool has_begun = false;    // a block of the shape has come
    bool approaches_at_rapid = false;  // in the first block
    nc::SlotMask approach_axes = 0;    // that it names

    // As the cycle found them.
    Modal modal;
    KeptState before;

    std::vector<path::Command> commands;  // of the blocks that are kept
};

}  // namespace kadr::interp
