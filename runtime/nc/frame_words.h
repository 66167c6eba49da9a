// frame_words.h — what the functions of frames give for X.
#pragma once

#include <cstddef>
#include <optional>

#include "nc/vocabulary.h"

namespace kadr::nc {

/// Which parameter of a function is a shift along X, a diameter under the rule shift_in_diameter.
constexpr std::optional<std::size_t> frame_x(Function f) {
    if (f == Function::Shift) return parameter_of<Function::Shift>("x");
    if (f == Function::ShiftAdd) return parameter_of<Function::ShiftAdd>("x");
    return std::nullopt;
}

}  // namespace kadr::nc
