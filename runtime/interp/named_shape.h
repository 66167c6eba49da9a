// named_shape.h — cycles whose call names the program in which their shape stands. Internal to
// interp.
#pragma once

#include <algorithm>

#include "nc/dialect.h"

namespace kadr::interp {

inline bool names_shape(const nc::CycleInfo& cycle) {
    return std::ranges::any_of(cycle.parameters, [](const nc::Parameter& parameter) {
        return parameter.dimension == nc::Dimension::Text && parameter.name == "shape";
    });
}

}  // namespace kadr::interp
