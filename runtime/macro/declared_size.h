// declared_size.h — how much a program may declare.
#pragma once

#include <cstddef>

#include "macro/control_value.h"
#include "nc/control_line.h"

namespace kadr::macro {

/// Elements of the arrays that one level of a program may declare: more than any control has memory
/// for.
inline constexpr std::size_t kMostElements = 2'000'000;

/// Whether a variable of these sizes fits beside those that the level has. Their product may be
/// larger than `Symbol::count` can tell.
inline bool has_room_for(const Level& level, const nc::ControlSymbol& symbol) {
    const double count = double{1} * symbol.sizes[0] * symbol.sizes[1] * symbol.sizes[2];
    const std::size_t used = level.elements.values.size() + level.locals.values.size();
    return static_cast<double>(used) + count <= static_cast<double>(kMostElements);
}

}  // namespace kadr::macro
