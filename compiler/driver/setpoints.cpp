#include "driver/setpoints.h"

#include <algorithm>

#include "base/units.h"
#include "driver/columns.h"

namespace kadr::driver {

namespace {

constexpr int kDecimals = 9;
constexpr int kFeedDecimals = 6;

/// W; the energy on a millimetre of path stays the same as far as the least power lets it.
double beam_power(const machine::Laser& laser, const motion::Setpoint& setpoint) {
    if (!(setpoint.programmed_feed > 0)) return 0;
    const double share = std::min(1.0, setpoint.feed / setpoint.programmed_feed);
    return laser.least_power + (laser.power - laser.least_power) * share;
}

}  // namespace

SetpointTable::SetpointTable(const machine::Machine& machine, Output& out)
    : machine_(machine), out_(out) {
    std::string header = "t";
    for (const machine::MachineAxis& axis : machine.axes) header += ',' + axis.name;
    header += ",tip_x,tip_y,tip_z,tool_i,tool_j,tool_k,feed,iso";
    if (machine.laser && machine.laser->pulse > 0) header += ",pulse";
    if (machine.laser && machine.laser->power > 0) header += ",power";
    out_.write(header + '\n');
}

void SetpointTable::write(std::span<const motion::Setpoint> setpoints) {
    text_.clear();
    for (const motion::Setpoint& setpoint : setpoints) {
        append_trimmed(text_, setpoint.time, kDecimals);
        for (std::size_t i = 0; i < machine_.axes.size(); ++i) {
            const double value = setpoint.axis[i];
            append_column(text_, machine_.axes[i].is_rotary ? deg_from_rad(value) : value,
                          kDecimals);
        }
        for (int i = 0; i < 3; ++i) append_column(text_, setpoint.tip[i], kDecimals);
        for (int i = 0; i < 3; ++i) append_column(text_, setpoint.tool[i], kDecimals);
        append_column(text_, mm_min_from_feed(setpoint.feed), kFeedDecimals);
        append_column(text_, setpoint.line);
        if (machine_.laser && machine_.laser->pulse > 0) append_column(text_, setpoint.pulses);
        if (machine_.laser && machine_.laser->power > 0)
            append_column(text_, beam_power(*machine_.laser, setpoint), kFeedDecimals);
        text_ += '\n';
    }
    out_.write(text_);
}

}  // namespace kadr::driver
