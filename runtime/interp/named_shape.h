// named_shape.h — what kind of cycle it is: one whose call names the program in which its shape
// stands, or a pattern of places. Internal to interp.
#pragma once

#include <algorithm>

#include "nc/dialect.h"

namespace kadr::interp {

inline bool names_shape(const nc::CycleInfo& cycle) {
    return std::ranges::any_of(cycle.parameters, [](const nc::Parameter& parameter) {
        return parameter.dimension == nc::Dimension::Text && parameter.name == "shape";
    });
}

/// A cycle that has it is a pattern of places: whether something is called at each.
inline constexpr std::string_view kPatternParameter = "calls";

inline bool goes_to_places(const nc::CycleInfo& cycle) {
    return std::ranges::any_of(cycle.parameters, [](const nc::Parameter& parameter) {
        return parameter.name == kPatternParameter;
    });
}

}  // namespace kadr::interp
