// block_words.h — what several parts of the executor read out of the words of a block.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "control/frames.h"
#include "nc/block.h"
#include "path/command.h"

namespace kadr::interp {

/// A parameter of a function that counts or numbers something.
inline std::int64_t count_of(const nc::Block& block, const nc::Invocation& invocation,
                             std::size_t parameter) {
    return std::llround(block.argument(invocation, parameter));
}

/// slots  not empty
inline nc::Slot first_slot(nc::SlotMask slots) {
    return static_cast<nc::Slot>(std::countr_zero(slots));
}

/// What a message calls the word of an arc, where all dialects have the same one.
inline std::string_view slot_word(nc::Slot slot) {
    switch (slot) {
        case nc::Slot::CenterX: return "I";
        case nc::Slot::CenterY: return "J";
        case nc::Slot::CenterZ: return "K";
        case nc::Slot::Radius: return "radius";
        case nc::Slot::Turns: return "turns";
        default: return nc::slot_name(slot);
    }
}

/// The sense of a spindle by the number of its M function: 3, 4; else it stands.
inline path::SpindleMode sense_by_code(std::int64_t code) {
    const nc::Function spindle = nc::spindle_of_code(static_cast<double>(code));
    if (spindle == nc::Function::SpindleCw) return path::SpindleMode::Cw;
    return spindle == nc::Function::SpindleCcw ? path::SpindleMode::Ccw : path::SpindleMode::Stop;
}

inline bool is_running(path::SpindleMode mode) {
    return mode == path::SpindleMode::Cw || mode == path::SpindleMode::Ccw;
}

/// Whether the block measures along its path at rapid, `MEAS=1 G0 X10`.
inline bool probes_at_rapid(const nc::Block& block) {
    if (block.function_count == 0) return false;
    const nc::Invocation* const call = block.find(nc::Function::Probe);
    return call != nullptr &&
           block.argument(*call, nc::parameter_of<nc::Function::Probe>("rapid")) != 0;
}

/// X, Y, Z of a frame function, from its parameter `first` on, or more axes.
///
/// x_scale  0.5 where X is a diameter
inline control::FrameWords frame_words(const nc::Block& block, const nc::Invocation& invocation,
                                       std::size_t first, double x_scale, std::size_t axes = 3) {
    control::FrameWords words;
    for (std::size_t i = 0; i < axes; ++i) words.values[i] = block.argument(invocation, first + i);
    words.values[0] *= x_scale;
    words.given = invocation.given >> first & ((1u << axes) - 1);
    return words;
}

}  // namespace kadr::interp
