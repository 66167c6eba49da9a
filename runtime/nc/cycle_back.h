// cycle_back.h — where a cycle of the library leaves the tool.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "nc/parameters.h"

namespace kadr::nc {

/// A cycle ends where it began, unless its first parameter is the level to which it goes back: then
/// it stands there, and one that has an end of its own is somewhere at it. Behind other parameters
/// `back` is no level.
struct CycleBack {
    bool is_elsewhere = false;         // along its tool axis: at the level, if that is given
    bool moves_in_plane = false;       // … and in its plane
    std::optional<std::size_t> level;  // the parameter that gives it
};

template <typename Parameters>
CycleBack cycle_back(const Parameters& parameters, std::uint32_t given) {
    if (find_parameter(parameters, "back") != std::size_t{0}) return {};
    CycleBack back{true, find_parameter(parameters, "x").has_value(), std::nullopt};
    if ((given & 1u) != 0) back.level = 0;
    return back;
}

}  // namespace kadr::nc
