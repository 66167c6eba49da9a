// danger_limits.h — beyond which a legal word is warned of; the table is danger_limits.def.
#pragma once

#include <array>
#include <string_view>

namespace kadr {

/// The values of the table by name: `danger::kMostTurnFeed`, in the unit of its row.
namespace danger {
#define KADR_DANGER_LIMIT(name, value, unit, meaning) inline constexpr double k##name = value;
#include "base/danger_limits.def"
#undef KADR_DANGER_LIMIT
}  // namespace danger

/// A row, for the documentation.
struct DangerLimit {
    std::string_view name;
    double value = 0;
    std::string_view unit;
    std::string_view meaning;
};

inline constexpr std::array kDangerLimits = {
#define KADR_DANGER_LIMIT(name, value, unit, meaning) DangerLimit{#name, value, unit, meaning},
#include "base/danger_limits.def"
#undef KADR_DANGER_LIMIT
};

}  // namespace kadr
