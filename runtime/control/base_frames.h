// base_frames.h — the frames outside of the work offset, of controls that have several of them.
//
// set : external : global 0 … : channel 0 …; S 6.1. Those of the whole control and of the channel
// have a number each and a bit of a mask that tells which of them act.
#pragma once

#include <array>
#include <cstdint>

#include "control/control_frame.h"

namespace kadr::control {

struct BaseFrames {
    static constexpr std::size_t kEach = 16;
    using Numbered = std::array<ControlFrame, kEach>;

    ControlFrame set;       // of the workpiece as it was measured
    ControlFrame external;  // the work offset that comes from outside of the program
    Numbered global;
    Numbered channel;
    std::uint16_t global_mask = 0xffff;  // bit 0: number 0 …
    std::uint16_t channel_mask = 0xffff;

    /// Those with numbers, one behind the other.
    ControlFrame numbered() const;
    /// All of them.
    ControlFrame whole() const { return chain(chain(set, external), numbered()); }
    /// Without those that have numbers.
    BaseFrames without_numbered() const;
};

}  // namespace kadr::control
