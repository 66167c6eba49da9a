#include <bit>
#include <cmath>
#include <utility>

#include "base/diagnostics/iso.h"
#include "interp/block_words.h"
#include "interp/channel.h"
#include "interp/programmed_frames.h"
#include "interp/transformation.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::parameter_of;
using nc::SlotMask;

// ------------------------------------------------------------------------------ without frames

bool ProgrammedFrames::is_without_frames(const Actions& actions) const {
    return actions.machine_coordinates && rules_.machine_coordinates_keep_length &&
           !rules_.machine_coordinates_rapid;
}

Done ProgrammedFrames::take_frames_off(const Block& block) {
    constexpr SlotMask kPlaces = nc::kTargetSlots | nc::kPolarSlots | nc::kArcSlots;
    if ((block.given & kPlaces) == 0) return kDone;
    if (channel_.transformation.is_transformed()) {
        reporter_.report(diag::TransformationMotion, block, Function::MachineCoordinates)
            .arg("a position in machine coordinates");
        return kFailed;
    }
    const Function motion = block.motion != Function::None ? block.motion : modal_.motion;
    if (nc::has_fact(motion, nc::Fact::SplineMotion)) {
        reporter_.report(diag::IsoNotSupported, block, Function::MachineCoordinates)
            .arg("a spline in machine coordinates");
        return kFailed;
    }
    const nc::Invocation* invocation = block.find(Function::MachineCoordinates);
    frames_off_.emplace(FramesOff{frames_, position_});
    frames_ = frames_.machine_frames(
        invocation != nullptr
            ? count_of(block, *invocation, parameter_of<Function::MachineCoordinates>("keeps"))
            : 0);
    frame_changed();
    position_.name();
    return kDone;
}

void ProgrammedFrames::put_frames_back(const Block& block) {
    const FramesOff off = *std::exchange(frames_off_, std::nullopt);
    go_back_to(off.frames);
    frame_changed();
    for (std::size_t i = 0; i < kAxes; ++i) {
        const bool has_moved =
            (block.given >> i & 1u) != 0 || position_.base()[i] != off.before.base()[i];
        if (has_moved) position_.name(i);
        else position_.name_as(off.before, i);
    }
}

}  // namespace kadr::interp
