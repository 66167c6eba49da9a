// frame_words.h — which functions are those of frames, and what they say about X.
#pragma once

#include <cstddef>
#include <optional>

#include "nc/vocabulary.h"

namespace kadr::nc {

/// Whether the function shifts, turns, scales or mirrors what comes behind it.
constexpr bool sets_frame(Function f) {
    return f == Function::Shift || f == Function::ShiftAdd || f == Function::Rotate ||
           f == Function::Scale || f == Function::Mirror;
}

/// … or ends such a frame.
constexpr bool changes_frame(Function f) {
    return sets_frame(f) || f == Function::RotateOff || f == Function::ScaleOff ||
           f == Function::MirrorOff;
}

/// Which parameter of a function is a shift along X, a diameter under the rule shift_in_diameter.
constexpr std::optional<std::size_t> frame_x(Function f) {
    if (f == Function::Shift || f == Function::ShiftAdd) return 0;
    return std::nullopt;
}

}  // namespace kadr::nc
