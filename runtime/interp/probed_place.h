// probed_place.h — where the axes stand when a probe has met something. Internal to interp.
#pragma once

#include "interp/state.h"

namespace kadr::interp {

/// place_of  of a quantity and an axis, in the units of programs; known where an axis has moved
template <typename PlaceOf>
Probed probed_place(const AxisValues& tip, PlaceOf place_of) {
    Probed probed;
    probed.tip = tip;
    for (std::size_t i = 0; i < kAxes; ++i) {
        probed.head[i] = *place_of(nc::Quantity::HeadPosition, static_cast<Axis>(i));
        probed.machine[i] = *place_of(nc::Quantity::MachinePosition, static_cast<Axis>(i));
    }
    return probed;
}

}  // namespace kadr::interp
