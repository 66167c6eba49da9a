// cycle_run.h — the programmed cycles, and the one that runs. Internal to interp.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "control/frames.h"
#include "interp/block_actions.h"
#include "interp/state.h"
#include "nc/block.h"

namespace kadr::interp {

/// What holds for the cycles that follow.
struct ModalCycles {
    ModalCycle modal;
    CycleData data;
    std::optional<nc::Block> behind_motions;  // the call that every motion is followed by
    std::vector<ModalCycle> presets;          // parameters that the next calls need not give
    std::optional<nc::CycleId> defined;       // the one of them that was programmed last
    bool returns_to_retract = false;
};

/// A cycle that runs: who called it, and what to restore behind it.
struct CycleRun {
    nc::BlockContext context{};         // of its blocks
    bool is_across = false;             // on a lathe: from the side, along X in radii
    bool lies_flat = false;             // its axes are those of the machine, whatever the plane
    int times_left = 0;                 // that the block does the cycle again
    std::optional<double> begins_at;    // level at which it takes the tool to be
    std::optional<double> final_level;  // below its retract level: where the tool goes behind it
    std::optional<control::Frames> frames_outside;  // where its distances are spared by the scaling
    nc::Block caller{};
    Modal modal_before;
    double x_scale_before = 1;
    bool is_modal_behind = false;
    Actions after;
    nc::Block remapped{};  // a block of it, in another plane than X-Y
};

/// A pattern of positions: a cycle whose blocks are followed by the call behind motions.
struct PatternRun {
    nc::Block caller;
    Modal modal_before;
    bool calls_program = false;
};

/// The parameter of a cycle that is where its cut ends along the axis.
inline std::string_view end_name(Axis axis) {
    switch (axis) {
        case Axis::X: return "x";
        case Axis::Y: return "y";
        case Axis::Z: return "z";
        default: return "";
    }
}

}  // namespace kadr::interp
