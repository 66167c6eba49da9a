// axis_data.h — what the machine gives of its axes, by logical axis. Internal to interp.
#pragma once

#include <array>

#include "base/axes.h"
#include "machine/machine.h"

namespace kadr::interp {

/// mm; deg for rotary axes.
struct AxisData {
    AxisMask present = 0;
    AxisValues lower{};
    AxisValues upper{};
    std::array<AxisValues, machine::kReferencePoints> reference_points{};
    std::array<AxisMask, machine::kReferencePoints> has_reference_point{};
    AxisValues left_over{};  // positions over which axes went to a reference point last
    AxisMask has_left = 0;
    AxisValues word_scale{};  // 0.5 for X of a lathe: a diameter is programmed

    void count_x_as(double scale) { word_scale[index(Axis::X)] = scale; }
};

}  // namespace kadr::interp
